//! Certified points of superquadrics in space: nested roots, compared exactly.

use std::cmp::Ordering;

use malachite::base::num::arithmetic::traits::{FloorRoot, Pow};
use malachite::{Integer, Natural};

use super::superquadric::{
    FIRST_BITS, MAX_ROOT_BITS, exact_root, natural_parts, nearest_multiple, signed,
};
use super::{Ray, Sample, SpaceDirection, UnitVector};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::shape::SpaceSuperquadric;

/// Solves `[|x/a1|^m + |y/a2|^m]^k + |z/a3|^n = c` along directions, with rational m = 2/ε2, k = ε2/ε1, n = 2/ε1.
///
/// Which side is larger at a rational point is decided by integer roots at growing precision, in intervals. Where all
/// the roots are rational the sides are compared exactly, so that ties are found where they can be expected; a tie of
/// nested radicals would end at [`MAX_ROOT_BITS`] with a limit, never with a guess.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::sample::{Direction, Ray, SpaceDirection, SpaceSuperquadricSolver};
/// use stellate::shape::SpaceSuperquadric;
///
/// let [one, two] = [1, 2].map(Rational::from);
/// let shape = SpaceSuperquadric::new([one.clone(), one.clone(), two], [one.clone(), 3.into()], one).unwrap();
/// let up = SpaceDirection::new(Direction::from_radians(0.0), Direction::from_radians(0.0));
/// let Ray::Points(points) = SpaceSuperquadricSolver::new(&shape).solve(&up)? else { panic!() };
/// assert_eq!(points[0].position, [0.0, 0.0, 2.0]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Debug)]
pub struct SpaceSuperquadricSolver<'a> {
    shape: &'a SpaceSuperquadric,
    /// m, k and n.
    exponents: [Exponent; 3],
}

/// p/q > 0
#[derive(Clone, Copy, Debug)]
struct Exponent {
    p: u64,
    q: u64,
}

/// Bounds of a number, in units of 2^−bits.
#[derive(Clone, Debug)]
struct Bounds {
    low: Natural,
    high: Natural,
}

impl<'a> SpaceSuperquadricSolver<'a> {
    /// For this surface.
    #[must_use]
    pub fn new(shape: &'a SpaceSuperquadric) -> Self {
        // What does not fit meets the limit of the roots.
        let small = |n: Integer| u64::try_from(&n).unwrap_or(u64::MAX);
        Self {
            shape,
            exponents: shape.exponents().map(|e| Exponent {
                p: small(e.numerator()),
                q: small(e.denominator()),
            }),
        }
    }

    /// The two points R and −R in a direction; R, x, y and z each the double nearest to the exact value.
    ///
    /// # Errors
    /// [`Error::Limit`] if a comparison takes roots of numbers of more than [`MAX_ROOT_BITS`] bits.
    pub fn solve(&self, direction: &SpaceDirection) -> Result<Ray<3>> {
        let unit = direction.components();
        let guess = self
            .shape
            .approximate_along(unit.each_ref().map(Rational::to_f64));
        let nearest = |factor: &Rational| {
            nearest_multiple(guess, factor, |r| {
                self.compare(&unit.each_ref().map(|u| r * u))
            })
        };
        let r = nearest(&Rational::one())?;
        let [x, y, z] = unit.each_ref().map(nearest);
        let position = [x?, y?, z?];
        let sample = |branch: usize, sign: f64| Sample {
            branch,
            r: sign * r,
            position: position.map(|v| signed(sign, v)),
            multiplicity: 1,
        };
        Ok(Ray::Points(vec![sample(0, 1.0), sample(1, -1.0)]))
    }

    /// The exact order of the left side at a point and c: `Less` inside the surface.
    ///
    /// # Errors
    /// As [`SpaceSuperquadricSolver::solve`].
    pub fn compare(&self, point: &[Rational; 3]) -> Result<Ordering> {
        let axes = self.shape.semi_axes();
        let bases: [Rational; 3] = std::array::from_fn(|i| (&point[i] / &axes[i]).abs());
        let level = self.shape.level();
        let size = bases.iter().map(Rational::bits).max().unwrap_or(0);
        self.check_size(size)?;
        if let Some(value) = self.exact_value(&bases) {
            return Ok(value.cmp(level));
        }
        let mut bits = FIRST_BITS;
        loop {
            self.check_size(bits + size)?;
            let [around, of_sum, of_z] = self.exponents;
            let [x, y] = [&bases[0], &bases[1]].map(|b| Bounds::of(b, bits).power(around, bits));
            let sum = x.plus(&y).power(of_sum, bits);
            let all = sum.plus(&Bounds::of(&bases[2], bits).power(of_z, bits));
            let scaled = level * &Rational::from(Integer::from(1) << bits);
            let [low, high] = [all.low, all.high].map(|n| Rational::from(Integer::from(n)));
            if low > scaled {
                return Ok(Ordering::Greater);
            }
            if high < scaled {
                return Ok(Ordering::Less);
            }
            bits *= 2;
        }
    }

    /// The left side if it is a number that is known to be rational.
    fn exact_value(&self, [x, y, z]: &[Rational; 3]) -> Option<Rational> {
        let [around, of_sum, of_z] = self.exponents;
        let height = exact_power(z, of_z)?;
        if x.is_zero() || y.is_zero() {
            // One power of a power: its exponent is that of z.
            return Some(exact_power(&(x + y), of_z)? + height);
        }
        let both = [exact_power(x, around), exact_power(y, around)];
        if let [Some(x), Some(y)] = both {
            return Some(exact_power(&(x + y), of_sum)? + height);
        }
        // (x^m + y^m)^k = x^n (1 + (y/x)^m)^k
        let ratio = exact_power(&(y / x), around)?;
        let factor = exact_power(&(Rational::one() + ratio), of_sum)?;
        Some(exact_power(x, of_z)? * factor + height)
    }

    fn check_size(&self, bits: u64) -> Result<()> {
        let largest = self.exponents.iter().map(|e| e.p.max(e.q)).max();
        if bits.saturating_mul(largest.unwrap_or(1)) <= MAX_ROOT_BITS {
            return Ok(());
        }
        Err(Error::limit(format!(
            "a point of the superquadric needs roots of numbers with more than {MAX_ROOT_BITS} bits: the exponents or the numbers are too long"
        )))
    }
}

/// base^(p/q) if it is rational, for a base that is not negative.
fn exact_power(base: &Rational, Exponent { p, q }: Exponent) -> Option<Rational> {
    // For q > 1 in lowest terms the power is rational exactly if the root of the base is.
    exact_root(base, q)?.pow(i64::try_from(p).ok()?)
}

impl Bounds {
    fn of(value: &Rational, bits: u64) -> Self {
        let (above, below) = natural_parts(value);
        let low = (above << bits) / below;
        let high = &low + Natural::from(1u32);
        Self { low, high }
    }

    fn plus(&self, other: &Self) -> Self {
        Self {
            low: &self.low + &other.low,
            high: &self.high + &other.high,
        }
    }

    /// The (p/q)-th power. With v = n/2^b it is (n^p 2^(b(q − p)))^(1/q) units.
    fn power(&self, Exponent { p, q }: Exponent, bits: u64) -> Self {
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
