//! Points against a tolerance (Theorem 8).

use super::equation::{
    Taken, check_curve, check_surface, cylinder, implicit_curve, surface_of_superquadric,
    through_equation,
};
use super::fit::exact_form;
use super::options::options;
use super::{Given, Remark, Work};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::fit::FitOptions;
use crate::inspect::{
    CircleSection, InspectOptions, Inspection, Inspector, MAX_SECTION_WORK, SphereSection,
};
use crate::limits::Limits;
use crate::parametrize::AngleRange;
use crate::poly::SparsePolynomial;
use crate::shape::{Form, ImplicitCurve, ImplicitSurface};

/// Significant digits of distances, if nothing else is said.
const DIGITS: u32 = 6;
/// Cubes for one point, if nothing else is said.
const BUDGET: usize = 50_000;

options! {
    /// How points are inspected.
    InspectionOptions {
        /// The largest distance that is inside.
        tolerance: Rational = Rational::one(),
        /// Distances are looked for up to here, or up to the tolerance if that is more.
        reach: f64 = 0.0,
        /// The goal for the distances: so many significant digits.
        digits: u32 = DIGITS,
        /// Cubes that may be divided for one point before it is undecided.
        budget: usize = BUDGET,
        /// How a contour is fitted.
        fit: FitOptions = FitOptions::default(),
    }
}

/// What points are held against.
#[derive(Clone, Debug)]
pub enum Subject {
    /// Points have three coordinates.
    Surface(ImplicitSurface),
    /// Points have two, in the curve's original coordinates.
    Curve(ImplicitCurve),
}

/// A surface or plane curve with a tolerance, ready for points.
#[derive(Debug)]
pub struct InspectionTask {
    subject: Subject,
    inspector: Inspector,
    tolerance: Rational,
    limits: Limits,
}

/// What is taken.
const INSPECT: Taken = Taken {
    verb: "inspect",
    these: "surfaces and plane curves",
};

/// Makes a form ready for the inspection of points with two or three coordinates; an equation in x and y is a cylinder for
/// points in space.
///
/// ```
/// use stellate::inspect::Verdict;
/// use stellate::language::Numbers;
/// use stellate::verb::{self, Given, InspectionOptions, Work};
/// let given = Given::read("x^2 + y^2 = 1", Numbers::Exact)?;
/// let options = InspectionOptions::default().tolerance("1/10".parse()?);
/// let task = verb::inspect(given, 3, &options, &Work::default())?;
/// let found = task.point(&["0.8", "0.6", "7"].map(|q| q.parse().unwrap()));
/// assert_eq!(found.verdict, Verdict::Inside);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of the fit and of the equation; [`Error::Usage`] for a form that is neither a surface nor a plane curve, and those of
/// [`Inspector`].
pub fn inspect(
    given: Given,
    dimension: usize,
    options: &InspectionOptions,
    work: &Work,
) -> Result<InspectionTask> {
    let subject = subject(given, dimension, &options.fit, work)?;
    let asked = InspectOptions {
        tolerance: options.tolerance.clone(),
        reach: options.reach,
        digits: options.digits,
        cubes: options.budget,
    };
    let inspector = work.stage("factor", || match &subject {
        Subject::Surface(surface) => Inspector::surface(surface, &asked, work.bounds()),
        Subject::Curve(curve) => Inspector::plane(curve, &asked, work.bounds()),
    })?;
    if inspector.is_in_doubles_alone() {
        work.remark(Remark::DoublesAlone);
    }
    Ok(InspectionTask {
        subject,
        inspector,
        tolerance: options.tolerance.clone(),
        limits: work.bounds().clone(),
    })
}

fn subject(given: Given, dimension: usize, fit: &FitOptions, work: &Work) -> Result<Subject> {
    let fitted = exact_form(given, fit, work)?;
    let form = through_equation(fitted.form, work)?;
    let subject = match (form, dimension) {
        (Form::Surface(surface), 3) => Subject::Surface(surface),
        (Form::SpaceSuperquadric(shape), 3) => Subject::Surface(surface_of_superquadric(&shape)?),
        (Form::Surface(_) | Form::SpaceSuperquadric(_), _) => {
            return Err(Error::Usage(
                "this is a surface: its points are X,Y,Z, such as 0.8,0.6,0".into(),
            ));
        }
        (Form::SpaceCurve(_) | Form::Intersection(_), _) => return Err(INSPECT.not_this()),
        (form, 2) => Subject::Curve(implicit_curve(form, &INSPECT, work)?),
        (form, _) => Subject::Surface(cylinder(&implicit_curve(form, &INSPECT, work)?)),
    };
    match &subject {
        Subject::Surface(surface) => check_surface(surface, work)?,
        Subject::Curve(curve) => check_curve(curve, work)?,
    }
    Ok(subject)
}

impl InspectionTask {
    /// What points are held against.
    #[must_use]
    pub fn subject(&self) -> &Subject {
        &self.subject
    }

    /// The tolerance.
    #[must_use]
    pub fn tolerance(&self) -> &Rational {
        &self.tolerance
    }

    /// What is certain of a point, in original coordinates; in the plane z is 0.
    #[must_use]
    pub fn point(&self, point: &[Rational; 3]) -> Inspection {
        self.inspector.inspect(point)
    }

    /// The same for a point that is read exactly only where that is needed: `near` are its coordinates as nearest doubles.
    pub(super) fn point_near(
        &self,
        near: [f64; 3],
        exactly: &dyn Fn() -> [Rational; 3],
    ) -> Inspection {
        self.inspector.inspect_near(near, exactly)
    }

    /// Where the section of Theorem 8 about a point is real; `None` beyond the limits of what is computed.
    ///
    /// # Errors
    /// [`Error::Interrupted`].
    pub fn ranges(&self, point: &[Rational; 3]) -> Result<Option<Vec<AngleRange>>> {
        let found = match &self.subject {
            Subject::Surface(surface) => {
                let section = SphereSection::new(surface.polynomial(), point, &self.tolerance);
                if section.work() > MAX_SECTION_WORK {
                    return Ok(None);
                }
                section.theta_ranges(&self.limits)
            }
            Subject::Curve(curve) => {
                let polynomial = SparsePolynomial::from(curve.polynomial());
                let ([x, y, z], [a, b]) = (point, curve.center());
                let point = [x - a, y - b, z.clone()];
                Ok(CircleSection::new(&polynomial, &point, &self.tolerance).theta_ranges())
            }
        };
        match found {
            Ok(ranges) => Ok(Some(ranges)),
            Err(Error::Limit { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }
}
