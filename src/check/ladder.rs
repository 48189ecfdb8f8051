//! The paper's own algorithm in doubles beside the exact one, for growing N: where doubles stop being usable.

use std::f64::consts::TAU;

use malachite::Integer;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

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
use crate::poly::{PlanePolynomial, SparsePolynomial};
use crate::shape::FourierRadius;

/// Where the ladder has rungs, besides the number of harmonics that there are.
const RUNGS: [usize; 16] = [
    1, 2, 3, 5, 7, 10, 14, 20, 30, 39, 50, 70, 100, 140, 200, 300,
];

/// Rays on which residuals and radii are compared.
const RAYS: u32 = 96;

/// How far outside the curve F is evaluated, relative to the radius; the first is "near the curve".
const OUTSIDE: [f64; 7] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];

/// Bits of the exact radii that are compared with.
const RADIUS_BITS: u32 = 200;

/// The fewest and the median digits of a kind of numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct DigitsKept {
    /// Of the worst one.
    pub worst: f64,
    /// Of half of them, at least.
    pub median: f64,
}

/// What doubles keep with N harmonics.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Rung {
    /// N.
    pub harmonics: usize,
    /// Of the coefficients of F.
    pub coefficients: DigitsKept,
    /// Of the value of F, from its expanded monomials, at points 1 % outside the curve.
    pub near: DigitsKept,
    /// The smallest of the distances 10⁻², 10⁻⁴, … 10⁻¹⁴ from the curve, relative to the radius, from which on the sign of F
    /// is right at all points; `None` if it is wrong somewhere 1 % outside.
    pub sign_distance: Option<f64>,
    /// Of the radii that the quadratic on a ray gives.
    pub radii: DigitsKept,
}

/// The paper's algorithm in doubles, beside the exact one, for the first N harmonics of a radius and growing N.
///
/// The radius is first multiplied by the power of two that brings a0 (or the largest coefficient, if a0 = 0) near 1, so that
/// doubles have no trouble with the size, and its coefficients are rounded to doubles: what is lost then is lost by the
/// algorithm. Cost: dominated by exact values of F at some 700 points.
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
/// As [`SquaredForm::new`]; what `limits` returns.
pub fn ladder(radius: &FourierRadius, limits: &Limits) -> Result<Vec<Rung>> {
    let radius = of_unit_size(radius);
    let top = radius.harmonics();
    let mut counts: Vec<usize> = RUNGS.into_iter().filter(|&n| n < top).collect();
    counts.push(top);
    let radii = counts.into_iter().map(|n| (n, truncated(&radius, n)));
    // A harmonic that is 0 is no new rung.
    let radii = radii.filter(|(n, radius)| radius.harmonics() == *n && !radius.is_zero());
    radii.map(|(_, radius)| rung(&radius, limits)).collect()
}

/// The radius times a power of two, every coefficient rounded to a double.
fn of_unit_size(radius: &FourierRadius) -> FourierRadius {
    let all = || radius.cosines().iter().chain(radius.sines());
    let mean = radius.cos(0).abs();
    let size = if mean.is_zero() {
        all().map(Rational::abs).max().unwrap_or(mean)
    } else {
        mean
    };
    let factor = Rational::from_dyadic(Integer::from(1), -nearest_power(&size));
    // What is beyond the doubles stays so.
    let rounded = |c: &Rational| {
        let scaled = c * &factor;
        Rational::try_from(scaled.to_f64()).unwrap_or(scaled)
    };
    let scaled = |v: &[Rational]| v.iter().map(rounded).collect();
    FourierRadius::new(scaled(radius.cosines()), scaled(radius.sines()))
}

/// What one ray says.
struct OnRay {
    /// How many of the first distances have the right sign.
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
            kept_coefficients(&compare_coefficients(&got, &SparsePolynomial::from(&exact)))
        }
        None => DigitsKept::default(),
    };
    let values = SeriesValues::new(radius);
    let rays: Result<Vec<OnRay>> = (0..RAYS)
        .into_par_iter()
        .map(|k| {
            limits.check()?;
            // Off the axes, which are too kind.
            let theta = TAU * (f64::from(k) + 0.5) / f64::from(RAYS);
            Ok(on_ray(theta, &float, &exact, &values))
        })
        .collect();
    let rays = rays?;
    let right = rays.iter().map(|ray| ray.right_signs).min();
    let right = right.invariant("there are rays");
    Ok(Rung {
        harmonics: radius.harmonics(),
        coefficients,
        near: kept(rays.iter().map(|ray| ray.near).collect()),
        sign_distance: right.checked_sub(1).map(|last| OUTSIDE[last]),
        radii: kept(rays.iter().map(|ray| ray.radius).collect()),
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
    // Correctly rounded, and so the same on every machine.
    let [c, s] = cosine_and_sine(&angle, RADIUS_BITS).map(|v| v.to_f64());
    let [r, _] = values.bounds(&angle, RADIUS_BITS);
    let rounded = r.to_f64();
    // F in doubles and exactly, at the same point; beyond the doubles there is no such point.
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

/// A missing or an extra coefficient has no digits.
fn kept_coefficients(found: &Comparison) -> DigitsKept {
    kept(found.all().map(|row| row.deviation.digits()).collect())
}

fn kept(mut digits: Vec<f64>) -> DigitsKept {
    digits.sort_by(f64::total_cmp);
    let middle = digits.len().saturating_sub(1) / 2;
    DigitsKept {
        worst: digits.first().copied().unwrap_or_default(),
        median: digits.get(middle).copied().unwrap_or_default(),
    }
}
