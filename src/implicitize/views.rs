//! The views of a curve in which its isolated points are searched: projections to a plane, and changes of the parameter.

use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::tracing::tracing_index_bound;
use crate::error::Invariant;
use crate::poly::{IntegerPolynomial, RationalFunction, Ring};

/// Changes of the parameter that are tried, `(a u + b)/(c u + d)` for s. After a change, two pairs of conjugate parameters that
/// had the same sum have different sums.
pub(super) const CHANGES: [[i64; 4]; 3] = [[1, 0, 0, 1], [1, 2, 3, 5], [7, -3, 2, 11]];

/// The projections of the curve to a plane that are tried: a plane curve itself; of a curve in space those that trace the
/// projected curve once, first along an axis and of small degree, at last an oblique one.
pub(super) fn projections(coordinates: &[&RationalFunction]) -> Vec<[RationalFunction; 2]> {
    match *coordinates {
        [x, y] => vec![[x.clone(), y.clone()]],
        [x, y, z] => {
            let mut all = vec![[x, y], [x, z], [y, z]];
            all.sort_by_key(|pair| pair[0].degree() + pair[1].degree());
            let mut all: Vec<_> = all
                .into_iter()
                .map(|pair| pair.map(RationalFunction::clone))
                .collect();
            all.push([x.plus(z), y.plus(&z.plus(z))]);
            all.retain(|pair| tracing_index_bound(pair) == 1);
            all
        }
        _ => Vec::new(),
    }
}

/// The function f((a u + b)/(c u + d)) of u.
pub(super) fn changed_parameter(f: &RationalFunction, [a, b, c, d]: [i64; 4]) -> RationalFunction {
    if [a, b, c, d] == CHANGES[0] {
        return f.clone();
    }
    let line = |low: i64, high: i64| {
        IntegerPolynomial::from_coefficients_asc(vec![low.into(), high.into()])
    };
    let (above, below) = (line(b, a), line(d, c));
    let degree = f.degree();
    let form = |p: &IntegerPolynomial| {
        let mut value = IntegerPolynomial::ZERO;
        let mut power = IntegerPolynomial::from_coefficients_asc(vec![1.into()]);
        for k in (0..=degree).rev() {
            value *= &above;
            if let Some(c) = p.coefficients_asc().get(k) {
                value += IntegerPolynomial::from_coefficients_asc(vec![c.clone()]) * &power;
            }
            power *= &below;
        }
        value
    };
    RationalFunction::from_integers(form(f.numerator()), form(f.denominator()))
        .invariant("a change of the parameter is invertible")
}
