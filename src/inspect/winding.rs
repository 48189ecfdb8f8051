//! Whether a closed plane curve, traced once, winds an odd number of times around a point.

use malachite::Integer;
use malachite::base::polynomial::Derivative;

use super::DistanceBounds;
use super::known::PlanePoint;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::fit::NearPolygon;
use crate::implicitize::traced_once;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, RationalFunction, polynomial_gcd, scaled};
use crate::roots::real_roots;
use crate::shape::{EllipticSeries, PlaneCurve};

/// The coordinates of a closed curve, which are functions of a parameter that traces it once or an odd number of times, or there and
/// back; and a polygon near it if it has one.
#[derive(Debug)]
pub(crate) struct Winding {
    coordinates: [RationalFunction; 2],
    polygon: Option<NearPolygon>,
}

impl Winding {
    /// Whether no parameter, ∞ included, is a pole.
    pub(super) fn is_closed(curve: &PlaneCurve) -> bool {
        curve.coordinates().iter().all(|f| {
            let length = |p: &IntegerPolynomial| p.coefficients_asc().len();
            length(f.numerator()) <= length(f.denominator())
                && real_roots(f.denominator()).is_empty()
        })
    }

    /// The winding numbers of a closed curve.
    ///
    /// # Errors
    /// [`crate::error::Error::Limit`] if it is too much work to find a parameter that traces the curve once; those of `limits`.
    pub(super) fn new(curve: &PlaneCurve, limits: &Limits) -> Result<Self> {
        match EllipticSeries::of_plane_curve(curve) {
            Some(series) => Self::of_series(&series, limits),
            None => Ok(Self {
                coordinates: traced_once(curve.coordinates(), limits)?
                    .unwrap_or_else(|| curve.coordinates().clone()),
                polygon: None,
            }),
        }
    }

    /// The winding numbers of the curve of a series.
    ///
    /// A series without a common divisor of its harmonics traces its curve an odd number of times, or there and back. For as a
    /// function of a parameter that traces the curve once it has its poles where the series has them, at the two ends of the
    /// imaginary angle: the parameter is a multiple of the angle, if it has both poles, or a real trigonometric polynomial, if it
    /// has one, which comes back to where it began.
    pub(super) fn of_series(series: &EllipticSeries, limits: &Limits) -> Result<Self> {
        let once = series.traced_once();
        let series = once.as_ref().unwrap_or(series);
        Ok(Self {
            coordinates: series.to_plane_curve().coordinates().clone(),
            polygon: NearPolygon::new(series, limits)?,
        })
    }

    /// −1 where the winding number is odd, else 1; 0 on the curve. The distance of the point from the curve is at least
    /// `distance.low`.
    pub(super) fn sign(&self, point: &PlanePoint<'_>, distance: &DistanceBounds) -> i8 {
        let by_polygon = self
            .polygon
            .as_ref()
            .and_then(|polygon| polygon.winds_oddly(point.near, distance.low - point.slack));
        match by_polygon {
            Some(true) => -1,
            Some(false) => 1,
            None => self.exactly(&(point.exactly)()),
        }
    }

    /// The sign by the number of points in which a ray from the point crosses the curve. The first of a few directions is taken
    /// in which the line through the point meets the curve only in simple crossings, not at the parameter ∞.
    fn exactly(&self, point: &[Rational; 2]) -> i8 {
        let [x, y] = [0, 1].map(|i| relative_to(&self.coordinates[i], &point[i]));
        // The coordinates over a common denominator, which has no real zero and so one sign.
        let common = x.1.clone() * &y.1;
        let (x, y) = (x.0 * &y.1, y.0 * &x.1);
        let length = |p: &IntegerPolynomial| p.coefficients_asc().len();
        let longest = length(&common);
        let is_positive = common.coefficients_asc().first().is_some_and(|c| *c > 0);
        if is_zero_at_once(&x, &y, longest) {
            return 0;
        }
        let count = (0i64..).find_map(|k| {
            let [a, b] = [1 + k * k, 3 * k].map(Integer::from);
            let across = scaled(&y, &a) - scaled(&x, &b);
            let shared = polynomial_gcd(&across, &(&across).derivative());
            if length(&across) < longest || !real_roots(&shared).is_empty() {
                return None;
            }
            let along = scaled(&x, &a) + scaled(&y, &b);
            let ahead = if is_positive { 1 } else { -1 };
            let roots = real_roots(&across);
            Some(
                roots
                    .iter()
                    .filter(|root| root.sign_of(&along) == ahead)
                    .count(),
            )
        });
        let count =
            count.invariant("finitely many lines through a point meet a curve in multiple points");
        if count % 2 == 1 { -1 } else { 1 }
    }
}

/// Whether two polynomials have a common real zero, ∞ included if both are shorter than `longest`.
fn is_zero_at_once(x: &IntegerPolynomial, y: &IntegerPolynomial, longest: usize) -> bool {
    let is_short = |p: &IntegerPolynomial| p.coefficients_asc().len() < longest;
    let common = polynomial_gcd(x, y);
    is_short(x) && is_short(y) || !real_roots(&common).is_empty()
}

/// The numerator and the denominator of f − c.
fn relative_to(f: &RationalFunction, c: &Rational) -> (IntegerPolynomial, IntegerPolynomial) {
    let (p, q) = (c.numerator(), c.denominator());
    (
        scaled(f.numerator(), &q) - scaled(f.denominator(), &p),
        scaled(f.denominator(), &q),
    )
}
