//! Formulas as people type them, and polar curves that are no finite Fourier series.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use stellate::error::Error;
use stellate::exact::Rational;
use stellate::implicitize::implicitize_plane;
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::poly::PlanePolynomial;
use stellate::shape::{Form, FourierRadius};

use crate::common::forms::refusal;
use crate::common::{radii, value_at};

fn read(text: &str) -> Result<Form, Error> {
    parse_form(text, "<form>", Numbers::Exact)
}

/// What is typed is read as what stands beside it.
const TYPED: [(&str, &str); 56] = [
    ("(t^2, t^3)", "x = t^2; y = t^3"),
    ("[t^2, t^3 + t]", "x = t^2; y = t^3 + t"),
    ("(u, v, u*v)", "x = u; y = v; z = u*v"),
    ("(cos(t), sin(2*t))", "x = cos(t); y = sin(2*t)"),
    (
        "((1 - t^2)/(1 + t^2), 2t/(1 + t^2))",
        "x = (1 - t^2)/(1 + t^2); y = 2t/(1 + t^2)",
    ),
    ("x = t^2, y = t^3 + t", "x = t^2; y = t^3 + t"),
    ("x(t) = t^2, y(t) = t^3", "x = t^2; y = t^3"),
    ("x(t) = t^2; y(t) = t^3", "x = t^2; y = t^3"),
    (
        "x(u,v) = u, y(u,v) = v, z(u,v) = u*v",
        "x = u; y = v; z = u*v",
    ),
    ("r(theta) = 1 + cos(theta)/3", "r = 1 + cos(theta)/3"),
    ("r(t) = 2 - sin(t)", "r = 2 - sin(t)"),
    ("rho = 1 + cos(t)/3", "r = 1 + cos(t)/3"),
    ("ρ(θ) = 1 + cos(θ)/3", "r = 1 + cos(theta)/3"),
    ("r = 1 + cos t", "r = 1 + cos(t)"),
    ("r = 1 + 0.2cos 3t", "r = 1 + 0.2cos(3t)"),
    (
        "r = 1 + 1/5 cos 3*t - sin 2t",
        "r = 1 + 1/5 cos(3*t) - sin(2t)",
    ),
    ("r = 2 + cos^2(t)", "r = 2 + cos(t)^2"),
    ("r = 2 + sin²(2t)/3", "r = 2 + sin(2t)^2/3"),
    ("r = 2 + cos^2 t", "r = 2 + cos(t)^2"),
    ("r = 2 + cos^2(t)*sin^3(2t)", "r = 2 + cos(t)^2*sin(2t)^3"),
    ("x = cos^3 t, y = sin^3 t", "x = cos(t)^3; y = sin(t)^3"),
    ("Eq(x**2 + y**2, 1)", "x^2 + y^2 = 1"),
    ("Eq(r, 1 + cos(t)/2)", "r = 1 + cos(t)/2"),
    ("x^2 + y^2 - 1 == 0", "x^2 + y^2 = 1"),
    ("x^2 + y^2 == 1", "x^2 + y^2 = 1"),
    ("[x + 1]^2 + y^2 = 4", "(x + 1)^2 + y^2 = 4"),
    ("x^2 + y^2 == 1; z == y^5", "x^2 + y^2 = 1; z = y^5"),
    ("{t^2, t^3}", "x = t^2; y = t^3"),
    ("[x = t^2, y = t^3]", "x = t^2; y = t^3"),
    ("{x(t) = cos(t), y(t) = sin(2t)}", "x = cos(t); y = sin(2t)"),
    ("{Cos[t], Sin[2 t]}", "x = cos(t); y = sin(2t)"),
    ("r = 1 + Cos[3 t]/5", "r = 1 + cos(3t)/5"),
    ("r := 1 + cos(t)/3", "r = 1 + cos(t)/3"),
    ("x.^2 + y.^2 - 1", "x^2 + y^2 = 1"),
    ("2.*x + 3.*y.^2 = 1", "2x + 3y^2 = 1"),
    ("x./2 + y = 1", "x/2 + y = 1"),
    ("f(x, y) = x^2 + y^2 - 1", "x^2 + y^2 = 1"),
    ("F(x,y,z) = x^2 + y^2 + z^2 - 1", "x^2 + y^2 + z^2 = 1"),
    ("f(x,y) := x^3 - y^2", "x^3 = y^2"),
    ("x^{2} + y^{2} = 1", "x^2 + y^2 = 1"),
    ("x² + y² − 1", "x^2 + y^2 = 1"),
    ("x**2+y**2-1", "x^2 + y^2 = 1"),
    ("x^2+y^2=1;", "x^2 + y^2 = 1"),
    ("y = x^2", "y - x^2"),
    ("r = 1 + .5cos(3θ)", "r = 1 + 1/2 cos(3theta)"),
    ("(cos t, sin t)", "x = cos(t); y = sin(t)"),
    ("r = sec(t)", "x = sec(t)*cos(t); y = sec(t)*sin(t)"),
    ("r^2 = 2 sin 2t", "(x^2 + y^2)^2 = 4x*y"),
    (
        "r = 2/(1 - cos(t))",
        "x = 2cos(t)/(1 - cos(t)); y = 2sin(t)/(1 - cos(t))",
    ),
    (
        "r = 1/(2 + cos(t))",
        "x = cos(t)/(2 + cos(t)); y = sin(t)/(2 + cos(t))",
    ),
    (
        "r = (2 + cos(t))^-1",
        "x = cos(t)/(2 + cos(t)); y = sin(t)/(2 + cos(t))",
    ),
    (
        "r = tan(theta)",
        "x = tan(theta)*cos(theta); y = tan(theta)*sin(theta)",
    ),
    (
        "r = cos(2t/3)",
        "x = cos(2t/3)*cos(t); y = cos(2t/3)*sin(t)",
    ),
    ("r^2 = cos(2t)", "(x^2 + y^2)^2 = x^2 - y^2"),
    ("r^2 = 4", "x^2 + y^2 = 4"),
    // r^4 = r + x
    ("r^3 = 1 + cos(t)", "((x^2 + y^2)^2 - x)^2 = x^2 + y^2"),
];

#[test]
fn what_is_typed_is_read_as_meant() {
    for (typed, meant) in TYPED {
        let [found, expected] = [typed, meant].map(|text| match read(text) {
            Ok(form) => form.to_string(),
            Err(error) => panic!("{error}"),
        });
        assert_eq!(found, expected, "{typed}");
    }
}

/// What is not read says what would be.
#[test]
fn what_is_refused_names_what_would_be_right() {
    for (typed, at, part) in [
        ("r = 1 + cos t/3", "t/3", "as in cos(3*t)"),
        (
            "r = cos(t + 1)",
            "t + 1",
            "an integer multiple of the angle",
        ),
        (
            "x = cos(t), y = 0,5*sin(t)",
            ",5",
            "decimals are written with a point",
        ),
        ("(x^2 + y^2]", "]", "`]` does not close `(`"),
        ("x = 1; y = 2", "x = 1", "this is a point"),
        ("r^(1/2) = 1 + cos(t)", "(1/2)", "as r^2"),
        ("r^0 = cos(t)", "0", "as r^2"),
        (
            "r^2 = -2 + cos(t/2)",
            "-2 + cos(t/2)",
            "negative at every angle",
        ),
        (
            "r^2 = 2*cos(2t) - 3",
            "2*cos(2t) - 3",
            "negative at every angle",
        ),
        (
            "r^2 = sin(2t)/sin(t)",
            "sin(2t)",
            "divide both by their common factor",
        ),
        ("r^2 = 0*cos(t)", "0*", "only the origin"),
        (
            "r = 1/(cos(t) - cos(t))",
            "(cos(t) - cos",
            "division by zero",
        ),
        (
            "# center: 1, 2\nr = 1/(2 + cos(t))",
            " 1, 2",
            "a center belongs to",
        ),
    ] {
        let (message, rest) = refusal(typed, read(typed));
        assert!(message.contains(part), "{typed}: {message}");
        let [rest, at] = [&*rest, at].map(|text| text.trim_start_matches('('));
        assert!(rest.starts_with(at), "{typed}: at {rest}");
    }
}

/// A power of the radius beside what would take too long is a stated limit.
#[test]
fn large_polar_curves_are_limits() {
    for (text, part) in [
        ("r^501 = 2 + cos(t)", "a power of r beyond 500"),
        ("r^2 = cos(61t)", "a harmonic beyond 60"),
        ("r^2 = cos(9999t)", "a harmonic beyond 60"),
        ("r^3 = 1/(2 + cos(t)^61)", "a harmonic beyond 60"),
        ("r^2 = 1e40000 + cos(t)", "of more than 100000 bits"),
        ("r^2 = 2 + cos(t/49)", "a degree beyond 200"),
    ] {
        match read(text) {
            Err(Error::Limit { limit, .. }) => assert!(limit.contains(part), "{limit}"),
            other => panic!("{text}: {other:?}"),
        }
    }
    for text in ["r^500 = cos(60t)", "r^499 = 1/(3 + cos(60t) - sin(59t))"] {
        let _ = read(text);
    }
}

/// Parentheses and functions beyond number end, and are read in time that is about linear.
#[test]
fn long_texts_of_functions_end() {
    for text in [
        "cos^2(".repeat(200_000),
        format!("r = {}", "cos ".repeat(200_000)),
        format!("x = 1{}", ", x(".repeat(200_000)),
        format!("({}", "t, (".repeat(200_000)),
        format!("r = 1{}", " + cos^2 3t".repeat(20_000)),
    ] {
        let _ = read(&text);
    }
}

/// The text of a trigonometric polynomial in t.
fn text_of(radius: &FourierRadius) -> String {
    let text = radius.to_string();
    let (_, formula) = text.trim().split_once("r = ").unwrap();
    formula.to_owned()
}

/// Whether r^k = v for every root r of the polynomial along (c, s) implies f = 0 there, for all of its complex roots.
fn vanishes_where(f: &PlanePolynomial, [c, s]: [&Rational; 2], k: usize, v: &Rational) -> bool {
    let mut classes = vec![Rational::zero(); k];
    for ((i, j), coefficient) in f.terms() {
        let [x, y] = [(c, i), (s, j)].map(|(u, e)| u.pow(e as i64).unwrap());
        let power = v.pow(((i + j) / k) as i64).unwrap();
        let class = &mut classes[(i + j) % k];
        *class = &*class + &(coefficient * x * y * power);
    }
    classes.iter().all(Rational::is_zero)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// r^k = P/Q: with the value v of P/Q in a direction, f(r c, r s) is a multiple of r^k − v.
    #[test]
    fn powers_of_the_radius_satisfy_their_equation(p in radii(4), q in radii(3), k in 2usize..6, m in -7i64..8) {
        let text = format!("r^{k} = ({})/({})", text_of(&p), text_of(&q));
        let Ok(Form::Curve(curve)) = read(&text) else {
            // Refused: a common zero, or an origin that is not on the curve.
            return Ok(());
        };
        let (t, one) = (Rational::from(m) / Rational::from(8), Rational::one());
        let w = &one + &(&t * &t);
        let (c, s) = ((&one - &(&t * &t)) / &w, &t * &Rational::from(2) / &w);
        let below = value_at(&q, &c, &s);
        prop_assume!(!below.is_zero());
        let v = value_at(&p, &c, &s) / below;
        prop_assert!(vanishes_where(curve.polynomial(), [&c, &s], k, &v), "{}", text);
        // Another value is not taken there.
        let other = &v + &one;
        let meets = vanishes_where(curve.polynomial(), [&c, &s], k, &other);
        // With odd k the opposite radius belongs to the opposite direction.
        let (c, s) = (-c, -s);
        let opposite = value_at(&q, &c, &s);
        let opposite = (!opposite.is_zero()).then(|| value_at(&p, &c, &s) / opposite);
        let sign = if k % 2 == 0 { 1 } else { -1 };
        prop_assert!(!meets || opposite.is_some_and(|o| o * Rational::from(sign) == other));
    }

    /// r = P/Q is the parametric curve whose equation vanishes at its points.
    #[test]
    fn quotients_are_parametric_curves(p in radii(2), q in radii(2), m in -7i64..8) {
        let text = format!("r = ({})/({})", text_of(&p), text_of(&q));
        let curve = match read(&text) {
            Ok(Form::PlaneCurve(curve)) => curve,
            // A divisor that is a constant.
            Ok(Form::Fourier(_)) => return Ok(()),
            other => return Err(TestCaseError::fail(format!("{text}: {other:?}"))),
        };
        prop_assume!(!curve.is_point());
        let f = implicitize_plane(&curve, &Limits::none()).unwrap().curve;
        let (t, one) = (Rational::from(m) / Rational::from(8), Rational::one());
        let w = &one + &(&t * &t);
        let (c, s) = ((&one - &(&t * &t)) / &w, &t * &Rational::from(2) / &w);
        let below = value_at(&q, &c, &s);
        prop_assume!(!below.is_zero());
        let r = value_at(&p, &c, &s) / below;
        prop_assert!(f.polynomial().evaluate(&(&r * &c), &(&r * &s)).is_zero(), "{}", text);
    }
}
