//! A sum of spherical harmonics as a sum of harmonics of θ and φ, with its derivatives in doubles.

use pulp::NullaryFnOnce;
use smallvec::SmallVec;

use crate::bigint::Machine;
use crate::exact::Rational;
use crate::intervals::interval::UNIT;
use crate::shape::WaveCoefficients;

/// The number of coefficients that are summed at once.
const LANES: usize = 4;
/// Covers the rounding errors of bounds that are themselves sums and products of at most 2^20 positive doubles.
pub(super) const ABOVE: f64 = 1.0 + 1e-9;
/// Orders of derivatives are below this number.
pub(super) const ORDERS: usize = 6;

/// The cosine and the sine of an angle.
pub(super) type Turn = [f64; 2];

/// The radius `R(θ, φ) = Σ (a_mn cos mθ + b_mn sin mθ) w_mn(φ)` for m, n ≤ L, where w_mn(φ) is cos nφ for even m and sin nφ for odd
/// m. Every polynomial on the sphere is such a sum, also at the poles.
#[derive(Debug)]
pub(super) struct Waves {
    degree: usize,
    machine: Machine,
    /// The coefficients for even and for odd m. A block has those of cos mθ, sin mθ, cos (m + 2)θ and sin (m + 2)θ for each n.
    blocks: [Vec<[f64; LANES]>; 2],
    /// The bounds E_k of the lemma at [`Self::derivatives`].
    errors: [f64; ORDERS],
    /// The sums Σ (|a_mn| + |b_mn|) (m + n)^k.
    sizes: [f64; ORDERS],
}

impl Waves {
    /// The sum with these coefficients, in units in which the sum of their sizes is at most 1; `scale` converts into units.
    pub(super) fn new(degree: usize, coefficients: &WaveCoefficients, scale: &Rational) -> Self {
        let blocks = [0, 1].map(|parity| {
            let count = if degree < parity {
                0
            } else {
                (degree - parity) / LANES + 1
            };
            vec![[0.0; LANES]; count * (degree + 1)]
        });
        let mut waves = Self {
            degree,
            machine: Machine::this(),
            blocks,
            errors: [0.0; ORDERS],
            sizes: [0.0; ORDERS],
        };
        for (m, is_sine, n, c) in coefficients {
            let (m, n) = (*m, *n);
            let value = (c * scale).to_f64();
            let (block, lane) = (m / LANES, m % LANES / 2 * 2 + usize::from(*is_sine));
            waves.blocks[m % 2][block * (degree + 1) + n][lane] = value;
            let order = as_f64(m + n);
            let roundings = 8.0 * order + 3.0 * as_f64(degree + 16);
            let mut size = value.abs();
            for k in 0..ORDERS {
                waves.sizes[k] += size;
                waves.errors[k] += size * roundings * (UNIT * ABOVE);
                size *= order;
            }
        }
        for list in [&mut waves.errors, &mut waves.sizes] {
            for bound in list {
                *bound = *bound * ABOVE + TINY;
            }
        }
        waves
    }

    /// The bounds E_k of the errors of derivatives of order k.
    pub(super) fn errors(&self) -> &[f64; ORDERS] {
        &self.errors
    }

    /// Bounds of the derivatives of order k.
    pub(super) fn sizes(&self) -> &[f64; ORDERS] {
        &self.sizes
    }

    /// The derivatives ∂^(i+j)R/∂θ^i ∂φ^j for i + j < N, at \[i\]\[j\].
    ///
    /// **Lemma 1.** Let the length of each of the pairs `theta` and `phi` be within 4u of 1, for u = `UNIT`. Then each derivative of order
    /// k is within E_k = Σ (|a_mn| + |b_mn|) (m + n)^k (8(m + n) + 3(L + 16)) u of the exact one at the directions of the pairs.
    ///
    /// Proof. The n-th power of a pair as a complex number is a product of n − 1 computed products, each wrong by at most √5 u of its
    /// size, and its length is within 4nu of 1 besides: all that is less than 8nu. Every product of a coefficient and two waves is
    /// rounded once for the coefficient, at most five times for the factors m^i n^j, in two products, and in at most L + 1 sums over n
    /// and L/2 + 8 sums over m: fewer than 3(L + 15) times, and the rest covers the products of these small numbers.
    ///
    /// Law: `derivatives_are_those_of_the_radius`.
    pub(super) fn derivatives<const N: usize>(&self, theta: Turn, phi: Turn) -> [[f64; N]; N] {
        self.machine.dispatch(Derivatives::<N> {
            waves: self,
            theta,
            phi,
        })
    }
}

/// The computation of [`Waves::derivatives`], which is compiled for the instructions of the machine.
struct Derivatives<'a, const N: usize> {
    waves: &'a Waves,
    theta: Turn,
    phi: Turn,
}

impl<const N: usize> NullaryFnOnce for Derivatives<'_, N> {
    type Output = [[f64; N]; N];

    #[inline(always)]
    fn call(self) -> [[f64; N]; N] {
        let Self { waves, theta, phi } = self;
        // The derivatives of cos nφ and of sin nφ, for all n.
        let mut of_phi: [SmallVec<[[f64; N]; 32]>; 2] = [SmallVec::new(), SmallVec::new()];
        let mut power = [1.0, 0.0];
        for n in 0..=waves.degree {
            let n = as_f64(n);
            let starts = [[power[0], -power[1]], [power[1], power[0]]];
            for (list, start) in of_phi.iter_mut().zip(starts) {
                let [mut value, mut turned] = start;
                let mut row = [0.0; N];
                for x in &mut row {
                    *x = value;
                    (value, turned) = (n * turned, -n * value);
                }
                list.push(row);
            }
            power = times(power, phi);
        }
        let mut found = [[[0.0; LANES]; N]; N];
        // The power m of the first pair of a block, and the square by which the next pair is more.
        let square = times(theta, theta);
        let fourth = times(square, square);
        for (parity, start) in [[1.0, 0.0], theta].into_iter().enumerate() {
            let mut power = start;
            let blocks = waves.blocks[parity].chunks_exact(waves.degree + 1);
            for (block, rows) in blocks.enumerate() {
                let mut sums = [[0.0; LANES]; N];
                for (row, wave) in rows.iter().zip(&of_phi[parity]) {
                    for (sum, wave) in sums.iter_mut().zip(wave) {
                        add_products(sum, row, &[*wave; LANES]);
                    }
                }
                let next = times(power, square);
                let m = [0, 2].map(|more| as_f64(LANES * block + parity + more));
                let mut wave = [power[0], power[1], next[0], next[1]];
                for (i, list) in found.iter_mut().enumerate() {
                    for (found, sum) in list.iter_mut().zip(&sums).take(N - i) {
                        add_products(found, sum, &wave);
                    }
                    wave = [
                        -m[0] * wave[1],
                        m[0] * wave[0],
                        -m[1] * wave[3],
                        m[1] * wave[2],
                    ];
                }
                power = times(power, fourth);
            }
        }
        found.map(|row| row.map(|[a, b, c, d]| (a + b) + (c + d)))
    }
}

/// Covers numbers below the range of doubles in sums of numbers of size 1.
const TINY: f64 = f64::from_bits((1023 - 100) << 52);

/// Adds the products of the numbers in equal lanes.
#[inline(always)]
fn add_products(
    [a, b, c, d]: &mut [f64; LANES],
    [p, q, r, s]: &[f64; LANES],
    [t, u, v, w]: &[f64; LANES],
) {
    *a += p * t;
    *b += q * u;
    *c += r * v;
    *d += s * w;
}

/// The product of two complex numbers.
#[inline(always)]
fn times([a, b]: Turn, [c, d]: Turn) -> Turn {
    [a * c - b * d, a * d + b * c]
}

#[inline(always)]
#[expect(clippy::cast_precision_loss, reason = "degrees are small")]
pub(super) fn as_f64(n: usize) -> f64 {
    n as f64
}
