//! Replaces characters that documents contain by the plain characters that they look like.

use std::borrow::Cow;

use super::token::SUPERSCRIPTS;

/// The text with plain characters: fullwidth and mathematical letters, typographic operators, fractions such as ½ and special
/// blanks are replaced by what they look like, characters without width are removed, and a pair of quotes around the whole text
/// is replaced by blanks. Line breaks are kept, so that messages can show a line.
///
/// The replacements are those of Unicode (NFKC; only with the feature `unicode`) and some more. Superscripts are kept, because x² is not x2.
pub(super) fn plain(text: &str) -> Cow<'_, str> {
    let text = match with_newlines(text) {
        Cow::Borrowed(text) => unquoted(text),
        Cow::Owned(text) => Cow::Owned(unquoted(&text).into_owned()),
    };
    if text.is_ascii() {
        return text;
    }
    let mut result = String::with_capacity(text.len());
    for c in text.chars() {
        let after_digit = result.ends_with(|c: char| c.is_ascii_digit());
        match c {
            _ if c.is_ascii() || SUPERSCRIPTS.contains(&c) || "⁺⁻".contains(c) => {
                result.push(c)
            }
            // Characters without width: joiners, soft hyphens, marks of direction and of byte order.
            '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{feff}' | '\u{ad}' => {}
            '\u{2044}' | '\u{2215}' | '\u{29f8}' => result.push('/'),
            '\u{2217}' | '\u{2062}' | '\u{2022}' => result.push('*'),
            '\u{2c6}' | '\u{2303}' | '\u{2038}' => result.push('^'),
            '\u{2010}'..='\u{2015}' | '\u{2212}' => result.push('-'),
            // A fraction after a digit is kept, and refused later, because 2½ could be a sum or a product.
            '½' | '⅓' | '⅔' | '¼' | '¾' | '⅕'..='⅞' if !after_digit => {
                result.push('(');
                result.extend(compatible(c).map(|c| if c == '\u{2044}' { '/' } else { c }));
                result.push(')');
            }
            '½' | '⅓' | '⅔' | '¼' | '¾' | '⅕'..='⅞' => result.push(c),
            _ => result.extend(compatible(c)),
        }
    }
    Cow::Owned(result)
}

/// The text in which every character that ends a line, as Unicode has them, is a newline. Two of these end a line together, the
/// carriage return and the line feed; there only the second one does.
pub(crate) fn with_newlines(text: &str) -> Cow<'_, str> {
    const ENDS: [char; 6] = ['\r', '\u{b}', '\u{c}', '\u{85}', '\u{2028}', '\u{2029}'];
    if !text.contains(ENDS) {
        return Cow::Borrowed(text);
    }
    let mut rest = text.chars().peekable();
    let mut result = String::with_capacity(text.len());
    while let Some(c) = rest.next() {
        let is_first_of_two = c == '\r' && rest.peek() == Some(&'\n');
        result.push(match c {
            _ if is_first_of_two => ' ',
            _ if ENDS.contains(&c) => '\n',
            _ => c,
        });
    }
    Cow::Owned(result)
}

/// The characters that stand for a character in Unicode's compatible form.
fn compatible(c: char) -> impl Iterator<Item = char> {
    #[cfg(feature = "unicode")]
    return unicode_normalization::UnicodeNormalization::nfkc(std::iter::once(c));
    #[cfg(not(feature = "unicode"))]
    std::iter::once(c)
}

/// The text in which a pair of quotes around all of it is replaced by blanks.
fn unquoted(text: &str) -> Cow<'_, str> {
    let trimmed = text.trim();
    let pairs = [
        ('"', '"'),
        ('\'', '\''),
        ('`', '`'),
        ('“', '”'),
        ('„', '“'),
        ('‘', '’'),
        ('«', '»'),
    ];
    let inner = pairs.iter().find_map(|&(open, close)| {
        let inner = trimmed.strip_prefix(open)?.strip_suffix(close)?;
        (!inner.contains([open, close])).then_some(inner)
    });
    match inner {
        None => Cow::Borrowed(text),
        Some(inner) => {
            let start = text.len() - text.trim_start().len();
            Cow::Owned(format!("{} {inner} ", &text[..start]))
        }
    }
}

#[cfg(all(test, feature = "unicode"))]
mod tests {
    use super::*;

    #[test]
    fn characters_of_documents_become_plain() {
        let cases = [
            ("x^2 + y^2", "x^2 + y^2"),
            ("x² + y³", "x² + y³"),
            ("ｘ＾２＋ｙ＝（１）", "x^2+y=(1)"),
            ("𝑥² + 𝜃", "x² + θ"),
            ("½x + ⅓", "(1/2)x + (1/3)"),
            ("2½", "2½"),
            ("1⁄2∗x\u{200b}", "1/2*x"),
            ("“x = y”", " x = y "),
            ("\"x\" = \"y\"", "\"x\" = \"y\""),
            ("x\u{a0}− 1", "x - 1"),
            ("ϑ + ϕ", "θ + φ"),
            ("x\r\ny\rz\u{2028}1\u{85}2\u{c}3", "x \ny\nz\n1\n2\n3"),
        ];
        for (text, expected) in cases {
            assert_eq!(plain(text), expected, "{text}");
        }
    }
}
