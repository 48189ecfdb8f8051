//! Polynomials in other coordinates.

use std::collections::BTreeMap;

use super::{SparsePolynomial, shift_rational};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;

impl SparsePolynomial<3> {
    /// f(c + 2^e X) as a polynomial in X, with a center and an exponent for each axis.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(crate) fn in_coordinates(
        &self,
        center: &[Rational; 3],
        exponents: [i32; 3],
        limits: &Limits,
    ) -> Result<Self> {
        let mut f = self.clone();
        for axis in 0..3 {
            let mut rows: BTreeMap<[u32; 3], Vec<Rational>> = BTreeMap::new();
            for (e, c) in f.terms() {
                let mut others = *e;
                others[axis] = 0;
                let row = rows.entry(others).or_default();
                let place = e[axis] as usize;
                row.resize(row.len().max(place + 1), Rational::zero());
                row[place] = c.clone();
            }
            let mut terms = Vec::new();
            let unit = Rational::from(2).pow(i64::from(exponents[axis]));
            let unit = unit.invariant("2 is not 0");
            for (others, mut row) in rows {
                limits.check()?;
                shift_rational(&mut row, &center[axis]);
                let mut power = Rational::one();
                for (k, c) in (0..).zip(row) {
                    let mut e = others;
                    e[axis] = k;
                    terms.push((e, c * &power));
                    power = power * &unit;
                }
            }
            f = Self::from_terms(terms);
        }
        Ok(f)
    }

    /// f(c + X) as a polynomial in X.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(crate) fn about(&self, center: &[Rational; 3], limits: &Limits) -> Result<Self> {
        self.in_coordinates(center, [0; 3], limits)
    }

    /// The coefficients, ascending, of f(t v); there are none if f is 0 on this line.
    pub(crate) fn along(&self, v: &[Rational; 3]) -> Vec<Rational> {
        let mut row: Vec<Rational> = Vec::new();
        for (e, c) in self.terms() {
            let degree = e.iter().sum::<u32>() as usize;
            row.resize(row.len().max(degree + 1), Rational::zero());
            let powers = e.iter().zip(v).filter(|(e, _)| **e > 0);
            let value = powers.fold(c.clone(), |value, (e, v)| {
                value * v.pow(i64::from(*e)).invariant("e > 0")
            });
            row[degree] = &row[degree] + value;
        }
        let used = row.iter().rposition(|c| !c.is_zero());
        row.truncate(used.map_or(0, |last| last + 1));
        row
    }

    /// The coefficients, ascending, of f(p + t e) for the unit vector e of an axis.
    pub(crate) fn along_axis(&self, axis: usize, p: &[Rational; 3]) -> Vec<Rational> {
        let degrees = [0, 1, 2].map(|i| self.degree_in(i));
        let powers: [Vec<Rational>; 3] = std::array::from_fn(|i| {
            let all = std::iter::successors(Some(Rational::one()), |power| Some(power * &p[i]));
            all.take(degrees[i] as usize + 1).collect()
        });
        let mut row = vec![Rational::zero(); degrees[axis] as usize + 1];
        for (e, c) in self.terms() {
            let others = (0..3).filter(|&i| i != axis);
            let value = others.fold(c.clone(), |value, i| value * &powers[i][e[i] as usize]);
            let place = &mut row[e[axis] as usize];
            *place = &*place + value;
        }
        shift_rational(&mut row, &p[axis]);
        row
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn polynomial() -> impl Strategy<Value = SparsePolynomial<3>> {
        let term = (prop::array::uniform3(0u32..5), -9i64..9);
        prop::collection::vec(term, 1..8).prop_map(|terms| {
            SparsePolynomial::from_terms(terms.into_iter().map(|(e, c)| (e, c.into())))
        })
    }

    fn point() -> impl Strategy<Value = [Rational; 3]> {
        prop::array::uniform3((-9i64..9, 1i64..5))
            .prop_map(|p| p.map(|(a, b)| Rational::from(a) / Rational::from(b)))
    }

    proptest! {
        #[test]
        fn values_are_kept(
            f in polynomial(), center in point(), exponents in prop::array::uniform3(-5i32..5), at in point(),
        ) {
            let local = f.in_coordinates(&center, exponents, &Limits::none()).unwrap();
            let there: [Rational; 3] = std::array::from_fn(|i| {
                &center[i] + &at[i] * Rational::from(2).pow(exponents[i].into()).unwrap()
            });
            prop_assert_eq!(local.evaluate(&at), f.evaluate(&there));
        }

        #[test]
        fn values_on_a_line_through_the_origin_are_kept(f in polynomial(), v in point(), t in -9i64..9) {
            let t = Rational::from(t);
            let row = f.along(&v);
            let value = row.iter().rev().fold(Rational::zero(), |sum, c| sum * &t + c);
            prop_assert_eq!(value, f.evaluate(&v.map(|x| x * &t)));
            prop_assert!(row.last().is_none_or(|c| !c.is_zero()));
        }

        #[test]
        fn values_on_a_line_are_kept(f in polynomial(), p in point(), axis in 0usize..3, t in -9i64..9) {
            let t = Rational::from(t);
            let row = f.along_axis(axis, &p);
            let value = row.iter().rev().fold(Rational::zero(), |sum, c| sum * &t + c);
            let mut there = p;
            there[axis] = &there[axis] + &t;
            prop_assert_eq!(value, f.evaluate(&there));
        }
    }
}
