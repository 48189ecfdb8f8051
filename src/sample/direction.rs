//! Exact rational directions near given angles.

use std::f64::consts::{FRAC_PI_2, PI};
use std::str::FromStr;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Square;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

use super::unit_vector::IntegerVector;
use crate::error::{Error, Invariant, Result};
use crate::exact::{Rational, WrittenAngle};

/// tan(δ/2) is rounded to this many bits after the point, so a direction is within 2⁻⁵³ of its
/// nominal angle.
const TANGENT_BITS: u32 = 53;

impl IntegerVector<2> for Direction {
    fn over_common_denominator(&self) -> ([Integer; 2], Integer) {
        ([self.u.clone(), self.v.clone()], self.w.clone())
    }
}

/// An exact unit vector `(u, v) = (U/W, V/W)`, with integers `U² + V² = W²`, near a nominal angle.
///
/// Let δ be the difference between the angle and the nearest multiple of a right angle. The direction has `tan(δ/2) = m/2⁵³`,
/// with the integer m for which it is nearest to the nominal angle. So the multiples of a right angle are exact, and along any
/// such direction the distance r is a rational multiple of the coordinates.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::sample::Direction;
/// let up = Direction::from_degrees(&Rational::from(90));
/// assert_eq!((up.u(), up.v()), (Rational::zero(), Rational::one()));
/// let d = Direction::from_radians(0.3);
/// assert_eq!(&d.u() * &d.u() + &d.v() * &d.v(), Rational::one());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Direction {
    theta: f64,
    u: Integer,
    v: Integer,
    w: Integer,
}

impl Direction {
    /// Beyond this many radians a double determines its angle modulo 2π too poorly.
    pub const LARGEST_RADIANS: f64 = 1e9;

    /// The direction nearest to the angle `theta`, in radians from +x towards +y, of at most
    /// [`Direction::LARGEST_RADIANS`].
    #[must_use]
    pub fn from_radians(theta: f64) -> Self {
        /// Of larger multiples the rounding may be seen.
        const MOST_AXES: f64 = 1000.0;
        /// π/2 without [`FRAC_PI_2`].
        const REST: f64 = 6.123_233_995_736_766e-17;
        let quarters = (theta / FRAC_PI_2).round();
        // A multiple of a right angle, as programs compute it in doubles, stands for the axis. Else no product is rounded.
        let is_axis = quarters.abs() <= MOST_AXES && (theta - quarters * FRAC_PI_2).abs() == 0.0;
        let delta = match is_axis {
            true => 0.0,
            false => f64::mul_add(-quarters, REST, f64::mul_add(-quarters, FRAC_PI_2, theta)),
        };
        let delta = delta.clamp(-1.0, 1.0);
        Self::from_quarter(theta, quarters.rem_euclid(4.0), delta)
    }

    /// The direction nearest to an angle in degrees.
    #[must_use]
    pub fn from_degrees(degrees: &Rational) -> Self {
        let theta = degrees.to_f64() / 180.0 * PI;
        let quarters = Integer::rounding_from_rational(&(degrees / &Rational::from(90)));
        let rest = degrees - &(Rational::from(90) * Rational::whole(&quarters));
        let quarter = Rational::whole(quarters) / Rational::from(4);
        let quarter = (&quarter - &quarter.floor()) * Rational::from(4);
        Self::from_quarter(theta, quarter.to_f64(), rest.to_f64() / 180.0 * PI)
    }

    /// The `count` directions nearest to the angles 2πk/count.
    #[must_use]
    pub fn around(count: usize) -> Vec<Self> {
        let whole = Rational::whole(Integer::from(count));
        (0..count)
            .map(|k| {
                let turn = Rational::whole(Integer::from(k)) / &whole;
                Self::from_degrees(&(turn * Rational::from(360)))
            })
            .collect()
    }

    /// The direction of `quarter` right angles (0, 1, 2 or 3) plus `delta`.
    fn from_quarter(theta: f64, quarter: f64, delta: f64) -> Self {
        let scaled = (delta / 2.0).tan() * f64::from(TANGENT_BITS).exp2();
        let m = Integer::rounding_from(scaled, RoundingMode::Nearest).0;
        let q = Integer::ONE << TANGENT_BITS;
        let (c, s) = ((&q).square() - (&m).square(), (&m * &q) << 1u64);
        let w = (&q).square() + m.square();
        let (u, v) = if (0.5..1.5).contains(&quarter) {
            (-s, c)
        } else if (1.5..2.5).contains(&quarter) {
            (-c, -s)
        } else if (2.5..3.5).contains(&quarter) {
            (s, -c)
        } else {
            (c, s)
        };
        Self { theta, u, v, w }.reduced()
    }

    fn reduced(self) -> Self {
        let (u, v) = (self.u(), self.v());
        // u and v have the same denominator unless one of them is 0.
        let w = if v == Rational::zero() {
            u.denominator()
        } else {
            v.denominator()
        };
        let scale = Rational::whole(&w);
        Self {
            theta: self.theta,
            u: (u * &scale).numerator(),
            v: (v * scale).numerator(),
            w,
        }
    }

    /// The nominal angle in radians.
    #[must_use]
    pub fn theta(&self) -> f64 {
        self.theta
    }

    /// cos of the direction's angle, exactly.
    #[must_use]
    pub fn u(&self) -> Rational {
        Rational::from_integers(self.u.clone(), self.w.clone()).invariant("a length is not 0")
    }

    /// sin of the direction's angle, exactly.
    #[must_use]
    pub fn v(&self) -> Rational {
        Rational::from_integers(self.v.clone(), self.w.clone()).invariant("a length is not 0")
    }

    /// The integers (U, V, W).
    pub(crate) fn integers(&self) -> (&Integer, &Integer, &Integer) {
        (&self.u, &self.v, &self.w)
    }
}

impl FromStr for Direction {
    type Err = Error;

    /// Reads an angle: radians up to 10⁹ (`0.5`), a multiple of π (`pi/4`, `3*pi/2`, `2π`), or degrees (`45deg`, `45°`), in all
    /// the spellings of [`WrittenAngle`]. Multiples of π and degrees are exact.
    ///
    /// ```
    /// use stellate::sample::Direction;
    /// let right_angles = ["pi/2", "90deg", "90°", "-3π/2"];
    /// for text in right_angles {
    ///     assert_eq!(text.parse::<Direction>()?.v(), 1.into());
    /// }
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] for anything else.
    fn from_str(text: &str) -> Result<Self> {
        let radians = match text.parse() {
            Ok(WrittenAngle::Degrees(degrees)) => return Ok(Self::from_degrees(&degrees)),
            Ok(WrittenAngle::Plain(radians) | WrittenAngle::Radians(radians)) => radians.to_f64(),
            Err(_) => f64::NAN,
        };
        if radians.abs() <= Self::LARGEST_RADIANS {
            Ok(Self::from_radians(radians))
        } else {
            let message =
                "expected radians up to 1e9 such as 0.5 or pi/6, or degrees such as 30deg";
            Err(Error::Usage(message.into()))
        }
    }
}

trait RoundRational {
    fn rounding_from_rational(q: &Rational) -> Integer;
}

impl RoundRational for Integer {
    fn rounding_from_rational(q: &Rational) -> Integer {
        let half = Rational::from_dyadic(Integer::ONE, -1);
        let shifted = q + &half;
        if shifted.is_zero() {
            Integer::ZERO
        } else {
            shifted.floor_integer()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn angles_in_the_plane_have_one_part() {
        use crate::sample::NominalAngles;
        assert_eq!(Direction::from_radians(1.5).angles(), (1.5, None));
    }

    #[test]
    fn the_axes_are_exact() {
        let axes = Direction::around(4);
        let shown: Vec<String> = axes
            .iter()
            .map(|d| format!("{},{}", d.u(), d.v()))
            .collect();
        assert_eq!(shown, ["1,0", "0,1", "-1,0", "0,-1"]);
        let turned = Direction::from_degrees(&Rational::from(-450));
        assert_eq!(
            (turned.u(), turned.v()),
            (Rational::zero(), Rational::from(-1))
        );
    }

    #[test]
    fn many_turns_lose_no_digits() {
        // The cosines and sines are those of the doubles, from 40 digits.
        for (theta, cos, sin) in [
            (1e8, -0.3633850893556905, 0.931639027109726),
            (123_456_789.123, 0.017722760166677856, 0.9998429395520451),
            (-987_654_321.5, -0.4970787633117217, -0.8677054241299229),
            (1e5, -0.9993608074382124, 0.03574879797201651),
        ] {
            let d = Direction::from_radians(theta);
            assert!((d.u().to_f64() - cos).abs() < 4e-16, "{theta}");
            assert!((d.v().to_f64() - sin).abs() < 4e-16, "{theta}");
        }
        let turn = Direction::from_radians(std::f64::consts::TAU);
        assert_eq!((turn.u(), turn.v()), (Rational::one(), Rational::zero()));
    }

    proptest! {
        #[test]
        fn directions_are_unit_vectors_beside_their_angle(theta in -20.0f64..20.0) {
            let d = Direction::from_radians(theta);
            let (u, v) = (d.u(), d.v());
            prop_assert_eq!(&u * &u + &v * &v, Rational::one());
            prop_assert!((u.to_f64() - theta.cos()).abs() < 4e-15);
            prop_assert!((v.to_f64() - theta.sin()).abs() < 4e-15);
        }
    }
}
