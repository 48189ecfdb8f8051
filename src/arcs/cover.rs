//! All arcs in a box: what no tube covers is cut off as empty, searched, divided, or said to be unresolved.

use std::collections::HashMap;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::follow::{Path, Run, Stop};
use super::tube::{Enclosed, Tube};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::factor::factor_space;
use crate::intervals::{Field, Interval, rational, rationals};
use crate::limits::Limits;
use crate::options::options;
use crate::poly::SparsePolynomial;
use crate::shape::ImplicitSurface;

/// Cells along the longest side of the box to begin with.
const FIRST_CELLS: f64 = 4.0;
/// A cell is halved so many times at most.
const LEVELS: u32 = 14;
/// No more cells are divided where so many are neither empty nor covered.
const MAX_OPEN_CELLS: usize = 40_000;
/// Arcs with an unresolved end are at least this many shortest steps long.
const SCRAP: f64 = 256.0;
/// Unresolved cells are taken together where blocks of so many, along each axis, touch.
const BLOCK: u32 = 16;
/// So many points at most.
const MAX_POINTS: usize = 1_000_000;

options! {
    /// How arcs are traced.
    ArcOptions of {
        /// The box in which they are looked for.
        bounds: [[f64; 2]; 3],
    } {
        /// Neighbours are at most the longest side of the box divided by this apart, along one of the axes.
        resolution: u32 = 64,
    }
}

/// A point with exactly one common zero of both polynomials beside it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ArcPoint {
    /// x, y, z.
    pub position: [f64; 3],
    /// The common zero is at most this far away.
    pub radius: f64,
    /// The exact values of both polynomials here.
    pub residuals: [Rational; 2],
}

/// How an arc ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ArcEnd {
    /// Where the curve leaves the box.
    Window,
    /// Where no further step could be proved: before a singular point of the curve, or one where the surfaces touch.
    Unresolved,
}

/// A smooth piece of the curve: any two neighbours (of a closed one also the last point and the first) are proved to lie on
/// one smooth arc, which is a graph over one of the axes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CurveArc {
    /// In order, in the direction of ∇f × ∇g.
    pub points: Vec<ArcPoint>,
    /// How it begins and ends; `None` if it is closed.
    pub ends: Option<[ArcEnd; 2]>,
}

/// What two surfaces have in common in a box.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct IntersectionArcs {
    /// The box in which they were looked for.
    pub bounds: [[f64; 2]; 3],
    /// The arcs that were found.
    pub arcs: Vec<CurveArc>,
    /// Every common point in the box lies beside one of the arcs or in one of these boxes, where it is not known what there is:
    /// they hold singular points, points or curves where the surfaces touch, or what is too near to such.
    pub unresolved: Vec<[[f64; 2]; 3]>,
}

impl CurveArc {
    /// The points as they are drawn: a closed arc ends with its first point.
    #[must_use]
    pub fn polyline(&self) -> Vec<[f64; 3]> {
        let first = self.points.first().filter(|_| self.ends.is_none());
        let all = self.points.iter().chain(first);
        all.map(|p| p.position).collect()
    }
}

impl IntersectionArcs {
    /// Keeps the arcs on which one of some polynomials may vanish throughout: an arc with a point beside which a polynomial is
    /// proved ≠ 0 is not on its zero set.
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

/// The curve in which two surfaces meet in a box, as chains of certified points.
///
/// Every step along the curve is proved by interval Newton (Krawczyk's operator) with one coordinate as the parameter: in a
/// box around the step, a tube, there is exactly one common point for every value of that coordinate. An octree over the
/// whole box finds the starting points: a cell is done if a Taylor bound proves one of the polynomials ≠ 0 on it, or if
/// it lies inside a tube; what is left after 14 halvings is [`IntersectionArcs::unresolved`].
///
/// The factors of both polynomials meet each other in pairs, so that double sheets and crossing components are regular.
/// `progress` hears numbers from 0 to 1000.
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
/// [`Error::Usage`] for a constant, a box that is not one, or surfaces with a component in common; [`Error::Limit`] for more than a million points;
/// those of [`factor_space`].
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
    progress(1000);
    Ok(all)
}

type Cell = [u32; 3];

/// The search for the arcs of two irreducible surfaces.
struct ArcCover<'a> {
    path: Path<'a>,
    /// Half the sides of the cells that are looked at now, and how many of them there are beside each other in the window.
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

    /// Goes on to cells of half the sides.
    fn refine(&mut self) {
        self.halves = self.halves.map(|h| h / 2.0);
        self.counts = self.counts.map(|count| 2 * count);
    }

    fn middle(&self, cell: Cell) -> [f64; 3] {
        std::array::from_fn(|i| {
            self.path.window[i][0] + self.halves[i] * (2.0 * f64::from(cell[i]) + 1.0)
        })
    }

    /// Half the sides that a box about the middle of a cell needs to hold the cell: the cells divide the window, and the doubles
    /// next to its middle and half sides are not exact.
    ///
    /// Lemma 15. With k + 1 cells beside each other from the lower end a of the window on to the upper end of a cell, of n in
    /// all, the ends of the cell are a + (b − a)k/n and a + (b − a)(k + 1)/n; it reaches no farther than the farther one.
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

    /// Those that are not proved to hold no common zero.
    fn not_empty(&self, cells: Vec<Cell>) -> Vec<Cell> {
        let is_open = |cell: &Cell| {
            let middle = self.middle(*cell);
            let halves = self.around(*cell, middle);
            let [f, g] = self.path.fields.map(|f| f.on_box(middle, halves));
            !f.exclude(&g)
        };
        cells.into_par_iter().filter(is_open).collect()
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
        // Scraps between a place that is not resolved and an arc that stopped before it are left to that place.
        let length: f64 = tubes.iter().map(|tube| tube.halves[tube.axis]).sum();
        let is_scrap = ends != Some([ArcEnd::Window; 2]) && length < SCRAP * self.path.shortest;
        (!is_scrap).then_some((Chain { points, ends }, tubes))
    }

    /// Where the first k cells beside each other end.
    fn edge(&self, axis: usize, k: u32) -> Interval {
        let [a, b] = self.path.window[axis].map(rational);
        let part = Rational::from(i64::from(k)) / Rational::from(i64::from(self.counts[axis]));
        Interval::narrowest(&(&a + &((&b - &a) * part)))
    }

    /// The boxes around cells that hang together, or nearly so.
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

/// `None` on an arc that is known already: the piece between it and where it stopped stays unresolved.
fn end(run: &Run) -> Option<ArcEnd> {
    match run.stop {
        Stop::Window => Some(ArcEnd::Window),
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

        /// Lemma 15: the boxes that are looked at hold the cells that divide the window.
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
