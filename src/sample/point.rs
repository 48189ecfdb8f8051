//! The points on a line through the origin.

/// A point c + r·(u, v) of a curve, or c + r·(u, v, w) of a surface. c is the origin unless the solver has a center. Each of r
/// and the coordinates is the double nearest to its exact value; ties go to either double.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample<const V: usize = 2> {
    /// The number of the point among those of its direction, from 0 for the largest r.
    pub branch: usize,
    /// The signed distance from c along the direction. [`super::RaySolver::exact_distances`] gives it exactly.
    pub r: f64,
    /// The coordinates x, y (and z).
    pub position: [f64; V],
    /// The multiplicity of r as a root of f(ru, rv).
    pub multiplicity: usize,
}

/// The intersection of a curve or surface with the line through the origin in one direction.
#[derive(Clone, Debug, PartialEq)]
pub enum Ray<const V: usize = 2> {
    /// All distinct real roots r ≠ 0 of f(ru, rv), the largest first; their number is exact.
    Points(Vec<Sample<V>>),
    /// The whole line belongs to the zero set: f vanishes identically along the direction.
    Line,
}

/// A point before it is numbered among the points of its line.
pub(super) struct Found<const V: usize> {
    /// The point with coordinates relative to the center.
    pub(super) relative: Sample<V>,
    /// The coordinates of the point, if the center is not the origin.
    pub(super) position: Option<[f64; V]>,
}

/// The points of a line, the largest r first, numbered. Points with the same double r are ordered by their coordinates relative
/// to the center.
pub(super) fn in_order<const V: usize>(mut points: Vec<Found<V>>) -> Vec<Sample<V>> {
    let beyond = |a: &Sample<V>, b: &Sample<V>| {
        let sizes = a.position.iter().zip(&b.position);
        let larger = sizes
            .map(|(a, b)| b.abs().total_cmp(&a.abs()))
            .find(|order| order.is_ne());
        let order = larger.unwrap_or_else(|| b.multiplicity.cmp(&a.multiplicity));
        if a.r < 0.0 { order.reverse() } else { order }
    };
    points.sort_by(|a, b| {
        let (a, b) = (&a.relative, &b.relative);
        b.r.total_cmp(&a.r).then_with(|| beyond(a, b))
    });
    let numbered = points.into_iter().enumerate();
    let placed = numbered.map(|(branch, point)| Sample {
        branch,
        position: point.position.unwrap_or(point.relative.position),
        ..point.relative
    });
    placed.collect()
}
