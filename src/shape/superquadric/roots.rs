//! Powers of rational numbers with exponents p/q: exact if they are rational, else enclosed by integers in units of 2^−bits.

use malachite::base::num::arithmetic::traits::{CheckedRoot, FloorRoot, Pow};
use malachite::{Integer, Natural};

use crate::error::{Error, Result};
use crate::exact::Rational;

/// The precision at which a comparison begins, in bits after the point.
pub(super) const FIRST_BITS: u64 = 128;

/// The largest length, in bits, of a number whose root is taken. Beyond it a comparison ends with an error.
pub(crate) const MAX_ROOT_BITS: u64 = 1 << 22;

/// A positive exponent p/q.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exponent {
    pub(super) p: u64,
    pub(super) q: u64,
}

impl From<&Rational> for Exponent {
    fn from(exponent: &Rational) -> Self {
        // An exponent that does not fit is larger than the limit of the roots.
        let small = |n: Integer| u64::try_from(&n).unwrap_or(u64::MAX);
        Self {
            p: small(exponent.numerator()),
            q: small(exponent.denominator()),
        }
    }
}

impl Exponent {
    /// An error if a comparison would take roots of numbers with more than [`MAX_ROOT_BITS`] bits; its numbers have `bits`
    /// bits.
    pub(super) fn check_size(self, bits: u64, why: &dyn Fn() -> String) -> Result<()> {
        if bits.saturating_mul(self.p.max(self.q)) <= MAX_ROOT_BITS {
            return Ok(());
        }
        Err(Error::limit(format!(
            "a point of the superquadric needs roots of numbers with more than {MAX_ROOT_BITS} bits: {}",
            why()
        )))
    }
}

/// The q-th root, if it is rational.
pub(super) fn exact_root(radicand: &Rational, q: u64) -> Option<Rational> {
    let (above, below) = natural_parts(radicand);
    let root = |n: Natural| n.checked_root(q).map(Integer::from);
    Rational::from_integers(root(above)?, root(below)?)
}

/// The power base^(p/q), if it is rational; the base must not be negative.
pub(super) fn exact_power(base: &Rational, Exponent { p, q }: Exponent) -> Option<Rational> {
    // For p/q in lowest terms, the power is rational exactly if the q-th root of the base is.
    exact_root(base, q)?.pow(i64::try_from(p).ok()?)
}

/// The integer ⌊radicand^(1/q) · 2^bits⌋.
pub(super) fn scaled_root(radicand: &Rational, q: u64, bits: u64) -> Natural {
    let (above, below) = natural_parts(radicand);
    // The floor of the radicand is enough: ⌊⌊n⌋^(1/q)⌋ = ⌊n^(1/q)⌋.
    ((above << (bits * q)) / below).floor_root(q)
}

fn natural_parts(q: &Rational) -> (Natural, Natural) {
    let natural = |n: Integer| n.unsigned_abs_ref().clone();
    (natural(q.numerator()), natural(q.denominator()))
}

/// Bounds of a number, in units of 2^−bits.
#[derive(Clone, Debug)]
pub(super) struct Bounds {
    pub(super) low: Natural,
    pub(super) high: Natural,
}

impl Bounds {
    pub(super) fn of(value: &Rational, bits: u64) -> Self {
        let (above, below) = natural_parts(value);
        let low = (above << bits) / below;
        let high = &low + Natural::from(1u32);
        Self { low, high }
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        Self {
            low: &self.low + &other.low,
            high: &self.high + &other.high,
        }
    }

    /// Bounds of the (p/q)-th power. For v = n/2^b it is (n^p 2^(b(q − p)))^(1/q) units.
    pub(super) fn power(&self, Exponent { p, q }: Exponent, bits: u64) -> Self {
        let root = |n: &Natural, up: bool| {
            let power = n.pow(p);
            let scaled = if q >= p {
                power << (bits * (q - p))
            } else {
                (power >> (bits * (p - q))) + Natural::from(u32::from(up))
            };
            scaled.floor_root(q) + Natural::from(u32::from(up))
        };
        Self {
            low: root(&self.low, false),
            high: root(&self.high, true),
        }
    }
}
