//! Which fields of the rows of a file are x and y: the separator, the names of the columns, and the decimal point.

use crate::rows::{double, fields};

/// The columns of a row, for messages.
pub(super) const COLUMNS: &str = "x,y";

/// Names of the columns of x and of y, without units and in small letters.
const NAMES: [&[&str]; 2] = [
    &["x", "px", "lon", "long", "longitude", "easting", "east"],
    &["y", "py", "lat", "latitude", "northing", "north"],
];
/// Names of columns that are no coordinates in the plane.
const ANGLES: [&str; 6] = ["theta", "angle", "phi", "azimuth", "deg", "degrees"];
const RADII: [&str; 4] = ["r", "radius", "rho", "distance"];

/// How the fields of a row are separated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Separator {
    Comma,
    Semicolon,
    Tab,
    Blanks,
}

/// The layout of the rows of a file.
#[derive(Debug)]
pub(super) struct Layout {
    separator: Separator,
    /// The places of x and y, from 0.
    columns: [usize; 2],
    /// The number of fields of every row, if there is a header; empty ones at the end of a row do not count.
    width: Option<usize>,
}

impl Layout {
    /// The layout that the header, if there is one, and the first row of numbers say.
    ///
    /// # Errors
    /// The message for a header without x and y.
    pub(super) fn of(header: Option<&str>, first: &str) -> Result<Self, String> {
        let separator = Separator::of(first);
        let Some(header) = header else {
            return Ok(Self {
                separator,
                columns: [0, 1],
                width: None,
            });
        };
        let header_separator = Separator::of(header);
        let names: Vec<String> = header_separator.split(header).map(plain_name).collect();
        let place = |known: &[&str]| names.iter().position(|name| known.contains(&name.as_str()));
        let columns = match (place(NAMES[0]), place(NAMES[1])) {
            (Some(x), Some(y)) => [x, y],
            _ if place(&ANGLES).is_some() && place(&RADII).is_some() => {
                return Err(format!(
                    "the columns are angles and radii ({header}); an outline is rows {COLUMNS} of points"
                ));
            }
            _ if names.len() == 2 => [0, 1],
            _ => {
                return Err(format!(
                    "none of the columns {header} is named x, or none y; each row must be {COLUMNS}, or the first row names x and y"
                ));
            }
        };
        Ok(Self {
            separator,
            columns,
            width: Some(names.len()),
        })
    }

    /// The point of a row.
    ///
    /// # Errors
    /// The message for another number of fields, or for a field that is not a number.
    pub(super) fn point(&self, row: &str) -> Result<[f64; 2], String> {
        let mut found = [None; 2];
        let mut count = 0;
        for (place, field) in self.separator.split(row).enumerate() {
            for (slot, column) in found.iter_mut().zip(self.columns) {
                if place == column {
                    *slot = Some(field);
                }
            }
            if !field.is_empty() || place < 2 {
                count = place + 1;
            }
        }
        match (found, self.width.unwrap_or(2)) {
            ([Some(x), Some(y)], width) if count == width => Ok([self.value(x)?, self.value(y)?]),
            (_, width) => {
                let columns = match count {
                    1 => "1 column".into(),
                    n => format!("{n} columns"),
                };
                Err(match width {
                    2 => format!("found {columns}; each row must be {COLUMNS}"),
                    _ => format!("found {columns}; the first row names {width}"),
                })
            }
        }
    }

    fn value(&self, field: &str) -> Result<f64, String> {
        let decimal_comma = self.separator != Separator::Comma && field.contains(',');
        let value = match decimal_comma && !field.contains('.') {
            true => double(&field.replacen(',', ".", 1)),
            false => double(field),
        };
        value.map_err(|message| match message.ends_with("not a number") {
            true => format!("{message}; each row must be {COLUMNS}"),
            false => message,
        })
    }
}

impl Separator {
    /// A semicolon or a tab wherever there is one; blanks between numbers that have decimal commas, or no comma at all.
    fn of(row: &str) -> Self {
        let mut words = row.split_whitespace();
        let has_several = words.clone().count() > 1;
        let mut has_decimal_commas =
            || words.all(|word| double(&word.replacen(',', ".", 1)).is_ok());
        if row.contains(';') {
            Self::Semicolon
        } else if row.contains('\t') {
            Self::Tab
        } else if has_several && (!row.contains(',') || has_decimal_commas()) {
            Self::Blanks
        } else {
            Self::Comma
        }
    }

    fn split(self, row: &str) -> Box<dyn Iterator<Item = &str> + '_> {
        let separated = |by: char| {
            row.split(by).map(|field| {
                let field = field.trim();
                let quoted = field
                    .strip_prefix('"')
                    .and_then(|rest| rest.strip_suffix('"'));
                quoted.map_or(field, str::trim)
            })
        };
        match self {
            Self::Comma => Box::new(fields(row)),
            Self::Semicolon => Box::new(separated(';')),
            Self::Tab => Box::new(separated('\t')),
            Self::Blanks => Box::new(row.split_whitespace()),
        }
    }
}

/// The name of a column in small letters, without its unit: `X (mm)` and `x_mm` are x.
fn plain_name(name: &str) -> String {
    let letters = name.trim().split(|c: char| !c.is_alphanumeric());
    letters
        .map(str::to_lowercase)
        .find(|part| !part.is_empty())
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(header: Option<&str>, row: &str) -> Result<[f64; 2], String> {
        Layout::of(header, row)?.point(row)
    }

    #[test]
    fn separators_and_decimal_commas_are_recognised() {
        for row in [
            "1.5,-2",
            "1.5, -2",
            "1.5;-2",
            "1,5;-2",
            "1,5\t-2",
            "1.5\t-2",
            "1.5 -2",
            "1,5 -2",
            "1.5   -2",
            "\"1.5\",\"-2\"",
            "1.5,-2,",
            "1,5;-2;",
        ] {
            assert_eq!(point(None, row), Ok([1.5, -2.0]), "{row}");
        }
        assert!(
            point(None, "1,5,2")
                .unwrap_err()
                .starts_with("found 3 columns")
        );
        assert!(point(None, "1").unwrap_err().starts_with("found 1 column;"));
    }

    #[test]
    fn columns_are_found_by_their_names() {
        for (header, row) in [
            ("y,x", "2,1"),
            ("lat,lon", "2,1"),
            ("id;X;Y", "7;1;2"),
            (",x,y", "0,1,2"),
            ("x (mm),y (mm)", "1,2"),
            ("x_px\ty_px\tz", "1\t2\t3"),
            ("northing easting", "2 1"),
            ("a,b", "1,2"),
        ] {
            assert_eq!(point(Some(header), row), Ok([1.0, 2.0]), "{header}");
        }
        assert!(
            point(Some("theta,r"), "0,1")
                .unwrap_err()
                .contains("angles and radii")
        );
        assert!(
            point(Some("a,b,c"), "1,2,3")
                .unwrap_err()
                .contains("the first row names x and y")
        );
        assert!(
            point(Some("id,x,y"), "1,2")
                .unwrap_err()
                .contains("the first row names 3")
        );
    }
}
