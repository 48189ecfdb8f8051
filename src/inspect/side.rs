//! On which side of a plane curve a point is.

use super::DistanceBounds;
use super::known::PlanePoint;
use super::winding::Winding;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::intervals::Interval;
use crate::limits::Limits;
use crate::shape::{EllipticSeries, FourierRadius, PlaneCurve};

/// The sides of a closed plane curve.
#[derive(Debug)]
pub(crate) enum Sides {
    /// Inside is where ρ < r(θ); r is positive.
    Radius(Box<RadiusSides>),
    /// Inside is where the curve, traced once, winds an odd number of times around the point.
    Closed(Box<Winding>),
}

impl Sides {
    /// The sides of a radius; `is_positive` says whether r > 0 for every angle.
    pub(crate) fn of_radius(
        radius: &FourierRadius,
        is_positive: bool,
        limits: &Limits,
    ) -> Result<Self> {
        if is_positive {
            return Ok(Self::Radius(Box::new(RadiusSides::new(radius))));
        }
        let series = EllipticSeries::from_radius(radius);
        Ok(Self::Closed(Box::new(Winding::of_series(&series, limits)?)))
    }

    /// The sides of a parametric curve; `None` if it is not closed, or if it is too much work to find around which points it winds.
    pub(crate) fn of_curve(curve: &PlaneCurve, limits: &Limits) -> Result<Option<Self>> {
        if !Winding::is_closed(curve) {
            return Ok(None);
        }
        match Winding::new(curve, limits) {
            Err(Error::Limit { .. }) => limits.check().map(|()| None),
            winding => Ok(Some(Self::Closed(Box::new(winding?)))),
        }
    }

    /// Whether [`Self::sign`] needs no bounds of the distance.
    pub(crate) fn need_no_distance(&self) -> bool {
        matches!(self, Self::Radius(_))
    }

    /// −1 inside, 0 on the curve, 1 outside; `distance` holds the distance of the point from the curve.
    pub(crate) fn sign(&self, point: &PlanePoint<'_>, distance: &DistanceBounds) -> i8 {
        if distance.high <= 0.0 {
            return 0;
        }
        match self {
            Self::Radius(radius) => radius.sign(point),
            Self::Closed(winding) => winding.sign(point, distance),
        }
    }
}

/// A positive radius in intervals and exactly.
#[derive(Debug)]
pub(crate) struct RadiusSides {
    exact: FourierRadius,
    center: [Interval; 2],
    /// The coefficients a_n and b_n.
    series: Vec<[Interval; 2]>,
}

impl RadiusSides {
    fn new(radius: &FourierRadius) -> Self {
        let pairs = radius.cosines().iter().zip(radius.sines());
        Self {
            center: radius.center().each_ref().map(Interval::narrowest),
            series: pairs
                .map(|(a, b)| [a, b].map(Interval::narrowest))
                .collect(),
            exact: radius.clone(),
        }
    }

    fn sign(&self, point: &PlanePoint<'_>) -> i8 {
        self.by_doubles(point)
            .unwrap_or_else(|| self.exactly((point.exactly)()))
    }

    /// The sign of ρ − r(θ), if doubles decide it.
    fn by_doubles(&self, point: &PlanePoint<'_>) -> Option<i8> {
        let [x, y] = [0, 1].map(|i| Interval::around(point.near[i], point.slack) - self.center[i]);
        let rho = (x.squared() + y.squared()).sqrt();
        if !rho.is_positive() {
            return None;
        }
        let [u, v] = [x / rho, y / rho];
        let (mut cos, mut sin) = (Interval::from(1.0), Interval::ZERO);
        let mut r = Interval::ZERO;
        for [a, b] in &self.series {
            r = r + *a * cos + *b * sin;
            (cos, sin) = (cos * u - sin * v, cos * v + sin * u);
        }
        (rho - r).sign()
    }

    /// The sign of ρ − r(θ).
    ///
    /// With z = x + iy, ρ^N (ρ − r) = ρ^(N+1) − Σ ρ^(N−n) (a_n Re z^n + b_n Im z^n) is E + Oρ with rational E and O; if they have
    /// different signs, E² and O²ρ² are compared.
    fn exactly(&self, point: [Rational; 2]) -> i8 {
        let [x, y] = point;
        let [a, b] = self.exact.center();
        let (x, y) = (x - a, y - b);
        let square = &x * &x + &y * &y;
        if square.is_zero() {
            return -1;
        }
        let last = self.exact.harmonics();
        let powers: Vec<Rational> =
            std::iter::successors(Some(Rational::one()), |p| Some(p * &square))
                .take(last / 2 + 2)
                .collect();
        // The parts E and O, by the parity of the exponent of ρ.
        let mut parts = [Rational::zero(), Rational::zero()];
        let mut add = |exponent: usize, value: Rational| {
            let part = &mut parts[exponent % 2];
            *part = &*part + value * &powers[exponent / 2];
        };
        add(last + 1, Rational::one());
        let (mut cos, mut sin) = (Rational::one(), Rational::zero());
        for n in 0..=last {
            let value = self.exact.cos(n) * &cos + self.exact.sin(n) * &sin;
            add(last - n, -value);
            (cos, sin) = (&cos * &x - &sin * &y, &cos * &y + &sin * &x);
        }
        let [even, odd] = parts;
        match (even.signum(), odd.signum()) {
            (e, 0) => e,
            (0, o) => o,
            (e, o) if e == o => e,
            (e, o) => {
                let [even, odd] = [&even * &even, &odd * &odd * square];
                match even.cmp(&odd) {
                    std::cmp::Ordering::Greater => e,
                    std::cmp::Ordering::Less => o,
                    std::cmp::Ordering::Equal => 0,
                }
            }
        }
    }
}

#[cfg(test)]
#[path = "side_laws.rs"]
mod laws;
