//! Zeros without a change of sign: a polynomial that comes nearer to 0 in a ball than any positive minimum could.

use malachite::base::num::logic::traits::SignificantBits;

use super::chart::sphere_about;
use super::exact::{exact_difference, squared_length};
use crate::exact::Rational;
use crate::field::Field;
use crate::poly::SparsePolynomial;

/// Evaluations go to so many bits at most.
const MAX_BITS: i64 = 1 << 21;

/// Proves that f has a zero in the closed ball of radius d about p, if it has one at a non-degenerate critical point near
/// `start` inside the ball.
///
/// For an f ∈ ℤ[x₁ … xₙ] on a compact connected set {h ≥ 0}, both of degree at most D (even) and with coefficients at most H,
/// the minimum is 0 or at least (2^(4−n/2) H̃ D^n)^(−n 2^n D^n) in size, where H̃ = max(H, 2n + 2) (Jeronimo, Perrucci, Tsigaridas, *On
/// the minimum of a polynomial function on a basic closed semialgebraic set*, SIAM J. Optim. 23 (2013), Theorem 1). So a
/// point x of the ball with |f(x)| below that proves a zero: if f(x) ≥ 0 the minimum is not positive. The exponent is
/// doubled here, which costs one more step of Newton's method and leaves a margin.
pub(super) fn zero_in_ball(
    field: &Field,
    p: &[Rational; 3],
    d: &Rational,
    start: [f64; 3],
) -> Option<[Rational; 3]> {
    let f = field.polynomial().primitive();
    let bits = gap_bits(&f, p, d);
    if bits > MAX_BITS {
        return None;
    }
    let derivatives = [0, 1, 2].map(|i| f.derivative(i));
    let second = derivatives
        .each_ref()
        .map(|g| [0, 1, 2].map(|i| g.derivative(i)));
    let bound = Rational::from(2).pow(-bits)?;
    let mut x = start.map(|x| Rational::try_from(x).unwrap_or_default());
    let mut precision = 64;
    loop {
        let gradient = derivatives.each_ref().map(|g| g.evaluate(&x));
        let hessian = second
            .each_ref()
            .map(|row| row.each_ref().map(|g| g.evaluate(&x)));
        let step = solved(&hessian, &gradient)?;
        precision = (2 * precision).min(bits + 64);
        x = std::array::from_fn(|i| {
            let next = &x[i] - &step[i];
            // The simplest fraction keeps rational points exact.
            let width = Rational::from(2).pow(-precision).unwrap_or_default();
            Rational::simplest_between(&(&next - &width), &(&next + &width))
        });
        if squared_length(&exact_difference(p, &x)) > d * d {
            return None;
        }
        if f.evaluate(&x).abs() < bound {
            return Some(x);
        }
        if precision >= bits + 64 {
            return None;
        }
    }
}

/// Minus the logarithm of the gap, doubled.
fn gap_bits(f: &SparsePolynomial<3>, p: &[Rational; 3], d: &Rational) -> i64 {
    let height = |g: &SparsePolynomial<3>| -> i64 {
        let bits = g.terms().map(|(_, c)| c.numerator().significant_bits());
        i64::try_from(bits.max().unwrap_or(0)).unwrap_or(i64::MAX / 4)
    };
    let height = height(f)
        .max(height(&sphere_about(p, d).primitive()))
        .max(3);
    let degree = i64::try_from(f.degree().unwrap_or(0))
        .unwrap_or(i64::MAX)
        .max(2);
    let even = degree + degree % 2;
    let log = 64 - i64::from(even.leading_zeros());
    // n = 3: twice 3·2³·D³ times log₂(2^(5/2) H̃ D³), rounded up
    2 * 24 * even.saturating_pow(3).saturating_mul(3 + height + 3 * log)
}

/// A⁻¹ b by Cramer's rule, `None` if A is singular. A variable that does not occur gives a row and a column of zeros and stays.
fn solved(a: &[[Rational; 3]; 3], b: &[Rational; 3]) -> Option<[Rational; 3]> {
    let mut a = a.clone();
    for i in 0..3 {
        if a[i].iter().all(Rational::is_zero) && b[i].is_zero() {
            a[i][i] = Rational::one();
        }
    }
    let determinant = |m: &[[Rational; 3]; 3]| {
        let minor = |i: usize, j: usize| &m[1][i] * &m[2][j] - &m[1][j] * &m[2][i];
        &m[0][0] * &minor(1, 2) - &m[0][1] * &minor(0, 2) + &m[0][2] * &minor(0, 1)
    };
    let whole = determinant(&a);
    let inverse = whole.recip()?;
    Some(std::array::from_fn(|column| {
        let mut replaced = a.clone();
        for (row, value) in replaced.iter_mut().zip(b) {
            row[column] = value.clone();
        }
        determinant(&replaced) * &inverse
    }))
}
