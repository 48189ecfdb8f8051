//! The nearest point of a form, and the normal of the form there, in doubles.
//!
//! A foot is found approximately, and then it is checked: its distance from the point must be within the certified bounds of the
//! distance, and it must lie on the form, both up to [`SLACK`] of the size of the coordinates. A foot that does not pass is none.
//! If several points are equally near, up to the digits of the bounds, the foot is one of them.
//!
//! Nothing else rests on a foot; the verdicts and the bounds are proved without it.

mod curve;
mod equation;
mod patch;

use super::DistanceBounds;
use crate::intervals::interval::UNIT;
use crate::intervals::{distance, largest};

/// The largest error of a foot, in parts of the largest coordinate of the point and the foot.
pub(crate) const SLACK: f64 = 1e-9;
/// A foot may be off the form by [`SLACK`] times its size or this many times its distance, …
const WIDE: f64 = 1e3;
/// … or by this part of the size of all coordinates.
const ROUNDED: f64 = 64.0 * UNIT;
/// Errors that are less than this are never too large.
const TINY: f64 = 1e-290;
/// Coordinates that are less than this part of the size are 0.
const NOTHING: f64 = 1e-30;
/// A gradient or tangent that is less than this, in parts of the next derivatives times the size, belongs to a singular point.
pub(super) const SINGULAR: f64 = 1e-8;

/// The nearest point of a form, with the unit normal of the form there; approximate, to nearly all digits of a double. In the plane z
/// is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Foot {
    /// The point.
    pub point: [f64; 3],
    /// The unit normal. It points out of the inside, for an equation to where its canonical polynomial grows. `None` at a singular
    /// point and for a space curve.
    pub normal: Option<[f64; 3]>,
}

/// A foot before the check.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FootCandidate {
    pub(crate) foot: Foot,
    /// About the distance of the point from the form.
    pub(crate) off: f64,
}

impl FootCandidate {
    /// A candidate on the form.
    pub(crate) fn on_form(point: [f64; 3], normal: Option<[f64; 3]>) -> Self {
        Self {
            foot: Foot { point, normal },
            off: 0.0,
        }
    }

    /// The foot of a point whose distance from the form is within the bounds, if it passes the check.
    pub(crate) fn checked(&self, from: [f64; 3], bounds: &DistanceBounds) -> Option<Foot> {
        let Foot { point, normal } = self.foot;
        let size = largest(&point).max(largest(&from));
        // At the origin the smallest errors of f are all that there is.
        let slack = (SLACK * size).max(TINY);
        let length = distance(from, point);
        let is_near = bounds.low - slack <= length && length <= bounds.high + slack;
        let is_unit = normal.is_none_or(|n| (length_of(&n) - 1.0).abs() <= SLACK);
        // Far away from a small form all of it is near a foot; so the foot must be on the form for its own size and distance.
        let own = largest(&point).min(WIDE * bounds.high);
        let is_on = self.off <= (SLACK * own).max(ROUNDED * size).max(TINY);
        // Numbers that are no numbers do not pass.
        (is_near && is_unit && is_on && size.is_finite()).then(|| Foot {
            point: point.map(|x| without_rounding(x, size.min(length))),
            normal: normal.map(|normal| normal.map(|x| without_rounding(x, 1.0))),
        })
    }
}

/// Parameters after at most so many steps of Newton's method, which end where there is no step or it is no longer shorter than the one
/// before.
pub(super) fn after_steps(
    start: [f64; 2],
    most: usize,
    step: impl Fn([f64; 2]) -> Option<[f64; 2]>,
) -> [f64; 2] {
    let mut at = start;
    let mut last = f64::INFINITY;
    for _ in 0..most {
        let Some(step) = step(at) else {
            break;
        };
        let size = step[0].abs().max(step[1].abs());
        if !size.is_finite() || size >= last {
            break;
        }
        at = [at[0] + step[0], at[1] + step[1]];
        last = size;
    }
    at
}

/// 0 for a coordinate that is nothing but a rounding error of numbers of this size.
fn without_rounding(x: f64, size: f64) -> f64 {
    if x.abs() <= NOTHING * size { 0.0 } else { x }
}

fn length_of(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The unit vector of a direction.
pub(crate) fn unit<const N: usize>(v: [f64; N]) -> Option<[f64; N]> {
    // First the largest coordinate becomes 1, so that no square underflows.
    let scale = largest(&v);
    let v = v.map(|x| x / scale);
    let length = length_of(&v);
    let unit = v.map(|x| x / length);
    unit.iter().all(|x| x.is_finite()).then_some(unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_foot_does_not_pass() {
        let bounds = |low: f64, high: f64| DistanceBounds { low, high };
        let from = [3.0, 4.0, 0.0];
        let right = FootCandidate::on_form([0.6, 0.8, 0.0], Some([0.6, 0.8, 0.0]));
        let foot = right.checked(from, &bounds(3.9, 4.1)).unwrap();
        assert_eq!(foot, right.foot);
        for wrong in [bounds(4.1, 4.2), bounds(3.8, 3.9), bounds(4.0 + 1e-8, 5.0)] {
            assert_eq!(right.checked(from, &wrong), None);
        }
        let off = FootCandidate { off: 1e-8, ..right };
        assert_eq!(off.checked(from, &bounds(3.9, 4.1)), None);
        let long = FootCandidate::on_form([0.6, 0.8, 0.0], Some([0.7, 0.8, 0.0]));
        assert_eq!(long.checked(from, &bounds(3.9, 4.1)), None);
        let no_number = FootCandidate::on_form([f64::NAN, 0.8, 0.0], None);
        assert_eq!(no_number.checked(from, &bounds(0.0, f64::INFINITY)), None);
    }

    #[test]
    fn coordinates_that_are_rounding_errors_are_0() {
        let bounds = DistanceBounds {
            low: 1.0,
            high: 1.0,
        };
        let found = FootCandidate::on_form([1e-200, 1.0, 0.0], Some([-1e-40, -1.0, 0.0]));
        let foot = found.checked([0.0; 3], &bounds).unwrap();
        assert_eq!(
            (foot.point, foot.normal),
            ([0.0, 1.0, 0.0], Some([0.0, -1.0, 0.0]))
        );
    }

    #[test]
    fn unit_vectors_need_no_squares_in_range() {
        let near =
            |v: [f64; 2]| unit(v).is_some_and(|[x, y]| (x - 0.6).abs() + (y - 0.8).abs() < 1e-15);
        assert!(near([3e-200, 4e-200]) && near([3e200, 4e200]) && near([3.0, 4.0]));
        assert_eq!(unit([0.0, 0.0]), None);
    }
}
