//! The command line. Every verb has its own file, and this file has what all verbs share.

mod about;
mod arguments;
mod check;
mod check_arguments;
mod describe;
mod fit;
mod fit_mesh;
mod flags;
mod implicitize;
mod input;
mod inspect;
mod inspect_arguments;
mod mesh;
mod output;
mod paper;
mod paper_figures;
mod parametrize;
mod plot;
mod sample;
mod session;
mod usage;
mod values;
mod vectors;
mod verify;
mod watch;

use std::ffi::OsString;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use stellate::document::Format;
use stellate::error::{Error, Result};

use arguments::Verb;
use session::Session;
use usage::Refusal;

/// The exit codes besides 0, as the help explains them.
const ANSWER_IS_NO: u8 = 1;
const WRONG_INPUT: u8 = 2;
const LIMIT_REACHED: u8 = 3;
const CONTRADICTION: u8 = 4;

/// Parses the arguments, of which the first is the name of the program, runs the verb, and reports its error if there is one. Returns
/// the exit code.
pub(crate) fn main(words: Vec<OsString>) -> u8 {
    let arguments = match usage::parsed(&words) {
        Ok(arguments) => arguments,
        Err(Refusal::Wrong(message, in_json)) => return reported(&message, WRONG_INPUT, in_json),
        Err(Refusal::Shown(text)) => {
            let _ = text.print();
            return 0;
        }
    };
    let in_json = arguments.common.format == Some(Format::Json);
    let outcome = guarded(|| {
        let proof = arguments.verb.proof().map(Path::to_owned);
        let mut session = Session::new(arguments.common, proof)?;
        let done = match arguments.verb {
            Verb::Describe(verb) => describe::run(&verb, &session),
            Verb::Implicitize(verb) => implicitize::run(&verb, &session),
            Verb::Parametrize(verb) => parametrize::run(&verb, &session),
            Verb::Fit(verb) => fit::run(&verb, &session),
            Verb::Sample(verb) => sample::run(&verb, &session),
            Verb::Inspect(verb) => inspect::run(&verb, &mut session),
            Verb::Mesh(verb) => mesh::run(&verb, &session),
            Verb::Plot(verb) => plot::run(&verb, &session),
            Verb::Check(verb) => check::run(&verb, &mut session),
            Verb::Vectors(verb) => vectors::run(&verb, &session),
            Verb::Paper(verb) => paper::run(&verb, &mut session),
            Verb::Verify(verb) => verify::run(&verb, &mut session),
            Verb::Completions(verb) => about::completions(&verb, &session),
            Verb::Schema(verb) => about::schema(&verb, &session),
            Verb::Man => about::manual(&session),
        };
        done.map_err(|error| session.explained(error))?;
        session.finish();
        session.report_missing()?;
        Ok(session.answer_is_no)
    });
    match outcome {
        Ok(false) => 0,
        Ok(true) => ANSWER_IS_NO,
        Err(error) if is_broken_pipe(&error) => 0,
        Err(error) => {
            let code = match error {
                Error::Limit { .. } => LIMIT_REACHED,
                Error::Internal { .. } => CONTRADICTION,
                _ => WRONG_INPUT,
            };
            reported(&error.to_string(), code, in_json)
        }
    }
}

/// Reports an error, and returns its exit code.
fn reported(message: &str, code: u8, in_json: bool) -> u8 {
    watch::report(&if in_json {
        serde_json::json!({ "error": { "exit_code": code, "message": message } }).to_string()
    } else {
        format!("stellate: {message}")
    });
    code
}

/// Runs the work of a verb; a broken invariant anywhere in it, on any thread, becomes the one error that is reported.
fn guarded<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
    static FIRST_PLACE: Mutex<Option<String>> = Mutex::new(None);
    let first_place = || FIRST_PLACE.lock().unwrap_or_else(PoisonError::into_inner);
    // This hook replaces the message of the standard library, which has more than one line.
    let usual = std::panic::take_hook();
    let is_traced = std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value != "0");
    std::panic::set_hook(Box::new(move |info| {
        if is_traced {
            usual(info);
        }
        first_place().get_or_insert_with(|| {
            info.location()
                .map_or_else(String::new, ToString::to_string)
        });
    }));
    // This is safe, because nothing that the work was changing is used after a panic.
    let outcome = catch_unwind(AssertUnwindSafe(work));
    outcome.unwrap_or_else(|payload| Err(Error::from_panic(payload.as_ref(), first_place().take())))
}

/// Whether the reader of the output has stopped reading (`stellate … | head`), which is no failure.
fn is_broken_pipe(error: &Error) -> bool {
    matches!(error, Error::Io { source, .. } if source.kind() == std::io::ErrorKind::BrokenPipe)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rayon::prelude::*;

    #[test]
    fn a_panic_on_any_thread_is_one_internal_error() {
        let work = || {
            let sum: u32 = (0..100u32).into_par_iter().map(|k| k / (k - k % 100)).sum();
            Ok(sum)
        };
        let error = guarded(work).expect_err("a division by 0");
        let text = error.to_string();
        assert!(
            text.starts_with("internal contradiction in src/cli/mod.rs:"),
            "{text}"
        );
        assert!(text.contains("divide by zero"), "{text}");
        assert_eq!(guarded(|| Ok(1)).ok(), Some(1));
    }
}
