//! Closed forms of r(θ) for up to four equally spaced homogeneous parts (Lemmas 2–4), and the exact
//! ranges in which they are real.

mod forms;
mod lemma2;
mod lemma3;
mod lemma4;

use malachite::base::num::arithmetic::traits::Parity;

use super::angle::AngleRange;
use super::cells::{Cells, Heading};
use super::expression::Expression;

pub(super) use lemma2::lemma_2;
pub(super) use lemma3::lemma_3;
pub(super) use lemma4::lemma_4;

/// One branch r(θ) of a curve in closed form.
#[derive(Clone, Debug)]
pub(super) struct ClosedBranch {
    /// r(θ).
    pub(super) radius: Expression,
    /// Where r is real and finite, of either sign.
    pub(super) real: Vec<AngleRange>,
    /// Where r > 0.
    pub(super) positive: Vec<AngleRange>,
}

/// The branches r of one root R = r^k, given the exact sign of the root in every direction (`None`
/// where it is not real or not finite): one for odd k, two of opposite sign for even k.
fn branches_of(
    root: Expression,
    k: u32,
    cells: &Cells,
    sign: impl Fn(&Heading) -> Option<i8>,
) -> Vec<ClosedBranch> {
    let radius = root.root(k);
    let positive = cells.ranges(|h| sign(h) == Some(1));
    if k.odd() {
        return vec![ClosedBranch {
            radius,
            real: cells.ranges(|h| sign(h).is_some()),
            positive,
        }];
    }
    let real = cells.ranges(|h| sign(h).is_some_and(|v| v >= 0));
    let negative = ClosedBranch {
        radius: radius.clone().negated(),
        real: real.clone(),
        positive: Vec::new(),
    };
    vec![
        ClosedBranch {
            radius,
            real,
            positive,
        },
        negative,
    ]
}
