//! A chart: numbers over numbers, each axis with a scale of its own.

use plotters::chart::ChartBuilder;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{Circle, PathElement};
use plotters::prelude::{DrawingBackend, SVGBackend};
use plotters::style::{BLACK, Color, RGBColor, ShapeStyle, WHITE};

use super::heading::{
    self, Drawn, FINER, LEFT, MARGIN, Mark, Row, WIDTH, color, font, load_font, shown_in_units,
    tick,
};
use crate::error::{Error, Result};

/// Units below the plotted part, and its height.
const BELOW: u32 = 56;
const HEIGHT: u32 = 460;

/// Half the width of a dot; the dots of many points are smaller.
const DOT: u32 = 3;
const SMALL_DOT: u32 = 1;
const MANY: usize = 300;

/// One row of numbers.
#[derive(Clone, Debug, Default)]
pub struct Series {
    /// What the legend says.
    pub label: String,
    /// (x, y).
    pub points: Vec<[f64; 2]>,
    /// Whether a line joins the points, in their order.
    pub joined: bool,
}

/// Series over two axes.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The heading, possibly empty.
    pub title: String,
    /// What the axes show.
    pub labels: [String; 2],
    /// The ends of the y axis; the x axis fits the points.
    pub y: [f64; 2],
    /// From the lowest to the topmost.
    pub series: Vec<Series>,
}

impl Chart {
    /// The chart as an SVG text; what is beyond the ends of the y axis is drawn on its end.
    ///
    /// ```
    /// use stellate::picture::{Chart, Series};
    /// let series = Series { label: "digits".into(), points: vec![[1.0, 15.9], [2.0, 14.1]], joined: true };
    /// let labels = ["N".into(), "digits".into()];
    /// let chart = Chart { title: String::new(), labels, y: [0.0, 17.0], series: vec![series] };
    /// assert!(chart.to_svg()?.starts_with("<svg"));
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Data`] if there is no point, or a number that is not finite.
    pub fn to_svg(&self) -> Result<String> {
        load_font();
        let x = self.x_range()?;
        let height = heading::height(&self.title, self.series.len()) + HEIGHT + BELOW;
        let mut svg = String::new();
        {
            let size = (WIDTH * FINER, height * FINER);
            let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            self.draw(&area, x)
                .map_err(|e| Error::data("chart", e.to_string()))?;
        }
        Ok(shown_in_units(&svg, height))
    }

    /// Around all points.
    fn x_range(&self) -> Result<[f64; 2]> {
        let all = self.series.iter().flat_map(|s| &s.points);
        let mut range: Option<[f64; 2]> = None;
        for [x, y] in all {
            if !(x.is_finite() && y.is_finite()) {
                return Err(Error::data("chart", "there is a number that is not finite"));
            }
            let [low, high] = range.unwrap_or([*x, *x]);
            range = Some([low.min(*x), high.max(*x)]);
        }
        let [low, high] = range.ok_or_else(|| Error::data("chart", "there is nothing to draw"))?;
        let room = if high > low { 0.02 * (high - low) } else { 0.5 };
        Ok([low - room, high + room])
    }

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>, x: [f64; 2]) -> Drawn<B> {
        area.fill(&WHITE)?;
        let above = heading::height(&self.title, self.series.len());
        let (above, plot) = area.split_vertically(above * FINER);
        heading::draw(&above, &self.title, self.rows())?;
        let mut chart = ChartBuilder::on(&plot)
            .margin_left(MARGIN / 2 * FINER)
            .margin_right(MARGIN * FINER)
            .x_label_area_size(BELOW * FINER)
            .y_label_area_size((LEFT - MARGIN / 2) * FINER)
            .build_cartesian_2d(x[0]..x[1], self.y[0]..self.y[1])?;
        let label = |v: &f64| tick(*v);
        let [x_label, y_label] = &self.labels;
        chart
            .configure_mesh()
            .max_light_lines(1)
            .light_line_style(WHITE.mix(0.0))
            .bold_line_style(ShapeStyle::from(RGBColor(225, 225, 225)).stroke_width(FINER))
            .axis_style(ShapeStyle::from(BLACK).stroke_width(FINER))
            .set_all_tick_mark_size(5 * FINER)
            .axis_desc_style(font(16))
            .label_style(font(14))
            .x_label_formatter(&label)
            .y_label_formatter(&label)
            .x_desc(x_label.as_str())
            .y_desc(y_label.as_str())
            .draw()?;
        for (index, series) in self.series.iter().enumerate() {
            let within = |p: &[f64; 2]| (p[0], p[1].clamp(self.y[0], self.y[1]));
            let points: Vec<(f64, f64)> = series.points.iter().map(within).collect();
            let size = if points.len() > MANY { SMALL_DOT } else { DOT };
            if series.joined {
                let style = ShapeStyle::from(color(index)).stroke_width(2 * FINER);
                chart.draw_series([PathElement::new(points.clone(), style)])?;
            }
            let dots = points.into_iter();
            chart
                .draw_series(dots.map(|at| Circle::new(at, size * FINER, color(index).filled())))?;
        }
        plot.present()
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
        let chart = |points: Vec<[f64; 2]>| Chart {
            title: String::new(),
            labels: ["x".into(), "y".into()],
            y: [0.0, 1.0],
            series: vec![Series {
                points,
                ..Series::default()
            }],
        };
        assert!(chart(vec![]).to_svg().is_err());
        assert!(chart(vec![[0.0, f64::NAN]]).to_svg().is_err());
        // One point, and one beyond the axis, are no fault.
        assert!(chart(vec![[3.0, 2.0]]).to_svg().is_ok());
    }
}
