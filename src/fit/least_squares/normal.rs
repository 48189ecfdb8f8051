//! The normal equations of a trigonometric series.
//!
//! With the functions 1, cos θ, sin θ, cos 2θ, … and the weights w_i, every entry of the matrix is a sum of two of the moments
//! Σ w_i cos kθ_i and Σ w_i sin kθ_i with k ≤ 2N, by the product formulas of cos and sin.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use rustfft::num_complex::Complex;

use super::sums::wave_sums;

/// The matrix of the normal equations, divided by the sum of the weights, as a product of triangular ones.
pub(super) struct NormalEquations {
    cholesky: Cholesky<f64, Dyn>,
    /// The sum of the weights.
    total: f64,
    /// The sum of the sizes of the entries of a column of the matrix, the largest one.
    norm: f64,
}

impl NormalEquations {
    /// The equations for N harmonics; `None` if the angles do not determine the coefficients at all.
    pub(super) fn new(angles: &[f64], weights: &[f64], harmonics: usize) -> Option<Self> {
        let moments = wave_sums(angles, |i| [weights[i]], 2 * harmonics);
        let total = moments[0][0].re;
        let moment = |k: usize| moments[k][0] / total;
        let size = 2 * harmonics + 1;
        let entry = |row: usize, column: usize| {
            let (row, column) = (row.max(column), row.min(column));
            let (j, k) = (row.div_ceil(2), column.div_ceil(2));
            let (sum, difference) = (moment(j + k), moment(j - k));
            // The odd places have cosines, the even ones sines.
            let is_sine = |place: usize| place > 0 && place.is_multiple_of(2);
            match (is_sine(row), is_sine(column)) {
                (false, false) => f64::midpoint(difference.re, sum.re),
                (true, true) => f64::midpoint(difference.re, -sum.re),
                (true, false) => f64::midpoint(difference.im, sum.im),
                (false, true) => f64::midpoint(-difference.im, sum.im),
            }
        };
        let matrix = DMatrix::from_fn(size, size, entry);
        let norm = largest_column(&matrix);
        let cholesky = Cholesky::new(matrix)?;
        Some(Self {
            cholesky,
            total,
            norm,
        })
    }

    /// The coefficients a_n + i b_n for the right sides Σ w_i v_i e^(inθ_i).
    pub(super) fn solve<const D: usize>(
        &self,
        right: &[[Complex<f64>; D]],
    ) -> Vec<[Complex<f64>; D]> {
        let mut found = vec![[Complex::default(); D]; right.len()];
        for d in 0..D {
            let right: Vec<Complex<f64>> = right.iter().map(|r| r[d] / self.total).collect();
            let solution = self.cholesky.solve(&to_places(&right));
            for (slot, c) in found.iter_mut().zip(from_places(&solution)) {
                slot[d] = c;
            }
        }
        found
    }

    /// The condition number of the matrix in the norm of sums, and the diagonal of its inverse, as a_n + i b_n.
    pub(super) fn condition(&self) -> (f64, Vec<Complex<f64>>) {
        let inverse = self.cholesky.inverse();
        let condition = self.norm * largest_column(&inverse);
        let diagonal = inverse.diagonal() / self.total;
        (condition, from_places(&diagonal))
    }
}

/// The largest sum of the sizes of the entries of a column.
fn largest_column(matrix: &DMatrix<f64>) -> f64 {
    matrix
        .column_iter()
        .map(|column| column.iter().map(|entry| entry.abs()).sum())
        .fold(0.0, f64::max)
}

/// Numbers a_n + i b_n as a_0, a_1, b_1, a_2, …
fn to_places(numbers: &[Complex<f64>]) -> DVector<f64> {
    let places = numbers.iter().flat_map(|c| [c.re, c.im]);
    // b_0 has no place.
    let without_first_sine = places.enumerate().filter(|(place, _)| *place != 1);
    let values: Vec<f64> = without_first_sine.map(|(_, value)| value).collect();
    DVector::from_vec(values)
}

fn from_places(places: &DVector<f64>) -> Vec<Complex<f64>> {
    let pairs = places.as_slice()[1..].chunks_exact(2);
    std::iter::once(Complex::new(places[0], 0.0))
        .chain(pairs.map(|pair| Complex::new(pair[0], pair[1])))
        .collect()
}
