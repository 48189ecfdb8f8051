//! The exact error of a Fourier series in a direction.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivRound, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::sample::Direction;
use crate::shape::FourierRadius;

/// Exact values of a Fourier radius in exact directions.
pub(super) struct Evaluator {
    denominator: Integer,
    cos: Vec<Integer>,
    sin: Vec<Integer>,
}

impl Evaluator {
    pub(super) fn new(radius: &FourierRadius) -> Self {
        let (denominator, cos, sin) = radius.over_common_denominator();
        Self {
            denominator,
            cos,
            sin,
        }
    }

    /// Re Σ (a_n − i b_n) z^n with z = (U + iV)/W, by Horner over integers.
    fn value(&self, direction: &Direction) -> Rational {
        let (u, v, w) = direction.integers();
        let (mut re, mut im) = (Integer::ZERO, Integer::ZERO);
        let mut power = Integer::ONE;
        for (a, b) in self.cos.iter().zip(&self.sin).rev() {
            let turned = &re * u - &im * v;
            im = &re * v + &im * u;
            re = turned;
            re += a * &power;
            im -= b * &power;
            power *= w;
        }
        // The last power of W is one too many.
        let scale = (&power).div_round(w, RoundingMode::Exact).0 * &self.denominator;
        Rational::from_integers(re, scale).invariant("a denominator is not 0")
    }

    /// A bound of |fit − r|, where `r` is the nearest double of the radius.
    pub(super) fn error(&self, direction: &Direction, r: f64) -> Rational {
        // Samples of a radius near the largest double have no finite sum.
        let [exact, next] = [r, r.abs().next_up()]
            .map(|r| Rational::try_from(r).invariant("a radius that has a fit is finite"));
        let ulp = next - exact.abs();
        (self.value(direction) - exact).abs() + ulp
    }
}

/// A positive number rounded up to three significant digits: `1.23e-4`.
#[must_use]
pub(crate) fn rounded_up(value: &Rational) -> String {
    if value.is_zero() {
        return "0".into();
    }
    let ten = |e: i64| Rational::from(10).pow(e).invariant("10 is not 0");
    let mut exponent = i64::rounding_from(value.to_f64().log10().floor(), RoundingMode::Nearest).0;
    let digits = |exponent: i64| {
        let scaled = value * &ten(2 - exponent);
        -(-scaled).floor_integer()
    };
    // The logarithm of a double may be wrong by one.
    while digits(exponent) >= Integer::from(10).pow(3) {
        exponent += 1;
    }
    let text = digits(exponent).to_string();
    let (first, rest) = text.split_at(1);
    format!("{first}.{rest}e{exponent}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_rounded_up() {
        let shown = |p: i64, q: i64| rounded_up(&(Rational::from(p) / Rational::from(q)));
        assert_eq!(shown(1, 3), "3.34e-1");
        assert_eq!(shown(1, 8), "1.25e-1");
        assert_eq!(shown(9999, 10), "1.00e3");
        assert_eq!(shown(12345, 1), "1.24e4");
        assert_eq!(shown(0, 1), "0");
    }

    #[test]
    fn a_series_is_evaluated_exactly() {
        let exact = |v: &[i64]| v.iter().map(|&c| Rational::from(c)).collect::<Vec<_>>();
        let radius = FourierRadius::new(exact(&[2, 0, 3]), exact(&[0, 5, 1]));
        let evaluator = Evaluator::new(&radius);
        for degrees in [0, 17, 90, 123, 270] {
            let d = Direction::from_degrees(&Rational::from(degrees));
            let (c, s) = (d.u(), d.v());
            let two = Rational::from(2);
            let expected = Rational::from(2)
                + Rational::from(5) * &s
                + Rational::from(3) * (&c * &c - &s * &s)
                + two * &c * &s;
            assert_eq!(evaluator.value(&d), expected);
        }
    }
}
