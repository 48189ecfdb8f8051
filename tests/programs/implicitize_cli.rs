//! Parametric forms from end to end on the command line.

use crate::common::program::{done, done_in, json, piped, run_in};
use tempfile::TempDir;

const EXAMPLE_1: &str = "x = sin(t); y = sin(t)*cos(t)";
const EXAMPLE_3: &str = "x = sin(t); y = cos(t); z = cos(t)^2";
const EXAMPLE_4: &str = "x = cos(theta)*sin(phi); y = cos(theta); z = cos(phi)";

/// The lines that are no comments.
fn formulas(text: &str) -> Vec<&str> {
    text.lines().filter(|line| !line.starts_with('#')).collect()
}

#[test]
fn the_answer_does_not_depend_on_the_method() {
    for method in [&[][..], &["--method", "polar"], &["--method", "resultant"]] {
        let out = done(&[&["implicitize", EXAMPLE_1], method].concat());
        assert_eq!(formulas(&out), ["x^4 - x^2 + y^2 = 0"], "{method:?}");
    }
    for method in [&[][..], &["--method", "polar"]] {
        let out = done(&[&["implicitize", EXAMPLE_3], method].concat());
        assert_eq!(formulas(&out), ["x^2 + y^2 - 1 = 0", "x^2 + z - 1 = 0"]);
        let out = done(&[&["implicitize", EXAMPLE_4], method].concat());
        assert_eq!(formulas(&out), ["y^2z^2 + x^2 - y^2 = 0"]);
    }
    let radius = "r = 1 + 1/5*cos(3*t)";
    let theorem_2 = done(&["implicitize", radius]);
    let eliminated = done(&["implicitize", radius, "--method", "resultant"]);
    assert_eq!(formulas(&theorem_2), formulas(&eliminated));
    let given = "x = (1 + cos(3t)/5)*cos(t); y = (1 + cos(3t)/5)*sin(t)";
    assert_eq!(
        formulas(&theorem_2),
        formulas(&done(&["implicitize", given]))
    );
}

#[test]
fn documents_say_what_was_found() {
    let polar = [
        "implicitize",
        EXAMPLE_1,
        "--method",
        "polar",
        "--format",
        "json",
    ];
    let document = json(&done(&polar));
    assert_eq!(
        (&document["kind"], &document["tracing_index"]),
        (&"implicit".into(), &1.into())
    );
    let roles: Vec<_> = document["polar"]["factors"]
        .as_array()
        .unwrap()
        .iter()
        .map(|f| &f["role"])
        .collect();
    assert_eq!(roles, ["squared-radius", "form"]);

    let document = json(&done(&[
        "implicitize",
        "x = t^2; y = t^3 + t",
        "--format",
        "json",
    ]));
    assert_eq!(document["beyond"][0]["point"], "(-1, 0)");

    let space = [
        "implicitize",
        EXAMPLE_3,
        "--method",
        "polar",
        "--format",
        "json",
    ];
    let text = done(&space);
    let document = json(&text);
    assert_eq!(
        (&document["kind"], &document["schema"]),
        (&"intersection".into(), &"stellate/1".into())
    );
    assert_eq!(document["surfaces"].as_array().unwrap().len(), 2);
    assert_eq!(document["components"][1][1], "y^2 + z");
    assert_eq!(document["curve_degree"], 4);
    // What is written is read, from JSON and from text.
    let again = piped(&["implicitize", "-"], &text);
    assert_eq!(again, "x^2 + y^2 - 1 = 0\nx^2 + z - 1 = 0\n");
    assert_eq!(piped(&["implicitize", "-"], &again), again);
    let singular = done(&["implicitize", EXAMPLE_3, "--format", "singular"]);
    assert!(singular.contains("poly F = x^2 + y^2 - 1"), "{singular}");

    let document = json(&done(&["describe", EXAMPLE_4, "--format", "json"]));
    assert_eq!(document["coordinates"]["x"], "cos(theta)*sin(phi)");
    assert_eq!(document["tracing_index_proved"], false);
    assert_eq!(document["method"], "lemma-7");
}

#[test]
fn a_parametric_document_is_a_form() {
    let document = r#"{"schema":"stellate/1","kind":"parametric","parameters":["t"],
        "coordinates":{"x":"sin(t)","y":"1/2*sin(2*t)"}}"#;
    let out = piped(&["implicitize", "-"], document);
    assert_eq!(formulas(&out), ["x^4 - x^2 + y^2 = 0"]);
    let folder = TempDir::new().unwrap();
    let wrong = document.replace("sin(2*t)", "exp(t)");
    let run = run_in(folder.path(), &["implicitize", "-"], &wrong);
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("coordinates:2:") && run.err.contains("not algebraic"),
        "{}",
        run.err
    );
}

#[test]
fn other_verbs_go_through_the_equation() {
    let equation = "x^4 - x^2 + y^2";
    let same = |arguments: &[&str]| {
        let with = |form: &str| {
            let all: Vec<&str> = arguments
                .iter()
                .map(|a| if *a == "FORM" { form } else { a })
                .collect();
            done(&all)
        };
        assert_eq!(with(EXAMPLE_1), with(equation), "{arguments:?}");
    };
    same(&["sample", "FORM", "--directions", "7"]);
    same(&["parametrize", "FORM"]);
    let described = done(&["describe", EXAMPLE_1]);
    assert!(described.contains("method: lemma-2 in r^2"), "{described}");
    assert!(
        described.contains("note: parametric form: x = sin(t); y = 1/2*sin(2*t)"),
        "{described}"
    );
    let described = done(&["describe", "x^2 + y^2 = 1; z = y^5"]);
    assert!(
        described.contains("equation of degree 5: y^5 - z = 0"),
        "{described}"
    );
}

#[test]
fn pictures_in_the_plane_and_in_space() {
    let folder = TempDir::new().unwrap();
    let draw = |arguments: &[&str]| {
        done_in(
            folder.path(),
            &[&["plot"], arguments, &["-o", "figure.svg"]].concat(),
            "",
        );
        std::fs::read_to_string(folder.path().join("figure.svg")).unwrap()
    };
    let plane = draw(&[EXAMPLE_1, "x^4 - x^2 + y^2"]);
    assert!(plane.contains("parametric curve, x = sin(t)") && plane.contains("zero set, degree 4"));
    let facets = |svg: &str| svg.matches("<polygon").count();
    let patch = draw(&[EXAMPLE_4, "--title", "Example 4"]);
    assert!(
        patch.contains("Example 4") && facets(&patch) > 2000,
        "{}",
        facets(&patch)
    );
    for name in ["x", "y", "z"] {
        assert!(
            patch.lines().any(|line| line.trim() == name),
            "the axis {name} has its name"
        );
    }
    // Three walls and no facet; a shadow.
    let curve = draw(&[EXAMPLE_3]);
    assert_eq!(facets(&curve), 3);
    assert!(curve.contains("#B9B9B9"));
    // A part of the surface has as many facets, and its legend says so.
    let part = draw(&[
        "x = u; y = v; z = u*v",
        "--range",
        "u=0,2",
        "--view",
        "10,40",
    ]);
    assert!(part.contains("u from 0 to 2, v from -1.5 to 1.5"));
    let thin = draw(&["x = u; y = v; z = 40u^2"]);
    assert!(thin.contains("the axes do not have one unit of length"));
}

#[test]
fn mistakes_are_said_once_and_nothing_is_written() {
    let folder = TempDir::new().unwrap();
    for (arguments, message) in [
        (
            &["implicitize", "x = 1; y = cos(t)^2 + sin(t)^2"][..],
            "a point, not a curve",
        ),
        (
            &["implicitize", "x = u + v; y = 2u + 2v; z = 1"],
            "move along a curve only",
        ),
        (
            &["implicitize", EXAMPLE_4, "--method", "resultant"],
            "is for plane curves",
        ),
        (
            &["implicitize", "x^2 + y^2 = 1", "--method", "polar"],
            "this one is implicit already",
        ),
        (
            &["implicitize", EXAMPLE_3, "--format", "csv"],
            "several equations",
        ),
        (&["implicitize", "x = t*sin(t); y = 1"], "not algebraic"),
        (
            &["implicitize", "x = t; y = 2t", "--method", "polar"],
            "line through the origin",
        ),
        (
            &["sample", EXAMPLE_3],
            "sample takes plane curves, surfaces and intersections",
        ),
        (
            &["parametrize", EXAMPLE_3],
            "parametrize takes plane curves, surfaces and intersections",
        ),
        (
            &["plot", EXAMPLE_3, "r = 1 + cos(t)/3", "-o", "f.svg"],
            "cannot be drawn with one in space",
        ),
        (
            &["plot", EXAMPLE_3, "--point", "1,2", "-o", "f.svg"],
            "expected X,Y,Z",
        ),
        (
            &["plot", EXAMPLE_3, "--view", "30", "-o", "f.svg"],
            "expected AZIMUTH,ELEVATION",
        ),
        (
            &["plot", EXAMPLE_3, "--range", "t=2,1", "-o", "f.svg"],
            "expected NAME=A,B",
        ),
        (
            &["plot", EXAMPLE_3, "--window", "0,1,0,1", "-o", "f.svg"],
            "expected X0,X1,Y0,Y1,Z0,Z1",
        ),
        (
            &["plot", EXAMPLE_3, "--harmonics", "3", "-o", "f.svg"],
            "--harmonics is for contours",
        ),
    ] {
        let run = run_in(folder.path(), arguments, "");
        assert_eq!(
            (run.code, run.out.as_str()),
            (2, ""),
            "{arguments:?}: {}",
            run.err
        );
        assert!(run.err.contains(message), "{arguments:?}: {}", run.err);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}

#[test]
fn limits_end_with_code_3_and_say_what_is_known() {
    let folder = TempDir::new().unwrap();
    let large = "x = u^7 + v; y = v^7 + u; z = u^5*v^5 + 1";
    let run = run_in(folder.path(), &["implicitize", large], "");
    assert_eq!(run.code, 3, "{}", run.err);
    assert!(
        run.err
            .contains("there is no equation of degree 18 or less"),
        "{}",
        run.err
    );
    let curve = "x = (t^200 + 3t + 1)/(t^199 + 7); y = (5t^200 + t^3 - 2)/(t^100 + 3)";
    let run = run_in(folder.path(), &["implicitize", curve], "");
    assert_eq!(run.code, 3, "{}", run.err);
    let run = run_in(
        folder.path(),
        &["implicitize", EXAMPLE_1, "--max-degree", "3"],
        "",
    );
    assert_eq!(run.code, 3, "{}", run.err);
}

/// Hundreds of kilobytes: more than one thread writes them.
#[test]
fn long_equations_are_the_same_for_any_number_of_threads_and_are_read_back() {
    let folder = TempDir::new().unwrap();
    let mut state = 1_u64;
    let mut dyadic = |n: u32| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        let digits = i64::try_from(state >> 12).unwrap() - (1 << 51);
        format!(
            "{digits}/{}",
            u128::from(1_u64 << 54) * u128::from(n.next_power_of_two())
        )
    };
    let rows = (1..=200).map(|n| format!("{n},{},{}\n", dyadic(n), dyadic(n)));
    let table = format!("n,cos,sin\n0,1,0\n{}", rows.collect::<String>());
    std::fs::write(folder.path().join("radius.csv"), table).unwrap();
    let mut documents = Vec::new();
    for format in ["text", "json", "csv", "sympy"] {
        let [one, three] = ["1", "3"].map(|threads| {
            let arguments = [
                "implicitize",
                "radius.csv",
                "--format",
                format,
                "--threads",
                threads,
            ];
            done_in(folder.path(), &arguments, "")
        });
        assert!(one == three, "{format}");
        assert!(one.len() > 100_000, "{format}: {} bytes", one.len());
        documents.push(one);
    }
    for (text, name) in documents
        .iter()
        .zip(["equation.txt", "equation.json", "equation.csv"])
    {
        std::fs::write(folder.path().join(name), text).unwrap();
        let again = done_in(folder.path(), &["implicitize", name], "");
        assert!(again == documents[0], "{name}");
    }
}

#[test]
fn a_point_on_a_real_branch_is_not_called_isolated() {
    for (form, is_isolated) in [
        ("x = t^3 + t; y = t^4 + t^2", false),
        ("x = t^2 + 1; y = t^3 + t", true),
        // t = infinity has the point of t = i and t = -i.
        ("x = (t^2 + 1)/(t^4 + 2); y = (t^3 + t)/(t^4 + 2)", false),
        ("x = (t^2 + 1)/(t^2 + 2); y = (t^3 + t)/(t^2 + 2)", true),
        // The same with tan(t/2), of which infinity is a value like any other.
        ("x = (1 + cos(t))*cos(t); y = (1 + cos(t))*sin(t)", false),
        ("x = (2 + cos(t))*cos(t); y = (2 + cos(t))*sin(t)", true),
    ] {
        // The same curve in the plane, and in space.
        for (form, origin) in [
            (form.to_owned(), "(0, 0)"),
            (format!("{form}; z = 0"), "(0, 0, 0)"),
        ] {
            let document = json(&done(&["implicitize", &form, "--format", "json"]));
            let beyond = document["beyond"].as_array().unwrap();
            let isolated = beyond
                .iter()
                .any(|entry| entry["kind"] == "isolated" && entry["point"] == origin);
            assert_eq!(isolated, is_isolated, "{form}");
        }
    }
}

#[test]
fn the_tracing_indices_count_over_what_the_angle_runs_through() {
    for (form, complex, real) in [
        ("x = cos(t); y = cos(2t)", 2, 2),
        ("x = cos(2t); y = sin(2t)", 2, 2),
        ("x = cos(t)^2 - sin(t)^2; y = 2*sin(t)*cos(t)", 2, 2),
        ("x = cos(t/2); y = sin(t/2)", 1, 1),
        ("x = t^3; y = t^6", 3, 1),
        ("x = t^2; y = t^4", 2, 2),
        ("x = cos(3t)*cos(t); y = cos(3t)*sin(t)", 2, 2),
        ("x = cos(2t); y = sin(2t); z = cos(4t)", 2, 2),
    ] {
        let document = json(&done(&["implicitize", form, "--format", "json"]));
        assert_eq!(
            (&document["tracing_index"], &document["real_tracing_index"]),
            (&complex.into(), &real.into()),
            "{form}"
        );
    }
    // Not the same everywhere: once outside of |x| < 2, three times inside.
    let form = "x = t^3 - 3t; y = (t^3 - 3t)^2";
    let document = json(&done(&["implicitize", form, "--format", "json"]));
    assert_eq!(document["real_tracing_index"], serde_json::Value::Null);
    assert_eq!(document["real_tracing_indices"], serde_json::json!([1, 3]));
    let text = done(&["implicitize", form]);
    assert!(
        text.contains("over some arcs of the curve once, over others 3 times"),
        "{text}"
    );
}

#[test]
fn what_is_finished_at_a_limit_is_written_and_says_what_is_missing() {
    let folder = TempDir::new().unwrap();
    // Of degree 169 and without a factor that is found soon.
    let f =
        "(x^97+y^89+3*x^7*y^50+x*y^39+7*x^20*y^10+11*y^3*x^2+5)*(x^61*y^2+x^5+2*y^70+13-x^33*y^31)";
    let arguments = [
        "describe",
        f,
        "--time-limit",
        "1",
        "--format",
        "json",
        "-o",
        "d.json",
    ];
    let run = run_in(folder.path(), &arguments, "");
    assert_eq!(run.code, 3, "{}", run.err);
    assert!(
        run.err.contains("what is written lacks the factors over Q"),
        "{}",
        run.err
    );
    let document = json(&std::fs::read_to_string(folder.path().join("d.json")).unwrap());
    assert_eq!(document["degree"], 167);
    assert_eq!(document["factors"], serde_json::Value::Null);
    assert_eq!(document["irreducible"], serde_json::Value::Null);
    let note = "not finished within the limits: the factors over Q";
    assert_eq!(document["notes"], serde_json::json!([note]));
    let text = run_in(folder.path(), &["describe", f, "--time-limit", "1"], "");
    assert_eq!(text.code, 3);
    assert!(
        text.out.contains("irreducible over Q: not decided\n"),
        "{}",
        text.out
    );
}

/// The equation of a radius is described even if its zeros are not found in time.
#[test]
fn a_radius_is_described_without_its_ranges_at_a_limit() {
    let folder = TempDir::new().unwrap();
    let radius = "r = 3cos(901t)+sin(803t)+cos(3t)";
    let arguments = [
        "describe",
        radius,
        "--time-limit",
        "0.5",
        "--format",
        "json",
    ];
    let run = run_in(folder.path(), &arguments, "");
    assert_eq!(run.code, 3, "{}", run.err);
    assert!(
        run.err
            .contains("what is written lacks the angles with r > 0"),
        "{}",
        run.err
    );
    let document = json(&run.out);
    assert_eq!(document["degree"], 902);
    assert_eq!(document["irreducible"], true);
    let note = "not finished within the limits: the angles with r > 0";
    assert_eq!(document["notes"], serde_json::json!([note]));
}
