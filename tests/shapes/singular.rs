//! Surfaces with singular points: what triangles cannot show is drawn as lines and points, or said to be missing; and the boundaries
//! of solids.

use crate::common::forms::space;
use crate::common::program::run_in;
use crate::mesh::volume;
use proptest::prelude::*;
use stellate::limits::Limits;
use stellate::mesh::{MeshOptions, mesh_surface};
use stellate::parametrize::singular_locus;
use stellate::shape::ImplicitSurface;
use tempfile::tempdir;

/// Sticks, double curves, pinch points and isolated points of classical surfaces.
#[test]
fn singular_points_of_classical_surfaces_are_found() {
    for (name, text, curves, points) in [
        ("Whitney's umbrella", "x^2 - y^2*z", 1, 0),
        ("Cartan's umbrella", "z*(x^2+y^2) - x^3", 1, 0),
        ("the Roman surface", "x^2*y^2+y^2*z^2+z^2*x^2-x*y*z", 3, 0),
        ("a circle", "(x^2+y^2-1)^2+z^2", 1, 0),
        ("a point", "x^2+y^2+z^2", 0, 1),
        ("a cone", "x^2+y^2-z^2", 0, 1),
        ("a drop", "x^2+y^2-z^3*(1-z)", 0, 1),
        ("Cayley's cubic", "x^2+y^2+z^2-2*x*y*z-1", 0, 4),
        ("a sphere", "x^2+y^2+z^2-1", 0, 0),
        ("a plane", "x+y+z-1", 0, 0),
        ("a cylinder over a node", "y^2-x^2*(x+1)+0*z", 1, 0),
    ] {
        let found = singular_locus(&space(text), &Limits::none()).unwrap();
        assert!(found.complete, "{name}");
        assert_eq!(
            (found.curves.len(), found.points.len()),
            (curves, points),
            "{name}: {found:?}"
        );
    }
}

/// Meshes say what they do not show, and an OBJ file has it as lines and points.
#[test]
fn meshes_say_what_triangles_do_not_show() {
    let folder = tempdir().unwrap();
    let mesh = |form: &str, name: &str| {
        run_in(
            folder.path(),
            &["mesh", form, "--resolution", "24", "-o", name],
            "",
        )
    };
    let umbrella = mesh("x^2 = y^2*z", "umbrella.obj");
    assert!(
        umbrella.err.contains("singular along 1 piece of a curve,"),
        "{}",
        umbrella.err
    );
    let file = std::fs::read_to_string(folder.path().join("umbrella.obj")).unwrap();
    assert_eq!(
        file.lines().filter(|line| line.starts_with("l ")).count(),
        1
    );
    let point = mesh("x^2+y^2+z^2 = z^3", "point.obj");
    assert!(point.err.contains("singular at 1 point,"), "{}", point.err);
    let file = std::fs::read_to_string(folder.path().join("point.obj")).unwrap();
    assert!(file.ends_with("v 0.0 0.0 0.0\np -1\n"));
    for (form, message) in [
        ("(x^2+y^2-1)^2+z^2", "only curves of the surface"),
        ("x^2+y^2+z^2", "only single points of the surface"),
        ("x^2+y^2+z^2+1", "proved that the surface has no real point"),
    ] {
        let run = mesh(form, "nothing.obj");
        assert_eq!(run.code, 2, "{form}");
        assert!(run.err.contains(message), "{form}: {}", run.err);
    }
    // A surface whose singular points are not found says so.
    let hard = mesh("(x^2+y^2)*((x-1)^2+y^2+z^2)-z^2/10", "hard.obj");
    assert!(
        hard.err.contains("may have more singular points"),
        "{}",
        hard.err
    );
}

/// Pictures show curves and points that are no part of any sheet.
#[cfg(feature = "pictures")]
#[test]
fn pictures_show_circles_sticks_and_points() {
    let folder = tempdir().unwrap();
    let parts = |form: &str| {
        let run = run_in(folder.path(), &["plot", form, "-o", "figure.svg"], "");
        assert_eq!(run.code, 0, "{form}: {}", run.err);
        let svg = std::fs::read_to_string(folder.path().join("figure.svg")).unwrap();
        // The first line and the first circle are those of the legend.
        ["<polyline", "<circle"].map(|element| svg.matches(element).count())
    };
    let [plain, _] = parts("x^2+y^2+z^2 = 1");
    assert!(parts("(x^2+y^2-1)^2+z^2 = 0")[0] > plain + 50);
    assert!(parts("z*(x^2+y^2) = x^3")[0] > plain + 50);
    assert!(parts("x^2+y^2+z^2 = 0")[1] > 0);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    /// The volume of a solid between nested spheres is the alternating sum of their volumes, whatever else is beside them.
    #[test]
    fn solids_have_hollows(radii in prop::collection::btree_set(2u32..9, 1..4), beside in any::<bool>()) {
        let mut text: Vec<String> = radii.iter().map(|r| format!("(x^2+y^2+z^2-{})", r * r)).collect();
        if beside {
            text.push("((x-14)^2+y^2+z^2-16)".into());
        }
        let options = MeshOptions::new([[-9.0, 19.0], [-9.0, 9.0], [-9.0, 9.0]]).resolution(56);
        let surface = ImplicitSurface::new(space(&text.join("*")));
        let mut mesh = mesh_surface(&surface, &options, &Limits::none(), &|_| {}).unwrap();
        prop_assert!(mesh.turn_as_solid());
        prop_assert_eq!(mesh.inward, radii.len() / 2);
        let signs = [1.0, -1.0].into_iter().cycle();
        let cubes = radii.iter().rev().zip(signs).map(|(r, sign)| sign * f64::from(r * r * r));
        let expected = (cubes.sum::<f64>() + if beside { 64.0 } else { 0.0 }) * 4.0 / 3.0 * std::f64::consts::PI;
        prop_assert!((volume(&mesh, [0.0; 3]) / expected - 1.0).abs() < 0.03, "{} {}", volume(&mesh, [0.0; 3]), expected);
    }
}

#[test]
fn a_shell_is_the_boundary_of_a_solid_on_request() {
    let folder = tempdir().unwrap();
    let run = |more: &[&str]| {
        let mut all = vec![
            "mesh",
            "(x^2+y^2+z^2-2)^2 = 1/2",
            "--resolution",
            "16",
            "-o",
            "shell.stl",
        ];
        all.extend(more);
        run_in(folder.path(), &all, "")
    };
    assert!(!run(&[]).err.contains("inward"));
    assert!(
        run(&["--solid"])
            .err
            .contains("1 piece inside others points inward")
    );
    let open = run_in(
        folder.path(),
        &["mesh", "x*y = z", "--solid", "-o", "open.stl"],
        "",
    );
    assert_eq!(open.code, 2);
    assert!(open.err.contains("is not closed"), "{}", open.err);
}
