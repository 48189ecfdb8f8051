//! Inspection of points against a superquadric with any exponents. The superquadric itself is compared; it needs no equation.

mod arc;
mod body;
mod exact;
mod foot;

use std::cmp::Ordering;
use std::sync::Arc;

use self::body::{Body, Found};
use self::exact::ExactPoints;
use super::known::rounding;
use super::nearest::FootCandidate;
use super::tolerance::Tolerance;
use super::{DistanceBounds, Inspection, InspectorOptions, Verdict};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::intervals::Interval;
use crate::limits::Limits;
use crate::shape::{Radial, SpaceSuperquadric, Superquadric};

#[cfg(test)]
mod laws;

/// Bounds of a distance do not become closer than this part of it, because of rounding;
const ROUNDING: f64 = 4e-15;
/// and what more divisions than this leave open is due to rounding.
const DIVISIONS: usize = 4000;
/// Newton's method for a foot starts from bounds that are so close.
const NEAR_FOOT: f64 = 1e-9;

/// A superquadric of the plane or of space with a tolerance, ready to be compared with points.
///
/// Points are reflected into the octant x, y, z ≥ 0. The surface there is divided into pieces, each of which lies in a thin polyhedron,
/// and the nearest ones are divided first. All numbers are intervals of doubles. Points at the tolerance are decided exactly if the
/// nearest point is a vertex, or on a straight part of the surface: (±a1, 0), or the faces and edges for ε = 2. Other points are
/// undecided only if the bounds in doubles, about 15 digits, do not decide them.
#[derive(Clone, Debug)]
pub struct SuperquadricInspector {
    shape: Arc<Shape>,
    body: Arc<Body>,
    exact: Arc<ExactPoints>,
    tolerance: Tolerance,
    /// Bounds of a distance may differ by this part of it.
    relative: f64,
    /// The largest number of divisions for one point.
    cells: usize,
    limits: Limits,
}

#[derive(Debug)]
enum Shape {
    Plane {
        shape: Superquadric,
        /// Whether points are compared with the cylinder over the curve.
        is_cylinder: bool,
    },
    Space(SpaceSuperquadric),
}

impl SuperquadricInspector {
    /// The inspector of a plane superquadric, for points (x, y, 0); with `is_cylinder` for points in space, which are compared with the
    /// cylinder over it.
    ///
    /// ```
    /// use stellate::inspect::{InspectorOptions, SuperquadricInspector, Verdict};
    /// use stellate::limits::Limits;
    /// use stellate::shape::Superquadric;
    /// // The astroid |x|^(2/3) + |y|^(2/3) = 1
    /// let astroid = Superquadric::new([1.into(), 1.into()], 3.into(), 1.into()).unwrap();
    /// let options = InspectorOptions::new("1/10".parse()?);
    /// let inspector = SuperquadricInspector::plane(&astroid, false, &options, &Limits::none())?;
    /// let at = |x: &str| inspector.inspect(&[x, "0", "0"].map(|q| q.parse().unwrap()));
    /// // The nearest point is the cusp (1, 0), exactly at the tolerance.
    /// assert_eq!((at("1.1").verdict, at("1.1").sign), (Verdict::Inside, Some(1)));
    /// assert_eq!(at("1.1000000000001").verdict, Verdict::Outside);
    /// // The nearest point to the center is (1/√8, 1/√8), at the distance 1/2.
    /// let found = at("0").distance;
    /// assert!(found.low <= 0.5 && 0.5 <= found.high && found.high - found.low < 1e-6);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`](crate::error::Error::Usage) for a tolerance that is not positive; [`Error::Limit`](crate::error::Error::Limit)
    /// for exponents with numerators or denominators of more than 40 bits.
    pub fn plane(
        shape: &Superquadric,
        is_cylinder: bool,
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let (body, exact) = (Body::plane(shape)?, ExactPoints::plane(shape));
        let shape = Shape::Plane {
            shape: shape.clone(),
            is_cylinder,
        };
        Self::new(shape, body, exact, options, limits)
    }

    /// The inspector of a superquadric in space.
    ///
    /// # Errors
    /// As [`Self::plane`].
    pub fn space(
        shape: &SpaceSuperquadric,
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let (body, exact) = (Body::space(shape)?, ExactPoints::space(shape));
        Self::new(Shape::Space(shape.clone()), body, exact, options, limits)
    }

    fn new(
        shape: Shape,
        body: Body,
        exact: ExactPoints,
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let digits = i32::try_from(options.digits.min(14)).invariant("14 is small");
        Ok(Self {
            shape: Arc::new(shape),
            body: Arc::new(body),
            exact: Arc::new(exact),
            tolerance: Tolerance::new(&options.tolerance)?,
            relative: 0.1f64.powi(digits),
            cells: options.cubes,
            limits: limits.clone(),
        })
    }

    /// The inspector of the same superquadric with another tolerance.
    ///
    /// # Errors
    /// [`Error::Usage`](crate::error::Error::Usage) for a tolerance that is not positive.
    pub fn with_tolerance(&self, tolerance: &Rational) -> Result<Self> {
        Ok(Self {
            tolerance: Tolerance::new(tolerance)?,
            ..self.clone()
        })
    }

    /// Inspects a point.
    #[must_use]
    pub fn inspect(&self, point: &[Rational; 3]) -> Inspection {
        self.inspect_near(point.each_ref().map(Rational::to_f64), &|| point.clone())
    }

    /// Inspects a point whose nearest doubles are `near`. Its exact coordinates are computed only if they are needed.
    ///
    /// Cost: some tens of pieces in the plane and some hundreds in space for 6 digits, about a microsecond each.
    #[must_use]
    pub fn inspect_near(&self, near: [f64; 3], exactly: &dyn Fn() -> [Rational; 3]) -> Inspection {
        if self.limits.check().is_err() || near.iter().any(|x| !x.is_finite()) {
            return Inspection::UNKNOWN;
        }
        let slack = rounding(near);
        let about = self.octant(near.map(|x| Interval::around(x, slack)));
        let sign = self.sign(about, exactly);
        if sign == Some(0) {
            return Inspection {
                verdict: Verdict::Inside,
                curve: self.curve(about, Verdict::Inside, exactly),
                distance: DistanceBounds::ZERO,
                sign,
            };
        }
        let is_enough = |found: &Found| {
            let DistanceBounds { low, high } = found.distance;
            self.tolerance.verdict(&found.distance).is_some() && high - low <= self.relative * high
        };
        let mut found = self
            .body
            .nearest(about, 0.5 * self.relative, self.cells, &self.limits);
        let mut verdict = self.tolerance.verdict(&found.distance);
        let mut narrow = about;
        if !is_enough(&found) {
            let point = exactly();
            narrow = self.octant(point.each_ref().map(Interval::narrowest));
            let most = self.cells.min(DIVISIONS);
            let again = self.body.nearest(narrow, ROUNDING, most, &self.limits);
            found.distance.low = found.distance.low.max(again.distance.low);
            found.distance.high = found.distance.high.min(again.distance.high);
            verdict = self.tolerance.verdict(&found.distance);
            if verdict.is_none() {
                let square = self.tolerance.squared();
                let is_near = self.exact.nearest(&point).is_some_and(|d| d <= square);
                verdict = is_near.then_some(Verdict::Inside);
            }
        }
        let verdict = verdict.unwrap_or(Verdict::Undecided);
        Inspection {
            verdict,
            curve: self.curve(narrow, verdict, exactly),
            distance: found.distance.given(verdict, &self.tolerance.exact),
            sign,
        }
    }

    /// The sign of [`SuperquadricInspector::inspect_near`], without the distance.
    pub(crate) fn side(&self, near: [f64; 3], exactly: &dyn Fn() -> [Rational; 3]) -> Option<i8> {
        self.sign(self.octant(near.map(Interval::from)), exactly)
    }

    /// The foot of a point, with the normal away from the center.
    pub(crate) fn foot(&self, point: &[Rational; 3]) -> FootCandidate {
        let about = self.octant(point.each_ref().map(Interval::narrowest));
        let found = self
            .body
            .nearest(about, NEAR_FOOT, self.cells.min(DIVISIONS), &self.limits);
        let signs = point
            .each_ref()
            .map(|x| if x.signum() < 0 { -1.0 } else { 1.0 });
        let mut foot = self.body.foot(about.map(Interval::middle), &found.place);
        for i in 0..3 {
            foot.foot.point[i] *= signs[i];
            if let Some(normal) = &mut foot.foot.normal {
                normal[i] *= signs[i];
            }
        }
        if matches!(
            *self.shape,
            Shape::Plane {
                is_cylinder: true,
                ..
            }
        ) {
            foot.foot.point[2] = point[2].to_f64();
        }
        foot
    }

    /// The reflected point, without its height for a plane curve.
    fn octant(&self, p: [Interval; 3]) -> [Interval; 3] {
        let [x, y, z] = p.map(Interval::abs);
        match *self.shape {
            Shape::Plane { .. } => [x, y, Interval::ZERO],
            Shape::Space(_) => [x, y, z],
        }
    }

    /// The side on which a point is; `None` if that would need numbers that are too long.
    fn sign(&self, about: [Interval; 3], exactly: &dyn Fn() -> [Rational; 3]) -> Option<i8> {
        let above = self.body.norm(about) - Interval::from(1.0);
        above.sign().or_else(|| {
            let point = exactly();
            let compared = match &*self.shape {
                Shape::Plane { shape, .. } => {
                    let [x, y, _] = point;
                    shape.compare(&[x, y])
                }
                Shape::Space(shape) => shape.compare(&point),
            };
            Some(match compared.ok()? {
                Ordering::Less => -1,
                Ordering::Equal => 0,
                Ordering::Greater => 1,
            })
        })
    }

    /// The criterion of Theorem 8: the superquadric is connected, so it meets the sphere exactly if it has a point in the ball and one
    /// that is not inside the sphere.
    fn curve(
        &self,
        about: [Interval; 3],
        verdict: Verdict,
        exactly: &dyn Fn() -> [Rational; 3],
    ) -> Option<bool> {
        match verdict {
            Verdict::Outside => return Some(false),
            Verdict::Uncertain | Verdict::Undecided => return None,
            Verdict::Inside => {}
        }
        if matches!(
            *self.shape,
            Shape::Plane {
                is_cylinder: true,
                ..
            }
        ) {
            return Some(true);
        }
        let beyond = self
            .body
            .goes_beyond(about, self.tolerance.around, self.cells, &self.limits);
        beyond.or_else(|| {
            let square = self.tolerance.squared();
            let farthest = self.exact.farthest(&exactly())?;
            (farthest >= square).then_some(true)
        })
    }
}
