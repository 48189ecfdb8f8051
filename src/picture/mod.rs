//! Pictures: zero sets traced from their exact form, figures as SVG and PNG.

mod clip;
mod extent;
mod figure;
mod raster;
mod trace;

pub use extent::extent;
pub use figure::{Figure, Layer};
pub use raster::png_from_svg;
pub use trace::{Window, isolated_origin, trace_zero_set};
