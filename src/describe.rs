//! Descriptions of curves and surfaces: the degree, the homogeneous parts, the lemma that applies, and other exact properties.

use malachite::base::num::arithmetic::traits::Gcd;

use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::factor::{factor_plane, factor_space};
use crate::implicitize::{SquaredForm, SquaredHarmonics};
use crate::limits::Limits;
use crate::parametrize::{AngleRange, born_of_radius, is_full_circle, positive_ranges};
use crate::poly::total_degree;
use crate::shape::{Form, FourierRadius, HarmonicSurface, ImplicitCurve, ImplicitSurface};
use crate::sphere::{Positivity, positivity};

/// The exact properties of an implicit curve or surface, or of the polynomial of a Fourier radius.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Description {
    /// The total degree of the (reduced, primitive) polynomial.
    pub degree: usize,
    /// The point that coordinates are relative to.
    pub center: Vec<Rational>,
    /// The degrees of its homogeneous parts, descending.
    pub homogeneous_degrees: Vec<usize>,
    /// The number of non-zero terms.
    pub terms: usize,
    /// The bit length of the largest coefficient.
    pub coefficient_bits: u64,
    /// The lemma of §3 of the paper that gives the radius.
    pub method: Method,
    /// The multiplicity of the origin: the lowest degree of a term.
    pub origin_multiplicity: usize,
    /// The properties of the Fourier radius, if the curve comes from one.
    pub fourier: Option<FourierDescription>,
    /// The irreducible factors over Q; `None` if they were not found within the limits.
    pub factors: Option<Vec<DescribedFactor>>,
}

/// An irreducible factor over Q.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct DescribedFactor {
    /// The factor, primitive and with a positive first coefficient.
    pub shape: Form,
    /// The multiplicity of the factor.
    pub multiplicity: usize,
    /// The reason why it is irreducible, in words.
    pub proof: String,
}

/// The properties of a curve that comes from a Fourier radius.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct FourierDescription {
    /// The radius.
    pub radius: FourierRadius,
    /// The exact ranges of angles in which r > 0.
    pub positive: Vec<AngleRange>,
    /// Whether F is the square of the described polynomial (r has no even harmonics, and a0 = 0).
    pub perfect_square: bool,
}

impl FourierDescription {
    /// Whether r > 0 for every angle.
    #[must_use]
    pub fn star_shaped(&self) -> bool {
        is_full_circle(&self.positive)
    }

    /// Whether r < 0 for some angle: then the ranges in which r > 0 leave a gap, while a zero without a change of sign ends one
    /// range and begins the next. Without any range r < 0 somewhere, because r = 0 is no curve.
    #[must_use]
    pub fn has_negative_radius(&self) -> bool {
        let whole = AngleRange::full_circle();
        let [Some(first), Some(last)] = [self.positive.first(), self.positive.last()] else {
            return true;
        };
        let mut neighbours = self.positive.windows(2);
        first.from.compare(&whole.from).is_ne()
            || last.to.compare(&whole.to).is_ne()
            || neighbours.any(|pair| pair[0].to.compare(&pair[1].from).is_ne())
    }

    fn of(radius: &FourierRadius, perfect_square: bool) -> Self {
        Self {
            radius: radius.clone(),
            positive: positive_ranges(radius),
            perfect_square,
        }
    }
}

/// Which part of §3 applies to a polynomial (Theorem 5): up to five homogeneous parts of equally
/// spaced degrees n, n−k, n−2k, … make it a polynomial of degree at most four in r^k.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// A single part: straight lines through the origin.
    Lines,
    /// Lemma 2, 3, 4 or 5 in the plane, or Lemma 7, 8, 9 or 10 in space, applied to r^step.
    Lemma {
        /// The number of the lemma.
        number: usize,
        /// The number k: the degrees of the parts differ by multiples of it.
        step: usize,
    },
    /// Lemma 6: certified roots direction by direction.
    Numeric,
}

impl Method {
    /// The method for homogeneous parts of these degrees, descending. `first` is the number of the lemma for two parts: 2 in
    /// the plane, 7 in space.
    fn from_degrees(degrees: &[usize], first: usize) -> Self {
        let gaps: Vec<usize> = degrees.windows(2).map(|w| w[0] - w[1]).collect();
        // Parts may be missing; what counts is the degree of the polynomial in r^k.
        let step = gaps.iter().fold(0, |g: usize, &gap| g.gcd(gap));
        match gaps.iter().sum::<usize>().checked_div(step) {
            None => Self::Lines,
            Some(degree) if degree <= 4 => Self::Lemma {
                number: first + degree - 1,
                step,
            },
            Some(_) => Self::Numeric,
        }
    }

    /// The name of the method in documents, such as `lemma-3`.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Lines => "lines".into(),
            Self::Lemma { number, .. } => format!("lemma-{number}"),
            Self::Numeric => "lemma-6".into(),
        }
    }
}

impl Description {
    /// Describes an implicit curve. If the curve comes from a Fourier radius, the radius is described, too.
    ///
    /// # Errors
    /// Those of [`factor_plane`].
    pub fn of_curve(curve: &ImplicitCurve, limits: &Limits) -> Result<Self> {
        if let Some(radius) = born_of_radius(curve).and_then(|found| found.radii.into_iter().next())
        {
            return Self::of_radius(&radius, limits);
        }
        let mut description = Self::unfactored_curve(curve);
        let factors = factor_plane(curve.polynomial(), limits)?.factors;
        let described = factors.into_iter().map(|factor| DescribedFactor {
            shape: Form::Curve(
                ImplicitCurve::new(factor.polynomial).with_center(curve.center().clone()),
            ),
            multiplicity: factor.multiplicity,
            proof: factor.proof.to_string(),
        });
        description.factors = Some(described.collect());
        Ok(description)
    }

    /// The description of an implicit curve without its factors and without the Fourier radius that it may come from.
    #[must_use]
    pub fn unfactored_curve(curve: &ImplicitCurve) -> Self {
        let f = curve.polynomial();
        let degrees = f.homogeneous_degrees();
        Self {
            degree: f.degree().unwrap_or(0),
            center: curve.center().to_vec(),
            method: Method::from_degrees(&degrees, 2),
            homogeneous_degrees: degrees,
            terms: f.term_count(),
            coefficient_bits: f.coefficient_bits(),
            origin_multiplicity: f.lowest_degree().unwrap_or(0),
            fourier: None,
            factors: None,
        }
    }

    /// Describes the reduced implicit equation of a Fourier radius.
    ///
    /// # Errors
    /// As [`SquaredForm::new`]; [`crate::error::Error::Limit`] or `Interrupted` when the limits say so.
    pub fn of_radius(radius: &FourierRadius, limits: &Limits) -> Result<Self> {
        let form = SquaredForm::new(radius)?;
        let mut description = Self::of_squared(&form);
        limits.check()?;
        description.fourier = Some(FourierDescription::of(radius, form.is_perfect_square()));
        Ok(description)
    }

    /// The description of the reduced implicit equation of a Fourier radius, without the radius and the angles at which it is positive.
    ///
    /// # Errors
    /// As [`SquaredForm::new`].
    pub fn unranged_radius(radius: &FourierRadius) -> Result<Self> {
        SquaredForm::new(radius).map(|form| Self::of_squared(&form))
    }

    fn of_squared(form: &SquaredForm) -> Self {
        let curve = form.expand();
        let mut description = Self::unfactored_curve(&curve);
        description.factors = Some(vec![DescribedFactor {
            shape: Form::Curve(curve),
            multiplicity: 1,
            proof: if form.is_perfect_square() {
                "linear in r on the unit circle, with a leading part that is a power of x^2 + y^2"
                    .into()
            } else {
                "in polar form F = r^(2N) (r - r(t)) (r + r(t+pi)), the two factors are exchanged by (r, t) -> (-r, t+pi) and differ, because an even harmonic (a0 among them) is not 0; and x^2 + y^2 does not divide F, because the N-th harmonic is not 0".into()
            },
        }]);
        description
    }

    /// Describes a surface.
    ///
    /// # Errors
    /// Those of [`factor_space`].
    pub fn of_surface(surface: &ImplicitSurface, limits: &Limits) -> Result<Self> {
        let factors = factor_space(surface.polynomial(), limits)?.factors;
        let described = factors.into_iter().map(|factor| DescribedFactor {
            shape: Form::Surface(
                ImplicitSurface::new(factor.polynomial).with_center(surface.center().clone()),
            ),
            multiplicity: factor.multiplicity,
            proof: factor.proof.to_string(),
        });
        Ok(Self {
            factors: Some(described.collect()),
            ..Self::unfactored_surface(surface)
        })
    }

    /// The description of a surface without its factors.
    #[must_use]
    pub fn unfactored_surface(surface: &ImplicitSurface) -> Self {
        let f = surface.polynomial();
        // Exponents are 32 bits long.
        let degree = |e: &[u32; 3]| usize::try_from(total_degree(e));
        let degrees = f
            .terms()
            .map(|(e, _)| degree(e).invariant("a degree is an address"));
        let mut degrees: Vec<usize> = degrees.collect();
        degrees.dedup();
        Self {
            degree: degrees.first().copied().unwrap_or(0),
            center: surface.center().to_vec(),
            method: Method::from_degrees(&degrees, 7),
            origin_multiplicity: degrees.last().copied().unwrap_or(0),
            homogeneous_degrees: degrees,
            terms: f.len(),
            coefficient_bits: f
                .primitive()
                .terms()
                .map(|(_, c)| c.bits())
                .max()
                .unwrap_or(0),
            fourier: None,
            factors: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lemmas_by_the_degrees_of_the_parts() {
        let name = |d: &[usize]| {
            let method = Method::from_degrees(d, 2);
            let step = if let Method::Lemma { step, .. } = method {
                step
            } else {
                0
            };
            (method.name(), step)
        };
        assert_eq!(name(&[4, 2]), ("lemma-2".into(), 2));
        assert_eq!(name(&[80, 79, 78]), ("lemma-3".into(), 1));
        assert_eq!(name(&[32, 28, 24, 20]), ("lemma-4".into(), 4));
        assert_eq!(name(&[4, 3, 2, 1, 0]), ("lemma-5".into(), 1));
        // Parts of degrees 5, 1, 0 give a general quintic; 3, 2, 0 a cubic without linear term.
        assert_eq!(name(&[5, 1, 0]), ("lemma-6".into(), 0));
        assert_eq!(name(&[3, 2, 0]), ("lemma-4".into(), 1));
        assert_eq!(name(&[2]), ("lines".into(), 0));
    }

    #[test]
    fn a_zero_without_a_change_of_sign_is_no_gap() {
        for (cos, sin, expected) in [
            (vec![2, 1], vec![], false),
            // It touches 0 at π, at 0, and at two angles.
            (vec![1, 1], vec![], false),
            (vec![1, -1], vec![], false),
            (vec![1, 0, 1], vec![], false),
            (vec![1, 2], vec![], true),
            (vec![0, 1], vec![], true),
            (vec![0, 0], vec![0, 1], true),
            (vec![-1, 1], vec![], true),
            (vec![-2, 1], vec![], true),
            // (1 + 2 cos θ)² = 3 + 4 cos θ + 2 cos 2θ touches 0 at ±2π/3, (3 + 5 cos θ)² = 43/2 + 30 cos θ + 25/2 cos 2θ at others.
            (vec![3, 4, 2], vec![], false),
            (vec![43, 60, 25], vec![], false),
            (vec![42, 60, 25], vec![], true),
        ] {
            let exact = |v: Vec<i64>| v.into_iter().map(Into::into).collect();
            let radius = FourierRadius::new(exact(cos.clone()), exact(sin));
            let described = Description::of_radius(&radius, &Limits::none()).unwrap();
            let fourier = described.fourier.unwrap();
            assert_eq!(fourier.has_negative_radius(), expected, "{cos:?}");
        }
    }
}

/// The properties of a harmonic surface and of its equation.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct HarmonicDescription {
    /// The radius.
    pub surface: HarmonicSurface,
    /// The total degree of the reduced equation: 2(L + 1), or L + 1 if F is a perfect square.
    pub degree: usize,
    /// The degrees of its homogeneous parts, descending.
    pub homogeneous_degrees: Vec<usize>,
    /// The number of non-zero terms.
    pub terms: usize,
    /// The bit length of the largest coefficient.
    pub coefficient_bits: u64,
    /// Whether F is the square of the described equation, because all even harmonics are 0.
    pub perfect_square: bool,
    /// Whether R > 0 in every direction.
    pub positivity: Positivity,
}

impl HarmonicDescription {
    /// The description of a harmonic surface with this equation.
    ///
    /// # Errors
    /// Those of the limits.
    pub fn new(
        surface: HarmonicSurface,
        equation: &SquaredHarmonics,
        limits: &Limits,
    ) -> Result<Self> {
        let expanded = equation.expand();
        let f = expanded.polynomial();
        let degrees = expanded.by_degree().homogeneous_degrees();
        let bits = f.terms().map(|(_, c)| c.bits()).max();
        Ok(Self {
            degree: degrees.first().copied().invariant("an equation is not 0"),
            homogeneous_degrees: degrees,
            terms: f.len(),
            coefficient_bits: bits.invariant("an equation is not 0"),
            perfect_square: surface.degree() > 0 && equation.is_perfect_square(),
            positivity: positivity(&surface, equation.pair(), limits)?,
            surface,
        })
    }
}
