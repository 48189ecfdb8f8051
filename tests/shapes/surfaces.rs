//! Lemmas 7 to 10 and Theorem 6: closed forms over forms in (α, β, γ), counts of sampled points, meridians.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::forms::space;
use crate::common::sturm::count_along;
use nalgebra::Complex;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use stellate::exact::Rational;
use stellate::limits::Limits;
use stellate::parametrize::{SurfaceMethod, SurfaceParametrization, parametrize_surface};
use stellate::poly::{SpacePolynomial, SparsePolynomial};
use stellate::sample::{Direction, Ray, RaySolver, Sample, SpaceDirection, UnitVector};
use stellate::shape::ImplicitSurface;

fn spherical(f: &SparsePolynomial<3>) -> SurfaceParametrization {
    parametrize_surface(&ImplicitSurface::new(f.clone()), &Limits::none()).unwrap()
}

fn points(f: &SpacePolynomial, direction: &SpaceDirection) -> Option<Vec<Sample<3>>> {
    match RaySolver::new(f).solve(direction) {
        Ray::Points(points) => Some(points),
        Ray::Line => None,
    }
}

fn floats(direction: &SpaceDirection) -> [f64; 3] {
    direction.components().map(|u| u.to_f64())
}

/// Doubles cannot tell close roots apart, nor show huge and tiny ones beside each other.
fn well_apart(points: &[Sample<3>]) -> bool {
    let spread = points.iter().map(|p| p.r.abs()).fold(0.0, f64::max);
    points.windows(2).all(|p| p[0].r - p[1].r > 0.02 * spread)
        && points.iter().all(|p| p.r.abs() > 0.02 * spread)
}

/// The branches that are real in a direction are the certified roots there: as many, of the same signs, exactly; and of the
/// same values where doubles can tell.
fn check(
    f: &SpacePolynomial,
    surface: &SurfaceParametrization,
    direction: &SpaceDirection,
) -> Result<(), TestCaseError> {
    let Some(points) = points(f, direction) else {
        return Ok(());
    };
    let answer = surface.in_direction(direction).branches;
    prop_assert_eq!(answer.len(), surface.branches.len());
    let signs = |sign: i8| answer.iter().filter(|s| **s == Some(sign)).count();
    let positive = points.iter().filter(|p| p.r > 0.0).count();
    prop_assert_eq!(signs(1), positive);
    prop_assert_eq!(signs(-1), points.len() - positive);
    if !well_apart(&points) {
        return Ok(());
    }
    let at = floats(direction);
    let real = surface.branches.iter().zip(&answer);
    let real = real.filter(|(_, sign)| sign.is_some_and(|s| s != 0));
    let mut values: Vec<f64> = real.map(|(b, _)| b.radius.approximate(at)).collect();
    values.sort_by(|a, b| b.total_cmp(a));
    let spread = points.iter().map(|p| p.r.abs()).fold(0.0, f64::max);
    for (value, point) in values.iter().zip(&points) {
        prop_assert!((value - point.r).abs() <= 1e-4 * spread);
    }
    Ok(())
}

/// All monomials of degree at most d.
fn dense(degree: u32) -> impl Strategy<Value = SparsePolynomial<3>> {
    let all: Vec<[u32; 3]> = (0..=degree)
        .flat_map(|i| {
            (0..=degree - i).flat_map(move |j| (0..=degree - i - j).map(move |k| [i, j, k]))
        })
        .collect();
    prop::collection::vec(-9i64..10, all.len()).prop_map(move |c| {
        let c = c.into_iter().map(Rational::from);
        SparsePolynomial::from_terms(all.iter().copied().zip(c))
    })
}

proptest! {
    // A fixed seed: closed forms are compared in doubles, whose errors have no bound here.
    #![proptest_config(ProptestConfig {
        cases: 8,
        rng_seed: RngSeed::Fixed(11),
        ..ProptestConfig::default()
    })]

    /// Random dense quadrics (Lemma 8), cubics (Lemma 9) and quartics (Lemma 10), 100 directions each.
    #[test]
    fn closed_forms_are_the_certified_roots(quadric in dense(2), cubic in dense(3), quartic in dense(4)) {
        for (n, f) in [quadric, cubic, quartic].into_iter().enumerate() {
            let surface = spherical(&f);
            if surface.factors.len() == 1 && surface.factors[0].polynomial.homogeneous_degrees().len() == n + 3 {
                prop_assert_eq!(surface.method, SurfaceMethod::Lemma(n + 8));
            }
            let f = SpacePolynomial::from(&f);
            for direction in SpaceDirection::fibonacci(100) {
                check(&f, &surface, &direction)?;
            }
        }
    }
}

/// Lemmas in R^k, factors, cones, surfaces of revolution: the branches are the certified roots.
#[test]
fn spaced_degrees_and_factors() {
    for (text, method) in [
        ("x^2/4 + y^2/9 + z^2 - 1", SurfaceMethod::Lemma(7)),
        ("x^4 + y^4 + z^4 - 1", SurfaceMethod::Lemma(7)),
        ("x^3 - y^2*z + z^3 - 5", SurfaceMethod::Lemma(7)),
        ("(x^2+y^2+z^2+3)^2 - 16*(x^2+y^2)", SurfaceMethod::Lemma(8)),
        ("x^6 + y^6 + z^6 + x^3 - x*y*z - 1", SurfaceMethod::Lemma(8)),
        ("x^9 - y^6 + y^5*z + z^3 - 2", SurfaceMethod::Lemma(9)),
        (
            "x^8 + y^8 + z^8 - 3*x^6 + y^2*z^4 - x^4 + y^4 + 2*z^2 - 1",
            SurfaceMethod::Lemma(10),
        ),
        (
            "(x^2+y^2+z^2-1)*(x^2+y^2-z^2)*(x+y-2)",
            SurfaceMethod::Factors,
        ),
        ("(x^2+y^2-z^2)*(x-y)", SurfaceMethod::Cones),
    ] {
        let f = space(text);
        let surface = spherical(&f);
        assert_eq!(surface.method, method, "{text}");
        let by_degree = SpacePolynomial::from(&f);
        for direction in SpaceDirection::fibonacci(60) {
            check(&by_degree, &surface, &direction).unwrap();
        }
    }
}

/// The surfaces that the sampling must get right: as many points as Sturm's theorem counts, in every direction.
#[test]
fn sampled_counts_are_sturms() {
    for text in [
        // A sphere off center, an ellipsoid, a torus about a point inside its tube and about its center
        "x^2 + y^2 + z^2 - 2x - 2y - 2z + 2",
        "x^2/4 + y^2/9 + z^2 - 1",
        "((x+2)^2 + y^2 + z^2 + 3)^2 - 16*((x+2)^2 + y^2)",
        "(x^2+y^2+z^2+3)^2 - 16*(x^2+y^2)",
        // Clebsch's and Cayley's cubics
        "x^3 + y^3 + z^3 + 1 - (x+y+z+1)^3",
        "4*(x^2+y^2+z^2) + 16*x*y*z - 1",
        // Two of Goursat's quartics
        "x^4 + y^4 + z^4 - 5*(x^2+y^2+z^2) + 11.8",
        "x^4 + y^4 + z^4 - (x^2+y^2+z^2)^2/2 - 1",
        // The heart (degree 6, no closed form), and a rounded cube
        "(x^2 + 9/4*y^2 + z^2 - 1)^3 - x^2*z^3 - 9/80*y^2*z^3",
        "x^4 + y^4 + z^4 - 1",
    ] {
        let f = space(text);
        let by_degree = SpacePolynomial::from(&f);
        let grid = SpaceDirection::grid(8, 6).into_iter();
        for direction in grid.chain(SpaceDirection::fibonacci(60)) {
            let found = points(&by_degree, &direction);
            let expected = count_along(&f, &direction.components());
            assert_eq!(found.as_ref().map(Vec::len), expected, "{text}");
            for point in found.into_iter().flatten() {
                // r, x, y and z are rounded from one exact point.
                let [x, y, z] = point.position;
                let r = x.hypot(y).hypot(z);
                assert!((r - point.r.abs()).abs() <= 4e-16 * r, "{text}");
            }
        }
    }
}

/// On a meridian the exact ranges of φ say the same as the certified roots in its directions.
#[test]
fn ranges_on_a_meridian_are_those_of_the_roots() {
    for (text, degrees) in [
        ("x^2 + y^2 + z^2 - 2x - 2y - 2z + 2", 37),
        ("x^3 + y^3 + z^3 + 1 - (x+y+z+1)^3", 37),
        ("x^3 + 2*y^3 - z^3 + x*y - z^2 + 3*x - y + 1", 37),
        ("x^4 + y^4 + z^4 - x*y*z + 2*x^2 - y - 1", 37),
        ("(x^2 + 9/4*y^2 + z^2 - 1)^3 - x^2*z^3 - 9/80*y^2*z^3", 37),
        // The first part is 0 on the meridian.
        ("27*x*y^2 + x*z + x + y - 1", 90),
        ("x*z + y - 1", 90),
        ("x*z^2 + 12*y^2 + 6*y*z + y + 2*z - 1", 90),
        ("4*x^3 + 8*x^2*z + x - 3*y^2 - z + 4", 90),
        (
            "-3*x^3*y - 2*x - 2*y^2*z - y^2 - 4*y*z^2 - 6*y*z - 3*y - 9*z^2 - z + 4",
            0,
        ),
        (
            "-4*x^3*y^3*z^2 + 4*x*y^2*z + 2*x*y + 2*x*z^3 - 6*y^2*z^4 - 2*y*z^3 + 4",
            0,
        ),
    ] {
        let f = space(text);
        let (surface, by_degree) = (spherical(&f), SpacePolynomial::from(&f));
        let theta = Direction::from_degrees(&Rational::from(degrees));
        let branches = surface.on_meridian(&theta, &Limits::none()).unwrap();
        for k in 1..60 {
            let phi = Direction::from_degrees(&Rational::from(3 * k + 1));
            let nominal = phi.theta();
            let direction = SpaceDirection::new(theta.clone(), phi);
            let points = points(&by_degree, &direction).unwrap();
            let [mut real, mut positive] = [0, 0];
            for branch in &branches {
                let inside = |ranges: &[stellate::parametrize::AngleRange]| {
                    ranges.iter().any(|range| {
                        let end = |a: &stellate::parametrize::ExactAngle| {
                            a.to_decimal(12).parse::<f64>().unwrap()
                        };
                        end(&range.from) < nominal && nominal < end(&range.to)
                    })
                };
                real += usize::from(inside(&branch.real));
                positive += usize::from(inside(&branch.positive));
            }
            assert_eq!(real, points.len(), "{text} at {nominal}");
            let expected = points.iter().filter(|p| p.r > 0.0).count();
            assert_eq!(positive, expected, "{text} at {nominal}");
        }
    }
}

/// A closed form in doubles loses digits where its terms cancel, but not more than this.
const CLOSE: f64 = 1e-4;

/// How far a value is from being a root of Σ c_k r^k (ascending), relative to the size of the terms.
fn residual(c: &[f64], r: Complex<f64>) -> f64 {
    let (mut value, mut size, mut power) = (Complex::new(0.0, 0.0), 0.0, Complex::new(1.0, 0.0));
    for &c in c {
        value += power * c;
        size += (power * c).norm();
        power *= r;
    }
    value.norm() / size
}

/// s, p, q, u(, v) of a surface in a direction: the values of its homogeneous parts, by descending degree.
fn coefficients(f: &SparsePolynomial<3>, direction: &SpaceDirection) -> Vec<f64> {
    let at = direction.components();
    let degrees = SpacePolynomial::from(f).homogeneous_degrees();
    let values = degrees.into_iter().map(|degree| {
        let part = f
            .terms()
            .filter(|(e, _)| e.iter().sum::<u32>() as usize == degree);
        let part = SparsePolynomial::from_terms(part.map(|(e, c)| (*e, c.clone())));
        part.evaluate(&at).to_f64()
    });
    values.collect()
}

fn cube_root(z: Complex<f64>) -> Complex<f64> {
    z.powf(1.0 / 3.0)
}

/// Lemma 9 as printed has the roots A + B, … without the shift −p/(3s) (the erratum of Lemma 4). Lemma 10 as printed has
/// (pu/s² − 4v), √(p/(4s) − q/s + l), and R/2 twice (the errata of Lemma 5). In every direction where the mended
/// formulas give roots, the printed ones do not.
#[test]
fn mended_lemmas_9_and_10_against_the_printed_ones() {
    let cubic = space("x^3 + 2*y^3 - z^3 + x*y*z + x^2 + 3*y^2 - x*z + 5*z^2 + 3*x - y + 2*z + 7");
    let quartic = space(
        "2*x^4 + y^4 + 3*z^4 + x*y*z^2 + x^3 - y^2*z + 2*z^3 - 5*x^2 - 7*y^2 - 6*z^2 + x*y + x - 2*y + z - 4",
    );
    for f in [&cubic, &quartic] {
        let surface = spherical(f);
        let [mut mended, mut printed] = [0, 0];
        for direction in SpaceDirection::fibonacci(100) {
            let descending = coefficients(f, &direction);
            let ascending: Vec<f64> = descending.iter().rev().copied().collect();
            let at = floats(&direction);
            let answer = surface.in_direction(&direction).branches;
            let real = surface.branches.iter().zip(answer);
            let real = real.filter(|(_, sign)| sign.is_some());
            for (branch, _) in real {
                let r = branch.radius.approximate(at);
                let error = residual(&ascending, r.into());
                assert!(error < CLOSE, "{r}: {error}");
                mended += 1;
            }
            for r in printed_roots(&descending) {
                printed += usize::from(residual(&ascending, r) < CLOSE);
            }
        }
        assert!(mended >= 100, "{mended}");
        assert_eq!(printed, 0, "none of the printed values is a root");
    }
}

/// Eqs. of Lemmas 9 and 10 exactly as printed, in complex doubles.
fn printed_roots(c: &[f64]) -> Vec<Complex<f64>> {
    let real = |x: f64| Complex::new(x, 0.0);
    match *c {
        [s, p, q, u] => {
            let a = (3.0 * q / s - (p / s).powi(2)) / 3.0;
            let b = (2.0 * (p / s).powi(3) - 9.0 * p * q / (s * s) + 27.0 * u / s) / 27.0;
            let root = real(b * b / 4.0 + a.powi(3) / 27.0).sqrt();
            let [x, y] = [1.0, -1.0].map(|sign| cube_root(real(-b / 2.0) + root * sign));
            let i3 = Complex::new(0.0, 3f64.sqrt());
            let half = -(x + y) / 2.0;
            vec![x + y, half + (x - y) * i3 / 2.0, half - (x - y) * i3 / 2.0]
        }
        [s, p, q, u, v] => {
            let (p, q, u, v) = (p / s, q / s, u / s, v / s);
            // l³ − q l² + (pu − 4v as printed: not divided by s) l − p²v + 4qv − u²
            let (c2, c1, c0) = (-q, p * u - 4.0 * v * s, -p * p * v + 4.0 * q * v - u * u);
            let mut l = real(1.0 + c2.abs() + c1.abs() + c0.abs());
            for _ in 0..200 {
                let value = ((l + c2) * l + c1) * l + c0;
                let slope = (l * 3.0 + 2.0 * c2) * l + c1;
                l -= value / slope;
            }
            let r = (l + real(p / 4.0 - q)).sqrt();
            let common = real(3.0 * p * p / 4.0 - 2.0 * q) - r * r;
            let rest = real(4.0 * p * q - 8.0 * u - p.powi(3)) / (r * 4.0);
            let (d, e) = ((common + rest).sqrt(), (common - rest).sqrt());
            let start = r / 2.0 - real(p / 4.0);
            vec![
                start + d / 2.0,
                start - d / 2.0,
                start + e / 2.0,
                start - e / 2.0,
            ]
        }
        _ => Vec::new(),
    }
}
