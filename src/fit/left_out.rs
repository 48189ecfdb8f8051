//! The options of reading a picture, and what of it is not in the outline.

use crate::options::options;

options! {
    /// How a silhouette is found in a picture.
    PictureOptions {
        /// The part of the silhouette that is taken, counted from 1 by the number of pixels.
        blob: usize = 1,
        /// The largest value of the darker class, from 0 to 254; by default Otsu's threshold.
        threshold: Option<u8> = None,
        /// Whether the silhouette is the class of pixels that is otherwise the background.
        invert: bool = false,
    }
}

/// What is in a picture besides the outline that was taken.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct LeftOut {
    /// The number of other parts of the silhouette.
    pub parts: usize,
    /// The number of pixels of the largest of them, as a share of the part that was taken.
    pub largest: f64,
    /// The number of holes in the part that was taken.
    pub holes: usize,
    /// The thickness of the frame around the picture, in pixels; 0 if there is none.
    pub frame: usize,
}

impl LeftOut {
    /// Whether the picture shows nothing but the outline.
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        self.parts == 0 && self.holes == 0 && self.frame == 0
    }
}
