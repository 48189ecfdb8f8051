//! Breakpoints: rational numbers between which Descartes' rule counts the real roots of a polynomial (T1).

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, integer_sign, negate_odd, shift_by_one, sign_at_rational};
use crate::roots::{root_bound_exponent, sign_changes};

/// No more breakpoints than this are tried for one polynomial.
const MOST: usize = 4096;
/// No interval is halved more often than this.
const DEEPEST: usize = 2000;

/// An end of an interval of the real line.
#[derive(Clone, Debug)]
pub(super) enum End {
    Below,
    At(Rational),
    Above,
}

impl End {
    /// The end, if it is finite.
    pub(super) fn rational(&self) -> Option<Rational> {
        match self {
            Self::At(end) => Some(end.clone()),
            Self::Below | Self::Above => None,
        }
    }
}

/// A squarefree polynomial, of a formal degree at least its degree and not 0 at 0, and enclosures of its real roots in ascending order.
pub(super) struct Roots<'a> {
    /// The coefficients, ascending, as many as the formal degree says.
    pub(super) coefficients: &'a [Integer],
    /// Closed intervals with one root each, disjoint but for their ends.
    pub(super) enclosures: &'a [(Rational, Rational)],
}

impl Roots<'_> {
    /// Breakpoints between the ends, such that the coefficients on each piece have at most one change of sign, and the breakpoints
    /// are no roots. `None` if too many would be needed.
    pub(super) fn breakpoints(&self, from: &End, to: &End) -> Option<Vec<Rational>> {
        let mut found = Vec::new();
        self.divide(from, to, 0, &mut found)?;
        Some(self.merged(from, to, found))
    }

    fn divide(&self, from: &End, to: &End, depth: usize, found: &mut Vec<Rational>) -> Option<()> {
        if self.changes(from, to) <= 1 {
            return Some(());
        }
        if found.len() > MOST || depth > DEEPEST {
            return None;
        }
        let middle = self.middle(from, to)?;
        let at = End::At(middle.clone());
        self.divide(from, &at, depth + 1, found)?;
        found.push(middle);
        self.divide(&at, to, depth + 1, found)
    }

    /// A number between the ends that is no root, in the middle between two roots if there are two.
    fn middle(&self, from: &End, to: &End) -> Option<Rational> {
        let two = Rational::from(2);
        let (low, high) = match (from, to) {
            (End::At(a), End::At(b)) => (a.clone(), b.clone()),
            (End::Below, End::Above) => return Some(Rational::zero()),
            // There are no real roots beyond the bound, and far beyond it all coefficients have one sign.
            (End::At(a), _) => {
                let bound = bound(self.coefficients);
                return Some(if *a < bound { bound } else { a * &two });
            }
            (_, End::At(b)) => {
                let mut reflected = self.coefficients.to_vec();
                negate_odd(&mut reflected);
                let bound = -bound(&reflected);
                return Some(if *b > bound { bound } else { b * &two });
            }
            (End::Below | End::Above, _) => return None,
        };
        let is_inside = |(l, h): &&(Rational, Rational)| {
            *h > low && *l < high || (l == h && *l > low && *l < high)
        };
        let inside: Vec<_> = self.enclosures.iter().filter(is_inside).collect();
        let (a, b) = match inside.len() {
            0 | 1 => (low.clone(), high.clone()),
            n => (inside[n / 2 - 1].1.clone(), inside[n / 2].0.clone()),
        };
        let third = &(&b - &a) / &Rational::from(3);
        // A window in the middle has simple numbers; one of a few of them is no root.
        let mut window = (&a + &third, &b - &third);
        for _ in 0..64 {
            let simple = Rational::simplest_between(&window.0, &window.1);
            if simple > low && simple < high && self.sign_at(&simple) != 0 {
                return Some(simple);
            }
            window.0 = &(&window.0 + &window.1) / &two;
        }
        None
    }

    fn sign_at(&self, at: &Rational) -> i8 {
        let f = IntegerPolynomial::from_coefficients_asc(self.coefficients.to_vec());
        sign_at_rational(&f, at)
    }

    /// Without the breakpoints that are not needed, from the left.
    fn merged(&self, from: &End, to: &End, found: Vec<Rational>) -> Vec<Rational> {
        let mut kept = Vec::new();
        let mut start = from.clone();
        let mut ends: Vec<End> = found.into_iter().map(End::At).collect();
        ends.push(to.clone());
        for pair in ends.windows(2) {
            // The piece from the start can go on if it has at most one change of sign up to the next end.
            if self.changes(&start, &pair[1]) > 1
                && let End::At(b) = &pair[0]
            {
                kept.push(b.clone());
                start = pair[0].clone();
            }
        }
        kept
    }

    /// The number of changes of sign of the coefficients on an interval. The whole line has no coefficients; a polynomial that is
    /// not constant needs a breakpoint.
    fn changes(&self, from: &End, to: &End) -> usize {
        match (from, to) {
            (End::Below, End::Above) if self.coefficients.len() > 1 => usize::MAX,
            _ => sign_changes(on(self.coefficients, from, to).iter().map(integer_sign)),
        }
    }
}

/// The coefficients on an interval (T1), in the order of the interval or against it, times positive numbers that depend only on
/// the interval and the formal degree.
pub(super) fn on(coefficients: &[Integer], from: &End, to: &End) -> Vec<Integer> {
    let mut f = coefficients.to_vec();
    match (from, to) {
        (End::At(a), End::At(b)) => {
            let width = b - a;
            let common = a.denominator() * width.denominator();
            let over = |q: &Rational| q.numerator() * (&common).div_exact(q.denominator());
            let (start, width) = (over(a), over(&width));
            scale_down(&mut f, &common);
            shift(&mut f, &start);
            stretch(&mut f, &width);
            f.reverse();
            shift(&mut f, &Integer::ONE);
        }
        (End::At(a), _) => shift_rational(&mut f, a),
        (_, End::At(b)) => {
            shift_rational(&mut f, b);
            negate_odd(&mut f);
        }
        (End::Below | End::Above, _) => {}
    }
    f
}

/// A power of two above all positive roots of a polynomial whose coefficients have a change of sign.
fn bound(coefficients: &[Integer]) -> Rational {
    let highest = coefficients.iter().rposition(|c| *c != 0);
    let highest = highest.invariant("a polynomial with a change of sign is not 0");
    Rational::from_dyadic(Integer::ONE, root_bound_exponent(&coefficients[..=highest]))
}

fn shift_rational(f: &mut Vec<Integer>, by: &Rational) {
    scale_down(f, &by.denominator());
    shift(f, &by.numerator());
}

/// d^n f(x/d), n the formal degree.
fn scale_down(f: &mut [Integer], d: &Integer) {
    let mut power = Integer::ONE;
    for c in f.iter_mut().rev() {
        *c *= &power;
        power *= d;
    }
}

/// f(w x).
fn stretch(f: &mut [Integer], w: &Integer) {
    let mut power = Integer::ONE;
    for c in f.iter_mut() {
        *c *= &power;
        power *= w;
    }
}

/// f(x + by), of the same formal degree.
pub(super) fn shift(f: &mut Vec<Integer>, by: &Integer) {
    if *by == 0 {
        return;
    }
    let length = f.len();
    stretch(f, by);
    let shifted = shift_by_one(IntegerPolynomial::from_coefficients_asc(std::mem::take(f)));
    *f = shifted.into_coefficients_asc();
    f.resize(length, Integer::ZERO);
    for (k, c) in f.iter_mut().enumerate() {
        *c = std::mem::take(c).div_exact(by.pow(k as u64));
    }
}
