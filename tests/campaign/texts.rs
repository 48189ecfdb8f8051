//! Reading: tables of doubles, expressions with their exact values, and documents that are written and read back.

use std::fmt::Write as _;

use num_traits::Zero;
use stellate::check::{read_points_csv, read_radii_csv};
use stellate::document::{Format, write_form};
use stellate::language::{Numbers, parse_form};
use stellate::reading::{read_coefficients_csv, read_text};
use stellate::shape::{Form, ImplicitCurve, ImplicitSurface};

use super::draw::Draw;
use super::exact::{Q, num, our};
use super::fourier::any_radius;
use super::harness::Outcome;
use super::numbers::decimal_text;
use super::roots::decimal;
use super::terms::{Terms, plane_terms, random, value_of};

/// Every field of a table is the nearest double, as Rust's own reader says.
pub(crate) fn tables(draw: &mut Draw) -> Outcome {
    let width = 2 + draw.index(2);
    let rows = 1 + draw.index(6);
    let mut text = String::new();
    let mut expected = Vec::new();
    for _ in 0..rows {
        let fields: Vec<String> = (0..width)
            .map(|_| {
                let sign = if draw.once_in(3) { "-" } else { "" };
                format!("{sign}{}", decimal_text(draw))
            })
            .collect();
        let doubles = fields.iter().map(|f| f.parse::<f64>().unwrap());
        let doubles: Vec<f64> = doubles.collect();
        if doubles.iter().any(|d| d.is_infinite()) {
            continue;
        }
        let space = if draw.once_in(3) { " , " } else { "," };
        let _ = writeln!(text, "{}", fields.join(space));
        expected.push(doubles);
    }
    if expected.is_empty() {
        return Outcome::Open;
    }
    draw.input = text.clone();
    let points = read_points_csv(&text, "points.csv", width == 3).unwrap();
    let found = points.iter().map(|p| p.position[..width].to_vec());
    assert_eq!(found.collect::<Vec<_>>(), expected);
    if width == 2 {
        let radii = read_radii_csv(&text, "radii.csv").unwrap();
        let found = radii.iter().map(|r| vec![r.theta, r.r]);
        assert_eq!(found.collect::<Vec<_>>(), expected);
    }
    Outcome::Checked
}

/// A polynomial as text, with its value at a point.
fn expression(draw: &mut Draw, depth: u32, at: &[Q; 2]) -> (String, Q) {
    if depth == 0 {
        return match draw.below(4) {
            0 => ("x".into(), at[0].clone()),
            1 => ("y".into(), at[1].clone()),
            2 => {
                let n = draw.below(30);
                (n.to_string(), Q::from_integer(n.into()))
            }
            _ => {
                let text = format!("{}.{}", draw.below(10), draw.below(1000));
                let value = decimal(&text);
                (text, value)
            }
        };
    }
    let (a, p) = expression(draw, depth - 1, at);
    let (b, q) = {
        let depth = draw.below(u64::from(depth)) as u32;
        expression(draw, depth, at)
    };
    match draw.below(7) {
        0 => (format!("{a} + {b}"), p + q),
        1 => (format!("{a} - ({b})"), p - q),
        2 => (format!("({a})*({b})"), p * q),
        3 => (format!("({a})({b})"), p * q),
        4 => (format!("-({a})"), -p),
        5 => {
            let k = draw.below(4) as i32;
            let sign = if draw.once_in(2) { "^" } else { "**" };
            (
                format!("({a}){sign}{k}"),
                (0..k).fold(Q::from_integer(1.into()), |v, _| v * &p),
            )
        }
        _ => {
            let n = 1 + draw.below(9);
            (format!("({a})/{n}"), p / Q::from_integer(n.into()))
        }
    }
}

/// What is read has the values of what is written: at two points, up to one factor.
pub(crate) fn expressions(draw: &mut Draw) -> Outcome {
    let at = [0; 2].map(|_: i32| [draw.fraction(40, 9), draw.fraction(40, 9)]);
    let state = draw.word();
    let mut found = at.each_ref().map(|at| {
        let mut again = Draw::new("expression", state);
        let depth = 1 + again.below(4) as u32;
        let (left, p) = expression(&mut again, depth, at);
        let (right, q) = expression(&mut again, 1, at);
        (format!("{left} = {right}"), p - q)
    });
    draw.input = format!("stellate describe '{}'", found[0].0);
    let Ok(Form::Curve(curve)) = parse_form(&found[0].0, "<form>", Numbers::Exact) else {
        return Outcome::Open;
    };
    let terms = plane_terms(curve.polynomial());
    let values = at.each_ref().map(|at| value_of(terms.clone(), at));
    let [a, b] = [0, 1].map(|i| std::mem::take(&mut found[i].1));
    assert_eq!(&a * &values[1], &b * &values[0]);
    assert_eq!(a.is_zero(), values[0].is_zero());
    Outcome::Checked
}

fn written(form: &Form, format: Format) -> String {
    let mut out = Vec::new();
    write_form(form, &[], format, &mut out).unwrap();
    String::from_utf8(out).unwrap()
}

/// Text, JSON and CSV are read back as what was written, and the digits are num-rational's.
pub(crate) fn documents(draw: &mut Draw) -> Outcome {
    let bits = if draw.once_in(5) { 3000 } else { 150 };
    let form = match draw.below(3) {
        0 => Form::Fourier(any_radius(draw, 8)),
        1 => {
            let f: Terms<2> = random(draw, 12, bits);
            let denominator = our(&draw.nonzero());
            let polynomial = stellate::poly::PlanePolynomial::from_terms(
                f.to_plane().terms().map(|(e, c)| (e, c / &denominator)),
            );
            Form::Curve(ImplicitCurve::new(polynomial))
        }
        _ => {
            let f: Terms<3> = random(draw, 9, bits);
            let f = f.plus(&Terms::variable(2));
            if f.0.keys().all(|e| e[2] == 0) {
                return Outcome::Open;
            }
            Form::Surface(ImplicitSurface::new(f.to_sparse()))
        }
    };
    let text = written(&form, Format::Text);
    draw.input = text.clone();
    assert_eq!(read_text(&text, "text", Numbers::Exact).unwrap(), form);
    let json = written(&form, Format::Json);
    assert_eq!(read_text(&json, "json", Numbers::Exact).unwrap(), form);
    if let Form::Curve(curve) = &form {
        let csv = written(&form, Format::Csv);
        assert_eq!(
            read_coefficients_csv(&csv, "csv", Numbers::Exact).unwrap(),
            form
        );
        let rows: Vec<String> = csv.lines().skip(1).map(ToString::to_string).collect();
        let terms = curve.polynomial().terms();
        let expected = terms.map(|((i, j), c)| format!("{i},{j},{}", num(&c)));
        assert_eq!(rows, expected.collect::<Vec<_>>());
    }
    Outcome::Checked
}
