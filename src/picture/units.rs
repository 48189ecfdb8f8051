//! The sizes in which pictures are laid out, in units of the SVG.

/// The default width of a picture in units of the SVG.
pub(crate) const WIDTH: u32 = 900;
/// The drawing library rounds to whole units, so it draws on a grid that is finer by this factor.
pub(super) const FINER: u32 = 8;
/// The number of units to the left of the plotted part if its numbers are short, and around the picture.
pub(super) const LEFT: u32 = 76;
pub(super) const MARGIN: u32 = 16;
