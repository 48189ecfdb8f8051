//! Implicitization: equations of parametric forms (§2 of the paper).

mod beyond;
mod characteristic;
mod conjugate;
mod eliminant;
mod elliptic;
mod enclosure;
mod expansion;
mod fibre;
mod harmonic;
mod identity;
mod image;
mod inverse;
mod isolated;
#[cfg(test)]
mod isolated_laws;
mod isolated_point;
mod map;
mod pair;
mod patch;
mod polar;
mod proper;
mod reached;
mod residue_expansion;
mod resultant;
mod run;
mod space_curve;
mod summed;
mod symmetric;
mod theorem2;
mod tracing;
mod vanishing;
mod views;

pub use beyond::{PointBeyond, point_beyond};
pub use harmonic::SquaredHarmonics;
pub(crate) use identity::lies_on;
pub use image::{Coverage, RealImage, real_image};
pub(crate) use image::{coverage, real_counts, traced_once};
pub use isolated_point::{Isolated, IsolatedPoint};
pub use patch::{SurfaceEquation, implicitize_patch};
pub use polar::{
    PolarFactor, PolarInverse, PolarPatch, PolarPlane, PolarSpaceCurve, PolarSurface, Role,
    polar_patch, polar_plane, polar_space_curve,
};
pub use resultant::{EquationProof, PlaneEquation, implicitize_plane};
pub(crate) use run::Run;
pub use space_curve::{SpaceCurveEquations, implicitize_space_curve};
pub use theorem2::SquaredForm;
pub(crate) use tracing::tracing_index;

// Only the tests and benches of this project use these; they are no part of the public interface.
#[doc(hidden)]
pub use theorem2::{Parts, parity_sums, square_away};
