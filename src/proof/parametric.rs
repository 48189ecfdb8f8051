//! Curves and patches whose coordinates are quotients of polynomials in rational parameters and in the cosines and sines of angles.

use num_bigint::BigInt;

use super::refusal::Checked;
use super::sparse::Sparse;

/// A parametrization. The generators are, in the order of the parameters, a rational parameter itself, or the cosine and the sine
/// of an angle.
#[derive(Debug)]
pub(super) struct Parametric {
    /// For every angle, the index of its sine among the generators; its cosine is the generator before.
    sines: Vec<usize>,
    generators: usize,
    pub(super) coordinates: Vec<Coordinate>,
}

/// A coordinate, numerator/denominator.
#[derive(Debug)]
pub(super) struct Coordinate {
    pub(super) numerator: Sparse,
    pub(super) denominator: Sparse,
}

impl Parametric {
    /// The parameters, each of which is an angle or rational; there are no coordinates yet.
    pub(super) fn new(angles: &[bool]) -> Self {
        let (mut sines, mut generators) = (Vec::new(), 0);
        for is_angle in angles {
            generators += 1;
            if *is_angle {
                sines.push(generators);
                generators += 1;
            }
        }
        Self {
            sines,
            generators,
            coordinates: Vec::new(),
        }
    }

    /// The number of generators.
    pub(super) fn generators(&self) -> usize {
        self.generators
    }

    /// The same function with exponents 0 and 1 of every sine, by sin² = 1 − cos². Such a polynomial is zero only as a function
    /// that is 0 everywhere.
    pub(super) fn reduced(&self, mut f: Sparse) -> Sparse {
        for &sine in &self.sines {
            if f.degree_in(sine) < 2 {
                continue;
            }
            let mut result = Sparse::default();
            for (exponents, c) in f.terms() {
                // sin^(2h + e) = (1 − cos²)^h·sin^e, by the binomial theorem.
                let half = exponents[sine] / 2;
                let mut term = *exponents;
                term[sine] %= 2;
                let mut factor = c.clone();
                for k in 0..=half {
                    result.add_term(term, factor.clone());
                    factor = -(factor * (half - k)) / BigInt::from(k + 1);
                    term[sine - 1] += 2;
                }
            }
            f = result;
        }
        f
    }

    /// The reduced product.
    pub(super) fn product(&self, f: &Sparse, g: &Sparse) -> Checked<Sparse> {
        Ok(self.reduced(f.times(g)?))
    }
}
