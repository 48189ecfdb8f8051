//! Float programs against exact: laws and oracles of the comparison.

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use proptest::prelude::*;
use stellate::check::{
    Comparison, FloatTheorem2, GivenPoint, GivenRadius, InputsOf, Reference, compare_coefficients,
    ladder, test_vectors,
};
use stellate::exact::Rational;
use stellate::implicitize::SquaredForm;
use stellate::limits::Limits;
use stellate::poly::SparsePolynomial;
use stellate::shape::{FourierRadius, ImplicitCurve, ImplicitSurface};

use crate::common::float_program::{changed, checked, lopsided, rounded};
use crate::common::forms::{plane, space};
use crate::common::oracle_theorem_2::theorem_2;
use crate::common::{power_of_two, radii};

#[test]
fn where_theorem_2_gives_a_square_it_may_be_reduced_or_not() {
    // r = cos 3t + sin(t)/2
    let half = power_of_two(-1);
    let zero = Rational::zero;
    let radius = FourierRadius::new(vec![zero(), zero(), zero(), 1.into()], vec![zero(), half]);
    let form = SquaredForm::new(&radius).unwrap();
    let reference = Reference::of_radius(&radius).unwrap();
    for curve in [form.expand(), form.expand_unreduced()] {
        let found = reference.check_coefficients(&SparsePolynomial::from(curve.polynomial()));
        assert!(found.passes(None) && found.passes(Some(100)));
    }
    assert_eq!(
        rounded(&radius).len(),
        form.expand_unreduced().polynomial().term_count()
    );
    assert!(checked(&radius, &rounded(&radius)).passes(Some(15)));
}

#[test]
fn terms_that_are_missing_or_extra_are_said() {
    let reference = Reference::of_curve(&ImplicitCurve::new(plane("x^4 + 7y^2 + x*y = 3")));
    let got = |text: &str| {
        let found = reference.check_coefficients(&SparsePolynomial::from(&plane(text)));
        (
            found.rows.len(),
            found.missing.len(),
            found.extra.len(),
            found.passes(None),
        )
    };
    assert_eq!(got("x^4 + 7y^2 + x*y = 3"), (4, 0, 0, true));
    assert_eq!(got("x^4 + 7y^2 = 3"), (3, 1, 0, false));
    assert_eq!(got("x^4 + 7y^2 + x*y + x^2/10 = 3"), (4, 0, 1, false));
    // Beside coefficients of size 7 in its degree this is a rounding error.
    let noise = "x^4 + 7y^2 + x*y + x^2/100000000000000000 = 3";
    assert_eq!(got(noise), (4, 0, 1, true));
    let found = reference.check_coefficients(&SparsePolynomial::from(&plane(noise)));
    assert!(found.passes(Some(16)) && !found.passes(Some(18)));
}

fn circle(radius: i64) -> Reference {
    let square = radius * radius;
    Reference::of_curve(&ImplicitCurve::new(plane(&format!("x^2 + y^2 = {square}"))))
}

#[test]
fn points_beside_a_circle_and_a_sphere() {
    let limits = Limits::none();
    let point = |position| GivenPoint { line: 1, position };
    let eighth = 1.0 + 0.125;
    let found = circle(1)
        .check_points(
            &[
                point([eighth, 0.0, 0.0]),
                point([0.6, 0.8, 0.0]),
                point([0.0; 3]),
            ],
            &limits,
        )
        .unwrap();
    let [outside, near, origin] = &found.rows[..] else {
        panic!()
    };
    let residual = outside.residual.unwrap();
    // λ = 8/9, so |λ − 1|/λ = 1/8; f = 17/64, |∇f| = 9/4.
    assert!((outside.deviation.relative().unwrap().to_f64() - 0.125).abs() < 1e-15);
    assert!((outside.deviation.ulps - 0.125 * 2f64.powi(52)).abs() < 1.0);
    let bits = |v: [f64; 2]| v.map(f64::to_bits);
    assert_eq!(
        bits([residual.value, residual.first_order]),
        bits([17.0 / 64.0, 17.0 / 144.0])
    );
    // The doubles 0.6 and 0.8 are not on the circle, but within half an ulp.
    assert!(near.deviation.ulps > 0.0 && near.deviation.ulps <= 0.5 && near.deviation.reaches(16));
    assert!(origin.exact.is_none() && !origin.deviation.reaches(0));

    let sphere = Reference::of_surface(&ImplicitSurface::new(space("x^2 + y^2 + z^2 = 9")));
    let found = sphere
        .check_points(&[point([1.0, 2.0, 2.0]), point([2.0, 4.0, 4.0])], &limits)
        .unwrap();
    assert!(found.rows[0].deviation.reaches(1000));
    assert_eq!(
        found.rows[0].residual.unwrap().value.to_bits(),
        0f64.to_bits()
    );
    // Twice as far out as the exact 3.
    assert!((found.rows[1].exact.as_ref().unwrap().to_f64() - 3.0).abs() < 1e-15);
    assert!((found.rows[1].deviation.relative().unwrap().to_f64() - 1.0).abs() < 1e-15);
}

#[test]
fn the_nearest_branch_is_taken() {
    let f = plane("(x^2 + y^2 - 1)*(x^2 + y^2 - 4)*(x - 5)");
    let reference = Reference::of_curve(&ImplicitCurve::new(f));
    let limits = Limits::none();
    for (x, nearest) in [
        (1.1, 1.0),
        (1.9, 2.0),
        (-1.1, -1.0),
        (-9.0, -2.0),
        (3.6, 5.0),
        (3.4, 2.0),
    ] {
        let point = GivenPoint {
            line: 1,
            position: [x, 0.0, 0.0],
        };
        let found = reference.check_points(&[point], &limits).unwrap();
        let exact = found.rows[0].exact.as_ref().unwrap().to_f64();
        assert!((exact - f64::abs(nearest)).abs() < 1e-14, "{x}: {exact}");
        // The same by an angle that is enclosed, near the axis: there the line x = 5 is about as far.
        let radius = GivenRadius {
            line: 1,
            theta: 1e-9,
            r: x,
        };
        let found = reference.check_radii(&[radius], &limits).unwrap();
        let exact = found.rows[0].exact.as_ref().unwrap().to_f64();
        assert!((exact - nearest).abs() < 1e-14, "{x}: {exact}");
    }
}

#[test]
fn radii_at_angles_that_are_doubles() {
    let limits = Limits::none();
    let given = |theta: f64, r: f64| GivenRadius { line: 1, theta, r };
    let limacon = FourierRadius::new(vec![1.into(), 1.into()], vec![]);
    // 1 + cos 1, from a table: 1.5403023058681397174…
    let reference = Reference::of_radius(&limacon).unwrap();
    let found = reference
        .check_radii(&[given(1.0, 1.540_302_305_868_139_8)], &limits)
        .unwrap();
    assert_eq!(
        found.rows[0].exact.as_ref().unwrap().to_significant(20),
        "1.5403023058681397174"
    );
    assert!(found.rows[0].deviation.ulps < 0.5);
    // A curve whose radius at every angle is exactly 2, however its circle is written.
    let f = plane("(x^2 + y^2 - 4)*(x^3 + y - 100)");
    let reference = Reference::of_curve(&ImplicitCurve::new(f));
    let found = reference
        .check_radii(&[given(1.0, 2.0), given(2.5, 2f64.next_up())], &limits)
        .unwrap();
    assert!(found.rows[0].deviation.reaches(5000));
    assert!((found.rows[1].deviation.ulps - 1.0).abs() < 1e-6);
    // A double circle, and no real point at all.
    let double = Reference::of_curve(&ImplicitCurve::new(plane("(x^2 + y^2 - 4)^2*(x - 7)")));
    let found = double.check_radii(&[given(1.0, 3.0)], &limits).unwrap();
    assert!((found.rows[0].exact.as_ref().unwrap().to_f64() - 2.0).abs() < 1e-15);
    let nothing = Reference::of_curve(&ImplicitCurve::new(plane("x^4 + y^2 + 1")));
    let found = nothing
        .check_radii(&[given(1.0, 3.0), given(0.0, 3.0)], &limits)
        .unwrap();
    assert!(found.rows.iter().all(|row| row.exact.is_none()));
}

#[test]
fn numbers_of_any_size_are_compared() {
    let limits = Limits::none();
    // r = 2 + cos t, and its polynomial: near 2.54 at theta = 1.
    let radius = FourierRadius::new(vec![2.into(), 1.into()], vec![]);
    let curve = SquaredForm::new(&radius).unwrap().expand();
    for (theta, r) in [
        (1.0, 1e300),
        (1.0, 1e-300),
        (1.0, 5e-324),
        (1e300, 2.0),
        (1e-300, 3.0),
        (-0.0, 3.0),
    ] {
        let given = [GivenRadius { line: 1, theta, r }];
        let by_series = Reference::of_radius(&radius)
            .unwrap()
            .check_radii(&given, &limits)
            .unwrap();
        let by_polynomial = Reference::of_curve(&curve)
            .check_radii(&given, &limits)
            .unwrap();
        let exact = |found: &Comparison| found.rows[0].exact.as_ref().unwrap().to_significant(19);
        // For tiny radii the other branch, on the other side, is nearer.
        if r < 1.0 {
            assert_eq!(exact(&by_polynomial), "-1.459697694131860283");
        } else {
            assert_eq!(exact(&by_series), exact(&by_polynomial), "{theta} {r}");
        }
    }
    for x in [1e300, 5e-324, 1e-150] {
        let point = [GivenPoint {
            line: 1,
            position: [x, x, 0.0],
        }];
        let found = circle(3).check_points(&point, &limits).unwrap();
        let exact = found.rows[0].exact.as_ref().unwrap().to_f64().abs();
        assert!((exact - 3.0).abs() < 1e-15, "{x}: {exact}");
    }
}

#[test]
fn the_butterfly_in_doubles_loses_what_is_said() {
    // Fifty harmonics that fall off as those of an outline do.
    let size = |n: usize| Rational::from(1) / Rational::from(i64::try_from(n * n).unwrap() + 3);
    let (cos, sin): (Vec<_>, Vec<_>) = (0..51)
        .map(|n| (if n == 0 { 2.into() } else { size(n) }, -size(n + 1)))
        .unzip();
    let rungs = ladder(&FourierRadius::new(cos, sin), &Limits::none()).unwrap();
    let counts: Vec<usize> = rungs.iter().map(|r| r.harmonics).collect();
    assert_eq!(counts, [1, 2, 3, 5, 7, 10, 14, 20, 30, 39, 50]);
    let (first, at_39, last) = (&rungs[0], &rungs[9], &rungs[10]);
    assert!(first.coefficients.worst > 15.0 && first.near.median > 13.0);
    assert_eq!(first.sign_distance, Some(1e-14));
    assert!((6.0..14.0).contains(&at_39.near.median), "{at_39:?}");
    assert!(last.near.worst < first.near.worst - 4.0, "{last:?}");
    assert!(
        last.coefficients.worst < first.coefficients.worst - 2.0,
        "{last:?}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// The oracle: num-rational, by the printed formula.
    #[test]
    fn correctly_rounded_coefficients_have_all_their_digits(r in radii(7), factor in -20i32..20) {
        let mut got = rounded(&r);
        // What is rounded to a subnormal number or to 0 has lost digits, before it is multiplied or after.
        prop_assume!(got.iter().all(|(_, c)| c.is_normal()));
        for (_, c) in &mut got {
            *c *= 2f64.powi(factor);
        }
        prop_assume!(got.iter().all(|(_, c)| c.is_normal()));
        let found = checked(&r, &got);
        let scale = found.scale.clone().unwrap();
        prop_assert_eq!(scale.factor, power_of_two(i64::from(factor)));
        prop_assert!(found.missing.is_empty() && found.extra.is_empty());
        prop_assert!(found.rows.iter().all(|row| row.deviation.ulps <= 0.5));
        prop_assert!(found.passes(None) && found.passes(Some(15)));
    }

    /// Every relative error is what num-rational says.
    #[test]
    fn relative_errors_are_those_of_an_independent_arithmetic(
        r in radii(5), spoil in prop::collection::vec(-1e-6f64..1e-6, 40)
    ) {
        let exact = theorem_2(&r);
        let mut got = rounded(&r);
        prop_assume!(got.len() > 5 && got.iter().all(|(_, c)| c.is_normal()));
        // Less than half of the coefficients are spoiled: the factor is 1.
        for ((_, c), s) in got.iter_mut().skip(1).step_by(3).zip(&spoil) {
            *c += *c * s;
        }
        let found = checked(&r, &got);
        let factor = BigRational::from(&found.scale.clone().unwrap().factor);
        prop_assert!(factor.is_one());
        for ((row, (_, exact)), (_, c)) in found.rows.iter().zip(&exact).zip(&got) {
            let off = (BigRational::from_float(*c).unwrap() - exact).abs() / exact.abs();
            prop_assert_eq!(BigRational::from(row.deviation.relative().unwrap()), off.clone());
            let digits = if off.is_zero() { 17.0 } else { -off.to_f64().unwrap().log10() };
            prop_assert!((row.deviation.digits() - digits.clamp(0.0, 17.0)).abs() < 1e-9);
        }
    }

    /// The enclosed series and the polynomial on the enclosed ray see the same distance.
    #[test]
    fn the_radius_and_its_polynomial_agree(
        c in prop::collection::vec((-9i64..10, -9i64..10), 1..6), theta in -20f64..20.0, off in -1e-3f64..1e-3
    ) {
        // r > 0: the other branch is on the other side of the origin.
        let tenth = |v: i64| Rational::from(v) / Rational::from(100);
        let (mut cos, sin): (Vec<_>, Vec<_>) = c.iter().map(|&(a, b)| (tenth(a), tenth(b))).unzip();
        cos[0] = 2.into();
        let radius = FourierRadius::new(cos, sin);
        let limits = Limits::none();
        let given = [GivenRadius { line: 1, theta, r: radius.approximate(theta) * (1.0 + off) }];
        let by_series = Reference::of_radius(&radius).unwrap().check_radii(&given, &limits).unwrap();
        let curve = SquaredForm::new(&radius).unwrap().expand();
        let by_polynomial = Reference::of_curve(&curve).check_radii(&given, &limits).unwrap();
        let [a, b] = [&by_series, &by_polynomial].map(|f| f.rows[0].clone());
        let [p, q] = [&a, &b].map(|row| row.exact.as_ref().unwrap().to_significant(19));
        prop_assert_eq!(p, q);
        prop_assert!((a.deviation.digits() - b.deviation.digits()).abs() < 1e-5);
    }

    /// Points given at exact rational distances from a circle, on its axes.
    #[test]
    fn the_distance_along_a_ray_is_exact(k in -4000i32..4000, r in 1i32..40) {
        prop_assume!(k != 0);
        let x = Rational::from(r) + Rational::from(k) * power_of_two(-20);
        let point = GivenPoint { line: 1, position: [x.to_f64(), 0.0, 0.0] };
        let found = circle(r.into()).check_points(&[point], &Limits::none()).unwrap();
        let row = &found.rows[0];
        let expected = (Rational::from(k) * power_of_two(-20)).abs() / Rational::from(r);
        let off = (row.deviation.relative().unwrap() - &expected).abs() / expected;
        prop_assert!(off < power_of_two(-60));
        let ulp = f64::from(r).next_up() - f64::from(r);
        prop_assert!((row.deviation.ulps / (f64::from(k.abs()) * 2f64.powi(-20) / ulp) - 1.0).abs() < 1e-12);
    }

    /// Test vectors: what follows from the inputs follows from them exactly.
    #[test]
    fn vectors_follow_from_their_inputs(r in radii(5)) {
        let size = power_of_two(-60);
        prop_assume!(r.cosines().iter().chain(r.sines()).all(|c| c.is_zero() || c.abs() > size));
        prop_assume!(!SquaredForm::new(&r).unwrap().is_perfect_square());
        let reference = Reference::of_radius(&r).unwrap();
        let vectors = test_vectors(&reference, InputsOf::Form, 5, &Limits::none()).unwrap();
        let doubles = changed(&r, |_, a, b| [a, b]);
        prop_assume!(doubles.harmonics() == r.harmonics());
        let exact = theorem_2(&doubles);
        prop_assert_eq!(vectors.coefficients.len(), exact.len());
        for (vector, ((i, j), c)) in vectors.coefficients.iter().zip(&exact) {
            prop_assert_eq!(vector.exponents.map(|e| e as usize), [*i, *j, 0]);
            prop_assert_eq!(&BigRational::from(&vector.exact), c);
            prop_assert_eq!(vector.double.to_bits(), vector.exact.to_f64().to_bits());
        }
        let given: Vec<GivenRadius> = vectors.radii.iter().map(|v| GivenRadius { line: 1, theta: v.theta, r: v.r }).collect();
        let found = Reference::of_radius(&doubles).unwrap().check_radii(&given, &Limits::none()).unwrap();
        prop_assert!(found.rows.iter().all(|row| row.deviation.ulps <= 0.5 + 1e-6));
        let points: Vec<GivenPoint> = vectors.points.iter().map(|v| GivenPoint { line: 1, position: v.position }).collect();
        let found = Reference::of_radius(&doubles).unwrap().check_points(&points, &Limits::none()).unwrap();
        // The correctly rounded coordinates of a point are near the curve as far as its condition allows.
        for (row, vector) in found.rows.iter().zip(&vectors.points) {
            let allowed = 4.0 * vector.condition.max(1.0) * f64::EPSILON;
            let relative = row.deviation.relative().map_or(f64::INFINITY, Rational::to_f64);
            prop_assert!(relative <= allowed, "{} {}", relative, allowed);
        }
    }
}

#[test]
fn theorem_2_in_doubles_is_right_where_doubles_are_enough() {
    let right = changed(&lopsided(), |_, a, b| [a, b]);
    let float = FloatTheorem2::new(&right).polynomial().unwrap();
    let found = compare_coefficients(&float, Reference::of_radius(&right).unwrap().polynomial());
    assert!(found.passes(Some(13)), "{:?}", found.worst(1));
}
