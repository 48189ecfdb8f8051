//! Which columns of a table are x and y, if the person who reads it says so.

use std::fmt;
use std::str::FromStr;

use crate::error::{Error, Result};
use crate::rows::columns_text;

/// The columns of x and of y in a table, each by its name or by its number from 1.
///
/// ```
/// use stellate::fit::Columns;
/// let columns: Columns = "lon,lat".parse()?;
/// assert_eq!(columns.to_string(), "lon,lat");
/// assert!("2,3".parse::<Columns>().is_ok());
/// assert!("0,1".parse::<Columns>().is_err());
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Columns([Column; 2]);

/// A column of a table, by its name or by its number from 1.
///
/// ```
/// use stellate::fit::Column;
/// assert_eq!("3".parse::<Column>()?.to_string(), "3");
/// assert_eq!("sigma".parse::<Column>()?.to_string(), "sigma");
/// assert!("0".parse::<Column>().is_err());
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column(Which);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Which {
    /// Its place, from 0.
    Place(usize),
    Name(String),
}

/// The places of x and y when a column of weights, but none of these, is given: the first two.
///
/// # Errors
/// The message if the weights are in one of them.
pub(super) fn places_beside(weights: usize) -> std::result::Result<[usize; 2], String> {
    match weights {
        0 | 1 => Err(format!(
            "--weights: column {} has the weights; --columns says which are x and y",
            weights + 1
        )),
        _ => Ok([0, 1]),
    }
}

impl Columns {
    /// The places of x and y, from 0, among columns with these names; without names there are `count` columns.
    ///
    /// # Errors
    /// The message for a column that there is not, or for one column that is both.
    pub(super) fn places(
        &self,
        names: &[&str],
        count: usize,
    ) -> std::result::Result<[usize; 2], String> {
        let [x, y] = [&self.0[0], &self.0[1]].map(|column| column.place(names, count, "--columns"));
        let (x, y) = (x?, y?);
        if x == y {
            let number = x + 1;
            return Err(format!(
                "--columns {self}: x and y are both column {number}"
            ));
        }
        Ok([x, y])
    }
}

impl Column {
    /// Its place, from 0, among columns with these names; `option` is what gave the column.
    ///
    /// # Errors
    /// The message for a column that there is not.
    pub(super) fn place(
        &self,
        names: &[&str],
        count: usize,
        option: &str,
    ) -> std::result::Result<usize, String> {
        let name = match &self.0 {
            Which::Place(place) if *place < count => return Ok(*place),
            Which::Place(place) => {
                let number = place + 1;
                let columns = columns_text(count);
                return Err(format!(
                    "{option}: there is no column {number}; found {columns}"
                ));
            }
            Which::Name(name) => name,
        };
        if names.is_empty() {
            return Err(format!(
                "{option}: no row names a column {name}; without names, columns have numbers from 1"
            ));
        }
        let exact = names.iter().position(|known| known == name);
        let small = name.to_lowercase();
        let similar = || names.iter().position(|known| known.to_lowercase() == small);
        exact.or_else(similar).ok_or_else(|| {
            let all = names.join(",");
            format!("{option}: no column is named {name}; the columns are {all}")
        })
    }
}

impl Column {
    fn read(text: &str) -> Option<Self> {
        let which = match text.trim() {
            "" => return None,
            digits if digits.bytes().all(|b| b.is_ascii_digit()) => {
                let number: usize = digits.parse().ok()?;
                Which::Place(number.checked_sub(1)?)
            }
            name => Which::Name(name.into()),
        };
        Some(Self(which))
    }
}

impl FromStr for Column {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        Self::read(text).ok_or_else(|| {
            Error::Usage(format!(
                "{text:?} is not a column; it is a name or a number from 1, such as 3 or weight"
            ))
        })
    }
}

impl FromStr for Columns {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let wrong = || {
            Error::Usage(format!(
                "{text:?} is not two columns; they are names or numbers from 1 with a comma between them, such as 2,3 or lon,lat"
            ))
        };
        let column = |text: &str| Column::read(text).ok_or_else(wrong);
        let (x, y) = text.split_once(',').ok_or_else(wrong)?;
        if y.contains(',') {
            return Err(wrong());
        }
        Ok(Self([column(x)?, column(y)?]))
    }
}

impl fmt::Display for Columns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y] = &self.0;
        write!(f, "{x},{y}")
    }
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Which::Place(place) => write!(f, "{}", place + 1),
            Which::Name(name) => f.write_str(name),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_names_or_numbers() {
        let places = |text: &str, names: &[&str], count| {
            text.parse::<Columns>()
                .map_err(|error| error.to_string())
                .and_then(|columns| columns.places(names, count))
        };
        let names = ["id", "Lon", "lat"];
        assert_eq!(places("2,3", &[], 3), Ok([1, 2]));
        assert_eq!(places("3, 1", &names, 3), Ok([2, 0]));
        assert_eq!(places("lon,lat", &names, 3), Ok([1, 2]));
        assert_eq!(places("lat,2", &names, 3), Ok([2, 1]));
        for (text, part) in [
            ("4,1", "there is no column 4; found 3 columns"),
            (
                "east,lat",
                "no column is named east; the columns are id,Lon,lat",
            ),
            ("lat,3", "x and y are both column 3"),
            ("0,1", "numbers from 1"),
            ("1", "numbers from 1"),
            ("1,2,3", "numbers from 1"),
            ("99999999999999999999,1", "numbers from 1"),
        ] {
            let message = places(text, &names, 3).unwrap_err();
            assert!(message.contains(part), "{text}: {message}");
        }
        assert!(
            places("lon,lat", &[], 3)
                .unwrap_err()
                .contains("no row names a column lon")
        );
    }
}
