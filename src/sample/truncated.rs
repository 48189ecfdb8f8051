//! Rays in bounded arithmetic: forms with coefficients of W limbs, whose roots along a direction are proved and rounded.
//!
//! Balls carry all errors ([`Coefficients`], [`UnitBalls`], [`ScaledBall`]); no error is added up in this file.

use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Gcd;

use super::parts::{ExpandedPart, ExpandedParts, PartBasis};
use super::point::{Found, Sample, in_order};
use super::root_rounding::RootRounding;
use super::unit_vector::RationalLine;
use crate::error::Invariant;
use crate::exact::Rational;
use crate::roots::{
    BoundedRoot, Coefficients, FOR_DOUBLES, ScaledBall, UnitBall, UnitBalls, Unproved, roots_of,
    rotations,
};

/// The homogeneous parts of a polynomial with coefficients of W limbs.
#[derive(Debug)]
pub(super) struct TruncatedForms<const W: usize, const V: usize> {
    basis: PartBasis,
    /// The functions of the basis that occur, each once and by their indices. There is one list for each coordinate, for
    /// vectors that are scaled so that this coordinate is 1.
    functions: [Functions<V>; V],
    /// The parts, ascending in degree.
    parts: Vec<Part<W, V>>,
    /// The degrees differ from the lowest one by multiples of this number.
    gap: u32,
}

/// 2^exponent Σ c b over functions b of the basis.
#[derive(Debug)]
struct Part<const W: usize, const V: usize> {
    degree: usize,
    exponent: i64,
    /// For each coordinate, the numbers of the functions b in its list.
    functions: Vec<[u32; V]>,
    /// The coefficients c.
    coefficients: Coefficients<W>,
}

/// Functions of a basis, with numbers.
#[derive(Debug, Default)]
struct Functions<const V: usize> {
    indices: Vec<[usize; V]>,
    numbers: BTreeMap<[usize; V], u32>,
}

impl<const V: usize> Functions<V> {
    /// The number of a function. A function without a number gets the next one.
    fn number(&mut self, indices: [usize; V]) -> u32 {
        *self.numbers.entry(indices).or_insert_with(|| {
            self.indices.push(indices);
            u32::try_from(self.indices.len() - 1).invariant("there are fewer than 2^32 terms")
        })
    }
}

/// The line through the origin and a vector: x = λ·(v / unit). The unit is the largest coordinate for a basis of powers, and
/// the length for a basis of harmonics.
struct Line<'a, const W: usize, const V: usize> {
    vector: &'a [Integer; V],
    unit: &'a Integer,
    /// The coordinate whose list of functions is used.
    pivot: usize,
    /// The values of these functions at v / unit.
    values: UnitBalls<W>,
}

impl<const W: usize, const V: usize> TruncatedForms<W, V> {
    pub(super) fn new(expansion: &ExpandedParts<'_, V>) -> Self {
        let basis = expansion.basis;
        let mut functions = std::array::from_fn(|_| Functions::default());
        let mut numbers = |indices: &[usize; V]| {
            std::array::from_fn(|pivot| {
                let mut seen = *indices;
                if basis == PartBasis::Powers {
                    seen[pivot] = 0;
                }
                functions[pivot].number(seen)
            })
        };
        let parts = expansion.parts.iter();
        let mut parts: Vec<Part<W, V>> = parts.map(|part| Part::new(part, &mut numbers)).collect();
        parts.sort_unstable_by_key(|part| part.degree);
        let lowest = parts.first().map_or(0, |part| part.degree);
        let gap = parts
            .iter()
            .fold(0, |gap: usize, part| gap.gcd(part.degree - lowest));
        Self {
            basis,
            functions,
            parts,
            gap: u32::try_from(gap.max(1)).invariant("degrees are small"),
        }
    }

    /// Finds all points on the line through the vector, which has the length w.
    ///
    /// # Errors
    /// An error if W limbs do not prove that these are all roots, that they are simple, and which doubles are nearest.
    pub(super) fn solve(&self, through: &RationalLine<'_, V>) -> Result<Vec<Sample<V>>, Unproved> {
        let RationalLine { vector, w, center } = *through;
        let degree = |part: Option<&Part<W, V>>| part.map_or(0, |part| part.degree);
        let (lowest, highest) = (degree(self.parts.first()), degree(self.parts.last()));
        let line = match self.basis {
            PartBasis::Powers => Line::from_largest(vector, &self.functions, highest),
            PartBasis::Harmonics => Line::from_length(vector, w, &self.functions[0], highest),
        };
        let gap = self.gap as usize;
        let mut coefficients = vec![ScaledBall::ZERO; (highest - lowest) / gap + 1];
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
                let sample = line.sample(root, gap, *sign, w, center);
                samples.push(sample.ok_or(Unproved::Bits)?);
            }
        }
        Ok(in_order(samples))
    }
}

impl<const W: usize, const V: usize> Part<W, V> {
    fn new(part: &ExpandedPart<'_, V>, numbers: &mut impl FnMut(&[usize; V]) -> [u32; V]) -> Self {
        let integers = part.terms.iter().map(|(_, c)| &**c);
        let (coefficients, exponent) = Coefficients::of_integers(integers);
        Self {
            degree: part.degree,
            exponent: exponent + part.exponent,
            functions: part.terms.iter().map(|(b, _)| numbers(b)).collect(),
            coefficients,
        }
    }

    /// The value of the part at v / unit.
    fn value(&self, line: &Line<'_, W, V>) -> ScaledBall<W> {
        let functions = self.functions.iter().map(|b| b[line.pivot] as usize);
        ScaledBall {
            ball: self.coefficients.combination(&line.values, functions),
            exponent: self.exponent,
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
        let pivot = (0..V)
            .max_by_key(size)
            .invariant("a vector has coordinates");
        let unit = &vector[pivot];
        let powers: [Vec<UnitBall<W>>; V] = std::array::from_fn(|i| {
            if i == pivot {
                return Vec::new();
            }
            let ratio = UnitBall::quotient(&vector[i], unit);
            let powers =
                std::iter::successors(Some(UnitBall::ONE), |power| Some(power.times(&ratio)));
            powers.take(degree + 1).collect()
        });
        let value = |indices: &[usize; V]| {
            let factors = powers.iter().zip(indices).filter(|(_, e)| **e > 0);
            let product = factors
                .map(|(powers, e)| powers[*e])
                .reduce(|a, b| a.times(&b));
            product.unwrap_or(UnitBall::ONE)
        };
        Self {
            vector,
            unit,
            pivot,
            values: functions[pivot].indices.iter().map(value).collect(),
        }
    }

    /// The line of a vector of length w in the plane.
    fn from_length(
        vector: &'a [Integer; V],
        w: &'a Integer,
        functions: &Functions<V>,
        degree: usize,
    ) -> Self {
        let [cosines, sines] = rotations([0, 1].map(|i| UnitBall::quotient(&vector[i], w)), degree);
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
    fn sample(
        &self,
        root: &BoundedRoot<W>,
        gap: u32,
        sign: i8,
        w: &Integer,
        center: Option<&[Rational; V]>,
    ) -> Option<Found<V>> {
        let rounding = RootRounding::new(root, gap);
        let unit = self.unit;
        let is_negative = |other: &Integer| (sign < 0) != ((*other < 0) != (*unit < 0));
        let along = |other: &Integer| -> Option<f64> {
            // The other coordinate is λ · other / unit.
            if *other == 0 {
                return Some(0.0);
            }
            let size = rounding.nearest(unit, other)?;
            Some(if is_negative(other) { -size } else { size })
        };
        let mut relative = [0.0; V];
        for (value, other) in relative.iter_mut().zip(self.vector) {
            *value = along(other)?;
        }
        let mut position = None;
        if let Some(center) = center {
            let mut shifted = relative;
            for ((value, other), from) in shifted.iter_mut().zip(self.vector).zip(center) {
                *value = match *other == 0 {
                    true => from.to_f64(),
                    false => rounding.nearest_from(from, is_negative(other), unit, other)?,
                };
            }
            position = Some(shifted);
        }
        let relative = Sample {
            branch: 0,
            r: along(w)?,
            position: relative,
            multiplicity: 1,
        };
        Some(Found { relative, position })
    }
}
