//! Closed rings of points: which one is the outline, and what is left out.

use super::{ContourKind, LeftOut, OutlineOptions};
use crate::error::{Error, Result};
use crate::shape::Contour;

/// A closed ring, and what is in it.
#[derive(Clone, Debug)]
pub(super) struct Ring {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) holes: usize,
    pub(super) area: f64,
}

/// The rings of a file, the largest first.
#[derive(Debug)]
pub(super) struct Rings {
    all: Vec<Ring>,
    /// What every outline leaves out, besides other rings and holes of its own.
    rest: LeftOut,
}

impl Ring {
    /// The ring through these points. If the last one is the first again, it is dropped.
    pub(super) fn new(mut points: Vec<[f64; 2]>, holes: usize) -> Self {
        let closes = |points: &[[f64; 2]]| points.len() > 1 && points.first() == points.last();
        while closes(&points) {
            points.pop();
        }
        let area = signed_area(&points).abs();
        Self {
            points,
            holes,
            area,
        }
    }
}

impl Rings {
    /// These rings in order of their areas.
    pub(super) fn new(mut all: Vec<Ring>, rest: LeftOut) -> Self {
        all.sort_by(|a, b| b.area.total_cmp(&a.area));
        Self { all, rest }
    }

    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    /// The ring with this number, from 0, as an outline.
    ///
    /// # Errors
    /// Those of [`Contour::new`]; [`Error::Data`] if there are fewer rings.
    pub(super) fn outline(
        &mut self,
        index: usize,
        options: &OutlineOptions,
        place: &str,
    ) -> Result<(Contour, LeftOut)> {
        let count = self.all.len();
        let others = self.all.iter().enumerate().filter(|(k, _)| *k != index);
        let largest = others.map(|(_, ring)| ring.area).fold(0.0, f64::max);
        let Some(taken) = self.all.get_mut(index) else {
            let what = match (self.rest.kind, count) {
                (ContourKind::Drawing, 1) => "closed path",
                (ContourKind::Drawing, _) => "closed paths",
                (_, 1) => "polygon",
                _ => "polygons",
            };
            return Err(Error::data(
                place,
                format!(
                    "--blob {}: there are {count} {what}, counted from 1 by their area",
                    index.saturating_add(1)
                ),
            ));
        };
        // No ring is an outline twice.
        let points = std::mem::take(&mut taken.points);
        let (outline, removed) = options.outline(points.into(), place)?;
        let left_out = LeftOut {
            parts: count - 1,
            largest: largest / taken.area,
            holes: taken.holes,
            removed,
            ..self.rest.clone()
        };
        Ok((outline, left_out))
    }
}

/// The signed area of a closed ring, by its distances from its first point: far from the origin no digits are lost.
pub(super) fn signed_area(ring: &[[f64; 2]]) -> f64 {
    let Some((first, others)) = ring.split_first() else {
        return 0.0;
    };
    let from_first = |p: &[f64; 2]| [p[0] - first[0], p[1] - first[1]];
    let pairs = others.windows(2);
    let doubled = pairs.map(|pair| {
        let (p, q) = (from_first(&pair[0]), from_first(&pair[1]));
        p[0] * q[1] - q[0] * p[1]
    });
    doubled.sum::<f64>() / 2.0
}

/// Whether a point is inside a closed ring, by the half-open rule; on the ring itself either answer may be given.
#[cfg(feature = "images")]
pub(super) fn is_inside(point: [f64; 2], ring: &[[f64; 2]]) -> bool {
    let edges = ring.iter().zip(ring.iter().cycle().skip(1));
    let crossed = edges.filter(|(p, q)| {
        (p[1] <= point[1]) != (q[1] <= point[1])
            && point[0] < p[0] + (point[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
    });
    crossed.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(at: f64, side: f64) -> Ring {
        let far = at + side;
        Ring::new(
            vec![[at, at], [far, at], [far, far], [at, far], [at, at]],
            1,
        )
    }

    #[test]
    fn rings_are_counted_by_their_area() {
        let all = vec![square(1e9, 1.0), square(0.0, 3.0), square(5.0, 2.0)];
        let mut rings = Rings::new(all, LeftOut::default());
        let options = OutlineOptions::default();
        let (outline, left_out) = rings.outline(1, &options, "a").unwrap();
        assert_eq!((outline.area(), outline.len()), (4.0, 4));
        assert_eq!(
            (left_out.parts, left_out.holes, left_out.largest),
            (2, 1, 2.25)
        );
        let (outline, _) = rings.outline(2, &options, "a").unwrap();
        assert_eq!((outline.area(), outline.len()), (1.0, 4));
        let error = rings.outline(3, &options, "a").unwrap_err().to_string();
        assert!(error.contains("--blob 4: there are 3 polygons"), "{error}");
    }
}
