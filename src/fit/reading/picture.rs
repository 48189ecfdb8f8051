//! A picture is decoded into one height a pixel: large where the silhouette is, 0 where the background is.

use super::OutlineOptions;
use super::pixels::{Pixels, Samples};
use crate::error::{Error, Invariant, Result};

/// A frame is at most this part of the picture's shorter side thick.
const THICKEST_FRAME: usize = 50;

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
        let pixels = Pixels::decode(bytes, place)?;
        let (size, orientation) = ([pixels.width, pixels.height], pixels.orientation);
        let (values, is_mask) = values(&pixels);
        let (values, [width, height]) = orientation.shown(values, size);
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

/// The values of the pixels, and whether they are those of the alpha channel: it is the mask if most border pixels are
/// transparent and others are not.
fn values(pixels: &Pixels) -> (Vec<u8>, bool) {
    let &Pixels {
        width, channels, ..
    } = pixels;
    match &pixels.samples {
        Samples::Bytes(samples) => {
            let white = u16::from(u8::MAX);
            let byte = |value: u16| u8::try_from(value).invariant("a mean of bytes is one");
            let alpha = alphas(samples, channels).map(byte).collect::<Vec<u8>>();
            if is_mask(&alpha, width) {
                return (alpha, true);
            }
            let grey = greys(samples, channels, white);
            (grey.map(byte).collect(), false)
        }
        Samples::Words(samples) => {
            let byte = |value: u16| {
                let value = (u32::from(value) + 128) / 257;
                u8::try_from(value).invariant("a part of 65535, of 257, is a byte")
            };
            let alpha = alphas(samples, channels).map(byte).collect::<Vec<u8>>();
            if is_mask(&alpha, width) {
                return (alpha, true);
            }
            let grey: Vec<u16> = greys(samples, channels, u16::MAX).collect();
            (stretched(&grey), false)
        }
    }
}

/// The values of the alpha channel, if there is one.
fn alphas<T: Copy + Into<u16>>(samples: &[T], channels: usize) -> impl Iterator<Item = u16> {
    let pixels = match channels {
        2 | 4 => samples.chunks_exact(channels),
        _ => [].chunks_exact(channels),
    };
    pixels.map(|pixel| pixel[pixel.len() - 1].into())
}

/// The grey values of pixels on a white background.
fn greys<T: Copy + Into<u16>>(
    samples: &[T],
    channels: usize,
    white: u16,
) -> impl Iterator<Item = u16> {
    let grey_and_alpha = move |pixel: &[T]| match *pixel {
        [grey] => [grey.into(), white],
        [grey, alpha] => [grey.into(), alpha.into()],
        [r, g, b] => [luminance([r, g, b].map(Into::into), white), white],
        [r, g, b, alpha] => [luminance([r, g, b].map(Into::into), white), alpha.into()],
        _ => [white; 2],
    };
    let pixels = samples.chunks_exact(channels);
    pixels.map(move |pixel| on_white(grey_and_alpha(pixel), white))
}

/// The luminance of a colour of sRGB: 0.2126 R + 0.7152 G + 0.0722 B, with the digits that follow from the chromaticities
/// of Rec. ITU-R BT.709 and of the white point D65 (0.31272, 0.32903).
fn luminance(color: [u16; 3], white: u16) -> u16 {
    const PARTS: [f32; 3] = [0.212_647_84, 0.715_179_2, 0.072_173_04];
    let unit = 1.0 / f32::from(white);
    let parts = color.into_iter().zip(PARTS);
    let sum = parts.fold(0.0, |sum, (value, part)| {
        sum + f32::from(value) * unit * part
    });
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a mean of values is within their range; the parts are 1 in all but for a rounding error"
    )]
    let rounded = (sum * f32::from(white)).round() as u16;
    rounded.min(white)
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
