//! Exact rational directions in space, near given spherical angles.

use malachite::Integer;

use super::direction::Direction;
use super::unit_vector::IntegerVector;
use crate::exact::Rational;

/// The golden angle in turns is 1 − 1/φ = (3 − √5)/2.
const GOLDEN_TURN: f64 = 0.381_966_011_250_105_15;

/// An exact unit vector `(u, v, w)` next to the spherical angles (θ, φ):
/// `u = sin φ cos θ`, `v = sin φ sin θ`, `w = cos φ`, with φ the polar angle from the z axis.
///
/// Both angles are replaced by exact rational directions ([`Direction`]), so the multiples of a right angle are exact,
/// all directions with the same θ lie in one plane through the z axis, and along every one of them
/// the distance R is a rational multiple of the coordinates.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::sample::{Direction, SpaceDirection, UnitVector};
/// let up = SpaceDirection::new(Direction::from_radians(0.3), Direction::from_radians(0.0));
/// assert_eq!(up.components(), [0, 0, 1].map(Rational::from));
/// let d = SpaceDirection::new(Direction::from_radians(0.3), Direction::from_radians(1.1));
/// let [u, v, w] = d.components();
/// assert_eq!(&u * &u + &v * &v + &w * &w, Rational::one());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceDirection {
    theta: Direction,
    phi: Direction,
}

impl SpaceDirection {
    /// The direction with azimuth `theta` and polar angle `phi`.
    #[must_use]
    pub fn new(theta: Direction, phi: Direction) -> Self {
        Self { theta, phi }
    }

    /// The azimuth θ, from +x towards +y.
    #[must_use]
    pub fn theta(&self) -> &Direction {
        &self.theta
    }

    /// The polar angle φ, from +z.
    #[must_use]
    pub fn phi(&self) -> &Direction {
        &self.phi
    }

    /// `count` directions spread evenly over the whole sphere: the Fibonacci grid
    /// `cos φ = 1 − (2k + 1)/count`, θ = k golden angles.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "nominal angles are doubles")]
    pub fn fibonacci(count: usize) -> Vec<Self> {
        let at = |k: usize| {
            let height = 1.0 - (2.0 * k as f64 + 1.0) / count as f64;
            let turn = (k as f64 * GOLDEN_TURN).fract();
            let theta = Direction::from_radians(turn * std::f64::consts::TAU);
            Self::new(theta, Direction::from_radians(height.acos()))
        };
        (0..count).map(at).collect()
    }

    /// The directions of a grid: `thetas` azimuths around the circle, each with the polar angles 180° k/`phis` for k = 1 …
    /// `phis` − 1; and the pole φ = 0. The other pole is on the same line as that one. The order is by θ, then by φ.
    #[must_use]
    pub fn grid(thetas: usize, phis: usize) -> Vec<Self> {
        let steps = Rational::whole(Integer::from(phis.max(1)));
        let polar = |k: usize| {
            let half_turns = Rational::whole(Integer::from(k)) / &steps;
            Direction::from_degrees(&(half_turns * Rational::from(180)))
        };
        let pole = Self::new(Direction::from_radians(0.0), Direction::from_radians(0.0));
        let polar: Vec<Direction> = (1..phis).map(polar).collect();
        let around = Direction::around(thetas).into_iter();
        let others = around.flat_map(|theta| {
            let along = polar.iter().cloned();
            let meridian = along.map(|phi| Self::new(theta.clone(), phi));
            meridian.collect::<Vec<_>>()
        });
        std::iter::once(pole).chain(others).collect()
    }
}

impl IntegerVector<3> for SpaceDirection {
    fn over_common_denominator(&self) -> ([Integer; 3], Integer) {
        let ([a, b], c) = self.theta.over_common_denominator();
        let ([cos, sin], w) = self.phi.over_common_denominator();
        ([a * &sin, b * sin, cos * &c], w * c)
    }
}

#[cfg(test)]
#[expect(clippy::cast_precision_loss, reason = "small numbers")]
mod tests {
    use super::*;
    use crate::sample::{NominalAngles, UnitVector};
    use proptest::prelude::*;

    #[test]
    fn grids_hold_what_they_say() {
        assert_eq!(SpaceDirection::grid(6, 4).len(), 1 + 6 * 3);
        // The directions are in the order of θ, then φ; the pole is the first.
        let angles = SpaceDirection::grid(6, 4);
        let angles: Vec<_> = angles.iter().map(NominalAngles::angles).collect();
        assert_eq!(angles[0], (0.0, Some(0.0)));
        for (index, (theta, phi)) in angles[1..].iter().enumerate() {
            let [sixth, quarter] = [index / 3, index % 3 + 1].map(|k| k as f64);
            assert!((theta - sixth * std::f64::consts::FRAC_PI_3).abs() < 1e-14);
            let phi = phi.expect("a direction in space has a polar angle");
            assert!((phi - quarter * std::f64::consts::FRAC_PI_4).abs() < 1e-14);
        }
        let spread = SpaceDirection::fibonacci(50);
        assert_eq!(spread.len(), 50);
        // The difference is the golden angle.
        assert!((spread[1].theta().theta() - 2.399_963_229_728_653).abs() < 1e-14);
        for (k, direction) in spread.iter().enumerate() {
            let height = direction.components()[2].to_f64();
            assert!((height - (1.0 - (2.0 * k as f64 + 1.0) / 50.0)).abs() < 1e-14);
        }
        let sum = spread.iter().fold([0.0; 3], |sum: [f64; 3], d| {
            let c = d.components();
            std::array::from_fn(|i| sum[i] + c[i].to_f64())
        });
        assert!(sum.iter().all(|s| s.abs() < 1.0), "{sum:?}");
    }

    proptest! {
        #[test]
        fn directions_are_unit_vectors_beside_their_angles(theta in -7.0f64..7.0, phi in 0.0f64..3.15) {
            let d = SpaceDirection::new(Direction::from_radians(theta), Direction::from_radians(phi));
            let c = d.components();
            let length = c.iter().fold(Rational::zero(), |sum, u| sum + u * u);
            prop_assert_eq!(length, Rational::one());
            let float = [phi.sin() * theta.cos(), phi.sin() * theta.sin(), phi.cos()];
            for (exact, near) in c.iter().zip(float) {
                prop_assert!((exact.to_f64() - near).abs() < 4e-15);
            }
        }
    }
}
