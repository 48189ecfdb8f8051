//! The real root of a polynomial that is nearest to 1. For the polynomial f(λp) in λ, where p is a point of a float program,
//! this root gives the point of the curve on the line through the origin and p that is nearest to p.

use malachite::Integer;
use malachite::base::polynomial::Polynomial;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, shift_by_one};
use crate::roots::{RealRoot, real_roots};
use crate::sample::RealParameters;

/// The distance of the root from 1 is enclosed with a relative width of 2^−DISTANCE_BITS.
const DISTANCE_BITS: i64 = 80;

/// Bounds of δ for a root 1 + δ. They have the same sign, and they are equal if the root is known exactly.
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

    /// A lower bound of the smaller one of |δ| and |1 + δ|.
    pub(super) fn size(&self) -> Rational {
        let one = Rational::one();
        let [a, b] = [&one + &self.low, one + &self.high];
        if a.signum() == b.signum() {
            self.inner().min(a.abs()).min(b.abs())
        } else {
            Rational::zero()
        }
    }

    /// An upper bound of the distance of 1 from the root relative to the root, |δ|/|1 + δ|; `None` if a bound of the root is 0.
    pub(super) fn relative(&self) -> Option<Rational> {
        let at = |delta: &Rational| {
            let root = Rational::one() + delta;
            root.recip().map(|inverse| (delta * &inverse).abs())
        };
        // The quotient δ/(1 + δ) grows with δ on either side of −1, and both bounds lie on the same side.
        Some(at(&self.low)?.max(at(&self.high)?))
    }
}

/// The real root λ ≠ 0 of Σ c_d λ^d that is nearest to 1, as δ = λ − 1. The bounds of δ are exactly 0, or apart by at most 2⁻⁸⁰
/// of δ and of λ. `None` if there is no real root but 0. If two roots are equally near up to 2⁻⁸⁰, it is either of them. The
/// terms (d, c_d) must descend in d. `on` tells which of them are counted; without it all are.
///
/// Cost: a Taylor shift and the isolation of the real roots.
pub(super) fn nearest_to_one(
    terms: &[(usize, Integer)],
    on: Option<&OnCurve<'_>>,
) -> Option<Offset> {
    let lowest = terms.last()?.0;
    let highest = terms.first()?.0;
    let mut dense = vec![Integer::default(); highest - lowest + 1];
    for (d, c) in terms {
        dense[d - lowest] = c.clone();
    }
    let f = IntegerPolynomial::from_coefficients_asc(dense);
    let mut roots = real_roots(&shift_by_one(f.clone()));
    let have_all = |on: &OnCurve<'_>| {
        let multiplicities = roots.iter().map(RealRoot::multiplicity);
        on.parameters.have_all(multiplicities)
    };
    if let Some(on) = on.filter(|on| !have_all(on)) {
        let mut reached = on
            .parameters
            .reach(on.vector, on.w, real_roots(&f))
            .into_iter();
        roots.retain(|_| reached.next().invariant("a shift keeps the roots"));
    }
    nearest_of(&roots)
}

/// The point vector/w, on the line on which points of a parametric curve are looked for.
pub(super) struct OnCurve<'a> {
    pub(super) parameters: &'a RealParameters,
    pub(super) vector: [&'a Integer; 2],
    pub(super) w: &'a Integer,
}

/// The real root δ of f that is nearest to 0, for an f of which −1 is not a root.
pub(super) fn nearest_to_zero(f: &IntegerPolynomial) -> Option<Offset> {
    nearest_of(&real_roots(f))
}

/// The one of some ascending roots that is nearest to 0.
fn nearest_of(roots: &[RealRoot]) -> Option<Offset> {
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

/// Bounds of the root δ that are close relative to δ and to 1 + δ, neither of which is 0.
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
