//! [`SweptEdge`]: an edge in the ordered status of a sweep.

use std::cmp::Ordering;

use super::orientation::orientation;

/// A directed edge that a sweeping line or ray meets. Exact turns order these edges along the line: the greater edge is farther
/// to the right, seen in the direction of the edges.
///
/// The order is defined for edges that are met at the same moment of the sweep, are directed across it in the same sense and do
/// not cross. Edges with different indices are different.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SweptEdge {
    pub(crate) index: usize,
    pub(crate) ends: [[f64; 2]; 2],
}

impl SweptEdge {
    /// The order of this edge and `other`, if all of `other` is on one side of the line of this edge.
    fn against(&self, other: &Self) -> Option<Ordering> {
        let sides = other
            .ends
            .map(|end| orientation(self.ends[0], self.ends[1], end));
        match sides {
            [Ordering::Equal, Ordering::Equal] => None,
            [s, Ordering::Equal] | [Ordering::Equal, s] => Some(s),
            [s, t] => (s == t).then_some(s),
        }
    }
}

impl Ord for SweptEdge {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.index == other.index {
            return Ordering::Equal;
        }
        self.against(other)
            .or_else(|| other.against(self).map(Ordering::reverse))
            .unwrap_or_else(|| self.index.cmp(&other.index))
    }
}

impl PartialOrd for SweptEdge {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for SweptEdge {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for SweptEdge {}
