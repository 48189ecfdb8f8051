//! Decides by algebra whether two angles are the same.

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::angle::ExactAngle;
use crate::exact::Rational;
use crate::poly::IntegerPolynomial;
use crate::roots::RealRoot;

impl ExactAngle {
    /// Some positive number below π/b, if the two angles are proved to differ by a multiple of π/b for some b; `None` if they
    /// are proved to be different.
    ///
    /// Lemma (two arctangents). Two angles differ by a multiple of π exactly if their tangents are the same, and tan 2x =
    /// 2t/(1 − t²) for t = tan x, which is a rational function of t.
    ///
    /// Lemma (a multiple of π). An angle is a multiple of π/b exactly if its tangent is a root of Im (1 + i t)^b, or
    /// infinite. A tangent of aπ/b, a/b in lowest terms and b > 4, is algebraic of degree φ(b) or φ(b)/2 (Calcut, *Rationality
    /// and the Tangent Function*), at least √(b/2)/2 in any case; so for b > 8n² no root of a polynomial of degree n is one.
    ///
    /// Laws: `equal_angles_are_equal_however_they_are_written`, `angles_that_differ_in_a_far_bit_differ`.
    pub(super) fn spacing(&self, other: &Self) -> Option<Rational> {
        let three = Rational::from(3);
        match (self, other) {
            (Self::Pi(a), Self::Pi(b)) => (a == b).then_some(three),
            (Self::Pi(q), Self::Arctangent { tangent, times, .. })
            | (Self::Arctangent { tangent, times, .. }, Self::Pi(q)) => {
                let degree = tangent.polynomial().coefficients_asc().len() as u64;
                let most = Integer::from(8 * degree * degree);
                let b = q.denominator();
                // For the angle of this tangent, π/b means a multiple of π/(times·b).
                let parts = &b * Integer::from(*times);
                let fits = parts <= most * Integer::from(*times);
                let parts = u64::try_from(&parts).ok().filter(|_| fits)?;
                tangent
                    .is_root_of(&sine_of_multiple(parts))
                    .then(|| three / Rational::whole(b))
            }
            (
                Self::Arctangent {
                    tangent: a,
                    times: k,
                    ..
                },
                Self::Arctangent {
                    tangent: b,
                    times: l,
                    ..
                },
            ) => {
                let is_same = match (k, l) {
                    (1, 1) => a.is_same(b),
                    (1, _) => is_tangent_of_double(a, b),
                    (_, 1) => is_tangent_of_double(b, a),
                    _ => a.is_same(b) || is_minus_inverse(a, b),
                };
                is_same.then_some(three)
            }
        }
    }
}

/// The polynomial Im (1 + i t)^b, whose roots are the tangents of the multiples of π/b.
fn sine_of_multiple(b: u64) -> IntegerPolynomial {
    let mut coefficients = vec![Integer::ZERO; 1];
    // The binomial coefficient C(b, k).
    let mut binomial = Integer::from(1);
    for k in 1..=b {
        binomial = binomial * Integer::from(b - k + 1) / Integer::from(k);
        coefficients.push(match k % 4 {
            1 => binomial.clone(),
            3 => -&binomial,
            _ => Integer::ZERO,
        });
    }
    IntegerPolynomial::from_coefficients_asc(coefficients)
}

/// Whether a = 2b/(1 − b²), exactly.
///
/// Let f be the polynomial of a. 2b/(1 − b²) is a root of f exactly if b is a root of f(2t/(1 − t²)) (1 − t²)^deg f. If it is a
/// root and lies within the bounds of a, it is a, because f has no other root there.
fn is_tangent_of_double(a: &RealRoot, b: &RealRoot) -> bool {
    let poly = |c: [i64; 3]| {
        IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
    };
    let (above, below) = (poly([0, 2, 0]), poly([1, 0, -1]));
    let sign_below = b.sign_of(&below);
    if sign_below == 0 {
        return false;
    }
    // The sign of 2b/(1 − b²) − p/q, for q > 0.
    let compared_with = |bound: &Rational| {
        let constant = |c: Integer| IntegerPolynomial::from_coefficients_asc(vec![c]);
        let difference =
            &above * constant(bound.denominator()) - &below * constant(bound.numerator());
        b.sign_of(&difference) * sign_below
    };
    let (low, high) = a.enclosure();
    if low == high {
        return compared_with(&low.to_rational()) == 0;
    }
    if compared_with(&low.to_rational()) <= 0 || compared_with(&high.to_rational()) >= 0 {
        return false;
    }
    let mut value = IntegerPolynomial::ZERO;
    let mut power = poly([1, 0, 0]);
    for c in a.polynomial().coefficients_asc().iter().rev() {
        value = value * &above + IntegerPolynomial::from_coefficients_asc(vec![c.clone()]) * &power;
        power *= &below;
    }
    b.is_root_of(&value)
}

/// Whether a b = −1, exactly. −1/b is a root of the polynomial of a exactly if b is a root of the polynomial with the
/// coefficients in reverse order and every other sign changed.
fn is_minus_inverse(a: &RealRoot, b: &RealRoot) -> bool {
    let product_sign = a.signum() * b.signum();
    if product_sign >= 0 {
        return false;
    }
    let coefficients = a.polynomial().coefficients_asc().iter().rev().enumerate();
    let coefficients = coefficients.map(|(k, c)| if k % 2 == 0 { c.clone() } else { -c });
    let turned = IntegerPolynomial::from_coefficients_asc(coefficients.collect());
    // −1/b must be inside the bounds (low, high) of a.
    let (low, high) = a.enclosure();
    let compared_with = |bound: &Rational| -> Ordering {
        match bound.recip() {
            // −1/b has the sign of a.
            None => a.signum().cmp(&0),
            // Of two numbers of one sign, the larger one has the smaller inverse.
            Some(inverse) if bound.signum() == a.signum() => b.cmp_rational(&-inverse),
            Some(_) => a.signum().cmp(&bound.signum()),
        }
    };
    let (low, high) = (low.to_rational(), high.to_rational());
    if low == high {
        return compared_with(&low) == Ordering::Equal;
    }
    compared_with(&low).is_gt() && compared_with(&high).is_lt() && b.is_root_of(&turned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roots::real_roots;
    use proptest::prelude::*;

    fn poly(c: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
    }

    /// A real root equal to a rational number q, of a polynomial with other roots as well.
    fn rational_root(q: &Rational) -> RealRoot {
        let f = IntegerPolynomial::from_coefficients_asc(vec![-q.numerator(), q.denominator()]);
        real_roots(&f).remove(0)
    }

    /// The function 2t/(1 − t²).
    fn doubled(t: &Rational) -> Option<Rational> {
        let below = Rational::one() - t * t;
        Some(&(t + t) * &below.recip()?)
    }

    /// An angle in [0, 2π), written by its tangent and by the tangent of its half.
    fn both_ways(half: &RealRoot, tangent: RealRoot) -> [ExactAngle; 2] {
        let by_half = ExactAngle::of_half_tangent(half.clone());
        let by_tangent = ExactAngle::of_tangent(tangent);
        let same_side = by_half.cmp_pi().is_lt();
        [
            by_half,
            if same_side {
                by_tangent
            } else {
                by_tangent.plus_pi()
            },
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn equal_angles_are_equal_however_they_are_written(p in -40i64..41, q in 1i64..40, c in 2i64..30) {
            let t = Rational::from(p) / Rational::from(q);
            prop_assume!(p != 0);
            if let Some(tangent) = doubled(&t) {
                let [a, b] = both_ways(&rational_root(&t), rational_root(&tangent));
                prop_assert_eq!(a.compare(&b), Ordering::Equal);
                prop_assert_eq!(b.compare(&a), Ordering::Equal);
                prop_assert_eq!(b.plus_pi().compare(&a.plus_pi()), Ordering::Equal);
                prop_assert_eq!(a.plus_pi().compare(&b), Ordering::Greater);
            }
            // With t = √c, 2t/(1 − t²) is a root of (1 − c)² z² − 4c.
            for half in real_roots(&poly(&[-c, 0, 1])) {
                let square = (1 - c) * (1 - c);
                let all = real_roots(&(poly(&[-4 * c, 0, square]) * poly(&[-7, 0, 3])));
                // 2t/(1 − t²) < 0 exactly for t > 1.
                let tangent = all.into_iter().find(|z| {
                    z.signum() == -half.signum() && z.is_root_of(&poly(&[-4 * c, 0, square]))
                });
                let [a, b] = both_ways(&half, tangent.unwrap());
                prop_assert_eq!(a.compare(&b), Ordering::Equal);
                prop_assert_eq!(b.compare(&a), Ordering::Equal);
            }
            // x and x + π/2 have the half tangents t and −1/t, where 2 atan t = 2 atan(−1/t) ± π.
            let inverse = -t.recip().unwrap();
            let [a, b] = [&t, &inverse].map(|t| ExactAngle::of_half_tangent(rational_root(t)));
            let (low, high) = if a.compare(&b).is_lt() { (a, b) } else { (b, a) };
            prop_assert_eq!(low.plus_pi().compare(&high), Ordering::Equal);
        }

        /// Multiples of π whose tangents are given as roots: tan(aπ/b) is a root of Im (1 + i t)^b.
        #[test]
        fn multiples_of_pi_are_equal_to_the_arctangents_that_they_are(b in 5u64..40, pick in 0usize..40) {
            let roots = real_roots(&sine_of_multiple(b));
            let root = &roots[pick % roots.len()];
            let angle = ExactAngle::of_tangent(root.clone());
            // The angle is in [0, π), so the nearest multiple is the right one.
            let (low, high) = angle.bounds(64);
            let of_pi = ((low + high) / Rational::from(2)).to_f64() / std::f64::consts::PI;
            #[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "a small number")]
            let a = (of_pi * b as f64).round() as i64;
            let exact = ExactAngle::Pi(Rational::from(a) / Rational::whole(Integer::from(b)));
            prop_assert_eq!(angle.compare(&exact), Ordering::Equal);
            prop_assert_eq!(exact.compare(&angle), Ordering::Equal);
            let by_half = ExactAngle::of_half_tangent(root.clone());
            let twice = ExactAngle::Pi(Rational::from(2 * a) / Rational::whole(Integer::from(b)));
            prop_assert_eq!(by_half.compare(&twice), Ordering::Equal);
            let near = ExactAngle::Pi(Rational::from(a) / Rational::whole(Integer::from(b)) + Rational::from_dyadic(Integer::from(1), -300));
            prop_assert_eq!(angle.compare(&near), Ordering::Less);
        }
    }

    #[test]
    fn angles_that_differ_in_a_far_bit_differ() {
        let tiny = Rational::from_dyadic(Integer::from(1), -20_000);
        let half = Rational::from(1) / Rational::from(3);
        let tangent = doubled(&half).unwrap();
        let by_half = ExactAngle::of_half_tangent(rational_root(&half));
        for (difference, order) in [
            (tiny.clone(), Ordering::Less),
            (-tiny.clone(), Ordering::Greater),
        ] {
            let other = ExactAngle::of_tangent(rational_root(&(&tangent + &difference)));
            assert_eq!(by_half.compare(&other), order);
            assert_eq!(other.compare(&by_half), order.reverse());
        }
        // Two angles of the same kind are compared as well.
        let [a, b] =
            [half.clone(), &half + &tiny].map(|t| ExactAngle::of_tangent(rational_root(&t)));
        assert_eq!(a.compare(&b), Ordering::Less);
        let quarter = ExactAngle::Pi(Rational::from(1) / Rational::from(5));
        let five = real_roots(&sine_of_multiple(5));
        let fifth = five.iter().find(|t| t.signum() > 0).unwrap();
        assert_eq!(
            ExactAngle::of_tangent(fifth.clone()).compare(&quarter),
            Ordering::Equal
        );
    }
}
