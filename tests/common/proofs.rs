//! Commands that write proofs, drawn at random.

use std::path::Path;

use super::program::run_in;
use super::random::SplitMix;

fn below(words: &mut SplitMix, n: u64) -> u64 {
    words.word() % n
}

/// A number that is not 0: a small integer, a fraction or a decimal.
fn number(words: &mut SplitMix) -> String {
    let digit = below(words, 9) + 1;
    match below(words, 4) {
        0 => format!("{digit}/{}", below(words, 8) + 2),
        1 => format!("{}.{digit}", below(words, 3)),
        _ => digit.to_string(),
    }
}

fn sign(words: &mut SplitMix) -> &'static str {
    if below(words, 2) == 0 { "+" } else { "-" }
}

/// A polynomial in the variables of about this degree with a few terms and a constant.
fn polynomial(words: &mut SplitMix, variables: &[&str], degree: u64) -> String {
    let mut text = number(words);
    for variable in variables {
        text += &format!(" {} {}*{variable}^{degree}", sign(words), number(words));
    }
    for _ in 0..3 {
        let mut rest = degree;
        let mut term = format!(" {} {}", sign(words), number(words));
        for variable in variables {
            let exponent = below(words, rest + 1);
            rest -= exponent;
            term += &format!("*{variable}^{exponent}");
        }
        text += &term;
    }
    text
}

/// A radius with a few harmonics.
fn radius(words: &mut SplitMix) -> String {
    let mut text = format!("r = {}", below(words, 3) + 2);
    for n in 1..=below(words, 4) + 1 {
        let wave = if below(words, 2) == 0 { "cos" } else { "sin" };
        text += &format!(" {} 1/{}*{wave}({n}*t)", sign(words), below(words, 9) + 1);
    }
    text
}

fn harmonics(words: &mut SplitMix) -> String {
    let mut text = "R = 10".to_owned();
    for _ in 0..3 {
        let l = below(words, 3) + 1;
        let m = i64::try_from(below(words, 2 * l + 1)).unwrap() - i64::try_from(l).unwrap();
        text += &format!(" {} {}*Y({l},{m})", sign(words), number(words));
    }
    text
}

fn point(words: &mut SplitMix, dimension: usize) -> String {
    let coordinate = |words: &mut SplitMix| {
        let minus = if below(words, 2) == 0 { "-" } else { "" };
        format!("{minus}{}.{}", below(words, 3), below(words, 100))
    };
    let all: Vec<String> = (0..dimension).map(|_| coordinate(words)).collect();
    all.join(",")
}

/// The arguments of a command of one of several kinds.
pub(crate) fn drawn_command(words: &mut SplitMix) -> Vec<String> {
    let plane = ["x", "y"];
    let space = ["x", "y", "z"];
    let mut extra: Vec<String> = Vec::new();
    let mut inspect = |words: &mut SplitMix, dimension| {
        extra.push(format!("--tolerance=1/{}", below(words, 20) + 2));
        for _ in 0..3 {
            extra.push(format!("--point={}", point(words, dimension)));
        }
    };
    let (verb, form) = match below(words, 13) {
        0 => ("sample", polynomial(words, &plane, 5)),
        1 => {
            let [f, g] = [2, 3].map(|degree| polynomial(words, &plane, degree));
            ("sample", format!("({f})^2*({g})"))
        }
        2 => ("sample", polynomial(words, &space, 4)),
        3 => {
            let [f, g] = [2, 3].map(|degree| polynomial(words, &plane, degree));
            ("describe", format!("({f})*({g})^2"))
        }
        4 => ("describe", radius(words)),
        5 => ("describe", harmonics(words)),
        6 => ("implicitize", radius(words)),
        7 => {
            let [p, q, r] = [2, 2, 3].map(|degree| polynomial(words, &["t"], degree));
            ("implicitize", format!("x = ({p})/({q}); y = {r}"))
        }
        8 => ("implicitize", harmonics(words)),
        9 => {
            inspect(words, 2);
            ("inspect", polynomial(words, &plane, 4))
        }
        10 => {
            inspect(words, 3);
            ("inspect", polynomial(words, &space, 2))
        }
        11 => {
            inspect(words, 2);
            ("inspect", radius(words))
        }
        _ => ("parametrize", polynomial(words, &plane, 3)),
    };
    let mut arguments = vec![verb.to_owned(), form];
    if verb == "sample" {
        extra.push("--directions=3".into());
    }
    arguments.append(&mut extra);
    arguments
}

/// The proof that the command writes in the folder.
pub(crate) fn proof_of(arguments: &[String], folder: &Path) -> String {
    let mut all: Vec<&str> = arguments.iter().map(String::as_str).collect();
    all.extend(["--proof", "proof.json", "-o", "out"]);
    let run = run_in(folder, &all, "");
    assert!(run.code <= 1, "{arguments:?}: {}", run.err);
    std::fs::read_to_string(folder.join("proof.json")).unwrap()
}
