//! Values at roots of unity and back: the fast Fourier transform modulo primes.

use super::primes::ORDER_BITS;
use super::quad::{Quad, QuadField, minus, negated, plus};

/// The transforms of n = 2^k or 3 · 2^k numbers modulo four primes, k ≥ 2.
///
/// For n = 2^k the values are those at 1, −1, i, −i, √i, −√i, …: the n-th roots of unity in the order of reversed bits. A
/// block of the transform works modulo x^m − c², and one root c serves the whole block. For n = 3 · 2^k they are followed
/// by those at θ and at θ² times these points, θ of order n.
#[derive(Clone, Debug, Default)]
pub(crate) struct Transform {
    field: QuadField,
    /// n.
    len: usize,
    /// c for block after block: 1, i, √i, i√i, …, 2^(k − 1) of them. The first ones do not depend on k.
    roots: Vec<Quad>,
    /// For n = 3 · 2^k.
    thirds: Thirds,
}

/// The step from n = 3m to m: modulo x^m − 1, x^m − ω and x^m − ω², where ω = θ^m, the latter two in x/θ and x/θ².
#[derive(Clone, Debug, Default)]
struct Thirds {
    /// ω.
    third: Quad,
    /// θ^j and θ^(2j) for j < m.
    twists: [Vec<Quad>; 2],
    /// Their inverses.
    untwists: [Vec<Quad>; 2],
}

/// The least length of a transform, 2^k or 3 · 2^k, that is at least `len`.
pub(crate) fn transform_len(len: usize) -> usize {
    let power = len.next_power_of_two().max(4);
    if power >= 16 && power / 4 * 3 >= len {
        power / 4 * 3
    } else {
        power
    }
}

/// The residues 1, x, x², …, 2^bits of them if each x is given the one before squared; in the order in which they are
/// given, the first bit last.
#[inline(always)]
fn set_products(products: &mut Vec<Quad>, field: &QuadField, factors: impl Iterator<Item = Quad>) {
    products.clear();
    products.push([1.0; 4]);
    for factor in factors {
        let by = field.factor(factor);
        for j in 0..products.len() {
            products.push(field.reduced(field.times_factor(products[j], by)));
        }
    }
}

/// x, x², x⁴, …, so many of them.
#[inline(always)]
fn squares(field: &QuadField, x: Quad, count: u32) -> Vec<Quad> {
    let mut squares = vec![x];
    for k in 1..count as usize {
        let last = squares[k - 1];
        squares.push(field.reduced(field.times(last, last)));
    }
    squares
}

/// θ^j and θ^(2j) for j < 2^bits.
#[inline(always)]
fn set_twists(twists: &mut [Vec<Quad>; 2], field: &QuadField, theta: Quad, bits: u32) {
    let squares = squares(field, theta, bits + 1);
    let [once, twice] = twists;
    set_products(once, field, squares[..bits as usize].iter().copied());
    set_products(twice, field, squares[1..].iter().copied());
}

impl Thirds {
    #[inline(always)]
    fn set(&mut self, field: &QuadField, theta: Quad, bits: u32) {
        self.third = field.reduced(field.power(theta, 1 << bits));
        set_twists(&mut self.twists, field, theta, bits);
        let inverse = field.reduced(field.inverse_of(theta));
        set_twists(&mut self.untwists, field, inverse, bits);
    }
}

impl Transform {
    /// Makes it one for a length of [`transform_len`], with a root of unity of order 3 · 2^[`ORDER_BITS`].
    #[inline(always)]
    pub(super) fn set(&mut self, field: QuadField, root: Quad, len: usize) {
        let bits = len.trailing_zeros();
        let above = squares(&field, root, ORDER_BITS - bits + 1);
        let theta = above[above.len() - 1];
        let cube = field.times(field.reduced(field.times(theta, theta)), theta);
        // Of orders 2^bits down to 4.
        let factors = squares(&field, field.reduced(cube), bits - 1);
        set_products(&mut self.roots, &field, factors.into_iter().rev());
        (self.field, self.len) = (field, len);
        if self.has_thirds() {
            self.thirds.set(&field, theta, bits);
        }
    }

    #[inline(always)]
    fn has_thirds(&self) -> bool {
        !self.len.is_power_of_two()
    }

    /// How many numbers are transformed.
    #[inline(always)]
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// From coefficients, of at most 2p, to values, of at most 3p.
    #[inline(always)]
    pub(crate) fn forward(&self, values: &mut [Quad]) {
        if self.has_thirds() {
            self.thirds.forward(&self.field, values);
        }
        for part in values.chunks_exact_mut(2 * self.roots.len()) {
            self.forward_power_of_two(part);
        }
    }

    /// From values, of at most 2p, to n times the coefficients, of at most 2p.
    #[inline(always)]
    pub(crate) fn backward(&self, values: &mut [Quad]) {
        for part in values.chunks_exact_mut(2 * self.roots.len()) {
            self.backward_power_of_two(part);
        }
        if self.has_thirds() {
            self.thirds.backward(&self.field, values);
        }
    }

    /// The squares of the points: the values come in pairs, at a point and at minus that point.
    #[inline(always)]
    pub(crate) fn set_squared_points(&self, points: &mut Vec<Quad>) {
        let field = &self.field;
        points.clear();
        for c in &self.roots {
            points.push(field.times(*c, *c));
        }
        if self.has_thirds() {
            for twists in &self.thirds.twists {
                let square = field.times(twists[1], twists[1]);
                let by = field.factor(field.reduced(square));
                for j in 0..self.roots.len() {
                    points.push(field.times_factor(points[j], by));
                }
            }
        }
    }

    /// Two steps at a time. If they are at most Ap before, x2 and x3 times c are at most (1/2 + 3/16 A) p, the first sums
    /// at most A more, hence below 4p; the products of those are at most (1/2 + 3/16 · 4) p, so that for A ≤ 3 no sum is
    /// more than (1/2 + 1/2 + 9/16 + 5/4) p < 3p.
    #[inline(always)]
    fn forward_power_of_two(&self, values: &mut [Quad]) {
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

    /// Two steps at a time. If they are at most Ap before, A ≤ 2, the sums of four are at most 4A p ≤ 8p, below 2^53; the
    /// products are at most (1/2 + 3/16 · 2A) p and (1/2 + 3/16 · 4A) p, which is again at most 2p.
    #[inline(always)]
    fn backward_power_of_two(&self, values: &mut [Quad]) {
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
    /// The exponents of the blocks 2^i … 2^(i+1) − 1 are those of the same blocks, from the last to the first, taken from
    /// half the order of the group: and that power is −1.
    #[inline(always)]
    fn inverse_root(&self, b: usize) -> Quad {
        if b == 0 {
            return [1.0; 4];
        }
        let first = 1 << b.ilog2();
        negated(self.roots[3 * first - 1 - b])
    }
}

impl Thirds {
    /// From x0 + x1 y + x2 y², y = x^m, to what is left modulo y − 1, y − ω and y − ω²: as ω² = −1 − ω, with
    /// t = ω (x1 − x2) that is x0 + x1 + x2, x0 − x2 + t and x0 − x1 − t. From at most 2p to at most 2p: t is at most
    /// (1/2 + 3/16 · 4) p, the latter two at most 6p before they are multiplied.
    #[inline(always)]
    fn forward(&self, field: &QuadField, values: &mut [Quad]) {
        let third = field.factor(self.third);
        let [once, twice] = &self.twists;
        for (([a0, a1, a2], once), twice) in thirds(values).zip(once).zip(twice) {
            let (x0, x1, x2) = (*a0, *a1, *a2);
            let t = field.times_factor(minus(x1, x2), third);
            *a0 = field.reduced(plus(plus(x0, x1), x2));
            *a1 = field.times_factor(plus(minus(x0, x2), t), field.factor(*once));
            *a2 = field.times_factor(minus(minus(x0, x1), t), field.factor(*twice));
        }
    }

    /// Three times the way back: with the twists undone and t = ω (x1 − x2), x0 + x1 + x2, x0 − x1 − t and x0 − x2 + t.
    #[inline(always)]
    fn backward(&self, field: &QuadField, values: &mut [Quad]) {
        let third = field.factor(self.third);
        let [once, twice] = &self.untwists;
        for (([a0, a1, a2], once), twice) in thirds(values).zip(once).zip(twice) {
            let x0 = *a0;
            let x1 = field.times_factor(*a1, field.factor(*once));
            let x2 = field.times_factor(*a2, field.factor(*twice));
            let t = field.times_factor(minus(x1, x2), third);
            *a0 = field.reduced(plus(plus(x0, x1), x2));
            *a1 = field.reduced(minus(minus(x0, x1), t));
            *a2 = field.reduced(plus(minus(x0, x2), t));
        }
    }
}

/// Numbers of one place in the four quarters.
#[inline(always)]
fn quarters(block: &mut [Quad]) -> impl Iterator<Item = [&mut Quad; 4]> {
    let (first, second) = block.split_at_mut(block.len() / 2);
    let (a0, a1) = first.split_at_mut(first.len() / 2);
    let (a2, a3) = second.split_at_mut(second.len() / 2);
    let fours = a0.iter_mut().zip(a1).zip(a2).zip(a3);
    fours.map(|(((a0, a1), a2), a3)| [a0, a1, a2, a3])
}

/// Numbers of one place in the three thirds.
#[inline(always)]
fn thirds(values: &mut [Quad]) -> impl Iterator<Item = [&mut Quad; 3]> {
    let (a0, rest) = values.split_at_mut(values.len() / 3);
    let (a1, a2) = rest.split_at_mut(rest.len() / 2);
    a0.iter_mut()
        .zip(a1)
        .zip(a2)
        .map(|((a0, a1), a2)| [a0, a1, a2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{f64_from, u64_from};
    use crate::poly::residues::Quartet;
    use crate::poly::residues::quad::tests::{congruent, integer};
    use malachite::Integer;
    use proptest::prelude::*;

    #[test]
    fn lengths_are_the_least() {
        let lens: Vec<usize> = (0..12).flat_map(|k| [4 << k, 12 << k]).collect();
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
            let mut random = crate::poly::SplitMix(seed);
            // Up to twice p, of both signs.
            let coefficients: Vec<Quad> = (0..len).map(|_| field.p.map(|p| {
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
                // All points are different: the product of values at them is that of others at others.
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
                    prop_assert!(congruent(&integer(back[i]), &(integer(c[i]) * Integer::from(len)), field.p[i]));
                }
            }
        }

        /// What the change of basis needs of it.
        #[test]
        fn products_are_products_of_values(a in prop::collection::vec(-9i32..10, 1..30), b in prop::collection::vec(-9i32..10, 1..30)) {
            let quartet = Quartet::enough_for(1).pop().unwrap();
            let len = transform_len(a.len() + b.len() - 1);
            let (field, transform) = (quartet.field, quartet.transform(len));
            let values = |c: &[i32]| {
                let mut values: Vec<Quad> = c.iter().map(|c| [f64::from(*c); 4]).collect();
                values.resize(transform.len(), [0.0; 4]);
                transform.forward(&mut values);
                values
            };
            let (of_a, of_b) = (values(&a), values(&b));
            let times = |(a, b): (&Quad, &Quad)| field.times(field.reduced(*a), field.reduced(*b));
            let mut product: Vec<Quad> = of_a.iter().zip(&of_b).map(times).collect();
            transform.backward(&mut product);
            let scale = field.inverse_of_divisor(f64_from(transform.len() as u64));
            for (k, c) in product.iter().enumerate() {
                let expected: i32 = (0..=k).map(|i| a.get(i).unwrap_or(&0) * b.get(k - i).unwrap_or(&0)).sum();
                let c = field.reduced(field.times(*c, scale));
                prop_assert_eq!(c.map(integer), [expected; 4].map(Integer::from));
            }
        }
    }
}
