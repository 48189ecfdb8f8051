//! Rational points of `Z² = A X² + B Y²`. Hilbert symbols decide whether there is one, and Lagrange's descent finds it.
//!
//! Serre, *A Course in Arithmetic*, chapters III (Hilbert symbols) and IV (the theorem of Hasse and Minkowski);
//! Cremona & Rusin, *Efficient solution of rational conics*, §2 (descent).

use std::fmt;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{
    Abs, DivExact, DivRem, Gcd, JacobiSymbol, Mod, ModInverse, ModSqrt, Parity,
};
use malachite::base::num::basic::traits::{One, Zero};

use super::integers::Factored;
use crate::error::Invariant;

/// A completion of Q.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The real numbers.
    Real,
    /// The p-adic numbers.
    Prime(u64),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Real => f.write_str("real numbers"),
            Self::Prime(p) => write!(f, "{p}-adic numbers"),
        }
    }
}

/// The answer about rational points of `Z² = A X² + B Y²`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Solution {
    /// A point [X, Y, Z] whose coordinates are not all 0.
    Point([Integer; 3]),
    /// There is no point over this completion of Q, so there is none over Q.
    None(Place),
    /// It is not decided, because this number was not factored.
    NotDecided(Integer),
}

/// Finds a rational point of `Z² = A X² + B Y²` with A, B ≠ 0, or a place without a point. A and B are given as products, which
/// are easier to factor.
///
/// By the theorem of Hasse and Minkowski there is a rational point exactly if there is a real one and
/// a p-adic one for every p that divides 2AB.
pub(super) fn solve(a: &[Integer], b: &[Integer]) -> Solution {
    let (of_a, of_b) = match (Factored::of_product(a), Factored::of_product(b)) {
        (Ok(of_a), Ok(of_b)) => (of_a, of_b),
        (Err(hard), _) | (_, Err(hard)) => return Solution::NotDecided(hard),
    };
    let ((root_a, free_a), (root_b, free_b)) = (of_a.square_part(), of_b.square_part());
    if let Some(place) = obstruction(&free_a, &free_b) {
        return Solution::None(place);
    }
    match descend(&free_a, &free_b) {
        Ok([x, y, z]) => Solution::Point([x * &root_b, y * &root_a, z * root_a * root_b]),
        Err(hard) => Solution::NotDecided(hard),
    }
}

/// A place at which the Hilbert symbol of two squarefree numbers is −1. The real place is tried first, then odd primes, then 2.
fn obstruction(a: &Factored, b: &Factored) -> Option<Place> {
    if a.negative && b.negative {
        return Some(Place::Real);
    }
    let mut primes: Vec<u64> = a.primes.iter().chain(&b.primes).map(|(p, _)| *p).collect();
    primes.sort_unstable();
    primes.dedup();
    primes.retain(|p| *p != 2);
    primes.push(2);
    let (a, b) = (a.value(), b.value());
    let bad = primes.into_iter().find(|p| hilbert(&a, &b, *p) < 0);
    bad.map(Place::Prime)
}

/// The Hilbert symbol (a, b) at p for squarefree a, b.
fn hilbert(a: &Integer, b: &Integer, p: u64) -> i8 {
    let split = |n: &Integer| {
        let (quotient, remainder) = n.div_rem(Integer::from(p));
        if remainder == 0 {
            (1, quotient)
        } else {
            (0, n.clone())
        }
    };
    let ((alpha, u), (beta, v)) = (split(a), split(b));
    if p == 2 {
        // (−1)^(ε(u) ε(v) + α ω(v) + β ω(u)), ε(n) = (n−1)/2, ω(n) = (n²−1)/8
        let residue = |n: &Integer| residue(n, 8);
        let epsilon = |r: u64| (r / 2) % 2;
        let omega = |r: u64| u64::from(r == 3 || r == 5);
        let (u, v) = (residue(&u), residue(&v));
        let exponent = epsilon(u) * epsilon(v) + alpha * omega(v) + beta * omega(u);
        return if exponent.even() { 1 } else { -1 };
    }
    let symbol = |n: &Integer| residue(n, p).jacobi_symbol(p);
    let mut sign = if alpha * beta * (p % 4 / 2) == 1 {
        -1
    } else {
        1
    };
    if beta == 1 {
        sign *= symbol(&u);
    }
    if alpha == 1 {
        sign *= symbol(&v);
    }
    sign
}

/// The residue of n modulo p.
fn residue(n: &Integer, p: u64) -> u64 {
    u64::try_from(&n.mod_op(Integer::from(p))).invariant("a residue is below the modulus")
}

/// Lagrange's descent for squarefree a, b without an obstruction. The error is a number that was not factored.
///
/// With r² ≡ a modulo b and |r| ≤ |b|/2, `r² − a = b b₁ m²` has |b₁| < |b|, and a point for (a, b₁) gives one for (a, b)
/// by multiplying norms: `(Z² − aX²)(r² − a) = (rZ + aX)² − a(Z + rX)²`.
fn descend(a: &Factored, b: &Factored) -> Result<[Integer; 3], Integer> {
    let (in_a, in_b) = (a.value(), b.value());
    let (zero, one) = (Integer::ZERO, Integer::ONE);
    if in_a == 1 {
        return Ok([one.clone(), zero, one]);
    }
    if in_b == 1 {
        return Ok([zero, one.clone(), one]);
    }
    if in_a == -&in_b {
        return Ok([one.clone(), one, zero]);
    }
    if (&in_a).abs() > (&in_b).abs() {
        let [x, y, z] = descend(b, a)?;
        return Ok([y, x, z]);
    }
    let root = root_modulo(&in_a, b).ok_or_else(|| in_b.clone())?;
    let quotient = (&root * &root - &in_a).div_exact(&in_b);
    let factored = Factored::of(&quotient).ok_or_else(|| quotient.clone())?;
    let (m, next) = factored.square_part();
    let [x, y, z] = descend(a, &next)?;
    Ok(primitive([
        &z + &root * &x,
        next.value() * m * y,
        root * z + in_a * x,
    ]))
}

/// An r with r² ≡ a modulo a squarefree number, and with |r| at most half of that number; `None` if there is none.
fn root_modulo(a: &Integer, modulus: &Factored) -> Option<Integer> {
    let (mut root, mut product) = (Integer::ZERO, Integer::ONE);
    for &(p, _) in &modulus.primes {
        let value = residue(a, p);
        let r = if p == 2 || value == 0 {
            value
        } else {
            value.mod_sqrt(p)?
        };
        // root + product · ((r − root)/product mod p)
        let inverse = if p == 2 {
            1
        } else {
            residue(&product, p).mod_inverse(p)?
        };
        let difference = Integer::from(r) - &root;
        let step = residue(&(difference * Integer::from(inverse)), p);
        root += &product * Integer::from(step);
        product *= Integer::from(p);
    }
    if &root + &root > product {
        root -= product;
    }
    Some(root)
}

/// The integers, divided by their greatest common divisor.
pub(super) fn primitive<const N: usize>(values: [Integer; N]) -> [Integer; N] {
    let mut common = Integer::ZERO;
    for v in &values {
        common = Integer::from(common.unsigned_abs_ref().gcd(v.unsigned_abs_ref()));
    }
    if common == 0 {
        return values;
    }
    values.map(|v| v.div_exact(&common))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn solved(a: i64, b: i64) -> Solution {
        solve(&[Integer::from(a)], &[Integer::from(b)])
    }

    #[test]
    fn places_without_a_point() {
        assert_eq!(solved(-1, -1), Solution::None(Place::Real));
        assert_eq!(solved(3, 3), Solution::None(Place::Prime(3)));
        assert_eq!(solved(2, 3), Solution::None(Place::Prime(3)));
        assert_eq!(solved(-1, 7), Solution::None(Place::Prime(7)));
        assert!(matches!(solved(2, 7), Solution::Point(_)));
    }

    /// Whether Z² = aX² + bY² has a solution in small coprime numbers, by trial.
    fn small_solution(a: i64, b: i64, bound: i64) -> bool {
        let is_square = |n: i64| n >= 0 && n.isqrt().pow(2) == n;
        (0..=bound)
            .any(|x| (0..=bound).any(|y| (x != 0 || y != 0) && is_square(a * x * x + b * y * y)))
    }

    proptest! {
        #[test]
        fn a_point_or_a_proof(a in -200i64..200, b in -200i64..200) {
            prop_assume!(a != 0 && b != 0);
            match solved(a, b) {
                Solution::Point([x, y, z]) => {
                    prop_assert!(x != 0 || y != 0 || z != 0);
                    prop_assert_eq!(&z * &z, Integer::from(a) * &x * &x + Integer::from(b) * &y * &y);
                }
                Solution::None(_) => prop_assert!(!small_solution(a, b, 40)),
                Solution::NotDecided(_) => prop_assert!(false, "these are small"),
            }
        }

        #[test]
        fn a_point_that_was_put_there_is_never_denied(x in 1i64..1000, y in 1i64..1000, z in 1i64..1000, a in -5000i64..5000) {
            // Up to scaling, (A, B) = (a, z² − a x²) has the point (x, 1, z).
            let b = z * z - a * x * x;
            prop_assume!(a != 0 && b != 0);
            let Solution::Point([u, v, w]) = solved(a, b) else {
                return Err(TestCaseError::fail("there is a point"));
            };
            prop_assert!(u != 0 || v != 0 || w != 0);
            prop_assert_eq!(&w * &w, Integer::from(a) * &u * &u + Integer::from(b) * &v * &v);
            // Multiplied by squares, the equation has a point as well.
            let scaled = solved(a * y * y, b);
            prop_assert!(matches!(scaled, Solution::Point(_)));
        }
    }
}
