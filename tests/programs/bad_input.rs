//! Whatever is wrong: the right exit code, one diagnosis, nothing printed, no file left behind.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use tempfile::TempDir;

pub(super) const EGG: &str = "r = 1 + 1/5*cos(t) + 0.1*sin(t)";

/// The names and contents of the files of a folder.
fn listing(folder: &Path) -> Vec<(String, Option<Vec<u8>>)> {
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| {
            let path = entry.unwrap().path();
            (path.display().to_string(), fs::read(&path).ok())
        })
        .collect();
    files.sort();
    files
}

/// Runs the program and checks what holds for every refusal; returns what it said.
pub(super) fn refused_in(folder: &Path, arguments: &[&str], stdin: &[u8], code: i32) -> String {
    let before = listing(folder);
    let output = Command::cargo_bin("stellate")
        .unwrap()
        .current_dir(folder)
        .args(arguments)
        .write_stdin(stdin)
        .output()
        .unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    let shown = format!("{arguments:?} said\n{said}");
    assert_eq!(output.status.code(), Some(code), "{shown}");
    assert_eq!(output.stdout, b"", "{shown}");
    assert!(!said.contains("panicked"), "{shown}");
    let is_diagnosis = |l: &&str| l.starts_with("stellate: ") || l.starts_with("{\"error\"");
    assert_eq!(said.lines().filter(is_diagnosis).count(), 1, "{shown}");
    assert_eq!(listing(folder), before, "{shown}");
    said
}

/// A form that is refused with code 2 and a message that contains `expected`, by every verb.
fn assert_wrong_form(form: &str, expected: &str) {
    let folder = TempDir::new().unwrap();
    for verb in ["implicitize", "describe", "parametrize", "sample"] {
        let said = refused_in(folder.path(), &[verb, form, "-o", "out.json"], b"", 2);
        assert!(said.contains(expected), "{verb} {form}: {said}");
    }
    let said = refused_in(folder.path(), &["plot", "-o", "out.svg", form], b"", 2);
    assert!(said.contains(expected), "plot {form}: {said}");
}

/// A file that is refused; `expected` is part of the message, which also names the file.
fn assert_wrong_file(name: &str, content: &[u8], expected: &str) {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(name), content).unwrap();
    let mut arguments = vec!["implicitize", name, "-o", "out.json"];
    if !name.ends_with(".json") {
        arguments.extend(["--harmonics", "2"]);
    }
    let said = refused_in(folder.path(), &arguments, b"", 2);
    assert!(
        said.contains(name) && said.contains(expected),
        "{name}: {said}"
    );
}

/// A circle of 40 points as rows `x,y`.
pub(super) fn circle() -> Vec<String> {
    let angle = |k: i32| f64::from(k) * std::f64::consts::TAU / 40.0;
    (0..40)
        .map(|k| format!("{},{}", angle(k).cos(), angle(k).sin()))
        .collect()
}

/// A square picture of 24 bits per pixel, black where `dark`.
fn bmp(side: u8, dark: impl Fn(u8, u8) -> bool) -> Vec<u8> {
    let row = (usize::from(side) * 3).div_ceil(4) * 4;
    let mut pixels = Vec::new();
    for y in 0..side {
        let start = pixels.len();
        for x in 0..side {
            pixels.extend([if dark(x, y) { 0 } else { 255 }; 3]);
        }
        pixels.resize(start + row, 0);
    }
    let size = u32::try_from(pixels.len()).unwrap();
    let mut file = b"BM".to_vec();
    for field in [54 + size, 0, 54, 40, side.into(), side.into()] {
        file.extend(u32::to_le_bytes(field));
    }
    file.extend([1, 0, 24, 0]);
    for field in [0, size, 2835, 2835, 0, 0] {
        file.extend(u32::to_le_bytes(field));
    }
    file.extend(pixels);
    file
}

#[test]
fn a_wrong_formula_is_shown_with_a_caret_under_the_place() {
    assert_wrong_form("r = 1 + foo(t)", "<form>:1:9: unknown function `foo`");
    assert_wrong_form("r = 1 + foo(t)", "\n  | r = 1 + foo(t)\n  |         ^\n");
    assert_wrong_form("r = 1/0", "<form>:1:7: division by zero");
    assert_wrong_form("r = 1/(1-1)", "division by zero");
    assert_wrong_form("r = 1 + cos(t", "this `(` is never closed");
    assert_wrong_form("r = cos(t+1)", "integer multiple of the angle");
    assert_wrong_form("r = 1/(2+exp(t))", "not a finite Fourier series");
    assert_wrong_form("r = t", "outside cos( ) and sin( )");
    assert_wrong_form("x^(1/2) + y", "an exponent is an integer");
    assert_wrong_form("x^ + y", "expected an exponent after `^`");
    assert_wrong_form("x = y = 1", "a second `=`");
    assert_wrong_form(
        "x^2 + y^2 < 1",
        "a curve or surface is the boundary, with `=`",
    );
    assert_wrong_form("2 3x", "a number after a factor");
    assert_wrong_form("1e", "the exponent after e needs digits");
    assert_wrong_form("", "there is no equation");
    assert_wrong_form("x - x", "0 = 0");
    assert_wrong_form("7", "no point satisfies it");
    assert_wrong_form("x = 1; x = 2", "a second equation");
}

#[test]
fn a_radius_of_zero_is_a_point_and_not_a_curve() {
    let folder = TempDir::new().unwrap();
    for verb in ["implicitize", "describe", "parametrize", "sample"] {
        let said = refused_in(folder.path(), &[verb, "r = 0*cos(t)"], b"", 2);
        assert!(said.contains("single point"), "{said}");
    }
}

#[test]
fn a_word_among_the_rows_is_pointed_out_by_its_row() {
    let mut rows = circle();
    rows[16] = "hello,3".into();
    assert_wrong_file(
        "c.csv",
        rows.join("\n").as_bytes(),
        "row 17: \"hello\" is not a number",
    );
    // With a header the same row of the file is row 17.
    let mut rows = circle();
    rows[15] = "3,hello".into();
    let with_header = format!("x,y\n{}", rows.join("\n"));
    assert_wrong_file(
        "c.csv",
        with_header.as_bytes(),
        "row 17: \"hello\" is not a number",
    );
}

#[test]
fn rows_that_make_no_outline_are_refused() {
    assert_wrong_file("c.csv", b"", "at least three points");
    assert_wrong_file("c.csv", b"x,y\n", "at least three points");
    assert_wrong_file(
        "c.csv",
        b"0,0\n1,1\n",
        "at least three points; there are two",
    );
    assert_wrong_file("c.csv", b"1,1\n1,1\n1,1\n1,1\n", "at least three points");
    assert_wrong_file("c.csv", b"0,0\n1,1\n2,2\n", "on one line");
    assert_wrong_file(
        "c.csv",
        b"0,0\n1,1\n1,0\n0,1\n",
        "crosses or touches itself",
    );
    assert_wrong_file("c.csv", b"0,0\n1,0\n1\n", "row 3: found 1 column");
    assert_wrong_file("c.csv", b"0,0,0\n1,0,0\n1,1,0\n", "row 1: found 3 columns");
    assert_wrong_file(
        "c.csv",
        b"0,0\nnan,0\n1,1\n",
        "row 2: \"nan\" is not a number",
    );
    assert_wrong_file("c.csv", b"0,0\n1e400,0\n1,1\n", "row 2: 1e400 is too large");
    assert_wrong_file("c.csv", b"0,0\n1e300,0\n1,1\n", "row 2");
    assert_wrong_file(
        "c.csv",
        b"\xff\xfe\x00\x01",
        "UTF-16 text; save it as UTF-8",
    );
    assert_wrong_file("c.csv", b"\xff\x00\x01", "not UTF-8");
}

#[test]
fn a_self_crossing_outline_is_pointed_out_by_the_rows_that_cross() {
    let crossing = b"x,y\n0,0\n1,1\n1,0\n0,1\n";
    assert_wrong_file(
        "c.csv",
        crossing,
        "the edge from row 2 to row 3 meets the edge from row 4 to row 5",
    );
}

#[test]
fn a_picture_without_a_silhouette_is_refused() {
    assert_wrong_file("p.bmp", &bmp(20, |_, _| false), "no silhouette");
    assert_wrong_file("p.bmp", &bmp(1, |_, _| true), "no silhouette");
    assert_wrong_file("p.png", b"", "not a PNG, JPEG");
    assert_wrong_file("p.png", b"\x89PNG\r\n\x1a\nbut not really", "p.png");
    assert_wrong_file("p.jpg", &[0xff, 0xd8, 0xff, 0xe0, 0, 0, 0], "p.jpg");
    let whole = bmp(20, |x, y| (5..15).contains(&x) && (5..15).contains(&y));
    assert_wrong_file("p.bmp", &whole[..whole.len() / 2], "p.bmp");
    // The whole of it is a picture, so it was the missing half that mattered.
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("p.bmp"), &whole).unwrap();
    let fit = ["fit", "p.bmp", "--harmonics", "4"];
    Command::cargo_bin("stellate")
        .unwrap()
        .current_dir(&folder)
        .args(fit)
        .assert()
        .success();
}

#[test]
fn a_document_that_is_none_is_refused() {
    let long = format!(r#"{{"a":{}"#, r#"{"a":"#.repeat(100_000));
    for (content, expected) in [
        (&b"{\"schema\":\"stellate/1\",\"kind\":\"implicit\",\"terms\":["[..], "not a JSON document"),
        (b"{\"schema\":\"stellate/1\",\"kind\":\"banana\"}", "\"banana\" is no form"),
        (b"{\"schema\":\"stellate/1\",\"kind\":\"description\",\"degree\":4}", "is no form"),
        (b"{\"schema\":\"stellate/9\",\"kind\":\"fourier\",\"cos\":[\"1\"],\"sin\":[\"0\"]}", "schema"),
        (b"{\"kind\":\"fourier\",\"cos\":[\"1\"],\"sin\":[\"0\"]}", "no document of stellate"),
        (b"{\"schema\":\"stellate/1\",\"kind\":\"fourier\",\"cos\":[\"1/0\"],\"sin\":[\"0\"]}", "cos[0]"),
        (b"{\"schema\":\"stellate/1\",\"kind\":\"fourier\",\"cos\":[\"1\"],\"sin\":[\"2\"]}", "sin"),
        (b"{\"schema\":\"stellate/1\",\"kind\":\"fourier\",\"cos\":[\"1\",\"2\"],\"sin\":[\"0\"]}", "sin"),
        (b"[1,2]", "1:1"),
        (b"", "there is no equation"),
        (b"\x00\xff\xfe\x80", "not UTF-8"),
        (long.as_bytes(), "not a JSON document"),
    ] {
        assert_wrong_file("d.json", content, expected);
        let folder = TempDir::new().unwrap();
        refused_in(folder.path(), &["implicitize", "-"], content, 2);
    }
}

#[test]
fn a_missing_file_and_a_folder_are_no_forms() {
    let folder = TempDir::new().unwrap();
    fs::create_dir(folder.path().join("sub")).unwrap();
    for name in ["missing.csv", "missing.png", "missing.json", "missing.txt"] {
        let said = refused_in(folder.path(), &["describe", name, "-o", "out.txt"], b"", 2);
        assert!(said.contains(name), "{said}");
    }
    for name in [".", "sub"] {
        let said = refused_in(folder.path(), &["describe", name, "-o", "out.txt"], b"", 2);
        assert!(said.contains("that is a folder"), "{said}");
    }
}

#[test]
fn a_destination_that_cannot_be_is_refused_before_the_work() {
    let folder = TempDir::new().unwrap();
    fs::create_dir(folder.path().join("sub")).unwrap();
    for (destination, expected) in [
        ("missing/out.json", "there is no folder missing"),
        ("sub", "that is a folder"),
    ] {
        let said = refused_in(
            folder.path(),
            &["implicitize", EGG, "-o", destination],
            b"",
            2,
        );
        assert!(said.contains(expected), "{said}");
        // Before even a broken form is read.
        let said = refused_in(
            folder.path(),
            &["implicitize", "x^", "-o", destination],
            b"",
            2,
        );
        assert!(said.contains(expected), "{said}");
    }
    for (arguments, expected) in [
        (&["plot", EGG][..], "plot writes a file"),
        (&["plot", EGG, "-o", "f.pdf"], "a .svg or a .png"),
        (
            &["plot", EGG, "-o", "missing/f.svg"],
            "there is no folder missing",
        ),
    ] {
        let said = refused_in(folder.path(), arguments, b"", 2);
        assert!(said.contains(expected), "{said}");
    }
}

#[test]
fn flags_that_do_not_fit_are_refused() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("c.csv"), circle().join("\n")).unwrap();
    for (arguments, expected) in [
        (
            &["fit", "c.csv"][..],
            "--harmonics N, --tolerance E or --distance E",
        ),
        (
            &["fit", "c.csv", "--harmonics", "2", "--tolerance", "1"],
            "cannot be used with",
        ),
        (
            &["fit", "c.csv", "--harmonics", "20", "--samples", "40"],
            "at least 41 samples",
        ),
        (
            &["fit", "c.csv", "--harmonics", "2", "--samples", "0"],
            "at least 5 samples",
        ),
        (
            &["fit", "c.csv", "--harmonics", "two"],
            "--harmonics two: expected a whole number",
        ),
        (&["fit", "c.csv", "--tolerance", "0"], "greater than 0"),
        (&["fit", "c.csv", "--tolerance", "nan"], "greater than 0"),
        (
            &["fit", "c.csv", "--harmonics", "2", "--center", "1"],
            "--center 1: expected",
        ),
        (
            &["fit", "c.csv", "--harmonics", "2", "--center", "5,5"],
            "not inside the outline",
        ),
        (
            &["fit", "c.csv", "--harmonics", "2", "--format", "singular"],
            "Singular",
        ),
        (&["fit", EGG, "--harmonics", "2"], "fit needs a contour"),
        (
            &["implicitize", EGG, "--harmonics", "2"],
            "--harmonics is for contours",
        ),
        (
            &["implicitize", EGG, "--center", "0,0"],
            "--center is for contours",
        ),
        (
            &["implicitize", EGG, "--format", "yaml"],
            "--format yaml: expected one of",
        ),
        (
            &["implicitize", EGG, "--scale", "large"],
            "--scale large: expected one of",
        ),
        (&["implicitize", EGG, "--digits", "-1"], "--digits -1"),
        (&["implicitize", EGG, "--time-limit", "nan"], "--time-limit"),
        (
            &["implicitize", EGG, "--threads", "0"],
            "at least one thread",
        ),
        (&["implicitize", EGG, "--no-such-flag"], "--no-such-flag"),
        (&["implicitize", EGG, EGG], "takes one form"),
        (&["implicitize"], "required"),
        (&["frobnicate", EGG], "frobnicate"),
        (&["describe", EGG, "--format", "latex"], "text or json"),
        (&["sample", EGG, "--format", "maple"], "csv or json"),
        (&["sample", EGG, "--directions", "0"], "at least one"),
        (&["sample", EGG, "--theta", "north"], "--theta north"),
        (
            &["sample", "x = t; y = t; z = t^2"],
            "this is a curve in space",
        ),
        (
            &["implicitize", "superquadric 2d a=1,2 e=3"],
            "does not apply",
        ),
        (
            &[
                "plot",
                "x = t; y = t; z = t^2",
                "x + y + z",
                "-o",
                "f.svg",
                "--point",
                "1",
            ],
            "X,Y,Z",
        ),
        (
            &["plot", EGG, "-o", "f.svg", "--window", "1,0,0,1"],
            "--window 1,0,0,1",
        ),
        (
            &["plot", EGG, "-o", "f.svg", "--window", "0,1,0"],
            "--window 0,1,0",
        ),
        (
            &["plot", EGG, "-o", "f.svg", "--harmonics", "3"],
            "--harmonics is for contours",
        ),
    ] {
        let said = refused_in(folder.path(), arguments, b"", 2);
        assert!(said.contains(expected), "{arguments:?}: {said}");
    }
}
