//! The exact angle ranges in which a Fourier radius is positive.

use malachite::base::num::arithmetic::traits::Gcd;

use super::angle::{AngleRange, ExactAngle};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::fit::is_positive_by_values;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, doubled_form_from_harmonics};
use crate::roots::real_roots;
use crate::shape::FourierRadius;

/// With more harmonics, certified values are tried before roots are counted.
const MOST_COUNTED: usize = 100;

/// The ranges in which r(θ) > 0, ascending within [0, 2π]: open intervals, but closed at 0 and 2π if r > 0 there.
///
/// With t = tan(θ/2), (1+t²)^N r is a polynomial of degree 2N in t. Its real roots of odd multiplicity are the changes of sign,
/// and its degree is smaller if r(π) = 0. So r > 0 for all angles is certified by exact root counting instead of sampling; then
/// the only range is the full circle. For more than 100 harmonics this is tried first by certified values of r, which take a small
/// part of the time.
///
/// If all harmonics are multiples of g, r(θ) is R(gθ), and the ranges are those of R, repeated g times, where R changes its sign at
/// rational multiples of π only.
#[must_use]
pub fn positive_ranges(radius: &FourierRadius) -> Vec<AngleRange> {
    if radius.harmonics() > MOST_COUNTED {
        let by_values = is_positive_by_values(radius, &Limits::none());
        if by_values.invariant("nothing limits the values") == Some(true) {
            return vec![AngleRange::full_circle()];
        }
    }
    let harmonics =
        (1..=radius.harmonics()).filter(|&n| !(radius.cos(n).is_zero() && radius.sin(n).is_zero()));
    let step = harmonics.fold(0, |g: usize, n| g.gcd(n));
    if step > 1 {
        let every = |list: &[Rational]| list.iter().step_by(step).cloned().collect();
        let contracted = FourierRadius::new(every(radius.cosines()), every(radius.sines()));
        if let Some(ranges) = repeated(&by_counting(&contracted), step) {
            return ranges;
        }
    }
    by_counting(radius)
}

/// The ranges of R(gθ), where these are those of R; `None` if an end is no rational multiple of π.
fn repeated(ranges: &[AngleRange], times: usize) -> Option<Vec<AngleRange>> {
    let turns = |angle: &ExactAngle| match angle {
        ExactAngle::Pi(turns) => Some(turns.clone()),
        ExactAngle::Arctangent { .. } => None,
    };
    let mut all: Vec<([Rational; 2], [bool; 2])> = Vec::new();
    let count = i64::try_from(times).ok()?;
    for k in 0..count {
        for range in ranges {
            let ends = [turns(&range.from)?, turns(&range.to)?];
            let ends = ends.map(|q| (q + Rational::from(2 * k)) / Rational::from(count));
            match all.last_mut() {
                // R > 0 at a full turn.
                Some(last) if last.1[1] && range.closed[0] && last.0[1] == ends[0] => {
                    let [_, to] = ends;
                    (last.0[1], last.1[1]) = (to, range.closed[1]);
                }
                _ => all.push((ends, range.closed)),
            }
        }
    }
    let all = all.into_iter().map(|([from, to], closed)| AngleRange {
        from: ExactAngle::Pi(from),
        to: ExactAngle::Pi(to),
        closed,
    });
    Some(all.collect())
}

/// The ranges by the real roots of the polynomial.
fn by_counting(radius: &FourierRadius) -> Vec<AngleRange> {
    let polynomial = half_angle_polynomial(radius);
    let Some(lead) = polynomial.coefficients_asc().last() else {
        return Vec::new();
    };
    let degree = polynomial.coefficients_asc().len() - 1;
    let mut roots = real_roots(&polynomial);
    // The zeros are ascending in θ over [0, 2π): first those with t ≥ 0, then π (t = ∞), then those with t < 0.
    let negative = roots.iter().take_while(|r| r.signum() < 0).count();
    roots.rotate_left(negative);
    let positive = roots.len() - negative;
    let mut zeros: Vec<(ExactAngle, usize)> = roots
        .into_iter()
        .map(|root| (root.multiplicity(), root))
        .map(|(multiplicity, root)| (ExactAngle::of_half_tangent(root), multiplicity))
        .collect();
    // Just before π the sign is that of the leading coefficient. Each zero of odd multiplicity changes it.
    let at_zero = matches!(zeros.first(), Some((ExactAngle::Pi(q), _)) if q.is_zero());
    let changes: usize = zeros[usize::from(at_zero)..positive]
        .iter()
        .map(|(_, m)| m)
        .sum();
    let mut is_positive = (*lead > 0) == changes.is_multiple_of(2);
    let drop = 2 * radius.harmonics() - degree;
    if drop > 0 {
        zeros.insert(positive, (ExactAngle::Pi(Rational::one()), drop));
    }
    let mut ranges = Vec::new();
    let mut from = (ExactAngle::Pi(Rational::zero()), !at_zero);
    let last = (ExactAngle::Pi(Rational::from(2)), 0);
    for (angle, multiplicity) in zeros.into_iter().skip(usize::from(at_zero)).chain([last]) {
        let closed = multiplicity == 0 && !at_zero;
        if is_positive {
            ranges.push(AngleRange {
                from: from.0,
                to: angle.clone(),
                closed: [from.1, closed],
            });
        }
        is_positive ^= !multiplicity.is_multiple_of(2);
        from = (angle, false);
    }
    ranges
}

/// Whether r(θ) > 0 for every angle, certified as [`positive_ranges`] is.
#[must_use]
pub fn is_positive(radius: &FourierRadius) -> bool {
    is_full_circle(&positive_ranges(radius))
}

/// Whether these ranges are the full circle.
pub(crate) fn is_full_circle(ranges: &[AngleRange]) -> bool {
    matches!(ranges, [only] if only.is_full_circle())
}

/// `(1 + t²)^N r(2 arctan t)` times a positive constant.
fn half_angle_polynomial(radius: &FourierRadius) -> IntegerPolynomial {
    let n = radius.harmonics();
    let (_, cos, sin) = radius.over_common_denominator();
    let doubled = (0..=n).map(|m| (2 * m, &cos[m], &sin[m]));
    doubled_form_from_harmonics(2 * n, doubled)
        .dehomogenized()
        .clone()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn radius(cos: &[i64], sin: &[i64]) -> FourierRadius {
        let exact = |v: &[i64]| v.iter().map(|&c| Rational::from(c)).collect();
        FourierRadius::new(exact(cos), exact(sin))
    }

    fn shown(r: &FourierRadius) -> String {
        let ranges = positive_ranges(r);
        let text = ranges.iter().map(|r| {
            let [a, b] = r.closed;
            let (open, close) = (if a { '[' } else { '(' }, if b { ']' } else { ')' });
            format!(
                "{open}{}, {}{close}",
                r.from.to_decimal(4),
                r.to.to_decimal(4)
            )
        });
        text.collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn ranges_of_simple_radii() {
        assert_eq!(shown(&radius(&[2, 1], &[])), "[0.0000, 6.2832]");
        assert_eq!(shown(&radius(&[-2, 1], &[])), "");
        // cos θ > 0 on both sides of 0, sin θ > 0 on (0, π), and 1 + cos θ touches 0 at π.
        assert_eq!(
            shown(&radius(&[0, 1], &[])),
            "[0.0000, 1.5708) (4.7124, 6.2832]"
        );
        assert_eq!(shown(&radius(&[0, 0], &[0, 1])), "(0.0000, 3.1416)");
        assert_eq!(
            shown(&radius(&[1, 1], &[])),
            "[0.0000, 3.1416) (3.1416, 6.2832]"
        );
        assert_eq!(shown(&radius(&[1, -1], &[])), "(0.0000, 6.2832)");
        assert_eq!(
            shown(&radius(&[1, 2], &[])),
            "[0.0000, 2.0944) (4.1888, 6.2832]"
        );
        assert_eq!(
            shown(&radius(&[1, 0, 1], &[])),
            "[0.0000, 1.5708) (1.5708, 4.7124) (4.7124, 6.2832]"
        );
        assert_eq!(shown(&radius(&[2, 0, 0, 1], &[])), "[0.0000, 6.2832]");
        assert_eq!(
            shown(&radius(&[0, 0, 0], &[0, 0, 1])),
            "(0.0000, 1.5708) (3.1416, 4.7124)"
        );
    }

    proptest! {
        #[test]
        fn the_ranges_agree_with_values(c in prop::collection::vec((-9i64..9, -9i64..9), 1..7), theta in 0.0f64..6.25) {
            let (cos, sin): (Vec<i64>, Vec<i64>) = c.iter().copied().unzip();
            let r = radius(&cos, &sin);
            let mut angle = 0.0;
            let mut value = 0.0;
            for (a, b) in &c {
                value += Rational::from(*a).to_f64() * f64::cos(angle) + if angle == 0.0 { 0.0 } else { Rational::from(*b).to_f64() * f64::sin(angle) };
                angle += theta;
            }
            prop_assume!(value.abs() > 1e-6);
            let inside = positive_ranges(&r).iter().any(|range| {
                let at = |a: &ExactAngle| a.to_decimal(12).parse::<f64>().unwrap();
                at(&range.from) <= theta && theta <= at(&range.to)
            });
            prop_assert_eq!(inside, value > 0.0);
        }

        /// The ranges of R(gθ) by those of R are those by its own polynomial.
        #[test]
        fn repeated_ranges_are_those_by_counting(c in prop::collection::vec((-2i64..3, -2i64..3), 1..3), step in 2usize..5) {
            let mut spread = vec![[0, 0]; step * (c.len() - 1) + 1];
            for (k, (a, b)) in c.into_iter().enumerate() {
                spread[k * step] = [a, b];
            }
            let (cos, sin): (Vec<i64>, Vec<i64>) = spread.into_iter().map(|[a, b]| (a, b)).unzip();
            let r = radius(&cos, &sin);
            let of = |ranges: Vec<AngleRange>| ranges.into_iter().map(|range| {
                (range.from.to_decimal(12), range.to.to_decimal(12), range.closed)
            }).collect::<Vec<_>>();
            prop_assert_eq!(of(positive_ranges(&r)), of(by_counting(&r)));
        }

        /// What values decide is what counting decides.
        #[test]
        fn values_and_counting_agree(c in prop::collection::vec((-2i64..3, -2i64..3), 2..60), constant in -4i64..40) {
            let (mut cos, sin): (Vec<i64>, Vec<i64>) = c.into_iter().unzip();
            cos[0] = constant;
            let r = radius(&cos, &sin);
            if let Some(is_positive) = is_positive_by_values(&r, &Limits::none()).unwrap() {
                prop_assert_eq!(is_positive, is_full_circle(&by_counting(&r)));
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]
        /// With many harmonics, values are tried first.
        #[test]
        fn ranges_of_many_harmonics_are_those_by_counting(c in prop::collection::vec((-2i64..3, -2i64..3), 102..108), constant in -9i64..90) {
            let (mut cos, sin): (Vec<i64>, Vec<i64>) = c.into_iter().unzip();
            cos[0] = constant;
            let r = radius(&cos, &sin);
            prop_assert_eq!(is_full_circle(&positive_ranges(&r)), is_full_circle(&by_counting(&r)));
        }
    }

    #[test]
    fn a_radius_of_any_size_is_positive() {
        for size in ["1e-400", "1", "1e400"] {
            let size: Rational = size.parse().unwrap();
            let mut cos = vec![Rational::zero(); 102];
            cos[0] = &size * Rational::from(2);
            cos[101] = -size.clone();
            cos[100] = -size;
            // It is 0 at θ = 0.
            assert!(!is_full_circle(&positive_ranges(&FourierRadius::new(
                cos.clone(),
                Vec::new()
            ))));
            cos[0] = cos[0].clone() * "1.0000001".parse::<Rational>().unwrap();
            assert!(is_full_circle(&positive_ranges(&FourierRadius::new(
                cos,
                Vec::new()
            ))));
        }
    }
}
