//! Parts of the surface between flat pieces: upper bounds of distances that hold for whole pieces.

use std::f64::consts::TAU;

use super::CellTree;
use super::expansion::{ANGLE, Expansion, dot, length};
use super::waves::ABOVE;
use crate::intervals::interval::UNIT;
use crate::shape::minus;

/// A part of the surface, near a triangle. All lengths are in units of the surface, and points are relative to its center.
#[derive(Clone, Copy, Debug)]
pub(in crate::inspect) struct FlatPart {
    /// A point of the part, up to `wrong`.
    pub(in crate::inspect) middle: [f64; 3],
    pub(in crate::inspect) wrong: f64,
    /// The corners of a triangle.
    pub(in crate::inspect) corners: [[f64; 3]; 3],
    /// Each point of the part is within this of a point of the triangle.
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

    /// A flat part of the surface near the points in the directions of a triangle, as seen from the center. `None` if these directions are far
    /// apart. Points are in units of the surface, relative to its center.
    ///
    /// **Lemma 9.** It holds what its fields promise.
    ///
    /// Proof. A point of the triangle is on a segment from a corner to a point of the opposite edge. The directions of a segment are an
    /// arc of a great circle, on which φ'' = θ'² sin φ cos φ and θ'' = −2θ'φ' cot φ, where |φ'| and |θ'| sin φ are at most 1. If
    /// |cos φ| ≤ 0.8, then |θ''| + |φ''| < 6, so an arc of length ψ is within ¾ψ² of the chord in the plane of the angles, and all
    /// directions of the triangle are within 1½ψ² of the triangle of the angles v_i of its corners.
    ///
    /// At the angles u + v with |v₁| + |v₂| ≤ r the surface is within ½|X''|r² + Mr³ of X(u) + X'(u)v by Taylor's formula, with the largest
    /// length |X''| of a bend at u and the bound M of |X'''|/6. The errors of the expansion are those of [`super::Errors::within`].
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
        // The angle between two directions is at most |v₁| + |v₂|.
        let reach = offsets
            .iter()
            .map(|v| v[0].abs() + v[1].abs())
            .fold(0.0, f64::max);
        let apart = 2.0 * reach + 4.0 * ANGLE;
        // |cos φ| ≤ √½ in the middle, up to rounding, so it is at most 0.8 in all these directions.
        if apart > 0.09 {
            return None;
        }
        let bulge = (1.5 * apart * apart + 4.0 * ANGLE) * ABOVE;
        let r = (reach + bulge) * ABOVE;
        let expansion = Expansion::new(&chart.waves, at, &[0.0; 3]);
        let (slope, bend) = expansion.sizes();
        let third = self.third_everywhere(chart_index);
        let rounding = 32.0 * UNIT * (length(&expansion.value) + slope * r);
        let [a, b] = expansion.slopes;
        let corners = offsets.map(|[s, t]| {
            chart.in_space([0, 1, 2].map(|i| expansion.value[i] + s * a[i] + t * b[i]))
        });
        let off = slope * bulge + r * r * (bend + third * r);
        Some(FlatPart {
            middle: chart.in_space(expansion.value),
            wrong: (chart.errors.value + rounding) * ABOVE,
            corners,
            off: (off + chart.errors.within(r) + rounding) * ABOVE,
        })
    }

    /// Bounds of the largest distance of a triangle from the surface. Points are in units of the surface, relative to its center.
    ///
    /// **Lemma 10.** The upper bound holds.
    ///
    /// Proof. Let X, X' be the surface and its slopes at any angles u, and q_i − X = X'v_i + ρ_i for the corners q_i. A point q = Σλ_i q_i of
    /// the triangle has q − X = X'v + ρ with v = Σλ_i v_i and ρ = Σλ_i ρ_i, so it is no farther from the point of the surface at u + v than
    /// max |ρ_i| + ½|X''|r² + Mr³ with r = max |v_i|, as in Lemma 9. The bound is near the distance if u belongs to the point nearest to the
    /// middle, and v_i makes ρ_i normal. It is also at most the distance of the middle and the largest distance of a corner from the
    /// middle together.
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
            let (mut reach, mut height) = (0.0f64, 0.0f64);
            for off in &off {
                let w = minus(found_in.turned(off), best.value);
                let (v, rest) = along(&best.slopes, &w);
                reach = reach.max(v[0].abs() + v[1].abs());
                height = height.max(length(&rest));
            }
            let r = reach * ABOVE;
            let (slope, bend) = best.sizes();
            let third = self.third_everywhere(chart);
            let rounding = rounding + 32.0 * UNIT * (slope * r + length(&best.value));
            (height + r * r * (bend + third * r) + found_in.errors.within(r) + rounding) * ABOVE
        });
        TriangleDistance {
            low: (low - rounding).max(0.0),
            high: by_way.min(by_plane),
        }
    }
}

/// The middle of a triangle.
fn middle([p, q, r]: &[[f64; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| (p[i] + q[i] + r[i]) / 3.0)
}

/// Coefficients v for which `w` is near v₁a + v₂b, and what remains of it.
fn along([a, b]: &[[f64; 3]; 2], w: &[f64; 3]) -> ([f64; 2], [f64; 3]) {
    let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
    let (wa, wb) = (dot(w, a), dot(w, b));
    let determinant = aa * bb - ab * ab;
    let v = if determinant > 1e-12 * aa * bb {
        [
            (wa * bb - wb * ab) / determinant,
            (wb * aa - wa * ab) / determinant,
        ]
    } else {
        [0.0; 2]
    };
    let rest = [0, 1, 2].map(|i| w[i] - v[0] * a[i] - v[1] * b[i]);
    (v, rest)
}
