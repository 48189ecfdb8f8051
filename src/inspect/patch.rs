//! Inspection of points against a patch. The patch itself is compared, not the zero set of its equation, which can have more
//! points.

use std::sync::Arc;

use super::boxes::PatchBoxes;
use super::squared_distance::{squared_in_doubles, upper_root};
use super::{DistanceBounds, Inspection, Inspector, InspectorOptions, Verdict};
use crate::error::Result;
use crate::exact::Rational;
use crate::intervals::Interval;
use crate::limits::Limits;
use crate::shape::{ImplicitSurface, Patch, PatchInDoubles};

/// The number of starting points along each parameter, in the search for the nearest point.
const STARTS: u32 = 48;
/// The number of nearest starting points from which the search goes downhill.
const FOLLOWED: usize = 4;
/// The largest number of steps downhill from each starting point.
const STEPS: usize = 40;
/// To prove that the patch is farther from a point than some radius, these parts of the distance of the nearest known point are
/// tried in turn.
const PARTS: [f64; 5] = [0.999, 0.98, 0.9, 0.5, 0.1];

/// A patch with a tolerance, ready to be compared with points.
///
/// A point that is farther than the tolerance from the zero set of the equation is outside. Otherwise a point of the patch
/// within the tolerance is searched in doubles and proved exactly. If there is none, boxes of the parameters may prove that the
/// point is outside; if they do not, it is undecided.
#[derive(Clone, Debug)]
pub struct PatchInspector {
    zero_set: Inspector,
    shape: Arc<Shape>,
    tolerance: Rational,
    budget: usize,
}

/// What does not depend on the tolerance.
#[derive(Debug)]
struct Shape {
    patch: Patch,
    doubles: PatchInDoubles,
    boxes: PatchBoxes,
    /// The angles τ of the starting points, where s = tan(τ/2), and the points of the patch there.
    starts: Vec<([f64; 2], [f64; 3])>,
}

impl PatchInspector {
    /// The inspector of a patch; `surface` is the zero set of its equation.
    ///
    /// # Errors
    /// Those of [`Inspector::surface`].
    pub fn new(
        patch: &Patch,
        surface: &ImplicitSurface,
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let angle = |k: u32| {
            let turn = (f64::from(k) + 0.5) / f64::from(STARTS);
            std::f64::consts::TAU * turn - std::f64::consts::PI
        };
        let pairs = (0..STARTS).flat_map(|i| (0..STARTS).map(move |j| [angle(i), angle(j)]));
        let doubles = patch.in_doubles();
        let starts = pairs.filter_map(|at| Some((at, point_near(&doubles, at)?)));
        let starts = starts.collect();
        Ok(Self {
            zero_set: Inspector::surface(surface, options, limits)?,
            shape: Arc::new(Shape {
                patch: patch.clone(),
                boxes: PatchBoxes::new(patch),
                starts,
                doubles,
            }),
            tolerance: options.tolerance.clone(),
            budget: options.cubes,
        })
    }

    /// The inspector of the same patch with another tolerance; what was computed for the patch is shared.
    ///
    /// # Errors
    /// [`crate::error::Error::Usage`] for a tolerance that is not positive.
    pub fn with_tolerance(&self, tolerance: &Rational) -> Result<Self> {
        Ok(Self {
            zero_set: self.zero_set.with_tolerance(tolerance)?,
            tolerance: tolerance.clone(),
            ..self.clone()
        })
    }

    /// Whether the equation has a factor that is too large for exact expansions; see [`Inspector::is_in_doubles_alone`].
    #[must_use]
    pub fn is_in_doubles_alone(&self) -> bool {
        self.zero_set.is_in_doubles_alone()
    }

    /// Inspects a point.
    #[must_use]
    pub fn inspect(&self, point: &[Rational; 3]) -> Inspection {
        let of_zero_set = self.zero_set.inspect(point);
        let found = self.nearest(point);
        let high = found.as_ref().map_or(f64::INFINITY, upper_root);
        let around = point.each_ref().map(Interval::narrowest);
        let tolerance = Interval::narrowest(&self.tolerance);
        let level = &self.tolerance * &self.tolerance;
        let is_inside = found.is_some_and(|squared| squared <= level);
        let verdict = if is_inside {
            Verdict::Inside
        } else if of_zero_set.verdict == Verdict::Outside
            || self
                .shape
                .boxes
                .are_farther(&around, tolerance, self.budget)
        {
            Verdict::Outside
        } else {
            Verdict::Undecided
        };
        let low = self.lower_bound(&around, of_zero_set.distance.low, high);
        Inspection {
            verdict,
            curve: match verdict {
                Verdict::Outside => Some(false),
                Verdict::Inside if of_zero_set.curve == Some(false) => Some(false),
                Verdict::Inside if self.goes_out(point, &level) => Some(true),
                _ => None,
            },
            distance: DistanceBounds { low, high }.given(verdict, &self.tolerance),
            sign: None,
        }
    }

    /// Whether it is proved that a patch with a point in the ball also has a point on the sphere: it is connected and has a
    /// point outside.
    fn goes_out(&self, point: &[Rational; 3], level: &Rational) -> bool {
        let center = point.each_ref().map(Rational::to_f64);
        let farthest = self.shape.starts.iter().max_by(|(_, a), (_, b)| {
            squared_in_doubles(a, &center).total_cmp(&squared_in_doubles(b, &center))
        });
        let exact = farthest.and_then(|(at, _)| self.exactly(*at, point));
        self.shape.boxes.is_connected && exact.is_some_and(|squared| squared >= *level)
    }

    /// A lower bound of the distance: the larger one of the bound for the zero set and the bound that the boxes prove.
    fn lower_bound(&self, around: &[Interval; 3], known: f64, high: f64) -> f64 {
        if !high.is_finite() || known >= PARTS[0] * high {
            return known;
        }
        let proved = |part: &f64| {
            let radius = Interval::from(part * high);
            self.shape
                .boxes
                .are_farther(around, radius, self.budget / 10)
        };
        let parts = PARTS.iter().filter(|part| **part * high > known);
        let best = parts.copied().find(|part| proved(part));
        best.map_or(known, |part| known.max(part * high))
    }

    /// The point of the patch at two angles, in doubles.
    pub(super) fn near(&self, at: [f64; 2]) -> Option<[f64; 3]> {
        point_near(&self.shape.doubles, at)
    }

    /// The exact point of the patch near two angles.
    pub(super) fn exact_point(&self, at: [f64; 2]) -> Option<[Rational; 3]> {
        let [s, t] = at.map(|angle| Rational::try_from((angle / 2.0).tan()).ok());
        self.shape.patch.point(&[s?, t?])
    }

    /// The exact squared distance between a point and the point of the patch at two angles.
    fn exactly(&self, at: [f64; 2], point: &[Rational; 3]) -> Option<Rational> {
        let q = self.exact_point(at)?;
        let differences = q.iter().zip(point).map(|(a, b)| a - b);
        Some(differences.fold(Rational::zero(), |sum, d| sum + &d * &d))
    }

    /// The squared distance of the nearest point of the patch that is found.
    fn nearest(&self, point: &[Rational; 3]) -> Option<Rational> {
        let center = point.each_ref().map(Rational::to_f64);
        let ends = self.lowest(&center).into_iter();
        ends.filter_map(|at| self.exactly(at, point)).min()
    }

    /// The angles of the nearest point of the patch that is found.
    pub(super) fn nearest_angles(&self, center: &[f64; 3]) -> Option<[f64; 2]> {
        let far = |at: &[f64; 2]| {
            let point = self.near(*at);
            point.map_or(f64::INFINITY, |point| squared_in_doubles(&point, center))
        };
        let ends = self.lowest(center).into_iter();
        ends.min_by(|a, b| far(a).total_cmp(&far(b)))
    }

    /// The angles of local minima of the distance.
    fn lowest(&self, center: &[f64; 3]) -> Vec<[f64; 2]> {
        let mut starts: Vec<&([f64; 2], [f64; 3])> = self.shape.starts.iter().collect();
        let count = FOLLOWED.min(starts.len());
        let order = |a: &&([f64; 2], [f64; 3]), b: &&([f64; 2], [f64; 3])| {
            squared_in_doubles(&a.1, center).total_cmp(&squared_in_doubles(&b.1, center))
        };
        if count < starts.len() {
            starts.select_nth_unstable_by(count, order);
        }
        let ends = starts[..count]
            .iter()
            .map(|(at, _)| self.downhill(*at, center));
        ends.collect()
    }

    /// A local minimum of the distance, in doubles, by damped steps of the methods of Gauss and Newton from two angles.
    fn downhill(&self, from: [f64; 2], center: &[f64; 3]) -> [f64; 2] {
        const DIFFERENCE: f64 = 1e-6;
        let distance = |at: [f64; 2]| {
            self.near(at)
                .map_or(f64::INFINITY, |q| squared_in_doubles(&q, center))
        };
        let (mut at, mut best, mut damping) = (from, distance(from), 1e-3);
        for _ in 0..STEPS {
            let Some(q) = self.near(at) else {
                break;
            };
            let side = |v: usize, by: f64| {
                let mut beside = at;
                beside[v] += by;
                self.near(beside)
            };
            let derivative = |v: usize| -> Option<[f64; 3]> {
                let (a, b) = (side(v, -DIFFERENCE)?, side(v, DIFFERENCE)?);
                Some([0, 1, 2].map(|i| (b[i] - a[i]) / (2.0 * DIFFERENCE)))
            };
            let (Some(u), Some(v)) = (derivative(0), derivative(1)) else {
                break;
            };
            let off = [0, 1, 2].map(|i| center[i] - q[i]);
            let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let (uu, uv, vv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v));
            let (a, b) = (dot(&u, &off), dot(&v, &off));
            let (uu, vv) = (uu * (1.0 + damping), vv * (1.0 + damping));
            let determinant = uu * vv - uv * uv;
            let step = [
                (a * vv - b * uv) / determinant,
                (b * uu - a * uv) / determinant,
            ];
            if !step.iter().all(|x| x.is_finite()) {
                break;
            }
            let next = [at[0] + step[0], at[1] + step[1]];
            let now = distance(next);
            if now < best {
                (at, best, damping) = (next, now, damping * 0.2);
            } else {
                damping = damping * 8.0 + 1e-9;
            }
            if step.iter().all(|x| x.abs() < 1e-15) {
                break;
            }
        }
        at
    }
}

/// The point of a patch at two angles, in doubles.
fn point_near(doubles: &PatchInDoubles, at: [f64; 2]) -> Option<[f64; 3]> {
    let ratio = |angle: f64| {
        let (sin, cos) = (angle / 2.0).sin_cos();
        [sin, cos]
    };
    doubles.at(at.map(ratio))
}
