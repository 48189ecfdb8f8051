//! The native part of the Python package `stellate`. It takes and returns texts; the package makes Python objects of them.

mod options;
mod run;

use std::ffi::OsString;
use std::panic::{AssertUnwindSafe, catch_unwind};

use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt, PyOSError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::error::Error;

create_exception!(_native, StellateError, PyException);
create_exception!(_native, InputError, StellateError);
create_exception!(_native, LimitReached, StellateError);
create_exception!(_native, InternalError, StellateError);

/// The exception for an error of the library, with the same message.
fn exception(error: &Error) -> PyErr {
    let message = error.to_string();
    match error {
        Error::Limit { .. } => LimitReached::new_err(message),
        Error::Internal { .. } => InternalError::new_err(message),
        Error::Interrupted => PyKeyboardInterrupt::new_err(message),
        Error::Io { .. } => PyOSError::new_err(message),
        _ => InputError::new_err(message),
    }
}

/// Runs a verb on forms, each a text or a path, or the text of a document or table with a name for messages. `options` is a JSON
/// object; `data` is the table that the verb reads besides. The result is what the program would write. Other Python threads run
/// meanwhile.
#[pyfunction]
fn call<'py>(
    python: Python<'py>,
    verb: &str,
    forms: Vec<(String, Option<String>)>,
    options: &str,
    data: &[u8],
) -> PyResult<Bound<'py, PyBytes>> {
    let run = AssertUnwindSafe(|| run::run(verb, &forms, options, data));
    // An invariant that does not hold is a panic; nothing that was being changed is used after it.
    let result = python.detach(|| {
        catch_unwind(run).unwrap_or_else(|payload| Err(Error::from_panic(payload.as_ref(), None)))
    });
    result
        .map(|bytes| PyBytes::new(python, &bytes))
        .map_err(|error| exception(&error))
}

/// Runs the program with these arguments, of which the first is its name, and returns its exit code.
#[pyfunction]
fn main(python: Python<'_>, arguments: Vec<OsString>) -> u8 {
    python.detach(|| crate::cli::main(arguments))
}

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let python = module.py();
    module.add("StellateError", python.get_type::<StellateError>())?;
    module.add("InputError", python.get_type::<InputError>())?;
    module.add("LimitReached", python.get_type::<LimitReached>())?;
    module.add("InternalError", python.get_type::<InternalError>())?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_function(wrap_pyfunction!(call, module)?)?;
    module.add_function(wrap_pyfunction!(main, module)?)
}
