//! Compares radii of a float program, at angles that are doubles, with the certified ones.

use std::iter::successors;

use super::comparison::{Comparison, GivenNumber, Row};
use super::deviation::{Deviation, unit_in_the_last_place};
use super::enclosed_ray::EnclosedRays;
use super::mistakes::{Mistaken, diagnose, mistaken_radii};
use super::points::{ROWS_FOR_DIAGNOSIS, check_finite};
use super::reference::Reference;
use super::series::SeriesValues;
use super::unexplained::unexplained;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::factor::factor_plane;
use crate::limits::Limits;
use crate::parallel;
use crate::poly::PlanePolynomial;

/// The number of bits in the first enclosure of a radius.
const FIRST_BITS: u32 = 128;

/// A radius of a float program, and the line of the file that it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GivenRadius {
    /// The line, counted from 1.
    pub line: usize,
    /// The angle in radians, exactly this double.
    pub theta: f64,
    /// The radius.
    pub r: f64,
}

impl Reference {
    /// Compares radii of a float program with the certified ones. The angle is the double itself; its cosine and sine are
    /// enclosed as closely as the answer requires.
    ///
    /// If the reference was given by its Fourier radius, r(θ) is enclosed. Otherwise the nearest root of the polynomial on the
    /// ray is enclosed, which may have either sign. Cost: for each radius, that of enclosing the sum of the series, or the values of
    /// the homogeneous parts at (cos θ, sin θ) in some 200 bits and the real roots of one polynomial.
    ///
    /// ```
    /// use stellate::check::{GivenRadius, Reference};
    /// use stellate::limits::Limits;
    /// use stellate::shape::FourierRadius;
    /// let limacon = Reference::of_radius(&FourierRadius::new(vec![2.into(), 1.into()], vec![]))?;
    /// let given = GivenRadius { line: 1, theta: 1.0, r: 2.0 + 1f64.cos() };
    /// let found = limacon.check_radii(&[given], &Limits::none())?;
    /// assert!(found.passes(Some(15)));
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] for a number that is not finite; [`Error::Hypothesis`] for a surface; [`Error::Limit`] if the roots of a polynomial cannot be separated; those of
    /// `limits`.
    pub fn check_radii(&self, radii: &[GivenRadius], limits: &Limits) -> Result<Comparison> {
        for given in radii {
            check_finite(given.line, [("theta", given.theta), ("r", given.r)])?;
        }
        let Some(radius) = self.given_radius() else {
            return self.compare_with_polynomial(radii, limits);
        };
        let mut found = compare_with_series(radii, &SeriesValues::new(radius), limits)?;
        let step = radii.len().div_ceil(ROWS_FOR_DIAGNOSIS).max(1);
        let some: Vec<GivenRadius> = radii.iter().step_by(step).copied().collect();
        let compared = compare_with_series(&some, &SeriesValues::new(radius), limits)?;
        found.diagnoses = diagnose(&compared, mistaken_radii(radius), |mistaken| {
            compare_with_series(&some, &SeriesValues::new(mistaken), limits).ok()
        });
        if found.diagnoses.is_empty() {
            found.diagnoses = diagnose(&compared, [in_degrees(&some)], |some| {
                compare_with_series(some, &SeriesValues::new(radius), limits).ok()
            });
        }
        if found.diagnoses.is_empty() {
            // The terms of r(θ) are at most the sizes of the coefficients, so the sum of these over |r(θ)| bounds its
            // condition.
            let sizes = radius.cosines().iter().chain(radius.sines());
            let size = sizes.fold(Rational::zero(), |sum, c| sum + c.abs());
            found.diagnoses = unexplained(&found, |row| {
                let exact = row.exact.as_ref().filter(|exact| !exact.is_zero());
                exact.map_or_else(Rational::one, |exact| &size / &exact.abs())
            });
        }
        Ok(found)
    }

    /// Refuses radii r(θ) for a surface, before they are read.
    ///
    /// # Errors
    /// [`Error::Hypothesis`] for a surface.
    pub(crate) fn check_has_radii(&self) -> Result<()> {
        match self.in_space() {
            true => Err(is_a_surface()),
            false => Ok(()),
        }
    }

    fn compare_with_polynomial(
        &self,
        radii: &[GivenRadius],
        limits: &Limits,
    ) -> Result<Comparison> {
        let plane = (!self.in_space())
            .then(|| self.polynomial().to_plane())
            .flatten();
        let plane = plane.ok_or_else(is_a_surface)?;
        let rays = EnclosedRays::new(&self.without_multiple_factors(plane, limits)?);
        let compare = |radii: &[GivenRadius]| -> Result<Comparison> {
            let rows = parallel::try_map(radii, limits, |given| {
                let [theta, got] = exact(given);
                if got.is_zero() {
                    return Ok(row(given, None, Deviation::infinite()));
                }
                let Some(offset) = rays.nearest(&theta, &got)? else {
                    return Ok(row(given, None, Deviation::infinite()));
                };
                let root = |delta: &Rational| &got * &(Rational::one() + delta);
                let radius = root(&offset.high);
                let distance = offset.high.abs() * got.abs();
                let ulps = (distance / unit_in_the_last_place(radius.to_f64())).to_f64();
                let deviation = match offset.relative() {
                    Some(relative) => Deviation::bounded(relative, ulps),
                    None => Deviation::infinite(),
                };
                Ok(row(given, Some(radius), deviation))
            });
            Ok(Comparison {
                rows: rows?,
                ..Comparison::default()
            })
        };
        let mut found = compare(radii)?;
        let step = radii.len().div_ceil(ROWS_FOR_DIAGNOSIS).max(1);
        let some: Vec<GivenRadius> = radii.iter().step_by(step).copied().collect();
        found.diagnoses = diagnose(&compare(&some)?, [in_degrees(&some)], |some| {
            compare(some).ok()
        });
        if found.diagnoses.is_empty() {
            found.diagnoses = unexplained(&found, |_| Rational::one());
        }
        Ok(found)
    }
}

fn is_a_surface() -> Error {
    Error::Hypothesis {
        statement: "the check of radii r(theta)",
        witness: "this is a surface, whose radius has two angles; check its points x,y,z instead"
            .into(),
    }
}

/// The same radii if their angles were in degrees.
fn in_degrees(radii: &[GivenRadius]) -> Mistaken<Vec<GivenRadius>> {
    let turned = radii.iter().map(|given| GivenRadius {
        theta: given.theta.to_radians(),
        ..*given
    });
    Mistaken {
        name: "degrees for radians".into(),
        explanation: "the angles are in degrees; radians are meant".into(),
        form: turned.collect(),
    }
}

impl Reference {
    /// The polynomial with every irreducible factor once. Without multiple factors, its roots on a ray with transcendental
    /// direction are simple. The polynomial of a Fourier radius is irreducible.
    fn without_multiple_factors(
        &self,
        f: PlanePolynomial,
        limits: &Limits,
    ) -> Result<PlanePolynomial> {
        if self.radius().is_some() {
            return Ok(f);
        }
        let factors = factor_plane(&f, limits)?.factors;
        if factors.iter().all(|factor| factor.multiplicity == 1) {
            return Ok(f);
        }
        let product = factors.into_iter().map(|factor| factor.polynomial);
        Ok(product.reduce(|a, b| &a * &b).unwrap_or(f))
    }
}

fn compare_with_series(
    radii: &[GivenRadius],
    values: &SeriesValues,
    limits: &Limits,
) -> Result<Comparison> {
    let rows = parallel::try_map(radii, limits, |given| {
        let [theta, got] = exact(given);
        let bits = successors(Some(FIRST_BITS), |bits| Some(2 * bits));
        let (radius, deviation) =
            Deviation::enclosed(&got, bits, |bits| values.bounds(&theta, bits));
        Ok(row(given, Some(radius), deviation))
    });
    Ok(Comparison {
        rows: rows?,
        ..Comparison::default()
    })
}

/// The exact values of the angle and the radius, which are finite doubles.
fn exact(given: &GivenRadius) -> [Rational; 2] {
    [given.theta, given.r].map(|v| Rational::try_from(v).invariant("radii have been checked"))
}

fn row(given: &GivenRadius, exact: Option<Rational>, deviation: Deviation) -> Row {
    Row {
        place: GivenNumber::Radius {
            line: given.line,
            theta: given.theta,
        },
        got: given.r,
        exact,
        deviation,
        residual: None,
    }
}
