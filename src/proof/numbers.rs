//! Exact numbers: big integers, fractions, and the doubles of a document with the midpoints between neighbouring doubles.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::{BigInt, BigUint, Sign};

use super::json::{Value, beginning};
use super::refusal::{Checked, Refusal, need};

/// The largest number of characters of a coefficient of a form or a part.
const LONGEST_COEFFICIENT: usize = 20_000;
/// The largest number of characters of any other exact number. Polynomials of high degrees are evaluated at these numbers.
const LONGEST_NUMBER: usize = 2_000;
/// The largest number of digits of a double on either side of the point, and of its exponent.
const DOUBLE_DIGITS: usize = 400;
const EXPONENT_DIGITS: usize = 4;
/// Every double is a multiple of 2^−1074.
const SMALLEST_EXPONENT: u32 = 1074;

/// A rational number. It need not be in lowest terms; two of them are equal if their values are.
#[derive(Clone, Debug)]
pub(super) struct Exact {
    numerator: BigInt,
    /// Positive.
    denominator: BigInt,
}

impl Exact {
    pub(super) fn zero() -> Self {
        Self::integer(0)
    }

    pub(super) fn one() -> Self {
        Self::integer(1)
    }

    pub(super) fn integer(value: impl Into<BigInt>) -> Self {
        Self {
            numerator: value.into(),
            denominator: BigInt::from(1),
        }
    }

    /// numerator/denominator, for a denominator that is not 0.
    pub(super) fn fraction(numerator: BigInt, denominator: BigInt) -> Self {
        if denominator.sign() == Sign::Minus {
            Self {
                numerator: -numerator,
                denominator: -denominator,
            }
        } else {
            Self {
                numerator,
                denominator,
            }
        }
    }

    pub(super) fn numerator(&self) -> &BigInt {
        &self.numerator
    }

    pub(super) fn denominator(&self) -> &BigInt {
        &self.denominator
    }

    pub(super) fn sign(&self) -> i64 {
        sign(&self.numerator)
    }

    pub(super) fn is_zero(&self) -> bool {
        self.sign() == 0
    }

    /// Whether this is a number from 0 to 1.
    pub(super) fn is_in_unit_interval(&self) -> bool {
        self.sign() >= 0 && self.numerator <= self.denominator
    }

    pub(super) fn squared(&self) -> Self {
        self * self
    }

    /// The quotient, for a divisor that is not 0.
    pub(super) fn divided_by(&self, divisor: &Self) -> Self {
        Self::fraction(
            &self.numerator * &divisor.denominator,
            &self.denominator * &divisor.numerator,
        )
    }

    /// Reads `0`, `p` or `p/q`, a number that is no coefficient.
    pub(super) fn read(value: &Value) -> Checked<Self> {
        Self::read_within(value, LONGEST_NUMBER)
    }

    /// Reads a coefficient of a form or a part.
    pub(super) fn read_coefficient(value: &Value) -> Checked<Self> {
        Self::read_within(value, LONGEST_COEFFICIENT)
    }

    fn read_within(value: &Value, longest: usize) -> Checked<Self> {
        let text = value.text()?;
        let fault = || Refusal::new(format!("{} is no exact number", beginning(text)));
        need(
            text.len() <= longest,
            &format!("an exact number has at most {longest} characters here"),
        )?;
        if text == "0" {
            return Ok(Self::zero());
        }
        let (negative, rest) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let (above, below) = rest.split_once('/').unwrap_or((rest, "1"));
        let [numerator, denominator] =
            [above, below].map(|digits| positive_integer(digits).ok_or_else(fault));
        let numerator = numerator?;
        Ok(Self {
            numerator: if negative { -numerator } else { numerator },
            denominator: denominator?,
        })
    }
}

/// Decimal digits without a leading zero.
fn positive_integer(digits: &str) -> Option<BigInt> {
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit()) && !digits.starts_with('0');
    if plain { digits.parse().ok() } else { None }
}

impl PartialEq for Exact {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Exact {}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Exact {
    fn cmp(&self, other: &Self) -> Ordering {
        (&self.numerator * &other.denominator).cmp(&(&other.numerator * &self.denominator))
    }
}

impl Add for &Exact {
    type Output = Exact;

    fn add(self, other: &Exact) -> Exact {
        if self.denominator == other.denominator {
            return Exact::fraction(&self.numerator + &other.numerator, self.denominator.clone());
        }
        Exact::fraction(
            &self.numerator * &other.denominator + &other.numerator * &self.denominator,
            &self.denominator * &other.denominator,
        )
    }
}

impl Neg for &Exact {
    type Output = Exact;

    fn neg(self) -> Exact {
        Exact::fraction(-&self.numerator, self.denominator.clone())
    }
}

impl Sub for &Exact {
    type Output = Exact;

    fn sub(self, other: &Exact) -> Exact {
        self + &-other
    }
}

impl Mul for &Exact {
    type Output = Exact;

    fn mul(self, other: &Exact) -> Exact {
        Exact::fraction(
            &self.numerator * &other.numerator,
            &self.denominator * &other.denominator,
        )
    }
}

/// −1, 0 or 1.
pub(super) fn sign(value: &BigInt) -> i64 {
    match value.sign() {
        Sign::Minus => -1,
        Sign::NoSign => 0,
        Sign::Plus => 1,
    }
}

pub(super) fn is_zero(value: &BigInt) -> bool {
    value.sign() == Sign::NoSign
}

/// 2^exponent.
pub(super) fn power_of_two(exponent: u32) -> BigInt {
    BigInt::from(1) << exponent
}

/// The powers of the base with the exponents 0 to the largest one.
pub(super) fn powers(base: &BigInt, largest: usize) -> Vec<BigInt> {
    let mut all = Vec::with_capacity(largest + 1);
    all.push(BigInt::from(1));
    for exponent in 0..largest {
        all.push(&all[exponent] * base);
    }
    all
}

/// Euclid's algorithm. The result is not negative.
pub(super) fn greatest_common_divisor(a: &BigInt, b: &BigInt) -> BigInt {
    let (mut a, mut b) = (a.magnitude().clone(), b.magnitude().clone());
    while b != BigUint::ZERO {
        (a, b) = (b.clone(), a % b);
    }
    BigInt::from(a)
}

/// The numbers times their positive common denominator, and this denominator.
pub(super) fn common_denominator(values: &[Exact]) -> (Vec<BigInt>, BigInt) {
    let mut common = BigInt::from(1);
    for value in values {
        if !is_zero(&(&common % &value.denominator)) {
            let shared = greatest_common_divisor(&common, &value.denominator);
            common *= &value.denominator / shared;
        }
    }
    let integers = values
        .iter()
        .map(|value| &value.numerator * (&common / &value.denominator))
        .collect();
    (integers, common)
}

/// A vector with this many coordinates.
pub(super) fn vector(value: &Value, dimension: usize) -> Checked<Vec<Exact>> {
    value.list(dimension..=dimension, Exact::read)
}

/// A vector whose length is exactly 1.
pub(super) fn unit_vector(value: &Value, dimension: usize) -> Checked<Vec<Exact>> {
    let found = vector(value, dimension)?;
    let (integers, common) = common_denominator(&found);
    let square: BigInt = integers
        .iter()
        .map(|coordinate| coordinate * coordinate)
        .sum();
    need(
        square == &common * &common,
        "the length of this vector is not 1",
    )?;
    Ok(found)
}

/// The square of the distance of two points.
pub(super) fn squared_distance(a: &[Exact], b: &[Exact]) -> Exact {
    let mut sum = Exact::zero();
    for (a, b) in a.iter().zip(b) {
        sum = &sum + &(a - b).squared();
    }
    sum
}

/// The double nearest to a decimal, or `inf` or `-inf`.
pub(super) fn read_double(value: &Value) -> Checked<f64> {
    let text = value.text()?;
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let fault = || Refusal::new(format!("{} is no double", beginning(text)));
    if unsigned != "inf" && !is_decimal(unsigned) {
        return Err(fault());
    }
    let double: f64 = text.parse().map_err(|_| fault())?;
    need(
        double.is_finite() || unsigned == "inf",
        "a number beyond the doubles is written inf",
    )?;
    Ok(double)
}

/// Whether this is a decimal without a sign: digits, a point with digits, `e` with a sign and digits.
fn is_decimal(text: &str) -> bool {
    let digits = |text: &str, most: usize| {
        (1..=most).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit())
    };
    let (mantissa, exponent) = match text.split_once('e') {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (text, None),
    };
    let (whole, places) = match mantissa.split_once('.') {
        Some((whole, places)) => (whole, Some(places)),
        None => (mantissa, None),
    };
    digits(whole, DOUBLE_DIGITS)
        && places.is_none_or(|places| digits(places, DOUBLE_DIGITS))
        && exponent.is_none_or(|exponent| {
            digits(
                exponent.strip_prefix(['+', '-']).unwrap_or(exponent),
                EXPONENT_DIGITS,
            )
        })
}

/// The midpoints between the double and the next smaller and the next larger one; `None` where there is no neighbour. The
/// neighbour of the largest finite double is taken to be 2^1024, as in rounding to nearest.
pub(super) fn midpoints(double: f64) -> [Option<Exact>; 2] {
    let own = in_smallest_units(double);
    [double.next_down(), double.next_up()].map(|neighbour| {
        (neighbour.to_bits() != double.to_bits()).then(|| {
            Exact::fraction(
                &own + in_smallest_units(neighbour),
                power_of_two(SMALLEST_EXPONENT + 1),
            )
        })
    })
}

/// The double times 2^1074, an integer; an infinite one stands for ±2^1024.
fn in_smallest_units(double: f64) -> BigInt {
    const FRACTION_BITS: u32 = 52;
    let bits = double.to_bits();
    let fraction = bits & ((1 << FRACTION_BITS) - 1);
    let exponent = u32::try_from(bits >> FRACTION_BITS & 0x7ff).unwrap_or_default();
    let magnitude = if exponent == 0 {
        BigInt::from(fraction)
    } else {
        BigInt::from(fraction | 1 << FRACTION_BITS) << (exponent - 1)
    };
    if double.is_sign_negative() {
        -magnitude
    } else {
        magnitude
    }
}
