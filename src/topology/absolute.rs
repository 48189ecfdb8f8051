//! The number of factors over the complex numbers of a polynomial that is irreducible over Q.

use crate::modular::{PrimeField, kernel};

use super::sweep::Sheared;

/// The number of absolutely irreducible factors of f modulo a prime of good reduction.
///
/// Ruppert and Gao (*Factoring multivariate polynomials via partial differential equations*, Mathematics of Computation 72,
/// 2003): the solutions (g, h) of ∂/∂v (g/f) = ∂/∂u (h/f) with deg g, deg h ≤ n − 1 are spanned by the Σ over the factors f_i of
/// f/f_i · (∂f_i/∂u, ∂f_i/∂v), if the characteristic is 0 or larger than (2n − 1) n. A prime of good reduction has the covers of
/// the line that belong to the factors, so their number is that over the complex numbers.
///
/// Cost: Gaussian elimination for n(n + 1) unknowns and n(2n − 1) equations.
pub(super) fn absolute_factors(curve: &Sheared, prime: u64) -> usize {
    let n = curve.degree;
    let field = PrimeField::new(prime);
    // f_(ij) is the coefficient of u^j v^i.
    let rows = curve.modulo(&field);
    let f = |i: usize, j: usize| rows.get(i).and_then(|row| row.get(j)).copied().unwrap_or(0);
    // The terms of degree at most n − 1, and of degree at most 2n − 2.
    let monomials = |degree: usize| -> Vec<(usize, usize)> {
        (0..=degree)
            .flat_map(|i| (0..=degree - i).map(move |j| (i, j)))
            .collect()
    };
    let unknowns = monomials(n - 1);
    let half = unknowns.len();
    let equations = monomials(2 * n - 2);
    let mut index = vec![vec![usize::MAX; 2 * n]; 2 * n];
    for (k, &(i, j)) in equations.iter().enumerate() {
        index[i][j] = k;
    }
    let mut matrix = vec![vec![0; 2 * half]; equations.len()];
    let p = field.prime();
    // f ∂g/∂v − g ∂f/∂v − f ∂h/∂u + h ∂f/∂u, where the unknown of (a, b) is the coefficient of u^b v^a.
    for (column, &(a, b)) in unknowns.iter().enumerate() {
        for i in 0..=n {
            for j in 0..=n - i {
                let c = f(i, j);
                if c == 0 {
                    continue;
                }
                let signed = |x: usize, y: usize| {
                    if x >= y {
                        (x - y) as u64
                    } else {
                        p - (y - x) as u64
                    }
                };
                // c u^j v^i and u^b v^a give (a − i) c u^(j+b) v^(i+a−1), and for h (j − b) c u^(j+b−1) v^(i+a).
                if i + a > 0 && a != i {
                    let row = index[i + a - 1][j + b];
                    let entry = &mut matrix[row][column];
                    *entry = field.sum(*entry, field.mul(c, signed(a, i)));
                }
                if j + b > 0 && b != j {
                    let row = index[i + a][j + b - 1];
                    let entry = &mut matrix[row][half + column];
                    *entry = field.sum(*entry, field.mul(c, signed(j, b)));
                }
            }
        }
    }
    kernel(matrix, 2 * half, p).vectors.len()
}
