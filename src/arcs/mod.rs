//! Certified arcs of the curve in which two surfaces meet.

mod cover;
mod follow;
mod tube;

pub use cover::{ArcEnd, ArcOptions, ArcPoint, CurveArc, IntersectionArcs, trace_intersection};
