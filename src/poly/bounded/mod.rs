//! Certified real roots in a bounded number of bits.
//!
//! The coefficients are cut to fixed-point numbers of W limbs with a bound of their errors, and every sign that is used
//! is larger than the error of the value. So what is found is proved: all real roots, simple, each between two bounds. Where
//! W limbs do not suffice nothing is found, and the caller takes more or goes to exact arithmetic.
//!
//! With x = ±2^s y the axis is four intervals: y in (0, 1) and 1/y in (0, 1) for either sign, s such that the roots have
//! mean size 1. On each of them Laguerre's rule or Descartes' rule in the Bernstein basis isolates, Newton's method encloses.

mod bernstein;
mod fixed;
mod newton;
mod search;
mod signed;

use std::cell::LazyCell;

use bernstein::inverse_binomials;
pub(crate) use fixed::Fixed;
use fixed::Fraction;
use malachite::Integer;
use malachite::base::num::arithmetic::traits::DivRound;
use malachite::base::rounding_modes::RoundingMode;
use newton::OnUnitInterval;
pub(crate) use search::Unproved;
use search::{Isolated, whole};
pub(crate) use signed::{Signed, rotations};

use super::IntegerPolynomial;
use super::isolate::Changes;
use crate::exact::Dyadic;

/// Beyond this degree the tables of weights and d² are too much.
const MAX_DEGREE: usize = 256;

/// Errors are sums and products of positive doubles, less than 4d of them one after another, each right up to a factor of
/// 1 ± 2^(−53): that times all of them is covered, 1 + 2^(−40).
const SLACK: f64 = 1.000_000_000_000_909_5;
/// 2^120 ulps: errors that leave nothing, but do not overflow either.
const LARGEST_ERROR: f64 = 1.329_227_995_784_916e36;

/// A coefficient: mantissa · 2^exponent, known up to less than `error` ulps of the mantissa.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Truncated<const W: usize> {
    pub(crate) mantissa: Fixed<W>,
    pub(crate) exponent: i64,
    pub(crate) error: u64,
}

impl<const W: usize> Truncated<W> {
    /// An integer, cut.
    pub(crate) fn new(value: &Integer) -> Self {
        let (mantissa, exponent) = Fixed::normalized(value);
        Self {
            mantissa,
            exponent,
            error: 1,
        }
    }

    /// 0.
    pub(crate) const ZERO: Self = Self {
        mantissa: Fixed::ZERO,
        exponent: 0,
        error: 0,
    };

    /// About log₂ |value|; `None` if it may be 0.
    fn size(&self) -> Option<i64> {
        self.mantissa.known_sign(self.error.into())?;
        Some(self.mantissa.bits() - Fixed::<W>::fraction_bits() + self.exponent)
    }
}

/// A simple root ±2^s y or ±2^s / y, with `low` < y < `high`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoundedRoot<const W: usize> {
    pub(crate) is_negative: bool,
    pub(crate) is_inverted: bool,
    /// s.
    pub(crate) scale: i64,
    pub(crate) low: Fraction<W>,
    pub(crate) high: Fraction<W>,
    /// The sign of the polynomial towards smaller x.
    sign_below: i8,
}

/// Relative lengths of enclosures: 58 bits, from which one in 32 cannot be rounded to a double of 53, and mostly there are more.
pub(crate) const FOR_DOUBLES: f64 = 3.469_446_951_953_614e-18;
/// The same where an exact root goes on from there: 12 bits.
const FOR_REFINEMENT: f64 = 2.441_406_25e-4;

/// All real roots of Σ c_i x^i, each enclosed in an interval that is about `longest` times as long, in no order.
///
/// Cost: 2d² additions of W limbs and d bits, less where Laguerre's rule decides, d²/2 means of W limbs for every interval
/// of the search, some 10 d products for a root.
///
/// # Errors
/// If W limbs do not prove that they are all and simple: for one if the first or the last coefficient may be 0.
pub(crate) fn roots_of<const W: usize>(
    coefficients: &[Truncated<W>],
    longest: f64,
) -> Result<Vec<BoundedRoot<W>>, Unproved> {
    let degree = coefficients.len().saturating_sub(1);
    if coefficients.is_empty() || degree > MAX_DEGREE {
        return Err(Unproved::Close);
    }
    let size = |i: usize| coefficients[i].size().ok_or(Unproved::Bits);
    let (first, last) = (size(0)?, size(degree)?);
    if degree == 0 {
        return Ok(Vec::new());
    }
    let by = i64::try_from(degree).unwrap_or(i64::MAX);
    // To the nearest: else roots of size 1 are found as those of size 1/2, which takes d bits more.
    let scale = (first - last + by / 2).div_euclid(by);
    let inverses = LazyCell::new(|| inverse_binomials(degree));
    let mut roots = Vec::new();
    for is_inverted in [false, true] {
        let mut piece = Piece {
            coefficients,
            scale,
            is_negative: false,
            is_inverted,
        };
        let mut polynomial = piece.polynomial().ok_or(Unproved::Bits)?;
        let mut errors = None;
        for is_negative in [false, true] {
            if is_negative {
                piece.is_negative = true;
                polynomial.reflect(is_inverted);
            }
            let places = match polynomial.changes_of_partial_sums() {
                Changes::None => continue,
                Changes::One => vec![polynomial.only_root()?],
                Changes::More => {
                    let errors =
                        errors.get_or_insert_with(|| polynomial.bernstein_errors(&inverses));
                    search::isolate(polynomial.to_bernstein(&inverses, errors))?
                }
            };
            for place in places {
                let root = piece.enclose(&polynomial, &place, longest);
                roots.push(root.ok_or(Unproved::Bits)?);
            }
        }
    }
    Ok(roots)
}

/// A quarter of the axis: x = ±2^s y or x = ±2^s / y, with 0 < y < 1.
#[derive(Clone, Copy)]
struct Piece<'a, const W: usize> {
    coefficients: &'a [Truncated<W>],
    scale: i64,
    is_negative: bool,
    is_inverted: bool,
}

impl<const W: usize> Piece<'_, W> {
    /// f as a polynomial in y, times a power of y, and of two that makes Σ |c_i| at most 64.
    fn polynomial(&self) -> Option<OnUnitInterval<W>> {
        let length = self.coefficients.len();
        let exponent = |i: usize| {
            let power = i64::try_from(i).unwrap_or(i64::MAX);
            self.coefficients[i].exponent + self.scale * power
        };
        let sizes = (0..length).map(|i| self.coefficients[i].mantissa.bits() + exponent(i));
        let excess = sizes.max()? - Fixed::<W>::fraction_bits() - Fixed::<W>::room_for(length);
        let mut errors = Vec::with_capacity(length);
        let mut result = Vec::with_capacity(length);
        for k in 0..length {
            let i = if self.is_inverted { length - 1 - k } else { k };
            let c = &self.coefficients[i];
            let down = excess - exponent(i);
            let cut = c.mantissa.shifted_down(down);
            let flipped = self.is_negative && !i.is_multiple_of(2);
            result.push(if flipped { cut.negated() } else { cut });
            errors.push(error_after(c.error, down));
        }
        let total: f64 = errors.iter().sum();
        // Far from overflow, whatever is added to it.
        (total < LARGEST_ERROR).then_some(OnUnitInterval {
            coefficients: result,
            errors,
            error: whole(total * SLACK),
        })
    }

    /// The root in `place`; `polynomial` is this piece's.
    fn enclose(
        &self,
        polynomial: &OnUnitInterval<W>,
        place: &Isolated,
        longest: f64,
    ) -> Option<BoundedRoot<W>> {
        let guess = polynomial.guess(place);
        // Near 0 the high powers would leave their limbs empty: y = 2^(−drop) z, with z between 1/4 and 1.
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
            let local = Piece { scale, ..*self }.polynomial()?;
            let [low, high] = local.enclose(&guess, bounds, place.sign_low, longest)?;
            (low, high, scale)
        };
        Some(BoundedRoot {
            is_negative: self.is_negative,
            is_inverted: self.is_inverted,
            scale,
            low,
            high,
            // x grows with y, or falls.
            sign_below: if self.is_negative == self.is_inverted {
                place.sign_low
            } else {
                -place.sign_low
            },
        })
    }
}

/// The error, in ulps, of what was known up to `error` ulps and is shifted down, and cut.
#[expect(clippy::cast_precision_loss, reason = "SLACK covers it")]
fn error_after(error: u64, down: i64) -> f64 {
    error as f64 * power_of_two(-down) + 1.0
}

/// 2^k, or what is near enough to 0 or ∞.
fn power_of_two(k: i64) -> f64 {
    f64::from_bits(u64::try_from(k.clamp(-1000, 1000) + 1023).unwrap_or(0) << 52)
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

/// All real roots of f, as (low, high, sign of f at low) with one simple root between, f ≠ 0 at both and the intervals
/// disjoint, short as W limbs tell, at most 2^−11 of its size; in no order.
///
/// # Errors
/// If W limbs do not prove that.
pub(crate) fn bounded_roots<const W: usize>(
    f: &IntegerPolynomial,
) -> Result<Vec<(Dyadic, Dyadic, i8)>, Unproved> {
    let coefficients = f.coefficients_asc();
    if coefficients.len() > MAX_DEGREE + 1 {
        return Err(Unproved::Close);
    }
    let truncated: Vec<Truncated<W>> = coefficients.iter().map(Truncated::new).collect();
    let roots = roots_of(&truncated, FOR_REFINEMENT)?.into_iter();
    Ok(roots.map(BoundedRoot::to_dyadic).collect())
}

impl<const W: usize> BoundedRoot<W> {
    /// Bounds of the root itself, and the sign at the lower one.
    fn to_dyadic(self) -> (Dyadic, Dyadic, i8) {
        let width = 64 * W as u64;
        let exponent = self.scale - i64::try_from(width).unwrap_or(0);
        let (low, high) = (self.low.to_integer(), self.high.to_integer());
        let (low, high) = if self.is_inverted {
            // 1/y, rounded outwards: that moves y by less than 2^(−64W), for which there is room.
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
