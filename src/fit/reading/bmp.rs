//! Bitmaps of Windows and OS/2 (BMP): with a palette, also in runs (RLE), and with colours of 16, 24 and 32 bits.
//!
//! Terms and layout are those of Microsoft, *Bitmap Header Types* and *Bitmap Compression* (learn.microsoft.com). No crate
//! reads all of these kinds and refuses files that end in the middle, but for large ones that read many formats.

use crate::error::Invariant;

/// What is wrong with a bitmap.
type Broken = String;

/// The sizes of the headers that are read: BITMAPCOREHEADER, BITMAPINFOHEADER and versions 2 to 5 of the latter.
const CORE: u32 = 12;
const HEADERS: [u32; 6] = [CORE, 40, 52, 56, 108, 124];
/// Where the header begins, behind that of the file.
const HEADER: usize = 14;

/// The header of a bitmap, and the whole file.
#[derive(Debug)]
pub(super) struct Bitmap<'a> {
    bytes: &'a [u8],
    pub(super) width: u32,
    pub(super) height: u32,
    /// The first row of the file is the lowest one.
    is_upward: bool,
    /// The number of bits of a pixel.
    bits: u32,
    coding: Coding,
    /// Where the pixels begin.
    data: usize,
}

/// How pixels are written.
#[derive(Debug)]
enum Coding {
    /// Indices of colours, row by row.
    Palette(Vec<[u8; 3]>),
    /// Runs of pixels of one index.
    Runs(Vec<[u8; 3]>),
    /// Red, green, blue and alpha, each in the bits of a mask.
    Masks([Mask; 4]),
}

/// The bits of a channel.
#[derive(Clone, Copy, Debug)]
struct Mask {
    shift: u32,
    /// The largest value; 0 if the channel is missing.
    most: u32,
}

/// The colours of a bitmap, row by row from the top: three bytes a pixel, or four with alpha.
pub(super) struct Colors {
    pub(super) channels: usize,
    pub(super) bytes: Vec<u8>,
}

impl<'a> Bitmap<'a> {
    /// Reads the header and the palette.
    ///
    /// # Errors
    /// What is wrong with them, or what is not read.
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self, Broken> {
        let size = u32_at(bytes, HEADER)?;
        if !HEADERS.contains(&size) {
            return Err(format!("a header of {size} bytes is not known"));
        }
        let (width, height, at) = match size {
            CORE => (
                u16_at(bytes, HEADER + 4)?.into(),
                u16_at(bytes, HEADER + 6)?.into(),
                HEADER + 8,
            ),
            _ => (
                i32_at(bytes, HEADER + 4)?,
                i32_at(bytes, HEADER + 8)?,
                HEADER + 12,
            ),
        };
        if width <= 0 || height == 0 {
            return Err(format!("its size is {width} × {height} pixels"));
        }
        let planes = u16_at(bytes, at)?;
        if planes != 1 {
            return Err(format!("it has {planes} planes"));
        }
        let bits = u32::from(u16_at(bytes, at + 2)?);
        let (compression, used) = match size {
            CORE => (0, 0),
            _ => (u32_at(bytes, HEADER + 16)?, u32_at(bytes, HEADER + 32)?),
        };
        let end = usize_of(size) + HEADER;
        let entry = if size == CORE { 3 } else { 4 };
        let masks_at = |at: [usize; 4]| -> Result<Coding, Broken> {
            let alpha = if size < 56 { 0 } else { u32_at(bytes, at[3])? };
            let [r, g, b] = [
                u32_at(bytes, at[0])?,
                u32_at(bytes, at[1])?,
                u32_at(bytes, at[2])?,
            ];
            masks([r, g, b, alpha], bits)
        };
        let coding = match (compression, bits) {
            (0, 1 | 4 | 8) => Coding::Palette(palette(bytes, end, entry, bits, used)?),
            (0, 2) if size != CORE => Coding::Palette(palette(bytes, end, entry, bits, used)?),
            (0, 16) if size != CORE => masks([0x7c00, 0x3e0, 0x1f, 0], bits)?,
            (0, 32) if size != CORE => masks([0xff_0000, 0xff00, 0xff, 0], bits)?,
            (0, 24) => masks([0xff_0000, 0xff00, 0xff, 0], bits)?,
            (1, 8) | (2, 4) if height > 0 => Coding::Runs(palette(bytes, end, entry, bits, used)?),
            (3, 16 | 32) => masks_at([40, 44, 48, 52].map(|at| HEADER + at))?,
            _ => {
                return Err(format!(
                    "the compression {compression} with {bits} bits a pixel is not known"
                ));
            }
        };
        Ok(Self {
            bytes,
            width: width.unsigned_abs(),
            height: height.unsigned_abs(),
            is_upward: height > 0,
            bits,
            coding,
            data: usize_of(u32_at(bytes, 10)?),
        })
    }

    /// The colours of the pixels.
    ///
    /// # Errors
    /// What is wrong with the pixels: they end in the middle, or a run leaves its row.
    pub(super) fn decode(&self) -> Result<Colors, Broken> {
        let data = self.bytes.get(self.data..).ok_or_else(ends)?;
        let (width, height) = (usize_of(self.width), usize_of(self.height));
        // The bits of a row fill words of 32 bits.
        let stride = (usize_of(self.bits) * width).div_ceil(32) * 4;
        let is_whole = matches!(self.coding, Coding::Runs(_)) || data.len() / stride >= height;
        if !is_whole {
            return Err(ends());
        }
        let channels = match self.coding {
            Coding::Masks([.., alpha]) if alpha.most > 0 => 4,
            _ => 3,
        };
        let mut colors = vec![0; width * height * channels];
        let mut rows: Vec<&mut [u8]> = colors.chunks_exact_mut(width * channels).collect();
        if self.is_upward {
            rows.reverse();
        }
        match &self.coding {
            Coding::Palette(palette) => {
                for (row, line) in rows.into_iter().zip(data.chunks_exact(stride)) {
                    for (color, index) in row.chunks_exact_mut(3).zip(indices(line, self.bits)) {
                        color.copy_from_slice(&palette[index]);
                    }
                }
            }
            Coding::Runs(palette) => self.decode_runs(data, palette, &mut rows)?,
            Coding::Masks(masks) => {
                let size = usize_of(self.bits) / 8;
                for (row, line) in rows.into_iter().zip(data.chunks_exact(stride)) {
                    for (color, pixel) in
                        row.chunks_exact_mut(channels).zip(line.chunks_exact(size))
                    {
                        let little_end = |value: u32, &byte: &u8| value << 8 | u32::from(byte);
                        let value = pixel.iter().rev().fold(0, little_end);
                        for (channel, mask) in color.iter_mut().zip(masks) {
                            *channel = mask.of(value);
                        }
                    }
                }
            }
        }
        Ok(Colors {
            channels,
            bytes: colors,
        })
    }

    /// Runs: the number of pixels and their index; or 0 and 0 at the end of a row, 0 and 1 at that of the picture, 0 and 2
    /// before a step to the right and upward, and 0 and a larger number before as many indices. Pixels that are stepped
    /// over stay black.
    fn decode_runs(
        &self,
        data: &[u8],
        palette: &[[u8; 3]],
        rows: &mut [&mut [u8]],
    ) -> Result<(), Broken> {
        let mut data = data.iter().copied();
        let mut next = || data.next().ok_or_else(ends);
        let leaves = || "a run leaves its row".to_owned();
        let (mut x, mut y) = (0, 0);
        while let Some(row) = rows.get_mut(y) {
            let mut set = |x: usize, index: usize| {
                let color = row.get_mut(3 * x..3 * x + 3);
                color.map(|color| color.copy_from_slice(&palette[index]))
            };
            match (next()?, next()?) {
                (0, 0) => (x, y) = (0, y + 1),
                (0, 1) => return Ok(()),
                (0, 2) => {
                    x += usize::from(next()?);
                    y += usize::from(next()?);
                    if x > usize_of(self.width) || y >= rows.len() {
                        return Err(leaves());
                    }
                }
                (0, count) => {
                    // Indices of full words of 16 bits.
                    let size = (u32::from(count) * self.bits).div_ceil(16) * 2;
                    let line = (0..size).map(|_| next()).collect::<Result<Vec<u8>, _>>()?;
                    for index in indices(&line, self.bits).take(count.into()) {
                        set(x, index).ok_or_else(leaves)?;
                        x += 1;
                    }
                }
                (count, pair) => {
                    let pair: Vec<usize> = indices(&[pair], self.bits).collect();
                    for &index in pair.iter().cycle().take(count.into()) {
                        // Some programs write runs of bytes that are longer than the rest of the row.
                        if set(x, index).is_none() && self.bits == 4 {
                            return Err(leaves());
                        }
                        x += 1;
                    }
                }
            }
        }
        Ok(())
    }
}

impl Mask {
    fn new(mask: u32, bits: u32) -> Result<Self, Broken> {
        let shift = mask.trailing_zeros() % 32;
        let most = mask >> shift;
        if most & most.wrapping_add(1) != 0 || u64::from(mask) >> bits != 0 {
            return Err(format!("{mask:#x} is no mask of {bits} bits"));
        }
        Ok(Self { shift, most })
    }

    /// The channel of a pixel, from 0 to 255.
    fn of(self, value: u32) -> u8 {
        let value = value >> self.shift & self.most;
        // Of more than eight bits the first eight are taken.
        let finer = (32 - self.most.leading_zeros()).saturating_sub(8);
        let (value, most) = (value >> finer, self.most >> finer);
        let scaled = (value * 255 + most / 2).checked_div(most);
        let scaled = scaled.invariant("a channel that is read has bits");
        u8::try_from(scaled).invariant("a value is at most the largest one")
    }
}

fn masks(masks: [u32; 4], bits: u32) -> Result<Coding, Broken> {
    let [r, g, b, alpha] = masks.map(|mask| Mask::new(mask, bits));
    let masks = [r?, g?, b?, alpha?];
    match masks[..3].iter().all(|mask| mask.most > 0) {
        true => Ok(Coding::Masks(masks)),
        false => Err("a colour has no bits".into()),
    }
}

/// The colours of a palette: blue, green and red. Colours behind its end are black.
fn palette(
    bytes: &[u8],
    at: usize,
    entry: usize,
    bits: u32,
    used: u32,
) -> Result<Vec<[u8; 3]>, Broken> {
    let most = 1 << bits;
    if used > most {
        return Err(format!("it has {used} colours of {bits} bits"));
    }
    let count = usize_of(if used == 0 { most } else { used });
    let colors = bytes.get(at..at + count * entry).ok_or_else(ends)?;
    let colors = colors
        .chunks_exact(entry)
        .map(|color| [color[2], color[1], color[0]]);
    let black = std::iter::repeat([0; 3]);
    Ok(colors.chain(black).take(256).collect())
}

/// The indices in a row of pixels of at most eight bits.
fn indices(line: &[u8], bits: u32) -> impl Iterator<Item = usize> {
    let parts = (0..8 / bits).rev();
    let shifts = parts.map(move |part| part * bits);
    line.iter().flat_map(move |&byte| {
        let part = move |shift: u32| usize::from(byte) >> shift & ((1 << bits) - 1);
        shifts.clone().map(part)
    })
}

fn ends() -> Broken {
    "unexpected end of file".into()
}

fn array<const N: usize>(bytes: &[u8], at: usize) -> Result<[u8; N], Broken> {
    let found = bytes.get(at..).and_then(|rest| rest.first_chunk());
    found.copied().ok_or_else(ends)
}

fn u16_at(bytes: &[u8], at: usize) -> Result<u16, Broken> {
    array(bytes, at).map(u16::from_le_bytes)
}

fn u32_at(bytes: &[u8], at: usize) -> Result<u32, Broken> {
    array(bytes, at).map(u32::from_le_bytes)
}

fn i32_at(bytes: &[u8], at: usize) -> Result<i32, Broken> {
    array(bytes, at).map(i32::from_le_bytes)
}

/// A number of a file as an index.
fn usize_of(number: u32) -> usize {
    usize::try_from(number).invariant("an index has at least 32 bits")
}
