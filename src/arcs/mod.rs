//! Certified arcs of the curve in which two surfaces meet.

mod cover;
mod follow;
mod tube;

pub(crate) use follow::leaves_window;
pub(crate) use tube::{Enclosed as CommonZero, enclose_common_zero};

pub use cover::{ArcEnd, ArcOptions, ArcPoint, CurveArc, IntersectionArcs, trace_intersection};
