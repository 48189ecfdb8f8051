//! The side of a line on which a point lies, by an exact sign.

use std::cmp::Ordering;

use robust::{Coord, orient2d};

/// The largest size of a coordinate: products of two coordinates must not overflow.
const LARGEST: f64 = 1e120;
/// The smallest size of a coordinate other than 0: exact signs need room below the last bit.
pub(super) const SMALLEST: f64 = 1e-120;

/// The sign of the turn a → b → c: `Greater` to the left (counter-clockwise), `Less` to the right,
/// `Equal` if the three points are on one line.
///
/// Exact for the doubles given (Shewchuk's adaptive predicate) as long as nothing overflows or
/// underflows, which the range of [`super::Contour`]'s coordinates rules out.
pub(crate) fn orientation(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Ordering {
    let coord = |p: [f64; 2]| Coord { x: p[0], y: p[1] };
    // Adding 0.0 turns −0.0, which `total_cmp` puts below 0.0, into 0.0.
    (orient2d(coord(a), coord(b), coord(c)) + 0.0).total_cmp(&0.0)
}

/// Whether c lies on the closed segment from a to b.
pub(crate) fn on_segment(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> bool {
    orientation(a, b, c) == Ordering::Equal && in_box(a, b, c)
}

/// Whether c lies in the closed box spanned by a and b.
pub(super) fn in_box(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> bool {
    (0..2).all(|k| a[k].min(b[k]) <= c[k] && c[k] <= a[k].max(b[k]))
}

/// The fault of a coordinate, if it has one.
pub(crate) fn coordinate_fault(c: f64) -> Option<String> {
    if !c.is_finite() {
        Some(format!("the coordinate {c} is not finite"))
    } else if c.abs() > LARGEST || (c.abs() < SMALLEST && c.abs() > 0.0) {
        Some(format!(
            "the coordinate {c:e} is out of range: it must be 0, or between {SMALLEST:e} and \
             {LARGEST:e} in size"
        ))
    } else {
        None
    }
}

/// Whether two points are equal.
pub(super) fn same(p: [f64; 2], q: [f64; 2]) -> bool {
    p.partial_cmp(&q) == Some(Ordering::Equal)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sign_is_exact_where_the_plain_determinant_is_not() {
        // The three points are within an ulp of the line y = x.
        let (a, b) = ([12.0, 12.0], [24.0, 24.0]);
        let up = [0.5, 0.5_f64.next_up()];
        let down = [0.5, 0.5_f64.next_down()];
        assert_eq!(orientation(a, b, [0.5, 0.5]), Ordering::Equal);
        assert_eq!(orientation(a, b, up), Ordering::Greater);
        assert_eq!(orientation(a, b, down), Ordering::Less);
    }

    #[test]
    fn a_segment_holds_its_ends_and_not_what_is_beyond() {
        let (a, b) = ([0.0, 0.0], [2.0, 1.0]);
        assert!(on_segment(a, b, a) && on_segment(a, b, b) && on_segment(a, b, [1.0, 0.5]));
        assert!(!on_segment(a, b, [4.0, 2.0]) && !on_segment(a, b, [1.0, 0.6]));
    }
}
