//! Lemmas 4 and 9: four homogeneous parts.

use malachite::Integer;

use super::forms::{LemmaForm, constant, negative, product, reduced, square_part};
use super::{Rule, Solved};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::parametrize::cells::SignedDirection;
use crate::parametrize::expression::Expression;

/// Eqs. (33)–(49): `s R³ + p R² + q R + u = 0` with R = r^k.
///
/// With y = 3sR + p this is y³ + 3Py + B = 0, P = 3sq − p², B = 2p³ − 9spq + 27s²u, and
/// B² + 4P³ = −27 s² Δ with the discriminant Δ. Where Δ ≤ 0 the formula with two real cube roots gives
/// the one real root (at Δ = 0 the simple one); where Δ ≥ 0 and P < 0 all three are real and come in
/// cosine form, in a fixed order. So no branch changes its identity within a range; the ranges end
/// where Δ changes its sign, and at s = 0, where a root is infinite.
///
/// DIFFERENCE (erratum Lemma 4): the printed roots lack the shift −p/(3s), and take cube roots
/// independently, which is right for about half of all cubics only.
pub(super) fn lemma_4<F: LemmaForm>([s, p, q, u]: [&F; 4]) -> Solved<F> {
    let discriminant = discriminant([s, p, q, u]);
    let big_p = product(3, &[s, q]).minus(&p.squared());
    let big_b = product(2, &[p, p, p])
        .plus(&product(-9, &[s, p, q]))
        .plus(&product(27, &[s, s, u]));
    let [s, p, q, u, discriminant, big_p, big_b] =
        [s, p, q, u, &discriminant, &big_p, &big_b].map(F::on_unit_vectors);
    let cubic = Cubic {
        s,
        p,
        discriminant,
        big_p,
        big_b,
    };
    let mut roots = vec![(cubic.by_cube_roots(), Rule::CubicOne)];
    roots.extend((0..3).map(|index| (cubic.by_cosine(index), Rule::CubicThree(index))));
    let Cubic {
        s,
        p,
        discriminant,
        big_p,
        ..
    } = cubic;
    Solved {
        roots,
        critical: Critical {
            s,
            p,
            q,
            u,
            discriminant,
            big_p,
        }
        .into_list(),
    }
}

/// 18spqu − 4p³u + p²q² − 4sq³ − 27s²u²
pub(super) fn discriminant<F: LemmaForm>([s, p, q, u]: [&F; 4]) -> F {
    product(18, &[s, p, q, u])
        .plus(&product(-4, &[p, p, p, u]))
        .plus(&product(1, &[p, p, q, q]))
        .plus(&product(-4, &[s, q, q, q]))
        .plus(&product(-27, &[s, s, u, u]))
}

/// The forms of the cubic on unit vectors.
struct Cubic<F> {
    s: F,
    p: F,
    discriminant: F,
    big_p: F,
    big_b: F,
}

impl<F: LemmaForm> Cubic<F> {
    /// (−p + y) / 3s
    fn shifted(&self, y: Expression<F>) -> Expression<F> {
        let [minus_p, thrice] = [negative(&self.p), self.s.scaled(&Integer::from(3))];
        let numerator = if minus_p.is_zero() {
            y
        } else {
            Expression::Sum(Box::new(Expression::form(minus_p)), Box::new(y))
        };
        numerator.over(thrice)
    }

    fn by_cube_roots(&self) -> Expression<F> {
        // B² + 4P³ = −27 s² Δ = (3s)² (−3Δ)
        let (outside, inside) = square_part(&self.discriminant.scaled(&Integer::from(-3)));
        let outside = outside.times(&self.s).scaled(&Integer::from(3));
        self.shifted(sum_of_cube_roots(&self.big_b, outside, inside))
    }

    fn by_cosine(&self, j: usize) -> Expression<F> {
        self.shifted(cosine_root(&self.big_p, &self.big_b, j))
    }
}

/// The forms whose signs decide which roots are real, or the signs of these forms in a direction.
#[derive(Clone)]
pub(super) struct Critical<T> {
    pub(super) s: T,
    pub(super) p: T,
    pub(super) q: T,
    pub(super) u: T,
    pub(super) discriminant: T,
    pub(super) big_p: T,
}

impl<T: Clone> Critical<T> {
    fn into_list(self) -> Vec<T> {
        let Self {
            s,
            p,
            q,
            u,
            discriminant,
            big_p,
        } = self;
        vec![s, p, q, u, discriminant, big_p]
    }

    /// The named values of the list that [`Critical::into_list`] makes.
    pub(super) fn named(list: &[T]) -> Self {
        let [s, p, q, u, discriminant, big_p] = <&[T; 6]>::try_from(list)
            .invariant("Lemma 4 has six critical forms")
            .clone();
        Self {
            s,
            p,
            q,
            u,
            discriminant,
            big_p,
        }
    }
}

/// The sign of the root that the cube roots give: the only real root or, for Δ = 0, the simple one.
pub(super) fn sign_of_one(at: &SignedDirection) -> Option<i8> {
    let Critical {
        s,
        p,
        q,
        u,
        discriminant,
        ..
    } = Critical::named(&at.signs);
    if s == 0 || discriminant > 0 {
        return None;
    }
    // The product of the two other roots is not negative, and the product of all three is −u/s.
    Some(if u == 0 && discriminant == 0 && q == 0 {
        // The double root is 0, and the other root is −p/s.
        -p * s
    } else {
        -u * s
    })
}

/// The sign of the root with the j-th largest y, if all three roots are real.
pub(super) fn sign_of_three(at: &SignedDirection, j: usize) -> Option<i8> {
    let Critical {
        s,
        p,
        q,
        u,
        discriminant,
        big_p,
    } = Critical::named(&at.signs);
    if s == 0 || discriminant < 0 || big_p >= 0 {
        return None;
    }
    // For s > 0, y and R = (y − p)/3s have the same order.
    let rank = if s > 0 { j } else { 2 - j };
    Some(sign_of_rank(rank, &[s, p, q, u]))
}

/// The sign of the root with the given rank (0 for the largest) of a polynomial with real roots only, from the signs of its
/// coefficients, descending. Descartes' rule is exact for such a polynomial.
pub(super) fn sign_of_rank(rank: usize, signs: &[i8]) -> i8 {
    let nonzero: Vec<i8> = signs.iter().copied().filter(|&sign| sign != 0).collect();
    let positive = nonzero.windows(2).filter(|pair| pair[0] != pair[1]).count();
    let zeros = signs.iter().rev().take_while(|&&sign| sign == 0).count();
    rank_sign(rank, positive, zeros)
}

/// The sign of the root with the given rank (0 for the largest), where `positive` roots are positive and `zeros` roots are 0.
pub(super) fn rank_sign(rank: usize, positive: usize, zeros: usize) -> i8 {
    if rank < positive {
        1
    } else if rank < positive + zeros {
        0
    } else {
        -1
    }
}

/// The real root of y³ + 3Py + B = 0, if it is the only one: ∛((−B + h√g)/2) + ∛((−B − h√g)/2) with h²g = B² + 4P³.
pub(super) fn sum_of_cube_roots<F: LemmaForm>(b: &F, h: F, g: F) -> Expression<F> {
    let [minus_b, h, two] = reduced([negative(b), h, constant::<F>(2)]);
    let root = || Box::new(Expression::form(g.clone()).root(2).times(h.clone()));
    let minus_b = || Box::new(Expression::form(minus_b.clone()));
    let plus = Expression::Sum(minus_b(), root()).over(two.clone()).root(3);
    let minus = Expression::Difference(minus_b(), root()).over(two).root(3);
    Expression::Sum(Box::new(plus), Box::new(minus))
}

/// The j-th largest root (j = 0, 1, 2) of y³ + 3Py + B = 0, if all roots are real and P < 0: 2√(−P) cos((arccos(−B / (2 (−P)
/// √(−P))) − 2πj) / 3).
pub(super) fn cosine_root<F: LemmaForm>(p: &F, b: &F, j: usize) -> Expression<F> {
    let minus_p = negative(p);
    let twice = minus_p.scaled(&Integer::from(2));
    let [minus_b, denominator] = reduced([negative(b), twice]);
    let root = Expression::form(minus_p).root(2);
    let below = root.clone().times(denominator);
    let ratio = Expression::Quotient(Box::new(Expression::form(minus_b)), Box::new(below));
    let angle = Expression::Arccosine(Box::new(ratio));
    let angle = if j == 0 {
        angle
    } else {
        let turn = Expression::Pi(Rational::whole(Integer::from(2 * j)));
        Expression::Difference(Box::new(angle), Box::new(turn))
    };
    let cosine = Expression::Cosine(Box::new(angle.over(constant(3))));
    Expression::Product(Box::new(root), Box::new(cosine)).times(constant(2))
}
