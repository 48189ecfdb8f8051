//! Superquadrics of the plane and of space (Examples 6 and 10), with rational exponents.

mod plane;
mod roots;
mod space;

pub use plane::Superquadric;
pub use space::SpaceSuperquadric;
