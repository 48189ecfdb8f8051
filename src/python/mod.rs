//! The native part of the Python package `stellate`. It takes and returns texts and columns of numbers; the package makes Python
//! objects of them.

mod contour;
mod exceptions;
mod inspector;
mod options;
mod radius;
mod run;
mod watch;

use std::ffi::OsString;

use pyo3::prelude::*;
use pyo3::types::PyBytes;

use self::exceptions::{InputError, InternalError, LimitReached, StellateError};
use self::options::Options;
use self::watch::with_options;

/// What a verb answers: the document, the remarks about it, the parts of it that are missing because a limit was reached, and the
/// proof if one was asked for.
type Answer<'py> = (
    Bound<'py, PyBytes>,
    Vec<String>,
    Option<String>,
    Option<String>,
);

/// Runs a verb on forms: each a text or a path, or the text of a document or table with a name for messages; and the options of how
/// it is read. `options` is a JSON object; `data` is the table that the verb reads besides. The result is what the program would
/// write. Other Python threads run meanwhile.
#[pyfunction]
fn call<'py>(
    python: Python<'py>,
    verb: String,
    forms: Vec<(String, Option<String>, String)>,
    options: &str,
    data: Vec<u8>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Answer<'py>> {
    let run = move |options: Options, work| run::run(&verb, &forms, &options, data, work);
    let (found, notes) = with_options(python, progress, options, run)?;
    let document = PyBytes::new(python, &found.document);
    Ok((document, notes, found.missing, found.proof))
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
    module.add_class::<inspector::Inspector>()?;
    module.add_class::<radius::Radius>()?;
    module.add_function(wrap_pyfunction!(call, module)?)?;
    module.add_function(wrap_pyfunction!(main, module)?)
}
