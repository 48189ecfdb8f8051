//! The nearest point of a curve, by branch and bound over its arcs.

use smallvec::SmallVec;

use super::super::DistanceBounds;
use super::super::tree::Search;
use super::ArcTree;
use crate::intervals::Interval;

/// The largest number of pieces of arcs that are searched for one point; then the bounds stay as wide as they are. Only points
/// from which large parts of the curve are equally far, such as the center of a circle, take more than some tens.
const MOST_PIECES: usize = 4000;
/// Shorter pieces are not divided.
const SHORTEST: f64 = 1e-9;
/// The largest number of steps of Newton's method on a piece.
const NEWTON_STEPS: usize = 6;

/// The nearest point of a closed curve, found in doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct NearestPoint<const N: usize> {
    /// Certified bounds of the distance.
    pub distance: DistanceBounds,
    /// The parameter of the point that was found, in [0, 2π]; without certificate.
    pub at: f64,
    /// The point of the curve with this parameter, within some units in the last place of the curve's size.
    pub point: [f64; N],
}

/// A node of the tree of boxes, or a piece of an arc, that remains to be searched.
#[derive(Clone, Copy)]
struct Piece {
    /// A lower bound of the squared distance.
    bound: f64,
    node: usize,
    /// The range of u on an arc.
    ends: [f64; 2],
}

impl<const N: usize> ArcTree<N> {
    /// The nearest point of the curve to a point within `slack` of `near`. The bounds differ by at most about `relative` times
    /// the distance, if doubles can do that with the work that is allowed. `None` if the point is too far away.
    ///
    /// **Lemma 5.** The bounds hold.
    ///
    /// Proof. Every part of the curve is in a piece that was left out, whose bound is at least `low`, or in a piece that still
    /// waits. Bounds of boxes hold because the boxes hold their arcs, and bounds of pieces by Lemmas 3 and 4. The difference
    /// and the square of such a bound are rounded by less than the spare factor of 1 − 4·2^(−53) in
    /// [`super::polynomials::Expansion::least_distance`].
    ///
    /// Laws: those of `curve_laws.rs`, and `bounds_hold_the_distance_of_a_polyline`.
    pub(in crate::inspect) fn nearest(
        &self,
        near: [f64; N],
        slack: f64,
        relative: f64,
    ) -> Option<NearestPoint<N>> {
        let p = &self.inside(near)?;
        let mut search = Search {
            low: f64::INFINITY,
            high: f64::INFINITY,
            place: (0, 0.0),
            enough: f64::INFINITY,
            relative,
            error: self.arcs.error(),
        };
        let mut waiting: SmallVec<[Piece; 32]> = SmallVec::new();
        let all = [-1.0, 1.0];
        waiting.push(Piece {
            bound: 0.0,
            node: 1,
            ends: all,
        });
        let mut work = 0;
        while work < MOST_PIECES
            && let Some(piece) = waiting.pop()
        {
            let Some(piece) = self.nearest_arc(&mut search, piece, &mut waiting, p) else {
                continue;
            };
            work += 1;
            let bound = self.piece(&mut search, &piece, p).max(piece.bound);
            if search.leaves_out(bound) {
                continue;
            }
            let [low, high] = piece.ends;
            if high - low < SHORTEST {
                search.low = search.low.min(bound);
                continue;
            }
            let middle = f64::midpoint(low, high);
            for ends in [[low, middle], [middle, high]] {
                waiting.push(Piece {
                    bound,
                    node: piece.node,
                    ends,
                });
            }
        }
        let slack = Interval::from(slack) * (1.0 / self.unit);
        let low = waiting.iter().fold(search.low, |low, p| low.min(p.bound));
        let low = (Interval::from(low).sqrt() - slack).low().max(0.0);
        let high = (Interval::from(search.high) + slack).high();
        let (arc, u) = search.place;
        let distance = Interval::between(low.min(high), high) * self.unit;
        Some(NearestPoint {
            distance: DistanceBounds {
                low: distance.low().max(0.0),
                high: distance.high(),
            },
            at: self.arcs.parameter(arc, u),
            point: self.arcs.point(arc, u).map(|x| x * self.unit),
        })
    }

    /// The nearest arc under a node, by the boxes; the others wait. `None` if all are left out.
    fn nearest_arc(
        &self,
        search: &mut Search<(usize, f64)>,
        mut piece: Piece,
        waiting: &mut SmallVec<[Piece; 32]>,
        p: &[f64; N],
    ) -> Option<Piece> {
        while !search.leaves_out(piece.bound) {
            if piece.node >= self.arcs.len() {
                return Some(piece);
            }
            let child = |node: usize| Piece {
                bound: self.boxes[node].least_square(p),
                node,
                ends: piece.ends,
            };
            let (mut near, mut far) = (child(2 * piece.node), child(2 * piece.node + 1));
            if far.bound < near.bound {
                std::mem::swap(&mut near, &mut far);
            }
            if !search.leaves_out(far.bound) {
                waiting.push(far);
            }
            piece = near;
        }
        None
    }

    /// A lower bound of the squared distance from a piece of an arc. Newton's method looks for the nearest point of the piece,
    /// until the bound is large enough.
    fn piece(&self, search: &mut Search<(usize, f64)>, piece: &Piece, p: &[f64; N]) -> f64 {
        let arc = piece.node - self.arcs.len();
        let third = self.arcs.third(arc);
        let [low, high] = piece.ends;
        let middle = f64::midpoint(low, high);
        let mut expansion = if middle.abs() > 0.0 {
            self.arcs.at(arc, middle, p)
        } else {
            self.arcs.at_middle(arc, p)
        };
        let mut bound = 0.0f64;
        for _ in 0..=NEWTON_STEPS {
            let [distance, error] = expansion.distance();
            search.found(distance, error, || (arc, expansion.at));
            let least = expansion.least_distance(piece.ends, third) - self.arcs.error();
            bound = bound.max(least.max(0.0) * least);
            if bound >= search.enough {
                break;
            }
            let Some(step) = expansion.newton_step() else {
                break;
            };
            let next = (expansion.at + step).clamp(low, high);
            if (next - expansion.at).abs() < SHORTEST {
                break;
            }
            expansion = self.arcs.at(arc, next, p);
        }
        bound
    }

    /// Whether some point of the curve is at least as far from a point as the tolerance; `None` if the boxes and the middles of
    /// the arcs do not show that. The point is within `slack` of `near`.
    pub(in crate::inspect) fn goes_beyond(
        &self,
        near: [f64; N],
        slack: f64,
        tolerance: Interval,
    ) -> Option<bool> {
        let p = &self.inside(near)?;
        let back = 1.0 / self.unit;
        let level = tolerance * back;
        let slack = Interval::from(slack) * back;
        let least = (level - slack).or_zero().squared().low();
        let greatest = (level + slack).high();
        let mut is_open = false;
        let mut waiting: SmallVec<[usize; 24]> = SmallVec::from_slice(&[1]);
        while let Some(node) = waiting.pop() {
            if self.boxes[node].greatest_square(p) < least {
                continue;
            }
            let Some(arc) = node.checked_sub(self.arcs.len()) else {
                let mut parts = [2 * node, 2 * node + 1];
                let [first, second] = parts.map(|node| self.boxes[node].greatest_square(p));
                if first > second {
                    parts.swap(0, 1);
                }
                waiting.extend(parts);
                continue;
            };
            let [distance, error] = self.arcs.at_middle(arc, p).distance();
            if distance - error - self.arcs.error() > greatest {
                return Some(true);
            }
            is_open = true;
        }
        (!is_open).then_some(false)
    }
}
