//! The outline of a silhouette in a picture is traced.

use contour::ContourBuilder;

use super::picture::{Heights, Picture};
use super::rings::signed_area;
use super::{ContourKind, LeftOut, OutlineOptions};
use crate::error::{Error, Invariant, Result};
use crate::shape::Contour;

/// A part of the silhouette: pixels that are connected along their sides.
struct Part {
    pixels: usize,
    /// The least and the largest column, and the least and the largest row.
    columns: [usize; 2],
    rows: [usize; 2],
    label: u32,
}

/// A silhouette in a picture, and its parts, that with the most pixels first.
pub(super) struct Silhouette {
    picture: Picture,
    heights: Heights,
    labels: Vec<u32>,
    parts: Vec<Part>,
}

impl Silhouette {
    /// Finds the silhouette in a picture; see [`super::contour_from_reader`] for the rules.
    ///
    /// # Errors
    /// [`Error::Data`] for a picture that cannot be read, or that has no silhouette; [`Error::Limit`] if it is too large.
    pub(super) fn read(bytes: &[u8], options: &OutlineOptions, place: &str) -> Result<Self> {
        let picture = Picture::decode(bytes, place)?;
        let heights = picture.heights(options, place)?;
        let (labels, mut parts) = parts(&heights, picture.width);
        parts.sort_by_key(|part| std::cmp::Reverse(part.pixels));
        Ok(Self {
            picture,
            heights,
            labels,
            parts,
        })
    }

    /// The number of parts.
    pub(super) fn count(&self) -> usize {
        self.parts.len()
    }

    /// Traces the outer boundary of the part with this number, from 1.
    ///
    /// # Errors
    /// [`Error::Data`] if there are fewer parts; those of [`Contour::new`].
    pub(super) fn outline(
        &self,
        blob: usize,
        options: &OutlineOptions,
        place: &str,
    ) -> Result<(Contour, LeftOut)> {
        let count = self.count();
        let found = blob.checked_sub(1).and_then(|index| self.parts.get(index));
        let Some(taken) = found else {
            return Err(Error::data(
                place,
                format!(
                    "--blob {blob}: the silhouette has {count} {}, counted from 1 by their size",
                    if count == 1 { "part" } else { "parts" }
                ),
            ));
        };
        let (ring, holes) = outline(&self.picture, &self.heights, &self.labels, taken, place)?;
        // The others are in order, too.
        let largest = self.parts.get(usize::from(blob == 1));
        let largest = largest
            .filter(|_| count > 1)
            .map_or(0, |other| other.pixels);
        let (contour, removed) = options.outline(ring.into(), place)?;
        let left_out = LeftOut {
            kind: ContourKind::Image,
            removed,
            parts: count - 1,
            largest: coordinate(largest) / coordinate(taken.pixels),
            holes,
            frame: self.heights.frame,
            ..LeftOut::default()
        };
        Ok((contour.with_resolution(1.0), left_out))
    }
}

/// The label of every pixel, 0 for the background, and the parts of the silhouette.
fn parts(heights: &Heights, width: usize) -> (Vec<u32>, Vec<Part>) {
    let is_inside = |k: usize| f64::from(heights.heights[k]) > heights.level;
    let count = heights.heights.len();
    let mut labels = vec![0_u32; count];
    let mut parts = Vec::new();
    let mut open = Vec::new();
    for start in 0..count {
        if labels[start] != 0 || !is_inside(start) {
            continue;
        }
        let label =
            u32::try_from(parts.len() + 1).invariant("a picture has fewer than 2^32 pixels");
        let (i, j) = (start % width, start / width);
        let mut part = Part {
            pixels: 0,
            columns: [i, i],
            rows: [j, j],
            label,
        };
        labels[start] = label;
        open.push(start);
        while let Some(k) = open.pop() {
            let (i, j) = (k % width, k / width);
            part.pixels += 1;
            part.columns = [part.columns[0].min(i), part.columns[1].max(i)];
            part.rows = [part.rows[0].min(j), part.rows[1].max(j)];
            let neighbours = [
                (i > 0).then(|| k - 1),
                (i + 1 < width).then_some(k + 1),
                k.checked_sub(width),
                Some(k + width).filter(|&k| k < count),
            ];
            for next in neighbours.into_iter().flatten() {
                if labels[next] == 0 && is_inside(next) {
                    labels[next] = label;
                    open.push(next);
                }
            }
        }
        parts.push(part);
    }
    (labels, parts)
}

/// The outer boundary of a part at the level, in the picture's coordinates with y upwards, and the number of its holes.
fn outline(
    picture: &Picture,
    heights: &Heights,
    labels: &[u32],
    part: &Part,
    place: &str,
) -> Result<(Vec<[f64; 2]>, usize)> {
    // Only the rectangle around the part is traced, with one more pixel on each side. Everything beyond the picture, and every
    // other part, is background.
    let ([left, right], [top, bottom]) = (part.columns, part.rows);
    let (wide, high) = (right - left + 3, bottom - top + 3);
    let mut grid = Vec::with_capacity(wide * high);
    for row in 0..high {
        for column in 0..wide {
            // The grid point (1, 1) is the pixel (left, top) of the picture.
            let pixel = (left + column)
                .checked_sub(1)
                .zip((top + row).checked_sub(1))
                .filter(|&(i, j)| i < picture.width && j < picture.height)
                .map(|(i, j)| j * picture.width + i)
                .filter(|&k| labels[k] == 0 || labels[k] == part.label)
                .map_or(0, |k| heights.heights[k]);
            grid.push(f64::from(pixel));
        }
    }
    let lines = ContourBuilder::new(wide, high, true)
        .lines(&grid, &[heights.level])
        .map_err(|error| Error::data(place, error.to_string()))?;
    let rings = lines.into_iter().flat_map(|line| line.into_inner().0.0);
    let (x_offset, y_offset) = (coordinate(left) - 1.0, coordinate(top) - 1.0);
    let picture_height = coordinate(picture.height);
    let in_picture = rings.map(|ring| -> Vec<[f64; 2]> {
        let points = ring.0.iter();
        points
            .map(|p| [p.x + x_offset, picture_height - (p.y + y_offset)])
            .collect()
    });
    let with_areas = in_picture.map(|ring| (signed_area(&ring), ring));
    let mut rings: Vec<(f64, Vec<[f64; 2]>)> = with_areas.collect();
    // A hole is within the outer boundary, so the boundary encloses more.
    rings.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    let mut rings = rings.into_iter();
    let Some((outer, ring)) = rings.next() else {
        return Err(Error::data(place, "no silhouette: no outline was found"));
    };
    // Holes are traced the other way round.
    let holes = rings.filter(|(area, _)| (*area < 0.0) != (outer < 0.0));
    Ok((ring, holes.count()))
}

fn coordinate(pixels: usize) -> f64 {
    u32::try_from(pixels).map_or(f64::INFINITY, f64::from)
}

#[cfg(test)]
#[path = "silhouette_laws.rs"]
mod laws;
