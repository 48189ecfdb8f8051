//! Lemmas 2 and 3: closed forms of r(θ) for two and three equally spaced homogeneous parts, and the
//! exact ranges in which they are real.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Abs, DivRem, Gcd, Parity};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use super::angle::AngleRange;
use super::cells::{Cells, Heading};
use super::expression::Expression;
use crate::poly::{BinaryForm, IntegerPolynomial, Ring, squarefree_decomposition};

/// Square factors of constants are taken out of roots up to this prime.
const LARGEST_SQUARE_PRIME: u32 = 1000;

/// One branch r(θ) of a curve in closed form.
#[derive(Clone, Debug)]
pub(super) struct ClosedBranch {
    /// r(θ).
    pub(super) radius: Expression,
    /// Where r is real and finite, of either sign.
    pub(super) real: Vec<AngleRange>,
    /// Where r > 0.
    pub(super) positive: Vec<AngleRange>,
}

/// Lemma 2, Eqs. (16)–(19): two parts, `top R + low = 0` with R = r^k.
///
/// The form that vanishes decides everything: R = −low/top is finite where top ≠ 0, and for even k
/// real where −low·top ≥ 0.
pub(super) fn lemma_2(top: &BinaryForm, low: &BinaryForm, k: u32) -> Vec<ClosedBranch> {
    let (top, low) = (on_circle(top), on_circle(low));
    let cells = Cells::cut(&[&top, &low]);
    let minus_low = negative(&low);
    let quotient = reduced([minus_low.clone(), top.clone()]);
    let [numerator, denominator] = quotient;
    let radius = Expression::form(numerator).over(denominator).root(k);
    let sign = |h: &Heading| h.sign(&minus_low) * h.sign(&top);
    let finite = |h: &Heading| h.sign(&top) != 0;
    if k.odd() {
        return vec![ClosedBranch {
            radius,
            real: cells.ranges(finite),
            positive: cells.ranges(|h| sign(h) > 0),
        }];
    }
    let real = cells.ranges(|h| finite(h) && sign(h) >= 0);
    let positive = cells.ranges(|h| sign(h) > 0);
    vec![
        ClosedBranch {
            radius: radius.clone(),
            real: real.clone(),
            positive,
        },
        ClosedBranch {
            radius: radius.negated(),
            real,
            positive: Vec::new(),
        },
    ]
}

/// Lemma 3, Eqs. (21)–(32): three parts, `s R² + p R + q = 0` with R = r^k, so that
/// `R = (−p ± √(p² − 4sq)) / 2s`.
///
/// The square factors of the discriminant are taken out of the root with their sign, so a branch goes
/// on smoothly where they vanish.
pub(super) fn lemma_3(s: &BinaryForm, p: &BinaryForm, q: &BinaryForm, k: u32) -> Vec<ClosedBranch> {
    let four = Integer::from(4);
    let discriminant = p.squared().minus(&s.times(q).scaled(&four));
    let (outside, inside) = square_part(&discriminant);
    let (s, p, q) = (on_circle(s), on_circle(p), on_circle(q));
    let cells = Cells::cut(&[&s, &p, &q, &inside, &outside]);
    let mut branches = Vec::new();
    for sign in [1, -1] {
        let quadratic = Quadratic {
            s: &s,
            p: &p,
            q: &q,
            inside: &inside,
            outside: &outside,
            sign,
        };
        let radius = quadratic.expression().root(k);
        if k.odd() {
            branches.push(ClosedBranch {
                radius,
                real: cells.ranges(|h| quadratic.root_sign(h).is_some()),
                positive: cells.ranges(|h| quadratic.root_sign(h) == Some(1)),
            });
        } else {
            let real = cells.ranges(|h| quadratic.root_sign(h).is_some_and(|v| v >= 0));
            branches.push(ClosedBranch {
                radius: radius.clone(),
                real: real.clone(),
                positive: cells.ranges(|h| quadratic.root_sign(h) == Some(1)),
            });
            branches.push(ClosedBranch {
                radius: radius.negated(),
                real,
                positive: Vec::new(),
            });
        }
    }
    branches
}

/// One root of s R² + p R + q, with √(p² − 4sq) = outside·√inside and a choice of sign.
struct Quadratic<'a> {
    s: &'a BinaryForm,
    p: &'a BinaryForm,
    q: &'a BinaryForm,
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
    fn root_sign(&self, heading: &Heading) -> Option<i8> {
        let inside = heading.sign(self.inside);
        let outside = heading.sign(self.outside);
        let (s, p, q) = (
            heading.sign(self.s),
            heading.sign(self.p),
            heading.sign(self.q),
        );
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

/// A form without its powers of x² + y², which are 1 on the circle.
pub(super) fn on_circle(form: &BinaryForm) -> BinaryForm {
    form.strip_rho()
        .map_or_else(|| form.clone(), |(_, rest)| rest)
}

fn negative(form: &BinaryForm) -> BinaryForm {
    form.scaled(&Integer::from(-1))
}

/// Forms divided by the gcd of all their coefficients, the last one with its first sign positive.
fn reduced<const N: usize>(forms: [BinaryForm; N]) -> [BinaryForm; N] {
    let mut content = Integer::ZERO;
    for form in &forms {
        content = Integer::from(
            content
                .unsigned_abs_ref()
                .gcd(form.content().unsigned_abs_ref()),
        );
    }
    let last_is_negative = forms[N - 1].terms().next().is_some_and(|(_, c)| *c < 0);
    if last_is_negative {
        content = -content;
    }
    if content == 0 {
        return forms;
    }
    forms.map(|form| form.div_exact(&content))
}

/// (h, g) with `form = h² g (x²+y²)^e` and g squarefree up to constants.
fn square_part(form: &BinaryForm) -> (BinaryForm, BinaryForm) {
    let form = on_circle(form);
    let in_t = form.dehomogenized();
    let Some(lead) = in_t.coefficients_asc().last() else {
        return (BinaryForm::zero(0), BinaryForm::zero(0));
    };
    let mut outside = IntegerPolynomial::one();
    let mut inside = IntegerPolynomial::one();
    for (multiplicity, part) in squarefree_decomposition(in_t) {
        for _ in 0..multiplicity / 2 {
            outside *= &part;
        }
        if multiplicity.odd() {
            inside *= &part;
        }
    }
    let sign = if *lead > 0 {
        Integer::ONE
    } else {
        -Integer::ONE
    };
    let (root, rest) = integer_square_part(form.content() * sign);
    let constant = |c: Integer| IntegerPolynomial::from_coefficients_asc(vec![c]);
    let x_power = form.degree() + 1 - in_t.coefficients_asc().len();
    let degree = |p: &IntegerPolynomial| p.coefficients_asc().len() - 1;
    (
        BinaryForm::from_dehomogenized(degree(&outside) + x_power / 2, outside * constant(root)),
        BinaryForm::from_dehomogenized(degree(&inside) + x_power % 2, inside * constant(rest)),
    )
}

/// (a, b) with value = a² b, a as large as small primes make it.
fn integer_square_part(value: Integer) -> (Integer, Integer) {
    use malachite::base::num::arithmetic::traits::CheckedSqrt;
    if value > 0
        && let Some(root) = (&value).checked_sqrt()
    {
        return (root, Integer::ONE);
    }
    let mut root = Integer::ONE;
    let mut rest = value;
    for p in 2..LARGEST_SQUARE_PRIME {
        let square = Integer::from(p * p);
        if square > (&rest).abs() {
            break;
        }
        loop {
            let (quotient, remainder) = (&rest).div_rem(&square);
            if remainder != 0 {
                break;
            }
            rest = quotient;
            root *= Integer::from(p);
        }
    }
    (root, rest)
}
