//! Rational parametrizations: curves are built backwards from a cover of the line of slopes, so that their genus is known.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::limits::Limits;
use stellate::parametrize::{
    Cover, FactorRationality, Parametrization, Place, Rationality, parametrize,
};
use stellate::poly::{BinaryForm, PlanePolynomial, Ring};
use stellate::shape::{Form, ImplicitCurve};

use crate::common::dense::of_integers;
use crate::common::program::{done, json};

fn form(coefficients: &[i64]) -> BinaryForm {
    BinaryForm::new(coefficients.iter().copied())
}

fn forms(degree: usize) -> impl Strategy<Value = BinaryForm> {
    prop::collection::vec(-5i64..6, degree + 1).prop_map(|c| form(&c))
}

fn power(f: &BinaryForm, k: usize) -> BinaryForm {
    (0..k).fold(form(&[1]), |product, _| product.times(f))
}

fn curve(parts: Vec<BinaryForm>) -> PlanePolynomial {
    parts.into_iter().collect()
}

fn parametrized(f: &PlanePolynomial) -> Parametrization {
    parametrize(&ImplicitCurve::new(f.clone()), &Limits::none()).unwrap()
}

fn read(text: &str) -> PlanePolynomial {
    let form = stellate::language::parse_form(text, "<form>", stellate::language::Numbers::Exact);
    let Form::Curve(curve) = form.unwrap() else {
        panic!("a curve: {text}")
    };
    curve.polynomial().clone()
}

/// What is known of the only factor.
fn rationality(text: &str) -> Option<Rationality> {
    let known = parametrized(&read(text)).rational;
    assert!(known.len() <= 1, "{text} is irreducible");
    known.into_iter().next().map(|r| r.rationality)
}

/// `(S − A)² − B² k` with degrees n, n−1 and 2 deg B + deg k = 2n − 2: with y = t x it is the cover w² = k of the line of
/// slopes.
fn double_cover(s: &BinaryForm, a: &BinaryForm, b: &BinaryForm, k: &BinaryForm) -> PlanePolynomial {
    let middle = s.times(a).times(&form(&[-2]));
    let low = a.squared().minus(&b.squared().times(k));
    curve(vec![s.squared(), middle, low])
}

/// Points for many parameters are on the curve, exactly, and there are many of them.
fn lies_on(known: &FactorRationality, f: &PlanePolynomial) -> Result<(), TestCaseError> {
    let Rationality::Parametrized(curve) = &known.rationality else {
        return Err(TestCaseError::fail(format!("rational: {known:?}")));
    };
    let mut points = Vec::new();
    for t in -12i64..12 {
        let at = Rational::from(t) / Rational::from(7);
        if let (Some(x), Some(y)) = (curve.x.evaluate(&at), curve.y.evaluate(&at)) {
            prop_assert!(f.evaluate(&x, &y).is_zero(), "({}, {})", x, y);
            points.push((x, y));
        }
    }
    points.sort();
    points.dedup();
    prop_assert!(points.len() > 6, "not constant, and not many to one");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    #[test]
    fn a_line_of_slopes_is_rational(s in forms(3), p in forms(2)) {
        prop_assume!(!s.is_zero() && !p.is_zero());
        let f = curve(vec![s, p]);
        for known in parametrized(&f).rational {
            if known.rationality != Rationality::HalfAngle {
                lies_on(&known, &f)?;
            }
        }
    }

    #[test]
    fn a_conic_with_a_point_gives_a_parametrization(
        s in forms(3), a in forms(2), b in forms(1), k0 in -9i64..10, k1 in -9i64..10, u in -5i64..6, w in 0i64..9,
    ) {
        // k(u, 1) = w²
        let k = form(&[k0, k1, w * w - k0 * u * u - k1 * u]);
        prop_assume!(!s.is_zero() && !b.is_zero() && k1 * k1 != 4 * k0 * (w * w - k0 * u * u - k1 * u));
        let f = double_cover(&s, &a, &b, &k);
        for known in parametrized(&f).rational {
            if known.rationality != Rationality::HalfAngle {
                lies_on(&known, &f)?;
            }
        }
    }

    #[test]
    fn a_conic_through_a_point_of_any_size_is_parametrized(
        a in -300i64..300, b in -300i64..300, c in -300i64..300, p in 1i64..20_000, q in -20_000i64..20_000,
    ) {
        // a x² + b x y + c y² through (p, q)
        let level = a * p * p + b * p * q + c * q * q;
        prop_assume!(level != 0 && b * b != 4 * a * c);
        let f = curve(vec![form(&[a, b, c]), form(&[-level])]);
        let factors = stellate::factor::factor_plane(&f, &Limits::none()).unwrap().factors;
        prop_assume!(factors.len() == 1);
        for known in parametrized(&f).rational {
            if known.rationality != Rationality::HalfAngle {
                lies_on(&known, &f)?;
            }
        }
    }

    #[test]
    fn a_conic_without_a_point_gives_none(s in forms(3), a in forms(2), b in forms(1), c in forms(2)) {
        // Sums of two squares are never 3 modulo 4 up to squares: w² = 3(t0² + t1²) after a change of (t0, t1).
        let [x, y] = [0, 1].map(|k| c.coefficients()[k].clone());
        let k = BinaryForm::new([(&x * &x + 1) * 3, &x * &y * 6, &y * &y * 3]);
        prop_assume!(!s.is_zero() && !b.is_zero() && y != 0.into());
        let f = double_cover(&s, &a, &b, &k);
        let known = parametrized(&f).rational;
        // The factor that is not linear in x.
        let positive = |r: &FactorRationality| matches!(r.rationality, Rationality::PositiveGenus { .. });
        prop_assert!(!known.iter().any(positive));
        if known.len() == 1 && stellate::factor::factor_plane(&f, &Limits::none()).unwrap().factors.len() == 1 {
            let Rationality::NoRationalPoint { place, .. } = &known[0].rationality else {
                return Err(TestCaseError::fail(format!("no point: {known:?}")));
            };
            prop_assert!(matches!(place, Place::Prime(_)));
        }
    }

    #[test]
    fn the_kernel_gives_the_genus(s in forms(4), a in forms(3), b in forms(1), k in forms(4), twisted in any::<bool>()) {
        prop_assume!(!s.is_zero() && !b.is_zero());
        // Degree 4 is genus 1; with b as a factor of the kernel, degree 6 with another B: genus 2.
        let (b, k, genus) = if twisted { (form(&[1]), k.times(&b).times(&form(&[1, 9])), 2) } else { (b, k, 1) };
        let discriminant_is_zero = {
            let in_t = of_integers(&k.coefficients());
            let parts = stellate::poly::squarefree_decomposition(&in_t);
            let degree = in_t.coefficients_asc().len();
            parts.iter().any(|(m, _)| *m > 1) || degree < k.degree()
        };
        prop_assume!(!k.is_zero() && !discriminant_is_zero);
        let f = double_cover(&s, &a, &b, &k);
        let factors = stellate::factor::factor_plane(&f, &Limits::none()).unwrap().factors;
        prop_assume!(factors.len() == 1);
        let known = parametrized(&f).rational;
        let Rationality::PositiveGenus { genus: found, cover: Cover::Double(kernel) } = &known[0].rationality else {
            return Err(TestCaseError::fail(format!("genus {genus}: {known:?}")));
        };
        prop_assert_eq!(*found, genus);
        prop_assert_eq!(kernel.degree(), 2 * genus + 2);
    }

    #[test]
    fn cyclic_covers_with_two_branch_points_are_rational(
        k in 3usize..6, m in 1usize..5, c in 1i64..9, l in forms(1), g in forms(1), d in forms(3), other in forms(1),
    ) {
        // R^k = c l^m other^(k−m) (g/d)^k
        prop_assume!(m < k && num_integer_gcd(m, k) == 1 && !g.is_zero() && !d.is_zero());
        let (l_at, other_at) = (l.coefficients(), other.coefficients());
        prop_assume!(&l_at[0] * &other_at[1] != &l_at[1] * &other_at[0]);
        let low = power(&l, m).times(&power(&other, k - m)).times(&power(&g, k)).times(&form(&[-c]));
        let f = curve(vec![power(&d, k), low]);
        for known in parametrized(&f).rational {
            lies_on(&known, &f)?;
        }
    }
}

fn num_integer_gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { num_integer_gcd(b, a % b) }
}

#[test]
fn the_examples_of_the_paper_have_simple_parametrizations() {
    let shown = |text: &str| match rationality(text) {
        Some(Rationality::Parametrized(curve)) => format!("{}, {}", curve.x, curve.y),
        other => panic!("{text}: {other:?}"),
    };
    // Examples 1 and 5, and 7
    assert_eq!(
        shown("x^4 - x^2 + y^2"),
        "(2*t)/(t^2+1), (2*t^3-2*t)/(t^4+2*t^2+1)"
    );
    assert_eq!(
        shown("x^2 + y^2 - 2x - 2y + 1"),
        "(t^2)/(t^2-2*t+2), 2/(t^2-2*t+2)"
    );
}

#[test]
fn genus_of_curves_that_everybody_knows() {
    let genus = |text: &str| match rationality(text) {
        Some(Rationality::PositiveGenus { genus, .. }) => genus,
        other => panic!("{text}: {other:?}"),
    };
    assert_eq!(genus("y^2 = x^3 + x"), 1);
    assert_eq!(genus("x^3 + y^3 = 1"), 1);
    assert_eq!(genus("x^4 + y^4 = 1"), 3, "Fermat's: (n-1)(n-2)/2");
    assert_eq!(genus("x^5 + y^5 = 1"), 6);
    assert_eq!(genus("x^4 + x^3*y + y^4 = x^2 + 2y^2"), 2);
}

#[test]
fn conics_without_a_point_say_where_and_over_which_field() {
    let place = |text: &str| match rationality(text) {
        Some(Rationality::NoRationalPoint { place, field, .. }) => (place, field.to_string()),
        other => panic!("{text}: {other:?}"),
    };
    assert_eq!(place("x^2 + 2y^2 = -1"), (Place::Real, "-1".into()));
    assert_eq!(place("x^2 + 5y^2 = 3"), (Place::Prime(5), "2".into()));
}

#[test]
fn nothing_is_claimed_where_nothing_is_known() {
    // Four parts; and a degree above the limit.
    assert_eq!(rationality("x^3 + y^2 + x = 1"), None);
    assert_eq!(rationality("x^43 = y^42"), None);
    // Conjugate curves: irreducible over Q, two curves over Q(√2).
    let conjugate = rationality("x^2 = 2y^4").unwrap();
    assert_eq!(conjugate, Rationality::Conjugates { count: 2 });
    // A conic with a number that is not factored: 2^61 − 1 times 1000000007 · 1000000009.
    let known = rationality("x^2 + 2y^2 = 2305843046107182243687212796462718913");
    assert!(
        matches!(known, Some(Rationality::NotDecided { .. })),
        "{known:?}"
    );
}

#[test]
fn documents_and_comments_say_what_is_known() {
    let text = done(&["parametrize", "(x^2 + 2y^2 - 1)*(x^3 + y^3 - 1)*(x - y)"]);
    let comments: Vec<&str> = text
        .lines()
        .filter(|l| l.starts_with("# factor "))
        .collect();
    assert_eq!(
        comments,
        [
            "# factor 1 is rational: x = (-t^2 + 2)/(t^2 + 2), y = 2*t/(t^2 + 2)",
            "# factor 2 has genus 1: no rational parametrization exists (with y = t*x it is x^3 = g(t), branched over 3 values of t: Riemann and Hurwitz)",
        ]
    );
    let document = json(&done(&["parametrize", "x^2*y^3 = 1", "--format", "json"]));
    let expected = r#"[{"factor":0,"genus":0,"rational":true,"parameter":"t","x":"t^3","y":"1/t^2",
        "latex":{"x":"t^{3}","y":"\\frac{1}{t^{2}}"},"sympy":{"x":"t**3","y":"1/t**2"}}]"#;
    assert_eq!(document["rational"], json(expected));
    let sympy = done(&["parametrize", "x^2*y^3 = 1", "--format", "sympy"]);
    assert_eq!(
        sympy.lines().last().unwrap(),
        "# factor 0 is rational: x = t**3, y = 1/t**2"
    );
    // A series is a parametrization in tan(theta/2) already.
    let egg = json(&done(&[
        "parametrize",
        crate::common::program::EGG,
        "--format",
        "json",
    ]));
    let expected = r#"[{"factor":0,"genus":0,"rational":true,"parameter":"tan(theta/2)"}]"#;
    assert_eq!(egg["rational"], json(expected));
}
