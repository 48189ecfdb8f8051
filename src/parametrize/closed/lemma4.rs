//! Lemma 4: four homogeneous parts.

use malachite::Integer;

use super::forms::{negative, on_circle, reduced, square_part};
use super::{ClosedBranch, branches_of};
use crate::exact::Rational;
use crate::parametrize::cells::{Cells, Heading};
use crate::parametrize::expression::Expression;
use crate::poly::{BinaryForm, Ring};

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
pub(in crate::parametrize) fn lemma_4(
    s: &BinaryForm,
    p: &BinaryForm,
    q: &BinaryForm,
    u: &BinaryForm,
    k: u32,
) -> Vec<ClosedBranch> {
    let times = |c: i64, forms: &[&BinaryForm]| {
        let one = BinaryForm::from_coefficients(vec![Integer::from(c)]);
        forms.iter().fold(one, |product, form| product.times(form))
    };
    // 18spqu − 4p³u + p²q² − 4sq³ − 27s²u²
    let discriminant = times(18, &[s, p, q, u])
        .plus(&times(-4, &[p, p, p, u]))
        .plus(&times(1, &[p, p, q, q]))
        .plus(&times(-4, &[s, q, q, q]))
        .plus(&times(-27, &[s, s, u, u]));
    let big_p = times(3, &[s, q]).minus(&p.squared());
    let big_b = times(2, &[p, p, p])
        .plus(&times(-9, &[s, p, q]))
        .plus(&times(27, &[s, s, u]));
    let [s, p, q, u, discriminant, big_p, big_b] =
        [s, p, q, u, &discriminant, &big_p, &big_b].map(on_circle);
    let cells = Cells::cut(&[&s, &p, &q, &u, &discriminant, &big_p]);
    let cubic = Cubic {
        s,
        p,
        q,
        u,
        discriminant,
        big_p,
        big_b,
    };
    let mut branches = branches_of(cubic.by_cube_roots(), k, &cells, |h| {
        cubic.sign_of_the_one(h)
    });
    for index in 0..3 {
        let root = cubic.by_cosine(index);
        branches.extend(branches_of(root, k, &cells, |h| {
            cubic.sign_of_three(h, index)
        }));
    }
    branches.retain(|branch| !branch.real.is_empty());
    branches
}

/// The forms of the cubic on the unit circle.
struct Cubic {
    s: BinaryForm,
    p: BinaryForm,
    q: BinaryForm,
    u: BinaryForm,
    discriminant: BinaryForm,
    big_p: BinaryForm,
    big_b: BinaryForm,
}

impl Cubic {
    /// (−p + y) / 3s
    fn shifted(&self, y: Expression) -> Expression {
        let [minus_p, thrice] = [negative(&self.p), self.s.scaled(&Integer::from(3))];
        let numerator = if minus_p.is_zero() {
            y
        } else {
            Expression::Sum(Box::new(Expression::form(minus_p)), Box::new(y))
        };
        numerator.over(thrice)
    }

    /// y = ∛((−B + 3s√(−3Δ))/2) + ∛((−B − 3s√(−3Δ))/2)
    fn by_cube_roots(&self) -> Expression {
        let (outside, inside) = square_part(&self.discriminant.scaled(&Integer::from(-3)));
        let outside = outside.times(&self.s).scaled(&Integer::from(3));
        let two = BinaryForm::from_coefficients(vec![Integer::from(2)]);
        let [minus_b, outside, two] = reduced([negative(&self.big_b), outside, two]);
        let root = || {
            Expression::form(inside.clone())
                .root(2)
                .times(outside.clone())
        };
        let minus_b = || Box::new(Expression::form(minus_b.clone()));
        let plus = Expression::Sum(minus_b(), Box::new(root()))
            .over(two.clone())
            .root(3);
        let minus = Expression::Difference(minus_b(), Box::new(root()))
            .over(two.clone())
            .root(3);
        self.shifted(Expression::Sum(Box::new(plus), Box::new(minus)))
    }

    /// y = 2√(−P) cos((arccos(−B / (2 (−P) √(−P))) − 2πj) / 3): the j-th largest y.
    fn by_cosine(&self, j: i32) -> Expression {
        let minus_p = negative(&self.big_p);
        let two = |form: BinaryForm| form.scaled(&Integer::from(2));
        let [minus_b, denominator] = reduced([negative(&self.big_b), two(minus_p.clone())]);
        let root = Expression::form(minus_p).root(2);
        let below = root.clone().times(denominator);
        let ratio = Expression::Quotient(Box::new(Expression::form(minus_b)), Box::new(below));
        let angle = Expression::Arccosine(Box::new(ratio));
        let angle = if j == 0 {
            angle
        } else {
            let turn = Expression::Pi(Rational::from(2 * j));
            Expression::Difference(Box::new(angle), Box::new(turn))
        };
        let three = BinaryForm::from_coefficients(vec![Integer::from(3)]);
        let cosine = Expression::Cosine(Box::new(angle.over(three)));
        let y = Expression::Product(Box::new(root), Box::new(cosine));
        self.shifted(y.times(BinaryForm::from_coefficients(vec![Integer::from(2)])))
    }

    /// The sign of the root that the cube roots give: the only real one, or for Δ = 0 the simple one.
    fn sign_of_the_one(&self, h: &Heading) -> Option<i8> {
        let s = h.sign(&self.s);
        if s == 0 || h.sign(&self.discriminant) > 0 {
            return None;
        }
        // The product of the other two is not negative, and that of all three is −u/s.
        let (p, q, u) = (h.sign(&self.p), h.sign(&self.q), h.sign(&self.u));
        Some(if u == 0 && h.sign(&self.discriminant) == 0 && q == 0 {
            // The double root is 0, the other one −p/s.
            -p * s
        } else {
            -u * s
        })
    }

    /// The sign of the j-th largest y's root where all three are real.
    fn sign_of_three(&self, h: &Heading, j: i32) -> Option<i8> {
        let s = h.sign(&self.s);
        if s == 0 || h.sign(&self.discriminant) < 0 || h.sign(&self.big_p) >= 0 {
            return None;
        }
        // Descartes' rule is exact when all roots are real.
        let signs = [s, h.sign(&self.p), h.sign(&self.q), h.sign(&self.u)];
        let mut last = s;
        let mut positive = 0;
        for &sign in signs.iter().filter(|&&sign| sign != 0) {
            positive += i32::from(sign == -last);
            last = sign;
        }
        let zeros = signs
            .iter()
            .rev()
            .take_while(|&&sign| sign == 0)
            .map(|_| 1)
            .sum::<i32>();
        // y and R = (y − p)/3s are ordered alike for s > 0.
        let index = if s > 0 { j } else { 2 - j };
        Some(if index < positive {
            1
        } else if index < positive + zeros {
            0
        } else {
            -1
        })
    }
}
