//! Pictures that are drawn by tests, as files.

use std::io::Cursor;

/// A picture of bytes, row by row from the top: one of grey for a pixel, or four of red, green, blue and alpha.
#[derive(Clone)]
pub(crate) struct Drawing {
    pub(crate) size: [u32; 2],
    pub(crate) channels: usize,
    pub(crate) bytes: Vec<u8>,
}

impl Drawing {
    pub(crate) fn grey(size: [u32; 2], mut value: impl FnMut(u32, u32) -> u8) -> Self {
        Self::of(size, |x, y| [value(x, y)])
    }

    pub(crate) fn rgba(size: [u32; 2], color: impl FnMut(u32, u32) -> [u8; 4]) -> Self {
        Self::of(size, color)
    }

    fn of<const N: usize>(size: [u32; 2], mut pixel: impl FnMut(u32, u32) -> [u8; N]) -> Self {
        let [width, height] = size;
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Self {
            size,
            channels: N,
            bytes: places.flat_map(|(x, y)| pixel(x, y)).collect(),
        }
    }

    pub(crate) fn png(&self) -> Vec<u8> {
        let color = match self.channels {
            1 => png::ColorType::Grayscale,
            _ => png::ColorType::Rgba,
        };
        png(self.size, color, png::BitDepth::Eight, &self.bytes)
    }

    /// JPEG has no alpha.
    pub(crate) fn jpeg(&self, quality: u8) -> Vec<u8> {
        let color = match self.channels {
            1 => jpeg_encoder::ColorType::Luma,
            _ => jpeg_encoder::ColorType::Rgba,
        };
        let mut file = Vec::new();
        let [width, height] = self.size.map(|side| u16::try_from(side).unwrap());
        jpeg_encoder::Encoder::new(&mut file, quality)
            .encode(&self.bytes, width, height, color)
            .unwrap();
        file
    }

    /// Grey values are indices of a palette, and colours have masks.
    pub(crate) fn bmp(&self) -> Vec<u8> {
        let [width, height] = self.size.map(|side| i32::try_from(side).unwrap());
        let rows = self
            .bytes
            .chunks_exact(self.bytes.len() / self.size[1] as usize);
        let pixels = rows.rev().flat_map(|row| {
            let padding = row.len().next_multiple_of(4) - row.len();
            row.iter().copied().chain(std::iter::repeat_n(0, padding))
        });
        let (header, bits, compression, table) = match self.channels {
            1 => (40, 8, 0, (0..=255).flat_map(|v| [v, v, v, 0]).collect()),
            _ => {
                let masks = [0xff_u32, 0xff00, 0xff_0000, 0xff00_0000];
                let masks: Vec<u8> = masks.into_iter().flat_map(u32::to_le_bytes).collect();
                (56, 32, 3, masks)
            }
        };
        bmp(
            header,
            [width, height],
            bits,
            compression,
            &table,
            pixels.collect(),
        )
    }
}

/// A bitmap: its header of so many bytes, width and height, the number of bits of a pixel, its compression, what is between
/// the header and the pixels (masks that belong to the header, or a palette), and the pixels.
pub(crate) fn bmp(
    header: u32,
    size: [i32; 2],
    bits: u16,
    compression: u32,
    table: &[u8],
    pixels: Vec<u8>,
) -> Vec<u8> {
    let mut file = b"BM".to_vec();
    let long = |file: &mut Vec<u8>, value: u32| file.extend(value.to_le_bytes());
    for value in [0, 0, 0, header] {
        long(&mut file, value);
    }
    if header == 12 {
        for side in size {
            file.extend(u16::try_from(side).unwrap().to_le_bytes());
        }
        file.extend([1, 0]);
        file.extend(bits.to_le_bytes());
    } else {
        file.extend(size.into_iter().flat_map(i32::to_le_bytes));
        file.extend([1, 0]);
        file.extend(bits.to_le_bytes());
        for value in [compression, 0, 0, 0, 0, 0] {
            long(&mut file, value);
        }
    }
    file.extend(table);
    let start = u32::try_from(file.len()).unwrap();
    file[10..14].copy_from_slice(&start.to_le_bytes());
    file.extend(pixels);
    let length = u32::try_from(file.len()).unwrap();
    file[2..6].copy_from_slice(&length.to_le_bytes());
    file
}

/// A PNG file of these samples.
pub(crate) fn png(
    [width, height]: [u32; 2],
    color: png::ColorType,
    depth: png::BitDepth,
    samples: &[u8],
) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(samples).unwrap();
    writer.finish().unwrap();
    file.into_inner()
}
