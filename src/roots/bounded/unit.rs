//! Balls of numbers in [−1, 1]: the rules of `ball.rs` for [`Signed`] midpoints.
//!
//! The numbering of the lemmas goes on from that file. The laws are in `unit_laws.rs`, one for every rule.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::FloorSqrt;
use malachite::base::num::basic::traits::One;

use super::ball::{Ball, LARGEST_SUM, SLACK, float, power_of_two};
use super::fixed::{Fixed, Fraction};
use super::signed::Signed;
use crate::error::Invariant;
use crate::exact::Rational;

#[cfg(test)]
#[path = "unit_laws.rs"]
mod laws;

/// A number in [−1, 1] with its error: a midpoint in (−1, 1), and a radius in units of 2^(−64W).
#[derive(Clone, Copy, Debug)]
pub(crate) struct UnitBall<const W: usize> {
    mid: Signed<W>,
    radius: f64,
}

impl<const W: usize> UnitBall<W> {
    /// The number 1; the largest fraction is one unit below it.
    pub(crate) const ONE: Self = Self {
        mid: Signed::LARGEST,
        radius: 1.0,
    };

    /// The exact number 0.
    pub(crate) const ZERO: Self = Self {
        mid: Signed::ZERO,
        radius: 0.0,
    };

    /// The quotient p / q, for |p| ≤ |q| ≠ 0.
    ///
    /// **Lemma 10.** The quotient is cut by less than one unit, or is ±1 and replaced by the largest fraction. Law:
    /// `quotients_are_inside`.
    pub(crate) fn quotient(p: &Integer, q: &Integer) -> Self {
        Self {
            mid: Signed::quotient(p, q),
            radius: 1.0,
        }
    }

    /// The product of two numbers in [−1, 1].
    ///
    /// **Lemma 11.** It is wrong by at most r + s + W units.
    ///
    /// Proof. x y − a b = x (y − b) + b (x − a) with |x| ≤ 1, |b| < 1, and the product of the midpoints is cut by less than
    /// W. Law: `products_are_inside`.
    pub(crate) fn times(&self, other: &Self) -> Self {
        Self {
            mid: self.mid.times(&other.mid),
            radius: (self.radius + other.radius + float(W)) * SLACK,
        }
    }

    /// The ball of a rational number in [−1, 1] that is known within 2^(−64W).
    pub(crate) fn near(value: &Rational) -> Self {
        let quotient = Self::quotient(&value.numerator(), &value.denominator());
        quotient.widened(1.0)
    }

    /// The ball of a double in (−1, 1).
    ///
    /// **Lemma 15.** Bits below the last unit are cut off, which are together less than one. Law: `doubles_are_inside`.
    pub(crate) fn of_double(value: f64) -> Self {
        let mid = Signed {
            size: Fraction::from_f64(value.abs()),
            is_negative: value < 0.0,
        };
        Self { mid, radius: 1.0 }
    }

    /// The quotient of two numbers; it must be in [−1, 1], and the divisor must be positive. `None` if the ball of the divisor does
    /// not show that, or if the midpoints do not.
    ///
    /// **Lemma 19.** Let a and b be the midpoints, with errors r and s, and |a| ≤ b. The quotient is wrong by at most (r + s)/(b − s)
    /// times 2^(64W) units, and its cut adds one.
    ///
    /// Proof. x/y − a/b = (x − a)/y + (a/b)(b − y)/y with |a/b| ≤ 1 and y ≥ b − s. Law: `quotients_of_balls_are_inside`.
    pub(crate) fn over(&self, divisor: &Self) -> Option<Self> {
        let b = divisor.mid.size.to_f64();
        // In units of 1, rounded down: the double of b is b or a neighbour of the nearest one.
        let below = b * (2.0 - SLACK) - divisor.radius * power_of_two(-64 * W as i64) * SLACK;
        if divisor.mid.is_negative || below <= 0.0 || self.mid.size > divisor.mid.size {
            return None;
        }
        let [p, q] = [self, divisor].map(|ball| ball.mid.size.to_integer());
        let mid = Signed {
            size: Fraction::quotient(&p, &q),
            is_negative: self.mid.is_negative,
        };
        let radius = ((self.radius + divisor.radius) / below + 1.0) * SLACK;
        Some(Self { mid, radius })
    }

    /// The square root of a number in [0, 1]. `None` if the midpoint is not positive.
    ///
    /// **Lemma 20.** The root of x is wrong by at most r/√a units for the midpoint a, and its cut adds one.
    ///
    /// Proof. |√x − √a| = |x − a|/(√x + √a) ≤ |x − a|/√a. Law: `roots_are_inside`.
    pub(crate) fn root(&self) -> Option<Self> {
        let approximate = self.mid.size.to_f64().sqrt();
        if self.mid.is_negative || approximate <= 0.0 {
            return None;
        }
        let square = self.mid.size.to_integer() << (64 * W as u64);
        let root = Integer::from(square.unsigned_abs_ref().floor_sqrt());
        let one = Integer::ONE << (64 * W as u64);
        let mid = Signed {
            size: Fraction::quotient(&root, &one),
            is_negative: false,
        };
        let radius = (self.radius / approximate + 1.0) * SLACK;
        Some(Self { mid, radius })
    }

    /// The same ball with a radius that is larger by this many units.
    pub(crate) fn widened(self, units: f64) -> Self {
        Self {
            radius: (self.radius + units) * SLACK,
            ..self
        }
    }

    /// The opposite number.
    pub(crate) fn negated(self) -> Self {
        Self {
            mid: self.mid.negated(),
            ..self
        }
    }

    /// The sum of two numbers, which must be in [−1, 1].
    ///
    /// **Lemma 16.** It is wrong by at most r + s + 1 units.
    ///
    /// Proof. A sum of midpoints inside (−1, 1) is exact. Any other is replaced by the fraction ±(1 − 2^(−64W)), which is
    /// closer to the true sum than the sum of the midpoints, unless the true one is beyond it, by at most one unit. Law:
    /// `sums_are_inside`.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self {
            mid: self.mid.plus(&other.mid),
            radius: (self.radius + other.radius + 1.0) * SLACK,
        }
    }

    /// The number divided by 2^bits.
    ///
    /// **Lemma 17.** It is wrong by at most r 2^(−bits) + 1 units: the shift cuts less than one. Law: `shifts_are_inside`.
    pub(crate) fn shifted_down(self, bits: u32) -> Self {
        Self {
            mid: self.mid.shifted_down(bits),
            radius: (self.radius * power_of_two(-i64::from(bits)) + 1.0) * SLACK,
        }
    }

    /// The number y = 2^bits x − k in [0, 1), and the whole number k, for a number x in [0, 1); bits < 64.
    ///
    /// **Lemma 18.** The midpoint is exact, and its error is r 2^bits. The numbers that the ball of y holds may be outside of
    /// [0, 1) by that much. Law: `digits_are_inside`.
    pub(crate) fn digits(self, bits: u32) -> (u64, Self) {
        let (whole, size) = self.mid.size.split(bits);
        let mid = Signed {
            size,
            is_negative: false,
        };
        let radius = self.radius * power_of_two(i64::from(bits)) * SLACK;
        (whole, Self { mid, radius })
    }

    /// The midpoint as the nearest double or one of its neighbours.
    pub(crate) fn to_f64(self) -> f64 {
        let size = self.mid.size.to_f64();
        if self.mid.is_negative { -size } else { size }
    }

    /// The ends of the ball.
    pub(crate) fn bounds(&self) -> [Rational; 2] {
        let size = self.mid.size.to_integer();
        let mid = if self.mid.is_negative { -size } else { size };
        let radius =
            Rational::try_from(self.radius).invariant("a radius that is written is finite");
        [-&radius, radius].map(|radius| {
            (Rational::whole(&mid) + radius) * Rational::from_dyadic(Integer::ONE, -64 * W as i64)
        })
    }
}

/// cos mθ and sin mθ for m = 0, …, `last`, from balls that hold cos θ and sin θ.
///
/// **Lemma 12.** Let Z and Y be complex numbers of modulus 1, and z and y computed ones, no farther from them than R and S
/// units. The computed product of z and y is no farther from Z Y than R + S (1 + R 2^(−64W)) + 3W + 1 units.
///
/// Proof. Z Y − z y = Y (Z − z) + z (Y − y), and |z| ≤ 1 + R 2^(−64W). Four products are cut, each by less than W, so either
/// coordinate is wrong by less than 2W more, and the point by less than 2√2 W < 3W. A coordinate that is at least 1 becomes
/// the largest fraction, which is no farther from the true one, which is at most 1, than before or than 1 unit; that happens
/// to one of the two coordinates at most. Law: `rotations_are_inside`.
pub(crate) fn rotations<const W: usize>(
    [cos, sin]: [UnitBall<W>; 2],
    last: usize,
) -> [Vec<UnitBall<W>>; 2] {
    let step_radius = (cos.radius + sin.radius) * SLACK;
    let (mut cosines, mut sines) = (vec![UnitBall::ONE], vec![UnitBall::ZERO]);
    let (mut c, mut s, mut radius) = (cos.mid, sin.mid, step_radius);
    for _ in 0..last {
        cosines.push(UnitBall { mid: c, radius });
        sines.push(UnitBall { mid: s, radius });
        (c, s) = (
            c.times(&cos.mid).plus(&s.times(&sin.mid).negated()),
            s.times(&cos.mid).plus(&c.times(&sin.mid)),
        );
        let longer = 1.0 + radius * power_of_two(-64 * W as i64);
        radius = (radius + step_radius * longer + float(3 * W + 1)) * SLACK;
    }
    [cosines, sines]
}

/// The values of functions at one point, each in [−1, 1].
#[derive(Debug)]
pub(crate) struct UnitBalls<const W: usize> {
    mids: Vec<Signed<W>>,
    /// A number that is at least the radius of each value.
    radius: f64,
}

impl<const W: usize> FromIterator<UnitBall<W>> for UnitBalls<W> {
    fn from_iter<I: IntoIterator<Item = UnitBall<W>>>(balls: I) -> Self {
        let mut radius = 0.0;
        let mids = balls.into_iter().map(|ball| {
            radius = f64::max(radius, ball.radius);
            ball.mid
        });
        let mids = mids.collect();
        Self { mids, radius }
    }
}

/// The coefficients of a sum Σ c_i b_i over numbers b_i in [−1, 1]. The sizes of their midpoints add up to at most 64.
#[derive(Debug)]
pub(crate) struct Coefficients<const W: usize> {
    /// The midpoints, divided by 2^8.
    mids: Vec<Signed<W>>,
    /// The sum of the radii.
    radius: f64,
}

impl<const W: usize> Coefficients<W> {
    /// The balls of integers, all divided by the power of two that is returned with them.
    ///
    /// **Lemma 13.** The midpoints fit, and each ball holds its quotient. The proof is that of Lemmas 5 and 6.
    pub(crate) fn of_integers<'a>(
        integers: impl Iterator<Item = &'a Integer> + Clone,
    ) -> (Self, i64) {
        let bits = integers.clone().map(Fixed::<W>::bits_of).max();
        let room = Fixed::<W>::room_for(integers.clone().count());
        let exponent = bits.map_or(0, |bits| bits - room);
        // Each radius is 0 or 1, so their sum is exact.
        let mut radius = 0.0;
        let mid = |value| {
            let ball = Ball::of_integer(value, exponent);
            radius += ball.radius;
            ball.mid.over_256()
        };
        let mids = integers.map(mid).collect();
        (Self { mids, radius }, exponent)
    }

    /// The sum Σ c_i b_i, where b_i is the value at the i-th of `indices`.
    ///
    /// **Lemma 14.** If the b_i are wrong by at most R units of 2^(−64W), that is R/256 ulps, the sum of n products is wrong
    /// by at most 64 R/256 + Σ r_i + W n ulps.
    ///
    /// Proof. x y − c b = y (x − c) + c (y − b) with |y| ≤ 1 and Σ |c| ≤ 64, and each product is rounded by less than W ulps.
    /// Law: `sums_of_products_are_inside`.
    pub(crate) fn combination(
        &self,
        values: &UnitBalls<W>,
        indices: impl Iterator<Item = usize>,
    ) -> Ball<W> {
        let terms = self.mids.iter().zip(indices);
        let mid = terms.fold(Fixed::ZERO, |sum, (c, i)| {
            sum.plus_product(c, &values.mids[i])
        });
        let rounding = float(W) * float(self.mids.len());
        let radius = LARGEST_SUM * values.radius / 256.0 + self.radius + rounding;
        Ball {
            mid,
            radius: radius * SLACK,
        }
    }
}
