//! The real root of a polynomial nearest to 1: where a ray through a point of a float program meets the curve.

use malachite::Integer;
use malachite::base::polynomial::Polynomial;

use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, shift_by_one};
use crate::roots::{RealRoot, real_roots};

/// Bits to which the distance from 1 is enclosed, relatively.
const DISTANCE_BITS: i64 = 80;

/// Bounds of δ for a root 1 + δ; both have one sign, and they are equal if the root is known exactly.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Offset {
    pub(super) low: Rational,
    pub(super) high: Rational,
}

impl Offset {
    /// The smaller bound of |δ|.
    pub(super) fn inner(&self) -> Rational {
        self.low.abs().min(self.high.abs())
    }

    /// A lower bound of |δ| and |1 + δ|, the smaller one of them.
    pub(super) fn size(&self) -> Rational {
        let one = Rational::one();
        let [a, b] = [&one + &self.low, one + &self.high];
        if a.signum() == b.signum() {
            self.inner().min(a.abs()).min(b.abs())
        } else {
            Rational::zero()
        }
    }

    /// An upper bound of |δ|/|1 + δ|, the distance relative to the root.
    pub(super) fn relative(&self) -> Option<Rational> {
        let at = |delta: &Rational| {
            let root = Rational::one() + delta;
            root.recip().map(|inverse| (delta * &inverse).abs())
        };
        // Monotonic between the bounds, which lie on one side of −1.
        Some(at(&self.low)?.max(at(&self.high)?))
    }
}

/// The real root λ ≠ 0 of Σ c_d λ^d that is nearest to 1, as δ = λ − 1, exactly 0 or enclosed to 2⁻⁸⁰ of itself and of λ; `None` if there
/// is no real root but 0. Of two that are equally near (to 2⁻⁸⁰) it is either. The terms (d, c_d) descend in d.
///
/// Cost: a Taylor shift, then the isolation of the real roots.
pub(super) fn nearest_to_one(terms: &[(usize, Integer)]) -> Option<Offset> {
    let lowest = terms.last()?.0;
    let highest = terms.first()?.0;
    let mut dense = vec![Integer::default(); highest - lowest + 1];
    for (d, c) in terms {
        dense[d - lowest] = c.clone();
    }
    nearest_to_zero(&shift_by_one(IntegerPolynomial::from_coefficients_asc(
        dense,
    )))
}

/// The real root δ nearest to 0, where −1 is no root.
pub(super) fn nearest_to_zero(f: &IntegerPolynomial) -> Option<Offset> {
    let roots = real_roots(f);
    let below = roots.iter().rev().find(|root| root.signum() < 0);
    let above = roots.iter().find(|root| root.signum() > 0);
    if roots.iter().any(|root| root.signum() == 0) {
        let zero = Rational::zero;
        return Some(Offset {
            low: zero(),
            high: zero(),
        });
    }
    let sides = [below, above].into_iter().flatten().map(enclosed);
    sides.min_by(|a, b| a.inner().cmp(&b.inner()))
}

/// Bounds of δ, close enough for δ and for the root 1 + δ, neither of which is 0.
fn enclosed(root: &RealRoot) -> Offset {
    let mut root = root.clone();
    let mut bits = DISTANCE_BITS;
    loop {
        root.refine(bits);
        let (low, high) = root.enclosure();
        let offset = Offset {
            low: low.to_rational(),
            high: high.to_rational(),
        };
        let width = &offset.high - &offset.low;
        if width <= offset.size() * Rational::from_dyadic(Integer::from(1), -DISTANCE_BITS) {
            return offset;
        }
        bits *= 2;
    }
}
