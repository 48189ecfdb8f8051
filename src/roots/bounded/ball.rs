//! Balls: numbers of W limbs that carry their errors.
//!
//! A ball is a midpoint, which is a [`Fixed`] number, and a radius, which counts ulps of the midpoint. It *holds* every real
//! number that is at most its radius away from its midpoint. There is one rule: **the result of an operation holds the
//! exact result for all numbers that its operands hold.** Each operation below says by how much it widens the radius,
//! and proves it; nothing outside this file and `unit.rs`, which has the rules for numbers in [−1, 1], turns a rounding into a
//! radius. What is not promised is the smallest ball.
//!
//! A radius is a non-negative double, perhaps infinite: then the ball holds every number, and no sign of it is known.
//! Midpoints must stay inside (−128, 128). Lists keep the sum of their midpoints' sizes at most 64, so that sums, values at
//! points of [0, 1], Bernstein coefficients and means stay inside.
//!
//! The laws are in `ball_laws.rs`, one for every rule.

use std::cell::OnceCell;

use malachite::Integer;

use super::super::sign_changes::Changes;
use super::bernstein::{BernsteinTable, scaled_to_bernstein};
use super::fixed::{Fixed, Fraction};

#[cfg(test)]
#[path = "ball_laws.rs"]
pub(super) mod laws;

/// **Lemma 1.** Let x be the double that at most 2^12 additions and multiplications of non-negative doubles give, each rounded
/// to the nearest, without underflow. Then the exact result is at most x · SLACK, also after the product with SLACK is rounded.
///
/// Proof. Each rounding changes a non-negative result by a factor of at least 1 − 2^(−53), so the exact result is at most
/// x (1 − 2^(−53))^(−4097) < x (1 + 2^(−40.9)), and SLACK = 1 + 2^(−40). Law: `sums_of_radii_are_covered`.
pub(super) const SLACK: f64 = 1.0 + 4096.0 * f64::EPSILON;

/// From 2^126 on, radii are compared with midpoints by their numbers of bits alone.
const LARGE_RADIUS: f64 = 85_070_591_730_234_615_865_843_651_857_942_052_864.0;

const TWO_TO_64: f64 = 18_446_744_073_709_551_616.0;

/// The sizes of the midpoints of a list add up to at most this number.
pub(super) const LARGEST_SUM: f64 = 64.0;

/// A double that is at least 2^k. It is exact for |k| ≤ 1000; it is 2^(−1000) for smaller k and infinite for larger ones.
pub(super) fn power_of_two(k: i64) -> f64 {
    match k {
        1001.. => f64::INFINITY,
        ..-1000 => power_of_two(-1000),
        _ => f64::from_bits((k + 1023).unsigned_abs() << 52),
    }
}

/// The radius of a ball whose midpoint is shifted down by s bits.
///
/// **Lemma 2.** If |x − mid| ≤ rad, then |x 2^(−s) − mid'| ≤ rad 2^(−s) + [s > 0], where mid' is mid · 2^(−s) cut towards 0.
///
/// Proof. The shift multiplies the old error by 2^(−s), whatever the sign of s. Only s > 0 cuts bits off, by less than one
/// ulp. Law: `a_shift_keeps_the_number_inside`.
fn radius_after_shift(radius: f64, s: i64) -> f64 {
    if radius == 0.0 {
        return f64::from(u8::from(s > 0));
    }
    (radius * power_of_two(-s) + f64::from(u8::from(s > 0))) * SLACK
}

/// A bound of the radius of the mean of two balls.
///
/// **Lemma 3.** If |x − a| ≤ r and |y − b| ≤ s, then |(x + y)/2 − m| ≤ (r + s)/2 + 1/2, where m is (a + b)/2 rounded down. The
/// double that is returned is at least that.
///
/// Proof. (a + b)/2 is a multiple of half an ulp, so rounding down loses 0 or 1/2. Of the three roundings of the doubles two
/// are covered by HALF, and the last one, of the final sum, by HALF for the part that is multiplied and by the other 1/2 of
/// the 1 that is added. Law: `means_keep_the_numbers_inside`.
#[inline]
fn radius_of_mean(r: f64, s: f64) -> f64 {
    const HALF: f64 = 0.5 * SLACK;
    (r + s) * HALF + 1.0
}

/// The sign of all numbers within `radius` of `mid`; `None` if they do not have one sign, or if this is not certain.
///
/// **Lemma 4.** A sign that is returned is that of every number that is held, none of which is 0.
///
/// Proof. |mid| is a whole number of ulps, so it is above the radius if and only if it is above the radius rounded down. A large
/// radius is below 2^(e + 1) for its exponent e, which is 1024 where it is infinite or not a number, and |mid| is at least
/// 2^(bits − 1). Law: `a_sign_is_that_of_all_numbers_inside`.
#[inline]
fn known_sign<const W: usize>(mid: Fixed<W>, radius: f64) -> Option<i8> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the radius is not negative, fits, and is rounded down"
    )]
    let is_larger = if radius < TWO_TO_64 {
        mid.is_larger_than((radius as u64).into())
    } else if radius < LARGE_RADIUS {
        mid.is_larger_than(radius as u128)
    } else {
        let exponent = (radius.to_bits() >> 52) as i64 - 1023;
        mid.bits() - 1 > exponent
    };
    is_larger.then_some(if mid.is_negative() { -1 } else { 1 })
}

/// A number of W limbs with its error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball<const W: usize> {
    pub(super) mid: Fixed<W>,
    /// The radius, in ulps.
    pub(super) radius: f64,
}

impl<const W: usize> Ball<W> {
    /// The exact number 0.
    pub(crate) const ZERO: Self = Self {
        mid: Fixed::ZERO,
        radius: 0.0,
    };

    /// The ball of value · 2^(−exponent), which must be in (−128, 128).
    ///
    /// **Lemma 5.** The radius is 0 if the bits of the value fit, else 1.
    ///
    /// Proof. Bits below the ulp are cut off, which are together less than one. Law: `integers_are_inside`.
    pub(crate) fn of_integer(value: &Integer, exponent: i64) -> Self {
        let (mid, is_cut) = Fixed::of_integer(value, exponent);
        Self {
            mid,
            radius: f64::from(u8::from(is_cut)),
        }
    }

    /// The sign of all numbers that the ball holds (Lemma 4).
    pub(crate) fn sign(self) -> Option<i8> {
        known_sign(self.mid, self.radius)
    }

    /// The midpoint, approximately.
    pub(crate) fn to_f64(self) -> f64 {
        self.mid.to_f64()
    }
}

/// A ball times 2^exponent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScaledBall<const W: usize> {
    pub(crate) ball: Ball<W>,
    pub(crate) exponent: i64,
}

impl<const W: usize> ScaledBall<W> {
    /// The exact number 0.
    pub(crate) const ZERO: Self = Self {
        ball: Ball::ZERO,
        exponent: 0,
    };

    /// The ball of an integer, with as many leading bits as fit.
    pub(crate) fn of_integer(value: &Integer) -> Self {
        let exponent = Fixed::<W>::bits_of(value);
        Self {
            ball: Ball::of_integer(value, exponent),
            exponent,
        }
    }

    /// About log₂ |value|; `None` if the ball may hold 0.
    pub(crate) fn log2(&self) -> Option<i64> {
        self.ball.sign()?;
        Some(self.ball.mid.bits() - Fixed::<W>::FRACTION_BITS + self.exponent)
    }
}

/// The coefficients c_0, …, c_d of a polynomial on [0, 1], in powers or in the Bernstein basis. In powers, the sizes of the
/// midpoints add up to at most 64; in the Bernstein basis, each is at most 64.
#[derive(Clone, Debug)]
pub(super) struct Balls<const W: usize> {
    mids: Vec<Fixed<W>>,
    radii: Vec<f64>,
    /// The radii of the Bernstein coefficients, which are the same for the polynomial in −y.
    bernstein_radii: OnceCell<Vec<f64>>,
    /// The radius of a value at any point, which is the same for the polynomial in −y.
    value_radius: OnceCell<f64>,
}

impl<const W: usize> Balls<W> {
    /// The balls of numbers, each times 2^(its shift), and all times one power of two that makes the sum of the sizes of the
    /// midpoints at most 64. `None` if all numbers are 0.
    ///
    /// **Lemma 6.** The midpoints fit, and each ball holds its number times that power of two.
    ///
    /// Proof. After the shift each of the n midpoints is below 2^room, and n 2^room ≤ 64 ([`Fixed::room_for`]). The balls by
    /// Lemma 2. Law: `aligned_numbers_are_inside`.
    pub(super) fn aligned(
        numbers: impl Iterator<Item = (ScaledBall<W>, i64)> + Clone,
    ) -> Option<Self> {
        let count = numbers.clone().count();
        let sizes = numbers
            .clone()
            .filter(|(number, _)| !number.ball.mid.is_zero());
        let largest = sizes.map(|(number, shift)| number.ball.mid.bits() + number.exponent + shift);
        let top = largest.max()? - Fixed::<W>::FRACTION_BITS - Fixed::<W>::room_for(count);
        let (mids, radii) = numbers
            .map(|(number, shift)| {
                let down = top - number.exponent - shift;
                let Ball { mid, radius } = number.ball;
                // The number 0 stays 0, however far it is shifted.
                let down_mid = if mid.is_zero() { 0 } else { down };
                (mid.shifted_down(down_mid), radius_after_shift(radius, down))
            })
            .unzip();
        Some(Self::new(mids, radii))
    }

    fn new(mids: Vec<Fixed<W>>, radii: Vec<f64>) -> Self {
        debug_assert_eq!(mids.len(), radii.len(), "a radius for each midpoint");
        Self {
            mids,
            radii,
            bernstein_radii: OnceCell::new(),
            value_radius: OnceCell::new(),
        }
    }

    /// The number of coefficients.
    pub(super) fn len(&self) -> usize {
        self.mids.len()
    }

    /// The sign of a coefficient (Lemma 4).
    pub(super) fn sign(&self, k: usize) -> Option<i8> {
        known_sign(self.mids[k], self.radii[k])
    }

    /// The midpoints, approximately.
    pub(super) fn to_doubles(&self) -> Vec<f64> {
        self.mids.iter().map(|c| c.to_f64()).collect()
    }

    /// Replaces every second coefficient, from the one at `first` on, by its opposite. This is exact.
    pub(super) fn negate_every_second(&mut self, first: usize) {
        for c in self.mids.iter_mut().skip(first).step_by(2) {
            *c = c.negated();
        }
    }

    /// The number of changes of sign in the sums c_0, c_0 + c_1, …, c_0 + … + c_d.
    ///
    /// **Lemma 7.** The k-th sum is wrong by at most the sum of the radii so far: sums of midpoints are exact.
    pub(super) fn changes_of_partial_sums(&self) -> Changes {
        let (mut sum, mut radius) = (Fixed::ZERO, 0.0);
        Changes::count(self.mids.iter().zip(&self.radii).map(|(c, own)| {
            sum = sum.plus(*c);
            radius += own;
            known_sign(sum, radius * SLACK)
        }))
    }

    /// The number of changes of sign of the coefficients.
    pub(super) fn changes(&self) -> Changes {
        Changes::count((0..self.len()).map(|k| self.sign(k)))
    }

    /// The radius of a value; it is at least Σ radii + W n (Lemma 8).
    pub(super) fn radius_of_a_value(&self) -> f64 {
        *self.value_radius.get_or_init(|| {
            let rounding = float(W) * float(self.len());
            (self.radii.iter().sum::<f64>() + rounding) * SLACK
        })
    }

    /// The value Σ c_i y^i.
    ///
    /// **Lemma 8.** Horner's rule with n coefficients is wrong by less than Σ radii + W n ulps for 0 ≤ y < 1.
    ///
    /// Proof. One step takes the sum s to s y + c. It multiplies the error of s by y < 1, and adds less than W for the product,
    /// which is cut, and the radius of c. Law: `values_are_inside`.
    pub(super) fn value(&self, y: &Fraction<W>) -> Ball<W> {
        let descending = self.mids.iter().rev();
        let mid = descending.fold(Fixed::ZERO, |sum, c| sum.times(y).plus(*c));
        let radius = self.radius_of_a_value();
        Ball { mid, radius }
    }

    /// The value, as [`Balls::value`], and an approximation of the derivative.
    pub(super) fn value_and_slope(&self, y: &Fraction<W>) -> (Ball<W>, f64) {
        // The slope may be d times larger than a sum that just fits.
        let bits = self.len().ilog2() + 1;
        let (mut mid, mut slope) = (Fixed::ZERO, Fixed::ZERO);
        for c in self.mids.iter().rev() {
            slope = slope.times(y).plus(mid.shifted_down(i64::from(bits)));
            mid = mid.times(y).plus(*c);
        }
        let radius = self.radius_of_a_value();
        (
            Ball { mid, radius },
            slope.to_f64() * f64::from(bits).exp2(),
        )
    }

    /// The Bernstein coefficients b_k = Σ_{i ≤ k} C(k, i)/C(d, i) c_i of a polynomial that is given in powers.
    ///
    /// **Lemma 9.** b_k is wrong by at most Σ_{i ≤ k} C(k, i)/C(d, i) r_i + W + 2, where r_i is the radius of c_i.
    ///
    /// Proof. C(d, k) b_k = Σ C(d − i, d − k) c_i is exact for the midpoints, and the r_i make an error that is the same sum
    /// of them. Its midpoint times 1/C(d, k) is wrong by less than W + 2 ([`scaled_to_bernstein`]). The sums of doubles have
    /// fewer than 2d roundings one after another, d ≤ 256 (Lemma 1). Law: `bernstein_coefficients_are_inside`.
    pub(super) fn to_bernstein(&self, table: &BernsteinTable<W>) -> Self {
        let radii = self.bernstein_radii.get_or_init(|| {
            let mut sums: Vec<f64> = self.radii.iter().rev().copied().collect();
            for start in (0..sums.len()).rev() {
                let rest = &mut sums[start..];
                for k in 1..rest.len() {
                    rest[k - 1] += rest[k];
                }
            }
            let rounding = float(W + 2);
            let sums = sums.into_iter().rev().zip(table.inverses());
            sums.map(|(sum, inverse)| (sum * inverse + rounding) * SLACK)
                .collect()
        });
        Self::new(scaled_to_bernstein(&self.mids, table), radii.clone())
    }

    /// The Bernstein coefficients on [0, 1/2] and on [1/2, 1] of a polynomial that is given by those on [0, 1], by De
    /// Casteljau's means. Each mean has the error of Lemma 3.
    pub(super) fn halves(self) -> [Self; 2] {
        let (mut high, mut high_radii) = (self.mids, self.radii);
        let mut low = Vec::with_capacity(high.len());
        let mut low_radii = Vec::with_capacity(high.len());
        for left in (0..high.len()).rev() {
            low.push(high[0]);
            low_radii.push(high_radii[0]);
            for k in 0..left {
                high[k] = high[k].mean(high[k + 1]);
            }
            for k in 0..left {
                high_radii[k] = radius_of_mean(high_radii[k], high_radii[k + 1]);
            }
        }
        [Self::new(low, low_radii), Self::new(high, high_radii)]
    }
}

/// A small count as a double.
#[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
pub(super) fn float(count: usize) -> f64 {
    count as f64
}
