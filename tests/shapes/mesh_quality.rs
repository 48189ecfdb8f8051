//! The triangles of meshes: along the surface, few slivers, and no crossings.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use nalgebra::Vector3;
use proptest::prelude::*;
use stellate::limits::Limits;
use stellate::mesh::{Mesh, MeshOptions, mesh_bounds, mesh_surface};
use stellate::shape::ImplicitSurface;
use tempfile::tempdir;

use crate::common::forms::space;
use crate::common::program::{done_in, run_in};

fn meshed(text: &str, resolution: u32) -> Mesh {
    let surface = ImplicitSurface::new(space(text));
    let limits = Limits::none();
    let bounds = mesh_bounds(&surface, &limits).unwrap().unwrap().bounds;
    let options = MeshOptions::new(bounds).resolution(resolution);
    mesh_surface(&surface, &options, &limits, &|_| {}).unwrap()
}

/// The least cosine of the angles between a triangle and the surface at its corners, and the least area of a triangle in parts of
/// that of an equilateral one with the same sum of the squares of the sides.
fn worst(mesh: &Mesh) -> [f64; 2] {
    let mut worst = [1.0_f64; 2];
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| Vector3::from(mesh.vertices[v as usize]));
        let normal = (b - a).cross(&(c - a));
        let squares = (b - a).norm_squared() + (c - b).norm_squared() + (a - c).norm_squared();
        worst[1] = worst[1].min(normal.norm() * 2.0 * 3.0_f64.sqrt() / squares);
        for v in triangle {
            let at_corner = Vector3::from(mesh.normals[*v as usize]);
            worst[0] = worst[0].min(at_corner.dot(&normal) / normal.norm());
        }
    }
    worst
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    /// An ellipsoid in any position has no triangle that is turned over or bent away. A few needles may be left, whose short edges
    /// cannot be collapsed.
    #[test]
    fn triangles_lie_along_the_surface(
        [a, b, c] in prop::array::uniform3(1i64..10),
        [p, q, r] in prop::array::uniform3(-9i64..10),
        mixed in -2i64..3,
        level in 1i64..6,
        resolution in 8u32..40,
    ) {
        let text = format!(
            "{a}*(x-({p})/7)^2 + {b}*(y-({q})/7)^2 + {c}*(z-({r})/7)^2 + {mixed}*(x-({p})/7)*(y-({q})/7)/3 - {level}"
        );
        let mesh = meshed(&text, resolution);
        let topology = mesh.topology();
        prop_assert!(topology.is_watertight());
        prop_assert_eq!((topology.components, topology.euler_characteristic), (1, 2));
        let [cosine, _] = worst(&mesh);
        prop_assert!(cosine > 0.5, "{} at {}: {}", text, resolution, cosine);
    }
}

#[test]
fn bent_surfaces_have_no_turned_triangles() {
    for (text, resolution) in [
        ("x^4 + y^4 + z^4 - 5*(x^2+y^2+z^2) + 12", 64),
        ("x^10 + y^10 + z^10 - 1", 64),
        ("(x^2+y^2-1)^2 + z^2 - 1/10", 64),
        ("(x^2+y^2+z^2+3)^2 - 16*(x^2+y^2)", 20),
        ("x^4 + y^4 + z^4 - 1", 20),
    ] {
        let [cosine, shape] = worst(&meshed(text, resolution));
        assert!(cosine > 0.5 && shape > 0.05, "{text}: {cosine} {shape}");
    }
    // Where sheets cross, no two vertices are at the same place.
    for text in ["x^2*y^2 + y^2*z^2 + z^2*x^2 - x*y*z", "x^2 - y^2*z"] {
        let surface = ImplicitSurface::new(space(text));
        let options = MeshOptions::new([[-1.0, 1.0]; 3]).resolution(33);
        let mesh = mesh_surface(&surface, &options, &Limits::none(), &|_| {}).unwrap();
        assert_eq!(mesh.topology().flat_triangles, 0, "{text}");
    }
}

/// The program takes its own meshes: they do not cross themselves, and those of convex surfaces are star-shaped.
#[test]
fn a_fit_takes_the_meshes_of_convex_surfaces() {
    let folder = tempdir().unwrap();
    for (form, resolution) in [
        ("x^2 + y^2 + z^2 = 1", "12"),
        ("x^2 + y^2 + z^2 = 1", "10"),
        ("x^2/9 + y^2 + z^2/2 = 1", "64"),
        ("(x-1/7)^2 + (y-1/5)^2 + (z-1/3)^2 = 1", "64"),
        ("x^2 + 2*y^2 + 3*z^2 = 1", "14"),
        ("x^4 + y^4 + z^4 = 1", "20"),
    ] {
        let mesh = ["mesh", form, "--resolution", resolution, "-o", "m.obj"];
        done_in(folder.path(), &mesh, "");
        let fit = run_in(folder.path(), &["fit", "m.obj", "--degree", "2"], "");
        assert_eq!(fit.code, 0, "{form} at {resolution}: {}", fit.err);
    }
}
