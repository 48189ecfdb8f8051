//! Taylor bounds over boxes.

use super::{Field, UNIT};

/// Steps towards the best bound of a distance.
const HALVINGS: usize = 12;

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

    /// No zero of g in the cube is nearer than this to a point, in units of the (equal) half sides.
    ///
    /// All zeros are in the slab |g(0) + ∇g·s| ≤ rest. With h ≤ 0 for the side of it that looks at the point p, every λ ≥ 0
    /// gives the bound min |s − p|² + λ h(s) over the cube, one coordinate at a time (weak duality); the best λ is bisected.
    pub(crate) fn nearest_zero(&self, p: [f64; 3]) -> f64 {
        let linear = self.slopes.map(|[m, _]| m);
        let plane = |s: [f64; 3]| -> f64 {
            self.value + linear.iter().zip(s).map(|(m, x)| m * x).sum::<f64>()
        };
        let sense = if plane(p) > 0.0 { 1.0 } else { -1.0 };
        let side = |s: [f64; 3]| sense * plane(s) - self.rest * (1.0 + 1e-9);
        let best = |weight: f64| -> [f64; 3] {
            std::array::from_fn(|i| (p[i] - sense * weight * linear[i] / 2.0).clamp(-1.0, 1.0))
        };
        let square: f64 = linear.iter().map(|m| m * m).sum();
        // Without the cube this is where the nearest point of the slab is.
        let mut high = 2.0 * side(p).max(0.0) / square;
        let mut low = 0.0;
        let mut found = 0.0f64;
        for step in 0..HALVINGS {
            let weight = if step == 0 {
                high
            } else {
                f64::midpoint(low, high)
            };
            let s = best(weight);
            let away: f64 = s.iter().zip(p).map(|(x, p)| (x - p) * (x - p)).sum();
            let beyond = weight * side(s);
            let bound = away + beyond
                - 1e-13
                    * (away
                        + weight
                            * (self.value.abs()
                                + self.rest
                                + linear.iter().map(|m| m.abs()).sum::<f64>()));
            found = found.max(bound);
            if side(s) <= 0.0 {
                high = weight;
            } else if step == 0 {
                low = weight;
                high = 4.0 * weight;
            } else {
                low = weight;
            }
        }
        found.sqrt() * (1.0 - 1e-14)
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

impl Field {
    /// Bounds of f and its derivatives on the box with a given middle and half sides: Σ |g_α| ρ^α over the Taylor coefficients.
    #[expect(clippy::cast_precision_loss, reason = "degrees are small")]
    pub(crate) fn on_box(&self, middle: [f64; 3], halves: [f64; 3]) -> BoxBounds {
        let taylor = self.taylor(middle);
        let powers = self.powers(halves.map(|half| half * (1.0 + 1e-9)));
        let mut bounds = BoxBounds {
            value: taylor.coefficients[0],
            error: taylor.errors[0],
            slopes: [[0.0; 2]; 3],
            rest: taylor.errors[0],
        };
        let all = self.layout.exponents.iter().zip(&taylor.coefficients);
        for ((e, g), error) in all.zip(&taylor.errors).skip(1) {
            let scale = powers[0][e[0]] * powers[1][e[1]] * powers[2][e[2]];
            let (g, error) = (g * scale, error * scale);
            let is_linear = e.iter().sum::<usize>() == 1;
            let size = if is_linear { error } else { g.abs() + error };
            bounds.rest += size;
            for (slope, k) in bounds.slopes.iter_mut().zip(e).filter(|(_, k)| **k > 0) {
                if is_linear {
                    slope[0] = g;
                }
                slope[1] += *k as f64 * size;
            }
        }
        bounds
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::field::tests::{cubic, sphere};
    use crate::poly::{Ring, SparsePolynomial};
    use proptest::prelude::*;

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
            let at = p.map(|k| Rational::from(k) / Rational::from(4));
            let through = |c: Vec<i64>| {
                let f = cubic(&c);
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
