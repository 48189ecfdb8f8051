//! Parametric → implicit: laws, forms built backwards, and independent oracles.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use crate::common::forms::{patch, space};
use crate::common::radii;
use malachite::Integer;
use malachite::base::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::factor::factor_plane;
use stellate::implicitize::{
    SquaredForm, implicitize_patch, implicitize_plane, implicitize_space_curve, polar_plane,
};
use stellate::limits::Limits;
use stellate::poly::{IntegerPolynomial, PlanePolynomial, RationalFunction, SparsePolynomial};
use stellate::shape::{Parameter, PlaneCurve, SpaceCurve};

use crate::common::dense::integral;

fn polynomial(coefficients: &[i64]) -> IntegerPolynomial {
    let coefficients = coefficients.iter().map(|&c| Integer::from(c));
    IntegerPolynomial::from_coefficients_asc(coefficients.collect())
}

fn quotient(numerator: &[i64], denominator: &[i64]) -> Option<RationalFunction> {
    let [p, q] =
        [numerator, denominator].map(|f| f.iter().map(|&c| Rational::from(c)).collect::<Vec<_>>());
    RationalFunction::new(&p, &q)
}

fn function() -> impl Strategy<Value = RationalFunction> {
    let coefficients = || prop::collection::vec(-5i64..6, 1..5);
    let denominator = prop_oneof![Just(vec![1]), coefficients()];
    (coefficients(), denominator).prop_filter_map("a denominator", |(p, q)| quotient(&p, &q))
}

fn curves() -> impl Strategy<Value = PlaneCurve> {
    (function(), function())
        .prop_map(|(x, y)| PlaneCurve::new(Parameter::number("t"), [x, y]))
        .prop_filter("not a point", |c| !c.is_point())
}

/// f at a point, in num-rational's arithmetic.
fn value(f: &SparsePolynomial<3>, point: &[Rational]) -> BigRational {
    let big = |q: &Rational| q.to_string().parse::<BigRational>().unwrap();
    let zero = BigRational::from(BigInt::from(0));
    f.terms().fold(zero, |sum, (e, c)| {
        let powers = point
            .iter()
            .zip(e)
            .map(|(x, &k)| big(x).pow(i32::try_from(k).unwrap()));
        sum + powers.fold(big(c), |product, power| product * power)
    })
}

/// The equation of least degree at most `degree` through many points of a curve, by Gauss over the fractions of
/// num-rational: monomials one by one until one depends on those before it.
fn naive_equation(curve: &PlaneCurve, degree: usize) -> Option<PlanePolynomial> {
    let points: Vec<[BigRational; 2]> = (2i64..)
        .filter_map(|s| curve.point(&Rational::from(s)))
        .take((degree + 1) * (degree + 2))
        .map(|p| p.map(|v| v.to_string().parse().unwrap()))
        .collect();
    let zero = BigRational::from(BigInt::from(0));
    // Each basis vector: its values at the points, and how it is made of monomials.
    type Row = (Vec<BigRational>, BTreeMap<(usize, usize), BigRational>);
    let mut rows: Vec<(usize, Row)> = Vec::new();
    for total in 0..=degree {
        for i in 0..=total {
            let j = total - i;
            let power = |x: &BigRational, k: usize| x.pow(i32::try_from(k).unwrap());
            let mut values: Vec<_> = points
                .iter()
                .map(|[x, y]| power(x, i) * power(y, j))
                .collect();
            let mut made = BTreeMap::from([((i, j), BigRational::from(BigInt::from(1)))]);
            for (pivot, (other, other_made)) in &rows {
                let factor = &values[*pivot] / &other[*pivot];
                for (v, o) in values.iter_mut().zip(other) {
                    *v -= &factor * o;
                }
                for (e, c) in other_made {
                    *made.entry(*e).or_insert_with(|| zero.clone()) -= &factor * c;
                }
            }
            match values.iter().position(|v| *v != zero) {
                Some(pivot) => rows.push((pivot, (values, made))),
                None => {
                    let terms = made.into_iter();
                    let terms = terms.map(|(e, c)| (e, c.to_string().parse().unwrap()));
                    return Some(PlanePolynomial::from_terms(terms).primitive());
                }
            }
        }
    }
    None
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn an_equation_vanishes_on_its_curve_and_is_irreducible(curve in curves()) {
        let limits = Limits::none();
        let found = implicitize_plane(&curve, &limits).unwrap();
        let f = SparsePolynomial::<3>::from(found.curve.polynomial());
        for s in [-7, 2, 11] {
            if let Some(point) = curve.point(&Rational::from(s)) {
                prop_assert_eq!(value(&f, &point), BigRational::from(BigInt::from(0)));
            }
        }
        let factors = factor_plane(found.curve.polynomial(), &limits).unwrap().factors;
        prop_assert_eq!((factors.len(), factors[0].multiplicity), (1, 1));
        // The degree in x is that of y(s) over the tracing index.
        let degree = |v: usize| f.terms().map(|(e, _)| e[v] as usize).max().unwrap();
        let [x, y] = curve.coordinates();
        prop_assert_eq!(degree(0) * found.tracing_index, y.degree());
        prop_assert_eq!(degree(1) * found.tracing_index, x.degree());
    }

    #[test]
    fn the_polar_way_gives_the_same(curve in curves()) {
        let limits = Limits::none();
        match polar_plane(&curve, &limits) {
            Ok(polar) => prop_assert_eq!(polar.curve, implicitize_plane(&curve, &limits).unwrap().curve),
            Err(error) => {
                let text = error.to_string();
                prop_assert!(text.contains("x = 0") || text.contains("line through the origin"), "{}", text);
            }
        }
    }

    #[test]
    fn running_twice_over_a_curve_doubles_the_index(curve in curves(), a in -4i64..5, b in 1i64..5) {
        // s → (s² + a)/(b s)
        let limits = Limits::none();
        let inner = quotient(&[a, 0, 1], &[0, b]).unwrap();
        prop_assume!(inner.degree() == 2);
        let composed = curve.coordinates().each_ref().map(|f| {
            let [above, below] = f.coefficients().map(|p| {
                let zero = quotient(&[], &[1]).unwrap();
                p.iter().rev().fold(zero, |v, c| (&v * &inner).plus_constant(c))
            });
            &above * &below.recip().unwrap()
        });
        let twice = PlaneCurve::new(Parameter::number("t"), composed);
        let (once, twice) = (implicitize_plane(&curve, &limits).unwrap(), implicitize_plane(&twice, &limits).unwrap());
        prop_assert_eq!(twice.tracing_index, 2 * once.tracing_index);
        prop_assert_eq!(twice.curve, once.curve);
    }

    #[test]
    fn gauss_over_fractions_finds_the_same(curve in curves()) {
        let found = implicitize_plane(&curve, &Limits::none()).unwrap().curve;
        let degree = found.polynomial().degree().unwrap();
        prop_assume!(degree <= 4);
        let naive = naive_equation(&curve, degree);
        prop_assert_eq!(naive.as_ref(), Some(found.polynomial()));
    }

    #[test]
    fn a_patch_built_backwards_from_a_graph(
        terms in prop::collection::vec(([0u32..4, 0u32..4], -9i64..10), 1..5),
        shear in [-3i64..4, -3i64..4, -3i64..4],
    ) {
        // z = p(x, y) after x → x + a y, y → y + b z, z → z + c x of space.
        let p = SparsePolynomial::<2>::from_terms(terms.iter().map(|&(e, c)| (e, Rational::from(c))));
        prop_assume!(p.degree() > Some(0) && p.degree() <= Some(4));
        let [a, b, c] = shear;
        let formula = |p: &SparsePolynomial<2>, [x, y]: [&str; 2]| {
            let terms = p.terms().map(|(e, c)| format!("({c})*({x})^{}*({y})^{}", e[0], e[1]));
            terms.collect::<Vec<_>>().join(" + ")
        };
        let z = formula(&p, ["u", "v"]);
        let text = format!("x = u + ({a})*v; y = v + ({b})*({z}); z = {z} + ({c})*(u + ({a})*v)");
        // Backwards: z' = z − c x, y' = y − b z', x' = x − a y'.
        let (back_z, back_y) = (format!("(z - ({c})*x)"), format!("(y - ({b})*(z - ({c})*x))"));
        let back_x = format!("(x - ({a})*{back_y})");
        let expected = space(&format!("{back_z} - ({})", formula(&p, [&back_x, &back_y])));
        let found = implicitize_patch(&patch(&text), &Limits::none()).unwrap();
        prop_assert_eq!(found.surface.polynomial(), &expected, "{}", text);
        prop_assert_eq!(found.tracing_index, Some(1));
    }

    #[test]
    fn every_equation_of_a_space_curve_vanishes_on_it(x in function(), y in function(), z in function()) {
        let curve = SpaceCurve::new(Parameter::number("t"), [x, y, z]);
        prop_assume!(!curve.is_point());
        let found = implicitize_space_curve(&curve, &Limits::none()).unwrap();
        prop_assume!(found.degree <= 8);
        prop_assert!(found.surfaces.len() >= 2);
        let zero = BigRational::from(BigInt::from(0));
        for s in [-9, 4, 13] {
            if let Some(point) = curve.point(&Rational::from(s)) {
                for surface in &found.surfaces {
                    prop_assert_eq!(value(surface.polynomial(), &point), zero.clone());
                }
                // A point beside the curve, on a line that meets it once more at most seldom, is cut off.
                let beside = [&point[0] + &Rational::from(1), point[1].clone(), point[2].clone()];
                let all = found.surfaces.iter().all(|s| value(s.polynomial(), &beside) == zero);
                if all {
                    // Then it is on the curve: some parameter value gives it.
                    let common = curve.coordinates().iter().zip(&beside).fold(polynomial(&[]), |g, (f, v)| {
                        let [numerator, _] = f.plus_constant(&-v.clone()).coefficients();
                        stellate::poly::polynomial_gcd(&g, &integral(&numerator))
                    });
                    prop_assert!(common.coefficients_asc().len() != 1, "{:?}", beside);
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn a_radius_gives_the_polynomial_of_theorem_2(radius in radii(8)) {
        let form = SquaredForm::new(&radius).unwrap();
        let found = implicitize_plane(&radius.to_plane_curve(), &Limits::none()).unwrap();
        let expected = form.expand();
        prop_assert_eq!(found.curve.polynomial(), expected.polynomial());
        // Odd harmonics alone run over the curve twice.
        prop_assert_eq!(found.tracing_index, if form.is_perfect_square() { 2 } else { 1 });
    }
}
