//! Splits a text into tokens.

use winnow::ascii::{digit0, digit1, hex_digit0, hex_digit1};
use winnow::combinator::{alt, not, opt, preceded};
use winnow::prelude::*;
use winnow::stream::{LocatingSlice, Location};
use winnow::token::{any, literal, one_of, take_till, take_while};

use super::name::{Name, split_word};
use super::source::{Source, Span};
use crate::error::{Invariant, Result};

/// The kind of a token; its text is that of its span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Number,
    /// A run of superscript digits.
    Superscript,
    Name(Name),
    /// A word that does not consist of names.
    Unknown,
    Plus,
    Minus,
    Star,
    Slash,
    Caret,
    Open,
    Close,
    Comma,
    Equals,
    Semicolon,
    Newline,
    /// Any other character, or `..`. It has no meaning, and a message says what to write instead.
    Other,
    End,
}

/// A token, and its place in the text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) span: Span,
}

/// The tokens of a text, of which the last one is [`Kind::End`], and the center that a comment gives.
#[derive(Debug)]
pub(super) struct Tokens {
    pub(super) tokens: Vec<Token>,
    /// The place of the text after `# center:`, if there is such a comment.
    pub(super) center: Option<Span>,
}

type Input<'a> = LocatingSlice<&'a str>;

/// The superscript digits from 0 to 9.
pub(super) const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Splits the text into tokens. Newlines are kept only if they end an equation (see [`join_lines`]).
pub(super) fn tokenize(source: Source<'_>) -> Result<Tokens> {
    let mut input = LocatingSlice::new(source.text);
    let mut tokens: Vec<Token> = Vec::new();
    let mut center = None;
    let mut line_start = true;
    loop {
        let blank = |c: char| c != '\n' && (c.is_whitespace() || c == '\u{feff}');
        let _: winnow::Result<&str> = take_while(0.., blank).parse_next(&mut input);
        let start = position(&input);
        let comment = is_comment(source.text, start, line_start);
        if comment {
            let mut line = take_till(0.., '\n');
            let text: winnow::Result<&str> = line.parse_next(&mut input);
            read_comment(
                source,
                start,
                text.invariant("a comment may be empty"),
                &mut center,
            )?;
            continue;
        }
        line_start = input.starts_with('\n');
        let Some(first) = input.chars().next() else {
            let span = Span { start, end: start };
            let kind = Kind::End;
            tokens.push(Token { kind, span });
            break;
        };
        if first.is_alphabetic() || first == '√' {
            word(&mut input, &mut tokens);
            continue;
        }
        let is_of_arrays = [".^", ".*", "./"].iter().any(|op| input.starts_with(*op));
        let kind = if input.starts_with("..") {
            let _: winnow::Result<&str> = take_while(2.., '.').parse_next(&mut input);
            Ok(Kind::Other)
        } else if first.is_ascii_digit() || first == '.' && !is_of_arrays {
            number(&mut input)
        } else {
            Ok(symbol(&mut input))
        };
        let span = Span {
            start,
            end: position(&input),
        };
        match kind {
            Ok(kind) => tokens.push(Token { kind, span }),
            Err(message) => {
                let shown = format!("{message}: {}", source.quoted(span));
                return Err(source.error(span, shown));
            }
        }
    }
    Ok(Tokens {
        tokens: join_lines(&tokens),
        center,
    })
}

/// Whether a comment starts here: with `#`; with `//` or `%` at the start of a line; or with `//` or `%` between two blanks, unless an
/// operand follows, as in `1 // 2`.
fn is_comment(text: &str, start: u32, line_start: bool) -> bool {
    let (before, rest) = text.split_at(start as usize);
    if rest.starts_with('#') {
        return true;
    }
    let after = rest.strip_prefix("//").or_else(|| rest.strip_prefix('%'));
    let stands_apart = |after: &str| {
        before.ends_with(' ') && after.starts_with(' ') && !begins_with_operand(after)
    };
    after.is_some_and(|after| line_start || stands_apart(after))
}

/// Whether a text begins with a number, an opening parenthesis, or a coordinate or parameter of one letter.
fn begins_with_operand(text: &str) -> bool {
    let mut rest = text.trim_start().chars();
    match (rest.next(), rest.next()) {
        (Some('(' | '.' | '0'..='9'), _) => true,
        (Some(name), after) => {
            "xyzrtuv".contains(name.to_ascii_lowercase())
                && !after.is_some_and(char::is_alphanumeric)
        }
        (None, _) => false,
    }
}

/// The position of the next character. Texts are shorter than 4 GiB: see [`super::budget::MAX_TEXT_BYTES`].
fn position(input: &Input<'_>) -> u32 {
    u32::try_from(input.current_token_start()).invariant("a text is shorter than 4 GiB")
}

/// Records the center that a comment gives. `# center: p/q, p/q` is the only comment with a meaning.
fn read_comment(
    source: Source<'_>,
    start: u32,
    comment: &str,
    center: &mut Option<Span>,
) -> Result<()> {
    let body = comment.trim_start_matches(['#', '/', '%']);
    let Some(value) = body.trim_start().strip_prefix("center:") else {
        return Ok(());
    };
    let end = start + u32::try_from(comment.len()).invariant("a text is shorter than 4 GiB");
    let length = u32::try_from(value.len()).invariant("a text is shorter than 4 GiB");
    let span = Span {
        start: end - length,
        end,
    };
    if center.replace(span).is_some() {
        return Err(source.error(span, "a second center"));
    }
    Ok(())
}

/// The modules of Python and JavaScript whose names are written before functions, as in `np.cos`.
const MODULES: [&str; 6] = ["np", "numpy", "math", "sympy", "sp", "Math"];

/// Reads a run of letters, which consists of names or is one unknown word. The name of a module and the point after it are no
/// tokens.
fn word(input: &mut Input<'_>, tokens: &mut Vec<Token>) {
    let start = position(input);
    let letter = |c: char| c.is_alphabetic() || c == '√';
    let text: winnow::Result<&str> = take_while(1.., letter).parse_next(input);
    let text = text.invariant("a word begins with a letter");
    let is_followed =
        input.starts_with('.') && input.chars().nth(1).is_some_and(char::is_alphabetic);
    if MODULES.contains(&text) && is_followed {
        let _: winnow::Result<char> = any.parse_next(input);
        return;
    }
    match split_word(text, start) {
        Some(names) => tokens.extend(names.into_iter().map(|(name, span)| Token {
            kind: Kind::Name(name),
            span,
        })),
        None => tokens.push(Token {
            kind: Kind::Unknown,
            span: Span {
                start,
                end: position(input),
            },
        }),
    }
}

fn number(input: &mut Input<'_>) -> std::result::Result<Kind, &'static str> {
    let hex: ModalResult<Option<&str>> = opt(hexadecimal).parse_next(input);
    if hex.is_ok_and(|h| h.is_some()) {
        return Ok(Kind::Number);
    }
    if mantissa.parse_next(input).is_err() {
        return Err(with_next_character(input, "a point without digits"));
    }
    let exponent: winnow::Result<Option<_>> =
        opt((one_of(['e', 'E']), opt(one_of(['+', '-', '−'])), digit1)).parse_next(input);
    if exponent.is_ok_and(|e| e.is_none()) && input.starts_with(['e', 'E']) {
        // `2exp(…)` is a product with a function, but `2e` and `2e+` are slips.
        let follows_a_letter = input.chars().nth(1).is_some_and(char::is_alphabetic);
        if !follows_a_letter {
            return Err(with_next_character(
                input,
                "the exponent after e needs digits, as in 2e5",
            ));
        }
    }
    Ok(Kind::Number)
}

/// Reads one more character, so that the text that the message quotes contains it, and returns the message.
fn with_next_character(input: &mut Input<'_>, message: &'static str) -> &'static str {
    let _: winnow::Result<char> = any.parse_next(input);
    message
}

/// Reads `12`, `1.5`, `.5` or `2.`; of `0..1` it reads only the 0.
fn mantissa<'a>(input: &mut Input<'a>) -> ModalResult<&'a str> {
    let fraction = opt((not(".."), '.', digit0));
    alt(((digit1, fraction).take(), ('.', digit1).take())).parse_next(input)
}

/// Reads a hexadecimal float such as `0x1.8p+1`; `0x^2` is 0 times x².
fn hexadecimal<'a>(input: &mut Input<'a>) -> ModalResult<&'a str> {
    let digits = alt((
        (hex_digit1, opt(('.', hex_digit0))).take(),
        ('.', hex_digit1).take(),
    ));
    let exponent = opt((one_of(['p', 'P']), opt(one_of(['+', '-', '−'])), digit1));
    preceded(('0', one_of(['x', 'X'])), (digits, exponent).take()).parse_next(input)
}

fn symbol(input: &mut Input<'_>) -> Kind {
    let superscripts: ModalResult<&str> = take_while(1.., SUPERSCRIPTS).parse_next(input);
    if superscripts.is_ok() {
        return Kind::Superscript;
    }
    let power: ModalResult<&str> = "**".parse_next(input);
    if power.is_ok() {
        return Kind::Caret;
    }
    // `:=` is written in Maple, `//` in fractions of Julia, and `.^`, `.*` and `./` in formulas with arrays.
    for (written, kind) in [
        ("==", Kind::Equals),
        (":=", Kind::Equals),
        ("//", Kind::Slash),
        (".^", Kind::Caret),
        (".*", Kind::Star),
        ("./", Kind::Slash),
    ] {
        let found: ModalResult<&str> = literal(written).parse_next(input);
        if found.is_ok() {
            return kind;
        }
    }
    let c: winnow::Result<char> = any.parse_next(input);
    match c.invariant("the text does not end here") {
        '+' => Kind::Plus,
        '-' | '−' | '–' => Kind::Minus,
        '*' | '·' | '×' | '⋅' | '∙' => Kind::Star,
        '/' | '÷' => Kind::Slash,
        '^' => Kind::Caret,
        '(' | '[' | '{' => Kind::Open,
        ')' | ']' | '}' => Kind::Close,
        ',' => Kind::Comma,
        '=' => Kind::Equals,
        ';' => Kind::Semicolon,
        '\n' => Kind::Newline,
        _ => Kind::Other,
    }
}

/// The tokens without the newlines that do not end an equation. These are the newlines within parentheses; those after an
/// operator, a comma or `=`; those before `*`, `/`, `^` or `=`; and those before a line that begins with + or −, unless both
/// this line and the equation before it have an `=`.
fn join_lines(tokens: &[Token]) -> Vec<Token> {
    let mut kept: Vec<Token> = Vec::with_capacity(tokens.len());
    let (mut depth, mut equals) = (0_usize, false);
    for (i, &token) in tokens.iter().enumerate() {
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Equals => equals = true,
            Kind::Semicolon => equals = false,
            Kind::Newline => {
                let before = kept.last().map_or(Kind::Semicolon, |t| t.kind);
                let joins_before = matches!(
                    before,
                    Kind::Plus
                        | Kind::Minus
                        | Kind::Star
                        | Kind::Slash
                        | Kind::Caret
                        | Kind::Comma
                        | Kind::Equals
                        | Kind::Semicolon
                        | Kind::Newline
                );
                let joins_after = match tokens.get(i + 1).map(|t| t.kind) {
                    Some(Kind::Star | Kind::Slash | Kind::Caret | Kind::Equals) => true,
                    Some(Kind::Plus | Kind::Minus) => {
                        !(equals && line_has_equals(&tokens[i + 1..]))
                    }
                    // The next newline decides whether the equation ends.
                    Some(Kind::Newline | Kind::End) => true,
                    _ => false,
                };
                if depth > 0 || joins_before || joins_after {
                    continue;
                }
                equals = false;
            }
            _ => {}
        }
        kept.push(token);
    }
    kept
}

fn line_has_equals(tokens: &[Token]) -> bool {
    tokens
        .iter()
        .take_while(|t| !matches!(t.kind, Kind::Newline | Kind::Semicolon))
        .any(|t| t.kind == Kind::Equals)
}
