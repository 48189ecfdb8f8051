//! Comparisons of rational angles with arctangents of rational numbers.

use num_bigint::BigInt;

use super::numbers::{Exact, powers};

/// The number of terms of the sine and cosine series together.
const TERMS: usize = 60;
/// For |α| < 2 the two sums are right to 2^60/60!, which is less than 2^−200.
const ERROR_BITS: u32 = 200;

/// Whether α ≤ atan t can be shown, for |α| < 2. If cos α > 0 it is the same as sin α ≤ t·cos α.
pub(super) fn is_below_arctangent(alpha: &Exact, t: &Exact) -> bool {
    let two = Exact::integer(2);
    if *alpha >= two || *alpha <= -&two {
        return false;
    }
    // With α = p/q, all terms α^k/k! have the denominator q^(TERMS − 1)·(TERMS − 1)!.
    let last = TERMS - 1;
    let above = powers(alpha.numerator(), last);
    let below = powers(alpha.denominator(), last);
    let (mut cosine, mut sine, mut falling) = (BigInt::ZERO, BigInt::ZERO, BigInt::from(1));
    for k in (0..TERMS).rev() {
        // `falling` is (TERMS − 1)!/k!.
        let term = &above[k] * &below[last - k] * &falling;
        let sum = if k % 2 == 0 { &mut cosine } else { &mut sine };
        if k % 4 < 2 {
            *sum += term;
        } else {
            *sum -= term;
        }
        if k > 0 {
            falling *= k;
        }
    }
    let denominator = &below[last] * falling;
    let error = &denominator;
    let (cosine, sine) = (cosine << ERROR_BITS, sine << ERROR_BITS);
    let cosine_low: BigInt = &cosine - error;
    if cosine_low <= BigInt::ZERO {
        return false;
    }
    let bound = if t.sign() > 0 {
        cosine_low
    } else {
        cosine + error
    };
    (sine + error) * t.denominator() <= bound * t.numerator()
}

#[cfg(test)]
mod tests {
    use super::is_below_arctangent;
    use crate::proof::numbers::Exact;

    fn exact(above: i64, below: i64) -> Exact {
        Exact::fraction(above.into(), below.into())
    }

    #[test]
    fn decimals_enclose_arctangents() {
        // atan 1 = 0.785398163397448309615…
        let one = Exact::one();
        assert!(is_below_arctangent(
            &exact(785_398_163_397_448_309, 1_000_000_000_000_000_000),
            &one
        ));
        assert!(!is_below_arctangent(
            &exact(785_398_163_397_448_310, 1_000_000_000_000_000_000),
            &one
        ));
        // atan(−100) = −1.560796660108231381…
        let steep = exact(-100, 1);
        assert!(is_below_arctangent(
            &exact(-1_560_796_660_108_231_382, 1_000_000_000_000_000_000),
            &steep
        ));
        assert!(!is_below_arctangent(
            &exact(-1_560_796_660_108_231_381, 1_000_000_000_000_000_000),
            &steep
        ));
    }

    #[test]
    fn angles_beyond_a_quarter_turn_are_not_decided() {
        assert!(!is_below_arctangent(&exact(-158, 100), &Exact::zero()));
        assert!(!is_below_arctangent(&exact(-3, 1), &Exact::zero()));
        assert!(!is_below_arctangent(&exact(2, 1), &exact(1_000_000, 1)));
    }
}
