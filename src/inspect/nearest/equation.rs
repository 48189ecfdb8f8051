//! The foot of a point on the zero set of an equation.

use nalgebra::Vector4;

use super::{FootCandidate, SINGULAR, unit};
use crate::exact::Rational;
use crate::inspect::common_zeros::CommonZeros;
use crate::inspect::distance::{Goal, nearest};
use crate::inspect::exact::{critical_point, rational_zero, refined_foot};
use crate::inspect::foot::{approach, lagrange, stationary};
use crate::inspect::inspector::{Factor, Inspector};
use crate::inspect::quadric::Quadric;
use crate::inspect::{DistanceBounds, Inspection};
use crate::intervals::{Field, Interval, distance, dot, largest, rational, rationals};

/// A foot in doubles is refined exactly if the error of f moves it by more than this part of its size.
const ROUNDING: f64 = 4e-16;
/// A foot is on the surface, but for rounding, up to this part of its size.
const NEARLY: f64 = 2e-15;
/// The foot of a far point is known to better than this part of the point's coordinates.
const FAR: f64 = 1e-6;
/// The number of bits after the point of a refined foot, for a size of 1.
const BITS: i64 = 128;
/// A singular point is looked for among the simplest fractions within these parts of the size.
const SIMPLE: [f64; 2] = [1e-9, 1e-5];
/// The largest number of steps with exact values.
const EXACT_STEPS: usize = 40;
/// The largest number of steps of Newton's method with exact derivatives.
const EXACT_NEWTON_STEPS: usize = 12;
/// The precision of a place from which Newton's method starts.
const ROUGHLY: f64 = 1e-3;
/// The precision of a foot that is approached in tangent planes.
const APPROACHED: f64 = 1e-15;

impl Inspector {
    /// The foot of a point, given in original coordinates, with what was found for it.
    pub(crate) fn foot(&self, point: &[Rational; 3], found: &Inspection) -> Option<super::Foot> {
        let own = &*self.relative(point);
        let from = own.each_ref().map(Rational::to_f64);
        let bounds = &found.distance;
        if !bounds.high.is_finite() || from.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let quick = self.nearest_of(own, from, bounds, |k, exactly, p| {
            let factor = &self.factors()[k];
            match &factor.curve {
                Some(curve) => self.on_curve(curve, &factor.field, exactly, p, bounds),
                None => self.feet_near(k, exactly, p, self.start(&factor.field, p)),
            }
        });
        // What is found on curves is not looked for again.
        let is_surface = |k: usize| self.factors()[k].curve.is_none();
        let quick = quick.or_else(|| {
            self.nearest_of(own, from, bounds, |k, exactly, _| {
                let foot = is_surface(k).then(|| self.on_quadric(k, exactly));
                foot.flatten().into_iter().collect()
            })
        });
        let is_blurred = |factor: &Factor| self.is_blurred(&factor.field, from);
        if quick.is_none() && self.factors().iter().any(is_blurred) {
            return self.about(from).ok()?.foot(point, found);
        }
        let best = quick.or_else(|| {
            self.nearest_of(own, from, bounds, |k, exactly, p| {
                let field = &self.factors()[k].field;
                let starts = is_surface(k).then(|| self.starts_by_cubes(field, p, bounds));
                self.feet_near(k, exactly, p, starts.into_iter().flatten())
            })
        })?;
        let mut candidate = best;
        if bounds.high <= 0.0 {
            candidate.foot.point = from;
        }
        // Back to original coordinates.
        let offset: [Rational; 3] = std::array::from_fn(|i| &point[i] - &own[i]);
        let found = candidate.foot.point;
        let moved = std::array::from_fn(|i| (rational(found[i]) + &offset[i]).to_f64());
        if offset.iter().any(|x| !x.is_zero()) {
            candidate.foot.point = moved;
        }
        candidate.checked(point.each_ref().map(Rational::to_f64), bounds)
    }

    /// The nearest one of the candidates for each factor, which are found from its index and the point, exactly and in doubles.
    fn nearest_of(
        &self,
        point: &[Rational; 3],
        from: [f64; 3],
        bounds: &DistanceBounds,
        candidates: impl Fn(usize, &[Rational; 3], [f64; 3]) -> Vec<FootCandidate>,
    ) -> Option<FootCandidate> {
        let mut best: Option<(f64, FootCandidate)> = None;
        let mut take = |candidate: FootCandidate| {
            let length = distance(candidate.foot.point, from);
            if candidate.checked(from, bounds).is_some()
                && best.as_ref().is_none_or(|(least, _)| length < *least)
            {
                best = Some((length, candidate));
            }
        };
        for (k, factor) in self.factors().iter().enumerate() {
            let field = &factor.field;
            // A cylinder is inspected in the plane of x and y.
            let mut p = from;
            let mut exactly = point.clone();
            if field.is_flat() {
                p[2] = 0.0;
                exactly[2] = Rational::zero();
            }
            for mut candidate in candidates(k, &exactly, p) {
                if field.is_flat() {
                    candidate.foot.point[2] = from[2];
                }
                take(candidate);
            }
        }
        best.map(|(_, candidate)| candidate)
    }

    /// The nearest point that is found on a curve of common zeros.
    fn on_curve(
        &self,
        curve: &CommonZeros,
        field: &Field,
        exactly: &[Rational; 3],
        p: [f64; 3],
        bounds: &DistanceBounds,
    ) -> Vec<FootCandidate> {
        let position = if bounds.high <= 0.0 {
            curve.is_zero(exactly).then_some(p)
        } else {
            let goal = Goal {
                reach: (Interval::from(bounds.high) * (1.0 + 1e-6)).high(),
                tolerance: 0.0,
                cubes: self.cubes_for(field),
                ..self.goal
            };
            let found = curve.nearest(p, DistanceBounds::UNKNOWN, goal, &self.limits);
            found.foot.map(|foot| foot.position)
        };
        let candidate = position.map(|position| FootCandidate::on_form(position, None));
        candidate.into_iter().collect()
    }

    /// The feet that are found from starting points.
    fn feet_near(
        &self,
        factor: usize,
        exactly: &[Rational; 3],
        p: [f64; 3],
        starts: impl IntoIterator<Item = [f64; 3]>,
    ) -> Vec<FootCandidate> {
        let starts = starts.into_iter();
        starts
            .filter_map(|start| self.candidate(factor, exactly, p, start))
            .collect()
    }

    /// The foot on a quadric, which is not improved: from far away a step in doubles leads anywhere.
    fn on_quadric(&self, factor: usize, exactly: &[Rational; 3]) -> Option<FootCandidate> {
        let field = &self.factors()[factor].field;
        let foot = Quadric::of(field)?.nearest(exactly)?.foot;
        let regular = self.regular(factor, exactly, foot);
        Some(regular.unwrap_or_else(|| FootCandidate::on_form(foot, None)))
    }

    fn start(&self, field: &Field, p: [f64; 3]) -> Vec<[f64; 3]> {
        let size = largest(&p);
        let near = approach(field, p, p, APPROACHED)
            .or_else(|| approach(field, p, p, ROUGHLY))
            .or_else(|| stationary(field, p, p));
        // The point itself, if it is on the surface.
        let is_on = |q: &[f64; 3]| distance(*q, p) <= ROUNDING * size;
        match near {
            Some(q) if !is_on(&q) => vec![q],
            Some(q) => vec![q, p],
            None => vec![p],
        }
    }

    /// Places near the nearest zeros, by a search of cubes.
    fn starts_by_cubes(
        &self,
        field: &Field,
        p: [f64; 3],
        bounds: &DistanceBounds,
    ) -> Vec<[f64; 3]> {
        let reach = (Interval::from(bounds.high) * (1.0 + 1e-6)).high();
        let goal = Goal {
            reach: reach.max(f64::MIN_POSITIVE),
            tolerance: 0.0,
            relative: self.goal.relative,
            cubes: self.cubes_for(field),
        };
        let known = DistanceBounds {
            low: (Interval::from(bounds.low) * (1.0 - 1e-6)).or_zero().low(),
            high: f64::INFINITY,
        };
        nearest(field, p, field.sign(p), known, goal, &self.limits).near
    }

    /// The foot that is found from a starting point: a regular one, or else one at a singular point. Of several, it is the one that is
    /// on the surface most exactly.
    fn candidate(
        &self,
        factor: usize,
        exactly: &[Rational; 3],
        p: [f64; 3],
        start: [f64; 3],
    ) -> Option<FootCandidate> {
        let field = &self.factors()[factor].field;
        let mut best: Option<FootCandidate> = None;
        let mut take = |candidate: Option<FootCandidate>| {
            if let Some(candidate) = candidate
                && best.is_none_or(|best| candidate.off < best.off)
            {
                best = Some(candidate);
            }
            let size = best.map_or(0.0, |best| largest(&best.foot.point).max(largest(&p)));
            best.filter(|best| best.off <= NEARLY * size)
        };
        // Near a center of curvature Newton's method is slow, and its last step may be too long: one more step ends it.
        let found = stationary(field, p, start);
        let in_doubles = [
            found.and_then(|q| stationary(field, p, q)),
            found,
            approach(field, p, start, APPROACHED),
            Some(start),
        ];
        for q in in_doubles.into_iter().flatten() {
            let found = take(self.regular(factor, exactly, q));
            if found.is_some() {
                return found;
            }
        }
        if self.is_exact_possible(field) {
            // Where doubles lose all digits of f, exact values do not.
            let near = approach_exactly(field, exactly, start).unwrap_or(start);
            for start in [near, start] {
                let q = stationary_exactly(field, exactly, start);
                let found = take(q.and_then(|q| self.regular(factor, exactly, q)));
                if found.is_some() {
                    return found;
                }
            }
        }
        take(singular(field, p, start));
        best
    }

    /// A foot near q at which the gradient is not 0.
    fn regular(
        &self,
        factor: usize,
        exactly: &[Rational; 3],
        q: [f64; 3],
    ) -> Option<FootCandidate> {
        let field = &self.factors()[factor].field;
        let p = exactly.each_ref().map(Rational::to_f64);
        let size = largest(&q).max(largest(&p)).max(f64::MIN_POSITIVE);
        let mut q = q;
        let (mut gradient, mut off) = gradient_and_off(field, q)?;
        let is_rough = off > ROUNDING * size || aside(p, q, gradient) > NEARLY * size;
        if is_rough && self.is_exact_possible(field) {
            // 2^exponent is about the size.
            let exponent = size.log2().clamp(-900.0, 900.0).ceil();
            #[expect(clippy::cast_possible_truncation, reason = "at most 900 in size")]
            let bits = BITS - exponent as i64;
            let refined = refined_foot(field, exactly, &rationals(q), bits.max(16), &self.limits);
            if let Some(refined) = refined {
                q = refined.each_ref().map(Rational::to_f64);
                (gradient, off) = gradient_and_off(field, q)?;
            }
        }
        let bend = field.local(q).hessian().amax();
        let steepness = dot(gradient, gradient).sqrt();
        // A far point does not make a regular foot singular; it moves the foot by its rounding only.
        let scale = largest(&q).max(FAR * size);
        if steepness.is_nan() || steepness <= SINGULAR * bend * scale {
            return None;
        }
        let normal = self
            .outward(factor, q)
            .and_then(|sign| unit(gradient.map(|g| sign * g)));
        let foot = super::Foot { point: q, normal };
        // What is not a foot of p is as wrong as what is not on the surface.
        let off = off.max(aside(p, q, gradient));
        Some(FootCandidate { foot, off })
    }

    /// 1 or −1 if the polynomial grows along the gradient of a factor or against it; `None` if it does neither: the factor is repeated an
    /// even number of times, or another one vanishes there, too.
    fn outward(&self, factor: usize, q: [f64; 3]) -> Option<f64> {
        let mut sign = 1.0;
        for (k, other) in self.factors().iter().enumerate() {
            let field = &other.field;
            match (k == factor, other.multiplicity % 2) {
                (true, 0) => return None,
                (true, _) => {}
                (false, odd) => {
                    let mut q = q;
                    if field.is_flat() {
                        q[2] = 0.0;
                    }
                    let value = field.value(q);
                    let slope = field.gradient(q);
                    if value.abs() <= super::SLACK * largest(&q) * dot(slope, slope).sqrt() {
                        return None;
                    }
                    if odd == 1 {
                        sign *= value.signum();
                    }
                }
            }
        }
        Some(sign)
    }
}

/// A point that is about a foot, by steps from `start` to the nearest points in tangent planes, with exact values of f and its gradient
/// at doubles.
fn approach_exactly(field: &Field, p: &[Rational; 3], start: [f64; 3]) -> Option<[f64; 3]> {
    let mut q = start;
    let mut last = f64::INFINITY;
    for step in 0..EXACT_STEPS {
        let at = rationals(q);
        let (value, gradient) = field.exact_value_and_gradient(&at);
        let square: Rational = gradient.iter().map(|g| g * g).sum();
        let back: [Rational; 3] = std::array::from_fn(|i| &p[i] - &at[i]);
        let along: Rational = gradient.iter().zip(&back).map(|(g, b)| g * b).sum();
        let weight = (value + along) * square.recip()?;
        let next = std::array::from_fn(|i| (&p[i] - &(&weight * &gradient[i])).to_f64());
        let moved = distance(next, q);
        // Far from the surface the steps may become longer.
        if !moved.is_finite() || step > 2 && moved >= last {
            return (moved <= ROUGHLY * largest(&q)).then_some(q);
        }
        (q, last) = (next, moved);
    }
    Some(q)
}

/// A foot near `start`, as [`stationary`] finds it, with exact values of f and its derivatives at doubles.
fn stationary_exactly(field: &Field, p: &[Rational; 3], start: [f64; 3]) -> Option<[f64; 3]> {
    let mut q = start;
    for _ in 0..EXACT_NEWTON_STEPS {
        let at = rationals(q);
        let (value, gradient) = field.exact_value_and_gradient(&at);
        let square: Rational = gradient.iter().map(|g| g * g).sum();
        let back: [Rational; 3] = std::array::from_fn(|i| &p[i] - &at[i]);
        let along: Rational = gradient.iter().zip(&back).map(|(g, b)| g * b).sum();
        let nu = along * square.recip()?;
        let [a, b, c] = [0, 1, 2].map(|i| (&back[i] - &(&nu * &gradient[i])).to_f64());
        let inverse = lagrange(&field.exact_local(&at), nu.to_f64()).try_inverse()?;
        let step = inverse * Vector4::new(a, b, c, value.to_f64());
        let next = [0, 1, 2].map(|i| q[i] - step[i]);
        let moved = distance(next, q);
        if !moved.is_finite() {
            return None;
        }
        q = next;
        if moved <= NEARLY * largest(&q).max(largest(&p.each_ref().map(Rational::to_f64))) {
            return Some(q);
        }
    }
    None
}

/// The length of the part of p − q that is not along the gradient at q, which is 0 at a foot.
fn aside(p: [f64; 3], q: [f64; 3], gradient: [f64; 3]) -> f64 {
    let away = [0, 1, 2].map(|i| p[i] - q[i]);
    let along = dot(away, gradient) / dot(gradient, gradient);
    let rest = [0, 1, 2].map(|i| away[i] - along * gradient[i]);
    dot(rest, rest).sqrt()
}

/// The gradient of f, and about the distance of a point from the zeros of f, both by exact values.
fn gradient_and_off(field: &Field, q: [f64; 3]) -> Option<([f64; 3], f64)> {
    let (value, gradient) = field.exact_value_and_gradient(&rationals(q));
    let gradient = gradient.each_ref().map(Rational::to_f64);
    let off = value.abs().to_f64() / dot(gradient, gradient).sqrt();
    off.is_finite().then_some((gradient, off))
}

/// A zero near a point at which the gradient is 0, too.
fn singular(field: &Field, p: [f64; 3], start: [f64; 3]) -> Option<FootCandidate> {
    let near = critical_point(field, start).unwrap_or(start);
    let size = largest(&p).max(largest(&start));
    for q in [near, start] {
        for width in SIMPLE {
            let width = rational(width * size);
            if width.is_zero() {
                continue;
            }
            if let Some(zero) = rational_zero(field, &rationals(q), &width) {
                return Some(FootCandidate::on_form(zero.map(|x| x.to_f64()), None));
            }
        }
    }
    // |f| ≈ |H| t²/2 at the distance t of a zero. The value is exact, because doubles would cancel.
    let bend = field.local(near).hessian().amax();
    let value = field.exact_value(near).abs().to_f64();
    let off = match value > 0.0 {
        true => (2.0 * value / bend).sqrt(),
        false => 0.0,
    };
    off.is_finite().then_some(FootCandidate {
        foot: super::Foot {
            point: near,
            normal: None,
        },
        off,
    })
}
