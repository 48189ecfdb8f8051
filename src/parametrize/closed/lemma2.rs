//! Lemma 2: two homogeneous parts.

use super::forms::{negative, on_circle, reduced};
use super::{ClosedBranch, branches_of};
use crate::parametrize::cells::Cells;
use crate::parametrize::expression::Expression;
use crate::poly::BinaryForm;

/// Eqs. (16)–(19): `top R + low = 0` with R = r^k.
///
/// R = −low/top is finite where top ≠ 0, and for even k r is real where −low·top ≥ 0.
pub(in crate::parametrize) fn lemma_2(
    top: &BinaryForm,
    low: &BinaryForm,
    k: u32,
) -> Vec<ClosedBranch> {
    let (top, minus_low) = (on_circle(top), negative(&on_circle(low)));
    let cells = Cells::cut(&[&top, &minus_low]);
    let [numerator, denominator] = reduced([minus_low.clone(), top.clone()]);
    let root = Expression::form(numerator).over(denominator);
    branches_of(root, k, &cells, |at, _| {
        let [top, minus_low] = at.signs[..] else {
            return None;
        };
        (top != 0).then_some(minus_low * top)
    })
}
