//! The command line. Every verb has its own file, and this file has what all verbs share. It is in the library so that the program and
//! the Python package have it from there, and so that it is compiled once.

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
use std::path::Path;
use std::sync::Mutex;

use stellate::document::Format;
use stellate::error::{Error, Result};

use arguments::{Arguments, Verb};
use session::Session;
use usage::Refusal;

/// The exit codes besides 0, as the help explains them.
const ANSWER_IS_NO: u8 = 1;
const WRONG_INPUT: u8 = 2;
const LIMIT_REACHED: u8 = 3;
const CONTRADICTION: u8 = 4;

/// Parses the arguments, of which the first is the name of the program, runs the verb, and reports its error if there is one. Returns
/// the exit code.
#[must_use]
pub fn main(words: Vec<OsString>) -> u8 {
    let arguments = match usage::parsed(&words) {
        Ok(arguments) => arguments,
        Err(Refusal::Wrong(message, in_json)) => return reported(&message, WRONG_INPUT, in_json),
        Err(Refusal::Shown(text)) => {
            let _ = text.print();
            return 0;
        }
    };
    let in_json = arguments.common.format == Some(Format::Json);
    end_at_panics(in_json);
    match run(arguments) {
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

/// Runs the verb. Returns whether the answer to its question is no.
fn run(arguments: Arguments) -> Result<bool> {
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
}

/// Reports an error, and returns its exit code.
fn reported(message: &str, code: u8, in_json: bool) -> u8 {
    watch::report(&line(message, code, in_json));
    code
}

/// The line that reports an error.
fn line(message: &str, code: u8, in_json: bool) -> String {
    if in_json {
        serde_json::json!({ "error": { "exit_code": code, "message": message } }).to_string()
    } else {
        format!("stellate: {message}")
    }
}

/// From here on, a broken invariant on any thread is the one error that is reported, and ends the process. The unfinished file is
/// removed.
pub fn end_at_panics(in_json: bool) {
    static ENDING: Mutex<()> = Mutex::new(());
    let usual = std::panic::take_hook();
    let is_traced = std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value != "0");
    std::panic::set_hook(Box::new(move |info| {
        // Another thread that panics meanwhile waits here until the process has ended.
        let _first = ENDING.lock();
        if is_traced {
            usual(info);
        }
        let place = info.location().map(ToString::to_string);
        let error = Error::from_panic(info.payload(), place);
        let line = line(&error.to_string(), CONTRADICTION, in_json);
        watch::end(&line, CONTRADICTION)
    }));
}

/// Whether the reader of the output has stopped reading (`stellate … | head`), which is no failure.
fn is_broken_pipe(error: &Error) -> bool {
    matches!(error, Error::Io { source, .. } if source.kind() == std::io::ErrorKind::BrokenPipe)
}
