//! Wavefront OBJ: vertices and faces; everything else is left out.

use super::{Faces, vertex};
use crate::error::{Error, Result};

pub(super) fn read(text: &str, place: &str) -> Result<Faces> {
    let mut found = Faces::default();
    let mut corners: Vec<u32> = Vec::new();
    for (at, line) in text.lines().enumerate() {
        let line_number = at + 1;
        let line = line.split('#').next().unwrap_or("");
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => found.vertices.push(vertex(words, line_number, place)?),
            Some("f") => {
                corners.clear();
                for word in words {
                    corners.push(corner(word, found.vertices.len()).ok_or_else(|| {
                        let message = format!(
                            "line {line_number}: `{word}` is no corner of a face: there are {} vertices before it",
                            found.vertices.len()
                        );
                        Error::data(place, message)
                    })?);
                }
                if corners.len() < 3 {
                    let message = format!("line {line_number}: a face has at least three corners");
                    return Err(Error::data(place, message));
                }
                found.add(&corners);
            }
            _ => {}
        }
    }
    Ok(found)
}

/// The index of the vertex of a corner such as `3`, `3/1/2` or `-1`, which is the last vertex so far.
fn corner(word: &str, count: usize) -> Option<u32> {
    let index: i64 = word.split('/').next()?.parse().ok()?;
    let count = i64::try_from(count).ok()?;
    let at = if index < 0 { count + index } else { index - 1 };
    let is_vertex = 0 <= at && at < count;
    is_vertex.then(|| u32::try_from(at).ok()).flatten()
}
