//! Converts SVG to PNG, with the font by which the figure was laid out.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};

use crate::error::{Error, Result};

/// Renders an SVG text as a PNG file at `scale` pixels per unit.
///
/// # Errors
/// [`Error::Limit`] if the picture is too large to be held in memory; [`Error::Data`] if the SVG
/// is malformed.
pub(crate) fn png_from_svg(svg: &str, scale: f32) -> Result<Vec<u8>> {
    let mut fonts = Database::new();
    fonts.load_font_data(dejavu::sans::regular().to_vec());
    fonts.set_sans_serif_family("DejaVu Sans");
    let options = Options {
        fontdb: Arc::new(fonts),
        font_family: "DejaVu Sans".into(),
        ..Options::default()
    };
    let broken = |e: &dyn std::fmt::Display| Error::data("figure", e.to_string());
    let tree = Tree::from_str(svg, &options).map_err(|e| broken(&e))?;
    let size = tree
        .size()
        .to_int_size()
        .scale_by(scale)
        .ok_or_else(|| Error::limit("picture size"))?;
    let mut pixels = Pixmap::new(size.width(), size.height())
        .ok_or_else(|| Error::limit(format!("picture size {}x{}", size.width(), size.height())))?;
    resvg::render(
        &tree,
        Transform::from_scale(scale, scale),
        &mut pixels.as_mut(),
    );
    pixels.encode_png().map_err(|e| broken(&e))
}
