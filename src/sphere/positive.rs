//! Whether a sum of spherical harmonics is positive in every direction.

use malachite::base::num::logic::traits::SignificantBits;

use super::grid::Latitudes;
use super::touching::direction_without_radius;
use crate::error::{Invariant, Result};
use crate::exact::{Dyadic, Rational};
use crate::intervals::interval::Interval;
use crate::limits::Limits;
use crate::sample::{Direction, SpaceDirection, UnitVector};
use crate::shape::{HarmonicPair, HarmonicSurface};

/// Whether R > 0 in every direction.
#[expect(
    clippy::large_enum_variant,
    reason = "there is one of these for each surface that is described"
)]
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Positivity {
    /// R > 0 everywhere; its least value is between `low` and `high`.
    Positive {
        /// A lower bound, above 0 unless no double is a useful one.
        low: f64,
        /// An upper bound, infinite if the least value is above the largest double.
        high: f64,
    },
    /// R ≤ 0 in this exact direction.
    NotPositive {
        /// The unit vector.
        direction: [Rational; 3],
        /// R there.
        value: Rational,
    },
    /// The least value of R is too near 0.
    Unknown,
}

/// A radius is scaled if its terms are beyond 2 to this power, or its inverse.
const MOST_EXPONENT: i64 = 300;
/// The largest degree at which a zero in a rational direction is looked for, because that takes many exact values.
const MOST_DEGREE: usize = 24;
/// The distances of the latitudes and longitudes of the grids, as multiples of 1/L; each grid is finer than the one before.
const STEPS: [f64; 5] = [0.5, 0.25, 0.125, 0.06, 0.03];

/// Decides whether R > 0 in every direction, by its values on grids.
///
/// Lemma. Let S be a polynomial of degree L on the sphere, M = max |S|, and let every direction be within h of a direction of the
/// grid, with q = L²h²/2 < 1. Then M ≤ m/(1 − q) for the largest |S| on the grid m, and min S ≥ (least value on the grid) − qM.
///
/// Proof. S has its minimum at d; let g be a direction of the grid within h of d. On the great circle through both S is a trigonometric
/// polynomial f of degree at most L with f'(0) = 0 at d, and |f''| ≤ L²M by Bernstein's inequality, so |S(g) − S(d)| ≤ L²h²M/2. The
/// same at a direction where |S| = M gives M − m ≤ qM.
///
/// S is R without its mean. Cost: about L³ products for the coarsest grid, besides exact values of L² polynomials.
///
/// ```
/// use stellate::limits::Limits;
/// use stellate::shape::{HarmonicPair, HarmonicSurface};
/// use stellate::sphere::{Positivity, positivity};
///
/// // R = 2 + cos(phi)/2 is between 3/2 and 5/2.
/// let surface = HarmonicSurface::new([((0, 0), 2.into()), ((1, 0), "1/2".parse()?)])?;
/// let found = positivity(&surface, &HarmonicPair::new(&surface), &Limits::none())?;
/// let Positivity::Positive { low, high } = found else { unreachable!() };
/// assert!(low > 1.4 && low <= 1.5 && 1.5 <= high + 1e-9);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `limits`.
pub fn positivity(
    surface: &HarmonicSurface,
    pair: &HarmonicPair,
    limits: &Limits,
) -> Result<Positivity> {
    let mean = surface.coefficient(0, 0);
    if surface.degree() == 0 {
        if mean.signum() > 0 {
            let bounds = Interval::from(mean);
            return Ok(Positivity::Positive {
                low: bounds.low(),
                high: bounds.high(),
            });
        }
        let direction = [Rational::zero(), Rational::zero(), Rational::one()];
        return Ok(Positivity::NotPositive {
            direction,
            value: mean.clone(),
        });
    }
    // Doubles hold the values of the scaled radius.
    let exponent = match largest_exponent(surface) {
        e if e.abs() > MOST_EXPONENT => e,
        _ => 0,
    };
    let unit = Rational::from_dyadic(1.into(), -exponent);
    let terms = surface.terms().map(|(l, m, c)| ((l, m), c * &unit));
    let scaled = HarmonicSurface::new(terms)?;
    let latitudes = Latitudes::new(&scaled);
    let mut last = None;
    for step in STEPS {
        limits.check()?;
        let mean = scaled.coefficient(0, 0);
        let Some(grid) = least_on_grid(&latitudes, surface.degree(), mean, step, limits)? else {
            break;
        };
        if grid.low > 0.0 {
            if exponent == 0 {
                let (low, high) = (grid.low, grid.high);
                return Ok(Positivity::Positive { low, high });
            }
            let [low, high] = [grid.low, grid.high].map(|bound| {
                let bound = Dyadic::from_f64(bound).invariant("the bounds are finite");
                Interval::from(&bound.times_power_of_two(exponent).to_rational())
            });
            return Ok(Positivity::Positive {
                low: low.low().clamp(0.0, f64::MAX),
                high: high.high(),
            });
        }
        // An exact value in a direction near that of the least value may be a witness.
        let [theta, phi] = grid.at.map(Direction::from_radians);
        let direction = SpaceDirection::new(theta, phi).components();
        let value = pair.value(&direction);
        if value.signum() <= 0 {
            return Ok(Positivity::NotPositive { direction, value });
        }
        last = Some(direction);
    }
    if let Some(near) = last.filter(|_| surface.degree() <= MOST_DEGREE)
        && let Some((direction, value)) = direction_without_radius(pair, &near, limits)?
    {
        return Ok(Positivity::NotPositive { direction, value });
    }
    Ok(Positivity::Unknown)
}

/// The exponent e for which 2^e is about the largest that a term may be: |c| times an estimate of the largest |Y(l, m)|, the root of
/// (l + |m|)!/(l − |m|)!. The radius is not constant.
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "an estimate"
)]
fn largest_exponent(surface: &HarmonicSurface) -> i64 {
    let logarithm = |k: usize| (k as f64).log2();
    let exponents = surface
        .terms()
        .filter(|(.., c)| !c.is_zero())
        .map(|(l, m, c)| {
            let m = m.unsigned_abs();
            let product: f64 = (l - m + 1..=l + m).map(logarithm).sum();
            let bits = |n: malachite::Integer| n.significant_bits().cast_signed();
            bits(c.numerator()) - bits(c.denominator()) + (product / 2.0) as i64
        });
    exponents
        .max()
        .invariant("a radius with a degree has a term")
}

/// Bounds of the least value of R, and the angles θ and φ of a direction near it.
struct Least {
    low: f64,
    high: f64,
    at: [f64; 2],
}

/// The bounds by one grid; `None` if the values are not finite.
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of angles are small"
)]
fn least_on_grid(
    latitudes: &Latitudes,
    degree: usize,
    mean: &Rational,
    step: f64,
    limits: &Limits,
) -> Result<Option<Least>> {
    let mean = Interval::from(mean);
    let rows = (std::f64::consts::PI * degree as f64 / step).ceil() as usize;
    let count = 2 * rows;
    let turns: Vec<[f64; 2]> = (0..count)
        .map(|j| {
            let (s, c) = (std::f64::consts::TAU * j as f64 / count as f64).sin_cos();
            [c, s]
        })
        .collect();
    let (mut least, mut at) = (f64::INFINITY, [0.0, 0.0]);
    let (mut size, mut error) = (0.0f64, 0.0f64);
    let (mut before, mut widest) = (0.0, 0.0f64);
    for i in 0..=rows {
        limits.check()?;
        let nominal = std::f64::consts::PI * i as f64 / rows as f64;
        let latitude = latitudes.at(nominal.cos());
        let phi = latitude.cosine.acos();
        widest = widest.max(phi - before);
        before = phi;
        error = error.max(latitude.error());
        for (j, value) in latitude.values(&turns).enumerate() {
            if value < least {
                least = value;
                at = [std::f64::consts::TAU * j as f64 / count as f64, phi];
            }
            size = size.max((value - mean.middle()).abs());
        }
    }
    // Half of the distance of neighbouring latitudes, and of neighbouring longitudes, with room for the roundings of the angles.
    let half = widest.max(std::f64::consts::TAU / count as f64) / 2.0 + 1e-9;
    let square = Interval::from(half).squared() * 2.0;
    let q = square * (degree as f64 * degree as f64) * 0.5;
    let error = Interval::from(error);
    let from_mean = Interval::from(size) + error + (mean - Interval::from(mean.middle())).abs();
    let largest = from_mean / (Interval::from(1.0) - q);
    let low = Interval::from(least) - error - q * largest;
    let high = Interval::from(least) + error;
    let is_finite = low.low().is_finite() && high.high().is_finite() && q.high() < 1.0;
    Ok(is_finite.then(|| Least {
        low: low.low(),
        high: high.high(),
        at,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn decided(surface: &HarmonicSurface) -> Positivity {
        positivity(surface, &HarmonicPair::new(surface), &Limits::none()).unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// The least value on random directions is not below the bound, and a witness is one.
        #[test]
        fn the_least_value_is_bounded(
            list in prop::collection::vec((1usize..9, 0usize..17, -9i64..10), 1..8),
            mean in 1i64..400, p in -30i64..30, q in -30i64..30,
        ) {
            let terms = list.into_iter().map(|(l, m, c)| {
                let m = (m % (2 * l + 1)) as isize - l as isize;
                let size: i64 = (1..=m.unsigned_abs() as i64).map(|k| l as i64 + k).product();
                ((l, m), Rational::new(c, size).unwrap())
            });
            let surface = HarmonicSurface::new(terms.chain([((0, 0), mean.into())])).unwrap();
            let pair = HarmonicPair::new(&surface);
            match decided(&surface) {
                Positivity::Positive { low, .. } => {
                    let n = p * p + q * q + 400;
                    let unit = [40 * p, 40 * q, p * p + q * q - 400];
                    let unit = unit.map(|x| Rational::new(x, n).unwrap());
                    let low = Rational::try_from(low).unwrap();
                    prop_assert!(pair.value(&unit) >= low);
                    prop_assert!(low.signum() > 0);
                }
                Positivity::NotPositive { direction, value } => {
                    prop_assert_eq!(pair.value(&direction), value.clone());
                    prop_assert!(value.signum() <= 0);
                }
                Positivity::Unknown => {}
            }
        }
    }

    #[test]
    fn radii_near_zero() {
        // R = c + cos φ has the least value c − 1.
        let of = |c: &str| {
            let terms = [((0, 0), c.parse().unwrap()), ((1, 0), Rational::one())];
            decided(&HarmonicSurface::new(terms).unwrap())
        };
        assert!(matches!(of("1.01"), Positivity::Positive { .. }));
        assert!(matches!(of("1"), Positivity::NotPositive { .. }));
        assert!(matches!(of("0.99"), Positivity::NotPositive { .. }));
        assert_eq!(of("1.00000001"), Positivity::Unknown);
    }

    /// A radius that is 0 in one rational direction: |n|² − n·d for a unit vector d, or its square, or along a circle.
    #[test]
    fn zeros_in_rational_directions_are_found() {
        let of = |text: &str| {
            use crate::language::{Numbers, parse_form};
            use crate::shape::Form;
            let Form::Harmonic(surface) = parse_form(text, "<form>", Numbers::Exact).unwrap()
            else {
                panic!("{text}")
            };
            decided(&surface)
        };
        let x = "sin(phi)*cos(theta)";
        let y = "sin(phi)*sin(theta)";
        for text in [
            format!("R = 1 + {x}"),
            format!("R = 1 - {x}"),
            format!("R = 3 - 3*{y}"),
            format!("R = 7 + 7*{y}"),
            format!("R = 5 + 3*{x} + 4*{y}"),
            format!("R = 1 + 2/7*{x} - 3/7*{y} + 6/7*cos(phi)"),
            format!("R = (13 - 5*{x} - 12*cos(phi))^2"),
            format!("R = (3*{x} + 4*{y})^2"),
            "R = cos(phi)^2".to_owned(),
        ] {
            let Positivity::NotPositive { value, .. } = of(&text) else {
                panic!("{text} is 0 in a rational direction")
            };
            assert!(value.is_zero(), "{text}: {value}");
        }
        // The first of these is 0 in the direction of (1, 1, 0), which is not rational; the others are never 0.
        for text in [
            format!("R = 1 - 2*{x}*{y}"),
            format!("R = 3 + {x} + 2*{y} + 2*cos(phi) + 1e-12"),
            format!("R = (1 + {x})^2 + 1e-14"),
        ] {
            assert_eq!(of(&text), Positivity::Unknown, "{text}");
        }
    }

    #[test]
    fn radii_of_any_size_are_decided_alike() {
        for exponent in [-1400, -700, 0, 700, 1400] {
            let of = |c: &str| {
                let unit = Rational::from_dyadic(1.into(), exponent);
                let mean: Rational = c.parse().unwrap();
                let terms = [((0, 0), &mean * &unit), ((1, 0), unit)];
                decided(&HarmonicSurface::new(terms).unwrap())
            };
            let Positivity::Positive { low, high } = of("2") else {
                panic!("positive at 2^{exponent}");
            };
            let least = Rational::from_dyadic(1.into(), exponent).to_f64();
            assert!(
                low <= least && least <= high && low < f64::INFINITY,
                "{exponent}"
            );
            assert!(matches!(of("0.5"), Positivity::NotPositive { .. }));
        }
        // The values of Y(150, 150) are up to 299!!, which has 307 digits.
        let sectoral = HarmonicSurface::new([((150, 150), Rational::one())]).unwrap();
        assert!(matches!(decided(&sectoral), Positivity::NotPositive { .. }));
    }
}
