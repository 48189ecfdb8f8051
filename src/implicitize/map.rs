//! Parametric forms as rational maps, and their values modulo a prime.

use crate::error::Invariant;
use crate::modular::PrimeField;
use crate::poly::{IntegerTerms, RationalFunction};
use crate::shape::{ParametricCurve, Patch, PatchFunction};

/// A parametric form whose coordinates are quotients of polynomials in s1 and s2.
pub(super) struct RationalMap {
    /// The numerator and the denominator of each coordinate.
    pub(super) coordinates: Vec<[IntegerTerms<2>; 2]>,
}

impl RationalMap {
    pub(super) fn of_curve<const N: usize>(curve: &ParametricCurve<N>) -> Self {
        Self::of_functions(curve.coordinates())
    }

    pub(super) fn of_functions(functions: &[RationalFunction]) -> Self {
        let both = |f: &RationalFunction| {
            [f.numerator(), f.denominator()].map(|p| IntegerTerms::from_univariate(p, 0))
        };
        Self {
            coordinates: functions.iter().map(both).collect(),
        }
    }

    pub(super) fn of_patch(patch: &Patch) -> Self {
        Self::of_patch_functions(patch.coordinates())
    }

    pub(super) fn of_patch_functions(functions: &[PatchFunction]) -> Self {
        Self {
            coordinates: functions
                .iter()
                .map(|f| [f.numerator(), f.denominator()].map(IntegerTerms::of_numerators))
                .collect(),
        }
    }

    /// Whether no denominator is 0 modulo the prime.
    pub(super) fn is_defined_modulo(&self, prime: u64) -> bool {
        let field = PrimeField::new(prime);
        let is_zero = |q: &IntegerTerms<2>| q.iter().all(|(_, c)| field.reduce_integer(c) == 0);
        self.coordinates.iter().all(|[_, q]| !is_zero(q))
    }

    /// The map modulo a prime below 2³¹.
    pub(super) fn modulo(&self, prime: u64) -> MapModulo {
        let field = PrimeField::new(prime);
        let coordinates = self.coordinates.iter();
        let coordinates: Vec<[Vec<Vec<u64>>; 2]> = coordinates
            .map(|both| both.each_ref().map(|terms| rows_modulo(terms, &field)))
            .collect();
        let rows = coordinates.iter().flatten().flatten();
        MapModulo {
            field,
            length: rows
                .map(Vec::len)
                .max()
                .invariant("a denominator has a term"),
            coordinates,
        }
    }
}

/// A rational map modulo a prime.
pub(super) struct MapModulo {
    field: PrimeField,
    /// One more than the largest exponent of s1.
    length: usize,
    /// For each numerator and denominator, the coefficients of the powers of s2, as lists ascending in s1.
    coordinates: Vec<[Vec<Vec<u64>>; 2]>,
}

impl MapModulo {
    /// The point at (s1, s2), `None` at a pole.
    pub(super) fn at(&self, [s1, s2]: [u64; 2]) -> Option<Vec<u64>> {
        let (field, p) = (&self.field, self.field.prime());
        let powers = field.powers(s1, self.length);
        let value = |rows: &[Vec<u64>]| {
            let rows = rows.iter().rev();
            rows.fold(0, |v, row| (v * s2 + field.dot(row, &powers)) % p)
        };
        // Neighbouring coordinates often have the same denominator.
        let mut last: Option<(&Vec<Vec<u64>>, u64)> = None;
        let mut point = Vec::with_capacity(self.coordinates.len());
        for [above, below] in &self.coordinates {
            let inverse = match last {
                Some((known, inverse)) if known == below => inverse,
                _ => match value(below) {
                    0 => return None,
                    1 => 1,
                    other => field.inverse(other),
                },
            };
            last = Some((below, inverse));
            point.push(field.mul(value(above), inverse));
        }
        Some(point)
    }
}

fn rows_modulo(terms: &IntegerTerms<2>, field: &PrimeField) -> Vec<Vec<u64>> {
    let mut rows: Vec<Vec<u64>> = Vec::new();
    for (e, c) in terms.iter() {
        let [in_row, row] = e.map(|k| k as usize);
        rows.resize(rows.len().max(row + 1), Vec::new());
        let row = &mut rows[row];
        row.resize(row.len().max(in_row + 1), 0);
        row[in_row] = field.reduce_integer(c);
    }
    rows
}
