//! Bernstein coefficients and Descartes' rule: theorem T1.

use num_bigint::BigInt;

use super::clock;
use super::json::{LONGEST_LIST, Value};
use super::numbers::{Exact, common_denominator, is_zero, sign};
use super::refusal::{Checked, Refusal, need};
use super::univariate::{
    Coefficients, End, alternate, shift, shift_by_one, shrink, stretch, variations,
};

/// The interval between two ends, of which the first is the smaller one.
#[derive(Clone, Debug)]
pub(super) struct Interval {
    pub(super) from: End,
    pub(super) to: End,
}

/// Reads breakpoints, which ascend strictly between the two ends, and returns the intervals between them.
pub(super) fn intervals(value: &Value, from: &End, to: &End) -> Checked<Vec<Interval>> {
    let mut ends = vec![from.clone()];
    ends.extend(
        value
            .list(0..=LONGEST_LIST, Exact::read)?
            .into_iter()
            .map(End::At),
    );
    ends.push(to.clone());
    let ascend = ends.windows(2).all(|pair| match pair {
        [End::At(a), End::At(b)] => a < b,
        _ => true,
    });
    need(ascend, "the breakpoints do not ascend between the ends")?;
    let pairs = ends.windows(2).filter_map(|pair| match pair {
        [from, to] => Some(Interval {
            from: from.clone(),
            to: to.clone(),
        }),
        _ => None,
    });
    Ok(pairs.collect())
}

/// Positive multiples of the coefficients of p on the interval, by one common factor. The formal degree of p is one less than
/// the length of its list.
pub(super) fn coefficients_on(p: &[BigInt], interval: &Interval) -> Checked<Coefficients> {
    clock::need_time()?;
    let mut p = p.to_vec();
    match (&interval.from, &interval.to) {
        (End::At(a), End::At(b)) => {
            // The polynomial p(a + (b − a)·x) on [0, 1], where x = s/(1 + s) for the s of the definition.
            let (integers, common) = common_denominator(&[a.clone(), b - a]);
            if let [a, width] = integers.as_slice() {
                shrink(&mut p, &common);
                shift(&mut p, a);
                stretch(&mut p, width);
            }
            on_unit_interval(&mut p);
        }
        (End::At(a), End::Infinity) => shift_to(&mut p, a),
        (End::MinusInfinity, End::At(b)) => {
            alternate(&mut p);
            shift_to(&mut p, &-b);
            p.reverse();
        }
        _ => need(p.len() <= 1, "at least one breakpoint is needed")?,
    }
    Ok(p)
}

/// The coefficients of p on [0, 1], in place.
pub(super) fn on_unit_interval(p: &mut [BigInt]) {
    p.reverse();
    shift_by_one(p);
    p.reverse();
}

/// p(a + s) times a positive factor.
fn shift_to(p: &mut [BigInt], a: &Exact) {
    shrink(p, a.denominator());
    shift(p, a.numerator());
}

/// An interval with exactly one root, which is simple, and the signs of the polynomial at its two ends.
#[derive(Clone, Debug)]
pub(super) struct RootInterval {
    pub(super) interval: Interval,
    pub(super) sign_before: i64,
}

/// The intervals that have a root, in ascending order. There is no other root, and all of them are simple: theorem T1. For
/// unbounded intervals the last coefficient of p must be the leading one.
pub(super) fn isolated_roots(p: &[BigInt], intervals: &[Interval]) -> Checked<Vec<RootInterval>> {
    let mut found = Vec::new();
    for (index, interval) in intervals.iter().enumerate() {
        let coefficients = coefficients_on(p, interval)?;
        let (Some(first), Some(last)) = (coefficients.first(), coefficients.last()) else {
            return Err(Refusal::new("the polynomial is zero"));
        };
        need(
            !is_zero(first) && !is_zero(last),
            &format!("an end of piece {index} is a root"),
        )?;
        match variations(&coefficients) {
            0 => {}
            1 => found.push(RootInterval {
                interval: interval.clone(),
                sign_before: sign(first),
            }),
            many => {
                return Err(Refusal::new(format!(
                    "there are {many} sign changes in piece {index}"
                )));
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;

    use super::{Interval, coefficients_on, isolated_roots};
    use crate::proof::numbers::Exact;
    use crate::proof::univariate::{End, add_multiple, power, product};

    fn interval(from: Option<(i64, i64)>, to: Option<(i64, i64)>) -> Interval {
        let end = |(above, below): (i64, i64)| End::At(Exact::fraction(above.into(), below.into()));
        Interval {
            from: from.map_or(End::MinusInfinity, end),
            to: to.map_or(End::Infinity, end),
        }
    }

    fn integers(values: &[i64]) -> Vec<BigInt> {
        values.iter().map(|value| BigInt::from(*value)).collect()
    }

    /// (1 + s)^n·p((a + b s)/(1 + s)) for integers a and b, term by term.
    fn by_definition(p: &[BigInt], a: i64, b: i64) -> Vec<BigInt> {
        let mut sum = Vec::new();
        for (i, c) in p.iter().enumerate() {
            let rest = power(&integers(&[1, 1]), p.len() - 1 - i);
            add_multiple(&mut sum, c, &product(&power(&integers(&[a, b]), i), &rest));
        }
        sum
    }

    #[test]
    fn the_coefficients_are_those_of_the_definition() {
        let p = integers(&[3, -8, 0, 1, 4]);
        for (a, b) in [(-2, 5), (0, 1), (3, 4)] {
            let found = coefficients_on(&p, &interval(Some((a, 1)), Some((b, 1)))).unwrap();
            assert_eq!(found, by_definition(&p, a, b));
        }
        assert_eq!(
            coefficients_on(&p, &interval(Some((0, 1)), None)).unwrap(),
            p
        );
        // p(1 − s) in reverse order.
        let to_one = coefficients_on(&p, &interval(None, Some((1, 1)))).unwrap();
        assert_eq!(to_one, integers(&[4, -17, 27, -11, 0]));
        assert!(coefficients_on(&p, &interval(None, None)).is_err());
    }

    #[test]
    fn roots_are_isolated_only_where_the_ends_are_no_roots() {
        // (x − 1)(x − 2)(x + 3)
        let p = integers(&[6, -7, 0, 1]);
        let pieces = |points: &[(i64, i64)]| {
            let mut ends = vec![None];
            ends.extend(points.iter().copied().map(Some));
            ends.push(None);
            ends.windows(2)
                .map(|pair| interval(pair[0], pair[1]))
                .collect::<Vec<_>>()
        };
        let count = |points: &[(i64, i64)]| {
            isolated_roots(&p, &pieces(points))
                .map(|found| found.len())
                .ok()
        };
        assert_eq!(count(&[(0, 1), (3, 2)]), Some(3));
        assert_eq!(count(&[(0, 1), (1, 1)]), None);
        assert_eq!(count(&[(0, 1)]), None);
        assert_eq!(count(&[]), None);
    }
}
