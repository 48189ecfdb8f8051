//! Theorem 2 in large integers: the homogeneous parts of F in lowest terms, from the sums over the odd and over the even
//! harmonics.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{
    DivExactAssign, Gcd, NegAssign, Square, UnsignedAbs,
};
use malachite::base::num::basic::traits::Zero;
use rayon::prelude::*;

use super::residue_expansion::middle_and_low_by_residues;
use super::summed::SummedHarmonics;
use crate::bigint::{FlatPolynomial, Machine, Target, binomials, form_bits};
use crate::error::Invariant;
use crate::poly::{BinaryForm, from_harmonic_basis};

/// The three parts that [`square_away`](super::square_away) gives for the sums, divided by the common factor of all their
/// coefficients. The sums are `unit` times those of the radius, and the parts are `unit² ρ^(N+1)`, `−2 unit ρ^⌊N/2+1⌋ odd`, and
/// `± (ρ·odd² − even²)` or `± (odd² − ρ·even²)`.
///
/// Cost: two changes of basis and two squares of forms of degree N, and two products of half that length (ρ is a polynomial in
/// t²), in large integers or modulo primes.
pub(super) fn primitive_parts(sums: &SummedHarmonics, unit: &Integer) -> Vec<BinaryForm> {
    let (middle, low) = middle_and_low(sums);
    // unit = 2^power · factor, with an odd factor that is 1 for dyadic radii
    let power = unit.trailing_zeros().invariant("a unit is not 0");
    let factor = unit >> power;
    let in_middle = middle.as_ref().and_then(Part::trailing_zeros);
    let in_parts = [
        Some(2 * power),
        in_middle.map(|zeros| zeros + power + 1),
        low.trailing_zeros(),
    ];
    let common = in_parts.into_iter().flatten().min();
    let common = common.invariant("the part of the unit is there");
    let by = |shift: u64| shift.cast_signed() - common.cast_signed();

    let square = (&factor).square();
    let mut parts = vec![top_part(sums.harmonics, &(&square << by(2 * power)))];
    parts.extend(middle.map(|middle| {
        let mut coefficients = middle.into_integers(by(power + 1));
        for c in &mut coefficients {
            if factor != 1 {
                *c *= &factor;
            }
            c.neg_assign();
        }
        coefficients
    }));
    parts.push(low.into_integers(by(0)));
    divide_by_common_factor(square, &mut parts);
    let parts = parts.into_iter().map(BinaryForm::from_coefficients);
    parts.collect()
}

/// Whether residues modulo primes are faster than products of large integers. On one thread they take 0.9 of the time at 100
/// harmonics of 60 bits, 0.7 at 200, 0.45 at 1000 and less at 10 000. Their cost is quadratic in the bits of a coefficient, so
/// at 1000 harmonics of 5000 bits the two methods tie.
fn residues_are_faster(sums: &SummedHarmonics) -> bool {
    let harmonics = sums.harmonics;
    Machine::this().has_fused_products()
        && (75..100_000).contains(&harmonics)
        && sums.bits / 6 <= harmonics as u64 - 75
}

/// The computed coefficients of a part, before they are integers in lowest terms.
enum Part {
    Flat(FlatPolynomial),
    Integers(Vec<Integer>),
}

impl Part {
    /// The number of low bits that are 0 in all coefficients; `None` if all coefficients are 0.
    fn trailing_zeros(&self) -> Option<u64> {
        match self {
            Self::Flat(part) => part.trailing_zeros(),
            Self::Integers(part) => part.iter().filter_map(Integer::trailing_zeros).min(),
        }
    }

    /// The coefficients times 2^`shift`, which are integers.
    fn into_integers(self, shift: i64) -> Vec<Integer> {
        /// Below this number of coefficients one thread is faster.
        const FEW: usize = 1000;
        match self {
            Self::Flat(part) => part.to_integers(shift).collect(),
            Self::Integers(mut part) => {
                if shift != 0 && part.len() < FEW {
                    part.iter_mut().for_each(|c| *c <<= shift);
                } else if shift != 0 {
                    part.par_iter_mut().for_each(|c| *c <<= shift);
                }
                part
            }
        }
    }
}

/// `ρ^⌊N/2+1⌋ · odd` and the low part.
fn middle_and_low(sums: &SummedHarmonics) -> (Option<Part>, Part) {
    match &sums.odd {
        Some(odd) if residues_are_faster(sums) => {
            let [middle, low] = middle_and_low_by_residues(sums, odd);
            (Some(Part::Integers(middle)), Part::Integers(low))
        }
        _ => {
            let (middle, low) = by_large_integers(sums);
            (middle.map(Part::Flat), Part::Flat(low))
        }
    }
}

fn by_large_integers(sums: &SummedHarmonics) -> (Option<FlatPolynomial>, FlatPolynomial) {
    let odd = sums
        .odd
        .as_ref()
        .map(|odd| from_harmonic_basis(odd, sums.bits));
    let even = from_harmonic_basis(&sums.even, sums.bits);
    let middle = odd.as_ref().map(|odd| middle_part(odd, sums));
    (middle, low_part(odd.as_ref(), &even, sums))
}

/// `factor · ρ^(N+1)`.
fn top_part(harmonics: usize, factor: &Integer) -> Vec<Integer> {
    let mut coefficients = vec![Integer::ZERO; 2 * harmonics + 3];
    for (k, binomial) in binomials(harmonics + 1).into_iter().enumerate() {
        coefficients[2 * k] = binomial * factor;
    }
    coefficients
}

/// The largest power of ρ, for numbers of `bits` bits, by which repeated additions multiply faster than two products do.
/// Additions took 7 µs and products 30 µs at the 51st power, and 43 and 103 µs at the 101st, where the additions are compiled
/// for the width; otherwise 124 and 115 µs at the 111th.
fn additions_up_to(bits: u64) -> usize {
    if FlatPolynomial::is_compiled_for(bits) {
        190
    } else {
        100
    }
}

/// `ρ^⌊N/2+1⌋ · odd`, of the form f(1, t).
fn middle_part(odd: &FlatPolynomial, sums: &SummedHarmonics) -> FlatPolynomial {
    let power = sums.rho_power();
    // A coefficient is at most the sum over C(power, k) times the largest C(degree, j).
    let room = form_bits(odd.len() - 1, sums.bits) + power as u64;
    if power <= additions_up_to(room) {
        by_additions(odd, power, room)
    } else {
        by_products(odd, power, room)
    }
}

fn by_additions(odd: &FlatPolynomial, power: usize, room: u64) -> FlatPolynomial {
    let mut middle = odd.part(0, 1, odd.len() + 2 * power, room);
    middle.multiply_by_rho(power);
    middle
}

fn by_products(odd: &FlatPolynomial, power: usize, room: u64) -> FlatPolynomial {
    let rho = FlatPolynomial::from_integers(binomials(power).iter(), power as u64);
    let mut middle = FlatPolynomial::zero(odd.len() + 2 * power, room);
    for (half, at) in odd.halves(room).iter().zip(0..) {
        middle.add_product(half, &rho, room, &[Target::of_sum(at, 2)]);
    }
    middle
}

/// The low part of two sums a and b, of degrees N and N − 1. It is `a² − ρ b²` for odd N, and the negative of that for even N.
fn low_part(
    odd: Option<&FlatPolynomial>,
    even: &FlatPolynomial,
    sums: &SummedHarmonics,
) -> FlatPolynomial {
    let harmonics = sums.harmonics;
    // a² and ρ b² are forms of degree 2N; in the other basis the absolute values of their coefficients add up to at most the
    // square of the sum for a or b.
    let room = form_bits(2 * harmonics, 2 * sums.bits);
    let mut low = FlatPolynomial::zero(2 * harmonics + 1, room + 1);
    let (plus, minus) = (Target::of_sum, Target::of_difference);
    let squares = match odd {
        Some(odd) if !harmonics.is_multiple_of(2) => [
            (Some(odd), vec![plus(0, 1)]),
            (Some(even), vec![minus(0, 1), minus(2, 1)]),
        ],
        odd => [
            (Some(even), vec![minus(0, 1)]),
            (odd, vec![plus(0, 1), plus(2, 1)]),
        ],
    };
    for (sum, places) in squares {
        if let Some(sum) = sum {
            low.add_square(sum, room, &places);
        }
    }
    low
}

/// Divides the coefficients by the gcd of `factor` and all of them.
fn divide_by_common_factor(factor: Integer, parts: &mut [Vec<Integer>]) {
    let mut common = factor.unsigned_abs();
    // The coefficients of the low part are first, because they soon have a small common factor.
    for c in parts.iter().rev().flatten() {
        if common == 1 {
            return;
        }
        common = common.gcd(c.unsigned_abs_ref());
    }
    let common = Integer::from(common);
    if common != 1 {
        for c in parts.iter_mut().flatten() {
            c.div_exact_assign(&common);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bigint::bounded_integer;
    use crate::poly::IntegerPolynomial;
    use malachite::base::polynomial::Polynomial;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        /// Residues and large integers give the same parts, also for sums that make the coefficients as large as possible.
        #[test]
        fn by_residues_and_by_large_integers(
            harmonics in prop_oneof![1usize..12, 1usize..150, 340usize..380, Just(512)],
            size in prop_oneof![0u64..4, 40u64..80, 1u64..700],
            seed in prop::collection::vec(any::<i64>(), 1..300),
            extreme in any::<bool>(),
        ) {
            let coefficient = |k: usize| bounded_integer(seed[k % seed.len()], size, extreme);
            let bits = size + u64::from((harmonics + 1).ilog2()) + 1;
            let sum = |degree: usize, from: usize| {
                let coefficients: Vec<Integer> = (from..=from + degree).map(coefficient).collect();
                FlatPolynomial::from_integers(coefficients.iter(), bits)
            };
            let degree = |parity: usize| if harmonics % 2 == parity { harmonics } else { harmonics - 1 };
            let (odd, even) = (sum(degree(1), 0), sum(degree(0), 1000));
            let sums = SummedHarmonics { harmonics, odd: Some(odd.clone()), even, bits };
            let [middle, low] = middle_and_low_by_residues(&sums, &odd).map(IntegerPolynomial::from_coefficients_asc);
            let (middle_twin, low_twin) = by_large_integers(&sums);
            prop_assert_eq!(middle, middle_twin.map(|part| part.to_polynomial()).unwrap_or_default());
            prop_assert_eq!(low, low_twin.to_polynomial());
        }
    }

    proptest! {
        /// Additions give the same products for widths that are compiled and for others.
        #[test]
        fn powers_of_rho_by_additions_and_by_products(
            odd in prop::collection::vec(any::<i128>(), 1..60),
            power in 1usize..60,
            shift in prop_oneof![Just(0_u64), Just(900)],
        ) {
            let odd: Vec<Integer> = odd.into_iter().map(|c| Integer::from(c) << shift).collect();
            let bits = 128 + shift;
            let odd = FlatPolynomial::from_integers(odd.iter(), bits);
            let room = bits + power as u64 + 6;
            prop_assert_eq!(by_additions(&odd, power, room), by_products(&odd, power, room));
        }
    }
}
