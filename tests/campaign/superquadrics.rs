//! Superquadrics in the plane: r, x and y are nearest doubles, by integer roots at the points where rounding changes.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};
use stellate::sample::{Ray, solve_radial};
use stellate::shape::Superquadric;

use super::draw::Draw;
use super::exact::{Q, num, our, rounding_interval};
use super::harness::Outcome;

/// The order of α^(1/q) + β^(1/q) and c, by roots of integers; `None` if 600 bits do not tell.
fn compare(alpha: &Q, beta: &Q, q: u32, level: &Q) -> Option<Ordering> {
    let bits = 600u32;
    let floor = |a: &Q| ((a.numer() << (bits * q)) / a.denom()).nth_root(q);
    let sum = floor(alpha) + floor(beta);
    let scaled = level * Q::from_integer(BigInt::one() << bits);
    if Q::from_integer(sum.clone()) > scaled {
        return Some(Ordering::Greater);
    }
    if Q::from_integer(sum + BigInt::from(2)) < scaled {
        return Some(Ordering::Less);
    }
    None
}

pub(crate) fn plane(draw: &mut Draw) -> Outcome {
    let positive =
        |draw: &mut Draw| Q::new((1 + draw.below(30)).into(), (1 + draw.below(9)).into());
    let axes = [positive(draw), positive(draw)];
    let level = positive(draw);
    let epsilon = Q::new((1 + draw.below(8)).into(), (1 + draw.below(8)).into());
    let exponent = Q::from_integer(2.into()) / &epsilon;
    let [p, q] = [exponent.numer(), exponent.denom()].map(|n| u32::try_from(n.clone()).unwrap());
    let shape = Superquadric::new(axes.each_ref().map(our), our(&epsilon), our(&level)).unwrap();
    let theta = draw.below(1 << 50) as f64 / (1u64 << 47) as f64;
    draw.input = format!("{shape:?} --theta {theta}");
    let direction = stellate::sample::Direction::from_radians(theta);
    let [u, v] = [num(&direction.u()), num(&direction.v())];
    let Ok(Ray::Points(points)) = solve_radial(&shape, &direction) else {
        return Outcome::Open;
    };
    assert_eq!(points.len(), 2);
    assert_eq!(points[0].r, -points[1].r);
    let at = |r: &Q| {
        let base = |w: &Q, a: &Q| {
            let base = (r * w / a).abs();
            (0..p).fold(Q::one(), |power, _| power * &base)
        };
        compare(&base(&u, &axes[0]), &base(&v, &axes[1]), q, &level)
    };
    let factors = [Q::one(), u.clone(), v.clone()];
    let [x, y] = points[0].position;
    for (double, factor) in [points[0].r, x, y].into_iter().zip(&factors) {
        if factor.is_zero() {
            assert_eq!(double, 0.0);
            continue;
        }
        let [low, high] = rounding_interval(double).map(|end| end / factor);
        let (low, high) = if low < high { (low, high) } else { (high, low) };
        assert!(at(&low) != Some(Ordering::Greater), "{double} is too large");
        assert!(at(&high) != Some(Ordering::Less), "{double} is too small");
    }
    Outcome::Checked
}
