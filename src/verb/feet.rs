//! The feet of inspected points: the nearest point of the form, with the normal there.

use super::against::{Against, AgainstPlaneCurve};
use super::inspect::InspectionTask;
use crate::exact::Rational;
use crate::inspect::{Foot, FootCandidate, Inspection, PlanePoint, unit};
use crate::intervals::rational;

/// A point so near to a curve, in parts of the size of the curve, that the direction to it does not tell the side.
const NEAR: f64 = 1e-6;
/// A point so near to a curve, in parts of the coordinates, that their rounding changes the direction to it.
const ROUNDED: f64 = 1e-12;
/// Two points that far from the curve, in parts of its size, may be on the wrong sides of it.
const FAR: f64 = 1e-2;

impl InspectionTask {
    /// The nearest point of the form to a point, in original coordinates, and the unit normal of the form there; in the plane z is 0.
    /// `None` if none was found that passes the check. `found` is the inspection of the point.
    ///
    /// The foot is approximate, to nearly all digits of a double. It is checked: its distance from the point is within the certified bounds,
    /// up to 10⁻⁹ of the largest coordinate, and it is on the form up to that.
    ///
    /// ```
    /// use stellate::language::Numbers;
    /// use stellate::verb::{self, Given, InspectionOptions, Work};
    /// let given = Given::read("r = 5", Numbers::Exact)?;
    /// let task = verb::inspect(given, 2, &InspectionOptions::default(), &Work::default())?;
    /// let point = ["6", "8", "0"].map(|q| q.parse().unwrap());
    /// let found = task.point(&point);
    /// let foot = task.foot(&point, &found).unwrap();
    /// let near = |a: [f64; 3], b: [f64; 3]| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-14);
    /// assert!(near(foot.point, [3.0, 4.0, 0.0]) && near(foot.normal.unwrap(), [0.6, 0.8, 0.0]));
    /// assert!((found.signed_distance().unwrap()[0] - 5.0).abs() < 1e-5);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    #[must_use]
    pub fn foot(&self, point: &[Rational; 3], found: &Inspection) -> Option<Foot> {
        let near = point.each_ref().map(Rational::to_f64);
        if !found.distance.high.is_finite() || near.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let mut candidate = match &self.against {
            Against::Equation(inspector) => return inspector.foot(point, found),
            Against::Plane(plane) => plane.foot(point, found)?,
            Against::Space(inspector) => FootCandidate::on_form(inspector.foot(point)?.point, None),
            Against::Patch(inspector) => inspector.foot(point)?,
            Against::Harmonic(inspector) => inspector.foot(point)?,
            Against::Superquadric(inspector) => inspector.foot(point),
        };
        if found.distance.high <= 0.0 {
            // A point of the form is its own foot, also at the origin, where the smallest error is large.
            candidate.foot.point = near;
        }
        candidate.checked(near, &found.distance)
    }
}

impl AgainstPlaneCurve {
    fn foot(&self, point: &[Rational; 3], found: &Inspection) -> Option<FootCandidate> {
        let [x, y, z] = point;
        let foot = self.curve.foot(&[x.clone(), y.clone()])?;
        let [a, b] = foot.point;
        let height = match self.is_cylinder {
            true => z.to_f64(),
            false => 0.0,
        };
        let normal = foot.tangent.and_then(|[u, v]| {
            // To the right of the direction in which the parameter grows.
            let right = [v, -u];
            let sign = match self.sides {
                None => 1.0,
                Some(_) => {
                    self.outward([x.to_f64() - a, y.to_f64() - b], foot.point, right, found)?
                }
            };
            Some([sign * right[0], sign * right[1], 0.0])
        });
        Some(FootCandidate::on_form([a, b, height], normal))
    }

    /// 1 or −1 if a normal points out of the inside or into it; `None` if that is not known. `away` points from the foot to the point.
    fn outward(
        &self,
        away: [f64; 2],
        foot: [f64; 2],
        normal: [f64; 2],
        found: &Inspection,
    ) -> Option<f64> {
        let center = self.curve.center().each_ref().map(Rational::to_f64);
        let own = self
            .curve
            .size_near(&[foot[0] - center[0], foot[1] - center[1]]);
        // Far from the origin the coordinates of the foot are rounded.
        let step = (NEAR * own).max(ROUNDED * foot[0].abs().max(foot[1].abs()));
        let length = away[0].hypot(away[1]);
        let dot = |u: [f64; 2]| u[0] * normal[0] + u[1] * normal[1];
        if let Some(sign) = found.sign.filter(|sign| *sign != 0)
            && length > step
        {
            // The segment from the foot to the point is on one side.
            let along = f64::from(sign) * dot(unit(away)?);
            return (along.abs() > 0.5).then(|| along.signum());
        }
        let sides = self.sides.as_ref()?;
        if step > FAR * own {
            return None;
        }
        let beside = |sense: f64| {
            let near = [0, 1].map(|i| foot[i] + sense * step * normal[i]);
            let exactly = || near.map(rational);
            let bounds = self.curve.inspect_near(near, &exactly).distance;
            sides.sign(
                &PlanePoint {
                    near,
                    slack: 0.0,
                    exactly: &exactly,
                },
                &bounds,
            )
        };
        match [beside(1.0), beside(-1.0)] {
            [1, -1] => Some(1.0),
            [-1, 1] => Some(-1.0),
            _ => None,
        }
    }
}
