//! Certified bounds of the distance between points and a closed curve whose coordinates are finite Fourier series, in doubles.
//!
//! The curve is cut into arcs with Taylor polynomials ([`polynomials`]). A complete binary tree holds the boxes of runs of
//! consecutive arcs. The search for the nearest point ([`search`]) leaves out boxes that are too far away; on an arc, a bound
//! by the second derivative at a local minimum of the distance ([`bound`]) leaves out the rest, or else the arc is divided.

mod bound;
mod polynomials;
mod scaled;
mod search;
mod waves;

#[cfg(test)]
mod laws;

pub(super) use scaled::Waveform;
pub use search::NearestPoint;

use polynomials::Polynomials;
use scaled::Scaled;

use super::tree::Extent;

/// The largest number of harmonics H. The cost of the arcs grows with H²; with so many it is some tenths of a second.
const MOST_HARMONICS: usize = 512;
/// Points whose coordinates are farther than this away, in units of the curve's size, are not searched.
const FARTHEST: f64 = 1e60;

/// A closed curve as a tree of arcs, ready to be compared with points.
#[derive(Debug)]
pub(super) struct ArcTree<const N: usize> {
    /// The arcs in units of 2^exponent.
    arcs: Polynomials<N>,
    /// The unit, a power of two.
    unit: f64,
    /// The boxes of the nodes: node 1 is the root, the children of node k are 2k and 2k + 1, and node K + j is the arc j of K.
    boxes: Vec<Extent<N>>,
}

impl<const N: usize> ArcTree<N> {
    /// The arcs of a curve; `None` if its size is not within the range of doubles, or for too many harmonics.
    pub(super) fn new(series: &[Waveform; N]) -> Option<Self> {
        let scaled = Scaled::new(series)?;
        if scaled.harmonics() > MOST_HARMONICS {
            return None;
        }
        let arcs = Polynomials::new(&scaled);
        let count = arcs.len();
        let mut boxes = vec![Extent::EMPTY; 2 * count];
        for arc in 0..count {
            boxes[count + arc] = Extent::of(arcs.extent(arc));
        }
        for node in (1..count).rev() {
            boxes[node] = boxes[2 * node].joined(&boxes[2 * node + 1]);
        }
        Some(Self {
            arcs,
            unit: f64::from(scaled.exponent()).exp2(),
            boxes,
        })
    }

    /// A point in units of the curve; `None` if it is too far away.
    fn inside(&self, point: [f64; N]) -> Option<[f64; N]> {
        let inside = point.map(|x| x / self.unit);
        inside.iter().all(|x| x.abs() <= FARTHEST).then_some(inside)
    }
}

#[cfg(test)]
pub(super) use laws::series;
