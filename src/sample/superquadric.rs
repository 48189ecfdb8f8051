//! Certified points of superquadrics: sums of two real roots, compared exactly.

use std::cmp::Ordering;

use malachite::base::num::arithmetic::traits::{CheckedRoot, FloorRoot};
use malachite::{Integer, Natural};

use super::{Direction, Ray, Sample};
use crate::error::{Error, Invariant, Result};
use crate::exact::{Rational, nearest_double};
use crate::shape::Superquadric;

/// The precision that a comparison begins with, in bits after the point.
pub(super) const FIRST_BITS: u64 = 128;

/// The largest number, in bits, of which a root is taken before a comparison is given up.
pub const MAX_ROOT_BITS: u64 = 1 << 22;

/// Solves `|x/a1|^(2/ε) + |y/a2|^(2/ε) = c` along directions.
///
/// With 2/ε = p/q in lowest terms the equation at a rational point is `α^(1/q) + β^(1/q) = c` with
/// rational `α = |x/a1|^p`, `β = |y/a2|^p`. Which side is larger is decided by integer q-th roots at growing
/// precision; equality of positive numbers needs both roots rational (real radicals of different classes are
/// linearly independent over Q: Besicovitch 1940), which is decided by exact roots. So every comparison ends, up
/// to [`MAX_ROOT_BITS`].
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::sample::{Direction, Ray, SuperquadricSolver};
/// use stellate::shape::Superquadric;
///
/// let one = Rational::one;
/// let diamond = Superquadric::new([one(), one()], Rational::from(2), one()).unwrap();
/// let Ray::Points(points) = SuperquadricSolver::new(&diamond).solve(&Direction::from_radians(0.0))? else { panic!() };
/// assert_eq!([points[0].r, points[1].r], [1.0, -1.0]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Debug)]
pub struct SuperquadricSolver<'a> {
    shape: &'a Superquadric,
    /// p/q = 2/ε
    p: u64,
    q: u64,
}

impl<'a> SuperquadricSolver<'a> {
    /// For this curve.
    #[must_use]
    pub fn new(shape: &'a Superquadric) -> Self {
        let exponent = shape.exponent();
        // What does not fit meets the limit of the roots.
        let small = |n: Integer| u64::try_from(&n).unwrap_or(u64::MAX);
        Self {
            shape,
            p: small(exponent.numerator()),
            q: small(exponent.denominator()),
        }
    }

    /// The two points r and −r in a direction; r, x and y each the double nearest to the exact value.
    ///
    /// Cost: some ten comparisons, each of two q-th roots of numbers with about (128 + bits of the direction)·p bits.
    ///
    /// # Errors
    /// [`Error::Limit`] if a comparison takes roots of numbers of more than [`MAX_ROOT_BITS`] bits.
    pub fn solve(&self, direction: &Direction) -> Result<Ray> {
        let (u, v) = (direction.u(), direction.v());
        let guess = self.shape.approximate_along(u.to_f64(), v.to_f64());
        let nearest = |factor: &Rational| {
            nearest_multiple(guess, factor, |r| self.compare(&(r * &u), &(r * &v)))
        };
        let (r, x, y) = (nearest(&Rational::one())?, nearest(&u)?, nearest(&v)?);
        let sample = |branch: usize, sign: f64| Sample {
            branch,
            r: sign * r,
            position: [signed(sign, x), signed(sign, y)],
            multiplicity: 1,
        };
        Ok(Ray::Points(vec![sample(0, 1.0), sample(1, -1.0)]))
    }

    /// The exact order of `|x/a1|^(2/ε) + |y/a2|^(2/ε)` and c: `Less` inside the curve.
    ///
    /// # Errors
    /// As [`SuperquadricSolver::solve`].
    pub fn compare(&self, x: &Rational, y: &Rational) -> Result<Ordering> {
        let [a1, a2] = self.shape.semi_axes();
        let level = self.shape.level();
        let bases = [(x / a1).abs(), (y / a2).abs()];
        self.check_size(bases.iter().map(Rational::bits).max().unwrap_or(0))?;
        let power = i64::try_from(self.p).invariant("a power is within the limit of bits");
        let radicands = bases.map(|base| base.pow(power).invariant("a power is not negative"));
        let roots = radicands
            .each_ref()
            .map(|radicand| exact_root(radicand, self.q));
        if let [Some(first), Some(second)] = roots {
            return Ok((first + second).cmp(level));
        }
        let mut bits = FIRST_BITS;
        loop {
            self.check_size(bits)?;
            let unit = Rational::from(Integer::from(1) << bits);
            let [first, second] = radicands
                .each_ref()
                .map(|radicand| self.scaled_root(radicand, bits));
            // Each root is less than one unit above its floor.
            let low = Rational::from(Integer::from(first + second));
            let scaled = level * &unit;
            if low >= scaled {
                // The sum of the roots is no integer multiple of a unit unless both are, and they are irrational.
                return Ok(Ordering::Greater);
            }
            if low + Rational::from(2) <= scaled {
                return Ok(Ordering::Less);
            }
            bits *= 2;
        }
    }

    fn check_size(&self, bits: u64) -> Result<()> {
        let largest = bits.saturating_mul(self.p.max(self.q));
        if largest <= MAX_ROOT_BITS {
            return Ok(());
        }
        Err(Error::limit(format!(
            "a point of the superquadric needs roots of numbers with more than {MAX_ROOT_BITS} bits: the exponent 2/e = {} or the numbers are too long",
            self.shape.exponent()
        )))
    }

    /// ⌊radicand^(1/q) · 2^bits⌋
    fn scaled_root(&self, radicand: &Rational, bits: u64) -> Natural {
        let (above, below) = natural_parts(radicand);
        // ⌊⌊n⌋^(1/q)⌋ = ⌊n^(1/q)⌋
        ((above << (bits * self.q)) / below).floor_root(self.q)
    }
}

/// The double nearest to factor·r, for the r > 0 at which a point on a ray goes from inside to outside: `compare` gives the
/// order of the point at r, `Less` inside. `guess` is near r.
pub(super) fn nearest_multiple(
    guess: f64,
    factor: &Rational,
    compare: impl Fn(&Rational) -> Result<Ordering>,
) -> Result<f64> {
    if factor.is_zero() {
        return Ok(0.0);
    }
    let start = guess * factor.to_f64().abs();
    // The boundary is beyond r where the point at r is inside.
    let magnitude = nearest_double(start.max(0.0), |bound| -> Result<Ordering> {
        let r = bound / &factor.abs();
        match r.signum() {
            1 => Ok(compare(&r)?.reverse()),
            _ => Ok(Ordering::Greater),
        }
    })?;
    Ok(magnitude * f64::from(factor.signum()))
}

/// The q-th root if it is rational.
pub(super) fn exact_root(radicand: &Rational, q: u64) -> Option<Rational> {
    let (above, below) = natural_parts(radicand);
    let root = |n: Natural| n.checked_root(q).map(Integer::from);
    Rational::new(root(above)?, root(below)?)
}

pub(super) fn natural_parts(q: &Rational) -> (Natural, Natural) {
    let natural = |n: Integer| n.unsigned_abs_ref().clone();
    (natural(q.numerator()), natural(q.denominator()))
}

/// sign · value, where 0 has no sign.
pub(super) fn signed(sign: f64, value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { sign * value }
}
