//! The coefficients of Kuhl and Giardina, each correctly rounded.
//!
//! For a closed polygon with vertices P_k at the arc lengths t_k and the length T, with u_k the unit vector of the edge from P_k
//! to P_(k+1), the n-th harmonic of the polygon as a function of arc length is
//!
//! a_n = T/(2π²n²) Σ_k (u_(k−1) − u_k) cos(2πn t_k/T), b_n = T/(2π²n²) Σ_k (u_(k−1) − u_k) sin(2πn t_k/T)
//!
//! (Kuhl & Giardina 1982, Eq. (7), with the sum over edges turned into one over vertices), and a_0 = 1/T ∫ P dt. All numbers are
//! balls of W limbs ([`UnitBall`]), so each coefficient lies between two rational numbers, from which it is rounded. If they do
//! not determine the rounded one, all is done again with more limbs.

use malachite::Integer;
use malachite::base::num::basic::traits::One;

use super::super::exponent_of;
use super::super::turns::{Turns, bits_of};
use crate::error::{Error, Invariant, Result};
use crate::exact::{Rational, pi};
use crate::limits::Limits;
use crate::parallel;
use crate::roots::{UnitBall, rotations};

/// The number of vertices that one thread takes at a time.
const CHUNK: usize = 512;
/// The number of chunks whose sums are held at the same time.
const CHUNKS: usize = 64;
/// A coefficient that is 0, or half-way between two rounded numbers, is known this many bits below the size of the outline.
const ZERO_BITS: i64 = 200;

/// The coefficients of x by cosines and sines, then those of y.
pub(super) type Harmonics = [Vec<Rational>; 4];

/// The coefficients for n = 0, …, `harmonics` of the closed polygon through `points`, rounded to the nearest doubles or to
/// decimals.
///
/// A number that cannot be told from 0, or from one half-way between two rounded numbers, by balls of 320 bits is taken for it;
/// it is within 2^(−200) of the size.
pub(super) fn coefficients(
    points: &[[f64; 2]],
    middle: [f64; 2],
    harmonics: usize,
    decimals: Option<u32>,
    limits: &Limits,
) -> Result<Harmonics> {
    let polygon = Polygon { points, middle };
    let few = polygon.enclose::<3>(harmonics, limits)?;
    if let Some(rounded) = few.and_then(|e| e.rounded(decimals, false)) {
        return Ok(rounded);
    }
    let more = polygon.enclose::<5>(harmonics, limits)?;
    if let Some(rounded) = more.and_then(|e| e.rounded(decimals, true)) {
        return Ok(rounded);
    }
    let most = polygon.enclose::<10>(harmonics, limits)?;
    most.and_then(|e| e.rounded(decimals, true)).ok_or_else(|| {
        Error::internal(
            "the coefficients of an elliptic series",
            "640 bits do not determine their doubles",
        )
    })
}

/// A closed polygon, and the point from which its coordinates are measured.
struct Polygon<'a> {
    points: &'a [[f64; 2]],
    middle: [f64; 2],
}

/// The numbers that all vertices share.
struct Frame<const W: usize> {
    turns: Turns<W>,
    /// All lengths, and the length of the polygon, are less than 2^length.
    length: i64,
    /// All coordinates are less than 2^size from the middle.
    size: i64,
    /// The length of the polygon in units of 2^length.
    total: UnitBall<W>,
    /// 1/8 over that length.
    reciprocal: UnitBall<W>,
    /// All weights are divided by 2^`guard`, so that their sums are in [−1, 1].
    guard: u32,
}

/// Reciprocals of lengths are divided by 2^3, so that they are less than 1: [`exponent_above`] makes a length at least 1/4 of its
/// unit, up to rounding.
const EIGHTH_BITS: u32 = 3;
const EIGHTH: f64 = 0.125;

/// The sums over a run of vertices.
struct Sums<const W: usize> {
    /// Σ P_k (l_(k−1) + l_k)/2 for the lengths l_k of edges, in units of 2^(size + length).
    middle: [UnitBall<W>; 2],
    /// The sums for n = 1, 2, …: x by cosines and sines, then y.
    harmonics: Vec<[UnitBall<W>; 4]>,
}

/// An edge in units of 2^exponent.
struct Edge<const W: usize> {
    vector: [UnitBall<W>; 2],
    length: UnitBall<W>,
    exponent: i64,
}

impl Polygon<'_> {
    /// The enclosures by balls of W limbs; `None` if these are too few for the length of an edge.
    fn enclose<const W: usize>(
        &self,
        harmonics: usize,
        limits: &Limits,
    ) -> Result<Option<Enclosures>> {
        let n = self.points.len();
        let starts: Vec<usize> = (0..n).step_by(CHUNK).collect();
        let length = self.length_exponent();
        let lengths = parallel::try_map(&starts, limits, |&start| {
            let mut edges = (start..n.min(start + CHUNK)).map(|k| self.edge::<W>(k));
            Ok(edges.try_fold(UnitBall::ZERO, |sum, edge| {
                Some(sum.plus(&edge?.length_in(length)))
            }))
        })?;
        let mut before = UnitBall::ZERO;
        let mut runs = Vec::new();
        for (&start, length) in starts.iter().zip(&lengths) {
            runs.push((start, before));
            let Some(length) = length else {
                return Ok(None);
            };
            before = before.plus(length);
        }
        let Some(reciprocal) = UnitBall::of_double(EIGHTH).over(&before) else {
            return Ok(None);
        };
        let frame = Frame::<W> {
            turns: Turns::new(),
            length,
            size: self.size_exponent(),
            total: before,
            reciprocal,
            // Each weight is a difference of two numbers in [−1, 1].
            guard: n.ilog2() + 2,
        };
        let mut sums = Sums::zero(harmonics);
        for some in runs.chunks(CHUNKS) {
            let parts = parallel::try_map(some, limits, |&(start, before)| {
                Ok(self.run(start, before, harmonics, &frame))
            })?;
            for part in parts {
                let Some(part) = part else { return Ok(None) };
                sums.add(&part);
            }
        }
        Ok(Some(Enclosures::new(&sums, &frame, self.middle)))
    }

    /// The sums over the vertices from `start` on; `at` is the arc length there.
    fn run<const W: usize>(
        &self,
        start: usize,
        mut at: UnitBall<W>,
        harmonics: usize,
        frame: &Frame<W>,
    ) -> Option<Sums<W>> {
        let n = self.points.len();
        let mut sums = Sums::zero(harmonics);
        let before = self.edge::<W>((start + n - 1) % n)?;
        let mut incoming = before.direction(frame.guard)?;
        let mut last = before.length_in(frame.length);
        for k in start..n.min(start + CHUNK) {
            let edge = self.edge::<W>(k)?;
            let outgoing = edge.direction(frame.guard)?;
            let weights: [UnitBall<W>; 2] =
                std::array::from_fn(|i| incoming[i].plus(&outgoing[i].negated()));
            let wave = if k == 0 {
                [UnitBall::ONE, UnitBall::ZERO]
            } else {
                frame.turns.at(at.times(&frame.reciprocal), EIGHTH_BITS)
            };
            let [cosines, sines] = rotations(wave, harmonics);
            let pairs = cosines[1..].iter().zip(&sines[1..]);
            for (sum, (c, s)) in sums.harmonics.iter_mut().zip(pairs) {
                for (part, (weight, wave)) in sum.iter_mut().zip([(0, c), (0, s), (1, c), (1, s)]) {
                    *part = part.plus(&weights[weight].times(wave));
                }
            }
            let next = edge.length_in(frame.length);
            let share = last.shifted_down(1).plus(&next.shifted_down(1));
            for (i, sum) in sums.middle.iter_mut().enumerate() {
                let coordinate = difference(self.points[k][i], self.middle[i], frame.size);
                *sum = sum.plus(&share.times(&coordinate));
            }
            at = at.plus(&next);
            (last, incoming) = (next, outgoing);
        }
        Some(sums)
    }

    /// The edge from the k-th vertex to the next one; `None` if W limbs are too few for its length.
    fn edge<const W: usize>(&self, k: usize) -> Option<Edge<W>> {
        let (p, q) = (self.points[k], self.points[(k + 1) % self.points.len()]);
        let largest = (q[0] - p[0]).abs().max((q[1] - p[1]).abs());
        let exponent = exponent_above(largest);
        let vector = [0, 1].map(|i| difference(q[i], p[i], exponent));
        let square = vector.map(|c: UnitBall<W>| c.times(&c));
        Some(Edge {
            length: square[0].plus(&square[1]).root()?,
            vector,
            exponent,
        })
    }

    /// An exponent e with a length of the polygon, and of each edge's unit, below 2^e.
    fn length_exponent(&self) -> i64 {
        let n = self.points.len();
        let edges = (0..n).map(|k| (self.points[k], self.points[(k + 1) % n]));
        let length: f64 = edges
            .map(|(p, q)| f64::hypot(q[0] - p[0], q[1] - p[1]))
            .sum();
        exponent_above(length)
    }

    /// An exponent e such that all coordinates are less than 2^e from the middle.
    fn size_exponent(&self) -> i64 {
        let distances = self
            .points
            .iter()
            .flat_map(|p| [0, 1].map(|i| (p[i] - self.middle[i]).abs()));
        exponent_above(distances.fold(0.0, f64::max))
    }
}

/// An exponent e with value < 2^(e − 1) ≤ 2 · value. The doubles that are handed in are rounded, so they may be a little too
/// small.
fn exponent_above(value: f64) -> i64 {
    exponent_of(value) + 1
}

/// The difference a − b in units of 2^exponent, which must be in (−1, 1).
fn difference<const W: usize>(a: f64, b: f64, exponent: i64) -> UnitBall<W> {
    // The difference is the sum of two doubles, exactly (Knuth's two-sum).
    let high = a - b;
    let back = high - a;
    let low = (a - (high - back)) - (b + back);
    // Powers of two scale exactly: the coordinates of outlines are between 1e-120 and 1e120.
    let scale = f64::from_bits((1023 - exponent).unsigned_abs() << 52);
    UnitBall::of_double(high * scale).plus(&UnitBall::of_double(low * scale))
}

impl<const W: usize> Edge<W> {
    /// The unit vector, divided by 2^guard.
    fn direction(&self, guard: u32) -> Option<[UnitBall<W>; 2]> {
        let eighth = UnitBall::of_double(EIGHTH).over(&self.length)?;
        Some(
            self.vector
                .map(|c| c.times(&eighth).shifted_down(guard - EIGHTH_BITS)),
        )
    }

    /// The length in units of 2^exponent, which is at least that of the edge itself.
    fn length_in(&self, exponent: i64) -> UnitBall<W> {
        let bits = u32::try_from(exponent - self.exponent)
            .invariant("an edge is no longer than its polygon");
        self.length.shifted_down(bits)
    }
}

impl<const W: usize> Sums<W> {
    fn zero(harmonics: usize) -> Self {
        Self {
            middle: [UnitBall::ZERO; 2],
            harmonics: vec![[UnitBall::ZERO; 4]; harmonics],
        }
    }

    fn add(&mut self, other: &Self) {
        let own = self
            .middle
            .iter_mut()
            .chain(self.harmonics.iter_mut().flatten());
        let others = other.middle.iter().chain(other.harmonics.iter().flatten());
        for (sum, part) in own.zip(others) {
            *sum = sum.plus(part);
        }
    }
}

/// Rational bounds of all coefficients.
struct Enclosures {
    middle: [[Rational; 2]; 2],
    harmonics: Vec<[[Rational; 2]; 4]>,
    /// The largest difference of bounds within which a number is taken for 0, or for one half-way between rounded ones.
    zero: Rational,
}

impl Enclosures {
    fn new<const W: usize>(sums: &Sums<W>, frame: &Frame<W>, middle: [f64; 2]) -> Self {
        let power = |e: i64| Rational::from_dyadic(Integer::ONE, e);
        let (low, high) = pi(bits_of::<W>());
        let two = Rational::from(2);
        let [shortest, longest] = frame.total.bounds();
        let unit = power(frame.length + i64::from(frame.guard));
        // T/(2π²), times 2^guard.
        let factor = [
            &shortest * &unit / (&two * &high * &high),
            &longest * &unit / (&two * &low * &low),
        ];
        let of_sum = |sum: &UnitBall<W>, n: usize| {
            let square = Rational::from(n as i64) * Rational::from(n as i64);
            let [low, high] = sum.bounds();
            // The factor is positive.
            let scaled = |bound: Rational, when_positive: usize| {
                let which = if bound.signum() < 0 {
                    1 - when_positive
                } else {
                    when_positive
                };
                bound * &factor[which] / &square
            };
            [scaled(low, 0), scaled(high, 1)]
        };
        let harmonics = sums.harmonics.iter().enumerate();
        let about = |i: usize| {
            let from =
                Rational::try_from(middle[i]).invariant("the middle of an outline is finite");
            let [low, high] = sums.middle[i].bounds();
            let mean = |bound: Rational, when_positive: &Rational, when_negative: &Rational| {
                let length = if bound.signum() < 0 {
                    when_negative
                } else {
                    when_positive
                };
                bound / length * power(frame.size) + &from
            };
            [
                mean(low, &longest, &shortest),
                mean(high, &shortest, &longest),
            ]
        };
        Self {
            middle: [about(0), about(1)],
            harmonics: harmonics
                .map(|(k, sums)| sums.each_ref().map(|sum| of_sum(sum, k + 1)))
                .collect(),
            zero: power(frame.size - 1 - ZERO_BITS),
        }
    }

    /// The rounded coefficients; `None` if some bounds do not determine one.
    fn rounded(&self, decimals: Option<u32>, with_ties: bool) -> Option<Harmonics> {
        let mut found: Harmonics = Default::default();
        let zero = [Rational::zero(), Rational::zero()];
        let [x, y] = &self.middle;
        let first = [x, &zero, y, &zero];
        let all = std::iter::once(first).chain(self.harmonics.iter().map(|four| four.each_ref()));
        for four in all {
            for (list, bounds) in found.iter_mut().zip(four) {
                list.push(self.round(bounds, decimals, with_ties)?);
            }
        }
        Some(found)
    }

    fn round(
        &self,
        [low, high]: &[Rational; 2],
        decimals: Option<u32>,
        with_ties: bool,
    ) -> Option<Rational> {
        let rounded = |value: &Rational| match decimals {
            None => Rational::try_from(value.to_f64()).ok(),
            Some(digits) => Some(value.round_decimals(digits)),
        };
        let (below, above) = (rounded(low)?, rounded(high)?);
        if below == above {
            return Some(below);
        }
        if !with_ties || high - low > self.zero {
            return None;
        }
        let is_held = |value: &Rational| low <= value && value <= high;
        let zero = Rational::zero();
        if is_held(&zero) {
            return Some(zero);
        }
        let tie = (below + above) / Rational::from(2);
        is_held(&tie).then(|| rounded(&tie))?
    }
}
