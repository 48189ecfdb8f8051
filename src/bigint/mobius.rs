//! The change of basis `Σ g_j (1+T)^j (1−T)^(d−j)`, from harmonics to powers.

use malachite::Integer;

use super::Machine;
use super::binomials::binomials;
use super::flat::{FlatPolynomial, OnNumbers};
use super::form_size::form_bits;
use super::limbs::{add, negate, shift_left, width_for};
use super::residues::changed_by_residues;

/// The largest number of coefficients of `bits` bits for which the n² additions of [`ByShifts`] are faster than two products of
/// halves. Additions took 24 µs and products 66 µs at n = 150, 134 and 177 µs at 300, where the additions are compiled for the
/// width; otherwise both took 164 µs at 250.
fn shifts_up_to(bits: u64) -> usize {
    if FlatPolynomial::is_compiled_for(bits) {
        400
    } else {
        200
    }
}

/// Computes `h(T) = Σ_j g_j (1+T)^j (1−T)^(d−j)` for d + 1 coefficients g with Σ |g_j| < 2^`bits`. The result has room for
/// integers below 2^[`form_bits`] at least.
///
/// Let g_low be the first k coefficients and g_high the other d + 1 − k. Then `h = (1−T)^(d+1−k) h_low + (1+T)^k h_high`. The
/// numbers of h_low and h_high are shorter by a bit for each degree less, so all levels together cost about twice the topmost
/// level, which is two products of polynomials of half the degree.
pub(crate) fn change_of_basis(g: &FlatPolynomial, bits: u64) -> FlatPolynomial {
    let machine = Machine::this();
    if residues_are_faster(machine, g.len(), bits) {
        changed_by_residues(machine, g, bits)
    } else {
        by_large_integers(g, bits)
    }
}

/// Whether residues modulo primes are faster than products of large integers. They take 0.5 of the time at 600 coefficients and
/// 0.3 at 1000. Their cost is quadratic in the bits, so at 1000 coefficients of 6000 bits the two methods tie.
fn residues_are_faster(machine: Machine, len: usize, bits: u64) -> bool {
    machine.has_fused_products() && (300..100_000).contains(&len) && bits / 6 <= len as u64
}

fn by_large_integers(g: &FlatPolynomial, bits: u64) -> FlatPolynomial {
    changed(g, 0, g.len(), bits, &mut Vec::new())
}

/// The polynomials `(1−T)^n` and `(1+T)^n` as large integers, for one width of the coefficients.
struct Powers {
    exponent: usize,
    width: usize,
    minus: Integer,
    plus: Integer,
}

impl Powers {
    fn new(exponent: usize, width: usize) -> Self {
        let row = binomials(exponent);
        let mut row = FlatPolynomial::from_integers(row.iter(), exponent as u64 + 1);
        let plus = row.packed(width);
        row.coefficients_mut().skip(1).step_by(2).for_each(negate);
        let minus = row.packed(width);
        Self {
            exponent,
            width,
            minus,
            plus,
        }
    }
}

/// The index of an entry for this exponent. The halves of one level differ by at most one in length, so two entries are enough
/// for each level.
fn powers(levels: &mut Vec<Powers>, exponent: usize, width: usize) -> usize {
    let known = |p: &Powers| p.exponent == exponent && p.width == width;
    levels.iter().position(known).unwrap_or_else(|| {
        levels.push(Powers::new(exponent, width));
        levels.len() - 1
    })
}

/// The change of basis of the `len` coefficients of g from `start` on, by halves until shifts are faster.
fn changed(
    g: &FlatPolynomial,
    start: usize,
    len: usize,
    bits: u64,
    levels: &mut Vec<Powers>,
) -> FlatPolynomial {
    let room = form_bits(len - 1, bits);
    if len <= shifts_up_to(room) {
        let mut h = g.part(start, 1, len, room);
        h.run(ByShifts);
        return h;
    }
    let (low_len, width) = (len / 2, width_for(room));
    let high_len = len - low_len;
    let low = changed(g, start, low_len, bits, levels).packed(width);
    let high = changed(g, start + low_len, high_len, bits, levels).packed(width);
    let (minus, plus) = (
        powers(levels, high_len, width),
        powers(levels, low_len, width),
    );
    let value = low * &levels[minus].minus + high * &levels[plus].plus;
    FlatPolynomial::unpacked(value, len, width)
}

/// The change of basis in place, by two Taylor shifts with n² additions. Intermediate results may exceed the width; the final
/// ones fit again.
///
/// Lemma. With e(x) = g(x + 1), `T^d h(1/T) = Σ_k 2^k e_k (T−1)^(d−k)`.
/// Proof. The left side is (T−1)^d g((T+1)/(T−1)), and (T+1)/(T−1) = 1 + 2/(T−1).
/// Law: `the_change_of_basis_is_two_taylor_shifts`.
///
/// So the first shift gives e, and the second one, by −1, is that of a polynomial whose coefficient of T^(d−k) is 2^k e_k. A shift
/// by −1 is a shift by 1 with the signs (−1)^k before and after it.
struct ByShifts;

impl OnNumbers for ByShifts {
    fn run<C: AsRef<[u64]> + AsMut<[u64]>>(self, g: &mut [C]) {
        ShiftByOne.run(g);
        for (k, c) in g.iter_mut().enumerate() {
            shift_left(c.as_mut(), k as u64);
        }
        negate_odd(g);
        for end in 2..=g.len() {
            add_neighbours(g[..end].iter_mut().rev());
        }
        negate_odd(g);
    }
}

/// The Taylor shift f(x + 1) in place, with n²/2 additions.
pub(crate) struct ShiftByOne;

impl OnNumbers for ShiftByOne {
    fn run<C: AsRef<[u64]> + AsMut<[u64]>>(self, f: &mut [C]) {
        for start in (0..f.len().saturating_sub(1)).rev() {
            add_neighbours(f[start..].iter_mut());
        }
    }
}

fn negate_odd<C: AsMut<[u64]>>(g: &mut [C]) {
    for c in g.iter_mut().skip(1).step_by(2) {
        negate(c.as_mut());
    }
}

/// Adds to each number the next one.
#[inline]
fn add_neighbours<'a, C: AsRef<[u64]> + AsMut<[u64]> + 'a>(
    mut numbers: impl Iterator<Item = &'a mut C>,
) {
    let Some(mut current) = numbers.next() else {
        return;
    };
    for next in numbers {
        add(current.as_mut(), next.as_ref());
        current = next;
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::poly::{negate_odd, shift_by_one};
    use malachite::base::polynomial::Polynomial;
    use malachite::integer_polynomial::IntegerPolynomial;
    use proptest::prelude::*;

    /// An integer of absolute value below 2^size; the largest one if it is `extreme`.
    pub(crate) fn bounded_integer(seed: i64, size: u64, extreme: bool) -> Integer {
        let most = (Integer::from(1) << size) - Integer::from(1);
        if extreme {
            if seed < 0 { -most } else { most }
        } else {
            (Integer::from(seed) * most) >> 63u64
        }
    }

    /// The polynomial f(x − 1), as the reflection of a shift by 1.
    fn shift_by_minus_one(f: Vec<Integer>) -> Vec<Integer> {
        let reflected = |mut c: Vec<Integer>| {
            negate_odd(&mut c);
            IntegerPolynomial::from_coefficients_asc(c)
        };
        let shifted = shift_by_one(reflected(f)).into_coefficients_asc();
        reflected(shifted).into_coefficients_asc()
    }

    /// The slow twin: two Taylor shifts of integers of any size.
    fn by_taylor_shifts(g: Vec<Integer>) -> IntegerPolynomial {
        let len = g.len();
        let zero = Integer::from(0);
        let mut c = shift_by_minus_one(g);
        c.resize(len, zero);
        for (k, value) in c.iter_mut().enumerate() {
            *value <<= k as u64;
        }
        c.reverse();
        let h = shift_by_one(IntegerPolynomial::from_coefficients_asc(c));
        let mut h = h.into_coefficients_asc();
        negate_odd(&mut h);
        IntegerPolynomial::from_coefficients_asc(h)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        /// Lengths around every change of method, for every width that has compiled code and for larger ones; and signs that
        /// make all of h as large as possible.
        #[test]
        fn the_change_of_basis_is_two_taylor_shifts(
            len in prop_oneof![1usize..20, 198usize..203, 398usize..403, 798usize..803, 1usize..1200],
            size in prop_oneof![0u64..4, 50u64..70, 100u64..900],
            seed in prop::collection::vec(any::<i64>(), 1..500),
            extreme in any::<bool>(),
        ) {
            let coefficient = |k: usize| bounded_integer(seed[k % seed.len()], size, extreme);
            let g: Vec<Integer> = (0..len).map(coefficient).collect();
            let bits = size + u64::from(len.ilog2()) + 1;
            let flat = FlatPolynomial::from_integers(g.iter(), bits);
            let expected = by_taylor_shifts(g);
            prop_assert_eq!(by_large_integers(&flat, bits).to_polynomial(), expected.clone());
            prop_assert_eq!(changed_by_residues(Machine::this(), &flat, bits).to_polynomial(), expected.clone());
            // All other sets of instructions, if that does not take long.
            if len < 60 {
                for machine in Machine::all() {
                    prop_assert_eq!(changed_by_residues(machine, &flat, bits).to_polynomial(), expected.clone());
                }
            }
        }
    }
}
