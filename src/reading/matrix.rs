//! Coefficients as a matrix: c[i][j] is that of x^i y^j.

use super::document::check_exponents;
use super::table::{Table, read_coefficients_csv};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::language::{Numbers, constant_message, implicit_curve, number_at};
use crate::poly::SparsePolynomial;
use crate::shape::Form;

/// Reads the coefficients of a curve or surface as programs write them: rows `i,j,coefficient` or `i,j,k,coefficient`
/// ([`read_coefficients_csv`]), or a matrix of which row i and column j, both counted from 0, have the coefficient of x^i y^j,
/// as CSV of at least two rows or as a list of lists.
///
/// Three or four columns are rows of terms if all but the last one are natural numbers and no term comes twice; otherwise they
/// are a matrix.
///
/// ```
/// use stellate::language::{Numbers, parse_form};
/// use stellate::reading::read_coefficients;
/// let circle = parse_form("x^2 + y^2 = 1", "<form>", Numbers::Exact)?;
/// for text in ["-1,0,1\n0,0,0\n1,0,0\n", "[[-1, 0, 1], [0, 0, 0], [1, 0, 0]]", "2,0,1\n0,2,1\n0,0,-1\n"] {
///     assert_eq!(read_coefficients(text, "circle", Numbers::Exact)?, circle);
/// }
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Data`] with the line if a field is not a number, or all are 0; those of [`read_coefficients_csv`].
pub fn read_coefficients(text: &str, source_name: &str, numbers: Numbers) -> Result<Form> {
    let start = text.trim_start_matches('\u{feff}').trim_start();
    if start.starts_with('[') {
        let rows: Vec<Vec<serde_json::Value>> = serde_json::from_str(start).map_err(|error| {
            Error::data(
                source_name,
                format!("expected a list of lists of numbers, c[i][j]: {error}"),
            )
        })?;
        let rows = rows.iter().enumerate().map(|(i, row)| {
            let fields = row.iter().map(|value| match value {
                serde_json::Value::String(text) => text.clone(),
                other => other.to_string(),
            });
            (format!("{source_name}: [{i}]"), fields.collect())
        });
        return of_rows(&rows.collect::<Vec<_>>(), source_name, numbers);
    }
    let table = Table::read(text, source_name, numbers)?;
    let width = table.width().invariant("a table has rows");
    let is_natural = |field: &String| field.bytes().all(|b| b.is_ascii_digit());
    let are_terms = matches!(width, 3 | 4)
        && table
            .rows
            .iter()
            .all(|(_, row)| row[..width - 1].iter().all(is_natural));
    let is_square = width == table.rows.len();
    let is_row = table.rows.len() < 2;
    match (are_terms || is_row || table.has_header(), is_square) {
        (true, false) => read_coefficients_csv(text, source_name, numbers),
        (true, true) => {
            let terms = read_coefficients_csv(text, source_name, numbers);
            if terms.is_ok() || table.has_header() {
                return terms;
            }
            of_rows(&table.rows, source_name, numbers)
        }
        (false, _) => of_rows(&table.rows, source_name, numbers),
    }
}

fn of_rows(rows: &[(String, Vec<String>)], source_name: &str, numbers: Numbers) -> Result<Form> {
    let mut polynomial = SparsePolynomial::zero();
    for ((place, row), i) in rows.iter().zip(0..) {
        for (field, j) in row.iter().zip(0..) {
            let value: Rational = number_at(place, field, numbers)?;
            let exponents = [i, j, 0];
            check_exponents(place, &exponents)?;
            polynomial.add_term(exponents, value);
        }
    }
    if let Some(value) = polynomial.as_constant() {
        return Err(Error::data(source_name, constant_message(&value)));
    }
    implicit_curve(&polynomial, source_name).map(Form::Curve)
}
