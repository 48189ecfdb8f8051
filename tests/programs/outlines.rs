//! Outlines from the files that people have: pictures with holes and frames, masks of labels, cut files, tables of all kinds.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use stellate::verb::{Content, Given, ReadOptions};
use tempfile::TempDir;

use crate::common::program::{Run, done, json, number, run_in, strings};

pub(super) fn file(name: &str) -> String {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    root.join("tests/outlines")
        .join(name)
        .to_str()
        .unwrap()
        .to_owned()
}

/// a0 and the center of a fit.
pub(super) fn mean_and_center(arguments: &[&str]) -> (f64, [f64; 2]) {
    let document = json(&done(
        &[
            &["fit", "-n", "8", "--format", "json", "--quiet"],
            arguments,
        ]
        .concat(),
    ));
    let center = strings(&document["center"]);
    let a0 = &strings(&document["cos"])[0];
    (number(a0), [number(&center[0]), number(&center[1])])
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
        (
            "missing.csv",
            "x,y\n1,2\n3,NaN\n".into(),
            "row 3: \"NaN\" is not a number, and an outline has no gaps; leave this row out",
        ),
        ("page.pdf", "%PDF-1.4".into(), "this is a PDF document"),
        ("a.npz", "PK".into(), "numpy.save(\"outline.npy\", array)"),
        ("a.kml", "<kml/>".into(), "ogr2ogr -f GeoJSON"),
        ("a.dxf", "0\nSECTION\n".into(), "a CAD drawing (DXF or DWG)"),
        (
            "a.xlsx",
            "PK".into(),
            "save the sheet with the columns x and y as .csv",
        ),
        (
            "kml.txt",
            "<kml></kml>".into(),
            "a map of places (KML, GPX or GML)",
        ),
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
    for form in ["r = 1", &file("whole.jpg"), &file("a.geojson")] {
        let run = run_in(
            Path::new("."),
            &["implicitize", form, "--columns", "1,2"],
            "",
        );
        assert_eq!(run.code, 2);
        assert!(
            run.err.contains("--columns is for tables of points"),
            "{}",
            run.err
        );
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

#[test]
fn columns_are_chosen_by_name_or_by_number() {
    let folder = TempDir::new().unwrap();
    let rows = "id,u,v,name\n1,0,0,\"a, b\"\n2,4,0,c\n3,4.5,2,d\n4,4,4,e\n5,0,4,\n";
    fs::write(folder.path().join("table.csv"), rows).unwrap();
    fs::write(
        folder.path().join("points.csv"),
        "0,0\n4,0\n4.5,2\n4,4\n0,4\n",
    )
    .unwrap();
    let fit = |arguments: &[&str]| {
        let all = [&["fit", "-n", "2"][..], arguments].concat();
        let run = run_in(folder.path(), &all, "");
        (run.code, run.out, run.err)
    };
    let (code, expected, err) = fit(&["points.csv"]);
    assert_eq!(code, 0, "{err}");
    for columns in ["2,3", "u,v", "U, V", "2,v"] {
        let (code, out, err) = fit(&["table.csv", "--columns", columns]);
        assert_eq!((code, &out), (0, &expected), "{columns}: {err}");
    }
    for (columns, part) in [
        (
            "u,w",
            "row 2: --columns: no column is named w; the columns are id,u,v,name",
        ),
        ("2,7", "there is no column 7; found 4 columns"),
        ("name,v", "row 2: \"a, b\" is not a number"),
        ("2", "expected two names, or numbers from 1"),
    ] {
        let (code, _, err) = fit(&["table.csv", "--columns", columns]);
        assert!(code == 2 && err.contains(part), "{columns}: {err}");
    }
    // Standard input and other verbs take it, too.
    let run = run_in(
        folder.path(),
        &["fit", "-", "-n", "2", "--columns", "2,3"],
        rows,
    );
    assert_eq!((run.code, run.out), (0, expected), "{}", run.err);
    let verb = |verb: &[&str]| {
        let table = ["table.csv", "--columns", "u,v", "--quiet", "-n", "2"];
        run_in(folder.path(), &[verb, &table].concat(), "").code
    };
    assert_eq!(verb(&["describe"]), 0);
    assert_eq!(verb(&["sample", "--directions", "4"]), 0);
    assert_eq!(verb(&["inspect", "--tolerance", "1", "--point", "2,4"]), 0);
}

#[test]
fn polygons_of_geojson_are_outlines() {
    let (a0, [x, y]) = mean_and_center(&[&file("a.geojson")]);
    assert!((a0 - 2.3).abs() < 0.1 && (x - 2.12).abs() < 0.01 && (y - 2.0).abs() < 1e-9);
    let fit = |arguments: &[&str], input: &str| {
        run_in(
            Path::new("."),
            &[&["fit", "-n", "2"][..], arguments].concat(),
            input,
        )
    };
    let islands = file("islands.geojson");
    let run = fit(&[&islands], "");
    assert!(
        run.code == 0
            && run.err.contains(
                "leaves out 1 other polygon, the largest with 1.9 % of the area of the one that is taken \
                 (--blob chooses another one), 1 hole, 1 point or open line"
            ),
        "{}",
        run.err
    );
    assert_ne!(fit(&[&islands, "--blob", "2"], "").out, run.out);
    let third = fit(&[&islands, "--blob", "3"], "");
    assert!(
        third.code == 2 && third.err.contains("there are 2 polygons"),
        "{}",
        third.err
    );
    // The text of it is recognised without the name.
    let again = fit(&["-"], &fs::read_to_string(&islands).unwrap());
    assert_eq!((again.code, again.out), (0, run.out), "{}", again.err);
    let points = r#"{"type":"MultiPoint","coordinates":[[0,0],[1,1]]}"#;
    let run = fit(&["-"], points);
    assert!(
        run.code == 2 && run.err.contains("this is GeoJSON of 2 points"),
        "{}",
        run.err
    );
}

#[test]
fn closed_paths_of_svg_are_outlines() {
    let leaf = file("leaf.svg");
    let run = run_in(Path::new("."), &["fit", &leaf, "-n", "4"], "");
    assert!(
        run.code == 0
            && run.err.contains(
                "leaves out 1 other closed path, the largest with 1.4 % of the area of the one that is taken \
                 (--blob chooses another one), 1 hole, a rectangle that covers the whole drawing, 1 open path"
            ),
        "{}",
        run.err
    );
    // The circle is below on the right.
    let (a0, [x, y]) = mean_and_center(&[&leaf, "--blob", "2"]);
    assert!((a0 - 4.0).abs() < 1e-3 && (x - 110.0).abs() < 1e-3 && (y - 10.0).abs() < 1e-3);
}

#[test]
fn an_array_of_numpy_is_an_outline() {
    let folder = TempDir::new().unwrap();
    let header = "{'descr': '<i4', 'fortran_order': False, 'shape': (5, 1, 2), }\n";
    let mut bytes = b"\x93NUMPY\x01\0".to_vec();
    bytes.extend(u16::try_from(header.len()).unwrap().to_le_bytes());
    bytes.extend(header.as_bytes());
    let points = [[0_i32, 0], [40, 0], [45, 20], [40, 40], [0, 40]];
    bytes.extend(points.iter().flatten().flat_map(|c| c.to_le_bytes()));
    fs::write(folder.path().join("a.npy"), &bytes).unwrap();
    fs::write(folder.path().join("cut.npy"), &bytes[..bytes.len() - 1]).unwrap();
    let rows: Vec<String> = points.iter().map(|[x, y]| format!("{x},{y}")).collect();
    fs::write(folder.path().join("a.csv"), rows.join("\n")).unwrap();
    let fit = |name: &str| run_in(folder.path(), &["fit", name, "-n", "2"], "");
    let (array, table) = (fit("a.npy"), fit("a.csv"));
    assert_eq!((array.code, array.out), (0, table.out), "{}", array.err);
    let cut = fit("cut.npy");
    let part = "an array of shape (5, 1, 2) has 40 bytes of elements; the file has 39";
    assert!(cut.code == 2 && cut.err.contains(part), "{}", cut.err);
}

#[test]
fn all_outlines_of_a_file_are_read_in_order() {
    let all = |name: &str| {
        let found = Given::read_all_with(&file(name), &ReadOptions::default()).unwrap();
        let found: Vec<Given> = found.into_iter().map(Result::unwrap).collect();
        let area = |given: &Given| match given.content() {
            Content::Contour(outline) => outline.area(),
            _ => panic!("{name}: no outline"),
        };
        let areas: Vec<f64> = found.iter().map(area).collect();
        (
            areas,
            found.iter().map(Given::short_name).collect::<Vec<_>>(),
        )
    };
    let (areas, names) = all("islands.geojson");
    assert_eq!(
        names,
        ["islands.geojson, blob 1", "islands.geojson, blob 2"]
    );
    assert!(areas[0] > areas[1] && areas[1] > 0.0);
    let (areas, _) = all("leaf.svg");
    assert!(areas.len() == 2 && (areas[1] - 16.0 * std::f64::consts::PI).abs() < 0.02);
    assert_eq!(all("comb_hole.png").1, ["comb_hole.png"]);
    assert_eq!(all("plain.txt").1, ["plain.txt"]);
    let formula = Given::read_all_with("r = 1", &ReadOptions::default()).unwrap();
    assert_eq!(formula.len(), 1);
}

/// What a small fit takes is subtracted.
#[test]
fn a_million_rows_take_at_most_150_bytes_each() {
    let folder = TempDir::new().unwrap();
    let peak = |count: u32| {
        let rows = (0..count).map(|k| {
            let t = f64::from(k) * std::f64::consts::TAU / f64::from(count);
            let r = 2.0 + 0.5 * t.cos() + 0.25 * (3.0 * t).sin();
            format!("{:.9},{:.9}\n", r * t.cos(), r * t.sin())
        });
        fs::write(folder.path().join("rows.csv"), rows.collect::<String>()).unwrap();
        let fit = ["fit", "rows.csv", "-n", "8", "--quiet", "--stats"];
        let run = run_in(folder.path(), &fit, "");
        assert_eq!(run.code, 0, "{}", run.err);
        json(&run.err)["stats"]["peak_rss_bytes"].as_u64().unwrap()
    };
    let (small, large) = (peak(1000), peak(1_000_000));
    assert!(large - small <= 150_000_000, "{large} - {small}");
}

#[cfg(not(feature = "more-images"))]
#[test]
fn pictures_that_this_build_does_not_read_are_named() {
    for (name, head, kind) in [
        ("a.tif", &b"II*\0\x08\0\0\0"[..], "TIFF"),
        ("a.gif", b"GIF89a\x01\0\x01\0", "GIF"),
        ("a.webp", b"RIFF\x08\0\0\0WEBPVP8L", "WebP"),
    ] {
        let run = fitted(name, head);
        let part = format!(
            "{name}: {kind} pictures are read by stellate with the feature `more-images` only"
        );
        assert!(run.code == 2 && run.err.contains(&part), "{}", run.err);
    }
}
