//! Each mistake is found from the numbers that a program with it gives.

#![expect(clippy::cast_precision_loss, reason = "the numbers of tests are small")]

use super::*;
use crate::shape::HarmonicPair;
use proptest::prelude::*;

fn surface() -> HarmonicSurface {
    let mut seed = 1u64;
    let mut next = move || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as i64 % 1000 - 500
    };
    let mut terms = vec![((0, 0), Rational::from(10))];
    for l in 1..7usize {
        for m in -(l as isize)..=l as isize {
            let size: i64 = (1..=m.unsigned_abs()).map(|k| (l + k) as i64).product();
            terms.push(((l, m), Rational::from(next()) / Rational::from(1000 * size)));
        }
    }
    HarmonicSurface::new(terms).unwrap()
}

fn coefficients(surface: &HarmonicSurface) -> GivenHarmonics {
    let nearest = |c: &Rational| Rational::try_from(c.to_f64()).unwrap();
    surface
        .terms()
        .map(|(l, m, c)| ((l, m), nearest(c)))
        .collect()
}

/// Directions, and the radii of a program there.
fn radii(surface: &HarmonicSurface, count: usize) -> Vec<GivenSpaceRadius> {
    let values = SphericalValues::new(surface);
    (0..count)
        .map(|k| {
            let phi = (1.0 - (2.0 * k as f64 + 1.0) / count as f64).acos();
            let theta = (2.399_963_229_728_653 * k as f64) % std::f64::consts::TAU;
            let [t, p] = [theta, phi].map(|x| Rational::try_from(x).unwrap());
            let [low, _] = values.bounds(&t, &p, 100);
            GivenSpaceRadius {
                line: k + 1,
                theta,
                phi,
                r: low.to_f64(),
            }
        })
        .collect()
}

fn names(found: &Comparison) -> Vec<&str> {
    found.diagnoses.iter().map(|d| d.name.as_ref()).collect()
}

#[test]
fn right_numbers_pass() {
    let surface = surface();
    let reference = SphericalReference::new(&surface);
    let found = reference.check_coefficients(&coefficients(&surface));
    assert!(
        found.passes(None) && found.passes(Some(15)),
        "{:?}",
        names(&found)
    );
    let found = reference
        .check_radii(&radii(&surface, 60), &Limits::none())
        .unwrap();
    assert!(
        found.passes(None) && found.passes(Some(15)),
        "{:?}",
        names(&found)
    );
}

#[test]
fn mistakes_with_coefficients_are_named_from_coefficients_and_from_radii() {
    let surface = surface();
    let reference = SphericalReference::new(&surface);
    for mistaken in mistaken_surfaces(&surface) {
        let found = reference.check_coefficients(&coefficients(&mistaken.form));
        assert!(
            names(&found).contains(&mistaken.name.as_ref()),
            "{}: {:?}",
            mistaken.name,
            names(&found)
        );
        let found = reference
            .check_radii(&radii(&mistaken.form, 40), &Limits::none())
            .unwrap();
        assert!(
            names(&found).contains(&mistaken.name.as_ref()),
            "{}: {:?}",
            mistaken.name,
            names(&found)
        );
    }
    let scaled = HarmonicSurface::new(
        surface
            .terms()
            .map(|(l, m, c)| ((l, m), c * Rational::from(3))),
    )
    .unwrap();
    assert_eq!(
        names(&reference.check_coefficients(&coefficients(&scaled))),
        ["scale"]
    );
    let found = reference
        .check_radii(&radii(&scaled, 40), &Limits::none())
        .unwrap();
    assert_eq!(names(&found), ["scale"]);
}

#[test]
fn mistakes_with_angles_are_named() {
    let surface = surface();
    let reference = SphericalReference::new(&surface);
    let right = radii(&surface, 60);
    let turned = |change: &dyn Fn(f64, f64) -> [f64; 2]| -> Vec<GivenSpaceRadius> {
        let rows = right.iter().map(|given| {
            let [theta, phi] = change(given.theta, given.phi);
            GivenSpaceRadius {
                theta,
                phi,
                ..*given
            }
        });
        rows.collect()
    };
    let half = std::f64::consts::FRAC_PI_2;
    for (name, rows) in [
        (
            "degrees for radians",
            turned(&|t, p| [t.to_degrees(), p.to_degrees()]),
        ),
        ("theta and phi exchanged", turned(&|t, p| [p, t])),
        ("latitude for colatitude", turned(&|t, p| [t, half - p])),
        (
            "degrees for radians, latitude for colatitude",
            turned(&|t, p| [t.to_degrees(), (half - p).to_degrees()]),
        ),
    ] {
        let found = reference.check_radii(&rows, &Limits::none()).unwrap();
        assert_eq!(names(&found), [name]);
    }
}

#[test]
fn a_forgotten_center_is_named() {
    let center = ["0.5", "-1/4", "0.25"].map(|x| x.parse().unwrap());
    let surface = surface().with_center(center);
    let reference = SphericalReference::new(&surface);
    let mut rows = radii(&surface, 50);
    let moved = reference.without_center(&rows).unwrap();
    for (row, r) in rows.iter_mut().zip(moved) {
        row.r = r;
    }
    // The points are on the surface.
    let pair = HarmonicPair::new(&surface);
    assert_eq!(pair.degree(), 6);
    let found = reference.check_radii(&rows, &Limits::none()).unwrap();
    assert_eq!(names(&found), ["center forgotten"]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    #[test]
    fn missing_harmonics_are_named(l in 1usize..7, order in 0usize..7) {
        let surface = surface();
        let order = (order % (l + 1)) as isize;
        let left_out: Vec<(usize, isize)> = if order == 0 { vec![(l, 0)] } else { vec![(l, -order), (l, order)] };
        let left = without(&surface, &left_out).unwrap().form;
        let reference = SphericalReference::new(&surface);
        let name = format!("missing: ({l}, {order})");
        let found = reference.check_coefficients(&coefficients(&left));
        prop_assert_eq!(names(&found), [name.as_str()]);
        let found = reference.check_radii(&radii(&left, 200), &Limits::none()).unwrap();
        prop_assert_eq!(names(&found), [name.as_str()]);
    }
}

#[test]
fn degrees_that_are_cut_off_are_named() {
    let surface = surface();
    let left = HarmonicSurface::new(
        surface
            .terms()
            .filter(|(l, ..)| *l < 5)
            .map(|(l, m, c)| ((l, m), c.clone())),
    )
    .unwrap();
    let found = SphericalReference::new(&surface)
        .check_radii(&radii(&left, 200), &Limits::none())
        .unwrap();
    assert_eq!(names(&found), ["missing: degrees 5 to 6"]);
}

/// A number that is not finite is an error, with its line.
#[test]
fn numbers_must_be_finite() {
    let surface = HarmonicSurface::new([((0, 0), 2.into()), ((1, 0), 1.into())]).unwrap();
    let reference = SphericalReference::new(&surface);
    let right = GivenSpaceRadius {
        line: 1,
        theta: 0.0,
        phi: 0.0,
        r: 3.0,
    };
    for (wrong, name) in [
        (
            GivenSpaceRadius {
                line: 7,
                theta: f64::NAN,
                ..right
            },
            "theta is NaN",
        ),
        (
            GivenSpaceRadius {
                line: 7,
                phi: f64::INFINITY,
                ..right
            },
            "phi is inf",
        ),
        (
            GivenSpaceRadius {
                line: 7,
                r: f64::NAN,
                ..right
            },
            "r is NaN",
        ),
    ] {
        let refused = reference
            .check_radii(&[right, wrong], &Limits::none())
            .unwrap_err();
        assert!(
            refused.to_string().contains(&format!("line 7: {name}")),
            "{refused}"
        );
    }
}
