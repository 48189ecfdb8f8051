//! Comparisons of the numbers of a float program with a sum of spherical harmonics: its coefficients, and its radii at angles that are
//! doubles.

mod mistakes;
mod values;

use std::collections::BTreeMap;

use nalgebra::{Cholesky, DMatrix, DVector};

use super::comparison::{Comparison, GivenNumber, Row};
use super::deviation::Deviation;
use super::mistakes::{Mistaken, diagnose};
use super::points::check_finite;
use super::unexplained::unexplained;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::parallel;
use crate::shape::{HarmonicSurface, NormalizedHarmonics, harmonic_norm};
use mistakes::{missing_name, mistaken_angles, mistaken_surfaces, scaled, without};
use values::SphericalValues;

/// The numbers of bits of the enclosures of a radius, in turn. A radius that is equal up to the last of them is reported with a
/// deviation of that size.
const BITS: [u32; 4] = [128, 256, 512, 1024];
/// Mistakes are tried at this many radii.
const TRIED: usize = 96;
/// Harmonics that are missing are sought by at most this many radii for each coefficient.
const RADII_FOR_COEFFICIENT: usize = 4;
/// Harmonics that are missing are sought up to this number of coefficients.
const MOST_COEFFICIENTS: usize = 1024;
/// A harmonic is missing if its coefficient lacks up to this part of it.
const LACKING: f64 = 0.02;

/// A radius of a float program in a direction, and the line of the file that it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GivenSpaceRadius {
    /// The line, counted from 1.
    pub line: usize,
    /// The angle about z in radians, exactly this double.
    pub theta: f64,
    /// The angle from z, likewise.
    pub phi: f64,
    /// The radius.
    pub r: f64,
}

/// The coefficients of a float program, by (l, m).
pub type GivenHarmonics = BTreeMap<(usize, isize), Rational>;

/// A harmonic surface that float programs are measured against.
#[derive(Clone, Debug)]
pub struct SphericalReference {
    surface: HarmonicSurface,
}

/// What a mistake changes.
enum Changed {
    Surface(Box<HarmonicSurface>),
    Angles(Vec<GivenSpaceRadius>),
}

impl SphericalReference {
    /// The reference for a harmonic surface; radii are measured from its center.
    #[must_use]
    pub fn new(surface: &HarmonicSurface) -> Self {
        Self {
            surface: surface.clone(),
        }
    }

    /// The harmonic surface.
    #[must_use]
    pub fn surface(&self) -> &HarmonicSurface {
        &self.surface
    }

    /// Compares coefficients of the unnormalised harmonics without the Condon–Shortley phase with the exact ones, one by one, and looks for
    /// usual mistakes.
    ///
    /// ```
    /// use stellate::check::{GivenHarmonics, SphericalReference};
    /// use stellate::shape::HarmonicSurface;
    /// let surface = HarmonicSurface::new([((0, 0), 2.into()), ((1, 1), 1.into()), ((2, 1), 1.into())])?;
    /// let wrong = GivenHarmonics::from([((0, 0), 2.into()), ((1, 1), (-1).into()), ((2, 1), (-1).into())]);
    /// let found = SphericalReference::new(&surface).check_coefficients(&wrong);
    /// assert_eq!(found.diagnoses[0].name, "Condon–Shortley phase");
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    #[must_use]
    pub fn check_coefficients(&self, got: &GivenHarmonics) -> Comparison {
        let mut found = compare_coefficients(got, &self.surface);
        let ratios = found.rows.iter().filter_map(|row| {
            let exact = row.exact.as_ref()?.to_f64();
            Some(row.got / exact)
        });
        let mut candidates = mistaken_surfaces(&self.surface);
        candidates.extend(scaled(&self.surface, ratios.collect()));
        found.diagnoses = diagnose(&found, candidates, |surface| {
            Some(compare_coefficients(got, surface))
        });
        if found.diagnoses.is_empty() && !found.missing.is_empty() {
            let missing: Vec<(usize, isize)> =
                found.missing.iter().filter_map(harmonic_of).collect();
            let one = without(&self.surface, &missing);
            found.diagnoses = diagnose(&found, one, |surface| {
                Some(compare_coefficients(got, surface))
            });
            // The name says which, even if other numbers are wrong, too.
            if found.diagnoses.is_empty() {
                found.diagnoses = unexplained(&found, |_| Rational::one());
                if let Some(first) = found.diagnoses.first_mut() {
                    first.name = missing_name(&self.surface, &missing).into();
                    first.explanation = format!("{} harmonics are not there", missing.len()).into();
                }
                return found;
            }
        }
        if found.diagnoses.is_empty() {
            let size = self.largest();
            found.diagnoses = unexplained(&found, |row| {
                let small = harmonic_of(row).zip(row.exact.as_ref()).map(|((l, m), c)| {
                    let norm = harmonic_norm(l, m.unsigned_abs());
                    size * norm / c.to_f64().abs()
                });
                let condition = small.and_then(|x| Rational::try_from(x).ok());
                condition.unwrap_or_else(Rational::one).max(Rational::one())
            });
        }
        found
    }

    /// The largest coefficient of a normalised harmonic.
    fn largest(&self) -> f64 {
        let sizes = self
            .surface
            .terms()
            .map(|(l, m, c)| c.to_f64().abs() / harmonic_norm(l, m.unsigned_abs()));
        sizes.fold(0.0, f64::max)
    }

    /// Compares radii of a float program with the exact ones at angles that are exactly its doubles, and looks for usual mistakes.
    ///
    /// ```
    /// use stellate::check::{GivenSpaceRadius, SphericalReference};
    /// use stellate::limits::Limits;
    /// use stellate::shape::HarmonicSurface;
    /// let surface = HarmonicSurface::new([((0, 0), 2.into()), ((1, 0), 1.into())])?;
    /// let at = |phi: f64| GivenSpaceRadius { line: 1, theta: 0.3, phi, r: 2.0 + phi.cos() };
    /// let found = SphericalReference::new(&surface).check_radii(&[at(1.0), at(2.5)], &Limits::none())?;
    /// assert!(found.passes(Some(15)));
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`](crate::error::Error::Usage) for a number that is not finite; those of `limits`.
    pub fn check_radii(&self, radii: &[GivenSpaceRadius], limits: &Limits) -> Result<Comparison> {
        for given in radii {
            let numbers = [("theta", given.theta), ("phi", given.phi), ("r", given.r)];
            check_finite(given.line, numbers)?;
        }
        let values = SphericalValues::new(&self.surface);
        let mut found = compare_radii(radii, &values, limits)?;
        let step = radii.len().div_ceil(TRIED).max(1);
        let some: Vec<GivenSpaceRadius> = radii.iter().step_by(step).copied().collect();
        let compared = compare_radii(&some, &values, limits)?;
        let try_all = |all: Vec<Mistaken<Changed>>| {
            diagnose(&compared, all, |changed| match changed {
                Changed::Angles(radii) => compare_radii(radii, &values, limits).ok(),
                Changed::Surface(surface) => {
                    compare_radii(&some, &SphericalValues::new(surface), limits).ok()
                }
            })
        };
        let of_surface = |m: Mistaken<HarmonicSurface>| Mistaken {
            name: m.name,
            explanation: m.explanation,
            form: Changed::Surface(Box::new(m.form)),
        };
        let of_angles = |m: Mistaken<Vec<GivenSpaceRadius>>| Mistaken {
            name: m.name,
            explanation: m.explanation,
            form: Changed::Angles(m.form),
        };
        let ratios = compared.rows.iter().filter_map(|row| {
            let exact = row.exact.as_ref()?.to_f64();
            Some(row.got / exact)
        });
        let scaled = scaled(&self.surface, ratios.collect());
        let surfaces = mistaken_surfaces(&self.surface).into_iter().chain(scaled);
        let all = surfaces.map(of_surface);
        let all = all.chain(mistaken_angles(&some).into_iter().map(of_angles));
        found.diagnoses = try_all(all.collect());
        if found.diagnoses.is_empty()
            && !self.surface.is_centered()
            && let Some(moved) = self.without_center(&some)
        {
            found.diagnoses = center_forgotten(&compared, moved);
        }
        if found.diagnoses.is_empty()
            && compared.below(9).len() > compared.rows.len() / 4
            && let Some(missing) = self.missing(radii, &found, limits)?
            && let Some(mistaken) = without(&self.surface, &missing)
        {
            found.diagnoses = try_all(vec![of_surface(mistaken)]);
        }
        if found.diagnoses.is_empty() {
            let size = values.size();
            found.diagnoses = unexplained(&found, |row| {
                let exact = row.exact.as_ref().filter(|exact| !exact.is_zero());
                exact.map_or_else(Rational::one, |exact| &size / &exact.abs())
            });
        }
        Ok(found)
    }

    /// The harmonics that are missing in the radii: the differences from the exact radii are fitted by least squares with all harmonics, and
    /// those are missing whose coefficient is nearly minus the exact one.
    fn missing(
        &self,
        radii: &[GivenSpaceRadius],
        found: &Comparison,
        limits: &Limits,
    ) -> Result<Option<Vec<(usize, isize)>>> {
        let degree = self.surface.degree();
        let count = (degree + 1) * (degree + 1);
        if count > MOST_COEFFICIENTS || radii.len() < count {
            return Ok(None);
        }
        let step = (radii.len() / (RADII_FOR_COEFFICIENT * count)).max(1);
        let mut basis = NormalizedHarmonics::new(degree);
        let mut values = vec![0.0; count];
        let mut products = DMatrix::<f64>::zeros(count, count);
        let mut sums = DVector::<f64>::zeros(count);
        for (given, row) in radii.iter().zip(&found.rows).step_by(step) {
            limits.check()?;
            let Some(exact) = &row.exact else { continue };
            let ((st, ct), (sp, cp)) = (given.theta.sin_cos(), given.phi.sin_cos());
            basis.values([sp * ct, sp * st, cp], &mut values);
            let off = given.r - exact.to_f64();
            for (j, y) in values.iter().enumerate() {
                sums[j] += y * off;
                for (sum, x) in products.column_mut(j).iter_mut().skip(j).zip(&values[j..]) {
                    *sum += y * x;
                }
            }
        }
        let Some(factors) = Cholesky::new(products) else {
            return Ok(None);
        };
        let lacking = factors.solve(&sums);
        let missing: Vec<(usize, isize)> = self
            .surface
            .terms()
            .filter(|(l, m, c)| {
                let exact = c.to_f64() / harmonic_norm(*l, m.unsigned_abs());
                let at = (l * l + l).checked_add_signed(*m);
                let lacks = at.map_or(0.0, |at| lacking[at]);
                (lacks + exact).abs() <= LACKING * exact.abs()
            })
            .map(|(l, m, _)| (l, m))
            .collect();
        Ok((!missing.is_empty()).then_some(missing))
    }

    /// The radii from the origin of the surface's coordinates instead of its center, in doubles, in the directions of some given ones; `None`
    /// if a ray from the origin was not found to meet the surface.
    fn without_center(&self, radii: &[GivenSpaceRadius]) -> Option<Vec<f64>> {
        let degree = self.surface.degree();
        let mut basis = NormalizedHarmonics::new(degree);
        let mut values = vec![0.0; (degree + 1) * (degree + 1)];
        let mut coefficients = vec![0.0; values.len()];
        for (l, m, c) in self.surface.terms() {
            let at = (l * l + l).checked_add_signed(m)?;
            coefficients[at] = c.to_f64() / harmonic_norm(l, m.unsigned_abs());
        }
        let center = self.surface.center().each_ref().map(Rational::to_f64);
        let mut excess = |d: [f64; 3], t: f64| {
            let p: [f64; 3] = std::array::from_fn(|i| t * d[i] - center[i]);
            let rho = p.iter().map(|x| x * x).sum::<f64>().sqrt();
            basis.values(p.map(|x| x / rho), &mut values);
            rho - coefficients
                .iter()
                .zip(&values)
                .map(|(c, y)| c * y)
                .sum::<f64>()
        };
        let size = coefficients.iter().map(|c| c.abs()).sum::<f64>()
            * f64::from(u32::try_from(degree + 1).invariant("a degree is below 2^32"))
            + center.iter().map(|x| x.abs()).sum::<f64>();
        let radius = |given: &GivenSpaceRadius| {
            let ((st, ct), (sp, cp)) = (given.theta.sin_cos(), given.phi.sin_cos());
            let d = [sp * ct, sp * st, cp];
            let (mut low, mut high) = (0.0, 4.0 * size);
            if excess(d, low) >= 0.0 || excess(d, high) <= 0.0 {
                return None;
            }
            for _ in 0..80 {
                let middle = f64::midpoint(low, high);
                match excess(d, middle) < 0.0 {
                    true => low = middle,
                    false => high = middle,
                }
            }
            Some(high)
        };
        radii.iter().map(radius).collect()
    }
}

/// The diagnosis that radii were measured from the origin of the coordinates, if these radii are such ones.
fn center_forgotten(compared: &Comparison, moved: Vec<f64>) -> Vec<super::Diagnosis> {
    let mistaken = Mistaken {
        name: "center forgotten".into(),
        explanation: "the radii are measured from the origin of the coordinates, not from the center of the surface".into(),
        form: moved,
    };
    diagnose(compared, [mistaken], |moved| {
        let rows = compared.rows.iter().zip(moved).map(|(row, radius)| {
            let exact = Rational::try_from(*radius).ok()?;
            let got = Rational::try_from(row.got).ok()?;
            Some(Row {
                deviation: Deviation::between(&got, &exact),
                exact: Some(exact),
                ..row.clone()
            })
        });
        Some(Comparison {
            rows: rows.collect::<Option<Vec<Row>>>()?,
            ..Comparison::default()
        })
    })
}

fn harmonic_of(row: &Row) -> Option<(usize, isize)> {
    match row.place {
        GivenNumber::Harmonic { l, m } => Some((l, m)),
        _ => None,
    }
}

fn compare_coefficients(got: &GivenHarmonics, surface: &HarmonicSurface) -> Comparison {
    let mut found = Comparison {
        in_space: true,
        ..Comparison::default()
    };
    let mut exact: GivenHarmonics = surface
        .terms()
        .map(|(l, m, c)| ((l, m), c.clone()))
        .collect();
    let normalized =
        |l: usize, m: isize, c: &Rational| c.to_f64().abs() / harmonic_norm(l, m.unsigned_abs());
    let sizes = exact.iter().map(|((l, m), c)| normalized(*l, *m, c));
    let largest = sizes.fold(0.0, f64::max);
    for (&(l, m), value) in got {
        let place = GivenNumber::Harmonic { l, m };
        let given = value.to_f64();
        let deviation;
        let list;
        let known = exact.remove(&(l, m));
        match &known {
            Some(c) if !value.is_zero() => {
                deviation = Deviation::between(value, c);
                list = &mut found.rows;
            }
            Some(c) => {
                deviation = Deviation::between(value, c);
                list = &mut found.missing;
            }
            None if value.is_zero() => continue,
            None => {
                // Its size relative to the largest harmonic.
                let share = normalized(l, m, value) / largest;
                let share = Rational::try_from(share).unwrap_or_else(|_| Rational::one());
                deviation = Deviation::between(&(Rational::one() + share), &Rational::one());
                list = &mut found.extra;
            }
        }
        list.push(Row {
            place,
            got: given,
            exact: known,
            deviation,
            residual: None,
        });
    }
    for ((l, m), c) in exact {
        found.missing.push(Row {
            place: GivenNumber::Harmonic { l, m },
            got: 0.0,
            deviation: Deviation::between(&Rational::zero(), &c),
            exact: Some(c),
            residual: None,
        });
    }
    found
}

fn compare_radii(
    radii: &[GivenSpaceRadius],
    values: &SphericalValues,
    limits: &Limits,
) -> Result<Comparison> {
    let rows = parallel::try_map(radii, limits, |given| {
        let exact = |x: f64| Rational::try_from(x).invariant("radii have been checked");
        let [theta, phi, got] = [given.theta, given.phi, given.r].map(exact);
        let (radius, deviation) =
            Deviation::enclosed(&got, BITS, |bits| values.bounds(&theta, &phi, bits));
        Ok(Row {
            place: GivenNumber::SpaceRadius {
                line: given.line,
                theta: given.theta,
                phi: given.phi,
            },
            got: given.r,
            exact: Some(radius),
            deviation,
            residual: None,
        })
    });
    Ok(Comparison {
        in_space: true,
        rows: rows?,
        ..Comparison::default()
    })
}

#[cfg(test)]
mod laws;
