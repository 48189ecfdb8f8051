//! Whole documents: a proof of every kind is accepted, and refused with the right place when one thing in it is wrong.

mod documents;
mod identities;
mod roots;
mod signs;

use super::{Report, check};

const CIRCLE: &str = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[2,0],"coefficient":"1"},
    {"exponents":[0,2],"coefficient":"1"},{"exponents":[0,0],"coefficient":"-1/4"}]}"#;
const SPHERE: &str = r#"{"kind":"implicit","variables":["x","y","z"],"terms":[{"exponents":[2,0,0],"coefficient":"4"},
    {"exponents":[0,2,0],"coefficient":"4"},{"exponents":[0,0,2],"coefficient":"4"},{"exponents":[0,0,0],"coefficient":"-1"}]}"#;
const ROUND: &str = r#"{"kind":"fourier","cos":["1/2"],"sin":["0"],"center":["1","0"]}"#;
/// The circle of [`ROUND`] about its own center.
const MOVED_CIRCLE: &str = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[2,0],"coefficient":"1"},
    {"exponents":[0,2],"coefficient":"1"},{"exponents":[1,0],"coefficient":"-2"},{"exponents":[0,0],"coefficient":"3/4"}]}"#;
const EGG: &str = r#"{"kind":"fourier","cos":["3","1"],"sin":["0","0"]}"#;
/// r = 2 + 6/5 cos θ + 9/10 sin θ: the point nearest to the origin is (−2/5, −3/10), where tan ((θ − π)/2) is 1/3.
const EGG_AROUND: &str = r#"{"kind":"fourier","cos":["2","6/5"],"sin":["0","9/10"]}"#;
const BALL: &str = r#"{"kind":"spherical","degree":1,"coefficients":[{"l":0,"m":0,"value":"3"},{"l":1,"m":-1,"value":"1"}]}"#;
const ANGLE: &str = r#"{"kind":"parametric","parameters":["angle"],"coordinates":[
    {"numerator":[{"exponents":[1,0],"coefficient":"1/2"}],"denominator":[{"exponents":[0,0],"coefficient":"1"}]},
    {"numerator":[{"exponents":[0,1],"coefficient":"1/2"}],"denominator":[{"exponents":[0,0],"coefficient":"1"}]}]}"#;
/// x²(x − 1)²(x + 2) on the x axis.
const MULTIPLE: &str = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[5,0],"coefficient":"1"},
    {"exponents":[3,0],"coefficient":"-3"},{"exponents":[2,0],"coefficient":"2"},{"exponents":[0,1],"coefficient":"7"}]}"#;
const LINES: &str = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[2,0],"coefficient":"1/3"},
    {"exponents":[0,2],"coefficient":"-1/3"}]}"#;
const SUM: &str = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[1,0],"coefficient":"1"},
    {"exponents":[0,1],"coefficient":"1"}]}"#;
const DIFFERENCE: &str = r#"{"kind":"implicit","variables":["x","y"],"terms":[{"exponents":[1,0],"coefficient":"1/2"},
    {"exponents":[0,1],"coefficient":"-1/2"}]}"#;

/// A proof with these forms and one claim.
fn document(forms: &[&str], name: &str, statement: &str, witness: &str) -> String {
    let forms = forms.join(",");
    format!(
        r#"{{"schema":"stellate/1","kind":"proof","forms":[{forms}],"claims":[{{"claim":"{name}","statement":{statement},"witness":{witness}}}]}}"#
    )
}

fn report(text: &str) -> Report {
    check(text, false).unwrap_or_else(|refusal| panic!("{refusal} in {text}"))
}

fn assert_accepted(text: &str) {
    let report = report(text);
    assert!(report.holds(), "{report}\n{text}");
}

/// Asserts that the first claim is refused at this place.
fn assert_refused(text: &str, place: &str) {
    let report = report(text);
    let refused = report
        .refused
        .first()
        .unwrap_or_else(|| panic!("accepted: {text}"));
    assert_eq!(refused.refusal.place(), place, "{}", refused.refusal);
}

/// Accepts the document, and refuses it at the place after each of the replacements.
fn assert_each_matters(text: &str, changes: &[(&str, &str, &str)]) {
    assert_accepted(text);
    for (old, new, place) in changes {
        assert!(text.contains(old), "{old} in {text}");
        let changed = text.replacen(old, new, 1);
        assert_refused(&changed, place);
    }
}

/// A claim of the distance of the point (1, 0) from the circle of radius 1/2 about the origin.
fn distance(relation: &str, bound: &str, witness: &str) -> String {
    let statement =
        format!(r#"{{"form":0,"point":["1","0"],"relation":"{relation}","bound":"{bound}"}}"#);
    document(&[CIRCLE], "distance", &statement, witness)
}
