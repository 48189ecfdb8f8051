//! Plane curves from the literature: components, real singular points and genus; and random curves against another program.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use stellate::factor::factor_plane;
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::poly::PlanePolynomial;
use stellate::shape::Form;
use stellate::topology::{Genus, Topology};

fn polynomial(equation: &str) -> PlanePolynomial {
    match parse_form(equation, "classical.tsv", Numbers::Exact).unwrap() {
        Form::Curve(curve) => curve.polynomial().clone(),
        other => panic!("{equation} is no plane curve: {other:?}"),
    }
}

/// The entries of a list with commas, in alphabetical order.
fn sorted(list: &str) -> Vec<String> {
    let mut entries: Vec<String> = list
        .split(',')
        .filter(|entry| !entry.is_empty())
        .map(str::to_owned)
        .collect();
    entries.sort();
    entries
}

#[test]
fn classical_curves_have_their_components_singular_points_and_genus() {
    let table = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/curves/classical.tsv");
    let table = fs::read_to_string(table).unwrap();
    let rows = table.lines().filter(|line| !line.starts_with('#'));
    let (mut count, mut wrong) = (0, Vec::new());
    for row in rows {
        let [name, equation, components, points, genera] =
            <[&str; 5]>::try_from(row.split('\t').collect::<Vec<_>>()).unwrap();
        count += 1;
        let f = polynomial(equation);
        let found = Topology::of(&f, &Limits::none()).unwrap();
        let kinds = found.components.iter().map(|c| c.kind.name().to_owned());
        let kinds = sorted(&kinds.collect::<Vec<_>>().join(","));
        let singular = found.singular_points.iter();
        let singular = singular.map(|p| p.singularity.kind().name().to_owned());
        let singular = sorted(&singular.collect::<Vec<_>>().join(","));
        let factors = factor_plane(&f, &Limits::none()).unwrap().factors;
        let genus = factors.iter().map(|factor| {
            let genus = Genus::of(&factor.polynomial, &Limits::none()).unwrap();
            genus.map_or("none".into(), |g| format!("g{}x{}", g.genus, g.components))
        });
        let genus = sorted(&genus.collect::<Vec<_>>().join(","));
        if kinds != sorted(components) || singular != sorted(points) || genus != sorted(genera) {
            wrong.push(format!("{name}: {kinds:?} {singular:?} {genus:?}"));
        }
    }
    assert!(count >= 60, "{count} curves");
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn random_curves_have_the_components_that_another_program_finds() {
    let table = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/curves/random.tsv");
    let table = fs::read_to_string(table).unwrap();
    let (mut count, mut wrong) = (0, Vec::new());
    for row in table.lines().filter(|line| !line.starts_with('#')) {
        let (equation, expected) = row.split_once('\t').unwrap();
        count += 1;
        let found = Topology::of(&polynomial(equation), &Limits::none()).unwrap();
        let components = found.components.iter();
        let components = components.map(|c| format!("{}:{}", c.kind.name(), c.contains.len()));
        let components = sorted(&components.collect::<Vec<_>>().join(","));
        if components != sorted(expected) {
            wrong.push(format!("{equation}: {components:?}, not {expected}"));
        }
    }
    assert!(count >= 400, "{count} curves");
    assert_eq!(wrong, Vec::<String>::new());
}
