//! The outline of a silhouette in a picture is traced.

use std::io::Cursor;

use contour::ContourBuilder;
use image::{DynamicImage, ImageDecoder, ImageReader, Limits};

use crate::error::{Error, Invariant, Result};
use crate::shape::Contour;

/// The longest side of a picture, in pixels.
const MAX_SIDE: u32 = 20_000;
/// The largest number of pixels of a picture.
const MAX_PIXELS: u64 = 64_000_000;
/// The largest amount of memory that decoding may take.
const MAX_ALLOC: u64 = 1 << 30;

/// Traces the longest outline in a picture; see [`super::contour_from_reader`] for the rules.
pub(super) fn trace_silhouette(bytes: &[u8], place: &str) -> Result<Contour> {
    let picture = Picture::decode(bytes, place)?;
    let Some(split) = otsu(&picture.grey) else {
        return Err(Error::data(
            place,
            "no silhouette: every pixel is background (all have one colour; transparent pixels count \
             as white)",
        ));
    };
    let (inside, level) = picture.heights(split);
    let ring = longest_outline(&picture, &inside, level, place)?;
    Contour::new(ring, place)
}

/// Grey values 0 to 255, row by row from the top.
struct Picture {
    width: usize,
    height: usize,
    grey: Vec<u8>,
}

impl Picture {
    fn decode(bytes: &[u8], place: &str) -> Result<Self> {
        let unreadable = |error: &dyn std::fmt::Display| Error::data(place, error.to_string());
        let mut reader = ImageReader::new(Cursor::new(bytes))
            .with_guessed_format()
            .map_err(|error| unreadable(&error))?;
        if reader.format().is_none() {
            return Err(Error::data(place, "not a PNG, JPEG or BMP picture"));
        }
        let mut limits = Limits::default();
        limits.max_alloc = Some(MAX_ALLOC);
        reader.limits(limits);
        let mut decoder = reader.into_decoder().map_err(|error| unreadable(&error))?;
        let (width, height) = decoder.dimensions();
        if width.max(height) > MAX_SIDE || u64::from(width) * u64::from(height) > MAX_PIXELS {
            return Err(Error::limit(format!(
                "a picture has at most {MAX_SIDE} pixels a side and {MAX_PIXELS} in all; {place} has \
                 {width} × {height}"
            )));
        }
        let orientation = decoder.orientation().map_err(|error| unreadable(&error))?;
        let mut image = DynamicImage::from_decoder(decoder).map_err(|error| unreadable(&error))?;
        image.apply_orientation(orientation);
        let pixels = image.into_luma_alpha8();
        let side = |pixels: u32| usize::try_from(pixels).invariant("a picture fits in memory");
        Ok(Self {
            width: side(pixels.width()),
            height: side(pixels.height()),
            grey: pixels.pixels().map(|p| on_white(p.0)).collect(),
        })
    }

    /// The height of every pixel, which is larger inside the silhouette and 0 for the plainest background; and the level
    /// between inside and outside, which no pixel has.
    fn heights(&self, split: u8) -> (Vec<u8>, f64) {
        let border: Vec<u8> = (0..self.width)
            .flat_map(|i| [(i, 0), (i, self.height - 1)])
            .chain((0..self.height).flat_map(|j| [(0, j), (self.width - 1, j)]))
            .map(|(i, j)| self.grey[j * self.width + i])
            .collect();
        let bright = border.iter().filter(|&&grey| grey > split).count();
        let level = f64::from(split) + 0.5;
        if 2 * bright >= border.len() {
            (
                self.grey.iter().map(|grey| 255 - grey).collect(),
                255.0 - level,
            )
        } else {
            (self.grey.clone(), level)
        }
    }
}

/// The grey value on a white background.
fn on_white([grey, alpha]: [u8; 2]) -> u8 {
    let sum = u32::from(grey) * u32::from(alpha) + 255 * (255 - u32::from(alpha));
    u8::try_from((sum + 127) / 255).invariant("a mean of grey values is one")
}

/// Otsu's threshold: the value v for which the variance between the classes `≤ v` and `> v` is largest. If several values are
/// best, the middle one of their first run is taken. `None` if all pixels have one value.
fn otsu(grey: &[u8]) -> Option<u8> {
    let mut histogram = [0u64; 256];
    for &value in grey {
        histogram[usize::from(value)] += 1;
    }
    let total: u64 = histogram.iter().sum();
    let weighted: u64 = (0u64..).zip(&histogram).map(|(v, count)| v * count).sum();
    let (mut below, mut weighted_below) = (0u64, 0u64);
    let mut best: Option<(f64, u8, u8)> = None;
    for (value, count) in (0u8..=254).zip(histogram) {
        below += count;
        weighted_below += u64::from(value) * count;
        if below == 0 || below == total {
            continue;
        }
        let (low, high) = (small(below), small(total - below));
        let gap = small(weighted - weighted_below) / high - small(weighted_below) / low;
        let variance = low * high * gap * gap;
        match &mut best {
            Some((most, _, last)) if variance <= *most => {
                // A value that no pixel has gives the same classes as the value before it.
                if count == 0 && *last + 1 == value {
                    *last = value;
                }
            }
            _ => best = Some((variance, value, value)),
        }
    }
    best.map(|(_, first, last)| u8::midpoint(first, last))
}

#[expect(
    clippy::cast_precision_loss,
    reason = "at most 64 million pixels times 255 is below 2^53"
)]
fn small(count: u64) -> f64 {
    count as f64
}

/// The longest closed line at `level`, in the picture's coordinates with y upwards.
fn longest_outline(
    picture: &Picture,
    heights: &[u8],
    level: f64,
    place: &str,
) -> Result<Vec<[f64; 2]>> {
    // Only the rectangle around the silhouette is traced, with one more pixel on each side. Everything beyond the picture is
    // background.
    let inside = |i: usize, j: usize| f64::from(heights[j * picture.width + i]) > level;
    let columns: Vec<usize> = (0..picture.width)
        .filter(|&i| (0..picture.height).any(|j| inside(i, j)))
        .collect();
    let rows: Vec<usize> = (0..picture.height)
        .filter(|&j| (0..picture.width).any(|i| inside(i, j)))
        .collect();
    let (Some((left, right)), Some((top, bottom))) = (
        columns.first().zip(columns.last()),
        rows.first().zip(rows.last()),
    ) else {
        return Err(Error::data(
            place,
            "no silhouette: every pixel is background",
        ));
    };
    let (wide, high) = (right - left + 3, bottom - top + 3);
    let mut grid = Vec::with_capacity(wide * high);
    for row in 0..high {
        for column in 0..wide {
            // The grid point (1, 1) is the pixel (left, top) of the picture.
            let pixel = (left + column)
                .checked_sub(1)
                .zip((top + row).checked_sub(1))
                .filter(|&(i, j)| i < picture.width && j < picture.height)
                .map_or(0, |(i, j)| heights[j * picture.width + i]);
            grid.push(f64::from(pixel));
        }
    }
    let lines = ContourBuilder::new(wide, high, true)
        .lines(&grid, &[level])
        .map_err(|error| Error::data(place, error.to_string()))?;
    let (x_offset, y_offset) = (coordinate(*left) - 1.0, coordinate(*top) - 1.0);
    let picture_height = coordinate(picture.height);
    lines
        .into_iter()
        .flat_map(|line| line.into_inner().0.0)
        .map(|ring| -> Vec<[f64; 2]> {
            ring.0
                .iter()
                .map(|p| [p.x + x_offset, picture_height - (p.y + y_offset)])
                .collect()
        })
        .max_by(|a, b| length(a).total_cmp(&length(b)))
        .ok_or_else(|| Error::data(place, "no silhouette: no outline was found"))
}

fn coordinate(pixels: usize) -> f64 {
    u32::try_from(pixels).map_or(f64::INFINITY, f64::from)
}

fn length(ring: &[[f64; 2]]) -> f64 {
    ring.windows(2)
        .map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]))
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{GrayImage, ImageFormat, Luma, Rgba, RgbaImage};

    fn encoded(image: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
        let mut bytes = Cursor::new(Vec::new());
        image.into().write_to(&mut bytes, format).unwrap();
        bytes.into_inner()
    }

    /// A disc with smooth borders: the grey value of a pixel is roughly the part of it that is covered.
    fn disc(size: u32, center: [f64; 2], radius: f64, inside: f64, outside: f64) -> GrayImage {
        GrayImage::from_fn(size, size, |i, j| {
            let (x, y) = (f64::from(i) + 0.5, f64::from(size - j) - 0.5);
            let depth = radius - (x - center[0]).hypot(y - center[1]);
            let part = (depth + 0.5).clamp(0.0, 1.0);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a grey value"
            )]
            Luma([(part * inside + (1.0 - part) * outside).round() as u8])
        })
    }

    #[test]
    fn a_disc_is_traced_to_a_fraction_of_a_pixel() {
        for (inside, outside) in [(0.0, 255.0), (255.0, 0.0), (40.0, 200.0)] {
            let image = disc(100, [40.0, 60.25], 25.0, inside, outside);
            for format in [ImageFormat::Png, ImageFormat::Bmp] {
                let outline = trace_silhouette(&encoded(image.clone(), format), "disc").unwrap();
                outline.check_invariants();
                let area = outline.area() / (std::f64::consts::PI * 625.0);
                assert!((area - 1.0).abs() < 0.005, "{area}");
                for p in outline.points() {
                    let radius = (p[0] - 40.0).hypot(p[1] - 60.25);
                    assert!((radius - 25.0).abs() < 0.15, "{p:?} at {radius}");
                }
            }
            let jpeg = encoded(image, ImageFormat::Jpeg);
            let centroid = trace_silhouette(&jpeg, "disc").unwrap().centroid();
            assert!((centroid[0] - 40.0).hypot(centroid[1] - 60.25) < 0.05);
        }
    }

    #[test]
    fn black_and_white_pixels_give_half_way_borders() {
        // A 2 × 1 block of black pixels; the corners are cut by marching squares.
        let mut image = GrayImage::from_pixel(5, 4, Luma([255]));
        image.put_pixel(1, 1, Luma([0]));
        image.put_pixel(2, 1, Luma([0]));
        let outline = trace_silhouette(&encoded(image, ImageFormat::Png), "block").unwrap();
        assert_eq!(outline.bounding_box(), [[1.0, 2.0], [3.0, 3.0]]);
    }

    #[test]
    fn a_silhouette_at_the_border_is_closed_there() {
        let mut image = GrayImage::from_pixel(8, 8, Luma([255]));
        for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1), (0, 2), (1, 2)] {
            image.put_pixel(i, j, Luma([0]));
        }
        let outline = trace_silhouette(&encoded(image, ImageFormat::Png), "corner").unwrap();
        assert_eq!(outline.bounding_box(), [[0.0, 5.0], [2.0, 8.0]]);
    }

    #[test]
    fn a_plain_picture_has_no_silhouette() {
        for image in [
            DynamicImage::from(GrayImage::from_pixel(9, 9, Luma([7]))),
            // White pixels on a transparent background are white on white.
            DynamicImage::from(RgbaImage::from_fn(9, 9, |i, _| {
                Rgba([255, 255, 255, if i == 4 { 255 } else { 0 }])
            })),
        ] {
            let error = trace_silhouette(&encoded(image, ImageFormat::Png), "plain.png");
            let message = error.unwrap_err().to_string();
            assert!(
                message.starts_with("plain.png: no silhouette: every pixel is background"),
                "{message}"
            );
        }
    }

    #[test]
    fn transparency_is_white_and_the_longest_outline_wins() {
        let image = RgbaImage::from_fn(40, 40, |i, j| {
            let big = (5..20).contains(&i) && (5..30).contains(&j);
            let small = (30..35).contains(&i) && (30..35).contains(&j);
            Rgba([0, 0, 0, if big || small { 255 } else { 0 }])
        });
        let outline = trace_silhouette(&encoded(image, ImageFormat::Png), "two").unwrap();
        assert_eq!(outline.bounding_box(), [[5.0, 10.0], [20.0, 35.0]]);
    }

    #[test]
    fn what_is_not_a_picture_is_refused() {
        assert!(trace_silhouette(b"", "a.png").is_err());
        let error = trace_silhouette(b"x,y\n1,2\n", "a.png").unwrap_err();
        assert_eq!(error.to_string(), "a.png: not a PNG, JPEG or BMP picture");
        let mut cut = encoded(disc(50, [25.0, 25.0], 9.0, 0.0, 255.0), ImageFormat::Png);
        cut.truncate(cut.len() / 2);
        assert!(trace_silhouette(&cut, "cut.png").is_err());
    }

    #[test]
    fn pictures_beyond_the_limit_are_refused_before_they_are_decoded() {
        let wide = encoded(GrayImage::new(20_001, 1), ImageFormat::Png);
        let error = trace_silhouette(&wide, "wide.png").unwrap_err();
        assert!(matches!(error, Error::Limit { .. }), "{error}");
    }
}
