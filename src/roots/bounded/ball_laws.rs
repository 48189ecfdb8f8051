//! The laws of the rules in `ball.rs`. For all numbers that the operands hold, the result holds the exact result. And no radius
//! is much too large, because for some input the error is nearly the radius.
//!
//! The limbs of the inputs are all ones, all zeros, single bits, or next to a power of two, so that every cut loses as much as
//! it can; and some midpoints cancel. The numbers that a ball holds are taken at its ends, at its middle, and between.

use malachite::Natural;

use super::super::draw::Draw;
use super::*;
use crate::bigint::binomials;
use crate::exact::Rational;

/// The number of inputs for each law and width.
pub(crate) const CASES: usize = 2000;

impl Draw {
    /// A radius of 0, of some ulps, or much larger, with few bits or with all of them.
    pub(crate) fn radius(&mut self) -> f64 {
        match self.below(5) {
            4 => f64::from_bits((1023 + 50 + self.word() % 20) << 52 | self.word() >> 12),
            0 => 0.0,
            1 => float(1 + self.below(4)),
            2 => float(self.below(1000)) / 8.0,
            _ => power_of_two(self.below(70) as i64) * 1.75,
        }
    }

    /// A ball with a midpoint of size below 2^room.
    fn ball<const W: usize>(&mut self, room: i64) -> Ball<W> {
        let (size, _) =
            Fixed::of_integer(&Integer::from(self.natural::<W>()), 64 * W as i64 - room);
        let mid = if self.below(2) == 0 {
            size
        } else {
            size.negated()
        };
        Ball {
            mid,
            radius: self.radius(),
        }
    }

    /// A number that a ball with this midpoint and radius holds.
    pub(crate) fn held(&mut self, mid: &Rational, radius: f64) -> Rational {
        let off = exact(radius) * Rational::from([-1, 1, 0, 1][self.below(4)]);
        match self.below(3) {
            0 => mid + off * Rational::from(self.below(100) as i64) / Rational::from(100),
            _ => mid + off,
        }
    }
}

/// A few ulps, as a radius.
fn ulps_of(count: i64) -> f64 {
    float(usize::try_from(count).expect("a radius is not negative"))
}

/// The exact value of a double.
pub(crate) fn exact(value: f64) -> Rational {
    Rational::try_from(value).expect("a finite double")
}

/// The number in ulps.
pub(crate) fn ulps<const W: usize>(value: Fixed<W>) -> Rational {
    let size = Rational::whole(Integer::from(Natural::from_limbs_asc(&value.magnitude())));
    if value.is_negative() { -size } else { size }
}

/// The exact value of a fraction.
pub(crate) fn number<const W: usize>(fraction: &Fraction<W>) -> Rational {
    Rational::from_dyadic(fraction.to_integer(), -(64 * W as i64))
}

/// The number of ulps in 1, which is 2^(64W − 8).
pub(crate) fn one<const W: usize>() -> Rational {
    Rational::from_dyadic(Integer::from(1), Fixed::<W>::FRACTION_BITS)
}

/// The largest quotient of an error and its radius so far.
#[derive(Default)]
pub(crate) struct Tightness(f64);

impl Tightness {
    /// Checks that the ball with this midpoint and radius holds the true value.
    pub(crate) fn check(&mut self, truth: &Rational, mid: &Rational, radius: f64) {
        let error = (truth - mid).abs();
        assert!(
            error <= exact(radius),
            "{truth} is not within {radius} of {mid}"
        );
        if radius > 0.0 {
            self.0 = self.0.max((error / exact(radius)).to_f64());
        }
    }

    /// Checks that some error had this share of its radius, so that no radius is much too large.
    pub(crate) fn is_at_least(&self, share: f64) {
        assert!(
            self.0 >= share,
            "no error is more than {} of its radius",
            self.0
        );
    }
}

/// Checks that a radius is at least the bound of a lemma, and hardly more.
pub(crate) fn is_just(radius: f64, lemma: &Rational) {
    let slack = Rational::one() + Rational::from_dyadic(Integer::from(1), -30);
    let radius = exact(radius);
    assert!(
        *lemma <= radius && radius <= lemma * &slack,
        "{radius} is not {lemma}"
    );
}

/// Runs a law for several widths.
macro_rules! for_widths {
    ($law:ident) => {
        for_widths!($law, 2 3 4 6 12);
    };
    ($law:ident, $($width:literal)*) => {
        #[test]
        fn $law() {
            $( all::$law::<$width>(&mut Draw($width)); )*
        }
    };
}
pub(crate) use for_widths;

for_widths!(integers_are_inside);
for_widths!(a_shift_keeps_the_number_inside);
for_widths!(means_keep_the_numbers_inside);
for_widths!(a_sign_is_that_of_all_numbers_inside);
for_widths!(aligned_numbers_are_inside);
for_widths!(partial_sums_change_as_often_as_is_said);
for_widths!(values_are_inside);
for_widths!(bernstein_coefficients_are_inside);
for_widths!(halves_are_inside);

mod all {
    use super::*;

    pub(crate) fn integers_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES {
            let value = draw.integer(W + 3);
            let exponent = Fixed::<W>::bits_of(&value) - 7 + 1 + draw.below(90) as i64;
            let ball = Ball::<W>::of_integer(&value, exponent);
            let truth = Rational::from_dyadic(value, -exponent) * one::<W>();
            tightness.check(&truth, &ulps(ball.mid), ball.radius);
            assert_eq!(ball.radius == 0.0, truth == ulps(ball.mid));
            // Integers with all leading bits, shifted by any number of them.
            let value = draw.integer(W + 3);
            let bits = Fixed::<W>::bits_of(&value);
            let mut scaled = ScaledBall::<W>::of_integer(&value);
            assert_eq!(scaled.log2(), (value != 0).then_some(bits));
            let down = draw.below(60) as i64;
            scaled.ball.mid = scaled.ball.mid.shifted_down(down);
            assert_eq!(scaled.log2(), (value != 0).then_some(bits - down));
        }
        tightness.is_at_least(0.99);
    }

    pub(crate) fn a_shift_keeps_the_number_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES {
            let ball = draw.ball::<W>(-70);
            let shift = draw.below(141) as i64 - 70;
            let truth = draw.held(&ulps(ball.mid), ball.radius);
            let shifted = ball.mid.shifted_down(shift);
            let radius = radius_after_shift(ball.radius, shift);
            // A shift upwards, or none, cuts nothing.
            assert!(shift > 0 || ball.radius > 0.0 || radius == 0.0);
            assert!(shift > 0 || radius <= ball.radius * power_of_two(-shift) * SLACK);
            let truth = truth * Rational::from_dyadic(Integer::from(1), -shift);
            tightness.check(&truth, &ulps(shifted), radius);
        }
        tightness.is_at_least(0.99);
    }

    pub(crate) fn means_keep_the_numbers_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES {
            let (a, b) = (draw.ball::<W>(5), draw.ball::<W>(5));
            let [x, y] = [a, b].map(|ball| draw.held(&ulps(ball.mid), ball.radius));
            let truth = (x + y) / Rational::from(2);
            tightness.check(
                &truth,
                &ulps(a.mid.mean(b.mid)),
                radius_of_mean(a.radius, b.radius),
            );
        }
        tightness.is_at_least(0.99);
    }

    pub(crate) fn a_sign_is_that_of_all_numbers_inside<const W: usize>(draw: &mut Draw) {
        let mut known = 0;
        for _ in 0..CASES {
            // The midpoints are about as large as the radius, and the radii are near integers.
            let bits = Fixed::<W>::FRACTION_BITS.unsigned_abs();
            let size = match draw.below(3) {
                0 => Integer::from(draw.below(1000)),
                1 => Integer::from(1) << (draw.word() % bits),
                _ => draw.integer(W) >> (8 + draw.word() % (bits - 64)),
            };
            let (mid, _) = Fixed::<W>::of_integer(&size, Fixed::<W>::FRACTION_BITS);
            let near = ulps(mid).abs().to_f64();
            let others = [
                near.next_down(),
                near.next_up(),
                near - 0.5,
                near + 0.5,
                near / 2.5,
                near / 9.0,
            ];
            let radius = match draw.below(8) {
                0 => f64::INFINITY,
                1 => f64::NAN,
                2 => near,
                _ => others[draw.below(others.len())].max(0.0),
            };
            let sign = Ball { mid, radius }.sign();
            let is_one_sign = radius.is_finite() && ulps(mid).abs() > exact(radius);
            let expected = is_one_sign.then_some(if mid.is_negative() { -1 } else { 1 });
            if radius < LARGE_RADIUS || !is_one_sign {
                assert_eq!(sign, expected, "{mid:?} {radius}");
            } else {
                // The numbers of bits decide unless the sizes are within a factor of 4.
                assert!(
                    sign == expected || sign.is_none() && exact(4.0 * radius) > ulps(mid).abs()
                );
            }
            known += usize::from(sign.is_some());
        }
        assert!(known > CASES / 8, "{known}");
    }

    /// For each ball of a list a number that it holds.
    fn held<const W: usize>(draw: &mut Draw, list: &Balls<W>) -> Vec<Rational> {
        let pairs = list.mids.iter().zip(&list.radii);
        let all_at_one_end = draw.below(2) == 0;
        pairs
            .map(|(mid, radius)| {
                if all_at_one_end {
                    ulps(*mid) + exact(*radius)
                } else {
                    draw.held(&ulps(*mid), *radius)
                }
            })
            .collect()
    }

    /// A list in which the sizes of the midpoints add up to at most 64.
    fn list<const W: usize>(draw: &mut Draw, longest: usize) -> Balls<W> {
        let count = 1 + draw.below(longest);
        let room = Fixed::<W>::room_for(count);
        let all_ones = draw.below(2) == 0;
        let balls = (0..count).map(|_| {
            let ball = draw.ball::<W>(room);
            if all_ones {
                let ones = Integer::from(Natural::from_limbs_asc(&[u64::MAX; W]));
                let (mid, _) = Fixed::of_integer(&ones, 64 * W as i64 - room);
                Ball {
                    mid,
                    radius: if draw.below(2) == 0 { 0.0 } else { ball.radius },
                }
            } else {
                ball
            }
        });
        let (mids, radii) = balls.map(|ball| (ball.mid, ball.radius)).unzip();
        Balls::new(mids, radii)
    }

    pub(crate) fn aligned_numbers_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES / 10 {
            let count = 1 + draw.below(40);
            let numbers: Vec<_> = (0..count)
                .map(|_| {
                    let value = if draw.below(5) == 0 {
                        Integer::from(0)
                    } else {
                        draw.integer(W + 2)
                    };
                    (
                        ScaledBall::<W>::of_integer(&value),
                        draw.below(100) as i64 - 50,
                        value,
                    )
                })
                .collect();
            let given = numbers.iter().map(|(number, shift, _)| (*number, *shift));
            let Some(list) = Balls::aligned(given) else {
                assert!(numbers.iter().all(|(_, _, value)| *value == 0));
                continue;
            };
            let sum = list
                .mids
                .iter()
                .fold(Rational::zero(), |sum, mid| sum + ulps(*mid).abs());
            assert!(sum <= one::<W>() * Rational::from(64));
            // The power of two by which all numbers are multiplied.
            let sizes = numbers.iter().filter(|(_, _, value)| *value != 0);
            let top = sizes
                .map(|(_, shift, value)| Fixed::<W>::bits_of(value) + shift)
                .max();
            let top = top.expect("one is not 0") - Fixed::<W>::room_for(count);
            for ((_, shift, value), (mid, radius)) in
                numbers.iter().zip(list.mids.iter().zip(&list.radii))
            {
                let truth = Rational::from_dyadic(value.clone(), shift - top) * one::<W>();
                tightness.check(&truth, &ulps(*mid), *radius);
            }
        }
        tightness.is_at_least(0.99);
    }

    /// Midpoints and radii of a few ulps, so that the signs of many sums are unknown. The numbers are taken at all ends.
    pub(crate) fn partial_sums_change_as_often_as_is_said<const W: usize>(draw: &mut Draw) {
        let mut told = 0;
        for _ in 0..CASES / 4 {
            let count = 1 + draw.below(6);
            let balls: Vec<(i64, i64)> = (0..count)
                .map(|_| (draw.below(41) as i64 - 20, draw.below(5) as i64))
                .collect();
            let mids = balls.iter().map(|(mid, _)| {
                Fixed::of_integer(&Integer::from(*mid), Fixed::<W>::FRACTION_BITS).0
            });
            let radii = balls.iter().map(|(_, radius)| ulps_of(*radius));
            let said = Balls::<W>::new(mids.collect(), radii.collect()).changes_of_partial_sums();
            let expected = match said {
                Changes::None => 0,
                Changes::One => 1,
                Changes::More => continue,
            };
            told += 1;
            for ends in 0..1u32 << count {
                let mut sum = 0;
                let sums = balls.iter().enumerate().map(|(i, (mid, radius))| {
                    sum += mid + if ends >> i & 1 == 0 { *radius } else { -radius };
                    sum
                });
                let signs: Vec<i64> = sums.map(i64::signum).filter(|sign| *sign != 0).collect();
                let changes = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
                assert_eq!(changes, expected, "{balls:?}");
            }
        }
        assert!(told > CASES / 16, "{told}");
    }

    pub(crate) fn values_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES / 10 {
            let list = list::<W>(draw, 30);
            let y = if draw.below(2) == 0 {
                Fraction::LARGEST
            } else {
                draw.fraction::<W>()
            };
            let point = number(&y);
            let truth = held(draw, &list).into_iter().rev();
            let truth = truth.fold(Rational::zero(), |sum, c| sum * &point + c);
            let value = list.value(&y);
            tightness.check(&truth, &ulps(value.mid), value.radius);
            let (again, slope) = list.value_and_slope(&y);
            assert_eq!((again.mid, again.radius), (value.mid, value.radius));
            // The slope is an estimate; its terms have sizes of at most 64 d.
            let terms = list.mids.iter().enumerate().skip(1).rev();
            let expected = terms.fold(Rational::zero(), |sum, (i, c)| {
                sum * &point + ulps(*c) * Rational::from(i as i64)
            });
            let off = (expected / one::<W>()).to_f64() - slope;
            assert!(off.abs() <= 1e-9 * float(list.len()), "{off}");
        }
        tightness.is_at_least(0.99);
    }

    pub(crate) fn bernstein_coefficients_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for case in 0..CASES / 40 {
            let list = list::<W>(draw, if case % 10 == 0 { 120 } else { 20 });
            let degree = list.len() - 1;
            let found = list.to_bernstein(&BernsteinTable::of_degree(degree));
            let c = held(draw, &list);
            let row = binomials(degree);
            for k in 0..=degree {
                let above = binomials(k);
                let terms = c[..=k].iter().zip(above.iter().zip(&row));
                let truth = terms.fold(Rational::zero(), |sum, (c, (above, below))| {
                    let weight = Rational::from_integers(above.clone(), below.clone());
                    sum + c * &weight.expect("a binomial coefficient is not 0")
                });
                tightness.check(&truth, &ulps(found.mids[k]), found.radii[k]);
                // The radius is that of Lemma 9.
                let terms = list.radii[..=k].iter().zip(above.iter().zip(&row));
                let lemma = terms.fold(Rational::from(W as i64 + 2), |sum, (r, (above, below))| {
                    let weight = Rational::from_integers(above.clone(), below.clone());
                    sum + exact(*r) * weight.expect("a binomial coefficient is not 0")
                });
                is_just(found.radii[k], &lemma);
            }
            // The radii are right for −y as well.
            let mut reflected = list.clone();
            reflected.negate_every_second(1);
            let again = reflected.to_bernstein(&BernsteinTable::of_degree(degree));
            assert_eq!(again.radii, found.radii);
        }
        tightness.is_at_least(0.99);
    }

    pub(crate) fn halves_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES / 20 {
            let list = list::<W>(draw, 20);
            let mut truth = held(draw, &list);
            let [low, high] = list.halves();
            for k in 0..truth.len() {
                tightness.check(&truth[0], &ulps(low.mids[k]), low.radii[k]);
                let last = truth.len() - 1;
                tightness.check(&truth[last], &ulps(high.mids[last]), high.radii[last]);
                let pairs = truth.windows(2);
                truth = pairs.map(|p| (&p[0] + &p[1]) / Rational::from(2)).collect();
                if truth.is_empty() {
                    break;
                }
            }
        }
        tightness.is_at_least(0.99);
    }
}

/// A ball whose radius is as large as its midpoint holds 0. The radii include those at which the way to compare them changes.
#[test]
fn no_sign_is_known_where_zero_is_at_the_end() {
    for k in 0..180i64 {
        let mid = Fixed::<3>::of_integer(&(Integer::from(1) << k.unsigned_abs()), 184).0;
        for (mid, expected) in [(mid, 1), (mid.negated(), -1)] {
            let sign = |radius| Ball { mid, radius }.sign();
            let radius = power_of_two(k);
            assert_eq!(sign(radius), None);
            assert_eq!(sign(radius.next_up()), None);
            assert_eq!(sign(radius / 8.0), Some(expected));
        }
    }
}

/// The sum of the radii would be rounded down here, and the sum of the midpoints is between this value and the true sum.
#[test]
fn partial_sums_round_their_radii_up() {
    let number = |n: i64| Fixed::<2>::of_integer(&Integer::from(n), Fixed::<2>::FRACTION_BITS).0;
    let large = 1i64 << 60;
    let mids = vec![number(2 * large), number(-large + 100)];
    let radii = vec![float(1 << 60), float(115)];
    // The sums are 2^61 ± 2^60 and 2^60 + 100 ± (2^60 + 115): the second may be negative.
    let said = Balls::<2>::new(mids, radii).changes_of_partial_sums();
    assert!(matches!(said, Changes::More));
}

/// Lemma 1, for the largest number of roundings.
#[test]
fn sums_of_radii_are_covered() {
    let mut draw = Draw(1);
    for _ in 0..20 {
        let radii: Vec<f64> = (0..4000).map(|_| draw.radius() + 0.1).collect();
        let sum: f64 = radii.iter().sum();
        let truth = radii
            .iter()
            .fold(Rational::zero(), |sum, r| sum + exact(*r));
        assert!(truth <= exact(sum * SLACK));
    }
    // All roundings go down in this sum.
    let sum = (0..4096).fold(1.0, |sum, _| sum + f64::EPSILON * 0.49);
    let truth = Rational::one() + exact(f64::EPSILON * 0.49) * Rational::from(4096);
    assert!(truth > exact(sum) && truth <= exact(sum * SLACK));
}

#[test]
fn powers_of_two_are_not_too_small() {
    for k in -1100i64..=1000 {
        let two = Rational::from_dyadic(Integer::from(1), k);
        assert!(exact(power_of_two(k)) >= two);
        let expected = if k < -1000 {
            power_of_two(-1000)
        } else {
            power_of_two(k)
        };
        assert_eq!(power_of_two(k).to_bits(), expected.to_bits());
        assert!(k < -1000 || exact(expected) == two);
    }
    assert!(power_of_two(1001).is_infinite());
}
