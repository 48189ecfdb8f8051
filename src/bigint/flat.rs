//! Polynomials in one block of memory: all coefficients have the same number of limbs.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Square;
use malachite::integer_polynomial::IntegerPolynomial;

use super::limbs::{
    add, add_integer, decrement, increment, is_negative, subtract, to_integer, trailing_zeros,
    widen, width_for,
};
use malachite::base::polynomial::Polynomial;

/// A polynomial whose coefficients, ascending, are two's complement numbers of one width.
///
/// An addition takes about a nanosecond for each limb and does not use the heap. Except for borrows, the block is also the
/// value of the polynomial at 2^(64·width), so products of polynomials are products of two large integers (Kronecker's
/// substitution).
///
/// The user of the type chooses the width from a known bound. Sums that do not fit wrap around.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct FlatPolynomial {
    width: usize,
    limbs: Vec<u64>,
}

impl FlatPolynomial {
    /// The polynomial with `len` coefficients that are all 0, with room for integers below 2^`bits`.
    pub(crate) fn zero(len: usize, bits: u64) -> Self {
        let width = width_for(bits);
        Self {
            width,
            limbs: vec![0; len * width],
        }
    }

    /// The polynomial with these coefficients, with room for integers below 2^`bits`.
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

    /// The polynomial with these coefficients, of `width` limbs each, one after the other.
    pub(crate) fn from_limbs(limbs: Vec<u64>, width: usize) -> Self {
        Self { width, limbs }
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
    pub(crate) fn coefficients(&self) -> std::slice::ChunksExact<'_, u64> {
        self.limbs.chunks_exact(self.width)
    }

    /// The coefficients, ascending.
    pub(crate) fn coefficients_mut(&mut self) -> std::slice::ChunksExactMut<'_, u64> {
        self.limbs.chunks_exact_mut(self.width)
    }

    /// Adds `value` to the coefficient k, or subtracts it if `negated`.
    pub(crate) fn add_at(&mut self, k: usize, value: &Integer, negated: bool) {
        let target = &mut self.limbs[k * self.width..][..self.width];
        add_integer(target, value, negated);
    }

    /// The polynomial with `len` of the coefficients, from `start` on and `step` apart, with room for integers below 2^`bits`.
    pub(crate) fn part(&self, start: usize, step: usize, len: usize, bits: u64) -> Self {
        let mut part = Self::zero(len, bits);
        let from = self.coefficients().skip(start).step_by(step);
        for (target, c) in part.coefficients_mut().zip(from) {
            widen(target, c);
        }
        part
    }

    /// The polynomials with the coefficients of even and of odd powers, with room for integers below 2^`bits`.
    pub(crate) fn halves(&self, bits: u64) -> [Self; 2] {
        [0, 1].map(|start| self.part(start, 2, (self.len() + 1 - start) / 2, bits))
    }

    /// Adds `± x^at · other(x^step)`. `other` must not be narrower; coefficients beyond the length of `self` are left out.
    pub(crate) fn add(&mut self, other: &Self, place: Target) {
        let targets = self.coefficients_mut().skip(place.at).step_by(place.step);
        let pairs = targets.zip(other.coefficients());
        if place.negative {
            pairs.for_each(|(target, c)| subtract(target, c));
        } else {
            pairs.for_each(|(target, c)| add(target, c));
        }
    }

    /// Multiplies by `(1 + x²)^power`, by `power` passes of additions. The last 2·power coefficients must be 0.
    pub(crate) fn multiply_by_rho(&mut self, power: usize) {
        self.run(TimesRho { power });
    }

    /// Whether operations are compiled for the width that holds integers below 2^`bits`. They take 0.25 ns for each limb and
    /// addition, operations for other widths 0.6 ns.
    pub(crate) fn is_compiled_for(bits: u64) -> bool {
        width_for(bits) <= 12
    }

    /// Runs an operation on the coefficients in place. It is compiled for their width if that is small.
    pub(crate) fn run(&mut self, operation: impl OnNumbers) {
        match self.width {
            1 => operation.run(self.limbs.as_chunks_mut::<1>().0),
            2 => operation.run(self.limbs.as_chunks_mut::<2>().0),
            3 => operation.run(self.limbs.as_chunks_mut::<3>().0),
            4 => operation.run(self.limbs.as_chunks_mut::<4>().0),
            5 => operation.run(self.limbs.as_chunks_mut::<5>().0),
            6 => operation.run(self.limbs.as_chunks_mut::<6>().0),
            7 => operation.run(self.limbs.as_chunks_mut::<7>().0),
            8 => operation.run(self.limbs.as_chunks_mut::<8>().0),
            9 => operation.run(self.limbs.as_chunks_mut::<9>().0),
            10 => operation.run(self.limbs.as_chunks_mut::<10>().0),
            11 => operation.run(self.limbs.as_chunks_mut::<11>().0),
            12 => operation.run(self.limbs.as_chunks_mut::<12>().0),
            _ => operation.run(&mut self.coefficients_mut().collect::<Vec<_>>()),
        }
    }

    /// The number of low zero bits that all coefficients have; `None` for the zero polynomial.
    pub(crate) fn trailing_zeros(&self) -> Option<u64> {
        self.coefficients().filter_map(trailing_zeros).min()
    }

    /// The coefficients times 2^`shift`, which must be integers.
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

/// An operation on numbers that all have one width.
pub(crate) trait OnNumbers {
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

/// A place at which a polynomial f is added, as `± x^at · f(x^step)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    negative: bool,
    at: usize,
    step: usize,
}

impl Target {
    /// The place `+ x^at · f(x^step)`.
    pub(crate) fn of_sum(at: usize, step: usize) -> Self {
        let negative = false;
        Self { negative, at, step }
    }

    /// The place `− x^at · f(x^step)`.
    pub(crate) fn of_difference(at: usize, step: usize) -> Self {
        let negative = true;
        Self { negative, at, step }
    }

    /// The places of the products of halves, if f g is added at `places`. With `f = E + xO` and `g = G + xU`, where E, O, G, U
    /// are polynomials in x², `fg = EG + x²OU + x((E + O)(G + U) − EG − OU)`. The order is EG, OU, (E + O)(G + U).
    fn of_halves(places: &[Self]) -> [Vec<Self>; 3] {
        let [mut even, mut odd, mut sum] = [const { Vec::new() }; 3];
        for &Self { negative, at, step } in places {
            let place = |negative, steps| Self {
                negative,
                at: at + steps * step,
                step: 2 * step,
            };
            even.extend([place(negative, 0), place(!negative, 1)]);
            odd.extend([place(negative, 2), place(!negative, 1)]);
            sum.push(place(negative, 1));
        }
        [even, odd, sum]
    }
}

/// The largest integer that is multiplied at once, in limbs, because a product takes ten times the memory of its factors.
/// Larger ones are computed from three products of half the length, which takes one and a half times as long for each halving.
const LARGEST_PRODUCT: usize = 1 << 20;

/// Kronecker's substitution. Cost: quasi-linear in the size of the product.
///
/// Lemma 1. A polynomial with coefficients below 2^(64·width − 1) is determined by its value at 2^(64·width).
/// Proof. The lowest coefficient is congruent to the value modulo 2^(64·width), and only one number of this size is. The rest
/// is the value of the polynomial with the other coefficients.
///
/// Lemma 2. If every sum Σ |f_j| |g_(k−j)| is below 2^bits, the same sums for E, O and E + O of `f = E + xO`, `g = G + xU` are below
/// 2^(bits + 2), and so are the coefficients themselves.
/// Proof. A coefficient of (|E| + |O|)(|G| + |U|) is a sum of |f_i| |g_j| with i + j = 2k, 2k + 1 (twice) and 2k + 2, of which those with the
/// indices of one coefficient of fg are below 2^bits: less than 4 · 2^bits.
/// Law for both: `products_are_those_of_integer_polynomials`, with equal coefficients of the largest size, too.
impl FlatPolynomial {
    /// Adds `f · g` at all these places. Every sum `Σ |f_j| |g_(k−j)|` must be below 2^`bits`.
    pub(crate) fn add_product(&mut self, f: &Self, g: &Self, bits: u64, places: &[Target]) {
        self.add_products(f, Some(g), bits, places, LARGEST_PRODUCT);
    }

    /// Adds `f²` at all these places. Every sum `Σ |f_j| |f_(k−j)|` must be below 2^`bits`.
    pub(crate) fn add_square(&mut self, f: &Self, bits: u64, places: &[Target]) {
        self.add_products(f, None, bits, places, LARGEST_PRODUCT);
    }

    /// Adds f g, or the square of f if there is no g. Integers of more than `largest` limbs are not multiplied.
    fn add_products(
        &mut self,
        f: &Self,
        g: Option<&Self>,
        bits: u64,
        places: &[Target],
        largest: usize,
    ) {
        let width = width_for(bits).max(self.width);
        let longer = f.len().max(g.map_or(0, Self::len));
        if longer * width <= largest || longer == 1 {
            let value = match g {
                Some(g) => f.packed(width) * g.packed(width),
                None => f.packed(width).square(),
            };
            let len = f.len() + g.unwrap_or(f).len() - 1;
            let product = Self::unpacked(value, len, width);
            places.iter().for_each(|&place| self.add(&product, place));
            return;
        }
        // The room is that of Lemma 2.
        let room = bits + 2;
        let (f, g) = (f.halves_and_sum(room), g.map(|g| g.halves_and_sum(room)));
        for (k, places) in Target::of_halves(places).iter().enumerate() {
            self.add_products(&f[k], g.as_ref().map(|g| &g[k]), room, places, largest);
        }
    }

    /// The polynomials E, O and E + O in x², where `f = E + xO`.
    fn halves_and_sum(&self, bits: u64) -> [Self; 3] {
        let [even, odd] = self.halves(bits);
        let mut sum = even.clone();
        sum.add(&odd, Target::of_sum(0, 1));
        [even, odd, sum]
    }

    /// The value at 2^(64·width).
    pub(crate) fn packed(&self, width: usize) -> Integer {
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

    /// The polynomial with `len` coefficients whose value at 2^(64·width) is given.
    pub(crate) fn unpacked(value: Integer, len: usize, width: usize) -> Self {
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
    use malachite::base::polynomial::{ComposePowerOfX, MulPowerOfX};
    use proptest::prelude::*;

    fn coefficients() -> impl Strategy<Value = Vec<Integer>> {
        let small = prop_oneof![
            Just(0),
            Just(-1),
            Just(i128::MIN),
            Just(i128::MAX),
            any::<i128>()
        ];
        let small = small.prop_map(Integer::from);
        prop_oneof![
            prop::collection::vec(small.clone(), 1..40),
            // Equal coefficients give the largest sums.
            (small, 1usize..40).prop_map(|(c, len)| vec![c; len]),
        ]
    }

    /// Sums just below a power of two at the end of a limb; those of the halves are twice as large.
    #[test]
    fn sums_of_halves_have_the_room_that_they_need() {
        for limbs in 1..6_u64 {
            let c = (Integer::from(1) << (32 * limbs - 1)) - Integer::from(1);
            for c in [c.clone(), -c] {
                let f = IntegerPolynomial::from_coefficients_asc(vec![c.clone(), c]);
                let bits = 64 * limbs - 1;
                let flat = FlatPolynomial::from_integers(f.coefficients_asc().iter(), bits);
                let mut square = FlatPolynomial::zero(3, bits);
                square.add_products(&flat, None, bits, &[Target::of_sum(0, 1)], 1);
                assert_eq!(square.to_polynomial(), f.square());
            }
        }
    }

    proptest! {
        #[test]
        fn products_are_those_of_integer_polynomials(a in coefficients(), b in coefficients(), spare in 0u64..130) {
            let flat = |c: &[Integer]| FlatPolynomial::from_integers(c.iter(), 128);
            let long = |c: &[Integer]| IntegerPolynomial::from_coefficients_asc(c.to_vec());
            let bits = 254 + 6 + spare;
            prop_assert_eq!(flat(&a).to_polynomial(), long(&a));
            let expected = [long(&a) * long(&b), long(&a).square()];
            // In one piece, and in as many pieces as possible.
            for largest in [usize::MAX, 1, 12, 60] {
                for (other, expected) in [Some(flat(&b)), None].iter().zip(&expected) {
                    let len = a.len() + other.as_ref().map_or(a.len(), FlatPolynomial::len) - 1;
                    let mut sum = FlatPolynomial::zero(3 * len + 1, bits + 2);
                    let places = [Target::of_sum(1, 3), Target::of_difference(0, 1), Target::of_sum(0, 1)];
                    sum.add_products(&flat(&a), other.as_ref(), bits, &places, largest);
                    let spread = expected.clone().compose_power_of_x(3).mul_power_of_x(1);
                    prop_assert_eq!(sum.to_polynomial(), spread);
                }
            }
        }

        #[test]
        fn halves_are_put_together_and_rho_is_multiplied(a in coefficients(), power in 0usize..20, spare in 0u64..450) {
            let len = a.len();
            let bits = 128 + power as u64 + spare;
            let flat = FlatPolynomial::from_integers(a.iter(), 128);
            let [even, odd] = flat.halves(bits);
            let mut joined = FlatPolynomial::zero(len + 2 * power, bits);
            joined.add(&even, Target::of_sum(0, 2));
            joined.add(&odd, Target::of_sum(1, 2));
            prop_assert_eq!(joined.to_polynomial(), flat.to_polynomial());
            let mut cancelled = joined.clone();
            cancelled.add(&even, Target::of_difference(0, 2));
            cancelled.add(&odd, Target::of_difference(1, 2));
            prop_assert!(cancelled.is_zero());
            joined.multiply_by_rho(power);
            let rho = IntegerPolynomial::from_coefficients_asc([1, 0, 1].map(Integer::from).to_vec());
            let expected = (0..power).fold(flat.to_polynomial(), |product, _| product * &rho);
            prop_assert_eq!(joined.to_polynomial(), expected);
        }
    }
}
