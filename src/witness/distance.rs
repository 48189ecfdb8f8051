//! Claims about the distance of points from an equation or a radius, and about their side (T6).

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

use serde_json::{Value, json};

use super::forms::{curve_form, harmonic_form, radius_form, surface_form, texts};
use super::minima::{ANGLES, angle, minima, narrowed, real};
use super::proof::{Proof, by_expansion};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::inspect::{DecidedDistance, Inspection, stationary};
use crate::intervals::{Field, distance};
use crate::poly::{PlanePolynomial, SparsePolynomial};
use crate::sample::{Direction, SpaceDirection, UnitVector};
use crate::shape::{FourierRadius, HarmonicSurface, ImplicitCurve, ImplicitSurface};

/// The number of directions in which the nearest zero of a polynomial is searched.
const RAYS: usize = 96;
/// Zeros are searched to this multiple of the largest distance, so that rays beside the nearest zero meet one, too.
const BEYOND: f64 = 1.5;
/// The number of steps along one ray.
const STEPS: u32 = 48;
/// The number of feet from which covers get their multipliers.
const MOST_FEET: usize = 4;
/// Points are among the nearest ones up to this ratio of their distances.
const NEARLY: f64 = 1.1;
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
    /// A form whose distances have no witness: the index of a sum of spherical harmonics, whose sides have one, or of none.
    Other(Option<usize>),
}

/// The polynomial of a plane curve or of a surface. In the plane z is 0.
#[derive(Debug)]
pub(crate) struct Equation {
    field: Field,
    /// The polynomial is this multiple of that of the field.
    scale: f64,
    dimension: usize,
    /// The origin of the polynomial's coordinates.
    center: [Rational; 3],
}

impl Equation {
    fn new(polynomial: &SparsePolynomial<3>, dimension: usize, center: [Rational; 3]) -> Self {
        let field = Field::new(polynomial);
        let [own, of_field] = [polynomial, field.polynomial()].map(|f| f.terms().next());
        let [c, d] = [own, of_field].map(|first| {
            let (_, c) = first.invariant("the polynomial of an equation is not 0");
            c
        });
        let scale = (c / d).to_f64();
        Self {
            field,
            scale,
            dimension,
            center,
        }
    }
}

impl InspectedForm {
    /// The polynomial is written with coprime integers and a positive first coefficient, since `side` claims its sign.
    pub(crate) fn of_curve(curve: &ImplicitCurve, proof: &mut Proof) -> Self {
        let primitive: PlanePolynomial = curve.polynomial().primitive();
        let [a, b] = curve.center().clone();
        let in_space = SparsePolynomial::from(&primitive);
        let equation = Equation::new(&in_space, 2, [a, b, Rational::zero()]);
        Self::Equation(curve_form(proof, &primitive), Box::new(equation))
    }

    /// As [`Self::of_curve`].
    pub(crate) fn of_surface(surface: &ImplicitSurface, proof: &mut Proof) -> Self {
        let primitive = surface.polynomial().primitive();
        let equation = Equation::new(&primitive, 3, surface.center().clone());
        Self::Equation(surface_form(proof, &primitive), Box::new(equation))
    }

    pub(crate) fn of_harmonics(surface: &HarmonicSurface, proof: &mut Proof) -> Self {
        Self::Other(harmonic_form(proof, surface))
    }

    pub(crate) fn of_radius(radius: &FourierRadius, proof: &mut Proof) -> Self {
        let points = (0..ANGLES).map(|k| point_of_radius(radius, angle(real(k))));
        Self::Radius(radius_form(proof, radius), radius.clone(), points.collect())
    }
}

fn point_of_radius(radius: &FourierRadius, theta: f64) -> [f64; 2] {
    let r = radius.approximate(theta);
    let center = radius.center().each_ref().map(Rational::to_f64);
    [center[0] + r * theta.cos(), center[1] + r * theta.sin()]
}

/// The answers for a point, about which claims are made.
#[derive(Debug)]
pub(crate) struct ClaimedPoint {
    /// The exact point.
    pub(crate) point: [Rational; 3],
    /// The radius of the criterion of Theorem 8: the tolerance of the point's side.
    pub(crate) tolerance: Rational,
    /// The answers.
    pub(crate) inspection: Inspection,
    /// What was decided about the distance for the verdict. Together with the side it implies the verdict.
    pub(crate) decided: Vec<DecidedDistance>,
}

/// Claims the answers for one point: `distance` for the verdict, for the criterion of Theorem 8 and for the bounds, and `side`.
pub(crate) fn inspected_point(proof: &mut Proof, form: &InspectedForm, claimed: &ClaimedPoint) {
    let ClaimedPoint {
        point,
        tolerance,
        inspection: found,
        decided,
    } = claimed;
    let decided = decided.iter().map(|decided| {
        let relation = if decided.is_within {
            "at-most"
        } else {
            "more-than"
        };
        (relation, decided.distance.clone())
    });
    let mut asked: Vec<(&'static str, Rational)> = decided.collect();
    // On a side whose tolerance is 0, the side of the point says it all.
    let criterion = found.curve.filter(|_| !tolerance.is_zero());
    match criterion {
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
        InspectedForm::Other(index) => {
            claim_all(proof, *index, &point[..], asked, found.sign, |_| NoWitness);
        }
    }
}

/// A simple rational number near the given one.
fn short(value: f64) -> Option<Rational> {
    /// An error of this relative size moves the least value of f − μ·(d² − |x − p|²) by its square.
    const ERROR: f64 = 1e-9;
    let ends = [value * (1.0 - ERROR), value * (1.0 + ERROR)];
    let [low, high] = [exact(ends[0].min(ends[1]))?, exact(ends[0].max(ends[1]))?];
    (low < high).then(|| Rational::simplest_between(&low, &high))
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
            "more-than" | "misses" => nearest.cover(),
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
    /// The rule of a cover that excludes points of the form.
    fn cover(&self) -> Option<Value>;

    /// A witness that a point of the form is within the bound, or at exactly this distance.
    fn witness(&self, bound: &Rational, exactly: bool) -> Option<Value>;
}

/// There are no witnesses for the distances of this form.
struct NoWitness;

impl Witnesses for NoWitness {
    fn cover(&self) -> Option<Value> {
        None
    }

    fn witness(&self, _: &Rational, _: bool) -> Option<Value> {
        None
    }
}

/// The nearest zero of a polynomial to a point: its direction and its distance in doubles.
struct Nearest<'a> {
    equation: &'a Equation,
    point: &'a [Rational; 3],
    foot: Option<([f64; 3], f64)>,
    /// The multipliers of Lagrange at the nearest feet.
    multipliers: Vec<Rational>,
}

impl<'a> Nearest<'a> {
    fn of(equation: &'a Equation, point: &'a [Rational; 3], reach: f64) -> Self {
        let from = point.each_ref().map(Rational::to_f64);
        let rays = directions(equation.dimension).into_iter();
        let zeros = rays.filter_map(|direction| {
            let t = first_zero(&equation.field, from, direction, reach * BEYOND)?;
            Some((direction, t))
        });
        let mut zeros: Vec<([f64; 3], f64)> = zeros.collect();
        zeros.sort_unstable_by(|(_, a), (_, b)| a.total_cmp(b));
        // The normals at the nearest zeros go through the point.
        let mut feet: Vec<([f64; 3], f64)> = Vec::new();
        for (direction, t) in &zeros {
            let start = std::array::from_fn(|k| from[k] + t * direction[k]);
            let Some(q) = stationary(&equation.field, from, start) else {
                continue;
            };
            let length = distance(from, q);
            let is_known = |(other, _): &([f64; 3], f64)| distance(*other, q) < 1e-3 * length;
            if length.is_normal() && length <= *t && !feet.iter().any(is_known) {
                feet.push((q, length));
            }
            if feet.len() == MOST_FEET {
                break;
            }
        }
        feet.sort_unstable_by(|(_, a), (_, b)| a.total_cmp(b));
        let multipliers = feet.iter().filter_map(|(q, length)| {
            let slope = equation.field.gradient(*q);
            let along: f64 = (0..3).map(|k| slope[k] * (q[k] - from[k])).sum();
            short(-along / (2.0 * length * length) * equation.scale)
        });
        let away = |(q, length): &([f64; 3], f64)| {
            (std::array::from_fn(|k| (q[k] - from[k]) / length), *length)
        };
        Self {
            equation,
            point,
            multipliers: multipliers.collect(),
            foot: feet.first().map(away).or(zeros.first().copied()),
        }
    }

    fn end(&self, direction: &[Rational; 3], length: &Rational) -> [Rational; 3] {
        std::array::from_fn(|k| &self.point[k] + &(length * &direction[k]))
    }
}

impl Witnesses for Nearest<'_> {
    fn cover(&self) -> Option<Value> {
        let mut witness = json!({ "depth": DEPTHS[self.equation.dimension - 2] });
        if !self.multipliers.is_empty() {
            witness["multipliers"] = texts(&self.multipliers);
        }
        Some(witness)
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
    /// Numbers q + t for the angles qπ/2 + 2 atan t of the nearest points.
    places: Vec<Rational>,
}

impl NearestOfRadius {
    fn of(radius: &FourierRadius, points: &[[f64; 2]], point: &[Rational; 3]) -> Self {
        let [x, y, _] = point.each_ref().map(Rational::to_f64);
        let distance = |[a, b]: [f64; 2]| (a - x).hypot(b - y);
        let at = |k: f64| distance(point_of_radius(radius, angle(k)));
        let values: Vec<f64> = points.iter().map(|point| distance(*point)).collect();
        let negative: Vec<f64> = values.iter().map(|value| -value).collect();
        let [mut lowest, highest] = [&values, &negative].map(|values| minima(values));
        let least = values[lowest[0]];
        lowest.retain(|&k| values[k] <= least * NEARLY || values[k].is_nan());
        lowest.truncate(MOST_FEET);
        let lowest: Vec<f64> = lowest.into_iter().map(|k| angle(narrowed(k, at))).collect();
        let highest = angle(narrowed(highest[0], |k| -at(k)));
        let direction = |theta: f64| {
            // Where the nearest point is in the direction of an axis, it may be at exactly the distance that is claimed.
            let degrees = theta.to_degrees();
            let whole = Rational::try_from(degrees.round()).ok();
            match whole.filter(|_| (degrees - degrees.round()).abs() < 1e-5) {
                Some(whole) => Direction::from_degrees(&whole).components(),
                None => Direction::from_radians(theta).components(),
            }
        };
        Self {
            nearest: direction(lowest[0]),
            farthest: direction(highest),
            places: lowest.iter().filter_map(|theta| place(*theta)).collect(),
        }
    }
}

/// A simple number q + t near that of an angle.
fn place(theta: f64) -> Option<Rational> {
    /// An error of this size moves the least value of the squared distance by its square.
    const ERROR: f64 = 1e-9;
    let turn = theta.rem_euclid(TAU) / FRAC_PI_2;
    let quarter = turn.floor().min(3.0);
    let parameter = ((turn - quarter) * FRAC_PI_4).tan();
    let ends = [parameter - ERROR, parameter + ERROR].map(|t| exact(quarter + t.clamp(0.0, 1.0)));
    let [Some(low), Some(high)] = ends else {
        return None;
    };
    (low < high).then(|| Rational::simplest_between(&low, &high))
}

impl Witnesses for NearestOfRadius {
    fn cover(&self) -> Option<Value> {
        let mut witness = json!({ "depth": DEPTH_OF_ARCS });
        if !self.places.is_empty() {
            witness["near"] = texts(&self.places);
        }
        Some(witness)
    }

    fn witness(&self, _: &Rational, exactly: bool) -> Option<Value> {
        let mut directions = vec![texts(&self.nearest)];
        if exactly {
            directions.push(texts(&self.farthest));
        }
        Some(json!({ "directions": directions }))
    }
}
