//! A polynomial as a function of doubles: exact signs, Taylor bounds over boxes, certified crossings.

use crate::exact::{Dyadic, Rational};
use crate::poly::SparsePolynomial;

/// Half of the distance from 1 to the next double.
const UNIT: f64 = 1.11e-16;
/// Below this products may lose digits to underflow.
const TINY: f64 = 1e-280;
/// A crossing is enclosed to this part of the segment's length.
const CROSSING: f64 = 1.0 / 1_073_741_824.0;

/// f, with its coefficients also as doubles, scaled so that the largest is 1.
pub(super) struct Field {
    exact: SparsePolynomial<3>,
    terms: Vec<([usize; 3], f64)>,
    /// In each variable.
    degrees: [usize; 3],
    /// A relative error bound of a sum of terms in doubles.
    relative: f64,
}

/// The Taylor coefficients of f about the middle of a cube, each times the power of the cube's half side.
struct Taylor {
    coefficients: Vec<([usize; 3], f64)>,
    /// More than all rounding errors of the coefficients together.
    error: f64,
}

/// A point with a zero of f within `radius` of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub(super) point: [f64; 3],
    pub(super) radius: f64,
}

/// What is proved of f on a cube.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// It has no zero there.
    Empty,
    /// Any two of its gradients there make an acute angle: one sheet at most, without singular points.
    Regular,
    /// Neither is proved.
    Open,
}

#[expect(
    clippy::cast_precision_loss,
    reason = "degrees and numbers of terms are small"
)]
impl Field {
    pub(super) fn new(f: &SparsePolynomial<3>) -> Self {
        let largest = f.terms().map(|(_, c)| c.abs()).max();
        let scale = largest.and_then(|c| c.recip()).unwrap_or_default();
        let exact = f.scaled(&scale);
        let terms: Vec<([usize; 3], f64)> = exact
            .terms()
            .map(|(e, c)| (e.map(|k| k as usize), c.to_f64()))
            .collect();
        let degrees = terms.iter().fold([0; 3], |d: [usize; 3], (e, _)| {
            std::array::from_fn(|i| d[i].max(e[i]))
        });
        // One rounding per coefficient, the powers, two products, one sum per term.
        let roundings = terms.len() + degrees.iter().sum::<usize>() + 8;
        Self {
            relative: 1.01 * UNIT * roundings as f64,
            exact,
            terms,
            degrees,
        }
    }

    fn powers(&self, p: [f64; 3]) -> [Vec<f64>; 3] {
        std::array::from_fn(|i| {
            let mut list = Vec::with_capacity(self.degrees[i] + 1);
            let mut power = 1.0;
            for _ in 0..=self.degrees[i] {
                list.push(power);
                power *= p[i];
            }
            list
        })
    }

    /// (f, Σ |term|) in doubles.
    fn sums(&self, p: [f64; 3]) -> (f64, f64) {
        let [x, y, z] = self.powers(p);
        self.terms
            .iter()
            .fold((0.0, 0.0), |(sum, size), ([i, j, k], c)| {
                let term = c * x[*i] * y[*j] * z[*k];
                (sum + term, size + term.abs())
            })
    }

    fn tiny(&self, p: [f64; 3]) -> f64 {
        let sizes = p.iter().zip(self.degrees);
        sizes.fold(TINY, |size, (x, d)| size * x.abs().max(1.0).powf(d as f64))
    }

    /// The exact sign of f at a point: by doubles with an error bound where that decides, else exactly.
    pub(super) fn sign(&self, p: [f64; 3]) -> i8 {
        let (value, size) = self.sums(p);
        if value.abs() > size * self.relative + self.tiny(p) {
            return if value > 0.0 { 1 } else { -1 };
        }
        let exact = p.map(|x| Dyadic::from_f64(x).map_or_else(Rational::zero, |d| d.to_rational()));
        self.exact.evaluate(&exact).signum()
    }

    /// The gradient in doubles, with no bound of its error.
    pub(super) fn gradient(&self, p: [f64; 3]) -> [f64; 3] {
        let powers = self.powers(p);
        let mut gradient = [0.0; 3];
        for (e, c) in &self.terms {
            for axis in 0..3 {
                if e[axis] > 0 {
                    let factors = (0..3).map(|i| {
                        if i == axis {
                            e[i] as f64 * powers[i][e[i] - 1]
                        } else {
                            powers[i][e[i]]
                        }
                    });
                    gradient[axis] += c * factors.product::<f64>();
                }
            }
        }
        gradient
    }

    /// What is certain of f on the cube with the given middle and half side.
    ///
    /// f is not 0 where its constant Taylor coefficient outweighs all others, by Σ_{α ≠ 0} |g_α| ρ^|α|. The sheet is regular
    /// where the gradients, each component within bounds of the same kind, have positive products (the small normal
    /// variation of Plantinga & Vegter, SGP 2004).
    pub(super) fn verdict(&self, middle: [f64; 3], half: f64) -> Verdict {
        let taylor = self.taylor(middle, half * (1.0 + 1e-9));
        let mut rest = taylor.error;
        let mut value = 0.0;
        // [gradient, its largest change] for every component
        let mut slopes = [[0.0, taylor.error]; 3];
        for (e, g) in &taylor.coefficients {
            let order: usize = e.iter().sum();
            if order == 0 {
                value = *g;
                continue;
            }
            rest += g.abs();
            for axis in 0..3 {
                match (e[axis], order) {
                    (0, _) => {}
                    (_, 1) => slopes[axis][0] = *g,
                    (k, _) => slopes[axis][1] += k as f64 * (g.abs() + taylor.error),
                }
            }
        }
        if value.abs() > rest * (1.0 + 1e-9) {
            return Verdict::Empty;
        }
        let products = slopes.iter().map(|[m, r]| {
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

    fn taylor(&self, middle: [f64; 3], half: f64) -> Taylor {
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
        let mut coefficients = Vec::with_capacity(g.len());
        for i in 0..nx {
            for j in 0..ny {
                for k in 0..nz {
                    let value = g[at([i, j, k])];
                    if value != 0.0 {
                        coefficients.push(([i, j, k], value * half.powf((i + j + k) as f64)));
                    }
                }
            }
        }
        // Every coefficient is a sum of terms of |f| about |middle|, each rounded at most 2·degree times in every variable.
        let far = middle.map(|m| m.abs() + half);
        let (_, size) = self.sums(far);
        let roundings = 4 * (dx + dy + dz) + self.terms.len() + 16;
        Taylor {
            coefficients,
            error: 1.01 * UNIT * roundings as f64 * size + self.tiny(far),
        }
    }

    /// A certified zero on the segment from a, where f < 0, to b, where f ≥ 0.
    pub(super) fn crossing(&self, mut a: [f64; 3], mut b: [f64; 3]) -> Crossing {
        let length = distance(a, b);
        let goal = length * CROSSING;
        let (mut fa, mut fb) = (self.sums(a).0, self.sums(b).0);
        // Illinois' method on doubles says where to look; the signs that it goes on with are exact.
        let mut side = 0;
        while distance(a, b) > goal {
            let weight = fa / (fa - fb);
            let weight = if weight.is_finite() {
                weight.clamp(0.0, 1.0)
            } else {
                0.5
            };
            // Stepping over the zero on purpose shuts the bracket from the other side, too.
            let nudge = 0.4 * goal / distance(a, b);
            let weight = if side.cmp(&0).is_le() {
                weight + nudge
            } else {
                weight - nudge
            };
            let weight = if weight > 0.0 && weight < 1.0 {
                weight
            } else {
                0.5
            };
            let mut p = between(a, b, weight);
            let is_end = |p: [f64; 3]| distance(p, a) <= 0.0 || distance(p, b) <= 0.0;
            if is_end(p) {
                p = between(a, b, 0.5);
                if is_end(p) {
                    break;
                }
            }
            let value = self.sums(p).0;
            if self.sign(p) < 0 {
                if side < 0 {
                    fb /= 2.0;
                }
                side = -1;
                (a, fa) = (p, value.min(-f64::MIN_POSITIVE));
            } else {
                if side > 0 {
                    fa /= 2.0;
                }
                side = 1;
                (b, fb) = (p, value.max(f64::MIN_POSITIVE));
            }
        }
        let point = between(a, b, 0.5);
        Crossing {
            point,
            radius: distance(a, point).max(distance(b, point)),
        }
    }
}

pub(super) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

/// a + t (b − a)
pub(super) fn between(a: [f64; 3], b: [f64; 3], t: f64) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + t * (b[i] - a[i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::Ring;
    use proptest::prelude::*;

    /// x² + y² + z² − c
    fn sphere(c: i64) -> SparsePolynomial<3> {
        let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
        let squares = x.squared().plus(&y.squared()).plus(&z.squared());
        squares.minus(&SparsePolynomial::constant(c.into()))
    }

    #[test]
    fn signs_are_exact_where_doubles_vanish() {
        // (x − y)² − 2⁻¹⁰⁰ z² beside x = y
        let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
        let small = Rational::from(2).pow(-100).unwrap();
        let f = Field::new(&x.minus(&y).squared().minus(&z.squared().scaled(&small)));
        assert_eq!(f.sign([1.0, 1.0, 1.0]), -1);
        assert_eq!(f.sign([1.0, 1.0, 0.0]), 0);
        // (4·2⁻⁵²)² = 2⁻¹⁰⁰
        for (ulps, sign) in [(3.0, -1), (4.0, 0), (5.0, 1)] {
            assert_eq!(f.sign([1.0, 1.0 + ulps * f64::EPSILON, 1.0]), sign);
        }
    }

    #[test]
    fn verdicts_on_cubes() {
        let f = Field::new(&sphere(1));
        assert_eq!(f.verdict([0.0; 3], 0.5), Verdict::Empty);
        assert_eq!(f.verdict([0.0; 3], 0.6), Verdict::Open);
        assert_eq!(f.verdict([1.0, 0.0, 0.0], 0.2), Verdict::Regular);
        assert_eq!(f.verdict([1.3, 0.0, 0.0], 0.2), Verdict::Empty);
    }

    proptest! {
        /// A cube that is called empty has no zero: there f has one sign everywhere.
        #[test]
        fn empty_cubes_have_one_sign(c in prop::collection::vec(-9i64..10, 20), m in prop::array::uniform3(-3.0f64..3.0), half in 0.01f64..0.5, at in prop::array::uniform3(-1.0f64..1.0)) {
            let all = (0..4u32).flat_map(|i| (0..4 - i).flat_map(move |j| (0..4 - i - j).map(move |k| [i, j, k])));
            let f = Field::new(&SparsePolynomial::from_terms(all.zip(c.into_iter().map(Rational::from))));
            if f.verdict(m, half) == Verdict::Empty {
                let p = std::array::from_fn(|i| m[i] + half * at[i]);
                prop_assert_eq!(f.sign(p), f.sign(m));
            }
        }

        /// A crossing of the unit sphere lies within its radius of it.
        #[test]
        fn crossings_are_enclosed(b in prop::array::uniform3(1.0f64..2.0)) {
            let f = Field::new(&sphere(1));
            let found = f.crossing([0.1, 0.0, -0.2], b);
            let r = distance(found.point, [0.0; 3]);
            prop_assert!((r - 1.0).abs() <= found.radius + 1e-15);
            prop_assert!(found.radius < 1e-8);
        }
    }
}
