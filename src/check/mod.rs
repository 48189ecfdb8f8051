//! Float implementations against exact: how many digits of coefficients, points and radii are right, and which of the
//! usual mistakes explains what is not.
//!
//! The numbers of a float program are doubles, taken bit for bit, and the reference is exact: what is compared is
//! rational, or enclosed as closely as the answer needs it. Relative distances, pass marks and the choice of the
//! common factor are decided in exact arithmetic; digits and ulps are then rounded for people.

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
pub use vectors::{
    CoefficientVector, InputsOf, PointVector, RadiusVector, TestVectors, VectorInput, test_vectors,
};

// For the tests and benches of this project; no part of what the library promises.
#[doc(hidden)]
pub use float_theorem2::FloatTheorem2;
#[doc(hidden)]
pub use series::SeriesValues;
#[doc(hidden)]
pub use tables::{read_points_csv, read_radii_csv};
