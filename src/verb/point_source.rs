//! Where the points of an inspection come from: texts, or a table that is read row by row.

use std::io::BufRead;

use super::point_layout::{PointLayout, coordinate};
use crate::error::{Error, Result};
use crate::rows::{RowReader, fields, row_error};

/// The sections are computed for at most this many points.
const FEW: usize = 16;

/// The source of the points of an inspection.
#[non_exhaustive]
pub enum PointSource {
    /// Points that are given one by one, each as a text `x,y` or `x,y,z`.
    Texts(Vec<String>),
    /// A table with rows `x,y` or `x,y,z`; the header is optional. If it names x and y, and z in space, the columns may be in any
    /// order, and others beside them.
    Rows(PointRows),
}

/// A table of points, read up to its first row.
pub struct PointRows {
    pub(super) place: String,
    pub(super) size: u64,
    pub(super) layout: PointLayout,
    pub(super) reader: Box<dyn BufRead>,
    /// The types of the columns of a file that stores them.
    #[cfg(feature = "columnar")]
    types: Option<super::ColumnTypes>,
}

impl std::fmt::Debug for PointSource {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Texts(texts) => f.debug_tuple("Texts").field(texts).finish(),
            Self::Rows(rows) => f.debug_tuple("Rows").field(rows).finish(),
        }
    }
}

impl std::fmt::Debug for PointRows {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PointRows")
            .field("place", &self.place)
            .field("layout", &self.layout)
            .finish_non_exhaustive()
    }
}

impl PointRows {
    /// A table from a reader. `place` names it in messages; `size` is about its number of bytes, or 0 if that is not known.
    ///
    /// # Errors
    /// [`Error::Io`] if reading fails; [`Error::Data`] if it is not known which of the columns are coordinates.
    pub fn new(mut reader: Box<dyn BufRead>, place: &str, size: u64) -> Result<Self> {
        let buffer = reader.fill_buf().map_err(|source| Error::Io {
            path: place.into(),
            source,
        })?;
        let mut rows = RowReader::new(buffer, place, "x,y,z");
        // A row that is longer than the buffer is refused later.
        let first = rows.next_row().ok().flatten();
        let first = first.map(|(number, row)| (number, row.to_owned()));
        rows.refuse_center()?;
        let layout = match first {
            Some((number, first)) => PointLayout::of(rows.header(), &first)
                .map_err(|message| row_error(place, number, message))?,
            None => PointLayout::plain(3),
        };
        Ok(Self {
            place: place.into(),
            size,
            layout,
            reader,
            #[cfg(feature = "columnar")]
            types: None,
        })
    }

    #[cfg(feature = "columnar")]
    pub(super) fn with_types(self, types: super::ColumnTypes) -> Self {
        Self {
            types: Some(types),
            ..self
        }
    }
}

impl PointSource {
    /// The number of coordinates: 2 or 3.
    ///
    /// # Errors
    /// [`Error::Usage`] for texts with another number of coordinates, with different numbers, or with what is not a number.
    pub fn dimension(&self) -> Result<usize> {
        match self {
            Self::Texts(points) => {
                let count = points.first().map_or(3, |text| fields(text).count());
                let wrong = points
                    .iter()
                    .find(|text| fields(text).count() != count || !(2..=3).contains(&count));
                match wrong {
                    Some(text) => Err(Error::Usage(format!(
                        "--point {text}: expected X,Y,Z, such as 0.8,0.6,0, or X,Y for a plane curve, the same for all points"
                    ))),
                    None => points
                        .iter()
                        .try_for_each(|text| check_numbers(text))
                        .map(|()| count),
                }
            }
            Self::Rows(rows) => Ok(rows.layout.dimension()),
        }
    }

    pub(super) fn layout(&self) -> Result<PointLayout> {
        match self {
            Self::Texts(_) => Ok(PointLayout::plain(self.dimension()?)),
            Self::Rows(rows) => Ok(rows.layout.clone()),
        }
    }

    /// The names of the columns of a table that are no coordinates.
    #[must_use]
    pub fn other_names(&self) -> Vec<String> {
        match self {
            Self::Texts(_) => Vec::new(),
            Self::Rows(rows) => rows.layout.other_names().map(str::to_owned).collect(),
        }
    }

    /// The types of the columns of a Parquet or Arrow file.
    #[cfg(feature = "columnar")]
    #[must_use]
    pub fn types(&self) -> Option<super::ColumnTypes> {
        match self {
            Self::Texts(_) => None,
            Self::Rows(rows) => rows.types.clone(),
        }
    }

    /// Whether there are so few points that each of them may have its section.
    #[must_use]
    pub fn are_few(&self) -> bool {
        matches!(self, Self::Texts(points) if points.len() <= FEW)
    }

    /// The size that progress is measured against: a number of points, or a number of bytes.
    pub(super) fn size(&self) -> u64 {
        match self {
            Self::Texts(points) => points.len() as u64,
            Self::Rows(rows) => rows.size,
        }
    }
}

/// Refuses the text of a point with a coordinate that is no number.
fn check_numbers(text: &str) -> Result<()> {
    match fields(text).find_map(|field| coordinate(field).err()) {
        Some(message) => Err(Error::Usage(format!("--point {text}: {message}"))),
        None => Ok(()),
    }
}
