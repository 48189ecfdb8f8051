//! The change of basis `Σ g_j (1+T)^j (1−T)^(d−j)` modulo four primes, by two Taylor shifts, each of which is a product with Σ
//! x^t/t!.

use std::ops::Range;

use pulp::NullaryFnOnce;

use super::lanes::{LaneFields, Lanes, negated};
use super::lifting::{Lifting, Residues, Sizes};
use super::one_more_prime::{value_after_change, value_of_flat};
use super::quartet::{Quartet, for_each_quartet};
use super::transform::{Transform, transform_len};
use crate::bigint::{FlatPolynomial, FormSize, Machine};
use crate::error::broken;

/// The common data of all changes of basis of degree at most D.
#[derive(Debug, Default)]
pub(crate) struct Bases {
    field: LaneFields,
    transform: Transform,
    /// The numbers k!, 1/k! and (−2)^k / k! for k ≤ D, of at most (1/2 + 2^-20) p.
    factorials: Vec<Lanes>,
    inverse_factorials: Vec<Lanes>,
    powers: Vec<Lanes>,
    /// The values of `Σ x^t/t!`, scaled for the backward transform, of at most p/2.
    exponential: Vec<Lanes>,
    /// The scale of the transform.
    scale: Lanes,
}

impl Bases {
    /// Sets up the data for these primes, up to degree D, with transforms of at least `len` > 2D numbers.
    #[inline(always)]
    pub(crate) fn set(&mut self, quartet: &Quartet, degree: usize, len: usize) {
        let len = transform_len(len);
        let field = quartet.field;
        self.field = field;
        quartet.set_transform(&mut self.transform, len);
        self.set_factorials(degree);
        self.scale = self.transform.scale();
        let by = field.factor(self.scale);
        self.exponential.resize(len, [0.0; 4]);
        let (values, zeros) = self.exponential.split_at_mut(degree + 1);
        values.copy_from_slice(&self.inverse_factorials);
        zeros.fill([0.0; 4]);
        self.transform.forward(&mut self.exponential);
        for value in &mut self.exponential {
            *value = field.reduced(field.times_factor(*value, by));
        }
    }

    /// Lemma 1. The product of a residue of at most p and a number k < 2^29 is at most (1/2 + 2^-20) p.
    /// Proof. This is Lemma 2 of lanes.rs with A = 1 and B < 2^29/2^49.99 < 2^-20. No transform has more than 2^29 numbers.
    /// Law: `the_change_of_basis_is_two_taylor_shifts` of mobius.rs.
    #[inline(always)]
    fn set_factorials(&mut self, degree: usize) {
        let field = self.field;
        for numbers in [
            &mut self.factorials,
            &mut self.inverse_factorials,
            &mut self.powers,
        ] {
            numbers.resize(degree + 1, [1.0; 4]);
        }
        let (mut last, mut k, mut power) = ([1.0; 4], 0.0, [1.0; 4]);
        for (factorial, to) in self.factorials.iter_mut().zip(&mut self.powers) {
            (*factorial, *to) = (last, power);
            k += 1.0;
            last = field.times(last, [k; 4]);
            power = field.times(power, [-2.0; 4]);
        }
        last = field.reduced(field.inverse_of(last));
        let inverses = self.inverse_factorials.iter_mut().rev();
        for (inverse, power) in inverses.zip(self.powers.iter_mut().rev()) {
            last = field.times(last, [k; 4]);
            k -= 1.0;
            *inverse = last;
            *power = field.reduced(field.times(*power, last));
        }
    }

    /// The coefficients of h(T), of at most p, followed by zeros.
    ///
    /// With c(x) = g(x − 1), `k! c_k = Σ_j j! g_j (−1)^(j−k) / (j−k)!`, and `h = Σ_k 2^k c_k (1−T)^(d−k)`. The second sum has
    /// the same shape: with m = d − k, `i! (−1)^i h_i = Σ_m m! 2^k c_k / (m−i)!`.
    #[inline(always)]
    pub(crate) fn change(&self, g: &FlatPolynomial, values: &mut Vec<Lanes>) {
        let Self {
            field,
            factorials,
            inverse_factorials,
            powers,
            ..
        } = self;
        let degree = g.len() - 1;
        values.resize(self.transform.len(), [0.0; 4]);
        values[degree + 1..].fill([0.0; 4]);
        for (j, limbs) in g.coefficients().enumerate() {
            let value = field.times(field.residue(limbs), factorials[j]);
            values[degree - j] = if j.is_multiple_of(2) {
                value
            } else {
                negated(value)
            };
        }
        self.times_exponential(values);
        // The number (−1)^k k! c_k is at the index d − k.
        values[..=degree].reverse();
        values[degree + 1..].fill([0.0; 4]);
        let factors = factorials[..=degree].iter().rev().zip(powers);
        for (target, (factorial, power)) in values.iter_mut().zip(factors) {
            *target = field.times(*target, field.times(*factorial, *power));
        }
        self.times_exponential(values);
        values[..=degree].reverse();
        values[degree + 1..].fill([0.0; 4]);
        for (i, target) in values[..=degree].iter_mut().enumerate() {
            let value = field.times(*target, inverse_factorials[i]);
            *target = if i.is_multiple_of(2) {
                value
            } else {
                negated(value)
            };
        }
    }

    /// The values, of at most p/2, of the form f(1, t) = h(it) at the points of the transform. The factors i^k have the signs +
    /// + − −.
    #[inline(always)]
    pub(crate) fn values_of_form(&self, g: &FlatPolynomial, values: &mut Vec<Lanes>) {
        self.change(g, values);
        for (k, value) in values.iter_mut().enumerate() {
            if k % 4 >= 2 {
                *value = negated(*value);
            }
        }
        self.transform.forward(values);
        for value in values {
            *value = self.field.reduced(*value);
        }
    }

    /// Some of the coefficients, of at most p, from values of at most 2p at the points of the transform.
    #[inline(always)]
    pub(crate) fn coefficients(&self, values: &mut [Lanes], range: Range<usize>) -> Residues {
        self.transform.backward(values);
        let by = self.field.factor(self.scale);
        let start = range.start;
        let mut coefficients = Vec::with_capacity(range.len());
        for value in &values[range] {
            coefficients.push(self.field.times_factor(*value, by));
        }
        Residues {
            start,
            values: coefficients,
        }
    }

    /// The squares of the points, one for each pair of values.
    #[inline(always)]
    pub(crate) fn set_squared_points(&self, points: &mut Vec<Lanes>) {
        self.transform.set_squared_points(points);
    }

    #[inline(always)]
    pub(crate) fn field(&self) -> LaneFields {
        self.field
    }

    /// Multiplies by `Σ x^t/t!` modulo x^len − 1, in place. The numbers are at most 2p before and after.
    #[inline(always)]
    fn times_exponential(&self, values: &mut [Lanes]) {
        self.transform.forward(values);
        for (value, by) in values.iter_mut().zip(&self.exponential) {
            *value = self.field.times(*value, *by);
        }
        self.transform.backward(values);
    }
}

/// The change of basis of integers. It is checked at one more point modulo one more prime. The result has room for integers
/// below 2^[`form_bits`](crate::bigint::form_bits), if Σ |g_j| < 2^`bits`.
///
/// Cost: five transforms of twice the length for each prime that the largest coefficient needs; then, for each coefficient, the
/// square of the number of primes that it needs.
pub(crate) fn changed_by_residues(
    machine: Machine,
    g: &FlatPolynomial,
    bits: u64,
) -> FlatPolynomial {
    let size = FormSize {
        power: 0,
        degree: g.len() - 1,
        bits,
    };
    let quartets = Quartet::enough_for(size.largest());
    let lifting = Lifting::new(machine, &quartets);
    let sizes = Sizes::new(g.len(), |range| size.largest_of(range));
    let residues = for_each_quartet(&quartets, Default::default, |workspace, k, quartet| {
        let change = Change {
            workspace,
            quartet,
            g,
            asked: lifting.asked(&sizes, k),
        };
        machine.dispatch_fused(change)
    });
    let changed = lifting.polynomial(&sizes, &residues);
    if value_of_flat(&changed) != value_after_change(g) {
        broken("a change of basis has its value modulo one more prime");
    }
    changed
}

struct Change<'a> {
    workspace: &'a mut (Bases, Vec<Lanes>),
    quartet: &'a Quartet,
    g: &'a FlatPolynomial,
    asked: Range<usize>,
}

impl NullaryFnOnce for Change<'_> {
    type Output = Residues;

    #[inline(always)]
    fn call(self) -> Residues {
        let (bases, values) = self.workspace;
        let len = self.g.len();
        bases.set(self.quartet, len - 1, 2 * len);
        bases.change(self.g, values);
        Residues {
            start: self.asked.start,
            values: values[self.asked].to_vec(),
        }
    }
}
