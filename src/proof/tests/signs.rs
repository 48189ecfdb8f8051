//! Claims about the signs of polynomials and radii: distances, sides, sectors, errors.

use super::{
    BALL, CIRCLE, EGG, EGG_AROUND, ROUND, assert_accepted, assert_each_matters, assert_refused,
    distance, document,
};

#[test]
fn a_positive_radius_is_positive_everywhere() {
    let statement = r#"{"form":0,"positive":true}"#;
    let plane = document(
        &[EGG],
        "positive-radius",
        statement,
        r#"{"quarters":[[],["1/2"],[],[]]}"#,
    );
    let changes = [
        (r#""3""#, r#""1""#, "witness.quarters[1]"),
        (r#""3""#, r#""-3""#, ""),
        (r#""1/2""#, r#""1""#, "witness.quarters[1]"),
        (",[],[]]", ",[]]", "witness.quarters"),
        ("true", "1", "statement.positive"),
    ];
    assert_each_matters(&plane, &changes);
    let space = document(&[BALL], "positive-radius", statement, r#"{"depth":2}"#);
    assert_each_matters(
        &space,
        &[
            (r#""3""#, r#""1""#, ""),
            (r#""depth":2"#, r#""depth":201"#, "witness.depth"),
        ],
    );
    let negative = document(
        &[r#"{"kind":"fourier","cos":["1","1"],"sin":["0","0"]}"#],
        "positive-radius",
        r#"{"form":0,"positive":false}"#,
        r#"{"direction":["-1","0"]}"#,
    );
    assert_each_matters(
        &negative,
        &[
            (r#""-1""#, r#""1""#, ""),
            (r#""-1""#, r#""-2""#, "witness.direction"),
        ],
    );
}

#[test]
fn the_distance_from_an_implicit_curve_is_enclosed() {
    let near = distance("at-most", "1/2", r#"{"segment":[["1","0"],["1/2","0"]]}"#);
    assert_each_matters(
        &near,
        &[
            (
                r#""bound":"1/2""#,
                r#""bound":"499/1000""#,
                "witness.segment[1]",
            ),
            (r#""1/2","0""#, r#""3/4","0""#, ""),
        ],
    );
    let meets = distance("meets", "1", r#"{"segment":[["0","0"],["2","0"]]}"#);
    assert_each_matters(
        &meets,
        &[(r#"["0","0"]"#, r#"["1/2","0"]"#, "witness.segment[0]")],
    );
    let far = distance("more-than", "9/20", r#"{"depth":6}"#);
    assert_each_matters(
        &far,
        &[
            ("9/20", "1/2", ""),
            ("9/20", "-9/20", ""),
            (r#""depth":6"#, r#""depth":201"#, "witness.depth"),
        ],
    );
    let misses = distance("misses", "2", r#"{"depth":6}"#);
    assert_each_matters(&misses, &[(r#""bound":"2""#, r#""bound":"1""#, "")]);
    assert_accepted(&distance("misses", "0", r#"{"depth":0}"#));
    assert_refused(
        &distance("inside", "1", r#"{"depth":0}"#),
        "statement.relation",
    );
}

#[test]
fn the_distance_from_a_radius_is_enclosed() {
    let about = |relation: &str, bound: &str, witness: &str| {
        let statement =
            format!(r#"{{"form":0,"point":["0","0"],"relation":"{relation}","bound":"{bound}"}}"#);
        document(&[ROUND], "distance", &statement, witness)
    };
    let near = about("at-most", "1/2", r#"{"directions":[["-1","0"]]}"#);
    assert_each_matters(
        &near,
        &[
            (r#""-1""#, r#""1""#, ""),
            (r#""bound":"1/2""#, r#""bound":"1/3""#, ""),
        ],
    );
    let meets = about("meets", "1", r#"{"directions":[["-1","0"],["1","0"]]}"#);
    assert_each_matters(&meets, &[(r#"["-1","0"]"#, r#"["1","0"]"#, "")]);
    let far = about("more-than", "9/20", r#"{"depth":9}"#);
    assert_each_matters(
        &far,
        &[
            ("9/20", "1/2", ""),
            (r#""depth":9"#, r#""depth":201"#, "witness.depth"),
        ],
    );
    let misses = about("misses", "8/5", r#"{"depth":9}"#);
    assert_each_matters(&misses, &[("misses", "more-than", ""), ("8/5", "1", "")]);
}

/// A distance just below the true one, 1/2.
const NEARLY: &str = "499999999999999999/1000000000000000000";

#[test]
fn multipliers_tell_distances_apart_that_are_nearly_equal() {
    let witness = r#"{"depth":3,"multipliers":["1000000001/1000000000"]}"#;
    // The nearest point, (3/10, 2/5), is inside the cube.
    let about = |relation: &str| {
        let text = distance(relation, NEARLY, witness);
        text.replace(r#"["1","0"]"#, r#"["3/5","4/5"]"#)
    };
    let far = about("more-than");
    let changes = [
        (NEARLY, "1/2", ""),
        (r#""1000000001"#, r#""-1000000001"#, ""),
        (r#","multipliers":["1000000001/1000000000"]"#, "", ""),
        (r#"["1000000001/1000000000"]"#, "[]", "witness.multipliers"),
    ];
    assert_each_matters(&far, &changes);
    let inside = about("misses");
    assert_each_matters(&inside, &[(NEARLY, "1/2", ""), (NEARLY, "1", "")]);
}

#[test]
fn a_place_tells_distances_from_a_radius_apart_that_are_nearly_equal() {
    let statement =
        format!(r#"{{"form":0,"point":["0","0"],"relation":"more-than","bound":"{NEARLY}"}}"#);
    let witness = r#"{"depth":6,"near":["2333333334/1000000000"]}"#;
    let text = document(&[EGG_AROUND], "distance", &statement, witness);
    let changes = [
        (NEARLY, "1/2", ""),
        (r#""2333333334"#, r#""1333333334"#, ""),
        (r#","near":["2333333334/1000000000"]"#, "", ""),
        (r#"["2333333334/1000000000"]"#, r#""2""#, "witness.near"),
    ];
    assert_each_matters(&text, &changes);
}

#[test]
fn a_sphere_has_points_within_a_distance() {
    // R(0, 0, 1) = 3 and R(0, −1, 0) = 2.
    let statement = |relation: &str, bound: &str| {
        format!(r#"{{"form":0,"point":["0","0","0"],"relation":"{relation}","bound":"{bound}"}}"#)
    };
    let near = document(
        &[BALL],
        "distance",
        &statement("at-most", "2"),
        r#"{"directions":[["0","-1","0"]]}"#,
    );
    assert_each_matters(
        &near,
        &[
            (r#""-1""#, r#""1""#, ""),
            (
                r#"["0","-1","0"]"#,
                r#"["0","-1"]"#,
                "witness.directions[0]",
            ),
            (r#""bound":"2""#, r#""bound":"19/10""#, ""),
        ],
    );
    let meets = document(
        &[BALL],
        "distance",
        &statement("meets", "5/2"),
        r#"{"directions":[["0","-1","0"],["0","0","1"]]}"#,
    );
    assert_each_matters(&meets, &[(r#","0","1"]"#, r#","-1","0"]"#, "")]);
    let far = document(
        &[BALL],
        "distance",
        &statement("more-than", "1"),
        r#"{"depth":9}"#,
    );
    assert_refused(&far, "");
}

#[test]
fn a_point_is_on_its_side() {
    let statement = r#"{"form":0,"point":["1","1/2"],"sign":1}"#;
    let witness = r#"{"method":"expansion"}"#;
    for form in [CIRCLE, BALL, ROUND] {
        let dimension_three = statement.replace(r#""1/2""#, r#""1/2","7/2""#);
        let statement = if form == BALL {
            &dimension_three
        } else {
            statement
        };
        let sign = if form == ROUND {
            r#""sign":0"#
        } else {
            r#""sign":1"#
        };
        let text = document(
            &[form],
            "side",
            &statement.replace(r#""sign":1"#, sign),
            witness,
        );
        assert_each_matters(&text, &[(sign, r#""sign":-1"#, "statement.sign")]);
    }
    let center = document(
        &[ROUND],
        "side",
        r#"{"form":0,"point":["1","0"],"sign":-1}"#,
        witness,
    );
    assert_accepted(&center);
}

#[test]
fn sectors_have_constant_numbers_of_roots() {
    // The parabola y = x² − 1: two roots in every direction but that of the y axis, which has s = 3.
    let parabola = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[2,0],"coefficient":"1"},
        {"exponents":[0,1],"coefficient":"-1"},{"exponents":[0,0],"coefficient":"-1"}]}"#;
    let text = document(
        &[parabola],
        "sectors",
        r#"{"form":0,"cuts":[{"between":["29/10","31/10"],"angle":["-1/10","1/10"]}],
            "counts":[{"negative":1,"positive":1},{"negative":1,"positive":1}]}"#,
        r#"{"sectors":[[{"to":"2","breakpoints":["0"]},{"to":"29/10","breakpoints":["0"]}],[{"to":"4","breakpoints":["0"]}]]}"#,
    );
    let changes = [
        (
            r#""negative":1"#,
            r#""negative":2"#,
            "witness.sectors[0][0]",
        ),
        (r#""1/10"]"#, r#""99/1000"]"#, "statement.cuts[0].angle"),
        (r#""-1/10""#, r#""-99/1000""#, "statement.cuts[0].angle"),
        (
            r#""29/10","31/10""#,
            r#""29/10","3""#,
            "witness.sectors[1][0]",
        ),
        (
            r#"{"to":"2","breakpoints":["0"]},"#,
            "",
            "witness.sectors[0][0]",
        ),
        (r#""to":"2""#, r#""to":"3""#, "witness.sectors[0][0]"),
        (r#"["0"]"#, r#"["1"]"#, "witness.sectors[0][0].breakpoints"),
        (
            r#"[{"to":"4","breakpoints":["0"]}]"#,
            "null",
            "witness.sectors[1]",
        ),
        (r#",{"negative":1,"positive":1}]"#, "]", "statement.counts"),
    ];
    assert_accepted(&text);
    for (old, new, place) in changes {
        let changed = text.replacen(old, new, 1);
        assert_refused(&changed, place);
    }
}

#[test]
fn a_fit_has_its_errors() {
    // The distances of the samples from the circle are 1/2 and 1/2·√2 − 1/2, that is about 0.2071.
    let text = document(
        &[ROUND],
        "fit-error",
        r#"{"form":0,"samples":[["2","0"],["3/2","1/2"]],"max":["1/2","501/1000"],"rms":["38268/100000","38269/100000"]}"#,
        r#"{"bits":40}"#,
    );
    let changes = [
        (
            r#""max":["1/2","501/1000"]"#,
            r#""max":["1/2","499/1000"]"#,
            "statement.max",
        ),
        (
            r#""max":["1/2","501/1000"]"#,
            r#""max":["51/100","1"]"#,
            "statement.max",
        ),
        ("38269", "38268", "statement.rms"),
        (r#"["2","0"]"#, r#"["1","0"]"#, "statement.samples[0]"),
        (r#""bits":40"#, r#""bits":4"#, "statement.max"),
    ];
    assert_each_matters(&text, &changes);
}
