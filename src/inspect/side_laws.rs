//! The sides of plane curves, on points whose side is known by construction.

use proptest::prelude::*;

use super::*;
use crate::inspect::{Inspector, InspectorOptions};
use crate::language::{Numbers, parse_form};
use crate::shape::{Form, ImplicitCurve};

/// The sign, with no bounds of the distance but the given ones.
fn sign(sides: &Sides, point: &[Rational; 2], distance: DistanceBounds) -> i8 {
    let near = point.each_ref().map(Rational::to_f64);
    let off = |i: usize| (Rational::try_from(near[i]).unwrap() - &point[i]).abs();
    let exactly = || point.clone();
    let point = PlanePoint {
        near,
        slack: Interval::narrowest(&(off(0) + off(1))).high(),
        exactly: &exactly,
    };
    sides.sign(&point, &distance)
}

/// The direction with the half-angle tangent s, and the radius there.
fn exact_radius(radius: &FourierRadius, s: &Rational) -> ([Rational; 2], Rational) {
    let one = Rational::one();
    let below = (&one + s * s).recip().unwrap();
    let [u, v] = [(&one - s * s) * &below, (s + s) * &below];
    let (mut cos, mut sin, mut r) = (one, Rational::zero(), Rational::zero());
    for n in 0..=radius.harmonics() {
        r = r + radius.cos(n) * &cos + radius.sin(n) * &sin;
        (cos, sin) = (&cos * &u - &sin * &v, &cos * &v + &sin * &u);
    }
    ([u, v], r)
}

fn plane_curve(text: &str) -> PlaneCurve {
    match parse_form(text, "<form>", Numbers::Exact).unwrap() {
        Form::PlaneCurve(curve) => curve,
        Form::Fourier(radius) => EllipticSeries::from_radius(&radius).to_plane_curve(),
        _ => panic!("a plane curve"),
    }
}

fn quotient(p: i64, q: i64) -> Rational {
    Rational::from(p) / Rational::from(q)
}

proptest! {
    /// Points at λ times a positive radius in a rational direction, as sides of a radius and by winding numbers, with and without
    /// bounds of the distance. Some are so near to the curve that doubles do not decide.
    #[test]
    fn radii_divide_the_plane(
        pairs in prop::collection::vec((-9i64..=9, -9i64..=9), 1..9),
        center in (-99i64..99, -99i64..99),
        direction in (-40i64..40, 1i64..20),
        tiny in 1u32..200,
        side in -1i8..=1,
    ) {
        let sum: i64 = pairs.iter().map(|(a, b)| a.abs() + b.abs()).sum();
        let (mut cos, sin): (Vec<_>, Vec<_>) = pairs.into_iter().map(|(a, b)| (Rational::from(a), Rational::from(b))).unzip();
        cos[0] = Rational::from(sum + 1);
        let center = [quotient(center.0, 7), quotient(center.1, 3)];
        let radius = FourierRadius::new(cos, sin).with_center(center.clone());
        let ([u, v], r) = exact_radius(&radius, &quotient(direction.0, direction.1));
        let little = Rational::from_dyadic(1.into(), -i64::from(tiny));
        let rho = &r * (Rational::one() + &little * Rational::from(i64::from(side)));
        let point = [&center[0] + &rho * u, &center[1] + &rho * v];
        let unknown = DistanceBounds { low: 0.0, high: f64::INFINITY };
        let known = DistanceBounds { low: little.to_f64() * 0.01, high: f64::INFINITY };
        for is_positive in [true, false] {
            let sides = Sides::of_radius(&radius, is_positive, &Limits::none()).unwrap();
            prop_assert_eq!(sign(&sides, &point, unknown), side);
            prop_assert_eq!(sign(&sides, &center, unknown), -1);
            if side != 0 && tiny < 40 {
                prop_assert_eq!(sign(&sides, &point, known), side);
            }
        }
    }

    /// The sign of an equation is that of its canonical polynomial, whatever the multiplicities of its factors.
    #[test]
    fn equations_have_the_sign_of_their_polynomials(p in (-40i64..40, -40i64..40), scale in prop::sample::select(vec![-3i64, 1])) {
        let text = format!("{scale}*(x^2 + y^2 - 1)*(x - y)^2*(x^3 - y)^3*(x^2 + 2y^2 + 1) = 0");
        let Form::Curve(curve) = parse_form(&text, "<form>", Numbers::Exact).unwrap() else { panic!() };
        let inspector = Inspector::plane(&curve, &InspectorOptions::new(quotient(1, 50)), &Limits::none()).unwrap();
        let point = [quotient(p.0, 20), quotient(p.1, 20), Rational::zero()];
        let [x, y, _] = &point;
        let circle = x * x + y * y - Rational::one();
        let parts = [circle.signum(), (x - y).signum().abs(), (x * x * x - y).signum()];
        let found = inspector.inspect(&point);
        prop_assert_eq!(found.sign, Some(parts.iter().product()));
        prop_assert!(found.distance.low <= found.distance.high && found.distance.high.is_finite());
    }
}

#[test]
fn winding_numbers_count_by_parity() {
    for (form, inside, outside) in [
        // Both lobes of a figure of eight.
        (
            "x = sin(t); y = sin(t)*cos(t)",
            vec![[1, 0], [-1, 0]],
            vec![[0, 1], [0, -1], [4, 0]],
        ),
        // The inner loop of a limaçon is wound around twice.
        (
            "r = 1 + 2*cos(t)",
            vec![[5, 0], [4, 0]],
            vec![[1, 0], [-1, 0], [7, 0]],
        ),
        // A circle as a rational curve, one point of which is at the parameter ∞.
        (
            "x = (1 - t^2)/(1 + t^2); y = 2t/(1 + t^2)",
            vec![[1, 0], [-1, 0]],
            vec![[3, 0], [-3, 1]],
        ),
        // Circles that are traced twice, by multiples of an angle and by another function of degree 2, and twice there and back.
        ("x = cos(2t); y = sin(2t)", vec![[1, 1]], vec![[3, 0]]),
        (
            "x = cos(t)^2; y = sin(t)*cos(t)",
            vec![[1, 0], [1, 1]],
            vec![[-1, 0], [3, 0]],
        ),
        (
            "x = (t^2 - (t^2 - 2)^2)/(t^2 + (t^2 - 2)^2); y = 2t*(t^2 - 2)/(t^2 + (t^2 - 2)^2)",
            vec![[1, 0], [-1, 1]],
            vec![[3, 0], [0, 4]],
        ),
        // Half a circle there and back is no boundary.
        (
            "x = (1 - t^4)/(1 + t^4); y = 2t^2/(1 + t^4)",
            Vec::new(),
            vec![[1, 1], [0, 0], [3, 0]],
        ),
    ] {
        let curve = plane_curve(form);
        let sides = Sides::of_curve(&curve, &Limits::none()).unwrap().unwrap();
        let unknown = DistanceBounds {
            low: 0.0,
            high: f64::INFINITY,
        };
        for (points, expected) in [(inside, -1), (outside, 1)] {
            for [x, y] in points {
                let point = [quotient(x, 2), quotient(y, 3)];
                for distance in [
                    unknown,
                    DistanceBounds {
                        low: 0.01,
                        ..unknown
                    },
                ] {
                    assert_eq!(
                        sign(&sides, &point, distance),
                        expected,
                        "{form}: {point:?}"
                    );
                }
            }
        }
    }
    // Only odd harmonics trace a radius twice.
    for (form, inside, outside) in [
        ("r = sin(t)", [0, 1], [0, -1]),
        ("r = cos(3t)", [1, 0], [-1, 0]),
        ("r = 2*cos(t)^3", [1, 0], [-1, 0]),
    ] {
        let Form::Fourier(radius) = parse_form(form, "<form>", Numbers::Exact).unwrap() else {
            panic!("a radius")
        };
        let sides = Sides::of_radius(&radius, false, &Limits::none()).unwrap();
        let unknown = DistanceBounds {
            low: 0.0,
            high: f64::INFINITY,
        };
        for ([x, y], expected) in [(inside, -1), (outside, 1)] {
            let point = [quotient(x, 2), quotient(y, 3)];
            assert_eq!(sign(&sides, &point, unknown), expected, "{form}");
        }
    }
    for open in ["x = t^2; y = t^3 + t", "x = 1/t; y = t/(1 + t^2)"] {
        assert!(
            Sides::of_curve(&plane_curve(open), &Limits::none())
                .unwrap()
                .is_none()
        );
    }
    let circle = plane_curve("x = (1 - t^2)/(1 + t^2); y = 2t/(1 + t^2)");
    let sides = Sides::of_curve(&circle, &Limits::none()).unwrap().unwrap();
    let unknown = DistanceBounds {
        low: 0.0,
        high: f64::INFINITY,
    };
    for point in [[-1, 0], [0, 1], [1, 0]] {
        let point = point.map(|c| Rational::from(i64::from(c)));
        assert_eq!(sign(&sides, &point, unknown), 0);
    }
}

/// A far point of an equation has its distance, and one of an equation without zeros has none.
#[test]
fn far_points_have_distances() {
    let inspector = |text: &str| {
        let form = parse_form(text, "<form>", Numbers::Exact).unwrap();
        let Form::Curve(curve) = form else {
            panic!("a curve")
        };
        let curve: ImplicitCurve = curve;
        Inspector::plane(
            &curve,
            &InspectorOptions::new(quotient(1, 100)),
            &Limits::none(),
        )
        .unwrap()
    };
    for (text, point, expected) in [
        ("x^2 + y^2 = 1", [1000, 0], 999.0),
        ("(x^2 + y^2 - 1)*((x - 10)^2 + y^2 - 1)", [100, 0], 89.0),
        ("(x^2 + y^2 - 1)*((x - 10)^2 + y^2 - 1)", [5, 0], 4.0),
        ("y = x^2", [0, -7], 7.0),
    ] {
        let point = [point[0], point[1], 0].map(Rational::from);
        let found = inspector(text).inspect(&point).distance;
        assert!(
            found.low <= expected && expected <= found.high,
            "{text}: {found:?}"
        );
        assert!(
            found.high - found.low <= 2e-6 * expected,
            "{text}: {found:?}"
        );
    }
    // An isolated point, around which the sign does not change: the lower bound is proved.
    let isolated = inspector("x^2 + y^2 = 0").inspect(&[3, 4, 0].map(Rational::from));
    assert!(isolated.distance.low > 4.999 && isolated.distance.low <= 5.0);
    let nothing = inspector("x^2 + y^2 + 1 = 0").inspect(&[3, 4, 0].map(Rational::from));
    assert!(nothing.distance.high.is_infinite());
}
