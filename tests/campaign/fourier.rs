//! Theorem 2 by schoolbook and by values, the way back, and where a Fourier radius is positive.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};
use stellate::implicitize::SquaredForm;
use stellate::parametrize::{fourier_branches, positive_ranges};
use stellate::shape::FourierRadius;

use super::branches::is_in;
use super::common::oracle_theorem_2::theorem_2;
use super::draw::Draw;
use super::exact::{Poly, Q, Sturm, num, our, power_of_two, value};
use super::harness::Outcome;
use super::terms::{plane_terms, value_of};

/// A radius that is not 0, with up to so many harmonics, many of them 0 in some.
pub(crate) fn any_radius(draw: &mut Draw, harmonics: u64) -> FourierRadius {
    let top = draw.below(harmonics + 1);
    let kind = draw.below(6);
    let step = 1 + draw.below(3);
    let mut pairs = Vec::new();
    for n in 0..=top {
        let left_out = match kind {
            0 => n % 2 == 0,
            1 => n % 2 == 1,
            2 => n % step != 0,
            3 => draw.once_in(2),
            _ => false,
        };
        let pair = if left_out {
            [Q::zero(), Q::zero()]
        } else {
            [draw.rational(), draw.rational()]
        };
        pairs.push(pair);
    }
    if pairs.iter().flatten().all(Zero::is_zero) {
        pairs[0][0] = Q::one();
    }
    let of = |k: usize| pairs.iter().map(|pair| our(&pair[k])).collect();
    let radius = FourierRadius::new(of(0), of(1));
    if radius.is_zero() {
        FourierRadius::new(vec![1.into()], vec![])
    } else {
        radius
    }
}

fn text(radius: &FourierRadius) -> String {
    let terms = (0..=radius.harmonics()).map(|n| {
        format!(
            "({})*cos({n}*t) + ({})*sin({n}*t)",
            radius.cos(n),
            radius.sin(n)
        )
    });
    format!("r = {}", terms.collect::<Vec<_>>().join(" + "))
}

/// F term by term.
pub(crate) fn schoolbook(draw: &mut Draw) -> Outcome {
    let radius = any_radius(draw, 7);
    draw.input = format!("stellate implicitize '{}'", text(&radius));
    let f = SquaredForm::new(&radius).unwrap().expand_unreduced();
    let ours = f.polynomial().monic();
    let ours = ours.terms().map(|(e, c)| (e, num(&c)));
    assert_eq!(ours.collect::<Vec<_>>(), theorem_2(&radius));
    Outcome::Checked
}

/// F(x, y) by Eqs. (7) and (8) in numbers.
fn value_of_theorem_2(radius: &FourierRadius, [x, y]: &[Q; 2]) -> Q {
    let n = radius.harmonics();
    let rho = x * x + y * y;
    let power = |k: usize| (0..k).fold(Q::one(), |p, _| p * &rho);
    let (mut re, mut im) = (Q::one(), Q::zero());
    let mut sums = [Q::zero(), Q::zero()];
    let top = |parity: usize| {
        if n % 2 == parity {
            n
        } else {
            n.saturating_sub(1)
        }
    };
    for m in 0..=n {
        let k = num(radius.cos(m)) * &re + num(radius.sin(m)) * &im;
        sums[m % 2] += k * power((top(m % 2) - m) / 2);
        (re, im) = (&re * x - &im * y, &re * y + &im * x);
    }
    let [even, odd] = sums;
    if n.is_multiple_of(2) {
        let left = power(n / 2) - odd;
        &rho * &left * &left - &even * &even
    } else {
        let left = power(n.div_ceil(2)) - odd;
        &left * &left - &rho * &even * &even
    }
}

/// Values of F for up to 300 harmonics, most of them far fewer.
pub(crate) fn values(draw: &mut Draw) -> Outcome {
    let top = match draw.below(24) {
        0 => 100 + draw.below(201),
        1..6 => 20 + draw.below(40),
        _ => 2 + draw.below(18),
    };
    let decimals = draw.once_in(2);
    let mut coefficient = |n: u64| {
        if draw.once_in(10) {
            Q::zero()
        } else if decimals {
            Q::new(draw.small(9999).into(), (10_000 * (n + 1)).into())
        } else {
            value(draw.double(10))
        }
    };
    let (cos, sin) = (0..=top)
        .map(|n| (our(&coefficient(n)), our(&coefficient(n))))
        .unzip();
    let radius = FourierRadius::new(cos, sin);
    if radius.is_zero() {
        return Outcome::Open;
    }
    draw.input = format!("stellate implicitize '{}'", text(&radius));
    let form = SquaredForm::new(&radius).unwrap();
    let unreduced = form.expand_unreduced();
    let terms = plane_terms(unreduced.polynomial());
    let lead = num(&unreduced.polynomial().first_coefficient().unwrap());
    // Integers for large N: no fractions are reduced.
    let denominator = if top < 20 { 7 } else { 1 };
    for _ in 0..if top < 100 { 2 } else { 1 } {
        let at = [0; 2].map(|_: i32| draw.fraction(9, denominator));
        let expected = value_of_theorem_2(&radius, &at);
        assert_eq!(value_of(terms.clone(), &at), &lead * &expected, "at {at:?}");
        if form.is_perfect_square() && top < 20 {
            let reduced = form.expand();
            let lead = num(&reduced.polynomial().first_coefficient().unwrap());
            let root = value_of(plane_terms(reduced.polynomial()), &at) / lead;
            assert_eq!(&root * &root, expected, "the square root at {at:?}");
        }
    }
    Outcome::Checked
}

/// Fourier → F → Fourier: r(θ) and −r(θ + π), which are the same curve.
pub(crate) fn round_trip(draw: &mut Draw) -> Outcome {
    let radius = any_radius(draw, 20);
    draw.input = format!(
        "stellate implicitize '{}' | stellate parametrize",
        text(&radius)
    );
    let curve = SquaredForm::new(&radius).unwrap().expand();
    let found = fourier_branches(&curve).unwrap().radii;
    let sign = |n: usize| {
        if n.is_multiple_of(2) {
            -Q::one()
        } else {
            Q::one()
        }
    };
    let turned = |of: &dyn Fn(usize) -> Q| {
        (0..=radius.harmonics())
            .map(|n| our(&(of(n) * sign(n))))
            .collect()
    };
    let opposite = FourierRadius::new(
        turned(&|n| num(radius.cos(n))),
        turned(&|n| num(radius.sin(n))),
    );
    assert!(found.contains(&radius), "{found:?}");
    assert!(found.contains(&opposite), "{found:?}");
    assert_eq!(found.len(), if radius == opposite { 1 } else { 2 });
    Outcome::Checked
}

/// (1 + t²)^N r(2 arctan t), for rational coefficients.
fn half_angle(cos: &[Q], sin: &[Q]) -> Poly {
    let scale = cos
        .iter()
        .chain(sin)
        .fold(BigInt::one(), |d, c| d * c.denom());
    let n = cos.len() - 1;
    let times = |[a, b]: &[Poly; 2], [c, d]: &[Poly; 2]| {
        let minus = b.times(d).scaled(&BigInt::from(-1));
        [a.times(c).plus(&minus), a.times(d).plus(&b.times(c))]
    };
    // (1 + i t)² = (1 + t²)(cos θ + i sin θ)
    let step = [Poly::of(&[1, 0, -1]), Poly::of(&[0, 2])];
    let mut power = [Poly::of(&[1]), Poly::of(&[])];
    let mut sum = Poly::of(&[]);
    for m in 0..=n {
        let rest = Poly::of(&[1, 0, 1]).power(n - m);
        for (part, c) in power.iter().zip([&cos[m], &sin[m]]) {
            let c = c.numer() * (&scale / c.denom());
            sum = sum.plus(&part.times(&rest).scaled(&c));
        }
        power = times(&power, &step);
    }
    sum
}

/// The product of two series.
fn product([a, b]: &[Vec<Q>; 2], [c, d]: &[Vec<Q>; 2]) -> [Vec<Q>; 2] {
    let top = a.len() + c.len() - 2;
    let mut result = [vec![Q::zero(); top + 1], vec![Q::zero(); top + 1]];
    let half = Q::new(1.into(), 2.into());
    for m in 0..a.len() {
        for n in 0..c.len() {
            let (plus, minus) = (m + n, m.abs_diff(n));
            // sin((m − n) t) = −sin((n − m) t)
            let sign = if m >= n { half.clone() } else { -half.clone() };
            result[0][plus] += (&a[m] * &c[n] - &b[m] * &d[n]) * &half;
            result[0][minus] += (&a[m] * &c[n] + &b[m] * &d[n]) * &half;
            result[1][plus] += (&a[m] * &d[n] + &b[m] * &c[n]) * &half;
            result[1][minus] += (&b[m] * &c[n] - &a[m] * &d[n]) * &sign;
        }
    }
    result[1][0] = Q::zero();
    result
}

/// r > 0 for all angles, or where: radii that are squares and a little, and any others.
pub(crate) fn star_shaped(draw: &mut Draw) -> Outcome {
    let series = |draw: &mut Draw, top: u64| {
        let row = |draw: &mut Draw| (0..=top).map(|_| draw.rational()).collect::<Vec<_>>();
        let [cos, mut sin] = [row(draw), row(draw)];
        sin[0] = Q::zero();
        [cos, sin]
    };
    let top = draw.below(5);
    let [mut cos, mut sin] = series(draw, top);
    if draw.once_in(2) {
        let top = 1 + draw.below(3);
        let root = series(draw, top);
        [cos, sin] = product(&root, &root);
        cos[0] += match draw.below(3) {
            0 => Q::zero(),
            1 => power_of_two(-60),
            _ => -power_of_two(-60),
        };
    }
    let ours = |row: &[Q]| row.iter().map(our).collect::<Vec<_>>();
    let radius = FourierRadius::new(ours(&cos), ours(&sin));
    if radius.is_zero() {
        return Outcome::Open;
    }
    cos.truncate(radius.harmonics() + 1);
    sin.truncate(radius.harmonics() + 1);
    sin[0] = Q::zero();
    draw.input = format!("stellate describe '{}'", text(&radius));
    let f = half_angle(&cos, &sin);
    let ranges = positive_ranges(&radius);
    let roots = if f.degree() == 0 {
        0
    } else {
        Sturm::new(&f).count()
    };
    let is_full =
        f.degree() == 2 * radius.harmonics() && f.0[f.degree()].is_positive() && roots == 0;
    let whole = ranges.len() == 1
        && ranges[0].closed == [true, true]
        && ranges[0].from.to_decimal(5) == "0.00000"
        && ranges[0].to.to_decimal(5) == "6.28319";
    assert_eq!(
        whole, is_full,
        "positive everywhere, {roots} zeros: {ranges:?}"
    );
    let mut asked: Vec<Q> = (0..4).map(|_| draw.rational()).collect();
    for range in &ranges {
        for end in [&range.from, &range.to] {
            let theta: f64 = end.to_decimal(17).parse().unwrap();
            let near = (theta / 2.0).tan();
            if near.is_finite() && near.abs() < 1e9 {
                asked.push(value(near));
                asked.push(value(near.next_up()));
            }
        }
    }
    for t in asked {
        if let Some(inside) = is_in(&ranges, &t) {
            assert_eq!(inside, f.sign_at(&t) > 0, "positive at 2 atan {t}");
        }
    }
    Outcome::Checked
}
