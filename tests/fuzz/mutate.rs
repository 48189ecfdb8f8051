//! Mutations of bytes, of tokens, of lines, and of numbers.

use std::ops::Range;

use super::draw::Draw;

/// Numbers that readers find hard.
const NUMBERS: [&str; 30] = [
    "0",
    "-0",
    "1",
    "-1",
    "1e400",
    "1e-400",
    "1e100000",
    "1e100001",
    "-1e-100001",
    "0x1p-1074",
    "0x1.fffffffffffffp+1023",
    "0x",
    "0x1p99999999999",
    "nan",
    "inf",
    "-inf",
    "1/0",
    "0/0",
    "1/3",
    "18446744073709551616",
    "9223372036854775807",
    "4294967296",
    "2147483648",
    "65536",
    "20003",
    "1e",
    ".",
    "1.",
    ".5",
    "0.1000000000000000055511151231257827021181583404541015625",
];

/// Words of the language and of documents, and other things that mean something somewhere.
const WORDS: [&str; 58] = [
    "cos(",
    "sin(",
    "theta",
    "phi",
    "t",
    "x",
    "y",
    "z",
    "r",
    "=",
    ";",
    "^",
    "**",
    "*",
    "/",
    "+",
    "-",
    "−",
    "(",
    ")",
    "((",
    "superquadric",
    "2d",
    "3d",
    "a1=",
    "epsilon=",
    "# center: ",
    "#",
    "pi",
    "θ",
    "φ",
    "²",
    "sqrt(",
    "e",
    "i",
    "\n",
    "\r\n",
    "\t",
    "\0",
    "\u{feff}",
    "\u{2028}",
    "{",
    "}",
    "[",
    "]",
    "\"",
    ",",
    ":",
    "null",
    "true",
    "\"kind\"",
    "\"schema\"",
    "\"terms\"",
    "\"center\"",
    "\\u0000",
    "i,j,k,coefficient",
    "n,cos,sin",
    "^20002",
];

fn range(draw: &mut Draw, length: usize, longest: usize) -> Range<usize> {
    if length == 0 {
        return 0..0;
    }
    let start = draw.index(length);
    let most = longest.min(length - start).max(1);
    start..start + 1 + draw.index(most)
}

/// Maximal runs of letters, digits and points, of spaces, and any other single bytes.
fn tokens(bytes: &[u8]) -> Vec<Range<usize>> {
    let class = |b: u8| match b {
        b'0'..=b'9' | b'.' => 1,
        b'a'..=b'z' | b'A'..=b'Z' | b'_' => 2,
        b' ' | b'\n' => 3,
        _ => 0,
    };
    let mut found: Vec<Range<usize>> = Vec::new();
    for (i, b) in bytes.iter().enumerate() {
        match found.last_mut() {
            Some(last) if class(*b) != 0 && class(bytes[last.start]) == class(*b) => {
                last.end = i + 1
            }
            _ => found.push(i..i + 1),
        }
    }
    found
}

fn lines(bytes: &[u8]) -> Vec<Vec<u8>> {
    bytes.split(|b| *b == b'\n').map(<[u8]>::to_vec).collect()
}

fn number(draw: &mut Draw) -> Vec<u8> {
    match draw.below(8) {
        0 => {
            let length = draw.pick(&[20, 400, 5000]);
            (0..length).map(|_| b'0' + draw.below(10) as u8).collect()
        }
        1 => draw.small(300).to_string().into_bytes(),
        2 => format!("{:e}", draw.double(1000)).into_bytes(),
        _ => draw.pick(&NUMBERS).as_bytes().to_vec(),
    }
}

/// A number replaced by another one.
fn with_other_number(draw: &mut Draw, bytes: &mut Vec<u8>) {
    let all = tokens(bytes);
    let numbers: Vec<_> = all
        .into_iter()
        .filter(|t| bytes[t.start].is_ascii_digit())
        .collect();
    if !numbers.is_empty() {
        let place = draw.pick(&numbers);
        let other = number(draw);
        bytes.splice(place, other);
    }
}

/// Something nested very deep, somewhere.
fn nested(draw: &mut Draw, bytes: &mut Vec<u8>) {
    let depth = draw.pick(&[3, 100, 255, 256, 257, 3000, 100_000]);
    let (open, close) = draw.pick(&[
        ("(", ")"),
        ("[", "]"),
        ("{\"a\":", "}"),
        ("-", ""),
        ("2^", ""),
        ("cos(", ")"),
    ]);
    let place = range(draw, bytes.len(), bytes.len());
    let mut inner = bytes[place.clone()].to_vec();
    let depth = if bytes.len() > 5000 {
        depth.min(3000)
    } else {
        depth
    };
    inner.splice(0..0, open.repeat(depth).into_bytes());
    if !draw.once_in(4) {
        inner.extend(close.repeat(depth).into_bytes());
    }
    bytes.splice(place, inner);
}

/// One mutation of text.
fn text_step(draw: &mut Draw, bytes: &mut Vec<u8>, seeds: &[Vec<u8>]) {
    match draw.below(12) {
        0..3 => with_other_number(draw, bytes),
        3 => {
            let all = tokens(bytes);
            if all.len() > 1 {
                let (a, b) = (draw.pick(&all), draw.pick(&all));
                let (a, b) = if a.start < b.start { (a, b) } else { (b, a) };
                let [first, second] = [a.clone(), b.clone()].map(|t| bytes[t].to_vec());
                bytes.splice(b, first);
                bytes.splice(a, second);
            }
        }
        4 => {
            let at = draw.index(bytes.len() + 1);
            let word = draw.pick(&WORDS);
            bytes.splice(at..at, word.bytes());
        }
        5 => {
            let all = tokens(bytes);
            if !all.is_empty() {
                bytes.drain(draw.pick(&all));
            }
        }
        6 => {
            let mut all = lines(bytes);
            let i = draw.index(all.len());
            match draw.below(3) {
                0 => {
                    let times = draw.pick(&[1, 2, 50]);
                    let row = all[i].clone();
                    all.splice(i..i, std::iter::repeat_n(row, times));
                }
                1 => {
                    all.remove(i);
                }
                _ => {
                    let j = draw.index(all.len());
                    all.swap(i, j);
                }
            }
            *bytes = all.join(&b'\n');
        }
        7 => nested(draw, bytes),
        8 => {
            let other = draw.pick(seeds);
            let from = other[range(draw, other.len(), other.len())].to_vec();
            let place = range(draw, bytes.len(), 40);
            bytes.splice(place, from);
        }
        _ => bytes_step(draw, bytes),
    }
}

/// One mutation of bytes.
pub(crate) fn bytes_step(draw: &mut Draw, bytes: &mut Vec<u8>) {
    if bytes.is_empty() {
        bytes.push(draw.word() as u8);
        return;
    }
    let at = draw.index(bytes.len());
    match draw.below(6) {
        0 => bytes[at] ^= 1 << draw.below(8),
        1 => bytes[at] = draw.pick(&[0, 0xff, 0x7f, 0x80, 0xc3, 0xfe, b'"', b'\n']),
        2 => bytes.insert(at, draw.word() as u8),
        3 => {
            let place = range(draw, bytes.len(), 50);
            bytes.drain(place);
        }
        4 => {
            let place = range(draw, bytes.len(), 200);
            let copy = bytes[place].to_vec();
            bytes.splice(at..at, copy);
        }
        _ => bytes.truncate(at),
    }
}

/// A seed with a few mutations.
pub(crate) fn mutated_text(draw: &mut Draw, seeds: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = draw.pick(seeds);
    for _ in 0..1 + draw.below(5).min(draw.below(5)) {
        text_step(draw, &mut bytes, seeds);
        bytes.truncate(1 << 20);
    }
    bytes
}

/// Bytes for people, not too many.
pub(crate) fn shown(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    let short: String = text.chars().take(1500).collect();
    let more = if short.len() < text.len() { " …" } else { "" };
    format!("{} bytes {short:?}{more}", bytes.len())
}

#[test]
fn mutations_change_something_and_repeat() {
    let seeds = vec![b"x^2 + 3*y = 1".to_vec(), b"r = 1 + cos(t)".to_vec()];
    let all = |seed: u64| mutated_text(&mut Draw::new("mutate", seed), &seeds);
    let changed = (0..200).filter(|seed| !seeds.contains(&all(*seed)));
    assert!(changed.count() > 150);
    assert!((0..50).all(|seed| all(seed) == all(seed)));
}
