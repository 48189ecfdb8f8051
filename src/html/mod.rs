//! Pages of HTML, with texts and pictures in them. A page needs no network and no script, and can be read on a phone, on paper, on
//! light and on dark screens. It is also well-formed XML.

use std::fmt::Write as _;
use std::io::{self, Write};

const STYLE: &str = include_str!("page.css");

/// Begins a page, with a link past its head, which `skip` names.
pub(crate) fn begin_page(title: &str, skip: &str, out: &mut dyn Write) -> io::Result<()> {
    writeln!(
        out,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <meta name=\"color-scheme\" content=\"light dark\"/>\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <a class=\"skip\" href=\"#content\">{skip}</a>"
    )
}

/// Ends a page.
pub(crate) fn end_page(out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "</body>\n</html>")
}

/// Begins a figure. The page contains its picture, and `words` describe it for those who do not see it.
pub(crate) fn write_picture(words: &str, svg: &str, out: &mut dyn Write) -> io::Result<()> {
    writeln!(
        out,
        "<figure>\n<img alt=\"{}\" src=\"data:image/svg+xml,{}\"/>",
        escaped(words),
        in_an_address(svg)
    )
}

/// The text with entities for the characters that have a meaning in HTML.
pub(crate) fn escaped(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => result.push_str("&amp;"),
            '<' => result.push_str("&lt;"),
            '>' => result.push_str("&gt;"),
            '"' => result.push_str("&quot;"),
            c => result.push(c),
        }
    }
    result
}

/// An SVG text for a data address in double quotes. If it has no single quotes, its double quotes become single ones, which
/// need not be escaped.
fn in_an_address(svg: &str) -> String {
    let mut result = String::with_capacity(svg.len() * 5 / 4);
    let may_change = !svg.contains('\'');
    for byte in svg.bytes() {
        match byte {
            b'"' if may_change => result.push('\''),
            b'%' | b'#' | b'"' | b'<' | b'>' | b'&' | 0..b' ' | 0x7f.. => {
                // Writing to a string cannot fail.
                let _ = write!(result, "%{byte:02X}");
            }
            _ => result.push(char::from(byte)),
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_and_texts_are_escaped() {
        assert_eq!(in_an_address("<a b=\"#θ%\"/>"), "%3Ca b='%23%CE%B8%25'/%3E");
        assert_eq!(in_an_address("<a b=\"'\"/>"), "%3Ca b=%22'%22/%3E");
        assert_eq!(escaped("a < b & \"c\""), "a &lt; b &amp; &quot;c&quot;");
    }
}
