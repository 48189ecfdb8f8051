//! Rays in a bounded number of bits: forms cut to W limbs, the roots along a direction proved and rounded.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Gcd;

use super::parts::{Basis, ExpandedPart, Expansion};
use super::point::{Sample, in_order};
use super::wide::Wide;
use crate::poly::{
    BoundedRoot, FOR_DOUBLES, Fixed, Signed, Truncated, Unproved, roots_of, rotations,
};

/// Neighbouring doubles that are tried when the guess is not the nearest.
const TRIES: usize = 4;

/// The homogeneous parts of a polynomial with coefficients of W limbs.
#[derive(Debug)]
pub(super) struct TruncatedForms<const W: usize, const V: usize> {
    basis: Basis,
    /// The functions of the basis that occur, each once, by their indices: as they are seen from each coordinate, which
    /// is 1 then.
    functions: [Functions<V>; V],
    /// Ascending in degree.
    parts: Vec<Part<W, V>>,
    /// All degrees are the lowest one plus multiples of it.
    gap: u32,
}

/// 2^(exponent + 8) Σ c b over functions b of the basis, Σ |c| ≤ 1/4.
#[derive(Debug)]
struct Part<const W: usize, const V: usize> {
    degree: usize,
    exponent: i64,
    /// The number of the function, as seen from each coordinate, and c.
    terms: Vec<([u32; V], Signed<W>)>,
}

/// Functions of a basis, numbered.
#[derive(Debug, Default)]
struct Functions<const V: usize> {
    indices: Vec<[usize; V]>,
    numbers: BTreeMap<[usize; V], u32>,
}

impl<const V: usize> Functions<V> {
    /// The number of a function, which it has or gets.
    fn number(&mut self, indices: [usize; V]) -> u32 {
        *self.numbers.entry(indices).or_insert_with(|| {
            self.indices.push(indices);
            // There are fewer than terms.
            u32::try_from(self.indices.len() - 1).unwrap_or(u32::MAX)
        })
    }
}

/// The line through the origin and a vector, x = λ·(v / unit): seen from its largest coordinate where the basis is
/// that of powers, and from its length where it is that of harmonics.
struct Line<'a, const W: usize, const V: usize> {
    vector: &'a [Integer; V],
    unit: &'a Integer,
    /// The coordinate from which functions are numbered.
    pivot: usize,
    /// The values of the functions at v / unit.
    values: Vec<Signed<W>>,
}

impl<const W: usize, const V: usize> TruncatedForms<W, V> {
    pub(super) fn new(expansion: &Expansion<'_, V>) -> Self {
        let basis = expansion.basis;
        let mut functions = std::array::from_fn(|_| Functions::default());
        let mut numbers = |indices: &[usize; V]| {
            std::array::from_fn(|pivot| {
                let mut seen = *indices;
                if basis == Basis::Powers {
                    seen[pivot] = 0;
                }
                functions[pivot].number(seen)
            })
        };
        let parts = expansion.parts.iter();
        let mut parts: Vec<Part<W, V>> = parts.map(|part| Part::new(part, &mut numbers)).collect();
        parts.sort_by_key(|part| part.degree);
        let lowest = parts.first().map_or(0, |part| part.degree);
        let gap = parts
            .iter()
            .fold(0, |gap: usize, part| gap.gcd(part.degree - lowest));
        Self {
            basis,
            functions,
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
        let line = match self.basis {
            Basis::Powers => Line::from_largest(vector, &self.functions, highest),
            Basis::Harmonics => Line::from_length(vector, w, &self.functions[0], highest),
        };
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
    fn new(part: &ExpandedPart<'_, V>, numbers: &mut impl FnMut(&[usize; V]) -> [u32; V]) -> Self {
        let cut = part.terms.iter();
        let cut: Vec<_> = cut
            .map(|(b, c)| (numbers(b), Fixed::normalized(c)))
            .collect();
        let largest = cut.iter().map(|(_, (_, exponent))| *exponent).max();
        let exponent = largest.unwrap_or(0) - Fixed::<W>::room_for(cut.len());
        let terms = cut.into_iter();
        let terms = terms.map(|(b, (c, own))| (b, c.shifted_down(exponent - own).over_256()));
        Self {
            degree: part.degree,
            exponent: exponent + part.exponent,
            terms: terms.collect(),
        }
    }

    /// The value at v / unit.
    fn value(&self, line: &Line<'_, W, V>) -> Truncated<W> {
        let sum = self.terms.iter().fold(Fixed::ZERO, |sum, (b, c)| {
            sum.plus_product(c, &line.values[b[line.pivot] as usize])
        });
        // Each coefficient is cut (2 ulps), each product rounded (W). The values of the functions are wrong by at most
        // ((3W + 2) d + 1) 2^(−64W), that is by so many 256ths of an ulp, and Σ |c| ≤ 64 in these units: (W + 1) d + 1.
        let error = (W + 2) * self.terms.len() + (W + 1) * self.degree + 1;
        Truncated {
            mantissa: sum,
            exponent: self.exponent,
            error: error as u64,
        }
    }
}

impl<'a, const W: usize, const V: usize> Line<'a, W, V> {
    fn from_largest(
        vector: &'a [Integer; V],
        functions: &[Functions<V>; V],
        degree: usize,
    ) -> Self {
        let size = |i: &usize| vector[*i].unsigned_abs_ref();
        let pivot = (0..V).max_by_key(size).unwrap_or(0);
        let unit = &vector[pivot];
        let powers: [Vec<Signed<W>>; V] = std::array::from_fn(|i| {
            if i == pivot {
                return Vec::new();
            }
            let ratio = Signed::quotient(&vector[i], unit);
            let powers =
                std::iter::successors(Some(Signed::ONE), |power| Some(power.times(&ratio)));
            powers.take(degree + 1).collect()
        });
        // With the errors 1 of 1 and of the ratio, and W of a product, an x^e is wrong by at most (W + 1) e + 1 and a
        // product of two or three of them, Σ e ≤ d, by 2W + 1 more: not more than (3W + 2) d + 1.
        let value = |indices: &[usize; V]| {
            let factors = powers.iter().zip(indices).filter(|(_, e)| **e > 0);
            let product = factors
                .map(|(powers, e)| powers[*e])
                .reduce(|a, b| a.times(&b));
            product.unwrap_or(Signed::ONE)
        };
        Self {
            vector,
            unit,
            pivot,
            values: functions[pivot].indices.iter().map(value).collect(),
        }
    }

    /// For a vector of length w in the plane.
    fn from_length(
        vector: &'a [Integer; V],
        w: &'a Integer,
        functions: &Functions<V>,
        degree: usize,
    ) -> Self {
        let [cosines, sines] = rotations([0, 1].map(|i| Signed::quotient(&vector[i], w)), degree);
        let value = |indices: &[usize; V]| match indices[1] {
            0 => cosines[indices[0]],
            m => sines[m],
        };
        Self {
            vector,
            unit: w,
            pivot: 0,
            values: functions.indices.iter().map(value).collect(),
        }
    }

    /// The point with λ = sign · |root|^(1/gap).
    fn sample(&self, root: &BoundedRoot<W>, gap: u32, sign: i8, w: &Integer) -> Option<Sample<V>> {
        let rounding = Rounding::new(root, gap);
        let unit = self.unit;
        let along = |other: &Integer| -> Option<f64> {
            // λ · other / unit
            if *other == 0 {
                return Some(0.0);
            }
            let is_negative = (sign < 0) != ((*other < 0) != (*unit < 0));
            let size = rounding.nearest(unit, other)?;
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

    /// The double nearest to |root|^(1/gap) · |other / unit|.
    fn nearest(&self, unit: &Integer, other: &Integer) -> Option<f64> {
        let inverse = Wide::quotient(unit, other);
        let mut guess = self.guess / inverse.to_f64();
        for _ in 0..TRIES {
            if !(guess.is_normal() && guess.next_down().is_normal() && guess.next_up().is_finite())
            {
                return None;
            }
            let [below, above] = midpoints(guess);
            if self.compare(above, inverse, Ordering::Less)? == Ordering::Greater {
                guess = guess.next_up();
            } else if self.compare(below, inverse, Ordering::Greater)? == Ordering::Less {
                guess = guess.next_down();
            } else {
                return Some(guess);
            }
        }
        None
    }

    /// How |root|^(1/gap) / inverse compares with a bound; what is likely is tried first.
    fn compare(&self, bound: Wide, inverse: Wide, likely: Ordering) -> Option<Ordering> {
        // The root is 2^s y, or 2^s / y, and is compared with q 2^s.
        let q = bound.times(inverse).power(self.gap);
        let q = q.times_power_of_two(-self.scale);
        [likely, likely.reverse()].into_iter().find(|order| {
            // It is larger if its lower end is, and smaller if the upper one is.
            let y = if (*order == Ordering::Greater) == self.is_inverted {
                self.high
            } else {
                self.low
            };
            let certain = if self.is_inverted {
                Wide::exact(1, 0).certain_order(q.times(y))
            } else {
                y.certain_order(q)
            };
            certain == Some(*order)
        })
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
