//! The fits of many outlines as one table.

use std::io::Write;

use super::{Format, Kind};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::verb::{FittedOutline, OutlineSeries};

/// The columns before the coefficients.
const COLUMNS: [&str; 13] = [
    "file",
    "blob",
    "model",
    "harmonics",
    "degree",
    "center_x",
    "center_y",
    "max_radial_error",
    "distance_low",
    "distance_high",
    "overlap",
    "hidden_share",
    "star_shaped",
];

/// Writes one row for each outline, as CSV: file, blob, model, harmonics, degree, center_x, center_y, max_radial_error,
/// distance_low, distance_high, overlap, hidden_share, star_shaped, and then the coefficients by harmonics, `cos_0,sin_0,cos_1,…`
/// of radii or `x_cos_0,x_sin_0,y_cos_0,y_sin_0,x_cos_1,…` of elliptic series. All numbers are the nearest doubles. What a model
/// does not have, and harmonics beyond those of a row, are empty fields.
///
/// # Errors
/// Those of `out`; [`Error::Usage`] if the models differ.
pub fn write_fit_table(rows: &[FittedOutline], out: &mut dyn Write) -> Result<()> {
    Kind::FitTable.check(Format::Csv)?;
    let names: &[&str] = match rows.first().map(|row| &row.fit.series) {
        Some(OutlineSeries::Elliptic(_)) => &["x_cos", "x_sin", "y_cos", "y_sin"],
        _ => &["cos", "sin"],
    };
    let most = rows
        .iter()
        .map(|row| lists(row)[0].len())
        .max()
        .unwrap_or(0);
    let mut table = ::csv::Writer::from_writer(out);
    let coefficients = (0..most).flat_map(|n| names.iter().map(move |name| format!("{name}_{n}")));
    let header = COLUMNS.iter().map(|&name| name.to_owned());
    table
        .write_record(header.chain(coefficients))
        .map_err(failed)?;
    for row in rows {
        let lists = lists(row);
        if lists.len() != names.len() {
            return Err(Error::Usage("a table has fits of one model".into()));
        }
        let coefficients = (0..most).flat_map(|n| {
            let values = lists.iter().map(move |list| list.get(n));
            values.map(|value| value.map_or(String::new(), |c| c.to_f64().to_string()))
        });
        let fields = fields(row).into_iter().chain(coefficients);
        table.write_record(fields).map_err(failed)?;
    }
    table.flush()?;
    Ok(())
}

/// The lists of coefficients.
fn lists(row: &FittedOutline) -> Vec<&[Rational]> {
    match &row.fit.series {
        OutlineSeries::Radius(fit) => vec![fit.radius.cosines(), fit.radius.sines()],
        OutlineSeries::Elliptic(fit) => fit.series.lists().iter().map(Vec::as_slice).collect(),
    }
}

/// The fields of [`COLUMNS`].
fn fields(row: &FittedOutline) -> [String; 13] {
    let number = |value: Option<f64>| value.map_or(String::new(), |v| v.to_string());
    let series = &row.fit.series;
    let harmonics = lists(row)[0].len() - 1;
    let (model, degree, center) = match series {
        OutlineSeries::Radius(fit) => {
            let center = fit.radius.center().each_ref().map(|c| Some(c.to_f64()));
            ("radius", 2 * harmonics + 2, center)
        }
        OutlineSeries::Elliptic(_) => ("elliptic", 2 * harmonics, [None, None]),
    };
    let radial = row.fit.report.radial.as_ref();
    let distances = row.fit.report.distances.as_ref();
    let star_shaped = radial.and_then(|r| r.star_shaped);
    [
        row.file.clone(),
        row.blob.to_string(),
        model.into(),
        harmonics.to_string(),
        degree.to_string(),
        number(center[0]),
        number(center[1]),
        number(radial.map(|r| r.max_error)),
        number(distances.map(|d| d.hausdorff.low)),
        number(distances.map(|d| d.hausdorff.high)),
        number(distances.map(|d| d.overlap)),
        number(radial.and_then(|r| r.outline).map(|seen| seen.hidden_share)),
        star_shaped.map_or(String::new(), |yes| yes.to_string()),
    ]
}

fn failed(error: ::csv::Error) -> Error {
    Error::from(std::io::Error::from(error))
}
