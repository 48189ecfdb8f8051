//! Closed forms of r(θ) for up to five equally spaced homogeneous parts (Lemmas 2–5), and the exact
//! ranges in which they are real.

mod forms;
mod lemma2;
mod lemma3;
mod lemma4;
mod lemma5;

use malachite::base::num::arithmetic::traits::Parity;

use super::angle::AngleRange;
use super::cells::{Cells, Place};
use super::expression::Expression;

pub(super) use forms::{integer_square_part, squarefree_kernel};
pub(super) use lemma2::lemma_2;
pub(super) use lemma3::lemma_3;
pub(super) use lemma4::lemma_4;
pub(super) use lemma5::lemma_5;

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

/// The branches r of one root R = r^k, given the exact sign of the root at every place, with the cells
/// beside a mark (`None` where it is not real or not finite): one for odd k, two of opposite sign for even k.
fn branches_of(
    root: Expression,
    k: u32,
    cells: &Cells,
    sign: impl Fn(&Place, &[&Place]) -> Option<i8>,
) -> Vec<ClosedBranch> {
    let radius = root.root(k);
    let positive = cells.ranges(|at, beside| sign(at, beside) == Some(1));
    if k.odd() {
        return vec![ClosedBranch {
            radius,
            real: cells.ranges(|at, beside| sign(at, beside).is_some()),
            positive,
        }];
    }
    let real = cells.ranges(|at, beside| sign(at, beside).is_some_and(|v| v >= 0));
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
