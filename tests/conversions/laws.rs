//! Laws that hold for every input.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::implicitize::SquaredForm;
use stellate::parametrize::fourier_branches;
use stellate::poly::{BinaryForm, PlanePolynomial, Ring, SparsePolynomial};
use stellate::shape::FourierRadius;

use crate::common::{plane_polynomials, radii, rational, value_at};

fn implicit(r: &FourierRadius) -> PlanePolynomial {
    SquaredForm::new(r).unwrap().expand().polynomial().clone()
}

fn sparse(f: &PlanePolynomial) -> SparsePolynomial<3> {
    f.into()
}

/// A binary form of the given degree from the coefficients of a polynomial.
fn form(f: &PlanePolynomial, degree: usize) -> BinaryForm {
    let f = f.primitive();
    let coefficient = |k: usize| f.terms().nth(k).map(|(_, c)| c.numer()).unwrap_or_default();
    BinaryForm::new((0..=degree).map(coefficient))
}

fn ring_laws<R: Ring + PartialEq + std::fmt::Debug>(
    a: &R,
    b: &R,
    c: &R,
) -> Result<(), TestCaseError> {
    prop_assert_eq!(a.plus(b), b.plus(a));
    prop_assert_eq!(a.times(b), b.times(a));
    prop_assert_eq!(a.plus(b).plus(c), a.plus(&b.plus(c)));
    prop_assert_eq!(a.times(b).times(c), a.times(&b.times(c)));
    prop_assert_eq!(a.times(&b.plus(c)), a.times(b).plus(&a.times(c)));
    prop_assert_eq!(a.minus(b).plus(b), a.clone());
    prop_assert_eq!(a.squared(), a.times(a));
    Ok(())
}

proptest! {
    #[test]
    fn sparse_polynomials_are_a_ring(f in plane_polynomials(), g in plane_polynomials(), h in plane_polynomials()) {
        ring_laws(&sparse(&f), &sparse(&g), &sparse(&h))?;
    }

    #[test]
    fn forms_are_a_ring(f in plane_polynomials(), g in plane_polynomials(), h in plane_polynomials(), d in 0usize..9) {
        ring_laws(&form(&f, d), &form(&g, d), &form(&h, d))?;
    }

    #[test]
    fn products_of_plane_polynomials_are_those_of_sparse_ones(f in plane_polynomials(), g in plane_polynomials()) {
        let product = &f * &g;
        prop_assert!(product.check_invariants());
        prop_assert_eq!(sparse(&product), sparse(&f).times(&sparse(&g)));
        prop_assert_eq!(product.primitive().monic(), product.monic());
    }

    #[test]
    fn the_parts_have_three_degrees_and_the_origin_its_multiplicity(r in radii(9)) {
        let f = SquaredForm::new(&r).unwrap().expand_unreduced();
        let n = r.harmonics();
        let degrees = f.polynomial().homogeneous_degrees();
        prop_assert_eq!(degrees[0], 2 * n + 2);
        prop_assert_eq!(f.polynomial().lowest_degree(), Some(2 * n));
        prop_assert!(degrees.iter().all(|&d| d >= 2 * n));
    }

    /// F(r(θ) (cos θ, sin θ)) = 0 in rational directions, and F ≠ 0 just beside.
    #[test]
    fn f_vanishes_exactly_on_the_curve(r in radii(9), t in rational()) {
        let f = implicit(&r);
        let one = Rational::one();
        let w = &one + &t * &t;
        let (c, s) = ((&one - &t * &t) / &w, Rational::from(2) * &t / &w);
        let radius = value_at(&r, &c, &s);
        prop_assert!(f.evaluate(&(&radius * &c), &(&radius * &s)).is_zero());
        let beside = &radius + &"1/1000003".parse::<Rational>().unwrap();
        let opposite = -value_at(&r, &-c.clone(), &-s.clone());
        if beside != opposite && !beside.is_zero() {
            prop_assert!(!f.evaluate(&(&beside * &c), &(&beside * &s)).is_zero());
        }
    }

    #[test]
    fn there_and_back_is_the_identity(r in radii(12)) {
        let branches = fourier_branches(&SquaredForm::new(&r).unwrap().expand()).unwrap();
        prop_assert!(branches.radii.contains(&r), "{:?} not in {:?}", r, branches.radii);
    }

    /// Scaling the contour by λ scales the roots: F_λ(λx, λy) is a multiple of F(x, y).
    #[test]
    fn scaling_acts_as_it_should(r in radii(6), p in 1i64..20, q in 1i64..20) {
        let scale = Rational::from(p) / Rational::from(q);
        let times = |v: &[Rational]| v.iter().map(|c| c * &scale).collect();
        let scaled = FourierRadius::new(times(r.cosines()), times(r.sines()));
        let power = |e: usize| scale.pow(i64::try_from(e).unwrap()).unwrap();
        let back = PlanePolynomial::from_terms(
            implicit(&scaled).terms().map(|((i, j), c)| ((i, j), c * power(i + j))),
        );
        prop_assert_eq!(back.primitive(), implicit(&r));
    }

    /// A quarter turn of the contour is a quarter turn of F: (x, y) → (y, −x).
    #[test]
    fn rotation_acts_as_it_should(r in radii(6)) {
        // cos n(θ − π/2), sin n(θ − π/2)
        let (mut cos, mut sin) = (Vec::new(), Vec::new());
        for n in 0..=r.harmonics() {
            let (a, b) = (r.cos(n).clone(), r.sin(n).clone());
            let (a, b) = match n % 4 { 0 => (a, b), 1 => (-b, a), 2 => (-a, -b), _ => (b, -a) };
            cos.push(a);
            sin.push(b);
        }
        let turned = implicit(&FourierRadius::new(cos, sin));
        let back = PlanePolynomial::from_terms(implicit(&r).terms().map(|((i, j), c)| {
            // x → y, y → −x
            ((j, i), if j % 2 == 1 { -c } else { c })
        }));
        prop_assert_eq!(turned, back.primitive());
    }
}
