//! The laws of the rules in `ball.rs` for numbers in [−1, 1], as those of `ball_laws.rs`.

use super::super::draw::Draw;
use super::laws::{CASES, Tightness, for_widths, one, ulps};
use super::*;
use crate::exact::Rational;
use crate::poly::TrigPolynomial;

/// In units of 2^(−64W).
fn units<const W: usize>(value: &Signed<W>) -> Rational {
    let size = Rational::from(value.size.to_integer());
    if value.is_negative { -size } else { size }
}

for_widths!(quotients_are_inside);
for_widths!(products_are_inside);
for_widths!(rotations_are_inside);
for_widths!(sums_of_products_are_inside);

mod all {
    use super::*;

    /// A ball that holds a number in [−1, 1], and one of those.
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
            let truth = Rational::new(p << (64 * W as u64), q).expect("not 0");
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
            // tan(θ/2) = p/q
            let (p, q) = (draw.integer(2), draw.integer(2));
            let (pp, qq) = (&p * &p, &q * &q);
            let (w, u, v) = (&qq + &pp, &qq - &pp, &p * &q * Integer::from(2));
            if w == 0 {
                continue;
            }
            let last = 1 + draw.below(40);
            let tables = rotations([&u, &v].map(|c| UnitBall::<W>::quotient(c, &w)), last);
            let [c, s] = [u, v].map(|n| Rational::new(n, w.clone()).expect("not 0"));
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
                sum + truth * &Rational::from(c)
            });
            tightness.check(&(truth * scale), &ulps(ball.mid), ball.radius);
        }
        tightness.is_at_least(0.4);
    }
}
