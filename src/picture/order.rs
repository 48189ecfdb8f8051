//! The order of pieces from the farthest to the nearest, by a binary space partition, so that near pieces hide far ones.

use crate::error::Invariant;

/// Up to this number of pieces the planes of the facets divide the pieces; more pieces are first divided by planes across an
/// axis.
const LEAF: usize = 100;
/// Cuts make no more pieces than so many for each of the first ones, and so many besides.
const MOST_CUTS: usize = 4;
const MORE_CUTS: usize = 100_000;
/// Points that are nearer to a plane than this part of the scene's size are on the plane.
const ON_PLANE: f64 = 1e-9;

/// A facet (three or more corners, nearly in a plane), a segment (two corners) or a point, with the index of its item.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) corners: Vec<[f64; 3]>,
    /// For every corner, whether the edge to the next corner is an edge of the whole facet and not a cut.
    pub(super) edges: Vec<bool>,
    pub(super) item: usize,
}

/// The plane n·x = offset, with a unit vector n.
struct Plane {
    normal: [f64; 3],
    offset: f64,
}

/// The pieces from the farthest to the nearest, as seen from `eye`: no piece hides a later one. Facets and segments that cross
/// a plane of the partition are cut there, so surfaces that intersect each other are drawn rightly. Of many facets that all cross each
/// other, those in one place are ordered by distance when there are too many cuts.
///
/// Cost: about n log n for n pieces of usual scenes, with some tenths more pieces at the end.
pub(super) fn from_behind(pieces: Vec<Piece>, eye: [f64; 3]) -> Vec<Piece> {
    let mut largest = 0.0_f64;
    for value in pieces.iter().flat_map(|p| &p.corners).flatten().chain(&eye) {
        largest = largest.max(value.abs());
    }
    let mut order = Order {
        eye,
        near: ON_PLANE * largest,
        room: pieces.len() * MOST_CUTS + MORE_CUTS,
        ordered: Vec::with_capacity(pieces.len() * 3 / 2),
    };
    order.add(pieces);
    order.ordered
}

/// The pieces that have been ordered.
struct Order {
    eye: [f64; 3],
    near: f64,
    /// The number of pieces that cuts may still make.
    room: usize,
    ordered: Vec<Piece>,
}

impl Order {
    fn add(&mut self, pieces: Vec<Piece>) {
        if self.room == 0 {
            return self.add_by_distance(pieces);
        }
        if pieces.len() > LEAF
            && let Some(plane) = across(&pieces)
            && let Ok(parts) = divided(&pieces, &plane, self.near)
            && parts[0].len().max(parts[2].len()) * 10 < pieces.len() * 9
        {
            return self.add_parts(pieces.len(), &plane, parts);
        }
        let facets = pieces.iter().filter(|p| p.corners.len() > 2);
        let count = facets.clone().count();
        // A facet from the middle of the list is the first candidate, because neighbors in the list are neighbors on a surface.
        let planes = facets.skip(count / 2).chain(pieces.iter());
        let plane = planes
            .filter(|p| p.corners.len() > 2)
            .find_map(Piece::plane);
        let parts = plane.and_then(|plane| {
            let parts = divided(&pieces, &plane, self.near).ok()?;
            let [behind, on, before] = parts.each_ref().map(Vec::len);
            // Else the plane does not contain its own facet.
            let is_divided = on > 0 || behind.max(before) < pieces.len();
            is_divided.then_some((plane, parts))
        });
        match parts {
            Some((plane, parts)) => self.add_parts(pieces.len(), &plane, parts),
            None => self.add_by_distance(pieces),
        }
    }

    /// Adds the pieces behind, on and in front of a plane, which are the parts of `count` pieces.
    fn add_parts(&mut self, count: usize, plane: &Plane, [behind, on, before]: [Vec<Piece>; 3]) {
        let made = (behind.len() + on.len() + before.len()).saturating_sub(count);
        self.room = self.room.saturating_sub(made);
        let (far, close) = sides(plane, self.eye, behind, before);
        self.add(far);
        self.ordered.extend(lines_over_facets(on));
        self.add(close);
    }

    fn add_by_distance(&mut self, mut pieces: Vec<Piece>) {
        let distance = |piece: &Piece| -> f64 {
            let middle = piece.middle();
            (0..3).map(|k| (middle[k] - self.eye[k]).powi(2)).sum()
        };
        pieces.sort_by(|a, b| distance(b).total_cmp(&distance(a)));
        self.ordered.extend(pieces);
    }
}

/// The pieces in one plane, with facets before lines and points, because facets in a plane can only hide these.
fn lines_over_facets(mut on: Vec<Piece>) -> Vec<Piece> {
    on.sort_by_key(|piece| std::cmp::Reverse(piece.corners.len().min(3)));
    on
}

/// The side of the plane without the eye, then the other side.
fn sides(
    plane: &Plane,
    eye: [f64; 3],
    behind: Vec<Piece>,
    before: Vec<Piece>,
) -> (Vec<Piece>, Vec<Piece>) {
    if plane.height(eye) > 0.0 {
        (behind, before)
    } else {
        (before, behind)
    }
}

/// A plane across the axis along which the pieces extend most, through the median of their middles.
fn across(pieces: &[Piece]) -> Option<Plane> {
    let middles: Vec<[f64; 3]> = pieces.iter().map(Piece::middle).collect();
    let spread = |k: usize| {
        let values = || middles.iter().map(|m| m[k]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    let axis = (0..3).max_by(|&a, &b| spread(a).total_cmp(&spread(b)))?;
    let mut values: Vec<f64> = middles.iter().map(|m| m[axis]).collect();
    let middle = values.len() / 2;
    let (_, median, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    let mut normal = [0.0; 3];
    normal[axis] = 1.0;
    Some(Plane {
        normal,
        offset: *median,
    })
}

/// The pieces behind, on and in front of a plane. Pieces that cross it are cut. An error if a coordinate is not finite.
fn divided(pieces: &[Piece], plane: &Plane, near: f64) -> Result<[Vec<Piece>; 3], ()> {
    let mut parts: [Vec<Piece>; 3] = Default::default();
    for piece in pieces {
        let heights: Vec<f64> = piece.corners.iter().map(|p| plane.height(*p)).collect();
        if heights.iter().any(|h| !h.is_finite()) {
            return Err(());
        }
        let below = heights.iter().any(|h| *h < -near);
        let above = heights.iter().any(|h| *h > near);
        match (below, above) {
            (true, true) => {
                for (part, sign) in [(0, -1.0), (2, 1.0)] {
                    parts[part].extend(piece.cut(&heights, sign));
                }
            }
            (true, false) => parts[0].push(piece.clone()),
            (false, true) => parts[2].push(piece.clone()),
            (false, false) => parts[1].push(piece.clone()),
        }
    }
    Ok(parts)
}

impl Plane {
    fn height(&self, p: [f64; 3]) -> f64 {
        let products = self.normal.iter().zip(p).map(|(n, x)| n * x);
        products.sum::<f64>() - self.offset
    }
}

impl Piece {
    fn middle(&self) -> [f64; 3] {
        let count =
            f64::from(u32::try_from(self.corners.len()).invariant("a facet has few corners"));
        [0, 1, 2].map(|k| self.corners.iter().map(|p| p[k]).sum::<f64>() / count)
    }

    /// The plane of a facet by Newell's rule; `None` if the facet has no area.
    fn plane(&self) -> Option<Plane> {
        let n = self.corners.len();
        let normal = [0, 1, 2].map(|i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let terms = (0..n).map(|a| {
                let (p, q) = (self.corners[a], self.corners[(a + 1) % n]);
                (p[j] - q[j]) * (p[k] + q[k])
            });
            terms.sum::<f64>()
        });
        let length = normal.iter().map(|v| v * v).sum::<f64>().sqrt();
        let normal = normal.map(|v| v / length);
        let through = self.middle();
        let offset = normal.iter().zip(through).map(|(n, x)| n * x).sum();
        (length > 0.0 && normal.iter().all(|v| v.is_finite())).then_some(Plane { normal, offset })
    }

    /// A piece that has not been cut.
    pub(super) fn whole(corners: Vec<[f64; 3]>, item: usize) -> Self {
        Self {
            edges: vec![true; corners.len()],
            corners,
            item,
        }
    }

    /// The part of the piece on the side of a plane with the given sign.
    fn cut(&self, heights: &[f64], sign: f64) -> Option<Self> {
        let n = self.corners.len();
        let (mut corners, mut edges) = (Vec::with_capacity(n + 1), Vec::with_capacity(n + 1));
        let steps = if n > 2 { n } else { n - 1 };
        for a in 0..n {
            let b = (a + 1) % n;
            let (p, q) = (self.corners[a], self.corners[b]);
            let (g, h) = (sign * heights[a], sign * heights[b]);
            if g >= 0.0 {
                corners.push(p);
                edges.push(self.edges[a] && (g > 0.0 || h >= 0.0));
            }
            if a < steps && g * h < 0.0 {
                let t = g / (g - h);
                corners.push([0, 1, 2].map(|k| p[k] + t * (q[k] - p[k])));
                // The next edge is the cut, or the rest of an edge.
                edges.push(self.edges[a] && h > 0.0);
            }
        }
        let least = n.min(3);
        (corners.len() >= least).then_some(Self {
            corners,
            edges,
            item: self.item,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn piece(corners: &[[f64; 3]], item: usize) -> Piece {
        Piece::whole(corners.to_vec(), item)
    }

    fn area(piece: &Piece) -> f64 {
        let [o, rest @ ..] = &piece.corners[..] else {
            return 0.0;
        };
        let minus = |a: &[f64; 3]| nalgebra::Vector3::from(*a) - nalgebra::Vector3::from(*o);
        let parts = rest
            .windows(2)
            .map(|w| minus(&w[0]).cross(&minus(&w[1])).norm());
        parts.sum::<f64>() / 2.0
    }

    #[test]
    fn cuts_are_bounded() {
        // Each of 300 squares through one point would be cut by all others.
        let squares = (0..300).map(|k| {
            let turn = |angle: f64| {
                nalgebra::Rotation3::from_euler_angles(angle, 1.7 * angle, 0.3 * angle)
            };
            let corners = [
                [-1.0, -1.0, 0.0],
                [1.0, -1.0, 0.0],
                [1.0, 1.0, 0.0],
                [-1.0, 1.0, 0.0],
            ];
            let turned = corners.map(|c| (turn(f64::from(k)) * nalgebra::Vector3::from(c)).into());
            piece(&turned, usize::try_from(k).unwrap())
        });
        let squares: Vec<Piece> = squares.collect();
        let before: f64 = squares.iter().map(area).sum();
        let ordered = from_behind(squares, [3.0, 4.0, 5.0]);
        assert!(
            (5_000..2 * (300 * MOST_CUTS + MORE_CUTS)).contains(&ordered.len()),
            "{}",
            ordered.len()
        );
        let after: f64 = ordered.iter().map(area).sum();
        assert!((before - after).abs() < 1e-6 * before);
    }

    #[test]
    fn crossing_squares_are_cut() {
        let a = piece(
            &[
                [-1.0, -1.0, 0.0],
                [1.0, -1.0, 0.0],
                [1.0, 1.0, 0.0],
                [-1.0, 1.0, 0.0],
            ],
            0,
        );
        let b = piece(
            &[
                [-1.0, 0.0, -1.0],
                [1.0, 0.0, -1.0],
                [1.0, 0.0, 1.0],
                [-1.0, 0.0, 1.0],
            ],
            1,
        );
        let ordered = from_behind(vec![a, b], [0.0, 5.0, 5.0]);
        assert_eq!(ordered.len(), 3);
        // A cut is not an edge.
        let edges = |p: &Piece| p.edges.iter().filter(|e| **e).count();
        assert_eq!(ordered.iter().map(edges).collect::<Vec<_>>(), [3, 4, 3]);
        // The order is: half of one facet, the other facet, the other half.
        assert_eq!(ordered[0].item, ordered[2].item);
        assert_ne!(ordered[0].item, ordered[1].item);
    }

    #[test]
    fn facets_in_one_plane_are_kept() {
        let square = |x: f64, item| {
            piece(
                &[
                    [x, 0.0, 0.0],
                    [x + 1.0, 0.0, 0.0],
                    [x + 1.0, 1.0, 0.0],
                    [x, 1.0, 0.0],
                ],
                item,
            )
        };
        let mut pieces: Vec<Piece> = (0..4000).map(|n| square(f64::from(n) * 0.01, 0)).collect();
        pieces.push(piece(&[[0.0, 0.5, -1.0], [0.0, 0.5, 1.0]], 1));
        let ordered = from_behind(pieces, [3.0, 4.0, 5.0]);
        let total: f64 = ordered.iter().map(area).sum();
        assert!((total - 4000.0).abs() < 1e-6);
        assert_eq!(ordered.iter().filter(|p| p.item == 1).count(), 2);
    }

    proptest! {
        /// Cutting loses nothing, and along every line of sight the nearer piece comes later.
        #[test]
        fn nearer_is_later(corners in prop::collection::vec(prop::array::uniform9(-1.0f64..1.0), 1..60), at in prop::array::uniform2(-0.8f64..0.8)) {
            let pieces: Vec<Piece> = corners.iter().enumerate().map(|(item, c)| {
                piece(&[[c[0], c[1], c[2]], [c[3], c[4], c[5]], [c[6], c[7], c[8]]], item)
            }).collect();
            let before: f64 = pieces.iter().map(area).sum();
            let eye = [0.0, 0.0, 9.0];
            let ordered = from_behind(pieces, eye);
            let after: f64 = ordered.iter().map(area).sum();
            prop_assert!((before - after).abs() < 1e-6 * (1.0 + before));
            // The points at which the line from the eye through (x, y, 0) meets each piece.
            let mut last = f64::INFINITY;
            for piece in &ordered {
                let Some(plane) = piece.plane() else { continue };
                let along = [at[0], at[1], -9.0];
                let slope: f64 = plane.normal.iter().zip(along).map(|(n, d)| n * d).sum();
                let t = -plane.height(eye) / slope;
                if !t.is_finite() {
                    continue;
                }
                let hit = [0, 1, 2].map(|k| eye[k] + t * along[k]);
                let n = piece.corners.len();
                let inside = (0..n).all(|a| {
                    let (p, q) = (piece.corners[a], piece.corners[(a + 1) % n]);
                    let edge = nalgebra::Vector3::from(q) - nalgebra::Vector3::from(p);
                    let to = nalgebra::Vector3::from(hit) - nalgebra::Vector3::from(p);
                    edge.cross(&to).dot(&nalgebra::Vector3::from(plane.normal)) * 1.0 > 1e-6
                });
                // Newell's normal may have either sign here, so both are tried.
                let outside = (0..n).all(|a| {
                    let (p, q) = (piece.corners[a], piece.corners[(a + 1) % n]);
                    let edge = nalgebra::Vector3::from(q) - nalgebra::Vector3::from(p);
                    let to = nalgebra::Vector3::from(hit) - nalgebra::Vector3::from(p);
                    edge.cross(&to).dot(&nalgebra::Vector3::from(plane.normal)) < -1e-6
                });
                if inside || outside {
                    prop_assert!(t <= last + 1e-6, "{t} after {last}");
                    last = t;
                }
            }
        }
    }
}
