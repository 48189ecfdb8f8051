//! The topology of a plane curve, as text and as JSON.

use std::io::Write;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use serde_json::{Value, json};

use crate::error::Result;
use crate::exact::Rational;
use crate::topology::{
    Asymptote, AtInfinity, Component, ComponentKind, Coordinate, Genus, SingularKind,
    SingularPoint, Singularity, Topology,
};

/// The topology as the field `topology` of a description.
pub(super) fn topology_json(topology: &Topology, digits: u32) -> Value {
    let components = topology.components.iter().map(|component| {
        json!({
            "kind": component.kind.name(),
            "contains": component.contains,
            "extent": component.extent.each_ref().map(|ends| extent_json(ends, digits)),
            "singular_points": component.singular_points,
        })
    });
    let singular = topology.singular_points.iter().map(|point| {
        let s = &point.singularity;
        json!({
            "at": point.at.each_ref().map(|c| coordinate_json(c, digits)),
            "multiplicity": s.multiplicity,
            "kind": s.kind().name(),
            "type": s.arnold(),
            "milnor_number": s.milnor,
            "delta": s.delta,
            "branches": s.branches,
            "real_half_branches": s.real_half_branches,
            "component": point.component,
        })
    });
    let asymptotes = topology.at_infinity.asymptotes.iter().map(|line| {
        json!({
            "slope": slope_json(line, digits),
            "intercept": bounds_json([&line.intercept[0], &line.intercept[1]], digits),
        })
    });
    json!({
        "components": components.collect::<Vec<_>>(),
        "singular_points": singular.collect::<Vec<_>>(),
        "asymptotes": asymptotes.collect::<Vec<_>>(),
    })
}

fn extent_json(ends: &[Option<Coordinate>; 2], digits: u32) -> [String; 2] {
    let [low, high] = ends;
    [
        low.as_ref().map_or_else(
            || "-inf".into(),
            |c| outward(c.bounds()[0], digits, Side::Down),
        ),
        high.as_ref().map_or_else(
            || "inf".into(),
            |c| outward(c.bounds()[1], digits, Side::Up),
        ),
    ]
}

/// A fraction if the number is rational, and otherwise two decimals around it.
fn coordinate_json(c: &Coordinate, digits: u32) -> Value {
    bounds_json(c.bounds(), digits)
}

fn bounds_json(bounds: [&Rational; 2], digits: u32) -> Value {
    let [low, high] = bounds;
    if low == high {
        json!(low.to_string())
    } else {
        json!([
            outward(low, digits, Side::Down),
            outward(high, digits, Side::Up)
        ])
    }
}

fn slope_json(line: &Asymptote, digits: u32) -> Value {
    match &line.slope {
        None => json!("inf"),
        Some(slope) => coordinate_json(&Coordinate::from(slope.clone()), digits),
    }
}

#[derive(Clone, Copy)]
enum Side {
    Down,
    Up,
}

/// The decimal with at most this many digits after the point, and as many more as there are zeros at first, that is next to the number
/// on one side.
fn outward(q: &Rational, digits: u32, side: Side) -> String {
    let zeros = q
        .decimal_exponent()
        .map_or(0, |exponent| (-exponent - 1).max(0));
    let digits = digits.saturating_add(u32::try_from(zeros).unwrap_or(u32::MAX));
    let unit = Rational::whole(Integer::from(10).pow(u64::from(digits)));
    let scaled = q * &unit;
    let whole = match side {
        Side::Down => scaled.floor(),
        Side::Up => -((-scaled).floor()),
    };
    let text = (whole / unit).to_decimal(digits);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A coordinate for people: a short fraction, or ≈ and a decimal.
fn shown(c: &Coordinate, digits: u32) -> String {
    match c.exact() {
        Some(q) => exact_shown(q, digits),
        None => format!("≈ {}", trimmed(c.bounds()[0], digits)),
    }
}

fn exact_shown(q: &Rational, digits: u32) -> String {
    let text = q.to_string();
    if text.trim_start_matches('-').len() <= 2 * digits as usize {
        text
    } else {
        format!("≈ {}", trimmed(q, digits))
    }
}

/// The digits that people are shown unless they ask for more than the usual digits of documents.
const SHOWN: u32 = 12;
const USUAL: u32 = 16;

/// A decimal with this many digits after the point or, for a number that is small or large, with this many digits.
fn trimmed(q: &Rational, digits: u32) -> String {
    let digits = match digits {
        0..=USUAL => digits.min(SHOWN),
        more => more,
    };
    if q.decimal_exponent()
        .is_some_and(|exponent| !(-5..16).contains(&exponent))
    {
        return q.to_significant(digits);
    }
    let text = q.to_decimal(digits);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// Writes the topology and the genus of the only factor as lines.
pub(super) fn write_topology(
    topology: Option<&Topology>,
    genera: &[Option<Genus>],
    digits: u32,
    out: &mut dyn Write,
) -> Result<()> {
    if let [only] = genera {
        writeln!(out, "genus: {}", genus_text(*only))?;
    }
    let Some(topology) = topology else {
        return Ok(());
    };
    writeln!(out, "components: {}", topology.components.len())?;
    for (index, component) in topology.components.iter().enumerate() {
        writeln!(
            out,
            "component {index}: {}",
            component_text(component, digits)
        )?;
    }
    writeln!(
        out,
        "real singular points: {}",
        topology.singular_points.len()
    )?;
    for point in &topology.singular_points {
        writeln!(out, "singular point {}", singular_text(point, digits))?;
    }
    write_asymptotes(&topology.at_infinity, digits, out)
}

fn component_text(component: &Component, digits: u32) -> String {
    let [x, y] = &component.extent;
    if component.kind == ComponentKind::Point
        && let ([Some(x), _], [Some(y), _]) = (x, y)
    {
        return format!(
            "isolated point ({}, {})",
            shown(x, digits),
            shown(y, digits)
        );
    }
    let range = |ends: &[Option<Coordinate>; 2]| {
        let end = |c: &Option<Coordinate>, infinite: &str| {
            c.as_ref()
                .map_or_else(|| infinite.to_owned(), |c| shown(c, digits))
        };
        let brackets = [
            if ends[0].is_some() { "[" } else { "(" },
            if ends[1].is_some() { "]" } else { ")" },
        ];
        format!(
            "{}{}, {}{}",
            brackets[0],
            end(&ends[0], "-inf"),
            end(&ends[1], "inf"),
            brackets[1]
        )
    };
    let mut text = format!(
        "{}, x in {}, y in {}",
        component.kind.name(),
        range(x),
        range(y)
    );
    if !component.contains.is_empty() {
        let inside: Vec<String> = component.contains.iter().map(usize::to_string).collect();
        text.push_str(&format!(", contains {}", inside.join(", ")));
    }
    text
}

fn singular_text(point: &SingularPoint, digits: u32) -> String {
    let [x, y] = &point.at;
    let s = &point.singularity;
    format!(
        "({}, {}): {}, multiplicity {}, on component {}",
        shown(x, digits),
        shown(y, digits),
        kind_text(s),
        s.multiplicity,
        point.component
    )
}

/// The kind in words, with Arnold's symbol or δ.
fn kind_text(s: &Singularity) -> String {
    let symbol = match (s.arnold(), s.delta) {
        (Some(symbol), _) => format!(" ({symbol})"),
        (None, Some(delta)) => format!(" (delta {delta})"),
        (None, None) => String::new(),
    };
    let name = match (s.kind(), s.multiplicity, s.milnor) {
        (SingularKind::Isolated, ..) => "isolated".into(),
        (SingularKind::Higher, 2, Some(4)) => "ramphoid cusp".into(),
        (SingularKind::Higher, 2, Some(5)) if s.real_half_branches == 4 => "oscnode".into(),
        (SingularKind::Higher, m, _) if s.is_ordinary() => format!("ordinary {m}-fold point"),
        (SingularKind::Higher, ..) => "singular point of higher order".into(),
        (kind, ..) => kind.name().to_owned(),
    };
    name + &symbol
}

fn write_asymptotes(at: &AtInfinity, digits: u32, out: &mut dyn Write) -> Result<()> {
    for line in &at.asymptotes {
        let [low, high] = &line.intercept;
        let intercept = if low == high {
            exact_shown(low, digits)
        } else {
            format!("≈ {}", trimmed(low, digits))
        };
        match &line.slope {
            None => writeln!(out, "asymptote: x = {intercept}")?,
            Some(slope) => {
                let slope = Coordinate::from(slope.clone());
                writeln!(
                    out,
                    "asymptote: slope {}, y-intercept {intercept}",
                    shown(&slope, digits)
                )?;
            }
        }
    }
    Ok(())
}

/// What is not decided at infinity, as notes.
pub(super) fn notes(topology: &Topology, digits: u32) -> Vec<String> {
    let undecided = topology.at_infinity.undecided.iter();
    undecided
        .map(|slope| {
            let slope = Coordinate::from(slope.clone());
            format!(
                "the asymptotes of slope {} are not decided: the line at infinity touches the curve there, or the point is singular",
                shown(&slope, digits)
            )
        })
        .collect()
}

/// The genus of a factor, in words.
pub(super) fn genus_text(genus: Option<Genus>) -> String {
    match genus {
        None => "not found".into(),
        Some(g) if g.components == 1 => g.genus.to_string(),
        Some(g) => format!(
            "{} each, of {} conjugate components over the complex numbers",
            g.genus, g.components
        ),
    }
}

/// The note for a factor whose genus was not found.
pub(super) const NO_GENUS: &str = "the genus of a factor was not found: either a limit was reached, or among the primes that were tried there was none modulo which the branches of all its singular points are rational";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn people_are_shown_digits_of_numbers_of_any_size() {
        let q = |text: &str| text.parse::<Rational>().expect("a fraction");
        for (number, digits, shown) in [
            ("1e-31", 16, "≈ 1e-31"),
            ("2/3e31", 16, "≈ 6.66666666667e-32"),
            ("-1e31", 16, "-10000000000000000000000000000000"),
            ("1e31", 16, "10000000000000000000000000000000"),
            ("1e62", 16, "≈ 1e62"),
            ("123456789012345678901/123456789012345678900", 16, "≈ 1"),
            ("1e-5", 16, "1/100000"),
            (
                "20000000000000000000000000000/3",
                20,
                "20000000000000000000000000000/3",
            ),
        ] {
            assert_eq!(exact_shown(&q(number), digits), shown, "{number}");
        }
        assert_eq!(trimmed(&q("2/3"), 16), "0.666666666667");
        assert_eq!(trimmed(&q("2/3"), 20), "0.66666666666666666667");
    }

    #[test]
    fn decimals_are_rounded_outward() {
        let q = |text: &str| text.parse::<Rational>().expect("a fraction");
        assert_eq!(outward(&q("1/3"), 4, Side::Down), "0.3333");
        assert_eq!(outward(&q("1/3"), 4, Side::Up), "0.3334");
        assert_eq!(outward(&q("-1/3"), 4, Side::Down), "-0.3334");
        assert_eq!(outward(&q("-1/3"), 4, Side::Up), "-0.3333");
        assert_eq!(outward(&q("-5/4"), 4, Side::Down), "-1.25");
        // Small numbers keep their digits.
        assert_eq!(outward(&q("2/3e10"), 4, Side::Down), "0.00000000006666");
        assert_eq!(outward(&q("-2/3e10"), 4, Side::Down), "-0.00000000006667");
        assert_eq!(outward(&q("2/3e-10"), 4, Side::Up), "6666666666.6667");
        assert_eq!(outward(&q("100"), 0, Side::Up), "100");
    }
}
