//! Outlines are read from files: tables, arrays, maps, drawings and pictures.
//!
//! [`read`] turns a file of any kind into the outline that is chosen ([`OutlineOptions`]) and what else there is ([`LeftOut`]).
//! Below it is a file for each kind: rows of numbers in [`rows`], [`layout`] and [`columns`]; arrays in [`numpy`]; polygons in
//! [`geojson`]; drawings in `drawing`, with the paths of SVG in `svg_path`, `cut` and `viewport`; and pictures in `pixels` (with
//! `bmp` and `orientation`), `picture` and `silhouette`. Several closed rings are put in order in [`rings`].

#[cfg(feature = "images")]
mod bmp;
mod columns;
#[cfg(feature = "images")]
mod cut;
#[cfg(feature = "images")]
mod drawing;
#[cfg(feature = "images")]
#[cfg(test)]
mod encoded;
mod geojson;
mod layout;
mod left_out;
mod numpy;
#[cfg(feature = "images")]
mod orientation;
mod outline_options;
#[cfg(feature = "images")]
mod picture;
#[cfg(feature = "images")]
mod pixels;
mod read;
mod rings;
mod rows;
#[cfg(feature = "images")]
mod silhouette;
#[cfg(feature = "images")]
mod svg_path;
#[cfg(feature = "images")]
mod svg_style;
#[cfg(feature = "images")]
mod viewport;

pub use columns::{Column, Columns};
pub(crate) use geojson::is_geojson;
pub use left_out::LeftOut;
pub(crate) use numpy::rows_of_array;
pub use outline_options::OutlineOptions;
pub use read::{
    ContourKind, cloud_from_reader, contour_from_reader, outline_from_reader, outlines_from_reader,
    read_contour,
};

/// Some things in words: "one point", "3 points"; `None` for none.
fn counted(count: usize, one: &str, several: &str) -> Option<String> {
    match count {
        0 => None,
        1 => Some(format!("one {one}")),
        count => Some(format!("{count} {several}")),
    }
}
