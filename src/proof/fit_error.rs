//! The claim `fit-error`: the largest residual and the root mean square of all residuals of samples (T8).

use num_bigint::{BigInt, Sign};

use super::forms::Forms;
use super::json::{Claim, LONGEST_LIST, Value};
use super::numbers::{Exact, squared_distance, vector};
use super::refusal::{Checked, Refusal, need};
use super::series::Series;

/// The largest number of binary places to which distances are rounded.
const MOST_BITS: u32 = 4096;

/// Bounds of the square of a residual, in units of 4^−bits.
struct SquaredResidual {
    low: BigInt,
    high: BigInt,
}

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    let fields = claim.statement(&["form", "samples", "max", "rms"], &[])?;
    let radius = fields.get("form", |index| forms.series(index))?;
    let largest = fields.get("max", read_bounds)?;
    let root_mean_square = fields.get("rms", read_bounds)?;
    let bits = claim
        .witness(&["bits"], &[])?
        .get("bits", |value| value.count(MOST_BITS))?;
    let residuals = fields.get("samples", |list| {
        list.list(1..=LONGEST_LIST, |sample| {
            squared_residual(radius, &vector(sample, radius.dimension())?, bits)
        })
    })?;

    let zero = || BigInt::ZERO;
    let low = residuals
        .iter()
        .map(|residual| &residual.low)
        .max()
        .cloned()
        .unwrap_or_else(zero);
    let high = residuals
        .iter()
        .map(|residual| &residual.high)
        .max()
        .cloned()
        .unwrap_or_else(zero);
    need_enclosed(&low, &high, 1, &largest, bits)
        .map_err(|refusal| refusal.within("max").within("statement"))?;
    let low = residuals.iter().map(|residual| &residual.low).sum();
    let high = residuals.iter().map(|residual| &residual.high).sum();
    need_enclosed(&low, &high, residuals.len(), &root_mean_square, bits)
        .map_err(|refusal| refusal.within("rms").within("statement"))
}

fn read_bounds(value: &Value) -> Checked<[Exact; 2]> {
    let bounds = vector(value, 2)?;
    let bounds: [Exact; 2] = bounds
        .try_into()
        .map_err(|_| Refusal::new("two numbers are expected"))?;
    need(
        bounds[0].sign() >= 0 && bounds[0] <= bounds[1],
        "the bounds do not ascend from 0",
    )?;
    Ok(bounds)
}

/// The residual is a + (b − 1)·|e| for a radius a + b·|e| in the direction of e. The length |e| is enclosed to 2^−bits, and the
/// bounds are rounded outward.
fn squared_residual(radius: &Series, sample: &[Exact], bits: u32) -> Checked<SquaredResidual> {
    let vector: Vec<_> = sample
        .iter()
        .zip(&radius.center)
        .map(|(p, c)| p - c)
        .collect();
    let parts = radius.radius(&vector)?;
    let square = squared_distance(sample, &radius.center);
    let scaled: BigInt = square.numerator() << (2 * bits);
    let root = (scaled / square.denominator()).sqrt();
    let slope = &parts.of_length - &Exact::one();
    let unit = BigInt::from(1) << bits;
    // The residual in units of 2^−bits.
    let at = |length: BigInt| {
        &(&parts.rational * &Exact::integer(unit.clone())) + &(&slope * &Exact::integer(length))
    };
    let [first, second] = [at(root.clone()), at(root + 1)];
    let (smaller, larger) = if first <= second {
        (first, second)
    } else {
        (second, first)
    };
    let low = floor(&smaller);
    let high = -floor(&-&larger);
    let [low_square, high_square] = [&low * &low, &high * &high];
    let least = match (low.sign(), high.sign()) {
        (Sign::Plus, _) => low_square.clone(),
        (_, Sign::Minus) => high_square.clone(),
        _ => BigInt::ZERO,
    };
    Ok(SquaredResidual {
        low: least,
        high: low_square.max(high_square),
    })
}

/// The largest integer that is not larger.
fn floor(value: &Exact) -> BigInt {
    let quotient = value.numerator() / value.denominator();
    let is_exact = &quotient * value.denominator() == *value.numerator();
    if value.sign() < 0 && !is_exact {
        quotient - 1
    } else {
        quotient
    }
}

/// Needs low² ≤ sum of the lower bounds/number and sum of the upper bounds/number ≤ high².
fn need_enclosed(
    low: &BigInt,
    high: &BigInt,
    number: usize,
    [stated_low, stated_high]: &[Exact; 2],
    bits: u32,
) -> Checked<()> {
    let denominator = BigInt::from(number) << (2 * bits);
    let [low, high] = [low, high].map(|sum| Exact::fraction(sum.clone(), denominator.clone()));
    need(stated_low.squared() <= low, "the error may be less")?;
    need(high <= stated_high.squared(), "the error may be more")
}
