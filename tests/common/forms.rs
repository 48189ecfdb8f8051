//! Forms of every kind from text.

use stellate::error::{Error, Result};
use stellate::language::{Numbers, parse_form};
use stellate::poly::{PlanePolynomial, SparsePolynomial};
use stellate::shape::{Form, Patch, PlaneCurve, SpaceCurve};

fn read(text: &str) -> Form {
    parse_form(text, "<form>", Numbers::Exact).unwrap_or_else(|e| panic!("{e}"))
}

pub(crate) fn plane_curve(text: &str) -> PlaneCurve {
    match read(text) {
        Form::PlaneCurve(curve) => curve,
        other => panic!("{text}: {other:?}"),
    }
}

pub(crate) fn space_curve(text: &str) -> SpaceCurve {
    match read(text) {
        Form::SpaceCurve(curve) => curve,
        other => panic!("{text}: {other:?}"),
    }
}

pub(crate) fn patch(text: &str) -> Patch {
    match read(text) {
        Form::Patch(patch) => patch,
        other => panic!("{text}: {other:?}"),
    }
}

pub(crate) fn plane(text: &str) -> PlanePolynomial {
    match read(text) {
        Form::Curve(curve) => curve.polynomial().primitive(),
        other => panic!("{text}: {other:?}"),
    }
}

/// `+ 0z` makes it a surface.
pub(crate) fn space(text: &str) -> SparsePolynomial<3> {
    match read(&format!("{text} + 0z")) {
        Form::Surface(surface) => surface.polynomial().primitive(),
        other => panic!("{text}: {other:?}"),
    }
}

/// The message of a refused text, and how the text goes on where the message points.
#[track_caller]
pub(crate) fn refusal(typed: &str, read: Result<Form>) -> (String, String) {
    match read {
        Err(Error::Syntax {
            message, text, at, ..
        }) => (message, text[at..].to_owned()),
        other => panic!("{typed}: {other:?}"),
    }
}
