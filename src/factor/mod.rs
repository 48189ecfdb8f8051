//! Factorization over the rational numbers, in one, two and three variables.
//!
//! The steps are: the rational content; monomials; the largest form that divides a plane polynomial; the substitution x^k → x;
//! contents and squarefree parts (Yun). Each part is then factored at an integer point of all variables but one by Zassenhaus'
//! algorithm; these factors are lifted to the other variables by Hensel's lemma and recombined with exact division. Every
//! factor has a proof that it is irreducible, and the product of all factors is compared with the input before the result is
//! returned.
//!
//! The algorithms are those of von zur Gathen & Gerhard, *Modern Computer Algebra*, chapters 14 and 15,
//! and Geddes, Czapor & Labahn, *Algorithms for Computer Algebra*, chapters 7 and 8.

mod conjugate;
mod gcd;
mod multivariate;
mod proof;
mod recombine;
mod specialize;
mod split;
mod univariate;

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Lcm;
use malachite::base::num::basic::traits::One;

pub(crate) use conjugate::conjugate_pair;
pub use proof::{Irreducibility, Variable};

use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{
    IntegerTerms, PlanePolynomial, SparsePolynomial, TernaryForm, coefficients, term_order,
    with_integers,
};
use split::Found;

/// A polynomial in factored form, exactly `content · ∏ polynomial^multiplicity`.
///
/// The factors are pairwise different and in canonical order: by total degree, then term by term.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factorization<P> {
    /// The rational factor in front, with the sign; a constant is its own content.
    pub content: Rational,
    /// The irreducible factors.
    pub factors: Vec<Factor<P>>,
}

/// An irreducible factor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factor<P> {
    /// The factor, with coprime integer coefficients and a positive first coefficient (for one variable: leading coefficient).
    pub polynomial: P,
    /// The multiplicity, at least 1.
    pub multiplicity: usize,
    /// The proof that it has no proper factors over the rational numbers.
    pub proof: Irreducibility,
}

/// Two polynomials in at most three variables, neither of them 0, divided by their greatest common divisor. The results are
/// primitive with positive first coefficients.
///
/// # Errors
/// Those of `limits`.
///
/// # Panics
/// If there are more than three variables.
pub(crate) fn coprime_parts<const V: usize>(
    [f, g]: [&SparsePolynomial<V>; 2],
    limits: &Limits,
) -> Result<[SparsePolynomial<V>; 2]> {
    let [f, g] = [primitive_terms(f), primitive_terms(g)];
    let common = gcd::gcd(&f, &g, limits)?;
    Ok([f, g].map(|f| canonical(&f.divided_by(&common).invariant("a gcd divides"))))
}

/// The primitive part of the greatest common divisor of two polynomials in at most three variables, with a positive first
/// coefficient. One of the polynomials may be 0.
///
/// # Errors
/// Those of `limits`.
///
/// # Panics
/// If there are more than three variables.
pub(crate) fn greatest_common_divisor<const V: usize>(
    f: &SparsePolynomial<V>,
    g: &SparsePolynomial<V>,
    limits: &Limits,
) -> Result<SparsePolynomial<V>> {
    let common = gcd::gcd(&primitive_terms(f), &primitive_terms(g), limits)?;
    Ok(canonical(&common))
}

/// The product of the irreducible factors of a plane polynomial, each of them once: f divided by the greatest common divisor of f
/// and its partial derivatives.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn squarefree_plane(f: &PlanePolynomial, limits: &Limits) -> Result<PlanePolynomial> {
    let terms = primitive_terms(&SparsePolynomial::<3>::from(f));
    let mut repeated = terms.clone();
    for &v in &terms.used() {
        repeated = gcd::gcd(&repeated, &terms.derivative(v), limits)?;
    }
    if terms.used().is_empty() {
        return Ok(f.clone());
    }
    let quotient = terms.divided_by(&repeated).invariant("a gcd divides");
    Ok(canonical::<3>(&quotient)
        .to_plane()
        .invariant("a divisor of a polynomial without z is one without z"))
}

/// The squarefree decomposition of a ternary form that is not 0, without the content and the sign: pairwise coprime primitive
/// forms with their multiplicities.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn squarefree_form(
    form: &TernaryForm,
    limits: &Limits,
) -> Result<Vec<(usize, TernaryForm)>> {
    let narrow =
        |e: [usize; 3]| -> Result<[u32; 3]> { Ok([narrow(e[0])?, narrow(e[1])?, narrow(e[2])?]) };
    let terms = form.terms().map(|(e, c)| Ok((narrow(e)?, c.clone())));
    let mut rest = IntegerTerms::new(terms.collect::<Result<_>>()?).primitive();
    let mut parts = Vec::new();
    // The part in which the main variable does not occur is decomposed in the next variable.
    while let Some(&v) = rest.used().first() {
        let (content, primitive) = gcd::content_in(&rest, v, limits)?;
        parts.extend(gcd::squarefree_parts(&primitive, v, limits)?);
        rest = content;
    }
    let wide = |e: &[u32; 3]| e.map(|k| k as usize);
    let form = |part: IntegerTerms<3>| {
        let terms: Vec<_> = part.iter().map(|(e, c)| (wide(e), c.clone())).collect();
        let degree = terms.first().map_or(0, |(e, _)| e.iter().sum());
        let form = TernaryForm::from_terms(degree, terms);
        let positive = form.terms().next().is_none_or(|(_, c)| *c > 0);
        if positive {
            form
        } else {
            form.scaled(&Integer::from(-1))
        }
    };
    Ok(parts.into_iter().map(|(m, part)| (m, form(part))).collect())
}

fn primitive_terms<const V: usize>(f: &SparsePolynomial<V>) -> IntegerTerms<3> {
    let padded = |e: &[u32; V]| std::array::from_fn(|v| if v < V { e[v] } else { 0 });
    let primitive = f.primitive();
    let terms = primitive.terms().map(|(e, c)| (padded(e), c.numerator()));
    IntegerTerms::new(terms.collect())
}

fn canonical<const V: usize>(f: &IntegerTerms<3>) -> SparsePolynomial<V> {
    let terms = f.iter();
    let terms = terms.map(|(e, c)| (std::array::from_fn(|v| e[v]), Rational::whole(c)));
    SparsePolynomial::from_terms(terms).primitive()
}

/// Finds the irreducible factors over Q of a univariate polynomial with rational coefficients.
///
/// Method: deflation, Yun's decomposition, Zassenhaus' algorithm. Cost: if there are r factors modulo the best prime, at most
/// 2^(r−1) cheap tests, of which 2²⁸ are allowed and usually hardly any are needed; O(n³) operations modulo a small prime; and
/// polynomial arithmetic with coefficients of about n + log ‖f‖ bits.
///
/// ```
/// use stellate::factor::factor_univariate;
/// use stellate::limits::Limits;
/// let f = [0, 0, 2, 0, 0, 0, -2].map(stellate::exact::Rational::from); // −2x⁶ + 2x²
/// let result = factor_univariate(&f, &Limits::none())?;
/// assert_eq!(result.content, (-2).into());
/// // x², x − 1, x + 1, x² + 1
/// let degrees: Vec<_> = result.factors.iter().map(|g| (g.polynomial.len() - 1, g.multiplicity)).collect();
/// assert_eq!(degrees, [(1, 2), (1, 1), (1, 1), (2, 1)]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] for the zero polynomial; [`Error::Limit`] if a limit is reached: degree 4096 after deflation, 2²⁸ products
/// of modular factors, or the time of `limits`; [`Error::Interrupted`].
pub fn factor_univariate(f: &[Rational], limits: &Limits) -> Result<Factorization<Vec<Rational>>> {
    let (integers, denominator) = with_integers(f);
    let (content, found) = factor_terms(IntegerTerms::from_univariate(&integers, 0), limits)?;
    Ok(Factorization {
        content: Rational::whole(content) / Rational::whole(denominator),
        factors: factors_as(found, |g| coefficients(&g.to_univariate(0))),
    })
}

/// Finds the irreducible factors over Q of a polynomial in x and y.
///
/// A polynomial in powers of x and y is factored first as a polynomial in these powers. A factor that is irreducible at one
/// value of x or y needs no lifting. Cost of lifting, for degrees n and m: O(log m) products of polynomials with 4nm
/// coefficients of about n + m + log ‖f‖ bits, times the number of factors at the chosen point.
///
/// ```
/// use stellate::factor::factor_plane;
/// use stellate::limits::Limits;
/// use stellate::poly::PlanePolynomial;
/// // x³y − xy³ = xy(x − y)(x + y)
/// let f = PlanePolynomial::from_terms([((3, 1), 1.into()), ((1, 3), (-1).into())]);
/// let result = factor_plane(&f, &Limits::none())?;
/// assert_eq!(result.factors.len(), 4);
/// // x² + y² − 1 is linear in x² and y²; neither square root splits it.
/// let circle = PlanePolynomial::from_terms([((2, 0), 1.into()), ((0, 2), 1.into()), ((0, 0), (-1).into())]);
/// let result = factor_plane(&circle, &Limits::none())?;
/// assert_eq!(result.factors[0].polynomial, circle);
/// assert_eq!(
///     result.factors[0].proof.to_string(),
///     "irreducible in y^2, and by Capelli's theorem in y"
/// );
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`factor_univariate`], and [`Error::Limit`] if polynomials of these degrees may have more than 2²¹ terms.
pub fn factor_plane(
    f: &PlanePolynomial,
    limits: &Limits,
) -> Result<Factorization<PlanePolynomial>> {
    let mut terms = Vec::new();
    for part in f.parts() {
        for (k, c) in part.terms() {
            terms.push(([narrow(part.degree() - k)?, narrow(k)?, 0], c.clone()));
        }
    }
    let (content, found) = factor_terms(IntegerTerms::new(terms), limits)?;
    let factors = factors_as(found, |g| {
        PlanePolynomial::from_terms(
            g.iter()
                .map(|(e, c)| ((e[0] as usize, e[1] as usize), Rational::whole(c))),
        )
    });
    Ok(Factorization {
        content: Rational::whole(content) / Rational::whole(f.denominator()),
        factors,
    })
}

/// Finds the irreducible factors over Q of a polynomial in x, y and z.
///
/// The method is that of [`factor_plane`], with one more variable to which factors are lifted.
///
/// ```
/// use stellate::factor::factor_space;
/// use stellate::limits::Limits;
/// use stellate::poly::SparsePolynomial;
/// let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
/// // x² − (y + z)²
/// let f = &x.pow(2) - &(&y + &z).pow(2);
/// let result = factor_space(&f, &Limits::none())?;
/// assert_eq!(result.factors[0].polynomial, &(&x - &y) - &z);
/// assert_eq!(result.factors[1].polynomial, &(&x + &y) + &z);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// As [`factor_plane`].
pub fn factor_space(
    f: &SparsePolynomial<3>,
    limits: &Limits,
) -> Result<Factorization<SparsePolynomial<3>>> {
    let denominator = f.terms().fold(Integer::ONE, |d, (_, c)| {
        let both = d.unsigned_abs_ref().lcm(c.denominator().unsigned_abs_ref());
        Integer::from(both)
    });
    let scale = Rational::whole(&denominator);
    let terms = f.terms().map(|(e, c)| (*e, (c * &scale).numerator()));
    let (content, found) = factor_terms(IntegerTerms::new(terms.collect()), limits)?;
    let factors = factors_as(found, |g| {
        SparsePolynomial::from_terms(g.iter().map(|(e, c)| (*e, Rational::whole(c))))
    });
    Ok(Factorization {
        content: Rational::whole(content) / scale,
        factors,
    })
}

fn narrow(exponent: usize) -> Result<u32> {
    u32::try_from(exponent).map_err(|_| Error::limit("exponents below 2^32"))
}

fn factors_as<P>(found: Vec<Found>, convert: impl Fn(&IntegerTerms<3>) -> P) -> Vec<Factor<P>> {
    let factors = found.into_iter().map(|found| Factor {
        polynomial: convert(&found.polynomial),
        multiplicity: found.multiplicity,
        proof: found.proof,
    });
    factors.collect()
}

/// The content and the factors, in canonical order and with canonical signs. Their product is compared with f.
fn factor_terms(f: IntegerTerms<3>, limits: &Limits) -> Result<(Integer, Vec<Found>)> {
    if f.is_zero() {
        return Err(Error::Usage(
            "the zero polynomial has no factorization".into(),
        ));
    }
    // The graded order and the purely lexicographic order are both multiplicative, so the signs can be determined factor by
    // factor in either order.
    let graded = graded_terms(&f);
    let negative = graded.first().is_some_and(|(_, c)| *c < 0);
    let content = f.signed_content();
    let content = if (content < 0) == negative {
        content
    } else {
        -content
    };
    let primitive = f.primitive();
    let mut found = split::factors(&primitive, limits)?;
    let mut product = IntegerTerms::constant(Integer::ONE);
    for factor in &found {
        limits.check()?;
        product = product.product(&factor.polynomial.pow(factor.multiplicity));
    }
    if product.primitive() != primitive {
        return Err(Error::internal(
            "factorization",
            "the factors do not multiply back",
        ));
    }
    for factor in &mut found {
        if graded_terms(&factor.polynomial)
            .first()
            .is_some_and(|(_, c)| *c < 0)
        {
            factor.polynomial = factor.polynomial.clone().scaled(&Integer::from(-1));
        }
    }
    found.sort_unstable_by(|a, b| canonical_order(&a.polynomial, &b.polynomial));
    Ok((content, found))
}

/// The terms by total degree, then by exponents, both descending.
fn graded_terms(f: &IntegerTerms<3>) -> Vec<&([u32; 3], Integer)> {
    let mut terms: Vec<_> = f.iter().collect();
    terms.sort_unstable_by(|(a, _), (b, _)| term_order(a, b));
    terms
}

/// The order of factors: by total degree, then term by term; the term that comes first in the order of terms is first, then the
/// smaller coefficient.
fn canonical_order(f: &IntegerTerms<3>, g: &IntegerTerms<3>) -> Ordering {
    let (f, g) = (graded_terms(f), graded_terms(g));
    let total = |terms: &[&([u32; 3], Integer)]| {
        terms
            .first()
            .map_or(0, |(e, _)| e.iter().map(|&k| u64::from(k)).sum::<u64>())
    };
    total(&f).cmp(&total(&g)).then_with(|| {
        for ((a, c), (b, d)) in f.iter().zip(&g) {
            let order = term_order(a, b).then_with(|| c.cmp(d));
            if order.is_ne() {
                return order;
            }
        }
        f.len().cmp(&g.len())
    })
}
