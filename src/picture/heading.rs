//! The title of a picture and a row of legend for every layer: above the drawing, so that they hide nothing.

use std::sync::Once;

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::element::{Circle, PathElement, Rectangle, Text};
use plotters::prelude::DrawingBackend;
use plotters::style::{FontStyle, IntoFont, RGBColor, ShapeStyle, TextStyle, register_font};

/// Colours that stay apart for the colour-blind (Okabe and Ito), dark enough on white.
const PALETTE: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 120, 90),
    RGBColor(170, 60, 130),
    RGBColor(120, 94, 0),
    RGBColor(90, 90, 90),
    RGBColor(0, 150, 190),
    RGBColor(150, 20, 20),
];

/// Width of the picture in units of the SVG.
pub(super) const WIDTH: u32 = 900;
/// The drawing library rounds to whole units: it draws on a grid this much finer.
pub(super) const FINER: u32 = 8;
/// Units left of the legend, and around the picture.
pub(super) const LEFT: u32 = 76;
pub(super) const MARGIN: u32 = 16;
const LEGEND_ROW: u32 = 22;
const TITLE_ROW: u32 = 34;

/// What drawing gives.
pub(super) type Drawn<B> =
    std::result::Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;

/// A row of the legend.
pub(super) struct Row {
    pub(super) label: String,
    pub(super) mark: Mark,
    /// A dot in this colour is drawn too.
    pub(super) dot: Option<RGBColor>,
}

/// What stands before the label.
pub(super) enum Mark {
    Line(ShapeStyle),
    Area(ShapeStyle),
    None,
}

/// The height of the heading.
pub(super) fn height(title: &str, rows: usize) -> u32 {
    let title = if title.is_empty() { 0 } else { TITLE_ROW };
    let rows = u32::try_from(rows).unwrap_or(u32::MAX).min(1000);
    MARGIN + title + rows * LEGEND_ROW + MARGIN / 2
}

/// Draws title and rows.
pub(super) fn draw<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    title: &str,
    rows: Vec<Row>,
) -> Drawn<B> {
    let at = |x: u32, y: u32| (int(x * FINER), int(y * FINER));
    let mut y = MARGIN;
    if !title.is_empty() {
        area.draw(&Text::new(title.to_owned(), at(LEFT, y), font(20)))?;
        y += TITLE_ROW;
    }
    for row in rows {
        let middle = y + LEGEND_ROW / 2;
        match row.mark {
            Mark::Area(style) => {
                let corners = [at(LEFT, middle - 6), at(LEFT + 30, middle + 6)];
                area.draw(&Rectangle::new(corners, style))?;
            }
            Mark::Line(style) => {
                let ends = vec![at(LEFT, middle), at(LEFT + 30, middle)];
                area.draw(&PathElement::new(ends, style))?;
            }
            Mark::None => {}
        }
        if let Some(color) = row.dot {
            area.draw(&dot(at(LEFT + 15, middle), color))?;
        }
        area.draw(&Text::new(row.label, at(LEFT + 40, y + 6), font(14)))?;
        y += LEGEND_ROW;
    }
    Ok(())
}

pub(super) fn dot<C>(at: C, color: RGBColor) -> Circle<C, u32> {
    use plotters::style::Color;
    Circle::new(at, 4 * FINER, color.filled())
}

pub(super) fn color(index: usize) -> RGBColor {
    PALETTE[index % PALETTE.len()]
}

pub(super) fn font(size: u32) -> TextStyle<'static> {
    ("sans-serif", size * FINER).into_font().into()
}

pub(super) fn int(value: u32) -> i32 {
    i32::try_from(value).unwrap_or(i32::MAX)
}

/// The shortest text of a tick: ticks are decimals up to rounding.
pub(super) fn tick(value: f64) -> String {
    let text = format!("{value:.10}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    match short {
        "-0" => "0".into(),
        "0" | "" if value != 0.0 => format!("{value:e}"),
        _ => short.into(),
    }
}

/// The SVG drawn on the fine grid, shown in units.
pub(super) fn shown_in_units(svg: &str, height: u32) -> String {
    let fine = format!("width=\"{}\" height=\"{}\"", WIDTH * FINER, height * FINER);
    let shown = format!("width=\"{WIDTH}\" height=\"{height}\"");
    svg.replacen(&fine, &shown, 1)
}

/// The same picture in fewer characters: full opacity is not said, and an outline in the colour of its polygon becomes
/// the polygon's stroke.
pub(super) fn compacted(svg: &str) -> String {
    let svg = svg.replace(" opacity=\"1\"", "");
    let mut short = String::with_capacity(svg.len());
    let mut lines = svg.lines().peekable();
    while let Some(line) = lines.next() {
        match lines.peek().and_then(|next| with_outline(line, next)) {
            Some(both) => {
                lines.next();
                short.push_str(&both);
            }
            None => short.push_str(line),
        }
        short.push('\n');
    }
    short
}

/// A polygon and a closed line around it of the same colour as one polygon.
fn with_outline(polygon: &str, line: &str) -> Option<String> {
    let (fill, points) = polygon
        .strip_prefix("<polygon fill=\"")?
        .strip_suffix(" \"/>")?
        .split_once("\" points=\"")?;
    let (stroke, outline) = line
        .strip_prefix("<polyline fill=\"none\" stroke=\"")?
        .split_once("\" points=\"")?;
    let (color, width) = stroke.split_once("\" stroke-width=\"")?;
    (color == fill && outline.starts_with(points)).then(|| {
        format!("<polygon fill=\"{fill}\" stroke=\"{fill}\" stroke-width=\"{width}\" points=\"{points}\"/>")
    })
}

pub(super) fn load_font() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // A font that ships with a crate parses; if it did not, labels would be missing.
        let _ = register_font("sans-serif", FontStyle::Normal, dejavu::sans::regular());
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_short() {
        let shown = [0.0, -0.0, 200.0, 0.1 + 0.2, -1.5, 1e-12].map(tick);
        assert_eq!(shown, ["0", "0", "200", "0.3", "-1.5", "1e-12"]);
    }
}
