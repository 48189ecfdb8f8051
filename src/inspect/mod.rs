//! Inspection (§4 of the paper): is a point within a tolerance of a surface or a plane curve, exactly?
//!
//! Theorem 8 asks whether the sphere of radius d about p and f = 0 meet in a real curve. That is sufficient for a distance of at
//! most d, but not necessary: a whole component may lie inside the ball. Both questions are answered here
//! ([`Inspection::curve`], [`Inspection::verdict`]), with certified bounds of the distance itself.
//!
//! A form that is given by parameters is inspected itself ([`CurveInspector`], [`PatchInspector`]), an equation as its zero set
//! ([`Inspector`]): the zero set of a form's equation can have more points than the form.
//!
//! For an equation doubles with error bounds decide nearly all points ([`Inspector`]): an expansion at the foot of the point, else cubes and
//! patches of the sphere. What they leave open is decided in exact arithmetic: at a refined foot, at rational points,
//! by the exact angle ranges of the section ([`SphereSection`]), or by the gap between 0 and the smallest positive minimum. If
//! that fails, too, the verdict is [`Verdict::Undecided`].

mod boxes;
mod chart;
mod criterion;
mod curve;
mod distance;
mod exact;
mod foot;
mod gap;
mod inspector;
mod patch;
mod proof;
mod sphere;
mod squared_distance;
mod summary;

#[cfg(feature = "pictures")]
pub(crate) use chart::sphere_about;
pub use chart::{CircleSection, SphereSection};
pub(crate) use criterion::MAX_SECTION_WORK;
pub use curve::CurveInspector;
pub(crate) use inspector::MAX_EXACT_MONOMIALS;
pub use inspector::{InspectOptions, Inspector};
pub use patch::PatchInspector;
pub use summary::{InspectedPoint, InspectionSummary, Section};

use std::fmt;

use crate::exact::Rational;
use crate::intervals::Interval;

/// What is proved of a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceBounds {
    /// No point of the surface is nearer.
    pub low: f64,
    /// Some point of the surface is at most this far away; ∞ where none was found within reach.
    pub high: f64,
}

impl DistanceBounds {
    /// What is known before anything is known.
    pub(crate) const UNKNOWN: Self = Self {
        low: 0.0,
        high: f64::INFINITY,
    };
    /// A point of the surface.
    const ZERO: Self = Self {
        low: 0.0,
        high: 0.0,
    };

    /// With what a verdict says of the distance, too.
    fn given(mut self, verdict: Verdict, tolerance: &Rational) -> Self {
        let tolerance = Interval::narrowest(tolerance);
        match verdict {
            Verdict::Inside => self.high = self.high.min(tolerance.high()),
            Verdict::Outside => self.low = self.low.max(tolerance.low()),
            Verdict::Undecided => {}
        }
        self.low = self.low.min(self.high);
        self
    }
}

/// Whether the distance is at most the tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// It is.
    Inside,
    /// It is not.
    Outside,
    /// The stated work did not suffice to tell.
    Undecided,
}

impl Verdict {
    /// `inside`, `outside` or `undecided`, as documents have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Inside => "inside",
            Self::Outside => "outside",
            Self::Undecided => "undecided",
        }
    }
}

impl fmt::Display for Verdict {
    /// [`Verdict::name`].
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What is certain of one point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Inspection {
    /// Whether the distance is at most the tolerance, exactly.
    pub verdict: Verdict,
    /// The paper's criterion, exactly: whether the sphere (for a plane curve: the circle) whose radius is the tolerance and the
    /// surface have a real point in common. `None` where that is undecided.
    pub curve: Option<bool>,
    /// Bounds of the distance.
    pub distance: DistanceBounds,
}

impl Inspection {
    /// What is known before anything is known.
    const UNKNOWN: Self = Self {
        verdict: Verdict::Undecided,
        curve: None,
        distance: DistanceBounds::UNKNOWN,
    };
}
