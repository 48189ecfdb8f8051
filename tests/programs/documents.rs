//! Documents: what is written is read back, and what is wrong with a document is said with its place.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use stellate::document::{Format, write_form, write_fourier};
use stellate::error::Error;
use stellate::exact::Rational;
use stellate::fit::Visibility;
use stellate::implicitize::EquationProof;
use stellate::language::{Numbers, parse_form};
use stellate::poly::{PlanePolynomial, SparsePolynomial};
use stellate::reading::{read_coefficients_csv, read_document, read_fourier_csv, read_text};
use stellate::shape::{Form, FourierRadius, ImplicitCurve, ImplicitSurface};
use stellate::verb::{Fact, FitReport, Part, RadialReport};

/// The notes of two facts.
const IRREDUCIBLE: &str =
    "the irreducible equation, of degree 4; that it vanishes identically is proved by substitution";
const MISSING: &str = "not finished within the limits: the factors over Q";

fn write(form: &Form, facts: &[Fact], format: Format) -> String {
    let mut out = Vec::new();
    write_form(form, facts, format, &mut out).unwrap();
    String::from_utf8(out).unwrap()
}

fn read(text: &str) -> Form {
    read_text(text, "<form>", Numbers::Exact).unwrap_or_else(|e| panic!("{e}"))
}

const PAPER: &str =
    "100x^4 + 200x^2y^2 + 100y^4 - 40x^3 - 20x^2y - 40xy^2 - 20y^3 - 96x^2 + 4xy - 99y^2 = 0\n";

#[test]
fn the_text_is_what_people_write() {
    assert_eq!(write(&read(PAPER), &[], Format::Text), PAPER);
    for text in [
        "-x^2 + 1/3y = 0\n",
        "x - 1 = 0\n",
        "-1/2xy^2 - x + 3 = 0\n",
        "x^2 + z = 0\n",
    ] {
        assert_eq!(write(&read(text), &[], Format::Text), text);
    }
}

#[test]
fn every_format_of_one_curve() {
    let form = read("# center: 1/2, -3\nx^4 - x^2y/3 - 2y + 1");
    let irreducible = Fact::Irreducible {
        degree: 4,
        proof: EquationProof::Substitution,
    };
    let shown = |format| {
        write(
            &form,
            &[irreducible.clone(), Fact::Missing(Part::Factors)],
            format,
        )
    };
    assert_eq!(
        shown(Format::Text),
        format!(
            "# center: 1/2, -3\n# note: {IRREDUCIBLE}\n# note: {MISSING}\nx^4 - 1/3x^2y - 2y + 1 = 0\n"
        )
    );
    assert_eq!(
        shown(Format::Latex),
        format!(
            "% center: 1/2, -3\n% note: {IRREDUCIBLE}\n% note: {MISSING}\n\
             x^{{4}} - \\frac{{1}}{{3}} x^{{2}} y - 2 y + 1 = 0\n"
        )
    );
    assert_eq!(
        shown(Format::Sympy),
        format!(
            "x**4 - Rational(1, 3)*x**2*y - 2*y + 1  # center: 1/2, -3\n# note: {IRREDUCIBLE}\n# note: {MISSING}\n"
        )
    );
    assert_eq!(
        write(&form, &[], Format::Maple),
        "# center: 1/2, -3\nx^4 - 1/3*x^2*y - 2*y + 1 = 0;\n"
    );
    assert_eq!(
        write(&form, &[], Format::Singular),
        "// center: 1/2, -3\nring R = 0, (x, y), dp;\npoly F = x^4 - 1/3*x^2*y - 2*y + 1;\n"
    );
    assert_eq!(
        write(&form, &[], Format::Csv),
        "# center: 1/2, -3\ni,j,coefficient\n4,0,1\n2,1,-1/3\n0,1,-2\n0,0,1\n"
    );
    let json: serde_json::Value = serde_json::from_str(&shown(Format::Json)).unwrap();
    assert_eq!(
        json,
        serde_json::json!({
            "schema": "stellate/1", "kind": "implicit", "variables": ["x", "y"], "degree": 4,
            "homogeneous_degrees": [4, 3, 1, 0], "center": ["1/2", "-3"], "notes": [IRREDUCIBLE, MISSING],
            "irreducible": true,
            "terms": [
                {"exponents": [4, 0], "coefficient": "1"},
                {"exponents": [2, 1], "coefficient": "-1/3"},
                {"exponents": [0, 1], "coefficient": "-2"},
                {"exponents": [0, 0], "coefficient": "1"},
            ],
        })
    );
}

#[test]
fn every_format_of_one_radius() {
    let form = read("r = 1 + cos(t) - sin(t)/3 + 2/5cos(3t)");
    let shown = |format| write(&form, &[], format);
    assert_eq!(
        shown(Format::Text),
        "r = 1 + cos(t) - 1/3*sin(t) + 2/5*cos(3*t)\n"
    );
    assert_eq!(
        shown(Format::Latex),
        "r = 1 + \\cos \\theta - \\tfrac{1}{3} \\sin \\theta + \\tfrac{2}{5} \\cos 3\\theta\n"
    );
    assert_eq!(
        shown(Format::Sympy),
        "1 + cos(theta) - Rational(1, 3)*sin(theta) + Rational(2, 5)*cos(3*theta)\n"
    );
    assert_eq!(
        shown(Format::Maple),
        "r = 1 + cos(theta) - 1/3*sin(theta) + 2/5*cos(3*theta);\n"
    );
    assert_eq!(
        shown(Format::Csv),
        "n,cos,sin\n0,1,0\n1,1,-1/3\n2,0,0\n3,2/5,0\n"
    );
    let Form::Fourier(radius) = &form else {
        panic!()
    };
    let error = write_fourier(radius, None, Format::Singular, &mut Vec::new()).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("Singular has no trigonometric functions")
    );
}

#[test]
fn a_fit_is_reported() {
    let mut fit = FitReport::default();
    fit.radial = Some(RadialReport {
        max_error: 0.25,
        rms_error: f64::NAN,
        star_shaped: Some(true),
        samples: 360,
        outline: Some(Visibility {
            star_shaped: false,
            hidden_share: 0.0,
        }),
    });
    let radius = FourierRadius::new(vec![Rational::from(2)], vec![]);
    let mut out = Vec::new();
    write_fourier(&radius, Some(&fit), Format::Json, &mut out).unwrap();
    let json: serde_json::Value = serde_json::from_slice(&out).unwrap();
    assert_eq!(
        json.to_string(),
        serde_json::json!({
            "schema": "stellate/1", "kind": "fourier", "cos": ["2"], "sin": ["0"],
            "center": ["0", "0"], "max_radial_error": 0.25, "rms_radial_error": null,
            "star_shaped": true, "outline_star_shaped": false, "samples": 360, "hidden_share": 0.0,
        })
        .to_string()
    );
    for format in [Format::Text, Format::Sympy, Format::Maple] {
        let mut out = Vec::new();
        write_fourier(&radius, Some(&fit), format, &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        assert!(text.contains("# max_radial_error: 0.25"), "{text}");
    }
}

#[test]
fn numbers_of_json_are_taken_from_their_text() {
    let text = r#"{"schema":"stellate/1","kind":"fourier","extra":{},
        "cos":[0.1,"0x1.8p+1",1e-5,123456789012345678901234567890],"sin":[0,"1/3","-0.50",-2.5E1]}"#;
    let Form::Fourier(r) = read(text) else {
        panic!()
    };
    let shown = |values: &[Rational]| values.iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(
        shown(r.cosines()),
        ["1/10", "3", "1/100000", "123456789012345678901234567890"]
    );
    assert_eq!(shown(r.sines()), ["0", "1/3", "-1/2", "-25"]);
    let Ok(Form::Fourier(r)) = read_document(text, "a", Numbers::F64) else {
        panic!()
    };
    assert_eq!(r.cos(0), &0.1_f64.try_into().unwrap());
    assert_eq!(r.sin(1).to_string(), "1/3");
}

#[test]
fn a_parametric_document_gives_its_exact_radius() {
    let text = r#"{"schema":"stellate/1","kind":"parametric","branches":[
        {"factor":0,"fourier":{"kind":"fourier","cos":["1","2"],"sin":["0","0"]}}]}"#;
    assert_eq!(read(text), read("r = 1 + 2cos(t)"));
}

#[test]
fn what_is_wrong_with_a_document_is_said_with_its_place() {
    let implicit = |rest: &str| format!(r#"{{"schema":"stellate/1","kind":"implicit",{rest}}}"#);
    let terms = |terms: &str| implicit(&format!(r#""variables":["x","y"],"terms":[{terms}]"#));
    let fourier = |rest: &str| format!(r#"{{"schema":"stellate/1","kind":"fourier",{rest}}}"#);
    for (text, expected) in [
        (
            "{}".into(),
            "f.json: this is JSON, but no document of stellate",
        ),
        (
            r#"{"schema":"other/1"}"#.into(),
            "f.json: schema: expected \"stellate/1\"",
        ),
        (
            r#"{"schema":"stellate/1"}"#.into(),
            "f.json: the field \"kind\" is missing",
        ),
        (
            r#"{"schema":"stellate/1","kind":"description"}"#.into(),
            "f.json: kind: a document of kind \"description\" is no form",
        ),
        (
            r#"{"schema":"stellate/1","kind":"parametric","branches":[]}"#.into(),
            "f.json: branches: entry 0 is missing",
        ),
        (
            r#"{"schema":"stellate/1","kind":"parametric","branches":[{}]}"#.into(),
            "f.json: branches[0]: the field \"fourier\" is missing",
        ),
        (
            implicit(r#""variables":["x","w"]"#),
            "f.json: variables: expected [\"x\",\"y\"]",
        ),
        (
            implicit(r#""variables":["x","y"]"#),
            "f.json: the field \"terms\" is missing",
        ),
        (terms("1"), "f.json: terms[0]: expected an object"),
        (terms(""), "f.json: terms: the equation is 0 = 0"),
        (
            terms(r#"{"exponents":[1,0]}"#),
            "f.json: terms[0]: the field \"coefficient\" is missing",
        ),
        (
            terms(r#"{"exponents":[1,0,0],"coefficient":"1"}"#),
            "f.json: terms[0].exponents: expected 2 exponents",
        ),
        (
            terms(r#"{"exponents":[1,-1],"coefficient":"1"}"#),
            "f.json: terms[0].exponents[1]: expected a non-negative integer",
        ),
        (
            terms(r#"{"exponents":[1,0.5],"coefficient":"1"}"#),
            "f.json: terms[0].exponents[1]: expected a non-negative integer",
        ),
        (
            terms(r#"{"exponents":[1,0],"coefficient":"1/0"}"#),
            "f.json: terms[0].coefficient: the denominator is 0",
        ),
        (
            terms(r#"{"exponents":[1,0],"coefficient":"one"}"#),
            "f.json: terms[0].coefficient: expected a number",
        ),
        (
            terms(r#"{"exponents":[1,0],"coefficient":1},{"exponents":[1,0],"coefficient":2}"#),
            "f.json: terms[1].exponents: this term was given before",
        ),
        (
            fourier(r#""cos":[],"sin":[]"#),
            "f.json: cos: expected the coefficients",
        ),
        (
            fourier(r#""cos":[1,2],"sin":[0]"#),
            "f.json: sin: expected as many entries as in cos, 2; found 1",
        ),
        (
            fourier(r#""cos":[1],"sin":[1]"#),
            "f.json: sin: the first entry",
        ),
        (
            fourier(r#""cos":[1,[]],"sin":[0,0]"#),
            "f.json: cos[1]: expected a number",
        ),
        (
            fourier(r#""cos":[1],"sin":[0],"center":[1]"#),
            "f.json: center: expected two numbers",
        ),
        (
            fourier(r#""cos":[1],"sin":[0],"center":[1,"a"]"#),
            "f.json: center[1]: expected a",
        ),
    ] {
        let text: String = text;
        match read_document(&text, "f.json", Numbers::Exact) {
            Err(error @ Error::Data { .. }) => {
                assert!(error.to_string().starts_with(expected), "{text}\n{error}");
            }
            other => panic!("{text}: {other:?}"),
        }
    }
    let too_large = terms(r#"{"exponents":[20002,1],"coefficient":"1"}"#);
    let error = read_document(&too_large, "f.json", Numbers::Exact).unwrap_err();
    assert!(matches!(error, Error::Limit { .. }), "{error}");
    let error = read_text("{\n  \"schema\": oops}", "f.json", Numbers::Exact).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("f.json:2:13: not a JSON document"),
        "{error}"
    );
    let nested = "[".repeat(100_000);
    assert!(read_document(&nested, "f.json", Numbers::Exact).is_err());
}

#[test]
fn what_is_wrong_with_a_table_is_said_with_its_line() {
    for (text, expected) in [
        ("", "t.csv: there are no rows"),
        ("i,j,coefficient\n", "t.csv: there are no rows"),
        (
            "a,b,c\n1,2,3\n",
            "t.csv, line 1: expected the columns i,j,coefficient",
        ),
        ("1,2\n", "t.csv: expected the columns"),
        (
            "i,j,value\n1,0,1\n1,0\n",
            "t.csv, line 3: expected 3 columns, found 2",
        ),
        (
            "# center: 1,2\ni,j,value\n1,0,q\n",
            "t.csv, line 3: expected a number",
        ),
        (
            "1,-1,2\n",
            "t.csv, line 1: expected a non-negative integer, found `-1`",
        ),
        (
            "1,0,1\n1,0,2\n",
            "t.csv, line 2: this term was given before",
        ),
        ("0,0,1\n", "t.csv: the equation is a constant = 0"),
        ("# center: 1\n1,0,1\n", "t.csv, line 1: expected a center"),
    ] {
        let error = read_coefficients_csv(text, "t.csv", Numbers::Exact).unwrap_err();
        assert!(error.to_string().starts_with(expected), "{text}: {error}");
    }
    for (text, expected) in [
        ("0,1\n", "r.csv: expected the columns n,cos,sin"),
        ("0,1,1\n", "r.csv, line 1: the sine of harmonic 0 is 0"),
        (
            "1,1,1\n1,1,1\n",
            "r.csv, line 2: this harmonic was given before",
        ),
    ] {
        let error = read_fourier_csv(text, "r.csv", Numbers::Exact).unwrap_err();
        assert!(error.to_string().starts_with(expected), "{text}: {error}");
    }
}

fn rational() -> impl Strategy<Value = Rational> {
    prop_oneof![
        (-20i64..20, 1i64..9).prop_map(|(p, q)| Rational::from(p) / Rational::from(q)),
        (any::<i64>(), 1..i64::MAX).prop_map(|(p, q)| Rational::from(p) / Rational::from(q)),
        (any::<i64>(), 0i64..6)
            .prop_map(|(p, k)| { Rational::from(p) * Rational::from(i64::MAX).pow(k).unwrap() }),
    ]
}

fn center() -> impl Strategy<Value = [Rational; 2]> {
    prop_oneof![
        Just([Rational::zero(), Rational::zero()]),
        (rational(), rational()).prop_map(|(x, y)| [x, y]),
    ]
}

fn curve() -> impl Strategy<Value = Form> {
    let terms = prop::collection::vec(((0usize..12, 0usize..12), rational()), 1..20);
    (terms, center())
        .prop_map(|(terms, center)| (PlanePolynomial::from_terms(terms), center))
        .prop_filter("not a constant", |(f, _)| f.degree() > Some(0))
        .prop_map(|(f, center)| Form::Curve(ImplicitCurve::new(f).with_center(center)))
}

fn surface() -> impl Strategy<Value = Form> {
    let exponents = (0u32..9, 0u32..9, 0u32..9).prop_map(|(i, j, k)| [i, j, k]);
    prop::collection::vec((exponents, rational()), 1..20)
        .prop_map(SparsePolynomial::<3>::from_terms)
        .prop_filter("not a constant", |f| f.as_constant().is_none())
        .prop_map(|f| Form::Surface(ImplicitSurface::new(f)))
}

fn radius() -> impl Strategy<Value = FourierRadius> {
    let list = || prop::collection::vec(rational(), 0..9);
    (list(), list(), center())
        .prop_map(|(cos, sin, center)| FourierRadius::new(cos, sin).with_center(center))
}

proptest! {
    #[test]
    fn an_implicit_form_is_read_back_from_every_format(
        form in prop_oneof![curve(), surface()], noted in any::<bool>()
    ) {
        let notes: &[Fact] = if noted { &[Fact::PerfectSquare, Fact::Missing(Part::BeyondCurve)] } else { &[] };
        for format in [
            Format::Text, Format::Json, Format::Csv, Format::Sympy, Format::Maple, Format::Singular,
        ] {
            let text = write(&form, notes, format);
            let back = if format == Format::Csv {
                read_coefficients_csv(&text, "t.csv", Numbers::Exact)
            } else {
                read_text(&text, "<form>", Numbers::Exact)
            };
            prop_assert_eq!(&back.unwrap(), &form, "{}", text);
        }
        prop_assert!(write(&form, notes, Format::Latex).contains(" = 0\n"));
    }

    #[test]
    fn a_radius_is_read_back_from_every_format(radius in radius()) {
        let form = Form::Fourier(radius.clone());
        for format in [Format::Text, Format::Json, Format::Maple] {
            let text = write(&form, &[], format);
            prop_assert_eq!(&read_text(&text, "<form>", Numbers::Exact).unwrap(), &form);
        }
        let table = write(&form, &[], Format::Csv);
        prop_assert_eq!(&read_fourier_csv(&table, "r.csv", Numbers::Exact).unwrap(), &radius);
        if radius.harmonics() > 0 {
            // A constant expression alone does not say that it is a radius.
            let text = write(&form, &[], Format::Sympy);
            prop_assert_eq!(parse_form(&text, "<form>", Numbers::Exact).unwrap(), form);
        }
    }

    #[test]
    fn no_document_panics(text in r#"[\[\]{},:"a-z0-9./-]{0,80}"#) {
        let _ = read_document(&text, "f.json", Numbers::Exact);
        let _ = read_coefficients_csv(&text, "t.csv", Numbers::F64);
        let _ = read_fourier_csv(&text, "t.csv", Numbers::Exact);
    }
}

proptest! {
    #[test]
    fn what_is_displayed_is_parsed_back(curve in curve(), surface in surface(), radius in radius()) {
        for form in [curve, surface, Form::Fourier(radius)] {
            let text = form.to_string();
            prop_assert_eq!(&text.parse::<Form>().unwrap(), &form, "{}", text);
            match form {
                Form::Curve(curve) => {
                    prop_assert_eq!(&curve.to_string().parse::<ImplicitCurve>().unwrap(), &curve);
                    let f = curve.polynomial();
                    prop_assert_eq!(&f.to_string().parse::<PlanePolynomial>().unwrap(), f);
                }
                Form::Surface(surface) => {
                    prop_assert_eq!(&surface.to_string().parse::<ImplicitSurface>().unwrap(), &surface);
                    let f = surface.polynomial();
                    prop_assert_eq!(&f.to_string().parse::<SparsePolynomial<3>>().unwrap(), f);
                }
                Form::Fourier(radius) => {
                    prop_assert_eq!(&radius.to_string().parse::<FourierRadius>().unwrap(), &radius);
                }
                _ => prop_assert!(false, "another form"),
            }
        }
    }
}
