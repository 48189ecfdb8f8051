//! Separates two real roots that are very close together, or shows that there are none where two conjugate roots are very close
//! to the real axis.
//!
//! The sign at the extremum decides. Bisection would take one step for every bit of the distance; the extremum is refined in a
//! number of steps that is the logarithm of the number of bits.

use std::sync::Arc;

use malachite::Integer;
use malachite::base::polynomial::Derivative;

use super::RealRoot;
use crate::error::Invariant;
use crate::exact::Dyadic;
use crate::poly::{IntegerPolynomial, leading_value, sign_at};

/// Intervals that hold one root each of a squarefree f in (low, high), or `Err` with a root that is a dyadic number. The caller
/// must ensure that f″ has the sign `convex` on the whole interval and that f is not 0 at the ends.
pub(super) fn separate(
    f: &IntegerPolynomial,
    (low, high): (Dyadic, Dyadic),
    convex: i8,
) -> Result<Vec<(Dyadic, Dyadic)>, Dyadic> {
    let sign_low = sign_at(f, &low);
    if sign_low != sign_at(f, &high) {
        return Ok(vec![(low, high)]);
    }
    let slope = f.derivative();
    let falls_then_rises = sign_at(&slope, &low) == -convex && sign_at(&slope, &high) == convex;
    // Let `convex` be 1. A convex function is below its chord, so it has no root inside if it is negative at both ends. If it is
    // positive there, it can only have roots if its least value is inside, where its slope changes sign.
    if sign_low != convex || !falls_then_rises {
        return Ok(Vec::new());
    }
    let slope = Arc::new(slope);
    let mut least = RealRoot::between(&slope, (low.clone(), high.clone()), -convex, 1);
    let mut bits = 64;
    loop {
        least.refine(bits);
        let (a, b) = least.enclosure();
        for point in [a, b] {
            match sign_at(f, point) {
                0 => return Err(point.clone()),
                sign if sign != convex => {
                    return Ok(vec![
                        around(f, &slope, point, &low, -1),
                        around(f, &slope, point, &high, 1),
                    ]);
                }
                _ => {}
            }
        }
        // The least value is between a and b, and f is above its tangent at a: f ≥ f(a) − |f′(a)| (b − a) there. If f(a) is larger
        // than this drop (16 times, for the errors of the logarithms), f has no root.
        let size = |g: &IntegerPolynomial| {
            let (m, e) = leading_value(g, a, 2);
            Dyadic::new(m, e).log2()
        };
        let drop = size(&slope).zip(b.minus(a).log2()).map(|(s, w)| s + w + 4);
        if drop.is_none_or(|drop| size(f).is_some_and(|size| size - 1 > drop)) {
            return Ok(Vec::new());
        }
        bits *= 2;
    }
}

/// A short interval that holds the root between `point`, which is near the extremum, and `end`, which is on the given side of it.
/// It is short because the root is at a distance of about `√(2 |f / f″|)` from the extremum.
fn around(
    f: &IntegerPolynomial,
    slope: &IntegerPolynomial,
    point: &Dyadic,
    end: &Dyadic,
    side: i64,
) -> (Dyadic, Dyadic) {
    let inside = sign_at(f, point);
    let size = |g: &IntegerPolynomial| {
        let (m, e) = leading_value(g, point, 2);
        let size = Dyadic::new(m, e).log2();
        size.invariant("neither f nor its second derivative is 0 beside the extremum")
    };
    let mut exponent = (size(f) - size(&slope.derivative())).div_euclid(2) + 2;
    let beyond = |point: &Dyadic| if side < 0 { point <= end } else { point >= end };
    let outer = loop {
        let step = Dyadic::new(Integer::from(side), exponent);
        let outer = point.plus(&step);
        if beyond(&outer) {
            break end.clone();
        }
        if sign_at(f, &outer) == -inside {
            break outer;
        }
        exponent += 1;
    };
    if side < 0 {
        (outer, point.clone())
    } else {
        (point.clone(), outer)
    }
}
