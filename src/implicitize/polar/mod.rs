//! The paper's own way (Theorems 1, 3 and 4): where `x² + y²` (or `x² + y² + z²`) is a rational function of the
//! direction, that function is substituted, and the spurious factors are found and named.

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
    /// It is the quotient above/below of two forms of the same degree in x, y (and z).
    Function([SparsePolynomial<3>; 2]),
    /// It is no rational function, for this reason; a polynomial relation between the two was taken.
    Relation(String),
}

/// An irreducible factor of an equation that was found by substitution.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct PolarFactor {
    /// Primitive, with positive first term.
    pub polynomial: SparsePolynomial<3>,
    /// How often it occurs.
    pub multiplicity: usize,
    /// What it is.
    pub role: Role,
}

/// What an irreducible factor of such an equation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Role {
    /// It vanishes identically on the form (proved by substitution).
    Form,
    /// It vanishes identically on the reflection −α.
    Reflection,
    /// x² + y² or x² + y² + z².
    SquaredRadius,
    /// It divides a denominator that was multiplied by.
    Denominator,
    /// Nothing of these.
    Other,
}

impl Role {
    /// In words.
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

    /// As in documents.
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

    /// What the irreducible polynomial g is, where `denominators` were multiplied by.
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
