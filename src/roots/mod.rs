//! Real roots of polynomials: isolated, as exact objects, and as doubles with a proof.

mod all_roots;
mod bounded;
mod isolate;
mod pair;
mod real_root;
mod root_sign;
mod sign_changes;

pub(crate) use all_roots::{real_roots, sort_distinct};
#[cfg(test)]
pub(crate) use bounded::Draw;
pub(crate) use bounded::{
    BoundedRoot, Coefficients, FOR_DOUBLES, ScaledBall, UnitBall, UnitBalls, Unproved, roots_of,
    rotations,
};
pub use real_root::RealRoot;
pub(crate) use root_sign::constant_sign;
