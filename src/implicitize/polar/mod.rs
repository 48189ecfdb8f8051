//! Implicitization by the paper's substitution (Theorems 1, 3 and 4).
//!
//! The squared radius `x² + y²` (or `x² + y² + z²`) is expressed as a rational function of the direction. This equation, cleared
//! of denominators, vanishes on the form but also has spurious factors; they are found, and each is named by its [`Role`].

mod patch;
mod plane;
mod space_curve;

use super::map::RationalMap;
use crate::limits::Limits;
use crate::poly::SparsePolynomial;

pub use patch::{PolarPatch, polar_patch};
pub use plane::{PolarPlane, polar_plane};
pub use space_curve::{PolarSpaceCurve, PolarSurface, polar_space_curve};

/// How the squared distance from the origin depends on the direction.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PolarInverse {
    /// It is the quotient of these two forms, numerator first, of the same degree in x, y (and z).
    Function([SparsePolynomial<3>; 2]),
    /// It is not a rational function of the direction, for this reason. The polar equation is a polynomial relation between the
    /// squared distance and the direction.
    Relation(String),
}

/// An irreducible factor of a polar equation.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct PolarFactor {
    /// The factor, primitive and with a positive first coefficient.
    pub polynomial: SparsePolynomial<3>,
    /// The multiplicity of the factor in the equation.
    pub multiplicity: usize,
    /// The origin of the factor.
    pub role: Role,
}

/// The origin of an irreducible factor of a polar equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Role {
    /// The factor vanishes on the whole form α (exact substitution proves it).
    Form,
    /// The factor vanishes on the whole reflection −α.
    Reflection,
    /// The factor is x² + y² or x² + y² + z².
    SquaredRadius,
    /// The factor divides a denominator by which the equation was multiplied.
    Denominator,
    /// The factor is spurious for none of these reasons.
    Other,
}

impl Role {
    /// The role in words.
    #[must_use]
    pub fn describe(self) -> &'static str {
        match self {
            Role::Form => "the form: it vanishes there identically, by exact substitution",
            Role::Reflection => "spurious: the reflection -alpha",
            Role::SquaredRadius => "spurious: the squared radius",
            Role::Denominator => "spurious: a denominator that was multiplied by",
            Role::Other => "spurious",
        }
    }

    /// The name of the role in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Role::Form => "form",
            Role::Reflection => "reflection",
            Role::SquaredRadius => "squared-radius",
            Role::Denominator => "denominator",
            Role::Other => "other",
        }
    }

    /// The role of the irreducible factor g of an equation that was multiplied by `denominators`.
    fn of(
        g: &SparsePolynomial<3>,
        map: &RationalMap,
        squared_radius: &SparsePolynomial<3>,
        denominators: &[SparsePolynomial<3>],
    ) -> Self {
        let reflected = SparsePolynomial::from_terms(g.terms().map(|(e, c)| {
            let odd = e.iter().sum::<u32>() % 2 == 1;
            (*e, if odd { -c.clone() } else { c.clone() })
        }));
        let vanishes = |f| {
            map.annihilates(f, &Limits::none())
                .is_ok_and(|it_does| it_does)
        };
        if vanishes(g) {
            Role::Form
        } else if vanishes(&reflected) {
            Role::Reflection
        } else if g == squared_radius {
            Role::SquaredRadius
        } else if denominators.iter().any(|d| divides(g, d)) {
            Role::Denominator
        } else {
            Role::Other
        }
    }
}

/// Whether the irreducible g divides d.
fn divides(g: &SparsePolynomial<3>, d: &SparsePolynomial<3>) -> bool {
    use crate::factor::greatest_common_divisor;
    greatest_common_divisor(g, d, &Limits::none()).is_ok_and(|common| common == *g)
}

/// x² + y², or x² + y² + z²
fn squared_radius(in_space: bool) -> SparsePolynomial<3> {
    let squares = [[2, 0, 0], [0, 2, 0], [0, 0, 2]];
    let count = if in_space { 3 } else { 2 };
    let terms = squares.into_iter().take(count);
    SparsePolynomial::from_terms(terms.map(|e| (e, crate::exact::Rational::one())))
}
