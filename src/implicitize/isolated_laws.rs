//! The laws of isolated points, on curves that are built from a known pair of conjugate parameters.

use malachite::Integer;
use malachite::base::polynomial::Polynomial;
use proptest::prelude::*;

use super::isolated::isolated;
use super::isolated_point::IsolatedPoint;
use super::tracing::tracing_index_bound;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, RationalFunction, Ring, polynomial_gcd};
use crate::roots::real_roots;

fn poly(c: &[i64]) -> IntegerPolynomial {
    IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
}

fn function(p: &IntegerPolynomial, q: &IntegerPolynomial) -> RationalFunction {
    RationalFunction::from_integers(p.clone(), q.clone()).unwrap()
}

fn found(x: &RationalFunction, y: &RationalFunction) -> super::isolated_point::Isolated {
    isolated([x, y], &Limits::none()).unwrap()
}

fn exact(x: i64, y: i64) -> IsolatedPoint {
    IsolatedPoint::Exact(vec![Rational::from(x), Rational::from(y)])
}

fn small(length: std::ops::Range<usize>) -> impl Strategy<Value = IntegerPolynomial> {
    prop::collection::vec(-6i64..7, length).prop_map(|c| poly(&c))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]
    /// x = (t² − S t + P) A/q and y = (t² − S t + P) B/q have the point (0, 0) at two conjugate parameters. It is isolated
    /// unless A and B have a common real root, or both functions are 0 at infinity.
    #[test]
    fn a_pair_is_isolated_unless_a_real_parameter_has_its_point(
        a in small(1..5), b in small(1..5), q in small(1..5),
        half in -3i64..4, more in 1i64..6, real in prop::option::of(-3i64..4), trigonometric in any::<bool>(),
    ) {
        // The roots are half ± i √more.
        let pair = poly(&[half * half + more, -2 * half, 1]);
        let line = real.map_or(poly(&[1]), |r| poly(&[-r, 1]));
        let q = if trigonometric { poly(&[1, 0, 1]) * poly(&[1, 0, 1]) } else { q };
        prop_assume!(a != poly(&[]) && b != poly(&[]) && q != poly(&[]));
        prop_assume!(polynomial_gcd(&q, &pair).coefficients_asc().len() == 1);
        let (x, y) = (function(&(&pair * &a * &line), &q), function(&(&pair * &b * &line), &q));
        prop_assume!(tracing_index_bound(&[x.clone(), y.clone()]) == 1);
        let at_infinity = [&x, &y].iter().all(|f| f.evaluate_at_infinity() == Some(Rational::zero()));
        // Poles may cancel zeros, so the numerators in lowest terms are compared.
        let common = polynomial_gcd(x.numerator(), y.numerator());
        let is_reached = at_infinity || !real_roots(&common).is_empty();
        let found = found(&x, &y);
        prop_assert!(found.complete);
        prop_assert_eq!(found.points.contains(&exact(0, 0)), !is_reached, "{:?}", found);
        // Every claim holds: no real parameter reaches a rational point that is called isolated.
        for point in &found.points {
            if let IsolatedPoint::Exact(point) = point {
                let [f, g] = [(&x, &point[0]), (&y, &point[1])].map(|(f, v)| f.plus_constant(&-v.clone()));
                let common = polynomial_gcd(f.numerator(), g.numerator());
                prop_assert!(real_roots(&common).is_empty());
                prop_assert!(common.coefficients_asc().len() > 2);
            }
        }
    }

    /// The same in space, where a coordinate z = pair·C/q + m t separates the two parameters unless m = 0.
    #[test]
    fn a_pair_is_isolated_in_space_unless_a_coordinate_separates_it(
        factors in prop::array::uniform3(small(1..4)), q in small(1..4),
        half in -3i64..4, more in 1i64..6, real in prop::option::of(-3i64..4), m in -1i64..2, axis in 0usize..3,
    ) {
        let pair = poly(&[half * half + more, -2 * half, 1]);
        let line = real.map_or(poly(&[1]), |r| poly(&[-r, 1]));
        prop_assume!(q != poly(&[]) && polynomial_gcd(&q, &pair).coefficients_asc().len() == 1);
        let mut functions = factors.map(|a| function(&(&pair * &a * &line), &q));
        functions[axis] = functions[axis].plus(&function(&poly(&[0, m]), &poly(&[1])));
        prop_assume!(tracing_index_bound(&functions) == 1);
        let zero = Rational::zero();
        let at_infinity = functions.iter().all(|f| f.evaluate_at_infinity() == Some(zero.clone()));
        let common = |point: &[Rational]| {
            let differences = functions.iter().zip(point).map(|(f, v)| f.plus_constant(&-v.clone()));
            differences.fold(poly(&[]), |common, f| polynomial_gcd(&common, f.numerator()))
        };
        let origin = vec![zero; 3];
        let is_reached = at_infinity || !real_roots(&common(&origin)).is_empty();
        let found = isolated(functions.each_ref(), &Limits::none()).unwrap();
        prop_assert!(found.complete, "{:?}", functions);
        let holds_origin = found.points.contains(&IsolatedPoint::Exact(origin));
        prop_assert_eq!(holds_origin, m == 0 && !is_reached, "{:?}", found);
        for point in &found.points {
            if let IsolatedPoint::Exact(point) = point {
                prop_assert!(real_roots(&common(point)).is_empty() && common(point).coefficients_asc().len() > 2);
            }
        }
    }

    /// The isolated real points do not depend on the choice of the parameter.
    #[test]
    fn isolated_points_do_not_depend_on_the_parameter(p in small(2..5), r in small(2..5), q in small(1..4), m in -4i64..5) {
        let quadratic = poly(&[2, 1, 1]);
        prop_assume!(q != poly(&[]));
        let (x, y) = (function(&(&p * &quadratic), &q), function(&(&r * &quadratic), &q));
        prop_assume!(x.degree() > 1 && y.degree() > 1);
        prop_assume!(tracing_index_bound(&[x.clone(), y.clone()]) == 1);
        // The substitution t = (m u + 1)/(u + m + 3) has the determinant m² + 3m − 1, which is never 0.
        let moved = |f: &RationalFunction| {
            let (above, below) = (poly(&[1, m]), poly(&[m + 3, 1]));
            let form = |p: &IntegerPolynomial| {
                (0..=f.degree()).fold(poly(&[]), |sum, k| {
                    let c = p.coefficients_asc().get(k).cloned().unwrap_or_default();
                    let powers = (0..f.degree()).fold(poly(&[1]), |product, i| {
                        product * if i < k { &above } else { &below }
                    });
                    sum + powers * IntegerPolynomial::from_coefficients_asc(vec![c])
                })
            };
            function(&form(f.numerator()), &form(f.denominator()))
        };
        let (one, two) = (found(&x, &y), found(&moved(&x), &moved(&y)));
        prop_assert!(one.complete && two.complete);
        prop_assert_eq!(one.points.len(), two.points.len(), "{:?} {:?}", one, two);
        for point in &one.points {
            let near = |other: &IsolatedPoint| match (point, other) {
                (IsolatedPoint::Near(a), IsolatedPoint::Near(b)) => {
                    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-9 * (1.0 + a.abs()))
                }
                (a, b) => a == b,
            };
            prop_assert!(two.points.iter().any(near));
        }
    }
}

#[test]
fn points_that_a_real_branch_passes_through_are_not_isolated() {
    let one = poly(&[1]);
    // The parameters t = 0 and t = ±i have the point (0, 0).
    let passed = found(
        &function(&poly(&[0, 1, 0, 1]), &one),
        &function(&poly(&[0, 0, 1, 0, 1]), &one),
    );
    assert!(passed.complete && passed.points.is_empty());
    // The parameters t = ±i and t = ∞ have the point (0, 0).
    let q = poly(&[2, 0, 0, 0, 1]);
    let passed = found(
        &function(&poly(&[1, 0, 1]), &q),
        &function(&poly(&[0, 1, 0, 1]), &q),
    );
    assert!(passed.complete && passed.points.is_empty());
    // Only the parameters t = ±i have the point (0, 0).
    let alone = found(
        &function(&poly(&[1, 0, 1]), &one),
        &function(&poly(&[0, 1, 0, 1]), &one),
    );
    assert_eq!((alone.complete, alone.points), (true, vec![exact(0, 0)]));
}

/// With h = (t² − √2 t + 5)(t² + √2 t + 5), y = (t² + 5)/t + …h and x = …h, the two pairs of roots of h have the points (0,
/// ±√2). If x has a factor t² − 2 and y is chosen accordingly, t = ±√2 reach these points, too.
#[test]
fn irrational_points_are_decided_exactly() {
    let h = poly(&[25, 0, 8, 0, 1]);
    let y_above = poly(&[5, 0, 1]) * poly(&[18]) - poly(&[0, 0, 1]) * &h;
    let y = function(&y_above, &poly(&[0, 18]));
    let one = poly(&[1]);
    let reached = found(&function(&(&h * poly(&[-2, 0, 1])), &one), &y);
    assert!(reached.complete, "{reached:?}");
    let at_root = |points: &[IsolatedPoint]| {
        let near = |p: &&IsolatedPoint| match p {
            IsolatedPoint::Near(p) => {
                p[0].abs() < 1e-12 && (p[1].abs() - 2f64.sqrt()).abs() < 1e-12
            }
            IsolatedPoint::Exact(_) => false,
        };
        points.iter().filter(near).count()
    };
    assert_eq!(at_root(&reached.points), 0, "{reached:?}");
    let alone = found(&function(&(&h * poly(&[-3, 0, 1])), &one), &y);
    assert!(alone.complete, "{alone:?}");
    assert_eq!(at_root(&alone.points), 2, "{alone:?}");
}

#[test]
fn a_point_that_conjugate_cusps_have_is_isolated() {
    let circle = poly(&[1, 0, 1]);
    let square = &circle * &circle;
    let (x, y) = (
        function(&square, &poly(&[1])),
        function(&(&square * poly(&[0, 1])), &poly(&[1])),
    );
    let found = found(&x, &y);
    assert_eq!((found.complete, found.points), (true, vec![exact(0, 0)]));
}

/// No coordinate plane shows (t⁶, t¹⁰, t¹⁵) as run over once.
#[test]
fn a_curve_that_no_coordinate_plane_shows_once_is_searched() {
    let one = poly(&[1]);
    let powers = [6, 10, 15].map(|n| {
        let mut power = vec![0; n + 1];
        power[n] = 1;
        function(&poly(&power), &one)
    });
    let monomial = isolated(powers.each_ref(), &Limits::none()).unwrap();
    assert!(monomial.complete && monomial.points.is_empty());
}
