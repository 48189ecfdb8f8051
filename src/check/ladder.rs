//! Compares the paper's own algorithm in doubles with the exact one for growing N, to show where doubles stop being usable.

use std::f64::consts::TAU;

use malachite::Integer;

use super::coefficients::compare_coefficients;
use super::comparison::Comparison;
use super::deviation::Deviation;
use super::float_theorem2::FloatTheorem2;
use super::mistakes::truncated;
use super::scale::nearest_power;
use super::series::SeriesValues;
use crate::error::{Invariant, Result};
use crate::exact::{Rational, cosine_and_sine};
use crate::implicitize::SquaredForm;
use crate::limits::Limits;
use crate::parallel;
use crate::poly::{PlanePolynomial, SparsePolynomial};
use crate::shape::FourierRadius;

/// The numbers of harmonics for which there are rungs, besides that of the radius itself.
const RUNGS: [usize; 16] = [
    1, 2, 3, 5, 7, 10, 14, 20, 30, 39, 50, 70, 100, 140, 200, 300,
];

/// The number of rays on which values of F and radii are compared.
const RAYS: u32 = 96;

/// The distances outside the curve at which F is evaluated, relative to the radius. The first one counts as "near the curve".
const OUTSIDE: [f64; 7] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];

/// The number of bits of the exact radii.
const RADIUS_BITS: u32 = 200;

/// The smallest and the median number of correct digits of numbers of one kind.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct DigitsKept {
    /// The digits of the worst number.
    pub worst: f64,
    /// The digits that at least half of the numbers have.
    pub median: f64,
}

/// The digits that doubles keep with N harmonics.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Rung {
    /// The number of harmonics N.
    pub harmonics: usize,
    /// The digits of the coefficients of F.
    pub coefficients: DigitsKept,
    /// The digits of the value of F, summed from its monomials, at points 1 % outside the curve.
    pub near: DigitsKept,
    /// The smallest of the distances 10⁻², 10⁻⁴, … 10⁻¹⁴ from the curve, relative to the radius, such that at this distance and
    /// all larger ones the sign of F is right at all points; `None` if it is wrong somewhere 1 % outside.
    pub sign_distance: Option<f64>,
    /// The digits of the radii that the quadratic equation on a ray gives.
    pub radii: DigitsKept,
}

/// Compares the paper's algorithm in doubles with the exact one, for the first N harmonics of a radius and growing N.
///
/// The radius is first multiplied by the power of two that brings a0 (or the largest coefficient, if a0 = 0) near 1, so that
/// its size causes no overflow. Its coefficients are then rounded to doubles, so that all further losses are those of the
/// algorithm. Cost: mainly exact values of F at about 700 points for each N.
///
/// ```
/// use stellate::check::ladder;
/// use stellate::limits::Limits;
/// use stellate::shape::FourierRadius;
/// let radius = FourierRadius::new(vec![3.into(), 1.into(), 1.into()], vec![]);
/// let rungs = ladder(&radius, &Limits::none())?;
/// assert_eq!(rungs.iter().map(|rung| rung.harmonics).collect::<Vec<_>>(), [1, 2]);
/// // Small integers are exact in doubles.
/// assert!(rungs[1].coefficients.worst >= 17.0);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`SquaredForm::new`] and of `limits`.
pub fn ladder(radius: &FourierRadius, limits: &Limits) -> Result<Vec<Rung>> {
    let radius = of_unit_size(radius);
    let top = radius.harmonics();
    let mut counts: Vec<usize> = RUNGS.into_iter().filter(|&n| n < top).collect();
    counts.push(top);
    let radii = counts.into_iter().map(|n| (n, truncated(&radius, n)));
    // If the N-th harmonic is 0, there is no rung for N.
    let radii = radii.filter(|(n, radius)| radius.harmonics() == *n && !radius.is_zero());
    radii.map(|(_, radius)| rung(&radius, limits)).collect()
}

/// The radius times a power of two, with every coefficient rounded to a double.
fn of_unit_size(radius: &FourierRadius) -> FourierRadius {
    let all = || radius.cosines().iter().chain(radius.sines());
    let mean = radius.cos(0).abs();
    let size = if mean.is_zero() {
        all().map(Rational::abs).max().unwrap_or(mean)
    } else {
        mean
    };
    let factor = Rational::from_dyadic(Integer::from(1), -nearest_power(&size));
    // A coefficient beyond the largest double is not rounded.
    let rounded = |c: &Rational| {
        let scaled = c * &factor;
        Rational::try_from(scaled.to_f64()).unwrap_or(scaled)
    };
    let scaled = |v: &[Rational]| v.iter().map(rounded).collect();
    FourierRadius::new(scaled(radius.cosines()), scaled(radius.sines()))
}

/// The comparison on one ray.
struct OnRay {
    /// The number of distances, from the first one on, at which the sign of F is right.
    right_signs: usize,
    near: f64,
    radius: f64,
}

fn rung(radius: &FourierRadius, limits: &Limits) -> Result<Rung> {
    limits.check()?;
    let float = FloatTheorem2::new(radius);
    let exact = SquaredForm::new(radius)?
        .expand_unreduced()
        .polynomial()
        .monic();
    let coefficients = match float.polynomial() {
        Some(got) => {
            coefficient_digits(&compare_coefficients(&got, &SparsePolynomial::from(&exact)))
        }
        None => DigitsKept::default(),
    };
    let values = SeriesValues::new(radius);
    let rays: Vec<u32> = (0..RAYS).collect();
    let rays = parallel::try_map(&rays, limits, |&k| {
        // No ray lies on an axis, where most monomials are 0 and nothing cancels.
        let theta = TAU * (f64::from(k) + 0.5) / f64::from(RAYS);
        Ok(on_ray(theta, &float, &exact, &values))
    })?;
    let right = rays.iter().map(|ray| ray.right_signs).min();
    let right = right.invariant("there are rays");
    Ok(Rung {
        harmonics: radius.harmonics(),
        coefficients,
        near: digits_kept(rays.iter().map(|ray| ray.near).collect()),
        sign_distance: right.checked_sub(1).map(|last| OUTSIDE[last]),
        radii: digits_kept(rays.iter().map(|ray| ray.radius).collect()),
    })
}

fn on_ray(
    theta: f64,
    float: &FloatTheorem2,
    exact: &PlanePolynomial,
    values: &SeriesValues,
) -> OnRay {
    let at = |v: f64| Rational::try_from(v).ok();
    let angle = at(theta).invariant("an angle is finite");
    // These are the same on every machine; the cosine and sine of the standard library need not be.
    let [c, s] = cosine_and_sine(&angle, RADIUS_BITS).map(|v| v.to_f64());
    let [r, _] = values.bounds(&angle, RADIUS_BITS);
    let rounded = r.to_f64();
    // The value of F in doubles and the exact value at the same point. A point beyond the largest double has no exact value.
    let both = |outside: f64| {
        let radius = rounded * (1.0 + outside);
        let (x, y) = (radius * c, radius * s);
        let value = at(x).zip(at(y)).map(|(x, y)| exact.evaluate(&x, &y));
        (at(float.evaluate(x, y)), value)
    };
    let values = OUTSIDE.map(both);
    let right = values.iter().take_while(|(got, exact)| {
        let both = got.as_ref().zip(exact.as_ref());
        both.is_some_and(|(got, exact)| got.signum() == exact.signum())
    });
    let right_signs = right.count();
    let [(got, value), ..] = values;
    let digits = |got: Option<Rational>, exact: &Rational| {
        got.map_or(0.0, |got| Deviation::between(&got, exact).digits())
    };
    let radii = float.radii([c, s]).map(|root| digits(at(root), &r));
    OnRay {
        right_signs,
        near: value.map_or(0.0, |value| digits(got, &value)),
        radius: radii[0].max(radii[1]),
    }
}

/// The digits of all coefficients. A missing one has no digits; those of an extra one count how small it is.
fn coefficient_digits(found: &Comparison) -> DigitsKept {
    digits_kept(found.all().map(|row| row.deviation.digits()).collect())
}

fn digits_kept(mut digits: Vec<f64>) -> DigitsKept {
    digits.sort_unstable_by(f64::total_cmp);
    let middle = digits.len().saturating_sub(1) / 2;
    DigitsKept {
        worst: digits.first().copied().unwrap_or_default(),
        median: digits.get(middle).copied().unwrap_or_default(),
    }
}
