//! Condition numbers: the factors by which relative errors of the inputs grow in an output, to first order.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{
    BinaryForm, Ring, SpacePolynomial, SparsePolynomial, doubled_form_from_harmonics,
};
use crate::sample::along;
use crate::shape::FourierRadius;

/// The condition of every coefficient of F of Theorem 2 with respect to the coefficients of the radius: for F_k it is
/// `Σ_j |a_j ∂F_k/∂a_j| / |F_k|` over all a_n and b_n, exactly. If every input is off by at most ε, relatively, F_k is
/// off by at most this times ε, to first order.
///
/// The top part does not depend on the inputs, so its conditions are 0; the middle part is linear in the inputs, and the low
/// part is quadratic. The answer is a polynomial with the terms of the expanded F and the conditions as coefficients, so that a
/// condition of 0 has no term. Cost: two products of forms of degree N for each of the 2N + 1 inputs.
#[must_use]
pub(super) fn coefficient_conditions(radius: &FourierRadius) -> SparsePolynomial<3> {
    let n = radius.harmonics();
    let (_, cos, sin) = radius.over_common_denominator();
    let zero = Integer::ZERO;
    // The contribution of each input to the sum over the harmonics of one parity.
    let added = |parity: usize| -> Vec<BinaryForm> {
        let degree = if n % 2 == parity {
            n
        } else {
            n.saturating_sub(1)
        };
        let harmonics = (parity..=degree.min(n)).step_by(2);
        harmonics
            .flat_map(|m| [(m, &cos[m], &zero), (m, &zero, &sin[m])])
            .filter(|(_, a, b)| **a != 0 || **b != 0)
            .map(|harmonic| doubled_form_from_harmonics(degree, [harmonic]))
            .collect()
    };
    let (odd, even) = (if n > 0 { added(1) } else { Vec::new() }, added(0));
    let total = |forms: &[BinaryForm]| forms.iter().cloned().reduce(|a, b| a.plus(&b));
    let rho = BinaryForm::rho_power(1);
    let raised = |form: BinaryForm, by: bool| if by { form.times(&rho) } else { form };
    let mut parts = Vec::new();
    if let Some(sum) = total(&odd) {
        let power = BinaryForm::rho_power(n / 2 + 1);
        parts.push(Ratios::new(
            &power.times(&sum),
            odd.iter().map(|t| power.times(t)),
        ));
    }
    let square = |forms: &[BinaryForm], by: bool| {
        let sum = total(forms)?;
        let products: Vec<BinaryForm> = forms.iter().map(|t| raised(sum.times(t), by)).collect();
        Some((raised(sum.squared(), by), products))
    };
    let [of_odd, of_even] = [
        square(&odd, n.is_multiple_of(2)),
        square(&even, !n.is_multiple_of(2)),
    ];
    let value = match (&of_odd, &of_even) {
        (Some((a, _)), Some((b, _))) => Some(a.minus(b)),
        (Some((a, _)), None) | (None, Some((a, _))) => Some(a.clone()),
        (None, None) => None,
    };
    if let Some(value) = value {
        // The derivative of a square is twice a product.
        let two = Integer::from(2);
        let products = [of_odd, of_even]
            .into_iter()
            .flatten()
            .flat_map(|(_, products)| products);
        parts.push(Ratios::new(&value, products.map(|p| p.scaled(&two))));
    }
    SparsePolynomial::from_terms(parts.into_iter().flat_map(|part| part.0))
}

/// Terms with quotients of coefficients.
struct Ratios(Vec<([u32; 3], Rational)>);

impl Ratios {
    /// The quotients (Σ_t |t_k|)/|f_k| for all k with f_k ≠ 0, where t runs through `derivatives`.
    fn new(f: &BinaryForm, derivatives: impl Iterator<Item = BinaryForm>) -> Self {
        let mut sums = vec![Integer::ZERO; f.degree() + 1];
        for form in derivatives {
            for (k, c) in form.terms() {
                sums[k] += Integer::from(c.unsigned_abs_ref().clone());
            }
        }
        let exponent = |e: usize| u32::try_from(e).invariant("a degree is below 2^32");
        let ratios = f.terms().filter_map(|(k, c)| {
            let below = Integer::from(c.unsigned_abs_ref().clone());
            let ratio = Rational::from_integers(std::mem::take(&mut sums[k]), below)?;
            Some(([exponent(f.degree() - k), exponent(k), 0], ratio))
        });
        Self(ratios.collect())
    }
}

/// The conditions of the roots r of f(ru, rv, rw) with respect to independent relative errors of the coefficients of f.
#[derive(Debug)]
pub(super) struct RootConditions {
    f: SpacePolynomial,
    /// f with the sizes of its coefficients in place of the coefficients.
    sizes: SpacePolynomial,
}

impl RootConditions {
    /// Prepares the conditions of the roots of this polynomial.
    #[must_use]
    pub(super) fn new(f: &SparsePolynomial<3>) -> Self {
        let sizes = f.terms().map(|(e, c)| (*e, c.abs()));
        Self {
            f: SpacePolynomial::from(f),
            sizes: SpacePolynomial::from(&SparsePolynomial::from_terms(sizes)),
        }
    }

    /// The sum of the sizes of all terms, divided by |r ∂f/∂r|, in the direction vector/w and at a double r near the root;
    /// rounded, and infinite if the derivative is 0. Cost: the values of all homogeneous parts.
    #[must_use]
    pub(super) fn at(&self, vector: &[Integer; 3], w: &Integer, r: f64) -> f64 {
        // Nothing is known about a root beyond the largest double.
        let Ok(r) = Rational::try_from(r) else {
            return f64::INFINITY;
        };
        let magnitude = |v: &Integer| Integer::from(v.unsigned_abs_ref().clone());
        let sum = |terms: Vec<(usize, Integer)>, r: &Rational, weight: &dyn Fn(usize) -> usize| {
            let terms = terms.into_iter().map(|(d, c)| {
                let degree = i64::try_from(d).invariant("a degree is below 2^63");
                let power = r.pow(degree).invariant("an exponent is not negative");
                power * Rational::whole(c * Integer::from(weight(d)))
            });
            terms.sum::<Rational>()
        };
        // Both sums are multiplied by the same power of w and the same common denominator, which cancel in the quotient.
        let slope = sum(along(&self.f, vector, w), &r, &|d| d);
        let sizes = along(&self.sizes, &vector.each_ref().map(magnitude), w);
        let sizes = sum(sizes, &r.abs(), &|_| 1);
        slope
            .recip()
            .map_or(f64::INFINITY, |inverse| (sizes * inverse.abs()).to_f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::implicitize::SquaredForm;
    use crate::poly::PlanePolynomial;
    use proptest::prelude::*;

    #[test]
    fn known_conditions() {
        // r = 3: F = x² + y² − 9, and 9 = a0² doubles a relative error of a0.
        let terms = coefficient_conditions(&FourierRadius::new(vec![3.into()], vec![]));
        assert_eq!(terms.terms().next().unwrap(), (&[0, 0, 0], &2.into()));
        // (x − 1)(x − 2) = x² − 3x + 2 at x = 1: (1 + 3 + 2)/|2 − 3|
        let f = [
            ([2, 0, 0], 1.into()),
            ([1, 0, 0], (-3).into()),
            ([0, 0, 0], 2.into()),
        ];
        let conditions = RootConditions::new(&SparsePolynomial::from_terms(f));
        let condition = conditions.at(&[1.into(), 0.into(), 0.into()], &1.into(), 1.0);
        assert!((condition - 6.0).abs() < 1e-15);
    }

    fn expanded(radius: &FourierRadius) -> PlanePolynomial {
        SquaredForm::new(radius)
            .unwrap()
            .expand_unreduced()
            .polynomial()
            .monic()
    }

    proptest! {
        /// The oracle uses central differences, which are exact for a polynomial that is quadratic in every input.
        #[test]
        fn conditions_are_sums_of_derivatives(
            c in prop::collection::vec((-9i32..10, -9i32..10), 1..7)
        ) {
            let (cos, sin): (Vec<Rational>, Vec<Rational>) =
                c.iter().map(|&(a, b)| (Rational::from(a), Rational::from(b))).unzip();
            let radius = FourierRadius::new(cos, sin);
            prop_assume!(!radius.is_zero());
            let f = expanded(&radius);
            let mut sums = std::collections::BTreeMap::<(usize, usize), Rational>::new();
            let half = Rational::from_dyadic(1.into(), -1);
            for n in 0..=radius.harmonics() {
                for is_sine in [false, true] {
                    // F for 3/2 of the input minus F for 1/2 of it is the input times the derivative.
                    let moved = |sign: i32| {
                        let factor = Rational::one() + &half * &Rational::from(sign);
                        let pick = |v: &[Rational], chosen: bool| -> Vec<Rational> {
                            v.iter().enumerate().map(|(m, c)| if chosen && m == n { c * &factor } else { c.clone() }).collect()
                        };
                        let moved = FourierRadius::new(pick(radius.cosines(), !is_sine), pick(radius.sines(), is_sine));
                        expanded(&moved)
                    };
                    for (sign, g) in [(1, moved(1)), (-1, moved(-1))] {
                        for (e, v) in g.terms() {
                            let key = (e.0 * 1000 + e.1, n * 2 + usize::from(is_sine));
                            let sum = sums.entry(key).or_default();
                            *sum = &*sum + &(v * Rational::from(sign));
                        }
                    }
                }
            }
            let found = coefficient_conditions(&radius);
            for ((i, j), v) in f.terms() {
                let of_term = sums.iter().filter(|((term, _), _)| *term == i * 1000 + j);
                let expected: Rational = of_term.map(|(_, d)| d.abs()).sum::<Rational>() / v.abs();
                let e = [u32::try_from(i).unwrap(), u32::try_from(j).unwrap(), 0];
                let condition = found.terms().find(|(x, _)| **x == e).map(|(_, c)| c.clone());
                prop_assert_eq!(condition.unwrap_or_default(), expected, "x^{} y^{}", i, j);
            }
        }
    }

    #[test]
    fn a_simple_root_and_a_nearly_double_one() {
        // (x − 1)(x − 1 − d) on the x axis
        let unit = [1, 0, 0].map(Integer::from);
        let at = |d: f64| {
            let d = Rational::try_from(d).unwrap();
            let terms = [
                ([2, 0, 0], Rational::one()),
                ([1, 0, 0], -(Rational::from(2) + &d)),
                ([0, 0, 0], Rational::one() + d),
            ];
            let conditions = RootConditions::new(&SparsePolynomial::from_terms(terms));
            conditions.at(&unit, &Integer::from(1), 1.0)
        };
        assert!((at(1.0) - 6.0).abs() < 1e-12, "{}", at(1.0));
        assert!((at(2f64.powi(-20)) * 2f64.powi(-20) - 4.0).abs() < 1e-3);
        assert!(at(0.0).is_infinite());
    }
}
