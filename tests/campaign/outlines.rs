//! Outlines: seen from a center, and what is inside, by exact cross products.

use std::cmp::Ordering;

use num_traits::Zero;
use stellate::fit::star_shaped_about;
use stellate::shape::Contour;

use super::draw::Draw;
use super::exact::{Q, value};
use super::harness::Outcome;

/// The sign of the turn from a over b to c.
fn turn(a: &[Q; 2], b: &[Q; 2], c: &[Q; 2]) -> Ordering {
    let cross = (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0]);
    cross.cmp(&Q::zero())
}

pub(crate) fn outlines(draw: &mut Draw) -> Outcome {
    let count = 3 + draw.index(9);
    let size = draw.pick(&[3, 10, 1000]);
    let around = draw.once_in(2);
    let mut points: Vec<[f64; 2]> = (0..count)
        .map(|_| [draw.small(size) as f64, draw.small(size) as f64])
        .collect();
    if around {
        points.sort_by(|p, q| p[1].atan2(p[0]).total_cmp(&q[1].atan2(q[0])));
        points.dedup();
    }
    let scale = draw.double(20).abs();
    for p in &mut points {
        *p = p.map(|x| x * scale);
    }
    let mut center = [0; 2].map(|_: i32| draw.small(2 * size) as f64 / 4.0 * scale);
    match draw.below(4) {
        // On an edge, or beside it.
        0 => {
            let i = draw.index(points.len());
            let (p, q) = (points[i], points[(i + 1) % points.len()]);
            center = [0, 1].map(|k| p[k] / 2.0 + q[k] / 2.0);
            // Numbers that are smaller than any coordinate may be are refused.
            center[0] = match draw.below(3) {
                _ if center[0] == 0.0 => 0.0,
                0 => center[0].next_up(),
                1 => center[0].next_down(),
                _ => center[0],
            };
        }
        1 => center = [0.0; 2],
        2 => center = points[draw.index(points.len())],
        _ => {}
    }
    draw.input = format!("{points:?} about {center:?}");
    let Ok(contour) = Contour::new(points, "outline") else {
        return Outcome::Open;
    };
    let exact = |p: [f64; 2]| p.map(value);
    let c = exact(center);
    let all: Vec<[Q; 2]> = contour.points().iter().map(|p| exact(*p)).collect();
    let edges = || (0..all.len()).map(|i| (&all[i], &all[(i + 1) % all.len()]));
    let seen = edges().all(|(p, q)| turn(&c, p, q) == Ordering::Greater);
    assert_eq!(star_shaped_about(&contour, center), seen, "star-shaped");
    // Strictly inside: an odd number of edges is crossed to the right, and none is met.
    let on_edge = edges().any(|(p, q)| {
        let between = |k: usize| (p[k] <= c[k] && c[k] <= q[k]) || (q[k] <= c[k] && c[k] <= p[k]);
        turn(p, q, &c) == Ordering::Equal && between(0) && between(1)
    });
    let crossed = edges().filter(|(p, q)| {
        let (low, high) = if p[1] < q[1] { (p, q) } else { (q, p) };
        low[1] <= c[1] && c[1] < high[1] && turn(low, high, &c) == Ordering::Greater
    });
    let inside = !on_edge && crossed.count() % 2 == 1;
    assert_eq!(contour.contains(center), inside, "inside");
    let doubled = edges().fold(Q::zero(), |sum, (p, q)| sum + &p[0] * &q[1] - &p[1] * &q[0]);
    assert!(doubled > Q::zero(), "counter-clockwise");
    Outcome::Checked
}
