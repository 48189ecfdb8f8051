//! The number of parameter values for each value of s, on which the coordinates depend.

use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Gcd;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, SparsePolynomial};
use crate::shape::{ParametricCurve, Patch};

/// The number of parameter values for each value of s, as the quotient `turns/parts`. The coordinates of a curve or a patch are
/// functions of s, or of s1 and s2.
///
/// A parameter t that is a number has one value for each s = t. An angle t runs through [0, 2π], or through the shortest common
/// period of the coordinates that is not below 2π. With s = tan(g·t/2) the coordinates have the period 2π/g, perhaps divided by
/// an integer `parts`. So the period is 2π/g₀ with g₀ = `parts`·g, and the angle runs through `turns` = ⌈g₀⌉ periods. The
/// numbers depend on the functions alone, not on how they are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    turns: usize,
    parts: usize,
}

impl Run {
    /// The numbers for a curve that is not a point.
    #[must_use]
    pub(crate) fn of<const N: usize>(curve: &ParametricCurve<N>) -> Self {
        let Some(step) = curve.parameter().step() else {
            return Self { turns: 1, parts: 1 };
        };
        let gaps = curve.coordinates().iter();
        let gaps = gaps.map(|f| gap_of_exponents(&[f.numerator(), f.denominator()], f.degree()));
        Self::with_gaps(step, gaps)
    }

    /// The numbers for a patch. Its parameters are independent, so the numbers are products.
    #[must_use]
    pub(crate) fn of_patch(patch: &Patch) -> Self {
        let mut run = Self { turns: 1, parts: 1 };
        for (v, parameter) in patch.parameters().iter().enumerate() {
            let Some(step) = parameter.step() else {
                continue;
            };
            let gaps = patch.coordinates().iter().map(|f| {
                let rows = [f.numerator(), f.denominator()].map(|p| in_one_variable(p, v));
                let rows: Vec<&IntegerPolynomial> = rows.iter().flatten().collect();
                let lengths = rows.iter().map(|row| row.coefficients_asc().len());
                // The degree of the function is the larger one; it is 0 for a constant.
                let degree = lengths.max().invariant("a denominator has a term") - 1;
                gap_of_exponents(&rows, degree)
            });
            let one = Self::with_gaps(step, gaps);
            run.turns *= one.turns;
            run.parts *= one.parts;
        }
        run
    }

    fn with_gaps(step: &Rational, gaps: impl Iterator<Item = usize>) -> Self {
        // The gap of a coordinate that does not depend on the angle is 0.
        let parts = gaps.fold(0, |a: usize, b| a.gcd(b)).max(1);
        let step = step * &Rational::whole(Integer::from(parts));
        let turns = -(-step).floor_integer();
        Self {
            turns: usize::try_from(&turns).invariant("an angle has a short positive step"),
            parts,
        }
    }

    /// The number of parameter values of a point that has `count` values of s. `parts` must divide `count` · `turns`: the point
    /// does not change after one part of a period.
    #[must_use]
    pub(crate) fn count(&self, count: usize) -> usize {
        self.checked_count(count)
            .invariant("turning through a part of the period permutes the values of s")
    }

    /// The same number if `count` is not proved to be right; `None` if it is not divisible.
    #[must_use]
    pub(crate) fn checked_count(&self, count: usize) -> Option<usize> {
        let whole = count * self.turns;
        whole.is_multiple_of(self.parts).then(|| whole / self.parts)
    }
}

/// The coefficients of the powers of the other variable, as polynomials in s_v.
fn in_one_variable(f: &SparsePolynomial<2>, v: usize) -> Vec<IntegerPolynomial> {
    let mut rows: BTreeMap<u32, Vec<Integer>> = BTreeMap::new();
    for (e, c) in f.primitive().terms() {
        let row = rows.entry(e[1 - v]).or_default();
        let k = e[v] as usize;
        row.resize(row.len().max(k + 1), Integer::ZERO);
        row[k] = c.numerator();
    }
    let rows = rows.into_values();
    rows.map(IntegerPolynomial::from_coefficients_asc).collect()
}

/// The largest number n such that f(s) is a function of z^n, where z = e^(iθ) and s = tan(θ/2); 0 for a constant. The given
/// polynomials in s are the coprime numerator and denominator of f, or their coefficients, of degree at most `degree`.
///
/// With s = −i(z − 1)/(z + 1) numerator and denominator become coprime forms in z. f does not change under z ↦ ζz exactly if
/// both get the same factor. That holds for all ζ with ζ^n = 1 exactly if all exponents in both are equal modulo n.
fn gap_of_exponents(polynomials: &[&IntegerPolynomial], degree: usize) -> usize {
    let polynomials = polynomials.iter();
    let exponents = polynomials.flat_map(|p| exponents_in_z(p, degree));
    let exponents: Vec<usize> = exponents.collect();
    let Some(least) = exponents.iter().min() else {
        return 0;
    };
    exponents.iter().fold(0, |gap: usize, e| gap.gcd(e - least))
}

/// The exponents of `Σ c_k (−i)^k (z − 1)^k (z + 1)^(degree−k)`.
fn exponents_in_z(p: &IntegerPolynomial, degree: usize) -> Vec<usize> {
    let line = |low: i64| IntegerPolynomial::from_coefficients_asc(vec![low.into(), 1.into()]);
    let (minus, plus) = (line(-1), line(1));
    // Horner's rule in z − 1, with the powers of z + 1, for the real and the imaginary part.
    let mut value = [IntegerPolynomial::ZERO, IntegerPolynomial::ZERO];
    let mut power = IntegerPolynomial::from_coefficients_asc(vec![1.into()]);
    for k in (0..=degree).rev() {
        for part in &mut value {
            *part *= &minus;
        }
        if let Some(c) = p.coefficients_asc().get(k) {
            let term = &power * IntegerPolynomial::from_coefficients_asc(vec![c.clone()]);
            match k % 4 {
                0 => value[0] += term,
                1 => value[1] -= term,
                2 => value[0] -= term,
                _ => value[1] += term,
            }
        }
        power *= &plus;
    }
    let is_there = |part: &IntegerPolynomial, e: usize| {
        part.coefficients_asc()
            .get(e)
            .is_some_and(|c| *c != Integer::ZERO)
    };
    (0..=degree)
        .filter(|&e| value.iter().any(|part| is_there(part, e)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::implicitize::tracing::tracing_index_bound;
    use crate::language::{Numbers, parse_form};
    use crate::shape::Form;

    fn tracing(text: &str) -> usize {
        let form = parse_form(text, "<form>", Numbers::Exact).unwrap();
        let Form::PlaneCurve(curve) = form else {
            panic!("a plane curve")
        };
        Run::of(&curve).count(tracing_index_bound(curve.coordinates()))
    }

    #[test]
    fn the_tracing_index_does_not_depend_on_spelling() {
        let spellings: [(usize, &[&str]); 9] = [
            (
                1,
                &[
                    "x = cos(t); y = sin(t)",
                    "x = cos(t/2)^2 - sin(t/2)^2; y = 2*sin(t/2)*cos(t/2)",
                    "x = 1 - 2*sin(t/2)^2; y = sin(t)",
                ],
            ),
            (
                2,
                &[
                    "x = cos(t); y = cos(2t)",
                    "x = cos(t); y = 2*cos(t)^2 - 1",
                    "x = cos(t/2)^2 - sin(t/2)^2; y = cos(2t)",
                ],
            ),
            (
                2,
                &[
                    "x = cos(2t); y = sin(2t)",
                    "x = cos(t)^2 - sin(t)^2; y = 2*sin(t)*cos(t)",
                    "x = cos(t)^4 - sin(t)^4; y = sin(2t)",
                ],
            ),
            (
                3,
                &[
                    "x = cos(3t); y = sin(3t)",
                    "x = 4*cos(t)^3 - 3*cos(t); y = 3*sin(t) - 4*sin(t)^3",
                ],
            ),
            // The longer common period is [0, 4π].
            (
                1,
                &[
                    "x = cos(t/2); y = sin(t/2)",
                    "x = cos(t/4)^2 - sin(t/4)^2; y = sin(t/2)",
                ],
            ),
            (
                2,
                &[
                    "x = cos(t/2); y = cos(t)",
                    "x = cos(t/2); y = 2*cos(t/2)^2 - 1",
                ],
            ),
            // The longer common period is [0, 3π].
            (
                1,
                &[
                    "x = cos(2t/3); y = sin(2t/3)",
                    "x = cos(t/3)^2 - sin(t/3)^2; y = 2*sin(t/3)*cos(t/3)",
                ],
            ),
            (
                2,
                &[
                    "x = tan(t); y = tan(t)^2",
                    "x = sin(t)/cos(t); y = 1/cos(t)^2 - 1",
                    "x = tan(t); y = (1 - cos(2t))/(1 + cos(2t))",
                ],
            ),
            (
                1,
                &[
                    "x = cos(t) + cos(3t)/2; y = sin(t)",
                    "x = t; y = t^2",
                    "x = (1 - t^2)/(1 + t^2); y = 2t/(1 + t^2)",
                ],
            ),
        ];
        for (index, texts) in spellings {
            for text in texts {
                assert_eq!(tracing(text), index, "{text}");
            }
        }
    }

    #[test]
    fn the_parameters_of_a_patch_run_independently() {
        let run = |text: &str| {
            let form = parse_form(text, "<form>", Numbers::Exact).unwrap();
            let Form::Patch(patch) = form else {
                panic!("a patch")
            };
            Run::of_patch(&patch)
        };
        let once = run("x = cos(u)*sin(v); y = sin(u)*sin(v); z = cos(v)");
        assert_eq!(once.count(2), 2);
        let twice = run("x = cos(2u)*sin(v); y = sin(2u)*sin(v); z = cos(v)");
        assert_eq!(twice.count(2), 4);
        // The same curve with u has the period π in u; tan(u/2) has four values, as many as before.
        let written =
            run("x = (cos(u)^2 - sin(u)^2)*sin(v); y = 2*sin(u)*cos(u)*sin(v); z = cos(v)");
        assert_eq!(written.count(4), 4);
    }
}
