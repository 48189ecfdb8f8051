//! The laws of the rules in `interval.rs`.

use super::*;
use proptest::prelude::*;

/// Doubles with the worst rounding: neighbours of powers of two, subnormal numbers, the largest doubles, ±0, and others.
pub(crate) fn nasty() -> impl Strategy<Value = f64> {
    let near_a_power = (-1074i32..1024, -2i64..3, any::<bool>()).prop_map(|(e, ulps, negative)| {
        let power = if e < -1022 {
            5e-324 * 2f64.powi(e + 1074)
        } else {
            2f64.powi(e)
        };
        let bits = i64::try_from(power.to_bits()).unwrap() + ulps;
        let x = f64::from_bits(u64::try_from(bits.max(0)).unwrap());
        let x = if x.is_finite() { x } else { f64::MAX };
        if negative { -x } else { x }
    });
    let small = (1u64..64, any::<bool>()).prop_map(|(bits, negative)| {
        let x = f64::from_bits(bits);
        if negative { -x } else { x }
    });
    prop_oneof![
        3 => near_a_power,
        1 => small,
        1 => prop::sample::select(vec![0.0, -0.0, 1.0, -1.0, f64::MAX, f64::MIN, f64::MIN_POSITIVE]),
        3 => -4.0f64..4.0,
        1 => (any::<u32>(), any::<u32>(), -60i32..60).prop_map(|(a, b, e)| {
            (1.0 + (f64::from(a) + f64::from(b) * 2f64.powi(-32)) * 2f64.powi(-32)) * 2f64.powi(e)
        }),
    ]
}

fn exact(x: f64) -> Rational {
    Rational::try_from(x).unwrap()
}

/// An interval with finite ends, and its ends as the members that are tested.
fn intervals() -> impl Strategy<Value = (Interval, [Rational; 2])> {
    (nasty(), nasty(), any::<bool>()).prop_map(|(a, b, is_thin)| {
        let b = if is_thin { a } else { b };
        let (low, high) = (a.min(b), a.max(b));
        (Interval::between(low, high), [exact(low), exact(high)])
    })
}

/// A sign is returned exactly if all members have it.
#[test]
fn signs_are_those_of_all_members() {
    let sign = |low, high| Interval::between(low, high).sign();
    for x in [f64::from_bits(1), 1.0, f64::MAX] {
        assert_eq!([sign(x, x), sign(-x, -x)], [Some(1), Some(-1)]);
        assert_eq!([sign(0.0, x), sign(-x, 0.0), sign(-x, x)], [None; 3]);
        assert_eq!(sign(x, f64::INFINITY), Some(1));
        assert_eq!(sign(f64::NEG_INFINITY, -x), Some(-1));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, ..ProptestConfig::default() })]

    /// Lemma 1: the exact results for the ends are members of the result, and for thin intervals the result is at most four
    /// units wide.
    #[test]
    fn operations_hold_the_exact_results((x, of_x) in intervals(), (y, of_y) in intervals()) {
        let checked = |found: Interval, operation: &dyn Fn(&Rational, &Rational) -> Option<Rational>| {
            of_x.iter().flat_map(|a| of_y.iter().map(move |b| (a, b))).all(|(a, b)| {
                operation(a, b).is_none_or(|value| found.contains(&value))
            })
        };
        prop_assert!(checked(x + y, &|a, b| Some(a + b)));
        prop_assert!(checked(x - y, &|a, b| Some(a - b)));
        prop_assert!(checked(x * y, &|a, b| Some(a * b)));
        prop_assert!(checked(x / y, &|a, b| Some(a * &b.recip()?)));
        prop_assert!(checked(-x, &|a, _| Some(-a)));
        prop_assert!(checked(x.abs(), &|a, _| Some(a.abs())));
        prop_assert!(checked(x.squared(), &|a, _| Some(a * a)));
        prop_assert!(checked(x.max(y), &|a, b| Some(a.max(b).clone())));
        prop_assert!(checked(x.or_zero(), &|a, _| Some(a.clone().max(Rational::zero()))));
        if x.high() >= 0.0 {
            let root = x.sqrt();
            let [low, high] = [root.low(), root.high()].map(|r| Rational::try_from(r).map(|r| &r * &r));
            for value in of_x.iter().filter(|value| value.signum() >= 0) {
                prop_assert!(low.as_ref().is_ok_and(|low| low <= value));
                prop_assert!(high.as_ref().is_ok_and(|high| value <= high));
            }
        }
        for (found, is_used) in [(x + y, true), (x * y, true), (x / y, y.sign().is_some())] {
            if is_used && of_x[0] == of_x[1] && of_y[0] == of_y[1] {
                let [low, high] = [found.low(), found.high()];
                prop_assert!((0..4).fold(low, |low: f64, _| low.next_up()) >= high || found.magnitude().is_infinite());
            }
        }
    }

    /// The interval of a number holds it, and the interval around a number holds all numbers within the radius.
    #[test]
    fn conversions_hold_the_number(p in any::<i64>(), q in 1i64..i64::MAX, e in -1100i64..1100, middle in nasty(), radius in nasty()) {
        let x = Rational::from(p) / Rational::from(q) * Rational::from(2).pow(e).unwrap();
        prop_assert!(Interval::from(&x).contains(&x));
        let narrow = Interval::narrowest(&x);
        prop_assert!(narrow.contains(&x));
        // There is no next double beyond the largest one.
        prop_assert!(narrow.low().next_up() >= narrow.high() || narrow.high().is_infinite());
        let found = Interval::around(middle, radius.abs());
        for end in [exact(middle) - exact(radius.abs()), exact(middle) + exact(radius.abs())] {
            prop_assert!(found.contains(&end));
        }
    }
}

#[test]
fn nothing_is_claimed_of_what_is_no_number() {
    let (one, all) = (Interval::from(1.0), Interval::ENTIRE);
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(Interval::from(x), all);
        assert_eq!(Interval::around(x, 1.0), all);
        assert_eq!(Interval::around(1.0, x), all);
    }
    assert_eq!(all + all, all);
    assert_eq!(all - all, all);
    assert_eq!(all * all, all);
    assert_eq!(all / all, all);
    assert_eq!(one / Interval::ZERO, all);
    assert_eq!(all.sign(), None);
    assert_eq!(all * f64::INFINITY, all);
    assert_eq!(one * f64::NAN, all);
    // [0, 1] times all real numbers is all real numbers; [0, 1] times the positive numbers is the numbers that are not
    // negative.
    let part = Interval::between(0.0, 1.0);
    let positive = Interval::between(0.0, f64::INFINITY);
    assert_eq!(part * all, all);
    assert!((part * positive).high().is_infinite());
    assert!((part * positive).low() >= -f64::MIN_POSITIVE);
    assert!((all * Interval::ZERO).low() <= 0.0 && (all * Interval::ZERO).high() >= 0.0);
    // After an overflow there is no bound.
    let huge = Interval::from(f64::MAX);
    assert!((huge + huge).high().is_infinite());
    assert!((huge * huge).high().is_infinite());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10_000, ..ProptestConfig::default() })]

    /// Lemma 1: the result is the next double or the one after it.
    #[test]
    fn the_next_double_is_reached(x in nasty()) {
        prop_assert!(x.next_up() <= above(x) && above(x) <= x.next_up().next_up());
        prop_assert!(x.next_down().next_down() <= below(x) && below(x) <= x.next_down());
    }
}

/// Lemma 2 for powers: every error is within the counted error, and some errors are an eighth of it.
#[test]
fn counted_errors_hold_and_are_reached() {
    let mut most = 0.0f64;
    for roundings in [1usize, 2, 5, 20, 100] {
        for x in [
            1.0 + f64::EPSILON,
            1.5 - f64::EPSILON,
            4.0 / 3.0,
            1.1,
            1.0 / 3.0,
            1.9,
        ] {
            let power = (0..roundings).fold(x, |power, _| power * x);
            let count = i64::try_from(roundings).unwrap();
            let error = (exact(x).pow(count + 1).unwrap() - exact(power)).abs();
            let bound = exact(power) * exact(relative_error(roundings));
            assert!(error <= bound);
            most = most.max((error / bound).to_f64());
        }
    }
    assert!(most >= 0.125, "{most}");
}
