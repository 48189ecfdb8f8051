//! Laws of the split over imaginary quadratic fields.

use super::*;
use proptest::prelude::*;

fn random(coefficients: &[i64], degree: u64) -> SparsePolynomial<3> {
    let terms = monomials(degree).into_iter().zip(coefficients);
    SparsePolynomial::from_terms(terms.map(|(e, c)| (e, Rational::from(*c))))
}

/// Whether both pairs have the same span, so the same common zeros.
fn have_one_span(a: &[SparsePolynomial<3>; 2], b: &[SparsePolynomial<3>; 2]) -> bool {
    let [a, b] = [a, b].map(|pair| reduced(pair[0].clone(), pair[1].clone()));
    a.iter().all(|f| {
        b.iter()
            .any(|g| f == g || *f == g.scaled(&Rational::from(-1)))
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// A norm that is built from g and h is split into them.
    #[test]
    fn norms_are_split(c in prop::collection::vec(-4i64..5, 30), square in 1i64..12, first in 1u64..3, second in 1u64..3) {
        let (g, h) = (random(&c[..10], first), random(&c[10..20], second));
        let f = g.squared().plus(&h.squared().scaled(&Rational::from(square)));
        let factors = crate::factor::factor_space(&f, &Limits::none()).unwrap().factors;
        prop_assume!(factors.len() == 1 && factors[0].multiplicity == 1 && f.degree().unwrap() > 0);
        prop_assume!(h.degree() > Some(0) && g.degree() > Some(0));
        let found = conjugate_pair(&factors[0].polynomial, &Limits::none()).unwrap();
        let pair = found.expect("f is a norm");
        prop_assert!(have_one_span(&pair, &[g.primitive(), h.primitive()]) || pair.iter().any(|f| f.degree() < g.degree().max(h.degree())), "{pair:?}");
        // Every common zero of the pair is one of f: f is a form of degree 2 in g and h.
        let [a, b] = &pair;
        let at = [1, 2, 3].map(Rational::from);
        prop_assert!(!a.evaluate(&at).is_zero() || !b.evaluate(&at).is_zero() || f.evaluate(&at).is_zero());
    }

    /// What changes its sign, or is a norm from a real field, or a sum of three squares, has no pair.
    #[test]
    fn other_polynomials_are_not_split(c in prop::collection::vec(-4i64..5, 30), square in 2i64..4) {
        let (g, h) = (random(&c[..10], 2), random(&c[10..20], 2));
        for f in [g.clone(), g.squared().minus(&h.squared().scaled(&Rational::from(square)))] {
            let factors = crate::factor::factor_space(&f, &Limits::none()).unwrap().factors;
            prop_assume!(factors.len() == 1 && factors[0].multiplicity == 1 && f.degree().unwrap() > 1);
            let is_definite = !changes_sign(&f);
            let found = conjugate_pair(&factors[0].polynomial, &Limits::none()).unwrap();
            prop_assert!(found.is_none() || is_definite);
        }
        let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
        let three = x.squared().plus(&y.squared()).plus(&z.squared());
        prop_assert!(conjugate_pair(&three, &Limits::none()).unwrap().is_none());
    }
}

#[test]
fn a_circle_in_space_is_found() {
    let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
    let one = SparsePolynomial::constant(Rational::one());
    let ring = x.squared().plus(&y.squared()).minus(&one);
    let f = ring.squared().plus(&z.squared());
    let pair = conjugate_pair(&f, &Limits::none()).unwrap();
    assert_eq!(pair, Some([z.clone(), ring.clone()]));
    // The same circle with a tangent plane that is counted twice: (x² + y² − 1)² + z⁴
    let f = ring.squared().plus(&z.squared().squared());
    assert_eq!(
        conjugate_pair(&f, &Limits::none()).unwrap(),
        Some([z, ring])
    );
}
