//! Branches r(θ) with exact ranges, assembled from the roots in sectors.

use std::sync::Arc;

use super::link::Link;
use super::{Sector, Tracing};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::parametrize::angle::{AngleRange, ExactAngle};
use crate::poly::{BinaryForm, IntegerPolynomial, coefficients, negate_odd};
use crate::roots::{RealRoot, real_roots};
use crate::sample::Direction;
use malachite::base::polynomial::Polynomial;

/// A continuous real branch r(θ) of a curve. In every direction, its rank among the real radii is known.
#[derive(Clone, Debug)]
pub struct RootBranch {
    tracing: Arc<Tracing>,
    /// The sectors in which the branch is real, each with the index of r among the real radii there, ascending.
    arcs: Vec<(usize, usize)>,
    /// For a branch that is real at a single angle: the rank of r among the real radii r ≠ 0 there, from the largest, and their
    /// number.
    single: Option<(usize, usize)>,
    /// The ranges in which the branch is real and finite.
    pub(in crate::parametrize) real: Vec<AngleRange>,
    /// The ranges in which the branch is positive.
    pub(in crate::parametrize) positive: Vec<AngleRange>,
}

/// A range of angles in which the branch has a fixed rank among the real radii.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct RootArc {
    /// The range, which is open.
    pub range: AngleRange,
    /// The rank of the branch: 0 for the largest r.
    pub rank: usize,
    /// The number of real radii in the range.
    pub of: usize,
}

/// A real radius in a sector: the index of the root R, and the sign of r.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct SignedRoot {
    root: usize,
    sign: i8,
}

/// The radii of all sectors, and the connections between neighbouring sectors.
#[derive(Debug, Default)]
pub(super) struct Graph {
    radii: Vec<Vec<SignedRoot>>,
    /// For each radius, the radius of the next sector that continues it.
    next: Vec<Vec<Option<usize>>>,
    has_previous: Vec<Vec<bool>>,
    /// The signs of the limits at the beginning and at the end of the sector; `None` if the limit is infinite.
    limits: Vec<Vec<[Option<i8>; 2]>>,
    angles: Vec<ExactAngle>,
    /// The isolated points, each as the index of a boundary and the sign of r.
    isolated: Vec<(usize, i8)>,
}

impl Tracing {
    /// The branches in the order of the angles at which they begin, from 0; isolated points are last.
    pub(in crate::parametrize) fn branches(self: &Arc<Self>) -> Vec<RootBranch> {
        let graph = &self.graph;
        let mut branches: Vec<RootBranch> = graph
            .chains()
            .into_iter()
            .map(|arcs| RootBranch {
                tracing: Arc::clone(self),
                real: graph.ranges(&arcs, |sign| sign.is_some(), |_| true),
                positive: graph.ranges(&arcs, |sign| sign == Some(1), |sign| sign > 0),
                arcs,
                single: None,
            })
            .collect();
        branches.extend(graph.isolated.iter().map(|&(boundary, sign)| {
            let point = || vec![AngleRange::point(graph.angles[boundary].clone())];
            RootBranch {
                tracing: Arc::clone(self),
                arcs: Vec::new(),
                single: None,
                real: point(),
                positive: if sign > 0 { point() } else { Vec::new() },
            }
        }));
        branches
    }

    /// The finite real r ≠ 0 at the single angles at which another root is infinite. A formula whose denominator is the leading
    /// coefficient has no value there.
    pub(in crate::parametrize) fn finite_where_one_is_infinite(
        self: &Arc<Self>,
    ) -> Vec<RootBranch> {
        let mut branches = Vec::new();
        for &(index, turned) in &self.boundaries() {
            let link = self.link(index, turned);
            if !link.loses {
                continue;
            }
            let angle = self.angle(index, turned);
            let mut signs: Vec<i8> = link.finite.iter().rev().copied().collect();
            if !self.is_odd() {
                let positive = signs.iter().filter(|s| **s > 0).count();
                signs = [vec![1; positive], vec![-1; positive]].concat();
            }
            for (rank, &sign) in signs.iter().enumerate() {
                let point = || vec![AngleRange::point(angle.clone())];
                branches.push(RootBranch {
                    tracing: Arc::clone(self),
                    arcs: Vec::new(),
                    single: Some((rank, signs.len())),
                    real: point(),
                    positive: if sign > 0 { point() } else { Vec::new() },
                });
            }
        }
        branches
    }

    /// The radii r of a sector, ascending.
    fn radii(&self, sector: Sector) -> Vec<SignedRoot> {
        let signs = self.signs(sector);
        let all = signs.iter().enumerate();
        if self.is_odd() {
            return all.map(|(root, &sign)| SignedRoot { root, sign }).collect();
        }
        let positive: Vec<usize> = all.filter(|(_, s)| **s > 0).map(|(root, _)| root).collect();
        let negative = positive
            .iter()
            .rev()
            .map(|&root| SignedRoot { root, sign: -1 });
        negative
            .chain(positive.iter().map(|&root| SignedRoot { root, sign: 1 }))
            .collect()
    }

    /// The graph of the radii of all sectors.
    pub(super) fn new_graph(&self) -> Graph {
        let sectors = self.sectors();
        let boundaries = self.boundaries();
        let count = sectors.len();
        let radii: Vec<Vec<SignedRoot>> = sectors.iter().map(|&s| self.radii(s)).collect();
        let mut graph = Graph {
            next: radii.iter().map(|list| vec![None; list.len()]).collect(),
            has_previous: radii.iter().map(|list| vec![false; list.len()]).collect(),
            limits: radii
                .iter()
                .map(|list| vec![[None, None]; list.len()])
                .collect(),
            angles: boundaries
                .iter()
                .map(|&(index, turned)| self.angle(index, turned))
                .collect(),
            isolated: Vec::new(),
            radii,
        };
        for (after, &(index, turned)) in boundaries.iter().enumerate() {
            let link = self.link(index, turned);
            graph.add((after + count - 1) % count, after, &link, self.is_odd());
        }
        graph
    }

    /// The radii in an exact direction that is not critical, as pairs of |r|^step and the sign of r, ascending in r.
    fn radii_at(&self, direction: &Direction) -> Vec<(RealRoot, i8)> {
        let along = self.equation.along(direction);
        let positive = |g: &IntegerPolynomial| {
            let mut roots = real_roots(g);
            roots.retain(|root| root.signum() > 0);
            roots
        };
        let outward = positive(&along);
        let mut backward = if self.is_odd() {
            let mut reflected = along.into_coefficients_asc();
            negate_odd(&mut reflected);
            positive(&IntegerPolynomial::from_coefficients_asc(reflected))
        } else {
            outward.clone()
        };
        backward.reverse();
        let signed = |roots: Vec<RealRoot>, sign| roots.into_iter().map(move |root| (root, sign));
        signed(backward, -1).chain(signed(outward, 1)).collect()
    }
}

impl Tracing {
    /// The double nearest to sign · root^(1/step).
    fn nearest(&self, mut root: RealRoot, sign: i8) -> f64 {
        let step = u32::try_from(self.equation.step);
        let step = step.invariant("a degree is below 2^32");
        root.nearest_f64(step, &Rational::from(i32::from(sign)), &Rational::zero())
    }
}

impl Graph {
    /// Whether all radii are finite at the angle between two sectors.
    fn is_finite_between(&self, before: usize, after: usize) -> bool {
        let ends = self.limits[before].iter().map(|limits| limits[1]);
        let begins = self.limits[after].iter().map(|limits| limits[0]);
        ends.chain(begins).all(|limit| limit.is_some())
    }

    /// Adds the connections between two neighbouring sectors.
    fn add(&mut self, before: usize, after: usize, link: &Link, odd: bool) {
        let limit = |radius: &SignedRoot, side: usize| {
            let of_root = link.limits[side][radius.root];
            if odd {
                of_root
            } else {
                of_root.map(|s| if s == 0 { 0 } else { radius.sign })
            }
        };
        let mut reaches_zero = false;
        for (sector, side) in [(before, 0), (after, 1)] {
            for index in 0..self.radii[sector].len() {
                let value = limit(&self.radii[sector][index], side);
                self.limits[sector][index][1 - side] = value;
                reaches_zero |= value == Some(0);
            }
        }
        for &(a, b) in &link.pairs {
            for index in 0..self.radii[before].len() {
                let from = self.radii[before][index];
                let is_next = |to: &SignedRoot| to.root == b && (odd || to.sign == from.sign);
                if from.root == a
                    && let Some(to) = self.radii[after].iter().position(is_next)
                {
                    self.next[before][index] = Some(to);
                    self.has_previous[after][to] = true;
                }
            }
        }
        for &sign in &link.isolated {
            match (odd, sign > 0) {
                (true, _) => self.isolated.push((after, sign)),
                (false, true) => self.isolated.extend([(after, 1), (after, -1)]),
                (false, false) => {}
            }
        }
        if link.zero && !reaches_zero {
            self.isolated.push((after, 0));
        }
    }

    /// The maximal chains of (sector, radius), each at most one turn long. A chain that continues through the angle 0 is one
    /// branch if its two parts do not overlap.
    fn chains(&self) -> Vec<Vec<(usize, usize)>> {
        let count = self.radii.len();
        let mut seen: Vec<Vec<bool>> = self
            .radii
            .iter()
            .map(|list| vec![false; list.len()])
            .collect();
        let mut chains = Vec::new();
        let starts = |wanted: bool| {
            (0..count)
                .flat_map(move |s| (0..self.radii[s].len()).map(move |i| (s, i)))
                .filter(move |&(s, i)| self.has_previous[s][i] != wanted)
        };
        // The chains with a beginning are first, then the closed ones, in the order of angles from 0.
        for start in starts(true).chain(starts(false)) {
            if seen[start.0][start.1] {
                continue;
            }
            let mut pieces: Vec<Vec<(usize, usize)>> = vec![Vec::new()];
            let mut at = Some(start);
            while let Some((sector, index)) = at.filter(|&(s, i)| !seen[s][i]) {
                seen[sector][index] = true;
                if sector == 0 && !pieces[pieces.len() - 1].is_empty() {
                    pieces.push(Vec::new());
                }
                let last = pieces.len() - 1;
                pieces[last].push((sector, index));
                at = self.next[sector][index].map(|to| ((sector + 1) % count, to));
            }
            let ends_before = |a: &[(usize, usize)], b: &[(usize, usize)]| {
                a.last().map(|x| x.0) < b.first().map(|x| x.0)
            };
            if pieces.len() == 2 && ends_before(&pieces[1], &pieces[0]) {
                let first = pieces.swap_remove(0);
                pieces[0].extend(first);
            }
            chains.extend(pieces);
        }
        chains.sort_unstable();
        chains
    }

    /// The maximal ranges of a chain in which `at_limit` holds at the boundaries and `inside` holds in the sectors.
    fn ranges(
        &self,
        arcs: &[(usize, usize)],
        at_limit: impl Fn(Option<i8>) -> bool,
        inside: impl Fn(i8) -> bool,
    ) -> Vec<AngleRange> {
        let full = || ExactAngle::Pi(Rational::from(2));
        let mut ranges: Vec<AngleRange> = Vec::new();
        let mut goes_on = false;
        for (position, &(sector, index)) in arcs.iter().enumerate() {
            let [from, to] = self.limits[sector][index].map(&at_limit);
            let holds = inside(self.radii[sector][index].sign);
            let end = self.angles.get(sector + 1).cloned().unwrap_or_else(full);
            let glued = position > 0
                && arcs[position - 1].0 + 1 == sector
                && self.next[arcs[position - 1].0][arcs[position - 1].1] == Some(index);
            match ranges.last_mut() {
                Some(range) if holds && glued && goes_on && from => {
                    range.to = end;
                    range.closed[1] = to;
                }
                _ if holds => ranges.push(AngleRange {
                    from: self.angles[sector].clone(),
                    to: end,
                    closed: [from, to],
                }),
                _ => {}
            }
            goes_on = holds && to;
        }
        ranges
    }
}

impl RootBranch {
    /// The maximal angle ranges in which the branch has a fixed rank among the real radii, counted with multiplicity. Where a radius is
    /// infinite there are fewer, so a range ends there.
    #[must_use]
    pub fn arcs(&self) -> Vec<RootArc> {
        let graph = &self.tracing.graph;
        let end = |sector: usize| {
            let angle = graph.angles.get(sector + 1);
            angle
                .cloned()
                .unwrap_or_else(|| ExactAngle::Pi(Rational::from(2)))
        };
        if let Some((rank, of)) = self.single {
            let range = self.real[0].clone();
            return vec![RootArc { range, rank, of }];
        }
        let mut arcs: Vec<(usize, RootArc)> = Vec::new();
        for &(sector, index) in &self.arcs {
            let of = graph.radii[sector].len();
            let rank = of - 1 - index;
            match arcs.last_mut() {
                Some((last, arc))
                    if *last + 1 == sector
                        && arc.rank == rank
                        && arc.of == of
                        && graph.is_finite_between(*last, sector) =>
                {
                    arc.range.to = end(sector);
                    *last = sector;
                }
                _ => arcs.push((
                    sector,
                    RootArc {
                        range: AngleRange {
                            from: graph.angles[sector].clone(),
                            to: end(sector),
                            closed: [false, false],
                        },
                        rank,
                        of,
                    },
                )),
            }
        }
        arcs.into_iter().map(|(_, arc)| arc).collect()
    }

    /// The forms f_(low), f_(low + step), … of the polynomial Σ f_(low + i·step)(cos θ, sin θ) r^(i·step), of which r is a
    /// root; and the step.
    pub(crate) fn equation(&self) -> (&[BinaryForm], usize) {
        (&self.tracing.equation.forms, self.tracing.equation.step)
    }

    /// The discriminant of that polynomial with respect to r^step, up to a constant, by its coefficients in t = tan θ,
    /// ascending. Branches begin, end and meet at zeros of the discriminant.
    #[must_use]
    pub fn discriminant(&self) -> Vec<Rational> {
        coefficients(&self.tracing.discriminant())
    }

    /// Whether the branch is a point, that is real at a single angle only.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.arcs.is_empty()
    }

    /// Whether the branch is positive in every direction.
    #[must_use]
    pub fn covers_circle(&self) -> bool {
        let graph = &self.tracing.graph;
        let (Some(first), Some(last)) = (self.arcs.first(), self.arcs.last()) else {
            return false;
        };
        self.arcs.len() == graph.radii.len()
            && graph.next[last.0][last.1] == Some(first.1)
            && self.positive.len() == 1
            && self.positive[0].closed == [true, true]
    }

    /// The angles at which the outermost positive radius changes from one branch to another, all branches together. `None` if
    /// some direction has no positive radius, or if the radii are not bounded.
    #[must_use]
    pub fn outermost_jumps(&self) -> Option<Vec<ExactAngle>> {
        let graph = &self.tracing.graph;
        let count = graph.radii.len();
        let mut jumps = Vec::new();
        for (sector, radii) in graph.radii.iter().enumerate() {
            let outermost = radii
                .len()
                .checked_sub(1)
                .filter(|&last| radii[last].sign > 0)?;
            let after = (sector + 1) % count;
            if graph.limits[sector][outermost].contains(&None) {
                return None;
            }
            if graph.next[sector][outermost] != graph.radii[after].len().checked_sub(1) {
                jumps.push((after, graph.angles[after].clone()));
            }
        }
        jumps.sort_unstable_by_key(|(after, _)| *after);
        Some(jumps.into_iter().map(|(_, angle)| angle).collect())
    }

    /// The double nearest to the largest positive radius of all branches in an exact direction.
    #[must_use]
    pub fn outermost_radius(&self, direction: &Direction) -> Option<f64> {
        let (root, sign) = self.tracing.radii_at(direction).pop()?;
        (sign > 0).then(|| self.tracing.nearest(root, sign))
    }

    /// The double nearest to r in an exact direction; `None` in critical directions and where the branch is not real.
    #[must_use]
    pub fn radius(&self, direction: &Direction) -> Option<f64> {
        let (u, v, _) = direction.integers();
        let sector = self.tracing.sector_of(u, v)?;
        let index = self.arcs.iter().find(|(s, _)| *s == sector)?.1;
        let (root, sign) = self.tracing.radii_at(direction).into_iter().nth(index)?;
        Some(self.tracing.nearest(root, sign))
    }
}
