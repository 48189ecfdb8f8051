//! Compares the coefficients of a float program with the exact ones, term by term, up to one common factor.

use std::collections::BTreeMap;

use super::comparison::{Comparison, GivenNumber, Row};
use super::deviation::Deviation;
use super::scale::common_factor;
use crate::exact::Rational;
use crate::poly::{SparsePolynomial, total_degree};

/// Compares the coefficients of two polynomials up to one common factor, which [`Comparison::scale`] tells.
///
/// The coefficients of `got` are doubles; a term that is 0 there counts as missing. Cost: about n log n products of
/// coefficients.
///
/// ```
/// use stellate::check::compare_coefficients;
/// use stellate::language::{Numbers, parse_form};
/// use stellate::poly::SparsePolynomial;
/// use stellate::shape::Form;
///
/// let polynomial = |text, numbers| match parse_form(text, "<form>", numbers) {
///     Ok(Form::Curve(curve)) => SparsePolynomial::from(curve.polynomial()),
///     other => panic!("{other:?}"),
/// };
/// let exact = polynomial("3x^2 + y^2 - 0.3", Numbers::Exact);
/// let got = polynomial("1.5x^2 + 0.5y^2 - 0.15 + 1e-17x", Numbers::F64);
/// let found = compare_coefficients(&got, &exact);
/// assert_eq!(found.scale.as_ref().unwrap().factor.to_string(), "1/2");
/// assert_eq!((found.rows.len(), found.missing.len(), found.extra.len()), (3, 0, 1));
/// assert!(found.passes(Some(15)));
/// ```
#[must_use]
pub fn compare_coefficients(got: &SparsePolynomial<3>, exact: &SparsePolynomial<3>) -> Comparison {
    let mut rest: BTreeMap<[u32; 3], &Rational> = got.terms().map(|(e, c)| (*e, c)).collect();
    let mut common = Vec::new();
    let mut missing = Vec::new();
    for (exponents, c) in exact.terms() {
        match rest.remove(exponents) {
            Some(value) => common.push((*exponents, [value.clone(), c.clone()])),
            None => missing.push((*exponents, c)),
        }
    }
    let pairs: Vec<[Rational; 2]> = common.iter().map(|(_, pair)| pair.clone()).collect();
    let scale = common_factor(&pairs);
    let factor = scale
        .as_ref()
        .map_or_else(Rational::one, |s| s.factor.clone());
    let rows = common.into_iter().map(|(exponents, [got, exact])| {
        let exact = exact * &factor;
        row(
            exponents,
            got.to_f64(),
            Deviation::between(&got, &exact),
            Some(exact),
        )
    });
    let rows = rows.collect();
    let missing = missing.into_iter().map(|(exponents, c)| {
        let exact = c * &factor;
        let off = Deviation::between(&Rational::zero(), &exact);
        row(exponents, 0.0, off, Some(exact))
    });
    let missing = missing.collect();
    let sizes = Sizes::of(exact);
    // The polynomial brings the extra terms into canonical order.
    let only = SparsePolynomial::from_terms(rest.into_iter().map(|(e, c)| (e, c.clone())));
    let extra = only.terms().map(|(exponents, value)| {
        let size = sizes.around(exponents) * factor.abs();
        // The deviation of size + value from size is |value|, relative to this size.
        let off = Deviation::between(&(&size + value), &size);
        row(*exponents, value.to_f64(), off, None)
    });
    Comparison {
        in_space: [got, exact]
            .iter()
            .any(|f| f.terms().any(|(e, _)| e[2] > 0)),
        rows,
        missing,
        extra: extra.collect(),
        scale,
        diagnoses: Vec::new(),
    }
}

fn row(exponents: [u32; 3], got: f64, deviation: Deviation, exact: Option<Rational>) -> Row {
    Row {
        place: GivenNumber::Term(exponents),
        got,
        exact,
        deviation,
        residual: None,
    }
}

/// The sizes of the largest coefficient of each degree and of all degrees.
struct Sizes {
    by_degree: BTreeMap<u64, Rational>,
    largest: Rational,
}

impl Sizes {
    fn of(f: &SparsePolynomial<3>) -> Self {
        let mut sizes = Self {
            by_degree: BTreeMap::new(),
            largest: Rational::zero(),
        };
        for (exponents, c) in f.terms() {
            let size = sizes.by_degree.entry(total_degree(exponents)).or_default();
            *size = c.abs().max(size.clone());
            sizes.largest = c.abs().max(sizes.largest);
        }
        sizes
    }

    fn around(&self, exponents: &[u32; 3]) -> &Rational {
        let of_degree = self.by_degree.get(&total_degree(exponents));
        of_degree.unwrap_or(&self.largest)
    }
}
