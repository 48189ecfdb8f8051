//! Questions to the engine: a kind, what it is asked about, and the answer that is claimed.

mod certified;
mod equations;
mod polar;

use crate::document::{Format, write_form};
use crate::error::{Error, Result};
use crate::language::{Numbers, parse_form};
use crate::limits::Limits;
use crate::paper::data::example;
use crate::paper::text::Text;
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

/// A kind of question: its name, how it is answered, and the sentence about the answer, without a full stop.
///
/// In the sentence `{0}`, `{1}`, … are the parts of the subject between `|`, the first one as code, {claim} is the claimed
/// answer, `{found}` what was found in words, and `{code}` what was found as code.
type Kind = (&'static str, Asked, &'static str);

/// Every kind of question.
const KINDS: [Kind; 21] = [
    // Several equations for a curve in space.
    (
        "equation",
        equations::equation,
        "the implicit form of {0} is the zero set of {code}",
    ),
    // Eqs. (1), (10), (11) and (15).
    (
        "polar equation",
        equations::polar_equation,
        "cleared of denominators, what the paper constructs from {0} is the zero set of {code}",
    ),
    // What Eqs. (1) and (15) have beside the form, and the surfaces of Theorem 3 beside the curve.
    (
        "spurious",
        equations::spurious,
        "beside the squared radius, what the paper constructs from {0} has these spurious factors: {code}",
    ),
    (
        "order at the origin",
        equations::origin,
        "the polynomial of {0} vanishes at the origin to the order {found}",
    ),
    (
        "degrees",
        equations::degrees,
        "the homogeneous parts of the polynomial of {0} have the degrees {found}",
    ),
    // Of an outline of paper-examples and its N harmonics.
    (
        "fitted degrees",
        equations::fitted_degrees,
        "with {1} harmonics, the homogeneous parts of the polynomial of the outline {0} have the degrees {found}",
    ),
    (
        "factors",
        equations::factors,
        "the powers of irreducible polynomials over Q in {0} are {code}",
    ),
    (
        "same",
        equations::same,
        "the forms {0} and {claim} are {found}",
    ),
    (
        "perfect square",
        equations::perfect_square,
        "the polynomial F of Theorem 2 for {0} is {found}",
    ),
    // Eqs. (7) and (8) with symbols K0, K1, … and rho = r².
    (
        "squared away",
        equations::squared_away,
        "for N = {0} and rho = r², what Theorem 2 gives for symbols K0, K1, … and {claim} are {found}",
    ),
    (
        "back",
        polar::back,
        "from the radius {0} to its polynomial and back by Lemma 3, one gets {found}",
    ),
    (
        "lemma",
        polar::lemma,
        "for the radius of {0} there is {found}",
    ),
    (
        "radius",
        polar::radius,
        "the closed forms of the radius of {0} are {code}",
    ),
    (
        "real",
        polar::real,
        "the first radius of {0} is real for θ in {code}",
    ),
    (
        "lines",
        polar::lines,
        "the straight lines through the origin in {0} have the angles {code}",
    ),
    (
        "folds",
        polar::folds,
        "the discriminant of {0}, as a polynomial in t = tan θ, has {found}",
    ),
    // Theorem 7.
    ("curves", polar::curves, "the surfaces {0} meet in {code}"),
    (
        "positive roots",
        certified::positive_roots,
        "at {1} degrees, the number of positive radii of {0} is {found}",
    ),
    (
        "closed forms",
        certified::closed_forms,
        "in {1} directions, {0} has {found}",
    ),
    (
        "section",
        certified::section,
        "the sphere of radius {2} about ({1}) meets the surface {0} for θ/π in {found}",
    ),
    (
        "inspect",
        certified::inspect,
        "with the tolerance {2} and the surface {0}, the point ({1}) is {found}",
    ),
];

/// A question: its kind and its subject.
#[derive(Clone, Debug)]
pub(super) struct Question<'a> {
    kind: &'static Kind,
    subject: &'a str,
}

impl<'a> Question<'a> {
    /// From `kind: subject`.
    ///
    /// # Errors
    /// [`Error::Usage`] for an unknown kind, with those that there are.
    pub(super) fn new(text: &'a str) -> Result<Self> {
        let (name, subject) = text.split_once(':').unwrap_or((text, ""));
        match KINDS.iter().find(|(kind, ..)| *kind == name.trim()) {
            Some(kind) => Ok(Self {
                kind,
                subject: subject.trim(),
            }),
            None => {
                let kinds: Vec<&str> = KINDS.iter().map(|(kind, ..)| *kind).collect();
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
        (self.kind.1)(self.subject, claimed, limits)
    }

    /// What was found, as a sentence; and what was claimed, if it is something else.
    pub(super) fn sentence(&self, answer: &Answer, claimed: &str) -> Text {
        let subjects: Vec<&str> = self.subject.split('|').map(str::trim).collect();
        let sentence = self.kind.2;
        let mut text = Text::default();
        for (index, part) in sentence.split(['{', '}']).enumerate() {
            text = match (index % 2, part) {
                (0, words) => text.followed_by(Text::marked(words)),
                (_, "0") => text.code(subjects[0]),
                (_, "found") => text.words(&answer.found),
                (_, "code") => code(text, &answer.found),
                (_, "claim") => text.code(claimed),
                (_, number) => {
                    let part = number.parse().ok().and_then(|k: usize| subjects.get(k));
                    text.words(part.unwrap_or(&""))
                }
            };
        }
        if !answer.agrees && !sentence.contains("{claim}") {
            text = text.words(", and not ");
            text = match sentence.contains("{code}") {
                true => code(text, claimed),
                false => text.words(claimed),
            };
        }
        text.words(".")
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

/// An answer as code, unless there is none.
fn code(text: Text, answer: &str) -> Text {
    if answer == "none" {
        text.words(answer)
    } else {
        text.code(answer)
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
