//! The exact extents of components: between which critical values of x, and of y, each of them lies.
//!
//! A component that is no point crosses the line x = c for exactly the c between its smallest and its largest x. So it is enough to
//! know which components cross one line in each gap between neighbouring critical values of x, and the same for y.
//!
//! Lemma. Let ℓ be a line through no critical point of its own direction, so that it crosses the curve transversally, and let
//! [t−, t+] be an interval of t between two critical values of the sweep in which ℓ crosses the curve once. Then the numbers of arcs
//! below ℓ at t− and at t+ differ by 1, and the smaller one is the rank of the arc that is crossed.
//! Proof. Arcs and ℓ are graphs over [t−, t+]; the arcs keep their order, and only the one that is crossed changes its side.

use malachite::base::num::basic::traits::Zero;

use super::components::Components;
use super::fibre::narrow;
use super::strip::Strip;
use super::sweep::{Sweep, eliminant};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{
    IntegerPolynomial, PlanePolynomial, primitive_part, sign_at, squarefree_decomposition,
};
use crate::roots::{RealRoot, between, disjoint, distinct_roots, real_roots};

/// How many lines are tried in a gap before it is given up; only lines through finitely many points are unfit.
const LINES: i64 = 64;

/// How far, in bits, a crossing is narrowed before another line is tried; for later lines twice, three times, … as far.
const MOST_BITS: i64 = 128;

/// A coordinate of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    X,
    Y,
}

/// The values of a coordinate at which lines of constant value are not transversal to the curve, ascending, and lines between.
#[derive(Clone, Debug)]
pub(crate) struct CriticalValues {
    pub(crate) axis: Axis,
    /// The values; their enclosures are disjoint.
    pub(crate) values: Vec<RealRoot>,
    gaps: Vec<Rational>,
}

impl CriticalValues {
    /// The critical values of a coordinate on the curve f = 0, together with the values at which it has an asymptote.
    ///
    /// # Errors
    /// Those of the subresultants.
    pub(crate) fn new(f: &PlanePolynomial, axis: Axis, limits: &Limits) -> Result<Self> {
        let turned = match axis {
            Axis::X => f.clone(),
            Axis::Y => exchanged(f),
        };
        let strip = Strip::of_plane(&turned, 0);
        let degree = f.degree().invariant("the polynomial is not 0");
        let polynomial = if strip.coefficients().len() == 1 {
            strip.coefficients()[0].clone()
        } else {
            eliminant(&strip, degree, 0, limits)?
        };
        if polynomial == IntegerPolynomial::ZERO {
            return Err(Error::internal(
                "the critical values of a coordinate",
                "a squarefree polynomial and its derivative have a resultant that is not 0",
            ));
        }
        let parts = squarefree_decomposition(&primitive_part(&polynomial));
        let values = disjoint(distinct_roots(parts.iter().map(|(_, g)| g)));
        let gaps = between(&values);
        Ok(Self { axis, values, gaps })
    }
}

impl From<&Sweep> for CriticalValues {
    /// The critical values of x on a curve that was swept without a shear: those of the sweep.
    fn from(sweep: &Sweep) -> Self {
        Self {
            axis: Axis::X,
            values: sweep
                .fibres
                .iter()
                .map(|fibre| fibre.value.clone())
                .collect(),
            gaps: sweep.insides.clone(),
        }
    }
}

/// f(y, x).
pub(super) fn exchanged(f: &PlanePolynomial) -> PlanePolynomial {
    PlanePolynomial::from_terms(f.terms().map(|((i, j), c)| ((j, i), c)))
}

/// The smallest and the largest value of a coordinate on a component; `None` for an infinite one.
pub(crate) type Extent = [Option<RealRoot>; 2];

/// The extents of all components that are not single points or lines of constant value; `None` for these.
pub(super) fn extents(
    sweep: &Sweep,
    components: &Components,
    f: &PlanePolynomial,
    critical: &CriticalValues,
    limits: &Limits,
) -> Result<Vec<Option<Extent>>> {
    let count = components.list.len();
    let last = critical.gaps.len() - 1;
    let mut seen: Vec<Option<[usize; 2]>> = vec![None; count];
    for gap in 0..=last {
        limits.check()?;
        for component in crossed(sweep, components, f, critical, gap, limits)? {
            let range = seen[component].get_or_insert([gap, gap]);
            if gap > range[1] + 1 {
                return Err(Error::internal(
                    "the extents of components",
                    "a connected component crosses all lines between two that it crosses",
                ));
            }
            range[1] = gap;
        }
    }
    let extent = |range: [usize; 2]| {
        [
            range[0].checked_sub(1).map(|i| critical.values[i].clone()),
            critical.values.get(range[1]).cloned(),
        ]
    };
    Ok(seen.into_iter().map(|range| range.map(extent)).collect())
}

/// The components that cross a line of constant value in a gap, in no order and perhaps more than once.
fn crossed(
    sweep: &Sweep,
    components: &Components,
    f: &PlanePolynomial,
    critical: &CriticalValues,
    gap: usize,
    limits: &Limits,
) -> Result<Vec<usize>> {
    let (low, high) = match (
        gap.checked_sub(1).map(|i| &critical.values[i]),
        critical.values.get(gap),
    ) {
        (Some(a), Some(b)) => (a.enclosure().1.to_rational(), b.enclosure().0.to_rational()),
        _ => {
            let c = &critical.gaps[gap];
            let half = Rational::one() / Rational::from(2);
            (c - &half, c + &half)
        }
    };
    for attempt in 0..LINES {
        limits.check()?;
        // Not in the middle, where the line would often be an axis of symmetry and pass through critical points.
        let part = |k: i64| &low + &((&high - &low) * &(Rational::from(k) / Rational::from(LINES)));
        let from = (20 + 7 * attempt) % (LINES - 1);
        let line = Rational::simplest_between(&part(from + 1), &part(from + 2));
        let most_bits = MOST_BITS * (attempt + 1);
        if let Some(found) = along_line(sweep, components, f, critical.axis, &line, most_bits) {
            return Ok(found);
        }
    }
    Err(Error::internal(
        "the extents of components",
        "only finitely many lines pass through a critical point of the sweep",
    ))
}

/// The components that cross the line x = c or y = c; `None` if a crossing is too near a critical value of the sweep.
fn along_line(
    sweep: &Sweep,
    components: &Components,
    f: &PlanePolynomial,
    axis: Axis,
    c: &Rational,
    most_bits: i64,
) -> Option<Vec<usize>> {
    let shear = Rational::from(sweep.curve.shear);
    if axis == Axis::X && shear.is_zero() {
        let interval = sweep
            .fibres
            .partition_point(|fibre| fibre.value.cmp_rational(c).is_lt());
        let arcs = 0..sweep.arcs[interval].len();
        return Some(arcs.map(|rank| components.of_arc(interval, rank)).collect());
    }
    // On y = c, t itself runs; on x = c, R runs, and t = c − shear·R.
    let on_line = match axis {
        Axis::Y => sweep.curve.strip.across(c),
        Axis::X => Strip::of_plane(f, 0).along(c),
    };
    let t_of = |s: &Rational| match axis {
        Axis::Y => s.clone(),
        Axis::X => c - &(&shear * s),
    };
    let height = |t: &Rational| match axis {
        Axis::Y => c.clone(),
        Axis::X => (c - t) / &shear,
    };
    let mut found = Vec::new();
    for mut root in real_roots(&on_line) {
        let mut bits = 0;
        let (interval, ends) = loop {
            let (low, high) = root.enclosure();
            // Another crossing may be exactly at an end.
            let is_alone = low == high || [low, high].iter().all(|s| sign_at(&on_line, s) != 0);
            let mut ends = [t_of(&low.to_rational()), t_of(&high.to_rational())];
            ends.sort_unstable();
            if let Some(interval) = interval_of(sweep, &ends).filter(|_| is_alone) {
                break (interval, ends);
            }
            if low == high || bits > most_bits {
                return None;
            }
            narrow(&mut root, 8);
            bits += 8;
        };
        // Where the crossing is known exactly, its rank is seen there.
        let rank = if ends[0] == ends[1] {
            let t = &ends[0];
            let roots = real_roots(&sweep.curve.strip.along(t));
            let below = height(t);
            let rank = roots.partition_point(|r| r.cmp_rational(&below).is_lt());
            let is_here = roots
                .get(rank)
                .is_some_and(|r| r.cmp_rational(&below).is_eq());
            is_here
                .then_some(())
                .invariant("the crossing is a point of the curve");
            rank
        } else {
            let [before, after] = ends.each_ref().map(|t| {
                let below = height(t);
                let roots = real_roots(&sweep.curve.strip.along(t));
                roots.partition_point(|r| r.cmp_rational(&below).is_lt())
            });
            (before.abs_diff(after) == 1)
                .then_some(before.min(after))
                .invariant("a line crosses one arc at a time")
        };
        found.push(components.of_arc(interval, rank));
    }
    Some(found)
}

/// The interval of the sweep that holds [ends_0, ends_1] in its inside.
fn interval_of(sweep: &Sweep, ends: &[Rational; 2]) -> Option<usize> {
    let place = |t: &Rational| {
        sweep
            .fibres
            .partition_point(|fibre| fibre.value.cmp_rational(t).is_lt())
    };
    let interval = place(&ends[0]);
    let is_free = sweep
        .fibres
        .get(interval)
        .is_none_or(|fibre| fibre.value.cmp_rational(&ends[1]).is_gt());
    is_free.then_some(interval)
}
