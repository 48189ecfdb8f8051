//! Inspection (§4 of the paper): the exact decision whether a point is within a tolerance of a surface or a plane curve.
//!
//! Theorem 8 asks whether the sphere of radius d about p and f = 0 meet in a real curve. That is sufficient for a distance of
//! at most d, but not necessary: a whole component may lie inside the ball. Both questions are answered ([`Inspection::curve`]
//! and [`Inspection::verdict`]), together with certified bounds of the distance.
//!
//! A parametric form is compared itself ([`CurveInspector`], [`PatchInspector`]), because the zero set of its equation can have
//! more points. An equation is compared as its zero set ([`Inspector`]). A harmonic surface is compared without its equation
//! ([`HarmonicInspector`]), and so is a superquadric with any exponents ([`SuperquadricInspector`]).
//!
//! For an equation, doubles with error bounds decide nearly all points: by a Taylor expansion at the foot of the point, or else
//! by cubes and by patches of the sphere. Exact arithmetic decides the other points: at a refined foot, at rational points, by
//! the exact angle ranges of the section ([`SphereSection`]), or by the gap between 0 and the smallest positive minimum. If
//! none of these decides a point, the verdict is [`Verdict::Undecided`]. An irreducible equation that is a norm g² + D·h², such as
//! that of a circle in space, is compared with the curve g = h = 0.

mod arcs;
mod boxes;
mod by_curve;
mod cells;
mod chart;
mod common_zeros;
mod coordinates;
mod criterion;
mod curve;
mod distance;
mod exact;
mod exact_foot;
mod far;
mod foot;
mod gap;
mod guess;
mod harmonic;
mod inspector;
mod known;
mod linear;
#[cfg(feature = "meshes")]
mod mesh_distance;
mod nearest;
mod origin;
mod patch;
mod proof;
mod quadric;
mod refine;
mod side;
mod sphere;
mod squared_distance;
mod summary;
mod superquadric;
mod tolerance;
mod tree;
mod winding;
mod zone;

pub use arcs::NearestPoint;
#[cfg(feature = "pictures")]
pub(crate) use chart::sphere_about;
pub use chart::{CircleSection, SphereSection};
pub(crate) use criterion::MAX_SECTION_WORK;
pub use curve::CurveInspector;
pub(crate) use foot::stationary;
pub use harmonic::HarmonicInspector;
pub(crate) use inspector::MAX_EXACT_MONOMIALS;
pub use inspector::{Inspector, InspectorOptions};
pub(crate) use known::{PlanePoint, rounding};
#[cfg(feature = "meshes")]
pub use mesh_distance::mesh_distance;
pub use nearest::Foot;
pub(crate) use nearest::{FootCandidate, unit};
pub use patch::PatchInspector;
pub(crate) use side::Sides;
pub use summary::{
    CLASSES, Histogram, HistogramRange, InspectedPoint, InspectionSummary, RowDistance, Section,
};
pub use superquadric::SuperquadricInspector;
pub use zone::ToleranceZone;
pub(crate) use zone::{DecidedDistance, is_within};

use std::fmt;

use crate::exact::Rational;
use crate::intervals::Interval;

/// Certified bounds of a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceBounds {
    /// No point of the surface is nearer.
    pub low: f64,
    /// Some point of the surface is at most this far away; ∞ if none was found within reach.
    pub high: f64,
}

impl DistanceBounds {
    /// The bounds that always hold.
    pub(crate) const UNKNOWN: Self = Self {
        low: 0.0,
        high: f64::INFINITY,
    };
    /// The bounds for a point of the surface.
    const ZERO: Self = Self {
        low: 0.0,
        high: 0.0,
    };

    /// The bounds after a verdict, which compares the distance with the tolerance.
    fn given(mut self, verdict: Verdict, tolerance: &Rational) -> Self {
        let tolerance = Interval::narrowest(tolerance);
        match verdict {
            Verdict::Inside => self.high = self.high.min(tolerance.high()),
            Verdict::Outside => self.low = self.low.max(tolerance.low()),
            Verdict::Uncertain | Verdict::Undecided => {}
        }
        self.low = self.low.min(self.high);
        self
    }
}

/// Whether the distance is at most the tolerance, or the signed distance between the limits of a [`ToleranceZone`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// The distance is at most the tolerance; of a measured point, that of every point within its uncertainty.
    Inside,
    /// The distance is larger than the tolerance; of a measured point, that of every point within its uncertainty.
    Outside,
    /// The uncertainty of the measured point leaves both open.
    Uncertain,
    /// The allowed amount of work was not enough to decide.
    Undecided,
}

impl Verdict {
    /// The name in documents: `inside`, `outside`, `uncertain` or `undecided`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Inside => "inside",
            Self::Outside => "outside",
            Self::Uncertain => "uncertain",
            Self::Undecided => "undecided",
        }
    }
}

impl fmt::Display for Verdict {
    /// Writes [`Verdict::name`].
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The certified answers for one point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Inspection {
    /// Whether the distance is at most the tolerance, or within the tolerance zone, exactly.
    pub verdict: Verdict,
    /// The exact answer to the paper's criterion: whether the surface has a real point on the sphere (for a plane curve, the
    /// circle) whose radius is the tolerance (of the point's side). `None` if it is undecided.
    pub curve: Option<bool>,
    /// Bounds of the distance.
    pub distance: DistanceBounds,
    /// The side of the form on which the point is: 0 on it, −1 inside, 1 outside; `None` for a form without sides, and for a point
    /// of which it is not known.
    ///
    /// For an equation it is the sign of its polynomial, whose first term is positive. Inside a closed plane curve with a
    /// parameter are the points around which it, traced once, winds an odd number of times; for a radius r > 0, these have ρ < r.
    pub sign: Option<i8>,
}

impl Inspection {
    /// Bounds of the signed distance, which is negative inside; `None` without a sign.
    #[must_use]
    pub fn signed_distance(&self) -> Option<[f64; 2]> {
        let DistanceBounds { low, high } = self.distance;
        self.sign.map(|sign| match sign {
            0 => [0.0, 0.0],
            1.. => [low, high],
            _ => [-high, -low],
        })
    }

    /// The answers for a point of which nothing is known.
    const UNKNOWN: Self = Self {
        verdict: Verdict::Undecided,
        curve: None,
        distance: DistanceBounds::UNKNOWN,
        sign: None,
    };
}
