//! Claims about the distance of points from an equation or a radius, and about their side (T6).

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};
use serde_json::{Value, json};

use super::forms::{curve_form, radius_form, surface_form, texts};
use super::proof::{Proof, by_expansion};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::inspect::{Inspection, Verdict};
use crate::poly::{PlanePolynomial, SparsePolynomial};
use crate::sample::{Direction, SpaceDirection, UnitVector};
use crate::shape::{FourierRadius, ImplicitCurve, ImplicitSurface};

/// The number of angles at which a radius is evaluated to find its nearest and its farthest point.
const ANGLES: usize = 4096;
/// The number of directions in which the nearest zero of a polynomial is searched.
const RAYS: usize = 96;
/// Zeros are searched to this multiple of the largest distance, so that rays beside the nearest zero meet one, too.
const BEYOND: f64 = 1.5;
/// The number of steps along one ray.
const STEPS: u32 = 48;
/// The number of steps of Newton's method.
const NEWTON: usize = 30;
/// The largest numbers of halvings of the covers of a cube in 2 and 3 dimensions, and of arcs. About a point at which the form nearly
/// touches a ball, the cells of a cover are as many as 2^(1/2) or 2 to this power.
const DEPTHS: [u32; 2] = [28, 12];
const DEPTH_OF_ARCS: u32 = 60;

/// A form that points are compared with, entered into the proof.
#[derive(Debug)]
pub(crate) enum InspectedForm {
    /// The polynomial of a plane curve, and its center.
    Plane(Option<usize>, SparsePolynomial<2>, [Rational; 2]),
    /// The polynomial of a surface.
    Space(Option<usize>, SparsePolynomial<3>),
    /// A radius, and its points in doubles.
    Radius(Option<usize>, FourierRadius, Vec<[f64; 2]>),
    /// A form about which proof files have no claims.
    Other,
}

impl InspectedForm {
    /// The polynomial is written with coprime integers and a positive first coefficient, since `side` claims its sign.
    pub(crate) fn of_curve(curve: &ImplicitCurve, proof: &mut Proof) -> Self {
        let primitive: PlanePolynomial = curve.polynomial().primitive();
        let form = curve_form(proof, &primitive);
        let terms = primitive.terms();
        let narrow = |e: usize| u32::try_from(e).unwrap_or(u32::MAX);
        let f = SparsePolynomial::from_terms(terms.map(|((i, j), c)| ([narrow(i), narrow(j)], c)));
        Self::Plane(form, f, curve.center().clone())
    }

    /// As [`Self::of_curve`].
    pub(crate) fn of_surface(surface: &ImplicitSurface, proof: &mut Proof) -> Self {
        let primitive = surface.polynomial().primitive();
        Self::Space(surface_form(proof, &primitive), primitive)
    }

    pub(crate) fn of_radius(radius: &FourierRadius, proof: &mut Proof) -> Self {
        let points = (0..ANGLES).map(|k| point_of_radius(radius, angle(real(k))));
        Self::Radius(radius_form(proof, radius), radius.clone(), points.collect())
    }
}

fn angle(k: f64) -> f64 {
    k * TAU / real(ANGLES)
}

#[expect(clippy::cast_precision_loss, reason = "a small count")]
fn real(count: usize) -> f64 {
    count as f64
}

fn point_of_radius(radius: &FourierRadius, theta: f64) -> [f64; 2] {
    let r = radius.approximate(theta);
    let center = radius.center().each_ref().map(Rational::to_f64);
    [center[0] + r * theta.cos(), center[1] + r * theta.sin()]
}

/// Claims the answers for one point: `distance` for the verdict, for the criterion of Theorem 8 and for the bounds, and `side`.
pub(crate) fn inspected_point(
    proof: &mut Proof,
    form: &InspectedForm,
    point: &[Rational; 3],
    tolerance: &Rational,
    found: &Inspection,
) {
    let mut asked: Vec<(&'static str, Rational)> = Vec::new();
    match found.verdict {
        Verdict::Inside => asked.push(("at-most", tolerance.clone())),
        Verdict::Outside => asked.push(("more-than", tolerance.clone())),
        Verdict::Undecided => {}
    }
    match found.curve {
        Some(true) => asked.push(("meets", tolerance.clone())),
        Some(false) => asked.push(("misses", tolerance.clone())),
        None => {}
    }
    // The distance is at least the lower bound; what is claimed is that it is more than the double below.
    if found.distance.low > 0.0 {
        asked.extend(exact(found.distance.low.next_down()).map(|low| ("more-than", low)));
    }
    asked.extend(exact(found.distance.high).map(|high| ("at-most", high)));
    let [x, y, _] = point;
    match form {
        InspectedForm::Plane(index, f, center) => {
            let relative = [x - &center[0], y - &center[1]];
            claim_all(
                proof,
                *index,
                &relative,
                asked,
                found.sign,
                |point, high| Nearest::of(f, point, high),
            );
        }
        InspectedForm::Space(index, f) => {
            claim_all(proof, *index, point, asked, found.sign, |point, high| {
                Nearest::of(f, point, high)
            });
        }
        InspectedForm::Radius(index, radius, points) => {
            let point = [x.clone(), y.clone()];
            claim_all(proof, *index, &point, asked, found.sign, |point, _| {
                Nearest::of_radius(radius, points, point)
            });
        }
        InspectedForm::Other => {
            let statement =
                json!({ "point": texts(point), "verdict": format!("{:?}", found.verdict) });
            proof.claim("distance", &statement, None);
        }
    }
}

fn exact(bound: f64) -> Option<Rational> {
    Rational::try_from(bound).ok()
}

fn claim_all<'a, const V: usize, N: Witnesses>(
    proof: &mut Proof,
    form: Option<usize>,
    point: &'a [Rational; V],
    asked: Vec<(&'static str, Rational)>,
    sign: Option<i8>,
    nearest: impl Fn(&'a [Rational; V], f64) -> N,
) {
    let high = asked
        .iter()
        .map(|(_, bound)| bound.to_f64())
        .fold(0.0, f64::max);
    let mut known = None;
    for (relation, bound) in asked {
        let witness = form.and_then(|_| match relation {
            "more-than" | "misses" => Some(json!({ "depth": N::DEPTH })),
            _ => {
                let nearest = known.get_or_insert_with(|| nearest(point, high));
                nearest.witness(&bound, relation == "meets")
            }
        });
        let statement = json!({
            "form": form,
            "point": texts(point),
            "relation": relation,
            "bound": bound.to_string(),
        });
        proof.claim("distance", &statement, witness);
    }
    if let Some(sign) = sign {
        let statement = json!({ "form": form, "point": texts(point), "sign": sign });
        proof.claim("side", &statement, form.and_then(|_| by_expansion()));
    }
}

/// The nearest point of a form, approximately, from which witnesses are made.
trait Witnesses {
    /// The largest number of halvings of a cover.
    const DEPTH: u32;

    /// A witness that a point of the form is within the bound, or at exactly this distance.
    fn witness(&self, bound: &Rational, exactly: bool) -> Option<Value>;
}

/// The nearest zero of a polynomial to a point: its direction and its distance in doubles.
struct Nearest<'a, const V: usize> {
    f: &'a SparsePolynomial<V>,
    point: &'a [Rational; V],
    foot: Option<([f64; V], f64)>,
}

impl<'a, const V: usize> Nearest<'a, V> {
    fn of(f: &'a SparsePolynomial<V>, point: &'a [Rational; V], reach: f64) -> Self {
        let numeric = Numeric::of(f);
        let from = point.each_ref().map(Rational::to_f64);
        let zero_along = |direction: [f64; V]| numeric.first_zero(from, direction, reach * BEYOND);
        let mut best: Option<([f64; V], f64)> = None;
        for direction in directions::<V>(RAYS) {
            if let Some(t) = zero_along(direction)
                && best.is_none_or(|(_, distance)| t < distance)
            {
                best = Some((direction, t));
            }
        }
        if let Some((direction, t)) = best {
            let foot = std::array::from_fn(|k| from[k] + t * direction[k]);
            if let Some(found) = numeric.polished(from, foot)
                && found.1 <= t
            {
                best = Some(found);
            }
        }
        Self {
            f,
            point,
            foot: best,
        }
    }

    fn end(&self, direction: &[Rational; V], length: &Rational) -> [Rational; V] {
        std::array::from_fn(|k| &self.point[k] + &(length * &direction[k]))
    }
}

impl<const V: usize> Witnesses for Nearest<'_, V> {
    const DEPTH: u32 = DEPTHS[V - 2];

    fn witness(&self, bound: &Rational, exactly: bool) -> Option<Value> {
        let sign = |end: &[Rational; V]| self.f.evaluate(end).signum();
        let segment =
            |a: &[Rational; V], b: &[Rational; V]| json!({ "segment": [texts(a), texts(b)] });
        let near = self.foot.map(|(direction, _)| direction);
        let opposite = near.map(|direction| direction.map(|c| -c));
        let tried = near
            .into_iter()
            .chain(opposite)
            .chain(directions::<V>(RAYS));
        let tried = tried.map(rational_unit);
        let mut seen: Vec<(i8, [Rational; V])> = Vec::new();
        if !exactly {
            let here = sign(self.point);
            if here == 0 {
                return Some(segment(self.point, self.point));
            }
            seen.push((here, self.point.clone()));
            // A little beyond the nearest point.
            if let Some((direction, t)) = self.foot {
                let direction = rational_unit(direction);
                for share in [1e-12, 1e-9, 1e-7, 1e-4] {
                    let length = exact(t * (1.0 + share))?;
                    if length <= *bound {
                        let end = self.end(&direction, &length);
                        if sign(&end) != here {
                            return Some(segment(self.point, &end));
                        }
                    }
                }
            }
        }
        for direction in tried {
            let end = self.end(&direction, bound);
            let found = sign(&end);
            if found == 0 {
                return Some(segment(&end, &end));
            }
            if let Some((_, other)) = seen.iter().find(|(sign, _)| *sign != found) {
                return Some(segment(other, &end));
            }
            if seen.is_empty() {
                seen.push((found, end));
            }
        }
        None
    }
}

/// Directions of a circle, or spread over a sphere; the axes are among them.
fn directions<const V: usize>(count: usize) -> Vec<[f64; V]> {
    let mut all: Vec<[f64; V]> = Vec::with_capacity(count + 2 * V);
    for axis in 0..V {
        for sign in [1.0, -1.0] {
            all.push(std::array::from_fn(|k| if k == axis { sign } else { 0.0 }));
        }
    }
    let golden = TAU * (1.0 - 1.0 / 1.618_033_988_749_895);
    for k in 0..count {
        let share = (real(k) + 0.5) / real(count);
        let spread: [f64; 3] = match V {
            2 => [(TAU * share).cos(), (TAU * share).sin(), 0.0],
            _ => {
                let z = 1.0 - 2.0 * share;
                let (sin, cos) = (golden * real(k)).sin_cos();
                let s = (1.0 - z * z).sqrt();
                [s * cos, s * sin, z]
            }
        };
        all.push(std::array::from_fn(|k| spread[k]));
    }
    all
}

/// A rational unit vector near the direction.
fn rational_unit<const V: usize>(direction: [f64; V]) -> [Rational; V] {
    // The axes are exact.
    if let Some(axis) = direction.iter().position(|c| c.abs() >= 1.0) {
        let sign = if direction[axis] > 0.0 { 1 } else { -1 };
        return std::array::from_fn(|k| Rational::from(if k == axis { sign } else { 0 }));
    }
    let theta = Direction::from_radians(direction[1].atan2(direction[0]));
    let found: Vec<Rational> = match V {
        2 => theta.components().to_vec(),
        _ => {
            let phi = Direction::from_radians(direction[V - 1].clamp(-1.0, 1.0).acos());
            SpaceDirection::new(theta, phi).components().to_vec()
        }
    };
    std::array::from_fn(|k| found[k].clone())
}

fn unit<const V: usize>(vector: [f64; V]) -> Option<[f64; V]> {
    let length = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
    (length.is_normal()).then(|| vector.map(|c| c / length))
}

/// A polynomial in doubles, for guesses.
struct Numeric<const V: usize> {
    terms: Vec<([i32; V], f64)>,
}

impl<const V: usize> Numeric<V> {
    fn of(f: &SparsePolynomial<V>) -> Self {
        let narrow = |e: &[u32; V]| e.map(|e| i32::try_from(e).unwrap_or(i32::MAX));
        let terms = f.terms().map(|(e, c)| (narrow(e), c.to_f64()));
        Self {
            terms: terms.collect(),
        }
    }

    fn value(&self, at: [f64; V]) -> f64 {
        let term = |(e, c): &([i32; V], f64)| c * (0..V).map(|k| at[k].powi(e[k])).product::<f64>();
        self.terms.iter().map(term).sum()
    }

    fn gradient(&self, at: [f64; V]) -> [f64; V] {
        std::array::from_fn(|axis| {
            let term = |(e, c): &([i32; V], f64)| match e[axis] {
                0 => 0.0,
                n => {
                    let power = |k: usize| at[k].powi(if k == axis { n - 1 } else { e[k] });
                    c * f64::from(n) * (0..V).map(power).product::<f64>()
                }
            };
            self.terms.iter().map(term).sum()
        })
    }

    /// The second derivatives.
    fn hessian(&self, at: [f64; V]) -> [[f64; V]; V] {
        let derivative = |e: &mut [i32; V], axis: usize| {
            let n = e[axis];
            e[axis] = (n - 1).max(0);
            f64::from(n)
        };
        std::array::from_fn(|a| {
            std::array::from_fn(|b| {
                let term = |(e, c): &([i32; V], f64)| {
                    let mut e = *e;
                    let factor = derivative(&mut e, a) * derivative(&mut e, b);
                    c * factor * (0..V).map(|k| at[k].powi(e[k])).product::<f64>()
                };
                self.terms.iter().map(term).sum()
            })
        })
    }

    /// The direction and the distance of a zero whose normal goes through the point `from`, by Newton's method for
    /// q − from + s ∇f(q) = 0 and f(q) = 0.
    fn polished(&self, from: [f64; V], near: [f64; V]) -> Option<([f64; V], f64)> {
        let mut q = near;
        let gradient = self.gradient(q);
        let square: f64 = gradient.iter().map(|c| c * c).sum();
        let mut s = -(0..V).map(|k| (q[k] - from[k]) * gradient[k]).sum::<f64>() / square;
        for _ in 0..NEWTON {
            let (gradient, hessian) = (self.gradient(q), self.hessian(q));
            let matrix = DMatrix::from_fn(V + 1, V + 1, |i, j| match (i < V, j < V) {
                (true, true) => s * hessian[i][j] + if i == j { 1.0 } else { 0.0 },
                (true, false) => gradient[i],
                (false, true) => gradient[j],
                (false, false) => 0.0,
            });
            let right = DVector::from_fn(V + 1, |i, _| match i < V {
                true => from[i] - q[i] - s * gradient[i],
                false => -self.value(q),
            });
            let step = matrix.lu().solve(&right)?;
            q = std::array::from_fn(|k| q[k] + step[k]);
            s += step[V];
        }
        let away: [f64; V] = std::array::from_fn(|k| q[k] - from[k]);
        let length = away.iter().map(|c| c * c).sum::<f64>().sqrt();
        Some((unit(away)?, length))
    }

    /// The first change of sign along a ray, up to the reach.
    fn first_zero(&self, from: [f64; V], direction: [f64; V], reach: f64) -> Option<f64> {
        let at = |t: f64| self.value(std::array::from_fn(|k| from[k] + t * direction[k]));
        let step = reach / f64::from(STEPS);
        let start = at(0.0) > 0.0;
        let k = (1..=STEPS).find(|k| (at(step * f64::from(*k)) > 0.0) != start)?;
        let (mut low, mut high) = (step * f64::from(k - 1), step * f64::from(k));
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if (at(middle) > 0.0) == start {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(high)
    }
}

/// The directions of the nearest and the farthest point of a radius.
struct NearestOfRadius {
    nearest: [Rational; 2],
    farthest: [Rational; 2],
}

impl<'a> Nearest<'a, 2> {
    fn of_radius(
        radius: &FourierRadius,
        points: &[[f64; 2]],
        point: &'a [Rational; 2],
    ) -> NearestOfRadius {
        let [x, y] = point.each_ref().map(Rational::to_f64);
        let distance = |[a, b]: [f64; 2]| (a - x).hypot(b - y);
        let extreme = |sign: f64| {
            let values: Vec<f64> = points.iter().map(|point| sign * distance(*point)).collect();
            let best = (0..values.len()).min_by(|&i, &j| values[i].total_cmp(&values[j]));
            let best = real(best.invariant("a radius is drawn with points"));
            // The golden section between the neighbours.
            let ratio = 0.618_033_988_749_895;
            let value = |k: f64| sign * distance(point_of_radius(radius, angle(k)));
            let (mut low, mut high) = (best - 1.0, best + 1.0);
            for _ in 0..60 {
                let a = high - ratio * (high - low);
                let b = low + ratio * (high - low);
                if value(a) < value(b) {
                    high = b;
                } else {
                    low = a;
                }
            }
            let theta = angle(f64::midpoint(low, high));
            // Where the nearest point is in the direction of an axis, it may be at exactly the distance that is claimed.
            let degrees = theta.to_degrees();
            let whole = Rational::try_from(degrees.round()).ok();
            match whole.filter(|_| (degrees - degrees.round()).abs() < 1e-5) {
                Some(whole) => Direction::from_degrees(&whole).components(),
                None => Direction::from_radians(theta).components(),
            }
        };
        NearestOfRadius {
            nearest: extreme(1.0),
            farthest: extreme(-1.0),
        }
    }
}

impl Witnesses for NearestOfRadius {
    const DEPTH: u32 = DEPTH_OF_ARCS;

    fn witness(&self, _: &Rational, exactly: bool) -> Option<Value> {
        let mut directions = vec![texts(&self.nearest)];
        if exactly {
            directions.push(texts(&self.farthest));
        }
        Some(json!({ "directions": directions }))
    }
}
