//! The sign of a polynomial on a cube, as far as its coefficients show it (theorem T6).

use num_bigint::BigInt;

use super::numbers::{Exact, sign};

/// The exponents of up to three variables.
pub(super) type CubeExponents = [usize; 3];

/// The sign of the polynomial on the cube [−1, 1]^n, 1 or −1; 0 if the rule of the page does not decide it.
///
/// With s the sign of the constant coefficient, s·f ≥ |constant| + Σ (m_j v_j² − l_j |v_j|): l_j is the absolute value of the
/// coefficient of v_j, and m_j is s times that of v_j², less the shares of all other terms. A term in one variable counts in full
/// there, and a term in more of them by half in each of the first two, since |v_i v_j| ≤ (v_i² + v_j²)/2.
pub(super) fn sign_on_cube<'a>(
    terms: impl Iterator<Item = (CubeExponents, &'a BigInt)> + Clone,
) -> i64 {
    let constant = terms.clone().find(|(e, _)| *e == [0; 3]);
    let Some((_, constant)) = constant.filter(|(_, c)| sign(c) != 0) else {
        return 0;
    };
    let positive = sign(constant) > 0;
    let mut slopes: [BigInt; 3] = Default::default();
    // The numbers 2·m_j.
    let mut bends: [BigInt; 3] = Default::default();
    for (exponents, c) in terms.filter(|(_, c)| sign(c) != 0) {
        let mut axes = (0..3).filter(|axis| exponents[*axis] > 0);
        let total: usize = exponents.iter().sum();
        let magnitude = BigInt::from(c.magnitude().clone());
        match (axes.next(), axes.next()) {
            (None, _) => {}
            (Some(axis), None) if total == 1 => slopes[axis] = magnitude,
            (Some(axis), None) if total == 2 && (sign(c) > 0) == positive => {
                bends[axis] += magnitude * 2;
            }
            (Some(axis), None) => bends[axis] -= magnitude * 2,
            (Some(first), Some(second)) => {
                bends[first] -= &magnitude;
                bends[second] -= magnitude;
            }
        }
    }
    let lost = slopes.iter().zip(&bends).fold(Exact::zero(), |sum, pair| {
        // The largest value of l |v| − m v² for |v| ≤ 1.
        let (slope, bend) = pair;
        let lost = if slope < bend {
            Exact::fraction(slope * slope, bend * 2)
        } else {
            Exact::fraction(slope * 2 - bend, BigInt::from(2))
        };
        &sum + &lost
    });
    let least = &Exact::integer(BigInt::from(constant.magnitude().clone())) - &lost;
    match (least.sign() > 0, positive) {
        (false, _) => 0,
        (true, true) => 1,
        (true, false) => -1,
    }
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;

    use super::sign_on_cube;

    /// The sign of the polynomial with these terms.
    fn found(terms: &[([usize; 3], i64)]) -> i64 {
        let terms: Vec<_> = terms.iter().map(|(e, c)| (*e, BigInt::from(*c))).collect();
        sign_on_cube(terms.iter().map(|(e, c)| (*e, c)))
    }

    #[test]
    fn a_bowl_above_zero_is_seen_and_one_that_touches_zero_is_not() {
        // 4x² − 4x + c has the minimum c − 1 at x = 1/2.
        assert_eq!(
            found(&[([2, 0, 0], 400), ([1, 0, 0], -400), ([0; 3], 101)]),
            1
        );
        assert_eq!(
            found(&[([2, 0, 0], 400), ([1, 0, 0], -400), ([0; 3], 100)]),
            0
        );
        assert_eq!(
            found(&[([2, 0, 0], -400), ([1, 0, 0], 400), ([0; 3], -101)]),
            -1
        );
        // A bowl in two variables with a mixed term of half the size.
        let bowl = |c| {
            found(&[
                ([2, 0, 0], 9),
                ([0, 2, 0], 9),
                ([1, 1, 0], 2),
                ([0, 1, 0], 8),
                ([0; 3], c),
            ])
        };
        assert_eq!((bowl(3), bowl(2)), (1, 0));
    }

    #[test]
    fn terms_of_higher_degree_count_in_full() {
        assert_eq!(found(&[([0; 3], 6), ([1, 2, 3], 3), ([0, 0, 3], -2)]), 1);
        assert_eq!(found(&[([0; 3], 5), ([1, 2, 3], 3), ([0, 0, 3], -2)]), 0);
        assert_eq!(found(&[([0; 3], 5), ([0, 0, 2], -5)]), 0);
        assert_eq!(found(&[([0; 3], 5), ([0, 0, 2], -4)]), 1);
        assert_eq!(found(&[([1, 0, 0], 1)]), 0);
    }
}
