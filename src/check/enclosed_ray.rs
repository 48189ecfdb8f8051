//! A curve on the ray of an angle that is a double: its direction (cos θ, sin θ) is transcendental, the answer certified.

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

/// The precision that a direction is first enclosed with, in bits …
const FIRST_BITS: u32 = 192;
/// … and the one at which the work is given up: the roots there cannot be told apart.
const MOST_BITS: u32 = 1 << 14;

/// The distance of a root λ from 1 is enclosed to 2^−this of itself and of λ …
const ROOT_BITS: i64 = 76;
/// … and no root is nearer by more than 2^−this of it.
const REACH_BITS: i64 = 24;

/// How often an interval is halved to prove that it holds no root.
const MOST_HALVINGS: u32 = 100;

/// f by its homogeneous parts without their powers of x² + y², which are 1 on every ray.
#[derive(Debug)]
pub(super) struct EnclosedRays {
    /// (d, what is left of the part of degree d), ascending in d.
    parts: Vec<(usize, BinaryForm)>,
    whole: PlanePolynomial,
}

/// Σ c_d λ^d with integers c_d of which each is known up to an error e_d.
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

    /// The root of f(r cos θ, r sin θ) nearest to r = `got` ≠ 0, as r = got·(1 + δ); `None` if there is none but 0.
    ///
    /// The direction is enclosed in a square of 2^−bits; so every coefficient of the polynomial in λ = r/got is known
    /// up to an error. The root of the polynomial in the middle is a root of the true one up to proof: the true one
    /// has opposite signs on both sides of it, and no zero nearer to 1 (Descartes' rule for the middle polynomial less and
    /// plus the error). Where that fails the precision doubles; it does not fail for ever, because (cos θ, sin θ) is
    /// transcendental (Lindemann), so that no coefficient, no root and no discriminant is an accident of θ; and what
    /// vanishes for every θ is found exactly.
    ///
    /// # Errors
    /// [`Error::Limit`] where roots cannot be told apart: f has a multiple factor.
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
            // A root that no precision tells from 1: the circle of radius |got| belongs to the curve.
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

    /// f(λ got cos θ, λ got sin θ) without powers of λ, up to a positive factor.
    ///
    /// Lemma 1. Let C and S be less than 2 away from 2^b cos θ and 2^b sin θ, and h a form of degree m ≥ 1 with 8m < 2^b. Then
    /// ⌊h(C, S)/2^(b(m − 1))⌋ is at most 4m‖h‖ + 1 away from 2^b h(cos θ, sin θ), ‖h‖ the sum of the sizes of the coefficients.
    /// Proof. With ε = 2·2^−b, C/2^b and S/2^b are at most 1 + ε in size. Replacing the m factors of a monomial one after another
    /// changes it by at most mε(1 + ε)^(m − 1) ≤ mε e^(mε) ≤ 2mε, since mε < 1/4. That is 4m in units of 2^−b. The
    /// floor takes less than 1 more.
    ///
    /// Law: `coefficients_are_within_their_errors_and_reach_them`.
    fn enclosed(&self, theta: &Rational, got: &Rational, bits: u32) -> Enclosed {
        let unit = Integer::ONE << bits;
        // Less than a quarter of a unit away, and less than one more by the floor.
        let fixed = |v: Rational| (v * Rational::whole(&unit)).floor_integer();
        let [c, s] = cosine_and_sine(theta, bits + 2).map(fixed);
        let exact = theta.is_zero();
        let lowest = self.parts.first().map_or(0, |(d, _)| *d);
        let highest = self.parts.last().map_or(0, |(d, _)| *d);
        let mut middle = vec![Integer::ZERO; highest - lowest + 1];
        let mut errors = middle.clone();
        let (p, q) = (got.numerator(), got.denominator());
        for (d, form) in &self.parts {
            // By Lemma 1; a constant is exact.
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

    /// Whether f vanishes on the circle of this radius: Σ radius^d f_d over the d of either parity, made one form by
    /// powers of x² + y², is 0.
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

    /// For coefficients without error.
    fn nearest_exact(&self) -> Option<Offset> {
        let mut coefficients = self.middle.clone();
        // No root 0.
        let zeros = coefficients.iter().take_while(|c| **c == 0).count();
        coefficients.drain(..zeros);
        nearest_to_zero(&shift_by_one(Self::polynomial(&coefficients)))
    }

    /// The nearest root of the true polynomial, if that is proved; `Some(None)` if it is proved that there is none.
    ///
    /// Lemma 2. For |λ − 1| ≤ ρ the true polynomial differs from the middle one by at most E = Σ e_d (1 + ρ)^d. So it has the
    /// sign of middle − E and middle + E where these have one sign: no zero on an interval on which they have, and one between two
    /// points at which these signs are opposite. Proof. |λ| ≤ 1 + ρ, and every coefficient is off by at most e_d.
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
        // A little room around the root, so that signs differ.
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

    /// Whether the true polynomial is proved to have no real root at all.
    fn is_proved_empty(&self, shifted: &IntegerPolynomial) -> bool {
        let (Some(top), Some(top_error)) = (self.middle.last(), self.errors.last()) else {
            return true;
        };
        let lead = Integer::from(top.unsigned_abs_ref().clone()) - top_error;
        if lead <= 0 {
            return false;
        }
        // Cauchy: all roots have |λ| < 1 + max |c_d|/|c_top|.
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

/// f − error and f + error.
fn bounds(f: &IntegerPolynomial, error: &Integer) -> [IntegerPolynomial; 2] {
    let constant = |c: Integer| IntegerPolynomial::from_coefficients_asc(vec![c]);
    [f + constant(-error), f + constant(error.clone())]
}

/// Whether everything between two polynomials has one sign on an interval, by halving it.
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

    /// The coefficients with few bits against those with many, for forms of which each has one part beside a constant.
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
