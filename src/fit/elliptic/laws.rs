//! The laws of elliptic series, on random outlines.

use std::f64::consts::TAU;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::FloorSqrt;
use proptest::prelude::*;

use super::*;
use crate::exact::{Rational, cosine_and_sine, pi};
use crate::fit::{FitModel, as_f64};

/// The number of bits of the slow computation.
const BITS: u32 = 400;

/// The coefficients of Kuhl and Giardina by their own formula, over edges, as rational numbers with errors far below 2^(−300).
fn slow(points: &[[i32; 2]], harmonics: usize) -> Vec<[Rational; 4]> {
    let n = points.len();
    let edge = |k: usize| {
        let (p, q) = (points[k], points[(k + 1) % n]);
        [0, 1].map(|i| i64::from(q[i]) - i64::from(p[i]))
    };
    let length = |k: usize| {
        let [x, y] = edge(k);
        let square = Integer::from(x * x + y * y) << (2 * u64::from(BITS));
        let root = Integer::from(square.unsigned_abs_ref().floor_sqrt());
        Rational::from_dyadic(root, -i64::from(BITS))
    };
    let lengths: Vec<Rational> = (0..n).map(length).collect();
    let total: Rational = lengths.iter().cloned().sum();
    let mut at = vec![Rational::zero()];
    for length in &lengths {
        let next = at[at.len() - 1].clone() + length;
        at.push(next);
    }
    let (pi, _) = pi(BITS);
    let two = Rational::from(2);
    let middle = [0, 1].map(|i| {
        let moments = (0..n).map(|k| {
            let sum = points[k][i] + points[(k + 1) % n][i];
            &lengths[k] * &Rational::from(sum) / &two
        });
        moments.sum::<Rational>() / &total
    });
    let [x, y] = middle;
    let mut found = vec![[x, Rational::zero(), y, Rational::zero()]];
    for m in 1..=harmonics {
        let m = Rational::from(m as i64);
        let wave = |k: usize| cosine_and_sine(&(&two * &pi * &m * &at[k] / &total), BITS);
        let waves: Vec<[Rational; 2]> = (0..=n).map(wave).collect();
        let factor = &total / &(&two * &m * &m * &pi * &pi);
        found.push(std::array::from_fn(|which| {
            let (axis, wave) = (which / 2, which % 2);
            let terms = (0..n).map(|k| {
                let slope = Rational::from(edge(k)[axis]) / &lengths[k];
                slope * (&waves[k + 1][wave] - &waves[k][wave])
            });
            terms.sum::<Rational>() * &factor
        }));
    }
    found
}

/// A star-shaped polygon with whole coordinates, in either sense.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the coordinates are at most 1000"
)]
fn polygon() -> impl Strategy<Value = Vec<[i32; 2]>> {
    (prop::collection::vec(10i32..1000, 3..12), any::<bool>()).prop_map(|(radii, is_reversed)| {
        let count = radii.len();
        let mut points: Vec<[i32; 2]> = radii
            .iter()
            .enumerate()
            .map(|(k, r)| {
                let angle = TAU * as_f64(k) / as_f64(count);
                [angle.cos(), angle.sin()].map(|c| (f64::from(*r) * c) as i32)
            })
            .collect();
        if is_reversed {
            points.reverse();
        }
        points
    })
}

fn contour(points: &[[i32; 2]]) -> Option<Contour> {
    let points = points.iter().map(|p| p.map(f64::from)).collect();
    Contour::new(points, "polygon").ok()
}

fn fitted(contour: &Contour, size: FitSize, decimals: Option<u32>) -> EllipticFit {
    let options = FitOptions::new(size)
        .model(FitModel::Elliptic)
        .decimals(decimals);
    fit_elliptic(contour, &options, &Limits::none()).unwrap()
}

fn check(points: &[[i32; 2]], decimals: Option<u32>) {
    const HARMONICS: usize = 5;
    let Some(contour) = contour(points) else {
        return;
    };
    let series = fitted(&contour, FitSize::Harmonics(HARMONICS), decimals).series;
    for (n, exact) in slow(points, HARMONICS).iter().enumerate() {
        for (list, value) in series.lists().iter().zip(exact) {
            let tiny = Rational::from_dyadic(Integer::from(1), -300);
            let expected = match decimals {
                _ if value.abs() < tiny => Rational::zero(),
                Some(digits) => value.round_decimals(digits),
                None => Rational::try_from(value.to_f64()).unwrap(),
            };
            let found = list.get(n).cloned().unwrap_or_else(Rational::zero);
            assert_eq!(found, expected, "harmonic {n} of {points:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn coefficients_are_correctly_rounded(points in polygon(), decimals in prop::option::of(0u32..30)) {
        check(&points, decimals);
    }
}

/// Many coefficients are exactly 0, and the middle is half-way between decimals.
#[test]
fn coefficients_of_symmetric_outlines_are_exact() {
    let square = [[0, 0], [5, 0], [5, 5], [0, 5]];
    let hexagon = [[2, 0], [1, 2], [-1, 2], [-2, 0], [-1, -2], [1, -2]];
    for decimals in [None, Some(0), Some(3)] {
        check(&square, decimals);
        check(&hexagon, decimals);
    }
}

/// Edges of very different lengths, far from the origin: the coefficients are those of the outline without its small notch, up
/// to the size of the notch.
#[test]
fn tiny_edges_and_large_offsets_lose_nothing() {
    let far = 2f64.powi(40);
    let size = |e: f64| {
        let notch = vec![
            [far, 0.0],
            [far + 1.0, 0.0],
            [far + 1.0, 1.0],
            [far, 1.0],
            [far, e],
        ];
        let contour = Contour::new(notch, "notch").unwrap();
        fitted(&contour, FitSize::Harmonics(3), None).series
    };
    let (with, without) = (size(1e-100), size(0.5));
    for (a, b) in with.lists().iter().zip(without.lists()) {
        for (a, b) in a.iter().zip(b) {
            assert_eq!(a, b);
        }
    }
    assert!((with.x_cos()[0].to_f64() - far - 0.5).abs() < 1e-4);
}

/// The share of the power does not depend on the size, also where its square is no double.
#[test]
fn powers_of_outlines_of_any_size() {
    let power = |size: f64| {
        let points = [[0.0, 0.0], [3.0, 0.0], [0.0, 1.0]]
            .map(|p| p.map(|c| c * size))
            .to_vec();
        let contour = Contour::new(points, "triangle").unwrap();
        fitted(&contour, FitSize::Harmonics(2), None).power
    };
    for size in [1e-119, 1e119] {
        assert!((power(size) - power(1.0)).abs() < 1e-12, "{size}");
    }
    assert!(power(1.0) > 0.9 && power(1.0) < 1.0);
}

/// Twice as large, the coefficients are twice as large, exactly; moved by a double that all coordinates can take, the middle
/// alone moves.
#[test]
fn sizes_and_places_are_exact() {
    let points = [[0, 0], [70, 3], [64, 40], [20, 31], [11, 60]];
    let plain = contour(&points).unwrap();
    let larger = contour(&points.map(|p| p.map(|c| 2 * c))).unwrap();
    let [plain, larger] = [plain, larger].map(|c| fitted(&c, FitSize::Harmonics(6), None).series);
    for (a, b) in plain
        .lists()
        .iter()
        .flatten()
        .zip(larger.lists().iter().flatten())
    {
        assert_eq!(a + a, *b);
    }
    let moved = contour(&points.map(|[x, y]| [x + 4096, y])).unwrap();
    let moved = fitted(&moved, FitSize::Harmonics(6), None).series;
    assert_eq!(moved.x_cos()[1..], plain.x_cos()[1..]);
    assert_eq!(moved.y_sin(), plain.y_sin());
}

#[test]
fn tolerances_and_powers_are_met_by_the_fewest_harmonics() {
    let u_shape = [
        [0, 0],
        [90, 0],
        [90, 80],
        [60, 80],
        [60, 30],
        [30, 30],
        [30, 80],
        [0, 80],
    ];
    let contour = contour(&u_shape).unwrap();
    let high = |n: usize| {
        let series = fitted(&contour, FitSize::Harmonics(n), None).series;
        let found = super::super::distances(&contour, &series, &Limits::none());
        found.unwrap().unwrap().hausdorff.high
    };
    for size in [FitSize::Tolerance(4.0), FitSize::Distance(4.0)] {
        let found = fitted(&contour, size, None).series.harmonics();
        assert!(high(found) <= 4.0 && found > 4);
        for fewer in 0..found {
            assert!(high(fewer) > 4.0, "{fewer}");
        }
    }
    let power = fitted(&contour, FitSize::Power(0.99), None);
    let n = power.series.harmonics();
    assert!(power.power >= 0.99);
    assert!(fitted(&contour, FitSize::Harmonics(n - 1), None).power < 0.99);
    // Rounded to tenths, the coefficients have other powers, but the harmonics have the same share.
    let rough = scaled(&u_shape);
    let [exact, rounded] = [None, Some(1)].map(|d| fitted(&rough, FitSize::Power(0.99), d));
    assert_eq!(rounded.series.harmonics(), exact.series.harmonics());
    assert!((rounded.power - exact.power).abs() < 1e-12 && exact.power < 1.0);
    // With no decimals the harmonics that are left do not have this share.
    let options = FitOptions::new(FitSize::Power(0.9999))
        .model(FitModel::Elliptic)
        .decimals(Some(0));
    let refused = fit_elliptic(&rough, &options, &Limits::none());
    assert!(matches!(refused, Err(Error::Limit { .. })), "{refused:?}");
}

/// The outline in units of 30, in which coefficients of one decimal are rough.
fn scaled(points: &[[i32; 2]]) -> Contour {
    let points: Vec<[i32; 2]> = points.iter().map(|p| p.map(|x| x / 30)).collect();
    contour(&points).unwrap()
}
