//! A polynomial as a function of doubles: exact signs, Taylor bounds over boxes, certified crossings.

mod bounds;
mod crossing;
mod local;
mod taylor;

pub(crate) use bounds::{BoxBounds, Verdict};
pub(crate) use crossing::Crossing;
pub(crate) use local::Local;
pub(crate) use taylor::Taylor;

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use smallvec::SmallVec;

use crate::exact::{Dyadic, Rational};
use crate::poly::SparsePolynomial;
use taylor::Layout;

/// Half of the distance from 1 to the next double.
const UNIT: f64 = 1.11e-16;
/// Below this products may lose digits to underflow.
const TINY: f64 = 1e-280;

/// 1, x, x², … Those of low degrees need no memory of their own.
type Powers = SmallVec<[f64; 16]>;

/// f, with its coefficients also as doubles, scaled so that the largest is 1.
#[derive(Debug)]
pub(crate) struct Field {
    exact: SparsePolynomial<3>,
    terms: Vec<([usize; 3], f64)>,
    /// A positive multiple of f: the coefficients of its terms.
    integers: Vec<Integer>,
    /// In each variable.
    degrees: [usize; 3],
    /// A relative error bound of a sum of terms in doubles.
    relative: f64,
    layout: Layout,
}

#[expect(
    clippy::cast_precision_loss,
    reason = "degrees and numbers of terms are small"
)]
impl Field {
    pub(crate) fn new(f: &SparsePolynomial<3>) -> Self {
        let largest = f.terms().map(|(_, c)| c.abs()).max();
        let scale = largest.and_then(|c| c.recip()).unwrap_or_default();
        let exact = f.scaled(&scale);
        let terms: Vec<([usize; 3], f64)> = exact
            .terms()
            .map(|(e, c)| (e.map(|k| k as usize), c.to_f64()))
            .collect();
        let degrees = terms.iter().fold([0; 3], |d: [usize; 3], (e, _)| {
            std::array::from_fn(|i| d[i].max(e[i]))
        });
        // One rounding per coefficient, the powers, two products, one sum per term.
        let roundings = terms.len() + degrees.iter().sum::<usize>() + 8;
        Self {
            relative: 1.01 * UNIT * roundings as f64,
            layout: Layout::new(&terms),
            integers: integers(&exact),
            exact,
            terms,
            degrees,
        }
    }

    fn powers(&self, p: [f64; 3]) -> [Powers; 3] {
        std::array::from_fn(|i| {
            let mut list = Powers::new();
            let mut power = 1.0;
            for _ in 0..=self.degrees[i] {
                list.push(power);
                power *= p[i];
            }
            list
        })
    }

    /// (f, Σ |term|) in doubles.
    fn sums(&self, p: [f64; 3]) -> (f64, f64) {
        let [x, y, z] = self.powers(p);
        self.terms
            .iter()
            .fold((0.0, 0.0), |(sum, size), ([i, j, k], c)| {
                let term = c * x[*i] * y[*j] * z[*k];
                (sum + term, size + term.abs())
            })
    }

    fn tiny(&self, p: [f64; 3]) -> f64 {
        let sizes = p.iter().zip(self.degrees);
        sizes.fold(TINY, |size, (x, d)| size * x.abs().max(1.0).powf(d as f64))
    }

    /// The exact sign of f at a point: by doubles with an error bound where that decides, else exactly.
    pub(crate) fn sign(&self, p: [f64; 3]) -> i8 {
        let (value, size) = self.sums(p);
        if value.abs() > size * self.relative + self.tiny(p) {
            return if value > 0.0 { 1 } else { -1 };
        }
        self.exact_sign(p)
    }

    /// The sign of f at a point with finite coordinates, in integers.
    ///
    /// With x = m/2^e, … and d the degree in x, `2^(d e) …` times f has the terms `c m^i 2^((d − i) e) …`: no
    /// denominators, so no greatest common divisors.
    fn exact_sign(&self, p: [f64; 3]) -> i8 {
        let powers: [Vec<Integer>; 3] = std::array::from_fn(|axis| {
            let x = Dyadic::from_f64(p[axis]).unwrap_or_else(Dyadic::zero);
            let shift = x.exponent().unsigned_abs();
            let degree = self.degrees[axis] as u64;
            let (mantissa, missing) = match x.exponent() < 0 {
                true => (x.mantissa().clone(), shift),
                false => (x.mantissa() << shift, 0),
            };
            let powers = std::iter::successors(Some(Integer::ONE), |power| Some(power * &mantissa));
            (0..=degree)
                .zip(powers)
                .map(|(i, power)| power << (missing * (degree - i)))
                .collect()
        });
        let mut sum = Integer::ZERO;
        for (([i, j, k], _), c) in self.terms.iter().zip(&self.integers) {
            sum += c * &powers[0][*i] * (&powers[1][*j] * &powers[2][*k]);
        }
        match sum.cmp(&Integer::ZERO) {
            Ordering::Less => -1,
            Ordering::Equal => 0,
            Ordering::Greater => 1,
        }
    }

    /// f, exactly, at a point with finite coordinates.
    pub(crate) fn exact_value(&self, p: [f64; 3]) -> Rational {
        let exact = p.map(|x| Rational::try_from(x).unwrap_or_default());
        self.exact.evaluate(&exact)
    }

    /// f and its gradient, exactly.
    pub(crate) fn exact_value_and_gradient(&self, p: &[Rational; 3]) -> (Rational, [Rational; 3]) {
        let powers: [Vec<Rational>; 3] = std::array::from_fn(|i| {
            let all = std::iter::successors(Some(Rational::one()), |power| Some(power * &p[i]));
            all.take(self.degrees[i] + 1).collect()
        });
        let mut value = Rational::zero();
        let mut gradient = std::array::from_fn(|_| Rational::zero());
        for (e, c) in self.exact.terms() {
            let e = e.map(|k| k as usize);
            let product = |e: [usize; 3]| &(&powers[0][e[0]] * &powers[1][e[1]]) * &powers[2][e[2]];
            value = &value + &(c * &product(e));
            for (axis, slope) in gradient
                .iter_mut()
                .enumerate()
                .filter(|(axis, _)| e[*axis] > 0)
            {
                let mut lower = e;
                lower[axis] -= 1;
                let factor = c * &Rational::from(Integer::from(e[axis]));
                *slope = &*slope + &(factor * product(lower));
            }
        }
        (value, gradient)
    }

    /// f in doubles, with no bound of its error.
    pub(crate) fn value(&self, p: [f64; 3]) -> f64 {
        self.sums(p).0
    }

    /// f and its gradient in doubles, with no bound of their errors.
    pub(crate) fn value_and_gradient(&self, p: [f64; 3]) -> (f64, [f64; 3]) {
        self.value_and_gradient_of(p, |c| c)
    }

    /// The same for the polynomial whose coefficients are some function of those of f.
    fn value_and_gradient_of(
        &self,
        p: [f64; 3],
        coefficient: impl Fn(f64) -> f64,
    ) -> (f64, [f64; 3]) {
        let [x, y, z] = self.powers(p);
        // k x^(k−1)
        let slope = |list: &Powers, k: usize| match k {
            0 => 0.0,
            k => k as f64 * list[k - 1],
        };
        let mut sum = 0.0;
        let mut gradient = [0.0; 3];
        for ([i, j, k], c) in &self.terms {
            let c = coefficient(*c);
            let (xy, zc) = (x[*i] * y[*j], c * z[*k]);
            sum += xy * zc;
            gradient[0] += slope(&x, *i) * y[*j] * zc;
            gradient[1] += slope(&y, *j) * x[*i] * zc;
            gradient[2] += slope(&z, *k) * xy * c;
        }
        (sum, gradient)
    }

    /// The gradient in doubles, with no bound of its error.
    pub(crate) fn gradient(&self, p: [f64; 3]) -> [f64; 3] {
        self.value_and_gradient(p).1
    }

    /// How many coefficients a Taylor expansion has.
    pub(crate) fn monomials(&self) -> usize {
        self.layout.exponents.len()
    }

    /// About how many operations an expansion takes.
    pub(crate) fn work(&self) -> usize {
        self.monomials() * self.degrees.iter().sum::<usize>().max(1)
    }

    /// f does not depend on z.
    pub(crate) fn is_flat(&self) -> bool {
        self.degrees[2] == 0
    }

    /// The sign of f at all points whose coordinates are within `off` of those of p, if doubles tell.
    pub(crate) fn sign_near(&self, p: [f64; 3], off: f64) -> Option<i8> {
        let (value, _) = self.sums(p);
        // What the sizes of the terms are at most nearby, and how fast they change.
        let (size, slopes) = self.value_and_gradient_of(p.map(|x| x.abs() + off), f64::abs);
        let spread = size * self.relative + 1.01 * off * slopes.iter().sum::<f64>();
        let is_certain = value.abs() > spread + self.tiny(p);
        is_certain.then_some(if value > 0.0 { 1 } else { -1 })
    }

    /// f with its largest coefficient 1: what the exact values and signs are those of.
    pub(crate) fn polynomial(&self) -> &SparsePolynomial<3> {
        &self.exact
    }
}

/// The coefficients times a positive number that makes them integers.
fn integers(f: &SparsePolynomial<3>) -> Vec<Integer> {
    let primitive = f.primitive();
    let first = f.terms().next();
    let negative = first.is_some_and(|(_, c)| c.signum() < 0);
    let coefficients = primitive.terms().map(|(_, c)| c.numerator());
    // The first one of a primitive polynomial is positive.
    coefficients
        .map(|c| if negative { -c } else { c })
        .collect()
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

/// a + t (b − a)
pub(crate) fn between(a: [f64; 3], b: [f64; 3], t: f64) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + t * (b[i] - a[i]))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::poly::Ring;
    use proptest::prelude::*;

    /// x² + y² + z² − c
    pub(crate) fn sphere(c: i64) -> SparsePolynomial<3> {
        let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
        let squares = x.squared().plus(&y.squared()).plus(&z.squared());
        squares.minus(&SparsePolynomial::constant(c.into()))
    }

    /// The cubic with the given coefficients.
    pub(crate) fn cubic(coefficients: &[i64]) -> SparsePolynomial<3> {
        let all = (0..4u32)
            .flat_map(|i| (0..4 - i).flat_map(move |j| (0..4 - i - j).map(move |k| [i, j, k])));
        SparsePolynomial::from_terms(all.zip(coefficients.iter().map(|c| Rational::from(*c))))
    }

    #[test]
    fn signs_are_exact_where_doubles_vanish() {
        // (x − y)² − 2⁻¹⁰⁰ z² beside x = y
        let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
        let small = Rational::from(2).pow(-100).unwrap();
        let f = Field::new(&x.minus(&y).squared().minus(&z.squared().scaled(&small)));
        assert_eq!(f.sign([1.0, 1.0, 1.0]), -1);
        assert_eq!(f.sign([1.0, 1.0, 0.0]), 0);
        // (4·2⁻⁵²)² = 2⁻¹⁰⁰
        for (ulps, sign) in [(3.0, -1), (4.0, 0), (5.0, 1)] {
            assert_eq!(f.sign([1.0, 1.0 + ulps * f64::EPSILON, 1.0]), sign);
        }
    }

    proptest! {
        #[test]
        fn signs_in_integers_are_those_of_fractions(
            coefficients in prop::collection::vec((-9i64..=9, 1i64..9), 20),
            p in prop::array::uniform3((-20i32..20, -60i32..20)),
        ) {
            let f = cubic(&[1; 20]);
            let terms = f.terms().zip(&coefficients);
            let f = SparsePolynomial::from_terms(terms.filter_map(|((e, _), (p, q))| {
                Some((*e, Rational::new((*p).into(), (*q).into())?))
            }));
            prop_assume!(!f.is_empty());
            let f = Field::new(&f);
            // Small mantissas, so that zeros are met.
            let p = p.map(|(m, e)| f64::from(m) * 2f64.powi(e / 3));
            prop_assert_eq!(f.exact_sign(p), f.exact_value(p).signum());
            prop_assert_eq!(f.sign(p), f.exact_sign(p));
        }
    }
}
