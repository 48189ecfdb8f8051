//! Charts of numbers over numbers, with a scale for each axis.

use plotters::chart::{ChartBuilder, ChartContext};
use plotters::coord::Shift;
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::combinators::{BindKeyPoints, IntoLogRange};
use plotters::coord::ranged1d::{Ranged, ValueFormatter};
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{Circle, EmptyElement, PathElement, Text};
use plotters::prelude::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{BLACK, Color, RGBColor, ShapeStyle, WHITE};

use super::heading::{
    self, Drawn, FINER, LEFT, MARGIN, Mark, Row, WIDTH, color, font, load_font, shown_in_units,
    tick,
};
use crate::error::{Error, Result};

/// The number of units below the plotted part, and its height.
const BELOW: u32 = 56;
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
        let y = self.y;
        let mut builder = ChartBuilder::on(&plot);
        builder
            .margin_left(MARGIN / 2 * FINER)
            .margin_right(MARGIN * FINER)
            .x_label_area_size(BELOW * FINER)
            .y_label_area_size((LEFT - MARGIN / 2) * FINER);
        if self.logarithmic {
            let axis = |ends: [f64; 2]| {
                let scale = (ends[0]..ends[1]).log_scale();
                scale.with_key_points(decades(ends))
            };
            let chart = builder.build_cartesian_2d(axis(x), axis(y))?;
            self.draw_on(chart, |v| logarithmic_tick(*v))?;
        } else {
            let chart = builder.build_cartesian_2d(x[0]..x[1], y[0]..y[1])?;
            self.draw_on(chart, |v| tick(*v))?;
        }
        plot.present()
    }

    /// Draws the axes and the series.
    fn draw_on<B: DrawingBackend, X, Y>(
        &self,
        mut chart: ChartContext<'_, B, Cartesian2d<X, Y>>,
        label: impl Fn(&f64) -> String,
    ) -> Drawn<B>
    where
        X: Ranged<ValueType = f64> + ValueFormatter<f64>,
        Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
    {
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

/// The ticks of a logarithmic axis: powers of ten and, if they are few, 2 and 5 times these.
fn decades([low, high]: [f64; 2]) -> Vec<f64> {
    /// With at most this many decades there is room for further ticks.
    const FEW: f64 = 4.0;
    let steps: &[f64] = if high < low * 10f64.powf(FEW) {
        &[1.0, 2.0, 5.0]
    } else {
        &[1.0]
    };
    let mut ticks = Vec::new();
    let mut power = low.log10().floor();
    while power <= high.log10() {
        let within = steps.iter().map(|step| step * 10f64.powf(power));
        ticks.extend(within.filter(|tick| (low..=high).contains(tick)));
        power += 1.0;
    }
    ticks
}

/// The text of a tick of a logarithmic axis.
fn logarithmic_tick(value: f64) -> String {
    if (1e-3..1e5).contains(&value) {
        tick(value)
    } else {
        format!("{value:.0e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithmic_ticks_are_round_numbers() {
        let shown = |ends: [f64; 2]| -> Vec<String> {
            decades(ends).into_iter().map(logarithmic_tick).collect()
        };
        assert_eq!(
            shown([0.9, 120.0]),
            ["1", "2", "5", "10", "20", "50", "100"]
        );
        assert_eq!(
            shown([5e-6, 11.0]),
            ["1e-5", "1e-4", "0.001", "0.01", "0.1", "1", "10"]
        );
    }

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
