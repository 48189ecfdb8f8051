//! Rational points of conics `w² = k(t0, t1)` over Q, and parametrizations by the lines through a point.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{CheckedSqrt, DivExact, ExtendedGcd, Gcd, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;

use super::legendre::{Solution, primitive, solve};
use crate::poly::{BinaryForm, IntegerPolynomial};

/// Points with |t0|, |t1| up to this number are tried first, because they give the simplest parametrizations.
const SMALL: i64 = 24;

/// The largest number of these points that are tried.
const MOST_POINTS: usize = 6;

/// Sublattices of these indices are tried to make the coefficients of a parametrization smaller.
const INDICES: [i64; 6] = [2, 3, 5, 7, 11, 13];

type Vector = [Integer; 3];

/// The parametrization (t0, t1, w), each a quadratic form `c0 a² + c1 ab + c2 b²`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ConicParametrization([[Integer; 3]; 3]);

/// The rational points of a conic, as far as they are known.
pub(super) enum Points {
    /// Rational points (t0, t1, w), at least one.
    Found(Vec<Vector>),
    /// The outcome of [`Solution`], if no small point was found.
    Other(Solution),
}

/// Rational points of `w² = k(t0, t1)` for a squarefree form of degree 2.
pub(super) fn points(k: &BinaryForm) -> Points {
    let small = small_points(k);
    if !small.is_empty() {
        return Points::Found(small);
    }
    // k = g (a, b, c): 4ga w² = g² ((2a t0 + b t1)² − (b² − 4ac) t1²), so Z² = D X² + ga Y² with
    // Z = g (2a t0 + b t1), X = g t1, Y = 2w; a ≠ 0, since (1, 0, 0) would be a small point, and D ≠ 0, since k is
    // squarefree.
    let g = k.content();
    let [a, b, c] = [0, 1, 2].map(|i| k.coefficient(i).div_exact(&g));
    let discriminant = if b == 0 {
        vec![Integer::from(-4), a.clone(), c]
    } else {
        vec![(&b).square() - Integer::from(4) * &a * &c]
    };
    match solve(&discriminant, &[g.clone(), a.clone()]) {
        Solution::Point([x, y, z]) => {
            // All coordinates are multiplied by 2ga: t0 = Z − bX, t1 = 2aX, w = gaY.
            let t0 = z - b * &x;
            let t1 = Integer::from(2) * &a * x;
            Points::Found(vec![primitive([t0, t1, g * a * y])])
        }
        other => Points::Other(other),
    }
}

/// Coprime (t0, t1) with small entries for which k is a square, the smallest first.
fn small_points(k: &BinaryForm) -> Vec<Vector> {
    let mut found = Vec::new();
    for size in 1..=SMALL {
        for other in -size..=size {
            for (t0, t1) in [(size, other), (other, size)] {
                let both = other.abs() == size && t0 != size;
                let coprime = t0.unsigned_abs().gcd(t1.unsigned_abs()) == 1;
                if both || !coprime || found.len() >= MOST_POINTS {
                    continue;
                }
                let (t0, t1) = (Integer::from(t0), Integer::from(t1));
                let value = k.evaluate(&t0, &t1);
                if value >= 0
                    && let Some(w) = value.checked_sqrt()
                {
                    found.push([t0, t1, w]);
                }
            }
        }
    }
    found
}

/// While the size has at most this many bits, every smaller parametrization is accepted.
const ANY_FALL_BITS: u64 = 20;

impl ConicParametrization {
    /// Parametrizes all points of the conic by the lines through one of them, P. The line through P in the direction D meets
    /// the conic again in `Q(D) P − B(P, D) D`, where Q = k − w² and B is its polar form. D runs through the combinations of a
    /// basis of Z³/ZP.
    pub(super) fn through(k: &BinaryForm, point: &Vector) -> Self {
        let [d, e] = complement(point);
        let (q_d, q_e, b_de) = (quadric(k, &d), quadric(k, &e), polar(k, &d, &e));
        let (p_d, p_e) = (polar(k, point, &d), polar(k, point, &e));
        let forms = [0, 1, 2].map(|i| {
            [
                &q_d * &point[i] - &p_d * &d[i],
                &b_de * &point[i] - &p_d * &e[i] - &p_e * &d[i],
                &q_e * &point[i] - &p_e * &e[i],
            ]
        });
        Self(forms).reduced()
    }

    /// t0, t1 and w as polynomials in t = a/b, or in b/a.
    pub(super) fn polynomials(&self, inverse: bool) -> [IntegerPolynomial; 3] {
        self.0.each_ref().map(|form| {
            let mut coefficients = form.to_vec();
            if !inverse {
                coefficients.reverse();
            }
            IntegerPolynomial::from_coefficients_asc(coefficients)
        })
    }

    /// The same conic parametrized with smaller coefficients. Bases of the lattice of (a, b) and of sublattices are tried as
    /// long as the sum of the squares of the coefficients becomes smaller.
    fn reduced(self) -> Self {
        let mut best = self.primitive();
        let mut size = best.size();
        loop {
            let largest = size.significant_bits() / 4 + 1;
            let shifts = (0..largest).rev().flat_map(|bits| {
                let step = Integer::ONE << bits;
                [step.clone(), -step]
            });
            let shears = shifts.flat_map(|m| {
                let (zero, one) = (Integer::ZERO, Integer::ONE);
                [
                    [[one.clone(), m.clone()], [zero.clone(), one.clone()]],
                    [[one.clone(), zero], [m, one]],
                ]
            });
            let sublattices = INDICES.iter().flat_map(|&p| {
                let matrix = |m: [[i64; 2]; 2]| m.map(|row| row.map(Integer::from));
                let along = (0..p).map(move |j| matrix([[p, j], [0, 1]]));
                along.chain([matrix([[1, 0], [0, p]])])
            });
            let better = shears.chain(sublattices).find_map(|matrix| {
                let other = best.substituted(&matrix).primitive();
                let other_size = other.size();
                // A large size must become smaller by a 64th, so that the number of steps is logarithmic in it.
                let falls = if size.significant_bits() > ANY_FALL_BITS {
                    (&size - &other_size) << 6u64 > size
                } else {
                    other_size < size
                };
                falls.then_some((other, other_size))
            });
            match better {
                Some(found) => (best, size) = found,
                None => return best,
            }
        }
    }

    /// The parametrization with (m00 a + m01 b, m10 a + m11 b) in place of (a, b).
    fn substituted(&self, [[p, q], [r, s]]: &[[Integer; 2]; 2]) -> Self {
        let two = Integer::from(2);
        Self(self.0.each_ref().map(|[c0, c1, c2]| {
            [
                c0 * p * p + c1 * p * r + c2 * r * r,
                &two * c0 * p * q + c1 * (p * s + q * r) + &two * c2 * r * s,
                c0 * q * q + c1 * q * s + c2 * s * s,
            ]
        }))
    }

    fn primitive(self) -> Self {
        let [x, y, z] = self.0;
        let [a, b, c] = x;
        let [d, e, f] = y;
        let [g, h, i] = z;
        let [a, b, c, d, e, f, g, h, i] = primitive([a, b, c, d, e, f, g, h, i]);
        Self([[a, b, c], [d, e, f], [g, h, i]])
    }

    fn size(&self) -> Integer {
        let squares = self.0.iter().flatten().map(Square::square);
        squares.fold(Integer::ZERO, |sum, square| sum + square)
    }
}

/// Q(v) = k(t0, t1) − w²
fn quadric(k: &BinaryForm, [t0, t1, w]: &Vector) -> Integer {
    k.evaluate(t0, t1) - w.square()
}

/// B(u, v) = Q(u + v) − Q(u) − Q(v)
fn polar(k: &BinaryForm, u: &Vector, v: &Vector) -> Integer {
    let sum = [&u[0] + &v[0], &u[1] + &v[1], &u[2] + &v[2]];
    quadric(k, &sum) - quadric(k, u) - quadric(k, v)
}

/// Two vectors that together with a primitive vector are a basis of Z³.
fn complement([x, y, z]: &Vector) -> [Vector; 2] {
    let (zero, one) = (Integer::ZERO, Integer::ONE);
    if *x == 0 && *y == 0 {
        return [
            [one.clone(), zero.clone(), zero.clone()],
            [zero.clone(), one, zero],
        ];
    }
    let (g, alpha, beta) = x.extended_gcd(y);
    let g = Integer::from(g);
    let (_, gamma, delta) = (&g).extended_gcd(z);
    let (x, y) = (x.div_exact(&g), y.div_exact(&g));
    let second = [-(&delta * x), -(delta * y), gamma];
    [[-beta, alpha, zero], second]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_parametrization_stays_on_its_conic(
            a in -50i64..50, b in -50i64..50, t0 in -30i64..30, t1 in 1i64..30, w in -30i64..30, s in -20i64..20,
        ) {
            // c is chosen so that (t0 t1, t1², w t1²) is a point of the scaled conic.
            let c = w * w - a * t0 * t0 - b * t0 * t1;
            let scale = t1 * t1;
            let k = BinaryForm::from_coefficients([a * scale, b * scale, c].map(Integer::from).to_vec());
            prop_assume!(b * b * scale * scale - 4 * a * scale * c != 0);
            let Points::Found(points) = points(&k) else {
                return Err(TestCaseError::fail("(t0, t1², w t1) is one"));
            };
            for point in points {
                prop_assert_eq!(quadric(&k, &point), 0);
                let conic = ConicParametrization::through(&k, &primitive(point));
                let at = Integer::from(s);
                let [u, v, w] = conic.polynomials(false).map(|p| {
                    p.coefficients_asc().iter().rev().fold(Integer::ZERO, |sum, c| sum * &at + c)
                });
                prop_assert_eq!(quadric(&k, &[u, v, w]), 0);
                // The three forms are independent, so the map is not constant.
                let [[a, b, c], [d, e, f], [g, h, i]] = &conic.0;
                let determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
                prop_assert!(determinant != 0);
            }
        }
    }
}
