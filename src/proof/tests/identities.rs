//! Claims that are checked by expanding polynomials.

use super::{
    ANGLE, CIRCLE, DIFFERENCE, LINES, MOVED_CIRCLE, ROUND, SPHERE, SUM, assert_accepted,
    assert_each_matters, document, report,
};

#[test]
fn the_equation_of_a_radius_is_recognized() {
    let text = document(
        &[MOVED_CIRCLE, ROUND],
        "series-equation",
        r#"{"form":0,"radius":1,"coordinates":"original"}"#,
        r#"{"method":"expansion"}"#,
    );
    let changes = [
        (r#""3/4""#, r#""4/5""#, ""),
        ("original", "center", ""),
        ("original", "polar", "statement.coordinates"),
        (r#""radius":1"#, r#""radius":0"#, "statement.radius"),
        (r#""expansion""#, r#""faith""#, "witness.method"),
        (r#"["1/2"]"#, r#"["1/3"]"#, ""),
    ];
    assert_each_matters(&text, &changes);
}

#[test]
fn an_equation_vanishes_on_its_curve() {
    let text = document(
        &[CIRCLE, ANGLE, SPHERE],
        "identity",
        r#"{"equations":[0],"curve":1}"#,
        r#"{"method":"expansion"}"#,
    );
    let changes = [
        (r#""-1/4""#, r#""-1/5""#, "statement.equations[0]"),
        (
            r#""equations":[0]"#,
            r#""equations":[0,2]"#,
            "statement.equations[1]",
        ),
        (
            r#""equations":[0]"#,
            r#""equations":[]"#,
            "statement.equations",
        ),
        (r#""curve":1"#, r#""curve":0"#, "statement.curve"),
    ];
    assert_each_matters(&text, &changes);
}

#[test]
fn a_factorization_has_its_constant_and_its_multiplicities() {
    let text = document(
        &[LINES, SUM, DIFFERENCE],
        "factorization",
        r#"{"form":0,"constant":"2/3","factors":[{"form":1,"multiplicity":1},{"form":2,"multiplicity":1}]}"#,
        r#"{"method":"expansion"}"#,
    );
    let changes = [
        ("2/3", "1/3", ""),
        (r#""multiplicity":1"#, r#""multiplicity":2"#, ""),
        (
            r#""multiplicity":1"#,
            r#""multiplicity":0"#,
            "statement.factors[0]",
        ),
        (r#""form":2"#, r#""form":1"#, "statement.factors[1]"),
    ];
    assert_each_matters(&text, &changes);
}

#[test]
fn an_irreducible_polynomial_has_a_line_or_a_radius() {
    let line = document(
        &[CIRCLE],
        "irreducible",
        r#"{"form":0}"#,
        r#"{"point":["0","1"],"direction":["1","0"],"prime":5}"#,
    );
    // x² + 3/4 is 4x² + 3, which has no root modulo 5.
    let changes = [
        (r#""prime":5"#, r#""prime":4"#, "witness.prime"),
        (r#""prime":5"#, r#""prime":2"#, ""),
        (r#""prime":5"#, r#""prime":7"#, ""),
        (r#"["1","0"],"prime""#, r#"["0","0"],"prime""#, ""),
        (r#""-1/4""#, r#""-1""#, ""),
    ];
    assert_each_matters(&line, &changes);
    let radius = document(
        &[MOVED_CIRCLE, ROUND],
        "irreducible",
        r#"{"form":0}"#,
        r#"{"radius":1,"coordinates":"original"}"#,
    );
    assert_each_matters(&radius, &[(r#""3/4""#, r#""1""#, "")]);
}

#[test]
fn the_square_of_an_odd_radius_is_not_irreducible() {
    // r = cos θ has no even part: its equation is (x² + y² − x)².
    let square = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[4,0],"coefficient":"1"},
        {"exponents":[2,2],"coefficient":"2"},{"exponents":[0,4],"coefficient":"1"},{"exponents":[3,0],"coefficient":"-2"},
        {"exponents":[1,2],"coefficient":"-2"},{"exponents":[2,0],"coefficient":"1"}]}"#;
    let odd = r#"{"kind":"fourier","cos":["0","1"],"sin":["0","0"]}"#;
    let witness = r#"{"radius":1,"coordinates":"center"}"#;
    let text = document(&[square, odd], "irreducible", r#"{"form":0}"#, witness);
    let refused = report(&text).refused.remove(0).refusal;
    assert_eq!(refused.reason(), "the even part of the radius is zero");
    let equation = r#"{"form":0,"radius":1,"coordinates":"center"}"#;
    assert_accepted(&document(
        &[square, odd],
        "series-equation",
        equation,
        r#"{"method":"expansion"}"#,
    ));
}

#[test]
fn the_polynomial_of_the_theorem_may_be_a_square() {
    // r = cos θ: T = (ρ − x)².
    let radius = r#"{"kind":"fourier","cos":["0","1"],"sin":["0","0"]}"#;
    let circle = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[2,0],"coefficient":"1"},
        {"exponents":[0,2],"coefficient":"1"},{"exponents":[1,0],"coefficient":"-1"}]}"#;
    let text = document(
        &[circle, radius],
        "series-equation",
        r#"{"form":0,"radius":1,"coordinates":"center","square":true}"#,
        r#"{"method":"expansion"}"#,
    );
    let changes = [
        (r#","square":true"#, "", ""),
        (r#""square":true"#, r#""square":1"#, "statement.square"),
        (r#""square":true"#, r#""square":false"#, "statement.square"),
        (r#""-1""#, r#""-2""#, ""),
    ];
    assert_each_matters(&text, &changes);
}
