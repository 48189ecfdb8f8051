//! Claims about the distance of points from an equation or a radius, and about their side (T6).

use std::f64::consts::TAU;

use serde_json::{Value, json};

use super::forms::{curve_form, radius_form, surface_form, texts};
use super::proof::{Proof, by_expansion};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::inspect::{Inspection, Verdict, stationary};
use crate::intervals::{Field, distance};
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
/// The largest numbers of halvings of the covers of a cube in 2 and 3 dimensions, and of arcs. About a point at which the form nearly
/// touches a ball, the cells of a cover are as many as 2^(1/2) or 2 to this power.
const DEPTHS: [u32; 2] = [28, 12];
const DEPTH_OF_ARCS: u32 = 60;

/// A form that points are compared with, entered into the proof under an index.
#[derive(Debug)]
pub(crate) enum InspectedForm {
    /// An equation.
    Equation(Option<usize>, Box<Equation>),
    /// A radius, and its points in doubles.
    Radius(Option<usize>, FourierRadius, Vec<[f64; 2]>),
    /// A form about which proof files have no claims.
    Other,
}

/// The polynomial of a plane curve or of a surface. In the plane z is 0.
#[derive(Debug)]
pub(crate) struct Equation {
    field: Field,
    dimension: usize,
    /// The origin of the polynomial's coordinates.
    center: [Rational; 3],
}

impl InspectedForm {
    /// The polynomial is written with coprime integers and a positive first coefficient, since `side` claims its sign.
    pub(crate) fn of_curve(curve: &ImplicitCurve, proof: &mut Proof) -> Self {
        let primitive: PlanePolynomial = curve.polynomial().primitive();
        let [a, b] = curve.center().clone();
        let equation = Equation {
            field: Field::new(&SparsePolynomial::from(&primitive)),
            dimension: 2,
            center: [a, b, Rational::zero()],
        };
        Self::Equation(curve_form(proof, &primitive), Box::new(equation))
    }

    /// As [`Self::of_curve`].
    pub(crate) fn of_surface(surface: &ImplicitSurface, proof: &mut Proof) -> Self {
        let primitive = surface.polynomial().primitive();
        let equation = Equation {
            field: Field::new(&primitive),
            dimension: 3,
            center: std::array::from_fn(|_| Rational::zero()),
        };
        Self::Equation(surface_form(proof, &primitive), Box::new(equation))
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
    match form {
        InspectedForm::Equation(index, equation) => {
            let relative: [Rational; 3] = std::array::from_fn(|k| &point[k] - &equation.center[k]);
            let point = &relative[..equation.dimension];
            claim_all(proof, *index, point, asked, found.sign, |high| {
                Nearest::of(equation, &relative, high)
            });
        }
        InspectedForm::Radius(index, radius, points) => {
            claim_all(proof, *index, &point[..2], asked, found.sign, |_| {
                NearestOfRadius::of(radius, points, point)
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

fn claim_all<N: Witnesses>(
    proof: &mut Proof,
    form: Option<usize>,
    point: &[Rational],
    asked: Vec<(&'static str, Rational)>,
    sign: Option<i8>,
    nearest: impl Fn(f64) -> N,
) {
    let bounds = asked.iter().map(|(_, bound)| bound.to_f64());
    let nearest = form.map(|_| nearest(bounds.fold(0.0, f64::max)));
    for (relation, bound) in asked {
        let witness = nearest.as_ref().and_then(|nearest| match relation {
            "more-than" | "misses" => Some(json!({ "depth": nearest.depth() })),
            _ => nearest.witness(&bound, relation == "meets"),
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
    fn depth(&self) -> u32;

    /// A witness that a point of the form is within the bound, or at exactly this distance.
    fn witness(&self, bound: &Rational, exactly: bool) -> Option<Value>;
}

/// The nearest zero of a polynomial to a point: its direction and its distance in doubles.
struct Nearest<'a> {
    equation: &'a Equation,
    point: &'a [Rational; 3],
    foot: Option<([f64; 3], f64)>,
}

impl<'a> Nearest<'a> {
    fn of(equation: &'a Equation, point: &'a [Rational; 3], reach: f64) -> Self {
        let from = point.each_ref().map(Rational::to_f64);
        let rays = directions(equation.dimension).into_iter();
        let zeros = rays.filter_map(|direction| {
            let t = first_zero(&equation.field, from, direction, reach * BEYOND)?;
            Some((direction, t))
        });
        let nearest = zeros.min_by(|(_, a), (_, b)| a.total_cmp(b));
        // The normal at the nearest zero goes through the point.
        let foot = nearest.map(|(direction, t)| {
            let start = std::array::from_fn(|k| from[k] + t * direction[k]);
            let polished = stationary(&equation.field, from, start).and_then(|q| {
                let length = distance(from, q);
                let away = std::array::from_fn(|k| (q[k] - from[k]) / length);
                (length.is_normal() && length <= t).then_some((away, length))
            });
            polished.unwrap_or((direction, t))
        });
        Self {
            equation,
            point,
            foot,
        }
    }

    fn end(&self, direction: &[Rational; 3], length: &Rational) -> [Rational; 3] {
        std::array::from_fn(|k| &self.point[k] + &(length * &direction[k]))
    }
}

impl Witnesses for Nearest<'_> {
    fn depth(&self) -> u32 {
        DEPTHS[self.equation.dimension - 2]
    }

    fn witness(&self, bound: &Rational, exactly: bool) -> Option<Value> {
        let dimension = self.equation.dimension;
        let polynomial = self.equation.field.polynomial();
        let sign = |end: &[Rational; 3]| polynomial.evaluate(end).signum();
        let segment = |a: &[Rational; 3], b: &[Rational; 3]| json!({ "segment": [texts(&a[..dimension]), texts(&b[..dimension])] });
        let near = self.foot.map(|(direction, _)| direction);
        let opposite = near.map(|direction| direction.map(|c| -c));
        let tried = near.into_iter().chain(opposite);
        let tried = tried.chain(directions(dimension));
        let tried = tried.map(|direction| rational_unit(direction, dimension));
        let mut seen: Option<(i8, [Rational; 3])> = None;
        if !exactly {
            let here = sign(self.point);
            if here == 0 {
                return Some(segment(self.point, self.point));
            }
            seen = Some((here, self.point.clone()));
            // A little beyond the nearest point.
            if let Some((direction, t)) = self.foot {
                let direction = rational_unit(direction, dimension);
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
            match &seen {
                Some((sign, other)) if *sign != found => return Some(segment(other, &end)),
                Some(_) => {}
                None => seen = Some((found, end)),
            }
        }
        None
    }
}

/// Directions of a circle, or spread over a sphere; the axes are among them.
fn directions(dimension: usize) -> Vec<[f64; 3]> {
    let mut all: Vec<[f64; 3]> = Vec::with_capacity(RAYS + 2 * dimension);
    for axis in 0..dimension {
        for sign in [1.0, -1.0] {
            all.push(std::array::from_fn(|k| if k == axis { sign } else { 0.0 }));
        }
    }
    let golden = TAU * (1.0 - 1.0 / 1.618_033_988_749_895);
    for k in 0..RAYS {
        let share = (real(k) + 0.5) / real(RAYS);
        all.push(match dimension {
            2 => [(TAU * share).cos(), (TAU * share).sin(), 0.0],
            _ => {
                let z = 1.0 - 2.0 * share;
                let (sin, cos) = (golden * real(k)).sin_cos();
                let s = (1.0 - z * z).sqrt();
                [s * cos, s * sin, z]
            }
        });
    }
    all
}

/// A rational unit vector near the direction.
fn rational_unit(direction: [f64; 3], dimension: usize) -> [Rational; 3] {
    // The axes are exact.
    if let Some(axis) = direction.iter().position(|c| c.abs() >= 1.0) {
        let sign = if direction[axis] > 0.0 { 1 } else { -1 };
        return std::array::from_fn(|k| Rational::from(if k == axis { sign } else { 0 }));
    }
    let [x, y, z] = direction;
    let theta = Direction::from_radians(y.atan2(x));
    if dimension == 2 {
        let [u, v] = theta.components();
        return [u, v, Rational::zero()];
    }
    let phi = Direction::from_radians(z.clamp(-1.0, 1.0).acos());
    SpaceDirection::new(theta, phi).components()
}

/// The first change of sign of a polynomial along a ray, up to the reach.
fn first_zero(field: &Field, from: [f64; 3], direction: [f64; 3], reach: f64) -> Option<f64> {
    let at = |t: f64| field.value(std::array::from_fn(|k| from[k] + t * direction[k]));
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

/// The directions of the nearest and the farthest point of a radius.
struct NearestOfRadius {
    nearest: [Rational; 2],
    farthest: [Rational; 2],
}

impl NearestOfRadius {
    fn of(radius: &FourierRadius, points: &[[f64; 2]], point: &[Rational; 3]) -> Self {
        let [x, y, _] = point.each_ref().map(Rational::to_f64);
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
        Self {
            nearest: extreme(1.0),
            farthest: extreme(-1.0),
        }
    }
}

impl Witnesses for NearestOfRadius {
    fn depth(&self) -> u32 {
        DEPTH_OF_ARCS
    }

    fn witness(&self, _: &Rational, exactly: bool) -> Option<Value> {
        let mut directions = vec![texts(&self.nearest)];
        if exactly {
            directions.push(texts(&self.farthest));
        }
        Some(json!({ "directions": directions }))
    }
}
