//! The values of options: every kind is read in one place, and what is wrong with one is said in plain words, with what would
//! be right. [`super::usage`] puts the option and the value before it.

mod angle;
mod list;
mod number;
mod time;

pub(crate) use angle::{Angle, angle, degrees, directions, range, view};
pub(crate) use list::{center, frame, marked_point, point, space_window};
pub(crate) use number::{positive, whole};
pub(crate) use time::time;

/// A value, or what is wrong with its text.
pub(crate) type Read<T> = std::result::Result<T, String>;
