//! Sums of waves over many angles, and values of series at them.

use rustfft::num_complex::Complex;

use crate::parallel;

/// So many angles are summed together. The number is fixed, so that sums do not depend on the number of threads.
const TOGETHER: usize = 4096;

/// The sums Σ_i v_i e^(inθ_i) for n = 0 … `harmonics`, for D numbers v_i at each angle. Cost: O(D N) for each angle.
pub(super) fn wave_sums<const D: usize>(
    angles: &[f64],
    values: impl Fn(usize) -> [f64; D] + Sync,
    harmonics: usize,
) -> Vec<[Complex<f64>; D]> {
    let part = |(part, angles): &(usize, &[f64])| {
        let mut sums = vec![[Complex::default(); D]; harmonics + 1];
        for (k, &theta) in angles.iter().enumerate() {
            let value = values(part * TOGETHER + k);
            let step = Complex::from_polar(1.0, theta);
            let mut wave = Complex::new(1.0, 0.0);
            for sum in &mut sums {
                for d in 0..D {
                    sum[d] += wave * value[d];
                }
                wave *= step;
            }
        }
        sums
    };
    let parts: Vec<(usize, &[f64])> = angles.chunks(TOGETHER).enumerate().collect();
    let parts = parallel::map(&parts, part);
    let mut all = vec![[Complex::default(); D]; harmonics + 1];
    for sums in parts {
        for (all, sum) in all.iter_mut().zip(sums) {
            for d in 0..D {
                all[d] += sum[d];
            }
        }
    }
    all
}

/// The values Σ_n (a_n cos nθ + b_n sin nθ) of D series at every angle, from the numbers a_n + i b_n.
pub(super) fn values_at<const D: usize>(
    angles: &[f64],
    series: &[[Complex<f64>; D]],
) -> Vec<[f64; D]> {
    let at = |theta: &f64| {
        let step = Complex::from_polar(1.0, *theta);
        let mut wave = Complex::new(1.0, 0.0);
        let mut value = [0.0; D];
        for c in series {
            for d in 0..D {
                value[d] += c[d].re * wave.re + c[d].im * wave.im;
            }
            wave *= step;
        }
        value
    };
    parallel::map(angles, at)
}
