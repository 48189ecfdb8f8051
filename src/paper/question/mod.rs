//! Questions to the engine: a kind, what it is asked about, and the answer that is claimed.

mod certified;
mod equations;
mod polar;

use std::fmt;

use crate::document::{Format, write_form};
use crate::error::{Error, Result};
use crate::language::{Numbers, parse_form};
use crate::limits::Limits;
use crate::paper::data::example;
use crate::poly::SparsePolynomial;
use crate::shape::{Form, ImplicitCurve, ImplicitSurface};

/// What the engine answered, and whether that is what was claimed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Answer {
    pub(super) found: String,
    pub(super) agrees: bool,
}

/// How one kind of question is answered: from the subject and the claimed answer.
type Asked = fn(&str, &str, &Limits) -> Result<Answer>;

/// Every kind of question.
const KINDS: [(&str, Asked); 21] = [
    // The implicit equation of a form; several for a curve in space.
    ("equation", equations::equation),
    // Eqs. (1), (10), (11) and (15), cleared of denominators.
    ("polar equation", equations::polar_equation),
    // What Eqs. (1) and (15) have beside the form, and the surfaces of Theorem 3 beside the curve.
    ("spurious", equations::spurious),
    // The multiplicity of the origin.
    ("multiplicity of the origin", equations::origin),
    // The degrees of the homogeneous parts.
    ("degrees", equations::degrees),
    // The degrees of the polynomial of a contour of paper-examples and its N harmonics.
    ("fitted degrees", equations::fitted_degrees),
    // The irreducible factors, with their multiplicities.
    ("factors", equations::factors),
    // Whether two texts are the same form.
    ("same", equations::same),
    // Whether F of Theorem 2 is a perfect square.
    ("perfect square", equations::perfect_square),
    // Eqs. (7) and (8) with symbols K0, K1, … and rho = r².
    ("squared away", equations::squared_away),
    // From a radius to its polynomial and back.
    ("back", polar::back),
    // Which lemma gives the radius.
    ("lemma", polar::lemma),
    // The closed forms of the radius.
    ("radius", polar::radius),
    // Where the first branch is real.
    ("real", polar::real),
    // The angles of straight lines in the zero set.
    ("lines", polar::lines),
    // The discriminant in t = tan θ: its degree and its real zeros.
    ("folds", polar::folds),
    // Theorem 7: the curves in which surfaces meet.
    ("curves", polar::curves),
    // How many certified roots r > 0 there are in directions given in degrees.
    ("positive roots", certified::positive_roots),
    // Whether the closed forms are the certified roots in so many directions.
    ("closed forms", certified::closed_forms),
    // Where the sphere of radius d about p meets a surface: multiples of π.
    ("section", certified::section),
    // Whether p is within d, and whether the paper's criterion says so.
    ("inspect", certified::inspect),
];

/// A question: its kind and its subject.
#[derive(Clone, Debug)]
pub(super) struct Question<'a> {
    kind: &'static str,
    asked: Asked,
    subject: &'a str,
}

impl<'a> Question<'a> {
    /// From `kind: subject`.
    ///
    /// # Errors
    /// [`Error::Usage`] for an unknown kind, with those that there are.
    pub(super) fn new(text: &'a str) -> Result<Self> {
        let (name, subject) = text.split_once(':').unwrap_or((text, ""));
        match KINDS.iter().find(|(kind, _)| *kind == name.trim()) {
            Some((kind, asked)) => Ok(Self {
                kind,
                asked: *asked,
                subject: subject.trim(),
            }),
            None => {
                let kinds: Vec<&str> = KINDS.iter().map(|(kind, _)| *kind).collect();
                Err(Error::Usage(format!(
                    "`{text}`: expected `identity: …`, or one of: {}",
                    kinds.join(", ")
                )))
            }
        }
    }

    /// Asks the engine.
    ///
    /// # Errors
    /// Those of the engine.
    pub(super) fn ask(&self, claimed: &str, limits: &Limits) -> Result<Answer> {
        (self.asked)(self.subject, claimed, limits)
    }
}

impl fmt::Display for Question<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", self.kind, self.subject)
    }
}

impl Answer {
    /// An answer in words or numbers, which must be the claimed one.
    fn text(found: String, claimed: &str) -> Self {
        let agrees = found == claimed;
        Self { found, agrees }
    }

    /// Polynomials up to constant factors, in any order; claimed as `f; g; …`.
    fn polynomials(found: &[SparsePolynomial<3>], claimed: &str) -> Result<Self> {
        let sorted = |list: Vec<SparsePolynomial<3>>| -> Result<Vec<String>> {
            let mut texts = list.iter().map(text_of).collect::<Result<Vec<_>>>()?;
            texts.sort();
            Ok(texts)
        };
        let claims = claimed.split(';').map(polynomial);
        let claimed = sorted(claims.collect::<Result<_>>()?)?;
        let found = sorted(found.to_vec())?;
        Ok(Self {
            agrees: found == claimed,
            found: found.join("; "),
        })
    }
}

/// A form as text, or a file of paper-examples.
fn form(text: &str) -> Result<Form> {
    let text = example(text).unwrap_or(text);
    parse_form(text, "<statement>", Numbers::Exact)
}

/// A polynomial in x, y and z.
fn polynomial(text: &str) -> Result<SparsePolynomial<3>> {
    match form(text)? {
        Form::Curve(curve) => Ok(curve.polynomial().into()),
        Form::Surface(surface) => Ok(surface.polynomial().clone()),
        _ => Err(not_asked(text, "a polynomial in x, y, z")),
    }
}

/// The primitive part as text.
fn text_of(f: &SparsePolynomial<3>) -> Result<String> {
    let f = f.primitive();
    let form = match f.to_plane() {
        Some(f) => Form::Curve(ImplicitCurve::new(f)),
        None => Form::Surface(ImplicitSurface::new(f)),
    };
    let mut text = Vec::new();
    write_form(&form, &[], Format::Text, &mut text)?;
    let text = String::from_utf8_lossy(&text);
    Ok(text.trim_end().trim_end_matches(" = 0").to_owned())
}

fn not_asked(subject: &str, expected: &str) -> Error {
    Error::Usage(format!("`{subject}`: expected {expected}"))
}

fn joined(values: impl IntoIterator<Item = impl ToString>) -> String {
    let values: Vec<String> = values.into_iter().map(|v| v.to_string()).collect();
    values.join(", ")
}

/// The parts of `a | b | c`.
fn parts<const N: usize>(subject: &str) -> Result<[&str; N]> {
    let parts: Vec<&str> = subject.split('|').map(str::trim).collect();
    let count = parts.len();
    parts
        .try_into()
        .map_err(|_| not_asked(subject, &format!("{N} parts between `|`, not {count}")))
}
