//! Converts the SVG of a picture to PNG.
//!
//! Pictures have few elements: rectangles, lines, polygons and circles, each with its own style, and text. They are drawn one
//! by one, each in front of those before it; nothing else of SVG is understood.

use std::fmt::Display;
use std::str::FromStr;

use roxmltree::{Document, Node};
use svgtypes::{Color, Length, LengthUnit, PointsParser, ViewBox};
use tiny_skia::{
    FillRule, IntSize, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Rect, Shader, Stroke,
    Transform,
};

use super::glyphs::letters;
use crate::error::{Error, Result};

/// Renders the SVG of a picture as a PNG file at `scale` pixels per unit.
///
/// # Errors
/// [`Error::Limit`] if the picture is too large to be held in memory; [`Error::Data`] if the SVG
/// is malformed or has an element that pictures do not have.
pub(crate) fn png_from_svg(svg: &str, scale: f32) -> Result<Vec<u8>> {
    let document = Document::parse(svg).map_err(|e| broken(&e))?;
    let root = document.root_element();
    let [width, height]: [u32; 2] = [given(root, "width")?, given(root, "height")?];
    let size = IntSize::from_wh(width, height)
        .and_then(|size| size.scale_by(scale))
        .ok_or_else(|| Error::limit("picture size"))?;
    let mut pixels = Pixmap::new(size.width(), size.height())
        .ok_or_else(|| Error::limit(format!("picture size {}x{}", size.width(), size.height())))?;
    let shown: ViewBox = given(root, "viewBox")?;
    let to_pixels = Transform::from_translate(single(-shown.x), single(-shown.y)).post_scale(
        scale * single(f64::from(width) / shown.w),
        scale * single(f64::from(height) / shown.h),
    );
    for element in root.children().filter(Node::is_element) {
        if let Some(path) = path(element)? {
            draw(&mut pixels, element, &path, to_pixels)?;
        }
    }
    pixels.encode_png().map_err(|e| broken(&e))
}

/// The outline of an element; `None` if it has no extent.
fn path(element: Node<'_, '_>) -> Result<Option<Path>> {
    let number = |name: &str| given::<f32>(element, name);
    let name = element.tag_name().name();
    Ok(match name {
        "rect" => {
            let [x, y] = [number("x")?, number("y")?];
            let sides = Rect::from_xywh(x, y, number("width")?, number("height")?);
            sides.map(PathBuilder::from_rect)
        }
        "circle" => PathBuilder::from_circle(number("cx")?, number("cy")?, number("r")?),
        "line" => {
            let mut line = PathBuilder::new();
            line.move_to(number("x1")?, number("y1")?);
            line.line_to(number("x2")?, number("y2")?);
            line.finish()
        }
        "polyline" | "polygon" => {
            let points: String = given(element, "points")?;
            let mut line = PathBuilder::new();
            for (x, y) in PointsParser::from(points.as_str()) {
                match line.is_empty() {
                    true => line.move_to(single(x), single(y)),
                    false => line.line_to(single(x), single(y)),
                }
            }
            if name == "polygon" {
                line.close();
            }
            line.finish()
        }
        "text" => text_path(element)?,
        other => {
            return Err(broken(&format!(
                "pictures have no element <{other}>, so that it is not drawn in PNG"
            )));
        }
    })
}

/// Fills and strokes the outline of an element as its attributes say. An element that is not opaque has either a filling or
/// a stroke, so that its opacity is that of its only colour.
fn draw(
    pixels: &mut Pixmap,
    element: Node<'_, '_>,
    path: &Path,
    to_pixels: Transform,
) -> Result<()> {
    let opacity = optional(element, "opacity")?.unwrap_or(1.0);
    let paint = |color: Color| {
        let mut solid = tiny_skia::Color::from_rgba8(color.red, color.green, color.blue, 255);
        solid.apply_opacity(opacity);
        Paint {
            shader: Shader::SolidColor(solid),
            ..Paint::default()
        }
    };
    let color = |name: &str, default: Option<Color>| -> Result<Option<Color>> {
        match element.attribute(name) {
            Some("none") => Ok(None),
            _ => Ok(optional(element, name)?.or(default)),
        }
    };
    if let Some(fill) = color("fill", Some(Color::black()))? {
        pixels.fill_path(path, &paint(fill), FillRule::Winding, to_pixels, None);
    }
    if let Some(stroke) = color("stroke", None)? {
        let inherited = |name: &str| element.ancestors().find(|node| node.has_attribute(name));
        let is_round =
            |name: &str| inherited(name).and_then(|node| node.attribute(name)) == Some("round");
        let style = Stroke {
            width: match inherited("stroke-width") {
                Some(node) => given(node, "stroke-width")?,
                None => 1.0,
            },
            line_cap: match is_round("stroke-linecap") {
                true => LineCap::Round,
                false => LineCap::Butt,
            },
            line_join: match is_round("stroke-linejoin") {
                true => LineJoin::Round,
                false => LineJoin::Miter,
            },
            ..Stroke::default()
        };
        pixels.stroke_path(path, &paint(stroke), &style, to_pixels, None);
    }
    Ok(())
}

/// The outlines of the letters of a text, at their place.
fn text_path(element: Node<'_, '_>) -> Result<Option<Path>> {
    let size: f32 = given(element, "font-size")?;
    let words: Vec<&str> = element
        .text()
        .unwrap_or_default()
        .split_ascii_whitespace()
        .collect();
    let letters = letters(&words.join(" "), size);
    let before = match element.attribute("text-anchor") {
        Some("end") => letters.width,
        Some("middle") => letters.width / 2.0,
        _ => 0.0,
    };
    let down: Length = given(element, "dy")?;
    let unit = match down.unit {
        LengthUnit::Em => size,
        LengthUnit::Ex => size / 2.0,
        _ => 1.0,
    };
    let [x, y]: [f32; 2] = [given(element, "x")?, given(element, "y")?];
    let turn: svgtypes::Transform = optional(element, "transform")?.unwrap_or_default();
    let [a, b, c, d, e, f] = [turn.a, turn.b, turn.c, turn.d, turn.e, turn.f].map(single);
    let place = Transform::from_translate(x - before, y + single(down.number) * unit)
        .post_concat(Transform::from_row(a, b, c, d, e, f));
    Ok(letters.outlines.and_then(|path| path.transform(place)))
}

/// The value of an attribute that must be there.
fn given<T: FromStr<Err: Display>>(element: Node<'_, '_>, name: &str) -> Result<T> {
    optional(element, name)?.ok_or_else(|| {
        let element = element.tag_name().name();
        broken(&format!("<{element}> has no attribute {name}"))
    })
}

/// The value of an attribute, if it is there.
fn optional<T: FromStr<Err: Display>>(element: Node<'_, '_>, name: &str) -> Result<Option<T>> {
    let Some(text) = element.attribute(name) else {
        return Ok(None);
    };
    let value = text.parse().map_err(|e: T::Err| {
        let element = element.tag_name().name();
        broken(&format!("<{element}>: {name}=\"{text}\": {e}"))
    })?;
    Ok(Some(value))
}

fn broken(error: &dyn Display) -> Error {
    Error::data("figure", error.to_string())
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "pixels need no more digits than a single has"
)]
fn single(value: f64) -> f32 {
    value as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of 100 × 50 units of eight steps each.
    fn drawn(elements: &str) -> Result<Pixmap> {
        let svg = format!(
            "<svg stroke-width=\"4\" width=\"100\" height=\"50\" stroke-linejoin=\"round\" stroke-linecap=\"round\" \
             viewBox=\"0 0 800 400\" xmlns=\"http://www.w3.org/2000/svg\">\n\
             <rect x=\"0\" y=\"0\" width=\"800\" height=\"400\" opacity=\"1\" fill=\"#FFFFFF\" stroke=\"none\"/>\n\
             {elements}\n</svg>\n"
        );
        Ok(Pixmap::decode_png(&png_from_svg(&svg, 2.0)?).unwrap())
    }

    /// Red, green and blue of the pixel at a place in steps.
    fn at(pixels: &Pixmap, x: u32, y: u32) -> [u8; 3] {
        let color = pixels.pixel(x / 4, y / 4).unwrap();
        [color.red(), color.green(), color.blue()]
    }

    /// The columns and rows of pixels that are not white: the first and the last ones.
    fn inked(pixels: &Pixmap) -> Option<[u32; 4]> {
        let places = (0..pixels.height()).flat_map(|y| (0..pixels.width()).map(move |x| (x, y)));
        let is_inked = |&(x, y): &(u32, u32)| pixels.pixel(x, y).unwrap().green() < 200;
        places.filter(is_inked).fold(None, |extent, (x, y)| {
            let [left, top, right, bottom] = extent.unwrap_or([x, y, x, y]);
            Some([left.min(x), top.min(y), right.max(x), bottom.max(y)])
        })
    }

    fn text(anchor: &str, dy: &str, more: &str, letters: &str) -> String {
        format!(
            "<text x=\"400\" y=\"200\" dy=\"{dy}\" text-anchor=\"{anchor}\" font-family=\"sans-serif\" font-size=\"80\" \
             fill=\"#000000\"{more}>\n{letters}\n</text>"
        )
    }

    #[test]
    fn every_element_is_drawn_at_its_place() {
        let pixels = drawn(
            "<rect x=\"80\" y=\"80\" width=\"80\" height=\"80\" opacity=\"0.5\" fill=\"#FF0000\" stroke=\"none\"/>\n\
             <circle cx=\"240\" cy=\"120\" r=\"40\" opacity=\"1\" fill=\"#00FF00\" stroke=\"none\" stroke-width=\"1\"/>\n\
             <line opacity=\"1\" stroke=\"#0000FF\" stroke-width=\"16\" x1=\"320\" y1=\"120\" x2=\"400\" y2=\"120\"/>\n\
             <polyline fill=\"none\" stroke=\"#123456\" stroke-width=\"8\" points=\"440,80 520,80 520,160 \"/>\n\
             <polygon fill=\"#654321\" stroke=\"#FF00FF\" points=\"560,80,640,80,640,160\"/>\n\
             <polyline stroke=\"#00FFFF\" points=\"680,80,760,160\"/>",
        )
        .unwrap();
        assert_eq!((pixels.width(), pixels.height()), (200, 100));
        assert_eq!(at(&pixels, 4, 4), [255; 3]);
        assert_eq!(at(&pixels, 120, 120), [255, 127, 127]);
        assert_eq!(at(&pixels, 240, 120), [0, 255, 0]);
        assert_eq!(at(&pixels, 204, 84), [255; 3]);
        assert_eq!(at(&pixels, 360, 120), [0, 0, 255]);
        assert_eq!(at(&pixels, 480, 80), [0x12, 0x34, 0x56]);
        assert_eq!(at(&pixels, 460, 130), [255; 3]);
        assert_eq!(at(&pixels, 624, 100), [0x65, 0x43, 0x21]);
        assert_ne!(at(&pixels, 600, 80), [255; 3]);
        assert_eq!(at(&pixels, 740, 100), [255; 3]);
        assert_ne!(at(&pixels, 720, 120), [255; 3]);
    }

    /// The baseline is at y + dy, and the anchor is an end or the middle of the text.
    #[test]
    fn a_text_is_drawn_at_its_place() {
        let extent = |anchor: &str, dy: &str, more: &str, letters: &str| {
            inked(&drawn(&text(anchor, dy, more, letters)).unwrap())
        };
        // Of 80 steps or 20 pixels per em: H is 1.9 to 13.1 pixels from its origin, and 14.6 high; the anchor is at (100, 50).
        assert_eq!(extent("start", "0", "", "H"), Some([102, 35, 112, 49]));
        assert_eq!(extent("start", "0.76em", "", "H"), Some([102, 50, 112, 65]));
        assert_eq!(extent("start", "0.5ex", "", "H"), Some([102, 40, 112, 54]));
        assert_eq!(extent("start", "-0.5ex", "", "H"), Some([102, 30, 112, 44]));
        assert_eq!(extent("end", "0", "", "H"), Some([87, 35, 97, 49]));
        let [left, .., right, _] = extent("middle", "0", "", "H").unwrap();
        assert_eq!(left + right, 199);
        // From bottom to top.
        let upward = " transform=\"rotate(270, 400, 200)\"";
        let [left, top, right, bottom] = extent("start", "0", upward, "HH").unwrap();
        assert_eq!((left, right, bottom), (85, 99, 47));
        assert!(top < 30, "{top}");
        assert_eq!(extent("start", "0", "", " "), None);
        assert_eq!(
            extent("start", "0", "", "1 &lt; 2 &amp;\n3"),
            extent("start", "0", "", "1&#32;&#60; 2   &#38; 3")
        );
    }

    #[test]
    fn what_pictures_do_not_have_is_refused() {
        for (elements, expected) in [
            ("<ellipse/>", "no element <ellipse>"),
            ("<circle cx=\"1\" cy=\"1\"/>", "<circle> has no attribute r"),
            ("<line x1=\"a\" y1=\"0\"/>", "<line>: x1=\"a\""),
            ("<line", "figure: "),
        ] {
            let error = drawn(elements).unwrap_err();
            assert!(matches!(error, Error::Data { .. }), "{error}");
            assert!(error.to_string().contains(expected), "{error}");
        }
        let large = "<svg width=\"4000000000\" height=\"9\" viewBox=\"0 0 9 9\"/>";
        let error = png_from_svg(large, 2.0).unwrap_err();
        assert!(matches!(error, Error::Limit { .. }), "{error}");
    }
}
