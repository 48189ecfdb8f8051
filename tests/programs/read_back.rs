//! What `parametrize` writes is read back by every verb as the form that it is the parametrization of.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use stellate::document::{Format, write_parametrized};
use stellate::language::Numbers;
use stellate::poly::PlanePolynomial;
use stellate::reading::read_text;
use stellate::shape::{Form, ImplicitCurve};
use stellate::verb::{self, Given, ParametrizeOptions, Work};
use tempfile::TempDir;

use crate::common::program::{done, done_in, json, piped, run_in, strings};

const READ: [&str; 4] = ["json", "text", "sympy", "maple"];

/// Forms, and the equation that they are read back as.
const FORMS: [(&str, &str); 10] = [
    ("x^2/4 + y^2/9 = 1", "9x^2 + 4y^2 = 36"),
    ("(x, y) = (t^2, t^3)", "x^3 - y^2"),
    ("x^2*y - 1/3", "3x^2*y = 1"),
    (
        "(x^2 + y^2 - x)*(x^2 + y^2 - 4)*(x - y)",
        "(x^2 + y^2 - x)*(x^2 + y^2 - 4)*(x - y)",
    ),
    (
        "(x^2 + y^2 - 4)*(x^2 + y^2 - 9)",
        "(x^2 + y^2 - 4)*(x^2 + y^2 - 9)",
    ),
    (
        "superquadric 2d a=1,2/3 e=3/5",
        "superquadric 2d a=1,2/3 e=3/5",
    ),
    ("x^2/4 + y^2/9 + z^2 = 1", "9x^2 + 4y^2 + 36z^2 = 36"),
    ("x = u, y = v, z = u*v", "x*y = z"),
    ("x^2 + y^2 + 0*z = 1", "x^2 + y^2 + 0*z = 1"),
    (
        "superquadric 3d a=1,1,2 e=1/2,1 level=3",
        "superquadric 3d a=1,1,2 e=1/2,1 level=3",
    ),
];

#[test]
fn every_verb_reads_what_parametrize_writes() {
    for (form, equation) in FORMS {
        let form = form.replace("(x, y) = ", "");
        let folder = TempDir::new().unwrap();
        let run = |arguments: &[&str]| run_in(folder.path(), arguments, "");
        for format in READ {
            let written = run(&["parametrize", &form, "--format", format, "-o", format]);
            assert_eq!(written.code, 0, "{form} as {format}: {}", written.err);
        }
        let mut jobs = vec![
            vec!["describe", "FORM"],
            vec!["sample", "FORM", "--directions", "7"],
            vec!["plot", "FORM", "-o", "f.svg"],
        ];
        if !form.contains("e=3/5") {
            jobs.push(vec!["implicitize", "FORM"]);
        }
        if equation.contains('z') && !form.contains("superquadric") {
            let inspect = "inspect FORM --tolerance 0.1 --point 7,8,9";
            jobs.push(inspect.split(' ').collect());
        }
        for job in jobs {
            let answer = |form: &str| {
                let arguments: Vec<String> = job.iter().map(|a| a.replace("FORM", form)).collect();
                let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
                let answer = run(&arguments);
                // The point is outside.
                let code = i32::from(job[0] == "inspect");
                assert_eq!(answer.code, code, "{form}: {}", answer.err);
                match job[0] {
                    "plot" => std::fs::read_to_string(folder.path().join("f.svg")).unwrap(),
                    _ => answer.out,
                }
            };
            let plain = |text: &str| text.replace("radii.txt", "FORM").replace(equation, "FORM");
            let expected = answer(equation);
            for format in READ {
                let text = std::fs::read_to_string(folder.path().join(format)).unwrap();
                let context = format!("{form} as {format}, {job:?}: {text}");
                std::fs::write(folder.path().join("radii.txt"), &text).unwrap();
                assert_eq!(plain(&answer("radii.txt")), plain(&expected), "{context}");
                if job[0] == "implicitize" {
                    let through_pipe = piped(&["implicitize", "-"], &text);
                    assert_eq!(through_pipe, expected, "{context}");
                }
            }
        }
    }
}

#[test]
fn several_radii_are_a_list_in_sympy_and_one_is_an_expression() {
    let written = |form: &str| {
        let folder = TempDir::new().unwrap();
        done_in(
            folder.path(),
            &["parametrize", form, "--format", "sympy"],
            "",
        )
    };
    assert_eq!(
        written("x^2*y^2 = 1").lines().next().unwrap(),
        "[sqrt(1/(cos(theta)*sin(theta))), -sqrt(1/(cos(theta)*sin(theta))), sqrt((-1)/(cos(theta)*sin(theta))), -sqrt((-1)/(cos(theta)*sin(theta)))]"
    );
    assert_eq!(
        written("(x^2 + y^2 - x)*(x^2 + y^2 - 4)"),
        "[cos(theta), 2, -2]\n# parametrizes: x^4 + 2x^2y^2 + y^4 - x^3 - xy^2 - 4x^2 - 4y^2 + 4x = 0\n"
    );
    assert_eq!(
        written("x^3 = y^2").lines().next().unwrap(),
        "sin(theta)**2/cos(theta)**3"
    );
    // A number alone is no radius.
    assert_eq!(written("x^2 + y^2 = 4"), "2  # parametrizes: r = 2\n");
    assert_eq!(
        piped(&["implicitize", "-"], &written("x^2 + y^2 = 4")),
        "x^2 + y^2 - 4 = 0\n"
    );
    assert_eq!(
        written("r = 1 + cos(t)/5"),
        "1 + Rational(1, 5)*cos(theta)\n"
    );
}

#[test]
fn a_center_stays_and_places_of_errors_are_those_of_the_text() {
    let radii =
        "# lemma-2 in r^2\n# center: 1/2, -3\n# parametrizes: x^2/4 + y^2 = 1\nr = sqrt(1)\n";
    let Form::Curve(curve) = read_text(radii, "radii.txt", Numbers::Exact).unwrap() else {
        panic!("a plane curve")
    };
    assert_eq!(curve.center(), &["1/2".parse().unwrap(), (-3).into()]);
    let wrong = radii.replace("y^2", "q^2");
    let error = read_text(&wrong, "radii.txt", Numbers::Exact).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("radii.txt:3:25: unknown name `q`"),
        "{error}"
    );
}

/// Products of one to three small factors, some of which are lines, circles or without any real point.
fn products() -> impl Strategy<Value = PlanePolynomial> {
    let term = ((0_usize..3, 0_usize..3), -3_i64..4);
    let factor = prop::collection::vec(term, 1..4);
    prop::collection::vec(factor, 1..4).prop_map(|factors| {
        let one = PlanePolynomial::from_terms([((0, 0), 1.into())]);
        let polynomial = |terms: Vec<((usize, usize), i64)>| {
            PlanePolynomial::from_terms(terms.into_iter().map(|(e, c)| (e, c.into())))
        };
        factors
            .into_iter()
            .fold(one, |product, f| &product * &polynomial(f))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// The document is read back as its polynomial, or as a radius or a fit with the same document.
    #[test]
    fn the_polynomial_or_all_of_its_radii_come_back(f in products()) {
        prop_assume!(f.degree().is_some_and(|d| d > 0));
        let curve = ImplicitCurve::new(f.clone());
        let work = Work::default();
        let options = ParametrizeOptions::default();
        let parametrized = verb::parametrize(Given::from(Form::Curve(curve)), &options, &work);
        let Ok(found) = parametrized else { return Err(TestCaseError::reject("no parametrization")) };
        for format in [Format::Json, Format::Text] {
            let mut text = Vec::new();
            write_parametrized(&found, 16, format, &mut text).unwrap();
            let text = String::from_utf8(text).unwrap();
            match read_text(&text, "<form>", Numbers::Exact) {
                Ok(Form::Curve(back)) => prop_assert_eq!(back.polynomial(), &f, "{}", text),
                Ok(Form::Fourier(radius)) => {
                    // All of it: the squared form is the one factor, up to its power; or it is the fit of Lemma 6.
                    if !text.contains("lemma-6") {
                        let given = Given::from(Form::Fourier(radius));
                        let back = verb::implicitize(given, &verb::ImplicitizeOptions::default(), &work).unwrap();
                        let Form::Curve(back) = back.form else { panic!("a plane curve") };
                        let squarefree = vanishes_alike(&f, back.polynomial());
                        prop_assert!(squarefree, "{text}");
                    }
                }
                other => prop_assert!(false, "{other:?}: {text}"),
            }
        }
    }
}

/// Whether f is a constant times a power of the irreducible g, perhaps times powers of x² + y² that Theorem 2 brings in.
fn vanishes_alike(f: &PlanePolynomial, g: &PlanePolynomial) -> bool {
    let factors = |f: &PlanePolynomial| {
        let found = stellate::factor::factor_plane(f, &stellate::limits::Limits::none()).unwrap();
        let polynomials = found.factors.into_iter().map(|f| f.polynomial.monic());
        polynomials.collect::<Vec<_>>()
    };
    let (f, g) = (factors(f), factors(g));
    f.len() == 1 && g.contains(&f[0])
}

#[test]
fn the_fit_of_lemma_6_is_read_as_the_fit() {
    let folder = TempDir::new().unwrap();
    let run = |arguments: &[&str]| done_in(folder.path(), arguments, "");
    run(&[
        "parametrize",
        "x^6 + y^6 + x*y^3 = 1 + x",
        "--format",
        "json",
        "-o",
        "radii.json",
    ]);
    let described = run(&["describe", "radii.json"]);
    assert!(described.contains("harmonics: "), "{described}");
}

/// R = 2 + cos(phi)/2 about (1, 2, 3).
const OFF_CENTER: &str = "# center: 1, 2, 3\nR = 2 + cos(phi)/2\n";

#[test]
fn the_center_of_a_surface_stays_in_every_format() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    std::fs::write(folder.join("surface.txt"), OFF_CENTER).unwrap();
    let is_on = |name: &str| {
        let pole = ["inspect", name, "--tolerance", "1e-9", "--point", "1,2,5.5"];
        let row = done_in(folder, &pole, "");
        assert!(
            row.ends_with("1,2,5.5,inside,true,0.0,0.0,0\n"),
            "{name}: {row}"
        );
    };
    is_on("surface.txt");
    for (verb, format, name) in [
        ("implicitize", "json", "f.json"),
        ("implicitize", "text", "f.txt"),
        ("implicitize", "csv", "f.csv"),
        ("implicitize", "sympy", "f.py.txt"),
        ("implicitize", "maple", "f.mpl.txt"),
        ("implicitize", "singular", "f.sing.txt"),
        ("parametrize", "text", "r.txt"),
        ("parametrize", "json", "r.json"),
        ("parametrize", "csv", "r.csv"),
        ("parametrize", "sympy", "r.py.txt"),
    ] {
        let command = [
            verb,
            "surface.txt",
            "--format",
            format,
            "-o",
            name,
            "--quiet",
        ];
        done_in(folder, &command, "");
        is_on(name);
        if verb == "implicitize" {
            let original = [&command[..], &["--coordinates", "original"]].concat();
            done_in(folder, &original, "");
            is_on(name);
        }
    }
    let equation = json(&done_in(
        folder,
        &["implicitize", "surface.txt", "--format", "json"],
        "",
    ));
    assert_eq!(strings(&equation["center"]), ["1", "2", "3"]);
    // The program's own equation is right, and so is one without a center, which is taken as relative to it.
    for (format, name) in [("csv", "own.csv"), ("json", "own.json")] {
        let write = ["implicitize", "surface.txt", "--format", format, "-o", name];
        done_in(folder, &write, "");
        done_in(
            folder,
            &["check", "surface.txt", "--coefficients", name],
            "",
        );
        let text = std::fs::read_to_string(folder.join(name)).unwrap();
        let bare = text
            .replace("# center: 1, 2, 3\n", "")
            .replace("\"center\":[\"1\",\"2\",\"3\"],", "");
        assert_ne!(bare, text);
        std::fs::write(folder.join(name), bare).unwrap();
        done_in(
            folder,
            &["check", "surface.txt", "--coefficients", name],
            "",
        );
    }
    let vectors = json(&done_in(folder, &["vectors", "surface.txt", "--quiet"], ""));
    assert_eq!(strings(&vectors["center"]), ["1", "2", "3"]);
    let samples = [
        "sample",
        "surface.txt",
        "--theta",
        "0",
        "--phi",
        "0",
        "--coordinates",
    ];
    for (coordinates, row) in [
        ("center", "2.5,0.0,0.0,2.5,1"),
        ("original", "2.5,1.0,2.0,5.5,1"),
    ] {
        let found = done_in(folder, &[&samples[..], &[coordinates]].concat(), "");
        assert!(found.contains(row), "{found}");
    }
    // A center with the wrong number of coordinates.
    for (text, expected) in [
        (
            "# center: 1, 2\nx^2 + y^2 + z^2 = 1\n",
            "a center of two coordinates belongs to a plane curve",
        ),
        (
            "# center: 1, 2, 3\nx^2 + y^2 = 1\n",
            "a center of three coordinates belongs to a surface",
        ),
        (
            "# center: 1, 2\nl,m,value\n0,0,2\n",
            "a center of two coordinates belongs to a plane curve",
        ),
    ] {
        let run = run_in(folder, &["describe", "-"], text);
        assert_eq!(run.code, 2, "{text}: {}", run.out);
        assert!(run.err.contains(expected), "{text}: {}", run.err);
    }
}

#[test]
fn an_intersection_is_read_back_whole() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    for form in [
        // Two curves; no formula; no curve; one point; a curve and a component without a formula.
        "x*z = y; y*z = x^2",
        "x^2+y^2+z^2 = 1; x^2+y^2 = z^2",
        "x^2+y^2+z^2 = 1; z = 2",
        "x^2+y^2+z^2 = 1; z = 1",
        "x*(x^2+y^2+z^2-1) = 0; x^2+y^2 = z^2",
        // A curve and an isolated point, which no parameter reaches.
        "x^2+y^2 = z^3-z^2; y = 0",
    ] {
        let expected = done(&["describe", form]);
        for format in ["json", "text", "sympy", "maple"] {
            let name = if format == "json" {
                "curves.json"
            } else {
                "curves.txt"
            };
            let command = ["parametrize", form, "--format", format, "-o", name];
            let run = run_in(folder, &command, "");
            if form.starts_with("x^2+y^2+z^2 = 1; x^2") && ["sympy", "maple"].contains(&format) {
                // There are only arcs, which only text and JSON can hold.
                assert_eq!(run.code, 2, "{form} as {format}");
                continue;
            }
            assert_eq!(run.code, 0, "{form} as {format}: {}", run.err);
            assert_eq!(
                done_in(folder, &["describe", name], ""),
                expected,
                "{form}: {name}"
            );
        }
    }
    let two = ["parametrize", "x*z = y; y*z = x^2", "--format"];
    for (format, expected) in [
        ("sympy", "[(0, 0, t), (t**2, t**3, t)]\n# parametrizes: "),
        (
            "maple",
            "curves := [[0, 0, t], [t^2, t^3, t]];\n# parametrizes: ",
        ),
    ] {
        let written = done(&[&two[..], &[format]].concat());
        assert!(written.starts_with(expected), "{written}");
    }
    // One curve is the whole intersection, except a point that it approaches.
    let cusp = done(&["parametrize", "x^2 = y^3; z = y", "--format", "json"]);
    assert!(piped(&["describe", "-"], &cusp).contains("parametric form: x = 1/t^3"));
}
