//! Documents: how forms are written for people and for other programs, and read back.
//!
//! Writing streams: no format builds the whole text in memory. Everything but LaTeX is read back
//! without loss, the center included.

mod angles;
mod arcs;
mod check;
mod check_tables;
mod coordinates;
mod csv;
mod description;
mod expression;
mod fourier;
mod implicit;
mod implicitization;
mod in_order;
mod inspection;
mod intersection;
mod intersection_curves;
mod json;
mod ladder;
mod mesh;
mod node;
mod numeric;
mod parametric;
mod powers;
mod rational;
mod samples;
mod spherical;
mod superquadric;
mod terms;
mod vectors;

use std::{fmt, io};

pub use arcs::{arcs_text, write_arcs};
pub use check::write_check;
pub use check_tables::{read_points_csv, read_radii_csv};
pub use coordinates::Coordinates;
pub use csv::{read_coefficients_csv, read_fourier_csv};
pub use description::{write_description, write_space_curve_description};
pub use fourier::{FitReport, write_fourier};
pub use implicit::{Annotations, write_implicit, write_surface};
pub use inspection::{InspectedPoint, InspectionSummary, InspectionWriter, write_inspection_cloud};
pub use intersection::write_intersection;
pub use intersection_curves::write_intersection_curves;
pub use json::read_document;
pub use ladder::write_ladder;
pub use mesh::{MeshFormat, write_mesh};
pub use parametric::write_parametrization;
pub use samples::{NominalAngles, SampledRay, write_samples};
pub use spherical::{WrittenDirection, WrittenMeridian, write_surface_parametrization};
pub use superquadric::{
    write_space_superquadric, write_space_superquadric_description, write_superquadric,
    write_superquadric_description,
};
pub(crate) use terms::Notation;
pub use vectors::write_vectors;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::language::{Numbers, parse_form};
use crate::shape::Form;

/// The value of the field `schema` of every JSON document.
pub const SCHEMA: &str = "stellate/1";

/// How a form is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum Format {
    /// A formula in the input language.
    #[default]
    Text,
    /// A document with every exact number as a string.
    Json,
    /// A table of coefficients.
    Csv,
    /// A formula to be typeset.
    Latex,
    /// An expression for SymPy, or for Python with x, y and Rational in scope.
    Sympy,
    /// A statement for Maple.
    Maple,
    /// Statements for Singular.
    Singular,
}

impl Format {
    /// Checks that a Fourier radius can be written in this format.
    ///
    /// ```
    /// use stellate::document::Format;
    /// assert!(Format::Maple.check_fourier().is_ok());
    /// assert!(Format::Singular.check_fourier().is_err());
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] for Singular, which computes with polynomials only.
    pub fn check_fourier(self) -> Result<()> {
        match self {
            Format::Singular => Err(Error::Usage(
                "Singular has no trigonometric functions, so a Fourier radius cannot be written \
                 for it; use text, json, csv, latex, sympy or maple, or implicitize it first"
                    .into(),
            )),
            _ => Ok(()),
        }
    }

    /// What starts a comment; JSON has none.
    fn comment(self) -> &'static str {
        match self {
            Format::Latex => "%",
            Format::Singular => "//",
            _ => "#",
        }
    }
}

impl fmt::Display for Format {
    /// The name that the command line uses.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Format::Text => "text",
            Format::Json => "json",
            Format::Csv => "csv",
            Format::Latex => "latex",
            Format::Sympy => "sympy",
            Format::Maple => "maple",
            Format::Singular => "singular",
        })
    }
}

/// Writes any form in the given format, with what is annotated if it is implicit.
///
/// # Errors
/// Those of `out`; `Unsupported` for a format that the kind of form does not have.
pub fn write_form(
    form: &Form,
    annotations: &Annotations,
    format: Format,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    match form {
        Form::Fourier(radius) => write_fourier(radius, None, format, out),
        Form::Curve(curve) => write_implicit(curve, annotations, format, out),
        Form::Surface(surface) => write_surface(surface, annotations, format, out),
        Form::Superquadric(shape) => write_superquadric(shape, format, out),
        Form::SpaceSuperquadric(shape) => write_space_superquadric(shape, format, out),
        Form::PlaneCurve(curve) => Coordinates::from(curve).write(format, out),
        Form::SpaceCurve(curve) => Coordinates::from(curve).write(format, out),
        Form::Patch(patch) => Coordinates::from(patch).write(format, out),
        Form::Intersection(surfaces) => write_intersection(surfaces, annotations, format, out),
    }
}

/// Reads a form from text that is a JSON document (if it starts with `{`) or a formula.
///
/// ```
/// use stellate::document::read_text;
/// use stellate::language::Numbers;
/// let document = r#"{"schema":"stellate/1","kind":"fourier","cos":["1","1/5"],"sin":["0","0"]}"#;
/// let formula = "r = 1 + 1/5*cos(t)";
/// let read = |text| read_text(text, "<form>", Numbers::Exact).unwrap();
/// assert_eq!(read(document), read(formula));
/// ```
///
/// # Errors
/// Those of [`read_document`] or of [`parse_form`].
pub fn read_text(text: &str, source_name: &str, numbers: Numbers) -> Result<Form> {
    if text
        .trim_start_matches('\u{feff}')
        .trim_start()
        .starts_with('{')
    {
        read_document(text, source_name, numbers)
    } else {
        parse_form(text, source_name, numbers)
    }
}

/// The text of the comment that keeps a center, if it is not the origin.
fn center_comment(center: &[Rational; 2]) -> Option<String> {
    let [x, y] = center;
    (!x.is_zero() || !y.is_zero()).then(|| format!("center: {x}, {y}"))
}
