//! The paper: its theorems and examples, and the verb that reports them.

#[path = "../common/mod.rs"]
mod common;

mod compare;
mod report;
mod theorems;
mod verb;
