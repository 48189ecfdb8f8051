//! Certified points of forms that every ray from the origin meets once.

use std::cmp::Ordering;

use super::{Ray, Sample, UnitVector};
use crate::error::Result;
use crate::exact::{Rational, nearest_double};
use crate::shape::Radial;

/// The two points r and −r of a radial form in a direction. Each of r and the coordinates is the double nearest to its exact
/// value.
///
/// Cost: about ten comparisons for each number. For a superquadric each comparison takes roots of numbers with about (128 +
/// bits of the
/// direction)·p bits, where p is the numerator of the exponent.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::sample::{Direction, Ray, solve_radial};
/// use stellate::shape::Superquadric;
///
/// let one = Rational::one;
/// let diamond = Superquadric::new([one(), one()], Rational::from(2), one()).unwrap();
/// let Ray::Points(points) = solve_radial(&diamond, &Direction::from_radians(0.0))? else { panic!() };
/// assert_eq!([points[0].r, points[1].r], [1.0, -1.0]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`Radial::compare`].
pub fn solve_radial<const V: usize>(
    form: &dyn Radial<V>,
    direction: &impl UnitVector<V>,
) -> Result<Ray<V>> {
    let unit = direction.components();
    let guess = form.approximate_along(unit.each_ref().map(Rational::to_f64));
    let nearest = |factor: &Rational| {
        nearest_multiple(guess, factor, |r| {
            form.compare(&unit.each_ref().map(|u| r * u))
        })
    };
    let r = nearest(&Rational::one())?;
    let mut position = [0.0; V];
    for (value, u) in position.iter_mut().zip(&unit) {
        *value = nearest(u)?;
    }
    let sample = |branch: usize, sign: f64| Sample {
        branch,
        r: sign * r,
        position: position.map(|v| signed(sign, v)),
        multiplicity: 1,
    };
    Ok(Ray::Points(vec![sample(0, 1.0), sample(1, -1.0)]))
}

/// The double nearest to factor·r, for the r > 0 at which the points of a ray pass from inside to outside. `compare` gives the
/// position of the point at r, which is `Less` inside. `guess` is near r.
fn nearest_multiple(
    guess: f64,
    factor: &Rational,
    compare: impl Fn(&Rational) -> Result<Ordering>,
) -> Result<f64> {
    if factor.is_zero() {
        return Ok(0.0);
    }
    let start = guess * factor.to_f64().abs();
    // If the point at the bound is inside, the boundary is beyond the bound.
    let magnitude = nearest_double(start.max(0.0), |bound| -> Result<Ordering> {
        let r = bound / &factor.abs();
        match r.signum() {
            1 => Ok(compare(&r)?.reverse()),
            _ => Ok(Ordering::Greater),
        }
    })?;
    Ok(magnitude * f64::from(factor.signum()))
}

/// sign · value, where 0 has no sign.
fn signed(sign: f64, value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { sign * value }
}
