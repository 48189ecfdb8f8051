//! The digits that the paper's algorithm keeps in doubles for growing N, as text, JSON and CSV.

use std::io::Write;

use serde::Serialize;

use super::check::tenths;
use super::json::{Number, write_value};
use super::{Format, Kind, SCHEMA};
use crate::check::{DigitsKept, Rung};
use crate::error::Result;

#[derive(Serialize)]
struct LadderDocument {
    schema: &'static str,
    kind: &'static str,
    what: &'static str,
    rungs: Vec<RungEntry>,
}

#[derive(Serialize)]
struct RungEntry {
    harmonics: usize,
    degree: usize,
    coefficient_digits: Kept,
    digits_near_the_curve: Kept,
    radius_digits: Kept,
    sign_distance: Option<Number>,
}

#[derive(Serialize)]
struct Kept {
    worst: Number,
    median: Number,
}

/// Writes the digits that doubles keep for growing N, as text, as JSON of kind `check` with `what` = `self`, or as CSV.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_ladder(rungs: &[Rung], format: Format, out: &mut dyn Write) -> Result<()> {
    match format {
        Format::Text => write_text(rungs, out),
        Format::Csv => write_table(rungs, out),
        Format::Json => {
            let document = LadderDocument {
                schema: SCHEMA,
                kind: "check",
                what: "self",
                rungs: rungs.iter().map(entry).collect(),
            };
            write_value(&document, out)?;
            Ok(writeln!(out)?)
        }
        _ => Err(Kind::Check.refused(format)),
    }
}

fn degree(rung: &Rung) -> usize {
    2 * (rung.harmonics + 1)
}

fn entry(rung: &Rung) -> RungEntry {
    let kept = |k: DigitsKept| Kept {
        worst: Number(k.worst),
        median: Number(k.median),
    };
    RungEntry {
        harmonics: rung.harmonics,
        degree: degree(rung),
        coefficient_digits: kept(rung.coefficients),
        digits_near_the_curve: kept(rung.near),
        radius_digits: kept(rung.radii),
        sign_distance: rung.sign_distance.map(Number),
    }
}

fn write_text(rungs: &[Rung], out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "Theorem 2 in doubles beside exact arithmetic: correct digits, ≈ worst / median"
    )?;
    writeln!(
        out,
        "{:>4} {:>6}  {:>13}  {:>13}  {:>13}  {:>15}",
        "N", "degree", "coefficients", "radii", "F 1 % outside", "sign right from"
    )?;
    for rung in rungs {
        let kept = |k: DigitsKept| format!("{} / {}", tenths(k.worst), tenths(k.median));
        writeln!(
            out,
            "{:>4} {:>6}  {:>13}  {:>13}  {:>13}  {:>15}",
            rung.harmonics,
            degree(rung),
            kept(rung.coefficients),
            kept(rung.radii),
            kept(rung.near),
            sign_distance(rung)
        )?;
    }
    Ok(())
}

/// The distance as text, such as `1e-8`.
fn sign_distance(rung: &Rung) -> String {
    rung.sign_distance
        .map_or_else(|| "nowhere".into(), |d| format!("{d:e}"))
}

fn write_table(rungs: &[Rung], out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "harmonics,degree,coefficients_worst,coefficients_median,radii_worst,radii_median,near_worst,near_median,sign_distance"
    )?;
    for rung in rungs {
        let kept = |k: DigitsKept| format!("{:.2},{:.2}", k.worst, k.median);
        writeln!(
            out,
            "{},{},{},{},{},{}",
            rung.harmonics,
            degree(rung),
            kept(rung.coefficients),
            kept(rung.radii),
            kept(rung.near),
            sign_distance(rung)
        )?;
    }
    Ok(())
}
