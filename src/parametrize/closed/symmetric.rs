//! Quartics in R whose four roots lie symmetrically about −p/4s in every direction: Lemmas 5 and 10 with B = 0.

use super::forms::{LemmaForm, constant, negative, reduced, square_part};
use super::quartic::{Index, ROOTS};
use super::quartic_signs::{Critical, QuarticRoots, Signs, position, sign_beside_zero};
use crate::parametrize::cells::SignedDirection;
use crate::parametrize::condition::{Condition, Relation};
use crate::parametrize::expression::Expression;
use crate::poly::TernaryForm;

/// Whether a root is one of the outer ones, ±√((−A + √(A² − 4C))/2), of y⁴ + Ay² + C = 0; the inner ones are
/// ±√((−A − √(A² − 4C))/2).
fn is_outer(index: Index) -> bool {
    index.pair == index.sign
}

/// |y| = √((−A ± √(A² − 4C))/2) from A and A² − 4C; the sign of y is that of `pair`.
pub(super) fn size<F: LemmaForm>(a: &F, inner: &F, index: Index) -> Expression<F> {
    let (outside, inside) = square_part(inner);
    let [minus_a, outside, two] = reduced([negative(a), outside, constant(2)]);
    let difference = if inside == constant(1) {
        absolute(outside)
    } else {
        let root = Expression::form(inside).root(2);
        if is_never_negative(&outside) {
            root.times(outside)
        } else {
            Expression::Product(Box::new(absolute(outside)), Box::new(root))
        }
    };
    let [minus_a, difference] = [Expression::form(minus_a), difference].map(Box::new);
    let twice_square = if is_outer(index) {
        Expression::Sum(minus_a, difference)
    } else {
        Expression::Difference(minus_a, difference)
    };
    twice_square.over(two).root(2)
}

/// The absolute value of a form.
fn absolute<F: LemmaForm>(form: F) -> Expression<F> {
    let is_positive = is_never_negative(&form);
    let form = Expression::form(form);
    if is_positive {
        form
    } else {
        Expression::Absolute(Box::new(form))
    }
}

/// Whether this is seen from the terms: they are squares with positive coefficients.
fn is_never_negative<F: LemmaForm>(form: &F) -> bool {
    let terms = form.monomials();
    let is_square = |exponents: &[usize; 3]| exponents.iter().all(|e| e.is_multiple_of(2));
    terms
        .iter()
        .all(|(exponents, c)| **c > 0 && is_square(exponents))
}

/// The condition under which a root is real and finite.
pub(super) fn condition(forms: &Critical<TernaryForm>, index: Index) -> Condition {
    use Relation::{AtLeastZero, AtMostZero, NotZero};
    let form = Condition::form;
    let signs = [form(&forms.a, AtMostZero)];
    let square_is_not_negative = if is_outer(index) {
        Condition::any(signs.into_iter().chain([form(&forms.c, AtMostZero)]))
    } else {
        Condition::all(signs.into_iter().chain([form(&forms.c, AtLeastZero)]))
    };
    Condition::all([
        form(&forms.s, NotZero),
        form(&forms.inner, AtLeastZero),
        square_is_not_negative,
    ])
}

/// Whether a root is real and finite.
fn is_real(signs: Signs, index: Index) -> bool {
    let square_is_not_negative = if is_outer(index) {
        signs.a <= 0 || signs.c <= 0
    } else {
        signs.a <= 0 && signs.c >= 0
    };
    signs.s != 0 && signs.inner >= 0 && square_is_not_negative
}

/// The exact sign of a root R = (y − p)/4s in a direction; `None` if it is not real or not finite.
pub(super) fn sign(
    roots: &QuarticRoots<'_>,
    at: &SignedDirection,
    beside: &[&SignedDirection],
    index: Index,
) -> Option<i8> {
    let signs = Signs::of(at);
    if !is_real(signs, index) {
        return None;
    }
    if let Some(vector) = &at.vector {
        return roots.sign_at(vector, index);
    }
    let Signs { s, p, c, v, .. } = signs;
    let all_are_real = ROOTS.iter().all(|&root| is_real(signs, root));
    if all_are_real {
        let rank = position(index, 4, s);
        return Some(signs.sign_of_rank(rank));
    }
    // Two roots are real.
    if c == 0 {
        // They are the double root y = 0.
        return Some(-p * s);
    }
    if v == 0 {
        return Some(sign_beside_zero(signs, index));
    }
    // Both are simple and not 0, so they are real in the neighboring cells, with the same sign.
    let vector = beside.iter().find_map(|near| near.vector.as_ref())?;
    roots.sign_at(vector, index)
}
