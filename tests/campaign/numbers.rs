//! Rounding, decimals, literals, and the arithmetic of rational and dyadic numbers, against num-rational.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use stellate::exact::{Dyadic, Rational, double_literal, exact_literal, hex_literal};

use super::draw::Draw;
use super::exact::{Q, integer, nearest, num, our, power_of_two, value, whole};
use super::harness::Outcome;
use super::roots::decimal;

/// A number where rounding to a double is hard: at and beside midpoints, subnormal, at the largest double.
fn hard_for_doubles(draw: &mut Draw) -> Q {
    let near = match draw.below(5) {
        0 => f64::from_bits(draw.below(1 << 53)),
        1 => f64::MAX.next_down(),
        2 => f64::from_bits(1 + draw.below(3)),
        _ => draw.double(1000),
    };
    match draw.below(4) {
        0 => {
            let bits = 1 + draw.below(200);
            Q::new(draw.integer(bits), draw.natural(bits))
        }
        1 => value(near) * (Q::one() + draw.tiny()),
        _ => {
            let next = near.next_up();
            let above = if next.is_finite() {
                value(next)
            } else {
                power_of_two(1024)
            };
            let middle = (value(near) + above) / whole(2);
            &middle + &middle * draw.tiny()
        }
    }
}

pub(crate) fn doubles(draw: &mut Draw) -> Outcome {
    let mut q = hard_for_doubles(draw);
    if draw.once_in(40) {
        q = power_of_two(1024) - power_of_two(970) * (Q::one() + draw.tiny());
    }
    if draw.once_in(2) {
        q = -q;
    }
    draw.input = format!("{q}");
    let (got, expected) = (our(&q).to_f64(), nearest(&q));
    assert_eq!(got, expected);
    if got.is_finite() {
        assert_eq!(num(&Rational::try_from(got).unwrap()), value(got));
    }
    Outcome::Checked
}

fn ten(e: i64) -> Q {
    let power = Q::from_integer(BigInt::from(10).pow(e.unsigned_abs() as u32));
    if e < 0 { power.recip() } else { power }
}

/// The nearest integer, ties to even.
fn rounded(q: &Q) -> BigInt {
    let floor = q.floor().to_integer();
    let rest = q - Q::from_integer(floor.clone());
    let half = Q::new(1.into(), 2.into());
    let odd = !(&floor % BigInt::from(2)).is_zero();
    if rest > half || rest == half && odd {
        floor + 1
    } else {
        floor
    }
}

pub(crate) fn decimals(draw: &mut Draw) -> Outcome {
    let digits = draw.below(40) as u32;
    let q = match draw.below(4) {
        // A midpoint of decimals, or beside it.
        0 | 1 => {
            let bits = 1 + draw.below(130);
            let odd = draw.integer(bits) * 2 + 1;
            let middle = Q::from_integer(odd) / whole(2) * ten(-i64::from(digits));
            &middle + &middle * draw.tiny()
        }
        // A power of ten, or beside it.
        2 => {
            let power = ten(draw.small(40));
            &power + &power * draw.tiny()
        }
        _ => draw.rational(),
    };
    draw.input = format!("{q} with {digits} digits");
    let ours = our(&q);
    let scaled = rounded(&(&q * ten(i64::from(digits))));
    let text = scaled.abs().to_string();
    let text = format!("{text:0>width$}", width = digits as usize + 1);
    let (head, tail) = text.split_at(text.len() - digits as usize);
    let sign = if scaled.is_negative() { "-" } else { "" };
    let point = if tail.is_empty() { "" } else { "." };
    assert_eq!(
        ours.to_decimal(digits),
        format!("{sign}{head}{point}{tail}")
    );
    let expected = Q::from_integer(scaled) * ten(-i64::from(digits));
    assert_eq!(num(&ours.round_decimals(digits)), expected);
    assert_eq!(num(&ours.floor()), q.floor());
    if q.is_zero() {
        assert_eq!(ours.decimal_exponent(), None);
        return Outcome::Checked;
    }
    let exponent = ours.decimal_exponent().unwrap();
    assert!(
        ten(exponent) <= q.abs() && q.abs() < ten(exponent + 1),
        "10^{exponent}"
    );
    let digits = 1 + draw.below(30) as u32;
    let unit = exponent + 1 - i64::from(digits);
    let expected = Q::from_integer(rounded(&(q.abs() * ten(-unit)))) * ten(unit);
    let shown = ours.to_significant(digits);
    assert_eq!(
        decimal(&shown),
        expected * q.signum(),
        "{shown} of {digits} digits"
    );
    Outcome::Checked
}

/// Decimal text, with its value.
pub(crate) fn decimal_text(draw: &mut Draw) -> String {
    let digits = |draw: &mut Draw| {
        let most = if draw.once_in(5) { 60 } else { 18 };
        let count = draw.below(most);
        let digit = |draw: &mut Draw| match draw.below(4) {
            0 => '0',
            1 => '9',
            _ => char::from(b'0' + draw.below(10) as u8),
        };
        (0..count).map(|_| digit(draw)).collect::<String>()
    };
    if draw.once_in(4) {
        // All digits of a midpoint of two doubles, or of a number next to it.
        let near = draw.double(60).abs();
        let middle = (value(near) + value(near.next_up())) / whole(2);
        let places = middle.denom().bits() as u32;
        let mut text = our(&middle).to_decimal(places);
        match draw.below(3) {
            0 => text.push('1'),
            1 => {
                let last = text.pop().unwrap();
                text.push(if last == '0' { '0' } else { '4' });
                text.push('9');
            }
            _ => {}
        }
        return text;
    }
    let head = digits(draw);
    let tail = digits(draw);
    let head = if head.is_empty() { "0".into() } else { head };
    let point = if tail.is_empty() { "" } else { "." };
    let exponent = match draw.below(6) {
        0 => format!("e{}", draw.small(330)),
        1 => format!("E+{}", draw.below(20)),
        2 => format!("e-0{}", draw.below(20)),
        _ => String::new(),
    };
    format!("{head}{point}{tail}{exponent}")
}

fn value_of_decimal(text: &str) -> Q {
    decimal(&text.to_lowercase().replace("e+", "e"))
}

pub(crate) fn literals(draw: &mut Draw) -> Outcome {
    match draw.below(4) {
        0 => {
            // A hexadecimal float, back and forth.
            let double = match draw.below(3) {
                0 => f64::from_bits(draw.below(1 << 52)),
                _ => draw.double(1000),
            };
            let text = hex_literal(double);
            draw.input = text.clone();
            assert_eq!(num(&exact_literal(&text).unwrap()), value(double));
            let read = double_literal(&text).unwrap().to_f64();
            assert_eq!(read.to_bits(), double.to_bits());
        }
        1 => {
            let [p, q] = [decimal_text(draw), decimal_text(draw)];
            draw.input = format!("{p}/{q}");
            let bottom = value_of_decimal(&q);
            let read = exact_literal(&draw.input);
            if bottom.is_zero() {
                assert!(read.is_err(), "a denominator 0");
            } else {
                assert_eq!(num(&read.unwrap()), value_of_decimal(&p) / bottom);
            }
        }
        _ => {
            let text = decimal_text(draw);
            draw.input = text.clone();
            assert_eq!(num(&exact_literal(&text).unwrap()), value_of_decimal(&text));
            let double: f64 = text.parse().unwrap();
            match double_literal(&text) {
                Ok(read) => assert_eq!(read.to_f64(), double),
                Err(_) => assert!(double.is_infinite()),
            }
        }
    }
    Outcome::Checked
}

pub(crate) fn rationals(draw: &mut Draw) -> Outcome {
    let [p, q] = [draw.rational(), draw.rational()];
    draw.input = format!("{p} and {q}");
    let (a, b) = (our(&p), our(&q));
    assert_eq!(num(&(&a + &b)), &p + &q);
    assert_eq!(num(&(&a - &b)), &p - &q);
    assert_eq!(num(&(&a * &b)), &p * &q);
    assert_eq!(a.cmp(&b), p.cmp(&q));
    assert_eq!(a.signum(), super::exact::sign(p.numer()));
    assert_eq!(num(&a.abs()), p.abs());
    assert_eq!(a.to_string(), p.to_string());
    assert_eq!(a.to_string().parse::<Rational>().unwrap(), a);
    assert_eq!(a.bits(), p.numer().bits().max(p.denom().bits()));
    if !q.is_zero() {
        assert_eq!(num(&(&a / &b)), &p / &q);
    }
    let k = draw.small(6);
    match a.pow(k) {
        None => assert!(p.is_zero() && k < 0),
        Some(power) => {
            let product = (0..k.abs()).fold(Q::one(), |product, _| product * &p);
            let expected = if k < 0 { product.recip() } else { product };
            assert_eq!(num(&power), expected);
        }
    }
    assert_eq!((&a * &a).sqrt(), Some(a.abs()));
    if let Some(root) = a.sqrt() {
        assert_eq!(&root * &root, a);
    }
    // No fraction with a smaller denominator lies between.
    let (low, high) = if p <= q { (&p, &q) } else { (&q, &p) };
    let simplest = num(&Rational::simplest_between(&a, &b));
    assert!(*low <= simplest && simplest <= *high);
    if simplest.denom().bits() < 12 {
        let bound = u64::try_from(simplest.denom().clone()).unwrap();
        for d in 1..bound {
            let scale = Q::from_integer(d.into());
            assert!((high * &scale).floor() < low * &scale, "over {d}");
        }
    }
    Outcome::Checked
}

pub(crate) fn dyadics(draw: &mut Draw) -> Outcome {
    let number = |draw: &mut Draw| {
        let bits = 1 + draw.below(200);
        let (mantissa, exponent) = (draw.integer(bits), draw.small(300));
        let mantissa = if draw.once_in(10) {
            BigInt::zero()
        } else {
            mantissa
        };
        let ours = Dyadic::new(integer(&mantissa), exponent);
        (ours, Q::from_integer(mantissa) * power_of_two(exponent))
    };
    let (a, p) = number(draw);
    let (b, q) = number(draw);
    draw.input = format!("{p} and {q}");
    let same = |d: &Dyadic, expected: BigRational| assert_eq!(num(&d.to_rational()), expected);
    same(&a, p.clone());
    same(&a.plus(&b), &p + &q);
    same(&a.minus(&b), &p - &q);
    same(&a.negated(), -p.clone());
    same(&a.midpoint(&b), (&p + &q) / whole(2));
    let k = draw.small(100);
    same(&a.times_power_of_two(k), &p * power_of_two(k));
    let n = draw.integer(70);
    same(&a.times_integer(&integer(&n)), &p * Q::from_integer(n));
    let k = draw.below(5) as u32;
    same(
        &a.power(k),
        (0..k).fold(Q::one(), |product, _| product * &p),
    );
    assert_eq!(a.cmp(&b), p.cmp(&q));
    assert_eq!(a.to_f64(), nearest(&p));
    match a.log2() {
        None => assert!(p.is_zero()),
        Some(e) => assert!(power_of_two(e) <= p.abs() && p.abs() < power_of_two(e + 1)),
    }
    Outcome::Checked
}
