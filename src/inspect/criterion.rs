//! The criterion of Theorem 8: whether the sphere (or circle) about a point meets the surface (or curve).

use super::chart::{CircleSection, SphereSection};
use super::exact;
use super::foot::difference;
use super::inspector::Inspector;
use super::known::{PartialInspection, Point};
use super::sphere::{OnSphere, on_sphere};
use crate::exact::Rational;
use crate::intervals::interval::{exactly, minus, square};
use crate::intervals::{Field, Interval, dot, rationals};

/// A section is left undecided, and its angles are not computed, if it is more work than this ([`SphereSection::work`]).
pub(crate) const MAX_SECTION_WORK: f64 = 1e11;
/// The number of points, among those that the patches leave open, that are tried.
const CANDIDATES: usize = 24;

impl Inspector {
    /// Whether f has both signs at the two points where the line through p and its foot meets the sphere. `false` means that
    /// doubles do not prove it.
    pub(super) fn signs_differ(&self, field: &Field, p: &Point, known: &PartialInspection) -> bool {
        let Some(away) = self.towards_foot(field, p, known) else {
            return false;
        };
        // The box holds the exact point of the sphere in that direction, or opposite to it.
        let direction = exactly(away);
        let radius = Interval::between(self.around[0], self.around[1]) / square(direction).sqrt();
        let center = p.around();
        let sign = |sense: f64| {
            let place = [0, 1, 2].map(|i| center[i] + direction[i] * radius * sense);
            let near = place.map(Interval::middle);
            let off = minus(place, exactly(near)).map(Interval::magnitude);
            field.sign_near(near, off.into_iter().fold(0.0, f64::max))
        };
        let [a, b] = [1.0, -1.0].map(sign);
        matches!((a, b), (Some(a), Some(b)) if a != b)
    }

    fn towards_foot(
        &self,
        field: &Field,
        p: &Point,
        known: &PartialInspection,
    ) -> Option<[f64; 3]> {
        let foot = known.foot.map(|q| difference(q, p.near));
        let is_usable = |v: &[f64; 3]| dot(*v, *v) > 1e-20 * self.around[0] * self.around[0];
        let direction = foot
            .filter(is_usable)
            .unwrap_or_else(|| field.gradient(p.near));
        (dot(direction, direction) > 0.0 && direction.iter().all(|x| x.is_finite()))
            .then_some(direction)
    }

    /// Whether the sphere of radius d about p meets the surface. The caller must ensure that a point of the surface is inside
    /// the sphere.
    pub(super) fn sphere_meets(
        &self,
        field: &Field,
        p: &Point,
        known: &PartialInspection,
    ) -> Option<bool> {
        if self.signs_differ(field, p, known) {
            return Some(true);
        }
        // The patches divide a sphere about the doubles instead of the exact point.
        let slack = Interval::from(p.slack) + Interval::from(self.around[1])
            - Interval::from(self.around[0]);
        let is_same = p.slack <= 0.0 && self.around[0] >= self.around[1];
        let slack = if is_same { 0.0 } else { slack.high() };
        let patches = on_sphere(field, p.near, self.around[0], slack);
        let points = match patches {
            OnSphere::Zeros => return Some(true),
            OnSphere::NoZeros => return Some(false),
            OnSphere::Unknown(points) => points,
        };
        let step = points.len().div_ceil(CANDIDATES).max(1);
        let starts = points.iter().step_by(step).map(|x| difference(*x, p.near));
        let foot = match &known.exact_foot {
            Some(foot) => Some(exact::exact_difference(foot, p.exactly())),
            None => self.towards_foot(field, p, known).map(rationals),
        };
        let backwards = foot.clone().map(|v| v.map(|x| -x));
        let exact_sign = |v: [Rational; 3]| {
            let x = exact::on_sphere(p.exactly(), &self.tolerance, &v)?;
            Some(field.polynomial().evaluate(&x).signum())
        };
        let directions = foot.into_iter().chain(backwards);
        let mut signs = directions
            .chain(starts.map(rationals))
            .filter_map(exact_sign);
        let first = signs.next();
        if first == Some(0) || signs.any(|sign| Some(sign) != first) {
            return Some(true);
        }
        self.section(field, p)
    }

    pub(super) fn circle_meets(&self, field: &Field, p: &Point) -> bool {
        CircleSection::new(field.polynomial(), p.exactly(), &self.tolerance).has_points()
    }

    /// Decides by the exact angle ranges of the section; `None` if they are too much work.
    pub(super) fn section(&self, field: &Field, p: &Point) -> Option<bool> {
        let section = SphereSection::new(field.polynomial(), p.exactly(), &self.tolerance);
        (section.work() <= MAX_SECTION_WORK)
            .then(|| section.has_points(&self.limits).ok())
            .flatten()
    }
}
