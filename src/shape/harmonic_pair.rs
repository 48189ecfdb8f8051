//! The pair of forms of a harmonic surface: the sums of its odd and of its even harmonics, each homogeneous.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::HarmonicSurface;
use crate::bigint::binomials;
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{
    BinaryForm, TernaryForm, doubled_form_from_harmonics, legendre_derivative, with_integers,
};

/// The sums of the harmonics of odd and of even degree l, as forms: on the unit sphere a harmonic of degree l is a solid harmonic,
/// a form of degree l, and multiplied by a power of ρ = x² + y² + z², which is 1 there, a form of any degree l + 2e.
///
/// One of the two forms has degree L, the other L − 1. Together they have (L + 1)² coefficients, as many as there are harmonics, so
/// the pair is the radius in another basis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HarmonicPair {
    degree: usize,
    /// The factor by which the stored forms are larger than the sums.
    unit: Integer,
    /// `None` for L = 0.
    odd: Option<TernaryForm>,
    even: TernaryForm,
}

impl HarmonicPair {
    /// The pair of a surface. Cost: about L³/6 products of a coefficient and a short integer, and the changes of basis of 2L
    /// binary forms.
    #[must_use]
    pub fn new(surface: &HarmonicSurface) -> Self {
        let degree = surface.degree();
        let (denominator, coefficients) = surface.over_common_denominator();
        let sum = |parity: usize| {
            let d = if degree % 2 == parity {
                degree
            } else {
                degree - 1
            };
            doubled_sum(d, degree, &coefficients)
        };
        Self {
            degree,
            unit: denominator << (degree + 1),
            odd: (degree > 0).then(|| sum(1)),
            even: sum(0),
        }
    }

    /// The degree L of the surface.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Whether there are odd harmonics alone.
    #[must_use]
    pub fn is_odd(&self) -> bool {
        self.even.is_zero()
    }

    pub(crate) fn unit(&self) -> &Integer {
        &self.unit
    }

    /// The sum of the odd harmonics, times the unit; `None` for L = 0.
    pub(crate) fn odd(&self) -> Option<&TernaryForm> {
        self.odd.as_ref()
    }

    /// The sum of the even harmonics, times the unit.
    pub(crate) fn even(&self) -> &TernaryForm {
        &self.even
    }

    /// The exact value R(d) in the direction d of a vector (u, v, w) of rational length s: with u, v, w and s over one
    /// denominator, `(odd(u, v, w) s^e + even(u, v, w) s^(1−e)) / (unit s^L)`, where e = 1 if L is even.
    ///
    /// # Panics
    /// If the vector is not a unit vector.
    #[must_use]
    pub fn value(&self, unit_vector: &[Rational; 3]) -> Rational {
        let [odd, even] = self.values(unit_vector);
        odd + even
    }

    /// The exact values of the odd and of the even part of R: R(−d) is even − odd.
    ///
    /// # Panics
    /// If the vector is not a unit vector.
    #[must_use]
    pub fn values(&self, unit_vector: &[Rational; 3]) -> [Rational; 2] {
        let square = unit_vector.iter().map(|u| u * u).sum::<Rational>();
        assert!(square == Rational::one(), "a direction is a unit vector");
        let (scaled, s) = with_integers(unit_vector);
        let mut vector = scaled.into_coefficients_asc();
        vector.resize(3, Integer::ZERO);
        let vector: [Integer; 3] = vector
            .try_into()
            .invariant("a vector has three coordinates");
        let of = |form: &TernaryForm| {
            let below = &self.unit * (&s).pow(form.degree() as u64);
            Rational::from_integers(form.evaluate(&vector), below)
                .invariant("a denominator is not 0")
        };
        let odd = self.odd.as_ref().map_or_else(Rational::zero, of);
        [odd, of(&self.even)]
    }
}

/// `2^(L+1)` times the sum of the harmonics of the parity of d, as a form of degree d; the coefficients are integers.
///
/// At z = 1 a solid harmonic is `Re or Im (x+iy)^m · Σ_k b_k ρ^(k+(d−l)/2)`, with the coefficients b_k of
/// [`legendre_derivative`], and with ρ = 1 + s, s = x² + y², the sum for each m is a short polynomial in s by a Taylor shift. A
/// power s^j (x+iy)^m belongs to the binary form of degree m + 2j.
fn doubled_sum(d: usize, degree: usize, coefficients: &[Integer]) -> TernaryForm {
    // The harmonics (m, a, b) of the binary form of each degree.
    let mut rows: Vec<Vec<(usize, Integer, Integer)>> = vec![Vec::new(); d + 1];
    for m in 0..=d {
        let count = (d - m) / 2 + 1;
        let mut sums = [vec![Integer::ZERO; count], vec![Integer::ZERO; count]];
        let order = m.cast_signed();
        for l in (m..=d).filter(|l| l % 2 == d % 2) {
            let sine = (m > 0).then(|| &coefficients[HarmonicSurface::index(l, -order)]);
            let pair = [Some(&coefficients[HarmonicSurface::index(l, order)]), sine];
            if pair.iter().flatten().all(|c| **c == 0) {
                continue;
            }
            let short = |n: usize| u32::try_from(n).invariant("a degree is below 2^32");
            let b = legendre_derivative(short(l), short(m));
            for (c, sum) in pair.into_iter().zip(&mut sums) {
                let Some(c) = c.filter(|c| **c != 0) else {
                    continue;
                };
                let c = c << (degree - l);
                for (k, b) in b.iter().enumerate() {
                    sum[k + (d - l) / 2] += b * &c;
                }
            }
        }
        if sums.iter().flatten().all(|c| *c == 0) {
            continue;
        }
        sums.iter_mut().for_each(|sum| shift(sum));
        let [cosines, sines] = sums;
        for (j, (a, b)) in cosines.into_iter().zip(sines).enumerate() {
            rows[m + 2 * j].push((m, a, b));
        }
    }
    let forms = rows
        .iter()
        .enumerate()
        .map(|(n, row)| match row.as_slice() {
            [] => BinaryForm::zero(n),
            row => doubled_form_from_harmonics(n, row.iter().map(|(m, a, b)| (*m, a, b))),
        });
    // The binary form of degree n goes with z^(d−n).
    let mut forms: Vec<BinaryForm> = forms.collect();
    forms.reverse();
    TernaryForm::from_rows(forms)
}

/// Replaces p(s) by p(s + 1), by additions.
fn shift(p: &mut [Integer]) {
    let count = p.len();
    for first in 1..count {
        for k in (first - 1..count - 1).rev() {
            let (low, high) = p.split_at_mut(k + 1);
            low[k] += &high[0];
        }
    }
}

/// `factor · (x² + y² + z²)^power`, from the powers of x² + y² by the binomial theorem.
pub(crate) fn rho_power_in_space(power: usize, factor: &Integer) -> TernaryForm {
    let mut rows = Vec::with_capacity(2 * power + 1);
    for (e, binomial) in binomials(power).into_iter().enumerate() {
        let flat = BinaryForm::rho_power(power - e);
        rows.push(flat.scaled(&(binomial * factor)));
        if e < power {
            rows.push(BinaryForm::zero(2 * (power - e) - 1));
        }
    }
    TernaryForm::from_rows(rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use num_rational::BigRational;
    use proptest::prelude::*;

    /// R in the direction of a unit vector, from the recurrence of the associated Legendre functions in num-rational.
    fn naive(terms: &[(usize, isize, i64)], [u, v, w]: &[BigRational; 3]) -> BigRational {
        let whole = |n: i64| BigRational::from(BigInt::from(n));
        let mut sum = whole(0);
        for &(l, m, c) in terms {
            let order = m.unsigned_abs();
            // (x + iy)^m
            let (mut re, mut im) = (whole(1), whole(0));
            for _ in 0..order {
                (re, im) = (&re * u - &im * v, &re * v + &im * u);
            }
            // P_m^(m) = (2m−1)!!, (l−m) P_l^(m) = (2l−1) t P_(l−1)^(m) − (l+m−1) P_(l−2)^(m)
            let (mut last, mut p) = (whole(0), whole(1));
            for k in 1..=order {
                p *= whole(2 * k as i64 - 1);
            }
            for n in order + 1..=l {
                let (n, m) = (n as i64, order as i64);
                let next = (whole(2 * n - 1) * w * &p - whole(n + m - 1) * &last) / whole(n - m);
                last = std::mem::replace(&mut p, next);
            }
            sum += whole(c) * p * if m < 0 { im } else { re };
        }
        sum
    }

    proptest! {
        #[test]
        fn values_are_those_of_the_recurrence(
            list in prop::collection::vec((0usize..9, 0usize..17, -9i64..10), 1..12),
            p in -9i64..10, q in -9i64..10,
        ) {
            let terms: Vec<(usize, isize, i64)> = list
                .into_iter()
                .map(|(l, m, c)| (l, (m % (2 * l + 1)) as isize - l as isize, c))
                .collect();
            let surface = HarmonicSurface::new(terms.iter().map(|&(l, m, c)| ((l, m), c.into()))).unwrap();
            let pair = HarmonicPair::new(&surface);
            // A rational unit vector by stereographic projection.
            let n = p * p + q * q + 4;
            let vector = [4 * p, 4 * q, p * p + q * q - 4];
            let exact = vector.map(|x| Rational::new(x, n).unwrap());
            let plain = vector.map(|x| BigRational::new(x.into(), n.into()));
            prop_assert_eq!(BigRational::from(&pair.value(&exact)), naive(&terms, &plain));
            let [odd, even] = pair.values(&exact);
            let opposite = exact.each_ref().map(|x| -x);
            prop_assert_eq!(pair.value(&opposite), even - odd);
        }
    }
}
