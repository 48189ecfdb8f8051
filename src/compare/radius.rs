//! The radius that all methods convert, and the systems of equations that other programs get for it.

use malachite::Integer;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{RationalFunction, SparsePolynomial, doubled_form_from_harmonics};
use crate::shape::FourierRadius;

/// The numbers of harmonics of the ladder.
pub const RUNGS: [usize; 14] = [1, 2, 3, 4, 6, 8, 10, 14, 20, 28, 39, 55, 78, 110];

/// A description of the coefficients, for people.
pub(super) const RADIUS_TEXT: &str =
    "a0 = 1, a_n = (2 (7n mod 19) - 19)/200, b_n = (2 (11n mod 19) - 19)/200";

/// The first N harmonics of a series with short coefficients, none of which is 0:
/// `a0 = 1, a_n = (2 (7n mod 19) − 19)/200, b_n = (2 (11n mod 19) − 19)/200`.
///
/// ```
/// use stellate::compare::ladder_radius;
/// let radius = ladder_radius(2);
/// assert_eq!(radius.cosines(), ["1", "-1/40", "9/200"].map(|q| q.parse().unwrap()));
/// ```
#[must_use]
pub fn ladder_radius(harmonics: usize) -> FourierRadius {
    let numerator = |n: usize, factor: usize| {
        let residue = i64::try_from(factor * n % 19).invariant("a residue modulo 19 is small");
        Rational::from(2 * residue - 19) / Rational::from(200)
    };
    let coefficients = |first: i64, factor: usize| {
        let others = (1..=harmonics).map(|n| numerator(n, factor));
        std::iter::once(Rational::from(first))
            .chain(others)
            .collect()
    };
    FourierRadius::new(coefficients(1, 7), coefficients(0, 11))
}

/// Two polynomials with integer coefficients whose resultant with respect to z is F up to a constant factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum System {
    /// z is tan(θ/2); the equations are `(1 + z²)^(N+1) x = …` and the same for y.
    HalfAngle,
    /// z is r; the equations are `z² = x² + y²` and `z^(N+1) = Σ K_n z^(N−n)`, Eqs. (2) and (6).
    Radius,
}

impl System {
    pub(super) fn polynomials(self, radius: &FourierRadius) -> [SparsePolynomial<3>; 2] {
        match self {
            System::HalfAngle => {
                let curve = radius.to_plane_curve();
                let [x, y] = curve.coordinates();
                [cleared(x, 0), cleared(y, 1)]
            }
            System::Radius => {
                let square = |v: u32| {
                    let mut exponents = [0; 3];
                    exponents[v as usize] = 2;
                    (exponents, Rational::from(if v == 2 { 1 } else { -1 }))
                };
                [
                    SparsePolynomial::from_terms((0..3).map(square)),
                    in_powers_of_r(radius),
                ]
            }
        }
    }
}

fn exponent(e: usize) -> u32 {
    u32::try_from(e).invariant("degrees are below 2^32")
}

/// The polynomial q(z) v − p(z) for the coordinate v = p/q.
fn cleared(coordinate: &RationalFunction, variable: usize) -> SparsePolynomial<3> {
    let below = coordinate.denominator().coefficients_asc().iter();
    let above = coordinate.numerator().coefficients_asc().iter();
    let below = below.enumerate().map(|(k, c)| {
        let mut exponents = [0, 0, exponent(k)];
        exponents[variable] = 1;
        (exponents, Rational::whole(c))
    });
    let above = above
        .enumerate()
        .map(|(k, c)| ([0, 0, exponent(k)], -Rational::whole(c)));
    SparsePolynomial::from_terms(below.chain(above))
}

/// The polynomial `z^(N+1) − Σ K_n z^(N−n)`, times an integer.
fn in_powers_of_r(radius: &FourierRadius) -> SparsePolynomial<3> {
    let harmonics = radius.harmonics();
    let (denominator, cos, sin) = radius.over_common_denominator();
    let twice = Rational::whole(&(denominator * Integer::from(2)));
    let mut sum = SparsePolynomial::from_terms([([0, 0, exponent(harmonics + 1)], twice)]);
    for n in 0..=harmonics {
        let form = doubled_form_from_harmonics(n, [(n, &cos[n], &sin[n])]);
        for (k, c) in form.terms() {
            let exponents = [n - k, k, harmonics - n].map(exponent);
            sum.add_term(exponents, -Rational::whole(c));
        }
    }
    sum.primitive()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::implicitize::SquaredForm;

    #[test]
    fn no_coefficient_is_zero() {
        let radius = ladder_radius(110);
        assert_eq!(radius.harmonics(), 110);
        let mut all = radius.cosines().iter().chain(&radius.sines()[1..]);
        assert!(all.all(|c| !c.is_zero()));
        assert!(!SquaredForm::new(&radius).unwrap().is_perfect_square());
    }

    #[test]
    fn both_systems_vanish_on_the_curve() {
        let radius = ladder_radius(5);
        // The angle with tan(θ/2) = 1/2 has the direction (3/5, 4/5).
        let t = Rational::from(1) / Rational::from(2);
        let curve = radius.to_plane_curve();
        let [x, y] = curve.point(&t).unwrap();
        let [three, five] = [3, 5].map(Rational::from);
        let r = &x * &five / three;
        for (system, z) in [(System::HalfAngle, t), (System::Radius, r)] {
            for polynomial in system.polynomials(&radius) {
                let at = [x.clone(), y.clone(), z.clone()];
                assert!(polynomial.evaluate(&at).is_zero(), "{system:?}");
                let elsewhere = [x.clone(), y.clone(), &z + &Rational::from(1)];
                assert!(!polynomial.evaluate(&elsewhere).is_zero(), "{system:?}");
            }
        }
    }
}
