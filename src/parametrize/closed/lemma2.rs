//! Lemmas 2 and 7: closed forms for two homogeneous parts.

use super::forms::{LemmaForm, negative, reduced};
use super::{Rule, Solved};
use crate::error::Invariant;
use crate::parametrize::cells::SignedDirection;
use crate::parametrize::expression::Expression;

/// Eqs. (16)–(19): `top R + low = 0` with R = r^k.
///
/// R = −low/top is finite where top ≠ 0, and for even k r is real where −low·top ≥ 0.
pub(super) fn lemma_2<F: LemmaForm>([top, low]: [&F; 2]) -> Solved<F> {
    let (top, minus_low) = (top.on_unit_vectors(), negative(&low.on_unit_vectors()));
    let [numerator, denominator] = reduced([minus_low.clone(), top.clone()]);
    Solved {
        roots: vec![(Expression::form(numerator).over(denominator), Rule::Linear)],
        critical: Critical { top, minus_low }.into_list(),
    }
}

/// The forms whose signs decide where the root is real, or the signs of these forms in a direction.
pub(super) struct Critical<T> {
    pub(super) top: T,
    pub(super) minus_low: T,
}

impl<T: Clone> Critical<T> {
    fn into_list(self) -> Vec<T> {
        let Self { top, minus_low } = self;
        vec![top, minus_low]
    }

    /// The named values of the list that [`Critical::into_list`] makes.
    pub(super) fn named(list: &[T]) -> Self {
        let [top, minus_low] = <&[T; 2]>::try_from(list)
            .invariant("Lemma 2 has two critical forms")
            .clone();
        Self { top, minus_low }
    }
}

/// The sign of the root; `None` if it is not finite.
pub(super) fn sign(at: &SignedDirection) -> Option<i8> {
    let Critical { top, minus_low } = Critical::named(&at.signs);
    (top != 0).then_some(minus_low * top)
}
