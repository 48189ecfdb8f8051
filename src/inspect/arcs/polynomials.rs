//! A closed curve as arcs, each with Taylor polynomials of its coordinates and one proved bound of their errors.

use std::f64::consts::PI;

use super::scaled::Scaled;
use super::waves::{BITS, Waves};
use crate::intervals::interval::{UNIT, relative_error};

/// The number of arcs for each harmonic.
const ARCS_PER_HARMONIC: usize = 13;
/// The smallest number of arcs.
const FEWEST_ARCS: usize = 64;
/// The remainder of the Taylor polynomials is at most this part, 2^(−57), of the sum of the coefficients. With
/// [`ARCS_PER_HARMONIC`] their degree is then at most 12, because (π/13)^13/13! < 2^(−59).
const REMAINDER: f64 = f64::EPSILON / 32.0;
/// The largest degree.
const LARGEST_DEGREE: usize = 12;
/// Covers the rounding errors of bounds that are themselves sums and products of at most 2^20 positive doubles.
const ABOVE: f64 = 1.0 + 1e-9;

/// A curve C(t) cut into K arcs. With h = π/K the j-th arc is the curve over the parameters (2j + 1)h + hu for −1 ≤ u ≤ 1.
///
/// **Lemma 2.** Let c_n be the sum of the sizes of all coefficients of the n-th harmonic, in units such that Σ c_n ≤ 1, and Q_k
/// = Σ (nh)^k c_n/k!. Let c(u) be the exact value of the polynomial of an arc with its doubles as coefficients. Then |C − c| is
/// at most the sum of
///
/// 1. N(H + 4) 2^(−62), for N coordinates and H harmonics: the middle of the arc is a sum of products of integers. Each of the
///    2H + 1 coefficients of a coordinate is rounded by at most 2^(−63), and each cosine or sine is wrong by at most 2·2^(−62)
///    (Lemma 1). The sum is rounded to two doubles, which is wrong by less than 2^(−100).
/// 2. ε_k Q_k for 1 ≤ k ≤ D with ε_k = `relative_error(H + 4k + 8)`: the k-th coefficient is a sum of 2H products of the
///    doubles nearest to the coefficients, of doubles that are wrong by at most two roundings of 1 for the cosines and sines,
///    and of (nh)^k/k!, computed with 4k roundings. Each product is rounded at most H + 4k + 8 times (the lemma at
///    [`relative_error`]).
/// 3. Q_(D+1), the remainder of a Taylor polynomial of degree D.
///
/// Laws: `polynomials_are_near_the_curve`, and those of the search.
#[derive(Debug)]
pub(super) struct Polynomials<const N: usize> {
    degree: usize,
    /// For each arc D + 2 points: the middle as the sum of two, then the coefficients of u, u², …, u^D.
    coefficients: Vec<[f64; N]>,
    /// For each arc a bound of |c'''|/6.
    thirds: Vec<f64>,
    /// A bound of |C − c| and of the rounding errors of an expansion, as Lemma 3 says.
    error: f64,
}

/// The Taylor polynomial of degree two of one arc, at one place, less a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expansion<const N: usize> {
    /// The place u.
    pub(super) at: f64,
    /// c(u) − p
    pub(super) value: [f64; N],
    /// c'(u)
    pub(super) slope: [f64; N],
    /// c''(u)/2
    pub(super) bend: [f64; N],
}

impl<const N: usize> Polynomials<N> {
    pub(super) fn new(series: &Scaled<N>) -> Self {
        let harmonics = series.harmonics();
        let arcs = (ARCS_PER_HARMONIC * harmonics)
            .next_power_of_two()
            .max(FEWEST_ARCS);
        let step = PI / as_f64(arcs);
        // (nh)^k/k!, by n.
        let powers: Vec<[f64; LARGEST_DEGREE + 2]> = (0..=harmonics)
            .map(|n| {
                let mut power = [1.0; LARGEST_DEGREE + 2];
                for k in 1..power.len() {
                    power[k] = power[k - 1] * (as_f64(n) * step / as_f64(k));
                }
                power
            })
            .collect();
        let sizes = |k: usize| {
            let terms = (0..=harmonics).map(|n| powers[n][k] * series.size(n));
            terms.sum::<f64>() * ABOVE
        };
        let sizes: [f64; LARGEST_DEGREE + 2] = std::array::from_fn(sizes);
        let degree = (2..LARGEST_DEGREE)
            .find(|k| sizes[k + 1] <= REMAINDER * sizes[0])
            .unwrap_or(LARGEST_DEGREE);

        let waves = Waves::new(arcs);
        let mut coefficients = Vec::with_capacity(arcs * (degree + 2));
        let mut thirds = Vec::with_capacity(arcs);
        for j in 0..arcs {
            let mut middle = [0i128; N];
            let mut rows = [[0.0; N]; LARGEST_DEGREE + 1];
            for (n, power) in powers.iter().enumerate() {
                let wave = waves.at(n * (2 * j + 1));
                let [cos, sin] = wave.map(|c| from_units(c.into(), BITS));
                for i in 0..N {
                    let fixed = series.fixed(i, n);
                    middle[i] += product(fixed[0], wave[0]) + product(fixed[1], wave[1]);
                    let [a, b] = series.doubles(i, n);
                    // Derivatives by nt of a cos nt + b sin nt, up to signs.
                    let derivatives = [a * cos + b * sin, b * cos - a * sin];
                    for k in 1..=degree {
                        rows[k][i] += power[k] * derivatives[k % 2];
                    }
                }
            }
            for (k, row) in rows.iter_mut().enumerate() {
                if k % 4 >= 2 {
                    *row = row.map(|x| -x);
                }
            }
            let [high, low] = two_doubles(middle);
            coefficients.extend([high, low]);
            coefficients.extend_from_slice(&rows[1..=degree]);
            let third = (3..=degree).map(|k| choose(k, 3) * length(&rows[k]));
            thirds.push(third.sum::<f64>() * ABOVE);
        }
        let mut polynomials = Self {
            degree,
            coefficients,
            thirds,
            error: 0.0,
        };
        polynomials.error = polynomials.error_of(harmonics, &sizes);
        polynomials
    }

    /// The bound of Lemmas 2 and 3.
    fn error_of(&self, harmonics: usize, sizes: &[f64]) -> f64 {
        let degree = self.degree;
        let middle = as_f64(N * (harmonics + 4)) * from_units(1, BITS);
        let remainder = sizes[degree + 1];
        let of_terms = (1..=degree).map(|k| {
            let expansion = 1.0 + 2.0 * choose(k, 1) + 4.0 * choose(k, 2);
            let relative = relative_error(harmonics + 4 * k + 8)
                + relative_error(2 * k + 4) * expansion
                + 4.0 * UNIT;
            relative * sizes[k]
        });
        (middle + remainder + of_terms.sum::<f64>()) * ABOVE + TINY
    }

    /// The number of arcs, a power of two.
    pub(super) fn len(&self) -> usize {
        self.thirds.len()
    }

    /// The bound of Lemmas 2 and 3.
    pub(super) fn error(&self) -> f64 {
        self.error
    }

    /// The parameter of the curve at the place u of an arc.
    pub(super) fn parameter(&self, arc: usize, u: f64) -> f64 {
        (as_f64(2 * arc + 1) + u) * (PI / as_f64(self.len()))
    }

    /// A bound of |c'''|/6 on an arc.
    pub(super) fn third(&self, arc: usize) -> f64 {
        self.thirds[arc]
    }

    pub(super) fn of(&self, arc: usize) -> &[[f64; N]] {
        let stride = self.degree + 2;
        &self.coefficients[arc * stride..(arc + 1) * stride]
    }

    /// A box that holds an arc: its middle, rounded to doubles, and half its sides.
    pub(super) fn extent(&self, arc: usize) -> ([f64; N], [f64; N]) {
        let all = self.of(arc);
        let half = std::array::from_fn(|i| {
            let sum: f64 = all[2..].iter().map(|c| c[i].abs()).sum();
            // The second double of the middle is at most `UNIT` in size.
            sum * ABOVE + self.error + UNIT
        });
        (all[0], half)
    }

    /// The expansion at the middle of an arc.
    pub(super) fn at_middle(&self, arc: usize, p: &[f64; N]) -> Expansion<N> {
        let all = self.of(arc);
        Expansion {
            at: 0.0,
            value: std::array::from_fn(|i| (all[0][i] - p[i]) + all[1][i]),
            slope: all[2],
            bend: all[3],
        }
    }

    /// The expansion at the place u of an arc, |u| ≤ 1.
    ///
    /// **Lemma 3.** Let D, T and B be the computed value, slope and bend. For v with |u + v| ≤ 1
    ///
    /// C(u + v) − p = D + Tv + Bv² + κ + ω with |κ| ≤ |v|³ max |c'''|/6 and |ω| ≤ `error` + 4·2^(−53)|D|.
    ///
    /// Proof. κ is the remainder of the expansion of c, and Lemma 2 bounds C − c. By Horner's rule the products with the k-th
    /// coefficient in the value of c less its middle, in its slope and in its bend are rounded at most 2k + 4 times. So these
    /// are wrong by at most ε Q_k, ε k Q_k and ε Q_k k(k − 1)/2 with ε = `relative_error(2k + 4)`, and |v| ≤ 2. The value is
    /// ((high − p) + low) + rest with three roundings of its partial sums, which are at most |D| + ΣQ_k + 2·2^(−53) in size, up
    /// to a factor of 1 + 4·2^(−53). Numbers below 2^(−1022) are wrong by less than 2^(−1000), which [`TINY`] covers.
    pub(super) fn at(&self, arc: usize, u: f64, p: &[f64; N]) -> Expansion<N> {
        let all = self.of(arc);
        let [mut value, mut slope, mut bend] = [[0.0; N]; 3];
        for c in all[2..].iter().rev() {
            for i in 0..N {
                bend[i] = bend[i] * u + slope[i];
                slope[i] = slope[i] * u + value[i];
                value[i] = value[i] * u + c[i];
            }
        }
        for i in 0..N {
            bend[i] = bend[i] * u + slope[i];
            slope[i] = slope[i] * u + value[i];
            value[i] = ((all[0][i] - p[i]) + all[1][i]) + value[i] * u;
        }
        Expansion {
            at: u,
            value,
            slope,
            bend,
        }
    }

    /// The point c(u) in doubles, for output.
    pub(super) fn point(&self, arc: usize, u: f64) -> [f64; N] {
        self.at(arc, u, &[0.0; N]).value
    }
}

/// Covers the errors of Lemmas 2 and 3 that are far below the roundings of a curve of size 1.
const TINY: f64 = f64::from_bits((1023 - 100) << 52);

/// The product of two numbers of at most 2^62.
fn product(a: i64, b: i64) -> i128 {
    i128::from(a) * i128::from(b)
}

/// The doubles h and l with h + l near the sums, which are in units of 2^(−124).
#[expect(
    clippy::cast_possible_truncation,
    reason = "a sum that is at most 2^125 was rounded to a double"
)]
fn two_doubles<const N: usize>(sums: [i128; N]) -> [[f64; N]; 2] {
    let high = sums.map(|sum| from_units(sum, 2 * BITS));
    let unit = from_units(1, 2 * BITS);
    let low = std::array::from_fn(|i| from_units(sums[i] - (high[i] / unit) as i128, 2 * BITS));
    [high, low]
}

/// The double nearest to a number in units of 2^(−bits).
#[expect(
    clippy::cast_precision_loss,
    reason = "the number is rounded to the nearest double"
)]
fn from_units(units: i128, bits: u32) -> f64 {
    units as f64 / (1i128 << bits) as f64
}

/// The binomial coefficient, for small numbers.
fn choose(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |c, i| c * as_f64(n.saturating_sub(i)) / as_f64(i + 1))
}

/// A bound of the length of a vector, up to rounding: the sum of the sizes of its coordinates.
pub(super) fn length(v: &[f64]) -> f64 {
    v.iter().map(|x| x.abs()).sum()
}

#[expect(clippy::cast_precision_loss, reason = "counts are small")]
fn as_f64(n: usize) -> f64 {
    n as f64
}
