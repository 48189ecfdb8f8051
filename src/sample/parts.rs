//! The homogeneous parts of polynomials, for the evaluation along rays.

use std::borrow::Cow;

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use crate::error::Invariant;
use crate::poly::{BinaryForm, PlanePolynomial, SpacePolynomial, scaled_harmonics};

/// The exponents of a monomial, and its coefficient.
pub(super) type Term<'a, const V: usize> = ([usize; V], &'a Integer);

/// The functions on vectors of which the homogeneous parts are sums.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartBasis {
    /// Powers: `[i, j]` is x^i y^j, and in space `[i, j, k]` is x^i y^j z^k.
    Powers,
    /// Harmonics, on unit vectors of the plane: `[m, 0]` is cos mθ and `[0, m]` is sin mθ.
    Harmonics,
}

/// A homogeneous part as the sum 2^exponent Σ c b over functions b of a basis.
#[derive(Clone, Debug)]
pub struct ExpandedPart<'a, const V: usize> {
    /// The degree of the part.
    pub degree: usize,
    /// The exponent of the power of two before the sum.
    pub exponent: i64,
    /// For each term the index of b, and c.
    pub terms: Vec<([usize; V], Cow<'a, Integer>)>,
}

/// The homogeneous parts of a polynomial as sums of few functions.
#[derive(Clone, Debug)]
pub struct ExpandedParts<'a, const V: usize> {
    /// The basis.
    pub basis: PartBasis,
    /// The parts that are not 0.
    pub parts: Vec<ExpandedPart<'a, V>>,
}

/// A polynomial in V variables that can be solved along rays: a [`PlanePolynomial`] or a [`SpacePolynomial`].
pub trait HomogeneousParts<const V: usize>: PartsByDegree<V> {}

impl<T: PartsByDegree<V>, const V: usize> HomogeneousParts<V> for T {}

/// The operations behind [`HomogeneousParts`]. The trait is sealed: it cannot be named outside of the crate.
pub trait PartsByDegree<const V: usize> {
    /// The largest total degree, `None` for the zero polynomial.
    fn top_degree(&self) -> Option<usize>;

    /// For each part that is not 0, its degree and its terms, each with exponents and coefficient.
    fn terms_by_degree(&self) -> Vec<(usize, Vec<Term<'_, V>>)>;

    /// The parts that are not 0, in a basis in which their values lose few bits.
    fn expanded(&self) -> ExpandedParts<'_, V> {
        in_powers(self.terms_by_degree())
    }

    /// The degrees d of the parts, descending, with their values f_d at a vector.
    fn values_at(&self, vector: &[Integer; V]) -> Vec<(usize, Integer)>;
}

impl PartsByDegree<2> for PlanePolynomial {
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

    fn expanded(&self) -> ExpandedParts<'_, 2> {
        in_harmonics(self).unwrap_or_else(|| in_powers(self.terms_by_degree()))
    }

    fn values_at(&self, [u, v]: &[Integer; 2]) -> Vec<(usize, Integer)> {
        let parts = self.parts();
        parts.map(|p| (p.degree(), p.evaluate(u, v))).collect()
    }
}

impl PartsByDegree<3> for SpacePolynomial {
    fn top_degree(&self) -> Option<usize> {
        self.degree()
    }

    fn terms_by_degree(&self) -> Vec<(usize, Vec<Term<'_, 3>>)> {
        let parts = self.parts();
        let parts =
            parts.map(|(degree, terms)| (degree, terms.iter().map(|(e, c)| (*e, c)).collect()));
        parts.collect()
    }

    fn values_at(&self, vector: &[Integer; 3]) -> Vec<(usize, Integer)> {
        SpacePolynomial::values_at(self, vector).collect()
    }
}

fn in_powers<const V: usize>(parts: Vec<(usize, Vec<Term<'_, V>>)>) -> ExpandedParts<'_, V> {
    let parts = parts.into_iter().map(|(degree, terms)| ExpandedPart {
        degree,
        exponent: 0,
        terms: terms
            .into_iter()
            .map(|(e, c)| (e, Cow::Borrowed(c)))
            .collect(),
    });
    ExpandedParts {
        basis: PartBasis::Powers,
        parts: parts.collect(),
    }
}

/// The parts as sums of harmonics, if that saves bits.
///
/// Near the unit circle, powers of x and y can have coefficients 2^d times as large as their sum; this is so for a radius with
/// d/2 − 1 harmonics. The coefficients of harmonics are on average at most as large as the sum.
fn in_harmonics(f: &PlanePolynomial) -> Option<ExpandedParts<'static, 2>> {
    /// Below this degree hardly any bits can be saved.
    const LEAST_DEGREE: usize = 16;
    f.degree().filter(|degree| *degree >= LEAST_DEGREE)?;
    let mut saved = 0;
    let mut parts = Vec::new();
    for form in f.parts() {
        let harmonics = scaled_harmonics(form);
        saved += saved_bits(form, &harmonics);
        if saved <= 0 {
            return None;
        }
        let terms = harmonics
            .into_iter()
            .flat_map(|(m, a, b)| [([m, 0], a), ([0, m], b)])
            .filter(|(_, c)| *c != 0);
        parts.push(ExpandedPart {
            degree: form.degree(),
            exponent: -exponent(form.degree() as u64),
            terms: terms.map(|(e, c)| (e, Cow::Owned(c))).collect(),
        });
    }
    Some(ExpandedParts {
        basis: PartBasis::Harmonics,
        parts,
    })
}

/// About how many bits fewer the values lose, on average over the directions, as sums of the harmonics, which are given times
/// 2^d, than as sums of powers.
fn saved_bits(form: &BinaryForm, harmonics: &[(usize, Integer, Integer)]) -> i64 {
    let bits = |c: &Integer| exponent(c.significant_bits());
    let powers = form.terms().map(|(_, c)| bits(c)).max();
    let harmonics = harmonics.iter().map(|(_, a, b)| bits(a).max(bits(b))).max();
    let degree = exponent(form.degree() as u64);
    // Powers are evaluated with the larger coordinate as 1; its d-th power is 1 to 2^(d/2) times smaller than that of the
    // length.
    let [powers, harmonics] = [powers, harmonics].map(|bits| bits.invariant("a part is not 0"));
    powers - (harmonics - degree) - degree / 4
}

/// A degree or a number of bits, with a sign.
fn exponent(count: u64) -> i64 {
    i64::try_from(count).invariant("degrees and bits are far below 2^63")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::poly::TrigPolynomial;
    use crate::sample::Direction;
    use proptest::prelude::*;

    /// The value of a part at a unit vector.
    fn value(part: &ExpandedPart<'_, 2>, basis: PartBasis, [x, y]: &[Rational; 2]) -> Rational {
        let function = |[i, j]: [usize; 2]| {
            let index = |k| i32::try_from(k).expect("small");
            match basis {
                PartBasis::Powers => {
                    x.pow(index(i).into()).expect("a power")
                        * y.pow(index(j).into()).expect("a power")
                }
                PartBasis::Harmonics if j == 0 => TrigPolynomial::cosine(index(i)).evaluate(x, y),
                PartBasis::Harmonics => TrigPolynomial::sine(index(j)).evaluate(x, y),
            }
        };
        let terms = part.terms.iter();
        let sum = terms.fold(Rational::zero(), |sum, (b, c)| {
            sum + function(*b) * Rational::whole(&**c)
        });
        sum * Rational::from(2).pow(part.exponent).expect("2 is not 0")
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        /// Powers of ρ, shifted or not, save bits as harmonics; large powers of x do not.
        #[test]
        fn parts_are_their_expansions(k in 8usize..11, a in -3i64..4, high in 0usize..30, theta in -4.0f64..4.0) {
            let rho = PlanePolynomial::from_parts([BinaryForm::rho_power(k)], 1.into());
            let rho = rho.translated(&Rational::from(a), &Rational::one());
            let power = ((high, 0), Rational::from(5));
            let f = PlanePolynomial::from_terms(rho.terms().chain([power]));
            let expansion = f.expanded();
            let expected = if high > 2 * k { PartBasis::Powers } else { PartBasis::Harmonics };
            prop_assert_eq!(expansion.basis, expected);
            let direction = Direction::from_radians(theta);
            let (u, v) = (direction.u(), direction.v());
            prop_assert_eq!(expansion.parts.len(), f.parts().count());
            for (part, form) in expansion.parts.iter().zip(f.parts()) {
                let alone = PlanePolynomial::from_parts([form.clone()], 1.into());
                prop_assert_eq!(part.degree, form.degree());
                let found = value(part, expansion.basis, &[u.clone(), v.clone()]);
                prop_assert_eq!(found, alone.evaluate(&u, &v));
            }
        }
    }
}
