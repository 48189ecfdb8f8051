//! Inspection of points against a parametric curve. The curve itself is compared, not the zero set of its equation, which can
//! have more points.

use std::sync::Arc;

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use super::arcs::{ArcTree, NearestPoint, Waveform};
use super::guess::Guess;
use super::known::rounding;
use super::squared_distance::{
    Against, DistanceForms, SquaredDistance, squared_in_doubles, upper_root,
};
use super::tolerance::Tolerance;
use super::{DistanceBounds, Inspection, InspectorOptions, Verdict};
use crate::error::{Error, Invariant, Result};
use crate::exact::{Dyadic, Rational};
use crate::intervals::Interval;
use crate::limits::Limits;
use crate::poly::RationalFunction;
use crate::shape::{EllipticSeries, FourierRadius, ParametricCurve, harmonics_of_curve};

/// The squared distance of a point of the curve, and its parameter s, `None` for ∞.
type Nearby = (Rational, Option<Dyadic>);

#[cfg(test)]
#[path = "curve_laws.rs"]
mod laws;

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
/// The bounds of a distance are sought to this part of the width that is asked for.
const SHARE: f64 = 0.25;
/// How often the search may start again because a nearer part of the curve exists.
const TURNS: usize = 12;

/// A parametric curve in the plane or in space, ready to be compared with points. The curve is the closure of the points that
/// the parameter reaches.
///
/// The squared distance from a point is an exact rational function of the parameter. The curve meets a sphere about the point
/// exactly if a certain polynomial has a real root or a root at infinity, and this is decided exactly; so the verdict and the
/// criterion are never undecided. The upper bound of the distance comes from a point of the curve, found in doubles; the lower
/// bound is the radius of a sphere that the curve provably misses.
///
/// If the coordinates are finite Fourier series, doubles with error bounds decide nearly all points, in about a microsecond
/// each: by branch and bound over arcs of the curve. The exact way remains for points that are on the curve or at the
/// tolerance, within about 10^−15 of the curve's size, and for distances that are not determined to the requested digits.
#[derive(Clone, Debug)]
pub struct CurveInspector<const N: usize> {
    /// The arcs of the curve in original coordinates, if these are finite Fourier series.
    arcs: Option<Arc<ArcTree<N>>>,
    forms: Arc<DistanceForms<N>>,
    /// The coordinates relative to the center.
    coordinates: Arc<[RationalFunction; N]>,
    guess: Arc<Guess<N>>,
    starts: Arc<[(f64, [f64; N])]>,
    size: f64,
    /// A point in the middle of the curve, relative to the center, and the distance of most points from it.
    spread: ([f64; N], f64),
    center: [Rational; N],
    tolerance: Tolerance,
    /// Bounds of a distance may differ by this part of it.
    relative: f64,
    limits: Limits,
}

impl CurveInspector<2> {
    /// The inspector of the curve r(θ) about its center. Points are in original coordinates.
    ///
    /// ```
    /// use stellate::inspect::{CurveInspector, InspectorOptions, Verdict};
    /// use stellate::limits::Limits;
    /// use stellate::shape::FourierRadius;
    /// let radius: FourierRadius = "r = 1 + 1/5*cos(3t)".parse()?;
    /// let options = InspectorOptions::new("1/10".parse()?);
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
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let curve = radius.to_plane_curve();
        let [a, b, c, d] = EllipticSeries::from_radius(radius).lists().clone();
        let series = Some([[a, b], [c, d]]);
        Self::with_series(&curve, series, radius.center().clone(), options, limits)
    }
}

impl<const N: usize> CurveInspector<N> {
    /// The inspector of a curve whose coordinates are rational functions of its parameter.
    ///
    /// # Errors
    /// [`Error::Usage`] for a tolerance that is not positive, and for a curve of which no point was found in doubles.
    pub fn new(
        curve: &ParametricCurve<N>,
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let origin = std::array::from_fn(|_| Rational::zero());
        Self::with_series(curve, harmonics_of_curve(curve), origin, options, limits)
    }

    /// The inspector of a curve about its center, with the Fourier series of its original coordinates if they are finite.
    fn with_series(
        curve: &ParametricCurve<N>,
        series: Option<[Waveform; N]>,
        center: [Rational; N],
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let guess = match &series {
            Some(series) => Guess::of_series(series, &center),
            None => Guess::of_functions(curve),
        };
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
        let points = || starts.iter().map(|(_, point)| point);
        let middle = std::array::from_fn(|i| median(points().map(|p| p[i])));
        let from_middle = |p: &[f64; N]| norm::<N>(&std::array::from_fn(|i| p[i] - middle[i]));
        let digits = i32::try_from(options.digits.min(14)).invariant("14 is small");
        Ok(Self {
            arcs: series
                .and_then(|series| ArcTree::new(&series))
                .map(Arc::new),
            forms: Arc::new(DistanceForms::new(curve)),
            coordinates: Arc::new(curve.coordinates().clone()),
            guess: Arc::new(guess),
            size: median(points().map(norm)),
            spread: (middle, median(points().map(from_middle))),
            starts: starts.into(),
            center,
            tolerance: Tolerance::new(&options.tolerance)?,
            relative: 0.1f64.powi(digits),
            limits: limits.clone(),
        })
    }

    /// The inspector of the same curve with another tolerance; what was computed for the curve is shared.
    ///
    /// # Errors
    /// [`Error::Usage`] for a tolerance that is not positive.
    pub fn with_tolerance(&self, tolerance: &Rational) -> Result<Self> {
        Ok(Self {
            tolerance: Tolerance::new(tolerance)?,
            ..self.clone()
        })
    }

    /// Inspects a point.
    ///
    /// Cost: a search in a tree of arcs in doubles if the coordinates are finite Fourier series, which decides nearly all
    /// points. Otherwise, two or three counts of the real roots of a polynomial of twice the degree of the coordinates, and a
    /// thousand distances in doubles.
    #[must_use]
    pub fn inspect(&self, point: &[Rational; N]) -> Inspection {
        let near = point.each_ref().map(Rational::to_f64);
        if let Some(arcs) = &self.arcs
            && near.iter().all(|x| x.is_finite())
        {
            let off = near.iter().zip(point).map(|(near, x)| {
                let near = exactly(*near).invariant("the coordinate is finite");
                (near - x).abs()
            });
            let slack = Interval::from(&off.sum::<Rational>()).high();
            if let Some(found) = self.by_arcs(arcs, near, slack) {
                return found;
            }
            return self.by_counts(point, arcs.nearest(near, slack, 0.0));
        }
        self.by_counts(point, None)
    }

    /// Inspects a point whose nearest doubles are `near`. Its exact coordinates are computed only if they are needed.
    ///
    /// ```
    /// use stellate::exact::Rational;
    /// use stellate::inspect::{CurveInspector, InspectorOptions, Verdict};
    /// use stellate::limits::Limits;
    /// use stellate::shape::FourierRadius;
    /// let radius: FourierRadius = "r = 1 + 1/5*cos(3t)".parse()?;
    /// let options = InspectorOptions::new("1/10".parse()?);
    /// let inspector = CurveInspector::radius(&radius, &options, &Limits::none())?;
    /// let near = [1.25, 0.0];
    /// let found = inspector.inspect_near(near, &|| near.map(|x| Rational::try_from(x).unwrap()));
    /// assert_eq!(found.verdict, Verdict::Inside);
    /// assert!(found.distance.low < 0.05 && 0.05 < found.distance.high);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    #[must_use]
    pub fn inspect_near(&self, near: [f64; N], exactly: &dyn Fn() -> [Rational; N]) -> Inspection {
        let arcs = self.arcs.as_deref();
        let found = arcs.and_then(|arcs| self.by_arcs(arcs, near, rounding(near)));
        found.unwrap_or_else(|| self.inspect(&exactly()))
    }

    /// The nearest point of the curve to a point in doubles, with bounds of the distance; `None` if the coordinates of the
    /// curve are not finite Fourier series, or beyond the range of doubles. For the curve of a radius the parameter is θ;
    /// otherwise it is the angle τ with s = tan(τ/2), where the coordinates are functions of s.
    ///
    /// ```
    /// use stellate::inspect::{CurveInspector, InspectorOptions};
    /// use stellate::limits::Limits;
    /// use stellate::shape::FourierRadius;
    /// let radius: FourierRadius = "r = 1 + 1/5*cos(3t)".parse()?;
    /// let options = InspectorOptions::new("1/10".parse()?);
    /// let inspector = CurveInspector::radius(&radius, &options, &Limits::none())?;
    /// let found = inspector.nearest_point([-1.0, 0.0]).unwrap();
    /// assert!((found.at.cos() + 1.0).abs() < 1e-5);
    /// assert!((found.point[0] + 0.8).abs() < 1e-5);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    #[must_use]
    pub fn nearest_point(&self, point: [f64; N]) -> Option<NearestPoint<N>> {
        self.arcs.as_ref()?.nearest(point, 0.0, self.relative)
    }

    /// The inspection in doubles; `None` if their bounds do not decide the verdict and the criterion, or are too wide.
    fn by_arcs(&self, arcs: &ArcTree<N>, near: [f64; N], slack: f64) -> Option<Inspection> {
        let tolerance = self.tolerance.around;
        let decided = |bounds: DistanceBounds| match bounds {
            DistanceBounds { high, .. } if high <= tolerance.low() => Some(Verdict::Inside),
            DistanceBounds { low, .. } if low > tolerance.high() => Some(Verdict::Outside),
            _ => None,
        };
        let mut distance = arcs.nearest(near, slack, SHARE * self.relative)?.distance;
        if decided(distance).is_none() {
            distance = arcs.nearest(near, slack, 0.0)?.distance;
        }
        let verdict = decided(distance)?;
        if distance.high - distance.low > self.relative * distance.high {
            return None;
        }
        // The curve is connected, and it has a point in the ball.
        let curve = verdict == Verdict::Inside && arcs.goes_beyond(near, slack, tolerance)?;
        self.limits.check().ok().map(|()| Inspection {
            sign: None,
            verdict,
            curve: Some(curve),
            distance,
        })
    }

    /// The inspection by exact counts of real roots, which decides every point; what is known of the nearest point narrows the
    /// bounds.
    fn by_counts(&self, point: &[Rational; N], known: Option<NearestPoint<N>>) -> Inspection {
        if self.limits.check().is_err() {
            return Inspection::UNKNOWN;
        }
        let point: [Rational; N] = std::array::from_fn(|i| &point[i] - &self.center[i]);
        let distance = self.forms.to_point(&point);
        let level = self.tolerance.squared();
        let near = point.each_ref().map(Rational::to_f64);
        let start = known.map_or_else(|| self.nearest_start(&near), |known| known.at);
        let ((nearest, _), mut bounds) = self.bounds(start, &near, &distance);
        if let Some(NearestPoint { distance, .. }) = known {
            bounds.low = bounds.low.max(distance.low);
            bounds.high = bounds.high.min(distance.high);
        }
        let verdict = if nearest <= level {
            Verdict::Inside
        } else if exactly(bounds.low).is_some_and(|low| low > self.tolerance.exact) {
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
            distance: bounds.given(verdict, &self.tolerance.exact),
            sign: None,
        }
    }

    /// The inspection without the arcs: the slow way that the arcs are tested against.
    #[doc(hidden)]
    #[must_use]
    pub fn inspect_by_counts(&self, point: &[Rational; N]) -> Inspection {
        self.by_counts(point, None)
    }

    /// Whether a curve that has a point in the ball also has one on the sphere, if it has a point outside: it is connected, or
    /// all its pieces go to infinity.
    fn goes_out(&self, distance: &SquaredDistance, level: &Rational) -> bool {
        self.forms.is_unbounded || distance.against(level) == Against::Meets
    }

    /// The nearest point that was found, and bounds of the distance of the nearest one. The search begins at the angle `start`.
    fn bounds(
        &self,
        start: f64,
        point: &[f64; N],
        distance: &SquaredDistance,
    ) -> (Nearby, DistanceBounds) {
        let mut best = self.descend(start, point, distance);
        let relative = SHARE * self.relative;
        let mut high = upper_root(&best.0);
        if high <= NEARLY_ON * self.size && distance.against(&Rational::zero()) == Against::Meets {
            return ((Rational::zero(), best.1), DistanceBounds::ZERO);
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
                if next.0 < best.0 {
                    best = next;
                    is_nearer = true;
                }
            }
            high = upper_root(&best.0);
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

    /// A point of the curve that is, in doubles, a local minimum of the distance near the given angle.
    fn descend(&self, angle: f64, point: &[f64; N], distance: &SquaredDistance) -> Nearby {
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
            return (distance.at_infinity().unwrap_or_else(huge), None);
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
            let next = cut(&next);
            match distance.at(&next) {
                Some(value) if value < best => (s, best) = (next, value),
                _ => break,
            }
        }
        (best, Some(s))
    }

    pub(crate) fn center(&self) -> &[Rational; N] {
        &self.center
    }

    /// About the size of the curve itself near a point of it, relative to the center: however far away the curve is from there.
    pub(crate) fn size_near(&self, point: &[f64; N]) -> f64 {
        let (middle, size) = &self.spread;
        norm::<N>(&std::array::from_fn(|i| point[i] - middle[i])).max(*size)
    }

    pub(super) fn guess(&self) -> &Guess<N> {
        &self.guess
    }

    pub(super) fn coordinates(&self) -> &[RationalFunction; N] {
        &self.coordinates
    }

    /// The squared distance from a point, relative to the center, as a function of s, and the parameter of the nearest point that
    /// is found; `None` is s = ∞. The search begins at an angle, if there is one.
    pub(super) fn best_parameter(
        &self,
        point: &[Rational; N],
        start: Option<f64>,
    ) -> (SquaredDistance, Option<Dyadic>) {
        let distance = self.forms.to_point(point);
        let near = point.each_ref().map(Rational::to_f64);
        let start = start.unwrap_or_else(|| self.nearest_start(&near));
        let ((_, found), _) = self.bounds(start, &near, &distance);
        (distance, found)
    }
}

/// The number in the middle of numbers, of which there is at least one.
fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.collect();
    let middle = numbers.len() / 2;
    *numbers.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[expect(clippy::cast_precision_loss, reason = "counts of points are small")]
fn part(k: usize, count: usize) -> f64 {
    k as f64 / count as f64
}

fn norm<const N: usize>(point: &[f64; N]) -> f64 {
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
pub(super) fn cut(q: &Rational) -> Dyadic {
    let bits = |n: Integer| n.significant_bits().cast_signed();
    let exponent = bits(q.numerator()) - bits(q.denominator()) - STEP_BITS;
    let unit = Dyadic::new(Integer::from(1), -exponent).to_rational();
    Dyadic::new((q * &unit).floor_integer(), exponent)
}
