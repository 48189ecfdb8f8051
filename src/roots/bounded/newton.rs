//! Newton's method for enclosures of roots: doubles find a root, fixed-point numbers sharpen it, and two signs prove it.

use super::ball::Balls;
use super::fixed::{Fixed, Fraction};
use super::search::IsolatingInterval;

/// The largest number of steps in doubles; they end earlier if they make no progress.
const DOUBLE_STEPS: usize = 40;
/// The largest number of steps in fixed-point numbers. After a few steps for the error of the doubles, each step adds about 50
/// bits.
const FIXED_STEPS: usize = 24;
/// Newton's method ends when the enclosure is relatively as short as this, 2^−70, or when rounding hides the value.
const SHORT: f64 = 8.470_329_472_543_003e-22;
/// The number of ulps by which an enclosure is longer than the estimated error.
const ROOM: f64 = 4.0;

/// Whether a root between the two ends is proved. [`Balls::enclose`] trusts only this and [`is_inside`]; a bad guess only costs
/// time.
///
/// **Lemma.** Certain and opposite signs at the two ends have a root between them. Proof: the balls of the values hold the
/// true values (Lemma 8 of `ball.rs`), and polynomials are continuous. Law: `an_enclosure_holds_the_root`.
fn proves_root<const W: usize>(
    polynomial: &Balls<W>,
    [low, high]: &[Fraction<W>; 2],
    sign_low: i8,
) -> bool {
    let sign = |y| polynomial.value(y).sign();
    sign(low) == Some(sign_low) && sign(high) == Some(-sign_low)
}

/// Whether an enclosure is strictly inside its place.
///
/// **Lemma.** Let a place hold exactly one root, in an enclosure that is strictly inside the place. If an end of the enclosure
/// is moved outwards by less than 2^(−64W), the enclosure still holds exactly this root, and the sign at the moved end does not
/// change.
///
/// Proof. All ends are multiples of 2^(−64W), so the moved end is still inside the place. The polynomial has no other root
/// there, so it has the same sign. Law: `an_enclosure_holds_the_root`.
fn is_inside<const W: usize>(enclosure: &[Fraction<W>; 2], [low, high]: &[Fraction<W>; 2]) -> bool {
    enclosure[0] > *low && enclosure[1] < *high
}

impl<const W: usize> Balls<W> {
    /// Bounds of the root that is alone in `place`, where the polynomial has the sign `sign_low` below the root. They are
    /// strictly inside the place and have certain, opposite signs. `None` if they would be farther apart than twice `longest`
    /// times the root.
    pub(super) fn enclose(
        &self,
        guess: &Fraction<W>,
        place: [Fraction<W>; 2],
        sign_low: i8,
        longest: f64,
    ) -> Option<[Fraction<W>; 2]> {
        let error = self.radius_of_a_value();
        let [mut below, mut above] = place;
        let mut y = if *guess > below && *guess < above {
            *guess
        } else {
            middle(&below, &above)?
        };
        let mut last = 1.0;
        let mut radius = f64::INFINITY;
        for _ in 0..FIXED_STEPS {
            let (value, slope) = self.value_and_slope(&y);
            let step = value.to_f64() / slope;
            // The root is within twice the step, unless the rounding error is larger.
            radius = 2.0 * (step.abs() + error * ulp::<W>() / slope.abs());
            if radius <= SHORT * y.to_f64() {
                break;
            }
            match value.sign() {
                None => break,
                Some(sign) if sign == sign_low => below = y,
                Some(_) => above = y,
            }
            let size = Fraction::from_f64(step.abs().min(0.5));
            let next = if step < 0.0 {
                y.plus(&size)
            } else {
                y.minus(&size)
            };
            y = match next {
                Some(next) if next > below && next < above && step.abs() < last / 2.0 => next,
                _ => middle(&below, &above)?,
            };
            last = above.minus(&below)?.to_f64().min(step.abs());
        }
        if radius.is_nan() || radius > longest * y.to_f64() {
            return None;
        }
        let room = Fraction::from_f64(ROOM * ulp::<W>());
        let radius = Fraction::from_f64(radius).plus(&room)?;
        let enclosure = [y.minus(&radius)?, y.plus(&radius)?];
        let proved = is_inside(&enclosure, &place) && proves_root(self, &enclosure, sign_low);
        proved.then_some(enclosure)
    }

    /// An approximation of the root in an isolating interval, by Newton's method in doubles with bisection where it is slow.
    pub(super) fn guess(&self, place: &IsolatingInterval) -> f64 {
        let sign_low = place.sign_low;
        let [mut low, mut high] = place.bounds::<W>().map(Fraction::to_f64);
        let coefficients = self.to_doubles();
        let mut y = between(low, high);
        let mut last = high - low;
        for _ in 0..DOUBLE_STEPS {
            let (mut value, mut slope) = (0.0, 0.0);
            for c in coefficients.iter().rev() {
                slope = slope * y + value;
                value = value * y + c;
            }
            if (value < 0.0) == (sign_low < 0) {
                low = y;
            } else {
                high = y;
            }
            let step = value / slope;
            let next = y - step;
            let size = step.abs();
            if next > low && next < high && size < last / 2.0 {
                y = next;
                last = size;
                // The remaining error is about the square of the step, or a rounding error.
                if size < y * 1e-8 {
                    break;
                }
            } else if high - low < y * 1e-15 {
                break;
            } else {
                y = between(low, high);
                last = high - low;
            }
        }
        y
    }
}

/// A point between 0 ≤ low < high ≤ 1: the middle or, if the two have different sizes, a point of a size between them.
fn between(low: f64, high: f64) -> f64 {
    if low == 0.0 {
        high * high / 4.0
    } else if low < high / 16.0 {
        (low * high).sqrt()
    } else {
        f64::midpoint(low, high)
    }
}

fn middle<const W: usize>(low: &Fraction<W>, high: &Fraction<W>) -> Option<Fraction<W>> {
    low.plus(&high.minus(low)?.shifted_down(1))
}

/// About the size of an ulp of `Fixed<W>`.
#[expect(clippy::cast_precision_loss, reason = "a small number")]
fn ulp<const W: usize>() -> f64 {
    (-(Fixed::<W>::FRACTION_BITS as f64)).exp2()
}

#[cfg(test)]
mod tests {
    use super::super::ball::ScaledBall;
    use super::super::draw::Draw;
    use super::*;
    use crate::exact::Rational;
    use malachite::Integer;

    /// The product of polynomials with ascending coefficients.
    fn product(f: &[Integer], g: &[Integer]) -> Vec<Integer> {
        let mut result = vec![Integer::from(0); f.len() + g.len() - 1];
        for (i, a) in f.iter().enumerate() {
            for (j, b) in g.iter().enumerate() {
                result[i + j] += a * b;
            }
        }
        result
    }

    fn balls<const W: usize>(c: &[Integer]) -> Balls<W> {
        let balls = c.iter().map(|c| (ScaledBall::of_integer(c), 0));
        Balls::aligned(balls).expect("not all are 0")
    }

    fn number<const W: usize>(fraction: &Fraction<W>) -> Rational {
        Rational::from_dyadic(fraction.to_integer(), -(64 * W as i64))
    }

    /// A polynomial with positive coefficients, which are longer than W limbs; it has no root in (0, 1).
    fn positive(draw: &mut Draw, limbs: usize) -> Vec<Integer> {
        let count = 1 + draw.below(12);
        (0..count)
            .map(|_| {
                Integer::from(draw.integer(limbs).unsigned_abs_ref().clone()) + Integer::from(1)
            })
            .collect()
    }

    fn an_enclosure_holds_the_root<const W: usize>(draw: &mut Draw) {
        let mut found = 0;
        for _ in 0..300 {
            // A place (index, index + 1) 2^(−depth), and a root p/q in it, often very near to one of its ends.
            let depth = u32::try_from(draw.below(30)).expect("small");
            let index = draw.below(1 << depth) as u64;
            let place = IsolatingInterval {
                index,
                depth,
                sign_low: -1,
            };
            let bits = 64 + draw.below(64 * W) as u64;
            let inside = match draw.below(4) {
                0 => Integer::from(1 + draw.below(9)),
                1 => (Integer::from(1) << bits) - Integer::from(1 + draw.below(9)),
                _ => (Integer::from(1) << (bits - 1)) + Integer::from(draw.word()),
            };
            let p = (Integer::from(index) << bits) + inside;
            let q = Integer::from(1) << (bits + u64::from(depth));
            let root = Rational::from_integers(p.clone(), q.clone()).expect("not 0");
            let without = positive(draw, W + 2);
            let polynomial = balls::<W>(&product(&[-p, q], &without));
            let bounds = place.bounds();
            let guess = Fraction::from_f64(root.to_f64().min(1.0f64.next_down()));
            let longest = [1e-3, 1e-17, 1e-28, 1e-33][draw.below(4)];
            let enclosure = polynomial.enclose(&guess, bounds, -1, longest);
            if let Some([low, high]) = enclosure {
                found += 1;
                assert!(number(&low) < root && root < number(&high));
                // An end that is moved by less than one unit in the last place is still inside the place.
                let unit = Rational::from_dyadic(Integer::from(1), -(64 * W as i64));
                let end = |k| Rational::from_dyadic(Integer::from(index + k), -i64::from(depth));
                assert!(number(&low) - &unit >= end(0) && number(&high) + &unit <= end(1));
                let room = exact(3.0 * ROOM * ulp::<W>());
                assert!(number(&high) - number(&low) < exact(2.5 * longest) * &root + room);
            }
            // A wrong sign is not proved.
            assert!(polynomial.enclose(&guess, bounds, 1, longest).is_none());
            assert!(
                balls::<W>(&without)
                    .enclose(&guess, bounds, 1, longest)
                    .is_none()
            );
            assert!(
                balls::<W>(&without)
                    .enclose(&guess, bounds, -1, longest)
                    .is_none()
            );
        }
        assert!(found > 100, "{found}");
    }

    /// Certain signs at both ends are not enough if they are equal: 2y − 1 has no root between 1/4 and 3/8, nor between 5/8 and 3/4.
    #[test]
    fn both_signs_are_asked_for() {
        let polynomial = balls::<2>(&[Integer::from(-1), Integer::from(2)]);
        let at = |eighths| Fraction::dyadic(eighths, 3);
        assert!(proves_root(&polynomial, &[at(3), at(5)], -1));
        assert!(!proves_root(&polynomial, &[at(2), at(3)], -1));
        assert!(!proves_root(&polynomial, &[at(5), at(6)], -1));
    }

    /// An enclosure that shares an end with its place is not strictly inside it.
    #[test]
    fn no_end_is_shared() {
        let at = |eighths| Fraction::<2>::dyadic(eighths, 3);
        let place = [at(1), at(5)];
        assert!(is_inside(&[at(2), at(4)], &place));
        assert!(!is_inside(&[at(1), at(4)], &place));
        assert!(!is_inside(&[at(2), at(5)], &place));
    }

    fn exact(value: f64) -> Rational {
        Rational::try_from(value).expect("a finite double")
    }

    #[test]
    fn an_enclosure_holds_the_root_in_all_widths() {
        an_enclosure_holds_the_root::<2>(&mut Draw(2));
        an_enclosure_holds_the_root::<3>(&mut Draw(3));
        an_enclosure_holds_the_root::<6>(&mut Draw(6));
        an_enclosure_holds_the_root::<12>(&mut Draw(12));
    }
}
