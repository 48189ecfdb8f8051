//! Small files of outlines of every kind, cut, with other bits, and with parts twice.

use std::fs;
use std::path::PathBuf;

use crate::common::pictures::Drawing;
use stellate::error::Error;
use stellate::fit::{
    ContourKind, OutlineOptions, contour_from_reader, outline_from_reader, outlines_from_reader,
};
use stellate::language::Numbers;
use stellate::verb::Given;

use super::draw::Draw;
use super::harness::Outcome;
use super::mutate::{bytes_step, mutated_text, shown};

type Run = fn(&mut Draw) -> Outcome;
type Encode = fn(&Drawing) -> Vec<u8>;

/// The pictures that every build reads.
const PICTURES: [Encode; 3] = [Drawing::png, |disc| disc.jpeg(75), Drawing::bmp];

/// The kinds that every build reads.
pub(crate) const KINDS: [(&str, Run); 7] = [
    ("csv", |draw| text(draw, ContourKind::Rows, &csv())),
    ("npy", |draw| bytes(draw, ContourKind::Array, npy)),
    ("geojson", |draw| {
        text(draw, ContourKind::Polygons, &geojson())
    }),
    ("svg", |draw| text(draw, ContourKind::Drawing, &svg())),
    ("png", |draw| picture(draw, PICTURES[0])),
    ("jpg", |draw| picture(draw, PICTURES[1])),
    ("bmp", |draw| picture(draw, PICTURES[2])),
];

/// The kinds that are read with the feature `more-images`.
#[cfg(feature = "more-images")]
pub(crate) const MORE_KINDS: [(&str, Run); 3] = [
    ("gif", |draw| picture(draw, MORE_PICTURES[0])),
    ("tif", |draw| picture(draw, MORE_PICTURES[1])),
    ("webp", |draw| picture(draw, MORE_PICTURES[2])),
];

#[cfg(feature = "more-images")]
const MORE_PICTURES: [Encode; 3] = [
    |disc| more(disc, image::ImageFormat::Gif),
    |disc| more(disc, image::ImageFormat::Tiff),
    |disc| more(disc, image::ImageFormat::WebP),
];

#[cfg(feature = "more-images")]
fn more(disc: &Drawing, format: image::ImageFormat) -> Vec<u8> {
    let [width, height] = disc.size;
    let grey = image::GrayImage::from_raw(width, height, disc.bytes.clone()).unwrap();
    let disc = image::DynamicImage::from(grey);
    let disc = match format {
        image::ImageFormat::Tiff => disc,
        _ => disc.to_rgba8().into(),
    };
    let mut out = std::io::Cursor::new(Vec::new());
    disc.write_to(&mut out, format).unwrap();
    out.into_inner()
}

fn file(name: &str) -> Vec<u8> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    fs::read(root.join("tests/outlines").join(name)).unwrap()
}

fn csv() -> Vec<Vec<u8>> {
    let tables = [
        "x,y\n0,0\n4,0\n4.5,2\n4,4\n0,4\n",
        "id;X;Y\n1;0,5;0\n2;4;0\n3;4,5;2\n",
        "\"name, unit\",x,y\n\"a, b\",0,0\n\"c\",4,0\nd,1,NaN\n",
        "0\t0\n4\t0\n0x1p2\t4\n",
    ];
    tables.map(|text| text.as_bytes().to_vec()).to_vec()
}

fn geojson() -> Vec<Vec<u8>> {
    vec![file("a.geojson"), file("islands.geojson")]
}

fn svg() -> Vec<Vec<u8>> {
    let uses = br##"<svg width="9" height="9"><defs><symbol id="s" viewBox="0 0 2 2"><ellipse rx="1" ry=".5" cx="1" cy="1"/>
        </symbol></defs><use href="#s" transform="rotate(20)" width="4" height="4"/><polygon points="1,1 2,1 2,2"/></svg>"##;
    vec![file("leaf.svg"), uses.to_vec()]
}

/// A triangle as an array of one of three kinds.
fn npy(draw: &mut Draw) -> Vec<u8> {
    let (kind, order, shape, size) = draw.pick(&[
        ("<f8", "False", "(3, 2)", 8),
        (">i2", "True", "(3, 1, 2)", 2),
        ("<c8", "False", "(3,)", 4),
    ]);
    let header = format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\0".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    for value in [0_i16, 0, 5, 1, 2, 7] {
        match size {
            8 => bytes.extend(f64::from(value).to_le_bytes()),
            4 => bytes.extend(f32::from(value).to_le_bytes()),
            _ => bytes.extend(value.to_be_bytes()),
        }
    }
    bytes
}

/// A disc of 24 pixels with a hole and a speck beside it.
fn disc() -> Drawing {
    Drawing::grey([24, 20], |x, y| {
        let from = |a: u32, b: u32| (x.abs_diff(a).pow(2) + y.abs_diff(b).pow(2)) as f64;
        let dark = (4.0..60.0).contains(&from(9, 10)) || from(21, 3) < 3.0;
        if dark { 20 } else { 240 }
    })
}

fn text(draw: &mut Draw, kind: ContourKind, seeds: &[Vec<u8>]) -> Outcome {
    let bytes = mutated_text(draw, seeds);
    read(draw, &bytes, kind)
}

fn bytes(draw: &mut Draw, kind: ContourKind, seed: fn(&mut Draw) -> Vec<u8>) -> Outcome {
    let mut bytes = seed(draw);
    for _ in 0..1 + draw.below(4) {
        bytes_step(draw, &mut bytes);
    }
    read(draw, &bytes, kind)
}

fn picture(draw: &mut Draw, encode: Encode) -> Outcome {
    let mut bytes = encode(&disc());
    for _ in 0..1 + draw.below(4) {
        bytes_step(draw, &mut bytes);
    }
    read(draw, &bytes, ContourKind::Image)
}

/// A refusal is one paragraph that says something, and no contradiction.
fn is_said<T>(result: &Result<T, Error>) {
    if let Err(error) = result {
        let message = error.to_string();
        assert!(!matches!(error, Error::Internal { .. }), "{message}");
        assert!(message.len() > 10 && !message.contains('\n'), "{message}");
    }
}

fn read(draw: &mut Draw, bytes: &[u8], kind: ContourKind) -> Outcome {
    draw.input = shown(bytes);
    let options = OutlineOptions::default();
    let result = outline_from_reader(bytes, kind, &options, "outline");
    is_said(&result);
    let all = outlines_from_reader(bytes, kind, &options, "outline");
    is_said(&all);
    let all: Vec<_> = all.into_iter().flatten().collect();
    all.iter().for_each(is_said);
    // It is the first of all, and it is found without its name, too, or is another form.
    let first = all.first().and_then(|found| found.as_ref().ok());
    let points = |found: &(stellate::shape::Contour, _)| found.0.points().to_vec();
    assert_eq!(result.as_ref().ok().map(points), first.map(points));
    let _ = Given::from_reader(bytes, "outline", Numbers::Exact);
    match result {
        Ok((outline, _)) => {
            assert!(outline.len() >= 3);
            Outcome::Checked
        }
        Err(_) => Outcome::Open,
    }
}

#[test]
fn the_seeds_are_outlines() {
    let read = |bytes: &[u8], kind| contour_from_reader(bytes, kind, "seed").unwrap().len();
    for (kind, seeds) in [
        (ContourKind::Rows, csv()[..2].to_vec()),
        (ContourKind::Polygons, geojson()),
        (ContourKind::Drawing, svg()),
        (ContourKind::Image, vec![disc().png()]),
        (ContourKind::Array, vec![npy(&mut Draw::new("npy", 1))]),
    ] {
        for seed in seeds {
            assert!(read(&seed, kind) >= 3);
        }
    }
}

/// A picture that ends in its first half is an error, not a picture that is completed.
#[test]
fn pictures_that_end_in_the_middle_are_errors() {
    #[cfg(feature = "more-images")]
    let more = MORE_PICTURES;
    #[cfg(not(feature = "more-images"))]
    let more: [Encode; 0] = [];
    for encode in PICTURES.into_iter().chain(more) {
        let whole = encode(&disc());
        assert!(contour_from_reader(&whole[..], ContourKind::Image, "whole").is_ok());
        for length in 0..=whole.len() / 2 {
            let cut = contour_from_reader(&whole[..length], ContourKind::Image, "cut");
            let start = &whole[..4];
            assert!(cut.is_err(), "{start:?}: {length} of {} bytes", whole.len());
        }
    }
}
