//! The laws of [`roots_of`]: it finds all real roots of polynomials with known roots, and it succeeds for most of them.

use malachite::Integer;
use malachite::base::polynomial::Polynomial;

use super::draw::Draw;
use super::*;
use crate::exact::Rational;

/// The polynomial f · (q x − p), ascending.
fn with_root(f: &[Integer], [p, q]: [&Integer; 2]) -> Vec<Integer> {
    let mut product = vec![Integer::from(0); f.len() + 1];
    for (i, c) in f.iter().enumerate() {
        product[i] -= c * p;
        product[i + 1] += c * q;
    }
    product
}

/// The polynomial f · (a x² + b) with a, b > 0, whose second factor has no real root.
fn with_none(f: &[Integer], a: &Integer, b: &Integer) -> Vec<Integer> {
    let mut product = vec![Integer::from(0); f.len() + 2];
    for (i, c) in f.iter().enumerate() {
        product[i] += c * b;
        product[i + 2] += c * a;
    }
    product
}

/// The sign of the value at a dyadic number.
fn sign_at(f: &[Integer], x: &Rational) -> i8 {
    let value = f
        .iter()
        .rev()
        .fold(Rational::zero(), |sum, c| sum * x + Rational::whole(c));
    value.signum()
}

/// A small count as a double.
#[expect(clippy::cast_precision_loss, reason = "a degree")]
fn float(count: usize) -> f64 {
    count as f64
}

/// The number of random polynomials that were decided.
fn decided<const W: usize>(draw: &mut Draw, count: usize, longest: f64) -> usize {
    let mut decided = 0;
    for _ in 0..count {
        let mut roots: Vec<Rational> = (0..1 + draw.below(6))
            .map(|_| {
                let sign = if draw.below(2) == 0 { 1 } else { -1 };
                let size = draw.below(1 << 20) as i64 + 1;
                let down = draw.below(40) as i64;
                // An odd number over a power of 3 is not a point of bisection.
                Rational::from_dyadic(Integer::from(sign * (2 * size + 1)), -down)
                    / Rational::from(3i64.pow(12))
            })
            .collect();
        roots.sort();
        roots.dedup();
        let mut f = vec![Integer::from(1)];
        for root in &roots {
            f = with_root(&f, [&root.numerator(), &root.denominator()]);
        }
        for _ in 0..draw.below(3) {
            let [a, b] = [0, 0].map(|_: i32| Integer::from(1 + draw.below(1 << 30)));
            f = with_none(&f, &a, &b);
        }
        let balls: Vec<_> = f.iter().map(ScaledBall::<W>::of_integer).collect();
        let Ok(found) = roots_of(&balls, longest) else {
            continue;
        };
        decided += 1;
        let mut enclosures: Vec<_> = found.into_iter().map(BoundedRoot::to_dyadic).collect();
        enclosures.sort_by(|a, b| a.0.cmp(&b.0));
        assert_eq!(enclosures.len(), roots.len(), "{f:?}");
        for ((low, high, sign_low), root) in enclosures.iter().zip(&roots) {
            let (low, high) = (low.to_rational(), high.to_rational());
            assert!(low < *root && *root < high, "{root}");
            assert_eq!(
                (sign_at(&f, &low), sign_at(&f, &high)),
                (*sign_low, -sign_low)
            );
            let width = ((high - low) / root.abs()).to_f64();
            assert!(width <= 8.0 * longest, "{width}");
        }
    }
    decided
}

#[test]
fn all_roots_are_found_where_bits_suffice() {
    let mut draw = Draw(1);
    assert!(decided::<4>(&mut draw, 200, FOR_DOUBLES) >= 190);
    assert!(decided::<6>(&mut draw, 100, FOR_REFINEMENT) >= 95);
    assert!(decided::<2>(&mut draw, 100, FOR_REFINEMENT) >= 20);
    assert!(decided::<12>(&mut draw, 100, FOR_DOUBLES) >= 95);
}

#[test]
fn what_may_vanish_is_not_decided() {
    let none: [ScaledBall<2>; 0] = [];
    assert!(roots_of(&none, FOR_DOUBLES).is_err());
    assert!(roots_of(&[ScaledBall::<2>::ZERO], FOR_DOUBLES).is_err());
    let one = ScaledBall::<2>::of_integer(&Integer::from(1));
    assert!(roots_of(&[one], FOR_DOUBLES).is_ok_and(|roots| roots.is_empty()));
    assert!(roots_of(&[ScaledBall::ZERO, one], FOR_DOUBLES).is_err());
    assert!(roots_of(&[one, ScaledBall::ZERO], FOR_DOUBLES).is_err());
    // A double root.
    let square: Vec<_> = [1, -2, 1]
        .map(|c| ScaledBall::<2>::of_integer(&Integer::from(c)))
        .to_vec();
    assert!(roots_of(&square, FOR_DOUBLES).is_err());
    let long = vec![one; MAX_DEGREE + 2];
    assert!(matches!(roots_of(&long, FOR_DOUBLES), Err(Unproved::Close)));
}

/// x^d − 2 has two roots for every even d up to the largest degree for which there are tables.
#[test]
fn the_largest_degree_is_decided() {
    let polynomial = |degree: usize| {
        let mut coefficients = vec![Integer::from(0); degree + 1];
        coefficients[0] = Integer::from(-2);
        coefficients[degree] = Integer::from(1);
        IntegerPolynomial::from_coefficients_asc(coefficients)
    };
    for degree in [2, 4, MAX_DEGREE - 2, MAX_DEGREE] {
        let f = polynomial(degree);
        let mut roots = bounded_roots::<4>(&f).expect("simple roots");
        roots.sort_by(|a, b| a.0.cmp(&b.0));
        assert_eq!(roots.len(), 2);
        let root = 2f64.powf(1.0 / float(degree));
        for ((low, high, sign), expected) in roots.iter().zip([-root, root]) {
            let [low, high] = [low, high].map(Dyadic::to_rational);
            let bounds = [&low, &high].map(|end| sign_at(f.coefficients_asc(), end));
            assert_eq!(bounds, [*sign, -sign]);
            assert!((low.to_f64() - expected).abs() < 2.0 * FOR_REFINEMENT);
            assert!(((high - low) / Rational::from(2)).to_f64() < 2.0 * FOR_REFINEMENT);
        }
    }
    for degree in [MAX_DEGREE + 1, MAX_DEGREE + 2] {
        let found = bounded_roots::<4>(&polynomial(degree));
        assert!(matches!(found, Err(Unproved::Close)));
    }
}

/// 2^k y is below 1/2, and 2^(k + 1) y is not.
#[test]
fn small_numbers_are_scaled_up_to_a_quarter() {
    for y in [0.9, 0.5, 0.49, 0.25, 0.2, 0.1, 1e-3, 1e-30, 1e-200] {
        let scaled = y * f64::from(drop_to_quarter(y)).exp2();
        assert!(
            scaled >= 0.25 && (scaled < 0.5 || drop_to_quarter(y) == 0),
            "{y}"
        );
    }
    assert_eq!(drop_to_quarter(0.0), 1000);
}
