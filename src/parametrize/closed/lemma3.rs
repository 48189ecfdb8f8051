//! Lemmas 3 and 8: closed forms for three homogeneous parts.

use malachite::Integer;

use super::forms::{LemmaForm, negative, reduced, square_part};
use super::{Rule, Solved};
use crate::error::Invariant;
use crate::parametrize::cells::SignedDirection;
use crate::parametrize::expression::Expression;

/// Eqs. (21)–(32): `s R² + p R + q = 0` with R = r^k, so that
/// `R = (−p ± √(p² − 4sq)) / 2s`.
///
/// The square factors of the discriminant are taken out of the root with their sign, so a branch continues smoothly where they
/// vanish.
pub(super) fn lemma_3<F: LemmaForm>([s, p, q]: [&F; 3]) -> Solved<F> {
    let (outside, inside) = square_part(&discriminant([s, p, q]));
    let [s, p, q] = [s, p, q].map(F::on_unit_vectors);
    let roots = [1, -1].map(|sign| {
        let root = Quadratic {
            s: &s,
            p: &p,
            inside: &inside,
            outside: &outside,
            sign,
        };
        (root.expression(), Rule::Quadratic(sign))
    });
    Solved {
        roots: roots.into(),
        critical: Critical {
            s,
            p,
            q,
            inside,
            outside,
        }
        .into_list(),
    }
}

/// p² − 4sq
pub(super) fn discriminant<F: LemmaForm>([s, p, q]: [&F; 3]) -> F {
    p.squared().minus(&s.times(q).scaled(&Integer::from(4)))
}

/// One root of s R² + p R + q = 0, where √(p² − 4sq) = outside·√inside, with a choice of its sign.
struct Quadratic<'a, F> {
    s: &'a F,
    p: &'a F,
    inside: &'a F,
    outside: &'a F,
    sign: i8,
}

impl<F: LemmaForm> Quadratic<'_, F> {
    /// The expression `(−p ± outside √inside) / 2s`, without common constant factors.
    fn expression(&self) -> Expression<F> {
        let minus_p = negative(self.p);
        let twice = self.s.scaled(&Integer::from(2));
        let [minus_p, outside, twice] = reduced([minus_p, self.outside.clone(), twice]);
        let root = if *self.inside == super::forms::constant(1) {
            Expression::form(outside)
        } else {
            Expression::form(self.inside.clone()).root(2).times(outside)
        };
        let numerator = match (minus_p.is_zero(), self.sign > 0) {
            (true, true) => root,
            (true, false) => root.negated(),
            (false, true) => Expression::Sum(Box::new(Expression::form(minus_p)), Box::new(root)),
            (false, false) => {
                Expression::Difference(Box::new(Expression::form(minus_p)), Box::new(root))
            }
        };
        numerator.over(twice)
    }
}

/// The forms whose signs decide where the roots are real, or the signs of these forms in a direction; p² − 4sq = outside²
/// inside.
pub(super) struct Critical<T> {
    pub(super) s: T,
    pub(super) p: T,
    pub(super) q: T,
    pub(super) inside: T,
    pub(super) outside: T,
}

impl<T: Clone> Critical<T> {
    fn into_list(self) -> Vec<T> {
        let Self {
            s,
            p,
            q,
            inside,
            outside,
        } = self;
        vec![s, p, q, inside, outside]
    }

    /// The named values of the list that [`Critical::into_list`] makes.
    pub(super) fn named(list: &[T]) -> Self {
        let [s, p, q, inside, outside] = <&[T; 5]>::try_from(list)
            .invariant("Lemma 3 has five critical forms")
            .clone();
        Self {
            s,
            p,
            q,
            inside,
            outside,
        }
    }
}

/// The sign of the root with the given sign of √(p² − 4sq); `None` if it is not real or not finite.
pub(super) fn sign(at: &SignedDirection, of_root: i8) -> Option<i8> {
    let Critical {
        s,
        p,
        q,
        inside,
        outside,
    } = Critical::named(&at.signs);
    if inside < 0 && outside != 0 {
        return None;
    }
    // The square root, with the sign of `outside`, has this sign.
    let root = if inside == 0 { 0 } else { outside * of_root };
    if s == 0 {
        // p R + q = 0 is the root that stays finite: there the numerator −p ± √… vanishes.
        return (p != 0 && root == p).then(|| -q * p);
    }
    // −p + root with p² − root² = 4sq
    let numerator = match (-p, root) {
        (a, b) if a == b || b == 0 => a,
        (0, b) => b,
        (a, b) => match s * q {
            0 => 0,
            1 => a,
            _ => b,
        },
    };
    Some(numerator * s)
}
