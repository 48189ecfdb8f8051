//! The coordinates between which all bounded pieces of a surface lie, by critical values.

use malachite::base::polynomial::Polynomial;

use super::extent::BoxSides;
use crate::error::Result;
use crate::factor::{coprime_parts, factor_space, greatest_common_divisor};
use crate::intervals::Interval;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, IntegerTerms, SparsePolynomial, resultant, resultant_work};
use crate::roots::{RealRoot, real_roots};

/// The largest number of operations of one elimination; that many take some tenths of a second.
const MAX_WORK: f64 = 2e8;
/// Larger surfaces are not examined.
const MAX_SURFACE_DEGREE: u64 = 12;
const MAX_TERMS: usize = 200;
/// The largest degree of an eliminant whose roots are isolated.
const MAX_DEGREE: u64 = 400;

/// The place of the bounded pieces of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Pieces {
    /// There is no bounded piece.
    Nowhere,
    /// All of them are in this box.
    Within(BoxSides),
}

/// Finds a box that holds all bounded connected pieces of the surface f = 0; `None` if that takes too much work, or if the
/// critical points of a coordinate are not finitely many.
///
/// Lemma 2. Let v be a coordinate, and let f_u and f_w be the derivatives in the two other ones. On a bounded piece v is between
/// the least and the largest value that it has at common zeros of f, f_u and f_w; if there are none, then no piece is bounded.
/// Proof. A piece is closed, so on a bounded one v has a largest and a least value. Where f_u or f_w is not 0, the surface is a
/// graph over a neighbourhood in v and a second coordinate, so v is not extreme there.
/// Test: `the_default_box_holds_all_bounded_pieces`.
///
/// # Errors
/// Those of `limits`.
pub(super) fn bounded_pieces(f: &SparsePolynomial<3>, limits: &Limits) -> Result<Option<Pieces>> {
    if f.degree() > Some(MAX_SURFACE_DEGREE) || f.len() > MAX_TERMS {
        return Ok(None);
    }
    let mut bounds = [[0.0; 2]; 3];
    for (axis, side) in bounds.iter_mut().enumerate() {
        limits.check()?;
        match critical_values(f, axis, limits)? {
            None => return Ok(None),
            Some(values) => match values.first().zip(values.last()) {
                None => return Ok(Some(Pieces::Nowhere)),
                Some((first, last)) => *side = [value(first).low(), value(last).high()],
            },
        }
    }
    Ok(Some(Pieces::Within(bounds)))
}

/// An interval that holds a root.
fn value(root: &RealRoot) -> Interval {
    let mut root = root.clone();
    root.refine(60);
    let (low, high) = root.bounds();
    Interval::between(Interval::from(&low).low(), Interval::from(&high).high())
}

/// Real numbers in ascending order among which are all values of a coordinate at the common zeros of Lemma 2.
fn critical_values(
    f: &SparsePolynomial<3>,
    v: usize,
    limits: &Limits,
) -> Result<Option<Vec<RealRoot>>> {
    let slopes = [(v + 1) % 3, (v + 2) % 3].map(|other| f.derivative(other));
    if slopes.iter().any(SparsePolynomial::is_empty) {
        // A cylinder has no bounded piece.
        return Ok(Some(Vec::new()));
    }
    let [first, second] = slopes;
    let [first, second] = [
        factor_space(&first, limits)?.factors,
        factor_space(&second, limits)?.factors,
    ];
    let mut roots = Vec::new();
    for p in &first {
        for q in &second {
            let mut system = vec![f.clone(), p.polynomial.clone()];
            if p.polynomial != q.polynomial {
                system.push(q.polynomial.clone());
            }
            let Some(eliminants) = eliminants(&system, v, limits)? else {
                return Ok(None);
            };
            for eliminant in eliminants {
                if eliminant.degree().is_some_and(|degree| degree > MAX_DEGREE) {
                    return Ok(None);
                }
                roots.extend(real_roots(&eliminant));
            }
        }
    }
    roots.sort_unstable_by(|a, b| value(a).middle().total_cmp(&value(b).middle()));
    Ok(Some(roots))
}

/// Polynomials in v, not 0, such that one of them vanishes wherever all polynomials of the system do.
fn eliminants(
    system: &[SparsePolynomial<3>],
    v: usize,
    limits: &Limits,
) -> Result<Option<Vec<IntegerPolynomial>>> {
    let degree = |k: usize| move |f: &SparsePolynomial<3>| f.degree_in(k);
    let [a, b] = [(v + 1) % 3, (v + 2) % 3];
    let total = |k: usize| system.iter().map(degree(k)).sum::<u32>();
    let (w, u) = if total(a) < total(b) { (a, b) } else { (b, a) };
    let (mut above, mut plane): (Vec<_>, Vec<_>) =
        system.iter().cloned().partition(|f| f.degree_in(w) > 0);
    above.sort_unstable_by_key(degree(w));
    for (k, f) in above.iter().enumerate() {
        for g in &above[k + 1..] {
            match cheap_resultant(f, g, w, limits)? {
                Some(found) => plane.push(found),
                None => return Ok(None),
            }
        }
    }
    plane.retain(|f| !f.is_empty());
    // The common zeros of the first polynomials are those of their common divisor and those of the quotients.
    let mut rest = match plane.pop() {
        Some(first) => first,
        None => return Ok(None),
    };
    let mut found = Vec::new();
    while rest.degree_in(u) > 0 {
        let Some(next) = plane.pop() else {
            return Ok(None);
        };
        let common = greatest_common_divisor(&rest, &next, limits)?;
        let [p, q] = coprime_parts([&rest, &next], limits)?;
        let free = [&p, &q].into_iter().find(|f| f.degree_in(u) == 0);
        match free {
            Some(free) => found.push(free.clone()),
            None => match cheap_resultant(&p, &q, u, limits)? {
                Some(eliminant) if !eliminant.is_empty() => found.push(eliminant),
                _ => return Ok(None),
            },
        }
        rest = common;
    }
    found.push(rest);
    let univariate =
        |f: &SparsePolynomial<3>| IntegerTerms::of_numerators(&f.primitive()).to_univariate(v);
    Ok(Some(found.iter().map(univariate).collect()))
}

fn cheap_resultant(
    f: &SparsePolynomial<3>,
    g: &SparsePolynomial<3>,
    v: usize,
    limits: &Limits,
) -> Result<Option<SparsePolynomial<3>>> {
    if resultant_work(f, g, v) > MAX_WORK {
        return Ok(None);
    }
    resultant(f, g, v, limits).map(Some)
}
