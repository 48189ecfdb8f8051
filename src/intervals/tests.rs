//! The laws of fields, and inputs for the laws of the other files in this folder.

use super::*;
use crate::poly::Ring;
use proptest::prelude::*;

/// The polynomial x² + y² + z² − c.
pub(crate) fn sphere(c: i64) -> SparsePolynomial<3> {
    let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
    let squares = x.squared().plus(&y.squared()).plus(&z.squared());
    squares.minus(&SparsePolynomial::constant(c.into()))
}

/// The cubic with these coefficients.
pub(crate) fn cubic(coefficients: &[i64]) -> SparsePolynomial<3> {
    let all = (0..4u32)
        .flat_map(|i| (0..4 - i).flat_map(move |j| (0..4 - i - j).map(move |k| [i, j, k])));
    SparsePolynomial::from_terms(all.zip(coefficients.iter().map(|c| Rational::from(*c))))
}

/// Cubics. Some of their coefficients have mantissas of all ones, are powers of two or their neighbours, or are so small that
/// they vanish.
pub(crate) fn nasty_cubics() -> impl Strategy<Value = SparsePolynomial<3>> {
    let coefficient = prop_oneof![
        4 => (-9i64..10).prop_map(Rational::from),
        1 => Just(Rational::zero()),
        2 => any::<i64>().prop_map(Rational::from),
        1 => (1u32..62, -1i64..2, any::<bool>()).prop_map(|(k, off, negative)| {
            let near = (1i64 << k) + off;
            Rational::from(if negative { -near } else { near })
        }),
        1 => (any::<i64>(), -1140i64..-60).prop_map(|(m, e)| Rational::from(m) * Rational::from(2).pow(e).unwrap()),
    ];
    let coefficients = prop::collection::vec(coefficient, 20);
    let all = prop_oneof![
        3 => coefficients.clone(),
        // Cubics with few terms, so that no error is hidden by those of other terms.
        2 => (coefficients, any::<u32>(), any::<u32>()).prop_map(|(c, a, b)| {
            let kept = |k: usize| a & b & 1 << k != 0;
            c.into_iter().enumerate().map(|(k, c)| if kept(k) { c } else { Rational::zero() }).collect()
        }),
    ];
    all.prop_filter_map("the polynomial 0", |c: Vec<Rational>| {
        let f = SparsePolynomial::from_terms(cubic(&[1; 20]).terms().map(|(e, _)| *e).zip(c));
        (!f.is_empty()).then_some(f)
    })
}

/// Points with nasty coordinates, or with coordinates whose products of two or three are near the smallest doubles.
pub(crate) fn nasty_points() -> impl Strategy<Value = [f64; 3]> {
    let small = (
        1.0f64..2.0,
        prop::sample::select(vec![-538, -537, -536, -359, -358, -357]),
    )
        .prop_map(|(x, e)| x * 2f64.powi(e));
    prop_oneof![
        2 => prop::array::uniform3(interval::tests::nasty()),
        2 => prop::array::uniform3(-3.0f64..3.0),
        1 => prop::array::uniform3(small),
    ]
}

/// The exact Taylor coefficient α!^(−1) ∂^α f at a point, by differentiation.
pub(crate) fn taylor_coefficient(
    f: &SparsePolynomial<3>,
    e: &[usize; 3],
    p: &[Rational; 3],
) -> Rational {
    let mut g = f.clone();
    let mut factorials = Rational::one();
    for (axis, k) in e.iter().enumerate() {
        for n in 1..=*k {
            g = g.derivative(axis);
            factorials = factorials * Rational::from(i64::try_from(n).unwrap());
        }
    }
    g.evaluate(p) / factorials
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    /// Lemma 4.
    #[test]
    fn values_are_within_their_bounds(f in nasty_cubics(), p in nasty_points()) {
        let field = Field::new(&f);
        let found = field.sums(p);
        prop_assert!(found.contains(&field.exact_value(p)), "{found:?} {p:?}");
        prop_assert_eq!(field.sign(p), field.exact_value(p).signum());
    }

    /// Lemma 5: as long as the sign is proved, the farthest corners have it.
    #[test]
    fn signs_nearby_are_those_of_the_point(f in nasty_cubics(), p in nasty_points()) {
        let field = Field::new(&f);
        let (mut low, mut high) = (0.0, 4.0);
        for _ in 0..1100 {
            let off = f64::midpoint(low, high);
            if field.sign_near(p, off).is_some() {
                low = off;
            } else {
                high = off;
            }
        }
        if let Some(sign) = field.sign_near(p, low) {
            for corner in 0..8u32 {
                let at = std::array::from_fn(|i| {
                    let off = rational(low);
                    rational(p[i]) + if corner >> i & 1 == 1 { off } else { -off }
                });
                prop_assert_eq!(field.polynomial().evaluate(&at).signum(), sign);
            }
        }
    }
}

/// The bound of an error is not much larger than the errors: some value has an error of an eighth of it.
#[test]
fn errors_of_values_are_reached() {
    let [x, y, _] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
    let third = Rational::from(1) / Rational::from(3);
    let forms = [
        x.clone(),
        x.scaled(&third).plus(&y),
        x.plus(&y.scaled(&third)),
        x.squared(),
    ];
    let mut most = 0.0f64;
    for f in forms {
        let field = Field::new(&f);
        for k in 0..200 {
            let p = [1.0 + f64::from(k) / 7.0, 1.0 + f64::from(k) / 11.0, 0.0];
            let found = field.sums(p);
            let error = (field.exact_value(p) - rational(field.value(p)))
                .abs()
                .to_f64();
            most = most.max(error / (found.high() - found.low()) * 2.0);
        }
    }
    assert!(most >= 0.125, "{most}");
}

/// x² underflows, and y magnifies the loss.
#[test]
fn losses_by_underflow_are_multiplied_by_the_other_factors() {
    let [x, y, _] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
    let f = Field::new(&x.squared().times(&y));
    for p in [
        [1e-170, 1e150, 1.0],
        [1e-180, 1e30, 0.0],
        [1e-300, 1e300, 0.0],
    ] {
        assert!(f.sums(p).contains(&f.exact_value(p)), "{p:?}");
    }
}

proptest! {
    /// Values and gradients in doubles, which have no bound, are nearly the exact ones.
    #[test]
    fn doubles_are_near_the_exact_values(c in prop::collection::vec(-9i64..10, 20), p in prop::array::uniform3(-3.0f64..3.0)) {
        let field = Field::new(&cubic(&c));
        let (value, gradient) = field.exact_value_and_gradient(&rationals(p));
        let (found, slopes) = field.value_and_gradient(p);
        let is_near = |found: f64, exact: &Rational| (found - exact.to_f64()).abs() < 1e-11;
        prop_assert!(is_near(found, &value) && is_near(field.value(p), &value));
        for (found, exact) in slopes.iter().zip(&gradient) {
            prop_assert!(is_near(*found, exact));
        }
        prop_assert_eq!(field.gradient(p).map(f64::to_bits), slopes.map(f64::to_bits));
        prop_assert_eq!(value, field.exact_value(p));
    }
}

#[test]
fn vectors_are_multiplied_and_measured() {
    let (a, b) = ([1.0, 2.0, 3.0], [5.0, -4.0, 0.5]);
    assert!((dot(a, b) + 1.5).abs() < 1e-15);
    assert!((distance(a, b) - (16.0f64 + 36.0 + 6.25).sqrt()).abs() < 1e-15);
    let quarter = between(a, b, 0.25);
    assert!(distance(quarter, [2.0, 0.5, 2.375]) < 1e-15);
}

#[test]
fn signs_are_exact_where_doubles_vanish() {
    // (x − y)² − 2⁻¹⁰⁰ z² near x = y.
    let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
    let small = Rational::from(2).pow(-100).unwrap();
    let f = Field::new(&x.minus(&y).squared().minus(&z.squared().scaled(&small)));
    assert_eq!(f.sign([1.0, 1.0, 1.0]), -1);
    assert_eq!(f.sign([1.0, 1.0, 0.0]), 0);
    // (4·2⁻⁵²)² = 2⁻¹⁰⁰.
    for (ulps, sign) in [(3.0, -1), (4.0, 0), (5.0, 1)] {
        assert_eq!(f.sign([1.0, 1.0 + ulps * f64::EPSILON, 1.0]), sign);
    }
}

proptest! {
    #[test]
    fn signs_in_integers_are_those_of_fractions(
        coefficients in prop::collection::vec((-9i64..=9, 1i64..9), 20),
        p in prop::array::uniform3((-20i32..20, -60i32..20)),
    ) {
        let f = cubic(&[1; 20]);
        let terms = f.terms().zip(&coefficients);
        let f = SparsePolynomial::from_terms(terms.filter_map(|((e, _), (p, q))| {
            Some((*e, Rational::from_integers((*p).into(), (*q).into())?))
        }));
        prop_assume!(!f.is_empty());
        let f = Field::new(&f);
        // Small mantissas, so that some of the points are zeros.
        let p = p.map(|(m, e)| f64::from(m) * 2f64.powi(e / 3));
        prop_assert_eq!(f.exact_sign(p), f.exact_value(p).signum());
        prop_assert_eq!(f.sign(p), f.exact_sign(p));
    }
}
