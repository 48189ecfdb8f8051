//! The norms of spherical harmonics, and products with them that are rounded within a certified bound of the radius.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::FloorSqrt;
use malachite::base::num::logic::traits::SignificantBits;

use crate::error::Invariant;
use crate::exact::{Rational, pi};

/// The radius is off by at most 2^(−ROUNDING_BITS) of its mean.
const ROUNDING_BITS: i64 = 60;

/// What the harmonics of a file are normalised to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Normalization {
    /// `P_l^m(cos φ) cos mθ` as they are.
    Unnormalized,
    /// The mean square over the sphere is 1.
    FourPi,
    /// The integral of the square over the sphere is 1.
    Orthonormal,
    /// Schmidt's semi-normalisation: the mean square is 1/(2l + 1).
    Schmidt,
}

impl Normalization {
    /// The factor N with N·Y(l, m) the real harmonic with this normalisation, in doubles.
    pub(crate) fn factor(self, l: usize, order: usize) -> f64 {
        let norm = Norm {
            normalization: self,
            is_complex: false,
        };
        let (square, over_pi) = norm.square(l, order.cast_signed());
        let square = square.to_f64();
        match over_pi {
            true => (square / std::f64::consts::PI).sqrt(),
            false => square.sqrt(),
        }
    }
}

/// The norms of the harmonics of a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Norm {
    pub(super) normalization: Normalization,
    /// Whether the harmonics are complex: then there is no factor √2 for m ≠ 0.
    pub(super) is_complex: bool,
}

impl Norm {
    /// The square of N with N·Y(l, m) the harmonic of the file, and whether it is still to be divided by π.
    fn square(self, l: usize, m: isize) -> (Rational, bool) {
        let degree = Rational::from(2 * l as i64 + 1);
        let twice = if m == 0 || self.is_complex { 1 } else { 2 };
        let schmidt = Rational::from(twice) / factorial_ratio(l, m);
        match self.normalization {
            Normalization::Unnormalized => (Rational::one(), false),
            Normalization::FourPi => (schmidt * degree, false),
            Normalization::Orthonormal => (schmidt * degree / Rational::from(4), true),
            Normalization::Schmidt => (schmidt, false),
        }
    }
}

/// (l + |m|)!/(l − |m|)!
fn factorial_ratio(l: usize, m: isize) -> Rational {
    let order = m.unsigned_abs();
    let factors = (l - order + 1)..=(l + order);
    let product = factors.fold(Integer::from(1), |product, k| {
        product * Integer::from(k as u64)
    });
    Rational::whole(product)
}

/// The square of a bound of |Y(l, m)|: by the addition theorem the sum of the squares of the 4π-normalised harmonics of degree l is 2l + 1,
/// so that of Y(l, m) is at most (l + |m|)!/((2 − δ)(l − |m|)!) with δ = 1 for m = 0, else 0.
fn largest_square(l: usize, m: isize) -> Rational {
    let ratio = factorial_ratio(l, m);
    if m == 0 {
        ratio
    } else {
        ratio / Rational::from(2)
    }
}

/// Coefficients of the unnormalised harmonics.
pub(super) struct Rounded {
    pub(super) terms: Vec<((usize, isize), Rational)>,
    /// In every direction the radius differs by at most this from that of the exact products; 0 if nothing was rounded.
    pub(super) bound: Rational,
}

/// The products of the coefficients and the norms. An irrational product is rounded to a multiple of 2^(−k), with k such that the error,
/// at most 2^(−k), times the largest value of its harmonic is an equal share of 2^(−60) of the mean radius (of the largest coefficient,
/// if the mean is 0).
pub(super) fn rounded_product(terms: Vec<((usize, isize), Rational)>, norm: Norm) -> Rounded {
    let scale = scale(&terms, norm);
    let count = Rational::from(terms.len() as i64);
    let bound = scale * Rational::from_dyadic(Integer::from(1), -ROUNDING_BITS);
    let share = &bound / count;
    let mut is_rounded = false;
    let terms = terms.into_iter().map(|((l, m), c)| {
        let (square, over_pi) = norm.square(l, m);
        if c.is_zero() {
            return ((l, m), c);
        }
        if let (Some(root), false) = (square.sqrt(), over_pi) {
            return ((l, m), c * root);
        }
        is_rounded = true;
        // 4^k ≥ largest²/share²
        let quotient = largest_square(l, m) / (&share * &share);
        let bits = quotient.floor().numerator().significant_bits() + 1;
        let k = i64::try_from(bits.div_ceil(2)).invariant("bits are far below 2^63");
        ((l, m), product(&c, &square, over_pi, k))
    });
    let terms = terms.collect();
    Rounded {
        terms,
        bound: if is_rounded { bound } else { Rational::zero() },
    }
}

/// A lower bound of the size of the mean radius, or of the largest coefficient.
fn scale(terms: &[((usize, isize), Rational)], norm: Norm) -> Rational {
    let mean = terms.iter().find(|((l, _), c)| *l == 0 && !c.is_zero());
    let largest = terms.iter().max_by(|(_, a), (_, b)| a.abs().cmp(&b.abs()));
    let Some(((l, m), c)) = mean.or(largest).filter(|(_, c)| !c.is_zero()) else {
        return Rational::one();
    };
    let (square, over_pi) = norm.square(*l, *m);
    // Enough bits for two correct digits of the product.
    let inverse = (c * c * &square).recip().invariant("neither factor is 0");
    let bits = inverse.floor().numerator().significant_bits();
    let k = 8 + i64::try_from(bits).invariant("bits are far below 2^63");
    let found = product(c, &square, over_pi, k).abs();
    found - Rational::from_dyadic(Integer::from(1), -k)
}

/// c √square, or c √(square/π), with an error of at most 2^(−k).
///
/// With x = c² square (/π) the result is ⌊√(4^(k+2) x)⌋/2^(k+2). The bounds of π are so narrow that 4^(k+2) x is known up to 1, and its root up
/// to 1; the floor cuts off less than 1. So the error is less than 2·2^(−k−2).
fn product(c: &Rational, square: &Rational, over_pi: bool, k: i64) -> Rational {
    let k = k.max(0) + 2;
    let mut scaled = c * c * square * Rational::from_dyadic(Integer::from(1), 2 * k);
    if over_pi {
        let bits = scaled.floor().numerator().significant_bits() + 8;
        let bits = u32::try_from(bits).invariant("a number has fewer than 2^32 bits");
        scaled = scaled / pi(bits).1;
    }
    let whole = scaled.floor().numerator();
    let root = Integer::from(whole.unsigned_abs_ref().floor_sqrt());
    Rational::from_dyadic(root, -k) * Rational::from(i32::from(c.signum()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn products_are_as_near_as_claimed(p in -1000i64..1000, q in 1i64..1000, s in 1i64..1000, k in 0i64..90) {
            let (c, square) = (Rational::new(p, q).unwrap(), Rational::from(s));
            let found = product(&c, &square, false, k).abs();
            let unit = Rational::from_dyadic(Integer::from(1), -k);
            let x = &c * &c * &square;
            let low = if found > unit { &found - &unit } else { Rational::zero() };
            prop_assert!(&low * &low <= x && x <= (&found + &unit) * (&found + &unit));
        }

        /// The mean square of a normalised harmonic is 1, by exact values of Y on a zonal one.
        #[test]
        fn norms_of_zonal_harmonics(l in 0usize..20) {
            let norm = |normalization| Norm { normalization, is_complex: false };
            // ∫ P_l² dt/2 = 1/(2l + 1)
            let (square, _) = norm(Normalization::FourPi).square(l, 0);
            prop_assert_eq!(square, Rational::from(2 * l as i64 + 1));
            let (square, _) = norm(Normalization::Schmidt).square(l, 0);
            prop_assert_eq!(square, Rational::one());
        }
    }

    #[test]
    fn the_first_orthonormal_harmonic() {
        let norm = Norm {
            normalization: Normalization::Orthonormal,
            is_complex: false,
        };
        let Rounded { terms, bound } = rounded_product(vec![((0, 0), Rational::one())], norm);
        let expected = 1.0 / (4.0 * std::f64::consts::PI).sqrt();
        assert!((terms[0].1.to_f64() - expected).abs() < 1e-16);
        assert!(bound.to_f64() < 1e-18 && bound.signum() > 0);
    }
}
