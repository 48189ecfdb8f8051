//! Characteristic polynomials of Laurent polynomials in a root of another one, modulo four short primes at once.
//!
//! Let x(z) = Σ x_k z^k for −N ≤ k ≤ N and y(z) = Σ y_k z^k for −M ≤ k ≤ M. For a number v let g be z^M (y(z) − v) divided by its
//! leading coefficient, of degree n = 2M, and A = F_p[z]/(g). The characteristic polynomial of the multiplication by x in A is
//! ∏ (u − x(ρ)) over the roots ρ of g. Its coefficients follow from the traces of the powers of x by Newton's identities, and the
//! traces Tr(x^(Bj + i)) are values of the linear forms Tr(x^(Bj) ·) at the elements x^i: about 2√n products in A, of n² products
//! of residues each.

use pulp::NullaryFnOnce;

use crate::bigint::f64_from;
use crate::error::Invariant;
use crate::modular::{Four, FourFields, multiplied, negated};

/// The two Laurent polynomials modulo four primes, and what all values v have in common.
#[derive(Debug)]
pub(super) struct Pair {
    field: FourFields,
    /// The coefficients of x, from z^(−N) on.
    x: Vec<Four>,
    /// The coefficients of z^M y(z), divided by the leading one.
    g: Vec<Four>,
    /// 1/y_M.
    leading_inverse: Four,
    /// 1/g_0.
    last_inverse: Four,
    /// The numbers 1/k for 0 < k ≤ the larger one of 2M and 2N.
    inverses: Vec<Four>,
}

impl Pair {
    /// The pair of x and y, given by their reduced coefficients from the lowest on. No prime may divide the leading coefficient of
    /// y or its lowest one.
    pub(super) fn new(field: FourFields, x: Vec<Four>, y: &[Four]) -> Self {
        let inverse_of = |a: Four| field.inverse(a);
        let leading_inverse = inverse_of(y[y.len() - 1]);
        let mut g: Vec<Four> = y.iter().map(|&c| field.times(c, leading_inverse)).collect();
        g[y.len() - 1] = [1.0; 4];
        let last_inverse = inverse_of(g[0]);
        let most = (x.len() - 1).max(y.len() - 1);
        let mut inverses = vec![[0.0; 4]];
        inverses.extend((1..=most as u64).map(|k| field.of(|field| field.inverse(k))));
        Self {
            field,
            x,
            g,
            leading_inverse,
            last_inverse,
            inverses,
        }
    }

    /// The degree n.
    fn degree(&self) -> usize {
        self.g.len() - 1
    }

    /// The inverses of 1, 2, …, after a 0.
    pub(super) fn inverses(&self) -> &[Four] {
        &self.inverses
    }

    pub(super) fn field(&self) -> FourFields {
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
    type Output = Vec<Four>;

    #[inline(always)]
    fn call(self) -> Vec<Four> {
        let pair = self.pair;
        let (field, n) = (pair.field, pair.degree());
        let ring = Ring::new(pair, self.value);
        let x = ring.value(pair);
        // The square root of n balances the two kinds of steps.
        let block = (1..=n).find(|b| b * b >= n).invariant("n² is at least n");
        let mut powers = vec![ring.one()];
        for _ in 0..block {
            let last = &powers[powers.len() - 1];
            powers.push(ring.product(last, &x));
        }
        let mut giant = powers.pop().invariant("there is the power 0");
        giant.reverse();
        let mut form = ring.traces();
        let mut traces = Vec::with_capacity(n + block);
        while traces.len() <= n {
            for power in &powers {
                traces.push(ring.dot(&form, power));
            }
            if traces.len() <= n {
                form = ring.form_after(&form, &giant);
            }
        }
        // Newton's identities: k c_(n−k) = −Σ_{0 ≤ i < k} c_(n−i) p_(k−i) with c_n = 1.
        let mut descending = vec![[1.0; 4]];
        for k in 1..=n {
            let sum = field.sum_of_products((0..k).map(|i| (descending[i], traces[k - i])));
            descending.push(negated(field.times(sum, pair.inverses[k])));
        }
        descending.reverse();
        descending.truncate(n);
        descending
    }
}

/// The ring A. All residues are reduced.
struct Ring {
    field: FourFields,
    /// The modulus, with the leading coefficient 1.
    g: Vec<Four>,
    /// The coefficients of g from the leading one down.
    descending: Vec<Four>,
    /// The first n coefficients of the power series 1/Σ g_(n−i) T^i.
    series: Vec<Four>,
}

impl Ring {
    #[inline(always)]
    fn new(pair: &Pair, value: f64) -> Self {
        let (field, n) = (pair.field, pair.degree());
        let mut g = pair.g.clone();
        g[n / 2] = field.reduced(multiplied([-value; 4], pair.leading_inverse, g[n / 2]));
        let descending: Vec<Four> = g.iter().rev().copied().collect();
        let mut series = vec![[1.0; 4]];
        for k in 1..n {
            let sum = field.sum_of_products((1..=k).map(|i| (descending[i], series[k - i])));
            series.push(negated(sum));
        }
        Self {
            field,
            g,
            descending,
            series,
        }
    }

    #[inline(always)]
    fn degree(&self) -> usize {
        self.g.len() - 1
    }

    #[inline(always)]
    fn one(&self) -> Vec<Four> {
        let mut one = vec![[0.0; 4]; self.degree()];
        one[0] = [1.0; 4];
        one
    }

    #[inline(always)]
    fn dot(&self, a: &[Four], b: &[Four]) -> Four {
        let pairs = a.iter().copied().zip(b.iter().copied());
        self.field.sum_of_products(pairs)
    }

    /// The element x(z).
    #[inline(always)]
    fn value(&self, pair: &Pair) -> Vec<Four> {
        let (field, n) = (self.field, self.degree());
        // First z^N x(z), modulo g from the highest power down.
        let mut value = pair.x.clone();
        while value.len() > n {
            let top = value.pop().invariant("it is longer than n");
            let low = value.len() - n;
            for (c, g) in value[low..].iter_mut().zip(&self.g) {
                *c = field.reduced(multiplied(negated(top), *g, *c));
            }
        }
        value.resize(n, [0.0; 4]);
        // Then N divisions by z, by g_0 = −Σ_{i > 0} g_i z^i.
        for _ in 0..pair.x.len() / 2 {
            let c = negated(field.times(value[0], pair.last_inverse));
            for i in 0..n {
                let above = value.get(i + 1).copied().unwrap_or([0.0; 4]);
                value[i] = field.reduced(multiplied(c, self.g[i + 1], above));
            }
        }
        value
    }

    /// The product of two elements.
    ///
    /// With w = q g + r, the coefficients of q from the leading one down are those of the power series of w divided by that of g.
    #[inline(always)]
    fn product(&self, a: &[Four], b: &[Four]) -> Vec<Four> {
        let (field, n) = (self.field, self.degree());
        let wide = field.product(a, b, 0..2 * n - 1);
        let top: Vec<Four> = wide[n..].iter().rev().copied().collect();
        let mut quotient = field.product(&top, &self.series, 0..n - 1);
        quotient.reverse();
        let multiple = field.product(&quotient, &self.g, 0..n);
        self.difference(&wide[..n], &multiple)
    }

    #[inline(always)]
    fn difference(&self, a: &[Four], b: &[Four]) -> Vec<Four> {
        let minus = |(a, b): (&Four, &Four)| self.field.reduced(multiplied([-1.0; 4], *b, *a));
        a.iter().zip(b).map(minus).collect()
    }

    /// The traces of 1, z, …, z^(n−1): Newton's identities for the power sums s_k of the roots of g,
    /// s_k = −k g_(n−k) − Σ_{0 < i < k} g_(n−i) s_(k−i).
    #[inline(always)]
    fn traces(&self) -> Vec<Four> {
        let (field, n) = (self.field, self.degree());
        let mut count = [0.0; 4];
        let mut traces = vec![count];
        for k in 1..n {
            count = count.map(|count| count + 1.0);
            let sum = field.sum_of_products((1..k).map(|i| (self.descending[i], traces[k - i])));
            traces.push(negated(field.reduced(multiplied(
                count,
                self.descending[k],
                sum,
            ))));
        }
        traces[0] = count.map(|count| count + 1.0);
        traces
    }

    /// The linear form a ↦ ℓ(h a), for a form ℓ that is given by its values at 1, z, …, z^(n−1), and an h that is given by its
    /// coefficients from the highest one down.
    ///
    /// The series of the values ℓ(z^k), multiplied by Σ g_(n−i) T^i, is a polynomial of degree below n. So if the first n values
    /// alone give the terms R T^n after that, the further values are those of −R T^n divided by this polynomial.
    #[inline(always)]
    fn form_after(&self, form: &[Four], reversed: &[Four]) -> Vec<Four> {
        let (field, n) = (self.field, self.degree());
        let rest = field.product(form, &self.descending, n..2 * n - 1);
        let more = field.product(&rest, &self.series, 0..n - 1);
        let mut wide = form.to_vec();
        wide.extend(more.into_iter().map(negated));
        field.product(reversed, &wide, n - 1..2 * n - 1)
    }
}

/// Interpolates: from the values at 0, 1, …, m of a polynomial of degree at most m to its coefficients.
pub(super) struct Interpolation<'a> {
    pub(super) pair: &'a Pair,
    pub(super) values: Vec<Four>,
}

impl NullaryFnOnce for Interpolation<'_> {
    type Output = Vec<Four>;

    #[inline(always)]
    fn call(self) -> Vec<Four> {
        let field = self.pair.field();
        let inverses = self.pair.inverses();
        let mut table = self.values;
        let len = table.len();
        // Divided differences; the distance of the k-th point from the one `step` before it is `step`.
        for (step, inverse) in inverses.iter().enumerate().take(len).skip(1) {
            let minus = negated(*inverse);
            for k in (step..len).rev() {
                let sum = multiplied(table[k], *inverse, [0.0; 4]);
                table[k] = field.reduced(multiplied(table[k - 1], minus, sum));
            }
        }
        // Horner's rule for Newton's form: the polynomial times (v − k), plus the next difference.
        let mut minus_node = [0.0; 4].map(|zero: f64| zero - f64_from(len as u64 - 1));
        let mut coefficients: Vec<Four> = Vec::with_capacity(len);
        for c in table.into_iter().rev() {
            coefficients.insert(0, c);
            for k in 0..coefficients.len() - 1 {
                let above = coefficients[k + 1];
                coefficients[k] = field.reduced(multiplied(minus_node, above, coefficients[k]));
            }
            minus_node = minus_node.map(|node| node + 1.0);
        }
        coefficients
    }
}
