//! The certified points of a curve on the ray of an angle θ that is a double. The direction (cos θ, sin θ) is transcendental,
//! so it is enclosed.

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use super::nearest::{Offset, nearest_to_zero};
use crate::error::{Error, Invariant, Result};
use crate::exact::{Rational, cosine_and_sine};
use crate::poly::{
    BinaryForm, IntegerPolynomial, PlanePolynomial, Ring, shift_by_one, sign_at_rational,
};
use crate::roots::constant_sign;

/// The number of bits in the first enclosure of a direction.
const FIRST_BITS: u32 = 192;
/// The number of bits at which the search for the root is given up.
const MOST_BITS: u32 = 1 << 14;

/// The distance of a root λ from 1 is enclosed with a width of about 2^−ROOT_BITS, relative to the distance and to λ.
const ROOT_BITS: i64 = 76;
/// It is proved that no root is nearer to 1 by more than 2^−REACH_BITS of this distance.
const REACH_BITS: i64 = 24;

/// The largest number of halvings of an interval in a proof that it has no root.
const MOST_HALVINGS: u32 = 100;

/// A polynomial f, as its homogeneous parts divided by all factors x² + y², which are 1 on the unit circle.
#[derive(Debug)]
pub(super) struct EnclosedRays {
    /// The pairs of a degree d and the rest of the part of degree d after the division, ascending in d.
    parts: Vec<(usize, BinaryForm)>,
    whole: PlanePolynomial,
}

/// A polynomial Σ c_d λ^d whose coefficients are known up to errors: c_d is at most `errors[d]` away from the integer
/// `middle[d]`.
struct Enclosed {
    middle: Vec<Integer>,
    errors: Vec<Integer>,
}

impl EnclosedRays {
    pub(super) fn new(f: &PlanePolynomial) -> Self {
        let parts = f.parts().rev().filter_map(|part| {
            let (_, rest) = part.strip_rho()?;
            Some((part.degree(), rest))
        });
        Self {
            parts: parts.collect(),
            whole: f.clone(),
        }
    }

    /// The real root of f(r cos θ, r sin θ) that is nearest to r = `got` ≠ 0, as r = got·(1 + δ); `None` if there is no real
    /// root but 0.
    ///
    /// The cosine and the sine are enclosed to about 2^−bits, so every coefficient of the polynomial in λ = r/got is known up
    /// to an error. The nearest root of the polynomial with the middle coefficients is a guess. Then it is proved that the true
    /// polynomial has opposite signs on both sides of the guess, and no zero nearer to 1 (Descartes' rule for the middle
    /// polynomial minus and plus the error). If a proof fails, the number of bits is doubled. The proofs do not fail for ever
    /// if f has no multiple factor: cos θ and sin θ are transcendental (Lindemann), so a coefficient, a difference of roots or
    /// a discriminant is 0 only if it is 0 for all θ, and the circle, for which 1 itself is a root for all θ, is found exactly.
    ///
    /// # Errors
    /// [`Error::Limit`] if the roots cannot be separated, because f has a multiple factor.
    pub(super) fn nearest(&self, theta: &Rational, got: &Rational) -> Result<Option<Offset>> {
        let mut bits = FIRST_BITS;
        loop {
            let g = self.enclosed(theta, got, bits);
            if theta.is_zero() {
                return Ok(g.nearest_exact());
            }
            if let Some(proved) = g.nearest_proved() {
                return Ok(proved);
            }
            // If the circle of radius |got| belongs to the curve, 1 is a root, and no number of bits can prove it.
            if bits == FIRST_BITS && self.holds_circle(got) {
                let zero = Rational::zero;
                return Ok(Some(Offset {
                    low: zero(),
                    high: zero(),
                }));
            }
            if bits >= MOST_BITS {
                return Err(Error::limit(format!(
                    "the roots on the ray theta = {} are not told apart with {MOST_BITS} bits: has the curve a multiple factor? (describe shows factors)",
                    theta.to_f64()
                )));
            }
            bits *= 2;
        }
    }

    /// The polynomial f(λ got cos θ, λ got sin θ), up to a positive factor and divided by its lowest power of λ.
    ///
    /// Lemma 1. Let C and S be less than 2 away from 2^b cos θ and 2^b sin θ, let h be a form of degree m ≥ 1 with 8m < 2^b,
    /// and let ‖h‖ be the sum of the sizes of its coefficients. Then ⌊h(C, S)/2^(b(m − 1))⌋ is at most 4m‖h‖ + 1 away from 2^b
    /// h(cos θ, sin θ).
    /// Proof. With ε = 2·2^−b, C/2^b and S/2^b are at most 1 + ε in size. Replacing the m factors of a monomial one after
    /// another changes it by at most mε(1 + ε)^(m − 1) ≤ mε e^(mε) ≤ 2mε, since mε < 1/4. That is 4m in units of 2^−b. Rounding
    /// down adds less than 1.
    ///
    /// Law: `coefficients_are_within_their_errors_and_reach_them`.
    fn enclosed(&self, theta: &Rational, got: &Rational, bits: u32) -> Enclosed {
        let unit = Integer::ONE << bits;
        // The bounds are at most a quarter of a unit away, and rounding down adds less than one, so Lemma 1 applies.
        let fixed = |v: Rational| (v * Rational::whole(&unit)).floor_integer();
        let [c, s] = cosine_and_sine(theta, bits + 2).map(fixed);
        let exact = theta.is_zero();
        let lowest = self.parts.first().map_or(0, |(d, _)| *d);
        let highest = self.parts.last().map_or(0, |(d, _)| *d);
        let mut middle = vec![Integer::ZERO; highest - lowest + 1];
        let mut errors = middle.clone();
        let (p, q) = (got.numerator(), got.denominator());
        for (d, form) in &self.parts {
            // The error is that of Lemma 1, and 0 for a constant.
            let m = form.degree();
            let value = form.evaluate(&c, &s);
            let value = if m == 0 {
                value << bits
            } else {
                value >> (u64::from(bits) * (m as u64 - 1))
            };
            let norm: Integer = form
                .terms()
                .map(|(_, c)| Integer::from(c.unsigned_abs_ref().clone()))
                .sum();
            let error = if exact || m == 0 {
                Integer::ZERO
            } else {
                norm * Integer::from(4 * m) + Integer::ONE
            };
            let factor = (&p).pow((d - lowest) as u64) * (&q).pow((highest - d) as u64);
            middle[d - lowest] = value * &factor;
            errors[d - lowest] = error * Integer::from(factor.unsigned_abs_ref().clone());
        }
        Enclosed { middle, errors }
    }

    /// Whether f vanishes on the circle of this radius. This is so if, for the even and for the odd degrees d, Σ radius^d f_d
    /// is 0 after powers of x² + y² have raised all parts to the same degree.
    fn holds_circle(&self, radius: &Rational) -> bool {
        [0, 1].into_iter().all(|parity| {
            let parts = self
                .whole
                .parts()
                .filter(|part| part.degree() % 2 == parity);
            let mut sum: Option<PlanePolynomial> = None;
            let mut above = None;
            for part in parts {
                let rise = above.map_or(0, |top: usize| (top - part.degree()) / 2);
                above.get_or_insert(part.degree());
                let power = i64::try_from(part.degree()).invariant("a degree is below 2^63");
                let factor = radius.pow(power).invariant("an exponent is not negative");
                let raised = part
                    .times(&BinaryForm::rho_power(rise))
                    .scaled(&factor.numerator());
                let term = PlanePolynomial::from_parts([raised], factor.denominator());
                sum = Some(match sum {
                    Some(sum) => plus(&sum, &term),
                    None => term,
                });
            }
            sum.is_none_or(|sum| sum.is_zero())
        })
    }
}

fn plus(a: &PlanePolynomial, b: &PlanePolynomial) -> PlanePolynomial {
    PlanePolynomial::from_terms(a.terms().chain(b.terms()))
}

impl Enclosed {
    fn polynomial(coefficients: &[Integer]) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(coefficients.to_vec())
    }

    /// The nearest root if the coefficients have no errors.
    fn nearest_exact(&self) -> Option<Offset> {
        let mut coefficients = self.middle.clone();
        // The root 0 is divided out.
        let zeros = coefficients.iter().take_while(|c| **c == 0).count();
        coefficients.drain(..zeros);
        nearest_to_zero(&shift_by_one(Self::polynomial(&coefficients)))
    }

    /// The nearest root of the true polynomial, or `Some(None)` if it has no real root; `None` if neither is proved.
    ///
    /// Lemma 2. For |λ − 1| ≤ ρ, the true polynomial differs from the middle one by at most E = Σ e_d (1 + ρ)^d. So wherever
    /// middle − E and middle + E have the same sign, the true polynomial has it, too: it has no zero in an interval in which
    /// they have the same constant sign, and a zero between two points at which they have opposite signs.
    /// Proof. |λ| ≤ 1 + ρ, and every coefficient is off by at most e_d.
    fn nearest_proved(&self) -> Option<Option<Offset>> {
        let shifted = shift_by_one(Self::polynomial(&self.middle));
        let Some(offset) = nearest_to_zero(&shifted) else {
            return self.is_proved_empty(&shifted).then_some(None);
        };
        let (inner, outer) = if offset.low.abs() < offset.high.abs() {
            (&offset.low, &offset.high)
        } else {
            (&offset.high, &offset.low)
        };
        // The interval is made a little larger than the enclosure of the root, so that the signs at its ends are certain.
        let part = |size: &Rational, bits: i64| size * &Rational::from_dyadic(Integer::ONE, -bits);
        let reach = (inner - &part(inner, REACH_BITS)).abs();
        let room = part(&offset.size(), ROOT_BITS) * Rational::from(i32::from(inner.signum()));
        let (inner, outer) = (inner - &room, outer + &room);
        let error = self.error_within(&outer.abs());
        let [less, more] = bounds(&shifted, &error);
        let sign = |at: &Rational| {
            let (a, b) = (sign_at_rational(&less, at), sign_at_rational(&more, at));
            (a == b && a != 0).then_some(a)
        };
        if sign(&inner)? == sign(&outer)? {
            return None;
        }
        has_no_zero([&less, &more], &-&reach, &reach, MOST_HALVINGS).then(|| {
            let (low, high) = if inner < outer {
                (inner, outer)
            } else {
                (outer, inner)
            };
            Some(Offset { low, high })
        })
    }

    /// Whether it is proved that the true polynomial has no real root.
    fn is_proved_empty(&self, shifted: &IntegerPolynomial) -> bool {
        let (Some(top), Some(top_error)) = (self.middle.last(), self.errors.last()) else {
            return true;
        };
        let lead = Integer::from(top.unsigned_abs_ref().clone()) - top_error;
        if lead <= 0 {
            return false;
        }
        // By Cauchy's bound all roots satisfy |λ| < 1 + max |c_d|/|c_top|, so |λ − 1| is less than this plus 1.
        let sizes = self.middle.iter().zip(&self.errors);
        let largest = sizes
            .map(|(c, e)| Integer::from(c.unsigned_abs_ref().clone()) + e)
            .max();
        let ratio =
            Rational::from_integers(largest.invariant("the leading coefficient is there"), lead);
        let ratio = ratio.invariant("the leading coefficient is not 0");
        let reach = ratio + Rational::from(2);
        let [less, more] = bounds(shifted, &self.error_within(&reach));
        has_no_zero([&less, &more], &-&reach, &reach, MOST_HALVINGS)
    }

    /// E of Lemma 2 for |λ − 1| ≤ reach, rounded up.
    fn error_within(&self, reach: &Rational) -> Integer {
        let most = Rational::one() + reach;
        let value = self
            .errors
            .iter()
            .rev()
            .fold(Rational::zero(), |sum, e| sum * &most + Rational::whole(e));
        value.floor_integer() + Integer::ONE
    }
}

/// The polynomials f − error and f + error.
fn bounds(f: &IntegerPolynomial, error: &Integer) -> [IntegerPolynomial; 2] {
    let constant = |c: Integer| IntegerPolynomial::from_coefficients_asc(vec![c]);
    [f + constant(-error), f + constant(error.clone())]
}

/// Whether it is proved, by halving the interval, that both polynomials have the same constant sign on it; then so has every
/// polynomial between them.
fn has_no_zero(
    both: [&IntegerPolynomial; 2],
    low: &Rational,
    high: &Rational,
    halvings: u32,
) -> bool {
    let signs = both.map(|f| constant_sign(f, low, high));
    if let [Some(a), Some(b)] = signs {
        return a == b;
    }
    if halvings == 0 {
        return false;
    }
    let middle = (low + high) / Rational::from(2);
    let at_middle = both.map(|f| sign_at_rational(f, &middle));
    if at_middle[0].cmp(&0) != at_middle[1].cmp(&0) || at_middle[0].cmp(&0) == Ordering::Equal {
        return false;
    }
    has_no_zero(both, low, &middle, halvings - 1) && has_no_zero(both, &middle, high, halvings - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The coefficients with few bits are compared with those with many bits, for forms that have one part beside a constant.
    #[test]
    fn coefficients_are_within_their_errors_and_reach_them() {
        const BITS: u32 = 24;
        let mut largest = Rational::zero();
        for m in 1..9 {
            for n in 0..60 {
                // x^m, whose error is all of its slope where cos θ is near 1, and a form with all monomials.
                let monomial = (0..=m).map(|k| Integer::from(i32::from(k == 0)));
                let dense = (0..=m).map(|k| Integer::from(if k % 2 == 0 { 3 } else { -5 }));
                let forms = [monomial.collect::<Vec<_>>(), dense.collect()];
                let theta =
                    Rational::from_integers((7 * n + 1).into(), (100 * m + n).into()).unwrap();
                for form in forms.map(BinaryForm::from_coefficients) {
                    let whole = [form, BinaryForm::from_coefficients(vec![Integer::ONE])];
                    let rays = EnclosedRays::new(&PlanePolynomial::from_parts(whole, Integer::ONE));
                    let few = rays.enclosed(&theta, &Rational::one(), BITS);
                    let many = rays.enclosed(&theta, &Rational::one(), 8 * BITS);
                    let parts = few.middle.iter().zip(&few.errors);
                    for ((few, error), many) in parts.zip(&many.middle) {
                        let off = (Rational::whole(few)
                            - Rational::from_dyadic(many.clone(), -7 * i64::from(BITS)))
                        .abs();
                        assert!(off <= Rational::whole(error), "{off} beyond {error}");
                        if *error != 0 {
                            largest = largest.max(off / Rational::whole(error));
                        }
                    }
                }
            }
        }
        assert!(
            largest > Rational::from_integers(1.into(), 8.into()).unwrap(),
            "{}",
            largest.to_f64()
        );
    }
}
