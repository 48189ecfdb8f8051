//! Inspection of points against one surface or plane curve. Each point is decided by the cheapest rule that can.

use std::sync::Arc;

use super::common_zeros::CommonZeros;
use super::distance::{Goal, nearest};
use super::foot::{approach, enclose};
use super::known::{PartialInspection, Point, rounding};
use super::origin::far_middle;
use super::{DistanceBounds, Inspection, Verdict};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::factor::{conjugate_pair, factor_plane, factor_space};
use crate::intervals::{Field, Interval, dot, rational};
use crate::limits::Limits;
use crate::options::options;
use crate::poly::SparsePolynomial;
use crate::shape::{ImplicitCurve, ImplicitSurface};

#[cfg(test)]
#[path = "inspector_laws.rs"]
mod laws;

/// Polynomials with more than this many monomials (divisors of monomials count, too) are inspected in doubles alone; those of
/// degree 16 in space and of degree 43 in the plane have fewer. A point that doubles do not decide is then undecided.
pub(crate) const MAX_EXACT_MONOMIALS: usize = 1000;
/// The number of cubes is calibrated for a dense polynomial of degree 6, whose expansion takes this many operations; more
/// expensive polynomials get proportionally fewer cubes.
const CUBE_WORK: usize = 84 * 18;
options! {
    /// How points are inspected.
    InspectorOptions of {
        /// The tolerance d > 0: the largest distance that counts as inside.
        tolerance: Rational,
    } {
        /// The search radius for the nearest point; at least the tolerance. By default the search goes on until the nearest point
        /// is found.
        reach: Option<f64> = None,
        /// The number of significant digits that the bounds of a distance should determine.
        digits: u32 = 6,
        /// The largest number of cubes that are divided for one point and one factor of the polynomial; fewer for degrees above
        /// 6.
        cubes: usize = 50_000,
    }
}

/// The kind of zero set that is inspected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Surface,
    /// A curve in the plane of x and y: the circle takes the place of the sphere.
    Plane,
}

/// An irreducible factor of the polynomial. It changes its sign at its zeros, which a repeated factor does not; if it does not either, its
/// zeros may be known as a curve.
#[derive(Debug)]
pub(super) struct Factor {
    pub(super) field: Field,
    pub(super) multiplicity: usize,
    pub(super) curve: Option<CommonZeros>,
}

/// A surface or plane curve with a tolerance, ready to be compared with points.
#[derive(Clone, Debug)]
pub struct Inspector {
    pub(super) kind: Kind,
    /// The origin of the coordinates of the factors, unless it is that of the points.
    pub(super) origin: Option<[Rational; 3]>,
    /// Whether the origin is a point that is inspected.
    pub(super) is_local: bool,
    pub(super) factors: Arc<[Factor]>,
    pub(super) tolerance: Rational,
    /// Doubles below and above the tolerance.
    pub(super) around: [f64; 2],
    /// The search radius; distances larger than this are reported as infinite. `None` if the nearest point is searched anywhere.
    pub(super) asked: Option<f64>,
    pub(super) goal: Goal,
    pub(super) limits: Limits,
}

impl Inspector {
    /// The inspector of a surface, for points in the surface's original coordinates; its center is taken into account.
    ///
    /// ```
    /// use stellate::inspect::{InspectorOptions, Inspector, Verdict};
    /// use stellate::language::{Numbers, parse_form};
    /// use stellate::limits::Limits;
    /// use stellate::shape::Form;
    ///
    /// let Form::Surface(sphere) = parse_form("x^2 + y^2 + z^2 = 1", "<form>", Numbers::Exact)? else { panic!() };
    /// let options = InspectorOptions::new("1/10".parse()?);
    /// let inspector = Inspector::surface(&sphere, &options, &Limits::none())?;
    /// let at = |x: &str, y: &str| inspector.inspect(&[x, y, "0"].map(|q| q.parse().unwrap()));
    /// // Exactly at the distance 1/10: the sphere about the point touches the surface.
    /// assert_eq!(at("0.66", "0.88").verdict, Verdict::Inside);
    /// assert_eq!(at("0.66", "0.88").curve, Some(true));
    /// assert_eq!(at("0.66", "0.8800000000000000000000000001").verdict, Verdict::Outside);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] for a constant, a tolerance that is not positive or a reach that is not finite; those of [`factor_space`].
    pub fn surface(
        surface: &ImplicitSurface,
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let polynomial = surface.polynomial();
        let found = factor_space(polynomial, limits)?.factors;
        let factors = found.into_iter().map(|f| (f.polynomial, f.multiplicity));
        let inspector = Self::new(
            Kind::Surface,
            polynomial,
            factors.collect(),
            options,
            limits,
        )?;
        Ok(inspector.moved(surface.center().each_ref()))
    }

    /// The inspector of a plane curve, for points (x, y, 0) in the curve's original coordinates; its center is taken into
    /// account.
    ///
    /// # Errors
    /// As [`Self::surface`], and those of [`factor_plane`].
    pub fn plane(
        curve: &ImplicitCurve,
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        let found = factor_plane(curve.polynomial(), limits)?.factors;
        let factors = found
            .iter()
            .map(|f| (SparsePolynomial::from(&f.polynomial), f.multiplicity));
        let inspector = Self::new(
            Kind::Plane,
            &SparsePolynomial::from(curve.polynomial()),
            factors.collect(),
            options,
            limits,
        )?;
        let [a, b] = curve.center();
        Ok(inspector.moved([a, b, &Rational::zero()]))
    }

    fn new(
        kind: Kind,
        polynomial: &SparsePolynomial<3>,
        factors: Vec<(SparsePolynomial<3>, usize)>,
        options: &InspectorOptions,
        limits: &Limits,
    ) -> Result<Self> {
        if factors.is_empty() {
            return Err(Error::Usage("a constant has no surface".into()));
        }
        let around = doubles_about(&options.tolerance)?;
        if let Some(reach) = options.reach.filter(|reach| !reach.is_finite()) {
            return Err(Error::Usage(format!(
                "the reach {reach}: expected a finite number, such as 10"
            )));
        }
        let origin = far_middle(polynomial, &options.tolerance, limits)?;
        let factors = factors.into_iter().map(|(f, multiplicity)| {
            let f = match &origin {
                Some(origin) => f.about(origin, limits)?,
                None => f,
            };
            let pair = match kind {
                Kind::Surface => conjugate_pair(&f, limits)?,
                Kind::Plane => None,
            };
            Ok(Factor {
                field: Field::new(&f),
                multiplicity,
                curve: pair.and_then(|pair| CommonZeros::new(&pair)),
            })
        });
        let factors: Vec<Factor> = factors.collect::<Result<_>>()?;
        let mut inspector = Self {
            kind,
            origin,
            is_local: false,
            factors: factors.into(),
            tolerance: options.tolerance.clone(),
            around,
            asked: options.reach,
            goal: Goal {
                reach: 0.0,
                tolerance: around[1],
                relative: 0.1f64
                    .powi(i32::try_from(options.digits.min(20)).invariant("20 is small"))
                    .max(1e-14),
                cubes: options.cubes,
            },
            limits: limits.clone(),
        };
        inspector.extend_reach();
        Ok(inspector)
    }

    /// The inspector of the same zero set with another tolerance; its factors are shared.
    ///
    /// # Errors
    /// [`Error::Usage`] for a tolerance that is not positive.
    pub fn with_tolerance(&self, tolerance: &Rational) -> Result<Self> {
        let around = doubles_about(tolerance)?;
        let mut inspector = Self {
            tolerance: tolerance.clone(),
            around,
            ..self.clone()
        };
        inspector.goal.tolerance = around[1];
        inspector.extend_reach();
        Ok(inspector)
    }

    /// Makes the search radius at least the tolerance.
    fn extend_reach(&mut self) {
        let tolerance = self.around[1];
        self.asked = self.asked.map(|reach| reach.max(tolerance));
        // A slightly larger radius, so that a zero beyond it is outside for every slack of a point. Any margin is sound.
        self.goal.reach = self.asked.unwrap_or(0.0).max(tolerance * (1.0 + 1e-9));
    }

    /// Whether a factor has too many monomials for exact expansions (more than 1000, divisors included).
    #[must_use]
    pub fn is_in_doubles_alone(&self) -> bool {
        let mut sizes = self.factors.iter().map(|factor| factor.field.monomials());
        sizes.any(|size| size > MAX_EXACT_MONOMIALS)
    }

    /// Inspects a point. A point with a coordinate beyond the largest double is undecided.
    ///
    /// Cost: a point whose distance is small against the radii of curvature takes about ten evaluations of f and one Taylor
    /// expansion, in doubles. Other points take a search of cubes. Points exactly or almost at the tolerance take exact
    /// arithmetic.
    #[must_use]
    pub fn inspect(&self, point: &[Rational; 3]) -> Inspection {
        let point = &*self.relative(point);
        let near = point.each_ref().map(Rational::to_f64);
        if !near.iter().all(|x| x.is_finite()) {
            return Inspection::UNKNOWN;
        }
        let off: Rational = (0..3).map(|i| (rational(near[i]) - &point[i]).abs()).sum();
        let slack = if off.is_zero() {
            0.0
        } else {
            Interval::from(&off).high()
        };
        self.of_point(&Point::new(near, slack, &|| point.clone()))
    }

    /// Inspects a point whose nearest doubles are `near`. The exact coordinates are computed only if they are needed.
    #[must_use]
    pub fn inspect_near(&self, near: [f64; 3], exactly: &dyn Fn() -> [Rational; 3]) -> Inspection {
        if self.origin.is_some() {
            return self.inspect(&exactly());
        }
        if !near.iter().all(|x| x.is_finite()) {
            return Inspection::UNKNOWN;
        }
        self.of_point(&Point::new(near, rounding(near), exactly))
    }

    fn of_point(&self, p: &Point) -> Inspection {
        self.in_these_coordinates(p)
            .unwrap_or_else(|| self.in_coordinates_about(p))
    }

    /// The findings for a point; `None` if it must be inspected in coordinates about the point.
    pub(super) fn in_these_coordinates(&self, p: &Point) -> Option<Inspection> {
        let flat = p.flattened();
        let at = |field: &Field| if field.is_flat() { &flat } else { p };
        let mut parts: Vec<PartialInspection> = self
            .factors
            .iter()
            .map(|factor| {
                let curve = factor.curve.as_ref();
                let point = at(&factor.field);
                let known = curve.and_then(|curve| self.by_curve(curve, &factor.field, point));
                known.unwrap_or_else(|| self.of_factor(factor, point))
            })
            .collect();
        if parts.iter().any(|known| known.is_blurred) {
            return None;
        }
        let mut all = Inspection {
            verdict: Verdict::Outside,
            curve: Some(false),
            sign: Some(1),
            distance: DistanceBounds {
                low: f64::INFINITY,
                high: f64::INFINITY,
            },
        };
        for known in &parts {
            all.verdict = match (all.verdict, known.inside) {
                (Verdict::Inside, _) | (_, Some(true)) => Verdict::Inside,
                (Verdict::Uncertain | Verdict::Undecided, _) | (_, None) => Verdict::Undecided,
                (Verdict::Outside, Some(false)) => Verdict::Outside,
            };
            all.curve = match (all.curve, known.curve) {
                (Some(true), _) | (_, Some(true)) => Some(true),
                (None, _) | (_, None) => None,
                (Some(false), Some(false)) => Some(false),
            };
        }
        if self.asked.is_none() && all.verdict == Verdict::Outside {
            self.far(&mut parts, at);
        }
        for (known, factor) in parts.iter().zip(&*self.factors) {
            all.distance.low = all.distance.low.min(known.bounds.low);
            all.distance.high = all.distance.high.min(known.bounds.high);
            let field = &factor.field;
            let sign = sign_of(field, at(field), &known.bounds);
            let of_power = if factor.multiplicity % 2 == 1 {
                sign
            } else {
                sign * sign
            };
            all.sign = all.sign.map(|all| all * of_power);
        }
        if self.asked.is_some_and(|asked| all.distance.high > asked) {
            // No zero was found within reach.
            all.distance.high = f64::INFINITY;
        }
        Some(all)
    }

    fn of_factor(&self, factor: &Factor, p: &Point) -> PartialInspection {
        let field = &factor.field;
        let mut known = self.by_doubles(field, p);
        // What is outside is searched for the nearest point later, with all factors together.
        let is_left = self.asked.is_none() && known.inside == Some(false);
        if known.inside.is_none() || !is_left && !self.is_close(&known.bounds) {
            self.by_search(field, p, &mut known);
        }
        known.curve = match (known.inside, self.kind) {
            (None, _) => known.curve,
            (Some(false), _) => Some(false),
            // The sphere meets the cylinder exactly if the ball's disc in the plane meets the curve.
            (Some(true), Kind::Surface) if field.is_flat() => Some(true),
            (Some(true), _) if known.curve.is_some() => known.curve,
            (Some(true), Kind::Plane) if self.signs_differ(field, p, &known) => Some(true),
            (Some(true), _) if !self.is_exact_possible(field) => None,
            (Some(true), Kind::Plane) => Some(self.circle_meets(field, p)),
            (Some(true), Kind::Surface) => self.sphere_meets(field, p, &known),
        };
        known
    }

    /// Whether the bounds of the distance are as close as the goal requires.
    pub(super) fn is_close(&self, bounds: &DistanceBounds) -> bool {
        self.asked.is_some() && bounds.low >= self.goal.reach
            || bounds.high.is_finite()
                && bounds.high - bounds.low <= self.goal.relative * bounds.high
    }

    /// Adds bounds that hold for the doubles; `slack` makes them hold for the exact point.
    pub(super) fn learn(&self, known: &mut PartialInspection, found: DistanceBounds, slack: f64) {
        let low = Interval::from(found.low) - Interval::from(slack);
        let high = Interval::from(found.high) + Interval::from(slack);
        known.bounds.low = known.bounds.low.max(low.low());
        known.bounds.high = known.bounds.high.min(high.high());
        if known.bounds.high <= self.around[0] {
            known.inside = Some(true);
        } else if known.bounds.low > self.around[1] {
            known.inside = Some(false);
        }
    }

    /// Decides by doubles: a quick proof that all zeros are far away, or the expansion at the foot.
    fn by_doubles(&self, field: &Field, p: &Point) -> PartialInspection {
        let mut known = PartialInspection::NOTHING;
        let (value, normal) = field.value_and_gradient(p.near);
        let reach = self.reach_from(p);
        let is_far = value.abs() > 2.0 * reach * dot(normal, normal).sqrt();
        if is_far && field.local(p.near).excludes(reach) {
            known.bounds.low = self.goal.reach;
            known.inside = Some(false);
            if self.asked.is_some() {
                return known;
            }
        }
        let sign = field.sign(p.near);
        if sign == 0 && p.slack <= 0.0 {
            known.bounds = DistanceBounds::ZERO;
            known.inside = Some(true);
            return known;
        }
        let goal = (self.goal.relative.sqrt() / 32.0).min(1e-3);
        known.foot = approach(field, p.near, p.near, goal);
        if let Some(q) = known.foot
            && sign != 0
        {
            let found = enclose(field, p.near, q, sign);
            self.learn(&mut known, found, p.slack);
        }
        known
    }

    /// The distance from the doubles within which a zero may be within reach of the exact point.
    fn reach_from(&self, p: &Point) -> f64 {
        (Interval::from(self.goal.reach) + Interval::from(p.slack)).high()
    }

    /// Decides a point that the expansion in doubles leaves open, by a search of cubes and by proofs about the cubes that are
    /// left.
    fn by_search(&self, field: &Field, p: &Point, known: &mut PartialInspection) {
        let sign = field.polynomial().evaluate(p.exactly()).signum();
        if sign == 0 {
            known.bounds = DistanceBounds::ZERO;
            known.inside = Some(true);
            return;
        }
        if let Some(start) = self.foot_of_nearly_known(field, p, known) {
            self.by_exact_foot(field, p, start, sign, known);
            self.by_refined_foot(field, p, known);
            if known.inside.is_some() && self.is_close(&known.bounds) {
                return;
            }
        }
        self.by_quadric(field, p, known);
        if known.inside.is_some() && self.is_close(&known.bounds) {
            return;
        }
        if self.is_coarse(p.near) || self.is_blurred(field, p.near) {
            known.is_blurred = true;
            return;
        }
        let mut goal = self.goal;
        goal.reach = self.reach_from(p);
        goal.tolerance = (Interval::from(goal.tolerance) + Interval::from(p.slack)).high();
        goal.cubes = self.cubes_for(field);
        let near_sign = field.sign(p.near);
        let slack = Interval::from(p.slack);
        let outer = DistanceBounds {
            low: (Interval::from(known.bounds.low) - slack).or_zero().low(),
            high: (Interval::from(known.bounds.high) + slack).high(),
        };
        let found = nearest(field, p.near, near_sign, outer, goal, &self.limits);
        self.learn(known, found.bounds, p.slack);
        if known.inside.is_none() && self.is_exact_possible(field) {
            self.by_proof(field, p, &found.left, sign, known);
        }
    }

    pub(super) fn factors(&self) -> &[Factor] {
        &self.factors
    }

    /// The number of cubes that may be divided for a factor.
    pub(super) fn cubes_for(&self, field: &Field) -> usize {
        let all = self.goal.cubes;
        (all * CUBE_WORK / field.work()).clamp(all.min(64), all)
    }

    /// Whether exact expansions are possible. They have as many coefficients as f has monomials, with longer and longer
    /// numbers.
    pub(super) fn is_exact_possible(&self, field: &Field) -> bool {
        field.monomials() <= MAX_EXACT_MONOMIALS && self.limits.check().is_ok()
    }
}

/// Doubles below and above a tolerance; both are the tolerance itself if it is a double.
fn doubles_about(tolerance: &Rational) -> Result<[f64; 2]> {
    let near = tolerance.to_f64();
    if tolerance.signum() <= 0 || !near.is_normal() {
        return Err(Error::Usage(format!(
            "the tolerance {tolerance}: expected a positive number, such as 0.1"
        )));
    }
    let is_exact = Rational::try_from(near).is_ok_and(|d| d == *tolerance);
    Ok(match is_exact {
        true => [near; 2],
        false => [near.next_down(), near.next_up()],
    })
}

/// The sign of a polynomial at a point whose distance from its zeros is known within these bounds.
fn sign_of(field: &Field, p: &Point, bounds: &DistanceBounds) -> i8 {
    if bounds.high <= 0.0 {
        return 0;
    }
    if bounds.low > p.slack {
        // There is no zero between the point and its doubles.
        return field.sign(p.near);
    }
    field.polynomial().evaluate(p.exactly()).signum()
}
