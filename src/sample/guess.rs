//! Guesses of real roots, by eigenvalues of the companion matrix in doubles.

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;
use nalgebra::DMatrix;
use nalgebra::linalg::Schur;

use crate::error::Invariant;
use crate::exact::Dyadic;
use crate::poly::IntegerPolynomial;

/// Above this degree O(d³) eigenvalues cost more than refining every interval exactly.
const LARGEST_DEGREE: usize = 24;

/// The largest number of QR steps; only speed depends on the eigenvalues.
const MAX_STEPS: usize = 1000;

/// Approximate real roots in no order. Some may be missing or wrong: they are guesses, which [`crate::roots::RealRoot`] proves
/// or ignores.
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "guesses: exact signs decide"
)]
pub(super) fn real_root_guesses(f: &IntegerPolynomial) -> Vec<f64> {
    let c = f.coefficients_asc();
    let degree = c.len().saturating_sub(1);
    if !(2..=LARGEST_DEGREE).contains(&degree) || c[0] == 0 {
        return Vec::new();
    }
    let bits = |v: &Integer| v.significant_bits() as f64;
    // The substitution x = 2^s y makes the roots of mean size 1.
    let s = ((bits(&c[0]) - bits(&c[degree])) / degree as f64).round() as i64;
    let lead = log_mantissa(&c[degree]);
    let scaled = |i: usize| -> f64 {
        let (mantissa, exponent) = log_mantissa(&c[i]);
        let shift = exponent - lead.1 + s * (i as i64 - degree as i64);
        mantissa / lead.0 * (shift.clamp(-2000, 2000) as f64).exp2()
    };
    let mut companion = DMatrix::<f64>::zeros(degree, degree);
    for i in 0..degree {
        companion[(i, degree - 1)] = -scaled(i);
        if i > 0 {
            companion[(i, i - 1)] = 1.0;
        }
    }
    if companion.iter().any(|v| !v.is_finite()) {
        return Vec::new();
    }
    let Some(schur) = Schur::try_new(companion, f64::EPSILON, MAX_STEPS) else {
        return Vec::new();
    };
    schur
        .complex_eigenvalues()
        .iter()
        .filter(|z| z.im.abs() <= 1e-6 * z.re.abs())
        .map(|z| z.re * (s.clamp(-1000, 1000) as f64).exp2())
        .filter(|v| v.is_normal())
        .collect()
}

/// value = mantissa · 2^exponent with a double in [1, 2).
fn log_mantissa(value: &Integer) -> (f64, i64) {
    let exponent = i64::try_from(value.significant_bits()).invariant("bits are far below 2^63");
    (Dyadic::new(value.clone(), -exponent).to_f64(), exponent)
}
