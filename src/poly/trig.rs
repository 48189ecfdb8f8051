//! Trigonometric polynomials: finite Fourier series with exact coefficients.

use std::collections::BTreeMap;

use malachite::base::num::arithmetic::traits::Lcm;
use malachite::base::num::basic::traits::One;
use malachite::{Integer, Natural};

use super::Ring;
use crate::error::Invariant;
use crate::exact::Rational;

/// `Σ_n (a_n cos nθ + b_n sin nθ)` with exact rational coefficients, as a map from n to
/// `[a_n, b_n]`.
///
/// Formulas for a Fourier radius are evaluated in this ring: products of cosines and sines are sums of cosines and sines.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub(crate) struct TrigPolynomial {
    /// The non-zero pairs; `b_0` is 0.
    harmonics: BTreeMap<u32, [Rational; 2]>,
}

impl TrigPolynomial {
    /// The polynomial 0.
    #[must_use]
    pub(crate) fn zero() -> Self {
        Self::default()
    }

    /// The constant polynomial with this value.
    #[must_use]
    pub(crate) fn constant(value: Rational) -> Self {
        let mut result = Self::zero();
        result.add_harmonic(0, [value, Rational::zero()]);
        result
    }

    /// The polynomial `cos nθ`; n may be negative.
    #[must_use]
    pub(crate) fn cosine(n: i32) -> Self {
        let mut result = Self::zero();
        result.add_harmonic(n.unsigned_abs(), [Rational::one(), Rational::zero()]);
        result
    }

    /// The polynomial `sin nθ`; n may be negative.
    #[must_use]
    pub(crate) fn sine(n: i32) -> Self {
        let mut result = Self::zero();
        let sign = Rational::from(n.signum());
        result.add_harmonic(n.unsigned_abs(), [Rational::zero(), sign]);
        result
    }

    /// Adds `a cos nθ + b sin nθ` in place.
    fn add_harmonic(&mut self, n: u32, [a, b]: [Rational; 2]) {
        let pair = self.harmonics.entry(n).or_default();
        pair[0] = &pair[0] + a;
        if n > 0 {
            pair[1] = &pair[1] + b;
        }
        if pair[0].is_zero() && pair[1].is_zero() {
            self.harmonics.remove(&n);
        }
    }

    /// Adds `factor · other` in place. Cost: linear in the length of `other`.
    pub(crate) fn add_multiple(&mut self, other: &Self, factor: &Rational) {
        for (&n, [a, b]) in &other.harmonics {
            self.add_harmonic(n, [a * factor, b * factor]);
        }
    }

    /// The product `factor · self`.
    #[must_use]
    pub(crate) fn scaled(&self, factor: &Rational) -> Self {
        let mut result = Self::zero();
        result.add_multiple(self, factor);
        result
    }

    /// The non-zero harmonics `(n, [a_n, b_n])`, ascending in n.
    pub(crate) fn harmonics(&self) -> impl Iterator<Item = (u32, &[Rational; 2])> {
        self.harmonics.iter().map(|(&n, pair)| (n, pair))
    }

    /// The number of non-zero harmonics.
    #[must_use]
    pub(crate) fn len(&self) -> usize {
        self.harmonics.len()
    }

    /// The largest n with `a_n ≠ 0` or `b_n ≠ 0`; `None` for 0.
    #[must_use]
    pub(crate) fn degree(&self) -> Option<u32> {
        self.harmonics.keys().next_back().copied()
    }

    /// The value, if the polynomial is a constant.
    #[must_use]
    pub(crate) fn as_constant(&self) -> Option<Rational> {
        match self.degree() {
            None => Some(Rational::zero()),
            Some(0) => self.harmonics.get(&0).map(|pair| pair[0].clone()),
            Some(_) => None,
        }
    }

    /// The dense coefficients `([a_0, …, a_N], [0, b_1, …, b_N])`.
    #[must_use]
    pub(crate) fn coefficients(&self) -> (Vec<Rational>, Vec<Rational>) {
        let len = self.degree().unwrap_or(0) as usize + 1;
        let (mut cos, mut sin) = (vec![Rational::zero(); len], vec![Rational::zero(); len]);
        for (&n, [a, b]) in &self.harmonics {
            cos[n as usize] = a.clone();
            sin[n as usize] = b.clone();
        }
        (cos, sin)
    }

    /// The value at the angle whose cosine and sine are `cos` and `sin`.
    ///
    /// Cost: N steps of the rotation `(cos nθ, sin nθ)`, whose bits grow linearly with n.
    #[cfg(test)]
    pub(crate) fn evaluate(&self, cos: &Rational, sin: &Rational) -> Rational {
        let (mut c, mut s) = (Rational::one(), Rational::zero());
        let mut value = Rational::zero();
        for n in 0..=self.degree().unwrap_or(0) {
            if let Some([a, b]) = self.harmonics.get(&n) {
                value = value + a * &c + b * &s;
            }
            (c, s) = (&c * cos - &s * sin, &s * cos + &c * sin);
        }
        value
    }

    /// The least common denominator of all coefficients.
    pub(crate) fn common_denominator(&self) -> Integer {
        let all = self.harmonics.values().flatten();
        Integer::from(all.fold(Natural::ONE, |d, c| d.lcm(c.denominator_ref())))
    }

    /// The least common denominator, and the coefficients times it.
    fn over_common_denominator(&self) -> (Integer, Vec<(u32, [Integer; 2])>) {
        let denominator = self.common_denominator();
        let whole = Rational::whole(&denominator);
        let scaled = |c: &Rational| (c * &whole).numerator();
        let all = self.harmonics.iter();
        let all = all.map(|(&n, pair)| (n, pair.each_ref().map(scaled)));
        (denominator, all.collect())
    }

    /// Checks the invariants of the type; every property test calls it.
    #[cfg(test)]
    pub(crate) fn check_invariants(&self) -> bool {
        self.harmonics
            .iter()
            .all(|(&n, [a, b])| !(a.is_zero() && b.is_zero()) && (n > 0 || b.is_zero()))
    }
}

impl Ring for TrigPolynomial {
    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add_multiple(other, &Rational::one());
        sum
    }

    fn minus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add_multiple(other, &Rational::from(-1));
        sum
    }

    /// The product-to-sum formulas: with `z_n = a_n − i b_n`, the harmonic n of f is `Re z_n e^{inθ}`, and `Re z e^{inθ} · Re w
    /// e^{imθ} = ½ Re (z w e^{i(n+m)θ} + z w̄ e^{i(n−m)θ})`.
    /// # Panics
    /// If a harmonic of the product is 2^32 or more.
    ///
    /// Cost: N M products of integers for N and M harmonics, and N + M greatest common divisors.
    fn times(&self, other: &Self) -> Self {
        let [(p, f), (q, g)] = [self, other].map(Self::over_common_denominator);
        let mut sums: BTreeMap<u32, [Integer; 2]> = BTreeMap::new();
        let mut add = |n: u32, [cos, sin]: [Integer; 2]| {
            let sum = sums.entry(n).or_default();
            sum[0] += cos;
            sum[1] += sin;
        };
        for (n, [a, b]) in &f {
            for (m, [c, d]) in &g {
                let (ac, bd, ad, bc) = (a * c, b * d, a * d, b * c);
                let sum = n.checked_add(*m).invariant("harmonics are below 2^32");
                add(sum, [&ac - &bd, &ad + &bc]);
                let difference = if n >= m { bc - ad } else { ad - bc };
                add(n.abs_diff(*m), [ac + bd, difference]);
            }
        }
        let denominator = p * q * Integer::from(2);
        let quotient = |sum: Integer| {
            let exact = Rational::from_integers(sum, denominator.clone());
            exact.invariant("a product of denominators is not 0")
        };
        let mut product = Self::zero();
        for (n, sums) in sums {
            product.add_harmonic(n, sums.map(quotient));
        }
        product
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn known_products() {
        let (c, s) = (TrigPolynomial::cosine(1), TrigPolynomial::sine(1));
        // cos² + sin² = 1, and 2 sin cos = sin 2θ.
        let one = c.squared().plus(&s.squared());
        assert_eq!(one.as_constant(), Some(Rational::one()));
        assert_eq!(c.times(&s).scaled(&2.into()), TrigPolynomial::sine(2));
    }

    fn trig() -> impl Strategy<Value = TrigPolynomial> {
        prop::collection::vec((-6i32..7, any::<bool>(), -9i32..10, 1i32..5), 0..6).prop_map(|v| {
            let mut f = TrigPolynomial::zero();
            for (n, is_cos, p, q) in v {
                let one = if is_cos {
                    TrigPolynomial::cosine(n)
                } else {
                    TrigPolynomial::sine(n)
                };
                f.add_multiple(&one, &(Rational::from(p) / Rational::from(q)));
            }
            f
        })
    }

    proptest! {
        #[test]
        fn the_laws_of_a_ring(f in trig(), g in trig(), h in trig()) {
            prop_assert!(f.times(&g).check_invariants() && f.plus(&g).check_invariants());
            prop_assert_eq!(f.times(&g), g.times(&f));
            prop_assert_eq!(f.times(&g).times(&h), f.times(&g.times(&h)));
            prop_assert_eq!(f.times(&g.plus(&h)), f.times(&g).plus(&f.times(&h)));
            prop_assert_eq!(f.plus(&g).minus(&g), f.clone());
            prop_assert_eq!(f.times(&TrigPolynomial::cosine(0)), f);
        }

        #[test]
        fn a_product_is_the_product_at_rational_points_of_the_circle(
            f in trig(), g in trig(), p in -9i32..10, q in 1i32..10
        ) {
            let s = Rational::from(p) / Rational::from(q);
            let ss = &s * &s;
            let below = Rational::one() + &ss;
            let (cos, sin) = ((Rational::one() - ss) / &below, (&s + &s) / &below);
            let at = |f: &TrigPolynomial| f.evaluate(&cos, &sin);
            prop_assert_eq!(at(&f.times(&g)), at(&f) * at(&g));
            prop_assert_eq!(at(&f.plus(&g)), at(&f) + at(&g));
        }
    }

    #[test]
    #[should_panic(expected = "harmonics are below 2^32")]
    fn a_product_with_a_higher_harmonic_stops() {
        let half = TrigPolynomial::cosine(i32::MIN);
        assert_eq!(half.degree(), Some(1 << 31));
        let _ = half.times(&half);
    }

    #[test]
    fn negative_indices_are_folded() {
        assert_eq!(TrigPolynomial::cosine(-3), TrigPolynomial::cosine(3));
        let minus = TrigPolynomial::sine(3).scaled(&Rational::from(-1));
        assert_eq!(TrigPolynomial::sine(-3), minus);
        assert!(TrigPolynomial::sine(0).len() == 0);
    }
}
