//! Translates formulas from the notation of the statements into MathML.
//!
//! Every letter is a symbol, digits after it are its index, and names such as cos are functions. `_` lowers and `^` raises the
//! symbol or the parenthesis that follows; characters such as ² are raised, too. `/` makes a fraction of what touches it on
//! either side: `2 pq/(3s)` is 2 times pq over 3s.

use crate::error::Invariant;
use crate::html::escaped;

/// Names of functions; all other runs of letters are products of symbols.
const FUNCTIONS: [&str; 5] = ["sin", "cos", "tan", "cot", "arccos"];

/// Superscripts, and the character that each of them raises.
const RAISED: [(char, &str); 13] = [
    ('⁰', "0"),
    ('¹', "1"),
    ('²', "2"),
    ('³', "3"),
    ('⁴', "4"),
    ('⁵', "5"),
    ('⁶', "6"),
    ('⁷', "7"),
    ('⁸', "8"),
    ('⁹', "9"),
    ('⁻', "−"),
    ('⁺', "+"),
    ('ⁿ', "n"),
];

/// The space between factors that do not touch.
const THIN: &str = "<mspace width=\"0.17em\"/>";

/// A row of at most this many characters fits on one line of a phone.
const WHOLE: usize = 22;

/// The formula as `<math>` elements, between which a line may break: before a relation, before an operator except `·`, and
/// after a separator.
pub(super) fn pieces(text: &str) -> Vec<String> {
    let mut pieces = vec![String::new()];
    let items = Reader::new(text).items();
    for item in items {
        let begins = matches!(item, Item::Infix(c) if c != '·');
        if begins || pieces.is_empty() {
            pieces.push(String::new());
        }
        let ends = matches!(item, Item::Separator(_));
        if let Some(piece) = pieces.last_mut() {
            item.append_to(piece);
        }
        if ends {
            pieces.push(String::new());
        }
    }
    wrapped(pieces)
}

/// Turns consecutive rows into `<math>` elements; short rows are joined.
pub(super) fn wrapped(rows: Vec<String>) -> Vec<String> {
    // Only the text between the tags counts. Entities do not: most of them are invisible operators.
    let size = |row: &str| {
        let texts = row.split('<').filter_map(|part| part.split_once('>'));
        let texts = texts.filter(|(_, text)| !text.starts_with('&'));
        texts.map(|(_, text)| text.chars().count()).sum::<usize>()
    };
    let mut pieces: Vec<String> = Vec::new();
    for row in rows.into_iter().filter(|row| !row.is_empty()) {
        match pieces.last_mut() {
            Some(piece) if size(piece) + size(&row) <= WHOLE => piece.push_str(&row),
            _ => pieces.push(row),
        }
    }
    pieces.iter().map(|piece| math(piece)).collect()
}

/// Puts a row into a `<math>` element whose fractions have the size of the text.
fn math(row: &str) -> String {
    format!("<math displaystyle=\"true\"><mrow>{row}</mrow></math>")
}

/// An operator between two terms. Its form is stated, because at the beginning of a `<math>` element it would be taken for a
/// prefix.
pub(super) fn infix(sign: char) -> String {
    format!("<mo form=\"infix\">{}</mo>", escaped(&sign.to_string()))
}

/// A part of a row.
enum Item {
    /// A product of factors without blanks between them, or a fraction of such products.
    Term(String),
    /// An operator after a term.
    Infix(char),
    /// A sign before the first term.
    Prefix(char),
    /// A comma, a semicolon or a colon.
    Separator(char),
}

impl Item {
    fn append_to(&self, row: &mut String) {
        match self {
            Self::Term(markup) => {
                if !row.is_empty() && !row.ends_with("</mo>") {
                    row.push_str(THIN);
                }
                row.push_str(markup);
            }
            Self::Infix(sign) => row.push_str(&infix(*sign)),
            Self::Prefix(sign) => row.push_str(&format!("<mo form=\"prefix\">{sign}</mo>")),
            Self::Separator(sign) => row.push_str(&format!("<mo separator=\"true\">{sign}</mo>")),
        }
    }
}

/// A factor, and its content if it is a parenthesis.
struct Factor {
    markup: String,
    inner: Option<String>,
}

impl Factor {
    fn new(markup: String) -> Self {
        Self {
            markup,
            inner: None,
        }
    }

    /// The factor without its parentheses, for places that make them superfluous.
    fn bare(self) -> String {
        format!("<mrow>{}</mrow>", self.inner.unwrap_or(self.markup))
    }
}

struct Reader<'t> {
    rest: &'t str,
    /// Whether an exponent is being read. Fractions in exponents are written with a slash, because they would be too small
    /// otherwise.
    in_exponent: bool,
}

impl<'t> Reader<'t> {
    fn new(text: &'t str) -> Self {
        Self {
            rest: text,
            in_exponent: false,
        }
    }

    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn next(&mut self) -> Option<char> {
        let next = self.peek()?;
        self.rest = &self.rest[next.len_utf8()..];
        Some(next)
    }

    fn take(&mut self, wanted: char) -> bool {
        let is_there = self.peek() == Some(wanted);
        if is_there {
            self.next();
        }
        is_there
    }

    /// Reads the longest run of characters that `belongs` accepts.
    fn run(&mut self, belongs: impl Fn(char) -> bool) -> &'t str {
        let (run, rest) = match self.rest.find(|c| !belongs(c)) {
            Some(end) => self.rest.split_at(end),
            None => (self.rest, ""),
        };
        self.rest = rest;
        run
    }

    /// Whether the parenthesis that comes next is closed.
    fn closes(&self) -> bool {
        let mut depth = 0_usize;
        for c in self.rest.chars() {
            match c {
                '(' => depth += 1,
                ')' => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth == 0 {
                return true;
            }
        }
        false
    }

    /// Reads the items up to the end or a closing parenthesis.
    fn items(&mut self) -> Vec<Item> {
        let mut items = Vec::new();
        loop {
            self.run(char::is_whitespace);
            let Some(next) = self.peek().filter(|c| !")]".contains(*c)) else {
                return items;
            };
            let after_term = matches!(items.last(), Some(Item::Term(_)));
            items.push(match next {
                '+' | '−' | '±' | '∓' if !after_term => Item::Prefix(next),
                '(' if !self.closes() => Item::Prefix(next),
                '+' | '−' | '±' | '∓' | '=' | '≤' | '≥' | '<' | '>' | '·' | '⊗' => {
                    Item::Infix(next)
                }
                ',' | ';' | ':' => Item::Separator(next),
                _ => {
                    items.push(Item::Term(self.term()));
                    continue;
                }
            });
            self.next();
        }
    }

    fn row(&mut self) -> String {
        let mut row = String::new();
        for item in self.items() {
            item.append_to(&mut row);
        }
        row
    }

    /// Reads a product of factors without blanks between them, or a fraction of such products.
    fn term(&mut self) -> String {
        let mut above = self.factors();
        while self.take('/') {
            if self.in_exponent {
                above = Factor::new(above.markup + "<mo>/</mo>" + &self.factors().markup);
                continue;
            }
            let below = self.factors().bare();
            above = Factor::new(format!("<mfrac>{}{below}</mfrac>", above.bare()));
        }
        above.markup
    }

    fn factors(&mut self) -> Factor {
        let mut product = self.factor();
        let ends = |c: char| c.is_whitespace() || "/)],;:+−±∓=≤≥<>·⊗".contains(c);
        while self.peek().is_some_and(|c| !ends(c)) {
            let markup = product.markup + &self.factor().markup;
            product = Factor::new(markup);
        }
        product
    }

    /// Reads a symbol, a number, a parenthesis or a root, with its index and its exponent.
    fn factor(&mut self) -> Factor {
        let Factor { markup, inner } = self.base();
        let is_letter = markup.starts_with("<mi>");
        let index = match self.peek() {
            Some(c) if is_letter && c.is_ascii_digit() => Some(self.number()),
            Some('_') => {
                self.next();
                Some(self.base().bare())
            }
            _ => None,
        };
        let exponent = match self.peek() {
            Some('^') => {
                self.next();
                let outer = std::mem::replace(&mut self.in_exponent, true);
                let exponent = self.factor().bare();
                self.in_exponent = outer;
                Some(exponent)
            }
            Some(c) if raised(c).is_some() => Some(self.raised_row()),
            _ => None,
        };
        match (index, exponent) {
            (None, None) => Factor { markup, inner },
            (Some(index), None) => Factor::new(format!("<msub>{markup}{index}</msub>")),
            (None, Some(exponent)) => Factor::new(format!("<msup>{markup}{exponent}</msup>")),
            (Some(index), Some(exponent)) => {
                Factor::new(format!("<msubsup>{markup}{index}{exponent}</msubsup>"))
            }
        }
    }

    fn base(&mut self) -> Factor {
        match self.peek() {
            Some(open @ ('(' | '[')) => {
                self.next();
                let inner = self.row();
                let close = self.next().invariant("parentheses are closed");
                Factor {
                    markup: format!("<mrow><mo>{open}</mo>{inner}<mo>{close}</mo></mrow>"),
                    inner: (open == '(').then_some(inner),
                }
            }
            Some('√') => Factor::new(format!("<msqrt>{}</msqrt>", self.radicand())),
            Some('∛') => Factor::new(format!("<mroot>{}<mn>3</mn></mroot>", self.radicand())),
            Some(c) if c.is_ascii_digit() => Factor::new(self.number()),
            Some('Σ') => {
                self.next();
                Factor::new("<mo>∑</mo>".into())
            }
            _ => Factor::new(format!("<mi>{}</mi>", self.symbol())),
        }
    }

    /// Reads the factor under a root, possibly with a sign.
    fn radicand(&mut self) -> String {
        self.next();
        let sign = if self.take('−') {
            "<mo form=\"prefix\">−</mo>"
        } else {
            ""
        };
        format!("<mrow>{sign}{}</mrow>", self.factor().bare())
    }

    fn number(&mut self) -> String {
        format!("<mn>{}</mn>", self.run(|c| c.is_ascii_digit() || c == '.'))
    }

    /// Reads the name of a function, or one character.
    fn symbol(&mut self) -> String {
        for name in FUNCTIONS {
            if let Some(rest) = self.rest.strip_prefix(name) {
                self.rest = rest;
                return name.into();
            }
        }
        let next = self.next().invariant("an operator has something behind it");
        escaped(&next.to_string())
    }

    fn raised_row(&mut self) -> String {
        let run = self.run(|c| raised(c).is_some());
        let text: String = run.chars().filter_map(raised).collect();
        let mut row = String::new();
        let digits = text.trim_start_matches(|c: char| !c.is_ascii_digit());
        for c in text[..text.len() - digits.len()].chars() {
            row.push_str(&match c {
                'n' => "<mi>n</mi>".to_owned(),
                sign => format!("<mo form=\"prefix\">{sign}</mo>"),
            });
        }
        if !digits.is_empty() {
            row.push_str(&format!("<mn>{digits}</mn>"));
        }
        format!("<mrow>{row}</mrow>")
    }
}

fn raised(c: char) -> Option<&'static str> {
    let found = RAISED.iter().find(|(shown, _)| *shown == c);
    found.map(|(_, meant)| *meant)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(text: &str) -> String {
        Reader::new(text).row()
    }

    #[test]
    fn a_fraction_is_made_of_what_touches() {
        assert_eq!(
            row("2 pq/(3s)"),
            "<mn>2</mn><mspace width=\"0.17em\"/><mfrac><mrow><mi>p</mi><mi>q</mi></mrow>\
             <mrow><mn>3</mn><mi>s</mi></mrow></mfrac>"
        );
        assert_eq!(
            row("(A − B)√−3/2").matches("<mfrac>").count(),
            1,
            "the root belongs to what is divided"
        );
    }

    #[test]
    fn indices_and_exponents() {
        assert_eq!(row("r1"), "<msub><mi>r</mi><mn>1</mn></msub>");
        assert_eq!(
            row("f_d⁻¹"),
            "<msubsup><mi>f</mi><mrow><mi>d</mi></mrow>\
             <mrow><mo form=\"prefix\">−</mo><mn>1</mn></mrow></msubsup>"
        );
        assert_eq!(
            row("r^(n−k)"),
            "<msup><mi>r</mi><mrow><mi>n</mi><mo form=\"infix\">−</mo><mi>k</mi></mrow></msup>"
        );
        assert_eq!(
            row("x¹⁰"),
            "<msup><mi>x</mi><mrow><mn>10</mn></mrow></msup>"
        );
        assert!(row("x^(1/n)").ends_with("<mn>1</mn><mo>/</mo><mi>n</mi></mrow></msup>"));
        assert!(row("cos² 2θ").starts_with("<msup><mi>cos</mi>"));
    }

    #[test]
    fn a_line_may_break_before_a_sum_goes_on_and_after_a_comma() {
        let found = pieces("abcdefghijkl + mnopqrstuvwx = −y, abcdefghijklmnopqrst");
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(found[1].contains("<mrow><mo form=\"infix\">+</mo><mi>m</mi>"));
        assert!(found[1].contains("<mo form=\"prefix\">−</mo><mi>y</mi><mo separator"));
        // A line does not break within parentheses, and not in a short formula.
        assert_eq!(pieces("(abcdefghijkl + mnopqrstuvwx)").len(), 1);
        assert_eq!(pieces("a + b = −c, d").len(), 1);
    }

    #[test]
    fn a_parenthesis_that_is_printed_open_stays_open() {
        assert_eq!(
            row("(a + b"),
            "<mo form=\"prefix\">(</mo><mi>a</mi><mo form=\"infix\">+</mo><mi>b</mi>"
        );
    }
}
