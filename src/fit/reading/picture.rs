//! A picture is decoded into one height a pixel: large where the silhouette is, 0 where the background is.

use std::io::Cursor;

use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};
use zune_core::bytestream::ZCursor;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

use super::OutlineOptions;
use crate::error::{Error, Invariant, Result};

/// The longest side of a picture, in pixels.
const MAX_SIDE: u32 = 20_000;
/// The largest number of pixels of a picture.
const MAX_PIXELS: u64 = 64_000_000;
/// A frame is at most this part of the picture's shorter side thick.
const THICKEST_FRAME: usize = 50;
/// The largest amount of memory that decoding may take.
const MAX_ALLOC: u64 = 1 << 30;

/// Whether GIF, TIFF and WebP pictures are read.
const MORE: bool = cfg!(feature = "more-images");
/// The pictures that are read.
const READ: &str = match MORE {
    true => "PNG, JPEG, BMP, GIF, TIFF or WebP",
    false => "PNG, JPEG or BMP",
};

/// Markers of JPEG files. In the data of a scan the byte 0xff is followed by 0, so that no pair of its bytes is one of these.
const START_OF_SCAN: [u8; 2] = [0xff, 0xda];
const END_OF_IMAGE: [u8; 2] = [0xff, 0xd9];

/// Values 0 to 255, row by row from the top.
pub(super) struct Picture {
    pub(super) width: usize,
    pub(super) height: usize,
    values: Vec<u8>,
    /// Whether the values are those of an alpha channel, in which the silhouette is opaque.
    is_mask: bool,
}

/// The silhouette in a picture: it has the pixels whose heights are above the level, which no pixel has.
pub(super) struct Heights {
    pub(super) heights: Vec<u8>,
    pub(super) level: f64,
    /// The thickness of the frame around the picture that was left out, in pixels.
    pub(super) frame: usize,
}

impl Picture {
    pub(super) fn decode(bytes: &[u8], place: &str) -> Result<Self> {
        let unreadable = |error: &dyn std::fmt::Display| {
            Error::decoding(place, "the picture is damaged or ends in the middle", error)
        };
        let mut reader = ImageReader::new(Cursor::new(bytes))
            .with_guessed_format()
            .map_err(|error| unreadable(&error))?;
        match reader.format() {
            Some(ImageFormat::Jpeg) => check_jpeg(bytes, place)?,
            Some(ImageFormat::Png | ImageFormat::Bmp) => {}
            Some(ImageFormat::Gif | ImageFormat::Tiff | ImageFormat::WebP) if MORE => {}
            Some(more @ (ImageFormat::Gif | ImageFormat::Tiff | ImageFormat::WebP)) => {
                let name = match more {
                    ImageFormat::Gif => "GIF",
                    ImageFormat::Tiff => "TIFF",
                    _ => "WebP",
                };
                return Err(Error::Usage(format!(
                    "{place}: {name} pictures are read by stellate with the feature `more-images` only \
                     (cargo install --path . --features more-images); or save it as .png"
                )));
            }
            _ => return Err(Error::data(place, format!("not a {READ} picture"))),
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
        let side = |pixels: u32| usize::try_from(pixels).invariant("a picture fits in memory");
        let (width, height) = (side(image.width()), side(image.height()));
        let (values, is_mask) = values(image, width);
        Ok(Self {
            width,
            height,
            values,
            is_mask,
        })
    }

    /// The silhouette: the class of pixels that is not the background. The background is transparent where the picture has
    /// an alpha channel as its mask, and otherwise the class of most border pixels.
    ///
    /// # Errors
    /// [`Error::Data`] if all pixels have one value.
    pub(super) fn heights(&self, options: &OutlineOptions, place: &str) -> Result<Heights> {
        let split = options.threshold.or_else(|| otsu(&self.values));
        let is_plain = |split: u8| {
            let above = self.values.iter().filter(|&&value| value > split).count();
            above == 0 || above == self.values.len()
        };
        let Some(split) = split.filter(|&split| !is_plain(split)) else {
            let reason = match options.threshold {
                None => "all have one colour".into(),
                Some(threshold) => format!("no colour is beyond --threshold {threshold}"),
            };
            return Err(Error::data(
                place,
                format!("no silhouette: every pixel is background ({reason})"),
            ));
        };
        let frame = if self.is_mask { 0 } else { self.frame(split) };
        let at = |depth: usize| self.ring(depth).map(|k| self.values[k]);
        let bright = at(frame).filter(|&value| value > split).count();
        let background_is_bright = !self.is_mask && 2 * bright >= at(frame).count();
        let mut values = self.values.clone();
        for k in (0..frame).flat_map(|depth| self.ring(depth)) {
            values[k] = if background_is_bright { 255 } else { 0 };
        }
        let level = f64::from(split) + 0.5;
        Ok(if background_is_bright != options.invert {
            let heights = values.iter().map(|value| 255 - value).collect();
            Heights {
                heights,
                level: 255.0 - level,
                frame,
            }
        } else {
            Heights {
                heights: values,
                level,
                frame,
            }
        })
    }

    /// The thickness of a frame around the picture: pixels of one class at the border, and of the other class all around
    /// within them. 0 if there is none.
    fn frame(&self, split: u8) -> usize {
        let thickest = self.width.min(self.height) / THICKEST_FRAME;
        let bright = |depth: usize| {
            let (mut bright, mut all) = (0, 0);
            for k in self.ring(depth) {
                bright += usize::from(self.values[k] > split);
                all += 1;
            }
            // All pixels but a few.
            let few = all / 50;
            if bright >= all - few {
                Some(true)
            } else {
                (bright <= few).then_some(false)
            }
        };
        let Some(border) = bright(0) else { return 0 };
        let inner = (1..=thickest).find(|&depth| bright(depth) != Some(border));
        inner
            .filter(|&depth| bright(depth) == Some(!border))
            .unwrap_or(0)
    }

    /// The pixels that are this far from the border.
    fn ring(&self, depth: usize) -> impl Iterator<Item = usize> {
        let (width, height) = (self.width, self.height);
        let (right, bottom) = (width - 1 - depth, height - 1 - depth);
        let rows = (depth..=right).flat_map(move |i| [(i, depth), (i, bottom)]);
        let columns = (depth..=bottom).flat_map(move |j| [(depth, j), (right, j)]);
        rows.chain(columns).map(move |(i, j)| j * width + i)
    }
}

/// Decodes a JPEG picture without the tolerance of most decoders: a file that ends in the middle, or whose data is damaged,
/// would otherwise be completed with grey.
fn check_jpeg(bytes: &[u8], place: &str) -> Result<()> {
    let side = usize::try_from(MAX_SIDE).invariant("a side fits in memory");
    let options = DecoderOptions::default()
        .set_strict_mode(true)
        .set_max_width(side + 1)
        .set_max_height(side + 1);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    let damaged = |error: &dyn std::fmt::Display| {
        Error::decoding(
            place,
            "the JPEG picture is damaged or ends in the middle",
            error,
        )
    };
    decoder.decode_headers().map_err(|error| damaged(&error))?;
    let info = decoder
        .info()
        .invariant("headers that were decoded have their information");
    if u64::from(info.width) * u64::from(info.height) > MAX_PIXELS {
        // The limit is named where the size of every picture is checked.
        return Ok(());
    }
    decoder.decode().map_err(|error| damaged(&error))?;
    // The marker of the end comes after that of the last scan.
    let last = |marker: [u8; 2]| bytes.windows(2).rposition(|pair| pair == marker);
    match last(END_OF_IMAGE) > last(START_OF_SCAN) {
        true => Ok(()),
        false => Err(damaged(&"the marker of its end is missing")),
    }
}

/// The values of the pixels, and whether they are those of the alpha channel: it is the mask if most border pixels are
/// transparent and others are not.
fn values(image: DynamicImage, width: usize) -> (Vec<u8>, bool) {
    let has_alpha = image.color().has_alpha();
    let channels = usize::from(image.color().channel_count());
    let is_deep = usize::from(image.color().bytes_per_pixel()) > channels;
    if has_alpha {
        let alpha: Vec<u8> = image.to_luma_alpha8().pixels().map(|p| p.0[1]).collect();
        if is_mask(&alpha, width) {
            return (alpha, true);
        }
    }
    if is_deep {
        let pixels = image.into_luma_alpha16();
        let grey: Vec<u16> = pixels.pixels().map(|p| on_white(p.0, u16::MAX)).collect();
        return (stretched(&grey), false);
    }
    let pixels = image.into_luma_alpha8();
    let grey = pixels.pixels().map(|p| {
        let [grey, alpha] = p.0.map(u16::from);
        u8::try_from(on_white([grey, alpha], 255)).invariant("a mean of values of a byte is one")
    });
    (grey.collect(), false)
}

/// Whether most pixels at the border are transparent, and some pixels are not.
fn is_mask(alpha: &[u8], width: usize) -> bool {
    let height = alpha.len() / width;
    let at_border = |k: usize| {
        let (i, j) = (k % width, k / width);
        i == 0 || j == 0 || i + 1 == width || j + 1 == height
    };
    let border = || (0..alpha.len()).filter(|&k| at_border(k));
    let transparent = border().filter(|&k| alpha[k] < 128).count();
    2 * transparent > border().count() && alpha.iter().any(|&a| a >= 128)
}

/// The grey value on a white background, for values from 0 to `white`.
fn on_white([grey, alpha]: [u16; 2], white: u16) -> u16 {
    let [grey, alpha, white] = [grey, alpha, white].map(u64::from);
    let sum = grey * alpha + white * (white - alpha);
    u16::try_from((sum + white / 2) / white).invariant("a mean of values is within their range")
}

/// Values of 16 bits from the least to the largest as 0 to 255: a mask of labels may have the values 0 and 1.
fn stretched(grey: &[u16]) -> Vec<u8> {
    let (low, high) = (grey.iter().min().copied(), grey.iter().max().copied());
    let (Some(low), Some(high)) = (low, high) else {
        return Vec::new();
    };
    let range = u32::from(high - low).max(1);
    let value = |&v: &u16| {
        let scaled = (u32::from(v - low) * 255 + range / 2) / range;
        u8::try_from(scaled).invariant("a part of 255 is a byte")
    };
    grey.iter().map(value).collect()
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
