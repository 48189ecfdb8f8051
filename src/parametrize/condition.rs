//! Conditions under which a formula of Lemmas 7 to 10 holds, as exact statements about signs of forms.

use super::expression::Expression;
use crate::poly::{TernaryForm, integer_sign};

/// A statement about a direction (θ, φ).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Condition {
    /// All of these conditions hold. An empty list always holds.
    All(Vec<Self>),
    /// One of these conditions holds. An empty list never holds.
    Any(Vec<Self>),
    /// This condition does not hold.
    Not(Box<Self>),
    /// A form in (sin φ cos θ, sin φ sin θ, cos φ) has this relation to 0.
    Form(TernaryForm, Relation),
    /// The value of the formula is not negative. The other conditions ensure that the value is real.
    NotNegative(Expression<TernaryForm>),
}

/// A relation of a number to 0.
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
    /// The condition that a form has this relation to 0. For a constant form, and for the form 0 of any degree, it is decided at
    /// once.
    pub(super) fn form(form: &TernaryForm, relation: Relation) -> Self {
        if form.degree() > 0 && !form.is_zero() {
            return Self::Form(form.clone(), relation);
        }
        let sign = form.terms().next().map_or(0, |(_, c)| integer_sign(c));
        match relation.holds(sign) {
            true => Self::All(Vec::new()),
            false => Self::Any(Vec::new()),
        }
    }

    /// The condition that all of these hold; conditions that always hold are left out.
    pub(super) fn all(parts: impl IntoIterator<Item = Self>) -> Self {
        let mut all = Vec::new();
        for part in parts {
            match part {
                Self::All(inner) => all.extend(inner),
                Self::Any(inner) if inner.is_empty() => return Self::Any(inner),
                other => all.push(other),
            }
        }
        match <[Self; 1]>::try_from(all) {
            Ok([only]) => only,
            Err(all) => Self::All(all),
        }
    }

    /// The condition that one of these holds; conditions that never hold are left out.
    pub(super) fn any(parts: impl IntoIterator<Item = Self>) -> Self {
        let mut any = Vec::new();
        for part in parts {
            match part {
                Self::Any(inner) => any.extend(inner),
                Self::All(inner) if inner.is_empty() => return Self::All(inner),
                other => any.push(other),
            }
        }
        match <[Self; 1]>::try_from(any) {
            Ok([only]) => only,
            Err(any) => Self::Any(any),
        }
    }

    /// The condition that this one does not hold.
    pub(super) fn negated(self) -> Self {
        match self {
            Self::All(inner) if inner.is_empty() => Self::Any(inner),
            Self::Any(inner) if inner.is_empty() => Self::All(inner),
            other => Self::Not(Box::new(other)),
        }
    }
}

impl Relation {
    /// Whether a number of this sign has this relation to 0.
    fn holds(self, sign: i8) -> bool {
        match self {
            Self::Zero => sign == 0,
            Self::NotZero => sign != 0,
            Self::Positive => sign > 0,
            Self::Negative => sign < 0,
            Self::AtLeastZero => sign >= 0,
            Self::AtMostZero => sign <= 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::language::{Numbers, parse_form};
    use crate::limits::Limits;
    use crate::parametrize::parametrize_surface;
    use crate::sample::{IntegerVector, SpaceDirection};
    use crate::shape::Form;
    use malachite::Integer;

    /// Whether a condition holds in the direction of a vector; `None` if the value of a formula is too near to 0 to know its
    /// sign.
    fn holds(condition: &Condition, vector: &[Integer; 3], unit: [f64; 3]) -> Option<bool> {
        let each = |parts: &[Condition]| -> Vec<Option<bool>> {
            parts.iter().map(|part| holds(part, vector, unit)).collect()
        };
        match condition {
            Condition::All(parts) => {
                let parts = each(parts);
                match parts.contains(&Some(false)) {
                    true => Some(false),
                    false => parts
                        .into_iter()
                        .try_fold(true, |all, part| Some(all && part?)),
                }
            }
            Condition::Any(parts) => {
                let parts = each(parts);
                match parts.contains(&Some(true)) {
                    true => Some(true),
                    false => parts
                        .into_iter()
                        .try_fold(false, |any, part| Some(any || part?)),
                }
            }
            Condition::Not(part) => holds(part, vector, unit).map(|holds| !holds),
            Condition::Form(form, relation) => {
                Some(relation.holds(integer_sign(&form.evaluate(vector))))
            }
            Condition::NotNegative(expression) => {
                let value = expression.approximate(unit);
                // If the value is not real, another condition fails.
                (value.is_nan() || value.abs() > 1e-9).then_some(value >= 0.0)
            }
        }
    }

    #[test]
    fn conditions_hold_exactly_where_branches_are_real() {
        let (mut real, mut not_real) = (0, 0);
        for text in [
            "x^2 + y^2 + z^2 = 4x - 3",
            "x^3 + z^3 + 3x*y + y - 1 + x^2",
            "x^3 + y^3 + z^3 - 3x*y*z - 1 + x*z",
            "x^4 + y^4 + z^4 + 3x^2*y - x*z + z - 1",
            "x^4 + 2y^4 - z^4 + x*y - 3",
            "x^4 + y^4 + z^4 - 5x^2*z + 3x*y + z - 1/9",
            "x^4 + y^4 + 2z^4 + x^2 - 1 - 3y^2",
            "x^6 + y^6 + z^6 - 3x^2*y^2 + z^2 - 1/9",
            "x^8 - y^8 + z^8 - 3x^4*y^2 + x^2*z^2 + y^2 - 1/9",
            "((x^2 + x)^2 - 2*(x^2 + x))*(y + 2z) + x + z",
            "((x - y)^2 + x - y)^2 - 2*((x - y)^2 + x - y) + 1/9 + 0*z",
        ] {
            let form = parse_form(text, "<form>", Numbers::Exact).unwrap();
            let Form::Surface(surface) = form else {
                panic!("{text} is a surface")
            };
            let found = parametrize_surface(&surface, &Limits::none()).unwrap();
            for direction in SpaceDirection::fibonacci(60) {
                let answer = found.in_direction(&direction);
                let (vector, w) = direction.over_common_denominator();
                let unit = vector.each_ref().map(|v| {
                    let component = Rational::from_integers(v.clone(), w.clone());
                    component.unwrap().to_f64()
                });
                for (branch, sign) in found.branches.iter().zip(&answer.branches) {
                    let Some(holds) = holds(&branch.real_where, &vector, unit) else {
                        continue;
                    };
                    assert_eq!(holds, sign.is_some(), "{text}: {:?}", branch.condition);
                    real += usize::from(holds);
                    not_real += usize::from(!holds);
                    // The formula is real where its condition holds. Some formulas hold wherever they are real.
                    let value = branch.radius.approximate(unit);
                    assert!(!holds || !value.is_nan(), "{text}");
                    assert!(
                        holds || !branch.holds_where_real || value.is_nan(),
                        "{text}"
                    );
                }
            }
        }
        assert!(real > 300 && not_real > 300, "{real} and {not_real}");
    }
}
