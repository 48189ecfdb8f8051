//! Comparisons and inspections with a proof.

#[path = "../common/mod.rs"]
mod common;

mod check;
mod check_bad_input;
mod check_chance;
mod check_cli;
mod check_mistakes;
mod check_numpy;
mod check_tables;
mod inspect;
mod inspect_cli;
mod inspect_feet;
mod inspect_forms;
mod inspect_many;
mod inspect_zones;
mod topology;
