//! The asymptotes of a plane curve.

use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, PlanePolynomial, coefficients};
use crate::roots::{RealRoot, real_roots};
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Derivative;

/// A straight line that a real branch of the curve approaches far away from the origin.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Asymptote {
    /// The slope dy/dx; `None` for a vertical line.
    pub slope: Option<RealRoot>,
    /// y at x = 0, or x for a vertical line, within bounds; both are equal if it is known exactly.
    pub intercept: [Rational; 2],
}

/// The directions in which the curve goes to infinity, and its asymptotes there.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct AtInfinity {
    /// The asymptotes, by ascending slopes; vertical ones are last.
    pub asymptotes: Vec<Asymptote>,
    /// The slopes (`None`: vertical) of real points at infinity at which the asymptotes are not decided, because the line at
    /// infinity touches the curve there or the point is singular.
    pub undecided: Vec<Option<RealRoot>>,
}

/// The width of the enclosures of irrational intercepts, as a power of two.
const INTERCEPT_BITS: i64 = -64;

/// The asymptotes of the curve f = 0, where f is squarefree.
///
/// With f = Σ f_d: at a simple zero τ of f_n(1, t), the branch approaches y = τx + c with c = −f_(n−1)(1, τ)/f_n′(1, τ). At a multiple
/// rational zero, f(x, τx + c) is a polynomial in x whose first coefficient that is not 0 is a polynomial in c. If c is a simple real
/// zero of it, a real branch approaches the line; if that coefficient is constant, there is no asymptote in this direction (the
/// branches are parabolic).
pub(super) fn at_infinity(f: &PlanePolynomial) -> AtInfinity {
    let mut found = AtInfinity::default();
    let degree = f.degree().invariant("the polynomial is not 0");
    let empty = IntegerPolynomial::ZERO;
    let part = |d: Option<usize>| {
        d.and_then(|d| f.part(d))
            .map_or(&empty, |form| form.dehomogenized())
    };
    let top = part(Some(degree));
    let next = part(degree.checked_sub(1));
    for slope in real_roots(top) {
        if slope.multiplicity() == 1 {
            let intercept = quotient(next, &top.derivative(), &slope);
            found.asymptotes.push(Asymptote {
                slope: Some(slope),
                intercept,
            });
        } else {
            match slope.as_rational() {
                Some(rational) => {
                    let intercepts = parallel(f, &rational);
                    found.add(Some(&slope), intercepts);
                }
                None => found.undecided.push(Some(slope)),
            }
        }
    }
    // The vertical direction is a zero of f_n(0, 1).
    let lost = degree + 1 - top.coefficients_asc().len();
    if lost > 0 {
        let turned = PlanePolynomial::from_terms(f.terms().map(|((i, j), c)| ((j, i), c)));
        found.add(None, parallel(&turned, &Rational::zero()));
    }
    found
}

impl AtInfinity {
    fn add(&mut self, slope: Option<&RealRoot>, intercepts: Vec<RealRoot>) {
        if intercepts.iter().any(|c| c.multiplicity() > 1) {
            self.undecided.push(slope.cloned());
        }
        for mut c in intercepts.into_iter().filter(|c| c.multiplicity() == 1) {
            let bounds = match c.as_rational() {
                Some(c) => [c.clone(), c],
                None => {
                    c.refine_to_width(INTERCEPT_BITS);
                    let (low, high) = c.bounds();
                    [low, high]
                }
            };
            self.asymptotes.push(Asymptote {
                slope: slope.cloned(),
                intercept: bounds,
            });
        }
    }
}

/// The real zeros c of the first coefficient in x of f(x, τx + c).
fn parallel(f: &PlanePolynomial, slope: &Rational) -> Vec<RealRoot> {
    // f(x, (p/q) x + c) with x = q·s: f(q s, p s + c), whose terms are collected by powers of s.
    let degree = f.degree().invariant("the polynomial is not 0");
    let mut rows: Vec<Vec<Rational>> = vec![Vec::new(); degree + 1];
    for ((i, j), coefficient) in f.terms() {
        let mut binomial = Rational::one();
        for k in 0..=j {
            // C(j, k) (τx)^(j−k) c^k x^i
            let power = slope.pow(i64::try_from(j - k).invariant("a degree is small"));
            let power = power.invariant("a natural power exists");
            let row = &mut rows[i + j - k];
            if row.len() <= k {
                row.resize(k + 1, Rational::zero());
            }
            row[k] = &row[k] + &(&coefficient * &(&binomial * &power));
            binomial = binomial * Rational::from(i64::try_from(j - k).invariant("small"))
                / Rational::from(i64::try_from(k + 1).invariant("small"));
        }
    }
    let first = rows
        .iter()
        .rev()
        .find(|row| row.iter().any(|c| !c.is_zero()));
    first.map_or_else(Vec::new, |row| RealRoot::all_of(row))
}

/// −g(τ)/h(τ) within bounds, for h(τ) ≠ 0.
fn quotient(g: &IntegerPolynomial, h: &IntegerPolynomial, at: &RealRoot) -> [Rational; 2] {
    if let Some(t) = at.as_rational() {
        let value = |f: &IntegerPolynomial| {
            let terms = coefficients(f);
            terms
                .iter()
                .rev()
                .fold(Rational::zero(), |v, c| v * &t + c)
        };
        let c = -(value(g) / value(h));
        return [c.clone(), c];
    }
    let mut root = at.clone();
    let width = Rational::one() / Rational::from(2).pow(-INTERCEPT_BITS).invariant("small");
    let mut bits = 64;
    loop {
        root.refine_to_width(-bits);
        let (low, high) = root.bounds();
        let above = super::strip::range(g, &low, &high);
        let below = super::strip::range(h, &low, &high);
        if below.0.signum() * below.1.signum() > 0 {
            let mut ends: Vec<Rational> = [&above.0, &above.1]
                .into_iter()
                .flat_map(|a| [&below.0, &below.1].map(|b| -(a / b)))
                .collect();
            ends.sort();
            let (first, last) = (ends[0].clone(), ends[3].clone());
            if &last - &first < width {
                return [first, last];
            }
        }
        bits *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(terms: &[((usize, usize), i64)]) -> PlanePolynomial {
        PlanePolynomial::from_terms(terms.iter().map(|&(e, c)| (e, Rational::from(c))))
    }

    #[test]
    fn hyperbolas_and_parabolas() {
        // x y = 1: both axes
        let found = at_infinity(&curve(&[((1, 1), 1), ((0, 0), -1)]));
        assert_eq!(found.asymptotes.len(), 2);
        assert!(found.asymptotes[1].slope.is_none());
        // y = x²: none, and nothing is undecided
        let found = at_infinity(&curve(&[((2, 0), 1), ((0, 1), -1)]));
        assert!(found.asymptotes.is_empty() && found.undecided.is_empty());
        // The folium x³ + y³ = 3xy approaches x + y + 1 = 0.
        let found = at_infinity(&curve(&[((3, 0), 1), ((0, 3), 1), ((1, 1), -3)]));
        assert_eq!(found.asymptotes[0].intercept[0], Rational::from(-1));
    }
}
