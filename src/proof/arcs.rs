//! Arcs of a curve, halved as often as a cover needs it. Many points share the arcs of one curve.

use std::cell::OnceCell;

use num_bigint::BigInt;

use super::bernstein::on_unit_interval;
use super::numbers::Exact;
use super::one_sign::sign_on_cube;
use super::univariate::{Coefficients, add_multiple, shift_by_one, shrink, substitute};

/// The halves of arcs of higher levels are not kept.
const KEPT_LEVELS: u32 = 8;

/// Four polynomials of equal formal degree on an arc, that is, for a parameter from 0 to 1.
#[derive(Debug)]
pub(super) struct Arc {
    level: u32,
    polynomials: [Coefficients; 4],
    /// The coefficients of the four polynomials on the arc, of equal index together.
    on_arc: Vec<[BigInt; 4]>,
    halves: OnceCell<Box<[Arc; 2]>>,
}

impl Arc {
    pub(super) fn new(polynomials: [Coefficients; 4], level: u32) -> Self {
        let [mut a, mut b, mut c, mut d] = polynomials.clone();
        for list in [&mut a, &mut b, &mut c, &mut d] {
            on_unit_interval(list);
        }
        let on_arc = a
            .into_iter()
            .zip(b)
            .zip(c)
            .zip(d)
            .map(|(((a, b), c), d)| [a, b, c, d])
            .collect();
        Self {
            level,
            polynomials,
            on_arc,
            halves: OnceCell::new(),
        }
    }

    /// The number of halvings that led to this arc.
    pub(super) fn level(&self) -> u32 {
        self.level
    }

    /// The coefficients on the arc of the sum of the four polynomials with these weights (T1).
    pub(super) fn combination(&self, weights: &[BigInt]) -> Coefficients {
        let sum = |values: &[BigInt; 4]| values.iter().zip(weights).map(|(v, w)| v * w).sum();
        self.on_arc.iter().map(sum).collect()
    }

    /// The sign on the closed arc of the sum of the four polynomials with these weights; 0 if the coefficients about this parameter,
    /// from 0 to 1, do not show it (T6).
    pub(super) fn sign_about(&self, at: &Exact, weights: &[BigInt]) -> i64 {
        let mut sum = Coefficients::new();
        for (polynomial, weight) in self.polynomials.iter().zip(weights) {
            add_multiple(&mut sum, weight, polynomial);
        }
        // The arc is within the parameters at + v for v from −1 to 1.
        substitute(&mut sum, at, &Exact::one());
        sign_on_cube(sum.iter().enumerate().map(|(k, c)| ([k, 0, 0], c)))
    }

    /// Calls the function for the two halves, with those of the parameters that are in them.
    pub(super) fn try_halves<E>(
        &self,
        parameters: &[Exact],
        mut visit: impl FnMut(&Self, &[Exact]) -> Result<(), E>,
    ) -> Result<(), E> {
        let fresh;
        let halves = if self.level < KEPT_LEVELS {
            self.halves.get_or_init(|| Box::new(self.halved()))
        } else {
            fresh = self.halved();
            &fresh
        };
        let two = Exact::integer(2);
        for (half, start) in halves.iter().zip([Exact::zero(), Exact::one()]) {
            let moved = parameters.iter().map(|t| &(t * &two) - &start);
            let inside: Vec<_> = moved.filter(Exact::is_in_unit_interval).collect();
            visit(half, &inside)?;
        }
        Ok(())
    }

    /// The arcs with the parameters t/2 and (1 + t)/2, times a power of 2.
    fn halved(&self) -> [Self; 2] {
        let two = BigInt::from(2);
        let mut first = self.polynomials.clone();
        for list in &mut first {
            shrink(list, &two);
        }
        let mut second = first.clone();
        for list in &mut second {
            shift_by_one(list);
        }
        [
            Self::new(first, self.level + 1),
            Self::new(second, self.level + 1),
        ]
    }
}
