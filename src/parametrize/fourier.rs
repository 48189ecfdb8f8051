//! Polynomials that come from a Fourier radius are recognised, and the radius is recovered exactly (Lemmas 2 and 3).

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{
    Abs, CheckedSqrt, ContentAndCanonicalPrimitivePart,
};
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::implicitize::SquaredForm;
use crate::poly::{BinaryForm, IntegerPolynomial, Ring, harmonics_of_form, polynomial_sqrt};
use crate::shape::{FourierRadius, ImplicitCurve};

/// The branches of an implicit curve whose radii are trigonometric polynomials, exactly.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FourierBranches {
    /// The number of the lemma that gives the closed form: 2 for two homogeneous parts, 3 for three.
    pub lemma: usize,
    /// The step k: r^k is the root. It is 2 if only every second degree occurs.
    pub step: usize,
    /// One radius, or the two radii r(θ) and −r(θ+π); the one whose first even coefficient is positive comes first. Both describe
    /// the same points, but they are positive at different angles.
    pub radii: Vec<FourierRadius>,
}

/// Recovers the exact Fourier radii that an implicit polynomial comes from.
///
/// With homogeneous parts s, p, q of degrees n, n−1, n−2 the radius satisfies
/// `s r² + p r + q = 0` (Lemma 3, Eq. (21)ff). If s is a constant times a power of x² + y² (1 on
/// the circle) and the discriminant p² − 4sq is a perfect square up to such a power, then
/// r = (−p ± √(p² − 4sq)) / 2s is a trigonometric polynomial with rational coefficients. For F of
/// Theorem 2 the discriminant is 4·even², so Fourier → implicit → Fourier is the identity.
/// With p = 0 or q = 0 this is Lemma 2.
///
/// Cost: a product of forms of degree n, a polynomial square root (n² products), two changes of
/// basis.
///
/// # Errors
/// [`Error::Hypothesis`], with the reason, if the radii are not trigonometric polynomials.
pub fn fourier_branches(curve: &ImplicitCurve) -> Result<FourierBranches> {
    let f = curve.polynomial();
    let degrees = f.homogeneous_degrees();
    let no = |witness: String| Error::Hypothesis {
        statement: "the way back to a Fourier radius (Lemmas 2 and 3)",
        witness,
    };
    let (Some(&n), Some(&low)) = (degrees.first(), degrees.last()) else {
        return Err(no("the polynomial is 0".into()));
    };
    if degrees.len() < 2 || n - low > 2 {
        return Err(no(format!(
            "the homogeneous parts have degrees {degrees:?}; a Fourier radius gives two or three parts within two degrees of the highest"
        )));
    }
    let part = |d: usize| f.part(d).cloned().unwrap_or_else(|| BinaryForm::zero(d));
    let (s, p) = (part(n), part(n - 1));
    let lead = match s.strip_rho() {
        Some((_, rest)) if rest.degree() == 0 => rest.coefficient(0),
        _ => {
            return Err(no(format!(
                "the part of degree {n} is not a constant times a power of x^2 + y^2"
            )));
        }
    };
    let (denominator, root) = if n - low == 1 {
        (Rational::whole(lead), None)
    } else {
        let q = part(low);
        let four = Integer::from(4);
        let discriminant = p.squared().minus(&s.times(&q).scaled(&four));
        let root = form_sqrt(&discriminant).ok_or_else(|| {
            no("the discriminant p^2 - 4sq of the quadratic in r is not a perfect square".into())
        })?;
        (Rational::whole(lead) * Rational::from(2), Some(root))
    };
    let base = Harmonics::of(&p, &-denominator.clone());
    let mut radii = Vec::new();
    match root {
        None => radii.push(base.radius()),
        Some(root) => {
            let root = Harmonics::of(&root, &denominator);
            radii.push(base.plus(&root, 1).radius());
            if root.first_sign() != 0 {
                radii.push(base.plus(&root, -1).radius());
            }
            if root.first_sign() < 0 {
                radii.reverse();
            }
        }
    }
    let radii = radii
        .into_iter()
        .map(|r| r.with_center(curve.center().clone()))
        .collect();
    Ok(FourierBranches {
        lemma: degrees.len(),
        step: if degrees.len() == 2 { n - low } else { 1 },
        radii,
    })
}

/// The branches of a curve that is exactly the (reduced) implicit curve of a Fourier radius and has no further factors, so that
/// it is irreducible over Q (see [`SquaredForm::is_perfect_square`]). `None` for all other curves.
#[must_use]
pub(crate) fn born_of_radius(curve: &ImplicitCurve) -> Option<FourierBranches> {
    let found = fourier_branches(curve).ok()?;
    let expanded = SquaredForm::new(found.radii.first()?).ok()?.expand();
    (expanded.polynomial() == &curve.polynomial().primitive()).then_some(found)
}

/// A square root on the unit circle: h with `f = h² (x² + y²)^e`.
fn form_sqrt(f: &BinaryForm) -> Option<BinaryForm> {
    let Some((_, stripped)) = f.strip_rho() else {
        return Some(BinaryForm::zero(0));
    };
    let (content, primitive) = stripped
        .dehomogenized()
        .content_and_canonical_primitive_part();
    let sign = if stripped.dehomogenized().coefficients_asc().last()? > &Integer::ZERO {
        1
    } else {
        -1
    };
    let content = Integer::from(content) * Integer::from(sign);
    if !stripped.degree().is_multiple_of(2) || content < 0 {
        return None;
    }
    let constant = (&content).abs().checked_sqrt()?;
    let root =
        polynomial_sqrt(&primitive)? * IntegerPolynomial::from_coefficients_asc(vec![constant]);
    Some(BinaryForm::from_dehomogenized(stripped.degree() / 2, root))
}

/// The coefficients of a trigonometric polynomial.
struct Harmonics {
    cos: Vec<Rational>,
    sin: Vec<Rational>,
}

impl Harmonics {
    /// The coefficients of form / denominator on the unit circle.
    fn of(form: &BinaryForm, denominator: &Rational) -> Self {
        // A power of x² + y² is 1 on the circle; without it there are fewer harmonics to transform.
        let Some((_, form)) = form.strip_rho() else {
            return Self {
                cos: vec![Rational::zero()],
                sin: vec![Rational::zero()],
            };
        };
        let mut cos = vec![Rational::zero(); form.degree() + 1];
        let mut sin = cos.clone();
        for (n, a, b) in harmonics_of_form(&form) {
            cos[n] = a / denominator;
            sin[n] = b / denominator;
        }
        Self { cos, sin }
    }

    fn plus(&self, other: &Self, sign: i32) -> Self {
        let sign = Rational::from(sign);
        let len = self.cos.len().max(other.cos.len());
        let sum = |a: &[Rational], b: &[Rational]| {
            (0..len)
                .map(|n| {
                    let get = |v: &[Rational]| v.get(n).cloned().unwrap_or_default();
                    get(a) + &sign * &get(b)
                })
                .collect()
        };
        Self {
            cos: sum(&self.cos, &other.cos),
            sin: sum(&self.sin, &other.sin),
        }
    }

    /// The sign of the first coefficient that is not 0.
    fn first_sign(&self) -> i8 {
        let both = self.cos.iter().zip(&self.sin).flat_map(|(a, b)| [a, b]);
        both.map(Rational::signum).find(|&s| s != 0).unwrap_or(0)
    }

    fn radius(&self) -> FourierRadius {
        FourierRadius::new(self.cos.clone(), self.sin.clone())
    }
}
