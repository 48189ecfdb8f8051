//! Descartes' rule by halving, in a bounded number of bits.

use super::super::isolate::Changes;
use super::fixed::{Fixed, Fraction};

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

struct Node<const W: usize> {
    index: u64,
    depth: u32,
    coefficients: Vec<Fixed<W>>,
    error: u128,
}

/// All roots in (0, 1), each alone in its interval, from Bernstein coefficients known up to `error` ulps; /// an error if
/// that is not enough to tell (a root at 1 or at a point of bisection, multiple or close roots).
///
/// At most 4d + 64 intervals are looked at, each of d²/2 means.
pub(super) fn isolate<const W: usize>(
    coefficients: Vec<Fixed<W>>,
    error: u128,
) -> Result<Vec<Isolated>, Unproved> {
    let known = |c: &Fixed<W>, error| c.known_sign(error).ok_or(Unproved::Bits);
    let mut left = 4 * coefficients.len() + 64;
    let mut found = Vec::new();
    let mut stack = vec![Node {
        index: 0,
        depth: 0,
        coefficients,
        error,
    }];
    // There is no root at 1.
    stack[0]
        .coefficients
        .last()
        .map(|c| known(c, error))
        .transpose()?;
    while let Some(node) = stack.pop() {
        left = left.checked_sub(1).ok_or(Unproved::Close)?;
        let signs = node.coefficients.iter().map(|c| c.known_sign(node.error));
        match Changes::count(signs) {
            Changes::None => {}
            Changes::One => found.push(Isolated {
                index: node.index,
                depth: node.depth,
                sign_low: known(&node.coefficients[0], node.error)?,
            }),
            Changes::More => {
                if node.depth == MAX_DEPTH {
                    return Err(Unproved::Close);
                }
                let (low, high) = halve(node);
                known(&high.coefficients[0], high.error)?;
                stack.push(high);
                stack.push(low);
            }
        }
    }
    Ok(found)
}

/// De Casteljau at the midpoint, every mean rounded down: the error grows by at most d ulps.
fn halve<const W: usize>(node: Node<W>) -> (Node<W>, Node<W>) {
    let mut high = node.coefficients;
    let degree = high.len() - 1;
    let mut low = Vec::with_capacity(degree + 1);
    for step in 0..=degree {
        low.push(high[0]);
        let mut here = high[0];
        for k in 0..degree - step {
            let next = high[k + 1];
            high[k] = here.mean(next);
            here = next;
        }
    }
    let error = node.error + degree as u128;
    let child = |index, coefficients| Node {
        index,
        depth: node.depth + 1,
        coefficients,
        error,
    };
    (child(2 * node.index, low), child(2 * node.index + 1, high))
}
