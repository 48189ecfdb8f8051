//! The facts that accompany an answer, as data. [`crate::document`] writes each of them as a sentence or as fields.

use super::{FitReport, Part};
use crate::exact::Rational;
use crate::implicitize::{
    EquationProof, IsolatedPoint, PointBeyond, PolarFactor, PolarInverse, PolarSurface,
};
use crate::poly::SparsePolynomial;
use crate::shape::Form;

/// A fact about a form or its equation. The document of the form states it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Fact {
    /// The form was given by these functions of parameters.
    Parametric(Form),
    /// The form was a contour; the document holds the Fourier fit of that contour.
    Outline {
        /// The number of vertices of the contour.
        vertices: usize,
        /// The area inside the contour.
        area: f64,
        /// The centroid of that area.
        centroid: [f64; 2],
    },
    /// The deviations of the fit from what it was fitted to.
    Fit(FitReport),
    /// The polynomial of Theorem 2 is a perfect square; the equation in the document is its square root.
    PerfectSquare,
    /// The equation is that of a harmonic surface of this degree L, by Theorem 2 in space.
    Harmonics(usize),
    /// The coefficients of the radius were rounded: in every direction it is off by at most this.
    RoundedRadius(Rational),
    /// The equation is irreducible, and it vanishes on the whole form.
    Irreducible {
        /// The degree of the equation.
        degree: u64,
        /// Why it vanishes on the form.
        proof: EquationProof,
    },
    /// The number of complex parameter values of a general point of a curve.
    TracingIndex(usize),
    /// The number of complex parameter values of a general point of a surface, counted at random points; `None` if the counts
    /// disagree.
    PatchTracingIndex(Option<usize>),
    /// The surfaces intersect in the space curve and in nothing else; the number is the degree of that curve.
    CutsOutCurve(usize),
    /// How often real values of the parameter trace the points that they reach.
    RealTracing {
        /// The numbers of real parameter values that occur at general points, one number if it is the same everywhere; `None` if
        /// they were not found.
        counts: Option<Vec<usize>>,
        /// The number of complex parameter values of a general point.
        complex: usize,
    },
    /// The points of the zero set of a curve that no real parameter value reaches.
    BeyondCurve(BeyondCurve),
    /// The topology is that of the equation of a curve, which has more points than the curve.
    TopologyOfEquation,
    /// A point of the zero set that is not on the patch, or `None` if none was found.
    BeyondPatch(Option<PointBeyond>),
    /// The result of Theorem 1 or of Theorem 4.
    Polar {
        /// The theorem.
        theorem: PolarTheorem,
        /// The squared radius as a function of the direction, or the reason why it is not a rational function.
        inverse: PolarInverse,
        /// The irreducible factors of the polar equation, cleared of denominators.
        factors: Vec<PolarFactor>,
    },
    /// The result of Theorem 3.
    PolarSpaceCurve {
        /// The surfaces of Eq. (10) and Eq. (11), each with the reason if it does not exist.
        surfaces: Box<[std::result::Result<PolarSurface, String>; 2]>,
        /// The components that the two surfaces have in common besides the curve: each is the common zero set of its two
        /// polynomials.
        components: Vec<[SparsePolynomial<3>; 2]>,
    },
    /// This part of the answer is missing, because a limit was reached.
    Missing(Part),
}

/// The theorems that give one polar equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PolarTheorem {
    /// Theorem 1, Eq. (1), for plane curves.
    One,
    /// Theorem 4, Eq. (15), for patches.
    Four,
}

/// The real points of the zero set of a curve's equation that no real parameter value reaches.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct BeyondCurve {
    /// The name of the parameter.
    pub parameter: String,
    /// The point that the curve tends to as the parameter goes to infinity, and that no parameter value reaches.
    pub approached: Option<Vec<Rational>>,
    /// The part of the curve that real parameter values reach.
    pub reach: Reach,
    /// The isolated real points that were found.
    pub isolated: Vec<IsolatedPoint>,
    /// Whether `isolated` holds all isolated real points.
    pub are_all: bool,
}

impl BeyondCurve {
    /// Whether the equation is known to have a part or an isolated point beyond the curve.
    pub(crate) fn has_more(&self) -> bool {
        matches!(self.reach, Reach::TurnsBack(_)) || !self.isolated.is_empty()
    }
}

/// The part of the real curve that real parameter values reach.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reach {
    /// All of the curve except finitely many points.
    Whole,
    /// The parametrization turns back at these points (approximate coordinates), and the curve goes on beyond them; `None` is the
    /// point at infinity.
    TurnsBack(Vec<Option<Vec<f64>>>),
    /// It was not decided.
    Unknown,
}
