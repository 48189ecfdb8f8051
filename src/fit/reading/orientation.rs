//! Pictures of cameras that were held upright or upside down: the orientation in their Exif data.

/// How the stored rows and columns are to be shown: the values 1 to 8 of the tag Orientation of Exif.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Orientation(u8);

/// The tag, and the type of its value: one integer of 16 bits.
const ORIENTATION: u16 = 0x0112;
const SHORT: u16 = 3;

impl Orientation {
    /// Rows are shown from the top, and columns from the left.
    pub(super) const UPRIGHT: Self = Self(1);

    /// The orientation of a value of the tag; `UPRIGHT` if the value is none of it.
    pub(super) fn new(value: u8) -> Self {
        match value {
            1..=8 => Self(value),
            _ => Self::UPRIGHT,
        }
    }

    /// The orientation in Exif data, which begin with the header of a TIFF file; `UPRIGHT` if they have none.
    pub(super) fn of_exif(exif: Option<&[u8]>) -> Self {
        let value = exif.and_then(Self::tag).and_then(|v| u8::try_from(v).ok());
        value.map_or(Self::UPRIGHT, Self::new)
    }

    /// The value of the tag in the first directory.
    fn tag(exif: &[u8]) -> Option<u16> {
        let is_little = match exif.first_chunk()? {
            b"II*\0" => true,
            b"MM\0*" => false,
            _ => return None,
        };
        let u16_at = |at: usize| {
            let two = *exif.get(at..)?.first_chunk()?;
            Some(match is_little {
                true => u16::from_le_bytes(two),
                false => u16::from_be_bytes(two),
            })
        };
        let u32_at = |at: usize| {
            let four = *exif.get(at..)?.first_chunk()?;
            Some(match is_little {
                true => u32::from_le_bytes(four),
                false => u32::from_be_bytes(four),
            })
        };
        let directory = usize::try_from(u32_at(4)?).ok()?;
        let count = usize::from(u16_at(directory)?);
        let entries = (0..count).map(|k| directory + 2 + 12 * k);
        let mut found = entries.take_while(|at| at + 12 <= exif.len());
        let is_orientation = |at: &usize| {
            let head = (u16_at(*at), u16_at(at + 2), u32_at(at + 4));
            head == (Some(ORIENTATION), Some(SHORT), Some(1))
        };
        u16_at(found.find(is_orientation)? + 8)
    }

    /// Values in the rows and columns in which they are shown, and the width and height then.
    pub(super) fn shown(
        self,
        values: Vec<u8>,
        [width, height]: [usize; 2],
    ) -> (Vec<u8>, [usize; 2]) {
        if self == Self::UPRIGHT {
            return (values, [width, height]);
        }
        let shown = if self.0 < 5 {
            [width, height]
        } else {
            [height, width]
        };
        // The stored place of the value that is shown at (x, y).
        let stored = |x: usize, y: usize| match self.0 {
            2 => (width - 1 - x, y),
            3 => (width - 1 - x, height - 1 - y),
            4 => (x, height - 1 - y),
            5 => (y, x),
            6 => (y, height - 1 - x),
            7 => (width - 1 - y, height - 1 - x),
            8 => (width - 1 - y, x),
            _ => (x, y),
        };
        let places = (0..shown[1]).flat_map(|y| (0..shown[0]).map(move |x| stored(x, y)));
        let values = places.map(|(x, y)| values[y * width + x]).collect();
        (values, shown)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Exif data with one entry before the orientation.
    fn exif(is_little: bool, value: u16) -> Vec<u8> {
        let short = |n: u16| match is_little {
            true => n.to_le_bytes(),
            false => n.to_be_bytes(),
        };
        let long = |n: u32| match is_little {
            true => n.to_le_bytes(),
            false => n.to_be_bytes(),
        };
        let mut exif = if is_little {
            b"II*\0".to_vec()
        } else {
            b"MM\0*".to_vec()
        };
        exif.extend(long(10));
        exif.extend(short(0));
        exif.extend(short(2));
        for (tag, value) in [(0x010f, 5), (ORIENTATION, value)] {
            exif.extend([short(tag), short(SHORT)].concat());
            exif.extend(long(1));
            exif.extend([short(value), short(0)].concat());
        }
        exif
    }

    #[test]
    fn the_tag_is_found_in_either_order_of_bytes() {
        for value in 1..=8 {
            for is_little in [true, false] {
                let exif = exif(is_little, value.into());
                assert_eq!(Orientation::of_exif(Some(&exif)), Orientation(value));
                for end in 0..exif.len() {
                    let cut = Orientation::of_exif(Some(&exif[..end]));
                    assert_eq!(cut, Orientation::UPRIGHT, "{end}");
                }
            }
        }
        for value in [0, 9, 300] {
            let exif = exif(true, value);
            assert_eq!(Orientation::of_exif(Some(&exif)), Orientation::UPRIGHT);
        }
        assert_eq!(Orientation::of_exif(None), Orientation::UPRIGHT);
    }

    /// Exif 2.32, 4.6.4 A: which side of the picture the first row and the first column are.
    #[test]
    fn rows_and_columns_are_shown_as_the_tag_says() {
        // 1 2 3
        // 4 5 6
        let expected: [(u8, [usize; 2], [u8; 6]); 8] = [
            (1, [3, 2], [1, 2, 3, 4, 5, 6]),
            (2, [3, 2], [3, 2, 1, 6, 5, 4]),
            (3, [3, 2], [6, 5, 4, 3, 2, 1]),
            (4, [3, 2], [4, 5, 6, 1, 2, 3]),
            (5, [2, 3], [1, 4, 2, 5, 3, 6]),
            (6, [2, 3], [4, 1, 5, 2, 6, 3]),
            (7, [2, 3], [6, 3, 5, 2, 4, 1]),
            (8, [2, 3], [3, 6, 2, 5, 1, 4]),
        ];
        for (value, size, values) in expected {
            let shown = Orientation::new(value).shown(vec![1, 2, 3, 4, 5, 6], [3, 2]);
            assert_eq!(shown, (values.to_vec(), size), "{value}");
        }
    }
}
