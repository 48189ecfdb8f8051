//! What is known of an answer besides the answer itself, as data; `document` turns it into sentences and fields.

use super::Part;
use crate::exact::Rational;
use crate::fit::FitReport;
use crate::implicitize::{IsolatedPoint, PointBeyond, PolarFactor, PolarInverse, PolarSurface};
use crate::poly::SparsePolynomial;
use crate::shape::Form;

/// Something that is known of a form or its equation, and stands in its document.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Fact {
    /// The form was given by these functions of parameters.
    Parametric(Form),
    /// The form was a contour, and what follows is its Fourier fit.
    Outline {
        /// The number of vertices.
        vertices: usize,
        /// Its area.
        area: f64,
        /// Its centroid.
        centroid: [f64; 2],
    },
    /// How good the fit is.
    Fit(FitReport),
    /// The polynomial of Theorem 2 is a perfect square; this is its root.
    PerfectSquare,
    /// The equation is irreducible, of this degree; that it vanishes identically is proved by substitution.
    Irreducible(u64),
    /// How often complex values of the parameter run over a curve.
    TracingIndex(usize),
    /// How many parameter values a general point of a surface has, counted at random points; `None` if the counts disagree.
    PatchTracingIndex(Option<usize>),
    /// The equations cut out a space curve of this degree alone.
    CutsOutCurve(usize),
    /// How often real values of the parameter run over what they reach.
    RealTracing {
        /// One number, or several if that is not the same everywhere; `None` if that was not found.
        counts: Option<Vec<usize>>,
        /// The tracing index for complex values.
        complex: usize,
    },
    /// What the zero set of a curve has beyond the points of real parameters.
    BeyondCurve(BeyondCurve),
    /// A point of the zero set that is not on the patch, if one was found.
    BeyondPatch(Option<PointBeyond>),
    /// What Theorem 1 or Theorem 4 gave.
    Polar {
        /// Which of the two.
        theorem: PolarTheorem,
        /// The equation, or why there is only a relation.
        inverse: PolarInverse,
        /// The factors of the polar equation, cleared of denominators.
        factors: Vec<PolarFactor>,
    },
    /// What Theorem 3 gave: the surfaces of Eqs. (10) and (11), or why there is none, and what they have in common besides the
    /// curve.
    PolarSpaceCurve {
        /// Eq. (10) and Eq. (11).
        surfaces: Box<[std::result::Result<PolarSurface, String>; 2]>,
        /// On the first polynomial's zero set that of the second.
        components: Vec<[SparsePolynomial<3>; 2]>,
    },
    /// A limit has cost this part.
    Missing(Part),
}

/// Theorems with one polar equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PolarTheorem {
    /// Theorem 1, Eq. (1), of plane curves.
    One,
    /// Theorem 4, Eq. (15), of patches.
    Four,
}

/// What the zero set of a curve has beyond the points of real parameters.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct BeyondCurve {
    /// The name of the parameter.
    pub parameter: String,
    /// The point that is only approached, as the parameter goes to infinity.
    pub approached: Option<Vec<Rational>>,
    /// How much of the curve is reached.
    pub reach: Reach,
    /// Isolated real points.
    pub isolated: Vec<IsolatedPoint>,
    /// Whether these are all; `None` for space curves, where they are not looked for.
    pub are_all: Option<bool>,
}

/// How much of the real curve real values of the parameter reach.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reach {
    /// All of it, but for finitely many points.
    Whole,
    /// They turn back at these points, near to the exact ones; `None` is infinity.
    TurnsBack(Vec<Option<Vec<f64>>>),
    /// Not decided.
    Unknown,
}
