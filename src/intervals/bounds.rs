//! Taylor bounds over boxes.

use super::interval::{Interval, UNIT, exactly};
use super::{FLOOR, Field, dot, largest_powers};

/// The number of halvings in the search for the best bound of a distance.
const HALVINGS: usize = 12;

/// The polynomial f on a box, as the polynomial g(s) = f(m + ρ∘s) over the cube [−1, 1]³.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoxBounds {
    /// The value g(0) in doubles, and a bound of its error.
    value: f64,
    error: f64,
    /// The derivatives of g at 0, in doubles.
    linear: [f64; 3],
    /// Bounds of the differences between these and the derivatives anywhere on the cube.
    spread: [f64; 3],
    /// A bound of |g(s) − value − linear·s| on the cube.
    rest: f64,
}

/// The proved property of f on a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BoxProof {
    /// f has no zero in the box.
    Empty,
    /// Any two gradients of f in the box make an acute angle, so there is at most one sheet, without singular points.
    Regular,
    /// Neither is proved.
    Open,
}

impl BoxBounds {
    /// The value of f in the middle of the box.
    pub(crate) fn value(&self) -> Interval {
        Interval::around(self.value, self.error)
    }

    /// The derivative of g with respect to one variable, anywhere on the cube.
    pub(crate) fn slope(&self, axis: usize) -> Interval {
        Interval::around(self.linear[axis], self.spread[axis])
    }

    /// Whether it is proved that f has no zero in the box, because its constant Taylor coefficient is larger than all others
    /// together.
    pub(crate) fn is_empty(&self) -> bool {
        let [a, b, c] = exactly(self.linear).map(Interval::abs);
        (a + b + c + Interval::from(self.rest)).high() < self.value.abs()
    }

    /// Whether it is proved that the two functions have no common zero in the box. Either one of them has no zero there, or a
    /// combination g − λ f has none. λ is chosen so that ∇g − λ∇f has no part along ∇f, which separates surfaces that cross at
    /// a small angle.
    pub(crate) fn exclude(&self, other: &Self) -> bool {
        self.is_empty() || other.is_empty() || self.combined(other) || other.combined(self)
    }

    /// Whether the constant coefficient of a combination is larger than all others together. The result is right for any factor
    /// λ.
    fn combined(&self, other: &Self) -> bool {
        let dot = |a: &Self, b: &Self| -> f64 {
            let pairs = a.linear.iter().zip(&b.linear);
            pairs.map(|(m, n)| m * n).sum()
        };
        let factor = Interval::from(dot(self, other) / dot(self, self));
        let combination = |of_self: f64, of_other: f64| Interval::from(of_other) - factor * of_self;
        let value = combination(self.value, other.value);
        let mut spread = Interval::from(other.rest) + factor.abs() * self.rest;
        for (m, n) in self.linear.iter().zip(&other.linear) {
            spread = spread + combination(*m, *n).abs();
        }
        spread.high() < value.mignitude()
    }

    /// The function a·f + b·g on the box.
    ///
    /// The new value and linear coefficients are doubles near the exact ones; what they differ by is added to the bounds.
    ///
    /// Law: `combinations_hold_the_exact_values`.
    pub(crate) fn combination(&self, a: f64, other: &Self, b: f64) -> Self {
        let blend = |x: f64, y: f64| Interval::from(x) * a + Interval::from(y) * b;
        let sizes = |x: f64, y: f64| Interval::from(x) * a.abs() + Interval::from(y) * b.abs();
        let near = |exact: Interval| {
            let near = exact.middle();
            (near, (exact - Interval::from(near)).abs())
        };
        let (value, off) = near(blend(self.value, other.value));
        let mut combined = Self {
            value,
            error: (sizes(self.error, other.error) + off).high(),
            linear: [0.0; 3],
            spread: [0.0; 3],
            rest: 0.0,
        };
        let mut rest = sizes(self.rest, other.rest) + off;
        for i in 0..3 {
            let (linear, off) = near(blend(self.linear[i], other.linear[i]));
            combined.linear[i] = linear;
            combined.spread[i] = (sizes(self.spread[i], other.spread[i]) + off).high();
            rest = rest + off;
        }
        combined.rest = rest.high();
        combined
    }

    /// The weights a and b for which the zeros of a·f + b·g, linearized, touch the sphere about a point at the nearest common zero of f
    /// and g, linearized; in units of the half sides.
    pub(crate) fn weights_of_common_zero(&self, other: &Self, p: [f64; 3]) -> Option<[f64; 2]> {
        let values = [self, other].map(|f| f.value + dot(f.linear, p));
        weights_of_common_zero(values, [self.linear, other.linear])
    }

    /// A lower bound of the distances of the zeros of g in the cube from a point, in units of the half sides, which must be
    /// equal. The result is 0 if the bound does not seem to be larger than `known`.
    ///
    /// A search in doubles chooses the weight; only the bound that the weight gives is trusted.
    pub(crate) fn nearest_zero(&self, p: [Interval; 3], known: f64) -> f64 {
        let near = p.map(Interval::middle);
        let plane = |s: [f64; 3]| -> f64 {
            self.value + self.linear.iter().zip(s).map(|(m, x)| m * x).sum::<f64>()
        };
        let sense = if plane(near) > 0.0 { 1.0 } else { -1.0 };
        let side = |s: [f64; 3]| sense * plane(s) - self.rest;
        let best = |weight: f64| -> [f64; 3] {
            std::array::from_fn(|i| {
                (near[i] - sense * weight * self.linear[i] / 2.0).clamp(-1.0, 1.0)
            })
        };
        let square: f64 = self.linear.iter().map(|m| m * m).sum();
        // Without the cube this weight gives the nearest point of the slab.
        let mut high = 2.0 * side(near).max(0.0) / square;
        let mut low = 0.0;
        let (mut found, mut found_at) = (0.0f64, None);
        for step in 0..HALVINGS {
            let weight = if step == 0 {
                high
            } else {
                f64::midpoint(low, high)
            };
            let s = best(weight);
            let away: f64 = s.iter().zip(near).map(|(x, p)| (x - p) * (x - p)).sum();
            let bound = away + weight * side(s);
            if bound > found {
                (found, found_at) = (bound, Some((weight, s)));
            }
            if side(s) <= 0.0 {
                high = weight;
            } else if step == 0 {
                low = weight;
                high = 4.0 * weight;
            } else {
                low = weight;
            }
        }
        let better = found_at.filter(|_| found > known * known);
        better.map_or(0.0, |(weight, s)| self.distance_bound(p, sense, weight, s))
    }

    /// Lemma 10. Let λ ≥ 0, σ = ±1 and s a point of the cube. No zero x of g in the cube has |x − p|² less than λ(σ·value −
    /// rest) + Σ ((sᵢ − pᵢ)² + λσ·linearᵢ·sᵢ − lossᵢ). Here lossᵢ is 0 if sᵢ is an end of [−1, 1] towards which q(x) = (x −
    /// pᵢ)² + λσ·linearᵢ·x does not increase, else q′(sᵢ)²/4.
    ///
    /// Proof. At a zero σ(value + linear·x) ≤ rest, so |x − p|² ≥ |x − p|² + λ(σ(value + linear·x) − rest) (weak duality), which
    /// is a sum over the coordinates; and q(x) = q(sᵢ) + q′(sᵢ)(x − sᵢ) + (x − sᵢ)² ≥ q(sᵢ) − lossᵢ.
    ///
    /// Law: `no_zero_is_nearer_than_its_bound`.
    fn distance_bound(&self, p: [Interval; 3], sense: f64, weight: f64, s: [f64; 3]) -> f64 {
        let weight = Interval::from(weight);
        let outside = Interval::from(sense * self.value) - Interval::from(self.rest);
        let mut bound = weight * outside;
        for i in 0..3 {
            let (pull, x) = (weight * (sense * self.linear[i]), Interval::from(s[i]));
            let off = x - p[i];
            let growth = off * 2.0 + pull;
            let is_at_end =
                (s[i] >= 1.0 && growth.high() <= 0.0) || (s[i] <= -1.0 && growth.low() >= 0.0);
            let loss = if is_at_end {
                Interval::ZERO
            } else {
                growth.squared() * 0.25
            };
            bound = bound + (off.squared() + pull * x - loss);
        }
        bound.or_zero().sqrt().low()
    }

    /// The proved property of f on the box. The sheet is regular if the gradients, with each component anywhere within its
    /// bounds, have positive scalar products (the small normal variation of Plantinga & Vegter, SGP 2004).
    pub(crate) fn verdict(&self) -> BoxProof {
        if self.is_empty() {
            return BoxProof::Empty;
        }
        let [x, y, z] = [0, 1, 2].map(|axis| self.slope(axis));
        if (x * x + y * y + z * z).is_positive() {
            BoxProof::Regular
        } else {
            BoxProof::Open
        }
    }
}

/// The weights a and b for which a step of −a∇f − b∇g leads to the nearest common zero of f and g, linearized, from a point at which they
/// have these values and gradients.
pub(crate) fn weights_of_common_zero(
    [first, second]: [f64; 2],
    [f, g]: [[f64; 3]; 2],
) -> Option<[f64; 2]> {
    let [aa, ab, bb] = [dot(f, f), dot(f, g), dot(g, g)];
    let determinant = aa * bb - ab * ab;
    let weights = [
        (bb * first - ab * second) / determinant,
        (aa * second - ab * first) / determinant,
    ];
    weights.iter().all(|w| w.is_finite()).then_some(weights)
}

impl Field {
    /// Bounds of f and its derivatives on the box with the given middle and half sides, by the sums Σ |g_α| ρ^α over the Taylor
    /// coefficients.
    ///
    /// Lemma 11. Let N be the number of monomials, D the sum of the degrees, and P the product of the largest powers of the
    /// half sides that are > 1. A computed sum S is too small by at most `relative_error(N + D + 6)` times (S + `FLOOR`·P·(1 +
    /// Σ|g_α|)).
    ///
    /// Proof. ρ^α is rounded at most D times; |g| + error, its product with ρ^α and the product with an exponent are rounded
    /// once each; and the sum is rounded once for every monomial (Lemma 2). Two more roundings are those of the last sum and
    /// product here. A loss by underflow is multiplied by at most P and one of the |g| + error (Lemma 3), which counts as one
    /// more. The linear coefficients are rounded once more, by a `UNIT` part that is added to their errors.
    ///
    /// Law: `boxes_hold_the_exact_values`.
    #[expect(clippy::cast_precision_loss, reason = "degrees are small")]
    pub(crate) fn on_box(&self, middle: [f64; 3], halves: [f64; 3]) -> BoxBounds {
        let taylor = self.taylor(middle);
        let powers = self.powers(halves);
        let mut bounds = BoxBounds {
            value: taylor.coefficients[0],
            error: taylor.errors[0],
            linear: [0.0; 3],
            spread: [0.0; 3],
            rest: taylor.errors[0],
        };
        let mut sizes = 1.0 + taylor.errors[0];
        let all = self.layout.exponents.iter().zip(&taylor.coefficients);
        for ((e, g), error) in all.zip(&taylor.errors).skip(1) {
            let scale = powers[0][e[0]] * powers[1][e[1]] * powers[2][e[2]];
            sizes += g.abs() + error;
            if e.iter().sum::<usize>() == 1 {
                let error = (error + UNIT * g.abs()) * scale;
                for axis in (0..3).filter(|axis| e[*axis] == 1) {
                    bounds.linear[axis] = g * scale;
                    bounds.spread[axis] += error;
                }
                bounds.rest += error;
                continue;
            }
            let size = (g.abs() + error) * scale;
            bounds.rest += size;
            for (spread, k) in bounds.spread.iter_mut().zip(e) {
                *spread += *k as f64 * size;
            }
        }
        let floor = FLOOR * largest_powers(&powers) * sizes;
        let upper = |sum: f64| Interval::around(sum, self.relative_of_boxes * (sum + floor)).high();
        bounds.spread = bounds.spread.map(upper);
        bounds.rest = upper(bounds.rest);
        bounds
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::intervals::tests::{cubic, nasty_cubics, nasty_points, sphere};
    use crate::intervals::{rational, rationals};
    use crate::poly::{Ring, SparsePolynomial};
    use proptest::prelude::*;

    /// The squared distance from p to the zeros that a box may have, that is to the points of the cube with |value + linear·x|
    /// ≤ rest. It is exact: the nearest point is the projection of p to a face of the cube, or to the intersection of a face
    /// and the side of the slab.
    fn exact_nearest(bounds: &BoxBounds, p: &[Rational; 3]) -> Option<Rational> {
        let linear = rationals(bounds.linear);
        let [value, rest] = [bounds.value, bounds.rest].map(rational);
        let plane =
            |x: &[Rational; 3]| (0..3).fold(value.clone(), |sum, i| sum + &linear[i] * &x[i]);
        let one = Rational::one();
        let mut best: Option<Rational> = None;
        for face in 0..27 {
            let ends = [face % 3, face / 3 % 3, face / 9];
            let start: [Rational; 3] = std::array::from_fn(|i| match ends[i] {
                0 => p[i].clone(),
                1 => one.clone(),
                _ => -&one,
            });
            let free = |i: usize| ends[i] == 0;
            let square: Rational = (0..3)
                .filter(|i| free(*i))
                .map(|i| &linear[i] * &linear[i])
                .sum();
            let sides = [&rest, &-&rest].map(|side| {
                let factor = square
                    .recip()
                    .map(|inverse| (plane(&start) - side) * inverse)?;
                Some(std::array::from_fn(|i| {
                    if free(i) {
                        &start[i] - &(&factor * &linear[i])
                    } else {
                        start[i].clone()
                    }
                }))
            });
            for x in sides.into_iter().flatten().chain([start.clone()]) {
                let x: [Rational; 3] = x;
                if x.iter().all(|x| x.abs() <= one) && plane(&x).abs() <= rest {
                    let away: Rational = (0..3).map(|i| (&x[i] - &p[i]) * (&x[i] - &p[i])).sum();
                    best = Some(best.map_or(away.clone(), |best: Rational| best.min(away)));
                }
            }
        }
        best
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

        /// The combination of two polynomials is within its bounds at the corners of the box and inside.
        #[test]
        fn combinations_hold_the_exact_values(f in nasty_cubics(), g in nasty_cubics(), m in prop::array::uniform3(-4.0f64..4.0), half in 1e-6f64..2.0, weights in prop::array::uniform2(-9.0f64..9.0), part in 0.0f64..1.0) {
            let [own, other] = [&f, &g].map(Field::new);
            let [bounds, others] = [&own, &other].map(|field| field.on_box(m, [half; 3]));
            let combined = bounds.combination(weights[0], &others, weights[1]);
            let [a, b] = weights.map(rational);
            let sum = own.polynomial().scaled(&a).plus(&other.polynomial().scaled(&b));
            prop_assert!(combined.value().contains(&sum.evaluate(&rationals(m))));
            for corner in 0..8u32 {
                let s = [0, 1, 2].map(|i: usize| if corner >> i & 1 == 1 { part } else { -1.0 });
                let at: [Rational; 3] = std::array::from_fn(|i| rational(m[i]) + rational(half) * rational(s[i]));
                let plane = (0..3).fold(rational(combined.value), |sum, i| sum + rational(combined.linear[i]) * rational(s[i]));
                prop_assert!((sum.evaluate(&at) - plane).abs() <= rational(combined.rest));
                for axis in 0..3 {
                    let slope = sum.derivative(axis).evaluate(&at) * rational(half);
                    prop_assert!(combined.slope(axis).contains(&slope));
                }
            }
        }

        /// Lemma 11 at the corners of the box, where the bounds are reached if all signs agree.
        #[test]
        fn boxes_hold_the_exact_values(f in nasty_cubics(), m in nasty_points(), halves in nasty_points(), is_positive in any::<bool>()) {
            let f = if is_positive {
                SparsePolynomial::from_terms(f.terms().map(|(e, c)| (*e, c.abs())))
            } else {
                f
            };
            let (m, halves) = (if is_positive { m.map(f64::abs) } else { m }, halves.map(f64::abs));
            let field = Field::new(&f);
            let bounds = field.on_box(m, halves);
            prop_assert!(bounds.value().contains(&field.exact_value(m)));
            for corner in 0..8u32 {
                let ends = [0, 1, 2].map(|i: usize| rational(if corner >> i & 1 == 1 { 1.0 } else { -1.0 }));
                let at = std::array::from_fn(|i| rational(m[i]) + rational(halves[i]) * &ends[i]);
                let (value, gradient) = field.exact_value_and_gradient(&at);
                for i in 0..3 {
                    prop_assert!(bounds.slope(i).contains(&(&gradient[i] * &rational(halves[i]))));
                }
                if bounds.value.is_finite() && bounds.linear.iter().all(|m| m.is_finite()) && bounds.rest.is_finite() {
                    let linear = (0..3).fold(rational(bounds.value), |sum, i| sum + rational(bounds.linear[i]) * &ends[i]);
                    prop_assert!((value - linear).abs() <= rational(bounds.rest));
                }
            }
        }

        /// Lemma 10: the bound of the distance is at most the exact distance, and nearly equal to it if the weight is found.
        #[test]
        fn no_zero_is_nearer_than_its_bound(value in -3.0f64..3.0, linear in prop::array::uniform3(-2.0f64..2.0), kind in 0u8..3, rest in 0.0f64..0.5, p in prop::array::uniform3(-4.0f64..4.0)) {
            let linear = match kind {
                0 => linear,
                1 => [linear[0], 0.0, 0.0],
                _ => [linear[0], linear[1], 0.0],
            };
            let bounds = BoxBounds { value, error: 0.0, linear, spread: [0.0; 3], rest };
            let found = bounds.nearest_zero(p.map(Interval::from), 0.0);
            if let Some(exact) = exact_nearest(&bounds, &rationals(p)) {
                let square = rational(found) * rational(found);
                prop_assert!(square <= exact, "{found} {}", exact.to_f64().sqrt());
                if kind == 1 {
                    prop_assert!(found >= 0.9 * exact.to_f64().sqrt());
                }
            }
        }

        /// Lemma 10 for any weight and any point of the cube.
        #[test]
        fn every_weight_gives_a_bound(value in -3.0f64..3.0, linear in prop::array::uniform3(-2.0f64..2.0), rest in 0.0f64..0.5, p in prop::array::uniform3(-4.0f64..4.0), weight in 0.0f64..4.0, s in prop::array::uniform3(prop_oneof![Just(-1.0), Just(1.0), -1.0f64..1.0]), is_negative in any::<bool>()) {
            let bounds = BoxBounds { value, error: 0.0, linear, spread: [0.0; 3], rest };
            let sense = if is_negative { -1.0 } else { 1.0 };
            let found = bounds.distance_bound(p.map(Interval::from), sense, weight, s);
            if let Some(exact) = exact_nearest(&bounds, &rationals(p)) {
                prop_assert!(rational(found) * rational(found) <= exact);
            }
        }

        /// A plane through a corner of the cube, or an ulp beside it: the box is proved to be empty only if it is.
        #[test]
        fn boxes_with_a_zero_at_a_corner_are_not_empty(linear in prop::array::uniform3(-2.0f64..2.0), rest in 0.0f64..0.5, ulps in -3i64..4) {
            let sum = linear.iter().map(|m| m.abs()).sum::<f64>() + rest;
            let value = f64::from_bits(u64::try_from(i64::try_from(sum.to_bits()).unwrap() + ulps).unwrap());
            let bounds = BoxBounds { value, error: 0.0, linear, spread: [0.0; 3], rest };
            let exact: Rational = rationals(linear).iter().map(Rational::abs).sum();
            if exact + rational(rest) >= rational(value) {
                prop_assert!(!bounds.is_empty());
            }
        }
    }

    /// Boxes without a common zero are excluded: one of the functions has no zero there, or the two cross elsewhere at a small
    /// angle.
    #[test]
    fn boxes_apart_from_common_zeros_are_excluded() {
        let [x, y, _] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
        let on = |f: &SparsePolynomial<3>| Field::new(f).on_box([0.0; 3], [0.5; 3]);
        let tilted = y.plus(&x.scaled(&Rational::from(2).pow(-5).unwrap()));
        let constant = |c: i64| SparsePolynomial::constant(Rational::from(c) / Rational::from(8));
        let (here, tilted, beside, far) = (
            on(&y),
            on(&tilted),
            on(&y.minus(&constant(1))),
            on(&y.minus(&constant(8))),
        );
        // Each of the two has a zero in the box, and they cross in it.
        assert!(!here.exclude(&tilted) && !tilted.exclude(&here));
        // The two are parallel or nearly parallel. Each has zeros in the box, but there is no common zero.
        for (f, g) in [(&here, &beside), (&tilted, &beside), (&here, &far)] {
            assert!(f.exclude(g) && g.exclude(f));
        }
    }

    #[test]
    fn verdicts_on_cubes() {
        let f = Field::new(&sphere(1));
        let on = |middle, half: f64| f.on_box(middle, [half; 3]).verdict();
        assert_eq!(on([0.0; 3], 0.5), BoxProof::Empty);
        assert_eq!(on([0.0; 3], 0.6), BoxProof::Open);
        assert_eq!(on([1.0, 0.0, 0.0], 0.2), BoxProof::Regular);
        assert_eq!(on([1.3, 0.0, 0.0], 0.2), BoxProof::Empty);
    }

    proptest! {
        /// A box with a known common zero of two functions that cross at a small angle is not excluded.
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

        /// In a cube that is proved to be empty f has one sign.
        #[test]
        fn empty_cubes_have_one_sign(c in prop::collection::vec(-9i64..10, 20), m in prop::array::uniform3(-3.0f64..3.0), half in 0.01f64..0.5, at in prop::array::uniform3(-1.0f64..1.0)) {
            let all = (0..4u32).flat_map(|i| (0..4 - i).flat_map(move |j| (0..4 - i - j).map(move |k| [i, j, k])));
            let f = Field::new(&SparsePolynomial::from_terms(all.zip(c.into_iter().map(Rational::from))));
            if f.on_box(m, [half; 3]).verdict() == BoxProof::Empty {
                let p = std::array::from_fn(|i| m[i] + half * at[i]);
                prop_assert_eq!(f.sign(p), f.sign(m));
            }
        }
    }
}
