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

/// Arnold's symbols of simple triple points, and none for points that are not simple; the same in other coordinates.
#[test]
fn triple_points_have_their_symbols() {
    for (equation, symbol) in [
        ("x^2*y + y^9", Some("D10")),
        ("x*y^2 + x^4", Some("D5")),
        ("x^2*y + y^3", Some("D4")),
        ("x^2*y + y^6", Some("D7")),
        ("y^3 + x^4", Some("E6")),
        ("y^3 - y*x^3", Some("E7")),
        ("(y^2 - x^3)*(y - x^2)", Some("E7")),
        ("y^3 + x^5", Some("E8")),
        ("y*(y - x^2)*(y - 2*x^2)", None),
        ("y^3 + x^6", None),
        ("y^3 + y*x^5", None),
        ("y^3 + x^2*y^2 + x^7", None),
        ("y^3 + x^2*y^2 + x^9", None),
    ] {
        for [x, y] in [["x", "y"], ["(x+2*y)", "(y-x)"], ["(x-1)", "(y+x-3)"]] {
            let text: String = equation
                .chars()
                .map(|c| match c {
                    'x' => x.to_owned(),
                    'y' => y.to_owned(),
                    c => c.to_string(),
                })
                .collect();
            let topology = Topology::of(&polynomial(&text), &Limits::none()).unwrap();
            let point = topology
                .singular_points
                .iter()
                .find(|p| p.singularity.multiplicity == 3);
            assert_eq!(
                point.unwrap().singularity.arnold().as_deref(),
                symbol,
                "{text}"
            );
        }
    }
}

/// The origin of the equation of a radius is the singular point that the equation has there.
#[test]
fn the_origin_of_a_radius_is_that_of_its_equation() {
    use stellate::exact::Rational;
    use stellate::verb::{self, Given, ImplicitizeOptions, Work};
    for text in [
        "r = 1 + cos(t)",
        "r = 1 + 2*cos(t)",
        "r = 1/2 + 1/3*cos(t)",
        "r = cos(3*t)",
        "r = cos(2*t)",
        "r = cos(t) + cos(3*t)",
        "r = 1 + cos(2*t)",
        "r = 1 - cos(2*t) + sin(t)",
        "r = 1 + sin(t) + cos(2*t)",
        "r = 3/2 + 2*cos(t) + 1/2*cos(2*t)",
        "r = cos(t) + cos(2*t)",
        "r = 2 + cos(2*t)",
    ] {
        let given = || Given::read(text, Numbers::Exact).unwrap();
        let verb::Content::Exact(Form::Fourier(radius)) = given().into_content() else {
            panic!("{text} is a radius");
        };
        let found = verb::implicitize(given(), &ImplicitizeOptions::default(), &Work::default());
        let Form::Curve(curve) = found.unwrap().form else {
            panic!("{text} is a plane curve");
        };
        let multiplicity = curve.polynomial().lowest_degree().unwrap();
        let of_radius = Topology::of_radius(&radius, multiplicity, &Limits::none()).unwrap();
        let of_equation = Topology::of(curve.polynomial(), &Limits::none()).unwrap();
        let origin = |topology: &Topology| {
            let mut points = topology.singular_points.iter();
            let at_origin = points.find(|p| {
                p.at.iter()
                    .all(|c| c.exact().is_some_and(Rational::is_zero))
            });
            at_origin.map(|p| p.singularity.clone())
        };
        let expected = origin(&of_equation);
        assert!(expected.is_some(), "{text}");
        assert_eq!(origin(&of_radius), expected, "{text}");
    }
}
