//! What one Taylor expansion says of f around a point: value, gradient, curvature, and how far the rest may go.

use std::cell::OnceCell;

use nalgebra::{Matrix3, Vector3};
use smallvec::SmallVec;

use super::{Field, Taylor, dot};
use crate::exact::Rational;

/// f(m + w) = value + gradient·w + wᵀ quadratic w + Σ f_k(w), with |f_k(w)| ≤ norm_k |w|^k. For an f without z all w are in the
/// plane of x and y.
///
/// The norms are Bombieri's, √(Σ c_α² α!/k!), which bound a form on the unit sphere.
#[derive(Clone, Debug)]
pub(crate) struct Local {
    pub(crate) value: f64,
    /// Bounds the error of `value`.
    pub(crate) error: f64,
    pub(crate) gradient: [f64; 3],
    /// Bounds the length of what the gradient is off.
    pub(crate) gradient_error: f64,
    quadratic: Matrix3<f64>,
    quadratic_error: f64,
    /// The eigenvalues of `quadratic` lie between these; computed when they are asked for.
    extremes: OnceCell<[f64; 2]>,
    /// For k = 3, 4, …, with the errors of the coefficients.
    norms: SmallVec<[f64; 12]>,
}

impl Field {
    /// The expansion in doubles.
    pub(crate) fn local(&self, middle: [f64; 3]) -> Local {
        self.local_of(&self.taylor(middle))
    }

    /// The expansion with exact coefficients, rounded at the end.
    ///
    /// Cost: for degree n about n times as many exact operations as there are monomials.
    pub(crate) fn exact_local(&self, middle: &[Rational; 3]) -> Local {
        self.local_of(&self.exact_taylor(middle))
    }

    fn local_of(&self, taylor: &Taylor) -> Local {
        let layout = &self.layout;
        let mut local = Local {
            value: taylor.coefficients[0],
            error: taylor.errors[0],
            gradient: [0.0; 3],
            gradient_error: 0.0,
            quadratic: Matrix3::zeros(),
            quadratic_error: 0.0,
            extremes: OnceCell::new(),
            norms: SmallVec::new(),
        };
        for (n, e) in layout.exponents.iter().enumerate().skip(1) {
            let (g, error) = (taylor.coefficients[n], taylor.errors[n]);
            match e.iter().sum::<usize>() {
                1 => {
                    let axis = e.iter().position(|k| *k == 1).unwrap_or(0);
                    local.gradient[axis] = g;
                    local.gradient_error += error;
                }
                2 => {
                    let first = e.iter().position(|k| *k > 0).unwrap_or(0);
                    let last = e.iter().rposition(|k| *k > 0).unwrap_or(0);
                    let share = if first == last { g } else { g / 2.0 };
                    local.quadratic[(first, last)] = share;
                    local.quadratic[(last, first)] = share;
                    local.quadratic_error += error;
                }
                order => {
                    if local.norms.len() < order - 2 {
                        local.norms.push(0.0);
                    }
                    let size = g.abs() + error;
                    local.norms[order - 3] += size * size * layout.weights[n];
                }
            }
        }
        if self.is_flat() {
            // The extremes are those of x and y alone.
            let [a, b] = [0, 1].map(|i| local.quadratic[(i, i)]);
            local.quadratic[(2, 2)] = f64::midpoint(a, b);
        }
        for norm in &mut local.norms {
            *norm = norm.sqrt() * (1.0 + 1e-9);
        }
        local
    }
}

impl Local {
    /// f has no zero within this distance, as far as one bound of everything but the value tells.
    pub(crate) fn excludes(&self, radius: f64) -> bool {
        let gradient = dot(self.gradient, self.gradient).sqrt() + self.gradient_error;
        let [low, high] = self.curvature(radius, false);
        let spread = gradient * radius + low.abs().max(high.abs()) * radius * radius;
        self.value.abs() - self.error > spread * (1.0 + 1e-9)
    }

    /// f is strictly convex, or strictly concave, within this distance (for one without z: in the plane of x and y).
    pub(crate) fn is_convex(&self, radius: f64) -> bool {
        let [low, high] = self.curvature(radius, true);
        low > 0.0 || high < 0.0
    }

    /// Bounds of (f(m + w) − value − gradient·w)/|w|² for 0 < |w| ≤ radius; `anywhere` bounds the same about every other
    /// centre, too, as long as it and all w stay within the radius: then a form of degree k has k(k−1)/2 times its norm.
    pub(crate) fn curvature(&self, radius: f64, anywhere: bool) -> [f64; 2] {
        let tail = self.tail(radius, anywhere);
        let [low, high] = self.extremes();
        let slack = 1e-9 * (low.abs() + high.abs() + tail);
        [low - tail - slack, high + tail + slack]
    }

    /// What the forms of degree 3 and more, and the errors of the quadratic one, add to the curvature.
    #[expect(clippy::cast_precision_loss, reason = "degrees are small")]
    fn tail(&self, radius: f64, anywhere: bool) -> f64 {
        let mut power = 1.0;
        let mut tail = self.quadratic_error;
        for (n, norm) in self.norms.iter().enumerate() {
            power *= radius;
            let times = if anywhere {
                ((n + 3) * (n + 2) / 2) as f64
            } else {
                1.0
            };
            tail += times * norm * power;
        }
        tail
    }

    /// For w = u + τn, with u across the unit vector n, |w| ≤ radius, and about every centre within the last place of this one:
    /// sign·(f(m + w) − value − gradient·w) ≥ across·|w|² − along·|τ||w|. The two numbers.
    pub(crate) fn one_sided(&self, sign: f64, normal: [f64; 3], radius: f64) -> [f64; 2] {
        let n = Vector3::from(normal);
        let image = self.quadratic * n;
        let projection = Matrix3::identity() - n * n.transpose();
        // Across n; along n it is 0, which is no less than what is looked for.
        let tangential = projection * self.quadratic * projection * sign;
        let least = tangential.symmetric_eigenvalues().min().min(0.0);
        let tail = self.tail(radius, true);
        let slack = 1e-9 * (self.quadratic.norm() + tail);
        [
            least - tail - slack,
            2.0 * image.norm() + self.quadratic_error + slack,
        ]
    }

    /// The second derivatives in doubles.
    pub(crate) fn hessian(&self) -> Matrix3<f64> {
        self.quadratic * 2.0
    }

    /// The error of the eigenvalues is a few units of the largest, far less than the slack that `curvature` adds.
    fn extremes(&self) -> [f64; 2] {
        *self.extremes.get_or_init(|| {
            let found = self.quadratic.symmetric_eigenvalues();
            [found.min(), found.max()]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::distance;
    use crate::field::tests::cubic;
    use proptest::prelude::*;

    proptest! {
        /// The bounds hold at random places, about the centre and about other centres.
        #[test]
        fn curvature_bounds_the_second_order(c in prop::collection::vec(-9i64..10, 20), m in prop::array::uniform3(-2.0f64..2.0), a in prop::array::uniform3(-0.5f64..0.5), b in prop::array::uniform3(-0.5f64..0.5)) {
            let f = Field::new(&cubic(&c));
            let local = f.local(m);
            let at = |v: [f64; 3]| std::array::from_fn(|i| m[i] + v[i]);
            let remainder = |from: [f64; 3], to: [f64; 3]| {
                let [p, q] = [at(from), at(to)];
                let w: [f64; 3] = std::array::from_fn(|i| q[i] - p[i]);
                (f.value(q) - f.value(p) - dot(f.gradient(p), w)) / dot(w, w)
            };
            prop_assume!(distance(a, b) > 1e-2 && distance(a, [0.0; 3]) > 1e-2);
            for (from, to, anywhere) in [([0.0; 3], a, false), (a, b, true)] {
                let [low, high] = local.curvature(1.0, anywhere);
                let exact = remainder(from, to);
                prop_assert!(low - 1e-9 <= exact && exact <= high + 1e-9, "{low} {exact} {high}");
            }
            let exact = f.exact_local(&m.map(|x| Rational::try_from(x).unwrap()));
            prop_assert!((exact.value - local.value).abs() <= local.error + exact.error);
            prop_assert!(distance(exact.gradient, local.gradient) <= local.gradient_error + exact.gradient_error);
        }

        /// Where a ball is excluded, f has the sign of its centre.
        #[test]
        fn excluded_balls_have_one_sign(c in prop::collection::vec(-9i64..10, 20), m in prop::array::uniform3(-2.0f64..2.0), v in prop::array::uniform3(-0.5f64..0.5)) {
            let f = Field::new(&cubic(&c));
            if f.local(m).excludes(1.0) {
                prop_assert_eq!(f.sign(m), f.sign(std::array::from_fn(|i| m[i] + v[i])));
            }
        }
    }
}
