//! Inspection of points against a harmonic surface. The surface itself is compared, without its equation, which can have more points.

use std::cmp::Ordering;
use std::sync::Arc;

use super::cells::{CellTree, NearestOnSphere};
use super::exact_foot::{ExactSurface, RefinementGoal};
use super::known::rounding;
use super::nearest::{FootCandidate, unit};
use super::tolerance::Tolerance;
use super::{DistanceBounds, Inspection, InspectorOptions, Verdict};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::intervals::Interval;
use crate::intervals::rational;
use crate::limits::Limits;
use crate::shape::{HarmonicPair, HarmonicSurface};

#[cfg(test)]
#[path = "harmonic_laws.rs"]
mod laws;

/// The bounds of a distance are sought to this part of the width that is asked for.
const SHARE: f64 = 0.25;

/// A harmonic surface with a tolerance, ready to be compared with points in the surface's original coordinates.
///
/// Doubles with error bounds decide nearly all points, by branch and bound over cells of the sphere. For points at the tolerance, or so near
/// to the surface that doubles do not give enough digits of the distance, the nearest point is refined in exact arithmetic: that decides
/// all points but those whose distance is the tolerance up to some 10^−60 of it and whose nearest point is not in a simple rational
/// direction.
#[derive(Clone, Debug)]
pub struct HarmonicInspector {
    /// `None` for a sphere about the center, whose distances are known exactly, and for sizes beyond doubles.
    cells: Option<Arc<CellTree>>,
    exact: Arc<ExactSurface>,
    /// Whether R > 0 everywhere, so that the surface has an inside.
    is_positive: bool,
    tolerance: Tolerance,
    /// Bounds of a distance may differ by this part of it.
    relative: f64,
    limits: Limits,
}

impl HarmonicInspector {
    /// The inspector of a surface; `is_positive` says whether R > 0 in every direction is known.
    ///
    /// ```
    /// use stellate::inspect::{HarmonicInspector, InspectorOptions, Verdict};
    /// use stellate::limits::Limits;
    /// use stellate::shape::HarmonicSurface;
    /// let surface = HarmonicSurface::new([((0, 0), 2.into()), ((1, 0), "1/2".parse()?)])?;
    /// let options = InspectorOptions::new("1/10".parse()?);
    /// let inspector = HarmonicInspector::new(&surface, true, &options, &Limits::none())?;
    /// let found = inspector.inspect(&["0", "0", "2.6"].map(|q| q.parse().unwrap()));
    /// // The nearest point is (0, 0, 5/2), exactly at the tolerance.
    /// assert_eq!((found.verdict, found.curve, found.sign), (Verdict::Inside, Some(true), Some(1)));
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] for a tolerance that is not positive, and for R = 0.
    pub fn new(
        surface: &HarmonicSurface,
        is_positive: bool,
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        if surface.is_zero() {
            return Err(Error::Usage(
                "R is 0 in every direction: the surface is a single point".into(),
            ));
        }
        let pair = HarmonicPair::new(surface);
        let is_sphere = surface.degree() == 0;
        let cells = (!is_sphere)
            .then(|| CellTree::new(surface, &pair))
            .flatten();
        if cells.is_none() && !is_sphere {
            return Err(Error::limit("a radius within the range of doubles"));
        }
        let digits = i32::try_from(options.digits.min(14)).invariant("14 is small");
        Ok(Self {
            cells: cells.map(Arc::new),
            exact: Arc::new(ExactSurface::new(surface, pair)),
            is_positive,
            tolerance: Tolerance::new(&options.tolerance)?,
            relative: 0.1f64.powi(digits),
            limits: limits.clone(),
        })
    }

    /// The inspector of the same surface with another tolerance; what was computed for the surface is shared.
    ///
    /// # Errors
    /// [`Error::Usage`] for a tolerance that is not positive.
    pub fn with_tolerance(&self, tolerance: &Rational) -> Result<Self> {
        Ok(Self {
            tolerance: Tolerance::new(tolerance)?,
            ..self.clone()
        })
    }

    /// Whether the surface has an inside: whether R > 0 is known everywhere.
    pub(crate) fn has_sides(&self) -> bool {
        self.is_positive
    }

    /// Inspects a point.
    #[must_use]
    pub fn inspect(&self, point: &[Rational; 3]) -> Inspection {
        self.inspect_near(point.each_ref().map(Rational::to_f64), &|| point.clone())
    }

    /// Inspects a point whose nearest doubles are `near`. Its exact coordinates are computed only if they are needed.
    ///
    /// Cost: in doubles some tens of L² operations. Exactly, some values of forms of degree L at vectors of hundreds of bits.
    #[must_use]
    pub fn inspect_near(&self, near: [f64; 3], exactly: &dyn Fn() -> [Rational; 3]) -> Inspection {
        if self.limits.check().is_err() {
            return Inspection::UNKNOWN;
        }
        let Some(cells) = &self.cells else {
            return self.against_sphere(&exactly());
        };
        let slack = rounding(near);
        let in_doubles = near.iter().all(|x| x.is_finite());
        let (found, verdict) = match in_doubles {
            true => self.by_cells(cells, near, slack),
            false => (None, None),
        };
        let sign = self.sign(cells, near, slack, exactly);
        if let (Some(found), Some(verdict)) = (&found, verdict)
            && found.distance.high - found.distance.low <= self.relative * found.distance.high
            && let Some(curve) = self.curve(cells, near, slack, verdict, exactly)
        {
            return Inspection {
                verdict,
                curve: Some(curve),
                distance: found.distance,
                sign,
            };
        }
        self.by_refinement(cells, near, found, &exactly(), sign)
    }

    /// The sign of [`HarmonicInspector::inspect_near`], without the distance if R > 0 is not a constant.
    pub(crate) fn side(&self, near: [f64; 3], exactly: &dyn Fn() -> [Rational; 3]) -> Option<i8> {
        match &self.cells {
            Some(cells) => self.sign(cells, near, 0.0, exactly),
            None => self.against_sphere(&exactly()).sign,
        }
    }

    /// The foot of a point; the normal points away from the center.
    pub(crate) fn foot(&self, point: &[Rational; 3]) -> Option<FootCandidate> {
        let center = self.exact.center();
        let (near, normal) = match &self.cells {
            Some(cells) => cells.foot(point.each_ref().map(Rational::to_f64))?,
            None => {
                let offsets: [Rational; 3] = std::array::from_fn(|i| &point[i] - &center[i]);
                // From the center all directions are equally near.
                let outward =
                    unit(offsets.each_ref().map(Rational::to_f64)).unwrap_or([1.0, 0.0, 0.0]);
                let radius = self.exact.mean().abs().to_f64();
                (outward.map(|x| radius * x), Some(outward))
            }
        };
        let point = std::array::from_fn(|i| (rational(near[i]) + &center[i]).to_f64());
        Some(FootCandidate::on_form(point, normal))
    }

    /// The nearest point in doubles, and the verdict if its bounds decide it.
    fn by_cells(
        &self,
        cells: &CellTree,
        near: [f64; 3],
        slack: f64,
    ) -> (Option<NearestOnSphere>, Option<Verdict>) {
        let decided = |found: &NearestOnSphere| self.tolerance.verdict(&found.distance);
        let Some(found) = cells.nearest(near, slack, SHARE * self.relative) else {
            return (None, None);
        };
        if let Some(verdict) = decided(&found) {
            return (Some(found), Some(verdict));
        }
        let found = cells.nearest(near, slack, 0.0).unwrap_or(found);
        let verdict = decided(&found);
        (Some(found), verdict)
    }

    /// The criterion of Theorem 8: the surface is connected, so it meets the sphere exactly if it has a point in the ball and one that is
    /// not inside the sphere.
    fn curve(
        &self,
        cells: &CellTree,
        near: [f64; 3],
        slack: f64,
        verdict: Verdict,
        exactly: &dyn Fn() -> [Rational; 3],
    ) -> Option<bool> {
        match verdict {
            Verdict::Outside => Some(false),
            Verdict::Uncertain | Verdict::Undecided => None,
            Verdict::Inside => cells
                .goes_beyond(near, slack, self.tolerance.around)
                .or_else(|| {
                    let level = self.tolerance.squared();
                    self.exact.goes_beyond(&exactly(), &level).then_some(true)
                }),
        }
    }

    /// The side of the surface on which a point is, if R > 0.
    fn sign(
        &self,
        cells: &CellTree,
        near: [f64; 3],
        slack: f64,
        exactly: &dyn Fn() -> [Rational; 3],
    ) -> Option<i8> {
        if !self.is_positive {
            return None;
        }
        let in_doubles = cells.radius_towards(near, slack).and_then(|radius| {
            let offsets = [0, 1, 2].map(|i| {
                let center = Interval::narrowest(&self.exact.center()[i]);
                Interval::around(near[i], slack) - center
            });
            let square = offsets.map(Interval::squared);
            (((square[0] + square[1]) + square[2]).sqrt() - radius).sign()
        });
        in_doubles.or_else(|| Some(self.exact.side(&exactly())))
    }

    /// The inspection with a nearest point that is refined in exact arithmetic.
    fn by_refinement(
        &self,
        cells: &CellTree,
        near: [f64; 3],
        found: Option<NearestOnSphere>,
        point: &[Rational; 3],
        sign: Option<i8>,
    ) -> Inspection {
        let level = self.tolerance.squared();
        let mut distance = found
            .as_ref()
            .map_or(DistanceBounds::UNKNOWN, |f| f.distance);
        let mut verdict = Verdict::Undecided;
        if sign == Some(0) || sign.is_none() && self.exact.is_on(point) {
            distance = DistanceBounds::ZERO;
            verdict = Verdict::Inside;
        } else if let Some(found) = &found {
            let goal = RefinementGoal::new(self.relative, self.tolerance.squared());
            let slack = rounding(near);
            let refined = self.exact.refine(cells, near, slack, found, point, &goal);
            if let Some([low, high]) = refined {
                let bounds = [&low, &high].map(|square| Interval::from(square).sqrt());
                distance.low = distance.low.max(bounds[0].low());
                distance.high = distance.high.min(bounds[1].high());
                verdict = match (high.cmp(&level), low.cmp(&level)) {
                    (Ordering::Less | Ordering::Equal, _) => Verdict::Inside,
                    (_, Ordering::Greater) => Verdict::Outside,
                    _ => Verdict::Undecided,
                };
            }
            if verdict == Verdict::Undecided {
                let tolerance = &self.tolerance.exact;
                if distance.high.is_finite() && rational(distance.high) <= *tolerance {
                    verdict = Verdict::Inside;
                } else if rational(distance.low) > *tolerance {
                    verdict = Verdict::Outside;
                }
            }
        }
        let slack = rounding(near);
        let curve = self.curve(cells, near, slack, verdict, &|| point.clone());
        Inspection {
            verdict,
            curve,
            distance: distance.given(verdict, &self.tolerance.exact),
            sign,
        }
    }

    /// The inspection against the sphere R = c, exactly: |ρ − |c|| is compared with the tolerance.
    fn against_sphere(&self, point: &[Rational; 3]) -> Inspection {
        let offsets = [0, 1, 2].map(|i| &point[i] - &self.exact.center()[i]);
        let square: Rational = offsets.iter().map(|x| x * x).sum();
        let radius = self.exact.mean().abs();
        let tolerance = &self.tolerance.exact;
        let (outer, inner) = (&radius + tolerance, &radius - tolerance);
        let meets_outer = square.cmp(&(&outer * &outer));
        let meets_inner = if inner.signum() > 0 {
            square.cmp(&(&inner * &inner))
        } else {
            Ordering::Greater
        };
        let is_inside = meets_outer != Ordering::Greater && meets_inner != Ordering::Less;
        // The farthest point of the sphere is at the distance ρ + c.
        let is_beyond = inner.signum() >= 0 || square >= &inner * &inner;
        let verdict = match is_inside {
            true => Verdict::Inside,
            false => Verdict::Outside,
        };
        let side = square.cmp(&(&radius * &radius));
        let rho = Interval::from(&square).sqrt();
        let distance = (rho - Interval::narrowest(&radius)).abs();
        let mut distance = DistanceBounds {
            low: distance.low(),
            high: distance.high(),
        };
        if side == Ordering::Equal {
            distance = DistanceBounds::ZERO;
        } else if distance.high > (1.0 + self.relative) * distance.low {
            // |ρ − c| = |ρ² − c²|/(ρ + c) does not cancel.
            let above = Interval::from(&(square - &radius * &radius).abs());
            let near = above / (rho + Interval::narrowest(&radius));
            distance = DistanceBounds {
                low: near.low().max(0.0),
                high: near.high(),
            };
        }
        Inspection {
            verdict,
            curve: Some(is_inside && is_beyond),
            distance: distance.given(verdict, tolerance),
            sign: self.is_positive.then_some(match side {
                Ordering::Less => -1,
                Ordering::Equal => 0,
                Ordering::Greater => 1,
            }),
        }
    }
}
