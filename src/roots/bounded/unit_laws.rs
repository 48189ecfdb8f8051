//! The laws of the rules in `unit.rs`, in the manner of `ball_laws.rs`.

use super::super::ball::laws::{CASES, Tightness, exact, for_widths, is_just, one, ulps};
use super::super::draw::Draw;
use super::*;
use crate::exact::Rational;
use crate::poly::TrigPolynomial;

/// The number in units of 2^(−64W).
fn units<const W: usize>(value: &Signed<W>) -> Rational {
    let size = Rational::whole(value.size.to_integer());
    if value.is_negative { -size } else { size }
}

for_widths!(quotients_are_inside);
for_widths!(products_are_inside);
for_widths!(rotations_are_inside);
for_widths!(errors_of_steps_are_multiplied);
for_widths!(sums_of_products_are_inside);
for_widths!(doubles_are_inside);
for_widths!(quotients_of_balls_are_inside);
for_widths!(roots_are_inside);
for_widths!(sums_are_inside);
for_widths!(shifts_are_inside);
for_widths!(digits_are_inside);

mod all {
    use super::*;

    /// A ball that holds a number in [−1, 1], and such a number.
    fn unit_ball<const W: usize>(draw: &mut Draw) -> (UnitBall<W>, Rational) {
        let size = if draw.below(2) == 0 {
            Fraction::LARGEST
        } else {
            draw.fraction()
        };
        let mid = Signed {
            size,
            is_negative: draw.below(2) == 0,
        };
        let radius = draw.radius();
        let unit = Rational::from_dyadic(Integer::from(1), 64 * W as i64);
        let truth = draw.held(&units(&mid), radius);
        (UnitBall { mid, radius }, truth.min(unit.clone()).max(-unit))
    }

    pub(super) fn quotients_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES {
            let (p, q) = (draw.integer(W + 2), draw.integer(W + 2));
            let (p, q) = if p.unsigned_abs_ref() > q.unsigned_abs_ref() {
                (q, p)
            } else {
                (p, q)
            };
            if q == 0 {
                continue;
            }
            let ball = UnitBall::<W>::quotient(&p, &q);
            let truth = Rational::from_integers(p << (64 * W as u64), q).expect("not 0");
            tightness.check(&truth, &units(&ball.mid), ball.radius);
        }
        tightness.is_at_least(0.99);
    }

    pub(super) fn products_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES {
            let ((a, x), (b, y)) = (unit_ball::<W>(draw), unit_ball::<W>(draw));
            let product = a.times(&b);
            let truth = x * y * Rational::from_dyadic(Integer::from(1), -(64 * W as i64));
            tightness.check(&truth, &units(&product.mid), product.radius);
        }
        tightness.is_at_least(0.99);
    }

    pub(super) fn rotations_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES / 40 {
            // The angle with tan(θ/2) = p/q.
            let (p, q) = (draw.integer(2), draw.integer(2));
            let (pp, qq) = (&p * &p, &q * &q);
            let (w, u, v) = (&qq + &pp, &qq - &pp, &p * &q * Integer::from(2));
            if w == 0 {
                continue;
            }
            let last = 1 + draw.below(40);
            let tables = rotations([&u, &v].map(|c| UnitBall::<W>::quotient(c, &w)), last);
            let [c, s] = [u, v].map(|n| Rational::from_integers(n, w.clone()).expect("not 0"));
            for m in [last, draw.below(last + 1)] {
                let index = i32::try_from(m).expect("small");
                let truths = [TrigPolynomial::cosine(index), TrigPolynomial::sine(index)];
                for (table, truth) in tables.iter().zip(truths) {
                    let truth = truth.evaluate(&c, &s)
                        * Rational::from_dyadic(Integer::from(1), 64 * W as i64);
                    tightness.check(&truth, &units(&table[m].mid), table[m].radius);
                }
            }
        }
        tightness.is_at_least(0.99);
    }

    /// The step is a quarter of a turn. Its cosine is too large by much more than roundings, and the radii are those of Lemma
    /// 12.
    pub(super) fn errors_of_steps_are_multiplied<const W: usize>(draw: &mut Draw) {
        let width = 64 * W as u64;
        let last = 12;
        for _ in 0..CASES / 40 {
            let bits = draw.word() % (width - 8);
            let size =
                Fraction::quotient(&(Integer::from(1) << bits), &(Integer::from(1) << width));
            let off = power_of_two(i64::try_from(bits).expect("small"));
            let cos = UnitBall::<W> {
                mid: Signed {
                    size,
                    is_negative: draw.below(2) == 0,
                },
                radius: off,
            };
            let sin = UnitBall {
                mid: Signed::LARGEST,
                radius: if draw.below(2) == 0 {
                    1.0
                } else {
                    1.0 + draw.radius()
                },
            };
            let tables = rotations([cos, sin], last);
            let step = exact(cos.radius) + exact(sin.radius);
            let mut radius = step.clone();
            for m in 1..=last {
                let truths = [[1, 0, -1, 0][m % 4], [0, 1, 0, -1][m % 4]];
                let mut tightness = Tightness::default();
                for (table, truth) in tables.iter().zip(truths) {
                    let truth = Rational::from_dyadic(Integer::from(truth), 64 * W as i64);
                    tightness.check(&truth, &units(&table[m].mid), table[m].radius);
                    is_just(table[m].radius, &radius);
                }
                // If the other errors are small, some coordinate has nearly the largest error.
                if off > 1e4 * sin.radius && off > 1e4 * float(W) {
                    tightness.is_at_least(0.95);
                }
                let longer = Rational::one()
                    + &radius * &Rational::from_dyadic(Integer::from(1), -64 * W as i64);
                radius = &radius + &(&step * &longer) + Rational::from(3 * W as i64 + 1);
            }
        }
    }

    pub(super) fn sums_of_products_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES / 10 {
            let count = 1 + draw.below(30);
            let cancels = draw.below(2) == 0;
            let integers: Vec<Integer> = (0..count).map(|_| draw.integer(W + 2)).collect();
            let (values, truths): (Vec<_>, Vec<_>) =
                (0..count).map(|_| unit_ball::<W>(draw)).unzip();
            let values: UnitBalls<W> = values.into_iter().collect();
            let (coefficients, exponent) = Coefficients::of_integers(integers.iter());
            let ball = coefficients.combination(
                &values,
                (0..count).map(|i| if cancels { i } else { count - 1 - i }),
            );
            let scale =
                Rational::from_dyadic(Integer::from(1), -exponent - 64 * W as i64) * one::<W>();
            let terms = integers.iter().enumerate();
            let truth = terms.fold(Rational::zero(), |sum, (i, c)| {
                let truth = &truths[if cancels { i } else { count - 1 - i }];
                sum + truth * &Rational::whole(c)
            });
            tightness.check(&(truth * scale), &ulps(ball.mid), ball.radius);
            // The radius is that of Lemma 14.
            let of_values = exact(values.radius) * Rational::from(64) / Rational::from(256);
            let rounding = Rational::from((W * count) as i64);
            is_just(
                ball.radius,
                &(of_values + exact(coefficients.radius) + rounding),
            );
        }
        tightness.is_at_least(0.4);
    }

    pub(super) fn doubles_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES {
            let bits = draw.word() >> 12;
            let exponent = 1022 - draw.word() % (100 * W as u64).min(1000);
            let size = f64::from_bits(exponent << 52 | bits);
            let value = if draw.below(2) == 0 { size } else { -size };
            let ball = UnitBall::<W>::of_double(value);
            let truth = exact(value) * Rational::from_dyadic(Integer::from(1), 64 * W as i64);
            tightness.check(&truth, &units(&ball.mid), ball.radius);
        }
        tightness.is_at_least(0.9);
    }

    pub(super) fn quotients_of_balls_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        let unit = Rational::from_dyadic(Integer::from(1), 64 * W as i64);
        for _ in 0..CASES {
            let ((a, x), (b, y)) = (unit_ball::<W>(draw), unit_ball::<W>(draw));
            let Some(quotient) = a.over(&b) else { continue };
            assert!(y.signum() > 0, "a positive divisor");
            let truth = x / y * &unit;
            if truth.abs() <= unit {
                tightness.check(&truth, &units(&quotient.mid), quotient.radius);
            }
        }
        tightness.is_at_least(0.9);
    }

    /// The truth is a fraction, and the ball holds its square.
    pub(super) fn roots_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES / 4 {
            let root: Fraction<W> = draw.fraction();
            let ball = UnitBall {
                mid: Signed {
                    size: root.times(&root),
                    is_negative: false,
                },
                radius: float(W) + draw.radius(),
            };
            let Some(found) = ball.root() else { continue };
            let truth = Rational::whole(root.to_integer());
            tightness.check(&truth, &units(&found.mid), found.radius);
        }
        tightness.is_at_least(0.1);
    }

    pub(super) fn sums_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        let unit = Rational::from_dyadic(Integer::from(1), 64 * W as i64);
        for _ in 0..CASES {
            let ((a, x), (b, y)) = (unit_ball::<W>(draw), unit_ball::<W>(draw));
            let truth = x + y;
            if truth.abs() <= unit {
                let sum = a.plus(&b);
                tightness.check(&truth, &units(&sum.mid), sum.radius);
            }
        }
        tightness.is_at_least(0.99);
    }

    pub(super) fn shifts_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES {
            let (a, x) = unit_ball::<W>(draw);
            let bits = u32::try_from(draw.below(80)).expect("small");
            let ball = a.shifted_down(bits);
            let truth = x * Rational::from_dyadic(Integer::from(1), -i64::from(bits));
            tightness.check(&truth, &units(&ball.mid), ball.radius);
        }
        tightness.is_at_least(0.9);
    }

    pub(super) fn digits_are_inside<const W: usize>(draw: &mut Draw) {
        let mut tightness = Tightness::default();
        for _ in 0..CASES {
            let (a, x) = unit_ball::<W>(draw);
            if a.mid.is_negative {
                continue;
            }
            let bits = u32::try_from(draw.below(64)).expect("small");
            let (whole, ball) = a.digits(bits);
            let scaled = Rational::from_dyadic(Integer::from(1), i64::from(bits));
            let unit = Rational::from_dyadic(Integer::from(1), 64 * W as i64);
            let truth = x * scaled - Rational::whole(Integer::from(whole)) * &unit;
            tightness.check(&truth, &units(&ball.mid), ball.radius);
            // The midpoint itself is exact, and the ends are those of the ball.
            let [low, high] = ball.bounds();
            assert_eq!(
                (&high - &low) * &unit,
                exact(ball.radius) * Rational::from(2)
            );
            assert_eq!((high + low) * unit, units(&ball.mid) * Rational::from(2));
        }
        tightness.is_at_least(0.99);
    }
}
