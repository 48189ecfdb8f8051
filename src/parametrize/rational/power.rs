//! Two homogeneous parts of degrees n and n − k: the cyclic cover `R^k = −q/s` of the line of slopes.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Content, Gcd};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use super::polynomials::{constant, form_at, power};
use super::{Cover, RationalCurve, Rationality};
use crate::exact::Rational;
use crate::poly::{BinaryForm, IntegerPolynomial, squarefree_decomposition};

/// A form without multiple zeros, and its multiplicity in −q/s, which is negative for a factor of s.
struct Part {
    form: BinaryForm,
    multiplicity: i64,
}

/// Decides by the formula of Riemann and Hurwitz, `2g − 2 = −2k + Σ (k − gcd(k, m))`. The sum is over the geometric zeros and
/// poles of −q/s, infinity included, with multiplicities m. If e = gcd(k, all m) > 1, the curve consists of e conjugate curves.
///
/// Genus 0 needs two branch points over which all sheets meet. These points are rational: conjugate ones would have one
/// multiplicity m, prime to k, with k | 2m, so k ≤ 2. Over Q the cover is then `R'^k = c u^m`. With α m + β k = 1, v = R'^α u^β
/// parametrizes it: `u = v^k / c^α`, `R' = c^β v^m`.
pub(super) fn rationality(s: &BinaryForm, q: &BinaryForm, k: usize) -> Option<Rationality> {
    let modulus = i64::try_from(k).ok()?;
    let (parts, factor) = parts(s, q)?;
    let branched: Vec<&Part> = parts
        .iter()
        .filter(|part| part.multiplicity.rem_euclid(modulus) != 0)
        .collect();
    let common = |m: i64| m.unsigned_abs().gcd(modulus.unsigned_abs());
    let components = branched.iter().fold(modulus.unsigned_abs(), |e, part| {
        e.gcd(common(part.multiplicity))
    });
    if components > 1 {
        return Some(Rationality::Conjugates {
            count: usize::try_from(components).ok()?,
        });
    }
    let sheets = branched.iter().map(|part| {
        let sheets = usize::try_from(common(part.multiplicity)).unwrap_or(k);
        part.form.degree() * (k - sheets)
    });
    let genus = (sheets.sum::<usize>() + 2).checked_sub(2 * k)? / 2;
    if genus > 0 {
        return Some(Rationality::PositiveGenus {
            genus,
            cover: Cover::Cyclic {
                degree: k,
                branch_points: branched.iter().map(|part| part.form.degree()).sum(),
            },
        });
    }
    let [first, second] = branched[..] else {
        return None;
    };
    let both = [(first, second), (second, first)];
    let curves = both
        .into_iter()
        .filter_map(|(zero, pole)| cover(&parts, zero, pole, &factor, modulus));
    let shortest = curves.min_by_key(RationalCurve::length)?;
    Some(Rationality::Parametrized(shortest))
}

/// The squarefree parts of −q/s, including powers of x, and the constant factor.
fn parts(s: &BinaryForm, q: &BinaryForm) -> Option<(Vec<Part>, Rational)> {
    let mut parts = Vec::new();
    let mut constants = Vec::new();
    for (form, sign) in [(q, 1), (s, -1)] {
        let in_t = form.dehomogenized();
        let at_infinity = form.degree() + 1 - in_t.coefficients_asc().len();
        if at_infinity > 0 {
            parts.push(Part {
                form: BinaryForm::from_coefficients(vec![Integer::ONE, Integer::ZERO]),
                multiplicity: sign * i64::try_from(at_infinity).ok()?,
            });
        }
        for (multiplicity, part) in squarefree_decomposition(in_t) {
            let degree = part.coefficients_asc().len() - 1;
            parts.push(Part {
                form: BinaryForm::from_dehomogenized(degree, part),
                multiplicity: sign * i64::try_from(multiplicity).ok()?,
            });
        }
        let content = Integer::from(in_t.content());
        let negative = *in_t.coefficients_asc().last()? < 0;
        constants.push(Rational::whole(if negative { -content } else { content }));
    }
    let [of_q, of_s] = &constants[..] else {
        return None;
    };
    Some((parts, -(of_q / of_s)))
}

/// The parametrization by u = zero/pole: `R = R' · pole · ∏ part^j`, where j is the multiplicity of the part divided by k,
/// rounded down.
fn cover(parts: &[Part], zero: &Part, pole: &Part, c: &Rational, k: i64) -> Option<RationalCurve> {
    let m = zero.multiplicity.rem_euclid(k);
    // α with α m ≡ 1 modulo k, of least absolute value.
    let alpha = (1 - k..k)
        .filter(|a| (a * m).rem_euclid(k) == 1)
        .min_by_key(|a| a.abs())?;
    let beta = (1 - alpha * m) / k;
    // The substitution u = zero/pole = v^k / c^α.
    let (ratio, scale) = (c.pow(alpha)?, c.pow(beta)?);
    let variable = |exponent: i64| {
        let mut coefficients = vec![Integer::ZERO; usize::try_from(exponent).unwrap_or(0)];
        coefficients.push(Integer::ONE);
        IntegerPolynomial::from_coefficients_asc(coefficients)
    };
    let above = variable(k) * constant(ratio.denominator());
    let below = constant(ratio.numerator());
    // t0 and t1 solve zero(t0, t1) = above, pole(t0, t1) = below, up to a common factor.
    let [a, b] =
        [&zero.form, &pole.form].map(|f| [constant(f.coefficient(0)), constant(f.coefficient(1))]);
    let slope = [
        &above * &b[1] - &below * &a[1],
        &below * &a[0] - &above * &b[0],
    ];
    let mut numerator = variable(m) * constant(scale.numerator()) * form_at(&pole.form, &slope);
    let mut denominator = constant(scale.denominator());
    for part in parts {
        let value = form_at(&part.form, &slope);
        let exponent = part.multiplicity.div_euclid(k);
        let times = power(&value, usize::try_from(exponent.unsigned_abs()).ok()?);
        if exponent > 0 {
            numerator *= times;
        } else {
            denominator *= times;
        }
    }
    RationalCurve::along(&slope, &numerator, &denominator)
}
