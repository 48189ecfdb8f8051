//! The origin as a singular point of the equation of a Fourier radius.
//!
//! Each zero θ₀ of r over the complex numbers, of order k, is a branch r(θ)(cos θ, sin θ) at the origin of multiplicity k with the tangent
//! at the angle θ₀. In the coordinates (ρ, θ) of the blow-up it is the graph of r, and the branch of a zero at θ₀ + π is the graph of
//! −r(θ + π). So the branch has δ = k(k − 1)/2, two branches with different tangents meet with the number k₁k₂, and those of zeros at θ₀
//! and θ₀ + π with k₁k₂ more than the order of r(θ) + r(θ + π), twice the even part E, at θ₀. Altogether δ = M(M − 1)/2 + Σ ord E for M
//! zeros with multiplicities, where the sum is over pairs of opposite zeros. If r has odd harmonics only, all of this is traced twice.

use super::singular::Singularity;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, polynomial_gcd, squarefree_decomposition};
use crate::shape::FourierRadius;

/// The origin of the equation of a radius, where the equation has the multiplicity `multiplicity`.
pub(super) fn at_origin(
    radius: &FourierRadius,
    multiplicity: usize,
    real_half_branches: usize,
) -> Singularity {
    let unknown = Singularity {
        multiplicity,
        milnor: None,
        delta: None,
        branches: None,
        tangents: None,
        real_half_branches,
    };
    let Some(own) = Zeros::new(radius) else {
        return unknown;
    };
    let (count, distinct) = (own.count(), own.distinct());
    let (all, branches, tangents, opposite) = match Zeros::new(&even_harmonics(radius)) {
        None => (count / 2, distinct / 2, distinct / 2, 0),
        Some(even) => {
            let (shared, orders) = own.shared_with(&even);
            (count, distinct, distinct - shared / 2, orders / 2)
        }
    };
    if all != multiplicity {
        return unknown;
    }
    let delta = all * (all - 1) / 2 + opposite;
    Singularity {
        milnor: Some(2 * delta + 1 - branches),
        delta: Some(delta),
        branches: Some(branches),
        tangents: Some(tangents),
        ..unknown
    }
}

/// The series without its odd harmonics.
fn even_harmonics(radius: &FourierRadius) -> FourierRadius {
    let even = |list: &[Rational]| {
        let mut kept = list.to_vec();
        let odd = kept.iter_mut().skip(1).step_by(2);
        odd.for_each(|c| *c = Rational::zero());
        kept
    };
    FourierRadius::new(even(radius.cosines()), even(radius.sines()))
}

/// The complex zeros of a series, in s = tan(θ/2).
struct Zeros {
    /// The squarefree parts of the numerator with their multiplicities.
    parts: Vec<(usize, IntegerPolynomial)>,
    /// The order at θ = π.
    at_infinity: usize,
}

impl Zeros {
    /// `None` for the series 0.
    fn new(series: &FourierRadius) -> Option<Self> {
        (!series.is_zero()).then(|| Self {
            parts: squarefree_decomposition(series.to_function().numerator()),
            at_infinity: order_at_infinity(series),
        })
    }

    fn count(&self) -> usize {
        let parts = self.parts.iter();
        parts.map(|(k, part)| k * degree(part)).sum::<usize>() + self.at_infinity
    }

    fn distinct(&self) -> usize {
        let parts = self.parts.iter().map(|(_, part)| degree(part));
        parts.sum::<usize>() + self.at_infinity.min(1)
    }

    /// The number of zeros that are zeros of another series, and the sum of their orders there.
    fn shared_with(&self, other: &Self) -> (usize, usize) {
        let both = self.at_infinity.min(1) * other.at_infinity;
        let mut found = (both.min(1), both);
        for (_, own) in &self.parts {
            for (order, part) in &other.parts {
                let shared = degree(&polynomial_gcd(own, part));
                found = (found.0 + shared, found.1 + order * shared);
            }
        }
        found
    }
}

/// The order of the zero at θ = π; 0 if there is none.
pub(super) fn order_at_infinity(series: &FourierRadius) -> usize {
    let function = series.to_function();
    let length = |f: &IntegerPolynomial| f.coefficients_asc().len();
    length(function.denominator()) - length(function.numerator())
}

fn degree(f: &IntegerPolynomial) -> usize {
    f.coefficients_asc().len().saturating_sub(1)
}
