//! Isolation of roots by Descartes' rule and bisection, in bounded arithmetic.

use super::super::sign_changes::Changes;
use super::ball::Balls;
use super::fixed::Fraction;

/// An interval is halved at most this often; roots that are closer are left to exact arithmetic.
const MAX_DEPTH: u32 = 40;

/// The reason why a number of bits proves nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unproved {
    /// More bits may be enough.
    Bits,
    /// Roots are multiple or very close, so bounded arithmetic proves nothing with any number of bits.
    Close,
}

impl Unproved {
    /// Calls `again` if more bits may help.
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
pub(super) struct IsolatingInterval {
    pub(super) index: u64,
    pub(super) depth: u32,
    pub(super) sign_low: i8,
}

impl IsolatingInterval {
    /// The ends of the interval.
    pub(super) fn bounds<const W: usize>(&self) -> [Fraction<W>; 2] {
        [self.index, self.index + 1].map(|index| Fraction::dyadic(index, self.depth))
    }
}

/// The roots in (0, 1) of a polynomial in powers, by Laguerre's rule. `f(y) / (1 − y) = Σ S_k y^k` with the partial sums S_k =
/// c_0 + … + c_k, where the last one is repeated for ever. So f has as many roots in (0, 1) as the S_k have changes of sign, or
/// fewer by an even number. `None` if that does not determine the number. Cost: d additions.
pub(super) fn by_partial_sums<const W: usize>(
    polynomial: &Balls<W>,
) -> Result<Option<Vec<IsolatingInterval>>, Unproved> {
    match polynomial.changes_of_partial_sums() {
        Changes::None => Ok(Some(Vec::new())),
        Changes::One => {
            let sign_low = polynomial.sign(0).ok_or(Unproved::Bits)?;
            let whole = IsolatingInterval {
                index: 0,
                depth: 0,
                sign_low,
            };
            Ok(Some(vec![whole]))
        }
        Changes::More => Ok(None),
    }
}

struct Node<const W: usize> {
    index: u64,
    depth: u32,
    polynomial: Balls<W>,
}

/// All roots in (0, 1) of a polynomial in the Bernstein basis, each alone in its interval. An error if the coefficients are not
/// known well enough to decide: for a root at 1 or at a point of bisection, and for multiple or close roots.
///
/// Descartes' rule: there are as many roots in (0, 1) as the coefficients have changes of sign, or fewer by an even number. A
/// coefficient whose sign is unknown may have either sign or be 0, and only a count that is the same in all these cases is used
/// ([`Changes::count`]). The signs at the ends of an interval are known, so no end is a root.
///
/// At most 4d + 64 intervals are examined, each of which takes d²/2 means.
pub(super) fn isolate<const W: usize>(
    polynomial: Balls<W>,
) -> Result<Vec<IsolatingInterval>, Unproved> {
    let length = polynomial.len();
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
        match node.polynomial.changes() {
            Changes::None => {}
            Changes::One => found.push(IsolatingInterval {
                index: node.index,
                depth: node.depth,
                sign_low: node.polynomial.sign(0).ok_or(Unproved::Bits)?,
            }),
            Changes::More => {
                if node.depth == MAX_DEPTH {
                    return Err(Unproved::Close);
                }
                let Node {
                    index,
                    depth,
                    polynomial,
                } = node;
                let [low, high] = polynomial.halves();
                high.sign(0).ok_or(Unproved::Bits)?;
                let child = |index, polynomial| Node {
                    index,
                    depth: depth + 1,
                    polynomial,
                };
                stack.push(child(2 * index + 1, high));
                next = Some(child(2 * index, low));
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roots::bounded::ball::ScaledBall;
    use crate::roots::bounded::bernstein::BernsteinTable;
    use malachite::Integer;
    use proptest::prelude::*;

    /// The product Π (q_i y − p_i), as a polynomial on (0, 1).
    fn with_roots(roots: &[(i64, i64)]) -> Balls<4> {
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
        let numbers = c.iter().map(|c| (ScaledBall::of_integer(c), 0));
        Balls::aligned(numbers).expect("the leading coefficient is not 0")
    }

    /// Laguerre's rule alone finds a single root, and decides that there is no root.
    #[test]
    fn partial_sums_find_a_single_root() {
        let found = by_partial_sums(&with_roots(&[(1, 2), (-3, 1)])).expect("certain signs");
        let [place] = found.expect("the rule decides")[..] else {
            panic!("there is one root");
        };
        assert_eq!((place.index, place.depth, place.sign_low), (0, 0, -1));
        let found = by_partial_sums(&with_roots(&[(-1, 2), (-3, 1)])).expect("certain signs");
        assert!(found.is_some_and(|places| places.is_empty()));
    }

    proptest! {
        /// For known roots, the rules give the number of roots or no answer.
        #[test]
        fn both_rules_find_the_roots(roots in prop::collection::vec((-30i64..30, 1i64..20), 1..12)) {
            prop_assume!(roots.iter().all(|(p, q)| *p != 0 && p != q));
            let f = with_roots(&roots);
            let inside: Vec<_> = roots.iter().filter(|(p, q)| 0 < *p && p < q).collect();
            if let Ok(Some(places)) = by_partial_sums(&f) {
                prop_assert_eq!(places.len(), inside.len());
                for place in places {
                    let negative = roots.iter().filter(|(p, _)| *p > 0).count() % 2 == 1;
                    prop_assert_eq!(place.sign_low, if negative { -1 } else { 1 });
                }
            }
            let table = BernsteinTable::of_degree(roots.len());
            if let Ok(found) = isolate(f.to_bernstein(&table)) {
                prop_assert_eq!(found.len(), inside.len());
                for place in found {
                    // The root is in the interval: index < 2^depth p/q < index + 1.
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
