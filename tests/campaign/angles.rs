//! Enclosures of angles and of Fourier radii, against series summed in another way; and the digits that `check` reports.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};
use stellate::check::{Deviation, GivenRadius, Reference, SeriesValues};
use stellate::exact::{arctangent, cosine_and_sine, pi};
use stellate::limits::Limits;
use stellate::shape::FourierRadius;

use super::draw::Draw;
use super::exact::{Q, nearest, num, our, power_of_two, rounding_interval, value};
use super::fourier::any_radius;
use super::harness::Outcome;

/// atan q for q from 0 to 1, times 2^bits, at most `2·bits + 4` too small: Euler's series, whose terms are at most half of
/// those before.
fn small_arctangent(q: &Q, bits: u32) -> BigInt {
    let (p, d) = (q.numer(), q.denom());
    let below = p * p + d * d;
    let mut term: BigInt = ((p * d) << bits) / &below;
    let mut sum = BigInt::zero();
    let mut n = 0u32;
    while !term.is_zero() {
        sum += &term;
        n += 1;
        term = term * (2 * n) * p * p / (&below * (2 * n + 1));
    }
    sum
}

/// Bounds of atan q, about 2^−bits apart.
pub(crate) fn arctangent_bounds(q: &Q, bits: u32) -> [Q; 2] {
    if q.is_negative() {
        let [low, high] = arctangent_bounds(&-q.clone(), bits);
        return [-high, -low];
    }
    if *q > Q::one() {
        let [low, high] = arctangent_bounds(&q.recip(), bits + 2);
        let [a, b] = pi_bounds(bits + 2).map(|p| p / Q::from_integer(2.into()));
        return [a - high, b - low];
    }
    let precision = bits + 40;
    let sum = small_arctangent(q, precision);
    let unit = power_of_two(-i64::from(precision));
    let high = &sum + BigInt::from(4 * precision + 8);
    [Q::from_integer(sum) * &unit, Q::from_integer(high) * unit]
}

pub(crate) fn pi_bounds(bits: u32) -> [Q; 2] {
    arctangent_bounds(&Q::one(), bits + 3).map(|q| q * Q::from_integer(4.into()))
}

/// cos θ and sin θ times 2^bits, each at most 2^20 off: the exponential series, after whole turns are taken away.
fn circle(theta: &Q, bits: u32) -> [BigInt; 2] {
    let more = theta.abs().ceil().to_integer().bits() as u32;
    let [turn, _] = pi_bounds(bits + more + 8).map(|p| p * Q::from_integer(2.into()));
    let turns = (theta / &turn).round();
    let rest = theta - turns * turn;
    // |rest| < 4: terms grow to 4^4/4! < 2^4.
    let one = BigInt::one() << bits;
    let x = (rest * Q::from_integer(one.clone())).floor().to_integer();
    let mut sums = [BigInt::zero(), BigInt::zero()];
    let mut term = one;
    let mut n = 0u32;
    while !term.is_zero() && term != BigInt::from(-1) {
        if n % 4 < 2 {
            sums[n as usize % 2] += &term;
        } else {
            sums[n as usize % 2] -= &term;
        }
        n += 1;
        term = ((term * &x) >> bits) / BigInt::from(n);
    }
    sums
}

pub(crate) fn cosine_and_sine_bounds(theta: &Q, bits: u32) -> [[Q; 2]; 2] {
    let precision = bits + 40;
    let error = BigInt::one() << 24u32;
    circle(theta, precision).map(|v| {
        [&v - &error, v + &error].map(|v| Q::from_integer(v) * power_of_two(-i64::from(precision)))
    })
}

/// An angle: a double, a fraction, small or large, or next to a multiple of π/2.
fn angle(draw: &mut Draw) -> Q {
    match draw.below(5) {
        0 => draw.rational(),
        1 => value(draw.double(30)),
        2 => {
            let [low, _] = pi_bounds(60 + draw.below(100) as u32);
            low / Q::from_integer(2.into()) * Q::from_integer(draw.small(9).into())
        }
        3 => draw.fraction(1_000_000, 1000),
        _ => value(draw.double(5)),
    }
}

pub(crate) fn enclosures(draw: &mut Draw) -> Outcome {
    let most = if draw.once_in(10) { 1500 } else { 200 };
    let bits = 8 + draw.below(most) as u32;
    let q = match draw.below(4) {
        0 => Q::one() + draw.tiny(),
        1 => value(draw.double(60)),
        _ => draw.rational(),
    };
    let theta = angle(draw);
    draw.input = format!("atan {q}, cos and sin of {theta}, {bits} bits");
    let (low, high) = arctangent(&our(&q), bits);
    let [a, b] = arctangent_bounds(&q, bits + 60);
    assert!(num(&low) <= a && b <= num(&high), "atan {q}");
    assert!(num(&high) - num(&low) <= power_of_two(1 - i64::from(bits)));
    let (low, high) = pi(bits);
    let [a, b] = pi_bounds(bits + 60);
    assert!(num(&low) <= a && b <= num(&high), "pi");
    let found = cosine_and_sine(&our(&theta), bits);
    let slack = power_of_two(-i64::from(bits));
    for (found, [a, b]) in found.iter().zip(cosine_and_sine_bounds(&theta, bits + 60)) {
        let found = num(found);
        assert!(
            &found - &slack <= a && b <= found + &slack,
            "cos or sin {theta}"
        );
    }
    Outcome::Checked
}

/// Bounds of r(θ), by products of cos θ + i sin θ in exact arithmetic over doubled precision.
fn radius_bounds(radius: &FourierRadius, theta: &Q, bits: u32) -> [Q; 2] {
    let precision = bits + 40 + 8 * radius.harmonics() as u32;
    let [c, s] = cosine_and_sine_bounds(theta, precision).map(|[low, _]| {
        (low * power_of_two(i64::from(precision)))
            .floor()
            .to_integer()
    });
    let (mut re, mut im) = (BigInt::one() << precision, BigInt::zero());
    let mut sum = Q::zero();
    let mut size = Q::zero();
    for n in 0..=radius.harmonics() {
        let [a, b] = [num(radius.cos(n)), num(radius.sin(n))];
        sum += &a * Q::from_integer(re.clone()) + &b * Q::from_integer(im.clone());
        size += a.abs() + b.abs();
        let next = (&re * &c - &im * &s) >> precision;
        im = (&re * &s + &im * &c) >> precision;
        re = next;
    }
    // Every product multiplies an error of up to 2^(4n) units by at most 2^4.
    let error = size * power_of_two(-i64::from(bits) - 20);
    let middle = sum * power_of_two(-i64::from(precision));
    [&middle - &error, middle + error]
}

pub(crate) fn series(draw: &mut Draw) -> Outcome {
    let radius = any_radius(draw, 6);
    let theta = angle(draw);
    let bits = 20 + draw.below(200) as u32;
    draw.input = format!("{radius:?} at {theta} with {bits} bits");
    let values = SeriesValues::new(&radius);
    let [low, high] = values.bounds(&our(&theta), bits).map(|b| num(&b));
    let [a, b] = radius_bounds(&radius, &theta, bits + 60);
    assert!(
        low <= b && a <= high && (low == high || low <= a && b <= high),
        "bounds"
    );
    let size: Q = (0..=radius.harmonics())
        .map(|n| num(radius.cos(n)).abs() + num(radius.sin(n)).abs())
        .sum();
    assert!(
        high - low <= size * power_of_two(-i64::from(bits)),
        "the width"
    );
    let double = values.nearest_double(&our(&theta));
    if !double.is_finite() {
        return Outcome::Open;
    }
    let [below, above] = rounding_interval(double);
    let [a, b] = radius_bounds(&radius, &theta, 300);
    assert!(below <= b && a <= above, "the nearest double");
    Outcome::Checked
}

/// The relative deviation of a double from r(θ) is an upper bound within a millionth of itself.
pub(crate) fn check_digits(draw: &mut Draw) -> Outcome {
    // Exact numbers first.
    let exact = draw.rational();
    let got = nearest(&exact) * (1.0 + f64::from_bits(draw.below(1 << 60)));
    if got.is_finite() {
        let deviation = Deviation::between(&our(&value(got)), &our(&exact));
        match deviation.relative() {
            None => assert!(exact.is_zero() && got != 0.0),
            Some(relative) if exact.is_zero() => assert!(relative.is_zero() && got == 0.0),
            Some(relative) => {
                let expected = (value(got) - &exact).abs() / exact.abs();
                assert_eq!(num(relative), expected);
                for digits in [0u32, 3, 15, 16] {
                    let mark = Q::new(BigInt::one(), BigInt::from(10).pow(digits));
                    assert_eq!(deviation.reaches(digits), expected <= mark);
                }
            }
        }
    }
    let radius = any_radius(draw, 5);
    let theta = draw.double(4);
    let [low, high] = radius_bounds(&radius, &value(theta), 400);
    let middle = nearest(&low);
    if radius.harmonics() == 0 {
        // Exact, and compared above.
        return Outcome::Checked;
    }
    if low.is_negative() != high.is_negative() || !middle.is_normal() {
        return Outcome::Open;
    }
    let r = match draw.below(3) {
        0 => middle,
        1 => (0..draw.below(20)).fold(middle, |r, _| r.next_up()),
        _ => middle * (1.0 + draw.double(40).abs().min(1.0)),
    };
    draw.input = format!("{radius:?} at {theta}: {r}");
    let Ok(reference) = Reference::of_radius(&radius) else {
        return Outcome::Open;
    };
    let given = GivenRadius { line: 1, theta, r };
    let found = reference.check_radii(&[given], &Limits::none()).unwrap();
    let claimed = num(found.rows[0].deviation.relative().unwrap());
    let [a, b] = [&low, &high].map(|exact| (value(r) - exact).abs() / exact.abs());
    let (least, most) = if a < b { (a, b) } else { (b, a) };
    if least.is_zero() || &most / &least > Q::new(1001.into(), 1000.into()) {
        return Outcome::Open;
    }
    assert!(least <= claimed, "an upper bound: {claimed}");
    let within = Q::new(1_000_002.into(), 1_000_000.into());
    assert!(claimed <= most * within, "within a millionth: {claimed}");
    Outcome::Checked
}
