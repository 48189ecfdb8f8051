//! A line and a prime modulo which a polynomial on the line is irreducible: so it is irreducible over Q (T4).

use malachite::Integer;
use serde_json::{Value, json};

use super::forms::texts;
use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::modular::{PrimeField, is_irreducible, large_primes, trimmed};
use crate::poly::{PlanePolynomial, SparsePolynomial};

/// Above this degree no line is searched.
const MOST_DEGREE: usize = 128;
/// The number of lines that are tried.
const LINES: i64 = 4;

/// A polynomial that is restricted to lines modulo primes.
pub(crate) trait LinePoly<const V: usize> {
    /// The total degree; `None` for the polynomial 0.
    fn total_degree(&self) -> Option<usize>;
    /// The terms, with coprime integer coefficients.
    fn integer_terms(&self) -> Vec<([usize; V], Integer)>;
}

impl LinePoly<2> for PlanePolynomial {
    fn total_degree(&self) -> Option<usize> {
        self.degree()
    }

    fn integer_terms(&self) -> Vec<([usize; 2], Integer)> {
        let primitive = self.primitive();
        let terms = primitive.terms();
        terms.map(|((i, j), c)| ([i, j], c.numerator())).collect()
    }
}

impl LinePoly<3> for SparsePolynomial<3> {
    fn total_degree(&self) -> Option<usize> {
        usize::try_from(self.degree()?).ok()
    }

    fn integer_terms(&self) -> Vec<([usize; 3], Integer)> {
        let primitive = self.primitive();
        let terms = primitive.terms();
        terms
            .map(|(e, c)| (e.map(|e| e as usize), c.numerator()))
            .collect()
    }
}

/// The witness of irreducibility by a line and a prime; `None` if none is found.
pub(super) fn line_and_prime<const V: usize>(
    polynomial: &impl LinePoly<V>,
    limits: &Limits,
) -> Result<Option<Value>> {
    let Some(degree) = polynomial
        .total_degree()
        .filter(|degree| (1..=MOST_DEGREE).contains(degree))
    else {
        return Ok(None);
    };
    let terms = polynomial.integer_terms();
    // Of the sections by most lines one in `degree` primes leaves an irreducible polynomial, if the polynomial is absolutely
    // irreducible.
    let primes = 6 * degree + 30;
    for line in 0..LINES {
        let point: [i64; V] = std::array::from_fn(|k| (k as i64 + 1) * line);
        let direction: [i64; V] = std::array::from_fn(|k| [3, 5 + line, -7][k % 3] + line);
        for prime in large_primes().take(primes) {
            limits.check()?;
            let field = PrimeField::new(prime);
            let section = on_line(&field, &terms, degree, (&point, &direction));
            if section.len() == degree + 1 && is_irreducible(&field, &field.monic(section)) {
                let [point, direction] = [point, direction].map(|v| v.map(Rational::from));
                return Ok(Some(json!({
                    "point": texts(&point),
                    "direction": texts(&direction),
                    "prime": prime,
                })));
            }
        }
    }
    Ok(None)
}

/// f(point + s·direction) modulo a prime above the degree, by values at s = 0 … degree.
fn on_line<const V: usize>(
    field: &PrimeField,
    terms: &[([usize; V], Integer)],
    degree: usize,
    (point, direction): (&[i64; V], &[i64; V]),
) -> Vec<u64> {
    let terms: Vec<([usize; V], u64)> = terms
        .iter()
        .map(|(e, c)| (*e, field.reduce_integer(c)))
        .collect();
    let values = (0..=degree as i64).map(|s| {
        let powers: [Vec<u64>; V] = std::array::from_fn(|k| {
            let coordinate = Integer::from(point[k] + s * direction[k]);
            field.powers(field.reduce_integer(&coordinate), degree + 1)
        });
        terms.iter().fold(0, |sum, (exponents, c)| {
            let term = exponents
                .iter()
                .zip(&powers)
                .fold(*c, |product, (&e, powers)| field.mul(product, powers[e]));
            field.sum(sum, term)
        })
    });
    trimmed(field.interpolate(values.collect()))
}
