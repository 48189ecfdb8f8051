//! A figure: layers of lines and points over equal axes, with a legend.

use std::sync::Once;

use plotters::chart::{ChartBuilder, SeriesLabelPosition};
use plotters::drawing::IntoDrawingArea;
use plotters::element::{Circle, PathElement, Polygon};
use plotters::prelude::SVGBackend;
use plotters::style::{BLACK, Color, FontStyle, RGBColor, ShapeStyle, WHITE, register_font};

use super::Window;
use crate::error::{Error, Result};

/// Colours that stay apart for the colour-blind (Okabe and Ito), dark enough on white.
const PALETTE: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(120, 120, 120),
];

/// Width of the drawing in SVG units; its height follows from the window, within limits.
const WIDTH: u32 = 900;
const MARGINS: (u32, u32) = (90, 110);

/// One thing drawn.
#[derive(Clone, Debug, Default)]
pub struct Layer {
    /// What the legend says.
    pub label: String,
    /// Polylines; closed ones end where they begin.
    pub lines: Vec<Vec<[f64; 2]>>,
    /// Isolated points.
    pub points: Vec<[f64; 2]>,
    /// Drawn as a wide pale band or filled area below the others.
    pub filled: bool,
}

/// Layers over equal axes.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The heading, possibly empty.
    pub title: String,
    /// The part of the plane that is shown.
    pub window: Window,
    /// From the lowest to the topmost.
    pub layers: Vec<Layer>,
}

impl Figure {
    /// The figure as an SVG text: the same unit of length on both axes.
    ///
    /// # Errors
    /// [`Error::Data`] if the window is empty or not finite.
    pub fn to_svg(&self) -> Result<String> {
        load_font();
        let (width, height) = self.canvas()?;
        let mut svg = String::new();
        {
            let area = SVGBackend::with_string(&mut svg, (width, height)).into_drawing_area();
            self.draw(&area)
                .map_err(|e| Error::data("figure", e.to_string()))?;
        }
        Ok(svg)
    }

    /// Canvas size for equal axes.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a number of pixels between 200 and 2000"
    )]
    fn canvas(&self) -> Result<(u32, u32)> {
        let [w, h] = [self.window.x, self.window.y].map(|v| v[1] - v[0]);
        if !(w.is_finite() && h.is_finite() && w > 0.0 && h > 0.0) {
            return Err(Error::data("figure", "there is nothing finite to draw"));
        }
        let plot_width = f64::from(WIDTH - MARGINS.0);
        let plot_height = (plot_width * h / w).round().clamp(100.0, 2000.0);
        Ok((WIDTH, plot_height as u32 + MARGINS.1))
    }

    fn draw<B: plotters::prelude::DrawingBackend>(
        &self,
        area: &plotters::drawing::DrawingArea<B, plotters::coord::Shift>,
    ) -> std::result::Result<(), plotters::drawing::DrawingAreaErrorKind<B::ErrorType>> {
        area.fill(&WHITE)?;
        let Window { x, y } = self.window;
        let mut builder = ChartBuilder::on(area);
        builder
            .margin(20)
            .x_label_area_size(45)
            .y_label_area_size(50);
        if !self.title.is_empty() {
            builder.caption(&self.title, ("sans-serif", 20));
        }
        let mut chart = builder.build_cartesian_2d(x[0]..x[1], y[0]..y[1])?;
        chart
            .configure_mesh()
            .light_line_style(RGBColor(244, 244, 244))
            .bold_line_style(RGBColor(225, 225, 225))
            .axis_desc_style(("sans-serif", 16))
            .label_style(("sans-serif", 14))
            .x_desc("x")
            .y_desc("y")
            .draw()?;
        for (index, layer) in self.layers.iter().enumerate() {
            let color = PALETTE[index % PALETTE.len()];
            // Later layers are thinner, so that what they cover stays visible on either side.
            let stroke = match index {
                0 => 5,
                1 => 3,
                _ => 1,
            };
            let stroke = if self.layers.len() == 1 { 2 } else { stroke };
            let style: ShapeStyle = if layer.filled {
                color.mix(0.25).filled()
            } else {
                color.stroke_width(stroke)
            };
            let series = if layer.filled {
                let polygons = layer.lines.iter().map(|l| Polygon::new(tuples(l), style));
                chart.draw_series(polygons)?
            } else {
                let paths = layer
                    .lines
                    .iter()
                    .map(|l| PathElement::new(tuples(l), style));
                chart.draw_series(paths)?
            };
            series.label(layer.label.clone()).legend(move |(x, y)| {
                PathElement::new(
                    vec![(x, y), (x + 24, y)],
                    style.color.stroke_width(stroke.max(2)),
                )
            });
            let marks = layer
                .points
                .iter()
                .map(|&[x, y]| Circle::new((x, y), 4, color.filled()));
            chart.draw_series(marks)?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .label_font(("sans-serif", 14))
            .legend_area_size(30)
            .margin(8)
            .draw()?;
        area.present()
    }
}

fn tuples(line: &[[f64; 2]]) -> Vec<(f64, f64)> {
    line.iter().map(|&[x, y]| (x, y)).collect()
}

/// The figure's one font, embedded in the binary: nothing is taken from the system.
fn load_font() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // A font that ships with a crate parses; if it did not, labels would be missing.
        let _ = register_font("sans-serif", FontStyle::Normal, dejavu::sans::regular());
    });
}
