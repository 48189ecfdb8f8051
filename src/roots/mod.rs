//! Real roots of polynomials in one variable.
//!
//! A [`RealRoot`] is an exact object: a polynomial and an interval that holds one root of it. Its enclosure can be narrowed as far
//! as wanted, and its nearest double is proved. Bounded arithmetic (`bounded`) finds most roots; exact arithmetic (`isolate`)
//! finds the others.

mod all_roots;
mod bounded;
mod distinct;
mod isolate;
mod pair;
mod real_root;
mod root_sign;
mod sign_changes;

pub(crate) use all_roots::real_roots;
#[cfg(test)]
pub(crate) use bounded::Draw;
pub(crate) use bounded::{
    BoundedRoot, Coefficients, FOR_DOUBLES, ScaledBall, UnitBall, UnitBalls, Unproved, roots_of,
    rotations,
};
pub(crate) use distinct::{between, disjoint, distinct_roots, strictly_between};
pub(crate) use isolate::root_bound_exponent;
pub use real_root::RealRoot;
pub(crate) use root_sign::constant_sign;
pub(crate) use sign_changes::sign_changes;
