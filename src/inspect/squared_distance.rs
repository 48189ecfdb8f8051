//! The squared distance between a point and a curve, as an exact rational function of the curve's parameter.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Gcd};
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::{Derivative, Polynomial};

use crate::error::Invariant;
use crate::exact::{Dyadic, Rational};
use crate::intervals::Interval;
use crate::poly::{IntegerPolynomial, divide_exactly, numerator_at, polynomial_gcd, scaled};
use crate::roots::real_roots;
use crate::shape::ParametricCurve;

/// For the curve X_i(s)/W(s), i < N, the three polynomials from which every distance is made: Σ X_i², X_i W and W².
#[derive(Clone, Debug)]
pub(super) struct DistanceForms<const N: usize> {
    squares: IntegerPolynomial,
    products: [IntegerPolynomial; N],
    weight: IntegerPolynomial,
    /// 2 max(deg X_i, deg W), the degree of all three as forms, so that s may be infinite.
    degree: usize,
    /// Whether W has a real zero or a zero at infinity, so that the curve goes to infinity.
    pub(super) is_unbounded: bool,
}

/// The squared distance |γ(s) − p|² = above/below from one point p.
#[derive(Clone, Debug)]
pub(super) struct SquaredDistance {
    above: IntegerPolynomial,
    below: IntegerPolynomial,
    degree: usize,
}

impl<const N: usize> DistanceForms<N> {
    /// The forms of a curve; W is the least common denominator.
    pub(super) fn new(curve: &ParametricCurve<N>) -> Self {
        let one = IntegerPolynomial::from_coefficients_asc(vec![Integer::from(1)]);
        let coordinates = curve.coordinates();
        let common = coordinates.iter().fold(one, |common, f| {
            let shared = polynomial_gcd(&common, f.denominator());
            let rest = divide_exactly(f.denominator(), &shared);
            // The gcd is primitive, so constant factors of the denominators are multiplied.
            common * rest.invariant("a gcd divides")
        });
        let above = coordinates.each_ref().map(|f| {
            let rest = divide_exactly(&common, f.denominator());
            f.numerator() * rest.invariant("a denominator divides the common one")
        });
        let length = |f: &IntegerPolynomial| f.coefficients_asc().len();
        let longest = above.iter().map(length).fold(length(&common), usize::max);
        let squares = above.iter().map(|x| x * x);
        let is_unbounded = length(&common) < longest || !real_roots(&common).is_empty();
        Self {
            squares: squares.fold(IntegerPolynomial::ZERO, |sum, square| sum + square),
            products: above.each_ref().map(|x| x * &common),
            weight: &common * &common,
            degree: 2 * (longest - 1),
            is_unbounded,
        }
    }

    /// The squared distance from the point p = P/Q: the quotient of Q² Σ X_i² − 2Q Σ P_i X_i W + Σ P_i² W² and Q² W².
    pub(super) fn to_point(&self, point: &[Rational; N]) -> SquaredDistance {
        let q = point.iter().fold(Integer::from(1), |q, p| {
            let own = p.denominator();
            let shared = Integer::from(q.unsigned_abs_ref().gcd(own.unsigned_abs_ref()));
            q * own.div_exact(shared)
        });
        let p = point.each_ref().map(|p| {
            let scaled = p * &Rational::whole(&q);
            scaled.numerator()
        });
        let norm: Integer = p.iter().map(|p| p * p).fold(Integer::ZERO, |a, b| a + b);
        let squared = &q * &q;
        let coefficient = |f: &IntegerPolynomial, k: usize| {
            f.coefficients_asc().get(k).cloned().unwrap_or_default()
        };
        let above = (0..=self.degree).map(|k| {
            let mut value = coefficient(&self.squares, k) * &squared;
            for (p, product) in p.iter().zip(&self.products) {
                value -= (coefficient(product, k) * p * &q) << 1u64;
            }
            value + coefficient(&self.weight, k) * &norm
        });
        SquaredDistance {
            above: IntegerPolynomial::from_coefficients_asc(above.collect()),
            below: scaled(&self.weight, &squared),
            degree: self.degree,
        }
    }
}

impl SquaredDistance {
    /// The value at s; `None` at a pole.
    pub(super) fn at(&self, s: &Dyadic) -> Option<Rational> {
        let [above, below] = [&self.above, &self.below].map(|f| value(f, s));
        (!below.is_zero()).then(|| above / below)
    }

    /// The value at s = ∞; `None` at a pole.
    pub(super) fn at_infinity(&self) -> Option<Rational> {
        let [above, below] = [&self.above, &self.below].map(|f| self.lead(f));
        Rational::from_integers(above, below)
    }

    /// The coefficient of s^degree.
    fn lead(&self, f: &IntegerPolynomial) -> Integer {
        let lead = f.coefficients_asc().get(self.degree);
        lead.cloned().unwrap_or_default()
    }

    /// One step of Newton's method from s towards a zero of the derivative; `None` if there is no such step.
    pub(super) fn newton_step(&self, s: &Dyadic) -> Option<Rational> {
        let [g, v] = [&self.above, &self.below];
        let first = [g, v].map(|f| f.derivative());
        let second = first.each_ref().map(|f| f.derivative());
        let [g, v] = [g, v].map(|f| value(f, s));
        let [g1, v1] = first.each_ref().map(|f| value(f, s));
        let [g2, v2] = second.each_ref().map(|f| value(f, s));
        let slope = &g1 * &v - &g * &v1;
        let bend = g2 * v - g * v2;
        let step = slope * bend.recip()?;
        Some(s.to_rational() - step)
    }

    /// above − level·below, times the denominator of the level. It is 0 where the squared distance is the level.
    fn beyond(&self, level: &Rational) -> IntegerPolynomial {
        let (p, q) = (level.numerator(), level.denominator());
        scaled(&self.above, &q) - scaled(&self.below, &p)
    }

    /// The exact position of the curve relative to the sphere about the point whose squared radius is `level`.
    pub(super) fn against(&self, level: &Rational) -> Against {
        let beyond = self.beyond(level);
        if beyond == IntegerPolynomial::ZERO || self.lead(&beyond) == 0 {
            return Against::Meets;
        }
        // If the polynomial is 0 at 0, that is a root; if it has no root, its sign at 0 is its sign everywhere.
        match beyond.coefficients_asc().first() {
            Some(constant) if *constant == 0 => Against::Meets,
            _ if !real_roots(&beyond).is_empty() => Against::Meets,
            Some(constant) if *constant < 0 => Against::Inside,
            _ => Against::Outside,
        }
    }

    /// Parameters, in doubles, near the exact ones at which the curve meets the sphere.
    pub(super) fn crossings(&self, level: &Rational) -> Vec<f64> {
        let roots = real_roots(&self.beyond(level));
        roots.iter().map(|root| root.to_f64()).collect()
    }
}

/// The position of a curve relative to a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Against {
    /// The curve has a point on the sphere.
    Meets,
    /// All of the curve is inside.
    Inside,
    /// All of the curve is outside.
    Outside,
}

/// The exact value f(s).
fn value(f: &IntegerPolynomial, s: &Dyadic) -> Rational {
    let lowered = s.exponent().min(0).unsigned_abs();
    let degree = f.coefficients_asc().len().saturating_sub(1) as u64;
    let scale = Integer::from(1) << (lowered * degree);
    Rational::whole(numerator_at(f, s)) / Rational::whole(scale)
}

/// The squared distance of two points, in doubles.
pub(super) fn squared_in_doubles<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum()
}

/// A double that is at least the square root.
pub(super) fn upper_root(squared: &Rational) -> f64 {
    Interval::from(squared).sqrt().high()
}
