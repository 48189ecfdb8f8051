//! The parts of facets and lines in space that are inside a box.

/// The part of a polygon inside the box (Sutherland and Hodgman); it is empty if the polygon is outside.
pub(super) fn polygon(corners: &[[f64; 3]], bounds: &[[f64; 2]; 3]) -> Vec<[f64; 3]> {
    let mut kept = corners.to_vec();
    for k in 0..3 {
        for side in 0..2 {
            let depth = |p: &[f64; 3]| inwards(p, k, side, bounds);
            let mut next = Vec::with_capacity(kept.len() + 1);
            for (i, p) in kept.iter().enumerate() {
                let q = &kept[(i + 1) % kept.len()];
                let (a, b) = (depth(p), depth(q));
                if a >= 0.0 {
                    next.push(*p);
                }
                if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
                    next.push(between(p, q, a / (a - b), k, bounds[k][side]));
                }
            }
            kept = next;
        }
    }
    if kept.len() < 3 { Vec::new() } else { kept }
}

/// The part of a segment inside the box; `None` if the segment is outside.
pub(super) fn segment([p, q]: [[f64; 3]; 2], bounds: &[[f64; 2]; 3]) -> Option<[[f64; 3]; 2]> {
    let mut ends = [p, q];
    for k in 0..3 {
        for side in 0..2 {
            let [a, b] = ends.each_ref().map(|p| inwards(p, k, side, bounds));
            match (a < 0.0, b < 0.0) {
                (true, true) => return None,
                (false, false) => {}
                (outside, _) => {
                    let cut = between(&ends[0], &ends[1], a / (a - b), k, bounds[k][side]);
                    ends[usize::from(!outside)] = cut;
                }
            }
        }
    }
    Some(ends)
}

fn inwards(p: &[f64; 3], k: usize, side: usize, bounds: &[[f64; 2]; 3]) -> f64 {
    if side == 0 {
        p[k] - bounds[k][0]
    } else {
        bounds[k][1] - p[k]
    }
}

/// The point with the parameter t on the segment from p to q, which lies on a plane.
fn between(p: &[f64; 3], q: &[f64; 3], t: f64, k: usize, plane: f64) -> [f64; 3] {
    let mut point = [0, 1, 2].map(|i| p[i] + t * (q[i] - p[i]));
    point[k] = plane;
    point
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const BOX: [[f64; 2]; 3] = [[-1.0, 1.0], [0.0, 2.0], [-3.0, 1.0]];

    fn inside(p: &[f64; 3]) -> bool {
        (0..3).all(|k| BOX[k][0] <= p[k] && p[k] <= BOX[k][1])
    }

    proptest! {
        #[test]
        fn what_is_left_is_inside(corners in prop::collection::vec(prop::array::uniform3(-5.0f64..5.0), 3..5)) {
            prop_assert!(polygon(&corners, &BOX).iter().all(inside));
            let rest = segment([corners[0], corners[1]], &BOX);
            prop_assert!(rest.iter().flatten().all(inside));
            if corners.iter().all(inside) {
                prop_assert_eq!(polygon(&corners, &BOX), corners.clone());
            }
            // The middle of a segment is outside if the whole segment was cut off.
            let middle = [0, 1, 2].map(|k| f64::midpoint(corners[0][k], corners[1][k]));
            prop_assert!(rest.is_some() || !inside(&middle));
        }
    }
}
