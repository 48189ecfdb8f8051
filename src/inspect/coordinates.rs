//! The coordinates in which points and zero sets are compared: those of the form, moved to the middle of the zero set if that is far
//! from the origin, or to a point at which all digits of the polynomial cancel.

use std::borrow::Cow;

use super::Inspection;
use super::common_zeros::CommonZeros;
use super::exact::exact_difference;
use super::inspector::{Factor, Inspector};
use super::known::{Point, rounding};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::intervals::interval::UNIT;
use crate::intervals::{Field, largest, rational};

/// Doubles are precise enough if the last place of the coordinates is at most this part of the tolerance.
const FINE: f64 = 1e-6;

impl Inspector {
    /// The inspector of the zero set that is moved by a vector.
    pub(super) fn moved(mut self, by: [&Rational; 3]) -> Self {
        if by.iter().any(|c| !c.is_zero()) {
            let origin = self.origin.take().unwrap_or_default();
            self.origin = Some(std::array::from_fn(|i| &origin[i] + by[i]));
        }
        self
    }

    /// The point in the coordinates of the factors.
    pub(super) fn relative<'a>(&self, point: &'a [Rational; 3]) -> Cow<'a, [Rational; 3]> {
        match &self.origin {
            None => Cow::Borrowed(point),
            Some(origin) => Cow::Owned(exact_difference(point, origin)),
        }
    }

    /// The sign of the polynomial at a point of finite doubles, as in [`Inspection::sign`].
    pub(crate) fn side(&self, point: [f64; 3]) -> i8 {
        let exactly = self.origin.is_some().then(|| {
            let point = point.map(rational);
            self.relative(&point).into_owned()
        });
        let sign_of = |field: &Field| match &exactly {
            None => field.sign(match field.is_flat() {
                true => [point[0], point[1], 0.0],
                false => point,
            }),
            Some(exactly) => {
                let near = exactly.each_ref().map(Rational::to_f64);
                let in_doubles = field.sign_near(near, rounding(near));
                in_doubles.unwrap_or_else(|| field.polynomial().evaluate(exactly).signum())
            }
        };
        let signs = self
            .factors
            .iter()
            .map(|factor| match factor.multiplicity % 2 {
                1 => sign_of(&factor.field),
                _ => sign_of(&factor.field).abs(),
            });
        signs.product()
    }

    /// Whether the factors can be moved to a point that is inspected.
    pub(super) fn can_move(&self) -> bool {
        let mut fields = self.factors().iter().flat_map(|factor| {
            let of_curve = factor.curve.iter().flat_map(CommonZeros::both);
            of_curve.chain([&factor.field])
        });
        !self.is_local && fields.all(|field| self.is_exact_possible(field))
    }

    /// Whether the coordinates of a point are so large that doubles hardly tell parts of the tolerance, and coordinates about the point
    /// would.
    pub(super) fn is_coarse(&self, near: [f64; 3]) -> bool {
        UNIT * largest(&near) > FINE * self.around[0] && self.can_move()
    }

    /// Whether doubles lose all digits of a factor at a point in these coordinates, and coordinates about the point would keep them.
    pub(super) fn is_blurred(&self, field: &Field, near: [f64; 3]) -> bool {
        self.can_move() && field.sign_near(near, 0.0).is_none()
    }

    /// The inspector in coordinates about a point of these coordinates.
    ///
    /// # Errors
    /// Those of the limits.
    pub(super) fn about(&self, near: [f64; 3]) -> Result<Self> {
        let by = near.map(rational);
        let factors = self.factors().iter().map(|factor| {
            let curve = factor.curve.as_ref();
            let curve = curve.map(|curve| curve.about(&by, &self.limits));
            Ok(Factor {
                field: factor.field.about(&by, &self.limits)?,
                multiplicity: factor.multiplicity,
                curve: curve.transpose()?,
            })
        });
        let local = Self {
            factors: factors.collect::<Result<Vec<Factor>>>()?.into(),
            is_local: true,
            ..self.clone()
        };
        Ok(local.moved(by.each_ref()))
    }

    /// Inspects a point in coordinates about it. There doubles hold the values of the polynomial near the point, however much its
    /// terms cancel in the coordinates of the form.
    pub(super) fn in_coordinates_about(&self, p: &Point) -> Inspection {
        let Ok(local) = self.about(p.near) else {
            // The limits ended it.
            return Inspection::UNKNOWN;
        };
        let rest = exact_difference(p.exactly(), &p.near.map(rational));
        let near = rest.each_ref().map(Rational::to_f64);
        let read = || rest.clone();
        let point = Point::new(near, rounding(near), &read);
        local
            .in_these_coordinates(&point)
            .invariant("an inspector about a point is not moved again")
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::inspect::{InspectorOptions, Verdict};
    use crate::limits::Limits;
    use crate::poly::{Ring, SparsePolynomial};
    use crate::shape::ImplicitCurve;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(50))]

        /// A circle with a small term of degree 6, from whose highest part its middle is not seen: at points near it doubles lose all
        /// digits.
        #[test]
        fn points_at_which_all_digits_cancel_are_decided(
            middle in prop::array::uniform2(100_000_000i64..1_000_000_000),
            away in prop::array::uniform2(-3000i64..3000),
        ) {
            let constant = |c: Rational| SparsePolynomial::<3>::constant(c);
            let number = |c: i64| Rational::from(c);
            let [x, y] = [0, 1].map(SparsePolynomial::<3>::variable);
            let [u, v] = [(&x, middle[0]), (&y, middle[1])].map(|(x, c)| x.minus(&constant(number(c))).pow(2));
            // Near the circle the term is less than 10^(−24).
            let small = x.plus(&y).pow(6).scaled(&number(10).pow(-80).unwrap());
            let f = u.plus(&v).minus(&constant(number(1))).plus(&small);
            let options = InspectorOptions::new("1/10".parse().unwrap());
            let curve = ImplicitCurve::new(f.to_plane().unwrap());
            let inspector = Inspector::plane(&curve, &options, &Limits::none()).unwrap();
            let away = away.map(|c| number(c) / number(1000));
            let square = &away[0] * &away[0] + &away[1] * &away[1];
            let exact = (square.to_f64().sqrt() - 1.0).abs();
            prop_assume!((exact - 0.1).abs() > 1e-9 && exact > 1e-3 && !square.is_zero());
            let point = [number(middle[0]) + &away[0], number(middle[1]) + &away[1], Rational::zero()];
            let near = inspector.relative(&point).each_ref().map(Rational::to_f64);
            prop_assert!(inspector.is_blurred(&inspector.factors()[0].field, near));
            let found = inspector.inspect(&point);
            prop_assert_eq!(found.verdict, if exact <= 0.1 { Verdict::Inside } else { Verdict::Outside });
            prop_assert_eq!(found.sign, Some(if square > Rational::one() { 1 } else { -1 }));
            let bounds = found.distance;
            prop_assert!(bounds.low <= exact + 1e-12 && exact - 1e-12 <= bounds.high, "{bounds:?}");
            prop_assert!(bounds.high - bounds.low <= 2e-6 * bounds.high, "{bounds:?}");
            let foot = inspector.foot(&point, &found).unwrap().point;
            let from_middle = [0, 1].map(|i| foot[i] - number(middle[i]).to_f64());
            // Doubles of this size are 10^(−7) apart.
            prop_assert!((from_middle[0].hypot(from_middle[1]) - 1.0).abs() < 1e-6, "{foot:?}");
        }
    }
}
