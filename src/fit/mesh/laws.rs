//! Fits to meshes of known surfaces, and meshes that are star-shaped about no point.

use super::*;
use crate::mesh::mesh_harmonic;
use crate::shape::HarmonicPair;
use proptest::prelude::*;

/// The mesh of a harmonic surface, with this number of rows of directions.
pub(crate) fn solid_of(surface: &HarmonicSurface, rows: usize) -> Solid {
    let mesh = mesh_harmonic(surface, rows, &Limits::none(), &|_| {}).unwrap();
    Solid::new(mesh.vertices.clone(), mesh.triangles.clone(), "mesh").unwrap()
}

/// The cube with the corners (±1, ±1, ±1), moved.
pub(crate) fn cube(shift: [f64; 3]) -> Solid {
    let vertices = (0..8)
        .map(|k| std::array::from_fn(|i| if k >> i & 1 == 1 { 1.0 } else { -1.0 } + shift[i]));
    let quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let triangles = quads
        .iter()
        .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]);
    Solid::new(vertices.collect(), triangles.collect(), "cube").unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]
    #[test]
    fn least_squares_find_the_surface(
        list in prop::collection::vec((1usize..5, 0usize..9, -9i64..10), 1..6),
        shift in [-5i64..5, -5i64..5, -5i64..5],
    ) {
        let terms = list.iter().map(|&(l, m, c)| {
            let m = (m % (2 * l + 1)) as isize - l as isize;
            let size: i64 = (1..=m.unsigned_abs()).map(|k| (l + k) as i64).product();
            ((l, m), Rational::from(c) / Rational::from(60 * size))
        });
        let center = shift.map(|x| Rational::from(x) / Rational::from(4));
        let surface = HarmonicSurface::new(terms.chain([((0, 0), Rational::from(3))])).unwrap();
        let surface = surface.with_center(center.clone());
        let solid = solid_of(&surface, 24);
        let options = MeshFitOptions::new(MeshFitSize::Degree(5))
            .center(CenterChoice::InSpace(center))
            .estimator(Estimator::LeastSquares);
        let found = fit_mesh(&solid, &options, &Limits::none()).unwrap();
        for l in 0..=surface.degree() {
            for m in -(l as isize)..=l as isize {
                let exact = surface.coefficient(l, m).to_f64();
                let near = found.surface.coefficient(l, m).to_f64();
                prop_assert!((exact - near).abs() < 1e-9, "({l}, {m}): {exact} {near}");
            }
        }
    }

    /// No direction has a larger error than the one that is stated.
    #[test]
    fn the_largest_error_is_the_largest(radii in prop::array::uniform6(0.5f64..2.0), degree in 0usize..3) {
        let axes = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
        let vertices = radii.iter().zip(axes).map(|(r, axis)| axis.map(|x| r * x));
        let triangles = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
        let solid = Solid::new(vertices.collect(), triangles.to_vec(), "octahedron").unwrap();
        let options = MeshFitOptions::new(MeshFitSize::Degree(degree))
            .center(CenterChoice::InSpace(std::array::from_fn(|_| Rational::zero())));
        let estimators = if degree < 2 { vec![Estimator::Quadrature, Estimator::LeastSquares] } else { vec![Estimator::Quadrature] };
        for estimator in estimators {
            let found = fit_mesh(&solid, &options.clone().estimator(estimator), &Limits::none()).unwrap();
            let pair = HarmonicPair::new(&found.surface);
            let mut rays = rays::Rays::new(&solid, [0.0; 3]);
            for k in 0..300i64 {
                // Rational unit vectors by stereographic projection.
                let [s, t] = [k % 17 - 8, k / 17 - 8].map(|x| Rational::from(x) / Rational::from(5));
                let square = &s * &s + &t * &t;
                let below = (Rational::one() + &square).recip().unwrap();
                let exact = [&s + &s, &t + &t, Rational::one() - square].map(|x| x * &below);
                let unit = exact.each_ref().map(Rational::to_f64);
                let error = (rays.radius(unit) - pair.value(&exact).to_f64()).abs();
                prop_assert!(error <= found.max_radial_error + 1e-12, "{error} {}", found.max_radial_error);
            }
        }
    }

    /// A cube is star-shaped exactly about its inner points.
    #[test]
    fn visibility_is_exact(p in [-12i64..13, -12i64..13, -12i64..13]) {
        let solid = cube([0.0; 3]);
        let point = p.map(|x| Rational::from(x) / Rational::from(9));
        let is_inside = p.iter().all(|x| x.abs() < 9);
        prop_assert_eq!(visible(&solid, &point).is_star_shaped(), is_inside);
    }
}

#[test]
fn quadrature_is_near_the_surface() {
    let terms = [
        ((0, 0), 3.into()),
        ((2, 1), "0.1".parse().unwrap()),
        ((3, -3), "0.01".parse().unwrap()),
    ];
    let surface = HarmonicSurface::new(terms).unwrap();
    let solid = solid_of(&surface, 70);
    let options = MeshFitOptions::new(MeshFitSize::Degree(4));
    let options = options.center(CenterChoice::InSpace([0.into(), 0.into(), 0.into()]));
    let found = fit_mesh(&solid, &options, &Limits::none()).unwrap();
    for (l, m, c) in surface.terms() {
        let near = found.surface.coefficient(l, m).to_f64();
        assert!((c.to_f64() - near).abs() < 3e-3, "({l}, {m}): {c} {near}");
    }
    assert!(found.max_radial_error < 1e-2);
    let options = MeshFitOptions {
        size: MeshFitSize::Tolerance(0.02),
        ..options
    };
    let least = fit_mesh(&solid, &options, &Limits::none()).unwrap();
    assert_eq!(least.surface.degree(), 3);
}

/// The largest error is between the samples: in the direction (−0.28808, −0.89712, 0.33494) it is 0.7896263, by another program.
#[test]
fn the_largest_error_may_be_between_the_samples() {
    let vertices = vec![
        [-0.29, 0.48, 0.0],
        [0.94, 1.52, 0.0],
        [-0.85, -1.38, 0.0],
        [0.94, -1.53, 0.0],
        [0.0, -0.7, 1.14],
        [0.0, 0.33, 0.53],
        [0.0, -0.45, -0.72],
        [0.0, 0.45, -0.73],
        [1.21, 0.0, -0.75],
        [1.2, 0.0, 0.74],
        [-0.56, 0.0, -0.35],
        [-0.97, 0.0, 0.6],
    ];
    let triangles = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    let solid = Solid::new(vertices, triangles, "icosahedron").unwrap();
    let options = MeshFitOptions::new(MeshFitSize::Degree(2)).estimator(Estimator::LeastSquares);
    let found = fit_mesh(&solid, &options, &Limits::none()).unwrap();
    assert!(
        (0.789_626_2..0.79).contains(&found.max_radial_error),
        "{}",
        found.max_radial_error
    );
}

#[test]
fn a_cube_is_fitted_about_its_centroid() {
    let found = fit_mesh(
        &cube([5.0, 0.0, 1.0]),
        &MeshFitOptions::new(MeshFitSize::Degree(2)),
        &Limits::none(),
    )
    .unwrap();
    let center = found.surface.center().each_ref().map(Rational::to_f64);
    assert!((center[0] - 5.0).abs() < 1e-12 && !found.is_moved);
}

/// A polygon in the plane of x and y, as a prism between z = 0 and z = 1.
fn prism(polygon: &[[f64; 2]], cut: &[[u32; 3]]) -> Solid {
    let n = u32::try_from(polygon.len()).unwrap();
    let at = |z: f64| polygon.iter().map(move |[x, y]| [*x, *y, z]);
    let vertices = at(0.0).chain(at(1.0)).collect();
    let walls = (0..n).flat_map(|i| {
        let j = (i + 1) % n;
        [[i, j, j + n], [i, j + n, i + n]]
    });
    let floor = cut.iter().map(|[a, b, c]| [*a, *c, *b]);
    let roof = cut.iter().map(|t| t.map(|v| v + n));
    Solid::new(vertices, walls.chain(floor).chain(roof).collect(), "prism").unwrap()
}

#[test]
fn a_mesh_without_kernel_is_proved_to_have_none() {
    // A U: from no point both arms are seen.
    let u = [
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 3.0],
        [2.0, 3.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.0, 3.0],
        [0.0, 3.0],
    ];
    let cut = [
        [0, 5, 6],
        [0, 6, 7],
        [0, 1, 5],
        [1, 4, 5],
        [1, 2, 4],
        [2, 3, 4],
    ];
    let solid = prism(&u, &cut);
    assert!(matches!(kernel(&solid), Kernel::Empty(_)));
    let error = fit_mesh(
        &solid,
        &MeshFitOptions::new(MeshFitSize::Degree(2)),
        &Limits::none(),
    )
    .unwrap_err();
    assert!(error.to_string().contains("not star-shaped"), "{error}");
}

#[test]
fn a_kernel_without_the_centroid_is_found() {
    // An L with long arms: the centroid is outside, and the corner sees everything.
    let l = [
        [0.0, 0.0],
        [9.0, 0.0],
        [9.0, 1.0],
        [1.0, 1.0],
        [1.0, 9.0],
        [0.0, 9.0],
    ];
    let cut = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]];
    let found = fit_mesh(
        &prism(&l, &cut),
        &MeshFitOptions::new(MeshFitSize::Degree(2)),
        &Limits::none(),
    )
    .unwrap();
    let [x, y, z] = found.surface.center().each_ref().map(Rational::to_f64);
    assert!(found.is_moved && [x, y, z].iter().all(|x| 0.0 < *x && *x < 1.0));
}

#[test]
fn a_mesh_that_crosses_itself_is_named() {
    // A prism over a pentagram goes around its middle twice.
    let star: Vec<[f64; 2]> = (0..5)
        .map(|k| {
            let (s, c) = (f64::from(k) * 0.8 * std::f64::consts::PI).sin_cos();
            [c, s]
        })
        .collect();
    let solid = prism(&star, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    let error = fit_mesh(
        &solid,
        &MeshFitOptions::new(MeshFitSize::Degree(2)),
        &Limits::none(),
    )
    .unwrap_err();
    assert!(error.to_string().contains("crosses itself"), "{error}");
}
