//! Values of a sum of complex exponentials at equidistant parameters, with a proved bound of the rounding errors.

use malachite::Integer;

use super::super::turns::Turns;
use crate::error::Result;
use crate::limits::Limits;
use crate::roots::{UnitBall, rotations};

/// The values of Σ c_k e^(ikt), where k is counted modulo M, at t = 2πj/M for j = 0, …, M − 1, in place; M is a power of two and at
/// least 4.
///
/// This is the fast Fourier transform of Cooley and Tukey with radix 2, decimated in time: M log2(M) operations. The crate rustfft, by
/// which series are fitted, states no bound of its rounding errors.
///
/// **Lemma.** Each value is within (4 log2(M) + 1) 2^(−52) S of the exact one, for the sum S of the sizes of all c_k, if nothing
/// underflows; what underflows adds less than 2^(−1022) for M ≤ 2^22. Proof: before and after each stage, each number is a sum of
/// some of the c_k, times roots of unity, so it is at most the sum s of their sizes. A stage makes a ± wb of two such numbers a and
/// b, with other c_k and the sums p and q of their sizes. Let u = 2^(−53). The root w is within 2√2 u of the exact one, the product
/// within 2√2 u q, and the sum within √2 u (p + q), so that a stage adds less than 7.1 u (p + q) to the errors of a and b, and
/// multiplies those by less than 1 + 7.1 u. By induction the errors after l stages are at most ((1 + 7.1 u)^l − 1) s, which is less
/// than 8 l u s for l ≤ 22. Each underflow adds at most 2^(−1074) to one of fewer than 16 M log2(M) operations.
pub(super) fn values(coefficients: &mut [[f64; 2]], limits: &Limits) -> Result<()> {
    let count = coefficients.len();
    let bits = count.trailing_zeros();
    for k in 0..count {
        let reversed = k.reverse_bits() >> (usize::BITS - bits);
        if k < reversed {
            coefficients.swap(k, reversed);
        }
    }
    let roots = RootsOfUnity::new(count);
    let mut half = 1;
    while half < count {
        limits.check()?;
        let stride = count / (2 * half);
        for block in coefficients.chunks_exact_mut(2 * half) {
            let (first, second) = block.split_at_mut(half);
            for (k, (a, b)) in first.iter_mut().zip(second).enumerate() {
                let [cos, sin] = roots.at(k * stride);
                let [x, y] = [b[0] * cos - b[1] * sin, b[0] * sin + b[1] * cos];
                *b = [a[0] - x, a[1] - y];
                *a = [a[0] + x, a[1] + y];
            }
        }
        half *= 2;
    }
    Ok(())
}

/// The numbers e^(2πik/M) with 0 ≤ k < M/2, each coordinate within 2^(−52).
struct RootsOfUnity {
    /// Those with k < M/4.
    quarter: Vec<[f64; 2]>,
}

impl RootsOfUnity {
    fn new(count: usize) -> Self {
        let turn = UnitBall::<2>::quotient(&Integer::from(1), &Integer::from(count));
        let [cosines, sines] = rotations(Turns::new().at(turn, 0), count / 4 - 1);
        let pairs = cosines.iter().zip(&sines);
        Self {
            quarter: pairs.map(|(c, s)| [c.to_f64(), s.to_f64()]).collect(),
        }
    }

    fn at(&self, k: usize) -> [f64; 2] {
        match self.quarter.get(k) {
            Some(&root) => root,
            None => {
                let [cos, sin] = self.quarter[k - self.quarter.len()];
                [-sin, cos]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Rational, cosine_and_sine, pi};
    use proptest::prelude::*;

    /// The exact value in a direction, to 2^(−100) or better.
    fn by_definition(coefficients: &[[f64; 2]], j: usize) -> [Rational; 2] {
        let exact = |c: f64| Rational::try_from(c).unwrap();
        let (pi, _) = pi(140);
        let exactly = |k: usize| Rational::from(i64::try_from(k).unwrap());
        let turn = &pi * &Rational::from(2) / exactly(coefficients.len());
        let mut sum = [Rational::zero(), Rational::zero()];
        for (k, c) in coefficients.iter().enumerate() {
            let turns = exactly(k * j % coefficients.len());
            let [cos, sin] = cosine_and_sine(&(&turn * &turns), 130);
            let [a, b] = c.map(exact);
            sum[0] = &sum[0] + &(&a * &cos - &b * &sin);
            sum[1] = &sum[1] + &(&a * &sin + &b * &cos);
        }
        sum
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        /// The values are within the bound of those by the definition, for coefficients of all sizes.
        #[test]
        fn values_are_within_their_bound(
            bits in 2u32..7,
            parts in prop::collection::vec(([-1.0f64..1.0, -1.0f64..1.0], -40i32..40), 64),
            j in any::<prop::sample::Index>(),
        ) {
            let count = 1usize << bits;
            let given: Vec<[f64; 2]> = parts[..count]
                .iter()
                .map(|(c, exponent)| c.map(|c| c * f64::powi(2.0, *exponent)))
                .collect();
            let mut found = given.clone();
            values(&mut found, &Limits::none()).unwrap();
            let size: f64 = given.iter().flatten().map(|c| c.abs()).sum();
            let bound = f64::from(4 * bits + 1) * f64::EPSILON * size;
            let bound = Rational::try_from(bound).unwrap();
            let j = j.index(count);
            for (value, exact) in found[j].into_iter().zip(by_definition(&given, j)) {
                let error = Rational::try_from(value).unwrap() - exact;
                prop_assert!(error.abs() <= bound, "{error}");
            }
        }
    }

    #[test]
    fn one_exponential_runs_around_the_circle() {
        let mut values_of_one = vec![[0.0; 2]; 8];
        values_of_one[1] = [1.0, 0.0];
        values(&mut values_of_one, &Limits::none()).unwrap();
        let half = 0.5f64.sqrt();
        let expected = [[1.0, 0.0], [half, half], [0.0, 1.0], [-half, half]];
        for (j, [x, y]) in values_of_one.into_iter().enumerate() {
            let sign = if j < 4 { 1.0 } else { -1.0 };
            let [a, b] = expected[j % 4].map(|c| sign * c);
            assert!((x - a).abs() < 1e-15 && (y - b).abs() < 1e-15, "{x} {y}");
        }
    }
}
