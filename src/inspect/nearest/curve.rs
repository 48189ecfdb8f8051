//! The foot of a point on a parametric curve.

use super::{length_of, unit};
use crate::exact::{Dyadic, Rational};
use crate::inspect::curve::CurveInspector;
use crate::inspect::guess::Guess;
use crate::intervals::rational;
use crate::poly::{IntegerPolynomial, RationalFunction, numerator_at};

use malachite::Integer;
use malachite::base::polynomial::Derivative;

/// The largest number of steps of Newton's method in doubles.
const STEPS: usize = 30;
/// The largest number of steps of Newton's method in exact arithmetic.
const EXACT_STEPS: usize = 8;
/// Newton's method in exact arithmetic ends with a step of the parameter of this size.
const NEAR: f64 = 1e-40;
/// s = 2^FAR stands for s = ∞.
const FAR: i64 = 200;
/// Where the derivative by the angle τ, with s = tan(τ/2), is less than this part of the curve's size, the curve is singular.
const SINGULAR: f64 = 1e-7;

/// A foot on a curve, in original coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CurveFoot<const N: usize> {
    pub(crate) point: [f64; N],
    /// The unit tangent, along which the parameter grows; `None` at a singular point.
    pub(crate) tangent: Option<[f64; N]>,
}

impl<const N: usize> CurveInspector<N> {
    /// The foot of a point.
    pub(crate) fn foot(&self, point: &[Rational; N]) -> Option<CurveFoot<N>> {
        let relative: [Rational; N] = std::array::from_fn(|i| &point[i] - &self.center()[i]);
        let near = relative.each_ref().map(Rational::to_f64);
        let start = self
            .nearest_point(point.each_ref().map(Rational::to_f64))
            .map(|found| found.at);
        let [at, derivative] = match (self.guess(), start) {
            (Guess::Series(series), Some(start)) => in_doubles(series, start, &near)?,
            _ => self.exactly(&relative, start)?,
        };
        let speed = length_of(&derivative);
        let size = self.size_near(&at);
        Some(CurveFoot {
            point: std::array::from_fn(|i| (rational(at[i]) + &self.center()[i]).to_f64()),
            tangent: (speed > SINGULAR * size)
                .then(|| unit(derivative))
                .flatten(),
        })
    }

    /// The foot, relative to the center, and the derivative by τ there, with a parameter that is refined in exact arithmetic.
    fn exactly(&self, relative: &[Rational; N], start: Option<f64>) -> Option<[[f64; N]; 2]> {
        let (distance, found) = self.best_parameter(relative, start);
        let mut s = found.unwrap_or_else(|| Dyadic::new(Integer::from(1), FAR));
        let mut best = distance.at(&s)?;
        for _ in 0..EXACT_STEPS {
            let Some(next) = distance
                .newton_step(&s)
                .map(|next| super::super::curve::cut(&next))
            else {
                break;
            };
            let moved = (next.to_rational() - s.to_rational()).abs().to_f64();
            match distance.at(&next) {
                Some(value) if value <= best => (s, best) = (next, value),
                _ => break,
            }
            if moved < NEAR {
                break;
            }
        }
        // ds/dτ = (1 + s²)/2
        let exact = s.to_rational();
        let rate = (Rational::one() + &exact * &exact) / Rational::from(2);
        let mut at = [0.0; N];
        let mut derivative = [0.0; N];
        for (i, f) in self.coordinates().iter().enumerate() {
            let (value, slope) = value_and_slope(f, &s)?;
            at[i] = value.to_f64();
            derivative[i] = (slope * &rate).to_f64();
        }
        Some([at, derivative])
    }
}

/// The value and the derivative of P/Q at s; `None` at a pole.
fn value_and_slope(f: &RationalFunction, s: &Dyadic) -> Option<(Rational, Rational)> {
    let at = |f: &IntegerPolynomial| {
        let lowered = s.exponent().min(0).unsigned_abs();
        let degree = f.coefficients_asc().len().saturating_sub(1) as u64;
        let scale = Integer::from(1) << (lowered * degree);
        Rational::whole(numerator_at(f, s)) / Rational::whole(scale)
    };
    let [p, q] = [f.numerator(), f.denominator()];
    let [p1, q1] = [p, q].map(|f| at(&f.derivative()));
    let [p, q] = [at(p), at(q)];
    let below = q.recip()?;
    let value = &p * &below;
    Some((value.clone(), (p1 - value * q1) * below))
}

/// A local minimum of the distance near an angle, and the derivative there, by Newton's method for the coordinates as Fourier series.
fn in_doubles<const N: usize>(
    series: &[Vec<[f64; 2]>; N],
    start: f64,
    point: &[f64; N],
) -> Option<[[f64; N]; 2]> {
    let mut angle = start;
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let [x, first, second] = expansion(series, angle);
        let (mut slope, mut bend) = (0.0, 0.0);
        for i in 0..N {
            let away = x[i] - point[i];
            slope += away * first[i];
            bend += first[i] * first[i] + away * second[i];
        }
        let step = -slope / bend;
        // Near a minimum each step is shorter than the one before; if it is not, only rounding is left, or it is no minimum.
        if !step.is_finite() || bend <= 0.0 || step.abs() >= last {
            break;
        }
        angle += step;
        last = step.abs();
    }
    let [x, first, _] = expansion(series, angle);
    Some([x, first])
}

/// The point of a curve at an angle, and the first and the second derivative.
#[expect(
    clippy::cast_precision_loss,
    reason = "the number of harmonics is small"
)]
fn expansion<const N: usize>(series: &[Vec<[f64; 2]>; N], angle: f64) -> [[f64; N]; 3] {
    let mut found = [[0.0; N]; 3];
    let longest = series.iter().map(Vec::len).max().unwrap_or(0);
    for n in (0..longest).rev() {
        let order = n as f64;
        let (sin, cos) = (order * angle).sin_cos();
        for (i, list) in series.iter().enumerate() {
            let Some([a, b]) = list.get(n) else {
                continue;
            };
            let value = a * cos + b * sin;
            found[0][i] += value;
            found[1][i] += order * (b * cos - a * sin);
            found[2][i] -= order * order * value;
        }
    }
    found
}
