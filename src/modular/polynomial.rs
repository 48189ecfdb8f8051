//! Polynomials over a prime field. They are ascending lists of residues; the last one is not 0 (the list is trimmed) unless a
//! function says otherwise.

use malachite::integer_polynomial::IntegerPolynomial;

use super::PrimeField;
use crate::error::Invariant;

impl PrimeField {
    /// The residues of all coefficients, including last ones that are 0.
    pub(crate) fn residues(&self, f: &IntegerPolynomial) -> Vec<u64> {
        let coefficients = f.coefficients_asc().iter();
        coefficients.map(|c| self.reduce_integer(c)).collect()
    }

    /// The polynomial modulo the prime, trimmed.
    pub(crate) fn reduce(&self, f: &IntegerPolynomial) -> Vec<u64> {
        trimmed(self.residues(f))
    }

    /// The value at t, by Horner's rule.
    pub(crate) fn value(&self, f: &[u64], t: u64) -> u64 {
        f.iter().rev().fold(0, |v, c| (v * t + c) % self.prime())
    }

    /// The multiple with leading coefficient 1.
    pub(crate) fn monic(&self, mut f: Vec<u64>) -> Vec<u64> {
        if let Some(&lead) = f.last()
            && lead != 1
        {
            let inverse = self.inverse(lead);
            for c in &mut f {
                *c = self.mul(*c, inverse);
            }
        }
        f
    }

    /// f(x + a) for a list of coefficients of any length, by Horner's rule.
    pub(crate) fn shifted(&self, mut f: Vec<u64>, a: u64) -> Vec<u64> {
        if a != 0 {
            for start in (0..f.len()).rev() {
                for k in start..f.len().saturating_sub(1) {
                    f[k] = self.sum(f[k], self.mul(a, f[k + 1]));
                }
            }
        }
        f
    }

    pub(crate) fn derivative(&self, f: &[u64]) -> Vec<u64> {
        let mut k = 0;
        let terms = f.iter().skip(1).map(|&c| {
            k = if k + 1 == self.prime() { 0 } else { k + 1 };
            self.mul(c, k)
        });
        trimmed(terms.collect())
    }

    pub(crate) fn difference(&self, f: &[u64], g: &[u64]) -> Vec<u64> {
        let length = f.len().max(g.len());
        let at = |f: &[u64], k: usize| f.get(k).copied().unwrap_or(0);
        trimmed(
            (0..length)
                .map(|k| (at(f, k) + self.prime() - at(g, k)) % self.prime())
                .collect(),
        )
    }

    /// The product f · g, by the classical algorithm.
    pub(crate) fn product(&self, f: &[u64], g: &[u64]) -> Vec<u64> {
        if f.is_empty() || g.is_empty() {
            return Vec::new();
        }
        let mut product = vec![0u64; f.len() + g.len() - 1];
        for (i, &a) in f.iter().enumerate().filter(|(_, a)| **a != 0) {
            for (slot, &b) in product[i..].iter_mut().zip(g) {
                *slot += a * b;
                if *slot >= self.square() {
                    *slot -= self.square();
                }
            }
        }
        for c in &mut product {
            *c %= self.prime();
        }
        trimmed(product)
    }

    /// Replaces f by its remainder modulo g ≠ 0, trimmed, and returns the quotient.
    pub(crate) fn divide(&self, f: &mut Vec<u64>, g: &[u64]) -> Vec<u64> {
        let Some((&lead, low)) = g.split_last() else {
            return Vec::new();
        };
        let length = (f.len() + 1).saturating_sub(g.len());
        let inverse = if lead == 1 { 1 } else { self.inverse(lead) };
        let mut quotient = vec![0; length];
        for k in (0..length).rev() {
            let top = f
                .pop()
                .invariant("the dividend is no shorter than the divisor")
                % self.prime();
            if top == 0 {
                continue;
            }
            let q = self.mul(top, inverse);
            quotient[k] = q;
            let minus = self.prime() - q;
            for (slot, &c) in f[k..].iter_mut().zip(low) {
                *slot += minus * c;
                if *slot >= self.square() {
                    *slot -= self.square();
                }
            }
        }
        for c in f.iter_mut() {
            *c %= self.prime();
        }
        while f.last() == Some(&0) {
            f.pop();
        }
        trimmed(quotient)
    }

    /// The quotient of f by a polynomial that divides it.
    pub(crate) fn quotient(&self, mut f: Vec<u64>, g: &[u64]) -> Vec<u64> {
        self.divide(&mut f, g)
    }

    /// The monic gcd, by Euclid's algorithm; empty if both polynomials are 0.
    pub(crate) fn gcd(&self, mut f: Vec<u64>, mut g: Vec<u64>) -> Vec<u64> {
        while !g.is_empty() {
            self.divide(&mut f, &g);
            std::mem::swap(&mut f, &mut g);
        }
        self.monic(f)
    }

    /// Whether f has no repeated factor and its derivative is not 0.
    pub(crate) fn is_squarefree(&self, f: &[u64]) -> bool {
        f.len() <= 1 || self.gcd(f.to_vec(), self.derivative(f)).len() == 1
    }

    /// The inverse of f modulo `modulus`, by the extended Euclidean algorithm; `None` if the two are not coprime.
    pub(crate) fn inverse_modulo(&self, f: &[u64], modulus: &[u64]) -> Option<Vec<u64>> {
        let (mut a, mut b) = (modulus.to_vec(), f.to_vec());
        self.divide(&mut b, modulus);
        let (mut u, mut v) = (Vec::new(), vec![1]);
        while b.len() > 1 {
            let q = self.divide(&mut a, &b);
            u = self.difference(&u, &self.product(&q, &v));
            std::mem::swap(&mut a, &mut b);
            std::mem::swap(&mut u, &mut v);
        }
        let scale = [self.inverse(*b.first()?)];
        let mut result = self.product(&v, &scale);
        self.divide(&mut result, modulus);
        Some(result)
    }

    /// The power f^exponent modulo `modulus`, for exponent ≥ 1; f must be reduced already.
    pub(crate) fn power_modulo(&self, f: &[u64], exponent: u64, modulus: &[u64]) -> Vec<u64> {
        let mut result = f.to_vec();
        for bit in (0..exponent.max(1).ilog2()).rev() {
            result = self.product(&result, &result);
            self.divide(&mut result, modulus);
            if exponent >> bit & 1 == 1 {
                result = self.product(&result, f);
                self.divide(&mut result, modulus);
            }
        }
        result
    }

    /// The resultant of two polynomials, by Euclid's algorithm. Their formal degrees are their lengths minus one.
    pub(crate) fn resultant(&self, mut f: Vec<u64>, mut g: Vec<u64>) -> u64 {
        let p = self.prime();
        let odd = |f: &[u64], g: &[u64]| (f.len() - 1) * (g.len() - 1) % 2 == 1;
        let mut value = 1;
        if g.last() == Some(&0) {
            if f.last() == Some(&0) {
                return 0;
            }
            if odd(&f, &g) {
                value = p - 1;
            }
            std::mem::swap(&mut f, &mut g);
        }
        // From here on the leading coefficient of g is not 0.
        while g.len() > 1 {
            if odd(&f, &g) {
                value = (p - value) % p;
            }
            let formal = f.len() - 1;
            let lead = g[g.len() - 1];
            self.divide(&mut f, &g);
            let Some(degree) = f.len().checked_sub(1) else {
                return 0;
            };
            value = self.mul(value, self.power(lead, (formal - degree) as u64));
            std::mem::swap(&mut f, &mut g);
        }
        self.mul(value, self.power(g[0], f.len() as u64 - 1))
    }

    /// The coefficients of the polynomial with the given values at 0, 1, 2, …, as many as there are values (Newton's
    /// interpolation).
    pub(crate) fn interpolate(&self, mut values: Vec<u64>) -> Vec<u64> {
        let (n, p) = (values.len(), self.prime());
        let inverses = self.inverses(n);
        for (gap, inverse) in inverses.iter().enumerate().skip(1) {
            for i in (gap..n).rev() {
                values[i] = (values[i] + p - values[i - 1]) * inverse % p;
            }
        }
        // Horner's rule in (t − k), from the last difference to the first.
        let mut coefficients = vec![0; n];
        for k in (0..n).rev() {
            let minus = p - k as u64 % p;
            for i in (1..n - k).rev() {
                coefficients[i] = (coefficients[i - 1] + minus * coefficients[i]) % p;
            }
            coefficients[0] = (minus * coefficients[0] + values[k]) % p;
        }
        coefficients
    }
}

/// The list without zeros at the end.
pub(crate) fn trimmed(mut f: Vec<u64>) -> Vec<u64> {
    while f.last() == Some(&0) {
        f.pop();
    }
    f
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const P: u64 = 2_147_483_647;

    /// The polynomial c ∏ (s − r).
    fn with_roots(c: u64, roots: &[u64]) -> Vec<u64> {
        let mut f = vec![c];
        for r in roots {
            f.insert(0, 0);
            for i in 1..f.len() {
                f[i - 1] = (f[i - 1] + (P - r) * f[i]) % P;
            }
        }
        f
    }

    proptest! {
        #[test]
        fn interpolation_takes_values_back_to_coefficients(f in prop::collection::vec(0..P, 0..12)) {
            let field = PrimeField::new(P);
            let values = (0..f.len() as u64).map(|t| field.value(&f, t));
            prop_assert_eq!(field.interpolate(values.collect()), f);
        }

        #[test]
        fn a_resultant_is_the_product_of_differences(
            a in 1u64..100, b in 1u64..100,
            r in prop::collection::vec(0u64..1000, 0..6),
            q in prop::collection::vec(0u64..1000, 0..6),
            drop in 0usize..3,
        ) {
            let field = PrimeField::new(P);
            // The resultant is a^n b^m ∏ (r − q).
            let mut expected = field.mul(field.power(a, q.len() as u64), field.power(b, r.len() as u64));
            for r in &r {
                for q in &q {
                    expected = expected * ((P + r - q) % P) % P;
                }
            }
            let (f, g) = (with_roots(a, &r), with_roots(b, &q));
            prop_assert_eq!(field.resultant(f.clone(), g.clone()), expected);
            // A leading zero of g is a root at infinity, which contributes the factor lc(f) up to sign.
            let mut formal = g.clone();
            formal.extend(vec![0; drop]);
            let found = field.resultant(f.clone(), formal.clone());
            let factor = field.power(a, drop as u64);
            prop_assert_eq!(found, expected * factor % P);
            // Res(g, f) = (−1)^(mn) Res(f, g).
            let swapped = field.resultant(formal.clone(), f.clone());
            let odd = (f.len() - 1) * (formal.len() - 1) % 2 == 1;
            prop_assert_eq!(swapped, if odd { (P - found) % P } else { found });
        }
    }
}
