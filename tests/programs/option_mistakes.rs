//! Mistakes in options and arguments: each is answered by one message that says what would be right.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use tempfile::TempDir;

use super::bad_input::{circle, refused_in};

/// What is typed behind `stellate`, and a part of the one message.
type Mistake = (&'static str, &'static str);

/// Every mistake is refused, with nothing printed and no file left.
fn assert_refused(mistakes: &[Mistake]) {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("c.csv"), circle().join("\n")).unwrap();
    for (typed, expected) in mistakes {
        let words = shell_words::split(typed).unwrap();
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let said = refused_in(folder.path(), &words, b"", 2);
        assert!(
            said.starts_with("stellate: ") || said.starts_with("{\"error\""),
            "{said}"
        );
        assert!(said.contains(expected), "{typed}\n{said}");
        for jargon in ["invalid", "literal", "digit found", "..=", "-- -"] {
            assert!(!said.contains(jargon), "{typed}\n{said}");
        }
    }
}

#[test]
fn a_long_name_needs_two_plain_dashes() {
    assert_refused(&[
        (
            "plot '-x^4+y^2=0' -o q.svg",
            "there is no option -x; a form that begins with a minus sign stands behind --, after all options",
        ),
        (
            "plot '-3*x^4+y^2=0' -o q.svg",
            "a form that begins with a minus sign stands behind --",
        ),
        (
            "fit c.csv -harmonics 3",
            "-harmonics: a long name has two plain dashes before it: --harmonics",
        ),
        (
            "fit c.csv -harm 3",
            "-harm: a long name has two plain dashes before it: --harmonics",
        ),
        ("fit c.csv -harmonics=3", "--harmonics"),
        (
            "fit c.csv —harmonics 3",
            "—harmonics: a long name has two plain dashes before it: --harmonics",
        ),
        ("fit c.csv –harmonics=3", "--harmonics"),
        (
            "implicitize 'x = 1' -format json",
            "-format: a long name has two plain dashes",
        ),
        (
            "implicitize -format json 'x = 1'",
            "-format: a long name has two plain dashes",
        ),
        ("describe x -help", "--help"),
        (
            "fit c.csv --harmonics = 3",
            "--harmonics =: without blanks around it, as in --harmonics=VALUE",
        ),
    ]);
}

#[test]
fn an_option_that_a_verb_does_not_have_is_found_where_it_belongs() {
    assert_refused(&[
        (
            "describe x --directions 5",
            "--directions belongs to sample and vectors, not to describe",
        ),
        (
            "implicitize x --theta 3",
            "--theta belongs to parametrize and sample, not to implicitize",
        ),
        (
            "fit c.csv -n 2 --window 0,1,0,1",
            "--window belongs to parametrize, sample, inspect, mesh and plot, not to fit",
        ),
        (
            "sample x --point 1,2",
            "--point belongs to inspect and plot, not to sample",
        ),
        (
            "plot x -o p.svg --resolution 30",
            "--resolution belongs to parametrize, sample and mesh, not to plot",
        ),
        (
            "--theta 3 sample x",
            "--theta belongs to sample and stands behind it: stellate sample --theta",
        ),
        (
            "fit c.csv --n 3",
            "there is no option --n; write --harmonics N or -n N",
        ),
        ("fit c.csv -N 3", "write --harmonics N or -n N"),
        ("fit c.csv --order 3", "write --harmonics N or -n N"),
        ("fit c.csv N=3", "N=3: an option has dashes before it: -n 3"),
        (
            "fit c.csv harmonics=3",
            "an option has dashes before it: --harmonics 3",
        ),
        (
            "fit c.csv --Harmonics 3",
            "there is no option --Harmonics; write --harmonics",
        ),
        ("fit c.csv --harm 3", "write --harmonics"),
        (
            "implicitize x --max_degree 3",
            "there is no option --max_degree; write --max-degree",
        ),
        (
            "implicitize x --json",
            "there is no option --json; write --format json",
        ),
        (
            "implicitize x -f json",
            "there is no option -f; write --format",
        ),
        ("implicitize x -q", "there is no option -q; write --quiet"),
        (
            "implicitize x --zebra",
            "there is no option --zebra; there are --model, --harmonics, ",
        ),
        ("--hlep", "there is no option --hlep; did you mean --help?"),
        // A form may begin with a sign, so the parser takes the first word for one.
        (
            "sample --directons 3 r=2",
            "there is no option --directons; did you mean --directions?",
        ),
        (
            "sample --zebra=1 3 r=2",
            "there is no option --zebra=1; there are --window, ",
        ),
        (
            "paper 3 --zebra",
            "there is no option --zebra; there are --only, ",
        ),
    ]);
}

#[test]
fn numbers_are_asked_for_in_plain_words() {
    assert_refused(&[
        (
            "fit c.csv --tolerance 0,1",
            "--tolerance 0,1: decimals are written with a point: 0.1",
        ),
        (
            "fit c.csv --tolerance 1%",
            "--tolerance 1%: a percentage is written as a number: 1/100",
        ),
        (
            "fit c.csv --tolerance 0.1mm",
            "--tolerance 0.1mm: a number stands here without a unit: 0.1",
        ),
        (
            "fit c.csv --tolerance ten",
            "--tolerance ten: expected a number greater than 0, such as 0.1, 1e-3 or 1/10",
        ),
        (
            "fit c.csv --tolerance -1",
            "--tolerance -1: expected a number greater than 0, such as 0.1, 1e-3 or 1/10",
        ),
        (
            "fit c.csv --tolerance",
            "--tolerance <E>: the value is missing",
        ),
        (
            "inspect x --point 1,0 --tolerance 0,1",
            "--tolerance 0,1: decimals are written with a point",
        ),
        (
            "inspect x --point 1,0 --tolerance -1",
            "--tolerance -1: expected a number greater than 0, such as 0.1, 1e-3 or 1/10",
        ),
        (
            "inspect x --point 1,0 --tolerance 1 --reach near",
            "--reach near: expected a number greater than 0, such as 0.1, 1e-3 or 1/10",
        ),
        (
            "fit c.csv -n -1",
            "--harmonics -1: expected a whole number from 0 on, such as 39",
        ),
        (
            "fit c.csv --harmonics=-1",
            "--harmonics -1: expected a whole number from 0 on, such as 39",
        ),
        (
            "fit c.csv -n many",
            "--harmonics many: expected a whole number, such as 39",
        ),
        (
            "fit c.csv -n 2.5",
            "--harmonics 2.5: expected a whole number, such as 39",
        ),
        (
            "fit c.csv -n 99999999999999999999999",
            "expected a whole number, and not such a large one, such as 39",
        ),
        (
            "fit c.csv -n 5 --decimals -1",
            "--decimals -1: expected a whole number from 0 on, such as 6",
        ),
        (
            "sample x --directions -4",
            "--directions -4: expected a whole number from 0 on, such as 360",
        ),
        (
            "vectors x --directions ten",
            "--directions ten: expected a whole number, such as 16",
        ),
        (
            "parametrize x --digits -3",
            "--digits -3: expected a whole number from 0 to 10000, such as 16",
        ),
        (
            "parametrize x --digits ten",
            "--digits ten: expected a whole number from 0 to 10000, such as 16",
        ),
        (
            "parametrize x --branch=-1",
            "--branch -1: expected a whole number from 0 on, such as 1",
        ),
        (
            "implicitize x --max-degree=-2",
            "--max-degree -2: expected a whole number from 0 on, such as 100",
        ),
        (
            "implicitize x --threads two",
            "--threads two: expected a whole number, such as 4",
        ),
        (
            "plot x -o p.svg --cells 0",
            "--cells 0: expected a whole number from 8 to 4000, such as 240",
        ),
        (
            "mesh z -o m.ply --resolution high",
            "--resolution high: expected a whole number from 2 to 1024, such as 64",
        ),
        (
            "implicitize x --time-limit -1",
            "--time-limit -1: expected a number of seconds, such as 60",
        ),
        (
            "implicitize x --time-limit 5parsec",
            "or with a unit, such as 5min",
        ),
    ]);
}

#[test]
fn angles_points_and_boxes_are_asked_for_in_plain_words() {
    assert_refused(&[
        (
            "sample x --theta pi/6,pi/3",
            "for several the option is repeated",
        ),
        (
            "sample x --theta '30,5°'",
            "--theta 30,5°: expected one angle, such as 0.5, pi/6 or 30deg",
        ),
        (
            "sample x --theta north",
            "--theta north: expected radians up to 1e9 such as 0.5 or pi/6",
        ),
        (
            "mesh z -o m.ply --angle steep",
            "--angle steep: expected degrees such as 20",
        ),
        (
            "plot 'x=t;y=t^2' -o p.svg --range 0..1",
            "--range 0..1: expected NAME=A,B with A < B",
        ),
        (
            "plot 'x=t;y=t^2' -o p.svg --range s=0,1",
            "--range s=0,1: no form here has the parameter s; there is t",
        ),
        (
            "plot 'x=cos(t);y=sin(t)' 'x = 1' -o p.svg --range theta=0,1",
            "there is t",
        ),
        (
            "plot 'x=u;y=v;z=u*v' -o p.svg --range t=0,1",
            "there is u and v",
        ),
        (
            "plot 'x = 1' -o p.svg --range t=0,1",
            "no form here has a parameter; equations and radii are drawn whole",
        ),
        (
            "plot z -o p.svg --view 30",
            "--view 30: expected AZIMUTH,ELEVATION in degrees",
        ),
        (
            "plot z -o p.svg --point a,b,c",
            "--point a,b,c: \"a\" is not a number; expected X,Y,Z",
        ),
        (
            "plot x -o p.svg --window=-inf,1,0,1",
            "\"-inf\" is not a number; expected X0,X1,Y0,Y1",
        ),
        (
            "fit c.csv -n 2 --center middle",
            "--center middle: \"middle\" is not a number; expected auto, centroid, kernel, best or X,Y",
        ),
        (
            "fit c.csv -n 2 --center 1,2,3",
            "--center: the center of an outline in the plane is X,Y",
        ),
        (
            "fit c.csv -n 2 --center '0,1;0,2'",
            "--center 0,1;0,2: 0,1: decimals are written with a point: 0.1",
        ),
        (
            "fit c.csv -n 2 --center 0 0",
            "--center takes its numbers in one argument: --center 0,0",
        ),
        (
            "inspect x --tolerance 1 --point 1 0",
            "--point takes its numbers in one argument: --point 1,0",
        ),
        (
            "inspect x --tolerance 1 --point '(1'",
            "--point (1: \"(1\" is not a number; expected X,Y,Z",
        ),
        (
            "inspect x --tolerance 1 --point pi,0",
            "--point pi,0: pi: expected a decimal or a fraction; pi and roots are neither",
        ),
        (
            "inspect x --tolerance 1 --point 'sqrt(2),0'",
            "sqrt(2): expected a decimal or a fraction",
        ),
        (
            "inspect x --tolerance 1 --point x=2,y=0",
            "\"x=2\" is not a number; expected X,Y,Z",
        ),
        (
            "inspect x --tolerance 1 --point 1,0 --point 1,1e400",
            "1e400 is too large",
        ),
    ]);
}

#[test]
fn formats_are_named_or_chosen_by_the_name_of_the_output() {
    assert_refused(&[
        (
            "implicitize x --format xml",
            "--format xml: expected one of text, json, csv, latex, sympy, maple, singular",
        ),
        (
            "implicitize x --method groebner",
            "--method groebner: expected one of polar, resultant",
        ),
        (
            "implicitize x --color red",
            "--color red: expected one of auto, always, never",
        ),
        (
            "mesh z --format obj",
            "mesh has no --format: the name after -o says .obj, .ply or .stl",
        ),
        (
            "plot x --format png",
            "plot has no --format: the name after -o says .svg or .png",
        ),
        (
            "sample x -o out.tex",
            "-o out.tex means --format latex: points are written as csv or json",
        ),
        (
            "describe x -o out.CSV",
            "-o out.CSV means --format csv: a description is written as text or json",
        ),
        (
            "vectors 'r = 2' -o out.csv",
            "-o out.csv means --format csv: test vectors are written as json",
        ),
        (
            "parametrize 'x^2 + 2y^2 = 1' -o out.csv",
            "-o out.csv means --format csv: a radius that is no Fourier series",
        ),
        (
            "inspect x --tolerance 1 --point 1,0 -o v.tex",
            "-o v.tex means --format latex: verdicts are written as csv, json or text",
        ),
        (
            "sample x --format latex -o out.csv",
            "stellate: --format latex: points are written as csv or json",
        ),
        (
            "sample x --theta north --format json",
            "{\"error\":{\"exit_code\":2,\"message\":\"--theta north: ",
        ),
    ]);
}

#[test]
fn forms_and_verbs_in_the_wrong_place_are_recognised() {
    assert_refused(&[
        (
            "describe x^2 + y^2 = 1",
            "a form that has blanks stands in quotes: stellate describe \"x^2 + y^2 = 1\"",
        ),
        (
            "implicitize r = 1 + 'cos(t)'",
            "stellate implicitize \"r = 1 + cos(t)\"",
        ),
        (
            "describe --format text x^2 + y^2 = 1",
            "stellate describe \"x^2 + y^2 = 1\"",
        ),
        (
            "describe x^2 - y = 1 --digits 3",
            "stellate describe \"x^2 - y = 1\"",
        ),
        (
            "plot x^2 + y^2 = 1 -o p.svg",
            "stellate plot \"x^2 + y^2 = 1\"",
        ),
        (
            "implicitize 'x = 1' 'y = 1'",
            "y = 1: implicitize takes one form, and this is another argument; plot takes several",
        ),
        (
            "describe c.csv d.csv",
            "d.csv: describe takes one form, and this is another argument",
        ),
        ("paper T1", "T1: paper takes options only"),
        (
            "'x^2/4+y^2=1'",
            "a verb stands before the form, as in stellate describe \"x^2/4+y^2=1\"",
        ),
        (
            "'x^2/4+y^2=1' describe",
            "those that take one are describe, implicitize, parametrize, fit, sample, inspect, mesh, plot, check, vectors",
        ),
        ("c.csv", "a verb stands before the form"),
        (
            "draw x",
            "there is no verb draw; the verbs are describe, implicitize, ",
        ),
        (
            "parametrise x",
            "there is no verb parametrise; did you mean parametrize?",
        ),
        (
            "help sampel",
            "there is no verb sampel; the verbs are describe, ",
        ),
        ("paper --only T99", "--only T99: no statement has this id"),
    ]);
}
