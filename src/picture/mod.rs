//! Pictures as SVG and PNG: figures of the plane with exactly traced zero sets, scenes in space, and charts.

mod axes;
mod camera;
mod chart;
mod clip;
mod cut;
mod extent;
mod figure;
mod glyphs;
mod heading;
#[cfg(test)]
mod inside;
mod order;
mod plane_axes;
mod raster;
mod scene;
mod text;
mod ticks;
mod trace;
mod units;

pub use chart::Chart;
pub(crate) use chart::Series;
pub(crate) use extent::extent;
pub(crate) use figure::{Figure, Layer};
pub(crate) use raster::png_from_svg;
pub(crate) use scene::{Scene, SpaceLayer};
pub use trace::Window;
pub(crate) use trace::{isolated_origin, trace_zero_set};
pub(crate) use units::WIDTH;
