//! Powers of intervals with positive rational exponents.

use super::Interval;
use crate::error::Invariant;
use crate::exact::Rational;

/// Numerators and denominators of exponents are below this, so that exponents of two stay in 64 bits.
const LARGEST: u64 = 1 << 40;
/// Results below this are 0 or more, and those above its inverse are not bounded.
const SMALLEST: f64 = 1e-290;

/// The exponent p/q of a power, p, q > 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Power {
    p: u64,
    q: u64,
    approximate: f64,
}

impl Power {
    /// `None` for an exponent that is not positive, or with a numerator or denominator of 2^40 or more.
    pub(crate) fn new(exponent: &Rational) -> Option<Self> {
        let small = |n: u64| (0 < n && n < LARGEST).then_some(n);
        Some(Self {
            p: small(u64::try_from(&exponent.numerator()).ok()?)?,
            q: small(u64::try_from(&exponent.denominator()).ok()?)?,
            approximate: exponent.to_f64(),
        })
    }

    /// The powers of the members x ≥ 0, of which there must be one. Powers increase with x.
    pub(crate) fn of(&self, x: Interval) -> Interval {
        let low = match x.low() {
            low if low <= 0.0 => 0.0,
            low => self.at(low).low(),
        };
        let high = match x.high() {
            high if high <= 0.0 => 0.0,
            f64::INFINITY => f64::INFINITY,
            high if high <= x.low() => return self.at(high),
            high => self.at(high).high(),
        };
        Interval::between(low.min(high), high)
    }

    /// Bounds of x^(p/q) for a finite x > 0.
    ///
    /// Lemma. Let y > 0 and ρ = x^p/y^q. Then x^(p/q) = yρ^(1/q), which is at most y(1 + (ρ − 1)/q) for ρ ≥ 1, and at least
    /// y(1 − (1 − ρ)/(qρ)) for ρ ≤ 1.
    ///
    /// Proof. By Bernoulli's inequality (1 + (ρ − 1)/q)^q ≥ ρ. For ρ ≤ 1 the same holds for 1/ρ, so ρ^(1/q) ≥ 1/(1 + (1/ρ − 1)/q)
    /// ≥ 1 − (1/ρ − 1)/q.
    ///
    /// y is the power in doubles. Powers with integer exponents are intervals with an exponent of two of their own.
    ///
    /// Law: `powers_hold_the_exact_ones`.
    #[expect(clippy::cast_precision_loss, reason = "q is less than 2^40")]
    fn at(&self, x: f64) -> Interval {
        let y = x.powf(self.approximate);
        let y = y.clamp(SMALLEST, SMALLEST.recip());
        let (above, below) = (Scaled::power(x, self.p), Scaled::power(y, self.q));
        let positive = Interval::between(0.0, f64::INFINITY);
        let ratio = match above.exponent - below.exponent {
            difference @ -60..=60 => {
                let mut ratio = above.factor / below.factor;
                for _ in 0..difference.abs() {
                    ratio = ratio * if difference < 0 { 0.5 } else { 2.0 };
                }
                ratio
            }
            // y is at an end of the range of doubles.
            difference if difference < 0 => return Interval::between(0.0, y),
            _ => return Interval::between(y, f64::INFINITY),
        };
        if !ratio.is_positive() || !ratio.high().is_finite() {
            return positive;
        }
        let (one, q) = (Interval::from(1.0), Interval::from(self.q as f64));
        let [low, high] = [ratio.low(), ratio.high()].map(Interval::from);
        let least = one - (one - low).or_zero() / (q * low);
        let most = one + (high - one).or_zero() / q;
        let of_y = Interval::from(y);
        Interval::between((of_y * least).low().max(0.0), (of_y * most).high())
    }
}

/// A positive number as an interval of numbers from about 1 to 2, times a power of two.
#[derive(Clone, Copy)]
struct Scaled {
    factor: Interval,
    exponent: i64,
}

impl Scaled {
    /// A finite number x > 0.
    fn new(x: f64) -> Self {
        /// Subnormal numbers are multiplied by 2^200.
        const LIFT: i64 = 200;
        let lifted = f64::from_bits((1023 + LIFT.unsigned_abs()) << 52);
        let is_small = x < f64::MIN_POSITIVE;
        let scaled = Self {
            factor: Interval::from(if is_small { x * lifted } else { x }),
            exponent: if is_small { -LIFT } else { 0 },
        };
        scaled.normalized()
    }

    /// The same number with a factor that is at most 2, and hardly less than 1. Products with powers of two are exact here.
    fn normalized(self) -> Self {
        let biased = self.factor.high().to_bits() >> 52;
        // The exponent of 2 in a normal number is at least −1022 and at most 1023.
        let exponent =
            i64::try_from(biased).invariant("a positive double has 11 bits of exponent") - 1023;
        let parts = [exponent / 2, exponent - exponent / 2];
        let powers = parts.map(|part| f64::from_bits((1023 - part).unsigned_abs() << 52));
        let ends = [self.factor.low(), self.factor.high()];
        let [low, high] = ends.map(|end| end * powers[0] * powers[1]);
        Self {
            factor: Interval::between(low, high),
            exponent: self.exponent + exponent,
        }
    }

    /// The power x^k by repeated squaring.
    fn power(x: f64, mut k: u64) -> Self {
        let mut base = Self::new(x);
        let mut all = Self::new(1.0);
        loop {
            if k % 2 == 1 {
                all = all.product(base);
            }
            k /= 2;
            if k == 0 {
                return all;
            }
            base = base.product(base);
        }
    }

    fn product(self, other: Self) -> Self {
        let product = Self {
            factor: self.factor * other.factor,
            exponent: self.exponent + other.exponent,
        };
        product.normalized()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

        /// low^q ≤ x^p ≤ high^q with exact rational numbers; the bounds are narrow.
        #[test]
        fn powers_hold_the_exact_ones(m in 1.0f64..2.0, e in -1070i32..1020, p in 1u32..60, q in 1u32..60) {
            let exponent = Rational::from(i64::from(p)) / Rational::from(i64::from(q));
            let power = Power::new(&exponent).unwrap();
            let (p, q) = (power.p.try_into().unwrap(), power.q.try_into().unwrap());
            let x = m * 2f64.powi(e);
            prop_assume!(x > 0.0);
            let found = power.of(Interval::from(x));
            let exact = |x: f64, k: i64| Rational::try_from(x).unwrap().pow(k).unwrap();
            let between = exact(x, p);
            prop_assert!(exact(found.low(), q) <= between);
            if found.high().is_finite() {
                prop_assert!(between <= exact(found.high(), q));
            }
            let y = x.powf(exponent.to_f64());
            if (1e-280..1e280).contains(&y) {
                prop_assert!(found.high() - found.low() <= 1e-13 * y, "{found:?}");
            } else if y < 1e-300 {
                prop_assert!(found.high() <= 1e-289);
            } else if y > 1e300 {
                prop_assert!(found.low() >= 1e289);
            }
        }

        /// Exponents with long numerators and denominators, near those with short ones: powers increase with the exponent.
        #[test]
        fn long_exponents_are_between_short_ones(x in 1.0001f64..8.0, n in 1i64..2_000, d in 1i64..2_000) {
            let exponent = Rational::from(n) / Rational::from(d);
            prop_assume!(exponent.to_f64() < 300.0);
            let [off, less] = [1 << 20, 2_097_143].map(|d| Rational::one() / Rational::from(d));
            let long = Power::new(&(&exponent + &less)).unwrap();
            let [short, more] = [&exponent, &(&exponent + &off)].map(|e| Power::new(e).unwrap().of(Interval::from(x)));
            let long = long.of(Interval::from(x));
            prop_assert!(short.low() <= long.high() && long.low() <= more.high());
            // Each factor of x is rounded.
            let width = 2e-15 * (exponent.to_f64() + 10.0) * long.high();
            prop_assert!(long.high() - long.low() <= width, "{long:?}");
        }
    }

    #[test]
    fn ends_of_the_range_are_kept() {
        let power = Power::new(&Rational::from(400)).unwrap();
        let found = power.of(Interval::between(0.0, 1e-3));
        assert!(found.low() <= 0.0 && found.high() <= 1e-289);
        assert!(power.of(Interval::from(1e3)).high().is_infinite());
        assert!(power.of(Interval::from(1e3)).low() > 1e280);
        let found = power.of(Interval::from(1.0));
        assert!((found.low() - 1.0).abs() < 1e-12 && (found.high() - 1.0).abs() < 1e-12);
        assert!(power.of(Interval::from(0.0)).high() <= 0.0);
        assert!(Power::new(&Rational::zero()).is_none());
        assert!(Power::new(&Rational::from(-1)).is_none());
        assert!(Power::new(&Rational::from(1i64 << 40)).is_none());
    }
}
