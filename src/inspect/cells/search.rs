//! The nearest point of the surface, by branch and bound over its cells.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use smallvec::SmallVec;

use super::super::DistanceBounds;
use super::super::tree::Search;
use super::{CellTree, Errors, Expansion, Place};
use crate::intervals::Interval;
use crate::intervals::interval::UNIT;

/// The largest number of cells and their parts that are searched for one point; then the bounds stay as wide as they are. Only points from
/// which large parts of the surface are equally far, such as the center of a sphere, take more than some tens.
const MOST_PIECES: usize = 4000;
/// Shorter parts are not divided.
const SHORTEST: f64 = 1e-8;
/// The largest number of steps downhill from the direction of the point.
const FIRST_STEPS: usize = 12;
/// A step downhill is the last one if it gains this part of the width that is asked for.
const NEAR: f64 = 0.1;
/// The largest number of steps of Newton's method on a part.
const STEPS: usize = 3;

/// The nearest point of a surface, found in doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::inspect) struct NearestOnSphere {
    /// Certified bounds of the distance.
    pub(in crate::inspect) distance: DistanceBounds,
    /// The point that was found, relative to the center, without certificate.
    pub(in crate::inspect) point: [f64; 3],
    /// Its chart and angles.
    pub(super) at: (usize, [f64; 2]),
}

/// A node of the tree of boxes, or a part of a cell, that remains to be searched.
#[derive(Clone, Copy)]
struct Piece {
    /// A lower bound of the squared distance.
    bound: f64,
    place: Place,
    /// The node that holds the piece: its level and its number.
    level: usize,
    code: usize,
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Piece {}

impl PartialOrd for Piece {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Piece {
    /// The piece with the least bound comes first out of a heap.
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound)
    }
}

/// What is known of the distance from one point. The place is the expansion at the nearest point so far, and its chart.
pub(super) type CellSearch = Search<Option<(usize, Expansion)>>;

/// A search that leaves out what is farther than this point by more than rounding errors, and no more.
pub(super) fn search_about(chart: usize, best: &Expansion, errors: &Errors) -> CellSearch {
    let [distance, error] = best.distance();
    let level = distance + 2.0 * (error + errors.value) + 16.0 * UNIT * distance;
    Search {
        low: f64::INFINITY,
        high: 0.0,
        place: Some((chart, *best)),
        enough: level * level,
        relative: 0.0,
        error: errors.value,
    }
}

impl CellSearch {
    /// Takes note of a point of the surface.
    fn reached(&mut self, chart: usize, expansion: &Expansion) {
        let [distance, error] = expansion.distance();
        self.found(distance, error, || Some((chart, *expansion)));
    }
}

/// A point in the coordinates of both charts, besides those of space.
pub(super) struct Target {
    pub(super) p: [f64; 3],
    turned: [[f64; 3]; 2],
}

impl CellTree {
    pub(super) fn target(&self, p: [f64; 3]) -> Target {
        Target {
            p,
            turned: self.charts.each_ref().map(|chart| chart.turned(&p)),
        }
    }

    pub(super) fn expansion(&self, chart: usize, at: [f64; 2], target: &Target) -> Expansion {
        Expansion::new(&self.charts[chart].waves, at, &target.turned[chart])
    }

    /// The nearest point of the surface to a point within `slack` of `near`. The bounds differ by at most about `relative` times the
    /// distance, if doubles can do that with the work that is allowed. `None` if the point is too far away.
    ///
    /// **Lemma 6.** The bounds hold.
    ///
    /// Proof. Every part of the surface is in a piece that was left out, whose bound is at least `low`, or in a piece that still waits.
    /// Bounds of boxes hold because the boxes hold their cells (Lemma 4), and bounds of pieces by Lemma 3 with the bound of the third
    /// derivatives of a node that holds the piece, or of all of its chart if the expansion is at a point outside.
    ///
    /// Laws: those of `harmonic_laws.rs`.
    pub(in crate::inspect) fn nearest(
        &self,
        near: [f64; 3],
        slack: f64,
        relative: f64,
    ) -> Option<NearestOnSphere> {
        let (p, slack) = self.inside(near, slack)?;
        let target = &self.target(p);
        let (search, low) = self.searched(target, relative);
        let slack = Interval::from(slack);
        let low = (Interval::from(low).sqrt() - slack).low().max(0.0);
        let high = (Interval::from(search.high) + slack).high();
        let distance = Interval::between(low.min(high), high) * self.unit;
        let (chart, best) = search.place?;
        let turned = [0, 1, 2].map(|i| (best.value[i] + target.turned[chart][i]) * self.unit);
        let point = self.charts[chart].in_space(turned);
        Some(NearestOnSphere {
            distance: DistanceBounds {
                low: distance.low().max(0.0),
                high: distance.high(),
            },
            point,
            at: (chart, best.at),
        })
    }

    /// What was found of the distance of a point in units of the surface and relative to its center, and a lower bound of its square.
    pub(super) fn searched(&self, target: &Target, relative: f64) -> (CellSearch, f64) {
        let mut search = Search {
            low: f64::INFINITY,
            high: f64::INFINITY,
            place: None,
            enough: f64::INFINITY,
            relative,
            error: self.charts[0].errors.value.max(self.charts[1].errors.value),
        };
        self.go_downhill(&mut search, target);
        let mut waiting = BinaryHeap::with_capacity(64);
        let squares = (0..6).map(|code| (Self::square(code), code));
        self.add(&mut search, &mut waiting, target, 0, 0.0, squares);
        let mut work = 0;
        while work < MOST_PIECES
            && let Some(piece) = waiting.pop()
        {
            if search.leaves_out(piece.bound) {
                continue;
            }
            let bound = self
                .bound_by_best(&search, &piece.place, piece.level, piece.code)
                .max(piece.bound);
            if search.leaves_out(bound) {
                continue;
            }
            if piece.level < self.divisions {
                let children = piece.place.parts().into_iter().enumerate();
                let children = children.map(|(i, place)| (place, 4 * piece.code + i));
                self.add(
                    &mut search,
                    &mut waiting,
                    target,
                    piece.level + 1,
                    bound,
                    children,
                );
                continue;
            }
            work += 1;
            let bound = self
                .piece(&mut search, &piece.place, piece.level, piece.code, target)
                .max(bound);
            if search.leaves_out(bound) {
                continue;
            }
            if piece.place.high[0] - piece.place.low[0] < SHORTEST {
                search.low = search.low.min(bound);
                continue;
            }
            let parts = piece.place.parts();
            waiting.extend(parts.map(|place| Piece {
                bound,
                place,
                ..piece
            }));
        }
        let low = waiting.iter().fold(search.low, |low, p| low.min(p.bound));
        (search, low)
    }

    /// Goes downhill from the direction of the point, for a first upper bound.
    fn go_downhill(&self, search: &mut CellSearch, target: &Target) {
        let (mut chart, mut at) = self.angles(&target.p);
        for _ in 0..FIRST_STEPS {
            let expansion = self.expansion(chart, at, target);
            let before = search.high;
            search.reached(chart, &expansion);
            let step = expansion.descent().map(|x| x.clamp(-0.3, 0.3));
            // What the step gains is within the width that is asked for.
            let [g, h] = expansion.gradient();
            let gain = (g * step[0] + h * step[1]).abs();
            let is_near = gain <= NEAR * search.relative * search.high * search.high;
            let is_last = search.high >= before || is_near;
            if is_last {
                break;
            }
            at = [0, 1].map(|i| at[i] + step[i]);
            // In the other chart, if the direction is too far from the equator of this one.
            if (at[1] - std::f64::consts::FRAC_PI_2).abs() > 1.0 {
                let ([st, ct], [sp, cp]) = (sine_and_cosine(at[0]), sine_and_cosine(at[1]));
                let direction = self.charts[chart].in_space([sp * ct, sp * st, cp]);
                (chart, at) = self.angles(&direction);
            }
        }
    }

    /// Adds pieces that are not left out.
    fn add(
        &self,
        search: &mut CellSearch,
        waiting: &mut BinaryHeap<Piece>,
        target: &Target,
        level: usize,
        least: f64,
        places: impl Iterator<Item = (Place, usize)>,
    ) {
        for (place, code) in places {
            let bound = self
                .node(level, code)
                .extent
                .least_square(&target.p)
                .max(least);
            if !search.leaves_out(bound) {
                waiting.push(Piece {
                    bound,
                    place,
                    level,
                    code,
                });
            }
        }
    }

    /// A lower bound of the squared distance of a piece, by the expansion at the nearest point that was found.
    pub(super) fn bound_by_best(
        &self,
        search: &CellSearch,
        place: &Place,
        level: usize,
        code: usize,
    ) -> f64 {
        let Some((chart, best)) = &search.place else {
            return 0.0;
        };
        if *chart != place.chart {
            return 0.0;
        }
        // θ up to full turns.
        let middle = place.middle();
        let turns = ((middle[0] - best.at[0]) / std::f64::consts::TAU).round();
        let mut here = *best;
        here.at[0] += turns * std::f64::consts::TAU;
        // The bound of the third derivatives of something that holds the piece and the expansion.
        let square_code = code >> (2 * level);
        let square = Self::square(square_code);
        let third = if place.holds(&here.at) {
            self.node(level, code).third
        } else if square.holds(&here.at) {
            self.node(0, square_code).third
        } else if *chart == 0 && square.low[1] <= here.at[1] && here.at[1] <= square.high[1] {
            self.third_of_band
        } else {
            return 0.0;
        };
        let least = here.least_distance(place.low, place.high, third, &self.charts[*chart].errors);
        least.max(0.0) * least
    }

    /// A lower bound of the squared distance of a part of a cell. Newton's method, or a step downhill, looks for the nearest point of the part, until the bound
    /// is large enough.
    pub(super) fn piece(
        &self,
        search: &mut CellSearch,
        place: &Place,
        level: usize,
        code: usize,
        target: &Target,
    ) -> f64 {
        let Place { chart, low, high } = *place;
        let third = self.node(level, code).third;
        let mut at = place.middle();
        let mut bound = 0.0f64;
        for _ in 0..=STEPS {
            let expansion = self.expansion(chart, at, target);
            search.reached(chart, &expansion);
            let least = expansion.least_distance(low, high, third, &self.charts[chart].errors);
            bound = bound.max(least.max(0.0) * least);
            if bound >= search.enough {
                break;
            }
            let step = expansion.descent();
            let next = [0, 1].map(|i| (at[i] + step[i]).clamp(low[i], high[i]));
            let moved = (0..2).map(|i| (next[i] - at[i]).abs());
            if moved.fold(0.0, f64::max) < 1e-3 * (high[0] - low[0]) {
                break;
            }
            at = next;
        }
        bound
    }

    /// Whether some point of the surface is at least as far from a point as the tolerance; `None` if the boxes and the middles of the cells
    /// do not show that. The point is within `slack` of `near`.
    pub(in crate::inspect) fn goes_beyond(
        &self,
        near: [f64; 3],
        slack: f64,
        tolerance: Interval,
    ) -> Option<bool> {
        let (p, slack) = self.inside(near, slack)?;
        let target = &self.target(p);
        let level = tolerance * (1.0 / self.unit);
        let slack = Interval::from(slack);
        let least = (level - slack).or_zero().squared().low();
        let greatest = (level + slack).high();
        let mut is_open = false;
        let mut waiting: SmallVec<[(Place, usize, usize); 64]> = SmallVec::new();
        let far = |level: usize, code: usize| self.node(level, code).extent.greatest_square(&p);
        let mut squares = [0, 1, 2, 3, 4, 5];
        squares.sort_unstable_by(|a, b| far(0, *a).total_cmp(&far(0, *b)));
        waiting.extend(squares.map(|code| (Self::square(code), 0, code)));
        while let Some((place, depth, code)) = waiting.pop() {
            if far(depth, code) < least {
                continue;
            }
            if depth < self.divisions {
                let children = place.parts().into_iter().enumerate();
                let mut children: SmallVec<[(Place, usize, usize); 4]> = children
                    .map(|(i, place)| (place, depth + 1, 4 * code + i))
                    .collect();
                children.sort_unstable_by(|a, b| far(a.1, a.2).total_cmp(&far(b.1, b.2)));
                waiting.extend(children);
                continue;
            }
            let expansion = self.expansion(place.chart, place.middle(), target);
            let [distance, error] = expansion.distance();
            if distance - error - self.charts[place.chart].errors.value > greatest {
                return Some(true);
            }
            is_open = true;
        }
        (!is_open).then_some(false)
    }
}

fn sine_and_cosine(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [sin, cos]
}
