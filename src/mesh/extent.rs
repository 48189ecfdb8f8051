//! A certified box around the zero set of a polynomial, where it is proved that nothing lies outside.

use malachite::base::num::arithmetic::traits::Lcm;

use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::intervals::{BoxBounds, Field};
use crate::limits::Limits;
use crate::poly::SparsePolynomial;

/// The sides of a box: the smallest and the largest x, then y and z.
pub type BoxSides = [[f64; 2]; 3];

/// What is proved about the place of a zero set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Extent {
    /// There is no real zero.
    Empty,
    /// All zeros are in this box.
    Within(BoxSides),
    /// All zeros are in this box, which is tiny compared with the coordinates in which it was found: they are a point, or hardly more.
    Tiny(BoxSides),
    /// The zero set may be unbounded.
    Unknown,
}

/// The largest number of parts that are examined for one proof, for a polynomial whose expansion takes little work; others get
/// proportionally fewer, so that the time is bounded.
const PARTS: usize = 60_000;
const LITTLE_WORK: usize = 600;
/// The part of [`PARTS`] that may be spent on one radius before the next one is tried.
const SHARE_OF_A_RADIUS: usize = 16;
/// The exponents of the radii that are tried, as powers of two.
const SMALLEST_RADIUS: i32 = -8;
const LARGEST_RADIUS: i32 = 48;
/// The box fits the zero set up to this part of its longest side.
const FIT: f64 = 1.0 / 64.0;
/// A zero set that is smaller than this part of the first box is not enclosed more tightly.
const TINY: f64 = 1e-9;
/// The largest sum of weights times exponents. Weights of forms that occur are far smaller.
const LARGEST_WEIGHT: u32 = 240;

/// Finds a box that holds all real zeros of f. `seen` are known sizes of coordinates of zeros; they save work, and the result does
/// not depend on their being right.
///
/// Lemma 1. Let w be three positive weights with w·e ≤ D for all exponents e of f, and let G(u, s) = Σ c_e u^e s^(D − w·e). If G
/// has no zero with max |u_i| = 1 and 0 ≤ s ≤ S, then |x_i| < S^(−w_i) for all i at every zero x of f.
/// Proof. A point x ≠ 0 is x_i = u_i ρ^(w_i) with ρ = max |x_i|^(1/w_i) and max |u_i| = 1, and f(x) = ρ^D G(u, 1/ρ). So ρ < 1/S
/// at a zero.
/// Law: `no_zero_is_outside_of_the_box`.
///
/// G can be without zeros at s = 0 only if each variable has a pure power among the terms of weight D, which determines the
/// weights. With equal weights G at s = 0 is the leading form of f.
///
/// # Errors
/// Those of `limits`.
pub(super) fn extent(
    f: &SparsePolynomial<3>,
    seen: Option<[f64; 3]>,
    limits: &Limits,
) -> Result<Extent> {
    let Some(weights) = weights(f) else {
        return Ok(Extent::Unknown);
    };
    let faces = faces(f, weights);
    // At s = 0 the faces of the cube at infinity are empty, or no radius will do.
    for face in &faces {
        let part = [[-1.0, 1.0], [-1.0, 1.0], [0.0, 0.0]];
        if !is_empty(face, part, parts_for(face), limits)? {
            return Ok(Extent::Unknown);
        }
    }
    let power = |k: i32, w: u32| {
        let weight = i32::try_from(w).invariant("a weight is a degree");
        2f64.powi(k.saturating_mul(weight))
    };
    let is_too_small = |k: i32| {
        let sizes = seen.iter().flat_map(|seen| seen.iter().zip(weights));
        sizes.into_iter().any(|(size, w)| *size > power(k, w))
    };
    for k in (SMALLEST_RADIUS..=LARGEST_RADIUS).filter(|&k| !is_too_small(k)) {
        let part = [[-1.0, 1.0], [-1.0, 1.0], [0.0, power(-k, 1)]];
        let mut holds = true;
        for face in &faces {
            holds = holds && is_empty(face, part, parts_for(face) / SHARE_OF_A_RADIUS, limits)?;
        }
        if holds {
            let first = weights.map(|w| [-power(k, w), power(k, w)]);
            return tightened(&Field::new(f), first, limits);
        }
    }
    Ok(Extent::Unknown)
}

/// The weights of Lemma 1, for which the pure powers of all three variables have the weight D; `None` if some term has a larger
/// weight, or if these powers already show that the terms of weight D have a zero.
fn weights(f: &SparsePolynomial<3>) -> Option<[u32; 3]> {
    let mut degrees = [0; 3];
    let mut signs = [0; 3];
    for (e, c) in f.terms() {
        for axis in 0..3 {
            let is_pure = (0..3).all(|other| other == axis || e[other] == 0);
            if is_pure && e[axis] > degrees[axis] {
                degrees[axis] = e[axis];
                signs[axis] = c.signum();
            }
        }
    }
    // An odd pure power changes its sign between the two ends of its axis.
    let is_definite = degrees.iter().all(|d| *d > 0 && d % 2 == 0) && signs[1..] == [signs[0]; 2];
    if !is_definite {
        return None;
    }
    let whole = degrees.iter().fold(1, |lcm: u32, d| lcm.lcm(*d));
    let weights = degrees.map(|d| whole / d);
    let weight = |e: &[u32; 3]| -> u64 {
        let products = e
            .iter()
            .zip(weights)
            .map(|(e, w)| u64::from(*e) * u64::from(w));
        products.sum()
    };
    let all_within = f.terms().all(|(e, _)| weight(e) <= u64::from(whole));
    (whole <= LARGEST_WEIGHT && all_within).then_some(weights)
}

/// The polynomial G of Lemma 1 on the six faces u_i = ±1, each in the two other u and in s.
fn faces(f: &SparsePolynomial<3>, weights: [u32; 3]) -> Vec<Field> {
    let weight = |e: &[u32; 3]| e.iter().zip(weights).map(|(e, w)| e * w).sum::<u32>();
    let whole = f.terms().map(|(e, _)| weight(e)).max().unwrap_or(0);
    let face = |axis: usize, sign: i64| {
        let [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
        Field::new(&SparsePolynomial::from_terms(f.terms().map(|(e, c)| {
            let sign = if e[axis] % 2 == 1 { sign } else { 1 };
            ([e[j], e[k], whole - weight(e)], c * &Rational::from(sign))
        })))
    };
    (0..3)
        .flat_map(|axis| [face(axis, 1), face(axis, -1)])
        .collect()
}

/// The number of parts that may be examined for a polynomial.
fn parts_for(field: &Field) -> usize {
    PARTS * LITTLE_WORK / field.work().max(LITTLE_WORK)
}

/// The middle of a part, and half sides that cover it in spite of rounding.
fn centered(part: BoxSides) -> ([f64; 3], [f64; 3]) {
    let middle = part.map(|[a, b]| f64::midpoint(a, b));
    let halves = std::array::from_fn(|i| {
        let [a, b] = part[i];
        (b - middle[i]).max(middle[i] - a).next_up()
    });
    (middle, halves)
}

/// The two halves of a part along an axis.
fn divided(part: BoxSides, axis: usize) -> [BoxSides; 2] {
    let [a, b] = part[axis];
    let middle = f64::midpoint(a, b);
    [[a, middle], [middle, b]].map(|side| {
        let mut half = part;
        half[axis] = side;
        half
    })
}

/// Whether it is proved that the polynomial has no zero in the box. Parts are halved along the variable that changes it most, at
/// most `most` times.
fn is_empty(field: &Field, part: BoxSides, most: usize, limits: &Limits) -> Result<bool> {
    let mut left = vec![part];
    let mut examined = 0;
    while let Some(part) = left.pop() {
        examined += 1;
        if examined > most {
            return Ok(false);
        }
        if examined % 256 == 0 {
            limits.check()?;
        }
        let (middle, halves) = centered(part);
        let bounds = field.on_box(middle, halves);
        if bounds.is_empty() {
            continue;
        }
        left.extend(divided(part, steepest(&bounds)));
    }
    Ok(true)
}

/// The box of the parts of a box in which zeros cannot be excluded. Only parts at the faces of this box are halved, until they are
/// small compared with it.
fn tightened(field: &Field, first: BoxSides, limits: &Limits) -> Result<Extent> {
    let longest = |b: &BoxSides| b.iter().fold(0.0, |l: f64, [a, b]| l.max(b - a));
    let least = TINY * longest(&first);
    let mut parts = vec![first];
    let mut examined = 0;
    loop {
        limits.check()?;
        let Some(around) = around(&parts) else {
            return Ok(Extent::Empty);
        };
        let fit = FIT * longest(&around);
        let is_wide = |part: &BoxSides| {
            (0..3).any(|axis| {
                let ([a, b], [low, high]) = (part[axis], around[axis]);
                b - a > fit && (a < low + fit || b > high - fit)
            })
        };
        let (wide, narrow): (Vec<BoxSides>, Vec<BoxSides>) = parts.into_iter().partition(is_wide);
        examined += 2 * wide.len();
        if longest(&around) <= least {
            return Ok(Extent::Tiny(around));
        }
        if wide.is_empty() || examined > parts_for(field) {
            return Ok(Extent::Within(around));
        }
        parts = narrow;
        for part in wide {
            let (middle, halves) = centered(part);
            let axis = steepest(&field.on_box(middle, halves));
            for half in divided(part, axis) {
                let (middle, halves) = centered(half);
                if !field.on_box(middle, halves).is_empty() {
                    parts.push(half);
                }
            }
        }
    }
}

/// The axis along which the polynomial changes most on a part.
fn steepest(bounds: &BoxBounds) -> usize {
    let [x, y, z] = [0, 1, 2].map(|axis| bounds.slope(axis).magnitude());
    if x >= y && x >= z {
        0
    } else if y >= z {
        1
    } else {
        2
    }
}

/// The box around several boxes.
pub(super) fn around(parts: &[BoxSides]) -> Option<BoxSides> {
    parts.iter().copied().reduce(joined)
}

/// The box around two boxes.
pub(super) fn joined(a: BoxSides, b: BoxSides) -> BoxSides {
    std::array::from_fn(|i| [a[i][0].min(b[i][0]), a[i][1].max(b[i][1])])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intervals::rationals;
    use crate::poly::Ring;
    use proptest::prelude::*;

    fn space(text: &str) -> SparsePolynomial<3> {
        let form = crate::language::parse_form(text, "a test", crate::language::Numbers::Exact);
        match form {
            Ok(crate::shape::Form::Surface(surface)) => surface.polynomial().clone(),
            other => panic!("{text} is no surface: {other:?}"),
        }
    }

    fn of(text: &str) -> Extent {
        extent(&space(text), None, &Limits::none()).expect("no limit")
    }

    fn is_near(found: Extent, expected: BoxSides) -> bool {
        let Extent::Within(found) = found else {
            return false;
        };
        let longest = expected.iter().fold(0.0, |l: f64, [a, b]| l.max(b - a));
        found.iter().zip(expected).all(|([a, b], [c, d])| {
            *a <= c && c - a < 0.06 * longest && *b >= d && b - d < 0.06 * longest
        })
    }

    #[test]
    fn bounded_surfaces_have_tight_boxes() {
        for (text, expected) in [
            ("x^2+y^2+z^2-1", [[-1.0, 1.0]; 3]),
            ("x^2+y^2+100z^2-1", [[-1.0, 1.0], [-1.0, 1.0], [-0.1, 0.1]]),
            (
                "(x-10)^2+y^2+z^2-1",
                [[9.0, 11.0], [-1.0, 1.0], [-1.0, 1.0]],
            ),
            ("x^2+y^4+z^6-64", [[-8.0, 8.0], [-2.83, 2.83], [-2.0, 2.0]]),
            // The leading form vanishes in a plane, yet the surface is bounded.
            (
                "(x*(x-1)^2*(x-2)+y^2)^2+z^2-1/100",
                [[-0.05, 2.05], [-0.5, 0.5], [-0.1, 0.1]],
            ),
        ] {
            let found = of(text);
            assert!(is_near(found, expected), "{text}: {found:?}");
        }
        assert_eq!(of("x^2+y^2+z^2+1"), Extent::Empty);
        for text in [
            "x^2+y^2-z^2-1",
            "x^2+y^2-1+0z",
            "x^2*y^2+y^2*z^2+z^2*x^2-x*y*z",
            "z-x*y",
        ] {
            assert_eq!(of(text), Extent::Unknown, "{text}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

        /// Lemma 1: no point at which f has another sign than far away is outside of the box.
        #[test]
        fn no_zero_is_outside_of_the_box(
            c in prop::collection::vec(-9i64..10, 20),
            points in prop::collection::vec(prop::array::uniform3(-40.0f64..40.0), 50),
        ) {
            let leading = space("x^4+2y^4+z^4+x^2*y^2");
            let mut lower = SparsePolynomial::zero();
            let mut at = c.into_iter();
            for i in 0..4u32 {
                for j in 0..4 - i {
                    for k in 0..4 - i - j {
                        lower.add_term([i, j, k], Rational::from(at.next().expect("20 coefficients")));
                    }
                }
            }
            let f = leading.plus(&lower);
            match extent(&f, None, &Limits::none()).expect("no limit") {
                Extent::Unknown => prop_assert!(false, "the leading form is definite"),
                Extent::Empty => for p in points {
                    prop_assert!(f.evaluate(&rationals(p)).signum() > 0);
                },
                Extent::Within(bounds) | Extent::Tiny(bounds) => for p in points {
                    let is_outside = (0..3).any(|i| p[i] < bounds[i][0] || p[i] > bounds[i][1]);
                    prop_assert!(!is_outside || f.evaluate(&rationals(p)).signum() > 0, "{:?}", p);
                },
            }
        }
    }
}
