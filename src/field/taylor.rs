//! Taylor coefficients of a polynomial about a point, in doubles with a bound for the error of each.

use std::collections::{BTreeSet, HashMap};

use super::{Field, UNIT};
use crate::exact::Rational;

/// The monomials that Taylor expansions of one polynomial have, and how a shift of the variables acts on them.
#[derive(Debug)]
pub(super) struct Layout {
    /// By total degree, ascending: all divisors of the monomials of f.
    pub(super) exponents: Vec<[usize; 3]>,
    /// For every axis the places of the monomials on a line along it, of ascending exponent.
    lines: [Vec<Vec<usize>>; 3],
    /// α!/|α|! for every monomial: the weights of Bombieri's norm.
    pub(super) weights: Vec<f64>,
    /// The places of the terms of f, in their order.
    terms: Vec<usize>,
}

/// f(m + v) = Σ g_α v^α, with |computed − exact| at most the error of the same place.
pub(crate) struct Taylor {
    pub(super) coefficients: Vec<f64>,
    pub(super) errors: Vec<f64>,
}

impl Layout {
    pub(super) fn new(terms: &[([usize; 3], f64)]) -> Self {
        let mut all = BTreeSet::from([(0, [0; 3])]);
        for ([i, j, k], _) in terms {
            let divisors =
                (0..=*i).flat_map(|a| (0..=*j).flat_map(move |b| (0..=*k).map(move |c| [a, b, c])));
            all.extend(divisors.map(|e| (e.iter().sum::<usize>(), e)));
        }
        let exponents: Vec<[usize; 3]> = all.into_iter().map(|(_, e)| e).collect();
        let places: HashMap<[usize; 3], usize> =
            exponents.iter().enumerate().map(|(n, e)| (*e, n)).collect();
        let lines = [0, 1, 2].map(|axis| {
            let starts = exponents.iter().filter(|e| e[axis] == 0);
            let line = |start: &[usize; 3]| -> Vec<usize> {
                let along = (0..).map(|k| {
                    let mut e = *start;
                    e[axis] = k;
                    places.get(&e).copied()
                });
                along.map_while(|place| place).collect()
            };
            starts.map(line).filter(|l| l.len() > 1).collect()
        });
        Self {
            weights: exponents.iter().map(weight).collect(),
            terms: terms.iter().map(|(e, _)| places[e]).collect(),
            exponents,
            lines,
        }
    }
}

/// α!/|α|!
#[expect(clippy::cast_precision_loss, reason = "degrees are small")]
fn weight(e: &[usize; 3]) -> f64 {
    let mut product = 1.0;
    let mut order = 0;
    for k in e {
        for i in 1..=*k {
            order += 1;
            product *= i as f64 / f64::from(order);
        }
    }
    product
}

impl Field {
    /// The Taylor coefficients about a point: x → m + x, variable by variable, each by repeated synthetic division.
    ///
    /// The same is done with |f| about |m|: every coefficient is a sum of products that are rounded at most 3·degree times
    /// in every variable, so its error is less than that many units of the sum of their sizes.
    #[expect(clippy::cast_precision_loss, reason = "degrees are small")]
    pub(crate) fn taylor(&self, middle: [f64; 3]) -> Taylor {
        let layout = &self.layout;
        let mut g = vec![0.0; layout.exponents.len()];
        let mut sizes = g.clone();
        for (place, (_, c)) in layout.terms.iter().zip(&self.terms) {
            g[*place] = *c;
            sizes[*place] = c.abs();
        }
        for (axis, m) in middle.into_iter().enumerate() {
            for line in &layout.lines[axis] {
                for first in 0..line.len() - 1 {
                    for i in (first..line.len() - 1).rev() {
                        let (to, from) = (line[i], line[i + 1]);
                        g[to] += m * g[from];
                        sizes[to] += m.abs() * sizes[from];
                    }
                }
            }
        }
        let roundings = 4 * self.degrees.iter().sum::<usize>() + 8;
        let relative = 1.01 * UNIT * roundings as f64;
        let tiny = self.tiny(middle);
        for size in &mut sizes {
            *size = relative * *size + tiny;
        }
        Taylor {
            coefficients: g,
            errors: sizes,
        }
    }
}

impl Field {
    /// The same with exact coefficients: only the last step is rounded.
    pub(super) fn exact_taylor(&self, middle: &[Rational; 3]) -> Taylor {
        let layout = &self.layout;
        let mut g = vec![Rational::zero(); layout.exponents.len()];
        for (place, (_, c)) in layout.terms.iter().zip(self.exact.terms()) {
            g[*place] = c.clone();
        }
        for (axis, m) in middle.iter().enumerate().filter(|(_, m)| !m.is_zero()) {
            for line in &layout.lines[axis] {
                for first in 0..line.len() - 1 {
                    for i in (first..line.len() - 1).rev() {
                        g[line[i]] = &g[line[i]] + &(m * &g[line[i + 1]]);
                    }
                }
            }
        }
        let coefficients: Vec<f64> = g.iter().map(Rational::to_f64).collect();
        let errors = coefficients
            .iter()
            .map(|c| UNIT * c.abs() + f64::MIN_POSITIVE);
        Taylor {
            errors: errors.collect(),
            coefficients,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::tests::cubic;
    use proptest::prelude::*;

    proptest! {
        /// The coefficients are those of the exact shift, within their errors; so f(m + v) is their sum.
        #[test]
        fn coefficients_are_within_their_errors(c in prop::collection::vec(-9i64..10, 20), m in prop::array::uniform3(-3.0f64..3.0), v in prop::array::uniform3(-2i64..3)) {
            let field = Field::new(&cubic(&c));
            let taylor = field.taylor(m);
            let exact = |x: f64| Rational::try_from(x).unwrap();
            let at = std::array::from_fn(|i| exact(m[i]) + Rational::from(v[i]));
            let [mut sum, mut error] = [Rational::zero(), Rational::zero()];
            for (n, e) in field.layout.exponents.iter().enumerate() {
                let power = e.iter().zip(v).fold(Rational::one(), |p, (k, x)| p * Rational::from(x).pow(i64::try_from(*k).unwrap()).unwrap());
                sum = sum + exact(taylor.coefficients[n]) * &power;
                error = error + exact(taylor.errors[n]) * power.abs();
            }
            prop_assert!((sum - field.exact.evaluate(&at)).abs() <= error);
        }
    }

    #[test]
    fn weights_are_those_of_bombieri() {
        for (e, expected) in [([2, 0, 0], 1.0), ([1, 1, 0], 0.5), ([1, 1, 1], 1.0 / 6.0)] {
            assert!((weight(&e) - expected).abs() < 1e-15);
        }
    }
}
