//! Charts of numbers over numbers, with a scale for each axis.

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{Circle, EmptyElement, PathElement, Text};
use plotters::prelude::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, ShapeStyle, WHITE};

use super::heading::{self, Drawn, Mark, Row, color, shown_in_units};
use super::plane_axes::{BELOW, Margins, PlaneAxes, PlaneChart, Scale};
use super::text::{font, load_font};
use super::units::{FINER, WIDTH};
use crate::error::{Error, Result};

/// The height of the plotted part.
const HEIGHT: u32 = 460;

/// The position of the mark of a series, relative to its last point.
const BESIDE: Pos = Pos {
    h_pos: HPos::Left,
    v_pos: VPos::Center,
};

/// A logarithmic axis extends beyond the points by this factor.
const ROOM: f64 = 1.15;

/// Half the width of a dot; if there are many points, their dots are smaller.
const DOT: u32 = 3;
const SMALL_DOT: u32 = 1;
const MANY: usize = 300;

/// A series of points.
#[derive(Clone, Debug, Default)]
pub(crate) struct Series {
    /// The label in the legend.
    pub(crate) label: String,
    /// The points (x, y).
    pub(crate) points: Vec<[f64; 2]>,
    /// Whether a line joins the points, in their order.
    pub(crate) joined: bool,
    /// The text next to the last point; it may be empty.
    pub(crate) mark: String,
}

/// Series over two axes.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The heading; it may be empty.
    pub(crate) title: String,
    /// The labels of the axes.
    pub(crate) labels: [String; 2],
    /// The ends of the y axis. The x axis is fitted to the points.
    pub(crate) y: [f64; 2],
    /// Whether both axes are logarithmic; then all numbers must be positive.
    pub(crate) logarithmic: bool,
    /// The series, from the lowest to the topmost layer.
    pub(crate) series: Vec<Series>,
}

impl Chart {
    /// The chart as an SVG text. Points beyond the ends of the y axis are drawn at the end.
    ///
    /// # Errors
    /// [`Error::Data`] if there is no point, or a number that is not finite.
    pub fn to_svg(&self) -> Result<String> {
        load_font();
        let x = self.x_range()?;
        let height = heading::height(&self.title, &self.rows(), WIDTH) + HEIGHT + BELOW;
        let mut svg = String::new();
        {
            let size = (WIDTH * FINER, height * FINER);
            let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            self.draw(&area, x)
                .map_err(|e| Error::data("chart", e.to_string()))?;
        }
        Ok(shown_in_units(&svg, WIDTH, height))
    }

    /// The range of x, which holds all points.
    fn x_range(&self) -> Result<[f64; 2]> {
        let all = self.series.iter().flat_map(|s| &s.points);
        let mut range: Option<[f64; 2]> = None;
        for [x, y] in all {
            if !(x.is_finite() && y.is_finite()) {
                return Err(Error::data("chart", "there is a number that is not finite"));
            }
            if self.logarithmic && !(*x > 0.0 && *y > 0.0) {
                let message = "there is a number that is not positive, and no logarithm of it";
                return Err(Error::data("chart", message));
            }
            let [low, high] = range.unwrap_or([*x, *x]);
            range = Some([low.min(*x), high.max(*x)]);
        }
        let [low, high] = range.ok_or_else(|| Error::data("chart", "there is nothing to draw"))?;
        if self.logarithmic {
            return Ok([low / ROOM, high * ROOM]);
        }
        let room = if high > low { 0.02 * (high - low) } else { 0.5 };
        Ok([low - room, high + room])
    }

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>, x: [f64; 2]) -> Drawn<B> {
        area.fill(&WHITE)?;
        let above = heading::height(&self.title, &self.rows(), WIDTH);
        let (above, plot) = area.split_vertically(above * FINER);
        heading::draw(&above, &self.title, self.rows(), WIDTH)?;
        let (axes, margins) = self.axes(x);
        self.draw_on(axes.draw(&plot, margins)?)?;
        plot.present()
    }

    /// The axes, and the margins for them.
    fn axes(&self, x: [f64; 2]) -> (PlaneAxes, Margins) {
        let names = self.labels.each_ref().map(String::as_str);
        let scale = if self.logarithmic {
            Scale::Logarithmic
        } else {
            Scale::Linear
        };
        Margins::settled(|margins| {
            let size = [margins.plotted(WIDTH), HEIGHT].map(f64::from);
            let axes = PlaneAxes::new([x, self.y], names, scale, size);
            let needed = axes.margins();
            ((axes, margins), needed)
        })
    }

    /// Draws the series.
    fn draw_on<B: DrawingBackend>(&self, mut chart: PlaneChart<'_, B>) -> Drawn<B> {
        for (index, series) in self.series.iter().enumerate() {
            let within = |p: &[f64; 2]| (p[0], p[1].clamp(self.y[0], self.y[1]));
            let points: Vec<(f64, f64)> = series.points.iter().map(within).collect();
            let size = if points.len() > MANY { SMALL_DOT } else { DOT };
            if series.joined {
                let style = ShapeStyle::from(color(index)).stroke_width(2 * FINER);
                chart.draw_series([PathElement::new(points.clone(), style)])?;
            }
            let dots = points.iter().copied();
            chart
                .draw_series(dots.map(|at| Circle::new(at, size * FINER, color(index).filled())))?;
            if let (Some(&at), false) = (points.last(), series.mark.is_empty()) {
                let color = color(index);
                let style = font(14).color(&color).pos(BESIDE);
                let aside = (heading::int(2 * DOT * FINER), 0);
                let text = Text::new(series.mark.clone(), aside, style);
                chart.draw_series([EmptyElement::at(at) + text])?;
            }
        }
        Ok(())
    }

    /// The rows of the legend.
    fn rows(&self) -> Vec<Row> {
        let row = |(index, series): (usize, &Series)| Row {
            label: series.label.clone(),
            mark: if series.joined {
                Mark::Line(ShapeStyle::from(color(index)).stroke_width(2 * FINER))
            } else {
                Mark::None
            },
            dot: Some(color(index)),
        };
        self.series.iter().enumerate().map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_must_be_something_finite() {
        let chart = |points: Vec<[f64; 2]>, logarithmic: bool| Chart {
            title: String::new(),
            labels: ["x".into(), "y".into()],
            y: [0.1, 1.0],
            logarithmic,
            series: vec![Series {
                points,
                ..Series::default()
            }],
        };
        for logarithmic in [false, true] {
            assert!(chart(vec![], logarithmic).to_svg().is_err());
            assert!(chart(vec![[0.0, f64::NAN]], logarithmic).to_svg().is_err());
            // A single point, and a point beyond the axis, are no errors.
            assert!(chart(vec![[3.0, 2.0]], logarithmic).to_svg().is_ok());
        }
        // 0 has no logarithm.
        assert!(chart(vec![[0.0, 1.0]], false).to_svg().is_ok());
        assert!(chart(vec![[0.0, 1.0]], true).to_svg().is_err());
    }
}
