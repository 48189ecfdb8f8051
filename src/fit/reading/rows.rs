//! Rows of points in the plane are read.

use std::io::BufRead;

use super::OutlineOptions;
use super::layout::{COLUMNS, Layout};
use crate::error::{Error, Result};
use crate::rows::RowReader;
use crate::shape::GivenPoints;

/// The largest number of rows with points in one file.
pub(super) const MAX_ROWS: usize = 10_000_000;

/// The points, with their rows in the file (counted from 1; every line counts) and with weights if the options name their column.
pub(super) fn read_rows(
    reader: &mut impl BufRead,
    options: &OutlineOptions,
    place: &str,
) -> Result<GivenPoints> {
    let mut read = GivenPoints::default();
    let mut rows = RowReader::new(reader, place, COLUMNS);
    let Some((number, first)) = rows.next_row()?.map(|(n, row)| (n, row.to_owned())) else {
        return Ok(read);
    };
    rows.refuse_center()?;
    // The header is known with the first row.
    let layout = Layout::of(rows.header(), &first, options)
        .map_err(|message| rows.error(number, message))?;
    let mut point = layout.point(&first);
    let mut height = layout.height(&first).map(|z| (z, number));
    let mut number = number;
    loop {
        let (xy, weight) = point.map_err(|message| rows.error(number, message))?;
        read.points.push(xy);
        read.weights.extend(weight);
        read.rows.push(number);
        if read.points.len() > MAX_ROWS {
            return Err(Error::limit(format!(
                "{place} has more than {MAX_ROWS} rows"
            )));
        }
        match rows.next_row()? {
            None => return Ok(read),
            Some((next, row)) => {
                let here = layout.height(row);
                if let (Some(z), Some((other, before))) = (here, height)
                    && (z - other).abs() > 0.0
                {
                    let message = format!(
                        "z is {z} here and {other} in row {before}: these are points in space, and an outline is in the plane; --columns says which two coordinates are wanted"
                    );
                    return Err(rows.error(next, message));
                }
                height = height.or(here.map(|z| (z, next)));
                (number, point) = (next, layout.point(row));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<(Vec<[f64; 2]>, Vec<usize>)> {
        let read = read_rows(
            &mut text.as_bytes(),
            &OutlineOptions::default(),
            "outline.csv",
        );
        read.map(|read| (read.points, read.rows))
    }

    fn message(text: &str) -> String {
        read(text).unwrap_err().to_string()
    }

    #[test]
    fn rows_are_counted_as_an_editor_counts_them() {
        let text = "\u{feff}# outline\n\nx,y\n0,1\r\n\r\n  # more\n \"2.5\" , -0x1.8p1\n1e3,−4";
        let (points, rows) = read(text).unwrap();
        assert_eq!(points, [[0.0, 1.0], [2.5, -3.0], [1000.0, -4.0]]);
        assert_eq!(rows, [4, 7, 8]);
    }

    #[test]
    fn a_header_is_optional() {
        assert_eq!(read("0,1\n2,3").unwrap().0.len(), 2);
        assert_eq!(read("easting,northing\n2,3").unwrap().0.len(), 1);
        assert_eq!(read("").unwrap().0.len(), 0);
        assert_eq!(read("y;x\n2,5;3\n").unwrap().0, [[3.0, 2.5]]);
        assert_eq!(read("NACA 0012\n1 0\n0 1\n").unwrap().0.len(), 2);
        assert!(message("1 b\n2 3\n").contains("row 1: \"b\" is not a number"));
        // A row of numbers is no header, whatever separates them.
        assert_eq!(read("1;2\n3;4").unwrap().0.len(), 2);
        // Only the first row can be a header, and only if none of its fields is a number.
        assert!(message("x,y\nx,y\n").contains("row 2: \"x\" is not a number"));
        assert!(message("1,y\n").contains("row 1: \"y\" is not a number"));
    }

    #[test]
    fn a_first_row_of_numbers_is_no_header() {
        assert_eq!(
            read("9\u{a0}9\n5\u{a0}0\n").unwrap().0,
            [[9.0, 9.0], [5.0, 0.0]]
        );
        assert_eq!(read("id,x,y,2nd_pass\n7,1,2,3\n").unwrap().0, [[1.0, 2.0]]);
        for text in ["9mm;9mm\n1;2\n", "$9;$9\n1;2\n", "-.5m,0.5m\n1,2\n"] {
            assert!(message(text).contains("row 1: "), "{text}");
        }
        let quoted = "id,x,y\n\"a;b\",5,6\n\"c\"\"d\te\",7,8\n";
        assert_eq!(read(quoted).unwrap().0, [[5.0, 6.0], [7.0, 8.0]]);
    }

    #[test]
    fn points_in_space_are_no_outline() {
        let flat = "x,y,z\n1,2,\n1,3,0\n3,4,0.0\n5,6,-0\n7,8,NA\n";
        assert_eq!(read(flat).unwrap().0.len(), 5);
        let text = "x,y,z\n1,2,0\n3,4,5\n";
        assert!(message(text).contains("row 3: z is 5 here and 0 in row 2"));
        let options = OutlineOptions::default().columns(Some("x,z".parse().unwrap()));
        let chosen = read_rows(&mut text.as_bytes(), &options, "outline.csv").unwrap();
        assert_eq!(chosen.points, [[1.0, 0.0], [3.0, 5.0]]);
    }

    #[test]
    fn errors_name_the_row() {
        let mut text: String = (1..17).map(|k| format!("{k},{}\n", k * k)).collect();
        text.push_str("17,abc\n");
        assert_eq!(
            message(&text),
            "outline.csv, row 17: \"abc\" is not a number; each row must be x,y"
        );
        assert!(message("1,2\n3\n").contains("row 2: found 1 column; each row must be x,y"));
        assert!(message("1,2\n3,4,5\n").contains("row 2: found 3 columns"));
        assert!(message("theta,r\n0,1\n").contains("row 2: the columns are angles and radii"));
        assert!(message("1,2\n3,\n").contains("\"\" is not a number"));
        assert!(message("1,2\n3,inf\n").contains("\"inf\" is not a number"));
        assert!(message("1,2\n3,NaN\n").contains("\"NaN\" is not a number"));
        for missing in ["NA", "", "NaN", "null", "-"] {
            let text = format!("x,y\n1,2\n3,{missing}\n");
            let expected = format!(
                "outline.csv, row 3: {missing:?} is not a number, and an outline has no gaps; leave this row out"
            );
            assert_eq!(message(&text), expected);
            // A first row of such marks is no header.
            assert!(message(&format!("{missing},{missing}\n1,2\n")).contains("row 1"));
        }
        assert!(message("1,2\n3,1e999\n").contains("too large for a double"));
        assert!(message("1,2\n3,1e-400\n").contains("row 2: 1e-400 is too small for a double"));
        assert_eq!(read("0,0e-400\n").unwrap().0, [[0.0, 0.0]]);
        assert!(message("inf,nan\n").contains("row 1: \"inf\" is not a number"));
        assert!(message("1,2\n3,0x1p99999\n").contains("not a number"));
    }

    #[test]
    fn what_is_not_text_is_refused() {
        let bytes = [b'1', b',', 0xff, b'\n'];
        let error =
            read_rows(&mut bytes.as_slice(), &OutlineOptions::default(), "a.csv").unwrap_err();
        assert!(
            error.to_string().contains("row 1: not UTF-8 text"),
            "{error}"
        );
        let long = "1".repeat(1 << 17);
        assert!(message(&long).contains("longer than 65536 bytes"));
    }
}
