//! Counts the real roots of P(α, ·) for an algebraic α, by the signs of subresultants.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;

use crate::error::{Invariant, Result};
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, Weights, signed_subresultant};
use crate::roots::RealRoot;

/// The numbers of distinct roots of P(α, ·), without R = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct RootCount {
    /// The number of real roots.
    pub(super) real: usize,
    /// The number of positive roots.
    pub(super) positive: usize,
    /// The sum of all multiplicities beyond 1, over all complex roots.
    pub(super) repeated: usize,
}

/// Counts the roots of Σ a_i(α) R^i, where neither the first nor the last coefficient vanishes at α.
///
/// The signs of the signed subresultant coefficients at α give the number of real roots (Basu, Pollack, Roy, Theorem 4.33);
/// those of P(α, R²) give the number of positive roots.
pub(super) fn count_roots(
    coefficients: &[IntegerPolynomial],
    weights: Weights,
    alpha: &RealRoot,
    limits: &Limits,
) -> Result<RootCount> {
    let signs = subresultant_signs(coefficients, weights, alpha, limits)?;
    let repeated = signs.iter().position(|&s| s != 0).unwrap_or(0);
    let mut squared = Vec::with_capacity(2 * coefficients.len() - 1);
    for (i, a) in coefficients.iter().enumerate() {
        if i > 0 {
            squared.push(IntegerPolynomial::ZERO);
        }
        squared.push(a.clone());
    }
    // As a polynomial in R, P(α, R²) has half the step, rounded up.
    let doubled = Weights {
        lowest: weights.lowest,
        step: (weights.step + 1).div_euclid(2),
    };
    let twice = subresultant_signs(&squared, doubled, alpha, limits)?;
    Ok(RootCount {
        real: variations(&signs),
        positive: variations(&twice) / 2,
        repeated,
    })
}

/// The signs at α of sRes_0, …, sRes_(m−1), and of the leading coefficient.
fn subresultant_signs(
    coefficients: &[IntegerPolynomial],
    weights: Weights,
    alpha: &RealRoot,
    limits: &Limits,
) -> Result<Vec<i8>> {
    let m = coefficients.len() - 1;
    let mut signs = Vec::with_capacity(m + 1);
    for j in 0..m {
        let value = signed_subresultant(coefficients, j, weights, limits)?;
        signs.push(alpha.sign_of(&value));
    }
    signs.push(alpha.sign_of(&coefficients[m]));
    Ok(signs)
}

/// Permanences minus variations of the signs s_0, …, s_m, from s_m down, with the rule for gaps
/// (Basu, Pollack, Roy, Notation 4.30).
fn variations(signs: &[i8]) -> usize {
    let mut total = 0i64;
    let mut last: Option<(usize, i8)> = None;
    for (index, &sign) in signs.iter().enumerate().rev().filter(|(_, s)| **s != 0) {
        if let Some((above, other)) = last {
            let gap = above - index;
            if gap % 2 == 1 {
                let flip = (gap * (gap - 1) / 2) % 2 == 1;
                total += i64::from(other * sign) * if flip { -1 } else { 1 };
            }
        }
        last = Some((index, sign));
    }
    usize::try_from(total).invariant("a number of real roots is not negative")
}

/// The multiplicity of R = 0 as a root of a polynomial in R.
pub(super) fn zero_multiplicity(g: &IntegerPolynomial) -> usize {
    g.coefficients_asc()
        .iter()
        .take_while(|c| **c == Integer::ZERO)
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roots::real_roots;
    use malachite::base::polynomial::Polynomial;
    use proptest::prelude::*;

    fn poly(c: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
    }

    fn sqrt_two() -> RealRoot {
        real_roots(&poly(&[-2, 0, 1])).pop().unwrap()
    }

    #[test]
    fn multiple_roots_over_a_number_field() {
        // (R − √2)² (R + 3) (R² + 1) with t² = 2: R² − 2tR + 2 times R³ + 3R² + R + 3
        let square = [poly(&[2]), poly(&[0, -2]), poly(&[1])];
        let rest = [poly(&[3]), poly(&[1]), poly(&[3]), poly(&[1])];
        let mut product = vec![IntegerPolynomial::ZERO; 6];
        for (i, a) in square.iter().enumerate() {
            for (j, b) in rest.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        let weights = Weights { lowest: 1, step: 0 };
        let count = count_roots(&product, weights, &sqrt_two(), &Limits::none()).unwrap();
        assert_eq!(
            count,
            RootCount {
                real: 2,
                positive: 1,
                repeated: 1
            }
        );
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]
        /// For constant coefficients the count is that of exact root isolation.
        #[test]
        fn agrees_with_isolation(roots in prop::collection::vec((-4i64..5, 1usize..3), 0..4), pairs in prop::collection::vec(-3i64..4, 0..2), lead in prop_oneof![-3i64..0, 1i64..4]) {
            let mut f = poly(&[lead]);
            for (r, m) in &roots {
                for _ in 0..*m {
                    f *= poly(&[if *r == 0 { 7 } else { -r }, 1]);
                }
            }
            for b in &pairs {
                f *= poly(&[b * b + 2, -2 * b, 1]);
            }
            prop_assume!(f.coefficients_asc().len() > 1);
            let coefficients: Vec<IntegerPolynomial> = f.coefficients_asc().iter().map(|c| IntegerPolynomial::from_coefficients_asc(vec![c.clone()])).collect();
            let found = count_roots(&coefficients, Weights { lowest: 0, step: 0 }, &sqrt_two(), &Limits::none()).unwrap();
            let exact = real_roots(&f);
            prop_assert_eq!(found.real, exact.len());
            prop_assert_eq!(found.positive, exact.iter().filter(|r| r.signum() > 0).count());
            let squarefree: usize = crate::poly::squarefree_decomposition(&f).iter().map(|(_, g)| g.coefficients_asc().len() - 1).sum();
            prop_assert_eq!(found.repeated, f.coefficients_asc().len() - 1 - squarefree);
        }
    }
}
