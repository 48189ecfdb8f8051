//! The places of a curve above one point of the line, modulo a prime: Newton polygons and Duval's rational Puiseux series.
//!
//! Let H(u, v) be a polynomial over a field whose characteristic is larger than its degree in v. The roots v(u) of H that vanish at
//! u = 0 are series in fractional powers of u. An edge of the Newton polygon from (i + kq, j) to (i, j + km), gcd(q, m) = 1, belongs
//! to kq roots of valuation m/q. Each simple root ξ of its polynomial φ belongs to one place with ramification index q; at a
//! multiple root the substitution u = ξ^w U^q, v = U^m (ξ^z + V), zq − wm = 1, leads on (Duval 1989).
//!
//! The valuation of the discriminant is the sum of the valuations of the differences of all pairs of roots, which the polygons give,
//! too. So the result is checked against the discriminant.

use std::collections::BTreeMap;

use crate::exact::Rational;
use crate::modular::{PrimeField, equal_degree, trimmed};

/// A place of a curve at a point: e = ord(u), and the multiplicity min(ord(u), ord(v)) of its branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Place {
    pub(super) ramification: usize,
    pub(super) multiplicity: usize,
}

/// The places of a curve at a point (0, v0) whose multiplicity in the fibre is at least 2.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct LocalType {
    /// The multiplicity of v0 as a root of the fibre.
    pub(super) fibre_multiplicity: usize,
    /// The valuation of the discriminant of the local factor: the intersection number of the curve and ∂f/∂v = 0.
    pub(super) intersection: usize,
    /// The places, ascending.
    pub(super) places: Vec<Place>,
    /// The number of different tangents of the branches.
    pub(super) tangents: usize,
}

impl LocalType {
    /// Milnor's number μ, by Teissier's formula: the intersection number with ∂f/∂v is μ + (fibre multiplicity) − 1.
    pub(super) fn milnor(&self) -> usize {
        self.intersection + 1 - self.fibre_multiplicity
    }

    /// δ = (μ + number of branches − 1)/2.
    pub(super) fn delta(&self) -> usize {
        (self.milnor() + self.places.len() - 1) / 2
    }

    /// The multiplicity of the point on the curve.
    pub(super) fn multiplicity(&self) -> usize {
        self.places.iter().map(|place| place.multiplicity).sum()
    }

    /// Σ (e − 1) over the places.
    pub(super) fn ramification(&self) -> usize {
        self.places.iter().map(|place| place.ramification - 1).sum()
    }
}

/// A polynomial in u and v modulo u^precision: for each power of v the coefficients of the powers of u.
struct Local {
    rows: Vec<Vec<u64>>,
    precision: usize,
}

impl Local {
    fn order(&self, i: usize) -> Option<usize> {
        self.rows[i].iter().position(|c| *c != 0)
    }

    /// The points (i, j) of the lowest terms v^i u^j up to v^multiplicity.
    fn points(&self, multiplicity: usize) -> Vec<(usize, usize)> {
        (0..=multiplicity)
            .filter_map(|i| Some((i, self.order(i)?)))
            .collect()
    }
}

/// Why the places cannot be found modulo this prime.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct NotSplit;

/// The types of all points (0, v) at which the fibre Σ rows_i(0) v^i has a multiple root. `rows` must be known modulo u^precision,
/// where the discriminant has a lower valuation.
///
/// # Errors
/// [`NotSplit`] if some multiple root is not in the prime field.
pub(super) fn types_above_zero(
    field: &PrimeField,
    rows: &[Vec<u64>],
    precision: usize,
) -> Result<Vec<LocalType>, NotSplit> {
    let fibre = trimmed(rows.iter().map(|row| coefficient(row, 0)).collect());
    let mut types = Vec::new();
    for (multiplicity, root) in multiple_roots(field, &fibre)? {
        let width = rows.iter().map(Vec::len).max().unwrap_or(0).min(precision);
        let columns: Vec<Vec<u64>> = (0..width)
            .map(|j| rows.iter().map(|row| coefficient(row, j)).collect())
            .map(|column| field.shifted(column, root))
            .collect();
        let shifted = (0..rows.len())
            .map(|i| columns.iter().map(|column| column[i]).collect())
            .collect();
        let local = Local {
            rows: shifted,
            precision,
        };
        let mut walk = Walk {
            field,
            places: Vec::new(),
        };
        let intersection = walk.follow(&local, multiplicity, 1, None)?;
        walk.places.sort_unstable();
        types.push(LocalType {
            tangents: tangents(field, &local, multiplicity),
            fibre_multiplicity: multiplicity,
            intersection,
            places: walk.places,
        });
    }
    Ok(types)
}

fn coefficient(row: &[u64], j: usize) -> u64 {
    row.get(j).copied().unwrap_or(0)
}

/// The number of different tangents of the branches at (0, 0). Roots of a valuation below 1 have the tangent u = 0, roots of a valuation
/// above 1 and the root v = 0 have v = 0, and those of valuation 1 have v = ξu for the roots ξ of their edge's polynomial.
fn tangents(field: &PrimeField, local: &Local, multiplicity: usize) -> usize {
    let points = local.points(multiplicity);
    let edges = lower_edges(local, &points);
    let is_divisible = points.first().is_some_and(|(lowest, _)| *lowest > 0);
    let horizontal = is_divisible || edges.iter().any(|edge| edge.m > edge.q);
    let vertical = edges.iter().any(|edge| edge.m < edge.q);
    let between = edges.iter().filter(|edge| edge.m == edge.q);
    let slopes = between.flat_map(|edge| squarefree_parts(field, &edge.polynomial));
    let distinct: usize = slopes.map(|(_, part)| part.len() - 1).sum();
    distinct + usize::from(horizontal) + usize::from(vertical)
}

/// An edge of a Newton polygon: `count` = k edges of the primitive step (−q, m), and the polynomial φ of degree k.
struct Edge {
    q: usize,
    m: usize,
    /// The value of m·i + q·j on the edge.
    level: usize,
    polynomial: Vec<u64>,
}

struct Walk<'a> {
    field: &'a PrimeField,
    places: Vec<Place>,
}

impl Walk<'_> {
    /// Adds the places of the roots that vanish at u = 0, and returns the valuation of their discriminant in u. `ramified` is the
    /// product of the q so far, `first` the valuation v/u of the first step.
    fn follow(
        &mut self,
        local: &Local,
        multiplicity: usize,
        ramified: usize,
        first: Option<(usize, usize)>,
    ) -> Result<usize, NotSplit> {
        let points = local.points(multiplicity);
        let edges = lower_edges(local, &points);
        let lowest = points.first().map_or(multiplicity, |p| p.0);
        // Σ over ordered pairs of different edges of N N′ min(slope, slope′), slopes ascending from the left end of i.
        let mut valuation = Rational::zero();
        let slopes: Vec<(Rational, usize)> = edges
            .iter()
            .map(|edge| {
                let slope = whole(edge.m) / whole(edge.q);
                (slope, edge.q * (edge.polynomial.len() - 1))
            })
            .collect();
        for (a, (slope, roots)) in slopes.iter().enumerate() {
            valuation = valuation + slope * &whole(roots * (roots - 1));
            for (other_slope, other_roots) in &slopes[..a] {
                let smaller = slope.min(other_slope);
                valuation = valuation + smaller * &whole(2 * roots * other_roots);
            }
            // The root v = 0, if there is one.
            valuation = valuation + slope * &whole(2 * roots * lowest);
        }
        if lowest > 1 {
            // A squarefree polynomial is not divisible by v²: the precision does not suffice.
            return Err(NotSplit);
        }
        if lowest == 1 {
            self.add(ramified, first);
        }
        let mut deeper = 0;
        for edge in &edges {
            let here = first.or(Some((edge.m, edge.q)));
            for (multiplicity, part) in squarefree_parts(self.field, &edge.polynomial) {
                if multiplicity == 1 {
                    for _ in 1..part.len() {
                        self.add(ramified * edge.q, here);
                    }
                    continue;
                }
                for root in roots_in_field(self.field, part)? {
                    let next = self.substituted(local, edge, root);
                    deeper += self.follow(&next, multiplicity, ramified * edge.q, here)?;
                }
            }
        }
        let valuation = valuation + whole(deeper);
        if !valuation.is_integer() {
            return Err(NotSplit);
        }
        usize::try_from(&valuation.numerator()).map_err(|_| NotSplit)
    }

    fn add(&mut self, ramification: usize, first: Option<(usize, usize)>) {
        // ord(v) = ramification · m/q
        let multiplicity = match first {
            Some((m, q)) => ramification.min(ramification * m / q),
            None => ramification,
        };
        self.places.push(Place {
            ramification,
            multiplicity,
        });
    }

    /// H(ξ^w U^q, U^m (ξ^z + V)) / U^level.
    fn substituted(&self, local: &Local, edge: &Edge, root: u64) -> Local {
        let (z, w) = bezout(edge.q, edge.m);
        let field = self.field;
        let precision = edge.q * local.precision - edge.level;
        let mut rows = vec![vec![0; precision]; local.rows.len()];
        let shift = field.power(root, z as u64);
        let scale = field.power(root, w as u64);
        // For each power of U, the coefficients of the powers of ξ^z + V.
        let mut columns: BTreeMap<usize, Vec<u64>> = BTreeMap::new();
        for (i, row) in local.rows.iter().enumerate() {
            for (j, &c) in row.iter().enumerate().filter(|(_, c)| **c != 0) {
                let Some(exponent) = (edge.m * i + edge.q * j).checked_sub(edge.level) else {
                    continue;
                };
                if exponent < precision {
                    let column = columns
                        .entry(exponent)
                        .or_insert_with(|| vec![0; local.rows.len()]);
                    let term = field.mul(c, field.power(scale, j as u64));
                    column[i] = field.sum(column[i], term);
                }
            }
        }
        for (exponent, column) in columns {
            for (i, c) in field.shifted(column, shift).into_iter().enumerate() {
                rows[i][exponent] = c;
            }
        }
        Local { rows, precision }
    }
}

fn whole(n: usize) -> Rational {
    Rational::whole(&malachite::Integer::from(n))
}

/// (z, w) with zq − wm = 1, both as small as possible and not negative.
fn bezout(q: usize, m: usize) -> (usize, usize) {
    let mut w = 0;
    while !(1 + w * m).is_multiple_of(q) {
        w += 1;
    }
    ((1 + w * m) / q, w)
}

/// The edges of the lower Newton polygon through the points, which ascend in i and end on the axis j = 0.
fn lower_edges(local: &Local, points: &[(usize, usize)]) -> Vec<Edge> {
    let mut edges = Vec::new();
    let Some(mut at) = points.len().checked_sub(1) else {
        return edges;
    };
    while at > 0 {
        let (i1, j1) = points[at];
        // The point with the smallest slope (j − j1)/(i1 − i); of several, the farthest.
        let mut best = at - 1;
        for k in (0..at).rev() {
            let (a, b) = (points[k], points[best]);
            // Points on the way may be below j1 only if the polygon is not that of a squarefree polynomial.
            let slope_a = (a.1 as i128 - j1 as i128) * (i1 - b.0) as i128;
            let slope_b = (b.1 as i128 - j1 as i128) * (i1 - a.0) as i128;
            if slope_a <= slope_b {
                best = k;
            }
        }
        let (i2, j2) = points[best];
        let (rise, run) = (j2.saturating_sub(j1), i1 - i2);
        let common = gcd(rise, run);
        let (m, q) = (rise / common, run / common);
        let polynomial = (0..=common)
            .map(|k| coefficient(&local.rows[i2 + k * q], j2 - k * m))
            .collect();
        edges.push(Edge {
            q,
            m,
            level: m * i2 + q * j2,
            polynomial,
        });
        at = best;
    }
    edges
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The multiple roots of a polynomial of a degree below the characteristic, with their multiplicities.
fn multiple_roots(field: &PrimeField, f: &[u64]) -> Result<Vec<(usize, u64)>, NotSplit> {
    let mut roots = Vec::new();
    for (multiplicity, part) in squarefree_parts(field, f) {
        if multiplicity > 1 {
            let found = roots_in_field(field, part)?;
            roots.extend(found.into_iter().map(|root| (multiplicity, root)));
        }
    }
    Ok(roots)
}

/// The squarefree parts with their multiplicities (Yun), for a degree below the characteristic; monic.
pub(super) fn squarefree_parts(field: &PrimeField, f: &[u64]) -> Vec<(usize, Vec<u64>)> {
    let f = field.monic(f.to_vec());
    let mut parts = Vec::new();
    let mut common = field.gcd(f.clone(), field.derivative(&f));
    let mut rest = field.quotient(f, &common);
    let mut multiplicity = 1;
    while rest.len() > 1 {
        let shared = field.gcd(rest.clone(), common.clone());
        let part = field.quotient(rest, &shared);
        if part.len() > 1 {
            parts.push((multiplicity, part));
        }
        common = field.quotient(common, &shared);
        rest = shared;
        multiplicity += 1;
    }
    parts
}

/// All roots of a monic squarefree polynomial.
fn roots_in_field(field: &PrimeField, f: Vec<u64>) -> Result<Vec<u64>, NotSplit> {
    let degree = f.len() - 1;
    let roots = some_roots(field, f);
    if roots.len() == degree {
        Ok(roots)
    } else {
        Err(NotSplit)
    }
}

/// The roots of a monic squarefree polynomial that are in the field.
pub(super) fn some_roots(field: &PrimeField, f: Vec<u64>) -> Vec<u64> {
    let p = field.prime();
    let negative = |c: u64| if c == 0 { 0 } else { p - c };
    if f.len() == 2 {
        return vec![negative(f[0])];
    }
    let x = vec![0, 1];
    let power = field.power_modulo(&x, p, &f);
    let linear = field.gcd(f, field.difference(&power, &x));
    if linear.len() < 2 {
        return Vec::new();
    }
    let factors = equal_degree(field, linear, 1);
    factors.into_iter().map(|g| negative(g[0])).collect()
}
