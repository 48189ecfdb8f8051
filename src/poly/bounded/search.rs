//! Descartes' rule by halving, in a bounded number of bits.

use std::borrow::Cow;

use super::super::isolate::Changes;
use super::SLACK;
use super::bernstein::Bernstein;
use super::fixed::{Fixed, Fraction};
use super::newton::OnUnitInterval;

/// Roots closer than that are left to exact arithmetic.
const MAX_DEPTH: u32 = 40;

/// Why a number of bits proves nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unproved {
    /// More bits may do.
    Bits,
    /// Roots are multiple or very close: no number of bits here does.
    Close,
}

impl Unproved {
    /// Tries again, if that may help.
    pub(crate) fn with_more_bits<T>(
        self,
        retry: impl FnOnce() -> Result<T, Self>,
    ) -> Result<T, Self> {
        match self {
            Self::Bits => retry(),
            Self::Close => Err(self),
        }
    }
}

/// An interval (index, index + 1) · 2^(−depth) with exactly one root, and the sign at its lower end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Isolated {
    pub(super) index: u64,
    pub(super) depth: u32,
    pub(super) sign_low: i8,
}

impl Isolated {
    /// The ends of the interval.
    pub(super) fn bounds<const W: usize>(&self) -> [Fraction<W>; 2] {
        [self.index, self.index + 1].map(|index| Fraction::dyadic(index, self.depth))
    }
}

impl<const W: usize> OnUnitInterval<W> {
    /// Laguerre's rule: `f(y) / (1 − y) = Σ S_k y^k` with the partial sums S_k = c_0 + … + c_k, the last one for ever. So f has
    /// as many roots in (0, 1) as these have changes of sign, or fewer by an even number. Cost: d additions.
    pub(super) fn changes_of_partial_sums(&self) -> Changes {
        let (mut sum, mut error) = (Fixed::ZERO, 0.0);
        let terms = self.coefficients.iter().zip(&self.errors);
        Changes::count(terms.map(|(c, own)| {
            sum = sum.plus(*c);
            error += own;
            sum.known_sign(whole(error * SLACK))
        }))
    }

    /// The only root in (0, 1).
    pub(super) fn only_root(&self) -> Result<Isolated, Unproved> {
        let sign_low = self.coefficients[0].known_sign(whole(self.errors[0]));
        Ok(Isolated {
            index: 0,
            depth: 0,
            sign_low: sign_low.ok_or(Unproved::Bits)?,
        })
    }
}

struct Node<'a, const W: usize> {
    index: u64,
    depth: u32,
    polynomial: Bernstein<'a, W>,
}

impl<const W: usize> Bernstein<'_, W> {
    fn sign(&self, k: usize) -> Option<i8> {
        self.coefficients[k].known_sign(whole(self.errors[k]))
    }
}

/// All roots in (0, 1), each alone in its interval; an error if the coefficients are not known well enough to tell (a root
/// at 1 or at a point of bisection, multiple or close roots).
///
/// At most 4d + 64 intervals are looked at, each of d²/2 means.
pub(super) fn isolate<const W: usize>(
    polynomial: Bernstein<'_, W>,
) -> Result<Vec<Isolated>, Unproved> {
    let length = polynomial.coefficients.len();
    let mut left = 4 * length + 64;
    let mut found = Vec::new();
    // There is no root at 1.
    polynomial.sign(length - 1).ok_or(Unproved::Bits)?;
    let mut stack = Vec::new();
    let mut next = Some(Node {
        index: 0,
        depth: 0,
        polynomial,
    });
    while let Some(node) = next.take().or_else(|| stack.pop()) {
        left = left.checked_sub(1).ok_or(Unproved::Close)?;
        match Changes::count((0..length).map(|k| node.polynomial.sign(k))) {
            Changes::None => {}
            Changes::One => found.push(Isolated {
                index: node.index,
                depth: node.depth,
                sign_low: node.polynomial.sign(0).ok_or(Unproved::Bits)?,
            }),
            Changes::More => {
                if node.depth == MAX_DEPTH {
                    return Err(Unproved::Close);
                }
                let (low, high) = halve(node);
                high.polynomial.sign(0).ok_or(Unproved::Bits)?;
                stack.push(high);
                next = Some(low);
            }
        }
    }
    Ok(found)
}

/// De Casteljau at the midpoint, every mean rounded down, by 0 or half an ulp.
fn halve<const W: usize>(node: Node<'_, W>) -> (Node<'static, W>, Node<'static, W>) {
    let mut high = node.polynomial.coefficients;
    let mut high_errors = node.polynomial.errors.into_owned();
    let degree = high.len() - 1;
    let mut low = Vec::with_capacity(degree + 1);
    let mut low_errors = Vec::with_capacity(degree + 1);
    for left in (0..=degree).rev() {
        low.push(high[0]);
        low_errors.push(high_errors[0]);
        for k in 0..left {
            high[k] = high[k].mean(high[k + 1]);
        }
        for k in 0..left {
            high_errors[k] = mean_error(high_errors[k], high_errors[k + 1]);
        }
    }
    let child = |index, coefficients, errors| Node {
        index,
        depth: node.depth + 1,
        polynomial: Bernstein {
            coefficients,
            errors: Cow::Owned(errors),
        },
    };
    (
        child(2 * node.index, low, low_errors),
        child(2 * node.index + 1, high, high_errors),
    )
}

/// The error of a mean. The doubles are rounded by less than their 2^(−51)th part, the mean by half an ulp.
fn mean_error(a: f64, b: f64) -> f64 {
    const HALF: f64 = 0.5 + f64::EPSILON;
    (a + b) * HALF + 1.0
}

/// More than the error.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "positive, and a cast of what is too large is the largest number"
)]
pub(super) fn whole(error: f64) -> u128 {
    /// 2^62
    const LARGE: f64 = 4_611_686_018_427_387_904.0;
    if error < LARGE {
        u128::from(error as u64) + 1
    } else {
        (error as u128).saturating_add(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::Integer;
    use proptest::prelude::*;

    /// Π (q_i y − p_i), as a polynomial on (0, 1).
    fn with_roots(roots: &[(i64, i64)]) -> OnUnitInterval<4> {
        let mut c = vec![Integer::from(1)];
        for (p, q) in roots {
            c.push(Integer::from(0));
            for k in (0..c.len()).rev() {
                let below = if k > 0 {
                    &c[k - 1] * Integer::from(*q)
                } else {
                    Integer::from(0)
                };
                c[k] = below - &c[k] * Integer::from(*p);
            }
        }
        let numbers: Vec<_> = c.iter().map(Fixed::normalized).collect();
        let largest = numbers
            .iter()
            .map(|(_, exponent)| *exponent)
            .max()
            .unwrap_or(0);
        let down = largest - Fixed::<4>::room_for(c.len());
        let cut = |(c, exponent): &(Fixed<4>, i64)| c.shifted_down(down - exponent);
        OnUnitInterval {
            coefficients: numbers.iter().map(cut).collect(),
            errors: vec![2.0; c.len()],
            error: 2 * c.len() as u128,
        }
    }

    proptest! {
        /// Built backwards: the rules say how many roots there are, or nothing.
        #[test]
        fn both_rules_find_the_roots(roots in prop::collection::vec((-30i64..30, 1i64..20), 1..12)) {
            prop_assume!(roots.iter().all(|(p, q)| *p != 0 && p != q));
            let f = with_roots(&roots);
            let inside: Vec<_> = roots.iter().filter(|(p, q)| 0 < *p && p < q).collect();
            match f.changes_of_partial_sums() {
                Changes::None => prop_assert_eq!(inside.len(), 0),
                Changes::One => {
                    prop_assert_eq!(inside.len(), 1);
                    let negative = roots.iter().filter(|(p, _)| *p > 0).count() % 2 == 1;
                    prop_assert_eq!(f.only_root().map(|root| root.sign_low), Ok(if negative { -1 } else { 1 }));
                }
                Changes::More => {}
            }
            let inverses = super::super::bernstein::inverse_binomials(roots.len());
            let errors = f.bernstein_errors(&inverses);
            if let Ok(found) = isolate(f.to_bernstein(&inverses, &errors)) {
                prop_assert_eq!(found.len(), inside.len());
                for place in found {
                    // index < 2^depth p/q < index + 1
                    let within = inside.iter().filter(|(p, q)| {
                        let (p, q) = (i128::from(*p) << place.depth, i128::from(*q));
                        i128::from(place.index) * q < p && p < i128::from(place.index + 1) * q
                    });
                    prop_assert_eq!(within.count(), 1);
                }
            }
        }
    }
}
