//! Which fields of the rows of a file are x and y: the separator, the names of the columns, and the decimal point.

use smallvec::SmallVec;

use super::OutlineOptions;
use super::columns::places_beside;
use crate::coordinate_names::coordinates_in_first_row;
use crate::exact::exact_literal;
use crate::rows::{Separator, columns_text, double, filled, is_missing};

/// The columns of a row, for messages.
pub(super) const COLUMNS: &str = "x,y";

/// The layout of the rows of a file.
#[derive(Debug)]
pub(super) struct Layout {
    separator: Separator,
    /// The places of x and y, from 0.
    columns: [usize; 2],
    /// The place of z, from 0, if the columns are named as three coordinates.
    height: Option<usize>,
    /// The place of the weight, from 0.
    weight: Option<usize>,
    /// The number of fields of every row: two, or as many as the header or else the first row has. Empty ones at the end of a
    /// row do not count.
    width: usize,
    /// What gave the width, for messages.
    given_by: GivenBy,
}

/// What gave the number of fields of every row.
#[derive(Clone, Copy, Debug)]
enum GivenBy {
    /// A table of two columns.
    Points,
    /// The names in the first row.
    Names,
    /// The first row of numbers.
    FirstRow,
}

impl Layout {
    /// The layout that the columns, if the options give them, the header, if there is one, and the first row of numbers say.
    ///
    /// # Errors
    /// The message for a header without x and y, or for columns that there are not.
    pub(super) fn of(
        header: Option<&str>,
        first: &str,
        options: &OutlineOptions,
    ) -> Result<Self, String> {
        let separator = Separator::of(first);
        let names = header.map(|header| separator.split(header));
        let names: Vec<&str> = names.into_iter().flatten().collect();
        let fields: Vec<&str> = separator.split(first).collect();
        let count = at_least_two(&fields);
        // A title is no row of names.
        let has_names = [count, fields.len()].contains(&names.len());
        let named = || {
            coordinates_in_first_row(&names, separator, has_names).map_err(|message| {
                format!(
                    "{message}; one is to be named x and one y, or --columns says which they are"
                )
            })
        };
        if options.columns.is_some() || options.weights.is_some() {
            let (width, given_by) = match has_names {
                true => (names.len(), GivenBy::Names),
                false => (count, GivenBy::FirstRow),
            };
            let known = if has_names { &names[..] } else { &[] };
            let weights = options.weights.as_ref();
            let weight = weights.map(|column| column.place(known, width, "--weights"));
            let weight = weight.transpose()?;
            let columns = match (&options.columns, weight) {
                (Some(columns), _) => columns.places(known, width)?,
                (None, weight) => match (named()?.filter(|_| has_names), weight) {
                    (Some(places), _) => [places.x, places.y],
                    (None, Some(weight)) => places_beside(weight)?,
                    (None, None) => [0, 1],
                },
            };
            return Ok(Self {
                separator,
                columns,
                height: None,
                weight,
                width,
                given_by,
            });
        }
        match named()? {
            Some(places) => Ok(Self {
                separator,
                columns: [places.x, places.y],
                height: places.z,
                weight: None,
                width: names.len(),
                given_by: GivenBy::Names,
            }),
            // There is no header, or a title in its place.
            None if names.len() <= 2 || names.len() != count => Ok(Self {
                separator,
                columns: [0, 1],
                height: None,
                weight: None,
                width: 2,
                given_by: GivenBy::Points,
            }),
            None => Err(format!(
                "none of the columns {} is named x, or none y; each row must be {COLUMNS}, or the first row names x and y, or --columns says which they are",
                names.join(",")
            )),
        }
    }

    /// The height of a point, if the columns are named as three coordinates and this one has a number.
    pub(super) fn height(&self, row: &str) -> Option<f64> {
        let field = self.separator.split(row).nth(self.height?)?;
        self.value(field).ok()
    }

    /// The point of a row, and its weight if there are weights.
    ///
    /// # Errors
    /// The message for another number of fields, or for a field that is not a number.
    pub(super) fn point(&self, row: &str) -> Result<([f64; 2], Option<f64>), String> {
        let fields: SmallVec<[&str; 4]> = self.separator.split(row).collect();
        let count = at_least_two(&fields);
        match self.columns.map(|column| fields.get(column)) {
            [Some(x), Some(y)] if [count, fields.len()].contains(&self.width) => {
                let weight = self.weight.and_then(|column| fields.get(column));
                let weight = weight.map(|field| self.value(field)).transpose()?;
                Ok(([self.value(x)?, self.value(y)?], weight))
            }
            _ => {
                let (columns, width) = (columns_text(count), self.width);
                Err(match self.given_by {
                    GivenBy::Points if count > 2 => format!(
                        "found {columns}; each row must be {COLUMNS}, or --columns says which they are"
                    ),
                    GivenBy::Points => format!("found {columns}; each row must be {COLUMNS}"),
                    GivenBy::Names => format!("found {columns}; the first row names {width}"),
                    GivenBy::FirstRow => format!("found {columns}; the first row has {width}"),
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
        let value = value.map_err(|message| match message.ends_with("not a number") {
            true if is_missing(field) => {
                format!("{message}, and an outline has no gaps; leave this row out")
            }
            true => format!("{message}; each row must be {COLUMNS}"),
            false => message,
        })?;
        if value == 0.0 && exact_literal(field).is_ok_and(|exact| !exact.is_zero()) {
            return Err(format!("{field} is too small for a double"));
        }
        Ok(value)
    }
}

/// The number of fields, without empty ones behind the second.
fn at_least_two(fields: &[&str]) -> usize {
    filled(fields).max(fields.len().min(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(header: Option<&str>, row: &str) -> Result<[f64; 2], String> {
        let layout = Layout::of(header, row, &OutlineOptions::default())?;
        layout.point(row).map(|(point, _)| point)
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
        for (title, row) in [
            ("butterfly", "1,2"),
            ("an outline of 3 points", "1,2"),
            ("NACA 0012", "1 2"),
            ("NACA 0012 AIRFOIL", "1 2"),
            ("Map of north shore", "1 2"),
            ("points at x of part y", "1 2"),
            ("outline of wing, west, east", "1,2"),
        ] {
            assert_eq!(point(Some(title), row), Ok([1.0, 2.0]), "{title}");
        }
        // A field in quotes may have the separator in it, and the last field may be empty.
        assert_eq!(point(Some("name,x,y"), "\"a, b\",1,2"), Ok([1.0, 2.0]));
        assert_eq!(point(Some("x,y,remark"), "1,2,"), Ok([1.0, 2.0]));
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

    #[test]
    fn columns_can_be_chosen() {
        let chosen = |header: Option<&str>, rows: [&str; 2], columns: &str| {
            let columns = columns
                .parse()
                .map_err(|error: crate::error::Error| error.to_string())?;
            let options = OutlineOptions::default().columns(Some(columns));
            let point = Layout::of(header, rows[0], &options)?.point(rows[1]);
            point.map(|(point, _)| point)
        };
        let same = |header, row, columns| chosen(header, [row, row], columns);
        assert_eq!(same(None, "7;1;2", "2,3"), Ok([1.0, 2.0]));
        assert_eq!(same(None, "7,a,1,2", "4,3"), Ok([2.0, 1.0]));
        assert_eq!(same(Some("x,y,u,v"), "7,8,1,2", "u,v"), Ok([1.0, 2.0]));
        assert_eq!(same(Some("a title"), "7,1,2", "2,3"), Ok([1.0, 2.0]));
        for (header, rows, columns, part) in [
            (
                None,
                ["1,2,3", "1,2"],
                "2,3",
                "found 2 columns; the first row has 3",
            ),
            (None, ["1,2", "1,2"], "2,3", "there is no column 3"),
            (
                Some("a,b,c"),
                ["1,2,3", "1,2,3"],
                "a,d",
                "the columns are a,b,c",
            ),
            (None, ["1,2,3", "1,NA,3"], "1,2", "leave this row out"),
        ] {
            let message = chosen(header, rows, columns).unwrap_err();
            assert!(message.contains(part), "{message}");
        }
    }

    #[test]
    fn weights_have_a_column() {
        let weighted = |header: Option<&str>, row: &str, weights: &str| {
            let weights = weights
                .parse()
                .map_err(|e: crate::error::Error| e.to_string())?;
            let options = OutlineOptions::default().weights(Some(weights));
            Layout::of(header, row, &options)?.point(row)
        };
        let right = Ok(([1.0, 2.0], Some(0.5)));
        assert_eq!(weighted(None, "1,2,0.5", "3"), right);
        assert_eq!(weighted(Some("w,y,x"), "0.5,2,1", "w"), right);
        assert_eq!(weighted(Some("a,b,Weight"), "1,2,0.5", "weight"), right);
        for (header, row, weights, part) in [
            (None, "1,2", "3", "--weights: there is no column 3"),
            (None, "0.5,1,2", "1", "--columns says which are x and y"),
            (Some("x,y,w"), "1,2,0.5", "sigma", "the columns are x,y,w"),
            (None, "1,2,0.5", "w", "--weights: no row names a column w"),
        ] {
            let message = weighted(header, row, weights).unwrap_err();
            assert!(message.contains(part), "{message}");
        }
    }
}
