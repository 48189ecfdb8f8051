//! Drawings in SVG.

use super::*;
use crate::fit::OutlineOptions;
use crate::shape::Contour;
use std::f64::consts::PI;

fn rings(body: &str) -> Result<Rings> {
    let text = format!(r#"<svg xmlns="{SVG}" viewBox="0 0 100 60">{body}</svg>"#);
    read_drawing(&text, "a.svg")
}

fn taken(body: &str) -> (Contour, LeftOut) {
    rings(body)
        .unwrap()
        .outline(0, &OutlineOptions::default(), "a.svg")
        .unwrap()
}

fn message(body: &str) -> String {
    rings(body).unwrap_err().to_string()
}

#[test]
fn a_polygon_keeps_its_digits_and_y_points_up() {
    let expected = [[10.1, 10.0], [30.0, 10.0], [30.0, 50.0]];
    for body in [
        r#"<polygon points="10.1,50 30,50 30 10"/>"#,
        r#"<polyline points="10.1,50 30,50 30 10 10.1 50"/>"#,
        r#"<path d="M10.1 50H30V10z"/>"#,
        r#"<path d="M 10.1,50 l 19.9,0 0,-40 -19.9,40"/>"#,
        r#"<g transform="translate(10 0)"><a><path transform="scale(1,2)" d="M.1 25H20V5z"/></a></g>"#,
        r##"<defs><path id="p" d="M.1 50H20V10z"/></defs><use href="#p" x="10"/>"##,
        r##"<symbol id="p" viewBox="0 0 10 10"><path d="M.01 5H2V1z"/></symbol><use href="#p" x="10" width="100" height="100"/>"##,
        r#"<svg x="10" width="50" height="60" viewBox="0 0 5 6"><path d="M.01 5H2V1z"/></svg>"#,
    ] {
        let (outline, _) = taken(body);
        let points = outline.points();
        assert_eq!(points.len(), 3, "{body}");
        for p in expected {
            let near = |q: &[f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]) < 1e-13;
            assert!(points.iter().any(near), "{body}: {points:?}");
        }
    }
    let exact = taken(r#"<polygon points="10.1,50 30,50 30 10"/>"#).0;
    assert_eq!(exact.points(), expected);
}

#[test]
fn the_range_of_y_stays_that_of_the_view_box() {
    let box_of = |attributes: &str| {
        let text = format!("<svg {attributes}><path d='M-1 -2H3V1z'/></svg>");
        let mut rings = read_drawing(&text, "a.svg").unwrap();
        rings
            .outline(0, &OutlineOptions::default(), "a")
            .unwrap()
            .0
            .bounding_box()
    };
    assert_eq!(box_of("viewBox='-5 -5 10 10'"), [[-1.0, -1.0], [3.0, 2.0]]);
    assert_eq!(box_of("viewBox='0 0 9 20'"), [[-1.0, 19.0], [3.0, 22.0]]);
    assert_eq!(
        box_of("width='9' height='15pt'"),
        [[-1.0, 19.0], [3.0, 22.0]]
    );
    assert_eq!(box_of("width='100%'"), [[-1.0, -1.0], [3.0, 2.0]]);
}

#[test]
fn basic_shapes_have_their_areas() {
    for (body, area) in [
        (r#"<circle cx="50" cy="30" r="20"/>"#, 400.0 * PI),
        (r#"<ellipse cx="50%" cy="30" rx="20" ry="10"/>"#, 200.0 * PI),
        (r#"<rect x="10" y="10" width="30" height="20"/>"#, 600.0),
        (
            r#"<rect x="10" y="10" width="30" height="20" rx="4"/>"#,
            600.0 - 16.0 * (4.0 - PI),
        ),
        (
            r#"<circle r="20" transform="rotate(30) scale(2 1)"/>"#,
            800.0 * PI,
        ),
        (
            r#"<path d="M10 30a20 20 0 0 0 40 0a20 20 0 0 0-40 0"/>"#,
            400.0 * PI,
        ),
        (r#"<path d="M0 0A25 10 30 1 1 0 1z"/>"#, 250.0 * PI),
    ] {
        let (outline, _) = taken(body);
        assert!(
            (outline.area() / area - 1.0).abs() < 1e-3,
            "{body}: {}",
            outline.area()
        );
    }
    // The first quarter goes from the right to the bottom.
    let (outline, _) = taken(r#"<rect width="9" height="5" rx="2" ry="1"/>"#);
    assert_eq!(outline.bounding_box(), [[0.0, 55.0], [9.0, 60.0]]);
}

#[test]
fn holes_backgrounds_and_open_paths_are_left_out() {
    let (outline, left_out) = taken(
        r#"<rect width="100%" height="100%"/><path d="M0 0L9 9"/><path d="M1 1H2V2z"/>
           <path d="M10 10H40V40H10z M20 20H30V30H20z M22 22H28V28H22z"/>"#,
    );
    assert_eq!(outline.bounding_box(), [[10.0, 20.0], [40.0, 50.0]]);
    let LeftOut {
        parts,
        holes,
        open,
        background,
        ..
    } = left_out;
    assert_eq!((parts, holes, open, background), (2, 1, 1, true));
    // If there is nothing else, the rectangle is the outline.
    let (outline, left_out) = taken(r#"<rect width="100" height="60"/>"#);
    assert_eq!(outline.bounding_box(), [[0.0, 0.0], [100.0, 60.0]]);
    assert!(left_out.is_nothing());
    let (_, left_out) = taken(
        r#"<g style="display: none"><path d="M1 1H2V2z"/></g><clipPath><path d="M1 1H2V2z"/></clipPath>
           <path d="M10 10H40V40H10z"/><x:path xmlns:x="other" d="M1 1H2V2z"/>"#,
    );
    assert!(left_out.is_nothing());
}

#[test]
fn what_is_no_outline_is_named() {
    for (body, part) in [
        ("", "the drawing has no closed path"),
        (
            r#"<path d="M0 0L9 9 9 0"/><text>A</text><image/>"#,
            "no closed path; it has one open path, one text, one picture",
        ),
        (r#"<path d="M0 0L9"/>"#, "a.svg, row 1, <path>"),
        (r#"<polygon points="0 0 1"/>"#, "the last point has no y"),
        (r#"<circle r="1em"/>"#, "depends on a font"),
        (r#"<circle r="x"/>"#, "is no length"),
        (r#"<g transform="turn(3)"/>"#, "is no transform"),
        (r##"<use id="u" href="#u"/>"##, "in a circle"),
        (r#"<path d="M0 0H1e400V1z"/>"#, "a.svg"),
        ("<g>", "this cannot be read as SVG"),
    ] {
        let message = message(body);
        assert!(message.contains(part), "{body}: {message}");
    }
    let html = read_drawing("<html/>", "a.svg").unwrap_err().to_string();
    assert!(html.contains("the root <html>, no SVG drawing"), "{html}");
}

#[test]
fn depth_and_uses_are_bounded() {
    let deep = "<g>".repeat(100_000) + r#"<path d="M1 1H2V2z"/>"# + &"</g>".repeat(100_000);
    assert!(taken(&deep).0.len() == 3);
    // Each group uses the one before ten times.
    let mut body = r#"<defs><path id="u0" d="M1 1H2V2z"/>"#.to_owned();
    for k in 0..8 {
        let uses = format!(r##"<use href="#u{k}"/>"##).repeat(10);
        body.push_str(&format!(r#"<g id="u{}">{uses}</g>"#, k + 1));
    }
    body.push_str(r##"</defs><use href="#u8"/>"##);
    assert!(message(&body).contains("limit reached: a.svg has more than"));
}

/// Styles move and hide shapes as attributes do.
#[test]
fn styles_say_what_is_drawn_and_where() {
    let rect = r#"<rect x="10" y="20" width="10" height="10""#;
    let small = r#"<circle cx="80" cy="20" r="2"/>"#;
    for (body, expected) in [
        (
            format!(r#"{rect} transform="rotate(90)" transform-origin="20 30"/>"#),
            [20.0, 30.0, 30.0, 40.0],
        ),
        (
            format!(r#"{rect} style="transform: scale(2,1); fill: red"/>"#),
            [20.0, 40.0, 30.0, 40.0],
        ),
        (
            format!(r#"{rect} style="transform:translate(10px,0px)"/>"#),
            [20.0, 30.0, 30.0, 40.0],
        ),
        (
            format!(
                r#"<style>.a{{transform:rotate(180deg);transform-origin:20px 20px}}</style>{rect} class="b a"/>"#
            ),
            [20.0, 30.0, 40.0, 50.0],
        ),
        (
            format!(r#"<style>.a{{display:none}}</style>{rect} class="a"/>{small}"#),
            [78.0, 82.0, 38.0, 42.0],
        ),
        (
            format!(
                r#"<style>g rect{{display:none}} #r{{display:inline}}</style><g>{rect} id="r"/></g>{small}"#
            ),
            [10.0, 20.0, 30.0, 40.0],
        ),
        (
            format!(r#"{rect} visibility="hidden"/>{small}"#),
            [78.0, 82.0, 38.0, 42.0],
        ),
        (
            format!(r#"<g style="opacity:0">{rect}/></g>{small}"#),
            [78.0, 82.0, 38.0, 42.0],
        ),
        (
            format!(r#"{rect} opacity=" 0 "/>{small}"#),
            [78.0, 82.0, 38.0, 42.0],
        ),
        (
            format!(r#"{rect} style="fill:none"/>{small}"#),
            [78.0, 82.0, 38.0, 42.0],
        ),
        (
            format!(r#"<g fill="none" stroke="none">{rect}/></g>{small}"#),
            [78.0, 82.0, 38.0, 42.0],
        ),
        (
            format!(r#"{rect} fill="rgba(1, 2, 3, 0)"/>{small}"#),
            [78.0, 82.0, 38.0, 42.0],
        ),
        (
            format!(r#"{rect} fill-opacity="0" stroke="red" stroke-width="0px"/>{small}"#),
            [78.0, 82.0, 38.0, 42.0],
        ),
        (
            format!(r#"<style>.b{{fill:none; stroke:#000}}</style>{rect} class="b"/>{small}"#),
            [10.0, 20.0, 30.0, 40.0],
        ),
        (
            format!(r#"<g fill="none">{rect} fill="url(#a)"/></g>{small}"#),
            [10.0, 20.0, 30.0, 40.0],
        ),
        (
            format!(r#"{rect} opacity="0.5"/>{small}"#),
            [10.0, 20.0, 30.0, 40.0],
        ),
        (
            format!(
                r#"<switch><g systemLanguage="tlh">{rect}/></g><g systemLanguage="de, en-GB">{small}</g><circle r="90"/></switch>"#
            ),
            [78.0, 82.0, 38.0, 42.0],
        ),
        (
            format!(
                r#"<g visibility="hidden">{rect} style="visibility:visible"/><circle r="90"/></g>{small}"#
            ),
            [10.0, 20.0, 30.0, 40.0],
        ),
    ] {
        let (contour, _) = taken(&body);
        let ends = |axis: usize| {
            let all = contour.points().iter().map(|p| p[axis]);
            let low = all.clone().fold(f64::INFINITY, f64::min);
            [low, all.fold(f64::NEG_INFINITY, f64::max)]
        };
        let found = [ends(0), ends(1)].concat();
        let is_near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-3;
        assert!(
            found.iter().zip(&expected).all(is_near),
            "{body}: {found:?}"
        );
    }
    for (body, part) in [
        (
            format!(r#"{rect} style="rotate: 3deg"/>"#),
            "the property rotate of a style is not read",
        ),
        (
            format!(r#"{rect} transform="scale(2)" transform-origin="center"/>"#),
            "expected two lengths in px",
        ),
        (
            r#"<path d="M0 0L10 10L10 0L0 10z"/>"#.to_owned(),
            "one closed path whose signed area is 0",
        ),
    ] {
        let message = message(&body);
        assert!(message.contains(part), "{body}: {message}");
    }
}
