//! The center of a fit, and the fits of many outlines.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use crate::common::pictures::Drawing;
use crate::common::program::{done, done_in, json, number, outline, run_in, strings};

/// A silhouette, anti-aliased, of the points within r(θ) of a center.
fn silhouette(radius: impl Fn(f64) -> f64, [x0, y0]: [f64; 2]) -> Drawing {
    const PARTS: u32 = 4;
    Drawing::grey([256, 256], |column, row| {
        let outside = (0..PARTS * PARTS).filter(|k| {
            let part = |n: u32| (f64::from(n) + 0.5) / f64::from(PARTS);
            let x = f64::from(column) + part(k % PARTS) - x0;
            let y = f64::from(row) + part(k / PARTS) - y0;
            x.hypot(y) >= radius(y.atan2(x))
        });
        let parts = u8::try_from(outside.count()).unwrap();
        parts.saturating_mul(16)
    })
}

fn center_of(folder: &Path, name: &str) -> [f64; 2] {
    let document = json(&done_in(
        folder,
        &["fit", name, "-n", "8", "--format", "json", "--quiet"],
        "",
    ));
    let center = strings(&document["center"]);
    [0, 1].map(|i| number(&center[i]))
}

/// The noise of a JPEG does not move the center.
#[test]
fn a_jpeg_has_the_center_of_the_png() {
    let folder = TempDir::new().unwrap();
    type Shape = (&'static str, fn(f64) -> f64);
    let shapes: [Shape; 4] = [
        ("egg", |t| 80.0 + 20.0 * t.cos()),
        ("star", |t| 70.0 + 30.0 * (5.0 * t).cos()),
        ("flower", |t| 75.0 + 22.0 * (7.0 * t + 1.0).sin()),
        // Two lobes: the centroid sees everything, but almost along the outline.
        ("bow", |t| 60.0 + 45.0 * (2.0 * t).cos()),
    ];
    for (name, radius) in shapes {
        let picture = silhouette(radius, [125.3, 131.7]);
        let save = |file: &str| folder.path().join(file);
        fs::write(save(&format!("{name}.png")), picture.png()).unwrap();
        let plain = center_of(folder.path(), &format!("{name}.png"));
        for quality in [95, 75, 50, 30, 10] {
            let file = format!("{name}-{quality}.jpg");
            fs::write(save(&file), picture.jpeg(quality)).unwrap();
            let found = center_of(folder.path(), &file);
            let off = f64::hypot(found[0] - plain[0], found[1] - plain[1]);
            let allowed = if quality >= 30 { 0.5 } else { 2.0 };
            assert!(off <= allowed, "{file}: {found:?} beside {plain:?}");
        }
    }
}

#[test]
fn the_center_can_be_chosen() {
    let jet = outline("jet");
    let hidden = |choice: &str| {
        let arguments = [
            "fit", &jet, "-n", "4", "--center", choice, "--format", "json", "--quiet",
        ];
        json(&done(&arguments))["hidden_share"].as_f64().unwrap()
    };
    assert!(hidden("best") < hidden("auto"));
    assert!((hidden("auto") - hidden("centroid")).abs() < 1e-12);
    let run = run_in(
        Path::new("."),
        &["fit", &jet, "-n", "4", "--center", "kernel"],
        "",
    );
    assert_eq!(run.code, 2);
    assert!(
        run.err
            .contains("no point was found that sees the whole outline"),
        "{}",
        run.err
    );
    let butterfly = outline("butterfly");
    let run = run_in(
        Path::new("."),
        &[
            "fit", &butterfly, "-n", "4", "--center", "kernel", "--format", "json",
        ],
        "",
    );
    assert_eq!(json(&run.out)["outline_star_shaped"], true, "{}", run.err);
}

/// Several files are rows of one table, also with different numbers of harmonics.
#[test]
fn fits_of_several_files_are_a_table() {
    let (jet, butterfly) = (outline("jet"), outline("butterfly"));
    let table = done(&[
        "fit",
        &butterfly,
        &jet,
        "--model",
        "elliptic",
        "--distance",
        "100",
    ]);
    let rows: Vec<Vec<&str>> = table
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(rows.len(), 3);
    assert_eq!(
        rows[0][..17].join(","),
        "file,blob,model,harmonics,degree,center_x,center_y,max_radial_error,distance_low,distance_high,overlap,\
         hidden_share,star_shaped,x_cos_0,x_sin_0,y_cos_0,y_sin_0"
    );
    for (row, file) in rows[1..].iter().zip([&butterfly, &jet]) {
        assert_eq!((row[0], row[1], row[2]), (file.as_str(), "1", "elliptic"));
        assert_eq!(row.len(), rows[0].len());
        let n: usize = row[3].parse().unwrap();
        assert_eq!(row[4], (2 * n).to_string());
        assert!(row[9].parse::<f64>().unwrap() <= 100.0);
        // The last coefficients of the row, and none behind them.
        let used = row[13..].iter().filter(|field| !field.is_empty()).count();
        assert_eq!(used, 4 * (n + 1));
    }
    let radii = done(&["fit", &butterfly, &jet, "-n", "5", "--quiet"]);
    let row: Vec<&str> = radii.lines().nth(2).unwrap().split(',').collect();
    assert_eq!(
        (row[2], row[3], row[4], row[12]),
        ("radius", "5", "12", "true")
    );
    assert!(
        row[11].parse::<f64>().unwrap() > 0.1,
        "the hidden share of the jet"
    );
    // The rows hold what a single fit says.
    let single = json(&done(&[
        "fit", &jet, "-n", "5", "--format", "json", "--quiet",
    ]));
    let low: f64 = row[8].parse().unwrap();
    assert!((single["distance"]["low"].as_f64().unwrap() - low).abs() <= 0.0);
    let run = run_in(
        Path::new("."),
        &["fit", &jet, &butterfly, "-n", "5", "--format", "json"],
        "",
    );
    assert_eq!(run.code, 2);
    assert!(
        run.err
            .contains("the fits of several outlines are written as csv"),
        "{}",
        run.err
    );
}

/// Every blob of a picture has a row; what cannot be fitted is named.
#[test]
fn all_outlines_of_a_picture_have_rows() {
    let folder = TempDir::new().unwrap();
    let mut picture = silhouette(|_| 60.0, [80.0, 128.0]);
    let other = silhouette(|_| 30.0, [200.0, 128.0]);
    for (value, other) in picture.bytes.iter_mut().zip(other.bytes) {
        *value = other.min(*value);
    }
    fs::write(folder.path().join("two.png"), picture.png()).unwrap();
    let table = done_in(folder.path(), &["fit", "two.png", "--all", "-n", "2"], "");
    let rows: Vec<Vec<&str>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').collect())
        .collect();
    let number = |text: &str| text.parse::<f64>().unwrap();
    assert_eq!(rows.len(), 2);
    for (k, (row, (x, radius))) in rows.iter().zip([(80.0, 60.0), (200.0, 30.0)]).enumerate() {
        assert_eq!((row[0], row[1]), ("two.png", (k + 1).to_string().as_str()));
        assert!(
            (number(row[5]) - x).abs() < 0.2 && (number(row[13]) - radius).abs() < 0.2,
            "{row:?}"
        );
    }
}
