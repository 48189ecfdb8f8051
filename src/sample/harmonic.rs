//! Certified points of harmonic surfaces, whose radii in rational directions are rational.

use super::{Ray, Sample, UnitVector};
use crate::exact::Rational;
use crate::shape::HarmonicPair;

/// The points of a harmonic surface on the line of a direction d: R(d) and, in the opposite direction, −R(−d). Both are rational, and
/// each number is the double nearest to the exact one. If the two are one point, as everywhere if there are only odd harmonics, it is
/// listed once, with multiplicity 2 where the line touches F = 0. The positions are those of the points plus `from`, the center for
/// original coordinates.
///
/// Cost: two exact values of forms of degree L.
///
/// ```
/// use stellate::sample::{Direction, Ray, SpaceDirection, harmonic_ray};
/// use stellate::shape::{HarmonicPair, HarmonicSurface};
///
/// let surface = HarmonicSurface::new([((0, 0), 2.into()), ((1, 0), "1/2".parse()?)])?;
/// let pole = SpaceDirection::new(Direction::from_radians(0.0), Direction::from_radians(0.0));
/// let Ray::Points(points) = harmonic_ray(&HarmonicPair::new(&surface), surface.center(), &pole) else { unreachable!() };
/// assert_eq!([points[0].r, points[1].r], [2.5, -1.5]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[must_use]
pub fn harmonic_ray(
    pair: &HarmonicPair,
    from: &[Rational; 3],
    direction: &impl UnitVector<3>,
) -> Ray<3> {
    let unit = direction.components();
    let [odd, even] = pair.values(&unit);
    let size = even.abs();
    let mut radii = vec![&odd + &size];
    if !size.is_zero() {
        radii.push(&odd - &size);
    }
    let multiplicity = match size.is_zero() && !pair.is_odd() {
        true => 2,
        false => 1,
    };
    let radii = radii.into_iter().filter(|r| !r.is_zero()).enumerate();
    let points = radii.map(|(branch, r)| Sample {
        branch,
        r: r.to_f64(),
        position: std::array::from_fn(|i| (&unit[i] * &r + &from[i]).to_f64()),
        multiplicity,
    });
    Ray::Points(points.collect())
}

/// The point R(d) d of a harmonic surface plus its center, each coordinate the double nearest to the exact one.
pub(crate) fn harmonic_point(
    pair: &HarmonicPair,
    center: &[Rational; 3],
    direction: &impl UnitVector<3>,
) -> [f64; 3] {
    let unit = direction.components();
    let radius = pair.value(&unit);
    std::array::from_fn(|i| (&unit[i] * &radius + &center[i]).to_f64())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::implicitize::SquaredHarmonics;
    use crate::sample::{RaySolver, SpaceDirection};
    use crate::shape::HarmonicSurface;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// The points are those of the equation.
        #[test]
        fn points_are_the_certified_roots_of_the_equation(
            list in prop::collection::vec((0usize..5, 0usize..9, -9i64..10), 1..7),
        ) {
            let terms = list.into_iter().map(|(l, m, c)| {
                ((l, (m % (2 * l + 1)) as isize - l as isize), Rational::from(c))
            });
            let surface = HarmonicSurface::new(terms).unwrap();
            prop_assume!(!surface.is_zero());
            let form = SquaredHarmonics::new(&surface).unwrap();
            let equation = form.expand();
            let solver = RaySolver::new(equation.by_degree());
            for direction in SpaceDirection::fibonacci(9) {
                let ours = harmonic_ray(form.pair(), surface.center(), &direction);
                prop_assert_eq!(ours, solver.solve(&direction));
            }
        }
    }
}
