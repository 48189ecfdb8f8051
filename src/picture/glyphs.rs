//! The outlines of a text in the font by which pictures are laid out.

use ab_glyph::{Font, FontRef, GlyphId, OutlineCurve, Point};
use tiny_skia::{Path, PathBuilder};
use unicode_bidi::{BidiInfo, Level};

use super::text::font_file;
use crate::error::Invariant;

/// A text on one line, from the origin to the right; the baseline is y = 0, and y grows downward.
pub(super) struct Letters {
    /// The outlines of its letters; `None` if there is none, as in a blank.
    pub(super) outlines: Option<Path>,
    /// The sum of its letters' advances.
    pub(super) width: f32,
}

/// Sets a text in letters of `size` per em. A letter that the font does not have is drawn as a box. Words that are read from
/// the right, such as Hebrew ones, are set so; letters of scripts in which they join, such as Arabic ones, are not joined.
pub(super) fn letters(text: &str, size: f32) -> Letters {
    let font =
        FontRef::try_from_slice(font_file()).invariant("the font of the crate can be parsed");
    let em = font.units_per_em().invariant("the font has a unit");
    let mut set = Setting {
        scale: size / em,
        x: 0.0,
        end: None,
        outlines: PathBuilder::new(),
    };
    let mut before: Option<GlyphId> = None;
    let order = BidiInfo::new(text, Some(Level::ltr()));
    let lines = order.paragraphs.iter();
    let shown: String = lines
        .map(|line| order.reorder_line(line, line.range.clone()))
        .collect();
    for letter in shown.chars() {
        let glyph = font.glyph_id(letter);
        set.x += before.map_or(0.0, |before| font.kern_unscaled(before, glyph));
        set.end = None;
        if let Some(outline) = font.outline(glyph) {
            outline.curves.iter().for_each(|curve| set.curve(curve));
        }
        set.x += font.h_advance_unscaled(glyph);
        before = Some(glyph);
    }
    Letters {
        width: set.x * set.scale,
        outlines: set.outlines.finish(),
    }
}

/// The letters that have been set so far, in units of the font.
struct Setting {
    scale: f32,
    /// Where the next letter begins.
    x: f32,
    /// Where the last curve of this letter ends.
    end: Option<Point>,
    outlines: PathBuilder,
}

impl Setting {
    /// Appends a curve of the letter at x. A curve that does not begin where the last one ends begins another outline.
    fn curve(&mut self, curve: &OutlineCurve) {
        let (&from, &to) = match curve {
            OutlineCurve::Line(from, to)
            | OutlineCurve::Quad(from, _, to)
            | OutlineCurve::Cubic(from, _, _, to) => (from, to),
        };
        let (x, scale) = (self.x, self.scale);
        let at = |p: &Point| [(x + p.x) * scale, -p.y * scale];
        if self.end != Some(from) {
            let [x, y] = at(&from);
            self.outlines.move_to(x, y);
        }
        let [x, y] = at(&to);
        match curve {
            OutlineCurve::Line(..) => self.outlines.line_to(x, y),
            OutlineCurve::Quad(_, control, _) => {
                let [a, b] = at(control);
                self.outlines.quad_to(a, b, x, y);
            }
            OutlineCurve::Cubic(_, first, second, _) => {
                let ([a, b], [c, d]) = (at(first), at(second));
                self.outlines.cubic_to(a, b, c, d, x, y);
            }
        }
        self.end = Some(to);
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::text::{load_font, text_width};
    use super::*;

    /// The extent of the outlines of a text: left, top, right and bottom.
    fn extent(text: &str, size: f32) -> [f32; 4] {
        let bounds = letters(text, size).outlines.unwrap().bounds();
        [bounds.left(), bounds.top(), bounds.right(), bounds.bottom()]
    }

    #[test]
    fn letters_stand_on_the_baseline() {
        let [left, top, right, bottom] = extent("H", 1000.0);
        // DejaVu Sans: capitals are 1493 of 2048 units high, and H reaches from 201 to 1339.
        let units = [201.0, -1493.0, 1339.0, 0.0].map(|unit| unit * 1000.0 / 2048.0);
        for (got, expected) in [left, top, right, bottom].into_iter().zip(units) {
            assert!((got - expected).abs() < 0.01, "{got} for {expected}");
        }
        // The hole of an o, and the two parts of an i, are outlines of their own.
        let moves = |text: &str| {
            let outlines = letters(text, 9.0).outlines.unwrap();
            let moves = |s: &tiny_skia::PathSegment| matches!(s, tiny_skia::PathSegment::MoveTo(_));
            outlines.segments().filter(moves).count()
        };
        assert_eq!(["l", "o", "i", "=", "oil"].map(moves), [1, 2, 2, 2, 5]);
    }

    #[test]
    fn blanks_have_a_width_and_no_outlines() {
        let blank = letters(" ", 10.0);
        assert!(blank.outlines.is_none());
        assert!(blank.width > 3.0 && blank.width < 4.0, "{}", blank.width);
        assert!(letters("", 10.0).width.abs() < 1e-9);
    }

    #[test]
    fn letters_that_the_font_does_not_have_are_boxes() {
        let [unknown, other] = ["\u{e123}", "\u{10fffd}"].map(|text| letters(text, 100.0));
        assert_eq!(unknown.outlines, other.outlines);
        let [left, _, right, _] = extent("\u{e123}", 100.0);
        assert!(right - left > 30.0, "{left} to {right}");
    }

    #[test]
    fn words_that_are_read_from_the_right_are_set_so() {
        let outlines = |text: &str| letters(text, 10.0).outlines.unwrap();
        assert_eq!(outlines("אבג b"), outlines("\u{202d}גבא b"));
        assert_ne!(outlines("אבג"), outlines("גבא"));
    }

    #[test]
    fn the_signs_of_mathematics_are_in_the_font() {
        let missing = letters("\u{e123}", 100.0).outlines;
        for sign in "θφρλκ²³⁰−·×→≤≥≈°√∞…äΩ".chars() {
            assert_ne!(
                letters(&sign.to_string(), 100.0).outlines,
                missing,
                "{sign}"
            );
        }
    }

    proptest! {
        /// A text is as wide as the picture was laid out for, and its outlines reach from end to end.
        #[test]
        fn a_text_is_as_wide_as_it_was_measured(text in "[a-zA-Z0-9_+*äΩθ²−AVWTy.,-]{1,60}", size in 5.0f32..200.0) {
            load_font();
            // The measure is of letters whose height, not whose em, is the size: 2384 units of 2048.
            let measured = text_width(&text, 1000) * f64::from(size) / 1000.0 * 2384.0 / 2048.0;
            let set = letters(&text, size);
            let width = f64::from(set.width);
            prop_assert!((width - measured).abs() < 1e-3 * measured, "{} for {}", width, measured);
            let bounds = set.outlines.unwrap().bounds();
            prop_assert!(bounds.left() > -0.3 * size && bounds.left() < 0.3 * size, "{:?}", bounds);
            prop_assert!((bounds.right() - set.width).abs() < 0.3 * size, "{:?}", bounds);
        }
    }
}
