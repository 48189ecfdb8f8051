//! Fuzzing: every reader on mutated files. None panics, and the program ends with a documented exit code.
//!
//! By default every reader has a few hundred inputs from a fixed seed. With `STELLATE_FUZZ=minutes` fresh ones are drawn until
//! the time is over; `STELLATE_FUZZ_SEED=n` begins at a seed that was printed, and `STELLATE_FUZZ_KIND=name` has one reader
//! only. An input is determined by its reader and its seed.

#![expect(clippy::unwrap_used, reason = "a case fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    clippy::float_cmp,
    reason = "draws are converted to small numbers, and doubles are compared bit by bit"
)]

#[path = "campaign/draw.rs"]
mod draw;
#[path = "campaign/harness.rs"]
mod harness;
#[path = "fuzz/mutate.rs"]
mod mutate;
#[path = "fuzz/outlines.rs"]
mod outlines;
#[path = "fuzz/pictures.rs"]
mod pictures;
#[path = "fuzz/program.rs"]
mod program;
#[path = "fuzz/readers.rs"]
mod readers;
#[path = "fuzz/seeds.rs"]
mod seeds;

mod common;

use harness::{Kind, Weight, campaign};

/// All readers, with how many inputs each has by default.
fn kinds() -> Vec<Kind> {
    use Weight::{Cheap, Heavy};
    let mut all = vec![
        Kind::new("language", Cheap, 300, readers::language),
        Kind::new("documents", Cheap, 200, readers::documents),
        Kind::new("coefficients", Cheap, 200, readers::coefficients),
        Kind::new("measurements", Cheap, 200, readers::measurements),
        Kind::new("numbers", Cheap, 300, readers::numbers),
        Kind::new("outlines", Cheap, 100, readers::outlines),
        Kind::new("pictures", Cheap, 60, pictures::pictures),
        Kind::new("program", Heavy, 8, program::program),
    ];
    all.extend(outlines::KINDS.map(|(name, run)| Kind::new(name, Cheap, 500, run)));
    #[cfg(feature = "more-images")]
    all.extend(outlines::MORE_KINDS.map(|(name, run)| Kind::new(name, Cheap, 500, run)));
    all
}

#[test]
fn no_reader_panics() {
    campaign("STELLATE_FUZZ", &kinds());
}
