//! Inspection of points against a parametric curve. The curve itself is compared, not the zero set of its equation, which can
//! have more points.

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use super::squared_distance::{
    Against, DistanceForms, SquaredDistance, squared_in_doubles, upper_root,
};
use super::{DistanceBounds, InspectOptions, Inspection, Verdict};
use crate::error::{Error, Invariant, Result};
use crate::exact::{Dyadic, Rational};
use crate::limits::Limits;
use crate::poly::RationalFunction;
use crate::shape::{CurveInDoubles, FourierRadius, ParametricCurve};

/// The number of starting points along the curve, for each degree of its coordinates, in the search for the nearest point.
const STARTS_PER_DEGREE: usize = 12;
const MIN_STARTS: usize = 192;
/// The number of steps of the golden section search around the best starting point.
const SECTIONS: usize = 44;
/// The number of steps of Newton's method in exact arithmetic, for points very near to the curve.
const EXACT_STEPS: usize = 3;
/// After each step the parameter is rounded to this many bits.
const STEP_BITS: i64 = 200;
/// Exact arithmetic refines the nearest point if its distance is less than this part of the curve's size.
const NEARLY_ON: f64 = 1e-5;
/// How often the search may start again because a nearer part of the curve exists.
const TURNS: usize = 12;

/// A parametric curve in the plane or in space, ready to be compared with points. The curve is the closure of the points that
/// the parameter reaches.
///
/// The squared distance from a point is an exact rational function of the parameter. The curve meets a sphere about the point
/// exactly if a certain polynomial has a real root or a root at infinity, and this is decided exactly; so the verdict and the
/// criterion are never undecided. The upper bound of the distance comes from a point of the curve, found in doubles; the lower
/// bound is the radius of a sphere that the curve provably misses.
#[derive(Debug)]
pub struct CurveInspector<const N: usize> {
    forms: DistanceForms<N>,
    guess: Guess<N>,
    starts: Vec<(f64, [f64; N])>,
    size: f64,
    center: [Rational; N],
    tolerance: Rational,
    digits: u32,
    limits: Limits,
}

/// The curve in doubles without certificate, over an angle τ from −π to π with s = tan(τ/2).
#[derive(Debug)]
enum Guess<const N: usize> {
    /// r(τ) = Σ a_n cos nτ + b_n sin nτ: the coefficients by n.
    Radius(Vec<[f64; 2]>),
    /// Rational functions of s.
    Functions(CurveInDoubles<N>),
}

impl CurveInspector<2> {
    /// The inspector of the curve r(θ) about its center. Points are in original coordinates.
    ///
    /// ```
    /// use stellate::inspect::{CurveInspector, InspectOptions, Verdict};
    /// use stellate::limits::Limits;
    /// use stellate::shape::FourierRadius;
    /// let radius: FourierRadius = "r = 1 + 1/5*cos(3t)".parse()?;
    /// let options = InspectOptions::new("1/10".parse()?);
    /// let inspector = CurveInspector::radius(&radius, &options, &Limits::none())?;
    /// // The origin is an isolated zero of the curve's polynomial, but no point of the curve.
    /// let found = inspector.inspect(&[0.into(), 0.into()]);
    /// assert_eq!(found.verdict, Verdict::Outside);
    /// assert!(found.distance.low > 0.79 && found.distance.high < 0.81);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`CurveInspector::new`].
    pub fn radius(
        radius: &FourierRadius,
        options: &InspectOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let curve = radius.to_plane_curve();
        let pairs = radius.cosines().iter().zip(radius.sines());
        let guess = Guess::Radius(pairs.map(|(a, b)| [a.to_f64(), b.to_f64()]).collect());
        Self::with_guess(&curve, guess, radius.center().clone(), options, limits)
    }
}

impl<const N: usize> CurveInspector<N> {
    /// The inspector of a curve whose coordinates are rational functions of its parameter.
    ///
    /// # Errors
    /// [`Error::Usage`] for a tolerance that is not positive, and for a curve of which no point was found in doubles.
    pub fn new(
        curve: &ParametricCurve<N>,
        options: &InspectOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let origin = std::array::from_fn(|_| Rational::zero());
        let guess = Guess::Functions(curve.in_doubles());
        Self::with_guess(curve, guess, origin, options, limits)
    }

    fn with_guess(
        curve: &ParametricCurve<N>,
        guess: Guess<N>,
        center: [Rational; N],
        options: &InspectOptions,
        limits: &Limits,
    ) -> Result<Self> {
        if options.tolerance.signum() <= 0 {
            return Err(Error::Usage(format!(
                "the tolerance {}: expected a positive number, such as 0.1",
                options.tolerance
            )));
        }
        let degrees = curve.coordinates().iter().map(RationalFunction::degree);
        let count = degrees.fold(MIN_STARTS, |count, d| count.max(STARTS_PER_DEGREE * d));
        let starts: Vec<(f64, [f64; N])> = (0..count)
            .map(|k| -std::f64::consts::PI + std::f64::consts::TAU * part(k, count))
            .map(|angle| (angle, guess.at(angle)))
            .filter(|(_, point)| point.iter().all(|x| x.is_finite()))
            .collect();
        if starts.is_empty() {
            return Err(Error::Usage(
                "no point of the curve is within the range of doubles".into(),
            ));
        }
        let mut sizes: Vec<f64> = starts.iter().map(|(_, p)| norm(p)).collect();
        sizes.sort_by(f64::total_cmp);
        Ok(Self {
            forms: DistanceForms::new(curve),
            guess,
            size: sizes[sizes.len() / 2],
            starts,
            center,
            tolerance: options.tolerance.clone(),
            digits: options.digits.min(14),
            limits: limits.clone(),
        })
    }

    /// Inspects a point.
    ///
    /// Cost: two or three counts of the real roots of a polynomial of twice the degree of the coordinates, and a thousand
    /// distances in doubles.
    #[must_use]
    pub fn inspect(&self, point: &[Rational; N]) -> Inspection {
        if self.limits.check().is_err() {
            return Inspection::UNKNOWN;
        }
        let point: [Rational; N] = std::array::from_fn(|i| &point[i] - &self.center[i]);
        let distance = self.forms.to_point(&point);
        let level = &self.tolerance * &self.tolerance;
        let near = point.each_ref().map(Rational::to_f64);
        let (nearest, bounds) = self.bounds(&near, &distance);
        let verdict = if nearest <= level {
            Verdict::Inside
        } else if exactly(bounds.low).is_some_and(|low| low > self.tolerance) {
            Verdict::Outside
        } else {
            match distance.against(&level) {
                Against::Outside => Verdict::Outside,
                Against::Meets | Against::Inside => Verdict::Inside,
            }
        };
        Inspection {
            verdict,
            curve: Some(verdict == Verdict::Inside && self.goes_out(&distance, &level)),
            distance: bounds.given(verdict, &self.tolerance),
            sign: None,
        }
    }

    /// Whether a curve that has a point in the ball also has one on the sphere, if it has a point outside: it is connected, or
    /// all its pieces go to infinity.
    fn goes_out(&self, distance: &SquaredDistance, level: &Rational) -> bool {
        self.forms.is_unbounded || distance.against(level) == Against::Meets
    }

    /// The squared distance of some point of the curve, and bounds of the distance of the nearest one.
    fn bounds(&self, point: &[f64; N], distance: &SquaredDistance) -> (Rational, DistanceBounds) {
        let start = self.nearest_start(point);
        let mut best = self.descend(start, point, distance);
        let relative = 0.25 * 0.1f64.powi(i32::try_from(self.digits).unwrap_or(14));
        let mut high = upper_root(&best);
        if high <= NEARLY_ON * self.size && distance.against(&Rational::zero()) == Against::Meets {
            return (Rational::zero(), DistanceBounds::ZERO);
        }
        for _ in 0..TURNS {
            let low = high * (1.0 - relative);
            let Some(level) = exactly(low).map(|low| &low * &low) else {
                break;
            };
            match distance.against(&level) {
                Against::Outside => return (best, DistanceBounds { low, high }),
                Against::Inside => break,
                // Some other part of the curve is nearer.
                Against::Meets => {}
            }
            let mut is_nearer = false;
            for s in distance.crossings(&level) {
                let next = self.descend(2.0 * s.atan(), point, distance);
                if next < best {
                    best = next;
                    is_nearer = true;
                }
            }
            high = upper_root(&best);
            if !is_nearer {
                break;
            }
        }
        (
            best,
            DistanceBounds {
                low: self.some_lower_bound(high, distance),
                high,
            },
        )
    }

    /// The radius of a sphere that the curve provably misses; it may be very small.
    fn some_lower_bound(&self, high: f64, distance: &SquaredDistance) -> f64 {
        let parts = [0.999, 0.99, 0.9, 0.5, 0.1, 1e-3, 1e-6];
        let misses = |low: &f64| {
            let level = exactly(*low).map(|low| &low * &low);
            level.is_some_and(|level| distance.against(&level) == Against::Outside)
        };
        parts
            .map(|part| part * high)
            .into_iter()
            .find(misses)
            .unwrap_or(0.0)
    }

    /// The angle τ of the nearest starting point.
    fn nearest_start(&self, point: &[f64; N]) -> f64 {
        let nearest = self.starts.iter().min_by(|(_, a), (_, b)| {
            squared_in_doubles(a, point).total_cmp(&squared_in_doubles(b, point))
        });
        let (angle, _) = nearest.invariant("there is a start");
        *angle
    }

    /// The exact squared distance of a point of the curve that is, in doubles, a local minimum of the distance near the given
    /// angle.
    fn descend(&self, angle: f64, point: &[f64; N], distance: &SquaredDistance) -> Rational {
        let step = std::f64::consts::TAU / part(self.starts.len(), 1);
        let squared = |angle: f64| squared_in_doubles(&self.guess.at(angle), point);
        let golden = (5f64.sqrt() - 1.0) / 2.0;
        let [mut low, mut high] = [angle - 1.5 * step, angle + 1.5 * step];
        let mut inner = [high - golden * (high - low), low + golden * (high - low)];
        let mut values = inner.map(squared);
        for _ in 0..SECTIONS {
            if values[0] < values[1] {
                high = inner[1];
                inner = [high - golden * (high - low), inner[0]];
                values = [squared(inner[0]), values[0]];
            } else {
                low = inner[0];
                inner = [inner[1], low + golden * (high - low)];
                values = [values[1], squared(inner[1])];
            }
        }
        let s = (f64::midpoint(low, high) / 2.0).tan();
        let Some(mut s) = Dyadic::from_f64(s) else {
            return distance.at_infinity().unwrap_or_else(huge);
        };
        let mut best = distance.at(&s).unwrap_or_else(huge);
        let near = |squared: &Rational| squared.to_f64() <= (NEARLY_ON * self.size).powi(2);
        for _ in 0..EXACT_STEPS {
            if !near(&best) {
                break;
            }
            let Some(next) = distance.newton_step(&s) else {
                break;
            };
            s = cut(&next);
            match distance.at(&s) {
                Some(value) if value < best => best = value,
                _ => break,
            }
        }
        best
    }
}

impl<const N: usize> Guess<N> {
    fn at(&self, angle: f64) -> [f64; N] {
        match self {
            Self::Radius(series) => {
                let (sin, cos) = angle.sin_cos();
                // cos nτ and sin nτ for n = 0, 1, … are computed by rotations. They may be slightly wrong, as this is only a
                // guess; the function is called often.
                let (mut turned, mut r) = ([1.0, 0.0], 0.0);
                for [a, b] in series {
                    r += a * turned[0] + b * turned[1];
                    turned = [
                        turned[0] * cos - turned[1] * sin,
                        turned[0] * sin + turned[1] * cos,
                    ];
                }
                let mut point = [0.0; N];
                for (x, u) in point.iter_mut().zip([cos, sin]) {
                    *x = r * u;
                }
                point
            }
            Self::Functions(functions) => {
                let (sin, cos) = (angle / 2.0).sin_cos();
                functions.at([sin, cos])
            }
        }
    }
}

#[expect(clippy::cast_precision_loss, reason = "counts of points are small")]
fn part(k: usize, count: usize) -> f64 {
    k as f64 / count as f64
}

fn norm(point: &[f64]) -> f64 {
    point.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn exactly(x: f64) -> Option<Rational> {
    Rational::try_from(x).ok()
}

/// A distance beyond all points that are searched.
fn huge() -> Rational {
    exactly(f64::MAX).invariant("the largest double is finite")
}

/// The number rounded to [`STEP_BITS`] bits after the leading one.
fn cut(q: &Rational) -> Dyadic {
    let bits = |n: Integer| n.significant_bits().cast_signed();
    let exponent = bits(q.numerator()) - bits(q.denominator()) - STEP_BITS;
    let unit = Dyadic::new(Integer::from(1), -exponent).to_rational();
    Dyadic::new((q * &unit).floor_integer(), exponent)
}
