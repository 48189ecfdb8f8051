//! The common factor of two lists of coefficients.

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use crate::exact::Rational;

/// The largest number of coefficients whose ratios are used. Of more coefficients, every k-th is taken.
const MOST_RATIOS: usize = 2048;

/// For each of these k, the simplest number within 2^−k of the typical ratio is a candidate.
const WINDOWS: [i64; 5] = [51, 44, 36, 26, 16];

/// The factor between the coefficients of a float program and the exact ones.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Scale {
    /// got ≈ factor · exact.
    pub factor: Rational,
    /// The meaning of the factor, if it is a simple one.
    pub meaning: Option<Meaning>,
}

/// Factors that say how the float program normalises its polynomial.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Meaning {
    /// The factor is ±2^k for this k, which may be 0.
    PowerOfTwo(i64),
    /// The factor is a short fraction.
    Fraction,
    /// The factor makes the first coefficient this short fraction.
    FirstCoefficient(Rational),
    /// The factor makes the largest coefficient ±1.
    LargestIsOne,
}

/// The largest number of bits of a simple fraction. It is far below 50: within 2⁻⁵¹ of any number near 1 there are fractions
/// with about 50 bits by accident.
const SIMPLE_BITS: u64 = 32;

struct Candidate {
    factor: Rational,
    bits: u64,
}

/// The factor s with got ≈ s·exact, from pairs (got, exact) in which no number is 0; `None` if there are no pairs.
///
/// The ratios got/exact are close together where a float program is right. First, the half-sample mode (Robertson and Cryer,
/// 1974) finds a typical ratio: of the sorted ratios, the half with the smallest relative width is kept again and again. Wrong
/// coefficients cannot mislead it if they are fewer than half. Then the simplest of some candidates is chosen: factors near the
/// typical ratio that are 2^k or p/q, or that make the first coefficient such a number, or the largest one. For a candidate to
/// be allowed, the error that a quarter of the coefficients does not exceed must be at most twice that of the best candidate,
/// or at most 2^−52. All decisions are exact. Cost: about n log n differences of ratios.
pub(super) fn common_factor(pairs: &[[Rational; 2]]) -> Option<Scale> {
    let step = pairs.len().div_ceil(MOST_RATIOS).max(1);
    let some: Vec<&[Rational; 2]> = pairs.iter().step_by(step).collect();
    let mut ratios: Vec<Rational> = some.iter().map(|[got, exact]| got / exact).collect();
    let mode = mode(&mut ratios)?;
    let first = pairs.first().map(|[_, exact]| exact.clone())?;
    let largest = pairs.iter().map(|[_, exact]| exact.abs()).max()?;
    let mut candidates = vec![Candidate {
        bits: u64::MAX,
        factor: mode.clone(),
    }];
    for unit in [Rational::one(), first.clone(), largest.clone()] {
        let value = &mode * &unit;
        let simple = WINDOWS.iter().map(|&k| {
            let reach = value.abs() * Rational::from_dyadic(Integer::from(1), -k);
            Rational::simplest_between(&(&value - &reach), &(&value + &reach))
        });
        let simple = simple.filter(|q| length(q) <= SIMPLE_BITS);
        candidates.extend(simple.map(|q| Candidate {
            bits: length(&q),
            factor: q / &unit,
        }));
        let power = Rational::from_dyadic(Integer::from(value.signum()), nearest_power(&value));
        candidates.push(Candidate {
            bits: 2,
            factor: power / &unit,
        });
    }
    // Of equally simple candidates the first is taken, so that a simple factor comes before one that makes the first
    // coefficient simple.
    let mut judged: Vec<(Rational, Candidate)> = candidates
        .into_iter()
        .map(|candidate| (quartile(&some, &candidate.factor), candidate))
        .collect();
    let best = judged.iter().map(|(error, _)| error).min()?.clone();
    let rounding = Rational::from_dyadic(Integer::from(1), -52);
    let allowed = (best * Rational::from(2)).max(rounding);
    judged.retain(|(error, _)| *error <= allowed);
    let (_, chosen) = judged.into_iter().min_by_key(|(_, c)| c.bits)?;
    let meaning = meaning(&chosen.factor, &first, &largest);
    Some(Scale {
        factor: chosen.factor,
        meaning,
    })
}

/// The half-sample mode: the narrowest half is kept until at most two ratios are left, of which the smaller one is taken.
fn mode(ratios: &mut [Rational]) -> Option<Rational> {
    ratios.sort_unstable();
    let mut rest = &*ratios;
    while rest.len() > 2 {
        let half = rest.len().div_ceil(2);
        let widths = rest.windows(half).map(|w| spread(&w[0], &w[half - 1]));
        let (start, _) = widths.enumerate().min_by(|(_, a), (_, b)| a.cmp(b))?;
        rest = &rest[start..start + half];
    }
    rest.first().cloned()
}

/// The distance of two numbers, relative to the larger of their sizes.
fn spread(low: &Rational, high: &Rational) -> Rational {
    let size = low.abs().max(high.abs());
    (high - low) / size
}

/// The relative error that a quarter of the pairs does not exceed.
fn quartile(pairs: &[&[Rational; 2]], factor: &Rational) -> Rational {
    let errors = pairs.iter().map(|[got, exact]| {
        let scaled = exact * factor;
        ((got - &scaled) / scaled).abs()
    });
    let mut errors: Vec<Rational> = errors.collect();
    let place = (errors.len() - 1) / 4;
    errors.select_nth_unstable_by(place, Ord::cmp).1.clone()
}

/// The k with 2^k nearest to |q|.
pub(super) fn nearest_power(q: &Rational) -> i64 {
    let bits = |n: &Integer| n.significant_bits().cast_signed();
    let k = bits(&q.numerator()) - bits(&q.denominator());
    let one = Integer::from(1);
    let off = |k: i64| (q.abs() - Rational::from_dyadic(one.clone(), k)).abs();
    match off(k - 1).cmp(&off(k)) {
        Ordering::Less => k - 1,
        _ if off(k + 1) < off(k) => k + 1,
        _ => k,
    }
}

/// The number of bits of the numerator and the denominator together.
fn length(q: &Rational) -> u64 {
    q.numerator().significant_bits() + q.denominator().significant_bits()
}

fn meaning(factor: &Rational, first: &Rational, largest: &Rational) -> Option<Meaning> {
    let power = nearest_power(factor);
    if factor.abs() == Rational::from_dyadic(Integer::from(1), power) {
        return Some(Meaning::PowerOfTwo(power));
    }
    if length(factor) <= SIMPLE_BITS {
        return Some(Meaning::Fraction);
    }
    let value = factor * first;
    if length(&value) <= SIMPLE_BITS {
        return Some(Meaning::FirstCoefficient(value));
    }
    ((factor * largest).abs() == Rational::one()).then_some(Meaning::LargestIsOne)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rational(v: f64) -> Rational {
        Rational::try_from(v).unwrap()
    }

    fn scale(pairs: &[[Rational; 2]]) -> Scale {
        common_factor(pairs).unwrap()
    }

    #[test]
    fn there_is_none_without_coefficients() {
        assert_eq!(common_factor(&[]), None);
    }

    proptest! {
        /// If coefficients are multiplied by a simple factor and rounded, and a third of them is spoiled, the factor is found
        /// exactly.
        #[test]
        fn simple_factors_come_back(
            c in prop::collection::vec((-1e6f64..1e6).prop_filter("not 0", |v| v.abs() > 1e-3), 12..40),
            p in 1i32..40, q in 1i32..40, power in -60i64..60, sign in any::<bool>(), spoiled in any::<u16>()
        ) {
            let fraction = Rational::from(if sign { p } else { -p }) / Rational::from(q);
            for factor in [fraction, Rational::from_dyadic(Integer::from(1), power)] {
                let pairs: Vec<[Rational; 2]> = c
                    .iter()
                    .enumerate()
                    .map(|(i, v)| {
                        // This exact value is not a double.
                        let exact = rational(*v) / Rational::from(3);
                        let mut got = (&exact * &factor).to_f64();
                        if i % 3 == 1 {
                            got *= 1.5 + f64::from(spoiled) % (exact.to_f64().abs() + 7.0);
                        }
                        [rational(got), exact]
                    })
                    .collect();
                prop_assert_eq!(&scale(&pairs).factor, &factor);
            }
        }

        /// A factor that is not simple, as after division by a norm, is found although nearly half of the coefficients are
        /// spoiled.
        #[test]
        fn any_factor_is_found_as_well_as_doubles_allow(
            c in prop::collection::vec(1e-3f64..1e6, 20..60), factor in 0.1f64..10.0, spoil in prop::collection::vec(0.2f64..5.0, 60)
        ) {
            let factor = factor.sqrt() / 3.0;
            let pairs: Vec<[Rational; 2]> = c
                .iter()
                .zip(&spoil)
                .enumerate()
                .map(|(i, (v, s))| {
                    let got = v / 7.0 * factor;
                    // At most four of nine coefficients are spoiled.
                    let got = if i % 9 > 4 { got * s } else { got };
                    [rational(got), rational(*v) / Rational::from(7)]
                })
                .collect();
            let found = scale(&pairs).factor.to_f64();
            prop_assert!((found / factor - 1.0).abs() < 1e-14, "{} {}", found, factor);
        }

        #[test]
        fn a_polynomial_with_first_coefficient_1_is_recognised(
            c in prop::collection::vec(1e-3f64..1e6, 8..30), lead in 1i64..i64::MAX
        ) {
            let mut exact = vec![Rational::from(lead) * Rational::from(i64::MAX)];
            exact.extend(c.iter().map(|v| rational(*v)));
            let lead = exact[0].clone();
            let pairs: Vec<_> = exact.into_iter().map(|e| [rational((&e / &lead).to_f64()), e]).collect();
            let found = scale(&pairs);
            prop_assert_eq!(&found.factor, &lead.recip().unwrap());
            prop_assert!(matches!(found.meaning, Some(Meaning::FirstCoefficient(v)) if v == Rational::one()));
        }
    }
}
