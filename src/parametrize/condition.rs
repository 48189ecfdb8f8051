//! Where a formula of Lemmas 7 to 10 holds, as an exact statement about signs of forms.

use super::expression::Expression;
use crate::poly::TernaryForm;

/// A statement about a direction (θ, φ).
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// All of these hold; with none of them, always.
    All(Vec<Self>),
    /// One of these holds.
    Any(Vec<Self>),
    /// This does not hold.
    Not(Box<Self>),
    /// How a form in (sin φ cos θ, sin φ sin θ, cos φ) compares with 0.
    Form(TernaryForm, Relation),
    /// The value of the formula, which is real where the conditions beside it hold, is not negative.
    NotNegative(Expression<TernaryForm>),
}

/// How a number compares with 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// = 0
    Zero,
    /// ≠ 0
    NotZero,
    /// > 0
    Positive,
    /// < 0
    Negative,
    /// ≥ 0
    AtLeastZero,
    /// ≤ 0
    AtMostZero,
}

impl Condition {
    /// That a form compares so with 0.
    pub(super) fn form(form: &TernaryForm, relation: Relation) -> Self {
        Self::Form(form.clone(), relation)
    }
}
