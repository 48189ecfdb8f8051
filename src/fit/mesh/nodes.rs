//! The nodes of the quadrature over the sphere.

use std::f64::consts::{PI, TAU};

/// The nodes z and the weights of Gauss and Legendre on [−1, 1], by Newton's method; the weights add up to 2.
pub(super) fn gauss_legendre(count: usize) -> Vec<[f64; 2]> {
    let n = as_f64(count);
    let node = |i: usize| {
        let mut z = (PI * (as_f64(i) + 0.75) / (n + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..100 {
            let (mut before, mut last) = (0.0, 1.0);
            for k in 0..count {
                let k = as_f64(k);
                (before, last) = (last, ((2.0 * k + 1.0) * z * last - k * before) / (k + 1.0));
            }
            slope = n * (z * last - before) / (z * z - 1.0);
            let step = last / slope;
            z -= step;
            if step.abs() < 1e-15 {
                break;
            }
        }
        [z, 2.0 / ((1.0 - z * z) * slope * slope)]
    };
    (0..count).map(node).collect()
}

/// The cosines and sines of equal angles.
pub(super) fn turns(count: usize) -> Vec<[f64; 2]> {
    (0..count)
        .map(|j| {
            let (s, c) = (TAU * as_f64(j) / as_f64(count)).sin_cos();
            [c, s]
        })
        .collect()
}

#[expect(clippy::cast_precision_loss, reason = "degrees and counts are small")]
pub(super) fn as_f64(n: usize) -> f64 {
    n as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadrature_is_exact_for_polynomials() {
        let nodes = gauss_legendre(7);
        for power in 0..14 {
            let sum: f64 = nodes.iter().map(|[z, w]| w * z.powi(power)).sum();
            let exact = if power % 2 == 0 {
                2.0 / f64::from(power + 1)
            } else {
                0.0
            };
            assert!((sum - exact).abs() < 1e-14, "{power}: {sum}");
        }
    }
}
