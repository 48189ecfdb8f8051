//! The Taylor expansion of f around a point: the value, the gradient, the curvature, and bounds of the rest.

use std::cell::OnceCell;

use nalgebra::Matrix3;
use smallvec::SmallVec;

use super::interval::{Interval, product, square};
use super::spectrum::{least_across, spectrum};
use super::{Field, Taylor};
use crate::exact::Rational;

/// The expansion f(m + w) = value + gradient·w + wᵀ hessian w/2 + Σ f_k(w), with |f_k(w)| ≤ norm_k |w|^k. If f does not depend
/// on z, all w must be in the plane of x and y.
///
/// The norms are Bombieri's, √(Σ c_α² α!/k!). They bound a form on the unit sphere.
#[derive(Clone, Debug)]
pub(crate) struct Local {
    pub(crate) value: Interval,
    pub(crate) gradient: [Interval; 3],
    hessian: Matrix3<f64>,
    /// The error of wᵀ hessian w/2, in parts of |w|².
    quadratic_error: f64,
    /// A lower and an upper bound of the eigenvalues of `hessian`, computed when they are first needed.
    spectrum: OnceCell<[f64; 2]>,
    /// The norms for k = 3, 4, …, including the errors of the coefficients.
    norms: SmallVec<[f64; 12]>,
}

impl Field {
    /// The expansion about a point, in doubles.
    pub(crate) fn local(&self, middle: [f64; 3]) -> Local {
        self.local_of(&self.taylor(middle))
    }

    /// The expansion with exact coefficients, which are rounded at the end.
    ///
    /// Cost: for degree n, about n times as many exact operations as there are monomials.
    pub(crate) fn exact_local(&self, middle: &[Rational; 3]) -> Local {
        self.local_of(&self.exact_taylor(middle))
    }

    /// Lemma 9. The computed norms are at least Bombieri's norms of the exact forms, if r bounds the relative error of their
    /// squares and 2^(−1022) is added to the squares.
    ///
    /// Proof. A summand is rounded once as |g| + error, which counts twice in its square, twice for every factor of its weight,
    /// and once in the product: 2k + 3 times; the sum is rounded once for every monomial (Lemma 2). At most two products of
    /// each summand underflow, by 2^(−1075), and the weight is at most 1.
    ///
    /// Law: `curvature_bounds_the_second_order`.
    fn local_of(&self, taylor: &Taylor) -> Local {
        let layout = &self.layout;
        let mut local = Local {
            value: taylor.at(0),
            gradient: [Interval::ZERO; 3],
            hessian: Matrix3::zeros(),
            quadratic_error: 0.0,
            spectrum: OnceCell::new(),
            norms: SmallVec::new(),
        };
        let mut quadratic_error = Interval::ZERO;
        for (n, e) in layout.exponents.iter().enumerate().skip(1) {
            let (g, error) = (taylor.coefficients[n], taylor.errors[n]);
            let mut quadratic = |i: usize, j: usize| {
                local.hessian[(i, j)] = if i == j { 2.0 * g } else { g };
                local.hessian[(j, i)] = local.hessian[(i, j)];
                // |wᵢwⱼ| ≤ |w|².
                quadratic_error = quadratic_error + Interval::from(error);
            };
            match *e {
                [1, 0, 0] => local.gradient[0] = taylor.at(n),
                [0, 1, 0] => local.gradient[1] = taylor.at(n),
                [0, 0, 1] => local.gradient[2] = taylor.at(n),
                [2, 0, 0] => quadratic(0, 0),
                [0, 2, 0] => quadratic(1, 1),
                [0, 0, 2] => quadratic(2, 2),
                [0, 1, 1] => quadratic(1, 2),
                [1, 0, 1] => quadratic(0, 2),
                [1, 1, 0] => quadratic(0, 1),
                _ => {
                    let order = e.iter().sum::<usize>();
                    if local.norms.len() < order - 2 {
                        local.norms.push(0.0);
                    }
                    let size = g.abs() + error;
                    local.norms[order - 3] += size * size * layout.weights[n];
                }
            }
        }
        local.quadratic_error = quadratic_error.high();
        if self.is_flat() {
            // This entry is between those of x and y, so the extremes are those of x and y.
            let [a, b] = [0, 1].map(|i| local.hessian[(i, i)]);
            local.hessian[(2, 2)] = f64::midpoint(a, b);
        }
        for norm in &mut local.norms {
            let square = Interval::around(*norm, layout.relative_of_norms * *norm);
            *norm = (square + Interval::from(f64::MIN_POSITIVE)).sqrt().high();
        }
        local
    }
}

impl Local {
    /// Whether f is proved to have no zero within this distance, by one bound of all terms but the value.
    pub(crate) fn excludes(&self, radius: f64) -> bool {
        let radius = Interval::from(radius);
        let bend = self.curvature(radius.high(), false).abs();
        let spread = (self.slope() + bend * radius) * radius;
        spread.high() < self.value.mignitude()
    }

    /// Whether f is proved to be strictly convex, or strictly concave, within this distance (if f does not depend on z: in the
    /// plane of x and y).
    pub(crate) fn is_convex(&self, radius: f64) -> bool {
        self.curvature(radius, true).sign().is_some()
    }

    /// The length of the gradient.
    pub(crate) fn slope(&self) -> Interval {
        square(self.gradient).sqrt()
    }

    /// Bounds of (f(m + w) − value − gradient·w)/|w|² for 0 < |w| ≤ radius. If `anywhere`, they also hold about every other
    /// center, as long as this center and all w stay within the radius; then a form of degree k counts with k(k−1)/2 times its
    /// norm.
    pub(crate) fn curvature(&self, radius: f64, anywhere: bool) -> Interval {
        let [low, high] = *self.spectrum.get_or_init(|| spectrum(&self.hessian));
        Interval::between(low, high) * 0.5 + Interval::up_to(self.tail(radius, anywhere))
    }

    /// A bound of the part of the curvature that comes from the forms of degree 3 and more, and from the errors of the
    /// quadratic form.
    #[expect(clippy::cast_precision_loss, reason = "degrees are small")]
    fn tail(&self, radius: f64, anywhere: bool) -> f64 {
        let radius = Interval::from(radius);
        let mut power = Interval::from(1.0);
        let mut tail = Interval::from(self.quadratic_error);
        for (n, norm) in self.norms.iter().enumerate() {
            power = power * radius;
            let times = if anywhere {
                ((n + 3) * (n + 2) / 2) as f64
            } else {
                1.0
            };
            tail = tail + power * *norm * times;
        }
        tail.high()
    }

    /// The numbers [across, along] of the following bound. Let n be the unit vector along `away`, and w = u + τn with u
    /// orthogonal to n and |w| ≤ radius. Then sign·(f(m + w) − value − gradient·w) ≥ across·|w|² − along·|τ
    /// w|, also about every center within the radius.
    ///
    /// Proof. With Q = sign·hessian/2 we have wᵀQw = uᵀQu + τ(Qn)·(w + u), |u| ≤ |w|, and `across` is not positive.
    pub(crate) fn one_sided(&self, sign: i8, away: [Interval; 3], radius: f64) -> [f64; 2] {
        let turned = self.hessian * f64::from(sign);
        let rows = [0, 1, 2].map(|i| [0, 1, 2].map(|j| Interval::from(turned[(i, j)])));
        let image = square(rows.map(|row| product(row, away))) / square(away);
        let least = Interval::from(least_across(&turned, away).min(0.0)) * 0.5;
        let tail = Interval::from(self.tail(radius, true));
        [(least - tail).low(), image.sqrt().high()]
    }

    /// The gradient in doubles, without a bound of its error.
    pub(crate) fn direction(&self) -> [f64; 3] {
        self.gradient.map(Interval::middle)
    }

    /// The second derivatives in doubles, without a bound of their errors.
    pub(crate) fn hessian(&self) -> Matrix3<f64> {
        self.hessian
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intervals::interval::{exactly, minus};
    use crate::intervals::tests::{cubic, nasty_cubics};
    use crate::intervals::{rational, rationals};
    use proptest::prelude::*;

    /// Points that are thirds of a power of two, so that the forms of degree 3 are large or small.
    fn offsets() -> impl Strategy<Value = ([f64; 3], [f64; 3])> {
        let v = || prop::array::uniform3(-3i32..4);
        (v(), v(), -50i32..2).prop_map(|(a, b, e)| {
            [a, b]
                .map(|v| v.map(|k| f64::from(k) * 2f64.powi(e)))
                .into()
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

        /// Lemma 9: the bound of the cubic form is at least Bombieri's norm, and hardly larger.
        #[test]
        fn norms_are_those_of_bombieri(f in nasty_cubics(), m in prop::array::uniform3(-2.0f64..2.0)) {
            let field = Field::new(&f);
            let cubes = field.polynomial().terms().filter(|(e, _)| e.iter().sum::<u32>() == 3);
            let factorial = |k: u32| Rational::from((1..=i64::from(k)).product::<i64>());
            let square: Rational = cubes.map(|(e, c)| {
                let weight = e.iter().fold(Rational::one() / Rational::from(6), |product, k| product * factorial(*k));
                c * c * weight
            }).sum();
            let found = field.local(m).norms.first().map_or_else(Rational::zero, |norm| rational(*norm));
            prop_assert!(&found * &found >= square);
            prop_assert!(found.to_f64() <= square.to_f64().sqrt() * (1.0 + 1e-13) + 1e-150);
        }

        /// The bounds are right about the center and about other centers, exactly, and so are the bounds to one side of a
        /// plane.
        #[test]
        fn curvature_bounds_the_second_order(f in prop_oneof![nasty_cubics(), prop::collection::vec(-9i64..10, 20).prop_map(|c| cubic(&c))], m in prop::array::uniform3(-2.0f64..2.0), (a, b) in offsets(), n in prop::array::uniform3(-3i32..4)) {
            let field = Field::new(&f);
            let local = field.local(m);
            // If f does not depend on z, all points are in the plane.
            let [a, b] = [a, b].map(|[x, y, z]| [x, y, if field.is_flat() { 0.0 } else { z }]);
            let n = if field.is_flat() { [n[0], n[1], 0] } else { n };
            let at = |v: [f64; 3]| -> [Rational; 3] { std::array::from_fn(|i| rational(m[i]) + rational(v[i])) };
            let length = |v: [f64; 3]| square(exactly(v)).sqrt().high();
            for (from, to, anywhere, is_centered) in [([0.0; 3], a, false, true), ([0.0; 3], b, true, true), (a, b, true, false), (b, a, true, false)] {
                let radius = length(from).max(length(to));
                let w: [Rational; 3] = std::array::from_fn(|i| rational(to[i]) - rational(from[i]));
                let squared: Rational = w.iter().map(|x| x * x).sum();
                prop_assume!(!squared.is_zero());
                let (start, gradient) = field.exact_value_and_gradient(&at(from));
                let linear: Rational = gradient.iter().zip(&w).map(|(g, x)| g * x).sum();
                let remainder = field.polynomial().evaluate(&at(to)) - start - linear;
                let found = local.curvature(radius, anywhere);
                prop_assert!(found.contains(&(&remainder / &squared)), "{found:?}");
                if n != [0; 3] && is_centered {
                    for sign in [1, -1] {
                        let away = n.map(f64::from);
                        let [across, along] = local.one_sided(sign, exactly(away), radius);
                        prop_assume!(across.is_finite() && along.is_finite());
                        let size = (Interval::from(&squared) * Interval::from(1.0)).sqrt();
                        let part = product(w.each_ref().map(Interval::from), exactly(away)) / square(exactly(away)).sqrt();
                        let least = Interval::from(across) * Interval::from(&squared) - Interval::from(along) * part.abs() * size;
                        prop_assert!(Interval::from(&(&remainder * &Rational::from(i32::from(sign)))).high() >= least.low());
                    }
                }
            }
        }

        /// The bounds hold if the quadratic coefficient is the difference of two larger numbers: x³ − 3cx² at c, up to δ.
        #[test]
        fn curvature_is_bounded_where_coefficients_cancel(m in 0.1f64..2.0, part in -40i64..41, k in 1i32..4) {
            let x = crate::poly::SparsePolynomial::<3>::variable(0);
            let near = rational(m) + Rational::from(part) / Rational::from(3) * Rational::from(2).pow(-56).unwrap();
            let squared = crate::poly::Ring::squared(&x);
            let f = crate::poly::Ring::minus(&crate::poly::Ring::times(&squared, &x), &squared.scaled(&(near * Rational::from(3))));
            let field = Field::new(&f);
            let step = rational(f64::from(k) * 2f64.powi(-70));
            let [zero, at] = [Rational::zero(), rational(m)];
            let (start, gradient) = field.exact_value_and_gradient(&[at.clone(), zero.clone(), zero.clone()]);
            let end = field.polynomial().evaluate(&[&at + &step, zero.clone(), zero]);
            let remainder = end - start - &gradient[0] * &step;
            let found = field.local([m, 0.0, 0.0]).curvature(f64::from(k) * 2f64.powi(-70), false);
            prop_assert!(found.contains(&(remainder / (&step * &step))), "{found:?}");
        }

        /// The intervals of value and gradient hold the exact numbers.
        #[test]
        fn values_and_gradients_are_enclosed(f in nasty_cubics(), m in prop::array::uniform3(-3.0f64..3.0)) {
            let field = Field::new(&f);
            let exact = rationals(m);
            let (value, gradient) = field.exact_value_and_gradient(&exact);
            for local in [field.local(m), field.exact_local(&exact)] {
                prop_assert!(local.value.contains(&value));
                prop_assert!((0..3).all(|i| local.gradient[i].contains(&gradient[i])));
            }
            prop_assert!(minus(field.local(m).gradient, field.exact_local(&exact).gradient).iter().all(|d| d.sign().is_none()));
        }

        /// In an excluded ball f has the sign of its center; for a linear form the ball ends at the zero.
        #[test]
        fn excluded_balls_have_one_sign(c in prop::collection::vec(-9i64..10, 20), m in prop::array::uniform3(-2.0f64..2.0), v in prop::array::uniform3(-0.5f64..0.5)) {
            let f = Field::new(&cubic(&c));
            if f.local(m).excludes(1.0) {
                prop_assert_eq!(f.sign(m), f.sign(std::array::from_fn(|i| m[i] + v[i])));
            }
            // The plane x − m₀ − r is at the distance r from m.
            let r = v[0].abs();
            let x = crate::poly::SparsePolynomial::<3>::variable(0);
            let f = Field::new(&crate::poly::Ring::minus(&x, &crate::poly::SparsePolynomial::constant(rational(m[0]) + rational(r))));
            prop_assert!(!f.local(m).excludes(r));
            prop_assert!(r < 1e-3 || f.local(m).excludes(r * (1.0 - 1e-9)));
        }
    }
}
