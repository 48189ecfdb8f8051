//! Proofs of a zero without a change of sign: f comes nearer to 0 in a ball than any positive minimum of f could.

use malachite::base::num::logic::traits::SignificantBits;

use super::chart::sphere_about;
use super::exact::{exact_difference, power_of_two, squared_length};
use crate::exact::Rational;
use crate::intervals::{Field, rationals};
use crate::poly::SparsePolynomial;

/// Evaluations use at most this many bits.
const MAX_BITS: i64 = 1 << 21;

/// Proves that f has a zero in the closed ball of radius d about p, if it has one at a non-degenerate critical point inside the
/// ball. `start` must hold the nearest doubles of that point.
///
/// Theorem (Jeronimo, Perrucci, Tsigaridas, *On the minimum of a polynomial function on a basic closed semialgebraic set and
/// applications*, SIAM J. Optim. 23 (2013), Theorem 1). Let T ⊂ ℝⁿ be given by m equations and inequalities between polynomials
/// in ℤ[x₁ … xₙ], and let D be even. If these and f ∈ ℤ[x₁ … xₙ] have degrees at most D and coefficients of size
/// at most H, then the minimum of f on a compact connected component of T is 0, or at least (2^(4−n/2) H̃ Dⁿ)^(−n 2ⁿ Dⁿ) in
/// size, where H̃ = max(H, 2n + 2m).
///
/// Here n = 3, m = 1, and T is the ball {h ≥ 0} for the integer multiple h of d² − |x − p|². The ball is compact and connected.
/// [`gap_bits`] is the number of bits of that bound.
///
/// Lemma 16. If |f(x)| is less than the bound at one point x of the ball, f has a zero in the ball.
///
/// Proof. Let f(x) ≥ 0, else take −f. The minimum is at most f(x), so by the theorem it is not positive. The ball is connected,
/// so f is 0 somewhere between x and the point of the minimum.
///
/// Laws: `the_gap_is_that_of_the_theorem`, `the_gap_is_below_known_minima`, `positive_minima_are_no_zeros`.
pub(super) fn zero_in_ball(
    field: &Field,
    p: &[Rational; 3],
    d: &Rational,
    start: [f64; 3],
) -> Option<[Rational; 3]> {
    let f = field.polynomial().primitive();
    let bits = gap_bits(&f, p, d).filter(|bits| *bits <= MAX_BITS)?;
    let derivatives = [0, 1, 2].map(|i| f.derivative(i));
    let second = derivatives
        .each_ref()
        .map(|g| [0, 1, 2].map(|i| g.derivative(i)));
    let bound = power_of_two(-bits);
    let mut x = rationals(start);
    let mut precision = 64;
    loop {
        let gradient = derivatives.each_ref().map(|g| g.evaluate(&x));
        let hessian = second
            .each_ref()
            .map(|row| row.each_ref().map(|g| g.evaluate(&x)));
        let step = solved(&hessian, &gradient)?;
        precision = (2 * precision).min(bits + 64);
        x = std::array::from_fn(|i| {
            let next = &x[i] - &step[i];
            // Rounding to the simplest fraction keeps rational points exact.
            let width = power_of_two(-precision);
            Rational::simplest_between(&(&next - &width), &(&next + &width))
        });
        if squared_length(&exact_difference(p, &x)) > d * d {
            return None;
        }
        if f.evaluate(&x).abs() < bound {
            return Some(x);
        }
        if precision >= bits + 64 {
            return None;
        }
    }
}

/// A number of bits such that 2^(−bits) is at most the bound of the theorem in [`zero_in_ball`]; `None` if it is too large for
/// an integer. The exponent of the theorem is doubled as a margin, which costs one more step of Newton's method.
fn gap_bits(f: &SparsePolynomial<3>, p: &[Rational; 3], d: &Rational) -> Option<i64> {
    let height = |g: &SparsePolynomial<3>| {
        let bits = g.terms().map(|(_, c)| c.numerator().significant_bits());
        bits.max()
    };
    // H̃ ≥ 8 = 2³, and integers of h bits are less than 2^h.
    let height = height(f)?
        .max(height(&sphere_about(p, d).primitive())?)
        .max(3);
    let degree = i64::try_from(f.degree()?.max(2)).ok()?;
    let even = degree + degree % 2;
    // D < 2^log
    let log = 64 - i64::from(even.leading_zeros());
    // 2^(5/2) H̃ D³ ≤ 2^(3 + height + 3 log), to the power of 3·2³·D³.
    let base = i64::try_from(height).ok()?.checked_add(3 + 3 * log)?;
    even.checked_pow(3)?.checked_mul(2 * 24)?.checked_mul(base)
}

/// A⁻¹ b by Cramer's rule; `None` if A is singular. A variable that does not occur has a row and a column of zeros, and is left
/// unchanged.
fn solved(a: &[[Rational; 3]; 3], b: &[Rational; 3]) -> Option<[Rational; 3]> {
    let mut a = a.clone();
    for i in 0..3 {
        if a[i].iter().all(Rational::is_zero) && b[i].is_zero() {
            a[i][i] = Rational::one();
        }
    }
    let determinant = |m: &[[Rational; 3]; 3]| {
        let minor = |i: usize, j: usize| &m[1][i] * &m[2][j] - &m[1][j] * &m[2][i];
        &m[0][0] * &minor(1, 2) - &m[0][1] * &minor(0, 2) + &m[0][2] * &minor(0, 1)
    };
    let whole = determinant(&a);
    let inverse = whole.recip()?;
    Some(std::array::from_fn(|column| {
        let mut replaced = a.clone();
        for (row, value) in replaced.iter_mut().zip(b) {
            row[column] = value.clone();
        }
        determinant(&replaced) * &inverse
    }))
}

#[cfg(test)]
mod tests {
    use super::super::exact::critical_point;
    use super::*;
    use crate::poly::Ring;
    use malachite::Integer;
    use malachite::base::num::arithmetic::traits::Pow;

    fn variables() -> [SparsePolynomial<3>; 3] {
        [0, 1, 2].map(SparsePolynomial::<3>::variable)
    }

    fn constant(c: i64) -> SparsePolynomial<3> {
        SparsePolynomial::constant(Rational::from(c))
    }

    fn power(f: &SparsePolynomial<3>, k: u32) -> SparsePolynomial<3> {
        (0..k).fold(constant(1), |power, _| power.times(f))
    }

    fn ball() -> ([Rational; 3], Rational) {
        (rationals([0.0; 3]), Rational::from(2))
    }

    /// The polynomial (2^height x − 1)² + (y − x^k)² + (z − y^k)² + z^(2k), which has no real zero. Where the first three
    /// squares vanish, its value is 2^(−2·height·k³), so its minimum is at most that.
    fn chain(height: u32, k: u32) -> (SparsePolynomial<3>, Rational) {
        let [x, y, z] = variables();
        let first = x.scaled(&power_of_two(height.into())).minus(&constant(1));
        let second = y.minus(&power(&x, k));
        let third = z.minus(&power(&y, k));
        let f = first
            .squared()
            .plus(&second.squared())
            .plus(&third.squared());
        let f = f.plus(&power(&z, 2 * k));
        (
            f,
            power_of_two(-2 * i64::from(height) * i64::from(k).pow(3)),
        )
    }

    /// The square of the inverse of the theorem's bound, computed in integers from its statement, (2^(4−n/2) H̃ Dⁿ)^(n 2ⁿ Dⁿ).
    /// The square makes 2^(n/2) an integer power.
    fn squared_inverse_of_the_bound(
        f: &SparsePolynomial<3>,
        p: &[Rational; 3],
        d: &Rational,
    ) -> Integer {
        let (n, m) = (3u64, 1u64);
        let largest = |g: &SparsePolynomial<3>| {
            g.primitive()
                .terms()
                .map(|(_, c)| c.abs().numerator())
                .max()
        };
        let height = largest(f).max(largest(&sphere_about(p, d))).unwrap();
        let height = height.max(Integer::from(2 * n + 2 * m));
        let degree = f.degree().unwrap().max(2).next_multiple_of(2);
        let base = Integer::from(2).pow(8 - n) * (height * Integer::from(degree.pow(3))).pow(2);
        base.pow(n * 2u64.pow(3) * degree.pow(3))
    }

    #[test]
    fn the_gap_is_that_of_the_theorem() {
        let [x, y, z] = variables();
        let mut forms = vec![
            x.clone(),
            x.times(&y).minus(&z),
            power(&x, 3).plus(&y),
            // This polynomial has height 1, and a degree far above the next lower power of two.
            power(&x, 6).plus(&y),
            power(&z, 4).minus(&constant(1 << 40)),
        ];
        forms.extend([chain(1, 1).0, chain(7, 1).0, chain(30, 2).0, chain(3, 3).0]);
        let centers = [
            rationals([0.0; 3]),
            rationals([0.1, 0.25, -3.0]),
            ["1/3", "2/7", "0"].map(|q| q.parse().unwrap()),
        ];
        for f in forms {
            for p in &centers {
                for d in ["1", "1/10", "12345678901/7"] {
                    let d: Rational = d.parse().unwrap();
                    let bits = gap_bits(&f.primitive(), p, &d).unwrap();
                    let bound = squared_inverse_of_the_bound(&f, p, &d);
                    // 2^bits is at least the square of the inverse of the bound, and not much larger.
                    let size = i64::try_from(bound.significant_bits()).unwrap();
                    assert!(bits >= size - 1, "{bits} {size}");
                    assert!(bits <= 2 * size, "{bits} {size}");
                }
            }
        }
    }

    /// The solution of a system satisfies it; a variable that does not occur stays.
    #[test]
    fn systems_are_solved() {
        let rows = [[2, -1, 3], [5, 7, -2], [-4, 6, 1]].map(|row| row.map(Rational::from));
        let b = [1, -2, 11].map(Rational::from);
        let x = solved(&rows, &b).expect("the matrix is regular");
        for (row, right) in rows.iter().zip(&b) {
            let left: Rational = row.iter().zip(&x).map(|(a, x)| a * x).sum();
            assert_eq!(left, *right);
        }
        let flat = [[2, 1, 0], [1, 3, 0], [0, 0, 0]].map(|row| row.map(Rational::from));
        let found = solved(&flat, &[3, 4, 0].map(Rational::from));
        assert_eq!(found, Some([1, 1, 0].map(Rational::from)));
        assert_eq!(solved(&flat, &[3, 4, 1].map(Rational::from)), None);
    }

    /// The bound is below the minimum of a quadratic form, which linear algebra gives, below an upper bound of the minimum of
    /// the chains, and below the constant minimum of a square plus a constant.
    #[test]
    fn the_gap_is_below_known_minima() {
        let (p, d) = ball();
        for (height, k) in [
            (1, 1),
            (5, 1),
            (20, 1),
            (60, 1),
            (1, 2),
            (10, 2),
            (40, 2),
            (2, 3),
            (12, 3),
        ] {
            let (f, above) = chain(height, k);
            let bits = gap_bits(&f.primitive(), &p, &d).unwrap();
            assert!(power_of_two(-bits) < above, "{height} {k}");
            if k == 1 {
                let [_, minimum] = quadratic_minimum(&f);
                assert!(minimum.signum() > 0 && minimum <= above);
                assert!(power_of_two(-bits) < minimum);
            }
        }
        // 2^k (x² − 2)² + 1 has the minimum 1.
        let [x, _, _] = variables();
        let f = power(&x.squared().minus(&constant(2)), 2)
            .scaled(&power_of_two(50))
            .plus(&constant(1));
        assert!(power_of_two(-gap_bits(&f.primitive(), &p, &d).unwrap()) < Rational::one());
    }

    /// The value at 0 and the minimum of a positive definite quadratic polynomial.
    fn quadratic_minimum(f: &SparsePolynomial<3>) -> [Rational; 2] {
        let origin = rationals([0.0; 3]);
        let gradient = [0, 1, 2].map(|i| f.derivative(i).evaluate(&origin));
        let hessian =
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| f.derivative(i).derivative(j).evaluate(&origin)));
        let step = solved(&hessian, &gradient).unwrap();
        [f.evaluate(&origin), f.evaluate(&step.map(|x| -x))]
    }

    /// No zero is claimed where the minimum is positive, however small it is. A zero is claimed where the minimum is 0 at an
    /// irrational point.
    #[test]
    fn positive_minima_are_no_zeros() {
        let (p, d) = ball();
        for (height, k) in [(1, 1), (20, 1), (60, 1), (10, 2)] {
            let (f, _) = chain(height, k);
            let field = Field::new(&f);
            let start = [0.5f64.powi(i32::try_from(height).unwrap()), 0.0, 0.0];
            let start = critical_point(&field, start).expect("a critical point");
            assert_eq!(zero_in_ball(&field, &p, &d, start), None, "{height} {k}");
        }
        let [x, y, z] = variables();
        // Callers know the critical point to the last place of doubles.
        let near = [2f64.sqrt(), 0.0, 0.0];
        let square = power(&x.squared().minus(&constant(2)), 2)
            .plus(&y.squared())
            .plus(&z.squared());
        for bits in [20, 100, 1000, 1500] {
            let f = square.plus(&SparsePolynomial::constant(power_of_two(-bits)));
            assert_eq!(zero_in_ball(&Field::new(&f), &p, &d, near), None, "{bits}");
            let f = square.minus(&SparsePolynomial::constant(power_of_two(-bits)));
            // f has zeros, but not at the critical point.
            assert_eq!(zero_in_ball(&Field::new(&f), &p, &d, near), None, "{bits}");
        }
        let found = zero_in_ball(&Field::new(&square), &p, &d, near);
        let found = found.expect("a zero at the square root of 2");
        assert!((found[0].to_f64() - 2f64.sqrt()).abs() < 1e-15);
        // There is no critical point inside this smaller ball.
        let small = Rational::one();
        assert_eq!(zero_in_ball(&Field::new(&square), &p, &small, near), None);
    }
}
