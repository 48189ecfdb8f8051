//! Harmonics of one angle are written as powers of its cosine and sine: `sin(t)^5` is shorter than its harmonics.

use malachite::base::num::arithmetic::traits::Gcd;

use crate::exact::Rational;
use crate::poly::{Ring, SparsePolynomial};
use crate::shape::{Basis, Expansion};

/// The largest harmonic that is written as powers; beyond it harmonics are shorter.
const LARGEST_HARMONIC: usize = 16;

/// The common divisors of all harmonics of a sum. Powers of the cosine and sine of such a multiple of the angle can be used.
pub(super) fn units(f: &Expansion) -> Vec<usize> {
    let harmonics = f.keys().flatten().map(|basis| match basis {
        Basis::Cos(n) | Basis::Sin(n) => *n,
        Basis::Power(_) => 0,
    });
    let common = harmonics.fold(0, |gcd: usize, n| gcd.gcd(n));
    let divides = |d: &usize| common.is_multiple_of(*d);
    (1..=common.min(LARGEST_HARMONIC)).filter(divides).collect()
}

/// A sum of harmonics of multiples of `unit`, written in two ways: with at most the first power of cos, and with at most the
/// first power of sin. The terms have the exponents of cos and sin. `None` if there are other functions or high harmonics.
pub(super) fn in_powers(f: &Expansion, unit: usize) -> Option<[SparsePolynomial<2>; 2]> {
    let mut sum = SparsePolynomial::zero();
    for (basis, c) in f {
        let harmonic = match basis {
            [Basis::Power(0), Basis::Power(0)] => SparsePolynomial::constant(Rational::one()),
            [Basis::Cos(n), Basis::Power(0)] if *n / unit <= LARGEST_HARMONIC => {
                power_of_unit(*n / unit)[0].clone()
            }
            [Basis::Sin(n), Basis::Power(0)] if *n / unit <= LARGEST_HARMONIC => {
                power_of_unit(*n / unit)[1].clone()
            }
            _ => return None,
        };
        sum.add_multiple(&harmonic, c);
    }
    Some([0, 1].map(|kept| reduced(&sum, kept)))
}

/// The polynomials for cos nt and sin nt, which are the real and the imaginary part of (cos t + i sin t)^n.
fn power_of_unit(n: usize) -> [SparsePolynomial<2>; 2] {
    let [c, s] = [0, 1].map(SparsePolynomial::<2>::variable);
    let mut power = [
        SparsePolynomial::constant(Rational::one()),
        SparsePolynomial::zero(),
    ];
    for _ in 0..n {
        let [re, im] = &power;
        let next = [
            re.times(&c).minus(&im.times(&s)),
            re.times(&s).plus(&im.times(&c)),
        ];
        power = next;
    }
    power
}

/// The polynomial with at most the first power of the variable `kept` (0 for cos, 1 for sin), by kept² = 1 − other².
fn reduced(f: &SparsePolynomial<2>, kept: usize) -> SparsePolynomial<2> {
    let other = SparsePolynomial::<2>::variable(1 - kept);
    let one = SparsePolynomial::constant(Rational::one());
    let square = one.minus(&other.squared());
    let mut sum = SparsePolynomial::zero();
    for (e, c) in f.terms() {
        let mut exponents = *e;
        let halved = exponents[kept] / 2;
        exponents[kept] %= 2;
        let monomial = SparsePolynomial::from_terms([(exponents, c.clone())]);
        sum.add_multiple(&monomial.times(&square.pow(halved)), &Rational::one());
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_identities() {
        // cos 2t = 1 − 2 sin² t = 2 cos² t − 1.
        let f = Expansion::from([([Basis::Cos(2), Basis::Power(0)], Rational::one())]);
        let [in_sines, in_cosines] = in_powers(&f, 1).unwrap();
        let [c, s] = [0, 1].map(SparsePolynomial::<2>::variable);
        let [one, two] = [1, 2].map(|n| SparsePolynomial::constant(Rational::from(n)));
        assert_eq!(in_sines, one.minus(&two.times(&s.squared())));
        assert_eq!(in_cosines, two.times(&c.squared()).minus(&one));
        // t cos t is not a sum of harmonics.
        let f = Expansion::from([([Basis::Cos(1), Basis::Power(1)], Rational::one())]);
        assert!(in_powers(&f, 1).is_none());
    }
}
