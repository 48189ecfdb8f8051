//! `stellate paper --out`: one page that needs nothing else.
//!
//! With `STELLATE_BROWSER=chromium` a browser looks at it, too.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::Command;

use crate::common::program::{done_in, run_in};
use roxmltree::{Document, Node, ParsingOptions};
use stellate::paper::{EntryVerdict, entries};
use tempfile::TempDir;

/// The folder of the report, and its page, in the place of an older one.
fn report() -> (TempDir, String) {
    let folder = TempDir::new().unwrap();
    fs::create_dir(folder.path().join("report")).unwrap();
    fs::write(folder.path().join("report/index.html"), "old").unwrap();
    let table = done_in(folder.path(), &["paper", "--out", "report", "--quiet"], "");
    assert!(table.ends_with("; 0 not as expected\n"), "{table}");
    let files = fs::read_dir(folder.path().join("report")).unwrap();
    let names: Vec<_> = files.map(|f| f.unwrap().file_name()).collect();
    assert_eq!(names, ["index.html"]);
    let page = fs::read_to_string(folder.path().join("report/index.html")).unwrap();
    (folder, page)
}

#[test]
fn the_page_is_whole_and_needs_nothing_else() {
    let (_folder, page) = report();
    assert!(page.starts_with("<!DOCTYPE html>"));
    // It is sent by mail and opened on phones.
    assert!(page.len() < 3_000_000, "{} bytes", page.len());
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(&page, options).unwrap();
    let all = || document.descendants().filter(Node::is_element);
    let named = |name: &'static str| all().filter(move |n| n.has_tag_name(name));

    // Links lead somewhere in the page, pictures are in it, and nothing is fetched or run.
    let ids: Vec<&str> = all().filter_map(|n| n.attribute("id")).collect();
    let unique: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(ids.len(), unique.len(), "an id occurs twice");
    for link in named("a") {
        let target = link.attribute("href").unwrap().strip_prefix('#').unwrap();
        assert!(unique.contains(target), "{target}");
    }
    for forbidden in ["script", "link", "iframe", "object", "base"] {
        assert_eq!(named(forbidden).count(), 0, "{forbidden}");
    }
    let style = named("style").next().unwrap().text().unwrap();
    assert!(!style.contains("url(") && !style.contains("@import"));
    assert!(style.contains("prefers-color-scheme: dark") && style.contains("@media print"));

    // For screen readers: one title, headings without a gap, names for regions, words for pictures.
    assert_eq!(named("h1").count(), 1);
    let headings = all().filter_map(|n| n.tag_name().name().strip_prefix('h')?.parse().ok());
    let levels: Vec<u8> = headings.filter(|level| *level <= 6).collect();
    assert!(levels.windows(2).all(|pair| pair[1] <= pair[0] + 1));
    assert_eq!(named("html").next().unwrap().attribute("lang"), Some("en"));
    for table in named("th") {
        assert!(table.has_attribute("scope"));
    }
    let pictures: Vec<Node<'_, '_>> = named("img").collect();
    assert_eq!(pictures.len(), 15);
    for picture in &pictures {
        assert!(picture.attribute("alt").unwrap().len() > 20);
        let source = picture.attribute("src").unwrap();
        let svg = source.strip_prefix("data:image/svg+xml,").unwrap();
        assert!(svg.starts_with("%3Csvg") && svg.is_ascii());
    }

    // Every statement is an article, every figure of the paper has its picture, every erratum its row.
    let entries = entries().unwrap();
    let articles: Vec<&str> = named("article").filter_map(|n| n.attribute("id")).collect();
    let expected: Vec<&str> = entries.iter().map(|e| e.id).collect();
    assert_eq!(articles, expected);
    for number in 1..=14 {
        let id = format!("F{number}");
        let article = named("article")
            .find(|n| n.attribute("id") == Some(&id))
            .unwrap();
        let count = article
            .descendants()
            .filter(|n| n.has_tag_name("img"))
            .count();
        assert_eq!(count, 1, "{id}");
    }
    let errata = entries
        .iter()
        .filter(|e| e.expected != EntryVerdict::Holds)
        .count();
    let rows = named("tbody").next().unwrap().children();
    assert_eq!(rows.filter(|n| n.has_tag_name("tr")).count(), errata);
    // A + B − p/(3s) is typeset.
    assert!(page.contains(
        "<mi>A</mi><mo>+</mo><mi>B</mi><mo>−</mo><mfrac><mrow><mi>p</mi></mrow><mrow><mn>3</mn>"
    ));
}

#[test]
fn a_place_that_cannot_be_is_refused_before_the_work() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("file"), "kept").unwrap();
    fs::create_dir_all(folder.path().join("full/index.html")).unwrap();
    for (out, reason) in [
        ("file", "--out file: that is a file; a folder is wanted"),
        ("no/such/report", "there is no folder no/such"),
        ("full", "that is a folder"),
    ] {
        let run = run_in(folder.path(), &["paper", "--out", out], "");
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{out}");
        assert!(run.err.contains(reason), "{}", run.err);
    }
    let run = run_in(folder.path(), &["paper", "--out", "r", "--only", "T1"], "");
    assert_eq!(run.code, 2, "{}", run.err);
    assert!(!folder.path().join("r").exists());
    assert_eq!(
        fs::read_to_string(folder.path().join("file")).unwrap(),
        "kept"
    );
}

/// What a browser without a window does with the page.
fn browser(program: &str, page: &Path, arguments: &[&str]) -> Vec<u8> {
    let output = Command::new(program)
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--hide-scrollbars",
        ])
        .args(arguments)
        .arg(format!("file://{}", page.display()))
        .output()
        .unwrap();
    assert!(output.status.success(), "{program}");
    output.stdout
}

#[test]
fn a_browser_shows_it() {
    let Some(program) = std::env::var_os("STELLATE_BROWSER") else {
        // Past the capture of the test harness: whoever runs the tests is told.
        let skipped = "skipped: a browser looks at the report with STELLATE_BROWSER=chromium";
        writeln!(std::io::stderr(), "{skipped}").unwrap();
        return;
    };
    let program = program.into_string().unwrap();
    let (folder, _) = report();
    let page = folder.path().join("report/index.html");
    let shown = String::from_utf8(browser(&program, &page, &["--dump-dom"])).unwrap();
    assert_eq!(shown.matches("<article ").count(), entries().unwrap().len());
    // On a phone and on a desk: a picture of the size asked for that is not of one colour.
    for size in ["390,800", "1280,900"] {
        let file = folder.path().join("shot.png");
        let screenshot = format!("--screenshot={}", file.display());
        browser(
            &program,
            &page,
            &[&screenshot, &format!("--window-size={size}")],
        );
        let picture = image::open(&file).unwrap().to_rgb8();
        assert_eq!(format!("{},{}", picture.width(), picture.height()), size);
        let first = *picture.pixels().next().unwrap();
        let others = picture.pixels().filter(|p| **p != first).count();
        assert!(others > 5_000, "{others}");
    }
    let file = folder.path().join("page.pdf");
    let print = format!("--print-to-pdf={}", file.display());
    browser(&program, &page, &[&print]);
    assert!(fs::read(&file).unwrap().starts_with(b"%PDF"));
}
