//! The two axes of a picture of the plane: a grid, numbers and titles, and the room that these take.

use std::ops::Range;

use plotters::chart::{ChartBuilder, ChartContext};
use plotters::coord::Shift;
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::prelude::DrawingBackend;
use plotters::style::{BLACK, Color, RGBColor, ShapeStyle, WHITE};

use super::text::{font, text_width};
use super::ticks::{self, Ticks};
use super::units::{FINER, LEFT, MARGIN};

/// The number of units below the plotted part.
pub(super) const BELOW: u32 = 56;
/// The number of units between the edge of the picture and the title of the y axis.
const EDGE: u32 = 4;

/// The sizes of letters.
const NUMBER_SIZE: u32 = 14;
const TITLE_SIZE: u32 = 16;
const SMALLEST_TITLE: u32 = 8;

/// The length of the mark of a tick; its number begins at twice this distance.
const TICK: u32 = 5;
/// The numbers of an axis have at least this distance.
const GAP: f64 = 12.0;
/// The ticks of the y axis have at least this distance.
const LINE: f64 = 22.0;
/// Letters have at least this distance from the edge of the picture.
const ROOM: f64 = 2.0;
/// The largest number of ticks on an axis.
const MOST: usize = 11;

/// How numbers are spaced along both axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scale {
    /// One unit of length for both axes.
    Equal,
    /// A unit of length for each axis.
    Linear,
    /// Logarithms.
    Logarithmic,
}

/// A chart whose axes have these ticks.
pub(super) type PlaneChart<'a, B> = ChartContext<'a, B, Cartesian2d<Axis, Axis>>;

/// An axis with its ticks.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    ends: [f64; 2],
    logarithmic: bool,
    ticks: Vec<f64>,
}

impl Axis {
    /// The place of a number along the axis, from 0 to 1.
    fn place(&self, value: f64) -> f64 {
        let [low, high] = self.ends;
        if self.logarithmic {
            (value / low).ln() / (high / low).ln()
        } else {
            (value - low) / (high - low)
        }
    }
}

impl Ranged for Axis {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    #[expect(clippy::cast_possible_truncation, reason = "a place on the picture")]
    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        (f64::from(from) + self.place(*value) * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() {
            Vec::new()
        } else {
            self.ticks.clone()
        }
    }

    fn range(&self) -> Range<f64> {
        self.ends[0]..self.ends[1]
    }
}

/// The space around and above the plotted part that the axes need, in units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Margins {
    pub(super) left: u32,
    pub(super) right: u32,
    /// The smallest height of the plotted part.
    pub(super) height: u32,
}

impl Margins {
    /// The margins of a picture with short numbers.
    pub(super) const USUAL: Self = Self {
        left: LEFT,
        right: MARGIN,
        height: 0,
    };

    /// The margins by which `drawn` of the picture is stable: each attempt gets more room if its axes need it.
    pub(super) fn settled<T>(mut draw: impl FnMut(Self) -> (T, Self)) -> T {
        const ATTEMPTS: usize = 6;
        let mut margins = Self::USUAL;
        let (mut drawn, mut needed) = draw(margins);
        for _ in 0..ATTEMPTS {
            let wider = Self {
                left: margins.left.max(needed.left),
                right: margins.right.max(needed.right),
                height: margins.height.max(needed.height),
            };
            if wider == margins {
                break;
            }
            margins = wider;
            (drawn, needed) = draw(margins);
        }
        drawn
    }

    /// The width of the plotted part of a picture.
    pub(super) fn plotted(self, width: u32) -> u32 {
        const NARROWEST: u32 = 80;
        width.saturating_sub(self.left + self.right).max(NARROWEST)
    }
}

/// The ticks and titles of both axes.
#[derive(Clone, Debug)]
pub(super) struct PlaneAxes {
    ticks: [Ticks; 2],
    titles: [String; 2],
    ranges: [[f64; 2]; 2],
    scale: Scale,
    /// The size of the plotted part, in units.
    size: [f64; 2],
}

impl PlaneAxes {
    /// Axes with these names over a plotted part of this size.
    pub(super) fn new(
        ranges: [[f64; 2]; 2],
        names: [&str; 2],
        scale: Scale,
        size: [f64; 2],
    ) -> Self {
        let ticks = match scale {
            Scale::Logarithmic => ranges.map(Ticks::of_decades),
            Scale::Equal | Scale::Linear => {
                let one_unit = scale == Scale::Equal;
                ticks::fitting(ranges, MOST, one_unit, |k, ticks| {
                    fits(ticks, ranges[k], k, size[k])
                })
            }
        };
        let [x, y] = &ticks;
        let titles = [x.title(names[0]), y.title(names[1])];
        Self {
            ticks,
            titles,
            ranges,
            scale,
            size,
        }
    }

    /// The margins that these axes need.
    pub(super) fn margins(&self) -> Margins {
        let numbers = self.ticks[1]
            .labels()
            .iter()
            .map(|label| number_width(label));
        let widest = numbers.fold(0.0, f64::max);
        let beside_y = f64::from(EDGE + TITLE_SIZE + 2 * TICK) + GAP / 2.0 + widest;
        let (mut before, mut after): (f64, f64) = (0.0, 0.0);
        let axis = self.axis(0);
        for (value, label) in self.ticks[0].values().iter().zip(self.ticks[0].labels()) {
            let at = axis.place(*value) * self.size[0];
            let half = number_width(label) / 2.0 + ROOM;
            before = before.max(half - at);
            after = after.max(at + half - self.size[0]);
        }
        Margins {
            left: units(beside_y.max(before)),
            right: units(after),
            height: units(text_width(&self.titles[1], TITLE_SIZE) + 2.0 * ROOM),
        }
    }

    fn axis(&self, k: usize) -> Axis {
        Axis {
            ends: self.ranges[k],
            logarithmic: self.scale == Scale::Logarithmic,
            ticks: self.ticks[k].values().to_vec(),
        }
    }

    /// Draws the grid, the numbers and the titles into an area with these margins.
    pub(super) fn draw<'a, B: DrawingBackend>(
        &self,
        area: &'a DrawingArea<B, Shift>,
        margins: Margins,
    ) -> Result<PlaneChart<'a, B>, DrawingAreaErrorKind<B::ErrorType>> {
        let mut chart = ChartBuilder::on(area)
            .margin_left(EDGE * FINER)
            .margin_right(margins.right * FINER)
            .x_label_area_size(BELOW * FINER)
            .y_label_area_size((margins.left - EDGE) * FINER)
            .build_cartesian_2d(self.axis(0), self.axis(1))?;
        let [x, y] = &self.ticks;
        let sizes = [0, 1].map(|k| title_size(&self.titles[k], self.size[k]));
        chart
            .configure_mesh()
            .max_light_lines(1)
            .light_line_style(WHITE.mix(0.0))
            .bold_line_style(ShapeStyle::from(RGBColor(225, 225, 225)).stroke_width(FINER))
            .axis_style(ShapeStyle::from(BLACK).stroke_width(FINER))
            .set_all_tick_mark_size(TICK * FINER)
            .axis_desc_style(font(sizes[0].min(sizes[1])))
            .label_style(font(NUMBER_SIZE))
            .x_label_formatter(&|v| x.label(*v))
            .y_label_formatter(&|v| y.label(*v))
            .x_desc(self.titles[0].as_str())
            .y_desc(self.titles[1].as_str())
            .draw()?;
        Ok(chart)
    }
}

/// Whether the numbers of an axis of this length do not touch each other.
fn fits(ticks: &Ticks, [low, high]: [f64; 2], axis: usize, length: f64) -> bool {
    let widths: Vec<f64> = ticks
        .labels()
        .iter()
        .map(|label| number_width(label))
        .collect();
    let mut pairs = ticks.values().windows(2).zip(widths.windows(2));
    pairs.all(|(at, widths)| {
        let distance = (at[1] - at[0]) / (high - low) * length;
        let needed = match axis {
            0 => f64::midpoint(widths[0], widths[1]) + GAP,
            _ => LINE,
        };
        distance >= needed
    })
}

fn number_width(label: &str) -> f64 {
    text_width(label, NUMBER_SIZE)
}

/// The largest size of letters in which a title is not longer than its axis.
fn title_size(title: &str, length: f64) -> u32 {
    let sizes = (SMALLEST_TITLE..=TITLE_SIZE).rev();
    let mut fitting = sizes.filter(|size| text_width(title, *size) + 2.0 * ROOM <= length);
    fitting.next().unwrap_or(SMALLEST_TITLE)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number of units, rounded up"
)]
fn units(value: f64) -> u32 {
    value.max(0.0).ceil() as u32
}
