//! Closed forms of r(θ) against certified roots in exact directions.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestCaseResult};
use stellate::exact::Rational;
use stellate::limits::Limits;
use stellate::parametrize::{
    AngleRange, Branch, BranchRadius, Parametrization, PolarMethod, parametrize,
};
use stellate::poly::{PlanePolynomial, Ring};
use stellate::sample::{Direction, Ray, RaySolver};
use stellate::shape::{Form, ImplicitCurve};

/// How near to the end of a range an angle is not asked, and how exactly values must agree.
const NEAR: f64 = 2e-2;

fn inside(ranges: &[AngleRange], theta: f64) -> Option<bool> {
    let mut answer = false;
    for range in ranges {
        let end = |a: &stellate::parametrize::ExactAngle| a.to_decimal(9).parse::<f64>().unwrap();
        let (from, to) = (end(&range.from), end(&range.to));
        if (theta - from).abs() < NEAR || (theta - to).abs() < NEAR {
            return None;
        }
        answer |= from < theta && theta < to;
    }
    Some(answer)
}

/// The branches that are real at θ have exactly the values of the certified roots.
fn check(f: &PlanePolynomial, curve: &Parametrization, theta: f64) -> Result<(), TestCaseError> {
    let Ray::Points(points) = RaySolver::new(f).solve(&Direction::from_radians(theta)) else {
        return Ok(());
    };
    let mut real_branches = Vec::new();
    for branch in &curve.branches {
        let (Some(real), Some(positive)) =
            (inside(&branch.real, theta), inside(&branch.positive, theta))
        else {
            return Ok(());
        };
        if real {
            real_branches.push((branch, positive));
        }
    }
    // How many are real, and of which sign, is exact.
    prop_assert_eq!(real_branches.len(), points.len(), "at {}", theta);
    let positive = real_branches
        .iter()
        .filter(|(_, positive)| *positive)
        .count();
    prop_assert_eq!(
        positive,
        points.iter().filter(|p| p.r > 0.0).count(),
        "at {}",
        theta
    );
    // Doubles cannot tell close roots apart, nor show huge and tiny ones: those are not compared.
    let spread = points.iter().map(|p| p.r.abs()).fold(0.0, f64::max);
    let close = points.windows(2).any(|p| p[0].r - p[1].r < 0.02 * spread);
    if close || points.iter().any(|p| p.r.abs() < 0.02 * spread) {
        return Ok(());
    }
    let mut values = Vec::new();
    for (branch, positive) in real_branches {
        let value = branch.radius.approximate(theta);
        prop_assert!(!value.is_nan(), "a real branch has a value at {theta}");
        prop_assert_eq!(positive, value > 0.0, "the sign of {} at {}", value, theta);
        values.push(value);
    }
    values.sort_by(|a, b| b.total_cmp(a));
    for (value, point) in values.iter().zip(&points) {
        prop_assert!(
            (value - point.r).abs() <= 1e-4 * spread,
            "{} {}",
            value,
            point.r
        );
    }
    Ok(())
}

/// A sum of random forms of the given degrees.
fn parts(degrees: Vec<usize>) -> impl Strategy<Value = PlanePolynomial> {
    let forms: Vec<_> = degrees
        .into_iter()
        .map(|d| {
            prop::collection::vec(-6i64..7, d + 1).prop_map(move |c| {
                let terms = c
                    .into_iter()
                    .enumerate()
                    .map(move |(k, c)| ((d - k, k), Rational::from(c)));
                PlanePolynomial::from_terms(terms)
            })
        })
        .collect();
    forms.prop_map(|forms| {
        PlanePolynomial::from_terms(forms.iter().flat_map(|f| f.terms().collect::<Vec<_>>()))
    })
}

/// Sums of up to five forms of degrees n, n − k, n − 2k, … with k ≤ 3.
fn curves() -> impl Strategy<Value = PlanePolynomial> {
    (1usize..4, 0usize..3, 2usize..6)
        .prop_flat_map(|(k, low, count)| parts((0..count).map(|j| low + j * k).collect()))
}

fn branches_are_roots(f: &PlanePolynomial, angles: &[f64]) -> TestCaseResult {
    prop_assume!(!f.is_zero());
    let curve = parametrize(&ImplicitCurve::new(f.clone()), &Limits::none()).unwrap();
    angles.iter().try_for_each(|theta| check(f, &curve, *theta))
}

/// A fixed seed: closed forms are compared in doubles, whose errors have no bound here.
fn fifty_cases(seed: u64) -> ProptestConfig {
    ProptestConfig {
        cases: 50,
        rng_seed: RngSeed::Fixed(seed),
        ..ProptestConfig::default()
    }
}

// Two halves, so that two cores have one each.
proptest! {
    #![proptest_config(fifty_cases(7))]

    #[test]
    fn branches_are_the_certified_roots(f in curves(), angles in prop::collection::vec(0.0f64..6.25, 6)) {
        branches_are_roots(&f, &angles)?;
    }
}

proptest! {
    #![proptest_config(fifty_cases(8))]

    #[test]
    fn branches_of_other_curves_are_the_certified_roots(f in curves(), angles in prop::collection::vec(0.0f64..6.25, 6)) {
        branches_are_roots(&f, &angles)?;
    }
}

proptest! {
    #![proptest_config(fifty_cases(9))]

    /// Quartics in R whose roots lie symmetrically about a middle: M (S² − k S) + N with S = u² + u for a linear form u and forms M
    /// and N of one degree. The form under the inner root of Lemma 5 has square factors that change their sign.
    #[test]
    fn symmetric_quartics_are_the_certified_roots(
        [m, n] in prop::array::uniform2(prop::collection::vec(-4i64..5, 2)),
        u in prop::sample::select(vec![[1, 0], [0, 1], [1, 1], [1, -1]]),
        k in -3i64..4,
        angles in prop::collection::vec(0.0f64..6.25, 12),
    ) {
        let form = |c: &[i64]| {
            let last = c.len() - 1;
            let terms = c.iter().enumerate().map(|(i, &c)| ((last - i, i), Rational::from(c)));
            PlanePolynomial::from_terms(terms)
        };
        let u = form(&u);
        let s = u.squared().plus(&u);
        let k = PlanePolynomial::from_terms([((0, 0), Rational::from(k))]);
        let square = s.squared().minus(&k.times(&s));
        let f = form(&m).times(&square).plus(&form(&n));
        // Where the first part is small, doubles cancel in the formulas.
        let is_large = |f: &PlanePolynomial, theta: f64| {
            let at = [theta.cos(), theta.sin()].map(|x| Rational::try_from(x).unwrap());
            f.evaluate(&at[0], &at[1]).to_f64().abs() > 0.4
        };
        let of_first = [&u, &form(&m)];
        let angles: Vec<f64> = angles
            .into_iter()
            .filter(|&theta| of_first.iter().all(|f| is_large(f, theta)))
            .collect();
        branches_are_roots(&f, &angles)?;
    }
}

/// Isolated points in directions with irrational slopes: a double root of a quartic, real there alone.
#[test]
fn isolated_points_have_the_right_sign() {
    use stellate::language::{Numbers, parse_form};
    for (text, positive) in [
        // (1, ±√2): at ±54.7…° with r > 0 and opposite with r < 0.
        ("(x-1)^2 + (y^2-2)^2", 2),
        ("(x+1)^2*(1+y^2) + (y^2-2)^2", 2),
    ] {
        let Form::Curve(curve) = parse_form(text, "<form>", Numbers::Exact).unwrap() else {
            panic!("a plane curve")
        };
        let found = parametrize(&curve, &Limits::none()).unwrap();
        assert_eq!(found.method, PolarMethod::Lemma(5));
        let single = |ranges: &[AngleRange]| -> Vec<String> {
            let points = ranges.iter().filter(|r| r.is_point());
            points.map(|r| r.from.to_decimal(6)).collect()
        };
        let of_all = |ranges: fn(&Branch) -> &[AngleRange]| {
            let mut all: Vec<String> = found
                .branches
                .iter()
                .flat_map(|b| single(ranges(b)))
                .collect();
            all.sort();
            all.dedup();
            all
        };
        let (real, above) = (of_all(|b| &b.real), of_all(|b| &b.positive));
        assert_eq!(
            (real.len(), above.len()),
            (4, positive),
            "{text}: {real:?} {above:?}"
        );
        for theta in above {
            let theta: f64 = theta.parse().unwrap();
            let x = if text.starts_with("(x-1)") { 1.0 } else { -1.0 };
            assert!((theta.cos() - x / 3f64.sqrt()).abs() < 1e-5, "{theta}");
        }
    }
}

/// Where the leading part vanishes one root is infinite, and the finite ones are not lost.
#[test]
fn finite_roots_beside_an_infinite_one_are_kept() {
    use stellate::language::{Numbers, parse_form};
    for text in [
        "x^3 + x^2*y + y - 1",
        "x^3 - 3x*y^2 + y^2 - x - 1",
        "x^2*y^2 - x^3 + y - 2x^2 + 3",
        "x^4 + x^3*y - 4x^2*y + x*y - 5x + y^2 - 2",
        "x^6 - x^2*y^4 - 7x^4 + y^4 - x^2 + 2y^2 - 1",
        // The slope is irrational: x² = 2y².
        "(x^2 - 2y^2)*x + 3x*y + y - 1",
        "(x^2 - 2y^2)*(x^2 + y^2) + x^2*y - 3x*y + y - 1",
    ] {
        let Form::Curve(curve) = parse_form(text, "<form>", Numbers::Exact).unwrap() else {
            panic!("a plane curve")
        };
        let found = parametrize(&curve, &Limits::none()).unwrap();
        let top = curve.polynomial().homogeneous_degrees()[0];
        let top: PlanePolynomial = curve.polynomial().part(top).cloned().into_iter().collect();
        let mut seen = 0;
        for degrees in (0..360).step_by(90) {
            let direction = Direction::from_degrees(&Rational::from(degrees));
            let Ray::Points(points) = RaySolver::new(curve.polynomial()).solve(&direction) else {
                panic!("no line in {text}")
            };
            let theta = f64::from(degrees).to_radians();
            let here = |ranges: &[AngleRange]| {
                ranges.iter().any(|r| {
                    let at = |e: &stellate::parametrize::ExactAngle| {
                        e.to_decimal(9).parse::<f64>().unwrap()
                    };
                    let (from, to) = (at(&r.from), at(&r.to));
                    let closed = |e: f64, c: bool| (e - theta).abs() < 1e-8 && c;
                    (from + 1e-8 < theta && theta < to - 1e-8)
                        || closed(from, r.closed[0])
                        || closed(to, r.closed[1])
                })
            };
            let real = found.branches.iter().filter(|b| here(&b.real)).count();
            let positive = found.branches.iter().filter(|b| here(&b.positive)).count();
            assert_eq!(real, points.len(), "{text} at {degrees} degrees");
            assert_eq!(
                positive,
                points.iter().filter(|p| p.r > 0.0).count(),
                "{text} at {degrees} degrees"
            );
            seen += usize::from(
                top.evaluate(&direction.u(), &direction.v()).is_zero() && !points.is_empty(),
            );
        }
        let irrational = text.starts_with("(x^2");
        assert!(
            seen > 0 || irrational,
            "{text}: a leading part vanishes along an axis"
        );
        let single = found
            .branches
            .iter()
            .filter(|b| matches!(&b.radius, BranchRadius::Root(root) if root.is_point()))
            .count();
        assert!(single > 0, "{text}");
    }
}

/// Where a formula has a pole or a zero at a rational slope, and another one ends at an irrational slope near it, the roots between the
/// two are those of the ranges.
#[test]
fn ranges_between_near_ends_are_right() {
    use stellate::language::{Numbers, parse_form};
    for (text, theta) in [
        ("20x^3-40x^2*y-5x^2-25x+2y=0", 4.63254),
        ("4x^3+2x^2*y-2x*y^2-4y^3+x^2+x*y/3-y^2-4x-5y=0", 0.785_45),
        ("4x - 2y + 2x^3 + 3x*y^3 + 3y^4 = 0", 1.10716),
        ("9x^2*y - 7x*y^2 - 2y^3 + 2x^2 - 5x + y = 0", 1.78952),
    ] {
        let Form::Curve(curve) = parse_form(text, "<form>", Numbers::Exact).unwrap() else {
            panic!("a plane curve")
        };
        let found = parametrize(&curve, &Limits::none()).unwrap();
        for theta in [
            theta,
            (theta + std::f64::consts::PI) % std::f64::consts::TAU,
        ] {
            let direction = Direction::from_radians(theta);
            let Ray::Points(points) = RaySolver::new(curve.polynomial()).solve(&direction) else {
                panic!("{text} has no line at {theta}")
            };
            // The origin is a point of the curve in every direction.
            let roots: Vec<f64> = points.iter().map(|p| p.r).filter(|r| *r != 0.0).collect();
            let count = |ranges: fn(&Branch) -> &[AngleRange]| {
                let holds = |branch: &&Branch| {
                    ranges(branch).iter().any(|range| {
                        let end = |a: &stellate::parametrize::ExactAngle| {
                            a.to_decimal(12).parse::<f64>().unwrap()
                        };
                        end(&range.from) < theta && theta < end(&range.to)
                    })
                };
                found.branches.iter().filter(holds).count()
            };
            assert_eq!(count(|b| &b.real), roots.len(), "{text} at {theta}");
            let positive = roots.iter().filter(|r| **r > 0.0).count();
            assert_eq!(count(|b| &b.positive), positive, "{text} at {theta}");
        }
    }
}
