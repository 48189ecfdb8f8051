//! The exceptions of the package, with the messages of the program.

use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt, PyOSError};
use pyo3::prelude::*;

use crate::error::Error;

create_exception!(_native, StellateError, PyException);
create_exception!(_native, InputError, StellateError);
create_exception!(_native, LimitReached, StellateError);
create_exception!(_native, InternalError, StellateError);

/// The exception for an error of the library, with the same message.
pub(super) fn exception(error: &Error) -> PyErr {
    let message = error.to_string();
    match error {
        Error::Limit { .. } => LimitReached::new_err(message),
        Error::Internal { .. } => InternalError::new_err(message),
        Error::Interrupted => PyKeyboardInterrupt::new_err(message),
        Error::Io { .. } => PyOSError::new_err(message),
        _ => InputError::new_err(message),
    }
}
