//! Pictures: mutated files, PNG files whose check sums are right again, and PNG files of every kind of pixel.

use stellate::fit::{ContourKind, contour_from_reader};

use super::draw::Draw;
use super::harness::Outcome;
use super::mutate::{bytes_step, shown};
use super::seeds;

const PNG: [u8; 8] = [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n'];

/// The check sum of PNG (ISO 3309).
fn crc(bytes: &[u8]) -> u32 {
    let step = |crc: u32, byte: &u8| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            if crc & 1 == 1 {
                crc >> 1 ^ 0xedb8_8320
            } else {
                crc >> 1
            }
        })
    };
    !bytes.iter().fold(!0, step)
}

fn adler(bytes: &[u8]) -> u32 {
    let step = |(a, b): (u32, u32), byte: &u8| {
        let a = (a + u32::from(*byte)) % 65_521;
        (a, (b + a) % 65_521)
    };
    let (a, b) = bytes.iter().fold((1, 0), step);
    b << 16 | a
}

fn chunk(out: &mut Vec<u8>, name: &[u8; 4], data: &[u8]) {
    out.extend((data.len() as u32).to_be_bytes());
    let start = out.len();
    out.extend(name);
    out.extend(data);
    let sum = crc(&out[start..]);
    out.extend(sum.to_be_bytes());
}

/// All chunks that are whole get their check sums.
fn with_check_sums(bytes: &mut [u8]) {
    let mut at = 8;
    while let Some(length) = bytes.get(at..at + 4) {
        let length = u32::from_be_bytes(length.try_into().unwrap()) as usize;
        let end = at.saturating_add(8).saturating_add(length);
        if end.saturating_add(4) > bytes.len() {
            return;
        }
        let sum = crc(&bytes[at + 4..end]);
        bytes[end..end + 4].copy_from_slice(&sum.to_be_bytes());
        at = end + 4;
    }
}

/// A PNG file with any header, any palette, and pixels in blocks that are stored as they are.
fn any_png(draw: &mut Draw) -> Vec<u8> {
    let side = |draw: &mut Draw| match draw.below(12) {
        0 => draw.pick(&[0, 1, 20_000, 20_001, 65_536, u32::MAX, 1 << 31]),
        _ => 1 + draw.below(24) as u32,
    };
    let (width, height) = (side(draw), side(draw));
    let (depth, kind) = if draw.once_in(10) {
        (draw.word() as u8, draw.word() as u8)
    } else {
        draw.pick(&[
            (1, 0),
            (2, 0),
            (4, 0),
            (8, 0),
            (16, 0),
            (8, 2),
            (16, 2),
            (1, 3),
            (4, 3),
            (8, 3),
            (8, 4),
            (16, 4),
            (8, 6),
            (16, 6),
        ])
    };
    let mut header = Vec::new();
    header.extend(width.to_be_bytes());
    header.extend(height.to_be_bytes());
    let interlaced = u8::from(draw.once_in(4));
    header.extend([depth, kind, 0, 0, interlaced]);
    let mut out = PNG.to_vec();
    chunk(&mut out, b"IHDR", &header);
    if kind == 3 || draw.once_in(10) {
        let colours = 3 * draw.pick(&[1, 2, 16, 256, 300]);
        let palette: Vec<u8> = (0..colours).map(|_| draw.word() as u8).collect();
        chunk(&mut out, b"PLTE", &palette);
    }
    if draw.once_in(4) {
        let length = draw.below(20);
        let transparent: Vec<u8> = (0..length).map(|_| draw.word() as u8).collect();
        chunk(&mut out, b"tRNS", &transparent);
    }
    let channels = match kind {
        2 => 3,
        4 => 2,
        6 => 4,
        _ => 1,
    };
    let (rows, columns) = (height.min(64) as usize, width.min(1 << 16) as usize);
    let row = 1 + (columns * channels * usize::from(depth.min(16))).div_ceil(8);
    let mut raw = vec![0; row * rows];
    let noise = draw.once_in(3);
    for (i, byte) in raw.iter_mut().enumerate() {
        let (y, x) = (i / row, i % row);
        *byte = if x == 0 {
            if draw.once_in(3) {
                draw.below(6) as u8
            } else {
                0
            }
        } else if noise {
            draw.word() as u8
        } else if y > rows / 4 && y < 3 * rows / 4 && x > row / 4 && x < 3 * row / 4 {
            0
        } else {
            0xff
        };
    }
    if draw.once_in(6) {
        raw.truncate(draw.index(raw.len() + 1));
    }
    let mut data = vec![0x78, 0x01];
    let count = raw.chunks(0xffff).len();
    for (i, block) in raw.chunks(0xffff).enumerate() {
        data.push(u8::from(i + 1 == count));
        data.extend((block.len() as u16).to_le_bytes());
        data.extend((!(block.len() as u16)).to_le_bytes());
        data.extend(block);
    }
    data.extend(adler(&raw).to_be_bytes());
    chunk(&mut out, b"IDAT", &data);
    if !draw.once_in(10) {
        chunk(&mut out, b"IEND", &[]);
    }
    out
}

pub(crate) fn any_picture(draw: &mut Draw) -> Vec<u8> {
    if draw.once_in(3) {
        return any_png(draw);
    }
    let mut bytes = draw.pick(seeds::pictures());
    for _ in 0..1 + draw.below(4) {
        if draw.once_in(2) && bytes.len() > 40 {
            // Somewhere in the header.
            let at = draw.index(40);
            bytes[at] = draw.pick(&[0, 1, 0x7f, 0x80, 0xff, 3, 8, 16, 32]);
        } else {
            bytes_step(draw, &mut bytes);
        }
    }
    if bytes.starts_with(&PNG) && !draw.once_in(8) {
        with_check_sums(&mut bytes);
    }
    bytes
}

pub(crate) fn pictures(draw: &mut Draw) -> Outcome {
    let bytes = any_picture(draw);
    draw.input = shown(&bytes);
    let result = contour_from_reader(bytes.as_slice(), ContourKind::Image, "picture");
    match result {
        Ok(contour) => {
            assert!(contour.len() >= 3);
            Outcome::Checked
        }
        Err(_) => Outcome::Open,
    }
}

#[test]
fn pictures_of_every_kind_are_read() {
    let mut read = 0;
    for seed in 0..400 {
        let mut draw = Draw::new("png", seed);
        let bytes = any_png(&mut draw);
        read += u32::from(contour_from_reader(bytes.as_slice(), ContourKind::Image, "png").is_ok());
    }
    assert!(read > 40, "{read} of 400 have an outline");
}
