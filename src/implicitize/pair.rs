//! Pairs of parameters with the same point, known by their sum and their product.

use malachite::base::num::basic::traits::Zero;

use super::eliminant::subresultant;
use super::enclosure::{Enclosure, Precision};
use super::symmetric::{Rows, modulo};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, RationalFunction};
use crate::roots::RealRoot;

/// The double points of a curve that is traced once: the common zeros of these two polynomials in S = s + σ and P = sσ.
pub(super) struct DoublePoints<'a> {
    pub(super) coordinates: [&'a RationalFunction; 2],
    pub(super) equations: [Rows; 2],
}

impl DoublePoints<'_> {
    /// The first subresultant `[s_0, s_1]`: if both equations hold, `s_1 P + s_0 = 0`.
    pub(super) fn linear(&self, limits: &Limits) -> Result<[IntegerPolynomial; 2]> {
        let [a, b] = &self.equations;
        let [m, n] = [a, b].map(Rows::degree);
        // If one of the two is linear already, it is the first subresultant itself.
        let found = match (m, n) {
            (1, _) => a.rows().to_vec(),
            (_, 1) => b.rows().to_vec(),
            // There is no first subresultant.
            (0, _) | (_, 0) => vec![IntegerPolynomial::ZERO; 2],
            _ => subresultant([a, b], 1, limits)?,
        };
        let found = <[IntegerPolynomial; 2]>::try_from(found);
        found.map_err(|_| {
            Error::internal(
                "isolated points",
                "a linear polynomial has two coefficients",
            )
        })
    }
}

/// The sum S and the product P of two parameters with the same point.
#[derive(Clone, Debug)]
pub(super) enum Pair {
    /// S is rational, P a real root.
    RationalSum { sum: Rational, product: RealRoot },
    /// S is a real root, and the only common zero P for it is simple, so that `s_1 P + s_0 = 0`.
    RealSum { sum: RealRoot },
}

impl Pair {
    /// Enclosures of S and P, about 2^−bits wide; `None` if the precision is too low to enclose P.
    pub(super) fn enclosed(
        &self,
        points: &DoublePoints<'_>,
        precision: Precision,
    ) -> Option<[Enclosure; 2]> {
        match self {
            Self::RationalSum { sum, product } => {
                Some([precision.rational(sum), enclosed_root(product, precision)])
            }
            Self::RealSum { sum } => {
                let sum = enclosed_root(sum, precision);
                let product = common_zero(&points.equations, &sum, precision)?;
                Some([sum, product])
            }
        }
    }

    /// Whether a polynomial in S and P is exactly 0 at this pair. `linear` is the result of [`DoublePoints::linear`]; without
    /// it the answer is `false` if S is not rational.
    pub(super) fn is_zero_of(&self, f: &Rows, linear: Option<&[IntegerPolynomial; 2]>) -> bool {
        let is_root = |root: &RealRoot, f: &IntegerPolynomial| {
            *f == IntegerPolynomial::ZERO || root.is_root_of(f)
        };
        match self {
            Self::RationalSum { sum, product } => is_root(product, &f.at(sum)),
            Self::RealSum { sum } => linear.is_some_and(|[constant, lead]| {
                let minus = IntegerPolynomial::ZERO - constant;
                is_root(sum, &f.at_quotient([&minus, lead]))
            }),
        }
    }
}

/// An enclosure of a root, of width 2^−bits.
pub(super) fn enclosed_root(root: &RealRoot, precision: Precision) -> Enclosure {
    let mut root = root.clone();
    root.refine_to_width(-precision.bits.cast_signed());
    let (low, high) = root.enclosure();
    precision.between(&low.to_rational(), &high.to_rational())
}

/// An enclosure of the value of a polynomial.
pub(super) fn value_at(f: &IntegerPolynomial, at: &Enclosure, precision: Precision) -> Enclosure {
    let coefficients = f.coefficients_asc().iter().rev();
    coefficients.fold(Enclosure::zero(), |v, c| {
        precision.times(&v, at).plus(&precision.integer(c))
    })
}

/// An enclosure of the common zero of two polynomials in the second variable, for a value of the first variable at which there
/// is exactly one common zero and it is simple. It comes from the matrix of the first subresultant.
fn common_zero([a, b]: &[Rows; 2], sum: &Enclosure, precision: Precision) -> Option<Enclosure> {
    let values = |f: &Rows| -> Vec<Enclosure> {
        let rows = f.rows().iter();
        rows.map(|row| value_at(row, sum, precision)).collect()
    };
    let [left, constant] = remaining([&values(a), &values(b)], precision)?;
    Some(Enclosure::zero().minus(&precision.over(&constant, &left)?))
}

/// Eliminates the rows `Y^r f`, r < deg g − 1, and `Y^r g`, r < deg f − 1, and returns the coefficients of Y and 1 in the row
/// that is left.
fn remaining([f, g]: [&[Enclosure]; 2], precision: Precision) -> Option<[Enclosure; 2]> {
    let (m, n) = (f.len().checked_sub(1)?, g.len().checked_sub(1)?);
    let linear = match (m, n) {
        (1, _) => Some(f),
        (_, 1) => Some(g),
        (0, _) | (_, 0) => return None,
        _ => None,
    };
    if let Some([constant, left]) = linear {
        return Some([left.clone(), constant.clone()]);
    }
    let top = m + n - 2;
    let row = |f: &[Enclosure], shift: usize| -> Vec<Enclosure> {
        let powers = (0..=top).rev();
        let entry = |power: usize| power.checked_sub(shift).and_then(|i| f.get(i)).cloned();
        // The row has zeros beyond both ends of the polynomial.
        powers
            .map(|power| entry(power).unwrap_or_else(Enclosure::zero))
            .collect()
    };
    let rows = (0..n - 1).rev().map(|r| row(f, r));
    let rows = rows.chain((0..m - 1).rev().map(|r| row(g, r)));
    precision.last_row(rows.collect())?.try_into().ok()
}

/// f modulo s² − S s + P as u + v s, for values of S and P.
pub(super) fn reduced(
    f: &IntegerPolynomial,
    [sum, product]: &[Enclosure; 2],
    precision: Precision,
) -> [Enclosure; 2] {
    let coefficients = f.coefficients_asc().iter().rev();
    coefficients.fold([Enclosure::zero(), Enclosure::zero()], |[u, v], c| {
        [
            precision.integer(c).minus(&precision.times(&v, product)),
            u.plus(&precision.times(&v, sum)),
        ]
    })
}

/// A coordinate of the common point of two conjugate parameters.
pub(super) enum Coordinate {
    Value(Enclosure),
    /// Both parameters are poles.
    Pole,
    /// The precision is too low to decide.
    Undecided,
}

/// The value of f at a pair of conjugate parameters with a common value, which is a real number or infinite.
///
/// Modulo s² − S s + P, f is (a + b s)/(c + d s). As s is not real, the value is a/c = b/d, or infinite if c = d = 0
/// ([`are_poles`]).
pub(super) fn coordinate(
    f: &RationalFunction,
    enclosed: &[Enclosure; 2],
    precision: Precision,
) -> Coordinate {
    let [above, below] = [f.numerator(), f.denominator()].map(|p| reduced(p, enclosed, precision));
    let sizes = below.each_ref().map(Enclosure::least);
    let larger = usize::from(sizes[1] > sizes[0]);
    match precision.over(&above[larger], &below[larger]) {
        Some(value) => Coordinate::Value(value),
        None => Coordinate::Undecided,
    }
}

/// Whether both conjugate parameters are poles of f, exactly.
pub(super) fn are_poles(
    f: &RationalFunction,
    pair: &Pair,
    linear: Option<&[IntegerPolynomial; 2]>,
) -> bool {
    let below = modulo(f.denominator());
    below.iter().all(|c| pair.is_zero_of(c, linear))
}

/// Whether f has exactly the rational value v at a pair of conjugate parameters that are no poles.
pub(super) fn has_value(
    f: &RationalFunction,
    pair: &Pair,
    value: &Rational,
    linear: Option<&[IntegerPolynomial; 2]>,
) -> bool {
    let [above, below] = [f.numerator(), f.denominator()].map(modulo);
    let parts = above.iter().zip(&below);
    // The condition is that p − v q is 0 at s, and so at s̄.
    parts
        .map(|(p, q)| p.combined(&value.denominator(), q, &value.numerator()))
        .all(|f| pair.is_zero_of(&f, linear))
}
