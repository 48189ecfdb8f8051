//! Real roots of univariate polynomials against Sturm counts.

use num_bigint::BigInt;
use num_traits::{One, Zero};
use stellate::poly::squarefree_decomposition;
use stellate::roots::RealRoot;

use super::draw::Draw;
use super::exact::{
    Poly, Q, is_even, num, our, power_of_two, rounding_interval, tower, value, whole,
};
use super::harness::Outcome;

fn linear(root: &Q) -> Poly {
    Poly::new(vec![-root.numer(), root.denom().clone()])
}

/// Polynomials whose roots are hard to tell apart, and random ones.
pub(crate) fn hard(draw: &mut Draw) -> Poly {
    let bits = 1 + draw.below(200);
    match draw.below(8) {
        // Mignotte: x^n − (a x − 1)², two roots very close to 1/a.
        0 => {
            let n = 3 + draw.index(10);
            let a = draw.natural(1 + bits / 8);
            let square = Poly::new(vec![BigInt::from(-1), a]).power(2);
            let mut power = vec![BigInt::zero(); n];
            power.push(BigInt::one());
            Poly::new(power).plus(&square.scaled(&BigInt::from(-1)))
        }
        // Roots 1, …, n, one coefficient changed by 1 half of the time.
        1 => {
            let n = 2 + draw.below(12) as i64;
            let mut f = (1..=n).fold(Poly::of(&[1]), |f, k| f.times(&Poly::of(&[-k, 1])));
            if draw.once_in(2) {
                let place = draw.index(f.0.len() - 1);
                f.0[place] += 1;
            }
            f
        }
        // Known roots 0, 1 or 2 ulps apart or beside midpoints, and multiplicities.
        2 | 3 => {
            let start = draw.double(30);
            let mut f = Poly::of(&[1]);
            for _ in 0..1 + draw.below(4) {
                let at = (0..draw.below(3)).fold(start, |at, _| at.next_up());
                let halfway = (value(at) + value(at.next_up())) / whole(2);
                let root = match draw.below(4) {
                    0 => value(at),
                    1 => draw.rational(),
                    _ => &halfway + &halfway * draw.tiny(),
                };
                let multiplicity = 1 + draw.index(3).min(draw.index(4));
                f = f.times(&linear(&root).power(multiplicity));
            }
            f
        }
        // A square and a little: roots that nearly meet, or nearly exist.
        4 => {
            let coefficients = (0..3 + draw.below(3)).map(|_| draw.integer(bits)).collect();
            let g = Poly::new(coefficients);
            let shift = draw.below(400);
            let constant = Poly::new(vec![BigInt::from(draw.small(1))]);
            g.power(2).scaled(&(BigInt::one() << shift)).plus(&constant)
        }
        // Tiny and huge roots together.
        5 => {
            let coefficients = (0..2 + draw.below(9)).map(|_| {
                let length = 1 + draw.below(600);
                if draw.once_in(3) {
                    BigInt::zero()
                } else {
                    draw.integer(length)
                }
            });
            Poly::new(coefficients.collect())
        }
        _ => {
            let coefficients = (0..2 + draw.below(14)).map(|_| draw.integer(bits));
            Poly::new(coefficients.collect())
        }
    }
}

pub(crate) fn real_roots_of(draw: &mut Draw) -> Outcome {
    let f = hard(draw);
    if f.degree() == 0 {
        return Outcome::Open;
    }
    draw.input = format!("real roots of {:?}", f.0);
    let roots = RealRoot::all_of(&f.to_coefficients());
    let chains = tower(&f);
    assert_eq!(roots.len(), chains[0].count(), "the number of roots");
    for (k, chain) in chains.iter().enumerate() {
        let deep = roots.iter().filter(|root| root.multiplicity() > k);
        assert_eq!(deep.count(), chain.count(), "of multiplicity above {k}");
    }
    for (i, root) in roots.iter().enumerate() {
        let (low, high) = root.bounds();
        let [low, high] = [low, high].map(|d| num(&d));
        let [open, closed] = chains[0].count_open_and_closed(&low, &high);
        // The ends of an open interval may be other roots.
        assert!(
            open == 1 || low == high && closed == 1,
            "an isolating interval"
        );
        // So many roots are at most as large: a point in the interval is compared by the count below it.
        let middle = (&low + &high) / whole(2);
        let below = chains[0].count_up_to(&middle);
        let order = root.cmp_rational(&our(&middle));
        assert_eq!(order.is_le(), below > i, "compared with {middle}");
        assert_eq!(order.is_eq(), below > i && chains[0].vanishes_at(&middle));
        // The nearest double, ties to even.
        let double = root.to_f64();
        if double.is_finite() {
            let [a, b] = rounding_interval(double);
            let rank = |at: &Q, or_equal: bool| {
                let up_to = chains[0].count_up_to(at);
                up_to - usize::from(!or_equal && chains[0].vanishes_at(at))
            };
            let even = is_even(double);
            assert!(
                rank(&a, !even) <= i && i < rank(&b, even),
                "rounded to {double}"
            );
        }
        // Multiplicity, by the chains.
        let deep = chains.iter().filter(|chain| {
            let [open, closed] = chain.count_open_and_closed(&low, &high);
            if low == high { closed > 0 } else { open > 0 }
        });
        assert_eq!(deep.count(), root.multiplicity(), "the multiplicity");
        // Decimals.
        if draw.once_in(4) {
            let digits = draw.below(60) as u32;
            let text = root.to_decimal(digits);
            let shown: Q = decimal(&text);
            let half = Q::new(
                BigInt::one(),
                BigInt::from(2) * BigInt::from(10).pow(digits),
            );
            let [_, closed] = chains[0].count_open_and_closed(&(&shown - &half), &(&shown + &half));
            assert!(closed > 0, "{digits} digits {text}");
            let up_to = chains[0].count_up_to(&(&shown + &half));
            assert!(up_to > i, "{digits} digits {text}");
        }
        if let Some(rational) = root.as_rational() {
            assert_eq!(f.sign_at(&num(&rational)), 0);
            assert!(low <= num(&rational) && num(&rational) <= high);
        }
        assert!(root.is_root_of(&f.to_integers()));
        if let Some(next) = roots.get(i + 1) {
            assert!(!root.is_same(next));
        }
        let mut finer = root.clone();
        finer.refine(80);
        let (a, b) = finer.bounds();
        let [a, b] = [a, b].map(|d| num(&d));
        let [open, closed] = chains[0].count_open_and_closed(&a, &b);
        assert!(open == 1 || a == b && closed == 1, "a refined interval");
        let size = if a < Q::zero() { -b.clone() } else { a.clone() };
        assert!(&b - &a <= size * power_of_two(-78), "refined to 80 bits");
    }
    let product = squarefree_decomposition(&f.to_integers());
    let product = product.iter().fold(Poly::of(&[1]), |product, (k, g)| {
        product.times(&Poly::of_integers(g).power(*k))
    });
    let same = product.primitive();
    let negated = same.scaled(&BigInt::from(-1));
    assert!(
        [same, negated].contains(&f.primitive()),
        "squarefree decomposition"
    );
    Outcome::Checked
}

/// The value of decimal text.
pub(crate) fn decimal(text: &str) -> Q {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let exponent: i64 = exponent.parse().unwrap();
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: BigInt = format!("{whole}{fraction}").parse().unwrap();
    let shift = exponent - fraction.len() as i64;
    let power = BigInt::from(10).pow(shift.unsigned_abs() as u32);
    if shift < 0 {
        Q::new(digits, power)
    } else {
        Q::from_integer(digits * power)
    }
}
