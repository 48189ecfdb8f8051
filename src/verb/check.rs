//! Comparison of the numbers of a float program with the exact ones, and test vectors for float programs.

use super::equation::{
    Taken, check_curve, curve_of_superquadric, equation_and_coverage, surface_of_superquadric,
    through_equation,
};
use super::fit::{exact_form, fit_quietly};
use super::{Content, Given, Remark, Work};
use crate::check::{
    Comparison, GivenHarmonics, GivenPoint, GivenRadius, GivenSpaceRadius, InputsOf, Reference,
    Rung, SphericalReference, TestVectors, ladder, read_points_csv, read_radii_csv,
    read_space_radii_csv, test_vectors,
};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::fit::FitOptions;
use crate::implicitize::Coverage;
use crate::language::Numbers;
use crate::options::options;
use crate::poly::SparsePolynomial;
use crate::reading::{
    HarmonicConvention, HarmonicLayout, layout_of_header, read_coefficients, read_document,
    read_harmonics,
};
use crate::rows::{center_of_table, double, listed, words};
use crate::sample::RealParameters;
use crate::shape::{Form, HarmonicSurface};

/// More directions of test vectors than this are refused.
pub const MAX_VECTOR_DIRECTIONS: usize = 1_000_000;

/// The numbers of a float program.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum FloatNumbers {
    /// Coefficients of a form, each of them a double.
    Coefficients(Box<Form>),
    /// Points of a curve or surface.
    Points(Vec<GivenPoint>),
    /// Radii in directions.
    Radii(Vec<GivenRadius>),
    /// Radii in directions of space.
    SpaceRadii(Vec<GivenSpaceRadius>),
    /// Coefficients of spherical harmonics, each of them a double.
    Harmonics(GivenHarmonics),
}

/// The kind of numbers of a float program, and how they are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FloatKind {
    /// An implicit document, rows `i,j[,k],value`, or a matrix `c[i][j]`; for a harmonic surface also rows `l,m,value` or a document of kind
    /// `spherical`.
    Coefficients,
    /// Rows `x,y[,z]`, or these columns by name among others.
    Points,
    /// Rows `theta,r`, or `theta,phi,r` for a harmonic surface, or these columns by name among others.
    Radii,
}

options! {
    /// The options of a comparison.
    CheckOptions {
        /// How a contour is fitted.
        fit: FitOptions = FitOptions::default(),
    }
}

options! {
    /// The options of test vectors.
    VectorOptions {
        /// How a contour is fitted.
        fit: FitOptions = FitOptions::default(),
        /// The number of directions around the circle in which the vectors have certified radii and points.
        directions: usize = 16,
    }
}

/// The exact form that a float program's numbers are compared with.
#[derive(Debug)]
pub struct CheckTask {
    reference: Reference,
    name: String,
    /// Whether the form was given by functions of parameters.
    is_parametric: bool,
    /// Whether the equation of a parametric plane curve is known to go on where the curve ends.
    equation_has_more: bool,
    /// The harmonic surface, if the form is one.
    spherical: Option<SphericalReference>,
}

const CHECK: Taken = Taken {
    verb: "check",
    these: "plane curves and surfaces",
};

/// Prepares the exact form of a comparison. A contour is fitted, once as the options say and once with one more harmonic. A patch is
/// compared by its equation. Points are compared with those of a parametric plane curve that real parameters have, coefficients and radii
/// with those of its equation.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::verb::{self, CheckOptions, FloatKind, Given, Work};
/// let work = Work::default();
/// let circle = Given::read("x^2 + y^2 = 1", Numbers::Exact)?;
/// let task = verb::check(circle, &CheckOptions::default(), &work)?;
/// let numbers = task.read(FloatKind::Points, "0.6,0.8\n1,0\n", "points.csv")?;
/// let found = task.compare(&numbers, "points.csv", &work)?;
/// assert!(found.passes(Some(15)));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of the fit and of the equation; [`Error::Usage`] for a form that is neither a plane curve nor a surface.
pub fn check(given: Given, options: &CheckOptions, work: &Work) -> Result<CheckTask> {
    let name = given.short_name();
    let next = match (given.content(), options.fit.harmonics()) {
        (Content::Contour(contour), Some(n)) => fit_quietly(contour, &options.fit, n + 1, work),
        _ => None,
    };
    let form = exact_form(given, &options.fit, work)?.form;
    let is_parametric = matches!(form, Form::PlaneCurve(_) | Form::Patch(_));
    let spherical = match &form {
        Form::Harmonic(surface) => Some(SphericalReference::new(surface)),
        _ => None,
    };
    let (mut parameters, mut equation_has_more) = (None, false);
    let form = match form {
        Form::Superquadric(shape) => Form::Curve(curve_of_superquadric(&shape)?),
        Form::SpaceSuperquadric(shape) => Form::Surface(surface_of_superquadric(&shape)?),
        Form::PlaneCurve(curve) => {
            let (equation, coverage) = equation_and_coverage(&curve, work)?;
            let is_whole = matches!(coverage, Coverage::Whole);
            parameters = Some(RealParameters::new(&curve, is_whole));
            equation_has_more = matches!(coverage, Coverage::Part(_));
            Form::Curve(equation)
        }
        other => through_equation(other, work)?,
    };
    let reference = work.stage("implicitize", || match &form {
        Form::Fourier(radius) => {
            work.check_degree(2 * radius.harmonics() + 2)?;
            Reference::of_radius(radius)
        }
        Form::Curve(curve) => {
            check_curve(curve, work)?;
            Ok(Reference::of_curve(curve))
        }
        Form::Surface(surface) => Ok(Reference::of_surface(surface)),
        _ => Err(CHECK.not_this()),
    })?;
    work.remark_center(reference.center());
    let reference = match (next, parameters) {
        (Some(next), _) => reference.with_next(next),
        (None, Some(parameters)) => reference.with_parameters(parameters),
        (None, None) => reference,
    };
    Ok(CheckTask {
        reference,
        name,
        is_parametric,
        equation_has_more,
        spherical,
    })
}

impl CheckTask {
    /// The name of the exact form.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Reads the numbers of a float program; every number is a double and is read bit for bit. `source_name` names the text in
    /// messages.
    ///
    /// # Errors
    /// Those of [`read_points_csv`], [`read_radii_csv`], [`read_document`] and [`read_coefficients`].
    pub fn read(&self, kind: FloatKind, text: &str, source_name: &str) -> Result<FloatNumbers> {
        if let (FloatKind::Points | FloatKind::Radii, Some(center)) = (kind, center_of_table(text))
        {
            self.refuse_other_center(&center, "these numbers", source_name)?;
        }
        Ok(match kind {
            FloatKind::Coefficients => {
                let start = text.trim_start_matches('\u{feff}').trim_start();
                if self.spherical.is_some() && !start.starts_with('{') && is_of_harmonics(start) {
                    let convention = HarmonicConvention::default();
                    let layout = Some(HarmonicLayout::Long);
                    let read =
                        read_harmonics(text, source_name, layout, &convention, Numbers::F64)?;
                    return Ok(FloatNumbers::Harmonics(terms_of(&read.surface)));
                }
                let form = if start.starts_with('{') {
                    read_document(text, source_name, Numbers::F64)?
                } else {
                    read_coefficients(text, source_name, Numbers::F64)?
                };
                FloatNumbers::Coefficients(Box::new(form))
            }
            FloatKind::Points => {
                let in_space = self.reference.in_space();
                FloatNumbers::Points(read_points_csv(text, source_name, in_space)?)
            }
            FloatKind::Radii if self.spherical.is_some() => {
                FloatNumbers::SpaceRadii(read_space_radii_csv(text, source_name)?)
            }
            FloatKind::Radii => {
                self.reference.check_has_radii()?;
                FloatNumbers::Radii(read_radii_csv(text, source_name)?)
            }
        })
    }

    /// Compares the numbers with the exact ones. `source_name` names their source in messages.
    ///
    /// # Errors
    /// [`Error::Data`] for coefficients of another kind of form; those of the comparisons of [`Reference`].
    pub fn compare(
        &self,
        numbers: &FloatNumbers,
        source_name: &str,
        work: &Work,
    ) -> Result<Comparison> {
        match numbers {
            FloatNumbers::Harmonics(got) => {
                let spherical = self.spherical(source_name)?;
                work.stage("check", || Ok(spherical.check_coefficients(got)))
            }
            FloatNumbers::SpaceRadii(radii) => {
                let spherical = self.spherical(source_name)?;
                work.stage("check", || spherical.check_radii(radii, work.bounds()))
            }
            FloatNumbers::Coefficients(form) => {
                if let (Form::Harmonic(surface), Some(spherical)) = (&**form, &self.spherical) {
                    let got = terms_of(surface);
                    return work.stage("check", || Ok(spherical.check_coefficients(&got)));
                }
                let got = self.coefficients(form, source_name)?;
                work.stage("check", || Ok(self.reference.check_coefficients(&got)))
            }
            FloatNumbers::Points(points) => work.stage("check", || {
                self.reference.check_points(points, work.bounds())
            }),
            FloatNumbers::Radii(radii) => {
                if self.equation_has_more {
                    work.remark(Remark::EquationHasMore("curve"));
                }
                work.stage("check", || self.reference.check_radii(radii, work.bounds()))
            }
        }
    }

    fn spherical(&self, name: &str) -> Result<&SphericalReference> {
        self.spherical.as_ref().ok_or_else(|| {
            Error::data(
                name,
                "these belong to a harmonic surface, and the reference is none",
            )
        })
    }

    /// Refuses numbers about another center than that of the exact form.
    fn refuse_other_center(&self, center: &[Rational], what: &str, name: &str) -> Result<()> {
        let ours = self.reference.center();
        let bits = |center: &[Rational]| -> Vec<u64> {
            center.iter().map(|v| v.to_f64().to_bits()).collect()
        };
        if bits(center) == bits(ours) {
            return Ok(());
        }
        let message = format!(
            "{what} are relative to ({}), the reference to ({})",
            listed(center),
            listed(ours)
        );
        Err(Error::data(name, message))
    }

    /// The polynomial whose coefficients a float program gave, about the center of the exact form.
    fn coefficients(&self, form: &Form, name: &str) -> Result<SparsePolynomial<3>> {
        let wrong = |message: String| Error::data(name, message);
        let reference = &self.reference;
        let (polynomial, center, in_space) = match form {
            Form::Curve(curve) => {
                let polynomial = SparsePolynomial::from(curve.polynomial());
                (polynomial, &curve.center()[..], false)
            }
            Form::Surface(surface) => (surface.polynomial().clone(), &surface.center()[..], true),
            _ => {
                return Err(wrong(
                    "expected the coefficients of a polynomial: a document of kind \"implicit\", or rows i,j[,k],value".into(),
                ));
            }
        };
        if in_space != reference.in_space() {
            let [these, that] = if in_space {
                ["a surface in x, y, z", "a curve in x, y"]
            } else {
                ["a curve in x, y", "a surface in x, y, z"]
            };
            return Err(wrong(format!(
                "these are the coefficients of {these}, the reference is {that}"
            )));
        }
        // What states no center is relative to the one of the exact form.
        if !center.iter().all(Rational::is_zero) {
            self.refuse_other_center(center, "the coefficients", name)?;
        }
        Ok(polynomial)
    }
}

/// Whether a table is one of spherical harmonics: its first row names l and m, or has three numbers, where the terms of a polynomial
/// in space have four.
fn is_of_harmonics(text: &str) -> bool {
    let mut rows = text.lines().map(str::trim);
    let first = rows.find(|row| !row.is_empty() && !row.starts_with('#'));
    let fields: Vec<String> = words(first.unwrap_or(""))
        .map(str::to_ascii_lowercase)
        .collect();
    let fields: Vec<&str> = fields.iter().map(String::as_str).collect();
    let are_numbers = fields.iter().all(|field| double(field).is_ok());
    layout_of_header(&fields).is_some() || are_numbers && fields.len() == 3
}

fn terms_of(surface: &HarmonicSurface) -> GivenHarmonics {
    surface
        .terms()
        .map(|(l, m, c)| ((l, m), c.clone()))
        .collect()
}

/// Measures how many digits the paper's own algorithm keeps in doubles, for more and more harmonics of a radius.
///
/// # Errors
/// [`Error::Usage`] for a form that is no Fourier radius; those of [`ladder`].
pub fn check_doubles(given: Given, options: &CheckOptions, work: &Work) -> Result<Vec<Rung>> {
    let Form::Fourier(radius) = exact_form(given, &options.fit, work)?.form else {
        return Err(Error::Usage(
            "check --self takes a Fourier radius, or a contour with --harmonics N: Theorem 2 starts from one".into(),
        ));
    };
    work.check_degree(2 * radius.harmonics() + 2)?;
    work.stage("check", || ladder(&radius, work.bounds()))
}

/// Makes test vectors for float programs: inputs, exact results, nearest doubles and condition numbers.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::verb::{self, Given, VectorOptions, Work};
/// let radius = Given::read("r = 1 + 1/5*cos(3*t)", Numbers::Exact)?;
/// let vectors = verb::vectors(radius, &VectorOptions::default(), &Work::default())?;
/// assert_eq!(vectors.rounded, 1); // 1/5 is no double
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// As [`check`]; [`Error::Limit`] beyond [`MAX_VECTOR_DIRECTIONS`].
pub fn vectors(given: Given, options: &VectorOptions, work: &Work) -> Result<TestVectors> {
    if options.directions > MAX_VECTOR_DIRECTIONS {
        return Err(Error::limit(format!(
            "--directions {}: at most {MAX_VECTOR_DIRECTIONS} directions",
            options.directions
        )));
    }
    let task = check(
        given,
        &CheckOptions::default().fit(options.fit.clone()),
        work,
    )?;
    let inputs = if task.is_parametric {
        InputsOf::Nothing
    } else {
        InputsOf::Form
    };
    let vectors = work.stage("vectors", || {
        test_vectors(&task.reference, inputs, options.directions, work.bounds())
    })?;
    if vectors.rounded > 0 {
        work.remark(Remark::Rounded {
            rounded: vectors.rounded,
            total: vectors.inputs.len(),
        });
    }
    Ok(vectors)
}
