//! Theorem 2: the implicit polynomial of a finite Fourier radius, Eqs. (5)–(9).

use malachite::Integer;
use malachite::base::num::basic::traits::One;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::poly::{BinaryForm, PlanePolynomial, Ring, doubled_form_from_harmonics};
use crate::shape::{FourierRadius, ImplicitCurve};

/// The three homogeneous parts of `F = top − middle + low`, of degrees 2N+2, 2N+1 and 2N.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parts<R> {
    /// ρ^(N+1), with ρ = x² + y².
    pub top: R,
    /// `2 ρ^⌊N/2+1⌋ · odd`, absent when there is no odd harmonic at all (N = 0).
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

/// The implicit polynomial F of a Fourier radius, held as the pair of forms that it is made of: about
/// 2N short coefficients instead of 6N long ones, expanded only when asked.
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
    harmonics: usize,
    unit: Integer,
    odd: Option<BinaryForm>,
    even: BinaryForm,
    center: [Rational; 2],
}

impl SquaredForm {
    /// The pair of forms of a radius: two changes of basis, quasi-linear in their size.
    ///
    /// # Errors
    /// [`Error::Hypothesis`] if r is identically 0: that is a point, not a curve.
    pub fn new(radius: &FourierRadius) -> Result<Self> {
        if radius.is_zero() {
            return Err(Error::Hypothesis {
                statement: "Theorem 2",
                witness: "r = 0 for every angle is a single point, not a curve".into(),
            });
        }
        let n = radius.harmonics();
        let (denominator, cos, sin) = radius.over_common_denominator();
        let sum = |parity: usize| {
            let degree = if n % 2 == parity { n } else { n - 1 };
            let harmonics = (parity..=degree).step_by(2).map(|m| (m, &cos[m], &sin[m]));
            doubled_form_from_harmonics(degree, harmonics)
        };
        Ok(Self {
            harmonics: n,
            unit: denominator << 1u64,
            odd: (n > 0).then(|| sum(1)),
            even: sum(0),
            center: radius.center().clone(),
        })
    }

    /// N.
    #[must_use]
    pub fn harmonics(&self) -> usize {
        self.harmonics
    }

    /// Whether F is the square of a polynomial: exactly when a0 and all even harmonics are 0.
    ///
    /// Otherwise F is irreducible over Q. For a factor of F is, in polar form and up to powers of
    /// r, a product of some of `r − r(θ)` and `r + r(θ+π)`, and a polynomial in x and y does not
    /// change under (r, θ) → (−r, θ+π), which exchanges the two; they are different exactly when
    /// the even part is not 0; and a form that divides the top part ρ^(N+1) is a power of ρ,
    /// which does not divide the low part as the N-th harmonic is not 0.
    #[must_use]
    pub fn is_perfect_square(&self) -> bool {
        self.even.is_zero()
    }

    /// The two sides of Eq. (7) or (8) before they are squared, without the factor r that one of them has: `r^N − odd`
    /// (N even) or `r^(N+1) − odd` (N odd), and `even`; both times one integer.
    #[must_use]
    pub fn sides(&self) -> [PlanePolynomial; 2] {
        let top = BinaryForm::rho_power(self.harmonics.div_ceil(2)).scaled(&self.unit);
        let minus_odd = self.odd.as_ref().map(|odd| odd.scaled(&Integer::from(-1)));
        let left = std::iter::once(top).chain(minus_odd);
        let plane = |parts: Vec<BinaryForm>| PlanePolynomial::from_parts(parts, Integer::ONE);
        [plane(left.collect()), plane(vec![self.even.clone()])]
    }

    /// F itself, a primitive polynomial with positive first term, also where it is a square.
    #[must_use]
    pub fn expand_unreduced(&self) -> ImplicitCurve {
        let unit = BinaryForm::from_coefficients(vec![self.unit.clone()]);
        let parts = square_away(
            self.harmonics,
            &unit,
            BinaryForm::rho_power,
            self.odd.as_ref(),
            &self.even,
        );
        let minus_middle = parts.middle.map(|m| m.scaled(&Integer::from(-1)));
        self.curve([Some(parts.top), minus_middle, Some(parts.low)])
    }

    /// The reduced implicit equation: F, or the G with F = G² if F is a perfect square.
    ///
    /// Cost: two squares and one product of forms of degree N, quasi-linear in the size of the
    /// answer (about 4N coefficients of 2N + 2·(bits of a coefficient) bits each).
    #[must_use]
    pub fn expand(&self) -> ImplicitCurve {
        match &self.odd {
            Some(odd) if self.is_perfect_square() => {
                // N is odd here: G = r^(N+1) − odd.
                let top = BinaryForm::rho_power(self.harmonics.div_ceil(2)).scaled(&self.unit);
                self.curve([Some(top), Some(odd.scaled(&Integer::from(-1)))])
            }
            _ => self.expand_unreduced(),
        }
    }

    fn curve<const K: usize>(&self, parts: [Option<BinaryForm>; K]) -> ImplicitCurve {
        let f = PlanePolynomial::from_parts(parts.into_iter().flatten(), Integer::ONE);
        ImplicitCurve::new(f.primitive()).with_center(self.center.clone())
    }
}
