//! A quarter of the curve ξ^n + η^n = 1, in pieces of which each is inside of a thin rectangle.

use std::cmp::Ordering;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::intervals::{Interval, Power};

/// Pieces that begin on an axis are divided at this part of their end.
const FIRST_PART: f64 = 0.25;

/// The arc ξ^n + η^n = 1 with ξ, η ≥ 0, n > 0.
///
/// The point in the direction (1, t), 0 ≤ t ≤ 1, is (1, t)/(1 + t^n)^(1/n); the other half of the arc has the directions (t, 1). The
/// parameter of the half is t for n ≥ 1, and t^n for n < 1, where most of the arc may have values of t that are too small for doubles.
#[derive(Debug)]
pub(super) struct UnitArc {
    /// n compared with 1: the arc bends outward for n > 1, and inward for n < 1.
    pub(super) bend: Ordering,
    exponent: Power,
    root: Power,
    /// The exponent of the parameter in the power t^|n − 1|.
    of_normal: Option<Power>,
}

/// A point of an arc, and a normal of the arc there, of any length.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArcPoint {
    pub(super) at: [Interval; 2],
    pub(super) normal: [Interval; 2],
}

/// A piece of an arc between two directions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// Whether the directions are (t, 1) instead of (1, t).
    pub(super) is_upper: bool,
    /// The parameters of the ends.
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) ends: [ArcPoint; 2],
    /// The corners of a rectangle that holds the piece.
    pub(super) hull: [[Interval; 2]; 4],
}

fn dot(a: [Interval; 2], b: [Interval; 2]) -> Interval {
    a[0] * b[0] + a[1] * b[1]
}

fn length(a: [Interval; 2]) -> Interval {
    (a[0].squared() + a[1].squared()).sqrt()
}

impl UnitArc {
    /// # Errors
    /// [`Error::Limit`] for an exponent n with a numerator or denominator of more than 40 bits.
    pub(super) fn new(n: &Rational) -> Result<Self> {
        let power = |e: &Rational| {
            let too_long = || Error::limit("exponents with numerators and denominators below 2^40");
            Power::new(e).ok_or_else(too_long)
        };
        let bend = n.cmp(&Rational::one());
        let mut off = (n - &Rational::one()).abs();
        if bend == Ordering::Less {
            off = off / n;
        }
        Ok(Self {
            bend,
            exponent: power(n)?,
            root: power(&(Rational::one() / n))?,
            of_normal: (!off.is_zero()).then(|| power(&off)).transpose()?,
        })
    }

    /// The roots x^(1/n) of the members x ≥ 0.
    pub(super) fn root(&self, x: Interval) -> Interval {
        self.root.of(x)
    }

    /// The norm (u^n + v^n)^(1/n) of numbers u, v ≥ 0.
    pub(super) fn norm(&self, u: Interval, v: Interval) -> Interval {
        let (large, small) = match u.high() >= v.high() {
            true => (u, v),
            false => (v, u),
        };
        if !large.is_positive() {
            return Interval::between(0.0, f64::INFINITY);
        }
        let ratio = self.exponent.of((small / large).or_zero());
        large * self.root.of(Interval::from(1.0) + ratio)
    }

    /// The point of a half with a parameter from 0 to 1.
    pub(super) fn point(&self, is_upper: bool, parameter: f64) -> ArcPoint {
        let (one, parameter) = (Interval::from(1.0), Interval::from(parameter));
        let (t, power) = match self.bend {
            Ordering::Less => (self.root.of(parameter), parameter),
            _ => (parameter, self.exponent.of(parameter)),
        };
        let scale = self.root.of(one / (one + power));
        // The gradient (ξ^(n−1), η^(n−1)), divided by a power of ξ or multiplied by one of t.
        let steep = self.of_normal.as_ref();
        let steep = steep.map_or(one, |power| power.of(parameter));
        let at = [scale, scale * t];
        let normal = match self.bend {
            Ordering::Less => [steep, one],
            _ => [one, steep],
        };
        let turned = |[a, b]: [Interval; 2]| if is_upper { [b, a] } else { [a, b] };
        ArcPoint {
            at: turned(at),
            normal: turned(normal),
        }
    }

    /// The two halves of the arc.
    pub(super) fn halves(&self) -> [Piece; 2] {
        [false, true].map(|is_upper| {
            let ends = [0.0, 1.0].map(|t| self.point(is_upper, t));
            self.piece(is_upper, [0.0, 1.0], ends)
        })
    }

    /// The two parts of a piece, unless doubles do not divide it.
    pub(super) fn divided(&self, piece: &Piece) -> Option<[Piece; 2]> {
        let Piece {
            is_upper, from, to, ..
        } = *piece;
        let middle = match () {
            () if from <= 0.0 => FIRST_PART * to,
            () if to > 4.0 * from => from.sqrt() * to.sqrt(),
            () => f64::midpoint(from, to),
        };
        if !(from < middle && middle < to) {
            return None;
        }
        let between = self.point(is_upper, middle);
        let [first, last] = piece.ends;
        Some([
            self.piece(is_upper, [from, middle], [first, between]),
            self.piece(is_upper, [middle, to], [between, last]),
        ])
    }

    /// Lemma. Let P and Q be the ends of a piece. Then the piece is inside of the rectangle over the segment PQ, on the side to which
    /// the arc bends, whose height is the distance of Q from the tangent at P, or that of P from the tangent at Q.
    ///
    /// Proof. ξ and η are monotonic along the arc, so the tangents at the ends and the segment make a triangle in the right triangle over PQ
    /// whose legs are parallel to the axes. The arc is convex, so it is inside of the triangle of the tangents. The angle of that triangle
    /// at its third corner T is at least a right angle. So the triangle is over PQ; and PQ is its longest side, so its height |PT| sin P
    /// is at most |PQ| sin P, the distance of Q from the tangent at P.
    ///
    /// Law: `pieces_are_inside_of_their_rectangles`.
    fn piece(&self, is_upper: bool, [from, to]: [f64; 2], ends: [ArcPoint; 2]) -> Piece {
        let [p, q] = ends.map(|end| end.at);
        let chord = [q[0] - p[0], q[1] - p[1]];
        let heights = ends.map(|end| (dot(end.normal, chord).abs() / length(end.normal)).high());
        let height = match self.bend {
            Ordering::Equal => 0.0,
            _ => heights[0].min(heights[1]),
        };
        // From P to Q the chord goes up and to the left on the lower half; outward is to its right.
        let outward = match is_upper {
            false => [chord[1], -chord[0]],
            true => [-chord[1], chord[0]],
        };
        let side = match self.bend {
            Ordering::Less => outward.map(|x| -x),
            _ => outward,
        };
        let size = length(chord);
        let off = side.map(|x| match height > 0.0 {
            true if size.is_positive() => x / size * height,
            true => Interval::up_to(height),
            false => Interval::ZERO,
        });
        let beyond = |end: [Interval; 2]| [end[0] + off[0], end[1] + off[1]];
        Piece {
            is_upper,
            from,
            to,
            ends,
            hull: [p, q, beyond(p), beyond(q)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 500, ..ProptestConfig::default() })]

        /// Points of a piece are inside of its rectangle, up to rounding; the rectangle is thin.
        #[test]
        fn pieces_are_inside_of_their_rectangles(n in 1i64..60, d in 1i64..20, path in 0u32..256, depth in 0usize..9, part in 0.0f64..1.0) {
            let n = Rational::from(n) / Rational::from(d);
            let arc = UnitArc::new(&n).unwrap();
            let mut piece = arc.halves()[usize::from(path % 2 == 1)];
            for k in 0..depth {
                piece = arc.divided(&piece).unwrap()[(path >> k & 1) as usize];
            }
            let t = piece.from + part * (piece.to - piece.from);
            let point = arc.point(piece.is_upper, t);
            let [x, y] = point.at.map(Interval::middle);
            let e = n.to_f64();
            prop_assert!((x.powf(e) + y.powf(e) - 1.0).abs() < 1e-12);
            // No direction separates the point from the corners.
            for k in 0..64 {
                let (s, c) = (f64::from(k) * std::f64::consts::TAU / 64.0).sin_cos();
                let along = |v: [Interval; 2]| c * v[0].middle() + s * v[1].middle();
                let least = piece.hull.map(along).into_iter().fold(f64::INFINITY, f64::min);
                prop_assert!(along(point.at) >= least - 1e-14, "{piece:?} {point:?}");
            }
            // The normal is that of the arc: it is perpendicular to a short chord.
            if depth == 8 && piece.from > 0.01 && e > 0.5 {
                let [p, q] = piece.ends.map(|end| end.at.map(Interval::middle));
                let chord = [q[0] - p[0], q[1] - p[1]];
                let size = chord[0].hypot(chord[1]);
                let normal = piece.ends[0].normal.map(Interval::middle);
                let cosine = (normal[0] * chord[0] + normal[1] * chord[1]) / normal[0].hypot(normal[1]) / size;
                prop_assert!(cosine.abs() < 0.3, "{cosine}");
            }
        }

        /// The arc is a part of the unit circle of the norm.
        #[test]
        fn points_have_the_norm_1(n in 1i64..60, d in 1i64..20, is_upper: bool, t in 0.0f64..1.0) {
            let arc = UnitArc::new(&(Rational::from(n) / Rational::from(d))).unwrap();
            let [x, y] = arc.point(is_upper, t).at;
            let norm = arc.norm(x, y);
            prop_assert!(norm.low() <= 1.0 && 1.0 <= norm.high() && norm.high() - norm.low() < 1e-12, "{norm:?}");
        }
    }
}
