//! Documents as a whole, and texts that are none.

use super::{
    ANGLE, BALL, CIRCLE, EGG, SPHERE, assert_accepted, assert_refused, distance, document, report,
};
use crate::proof::check;

#[test]
fn claims_without_a_witness_are_counted() {
    let topology = document(
        &[],
        "topology",
        r#"{"anything":[null,true,"text",-7]}"#,
        "null",
    );
    let found = report(&topology);
    assert_eq!((found.without_witness(), found.holds()), (1, true));
    assert!(!check(&topology, true).is_ok_and(|report| report.holds()));
    assert_refused(&topology.replace("null}]}", r#"{"depth":1}}]}"#), "witness");
    assert_refused(
        &topology.replace(r#"{"anything":[null,true,"text",-7]}"#, "{}"),
        "statement",
    );
    assert_refused(&topology.replace("topology", "tropology"), "claim");
}

#[test]
fn the_same_claim_is_not_made_twice() {
    let claim =
        |statement: &str| format!(r#"{{"claim":"genus","statement":{statement},"witness":null}}"#);
    let document = |second: &str| {
        let claims = [claim(r#"{"a":1,"b":[2,"x"]}"#), claim(second)].join(",");
        format!(r#"{{"schema":"stellate/1","kind":"proof","forms":[],"claims":[{claims}]}}"#)
    };
    assert_eq!(
        report(&document(r#"{"b":[2,"\u0078"],"a":1}"#)).refused[0].index,
        1
    );
    assert_accepted(&document(r#"{"b":[2,"x"],"a":true}"#));
}

#[test]
fn a_text_that_is_no_proof_is_an_error() {
    let good = document(&[CIRCLE], "topology", r#"{"n":1}"#, "null");
    assert_accepted(&good);
    let changes = [
        ("stellate/1", "stellate/2"),
        (r#""proof""#, r#""proofs""#),
        (r#""n":1"#, r#""n":1,"n":1"#),
        (r#""n":1"#, r#""n":1.0"#),
        (r#""n":1"#, r#""n":1e2"#),
        (r#""n":1"#, r#""n":-0"#),
        (r#""n":1"#, r#""n":2147483649"#),
        (r#""n":1"#, r#""n":123456789012345678901234567890"#),
        (r#""n":1"#, r#""n":NaN"#),
        (r#""n":1"#, r#""n":01"#),
        (r#""n":1"#, r#""$serde_json::private::Number":"1""#),
        (r#""n":1"#, r#""\u0024serde_json::private::Number":"1""#),
        (r#""n":1"#, r#""n":"\ud800""#),
        (r#""1""#, r#""0""#),
        ("[2,0]", "[2,0,0]"),
        ("[2,0]", "[513,0]"),
        ("[2,0]", "[0,2]"),
        (r#"["x","y"]"#, r#"["y","x"]"#),
        (r#""implicit""#, r#""explicit""#),
        (r#""claims""#, r#""Claims""#),
        ("]}", "]}]"),
    ];
    for (old, new) in changes {
        let changed = good.replacen(old, new, 1);
        assert_ne!(changed, good);
        assert!(check(&changed, false).is_err(), "{changed}");
    }
    for text in [
        "",
        "null",
        "[]",
        "{",
        "\u{feff}{}",
        &"[".repeat(100_000),
        &"9".repeat(100_000),
    ] {
        assert!(check(text, false).is_err());
    }
}

/// A generator of pseudorandom numbers (Marsaglia's xorshift), which is good enough to change bytes.
struct Changes(u64);

impl Changes {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 >> 33).unwrap_or(0) % limit
    }
}

#[test]
fn no_change_of_a_few_bytes_makes_the_checker_panic() {
    const PIECES: [&str; 16] = [
        "0", "-", "9", "\"", "[", "]", "{", "}", ",", ":", "/", "null", "\"line\"", "99999999",
        "\"inf\"", "\u{e9}",
    ];
    let witness =
        r#"{"breakpoints":["0"],"parts":[{"multiplicity":1,"coefficients":["-1/4","0","1"]}]}"#;
    let roots = r#"{"form":0,"direction":["3/5","4/5"],"order_at_zero":0,"center":["1","0"],
        "roots":[{"multiplicity":1,"nearest":"-0.5"},{"multiplicity":1,"position":["1.3","0.4"]}]}"#;
    let texts = [
        document(&[CIRCLE], "root-count", roots, witness),
        document(
            &[EGG],
            "positive-radius",
            r#"{"form":0,"positive":true}"#,
            r#"{"quarters":[[],["1/2"],[],[]]}"#,
        ),
        document(
            &[BALL],
            "positive-radius",
            r#"{"form":0,"positive":true}"#,
            r#"{"depth":2}"#,
        ),
        document(
            &[CIRCLE],
            "irreducible",
            r#"{"form":0}"#,
            r#"{"point":["0","1"],"direction":["1","0"],"prime":5}"#,
        ),
        document(
            &[CIRCLE, ANGLE],
            "identity",
            r#"{"equations":[0],"curve":1}"#,
            r#"{"method":"expansion"}"#,
        ),
        distance("more-than", "9/20", r#"{"depth":4}"#),
    ];
    let mut changes = Changes(88_172_645_463_325_252);
    for round in 0..6_000 {
        let mut text = texts[round % texts.len()].clone();
        for _ in 0..=changes.below(3) {
            let places: Vec<_> = text.char_indices().map(|(place, _)| place).collect();
            let place = places[changes.below(places.len())];
            if changes.below(2) == 0 {
                text.remove(place);
            } else {
                text.insert_str(place, PIECES[changes.below(PIECES.len())]);
            }
        }
        // Only that it returns matters; most texts are no proofs any more.
        let _ = check(&text, true).map(|report| report.to_string());
    }
}

#[test]
fn an_exact_number_is_written_in_the_stated_way() {
    let document = |number: &str| {
        let form = CIRCLE.replace("-1/4", number);
        document(&[&form], "topology", r#"{"n":1}"#, "null")
    };
    let long = "9".repeat(20_000);
    for good in [
        "7",
        "-7",
        "10/100",
        "-1/1",
        &long,
        &format!("-{}/3", &long[3..]),
    ] {
        assert_accepted(&document(good));
    }
    let bad = [
        "",
        "0",
        "-0",
        "00",
        "01",
        "+1",
        "1/0",
        "0/1",
        "1/01",
        "1/-2",
        "1/2/3",
        "/2",
        "1/",
        "-",
        "--1",
        "1.5",
        "1e3",
        " 1",
        "1 ",
        "1_000",
        "0x10",
        "\u{663}",
        "inf",
        "NaN",
        &format!("{long}9"),
    ];
    for bad in bad {
        assert!(check(&document(bad), false).is_err(), "{bad}");
    }
}

#[test]
fn the_limits_are_those_of_the_page() {
    let harmonics = |length: usize| {
        let zeros = vec![r#""0""#; length].join(",");
        let form = format!(r#"{{"kind":"fourier","cos":[{zeros}],"sin":[{zeros}]}}"#);
        check(&document(&[&form], "topology", r#"{"n":1}"#, "null"), false)
    };
    assert!(harmonics(512).is_ok());
    assert!(harmonics(513).is_err());
    let spherical = |degree: u32| {
        let form = format!(r#"{{"kind":"spherical","degree":{degree},"coefficients":[]}}"#);
        check(&document(&[&form], "topology", r#"{"n":1}"#, "null"), false)
    };
    assert!(spherical(128).is_ok());
    assert!(spherical(129).is_err());
    // The product of all degrees plus 1 is 101³ for the cover of a cube, which is too much.
    let large = SPHERE
        .replace("[2,0,0]", "[100,0,0]")
        .replace("[0,2,0]", "[0,100,0]")
        .replace("[0,0,2]", "[0,0,100]");
    let far = r#"{"form":0,"point":["9","0","0"],"relation":"more-than","bound":"1"}"#;
    let text = document(&[&large], "distance", far, r#"{"depth":3}"#);
    assert_eq!(
        report(&text).refused[0].refusal.reason(),
        "a polynomial on a cube has more than 300 000 coefficients"
    );
    // The circle comes as near to the point as the bound, so some cells are never decided.
    let tight = r#"{"form":0,"point":["1","0"],"relation":"more-than","bound":"1/2"}"#;
    let text = document(&[CIRCLE], "distance", tight, r#"{"depth":200}"#);
    assert_eq!(
        report(&text).refused[0].refusal.reason(),
        "a cell of the cover is undecided"
    );
}
