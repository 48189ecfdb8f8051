//! The verb `implicitize`: Theorems 1 to 4 for parametric forms, and canonical equations for implicit ones.

use super::cancelled::cancelled_digits;
use super::claims::claim_equation;
use super::equation::{
    check_curve, curve_of_superquadric, squared_harmonics, surface_of_superquadric,
};
use super::fit::{Fitted, exact_form};
use super::{BeyondCurve, Fact, Given, Part, PolarTheorem, Reach, Remark, Work};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::fit::FitOptions;
use crate::implicitize::{
    Coverage, EquationProof, RealImage, Run, SquaredForm, implicitize_patch, implicitize_plane,
    implicitize_space_curve, point_beyond, polar_patch, polar_plane, polar_space_curve,
    real_counts, real_image,
};
use crate::limits::Limits;
use crate::options::options;
use crate::poly::SparsePolynomial;
use crate::shape::{
    Form, FourierRadius, HarmonicSurface, ImplicitSurface, ParametricCurve, Patch, PlaneCurve,
    SpaceCurve,
};

/// The method that finds the equation of a parametric form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ImplicitizeMethod {
    /// The substitution of Theorems 1, 3 and 4 of the paper.
    Polar,
    /// The elimination of the parameter by a resultant, for plane curves only.
    Resultant,
}

/// How the coefficients of an equation are scaled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum CoefficientScale {
    /// Coprime integers, the first term positive.
    #[default]
    Integer,
    /// The first coefficient is 1.
    Monic,
}

/// The origin of the coordinates in the equation of a contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum CoordinatesFrom {
    /// The center of the fit.
    #[default]
    Center,
    /// The origin of the contour's own coordinates.
    Original,
}

options! {
    /// How a form is implicitized.
    ImplicitizeOptions {
        /// How a contour is fitted.
        fit: FitOptions = FitOptions::default(),
        /// The method; by default Theorem 2 for radii, a resultant for plane curves, certified linear algebra in space.
        method: Option<ImplicitizeMethod> = None,
        /// How the coefficients are scaled.
        scale: CoefficientScale = CoefficientScale::Integer,
        /// The origin of the coordinates.
        coordinates: CoordinatesFrom = CoordinatesFrom::Center,
    }
}

/// An equation, or the equations of a space curve, with the facts about them.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Implicitization {
    /// The equation or equations: a [`Form::Curve`], a [`Form::Surface`] or a [`Form::Intersection`].
    pub form: Form,
    /// The facts about them.
    pub facts: Vec<Fact>,
}

/// Finds the exact equation of a form.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::shape::Form;
/// use stellate::verb::{self, Given, ImplicitizeOptions, Work};
/// let given = Given::read("r = 1 + 1/5*cos(t)", Numbers::Exact)?;
/// let found = verb::implicitize(given, &ImplicitizeOptions::default(), &Work::default())?;
/// let Form::Curve(curve) = found.form else { unreachable!() };
/// assert_eq!(curve.polynomial().homogeneous_degrees(), [4, 3, 2]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of the theorems' functions in [`crate::implicitize`]; [`Error::Usage`] for a method that the form does not have.
pub fn implicitize(
    given: Given,
    options: &ImplicitizeOptions,
    work: &Work,
) -> Result<Implicitization> {
    let Fitted { form, report } = exact_form(given, &options.fit, work)?;
    refuse_method(options.method, &form)?;
    let proved = work.proves().then(|| form.clone());
    let mut found = work.stage("implicitize", || {
        let found = equation(form, options, work)?;
        let form = match options.coordinates {
            CoordinatesFrom::Center => found.form,
            CoordinatesFrom::Original => in_original_coordinates(found.form, work)?,
        };
        Ok(Implicitization {
            form: scaled(form, options.scale),
            ..found
        })
    })?;
    if let Form::Curve(curve) = &found.form {
        check_curve(curve, work)?;
    }
    if let Some(form) = proved {
        work.claim(|proof| {
            let coordinates = match options.coordinates {
                CoordinatesFrom::Center => "center",
                CoordinatesFrom::Original => "original",
            };
            claim_equation(proof, &form, &found.form, coordinates, work)
        })?;
    }
    found.facts.extend(report.map(Fact::Fit));
    Ok(found)
}

/// Refuses a method for a form that has no choice of methods.
fn refuse_method(method: Option<ImplicitizeMethod>, form: &Form) -> Result<()> {
    let Some(method) = method else {
        return Ok(());
    };
    let message = match (method, form) {
        (
            _,
            Form::Curve(_)
            | Form::Surface(_)
            | Form::Intersection(_)
            | Form::Superquadric(_)
            | Form::SpaceSuperquadric(_),
        ) => "--method is for parametric forms; this one is implicit already",
        (_, Form::Harmonic(_)) => {
            "--method is for parametric forms; a harmonic surface has one method, the squaring of Theorem 2"
        }
        (ImplicitizeMethod::Resultant, Form::SpaceCurve(_) | Form::Patch(_)) => {
            "--method resultant is for plane curves; in space the default is certified linear algebra, and polar \
             the paper's way"
        }
        _ => return Ok(()),
    };
    Err(Error::Usage(message.into()))
}

/// The implicit form before its coefficients are scaled.
fn equation(form: Form, options: &ImplicitizeOptions, work: &Work) -> Result<Implicitization> {
    let polar = options.method == Some(ImplicitizeMethod::Polar);
    let plain = |form| Implicitization {
        form,
        facts: Vec::new(),
    };
    Ok(match form {
        Form::Fourier(radius) => of_radius(&radius, options, work)?,
        Form::Harmonic(surface) => of_harmonics(&surface, work)?,
        Form::Superquadric(shape) => plain(Form::Curve(curve_of_superquadric(&shape)?)),
        Form::SpaceSuperquadric(shape) => plain(Form::Surface(surface_of_superquadric(&shape)?)),
        Form::PlaneCurve(curve) => of_plane_curve(&curve, polar, work)?,
        Form::SpaceCurve(curve) => of_space_curve(&curve, polar, work)?,
        Form::Patch(patch) => of_patch(&patch, polar, work)?,
        implicit => plain(implicit),
    })
}

fn of_radius(
    radius: &FourierRadius,
    options: &ImplicitizeOptions,
    work: &Work,
) -> Result<Implicitization> {
    work.check_degree(2 * radius.harmonics() + 2)?;
    if options.method == Some(ImplicitizeMethod::Resultant) {
        let parametric = radius.to_plane_curve();
        let equation = implicitize_plane(&parametric, work.bounds())?;
        let (run, index) = (Run::of(&parametric), equation.tracing_index);
        let counts = real_counts(&parametric, index, work.bounds())?;
        let curve = equation.curve.with_center(radius.center().clone());
        let degree = curve.polynomial().degree();
        return Ok(Implicitization {
            facts: vec![
                Fact::Irreducible {
                    degree: degree.invariant("an equation is not 0") as u64,
                    proof: equation.proof,
                },
                Fact::TracingIndex(run.count(index)),
                real_tracing(counts, run, index),
            ],
            form: Form::Curve(curve),
        });
    }
    let form = SquaredForm::new(radius)?;
    let mut facts = Vec::new();
    if form.is_perfect_square() {
        facts.push(Fact::PerfectSquare);
        work.remark(Remark::PerfectSquare);
    }
    Ok(Implicitization {
        form: Form::Curve(form.expand()),
        facts,
    })
}

/// The equation of a harmonic surface by Theorem 2 in space.
fn of_harmonics(surface: &HarmonicSurface, work: &Work) -> Result<Implicitization> {
    let form = squared_harmonics(surface, work)?;
    let mut facts = vec![Fact::Harmonics(surface.degree())];
    if form.is_perfect_square() {
        facts.push(Fact::PerfectSquare);
        work.remark(Remark::PerfectSquare);
    }
    if !surface.rounding().is_zero() {
        facts.push(Fact::RoundedRadius(surface.rounding().clone()));
    }
    Ok(Implicitization {
        form: Form::Surface(form.expand()),
        facts,
    })
}

/// The equation of a plane curve by a resultant; also by Theorem 1 if that is requested.
pub(super) fn of_plane_curve(
    curve: &PlaneCurve,
    polar: bool,
    work: &Work,
) -> Result<Implicitization> {
    let mut equation = implicitize_plane(curve, work.bounds())?;
    let (run, index) = (Run::of(curve), equation.tracing_index);
    let degree = equation.curve.polynomial().degree();
    let mut facts = vec![
        Fact::Irreducible {
            degree: degree.invariant("an equation is not 0") as u64,
            proof: equation.proof,
        },
        Fact::TracingIndex(run.count(index)),
    ];
    add_real_image(curve, index, run, &mut facts, work)?;
    if polar {
        let whole = curve.clone();
        let search = move |limits: &Limits| polar_plane(&whole, limits);
        facts.push(unless_missing(Part::PolarPlane, search, work, |polar| {
            equation.curve = polar.curve;
            Fact::Polar {
                theorem: PolarTheorem::One,
                inverse: polar.inverse,
                factors: polar.factors,
            }
        })?);
    }
    Ok(Implicitization {
        form: Form::Curve(equation.curve),
        facts,
    })
}

/// The equations of a space curve by certified linear algebra; also by Theorem 3 if that is requested.
pub(super) fn of_space_curve(
    curve: &SpaceCurve,
    polar: bool,
    work: &Work,
) -> Result<Implicitization> {
    let equations = implicitize_space_curve(curve, work.bounds())?;
    let (run, index) = (Run::of(curve), equations.tracing_index);
    let mut facts = vec![
        Fact::CutsOutCurve(equations.degree),
        Fact::TracingIndex(run.count(index)),
    ];
    add_real_image(curve, index, run, &mut facts, work)?;
    if polar {
        let whole = curve.clone();
        let search = move |limits: &Limits| polar_space_curve(&whole, limits);
        facts.push(unless_missing(
            Part::PolarSpaceCurve,
            search,
            work,
            |polar| Fact::PolarSpaceCurve {
                surfaces: Box::new([polar.first, polar.second]),
                components: polar.components,
            },
        )?);
    }
    Ok(Implicitization {
        form: Form::Intersection(equations.surfaces),
        facts,
    })
}

/// The equation of a patch by certified linear algebra; also by Theorem 4 if that is requested.
pub(super) fn of_patch(patch: &Patch, polar: bool, work: &Work) -> Result<Implicitization> {
    let mut equation = implicitize_patch(patch, work.bounds())?;
    let run = Run::of_patch(patch);
    let degree = equation.surface.polynomial().degree();
    let index = equation.tracing_index;
    let mut facts = vec![
        Fact::Irreducible {
            degree: degree.invariant("an equation is not 0"),
            proof: EquationProof::Substitution,
        },
        Fact::PatchTracingIndex(index.and_then(|index| run.checked_count(index))),
    ];
    let whole = (patch.clone(), equation.surface.clone());
    let search = move |_: &Limits| Ok(point_beyond(&whole.0, &whole.1));
    facts.push(unless_missing(
        Part::BeyondPatch,
        search,
        work,
        Fact::BeyondPatch,
    )?);
    if polar {
        let whole = patch.clone();
        let search = move |limits: &Limits| polar_patch(&whole, limits);
        facts.push(unless_missing(Part::PolarPatch, search, work, |polar| {
            equation.surface = polar.surface;
            Fact::Polar {
                theorem: PolarTheorem::Four,
                inverse: polar.inverse,
                factors: polar.factors,
            }
        })?);
    }
    Ok(Implicitization {
        form: Form::Surface(equation.surface),
        facts,
    })
}

/// The fact about what `search` finds, or the fact that this part is missing because a limit was reached.
fn unless_missing<T: Send + 'static>(
    part: Part,
    search: impl FnOnce(&Limits) -> Result<T> + Send + 'static,
    work: &Work,
    fact: impl FnOnce(T) -> Fact,
) -> Result<Fact> {
    let found = work.unless_limited(part, search)?;
    Ok(found.map_or(Fact::Missing(part), fact))
}

/// Adds two facts: the points of the zero set beyond the curve, and how often real parameter values trace the curve.
fn add_real_image<const N: usize>(
    curve: &ParametricCurve<N>,
    tracing_index: usize,
    run: Run,
    facts: &mut Vec<Fact>,
    work: &Work,
) -> Result<()> {
    let whole = curve.clone();
    let search = move |limits: &Limits| real_image(&whole, tracing_index, limits);
    match work.unless_limited(Part::BeyondCurve, search)? {
        Some(image) => {
            facts.push(real_tracing(image.real_counts.clone(), run, tracing_index));
            facts.push(Fact::BeyondCurve(beyond(curve, image)));
        }
        None => facts.push(Fact::Missing(Part::BeyondCurve)),
    }
    Ok(())
}

/// `counts` and `tracing_index` count values of s; the fact counts values of the parameter.
fn real_tracing(counts: Option<Vec<usize>>, run: Run, tracing_index: usize) -> Fact {
    let counts = counts.map(|counts| counts.iter().map(|&count| run.count(count)).collect());
    Fact::RealTracing {
        counts,
        complex: run.count(tracing_index),
    }
}

fn beyond<const N: usize>(curve: &ParametricCurve<N>, image: RealImage<N>) -> BeyondCurve {
    let at = |s: f64| {
        let point = match Rational::try_from(s) {
            Ok(s) => curve.point(&s),
            Err(_) => curve.point_at_infinity(),
        };
        point.map(|point| point.iter().map(Rational::to_f64).collect())
    };
    BeyondCurve {
        parameter: curve.parameter().name().into(),
        approached: image.approached.map(Vec::from),
        reach: match image.coverage {
            Coverage::Whole => Reach::Whole,
            Coverage::Part(turns) => Reach::TurnsBack(turns.into_iter().map(at).collect()),
            Coverage::Unknown => Reach::Unknown,
        },
        isolated: image.isolated.points,
        are_all: image.isolated.complete,
    }
}

/// The same form, with its polynomial expanded about the origin.
fn in_original_coordinates(form: Form, work: &Work) -> Result<Form> {
    /// Fewer digits are not worth a remark.
    const FEW_DIGITS: u32 = 3;
    let (center, about, moved, expanded) = match &form {
        Form::Curve(curve) if !curve.is_centered() => {
            let moved = curve.in_original_coordinates();
            let [about, expanded] = [curve, &moved].map(|c| SparsePolynomial::from(c.polynomial()));
            (curve.center().to_vec(), about, Form::Curve(moved), expanded)
        }
        Form::Surface(surface) if !surface.is_centered() => {
            let moved = surface.in_original_coordinates(work.bounds())?.into_owned();
            let [about, expanded] = [surface, &moved].map(|s| s.polynomial().clone());
            (
                surface.center().to_vec(),
                about,
                Form::Surface(moved),
                expanded,
            )
        }
        _ => return Ok(form),
    };
    let digits = cancelled_digits(&about, &expanded, &center);
    if digits >= FEW_DIGITS {
        work.remark(Remark::Expanded { center, digits });
    }
    Ok(moved)
}

fn scaled(form: Form, scale: CoefficientScale) -> Form {
    let surface = |surface: &ImplicitSurface| {
        let f = surface.polynomial();
        let scaled = ImplicitSurface::new(match scale {
            CoefficientScale::Integer => f.primitive(),
            CoefficientScale::Monic => f.monic(),
        });
        scaled.with_center(surface.center().clone())
    };
    match form {
        Form::Curve(curve) => Form::Curve(curve.map_polynomial(|f| match scale {
            CoefficientScale::Integer => f.into_primitive(),
            CoefficientScale::Monic => f.monic(),
        })),
        Form::Surface(s) => Form::Surface(surface(&s)),
        Form::Intersection(all) => Form::Intersection(all.iter().map(surface).collect()),
        other => other,
    }
}
