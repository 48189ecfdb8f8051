//! From radii to implicit forms and back, exactly.

#[path = "../common/mod.rs"]
mod common;

mod closed_forms;
mod factor;
mod fit;
mod implicitize_classics;
mod implicitize_laws;
mod laws;
mod lemma6;
mod oracles;
mod rational;
mod theorem7;
