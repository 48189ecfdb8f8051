//! `Display` and `FromStr` of forms and polynomials: a displayed form is a text of the input language and is parsed back.

use std::fmt;
use std::str::FromStr;

use super::{write_coordinates, write_form, write_fourier, write_implicit, write_surface};
use crate::error::{Error, Invariant, Result};
use crate::exact::exact_literal;
use crate::language::{Numbers, parse_form};
use crate::notation::{Format, Notation};
use crate::poly::{PlanePolynomial, SparsePolynomial};
use crate::shape::{
    Form, FourierRadius, ImplicitCurve, ImplicitSurface, ParametricCurve, Patch, PlaneCurve,
    SpaceCurve,
};

/// Displays the output of a writer without the last line break.
fn displayed(
    f: &mut fmt::Formatter<'_>,
    write: impl FnOnce(&mut Vec<u8>) -> Result<()>,
) -> fmt::Result {
    let mut text = Vec::new();
    write(&mut text).invariant("every form is written as text into memory");
    let text = String::from_utf8(text).invariant("text is UTF-8");
    f.write_str(text.trim_end_matches('\n'))
}

/// Parses a text as a form, and the form as one of the kind that `pick` accepts; `expected` names this kind in the error.
fn parsed<T>(text: &str, expected: &str, pick: impl FnOnce(Form) -> Option<T>) -> Result<T> {
    let form = parse_form(text, "<form>", Numbers::Exact)?;
    pick(form).ok_or_else(|| Error::data("<form>", format!("expected {expected}")))
}

/// Text of the input language, with a comment for the center.
///
/// ```
/// use stellate::shape::Form;
/// let form: Form = "x = sin(t); y = cos(t)*sin(t)".parse()?;
/// assert_eq!(form.to_string(), "x = sin(t)\ny = 1/2*sin(2*t)");
/// assert_eq!(form.to_string().parse::<Form>()?, form);
/// # Ok::<(), stellate::error::Error>(())
/// ```
impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        displayed(f, |out| write_form(self, &[], Format::Text, out))
    }
}

/// Reads a formula; see [`parse_form`].
impl FromStr for Form {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        parse_form(text, "<form>", Numbers::Exact)
    }
}

/// `r = …`, with a comment for the center.
///
/// ```
/// use stellate::shape::FourierRadius;
/// let radius: FourierRadius = "r = 1 + 0.2*cos(3t)".parse()?;
/// assert_eq!(radius.to_string(), "r = 1 + 1/5*cos(3*t)");
/// assert!("x = 1".parse::<FourierRadius>().is_err());
/// # Ok::<(), stellate::error::Error>(())
/// ```
impl fmt::Display for FourierRadius {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        displayed(f, |out| write_fourier(self, None, Format::Text, out))
    }
}

impl FromStr for FourierRadius {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        parsed(
            text,
            "a Fourier radius, such as r = 1 + 1/5*cos(3*t)",
            |form| match form {
                Form::Fourier(radius) => Some(radius),
                _ => None,
            },
        )
    }
}

/// `f(x, y) = 0`, with a comment for the center.
impl fmt::Display for ImplicitCurve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        displayed(f, |out| write_implicit(self, &[], Format::Text, out))
    }
}

impl FromStr for ImplicitCurve {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        parsed(
            text,
            "a polynomial in x and y, such as x^2 + y^2 = 1",
            |form| match form {
                Form::Curve(curve) => Some(curve),
                _ => None,
            },
        )
    }
}

/// `f(x, y, z) = 0`. If f does not depend on z, the text has the term 0z, so that it is read back as a surface.
impl fmt::Display for ImplicitSurface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        displayed(f, |out| write_surface(self, &[], Format::Text, out))
    }
}

impl FromStr for ImplicitSurface {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        parsed(
            text,
            "a polynomial in x, y and z, such as x^2 + y^2 + z^2 = 1",
            |form| match form {
                Form::Surface(surface) => Some(surface),
                _ => None,
            },
        )
    }
}

/// The coordinates, one to a line.
impl<const N: usize> fmt::Display for ParametricCurve<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        displayed(f, |out| write_coordinates(&self.into(), Format::Text, out))
    }
}

impl FromStr for PlaneCurve {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        parsed(
            text,
            "a plane curve, such as x = sin(t); y = cos(t)",
            |form| match form {
                Form::PlaneCurve(curve) => Some(curve),
                _ => None,
            },
        )
    }
}

impl FromStr for SpaceCurve {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        parsed(
            text,
            "a space curve, such as x = t; y = t^2; z = t^3",
            |form| match form {
                Form::SpaceCurve(curve) => Some(curve),
                _ => None,
            },
        )
    }
}

/// The coordinates, one to a line.
impl fmt::Display for Patch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        displayed(f, |out| write_coordinates(&self.into(), Format::Text, out))
    }
}

impl FromStr for Patch {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        parsed(
            text,
            "a patch, such as x = u; y = v; z = u*v",
            |form| match form {
                Form::Patch(patch) => Some(patch),
                _ => None,
            },
        )
    }
}

/// The terms in canonical order.
///
/// ```
/// use stellate::poly::PlanePolynomial;
/// let f: PlanePolynomial = "x^4 - x^2/3 + 2y".parse()?;
/// assert_eq!(f.to_string(), "x^4 - 1/3x^2 + 2y");
/// assert_eq!("7/2".parse::<PlanePolynomial>()?.to_string(), "7/2");
/// # Ok::<(), stellate::error::Error>(())
/// ```
impl fmt::Display for PlanePolynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&Notation::Text.polynomial(&SparsePolynomial::from(self)))
    }
}

/// Reads a polynomial in x and y, or a constant.
impl FromStr for PlanePolynomial {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        if let Ok(value) = exact_literal(text) {
            return Ok(Self::from_terms([((0, 0), value)]));
        }
        let expected = "a polynomial in x and y, such as x^2 + y^2 - 1, without a center";
        parsed(text, expected, |form| match form {
            Form::Curve(curve) if curve.is_centered() => Some(curve.polynomial().clone()),
            _ => None,
        })
    }
}

/// The terms in canonical order.
impl fmt::Display for SparsePolynomial<3> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&Notation::Text.polynomial(self))
    }
}

/// Reads a polynomial in some or all of x, y and z, or a constant.
///
/// ```
/// use stellate::poly::SparsePolynomial;
/// let f: SparsePolynomial<3> = "z^2 - x*y/2".parse()?;
/// assert_eq!(f.to_string(), "-1/2xy + z^2");
/// # Ok::<(), stellate::error::Error>(())
/// ```
impl FromStr for SparsePolynomial<3> {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        if let Ok(value) = exact_literal(text) {
            return Ok(Self::constant(value));
        }
        let expected = "a polynomial in x, y and z, such as x^2 + y^2 + z^2 - 1, without a center";
        parsed(text, expected, |form| match form {
            Form::Surface(surface) if surface.is_centered() => Some(surface.polynomial().clone()),
            Form::Curve(curve) if curve.is_centered() => Some(Self::from(curve.polynomial())),
            _ => None,
        })
    }
}
