//! Independent oracles: other arithmetic, naive algorithms.

use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::implicitize::SquaredForm;
use stellate::poly::PlanePolynomial;

use crate::common::oracle_theorem_2::theorem_2 as theorem_2_oracle;
use crate::common::{plane_polynomials, radii, rational};

fn num(q: &Rational) -> BigRational {
    BigRational::from(q)
}

proptest! {
    /// The direct formula with num-rational and schoolbook multiplication.
    #[test]
    fn theorem_2_is_the_printed_formula(r in radii(7)) {
        let f = SquaredForm::new(&r).unwrap().expand_unreduced();
        prop_assert!(f.polynomial().check_invariants());
        let naive: Vec<_> = theorem_2_oracle(&r);
        let ours: Vec<_> = f.polynomial().monic().terms().collect();
        prop_assert_eq!(ours.len(), naive.len());
        for ((e, c), (e2, c2)) in ours.into_iter().zip(naive) {
            prop_assert_eq!(e, e2);
            prop_assert_eq!(num_rational::BigRational::from(&c), c2);
        }
    }

    /// Every operation on rationals agrees with num-rational's.
    #[test]
    fn rationals_are_num_rationals(a in rational(), b in rational()) {
        let (p, q) = (num(&a), num(&b));
        prop_assert_eq!(num(&(&a + &b)), &p + &q);
        prop_assert_eq!(num(&(&a - &b)), &p - &q);
        prop_assert_eq!(num(&(&a * &b)), &p * &q);
        prop_assert_eq!(a.cmp(&b), p.cmp(&q));
        if !b.is_zero() {
            prop_assert_eq!(num(&(&a / &b)), &p / &q);
        }
        prop_assert_eq!(Rational::from(p.clone()), a.clone());
        prop_assert_eq!(a.is_integer(), BigInt::try_from(&a).is_ok());
        prop_assert_eq!(a.floor().to_string(), p.floor().to_integer().to_string());
    }

    /// Values of plane polynomials, by the sum of their terms in num-rational.
    #[test]
    fn values_are_sums_of_terms(f in plane_polynomials(), x in rational(), y in rational()) {
        let power = |b: &BigRational, e: usize| (0..e).fold(BigRational::from(BigInt::from(1)), |p, _| p * b);
        let (p, q) = (num(&x), num(&y));
        let sum: BigRational = f.terms().map(|((i, j), c)| num(&c) * power(&p, i) * power(&q, j)).sum();
        prop_assert_eq!(num(&f.evaluate(&x, &y)), sum);
    }

    /// Translation moves the argument.
    #[test]
    fn translation_is_evaluation_elsewhere(f in plane_polynomials(), x in rational(), y in rational(), a in rational(), b in rational()) {
        let moved: PlanePolynomial = f.translated(&a, &b);
        prop_assert!(moved.check_invariants());
        prop_assert_eq!(moved.evaluate(&x, &y), f.evaluate(&(&x - &a), &(&y - &b)));
    }
}
