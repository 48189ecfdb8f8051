//! [`Rational`]: malachite's rational number, with conversions from and to the `num` crates.

use std::fmt;
use std::iter::Sum;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::str::FromStr;

use malachite::base::num::arithmetic::traits::{Abs, CheckedSqrt, Pow, Reciprocal, Sign};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural};
use num_bigint::{BigInt, Sign as BigSign};
use num_rational::BigRational;

use crate::bigint::Decimal;
use crate::error::Error;

/// An exact rational number p/q in lowest terms, q > 0.
///
/// Its integers are those of `num-bigint`, and it is converted from and to the rational number of `num-rational`:
///
/// ```
/// use num_bigint::BigInt;
/// use num_rational::BigRational;
/// use stellate::exact::Rational;
///
/// let third: BigRational = BigRational::new(1.into(), 3.into());
/// let sixth = Rational::from(third.clone()) / Rational::from(2);
/// assert_eq!(sixth.to_string(), "1/6");
/// assert_eq!(sixth, Rational::new(-2, -12).unwrap());
/// assert_eq!(sixth.denom(), BigInt::from(6));
/// assert_eq!(BigRational::from(&(&sixth + &sixth)), third);
/// // A double is taken bit for bit, a decimal as it is written:
/// assert_eq!(Rational::try_from(0.1).unwrap().to_string(), "3602879701896397/36028797018963968");
/// assert_eq!("0.1".parse::<Rational>().unwrap().to_string(), "1/10");
/// ```
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Rational(malachite::Rational);

/// A double that is infinite or not a number has no exact value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("infinity and NaN are not numbers here")]
pub struct NotANumber;

/// The rational number is not an integer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the number is not an integer")]
pub struct NotAnInteger;

impl Rational {
    /// The number 0.
    #[must_use]
    pub fn zero() -> Self {
        Self(malachite::Rational::ZERO)
    }

    /// The number 1.
    #[must_use]
    pub fn one() -> Self {
        Self(malachite::Rational::ONE)
    }

    /// The number `numerator / denominator`; `None` if the denominator is 0.
    #[must_use]
    pub fn new(numerator: impl Into<BigInt>, denominator: impl Into<BigInt>) -> Option<Self> {
        Self::from_integers(
            integer_from_num(&numerator.into()),
            integer_from_num(&denominator.into()),
        )
    }

    /// The numerator p, which has the sign.
    #[must_use]
    pub fn numer(&self) -> BigInt {
        integer_to_num(&self.numerator())
    }

    /// The denominator q > 0.
    #[must_use]
    pub fn denom(&self) -> BigInt {
        integer_to_num(&self.denominator())
    }

    /// As [`Self::new`], from malachite's integers.
    pub(crate) fn from_integers(numerator: Integer, denominator: Integer) -> Option<Self> {
        (denominator != 0).then(|| Self(malachite::Rational::from_integers(numerator, denominator)))
    }

    /// The rational number that is equal to an integer of malachite, or to a reference to one.
    pub(crate) fn whole<T>(value: T) -> Self
    where
        malachite::Rational: From<T>,
    {
        Self(malachite::Rational::from(value))
    }

    /// The numerator p as malachite's integer.
    pub(crate) fn numerator(&self) -> Integer {
        Integer::from_sign_and_abs_ref(self.0 >= 0, self.0.numerator_ref())
    }

    /// The denominator q as malachite's integer.
    pub(crate) fn denominator(&self) -> Integer {
        Integer::from(self.0.denominator_ref())
    }

    /// A reference to |p|.
    pub(crate) fn magnitude_ref(&self) -> &Natural {
        self.0.numerator_ref()
    }

    /// A reference to q.
    pub(crate) fn denominator_ref(&self) -> &Natural {
        self.0.denominator_ref()
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0 == 0
    }

    /// Whether q = 1.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        *self.0.denominator_ref() == Natural::ONE
    }

    /// The sign: −1, 0 or 1.
    #[must_use]
    pub fn signum(&self) -> i8 {
        match self.0.sign() {
            std::cmp::Ordering::Less => -1,
            std::cmp::Ordering::Equal => 0,
            std::cmp::Ordering::Greater => 1,
        }
    }

    /// The absolute value |self|.
    #[must_use]
    pub fn abs(&self) -> Self {
        Self((&self.0).abs())
    }

    /// The inverse 1/self; `None` for 0.
    #[must_use]
    pub fn recip(&self) -> Option<Self> {
        (!self.is_zero()).then(|| Self((&self.0).reciprocal()))
    }

    /// The power self^exponent; `None` for 0 with a negative exponent.
    #[must_use]
    pub fn pow(&self, exponent: i64) -> Option<Self> {
        if exponent < 0 && self.is_zero() {
            return None;
        }
        Some(Self((&self.0).pow(exponent)))
    }

    /// The square root that is not negative; `None` if it is not rational.
    #[must_use]
    pub fn sqrt(&self) -> Option<Self> {
        (self.0 >= 0)
            .then(|| (&self.0).checked_sqrt().map(Self))
            .flatten()
    }

    /// The fraction with the smallest denominator in the closed interval between two numbers.
    #[must_use]
    pub fn simplest_between(low: &Self, high: &Self) -> Self {
        use malachite::rational::rational::arithmetic::traits::SimplestRationalInInterval;
        let (low, high) = if low <= high {
            (low, high)
        } else {
            (high, low)
        };
        Self(malachite::Rational::simplest_rational_in_closed_interval(
            &low.0, &high.0,
        ))
    }

    /// The larger of the bit lengths of numerator and denominator.
    #[must_use]
    pub fn bits(&self) -> u64 {
        use malachite::base::num::logic::traits::SignificantBits;
        self.0
            .numerator_ref()
            .significant_bits()
            .max(self.0.denominator_ref().significant_bits())
    }

    pub(super) fn inner(&self) -> &malachite::Rational {
        &self.0
    }

    pub(super) fn from_inner(value: malachite::Rational) -> Self {
        Self(value)
    }
}

impl fmt::Display for Rational {
    /// The fraction, such as `-1/3`. Format options such as a width apply to the numerator and to the denominator.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 < 0 {
            f.write_str("-")?;
        }
        fmt::Display::fmt(&Decimal(self.magnitude_ref()), f)?;
        if self.is_integer() {
            return Ok(());
        }
        f.write_str("/")?;
        fmt::Display::fmt(&Decimal(self.denominator_ref()), f)
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl FromStr for Rational {
    type Err = Error;

    /// Reads as [`exact_literal`](super::exact_literal) does.
    fn from_str(text: &str) -> Result<Self, Error> {
        super::exact_literal(text)
    }
}

impl From<i64> for Rational {
    fn from(value: i64) -> Self {
        Self(malachite::Rational::from(value))
    }
}

impl From<i32> for Rational {
    fn from(value: i32) -> Self {
        Self(malachite::Rational::from(value))
    }
}

impl TryFrom<f64> for Rational {
    type Error = NotANumber;

    /// The exact value of the double, bit for bit.
    fn try_from(value: f64) -> Result<Self, NotANumber> {
        malachite::Rational::try_from(value)
            .map(Self)
            .map_err(|_| NotANumber)
    }
}

/// The integer in malachite's type. Both types have 64-bit digits.
pub fn integer_from_num(value: &BigInt) -> Integer {
    let (sign, digits) = value.to_u64_digits();
    Integer::from_sign_and_abs(
        sign != BigSign::Minus,
        Natural::from_owned_limbs_asc(digits),
    )
}

/// The integer in the type of `num-bigint`.
pub fn integer_to_num(value: &Integer) -> BigInt {
    let sign = if *value < 0 {
        BigSign::Minus
    } else {
        BigSign::Plus
    };
    let digits = value
        .unsigned_abs_ref()
        .limbs()
        .flat_map(|limb| limb.to_le_bytes());
    BigInt::from_bytes_le(sign, &digits.collect::<Vec<u8>>())
}

impl From<&BigInt> for Rational {
    fn from(value: &BigInt) -> Self {
        Self::whole(integer_from_num(value))
    }
}

impl From<BigInt> for Rational {
    fn from(value: BigInt) -> Self {
        Self::from(&value)
    }
}

impl TryFrom<&Rational> for BigInt {
    type Error = NotAnInteger;

    fn try_from(value: &Rational) -> Result<Self, NotAnInteger> {
        if value.is_integer() {
            Ok(integer_to_num(&value.numerator()))
        } else {
            Err(NotAnInteger)
        }
    }
}

impl From<BigRational> for Rational {
    fn from(value: BigRational) -> Self {
        Self(malachite::Rational::from_integers(
            integer_from_num(value.numer()),
            integer_from_num(value.denom()),
        ))
    }
}

impl From<&Rational> for BigRational {
    fn from(value: &Rational) -> Self {
        // The fraction is already in lowest terms.
        Self::new_raw(
            integer_to_num(&value.numerator()),
            integer_to_num(&value.denominator()),
        )
    }
}

impl Neg for Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        Rational(-self.0)
    }
}

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        Rational(-&self.0)
    }
}

impl Sum for Rational {
    fn sum<I: Iterator<Item = Rational>>(iter: I) -> Rational {
        iter.fold(Rational::zero(), |a, b| a + b)
    }
}

/// Implements one operator, for values and references alike.
macro_rules! operator {
    ($trait:ident, $method:ident, $doc:literal) => {
        impl $trait for Rational {
            type Output = Rational;
            #[doc = $doc]
            fn $method(self, other: Rational) -> Rational {
                Rational(self.0.$method(other.0))
            }
        }
        impl $trait<&Rational> for Rational {
            type Output = Rational;
            #[doc = $doc]
            fn $method(self, other: &Rational) -> Rational {
                Rational(self.0.$method(&other.0))
            }
        }
        impl $trait<Rational> for &Rational {
            type Output = Rational;
            #[doc = $doc]
            fn $method(self, other: Rational) -> Rational {
                Rational((&self.0).$method(other.0))
            }
        }
        impl $trait<&Rational> for &Rational {
            type Output = Rational;
            #[doc = $doc]
            fn $method(self, other: &Rational) -> Rational {
                Rational((&self.0).$method(&other.0))
            }
        }
    };
}

operator!(Add, add, "Exact sum.");
operator!(Sub, sub, "Exact difference.");
operator!(Mul, mul, "Exact product.");
operator!(Div, div, "Exact quotient; panics if the divisor is 0.");
