//! Real parameters that reach a point which two conjugate parameters reach.

use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::eliminant::subresultant;
use super::enclosure::{Enclosure, Precision};
use super::pair::{DoublePoints, enclosed_root, value_at};
use super::symmetric::{Rows, bezoutian, in_both};
use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, RationalFunction, divide_exactly, polynomial_gcd};
use crate::roots::{RealRoot, real_roots};

/// Whether a real parameter, infinity included, reaches this rational point, exactly: the numerators of x(t) − x, y(t) − y, …
/// have a common real root, or all are 0 at infinity.
pub(super) fn is_reached<const N: usize>(
    coordinates: [&RationalFunction; N],
    point: &[Rational; N],
) -> bool {
    let at_infinity = coordinates.iter().zip(point);
    let mut at_infinity = at_infinity.map(|(f, v)| f.evaluate_at_infinity().as_ref() == Some(v));
    if at_infinity.all(|reached| reached) {
        return true;
    }
    let differences = coordinates
        .iter()
        .zip(point)
        .map(|(f, v)| f.plus_constant(&-v.clone()));
    let common = differences.fold(IntegerPolynomial::ZERO, |common, f| {
        polynomial_gcd(&common, f.numerator())
    });
    !real_roots(&common).is_empty()
}

/// Whether it is proved that no parameter but s and s̄, complex ones and infinity included, has their point. Two coordinates that
/// prove it are enough.
pub(super) fn is_reached_by_no_other<const N: usize>(
    coordinates: [&RationalFunction; N],
    pair: &[Enclosure; 2],
    point: &[Enclosure; N],
    precision: Precision,
) -> bool {
    (1..N).any(|j| {
        (0..j).any(|i| {
            let (both, values) = ([coordinates[i], coordinates[j]], [&point[i], &point[j]]);
            both.iter().all(|f| f.degree() >= 2)
                && is_projected_by_no_other(both, pair, values, precision)
        })
    })
}

/// Whether it is proved that no parameter but s and s̄, complex ones and infinity included, has the values x and y of two
/// coordinates.
///
/// `(p1(t) − x q1(t))/(t² − S t + P)` and the same quotient for y are polynomials in t, of formal degrees m − 2 and n − 2.
/// Their resultant is different from 0 exactly if they have no common root and their leading coefficients are not both 0. The
/// answer is `false` if the enclosure of the resultant holds 0.
fn is_projected_by_no_other(
    coordinates: [&RationalFunction; 2],
    [sum, product]: &[Enclosure; 2],
    point: [&Enclosure; 2],
    precision: Precision,
) -> bool {
    let quotient = |k: usize| -> Vec<Enclosure> {
        let f = coordinates[k];
        let [p, q] = [f.numerator(), f.denominator()].map(IntegerPolynomial::coefficients_asc);
        let coefficient = |i: usize| {
            let [p, q] = [p, q].map(|c| {
                c.get(i)
                    .map_or_else(Enclosure::zero, |c| precision.integer(c))
            });
            p.minus(&precision.times(&q, point[k]))
        };
        // Synthetic division from the highest coefficient; the remainder is 0 and not computed.
        let mut descending: Vec<Enclosure> = Vec::new();
        for i in (2..=f.degree()).rev() {
            let mut c = coefficient(i);
            if let Some(last) = descending.last() {
                c = c.plus(&precision.times(sum, last));
            }
            if let [.., before, _] = descending.as_slice() {
                c = c.minus(&precision.times(product, before));
            }
            descending.push(c);
        }
        descending
    };
    let [f, g] = [quotient(0), quotient(1)];
    let (m, n) = (f.len() - 1, g.len() - 1);
    if m + n == 0 {
        // Neither polynomial has any other parameter.
        return true;
    }
    let row = |f: &[Enclosure], shift: usize| -> Vec<Enclosure> {
        let mut row = vec![Enclosure::zero(); shift];
        row.extend_from_slice(f);
        row.resize(m + n, Enclosure::zero());
        row
    };
    let rows = (0..n).map(|r| row(&f, r));
    let rows = rows.chain((0..m).map(|r| row(&g, r)));
    let left = precision.last_row(rows.collect());
    left.is_some_and(|left| left[0].sign().is_some_and(|s| s != 0))
}

/// A real parameter that may share its point with two conjugate ones.
pub(super) struct RealPartner {
    t: RealRoot,
    /// Whether it is proved that it does.
    pub(super) proved: bool,
}

impl RealPartner {
    /// An enclosure of its point; `None` if the precision is too low.
    pub(super) fn point<const N: usize>(
        &self,
        coordinates: [&RationalFunction; N],
        precision: Precision,
    ) -> Option<[Enclosure; N]> {
        let t = enclosed_root(&self.t, precision);
        let value = |f: &RationalFunction| {
            let [p, q] = [f.numerator(), f.denominator()].map(|f| value_at(f, &t, precision));
            precision.over(&p, &q)
        };
        let values: Option<Vec<_>> = coordinates.into_iter().map(value).collect();
        values?.try_into().ok()
    }
}

/// All real numbers t whose point two conjugate parameters have as well, and perhaps further ones; t = ∞ is not included.
///
/// Let A(t, σ), B(t, σ) be the two quotients of differences. For such a t they have two common zeros σ, so the resultant with
/// respect to σ and the leading coefficient of the first subresultant are both 0 there. If the second subresultant is then a
/// quadratic polynomial in σ with negative discriminant, its zeros are the two conjugate parameters. Poles are left out.
///
/// # Errors
/// As [`subresultant`].
pub(super) fn real_partners(
    points: &DoublePoints<'_>,
    limits: &Limits,
) -> Result<Vec<RealPartner>> {
    let coordinates = points.coordinates;
    // The coefficients of the powers of σ are polynomials in t.
    let [a, b] = coordinates.map(|f| in_both(&bezoutian(f)));
    let least = a.degree().min(b.degree());
    if least < 2 {
        // A linear equation for σ has one solution, so there are no two; or, if it is 0 identically, every σ is a solution.
        return Ok(partners_of(&common_content([&a, &b]), None));
    }
    let both = [&a, &b];
    let resultant = subresultant(both, 0, limits)?;
    let first = subresultant(both, 1, limits)?;
    let mut common = polynomial_gcd(&resultant[0], &first[1]);
    for f in coordinates {
        loop {
            let poles = polynomial_gcd(&common, f.denominator());
            if poles.coefficients_asc().len() <= 1 {
                break;
            }
            match divide_exactly(&common, &poles) {
                Some(rest) => common = rest,
                None => break,
            }
        }
    }
    if common.coefficients_asc().len() <= 1 {
        return Ok(Vec::new());
    }
    let quadratic = match (a.degree(), b.degree()) {
        (2, _) => a.rows().to_vec(),
        (_, 2) => b.rows().to_vec(),
        _ => subresultant(both, 2, limits)?,
    };
    Ok(partners_of(&common, Some(&quadratic)))
}

/// The values of t at which all coefficients of both are 0.
fn common_content(both: [&Rows; 2]) -> IntegerPolynomial {
    let rows = both.into_iter().flat_map(Rows::rows);
    rows.fold(IntegerPolynomial::ZERO, |g, row| polynomial_gcd(&g, row))
}

fn partners_of(
    common: &IntegerPolynomial,
    quadratic: Option<&[IntegerPolynomial]>,
) -> Vec<RealPartner> {
    let four = IntegerPolynomial::from_coefficients_asc(vec![4.into()]);
    real_roots(common)
        .into_iter()
        .filter_map(|t| {
            let Some([c, b, a]) = quadratic else {
                return Some(RealPartner { t, proved: false });
            };
            if t.is_root_of(a) || *a == IntegerPolynomial::ZERO {
                return Some(RealPartner { t, proved: false });
            }
            let discriminant = b * b - &four * a * c;
            (t.sign_of(&discriminant) < 0).then_some(RealPartner { t, proved: true })
        })
        .collect()
}
