//! The inspectors of all kinds of forms, behind one interface.

use std::sync::Arc;

use crate::error::Result;
use crate::exact::Rational;
use crate::inspect::{
    CurveInspector, DistanceBounds, HarmonicInspector, Inspection, Inspector, PatchInspector,
    PlanePoint, Sides, SuperquadricInspector, ToleranceZone, Verdict, rounding,
};
use crate::intervals::{Interval, rational};

/// The inspector that compares points with a form, for one tolerance.
#[derive(Debug)]
pub(super) enum Against {
    /// The inspector of an equation.
    Equation(Inspector),
    /// The inspector of a plane curve with its parameter.
    Plane(AgainstPlaneCurve),
    /// The inspector of a space curve with its parameter.
    Space(CurveInspector<3>),
    /// The inspector of a patch with its parameters.
    Patch(Box<PatchInspector>),
    /// The inspector of a harmonic surface.
    Harmonic(Box<HarmonicInspector>),
    /// The inspector of a superquadric.
    Superquadric(Box<SuperquadricInspector>),
}

/// The inspector of a plane curve with its parameter; points in space are compared with the cylinder over it.
#[derive(Clone, Debug)]
pub(super) struct AgainstPlaneCurve {
    pub(super) curve: CurveInspector<2>,
    /// The sides of a closed curve.
    pub(super) sides: Option<Arc<Sides>>,
    pub(super) is_cylinder: bool,
}

/// A point, by its nearest doubles and exactly; in the plane z is 0.
#[derive(Clone, Copy)]
pub(super) struct AskedPoint<'a> {
    pub(super) near: [f64; 3],
    pub(super) exactly: &'a dyn Fn() -> [Rational; 3],
}

/// A distance that a verdict may depend on, with the inspector whose tolerance it is.
#[derive(Debug)]
pub(super) struct Level {
    pub(super) distance: Rational,
    /// The distance between two doubles.
    pub(super) around: Interval,
    pub(super) against: Against,
}

impl Level {
    /// The levels of a zone besides the first one, whose inspector is given.
    pub(super) fn others(zone: &ToleranceZone, first: &Against) -> Result<Vec<Self>> {
        let distances = zone.levels().into_iter().skip(1);
        let levels = distances.map(|distance| {
            Ok(Self {
                around: Interval::narrowest(&distance),
                against: first.with_tolerance(&distance)?,
                distance,
            })
        });
        levels.collect()
    }
}

impl Against {
    /// The inspector for another tolerance; what was computed for the form is shared.
    pub(super) fn with_tolerance(&self, tolerance: &Rational) -> Result<Self> {
        Ok(match self {
            Self::Equation(inspector) => Self::Equation(inspector.with_tolerance(tolerance)?),
            Self::Plane(plane) => Self::Plane(AgainstPlaneCurve {
                curve: plane.curve.with_tolerance(tolerance)?,
                ..plane.clone()
            }),
            Self::Space(inspector) => Self::Space(inspector.with_tolerance(tolerance)?),
            Self::Patch(inspector) => Self::Patch(Box::new(inspector.with_tolerance(tolerance)?)),
            Self::Harmonic(inspector) => {
                Self::Harmonic(Box::new(inspector.with_tolerance(tolerance)?))
            }
            Self::Superquadric(inspector) => {
                Self::Superquadric(Box::new(inspector.with_tolerance(tolerance)?))
            }
        })
    }

    /// Whether the points have sides: whether their distances have signs.
    pub(super) fn has_sides(&self) -> bool {
        match self {
            Self::Equation(_) | Self::Superquadric(_) => true,
            Self::Plane(plane) => plane.sides.is_some(),
            Self::Space(_) | Self::Patch(_) => false,
            Self::Harmonic(inspector) => inspector.has_sides(),
        }
    }

    /// Whether some points are left undecided because a factor has too many monomials.
    pub(super) fn is_in_doubles_alone(&self) -> bool {
        match self {
            Self::Equation(inspector) => inspector.is_in_doubles_alone(),
            Self::Patch(inspector) => inspector.is_in_doubles_alone(),
            Self::Plane(_) | Self::Space(_) | Self::Harmonic(_) | Self::Superquadric(_) => false,
        }
    }

    /// Inspects a point that is known exactly.
    pub(super) fn point(&self, point: &[Rational; 3]) -> Inspection {
        match self {
            Self::Equation(inspector) => inspector.inspect(point),
            Self::Plane(plane) => {
                let [x, y, _] = point;
                let flat = [x.clone(), y.clone()];
                let near = flat.each_ref().map(Rational::to_f64);
                let found = plane.curve.inspect(&flat);
                plane.answers(found, near, &|| flat.clone())
            }
            Self::Space(inspector) => inspector.inspect(point),
            Self::Patch(inspector) => inspector.inspect(point),
            Self::Harmonic(inspector) => inspector.inspect(point),
            Self::Superquadric(inspector) => inspector.inspect(point),
        }
    }

    /// Inspects a point whose exact coordinates are computed only if they are needed.
    pub(super) fn near(&self, point: AskedPoint<'_>) -> Inspection {
        let AskedPoint { near, exactly } = point;
        match self {
            Self::Equation(inspector) => inspector.inspect_near(near, exactly),
            Self::Plane(plane) => {
                let [x, y, _] = near;
                let flat = || {
                    let [x, y, _] = exactly();
                    [x, y]
                };
                let found = plane.curve.inspect_near([x, y], &flat);
                plane.answers(found, [x, y], &flat)
            }
            Self::Space(inspector) => inspector.inspect_near(near, exactly),
            Self::Patch(inspector) => inspector.inspect(&exactly()),
            Self::Harmonic(inspector) => inspector.inspect_near(near, exactly),
            Self::Superquadric(inspector) => inspector.inspect_near(near, exactly),
        }
    }

    /// The side of a point of doubles, if it can be found without the distance.
    pub(super) fn quick_side(&self, point: [f64; 3]) -> Option<Option<i8>> {
        let exactly = || point.map(rational);
        match self {
            Self::Equation(inspector) => Some(Some(inspector.side(point))),
            Self::Harmonic(inspector) => Some(inspector.side(point, &exactly)),
            Self::Superquadric(inspector) => Some(inspector.side(point, &exactly)),
            Self::Plane(AgainstPlaneCurve {
                sides: Some(sides), ..
            }) if sides.need_no_distance() => {
                let [x, y, _] = point;
                let of_point = PlanePoint {
                    near: [x, y],
                    slack: 0.0,
                    exactly: &|| [x, y].map(rational),
                };
                Some(Some(sides.sign(&of_point, &DistanceBounds::UNKNOWN)))
            }
            _ => None,
        }
    }
}

impl AgainstPlaneCurve {
    /// The answers for a point, from those for its projection against the curve.
    fn answers(
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
        let curve = match self.is_cylinder {
            false => found.curve,
            // The sphere meets the cylinder exactly if the distance of the point from it is at most the tolerance.
            true => Some(found.verdict == Verdict::Inside),
        };
        Inspection {
            curve,
            sign,
            ..found
        }
    }
}
