//! The verb `inspect`: points are compared with a form, by Theorem 8.

use super::equation::{Taken, check_surface, cylinder, implicit_curve, surface_of_superquadric};
use super::fit::{exact_form, is_positive_radius};
use super::{Given, Remark, Work};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::fit::FitOptions;
use crate::implicitize::implicitize_patch;
use crate::inspect::{
    CircleSection, CurveInspector, DistanceBounds, HarmonicInspector, InspectOptions, Inspection,
    Inspector, MAX_SECTION_WORK, PatchInspector, PlanePoint, Section, Sides, SphereSection,
    Verdict, rounding,
};
use crate::intervals::rational;
use crate::limits::Limits;
use crate::options::options;
use crate::poly::SparsePolynomial;
use crate::shape::{
    Form, FourierRadius, HarmonicPair, HarmonicSurface, ImplicitCurve, ImplicitSurface, Patch,
    PlaneCurve, SpaceCurve,
};
use crate::sphere::{Positivity, positivity};
use crate::witness::{InspectedForm, Proof};

/// The default number of significant digits of distances.
const DIGITS: u32 = 6;
/// The default number of cubes for one point.
const BUDGET: usize = 50_000;

options! {
    /// How points are inspected.
    InspectionOptions {
        /// The tolerance: a point at this distance or less is inside.
        tolerance: Rational = Rational::one(),
        /// The search radius for the nearest point of the form; at least the tolerance. If no point of the form is within it,
        /// the lower bound of the distance is this radius and the upper bound is infinite. By default the search goes on until the
        /// nearest point is found.
        reach: Option<f64> = None,
        /// The number of significant digits that the bounds of a distance should determine.
        digits: u32 = DIGITS,
        /// The number of cubes that may be divided for one point before the point is undecided.
        budget: usize = BUDGET,
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
    Patch(Patch, ImplicitSurface),
    /// The surface R(θ, φ).
    Harmonic(HarmonicSurface),
}

/// The inspector that compares points with the form.
#[derive(Debug)]
enum Against {
    /// The inspector of an equation.
    Equation(Inspector),
    /// The inspector of a plane curve with its parameter; points in space are compared with the cylinder over it.
    Plane(CurveInspector<2>),
    /// The inspector of a space curve with its parameter.
    Space(CurveInspector<3>),
    /// The inspector of a patch with its parameters.
    Patch(Box<PatchInspector>),
    /// The inspector of a harmonic surface.
    Harmonic(Box<HarmonicInspector>),
}

/// A form and a tolerance, ready to be compared with points.
#[derive(Debug)]
pub struct InspectionTask {
    subject: Subject,
    against: Against,
    /// The sides of a closed plane curve that is not an equation.
    sides: Option<Sides>,
    /// The number of coordinates of a point, 2 or 3.
    dimension: usize,
    tolerance: Rational,
    limits: Limits,
}

/// The forms that this verb takes.
const INSPECT: Taken = Taken {
    verb: "inspect",
    these: "surfaces, and curves of the plane or with a parameter",
};

/// Prepares a form for the inspection of points with two or three coordinates. An equation in x and y is a cylinder for points
/// in space.
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
    let asked = InspectOptions::new(options.tolerance.clone())
        .reach(options.reach)
        .digits(options.digits)
        .cubes(options.budget);
    let limits = work.bounds();
    let against = work.stage("factor", || {
        Ok(match &subject {
            Subject::Surface(surface) => {
                Against::Equation(Inspector::surface(surface, &asked, limits)?)
            }
            Subject::Curve(curve) => Against::Equation(Inspector::plane(curve, &asked, limits)?),
            Subject::Radius(radius) => {
                Against::Plane(CurveInspector::radius(radius, &asked, limits)?)
            }
            Subject::PlaneCurve(curve) => {
                Against::Plane(CurveInspector::new(curve, &asked, limits)?)
            }
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
    let is_in_doubles_alone = match &against {
        Against::Equation(inspector) => inspector.is_in_doubles_alone(),
        Against::Patch(inspector) => inspector.is_in_doubles_alone(),
        Against::Plane(_) | Against::Space(_) | Against::Harmonic(_) => false,
    };
    if is_in_doubles_alone {
        work.remark(Remark::DoublesAlone);
    }
    Ok(InspectionTask {
        subject,
        against,
        sides,
        dimension,
        tolerance: options.tolerance.clone(),
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
            Subject::Patch(patch, equation.surface)
        }
        (Form::SpaceSuperquadric(shape), 3) => {
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

    /// The tolerance.
    #[must_use]
    pub fn tolerance(&self) -> &Rational {
        &self.tolerance
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
            | Subject::Patch(..) => InspectedForm::Other(None),
        }
    }

    /// Inspects a point, given in original coordinates; in the plane z is 0.
    #[must_use]
    pub fn point(&self, point: &[Rational; 3]) -> Inspection {
        match &self.against {
            Against::Equation(inspector) => inspector.inspect(point),
            Against::Plane(inspector) => {
                let [x, y, _] = point;
                let flat = [x.clone(), y.clone()];
                let near = flat.each_ref().map(Rational::to_f64);
                let found = inspector.inspect(&flat);
                self.of_plane(found, near, &|| flat.clone())
            }
            Against::Space(inspector) => inspector.inspect(point),
            Against::Patch(inspector) => inspector.inspect(point),
            Against::Harmonic(inspector) => inspector.inspect(point),
        }
    }

    /// The answers for a point, from those for its projection against a plane curve.
    fn of_plane(
        &self,
        found: Inspection,
        near: [f64; 2],
        exactly: &dyn Fn() -> [Rational; 2],
    ) -> Inspection {
        let sign = self.sides.as_ref().map(|sides| {
            let point = PlanePoint {
                near,
                slack: rounding(near),
                exactly,
            };
            sides.sign(&point, &found.distance)
        });
        let curve = match self.dimension {
            2 => found.curve,
            // The sphere meets the cylinder exactly if the distance of the point from it is at most the tolerance.
            _ => Some(found.verdict == Verdict::Inside),
        };
        Inspection {
            curve,
            sign,
            ..found
        }
    }

    /// Inspects a point whose nearest doubles are `near`. Its exact coordinates are computed only if they are needed.
    pub(super) fn point_near(
        &self,
        near: [f64; 3],
        exactly: &dyn Fn() -> [Rational; 3],
    ) -> Inspection {
        match &self.against {
            Against::Equation(inspector) => inspector.inspect_near(near, exactly),
            Against::Plane(inspector) => {
                let [x, y, _] = near;
                let flat = || {
                    let [x, y, _] = exactly();
                    [x, y]
                };
                let found = inspector.inspect_near([x, y], &flat);
                self.of_plane(found, [x, y], &flat)
            }
            Against::Space(inspector) => inspector.inspect_near(near, exactly),
            Against::Patch(inspector) => inspector.inspect(&exactly()),
            Against::Harmonic(inspector) => inspector.inspect_near(near, exactly),
        }
    }

    /// Inspects the point whose coordinates are these doubles, which are finite; in the plane z is 0.
    #[must_use]
    pub fn of_doubles(&self, point: [f64; 3]) -> Inspection {
        self.point_near(point, &|| point.map(rational))
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
        let exactly = || point.map(rational);
        match (&self.against, &self.sides) {
            (Against::Equation(inspector), _) => Some(inspector.side(point)),
            (Against::Harmonic(inspector), _) => inspector.side(point, &exactly),
            (_, Some(sides)) if sides.need_no_distance() => {
                let [x, y, _] = point;
                let of_point = PlanePoint {
                    near: [x, y],
                    slack: 0.0,
                    exactly: &|| [x, y].map(rational),
                };
                Some(sides.sign(&of_point, &DistanceBounds::UNKNOWN))
            }
            _ => self.of_doubles(point).sign,
        }
    }

    /// The angles at which the section of Theorem 8 about a point is real.
    ///
    /// # Errors
    /// [`Error::Interrupted`].
    pub fn section(&self, point: &[Rational; 3]) -> Result<Section> {
        let found = match &self.subject {
            Subject::Surface(surface) => {
                let section = SphereSection::new(surface.polynomial(), point, &self.tolerance);
                if section.work() > MAX_SECTION_WORK {
                    return Ok(Section::TooLong);
                }
                section.theta_ranges(&self.limits)
            }
            Subject::Curve(curve) => {
                let polynomial = SparsePolynomial::from(curve.polynomial());
                let ([x, y, z], [a, b]) = (point, curve.center());
                let point = [x - a, y - b, z.clone()];
                Ok(CircleSection::new(&polynomial, &point, &self.tolerance).theta_ranges())
            }
            Subject::Radius(_)
            | Subject::PlaneCurve(_)
            | Subject::SpaceCurve(_)
            | Subject::Harmonic(_)
            | Subject::Patch(..) => return Ok(Section::NotAsked),
        };
        match found {
            Ok(ranges) => Ok(Section::At(ranges)),
            Err(Error::Limit { .. }) => Ok(Section::TooLong),
            Err(error) => Err(error),
        }
    }
}
