//! Proofs of what drawn commands claim: the verifier accepts them, and no claim that is always proved lacks a witness.

use stellate::proof::check;
use tempfile::TempDir;

use super::common::proofs::{drawn_command, proof_of};
use super::common::random::SplitMix;
use super::draw::Draw;
use super::harness::Outcome;

/// Claims that have a witness whatever was drawn.
const ALWAYS_PROVED: [&str; 6] = [
    "root-count",
    "series-equation",
    "identity",
    "factorization",
    "side",
    "positive-radius",
];

pub(crate) fn of_commands(draw: &mut Draw) -> Outcome {
    let folder = TempDir::new().unwrap();
    let arguments = drawn_command(&mut SplitMix(draw.word()));
    draw.input = format!("stellate {arguments:?} --proof proof.json");
    let text = proof_of(&arguments, folder.path());
    let report = check(&text, false).unwrap();
    assert!(report.holds(), "{report}");
    assert!(report.claims > 0, "nothing is claimed");
    for name in ALWAYS_PROVED {
        let count = report.counts.get(name).copied().unwrap_or_default();
        assert_eq!(count.without_witness, 0, "{name} without a witness");
    }
    Outcome::Checked
}
