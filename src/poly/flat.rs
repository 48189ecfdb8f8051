//! Polynomials in one block of memory: every coefficient has the same number of limbs.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Square;

use super::IntegerPolynomial;
use super::limbs::{
    add, add_integer, decrement, increment, is_negative, negate, subtract, to_integer,
    trailing_zeros, widen, width_for,
};
use malachite::base::polynomial::Polynomial;

/// A polynomial whose coefficients, ascending, are two's complement numbers of one fixed width.
///
/// An addition costs about a nanosecond per limb, without a look at the heap, and the block is at the same time, but
/// for borrows, the value at 2^(64·width): products are products of two large integers (Kronecker's substitution).
///
/// The width is chosen by the user of the type, who knows a bound: sums that do not fit wrap around.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct FlatPolynomial {
    width: usize,
    limbs: Vec<u64>,
}

impl FlatPolynomial {
    /// `len` coefficients 0, with room for integers below 2^`bits`.
    pub(crate) fn zero(len: usize, bits: u64) -> Self {
        let width = width_for(bits);
        Self {
            width,
            limbs: vec![0; len * width],
        }
    }

    /// The coefficients, with room for integers below 2^`bits`.
    pub(crate) fn from_integers<'a>(
        coefficients: impl ExactSizeIterator<Item = &'a Integer>,
        bits: u64,
    ) -> Self {
        let mut flat = Self::zero(coefficients.len(), bits);
        for (target, c) in flat.coefficients_mut().zip(coefficients) {
            add_integer(target, c, false);
        }
        flat
    }

    /// The number of coefficients, leading zeros included.
    pub(crate) fn len(&self) -> usize {
        self.limbs.len() / self.width
    }

    /// Whether every coefficient is 0.
    pub(crate) fn is_zero(&self) -> bool {
        self.limbs.iter().all(|&limb| limb == 0)
    }

    /// The coefficients, ascending.
    pub(super) fn coefficients(&self) -> std::slice::ChunksExact<'_, u64> {
        self.limbs.chunks_exact(self.width)
    }

    /// The coefficients, ascending.
    pub(super) fn coefficients_mut(&mut self) -> std::slice::ChunksExactMut<'_, u64> {
        self.limbs.chunks_exact_mut(self.width)
    }

    /// `self[k] += value`, or `−=` if `negated`.
    pub(super) fn add_at(&mut self, k: usize, value: &Integer, negated: bool) {
        let target = &mut self.limbs[k * self.width..][..self.width];
        add_integer(target, value, negated);
    }

    /// The coefficients from `start` on, `step` apart, as many as asked for, with room for integers below 2^`bits`.
    pub(crate) fn part(&self, start: usize, step: usize, len: usize, bits: u64) -> Self {
        let mut part = Self::zero(len, bits);
        let from = self.coefficients().skip(start).step_by(step);
        for (target, c) in part.coefficients_mut().zip(from) {
            widen(target, c);
        }
        part
    }

    /// The coefficients of even and of odd powers, with room for integers below 2^`bits`.
    pub(crate) fn halves(&self, bits: u64) -> [Self; 2] {
        [0, 1].map(|start| self.part(start, 2, (self.len() + 1 - start) / 2, bits))
    }

    /// `self += x^at · other(x^step)`, for another that is not narrower.
    pub(crate) fn add(&mut self, other: &Self, at: usize, step: usize) {
        let targets = self.coefficients_mut().skip(at).step_by(step);
        for (target, c) in targets.zip(other.coefficients()) {
            add(target, c);
        }
    }

    /// `self −= x^at · other(x^step)`, for another that is not narrower.
    pub(crate) fn subtract(&mut self, other: &Self, at: usize, step: usize) {
        let targets = self.coefficients_mut().skip(at).step_by(step);
        for (target, c) in targets.zip(other.coefficients()) {
            subtract(target, c);
        }
    }

    /// `(1 + x²)^power · self` for a `self` that ends with 2·power coefficients 0: as many passes of additions.
    pub(crate) fn multiply_by_rho(&mut self, power: usize) {
        self.run(TimesRho { power });
    }

    /// Runs an operation on the coefficients in place, compiled for their width if that is small.
    pub(super) fn run(&mut self, operation: impl OnNumbers) {
        match self.width {
            1 => operation.run(self.limbs.as_chunks_mut::<1>().0),
            2 => operation.run(self.limbs.as_chunks_mut::<2>().0),
            3 => operation.run(self.limbs.as_chunks_mut::<3>().0),
            4 => operation.run(self.limbs.as_chunks_mut::<4>().0),
            5 => operation.run(self.limbs.as_chunks_mut::<5>().0),
            6 => operation.run(self.limbs.as_chunks_mut::<6>().0),
            _ => operation.run(&mut self.coefficients_mut().collect::<Vec<_>>()),
        }
    }

    /// `−self`.
    pub(crate) fn negate(&mut self) {
        self.coefficients_mut().for_each(negate);
    }

    /// The number of low zero bits that all coefficients have; `None` for the zero polynomial.
    pub(crate) fn trailing_zeros(&self) -> Option<u64> {
        self.coefficients().filter_map(trailing_zeros).min()
    }

    /// The coefficients times 2^`shift`, which are integers.
    pub(crate) fn to_integers(&self, shift: i64) -> impl Iterator<Item = Integer> {
        let mut scratch = Vec::with_capacity(self.width + 1);
        self.coefficients()
            .map(move |c| to_integer(c, shift, &mut scratch))
    }

    /// The polynomial with coefficients of any size.
    pub(crate) fn to_polynomial(&self) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(self.to_integers(0).collect())
    }
}

/// An operation on numbers of one width.
pub(super) trait OnNumbers {
    fn run<C: AsRef<[u64]> + AsMut<[u64]>>(self, numbers: &mut [C]);
}

struct TimesRho {
    power: usize,
}

impl OnNumbers for TimesRho {
    fn run<C: AsRef<[u64]> + AsMut<[u64]>>(self, numbers: &mut [C]) {
        let len = numbers.len().saturating_sub(2 * self.power);
        for done in 1..=self.power {
            for k in (2..len + 2 * done).rev() {
                let (low, high) = numbers.split_at_mut(k);
                add(high[0].as_mut(), low[k - 2].as_ref());
            }
        }
    }
}

/// From this many limbs on a square is put together from three of half the length, which take half again as much time
/// and half of the memory: a transform takes five to ten times as much as the number.
const SQUARE_IN_HALVES_FROM: usize = 1 << 20;

/// Kronecker's substitution: a polynomial with coefficients below 2^(64·width − 1) is determined by its value at
/// 2^(64·width). Quasi-linear in the size of the product.
impl FlatPolynomial {
    /// `self · other`, with room for integers below 2^`bits`, which its coefficients are.
    pub(crate) fn product(&self, other: &Self, bits: u64) -> Self {
        let width = width_for(bits);
        let value = self.packed(width) * other.packed(width);
        Self::unpacked(value, self.len() + other.len() - 1, width)
    }

    /// `self²`, with room for integers below 2^`bits`, which its coefficients are.
    pub(crate) fn square(&self, bits: u64) -> Self {
        let width = width_for(bits);
        if self.len() * width >= SQUARE_IN_HALVES_FROM {
            return self.square_in_halves(bits);
        }
        Self::unpacked(self.packed(width).square(), 2 * self.len() - 1, width)
    }

    /// The same by `(E + xO)² = E² + x²O² + x((E + O)² − E² − O²)`, E and O polynomials in x².
    fn square_in_halves(&self, bits: u64) -> Self {
        // |E² + O² + 2EO| ≤ 4 · 2^bits: that the sum may be wider does no harm, it is cut off.
        let room = bits + 2;
        let [mut even, odd] = self.halves(room);
        let mut square = Self::zero(2 * self.len() - 1, bits);
        for (half, at) in [(&even, 0), (&odd, 2)] {
            let part = half.square(room);
            square.add(&part, at, 2);
            square.subtract(&part, 1, 2);
        }
        even.add(&odd, 0, 1);
        drop(odd);
        square.add(&even.square(room), 1, 2);
        square
    }

    /// The value at 2^(64·width).
    pub(super) fn packed(&self, width: usize) -> Integer {
        let mut limbs = vec![0; self.len() * width];
        let mut borrow = false;
        for (target, c) in limbs.chunks_exact_mut(width).zip(self.coefficients()) {
            widen(target, c);
            if borrow {
                decrement(target);
            }
            borrow = is_negative(target);
        }
        Integer::from_owned_twos_complement_limbs_asc(limbs)
    }

    /// The polynomial with `len` coefficients of which this is the value at 2^(64·width).
    pub(super) fn unpacked(value: Integer, len: usize, width: usize) -> Self {
        let sign = if value < 0 { u64::MAX } else { 0 };
        let mut limbs = value.into_twos_complement_limbs_asc();
        limbs.resize(len * width, sign);
        let mut borrowed = false;
        for c in limbs.chunks_exact_mut(width) {
            let negative = is_negative(c);
            if borrowed {
                increment(c);
            }
            borrowed = negative;
        }
        Self { width, limbs }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn coefficients() -> impl Strategy<Value = Vec<Integer>> {
        let small = prop_oneof![
            Just(0),
            Just(-1),
            Just(i128::MIN),
            Just(i128::MAX),
            any::<i128>()
        ];
        prop::collection::vec(small.prop_map(Integer::from), 1..40)
    }

    proptest! {
        #[test]
        fn products_are_those_of_integer_polynomials(a in coefficients(), b in coefficients(), spare in 0u64..130) {
            let flat = |c: &[Integer]| FlatPolynomial::from_integers(c.iter(), 128);
            let long = |c: &[Integer]| IntegerPolynomial::from_coefficients_asc(c.to_vec());
            let bits = 256 + 6 + spare;
            prop_assert_eq!(flat(&a).to_polynomial(), long(&a));
            prop_assert_eq!(flat(&a).product(&flat(&b), bits).to_polynomial(), long(&a) * long(&b));
            prop_assert_eq!(flat(&a).square(bits).to_polynomial(), long(&a).square());
            if a.len() > 1 {
                prop_assert_eq!(flat(&a).square_in_halves(bits), flat(&a).square(bits));
            }
        }

        #[test]
        fn halves_are_put_together_and_rho_is_multiplied(a in coefficients(), power in 0usize..20, spare in 0u64..450) {
            let len = a.len();
            let bits = 128 + power as u64 + spare;
            let flat = FlatPolynomial::from_integers(a.iter(), 128);
            let [even, odd] = flat.halves(bits);
            let mut joined = FlatPolynomial::zero(len + 2 * power, bits);
            joined.add(&even, 0, 2);
            joined.add(&odd, 1, 2);
            prop_assert_eq!(joined.to_polynomial(), flat.to_polynomial());
            let mut cancelled = joined.clone();
            cancelled.subtract(&even, 0, 2);
            cancelled.subtract(&odd, 1, 2);
            prop_assert!(cancelled.is_zero());
            joined.multiply_by_rho(power);
            let rho = IntegerPolynomial::from_coefficients_asc([1, 0, 1].map(Integer::from).to_vec());
            let expected = (0..power).fold(flat.to_polynomial(), |product, _| product * &rho);
            prop_assert_eq!(joined.to_polynomial(), expected);
        }
    }
}
