//! Laws of ticks: their labels are short, distinct and exact.

use proptest::prelude::*;

use super::*;

const MOST: usize = 10;

fn ticks(range: [f64; 2]) -> Ticks {
    let [ticks] = fitting([range], MOST, true, |_, _| true);
    ticks
}

fn exact(decimal: Decimal) -> Rational {
    let power = Rational::from(10).pow(i64::from(decimal.exponent)).unwrap();
    decimal.digits.to_string().parse::<Rational>().unwrap() * power
}

fn check([low, high]: [f64; 2]) -> std::result::Result<(), TestCaseError> {
    let found = ticks([low, high]);
    let Ticks { values, labels, .. } = &found;
    prop_assert!((3..=MOST).contains(&values.len()), "{:?}", found);
    prop_assert_eq!(values.len(), labels.len());
    let slack = 1e-8 * (high - low);
    prop_assert!(
        values
            .iter()
            .all(|v| (low - slack..=high + slack).contains(v)),
        "{:?}",
        found
    );
    prop_assert!(values.is_sorted_by(|a, b| a < b), "{:?}", found);
    let power = Rational::from(10).pow(i64::from(found.exponent)).unwrap();
    let mut before: Option<Rational> = None;
    for (value, label) in values.iter().zip(labels) {
        prop_assert!(label.len() <= 12 && !label.contains('e'), "{:?}", found);
        prop_assert!(label != "-0");
        let shown = label.parse::<Rational>().unwrap();
        let meant = &(&shown * &power) + &exact(found.offset);
        prop_assert_eq!(meant.to_f64().to_bits(), value.to_bits(), "{:?}", found);
        prop_assert!(before.is_none_or(|before| before < shown));
        before = Some(shown);
    }
    Ok(())
}

proptest! {
    #[test]
    fn labels_are_short_and_exact(
        low in -1e3f64..1e3,
        size in 1e-3f64..1e4,
        exponent in -120i32..=120,
    ) {
        let power = 10f64.powi(exponent);
        check([low * power, (low + size) * power])?;
    }

    #[test]
    fn labels_far_from_zero_are_short_and_exact(
        far in -1e15f64..1e15,
        digits in 0.0f64..12.0,
        exponent in -100i32..=100,
    ) {
        let power = 10f64.powi(exponent);
        let size = far.abs().max(1.0) * 10f64.powf(-digits);
        check([far * power, (far + size) * power])?;
    }

    #[test]
    fn zero_is_zero(low in -9.0f64..-1e-6, high in 1e-6f64..9.0, exponent in -100i32..=100) {
        let power = 10f64.powi(exponent);
        let found = ticks([low * power, high * power]);
        prop_assert_eq!(found.label(0.0), "0");
    }
}

#[test]
fn a_range_of_one_far_from_zero_has_ticks() {
    check([1e15, 1e15 + 1.0]).unwrap();
    let found = ticks([1e15, 1e15 + 1.0]);
    assert_eq!(found.title("x"), "x − 10¹⁵");
    assert!(found.values.len() >= 3);
    // Neighbouring doubles, and ranges that are no ranges.
    for range in [
        [1.0, 1.0f64.next_up()],
        [f64::MIN, f64::MAX],
        [0.0, f64::MIN_POSITIVE],
    ] {
        assert!(ticks(range).values.is_sorted_by(|a, b| a < b));
    }
    for range in [
        [1.0, 1.0],
        [2.0, 1.0],
        [0.0, f64::INFINITY],
        [f64::NAN, 1.0],
    ] {
        assert!(ticks(range).values.is_empty());
    }
}

#[test]
fn titles_say_what_labels_are() {
    let shown = |low: f64, high: f64| {
        let found = ticks([low, high]);
        let (first, last) = (found.labels.first(), found.labels.last());
        [&found.title("x"), first.unwrap(), last.unwrap()].map(String::clone)
    };
    assert_eq!(shown(-1.1, 1.1), ["x", "-1", "1"]);
    assert_eq!(
        shown(500_000.122_9, 500_000.127_6),
        ["x − 500 000.12", "0.003", "0.0075"]
    );
    assert_eq!(
        shown(999_999.997_9, 1_000_000.002_1),
        ["x − 1 000 000", "-0.002", "0.002"]
    );
    assert_eq!(
        shown(500_123e6, 500_123e6 + 1e4),
        ["x − 500 123 000 000", "0", "10000"]
    );
    assert_eq!(
        shown(-500_123e6, -500_123e6 + 1e4),
        ["x + 500 123 000 000", "0", "10000"]
    );
    assert_eq!(shown(0.0, 1.5e-9), ["x / 10⁻⁹", "0", "1.4"]);
    assert_eq!(shown(-2e15, 2e15), ["x / 10¹⁵", "-2", "2"]);
    assert_eq!(shown(1.0, 1.0 + 1e-9), ["(x − 1) / 10⁻⁹", "0", "1"]);
    assert_eq!(
        shown(1.25e30, 1.25e30 * (1.0 + 1e-7)),
        ["(x − 1.25·10³⁰) / 10²¹", "0", "120"]
    );
}

#[test]
fn axes_of_one_unit_share_their_exponent() {
    let ranges = [[0.0, 1.2e-9], [0.0, 0.7e-9]];
    let shared = fitting(ranges, MOST, true, |_, _| true);
    let own = fitting(ranges, MOST, false, |_, _| true);
    assert_eq!(shared.map(|t| t.exponent), [-9, -9]);
    assert_eq!(own.map(|t| t.exponent), [-9, -12]);
}

#[test]
fn ticks_become_fewer_until_they_fit() {
    let [few] = fitting([[0.0, 1.0]], MOST, true, |_, ticks| {
        ticks.values().len() <= 4
    });
    assert!((2..=4).contains(&few.values().len()), "{few:?}");
    let [two] = fitting([[0.0, 1.0]], MOST, true, |_, _| false);
    assert!(two.values().len() <= 2);
}

#[test]
fn logarithmic_ticks_are_round_numbers() {
    let shown = |ends: [f64; 2]| Ticks::of_decades(ends).labels;
    assert_eq!(
        shown([0.9, 120.0]),
        ["1", "2", "5", "10", "20", "50", "100"]
    );
    assert_eq!(
        shown([5e-6, 11.0]),
        ["1e-5", "1e-4", "0.001", "0.01", "0.1", "1", "10"]
    );
    assert!(shown([1e-300, 1e300]).len() <= 11);
}
