//! Certified real roots in bounded arithmetic.
//!
//! The coefficients become balls of W limbs (`ball.rs`), and only signs that are certain for all numbers of a ball are used. So
//! every result is proved: all real roots, all simple, each between two bounds. If W limbs are not enough, there is no result,
//! and the caller takes more limbs or exact arithmetic.
//!
//! With x = ±2^s y the real axis is cut into four pieces: y in (0, 1) and 1/y in (0, 1), for either sign, where s is chosen so
//! that the roots have mean size 1. On each piece Laguerre's rule, or Descartes' rule in the Bernstein basis, isolates the
//! roots, and Newton's method encloses them.

mod ball;
mod bernstein;
#[cfg(test)]
mod draw;
mod fixed;
#[cfg(test)]
mod laws;
mod newton;
mod search;
mod signed;
mod unit;

use std::cell::LazyCell;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::DivRound;
use malachite::base::rounding_modes::RoundingMode;

use ball::Balls;
pub(crate) use ball::ScaledBall;
use bernstein::BernsteinTable;
#[cfg(test)]
pub(crate) use draw::Draw;
use fixed::Fraction;
use search::IsolatingInterval;
pub(crate) use search::Unproved;
pub(crate) use unit::{Coefficients, UnitBall, UnitBalls, rotations};

use crate::error::Invariant;
use crate::exact::Dyadic;
use crate::poly::IntegerPolynomial;

/// The largest degree; beyond it the tables of weights and the d² operations are too large.
const MAX_DEGREE: usize = 256;

/// A simple root ±2^s y or ±2^s / y, with `low` < y < `high`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoundedRoot<const W: usize> {
    pub(crate) is_negative: bool,
    pub(crate) is_inverted: bool,
    /// The exponent s.
    pub(crate) scale: i64,
    pub(crate) low: Fraction<W>,
    pub(crate) high: Fraction<W>,
    /// The sign of the polynomial for x slightly below the root.
    sign_below: i8,
}

/// The relative length of an enclosure from which a double is rounded: 58 bits. For one root in 32 such an enclosure does not
/// determine the double of 53 bits; mostly the enclosure is shorter.
pub(crate) const FOR_DOUBLES: f64 = 3.469_446_951_953_614e-18;
/// The relative length of an enclosure that an exact root refines further: 12 bits.
const FOR_REFINEMENT: f64 = 2.441_406_25e-4;

/// Finds all real roots of Σ c_i x^i in no order, each enclosed in an interval of a relative length of about `longest`.
///
/// Cost: 2d² additions of numbers with W limbs and d bits, fewer if Laguerre's rule decides; d²/2 means of W limbs for every
/// interval of the search; and about 10 d products for each root.
///
/// # Errors
/// An error if W limbs do not prove that these are all roots and that they are simple, for example if the first or the last
/// coefficient may be 0.
pub(crate) fn roots_of<const W: usize>(
    coefficients: &[ScaledBall<W>],
    longest: f64,
) -> Result<Vec<BoundedRoot<W>>, Unproved> {
    let [first, .., last] = coefficients else {
        // A constant other than 0 has no roots.
        let is_constant = coefficients.first().is_some_and(|c| c.log2().is_some());
        return is_constant.then(Vec::new).ok_or(Unproved::Bits);
    };
    let degree = coefficients.len() - 1;
    if degree > MAX_DEGREE {
        return Err(Unproved::Close);
    }
    let log2 = |c: &ScaledBall<W>| c.log2().ok_or(Unproved::Bits);
    let by = degree as i64;
    // s is rounded to nearest. Otherwise roots of size 1 would be treated as roots of size 1/2, which takes d bits more.
    let scale = (log2(first)? - log2(last)? + by / 2).div_euclid(by);
    let table = LazyCell::new(|| BernsteinTable::of_degree(degree));
    let mut roots = Vec::new();
    for is_inverted in [false, true] {
        let mut piece = Piece {
            coefficients,
            scale,
            is_negative: false,
            is_inverted,
        };
        let mut polynomial = piece.polynomial();
        for is_negative in [false, true] {
            if is_negative {
                piece.is_negative = true;
                polynomial.negate_every_second(piece.first_odd());
            }
            let places = match search::by_partial_sums(&polynomial)? {
                Some(places) => places,
                None => search::isolate(polynomial.to_bernstein(&table))?,
            };
            for place in places {
                let root = piece.enclose(&polynomial, &place, longest);
                roots.push(root.ok_or(Unproved::Bits)?);
            }
        }
    }
    Ok(roots)
}

/// One of the four pieces of the axis: x = ±2^s y or x = ±2^s / y, with 0 < y < 1.
#[derive(Clone, Copy)]
struct Piece<'a, const W: usize> {
    coefficients: &'a [ScaledBall<W>],
    scale: i64,
    is_negative: bool,
    is_inverted: bool,
}

impl<const W: usize> Piece<'_, W> {
    /// The polynomial f in terms of y, times a power of y and a constant.
    fn polynomial(&self) -> Balls<W> {
        let scale = self.scale;
        let scaled = |(i, c): (usize, &ScaledBall<W>)| (*c, scale * i as i64);
        let terms = self.coefficients.iter().enumerate().map(scaled);
        let aligned = if self.is_inverted {
            Balls::aligned(terms.rev())
        } else {
            Balls::aligned(terms)
        };
        let mut polynomial = aligned.invariant("the first coefficient is not 0");
        if self.is_negative {
            polynomial.negate_every_second(self.first_odd());
        }
        polynomial
    }

    /// The index in [`Piece::polynomial`] of the first odd power of x.
    fn first_odd(&self) -> usize {
        if self.is_inverted {
            self.coefficients.len() % 2
        } else {
            1
        }
    }

    /// The root that is alone in `place`; `polynomial` must be that of this piece.
    fn enclose(
        &self,
        polynomial: &Balls<W>,
        place: &IsolatingInterval,
        longest: f64,
    ) -> Option<BoundedRoot<W>> {
        let guess = polynomial.guess(place);
        // Near 0 the limbs of the high powers would be empty. So y = 2^(−drop) z, with z between 1/4 and 1.
        let drop = drop_to_quarter(guess);
        let bounds = place.bounds().map(|end| end.shifted_up(drop));
        let guess = Fraction::from_f64(guess * f64::from(drop).exp2());
        let (low, high, scale) = if drop == 0 {
            let [low, high] = polynomial.enclose(&guess, bounds, place.sign_low, longest)?;
            (low, high, self.scale)
        } else {
            let drop = i64::from(drop);
            let sign = if self.is_inverted { 1 } else { -1 };
            let scale = self.scale + sign * drop;
            let local = Piece { scale, ..*self }.polynomial();
            let [low, high] = local.enclose(&guess, bounds, place.sign_low, longest)?;
            (low, high, scale)
        };
        Some(BoundedRoot {
            is_negative: self.is_negative,
            is_inverted: self.is_inverted,
            scale,
            low,
            high,
            // x increases or decreases with y.
            sign_below: if self.is_negative == self.is_inverted {
                place.sign_low
            } else {
                -place.sign_low
            },
        })
    }
}

/// The largest k ≥ 0 with 2^k y < 1/2, for a y between 0 and 1.
fn drop_to_quarter(y: f64) -> u32 {
    let mut drop = 0;
    let mut y = 2.0 * y;
    while y < 0.5 && drop < 1000 {
        y *= 2.0;
        drop += 1;
    }
    drop
}

/// All real roots of f in no order, as (low, high, sign of f at low). Each interval holds one root, which is simple; f ≠ 0 at
/// both ends, and the intervals are disjoint. They are as short as W limbs allow, at most 2^−11 of their size.
///
/// # Errors
/// An error if W limbs do not prove this.
pub(crate) fn bounded_roots<const W: usize>(
    f: &IntegerPolynomial,
) -> Result<Vec<(Dyadic, Dyadic, i8)>, Unproved> {
    let coefficients = f.coefficients_asc();
    if coefficients.len() > MAX_DEGREE + 1 {
        return Err(Unproved::Close);
    }
    let balls: Vec<_> = coefficients.iter().map(ScaledBall::of_integer).collect();
    let roots = roots_of::<W>(&balls, FOR_REFINEMENT)?.into_iter();
    Ok(roots.map(BoundedRoot::to_dyadic).collect())
}

impl<const W: usize> BoundedRoot<W> {
    /// Bounds of the root itself, and the sign at the lower bound.
    fn to_dyadic(self) -> (Dyadic, Dyadic, i8) {
        let width = 64 * W as u64;
        let exponent = self.scale - 64 * W as i64;
        let (low, high) = (self.low.to_integer(), self.high.to_integer());
        let (low, high) = if self.is_inverted {
            // 1/y is rounded outwards. This moves x by less than 2^(−64W), and y by less than that times y². The sign at the
            // new end is that at the old one, because an enclosure is strictly inside its place (`newton::is_inside`).
            let one = Integer::from(1) << (2 * width);
            (&one / high, one.div_round(low, RoundingMode::Ceiling).0)
        } else {
            (low, high)
        };
        let (low, high) = (Dyadic::new(low, exponent), Dyadic::new(high, exponent));
        if self.is_negative {
            (high.negated(), low.negated(), self.sign_below)
        } else {
            (low, high, self.sign_below)
        }
    }
}
