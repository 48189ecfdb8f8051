//! The complex roots of a polynomial whose coefficients are known within bounds, as clusters that are proved to hold one distinct
//! root each.
//!
//! Lemma 1 (Smith 1970). Let p be monic of degree n, let z_1, …, z_n be distinct, and W_i = p(z_i)/Π_(j≠i) (z_i − z_j). All roots of
//! p are in the union of the discs |z − z_i| ≤ n |W_i|, and a connected component of k discs holds k roots with multiplicities.
//!
//! Lemma 2. Let p have N distinct roots. If the discs have N components, each holds one distinct root, whose multiplicity is the
//! number of its discs.
//! Proof. Each component holds at least one root, and there are no more distinct roots than components.
//!
//! Lemma 3. Let p be real, and let a component K as in Lemma 2 meet the real axis. If the mirror image of K meets no other
//! component, the root of K is real.
//! Proof. The conjugate of the root is a root, so it is in some component, which meets the mirror image of K. So it is in K, which
//! holds one distinct root.
//!
//! The number N of distinct roots is known from subresultants, so nothing depends on how near two roots are: the precision grows
//! until there are N components.
//!
//! Laws: `roots_are_found_with_their_multiplicities`, `the_bounds_of_the_coefficients_count`.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Abs, DivMod};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;
use nalgebra::Complex;

use super::fixed_point::{Point, log2};
use super::guess::guessed_roots;
use crate::error::{Error, Invariant};
use crate::exact::Dyadic;

/// The numbers of fractional bits that are tried.
pub(super) const PRECISIONS: [u64; 8] = [128, 256, 512, 1024, 2048, 4096, 8192, 16384];

/// A real root: an interval that holds it and no other root, and its multiplicity.
#[derive(Clone, Debug)]
pub(super) struct RealCluster {
    pub(super) low: Dyadic,
    pub(super) high: Dyadic,
    pub(super) multiplicity: usize,
}

/// A polynomial with integer coefficients between `low` and `high`, ascending, all over one common power of two, which cancels.
/// The leading coefficient is exact and not 0.
pub(super) struct Enclosed {
    pub(super) low: Vec<Integer>,
    pub(super) high: Vec<Integer>,
}

/// Finds the real roots of every polynomial of the enclosure that has `distinct` distinct complex roots, in intervals of at most
/// 2^−`bits`. `None` if this number of fractional bits is not enough.
pub(super) fn real_clusters(
    polynomial: &Enclosed,
    distinct: usize,
    bits: i64,
    precision: u64,
) -> Option<Vec<RealCluster>> {
    let is_narrow = |cluster: &RealCluster| {
        let width = cluster.high.minus(&cluster.low).log2();
        width.is_none_or(|width| width <= -bits)
    };
    let scaled = Scaled::new(polynomial, precision);
    let n = scaled.degree();
    let mut z = starts(&scaled);
    let sweeps = 24 + precision;
    for sweep in 0..sweeps {
        // The discs are looked at now and then, because that costs as much as a step.
        if (sweep % 3 == 0 || sweep < 2)
            && let Some(found) = scaled.components(&z, distinct)
            && found.iter().all(is_narrow)
        {
            return Some(found);
        }
        let mut moved = false;
        for i in 0..n {
            let step = scaled.correction(&z, i);
            moved |= step != Point::zero();
            z[i] = z[i].minus(&step).within_unit_disc(precision);
        }
        separate(&mut z, precision);
        if !moved {
            break;
        }
    }
    let found = scaled.components(&z, distinct)?;
    found.iter().all(is_narrow).then_some(found)
}

/// The monic polynomial p(z) = Σ c_j z^j with z = y/2^scale, so that all roots have |z| ≤ 1/2; the coefficients in units of
/// 2^−precision.
struct Scaled {
    coefficients: Vec<Integer>,
    /// Σ of the bounds of the errors of the coefficients, in the same units.
    error: Integer,
    scale: i64,
    precision: u64,
}

impl Scaled {
    fn new(polynomial: &Enclosed, precision: u64) -> Self {
        let n = polynomial.low.len() - 1;
        let lead = &polynomial.low[n];
        // |y| ≤ 2 max |c_(n−k)/c_n|^(1/k) (Fujiwara).
        let lead_bits = lead.significant_bits().cast_signed();
        let scale = (0..n)
            .filter_map(|j| {
                let largest = (&polynomial.low[j]).abs().max((&polynomial.high[j]).abs());
                let bits = largest.significant_bits().cast_signed();
                let k = i64::try_from(n - j).invariant("a degree is small");
                (largest != 0).then(|| (bits - lead_bits + 1).div_euclid(k) + 1)
            })
            .max()
            .map_or(0, |bits| bits + 2);
        let mut error = Integer::ZERO;
        let mut coefficients = Vec::with_capacity(n + 1);
        for j in 0..n {
            let k = i64::try_from(n - j).invariant("a degree is small");
            let shift = precision.cast_signed() - scale * k;
            // floor and ceiling of c_j 2^shift / lead
            let quotient = |c: &Integer, up: bool| {
                let (mut above, mut below) = (c.clone(), lead.clone());
                if shift >= 0 {
                    above <<= shift.unsigned_abs();
                } else {
                    below <<= shift.unsigned_abs();
                }
                let (quotient, rest) = above.div_mod(below);
                if up && rest != 0 {
                    quotient + Integer::ONE
                } else {
                    quotient
                }
            };
            let mut ends = [&polynomial.low[j], &polynomial.high[j]]
                .map(|c| [quotient(c, false), quotient(c, true)])
                .concat();
            ends.sort_unstable();
            let middle: Integer = (&ends[0] + &ends[3]) >> 1u64;
            error += (&ends[3] - &middle).max(&middle - &ends[0]);
            coefficients.push(middle);
        }
        coefficients.push(Integer::ONE << precision);
        Self {
            coefficients,
            error,
            scale,
            precision,
        }
    }

    fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// p(z) by Horner's rule. Each product is rounded down in both coordinates, by less than 2 units in absolute value, and
    /// |z| ≤ 1, so the error is below 2n units besides that of the coefficients.
    fn value(&self, z: &Point) -> Point {
        let mut value = Point::zero();
        for c in self.coefficients.iter().rev() {
            value = value.times(z).shifted_down(self.precision);
            value.re += c;
        }
        value
    }

    /// Aberth's correction of the i-th point, p/(p′ − p Σ 1/(z_i − z_j)), rounded. It only moves the points; the discs prove.
    fn correction(&self, z: &[Point], i: usize) -> Point {
        let mut value = Point::zero();
        let mut slope = Point::zero();
        for c in self.coefficients.iter().rev() {
            slope = slope.times(&z[i]).shifted_down(self.precision);
            slope.re += &value.re;
            slope.im += &value.im;
            value = value.times(&z[i]).shifted_down(self.precision);
            value.re += c;
        }
        let mut sum = Point::zero();
        for (_, other) in z.iter().enumerate().filter(|(j, _)| *j != i) {
            if let Some(inverse) = z[i].minus(other).inverse(self.precision) {
                sum.re += inverse.re;
                sum.im += inverse.im;
            }
        }
        let below = slope.minus(&value.times(&sum).shifted_down(self.precision));
        match below.inverse(self.precision) {
            Some(inverse) => value.times(&inverse).shifted_down(self.precision),
            None => Point::zero(),
        }
    }

    /// The real clusters, if the discs have `distinct` components and Lemma 3 decides which ones are real.
    fn components(&self, z: &[Point], distinct: usize) -> Option<Vec<RealCluster>> {
        let n = self.degree();
        let logs: Vec<Vec<f64>> = z
            .iter()
            .map(|a| z.iter().map(|b| a.minus(b).log2()).collect())
            .collect();
        let slack = &self.error + Integer::from(2 * n + 2);
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let (degree, precision) = (n as f64, self.precision as f64);
        // The binary logarithm of each radius in units of 2^−precision, rounded up: the logarithms are exact within 1e−9, and
        // there are less than 10^4 of them.
        let mut radii = Vec::with_capacity(n);
        for i in 0..n {
            let value = self.value(&z[i]);
            let size = log2(&(value.re.abs() + value.im.abs() + &slack));
            let others = (0..n).filter(|j| *j != i).map(|j| logs[i][j] - precision);
            let product: f64 = others.sum();
            if !product.is_finite() {
                return None;
            }
            radii.push(degree.log2() + size - product + 1e-3);
        }
        // Two discs can meet only if the distance of their centres is at most twice the larger radius.
        let apart =
            |distance: f64, i: usize, j: usize| distance > radii[i].max(radii[j]) + 1.0 + 1e-3;
        let mut group: Vec<usize> = (0..n).collect();
        for i in 0..n {
            for j in 0..i {
                if !apart(logs[i][j], i, j) && group[i] != group[j] {
                    let (from, to) = (group[i], group[j]);
                    group
                        .iter_mut()
                        .filter(|g| **g == from)
                        .for_each(|g| *g = to);
                }
            }
        }
        let mut names = group.clone();
        names.sort_unstable();
        names.dedup();
        assert!(
            names.len() <= distinct,
            "internal contradiction: {} separate groups of roots, but {distinct} distinct roots",
            names.len()
        );
        if names.len() < distinct {
            return None;
        }
        let mut found = Vec::new();
        for name in names {
            let members: Vec<usize> = (0..n).filter(|&i| group[i] == name).collect();
            let on_axis = members
                .iter()
                .any(|&i| log2(&(&z[i].im).abs()) <= radii[i] + 1e-3);
            if !on_axis {
                continue;
            }
            let clear = members.iter().all(|&i| {
                let mirrored = Point {
                    re: z[i].re.clone(),
                    im: -&z[i].im,
                };
                (0..n)
                    .filter(|&j| group[j] != name)
                    .all(|j| apart(mirrored.minus(&z[j]).log2(), i, j))
            });
            if !clear {
                return None;
            }
            found.push(self.interval(z, &radii, &members)?);
        }
        found.sort_unstable_by(|a, b| a.low.cmp(&b.low));
        found
            .windows(2)
            .all(|pair| pair[0].high < pair[1].low)
            .then_some(found)
    }

    /// The interval of the real axis in which the discs of a component are.
    fn interval(&self, z: &[Point], radii: &[f64], members: &[usize]) -> Option<RealCluster> {
        let mut ends: Option<(Integer, Integer)> = None;
        for &i in members {
            #[expect(clippy::cast_possible_truncation, reason = "checked to be small")]
            let exponent = radii[i].ceil().max(0.0) as i64;
            if exponent > self.precision.cast_signed() {
                return None;
            }
            let radius = Integer::ONE << exponent.unsigned_abs();
            let (low, high) = (&z[i].re - &radius, &z[i].re + &radius);
            ends = Some(match ends {
                None => (low, high),
                Some((a, b)) => (a.min(low), b.max(high)),
            });
        }
        let (low, high) = ends?;
        let exponent = self.scale - self.precision.cast_signed();
        Some(RealCluster {
            low: Dyadic::new(low, exponent),
            high: Dyadic::new(high, exponent),
            multiplicity: members.len(),
        })
    }
}

/// Moves points that coincide apart, because the discs need distinct points: by about the square root of a unit, as far as the
/// approximations of a double root are apart.
fn separate(z: &mut [Point], precision: u64) {
    for i in 1..z.len() {
        let mut times = 1u64;
        while z[..i].contains(&z[i]) {
            z[i].re += Integer::from(times) << (precision / 2);
            times += 1;
        }
    }
}

/// First approximations, from doubles.
fn starts(scaled: &Scaled) -> Vec<Point> {
    let coefficients: Vec<f64> = scaled
        .coefficients
        .iter()
        .map(|c| Dyadic::new(c.clone(), -scaled.precision.cast_signed()).to_f64())
        .collect();
    let guesses = guessed_roots(&coefficients);
    let point = |z: &Complex<f64>| {
        let part = |x: f64| {
            let in_units = Dyadic::from_f64(x).unwrap_or_else(Dyadic::zero);
            in_units.in_units(scaled.precision, RoundingMode::Floor)
        };
        let point = Point {
            re: part(z.re),
            im: part(z.im),
        };
        point.within_unit_disc(scaled.precision)
    };
    let mut z: Vec<Point> = guesses.iter().map(point).collect();
    separate(&mut z, scaled.precision);
    z
}

/// The error for a fibre that needs more bits than the largest precision.
pub(super) fn too_near(at: &str) -> Error {
    Error::limit(format!(
        "the points of the curve above {at} are nearer to each other than 2^-{}",
        PRECISIONS[PRECISIONS.len() - 1]
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn product(roots: &[(i64, i64)]) -> Vec<Integer> {
        // Π (q y − p)
        roots.iter().fold(vec![Integer::ONE], |f, &(p, q)| {
            let mut g = vec![Integer::ZERO; f.len() + 1];
            for (i, c) in f.iter().enumerate() {
                g[i] -= c * Integer::from(p);
                g[i + 1] += c * Integer::from(q);
            }
            g
        })
    }

    fn times(f: &[Integer], g: &[i64]) -> Vec<Integer> {
        let mut h = vec![Integer::ZERO; f.len() + g.len() - 1];
        for (i, a) in f.iter().enumerate() {
            for (j, &b) in g.iter().enumerate() {
                h[i + j] += a * Integer::from(b);
            }
        }
        h
    }

    fn found(f: &[Integer], distinct: usize) -> Vec<RealCluster> {
        let enclosed = Enclosed {
            low: f.to_vec(),
            high: f.to_vec(),
        };
        PRECISIONS
            .iter()
            .find_map(|&bits| real_clusters(&enclosed, distinct, 0, bits))
            .unwrap()
    }

    proptest! {
        #[test]
        fn roots_are_found_with_their_multiplicities(
            roots in prop::collection::btree_map((-40i64..40, prop::sample::select(vec![1i64, 7, 1_000_003])), 1usize..4, 1..5),
            pairs in 0usize..3,
        ) {
            let mut exact: Vec<(crate::exact::Rational, usize)> = Vec::new();
            let mut list = Vec::new();
            for (&(p, q), &m) in &roots {
                let value = crate::exact::Rational::from(p) / crate::exact::Rational::from(q);
                match exact.iter_mut().find(|(v, _)| *v == value) {
                    Some((_, k)) => *k += m,
                    None => exact.push((value, m)),
                }
                list.extend(std::iter::repeat_n((p, q), m));
            }
            exact.sort_unstable();
            let mut f = product(&list);
            let mut distinct = exact.len();
            for k in 0..pairs {
                // Two conjugate roots that are near the axis, each double.
                let factor = [i64::try_from(k).unwrap() * 1000 + 1, 0, 1_000_000];
                f = times(&times(&f, &factor), &factor);
                distinct += 2;
            }
            let clusters = found(&f, distinct);
            prop_assert_eq!(clusters.len(), exact.len());
            for (cluster, (value, m)) in clusters.iter().zip(&exact) {
                prop_assert_eq!(cluster.multiplicity, *m);
                prop_assert!(cluster.low.to_rational() <= *value && *value <= cluster.high.to_rational());
            }
        }

        /// Within wide coefficients a double root is not told from two near ones.
        #[test]
        fn the_bounds_of_the_coefficients_count(p in -9i64..9) {
            let f = times(&product(&[(p, 1), (p, 1)]), &[1 << 20]);
            let mut high = f.clone();
            high[0] += Integer::ONE;
            let enclosed = Enclosed { low: f, high };
            for bits in [128, 256] {
                prop_assert!(real_clusters(&enclosed, 2, 0, bits).is_none());
            }
        }
    }
}
