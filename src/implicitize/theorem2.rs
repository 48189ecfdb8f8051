//! Theorem 2: the implicit polynomial of a finite Fourier radius, Eqs. (5)–(9).

use malachite::Integer;
use malachite::base::num::basic::traits::One;

use super::expansion::primitive_parts;
use super::summed::SummedHarmonics;
use crate::bigint::FlatPolynomial;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::poly::{
    BinaryForm, PlanePolynomial, Ring, doubled_harmonics, from_harmonic_basis, harmonic_bits,
};
use crate::shape::{FourierRadius, ImplicitCurve};

/// The three homogeneous parts of `F = top − middle + low`, of degrees 2N+2, 2N+1 and 2N.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parts<R> {
    /// ρ^(N+1), with ρ = x² + y².
    pub top: R,
    /// `2 ρ^⌊N/2+1⌋ · odd`; `None` if there is no odd harmonic at all (N = 0).
    pub middle: Option<R>,
    /// `ρ·odd² − even²` for even N, `odd² − ρ·even²` for odd N.
    pub low: R,
}

/// The sums of `K_m ρ^…` over odd and over even m, each homogeneous: of degree N where m ≡ N
/// (mod 2), else N − 1. By Horner's rule in ρ; `None` for the odd sum of N = 0.
///
/// # Panics
/// If there is no K0.
pub fn parity_sums<R: Ring>(k: &[R], rho: &R) -> (Option<R>, R) {
    let horner = |start: usize| {
        k.iter()
            .skip(start)
            .step_by(2)
            .cloned()
            .reduce(|sum, next| sum.times(rho).plus(&next))
    };
    let even = horner(0).expect("a radius has a K0");
    (horner(1), even)
}

/// Squares away the odd powers of r, Eqs. (7) and (8): with `r = Σ K_n / r^n`,
///
/// - N even: `r² (r^N − odd)² = even²`,
/// - N odd: `(r^(N+1) − odd)² = r² even²`,
///
/// multiplied by `unit²`, where `odd` and `even` are `unit` times the sums of [`parity_sums`]
/// (integer coefficients need a common denominator). `rho_power(e)` is ρ^e.
pub fn square_away<R: Ring>(
    harmonics: usize,
    unit: &R,
    rho_power: impl Fn(usize) -> R,
    odd: Option<&R>,
    even: &R,
) -> Parts<R> {
    let rho = rho_power(1);
    let even_harmonics = harmonics.is_multiple_of(2);
    let top = unit.squared().times(&rho_power(harmonics + 1));
    let middle = odd.map(|odd| {
        let once = rho_power(harmonics / 2 + 1).times(&unit.times(odd));
        once.plus(&once)
    });
    let with_rho = |square: R, multiplied: bool| {
        if multiplied {
            square.times(&rho)
        } else {
            square
        }
    };
    let even_square = with_rho(even.squared(), !even_harmonics);
    let low = match odd {
        Some(odd) => with_rho(odd.squared(), even_harmonics).minus(&even_square),
        None => even_square.minus(&even_square).minus(&even_square),
    };
    Parts { top, middle, low }
}

/// The implicit polynomial F of a Fourier radius, stored as a pair of forms with about 2N short coefficients. F itself has 6N
/// long coefficients and is expanded only on request.
///
/// With `ρ = x² + y²` and r = odd + even on the unit circle (sums over odd and even harmonics),
/// F = `ρ^(N+1) − 2ρ^⌊N/2+1⌋ odd + low`, of degree 2(N+1), in polar form
/// `r^(2N) (r − r(θ)) (r + r(θ+π))`.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::implicitize::SquaredForm;
/// use stellate::shape::FourierRadius;
///
/// let circle = FourierRadius::new(vec![Rational::from(2)], vec![]);
/// let form = SquaredForm::new(&circle).unwrap();
/// let terms: Vec<_> = form.expand().polynomial().terms().collect();
/// assert_eq!(terms, [((2, 0), 1.into()), ((0, 2), 1.into()), ((0, 0), (-4).into())]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SquaredForm {
    /// The factor by which the stored sums are larger than those of the radius.
    unit: Integer,
    sums: SummedHarmonics,
    center: [Rational; 2],
}

impl SquaredForm {
    /// The pair of forms of a radius. Cost: two changes of basis, quasi-linear in their size.
    ///
    /// # Errors
    /// [`Error::Hypothesis`] if r is identically 0: then the curve is a point.
    pub fn new(radius: &FourierRadius) -> Result<Self> {
        if radius.is_zero() {
            return Err(Error::Hypothesis {
                statement: "Theorem 2",
                witness: "r = 0 for every angle is a single point, not a curve".into(),
            });
        }
        let n = radius.harmonics();
        let (denominator, cos, sin) = radius.over_common_denominator();
        let bits = harmonic_bits(cos.iter().zip(&sin).map(|(a, b)| [a, b]));
        let sum = |parity: usize| {
            let degree = if n % 2 == parity { n } else { n - 1 };
            let harmonics = (parity..=degree).step_by(2).map(|m| (m, &cos[m], &sin[m]));
            doubled_harmonics(degree, harmonics, bits)
        };
        let sums = SummedHarmonics {
            harmonics: n,
            odd: (n > 0).then(|| sum(1)),
            even: sum(0),
            bits,
        };
        Ok(Self {
            unit: denominator << 1u64,
            sums,
            center: radius.center().clone(),
        })
    }

    /// The number of harmonics N.
    #[must_use]
    pub fn harmonics(&self) -> usize {
        self.sums.harmonics
    }

    /// Whether F is the square of a polynomial: exactly when a0 and all even harmonics are 0.
    ///
    /// Otherwise F is irreducible over Q. Proof. In polar form, a factor of F is up to a power of r a product of some of `r −
    /// r(θ)` and `r + r(θ+π)`. A polynomial in x and y does not change under (r, θ) → (−r, θ+π), which exchanges these two.
    /// They are different exactly if the even part is not 0, so then the factor contains both or neither. A factor that
    /// contains neither is a form that divides the top part ρ^(N+1), so it is a power of ρ, which does not divide the low part
    /// because the N-th harmonic is not 0.
    #[must_use]
    pub fn is_perfect_square(&self) -> bool {
        self.sums.even.is_zero()
    }

    /// The two sides of Eq. (7) or (8) before they are squared, without the factor r that one of them has: `r^N − odd` (N even)
    /// or `r^(N+1) − odd` (N odd), and `even`. Both are multiplied by one integer.
    #[must_use]
    pub fn sides(&self) -> [PlanePolynomial; 2] {
        let plane = |parts: Vec<BinaryForm>| PlanePolynomial::from_parts(parts, Integer::ONE);
        [
            plane(self.left_side()),
            plane(vec![self.form(&self.sums.even)]),
        ]
    }

    /// `r^N − odd` or `r^(N+1) − odd`, multiplied by the unit.
    fn left_side(&self) -> Vec<BinaryForm> {
        let top = BinaryForm::rho_power(self.sums.harmonics.div_ceil(2)).scaled(&self.unit);
        let odd = self.sums.odd.as_ref().map(|odd| self.form(odd));
        let minus_odd = odd.map(|odd| odd.scaled(&Integer::from(-1)));
        std::iter::once(top).chain(minus_odd).collect()
    }

    /// F itself, primitive and with a positive first coefficient, even if it is a perfect square.
    #[must_use]
    pub fn expand_unreduced(&self) -> ImplicitCurve {
        let parts = primitive_parts(&self.sums, &self.unit);
        self.curve(PlanePolynomial::from_parts(parts, Integer::ONE))
    }

    /// The reduced implicit equation: F, or the G with F = G² if F is a perfect square.
    ///
    /// Cost: two squares and one product of forms of degree N. That is quasi-linear in the size of the answer, about 4N
    /// coefficients of 2N + 2·(bits of a coefficient) bits each.
    #[must_use]
    pub fn expand(&self) -> ImplicitCurve {
        if self.sums.harmonics > 0 && self.is_perfect_square() {
            // N is odd here: G = r^(N+1) − odd.
            let g = PlanePolynomial::from_parts(self.left_side(), Integer::ONE);
            return self.curve(g.primitive());
        }
        self.expand_unreduced()
    }

    /// One of the sums as a form in x and y.
    fn form(&self, sum: &FlatPolynomial) -> BinaryForm {
        let in_t = from_harmonic_basis(sum, self.sums.bits);
        BinaryForm::from_dehomogenized(in_t.len() - 1, in_t.to_polynomial())
    }

    fn curve(&self, f: PlanePolynomial) -> ImplicitCurve {
        ImplicitCurve::new(f).with_center(self.center.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The slow twin: the formulas of [`square_away`] on forms with coefficients of any size, made primitive.
    fn by_formulas(f: &SquaredForm) -> PlanePolynomial {
        let unit = BinaryForm::from_coefficients(vec![f.unit.clone()]);
        let (odd, even) = (
            f.sums.odd.as_ref().map(|odd| f.form(odd)),
            f.form(&f.sums.even),
        );
        let parts = square_away(
            f.sums.harmonics,
            &unit,
            BinaryForm::rho_power,
            odd.as_ref(),
            &even,
        );
        let minus_middle = parts.middle.map(|m| m.scaled(&Integer::from(-1)));
        let parts = [Some(parts.top), minus_middle, Some(parts.low)];
        PlanePolynomial::from_parts(parts.into_iter().flatten(), Integer::ONE).primitive()
    }

    /// Dyadic numbers, multiples of 1/3 and the like, integers with a common factor, and zeros.
    fn coefficient() -> impl Strategy<Value = Rational> {
        prop_oneof![
            Just(Rational::zero()),
            (-1.0f64..1.0).prop_map(|x| Rational::try_from(x).unwrap_or_default()),
            (any::<i32>(), 1i32..60).prop_map(|(p, q)| Rational::from(p) / Rational::from(q)),
            (-20i64..20).prop_map(|n| Rational::from(60 * n)),
            (any::<i64>(), 0i64..300).prop_map(|(n, e)| {
                Rational::from(n) * Rational::from(2).pow(-e).unwrap_or_default()
            }),
        ]
    }

    /// Numbers of harmonics around and beyond those at which the method changes.
    #[test]
    fn hundreds_of_harmonics() {
        for n in [377, 378, 379, 399, 400, 401, 520] {
            let numbers = |by: i64| -> Vec<Rational> {
                let number = |k: i64| Rational::from((k * k * by + 7 * k) % 1009 - 504);
                (0..=n).map(|k| number(k) / Rational::from(1024)).collect()
            };
            let form = SquaredForm::new(&FourierRadius::new(numbers(3), numbers(5)));
            let form = form.expect("the radius is not 0");
            let expanded = form.expand();
            assert!(*expanded.polynomial() == by_formulas(&form), "N = {n}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(96))]
        #[test]
        fn large_integers_say_what_the_formulas_say(
            cos in prop::collection::vec(coefficient(), 1..130),
            sin in prop::collection::vec(coefficient(), 1..130),
            kept in 0usize..4,
        ) {
            // All harmonics are kept, or only the odd ones, the even ones, or the last pair.
            let keep = |values: Vec<Rational>| {
                let last = values.len() - 1;
                let kept = |n: usize| match kept {
                    0 => true,
                    3 => n == last,
                    parity => n % 2 == parity % 2,
                };
                let values = values.into_iter().enumerate();
                values.map(|(n, c)| if kept(n) { c } else { Rational::zero() }).collect()
            };
            let radius = FourierRadius::new(keep(cos), keep(sin));
            prop_assume!(!radius.is_zero());
            let form = SquaredForm::new(&radius).map_err(|e| TestCaseError::fail(e.to_string()))?;
            let expanded = form.expand_unreduced();
            prop_assert!(expanded.polynomial().check_invariants());
            prop_assert_eq!(expanded.polynomial(), &by_formulas(&form));
            prop_assert_eq!(expanded.polynomial().degree(), Some(2 * radius.harmonics() + 2));
        }
    }
}
