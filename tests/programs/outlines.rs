//! Outlines from the files that people have: pictures with holes and frames, masks of labels, cut files, tables of all kinds.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use crate::common::program::{Run, done, json, rational, run_in, strings};

fn file(name: &str) -> String {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    root.join("tests/outlines")
        .join(name)
        .to_str()
        .unwrap()
        .to_owned()
}

/// a0 and the center of a fit.
fn mean_and_center(arguments: &[&str]) -> (f64, [f64; 2]) {
    let document = json(&done(
        &[
            &["fit", "-n", "8", "--format", "json", "--quiet"],
            arguments,
        ]
        .concat(),
    ));
    let value = |text: &str| -> f64 {
        let exact = rational(text);
        let double = |n: &num_bigint::BigInt| n.to_string().parse::<f64>().unwrap();
        double(exact.numer()) / double(exact.denom())
    };
    let center = strings(&document["center"]);
    let a0 = &strings(&document["cos"])[0];
    (value(a0), [value(&center[0]), value(&center[1])])
}

#[test]
fn a_comb_shaped_hole_is_not_the_outline() {
    let (a0, _) = mean_and_center(&[&file("comb_hole.png")]);
    assert!((a0 - 13.5).abs() < 0.2, "{a0}");
}

#[test]
fn a_mask_of_16_bits_is_read() {
    let (a0, _) = mean_and_center(&[&file("label16.png")]);
    assert!(a0 > 5.0, "{a0}");
}

#[test]
fn a_cut_jpeg_is_an_error_and_the_whole_one_is_read() {
    let (a0, [x, y]) = mean_and_center(&[&file("whole.jpg")]);
    assert!(
        (a0 - 48.99).abs() < 0.01 && (x - 95.08).abs() < 0.01 && (y - 104.09).abs() < 0.01,
        "{a0} ({x}, {y})"
    );
    let run = run_in(
        Path::new("."),
        &["fit", &file("truncated99.jpg"), "-n", "8"],
        "",
    );
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(
        run.err
            .contains("truncated99.jpg: the JPEG picture is damaged or ends in the middle"),
        "{}",
        run.err
    );
}

/// Runs `fit` on a file of this name and text.
fn fitted(name: &str, text: impl AsRef<[u8]>) -> Run {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(name), text).unwrap();
    run_in(
        folder.path(),
        &["fit", name, "-n", "2", "--decimals", "3"],
        "",
    )
}

#[test]
fn tables_of_all_kinds_give_the_same_outline() {
    let points: Vec<[f64; 2]> = (0..24)
        .map(|k| {
            let t = f64::from(k) * std::f64::consts::TAU / 24.0;
            let r = 2.0 + 0.5 * t.cos() + 0.25 * (2.0 * t).sin();
            [r * t.cos(), r * t.sin()]
        })
        .collect();
    let rows = |row: &dyn Fn(usize, &str, &str) -> String| -> String {
        let rows = points
            .iter()
            .enumerate()
            .map(|(k, [x, y])| row(k, &format!("{x:.6}"), &format!("{y:.6}")));
        rows.collect::<Vec<_>>().join("\n")
    };
    let comma = |text: &str| text.replace('.', ",");
    let expected = fitted("outline.csv", rows(&|_, x, y| format!("{x},{y}")));
    assert_eq!(expected.code, 0, "{}", expected.err);
    for (name, text) in [
        (
            "header.csv",
            format!("x,y\n{}", rows(&|_, x, y| format!("{x},{y}"))),
        ),
        (
            "swapped.csv",
            format!("y,x\n{}", rows(&|_, x, y| format!("{y},{x}"))),
        ),
        (
            "places.csv",
            format!("lat,lon\n{}", rows(&|_, x, y| format!("{y},{x}"))),
        ),
        ("semicolon.csv", rows(&|_, x, y| format!("{x};{y}"))),
        (
            "german.csv",
            format!(
                "X;Y\n{}",
                rows(&|_, x, y| format!("{};{}", comma(x), comma(y)))
            ),
        ),
        ("tab.tsv", rows(&|_, x, y| format!("{x}\t{y}"))),
        ("blanks.dat", rows(&|_, x, y| format!("  {x}   {y}"))),
        (
            "blanks.xy",
            rows(&|_, x, y| format!("{} {}", comma(x), comma(y))),
        ),
        ("text.txt", rows(&|_, x, y| format!("{x} {y}"))),
        (
            "text.txt",
            format!("x y\n{}", rows(&|_, x, y| format!("{x} {y}"))),
        ),
        (
            "frame.csv",
            format!(",x,y\n{}", rows(&|k, x, y| format!("{k},{x},{y}"))),
        ),
        (
            "id.csv",
            format!(
                "id,t,x_px,y_px\n{}",
                rows(&|k, x, y| format!("{k},0,{x},{y}"))
            ),
        ),
        ("trailing.csv", rows(&|_, x, y| format!("{x},{y},"))),
        ("crlf.csv", rows(&|_, x, y| format!("{x},{y}\r"))),
    ] {
        let found = fitted(name, &text);
        assert_eq!(
            (found.code, &found.out),
            (0, &expected.out),
            "{name}: {}\n{}",
            found.err,
            &text[..60]
        );
    }
}

#[test]
fn tables_that_are_no_outline_are_named_for_what_they_are() {
    let utf16: Vec<u8> = "x,y\n1,2\n"
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    for (name, text, part) in [
        (
            "polar.csv",
            "theta,r\n0,1\n1,2\n".as_bytes().to_vec(),
            "the columns are angles and radii",
        ),
        (
            "three.csv",
            "1,2,3\n4,5,6\n".into(),
            "found 3 columns; each row must be x,y",
        ),
        (
            "names.csv",
            "a,b,c\n1,2,3\n".into(),
            "none of the columns a,b,c is named x",
        ),
        (
            "short.csv",
            "id,x,y\n1,2,3\n4,5\n".into(),
            "row 3: found 2 columns; the first row names 3",
        ),
        (
            "word.tsv",
            "1\t2\n3\tb\n".into(),
            "row 2: \"b\" is not a number",
        ),
        (
            "utf16.csv",
            [vec![0xff, 0xfe], utf16].concat(),
            "this is UTF-16 text; save it as UTF-8",
        ),
        ("page.pdf", "%PDF-1.4".into(), "files .pdf are not read"),
    ] {
        let run = fitted(name, text);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{name}");
        assert!(
            run.err.contains(part) && run.err.contains(name),
            "{name}: {}",
            run.err
        );
    }
}

#[test]
fn options_of_pictures_belong_to_pictures() {
    for option in [&["--blob", "2"][..], &["--threshold", "100"], &["--invert"]] {
        let arguments = [&["implicitize", "r = 1"][..], option].concat();
        let run = run_in(Path::new("."), &arguments, "");
        assert_eq!(run.code, 2);
        assert!(run.err.contains("is for pictures"), "{}", run.err);
    }
    let run = run_in(
        Path::new("."),
        &["fit", &file("whole.jpg"), "-n", "8", "--blob", "2"],
        "",
    );
    assert!(
        run.code == 2 && run.err.contains("the silhouette has 1 part"),
        "{}",
        run.err
    );
}
