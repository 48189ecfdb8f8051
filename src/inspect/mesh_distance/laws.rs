//! Distances of meshes and surfaces with known answers, and against samples.

use super::*;
use crate::exact::Rational;
use crate::fit::{cube_of_test as cube, solid_of_test as solid_of};
use proptest::prelude::*;

fn surface(terms: &[((usize, isize), f64)], center: [f64; 3]) -> HarmonicSurface {
    let exact = |x: f64| Rational::try_from(x).unwrap();
    let terms = terms.iter().map(|&(lm, c)| (lm, exact(c)));
    let surface = HarmonicSurface::new(terms).unwrap();
    surface.with_center(center.map(exact))
}

fn are_near([low, high]: [f64; 2]) -> bool {
    high - low <= f64::max(RELATIVE * low, ABSOLUTE) * 1.1
}

fn radius_towards(terms: &[((usize, isize), f64)], theta: f64, phi: f64) -> f64 {
    let (c, s) = (phi.cos(), phi.sin());
    // Unnormalized harmonics without the Condon–Shortley phase: P₁ = c, P₁₁ = s, P₂ = (3c² − 1)/2, P₂₁ = 3cs, P₂₂ = 3s².
    let value = |(l, m): (usize, isize)| match (l, m) {
        (0, 0) => 1.0,
        (1, 0) => c,
        (1, 1) => s * theta.cos(),
        (2, 0) => (3.0 * c * c - 1.0) / 2.0,
        (2, -1) => 3.0 * c * s * theta.sin(),
        (2, 2) => 3.0 * s * s * (2.0 * theta).cos(),
        _ => unreachable!("the test has no other harmonics"),
    };
    terms.iter().map(|&(lm, k)| k * value(lm)).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    /// A cube and a sphere about its middle: the corners, the middles of the faces, and the points of the sphere towards a corner and towards
    /// the middle of a face are the farthest ones.
    #[test]
    fn cubes_and_spheres(r in 0.3f64..3.0, shift in [-9.0f64..9.0, -9.0..9.0, -9.0..9.0], size in -60i32..60) {
        // The cube must be exact after it was moved.
        let shift = shift.map(|x| (x * 1024.0).round() / 1024.0);
        let scale = f64::from(size).exp2();
        let moved = cube(shift);
        let vertices = moved.vertices().iter().map(|v| v.map(|x| x * scale)).collect();
        let solid = Solid::new(vertices, moved.triangles().to_vec(), "cube").unwrap();
        let sphere = surface(&[((0, 0), r * scale)], shift.map(|x| x * scale));
        let found = mesh_distance(&solid, &sphere, &Limits::none()).unwrap().unwrap();
        let bounds = [found.low / scale, found.high / scale];
        let root = 3.0f64.sqrt();
        let outside = (root - r).abs().max((1.0 - r).abs());
        let to_corner = if r < root { 1.0 - r / root } else { r - root };
        let exact = outside.max(to_corner);
        prop_assert!(bounds[0] <= exact * (1.0 + 1e-12) && exact <= bounds[1] * (1.0 + 1e-12), "{bounds:?} {exact}");
        prop_assert!(are_near(bounds), "{:?}", bounds);
    }

    /// Against samples of both surfaces.
    #[test]
    fn samples_are_within_the_bounds(
        a in [-0.3f64..0.3, -0.3..0.3, -0.1..0.1, -0.1..0.1],
        b in [-0.3f64..0.3, -0.3..0.3, -0.1..0.1, -0.1..0.1],
        shift in [-0.2f64..0.2, -0.2..0.2, -0.2..0.2],
        rows in 6usize..14,
    ) {
        let terms = |c: [f64; 4]| [((0, 0), 1.5), ((1, 0), c[0]), ((1, 1), c[1]), ((2, -1), c[2]), ((2, 2), c[3])];
        let solid = solid_of(&surface(&terms(a), shift), rows);
        let found = mesh_distance(&solid, &surface(&terms(b), [0.0; 3]), &Limits::none()).unwrap().unwrap();
        let angle = |k: u32, n: u32| std::f64::consts::PI * f64::from(k) / f64::from(n);
        let n = 60;
        let cloud: Vec<[f64; 3]> = (0..2 * n).flat_map(|i| (0..=n).map(move |k| (i, k))).map(|(i, k)| {
            let (theta, phi) = (angle(i, n), angle(k, n));
            let r = radius_towards(&terms(b), theta, phi);
            [r * phi.sin() * theta.cos(), r * phi.sin() * theta.sin(), r * phi.cos()]
        }).collect();
        let distance = |p: &[f64; 3], q: &[f64; 3]| (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>();
        let mesh: Vec<[f64; 3]> = (0..solid.triangles().len()).flat_map(|k| {
            let [a, b, c] = solid.corners(k);
            (0..=8).flat_map(move |i| (0..=8 - i).map(move |j| {
                let (s, t) = (f64::from(i) / 8.0, f64::from(j) / 8.0);
                [0, 1, 2].map(|x| a[x] + s * (b[x] - a[x]) + t * (c[x] - a[x]))
            }))
        }).collect();
        let far = |from: &[[f64; 3]], to: &[[f64; 3]]| from.iter().step_by(13).map(|p| {
            to.iter().map(|q| distance(p, q)).fold(f64::INFINITY, f64::min).sqrt()
        }).fold(0.0, f64::max);
        let sampled = far(&mesh, &cloud).max(far(&cloud, &mesh));
        // Samples of either surface are less than 0.1 apart.
        prop_assert!(sampled <= found.high + 0.1 && found.low <= sampled + 0.15, "{sampled} {found:?}");
        prop_assert!(are_near([found.low, found.high]), "{:?}", found);
    }
}

#[test]
fn a_fine_mesh_is_near() {
    let round = surface(&[((0, 0), 2.0), ((2, 2), 0.01)], [0.0; 3]);
    let bounds = [20, 40].map(|rows| {
        mesh_distance(&solid_of(&round, rows), &round, &Limits::none())
            .unwrap()
            .unwrap()
    });
    // Half the sides, a quarter of the distance.
    let ratio = bounds[0].low / bounds[1].high;
    assert!((3.5..4.5).contains(&ratio), "{bounds:?}");
}
