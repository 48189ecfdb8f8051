//! Reads superquadrics, which are lists of parameters and not equations: `superquadric 2d a=1,2 e=1/2 level=1`, `superquadric
//! 3d a=1,1,2 e=1/2,1`.

use super::number::{Numbers, written_number};
use super::source::{Source, Span};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::shape::{Form, SpaceSuperquadric, Superquadric};

/// The word that such a form starts with.
const KEYWORD: &str = "superquadric";

/// The largest numerator and denominator of an exponent e. Powers with larger ones are of no use in exact arithmetic.
pub const MAX_SUPERQUADRIC_EXPONENT: i32 = 10_000;

/// The parameters of superquadrics of one dimension, and an example for messages.
struct Kind {
    example: &'static str,
    /// For each parameter its name, its description in messages, and the number of its values.
    parameters: [(&'static str, &'static str, usize); 3],
}

const LEVEL: (&str, &str, usize) = ("level", "`level=…`, the right-hand side", 1);

const IN_THE_PLANE: Kind = Kind {
    example: "as in `superquadric 2d a=1,2 e=1/2`, or with `level=3` for a right-hand side other than 1",
    parameters: [
        ("a", "`a=a1,a2`, the semi-axes", 2),
        (
            "e",
            "`e=…`, the exponent in |x/a1|^(2/e) + |y/a2|^(2/e) = level",
            1,
        ),
        LEVEL,
    ],
};

const IN_SPACE: Kind = Kind {
    example: "as in `superquadric 3d a=1,1,2 e=1/2,1`",
    parameters: [
        ("a", "`a=a1,a2,a3`, the semi-axes", 3),
        (
            "e",
            "`e=e1,e2`, the exponents in [|x/a1|^(2/e2) + |y/a2|^(2/e2)]^(e2/e1) + |z/a3|^(2/e1) = level",
            2,
        ),
        LEVEL,
    ],
};

/// The superquadric that a text gives; `None` if the text does not begin with the keyword.
///
/// # Errors
/// [`Error::Syntax`](crate::error::Error::Syntax) at the place of a fault; [`Error::Limit`](crate::error::Error::Limit) for
/// exponents beyond [`MAX_SUPERQUADRIC_EXPONENT`].
pub(super) fn superquadric(source: Source<'_>, numbers: Numbers) -> Result<Option<Form>> {
    let mut words = Words { source, at: 0 }.peekable();
    match words.next() {
        Some(first) if source.slice(first).eq_ignore_ascii_case(KEYWORD) => {}
        _ => return Ok(None),
    }
    let end = u32::try_from(source.text.len()).invariant("a text is shorter than 4 GiB");
    let end = Span { start: end, end };
    let dimension = words.next().unwrap_or(end);
    let kind = match source.slice(dimension) {
        "2d" | "2D" => IN_THE_PLANE,
        "3d" | "3D" => IN_SPACE,
        _ => {
            return Err(source.error(
                dimension,
                format!(
                    "expected `2d` or `3d` after `{KEYWORD}`, {}",
                    IN_THE_PLANE.example
                ),
            ));
        }
    };
    let (parameters, example) = (kind.parameters, kind.example);
    let mut values: [Option<Vec<(Span, Rational)>>; 3] = Default::default();
    while let Some(name) = words.next() {
        let position = parameters
            .iter()
            .position(|(n, ..)| *n == source.slice(name));
        let Some(index) = position else {
            let shown = source.quoted(name);
            return Err(source.error(
                name,
                format!("expected a parameter a, e or level, found {shown}; {example}"),
            ));
        };
        let (_, what, count) = parameters[index];
        let equals = words.next().unwrap_or(end);
        if source.slice(equals) != "=" {
            return Err(source.error(equals, format!("expected `=`: {what}")));
        }
        let mut list = Vec::new();
        loop {
            let at = words.next().unwrap_or(end);
            list.push((at, positive(source, at, what, numbers)?));
            if words.next_if(|w| source.slice(*w) == ",").is_none() {
                break;
            }
        }
        if list.len() != count {
            let numbers = match count {
                1 => "one number",
                2 if index == 0 => "two numbers in the plane",
                2 => "two numbers",
                _ => "three numbers in space",
            };
            return Err(source.error(
                list[0].0,
                format!("{what}: expected {numbers}, found {}", list.len()),
            ));
        }
        if values[index].replace(list).is_some() {
            return Err(source.error(name, format!("a second `{}=`", source.slice(name))));
        }
    }
    let [axes, epsilon, level] = values;
    let missing =
        |index: usize| source.error(end, format!("missing {}; {example}", parameters[index].1));
    let (axes, epsilon) = (
        axes.ok_or_else(|| missing(0))?,
        epsilon.ok_or_else(|| missing(1))?,
    );
    for (at, value) in &epsilon {
        check_exponent(value).map_err(|limit| source.limit(*at, limit))?;
    }
    refuse_center(source)?;
    let numbers = |list: Vec<(Span, Rational)>| list.into_iter().map(|(_, value)| value);
    let level = level.and_then(|list| numbers(list).next());
    let level = level.unwrap_or_else(Rational::one);
    let axes: Vec<Rational> = numbers(axes).collect();
    let epsilon: Vec<Rational> = numbers(epsilon).collect();
    // The counts and the signs were checked above, so there is a form.
    Ok(of_numbers(axes, epsilon, level))
}

/// The superquadric with these semi-axes and exponents, of the dimension that their counts give; `None` if no dimension has
/// these counts, or if a number is not positive.
pub(crate) fn of_numbers(
    axes: Vec<Rational>,
    epsilon: Vec<Rational>,
    level: Rational,
) -> Option<Form> {
    match (<[Rational; 2]>::try_from(axes), epsilon.as_slice()) {
        (Ok(axes), [e]) => Superquadric::new(axes, e.clone(), level).map(Form::Superquadric),
        (Err(axes), [e1, e2]) => {
            let axes = <[Rational; 3]>::try_from(axes).ok()?;
            let epsilon = [e1.clone(), e2.clone()];
            SpaceSuperquadric::new(axes, epsilon, level).map(Form::SpaceSuperquadric)
        }
        _ => None,
    }
}

/// Refuses a comment with a center, because a superquadric has its center at the origin.
fn refuse_center(source: Source<'_>) -> Result<()> {
    let comments = source.text.match_indices('#').map(|(at, _)| at);
    let center = |at: &usize| source.text[at + 1..].trim_start().starts_with("center:");
    match comments.into_iter().find(center) {
        Some(at) => {
            let at = u32::try_from(at).invariant("a text is shorter than 4 GiB");
            let message = "a superquadric is about the origin, so it has no center";
            Err(source.error(Span { start: at, end: at }, message))
        }
        None => Ok(()),
    }
}

/// Checks the limits of an exponent. The error is a message.
pub(crate) fn check_exponent(epsilon: &Rational) -> std::result::Result<(), String> {
    let most = malachite::Integer::from(MAX_SUPERQUADRIC_EXPONENT);
    if epsilon.numerator() <= most && epsilon.denominator() <= most {
        return Ok(());
    }
    Err(format!(
        "the numerator and the denominator of e are at most {MAX_SUPERQUADRIC_EXPONENT}"
    ))
}

fn positive(source: Source<'_>, at: Span, what: &str, numbers: Numbers) -> Result<Rational> {
    let value = written_number(source.slice(at), numbers)
        .map_err(|message| source.error(at, format!("{what}: {message}")))?;
    if value.signum() > 0 {
        return Ok(value);
    }
    Err(source.error(at, format!("{what}: it must be positive")))
}

/// The words of a text. `=` and `,` are words of their own; blanks, `;` and comments separate words.
struct Words<'a> {
    source: Source<'a>,
    at: usize,
}

impl Iterator for Words<'_> {
    type Item = Span;

    fn next(&mut self) -> Option<Span> {
        let text = self.source.text;
        let separates = |c: char| c.is_whitespace() || c == ';' || c == '\u{feff}';
        loop {
            let rest = &text[self.at..];
            let first = rest.chars().next()?;
            if separates(first) {
                self.at += first.len_utf8();
            } else if first == '#' {
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else {
                break;
            }
        }
        let rest = &text[self.at..];
        let ends = |c: char| separates(c) || matches!(c, '=' | ',' | '#');
        let length = match rest.find(ends) {
            Some(0) => 1,
            Some(length) => length,
            None => rest.len(),
        };
        let start = self.at;
        self.at += length;
        let position = |at: usize| u32::try_from(at).invariant("a text is shorter than 4 GiB");
        Some(Span {
            start: position(start),
            end: position(start + length),
        })
    }
}
