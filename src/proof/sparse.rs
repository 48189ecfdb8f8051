//! Polynomials in several variables with integer coefficients, as maps from exponents to coefficients.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use num_bigint::BigInt;

use super::clock;
use super::numbers::{Exact, common_denominator, greatest_common_divisor, is_zero, powers, sign};
use super::refusal::{Checked, need_within_limit};
use super::univariate::{Coefficients, shrink, substitute};

/// The exponents of the variables; those of missing variables are 0. Four generators are enough: two angles have two each.
pub(super) type Exponents = [u32; 4];

/// The largest cost of one product: the number of pairs of terms, times the largest number of bits in each factor and this number.
const LARGEST_PRODUCT: u64 = 10_000_000_000;
const BITS_OF_A_TERM: u64 = 300;

/// A polynomial in up to four variables. No coefficient is 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Sparse {
    terms: BTreeMap<Exponents, BigInt>,
}

impl Sparse {
    pub(super) fn constant(value: impl Into<BigInt>) -> Self {
        let mut result = Self::default();
        result.add_term([0; 4], value.into());
        result
    }

    /// x² + y² or x² + y² + z².
    pub(super) fn squared_radius(dimension: usize) -> Self {
        let mut result = Self::default();
        for axis in 0..dimension {
            let mut exponents = [0; 4];
            exponents[axis] = 2;
            result.add_term(exponents, BigInt::from(1));
        }
        result
    }

    pub(super) fn terms(&self) -> impl Iterator<Item = (&Exponents, &BigInt)> {
        self.terms.iter()
    }

    pub(super) fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    pub(super) fn add_term(&mut self, exponents: Exponents, coefficient: BigInt) {
        match self.terms.entry(exponents) {
            Entry::Occupied(mut entry) => {
                *entry.get_mut() += coefficient;
                if is_zero(entry.get()) {
                    entry.remove();
                }
            }
            Entry::Vacant(entry) => {
                if !is_zero(&coefficient) {
                    entry.insert(coefficient);
                }
            }
        }
    }

    /// Adds factor·other.
    pub(super) fn add_multiple(&mut self, factor: &BigInt, other: &Self) {
        for (exponents, c) in &other.terms {
            self.add_term(*exponents, factor * c);
        }
    }

    pub(super) fn times(&self, other: &Self) -> Checked<Self> {
        let pairs = (self.terms.len() as u64).saturating_mul(other.terms.len() as u64);
        let bits = self.largest_bits() + other.largest_bits() + BITS_OF_A_TERM;
        need_within_limit(
            pairs.saturating_mul(bits) <= LARGEST_PRODUCT,
            "this expansion is longer than the limit",
        )?;
        clock::need_time()?;
        let mut sums: BTreeMap<Exponents, BigInt> = BTreeMap::new();
        for (e, a) in &self.terms {
            for (h, b) in &other.terms {
                let exponents = [e[0] + h[0], e[1] + h[1], e[2] + h[2], e[3] + h[3]];
                *sums.entry(exponents).or_default() += a * b;
            }
        }
        sums.retain(|_, c| !is_zero(c));
        Ok(Self { terms: sums })
    }

    pub(super) fn power(&self, exponent: u32) -> Checked<Self> {
        let mut result = Self::constant(1);
        for _ in 0..exponent {
            result = result.times(self)?;
        }
        Ok(result)
    }

    /// The total degree; 0 for the zero polynomial.
    pub(super) fn degree(&self) -> u32 {
        self.terms.keys().map(total).max().unwrap_or(0)
    }

    /// The number of bits of the largest coefficient.
    fn largest_bits(&self) -> u64 {
        self.terms.values().map(BigInt::bits).max().unwrap_or(0)
    }

    /// The lowest total degree of a term; 0 for the zero polynomial.
    pub(super) fn lowest_degree(&self) -> u32 {
        self.terms.keys().map(total).min().unwrap_or(0)
    }

    /// The degree in one variable.
    pub(super) fn degree_in(&self, axis: usize) -> u32 {
        self.terms
            .keys()
            .map(|exponents| exponents[axis])
            .max()
            .unwrap_or(0)
    }

    /// Whether one of the polynomials is a rational multiple, not 0, of the other. Neither may be zero.
    pub(super) fn is_proportional_to(&self, other: &Self) -> bool {
        let (Some((e, a)), Some((h, b))) =
            (self.terms.first_key_value(), other.terms.first_key_value())
        else {
            return false;
        };
        let shared = greatest_common_divisor(a, b);
        let (a, b) = (a / &shared, b / shared);
        e == h
            && self.terms.len() == other.terms.len()
            && self
                .terms
                .iter()
                .zip(&other.terms)
                .all(|((e, c), (h, d))| e == h && c * &b == d * &a)
    }

    /// The polynomial with the variable v of this axis replaced by a + b·v, times a positive integer.
    pub(super) fn substituted(&self, axis: usize, a: &Exact, b: &Exact) -> Self {
        let mut lines: BTreeMap<Exponents, Coefficients> = BTreeMap::new();
        let length = self.degree_in(axis) as usize + 1;
        for (exponents, c) in &self.terms {
            let mut others = *exponents;
            others[axis] = 0;
            let line = lines
                .entry(others)
                .or_insert_with(|| vec![BigInt::ZERO; length]);
            line[exponents[axis] as usize] = c.clone();
        }
        let mut result = Self::default();
        for (others, mut line) in lines {
            substitute(&mut line, a, b);
            for (c, exponent) in line.into_iter().zip(0..) {
                let mut exponents = others;
                exponents[axis] = exponent;
                result.add_term(exponents, c);
            }
        }
        result
    }

    /// f(point + v) times a positive integer, as a polynomial in v.
    pub(super) fn about(&self, point: &[Exact]) -> Self {
        let one = Exact::one();
        let mut result = self.clone();
        for (axis, coordinate) in point.iter().enumerate() {
            result = result.substituted(axis, coordinate, &one);
        }
        result
    }

    /// f(s·direction) times a positive integer, as a polynomial in s of formal degree deg f. The polynomial is one in two or
    /// three variables.
    pub(super) fn along(&self, direction: &[Exact]) -> Coefficients {
        let (integers, common) = common_denominator(direction);
        let degree = self.degree() as usize;
        let mut result = self.parts_at(&integers);
        shrink(&mut result, &common);
        result.resize(degree + 1, BigInt::ZERO);
        result
    }

    /// The sign of the value at a point.
    pub(super) fn sign_at(&self, point: &[Exact]) -> i64 {
        sign(&self.along(point).iter().sum())
    }

    /// The values of the homogeneous parts of the degrees 0, 1, … at a point with two or three integer coordinates.
    pub(super) fn parts_at(&self, point: &[BigInt]) -> Vec<BigInt> {
        let (x, y) = (&point[0], &point[1]);
        let heights = powers(
            point.get(2).unwrap_or(&BigInt::ZERO),
            self.degree_in(2) as usize,
        );
        // The terms of one degree and one exponent of z make a form in x and y: the list of its coefficients by exponents of x.
        let mut slices: BTreeMap<(usize, usize), Coefficients> = BTreeMap::new();
        for (&[i, j, h, _], c) in &self.terms {
            let slice = slices
                .entry(((i + j + h) as usize, h as usize))
                .or_insert_with(|| vec![BigInt::ZERO; (i + j) as usize + 1]);
            slice[i as usize] = c.clone();
        }
        let mut result = vec![BigInt::ZERO; self.degree() as usize + 1];
        let mut squares = Squares::new(x, y);
        for ((degree, height), slice) in slices {
            result[degree] += binary_form_at(slice, &mut squares) * &heights[height];
        }
        result
    }
}

fn total(exponents: &Exponents) -> u32 {
    exponents.iter().sum()
}

/// The powers x^(2^k) and y^(2^k), as far as they have been needed.
struct Squares {
    x: Vec<BigInt>,
    y: Vec<BigInt>,
}

impl Squares {
    fn new(x: &BigInt, y: &BigInt) -> Self {
        Self {
            x: vec![x.clone()],
            y: vec![y.clone()],
        }
    }

    fn extend_to(&mut self, level: usize) {
        for list in [&mut self.x, &mut self.y] {
            while list.len() <= level {
                let last = &list[list.len() - 1];
                list.push(last * last);
            }
        }
    }

    /// y^exponent, from the binary digits of the exponent.
    fn y_power(&self, exponent: usize) -> BigInt {
        let digits = self
            .y
            .iter()
            .enumerate()
            .filter(|(level, _)| exponent >> level & 1 == 1);
        digits.fold(BigInt::from(1), |product, (_, square)| product * square)
    }
}

/// Σ c_i·x^i·y^(n − i) with n + 1 coefficients. Neighbouring blocks of coefficients are joined until one is left, so that most
/// products have factors of similar size.
fn binary_form_at(form: Coefficients, squares: &mut Squares) -> BigInt {
    // All blocks have 2^level coefficients, but for the last one, which has `last`.
    let (mut blocks, mut level, mut last) = (form, 0, 1);
    while blocks.len() > 1 {
        squares.extend_to(level);
        let whole = 1 << level;
        let pairs = blocks.len() / 2;
        let joined = blocks
            .chunks(2)
            .enumerate()
            .map(|(index, pair)| match pair {
                [low, high] if index + 1 == pairs && blocks.len() % 2 == 0 && last < whole => {
                    low * squares.y_power(last) + high * &squares.x[level]
                }
                [low, high] => low * &squares.y[level] + high * &squares.x[level],
                rest => rest[0].clone(),
            });
        let joined = joined.collect();
        if blocks.len() % 2 == 0 {
            last += whole;
        }
        (blocks, level) = (joined, level + 1);
    }
    blocks.pop().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;

    use super::Sparse;
    use crate::proof::numbers::Exact;

    /// A polynomial with all terms up to a degree, with coefficients of different signs and sizes.
    fn full(dimension: usize, degree: u32) -> Sparse {
        let mut f = Sparse::default();
        let height = if dimension == 3 { degree } else { 0 };
        for i in 0..=degree {
            for j in 0..=degree - i {
                for k in 0..=height.min(degree - i - j) {
                    let c = 7 * i64::from(i * i) - 5 * i64::from(j) + i64::from(k) - 3;
                    f.add_term([i, j, k, 0], BigInt::from(c));
                }
            }
        }
        f
    }

    fn value(f: &Sparse, point: &[i64]) -> BigInt {
        let power = |axis: usize, exponent: u32| {
            point
                .get(axis)
                .map_or(BigInt::from(1), |x| BigInt::from(*x).pow(exponent))
        };
        f.terms()
            .map(|(e, c)| c * power(0, e[0]) * power(1, e[1]) * power(2, e[2]))
            .sum()
    }

    #[test]
    fn the_homogeneous_parts_add_up_to_the_value() {
        for (dimension, point) in [(2, vec![3, -2]), (3, vec![-5, 2, 7]), (3, vec![0, 0, 1])] {
            for degree in 0..9 {
                let f = full(dimension, degree);
                let integers: Vec<_> = point.iter().map(|x| BigInt::from(*x)).collect();
                assert_eq!(
                    f.parts_at(&integers).iter().sum::<BigInt>(),
                    value(&f, &point)
                );
            }
        }
    }

    #[test]
    fn a_polynomial_is_moved_by_substitution() {
        let f = full(3, 4);
        let half = Exact::fraction(1.into(), 2.into());
        let moved = f.about(&[half.clone(), Exact::integer(-1), Exact::zero()]);
        // The substitution of a half multiplies by 2^4, since 4 is the degree in x.
        let back = moved.about(&[-&half, Exact::one(), Exact::zero()]);
        assert!(back.is_proportional_to(&f));
        assert_eq!(
            value(
                &f.about(&[Exact::one(), Exact::one(), Exact::one()]),
                &[1, 2, -4]
            ),
            value(&f, &[2, 3, -3])
        );
    }

    #[test]
    fn proportional_polynomials_have_one_factor_for_all_terms() {
        let f = full(2, 3);
        let mut g = Sparse::default();
        g.add_multiple(&BigInt::from(-6), &f);
        assert!(g.is_proportional_to(&f));
        g.add_term([1, 1, 0, 0], BigInt::from(1));
        assert!(!g.is_proportional_to(&f));
        assert!(!Sparse::default().is_proportional_to(&f));
    }
}
