//! Tables say by the names of their columns which of them are coordinates, to every verb in the same way.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::program::{Run, run_in, with_data};

fn inspected(table: &str, form: &str) -> Run {
    let arguments = ["inspect", form, "--tolerance=0.1", "--points=data.csv"];
    with_data(table, &arguments)
}

fn fitted(table: &str) -> Run {
    with_data(table, &["fit", "data.csv", "-n", "0", "--decimals=3"])
}

/// The verdicts of the points.
fn verdicts(run: &Run) -> Vec<String> {
    let rows = run.out.lines().skip(1);
    rows.map(|row| row.split(',').nth(2).unwrap().to_owned())
        .collect()
}

#[test]
fn columns_that_are_named_x_and_y_are_the_coordinates() {
    // The nominal points are on the circle, the measured ones are not.
    for header in [
        "id,x_nom,y_nom,x,y",
        "id,x [mm],y [mm],X,Y",
        "id,x-err,y-err,x_mm,y_mm",
        "lat,lon,easting,x,y",
    ] {
        let run = inspected(&format!("{header}\n1,3,4,3.3,4.4\n2,5,0,5.9,0\n"), "r = 5");
        assert_eq!(verdicts(&run), ["outside"; 2], "{header}: {}", run.err);
        assert_eq!(run.code, 1);
    }
    let run = fitted("lat,x,y\n7,13,0\n8,10,3\n7,7,0\n6,10,-3\n");
    assert!(run.out.starts_with("# center: 10, 0\n"), "{}", run.out);
}

#[test]
fn an_outline_agrees_with_its_own_table() {
    let rows = "0,3\n2,2\n1,0\n1.5,-2\n0,-3\n-1.5,-2\n-1,0\n-2,2\n";
    let asked = [
        "inspect",
        "data.csv",
        "-n8",
        "--tolerance=0.5",
        "--points=data.csv",
    ];
    let [geographic, plain] = ["lat,lon", "y,x"].map(|header| {
        let run = with_data(&format!("{header}\n{rows}"), &asked);
        assert_eq!(run.code, 0, "{header}: {}", run.err);
        run.out
    });
    assert_eq!(geographic, plain);
}

#[test]
fn names_that_fit_several_columns_are_refused() {
    for (header, part) in [
        (
            "x_nom,y_nom,x_meas,y_meas",
            "x_meas (number 3), x_nom (number 1)",
        ),
        ("x,y,x,z", "x (number 1), x (number 3)"),
        ("theta,r,a,b", "angles and radii"),
    ] {
        let table = format!("{header}\n3,4,3,4\n5,0,5,0\n");
        for run in [inspected(&table, "r = 5"), fitted(&table)] {
            assert_eq!((run.code, run.out.as_str()), (2, ""), "{header}");
            assert!(run.err.contains(part), "{}", run.err);
        }
    }
    let run = fitted("p_a,p_b,p_c\n1,2,3\n2,3,4\n");
    assert!(
        run.err.contains("none of the columns p_a,p_b,p_c"),
        "{}",
        run.err
    );
}

#[test]
fn a_first_row_of_numbers_is_a_point() {
    let run = inspected("9\u{a0}9\n5\u{a0}0\n3\u{a0}4\n", "r = 5");
    assert_eq!(verdicts(&run), ["outside", "inside", "inside"]);
    let run = inspected("9mm;9mm\n5;0\n", "r = 5");
    assert_eq!(run.code, 2, "{}", run.out);
    assert!(run.err.contains("row 1"), "{}", run.err);
    let quoted = "id,x,y\n\"a;b\",5,0\n\"c\",3,4\n";
    assert_eq!(verdicts(&inspected(quoted, "r = 5")), ["inside"; 2]);
}

#[test]
fn points_in_space_are_no_outline() {
    let run = fitted("x,y,z\n1,0,0\n0,1,0\n0,0,1\n-1,0,0\n");
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("row 4: z is 1 here and 0 in row 2"),
        "{}",
        run.err
    );
}

#[test]
fn check_takes_units_but_no_degrees() {
    let check = |table: &str, option: &str| {
        let option = format!("{option}=data.csv");
        with_data(table, &["check", "r = 5", &option])
    };
    let run = check("x (mm),y (mm),x_err,y_err\n3,4,9,9\n5,0,9,9\n", "--points");
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert_eq!(check("theta_rad,r\n0.5,5\n", "--radii").code, 0);
    let run = check("theta (deg),r\n90,5\n", "--radii");
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("expected the columns theta,r"),
        "{}",
        run.err
    );
}

#[test]
fn names_of_fewer_columns_than_there_are_do_not_say_which_are_coordinates() {
    // Row names of R have no header, and commas may be decimal points.
    for table in ["x y\n1 1.5 0\n2 1 0\n", "x,y\n1,5,0\n", "y,x\n0,1.5,0\n"] {
        let run = inspected(table, "x^2 + y^2 + z^2 = 1");
        assert_eq!(run.code, 2, "{table}: {}", run.out);
        let expected = "row 2: found 3 columns; the first row names 2";
        assert!(run.err.contains(expected), "{table}: {}", run.err);
    }
}

#[test]
fn a_table_of_rows_that_are_all_skipped_has_no_points() {
    let arguments = [
        "inspect",
        "r = 1",
        "--tolerance=1",
        "--points=data.csv",
        "--skip-bad",
    ];
    let run = with_data("x,y\nn/a,1\n,2\n", &arguments);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    let expected = "no points in it; rows that are no points: 2";
    assert!(run.err.contains(expected), "{}", run.err);
}

#[test]
fn rows_of_outlines_that_are_finished_are_written_at_a_limit() {
    let folder = tempfile::TempDir::new().unwrap();
    let circle: String = (0..100)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 100.0)
        .map(|t| format!("{},{}\n", t.cos(), t.sin()))
        .collect();
    std::fs::write(folder.path().join("circle.csv"), circle).unwrap();
    std::fs::write(folder.path().join("square.csv"), "1,1\n-1,1\n-1,-1\n1,-1\n").unwrap();
    for files in [["circle.csv", "square.csv"], ["square.csv", "circle.csv"]] {
        let mut arguments = vec!["fit"];
        arguments.extend(files);
        arguments.extend(["--tolerance", "0.001", "--decimals", "3"]);
        let run = run_in(folder.path(), &arguments, "");
        assert_eq!(run.code, 3, "{}", run.err);
        assert!(run.err.contains("square"), "{}", run.err);
        assert!(!run.err.contains("circle"), "{}", run.err);
        let rows: Vec<&str> = run.out.lines().skip(1).collect();
        assert!(
            rows.len() == 1 && rows[0].starts_with("circle.csv,"),
            "{rows:?}"
        );
    }
}

/// Columns are carried along by their names, which must differ from each other and, in CSV, from those of the answers.
#[test]
fn columns_that_would_have_equal_names_are_not_carried_along() {
    let kept = |table: &str, options: &[&str]| {
        let fixed = [
            "inspect",
            "r = 5",
            "--tolerance=0.1",
            "--points=data.csv",
            "--keep",
        ];
        with_data(table, &[&fixed[..], options].concat())
    };
    let answers = kept("x,y\n3,4\n", &[]).out;
    let again = answers.as_str();
    let json = ["--format=json"];
    let feet = ["--feet"];
    for (table, options, twice) in [
        ("x,y,a,a\n3,4,1,2\n", &[][..], Some("a")),
        ("x,y,a,a\n3,4,1,2\n", &json[..], Some("a")),
        (again, &[][..], Some("verdict")),
        (again, &json[..], None),
        ("x,y,foot_x\n3,4,1\n", &feet[..], Some("foot_x")),
        ("x,y,foot_x\n3,4,1\n", &[][..], None),
    ] {
        let run = kept(table, options);
        match twice {
            Some(name) => {
                assert_eq!((run.code, run.out.as_str()), (2, ""), "{table}");
                let expected = format!("two columns of the result would be called {name:?}");
                // In JSON, quotes are escaped.
                let said = run.err.replace('\\', "");
                assert!(said.contains(&expected), "{table}: {said}");
            }
            None => assert_eq!(run.code, 0, "{table}: {}", run.err),
        }
    }
}
