//! Rays in a bounded number of bits: forms cut to W limbs, the roots along a direction proved and rounded.

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Gcd;

use super::parts::HomogeneousParts;
use super::point::{Sample, in_order};
use super::wide::Wide;
use crate::poly::{BoundedRoot, FOR_DOUBLES, Fixed, Fraction, Truncated, Unproved, roots_of};

/// Neighbouring doubles that are tried when the guess is not the nearest.
const TRIES: usize = 4;

/// The homogeneous parts of a polynomial with coefficients of W limbs.
#[derive(Debug)]
pub(super) struct TruncatedForms<const W: usize, const V: usize> {
    /// Ascending in degree.
    parts: Vec<Part<W, V>>,
    /// All degrees are the lowest one plus multiples of it.
    gap: u32,
}

/// Σ c x^e · 2^exponent over the terms, Σ |c| ≤ 64.
#[derive(Debug)]
struct Part<const W: usize, const V: usize> {
    degree: usize,
    exponent: i64,
    terms: Vec<([usize; V], Fixed<W>)>,
}

/// The line through the origin and a vector, seen from its largest coordinate: x = λ·(v / v_pivot).
struct Line<'a, const W: usize, const V: usize> {
    vector: &'a [Integer; V],
    pivot: usize,
    /// The powers of |v_i / v_pivot|; none for the pivot itself.
    powers: [Vec<Fraction<W>>; V],
    is_negative: [bool; V],
}

impl<const W: usize, const V: usize> TruncatedForms<W, V> {
    pub(super) fn new(polynomial: &impl HomogeneousParts<V>) -> Self {
        let mut parts: Vec<Part<W, V>> = polynomial
            .terms_by_degree()
            .into_iter()
            .map(|(degree, terms)| Part::new(degree, &terms))
            .collect();
        parts.sort_by_key(|part| part.degree);
        let lowest = parts.first().map_or(0, |part| part.degree);
        let gap = parts
            .iter()
            .fold(0, |gap: usize, part| gap.gcd(part.degree - lowest));
        Self {
            parts,
            // Degrees are small.
            gap: u32::try_from(gap).unwrap_or(1).max(1),
        }
    }

    /// All points on the line through the vector, of length w.
    ///
    /// # Errors
    /// If W limbs do not prove that they are all, simple, and what the nearest doubles are.
    pub(super) fn solve(
        &self,
        vector: &[Integer; V],
        w: &Integer,
    ) -> Result<Vec<Sample<V>>, Unproved> {
        let degree = |part: Option<&Part<W, V>>| part.map_or(0, |part| part.degree);
        let (lowest, highest) = (degree(self.parts.first()), degree(self.parts.last()));
        let line = Line::new(vector, highest);
        let gap = self.gap as usize;
        let mut coefficients = vec![Truncated::ZERO; (highest - lowest) / gap + 1];
        for part in &self.parts {
            coefficients[(part.degree - lowest) / gap] = part.value(&line);
        }
        let gap = self.gap;
        let mut samples = Vec::new();
        for root in &roots_of(&coefficients, FOR_DOUBLES)? {
            // λ^gap is the root.
            let signs: &[i8] = match (gap.is_multiple_of(2), root.is_negative) {
                (true, true) => &[],
                (true, false) => &[1, -1],
                (false, true) => &[-1],
                (false, false) => &[1],
            };
            for sign in signs {
                let sample = line.sample(root, gap, *sign, w);
                samples.push(sample.ok_or(Unproved::Bits)?);
            }
        }
        Ok(in_order(samples))
    }
}

impl<const W: usize, const V: usize> Part<W, V> {
    fn new(degree: usize, terms: &[([usize; V], &Integer)]) -> Self {
        let cut = terms.iter().map(|(e, c)| (*e, Fixed::normalized(c)));
        let cut: Vec<_> = cut.collect();
        let largest = cut.iter().map(|(_, (_, exponent))| *exponent).max();
        let exponent = largest.unwrap_or(0) - Fixed::<W>::room_for(terms.len());
        let terms = cut.into_iter();
        let terms = terms.map(|(e, (c, own))| (e, c.shifted_down(exponent - own)));
        Self {
            degree,
            exponent,
            terms: terms.collect(),
        }
    }

    /// The value at v / v_pivot.
    fn value(&self, line: &Line<'_, W, V>) -> Truncated<W> {
        let mut sum = Fixed::ZERO;
        for (exponents, c) in &self.terms {
            let mut term = *c;
            for (i, e) in exponents.iter().enumerate() {
                if i != line.pivot && *e > 0 {
                    term = term.times(&line.powers[i][*e]);
                    if line.is_negative[i] && !e.is_multiple_of(2) {
                        term = term.negated();
                    }
                }
            }
            sum = sum.plus(term);
        }
        // Each coefficient is cut (2 ulps), each product rounded (V − 1 times W); the powers t^e are wrong by at most
        // ((W + 1) e + 1) 2^(−64W), which is so many 256ths of an ulp, and Σ |c| ≤ 64.
        let error = (2 + W * (V - 1)) * self.terms.len() + W * self.degree + V;
        Truncated {
            mantissa: sum,
            exponent: self.exponent,
            error: error as u64,
        }
    }
}

impl<'a, const W: usize, const V: usize> Line<'a, W, V> {
    fn new(vector: &'a [Integer; V], degree: usize) -> Self {
        let size = |i: &usize| vector[*i].unsigned_abs_ref();
        let pivot = (0..V).max_by_key(size).unwrap_or(0);
        let pivot_is_negative = vector[pivot] < 0;
        let powers = std::array::from_fn(|i| {
            if i == pivot {
                return Vec::new();
            }
            let ratio = Fraction::quotient(&vector[i], &vector[pivot]);
            let first =
                std::iter::successors(Some(Fraction::LARGEST), |power| Some(power.times(&ratio)));
            first.take(degree + 1).collect()
        });
        Self {
            vector,
            pivot,
            powers,
            is_negative: std::array::from_fn(|i| (vector[i] < 0) != pivot_is_negative),
        }
    }

    /// The point with λ = sign · |root|^(1/gap).
    fn sample(&self, root: &BoundedRoot<W>, gap: u32, sign: i8, w: &Integer) -> Option<Sample<V>> {
        let rounding = Rounding::new(root, gap);
        let pivot = &self.vector[self.pivot];
        let along = |other: &Integer| -> Option<f64> {
            // λ · other / pivot
            if *other == 0 {
                return Some(0.0);
            }
            let is_negative = (sign < 0) != ((*other < 0) != (*pivot < 0));
            let size = rounding.nearest(pivot, other)?;
            Some(if is_negative { -size } else { size })
        };
        let mut position = [0.0; V];
        for (value, other) in position.iter_mut().zip(self.vector) {
            *value = along(other)?;
        }
        Some(Sample {
            branch: 0,
            r: along(w)?,
            position,
            multiplicity: 1,
        })
    }
}

/// Rounds multiples of |root|^(1/gap).
struct Rounding {
    gap: u32,
    is_inverted: bool,
    scale: i64,
    low: Wide,
    high: Wide,
    /// About |root|^(1/gap).
    guess: f64,
}

impl Rounding {
    fn new<const W: usize>(root: &BoundedRoot<W>, gap: u32) -> Self {
        let y = root.low.to_f64();
        let sign = if root.is_inverted { -1.0 } else { 1.0 };
        let gap_f64 = f64::from(gap);
        // 2^s = 2^(whole gap) 2^rest, for roots beyond the doubles.
        let whole = root.scale.div_euclid(i64::from(gap));
        let rest = root.scale.rem_euclid(i64::from(gap));
        let small = |k: i64| f64::from(i32::try_from(k).unwrap_or(i32::MAX)).exp2();
        let guess = if gap == 1 {
            if root.is_inverted { 1.0 / y } else { y }
        } else {
            y.powf(sign / gap_f64) * (small(rest).powf(1.0 / gap_f64))
        };
        Self {
            gap,
            is_inverted: root.is_inverted,
            scale: root.scale,
            low: Wide::from_leading(root.low.leading()),
            high: Wide::from_leading(root.high.leading()),
            guess: guess * small(whole),
        }
    }

    /// The double nearest to |root|^(1/gap) · |other / pivot|.
    fn nearest(&self, pivot: &Integer, other: &Integer) -> Option<f64> {
        let inverse = Wide::quotient(pivot, other);
        let mut guess = self.guess / inverse.to_f64();
        for _ in 0..TRIES {
            if !(guess.is_normal() && guess.next_down().is_normal() && guess.next_up().is_finite())
            {
                return None;
            }
            let [below, above] = midpoints(guess);
            if self.compare(above, inverse)? == Ordering::Greater {
                guess = guess.next_up();
            } else if self.compare(below, inverse)? == Ordering::Less {
                guess = guess.next_down();
            } else {
                return Some(guess);
            }
        }
        None
    }

    /// How |root|^(1/gap) / inverse compares with a bound.
    fn compare(&self, bound: Wide, inverse: Wide) -> Option<Ordering> {
        // The root is 2^s y, or 2^s / y, and is compared with q 2^s.
        let q = bound.times(inverse).power(self.gap);
        let q = q.times_power_of_two(-self.scale);
        let one = Wide::exact(1, 0);
        let beside = |y: Wide| {
            if self.is_inverted {
                one.certain_order(q.times(y))
            } else {
                y.certain_order(q)
            }
        };
        let (low, high) = (beside(self.low)?, beside(self.high)?);
        (low == high).then_some(low)
    }
}

/// The midpoints between a positive normal double and its neighbours.
fn midpoints(double: f64) -> [Wide; 2] {
    let bits = double.to_bits();
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    let exponent = i64::try_from(bits >> 52).unwrap_or(0) - 1075;
    let below = if mantissa == 1 << 52 {
        // The doubles below are twice as close.
        Wide::exact(4 * mantissa - 1, exponent - 2)
    } else {
        Wide::exact(2 * mantissa - 1, exponent - 1)
    };
    [below, Wide::exact(2 * mantissa + 1, exponent - 1)]
}
