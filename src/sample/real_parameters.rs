//! The points of a plane curve's equation that real parameters of the curve have.

use malachite::Integer;

use super::{Direction, HomogeneousParts, IntegerVector, RaySolver, Sample};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, divide_exactly, integer_sign, polynomial_gcd, scaled};
use crate::roots::{RealRoot, between, disjoint, real_roots};
use crate::shape::PlaneCurve;

/// Tells which real zeros of the equation of a parametric curve are points of the curve, on lines through the origin.
///
/// The curve is closed: the limit for an infinite parameter is a point of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RealParameters {
    /// x(s) and y(s), over `common`.
    coordinates: [IntegerPolynomial; 2],
    common: IntegerPolynomial,
    /// The largest degree of these three.
    degree: usize,
    /// Whether all real zeros of the equation in which it is not singular are on the curve.
    is_general: bool,
}

/// A real value of s.
enum Parameter {
    Finite(RealRoot),
    Infinite,
}

impl RealParameters {
    /// The parameters of a curve that is no point. `is_general` says that all zeros of the equation but finitely many, which are
    /// singular, are on the curve.
    pub(crate) fn new(curve: &PlaneCurve, is_general: bool) -> Self {
        let [x, y] = curve.coordinates();
        let shared = polynomial_gcd(x.denominator(), y.denominator());
        let rest = |f: &IntegerPolynomial| {
            divide_exactly(f, &shared).invariant("a common divisor divides")
        };
        let [of_x, of_y] = [rest(x.denominator()), rest(y.denominator())];
        let common = x.denominator() * &of_y;
        let coordinates = [x.numerator() * of_y, y.numerator() * of_x];
        let lengths = coordinates.iter().chain([&common]);
        let longest = lengths.map(|f| f.coefficients_asc().len()).max();
        Self {
            degree: longest.map_or(0, |length| length - 1),
            coordinates,
            common,
            is_general,
        }
    }

    /// For each root λ ≠ 0 of f(λ·vector/w), where f is the equation: whether λ·vector/w is a point of the curve. The roots must
    /// ascend, and w > 0.
    ///
    /// The parameters of the points on the line are the real zeros of x(s)·v − y(s)·u, and each of them has one λ, which is one
    /// of the roots or 0. Signs of polynomials at s tell between which rational numbers λ is.
    ///
    /// Cost: the real roots of a polynomial with the degree of the curve, and the logarithm of the number of roots in signs for
    /// each of them; nothing if the roots are simple and general points are on the curve.
    pub(crate) fn reach(
        &self,
        [u, v]: [&Integer; 2],
        w: &Integer,
        roots: Vec<RealRoot>,
    ) -> Vec<bool> {
        let is_general = |root: &RealRoot| self.have_all([root.multiplicity()]);
        let mut reached: Vec<bool> = roots.iter().map(is_general).collect();
        if reached.iter().all(|reached| *reached) {
            return reached;
        }
        let separators = between(&disjoint(roots));
        let [x, y] = &self.coordinates;
        let across = scaled(x, v) - scaled(y, u);
        // λ = along/below, and the denominator has the sign of `common`.
        let along = scaled(&(scaled(x, u) + scaled(y, v)), w);
        let below = scaled(&self.common, &(u * u + v * v));
        for s in self.zeros(&across) {
            let denominator = self.sign(&below, &s);
            if denominator == 0 || self.sign(&along, &s) == 0 {
                continue;
            }
            let is_above = |c: &Rational| {
                let difference = scaled(&along, &c.denominator()) - scaled(&below, &c.numerator());
                self.sign(&difference, &s) * denominator > 0
            };
            let index = separators.partition_point(is_above);
            let root = index.checked_sub(1).and_then(|i| reached.get_mut(i));
            *root.invariant("every point of the curve is a zero of its equation") = true;
        }
        reached
    }

    /// Which of all the samples that the solver of the equation finds in a direction are points of the curve.
    pub(crate) fn have<P: HomogeneousParts<2>>(
        &self,
        samples: &[Sample],
        solver: &RaySolver<'_, P, 2>,
        direction: &Direction,
    ) -> Vec<bool> {
        if self.have_all(samples.iter().map(|sample| sample.multiplicity)) {
            return vec![true; samples.len()];
        }
        let roots = solver.exact_distances(direction);
        let mut roots = roots.invariant("only a whole line has no distances");
        roots.reverse();
        let ([u, v], w) = direction.over_common_denominator();
        let mut reached = self.reach([&u, &v], &w, roots);
        reached.reverse();
        reached
    }

    /// Whether it is known without more work that all zeros of the equation on a line are on the curve, of which these are the
    /// multiplicities.
    pub(crate) fn have_all(&self, multiplicities: impl IntoIterator<Item = usize>) -> bool {
        self.is_general && multiplicities.into_iter().all(|m| m == 1)
    }

    /// Whether all zeros of the equation on a line are on the curve if they are simple there.
    pub(crate) fn have_general_points(&self) -> bool {
        self.is_general
    }

    /// Whether vector/w is a point of the curve.
    pub(crate) fn have_point(&self, vector: [&Integer; 2], w: &Integer) -> bool {
        let [x, y] =
            [0, 1].map(|i| scaled(&self.coordinates[i], w) - scaled(&self.common, vector[i]));
        let is_zero = |f: &IntegerPolynomial, s: &Parameter| self.sign(f, s) == 0;
        let mut zeros = self.zeros(&polynomial_gcd(&x, &y)).into_iter();
        zeros.any(|s| is_zero(&x, &s) && is_zero(&y, &s) && !is_zero(&self.common, &s))
    }

    /// The real zeros of f ≠ 0, infinity included.
    fn zeros(&self, f: &IntegerPolynomial) -> Vec<Parameter> {
        let mut zeros: Vec<_> = real_roots(f).into_iter().map(Parameter::Finite).collect();
        if self.sign(f, &Parameter::Infinite) == 0 {
            zeros.push(Parameter::Infinite);
        }
        zeros
    }

    /// The sign of f at s; at infinity that of the coefficient of the largest degree.
    fn sign(&self, f: &IntegerPolynomial, s: &Parameter) -> i8 {
        match s {
            Parameter::Finite(s) => s.sign_of(f),
            Parameter::Infinite => match f.coefficients_asc().get(self.degree) {
                Some(c) => integer_sign(c),
                None => 0,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use malachite::base::num::basic::traits::One;
    use malachite::base::polynomial::Polynomial;
    use proptest::prelude::*;

    use super::*;
    use crate::exact::Rational;
    use crate::implicitize::implicitize_plane;
    use crate::limits::Limits;
    use crate::poly::PlanePolynomial;
    use crate::sample::along;
    use crate::shape::Form;

    fn curve(text: &str) -> PlaneCurve {
        match text.parse() {
            Ok(Form::PlaneCurve(curve)) => curve,
            other => unreachable!("{other:?}"),
        }
    }

    /// The roots λ of f(λ·vector) and which of them are reached.
    fn reached(curve: &PlaneCurve, is_general: bool, vector: [i64; 2]) -> Vec<(f64, bool)> {
        let equation = implicitize_plane(curve, &Limits::none()).unwrap().curve;
        let vector = vector.map(Integer::from);
        let roots = roots_on(equation.polynomial(), &vector);
        let values: Vec<f64> = roots.iter().map(RealRoot::to_f64).collect();
        let parameters = RealParameters::new(curve, is_general);
        let [u, v] = &vector;
        let found = parameters.reach([u, v], &Integer::ONE, roots);
        values.into_iter().zip(found).collect()
    }

    /// The real roots other than 0 of f(λ·vector), ascending.
    fn roots_on(f: &PlanePolynomial, vector: &[Integer; 2]) -> Vec<RealRoot> {
        let terms = along(f, vector, &Integer::ONE);
        let lowest = terms.last().map_or(0, |(d, _)| *d);
        let highest = terms.first().map_or(0, |(d, _)| *d);
        let mut dense = vec![Integer::from(0); highest - lowest + 1];
        for (d, c) in terms {
            dense[d - lowest] = c;
        }
        real_roots(&IntegerPolynomial::from_coefficients_asc(dense))
    }

    #[test]
    fn arcs_end_where_the_curve_turns_back() {
        // y = x² between x = −1 and 1; the points of the line y = 2x are at λ = 2 and 0.
        let folded = curve("x = cos(t); y = cos(t)^2");
        assert_eq!(reached(&folded, false, [1, 2]), [(2.0, false)]);
        assert_eq!(reached(&folded, false, [1, 1]), [(1.0, true)]);
        assert_eq!(reached(&folded, false, [-2, 1]), [(0.5 / 2.0, true)]);
        // The half of the circle with x ≥ 0, ends included.
        let half = curve("x = (1-sin(t)^2)/(1+sin(t)^2); y = 2*sin(t)/(1+sin(t)^2)");
        assert_eq!(reached(&half, false, [1, 0]), [(-1.0, false), (1.0, true)]);
        assert_eq!(reached(&half, false, [0, 1]), [(-1.0, true), (1.0, true)]);
    }

    #[test]
    fn isolated_points_and_infinite_parameters() {
        // y² = x² (x − 1) moved by (1, 0): only complex parameters have the double point.
        let isolated = curve("x = t^2 + 2; y = t*(t^2 + 1)");
        assert_eq!(
            reached(&isolated, true, [1, 0]),
            [(1.0, false), (2.0, true)]
        );
        // The circle without the limit at infinity is closed.
        let circle = curve("x = (1-t^2)/(1+t^2); y = 2*t/(1+t^2)");
        assert_eq!(reached(&circle, false, [1, 0]), [(-1.0, true), (1.0, true)]);
        let has_origin = |curve: &PlaneCurve| {
            let (zero, one) = (Integer::from(0), Integer::ONE);
            RealParameters::new(curve, true).have_point([&zero; 2], &one)
        };
        assert!(!has_origin(&circle));
        let through = curve("x = 1+(1-t^2)/(1+t^2); y = 2*t/(1+t^2)");
        assert!(has_origin(&through));
        assert!(!has_origin(&isolated));
    }

    proptest! {
        /// The curve (x(m), y(m)) for m = sin t or m = t²: a point that a rational m has is on it exactly if m is in the range.
        #[test]
        fn points_are_on_the_curve_if_their_parameter_is_real(
            x in prop::collection::vec(-4i64..5, 4),
            y in prop::collection::vec(-4i64..5, 3),
            (p, q) in (-9i64..10, 1i64..5),
            bounded in prop::bool::ANY,
        ) {
            let m = if bounded { "sin(t)" } else { "t^2" };
            let written = |c: &[i64]| -> String {
                let terms = c.iter().enumerate().map(|(k, c)| format!("+ ({c})*({m})^{k}"));
                terms.collect()
            };
            // In both coordinates together every value of m has its own point.
            let text = format!("x = 0 {} + ({m})^4; y = 0 {} + ({m})^3", written(&x), written(&y));
            let curve = curve(&text);
            let m = Rational::from(p) / Rational::from(q);
            let value = |c: &[i64], top: i64| {
                let sum = c.iter().rev().fold(Rational::zero(), |sum, c| sum * &m + Rational::from(*c));
                sum + m.pow(top).unwrap()
            };
            let point = [value(&x, 4), value(&y, 3)];
            let whole = point[0].denominator() * point[1].denominator();
            let vector = point.each_ref().map(|v| (v * &Rational::whole(&whole)).numerator());
            prop_assume!(vector != [Integer::from(0), Integer::from(0)]);
            let equation = implicitize_plane(&curve, &Limits::none()).unwrap();
            let parameters = RealParameters::new(&curve, false);
            let roots = roots_on(equation.curve.polynomial(), &vector);
            let place = Rational::one() / Rational::whole(&whole);
            let index = roots.iter().position(|root| root.cmp_rational(&place).is_eq());
            let index = index.invariant("a point of the curve is a zero of its equation");
            // A point with two values of m may be reached by the other one.
            let is_simple = roots[index].multiplicity() == 1;
            let [u, v] = &vector;
            let found = parameters.reach([u, v], &Integer::ONE, roots);
            prop_assert_eq!(found[index], parameters.have_point([u, v], &whole), "{}", text);
            if is_simple {
                let is_in_range = if bounded { m.abs() <= Rational::one() } else { m.signum() >= 0 };
                prop_assert_eq!(found[index], is_in_range, "{}", text);
            }
        }
    }
}
