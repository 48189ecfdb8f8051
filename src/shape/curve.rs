//! Parametric curves in the plane and in space.

use super::Parameter;
use crate::exact::Rational;
use crate::poly::RationalFunction;

/// The curve α(t) of Theorems 1 and 3: its N coordinates are rational functions of one parameter, or of the cosine and sine of
/// an angle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParametricCurve<const N: usize> {
    parameter: Parameter,
    coordinates: [RationalFunction; N],
}

/// (x(t), y(t))
pub type PlaneCurve = ParametricCurve<2>;

/// (x(t), y(t), z(t))
pub type SpaceCurve = ParametricCurve<3>;

impl<const N: usize> ParametricCurve<N> {
    /// The curve whose coordinates are these functions of s; `parameter` says how s depends on the parameter.
    #[must_use]
    pub fn new(parameter: Parameter, coordinates: [RationalFunction; N]) -> Self {
        Self {
            parameter,
            coordinates,
        }
    }

    /// The parameter of the curve.
    #[must_use]
    pub fn parameter(&self) -> &Parameter {
        &self.parameter
    }

    /// The coordinates, in lowest terms, as functions of s.
    #[must_use]
    pub fn coordinates(&self) -> &[RationalFunction; N] {
        &self.coordinates
    }

    /// Whether all coordinates are constant, so that the curve is a point.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.coordinates.iter().all(RationalFunction::is_constant)
    }

    /// The point at s; `None` if a coordinate has a pole there.
    #[must_use]
    pub fn point(&self, s: &Rational) -> Option<[Rational; N]> {
        let mut point = std::array::from_fn(|_| Rational::zero());
        for (value, f) in point.iter_mut().zip(&self.coordinates) {
            *value = f.evaluate(s)?;
        }
        Some(point)
    }

    /// The point at s = ∞; `None` if a coordinate has a pole there.
    #[must_use]
    pub fn point_at_infinity(&self) -> Option<[Rational; N]> {
        let mut point = std::array::from_fn(|_| Rational::zero());
        for (value, f) in point.iter_mut().zip(&self.coordinates) {
            *value = f.evaluate_at_infinity()?;
        }
        Some(point)
    }
}
