//! Lemma 3: three homogeneous parts.

use malachite::Integer;

use super::forms::{negative, on_circle, reduced, square_part};
use super::{ClosedBranch, branches_of};
use crate::parametrize::cells::{Cells, Place};
use crate::parametrize::expression::Expression;
use crate::poly::{BinaryForm, Ring};

/// Eqs. (21)–(32): `s R² + p R + q = 0` with R = r^k, so that
/// `R = (−p ± √(p² − 4sq)) / 2s`.
///
/// The square factors of the discriminant are taken out of the root with their sign, so a branch goes
/// on smoothly where they vanish.
pub(in crate::parametrize) fn lemma_3(
    s: &BinaryForm,
    p: &BinaryForm,
    q: &BinaryForm,
    k: u32,
) -> Vec<ClosedBranch> {
    let four = Integer::from(4);
    let discriminant = p.squared().minus(&s.times(q).scaled(&four));
    let (outside, inside) = square_part(&discriminant);
    let (s, p, q) = (on_circle(s), on_circle(p), on_circle(q));
    let cells = Cells::cut(&[&s, &p, &q, &inside, &outside]);
    let roots = [1, -1].map(|sign| Quadratic {
        s: &s,
        p: &p,
        inside: &inside,
        outside: &outside,
        sign,
    });
    let branches = roots
        .iter()
        .flat_map(|root| branches_of(root.expression(), k, &cells, |at, _| root.sign_at(at)));
    branches.collect()
}

/// One root of s R² + p R + q, with √(p² − 4sq) = outside·√inside and a choice of sign.
struct Quadratic<'a> {
    s: &'a BinaryForm,
    p: &'a BinaryForm,
    inside: &'a BinaryForm,
    outside: &'a BinaryForm,
    sign: i8,
}

impl Quadratic<'_> {
    /// `(−p ± outside √inside) / 2s` without common constants.
    fn expression(&self) -> Expression {
        let minus_p = negative(self.p);
        let twice = self.s.scaled(&Integer::from(2));
        let [minus_p, outside, twice] = reduced([minus_p, self.outside.clone(), twice]);
        let one = self.inside.degree() == 0 && self.inside.coefficient(0) == 1;
        let root = if one {
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

    /// The sign of the root; `None` where it is not real or not finite.
    fn sign_at(&self, at: &Place) -> Option<i8> {
        let [s, p, q, inside, outside] = at.signs[..] else {
            return None;
        };
        if inside < 0 && outside != 0 {
            return None;
        }
        // The signed square root has this sign.
        let root = if inside == 0 { 0 } else { outside * self.sign };
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
}
