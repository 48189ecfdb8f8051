//! Newton's method: doubles find a root, fixed-point numbers sharpen it, two signs prove it.

use super::fixed::{Fixed, Fraction};
use super::search::Isolated;

/// Steps in doubles; they stop earlier when they gain nothing.
const DOUBLE_STEPS: usize = 40;
/// Steps in fixed-point numbers: each one adds about 50 bits, after a few for what doubles could not see.
const FIXED_STEPS: usize = 24;
/// Newton's method goes on until the enclosure is relatively that short, 2^−70, or rounding hides the value.
const SHORT: f64 = 8.470_329_472_543_003e-22;

/// The polynomial Σ c_i y^i on (0, 1), Σ |c_i| ≤ 64.
#[derive(Debug)]
pub(super) struct OnUnitInterval<const W: usize> {
    pub(super) coefficients: Vec<Fixed<W>>,
    /// Bounds of the errors of the coefficients, in ulps.
    pub(super) errors: Vec<f64>,
    /// These add up to less than that.
    pub(super) error: u128,
}

impl<const W: usize> OnUnitInterval<W> {
    /// From y to −y, up to the sign of all; the powers are those of 1/y if it `is_inverted`.
    pub(super) fn reflect(&mut self, is_inverted: bool) {
        let first = if is_inverted {
            self.coefficients.len() % 2
        } else {
            1
        };
        for c in self.coefficients.iter_mut().skip(first).step_by(2) {
            *c = c.negated();
        }
    }

    /// The value, with an error of less than [`OnUnitInterval::error_of_a_value`] ulps.
    fn value(&self, y: &Fraction<W>) -> Fixed<W> {
        let descending = self.coefficients.iter().rev();
        descending.fold(Fixed::ZERO, |sum, c| sum.times(y).plus(*c))
    }

    /// Each product is rounded by less than W ulps.
    fn error_of_a_value(&self) -> u128 {
        self.error + (W * self.coefficients.len()) as u128
    }

    /// The value, and about the derivative.
    fn value_and_slope(&self, y: &Fraction<W>) -> (Fixed<W>, f64) {
        // The slope may be d times larger than a sum that has just room.
        let bits = self.coefficients.len().ilog2() + 1;
        let (mut value, mut slope) = (Fixed::ZERO, Fixed::ZERO);
        for c in self.coefficients.iter().rev() {
            slope = slope.times(y).plus(value.shifted_down(i64::from(bits)));
            value = value.times(y).plus(*c);
        }
        (value, slope.to_f64() * f64::from(bits).exp2())
    }

    /// Bounds of the root that lies between `low` and `high`, where it has the sign `sign_low` below: strictly inside, with
    /// opposite certain signs. `None` if they would be farther apart than twice `longest` times the root.
    pub(super) fn enclose(
        &self,
        guess: &Fraction<W>,
        [low, high]: [Fraction<W>; 2],
        sign_low: i8,
        longest: f64,
    ) -> Option<[Fraction<W>; 2]> {
        let error = self.error_of_a_value();
        let (mut below, mut above) = (low, high);
        let mut y = if *guess > low && *guess < high {
            *guess
        } else {
            middle(&low, &high)
        };
        let mut last = 1.0;
        let mut radius = f64::INFINITY;
        for _ in 0..FIXED_STEPS {
            let (value, slope) = self.value_and_slope(&y);
            let step = value.to_f64() / slope;
            // The root is within twice the step, unless the rounding is larger.
            radius = 2.0 * (step.abs() + ulps(error) * ulp::<W>() / slope.abs());
            if radius <= SHORT * y.to_f64() {
                break;
            }
            match value.known_sign(error) {
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
                _ => middle(&below, &above),
            };
            last = above.minus(&below)?.to_f64().min(step.abs());
        }
        if radius.is_nan() || radius > longest * y.to_f64() {
            return None;
        }
        let margin = Fraction::from_f64(4.0 * ulp::<W>());
        let radius = Fraction::from_f64(radius).plus(&margin)?;
        let enclosure = [y.minus(&radius)?, y.plus(&radius)?];
        let inside = enclosure[0] > low.plus(&margin)? && enclosure[1] < high.minus(&margin)?;
        let sign = |y| self.value(y).known_sign(error);
        let proved = inside
            && sign(&enclosure[0]) == Some(sign_low)
            && sign(&enclosure[1]) == Some(-sign_low);
        proved.then_some(enclosure)
    }

    /// About the root in an isolating interval, by Newton's method in doubles, halving where it is slow.
    pub(super) fn guess(&self, place: &Isolated) -> f64 {
        let sign_low = place.sign_low;
        let [mut low, mut high] = place.bounds::<W>().map(Fraction::to_f64);
        let coefficients: Vec<f64> = self.coefficients.iter().map(|c| c.to_f64()).collect();
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
                // What is left is about the square of the step, or rounding.
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

/// A point between 0 ≤ low < high ≤ 1: the middle, or where they are of different size one of a size between.
fn between(low: f64, high: f64) -> f64 {
    if low == 0.0 {
        high * high / 4.0
    } else if low < high / 16.0 {
        (low * high).sqrt()
    } else {
        f64::midpoint(low, high)
    }
}

fn middle<const W: usize>(low: &Fraction<W>, high: &Fraction<W>) -> Fraction<W> {
    let half = high.minus(low).map(|width| width.shifted_down(1));
    half.and_then(|half| low.plus(&half)).unwrap_or(*low)
}

/// The size of an ulp of `Fixed<W>`.
#[expect(clippy::cast_precision_loss, reason = "a small number")]
fn ulp<const W: usize>() -> f64 {
    (-(Fixed::<W>::fraction_bits() as f64)).exp2()
}

#[expect(clippy::cast_precision_loss, reason = "a size")]
fn ulps(count: u128) -> f64 {
    count as f64
}
