//! The title of a picture and a row of the legend for every layer. They are above the drawing, so that they hide nothing.

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::element::{Circle, PathElement, Rectangle, Text};
use plotters::prelude::DrawingBackend;
use plotters::style::{RGBColor, ShapeStyle};

use super::text::{few_lines, font, lines};
use super::units::{FINER, LEFT, MARGIN};
use crate::error::Invariant;

/// Colours that colour-blind people can distinguish (Okabe and Ito), and that are dark enough on white.
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

const LEGEND_ROW: u32 = 22;
const TITLE_ROW: u32 = 34;
/// The number of units that the mark before a label takes.
const MARK: u32 = 40;
/// The sizes of letters.
const LEGEND_SIZE: u32 = 14;
const TITLE_SIZE: u32 = 20;
/// A longer label loses its middle.
const MOST_LINES: usize = 3;

/// The result of drawing.
pub(super) type Drawn<B> =
    std::result::Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;

/// A row of the legend.
pub(super) struct Row {
    pub(super) label: String,
    pub(super) mark: Mark,
    /// The colour of a dot that is drawn in addition, if there is one.
    pub(super) dot: Option<RGBColor>,
}

/// The mark before the label.
pub(super) enum Mark {
    Line(ShapeStyle),
    Area(ShapeStyle),
    None,
}

/// The height of the heading.
pub(super) fn height(title: &str, rows: &[Row], width: u32) -> u32 {
    let titles = count(&title_lines(title, width));
    let rows: u32 = rows
        .iter()
        .map(|row| count(&label_lines(&row.label, width)))
        .sum();
    MARGIN + titles * TITLE_ROW + rows * LEGEND_ROW + MARGIN / 2
}

fn count(lines: &[String]) -> u32 {
    u32::try_from(lines.len().min(1000)).invariant("1000 is small")
}

/// The number of units to the left of the heading.
fn left(width: u32) -> u32 {
    LEFT.min(width / 10)
}

fn title_lines(title: &str, width: u32) -> Vec<String> {
    lines(title, TITLE_SIZE, room(left(width), width))
}

fn label_lines(label: &str, width: u32) -> Vec<String> {
    few_lines(
        label,
        LEGEND_SIZE,
        room(left(width) + MARK, width),
        MOST_LINES,
    )
}

/// The number of units from a place to the right margin.
fn room(from: u32, width: u32) -> f64 {
    f64::from(width.saturating_sub(from + MARGIN))
}

/// Draws the title and the rows.
pub(super) fn draw<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    title: &str,
    rows: Vec<Row>,
    width: u32,
) -> Drawn<B> {
    let at = |x: u32, y: u32| (int(x * FINER), int(y * FINER));
    let mut y = MARGIN;
    let left = left(width);
    for line in title_lines(title, width) {
        area.draw(&Text::new(line, at(left, y), font(TITLE_SIZE)))?;
        y += TITLE_ROW;
    }
    for row in rows {
        let middle = y + LEGEND_ROW / 2;
        match row.mark {
            Mark::Area(style) => {
                let corners = [at(left, middle - 6), at(left + 30, middle + 6)];
                area.draw(&Rectangle::new(corners, style))?;
            }
            Mark::Line(style) => {
                let ends = vec![at(left, middle), at(left + 30, middle)];
                area.draw(&PathElement::new(ends, style))?;
            }
            Mark::None => {}
        }
        if let Some(color) = row.dot {
            area.draw(&dot(at(left + 15, middle), color))?;
        }
        for line in label_lines(&row.label, width) {
            area.draw(&Text::new(line, at(left + MARK, y + 6), font(LEGEND_SIZE)))?;
            y += LEGEND_ROW;
        }
    }
    Ok(())
}

pub(super) fn dot<C>(at: C, color: RGBColor) -> Circle<C, u32> {
    use plotters::style::Color;
    Circle::new(at, 4 * FINER, color.filled())
}

pub(super) fn small_dot<C>(at: C, color: RGBColor) -> Circle<C, u32> {
    use plotters::style::Color;
    Circle::new(at, 3 * FINER / 2, color.filled())
}

pub(super) fn color(index: usize) -> RGBColor {
    PALETTE[index % PALETTE.len()]
}

pub(super) fn int(value: u32) -> i32 {
    i32::try_from(value).invariant("places on a picture are less than 2^31")
}

/// The SVG on the fine grid, scaled so that it shows units. Corners and ends of lines are round, so that sharp tips are neither
/// cut nor too long.
pub(super) fn shown_in_units(svg: &str, width: u32, height: u32) -> String {
    let fine = format!("width=\"{}\" height=\"{}\"", width * FINER, height * FINER);
    let shown = format!(
        "width=\"{width}\" height=\"{height}\" stroke-linejoin=\"round\" stroke-linecap=\"round\""
    );
    svg.replacen(&fine, &shown, 1)
}

/// The same picture in fewer characters: full opacity and the usual line width are written at most once, a line around a
/// polygon becomes the stroke of the polygon, and numbers are separated by single commas.
pub(super) fn compacted(svg: &str) -> String {
    let usual = format!(" stroke-width=\"{}\"", FINER / 2);
    let svg = svg.replace(" opacity=\"1\"", "");
    let mut short = String::with_capacity(svg.len());
    let mut lines = svg.lines().peekable();
    while let Some(line) = lines.next() {
        let both = lines.peek().and_then(|next| with_outline(line, next));
        if both.is_some() {
            lines.next();
        }
        let line = both.as_deref().unwrap_or(line);
        short.push_str(&with_short_points(line).replace(&usual, ""));
        short.push('\n');
    }
    // The width does not change elements without a stroke.
    short.replacen("<svg ", &format!("<svg{usual} "), 1)
}

/// A polygon and the closed line around it, as one polygon.
fn with_outline(polygon: &str, line: &str) -> Option<String> {
    let (style, points) = polygon
        .strip_prefix("<polygon ")?
        .strip_suffix(" \"/>")?
        .split_once("\" points=\"")?;
    let (stroke, outline) = line
        .strip_prefix("<polyline fill=\"none\" ")?
        .strip_suffix(" \"/>")?
        .split_once("\" points=\"")?;
    let first = points.split(' ').next()?;
    let closes = outline.strip_prefix(points)?.trim_start() == first;
    // If one of the two is transparent, each needs its own opacity.
    let is_opaque = !style.contains("opacity") && !stroke.contains("opacity");
    (closes && is_opaque).then(|| format!("<polygon {style}\" {stroke}\" points=\"{points}\"/>"))
}

/// `points="1,2 3,4 "` as `points="1,2,3,4"`. A line of two points has no area to fill, so its `fill` is dropped.
fn with_short_points(line: &str) -> String {
    let Some((before, rest)) = line.split_once("points=\"") else {
        return line.to_owned();
    };
    let Some((points, after)) = rest.split_once('"') else {
        return line.to_owned();
    };
    let points = points.trim_end();
    let before = match points.matches(' ').count() {
        1 => before.replace(" fill=\"none\"", ""),
        _ => before.to_owned(),
    };
    format!("{before}points=\"{}\"{after}", points.replace(' ', ","))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_compact_picture_has_the_same_shapes() {
        let svg = concat!(
            "<svg width=\"9\" height=\"9\">\n",
            "<polygon opacity=\"1\" fill=\"#123456\" points=\"1,2 3,4 5,7 \"/>\n",
            "<polyline fill=\"none\" opacity=\"1\" stroke=\"#654321\" stroke-width=\"4\" points=\"1,2 3,4 5,7 1,2 \"/>\n",
            "<polygon opacity=\"1\" fill=\"#123456\" points=\"1,2 3,4 5,7 \"/>\n",
            "<polyline fill=\"none\" opacity=\"1\" stroke=\"#654321\" stroke-width=\"8\" points=\"1,2 3,4 5,7 9,9 \"/>\n",
            "<polyline fill=\"none\" opacity=\"1\" stroke=\"#654321\" stroke-width=\"4\" points=\"1,2 3,4 \"/>\n",
            "<text>1 2</text>\n</svg>\n"
        );
        let expected = concat!(
            "<svg stroke-width=\"4\" width=\"9\" height=\"9\">\n",
            "<polygon fill=\"#123456\" stroke=\"#654321\" points=\"1,2,3,4,5,7\"/>\n",
            "<polygon fill=\"#123456\" points=\"1,2,3,4,5,7\"/>\n",
            "<polyline fill=\"none\" stroke=\"#654321\" stroke-width=\"8\" points=\"1,2,3,4,5,7,9,9\"/>\n",
            "<polyline stroke=\"#654321\" points=\"1,2,3,4\"/>\n",
            "<text>1 2</text>\n</svg>\n"
        );
        assert_eq!(compacted(svg), expected);
    }
}
