//! Theorem 2 modulo many primes: the long parts of F from the values of the two sums at roots of unity.

use malachite::Integer;
use pulp::{Arch, NullaryFnOnce};

use crate::poly::{
    Bases, FlatPolynomial, FormSize, Lifting, Quad, Quartet, for_each_quartet, minus, plus,
};

/// The two sums over odd and over even harmonics, as coefficients in the basis z^j w^(d−j) that add up to less than
/// 2^`bits`.
#[derive(Clone, Copy)]
pub(super) struct ResidueExpansion<'a> {
    pub(super) harmonics: usize,
    pub(super) odd: &'a FlatPolynomial,
    pub(super) even: &'a FlatPolynomial,
    pub(super) bits: u64,
}

impl ResidueExpansion<'_> {
    /// The power of ρ that the odd sum is multiplied by.
    fn rho_power(&self) -> usize {
        self.harmonics / 2 + 1
    }

    /// `ρ^⌊N/2+1⌋ · odd` and the low part, f(1, t).
    ///
    /// Cost: for each prime, of 50 bits, that the largest coefficient needs, 13 transforms of the length of the parts; then
    /// for each coefficient the square of the number of primes that it needs.
    pub(super) fn middle_and_low(&self) -> [Vec<Integer>; 2] {
        let middle = FormSize {
            power: self.rho_power(),
            degree: self.odd.len() - 1,
            bits: self.bits,
        };
        let low = FormSize {
            power: 0,
            degree: 2 * self.harmonics,
            bits: 2 * self.bits + 1,
        };
        let quartets = Quartet::enough_for(low.largest());
        let lifting = Lifting::new(&quartets);
        let for_middle = lifting.quartets_for(middle.largest());
        let residues = for_each_quartet(&quartets, Workspace::default, |workspace, k, quartet| {
            Arch::new().dispatch(Parts {
                sums: self,
                workspace,
                quartet,
                has_middle: k < for_middle,
            })
        });
        let (in_middle, in_low): (Vec<_>, Vec<_>) = residues.into_iter().unzip();
        [(middle, in_middle), (low, in_low)].map(|(size, residues)| {
            lifting.integers(&residues, size.len(), |range| size.largest_of(range))
        })
    }
}

/// What is computed for four primes.
#[derive(Default)]
struct Workspace {
    bases: Bases,
    squared_points: Vec<Quad>,
    odd: Vec<Quad>,
    even: Vec<Quad>,
}

/// The residues of both parts modulo four primes; of the middle one only if they are wanted.
struct Parts<'a> {
    sums: &'a ResidueExpansion<'a>,
    workspace: &'a mut Workspace,
    quartet: &'a Quartet,
    has_middle: bool,
}

impl NullaryFnOnce for Parts<'_> {
    type Output = (Vec<Quad>, Vec<Quad>);

    #[inline(always)]
    fn call(self) -> Self::Output {
        let Self {
            sums,
            workspace,
            quartet,
            has_middle,
        } = self;
        let Workspace {
            bases,
            squared_points,
            odd,
            even,
        } = workspace;
        // Degrees are at most 2N + 1.
        bases.set(quartet, sums.harmonics, 2 * sums.harmonics + 2);
        bases.values_of_form(sums.odd, odd);
        bases.values_of_form(sums.even, even);
        bases.set_squared_points(squared_points);
        let field = bases.field();
        let rho_power = if has_middle { sums.rho_power() } else { 1 };
        // Values come in pairs at points t and −t.
        let pairs = odd.as_chunks_mut::<2>().0.iter_mut();
        let pairs = pairs.zip(even.as_chunks_mut::<2>().0);
        for ((odd, even), square) in pairs.zip(squared_points) {
            let rho = plus(*square, [1.0; 4]);
            let to_power = field.power(rho, rho_power as u64);
            for (odd, even) in odd.iter_mut().zip(even) {
                let (o, e) = (field.times(*odd, *odd), field.times(*even, *even));
                let low = if sums.harmonics.is_multiple_of(2) {
                    minus(field.times(o, rho), e)
                } else {
                    minus(o, field.times(e, rho))
                };
                *even = field.reduced(low);
                *odd = field.times(*odd, to_power);
            }
        }
        let middle = if has_middle {
            bases.coefficients(odd, sums.odd.len() + 2 * rho_power)
        } else {
            Vec::new()
        };
        (middle, bases.coefficients(even, 2 * sums.harmonics + 1))
    }
}
