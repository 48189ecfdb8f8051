//! Lemmas 5 and 10: closed forms for five homogeneous parts.

use malachite::Integer;

use super::forms::{LemmaForm, constant, negative, product, square_part};
use super::lemma4::{cosine_root, sum_of_cube_roots};
use super::quartic::{Index, ROOTS, depressed, discriminant};
use super::quartic_signs::Critical;
use super::{Rule, Solved, symmetric};
use crate::parametrize::expression::Expression;

/// Eqs. (50)–(69): `s R⁴ + p R³ + q R² + u R + v = 0` with R = r^k.
///
/// With y = 4sR + p this is y⁴ + Ay² + By + C = 0. Let z be the largest real root of the resolvent z³ + 2Az² + (A² − 4C)z − B²
/// = 0, and let m = √z > 0. Then y = (m ± √(−z − 2A − 2B/m))/2 or y = (−m ± √(−z − 2A + 2B/m))/2: the two larger and the two
/// smaller roots. If the discriminant Δ is negative, cube roots give z, and one pair is real, the larger one for B < 0. If Δ ≥
/// 0, z has the cosine form, and all four roots are real if A < 0 and A² ≥ 4C. The case m = 0 has a formula of its own, y² =
/// (−A + √(A² − 4C))/2. If B is 0 in every direction, y² = (−A ± √(A² − 4C))/2 are all the roots.
///
/// DIFFERENCE (errata Lemmas 5 and 10): printed Eqs. (59)–(64) lack three coefficients and signs, and the case
/// of the paper's R = 0 (our m = 0).
pub(super) fn lemma_5<F: LemmaForm>(parts: [&F; 5]) -> Solved<F> {
    let quartic = Quartic::new(parts);
    let roots = if quartic.b.is_zero() {
        let formula = |index| (quartic.symmetric(index), Rule::SymmetricQuartic(index));
        ROOTS.map(formula).to_vec()
    } else {
        quartic.all_roots()
    };
    Solved {
        roots,
        critical: quartic.into_critical_forms().into_list(),
    }
}

/// The forms of the quartic on unit vectors.
struct Quartic<F> {
    /// The forms s, p, q, u, v.
    parts: [F; 5],
    a: F,
    b: F,
    c: F,
    /// The form A² − 4C.
    inner: F,
    /// The forms of the resolvent w³ + 3Pw + B' with w = 3z + 2A.
    resolvent_p: F,
    resolvent_b: F,
    discriminant: F,
}

impl<F: LemmaForm> Quartic<F> {
    fn new(parts: [&F; 5]) -> Self {
        let [a, b, c] = depressed(parts);
        let inner = a.squared().minus(&product(4, &[&c]));
        let resolvent_p = negative(&a.squared().plus(&product(12, &[&c])));
        let resolvent_b = product(-2, &[&a, &a, &a])
            .plus(&product(72, &[&a, &c]))
            .plus(&product(-27, &[&b, &b]));
        Self {
            discriminant: discriminant(parts).on_unit_vectors(),
            parts: parts.map(F::on_unit_vectors),
            a: a.on_unit_vectors(),
            b: b.on_unit_vectors(),
            c: c.on_unit_vectors(),
            inner: inner.on_unit_vectors(),
            resolvent_p: resolvent_p.on_unit_vectors(),
            resolvent_b: resolvent_b.on_unit_vectors(),
        }
    }

    fn into_critical_forms(self) -> Critical<F> {
        let [s, p, q, u, v] = self.parts;
        Critical {
            s,
            p,
            q,
            u,
            v,
            a: self.a,
            b: self.b,
            c: self.c,
            inner: self.inner,
            resolvent_p: self.resolvent_p,
            discriminant: self.discriminant,
        }
    }

    /// The root R = (±y − p)/4s, with the sign `sign`; y is given multiplied by `over`.
    fn shifted(&self, y: Expression<F>, sign: i8, over: i64) -> Expression<F> {
        let minus_p = self.parts[1].scaled(&Integer::from(-over));
        let denominator = self.parts[0].scaled(&Integer::from(4 * over));
        let numerator = if !minus_p.is_zero() {
            signed_sum(Expression::form(minus_p), y, sign)
        } else if sign > 0 {
            y
        } else {
            y.negated()
        };
        numerator.over(denominator)
    }

    /// The roots if B is 0 at most in single directions.
    fn all_roots(&self) -> Vec<(Expression<F>, Rule)> {
        let mut roots = Vec::new();
        for cosine in [false, true] {
            for index in ROOTS {
                let rule = Rule::Quartic { cosine, index };
                roots.push((self.general(cosine, index), rule));
            }
        }
        // The outer roots of the symmetric quartic are the two real ones for m = 0.
        for sign in [1, -1] {
            let formula = self.symmetric(Index { pair: sign, sign });
            roots.push((formula, Rule::Biquadratic(Index { pair: 0, sign })));
        }
        roots
    }

    /// The roots for m > 0.
    fn general(&self, cosine: bool, Index { pair, sign }: Index) -> Expression<F> {
        let w = if cosine {
            cosine_root(&self.resolvent_p, &self.resolvent_b, 0)
        } else {
            // B'² + 4P'³ = −27·4¹² s⁶ Δ
            let scaled = self
                .discriminant
                .scaled(&Integer::from(-27 * (1_i64 << 24)));
            let (outside, inside) = square_part(&scaled);
            let s = &self.parts[0];
            sum_of_cube_roots(&self.resolvent_b, product(1, &[&outside, s, s, s]), inside)
        };
        // z = (w − 2A)/3
        let twice_a = self.a.scaled(&Integer::from(2));
        let z = Expression::Difference(Box::new(w), Box::new(Expression::form(twice_a.clone())));
        let z = z.over(constant(3));
        let m = z.clone().root(2);
        // √(−z − 2A ∓ 2B/m)
        let twice_b = self.b.scaled(&Integer::from(-2 * i64::from(pair)));
        let first = Expression::Sum(Box::new(z), Box::new(Expression::form(twice_a))).negated();
        let inside = if twice_b.is_zero() {
            first
        } else {
            let quotient =
                Expression::Quotient(Box::new(Expression::form(twice_b)), Box::new(m.clone()));
            Expression::Sum(Box::new(first), Box::new(quotient))
        };
        let m = if pair > 0 { m } else { m.negated() };
        let twice_y = signed_sum(m, inside.root(2), sign);
        self.shifted(twice_y, 1, 2)
    }

    /// A root of y⁴ + Ay² + C.
    fn symmetric(&self, index: Index) -> Expression<F> {
        self.shifted(symmetric::size(&self.a, &self.inner, index), index.pair, 1)
    }
}

fn signed_sum<F: LemmaForm>(a: Expression<F>, b: Expression<F>, sign: i8) -> Expression<F> {
    if sign > 0 {
        Expression::Sum(Box::new(a), Box::new(b))
    } else {
        Expression::Difference(Box::new(a), Box::new(b))
    }
}
