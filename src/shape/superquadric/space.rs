//! [`SpaceSuperquadric`]: the superquadrics in space of Example 10, Eq. (77).

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Parity;

use super::roots::{Bounds, Exponent, FIRST_BITS, exact_power};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::poly::{Ring, SparsePolynomial};
use crate::shape::Radial;

/// The largest powers of sums that are expanded for an equation.
const MAX_POWER: u32 = 1000;

/// The closed surface `[|x/a1|^(2/ε2) + |y/a2|^(2/ε2)]^(ε2/ε1) + |z/a3|^(2/ε1) = c` about the origin, with exact
/// a1, a2, a3, ε1, ε2, c > 0; the paper has c = 1.
///
/// The left side is homogeneous of degree 2/ε1, so by Lemma 7
/// `R(θ, φ) = (c / {[|α/a1|^(2/ε2) + |β/a2|^(2/ε2)]^(ε2/ε1) + |γ/a3|^(2/ε1)})^(ε1/2)` with
/// (α, β, γ) = (sin φ cos θ, sin φ sin θ, cos φ), positive in every direction.
///
/// DIFFERENCE (erratum Eq. (77)): the paper prints `a2` under cos φ, which must be a3. The absolute values may be omitted only
/// for even integer exponents.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::shape::SpaceSuperquadric;
///
/// let one = Rational::one;
/// let half: Rational = "1/2".parse()?;
/// // (x⁴ + y⁴) + z⁴ = 1
/// let cube = SpaceSuperquadric::new([one(), one(), one()], [half.clone(), half], one()).unwrap();
/// assert_eq!(cube.polynomial()?.len(), 4);
/// assert!(cube.is_convex());
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpaceSuperquadric {
    semi_axes: [Rational; 3],
    epsilon: [Rational; 2],
    level: Rational,
}

impl SpaceSuperquadric {
    /// The superquadric with a1, a2, a3, then ε1 (north–south) and ε2 (around), and c; `None` unless all of them are positive.
    #[must_use]
    pub fn new(semi_axes: [Rational; 3], epsilon: [Rational; 2], level: Rational) -> Option<Self> {
        let positive = |q: &Rational| q.signum() > 0;
        let positive = semi_axes.iter().chain(&epsilon).all(positive) && positive(&level);
        positive.then_some(Self {
            semi_axes,
            epsilon,
            level,
        })
    }

    /// The semi-axes a1, a2 and a3.
    #[must_use]
    pub fn semi_axes(&self) -> &[Rational; 3] {
        &self.semi_axes
    }

    /// The numbers ε1 and ε2.
    #[must_use]
    pub fn epsilon(&self) -> &[Rational; 2] {
        &self.epsilon
    }

    /// The level c.
    #[must_use]
    pub fn level(&self) -> &Rational {
        &self.level
    }

    /// The exponents 2/ε2 of x and y, ε2/ε1 of their sum, and 2/ε1 of z.
    #[must_use]
    pub fn exponents(&self) -> [Rational; 3] {
        let [e1, e2] = &self.epsilon;
        let two = || Rational::from(2);
        [two() / e2, e2 / e1, two() / e1]
    }

    /// The number c^(ε1/2) by which the semi-axes are multiplied for c ≠ 1, if it is rational.
    pub(crate) fn exact_scale(&self) -> Option<Rational> {
        let half = &self.epsilon[0] / &Rational::from(2);
        exact_power(&self.level, Exponent::from(&half))
    }

    /// Whether the body inside is convex. It is a stretched ball of the norm with exponent 2/ε1 of the pair (norm with exponent
    /// 2/ε2 of (x, y), z), and these are norms exactly for exponents of at least 1 (Minkowski).
    #[must_use]
    pub fn is_convex(&self) -> bool {
        self.epsilon.iter().all(|e| *e <= Rational::from(2))
    }

    /// Whether all exponents of absolute values are even integers.
    #[must_use]
    pub fn has_even_exponents(&self) -> bool {
        let even = |q: &Rational| q.is_integer() && q.numerator().even();
        let [of_xy, _, of_z] = &self.exponents();
        even(of_xy) && even(of_z)
    }

    /// The degree of [`Self::polynomial`], if there is one, without its terms.
    #[must_use]
    pub(crate) fn polynomial_degree(&self) -> Option<Rational> {
        let [of_xy, of_sum, _] = self.exponents();
        let has_one = self.has_even_exponents() && !of_sum.denominator().even();
        has_one.then(|| of_xy * Rational::whole(of_sum.numerator()))
    }

    /// The primitive polynomial with the same zero set. It exists for even integers 2/ε2 and 2/ε1, and ε2/ε1 = p/q with odd q,
    /// and is then proportional to `[(x/a1)^(2/ε2) + (y/a2)^(2/ε2)]^p − (c − (z/a3)^(2/ε1))^q`.
    ///
    /// # Errors
    /// [`Error::Hypothesis`] with the reason if there is no such polynomial: for other exponents the left side is not smooth
    /// enough, and for even q the polynomial has a second sheet, where c − |z/a3|^(2/ε1) is negative. [`Error::Limit`] for p or q above
    /// 1000.
    pub fn polynomial(&self) -> Result<SparsePolynomial<3>> {
        let none = |witness: String| Error::Hypothesis {
            statement: "implicitization as a polynomial",
            witness: format!(
                "{witness}; describe, parametrize, sample, inspect, plot and mesh take any exponents"
            ),
        };
        let [of_xy, of_sum, of_z] = self.exponents();
        if !self.has_even_exponents() {
            return Err(none(format!(
                "the exponents 2/e2 of x and y and 2/e1 of z must be even integers, and here they are {of_xy} and {of_z}"
            )));
        }
        let (p, q) = (of_sum.numerator(), of_sum.denominator());
        if q.even() {
            return Err(none(format!(
                "with e2/e1 = {of_sum} the polynomial has a second sheet where 1 - |z/a3|^{of_z} is negative: its denominator must be odd"
            )));
        }
        let most = Integer::from(MAX_POWER);
        if p > most || q > most {
            return Err(Error::limit(format!(
                "the equation has powers of e2/e1 = {of_sum}: its numerator and denominator are at most {MAX_POWER}"
            )));
        }
        let small =
            |n: &Integer| u32::try_from(n).map_err(|_| Error::limit("exponents below 2^32"));
        let (m, n) = (small(&of_xy.numerator())?, small(&of_z.numerator())?);
        let power = |axis: usize, exponent: u32| {
            let scale = self.semi_axes[axis]
                .pow(-i64::from(exponent))
                .invariant("a semi-axis is not 0");
            let mut exponents = [0; 3];
            exponents[axis] = exponent;
            SparsePolynomial::from_terms([(exponents, scale)])
        };
        let sum = power(0, m).plus(&power(1, m));
        let rest = SparsePolynomial::constant(self.level.clone()).minus(&power(2, n));
        Ok(sum.pow(small(&p)?).minus(&rest.pow(small(&q)?)).primitive())
    }
}

impl Radial<3> for SpaceSuperquadric {
    fn approximate_along(&self, direction: [f64; 3]) -> f64 {
        let axes = self.semi_axes.each_ref().map(Rational::to_f64);
        let [m, _, n] = self.exponents().map(|q| q.to_f64());
        let scaled: [f64; 3] = std::array::from_fn(|i| (direction[i] / axes[i]).abs());
        let around = norm(scaled[0], scaled[1], m);
        self.level.to_f64().powf(1.0 / n) / norm(around, scaled[2], n)
    }

    /// The exact order of `[|x/a1|^m + |y/a2|^m]^k + |z/a3|^n` and c, with rational m = 2/ε2, k = ε2/ε1, n = 2/ε1.
    ///
    /// Integer roots at growing precision, as intervals, decide which side is larger. If all roots are rational, the sides are
    /// compared exactly, so that ties are found where they can be expected. A tie of nested radicals ends with an error at
    /// roots of numbers of 2²² bits; the answer is never a guess.
    fn compare(&self, point: &[Rational; 3]) -> Result<Ordering> {
        let exponents = self.exponents().each_ref().map(Exponent::from);
        let check_size = |bits: u64| {
            let why = || "the exponents or the numbers are too long".into();
            exponents.iter().try_for_each(|e| e.check_size(bits, &why))
        };
        let bases: [Rational; 3] = std::array::from_fn(|i| (&point[i] / &self.semi_axes[i]).abs());
        let size = bases.iter().map(Rational::bits).fold(0, u64::max);
        check_size(size)?;
        if let Some(value) = exact_value(exponents, &bases) {
            return Ok(value.cmp(&self.level));
        }
        let mut bits = FIRST_BITS;
        loop {
            check_size(bits + size)?;
            let [around, of_sum, of_z] = exponents;
            let [x, y] = [&bases[0], &bases[1]].map(|b| Bounds::of(b, bits).power(around, bits));
            let sum = x.plus(&y).power(of_sum, bits);
            let all = sum.plus(&Bounds::of(&bases[2], bits).power(of_z, bits));
            let scaled = &self.level * &Rational::whole(Integer::from(1) << bits);
            let [low, high] = [all.low, all.high].map(|n| Rational::whole(Integer::from(n)));
            if low > scaled {
                return Ok(Ordering::Greater);
            }
            if high < scaled {
                return Ok(Ordering::Less);
            }
            bits *= 2;
        }
    }
}

/// The left side, if it is known to be a rational number.
fn exact_value(
    [around, of_sum, of_z]: [Exponent; 3],
    [x, y, z]: &[Rational; 3],
) -> Option<Rational> {
    let height = exact_power(z, of_z)?;
    if x.is_zero() || y.is_zero() {
        // The bracket is a power of a power, with the exponent 2/ε2 · ε2/ε1 = 2/ε1 of z.
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

/// Values for drawing: doubles without certificate.
impl SpaceSuperquadric {
    /// The angles (θ, φ) of `4·count` directions around, in `2·count + 1` rows from pole to pole. Half of them have equal
    /// steps; the other half are those of the points `cos^ε1 η cos^ε2 ω, …`, which are dense where the surface bends.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a count of points is small")]
    pub fn angles(&self, count: usize) -> [Vec<f64>; 2] {
        let axes = self.semi_axes.each_ref().map(Rational::to_f64);
        let [e1, e2] = self.epsilon.each_ref().map(Rational::to_f64);
        let quarter = |from: f64, to: f64, epsilon: f64| -> Vec<f64> {
            // The angles in [0, π/2): half of them with equal steps, half with equal steps in the parameter of the
            // superellipse.
            let steps =
                (0..count).map(|k| (k as f64 + 0.5) / count as f64 * std::f64::consts::FRAC_PI_2);
            let mut all: Vec<f64> = steps
                .enumerate()
                .map(|(k, even)| {
                    let (s, c) = even.sin_cos();
                    if k % 2 == 0 {
                        even
                    } else {
                        (to * s.powf(epsilon)).atan2(from * c.powf(epsilon))
                    }
                })
                .collect();
            all.push(0.0);
            all.sort_unstable_by(f64::total_cmp);
            all.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
            all.retain(|a| *a < std::f64::consts::FRAC_PI_2 - 1e-9);
            all
        };
        let half = std::f64::consts::FRAC_PI_2;
        let around = quarter(axes[0], axes[1], e2);
        let mirrored = |list: &[f64]| -> Vec<f64> {
            // The angles in [0, π/2) and (π/2, π], with π/2 between them.
            let upper = list.iter().rev().map(|a| 2.0 * half - a);
            list.iter().copied().chain([half]).chain(upper).collect()
        };
        let mut thetas = mirrored(&around);
        let below: Vec<f64> = thetas[1..thetas.len() - 1]
            .iter()
            .rev()
            .map(|a| 4.0 * half - a)
            .collect();
        thetas.extend(below);
        let wide = axes[0].max(axes[1]);
        let phis = mirrored(&quarter(axes[2], wide, e1));
        [thetas, phis]
    }
}

/// The norm (a^p + b^p)^(1/p). The larger number is factored out, so that no power overflows.
fn norm(a: f64, b: f64, p: f64) -> f64 {
    let largest = a.max(b);
    if largest == 0.0 {
        return 0.0;
    }
    largest * ((a / largest).powf(p) + (b / largest).powf(p)).powf(1.0 / p)
}
