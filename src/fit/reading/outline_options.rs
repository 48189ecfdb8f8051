//! The options of reading an outline from a file.

use super::{Column, Columns, ContourKind};
use crate::error::{Error, Result};
use crate::options::options;
use crate::shape::{Contour, GivenPoints, Removed};

options! {
    /// How an outline is found in a file.
    OutlineOptions {
        /// The outline that is taken of a picture, a drawing or GeoJSON, counted from 1: by the number of pixels, or by the area.
        blob: usize = 1,
        /// Of a picture: the largest value of the darker class, from 0 to 254; by default Otsu's threshold.
        threshold: Option<u8> = None,
        /// Of a picture: whether the silhouette is the class of pixels that is otherwise the background.
        invert: bool = false,
        /// Of a table: the columns of x and y; by default those that its first row names so, or the only two.
        columns: Option<Columns> = None,
        /// Of a table: the column of the weights; by default every weight is 1.
        weights: Option<Column> = None,
        /// Whether an outline that touches or crosses itself is mended ([`Contour::repaired`](crate::shape::Contour::repaired)).
        repair: bool = false,
    }
}

impl OutlineOptions {
    /// The outline through these points, mended if that is asked for, and what was cut off.
    pub(super) fn outline(&self, given: GivenPoints, place: &str) -> Result<(Contour, Removed)> {
        if self.repair {
            return Contour::repaired(given, place);
        }
        Contour::from_rows(given, place).map(|outline| (outline, Removed::default()))
    }

    /// Refuses options that mean nothing for an outline of this kind, or for what is no outline (`None`).
    ///
    /// # Errors
    /// [`Error::Usage`] with the first of these options.
    pub fn check(&self, kind: Option<ContourKind>) -> Result<()> {
        use ContourKind::{Array, Drawing, Image, Polygons, Rows};
        let usual = Self::default();
        let given: [(&str, bool, &[ContourKind], &str); 6] = [
            (
                "--blob",
                self.blob != usual.blob,
                &[Image, Drawing, Polygons],
                "pictures, SVG drawings and GeoJSON",
            ),
            (
                "--threshold",
                self.threshold != usual.threshold,
                &[Image],
                "pictures",
            ),
            (
                "--invert",
                self.invert != usual.invert,
                &[Image],
                "pictures",
            ),
            (
                "--columns",
                self.columns != usual.columns,
                &[Rows, Array],
                "tables of points",
            ),
            (
                "--weights",
                self.weights != usual.weights,
                &[Rows, Array],
                "tables of points",
            ),
            (
                "--repair",
                self.repair,
                &[Array, Drawing, Image, Polygons, Rows],
                "outlines",
            ),
        ];
        let wrong = given
            .iter()
            .find(|(_, given, kinds, _)| *given && !kind.is_some_and(|kind| kinds.contains(&kind)));
        match wrong {
            Some((name, _, _, what)) => {
                Err(Error::Usage(format!("{name} is for {what}; this is none")))
            }
            None => Ok(()),
        }
    }
}
