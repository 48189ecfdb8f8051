//! Lemmas 2 and 7: two homogeneous parts.

use super::forms::{LemmaForm, negative, reduced};
use super::{Rule, Solved};
use crate::parametrize::cells::Place;
use crate::parametrize::expression::Expression;

/// Eqs. (16)–(19): `top R + low = 0` with R = r^k.
///
/// R = −low/top is finite where top ≠ 0, and for even k r is real where −low·top ≥ 0.
pub(super) fn lemma_2<F: LemmaForm>([top, low]: [&F; 2]) -> Solved<F> {
    let (top, minus_low) = (top.on_unit_vectors(), negative(&low.on_unit_vectors()));
    let [numerator, denominator] = reduced([minus_low.clone(), top.clone()]);
    Solved {
        roots: vec![(Expression::form(numerator).over(denominator), Rule::Linear)],
        critical: vec![top, minus_low],
    }
}

/// The sign of the root; `None` where it is not finite.
pub(super) fn sign(at: &Place) -> Option<i8> {
    let [top, minus_low] = at.signs[..] else {
        return None;
    };
    (top != 0).then_some(minus_low * top)
}
