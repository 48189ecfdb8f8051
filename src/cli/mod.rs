//! The command line: a file per verb; what all verbs share is here.

mod arcs;
mod arguments;
mod check;
mod check_arguments;
mod check_plot;
mod describe;
mod fit;
mod implicitize;
mod input;
mod inspect;
mod inspect_plot;
mod inspect_rows;
mod mesh;
mod numbers;
mod output;
mod paper;
mod paper_figures;
mod parametrize;
mod plot;
mod plot_space;
mod sample;
mod session;
mod vectors;

use std::process::ExitCode;

use clap::Parser;
use stellate::error::Error;

use arguments::{Arguments, Verb};
use session::Session;

/// Exit codes of the contract.
const ANSWER_IS_NO: u8 = 1;
const WRONG_INPUT: u8 = 2;
const LIMIT_REACHED: u8 = 3;

/// Parses the arguments, runs the verb, reports the one error there may be.
pub(crate) fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // `--help` and `--version` are no errors.
            let code = if error.use_stderr() { WRONG_INPUT } else { 0 };
            let _ = error.print();
            return ExitCode::from(code);
        }
    };
    let outcome = Session::new(arguments.common).and_then(|mut session| {
        match arguments.verb {
            Verb::Describe(verb) => describe::run(&verb, &mut session),
            Verb::Implicitize(verb) => implicitize::run(&verb, &mut session),
            Verb::Parametrize(verb) => parametrize::run(&verb, &mut session),
            Verb::Fit(verb) => fit::run(&verb, &mut session),
            Verb::Sample(verb) => sample::run(&verb, &mut session),
            Verb::Inspect(verb) => inspect::run(&verb, &mut session),
            Verb::Mesh(verb) => mesh::run(&verb, &mut session),
            Verb::Plot(verb) => plot::run(&verb, &mut session),
            Verb::Check(verb) => check::run(&verb, &mut session),
            Verb::Vectors(verb) => vectors::run(&verb, &mut session),
            Verb::Paper(verb) => paper::run(&verb, &mut session),
        }?;
        session.finish()?;
        Ok(session.answer_is_no)
    });
    match outcome {
        Ok(false) => ExitCode::SUCCESS,
        Ok(true) => ExitCode::from(ANSWER_IS_NO),
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            session::report(&format!("stellate: {error}"));
            ExitCode::from(match error {
                Error::Limit { .. } => LIMIT_REACHED,
                _ => WRONG_INPUT,
            })
        }
    }
}

/// Whoever read our output has read enough (`stellate … | head`).
fn is_broken_pipe(error: &Error) -> bool {
    matches!(error, Error::Io { source, .. } if source.kind() == std::io::ErrorKind::BrokenPipe)
}
