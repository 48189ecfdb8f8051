//! Questions that the library answers. A question has a kind and a subject, and a claimed answer is compared with the answer
//! that the library finds.

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

/// The answer that the library found, and whether it is the claimed one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Answer {
    pub(super) found: String,
    pub(super) agrees: bool,
}

/// The function that answers questions of one kind, from the subject and the claimed answer.
type Asked = fn(&str, &str, &Limits) -> Result<Answer>;

/// A kind of question: its name, the function that answers it, and a sentence about the answer, without a full stop.
///
/// In the sentence, `{0}`, `{1}`, … are the parts of the subject between `|`, the first one as code. `{claim}` is the claimed
/// answer, `{found}` the answer that was found, in words, and `{code}` the same as code.
type Kind = (&'static str, Asked, &'static str);

/// Every kind of question.
const KINDS: [Kind; 21] = [
    // The answer is a list of equations if the subject is a curve in space.
    (
        "equation",
        equations::equation,
        "the implicit form of {0} is the zero set of {code}",
    ),
    // The equation is that of Eqs. (1), (10), (11) or (15).
    (
        "polar equation",
        equations::polar_equation,
        "cleared of denominators, what the paper constructs from {0} is the zero set of {code}",
    ),
    // For a plane curve and a patch these are the factors of Eqs. (1) and (15) that are not its own equation; for a curve in
    // space, the second surfaces of the components in which the surfaces of Theorem 3 meet beside the curve.
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
    // The subject is an outline of paper-examples and a number N of harmonics.
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
    // Eq. (7) or (8) with symbols K0, K1, … and rho = r².
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
    // This asks for the curves of Theorem 7.
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
    /// Reads `kind: subject`.
    ///
    /// # Errors
    /// [`Error::Usage`] for an unknown kind, with a list of the known ones.
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

    /// Finds the answer and compares it with the claimed one.
    ///
    /// # Errors
    /// Those of the function that answers.
    pub(super) fn ask(&self, claimed: &str, limits: &Limits) -> Result<Answer> {
        (self.kind.1)(self.subject, claimed, limits)
    }

    /// The answer as a sentence. If another answer was claimed, the sentence contains that one, too.
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
    /// An answer in words or numbers. It agrees if it is the claimed text.
    fn text(found: String, claimed: &str) -> Self {
        let agrees = found == claimed;
        Self { found, agrees }
    }

    /// An answer that consists of polynomials. It agrees if `claimed`, as `f; g; …`, has the same polynomials up to constant
    /// factors, in any order.
    fn polynomials(found: &[SparsePolynomial<3>], claimed: &str) -> Result<Self> {
        let sorted = |list: Vec<SparsePolynomial<3>>| -> Result<Vec<String>> {
            let mut texts = list.iter().map(text_of).collect::<Result<Vec<_>>>()?;
            texts.sort_unstable();
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

/// Appends an answer as code; the answer `none` is a word.
fn code(text: Text, answer: &str) -> Text {
    if answer == "none" {
        text.words(answer)
    } else {
        text.code(answer)
    }
}

/// Reads a form from its text, or from the file of paper-examples that the text names.
fn form(text: &str) -> Result<Form> {
    let text = example(text).unwrap_or(text);
    parse_form(text, "<statement>", Numbers::Exact)
}

/// A polynomial in x, y and z.
fn polynomial(text: &str) -> Result<SparsePolynomial<3>> {
    match form(text)? {
        Form::Curve(curve) => Ok(curve.polynomial().into()),
        Form::Surface(surface) => Ok(surface.polynomial().clone()),
        _ => Err(wrong_subject(text, "a polynomial in x, y, z")),
    }
}

/// The primitive part of f as text.
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

/// The error for a subject that is not of the kind that a question expects.
fn wrong_subject(subject: &str, expected: &str) -> Error {
    Error::Usage(format!("`{subject}`: expected {expected}"))
}

fn joined(values: impl IntoIterator<Item = impl ToString>) -> String {
    let values: Vec<String> = values.into_iter().map(|v| v.to_string()).collect();
    values.join(", ")
}

/// The N parts of a subject `a | b | c`.
fn parts<const N: usize>(subject: &str) -> Result<[&str; N]> {
    let parts: Vec<&str> = subject.split('|').map(str::trim).collect();
    let count = parts.len();
    parts
        .try_into()
        .map_err(|_| wrong_subject(subject, &format!("{N} parts between `|`, not {count}")))
}
