//! The topology of plane curves from end to end, and the pictures that leave nothing out.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use serde_json::Value;
use tempfile::TempDir;

use crate::common::program::{done, json, run_in};

fn topology(form: &str) -> Value {
    json(&done(&["describe", form, "--topology", "--format", "json"]))
}

fn list<'a>(value: &'a Value, name: &str) -> &'a Vec<Value> {
    value["topology"][name].as_array().unwrap()
}

#[test]
fn components_extents_and_what_contains_what() {
    let found = topology("(x^2+y^2-1)*(x^2+y^2-4)*(x^2+y^2-900)");
    let components = list(&found, "components");
    assert_eq!(components.len(), 3);
    let of_size = |r: &str| {
        let low = format!("-{r}");
        let extent = serde_json::json!([[low, r], [low, r]]);
        components
            .iter()
            .position(|c| c["extent"] == extent)
            .unwrap()
    };
    let [small, middle, large] = ["1", "2", "30"].map(of_size);
    assert_eq!(components[large]["contains"], serde_json::json!([middle]));
    assert_eq!(components[middle]["contains"], serde_json::json!([small]));
    assert_eq!(components[small]["contains"], serde_json::json!([]));
    // Extents that are no short decimals are rounded outward.
    let found = topology("x^2 + 3*y^2 = 2/9");
    let extent = &list(&found, "components")[0]["extent"];
    let number = |v: &Value| v.as_str().unwrap().parse::<f64>().unwrap();
    let exact = (2.0f64 / 9.0).sqrt();
    assert!(number(&extent[0][0]) <= -exact && number(&extent[0][1]) >= exact);
    assert!((number(&extent[0][1]) - exact).abs() < 1e-9);
    assert_eq!(
        list(&topology("x*y = 1"), "components")[0]["extent"],
        serde_json::json!([["-inf", "0"], ["-inf", "0"]])
    );
}

/// Ends that are short fractions are exact, for a radius, too, and for an equation that is recognized as one.
#[test]
fn rational_extents_are_exact() {
    for (form, expected) in [
        ("(x-3)^2 + y^2 = 9", [["0", "6"], ["-3", "3"]]),
        ("x^2 + y^2 = 6x + 8y", [["-2", "8"], ["-1", "9"]]),
        ("r = 4*sin(t)", [["-2", "2"], ["0", "4"]]),
    ] {
        let found = topology(form);
        let extent = &list(&found, "components")[0]["extent"];
        assert_eq!(*extent, serde_json::json!(expected), "{form}");
    }
    let found = topology("r = 1 + 2*cos(t)");
    let x = &list(&found, "components")[0]["extent"][0];
    assert_eq!(*x, serde_json::json!(["-0.125", "3"]));
}

#[test]
fn the_isolated_point_of_the_issue() {
    let found = topology("y^2=(x-1)^2*(x-2)");
    let kinds: Vec<&str> = list(&found, "components")
        .iter()
        .map(|c| c["kind"].as_str().unwrap())
        .collect();
    assert!(kinds.contains(&"point") && kinds.contains(&"unbounded"));
    let point = &list(&found, "singular_points")[0];
    assert_eq!(point["at"], serde_json::json!(["1", "0"]));
    assert_eq!(point["kind"], "isolated");
    assert_eq!(found["factors"][0]["genus"], 0);
    let text = done(&["describe", "--topology", "y^2=(x-1)^2*(x-2)"]);
    assert!(text.contains("isolated point (1, 0)"), "{text}");
    assert!(text.contains("genus: 0"), "{text}");
}

#[test]
fn conjugate_components_share_a_genus() {
    let found = topology("x^2 - 2y^2");
    assert_eq!(found["factors"][0]["genus"], 0);
    assert_eq!(found["factors"][0]["conjugate_components"], 2);
    let found = topology("x^3*y + y^3 + x");
    assert_eq!(found["factors"][0]["genus"], 3);
    assert!(found["factors"][0].get("conjugate_components").is_none());
}

#[test]
fn without_the_flag_there_is_no_topology() {
    let plain = json(&done(&["describe", "x^2 + y^2 = 1", "--format", "json"]));
    assert!(plain.get("topology").is_none());
    assert!(plain["factors"][0].get("genus").is_none());
}

#[test]
fn a_radius_is_described_by_its_series() {
    let egg = topology("r = 1 + 1/5*cos(t) + 0.1*sin(t)");
    let components = list(&egg, "components");
    assert_eq!(components.len(), 2);
    assert_eq!(components[0]["kind"], "oval");
    assert_eq!(components[0]["contains"], serde_json::json!([1]));
    assert_eq!(components[1]["kind"], "point");
    // With 40 harmonics the equation has degree 82.
    let terms: Vec<String> = (2..=40)
        .map(|n| format!("cos({n}*t)/{}", n * n * n))
        .collect();
    let radius = format!("r = 1 + {}", terms.join(" + "));
    let found = topology(&radius);
    assert_eq!(found["degree"], 82);
    assert_eq!(list(&found, "components").len(), 2);
    assert_eq!(found["factors"][0]["genus"], 0);
}

#[test]
fn forms_that_are_no_plane_curves_are_refused() {
    let folder = TempDir::new().unwrap();
    for form in [
        "x^2 + y^2 + z^2 = 1",
        "x = cos(t); y = sin(t); z = cos(t)^2",
        "R = 1 + Y(2,0)/5",
    ] {
        let output = run_in(folder.path(), &["describe", form, "--topology"], "");
        assert_eq!(output.code, 2, "{form}");
        let said = output.err;
        assert!(said.contains("--topology describes plane curves"), "{said}");
    }
}

#[test]
fn a_limit_leaves_the_rest_of_the_description() {
    let folder = TempDir::new().unwrap();
    let dense: Vec<String> = (0..=60)
        .flat_map(|i| {
            (0..=60 - i).map(move |j| format!("{}*x^{i}*y^{j}", 1 + (7 * i * i + 5 * j) % 11))
        })
        .collect();
    let form = dense.join(" + ");
    let args = ["describe", &form, "--topology", "--time-limit", "5"];
    let output = run_in(folder.path(), &args, "");
    assert_eq!(output.code, 3);
    let text = output.out;
    assert!(text.contains("degree: 60"), "{text}");
    let said = output.err;
    assert!(said.contains("the topology of the curve"), "{said}");
}

/// The points of all lines and dots of a plot, in the units of the picture, by reading the note and the window.
fn plotted(form: &str, more: &[&str]) -> (String, String) {
    let folder = TempDir::new().unwrap();
    let mut args = vec!["plot", form, "-o", "f.svg"];
    args.extend(more);
    let output = run_in(folder.path(), &args, "");
    assert_eq!(output.code, 0, "{form}");
    let svg = fs::read_to_string(folder.path().join("f.svg")).unwrap();
    (svg, output.err)
}

#[test]
fn a_single_point_is_in_the_middle_of_its_picture() {
    let (svg, said) = plotted("(x-50)^2 + y^2 = 0", &[]);
    let shown = "only the point (50, 0) was found to fit the picture to: it shows 49,51,-1,1";
    assert!(said.contains(shown), "{said}");
    let ticks = svg.lines().filter(|line| ["49", "50", "51"].contains(line));
    assert!(ticks.count() >= 2);
}

#[test]
fn a_formula_without_a_value_at_an_angle_is_noted() {
    let run = run_in(
        std::path::Path::new("."),
        &["parametrize", "y = x^2 + 1"],
        "",
    );
    let note = "where the part of degree 2 vanishes one root is infinite, and the other one is the limit of its formula";
    assert!(
        run.out.contains(note) || run.err.contains(note),
        "{}{}",
        run.out,
        run.err
    );
    // The leading part of an ellipse does not vanish.
    let run = run_in(
        std::path::Path::new("."),
        &["parametrize", "x^2 + 2*y^2 + x = 1"],
        "",
    );
    assert!(!run.out.contains("vanishes") && !run.err.contains("vanishes"));
}

#[test]
fn plots_hold_all_components() {
    let count = |svg: &str, tag: &str| svg.matches(tag).count();
    // Each circle is one closed line in the colour of the layer, and the legend has one.
    let lines = |svg: &str| count(svg, r##"stroke="#0072B2""##);
    let (one, note) = plotted("(x-10)^2+y^2=1", &[]);
    assert!(!note.contains("outside"), "{note}");
    let (two, note) = plotted("(x^2+y^2-1)*((x-10)^2+(y-3)^2-1)", &[]);
    assert!(!note.contains("outside"), "{note}");
    assert!(lines(&two) == lines(&one) + 1);
    let (three, note) = plotted("(x^2+y^2-1)*(x^2+y^2-4)*(x^2+y^2-900)", &[]);
    assert!(!note.contains("outside"), "{note}");
    // The small circles are traced by grids of their own, too.
    assert!(lines(&three) >= lines(&one) + 2);
    let dots = |svg: &str| count(svg, "<circle");
    let (isolated, _) = plotted("y^2=(x-1)^2*(x-2)", &[]);
    let (without, _) = plotted("y^2=x-2", &[]);
    assert!(dots(&isolated) > dots(&without));
    let (tiny, note) = plotted("(x^2+y^2-1)*((x-2)^2+y^2-1/1000000000000)", &[]);
    assert!(dots(&tiny) > 0);
    assert!(tiny.contains("dot: its tiny oval"));
    assert!(note.contains("is drawn as a dot"), "{note}");
}

#[test]
fn a_window_says_what_it_leaves_out() {
    let (_, note) = plotted(
        "(x^2+y^2-1)*((x-10)^2+(y-3)^2-1)*((x+8)^2+y^2)",
        &["--window=-2,2,-2,2"],
    );
    assert!(note.contains("outside of the window"), "{note}");
    assert!(
        note.contains("an oval with x in 9.000000 to 11.000000"),
        "{note}"
    );
    assert!(note.contains("the point (-8.000000, 0.000000)"), "{note}");
}
