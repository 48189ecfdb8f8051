//! The coefficients of a mesh in normalised harmonics, and the errors of their sums.

use nalgebra::{Cholesky, DMatrix, DVector, Vector3};

use super::nodes::{as_f64, gauss_legendre, turns};
use super::rays::Rays;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::shape::{NormalizedHarmonics, harmonic_norm};

/// The least and the largest number of latitudes by default.
const LATITUDES: [usize; 2] = [64, 512];
/// The largest number of sampled directions.
pub(super) const MOST_SAMPLES: usize = 1 << 23;
/// The largest degree of least squares, which have (L + 1)⁴ sums.
const MOST_LEAST_SQUARES: usize = 40;

/// The radii at the nodes of Gauss and Legendre by equal angles.
pub(super) struct Samples {
    /// cos φ and its weight, which add up to 1.
    latitudes: Vec<[f64; 2]>,
    /// The cosines and sines of the angles θ.
    turns: Vec<[f64; 2]>,
    /// The radii, by latitudes.
    radii: Vec<f64>,
}

/// The error of a sum up to some degree.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Deviation {
    pub(super) largest: f64,
    /// The direction of the largest error.
    pub(super) at: [f64; 3],
    pub(super) mean_square: f64,
}

impl Samples {
    pub(super) fn new(
        rays: &mut Rays<'_>,
        degree: usize,
        asked: Option<usize>,
        limits: &Limits,
    ) -> Result<Self> {
        let [least, most] = LATITUDES;
        let default = rays.triangles().isqrt().clamp(least, most);
        let rows = asked
            .map_or(default, |n| n.div_ceil(2).isqrt().max(1))
            .max(degree + 1);
        if 2 * rows * rows > MOST_SAMPLES {
            return Err(Error::limit(format!(
                "more than {MOST_SAMPLES} sampled directions"
            )));
        }
        let turns = turns(2 * rows + 1);
        let latitudes: Vec<[f64; 2]> = gauss_legendre(rows)
            .into_iter()
            .map(|[z, w]| [z, w / 2.0])
            .collect();
        let mut radii = Vec::with_capacity(latitudes.len() * turns.len());
        for [z, _] in &latitudes {
            limits.check()?;
            let sine = (1.0 - z * z).sqrt();
            radii.extend(
                turns
                    .iter()
                    .map(|[c, s]| rays.radius([sine * c, sine * s, *z])),
            );
        }
        Ok(Self {
            latitudes,
            turns,
            radii,
        })
    }

    pub(super) fn len(&self) -> usize {
        self.radii.len()
    }

    /// The largest errors, over all samples, the vertices and the points of triangles and edges that are nearest to the center, and the mean squares over the samples, of the sums up to each degree.
    pub(super) fn errors(
        &self,
        rays: &Rays<'_>,
        coefficients: &[f64],
        degree: usize,
        limits: &Limits,
    ) -> Result<Vec<Deviation>> {
        let mut basis = NormalizedHarmonics::new(degree);
        let mut values = vec![0.0; coefficients.len()];
        let mut found = vec![Deviation::default(); degree + 1];
        let mut add = |direction: [f64; 3], radius: f64, weight: f64| {
            basis.values(direction, &mut values);
            let mut rest = radius;
            for (l, found) in found.iter_mut().enumerate() {
                let range = l * l..(l + 1) * (l + 1);
                let part = coefficients[range.clone()].iter().zip(&values[range]);
                rest -= part.map(|(c, y)| c * y).sum::<f64>();
                if rest.abs() > found.largest {
                    (found.largest, found.at) = (rest.abs(), direction);
                }
                found.mean_square += weight * rest * rest;
            }
        };
        let rows = self.radii.chunks(self.turns.len());
        for ([z, weight], row) in self.latitudes.iter().zip(rows) {
            limits.check()?;
            let sine = (1.0 - z * z).sqrt();
            let weight = weight / as_f64(self.turns.len());
            for ([c, s], radius) in self.turns.iter().zip(row) {
                add([sine * c, sine * s, *z], *radius, weight);
            }
        }
        for (direction, radius) in rays.vertices().chain(rays.feet()) {
            add(direction, radius, 0.0);
        }
        Ok(found)
    }
}

impl Samples {
    /// The largest error of the sum up to a degree near the direction of its largest sampled error. From there it climbs in steps
    /// that begin with the distance of two samples and are halved where no step leads higher.
    pub(super) fn largest_near(
        &self,
        sampled: &Deviation,
        rays: &mut Rays<'_>,
        coefficients: &[f64],
        degree: usize,
    ) -> f64 {
        /// The directions of steps, which are turned after each round, because the highest point may be on a ridge.
        const WAYS: u32 = 12;
        /// Rounds, of which about forty halve the step down to the precision of doubles.
        const ROUNDS: u32 = 100;
        let mut basis = NormalizedHarmonics::new(degree);
        let mut values = vec![0.0; (degree + 1) * (degree + 1)];
        let mut error = |direction: [f64; 3]| {
            basis.values(direction, &mut values);
            let sum: f64 = coefficients.iter().zip(&values).map(|(c, y)| c * y).sum();
            (rays.radius(direction) - sum).abs()
        };
        if sampled.largest == 0.0 {
            return 0.0;
        }
        let (mut at, mut largest) = (Vector3::from(sampled.at), sampled.largest);
        let mut step = std::f64::consts::PI / as_f64(self.latitudes.len());
        for round in 0..ROUNDS {
            let axis = if at.x.abs() < 0.8 {
                Vector3::x()
            } else {
                Vector3::y()
            };
            let u = at.cross(&axis).normalize();
            let v = at.cross(&u);
            let steps = (0..WAYS).map(|k| {
                let turn = f64::from(k) / f64::from(WAYS) + f64::from(round) / 7.0;
                let angle = std::f64::consts::TAU * turn;
                (at + step * (angle.cos() * u + angle.sin() * v)).normalize()
            });
            let next = steps.map(|to| (error(to.into()), to));
            let next = next.max_by(|a, b| a.0.total_cmp(&b.0));
            match next {
                Some((value, to)) if value > largest => (largest, at) = (value, to),
                _ => step /= 2.0,
            }
        }
        largest
    }
}

/// The means over the sphere of the radius times each harmonic.
pub(super) fn quadrature(samples: &Samples, degree: usize, limits: &Limits) -> Result<Vec<f64>> {
    let mut basis = NormalizedHarmonics::new(degree);
    let mut found = vec![0.0; (degree + 1) * (degree + 1)];
    let count = samples.turns.len();
    let rows = samples.radii.chunks(count);
    for ([z, weight], row) in samples.latitudes.iter().zip(rows) {
        limits.check()?;
        let legendre = basis.latitude(*z, (1.0 - z * z).sqrt());
        for m in 0..=degree {
            let (mut cosines, mut sines) = (0.0, 0.0);
            for (j, radius) in row.iter().enumerate() {
                let [c, s] = samples.turns[m * j % count];
                cosines += radius * c;
                sines += radius * s;
            }
            let share = weight / as_f64(count);
            for l in m..=degree {
                let value = legendre[l * (l + 1) / 2 + m] * share;
                found[l * l + l + m] += value * cosines;
                if m > 0 {
                    found[l * l + l - m] += value * sines;
                }
            }
        }
    }
    Ok(found)
}

/// The coefficients with the least weighted squares of the errors at the vertices.
pub(super) fn least_squares(rays: &Rays<'_>, degree: usize, limits: &Limits) -> Result<Vec<f64>> {
    if degree > MOST_LEAST_SQUARES {
        return Err(Error::limit(format!(
            "least squares of a degree beyond {MOST_LEAST_SQUARES}"
        )));
    }
    let count = (degree + 1) * (degree + 1);
    let weights = rays.weights();
    if weights.len() < count {
        return Err(Error::Usage(format!(
            "the mesh has {} vertices, fewer than the {count} coefficients of degree {degree}",
            weights.len()
        )));
    }
    let mut basis = NormalizedHarmonics::new(degree);
    let mut values = vec![0.0; count];
    let mut products = DMatrix::<f64>::zeros(count, count);
    let mut sums = DVector::<f64>::zeros(count);
    for ((direction, radius), weight) in rays.vertices().zip(weights) {
        limits.check()?;
        basis.values(direction, &mut values);
        for (j, y) in values.iter().enumerate() {
            let factor = weight * y;
            sums[j] += factor * radius;
            // The lower triangle of the column.
            for (sum, x) in products.column_mut(j).iter_mut().skip(j).zip(&values[j..]) {
                *sum += factor * x;
            }
        }
    }
    let found = Cholesky::new(products).map(|factors| factors.solve(&sums));
    found.map(|x| x.as_slice().to_vec()).ok_or_else(|| {
        Error::Usage(format!(
            "the vertices do not determine the {count} coefficients of degree {degree}"
        ))
    })
}

/// The terms c Y(l, m), each c the exact value of a double.
pub(super) fn unnormalised(
    coefficients: &[f64],
    degree: usize,
) -> Result<Vec<((usize, isize), Rational)>> {
    let mut terms = Vec::new();
    for l in 0..=degree {
        for (k, c) in coefficients[l * l..(l + 1) * (l + 1)].iter().enumerate() {
            let m = k.cast_signed() - l.cast_signed();
            let value = Rational::try_from(c * harmonic_norm(l, m.unsigned_abs()));
            let value =
                value.map_err(|_| Error::limit("coefficients within the range of doubles"))?;
            terms.push(((l, m), value));
        }
    }
    Ok(terms)
}
