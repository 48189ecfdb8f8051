//! Harmonic surfaces that are inspected, fitted to meshes, and checked, from end to end.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use serde_json::Value;
use tempfile::TempDir;

use crate::common::program::{done_in, run_in};

/// A table of a radius of degree 6, by rows l,m,value; `kept` says which harmonics are there.
fn table(kept: impl Fn(i64, i64) -> bool) -> String {
    let mut text = String::from("l,m,value\n0,0,10\n");
    for l in 1..=6_i64 {
        for m in -l..=l {
            let size: i64 = (1..=m.abs()).map(|k| l + k).product();
            let c = (7 * l + 5 * m).rem_euclid(11) - 5;
            if c != 0 && kept(l, m) {
                text += &format!("{l},{m},{c}/{}\n", 20 * size);
            }
        }
    }
    text
}

#[test]
fn points_are_inspected_without_the_equation() {
    let points = [
        "0,0,2.6",
        "0,0,2.600000000000000000000000000001",
        "0,0,2.5",
        "0,0,0",
    ];
    let mut arguments = vec![
        "inspect",
        "R = 2 + Y(1,0)/2",
        "--tolerance",
        "0.1",
        "--quiet",
    ];
    for point in points {
        arguments.extend(["--point", point]);
    }
    let run = run_in(Path::new("."), &arguments, "");
    // Some points are outside.
    assert_eq!(run.code, 1, "{}", run.err);
    let out = run.out;
    let rows: Vec<Vec<&str>> = out.lines().map(|row| row.split(',').collect()).collect();
    let verdicts: Vec<[&str; 3]> = rows[1..].iter().map(|r| [r[3], r[4], r[7]]).collect();
    assert_eq!(
        verdicts,
        [
            ["inside", "true", "1"],
            ["outside", "false", "1"],
            ["inside", "true", "0"],
            ["outside", "false", "-1"],
        ]
    );
    assert_eq!((rows[3][5], rows[3][6]), ("0.0", "0.0"));
    // The origin's nearest point is (0, 0, −3/2) in the direction of −z.
    let [low, high] = [rows[4][5], rows[4][6]].map(|x| x.parse::<f64>().unwrap());
    assert!(low > 1.4999 && high < 1.5001);
}

#[test]
fn a_table_of_points_is_decided_entirely() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("r.csv"), table(|_, _| true)).unwrap();
    let points: String = (0..400)
        .map(|k| {
            let (a, b) = (f64::from(k) * 0.37, f64::from(k) * 0.11);
            let r = 9.0 + 2.5 * f64::from(k % 17) / 17.0;
            format!(
                "{},{},{}\n",
                r * a.cos() * b.sin(),
                r * a.sin() * b.sin(),
                r * b.cos()
            )
        })
        .collect();
    let run = run_in(
        folder.path(),
        &[
            "inspect",
            "r.csv",
            "--tolerance",
            "0.3",
            "--points",
            "-",
            "--format",
            "json",
            "--quiet",
        ],
        &points,
    );
    let document: Value = serde_json::from_str(&run.out).unwrap();
    let points = document["points"].as_array().unwrap();
    assert_eq!(points.len(), 400);
    for point in points {
        assert_ne!(point["verdict"], "undecided", "{point}");
        assert!(
            point["curve"].is_boolean() && point["sign"].is_i64(),
            "{point}"
        );
    }
}

#[test]
fn packed_files_and_first_rows_of_planets_are_read() {
    let folder = TempDir::new().unwrap();
    let path = folder.path();
    let rows = "0 0 2.0 0.0\n1 0 0.5 0.0\n1 1 0.25 -0.125\n";
    fs::write(path.join("a.sh"), rows).unwrap();
    let planet = format!(" 6378.0, 398600.4, 0.1, 1, 1, 1, 0.0, 0.0\n{rows}");
    fs::write(path.join("planet.sh"), planet).unwrap();
    // gzip with one stored block.
    let length = u16::try_from(rows.len()).unwrap();
    let mut packed = vec![0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 255, 1];
    packed.extend(length.to_le_bytes());
    packed.extend((!length).to_le_bytes());
    packed.extend(rows.bytes());
    let cut = packed.clone();
    packed.extend(crc32(rows.as_bytes()).to_le_bytes());
    packed.extend(u32::from(length).to_le_bytes());
    fs::write(path.join("b.sh.gz"), packed).unwrap();
    fs::write(path.join("cut.sh.gz"), &cut[..30]).unwrap();
    let first = done_in(path, &["implicitize", "a.sh", "--quiet"], "");
    for name in ["b.sh.gz", "planet.sh"] {
        assert_eq!(done_in(path, &["implicitize", name, "--quiet"], ""), first);
    }
    let run = run_in(path, &["describe", "cut.sh.gz"], "");
    assert!(
        run.code == 2 && run.err.contains("cut.sh.gz"),
        "{} {}",
        run.code,
        run.err
    );
}

/// The checksum of gzip.
fn crc32(bytes: &[u8]) -> u32 {
    let mut crc = !0u32;
    for byte in bytes {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = if crc & 1 == 1 {
                crc >> 1 ^ 0xEDB8_8320
            } else {
                crc >> 1
            };
        }
    }
    !crc
}

#[test]
fn a_mesh_of_a_surface_is_fitted_back() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("r.csv"), table(|_, _| true)).unwrap();
    for (name, resolution) in [("m.obj", "40"), ("m.ply", "20")] {
        done_in(
            folder.path(),
            &["mesh", "r.csv", "--resolution", resolution, "-o", name],
            "",
        );
        let least = [
            "fit",
            name,
            "--degree",
            "6",
            "--estimator",
            "least-squares",
            "--center",
            "0,0,0",
        ];
        done_in(
            folder.path(),
            &[&least[..], &["--format", "json", "-o", "f.json"]].concat(),
            "",
        );
        let text = fs::read_to_string(folder.path().join("f.json")).unwrap();
        let document: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(document["kind"], "spherical");
        assert_eq!(document["outline_star_shaped"], true);
        assert_eq!(document["center"], serde_json::json!(["0", "0", "0"]));
        let run = run_in(
            folder.path(),
            &[
                "check",
                "r.csv",
                "--coefficients",
                "f.json",
                "--digits",
                "8",
            ],
            "",
        );
        assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    }
    // The quadrature sees the flat triangles.
    let out = done_in(
        folder.path(),
        &["fit", "m.obj", "--tolerance", "0.2", "--format", "json"],
        "",
    );
    let document: Value = serde_json::from_str(&out).unwrap();
    assert!(document["max_radial_error"].as_f64().unwrap() <= 0.2);
    assert!(document["degree"].as_u64().unwrap() <= 6);
    // The document is a form again.
    fs::write(folder.path().join("q.json"), &out).unwrap();
    let described = done_in(folder.path(), &["describe", "q.json"], "");
    assert!(described.contains("star-shaped: yes"), "{described}");
    // STL has single precision.
    done_in(
        folder.path(),
        &["mesh", "r.csv", "--resolution", "24", "-o", "m.stl"],
        "",
    );
    let run = run_in(folder.path(), &["fit", "m.stl", "--degree", "4"], "");
    assert!(
        run.code == 0 && run.err.contains("star-shaped about the centroid, exactly"),
        "{}",
        run.err
    );
}

#[test]
fn meshes_that_cannot_be_fitted_are_refused_in_one_sentence() {
    let folder = TempDir::new().unwrap();
    let vertices = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n";
    let faces = "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
    let turned: String = faces
        .lines()
        .map(|line| {
            let words: Vec<&str> = line.split(' ').collect();
            format!("f {} {} {}\n", words[1], words[3], words[2])
        })
        .collect();
    let hole: String = faces
        .lines()
        .skip(1)
        .map(|line| format!("{line}\n"))
        .collect();
    let flipped = faces.replacen("f 1 3 5", "f 3 1 5", 1);
    // A prism over a U.
    let outline = [
        [0, 0],
        [3, 0],
        [3, 3],
        [2, 3],
        [2, 1],
        [1, 1],
        [1, 3],
        [0, 3],
    ];
    let mut u = String::new();
    for z in 0..2 {
        for [x, y] in outline {
            u += &format!("v {x} {y} {z}\n");
        }
    }
    for i in 1..=8 {
        let j = i % 8 + 1;
        u += &format!("f {i} {j} {} {}\n", j + 8, i + 8);
    }
    for [a, b, c] in [
        [1, 6, 7],
        [1, 7, 8],
        [1, 2, 6],
        [2, 5, 6],
        [2, 3, 5],
        [3, 4, 5],
    ] {
        u += &format!("f {a} {c} {b}\nf {} {} {}\n", a + 8, b + 8, c + 8);
    }
    for (text, part) in [
        (format!("{vertices}{hole}"), "the mesh has a hole"),
        (format!("{vertices}{turned}"), "inside out"),
        (
            format!("{vertices}{flipped}"),
            "disagree about which side is outside",
        ),
        (
            format!("{vertices}{faces}f 1 2 9\n"),
            "line 15: `9` is no corner",
        ),
        (
            format!("{}{faces}", vertices.replacen("v 1 0 0", "v NaN 0 0", 1)),
            "line 1: `NaN` is no finite number",
        ),
        (
            format!("{}{faces}", vertices.replacen("v 1 0 0", "v 1 0", 1)),
            "line 1: a vertex has three coordinates",
        ),
        (u, "not star-shaped"),
        (String::from("# nothing\n"), "no triangle"),
    ] {
        fs::write(folder.path().join("a.obj"), &text).unwrap();
        let run = run_in(
            folder.path(),
            &["fit", "a.obj", "--degree", "2", "-o", "out.json"],
            "",
        );
        assert!(
            run.code == 2 && run.err.contains(part),
            "{part}: {} {}",
            run.code,
            run.err
        );
        assert!(!folder.path().join("out.json").exists());
    }
    fs::write(folder.path().join("a.obj"), format!("{vertices}{faces}")).unwrap();
    for (arguments, part) in [
        (vec!["fit", "a.obj"], "--degree L or --tolerance E"),
        (
            vec!["fit", "a.obj", "--harmonics", "3"],
            "--harmonics is for contours",
        ),
        (
            vec!["fit", "a.obj", "--degree", "2", "--center", "3,0,0"],
            "does not see the whole mesh",
        ),
        (
            vec!["fit", "a.obj", "--degree", "2", "--center", "3,0"],
            "X,Y,Z",
        ),
        (
            vec![
                "fit",
                "a.obj",
                "--degree",
                "5",
                "--estimator",
                "least-squares",
            ],
            "fewer than the 36 coefficients",
        ),
        (
            vec!["fit", "x.csv", "--degree", "2"],
            "--degree is for a closed mesh",
        ),
        (vec!["describe", "a.obj"], "`fit` takes a closed mesh"),
    ] {
        let run = run_in(folder.path(), &arguments, "");
        assert!(
            run.code == 2 && run.err.contains(part),
            "{arguments:?}: {} {}",
            run.code,
            run.err
        );
    }
    for (name, bytes, part) in [
        ("cut.stl", &b"solid a\n facet normal 0 0 1\n outer loop\n vertex 0 0 0\n"[..], "the file is cut"),
        ("cut.ply", &b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0"[..], "the file is cut"),
        ("bad.ply", &b"plx\n"[..], "begins with `ply`"),
    ] {
        fs::write(folder.path().join(name), bytes).unwrap();
        let run = run_in(folder.path(), &["fit", name, "--degree", "2"], "");
        assert!(run.code == 2 && run.err.contains(part), "{name}: {}", run.err);
    }
}

/// The radii that a form has in directions over the sphere, as `sample` prints them.
fn radii(folder: &Path, form: &str) -> String {
    let out = done_in(
        folder,
        &[
            "sample",
            form,
            "--directions",
            "200",
            "--positive",
            "--quiet",
        ],
        "",
    );
    let mut text = String::from("theta,phi,r\n");
    for row in out.lines().filter(|row| !row.starts_with('#')).skip(1) {
        let fields: Vec<&str> = row.split(',').collect();
        text += &format!("{},{},{}\n", fields[1], fields[2], fields[6]);
    }
    text
}

fn mistakes(folder: &Path, kind: &str, file: &str) -> Vec<String> {
    let run = run_in(
        folder,
        &["check", "r.csv", kind, file, "--format", "json", "--quiet"],
        "",
    );
    let document: Value = serde_json::from_str(&run.out).unwrap();
    let list = document["mistakes"].as_array().unwrap();
    assert_eq!(run.code, i32::from(!list.is_empty()), "{}", run.out);
    list.iter()
        .map(|m| m["name"].as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn a_legendre_function_that_is_left_out_is_found_from_radii_alone() {
    let folder = TempDir::new().unwrap();
    let path = folder.path();
    fs::write(path.join("r.csv"), table(|_, _| true)).unwrap();
    fs::write(
        path.join("without.csv"),
        table(|l, m| (l, m.abs()) != (6, 5)),
    )
    .unwrap();
    fs::write(path.join("radii.csv"), radii(path, "without.csv")).unwrap();
    assert_eq!(mistakes(path, "--radii", "radii.csv"), ["missing: (6, 5)"]);
    assert_eq!(
        mistakes(path, "--coefficients", "without.csv"),
        ["missing: (6, 5)"]
    );
    fs::write(path.join("radii.csv"), radii(path, "r.csv")).unwrap();
    assert_eq!(mistakes(path, "--radii", "radii.csv"), Vec::<String>::new());
}

#[test]
fn angles_and_signs_that_are_wrong_are_named() {
    let folder = TempDir::new().unwrap();
    let path = folder.path();
    fs::write(path.join("r.csv"), table(|_, _| true)).unwrap();
    let right = radii(path, "r.csv");
    let changed = |change: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let mut text = String::from("theta,phi,r\n");
        for row in right.lines().skip(1) {
            let row: Vec<f64> = row.split(',').map(|x| x.parse().unwrap()).collect();
            let [a, b, c] = change([row[0], row[1], row[2]]);
            text += &format!("{a:?},{b:?},{c:?}\n");
        }
        text
    };
    for (name, text) in [
        (
            "latitude for colatitude",
            changed(&|[t, p, r]| [t, std::f64::consts::FRAC_PI_2 - p, r]),
        ),
        ("theta and phi exchanged", changed(&|[t, p, r]| [p, t, r])),
        (
            "degrees for radians",
            changed(&|[t, p, r]| [t.to_degrees(), p.to_degrees(), r]),
        ),
        ("scale", changed(&|[t, p, r]| [t, p, 2.0 * r])),
    ] {
        fs::write(path.join("radii.csv"), text).unwrap();
        assert_eq!(mistakes(path, "--radii", "radii.csv"), [name]);
    }
    let flipped: String = table(|_, _| true)
        .lines()
        .map(|row| {
            let fields: Vec<&str> = row.split(',').collect();
            let is_odd = fields[1].parse::<i64>().is_ok_and(|m| m % 2 != 0);
            match is_odd {
                true if fields[2].starts_with('-') => {
                    format!("{},{},{}\n", fields[0], fields[1], &fields[2][1..])
                }
                true => format!("{},{},-{}\n", fields[0], fields[1], fields[2]),
                false => format!("{row}\n"),
            }
        })
        .collect();
    fs::write(path.join("phase.csv"), flipped).unwrap();
    assert_eq!(
        mistakes(path, "--coefficients", "phase.csv"),
        ["Condon–Shortley phase"]
    );
}
