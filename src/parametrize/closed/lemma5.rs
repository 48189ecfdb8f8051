//! Lemma 5: five homogeneous parts.

use malachite::Integer;
use malachite::base::polynomial::Polynomial;

use super::forms::{constant, negative, on_circle, product, reduced, square_part};
use super::lemma4::{cosine_root, rank_sign, sign_of_rank, sum_of_cube_roots};
use super::{ClosedBranch, branches_of};
use crate::parametrize::cells::{Cells, Place};
use crate::parametrize::expression::Expression;
use crate::poly::{BinaryForm, IntegerPolynomial, Ring, divide_exactly, integer_sign, real_roots};

/// Eqs. (50)–(69): `s R⁴ + p R³ + q R² + u R + v = 0` with R = r^k.
///
/// With y = 4sR + p this is y⁴ + Ay² + By + C = 0. If z is the largest real root of the resolvent
/// z³ + 2Az² + (A² − 4C)z − B² = 0 and m = √z > 0, then
/// y = (m ± √(−z − 2A − 2B/m))/2 or (−m ± √(−z − 2A + 2B/m))/2: the two larger and the two smaller
/// roots. Where the discriminant Δ is negative z comes by cube roots and one pair is real, the
/// upper one for B < 0; where Δ ≥ 0 it comes in cosine form, and all four are real if A < 0 and
/// A² ≥ 4C. m = 0 has its own formula, y² = (−A + √(A² − 4C))/2.
///
/// DIFFERENCE (erratum Lemma 5): printed Eqs. (59)–(64) lack three coefficients and signs, and the case
/// of the paper's R = 0 (our m = 0).
pub(in crate::parametrize) fn lemma_5(parts: [&BinaryForm; 5], k: u32) -> Vec<ClosedBranch> {
    let quartic = Quartic::new(parts);
    let cells = Cells::cut(&quartic.critical_forms());
    let mut branches = Vec::new();
    for (cosine, pair, sign) in [
        (false, 1, 1),
        (false, 1, -1),
        (false, -1, 1),
        (false, -1, -1),
        (true, 1, 1),
        (true, 1, -1),
        (true, -1, 1),
        (true, -1, -1),
    ] {
        let root = quartic.general(cosine, pair, sign);
        let index = Index { pair, sign };
        branches.extend(branches_of(root, k, &cells, |at, beside| {
            let signs = Signs::of(at);
            let real = if cosine {
                signs.all_real()
            } else {
                signs.pair_real(pair)
            };
            real.then(|| quartic.sign_of(at, beside, index)).flatten()
        }));
    }
    for sign in [1, -1] {
        let root = quartic.biquadratic(sign);
        let index = Index { pair: 0, sign };
        branches.extend(branches_of(root, k, &cells, |at, beside| {
            let real = Signs::of(at).biquadratic_real();
            real.then(|| quartic.sign_of(at, beside, index)).flatten()
        }));
    }
    branches.retain(|branch| !branch.real.is_empty());
    branches
}

/// Which of the real roots: `pair` 1 for the two larger y, −1 for the two smaller, 0 for the only two;
/// `sign` 1 for the larger one of the pair.
#[derive(Clone, Copy)]
struct Index {
    pair: i8,
    sign: i8,
}

/// The quotient of a form by a factor of it.
fn divided(form: &BinaryForm, factor: &BinaryForm) -> BinaryForm {
    let quotient = divide_exactly(form.dehomogenized(), factor.dehomogenized());
    let degree = form.degree().saturating_sub(factor.degree());
    BinaryForm::from_dehomogenized(degree, quotient.unwrap_or_default())
}

/// The signs of the critical forms at a place.
#[derive(Clone, Copy, Default)]
struct Signs {
    s: i8,
    p: i8,
    u: i8,
    v: i8,
    a: i8,
    b: i8,
    c: i8,
    inner: i8,
    resolvent_p: i8,
    discriminant: i8,
}

impl Signs {
    /// In the order of [`Quartic::critical_forms`].
    fn of(at: &Place) -> Self {
        let [s, p, _, u, v, a, b, c, inner, resolvent_p, discriminant] = at.signs[..] else {
            return Self::default();
        };
        Self {
            s,
            p,
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

    /// Where all four roots are real and the cosine form is defined.
    fn all_real(self) -> bool {
        self.s != 0
            && self.discriminant >= 0
            && self.a < 0
            && self.inner >= 0
            && self.resolvent_p < 0
    }

    /// Where the cube roots give a real pair: the upper one for B < 0, the lower one for B > 0.
    fn pair_real(self, pair: i8) -> bool {
        if self.s == 0 || self.discriminant > 0 || self.all_real() {
            return false;
        }
        // A triple root belongs to both pairs.
        let triple = self.discriminant == 0 && self.resolvent_p == 0;
        self.b == -pair || (triple && self.b != 0)
    }

    /// Where m = 0 and two roots are real.
    fn biquadratic_real(self) -> bool {
        self.s != 0
            && self.b == 0
            && !self.all_real()
            && self.inner >= 0
            && (self.a <= 0 || self.c <= 0)
    }
}

/// Forms on the unit circle.
struct Quartic {
    /// s, p, q, u, v
    parts: [BinaryForm; 5],
    a: BinaryForm,
    b: BinaryForm,
    c: BinaryForm,
    /// A² − 4C
    inner: BinaryForm,
    /// Of the resolvent: w³ + 3Pw + B' with w = 3z + 2A.
    resolvent_p: BinaryForm,
    resolvent_b: BinaryForm,
    discriminant: BinaryForm,
    /// A double root where it is the only one is y = n/d with d = 2A³ − 8AC + 9B² and n = −B(A² + 12C) (the
    /// first subresultant): d, and n − pd.
    double: [BinaryForm; 2],
}

impl Quartic {
    fn new([s, p, q, u, v]: [&BinaryForm; 5]) -> Self {
        let a = product(16, &[s, q]).plus(&product(-6, &[p, p]));
        let b = product(64, &[s, s, u])
            .plus(&product(-32, &[s, p, q]))
            .plus(&product(8, &[p, p, p]));
        let c = product(256, &[s, s, s, v])
            .plus(&product(-64, &[s, s, p, u]))
            .plus(&product(16, &[s, p, p, q]))
            .plus(&product(-3, &[p, p, p, p]));
        let inner = a.squared().minus(&product(4, &[&c]));
        let resolvent_p = negative(&a.squared().plus(&product(12, &[&c])));
        let resolvent_b = product(-2, &[&a, &a, &a])
            .plus(&product(72, &[&a, &c]))
            .plus(&product(-27, &[&b, &b]));
        // −(B'² + 4P'³) is 27 times the discriminant of y, and that a multiple of s⁶.
        let cube = product(4, &[&resolvent_p, &resolvent_p, &resolvent_p]);
        let full = negative(&resolvent_b.squared().plus(&cube));
        let discriminant = (0..6).fold(full, |rest, _| divided(&rest, s));
        let below = product(2, &[&a, &a, &a])
            .plus(&product(-8, &[&a, &c]))
            .plus(&product(9, &[&b, &b]));
        let above = product(-1, &[&b, &a, &a])
            .plus(&product(-12, &[&b, &c]))
            .minus(&product(1, &[p, &below]));
        Self {
            double: [&below, &above].map(on_circle),
            parts: [s, p, q, u, v].map(on_circle),
            a: on_circle(&a),
            b: on_circle(&b),
            c: on_circle(&c),
            inner: on_circle(&inner),
            resolvent_p: on_circle(&resolvent_p),
            resolvent_b: on_circle(&resolvent_b),
            discriminant: on_circle(&discriminant),
        }
    }

    fn critical_forms(&self) -> Vec<&BinaryForm> {
        let derived = [
            &self.a,
            &self.b,
            &self.c,
            &self.inner,
            &self.resolvent_p,
            &self.discriminant,
        ];
        self.parts.iter().chain(derived).collect()
    }

    /// The sign of a real root R = (y − p)/4s; `None` if exact root counting finds no such root.
    fn sign_of(&self, at: &Place, beside: &[&Place], index: Index) -> Option<i8> {
        if let Some(vector) = &at.vector {
            return self.sign_at(vector, index);
        }
        let signs = Signs::of(at);
        let Signs { s, p, u, v, .. } = signs;
        if index.pair == 0 && signs.discriminant == 0 {
            // The double root y = 0.
            return Some(-p * s);
        }
        if signs.all_real() {
            return Some(sign_of_rank(position(index, 4, s), &at.signs[..5]));
        }
        if v == 0 {
            // 0 is a root; the other real one is that of the cubic.
            let other = -u * s;
            let is_larger = (index.sign > 0) == (s > 0);
            return Some(if is_larger {
                other.max(0)
            } else {
                other.min(0)
            });
        }
        // v ≠ 0: no root changes its sign here, and a cell beside, where it is real, knows it.
        let known = beside.iter().find_map(|near| {
            let signs = Signs::of(near);
            let real = signs.all_real() || signs.pair_real(index.pair) || index.pair == 0;
            let vector = near.vector.as_ref().filter(|_| real)?;
            self.sign_at(vector, index)
        });
        // Else it is a double root, isolated between directions without it.
        Some(known.unwrap_or_else(|| {
            let [below, above] = self.double.each_ref().map(|form| at.sign_of(form));
            above * below * s
        }))
    }

    /// The sign in a rational direction, from the certified roots of the quartic there.
    fn sign_at(&self, (x, y): &(Integer, Integer), index: Index) -> Option<i8> {
        let mut values = self
            .parts
            .each_ref()
            .map(|form| form.evaluate(x, y))
            .to_vec();
        let s = integer_sign(&values[0]);
        values.reverse();
        let roots = real_roots(&IntegerPolynomial::from_coefficients_asc(values));
        let count = |sign: i8| {
            let those = roots.iter().filter(|r| r.signum() == sign);
            those
                .map(crate::poly::RealRoot::multiplicity)
                .sum::<usize>()
        };
        let all = count(1) + count(0) + count(-1);
        if all == 0 {
            return None;
        }
        let rank = position(index, all, s);
        Some(rank_sign(rank, count(1), count(0)))
    }

    /// y → (y − p)/4s
    fn shifted(&self, y: Expression, over: i64) -> Expression {
        // y comes multiplied by `over`.
        let minus_p = self.parts[1].scaled(&Integer::from(-over));
        let denominator = self.parts[0].scaled(&Integer::from(4 * over));
        let numerator = if minus_p.is_zero() {
            y
        } else {
            Expression::Sum(Box::new(Expression::form(minus_p)), Box::new(y))
        };
        numerator.over(denominator)
    }

    /// The roots for m > 0.
    fn general(&self, cosine: bool, pair: i8, sign: i8) -> Expression {
        let w = if cosine {
            cosine_root(&self.resolvent_p, &self.resolvent_b, 0)
        } else {
            let (outside, inside) = square_part(&negative(&self.discriminant));
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
        self.shifted(twice_y, 2)
    }

    /// y = ±√((−A + √(A² − 4C))/2)
    fn biquadratic(&self, sign: i8) -> Expression {
        let (outside, inside) = square_part(&self.inner);
        let [minus_a, outside, two] = reduced([negative(&self.a), outside, constant(2)]);
        let root = Expression::form(inside).root(2).times(outside);
        let square = Expression::Sum(Box::new(Expression::form(minus_a)), Box::new(root)).over(two);
        let y = square.root(2);
        self.shifted(if sign > 0 { y } else { y.negated() }, 1)
    }
}

fn signed_sum(a: Expression, b: Expression, sign: i8) -> Expression {
    if sign > 0 {
        Expression::Sum(Box::new(a), Box::new(b))
    } else {
        Expression::Difference(Box::new(a), Box::new(b))
    }
}

/// The place of a root among `all` real roots R, from the largest (0) down.
fn position(index: Index, all: usize, sign_of_s: i8) -> usize {
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
