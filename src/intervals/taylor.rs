//! Taylor coefficients of a polynomial about a point, in doubles with a bound of each error.

use std::collections::{BTreeSet, HashMap};

use super::interval::{Interval, UNIT, relative_error};
use super::{FLOOR, Field};
use crate::exact::Rational;

/// The monomials of the Taylor expansions of one polynomial, and the positions that a shift of the variables combines.
#[derive(Debug)]
pub(super) struct Layout {
    /// The exponents of the monomials, ascending by total degree: all divisors of the monomials of f.
    pub(super) exponents: Vec<[usize; 3]>,
    /// For every axis, the positions of the monomials on each line along it, by ascending exponent.
    lines: [Vec<Vec<usize>>; 3],
    /// The number α!/|α|! for every monomial α: the weights of Bombieri's norm.
    pub(super) weights: Vec<f64>,
    /// The positions of the terms of f, in their order.
    terms: Vec<usize>,
    /// The error of a coefficient in doubles, in parts of the result of the same operations on absolute values.
    relative: f64,
    /// The relative error of the squares of Bombieri's norms.
    pub(super) relative_of_norms: f64,
}

/// The coefficients g_α of f(m + v) = Σ g_α v^α. The error of a coefficient is at most the number at the same position of the
/// errors.
pub(crate) struct Taylor {
    pub(super) coefficients: Vec<f64>,
    pub(super) errors: Vec<f64>,
}

impl Taylor {
    /// The coefficient at a position, as an interval.
    pub(super) fn at(&self, place: usize) -> Interval {
        Interval::around(self.coefficients[place], self.errors[place])
    }
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
        let degree = |axis: usize| exponents.iter().map(|e| e[axis]).max();
        let degrees: usize = (0..3).filter_map(degree).sum();
        Self {
            relative: relative_error(3 * degrees + 5),
            relative_of_norms: relative_error(2 * degrees + 3 + exponents.len()),
            weights: exponents.iter().map(weight).collect(),
            terms: terms.iter().map(|(e, _)| places[e]).collect(),
            exponents,
            lines,
        }
    }
}

/// The number α!/|α|!.
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
    /// The Taylor coefficients about a point. The shift x → m + x is made variable by variable, each by repeated synthetic
    /// division.
    ///
    /// Lemma 6. Let D be the sum of the degrees. The error of every coefficient is at most `relative_error(3D + 5)` times the
    /// result of the same operations for the coefficients |c| + `FLOOR` and the point |m|.
    ///
    /// Proof. A coefficient is rounded once, and once more with `FLOOR` added. There are D passes and D steps: a contribution
    /// is rounded once in each pass in which it stays, and twice in each step (product and sum), together 3D times (Lemma 2).
    /// The last product here is one more rounding. A loss by underflow at a position is multiplied like the `FLOOR` of that
    /// position, so these losses and those of the absolute values count as less than two more (Lemma 3).
    ///
    /// Law: `coefficients_are_within_their_errors`.
    pub(crate) fn taylor(&self, middle: [f64; 3]) -> Taylor {
        let layout = &self.layout;
        let mut g = vec![0.0; layout.exponents.len()];
        let mut sizes = vec![FLOOR; g.len()];
        for (place, (_, c)) in layout.terms.iter().zip(&self.terms) {
            g[*place] = *c;
            sizes[*place] += c.abs();
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
        for size in &mut sizes {
            *size *= layout.relative;
        }
        Taylor {
            coefficients: g,
            errors: sizes,
        }
    }
}

impl Field {
    /// The coefficients by exact arithmetic. Only the result is rounded, to nearest, so the error is at most `UNIT` times the
    /// absolute value of the result, or half of the least subnormal double.
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
    use crate::intervals::rationals;
    use crate::intervals::tests::{nasty_cubics, nasty_points, taylor_coefficient};
    use crate::poly::{Ring, SparsePolynomial};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

        /// Lemma 6, and the bound for the expansion with exact coefficients.
        #[test]
        fn coefficients_are_within_their_errors(f in nasty_cubics(), m in nasty_points()) {
            let field = Field::new(&f);
            let exactly = rationals(m);
            let [taylor, exact] = [field.taylor(m), field.exact_taylor(&exactly)];
            for (n, e) in field.layout.exponents.iter().enumerate() {
                let value = taylor_coefficient(field.polynomial(), e, &exactly);
                for found in [&taylor, &exact] {
                    if found.coefficients[n].is_finite() && found.errors[n].is_finite() {
                        let error = (Rational::try_from(found.coefficients[n]).unwrap() - &value).abs();
                        prop_assert!(error <= Rational::try_from(found.errors[n]).unwrap(), "{e:?}");
                    }
                    prop_assert!(found.at(n).contains(&value));
                }
            }
        }
    }

    /// Some errors are an eighth of their bounds.
    #[test]
    fn errors_of_coefficients_are_reached() {
        let [x, _, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
        let mut most = 0.0f64;
        for k in 3..100 {
            let part = Rational::from(1) / Rational::from(k);
            let field = Field::new(&x.plus(&z.scaled(&part)));
            for j in 1..60 {
                let m = [1.0 / 128.0, 0.0, 1.0 + f64::from(j) / 60.0];
                let taylor = field.taylor(m);
                let value = field.polynomial().evaluate(&rationals(m));
                let error = (Rational::try_from(taylor.coefficients[0]).unwrap() - &value).abs();
                most = most.max(error.to_f64() / taylor.errors[0]);
            }
        }
        assert!((0.125..=1.0).contains(&most), "{most}");
    }

    #[test]
    fn weights_are_those_of_bombieri() {
        for (e, expected) in [([2, 0, 0], 1.0), ([1, 1, 0], 0.5), ([1, 1, 1], 1.0 / 6.0)] {
            assert!((weight(&e) - expected).abs() < 1e-15);
        }
    }
}
