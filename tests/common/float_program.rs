//! Coefficients as a correct float program has them, and radii with mistakes.

use stellate::check::{Comparison, Reference};
use stellate::exact::Rational;
use stellate::poly::SparsePolynomial;
use stellate::shape::FourierRadius;

use super::oracle_theorem_2::theorem_2;

pub(crate) type Terms = Vec<([u32; 3], f64)>;

/// F of a radius by the printed formula over num-rational, every coefficient rounded to a double.
pub(crate) fn rounded(radius: &FourierRadius) -> Terms {
    let exponent = |e: usize| u32::try_from(e).unwrap();
    let terms = theorem_2(radius).into_iter();
    terms
        .map(|((i, j), c)| ([exponent(i), exponent(j), 0], Rational::from(c).to_f64()))
        .collect()
}

pub(crate) fn polynomial(terms: &Terms) -> SparsePolynomial<3> {
    let exact = |c: f64| Rational::try_from(c).unwrap();
    SparsePolynomial::from_terms(terms.iter().map(|(e, c)| (*e, exact(*c))))
}

pub(crate) fn checked(reference: &FourierRadius, got: &Terms) -> Comparison {
    Reference::of_radius(reference)
        .unwrap()
        .check_coefficients(&polynomial(got))
}

/// r = 1 + cos(t)/4 + sin(t)/7 + cos(2t)/9 − sin(2t)/11 + cos(3t)/13 + sin(3t)/8: no symmetry hides a mistake.
pub(crate) fn lopsided() -> FourierRadius {
    let fraction = |(p, q): (i64, i64)| Rational::from(p) / Rational::from(q);
    FourierRadius::new(
        [(1, 1), (1, 4), (1, 9), (1, 13)].map(fraction).to_vec(),
        [(0, 1), (1, 7), (-1, 11), (1, 8)].map(fraction).to_vec(),
    )
}

pub(crate) fn names(found: &Comparison) -> Vec<&str> {
    found.diagnoses.iter().map(|d| &*d.name).collect()
}

/// The radius with other coefficients, by a function of n, a_n and b_n.
pub(crate) fn changed(
    radius: &FourierRadius,
    f: impl Fn(usize, f64, f64) -> [f64; 2],
) -> FourierRadius {
    let pairs = radius.cosines().iter().zip(radius.sines()).enumerate();
    let exact = |v: f64| Rational::try_from(v).unwrap();
    let (cos, sin) = pairs
        .map(|(n, (a, b))| {
            let [a, b] = f(n, a.to_f64(), b.to_f64());
            (exact(a), exact(b))
        })
        .unzip();
    FourierRadius::new(cos, sin)
}
