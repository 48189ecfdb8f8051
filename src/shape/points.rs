//! Points as they are read from a file, and point clouds.

use std::cmp::Ordering;

use super::orientation::{coordinate_fault, orientation, same};
use crate::error::{Error, Result};

/// Points in the order in which they were read.
///
/// A weight w says that the squared error of a point counts w times: 1/σ² for a point that was measured with the standard
/// deviation σ. A point of weight 0 does not count.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GivenPoints {
    /// The points.
    pub points: Vec<[f64; 2]>,
    /// The weight of each point; empty if every weight is 1.
    pub weights: Vec<f64>,
    /// The row of each point in its file, counted from 1; empty if it is the number of the point.
    pub rows: Vec<usize>,
}

impl From<Vec<[f64; 2]>> for GivenPoints {
    fn from(points: Vec<[f64; 2]>) -> Self {
        Self {
            points,
            ..Self::default()
        }
    }
}

impl GivenPoints {
    /// The name of a point in messages.
    pub(super) fn name(&self, index: usize) -> String {
        format!("row {}", self.row(index))
    }

    pub(super) fn row(&self, index: usize) -> usize {
        self.rows.get(index).copied().unwrap_or(index + 1)
    }

    /// The weights of some of the points; empty if every weight is 1.
    pub(super) fn weights_of(&self, kept: impl Iterator<Item = usize>) -> Vec<f64> {
        if self.weights.is_empty() {
            return Vec::new();
        }
        kept.map(|index| self.weights[index]).collect()
    }

    /// Checks the coordinates and the weights.
    ///
    /// # Errors
    /// [`Error::Data`] with the first point at fault, which `name` names.
    pub(super) fn check(&self, place: &str, name: impl Fn(usize) -> String) -> Result<()> {
        if !self.weights.is_empty() && self.weights.len() != self.points.len() {
            let (weights, points) = (self.weights.len(), self.points.len());
            return Err(Error::data(
                place,
                format!("there are {weights} weights for {points} points"),
            ));
        }
        for (i, point) in self.points.iter().enumerate() {
            let fault = point.iter().find_map(|&c| coordinate_fault(c));
            let fault = fault.or_else(|| weight_fault(*self.weights.get(i)?));
            if let Some(fault) = fault {
                return Err(Error::data(format!("{place}, {}", name(i)), fault));
            }
        }
        Ok(())
    }
}

/// The fault of a weight, if it has one.
fn weight_fault(weight: f64) -> Option<String> {
    let is_usual = weight.is_finite() && weight >= 0.0;
    (!is_usual).then(|| format!("the weight {weight} is not a number that is at least 0"))
}

/// Points of an outline in no order, such as those of a scanner.
///
/// ```
/// use stellate::shape::PointCloud;
/// let corners = vec![[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
/// let cloud = PointCloud::new(corners.into(), "corners")?;
/// assert_eq!(cloud.points().len(), 4);
/// assert!(PointCloud::new(vec![[0.0, 0.0], [1.0, 1.0]].into(), "two").is_err());
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PointCloud {
    points: Vec<[f64; 2]>,
    weights: Vec<f64>,
    place: String,
}

impl PointCloud {
    /// The cloud of these points; `place` names their source in messages.
    ///
    /// # Errors
    /// [`Error::Data`] if a coordinate or a weight is out of range, with its row, or if all points are on one line.
    pub fn new(given: GivenPoints, place: &str) -> Result<Self> {
        given.check(place, |i| given.name(i))?;
        let points = &given.points;
        let is_on_a_line = match points.iter().find(|p| !same(**p, points[0])) {
            None => true,
            Some(other) => points
                .iter()
                .all(|p| orientation(points[0], *other, *p) == Ordering::Equal),
        };
        if is_on_a_line {
            return Err(Error::data(
                place,
                format!(
                    "a cloud needs at least three points that are not on one line; there are {} points",
                    points.len()
                ),
            ));
        }
        Ok(Self {
            points: given.points,
            weights: given.weights,
            place: place.into(),
        })
    }

    /// The points, in the order in which they were given.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The weight of each point, as in [`GivenPoints`]; empty if every weight is 1.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Where the points came from, as it was given.
    #[must_use]
    pub fn place(&self) -> &str {
        &self.place
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_named_by_their_rows() {
        let message = |points: Vec<[f64; 2]>, weights: Vec<f64>| {
            let given = GivenPoints {
                points,
                weights,
                rows: vec![3, 5, 9],
            };
            PointCloud::new(given, "a.csv").unwrap_err().to_string()
        };
        let corners = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(message(corners.clone(), vec![1.0, -2.0, 1.0]).contains("row 5: the weight -2"));
        assert!(message(corners, vec![1.0]).contains("there are 1 weights for 3 points"));
        let far = vec![[0.0, 0.0], [1.0, 0.0], [0.0, f64::NAN]];
        assert!(message(far, vec![]).contains("row 9: the coordinate NaN"));
        for line in [
            vec![],
            vec![[1.0, 2.0]; 3],
            vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]],
        ] {
            assert!(message(line, vec![]).contains("not on one line"));
        }
    }
}
