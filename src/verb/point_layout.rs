//! Which fields of the rows of a table are the coordinates of points, and which are carried along.

use std::borrow::Cow;

use smallvec::SmallVec;

use crate::coordinate_names::{coordinates_among, coordinates_in_first_row};
use crate::error::Invariant;
use crate::exact::{Rational, double_literal, exact_literal};
use crate::language::Numbers;
use crate::rows::{Separator, columns_text, double, filled};

/// The layout of the rows of a table of points.
#[derive(Clone, Debug)]
pub(super) struct PointLayout {
    separator: Separator,
    /// The places of x, y and z, from 0; z is not used in the plane.
    places: [usize; 3],
    dimension: usize,
    /// The number of fields of every row.
    width: usize,
    /// Whether the first row gave the width by naming columns.
    is_named: bool,
    /// The places and the names of the other columns.
    others: Vec<(usize, String)>,
}

impl PointLayout {
    /// Rows of so many coordinates with commas between them.
    pub(super) fn plain(dimension: usize) -> Self {
        Self {
            separator: Separator::Comma,
            places: [0, 1, 2],
            dimension,
            width: dimension,
            is_named: false,
            others: Vec::new(),
        }
    }

    /// The layout that the header, if there is one, and the first row of numbers say. A header that names coordinates says which
    /// columns these are, and whether there is z; one that says nothing of coordinates is a title.
    ///
    /// # Errors
    /// The message for rows of which the coordinates are not known.
    pub(super) fn of(header: Option<&str>, first: &str) -> Result<Self, String> {
        let separator = Separator::of(first);
        let fields: Vec<&str> = separator.split(first).collect();
        let count = filled(&fields);
        let names: Vec<&str> = header
            .map(|h| separator.split(h).collect())
            .unwrap_or_default();
        let has_names = names.len() > 1 && [count, fields.len()].contains(&names.len());
        let named = coordinates_in_first_row(&names, separator, has_names).map_err(|message| {
            format!("{message}; one is to be named x, one y and, in space, one z")
        })?;
        if let Some(found) = named {
            let places = [found.x, found.y, found.z.unwrap_or(0)];
            let used = if found.z.is_some() { 3 } else { 2 };
            let is_other = |k: &usize| !places[..used].contains(k);
            let others = (0..names.len()).filter(is_other);
            return Ok(Self {
                separator,
                places,
                dimension: used,
                width: names.len(),
                is_named: names.len() > used || !places[..used].is_sorted(),
                others: others.map(|k| (k, names[k].to_owned())).collect(),
            });
        }
        // A header that names fewer columns than there are does not say which of them are the coordinates.
        if (2..count).contains(&names.len()) && !matches!(coordinates_among(&names), Ok(None)) {
            return Err(found_beside_names(count, names.len()));
        }
        match count {
            2 | 3 => Ok(Self {
                separator,
                ..Self::plain(count)
            }),
            _ => Err(format!(
                "found {}; each row must be x,y,z, or x,y in the plane, or the first row names x, y and z among other columns",
                columns_text(count)
            )),
        }
    }

    /// The number of coordinates, 2 or 3.
    pub(super) fn dimension(&self) -> usize {
        self.dimension
    }

    /// The names of the columns that are no coordinates.
    pub(super) fn other_names(&self) -> impl Iterator<Item = &str> {
        self.others.iter().map(|(_, name)| name.as_str())
    }

    /// The columns of a row, in messages.
    pub(super) fn expected(&self) -> &'static str {
        match (self.is_named, self.dimension) {
            (true, _) => "as the first row names them",
            (false, 2) => "x,y",
            (false, _) => "x,y,z",
        }
    }

    /// The fields of a row.
    ///
    /// # Errors
    /// The message for another number of fields, or for a coordinate that is no number.
    pub(super) fn row<'a>(&self, text: &'a str, numbers: Numbers) -> Result<Row<'a>, String> {
        let fields: SmallVec<[&str; 4]> = self.separator.split(text).collect();
        let count = filled(&fields);
        if ![count, fields.len()].contains(&self.width) {
            return Err(match self.is_named {
                true => found_beside_names(count, self.width),
                false => {
                    let found = columns_text(count);
                    format!("found {found}; each row must be {}", self.expected())
                }
            });
        }
        let mut row = Row {
            fields: [Cow::Borrowed(""), Cow::Borrowed(""), Cow::Borrowed("")],
            others: self
                .others
                .iter()
                .map(|(k, _)| plain_text(fields[*k]))
                .collect(),
            dimension: self.dimension,
            numbers,
            near: [0.0; 3],
        };
        for (i, place) in self.places.iter().enumerate().take(self.dimension) {
            let field = self.with_point(fields[*place]);
            row.near[i] = coordinate(&field)
                .map_err(|m| format!("{m}; each row must be {}", self.expected()))?;
            row.fields[i] = field;
        }
        Ok(row)
    }

    /// A field with a decimal point in place of a decimal comma, which there can be if commas do not separate the fields.
    fn with_point<'a>(&self, field: &'a str) -> Cow<'a, str> {
        let has_comma = self.separator != Separator::Comma && field.contains(',');
        if has_comma && !field.contains('.') {
            return Cow::Owned(field.replacen(',', ".", 1));
        }
        Cow::Borrowed(field)
    }
}

/// The message for a row with so many columns below a header that names another number of them.
fn found_beside_names(count: usize, named: usize) -> String {
    format!("found {}; the first row names {named}", columns_text(count))
}

/// The text of a field in which quotation marks are doubled.
fn plain_text(field: &str) -> Cow<'_, str> {
    match field.contains("\"\"") {
        true => Cow::Owned(field.replace("\"\"", "\"")),
        false => Cow::Borrowed(field),
    }
}

/// A row with the texts of its fields.
pub(super) struct Row<'a> {
    /// The coordinates as they are written, with a decimal point.
    pub(super) fields: [Cow<'a, str>; 3],
    /// The fields of the other columns.
    pub(super) others: Vec<Cow<'a, str>>,
    dimension: usize,
    numbers: Numbers,
    /// The nearest doubles of the coordinates; z is 0 in the plane.
    pub(super) near: [f64; 3],
}

impl Row<'_> {
    /// The exact coordinates: those that are written, or those of the doubles.
    pub(super) fn exactly(&self) -> [Rational; 3] {
        std::array::from_fn(|i| {
            let read = match self.numbers {
                _ if i >= self.dimension => return Rational::zero(),
                Numbers::Exact => exact_literal(&self.fields[i]),
                Numbers::F64 => double_literal(&self.fields[i]),
            };
            read.invariant("a field that was read as a double is a number")
        })
    }
}

/// The double nearest to a coordinate, or the reason why its text is refused.
pub(super) fn coordinate(field: &str) -> Result<f64, String> {
    let value = double(field)?;
    if may_be_out_of_reach(field, value) && exact_literal(field).is_err() {
        return Err(format!(
            "{field} has an exponent that is too large to be read exactly"
        ));
    }
    Ok(value)
}

/// Whether the text of this double may have an exponent that is too large to be read exactly. A short text is within the limits
/// if its double is normal.
fn may_be_out_of_reach(field: &str, value: f64) -> bool {
    const SHORT: usize = 100;
    field.len() > SHORT || !value.is_normal() && field.contains(['e', 'E', 'p', 'P'])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(header: Option<&str>, row: &str) -> Result<(Vec<f64>, Vec<String>), String> {
        let layout = PointLayout::of(header, row)?;
        let row = layout.row(row, Numbers::Exact)?;
        let others = row.others.iter().map(|o| o.to_string()).collect();
        Ok((row.near[..layout.dimension()].to_vec(), others))
    }

    #[test]
    fn coordinates_are_found_by_their_names() {
        let none: Vec<String> = Vec::new();
        for (header, row, near, others) in [
            (Some("z,y,x"), "3,2,1", vec![1.0, 2.0, 3.0], none.clone()),
            (
                Some("id,x,y,z"),
                "a 7,1,2,3",
                vec![1.0, 2.0, 3.0],
                vec!["a 7".into()],
            ),
            (
                Some("X (mm);Y (mm);remark"),
                "1,5;2;ok",
                vec![1.5, 2.0],
                vec!["ok".into()],
            ),
            (Some("lengths"), "1 2 3", vec![1.0, 2.0, 3.0], none.clone()),
            (Some("lat,lon"), "2,1", vec![1.0, 2.0], none.clone()),
            (
                Some("x_nom,y_nom,x,y"),
                "5,6,1,2",
                vec![1.0, 2.0],
                vec!["5".into(), "6".into()],
            ),
            (None, "5;0;0", vec![5.0, 0.0, 0.0], none.clone()),
            (None, "5\t0\t0", vec![5.0, 0.0, 0.0], none.clone()),
            (None, "1,2,", vec![1.0, 2.0], none),
        ] {
            assert_eq!(read(header, row), Ok((near, others)), "{header:?} {row}");
        }
        for (header, row, part) in [
            (None, "1,2,3,4", "found 4 columns; each row must be x,y,z"),
            (None, "1", "found 1 column"),
            (
                Some("x,y,z"),
                "1,2",
                "found 2 columns; each row must be x,y,z",
            ),
            (Some("x,y,z"), "1,2,b", "\"b\" is not a number"),
            (
                Some("x,y"),
                "1,5,0",
                "found 3 columns; the first row names 2",
            ),
            (
                Some("y x"),
                "1 1.5 0",
                "found 3 columns; the first row names 2",
            ),
            (Some("theta,r"), "1,2", "angles and radii"),
            (
                Some("x_nom,y_nom,x_meas,y_meas"),
                "1,2,3,4",
                "one is to be named x",
            ),
        ] {
            let message = read(header, row).unwrap_err();
            assert!(message.contains(part), "{message}");
        }
    }
}
