//! STL: triangles by their corners, as text or binary.

use super::{Faces, text, vertex};
use crate::error::{Error, Result};

/// The bytes before the triangles of a binary file, and those of a triangle.
const HEADER: usize = 84;
const TRIANGLE: usize = 50;

pub(super) fn read(bytes: &[u8], place: &str) -> Result<Faces> {
    // Some binary files begin with `solid`, too; the number of triangles tells them apart.
    let count = |bytes: &[u8]| -> Option<usize> {
        let word = bytes.get(80..HEADER)?.try_into().ok()?;
        Some(u32::from_le_bytes(word) as usize)
    };
    let is_text = bytes.trim_ascii_start().starts_with(b"solid")
        && count(bytes).is_none_or(|n| bytes.len() != HEADER + TRIANGLE * n);
    if is_text {
        return read_text(text(bytes, place)?, place);
    }
    let Some(count) = count(bytes) else {
        return Err(Error::data(place, "this is too short for an STL file"));
    };
    let triangles = &bytes[HEADER..];
    if triangles.len() < TRIANGLE * count {
        let message = format!(
            "the file is cut: its header says {count} triangles, and there are {}",
            triangles.len() / TRIANGLE
        );
        return Err(Error::data(place, message));
    }
    let mut found = Faces::default();
    for (k, triangle) in triangles.chunks_exact(TRIANGLE).take(count).enumerate() {
        // The normal is left out.
        let numbers = triangle[12..48].as_chunks::<4>().0;
        let corners = numbers.as_chunks::<3>().0;
        for corner in corners {
            let corner = corner.map(|bytes| f64::from(f32::from_le_bytes(bytes)));
            if corner.iter().any(|x| !x.is_finite()) {
                let message = format!("triangle {}: a coordinate is not finite", k + 1);
                return Err(Error::data(place, message));
            }
            found.vertices.push(corner);
        }
        let first = u32::try_from(3 * k).unwrap_or(u32::MAX - 2);
        found.triangles.push([first, first + 1, first + 2]);
    }
    Ok(found)
}

fn read_text(text: &str, place: &str) -> Result<Faces> {
    let mut found = Faces::default();
    let mut first = 0;
    let mut is_ended = false;
    for (at, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("vertex") => found.vertices.push(vertex(words, at + 1, place)?),
            Some("endloop") => {
                let last = u32::try_from(found.vertices.len()).unwrap_or(u32::MAX);
                if last != first + 3 {
                    let message = format!("line {}: a facet of STL has three vertices", at + 1);
                    return Err(Error::data(place, message));
                }
                found.triangles.push([first, first + 1, first + 2]);
                first = last;
            }
            Some("endsolid") => is_ended = true,
            _ => {}
        }
    }
    if !is_ended {
        let message = "the file is cut: there is no line `endsolid`";
        return Err(Error::data(place, message));
    }
    Ok(found)
}
