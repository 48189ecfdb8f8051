//! The laws of fits, on random outlines.

use std::f64::consts::TAU;

use proptest::prelude::*;

use super::*;

/// A closed outline around the origin with one vertex per angle.
fn around(radii: &[f64]) -> Vec<[f64; 2]> {
    radii
        .iter()
        .enumerate()
        .map(|(k, r)| {
            let angle = TAU * as_f64(k) / as_f64(radii.len());
            [r * angle.cos(), r * angle.sin()]
        })
        .collect()
}

/// Teeth of different heights on a bar.
fn comb(heights: &[f64]) -> Vec<[f64; 2]> {
    let mut points = vec![[0.0, -1.0], [2.0 * as_f64(heights.len()), -1.0]];
    for (k, height) in heights.iter().enumerate().rev() {
        let x = 2.0 * as_f64(k);
        points.extend([
            [x + 1.5, 0.0],
            [x + 1.5, *height],
            [x + 0.5, *height],
            [x + 0.5, 0.0],
        ]);
    }
    points
}

/// A thick spiral: it goes out along one arm and back along another arm beside it.
fn spiral(steps: usize, thickness: f64) -> Vec<[f64; 2]> {
    let arm = |shift: f64| {
        (0..steps).map(move |k| {
            let angle = as_f64(k) * 0.35;
            let r = 1.0 + angle / TAU + shift;
            [r * angle.cos(), r * angle.sin()]
        })
    };
    let mut points: Vec<[f64; 2]> = arm(thickness).collect();
    points.extend(arm(0.0).collect::<Vec<_>>().into_iter().rev());
    points
}

fn turned(points: &[[f64; 2]], angle: f64) -> Vec<[f64; 2]> {
    let (s, c) = angle.sin_cos();
    points
        .iter()
        .map(|p| [c * p[0] - s * p[1], s * p[0] + c * p[1]])
        .collect()
}

/// Star polygons, combs and spirals, turned by any angle.
fn outlines() -> impl Strategy<Value = Contour> {
    let any_shape = prop_oneof![
        prop::collection::vec(0.2f64..2.0, 3..40).prop_map(|radii| around(&radii)),
        prop::collection::vec(0.5f64..9.0, 2..9).prop_map(|heights| comb(&heights)),
        (5usize..90, 0.2f64..0.8).prop_map(|(steps, thickness)| spiral(steps, thickness)),
    ];
    (any_shape, prop_oneof![Just(0.0), 0.0..TAU])
        .prop_map(|(points, angle)| Contour::new(turned(&points, angle), "random").unwrap())
}

/// The distance from `c` to the last edge that the ray in the direction θ meets.
fn cast(contour: &Contour, c: [f64; 2], theta: f64) -> f64 {
    let (u, v) = (theta.cos(), theta.sin());
    contour
        .edges()
        .filter_map(|(p, q)| {
            let (px, py) = (p[0] - c[0], p[1] - c[1]);
            let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
            // The intersection of the lines: c + r (u, v) = p + t d.
            let determinant = u * dy - v * dx;
            let r = (px * dy - py * dx) / determinant;
            let t = (px * v - py * u) / determinant;
            ((-1e-12..=1.0 + 1e-12).contains(&t) && r > 0.0).then_some(r)
        })
        .fold(0.0, f64::max)
}

/// A point inside the contour, number `pick` of those of a grid.
fn some_interior_point(contour: &Contour, pick: usize) -> Option<[f64; 2]> {
    let [low, high] = contour.bounding_box();
    let inside: Vec<[f64; 2]> = (1..31)
        .flat_map(|i| (1..31).map(move |j| [as_f64(i) / 31.07, as_f64(j) / 30.93]))
        .map(|t| [0, 1].map(|k| low[k] + t[k] * (high[k] - low[k])))
        .filter(|&p| contour.contains(p))
        .collect();
    (!inside.is_empty()).then(|| inside[pick % inside.len()])
}

/// The radius |p(e^(iθ))|² for a polynomial p with these coefficients.
fn squared_size(p: &[i64]) -> FourierRadius {
    let products = |k: usize| p.iter().zip(&p[k..]).map(|(a, b)| a * b).sum::<i64>();
    let cos = (0..p.len()).map(|k| Rational::from(if k == 0 { 1 } else { 2 } * products(k)));
    FourierRadius::new(cos.collect(), Vec::new())
}

proptest! {
    /// A square of a size is not negative; a little more is positive, and the value at θ = 0 taken away leaves no positive radius.
    /// A radius that is 0 somewhere and positive elsewhere is not decided by values.
    #[test]
    fn signs_of_radii_are_decided_by_values(p in prop::collection::vec(-9i64..=9, 1..30), more in 1u32..12) {
        let by_values = |radius: &FourierRadius| is_positive_by_values(radius, &Limits::none()).unwrap();
        let plus = |radius: &FourierRadius, c: Rational| {
            let mut cos = radius.cosines().to_vec();
            cos[0] = &cos[0] + &c;
            FourierRadius::new(cos, radius.sines().to_vec())
        };
        let square = squared_size(&p);
        let little = Rational::from_dyadic(1.into(), -i64::from(more));
        let sum: i64 = p.iter().sum();
        let at_zero = Rational::from(sum * sum);
        prop_assert_ne!(by_values(&plus(&square, little.clone())), Some(false));
        prop_assert_eq!(by_values(&plus(&square, Rational::from(1))), Some(true));
        prop_assert_ne!(by_values(&plus(&square, -(&at_zero + &little))), Some(true));
        // p(z) (z − 1) is 0 at z = 1.
        let shifted = std::iter::once(&0).chain(&p);
        let touching: Vec<i64> = shifted.zip(p.iter().chain([&0])).map(|(a, b)| a - b).collect();
        prop_assert_eq!(by_values(&squared_size(&touching)), None);
    }
}

proptest! {
    #[test]
    fn the_radius_is_what_casting_every_ray_gives(
        contour in outlines(),
        pick in 0usize..900,
        angles in prop::collection::vec(0.0..TAU, 1..60),
    ) {
        contour.check_invariants();
        let Some(c) = some_interior_point(&contour, pick) else { return Ok(()) };
        let radius = ContourRadius::new(&contour, c).unwrap();
        for theta in angles {
            let expected = cast(&contour, c, theta);
            let found = radius.at(theta);
            prop_assert!(
                (found - expected).abs() <= 1e-7 * expected,
                "r({theta}) about {c:?} is {found}, a ray gives {expected}"
            );
        }
        for (k, sample) in radius.samples(37).into_iter().enumerate() {
            prop_assert!((sample - radius.at(TAU * (as_f64(k) / 37.0))).abs() <= 1e-12 * sample);
        }
        prop_assert_eq!(radius.is_star_shaped(), star_shaped_about(&contour, c));
        // The hidden share by its definition: the outline is followed, and each piece is tested whether it is outermost.
        let (mut hidden, mut all) = (0.0, 0.0);
        for (p, q) in contour.edges() {
            let parts = 50;
            let part = (q[0] - p[0]).hypot(q[1] - p[1]) / as_f64(parts);
            for k in 0..parts {
                let t = (as_f64(k) + 0.5) / as_f64(parts);
                let (x, y) = (p[0] + t * (q[0] - p[0]) - c[0], p[1] + t * (q[1] - p[1]) - c[1]);
                all += part;
                if x.hypot(y) < cast(&contour, c, y.atan2(x)) * (1.0 - 1e-9) {
                    hidden += part;
                }
            }
        }
        prop_assert!((radius.hidden_share() - hidden / all).abs() < 0.03);
    }

    #[test]
    fn a_chosen_center_is_inside_and_says_what_it_is(contour in outlines()) {
        let center = Center::choose(&contour, &CenterChoice::Auto, None).unwrap();
        prop_assert!(contour.contains(center.point));
        prop_assert_eq!(center.star_shaped, Some(star_shaped_about(&contour, center.point)));
        match center.origin {
            CenterOrigin::Kernel => prop_assert_eq!(center.star_shaped, Some(true)),
            CenterOrigin::ChordMiddle => prop_assert!(!contour.contains(contour.centroid())),
            _ => prop_assert!(center.point.partial_cmp(&contour.centroid()).is_some_and(|o| o.is_eq())),
        }
    }

    #[test]
    fn turning_the_outline_turns_the_coefficients(
        radii in prop::collection::vec(0.5f64..2.0, 3..30),
        steps in 0usize..64,
    ) {
        let turn = TAU * as_f64(steps) / 64.0;
        let options = FitOptions {
            center: CenterChoice::Point([0.into(), 0.into()]),
            samples: Some(64),
            size: Some(FitSize::Harmonics(8)),
            ..FitOptions::default()
        };
        let points = around(&radii);
        let contour = Contour::new(points.clone(), "star").unwrap();
        prop_assume!(contour.contains([0.0, 0.0]));
        let plain = fit(&contour, &options).unwrap().radius;
        let turned = Contour::new(turned(&points, turn), "star").unwrap();
        let turned = fit(&turned, &options).unwrap().radius;
        for n in 0..=8 {
            let (a, b) = pair(&plain, n);
            let (s, c) = (as_f64(n) * turn).sin_cos();
            let (turned_a, turned_b) = pair(&turned, n);
            prop_assert!((a * c - b * s - turned_a).abs() < 1e-12);
            prop_assert!((a * s + b * c - turned_b).abs() < 1e-12);
        }
    }

    #[test]
    fn scaling_the_outline_scales_the_coefficients(contour in outlines(), power in -30i32..30) {
        let scale = 2f64.powi(power);
        let scaled = contour.points().iter().map(|p| p.map(|c| c * scale)).collect();
        let scaled = Contour::new(scaled, "scaled").unwrap();
        let options = FitOptions::new(FitSize::Harmonics(5));
        let (plain, scaled) = (fit(&contour, &options).unwrap(), fit(&scaled, &options).unwrap());
        // A power of two scales every double without rounding.
        let factor = Rational::try_from(scale).unwrap();
        for n in 0..=plain.radius.harmonics() {
            prop_assert_eq!(&(plain.radius.cos(n) * &factor), scaled.radius.cos(n));
            prop_assert_eq!(&(plain.radius.sin(n) * &factor), scaled.radius.sin(n));
        }
        prop_assert!((plain.max_radial_error * scale / scaled.max_radial_error - 1.0).abs() < 1e-9);
        prop_assert!(plain.rms_radial_error <= plain.max_radial_error);
    }

    #[test]
    fn a_sampled_fourier_radius_is_recovered_within_the_sagitta(
        pairs in prop::collection::vec((-0.05f64..0.05, -0.05f64..0.05), 1..7),
    ) {
        let vertices = 720;
        let radii: Vec<f64> = (0..vertices)
            .map(|k| {
                let theta = TAU * as_f64(k) / as_f64(vertices);
                pairs.iter().enumerate().fold(1.0, |r, (n, (a, b))| {
                    let angle = as_f64(n + 1) * theta;
                    r + a * angle.cos() + b * angle.sin()
                })
            })
            .collect();
        let contour = Contour::new(around(&radii), "series").unwrap();
        let options = FitOptions {
            center: CenterChoice::Point([0.into(), 0.into()]),
            ..FitOptions::new(FitSize::Harmonics(pairs.len()))
        };
        let fit = fit(&contour, &options).unwrap();
        // A chord is nearer to the center than its arc by at most (2 r'² + r² + r |r''|) δ²/8 / r.
        let bound = 10.0 * (TAU / as_f64(vertices)).powi(2);
        let (a0, _) = pair(&fit.radius, 0);
        prop_assert!((a0 - 1.0).abs() < bound);
        for (n, (a, b)) in pairs.iter().enumerate() {
            let (fitted_a, fitted_b) = pair(&fit.radius, n + 1);
            prop_assert!((a - fitted_a).abs() < bound && (b - fitted_b).abs() < bound);
        }
        prop_assert!(fit.max_radial_error < 2.0 * bound * as_f64(pairs.len() + 1));
    }

    #[test]
    fn a_tolerance_is_met_by_the_fewest_harmonics(
        radii in prop::collection::vec(0.8f64..1.2, 5..20),
        tolerance in 0.01f64..0.3,
        decimals in prop::option::of(1u32..4),
    ) {
        let contour = Contour::new(around(&radii), "star").unwrap();
        let options = FitOptions {
            center: CenterChoice::Auto,
            samples: Some(512),
            size: Some(FitSize::Tolerance(tolerance)),
            decimals,
            ..FitOptions::default()
        };
        let Ok(fitted) = fit(&contour, &options) else {
            // With coarse rounding it may happen that no number of harmonics meets the tolerance.
            prop_assert!(decimals.is_some());
            return Ok(());
        };
        prop_assert!(fitted.max_radial_error <= tolerance);
        for n in 0..fitted.radius.harmonics() {
            let size = FitSize::Harmonics(n);
            let fewer = fit(&contour, &FitOptions { size: Some(size), ..options.clone() }).unwrap();
            prop_assert!(fewer.max_radial_error > tolerance, "{n} harmonics would do");
        }
        let size = FitSize::Harmonics(fitted.radius.harmonics());
        let same = fit(&contour, &FitOptions { size: Some(size), ..options }).unwrap();
        prop_assert_eq!(same.radius, fitted.radius);
        prop_assert!((same.max_radial_error - fitted.max_radial_error).abs() < 1e-12);
    }
}

fn pair(radius: &FourierRadius, n: usize) -> (f64, f64) {
    if n <= radius.harmonics() {
        (radius.cos(n).to_f64(), radius.sin(n).to_f64())
    } else {
        (0.0, 0.0)
    }
}

fn square() -> Contour {
    Contour::new(around(&[1.0; 4]), "square").unwrap()
}

#[test]
fn decimals_round_the_center_and_the_coefficients() {
    let points = around(&[1.0, 1.3, 0.9, 1.1, 1.2])
        .iter()
        .map(|p| [p[0] + 0.123_456, p[1] - 7.0])
        .collect();
    let contour = Contour::new(points, "star").unwrap();
    let options = FitOptions {
        decimals: Some(3),
        ..FitOptions::new(FitSize::Harmonics(4))
    };
    let radius = fit(&contour, &options).unwrap().radius;
    let thousandths = |q: &Rational| (q * &Rational::from(1000)).is_integer();
    assert!(radius.center().iter().all(thousandths));
    assert!(radius.cosines().iter().all(thousandths));
    assert!(radius.sines().iter().all(thousandths));
    // The residual belongs to the rounded coefficients, so coarser rounding makes it larger.
    let error = |decimals| {
        let options = FitOptions {
            decimals,
            ..options.clone()
        };
        fit(&contour, &options).unwrap().max_radial_error
    };
    assert!(error(Some(1)) > error(None));
}

#[test]
fn options_that_cannot_be_are_refused() {
    let refuse = |options: FitOptions| fit(&square(), &options).unwrap_err();
    let with_samples = |n, samples| FitOptions {
        samples: Some(samples),
        ..FitOptions::new(FitSize::Harmonics(n))
    };
    assert_eq!(
        refuse(with_samples(600, 1000)).to_string(),
        "N = 600 harmonics need at least 1201 samples; there are 1000"
    );
    for e in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = refuse(FitOptions::new(FitSize::Tolerance(e)));
        assert!(matches!(error, Error::Usage(_)), "{error}");
    }
    for options in [
        FitOptions::new(FitSize::Harmonics(MAX_HARMONICS + 1)),
        FitOptions::new(FitSize::Harmonics(usize::MAX)),
        with_samples(1, MAX_SAMPLES + 1),
        FitOptions {
            decimals: Some(u32::MAX),
            ..FitOptions::new(FitSize::Harmonics(1))
        },
    ] {
        let error = refuse(options);
        assert!(matches!(error, Error::Limit { .. }), "{error}");
    }
}

#[test]
fn a_tolerance_out_of_reach_says_how_far_it_got() {
    let options = FitOptions {
        samples: Some(33),
        ..FitOptions::new(FitSize::Tolerance(1e-6))
    };
    let message = fit(&square(), &options).unwrap_err().to_string();
    assert!(
        message.starts_with(
            "limit reached: no number of harmonics up to 16 has a radial error of at most 0.000001"
        ),
        "{message}"
    );
    assert!(message.contains("--samples"), "{message}");
}

#[test]
fn a_jump_puts_small_tolerances_out_of_reach() {
    let contour = Contour::new(comb(&[3.0, 5.0, 4.0]), "comb").unwrap();
    let options = FitOptions::new(FitSize::Tolerance(0.1));
    let message = fit(&contour, &options).unwrap_err().to_string();
    assert!(message.contains("r jumps by"), "{message}");
    let fitted = fit(&contour, &FitOptions::new(FitSize::Harmonics(20))).unwrap();
    let seen = fitted.outline.unwrap();
    assert!(!seen.star_shaped && seen.hidden_share > 0.1);
}

#[test]
fn no_harmonics_give_the_mean_radius() {
    let options = FitOptions {
        samples: Some(1),
        ..FitOptions::new(FitSize::Harmonics(0))
    };
    let fitted = fit(&square(), &options).unwrap();
    assert_eq!((fitted.radius.harmonics(), fitted.samples), (0, 1));
    assert!((fitted.radius.cos(0).to_f64() - 1.0).abs() < 1e-15);
}
