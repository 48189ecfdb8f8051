//! Isolating the real roots of a squarefree polynomial: Descartes' rule in the Bernstein basis.
//!
//! The number of sign changes of the Bernstein coefficients on an interval is at least the number
//! of roots there, and equal to it when it is 0 or 1. Intervals are halved (de Casteljau) until the number of
//! sign changes is 0 or 1, or until [`separate`] tells two close roots apart.
//!
//! The coefficients are rounded to a bounded number of bits, with a bound of their error. The sign of a coefficient that is
//! smaller than this bound is unknown. If the sign at a midpoint is unknown, the exact polynomial is evaluated there. If its
//! value is 0, the midpoint is an exact root, which is divided out; otherwise the search starts again with twice the
//! bits. So the answer is always exact, although most of the arithmetic is not.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::DivRound;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;
use malachite::base::rounding_modes::RoundingMode;

use super::pair::separate;
use super::sign_changes::{Changes, sign_changes};
use crate::error::Invariant;
use crate::exact::Dyadic;
use crate::poly::integer_sign as sign;
use crate::poly::{IntegerPolynomial, divide_exactly, negate_odd, shift_by_one, sign_at};

/// The first attempt works with this many bits more than the degree.
const GUARD_BITS: u64 = 64;

/// The isolated real roots of a polynomial: the `exact` roots, and open intervals that hold one root each of `rest`, which is the
/// polynomial divided by the factors of the exact roots.
#[derive(Clone, Debug)]
pub(crate) struct Isolation {
    pub(crate) exact: Vec<Dyadic>,
    pub(crate) rest: IntegerPolynomial,
    pub(crate) intervals: Vec<(Dyadic, Dyadic)>,
}

/// Isolates all real roots of a squarefree polynomial of positive degree.
///
/// At both ends of every interval `rest` is not 0, and it has opposite signs there.
pub(crate) fn isolate(f: &IntegerPolynomial) -> Isolation {
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
        return Isolation {
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
        let mut search = Bisection {
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
pub(crate) fn root_bound_exponent(f: &[Integer]) -> i64 {
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

impl Node {
    /// The number of sign changes of the exact coefficients, as far as their signs are known.
    fn changes(&self) -> Changes {
        let signs = self.coefficients.iter().map(|c| known_sign(c, &self.error));
        Changes::count(signs)
    }
}

struct Bisection<'a> {
    exact: &'a IntegerPolynomial,
    exponent: i64,
    found: Vec<(Dyadic, Dyadic)>,
}

impl Bisection<'_> {
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
            match node.changes() {
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
                    // A right half without roots is dropped at once: on the way to a root near 0 there are as many of them as
                    // the root has leading zero bits.
                    if !matches!(right.changes(), Changes::None) {
                        stack.push(right);
                    }
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

/// The sign of the second derivative on the interval of a node, if the node is deep in the tree and this sign is proved to be
/// the same on the whole interval.
///
/// Lemma 3. A second difference b0 − 2 b1 + b2 of rounded coefficients is less than twice `error` away from the exact one,
/// and where all of the exact ones have one sign, so has the second derivative.
/// Proof. By Lemma 1 b0 + b2 and 2 b1 are each less than 2 `error` below the exact ones, and not above. The differences,
/// times a positive number, are the Bernstein coefficients of the second derivative.
/// Law: `a_certain_second_derivative_is_right`.
fn convexity(node: &Node) -> Option<i8> {
    /// At this depth halving has separated all roots that are not very close together.
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

/// The sign of a number that is less than `error` away from `value`; `None` if both signs are possible.
fn known_sign(value: &Integer, error: &Integer) -> Option<i8> {
    (value.unsigned_abs_ref() >= error.unsigned_abs_ref()).then(|| sign(value))
}

#[cfg(test)]
mod laws;
