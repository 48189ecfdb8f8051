//! Meshes of surfaces that are thin, far from the origin, very small or very large, and what their files hold.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use proptest::prelude::*;
use stellate::error::Error;
use stellate::exact::{Dyadic, Rational};
use stellate::language::Numbers;
use stellate::mesh::Mesh;
use stellate::poly::SparsePolynomial;
use stellate::shape::{Form, ImplicitSurface};
use stellate::verb::{self, Given, MeshingOptions, Work};
use tempfile::tempdir;

use crate::common::program::run_in;
use crate::mesh::volume;

fn meshed(given: Given) -> Result<Mesh, Error> {
    let options = MeshingOptions::default().resolution(24);
    verb::mesh(given, &options, &Work::default())
}

fn of_text(text: &str) -> Result<Mesh, Error> {
    meshed(Given::read(text, Numbers::Exact).unwrap())
}

/// Σ (x_i − c_i)²/a_i² − 1
fn ellipsoid(center: [i64; 3], exponents: [i64; 3]) -> SparsePolynomial<3> {
    let mut f = SparsePolynomial::constant(Rational::from(-1));
    for axis in 0..3 {
        let weight = Rational::from(10).pow(-2 * exponents[axis]).unwrap();
        let c = Rational::from(center[axis]);
        let term = |k: u32| [0, 1, 2].map(|i| if i == axis { k } else { 0 });
        f.add_term(term(2), weight.clone());
        f.add_term(term(1), &weight * &c * Rational::from(-2));
        f.add_term(term(0), weight * &c * &c);
    }
    f
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Ellipsoids with semi-axes from 10⁻⁶ to 10³ anywhere have whole meshes of the right volume, and f has both signs within the bound
    /// of a vertex.
    #[test]
    fn ellipsoids_of_all_proportions_are_meshed_whole(
        center in prop::array::uniform3(prop::sample::select(vec![0i64, 0, 1, -7, 1_000_000, -1_000_000_000])),
        exponents in prop::array::uniform3(-6i64..4),
    ) {
        // Doubles tell points on the ellipsoid apart.
        let about = center.map(|c| i32::try_from(c).unwrap()).map(f64::from);
        let axes = exponents.map(|e| 10f64.powi(i32::try_from(e).unwrap()));
        prop_assume!((0..3).all(|i| about[i].abs() < 1e12 * axes[i]));
        let f = ellipsoid(center, exponents);
        let mesh = meshed(Form::Surface(ImplicitSurface::new(f.clone())).into()).unwrap();
        let topology = mesh.topology();
        prop_assert!(topology.is_watertight());
        prop_assert_eq!((topology.components, topology.euler_characteristic), (1, 2));
        let expected = 4.0 / 3.0 * std::f64::consts::PI * axes.iter().product::<f64>();
        let found = volume(&mesh, about);
        prop_assert!((found - expected).abs() < 0.05 * expected, "{found} {expected}");
        // Where doubles are so coarse, a step through the surface may leave it on the other side.
        let thinnest = axes.iter().copied().fold(f64::INFINITY, f64::min);
        let is_fine = 100.0 * mesh.vertex_bound < thinnest;
        let all = mesh.vertices.iter().zip(&mesh.normals);
        for (vertex, normal) in all.step_by(97).filter(|_| is_fine) {
            let sign = |step: f64| {
                let p: [Rational; 3] = [0, 1, 2].map(|i| {
                    let [at, along] = [vertex[i], step * normal[i]].map(|x| Dyadic::from_f64(x).unwrap().to_rational());
                    at + along
                });
                f.evaluate(&p).signum()
            };
            // Near a sharp rim a long step leaves the thin inside again.
            let mut steps = (0..10).map(|k| 2.5 * mesh.vertex_bound * 0.1f64.powi(k));
            prop_assert!(steps.any(|step| (sign(-step), sign(step)) == (-1, 1)), "{vertex:?}");
        }
    }
}

#[test]
fn small_and_thin_surfaces_are_found() {
    for (text, euler) in [
        ("x^2+y^2+1e8*z^2=1", 2),
        ("x^2+y^2+z^2=1e-80", 2),
        ("(x-1e9)^2+1e8*y^2+z^2=1e-6", 2),
        ("(x^2+y^2+1e6*z^2+3/4)^2 = 4(x^2+y^2)", 0),
    ] {
        let mesh = of_text(text).unwrap();
        let topology = mesh.topology();
        assert!(mesh.has_proved_topology(), "{text}: {:?}", mesh.cells);
        assert!(topology.is_watertight(), "{text}");
        assert_eq!(topology.components, 1, "{text}");
        assert_eq!(topology.euler_characteristic, euler, "{text}");
    }
}

/// What is said of an STL file is true of the numbers in it.
#[test]
fn stl_files_are_within_their_bounds() {
    let folder = tempdir().unwrap();
    for (form, center) in [
        ("x^2+y^2+z^2=1", 0.0),
        ("(x-1000)^2+y^2+z^2=1", 1000.0),
        ("R = 1", 0.0),
    ] {
        let run = run_in(folder.path(), &["mesh", form, "-o", "s.stl"], "");
        assert_eq!(run.code, 0, "{}", run.err);
        let (_, bound) = run.err.split_once("certified zero within ").unwrap();
        let bound: f64 = bound.lines().next().unwrap().parse().unwrap();
        let mut file = fs::File::open(folder.path().join("s.stl")).unwrap();
        let mesh = stl_io::read_stl(&mut file).unwrap();
        let distances = mesh.vertices.iter().map(|v| {
            let [x, y, z] = [0, 1, 2].map(|i| f64::from(v[i]));
            ((x - center).hypot(y).hypot(z) - 1.0).abs()
        });
        let largest = distances.fold(0.0, f64::max);
        // The bound is printed with two digits.
        assert!(largest <= 1.06 * bound, "{form}: {largest} {bound}");
        assert!(bound < 4.0 * largest, "{form}: {largest} {bound}");
    }
    let run = run_in(
        folder.path(),
        &["mesh", "x^2+y^2+z^2=1e80", "-o", "h.stl"],
        "",
    );
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("too large for single precision"),
        "{}",
        run.err
    );
    assert!(!folder.path().join("h.stl").exists());
}

/// An STL file has only places, of which single precision makes some equal; what is said is true of what is left.
#[test]
fn stl_files_have_the_topology_that_is_said() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("s.stl");
    for (form, is_whole) in [
        ("(x-1000)^2+y^2+z^2=1", true),
        ("(x-5000000)^2+(y-400000)^2+z^2=100", false),
    ] {
        let run = run_in(folder.path(), &["mesh", form, "-o", "s.stl"], "");
        assert_eq!(run.code, 0, "{}", run.err);
        let mesh = stl_io::read_stl(&mut fs::File::open(&file).unwrap()).unwrap();
        let said = format!("{} vertices", mesh.vertices.len());
        assert!(run.err.contains(&said), "{said}: {}", run.err);
        assert_eq!(run.err.contains(", watertight"), is_whole, "{}", run.err);
        assert_eq!(run.err.contains("not watertight"), !is_whole);
        assert_eq!(
            run.err.contains("OBJ and PLY files hold doubles"),
            !is_whole
        );
        // The mesh is read again exactly if it is watertight.
        let fit = run_in(folder.path(), &["fit", "s.stl", "--degree=2"], "");
        assert_eq!(fit.code, if is_whole { 0 } else { 2 }, "{}", fit.err);
    }
}

/// Where cells are too large for the surface, its edges bend by more than the angle, which is said.
#[test]
fn edges_that_bend_too_much_are_counted() {
    let folder = tempdir().unwrap();
    let said = |form: &str, window: &[&str]| {
        let command = [&["mesh", form, "-o", "m.obj"], window].concat();
        let run = run_in(folder.path(), &command, "");
        assert_eq!(run.code, 0, "{}", run.err);
        run.err.contains("by more than the wanted angle")
    };
    assert!(!said("x^2+y^2+z^2=1", &[]));
    // Apart, the two have cells of their own.
    let two = "(x^2+y^2+z^2-1)*((x-100)^2+y^2+z^2-1)";
    assert!(!said(two, &[]));
    assert!(said(two, &["--window=-9,109,-1.2,1.2,-1.2,1.2"]));
}

/// The image of a sphere tells the topology of a harmonic surface only where R has one sign.
#[test]
fn radii_that_change_their_sign_prove_no_topology() {
    for (form, is_proved) in [
        ("R = 2 + Y(1,0)/2", true),
        ("R = -2", true),
        ("R = -2 + Y(2,1)/9", true),
        ("R = Y(1,0)", false),
        ("R = 1/10 + Y(1,0)/2", false),
    ] {
        let mesh = of_text(form).unwrap();
        assert_eq!(mesh.has_proved_topology(), is_proved, "{form}");
        if is_proved {
            assert!(volume(&mesh, [0.0; 3]) > 10.0, "{form}");
        }
    }
    let flat = of_text("R = Y(1,0)").unwrap().topology().flat_triangles;
    assert!(flat > 0);
    let refused = of_text("R = 0").unwrap_err().to_string();
    assert!(refused.contains("a single point"), "{refused}");
}

/// A picture says what it may miss.
#[test]
fn pictures_say_what_they_may_miss() {
    let folder = tempdir().unwrap();
    let plot = |form: &str| run_in(folder.path(), &["plot", form, "-o", "p.svg"], "");
    let coarse = plot("(x^2+y^2+z^2+1-(1/50)^2)^2 = 4(x^2+y^2)");
    assert!(
        coarse.err.contains("the picture may miss what is smaller"),
        "{}",
        coarse.err
    );
    let thin = plot("x^2+y^2+1e4*z^2=1");
    assert_eq!((thin.code, thin.err.as_str()), (0, ""));
    let svg = fs::read_to_string(folder.path().join("p.svg")).unwrap();
    assert!(svg.matches("<path").count() + svg.matches("<polygon").count() > 100);
}

/// A note of a picture names an option that the verb has.
#[test]
fn a_note_of_a_picture_names_an_option_of_plot() {
    let folder = tempdir().unwrap();
    let plot = ["plot", "x^2 = y^2*z", "-o", "f.svg"];
    let run = run_in(folder.path(), &plot, "");
    assert!(
        run.err.contains("a larger --cells shows more"),
        "{}",
        run.err
    );
    let more = [&plot[..], &["--cells", "40"]].concat();
    let run = run_in(folder.path(), &more, "");
    assert_eq!(run.code, 0, "{}", run.err);
}
