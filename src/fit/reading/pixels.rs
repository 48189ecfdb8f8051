//! The pixels of a picture, as its file has them.

use std::fmt::Display;
use std::io::Cursor;

use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

use super::bmp::Bitmap;
use super::orientation::Orientation;
use crate::error::{Error, Invariant, Result};

/// The longest side of a picture, in pixels.
const MAX_SIDE: usize = 20_000;
/// The largest number of pixels of a picture.
const MAX_PIXELS: usize = 64_000_000;
/// The largest amount of memory that decoding may take.
const MAX_ALLOC: usize = 1 << 30;

/// The pictures that are read.
const READ: &str = match cfg!(feature = "more-images") {
    true => "PNG, JPEG, BMP, GIF, TIFF or WebP",
    false => "PNG, JPEG or BMP",
};

/// Markers of JPEG files. In the data of a scan the byte 0xff is followed by 0, so that no pair of its bytes is one of these.
const START_OF_SCAN: [u8; 2] = [0xff, 0xda];
const END_OF_IMAGE: [u8; 2] = [0xff, 0xd9];

/// The pixels of a picture, row by row from the top.
pub(super) struct Pixels {
    pub(super) width: usize,
    pub(super) height: usize,
    /// The number of samples of a pixel: 1 for grey, 3 for red, green and blue, and one more with alpha.
    pub(super) channels: usize,
    pub(super) samples: Samples,
    pub(super) orientation: Orientation,
}

/// All values, from 0 to the largest integer of their type.
pub(super) enum Samples {
    Bytes(Vec<u8>),
    Words(Vec<u16>),
}

/// The formats that are known by their first bytes.
enum Format {
    Png,
    Jpeg,
    Bmp,
    Gif,
    Tiff,
    WebP,
}

impl Format {
    fn of(bytes: &[u8]) -> Option<Self> {
        let begins = |start: &[u8]| bytes.starts_with(start);
        let is_webp = begins(b"RIFF") && bytes.get(8..12) == Some(b"WEBP");
        let formats = [
            (begins(b"\x89PNG\r\n\x1a\n"), Self::Png),
            (begins(b"\xff\xd8\xff"), Self::Jpeg),
            (begins(b"BM"), Self::Bmp),
            (begins(b"GIF87a") || begins(b"GIF89a"), Self::Gif),
            (begins(b"MM\0*") || begins(b"II*\0"), Self::Tiff),
            (is_webp, Self::WebP),
        ];
        formats
            .into_iter()
            .find_map(|(is_it, format)| is_it.then_some(format))
    }
}

impl Pixels {
    /// # Errors
    /// [`Error::Data`] for a file that is not a picture, damaged or incomplete; [`Error::Limit`] if the picture is too large;
    /// [`Error::Usage`] for a picture that is read by another build only.
    pub(super) fn decode(bytes: &[u8], place: &str) -> Result<Self> {
        match Format::of(bytes) {
            Some(Format::Png) => Self::of_png(bytes, place),
            Some(Format::Jpeg) => Self::of_jpeg(bytes, place),
            Some(Format::Bmp) => Self::of_bmp(bytes, place),
            Some(Format::Gif) => Self::of_more(bytes, place, "GIF"),
            Some(Format::Tiff) => Self::of_more(bytes, place, "TIFF"),
            Some(Format::WebP) => Self::of_more(bytes, place, "WebP"),
            None => Err(Error::data(place, format!("not a {READ} picture"))),
        }
    }

    fn of_png(bytes: &[u8], place: &str) -> Result<Self> {
        let broken = |error: png::DecodingError| unreadable(place, &error);
        let limits = png::Limits { bytes: MAX_ALLOC };
        let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), limits);
        // Colours of palettes, grey values of fewer than eight bits and transparent colours become samples.
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().map_err(broken)?;
        let [width, height] = checked(<[u32; 2]>::from(reader.info().size()), place)?;
        let size = reader
            .output_buffer_size()
            .invariant("a picture within the limits fits in memory");
        let mut samples = vec![0; size];
        let frame = reader.next_frame(&mut samples).map_err(broken)?;
        let info = reader.info();
        Ok(Self {
            width,
            height,
            channels: frame.color_type.samples(),
            samples: match frame.bit_depth {
                png::BitDepth::Sixteen => {
                    let (words, _) = samples.as_chunks();
                    Samples::Words(words.iter().copied().map(u16::from_be_bytes).collect())
                }
                _ => Samples::Bytes(samples),
            },
            orientation: Orientation::of_exif(info.exif_metadata.as_deref()),
        })
    }

    /// Decodes a JPEG picture without the tolerance of most decoders: a file that ends in the middle, or whose data is
    /// damaged, would otherwise be completed with grey.
    fn of_jpeg(bytes: &[u8], place: &str) -> Result<Self> {
        let damaged = |error: &dyn Display| {
            let what = "the JPEG picture is damaged or ends in the middle";
            Error::decoding(place, what, error)
        };
        let largest = usize::from(u16::MAX);
        let options = DecoderOptions::default()
            .set_strict_mode(true)
            .set_max_width(largest)
            .set_max_height(largest);
        let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
        decoder.decode_headers().map_err(|error| damaged(&error))?;
        let header = "headers that were decoded have their information";
        let (width, height) = decoder.dimensions().invariant(header);
        let [width, height] = checked([width, height], place)?;
        let (space, channels) = match decoder.input_colorspace().invariant(header) {
            ColorSpace::Luma => (ColorSpace::Luma, 1),
            _ => (ColorSpace::RGB, 3),
        };
        decoder.set_options(options.jpeg_set_out_colorspace(space));
        let samples = decoder.decode().map_err(|error| damaged(&error))?;
        // The marker of the end comes after that of the last scan.
        let last = |marker: [u8; 2]| bytes.windows(2).rposition(|pair| pair == marker);
        if last(END_OF_IMAGE) <= last(START_OF_SCAN) {
            return Err(damaged(&"the marker of its end is missing"));
        }
        Ok(Self {
            width,
            height,
            channels,
            samples: Samples::Bytes(samples),
            orientation: Orientation::of_exif(decoder.exif().map(Vec::as_slice)),
        })
    }

    fn of_bmp(bytes: &[u8], place: &str) -> Result<Self> {
        let broken = |error: String| unreadable(place, &error);
        let bitmap = Bitmap::new(bytes).map_err(broken)?;
        let [width, height] = checked([bitmap.width, bitmap.height], place)?;
        let colors = bitmap.decode().map_err(broken)?;
        Ok(Self {
            width,
            height,
            channels: colors.channels,
            samples: Samples::Bytes(colors.bytes),
            orientation: Orientation::UPRIGHT,
        })
    }

    /// A GIF, TIFF or WebP picture.
    #[cfg(feature = "more-images")]
    fn of_more(bytes: &[u8], place: &str, _: &str) -> Result<Self> {
        use image::{DynamicImage, ImageDecoder, ImageError, ImageReader, Limits};

        let broken = |error: ImageError| unreadable(place, &error);
        let mut reader = ImageReader::new(Cursor::new(bytes))
            .with_guessed_format()
            .map_err(|error| unreadable(place, &error))?;
        let mut limits = Limits::default();
        limits.max_alloc = u64::try_from(MAX_ALLOC).ok();
        reader.limits(limits);
        let mut decoder = reader.into_decoder().map_err(broken)?;
        let [width, height] = checked(<[u32; 2]>::from(decoder.dimensions()), place)?;
        let orientation = decoder.orientation().map_err(broken)?;
        let image = DynamicImage::from_decoder(decoder).map_err(broken)?;
        let color = image.color();
        let samples = match color.bytes_per_pixel() > color.channel_count() {
            true => Samples::Words(image.into_luma_alpha16().into_raw()),
            false => Samples::Bytes(image.into_luma_alpha8().into_raw()),
        };
        Ok(Self {
            width,
            height,
            channels: 2,
            samples,
            orientation: Orientation::new(orientation.to_exif()),
        })
    }

    /// A GIF, TIFF or WebP picture.
    #[cfg(not(feature = "more-images"))]
    fn of_more(_: &[u8], place: &str, name: &str) -> Result<Self> {
        Err(Error::Usage(format!(
            "{place}: {name} pictures are read by stellate with the feature `more-images` only \
             (cargo install --path . --features more-images); or save it as .png"
        )))
    }
}

fn unreadable(place: &str, error: &dyn Display) -> Error {
    Error::decoding(place, "the picture is damaged or ends in the middle", error)
}

/// The width and height of a picture that is not too large.
fn checked<T: TryInto<usize> + Display + Copy>(sides: [T; 2], place: &str) -> Result<[usize; 2]> {
    let side = |side: T| side.try_into().ok().filter(|&side| side <= MAX_SIDE);
    let within = |&[width, height]: &[usize; 2]| width * height <= MAX_PIXELS;
    let [width, height] = sides;
    let both = side(width).zip(side(height)).map(|(w, h)| [w, h]);
    both.filter(within).ok_or_else(|| {
        Error::limit(format!(
            "a picture has at most {MAX_SIDE} pixels a side and {MAX_PIXELS} in all; {place} has \
             {width} × {height}"
        ))
    })
}

#[cfg(test)]
#[path = "pixels_laws.rs"]
mod laws;
