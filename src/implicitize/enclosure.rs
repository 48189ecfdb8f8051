//! Enclosures of real numbers by two bounds, in fixed point.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;

use crate::exact::Rational;

/// An enclosed real number x: `low ≤ x·2^bits ≤ high`, where `bits` is that of the [`Precision`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Enclosure {
    low: Integer,
    high: Integer,
}

/// Arithmetic with this many bits after the point.
///
/// Lemma (inclusion). Every operation encloses its exact result for all numbers in the enclosures it is given.
/// Proof. Sums, differences and integers are exact. A product of two intervals is bounded by the products of their bounds,
/// a quotient by an interval without 0 by the quotients of the bounds; these are rounded down for the lower bound and up
/// for the upper one, and division by 2^bits is monotonic.
/// Law: `enclosures_hold_the_exact_results`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Precision {
    pub(super) bits: u64,
}

impl Precision {
    pub(super) fn integer(self, c: &Integer) -> Enclosure {
        let value = c << self.bits;
        Enclosure {
            low: value.clone(),
            high: value,
        }
    }

    /// An enclosure of all numbers between two rational numbers.
    pub(super) fn between(self, low: &Rational, high: &Rational) -> Enclosure {
        let scaled = |q: &Rational| q * &Rational::whole(Integer::from(1) << self.bits);
        Enclosure {
            low: scaled(low).floor_integer(),
            high: -(-scaled(high)).floor_integer(),
        }
    }

    pub(super) fn rational(self, q: &Rational) -> Enclosure {
        self.between(q, q)
    }

    pub(super) fn times(self, a: &Enclosure, b: &Enclosure) -> Enclosure {
        let [low, high] = extreme_products(a, b);
        Enclosure {
            low: low >> self.bits,
            high: -(-high >> self.bits),
        }
    }

    /// The quotient a/b; `None` if b may be 0.
    pub(super) fn over(self, a: &Enclosure, b: &Enclosure) -> Option<Enclosure> {
        b.sign()?;
        let quotients = |round_up: bool| {
            let quotient = |p: &Integer, q: &Integer| {
                let p = p << self.bits;
                let exact = Rational::from_integers(p, q.clone())?;
                Some(if round_up {
                    -(-exact).floor_integer()
                } else {
                    exact.floor_integer()
                })
            };
            Some([
                quotient(&a.low, &b.low)?,
                quotient(&a.low, &b.high)?,
                quotient(&a.high, &b.low)?,
                quotient(&a.high, &b.high)?,
            ])
        };
        let [low, _] = least_and_largest(quotients(false)?);
        let [_, high] = least_and_largest(quotients(true)?);
        Some(Enclosure { low, high })
    }

    /// The bounds of the enclosure as rational numbers.
    pub(super) fn bounds(self, a: &Enclosure) -> [Rational; 2] {
        let unit = Rational::from_dyadic(Integer::from(1), 0)
            / Rational::whole(Integer::from(1) << self.bits);
        [&a.low, &a.high].map(|v| Rational::whole(v) * &unit)
    }

    /// Whether q is outside of the enclosure.
    pub(super) fn excludes(self, a: &Enclosure, q: &Rational) -> bool {
        let [low, high] = self.bounds(a);
        *q < low || high < *q
    }

    /// Eliminates the first K − 1 columns of K rows and returns a non-zero multiple of the row that is left; `None` if some
    /// pivot may be 0.
    ///
    /// The rows are scaled by powers of two and combined, so what vanishes on all of them vanishes on the row that is left,
    /// and its first entry is 0 exactly if the determinant of the first K columns is.
    pub(super) fn last_row(self, mut rows: Vec<Vec<Enclosure>>) -> Option<Vec<Enclosure>> {
        for row in &mut rows {
            self.scale(row);
        }
        let size = rows.len();
        for column in 0..size.checked_sub(1)? {
            let pivot = (column..size)
                .filter(|&i| rows[i][column].sign().is_some_and(|s| s != 0))
                .max_by(|&i, &j| rows[i][column].least().cmp(&rows[j][column].least()))?;
            rows.swap(column, pivot);
            let (done, open) = rows.split_at_mut(column + 1);
            let top = &done[column];
            for row in open.iter_mut().filter(|row| !row[column].is_zero()) {
                let factor = self.over(&row[column], &top[column])?;
                for (entry, above) in row[column..].iter_mut().zip(&top[column..]) {
                    *entry = entry.minus(&self.times(&factor, above));
                }
                row[column] = Enclosure::zero();
            }
        }
        let last = rows.pop()?;
        Some(last[size - 1..].to_vec())
    }

    /// Divides a row by a power of two, so that its largest entry is about 1.
    fn scale(self, row: &mut [Enclosure]) {
        let size = |e: &Enclosure| e.low.significant_bits().max(e.high.significant_bits());
        let largest = row.iter().map(size).max().unwrap_or(0);
        for entry in row {
            *entry = if largest > self.bits {
                let shift = largest - self.bits;
                Enclosure {
                    low: &entry.low >> shift,
                    high: -(-&entry.high >> shift),
                }
            } else {
                let shift = self.bits - largest;
                Enclosure {
                    low: &entry.low << shift,
                    high: &entry.high << shift,
                }
            };
        }
    }
}

impl Enclosure {
    pub(super) fn zero() -> Self {
        Self {
            low: Integer::ZERO,
            high: Integer::ZERO,
        }
    }

    fn is_zero(&self) -> bool {
        self.low == 0 && self.high == 0
    }

    /// The number value/2^bits.
    pub(super) fn fixed(value: &Integer) -> Self {
        Self {
            low: value.clone(),
            high: value.clone(),
        }
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        Self {
            low: &self.low + &other.low,
            high: &self.high + &other.high,
        }
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        Self {
            low: &self.low - &other.high,
            high: &self.high - &other.low,
        }
    }

    /// The sign of the number; `None` if the enclosure holds numbers of different signs.
    pub(super) fn sign(&self) -> Option<i8> {
        match (self.low.sign_of(), self.high.sign_of()) {
            (1, _) => Some(1),
            (_, -1) => Some(-1),
            (0, 0) => Some(0),
            _ => None,
        }
    }

    /// A lower bound of the absolute value, times 2^bits.
    pub(super) fn least(&self) -> Integer {
        match self.sign() {
            Some(1) => self.low.clone(),
            Some(-1) => -&self.high,
            _ => Integer::ZERO,
        }
    }

    /// Whether the two may be the same number.
    pub(super) fn meets(&self, other: &Self) -> bool {
        self.low <= other.high && other.low <= self.high
    }
}

trait SignOf {
    fn sign_of(&self) -> i8;
}

impl SignOf for Integer {
    fn sign_of(&self) -> i8 {
        match self.cmp(&Integer::ZERO) {
            std::cmp::Ordering::Less => -1,
            std::cmp::Ordering::Equal => 0,
            std::cmp::Ordering::Greater => 1,
        }
    }
}

/// The least and the largest product of two members. If a factor has one sign, two products of bounds suffice.
fn extreme_products(a: &Enclosure, b: &Enclosure) -> [Integer; 2] {
    let is_negative = |e: &Enclosure| e.high <= 0;
    let is_positive = |e: &Enclosure| e.low >= 0;
    // Of a factor with one sign, the bound farther from 0 and the bound nearer to 0.
    let (near, far, other, minus) = if is_positive(a) {
        (&a.low, &a.high, b, false)
    } else if is_negative(a) {
        (&a.high, &a.low, b, true)
    } else if is_positive(b) {
        (&b.low, &b.high, a, false)
    } else if is_negative(b) {
        (&b.high, &b.low, a, true)
    } else {
        return least_and_largest([
            &a.low * &b.low,
            &a.low * &b.high,
            &a.high * &b.low,
            &a.high * &b.high,
        ]);
    };
    let low = if is_positive(other) { near } else { far } * &other.low;
    let high = if is_negative(other) { near } else { far } * &other.high;
    if minus { [high, low] } else { [low, high] }
}

fn least_and_largest([first, rest @ ..]: [Integer; 4]) -> [Integer; 2] {
    let mut bounds = [first.clone(), first];
    for value in rest {
        if value < bounds[0] {
            bounds[0] = value;
        } else if value > bounds[1] {
            bounds[1] = value;
        }
    }
    bounds
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Numbers of either sign with many bits below the precision, also near 0 and near powers of two.
    fn number() -> impl Strategy<Value = Rational> {
        let small = (-40i64..41, -90i64..20, -3i64..4).prop_map(|(m, e, d)| {
            Rational::from_dyadic(Integer::from(m), e)
                + Rational::from_dyadic(Integer::from(d), -130)
        });
        let fraction =
            (-1000i64..1000, 1i64..1000).prop_map(|(p, q)| Rational::from(p) / Rational::from(q));
        prop_oneof![small, fraction]
    }

    proptest! {
        #[test]
        fn enclosures_hold_the_exact_results(a in number(), b in number(), more in number(), bits in 1u64..80) {
            let precision = Precision { bits };
            let holds = |e: &Enclosure, q: &Rational| !precision.excludes(e, q);
            let wide = a.clone().max(&a + &more);
            let narrow = a.clone().min(&a + &more);
            let (x, y) = (precision.between(&narrow, &wide), precision.rational(&b));
            for inside in [&a, &wide, &narrow] {
                prop_assert!(holds(&x.plus(&y), &(inside + &b)));
                prop_assert!(holds(&x.minus(&y), &(inside - &b)));
                prop_assert!(holds(&precision.times(&x, &y), &(inside * &b)));
                if let Some(quotient) = precision.over(&x, &y) {
                    prop_assert!(holds(&quotient, &(inside / &b)));
                }
                if let Some(quotient) = precision.over(&y, &x) {
                    prop_assert!(holds(&quotient, &(&b / inside)));
                }
                if let Some(sign) = x.sign() {
                    prop_assert_eq!(sign, inside.signum());
                }
            }
            // The bounds are not much wider than necessary.
            let exact = precision.rational(&a);
            let [low, high] = precision.bounds(&precision.times(&exact, &y));
            let unit = Rational::from(1) / Rational::whole(Integer::from(1) << bits);
            let most = &unit * &(a.abs() + b.abs() + Rational::from(4));
            prop_assert!(high - low <= most);
        }

        /// Bounds of all signs.
        #[test]
        fn products_of_intervals_reach_from_the_least_to_the_largest(bounds in prop::array::uniform4(-3i64..4)) {
            let [a, b, c, d] = bounds;
            let interval = |a: i64, b: i64| Enclosure { low: a.min(b).into(), high: a.max(b).into() };
            let (x, y) = (interval(a, b), interval(c, d));
            let products = [&x.low * &y.low, &x.low * &y.high, &x.high * &y.low, &x.high * &y.high];
            prop_assert_eq!(extreme_products(&x, &y), least_and_largest(products));
        }

        #[test]
        fn what_is_left_of_a_matrix_is_its_determinant(
            entries in prop::collection::vec(prop::collection::vec(-9i64..10, 4), 3),
        ) {
            let precision = Precision { bits: 100 };
            let rows: Vec<Vec<Enclosure>> = entries.iter().map(|row| {
                row.iter().map(|&c| precision.integer(&Integer::from(c))).collect()
            }).collect();
            // The determinant of the first K − 1 columns and the column c.
            let det = |c: usize| -> i64 {
                let e = |i: usize, j: usize| entries[i][[0, 1, c][j]];
                e(0, 0) * (e(1, 1) * e(2, 2) - e(1, 2) * e(2, 1))
                    - e(0, 1) * (e(1, 0) * e(2, 2) - e(1, 2) * e(2, 0))
                    + e(0, 2) * (e(1, 0) * e(2, 1) - e(1, 1) * e(2, 0))
            };
            let expected = [det(2), det(3)];
            if let Some(row) = precision.last_row(rows) {
                prop_assert_eq!(row.len(), 2);
                for (entry, det) in row.iter().zip(expected) {
                    prop_assert!(entry.sign().is_none_or(|s| (s == 0) == (det == 0)));
                }
                // The ratio of two entries is that of the determinants.
                if let Some(ratio) = precision.over(&row[1], &row[0]) {
                    let exact = Rational::from(expected[1]) / Rational::from(expected[0]);
                    prop_assert!(!precision.excludes(&ratio, &exact));
                }
            }
        }
    }
}
