//! The distance of a point that is farther away than the tolerance.

use super::DistanceBounds;
use super::distance::{Goal, nearest};
use super::exact::{critical_point, exact_difference, rational_zero, squared_length};
use super::inspector::{Factor, Inspector};
use super::known::{PartialInspection, Point};
use crate::exact::Rational;
use crate::intervals::interval::separation;
use crate::intervals::{Field, Interval, largest, rational, rationals};
use crate::roots::RealRoot;

/// The part of the cubes of a verdict that may be divided for a distance.
pub(super) const SHARE: usize = 8;
/// How often the search radius is doubled along a ray, from the tolerance on.
const DOUBLINGS: u32 = 64;
/// How near a rational point must be to a critical point in doubles, relative to the size of the coordinates.
const WIDTH: f64 = 1e-9;
/// How often a piece of a ray with a zero is halved.
const HALVINGS: u32 = 30;
/// The number of bits to which zeros on lines are computed.
const PRECISION: i64 = 60;
/// How often the search radius grows, by a factor of 4 each time, if no zero was found on the rays.
pub(super) const GROWTHS: u32 = 12;

impl Inspector {
    /// Improves the bounds of the distances of the factors' zeros from a point that is outside, until those of the nearest one are
    /// as close as the goal requires or the cubes are used up. `at` is the point for a factor.
    pub(super) fn far<'p>(
        &'p self,
        parts: &mut [PartialInspection],
        at: impl Fn(&'p Field) -> &'p Point<'p>,
    ) {
        let high = |parts: &[PartialInspection]| {
            let highs = parts.iter().map(|known| known.bounds.high);
            highs.fold(f64::INFINITY, f64::min)
        };
        let is_near = |known: &PartialInspection, best: f64| {
            known.bounds.low < best * (1.0 - self.goal.relative)
        };
        // The distances from the curves of common zeros are known.
        fn others<'k, 'p>(
            parts: &'k mut [PartialInspection],
            factors: &'p [Factor],
        ) -> impl Iterator<Item = (&'k mut PartialInspection, &'p Field)> {
            let pairs = parts.iter_mut().zip(factors);
            let pairs =
                pairs.filter(|(known, factor)| factor.curve.is_none() || known.foot.is_none());
            pairs.map(|(known, factor)| (known, &factor.field))
        }
        for (known, field) in others(parts, self.factors()) {
            self.by_refined_foot(field, at(field), known);
            if !self.is_close(&known.bounds) {
                self.by_quadric(field, at(field), known);
            }
        }
        let best = high(parts);
        if parts.iter().all(|known| !is_near(known, best)) && best.is_finite() {
            return;
        }
        for (known, field) in others(parts, self.factors()) {
            if known.bounds.high.is_infinite() {
                let p = at(field);
                let mut high = self.on_rays(field, p).min(towards_extremum(field, p.near));
                if high.is_infinite() && self.is_exact_possible(field) {
                    high = self.on_lines(field, p);
                }
                let found = DistanceBounds { low: 0.0, high };
                self.learn(known, found, p.slack);
            }
        }
        let mut reach = high(parts);
        let is_known = reach.is_finite();
        if !is_known {
            reach = self.goal.reach;
        }
        for _ in 0..if is_known { 1 } else { GROWTHS } {
            if !is_known {
                reach *= 4.0;
            }
            for (known, field) in others(parts, self.factors()) {
                if is_near(known, reach) {
                    self.search_within(field, at(field), known, reach);
                }
            }
            if high(parts).is_finite() || self.limits.check().is_err() {
                return;
            }
        }
    }

    /// A search of cubes within a radius.
    fn search_within(&self, field: &Field, p: &Point, known: &mut PartialInspection, reach: f64) {
        let slack = Interval::from(p.slack);
        let outer = DistanceBounds {
            low: (Interval::from(known.bounds.low) - slack).or_zero().low(),
            high: (Interval::from(known.bounds.high) + slack).high(),
        };
        let goal = Goal {
            reach: (Interval::from(reach) * (1.0 + 1e-9) + slack).high(),
            tolerance: 0.0,
            cubes: self.cubes_for(field) / SHARE,
            ..self.goal
        };
        let found = nearest(field, p.near, field.sign(p.near), outer, goal, &self.limits);
        self.learn(known, found.bounds, p.slack);
        if !self.is_close(&known.bounds) && self.is_exact_possible(field) {
            self.by_rational_point(field, p, &found.near, known);
        }
    }

    /// Improves the upper bound by zeros at rational points near `starts` at which the gradient vanishes. There f need not change its
    /// sign, as at isolated points.
    fn by_rational_point(
        &self,
        field: &Field,
        p: &Point,
        starts: &[[f64; 3]],
        known: &mut PartialInspection,
    ) {
        let width = rational(WIDTH * largest(&p.near).max(self.goal.reach));
        for start in starts {
            let Some(critical) = critical_point(field, *start) else {
                continue;
            };
            let Some(zero) = rational_zero(field, &rationals(critical), &width) else {
                continue;
            };
            let square = squared_length(&exact_difference(p.exactly(), &zero));
            let high = Interval::from(&square).sqrt().high();
            if high < known.bounds.high {
                known.bounds.high = high;
                known.foot = Some(zero.each_ref().map(Rational::to_f64));
                known.exact_foot = Some(zero);
            }
        }
    }

    /// An upper bound of the distance of a zero, from changes of the sign along a few rays; ∞ if none is found.
    fn on_rays(&self, field: &Field, p: &Point) -> f64 {
        let sign = field.sign(p.near);
        directions(field, p.near)
            .filter_map(|u| {
                let length = u.iter().map(|x| x * x).sum::<f64>().sqrt();
                let u = u.map(|x| x / length);
                self.first_change(field, p.near, u, sign)
            })
            .fold(f64::INFINITY, f64::min)
    }

    /// An upper bound of the distance of a zero, from all zeros on a few lines, which are computed exactly; ∞ if there is none. A zero
    /// without a change of the sign is found, too, and a surface that is small and far away, if its middle is near the origin.
    fn on_lines(&self, field: &Field, p: &Point) -> f64 {
        let at = rationals(p.near);
        let Ok(about) = field.polynomial().about(&at, &self.limits) else {
            return f64::INFINITY;
        };
        let to_origin = at.map(|x| -x);
        directions(field, p.near)
            .filter(|u| u.iter().all(|x| x.is_finite()))
            .map(rationals)
            .chain([to_origin])
            .filter_map(|u| {
                let row = about.along(&u);
                if row.is_empty() {
                    // The point itself is a zero.
                    return Some(0.0);
                }
                let away = RealRoot::all_of(&row).into_iter().map(|mut root| {
                    root.refine(PRECISION);
                    let (low, high) = root.bounds();
                    low.abs().max(high.abs())
                });
                let square = away.min().map(|t| &t * &t * squared_length(&u))?;
                Some(Interval::from(&square).sqrt().high())
            })
            .fold(f64::INFINITY, f64::min)
    }

    /// An upper bound of the distance of a change of the sign along a ray.
    fn first_change(&self, field: &Field, p: [f64; 3], u: [f64; 3], sign: i8) -> Option<f64> {
        let there = |t: f64| -> [f64; 3] { std::array::from_fn(|i| p[i] + t * u[i]) };
        let is_other = |t: f64| {
            let q = there(t);
            q.iter().all(|x| x.is_finite()) && field.sign(q) != sign
        };
        let mut radii = (0..DOUBLINGS).map(|k| self.goal.tolerance * f64::from(k).exp2());
        let first = radii.find(|&t| is_other(t))?;
        let t = halved(0.0, first, f64::midpoint, is_other);
        Some(separation(p, there(t)).high())
    }
}

/// Directions along the axes and between them, in the plane or in space, and that of the gradient.
fn directions(field: &Field, p: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    let axes = if field.is_flat() { 2 } else { 3 };
    let steps = |n: u32| [n % 3, n / 3 % 3, n / 9].map(|k| f64::from(k) - 1.0);
    let rays = (0..3u32.pow(axes)).map(move |n| match axes {
        2 => [steps(n)[0], steps(n)[1], 0.0],
        _ => steps(n),
    });
    rays.filter(|u| u.iter().any(|x| x.abs() > 0.5))
        .chain([field.gradient(p)])
}

/// A point with the property of `far` that is near the end of those without it, by halving what is between them.
fn halved<T: Copy>(
    mut near: T,
    mut far: T,
    middle: impl Fn(T, T) -> T,
    is_far: impl Fn(T) -> bool,
) -> T {
    for _ in 0..HALVINGS {
        let between = middle(near, far);
        if is_far(between) {
            far = between;
        } else {
            near = between;
        }
    }
    far
}

/// An upper bound of the distance of a change of the sign between a point and a critical point of f that is found from it; ∞ if f has one
/// sign at both. Rays in fixed directions miss a surface that is thin, but its inside has an extremum.
fn towards_extremum(field: &Field, p: [f64; 3]) -> f64 {
    let sign = field.sign(p);
    let Some(extremum) = critical_point(field, p).filter(|x| field.sign(*x) != sign) else {
        return f64::INFINITY;
    };
    let middle = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| f64::midpoint(a[i], b[i]));
    let other = halved(p, extremum, middle, |x| field.sign(x) != sign);
    separation(p, other).high()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::inspect::{DistanceBounds, InspectorOptions, Verdict};
    use crate::limits::Limits;
    use crate::poly::{Ring, SparsePolynomial};
    use crate::shape::{ImplicitCurve, ImplicitSurface};

    /// The polynomial Σ (x_i − c_i)^n − rⁿ.
    fn ball(axes: usize, n: u32, center: &[Rational; 3], radius: &Rational) -> SparsePolynomial<3> {
        let away = |i: usize| {
            let x = SparsePolynomial::variable(i);
            x.minus(&SparsePolynomial::constant(center[i].clone()))
                .pow(n)
        };
        let size = radius.pow(n.into()).unwrap();
        (0..axes).fold(SparsePolynomial::constant(-size), |sum, i| {
            sum.plus(&away(i))
        })
    }

    fn distance(f: &SparsePolynomial<3>, p: &[Rational; 3], tolerance: Rational) -> DistanceBounds {
        let (options, limits) = (InspectorOptions::new(tolerance), Limits::none());
        let inspector = match f.to_plane() {
            Some(plane) => Inspector::plane(&ImplicitCurve::new(plane), &options, &limits),
            None => Inspector::surface(&ImplicitSurface::new(f.clone()), &options, &limits),
        };
        let found = inspector.unwrap().inspect(p);
        assert_eq!(found.verdict, Verdict::Outside);
        found.distance
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]

        /// Circles and spheres of any size, near the origin or far from it, and points that are far or very far from them.
        #[test]
        fn a_round_form_far_away_is_found(
            axes in 2usize..4,
            center in prop::array::uniform3(-1_000_000_000i64..1_000_000_000),
            is_far in any::<bool>(),
            radius in 1i64..1000,
            scale in -20i64..40,
            towards in prop::array::uniform3(-9i64..9),
            times in 2i64..100_000_000,
        ) {
            prop_assume!(towards[..axes].iter().any(|x| *x != 0));
            let radius = Rational::from(radius) * Rational::from(2).pow(scale).unwrap();
            let center = center.map(|c| if is_far { Rational::from(c) / Rational::from(7) } else { Rational::zero() });
            let mut towards = towards.map(|x| Rational::from(x) * &radius * Rational::from(times));
            let mut center = center;
            for i in axes..3 {
                (towards[i], center[i]) = (Rational::zero(), Rational::zero());
            }
            let point: [Rational; 3] = std::array::from_fn(|i| &center[i] + &towards[i]);
            let f = ball(axes, 2, &center, &radius);
            let found = distance(&f, &point, &radius / &Rational::from(100));
            let square = squared_length(&towards);
            // (d + r)² on both sides of |p − c|², exactly.
            let beyond = |d: f64| (rational(d) + &radius).pow(2).unwrap();
            prop_assert!(beyond(found.low) <= square && square <= beyond(found.high), "{found:?}");
            prop_assert!(found.high - found.low <= 3e-6 * found.high, "{found:?}");
        }
    }

    /// A surface that the doubled steps along a ray miss, and zeros without a change of the sign that are not rational.
    #[test]
    fn zeros_on_lines_are_found() {
        let number = |x: f64| rational(x);
        let unit = ball(3, 4, &[0.0; 3].map(number), &Rational::one());
        let found = distance(&unit, &[1e9, 0.0, 0.0].map(number), "1/10".parse().unwrap());
        assert!(found.low > 9.999e8 && found.low <= 999_999_999.0);
        assert!((999_999_999.0..999_999_999.001).contains(&found.high));
        // (x² − 2)² + y²
        let x = SparsePolynomial::<3>::variable(0).pow(2);
        let y = SparsePolynomial::<3>::variable(1).pow(2);
        let points = x
            .minus(&SparsePolynomial::constant(2.into()))
            .pow(2)
            .plus(&y);
        let found = distance(&points, &[0.0; 3].map(number), "1/10".parse().unwrap());
        let root = 2f64.sqrt();
        assert!(found.low <= root && root <= found.high && found.high - found.low < 3e-6);
    }
}
