//! Isolating the real roots of a squarefree polynomial: Descartes' rule in the Bernstein basis.
//!
//! The number of sign changes of the Bernstein coefficients on an interval is at least the number
//! of roots there, and equal to it when it is 0 or 1. Intervals are halved (de Casteljau) until it
//! is. Coefficients are carried with a bounded number of bits and a bound of their error; signs
//! below the bound count as unknown, and when the sign at an endpoint is unknown the exact
//! polynomial is asked: 0 there is an exact root, which is divided out; otherwise everything is
//! repeated with twice the bits. So the answer is always exact, and rarely is the arithmetic.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::DivRound;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;
use malachite::base::rounding_modes::RoundingMode;

use super::evaluate::integer_sign as sign;
use super::pair::separate;
use super::shift::negate_odd;
use super::{IntegerPolynomial, divide_exactly, shift_by_one, sign_at};
use crate::error::Invariant;
use crate::exact::Dyadic;

/// Bits carried beyond the degree at the first attempt.
const GUARD_BITS: u64 = 64;

/// What [`isolate`] finds: `exact` roots, and open intervals that hold one root each of
/// `rest`, the polynomial that is left when the exact roots are divided out.
#[derive(Clone, Debug)]
pub(crate) struct Isolated {
    pub(crate) exact: Vec<Dyadic>,
    pub(crate) rest: IntegerPolynomial,
    pub(crate) intervals: Vec<(Dyadic, Dyadic)>,
}

/// Isolates all real roots of a squarefree polynomial of positive degree.
///
/// At both ends of every interval `rest` is not 0, and it has opposite signs there.
pub(crate) fn isolate(f: &IntegerPolynomial) -> Isolated {
    let mut exact = Vec::new();
    let mut rest = f.clone();
    if rest.coefficients_asc().first() == Some(&Integer::ZERO) {
        exact.push(Dyadic::zero());
        rest = IntegerPolynomial::from_coefficients_asc(rest.coefficients_asc()[1..].to_vec());
    }
    'again: loop {
        let mut intervals = Vec::new();
        for negative in [true, false] {
            let mut coefficients = rest.coefficients_asc().to_vec();
            if negative {
                negate_odd(&mut coefficients);
            }
            match positive_roots(&coefficients) {
                Ok(found) => intervals.extend(found.into_iter().map(|(low, high)| {
                    if negative {
                        (high.negated(), low.negated())
                    } else {
                        (low, high)
                    }
                })),
                Err(root) => {
                    let root = if negative { root.negated() } else { root };
                    rest = without_root(&rest, &root);
                    exact.push(root);
                    continue 'again;
                }
            }
        }
        return Isolated {
            exact,
            rest,
            intervals,
        };
    }
}

/// f / (x − root), up to a constant.
fn without_root(f: &IntegerPolynomial, root: &Dyadic) -> IntegerPolynomial {
    let q = root.to_rational();
    let factor = IntegerPolynomial::from_coefficients_asc(vec![-q.numerator(), q.denominator()]);
    divide_exactly(f, &factor).invariant("the factor of an exact root divides the polynomial")
}

/// Intervals of the positive roots, or a root that is a dyadic number.
fn positive_roots(f: &[Integer]) -> Result<Vec<(Dyadic, Dyadic)>, Dyadic> {
    if f.len() < 2 || sign_changes(f.iter().map(sign)) == 0 {
        return Ok(Vec::new());
    }
    let exponent = root_bound_exponent(f);
    let top = Dyadic::new(Integer::ONE, exponent);
    let exact = IntegerPolynomial::from_coefficients_asc(f.to_vec());
    if sign_changes(f.iter().map(sign)) == 1 {
        return Ok(vec![(Dyadic::zero(), top)]);
    }
    let bernstein = scaled_bernstein(f, exponent);
    let mut bits = bernstein.degree as u64 + GUARD_BITS;
    loop {
        let mut search = Search {
            exact: &exact,
            exponent,
            found: Vec::new(),
        };
        match search.run(&bernstein, bits) {
            Ok(()) => return Ok(search.found),
            Err(Stop::ExactRoot(root)) => return Err(root),
            Err(Stop::MoreBits) => bits *= 2,
        }
    }
}

/// An e with all positive roots of f below 2^e (Kioustelidis: twice the largest
/// (|c_i| / c_n)^(1/(n−i)) over the coefficients of the other sign).
fn root_bound_exponent(f: &[Integer]) -> i64 {
    let bits = |c: &Integer| c.significant_bits().cast_signed();
    let n = f.len() - 1;
    let lead = &f[n];
    f[..n]
        .iter()
        .enumerate()
        .filter(|(_, c)| sign(c) == -sign(lead))
        .map(|(i, c)| {
            let gap = i64::try_from(n - i).invariant("degrees are below 2^63");
            // |c|/|lead| < 2^(bits(c) − bits(lead) + 1)
            (bits(c) - bits(lead) + 1)
                .div_round(gap, RoundingMode::Ceiling)
                .0
        })
        .max()
        .invariant("a polynomial with a change of sign has a coefficient of the other sign")
        + 1
}

/// Exact Bernstein coefficients on (0, 2^exponent), each as `numerator_k / C(d, k)`.
struct ScaledBernstein {
    degree: usize,
    numerators: Vec<Integer>,
    binomials: Vec<Integer>,
}

fn scaled_bernstein(f: &[Integer], exponent: i64) -> ScaledBernstein {
    let degree = f.len() - 1;
    // f(2^e x), multiplied by a power of two if e < 0.
    let mut c: Vec<Integer> = f
        .iter()
        .enumerate()
        .map(|(i, c)| {
            let i = if exponent >= 0 { i } else { degree - i };
            c << (exponent.unsigned_abs() * i as u64)
        })
        .collect();
    // (1+x)^d f(1/(1+x)) = Σ C(d, k) b_(d−k) x^k
    c.reverse();
    let mut numerators =
        shift_by_one(IntegerPolynomial::from_coefficients_asc(c)).into_coefficients_asc();
    numerators.resize(degree + 1, Integer::ZERO);
    numerators.reverse();
    let mut binomials = Vec::with_capacity(degree + 1);
    let mut binomial = Integer::ONE;
    for k in 0..=degree {
        binomials.push(binomial.clone());
        binomial = binomial * Integer::from(degree - k) / Integer::from(k + 1);
    }
    ScaledBernstein {
        degree,
        numerators,
        binomials,
    }
}

enum Stop {
    ExactRoot(Dyadic),
    MoreBits,
}

/// Rounded Bernstein coefficients on the interval `(index, index + 1) · 2^(exponent − depth)`.
///
/// Lemma 1 (the error of a node). Every coefficient is less than `error` below the exact one, and not above it.
/// Proof. The first ones are rounded down to integers, so `error` = 1 is right for them; Lemma 2 is the step.
/// Law: `halving_loses_less_than_the_error_says`.
struct Node {
    index: Integer,
    depth: u64,
    coefficients: Vec<Integer>,
    error: Integer,
}

struct Search<'a> {
    exact: &'a IntegerPolynomial,
    exponent: i64,
    found: Vec<(Dyadic, Dyadic)>,
}

impl Search<'_> {
    fn run(&mut self, bernstein: &ScaledBernstein, bits: u64) -> Result<(), Stop> {
        let sizes = bernstein.numerators.iter().zip(&bernstein.binomials);
        let largest = sizes
            .map(|(n, b)| (n.significant_bits() + 1).saturating_sub(b.significant_bits()))
            .max()
            .invariant("a polynomial of degree d has d + 1 coefficients");
        // b_k · 2^(bits − largest), rounded down.
        let coefficients: Vec<Integer> = bernstein
            .numerators
            .iter()
            .zip(&bernstein.binomials)
            .map(|(n, b)| {
                let (n, b) = if bits >= largest {
                    (n << (bits - largest), b.clone())
                } else {
                    (n.clone(), b << (largest - bits))
                };
                n.div_round(b, RoundingMode::Floor).0
            })
            .collect();
        let mut stack = vec![Node {
            index: Integer::ZERO,
            depth: 0,
            coefficients,
            error: Integer::ONE,
        }];
        while let Some(node) = stack.pop() {
            let signs = node.coefficients.iter().map(|c| known_sign(c, &node.error));
            match Changes::count(signs) {
                Changes::None => {}
                Changes::One => {
                    let low = self.dyadic(&node.index, node.depth);
                    let high = self.dyadic(&(&node.index + Integer::ONE), node.depth);
                    self.found.push((low, high));
                }
                Changes::More if let Some(convex) = convexity(&node) => {
                    let low = self.dyadic(&node.index, node.depth);
                    let high = self.dyadic(&(&node.index + Integer::ONE), node.depth);
                    let found = separate(self.exact, (low, high), convex);
                    self.found.extend(found.map_err(Stop::ExactRoot)?);
                }
                Changes::More => {
                    let (left, right) = halve(node);
                    let middle = &right.coefficients[0];
                    if known_sign(middle, &right.error).is_none() {
                        let point = self.dyadic(&right.index, right.depth);
                        return Err(if sign_at(self.exact, &point) == 0 {
                            Stop::ExactRoot(point)
                        } else {
                            Stop::MoreBits
                        });
                    }
                    stack.push(right);
                    stack.push(left);
                }
            }
        }
        Ok(())
    }

    fn dyadic(&self, index: &Integer, depth: u64) -> Dyadic {
        let depth = depth.cast_signed();
        Dyadic::new(index.clone(), self.exponent - depth)
    }
}

/// The sign of the second derivative, if it is certain that it has one, where halving has not helped for long.
///
/// Lemma 3. A second difference b0 − 2 b1 + b2 of rounded coefficients is less than twice `error` away from the exact one,
/// and where all of the exact ones have one sign, so has the second derivative.
/// Proof. By Lemma 1 b0 + b2 and 2 b1 are each less than 2 `error` below the exact ones, and not above. The differences,
/// times a positive number, are the Bernstein coefficients of the second derivative.
/// Law: `a_certain_second_derivative_is_right`.
fn convexity(node: &Node) -> Option<i8> {
    /// Roots that are not very close have been told apart by then.
    const LONG: u64 = 24;
    let b = &node.coefficients;
    if node.depth < LONG || b.len() < 3 {
        return None;
    }
    let error = &node.error << 1u64;
    let mut signs = b
        .windows(3)
        .map(|b| known_sign(&(&b[0] + &b[2] - (&b[1] << 1u64)), &error));
    let first = signs.next()??;
    signs.all(|sign| sign == Some(first)).then_some(first)
}

/// De Casteljau at the midpoint, rounding every mean down.
///
/// Lemma 2. If every coefficient of a polynomial of degree d is less than `error` below the exact one and not above it, then
/// those of the halves are less than `error` + d below, and not above.
/// Proof. The mean of two numbers that are less than e below is less than e below, and rounding it down takes at most 1/2
/// more. Each result comes from at most d means, one after the other: it is less than `error` + d/2 below.
/// Law: `halving_loses_less_than_the_error_says`.
fn halve(node: Node) -> (Node, Node) {
    let mut right = node.coefficients;
    let degree = right.len() - 1;
    let mut left = Vec::with_capacity(degree + 1);
    for step in 0..=degree {
        left.push(right[0].clone());
        for k in 0..degree - step {
            let (low, high) = right.split_at_mut(k + 1);
            low[k] += &high[0];
            low[k] >>= 1u64;
        }
    }
    let error = node.error + Integer::from(degree);
    let index = node.index << 1u64;
    (
        Node {
            index: index.clone(),
            depth: node.depth + 1,
            coefficients: left,
            error: error.clone(),
        },
        Node {
            index: index + Integer::ONE,
            depth: node.depth + 1,
            coefficients: right,
            error,
        },
    )
}

/// The sign of a number that is less than `error` away from `value`; `None` if that leaves it open.
fn known_sign(value: &Integer, error: &Integer) -> Option<i8> {
    (value.unsigned_abs_ref() >= error.unsigned_abs_ref()).then(|| sign(value))
}

fn sign_changes(signs: impl Iterator<Item = i8>) -> usize {
    let mut last = 0;
    let mut changes = 0;
    for s in signs.filter(|&s| s != 0) {
        changes += usize::from(last == -s);
        last = s;
    }
    changes
}

pub(super) enum Changes {
    None,
    One,
    More,
}

impl Changes {
    /// The number of sign changes, where an unknown sign may be anything: `None` and `One` are
    /// certain, `More` is "two or more, or not known".
    pub(super) fn count(signs: impl Iterator<Item = Option<i8>>) -> Self {
        let mut last: Option<i8> = None;
        let mut unknown = 0;
        let mut changes = 0;
        for s in signs {
            let Some(s) = s else {
                unknown += 1;
                continue;
            };
            match last {
                None if unknown > 0 => return Self::More,
                Some(l) if l == s && unknown > 0 => return Self::More,
                Some(l) if l != s && unknown > 1 => return Self::More,
                Some(l) => changes += usize::from(l != s),
                None => {}
            }
            (last, unknown) = (Some(s), 0);
        }
        match (unknown, changes) {
            (0, 0) => Self::None,
            (0, 1) => Self::One,
            _ => Self::More,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::poly::{RealRoot, real_roots};
    use malachite::base::num::arithmetic::traits::Pow;
    use proptest::prelude::*;

    fn poly(c: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
    }

    fn check(roots: &[RealRoot], expected: &[f64]) {
        let got: Vec<f64> = roots.iter().map(RealRoot::to_f64).collect();
        assert_eq!(got, expected);
    }

    #[test]
    fn roots_at_dyadic_points_and_beside_them() {
        check(&real_roots(&poly(&[-1, 0, 1])), &[-1.0, 1.0]);
        check(&real_roots(&poly(&[1, 0, 1])), &[]);
        check(&real_roots(&poly(&[0, -1, 3])), &[0.0, 1.0 / 3.0]);
        let five: Vec<f64> = (1..=20).map(f64::from).collect();
        let wilkinson = (1..=20).fold(poly(&[1]), |f, k| f * poly(&[-k, 1]));
        check(&real_roots(&wilkinson), &five);
    }

    #[test]
    fn mignotte_pairs_are_told_apart() {
        // x^d − 2 (a x − 1)²: two roots about a^(−(d+2)/2) apart near 1/a.
        for (d, a) in [(12, 50), (30, 9), (80, 3)] {
            let mut c = vec![Integer::ZERO; d + 1];
            c[d] = Integer::ONE;
            c[0] = Integer::from(-2);
            c[1] = Integer::from(4 * a);
            c[2] = Integer::from(-2 * a * a);
            let roots = real_roots(&IntegerPolynomial::from_coefficients_asc(c));
            let positive = roots.iter().filter(|r| r.signum() > 0).count();
            assert_eq!(positive, 3, "degree {d}");
        }
    }

    #[test]
    fn tiny_and_huge_roots() {
        // (x − 10^−30)(x − 10^30)(x + 7)
        let ten = Integer::from(10).pow(30);
        let f = IntegerPolynomial::from_coefficients_asc(vec![-Integer::ONE, ten.clone()])
            * IntegerPolynomial::from_coefficients_asc(vec![-ten, Integer::ONE])
            * poly(&[7, 1]);
        check(&real_roots(&f), &[-7.0, 1e-30, 1e30]);
    }

    /// The halves of twice the distance of exact and rounded coefficients, times 2^degree: de Casteljau without rounding.
    fn halved_exactly(coefficients: &[Integer]) -> [Vec<Integer>; 2] {
        // The coefficients of level k are multiplied by 2^k.
        let degree = coefficients.len() - 1;
        let mut level = coefficients.to_vec();
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for step in 0..=degree {
            let up = (degree - step) as u64;
            left.push(&level[0] << up);
            right.push(&level[degree - step] << up);
            level = level.windows(2).map(|w| &w[0] + &w[1]).collect();
        }
        right.reverse();
        [left, right]
    }

    /// Coefficients for which every mean of de Casteljau's scheme ends in 1/2, if `is_worst`: level by level from the last
    /// mean, of which the numbers given are those that are free.
    fn coefficients_to_halve(free: &[i64], is_worst: bool) -> Vec<Integer> {
        if !is_worst {
            return free.iter().map(|c| Integer::from(*c)).collect();
        }
        let mut level: Vec<Integer> = Vec::new();
        for c in free {
            let mut above = vec![Integer::from(*c)];
            for mean in &level {
                let next = (mean << 1u64) + Integer::ONE - &above[above.len() - 1];
                above.push(next);
            }
            level = above;
        }
        level
    }

    proptest! {
        /// The largest loss is half of the degree, and the bound is the degree.
        #[test]
        fn halving_loses_less_than_the_error_says(
            free in prop::collection::vec(any::<i64>(), 2..70), is_worst in any::<bool>(), error in 1u64..100,
        ) {
            let coefficients = coefficients_to_halve(&free, is_worst);
            let degree = coefficients.len() - 1;
            // The exact ones are as far above as is allowed, but for one 2^-20.
            let most = (Integer::from(error) << 20u64) - Integer::ONE;
            let exact: Vec<Integer> = coefficients.iter().map(|c| (c << 20u64) + &most).collect();
            let node = Node { index: Integer::from(3), depth: 7, coefficients, error: Integer::from(error) };
            let (left, right) = halve(node);
            prop_assert_eq!((&left.index, &right.index), (&Integer::from(6), &Integer::from(7)));
            let mut largest = Integer::ZERO;
            let scale = degree as u64 + 20;
            for (half, exact) in [left, right].into_iter().zip(halved_exactly(&exact)) {
                prop_assert_eq!(half.depth, 8);
                for (found, exact) in half.coefficients.iter().zip(exact) {
                    let below = exact - (found << scale);
                    prop_assert!(below >= 0 && below < &half.error << scale);
                    largest = largest.max(below);
                }
            }
            // And not much less than that, at least for the part that is lost here.
            let lost = largest - (most << degree as u64);
            if is_worst {
                prop_assert_eq!(lost << 1u64, Integer::from(degree) << scale);
            } else if degree > 20 {
                prop_assert!(lost << 3u64 >= Integer::from(degree) << scale);
            }
        }

        /// Second differences of exact coefficients at both ends of what the rounded ones allow.
        #[test]
        fn a_certain_second_derivative_is_right(
            slopes in prop::collection::vec(-4i64..5, 2..12), curve in -9i64..10, error in 1u64..4,
            ends in prop::collection::vec(any::<bool>(), 14),
        ) {
            let mut b = vec![Integer::ZERO];
            let mut slope = Integer::ZERO;
            for s in &slopes {
                slope += Integer::from(curve + s);
                b.push(&b[b.len() - 1] + &slope);
            }
            let node = Node { index: Integer::ZERO, depth: 99, coefficients: b.clone(), error: Integer::from(error) };
            let most = (Integer::from(error) << 20u64) - Integer::ONE;
            let exact: Vec<Integer> = b.iter().zip(&ends)
                .map(|(b, end)| (b << 20u64) + if *end { most.clone() } else { Integer::ZERO }).collect();
            if let Some(sign_found) = convexity(&node) {
                for w in exact.windows(3) {
                    prop_assert_eq!(sign(&(&w[0] + &w[2] - (&w[1] << 1u64))), sign_found);
                }
            }
        }

        /// Inputs built backwards: known rational roots with multiplicities, times a factor
        /// without real roots.
        #[test]
        fn known_roots_are_found_with_their_multiplicities(
            roots in prop::collection::btree_map((-60i64..60, 1i64..12), 1usize..4, 0..6),
            positive in prop::collection::vec((1i64..9, -4i64..4), 0..3),
        ) {
            let mut distinct = std::collections::BTreeMap::new();
            let mut f = poly(&[1]);
            for ((p, q), m) in roots {
                let r = crate::exact::Rational::from(p) / crate::exact::Rational::from(q);
                let factor = IntegerPolynomial::from_coefficients_asc(vec![-r.numerator(), r.denominator()]);
                for _ in 0..m {
                    f *= &factor;
                }
                *distinct.entry(r).or_insert(0) += m;
            }
            for (a, b) in positive {
                // (x − b)² + a
                f *= poly(&[b * b + a, -2 * b, 1]);
            }
            let found: Vec<(f64, usize)> = real_roots(&f).iter().map(|r| (r.to_f64(), r.multiplicity())).collect();
            let expected: Vec<(f64, usize)> = distinct.iter().map(|(r, m)| (r.to_f64(), *m)).collect();
            prop_assert_eq!(found, expected);
        }

        /// Inputs built backwards: rational roots 0, 1, 2, … ulps apart, at midpoints between doubles, and at 2^-60 and 2^-200
        /// ulps of them. Their order, their doubles and their multiplicities are known.
        #[test]
        fn roots_that_are_ulps_apart_are_told_apart_and_rounded(
            bits in prop_oneof![0x3FE0_u64 << 48..0x4010_u64 << 48, 0x0010_u64 << 48..0x7FD0_u64 << 48, 1_u64..1 << 54],
            places in prop::collection::btree_set((0_i64..4, 0_usize..9), 2..6), negative in any::<bool>(), twice in any::<bool>(),
        ) {
            let exactly = |x: f64| Rational::try_from(x).unwrap();
            let start = f64::from_bits(bits);
            let ulp = exactly(start.next_up()) - exactly(start);
            let part = |k: u64| Rational::from_parts(Integer::ONE, -k.cast_signed());
            let half = part(1);
            let offsets = [
                Rational::zero(), part(60), part(200), &half - part(200), &half - part(60), half.clone(), &half + part(200),
                &half + part(60), Rational::one() - part(60),
            ];
            let mut f = poly(&[1]);
            let mut expected = Vec::new();
            for (k, (ulps, offset)) in places.iter().enumerate() {
                let size = exactly(start) + &ulp * (Rational::from(*ulps) + &offsets[*offset]);
                let root = if negative { -size } else { size };
                let m = if twice && k == 0 { 2 } else { 1 };
                let factor = IntegerPolynomial::from_coefficients_asc(vec![-root.numerator(), root.denominator()]);
                for _ in 0..m {
                    f *= &factor;
                }
                expected.push((root, m));
            }
            expected.sort();
            let found: Vec<(f64, usize)> = real_roots(&f).iter().map(|r| (r.to_f64(), r.multiplicity())).collect();
            let expected: Vec<(f64, usize)> = expected.iter().map(|(r, m)| (r.to_f64(), *m)).collect();
            prop_assert_eq!(found, expected);
        }

        /// The same without real roots, or with pairs next to each other: (x − r)² ± 2^-k times the rest.
        #[test]
        fn close_pairs_are_roots_on_one_side_only(
            mantissa in 1_i64..1 << 53, exponent in -60_i64..10, k in prop_oneof![1_u64..80, 80_u64..700], other in 1_i64..9,
        ) {
            let root = Rational::from_parts(Integer::from(mantissa), exponent);
            let (p, q) = (root.numerator(), root.denominator());
            let square = IntegerPolynomial::from_coefficients_asc(vec![-p, q]).pow(2);
            let quadratic = poly(&[other, 1, 1]);
            for (sign, count) in [(-1, 2), (1, 0)] {
                let small = IntegerPolynomial::from_coefficients_asc(vec![Integer::from(sign)]);
                let f = ((&square << k) + small) * &quadratic;
                prop_assert_eq!(real_roots(&f).len(), count);
            }
        }

        /// Oracle: Sturm's theorem, done naively with num-rational.
        #[test]
        fn the_count_is_sturms(c in prop::collection::vec(-30i64..30, 2..14)) {
            let f = poly(&c);
            prop_assume!(f.coefficients_asc().len() > 1);
            prop_assert_eq!(real_roots(&f).len(), sturm(&f));
        }

        /// With long coefficients, next to powers of two, so that a bounded number of bits holds none of them.
        #[test]
        fn the_count_of_long_polynomials_is_sturms(
            c in prop::collection::vec((-8_i64..9, 0_u64..400, -1_i64..2), 2..9),
        ) {
            let long = |&(c, bits, more): &(i64, u64, i64)| (Integer::from(c) << bits) + Integer::from(more);
            let f = IntegerPolynomial::from_coefficients_asc(c.iter().map(long).collect());
            prop_assume!(f.coefficients_asc().len() > 1);
            prop_assert_eq!(real_roots(&f).len(), sturm(&f));
        }
    }

    fn sturm(f: &IntegerPolynomial) -> usize {
        use num_bigint::BigInt;
        use num_rational::BigRational;
        use num_traits::{Signed, Zero};
        type P = Vec<BigRational>;
        let trim = |mut p: P| {
            while p.last().is_some_and(Zero::is_zero) {
                p.pop();
            }
            p
        };
        let f: P = trim(
            f.coefficients_asc()
                .iter()
                .map(|c| BigRational::from(c.to_string().parse::<BigInt>().unwrap()))
                .collect(),
        );
        let df: P = f
            .iter()
            .enumerate()
            .skip(1)
            .map(|(i, c)| c * BigRational::from(BigInt::from(i)))
            .collect();
        let mut chain = vec![f, trim(df)];
        while !chain[chain.len() - 1].is_empty() {
            let (a, b) = (chain[chain.len() - 2].clone(), &chain[chain.len() - 1]);
            let mut a = a;
            while a.len() >= b.len() {
                let q = &a[a.len() - 1] / &b[b.len() - 1];
                let start = a.len() - b.len();
                for (i, v) in b.iter().enumerate() {
                    let s = &q * v;
                    a[start + i] -= s;
                }
                a.pop();
                a = trim(a);
            }
            chain.push(a.into_iter().map(|v| -v).collect());
        }
        chain.pop();
        let changes = |at_minus: bool| {
            let signs: Vec<bool> = chain
                .iter()
                .map(|p| p[p.len() - 1].is_positive() ^ (at_minus && p.len().is_multiple_of(2)))
                .collect();
            signs.windows(2).filter(|w| w[0] != w[1]).count()
        };
        changes(true) - changes(false)
    }
}
