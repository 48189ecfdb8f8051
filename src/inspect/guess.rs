//! Points of a curve in doubles, from which the search for the nearest point begins.

use super::arcs::Waveform;
use crate::exact::Rational;
use crate::shape::{CurveInDoubles, ParametricCurve};

/// The curve in doubles without certificate, over an angle τ from −π to π with s = tan(τ/2).
#[derive(Debug)]
pub(super) enum Guess<const N: usize> {
    /// Fourier series Σ a_n cos nτ + b_n sin nτ of the coordinates: the coefficients by n.
    Series([Vec<[f64; 2]>; N]),
    /// Rational functions of s.
    Functions(CurveInDoubles<N>),
}

impl<const N: usize> Guess<N> {
    /// The curve of rational functions.
    pub(super) fn of_functions(curve: &ParametricCurve<N>) -> Self {
        Self::Functions(curve.in_doubles())
    }

    /// The curve of the series less the center.
    pub(super) fn of_series(series: &[Waveform; N], center: &[Rational; N]) -> Self {
        Self::Series(std::array::from_fn(|i| {
            let [cos, sin] = &series[i];
            let pairs = cos.iter().zip(sin);
            let mut all: Vec<[f64; 2]> = pairs.map(|(a, b)| [a.to_f64(), b.to_f64()]).collect();
            if let (Some([first, _]), Some(constant)) = (all.first_mut(), cos.first()) {
                *first = (constant - &center[i]).to_f64();
            }
            all
        }))
    }

    /// The point at the angle τ.
    pub(super) fn at(&self, angle: f64) -> [f64; N] {
        match self {
            Self::Series(series) => {
                let (sin, cos) = angle.sin_cos();
                // cos nτ and sin nτ for n = 0, 1, … are computed by rotations. They may be slightly wrong, as this is only a
                // guess; the function is called often.
                series.each_ref().map(|series| {
                    let (mut turned, mut x) = ([1.0, 0.0], 0.0);
                    for [a, b] in series {
                        x += a * turned[0] + b * turned[1];
                        turned = [
                            turned[0] * cos - turned[1] * sin,
                            turned[0] * sin + turned[1] * cos,
                        ];
                    }
                    x
                })
            }
            Self::Functions(functions) => {
                let (sin, cos) = (angle / 2.0).sin_cos();
                functions.at([sin, cos])
            }
        }
    }
}
