//! Follows an arc from tube to tube.

use super::tube::{Enclosed, Tube, enclose, largest, newton, tangent, tube};
use crate::intervals::{Field, between};

/// A tube extends beyond both ends of its step by this part of the step, so that neighbouring tubes overlap.
const OVERLAP: f64 = 0.25;
/// Half the width of a tube, in steps. An arc rises by at most 0.75 from the middle, where its slope is 1.
const WIDTH: f64 = 1.25;
/// The next point must be this near to where it is expected, in steps.
const REACH: f64 = 1e-3;
/// The cosine of the largest angle (6°) between the directions at neighbouring points, unless the step is small.
const COSINE: f64 = 0.9945;
/// Where the arc bends, steps are made smaller, down to this part of the longest step.
const SMALL: f64 = 1.0 / 64.0;
/// The longest step out of a window, in parts of its side.
const LONGEST: f64 = 1.0 / 8.0;

/// Two surfaces, a box, and the lengths of steps.
pub(super) struct Path<'a> {
    pub(super) fields: [&'a Field; 2],
    pub(super) window: [[f64; 2]; 3],
    pub(super) longest: f64,
    pub(super) shortest: f64,
}

/// The reason why following an arc ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stop {
    /// The arc came back to its first point.
    Closed,
    /// The first point outside of the window, at the end of the last tube.
    Window(Enclosed),
    /// No tube could be proved.
    Unresolved,
    /// The arc reached an arc that was known before.
    Known,
}

/// A part of an arc, without the point that it started from.
pub(super) struct Run {
    pub(super) points: Vec<Enclosed>,
    pub(super) tubes: Vec<Tube>,
    pub(super) stop: Stop,
}

impl Path<'_> {
    fn tangent(&self, p: [f64; 3]) -> Option<[f64; 3]> {
        tangent(self.fields, p)
    }

    pub(super) fn is_inside(&self, p: [f64; 3]) -> bool {
        let mut sides = p.iter().zip(&self.window);
        sides.all(|(x, [a, b])| a <= x && x <= b)
    }

    /// The common zero near a point that is close to both surfaces.
    pub(super) fn seed(&self, start: [f64; 3], reach: f64) -> Option<Enclosed> {
        let axis = largest(self.tangent(start)?);
        let near = newton(self.fields, axis, start)?;
        let found = enclose(self.fields, axis, near, REACH * reach)?;
        self.is_inside(found.position).then_some(found)
    }

    /// Follows the arc through `seed` in the direction of ∇f × ∇g, or against it with `sense` −1.
    pub(super) fn follow(&self, seed: &Enclosed, sense: f64, known: &[Tube]) -> Run {
        let mut run = Run {
            points: Vec::new(),
            tubes: Vec::new(),
            stop: Stop::Unresolved,
        };
        let mut at = *seed;
        let mut step = self.longest / 4.0;
        while step >= self.shortest {
            let Some(tangent) = self.tangent(at.position) else {
                break;
            };
            let tangent = tangent.map(|t| sense * t);
            let found = self.step(&at, tangent, step);
            let turns = |p: &Enclosed| {
                // A direction that is not known counts as turned too much.
                let cosine = self.tangent(p.position).map_or(-1.0, |next| {
                    let pairs = tangent.iter().zip(next);
                    pairs.map(|(a, b)| sense * a * b).sum::<f64>()
                });
                cosine < COSINE && step > SMALL * self.longest
            };
            let Some((tube, next)) = found.filter(|(_, next)| !turns(next)) else {
                step /= 2.0;
                continue;
            };
            let ahead = tangent[tube.axis] * (seed.position[tube.axis] - at.position[tube.axis]);
            if ahead > 0.0 && tube.holds_point(seed) {
                run.tubes.push(tube);
                run.stop = Stop::Closed;
                break;
            }
            if known.iter().any(|old| old.holds_point(&next)) {
                run.stop = Stop::Known;
                break;
            }
            if !self.is_inside(next.position) {
                let last = self.exit(&at, &next, &tube);
                if last.is_none() && step / 2.0 >= self.shortest {
                    step /= 2.0;
                    continue;
                }
                run.points.extend(last);
                run.tubes.push(tube);
                run.stop = Stop::Window(next);
                break;
            }
            run.points.push(next);
            run.tubes.push(tube);
            at = next;
            step = (1.5 * step).min(self.longest);
        }
        run
    }

    /// The tube of a step from a point, and the point at the end of the step.
    fn step(&self, at: &Enclosed, tangent: [f64; 3], step: f64) -> Option<(Tube, Enclosed)> {
        let axis = largest(tangent);
        let ahead = |part: f64| {
            let length = part * step / tangent[axis].abs();
            std::array::from_fn(|i| at.position[i] + length * tangent[i])
        };
        let middle = newton(self.fields, axis, ahead(0.5))?;
        let mut halves = [WIDTH * step; 3];
        halves[axis] = (0.5 + OVERLAP) * step;
        let tube = tube(self.fields, axis, middle, halves).filter(|t| t.holds_point(at))?;
        let near = newton(self.fields, axis, ahead(1.0))?;
        let next = enclose(self.fields, axis, near, REACH * step)?;
        tube.holds_point(&next).then_some((tube, next))
    }

    /// The point where the arc in a tube leaves the window.
    fn exit(&self, inside: &Enclosed, outside: &Enclosed, tube: &Tube) -> Option<Enclosed> {
        let [p, q] = [inside.position, outside.position];
        let crossed = (0..3).filter_map(|i| {
            let bounds = self.window[i].into_iter();
            let beyond = bounds.filter(|b| (p[i] <= *b) != (q[i] <= *b));
            let parts = beyond.map(|b| ((b - p[i]) / (q[i] - p[i]), i, b));
            parts.min_by(|a, b| a.0.total_cmp(&b.0))
        });
        let (part, axis, bound) = crossed.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let mut start = between(p, q, part);
        start[axis] = bound;
        let near = newton(self.fields, axis, start)?;
        let last = enclose(self.fields, axis, near, REACH * tube.halves[tube.axis])?;
        (tube.holds_point(&last) && self.is_inside(last.position)).then_some(last)
    }
}

/// A common zero outside of a window, on the same arc as one inside; `None` if the arc is not proved to leave the window.
pub(crate) fn leaves_window(
    fields: [&Field; 2],
    seed: &Enclosed,
    window: [[f64; 2]; 3],
) -> Option<Enclosed> {
    let longest = LONGEST * (window[0][1] - window[0][0]);
    let path = Path {
        fields,
        window,
        longest,
        shortest: longest * SMALL,
    };
    [1.0, -1.0]
        .iter()
        .find_map(|sense| match path.follow(seed, *sense, &[]).stop {
            Stop::Window(outside) => Some(outside),
            Stop::Closed | Stop::Unresolved | Stop::Known => None,
        })
}
