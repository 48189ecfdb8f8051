//! All complex numbers z outside the unit circle at which two trigonometric polynomials of z = e^(it) are both real.
//!
//! The plane outside the circle is divided into boxes in log z, down to the circle and out to a radius beyond which one of the
//! leading terms is never balanced. A box is excluded by a bound, or it lies in a disk that is proved to hold exactly one zero;
//! else it is divided.

use nalgebra::Complex;
use rayon::prelude::*;

use super::expansion::{COVER, Expansion, Inverted, Powers, Wave};
use crate::error::{Error, Invariant, Result};
use crate::limits::Limits;

/// The most boxes for one sector of the first division, and the most divisions of a box. General curves of 4 to 60 harmonics need
/// up to 300 boxes in a sector and 6 divisions.
const MAX_BOXES: usize = 6000;
const MAX_DIVISIONS: u32 = 22;

/// The most steps of Newton's method.
const MAX_STEPS: usize = 12;

/// A number z whose disk |log(z′/z)| ≤ `reach` holds exactly one zero; that is at most `error` away.
#[derive(Clone, Copy, Debug)]
pub(super) struct Zero {
    pub(super) z: Complex<f64>,
    pub(super) reach: f64,
    pub(super) error: f64,
    /// Bounds of the slopes of both coordinates in the disk.
    pub(super) slopes: [f64; 2],
    /// Both coordinates at z, and the derivative.
    pub(super) expansions: [Expansion; 2],
}

/// The ratio |G(ζ) − ζ − G(ζ′) + ζ′|/|ζ − ζ′| that a disk of a zero has at most.
pub(super) const MAX_CONTRACTION: f64 = 0.5;

/// A part of a sector: between two turns and two radii.
#[derive(Clone, Copy, Debug)]
struct Cell {
    turns: [f64; 2],
    radii: [f64; 2],
    divisions: u32,
}

/// A middle direction and the half angle of a sector.
///
/// Lemma 4. For points P, Q with ||P| − 1|, ||Q| − 1| ≤ 2^(−50) and a chord c = |P − Q| ≤ 1 the angle between them is at most
/// (c + 2^(−48)) (1 + c²/16).
/// Proof. The chord c′ of the projections is at most c + 2^(−49), and arcsin s ≤ s (1 + s²/5) for s = c′/2 ≤ 1/2 + 2^(−50).
///
/// The sectors cover the circle whatever the errors of sine and cosine are, because a sector holds its two ends, the ends are
/// those of its neighbours, and from one to the next the direction turns to the left by less than a half turn.
fn sector(turns: [f64; 2]) -> (Complex<f64>, f64) {
    let direction = |turn: f64| {
        let (sin, cos) = (std::f64::consts::TAU * (turn % 1.0)).sin_cos();
        Complex::new(cos, sin)
    };
    let middle = direction(f64::midpoint(turns[0], turns[1]));
    let ends = turns.map(direction);
    let is_left = |p: Complex<f64>, q: Complex<f64>| (p.conj() * q).im > 0.0;
    let is_right = [middle, ends[0], ends[1]]
        .iter()
        .all(|p| (p.norm_sqr() - 1.0).abs() <= 4.0 * f64::EPSILON);
    let chord = (ends[0] - middle).norm().max((ends[1] - middle).norm());
    let fits = is_right && chord <= 1.0 && is_left(ends[0], middle) && is_left(middle, ends[1]);
    let half = if fits {
        (chord + 16.0 * f64::EPSILON) * (1.0 + chord * chord / 16.0) * COVER
    } else {
        f64::INFINITY
    };
    (middle, half)
}

/// A bound of |log(a/b)|, of the branch near 0.
pub(super) fn log_distance(a: Complex<f64>, b: Complex<f64>) -> f64 {
    let off = (a / b - 1.0).norm() + 8.0 * f64::EPSILON;
    if off < 0.5 {
        off / (1.0 - off) * COVER
    } else {
        f64::INFINITY
    }
}

/// The coordinates along the unit circle.
#[derive(Debug)]
pub(super) struct Arc {
    turns: [f64; 2],
    half: f64,
    expansions: [Expansion; 2],
}

/// The search for the zeros of the imaginary parts of two coordinates.
#[derive(Debug)]
pub(super) struct Search {
    waves: [Wave; 2],
    sectors: u32,
}

impl Search {
    pub(super) fn new(waves: [Wave; 2]) -> Self {
        let degree = waves[0].degree().max(waves[1].degree());
        // With sectors of half angle π/n the disk about a box of the first division has the radius √2 π/n.
        let sectors = (5 * degree).max(16).next_power_of_two();
        Self {
            waves,
            sectors: u32::try_from(sectors).invariant("a degree in memory is small"),
        }
    }

    pub(super) fn expansions(&self, z: Complex<f64>) -> [Expansion; 2] {
        let [x, y] = &self.waves;
        let powers = Powers::new(z, x.degree().max(y.degree()));
        [Expansion::new(x, &powers), Expansion::new(y, &powers)]
    }

    fn turns(&self) -> impl IndexedParallelIterator<Item = [f64; 2]> {
        let count = f64::from(self.sectors);
        (0..self.sectors)
            .into_par_iter()
            .map(move |k| [f64::from(k) / count, (f64::from(k) + 1.0) / count])
    }

    /// All zeros outside the unit circle; `None` if they are not found.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(super) fn zeros(&self, limits: &Limits) -> Result<Option<Vec<Zero>>> {
        let Some(last) = self.last_radius() else {
            return Ok(None);
        };
        // The first sector whose zeros are not found ends the search.
        let found: std::result::Result<Vec<Vec<Zero>>, Option<Error>> = self
            .turns()
            .map(|turns| {
                limits.check().map_err(Some)?;
                self.zeros_in_sector(turns, last).ok_or(None)
            })
            .collect();
        match found {
            Ok(zeros) => Ok(distinct(zeros.into_iter().flatten())),
            Err(None) => Ok(None),
            Err(Some(error)) => Err(error),
        }
    }

    /// The zeros in a sector, perhaps repeatedly, and perhaps with some beyond the sector.
    fn zeros_in_sector(&self, turns: [f64; 2], last: f64) -> Option<Vec<Zero>> {
        let width = std::f64::consts::TAU / f64::from(self.sectors);
        let mut open = Vec::new();
        let mut low = 1.0;
        while low < last {
            let high = low * (1.0 + width);
            open.push(Cell {
                turns,
                radii: [low, high],
                divisions: 0,
            });
            low = high;
        }
        let mut zeros: Vec<Zero> = Vec::new();
        let mut boxes = 0;
        while let Some(cell) = open.pop() {
            boxes += 1;
            if boxes > MAX_BOXES {
                return None;
            }
            if self.is_done(&cell, &mut zeros) {
                continue;
            }
            if cell.divisions == MAX_DIVISIONS {
                return None;
            }
            open.extend(cell.divided());
        }
        Some(zeros)
    }

    /// Whether a cell is proved to have no zero but those in the list, to which a zero may be added.
    fn is_done(&self, cell: &Cell, zeros: &mut Vec<Zero>) -> bool {
        let (middle, half) = sector(cell.turns);
        let [low, high] = cell.radii;
        if low <= 1.0 {
            let radius = half.hypot(high - 1.0) * COVER;
            let [x, y] = self.expansions(middle);
            // The combination along the tangent has the largest derivative.
            let [along, up] = [&x, &y].map(|f| f.derivative().im);
            return x
                .combination(along, &y, up)
                .is_never_real_beside_circle(radius);
        }
        let radius = f64::midpoint(low, high);
        let z = middle * radius;
        let outward = ((high - radius) / radius).max((radius - low) / low) * COVER + 1e-14;
        let around = half + 1e-14;
        let reach = around.hypot(outward) * COVER;
        let is_covered = |zero: &Zero| log_distance(z, zero.z) + reach <= zero.reach;
        if zeros.iter().any(is_covered) {
            return true;
        }
        let expansions = self.expansions(z);
        if expansions.iter().any(|f| f.is_never_real(around, outward)) {
            return true;
        }
        let inverted = Inverted::new(&expansions);
        if inverted.is_never_real(around, outward) {
            return true;
        }
        if inverted.contraction(reach) >= 1.0 {
            return false;
        }
        match self.zero_near(z, reach) {
            Some(zero) => {
                zeros.push(zero);
                true
            }
            None => false,
        }
    }

    /// A zero near a number, with a disk that holds the disk of this radius about the number.
    ///
    /// Lemma 5. If the bound κ of [`Inverted::contraction`] for a radius ρ and the bound g of [`Inverted::value`] have κ < 1 and g ≤
    /// (1 − κ)ρ, the disk |ζ| ≤ ρ holds exactly one zero of both imaginary parts, with |ζ| ≤ g/(1 − κ).
    /// Proof. ζ ↦ ζ − G(ζ) contracts the disk into itself (Banach), and the matrix of the combinations is invertible.
    /// Law: `zeros_that_were_built_in_are_found`.
    fn zero_near(&self, start: Complex<f64>, radius: f64) -> Option<Zero> {
        let mut z = start;
        for _ in 0..MAX_STEPS {
            let step = Inverted::new(&self.expansions(z)).step();
            let size = step.norm();
            if size.is_nan() || size > 4.0 * radius {
                return None;
            }
            z *= step.exp();
            if size < 1e-13 {
                break;
            }
        }
        let expansions = self.expansions(z);
        let inverted = Inverted::new(&expansions);
        let reach = (log_distance(z, start) + radius) * COVER;
        let contraction = inverted.contraction(reach);
        let value = inverted.value();
        let error = value / (1.0 - contraction) * COVER;
        let is_outside = z.norm() * (1.0 - error) > COVER;
        let is_proved = contraction <= MAX_CONTRACTION && error <= reach && is_outside;
        is_proved.then(|| Zero {
            z,
            reach,
            error,
            slopes: expansions.each_ref().map(Expansion::slope),
            expansions,
        })
    }

    /// A radius beyond which there are no zeros; `None` if none was found.
    ///
    /// Lemma 6. If a real combination of the coordinates of degree N has a leading term with |Im(C z^N)| > Σ_(k<N) |C_k| (|z|^k +
    /// |z|^(−k)) + |C| |z|^(−N) at |z| = r, for all z of a sector, it is not real at |z| ≥ r in this sector.
    /// Proof. Divided by |z|^N the left side depends on the angle alone, and the right side decreases.
    fn last_radius(&self) -> Option<f64> {
        let [x, y] = &self.waves;
        let degree = i32::try_from(x.degree().max(y.degree()));
        let degree = degree.invariant("a degree in memory is small");
        let step: f64 = 1.0 + 1.0 / 8.0;
        let radii = std::iter::successors(Some(1.0 + 1.0 / 8.0), |r| Some(r * step));
        // Powers of radii must be doubles.
        let radii = radii.take(150);
        radii
            .take_while(|r: &f64| r.powi(degree).is_finite())
            .find(|&radius| {
                if x.degree() == y.degree() {
                    leading_terms_prevail([x, y], radius)
                } else {
                    let sectors = self.turns().collect::<Vec<_>>();
                    let bounds = [x, y].map(|wave| lower_terms(wave, radius));
                    sectors
                        .into_iter()
                        .all(|turns| is_clear([x, y], bounds, turns, 10))
                }
            })
    }

    /// The expansions along the unit circle.
    pub(super) fn arcs(&self) -> Vec<Arc> {
        self.turns().map(|turns| self.arc(turns)).collect()
    }

    fn arc(&self, turns: [f64; 2]) -> Arc {
        let (middle, half) = sector(turns);
        Arc {
            turns,
            half,
            expansions: self.expansions(middle),
        }
    }

    /// Whether it is proved that the real curve does not pass through the point of a zero.
    pub(super) fn is_off_the_curve(&self, arcs: &[Arc], zero: &Zero) -> bool {
        let point = zero.expansions.map(|f| f.value().re);
        let errors: [f64; 2] = std::array::from_fn(|i| {
            (zero.expansions[i].error() + zero.slopes[i] * zero.error) * COVER
        });
        let misses = |arc: &Arc| {
            let [x, y] = &arc.expansions;
            let apart = |f: &Expansion, [alpha, beta]: [f64; 2]| {
                let value = alpha * point[0] + beta * point[1];
                let error = alpha.abs() * (errors[0] + 4.0 * f64::EPSILON * point[0].abs())
                    + beta.abs() * (errors[1] + 4.0 * f64::EPSILON * point[1].abs());
                f.never_has(value, error * COVER, arc.half)
            };
            let [along, up] = [x, y].map(|f| f.derivative().im);
            apart(x, [1.0, 0.0])
                || apart(y, [0.0, 1.0])
                || apart(&x.combination(-up, y, along), [-up, along])
        };
        let mut open: Vec<([f64; 2], u32)> = Vec::new();
        for arc in arcs.iter().filter(|arc| !misses(arc)) {
            open.extend(halves(arc.turns).map(|turns| (turns, 1)));
        }
        while let Some((turns, divisions)) = open.pop() {
            if misses(&self.arc(turns)) {
                continue;
            }
            if divisions == MAX_DIVISIONS {
                return false;
            }
            open.extend(halves(turns).map(|turns| (turns, divisions + 1)));
        }
        true
    }
}

fn halves([low, high]: [f64; 2]) -> [[f64; 2]; 2] {
    let middle = f64::midpoint(low, high);
    [[low, middle], [middle, high]]
}

impl Cell {
    fn divided(&self) -> [Self; 4] {
        let (turns, radii) = (halves(self.turns), halves(self.radii));
        std::array::from_fn(|k| Self {
            turns: turns[k / 2],
            radii: radii[k % 2],
            divisions: self.divisions + 1,
        })
    }
}

/// The zeros without repetitions; `None` if it is not decided whether two are the same.
fn distinct(zeros: impl Iterator<Item = Zero>) -> Option<Vec<Zero>> {
    let mut different: Vec<Zero> = Vec::new();
    for zero in zeros {
        let mut is_new = true;
        for other in &different {
            let errors = zero.error + other.error;
            let off = (zero.z / other.z - 1.0).norm();
            let is_same = log_distance(zero.z, other.z) + errors <= zero.reach.max(other.reach);
            if is_same {
                is_new = false;
            } else if off <= 4.0 * errors + 64.0 * f64::EPSILON {
                return None;
            }
        }
        if is_new {
            different.push(zero);
        }
    }
    Some(different)
}

/// Σ_(k<N) |C_k| (r^k + r^(−k)) + |C_N| r^(−N), divided by r^N.
fn lower_terms(wave: &Wave, radius: f64) -> f64 {
    let (leading, lower) = match wave.coefficients().split_last() {
        Some(parts) => parts,
        None => return f64::INFINITY,
    };
    let (mut up, mut down) = (1.0, 1.0);
    let mut sum = 0.0;
    for c in lower {
        sum += c.norm() * (up + down);
        up *= radius;
        down /= radius;
    }
    (sum + leading.norm() * down) / up * COVER
}

/// Lemma 6 for two coordinates of the same degree: whether L(z^N), the pair of the imaginary parts of the leading terms, is larger
/// than all other terms together, after multiplication by the inverse of the real linear map L.
fn leading_terms_prevail([x, y]: [&Wave; 2], radius: f64) -> bool {
    let pairs = x.coefficients().iter().zip(y.coefficients());
    let pairs: Vec<_> = pairs.collect();
    let Some(((c, d), lower)) = pairs.split_last() else {
        return false;
    };
    let determinant = c.re * d.im - c.im * d.re;
    // The matrices of L, which maps (Im w, Re w) to (Im C w, Im D w), have the rows (Re C, Im C) and (Re D, Im D).
    let size = |e: &Complex<f64>, f: &Complex<f64>| {
        let entries = [
            d.im * e.re - c.im * f.re,
            d.im * e.im - c.im * f.im,
            c.re * f.re - d.re * e.re,
            c.re * f.im - d.re * e.im,
        ];
        // Each entry has an error of at most three units of its products.
        let products = (c.norm() + d.norm()) * (e.norm() + f.norm()) * 8.0 * f64::EPSILON;
        let squares: f64 = entries
            .map(|e| (e.abs() + products) * (e.abs() + products))
            .iter()
            .sum();
        squares.sqrt() / determinant.abs()
    };
    let (mut up, mut down) = (1.0, 1.0);
    let mut sum = 0.0;
    for (e, f) in lower {
        sum += size(e, f) * (up + down);
        up *= radius;
        down /= radius;
    }
    let products = (c.norm() * d.norm()) * 8.0 * f64::EPSILON;
    let is_invertible = determinant.abs() > products * 1024.0;
    is_invertible && (sum + size(c, d) * down) * (1.0 + 1.0 / 128.0) < up
}

/// Lemma 6 for coordinates of different degrees: whether one of the two leading terms prevails in each part of the sector.
fn is_clear(waves: [&Wave; 2], bounds: [f64; 2], turns: [f64; 2], divisions: u32) -> bool {
    let (direction, half) = sector(turns);
    let prevails = |wave: &Wave, bound: f64| {
        let degree = wave.degree();
        let Some(c) = wave.coefficients().last() else {
            return false;
        };
        let Ok(exponent) = i32::try_from(degree) else {
            return false;
        };
        let off = c.norm() * f64::from(exponent) * (half + 64.0 * f64::EPSILON);
        (c * direction.powi(exponent)).im.abs() > (off + bound) * COVER
    };
    if prevails(waves[0], bounds[0]) || prevails(waves[1], bounds[1]) {
        return true;
    }
    let mut parts = halves(turns).into_iter();
    divisions > 0 && parts.all(|turns| is_clear(waves, bounds, turns, divisions - 1))
}
