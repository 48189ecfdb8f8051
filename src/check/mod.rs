//! Comparisons of float programs with exact results: how many digits of coefficients, points and radii are right, and which
//! usual mistakes explain the others.
//!
//! The numbers of a float program are doubles, taken bit for bit, and the reference is exact: the values that they are compared
//! with are rational numbers, or are enclosed as closely as the answer requires. Relative distances, pass marks and the choice
//! of the common factor are decided in exact arithmetic. Digits and ulps are then rounded for people.

mod coefficients;
mod comparison;
mod condition;
mod deviation;
mod enclosed_ray;
mod float_theorem2;
mod ladder;
mod misplaced;
mod mistakes;
mod nearest;
mod points;
mod radii;
mod reference;
mod scale;
mod series;
mod spherical;
mod tables;
mod unexplained;
mod vectors;

pub use coefficients::compare_coefficients;
pub use comparison::{Comparison, Diagnosis, GivenNumber, Residual, Row};
pub(crate) use deviation::DOUBLE_DIGITS;
pub use deviation::Deviation;
#[cfg(feature = "pictures")]
pub(crate) use deviation::MOST_DIGITS;
pub use ladder::{DigitsKept, Rung, ladder};
pub use points::GivenPoint;
pub use radii::GivenRadius;
pub use reference::Reference;
pub use scale::{Meaning, Scale};
pub use spherical::{GivenHarmonics, GivenSpaceRadius, SphericalReference};
pub use vectors::{
    CoefficientVector, InputsOf, PointVector, RadiusVector, TestVectors, VectorInput, test_vectors,
};

// These are for the tests and benches of this project, and not a part of what the library promises.
#[doc(hidden)]
pub use float_theorem2::FloatTheorem2;
#[doc(hidden)]
pub use series::SeriesValues;
#[doc(hidden)]
pub use tables::{read_points_csv, read_radii_csv, read_space_radii_csv};
