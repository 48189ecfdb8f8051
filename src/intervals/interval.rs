//! Intervals: real numbers that are known to lie between two doubles. This file accounts for all rounding errors on which
//! certified answers rest, by outward rounding ([`Interval`]) or, in long sums, by counting roundings ([`relative_error`]).
//!
//! There is one rule: the result of an operation on intervals holds the results of the operation on all their members. The
//! results need not be the narrowest intervals; each operation widens them by one or two units in the last place.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::exact::Rational;

#[cfg(test)]
#[path = "interval_laws.rs"]
pub(crate) mod tests;

/// The unit roundoff 2^(−53): a rounded result that does not underflow is `exact·(1 + δ)` with |δ| ≤ `UNIT`.
pub(crate) const UNIT: f64 = f64::EPSILON / 2.0;

/// The real numbers x with low ≤ x ≤ high. The ends are never NaN; low < ∞ and high > −∞, so there always is such an x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    low: f64,
    high: f64,
}

/// A number slightly above `UNIT`: 2^(−53) + 2^(−105).
const STEP: f64 = UNIT * (1.0 + f64::EPSILON);
/// The least positive double, 2^(−1074).
const LEAST: f64 = f64::from_bits(1);

/// Lemma 1. If `rounded` is the double nearest to a real number x, or ±∞ if x is too large, then `below(rounded)` ≤ x ≤
/// `above(rounded)`.
///
/// Proof. x is not beyond the neighbour of `rounded`, because then this neighbour would be nearer to x. For 2^e ≤ |rounded| <
/// 2^(e + 1), neighbouring doubles there differ by at most 2^(e − 52), and `STEP`·|rounded| is more than half of that; for
/// subnormal numbers `LEAST` is. So the sum is rounded to the neighbour or to the double after it (Rump, Zimmermann, Boldo,
/// Melquiond, *Computing predecessor and successor in rounding to nearest*, BIT 49 (2009)). The sum is NaN only for ∞ − ∞ and
/// for NaN, and then the bound is infinite.
///
/// Laws: `operations_hold_the_exact_results`, `the_next_double_is_reached`.
#[inline]
fn above(rounded: f64) -> f64 {
    (rounded + (STEP * rounded.abs() + LEAST)).min(f64::INFINITY)
}

/// The lower bound of the lemma at [`above`].
#[inline]
fn below(rounded: f64) -> f64 {
    (rounded - (STEP * rounded.abs() + LEAST)).max(f64::NEG_INFINITY)
}

/// Lemma 2. Let a number be computed from non-negative inputs by additions and multiplications. It is a sum of products of
/// inputs; let each product be rounded at most n times, without underflow. Then the error of the computed number is at most
/// `relative_error(n)` times this number. If the inputs may be negative, the same multiple of the sum of the absolute values of
/// the products bounds the error.
///
/// Proof. Let u be `UNIT`. Every product gets a factor between (1 − u)^n and (1 + u)^n ≤ (1 − u)^(−n). So a computed sum S of
/// absolute values is at least (1 − u)^n times the exact sum, and the error is at most (1 − u)^(−n) − 1 times the exact sum. By
/// Bernoulli's inequality (1 − u)^n ≥ 1 − nu, the error is at most nu/(1 − nu)² times S.
///
/// Laws: `counted_errors_hold_and_are_reached`, and those of `value`, `taylor` and `on_box`.
#[expect(clippy::cast_precision_loss, reason = "far fewer than 2^53 roundings")]
pub(crate) fn relative_error(roundings: usize) -> f64 {
    let nu = Interval::from(roundings as f64) * UNIT;
    let rest = Interval::from(1.0) - nu;
    (nu / (rest * rest)).high
}

impl From<f64> for Interval {
    /// The number itself; for ±∞ and NaN all real numbers, because nothing is known.
    #[inline]
    fn from(x: f64) -> Self {
        if x.is_finite() {
            Self { low: x, high: x }
        } else {
            Self::ENTIRE
        }
    }
}

impl From<&Rational> for Interval {
    /// The interval holds the number by Lemma 1, because conversions round to nearest.
    fn from(x: &Rational) -> Self {
        let rounded = x.to_f64();
        Self::ordered(below(rounded), above(rounded))
    }
}

impl Interval {
    /// The narrowest interval that holds a number: from the largest double that is not above it to the smallest that is not
    /// below it.
    pub(crate) fn narrowest(x: &Rational) -> Self {
        let rounded = x.to_f64();
        match Rational::try_from(rounded).map(|y| y.cmp(x)) {
            Ok(Ordering::Equal) => Self::from(rounded),
            Ok(Ordering::Less) => Self::ordered(rounded, rounded.next_up()),
            Ok(Ordering::Greater) => Self::ordered(rounded.next_down(), rounded),
            // The number is beyond the largest double.
            Err(_) if rounded > 0.0 => Self::ordered(f64::MAX, rounded),
            Err(_) => Self::ordered(rounded, f64::MIN),
        }
    }

    /// All real numbers.
    pub(crate) const ENTIRE: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };
    /// The number 0.
    pub(crate) const ZERO: Self = Self {
        low: 0.0,
        high: 0.0,
    };

    /// The interval between two ends; all real numbers if these are no ends of an interval.
    #[inline]
    fn ordered(low: f64, high: f64) -> Self {
        if low <= high {
            Self { low, high }
        } else {
            Self::ENTIRE
        }
    }

    /// The interval between a lower and an upper bound of the same number.
    #[inline]
    pub(crate) fn between(low: f64, high: f64) -> Self {
        debug_assert!(low <= high, "bounds in the wrong order: {low}, {high}");
        Self::ordered(low, high)
    }

    /// All numbers within `radius` of `middle`; all real numbers if one of the two is not finite. By Lemma 1.
    #[inline]
    pub(crate) fn around(middle: f64, radius: f64) -> Self {
        if middle.is_finite() {
            Self::ordered(below(middle - radius), above(middle + radius))
        } else {
            Self::ENTIRE
        }
    }

    /// All numbers of absolute value at most `radius`.
    #[inline]
    pub(crate) fn up_to(radius: f64) -> Self {
        Self::ordered(-radius, radius)
    }

    /// The lower end: no member is less.
    #[inline]
    pub(crate) fn low(self) -> f64 {
        self.low
    }

    /// The upper end: no member is greater.
    #[inline]
    pub(crate) fn high(self) -> f64 {
        self.high
    }

    /// A double near the middle, for computations that claim nothing.
    #[inline]
    pub(crate) fn middle(self) -> f64 {
        f64::midpoint(self.low, self.high)
    }

    /// An upper bound of the absolute values of the members.
    #[inline]
    pub(crate) fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// A lower bound of the absolute values of the members.
    #[inline]
    pub(crate) fn mignitude(self) -> f64 {
        self.low.max(-self.high).max(0.0)
    }

    /// The absolute values of the members.
    #[inline]
    pub(crate) fn abs(self) -> Self {
        Self {
            low: self.mignitude(),
            high: self.magnitude(),
        }
    }

    /// Whether every member is positive.
    #[inline]
    pub(crate) fn is_positive(self) -> bool {
        self.low > 0.0
    }

    /// Whether every member is negative.
    #[inline]
    pub(crate) fn is_negative(self) -> bool {
        self.high < 0.0
    }

    /// The sign of all members, if they have the same one.
    #[inline]
    pub(crate) fn sign(self) -> Option<i8> {
        match self {
            x if x.is_positive() => Some(1),
            x if x.is_negative() => Some(-1),
            _ => None,
        }
    }

    /// Whether every member of `self` is less than every member of `other`.
    #[inline]
    pub(crate) fn is_below(self, other: Self) -> bool {
        self.high < other.low
    }

    /// The interval of max(x, 0) for all members x.
    #[inline]
    pub(crate) fn or_zero(self) -> Self {
        Self {
            low: self.low.max(0.0),
            high: self.high.max(0.0),
        }
    }

    /// The interval of max(x, y) for all members x and y.
    #[inline]
    pub(crate) fn max(self, other: Self) -> Self {
        Self {
            low: self.low.max(other.low),
            high: self.high.max(other.high),
        }
    }

    /// The squares of all members. By Lemma 1, as squares increase with the absolute value.
    #[inline]
    pub(crate) fn squared(self) -> Self {
        let (low, high) = (self.mignitude(), self.magnitude());
        Self::ordered(below(low * low).max(0.0), above(high * high))
    }

    /// The square roots of the members x ≥ 0, of which there must be one. By Lemma 1, as roots are correctly rounded and
    /// increase with x.
    #[inline]
    pub(crate) fn sqrt(self) -> Self {
        Self::ordered(
            below(self.low.max(0.0).sqrt()).max(0.0),
            above(self.high.sqrt()),
        )
    }

    /// Whether a number is a member.
    #[cfg(test)]
    pub(crate) fn contains(self, x: &Rational) -> bool {
        let end = |end: f64| Rational::try_from(end).ok();
        end(self.low).is_none_or(|low| low <= *x) && end(self.high).is_none_or(|high| *x <= high)
    }
}

impl Neg for Interval {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            low: -self.high,
            high: -self.low,
        }
    }
}

impl Add for Interval {
    type Output = Self;

    /// By Lemma 1: the least sum is that of the lower ends, the greatest that of the upper ends. Lower ends are < ∞ and upper
    /// ends > −∞, so no sum is ∞ − ∞.
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            low: below(self.low + other.low),
            high: above(self.high + other.high),
        }
    }
}

impl Sub for Interval {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;

    /// By Lemma 1: xy is linear in x and in y, so its extremes are products of ends. Minimum and maximum ignore NaN, which only
    /// 0·∞ gives. Then the other products of this 0 or of this infinite end are among the candidates, and they bound the
    /// result.
    #[inline]
    fn mul(self, other: Self) -> Self {
        let [a, b, c, d] = [
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ];
        Self {
            low: below(a.min(b).min(c.min(d))),
            high: above(a.max(b).max(c.max(d))),
        }
    }
}

impl Mul<f64> for Interval {
    type Output = Self;

    /// The product with a double, by the same rule.
    #[inline]
    fn mul(self, factor: f64) -> Self {
        let (a, b) = (self.low * factor, self.high * factor);
        if factor.is_finite() {
            Self {
                low: below(a.min(b)),
                high: above(a.max(b)),
            }
        } else {
            Self::ENTIRE
        }
    }
}

impl Div for Interval {
    type Output = Self;

    /// By Lemma 1: x/y is monotonic in x and in y ≠ 0, so its extremes are quotients of ends. The result is all real numbers if
    /// the divisor may be 0, or if both may be unbounded.
    #[inline]
    fn div(self, other: Self) -> Self {
        if other.sign().is_none() {
            return Self::ENTIRE;
        }
        let [a, b, c, d] = [
            self.low / other.low,
            self.low / other.high,
            self.high / other.low,
            self.high / other.high,
        ];
        if a.is_nan() || b.is_nan() || c.is_nan() || d.is_nan() {
            return Self::ENTIRE;
        }
        Self {
            low: below(a.min(b).min(c.min(d))),
            high: above(a.max(b).max(c.max(d))),
        }
    }
}

/// A point or vector of doubles, as intervals.
pub(crate) fn exactly(v: [f64; 3]) -> [Interval; 3] {
    v.map(Interval::from)
}

/// The difference a − b.
pub(crate) fn minus(a: [Interval; 3], b: [Interval; 3]) -> [Interval; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The scalar product.
pub(crate) fn product(a: [Interval; 3], b: [Interval; 3]) -> Interval {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
pub(crate) fn cross(a: [Interval; 3], b: [Interval; 3]) -> [Interval; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| a[i] * b[j] - a[j] * b[i])
}

/// The squared length |a|².
pub(crate) fn square(a: [Interval; 3]) -> Interval {
    a[0].squared() + a[1].squared() + a[2].squared()
}

/// The distance |a − b| of two points of doubles.
pub(crate) fn separation(a: [f64; 3], b: [f64; 3]) -> Interval {
    square(minus(exactly(a), exactly(b))).sqrt()
}
