//! Real roots in a direction, their multiplicities and their nearest doubles.

use super::{
    CIRCLE, LINES, MULTIPLE, assert_accepted, assert_each_matters, assert_refused, document,
};

#[test]
fn roots_in_a_direction_have_their_nearest_doubles() {
    let text = document(
        &[CIRCLE],
        "root-count",
        r#"{"form":0,"direction":["3/5","4/5"],"order_at_zero":0,"center":["1","0"],
            "roots":[{"multiplicity":1,"nearest":"-0.5"},{"multiplicity":1,"nearest":"0.5","position":["1.3","0.4"]}]}"#,
        r#"{"breakpoints":["0"]}"#,
    );
    let changes = [
        (r#""3/5""#, r#""3/6""#, "statement.direction"),
        (r#""order_at_zero":0"#, r#""order_at_zero":1"#, ""),
        (r#"{"multiplicity":1,"nearest":"-0.5"},"#, "", ""),
        (
            r#""multiplicity":1"#,
            r#""multiplicity":2"#,
            "statement.roots[0].multiplicity",
        ),
        ("-0.5", "-0.5000000000000001", "statement.roots[0].nearest"),
        (
            r#""1.3""#,
            r#""1.3000000000000003""#,
            "statement.roots[1].position[0]",
        ),
        (r#""0.4""#, r#""inf""#, "statement.roots[1].position[1]"),
        (r#"["0"]"#, "[]", ""),
        (r#"["0"]"#, r#"["1/2"]"#, ""),
        (r#"["0"]"#, r#"["0","0"]"#, "witness.breakpoints"),
        (r#"["0"]"#, r#"["0/1"]"#, "witness.breakpoints[0]"),
        (r#""form":0"#, r#""form":1"#, "statement.form"),
        (r#","center""#, r#","middle""#, "statement"),
    ];
    assert_each_matters(&text, &changes);
}

#[test]
fn multiple_roots_need_their_parts() {
    let text = document(
        &[MULTIPLE],
        "root-count",
        r#"{"form":0,"direction":["1","0"],"order_at_zero":2,"roots":[{"multiplicity":1},{"multiplicity":2,"nearest":"1"}]}"#,
        r#"{"breakpoints":["0"],"parts":[{"multiplicity":2,"coefficients":["-2","2"]},{"multiplicity":1,"coefficients":["2","1"]}]}"#,
    );
    let changes = [
        (
            r#"{"multiplicity":1}"#,
            r#"{"multiplicity":2}"#,
            "statement.roots[0].multiplicity",
        ),
        (r#"["-2","2"]"#, r#"["-2","3"]"#, ""),
        (r#"["-2","2"]"#, r#"["-2","0"]"#, "witness.parts[0]"),
        (
            r#""parts":[{"multiplicity":2"#,
            r#""parts":[{"multiplicity":1"#,
            "",
        ),
        (
            r#""parts":[{"multiplicity":2"#,
            r#""parts":[{"multiplicity":0"#,
            "witness.parts[0]",
        ),
    ];
    assert_each_matters(&text, &changes);
}

#[test]
fn a_line_on_which_the_polynomial_vanishes_has_no_roots() {
    let text = document(
        &[LINES],
        "root-count",
        r#"{"form":0,"direction":["1","0"],"order_at_zero":2,"roots":[]}"#,
        r#"{"breakpoints":[]}"#,
    );
    assert_accepted(&text);
    assert_refused(&text.replace(":2,", r#":"line","#), "");
    let product = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[1,1],"coefficient":"1"}]}"#;
    let line = text
        .replace(LINES, product)
        .replace(r#""order_at_zero":2"#, r#""order_at_zero":"line""#);
    let changes = [
        (r#""line""#, "0", ""),
        ("[]}}", r#"["0"]}}"#, ""),
        (
            r#""breakpoints":[]"#,
            r#""breakpoints":[],"parts":[{"multiplicity":1,"coefficients":["0","1"]}]"#,
            "",
        ),
    ];
    assert_each_matters(&line, &changes);
}

/// x = value on the x axis, with this double.
fn nearest(value: &str, double: &str) -> String {
    let (above, below) = value.split_once('/').unwrap_or((value, "1"));
    let form = format!(
        r#"{{"kind":"implicit","variables":["x","y"],"terms":[{{"exponents":[1,0],"coefficient":"{below}"}},{{"exponents":[0,0],"coefficient":"-{above}"}}]}}"#
    );
    let statement = format!(
        r#"{{"form":0,"direction":["1","0"],"order_at_zero":0,"roots":[{{"multiplicity":1,"nearest":"{double}"}}]}}"#
    );
    document(
        &[&form],
        "root-count",
        &statement,
        r#"{"breakpoints":["0"]}"#,
    )
}

#[test]
fn doubles_are_nearest_up_to_ties_at_both_ends_of_their_range() {
    use num_bigint::BigInt;
    let power = |exponent: u32| BigInt::from(2).pow(exponent);
    let tie = format!("{}/{}", power(53) + 1, power(53));
    let smallest_tie = format!("1/{}", power(1075));
    let largest_tie = (power(1024) - power(970)).to_string();
    let huge = format!("1{}", "0".repeat(400));
    let accepted = [
        (&tie, "1"),
        (&tie, "1.0000000000000002"),
        (&smallest_tie, "0.0"),
        (&smallest_tie, "-0"),
        (&smallest_tie, "5e-324"),
        (&largest_tie, "1.7976931348623157e308"),
        (&largest_tie, "inf"),
        (&huge, "inf"),
    ];
    for (value, double) in accepted {
        assert_accepted(&nearest(value, double));
    }
    let refused = [
        (&tie, "1.0000000000000004"),
        (&tie, "0.9999999999999999"),
        (&smallest_tie, "-5e-324"),
        (&smallest_tie, "1e-323"),
        (&largest_tie, "-inf"),
        (&huge, "1.7976931348623157e308"),
        (&huge, "1e400"),
        (&huge, "Inf"),
        (&huge, "nan"),
        (&huge, "infinity"),
        (&huge, "+inf"),
        (&huge, "1E3"),
        (&huge, "1."),
    ];
    for (value, double) in refused {
        assert_refused(&nearest(value, double), "statement.roots[0].nearest");
    }
}
