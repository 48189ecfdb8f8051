//! The verb `inspect`: points are compared with a form, by Theorem 8.

use std::sync::Arc;

use super::against::{Against, AgainstPlaneCurve, AskedPoint, Level};
use super::allowed::{DIGITS, check_positive};
use super::equation::{Taken, check_surface, cylinder, implicit_curve, surface_of_superquadric};
use super::fit::{exact_form, is_positive_radius};
use super::{Given, Remark, Work};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::fit::FitOptions;
use crate::implicitize::implicitize_patch;
use crate::inspect::{
    CircleSection, CurveInspector, DecidedDistance, HarmonicInspector, Inspection, Inspector,
    InspectorOptions, MAX_SECTION_WORK, PatchInspector, Section, Sides, SphereSection,
    SuperquadricInspector, ToleranceZone,
};
use crate::intervals::rational;
use crate::limits::Limits;
use crate::options::options;
use crate::poly::SparsePolynomial;
use crate::shape::{
    Form, FourierRadius, HarmonicPair, HarmonicSurface, ImplicitCurve, ImplicitSurface, Patch,
    PlaneCurve, SpaceCurve, SpaceSuperquadric, Superquadric,
};
use crate::sphere::{Positivity, positivity};
use crate::witness::{InspectedForm, Proof};

/// Superquadrics with equations of at most this degree are compared with their equations, which decides all points exactly.
const HIGH_DEGREE: u32 = 16;

options! {
    /// How points are inspected.
    InspectionOptions {
        /// The tolerance: a point at this distance or less is inside. With a lower limit, it is the upper limit of the signed distance,
        /// which may be 0.
        tolerance: Rational = Rational::one(),
        /// The lower limit of the signed distance, at most 0; by default the negative tolerance. A point inside the form has a
        /// negative signed distance, so the form must have sides, unless the limit is the negative tolerance.
        lower: Option<Rational> = None,
        /// The uncertainty of the points: the true point is at most this far from the measured one; see [`ToleranceZone`].
        uncertainty: Rational = Rational::zero(),
        /// The search radius for the nearest point of the form, greater than 0; at least the tolerance. If no point of the form is within it,
        /// the lower bound of the distance is this radius and the upper bound is infinite. By default the search goes on until the
        /// nearest point is found.
        reach: Option<f64> = None,
        /// The number of significant digits that the bounds of a distance should determine.
        digits: u32 = 6,
        /// The number of cubes that may be divided for one point before the point is undecided.
        budget: usize = 50_000,
        /// How a contour is fitted.
        fit: FitOptions = FitOptions::default(),
    }
}

/// The form that points are compared with, in original coordinates.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Subject {
    /// The zero set of an equation in x, y and z.
    Surface(ImplicitSurface),
    /// The zero set of an equation in x and y.
    Curve(ImplicitCurve),
    /// The curve r(θ).
    Radius(FourierRadius),
    /// A plane curve with its parameter.
    PlaneCurve(PlaneCurve),
    /// A space curve with its parameter.
    SpaceCurve(SpaceCurve),
    /// A patch with its parameters, and the surface of its equation.
    Patch(Box<Patch>, ImplicitSurface),
    /// The surface R(θ, φ).
    Harmonic(HarmonicSurface),
    /// A plane superquadric without an equation, or with one of a high degree.
    Superquadric(Superquadric),
    /// The same in space.
    SpaceSuperquadric(SpaceSuperquadric),
}

/// A form and a tolerance, ready to be compared with points.
#[derive(Debug)]
pub struct InspectionTask {
    subject: Subject,
    /// The inspector with the tolerance of a point on the form.
    pub(super) against: Against,
    /// The inspectors for the other distances that the zone asks about.
    pub(super) levels: Vec<Level>,
    /// The number of coordinates of a point, 2 or 3.
    dimension: usize,
    zone: ToleranceZone,
    digits: u32,
    limits: Limits,
}

/// The forms that this verb takes.
const INSPECT: Taken = Taken {
    verb: "inspect",
    these: "surfaces, and curves of the plane or with a parameter",
};

/// Prepares a form for the inspection of points with two or three coordinates. An equation in x and y is a cylinder for points
/// in space. The task then answers for one point at a time, exact ([`InspectionTask::point`]) or of doubles
/// ([`InspectionTask::of_doubles`]), or for all rows of a source ([`InspectionTask::all`]).
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
/// Those of the fit and of the equation; [`Error::Usage`] for a form that is neither a surface nor a plane curve, for two different
/// limits and a form without sides, for a reach that is not positive and digits beyond [`DIGITS`], and those of [`ToleranceZone`] and
/// [`Inspector`].
pub fn inspect(
    given: Given,
    dimension: usize,
    options: &InspectionOptions,
    work: &Work,
) -> Result<InspectionTask> {
    DIGITS.check(options.digits)?;
    if let Some(reach) = options.reach {
        check_positive("--reach", reach)?;
    }
    let zone = match &options.lower {
        None => ToleranceZone::within(options.tolerance.clone())?,
        Some(lower) => ToleranceZone::new(lower.clone(), options.tolerance.clone())?,
    };
    let zone = zone.with_uncertainty(options.uncertainty.clone())?;
    let subject = subject(given, dimension, &options.fit, work)?;
    let asked = InspectorOptions::new(zone.tolerance_of_side(None))
        .reach(options.reach)
        .digits(options.digits)
        .cubes(options.budget);
    let limits = work.bounds();
    let plane = |curve| {
        Against::Plane(AgainstPlaneCurve {
            curve,
            sides: None,
            is_cylinder: dimension == 3,
        })
    };
    let mut against = work.stage("factor", || {
        Ok(match &subject {
            Subject::Surface(surface) => {
                Against::Equation(Inspector::surface(surface, &asked, limits)?)
            }
            Subject::Curve(curve) => Against::Equation(Inspector::plane(curve, &asked, limits)?),
            Subject::Radius(radius) => plane(CurveInspector::radius(radius, &asked, limits)?),
            Subject::PlaneCurve(curve) => plane(CurveInspector::new(curve, &asked, limits)?),
            Subject::SpaceCurve(curve) => {
                Against::Space(CurveInspector::new(curve, &asked, limits)?)
            }
            Subject::Patch(patch, surface) => {
                let inspector = PatchInspector::new(patch, surface, &asked, limits)?;
                Against::Patch(Box::new(inspector))
            }
            Subject::Harmonic(surface) => {
                let pair = HarmonicPair::new(surface);
                let found = positivity(surface, &pair, limits)?;
                let is_positive = matches!(found, Positivity::Positive { .. });
                let inspector = HarmonicInspector::new(surface, is_positive, &asked, limits)?;
                Against::Harmonic(Box::new(inspector))
            }
            Subject::Superquadric(shape) => {
                let inspector =
                    SuperquadricInspector::plane(shape, dimension == 3, &asked, limits)?;
                Against::Superquadric(Box::new(inspector))
            }
            Subject::SpaceSuperquadric(shape) => {
                let inspector = SuperquadricInspector::space(shape, &asked, limits)?;
                Against::Superquadric(Box::new(inspector))
            }
        })
    })?;
    let sides = match &subject {
        Subject::Radius(radius) => {
            let is_positive = is_positive_radius(radius, work)? == Some(true);
            Some(Sides::of_radius(radius, is_positive, limits)?)
        }
        Subject::PlaneCurve(curve) => Sides::of_curve(curve, limits)?,
        _ => None,
    };
    if let Against::Plane(plane) = &mut against {
        plane.sides = sides.map(Arc::new);
    }
    if zone.tolerance().is_none() && !against.has_sides() {
        return Err(Error::Usage(format!(
            "this form has no inside and no outside: it takes one tolerance, such as {}, instead of the limits {zone}",
            zone.limits()[1].max(&-zone.limits()[0].clone())
        )));
    }
    if against.is_in_doubles_alone() {
        work.remark(Remark::DoublesAlone);
    }
    match zone.inner_width().signum() {
        -1 => work.remark(Remark::ZoneUsedUp),
        0 => work.remark(Remark::ZoneIsPoint),
        _ => {}
    }
    Ok(InspectionTask {
        levels: Level::others(&zone, &against)?,
        subject,
        against,
        dimension,
        zone,
        digits: options.digits,
        limits: limits.clone(),
    })
}

/// The form that points are compared with. A parametric form is compared itself, because its equation can have more points.
fn subject(given: Given, dimension: usize, fit: &FitOptions, work: &Work) -> Result<Subject> {
    let form = exact_form(given, fit, work)?.form;
    Ok(match (form, dimension) {
        (Form::Fourier(radius), _) => {
            work.check_degree(2 * radius.harmonics() + 2)?;
            Subject::Radius(radius)
        }
        (Form::PlaneCurve(curve), _) => Subject::PlaneCurve(curve),
        (Form::SpaceCurve(curve), 3) => Subject::SpaceCurve(curve),
        (Form::Surface(surface), 3) => {
            check_surface(&surface, work)?;
            Subject::Surface(surface)
        }
        (Form::Patch(patch), 3) => {
            let equation =
                work.stage("implicitize", || implicitize_patch(&patch, work.bounds()))?;
            check_surface(&equation.surface, work)?;
            Subject::Patch(Box::new(patch), equation.surface)
        }
        (Form::Superquadric(shape), _)
            if shape
                .even_exponent()
                .is_none_or(|n| n > HIGH_DEGREE as usize) =>
        {
            Subject::Superquadric(shape)
        }
        (Form::SpaceSuperquadric(shape), 3) => {
            let most = Rational::from(i64::from(HIGH_DEGREE));
            if shape.polynomial_degree().is_none_or(|n| n > most) {
                return Ok(Subject::SpaceSuperquadric(shape));
            }
            let surface = surface_of_superquadric(&shape)?;
            check_surface(&surface, work)?;
            Subject::Surface(surface)
        }
        (Form::Harmonic(surface), 3) => Subject::Harmonic(surface),
        (Form::Intersection(_), _) => return Err(INSPECT.not_this()),
        (Form::Surface(_) | Form::SpaceSuperquadric(_) | Form::Patch(_) | Form::Harmonic(_), _) => {
            return Err(Error::Usage(
                "this is a surface: its points are X,Y,Z, such as 0.8,0.6,0".into(),
            ));
        }
        (Form::SpaceCurve(_), _) => {
            return Err(Error::Usage(
                "this is a curve in space: its points are X,Y,Z, such as 0.8,0.6,0".into(),
            ));
        }
        (form, 2) => Subject::Curve(implicit_curve(form, &INSPECT, work)?),
        (form, _) => {
            let surface = cylinder(&implicit_curve(form, &INSPECT, work)?);
            check_surface(&surface, work)?;
            Subject::Surface(surface)
        }
    })
}

impl InspectionTask {
    /// The form that points are compared with.
    #[must_use]
    pub fn subject(&self) -> &Subject {
        &self.subject
    }

    /// The number of coordinates of a point, 2 or 3; a plane curve is a cylinder for points in space.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The tolerance zone.
    #[must_use]
    pub fn zone(&self) -> &ToleranceZone {
        &self.zone
    }

    /// The number of significant digits that the bounds of a distance should determine.
    pub(super) fn digits(&self) -> i32 {
        // Doubles have fewer.
        i32::try_from(self.digits.min(20)).invariant("20 is small")
    }

    /// The form for claims about points.
    pub(super) fn claimed(&self, proof: &mut Proof) -> InspectedForm {
        match &self.subject {
            Subject::Surface(surface) => InspectedForm::of_surface(surface, proof),
            Subject::Curve(curve) => InspectedForm::of_curve(curve, proof),
            // Distances from a cylinder over a radius have no witness.
            Subject::Radius(radius) if self.dimension == 2 => {
                InspectedForm::of_radius(radius, proof)
            }
            Subject::Harmonic(surface) => InspectedForm::of_harmonics(surface, proof),
            Subject::Radius(_)
            | Subject::PlaneCurve(_)
            | Subject::SpaceCurve(_)
            | Subject::Patch(..)
            | Subject::Superquadric(_)
            | Subject::SpaceSuperquadric(_) => InspectedForm::Other(None),
        }
    }

    /// Inspects a point, given in original coordinates; in the plane z is 0.
    #[must_use]
    pub fn point(&self, point: &[Rational; 3]) -> Inspection {
        self.judged(&|against| against.point(point), None)
    }

    /// Inspects a point whose nearest doubles are `near`. Its exact coordinates are computed only if they are needed.
    pub(super) fn point_near(
        &self,
        point: AskedPoint<'_>,
        decided: Option<&mut Vec<DecidedDistance>>,
    ) -> Inspection {
        self.judged(&|against| against.near(point), decided)
    }

    /// Inspects the point whose coordinates are these doubles, which are finite; in the plane z is 0.
    #[must_use]
    pub fn of_doubles(&self, point: [f64; 3]) -> Inspection {
        let exactly = || point.map(rational);
        let asked = AskedPoint {
            near: point,
            exactly: &exactly,
        };
        self.point_near(asked, None)
    }

    /// The side of the point whose coordinates are these doubles: the sign of [`InspectionTask::of_doubles`], without the
    /// distance where the side does not need it.
    ///
    /// ```
    /// use stellate::language::Numbers;
    /// use stellate::verb::{self, Given, InspectionOptions, Work};
    /// let given = Given::read("r = 1 + cos(3t)/8", Numbers::Exact)?;
    /// let task = verb::inspect(given, 2, &InspectionOptions::default(), &Work::default())?;
    /// let sides = [0.0, 1.125, 1.2].map(|x| task.side_of_doubles([x, 0.0, 0.0]));
    /// assert_eq!(sides, [Some(-1), Some(0), Some(1)]);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    #[must_use]
    pub fn side_of_doubles(&self, point: [f64; 3]) -> Option<i8> {
        let quick = self.against.quick_side(point);
        quick.unwrap_or_else(|| self.of_doubles(point).sign)
    }

    /// The angles at which the section of Theorem 8 about a point is real, for the tolerance of the point's side.
    ///
    /// # Errors
    /// [`Error::Interrupted`].
    pub fn section(&self, point: &[Rational; 3]) -> Result<Section> {
        match &self.subject {
            Subject::Surface(_) | Subject::Curve(_) => self.section_of(point, &self.point(point)),
            _ => Ok(Section::NotAsked),
        }
    }

    /// As [`InspectionTask::section`], for a point that has been inspected.
    pub(super) fn section_of(
        &self,
        point: &[Rational; 3],
        inspection: &Inspection,
    ) -> Result<Section> {
        let tolerance = &self.zone.tolerance_of_side(inspection.sign);
        if tolerance.is_zero() {
            return Ok(Section::NotAsked);
        }
        let found = match &self.subject {
            Subject::Surface(_) | Subject::Curve(_) if inspection.curve == Some(false) => {
                return Ok(Section::At(Vec::new()));
            }
            Subject::Surface(surface) => {
                let center = surface.center();
                let point = [0, 1, 2].map(|i| &point[i] - &center[i]);
                let section = SphereSection::new(surface.polynomial(), &point, tolerance);
                if section.work() > MAX_SECTION_WORK {
                    return Ok(Section::TooLong);
                }
                section.theta_ranges(&self.limits)
            }
            Subject::Curve(curve) => {
                let polynomial = SparsePolynomial::from(curve.polynomial());
                let ([x, y, z], [a, b]) = (point, curve.center());
                let point = [x - a, y - b, z.clone()];
                Ok(CircleSection::new(&polynomial, &point, tolerance).theta_ranges())
            }
            Subject::Radius(_)
            | Subject::PlaneCurve(_)
            | Subject::SpaceCurve(_)
            | Subject::Harmonic(_)
            | Subject::Patch(..)
            | Subject::Superquadric(_)
            | Subject::SpaceSuperquadric(_) => return Ok(Section::NotAsked),
        };
        match found {
            Ok(ranges) => Ok(Section::At(ranges)),
            Err(Error::Limit { .. }) => Ok(Section::TooLong),
            Err(error) => Err(error),
        }
    }
}
