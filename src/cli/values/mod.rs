//! Readers of the values of options, one for every kind of value. If a value is wrong, a reader says in plain words what would
//! be right; [`super::usage`] writes the option and the value before that.

mod angle;
mod list;
mod number;
mod time;

pub(crate) use angle::{Angle, angle, degrees, range, view};
pub(crate) use list::{
    center, column, columns, frame, marked_point, point, space_window, tolerance,
};
pub(crate) use number::{positive, whole, within};
pub(crate) use time::time;

/// A value, or the message for a text that is not one.
pub(crate) type Read<T> = std::result::Result<T, String>;
