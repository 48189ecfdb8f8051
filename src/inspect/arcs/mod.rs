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

use crate::intervals::interval::UNIT;

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

/// A box.
#[derive(Clone, Copy, Debug)]
struct Extent<const N: usize> {
    low: [f64; N],
    high: [f64; N],
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

impl<const N: usize> Extent<N> {
    const EMPTY: Self = Self {
        low: [f64::INFINITY; N],
        high: [f64::NEG_INFINITY; N],
    };

    /// The box about a middle with half its sides. The ends are at most 1 in size, so each is rounded by less than 4·`UNIT`.
    fn of((middle, half): ([f64; N], [f64; N])) -> Self {
        Self {
            low: std::array::from_fn(|i| middle[i] - half[i] - 4.0 * UNIT),
            high: std::array::from_fn(|i| middle[i] + half[i] + 4.0 * UNIT),
        }
    }

    fn joined(&self, other: &Self) -> Self {
        Self {
            low: std::array::from_fn(|i| self.low[i].min(other.low[i])),
            high: std::array::from_fn(|i| self.high[i].max(other.high[i])),
        }
    }

    /// A lower bound of the squared distance of a point from the box, of which each coordinate has four roundings.
    fn least_square(&self, p: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for ((low, high), x) in self.low.iter().zip(&self.high).zip(p) {
            let away = (low - x).max(x - high).max(0.0);
            sum += away * away;
        }
        sum * (1.0 - 8.0 * UNIT)
    }

    /// An upper bound of the squared distance of a point from the points of the box.
    fn greatest_square(&self, p: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for ((low, high), x) in self.low.iter().zip(&self.high).zip(p) {
            let away = (high - x).max(x - low);
            sum += away * away;
        }
        sum * (1.0 + 8.0 * UNIT)
    }
}

#[cfg(test)]
pub(super) use laws::series;
