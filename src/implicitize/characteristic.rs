//! Characteristic polynomials of Laurent polynomials in a root of another one, modulo four primes at once.
//!
//! Let x(z) = Σ x_k z^k for −N ≤ k ≤ N and y(z) = Σ y_k z^k for −M ≤ k ≤ M. For a number v let g be z^M (y(z) − v) divided by its
//! leading coefficient, of degree n = 2M, and A = F_p[z]/(g). The characteristic polynomial of the multiplication by x in A is
//! ∏ (u − x(ρ)) over the roots ρ of g. Its coefficients follow from the traces of the powers of x by Newton's identities, and the
//! traces Tr(x^(Bj + i)) are values of the linear forms Tr(x^(Bj) ·) at the elements x^i: about 2√n products in A, of n² products
//! of residues each.

use pulp::NullaryFnOnce;

use crate::bigint::{LaneFields, Lanes, Quartet, f64_from, minus, plus};
use crate::error::Invariant;

/// So many products, of at most 3p/4 each, are added before a sum is reduced: sums stay below 8p.
const TOGETHER: usize = 8;

/// The two Laurent polynomials modulo four primes, and what all values v have in common.
#[derive(Debug)]
pub(super) struct Pair {
    field: LaneFields,
    /// The coefficients of x, from z^(−N) on.
    x: Vec<Lanes>,
    /// The coefficients of z^M y(z), divided by the leading one.
    g: Vec<Lanes>,
    /// 1/y_M.
    leading_inverse: Lanes,
    /// 1/g_0.
    last_inverse: Lanes,
    /// The numbers 1/k for 0 < k ≤ the larger one of 2M and 2N.
    inverses: Vec<Lanes>,
}

impl Pair {
    /// The pair of x and y, given by their coefficients from the lowest on. No prime may divide the leading coefficient of y or
    /// its lowest one.
    #[inline(always)]
    pub(super) fn new(quartet: &Quartet, x: Vec<Lanes>, y: &[Lanes]) -> Self {
        let field = quartet.field();
        let leading_inverse = field.inverse_of(y[y.len() - 1]);
        let mut g: Vec<Lanes> = y
            .iter()
            .map(|&c| field.reduced(field.times(c, leading_inverse)))
            .collect();
        g[y.len() - 1] = [1.0; 4];
        let last_inverse = field.reduced(field.inverse_of(g[0]));
        let most = (x.len() - 1).max(y.len() - 1);
        let mut count = [0.0; 4];
        let mut inverses = vec![[0.0; 4]];
        for _ in 0..most {
            count = plus(count, [1.0; 4]);
            inverses.push(field.reduced(field.inverse_of(count)));
        }
        Self {
            field,
            x,
            g,
            leading_inverse: field.reduced(leading_inverse),
            last_inverse,
            inverses,
        }
    }

    /// The degree n.
    fn degree(&self) -> usize {
        self.g.len() - 1
    }

    /// The inverses of 1, 2, …, after a 0.
    pub(super) fn inverses(&self) -> &[Lanes] {
        &self.inverses
    }

    pub(super) fn field(&self) -> LaneFields {
        self.field
    }
}

/// The characteristic polynomial for a value v.
pub(super) struct Characteristic<'a> {
    pub(super) pair: &'a Pair,
    pub(super) value: f64,
}

impl NullaryFnOnce for Characteristic<'_> {
    /// The coefficients from u^0 on; the leading one, 1, is left out.
    type Output = Vec<Lanes>;

    #[inline(always)]
    fn call(self) -> Vec<Lanes> {
        let pair = self.pair;
        let (field, n) = (pair.field, pair.degree());
        let mut g = pair.g.clone();
        let shift = field.times([self.value; 4], pair.leading_inverse);
        g[n / 2] = field.reduced(minus(g[n / 2], shift));
        let ring = Ring { field, g };
        let x = ring.value(pair);
        // The square root of n balances the two kinds of steps.
        let block = (1..=n).find(|b| b * b >= n).invariant("n² is at least n");
        let mut powers = vec![ring.one()];
        for _ in 0..block {
            let last = &powers[powers.len() - 1];
            powers.push(ring.product(last, &x));
        }
        let giant = powers.pop().invariant("there is the power 0");
        let mut form = ring.traces();
        let mut traces = Vec::with_capacity(n + block);
        while traces.len() <= n {
            traces.extend(powers.iter().map(|power| ring.dot(&form, power)));
            if traces.len() <= n {
                form = ring.form_after(&form, &giant);
            }
        }
        // Newton's identities: k c_(n−k) = −Σ_{0 ≤ i < k} c_(n−i) p_(k−i) with c_n = 1.
        let mut descending = vec![[1.0; 4]];
        for k in 1..=n {
            let sum = ring.sum_of_products((0..k).map(|i| (descending[i], traces[k - i])));
            let c = field.times(sum, pair.inverses[k]);
            descending.push(field.reduced(minus([0.0; 4], c)));
        }
        descending.reverse();
        descending.truncate(n);
        descending
    }
}

/// The ring A. All residues that are kept are reduced: at most p/2 + 1.
struct Ring {
    field: LaneFields,
    /// The modulus, with the leading coefficient 1.
    g: Vec<Lanes>,
}

impl Ring {
    #[inline(always)]
    fn degree(&self) -> usize {
        self.g.len() - 1
    }

    #[inline(always)]
    fn one(&self) -> Vec<Lanes> {
        let mut one = vec![[0.0; 4]; self.degree()];
        one[0] = [1.0; 4];
        one
    }

    /// The sum of products of pairs of reduced residues, reduced.
    #[inline(always)]
    fn sum_of_products(&self, pairs: impl Iterator<Item = (Lanes, Lanes)>) -> Lanes {
        let mut sum = [0.0; 4];
        for (k, (a, b)) in pairs.enumerate() {
            sum = plus(sum, self.field.times(a, b));
            if k % TOGETHER == TOGETHER - 1 {
                sum = self.field.reduced(sum);
            }
        }
        self.field.reduced(sum)
    }

    #[inline(always)]
    fn dot(&self, a: &[Lanes], b: &[Lanes]) -> Lanes {
        self.sum_of_products(a.iter().copied().zip(b.iter().copied()))
    }

    /// The element x(z).
    #[inline(always)]
    fn value(&self, pair: &Pair) -> Vec<Lanes> {
        let (field, n) = (self.field, self.degree());
        let reach = pair.x.len() / 2;
        let mut value = vec![[0.0; 4]; n];
        let mut add = |power: &[Lanes], c: Lanes| {
            for (sum, p) in value.iter_mut().zip(power) {
                *sum = field.reduced(plus(*sum, field.times(*p, c)));
            }
        };
        let mut power = self.one();
        add(&power, pair.x[reach]);
        for k in 1..=reach {
            // The next power of z.
            let top = power[n - 1];
            for i in (0..n).rev() {
                let below = if i == 0 { [0.0; 4] } else { power[i - 1] };
                power[i] = field.reduced(minus(below, field.times(top, self.g[i])));
            }
            add(&power, pair.x[reach + k]);
        }
        let mut power = self.one();
        for k in 1..=reach {
            // The next power of 1/z, from g_0 = −Σ_{i > 0} g_i z^i.
            let c = field.reduced(field.times(power[0], pair.last_inverse));
            for i in 0..n {
                let above = if i + 1 == n { [0.0; 4] } else { power[i + 1] };
                power[i] = field.reduced(minus(above, field.times(c, self.g[i + 1])));
            }
            add(&power, pair.x[reach - k]);
        }
        value
    }

    /// The product of two elements.
    #[inline(always)]
    fn product(&self, a: &[Lanes], b: &[Lanes]) -> Vec<Lanes> {
        let (field, n) = (self.field, self.degree());
        let mut wide = vec![[0.0; 4]; 2 * n - 1];
        for (i, &c) in a.iter().enumerate() {
            for (sum, &d) in wide[i..i + n].iter_mut().zip(b) {
                *sum = plus(*sum, field.times(c, d));
            }
            if i % TOGETHER == TOGETHER - 1 {
                self.reduce(&mut wide);
            }
        }
        self.reduce(&mut wide);
        for (count, k) in (n..2 * n - 1).rev().enumerate() {
            let top = field.reduced(wide[k]);
            for (sum, &c) in wide[k - n..k].iter_mut().zip(&self.g) {
                *sum = minus(*sum, field.times(top, c));
            }
            if count % TOGETHER == TOGETHER - 2 {
                self.reduce(&mut wide[..k]);
            }
        }
        wide.truncate(n);
        self.reduce(&mut wide);
        wide
    }

    #[inline(always)]
    fn reduce(&self, values: &mut [Lanes]) {
        for value in values {
            *value = self.field.reduced(*value);
        }
    }

    /// The traces of 1, z, …, z^(n−1): Newton's identities for the power sums s_k of the roots of g,
    /// s_k = −k g_(n−k) − Σ_{0 < i < k} g_(n−i) s_(k−i).
    #[inline(always)]
    fn traces(&self) -> Vec<Lanes> {
        let (field, n) = (self.field, self.degree());
        let mut count = [0.0; 4];
        let mut traces = vec![count];
        for k in 1..n {
            count = plus(count, [1.0; 4]);
            let sum = self.sum_of_products((1..k).map(|i| (self.g[n - i], traces[k - i])));
            let own = field.times(count, self.g[n - k]);
            traces.push(field.reduced(minus([0.0; 4], plus(sum, own))));
        }
        traces[0] = plus(count, [1.0; 4]);
        traces
    }

    /// The linear form a ↦ ℓ(h a), for a form ℓ that is given by its values at 1, z, …, z^(n−1).
    #[inline(always)]
    fn form_after(&self, form: &[Lanes], h: &[Lanes]) -> Vec<Lanes> {
        let (field, n) = (self.field, self.degree());
        // The values at further powers of z, from g(z) = 0.
        let mut wide = form.to_vec();
        for k in n..2 * n - 1 {
            let sum = self.sum_of_products((0..n).map(|i| (self.g[i], wide[k - n + i])));
            wide.push(field.reduced(minus([0.0; 4], sum)));
        }
        let mut after = vec![[0.0; 4]; n];
        for (i, &c) in h.iter().enumerate() {
            for (sum, &value) in after.iter_mut().zip(&wide[i..]) {
                *sum = plus(*sum, field.times(c, value));
            }
            if i % TOGETHER == TOGETHER - 1 {
                self.reduce(&mut after);
            }
        }
        self.reduce(&mut after);
        after
    }
}

/// Interpolates: from the values at 0, 1, …, m of a polynomial of degree at most m to its coefficients.
pub(super) struct Interpolation<'a> {
    pub(super) pair: &'a Pair,
    pub(super) values: Vec<Lanes>,
}

impl NullaryFnOnce for Interpolation<'_> {
    type Output = Vec<Lanes>;

    #[inline(always)]
    fn call(self) -> Vec<Lanes> {
        let field = self.pair.field();
        let inverses = self.pair.inverses();
        let mut table = self.values;
        let len = table.len();
        // Divided differences; the distance of the k-th point from the one `step` before it is `step`.
        for (step, inverse) in inverses.iter().enumerate().take(len).skip(1) {
            for k in (step..len).rev() {
                let difference = field.reduced(minus(table[k], table[k - 1]));
                table[k] = field.reduced(field.times(difference, *inverse));
            }
        }
        // Horner's rule for Newton's form: the polynomial times (v − k), plus the next difference.
        let mut node = [f64_from(len as u64 - 1); 4];
        let mut coefficients: Vec<Lanes> = Vec::with_capacity(len);
        for c in table.into_iter().rev() {
            coefficients.insert(0, [0.0; 4]);
            for k in 0..coefficients.len() {
                let above = coefficients.get(k + 1).copied().unwrap_or([0.0; 4]);
                coefficients[k] = field.reduced(minus(coefficients[k], field.times(node, above)));
            }
            coefficients[0] = field.reduced(plus(coefficients[0], c));
            node = minus(node, [1.0; 4]);
        }
        coefficients.truncate(len);
        coefficients
    }
}
