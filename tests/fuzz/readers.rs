//! The readers of text, in this process: any answer but a panic; what is read is written and read back as the same.

use stellate::check::{read_points_csv, read_radii_csv};
use stellate::document::{Format, write_form};
use stellate::exact::{double_literal, exact_literal};
use stellate::fit::{ContourKind, contour_from_reader};
use stellate::language::{Numbers, parse_form};
use stellate::reading::{read_coefficients_csv, read_document, read_fourier_csv, read_text};
use stellate::shape::Form;

use super::draw::Draw;
use super::harness::Outcome;
use super::mutate::{mutated_text, shown};
use super::seeds;

/// Texts are no bytes: what is no UTF-8 is replaced, as the command line refuses it before.
fn text(draw: &mut Draw, seeds: &[Vec<u8>]) -> String {
    let bytes = mutated_text(draw, seeds);
    draw.input = shown(&bytes);
    String::from_utf8_lossy(&bytes).into_owned()
}

fn numbers_as(draw: &mut Draw) -> Numbers {
    if draw.once_in(4) {
        Numbers::F64
    } else {
        Numbers::Exact
    }
}

/// A form that was read is written as JSON and read back.
fn again(form: &Form) {
    let mut out = Vec::new();
    if write_form(form, &[], Format::Json, &mut out).is_err() || out.len() > 1 << 16 {
        return;
    }
    let document = String::from_utf8(out).unwrap();
    let read = |document: &str| {
        let back = read_document(document, "again", Numbers::Exact);
        back.unwrap_or_else(|error| panic!("{error} in {document}"))
    };
    let back = read(&document);
    if matches!(
        form,
        Form::PlaneCurve(_) | Form::SpaceCurve(_) | Form::Patch(_)
    ) {
        // How the half-angle parameter is chosen depends on the spelling, which the second time is that of the document.
        let mut again = Vec::new();
        write_form(&back, &[], Format::Json, &mut again).unwrap();
        assert_eq!(String::from_utf8(again).unwrap(), document);
    } else {
        assert_eq!(back, *form);
    }
}

fn outcome<T, E>(result: &Result<T, E>) -> Outcome {
    // A refusal is an answer, too; how many inputs are accepted is of interest.
    if result.is_ok() {
        Outcome::Checked
    } else {
        Outcome::Open
    }
}

pub(crate) fn language(draw: &mut Draw) -> Outcome {
    let text = text(draw, seeds::formulas());
    let result = parse_form(&text, "<form>", numbers_as(draw));
    if let Ok(form) = &result {
        again(form);
    }
    outcome(&result)
}

pub(crate) fn documents(draw: &mut Draw) -> Outcome {
    let text = text(draw, seeds::documents());
    let result = read_document(&text, "form.json", numbers_as(draw));
    if let Ok(form) = &result {
        again(form);
    }
    let _ = read_text(&text, "form.txt", Numbers::Exact);
    outcome(&result)
}

pub(crate) fn coefficients(draw: &mut Draw) -> Outcome {
    let text = text(draw, seeds::coefficients());
    let numbers = numbers_as(draw);
    let result = read_coefficients_csv(&text, "table.csv", numbers);
    if let Ok(form) = &result {
        again(form);
    }
    let series = read_fourier_csv(&text, "series.csv", numbers);
    if let Ok(radius) = &series {
        again(&Form::Fourier(radius.clone()));
    }
    if series.is_ok() {
        Outcome::Checked
    } else {
        outcome(&result)
    }
}

pub(crate) fn measurements(draw: &mut Draw) -> Outcome {
    let text = text(draw, seeds::rows());
    let in_space = draw.once_in(2);
    let points = read_points_csv(&text, "points.csv", in_space);
    let radii = read_radii_csv(&text, "radii.csv");
    for p in points.iter().flatten() {
        assert!(p.position.iter().all(|x| x.is_finite()) && p.line > 0);
    }
    for r in radii.iter().flatten() {
        assert!(r.theta.is_finite() && r.r.is_finite());
    }
    if points.is_ok() {
        Outcome::Checked
    } else {
        outcome(&radii)
    }
}

pub(crate) fn numbers(draw: &mut Draw) -> Outcome {
    let seeds = [
        "12", "-1/3", "0.1", "1e-5", "-2.50/5", "0x1.8p+1", "+7", "1_000", "３",
    ];
    let seeds = seeds.map(|text| text.as_bytes().to_vec());
    let text = text(draw, &seeds);
    let exact = exact_literal(&text);
    let double = double_literal(&text);
    if let (Ok(exact), Ok(double)) = (&exact, &double) {
        assert_eq!(exact.to_f64(), double.to_f64());
        assert_eq!(exact_literal(&exact.to_string()).as_ref().ok(), Some(exact));
    }
    outcome(&exact)
}

pub(crate) fn outlines(draw: &mut Draw) -> Outcome {
    let bytes = mutated_text(draw, seeds::rows());
    draw.input = shown(&bytes);
    let result = contour_from_reader(bytes.as_slice(), ContourKind::Rows, "outline.csv");
    if let Ok(contour) = &result {
        assert!(contour.len() >= 3);
    }
    outcome(&result)
}
