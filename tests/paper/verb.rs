//! `stellate paper`: every statement comes out as recorded, a changed digit shows, and the command line.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::common::program::{done, json, run_in};
use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};
use stellate::limits::Limits;
use stellate::paper::{EntryVerdict, TestPart, entries, read_entries};

#[test]
fn every_statement_comes_out_as_recorded() {
    let entries = entries().unwrap();
    assert!(entries.len() >= 60, "{}", entries.len());
    let ids: BTreeSet<&str> = entries.iter().map(|e| e.id).collect();
    assert_eq!(ids.len(), entries.len(), "an id occurs twice");
    for number in 1..=8 {
        assert!(ids.contains(format!("T{number}").as_str()), "T{number}");
    }
    for number in 1..=10 {
        assert!(ids.contains(format!("L{number}").as_str()), "L{number}");
    }
    for number in 1..=12 {
        assert!(ids.contains(format!("E{number}").as_str()), "E{number}");
    }
    for number in 1..=14 {
        assert!(ids.contains(format!("F{number}").as_str()), "F{number}");
    }
    entries.par_iter().for_each(|entry| {
        let outcome = entry.evaluate(&Limits::none()).unwrap();
        assert!(outcome.expected, "{}: {:#?}", entry.id, outcome);
        let printed = outcome.findings.iter();
        let printed = printed.filter(|f| f.part == TestPart::Printed && !f.holds);
        assert_eq!(printed.count() > 0, outcome.verdict != EntryVerdict::Holds);
        assert!(!entry.section.is_empty() && !entry.printed.is_empty());
        // What holds as printed has no correction.
        let is_corrected = entry.correct != entry.printed;
        let holds = outcome.verdict == EntryVerdict::Holds;
        assert_eq!(is_corrected, !holds, "{}", entry.id);
    });
}

/// The files of statements.
fn statements() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/paper/statements");
    let files = fs::read_dir(folder).unwrap().map(|f| f.unwrap().path());
    files.collect()
}

/// The blocks of a file, an entry each, below the line of its section.
fn blocks(text: &str) -> Vec<String> {
    let mut blocks: Vec<String> = Vec::new();
    for line in text.lines() {
        if line.starts_with('[') {
            blocks.push("== Section\n".into());
        }
        if let Some(block) = blocks.last_mut().filter(|_| !line.starts_with('=')) {
            block.push_str(line);
            block.push('\n');
        }
    }
    blocks
}

/// The places of the digits whose change must show in a line: those of definitions, of identities that hold or whose
/// difference is stated, and the last one of the answer to a question.
fn telling_digits(line: &str) -> Vec<usize> {
    let Some((key, value)) = line.split_once(':') else {
        return Vec::new();
    };
    let digits = |text: &str, offset: usize| -> Vec<usize> {
        let places = text.char_indices().filter(|(_, c)| c.is_ascii_digit());
        places.map(|(at, _)| at + offset).collect()
    };
    let is_identity = value.trim_start().starts_with("identity:");
    let stated = value.contains(" => ");
    match key {
        "where" | "squares" => digits(value, key.len() + 1),
        "test" | "test corrected" if is_identity => digits(value, key.len() + 1),
        "test printed" if is_identity && stated => digits(value, key.len() + 1),
        "test" | "test corrected" if stated => {
            let start = line.find(" => ").unwrap();
            digits(&line[start..], start)
                .last()
                .copied()
                .into_iter()
                .collect()
        }
        _ => Vec::new(),
    }
}

/// Long lines have too many digits to change each of them.
const MOST_DIGITS: usize = 10;

#[test]
fn a_changed_digit_makes_the_statement_fail() {
    let texts: Vec<String> = statements()
        .iter()
        .map(|f| fs::read_to_string(f).unwrap())
        .collect();
    let blocks: Vec<String> = texts.iter().flat_map(|text| blocks(text)).collect();
    assert!(blocks.len() >= 60);
    let mutants: Vec<Mutant> = blocks.iter().flat_map(|block| mutants(block)).collect();
    assert!(mutants.len() > 500, "{}", mutants.len());
    let unnoticed: Vec<&Mutant> = mutants.par_iter().filter(|m| !m.is_noticed()).collect();
    assert!(unnoticed.is_empty(), "{unnoticed:#?}");
}

/// A block with one digit changed.
#[derive(Debug)]
enum Mutant {
    /// In what all tests share: the statement must fail.
    Block(String),
    /// In this test, without the others: the printed part of the paper is to fail in another way than stated, anything else
    /// to fail, and then the statement does, whatever the others say.
    Test(String),
}

impl Mutant {
    fn is_noticed(&self) -> bool {
        match self {
            Mutant::Block(text) => !comes_out(text),
            Mutant::Test(text) => {
                let Ok(entries) = read_entries(text, "mutated") else {
                    return true;
                };
                let Ok(outcome) = entries[0].evaluate(&Limits::none()) else {
                    return true;
                };
                let [finding] = &outcome.findings[..] else {
                    panic!("one test: {text}");
                };
                if finding.part == TestPart::Printed {
                    finding.surprising
                } else {
                    !finding.holds
                }
            }
        }
    }
}

/// The block with one telling digit changed, for each of them.
fn mutants(block: &str) -> Vec<Mutant> {
    let is_test = |line: &str| line.starts_with("test");
    let shared: String = block
        .split_inclusive('\n')
        .filter(|line| !is_test(line))
        .collect();
    let mut mutants = Vec::new();
    for line in block.split_inclusive('\n') {
        let places = telling_digits(line);
        let step = places.len().div_ceil(MOST_DIGITS).max(1);
        for at in places.into_iter().step_by(step) {
            let digit = line[at..].chars().next().unwrap().to_digit(10).unwrap();
            let mut changed = line.to_owned();
            changed.replace_range(at..=at, &((digit + 1) % 10).to_string());
            mutants.push(if is_test(line) {
                Mutant::Test(format!("{shared}{changed}"))
            } else {
                Mutant::Block(block.replacen(line, &changed, 1))
            });
        }
    }
    mutants
}

/// Whether the one entry of a text is read and comes out as recorded.
fn comes_out(text: &str) -> bool {
    let Ok(entries) = read_entries(text, "mutated") else {
        return false;
    };
    let [entry] = &entries[..] else {
        panic!("one entry");
    };
    entry.evaluate(&Limits::none()).is_ok_and(|o| o.expected)
}

#[test]
fn another_recorded_verdict_is_not_what_comes_out() {
    let recorded = ["holds", "holds once corrected", "claim too strong"];
    for path in statements() {
        let text = fs::read_to_string(path).unwrap();
        let blocks = blocks(&text);
        let results = blocks.into_par_iter().map(|block| {
            let kept: Vec<&str> = block
                .lines()
                .filter(|l| !l.starts_with("expected:"))
                .collect();
            let with = |verdict: &&str| format!("{}\nexpected: {verdict}\n", kept.join("\n"));
            recorded.iter().filter(|v| comes_out(&with(v))).count()
        });
        assert!(results.all(|count| count == 1));
    }
}

#[test]
fn malformed_statements_are_refused_with_their_line() {
    for (text, reason) in [
        (
            "[X] title\nprinted a",
            "x.txt, line 2: expected `[ID] title`",
        ),
        ("test: identity: a = a", "line 1: expected `[ID] title`"),
        ("[X] title\nproof: trivial", "unknown key `proof`"),
        ("[X] title\nexpected: maybe", "no verdict: maybe"),
        (
            "[X] title\ntest: identity: a + = b",
            "expected a number, a symbol or `(`",
        ),
        ("[X] title\ntest: identity: a", "expected one equation"),
        (
            "[X] title\ntest: colour: x => red",
            "expected `identity: …`, or one of: equation, ",
        ),
        (
            "[X] title\ntest: degrees: x",
            "expected ` => ` and the answer",
        ),
    ] {
        let error = read_entries(text, "x.txt").unwrap_err().to_string();
        assert!(error.contains(reason), "{error}");
    }
    // Wrong questions are errors when they are asked, never an answer.
    for question in [
        "degrees: x = t; y = t => 1",
        "spurious: x^2 => none",
        "fitted degrees: whale | 3 => 8",
        "positive roots: x^2 + y^2 - 1 => 1",
        "section: x^2 - 1 | 0, 0 | 1 => none",
        "squared away: 9 => rho",
        "curves: x^2 - 1 => (t, t, t)",
    ] {
        let text = format!("[X] title\ntest: {question}\n");
        let entries = read_entries(&text, "x.txt").unwrap();
        assert!(entries[0].evaluate(&Limits::none()).is_err(), "{question}");
    }
}

#[test]
fn the_table_and_the_document_say_the_same() {
    let table = done(&["paper", "--threads", "1"]);
    assert!(
        table.starts_with("Parametric to implicit (§2)\n  T1 "),
        "{table}"
    );
    assert!(table.contains("  L4      holds once corrected  Lemma 4: the roots of the cubic\n"));
    assert!(table.ends_with("; 0 not as expected\n"), "{table}");

    let document = json(&done(&["paper", "--format", "json"]));
    assert_eq!(document["schema"], "stellate/1");
    assert_eq!(document["kind"], "paper");
    assert!(document.get("comparison").is_none());
    let found = document["entries"].as_array().unwrap();
    assert_eq!(found.len(), entries().unwrap().len());
    for entry in found {
        assert_eq!(entry["expected"], true);
        for field in ["id", "title", "printed", "correct", "verdict", "evidence"] {
            assert!(!entry[field].as_str().unwrap().is_empty(), "{entry}");
        }
        let [id, verdict, title] =
            ["id", "verdict", "title"].map(|field| entry[field].as_str().unwrap());
        let row = format!("  {id:6}  {verdict:20}  {title}\n");
        assert!(table.contains(&row), "{row}");
    }
}

#[test]
fn one_statement_in_full() {
    let fold = done(&["paper", "--only", "e9"]);
    assert!(
        fold.contains("What is printed fails here: at 219.34, "),
        "{fold}"
    );
    let found = " degrees, the number of positive radii of `paper-examples/e09-sixth-degree/curve.txt` is 1, 3, 3, 3, 1";
    assert!(
        fold.contains(&format!("{found}, and not 1, 1, 1, 1, 1.\n")),
        "{fold}"
    );
    assert!(fold.contains(&format!("{found}.\n")), "{fold}");
    let meaning = EntryVerdict::ClaimTooStrong.meaning();
    let end = format!("verdict: claim too strong\nmeaning: {meaning}\n");
    assert!(fold.ends_with(&end), "{fold}");
    let cubic = done(&["paper", "--only", "L4"]);
    assert!(
        cubic.contains("What is printed fails here: the equation `A + B = r1` is false, since "),
        "{cubic}"
    );
    assert!(
        cubic.contains(" Its left side is its right side plus `p/(3*s)`.\n"),
        "{cubic}"
    );
    let corrected =
        "What is correct holds here: the equation `A + B - p/(3*s) = r1` holds identically in ";
    assert!(cubic.contains(corrected), "{cubic}");
}

#[test]
fn statements_are_found_by_their_titles() {
    for (wanted, expected) in [
        ("t2", &["T2"][..]),
        ("Theorem 2", &["T2", "T2b", "T2f", "T2s", "T2R"]),
        ("Lemma 1", &["L1"]),
        ("resolvent cubic", &["Eq63"]),
        ("eq 63", &["Eq63"]),
        ("EXAMPLE 8", &["E8", "E8d", "E8t"]),
        ("no such thing", &[]),
        // No word of a title, but a part of one.
        ("butterfl", &["E2", "F3"]),
    ] {
        let arguments = ["paper", "--format", "json", "--only", wanted];
        let run = run_in(Path::new("."), &arguments, "");
        if expected.is_empty() {
            assert_eq!((run.code, run.out.as_str()), (2, ""), "{wanted}");
            continue;
        }
        let document = json(&run.out);
        let found = document["entries"].as_array().unwrap().iter();
        let found: Vec<&str> = found.map(|e| e["id"].as_str().unwrap()).collect();
        assert_eq!(found, expected, "{wanted}");
    }
    // As text, one below the other.
    let both = done(&["paper", "--only", "butterfl"]);
    assert!(both.starts_with("E2: Example 2"), "{both}");
    assert!(both.contains("\n\nF3: Fig. 3: the butterfly\n"), "{both}");
    assert_eq!(both.matches("\nverdict: holds\n").count(), 2);
}

#[test]
fn the_evidence_is_in_whole_sentences() {
    let document = json(&done(&["paper", "--format", "json"]));
    for entry in document["entries"].as_array().unwrap() {
        for line in entry["evidence"].as_str().unwrap().lines() {
            assert!(line.ends_with('.') && !line.ends_with(".."), "{line}");
            assert!(line.starts_with(char::is_uppercase), "{line}");
            assert!(
                !line.contains("  ") && !line.contains(['{', '}', '|']),
                "{line}"
            );
            assert_eq!(line.matches('`').count() % 2, 0, "{line}");
        }
        if let Some(note) = entry["note"].as_str() {
            assert!(
                note.ends_with('.') && note.starts_with(char::is_uppercase),
                "{note}"
            );
        }
    }
}

#[test]
fn the_verdicts_of_these_statements_follow_from_what_they_say() {
    let document = json(&done(&["paper", "--format", "json"]));
    let entry = |id: &str| {
        let entries = document["entries"].as_array().unwrap();
        entries.iter().find(|e| e["id"] == id).unwrap().clone()
    };
    let said = |id: &str, field: &str, part: &str| {
        let entry = entry(id);
        assert!(entry[field].as_str().unwrap().contains(part), "{entry}");
    };
    said(
        "T2",
        "evidence",
        "What is printed holds here: the polynomial of `r = 3/2` ",
    );
    said(
        "T2",
        "evidence",
        " vanishes at the origin to the order 2, and not 0.",
    );
    said(
        "T2",
        "correct",
        "the origin is a spurious point of the zero set",
    );
    said("E2", "printed", "implicit polynomials of degree 80");
    said("E2", "note", "`paper-examples/e02-jet/jet.csv`");
    said(
        "E2",
        "evidence",
        "the outline `paper-examples/e02-jet/jet.csv` have the degrees 80, 79, 78.",
    );
    said("F10", "note", "both coordinate axes belong to it");
    said("F10", "evidence", " have the angles `pi/2, 0`.");
}

#[test]
fn the_document_of_one_statement_has_one_entry() {
    let one = json(&done(&["paper", "--only", "Eq63", "--format", "json"]));
    assert_eq!(one["entries"].as_array().unwrap().len(), 1);
    assert_eq!(one["entries"][0]["verdict"], "holds once corrected");
}

#[test]
fn wrong_use_is_one_clear_error() {
    let folder = Path::new(".");
    for (arguments, reason) in [
        (
            &["paper", "--only", "T9"][..],
            "--only T9: no statement has this id, or this in its title, as Theorem 2 or cubic; the ids are T1, ",
        ),
        (
            &["paper", "--format", "csv"],
            "--format csv: the statements of the paper are written as text or json",
        ),
        (
            &["paper", "-o", "no/such/folder/paper.txt"],
            "there is no folder",
        ),
        (&["paper", "--only", " "], "no statement has this id"),
        (&["paper", "T1"], "paper takes options only"),
    ] {
        let run = run_in(folder, arguments, "");
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
        assert!(run.err.contains(reason), "{}", run.err);
    }
    let run = run_in(folder, &["paper", "--time-limit", "0"], "");
    assert_eq!((run.code, run.out.as_str()), (3, ""), "{}", run.err);
}
