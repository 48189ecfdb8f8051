//! The program as a citizen: files, pipes, threads, notes, statistics, pictures.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use crate::common::program::{EGG, done, done_in, json, outline, piped, run_in};

const EGG_EQUATION: &str =
    "100x^4 + 200x^2y^2 + 100y^4 - 40x^3 - 20x^2y - 40xy^2 - 20y^3 - 96x^2 + 4xy - 99y^2 = 0\n";

/// `--stats` of `sample` says how many directions were decided in how many bits: together all of them.
#[test]
fn statistics_count_the_rays_of_each_precision() {
    let sample = |form: &str| {
        let arguments = ["sample", form, "--directions", "40", "--stats", "--quiet"];
        let run = run_in(Path::new("."), &arguments, "");
        json(&run.err)["stats"]["rays"].clone()
    };
    let count = |rays: &serde_json::Value, name: &str| rays[name].as_u64().unwrap();
    let all = [
        "128_bits", "192_bits", "256_bits", "384_bits", "512_bits", "768_bits", "exact",
    ];
    for form in ["x^4 + y^4 = 1 + x", "x^2 + y^2 + 2z^2 = 3 + x"] {
        let rays = sample(form);
        assert_eq!(all.map(|name| count(&rays, name)).iter().sum::<u64>(), 40);
        assert!(count(&rays, "128_bits") > 30, "{rays}");
    }
    // Double roots are beyond any bounded precision.
    assert_eq!(count(&sample("(x^4 + y^4 - 1 - x)^2"), "exact"), 40);
}

#[test]
fn statistics_are_one_line_of_json_on_standard_error() {
    let butterfly = outline("butterfly");
    let run = run_in(
        Path::new("."),
        &[
            "implicitize",
            &butterfly,
            "--harmonics",
            "9",
            "--stats",
            "--quiet",
        ],
        "",
    );
    assert_eq!(run.err.lines().count(), 1, "{}", run.err);
    let stats = &json(&run.err)["stats"];
    for stage in ["read", "fit", "implicitize", "write"] {
        assert!(stats[stage].as_f64().unwrap() >= 0.0, "{stage}");
    }
    if cfg!(target_os = "linux") {
        assert!(stats["peak_rss_bytes"].as_u64().unwrap() > 100_000);
    }
}

#[test]
fn quiet_silences_the_notes_and_changes_nothing_else() {
    let jet = outline("jet");
    let arguments = ["fit", jet.as_str(), "--harmonics", "9"];
    let loud = run_in(Path::new("."), &arguments, "");
    let quiet = run_in(Path::new("."), &[&arguments[..], &["--quiet"]].concat(), "");
    assert!(loud.err.starts_with("note: "));
    assert_eq!(quiet.err, "");
    assert_eq!(quiet.out, loud.out);
}

#[test]
fn the_number_of_threads_does_not_show() {
    let folder = TempDir::new().unwrap();
    let at = |arguments: &[&str]| done_in(folder.path(), arguments, "");
    at(&[
        "implicitize",
        &outline("butterfly"),
        "--harmonics",
        "20",
        "--format",
        "json",
        "-o",
        "f.json",
    ]);
    let samples = |n| at(&["sample", "f.json", "--directions", "90", "--threads", n]);
    assert_eq!(samples("1"), samples("2"));
    let figure = |n| {
        at(&["plot", "f.json", "-o", "f.svg", "--threads", n]);
        fs::read_to_string(folder.path().join("f.svg")).unwrap()
    };
    assert_eq!(figure("1"), figure("2"));
}

#[test]
fn output_goes_to_a_file_whole_and_nothing_to_the_screen() {
    let folder = TempDir::new().unwrap();
    fs::write(
        folder.path().join("f.txt"),
        "something longer that was here before".repeat(100),
    )
    .unwrap();
    let run = run_in(folder.path(), &["implicitize", EGG, "-o", "f.txt"], "");
    assert_eq!((run.code, run.out.as_str()), (0, ""));
    assert_eq!(
        fs::read_to_string(folder.path().join("f.txt")).unwrap(),
        EGG_EQUATION
    );
    assert_eq!(
        fs::read_dir(folder.path()).unwrap().count(),
        1,
        "no temporary file stays"
    );
}

#[cfg(unix)]
#[test]
fn output_through_a_link_keeps_the_link_and_to_a_pipe_keeps_the_pipe() {
    use std::os::unix::fs::FileTypeExt;
    let folder = TempDir::new().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("real.txt"), "old").unwrap();
    std::os::unix::fs::symlink("real.txt", path("link.txt")).unwrap();
    done_in(folder.path(), &["implicitize", EGG, "-o", "link.txt"], "");
    assert!(fs::symlink_metadata(path("link.txt")).unwrap().is_symlink());
    assert_eq!(fs::read_to_string(path("real.txt")).unwrap(), EGG_EQUATION);

    let made = std::process::Command::new("mkfifo")
        .arg(path("pipe"))
        .status()
        .unwrap();
    assert!(made.success());
    let pipe = path("pipe");
    let reader = std::thread::spawn(move || fs::read_to_string(pipe).unwrap());
    done_in(folder.path(), &["implicitize", EGG, "-o", "pipe"], "");
    // Looked at first: if a file had taken the pipe's place, the reader would wait for ever.
    assert!(fs::metadata(path("pipe")).unwrap().file_type().is_fifo());
    assert_eq!(reader.join().unwrap(), EGG_EQUATION);
}

#[cfg(unix)]
#[test]
fn a_result_has_the_permissions_that_the_umask_leaves() {
    use std::os::unix::fs::PermissionsExt;
    let folder = TempDir::new().unwrap();
    let program = assert_cmd::cargo::cargo_bin("stellate");
    let script = format!(
        "umask 027 && '{}' implicitize x -o f.txt",
        program.display()
    );
    let status = std::process::Command::new("sh")
        .current_dir(&folder)
        .args(["-c", &script])
        .status();
    assert!(status.unwrap().success());
    let mode = fs::metadata(folder.path().join("f.txt"))
        .unwrap()
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o640);
}

#[cfg(unix)]
#[test]
fn a_file_that_is_replaced_keeps_its_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("f.txt");
    fs::write(&path, "before").unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o600)).unwrap();
    done_in(folder.path(), &["implicitize", "x", "-o", "f.txt"], "");
    assert_eq!(fs::read_to_string(&path).unwrap(), "x = 0\n");
    let mode = fs::metadata(&path).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o600);
}

#[test]
fn a_form_may_be_a_file_with_comments_or_start_with_a_minus() {
    let folder = TempDir::new().unwrap();
    fs::write(
        folder.path().join("egg"),
        format!("# an egg\n{EGG} # round\n"),
    )
    .unwrap();
    assert_eq!(
        done_in(folder.path(), &["implicitize", "egg"], ""),
        EGG_EQUATION
    );
    assert_eq!(done(&["implicitize", "-x^2 + y"]), "x^2 - y = 0\n");
    assert_eq!(
        piped(&["implicitize", "-"], "x²+y² = 1"),
        "x^2 + y^2 - 1 = 0\n"
    );
}

#[test]
fn a_plot_overlays_outline_series_and_zero_set_with_a_legend() {
    let folder = TempDir::new().unwrap();
    let butterfly = outline("butterfly");
    let at = |arguments: &[&str]| done_in(folder.path(), arguments, "");
    at(&[
        "fit",
        &butterfly,
        "--harmonics",
        "12",
        "--format",
        "json",
        "-o",
        "r.json",
    ]);
    at(&["implicitize", "r.json", "--format", "json", "-o", "f.json"]);
    let forms = [
        "plot",
        butterfly.as_str(),
        "r.json",
        "f.json",
        "--title",
        "A butterfly",
        "-o",
    ];
    assert_eq!(at(&[&forms[..], &["f.svg"]].concat()), "");
    let svg = fs::read_to_string(folder.path().join("f.svg")).unwrap();
    for text in [
        "butterfly.csv",
        "N = 12, r.json",
        "degree 26, f.json",
        "A butterfly",
    ] {
        assert!(svg.contains(text), "the legend lacks {text}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    at(&[&forms[..], &["f.png"]].concat());
    let png = fs::read(folder.path().join("f.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n") && png.ends_with(b"IEND\xaeB`\x82"));
}

#[test]
fn every_verb_helps_with_an_example() {
    for verb in [
        "describe",
        "implicitize",
        "parametrize",
        "fit",
        "sample",
        "plot",
    ] {
        let help = done(&[verb, "--help"]);
        assert!(help.contains(&format!("\n  stellate {verb} ")), "{help}");
    }
    assert!(done(&["--help"]).contains("Example"));
    assert_eq!(
        done(&["--version"]),
        format!("stellate {}\n", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn a_form_without_points_to_fit_a_window_to_is_drawn_in_a_stated_one() {
    let folder = TempDir::new().unwrap();
    for form in ["x^2 + y^2 + 1", "x*y = 0", "x^2 + y^2 = 0"] {
        let run = run_in(folder.path(), &["plot", form, "-o", "f.svg"], "");
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(
            run.err.contains("it shows -1,1,-1,1; --window"),
            "{}",
            run.err
        );
    }
}

#[test]
fn roots_beyond_the_doubles_are_infinite_or_zero() {
    let radii = |form: &str| -> Vec<String> {
        let rows = done(&["sample", form, "--theta", "0"]);
        let field = |row: &str, i: usize| row.split(',').nth(i).unwrap().to_owned();
        rows.lines().skip(1).map(|row| field(row, 4)).collect()
    };
    assert_eq!(radii("x^2 + y^2 = 1e700"), ["inf", "-inf"]);
    assert_eq!(radii("x^3 = 1e1200"), ["inf"]);
    assert_eq!(radii("x^2 + y^2 = 1e600"), ["1e300", "-1e300"]);
    assert_eq!(radii("x^2 + y^2 = 2e-640"), ["1.414e-320", "-1.414e-320"]);
    assert_eq!(radii("x^2 + y^2 = 1e-700"), ["0.0", "-0.0"]);
    // r = 1e309 is beyond the doubles, y = r sin(theta) = 1e304 is not.
    let rows = done(&[
        "sample",
        "x^2 + y^2 = 1e618",
        "--theta",
        "1e-5",
        "--positive",
    ]);
    let row: Vec<&str> = rows.lines().nth(1).unwrap().split(',').collect();
    assert_eq!((row[4], row[5]), ("inf", "inf"));
    let y: f64 = row[6].parse().unwrap();
    assert!((y / 1e304 - 1.0).abs() < 1e-9, "{y}");
}

/// Ranges that are all but empty: their ends differ from multiples of pi/6 by about 10^-1500.
#[test]
fn far_apart_coefficients_do_not_take_memory_by_the_square_of_their_length() {
    let folder = TempDir::new().unwrap();
    let table = "n,cos,sin\n0,1/2,0\n1,0,0\n2,0,0\n3,1/3,1e1500\n";
    fs::write(folder.path().join("table.csv"), table).unwrap();
    let arguments = ["describe", "table.csv", "--stats", "--quiet"];
    let run = run_in(folder.path(), &arguments, "");
    assert_eq!(run.code, 0, "{}", run.err);
    let bytes = json(&run.err)["stats"]["peak_rss_bytes"].clone();
    if let Some(bytes) = bytes.as_u64() {
        assert!(bytes < 100_000_000, "{bytes}");
    }
}
