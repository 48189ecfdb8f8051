//! The verb `describe`: the exact properties of a form.

use super::claims::{claim_description, claim_equation, claim_harmonics, claim_topology};
use super::equation::{
    Taken, check_curve, check_surface, curve_of_superquadric, squared_harmonics,
};
use super::fit::exact_form;
use super::implicitize::{of_patch, of_plane_curve, of_space_curve};
use super::topology::{CurveTopology, not_a_plane_curve, topology_of};
use super::{Content, Fact, Given, Part, Work};
use crate::describe::{Description, HarmonicDescription};
use crate::error::Result;
use crate::fit::FitOptions;
use crate::limits::Limits;
use crate::options::options;
use crate::shape::{Form, ImplicitCurve, ImplicitSurface, SpaceSuperquadric, Superquadric};

options! {
    /// How a form is described.
    DescribeOptions {
        /// How a contour is fitted.
        fit: FitOptions = FitOptions::default(),
        /// Whether the topology of a plane curve is found: components, singular points, asymptotes and genus.
        topology: bool = false,
    }
}

/// The exact properties of a form.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Described {
    /// The description, which depends on the kind of the form.
    pub what: DescribedForm,
    /// Further facts about the form.
    pub facts: Vec<Fact>,
    /// The topology of the zero set of its equation, if it was asked for and found.
    pub topology: Option<CurveTopology>,
}

/// The kinds of forms that are described.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum DescribedForm {
    /// A form with one equation.
    Equation(Description),
    /// A space curve, by the surfaces that meet in it.
    Intersection(Vec<ImplicitSurface>),
    /// A harmonic surface.
    Harmonic(HarmonicDescription),
    /// A plane superquadric.
    Superquadric(Superquadric),
    /// A superquadric in space.
    SpaceSuperquadric(SpaceSuperquadric),
}

const DESCRIBE: Taken = Taken {
    verb: "describe",
    these: "plane curves, surfaces and space curves",
};

/// Describes a form: its degree and homogeneous parts, the lemma that applies, the factors over Q, and more.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::verb::{self, DescribeOptions, DescribedForm, Given, Work};
/// let given = Given::read("x^4 - x^2 + y^2 = 0", Numbers::Exact)?;
/// let found = verb::describe(given, &DescribeOptions::default(), &Work::default())?;
/// let DescribedForm::Equation(description) = found.what else { unreachable!() };
/// assert_eq!(description.homogeneous_degrees, [4, 2]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of the fit and of [`crate::implicitize`]. Factors that are not found in time are missing, which is no error.
pub fn describe(given: Given, options: &DescribeOptions, work: &Work) -> Result<Described> {
    let mut facts = Vec::new();
    if let Content::Contour(contour) = given.content() {
        facts.push(Fact::Outline {
            vertices: contour.len(),
            area: contour.area(),
            centroid: contour.centroid(),
        });
    }
    let fitted = exact_form(given, &options.fit, work)?;
    facts.extend(fitted.report.map(Fact::Fit));
    let form = match fitted.form {
        form @ (Form::Patch(_)
        | Form::Surface(_)
        | Form::SpaceCurve(_)
        | Form::Intersection(_)
        | Form::SpaceSuperquadric(_)
        | Form::Harmonic(_))
            if options.topology =>
        {
            return Err(not_a_plane_curve(&form));
        }
        Form::Superquadric(shape) if options.topology => {
            Form::Curve(curve_of_superquadric(&shape)?)
        }
        Form::Superquadric(shape) => return Ok(described(DescribedForm::Superquadric(shape))),
        Form::SpaceSuperquadric(shape) => {
            return Ok(described(DescribedForm::SpaceSuperquadric(shape)));
        }
        Form::Harmonic(surface) => {
            let form = squared_harmonics(&surface, work)?;
            let what = work.stage("describe", || {
                HarmonicDescription::new(surface, &form, work.bounds())
            })?;
            work.claim(|proof| {
                claim_harmonics(proof, &what.surface, &form, &what.positivity, work)
            })?;
            let what = DescribedForm::Harmonic(what);
            return Ok(Described {
                what,
                facts,
                topology: None,
            });
        }
        form => work.stage("implicitize", || with_equation(form, &mut facts, work))?,
    };
    if let Form::Intersection(surfaces) = form {
        let what = DescribedForm::Intersection(surfaces);
        return Ok(Described {
            what,
            facts,
            topology: None,
        });
    }
    let description = work.stage("describe", || match &form {
        Form::Fourier(radius) => {
            work.check_degree(2 * radius.harmonics() + 2)?;
            let whole = radius.clone();
            let search = move |limits: &Limits| Description::of_radius(&whole, limits);
            let found = work.unless_limited(Part::PositiveRanges, search)?;
            found.map_or_else(|| Description::unranged_radius(radius), Ok)
        }
        Form::Curve(curve) => of_curve(curve, work),
        Form::Surface(surface) => of_surface(surface, work),
        _ => Err(DESCRIBE.not_this()),
    })?;
    if description.factors.is_none() {
        facts.push(Fact::Missing(Part::Factors));
    }
    if matches!(form, Form::Fourier(_)) && description.fourier.is_none() {
        facts.push(Fact::Missing(Part::PositiveRanges));
    }
    work.claim(|proof| claim_description(proof, &form, &description, work))?;
    let topology = if options.topology {
        let is_rational = facts.iter().any(|f| matches!(f, Fact::Parametric(_)));
        let found = topology_of(&form, &description, is_rational, work)?;
        if found.topology.is_none() {
            facts.push(Fact::Missing(Part::Topology));
        } else if facts
            .iter()
            .any(|fact| matches!(fact, Fact::BeyondCurve(beyond) if beyond.has_more()))
        {
            facts.push(Fact::TopologyOfEquation);
        }
        work.claim(|proof| {
            claim_topology(proof, &form, &found);
            Ok(())
        })?;
        Some(found)
    } else {
        None
    };
    let what = DescribedForm::Equation(description);
    Ok(Described {
        what,
        facts,
        topology,
    })
}

fn described(what: DescribedForm) -> Described {
    Described {
        what,
        facts: Vec::new(),
        topology: None,
    }
}

fn of_curve(curve: &ImplicitCurve, work: &Work) -> Result<Description> {
    check_curve(curve, work)?;
    let whole = curve.clone();
    let search = move |limits: &Limits| Description::of_curve(&whole, limits);
    let found = work.unless_limited(Part::Factors, search)?;
    Ok(found.unwrap_or_else(|| Description::unfactored_curve(curve)))
}

fn of_surface(surface: &ImplicitSurface, work: &Work) -> Result<Description> {
    check_surface(surface, work)?;
    let whole = surface.clone();
    let search = move |limits: &Limits| Description::of_surface(&whole, limits);
    let found = work.unless_limited(Part::Factors, search)?;
    Ok(found.unwrap_or_else(|| Description::unfactored_surface(surface)))
}

/// The implicit form of a parametric form; the facts about the two are added.
fn with_equation(form: Form, facts: &mut Vec<Fact>, work: &Work) -> Result<Form> {
    let found = match &form {
        Form::PlaneCurve(curve) => of_plane_curve(curve, false, work)?,
        Form::SpaceCurve(curve) => of_space_curve(curve, false, work)?,
        Form::Patch(patch) => of_patch(patch, false, work)?,
        _ => return Ok(form),
    };
    work.claim(|proof| claim_equation(proof, &form, &found.form, "center", work))?;
    facts.push(Fact::Parametric(form));
    facts.extend(found.facts);
    Ok(found.form)
}
