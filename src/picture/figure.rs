//! Figures: layers of lines and points over equal axes, with a legend above them.

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{PathElement, Polygon};
use plotters::prelude::{DrawingBackend, SVGBackend};
use plotters::style::{Color, ShapeStyle, WHITE};

use super::heading::{self, Drawn, Mark, Row, color, dot, shown_in_units, small_dot};
use super::plane_axes::{BELOW, Margins, PlaneAxes, Scale};
use super::text::load_font;
use super::units::FINER;
use super::{Window, clip};
use crate::error::{Error, Result};

/// The smallest and the largest ratio of the height of the plotted part to its width. More of the plane is shown to keep the
/// ratio between them.
const ASPECT: [f64; 2] = [0.3, 1.4];

/// A layer of a figure.
#[derive(Clone, Debug, Default)]
pub(crate) struct Layer {
    /// The label in the legend.
    pub label: String,
    /// Polylines; closed ones end where they begin.
    pub lines: Vec<Vec<[f64; 2]>>,
    /// Isolated points, which the legend names.
    pub points: Vec<[f64; 2]>,
    /// The middles of ovals that are too small to be seen, which the legend names.
    pub ovals: Vec<[f64; 2]>,
    /// Points of a cloud, which have small dots.
    pub cloud: Vec<[f64; 2]>,
    /// Whether the layer is drawn as a pale area.
    pub filled: bool,
}

/// Layers over equal axes.
#[derive(Clone, Debug)]
pub(crate) struct Figure {
    /// The heading; it may be empty.
    pub title: String,
    /// The width of the picture, in units of the SVG.
    pub width: u32,
    /// The part of the plane that must be seen. More is shown if the shape of the picture requires it.
    pub window: Window,
    /// The layers, from the lowest to the topmost.
    pub layers: Vec<Layer>,
}

impl Figure {
    /// The figure as an SVG text, with the same unit of length on both axes.
    ///
    /// # Errors
    /// [`Error::Data`] if the window is empty or not finite.
    pub(crate) fn to_svg(&self) -> Result<String> {
        load_font();
        let frame = Frame::new(self)?;
        let mut svg = String::new();
        {
            let size = (self.width * FINER, frame.height * FINER);
            let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            self.draw(&area, &frame)
                .map_err(|e| Error::data("figure", e.to_string()))?;
        }
        Ok(shown_in_units(&svg, self.width, frame.height))
    }

    /// The part of the plane that the picture will show: the window, enlarged to the shape of the picture.
    ///
    /// # Errors
    /// As [`Figure::to_svg`].
    pub(crate) fn shown_window(&self) -> Result<Window> {
        Ok(Frame::new(self)?.window)
    }

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>, frame: &Frame) -> Drawn<B> {
        area.fill(&WHITE)?;
        let (above, plot) = area.split_vertically(frame.heading * FINER);
        heading::draw(&above, &self.title, self.rows(), self.width)?;
        let mut chart = frame.axes.draw(&plot, frame.margins)?;
        for (index, layer) in self.layers.iter().enumerate() {
            let style = self.style(index);
            let (lines, window) = (layer.lines.iter(), &frame.window);
            if layer.filled {
                let polygons = lines.map(|l| Polygon::new(clip::polygon(l, window), style));
                chart.draw_series(polygons)?;
            } else {
                let parts = lines.flat_map(|l| clip::polyline(l, window));
                chart.draw_series(parts.map(|part| PathElement::new(part, style)))?;
            }
            let shown = |p: &&[f64; 2]| {
                let within = |v: f64, [low, high]: [f64; 2]| low <= v && v <= high;
                within(p[0], frame.window.x) && within(p[1], frame.window.y)
            };
            let dots = layer.points.iter().chain(&layer.ovals).filter(shown);
            chart.draw_series(dots.map(|&[x, y]| dot((x, y), color(index))))?;
            let cloud = layer.cloud.iter().filter(shown);
            chart.draw_series(cloud.map(|&[x, y]| small_dot((x, y), color(index))))?;
        }
        plot.present()
    }

    /// The rows of the legend.
    fn rows(&self) -> Vec<Row> {
        let layers = self.layers.iter().enumerate();
        let layers = layers.filter(|(_, layer)| !layer.label.is_empty());
        let row = |(index, layer): (usize, &Layer)| {
            let style = self.style(index);
            let has_points = !layer.points.is_empty() || !layer.ovals.is_empty();
            let is_cloud = !layer.cloud.is_empty();
            let has_lines = !layer.lines.is_empty();
            let remark = match (layer.points.len(), layer.ovals.len()) {
                _ if !has_lines => "",
                (0, 0) => "",
                (1, 0) => " (dot: its isolated point)",
                (_, 0) => " (dots: its isolated points)",
                (0, 1) => " (dot: its tiny oval)",
                (0, _) => " (dots: its tiny ovals)",
                _ => " (dots: its isolated points and tiny ovals)",
            };
            Row {
                label: format!("{}{remark}", layer.label),
                mark: if layer.filled {
                    Mark::Area(style)
                } else if has_lines || !(has_points || is_cloud) {
                    Mark::Line(style)
                } else {
                    Mark::None
                },
                dot: (has_points || is_cloud).then(|| color(index)),
            }
        };
        layers.map(row).collect()
    }

    /// The style of a layer. Later layers are thinner, so that lines below them remain visible on both sides.
    fn style(&self, index: usize) -> ShapeStyle {
        if self.layers[index].filled {
            return color(index).mix(0.25).filled();
        }
        let lines = self.layers.iter().filter(|l| !l.filled).count();
        let before = self.layers[..index].iter().filter(|l| !l.filled).count();
        let width = match (lines, before) {
            (1, _) => 2 * FINER,
            (_, 0) => 5 * FINER,
            (_, 1) => 3 * FINER / 2,
            _ => FINER,
        };
        ShapeStyle::from(color(index)).stroke_width(width)
    }
}

/// The sizes that make the axes equal.
struct Frame {
    window: Window,
    margins: Margins,
    axes: PlaneAxes,
    heading: u32,
    height: u32,
}

impl Frame {
    fn new(figure: &Figure) -> Result<Self> {
        load_font();
        let size = |v: [f64; 2]| v[1] - v[0];
        let (w, h) = (size(figure.window.x), size(figure.window.y));
        if !(w.is_finite() && h.is_finite() && w > 0.0 && h > 0.0) {
            return Err(Error::data("figure", "there is nothing finite to draw"));
        }
        let heading = heading::height(&figure.title, &figure.rows(), figure.width);
        Ok(Margins::settled(|margins| {
            let frame = Self::with_margins(figure, heading, margins);
            let needed = frame.axes.margins();
            (frame, needed)
        }))
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a number of units below 6000"
    )]
    fn with_margins(figure: &Figure, heading: u32, margins: Margins) -> Self {
        let Window { x, y } = figure.window;
        let size = |v: [f64; 2]| v[1] - v[0];
        let width = f64::from(margins.plotted(figure.width));
        let aspect = (size(y) / size(x)).clamp(ASPECT[0], ASPECT[1]);
        let height = (width * aspect).round().max(f64::from(margins.height));
        // Both axes have one scale; in the direction with more room more of the plane is shown.
        let unit = (size(x) / width).max(size(y) / height);
        let widened = |v: [f64; 2], units: f64| {
            let more = (unit * units - size(v)) / 2.0;
            [v[0] - more, v[1] + more]
        };
        let (x, y) = (widened(x, width), widened(y, height));
        Self {
            window: Window { x, y },
            margins,
            axes: PlaneAxes::new([x, y], ["x", "y"], Scale::Equal, [width, height]),
            heading,
            height: heading + height as u32 + BELOW,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::units::WIDTH;
    use super::*;

    #[test]
    fn axes_are_equal_whatever_the_window() {
        for (w, h) in [(1.0, 1.0), (100.0, 1.0), (1.0, 100.0), (3.0, 2.0)] {
            let figure = Figure {
                title: String::new(),
                width: WIDTH,
                window: Window {
                    x: [0.0, w],
                    y: [0.0, h],
                },
                layers: vec![Layer::default()],
            };
            let frame = Frame::new(&figure).unwrap();
            let pixels = f64::from(frame.height - frame.heading - BELOW);
            let [x, y] = [frame.window.x, frame.window.y].map(|v| v[1] - v[0]);
            let unit = x / f64::from(frame.margins.plotted(WIDTH));
            assert!((y / pixels / unit - 1.0).abs() < 1e-9);
            assert!(x >= w && y >= h);
        }
    }
}
