//! Parts of the surface near triangles: upper bounds of distances that hold for whole pieces.

use std::f64::consts::TAU;

use super::CellTree;
use super::expansion::{ANGLE, Expansion, dot, length};
use super::waves::ABOVE;
use crate::intervals::interval::UNIT;
use crate::shape::minus;

/// The pairs of corners of a triangle, with the corners themselves.
const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [1, 2], [2, 0]];

/// A part of the surface, near a triangle. All lengths are in units of the surface, and points are relative to its center.
#[derive(Clone, Copy, Debug)]
pub(in crate::inspect) struct FlatPart {
    /// A point of the part, up to `wrong`.
    pub(in crate::inspect) middle: [f64; 3],
    pub(in crate::inspect) wrong: f64,
    /// Points, and each point of the part is within `off` of their convex hull.
    pub(in crate::inspect) hull: [[f64; 3]; 6],
    pub(in crate::inspect) off: f64,
}

/// The distance from the surface of a triangle that is given by its corners.
#[derive(Clone, Copy, Debug)]
pub(in crate::inspect) struct TriangleDistance {
    /// Some point of the triangle is at least this far away.
    pub(in crate::inspect) low: f64,
    /// No point of the triangle is farther away.
    pub(in crate::inspect) high: f64,
}

impl CellTree {
    /// The unit, a power of two.
    pub(in crate::inspect) fn unit(&self) -> f64 {
        self.unit
    }

    /// A bound of |X'''|/6 in all directions of length |v₁| + |v₂| = 1 of the angles, everywhere in a chart.
    fn third_everywhere(&self, chart: usize) -> f64 {
        let s = self.charts[chart].waves.sizes();
        (s[3] + 3.0 * s[2] + 3.0 * s[1] + s[0]) / 6.0 * ABOVE
    }

    /// The part of the surface in the directions of a triangle, as seen from the center. `None` if these directions are far apart. Points are in
    /// units of the surface, relative to its center.
    ///
    /// **Lemma 9.** It holds what its fields promise.
    ///
    /// Proof. A point of the triangle is on a segment from a corner to a point of the opposite edge. The directions of a segment are an
    /// arc of a great circle, on which φ'' = θ'² sin φ cos φ and θ'' = −2θ'φ' cot φ with φ'² + θ'² sin² φ = 1. So |θ''| + |φ''| is at most
    /// k = (½ + √(¼ + 1/s²)) c/s for |cos φ| ≤ c and sin φ ≥ s, an arc of length ψ is within kψ²/8 of the chord in the plane of the angles, and
    /// all directions of the triangle are within b = kψ²/4 of the triangle of the angles u + v_i of its corners.
    ///
    /// Let r = b + max |v_i|, where |v| = |v₁| + |v₂|. At angles u + v + δ with v = Σλ_i v_i and |δ| ≤ b, Taylor's formula gives X(u) + X'v +
    /// ½X''(v, v), up to (|X'| + |X''| r) b + Mr³ with the largest lengths of slopes and bends at u and the bound M of |X'''|/6. That is
    /// Σλ_iλ_j h_ij with h_ij = X(u) + ½X'(v_i + v_j) + ½X''(v_i, v_j), so it is in the hull of these. The errors of the expansion are those of
    /// [`super::Errors::within`].
    pub(in crate::inspect) fn flat_part(&self, triangle: &[[f64; 3]; 3]) -> Option<FlatPart> {
        let middle = middle(triangle);
        let (chart_index, at) = self.angles(&middle);
        let chart = &self.charts[chart_index];
        let mut offsets = [[0.0; 2]; 3];
        for (offset, corner) in offsets.iter_mut().zip(triangle) {
            let angles = chart.angles(corner);
            let off = [0, 1].map(|i| angles[i] - at[i]);
            *offset = [off[0] - TAU * (off[0] / TAU).round(), off[1]];
        }
        // The angle between two directions is at most |v|.
        let reach = offsets
            .iter()
            .map(|v| v[0].abs() + v[1].abs())
            .fold(0.0, f64::max);
        if reach > 0.045 {
            return None;
        }
        // As the corners, all directions are within `reach` of the middle, where |cos φ| is at most √½ up to rounding: a cap is convex.
        let cos = at[1].cos().abs() + reach + 4.0 * ANGLE;
        let sin = (1.0 - cos * cos).sqrt();
        let curved = (0.5 + (0.25 + 1.0 / (sin * sin)).sqrt()) * cos / sin;
        let arcs = PAIRS
            .map(|[i, j]| (offsets[i][0] - offsets[j][0]).hypot(offsets[i][1] - offsets[j][1]));
        let arc = arcs.into_iter().fold(0.0, f64::max) + 4.0 * ANGLE;
        let bulge = (0.25 * curved * arc * arc + 4.0 * ANGLE) * ABOVE;
        let r = (reach + bulge) * ABOVE;
        let expansion = Expansion::new(&chart.waves, at, &[0.0; 3]);
        let (slope, bend) = expansion.sizes();
        let third = self.third_everywhere(chart_index);
        let rounding = 32.0 * UNIT * (length(&expansion.value) + r * (slope + r * bend));
        let hull = PAIRS.map(|[i, j]| {
            let [v, w] = [offsets[i], offsets[j]];
            let along = expansion.along([0, 1].map(|k| f64::midpoint(v[k], w[k])));
            let bent = expansion.bent(v, w);
            chart.in_space([0, 1, 2].map(|k| expansion.value[k] + along[k] + bent[k]))
        });
        let off = bulge * (slope + 2.0 * r * bend) + r * r * r * third;
        Some(FlatPart {
            middle: chart.in_space(expansion.value),
            wrong: (chart.errors.value + rounding) * ABOVE,
            hull,
            off: (off + chart.errors.within(r) + rounding) * ABOVE,
        })
    }

    /// Bounds of the largest distance of a triangle from the surface. Points are in units of the surface, relative to its center.
    ///
    /// **Lemma 10.** The upper bound holds.
    ///
    /// Proof. Let X, X' and X'' be the surface and its derivatives at any angles u, and q_i − X = X'v_i + ρ_i for the corners q_i. A point
    /// q = Σλ_i q_i of the triangle is at X + X'v + ρ with v = Σλ_i v_i and ρ = Σλ_i ρ_i. By Taylor's formula it is within |ρ − ½X''(v, v)| + Mr³
    /// of the point of the surface at u + v, with r = max |v_i| and M as in Lemma 9. And ρ − ½X''(v, v) = Σλ_iλ_j g_ij for
    /// g_ij = ½(ρ_i + ρ_j) − ½X''(v_i, v_j), so it is no longer than the longest of these. The bound is near the distance if u belongs to the
    /// point nearest to the middle, and q_i − X − X'v_i − ½X''(v_i, v_i) is nearly normal to X'. The distance is also at most that of the middle
    /// and the largest distance of a corner from the middle together.
    pub(in crate::inspect) fn triangle_distance(
        &self,
        corners: &[[f64; 3]; 3],
        relative: f64,
    ) -> TriangleDistance {
        let middle = middle(corners);
        let target = self.target(middle);
        let (search, least) = self.searched(&target, relative);
        let low = (least.max(0.0).sqrt() * (1.0 - 4.0 * UNIT)).min(search.high);
        let size = corners.iter().map(length).fold(0.0, f64::max);
        let rounding = 64.0 * UNIT * size;
        let off = corners.map(|corner| minus(corner, middle));
        let way = off.iter().map(length).fold(0.0, f64::max);
        let by_way = search.high + way + rounding;
        let by_plane = search.place.map_or(f64::INFINITY, |(chart, best)| {
            let found_in = &self.charts[chart];
            let corners = off.map(|off| {
                let way = minus(found_in.turned(&off), best.value);
                let first = nearest_along(&best.slopes, &way);
                let v = nearest_along(&best.slopes, &minus(way, best.bent(first, first)));
                (v, minus(way, best.along(v)))
            });
            let sizes = corners.map(|(v, _)| v[0].abs() + v[1].abs());
            let r = sizes.into_iter().fold(0.0, f64::max) * ABOVE;
            let heights = PAIRS.map(|[i, j]| {
                let [(v, a), (w, b)] = [corners[i], corners[j]];
                let bent = best.bent(v, w);
                length(&[0, 1, 2].map(|k| f64::midpoint(a[k], b[k]) - bent[k]))
            });
            let height = heights.into_iter().fold(0.0, f64::max);
            let (slope, bend) = best.sizes();
            let third = self.third_everywhere(chart);
            let rounding = rounding + 64.0 * UNIT * (length(&best.value) + r * (slope + r * bend));
            (height + r * r * r * third + found_in.errors.within(r) + rounding) * ABOVE
        });
        TriangleDistance {
            low: (low - rounding).max(0.0),
            high: by_way.min(by_plane),
        }
    }
}

impl Expansion {
    /// X'v
    fn along(&self, v: [f64; 2]) -> [f64; 3] {
        let [a, b] = &self.slopes;
        [0, 1, 2].map(|i| v[0] * a[i] + v[1] * b[i])
    }

    /// ½X''(v, w)
    fn bent(&self, v: [f64; 2], w: [f64; 2]) -> [f64; 3] {
        let [aa, ab, bb] = &self.bends;
        let mixed = v[0] * w[1] + v[1] * w[0];
        [0, 1, 2].map(|i| 0.5 * (v[0] * w[0] * aa[i] + mixed * ab[i] + v[1] * w[1] * bb[i]))
    }
}

/// The middle of a triangle.
fn middle([p, q, r]: &[[f64; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| (p[i] + q[i] + r[i]) / 3.0)
}

/// Coefficients v for which v₁a + v₂b is nearest to `w`, up to rounding; 0 if a and b are nearly parallel.
fn nearest_along([a, b]: &[[f64; 3]; 2], w: &[f64; 3]) -> [f64; 2] {
    let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
    let (wa, wb) = (dot(w, a), dot(w, b));
    let determinant = aa * bb - ab * ab;
    if determinant > 1e-12 * aa * bb {
        [
            (wa * bb - wb * ab) / determinant,
            (wb * aa - wa * ab) / determinant,
        ]
    } else {
        [0.0; 2]
    }
}

#[cfg(test)]
mod tests {
    use super::super::laws::surface;
    use super::*;
    use crate::shape::{HarmonicPair, cross};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]
        /// The parts hold the surface in the directions of triangles, and no point of a triangle is farther from the surface than the bound.
        #[test]
        fn parts_and_bounds_hold_for_triangles(
            list in prop::collection::vec((1usize..6, 0usize..12, -6i64..7), 0..5),
            place in prop::array::uniform3(-1.0f64..1.0),
            sides in prop::array::uniform3(prop::array::uniform3(-1.0f64..1.0)),
            size in -12i32..-3,
            weights in prop::collection::vec(prop::array::uniform3(0.01f64..1.0), 12),
            outwards in prop::array::uniform3(-1.0f64..1.0),
        ) {
            prop_assume!(length(&place) > 0.3);
            let surface = surface(2, &list);
            let Some(tree) = CellTree::new(&surface, &HarmonicPair::new(&surface)) else {
                return Ok(());
            };
            // About as far from the center as the surface is.
            let far = 2.0 / tree.unit() / length(&place);
            let scale = f64::from(size).exp2();
            let corners = sides.map(|side| [0, 1, 2].map(|i| far * place[i] + scale * side[i]));
            let points = weights.iter().map(|weights| {
                let all: f64 = weights.iter().sum();
                let part = |i: usize| (0..3).map(|k| weights[k] / all * corners[k][i]).sum();
                [0, 1, 2].map(part)
            });
            let bound = tree.triangle_distance(&corners, 0.005);
            prop_assert!(bound.low <= bound.high);
            let part = tree.flat_part(&corners);
            for q in points.chain(corners) {
                let point = q.map(|c| c * tree.unit());
                let nearest = tree.nearest(point, 0.0, 1e-3).unwrap();
                prop_assert!(nearest.distance.low / tree.unit() <= bound.high * (1.0 + 1e-12));
                let Some(part) = part else {
                    continue;
                };
                // Its support in a direction is at most that of the hull.
                let (chart, at) = tree.angles(&q);
                let expansion = Expansion::new(&tree.charts[chart].waves, at, &[0.0; 3]);
                let on = tree.charts[chart].in_space(expansion.value);
                let hull = part.hull.iter().map(|h| dot(h, &outwards));
                let support = hull.fold(f64::NEG_INFINITY, f64::max);
                let off = (part.off + 1e-12) * length(&outwards);
                prop_assert!(dot(&on, &outwards) <= support + off);
            }
        }
    }

    /// The bounds for a piece of a sphere are near the arrow of its arcs, ℓ²/6 in the middle.
    #[test]
    fn bounds_are_near_what_they_bound() {
        let sphere = surface(1, &[]);
        let tree = CellTree::new(&sphere, &HarmonicPair::new(&sphere)).unwrap();
        let side: f64 = 0.02;
        for middle in [[1.0, 0.0, 0.0], [0.6, 0.0, 0.8], [0.6, 0.48, 0.64]] {
            let across: [f64; 3] = [-middle[1], middle[0], 0.0];
            let across = across.map(|c| c / length(&across));
            let other = cross(middle, across);
            let corners = [0, 1, 2].map(|k| {
                let (sin, cos) = (TAU * f64::from(k) / 3.0).sin_cos();
                let r = side / 3f64.sqrt();
                let p = [0, 1, 2].map(|i| middle[i] + r * (cos * across[i] + sin * other[i]));
                p.map(|c: f64| c / length(&p) / tree.unit())
            });
            let arrow = side * side / 6.0 / tree.unit();
            let found = tree.triangle_distance(&corners, 0.005);
            assert!(
                found.low > 0.98 * arrow && found.high < 2.2 * arrow,
                "{found:?} {arrow}"
            );
            let part = tree.flat_part(&corners).unwrap();
            let height = |p: &[f64; 3]| dot(&minus(*p, corners[0]), &middle);
            let highest = part.hull.iter().map(height).fold(0.0, f64::max) + part.off;
            assert!(highest < 6.0 * arrow, "{highest} {arrow}");
        }
    }
}
