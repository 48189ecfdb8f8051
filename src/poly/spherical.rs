//! Polynomials in cos φ, sin φ, cos θ and sin θ, and those among them that are polynomials on the unit sphere.

use std::collections::BTreeMap;

use malachite::base::num::arithmetic::traits::{DivExact, Factorial};
use malachite::{Integer, Natural};

use super::{TernaryForm, harmonics_of_form};
use crate::error::Invariant;
use crate::exact::Rational;

/// A part of a polynomial in the angles: everything that goes with one harmonic of θ and one parity of the power of sin φ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Part {
    /// The part goes with cos mθ, or with sin mθ if `sine`.
    m: u32,
    sine: bool,
    /// Whether the part has the factor sin φ. Its even powers are polynomials in cos φ.
    with_sin_phi: bool,
}

/// A polynomial in cos φ, sin φ, cos θ and sin θ in its normal form: the sum of `(sin φ)^e p(cos φ) cos mθ` and of the same with
/// `sin mθ`, with e = 0 or 1, m ≥ 0 and univariate polynomials p. Different normal forms are different functions on the sphere
/// without the poles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct SphericalPolynomial {
    /// The polynomials p by ascending coefficients, which do not end with 0.
    parts: BTreeMap<Part, Vec<Rational>>,
}

/// Why a polynomial in the angles is no polynomial on the sphere: the part with this harmonic of θ is not divisible by
/// `(sin φ)^m`, or the quotient is not a polynomial in cos φ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NotOnSphere {
    pub(crate) m: u32,
    pub(crate) sine: bool,
}

impl SphericalPolynomial {
    pub(crate) fn constant(value: Rational) -> Self {
        Self::single(0, false, false, vec![value])
    }

    /// cos nθ or sin nθ.
    pub(crate) fn of_theta(n: i32, sine: bool) -> Self {
        let value = if sine && n < 0 { -1 } else { 1 };
        if sine && n == 0 {
            return Self::default();
        }
        Self::single(n.unsigned_abs(), sine, false, vec![value.into()])
    }

    /// cos nφ or sin nφ: the Chebyshev polynomials T_n(cos φ), and sin φ U_(n−1)(cos φ).
    pub(crate) fn of_phi(n: i32, sine: bool) -> Self {
        if sine && n == 0 {
            return Self::default();
        }
        // p_0 = 1, p_1 = t for T and 2t for U, p_(k+1) = 2t p_k − p_(k−1)
        let mut last = vec![Rational::one()];
        let slope = if sine { 2 } else { 1 };
        let mut next = vec![Rational::zero(), slope.into()];
        let steps = if sine {
            n.unsigned_abs() - 1
        } else {
            n.unsigned_abs()
        };
        for _ in 0..steps {
            let mut after: Vec<Rational> = std::iter::once(Rational::zero())
                .chain(next.iter().map(|c| c * Rational::from(2)))
                .collect();
            for (a, b) in after.iter_mut().zip(&last) {
                *a = &*a - b;
            }
            last = std::mem::replace(&mut next, after);
        }
        if sine && n < 0 {
            last.iter_mut().for_each(|c| *c = -&*c);
        }
        Self::single(0, false, sine, last)
    }

    /// The harmonic Y(l, m), unnormalised and without the Condon–Shortley phase: `(sin φ)^|m| P_l^(|m|)(cos φ)` times cos mθ
    /// for m ≥ 0 and times sin |m|θ for m < 0, where `P_l^(m)` is the m-th derivative of the Legendre polynomial.
    pub(crate) fn harmonic(l: u32, m: i32) -> Self {
        let order = m.unsigned_abs();
        let scale = Rational::from(2)
            .pow(-i64::from(l))
            .invariant("a power of two has a reciprocal");
        let mut p = vec![Rational::zero(); (l - order) as usize + 1];
        for (k, c) in legendre_derivative(l, order).into_iter().enumerate() {
            p[(l - order) as usize - 2 * k] = Rational::whole(c) * &scale;
        }
        for _ in 0..order / 2 {
            p = times_squared_sine(&p);
        }
        Self::single(order, m < 0, order % 2 == 1, p)
    }

    fn single(m: u32, sine: bool, with_sin_phi: bool, p: Vec<Rational>) -> Self {
        let mut sum = Self::default();
        let part = Part {
            m,
            sine,
            with_sin_phi,
        };
        sum.add_part(part, &p, &Rational::one());
        sum
    }

    /// Adds factor·p to a part.
    fn add_part(&mut self, part: Part, p: &[Rational], factor: &Rational) {
        let sum = self.parts.entry(part).or_default();
        if sum.len() < p.len() {
            sum.resize(p.len(), Rational::zero());
        }
        for (a, b) in sum.iter_mut().zip(p) {
            if !b.is_zero() {
                *a = &*a + b * factor;
            }
        }
        while sum.last().is_some_and(Rational::is_zero) {
            sum.pop();
        }
        if sum.is_empty() {
            self.parts.remove(&part);
        }
    }

    pub(crate) fn add_multiple(&mut self, other: &Self, factor: &Rational) {
        for (part, p) in &other.parts {
            self.add_part(*part, p, factor);
        }
    }

    pub(crate) fn scaled(&self, factor: &Rational) -> Self {
        let mut product = Self::default();
        product.add_multiple(self, factor);
        product
    }

    /// The product, term by term.
    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        let half = Rational::new(1, 2).invariant("2 is not 0");
        for (a, p) in &self.parts {
            for (b, q) in &other.parts {
                let mut pq = convolution(p, q);
                if a.with_sin_phi && b.with_sin_phi {
                    pq = times_squared_sine(&pq);
                }
                let with_sin_phi = a.with_sin_phi != b.with_sin_phi;
                let sine = a.sine != b.sine;
                // cos a cos b and sin a sin b are half of cos(a−b) ± cos(a+b); sin a cos b is half of sin(a+b) + sin(a−b).
                let with_sum = if a.sine && b.sine { -1 } else { 1 };
                let difference = a.m.abs_diff(b.m);
                let turned = match (a.sine, b.sine) {
                    (true, false) => a.m < b.m,
                    (false, true) => b.m < a.m,
                    _ => false,
                };
                let with_difference = if turned { -1 } else { 1 };
                for (m, sign) in [(a.m + b.m, with_sum), (difference, with_difference)] {
                    if sine && m == 0 {
                        continue;
                    }
                    let part = Part {
                        m,
                        sine,
                        with_sin_phi,
                    };
                    product.add_part(part, &pq, &(&half * Rational::from(sign)));
                }
            }
        }
        product
    }

    pub(crate) fn as_constant(&self) -> Option<Rational> {
        let mut parts = self.parts.iter();
        match (parts.next(), parts.next()) {
            (None, _) => Some(Rational::zero()),
            (Some((part, p)), None) if part.m == 0 && !part.with_sin_phi && p.len() == 1 => {
                p.first().cloned()
            }
            _ => None,
        }
    }

    /// The number of coefficients.
    pub(crate) fn len(&self) -> usize {
        self.parts.values().map(Vec::len).sum()
    }

    /// The largest number of bits of a coefficient.
    pub(crate) fn bits(&self) -> u64 {
        let bits = self.parts.values().flatten().map(Rational::bits);
        bits.max().unwrap_or(0)
    }

    /// The largest m, and the largest power of cos φ and sin φ together.
    pub(crate) fn degrees(&self) -> [usize; 2] {
        let parts = self.parts.iter();
        parts.fold([0, 0], |[m, k], (part, p)| {
            let power = p.len().saturating_sub(1) + usize::from(part.with_sin_phi);
            [m.max(part.m as usize), k.max(power)]
        })
    }

    /// The coefficients c of the sum Σ c Y(l, m), as (l, m, c).
    ///
    /// # Errors
    /// [`NotOnSphere`], with the harmonic of θ whose part has no such sum.
    pub(crate) fn harmonics(&self) -> Result<Vec<(u32, i32, Rational)>, NotOnSphere> {
        let mut found = Vec::new();
        for (part, p) in &self.parts {
            let refused = NotOnSphere {
                m: part.m,
                sine: part.sine,
            };
            if part.with_sin_phi != (part.m % 2 == 1) {
                return Err(refused);
            }
            let mut q = p.clone();
            for _ in 0..part.m / 2 {
                q = over_squared_sine(&q).ok_or(refused)?;
            }
            let order = i32::try_from(part.m).invariant("an order is below 2^31");
            let m = if part.sine { -order } else { order };
            let series = legendre_series(q, part.m).into_iter();
            found.extend(series.map(|(l, c)| (l, m, c)));
        }
        Ok(found)
    }
}

/// The coefficients of a polynomial in the m-th derivatives of the Legendre polynomials, as (l, c): the one of the highest
/// degree is subtracted first.
fn legendre_series(mut q: Vec<Rational>, m: u32) -> Vec<(u32, Rational)> {
    let mut found = Vec::new();
    while let Some(top) = q.last().cloned() {
        let degree = q.len() - 1;
        if top.is_zero() {
            q.pop();
            continue;
        }
        let l = m + u32::try_from(degree).invariant("a degree is below 2^32");
        let b = legendre_derivative(l, m);
        let lead = b.first().map(Rational::whole::<&Integer>);
        let factor = top / lead.invariant("a Legendre polynomial is not 0");
        for (k, c) in b.iter().enumerate() {
            let at = degree - 2 * k;
            q[at] = &q[at] - &factor * Rational::whole(c);
        }
        let scale = Rational::from(2).pow(i64::from(l));
        found.push((l, factor * scale.invariant("two is not 0")));
    }
    found
}

/// The harmonics of a form on the unit sphere, as (l, m, c); l has the parity of the degree.
///
/// A binary form of degree n is a sum of `(x² + y²)^j` times `Re (x+iy)^m` or `Im (x+iy)^m` with m + 2j = n, and on the sphere x² + y²
/// is 1 − z². So what goes with one of these is a polynomial in z.
pub(crate) fn harmonics_of_ternary_form(form: &TernaryForm) -> Vec<(u32, i32, Rational)> {
    let degree = form.degree();
    // For each m, the coefficients of (1 − z²)^j z^(d−m−2j), for cosines and for sines.
    let mut sums: BTreeMap<usize, [Vec<Rational>; 2]> = BTreeMap::new();
    for (k, row) in form
        .rows()
        .iter()
        .enumerate()
        .filter(|(_, row)| !row.is_zero())
    {
        for (m, a, b) in harmonics_of_form(row) {
            let length = (degree - m) / 2 + 1;
            let [cosines, sines] = sums
                .entry(m)
                .or_insert_with(|| std::array::from_fn(|_| vec![Rational::zero(); length]));
            let j = (degree - k - m) / 2;
            cosines[j] = a;
            sines[j] = b;
        }
    }
    let mut found = Vec::new();
    for (m, pair) in sums {
        let order = i32::try_from(m).invariant("an order is below 2^31");
        for (list, signed) in pair.into_iter().zip([order, -order]) {
            let mut power = vec![Rational::one()];
            let mut sum = Vec::new();
            for (j, q) in list.iter().enumerate() {
                let shift = degree - m - 2 * j;
                let needed = shift + power.len();
                if sum.len() < needed {
                    sum.resize(needed, Rational::zero());
                }
                if !q.is_zero() {
                    for (i, p) in power.iter().enumerate().filter(|(_, p)| !p.is_zero()) {
                        sum[shift + i] = &sum[shift + i] + p * q;
                    }
                }
                power = times_squared_sine(&power);
            }
            let series = legendre_series(sum, order.unsigned_abs()).into_iter();
            found.extend(series.map(|(l, c)| (l, signed, c)));
        }
    }
    found
}

/// `2^l` times the m-th derivative of the Legendre polynomial P_l: the k-th number is the coefficient of t^(l−m−2k),
/// `(−1)^k C(l, k) C(2l−2k, l) (l−2k)!/(l−2k−m)!`. Each is a rational multiple of the one before.
pub(crate) fn legendre_derivative(l: u32, m: u32) -> Vec<Integer> {
    let factorial = |n: u32| Natural::factorial(u64::from(n));
    let first = factorial(2 * l).div_exact(factorial(l) * factorial(l - m));
    let mut coefficient = Integer::from(first);
    let mut found = Vec::with_capacity((l - m) as usize / 2 + 1);
    for k in 0..=(l - m) / 2 {
        found.push(coefficient.clone());
        let left = l - m - 2 * k;
        if left < 2 {
            break;
        }
        let above = u64::from(left) * u64::from(left - 1);
        let below = 2 * u64::from(k + 1) * u64::from(2 * l - 2 * k - 1);
        coefficient = -(coefficient * Integer::from(above)).div_exact(Integer::from(below));
    }
    found
}

fn convolution(p: &[Rational], q: &[Rational]) -> Vec<Rational> {
    let mut product = vec![Rational::zero(); p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
        for (j, b) in q.iter().enumerate().filter(|(_, b)| !b.is_zero()) {
            product[i + j] = &product[i + j] + a * b;
        }
    }
    product
}

/// (1 − t²) p.
fn times_squared_sine(p: &[Rational]) -> Vec<Rational> {
    let mut product = p.to_vec();
    product.resize(p.len() + 2, Rational::zero());
    for (k, c) in p.iter().enumerate() {
        product[k + 2] = &product[k + 2] - c;
    }
    product
}

/// p/(1 − t²); `None` if it is not a polynomial.
fn over_squared_sine(p: &[Rational]) -> Option<Vec<Rational>> {
    // The division begins with the lowest coefficient: q_k = p_k + q_(k−2).
    let mut q: Vec<Rational> = Vec::with_capacity(p.len());
    for (k, c) in p.iter().enumerate() {
        q.push(if k >= 2 { c + &q[k - 2] } else { c.clone() });
    }
    let kept = p.len().checked_sub(2)?;
    let divides = q[kept..].iter().all(Rational::is_zero);
    q.truncate(kept);
    divides.then_some(q)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn harmonics(f: &SphericalPolynomial) -> Vec<(u32, i32, Rational)> {
        f.harmonics().expect("a polynomial on the sphere")
    }

    #[test]
    fn legendre_derivatives_of_low_degree() {
        let numbers = |l, m| -> Vec<i64> {
            let found = legendre_derivative(l, m);
            found.iter().map(|c| i64::try_from(c).unwrap()).collect()
        };
        // 8 P_3 = 20 t³ − 12 t, 8 P_3' = 60 t² − 12, 4 P_2'' = 12
        assert_eq!(numbers(3, 0), [20, -12]);
        assert_eq!(numbers(3, 1), [60, -12]);
        assert_eq!(numbers(2, 2), [12]);
        assert_eq!(numbers(0, 0), [1]);
    }

    #[test]
    fn what_is_no_polynomial_on_the_sphere_is_named() {
        let sine = SphericalPolynomial::of_phi(1, true);
        assert_eq!(sine.harmonics(), Err(NotOnSphere { m: 0, sine: false }));
        let f = sine.times(&SphericalPolynomial::of_theta(2, true));
        assert_eq!(f.harmonics(), Err(NotOnSphere { m: 2, sine: true }));
        // sin² φ cos 2θ = Y(2, 2)/3, and the sum of the squares of the coordinates is 1.
        let f = sine
            .times(&sine)
            .times(&SphericalPolynomial::of_theta(2, false));
        assert_eq!(harmonics(&f), [(2, 2, Rational::new(1, 3).unwrap())]);
        let sum = [
            sine.times(&SphericalPolynomial::of_theta(1, false)),
            sine.times(&SphericalPolynomial::of_theta(1, true)),
            SphericalPolynomial::of_phi(1, false),
        ]
        .iter()
        .fold(SphericalPolynomial::default(), |mut sum, x| {
            sum.add_multiple(&x.times(x), &Rational::one());
            sum
        });
        assert_eq!(sum.as_constant(), Some(Rational::one()));
    }

    /// Values in doubles, from the definition.
    fn value(f: &SphericalPolynomial, theta: f64, phi: f64) -> f64 {
        let parts = f.parts.iter().map(|(part, p)| {
            let angle = f64::from(part.m) * theta;
            let turn = if part.sine { angle.sin() } else { angle.cos() };
            let p = p.iter().rev();
            let p = p.fold(0.0, |v, c| v * phi.cos() + c.to_f64());
            let sine = if part.with_sin_phi { phi.sin() } else { 1.0 };
            turn * p * sine
        });
        parts.sum()
    }

    proptest! {
        #[test]
        fn sums_of_harmonics_are_found_again(
            terms in prop::collection::vec((0u32..7, 0u32..13, -9i64..10), 1..6)
        ) {
            let mut sum = SphericalPolynomial::default();
            let mut expected: BTreeMap<(u32, i32), Rational> = BTreeMap::new();
            for (l, m, c) in terms {
                let m = (m % (2 * l + 1)) as i32 - l as i32;
                sum.add_multiple(&SphericalPolynomial::harmonic(l, m), &c.into());
                let entry = expected.entry((l, m)).or_default();
                *entry = &*entry + Rational::from(c);
            }
            expected.retain(|_, c| !c.is_zero());
            let found = harmonics(&sum).into_iter().map(|(l, m, c)| ((l, m), c));
            prop_assert_eq!(found.collect::<BTreeMap<_, _>>(), expected);
        }

        #[test]
        fn products_have_the_products_of_the_values(
            l in 0u32..5, m in -4i32..5, n in -5i32..6, k in -5i32..6, sine: bool,
            theta in -3.0f64..3.0, phi in 0.1f64..3.0,
        ) {
            prop_assume!(m.unsigned_abs() <= l);
            let y = SphericalPolynomial::harmonic(l, m);
            let f = SphericalPolynomial::of_theta(n, sine).times(&SphericalPolynomial::of_phi(k, !sine));
            let of = |n: i32, sine: bool, at: f64| {
                let angle = f64::from(n) * at;
                if sine { angle.sin() } else { angle.cos() }
            };
            let expected = of(n, sine, theta) * of(k, !sine, phi);
            prop_assert!((value(&f, theta, phi) - expected).abs() < 1e-12);
            let product = value(&y.times(&f), theta, phi);
            let expected = value(&y, theta, phi) * expected;
            prop_assert!((product - expected).abs() < 1e-10 * (1.0 + expected.abs()));
        }
    }
}
