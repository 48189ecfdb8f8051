//! Points on a patch over a grid of parameters.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use super::curve_values::{CurveValues, Value};
use super::drawn::{DRAWN_NUMBERS, Ratio};
use super::{Patch, PatchFunction};
use crate::exact::Dyadic;
use crate::poly::{IntegerPolynomial, SparsePolynomial};

/// A point of the grid: the coordinates, which are not finite at poles, and the signs of the denominators.
pub(super) type Node = [Value; 3];

/// The point of a node; `None` at a pole.
pub(super) fn point(node: &Node) -> Option<[f64; 3]> {
    let point = node.map(|v| v.value);
    point.iter().all(|v| v.is_finite()).then_some(point)
}

impl Patch {
    /// The points of the surface on a grid of parameters, with a row for each value of the first parameter; `None` at poles. The
    /// coordinates have at least 6 correct digits, or an error below 10⁻⁹ of the sum of all amplitudes.
    ///
    /// Without ranges the grid covers a full period of an angle, and −3/2 to 3/2 for a number.
    #[must_use]
    pub fn grid(
        &self,
        ranges: [Option<[f64; 2]>; 2],
        counts: [u32; 2],
    ) -> Vec<Vec<Option<[f64; 3]>>> {
        let nodes = self.nodes(ranges, counts);
        let points = |row: &Vec<Node>| row.iter().map(point).collect();
        nodes.iter().map(points).collect()
    }

    /// The grid with the signs of the denominators.
    pub(super) fn nodes(&self, ranges: [Option<[f64; 2]>; 2], counts: [u32; 2]) -> Vec<Vec<Node>> {
        let [first, second] = [0, 1].map(|k| {
            let parameter = &self.parameters()[k];
            let range = if parameter.is_angle() {
                ranges[k]
            } else {
                ranges[k].or(Some(DRAWN_NUMBERS))
            };
            let values = parameter.values(range, counts[k].max(1)).into_iter();
            values.map(|v| parameter.ratio(v)).collect::<Vec<_>>()
        });
        let rows = first.iter().map(|s| self.row(*s));
        rows.map(|row| second.iter().map(|t| row.at(*t)).collect())
            .collect()
    }

    /// The coordinates for an exact value of s1 near the given one, as functions of s2.
    fn row(&self, s: Ratio) -> CurveValues<3> {
        let functions = self.coordinates().each_ref().map(|f: &PatchFunction| {
            let degree = f.degree_in(0);
            let parts = [f.numerator(), f.denominator()].map(|part| restricted(part, degree, s));
            (parts, f.degree_in(1) as usize)
        });
        CurveValues::of_quotients(self.parameters()[1].is_angle(), functions)
    }
}

/// A multiple of f(a/b, s2), for the numerator and for the denominator of one degree in s1 by the same factor. It has the sign of
/// b^degree f(a/b, s2).
fn restricted(f: &SparsePolynomial<2>, degree: u32, [a, b]: Ratio) -> IntegerPolynomial {
    let length = f.degree_in(1) as usize + 1;
    let mut sums = vec![Integer::ZERO; length];
    let quotient = Dyadic::from_f64(a / b);
    // The powers of p and q with a/b = p/q, and 1 and 0 for an infinite quotient.
    let (p, shift) = match &quotient {
        Some(s) if s.exponent() >= 0 => (s.mantissa() << s.exponent().unsigned_abs(), Some(0)),
        Some(s) => (s.mantissa().clone(), Some(s.exponent().unsigned_abs())),
        None => (Integer::ONE, None),
    };
    let mut powers = vec![Integer::ONE];
    for k in 0..degree as usize {
        powers.push(&powers[k] * &p);
    }
    for (&[i, j], c) in f.terms() {
        let term = &powers[i as usize] * c.numerator();
        let below = degree - i;
        match shift {
            Some(shift) => sums[j as usize] += term << (shift * u64::from(below)),
            None if below == 0 => sums[j as usize] += term,
            None => {}
        }
    }
    if b < 0.0 && !degree.is_multiple_of(2) {
        for sum in &mut sums {
            *sum = -&*sum;
        }
    }
    IntegerPolynomial::from_coefficients_asc(sums)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::shape::Form;

    pub(in crate::shape) fn patch(text: &str) -> Patch {
        match text.parse() {
            Ok(Form::Patch(patch)) => patch,
            other => unreachable!("{other:?}"),
        }
    }

    /// The value k of 0, 1, …, `count` between a and b.
    fn between(a: f64, b: f64, k: usize, count: u32) -> f64 {
        let part = f64::from(u32::try_from(k).unwrap()) / f64::from(count);
        a * (1.0 - part) + b * part
    }

    #[test]
    fn values_near_a_root_of_high_order_have_correct_digits() {
        for patch in [
            patch("x = u; y = v; z = (u-100)^7 + (v-100)^7"),
            patch("x = v; y = u; z = (u-100)^7*(v-99)^5/(v+1)"),
        ] {
            let grid = patch.grid([Some([99.0, 101.0]), Some([99.5, 101.0])], [7, 9]);
            for (i, row) in grid.iter().enumerate() {
                for (j, point) in row.iter().enumerate() {
                    let s = [between(99.0, 101.0, i, 7), between(99.5, 101.0, j, 9)];
                    let exact = patch.point(&s.map(|v| Dyadic::from_f64(v).unwrap().to_rational()));
                    let exact = exact.unwrap().map(|v| v.to_f64());
                    for (near, exact) in point.unwrap().into_iter().zip(exact) {
                        assert!((near - exact).abs() < 1e-10 + 1e-6 * exact.abs(), "{s:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn many_oscillations_have_correct_values() {
        let patch = patch("x = cos(70*u)*(2+cos(v)); y = sin(u)*cos(60*v); z = sin(61*v + 3*u)");
        let grid = patch.grid([None; 2], [23, 19]);
        for (i, row) in grid.iter().enumerate() {
            for (j, point) in row.iter().enumerate() {
                let tau = std::f64::consts::TAU;
                let (u, v) = (between(0.0, tau, i, 23), between(0.0, tau, j, 19));
                let exact = [
                    (70.0 * u).cos() * (2.0 + v.cos()),
                    u.sin() * (60.0 * v).cos(),
                    (61.0 * v + 3.0 * u).sin(),
                ];
                for (near, exact) in point.unwrap().into_iter().zip(exact) {
                    assert!((near - exact).abs() < 1e-8, "{u} {v}");
                }
            }
        }
    }

    #[test]
    fn an_infinite_range_ends() {
        let grid = patch("x = 1/u; y = v; z = 1").grid([Some([1.0, f64::INFINITY]), None], [2, 2]);
        assert!(grid.iter().all(|row| row.len() == 3));
    }

    #[test]
    fn an_infinite_parameter_takes_the_leading_coefficients() {
        // At u = π, s1 is infinite.
        let patch = patch("x = cos(u); y = sin(u)*v; z = v^2");
        let values = patch.row([1.0, 0.0]).at([3.0, 1.0]).map(|v| v.value);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(near(values[0], -1.0) && near(values[1], 0.0) && near(values[2], 9.0));
    }
}
