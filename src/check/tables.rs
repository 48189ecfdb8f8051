//! Reads tables of a float program: points and radii, in which every number is a double, bit for bit.

use super::{GivenPoint, GivenRadius, GivenSpaceRadius};
use crate::error::{Error, Result};
use crate::language::{Numbers, number_at};
use crate::reading::Table;

/// Reads points `x,y` or `x,y,z` in rows. A header is optional, and can name these columns among others. A decimal stands for the
/// nearest double, and `0x1.8p+1` is taken bit for bit.
///
/// ```
/// use stellate::check::read_points_csv;
/// let points = read_points_csv("x,y\n# the first one\n0.1,0x1.8p+1\n", "points.csv", false)?;
/// assert_eq!((points[0].line, points[0].position), (3, [0.1, 3.0, 0.0]));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Data`] with the line if there are other columns than there should be in the plane or `in_space`, or a field is not a
/// finite number.
pub fn read_points_csv(text: &str, source_name: &str, in_space: bool) -> Result<Vec<GivenPoint>> {
    let rows = match in_space {
        true => read_doubles(text, source_name, &["x", "y", "z"], None),
        false => read_doubles(text, source_name, &["x", "y"], Some("z")),
    }?;
    let point = |(line, row): (usize, Vec<f64>)| GivenPoint {
        line,
        // In the plane, z is 0.
        position: std::array::from_fn(|i| row.get(i).copied().unwrap_or_default()),
    };
    Ok(rows.into_iter().map(point).collect())
}

/// Reads radii `theta,r` in rows, with θ in radians. Headers and numbers are read as in [`read_points_csv`].
///
/// ```
/// use stellate::check::read_radii_csv;
/// let radii = read_radii_csv("0.5,1.25\n", "radii.csv")?;
/// assert_eq!((radii[0].line, radii[0].theta, radii[0].r), (1, 0.5, 1.25));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// As [`read_points_csv`].
pub fn read_radii_csv(text: &str, source_name: &str) -> Result<Vec<GivenRadius>> {
    let rows = read_doubles(text, source_name, &["theta", "r"], Some("phi"))?;
    let radius = |(line, row): (usize, Vec<f64>)| GivenRadius {
        line,
        theta: row[0],
        r: row[1],
    };
    Ok(rows.into_iter().map(radius).collect())
}

/// Reads radii `theta,phi,r` in rows, with both angles in radians. Headers and numbers are read as in [`read_points_csv`].
///
/// ```
/// use stellate::check::read_space_radii_csv;
/// let radii = read_space_radii_csv("theta,phi,r\n0.5,1,1.25\n", "radii.csv")?;
/// assert_eq!((radii[0].line, radii[0].phi, radii[0].r), (2, 1.0, 1.25));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// As [`read_points_csv`].
pub fn read_space_radii_csv(text: &str, source_name: &str) -> Result<Vec<GivenSpaceRadius>> {
    let rows = read_doubles(text, source_name, &["theta", "phi", "r"], None)?;
    let radius = |(line, row): (usize, Vec<f64>)| GivenSpaceRadius {
        line,
        theta: row[0],
        phi: row[1],
        r: row[2],
    };
    Ok(rows.into_iter().map(radius).collect())
}

/// The values of these columns in the rows, each row with its line in the file. A table with the column `unwanted` is refused.
fn read_doubles(
    text: &str,
    source_name: &str,
    columns: &[&str],
    unwanted: Option<&str>,
) -> Result<Vec<(usize, Vec<f64>)>> {
    let table = Table::read(text, source_name, Numbers::F64)?;
    let places = table.places(source_name, columns, unwanted)?;
    let rows = table.rows.iter().zip(&table.lines);
    rows.map(|((place, fields), line)| {
        let doubles = places.iter().map(|&k| {
            let field = &fields[k];
            let value = number_at(place, field, Numbers::F64)?.to_f64();
            if value.is_finite() {
                return Ok(value);
            }
            let message = format!("{field} is too large for a double");
            Err(Error::data(place, message))
        });
        Ok((*line, doubles.collect::<Result<Vec<f64>>>()?))
    })
    .collect()
}
