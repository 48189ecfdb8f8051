//! Theorem 2 modulo many primes: the long parts of F from the values of the two sums at roots of unity.

use std::ops::Range;

use malachite::Integer;
use pulp::NullaryFnOnce;

use super::summed::SummedHarmonics;
use crate::bigint::{
    Bases, FlatPolynomial, FormSize, Lanes, Lifting, Machine, Quartet, Residues, Sizes,
    for_each_quartet, minus, plus, value_of_form, value_of_integers, value_of_rho,
};
use crate::error::broken;

/// `ρ^⌊N/2+1⌋ · odd` and the low part, as f(1, t). The odd sum must exist.
///
/// Cost: 13 transforms of the length of the parts for each prime of 50 bits that the largest coefficient needs; then, for each
/// coefficient, the square of the number of primes that it needs.
pub(super) fn middle_and_low_by_residues(
    sums: &SummedHarmonics,
    odd: &FlatPolynomial,
) -> [Vec<Integer>; 2] {
    let middle = FormSize {
        power: sums.rho_power(),
        degree: odd.len() - 1,
        bits: sums.bits,
    };
    let low = FormSize {
        power: 0,
        degree: 2 * sums.harmonics,
        bits: 2 * sums.bits + 1,
    };
    let quartets = Quartet::enough_for(low.largest());
    let machine = Machine::this();
    let lifting = Lifting::new(machine, &quartets);
    let sizes = [middle, low].map(|size| Sizes::new(size.len(), |range| size.largest_of(range)));
    let residues = for_each_quartet(&quartets, Workspace::default, |workspace, k, quartet| {
        let [middle, low] = sizes.each_ref().map(|sizes| lifting.asked(sizes, k));
        machine.dispatch_fused(Parts {
            sums,
            odd,
            workspace,
            quartet,
            middle,
            low,
        })
    });
    let (middle, low): (Vec<_>, Vec<_>) = residues.into_iter().unzip();
    let [for_middle, for_low] = sizes;
    let parts = [(for_middle, middle), (for_low, low)];
    let parts = parts.map(|(sizes, residues)| lifting.integers(&sizes, residues));
    check_values(sums, odd, &parts);
    parts
}

/// A check: stops the program if a part has a wrong value at one more point modulo one more prime.
fn check_values(sums: &SummedHarmonics, odd: &FlatPolynomial, [middle, low]: &[Vec<Integer>; 2]) {
    let (odd, even, rho) = (
        value_of_form(odd),
        value_of_form(&sums.even),
        value_of_rho(),
    );
    let squares = [odd, even].map(|value| value.times(value));
    let expected = if sums.harmonics.is_multiple_of(2) {
        squares[0].times(rho).minus(squares[1])
    } else {
        squares[0].minus(squares[1].times(rho))
    };
    let of_middle = odd.times(rho.power(sums.rho_power() as u64));
    if value_of_integers(middle) != of_middle || value_of_integers(low) != expected {
        broken("the parts of Theorem 2 have their values modulo one more prime");
    }
}

/// The working memory for the computation modulo four primes.
#[derive(Default)]
struct Workspace {
    bases: Bases,
    /// ρ = 1 + t² for one of each pair t and −t, and its powers.
    rho: Vec<Lanes>,
    rho_powers: Vec<Lanes>,
    odd: Vec<Lanes>,
    even: Vec<Lanes>,
}

/// The residues modulo four primes that are wanted of both parts; those of the middle part may be none.
struct Parts<'a> {
    sums: &'a SummedHarmonics,
    odd: &'a FlatPolynomial,
    workspace: &'a mut Workspace,
    quartet: &'a Quartet,
    middle: Range<usize>,
    low: Range<usize>,
}

impl NullaryFnOnce for Parts<'_> {
    type Output = (Residues, Residues);

    #[inline(always)]
    fn call(self) -> Self::Output {
        let Self {
            sums,
            odd: odd_sum,
            workspace,
            quartet,
            middle,
            low,
        } = self;
        let Workspace {
            bases,
            rho,
            rho_powers,
            odd,
            even,
        } = workspace;
        // The degrees are at most 2N + 1.
        bases.set(quartet, sums.harmonics, 2 * sums.harmonics + 2);
        bases.values_of_form(odd_sum, odd);
        bases.values_of_form(&sums.even, even);
        bases.set_squared_points(rho);
        let field = bases.field();
        for rho in &mut *rho {
            *rho = field.reduced(plus(*rho, [1.0; 4]));
        }
        let rho_power = if middle.is_empty() {
            1
        } else {
            sums.rho_power()
        };
        rho_powers.clone_from(rho);
        field.raise(rho_powers, rho_power as u64);
        // The values are in pairs, at the points t and −t.
        let pairs = odd.as_chunks_mut::<2>().0.iter_mut();
        let pairs = pairs.zip(even.as_chunks_mut::<2>().0);
        for (((odd, even), rho), rho_power) in pairs.zip(rho).zip(rho_powers) {
            for (odd, even) in odd.iter_mut().zip(even) {
                let (o, e) = (field.times(*odd, *odd), field.times(*even, *even));
                let low = if sums.harmonics.is_multiple_of(2) {
                    minus(field.times(o, *rho), e)
                } else {
                    minus(o, field.times(e, *rho))
                };
                *even = field.reduced(low);
                *odd = field.times(*odd, *rho_power);
            }
        }
        let in_middle = if middle.is_empty() {
            Residues::default()
        } else {
            bases.coefficients(odd, middle)
        };
        (in_middle, bases.coefficients(even, low))
    }
}
