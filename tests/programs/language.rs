//! The input language: what is read, what is refused and where, and what can never happen.

use proptest::prelude::*;
use stellate::error::Error;
use stellate::exact::Rational;
use stellate::language::{MAX_DEGREE, MAX_NESTING, Numbers, parse_form};
use stellate::poly::SparsePolynomial;
use stellate::shape::{Form, FourierRadius};

use crate::common::forms::refusal;

fn read(text: &str) -> Form {
    parse_form(text, "<form>", Numbers::Exact).unwrap_or_else(|e| panic!("{e}"))
}

fn radius(text: &str) -> FourierRadius {
    match read(text) {
        Form::Fourier(radius) => radius,
        other => panic!("{text}: {other:?}"),
    }
}

/// The polynomial as `coefficient:exponents` in canonical order.
fn terms(text: &str) -> String {
    let polynomial = match read(text) {
        Form::Curve(curve) => {
            assert!(curve.polynomial().check_invariants());
            SparsePolynomial::from(curve.polynomial())
        }
        Form::Surface(surface) => surface.polynomial().clone(),
        other => panic!("{text}: {other:?}"),
    };
    let terms = polynomial
        .terms()
        .map(|(e, c)| format!("{c}:{e:?}").replace(", ", ","));
    terms.collect::<Vec<_>>().join(" ")
}

#[track_caller]
fn assert_refused(input: &str, expected: &str, caret: &str) {
    let (message, rest) = refusal(input, parse_form(input, "<form>", Numbers::Exact));
    assert!(message.contains(expected), "{input}: {message}");
    assert!(rest.starts_with(caret), "{input}: {message}, at {rest}");
    assert!(!message.contains("implemented"), "{message}");
}

#[track_caller]
fn assert_limit(text: &str, expected: &str) {
    match parse_form(text, "<form>", Numbers::Exact) {
        Err(Error::Limit { limit, .. }) => assert!(limit.contains(expected), "{limit}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn products_are_read_from_left_to_right() {
    assert_eq!(terms("3x^2y"), "3:[2,1,0]");
    assert_eq!(terms("1.9x^2y^2"), "19/10:[2,2,0]");
    assert_eq!(terms("1/2x"), "1/2:[1,0,0]");
    assert_eq!(terms("x/2y"), "1/2:[1,1,0]");
    assert_eq!(terms("xy"), terms("x y"));
    assert_eq!(
        terms("2(x+1)(y-1)"),
        "2:[1,1,0] -2:[1,0,0] 2:[0,1,0] -2:[0,0,0]"
    );
    assert_eq!(terms("xyz"), "1:[1,1,1]");
    assert_eq!(terms("2*-x"), "-2:[1,0,0]");
    assert_eq!(terms("12/(2*3)*x"), "2:[1,0,0]");
    assert_eq!(terms("12/2/3x"), "2:[1,0,0]");
}

#[test]
fn powers_bind_tighter_than_signs_and_from_the_right() {
    assert_eq!(terms("-x^2"), "-1:[2,0,0]");
    assert_eq!(terms("2^3^2*x"), "512:[1,0,0]");
    assert_eq!(terms("2^-3x"), "1/8:[1,0,0]");
    assert_eq!(terms("x**2 + x²y³ + x¹²"), "1:[12,0,0] 1:[2,3,0] 1:[2,0,0]");
    assert_eq!(terms("x^(4/2)"), "1:[2,0,0]");
    assert_eq!(terms("x^0 + x"), "1:[1,0,0] 1:[0,0,0]");
    assert_eq!(terms("x--y"), "1:[1,0,0] 1:[0,1,0]");
    assert_eq!(terms("+x"), "1:[1,0,0]");
}

#[test]
fn numbers_are_exact_or_doubles() {
    assert_eq!(
        terms("0.1x + 1e-5y + 0x1.8p+1"),
        "1/10:[1,0,0] 1/100000:[0,1,0] 3:[0,0,0]"
    );
    assert_eq!(
        terms("Rational(1, 3)*x + Rational(-2,4)"),
        "1/3:[1,0,0] -1/2:[0,0,0]"
    );
    assert_eq!(terms(".5x + 2.y"), "1/2:[1,0,0] 2:[0,1,0]");
    assert_eq!(terms("0x^2 + 0xy + y"), "1:[0,1,0]");
    let form = parse_form("0.1x + y/3", "<form>", Numbers::F64).unwrap();
    let Form::Curve(curve) = form else { panic!() };
    let tenth = curve.polynomial().first_coefficient().unwrap();
    assert_eq!(tenth, 0.1_f64.try_into().unwrap());
    assert!(
        curve
            .polynomial()
            .terms()
            .any(|(_, c)| c.to_string() == "1/3")
    );
}

#[test]
fn typographic_signs_are_read() {
    assert_eq!(terms("−x·y×2"), "-2:[1,1,0]");
    assert_eq!(radius("r = 1 − cos(2θ)"), radius("r = 1 - cos(2*t)"));
}

#[test]
fn equations_spread_over_lines() {
    let circle = read("x^2 + y^2 - 1");
    for text in [
        "x^2 + y^2 = 1",
        "x^2 +\n y^2 = 1",
        "x^2\n + y^2\n - 1 = 0",
        "# a circle\nx^2 + y^2 = 1 # of radius 1\n\n",
        "x^2 + y^2 = 1;",
        "(x^2\n+ y^2)\r\n= 1",
        "x^2 + y^2 = 2\n - 1",
        "ring R = 0, (x, y), dp;\npoly F = x^2+y^2-1;",
        "\u{feff}x^2 + y^2 = 1",
        "// Singular\nx^2 + y^2 = 1",
    ] {
        assert_eq!(read(text), circle, "{text}");
    }
    assert_refused("x^2 + y^2 = 1\n- x + y = 0", "a second equation", "- x");
    assert_refused("x + y = 1\nx = 2", "a second equation", "x = 2");
}

#[test]
fn a_center_is_kept() {
    let Form::Curve(curve) = read("# center: 1/2, -3\nx^2 + y^2 = 1") else {
        panic!()
    };
    assert_eq!(curve.center().clone().map(|c| c.to_string()), ["1/2", "-3"]);
    assert_eq!(
        radius("r = 2 # center: 0.5,0").center()[0].to_string(),
        "1/2"
    );
    assert_refused("# center: 1\nx", "expected a center", " 1");
    assert_refused("# center: 1,1\n# center: 2,2\nx", "a second center", " 2,2");
    assert_refused(
        "# center: 1,1\nx+z",
        "a center of two coordinates belongs to a plane curve",
        " 1,1",
    );
}

#[test]
fn a_radius_is_expanded_exactly() {
    let text = |r: &FourierRadius| {
        let pairs = r.cosines().iter().zip(r.sines()).enumerate();
        let shown = pairs.filter(|(_, (a, b))| !a.is_zero() || !b.is_zero());
        shown
            .map(|(n, (a, b))| format!("{n}:{a},{b}"))
            .collect::<Vec<_>>()
            .join(" ")
    };
    let shown = |formula: &str| text(&radius(formula));
    assert_eq!(
        shown("r = 1 + 1/5*cos(3*t) - 0.1*sin(5*t)"),
        "0:1,0 3:1/5,0 5:0,-1/10"
    );
    assert_eq!(shown("r = cos(t)^3*sin(t)"), "2:0,1/4 4:0,1/8");
    assert_eq!(shown("r = cos(2t - 5t) + sin(-t)"), "1:0,-1 3:1,0");
    assert_eq!(shown("r = (1 + 2cos(theta))²"), "0:3,0 1:4,0 2:2,0");
    assert_eq!(shown("r = 2cos(3t)sin(2t)/4"), "1:0,-1/4 5:0,1/4");
    assert_eq!(shown("r = cos(0) + sin(0t)"), "0:1,0");
    assert_eq!(shown("r = 0"), "");
    assert_eq!(shown("1 + cos((4/2)t)"), "0:1,0 2:1,0");
    assert_eq!(radius("r = cos(t)^2 + sin(t)^2"), radius("r = 1"));
}

#[test]
fn what_is_not_a_finite_fourier_series_is_refused() {
    for (text, message, at) in [
        ("r = cos(t+1)", "integer multiple of the angle", "t+1"),
        ("r = cos(cos(t))", "integer multiple of the angle", "cos(t)"),
        ("r = cos(x)", "integer multiple of the angle", "x)"),
        ("r = cos(t*t)", "integer multiple of the angle", "t)"),
        ("r = cos(t^2)", "integer multiple of the angle", "t^2"),
        ("r = 1/0", "division by zero", "0"),
        ("r = 1/(2-2)", "division by zero", "2-2"),
        ("r = 0^-1", "division by zero", "0^"),
        ("r = exp(t)", "not a finite Fourier series", "exp"),
        ("r = t", "outside cos( ) and sin( )", "t"),
        ("r = x", "whose only variable is the angle", "x"),
        ("r = 1 + r", "r stands only on the left", "r"),
        (
            "r = cos(t) + sin(theta)",
            "a second name for the angle",
            "theta",
        ),
        ("r = cos(t, 2)", "one argument", "2)"),
        ("r", "expected `= …` after r", "r"),
        ("r =", "expected a number, a name or `(`", ""),
        ("r = cos(t)^(1/2)", "an exponent is an integer", "1/2"),
        ("r = 2^cos(t)", "expected a number here", "cos"),
        ("r = pi", "not rational", "pi"),
    ] {
        assert_refused(text, message, at);
    }
}

#[test]
fn malformed_text_is_refused_at_the_place() {
    for (text, message, at) in [
        ("", "there is no equation", ""),
        ("# only a comment", "there is no equation", ""),
        (
            "x^2 + foo",
            "unknown name `foo`; a Fourier radius uses",
            "foo",
        ),
        ("radius = 1", "unknown name `radius`", "radius"),
        ("x^2 + (y", "this `(` is never closed", "(y"),
        ("x)", "`)` without a `(`", ")"),
        ("x = 1 = 2", "a second `=`", "= 2"),
        ("x + 1,5y", "decimals are written with a point", ","),
        ("x + ", "expected a number", ""),
        ("x * * y", "expected a number", "* y"),
        ("()", "expected a number", ")"),
        ("x^", "expected a number", ""),
        ("2e", "the exponent after e needs digits", "2e"),
        ("2e+x", "the exponent after e needs digits", "2e"),
        ("x2", "a number after a factor", "2"),
        ("1 000x", "a number after a factor", "000"),
        ("1.2.3x", "a number after a factor", ".3"),
        ("x_1", "unexpected character: `_`", "_"),
        ("x + $", "LaTeX, which is not read", "$"),
        (".x", "a point without digits", "."),
        ("1e200000x", "the exponent is beyond", "1e2"),
        ("x²^3", "a second exponent", "^3"),
        ("x² ³", "a second exponent", "³"),
        ("Rational(1,0)x", "division by zero", "0"),
        ("Rational(1,2,3)x", "two arguments", "Ration"),
        ("x/(y-y)", "division by zero", "y-y"),
        ("x^y", "expected a number here", "y"),
        ("x^0.5", "an exponent is an integer", "0.5"),
        ("0 = 0", "every point satisfies it", "0"),
        ("1 = 0", "no point satisfies it", "1"),
        ("x - x", "every point satisfies it", "x"),
        ("x + t = 0", "whose variables are x, y, z", "t"),
        (
            "x + cos(t) = 0",
            "cos and sin do not occur in a polynomial",
            "cos",
        ),
        ("x + r = 0", "r stands only on the left", "r"),
        ("x + y = 1; y = 2", "a second equation", "y = 2"),
    ] {
        assert_refused(text, message, at);
    }
}

#[test]
fn a_coordinate_may_stand_alone_on_the_left() {
    assert_eq!(terms("x = y^2"), "-1:[0,2,0] 1:[1,0,0]");
    assert_eq!(terms("y = 0"), "1:[0,1,0]");
    assert!(matches!(read("x^2 + y^2 = 1 + 0z"), Form::Surface(_)));
}

#[test]
fn powers_of_sums_are_the_products() {
    for base in [
        "x+y",
        "x+y+z",
        "x^2+y^2",
        "x/2-3y+1",
        "x^3y+2/7x-z^2",
        "x^50+y^40z+1/3",
    ] {
        for n in [2, 3, 5, 8] {
            let product = vec![format!("({base})"); n].join("*");
            let power = format!("({base})^{n}");
            assert_eq!(read(&power), read(&product), "{power}");
        }
    }
    assert_eq!(terms("(x+1)*(x-1)*(x^2+1)"), "1:[4,0,0] -1:[0,0,0]");
    let Form::Curve(curve) = read("(x^2+y^2)^1000") else {
        panic!()
    };
    assert_eq!(curve.polynomial().term_count(), 1001);
}

#[test]
fn limits_are_reached_before_the_work() {
    assert_limit("(x+y+z)^20000", "terms");
    assert_limit("(x+y+z+1)^400*(x-y)^3", "terms");
    assert_limit(&format!("x^{}", MAX_DEGREE + 1), "exponent");
    assert_limit("x^20000*y^3", "degree");
    assert_limit("(x^3+1)^9999", "degree");
    assert_limit("2^99999*x", "exponent");
    assert_limit("((2^20000)^20000)^20000*x", "digits");
    assert_limit("x^4 - x^2 + y^1e100000^20002", "digits");
    assert_limit("(1e100000*x)^20002", "digits");
    assert_limit("r = (1e100000 + cos(t))^20002", "products");
    assert_limit("(x+y+1)^2990", "bits");
    assert_limit("r = cos(100001t)", "harmonic");
    assert_limit("r = cos(60000t)*cos(50000t)", "harmonic");
    assert_limit("r = (1+cos(t))^20000*(1+cos(2t))^20000", "products");
}

#[test]
fn deep_nesting_is_a_limit_and_not_a_crash() {
    let many = 100_000;
    let nesting = format!("nested more than {MAX_NESTING}");
    assert_limit(&"(".repeat(many), &nesting);
    assert_limit(
        &format!("{}x{}", "(".repeat(many), ")".repeat(many)),
        &nesting,
    );
    assert_limit(&format!("{}x", "-(".repeat(many)), &nesting);
    assert_limit(&format!("x{}", "^1".repeat(many)), &nesting);
    assert_limit(&format!("r = {}", "cos(".repeat(many)), &nesting);
    assert_limit(&format!("{}x", "2^-".repeat(many)), &nesting);
    assert_eq!(terms(&format!("{}x", "-".repeat(many))), "1:[1,0,0]");
    assert_eq!(terms(&format!("x{}", "+1-1".repeat(many))), "1:[1,0,0]");
    assert_eq!(terms(&format!("x{}", "*1/1".repeat(many))), "1:[1,0,0]");
    let deep = MAX_NESTING as usize;
    let inside = "(1+2*-".repeat(deep) + "x" + &")".repeat(deep);
    assert!(terms(&inside).contains("[1,0,0]"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn no_text_panics(text in ".{0,60}") {
        let _ = parse_form(&text, "<form>", Numbers::Exact).map_err(|e| e.to_string());
    }

    #[test]
    fn no_sequence_of_tokens_panics(
        tokens in prop::collection::vec(prop::sample::select(vec![
            "x", "y", "z", "r", "t", "theta", "cos", "sin", "cos(", "sin(3t)", "(", ")", "+", "-",
            "*", "/", "^", "**", "=", ";", "\n", ",", "1", "0", "2.5", "1e3", "0x1p-3", "²", "θ",
            "Rational(", "1,3)", "r = ", "#", "# center: 1,2\n", " ", "poly", "ring", "^2", "^-1",
            "foo", "superquadric", "//", "2e", ".", "√", "u", "pi", "10", "^9^9",
        ]), 0..14)
    ) {
        let text = tokens.concat();
        for numbers in [Numbers::Exact, Numbers::F64] {
            if let Err(error) = parse_form(&text, "<form>", numbers) {
                prop_assert!(!error.to_string().is_empty());
            }
        }
    }

    #[test]
    fn a_sum_is_read_term_by_term(
        terms in prop::collection::vec((-99i64..100, 1i64..20, 0u32..9, 0u32..9), 1..20)
    ) {
        let text: Vec<String> = terms
            .iter()
            .map(|(p, q, i, j)| format!("({p}/{q})x^{i}y^{j}"))
            .collect();
        let expected = SparsePolynomial::<3>::from_terms(
            terms
                .iter()
                .map(|&(p, q, i, j)| ([i, j, 0], Rational::from(p) / Rational::from(q))),
        );
        match parse_form(&text.join(" + "), "<form>", Numbers::Exact) {
            Ok(Form::Curve(curve)) => {
                prop_assert_eq!(SparsePolynomial::from(curve.polynomial()), expected);
            }
            Ok(_) => prop_assert!(false),
            Err(_) => prop_assert!(expected.as_constant().is_some()),
        }
    }
}

#[test]
fn parametric_forms_that_are_not_algebraic_are_refused_with_the_reason() {
    for (text, message, at) in [
        ("x = sin(t)", "`y = …` is missing", "x"),
        ("x = t; z = t", "`y = …` is missing", "z"),
        ("x = u; y = v", "a second parameter", "v"),
        ("x = u; y = v; z = t", "a third parameter", "v"),
        ("x = t; y = t^2; x = 2", "a second `x = …`", "x = 2"),
        ("x = t; y = x", "function of the parameters alone", "x"),
        ("x = t; y = t; x + y = 2", "expected `x = …`", "x + y"),
        ("x = t*sin(t); y = cos(t)", "not algebraic", "t*sin"),
        ("x = sin(t); y = t", "not algebraic", "t"),
        ("x = exp(t); y = t", "not algebraic", "exp"),
        ("x = sqrt(2)*t; y = t", "not rational", "sqrt"),
        ("x = cos(sqrt(2)*t); y = sin(t)", "not rational", "sqrt"),
        (
            "x = cos(pi*t); y = sin(t)",
            "pi times the parameter is no rational multiple of it",
            "t",
        ),
        (
            "x = cos(t + 1); y = sin(t)",
            "multiples of pi/2 may be added",
            "t + 1",
        ),
        (
            "x = cos(t + pi/3); y = sin(t)",
            "multiples of pi/2 may be added",
            "t + pi",
        ),
        (
            "x = cos(t^2); y = sin(t)",
            "integer multiple of the angle",
            "t^2",
        ),
        (
            "x = cos(u*v); y = u; z = v",
            "integer multiple of the angle",
            "v)",
        ),
        ("x = pi*t; y = t", "stands only in angles", "pi"),
        ("x = t^(1/2); y = t", "an exponent is an integer", "1/2"),
        ("x = 1/(t - t); y = t", "division by zero", "t - t"),
        ("x = tan(t - t + pi/2); y = cos(t)", "a pole", "tan"),
        ("x = cos(1001t); y = sin(t)", "", ""),
        (
            "# center: 1, 2\nx = t; y = t^2",
            "a center belongs",
            " 1, 2",
        ),
    ] {
        if message.is_empty() {
            let error = parse_form(text, "<form>", Numbers::Exact).unwrap_err();
            assert!(
                error.to_string().contains("a multiple beyond 1000"),
                "{error}"
            );
        } else {
            assert_refused(text, message, at);
        }
    }
}

#[test]
fn multiples_of_right_angles_may_be_added() {
    let same = |a: &str, b: &str| {
        let read = |text: &str| parse_form(text, "<form>", Numbers::Exact).unwrap();
        assert_eq!(read(a), read(b), "{a}");
    };
    same("r = 2 + cos(3t + pi/2)", "r = 2 - sin(3t)");
    same("r = 2 + sin(t - π)", "r = 2 - sin(t)");
    same(
        "x = cos(t - pi/2); y = sin(t + 3pi/2)",
        "x = sin(t); y = -cos(t)",
    );
    same(
        "x = sin(2u + v); y = cos(u - v); z = 1",
        "z = 1; y = cos(u)cos(v) + sin(u)*sin(v); x = 2sin(u)cos(u)*cos(v) + (2cos(u)^2 - 1)*sin(v)",
    );
    // Rescaling: t/2 and t/3 are three and two times t/6.
    same(
        "x = sin(t/2); y = sin(t/3)",
        "y = sin(t/3); x = 3sin(t/6) - 4sin(t/6)^3",
    );
}
