//! The exceptions of the package, with the messages of the program.

use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt, PyOSError};
use pyo3::prelude::*;

use crate::error::Error;

// They are pickled by the name of the package, from which they can be imported.
create_exception!(stellate, StellateError, PyException);
create_exception!(stellate, InputError, StellateError);
create_exception!(stellate, LimitReached, StellateError);
create_exception!(stellate, InternalError, StellateError);

/// The exception for an error of the library, with the same message.
pub(super) fn exception(error: &Error) -> PyErr {
    let message = error.to_string();
    match error {
        Error::Limit { .. } => LimitReached::new_err(message),
        Error::Internal { .. } => InternalError::new_err(message),
        Error::Interrupted => PyKeyboardInterrupt::new_err(message),
        // With the number of the error, Python makes a FileNotFoundError and the like of it.
        Error::Io { path, source } => match source.raw_os_error() {
            Some(number) => {
                PyOSError::new_err((number, error.reason(), path.as_os_str().to_owned()))
            }
            None => PyOSError::new_err(message),
        },
        _ => InputError::new_err(message),
    }
}
