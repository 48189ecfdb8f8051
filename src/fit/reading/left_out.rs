//! What of a file is not in the outline that was taken.

use super::ContourKind;
use crate::shape::Removed;

/// What is in a file besides the outline that was taken.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct LeftOut {
    /// The kind of the file.
    pub kind: ContourKind,
    /// The number of other outlines: parts of a silhouette, closed paths, or polygons.
    pub parts: usize,
    /// The size of the largest of them as a share of the outline that was taken: its number of pixels, or its area.
    pub largest: f64,
    /// The number of holes in the outline that was taken.
    pub holes: usize,
    /// The thickness of the frame around a picture, in pixels; 0 if there is none.
    pub frame: usize,
    /// The number of lines and points, which enclose nothing.
    pub open: usize,
    /// Whether a rectangle covers the whole drawing; it is taken for the background.
    pub background: bool,
    /// What was cut off to mend the outline.
    pub removed: Removed,
}

impl LeftOut {
    /// Whether the file has nothing but the outline.
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        *self
            == Self {
                kind: self.kind,
                ..Self::default()
            }
    }
}
