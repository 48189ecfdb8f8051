//! Silhouettes that are drawn by these tests are traced.

use super::*;
use crate::fit::reading::encoded::{Drawing, png};

/// The outline as it is traced without options.
fn traced(bytes: &[u8], place: &str) -> Result<Contour> {
    Ok(trace(bytes, &OutlineOptions::default(), place)?.0)
}

fn trace(bytes: &[u8], options: &OutlineOptions, place: &str) -> Result<(Contour, LeftOut)> {
    Silhouette::read(bytes, options, place)?.outline(options.blob, options, place)
}

/// A disc with smooth borders: the grey value of a pixel is roughly the part of it that is covered.
fn disc(size: u32, center: [f64; 2], radius: f64, inside: f64, outside: f64) -> Drawing {
    Drawing::grey([size; 2], |i, j| {
        let (x, y) = (f64::from(i) + 0.5, f64::from(size - j) - 0.5);
        let depth = radius - (x - center[0]).hypot(y - center[1]);
        let part = (depth + 0.5).clamp(0.0, 1.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a grey value"
        )]
        {
            (part * inside + (1.0 - part) * outside).round() as u8
        }
    })
}

#[test]
fn a_disc_is_traced_to_a_fraction_of_a_pixel() {
    for (inside, outside) in [(0.0, 255.0), (255.0, 0.0), (40.0, 200.0)] {
        let image = disc(100, [40.0, 60.25], 25.0, inside, outside);
        for file in [image.png(), image.bmp()] {
            let outline = traced(&file, "disc").unwrap();
            outline.check_invariants();
            let area = outline.area() / (std::f64::consts::PI * 625.0);
            assert!((area - 1.0).abs() < 0.005, "{area}");
            for p in outline.points() {
                let radius = (p[0] - 40.0).hypot(p[1] - 60.25);
                assert!((radius - 25.0).abs() < 0.15, "{p:?} at {radius}");
            }
        }
        let centroid = traced(&image.jpeg(75), "disc").unwrap().centroid();
        assert!((centroid[0] - 40.0).hypot(centroid[1] - 60.25) < 0.05);
    }
}

#[test]
fn black_and_white_pixels_give_half_way_borders() {
    // A 2 × 1 block of black pixels; the corners are cut by marching squares.
    let image = Drawing::grey([5, 4], |i, j| match (i, j) {
        (1 | 2, 1) => 0,
        _ => 255,
    });
    let outline = traced(&image.png(), "block").unwrap();
    assert_eq!(outline.bounding_box(), [[1.0, 2.0], [3.0, 3.0]]);
}

#[test]
fn a_silhouette_at_the_border_is_closed_there() {
    let image = Drawing::grey([8, 8], |i, j| if i < 2 && j < 3 { 0 } else { 255 });
    let outline = traced(&image.png(), "corner").unwrap();
    assert_eq!(outline.bounding_box(), [[0.0, 5.0], [2.0, 8.0]]);
}

#[test]
fn a_plain_picture_has_no_silhouette() {
    for image in [
        Drawing::grey([9, 9], |_, _| 7),
        // Nothing but transparent pixels.
        Drawing::rgba([9, 9], |_, _| [7, 8, 9, 0]),
    ] {
        let error = traced(&image.png(), "plain.png");
        let message = error.unwrap_err().to_string();
        assert!(
            message.starts_with("plain.png: no silhouette: every pixel is background"),
            "{message}"
        );
    }
}

#[test]
fn the_part_with_the_most_pixels_is_taken() {
    let image = Drawing::rgba([40, 40], |i, j| {
        let big = (5..20).contains(&i) && (5..30).contains(&j);
        let small = (30..35).contains(&i) && (30..35).contains(&j);
        [0, 0, 0, if big || small { 255 } else { 0 }]
    });
    let outline = traced(&image.png(), "two").unwrap();
    assert_eq!(outline.bounding_box(), [[5.0, 10.0], [20.0, 35.0]]);
}

#[test]
fn what_is_not_a_picture_is_refused() {
    assert!(traced(b"", "a.png").is_err());
    let error = traced(b"x,y\n1,2\n", "a.png").unwrap_err();
    assert!(error.to_string().starts_with("a.png: not a PNG, JPEG"));
    let mut cut = disc(50, [25.0, 25.0], 9.0, 0.0, 255.0).png();
    cut.truncate(cut.len() / 2);
    assert!(traced(&cut, "cut.png").is_err());
}

#[test]
fn pictures_beyond_the_limit_are_refused_before_they_are_decoded() {
    let wide = Drawing::grey([20_001, 1], |_, _| 0).png();
    let error = traced(&wide, "wide.png").unwrap_err();
    assert!(matches!(error, Error::Limit { .. }), "{error}");
}

/// A mask with the values 0 and 1, and a picture on black and on white.
#[test]
fn masks_of_labels_and_pictures_of_16_bits_are_read() {
    let disc = |i: u32, j: u32| (f64::from(i) - 30.0).hypot(f64::from(j) - 25.0) < 15.0;
    for (low, high) in [(0_u16, 1), (0, 65535), (65535, 0), (30000, 30001), (1, 0)] {
        let places = (0..64 * 64).map(|k| disc(k % 64, k / 64));
        let words = places.map(|inside| if inside { high } else { low });
        let samples: Vec<u8> = words.flat_map(u16::to_be_bytes).collect();
        let (grey, depth) = (png::ColorType::Grayscale, png::BitDepth::Sixteen);
        let mask = png([64, 64], grey, depth, &samples);
        let outline = traced(&mask, "mask.png").unwrap();
        let area = outline.area() / (std::f64::consts::PI * 225.0);
        assert!((area - 1.0).abs() < 0.02, "{low} {high}: {area}");
    }
    let mask = Drawing::grey([64, 64], |i, j| u8::from(disc(i, j)));
    let outline = traced(&mask.png(), "mask.png").unwrap();
    assert!((outline.centroid()[0] - 30.5).abs() < 0.01);
}

/// The opaque pixels are the silhouette, whatever their colour.
#[test]
fn an_alpha_channel_is_the_mask() {
    for colour in [[255, 255, 255], [0, 0, 0], [200, 30, 90]] {
        let image = Drawing::rgba([40, 40], |i, j| {
            let inside = (10..30).contains(&i) && (5..20).contains(&j);
            // A chequered pattern, of which the colours have no say.
            let [r, g, b] = if (i + j) % 2 == 0 {
                colour
            } else {
                [9, 200, 9]
            };
            [r, g, b, if inside { 255 } else { 0 }]
        });
        let outline = traced(&image.png(), "alpha.png").unwrap();
        assert_eq!(outline.bounding_box(), [[10.0, 20.0], [30.0, 35.0]]);
    }
}

/// A plate with a comb of slits, whose outline is much longer than that of the plate.
#[test]
fn a_hole_is_never_the_outline() {
    let plate = Drawing::grey([60, 60], |i, j| {
        let inside = (10..50).contains(&i) && (10..50).contains(&j);
        let slit = (13..47).contains(&i) && (13..47).contains(&j) && (i % 2 == 1 || j == 13);
        if inside && !slit { 0 } else { 255 }
    });
    let bytes = plate.png();
    let (outline, left_out) = trace(&bytes, &OutlineOptions::default(), "plate").unwrap();
    assert_eq!(outline.bounding_box(), [[10.0, 10.0], [50.0, 50.0]]);
    assert_eq!((left_out.parts, left_out.holes), (0, 1));
    assert!((outline.area() - 1600.0).abs() < 3.0, "{}", outline.area());
}

/// Three blobs, one of them with a hole, and a frame.
#[test]
fn other_parts_holes_and_a_frame_are_left_out_and_counted() {
    let picture = |frame: u32| {
        Drawing::grey([200, 150], |i, j| {
            let edge = i.min(199 - i).min(j).min(149 - j);
            let blob =
                |x: u32, y: u32, r: u32| (i.abs_diff(x)).pow(2) + (j.abs_diff(y)).pow(2) < r * r;
            let dark = edge < frame
                || blob(60, 60, 40) && !blob(60, 60, 10)
                || blob(150, 60, 20)
                || blob(150, 120, 5);
            if dark { 10 } else { 240 }
        })
    };
    for frame in [0, 1, 3] {
        let bytes = picture(frame).png();
        let trace = |options: &OutlineOptions| trace(&bytes, options, "blobs.png");
        let (outline, left_out) = trace(&OutlineOptions::default()).unwrap();
        assert!(
            (outline.centroid()[0] - 60.5).abs() < 0.01,
            "{:?}",
            outline.centroid()
        );
        assert_eq!((left_out.parts, left_out.holes), (2, 1));
        assert_eq!(left_out.frame, frame as usize);
        assert!(
            (left_out.largest - 400.0 / 1500.0).abs() < 0.01,
            "{left_out:?}"
        );
        let (second, _) = trace(&OutlineOptions::default().blob(2)).unwrap();
        assert!((second.centroid()[0] - 150.5).abs() < 0.01);
        assert!(
            (second.centroid()[1] - 89.5).abs() < 0.01,
            "{:?}",
            second.centroid()
        );
        let error = trace(&OutlineOptions::default().blob(4))
            .unwrap_err()
            .to_string();
        assert!(error.contains("the silhouette has 3 parts"), "{error}");
        assert!(trace(&OutlineOptions::default().blob(0)).is_err());
    }
}

#[test]
fn the_threshold_and_the_side_may_be_given() {
    // A bright core in a grey disc on black.
    let image = Drawing::grey([80, 80], |i, j| {
        let r = (f64::from(i) - 40.0).hypot(f64::from(j) - 40.0);
        if r < 10.0 {
            250
        } else if r < 30.0 {
            90
        } else {
            5
        }
    });
    let bytes = image.png();
    let trace = |options: OutlineOptions| trace(&bytes, &options, "core.png");
    let width = |options: OutlineOptions| {
        let [low, high] = trace(options).unwrap().0.bounding_box();
        high[0] - low[0]
    };
    assert!((width(OutlineOptions::default().threshold(Some(40))) - 59.0).abs() < 1.5);
    assert!((width(OutlineOptions::default().threshold(Some(150))) - 19.0).abs() < 1.5);
    // The background with a hole in it.
    let (_, left_out) = trace(OutlineOptions::default().threshold(Some(40)).invert(true)).unwrap();
    assert_eq!(left_out.holes, 1);
    let error = trace(OutlineOptions::default().threshold(Some(254)))
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("no colour is beyond --threshold 254"),
        "{error}"
    );
}

/// A JPEG file that ends anywhere before its end is refused, as is one whose data is damaged so that it ends early.
#[test]
fn a_cut_jpeg_is_refused() {
    let whole = disc(120, [60.0, 60.0], 40.0, 0.0, 255.0).jpeg(75);
    assert!(traced(&whole, "whole.jpg").is_ok());
    for cut in [2, 3, 10, 40, whole.len() / 4, whole.len() / 2] {
        let error = traced(&whole[..whole.len() - cut], "cut.jpg")
            .unwrap_err()
            .to_string();
        assert!(error.contains("cut.jpg"), "{cut}: {error}");
    }
}
