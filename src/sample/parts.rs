//! Polynomials as rays see them: homogeneous parts.

use malachite::Integer;

use crate::poly::{PlanePolynomial, SpacePolynomial};

/// The exponents of a monomial, and its coefficient.
pub type Term<'a, const V: usize> = ([usize; V], &'a Integer);

/// A polynomial in V variables by its homogeneous parts, as far as rays ask.
pub trait HomogeneousParts<const V: usize> {
    /// The largest total degree, `None` for the zero polynomial.
    fn top_degree(&self) -> Option<usize>;

    /// The degrees of the parts that are not 0, with their terms: exponents and coefficients.
    fn terms_by_degree(&self) -> Vec<(usize, Vec<Term<'_, V>>)>;

    /// The degrees d of the parts, descending, with their values f_d at a vector.
    fn values_at(&self, vector: &[Integer; V]) -> Vec<(usize, Integer)>;
}

impl HomogeneousParts<2> for PlanePolynomial {
    fn top_degree(&self) -> Option<usize> {
        self.degree()
    }

    fn terms_by_degree(&self) -> Vec<(usize, Vec<Term<'_, 2>>)> {
        let parts = self.parts().map(|part| {
            let degree = part.degree();
            let terms = part.terms().map(|(k, c)| ([degree - k, k], c));
            (degree, terms.collect())
        });
        parts.collect()
    }

    fn values_at(&self, [u, v]: &[Integer; 2]) -> Vec<(usize, Integer)> {
        let parts = self.parts();
        parts.map(|p| (p.degree(), p.evaluate(u, v))).collect()
    }
}

impl HomogeneousParts<3> for SpacePolynomial {
    fn top_degree(&self) -> Option<usize> {
        self.degree()
    }

    fn terms_by_degree(&self) -> Vec<(usize, Vec<Term<'_, 3>>)> {
        let parts = self.parts();
        parts.map(|p| (p.degree(), p.terms().collect())).collect()
    }

    fn values_at(&self, vector: &[Integer; 3]) -> Vec<(usize, Integer)> {
        let parts = self.parts();
        parts.map(|p| (p.degree(), p.evaluate(vector))).collect()
    }
}
