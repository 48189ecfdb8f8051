//! Sentences that contain formulas and code. They are written plainly for the terminal and for documents, and marked up for the
//! page.

use std::fmt;

use super::typeset;
use crate::html::escaped;

/// A text that may contain formulas and code. `Display` writes it plainly.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text(Vec<Part>);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Part {
    Words(String),
    /// Text that can be typed as it stands.
    Code(String),
    /// A formula in plain text, and as `<math>` elements between which a line may break.
    Formula(String, Vec<String>),
}

/// Characters that must not begin a line.
const CLOSING: [char; 5] = ['.', ',', ';', ':', ')'];

impl Text {
    /// Reads a text of the statements. Formulas stand between dollars, as in `the circle $x² + y² = 1$`, and code between
    /// backquotes.
    pub(super) fn marked(source: &str) -> Self {
        let mut text = Self::default();
        for (index, part) in source.split('$').enumerate() {
            if index % 2 == 1 {
                text = text.formula(part.into(), typeset::pieces(part));
                continue;
            }
            for (index, part) in part.split('`').enumerate() {
                text = if index % 2 == 1 {
                    text.code(part)
                } else {
                    text.words(part)
                };
            }
        }
        text
    }

    pub(super) fn words(mut self, words: &str) -> Self {
        if !words.is_empty() {
            self.0.push(Part::Words(words.into()));
        }
        self
    }

    pub(super) fn code(mut self, code: &str) -> Self {
        self.0.push(Part::Code(code.into()));
        self
    }

    pub(super) fn formula(mut self, plain: String, pieces: Vec<String>) -> Self {
        self.0.push(Part::Formula(plain, pieces));
        self
    }

    pub(super) fn followed_by(mut self, other: Self) -> Self {
        self.0.extend(other.0);
        self
    }

    /// The text with a capital letter at its beginning, if it begins with words.
    pub(super) fn capitalized(mut self) -> Self {
        if let Some(Part::Words(words)) = self.0.first_mut() {
            let mut rest = words.chars();
            if let Some(first) = rest.next() {
                *words = first.to_uppercase().chain(rest).collect();
            }
        }
        self
    }

    /// Whether the text is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The markup of the text for a page.
    pub(super) fn markup(&self) -> String {
        let mut markup = String::new();
        let mut rest = self.0.iter().peekable();
        // The number of bytes at the start of the next words that were already written behind a formula or code.
        let mut written = 0;
        while let Some(part) = rest.next() {
            let closing = match rest.peek() {
                Some(Part::Words(words)) => {
                    let end = words.find(|c| !CLOSING.contains(&c));
                    &words[..end.unwrap_or(words.len())]
                }
                _ => "",
            };
            match part {
                Part::Words(words) => {
                    markup.push_str(&escaped(&words[written..]));
                    written = 0;
                    continue;
                }
                Part::Code(code) => {
                    markup.push_str(&format!("<code>{}</code>{closing}", unbroken(code)));
                }
                Part::Formula(_, pieces) => {
                    if let Some((last, before)) = pieces.split_last() {
                        for piece in before {
                            markup.push_str(&format!("{piece}<wbr/>"));
                        }
                        markup.push_str(&format!("<span class=\"whole\">{last}{closing}</span>"));
                    }
                }
            }
            written = closing.len();
        }
        markup
    }
}

/// The markup of code in which a line breaks only at blanks.
pub(super) fn unbroken(code: &str) -> String {
    let words = code.split(' ');
    let words = words.map(|word| format!("<span>{}</span>", escaped(word)));
    words.collect::<Vec<_>>().join(" ")
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for part in &self.0 {
            match part {
                Part::Words(plain) | Part::Formula(plain, _) => f.write_str(plain)?,
                Part::Code(code) => write!(f, "`{code}`")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_plain_or_marked_up() {
        let text = Text::marked("the circle $x² = 1$, `a <b`");
        assert_eq!(text.to_string(), "the circle x² = 1, `a <b`");
        let markup = text.capitalized().markup();
        assert!(
            markup.starts_with("The circle <span class=\"whole\"><math"),
            "{markup}"
        );
        // The comma stays with the formula.
        assert!(markup.contains("</math>,</span> <code>"), "{markup}");
        assert!(markup.ends_with("<code><span>a</span> <span>&lt;b</span></code>"));
    }
}
