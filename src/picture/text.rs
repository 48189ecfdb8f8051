//! Text on a picture: the font, the width of a text, and a text in lines.

use std::sync::Once;

use plotters::style::{FontStyle, IntoFont, TextStyle, register_font};

use super::units::FINER;

/// The sign for what is left out of a text.
const LEFT_OUT: char = '…';

/// The file of the font by which pictures are laid out. It is called, not inlined: otherwise it would be in the program more
/// than once.
#[inline(never)]
pub(super) fn font_file() -> &'static [u8] {
    dejavu::sans::regular()
}

/// Registers the font by which pictures are laid out.
pub(super) fn load_font() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // The font of the crate can be parsed; if it could not, labels would be missing.
        let _ = register_font("sans-serif", FontStyle::Normal, font_file());
    });
}

/// The font in a size in units.
pub(super) fn font(size: u32) -> TextStyle<'static> {
    ("sans-serif", size * FINER).into_font().into()
}

/// The width of a text on one line, in units. The drawing library draws letters about 6 % smaller than it measures them.
pub(super) fn text_width(text: &str, size: u32) -> f64 {
    let measured = ("sans-serif", size * FINER).into_font().box_size(text);
    measured.map_or(0.0, |(width, _)| f64::from(width) / f64::from(FINER))
}

/// The text in lines of at most this width, broken at blanks. A word that is longer than a line is broken between letters. An
/// empty text has no line.
pub(super) fn lines(text: &str, size: u32, room: f64) -> Vec<String> {
    let fits = |line: &str| text_width(line, size) <= room;
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let longer = lines.last().map(|line| format!("{line} {word}"));
        match (longer.filter(|line| fits(line)), lines.last_mut()) {
            (Some(longer), Some(line)) => *line = longer,
            _ if fits(word) => lines.push(word.to_owned()),
            _ => push_letters(&mut lines, word, &fits),
        }
    }
    lines
}

/// Writes a word from the end of the last line on, letter by letter.
fn push_letters(lines: &mut Vec<String>, word: &str, fits: &impl Fn(&str) -> bool) {
    let mut line = match lines.pop() {
        Some(last) => format!("{last} "),
        None => String::new(),
    };
    for letter in word.chars() {
        line.push(letter);
        if !fits(&line) {
            line.pop();
            if !line.trim().is_empty() {
                lines.push(line.trim_end().to_owned());
            }
            line = letter.into();
        }
    }
    lines.push(line);
}

/// The text in at most `most` lines. If it is longer, its middle is left out.
pub(super) fn few_lines(text: &str, size: u32, room: f64, most: usize) -> Vec<String> {
    let letters: Vec<char> = text.chars().collect();
    let shortened = |kept: usize| -> Vec<String> {
        let (head, tail) = (
            &letters[..kept.div_ceil(2)],
            &letters[letters.len() - kept / 2..],
        );
        let text: String = head.iter().chain(&[LEFT_OUT]).chain(tail).collect();
        lines(&text, size, room)
    };
    let limit = most.saturating_mul(letters_per_line(room, size));
    if letters.len() <= limit {
        let whole = lines(text, size, room);
        if whole.len() <= most {
            return whole;
        }
    }
    // Between these two is the largest number of letters that can be kept.
    let (mut fitting, mut too_many) = (0, letters.len().min(limit));
    while too_many - fitting > 1 {
        let middle = usize::midpoint(fitting, too_many);
        if shortened(middle).len() <= most {
            fitting = middle;
        } else {
            too_many = middle;
        }
    }
    shortened(fitting)
}

/// More letters than fit into a line.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number of letters, rounded up"
)]
fn letters_per_line(room: f64, size: u32) -> usize {
    /// No letter is narrower than this part of the size of the font.
    const NARROWEST: f64 = 0.2;
    (room / (NARROWEST * f64::from(size))).max(1.0).ceil() as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const LABEL: &str = "parametric curve, x = 1 + cos(t); y = 1 + sin(t), t from 0 to 1";

    #[test]
    fn a_long_label_has_several_lines() {
        load_font();
        let broken = lines(LABEL, 14, 348.0);
        assert!(broken.len() > 1, "{broken:?}");
        assert_eq!(broken.join(" "), LABEL);
        assert_eq!(lines(LABEL, 14, 768.0), [LABEL]);
        assert!(lines("", 20, 768.0).is_empty());
    }

    #[test]
    fn a_label_that_is_too_long_loses_its_middle() {
        load_font();
        let long = format!(
            "zero set, {}, the end",
            "x^2 + 3xy - 1/7*y^2 + ".repeat(5000)
        );
        let kept = few_lines(&long, 14, 300.0, 3);
        assert_eq!(kept.len(), 3, "{kept:?}");
        assert!(kept[0].starts_with("zero set, x^2 + 3xy"), "{kept:?}");
        assert!(kept[2].ends_with(", the end"), "{kept:?}");
        assert_eq!(kept.concat().matches('…').count(), 1);
        assert_eq!(few_lines(LABEL, 14, 348.0, 3), lines(LABEL, 14, 348.0));
    }

    proptest! {
        #[test]
        fn every_line_fits(text in "[ a-zA-Z0-9_+*äΩ-]{0,160}", room in 40.0f64..800.0) {
            load_font();
            let all = lines(&text, 14, room);
            prop_assert!(all.iter().all(|line| text_width(line, 14) <= room), "{:?}", all);
            let letters = |text: &str| text.split_whitespace().collect::<String>();
            prop_assert_eq!(letters(&all.concat()), letters(&text));
            let few = few_lines(&text, 14, room, 3);
            prop_assert!(few.len() <= 3);
            if all.len() <= 3 {
                prop_assert_eq!(few, all);
            }
        }
    }
}
