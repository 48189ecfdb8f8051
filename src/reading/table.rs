//! Tables of coefficients are read.

use std::collections::BTreeMap;

use super::document::check_exponents;
use crate::coordinate_names::place_of;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::language::{
    MAX_HARMONIC, Numbers, WrittenCenter, check_size, constant_message, implicit, number_at,
    written_center,
};
use crate::poly::SparsePolynomial;
use crate::shape::{EllipticSeries, Form, FourierRadius};

/// Reads the coefficients of a curve, `i,j,coefficient` in rows, or of a surface,
/// `i,j,k,coefficient`. The header is optional, and `value` may stand for `coefficient`; the comment
/// `# center: p/q, p/q` gives the center of a curve.
///
/// ```
/// use stellate::reading::read_coefficients_csv;
/// use stellate::language::{Numbers, parse_form};
/// let circle = read_coefficients_csv("2,0,1\n0,2,1\n0,0,-1\n", "circle.csv", Numbers::Exact)?;
/// assert_eq!(circle, parse_form("x^2 + y^2 = 1", "<form>", Numbers::Exact)?);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Data`] with the line if a row has another number of columns, a field is not a number or
/// not a non-negative integer, or a term comes twice; [`Error::Limit`] beyond the limits of
/// [`crate::language`].
pub fn read_coefficients_csv(text: &str, source_name: &str, numbers: Numbers) -> Result<Form> {
    let table = Table::read(text, source_name, numbers)?;
    let columns = match table.width() {
        Some(width @ (3 | 4)) => width,
        _ => {
            let message = "expected the columns i,j,coefficient or i,j,k,coefficient";
            return Err(Error::data(source_name, message));
        }
    };
    table.check_header(&[&["i", "j", "coefficient"], &["i", "j", "k", "coefficient"]])?;
    let mut polynomial = SparsePolynomial::zero();
    for (place, row) in &table.rows {
        let mut exponents = [0; 3];
        let (powers, coefficient) = row.split_at(columns - 1);
        for (exponent, field) in exponents.iter_mut().zip(powers) {
            *exponent = natural(place, field)?;
        }
        check_exponents(place, &exponents)?;
        let value = number_at(place, coefficient.first().map_or("", |c| c), numbers)?;
        let (is_zero, terms) = (value.is_zero(), polynomial.len());
        polynomial.add_term(exponents, value);
        if !is_zero && polynomial.len() <= terms {
            return Err(Error::data(place, "this term was given before"));
        }
    }
    if let Some(value) = polynomial.as_constant() {
        return Err(Error::data(source_name, constant_message(&value)));
    }
    let center = table.center.map(|center| ((), center));
    implicit(
        polynomial,
        columns == 4,
        center,
        source_name,
        |(), message| Error::data(source_name, message),
    )
}

/// Reads the coefficients of a Fourier radius, `n,cos,sin` in rows. The header is optional; harmonics
/// that are not given are 0; the comment `# center: p/q, p/q` gives the center.
///
/// ```
/// use stellate::reading::read_fourier_csv;
/// use stellate::language::Numbers;
/// let r = read_fourier_csv("n,cos,sin\n0,1,0\n3,1/5,0\n", "r.csv", Numbers::Exact)?;
/// assert_eq!(r.cos(3).to_string(), "1/5");
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Data`] with the line if a row has another number of columns, a field is not a number, or
/// a harmonic comes twice; [`Error::Limit`] beyond [`MAX_HARMONIC`].
pub fn read_fourier_csv(text: &str, source_name: &str, numbers: Numbers) -> Result<FourierRadius> {
    let table = Table::read(text, source_name, numbers)?;
    let [cos, sin] = table.harmonics(source_name, numbers, &[&["n", "cos", "sin"]])?;
    let radius = FourierRadius::new(cos, sin);
    Ok(match table.center {
        Some(center) => {
            let center = center.in_plane();
            radius.with_center(center.map_err(|message| Error::data(source_name, message))?)
        }
        None => radius,
    })
}

/// The header of a table of an elliptic series, as this program writes it, and as other programs name the coefficients.
const ELLIPTIC_HEADERS: [&[&str]; 3] = [
    &["n", "x_cos", "x_sin", "y_cos", "y_sin"],
    &["n", "a", "b", "c", "d"],
    &["n", "an", "bn", "cn", "dn"],
];

/// Whether a table with these column names holds an elliptic series.
pub(crate) fn is_elliptic_header(names: &str) -> bool {
    ELLIPTIC_HEADERS
        .iter()
        .any(|header| header.join(",") == names)
}

/// Reads the coefficients of an elliptic series, `n,x_cos,x_sin,y_cos,y_sin` in rows; the columns may also be called `n,a,b,c,d` or
/// `n,an,bn,cn,dn`. The header is optional; harmonics that are not given are 0.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::reading::read_elliptic_csv;
/// let series = read_elliptic_csv("n,x_cos,x_sin,y_cos,y_sin\n1,3,0,0,2\n", "e.csv", Numbers::Exact)?;
/// assert_eq!(series.x_cos()[1].to_string(), "3");
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// As [`read_fourier_csv`].
pub fn read_elliptic_csv(
    text: &str,
    source_name: &str,
    numbers: Numbers,
) -> Result<EllipticSeries> {
    let table = Table::read(text, source_name, numbers)?;
    let lists = table.harmonics(source_name, numbers, &ELLIPTIC_HEADERS)?;
    Ok(EllipticSeries::new(lists))
}

/// The rows of a CSV file, all of the same length, each with its line.
pub(crate) struct Table {
    header: Option<(String, Vec<String>)>,
    pub(crate) rows: Vec<(String, Vec<String>)>,
    /// The line of each row, counted from 1.
    pub(crate) lines: Vec<usize>,
    center: Option<WrittenCenter>,
}

impl Table {
    pub(crate) fn read(text: &str, source_name: &str, numbers: Numbers) -> Result<Self> {
        check_size(text, source_name)?;
        let text = text.trim_start_matches('\u{feff}');
        let mut reader = ::csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .trim(::csv::Trim::All)
            .from_reader(text.as_bytes());
        let mut table = Table {
            header: None,
            rows: Vec::new(),
            lines: Vec::new(),
            center: read_center(text, source_name, numbers)?,
        };
        let mut lines = Lines {
            text,
            at: 0,
            before: 0,
        };
        for (n, record) in reader.records().enumerate() {
            let record = record.map_err(|error| Error::data(source_name, error.to_string()))?;
            let line = lines.of_record(record.position().map_or(0, ::csv::Position::byte));
            let place = format!("{source_name}, line {line}");
            let row: Vec<String> = record.iter().map(str::to_owned).collect();
            if let Some(width) = table.width()
                && width != row.len()
            {
                let message = format!("expected {width} columns, found {}", row.len());
                return Err(Error::data(place, message));
            }
            let is_header = n == 0
                && row
                    .iter()
                    .any(|field| field.starts_with(char::is_alphabetic));
            if is_header {
                table.header = Some((place, row));
            } else {
                table.rows.push((place, row));
                table.lines.push(line);
            }
        }
        if table.rows.is_empty() {
            return Err(Error::data(source_name, "there are no rows"));
        }
        Ok(table)
    }

    pub(crate) fn width(&self) -> Option<usize> {
        let header = self.header.as_ref().map(|(_, row)| row.len());
        header.or_else(|| self.rows.first().map(|(_, row)| row.len()))
    }

    /// The coefficients of harmonics, from rows of the number n and then a cosine and a sine in turn. `headers` are the possible
    /// names of the columns.
    fn harmonics<const K: usize>(
        &self,
        source_name: &str,
        numbers: Numbers,
        headers: &[&[&str]],
    ) -> Result<[Vec<Rational>; K]> {
        if self.width() != Some(K + 1) {
            let names = headers
                .first()
                .map_or(String::new(), |names| names.join(","));
            return Err(Error::data(
                source_name,
                format!("expected the columns {names}"),
            ));
        }
        self.check_header(headers)?;
        let mut harmonics: BTreeMap<usize, [Rational; K]> = BTreeMap::new();
        for (place, row) in &self.rows {
            let field = |i: usize| row.get(i).map_or("", String::as_str);
            let n = natural(place, field(0))?;
            if n > MAX_HARMONIC {
                return Err(Error::limit(format!(
                    "{place}: a harmonic beyond {MAX_HARMONIC}"
                )));
            }
            let mut values = std::array::from_fn(|_| Rational::zero());
            for (i, value) in values.iter_mut().enumerate() {
                *value = number_at(place, field(i + 1), numbers)?;
                if n == 0 && i % 2 == 1 && !value.is_zero() {
                    return Err(Error::data(place, "the sine of harmonic 0 is 0"));
                }
            }
            if harmonics.insert(n as usize, values).is_some() {
                return Err(Error::data(place, "this harmonic was given before"));
            }
        }
        let len = harmonics.keys().next_back().map_or(0, |&n| n + 1);
        let mut lists: [Vec<Rational>; K] = std::array::from_fn(|_| vec![Rational::zero(); len]);
        for (n, values) in harmonics {
            for (list, value) in lists.iter_mut().zip(values) {
                list[n] = value;
            }
        }
        Ok(lists)
    }

    /// The places of these columns: where the header names them, else in this order, in a table that has no others.
    ///
    /// # Errors
    /// [`Error::Data`] for a table of other columns, or with the column `unwanted`: its rows have one coordinate more.
    pub(crate) fn places(
        &self,
        source_name: &str,
        wanted: &[&str],
        unwanted: Option<&str>,
    ) -> Result<Vec<usize>> {
        if let Some((line, names)) = &self.header {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            let place = |wanted: &str| {
                place_of(&names, wanted).map_err(|message| Error::data(line, message))
            };
            let places: Result<Option<_>> = wanted.iter().map(|name| place(name)).collect();
            let unwanted = unwanted.map(|name| place(name).map(|found| found.map(|_| name)));
            match (places?, unwanted.transpose()?.flatten()) {
                (Some(places), None) => return Ok(places),
                (Some(_), Some(name)) => {
                    let columns = wanted.join(",");
                    let message = format!("expected the columns {columns} without {name}");
                    return Err(Error::data(line, message));
                }
                (None, _) => {}
            }
        }
        if self.width() == Some(wanted.len()) && !self.has_header() {
            return Ok((0..wanted.len()).collect());
        }
        let columns = wanted.join(",");
        let message =
            format!("expected the columns {columns}, or a first row that names them among others");
        let place = self.header.as_ref().map_or(source_name, |(place, _)| place);
        Err(Error::data(place, message))
    }

    pub(crate) fn has_header(&self) -> bool {
        self.header.is_some()
    }

    /// Checks the names of the columns, if the table has a header.
    pub(crate) fn check_header(&self, expected: &[&[&str]]) -> Result<()> {
        let Some((place, names)) = &self.header else {
            return Ok(());
        };
        let fits = |wanted: &[&str]| {
            wanted.len() == names.len()
                && wanted.iter().zip(names).all(|(w, name)| {
                    name.eq_ignore_ascii_case(w)
                        || (*w == "coefficient" && name.eq_ignore_ascii_case("value"))
                })
        };
        if expected.iter().any(|wanted| fits(wanted)) {
            return Ok(());
        }
        let wanted: Vec<String> = expected.iter().map(|names| names.join(",")).collect();
        let message = format!("expected the columns {}", wanted.join(" or "));
        Err(Error::data(place, message))
    }
}

/// Counts lines as an editor does. The counter of the CSV reader leaves out the comments and blank lines before a record.
struct Lines<'a> {
    text: &'a str,
    at: usize,
    before: usize,
}

impl Lines<'_> {
    /// The line, counted from 1, of the record that the reader found at this byte. The records must come in order.
    fn of_record(&mut self, byte: u64) -> usize {
        let byte = usize::try_from(byte).unwrap_or(usize::MAX);
        let skipped = self.text.get(self.at..byte).unwrap_or("");
        self.before += skipped.matches('\n').count();
        self.at += skipped.len();
        while let Some((line, _)) = self.text[self.at..].split_once('\n') {
            if !line.trim_end_matches('\r').is_empty() && !line.starts_with('#') {
                break;
            }
            self.before += 1;
            self.at += line.len() + 1;
        }
        self.before + 1
    }
}

/// The point that the comment `# center: …` of a table gives.
pub(super) fn read_center(
    text: &str,
    source_name: &str,
    numbers: Numbers,
) -> Result<Option<WrittenCenter>> {
    let mut center = None;
    for (n, line) in text.lines().enumerate() {
        let comment = line.strip_prefix('#').map(str::trim_start);
        if let Some(point) = comment.and_then(|c| c.strip_prefix("center:")) {
            let place = || format!("{source_name}, line {}", n + 1);
            let point = written_center(point, numbers);
            let point = point.map_err(|message| Error::data(place(), message))?;
            if center.replace(point).is_some() {
                return Err(Error::data(place(), "a second center"));
            }
        }
    }
    Ok(center)
}

fn natural(place: &str, field: &str) -> Result<u32> {
    let digits = !field.is_empty() && field.bytes().all(|b| b.is_ascii_digit());
    let value = digits.then(|| field.parse().unwrap_or(u32::MAX));
    let message = || format!("expected a non-negative integer, found `{field}`");
    value.ok_or_else(|| Error::data(place, message()))
}
