//! Rows of Pascal's triangle.

use malachite::base::num::arithmetic::traits::DivExactAssign;
use malachite::base::num::basic::traits::One;
use malachite::{Integer, Natural};

/// The longest row whose numbers fit in words: C(61, 30)·31 is below 2^64.
const LONGEST_OF_WORDS: usize = 61;

/// The row `[C(n, 0), …, C(n, n)]`. Cost: one product by a word and one division by a word for each of n/2 numbers of up to n
/// bits.
pub(crate) fn binomials(n: usize) -> Vec<Integer> {
    let mut row = Vec::with_capacity(n + 1);
    if n <= LONGEST_OF_WORDS {
        let mut binomial = 1;
        for k in 0..=n / 2 {
            row.push(Integer::from(binomial));
            binomial = binomial * (n - k) as u64 / (k + 1) as u64;
        }
    } else {
        let mut binomial = Natural::ONE;
        for k in 0..=n / 2 {
            row.push(Integer::from(&binomial));
            binomial *= Natural::from(n - k);
            binomial.div_exact_assign(Natural::from(k + 1));
        }
    }
    // C(n, k) = C(n, n − k).
    for k in (0..n.div_ceil(2)).rev() {
        row.push(row[k].clone());
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::shift_classical;
    use malachite::base::num::basic::traits::Zero;

    #[test]
    fn a_row_is_x_to_the_n_at_x_plus_one() {
        for n in 0..200 {
            let mut power = vec![Integer::ZERO; n];
            power.push(Integer::ONE);
            shift_classical(&mut power);
            assert_eq!(binomials(n), power);
        }
    }
}
