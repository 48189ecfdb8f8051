//! From powers to the Bernstein basis on [0, 1].

use std::any::Any;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use super::super::binomials::binomials;
use super::super::flat::FlatPolynomial;
use super::super::form_bits;
use super::super::limbs::widen;
use super::super::mobius::ShiftByOne;
use super::SLACK;
use super::fixed::{Fixed, Fraction};
use super::newton::OnUnitInterval;

/// Bernstein coefficients, each known up to as many ulps as its error says.
#[derive(Debug)]
pub(super) struct Bernstein<'a, const W: usize> {
    pub(super) coefficients: Vec<Fixed<W>>,
    pub(super) errors: Cow<'a, [f64]>,
}

/// 1 / C(d, k) = 2^(−shift) · factor with a factor between 1/2 and 1, rounded down.
pub(super) struct InverseBinomial<const W: usize> {
    shift: u32,
    factor: Fraction<W>,
    /// All of it.
    nearest: f64,
}

/// 1 / C(d, 0), …, 1 / C(d, d).
pub(super) fn inverse_binomials<const W: usize>(degree: usize) -> Arc<Vec<InverseBinomial<W>>> {
    type Tables = BTreeMap<(usize, usize), Arc<dyn Any + Send + Sync>>;
    static TABLES: Mutex<Tables> = Mutex::new(BTreeMap::new());
    let compute = || {
        let inverse = |binomial: Integer| {
            let bits = binomial.significant_bits() - 1;
            let shift = u32::try_from(bits).unwrap_or(u32::MAX);
            let factor = Fraction::quotient(&(Integer::from(1) << bits), &binomial);
            InverseBinomial {
                shift,
                factor,
                nearest: factor.to_f64() / f64::from(shift).exp2(),
            }
        };
        Arc::new(binomials(degree).into_iter().map(inverse).collect())
    };
    let mut tables = TABLES.lock().unwrap_or_else(PoisonError::into_inner);
    let table = tables
        .entry((W, degree))
        .or_insert_with(|| compute() as Arc<dyn Any + Send + Sync>);
    let table = Arc::clone(table);
    drop(tables);
    table.downcast().unwrap_or_else(|_| compute())
}

/// The Bernstein coefficients are b_k = Σ_{i ≤ k} C(k, i)/C(d, i) c_i, and C(d, k) b_k those of `Σ c_i X^i (1 + X)^(d−i)`: a
/// Taylor shift of the c_i backwards.
impl<const W: usize> OnUnitInterval<W> {
    /// The Bernstein coefficients, given their errors. Cost: d²/2 additions, exact in integers that are d bits longer, and
    /// d products.
    pub(super) fn to_bernstein<'a>(
        &self,
        inverses: &[InverseBinomial<W>],
        errors: &'a [f64],
    ) -> Bernstein<'a, W> {
        let c = &self.coefficients;
        // Σ |c_i| is below 2^(64W − 1) ulps.
        let bits = form_bits(c.len().saturating_sub(1), 64 * W as u64 - 1);
        let mut shifted = FlatPolynomial::zero(c.len(), bits);
        for (target, c) in shifted.coefficients_mut().zip(c.iter().rev()) {
            widen(target, c.limbs());
        }
        shifted.run(ShiftByOne);
        let pairs = shifted.coefficients().rev().zip(inverses);
        let scaled = pairs.map(|(c, by)| Fixed::from_wide(c, by.shift).times(&by.factor));
        Bernstein {
            coefficients: scaled.collect(),
            errors: Cow::Borrowed(errors),
        }
    }

    /// The errors of the Bernstein coefficients, also of those for −y.
    pub(super) fn bernstein_errors(&self, inverses: &[InverseBinomial<W>]) -> Vec<f64> {
        let mut errors: Vec<f64> = self.errors.iter().rev().copied().collect();
        for start in (0..errors.len()).rev() {
            let rest = &mut errors[start..];
            for k in 1..rest.len() {
                rest[k - 1] += rest[k];
            }
        }
        errors.reverse();
        // Of what is cut, of the factor and of the product.
        let rounding = f64::from(u32::try_from(W + 2).unwrap_or(u32::MAX));
        for (error, by) in errors.iter_mut().zip(inverses) {
            *error = *error * by.nearest * SLACK + rounding;
        }
        errors
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use malachite::Natural;
    use proptest::prelude::*;

    const W: usize = 2;

    /// In ulps.
    fn integer(a: Fixed<W>) -> Integer {
        let size = Integer::from(Natural::from_limbs_asc(a.magnitude().as_slice()));
        if a.is_negative() { -size } else { size }
    }

    proptest! {
        /// Against exact sums: the error of a coefficient covers what any error of the c_i makes of it.
        #[test]
        fn errors_are_bounds(
            c in prop::collection::vec((any::<i64>(), 0u64..120, 0u32..70, -1i64..2), 1..90),
        ) {
            let room = Fixed::<W>::room_for(c.len());
            let numbers = c.iter().map(|(n, shift, error, sign)| {
                let (mantissa, exponent) = Fixed::<W>::normalized(&(Integer::from(*n) << *shift));
                let off = Integer::from(1u128 << error) * Integer::from(*sign);
                (mantissa.shifted_down(190 - exponent - room), f64::from(*error).exp2(), off)
            });
            let numbers: Vec<_> = numbers.collect();
            let polynomial = OnUnitInterval {
                coefficients: numbers.iter().map(|(c, _, _)| *c).collect(),
                errors: numbers.iter().map(|(_, e, _)| *e).collect(),
                error: 0,
            };
            let degree = c.len() - 1;
            let inverses = inverse_binomials(degree);
            let errors = polynomial.bernstein_errors(&inverses);
            let found = polynomial.to_bernstein(&inverses, &errors);
            let row = binomials(degree);
            for k in 0..=degree {
                let above = binomials(k);
                let terms = numbers[..=k].iter().enumerate().map(|(i, (c, _, off))| {
                    Rational::new(&above[i] * (integer(*c) + off), row[i].clone()).unwrap_or_default()
                });
                let truth = terms.fold(Rational::zero(), |sum, term| sum + term);
                let off = truth - Rational::from(integer(found.coefficients[k]));
                let error = Rational::try_from(found.errors[k]).unwrap_or_default();
                prop_assert!(off <= error && -off <= error, "{k}");
            }
        }
    }
}
