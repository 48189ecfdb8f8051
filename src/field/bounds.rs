//! Taylor bounds over boxes.

use super::{Field, UNIT};

/// f on a box, as the polynomial g(s) = f(m + ρ∘s) over the cube [−1, 1]³.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoxBounds {
    /// g(0), in doubles.
    pub(crate) value: f64,
    /// Bounds the error of `value`.
    pub(crate) error: f64,
    /// For every variable the derivative of g: its double at 0, and how far from that it gets on the cube.
    pub(crate) slopes: [[f64; 2]; 3],
    /// Bounds what g(s) has beside `value` and the linear terms, and all rounding errors of its coefficients.
    rest: f64,
}

/// The Taylor coefficients of f about the middle of a box, each times the powers of the half sides.
struct Taylor {
    coefficients: Vec<([usize; 3], f64)>,
    /// More than all rounding errors of the coefficients together.
    error: f64,
}

/// What is proved of f on a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// It has no zero there.
    Empty,
    /// Any two of its gradients there make an acute angle: one sheet at most, without singular points.
    Regular,
    /// Neither is proved.
    Open,
}

impl BoxBounds {
    /// f has no zero on the box: its constant Taylor coefficient outweighs all others.
    pub(crate) fn is_empty(&self) -> bool {
        let linear: f64 = self.slopes.iter().map(|[m, _]| m.abs()).sum();
        self.value.abs() > (linear + self.rest) * (1.0 + 1e-9)
    }

    /// The two functions have no common zero on the box: one of them has none, or a combination g − λ f without the
    /// part of ∇g along ∇f, which tells apart surfaces that cross at a small angle.
    pub(crate) fn exclude(&self, other: &Self) -> bool {
        self.is_empty() || other.is_empty() || self.combined(other) || other.combined(self)
    }

    fn combined(&self, other: &Self) -> bool {
        let dot = |a: &Self, b: &Self| -> f64 {
            let pairs = a.slopes.iter().zip(&b.slopes);
            pairs.map(|([m, _], [n, _])| m * n).sum()
        };
        let factor = dot(self, other) / dot(self, self);
        let value = other.value - factor * self.value;
        let mut spread = other.rest + factor.abs() * self.rest;
        let mut size = other.value.abs() + (factor * self.value).abs();
        for ([m, _], [n, _]) in self.slopes.iter().zip(&other.slopes) {
            spread += (n - factor * m).abs();
            size += n.abs() + (factor * m).abs();
        }
        value.abs() > (spread + 16.0 * UNIT * size) * (1.0 + 1e-9)
    }

    /// What is certain of f on the box: the sheet is regular where the gradients, each component within its bounds, have
    /// positive products (the small normal variation of Plantinga & Vegter, SGP 2004).
    pub(crate) fn verdict(&self) -> Verdict {
        if self.is_empty() {
            return Verdict::Empty;
        }
        let products = self.slopes.iter().map(|[m, r]| {
            let (m, r) = (m.abs(), r * (1.0 + 1e-9));
            if m >= r {
                (m - r) * (m - r)
            } else {
                (m - r) * (m + r)
            }
        });
        if products.sum::<f64>() > 0.0 {
            Verdict::Regular
        } else {
            Verdict::Open
        }
    }
}

#[expect(
    clippy::cast_precision_loss,
    reason = "degrees and numbers of terms are small"
)]
impl Field {
    /// Bounds of f and its derivatives on the box with a given middle and half sides: Σ |g_α| ρ^α over the Taylor coefficients.
    pub(crate) fn on_box(&self, middle: [f64; 3], halves: [f64; 3]) -> BoxBounds {
        let taylor = self.taylor(middle, halves.map(|half| half * (1.0 + 1e-9)));
        let mut bounds = BoxBounds {
            value: 0.0,
            error: taylor.error,
            slopes: [[0.0, taylor.error]; 3],
            rest: taylor.error,
        };
        for (e, g) in &taylor.coefficients {
            let order: usize = e.iter().sum();
            if order == 0 {
                bounds.value = *g;
                continue;
            }
            if order > 1 {
                bounds.rest += g.abs();
            }
            for (slope, exponent) in bounds.slopes.iter_mut().zip(e) {
                match (*exponent, order) {
                    (0, _) => {}
                    (_, 1) => slope[0] = *g,
                    (k, _) => slope[1] += k as f64 * (g.abs() + taylor.error),
                }
            }
        }
        bounds
    }

    fn taylor(&self, middle: [f64; 3], halves: [f64; 3]) -> Taylor {
        let [dx, dy, dz] = self.degrees;
        let [nx, ny, nz] = [dx + 1, dy + 1, dz + 1];
        let at = |[i, j, k]: [usize; 3]| (i * ny + j) * nz + k;
        let mut g = vec![0.0; nx * ny * nz];
        for (e, c) in &self.terms {
            g[at(*e)] = *c;
        }
        // x → middle + x, variable by variable, each by repeated synthetic division.
        let strides = [ny * nz, nz, 1];
        let counts = [nx, ny, nz];
        for axis in 0..3 {
            let (stride, count) = (strides[axis], counts[axis]);
            for start in (0..g.len()).filter(|s| (s / stride).is_multiple_of(count)) {
                for first in 0..count - 1 {
                    for i in (first..count - 1).rev() {
                        g[start + i * stride] += middle[axis] * g[start + (i + 1) * stride];
                    }
                }
            }
        }
        let powers = self.powers(halves);
        let mut coefficients = Vec::with_capacity(g.len());
        for i in 0..nx {
            for j in 0..ny {
                for k in 0..nz {
                    let value = g[at([i, j, k])];
                    if value != 0.0 {
                        coefficients.push((
                            [i, j, k],
                            value * powers[0][i] * powers[1][j] * powers[2][k],
                        ));
                    }
                }
            }
        }
        // Every coefficient is a sum of terms of |f| about |middle|, each rounded at most 2·degree times in every variable.
        let far = std::array::from_fn(|i| middle[i].abs() + halves[i]);
        let (_, size) = self.sums(far);
        let roundings = 4 * (dx + dy + dz) + self.terms.len() + 16;
        Taylor {
            coefficients,
            error: 1.01 * UNIT * roundings as f64 * size + self.tiny(far),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::poly::{Ring, SparsePolynomial};
    use proptest::prelude::*;

    /// x² + y² + z² − c
    fn sphere(c: i64) -> SparsePolynomial<3> {
        let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
        let squares = x.squared().plus(&y.squared()).plus(&z.squared());
        squares.minus(&SparsePolynomial::constant(c.into()))
    }

    #[test]
    fn verdicts_on_cubes() {
        let f = Field::new(&sphere(1));
        let on = |middle, half: f64| f.on_box(middle, [half; 3]).verdict();
        assert_eq!(on([0.0; 3], 0.5), Verdict::Empty);
        assert_eq!(on([0.0; 3], 0.6), Verdict::Open);
        assert_eq!(on([1.0, 0.0, 0.0], 0.2), Verdict::Regular);
        assert_eq!(on([1.3, 0.0, 0.0], 0.2), Verdict::Empty);
    }

    proptest! {
        /// A box that is called empty of common zeros of a small-angled pair has none: at no point do both vanish, since
        /// both are built with a common zero at a known point.
        #[test]
        fn boxes_with_a_common_zero_are_not_excluded(c in prop::collection::vec(-9i64..10, 20), d in prop::collection::vec(-9i64..10, 20), small in 1u32..30, p in prop::array::uniform3(-8i64..9), off in prop::array::uniform3(-1.0f64..1.0), half in 0.001f64..0.5) {
            let all = || (0..4u32).flat_map(|i| (0..4 - i).flat_map(move |j| (0..4 - i - j).map(move |k| [i, j, k])));
            let at = p.map(|k| Rational::from(k) / Rational::from(4));
            let through = |c: Vec<i64>| {
                let f = SparsePolynomial::from_terms(all().zip(c.into_iter().map(Rational::from)));
                f.minus(&SparsePolynomial::constant(f.evaluate(&at)))
            };
            // g = f + 2^−k h: nearly tangent to f.
            let f = through(c);
            let g = f.plus(&through(d).scaled(&Rational::from(2).pow(-i64::from(small)).unwrap()));
            let middle = std::array::from_fn(|i| at[i].to_f64() + 0.999 * half * off[i]);
            let [f, g] = [f, g].map(|f| Field::new(&f).on_box(middle, [half; 3]));
            prop_assert!(!f.exclude(&g));
        }

        /// A cube that is called empty has no zero: there f has one sign everywhere.
        #[test]
        fn empty_cubes_have_one_sign(c in prop::collection::vec(-9i64..10, 20), m in prop::array::uniform3(-3.0f64..3.0), half in 0.01f64..0.5, at in prop::array::uniform3(-1.0f64..1.0)) {
            let all = (0..4u32).flat_map(|i| (0..4 - i).flat_map(move |j| (0..4 - i - j).map(move |k| [i, j, k])));
            let f = Field::new(&SparsePolynomial::from_terms(all.zip(c.into_iter().map(Rational::from))));
            if f.on_box(m, [half; 3]).verdict() == Verdict::Empty {
                let p = std::array::from_fn(|i| m[i] + half * at[i]);
                prop_assert_eq!(f.sign(p), f.sign(m));
            }
        }
    }
}
