//! Inspection of unions of spheres, planes and cylinders, circles and lines: verdicts, the paper's criterion and distance
//! bounds against the exact truth, for points near and exactly at the tolerance.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};
use stellate::inspect::{Inspector, InspectorOptions, Verdict};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::shape::Form;

use super::draw::Draw;
use super::exact::{Q, our, value};
use super::harness::Outcome;

/// A set with a known distance: |δ − ρ| where δ² is a rational number.
enum Shape {
    /// A sphere or circle: center and radius. Its farthest point matters for the criterion.
    Round([Q; 3], Q),
    /// A plane or line through a point, with a rational unit normal.
    Flat([Q; 3], [Q; 3]),
    /// A cylinder: a point of the axis, its rational unit direction, the radius.
    Pipe([Q; 3], [Q; 3], Q),
}

fn dot(a: &[Q; 3], b: &[Q; 3]) -> Q {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn minus(a: &[Q; 3], b: &[Q; 3]) -> [Q; 3] {
    std::array::from_fn(|i| &a[i] - &b[i])
}

impl Shape {
    /// δ² and ρ.
    fn distances(&self, p: &[Q; 3]) -> (Q, Q) {
        match self {
            Self::Round(c, radius) => {
                let v = minus(p, c);
                (dot(&v, &v), radius.clone())
            }
            Self::Flat(q, normal) => {
                let height = dot(&minus(p, q), normal);
                (&height * &height, Q::zero())
            }
            Self::Pipe(q, axis, radius) => {
                let v = minus(p, q);
                let along = dot(&v, axis);
                (dot(&v, &v) - &along * &along, radius.clone())
            }
        }
    }

    /// Whether |√δ² − ρ| ≤ d: ρ − d ≤ √δ² ≤ ρ + d.
    fn is_within(&self, p: &[Q; 3], d: &Q) -> bool {
        let (square, radius) = self.distances(p);
        let (low, high) = (&radius - d, &radius + d);
        !high.is_negative()
            && square <= &high * &high
            && (!low.is_positive() || square >= &low * &low)
    }

    /// Whether the sphere of radius d about p meets it: besides, the farthest point is not nearer than d.
    fn is_met(&self, p: &[Q; 3], d: &Q) -> bool {
        let (square, radius) = self.distances(p);
        let reaches = match self {
            // √δ² + ρ ≥ d
            Self::Round(..) => {
                let rest = d - &radius;
                !rest.is_positive() || square >= &rest * &rest
            }
            _ => true,
        };
        reaches && self.is_within(p, d)
    }

    fn equation(&self, in_space: bool) -> String {
        let names = ["x", "y", "z"];
        let used = if in_space { 3 } else { 2 };
        let centered = |q: &[Q; 3], i: usize| format!("({} - ({}))", names[i], q[i]);
        let squares = |q: &[Q; 3]| {
            let terms = (0..used).map(|i| format!("{}^2", centered(q, i)));
            terms.collect::<Vec<_>>().join(" + ")
        };
        let along = |q: &[Q; 3], v: &[Q; 3]| {
            let terms = (0..used).map(|i| format!("({})*{}", v[i], centered(q, i)));
            terms.collect::<Vec<_>>().join(" + ")
        };
        match self {
            Self::Round(c, radius) => format!("({} - ({radius})^2)", squares(c)),
            Self::Flat(q, normal) => format!("({})", along(q, normal)),
            Self::Pipe(q, axis, radius) => {
                format!("({} - ({})^2 - ({radius})^2)", squares(q), along(q, axis))
            }
        }
    }

    /// A unit vector away from the set at some point of it, and that point.
    fn normal_at(&self, draw: &mut Draw, in_space: bool) -> ([Q; 3], [Q; 3]) {
        let unit = unit(draw, in_space);
        let beyond = |q: &[Q; 3], v: &[Q; 3], s: &Q| std::array::from_fn(|i| &q[i] + &v[i] * s);
        match self {
            Self::Round(c, radius) => (beyond(c, &unit, radius), unit),
            Self::Flat(q, normal) => (q.clone(), normal.clone()),
            Self::Pipe(q, axis, radius) => {
                // A rational unit vector at right angles to a rational axis: the axis is (0, 0, 1) or in the plane z = 0.
                let across = if axis[2].is_zero() {
                    [-axis[1].clone(), axis[0].clone(), Q::zero()]
                } else {
                    let [u, v] = plane_unit(draw);
                    [u, v, Q::zero()]
                };
                let along = draw.fraction(6, 5);
                let at = beyond(&beyond(q, axis, &along), &across, radius);
                (at, across)
            }
        }
    }
}

fn plane_unit(draw: &mut Draw) -> [Q; 2] {
    let bits = draw.pick(&[4u64, 8, 50]);
    let (vector, length) = draw.unit2(bits);
    vector.map(|v| Q::new(v, length.clone()))
}

fn unit(draw: &mut Draw, in_space: bool) -> [Q; 3] {
    if in_space {
        let bits = draw.pick(&[4u64, 8, 50]);
        let (vector, length) = draw.unit3(bits);
        vector.map(|v| Q::new(v, length.clone()))
    } else {
        let [u, v] = plane_unit(draw);
        [u, v, Q::zero()]
    }
}

fn point(draw: &mut Draw, in_space: bool, size: i64) -> [Q; 3] {
    let z = if in_space {
        draw.fraction(size, 7)
    } else {
        Q::zero()
    };
    [draw.fraction(size, 7), draw.fraction(size, 7), z]
}

fn shape(draw: &mut Draw, in_space: bool) -> Shape {
    let at = point(draw, in_space, 6);
    let radius = Q::new((1 + draw.below(30)).into(), (1 + draw.below(12)).into());
    match draw.below(if in_space { 3 } else { 2 }) {
        0 => Shape::Round(at, radius),
        1 => Shape::Flat(at, unit(draw, in_space)),
        _ => {
            let axis = if draw.once_in(2) {
                [Q::zero(), Q::zero(), Q::one()]
            } else {
                let [u, v] = plane_unit(draw);
                [u, v, Q::zero()]
            };
            Shape::Pipe(at, axis, radius)
        }
    }
}

fn inspect(draw: &mut Draw, in_space: bool) -> Outcome {
    let count = if draw.once_in(2) {
        1
    } else {
        2 + draw.index(2)
    };
    let shapes: Vec<Shape> = (0..count).map(|_| shape(draw, in_space)).collect();
    let tolerance = match draw.below(3) {
        0 => Q::new(1.into(), (1 + draw.below(100)).into()),
        1 => value(draw.double(4).abs()),
        _ => Q::new((1 + draw.below(300)).into(), (1 + draw.below(40)).into()),
    };
    // Near or exactly at the tolerance of one of the shapes, at a center, on a shape, or anywhere.
    let chosen = draw.index(shapes.len());
    let p = match draw.below(8) {
        0 => point(draw, in_space, 8),
        1 => match &shapes[chosen] {
            Shape::Round(c, _) | Shape::Flat(c, _) | Shape::Pipe(c, _, _) => c.clone(),
        },
        _ => {
            let (at, normal) = shapes[chosen].normal_at(draw, in_space);
            let mut off = if draw.once_in(6) {
                Q::zero()
            } else {
                tolerance.clone()
            };
            off += &tolerance * draw.tiny();
            if draw.once_in(2) {
                off = -off;
            }
            std::array::from_fn(|i| &at[i] + &normal[i] * &off)
        }
    };
    let product = shapes.iter().map(|shape| shape.equation(in_space));
    let mut text = product.collect::<Vec<_>>().join("*");
    if in_space {
        text.push_str(" + 0*z");
    }
    let [x, y, z] = &p;
    draw.input =
        format!("stellate inspect '{text}' --tolerance '{tolerance}' --point '{x},{y},{z}'");
    let reach = if draw.once_in(2) { 0.0 } else { 3.0 };
    let options = InspectorOptions::new(our(&tolerance))
        .reach(Some(reach))
        .cubes(20_000);
    let none = Limits::none();
    let inspector = match parse_form(&text, "<form>", Numbers::Exact).unwrap() {
        Form::Surface(surface) => Inspector::surface(&surface, &options, &none),
        Form::Curve(curve) => Inspector::plane(&curve, &options, &none),
        other => panic!("{other:?}"),
    }
    .unwrap();
    let found = inspector.inspect(&p.each_ref().map(our));
    let inside = shapes.iter().any(|shape| shape.is_within(&p, &tolerance));
    let met = shapes.iter().any(|shape| shape.is_met(&p, &tolerance));
    match found.verdict {
        Verdict::Inside => assert!(inside, "not inside: {found:?}"),
        Verdict::Outside => assert!(!inside, "not outside: {found:?}"),
        Verdict::Uncertain | Verdict::Undecided => {}
    }
    if let Some(curve) = found.curve {
        assert_eq!(curve, met, "the criterion: {found:?}");
    }
    let (low, high) = (found.distance.low, found.distance.high);
    assert!(low <= high && low >= 0.0, "{found:?}");
    if low > 0.0 {
        // Nothing is nearer than the lower bound: less than it by the least amount is not within.
        let below = value(low) * (Q::one() - Q::new(BigInt::one(), BigInt::one() << 200u32));
        assert!(
            !shapes.iter().any(|shape| shape.is_within(&p, &below)),
            "something is nearer than {low}"
        );
    }
    if high.is_finite() {
        let high = value(high);
        assert!(
            shapes.iter().any(|shape| shape.is_within(&p, &high)),
            "nothing is as near as {high}"
        );
    }
    if found.verdict == Verdict::Undecided || found.curve.is_none() {
        return Outcome::Open;
    }
    Outcome::Checked
}

pub(crate) fn plane(draw: &mut Draw) -> Outcome {
    inspect(draw, false)
}

pub(crate) fn space(draw: &mut Draw) -> Outcome {
    inspect(draw, true)
}
