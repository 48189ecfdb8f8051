//! The kinds of results, and the formats in which each kind can be written.

use crate::error::{Error, Result};
use crate::notation::Format::{self, Csv, Json, Latex, Maple, Singular, Sympy, Text};

/// The kinds of results, each with the formats that it can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// A Fourier radius.
    Radius,
    /// A sum of spherical harmonics.
    Harmonics,
    /// An implicit equation.
    Equation,
    /// The equations of surfaces that meet in a curve.
    Equations,
    /// Coordinates as functions of parameters.
    ParametricForm,
    /// An elliptic Fourier series.
    EllipticSeries,
    /// The fits of many outlines.
    FitTable,
    /// A superquadric.
    Superquadric,
    /// The description of a form.
    Description,
    /// The radii of a form, or the coordinates of an intersection, before it is known which of them there are.
    Parametrization,
    /// A fitted series, before it is known of which model.
    Fit,
    /// Radii of a plane curve, none of which is a Fourier series.
    ClosedForms,
    /// Radii of a surface.
    SurfaceRadii,
    /// Certified points in directions.
    Points,
    /// Certified arcs of the curve in which surfaces meet.
    Arcs,
    /// Verdicts of an inspection.
    Verdicts,
    /// The comparison of the numbers of a float program with exact ones.
    Check,
    /// Test vectors for float programs.
    Vectors,
    /// The statements of the paper.
    Statements,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 19] = [
        Self::Radius,
        Self::Harmonics,
        Self::Equation,
        Self::Equations,
        Self::ParametricForm,
        Self::EllipticSeries,
        Self::FitTable,
        Self::Superquadric,
        Self::Description,
        Self::Parametrization,
        Self::Fit,
        Self::ClosedForms,
        Self::SurfaceRadii,
        Self::Points,
        Self::Arcs,
        Self::Verdicts,
        Self::Check,
        Self::Vectors,
        Self::Statements,
    ];

    /// The row of a kind in the table: its name for messages, its formats, and a hint for users who want another format.
    const fn row(self) -> (&'static str, &'static [Format], &'static str) {
        const FORMULAS: &[Format] = &[Text, Json, Latex, Sympy, Maple];
        const SERIES: &[Format] = &[Text, Json, Csv, Latex, Sympy, Maple];
        const NO_SINGULAR: &str =
            "; Singular has no trigonometric functions, but reads what implicitize writes";
        match self {
            Self::Radius => ("a Fourier radius is", SERIES, NO_SINGULAR),
            Self::Parametrization => ("what parametrize finds is", SERIES, NO_SINGULAR),
            Self::Fit => ("a fit is", SERIES, NO_SINGULAR),
            Self::Harmonics => (
                "a harmonic surface is",
                &[Text, Json, Csv, Latex, Sympy],
                "; implicitize writes its equation in every format",
            ),
            Self::Equation => ("an equation is", &Format::ALL, ""),
            Self::Equations => (
                "several equations are",
                &[Text, Json, Latex, Sympy, Maple, Singular],
                "",
            ),
            Self::ParametricForm => ("a parametric form is", FORMULAS, ""),
            Self::EllipticSeries => ("an elliptic series is", SERIES, NO_SINGULAR),
            Self::FitTable => ("the fits of several outlines are", &[Csv], ""),
            Self::Superquadric => ("a superquadric is", &[Text, Json], ""),
            Self::Description => ("a description is", &[Text, Json], ""),
            Self::ClosedForms => (
                "a radius that is no Fourier series is",
                FORMULAS,
                "; only a Fourier series is a table of coefficients",
            ),
            Self::SurfaceRadii => (
                "the radii of a surface are",
                FORMULAS,
                "; stellate sample writes points",
            ),
            Self::Points => ("points are", &[Csv, Json], ""),
            Self::Arcs => ("arcs are", &[Csv, Json], ""),
            Self::Verdicts => ("verdicts are", &[Csv, Json, Text], ""),
            Self::Check => ("a check is", &[Text, Json, Csv], ""),
            Self::Vectors => ("test vectors are", &[Json], ""),
            Self::Statements => ("the statements of the paper are", &[Text, Json], ""),
        }
    }

    /// The formats of this kind; the first one is the default.
    #[must_use]
    pub const fn formats(self) -> &'static [Format] {
        self.row().1
    }

    /// Checks whether results of this kind can be written in a format. Callers should check before they start any work.
    ///
    /// ```
    /// use stellate::document::{Format, Kind};
    /// assert!(Kind::Points.check(Format::Csv).is_ok());
    /// let error = Kind::Points.check(Format::Latex).unwrap_err();
    /// assert_eq!(error.to_string(), "--format latex: points are written as csv or json");
    /// ```
    ///
    /// # Errors
    /// [`Error::Format`], with the formats of the kind.
    pub fn check(self, format: Format) -> Result<()> {
        match self.formats().contains(&format) {
            true => Ok(()),
            false => Err(self.refused(format)),
        }
    }

    /// The error for a format that this kind does not have.
    pub(crate) fn refused(self, format: Format) -> Error {
        let (what, formats, hint) = self.row();
        let names: Vec<&str> = formats.iter().map(|format| format.name()).collect();
        let list = match names.split_last() {
            Some((last, [])) => (*last).to_owned(),
            Some((last, others)) => format!("{} or {last}", others.join(", ")),
            None => String::new(),
        };
        Error::Format {
            format: format.name(),
            written_as: format!("{what} written as {list}{hint}"),
        }
    }
}
