//! Pictures of every kind have the pixels that were written.

use super::*;
use crate::fit::reading::encoded::{Drawing, bmp, png};
use png::{BitDepth, ColorType};

/// The samples of a picture, with words as their bytes.
fn samples(file: &[u8]) -> (usize, Vec<u16>) {
    let pixels = Pixels::decode(file, "picture").unwrap();
    let samples: Vec<u16> = match pixels.samples {
        Samples::Bytes(bytes) => bytes.into_iter().map(u16::from).collect(),
        Samples::Words(words) => words,
    };
    assert_eq!(
        samples.len(),
        pixels.width * pixels.height * pixels.channels
    );
    (pixels.channels, samples)
}

fn message(file: &[u8]) -> String {
    let decoded = Pixels::decode(file, "p.x");
    decoded.err().map(|error| error.to_string()).unwrap()
}

/// Indices of a palette of five colours, in rows of seven.
const INDICES: [[usize; 7]; 3] = [
    [0, 1, 0, 1, 1, 0, 1],
    [1, 1, 1, 0, 0, 0, 1],
    [0, 0, 1, 1, 0, 1, 0],
];
const COLORS: [[u8; 3]; 2] = [[10, 20, 30], [200, 100, 0]];

fn expected() -> Vec<u16> {
    let colors = INDICES.iter().flatten().flat_map(|&index| COLORS[index]);
    colors.map(u16::from).collect()
}

/// The rows of the indices, in so many bits each, as rows of whole words of so many bytes.
fn packed(bits: usize, word: usize) -> Vec<Vec<u8>> {
    let row = |row: &[usize; 7]| {
        let mut bytes = vec![0; (7 * bits).div_ceil(8).next_multiple_of(word)];
        for (k, &index) in row.iter().enumerate() {
            let byte = &mut bytes[k * bits / 8];
            *byte |= u8::try_from(index << (8 - bits - k * bits % 8)).unwrap();
        }
        bytes
    };
    INDICES.iter().map(row).collect()
}

fn table(entry: usize) -> Vec<u8> {
    let colors = COLORS.iter().flat_map(|&[r, g, b]| {
        let all = [b, g, r, 99];
        all.into_iter().take(entry)
    });
    colors.collect()
}

#[test]
fn bitmaps_with_palettes_have_their_colours() {
    for bits in [1, 2, 4, 8] {
        for header in [12, 40, 108] {
            if bits == 2 && header == 12 {
                continue;
            }
            let entry = if header == 12 { 3 } else { 4 };
            let mut table = [vec![0; if header == 108 { 68 } else { 0 }], table(entry)].concat();
            table.resize(if header == 108 { 68 } else { 0 } + (entry << bits), 7);
            let rows = packed(bits, 4);
            let upward: Vec<u8> = rows.iter().rev().flatten().copied().collect();
            let bits = u16::try_from(bits).unwrap();
            let file = bmp(header, [7, 3], bits, 0, &table, upward);
            assert_eq!(samples(&file), (3, expected()), "{bits} {header}");
            for end in 0..file.len() {
                assert!(Pixels::decode(&file[..end], "cut").is_err(), "{end}");
            }
            if header > 12 {
                let file = bmp(header, [7, -3], bits, 0, &table, rows.concat());
                assert_eq!(samples(&file), (3, expected()), "{bits} {header}");
            }
        }
    }
}

#[test]
fn bitmaps_with_masks_have_their_colours() {
    let masks =
        |masks: [u32; 4]| -> Vec<u8> { masks.into_iter().flat_map(u32::to_le_bytes).collect() };
    // One pixel of five bits a colour, which fills a row of 32 bits with the padding behind it.
    let word = |value: u16| [value.to_le_bytes(), [0, 0]].concat();
    let file = bmp(40, [1, 1], 16, 0, &[], word(0x10 << 10 | 1 << 5 | 0x1f));
    assert_eq!(samples(&file), (3, vec![132, 8, 255]));
    let red_of_5_green_of_6 = &masks([0xf800, 0x7e0, 0x1f, 0])[..12];
    let file = bmp(
        40,
        [1, 1],
        16,
        3,
        red_of_5_green_of_6,
        word(0x10 << 11 | 1 << 5 | 0x1f),
    );
    assert_eq!(samples(&file), (3, vec![132, 4, 255]));
    let file = bmp(
        56,
        [1, 1],
        16,
        3,
        &masks([0xf00, 0xf0, 0xf, 0xf000]),
        word(0x8f31),
    );
    assert_eq!(samples(&file), (4, vec![255, 51, 17, 136]));
    // Ten bits a colour.
    let long = |value: u32| value.to_le_bytes().to_vec();
    let ten = masks([0x3ff0_0000, 0xf_fc00, 0x3ff, 0]);
    let file = bmp(56, [1, 1], 32, 3, &ten, long(0x3ff0_0000 | 0x200 << 10 | 3));
    assert_eq!(samples(&file), (3, vec![255, 128, 0]));
    let file = bmp(40, [2, 1], 24, 0, &[], vec![1, 2, 3, 4, 5, 6, 0, 0]);
    assert_eq!(samples(&file), (3, vec![3, 2, 1, 6, 5, 4]));
    let file = bmp(40, [1, 2], 32, 0, &[], vec![1, 2, 3, 9, 4, 5, 6, 9]);
    assert_eq!(samples(&file), (3, vec![6, 5, 4, 3, 2, 1]));
    for wrong in [
        [0xf0f, 0xf0, 0, 0],
        [0, 0xf0, 0xf, 0],
        [0x10_0000, 0xf0, 0xf, 0],
    ] {
        let file = bmp(56, [1, 1], 16, 3, &masks(wrong), word(1));
        assert!(
            message(&file).contains("the picture is damaged"),
            "{wrong:?}"
        );
    }
}

/// The example of Microsoft's *Bitmap Compression*: the same indices in runs of bytes and of half bytes.
#[test]
fn runs_of_bitmaps_are_written_out() {
    let grey: Vec<u8> = (0..=255_u8).flat_map(|v| [v, v, v, 0]).collect();
    let rows = |file: &[u8]| {
        let (_, samples) = samples(file);
        let grey: Vec<u16> = samples.chunks(3).map(|color| color[0]).collect();
        grey.chunks(9)
            .rev()
            .map(<[u16]>::to_vec)
            .collect::<Vec<_>>()
    };
    let bytes: &[u8] = &[
        3, 4, 5, 6, 0, 3, 0x45, 0x56, 0x67, 0, 0,
        0, // Then a step by one row upward, and to the right.
        2, 0x78, 0, 2, 2, 1, 2, 0x1e, 0, 0, 9, 0x11, 0, 1,
    ];
    let file = bmp(40, [9, 4], 8, 1, &grey, bytes.to_vec());
    // The first row has more pixels than fit: it is as long as the picture is wide.
    assert_eq!(
        message(&file),
        "p.x: the picture is damaged or ends in the middle: a run leaves its row"
    );
    let bytes: &[u8] = &[
        3, 4, 2, 6, 0, 3, 0x45, 0x56, 0x67, 0, 0, 0, 2, 0x78, 0, 2, 2, 1, 2, 0x1e, 0, 0, 12, 0x11,
        0, 1,
    ];
    let file = bmp(40, [9, 5], 8, 1, &grey, bytes.to_vec());
    let expected = [
        vec![4, 4, 4, 6, 6, 0x45, 0x56, 0x67, 0],
        vec![0x78, 0x78, 0, 0, 0, 0, 0, 0, 0],
        vec![0, 0, 0, 0, 0x1e, 0x1e, 0, 0, 0],
        // A run that is too long ends with its row.
        vec![0x11; 9],
        vec![0; 9],
    ];
    assert_eq!(rows(&file), expected);
    for end in 0..file.len() {
        assert!(Pixels::decode(&file[..end], "cut").is_err(), "{end}");
    }
    let bytes: &[u8] = &[
        3, 4, 2, 6, 0, 3, 0x45, 0x60, 0, 0, 5, 0x78, 4, 0x1e, 0, 0, 0, 1,
    ];
    let file = bmp(40, [9, 2], 4, 2, &grey[..64], bytes.to_vec());
    assert_eq!(rows(&file)[0], [0, 4, 0, 0, 6, 4, 5, 6, 0]);
    assert_eq!(rows(&file)[1], [7, 8, 7, 8, 7, 1, 14, 1, 14]);
}

#[test]
fn headers_of_bitmaps_that_make_no_sense_are_refused() {
    let good = Drawing::grey([3, 2], |x, y| u8::try_from(x + y).unwrap()).bmp();
    assert_eq!(samples(&good).1[..6], [0, 0, 0, 1, 1, 1]);
    for (at, value, expected) in [
        (14, 64, "a header of 64 bytes is not known"),
        (18, 0, "its size is 0 × 2 pixels"),
        (26, 2, "it has 2 planes"),
        (28, 3, "the compression 0 with 3 bits a pixel is not known"),
        (30, 4, "the compression 4 with 8 bits a pixel is not known"),
        (47, 2, "it has 512 colours of 8 bits"),
        (13, 9, "unexpected end of file"),
        (20, 1, "a picture has at most 20000 pixels a side"),
    ] {
        let mut file = good.clone();
        file[at] = value;
        assert!(message(&file).contains(expected), "{}", message(&file));
    }
}

/// Palettes, few bits, transparent colours, 16 bits, and interlaced rows are what PNG adds to plain samples.
#[test]
fn pictures_of_every_kind_of_png_have_their_samples() {
    let few = packed(1, 1).concat();
    let grey = INDICES
        .iter()
        .flatten()
        .map(|&index| if index == 1 { 255 } else { 0 });
    let file = png([7, 3], ColorType::Grayscale, BitDepth::One, &few);
    assert_eq!(samples(&file), (1, grey.clone().collect()));
    for (bits, depth) in [
        (1, BitDepth::One),
        (4, BitDepth::Four),
        (8, BitDepth::Eight),
    ] {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, 7, 3);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(depth);
        encoder.set_palette(COLORS.concat());
        if bits == 4 {
            encoder.set_trns(vec![77]);
        }
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(&packed(bits, 1).concat()).unwrap();
        writer.finish().unwrap();
        let mut colors = expected();
        if bits == 4 {
            let with_alpha = colors.chunks(3).zip(INDICES.iter().flatten());
            let pixels = with_alpha.map(|(color, &index)| {
                let alpha = [77, 255][index];
                [color[0], color[1], color[2], alpha]
            });
            colors = pixels.flatten().collect();
        }
        assert_eq!(samples(&file), (if bits == 4 { 4 } else { 3 }, colors));
    }
    let words: Vec<u8> = [0_u16, 1, 256, 65535]
        .into_iter()
        .flat_map(u16::to_be_bytes)
        .collect();
    let file = png([2, 1], ColorType::GrayscaleAlpha, BitDepth::Sixteen, &words);
    assert_eq!(samples(&file), (2, vec![0, 1, 256, 65535]));
    let file = png([1, 1], ColorType::Rgba, BitDepth::Sixteen, &words);
    assert_eq!(samples(&file), (4, vec![0, 1, 256, 65535]));
}

#[test]
fn jpeg_pictures_are_grey_or_coloured_whatever_their_channels() {
    let colors = Drawing::rgba([16, 16], |_, _| [200, 100, 0, 255]);
    let near = |file: &[u8], expected: &[u16]| {
        let (channels, samples) = samples(file);
        assert_eq!(channels, expected.len());
        for pixel in samples.chunks(channels) {
            let apart = pixel.iter().zip(expected).map(|(a, b)| a.abs_diff(*b));
            assert!(apart.max() < Some(4), "{pixel:?}");
        }
    };
    near(&colors.jpeg(95), &[200, 100, 0]);
    near(&Drawing::grey([16, 16], |_, _| 120).jpeg(95), &[120]);
    // The inks of a printer: of cyan, magenta, yellow and black, written inverted.
    for color in [
        jpeg_encoder::ColorType::Cmyk,
        jpeg_encoder::ColorType::CmykAsYcck,
    ] {
        let mut file = Vec::new();
        let inks = [255 - 200, 255 - 100, 255, 0].repeat(256);
        jpeg_encoder::Encoder::new(&mut file, 95)
            .encode(&inks, 16, 16, color)
            .unwrap();
        near(&file, &[200, 100, 0]);
    }
}

/// A picture of a camera is shown upright.
#[test]
fn the_orientation_is_read_from_png_and_jpeg() {
    let exif = b"MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0";
    let orientation = |file: &[u8]| Pixels::decode(file, "picture").unwrap().orientation;
    let plain = Drawing::grey([16, 8], |x, _| u8::try_from(x).unwrap());
    let expected = Orientation::new(6);
    let mut file = Vec::new();
    let mut encoder = jpeg_encoder::Encoder::new(&mut file, 90);
    encoder
        .add_app_segment(1, [&b"Exif\0\0"[..], exif].concat())
        .unwrap();
    encoder
        .encode(&plain.bytes, 16, 8, jpeg_encoder::ColorType::Luma)
        .unwrap();
    assert_eq!(orientation(&file), expected);
    assert_ne!(orientation(&plain.jpeg(90)), expected);
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 16, 8);
    encoder.set_color(ColorType::Grayscale);
    let mut writer = encoder.write_header().unwrap();
    writer
        .write_chunk(png::chunk::ChunkType(*b"eXIf"), exif)
        .unwrap();
    writer.write_image_data(&plain.bytes).unwrap();
    writer.finish().unwrap();
    assert_eq!(orientation(&file), expected);
    assert_ne!(orientation(&plain.png()), expected);
}

#[test]
fn other_pictures_are_named() {
    for (start, name) in [
        (&b"GIF89a"[..], "GIF"),
        (b"II*\0", "TIFF"),
        (b"MM\0*", "TIFF"),
        (b"RIFF\x08\0\0\0WEBP", "WebP"),
    ] {
        let message = message(start);
        match cfg!(feature = "more-images") {
            true => assert!(message.contains("the picture is damaged"), "{message}"),
            false => assert!(
                message.starts_with(&format!("p.x: {name} pictures are read")),
                "{message}"
            ),
        }
    }
    assert!(message(b"RIFF\x08\0\0\0WAVE").contains("not a PNG, JPEG"));
}
