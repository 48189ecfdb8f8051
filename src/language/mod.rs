//! The input language: formulas as people write them, read exactly.
//!
//! | text | form |
//! | --- | --- |
//! | `r = 1 + 1/5*cos(3*t) - 0.1*sin(5*t)` | a Fourier radius; the angle is t or theta, or another parameter |
//! | `r = 1/(1 + cos(t)/2)`, `r = cos(2t/3)`, `r = tan(t)` | a polar curve: any other radius that is rational in cosines and sines of rational multiples of the angle gives the parametric curve (r cos t, r sin t) |
//! | `r^2 = cos(2t)` | a polar curve by a power of its radius, rational in cosines and sines of rational multiples of the angle: the equation that its points satisfy; k up to 500, harmonics up to 60, with parts of the angle degrees up to 200. It may have the origin besides, as that of `r^2 = 2 + cos(t)` has |
//! | `R = 1 + Y(2,0)/5`, `R = 1 + sin(phi)^2*cos(2*theta)/5` | a harmonic surface: R is a polynomial in sin φ cos θ, sin φ sin θ and cos φ, or in the harmonics Y(l, m) of [`crate::shape::HarmonicSurface`] |
//! | `x^4 - x^2 + y^2 = 0` | an implicit curve in x and y; `= 0` may be left out |
//! | `x^2 + y^2 + z^2 = 1` | an implicit surface, as soon as z occurs (`+ 0z` is enough) |
//! | `x = sin(t); y = sin(t)*cos(t)` | a plane curve; with `z = …` a space curve |
//! | `x = cos(u)*sin(v); y = cos(u); z = cos(v)` | a patch; the parameters are two of t, theta, u, v, phi, s, w |
//! | `x^2 + y^2 = 1; z = y^5` | the intersection of two or more surfaces |
//! | `superquadric 2d a=1,2 e=1/2` | the curve `|x/a1|^(2/e) + |y/a2|^(2/e) = 1`; `level=3` makes it `= 3` |
//!
//! A parameter that no longer occurs after the coordinates are simplified does not count: `x = t; y = t^2; z = u^0` is a space
//! curve. If all coordinates are constant, the form is a point and is refused.
//!
//! A superquadric is a list of parameters, each given once and in any order. They are positive numbers, and the numerator and
//! the denominator of e are at most [`MAX_SUPERQUADRIC_EXPONENT`]. All other forms are equations.
//!
//! The grammar of equations, from the operators that bind least tightly to those that bind most tightly:
//!
//! - equations are separated by `;` or a new line. A new line within parentheses, after an operator
//!   or before one only continues the line above; one before + or − does so too, unless both
//!   lines have an `=`;
//! - `+`, `-`;
//! - `*`, `/` and two factors side by side (`2x`, `3x^2y`, `x y`, `2cos(3t)`), which bind equally tightly, from left to right:
//!   `1/2x` is (1/2)·x. A number never stands right after a factor;
//! - signs: `-x^2` is −(x²);
//! - `^` or `**`, from right to left: `2^3^2` is 2⁹, `x^2y` is x²·y. The exponent is a
//!   constant integer. `x²³` is x^23;
//! - numbers (`12`, `0.1`, `1e-5`, `0x1.8p+1`), names, `cos(…)`, `sin(…)`, `Rational(1, 3)` and parentheses. Letters without a
//!   space are split into the longest possible names: `xy` is x·y.
//!
//! Spellings of other programs are understood, too: `(t^2, t^3)`, `[t^2, t^3]`, `<t^2, t^3>` and `c(t) = (t^2, t^3)` for `x =
//! t^2; y = t^3`; a list of polynomials in x, y, z or of equations for the equations; a comma between equations; `x(t) = …`,
//! `y(x) = …`, `r(theta) = …`; `rho` for r; `f(x, y) = …`, `@(x, y) …`, `lambda x, y: …` and `(x, y) -> …` for a polynomial,
//! and `f(x) = …` for y = …; `Eq(a, b)`, `==` and `:=` for `=`, and sides that are exchanged, as in `1 + cos(t) = r`; `cos 3t`,
//! `cos^2(t)`, `Cos[t]`, `COS(t)`, `np.cos(t)`; `Fraction(1, 3)`, `pow(x, 2)`, `sqrt(4)`; braces and brackets for parentheses,
//! `.^`, `.*` and `./` of arrays, `//` of fractions. An equation between quotients of polynomials is that of their numerators
//! in lowest terms: `y = 1/x` is `x*y = 1`.
//!
//! Typographic signs (− · × θ ² ½ …), fullwidth and mathematical letters stand for what they look like, and quotes around the
//! whole text are ignored. `#` starts a comment, and so do `//` and `%` at the start of a line or between blanks; the comment
//! `# center: p/q, p/q` is the point that a plane form is relative to, `# center: p/q, p/q, p/q` that of a surface. The statements `ring R = 0, (x, y), dp; poly F = …;` of
//! Singular are read as well.
//!
//! The expressions are expanded exactly, those of a radius as trigonometric polynomials:
//!
//! ```
//! use stellate::language::{Numbers, parse_form};
//! use stellate::shape::Form;
//!
//! let Form::Fourier(r) = parse_form("r = 2 + cos(t)^2", "<form>", Numbers::Exact)? else { panic!() };
//! assert_eq!(r.cos(0).to_string(), "5/2");
//! assert_eq!(r.cos(2).to_string(), "1/2");
//!
//! let error = parse_form("x^2 + q = 0", "<form>", Numbers::Exact).unwrap_err();
//! assert!(error.to_string().starts_with("<form>:1:7: unknown name `q`"));
//! # Ok::<(), stellate::error::Error>(())
//! ```

mod angle;
mod budget;
mod coordinates;
mod divided_angle;
mod evaluate;
mod expand;
mod form;
mod fraction;
mod heads;
mod name;
mod number;
mod parser;
mod plain;
mod polar;
mod polar_equation;
mod polynomial;
mod quotient;
mod radius;
mod source;
mod spherical;
mod superquadric;
mod syntax;
mod token;
mod typed;
mod whole_angle;

pub use budget::{
    MAX_BITS, MAX_COEFFICIENTS, MAX_DEGREE, MAX_DIGITS, MAX_HARMONIC, MAX_NESTING, MAX_PRODUCTS,
    MAX_TERMS, MAX_TEXT_BYTES,
};
pub use number::Numbers;
pub use superquadric::MAX_SUPERQUADRIC_EXPONENT;

pub(crate) use form::{constant_message, implicit, implicit_curve};
pub(crate) use number::{WrittenCenter, number_at, written_center};
pub(crate) use plain::with_newlines;
pub(crate) use superquadric::{check_exponent, of_numbers as superquadric_of};

use crate::error::{Error, Result};
use crate::shape::Form;

/// The list of the forms that are read, for messages.
const UNDERSTOOD: &str = "the forms understood here: a Fourier radius \
     `r = 1 + 1/5*cos(3*t)`, a plane curve `x^2 + y^2 = 1`, a surface `x^2 + y^2 + z^2 = 1`, \
     a harmonic surface `R = 1 + Y(2,0)/5`, a parametric form `x = sin(t); y = cos(t)`, an intersection `x^2 + y^2 = 1; z = y^5`, \
     `superquadric 2d a=1,2 e=1/2`";

/// Reads a formula; the grammar is in the [module documentation](self). `source_name` is the name of the text in error
/// messages.
///
/// Cost: linear in the length of the text, up to the logarithm of the number of terms, plus the products that the text
/// contains.
///
/// ```
/// use stellate::language::{Numbers, parse_form};
/// use stellate::shape::Form;
/// let form = parse_form("x^4 - x^2 + y^2 = 0", "<form>", Numbers::Exact)?;
/// let Form::Curve(curve) = form else { panic!("a polynomial in x and y") };
/// assert_eq!(curve.polynomial().homogeneous_degrees(), [4, 2]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Syntax`] with the place in the text if it is not one of the forms above, if it divides by zero, or if the
/// polynomial is a constant; [`Error::Limit`] if one of the limits of this module is reached.
pub fn parse_form(text: &str, source_name: &str, numbers: Numbers) -> Result<Form> {
    parse(text, source_name, numbers).map(|(form, _)| form)
}

/// Reads a formula as [`parse_form`] does, and says whether the form has the origin although what is written has not: every
/// polynomial that is 0 on the curve `r^2 = 2 + cos(t)` is 0 at the origin, too.
///
/// # Errors
/// Those of [`parse_form`].
pub(crate) fn parse(text: &str, source_name: &str, numbers: Numbers) -> Result<(Form, bool)> {
    check_size(text, source_name)?;
    let text = plain::plain(text);
    let source = source::Source {
        name: source_name,
        text: &text,
    };
    if let Some(shape) = superquadric::superquadric(source, numbers)? {
        return Ok((shape, false));
    }
    let tokens = token::tokenize(source)?;
    let understood = typed::understood(source, &tokens.tokens)?;
    let mut equations = parser::parse(source, &understood)?;
    equations.iter_mut().for_each(syntax::Equation::turn);
    let mut context = evaluate::Context {
        source,
        numbers,
        budget: budget::Budget::new(),
        adds_origin: false,
    };
    let in_space = |e: &syntax::Equation| {
        e.names
            .any(&[name::Name::SpaceRadius, name::Name::Harmonic])
    };
    if equations.iter().any(in_space) {
        let form = spherical::surface(&mut context, &equations, tokens.center)?;
        return Ok((form, false));
    }
    let center = match tokens.center {
        None => None,
        Some(at) => {
            let point = written_center(source.slice(at), numbers);
            Some((at, point.map_err(|message| source.error(at, message))?))
        }
    };
    let form = form::form(&mut context, &equations, center)?;
    Ok((form, context.adds_origin))
}

/// Refuses a text beyond [`MAX_TEXT_BYTES`].
pub(crate) fn check_size(text: &str, source_name: &str) -> Result<()> {
    if text.len() > MAX_TEXT_BYTES {
        let limit = format!("{source_name}: a text of more than {MAX_TEXT_BYTES} bytes");
        return Err(Error::limit(limit));
    }
    Ok(())
}
