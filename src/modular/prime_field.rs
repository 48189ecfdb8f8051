//! Polynomials over a prime field with fewer than 2³¹ elements.

use malachite::Integer;
use malachite::integer_polynomial::IntegerPolynomial;

use super::residue::{inverse_mod, reduce_integer};
use crate::error::Invariant;

/// The integers modulo a prime p < 2³¹, and polynomials over them as ascending trimmed vectors.
///
/// Products of residues fit 62 bits, so sums of products are kept below p² by a conditional
/// subtraction and divided once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PrimeField {
    p: u64,
    square: u64,
}

impl PrimeField {
    /// For a prime below 2³¹.
    pub(crate) fn new(p: u64) -> Self {
        Self { p, square: p * p }
    }

    /// p.
    pub(crate) fn prime(&self) -> u64 {
        self.p
    }

    pub(crate) fn mul(&self, a: u64, b: u64) -> u64 {
        a * b % self.p
    }

    /// 1/a for a ≠ 0.
    pub(crate) fn inverse(&self, a: u64) -> u64 {
        inverse_mod(a, self.p)
    }

    pub(crate) fn reduce_integer(&self, value: &Integer) -> u64 {
        reduce_integer(value, self.p)
    }

    pub(crate) fn reduce(&self, f: &IntegerPolynomial) -> Vec<u64> {
        let coefficients = f.coefficients_asc().iter();
        trimmed(coefficients.map(|c| self.reduce_integer(c)).collect())
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

    pub(crate) fn derivative(&self, f: &[u64]) -> Vec<u64> {
        let mut k = 0;
        let terms = f.iter().skip(1).map(|&c| {
            k = if k + 1 == self.p { 0 } else { k + 1 };
            self.mul(c, k)
        });
        trimmed(terms.collect())
    }

    pub(crate) fn difference(&self, f: &[u64], g: &[u64]) -> Vec<u64> {
        let length = f.len().max(g.len());
        let at = |f: &[u64], k: usize| f.get(k).copied().unwrap_or(0);
        trimmed(
            (0..length)
                .map(|k| (at(f, k) + self.p - at(g, k)) % self.p)
                .collect(),
        )
    }

    /// f · g, classical.
    pub(crate) fn product(&self, f: &[u64], g: &[u64]) -> Vec<u64> {
        if f.is_empty() || g.is_empty() {
            return Vec::new();
        }
        let mut product = vec![0u64; f.len() + g.len() - 1];
        for (i, &a) in f.iter().enumerate().filter(|(_, a)| **a != 0) {
            for (slot, &b) in product[i..].iter_mut().zip(g) {
                *slot += a * b;
                if *slot >= self.square {
                    *slot -= self.square;
                }
            }
        }
        for c in &mut product {
            *c %= self.p;
        }
        trimmed(product)
    }

    /// f modulo g ≠ 0 in place, trimmed; the quotient is returned.
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
                % self.p;
            if top == 0 {
                continue;
            }
            let q = self.mul(top, inverse);
            quotient[k] = q;
            let minus = self.p - q;
            for (slot, &c) in f[k..].iter_mut().zip(low) {
                *slot += minus * c;
                if *slot >= self.square {
                    *slot -= self.square;
                }
            }
        }
        for c in f.iter_mut() {
            *c %= self.p;
        }
        while f.last() == Some(&0) {
            f.pop();
        }
        trimmed(quotient)
    }

    /// The quotient of f by a divisor.
    pub(crate) fn quotient(&self, mut f: Vec<u64>, g: &[u64]) -> Vec<u64> {
        self.divide(&mut f, g)
    }

    /// The monic gcd, by Euclid; empty if both are 0.
    pub(crate) fn gcd(&self, mut f: Vec<u64>, mut g: Vec<u64>) -> Vec<u64> {
        while !g.is_empty() {
            self.divide(&mut f, &g);
            std::mem::swap(&mut f, &mut g);
        }
        self.monic(f)
    }

    /// Whether f has no repeated factor (and its derivative is not 0).
    pub(crate) fn is_squarefree(&self, f: &[u64]) -> bool {
        f.len() <= 1 || self.gcd(f.to_vec(), self.derivative(f)).len() == 1
    }

    /// The inverse of f modulo `modulus`, if the two are coprime: the extended Euclidean algorithm.
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

    /// f^exponent modulo `modulus`, for exponent ≥ 1 and f already reduced.
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
}

fn trimmed(mut f: Vec<u64>) -> Vec<u64> {
    while f.last() == Some(&0) {
        f.pop();
    }
    f
}
