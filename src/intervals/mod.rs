//! Polynomials as functions of doubles: exact signs, Taylor bounds over boxes, and certified crossings.

mod bounds;
mod crossing;
pub(crate) mod interval;
mod local;
mod power;
mod spectrum;
mod taylor;

pub(crate) use bounds::{BoxBounds, BoxProof, weights_of_common_zero};
pub(crate) use crossing::Crossing;
pub(crate) use interval::Interval;
pub(crate) use local::Local;
pub(crate) use power::Power;
pub(crate) use taylor::Taylor;

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use smallvec::SmallVec;

use crate::error::{Invariant, Result};
use crate::exact::{Dyadic, Rational};
use crate::limits::Limits;
use crate::poly::SparsePolynomial;
use interval::relative_error;
use taylor::Layout;

/// The number 2^(−900). It is added to sums of absolute values, so that a relative error of a sum also covers losses by
/// underflow.
///
/// Lemma 3. Consider fewer than 2^110 losses of 2^(−1075) by underflow, which later products magnify by at most some factor. If
/// a sum of absolute values is at least `FLOOR` times this factor, the losses are less than half a `UNIT` of the sum.
///
/// Proof. 2^110·2^(−1075) < 2^(−54)·2^(−900).
///
/// Laws: `values_are_within_their_bounds`, `coefficients_are_within_their_errors`, `boxes_hold_the_exact_values`.
const FLOOR: f64 = f64::from_bits((1023 - 900) << 52);

/// The powers 1, x, x², …. For low degrees they need no memory on the heap.
type Powers = SmallVec<[f64; 16]>;

/// A polynomial f, scaled so that its largest coefficient is 1, also with its coefficients as doubles.
#[derive(Debug)]
pub(crate) struct Field {
    exact: SparsePolynomial<3>,
    terms: Vec<([usize; 3], f64)>,
    /// The coefficients of the terms of a positive multiple of f, as integers.
    integers: Vec<Integer>,
    /// The degrees in each variable.
    degrees: [usize; 3],
    /// The error of a value in doubles, in parts of the sum of the absolute values of the terms.
    relative: f64,
    /// The error of the sums over a box, in parts of these sums.
    relative_of_boxes: f64,
    layout: Layout,
}

#[expect(
    clippy::cast_precision_loss,
    reason = "degrees and numbers of terms are small"
)]
impl Field {
    pub(crate) fn new(f: &SparsePolynomial<3>) -> Self {
        let largest = f.terms().map(|(_, c)| c.abs()).max();
        // The polynomial 0 has no terms and stays 0.
        let scale = largest.and_then(|c| c.recip());
        let exact = scale.map_or_else(SparsePolynomial::zero, |scale| f.scaled(&scale));
        let terms: Vec<([usize; 3], f64)> = exact
            .terms()
            .map(|(e, c)| (e.map(|k| k as usize), c.to_f64()))
            .collect();
        let degrees = terms.iter().fold([0; 3], |d: [usize; 3], (e, _)| {
            std::array::from_fn(|i| d[i].max(e[i]))
        });
        let degree: usize = degrees.iter().sum();
        let layout = Layout::new(&terms);
        Self {
            relative: relative_error(terms.len() + degree + 4),
            relative_of_boxes: relative_error(layout.exponents.len() + degree + 6),
            layout,
            integers: integers(&exact),
            exact,
            terms,
            degrees,
        }
    }

    /// The field of f(c + X), a polynomial in X.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(crate) fn about(&self, center: &[Rational; 3], limits: &Limits) -> Result<Self> {
        Ok(Self::new(&self.exact.about(center, limits)?))
    }

    /// The powers of the coordinates of p. The lists are filled in place, because copying finished lists takes longer than the
    /// products.
    fn powers(&self, p: [f64; 3]) -> [Powers; 3] {
        let mut lists = [Powers::new(), Powers::new(), Powers::new()];
        for (list, (degree, x)) in lists.iter_mut().zip(self.degrees.iter().zip(p)) {
            list.resize(degree + 1, 1.0);
            for k in 1..=*degree {
                list[k] = list[k - 1] * x;
            }
        }
        lists
    }

    /// The value of f at a point, as an interval.
    ///
    /// Lemma 4. Let T be the number of terms, D the sum of the degrees, and P the product of the largest powers that are > 1.
    /// The error of the computed value is at most `relative_error(T + D + 4)` times (the computed Σ|term| + `FLOOR`·P).
    ///
    /// Proof. A coefficient is rounded once, x^k is rounded k − 1 times, and each of its products is rounded once: at most D +
    /// 1 roundings for a term, and T for the sum (Lemma 2). Two more are those of the last sum and product here. A loss by
    /// underflow is multiplied by at most P later (Lemma 3), which counts as less than one more.
    ///
    /// Law: `values_are_within_their_bounds`.
    fn sums(&self, p: [f64; 3]) -> Interval {
        let [x, y, z] = self.powers(p);
        let (value, size) = self
            .terms
            .iter()
            .fold((0.0, 0.0), |(sum, size), ([i, j, k], c)| {
                let term = c * x[*i] * y[*j] * z[*k];
                (sum + term, size + term.abs())
            });
        let floor = FLOOR * largest_powers(&[x, y, z]);
        Interval::around(value, self.relative * (size + floor))
    }

    /// The exact sign of f at a point. Doubles with an error bound decide it if they can; else it is computed exactly.
    pub(crate) fn sign(&self, p: [f64; 3]) -> i8 {
        self.sums(p).sign().unwrap_or_else(|| self.exact_sign(p))
    }

    /// The sign of f at a point with finite coordinates, computed in integers.
    ///
    /// With x = m/2^e, … and d the degree in x, `2^(d e) …` times f has the terms `c m^i 2^((d − i) e) …`. These have no
    /// denominators, so no greatest common divisors are needed.
    fn exact_sign(&self, p: [f64; 3]) -> i8 {
        let powers: [Vec<Integer>; 3] = std::array::from_fn(|axis| {
            let x = Dyadic::from_f64(p[axis]).invariant(FINITE);
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

    /// The exact value of f at a point with finite coordinates.
    pub(crate) fn exact_value(&self, p: [f64; 3]) -> Rational {
        self.exact.evaluate(&rationals(p))
    }

    /// The exact values of f and its gradient.
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
                let factor = c * &Rational::whole(Integer::from(e[axis]));
                *slope = &*slope + &(factor * product(lower));
            }
        }
        (value, gradient)
    }

    /// The value of f in doubles, without a bound of its error.
    pub(crate) fn value(&self, p: [f64; 3]) -> f64 {
        let [x, y, z] = self.powers(p);
        let terms = self.terms.iter();
        terms.fold(0.0, |sum, ([i, j, k], c)| sum + c * x[*i] * y[*j] * z[*k])
    }

    /// The value of f and its gradient in doubles, without bounds of their errors.
    pub(crate) fn value_and_gradient(&self, p: [f64; 3]) -> (f64, [f64; 3]) {
        self.value_and_gradient_of(&self.powers(p), |c| c)
    }

    /// The value and the gradient of the polynomial whose coefficients are `coefficient` of those of f.
    fn value_and_gradient_of(
        &self,
        [x, y, z]: &[Powers; 3],
        coefficient: impl Fn(f64) -> f64,
    ) -> (f64, [f64; 3]) {
        // The derivative k x^(k−1).
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
            gradient[0] += slope(x, *i) * y[*j] * zc;
            gradient[1] += slope(y, *j) * x[*i] * zc;
            gradient[2] += slope(z, *k) * xy * c;
        }
        (sum, gradient)
    }

    /// The gradient in doubles, without a bound of its error.
    pub(crate) fn gradient(&self, p: [f64; 3]) -> [f64; 3] {
        self.value_and_gradient(p).1
    }

    /// The number of coefficients of a Taylor expansion.
    pub(crate) fn monomials(&self) -> usize {
        self.layout.exponents.len()
    }

    /// The approximate number of operations of an expansion.
    pub(crate) fn work(&self) -> usize {
        self.monomials() * self.degrees.iter().sum::<usize>().max(1)
    }

    /// Whether f does not depend on z.
    pub(crate) fn is_flat(&self) -> bool {
        self.degrees[2] == 0
    }

    /// The sign of f at all points whose coordinates differ from those of p by at most `off`; `None` if doubles do not prove
    /// that there is one sign.
    ///
    /// Lemma 5. At these points f differs from f(p) by at most off·Σ|∂f/∂xᵢ|, where the derivatives are those of the polynomial
    /// with the absolute values of the coefficients at the point (|pᵢ| + off), up to a relative error as in Lemma 4.
    ///
    /// Proof. By the mean value theorem, since the derivatives of that polynomial bound those of f and increase with all
    /// variables. Each of its terms is rounded at most D + 3 times, and once in each of the sums, T times in all.
    ///
    /// Law: `signs_nearby_are_those_of_the_point`.
    pub(crate) fn sign_near(&self, p: [f64; 3], off: f64) -> Option<i8> {
        let powers = self.powers(p.map(|x| (x.abs() + off).next_up()));
        let (_, slopes) = self.value_and_gradient_of(&powers, f64::abs);
        let slopes: f64 = slopes.iter().sum();
        let floor = FLOOR * largest_powers(&powers);
        let change = Interval::around(slopes, self.relative * (slopes + floor)) * off;
        (self.sums(p) + Interval::up_to(change.magnitude())).sign()
    }

    /// The polynomial f, scaled so that its largest coefficient is 1. Exact values and signs are those of this polynomial.
    pub(crate) fn polynomial(&self) -> &SparsePolynomial<3> {
        &self.exact
    }
}

/// The invariant for points at which signs and values are computed: algorithms end before they reach a point that is not
/// finite.
const FINITE: &str = "a point where a polynomial is asked for has finite coordinates";

/// The exact value of a double.
pub(crate) fn rational(x: f64) -> Rational {
    Rational::try_from(x).invariant(FINITE)
}

/// The exact coordinates of a point of doubles.
pub(crate) fn rationals(p: [f64; 3]) -> [Rational; 3] {
    p.map(rational)
}

/// The product of the largest powers of those variables for which they are > 1.
fn largest_powers(powers: &[Powers; 3]) -> f64 {
    let largest = powers.iter().filter_map(|list| list.last());
    largest.fold(1.0, |product, power| product * power.abs().max(1.0))
}

/// The coefficients, multiplied by a positive number that makes them integers.
fn integers(f: &SparsePolynomial<3>) -> Vec<Integer> {
    let primitive = f.primitive();
    let first = f.terms().next();
    let negative = first.is_some_and(|(_, c)| c.signum() < 0);
    let coefficients = primitive.terms().map(|(_, c)| c.numerator());
    // The first coefficient of a primitive polynomial is positive.
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

/// The largest size of a coordinate.
pub(crate) fn largest(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

/// The point a + t (b − a).
pub(crate) fn between(a: [f64; 3], b: [f64; 3], t: f64) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + t * (b[i] - a[i]))
}

#[cfg(test)]
pub(crate) mod tests;
