//! Two triangles of a mesh that cross each other.

use robust::{Coord3D, orient3d};

use crate::shape::Solid;

/// Two triangles of which an edge of one goes through the inside of the other, by exact signs; `None` if no two do. Triangles that only touch
/// are not looked for.
///
/// Cost: a comparison of all pairs whose ranges of x overlap.
pub(super) fn crossing(solid: &Solid) -> Option<[usize; 2]> {
    let count = solid.triangles().len();
    let boxes: Vec<[[f64; 2]; 3]> = (0..count)
        .map(|k| {
            let corners = solid.corners(k);
            std::array::from_fn(|i| {
                let x = corners.map(|v| v[i]);
                [x[0].min(x[1]).min(x[2]), x[0].max(x[1]).max(x[2])]
            })
        })
        .collect();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_unstable_by(|a, b| boxes[*a][0][0].total_cmp(&boxes[*b][0][0]).then(a.cmp(b)));
    let mut open: Vec<usize> = Vec::new();
    for at in order {
        open.retain(|other| boxes[*other][0][1] >= boxes[at][0][0]);
        let found = open.iter().find(|other| {
            let overlap = |i: usize| {
                let ([a, b], [c, d]) = (boxes[at][i], boxes[**other][i]);
                a <= d && c <= b
            };
            overlap(1)
                && overlap(2)
                && (goes_through(solid, at, **other) || goes_through(solid, **other, at))
        });
        if let Some(other) = found {
            return Some([at.min(*other), at.max(*other)]);
        }
        open.push(at);
    }
    None
}

/// Whether an edge of the first triangle goes through the inside of the second one.
fn goes_through(solid: &Solid, first: usize, second: usize) -> bool {
    let (corners, others) = (solid.triangles()[first], solid.triangles()[second]);
    let point = |v: u32| {
        let [x, y, z] = solid.vertices()[v as usize];
        Coord3D { x, y, z }
    };
    let [a, b, c] = others.map(point);
    (0..3).any(|i| {
        let ends = [corners[i], corners[(i + 1) % 3]];
        if ends.iter().any(|v| others.contains(v)) {
            return false;
        }
        let [p, q] = ends.map(point);
        let (above, below) = (orient3d(a, b, c, p), orient3d(a, b, c, q));
        if above * below >= 0.0 && !(above > 0.0 && below < 0.0 || above < 0.0 && below > 0.0) {
            return false;
        }
        let sides = [
            orient3d(p, q, a, b),
            orient3d(p, q, b, c),
            orient3d(p, q, c, a),
        ];
        sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0)
    })
}
