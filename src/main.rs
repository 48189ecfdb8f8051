//! The command-line program: exact conversions between parametric and implicit forms.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::main()
}
