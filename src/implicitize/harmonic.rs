//! Theorem 2 in space: the implicit polynomial of a radius that is a finite sum of spherical harmonics.

use malachite::Integer;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::poly::{Ring, SpacePolynomial, TernaryForm};
use crate::shape::{HarmonicPair, HarmonicSurface, ImplicitSurface, rho_power_in_space};

/// The implicit polynomial F of a harmonic surface of degree L, stored as its [`HarmonicPair`]. F is expanded only on request.
///
/// These are Eqs. (7) and (8) with solid harmonics in the place of the K_n. With ρ = x² + y² + z² and R = odd + even on the unit
/// sphere,
///
/// - L even: `F = ρ (ρ^(L/2) − odd)² − even²`,
/// - L odd: `F = (ρ^((L+1)/2) − odd)² − ρ even²`,
///
/// of degree 2(L + 1) with three homogeneous parts, `F = ρ^(L+1) − 2ρ^⌊L/2+1⌋ odd + low`; in polar form
/// `r^(2L) (r − R(d)) (r + R(−d))`.
///
/// Proof. On the ray of a unit vector d the form `odd` is r^k odd(d), with k = L − 1 or L, and `even` likewise. For even L, F(rd) =
/// r² (r^L − r^(L−1) odd(d))² − r^(2L) even(d)² = r^(2L) ((r − odd(d))² − even(d)²), and the two factors of the difference are
/// r − R(d) and r + R(−d), because R(−d) = even(d) − odd(d). For odd L the calculation is the same.
///
/// ```
/// use stellate::implicitize::SquaredHarmonics;
/// use stellate::shape::HarmonicSurface;
///
/// let sphere = HarmonicSurface::new([((0, 0), 2.into())])?;
/// let surface = SquaredHarmonics::new(&sphere)?.expand();
/// assert_eq!(surface.by_degree().homogeneous_degrees(), [2, 0]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SquaredHarmonics {
    pair: HarmonicPair,
    center: [Rational; 3],
}

impl SquaredHarmonics {
    /// The pair of forms of a harmonic surface.
    ///
    /// # Errors
    /// [`Error::Hypothesis`] if R is identically 0: then the surface is a point.
    pub fn new(surface: &HarmonicSurface) -> Result<Self> {
        if surface.is_zero() {
            return Err(Error::Hypothesis {
                statement: "Theorem 2 in space",
                witness: "R = 0 in every direction is a single point, not a surface".into(),
            });
        }
        Ok(Self {
            pair: HarmonicPair::new(surface),
            center: surface.center().clone(),
        })
    }

    /// The pair of forms.
    #[must_use]
    pub fn pair(&self) -> &HarmonicPair {
        &self.pair
    }

    /// Whether F is the square of a polynomial: exactly when all harmonics of even degree are 0.
    ///
    /// Otherwise F is irreducible over Q. The proof is that of [`SquaredForm::is_perfect_square`](super::SquaredForm::is_perfect_square): in polar form a factor of
    /// F is up to a power of r a product of some of r − R(d) and r + R(−d), which (r, d) → (−r, −d) exchanges; if they are
    /// different, a factor contains both or neither, and one that contains neither divides the top part ρ^(L+1), so it is a power of
    /// ρ, which does not divide the low part: modulo ρ the low part is −even² or odd², the square of the harmonics of degree L,
    /// which are not divisible by ρ because harmonic forms are not.
    #[must_use]
    pub fn is_perfect_square(&self) -> bool {
        self.pair.is_odd()
    }

    /// The reduced implicit equation with coprime integer coefficients: F, or the G with F = G² if F is a perfect square, relative
    /// to the center of the harmonic surface.
    ///
    /// Cost: two squares of forms of degree L, each one product of univariate polynomials with about 2L² coefficients, and O(L³)
    /// additions.
    #[must_use]
    pub fn expand(&self) -> ImplicitSurface {
        let degree = self.pair.degree();
        if degree > 0 && self.is_perfect_square() {
            // L is odd here: G = ρ^((L+1)/2) − odd.
            let top = rho_power_in_space(degree.div_ceil(2), self.pair.unit());
            let odd = self.pair.odd().map(|odd| odd.scaled(&Integer::from(-1)));
            return self.surface(std::iter::once(top).chain(odd));
        }
        self.expand_unreduced()
    }

    /// F itself, with coprime integer coefficients, even if it is a perfect square.
    #[must_use]
    pub fn expand_unreduced(&self) -> ImplicitSurface {
        let (degree, unit) = (self.pair.degree(), self.pair.unit());
        let top = rho_power_in_space(degree + 1, &(unit * unit));
        let is_even = usize::from(degree.is_multiple_of(2));
        let middle = self.pair.odd().map(|odd| {
            let scaled = odd.scaled(&(unit * Integer::from(-2)));
            scaled.times_rho_power(degree / 2 + 1)
        });
        let even = self.pair.even().squared_densely();
        let even = even.times_rho_power(1 - is_even);
        let low = match self.pair.odd() {
            Some(odd) => odd.squared_densely().times_rho_power(is_even).minus(&even),
            None => even.scaled(&Integer::from(-1)),
        };
        self.surface([top].into_iter().chain(middle).chain([low]))
    }

    /// The surface on which the sum of the parts is 0, with coprime coefficients.
    fn surface(&self, parts: impl Iterator<Item = TernaryForm>) -> ImplicitSurface {
        let polynomial = SpacePolynomial::primitive(parts);
        ImplicitSurface::of_parts(polynomial).with_center(self.center.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::implicitize::square_away;
    use crate::poly::{HomogeneousPolynomial, SparsePolynomial};
    use proptest::prelude::*;

    /// The slow twin: the formulas of [`square_away`] on ternary forms.
    fn by_formulas(f: &SquaredHarmonics) -> SparsePolynomial<3> {
        let unit = TernaryForm::constant(f.pair.unit().clone());
        let (odd, even) = (f.pair.odd(), f.pair.even());
        let rho_power = |power| rho_power_in_space(power, &Integer::from(1));
        let parts = square_away(f.pair.degree(), &unit, rho_power, odd, even);
        let mut sum = SparsePolynomial::from(&parts.top);
        sum.add_multiple(&SparsePolynomial::from(&parts.low), &Rational::one());
        if let Some(middle) = &parts.middle {
            sum.add_multiple(&SparsePolynomial::from(middle), &Rational::from(-1));
        }
        sum.primitive()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn expansion_says_what_the_formulas_say(
            list in prop::collection::vec((0usize..7, 0usize..13, -9i64..10, 1i64..7), 1..12),
            only_odd: bool,
        ) {
            let terms = list.into_iter().map(|(l, m, p, q)| {
                let l = if only_odd { l | 1 } else { l };
                let m = (m % (2 * l + 1)) as isize - l as isize;
                ((l, m), Rational::new(p, q).unwrap())
            });
            let surface = HarmonicSurface::new(terms).unwrap();
            prop_assume!(!surface.is_zero());
            let form = SquaredHarmonics::new(&surface).unwrap();
            let whole = form.expand_unreduced();
            prop_assert_eq!(whole.polynomial(), &by_formulas(&form));
            prop_assert_eq!(whole.polynomial().degree(), Some(2 * surface.degree() as u64 + 2));
            prop_assert_eq!(form.is_perfect_square(), surface.terms().all(|(l, ..)| l % 2 == 1));
            if form.is_perfect_square() {
                let root = form.expand();
                let square = root.polynomial().times(root.polynomial());
                prop_assert_eq!(&square, whole.polynomial());
            }
        }

        /// F is 0 at the point with the radius R(d), and at the one with −R(−d).
        #[test]
        fn the_polynomial_vanishes_on_the_surface(
            list in prop::collection::vec((0usize..6, 0usize..11, -9i64..10), 1..8),
            p in -9i64..10, q in -9i64..10,
        ) {
            let terms = list.into_iter().map(|(l, m, c)| {
                ((l, (m % (2 * l + 1)) as isize - l as isize), Rational::from(c))
            });
            let surface = HarmonicSurface::new(terms).unwrap();
            prop_assume!(!surface.is_zero());
            let form = SquaredHarmonics::new(&surface).unwrap();
            let n = p * p + q * q + 4;
            let unit = [4 * p, 4 * q, p * p + q * q - 4].map(|x| Rational::new(x, n).unwrap());
            let [odd, even] = form.pair().values(&unit);
            let f = form.expand();
            for r in [&odd + &even, &odd - &even] {
                let at = unit.each_ref().map(|u| &r * u);
                prop_assert!(f.polynomial().evaluate(&at).is_zero());
            }
        }
    }
}
