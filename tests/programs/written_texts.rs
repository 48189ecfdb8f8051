//! What stands beside a form in its text: comments, ends of lines, and fields of documents.

use std::path::Path;

use crate::common::program::{Run, done, piped, run_in};

const CIRCLE: &str = "x^2 + y^2 - 1 = 0\n";

fn implicitized(text: &str) -> Run {
    run_in(Path::new("."), &["implicitize", "-"], text)
}

#[test]
fn every_end_of_a_line_ends_a_comment() {
    for end in [
        "\n", "\r\n", "\r", "\u{85}", "\u{2028}", "\u{2029}", "\u{b}", "\u{c}",
    ] {
        let text = format!("# the unit circle{end}x^2 + y^2 = 1{end}");
        assert_eq!(piped(&["implicitize", "-"], &text), CIRCLE, "{end:?}");
        let table = format!("i,j,coefficient{end}2,0,1{end}0,2,1{end}0,0,-1{end}");
        assert_eq!(piped(&["implicitize", "-"], &table), CIRCLE, "{end:?}");
    }
}

#[test]
fn a_form_that_a_comment_names_is_not_taken_without_a_word() {
    let comment = "# parametrizes: x - y = 0\n";
    // A radius beside the comment that is no other form.
    let run = implicitized("# parametrizes: r = 2\nr = 2\n");
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    // What parametrize writes of a curve with roots cannot be read by itself.
    let radii = done(&["parametrize", "x^4 + y^4 = 1"]);
    let run = implicitized(&radii);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    // A radius that is another form.
    let run = implicitized(&format!("{comment}r = 2 + cos(t)\n"));
    assert_eq!((run.code, run.out.as_str()), (0, "x - y = 0\n"));
    assert!(
        run.err.contains("the form is x - y = 0, of which"),
        "{}",
        run.err
    );
    // An equation, which parametrize never writes.
    let run = implicitized(&format!("{comment}{CIRCLE}"));
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(
        run.err.contains("an equation of another form"),
        "{}",
        run.err
    );
}

#[test]
fn a_document_says_everything_once_and_agrees_with_itself() {
    let terms = r#"[{"exponents":[2,0],"coefficient":"1"},{"exponents":[0,1],"coefficient":"3"}]"#;
    let document = |more: &str| {
        format!(
            r#"{{"schema":"stellate/1","kind":"implicit","variables":["x","y"],{more}"terms":{terms}}}"#
        )
    };
    for right in ["", r#""degree":2,"#, r#""homogeneous_degrees":[2,1],"#] {
        assert_eq!(implicitized(&document(right)).code, 0, "{right}");
    }
    for (wrong, message) in [
        (
            r#""degree":3,"#,
            "degree: the terms of this document have 2 here",
        ),
        (
            r#""homogeneous_degrees":[2],"#,
            "homogeneous_degrees: the terms of this document have [2,1] here",
        ),
        (r#""terms":[],"#, "the field \"terms\" is given twice"),
    ] {
        let run = implicitized(&document(wrong));
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{wrong}");
        assert!(run.err.contains(message), "{}", run.err);
    }
}
