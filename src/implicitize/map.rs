//! A parametric form as a rational map: its values modulo a prime, and exact substitution.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use crate::error::Result;
use crate::limits::Limits;
use crate::poly::{
    IntegerPolynomial, RationalFunction, SparsePolynomial, inverse_mod, power_mod, reduce_integer,
};
use crate::shape::{ParametricCurve, Patch, PatchFunction, SpaceCurve};

/// A polynomial in at most two variables with integer coefficients.
type Terms = Vec<([u32; 2], Integer)>;

/// The coordinates as quotients of polynomials in s1 and s2.
pub(super) struct RationalMap {
    coordinates: Vec<[Terms; 2]>,
}

impl RationalMap {
    pub(super) fn of_curve<const N: usize>(curve: &ParametricCurve<N>) -> Self {
        Self::of_functions(curve.coordinates())
    }

    pub(super) fn of_functions(functions: &[RationalFunction]) -> Self {
        let terms = |f: &IntegerPolynomial| {
            let coefficients = f.coefficients_asc().iter().enumerate();
            let terms = coefficients.filter(|(_, c)| **c != 0);
            terms
                .map(|(k, c)| ([u32::try_from(k).unwrap_or(u32::MAX), 0], c.clone()))
                .collect()
        };
        let both = |f: &RationalFunction| [terms(f.numerator()), terms(f.denominator())];
        Self {
            coordinates: functions.iter().map(both).collect(),
        }
    }

    pub(super) fn of_patch(patch: &Patch) -> Self {
        Self::of_patch_functions(patch.coordinates())
    }

    pub(super) fn of_patch_functions(functions: &[PatchFunction]) -> Self {
        let terms = |f: &SparsePolynomial<2>| {
            let terms = f.terms();
            terms.map(|(e, c)| (*e, c.numerator())).collect()
        };
        Self {
            coordinates: functions
                .iter()
                .map(|f| [terms(f.numerator()), terms(f.denominator())])
                .collect(),
        }
    }

    /// The point at (s1, s2) modulo a prime below 2³¹; `None` at a pole.
    pub(super) fn at(&self, s: [u64; 2], prime: u64) -> Option<Vec<u64>> {
        let coordinates = self.coordinates.iter();
        coordinates
            .map(|[p, q]| {
                let below = value_modulo(q, s, prime);
                let inverse = (below != 0).then(|| inverse_mod(below, prime))?;
                Some(value_modulo(p, s, prime) * inverse % prime)
            })
            .collect()
    }

    /// Whether f vanishes identically on the form: exact substitution in integers.
    ///
    /// With x = p1/q1 and so on, `f q1^deg_x q2^deg_y q3^deg_z` is expanded by Horner's rule, the two variables
    /// packed into one (Kronecker). Cost: about 2 deg_x deg_z products of polynomials for three coordinates.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(super) fn annihilates(&self, f: &SparsePolynomial<3>, limits: &Limits) -> Result<bool> {
        let degrees = f.terms().fold([0; 3], |d: [u32; 3], (e, _)| {
            std::array::from_fn(|v| d[v].max(e[v]))
        });
        // The degree in s1 of everything that is added up.
        let stride = self.coordinates.iter().zip(degrees).fold(1, |sum, (c, d)| {
            let degree = c.iter().flatten().map(|(e, _)| e[0]).max().unwrap_or(0);
            sum + degree as usize * d as usize
        });
        let packed: Vec<[IntegerPolynomial; 2]> = self
            .coordinates
            .iter()
            .map(|both| both.each_ref().map(|terms| pack(terms, stride)))
            .collect();
        let terms: Vec<([u32; 3], Integer)> = f
            .primitive()
            .terms()
            .map(|(e, c)| (*e, c.numerator()))
            .collect();
        let used = packed.len().min(3);
        let value = substitute(&terms, used, degrees, &packed, limits)?;
        Ok(value == IntegerPolynomial::ZERO)
    }
}

/// Whether a space curve satisfies f = 0 identically: exact substitution.
pub(crate) fn lies_on(curve: &SpaceCurve, f: &SparsePolynomial<3>) -> bool {
    let map = RationalMap::of_curve(curve);
    map.annihilates(f, &Limits::none())
        .is_ok_and(|it_does| it_does)
}

/// The terms, which all have the same exponents from `variable` on, with the first variables put in.
fn substitute(
    terms: &[([u32; 3], Integer)],
    variables: usize,
    degrees: [u32; 3],
    packed: &[[IntegerPolynomial; 2]],
    limits: &Limits,
) -> Result<IntegerPolynomial> {
    let Some(last) = variables.checked_sub(1) else {
        let sum = terms.iter().fold(Integer::ZERO, |sum, (_, c)| sum + c);
        return Ok(constant(sum));
    };
    let [p, q] = &packed[last];
    let mut value = IntegerPolynomial::ZERO;
    let mut q_power = constant(Integer::ONE);
    for k in (0..=degrees[last]).rev() {
        limits.check()?;
        let here: Vec<([u32; 3], Integer)> = terms
            .iter()
            .filter(|(e, _)| e[last] == k)
            .cloned()
            .collect();
        if value != IntegerPolynomial::ZERO {
            value *= p;
        }
        if !here.is_empty() {
            value += substitute(&here, last, degrees, packed, limits)? * &q_power;
        }
        if k > 0 && *q != constant(Integer::ONE) {
            q_power *= q;
        }
    }
    Ok(value)
}

fn constant(c: Integer) -> IntegerPolynomial {
    IntegerPolynomial::from_coefficients_asc(vec![c])
}

/// s1 becomes s, s2 becomes s^stride.
fn pack(terms: &Terms, stride: usize) -> IntegerPolynomial {
    let mut coefficients = Vec::new();
    for (e, c) in terms {
        let index = e[0] as usize + e[1] as usize * stride;
        if coefficients.len() <= index {
            coefficients.resize(index + 1, Integer::ZERO);
        }
        coefficients[index] += c;
    }
    IntegerPolynomial::from_coefficients_asc(coefficients)
}

fn value_modulo(terms: &Terms, s: [u64; 2], prime: u64) -> u64 {
    terms.iter().fold(0, |sum, (e, c)| {
        let c = reduce_integer(c, prime);
        let monomial =
            power_mod(s[0], e[0].into(), prime) * power_mod(s[1], e[1].into(), prime) % prime;
        (sum + c * monomial) % prime
    })
}
