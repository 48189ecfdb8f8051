//! Bounds of the eigenvalues of a symmetric matrix. They are guessed in doubles, and an LDLᵀ decomposition proves them.

use nalgebra::Matrix3;

use super::interval::{Interval, cross, square};

/// Before a guess is proved it is moved outwards by this part of the largest entries. That is more than the usual error of the
/// guess and more than the width of the intervals in the decomposition. The bounds are right for any margin.
const MARGIN: f64 = 1024.0 * f64::EPSILON;

/// The cubic formula is used only if the absolute value of its cosine is less than this, because its error grows with 1/√(1 −
/// cosine²).
const CLOSE: f64 = 1.0 - 1.0 / 1024.0;

/// A symmetric matrix, by its diagonal and by the entries (1, 2), (0, 2), (0, 1).
type Symmetric = ([Interval; 3], [Interval; 3]);

/// Two doubles that enclose all eigenvalues of a symmetric matrix. They are infinite if its entries are not finite.
///
/// Lemma 7. If m − low·I and high·I − m have LDLᵀ decompositions with a positive D, all eigenvalues are between low and high.
/// If a guess has no such decomposition, Gershgorin's bounds are returned: the sum of a diagonal entry and the absolute values
/// of the others in its row.
///
/// Proof. A matrix with such a decomposition is positive definite (Sylvester).
///
/// Laws: `spectra_are_enclosed`, `spectra_are_tight`.
pub(super) fn spectrum(m: &Matrix3<f64>) -> [f64; 2] {
    let beside = m[(1, 2)].abs() + m[(0, 2)].abs() + m[(0, 1)].abs();
    let [a, b, c] = [0, 1, 2].map(|i| m[(i, i)]);
    if beside <= 0.0 && (a + b + c).is_finite() {
        // The matrix is diagonal, so its entries are the eigenvalues.
        return [a.min(b).min(c), a.max(b).max(c)];
    }
    let safe = gershgorin(m);
    if !m.iter().all(|x| x.is_finite()) {
        return safe;
    }
    let [low, high] = [1.0, -1.0].map(|sense| {
        let proved = |[least, most]: [f64; 2]| {
            let size = least.abs().max(most.abs());
            let guess = if sense > 0.0 { least } else { most };
            let bound = guess - sense * MARGIN * size;
            is_positive_definite(shifted(m, sense, bound)).then_some(bound)
        };
        closed_form(m).and_then(proved).or_else(|| {
            let found = m.symmetric_eigenvalues();
            proved([found.min(), found.max()])
        })
    });
    [
        low.map_or(safe[0], |low| low.max(safe[0])),
        high.map_or(safe[1], |high| high.min(safe[1])),
    ]
}

/// The extreme eigenvalues by the cubic formula in doubles (Smith, *Eigenvalues of a symmetric 3 × 3 matrix*, CACM 4 (1961));
/// `None` if two of them are so close that the arccosine loses digits.
fn closed_form(m: &Matrix3<f64>) -> Option<[f64; 2]> {
    let mean = m.trace() / 3.0;
    let rest = m - Matrix3::from_diagonal_element(mean);
    let size = (rest.norm_squared() / 6.0).sqrt();
    let cosine = (rest / size).determinant() / 2.0;
    let turn = (cosine.abs() < CLOSE).then(|| cosine.acos() / 3.0)?;
    let third = std::f64::consts::TAU / 3.0;
    Some([
        mean + 2.0 * size * (turn + third).cos(),
        mean + 2.0 * size * turn.cos(),
    ])
}

/// Gershgorin's bounds.
fn gershgorin(m: &Matrix3<f64>) -> [f64; 2] {
    let rows = [0, 1, 2].map(|i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let beside = Interval::from(m[(i, j)]).abs() + Interval::from(m[(i, k)]).abs();
        Interval::from(m[(i, i)]) + Interval::up_to(beside.high())
    });
    let [a, b, c] = rows;
    [
        a.low().min(b.low()).min(c.low()),
        a.high().max(b.high()).max(c.high()),
    ]
}

/// The matrix sense·(m − shift·I).
fn shifted(m: &Matrix3<f64>, sense: f64, shift: f64) -> Symmetric {
    let diagonal = [0, 1, 2].map(|i| (Interval::from(m[(i, i)]) - Interval::from(shift)) * sense);
    let beside = [(1, 2), (0, 2), (0, 1)].map(|at| Interval::from(sense * m[at]));
    (diagonal, beside)
}

/// Whether the pivots of an LDLᵀ decomposition are proved to be positive. The largest remaining diagonal entry is the next
/// pivot, so no entry grows.
fn is_positive_definite((diagonal, beside): Symmetric) -> bool {
    let larger = |i: usize, j: usize| {
        if diagonal[j].low() > diagonal[i].low() {
            j
        } else {
            i
        }
    };
    let first = larger(larger(0, 1), 2);
    let (i, j) = ((first + 1) % 3, (first + 2) % 3);
    let pivot = diagonal[first];
    if !pivot.is_positive() {
        return false;
    }
    // The rest after elimination with the pivot. The entries of the pivot's row are those opposite to j and to i.
    let (to_i, to_j) = (beside[j], beside[i]);
    let one = diagonal[i] - to_i.squared() / pivot;
    let other = diagonal[j] - to_j.squared() / pivot;
    let between = beside[first] - to_i * to_j / pivot;
    let (pivot, last) = if one.low() > other.low() {
        (one, other)
    } else {
        (other, one)
    };
    pivot.is_positive() && (last - between.squared() / pivot).is_positive()
}

/// A lower bound of uᵀmu/|u|² for all u ≠ 0 orthogonal to a vector that lies in a box; −∞ if this vector may be 0.
///
/// Lemma 8. For n = (x, y, z) let b = (−y, x, 0), or this vector with the coordinates permuted, and c = n × b. The least value
/// of uᵀmu/|u|² is (β + γ)/2 − √(((β − γ)/2)² + δ²) for β = bᵀmb/|b|², γ = cᵀmc/|c|² and δ² = (bᵀmc)²/(|b|²|c|²).
///
/// Proof. b and c are an orthogonal basis of the plane orthogonal to n, and the number is the smaller eigenvalue of ((β, δ),
/// (δ, γ)).
///
/// Law: `across_a_vector_nothing_is_less`.
pub(super) fn least_across(m: &Matrix3<f64>, n: [Interval; 3]) -> f64 {
    let smaller = |i: usize, j: usize| {
        if n[j].magnitude() < n[i].magnitude() {
            j
        } else {
            i
        }
    };
    let k = smaller(smaller(0, 1), 2);
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let mut b = [Interval::ZERO; 3];
    (b[i], b[j]) = (-n[j], n[i]);
    let c = cross(n, b);
    let form = |u: [Interval; 3], v: [Interval; 3]| {
        let mut sum = Interval::ZERO;
        for i in 0..3 {
            for j in 0..3 {
                sum = sum + u[i] * v[j] * m[(i, j)];
            }
        }
        sum
    };
    let (of_b, of_c) = (square(b), square(c));
    let (beta, gamma) = (form(b, b) / of_b, form(c, c) / of_c);
    let delta = form(b, c).squared() / (of_b * of_c);
    let half = ((beta - gamma) * 0.5).squared() + delta;
    ((beta + gamma) * 0.5 - half.sqrt()).low()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::intervals::{rational, rationals};
    use proptest::prelude::*;

    /// Whether a matrix of rational numbers has no negative eigenvalue, that is, no negative principal minor. This is exact.
    fn is_semidefinite(m: &[[Rational; 3]; 3]) -> bool {
        let two = |i: usize, j: usize| &m[i][i] * &m[j][j] - &m[i][j] * &m[i][j];
        let minor = |a: usize, b: usize| &m[1][a] * &m[2][b] - &m[1][b] * &m[2][a];
        let whole = &m[0][0] * minor(1, 2) - &m[0][1] * minor(0, 2) + &m[0][2] * minor(0, 1);
        (0..3).all(|i| m[i][i].signum() >= 0)
            && [two(0, 1), two(0, 2), two(1, 2), whole]
                .iter()
                .all(|d| d.signum() >= 0)
    }

    /// The matrix sense·(m − shift·I), exactly.
    fn exact_shifted(m: &Matrix3<f64>, sense: i64, shift: &Rational) -> [[Rational; 3]; 3] {
        [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| {
                let entry = rational(m[(i, j)]);
                let entry = if i == j { &entry - shift } else { entry };
                entry * Rational::from(sense)
            })
        })
    }

    /// Symmetric matrices with nearly equal eigenvalues (a multiple of the identity or of a reflection, plus a small rest), or
    /// with rows of very different sizes.
    fn matrices() -> impl Strategy<Value = Matrix3<f64>> {
        let entries = prop::array::uniform6(-1.0f64..1.0);
        let scales = prop::array::uniform3(-60i32..60);
        (
            entries,
            scales,
            -60i32..1,
            prop::array::uniform3(-3i32..4),
            0u8..3,
        )
            .prop_map(|(e, s, rest, v, kind)| {
                let [a, b, c, d, f, g] = e;
                let m = Matrix3::new(a, d, f, d, b, g, f, g, c);
                let v = v.map(f64::from);
                let plain = match kind {
                    0 => return Matrix3::from_fn(|i, j| m[(i, j)] * 2f64.powi(s[i] + s[j])),
                    1 => Matrix3::identity() * v[0],
                    _ => Matrix3::from_fn(|i, j| v[i] * v[j]) + Matrix3::identity() * v[0],
                };
                plain + m * 2f64.powi(rest)
            })
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

        /// Lemma 7 in comparison with exact minors.
        #[test]
        fn spectra_are_enclosed(m in matrices()) {
            let [low, high] = spectrum(&m);
            prop_assert!(is_semidefinite(&exact_shifted(&m, 1, &rational(low))));
            prop_assert!(is_semidefinite(&exact_shifted(&m, -1, &rational(high))));
            let [low, high] = gershgorin(&m);
            prop_assert!(is_semidefinite(&exact_shifted(&m, 1, &rational(low))));
            prop_assert!(is_semidefinite(&exact_shifted(&m, -1, &rational(high))));
        }

        /// Lemma 7 if the squares of the entries underflow, so that the cubic formula gives bad guesses: no bad guess is
        /// accepted.
        #[test]
        fn spectra_of_tiny_matrices_are_enclosed(m in matrices(), exponent in -550i32..-500) {
            let m = m * 2f64.powi(exponent);
            let [low, high] = spectrum(&m);
            prop_assert!(is_semidefinite(&exact_shifted(&m, 1, &rational(low))));
            prop_assert!(is_semidefinite(&exact_shifted(&m, -1, &rational(high))));
        }

        /// Only positive definite matrices are proved to be so, also next to a singular matrix.
        #[test]
        fn only_definite_matrices_are_proved(m in matrices(), nudge in -8i64..9) {
            let found = m.symmetric_eigenvalues();
            for (sense, end) in [(1, found.min()), (-1, found.max())] {
                let end = (0..nudge.abs()).fold(end, |end, _| if nudge > 0 { end.next_up() } else { end.next_down() });
                if is_positive_definite(shifted(&m, f64::from(sense), end)) {
                    prop_assert!(is_semidefinite(&exact_shifted(&m, i64::from(sense), &rational(end))));
                }
            }
        }

        /// The bounds exceed the exact ones by at most 2^(−40) of the entries, also if eigenvalues are nearly equal: a bound
        /// that is moved inwards by more is wrong.
        #[test]
        fn spectra_are_tight(m in matrices()) {
            let [low, high] = spectrum(&m);
            let moved = rational(m.norm()) * Rational::from(2).pow(-40).unwrap();
            prop_assert!(!is_semidefinite(&exact_shifted(&m, 1, &(rational(low) + &moved))) || m.norm() <= 0.0);
            prop_assert!(!is_semidefinite(&exact_shifted(&m, -1, &(rational(high) - &moved))) || m.norm() <= 0.0);
        }

        /// Lemma 8, for vectors orthogonal to an integer vector, exactly.
        #[test]
        fn across_a_vector_nothing_is_less(m in matrices(), n in prop::array::uniform3(-9i32..10), w in prop::array::uniform3(-9i32..10)) {
            let [n, w] = [n, w].map(|v| v.map(f64::from));
            let cross = [0, 1, 2].map(|i: usize| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                n[j] * w[k] - n[k] * w[j]
            });
            prop_assume!(cross.iter().any(|x| x.abs() > 0.5));
            let least = least_across(&m, n.map(Interval::from));
            prop_assume!(least.is_finite());
            let u = rationals(cross);
            let rows = exact_shifted(&m, 1, &rational(least));
            let form: Rational = (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(|(i, j)| &u[i] * &u[j] * &rows[i][j]).sum();
            prop_assert!(form.signum() >= 0);
        }
    }

    #[test]
    fn a_guess_that_is_none_is_not_believed() {
        let m = Matrix3::new(2.0, 1.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 5.0);
        // The eigenvalues are 1, 3 and 5.
        assert!(is_positive_definite(shifted(&m, 1.0, 1.0 - 1e-14)));
        assert!(!is_positive_definite(shifted(&m, 1.0, 1.0)));
        assert!(!is_positive_definite(shifted(&m, -1.0, 5.0)));
        assert!(!is_positive_definite(shifted(&m, -1.0, 4.9)));
    }
}
