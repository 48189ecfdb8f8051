//! The distinct real roots of several polynomials, apart from each other, and rational numbers between them.

use malachite::Integer;
use malachite::base::num::basic::traits::One;
use malachite::base::polynomial::Polynomial;

use super::all_roots::{real_roots, sort_distinct};
use super::real_root::RealRoot;
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, divide_exactly, polynomial_gcd};

/// The distinct real roots of some polynomials, ascending.
pub(crate) fn distinct_roots<'a>(
    polynomials: impl Iterator<Item = &'a IntegerPolynomial>,
) -> Vec<RealRoot> {
    let mut roots: Vec<RealRoot> = Vec::new();
    let mut product = IntegerPolynomial::from_coefficients_asc(vec![Integer::ONE]);
    for g in polynomials {
        let common = polynomial_gcd(&product, g);
        let new = divide_exactly(g, &common).invariant("a common divisor divides");
        roots.extend(real_roots(&new));
        product *= new;
    }
    sort_distinct(&mut roots);
    roots
}

/// The roots with disjoint enclosures.
pub(crate) fn disjoint(mut roots: Vec<RealRoot>) -> Vec<RealRoot> {
    for i in 1..roots.len() {
        let mut bits = 4;
        while roots[i - 1].enclosure().1 >= roots[i].enclosure().0 {
            roots[i - 1].refine_to_width(-bits);
            roots[i].refine_to_width(-bits);
            bits *= 2;
        }
    }
    roots
}

/// Rational numbers below, between and above roots with disjoint enclosures; 0 if there are no roots.
pub(crate) fn between(roots: &[RealRoot]) -> Vec<Rational> {
    let bounds: Vec<[Rational; 2]> = roots
        .iter()
        .map(|r| [r.enclosure().0.to_rational(), r.enclosure().1.to_rational()])
        .collect();
    let (Some([first, _]), Some([_, last])) = (bounds.first(), bounds.last()) else {
        return vec![Rational::zero()];
    };
    let mut points = vec![first.floor() - Rational::one()];
    let pairs = bounds.windows(2);
    points.extend(pairs.map(|pair| strictly_between(&pair[0][1], &pair[1][0])));
    points.push(last.floor() + Rational::from(2));
    points
}

/// The simplest rational number in the middle half of the interval (low, high).
pub(crate) fn strictly_between(low: &Rational, high: &Rational) -> Rational {
    let quarter = (high - low) / Rational::from(4);
    Rational::simplest_between(&(low + &quarter), &(high - &quarter))
}
