//! Reproducible numbers for tests and benches.

use malachite::Integer;
use stellate::exact::{Rational, integer_to_num};
use stellate::poly::PlanePolynomial;

/// SplitMix64 (Steele, Lea & Flood).
pub(crate) struct SplitMix(pub(crate) u64);

impl SplitMix {
    pub(crate) fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Of at most so many bits, either sign.
    pub(crate) fn integer(&mut self, bits: u64) -> Integer {
        let words = (0..bits.div_ceil(64)).map(|_| self.word());
        let value = words.fold(Integer::from(0), |v, w| (v << 64u64) + Integer::from(w));
        let value = value >> ((64 - bits % 64) % 64);
        if self.word() & 1 == 0 { value } else { -value }
    }

    /// Between −size and size, a double with all its bits.
    pub(crate) fn double(&mut self, size: f64) -> f64 {
        let bits = (self.word() >> 12) | 1.0f64.to_bits();
        (f64::from_bits(bits) - 1.5) * 2.0 * size
    }

    /// All terms up to the given total degree, so irreducible.
    pub(crate) fn dense(&mut self, degree: usize, bits: u64) -> PlanePolynomial {
        let exponents = (0..=degree).flat_map(|i| (0..=degree - i).map(move |j| (i, j)));
        PlanePolynomial::from_terms(
            exponents.map(|e| (e, Rational::from(integer_to_num(&self.integer(bits))))),
        )
    }
}
