//! All arcs in a box: what no tube covers is cut off as empty, searched, divided, or said to be unresolved.

use std::collections::HashMap;

use super::follow::{Path, Run, Stop};
use super::tube::{Enclosed, Tube};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::factor::factor_space;
use crate::intervals::{Field, Interval, rational, rationals};
use crate::limits::Limits;
use crate::options::options;
use crate::parallel;
use crate::poly::SparsePolynomial;
use crate::shape::ImplicitSurface;

/// The number of cells along the longest side of the box at the beginning.
const FIRST_CELLS: f64 = 4.0;
/// A cell is halved at most this often.
const LEVELS: u32 = 14;
/// If this many cells are neither empty nor covered, no more cells are divided.
const MAX_OPEN_CELLS: usize = 40_000;
/// An arc with an unresolved end is kept only if it is at least this many shortest steps long.
const SCRAP: f64 = 256.0;
/// Unresolved cells are grouped into blocks of this many cells along each axis; blocks that touch become one box.
const BLOCK: u32 = 16;
/// The largest number of points.
const MAX_POINTS: usize = 1_000_000;

options! {
    /// How arcs are traced.
    ArcOptions of {
        /// The box in which the arcs are traced.
        bounds: [[f64; 2]; 3],
    } {
        /// Neighbouring points of an arc differ along one of the axes by at most the longest side of the box divided by this.
        resolution: u32 = 64,
    }
}

/// A point near which both polynomials have exactly one common zero.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ArcPoint {
    /// The coordinates x, y and z.
    pub position: [f64; 3],
    /// The common zero is at most this far away.
    pub radius: f64,
    /// The exact values of both polynomials at the point.
    pub residuals: [Rational; 2],
}

/// The reason why an arc ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ArcEnd {
    /// The curve leaves the box.
    Window,
    /// No further step could be proved: the curve has a singular point ahead, or the surfaces touch there.
    Unresolved,
}

/// A smooth piece of the curve. Any two neighbouring points (for a closed arc also the last and the first) are proved to lie on
/// one smooth arc, which is a graph over one of the axes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CurveArc {
    /// The points in order, in the direction of ∇f × ∇g.
    pub points: Vec<ArcPoint>,
    /// The reasons why the arc begins and ends; `None` if it is closed.
    pub ends: Option<[ArcEnd; 2]>,
}

/// The common points of two surfaces in a box.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct IntersectionArcs {
    /// The box that was searched.
    pub bounds: [[f64; 2]; 3],
    /// The arcs that were found.
    pub arcs: Vec<CurveArc>,
    /// Boxes in which the common points are not known: they hold singular points, or points near which the surfaces touch or
    /// nearly do. Every common point in the searched box lies near one of the arcs or in one of these boxes.
    pub unresolved: Vec<[[f64; 2]; 3]>,
    /// Common points in the unresolved boxes at which the gradients of both polynomials are parallel, exactly: there the surfaces
    /// touch, or one of them is singular.
    pub touching: Vec<[Rational; 3]>,
}

impl CurveArc {
    /// The points as they are drawn; a closed arc ends with its first point.
    #[must_use]
    pub fn polyline(&self) -> Vec<[f64; 3]> {
        let first = self.points.first().filter(|_| self.ends.is_none());
        let all = self.points.iter().chain(first);
        all.map(|p| p.position).collect()
    }
}

impl IntersectionArcs {
    /// Keeps only the arcs on which one of the polynomials may vanish. An arc is dropped if every polynomial is proved to be
    /// different from 0 near some point of the arc.
    pub fn retain_on(&mut self, polynomials: &[&SparsePolynomial<3>]) {
        let fields: Vec<Field> = polynomials.iter().map(|f| Field::new(f)).collect();
        self.arcs.retain(|arc| {
            fields.iter().any(|f| {
                let mut points = arc.points.iter();
                !points.any(|p| f.on_box(p.position, [p.radius; 3]).is_empty())
            })
        });
    }
}

/// Traces the curve in which two surfaces meet in a box, as chains of certified points.
///
/// Every step along the curve is proved by interval Newton (Krawczyk's operator) with one coordinate as the parameter: the box
/// around the step, a *tube*, holds exactly one common point for every value of that coordinate. An octree over the whole box
/// finds the starting points. A cell is done if a Taylor bound proves that one of the polynomials is not 0 on it, or if it lies
/// inside a tube. The cells that are left after 14 halvings are [`IntersectionArcs::unresolved`].
///
/// The polynomials are factored, and each pair of factors is traced by itself, so that double sheets and crossing components
/// are regular. `progress` is called with numbers from 0 to 1000.
///
/// Cost: two Taylor expansions for every cell along the curve, and two exact evaluations for every point.
///
/// ```
/// use stellate::arcs::{ArcOptions, trace_intersection};
/// use stellate::language::{Numbers, parse_form};
/// use stellate::limits::Limits;
/// use stellate::shape::Form;
///
/// // Two circles, with z = ±√(1/2)
/// let Form::Intersection(pair) = parse_form("x^2+y^2+z^2 = 1; x^2+y^2 = z^2", "<form>", Numbers::Exact)? else { panic!() };
/// let options = ArcOptions::new([[-1.25, 1.25]; 3]).resolution(32);
/// let found = trace_intersection([&pair[0], &pair[1]], &options, &Limits::none(), &|_| {})?;
/// assert_eq!(found.arcs.len(), 2);
/// assert!(found.unresolved.is_empty() && found.arcs.iter().all(|arc| arc.ends.is_none()));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] for a constant, a box with an empty side, or surfaces with a component in common; [`Error::Limit`] for more
/// than a million points; those of [`factor_space`].
pub fn trace_intersection(
    surfaces: [&ImplicitSurface; 2],
    options: &ArcOptions,
    limits: &Limits,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<IntersectionArcs> {
    let is_box = |[a, b]: &[f64; 2]| a.is_finite() && b.is_finite() && a < b;
    if !options.bounds.iter().all(is_box) || options.resolution == 0 {
        return Err(Error::Usage(
            "arcs need a box with positive sides and at least one step".into(),
        ));
    }
    let [first, second] = surfaces;
    let surfaces = [
        &*first.in_original_coordinates(limits)?,
        &*second.in_original_coordinates(limits)?,
    ];
    let mut factors = Vec::new();
    for surface in surfaces {
        let of = factor_space(surface.polynomial(), limits)?.factors;
        if of.is_empty() {
            return Err(Error::Usage("a constant has no surface".into()));
        }
        factors.push(of);
    }
    if factors[0]
        .iter()
        .any(|f| factors[1].iter().any(|g| f.polynomial == g.polynomial))
    {
        return Err(Error::Usage(
            "the surfaces have a component in common: they do not meet in a curve only".into(),
        ));
    }
    let polynomials = surfaces.map(ImplicitSurface::polynomial);
    let pairs = factors[0].len() * factors[1].len();
    let mut all = IntersectionArcs {
        bounds: options.bounds,
        arcs: Vec::new(),
        unresolved: Vec::new(),
        touching: Vec::new(),
    };
    let mut done = 0;
    for f in &factors[0] {
        for g in &factors[1] {
            let fields = [Field::new(&f.polynomial), Field::new(&g.polynomial)];
            let share = 1000 / pairs as u64;
            let heard = |part: u64| progress(share * done + share * part / 1000);
            ArcCover::new([&fields[0], &fields[1]], options).run(
                polynomials,
                &mut all,
                limits,
                &heard,
            )?;
            done += 1;
        }
    }
    let touching = all
        .unresolved
        .iter()
        .filter_map(|place| touching_point(place, polynomials));
    all.touching = touching.collect();
    all.touching.sort_unstable();
    all.touching.dedup();
    progress(1000);
    Ok(all)
}

/// The point with the simplest coordinates in a box, if it is a common zero with parallel gradients.
fn touching_point(
    place: &[[f64; 2]; 3],
    polynomials: [&SparsePolynomial<3>; 2],
) -> Option<[Rational; 3]> {
    let point = place
        .each_ref()
        .map(|side| Rational::simplest_between(&rational(side[0]), &rational(side[1])));
    if polynomials.iter().any(|f| !f.evaluate(&point).is_zero()) {
        return None;
    }
    let [a, b] = polynomials.map(|f| [0, 1, 2].map(|v| f.derivative(v).evaluate(&point)));
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    let is_parallel = [(0, 1), (0, 2), (1, 2)]
        .iter()
        .all(|&(i, j)| minor(i, j).is_zero());
    is_parallel.then_some(point)
}

type Cell = [u32; 3];

/// The search for the arcs of two irreducible surfaces.
struct ArcCover<'a> {
    path: Path<'a>,
    /// The half sides of the cells of the current level, and the number of cells along each axis of the box.
    halves: [f64; 3],
    counts: [u32; 3],
    tubes: Vec<Tube>,
}

impl<'a> ArcCover<'a> {
    fn new(fields: [&'a Field; 2], options: &ArcOptions) -> Self {
        let window = options.bounds;
        let sides = window.map(|[a, b]| b - a);
        let longest = sides.iter().fold(0.0, |l: f64, s| l.max(*s));
        let counts = sides.map(|s| (FIRST_CELLS * s / longest).ceil().max(1.0));
        Self {
            path: Path {
                fields,
                window,
                longest: longest / f64::from(options.resolution),
                shortest: longest / FIRST_CELLS * 0.5f64.powi(LEVELS as i32 + 1),
            },
            halves: std::array::from_fn(|i| sides[i] / counts[i] / 2.0),
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "from one to four"
            )]
            counts: counts.map(|count| count as u32),
            tubes: Vec::new(),
        }
    }

    /// Goes on to the next level, with cells of half the sides.
    fn refine(&mut self) {
        self.halves = self.halves.map(|h| h / 2.0);
        self.counts = self.counts.map(|count| 2 * count);
    }

    fn middle(&self, cell: Cell) -> [f64; 3] {
        std::array::from_fn(|i| {
            self.path.window[i][0] + self.halves[i] * (2.0 * f64::from(cell[i]) + 1.0)
        })
    }

    /// The half sides of a box about `middle` that certainly holds a cell. The cells divide the window exactly, but the middle
    /// and the half sides of a cell are rounded.
    ///
    /// Lemma 15. If n cells of equal length divide the window [a, b] along an axis, the cell number k has the ends a + (b −
    /// a)k/n and a + (b − a)(k + 1)/n. A box about `middle` holds it if its half side is at least the distance of `middle` from
    /// the farther end.
    ///
    /// Law: `cells_cover_the_window`.
    fn around(&self, cell: Cell, middle: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| {
            let [a, b] = self.path.window[i].map(Interval::from);
            let count = Interval::from(f64::from(self.counts[i]));
            let end = |k: u32| a + (b - a) * f64::from(k) / count - Interval::from(middle[i]);
            end(cell[i]).magnitude().max(end(cell[i] + 1).magnitude())
        })
    }

    fn run(
        mut self,
        polynomials: [&SparsePolynomial<3>; 2],
        all: &mut IntersectionArcs,
        limits: &Limits,
        progress: &dyn Fn(u64),
    ) -> Result<()> {
        let mut cells = self.first_cells();
        for level in 0..=LEVELS {
            limits.check()?;
            progress(u64::from(level) * 1000 / u64::from(LEVELS + 1));
            cells = self.not_empty(cells);
            let mut open = Vec::new();
            for (n, cell) in cells.into_iter().enumerate() {
                if n % 64 == 0 {
                    limits.check()?;
                }
                let middle = self.middle(cell);
                if !self.is_covered(cell, middle)
                    && let Some((arc, tubes)) = self.arc_from(middle)
                {
                    self.tubes.extend(tubes);
                    all.arcs.push(certified(&arc, polynomials));
                    if self.tubes.len() > MAX_POINTS {
                        return Err(Error::limit(format!("{MAX_POINTS} points")));
                    }
                }
                if !self.is_covered(cell, middle) {
                    open.push(cell);
                }
            }
            cells = open;
            if level == LEVELS || cells.len() > MAX_OPEN_CELLS {
                break;
            }
            cells = cells.into_iter().flat_map(children).collect();
            self.refine();
        }
        all.unresolved.extend(self.clusters(&cells));
        Ok(())
    }

    fn first_cells(&self) -> Vec<Cell> {
        let [l, m, n] = self.counts;
        let all = (0..l).flat_map(|i| (0..m).flat_map(move |j| (0..n).map(move |k| [i, j, k])));
        all.collect()
    }

    /// The cells that may hold a common zero.
    fn not_empty(&self, mut cells: Vec<Cell>) -> Vec<Cell> {
        let is_open = |cell: &Cell| {
            let middle = self.middle(*cell);
            let halves = self.around(*cell, middle);
            let [f, g] = self.path.fields.map(|f| f.on_box(middle, halves));
            !f.exclude(&g)
        };
        let mut open = parallel::map(&cells, is_open).into_iter();
        cells.retain(|_| open.next() == Some(true));
        cells
    }

    fn is_covered(&self, cell: Cell, middle: [f64; 3]) -> bool {
        let halves = self.around(cell, middle);
        self.tubes.iter().any(|tube| tube.holds(middle, halves))
    }

    /// A new arc that begins in or beside a cell.
    fn arc_from(&self, middle: [f64; 3]) -> Option<(Chain, Vec<Tube>)> {
        let side = self
            .halves
            .iter()
            .fold(f64::INFINITY, |m: f64, h| m.min(*h));
        let seed = self.path.seed(middle, side)?;
        if self.tubes.iter().any(|tube| tube.holds_point(&seed)) {
            return None;
        }
        let forward = self.path.follow(&seed, 1.0, &self.tubes);
        if forward.stop == Stop::Closed {
            let points = std::iter::once(seed).chain(forward.points).collect();
            return Some((Chain { points, ends: None }, forward.tubes));
        }
        let backward = self.path.follow(&seed, -1.0, &self.tubes);
        let ends = Some([end(&backward)?, end(&forward)?]);
        let mut points = backward.points;
        points.reverse();
        points.push(seed);
        points.extend(forward.points);
        let tubes = [backward.tubes, forward.tubes].concat();
        // A short arc that ends before an unresolved place is dropped; the place stays unresolved.
        let length: f64 = tubes.iter().map(|tube| tube.halves[tube.axis]).sum();
        let is_scrap = ends != Some([ArcEnd::Window; 2]) && length < SCRAP * self.path.shortest;
        (!is_scrap).then_some((Chain { points, ends }, tubes))
    }

    /// The end of the first k cells along an axis.
    fn edge(&self, axis: usize, k: u32) -> Interval {
        let [a, b] = self.path.window[axis].map(rational);
        let part = Rational::from(i64::from(k)) / Rational::from(i64::from(self.counts[axis]));
        Interval::narrowest(&(&a + &((&b - &a) * part)))
    }

    /// Boxes around groups of cells that touch or nearly touch.
    fn clusters(&self, cells: &[Cell]) -> Vec<[[f64; 2]; 3]> {
        let mut blocks: HashMap<Cell, Vec<Cell>> = HashMap::new();
        for cell in cells {
            blocks
                .entry(cell.map(|k| k / BLOCK))
                .or_default()
                .push(*cell);
        }
        let mut boxes = Vec::new();
        for cell in cells {
            let mut bounds = cell.map(|k| [k, k]);
            let mut waiting = vec![cell.map(|k| k / BLOCK)];
            let is_new = blocks.contains_key(&waiting[0]);
            while let Some(at) = waiting.pop() {
                for member in blocks.remove(&at).into_iter().flatten() {
                    for ([low, high], k) in bounds.iter_mut().zip(member) {
                        (*low, *high) = (k.min(*low), k.max(*high));
                    }
                    let beside =
                        |d: [u32; 3]| std::array::from_fn(|i| (at[i] + d[i]).saturating_sub(1));
                    let all = (0..27).map(|n| beside([n / 9, n / 3 % 3, n % 3]));
                    waiting.extend(all.filter(|next| blocks.contains_key(next)));
                }
            }
            if is_new {
                boxes.push(std::array::from_fn(|i| {
                    let [low, high] = [bounds[i][0], bounds[i][1] + 1].map(|k| self.edge(i, k));
                    [low.low(), high.high()]
                }));
            }
        }
        boxes
    }
}

/// The points of an arc before their residuals are known.
struct Chain {
    points: Vec<Enclosed>,
    ends: Option<[ArcEnd; 2]>,
}

/// The reason why a run ended; `None` if it ended on a known arc: the piece between the two stays unresolved.
fn end(run: &Run) -> Option<ArcEnd> {
    match run.stop {
        Stop::Window(_) => Some(ArcEnd::Window),
        Stop::Unresolved => Some(ArcEnd::Unresolved),
        Stop::Closed | Stop::Known => None,
    }
}

fn children(cell: Cell) -> impl Iterator<Item = Cell> {
    (0..8u32).map(move |n| [0, 1, 2].map(|i: usize| 2 * cell[i] + (n >> i & 1)))
}

fn certified(chain: &Chain, polynomials: [&SparsePolynomial<3>; 2]) -> CurveArc {
    let points = chain.points.iter().map(|p| {
        let exact = rationals(p.position);
        ArcPoint {
            position: p.position,
            radius: p.radius,
            residuals: polynomials.map(|f| f.evaluate(&exact)),
        }
    });
    CurveArc {
        points: points.collect(),
        ends: chain.ends,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intervals::tests::sphere;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

        /// Lemma 15: the boxes about the middles hold the cells that divide the window.
        #[test]
        fn cells_cover_the_window(low in prop::array::uniform3(-4.0f64..4.0), sides in prop::array::uniform3(0.01f64..3.0), level in 0u32..=LEVELS, part in prop::array::uniform3(0u32..1 << 20)) {
            let bounds: [[f64; 2]; 3] = std::array::from_fn(|i| [low[i], low[i] + sides[i]]);
            let options = ArcOptions::new(bounds).resolution(64);
            let field = Field::new(&sphere(1));
            let mut search = ArcCover::new([&field, &field], &options);
            for _ in 0..level {
                search.refine();
            }
            let cell: Cell = std::array::from_fn(|i| part[i] % search.counts[i]);
            let middle = search.middle(cell);
            let halves = search.around(cell, middle);
            for i in 0..3 {
                let [a, b] = bounds[i].map(rational);
                for k in [cell[i], cell[i] + 1] {
                    let end = &a + &((&b - &a) * Rational::from(i64::from(k)) / Rational::from(i64::from(search.counts[i])));
                    prop_assert!((&end - &rational(middle[i])).abs() <= rational(halves[i]));
                    let edge = search.edge(i, k);
                    prop_assert!(rational(edge.low()) <= end && end <= rational(edge.high()));
                }
                prop_assert!(halves[i] <= search.halves[i] * (1.0 + 1e-10) + 1e-14);
            }
        }
    }
}
