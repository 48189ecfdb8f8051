//! The root of a quartic that a formula of Lemma 5 gives in a direction, and its exact sign.

use malachite::Integer;
use malachite::base::polynomial::Polynomial;

use super::forms::product;
use super::lemma4::{rank_sign, sign_of_rank};
use super::quartic::{Index, depressed};
use crate::error::Invariant;
use crate::parametrize::cells::SignedDirection;
use crate::poly::{BinaryForm, HomogeneousPolynomial, IntegerPolynomial, Ring, integer_sign};
use crate::roots::real_roots;

/// The forms whose signs decide which roots are real, or the signs of these forms in a direction.
#[derive(Clone, Copy)]
pub(super) struct Critical<T> {
    pub(super) s: T,
    pub(super) p: T,
    pub(super) q: T,
    pub(super) u: T,
    pub(super) v: T,
    pub(super) a: T,
    pub(super) b: T,
    pub(super) c: T,
    pub(super) inner: T,
    pub(super) resolvent_p: T,
    pub(super) discriminant: T,
}

impl<T: Clone> Critical<T> {
    pub(super) fn into_list(self) -> Vec<T> {
        let Self {
            s,
            p,
            q,
            u,
            v,
            a,
            b,
            c,
            inner,
            resolvent_p,
            discriminant,
        } = self;
        vec![s, p, q, u, v, a, b, c, inner, resolvent_p, discriminant]
    }

    /// The named values of the list that [`Critical::into_list`] makes.
    pub(super) fn named(list: &[T]) -> Self {
        let [s, p, q, u, v, a, b, c, inner, resolvent_p, discriminant] = <&[T; 11]>::try_from(list)
            .invariant("Lemma 5 has eleven critical forms")
            .clone();
        Self {
            s,
            p,
            q,
            u,
            v,
            a,
            b,
            c,
            inner,
            resolvent_p,
            discriminant,
        }
    }
}

/// The signs of the forms in a direction.
pub(super) type Signs = Critical<i8>;

impl Signs {
    pub(super) fn of(at: &SignedDirection) -> Self {
        Self::named(&at.signs)
    }

    /// The sign of the root R with the given rank (0 for the largest), if all four are real.
    pub(super) fn sign_of_rank(self, rank: usize) -> i8 {
        sign_of_rank(rank, &[self.s, self.p, self.q, self.u, self.v])
    }

    /// Whether all four roots are real and the cosine form is defined.
    pub(super) fn all_real(self) -> bool {
        self.s != 0
            && self.discriminant >= 0
            && self.a < 0
            && self.inner >= 0
            && self.resolvent_p < 0
    }

    /// Whether the cube roots give this pair of real roots: the larger pair for B < 0, the smaller one for B > 0.
    pub(super) fn pair_real(self, pair: i8) -> bool {
        if self.s == 0 || self.discriminant > 0 || self.all_real() {
            return false;
        }
        // A triple root belongs to both pairs.
        let triple = self.discriminant == 0 && self.resolvent_p == 0;
        self.b == -pair || (triple && self.b != 0)
    }

    /// Whether m = 0 and two roots are real.
    pub(super) fn biquadratic_real(self) -> bool {
        self.s != 0
            && self.b == 0
            && !self.all_real()
            && self.inner >= 0
            && (self.a <= 0 || self.c <= 0)
    }
}

/// The quartic as a polynomial in R, to find the signs of its roots.
pub(super) struct QuarticRoots<'a> {
    /// The forms s, p, q, u, v.
    parts: &'a [BinaryForm],
    /// The forms d and n − pd. If the quartic has exactly one double root, it is y = n/d with d = 2A³ − 8AC + 9B² and n = −B(A²
    /// + 12C), by the first subresultant.
    double: [BinaryForm; 2],
}

impl<'a> QuarticRoots<'a> {
    /// The quartic of five parts; `None` for another number of parts.
    pub(super) fn new(parts: &'a [BinaryForm]) -> Option<Self> {
        let [s, p, q, u, v] = parts else {
            return None;
        };
        let [a, b, c] = depressed([s, p, q, u, v]);
        let below = product(2, &[&a, &a, &a])
            .plus(&product(-8, &[&a, &c]))
            .plus(&product(9, &[&b, &b]));
        let above = product(-1, &[&b, &a, &a])
            .plus(&product(-12, &[&b, &c]))
            .minus(&product(1, &[p, &below]));
        let double = [&below, &above].map(BinaryForm::on_unit_vectors);
        Some(Self { parts, double })
    }

    /// The sign of a real root R = (y − p)/4s; `None` if exact root counting does not find this root.
    pub(super) fn sign_of(
        &self,
        at: &SignedDirection,
        beside: &[&SignedDirection],
        index: Index,
    ) -> Option<i8> {
        if let Some(vector) = &at.vector {
            return self.sign_at(vector, index);
        }
        let signs = Signs::of(at);
        let Signs { s, p, v, .. } = signs;
        if index.pair == 0 && signs.discriminant == 0 {
            // The double root is y = 0.
            return Some(-p * s);
        }
        if signs.all_real() {
            return Some(signs.sign_of_rank(position(index, 4, s)));
        }
        if v == 0 {
            return Some(sign_beside_zero(signs, index));
        }
        // v ≠ 0, so no root changes its sign here. A neighbouring cell in which the root is real knows the sign.
        let known = beside.iter().find_map(|near| {
            let signs = Signs::of(near);
            let real = signs.all_real() || signs.pair_real(index.pair) || index.pair == 0;
            let vector = near.vector.as_ref().filter(|_| real)?;
            self.sign_at(vector, index)
        });
        // If the root is real in neither cell, it is an isolated double root.
        Some(known.unwrap_or_else(|| {
            let [below, above] = self.double.each_ref().map(|form| at.sign_of(form));
            above * below * s
        }))
    }

    /// The sign in a rational direction, by the certified roots of the quartic there.
    pub(super) fn sign_at(&self, (x, y): &(Integer, Integer), index: Index) -> Option<i8> {
        let values = self.parts.iter().map(|form| form.evaluate(x, y));
        let mut values: Vec<Integer> = values.collect();
        let s = integer_sign(&values[0]);
        values.reverse();
        let roots = real_roots(&IntegerPolynomial::from_coefficients_asc(values));
        let count = |sign: i8| {
            let those = roots.iter().filter(|r| r.signum() == sign);
            those
                .map(crate::roots::RealRoot::multiplicity)
                .sum::<usize>()
        };
        let all = count(1) + count(0) + count(-1);
        if all == 0 {
            return None;
        }
        let rank = position(index, all, s);
        Some(rank_sign(rank, count(1), count(0)))
    }
}

/// The sign of one of two real roots of which one is 0; the other is the real root of the cubic that remains.
pub(super) fn sign_beside_zero(Signs { s, u, .. }: Signs, index: Index) -> i8 {
    let other = -u * s;
    let is_larger = (index.sign > 0) == (s > 0);
    if is_larger {
        other.max(0)
    } else {
        other.min(0)
    }
}

/// The index of a root among `all` real roots R, from the largest (0) to the smallest.
pub(super) fn position(index: Index, all: usize, sign_of_s: i8) -> usize {
    let second_of_pair = usize::from(index.sign < 0);
    let by_y = if all > 2 && index.pair < 0 {
        2 + second_of_pair
    } else {
        second_of_pair
    };
    if sign_of_s > 0 {
        by_y
    } else {
        (all - 1).saturating_sub(by_y)
    }
}
