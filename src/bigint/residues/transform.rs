//! The fast Fourier transform modulo primes: values at roots of unity, and back.
//!
//! Lemma 1 (forward). From numbers of at most Ap, A ≤ 3, two steps of [`Transform::forward_power_of_two`] lead to numbers of at most 3p,
//! and no sum between is more than 8p.
//! Proof. x2 and x3 times c are at most (1/2 + 3/16 A) p ≤ 17/16 p (Lemma 3 of lanes.rs), so s1, d1 ≤ (3 + 17/16) p < 4.07p, and their products
//! with a root at most (1/2 + 3/16 · 4.07) p < 1.27p. x0 ≤ p/2 + 1, s0 and d0 ≤ (1/2 + 17/16) p + 1; the results ≤ 2.83p + 1 < 3p.
//!
//! Lemma 2 (backward). From numbers of at most 2p two steps of [`Transform::backward_power_of_two`] lead to numbers of at most 2p, and no
//! sum between is more than 8p.
//! Proof. Sums of four are at most 8p, reduced p/2 + 1. d0, d1 ≤ (1/2 + 3/16 · 4) p = 5/4 p, their sum is reduced, their difference and s0 − s1 are
//! at most 8p, and the product of that with a root is at most (1/2 + 3/16 · 8) p = 2p.
//!
//! Lemma 3 (points beyond, forward). [`More::forward`] leads from numbers of at most 2p to numbers of at most 2p.
//! Proof. What [`folded`] leaves is at most 6p, its product with ω at most (1/2 + 3/16 · 6) p < 2p, both together at most 8p, the product of
//! that with a twist at most 2p; the other sum, of at most 4p, is reduced.
//!
//! Lemma 4 (points beyond, backward). [`More::backward`] leads from numbers of at most 2p to numbers of at most p/2 + 1.
//! Proof. The product of f2 is at most (1/2 + 3/16 · 2) p, those of what [`folded`] leaves of f1 (1/2 + 3/16 · 6) p each: less than 5p together,
//! and reduced; the difference with f1 is at most 2.5p + 1, and reduced.
//!
//! Laws: `forward_are_the_values_and_backward_takes_them_back`, with numbers of exactly 2p; all sums and differences of the largest numbers are
//! in `the_largest_numbers_stay_as_small_as_is_said`.

use super::lanes::{LaneFields, Lanes, minus, negated, plus};
use super::primes::ORDER_BITS;
use crate::bigint::f64_from;

/// The transforms of n = m, 3/2 m or 5/4 m numbers modulo four primes, where m = 2^k ≥ 4.
///
/// For n = m the values are those at 1, −1, i, −i, √i, −√i, …: the m-th roots of unity in the order of reversed bits. A
/// block of the transform works modulo x^l − c², and one root c serves the whole block. For n = m + m' they are followed
/// by those at θ times the m'-th roots of unity, θ of order 3m': polynomials modulo (x^m − 1) (x^m' − ω), ω of order 3.
#[derive(Clone, Debug, Default)]
pub(crate) struct Transform {
    field: LaneFields,
    /// The number m.
    power: usize,
    /// The root c of each block: 1, i, √i, i√i, …, m/2 of them. The first ones do not depend on m.
    roots: Vec<Lanes>,
    /// The further points, if n > m.
    more: Option<More>,
}

/// The values at the points that are no m-th roots of unity.
#[derive(Clone, Debug, Default)]
struct More {
    /// The root ω.
    third: Lanes,
    /// The powers θ^j for j < m'.
    twists: Vec<Lanes>,
    /// The numbers m/m' κ θ^(−j) with κ = 1/(ω^(m/m') − 1).
    untwists: Vec<Lanes>,
    /// The numbers κ and κω.
    weights: [Lanes; 2],
}

/// The smallest length of a transform that is at least `len`.
pub(crate) fn transform_len(len: usize) -> usize {
    let power = len.next_power_of_two().max(4);
    let below = power / 2;
    let more = [4, 2].map(|parts| below / parts);
    let lens = more
        .into_iter()
        .filter(|more| *more >= 4)
        .map(|more| below + more);
    lens.filter(|n| *n >= len).min().unwrap_or(power)
}

/// The number at an index is the product of `first` and of the factors for those bits of the index that are 1. The lowest bit
/// belongs to the first factor.
#[inline(always)]
fn set_products(
    products: &mut Vec<Lanes>,
    field: &LaneFields,
    first: Lanes,
    factors: impl Iterator<Item = Lanes>,
) {
    products.clear();
    products.push(first);
    for factor in factors {
        let by = field.factor(factor);
        for j in 0..products.len() {
            products.push(field.reduced(field.times_factor(products[j], by)));
        }
    }
}

/// The first `count` of the squares x, x², x⁴, ….
#[inline(always)]
fn squares(field: &LaneFields, x: Lanes, count: u32) -> Vec<Lanes> {
    let mut squares = vec![x];
    for k in 1..count as usize {
        let last = squares[k - 1];
        squares.push(field.reduced(field.times(last, last)));
    }
    squares
}

impl More {
    /// Sets up the points for θ of order 3m', with m' = 2^bits, where m/m' is 2 or 4.
    #[inline(always)]
    fn set(&mut self, field: &LaneFields, theta: Lanes, bits: u32, parts: f64) {
        self.third = field.reduced(field.power(theta, 1 << bits));
        // The power ω² or ω⁴.
        let mut power = field.reduced(field.times(self.third, self.third));
        if parts > 2.0 {
            power = self.third;
        }
        let weight = field.reduced(field.inverse_of(field.reduced(minus(power, [1.0; 4]))));
        self.weights = [weight, field.reduced(field.times(weight, self.third))];
        let factors = squares(field, theta, bits).into_iter();
        set_products(&mut self.twists, field, [1.0; 4], factors);
        let first = field.reduced(field.times(weight, [parts; 4]));
        let inverse = field.reduced(field.inverse_of(theta));
        let factors = squares(field, inverse, bits).into_iter();
        set_products(&mut self.untwists, field, first, factors);
    }
}

impl Transform {
    /// Sets up the transform for a length of [`transform_len`], with a root of unity of order 3 · 2^[`ORDER_BITS`].
    #[inline(always)]
    pub(super) fn set(&mut self, field: LaneFields, root: Lanes, len: usize) {
        let bits = len.ilog2();
        let thirds = squares(&field, root, ORDER_BITS + 1);
        // The root of order 3 · 2^bits.
        let theta = |bits: u32| thirds[(ORDER_BITS - bits) as usize];
        let cube = field.times(field.times(theta(bits), theta(bits)), theta(bits));
        // The roots of the orders from 2^bits down to 4.
        let factors = squares(&field, field.reduced(cube), bits - 1);
        set_products(&mut self.roots, &field, [1.0; 4], factors.into_iter().rev());
        self.field = field;
        self.power = 1 << bits;
        let beyond = len - self.power;
        if let Some(parts) = self.power.checked_div(beyond) {
            let bits = beyond.ilog2();
            let more = self.more.get_or_insert_default();
            more.set(&field, theta(bits), bits, f64_from(parts as u64));
        } else {
            self.more = None;
        }
    }

    /// The number of numbers that are transformed.
    #[inline(always)]
    pub(super) fn len(&self) -> usize {
        self.power + self.more.as_ref().map_or(0, |more| more.twists.len())
    }

    /// The scale 1/m, because [`Transform::backward`] multiplies by m.
    #[inline(always)]
    pub(super) fn scale(&self) -> Lanes {
        self.field.inverse_of_divisor(f64_from(self.power as u64))
    }

    /// Replaces coefficients, of at most 2p, by values, of at most 3p.
    #[inline(always)]
    pub(crate) fn forward(&self, values: &mut [Lanes]) {
        if let Some(more) = &self.more {
            more.forward(&self.field, values);
        }
        let (values, beyond) = values.split_at_mut(self.power);
        self.forward_power_of_two(values);
        if !beyond.is_empty() {
            self.forward_power_of_two(beyond);
        }
    }

    /// Replaces values, of at most 2p, by m times the coefficients, of at most 2p.
    #[inline(always)]
    pub(crate) fn backward(&self, values: &mut [Lanes]) {
        let (first, beyond) = values.split_at_mut(self.power);
        self.backward_power_of_two(first);
        if !beyond.is_empty() {
            self.backward_power_of_two(beyond);
        }
        if let Some(more) = &self.more {
            more.backward(&self.field, values);
        }
    }

    /// The squares of the points. The values are in pairs, at a point and at its negative.
    #[inline(always)]
    pub(crate) fn set_squared_points(&self, points: &mut Vec<Lanes>) {
        let field = &self.field;
        points.clear();
        for c in &self.roots {
            points.push(field.times(*c, *c));
        }
        if let Some(more) = &self.more {
            let theta = more.twists[1];
            let by = field.factor(field.reduced(field.times(theta, theta)));
            for j in 0..more.twists.len() / 2 {
                points.push(field.times_factor(points[j], by));
            }
        }
    }

    /// The forward transform of m numbers, two steps at a time. The numbers are at most 3p before and after. Lemma 1.
    #[inline(always)]
    fn forward_power_of_two(&self, values: &mut [Lanes]) {
        let field = &self.field;
        let mut len = values.len();
        while len >= 4 {
            for (b, block) in values.chunks_exact_mut(len).enumerate() {
                let c = field.factor(self.roots[b]);
                let below = [
                    field.factor(self.roots[2 * b]),
                    field.factor(self.roots[2 * b + 1]),
                ];
                for [a0, a1, a2, a3] in quarters(block) {
                    let x0 = field.reduced(*a0);
                    let (x2, x3) = (field.times_factor(*a2, c), field.times_factor(*a3, c));
                    let (s0, s1) = (plus(x0, x2), plus(*a1, x3));
                    let (d0, d1) = (minus(x0, x2), minus(*a1, x3));
                    let s1 = field.times_factor(s1, below[0]);
                    let d1 = field.times_factor(d1, below[1]);
                    (*a0, *a1) = (plus(s0, s1), minus(s0, s1));
                    (*a2, *a3) = (plus(d0, d1), minus(d0, d1));
                }
            }
            len /= 4;
        }
        if len == 2 {
            for (pair, root) in values.as_chunks_mut::<2>().0.iter_mut().zip(&self.roots) {
                let [x0, x1] = *pair;
                let x0 = field.reduced(x0);
                let x1 = field.times_factor(x1, field.factor(*root));
                *pair = [plus(x0, x1), minus(x0, x1)];
            }
        }
    }

    /// The backward transform of m numbers, two steps at a time. The numbers are at most 2p before and after. Lemma 2.
    #[inline(always)]
    fn backward_power_of_two(&self, values: &mut [Lanes]) {
        let field = &self.field;
        let mut len = 4;
        if !values.len().ilog2().is_multiple_of(2) {
            for (b, pair) in values.as_chunks_mut::<2>().0.iter_mut().enumerate() {
                let [x0, x1] = *pair;
                let c = field.factor(self.inverse_root(b));
                *pair = [
                    field.reduced(plus(x0, x1)),
                    field.times_factor(minus(x0, x1), c),
                ];
            }
            len = 8;
        }
        while len <= values.len() {
            for (b, block) in values.chunks_exact_mut(len).enumerate() {
                let c = field.factor(self.inverse_root(b));
                let below = self.inverse_root(2 * b);
                let below = [
                    field.factor(below),
                    field.factor(self.inverse_root(2 * b + 1)),
                ];
                for [a0, a1, a2, a3] in quarters(block) {
                    let (s0, s1) = (plus(*a0, *a1), plus(*a2, *a3));
                    let d0 = field.times_factor(minus(*a0, *a1), below[0]);
                    let d1 = field.times_factor(minus(*a2, *a3), below[1]);
                    *a0 = field.reduced(plus(s0, s1));
                    *a1 = field.reduced(plus(d0, d1));
                    *a2 = field.times_factor(minus(s0, s1), c);
                    *a3 = field.times_factor(minus(d0, d1), c);
                }
            }
            len *= 4;
        }
    }

    /// The inverse of the root of block b.
    ///
    /// The exponents of the blocks 2^i … 2^(i+1) − 1, subtracted from half the order of the group, are those of the same blocks
    /// in reverse order; and the power with half the order is −1.
    #[inline(always)]
    fn inverse_root(&self, b: usize) -> Lanes {
        if b == 0 {
            return [1.0; 4];
        }
        let first = 1 << b.ilog2();
        negated(self.roots[3 * first - 1 - b])
    }
}

impl More {
    /// Reduces a polynomial f modulo x^m − 1 and, in x/θ, modulo x^m' − ω. The numbers are at most 2p before and after.
    ///
    /// f has one more coefficient in y = x^m' than x^m has. Lemma 3.
    #[inline(always)]
    fn forward(&self, field: &LaneFields, values: &mut [Lanes]) {
        let third = field.factor(self.third);
        let more = self.twists.len();
        let (values, last) = values.split_at_mut(values.len() - more);
        for (j, (last, twist)) in last.iter_mut().zip(&self.twists).enumerate() {
            let [a, b] = folded(values, j, more, *last);
            values[j] = field.reduced(plus(values[j], *last));
            let left = plus(a, field.times_factor(b, third));
            *last = field.times_factor(left, field.factor(*twist));
        }
    }

    /// Computes m f from m f1 and m' f2, where f1 and f2 are the two remainders of f. The numbers are at most 2p before and
    /// after.
    ///
    /// f = f1 + (x^m − 1) g. As x^m is ω^(m/m') modulo x^m' − ω, g = κ (f2 − f1) there, and g has a degree less than m'. Lemma
    /// 4.
    #[inline(always)]
    fn backward(&self, field: &LaneFields, values: &mut [Lanes]) {
        let weights = [field.factor(self.weights[0]), field.factor(self.weights[1])];
        let more = self.untwists.len();
        let (values, last) = values.split_at_mut(values.len() - more);
        for (j, (last, untwist)) in last.iter_mut().zip(&self.untwists).enumerate() {
            let [a, b] = folded(values, j, more, [0.0; 4]);
            let of_f1 = plus(
                field.times_factor(a, weights[0]),
                field.times_factor(b, weights[1]),
            );
            let of_f2 = field.times_factor(*last, field.factor(*untwist));
            *last = field.reduced(minus(of_f2, of_f1));
            values[j] = field.reduced(minus(values[j], *last));
        }
    }
}

/// The numbers a and b with a0 + a1 y + … = a + bω for y = ω, where ω² + ω + 1 = 0. The a_i are the j-th coefficients of y^0,
/// y^1, …, which are `more` apart in `values` (two or four of them), and then `last`. With s_i the sum of every third a_j, they
/// are s0 − s2 and s1 − s2, at most 6p if all a_i are at most 2p.
#[inline(always)]
fn folded(values: &[Lanes], j: usize, more: usize, last: Lanes) -> [Lanes; 2] {
    let (first, second) = (values[j], values[j + more]);
    if values.len() == 2 * more {
        return [minus(first, last), minus(second, last)];
    }
    let (s2, fourth) = (values[j + 2 * more], values[j + 3 * more]);
    [
        minus(plus(first, fourth), s2),
        minus(plus(second, last), s2),
    ]
}

/// The numbers at the same position in the four quarters.
#[inline(always)]
fn quarters(block: &mut [Lanes]) -> impl Iterator<Item = [&mut Lanes; 4]> {
    let (first, second) = block.split_at_mut(block.len() / 2);
    let (a0, a1) = first.split_at_mut(first.len() / 2);
    let (a2, a3) = second.split_at_mut(second.len() / 2);
    let fours = a0.iter_mut().zip(a1).zip(a2).zip(a3);
    fours.map(|(((a0, a1), a2), a3)| [a0, a1, a2, a3])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bigint::residues::Quartet;
    use crate::bigint::residues::lanes::tests::{congruent, integer};
    use crate::bigint::{f64_from, u64_from};
    use malachite::Integer;
    use proptest::prelude::*;

    #[test]
    fn lengths_are_the_least() {
        let lens: Vec<usize> = (0..12).flat_map(|k| [4 << k, 12 << k, 20 << k]).collect();
        for len in 0..5000 {
            assert_eq!(
                Some(transform_len(len)),
                lens.iter().copied().filter(|l| *l >= len).min(),
                "{len}"
            );
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]
        #[test]
        fn forward_are_the_values_and_backward_takes_them_back(len in 0usize..400, seed in any::<u64>(), largest in any::<bool>()) {
            let quartet = Quartet::enough_for(300).pop().unwrap();
            let (field, transform) = (quartet.field, quartet.transform(transform_len(len)));
            let len = transform.len();
            prop_assert_eq!(len, transform_len(len));
            let mut random = crate::modular::SplitMix(seed);
            // Numbers up to twice p, of both signs.
            let coefficients: Vec<Lanes> = (0..len).map(|_| field.p.map(|p| {
                let size = if largest { 2.0 * p } else { f64_from(random.next() % u64_from(2.0 * p)) };
                if random.next().is_multiple_of(2) { size } else { -size }
            })).collect();
            let mut values = coefficients.clone();
            transform.forward(&mut values);
            let mut squares = Vec::new();
            transform.set_squared_points(&mut squares);
            prop_assert_eq!(squares.len(), len / 2);
            for i in 0..4 {
                let p = field.p[i];
                prop_assert!(values.iter().all(|v| v[i].abs() <= 3.0 * p));
                // f(t) + f(−t) is twice the even part at t².
                for pair in [0, len / 4, len / 2 - 1] {
                    let square = integer(squares[pair][i]);
                    let even = coefficients.iter().step_by(2).rev();
                    let even = even.fold(Integer::from(0), |sum, c| (sum * &square + integer(c[i])) % integer(p));
                    let sum = integer(values[2 * pair][i]) + integer(values[2 * pair + 1][i]);
                    prop_assert!(congruent(&sum, &(even * Integer::from(2)), p));
                }
                // The squares of the points are all different, and so are the points.
                let mut points: Vec<Integer> = squares.iter().map(|s| integer(field.canonical(*s)[i])).collect();
                points.sort_unstable();
                points.dedup();
                prop_assert_eq!(points.len(), len / 2);
            }
            let mut back = values.clone();
            for value in &mut back {
                *value = field.reduced(*value);
            }
            transform.backward(&mut back);
            for (back, c) in back.iter().zip(&coefficients) {
                for i in 0..4 {
                    prop_assert!(back[i].abs() <= 2.0 * field.p[i]);
                    let scaled = field.times(*back, transform.scale())[i];
                    prop_assert!(congruent(&integer(scaled), &integer(c[i]), field.p[i]));
                }
            }
        }

        /// All signs of numbers of exactly the largest size, for which sums and differences are the largest.
        #[test]
        fn the_largest_numbers_stay_as_small_as_is_said(len in 4usize..100, signs in any::<u64>(), by in 0u32..7) {
            let quartet = Quartet::enough_for(1).pop().unwrap();
            let (field, transform) = (quartet.field, quartet.transform(transform_len(len)));
            // The sign depends on some bits of the position: all equal, alternating, alternating in pairs, and so on.
            let sign = |k: usize| if signs >> ((k >> by) % 64) & 1 == 1 { -1.0 } else { 1.0 };
            let all = |size: f64| (0..transform.len()).map(|k| field.p.map(|p| (size * p).trunc() * sign(k))).collect::<Vec<Lanes>>();
            let largest = |values: &[Lanes], size: f64| {
                values.iter().all(|v| (0..4).all(|i| v[i].abs() <= size * field.p[i]))
            };
            let mut values = all(2.0);
            transform.forward(&mut values);
            prop_assert!(largest(&values, 3.0));
            let mut values = all(3.0);
            values.truncate(transform.power);
            transform.forward_power_of_two(&mut values);
            prop_assert!(largest(&values, 3.0));
            let mut values = all(2.0);
            transform.backward(&mut values);
            prop_assert!(largest(&values, 2.0));
        }

        /// The properties of the transform that the change of basis needs.
        #[test]
        fn products_are_products_of_values(a in prop::collection::vec(-9i32..10, 1..30), b in prop::collection::vec(-9i32..10, 1..30)) {
            let quartet = Quartet::enough_for(1).pop().unwrap();
            let len = transform_len(a.len() + b.len() - 1);
            let (field, transform) = (quartet.field, quartet.transform(len));
            let values = |c: &[i32]| {
                let mut values: Vec<Lanes> = c.iter().map(|c| [f64::from(*c); 4]).collect();
                values.resize(transform.len(), [0.0; 4]);
                transform.forward(&mut values);
                values
            };
            let (of_a, of_b) = (values(&a), values(&b));
            let times = |(a, b): (&Lanes, &Lanes)| field.times(field.reduced(*a), field.reduced(*b));
            let mut product: Vec<Lanes> = of_a.iter().zip(&of_b).map(times).collect();
            transform.backward(&mut product);
            let scale = transform.scale();
            for (k, c) in product.iter().enumerate() {
                let expected: i32 = (0..=k).map(|i| a.get(i).unwrap_or(&0) * b.get(k - i).unwrap_or(&0)).sum();
                let c = field.reduced(field.times(*c, scale));
                prop_assert_eq!(c.map(integer), [expected; 4].map(Integer::from));
            }
        }
    }
}
