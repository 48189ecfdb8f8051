//! The command line as a whole, and the texts that it reads and writes.

#[path = "../common/mod.rs"]
mod common;

mod bad_input;
mod centered_surface;
mod centers;
mod cli;
mod cli_session;
mod column_files;
mod documents;
mod elliptic;
mod feet;
mod form_mistakes;
mod harmonic_signs;
mod harmonic_verbs;
mod harmonics;
mod hostile_proofs;
mod implicitize_cli;
mod inspect_options;
mod language;
mod language_parameters;
mod least_squares;
mod limits;
mod main_job;
mod measured;
mod mutated_proofs;
mod option_mistakes;
mod option_spellings;
mod outlines;
mod panics;
mod parametric_forms;
mod point_files;
mod polar_curves;
mod proofs;
mod python;
mod read_back;
mod spellings;
mod table_columns;
mod terminal;
mod topology;
mod typed;
mod verbs;
mod written_texts;
