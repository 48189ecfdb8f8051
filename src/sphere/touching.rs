//! A rational direction in which a sum of spherical harmonics is 0 or negative, near one in which it is nearly 0.

use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::shape::HarmonicPair;

/// The largest number of steps of Newton's method.
const STEPS: usize = 40;
/// A step that is shorter than this is the last one.
const SHORT: f64 = 1e-11;
/// Steps for quotients of differences: 2 to this power. The differences are exact.
const DIFFERENCE: i64 = -16;
/// Places are rounded to multiples of 2^-40, so that exact values stay short.
const GRAIN: f64 = 1_099_511_627_776.0;
/// The part of its trace that is added to a matrix of second derivatives, so that it has an inverse where R is 0 along a curve.
const DAMPING: f64 = 1e-6;
/// The simplest coordinates within these distances are tried.
const REACHES: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-9];

/// A rational unit vector at which R ≤ 0, with the value, if one is found near a direction.
///
/// Newton's method goes to a minimum of R in the two coordinates of a stereographic projection, from the point opposite of the nearest
/// axis. Rational coordinates are rational directions there, all of them, so that a zero in a rational direction is found by simple
/// fractions near the minimum. Nothing is found at a zero in another direction.
///
/// # Errors
/// Those of `limits`.
pub(super) fn direction_without_radius(
    pair: &HarmonicPair,
    near: &[Rational; 3],
    limits: &Limits,
) -> Result<Option<([Rational; 3], Rational)>> {
    let chart = Chart::around(near);
    let mut at = chart.coordinates(near);
    for _ in 0..STEPS {
        limits.check()?;
        let Some(step) = newton_step(|at| pair.value(&chart.direction(at)), at) else {
            break;
        };
        at = [0, 1].map(|i| at[i] + step[i]);
        if at.iter().any(|c| !c.is_finite() || c.abs() > 1.0) {
            return Ok(None);
        }
        if step[0].abs().max(step[1].abs()) < SHORT {
            break;
        }
    }
    for reach in REACHES {
        limits.check()?;
        let simple =
            at.map(|c| Rational::simplest_between(&exactly(c - reach), &exactly(c + reach)));
        let direction = chart.direction(&simple);
        let value = pair.value(&direction);
        if value.signum() <= 0 {
            return Ok(Some((direction, value)));
        }
    }
    Ok(None)
}

/// The step of Newton's method to a minimum; `None` if the second derivatives are all 0.
fn newton_step(value: impl Fn(&[Rational; 2]) -> Rational, at: [f64; 2]) -> Option<[f64; 2]> {
    let h = Rational::from_dyadic(1.into(), DIFFERENCE);
    let place = at.map(|c| exactly((c * GRAIN).round() / GRAIN));
    let beside = |i: i64, j: i64| {
        let moved = [i, j].map(|k| &h * &Rational::from(k));
        value(&[&place[0] + &moved[0], &place[1] + &moved[1]])
    };
    let [middle, east, west, north, south] =
        [(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)].map(|(i, j)| beside(i, j));
    let corners = beside(1, 1) - beside(1, -1) - beside(-1, 1) + beside(-1, -1);
    let twice = &middle + &middle;
    let unit = h.to_f64();
    let [g, k] = [&east - &west, &north - &south].map(|d| d.to_f64() / (2.0 * unit));
    let [a, c] = [east + west, north + south].map(|sum| (sum - &twice).to_f64() / (unit * unit));
    let b = corners.to_f64() / (4.0 * unit * unit);
    let damping = DAMPING * (a.abs() + c.abs());
    let (a, c) = (a + damping, c + damping);
    let determinant = a * c - b * b;
    (determinant != 0.0).then(|| [(b * k - c * g) / determinant, (b * g - a * k) / determinant])
}

/// A stereographic projection, from the point opposite of an axis.
struct Chart {
    axis: usize,
    is_negative: bool,
}

impl Chart {
    /// The projection in which the coordinates of a direction are smallest.
    fn around(direction: &[Rational; 3]) -> Self {
        let size = |i: usize| direction[i].abs();
        let axis = (1..3).fold(0, |best, i| if size(i) > size(best) { i } else { best });
        Self {
            axis,
            is_negative: direction[axis].signum() < 0,
        }
    }

    fn coordinates(&self, direction: &[Rational; 3]) -> [f64; 2] {
        let below = direction[self.axis].abs().to_f64() + 1.0;
        [1, 2].map(|i| direction[(self.axis + i) % 3].to_f64() / below)
    }

    /// The unit vector with these coordinates.
    fn direction(&self, [p, q]: &[Rational; 2]) -> [Rational; 3] {
        let square = p * p + q * q;
        let below = Rational::one() + &square;
        let along = (Rational::one() - square) / &below;
        let along = if self.is_negative { -along } else { along };
        let [p, q] = [p, q].map(|c| (c + c) / &below);
        let mut direction = [along, p, q];
        direction.rotate_right(self.axis);
        direction
    }
}

fn exactly(value: f64) -> Rational {
    crate::intervals::rational(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// Coordinates and directions belong to each other.
        #[test]
        fn directions_are_unit_vectors(p in -20i64..21, q in -20i64..21, axis in 0usize..3, is_negative: bool) {
            let chart = Chart { axis, is_negative };
            let at = [p, q].map(|c| Rational::new(c, 30).unwrap());
            let direction = chart.direction(&at);
            let squares = direction.iter().map(|c| c * c);
            prop_assert_eq!(squares.fold(Rational::zero(), |a, b| a + b), Rational::one());
            for (a, b) in chart.coordinates(&direction).iter().zip(&at) {
                prop_assert!((a - b.to_f64()).abs() < 1e-15);
            }
        }
    }
}
