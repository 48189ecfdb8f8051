//! Meshes: watertight where the surface is closed, all sheets, certified vertices, files that other readers read.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::HashMap;
use std::path::Path;

use crate::common::forms::space;
use crate::common::program::run_in;
use proptest::prelude::*;
use stellate::document::mesh_text;
use stellate::exact::{Dyadic, Rational};
use stellate::language::Numbers;
use stellate::limits::Limits;
use stellate::mesh::{Held, Mesh, MeshOptions, mesh_bounds, mesh_surface};
use stellate::poly::SparsePolynomial;
use stellate::shape::ImplicitSurface;
use stellate::verb::{self, Given, MeshingOptions, Work};
use tempfile::tempdir;

fn meshed(text: &str, bounds: Option<[[f64; 2]; 3]>, resolution: u32) -> Mesh {
    let surface = ImplicitSurface::new(space(text));
    let limits = Limits::none();
    let bounds = bounds.unwrap_or_else(|| mesh_bounds(&surface, &limits).unwrap().unwrap().bounds);
    let options = MeshOptions::new(bounds).resolution(resolution);
    mesh_surface(&surface, &options, &limits, &|_| {}).unwrap()
}

fn exact(p: [f64; 3]) -> [Rational; 3] {
    p.map(|x| Dyadic::from_f64(x).unwrap().to_rational())
}

/// The volume that a closed mesh encloses, by cones from a point.
pub(crate) fn volume(mesh: &Mesh, from: [f64; 3]) -> f64 {
    let from = nalgebra::Vector3::from(from);
    let corner = |v: u32| nalgebra::Vector3::from(mesh.vertices[v as usize]) - from;
    let cones = mesh.triangles.iter().map(|t| {
        let [a, b, c] = t.map(corner);
        a.dot(&b.cross(&c)) / 6.0
    });
    cones.sum()
}

/// Closed surfaces with the right number of pieces and holes.
#[test]
fn closed_surfaces_are_watertight() {
    for (text, pieces, euler) in [
        ("x^2 + y^2 + z^2 - 2x - 2y - 2z + 2", 1, 2),
        ("x^2/4 + y^2/9 + z^2 - 1", 1, 2),
        ("(x^2+y^2+z^2+3)^2 - 16*(x^2+y^2)", 1, 0),
        ("((x+2)^2 + y^2 + z^2 + 3)^2 - 16*((x+2)^2 + y^2)", 1, 0),
        ("x^4 + y^4 + z^4 - 1", 1, 2),
        ("(x^2 + 9/4*y^2 + z^2 - 1)^3 - x^2*z^3 - 9/80*y^2*z^3", 1, 2),
        // Goursat's tangle cube has genus 5.
        ("x^4 + y^4 + z^4 - 5*(x^2+y^2+z^2) + 11.8", 1, -8),
        // A double sphere, and a second one inside it
        ("(x^2+y^2+z^2-1)^2*(x^2+y^2+z^2-4)", 2, 4),
    ] {
        let mesh = meshed(text, None, 32);
        let topology = mesh.topology();
        assert!(topology.is_watertight(), "{text}: {topology:?}");
        assert_eq!(topology.components, pieces, "{text}");
        assert_eq!(topology.euler_characteristic, euler, "{text}");
        assert!(mesh.vertex_bound < 1e-8, "{text}");
    }
}

/// The volumes of closed meshes are those of the bodies, with the right sign.
#[test]
fn volumes_are_right_and_positive() {
    let pi = std::f64::consts::PI;
    for (text, expected) in [
        ("x^2 + y^2 + z^2 - 2x - 2y - 2z + 2", 4.0 / 3.0 * pi),
        ("1 - x^2 - y^2 - z^2", 4.0 / 3.0 * pi),
        ("x^2/4 + y^2/9 + z^2 - 1", 8.0 * pi),
        ("(x^2+y^2+z^2+3)^2 - 16*(x^2+y^2)", 4.0 * pi * pi),
    ] {
        let mesh = meshed(text, None, 48);
        let found = volume(&mesh, [0.0; 3]);
        assert!(
            (found - expected).abs() < 4e-3 * expected,
            "{text}: {found}"
        );
    }
}

/// Every vertex has a zero within the stated bound: f changes its sign, exactly, between two points along the normal that
/// are hardly farther apart.
#[test]
fn vertices_are_certified() {
    for (text, bounds) in [
        ("x^3 + y^3 + z^3 + 1 - (x+y+z+1)^3", Some([[-3.0, 3.0]; 3])),
        ("x^2/4 + y^2/9 + z^2 - 1", None),
    ] {
        let f = space(text);
        let mesh = meshed(text, bounds, 20);
        assert!(mesh.vertices.len() > 500);
        for (vertex, normal) in mesh.vertices.iter().zip(&mesh.normals) {
            let at = |t: f64| {
                let p = std::array::from_fn(|i| vertex[i] + t * normal[i]);
                f.evaluate(&exact(p)).signum()
            };
            // Cells' edges cross the surface at a slant, the normal does not.
            let reach = 2.0 * mesh.vertex_bound;
            assert!(at(reach) * at(-reach) <= 0, "{text} at {vertex:?}");
        }
    }
}

/// The sharper the angle, the more triangles, and all of them closer to the surface.
#[test]
fn bends_are_refined() {
    let surface = ImplicitSurface::new(space("x^2/25 + y^2 + z^2 - 1"));
    let limits = Limits::none();
    let bounds = mesh_bounds(&surface, &limits).unwrap().unwrap().bounds;
    let deviation = |angle: f64| {
        let options = MeshOptions::new(bounds).resolution(16).angle(angle);
        let mesh = mesh_surface(&surface, &options, &limits, &|_| {}).unwrap();
        assert!(mesh.topology().is_watertight());
        let middles = mesh.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| mesh.vertices[v as usize]);
            let [x, y, z]: [f64; 3] = std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0);
            1.0 - (x * x / 25.0 + y * y + z * z).sqrt()
        });
        (mesh.triangles.len(), middles.fold(0.0, f64::max))
    };
    let (coarse, fine) = (deviation(180.0), deviation(10.0));
    assert!(fine.0 > 2 * coarse.0, "{coarse:?} {fine:?}");
    assert!(fine.1 < coarse.1 / 4.0, "{coarse:?} {fine:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Whatever is closed inside its box is watertight: a random even-degree perturbation of a ball.
    #[test]
    fn perturbed_balls_are_watertight(c in prop::collection::vec(-3i64..4, 20)) {
        let all = (0..4u32).flat_map(|i| (0..4 - i).flat_map(move |j| (0..4 - i - j).map(move |k| [i, j, k])));
        let small = SparsePolynomial::from_terms(all.zip(c.into_iter().map(|c| Rational::from(c) / Rational::from(4))));
        let mut f = space("x^4 + y^4 + z^4 + x^2 + y^2 + z^2 - 9");
        f.add_multiple(&small, &Rational::one());
        // |small| is at most 20·(3/4)·r³ beyond r = 1, and f − small at least r⁴/3 + r² − 9.
        let options = MeshOptions::new([[-48.0, 48.0]; 3]).resolution(96).angle(30.0);
        let mesh = mesh_surface(&ImplicitSurface::new(f), &options, &Limits::none(), &|_| {}).unwrap();
        prop_assert!(mesh.topology().is_watertight());
        prop_assert_eq!(mesh.topology().euler_characteristic % 2, 0);
    }
}

/// The box that is chosen holds all bounded pieces, however far they are from the origin and from each other, and however thin
/// they are; where this is not proved, it is said.
#[test]
fn the_default_box_holds_all_bounded_pieces() {
    let folder = tempdir().unwrap();
    let whole = "no part of the surface is outside of the box";
    let pieces = "no bounded piece of the surface is outside of the box";
    for (form, found, held) in [
        (
            "(x^2+y^2+z^2-1)*((x-10)^2+y^2+z^2-1)",
            "triangles, 2 pieces, watertight, Euler characteristic 4",
            whole,
        ),
        (
            "x^2+y^2+100z^2-1",
            "one piece, watertight, Euler characteristic 2",
            whole,
        ),
        (
            "(x*(x-1)^2*(x-2)+y^2)^2+z^2-1/100",
            "one piece, watertight, Euler characteristic -2",
            whole,
        ),
        (
            "(x-100)^2+y^2+z^2-1/100",
            "triangles, one piece, watertight, Euler characteristic 2",
            whole,
        ),
        // A sphere and a disc
        ("y^2+z^2-x*(x-1)*(x-4)", "Euler characteristic 3", pieces),
        ("x^2+y^2-z^2-1", "one piece, open", pieces),
        // The Roman surface contains the axes, along which it is singular.
        (
            "x^2*y^2+y^2*z^2+z^2*x^2-x*y*z",
            "the mesh, which is no proof for the surface",
            "may be outside of the box",
        ),
    ] {
        let arguments = [form, "--resolution", "48", "-o", "surface.obj"];
        let said = mesh_in(folder.path(), &arguments);
        assert!(said.contains(found), "{form}: {said}");
        assert!(said.contains(held), "{form}: {said}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// If two meshes of different resolution are both proved to have the topology of the surface, they have the same one.
    #[test]
    fn what_is_proved_is_the_topology(c in prop::collection::vec(-9i64..10, 10), level in 1i64..8) {
        let all = (0..3u32).flat_map(|i| (0..3 - i).flat_map(move |j| (0..3 - i - j).map(move |k| [i, j, k])));
        let mut f = space("x^4 + y^4 + z^4");
        f.add_multiple(&SparsePolynomial::from_terms(all.zip(c.into_iter().map(Rational::from))), &Rational::one());
        f.add_term([0; 3], Rational::from(-level));
        let surface = ImplicitSurface::new(f);
        let Some(found) = mesh_bounds(&surface, &Limits::none()).unwrap() else {
            return Ok(());
        };
        prop_assert_eq!(found.held, Held::Whole);
        let meshes = [20, 33].map(|resolution| {
            let options = MeshOptions::new(found.bounds).resolution(resolution);
            let mut mesh = mesh_surface(&surface, &options, &Limits::none(), &|_| {}).unwrap();
            mesh.held = found.held;
            mesh
        });
        if meshes.iter().all(Mesh::has_proved_topology) {
            let [a, b] = meshes.map(|mesh| mesh.topology());
            prop_assert!(a.is_watertight() && b.is_watertight());
            prop_assert_eq!((a.components, a.euler_characteristic), (b.components, b.euler_characteristic));
        }
    }
}

/// Two spheres: their union has the topology of two only if they are apart.
#[test]
fn factors_that_meet_are_not_proved_to_be_apart() {
    let first = "(x^2+y^2+z^2-1)";
    for (second, is_apart) in [
        // Touching from outside and from inside, crossing, touching along a circle, near, and apart.
        ("((x-2)^2+y^2+z^2-1)", false),
        ("((x-1/2)^2+y^2+z^2-1/4)", false),
        ("((x-1)^2+y^2+z^2-1)", false),
        ("(x^2+y^2+2*z^2-1)", false),
        ("((x-3)^2+y^2+z^2-1)", true),
        ("(x^2+y^2+z^2-1/4)", true),
    ] {
        let surface = ImplicitSurface::new(space(&format!("{first}*{second}")));
        let found = mesh_bounds(&surface, &Limits::none()).unwrap().unwrap();
        let options = MeshOptions::new(found.bounds).resolution(48);
        let mut mesh = mesh_surface(&surface, &options, &Limits::none(), &|_| {}).unwrap();
        mesh.held = found.held;
        assert_eq!(mesh.has_proved_topology(), is_apart, "{second}");
        assert_eq!(mesh.shared_cells == 0, is_apart, "{second}");
        let said = mesh_text(&mesh).join("; ");
        assert_eq!(
            said.contains("factors of the polynomial may meet"),
            !is_apart
        );
    }
}

/// Far from each other, and of other sizes, two factors have the triangles that each of them has alone.
#[test]
fn factors_that_are_apart_have_grids_of_their_own() {
    let [first, second] = ["(x^2+y^2+z^2-1)", "((x-1000)^2+(y-7)^2+z^4-9)"];
    let options = MeshingOptions::default().resolution(12);
    let meshed = |text: &str| {
        let given = Given::read(text, Numbers::Exact).unwrap();
        verb::mesh(given, &options, &Work::default()).unwrap()
    };
    let both = meshed(&format!("{first}*{second}"));
    let mut alone = [first, second].map(&meshed);
    // The factors have no given order.
    alone.sort_by_key(|mesh| !both.vertices.starts_with(&mesh.vertices));
    let count = u32::try_from(alone[0].vertices.len()).unwrap();
    assert_eq!(
        both.vertices,
        alone.each_ref().map(|mesh| mesh.vertices.clone()).concat()
    );
    assert_eq!(both.factors, [0, alone[0].triangles.len()]);
    let moved = alone[1].triangles.iter().map(|t| t.map(|v| v + count));
    assert!(
        both.triangles
            .iter()
            .copied()
            .eq(alone[0].triangles.iter().copied().chain(moved))
    );
    let topology = both.topology();
    assert!(topology.is_watertight() && both.has_proved_topology());
    assert_eq!((topology.components, topology.euler_characteristic), (2, 4));
}

/// Undirected edges, each with the number of its triangles.
fn edge_counts(triangles: &[[usize; 3]]) -> Vec<usize> {
    let mut counts: HashMap<[usize; 2], usize> = HashMap::new();
    for [a, b, c] in triangles {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            *counts.entry([*p.min(q), *p.max(q)]).or_default() += 1;
        }
    }
    counts.into_values().collect()
}

fn mesh_in(folder: &Path, arguments: &[&str]) -> String {
    let mut all = vec!["mesh"];
    all.extend(arguments);
    let run = run_in(folder, &all, "");
    assert_eq!((run.code, run.out.as_str()), (0, ""), "{}", run.err);
    run.err
}

/// Other programs' readers find the same triangles, closed.
#[test]
fn other_readers_read_the_files() {
    let folder = tempdir().unwrap();
    let form = "(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)";
    let mut sizes = Vec::new();
    for name in ["torus.obj", "torus.ply", "torus.stl"] {
        let said = mesh_in(folder.path(), &[form, "--resolution", "24", "-o", name]);
        assert!(
            said.contains("one piece, watertight, Euler characteristic 0"),
            "{said}"
        );
        let path = folder.path().join(name);
        let triangles: Vec<[usize; 3]> = match name {
            "torus.obj" => {
                let (models, _) = tobj::load_obj(&path, &tobj::LoadOptions::default()).unwrap();
                let mesh = &models[0].mesh;
                assert_eq!(models.len(), 1);
                let numbers = mesh.indices.chunks(3);
                numbers.map(|t| [0, 1, 2].map(|i| t[i] as usize)).collect()
            }
            "torus.ply" => {
                let mut file = std::fs::File::open(&path).unwrap();
                let parser = ply_rs_bw::parser::Parser::<ply_rs_bw::ply::DefaultElement>::new();
                let ply = parser.read_ply(&mut file).unwrap();
                let faces = ply.payload["face"]
                    .iter()
                    .map(|face| match &face["vertex_indices"] {
                        ply_rs_bw::ply::Property::ListUInt(list) => {
                            [0, 1, 2].map(|i| list[i] as usize)
                        }
                        other => panic!("{other:?}"),
                    });
                faces.collect()
            }
            _ => {
                let mut file = std::fs::File::open(&path).unwrap();
                let mesh = stl_io::read_stl(&mut file).unwrap();
                mesh.validate().unwrap();
                mesh.faces.iter().map(|f| f.vertices).collect()
            }
        };
        assert!(edge_counts(&triangles).iter().all(|&n| n == 2), "{name}");
        sizes.push(triangles.len());
    }
    assert!(
        sizes[0] > 2000 && sizes.iter().all(|&n| n == sizes[0]),
        "{sizes:?}"
    );
}

/// An open surface ends at the window; patches and cylinders are surfaces; factors are groups.
#[test]
fn what_is_meshed() {
    let folder = tempdir().unwrap();
    let window = "--window=-2,2,-2,2,-2,2";
    let open = mesh_in(
        folder.path(),
        &["x*y - z", window, "--resolution", "12", "-o", "saddle.obj"],
    );
    assert!(open.contains("open, with"), "{open}");
    let cylinder = mesh_in(folder.path(), &["x^2+y^2=1", window, "-o", "pipe.stl"]);
    assert!(cylinder.contains("one piece, open"), "{cylinder}");
    let patch = "x = cos(theta)*sin(phi); y = sin(theta)*sin(phi); z = 2*cos(phi)";
    let closed = mesh_in(
        folder.path(),
        &[patch, "--resolution", "16", "-o", "egg.ply"],
    );
    assert!(
        closed.contains("watertight, Euler characteristic 2"),
        "{closed}"
    );
    let two = "(x^2+y^2+z^2-1)*(z-3)";
    mesh_in(folder.path(), &[two, window, "-o", "two.obj"]);
    mesh_in(
        folder.path(),
        &[
            two,
            "--window=-2,2,-2,2,-2,4",
            "--resolution",
            "16",
            "-o",
            "two.obj",
        ],
    );
    let text = std::fs::read_to_string(folder.path().join("two.obj")).unwrap();
    assert!(text.contains("g factor0") && text.contains("g factor1"));
}

/// The output does not depend on the number of threads.
#[test]
fn threads_change_nothing() {
    let folder = tempdir().unwrap();
    let form = "x^4 + y^4 + z^4 - x*y*z = 1";
    let bytes = ["1", "2"].map(|threads| {
        mesh_in(
            folder.path(),
            &[
                form,
                "--resolution",
                "20",
                "--threads",
                threads,
                "-o",
                "m.ply",
            ],
        );
        std::fs::read(folder.path().join("m.ply")).unwrap()
    });
    assert_eq!(bytes[0], bytes[1]);
}

/// One clear error each, and no file.
#[test]
fn what_cannot_be_meshed() {
    let folder = tempdir().unwrap();
    for (arguments, said, code) in [
        (&["x^2+y^2+z^2=1"][..], "give -o OUT.obj", 2),
        (&["x^2+y^2+z^2=1", "-o", "m.svg"], "a mesh is a .obj", 2),
        (
            &["x^2+y^2+z^2+1=0", "-o", "m.obj"],
            "it is proved that the surface has no real point",
            2,
        ),
        (
            &["x^2+y^2+z^2=1", "--window=3,4,3,4,3,4", "-o", "m.obj"],
            "it is proved that the surface has no real point in the window",
            2,
        ),
        (
            // Balls that are far apart, compared with their sizes.
            &[
                "(x^2+y^2+z^2-1)*((x-1000)^2+y^2+z^2-1/1000000)",
                "--window=-90,1090,-90,90,-90,90",
                "-o",
                "m.obj",
            ],
            "no part of the surface was found in the window, with 64 cells along the longest side of a box; a larger --resolution",
            3,
        ),
        (
            &["x^2+y^2+z^2=1", "--window=3,4,3,4", "-o", "m.obj"],
            "expected X0,X1",
            2,
        ),
        (
            &["r = 1 + cos(t)/3", "-o", "m.obj"],
            "mesh takes a surface",
            2,
        ),
        (
            &["x^2+y^2+z^2=1", "--angle", "0", "-o", "m.obj"],
            "--angle 0",
            2,
        ),
        (
            &["x^2+y^2+z^2=1", "--resolution", "1", "-o", "m.obj"],
            "--resolution 1: expected a whole number from 2 to 1024",
            2,
        ),
        (
            &["x^9+y^2+z^2=1", "--max-degree", "8", "-o", "m.obj"],
            "--max-degree",
            3,
        ),
    ] {
        let mut all = vec!["mesh"];
        all.extend(arguments);
        let run = run_in(folder.path(), &all, "");
        assert_eq!(run.code, code, "{arguments:?}: {}", run.err);
        assert!(run.err.contains(said), "{arguments:?}: {}", run.err);
        assert!(run.out.is_empty());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
