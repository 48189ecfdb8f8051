//! Points from PLY files and NumPy arrays, for inspection.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use tempfile::TempDir;

use crate::common::program::{done_in, run_in};

/// A NumPy array of doubles in version 1 of the format.
fn array(shape: &str, is_fortran: bool, numbers: &[f64]) -> Vec<u8> {
    let order = if is_fortran { "True" } else { "False" };
    let header = format!("{{'descr': '<f8', 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend(u16::try_from(header.len()).unwrap().to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
    bytes
}

#[test]
fn vertices_of_ply_files_are_points() {
    let folder = TempDir::new().unwrap();
    // A file of the program itself, in binary.
    let form = "R = 1 + Y(1,0)/100";
    done_in(
        folder.path(),
        &["mesh", form, "--resolution", "12", "-o", "s.ply"],
        "",
    );
    let run = run_in(
        folder.path(),
        &["inspect", form, "--points", "s.ply", "--tolerance", "1e-9"],
        "",
    );
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.lines().count() > 50 && !run.out.contains("outside"));
    // Text, with an element and a list before the coordinates, and the coordinates in another order.
    let text = "ply\nformat ascii 1.0\nelement camera 1\nproperty list uchar float view\nelement vertex 3\n\
        property int id\nproperty double z\nproperty list uchar int ring\nproperty double y\nproperty double x\nend_header\n\
        2 5 6\n17 0.1 2 8 9 0.6 0.8\n18 0 0 0 1\n19 5 1 3 0 0\n";
    fs::write(folder.path().join("t.ply"), text).unwrap();
    let run = run_in(
        folder.path(),
        &[
            "inspect",
            "x^2+y^2=1+0*z",
            "--points",
            "t.ply",
            "--tolerance",
            "1/10",
            "--keep",
        ],
        "",
    );
    assert_eq!(run.code, 1, "{}", run.err);
    let rows: Vec<Vec<&str>> = run.out.lines().map(|l| l.split(',').collect()).collect();
    let column = |name: &str| rows[0].iter().position(|n| *n == name).unwrap();
    let of = |name: &str| {
        rows[1..]
            .iter()
            .map(|r| r[column(name)])
            .collect::<Vec<_>>()
    };
    assert_eq!(of("id"), ["17.0", "18.0", "19.0"]);
    assert_eq!(of("x"), ["0.8", "1.0", "0.0"]);
    assert_eq!(of("verdict"), ["inside", "inside", "outside"]);
    // A file without vertices, and one that is cut.
    for (text, message) in [
        (
            "ply\nformat ascii 1.0\nelement face 0\nend_header\n",
            "no element `vertex`",
        ),
        (&text[..text.len() - 8], "the file is cut"),
    ] {
        fs::write(folder.path().join("bad.ply"), text).unwrap();
        let run = run_in(
            folder.path(),
            &[
                "inspect",
                "x^2+y^2=1+0*z",
                "--points",
                "bad.ply",
                "--tolerance",
                "1",
            ],
            "",
        );
        assert!(
            run.code == 2 && run.err.contains(message) && run.out.is_empty(),
            "{}",
            run.err
        );
    }
}

#[test]
fn rows_of_arrays_are_points() {
    let folder = TempDir::new().unwrap();
    let inspect = |bytes: &[u8], form: &str| {
        fs::write(folder.path().join("a.npy"), bytes).unwrap();
        run_in(
            folder.path(),
            &["inspect", form, "--points", "a.npy", "--tolerance", "0.125"],
            "",
        )
    };
    let verdicts = |text: &str| -> Vec<String> {
        let rows = text
            .lines()
            .skip(1)
            .map(|l| l.split(',').map(str::to_owned).collect());
        rows.map(|row: Vec<String>| row.into_iter().find(|w| w.ends_with("side")).unwrap())
            .collect()
    };
    let numbers = [1.125, 0.0, 0.0, 1.25, 0.6, 0.8];
    let rows = inspect(&array("(3, 2)", false, &numbers), "x^2+y^2=1");
    assert_eq!(
        verdicts(&rows.out),
        ["inside", "outside", "inside"],
        "{}",
        rows.err
    );
    let columns = [1.125, 0.0, 0.6, 0.0, 1.25, 0.8];
    assert_eq!(
        inspect(&array("(3, 2)", true, &columns), "x^2+y^2=1").out,
        rows.out
    );
    let in_space = inspect(
        &array("(2, 3)", false, &[1.0, 0.0, 0.0, 9.0, 9.0, 9.0]),
        "x^2+y^2+z^2=1",
    );
    assert_eq!(verdicts(&in_space.out), ["inside", "outside"]);
    for (bytes, message) in [
        (array("(6,)", false, &numbers), "shape (6,)"),
        (array("(3, 3)", false, &numbers), "the file has 48"),
        (array("(3, 2)", false, &[f64::NAN; 6]), "row 1"),
        (array("(0, 2)", false, &[]), "no point"),
    ] {
        let run = inspect(&bytes, "x^2+y^2=1");
        assert!(run.code == 2 && run.err.contains(message), "{}", run.err);
    }
}

/// Fields with separators and quotation marks are carried along as they are.
#[test]
fn quoted_fields_are_carried_along() {
    let folder = TempDir::new().unwrap();
    let text = "x,y,note,id\n1,0,\"a, \"\"b, c\"\"\",7\n0,1,\"\"\"d\"\"\",8\n0,2,plain,9\n";
    fs::write(folder.path().join("p.csv"), text).unwrap();
    let form = "x^2+y^2=1";
    let start = [
        "inspect",
        form,
        "--points",
        "p.csv",
        "--tolerance",
        "1/10",
        "--keep",
    ];
    let run = run_in(folder.path(), &start, "");
    assert_eq!(run.code, 1, "{}", run.err);
    let ends = [
        ",0,\"a, \"\"b, c\"\"\",7",
        ",0,\"\"\"d\"\"\",8",
        ",1,plain,9",
    ];
    for (line, end) in run.out.lines().skip(1).zip(ends) {
        assert!(line.ends_with(end), "{line}");
    }
    let run = run_in(
        folder.path(),
        &[&start[..], &["--format", "json"]].concat(),
        "",
    );
    assert!(run.out.contains(r#""note":"a, \"b, c\"""#), "{}", run.out);
}

/// Distances with fewer digits than requested, and points without a nearest point, are counted.
#[test]
fn what_is_not_known_is_said() {
    let folder = TempDir::new().unwrap();
    let inspect = |arguments: &[&str]| {
        let start = ["inspect", "--tolerance", "1/10"];
        run_in(folder.path(), &[&start[..], arguments].concat(), "")
    };
    let empty = inspect(&["x^2+y^2+z^2=-1", "--point", "1,2,3"]);
    assert_eq!(empty.code, 1);
    assert!(
        empty.err.contains("of 1 point no nearest point was found"),
        "{}",
        empty.err
    );
    // From a point of the axis a whole circle is nearest.
    let torus = "(x^2+y^2+z^2+3)^2=16*(x^2+y^2)";
    let others = ["--point", "5,1,2", "--point", "0.3,0.2,1/2"];
    let few = inspect(&[&[torus, "--point", "0,0,1/2"][..], &others].concat());
    assert!(
        few.err
            .contains("the distance of 1 point is known to fewer digits"),
        "{}",
        few.err
    );
    let enough = inspect(&[&[torus][..], &others].concat());
    assert!(!enough.err.contains("fewer digits"), "{}", enough.err);
}
