//! The real singular points of a curve: multiplicity and kind.

use super::places::LocalType;

/// What a real singular point looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SingularKind {
    /// Two smooth real branches cross (A1).
    Node,
    /// One branch with a cusp of the simplest kind (A2).
    Cusp,
    /// Two smooth real branches touch, and their curvatures differ (A3).
    Tacnode,
    /// No real branch passes through the point.
    Isolated,
    /// Any other singular point.
    Higher,
}

impl SingularKind {
    /// The name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Node => "node",
            Self::Cusp => "cusp",
            Self::Tacnode => "tacnode",
            Self::Isolated => "isolated",
            Self::Higher => "higher",
        }
    }
}

/// The invariants of a singular point, over the complex numbers unless they are called real.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Singularity {
    /// The multiplicity of the point on the curve.
    pub multiplicity: usize,
    /// Milnor's number μ, if it was determined.
    pub milnor: Option<usize>,
    /// By how much the point lowers the genus: δ = (μ + branches − 1)/2.
    pub delta: Option<usize>,
    /// The number of branches.
    pub branches: Option<usize>,
    /// The number of different tangents of the branches.
    pub tangents: Option<usize>,
    /// The number of real half-branches that end in the point.
    pub real_half_branches: usize,
}

impl Singularity {
    pub(super) fn new(local: &LocalType, real_half_branches: usize) -> Self {
        Self {
            multiplicity: local.multiplicity(),
            milnor: Some(local.milnor()),
            delta: Some(local.delta()),
            branches: Some(local.places.len()),
            tangents: Some(local.tangents),
            real_half_branches,
        }
    }

    /// The kind of the point.
    #[must_use]
    pub fn kind(&self) -> SingularKind {
        match (self.real_half_branches, self.multiplicity, self.milnor) {
            (0, ..) => SingularKind::Isolated,
            (_, 2, Some(1)) => SingularKind::Node,
            (_, 2, Some(2)) => SingularKind::Cusp,
            (4, 2, Some(3)) => SingularKind::Tacnode,
            _ => SingularKind::Higher,
        }
    }

    /// Arnold's symbol of a simple singularity, such as `A3`; `None` if there is none or the other invariants do not decide it.
    #[must_use]
    pub fn arnold(&self) -> Option<String> {
        let mu = self.milnor?;
        // A triple point is D if its tangent cone is no triple line, and then E if it is simple (Arnold).
        match (self.multiplicity, mu, self.tangents) {
            (2, ..) => Some(format!("A{mu}")),
            (3, _, Some(2 | 3)) => Some(format!("D{mu}")),
            (3, 6..=8, Some(1)) => Some(format!("E{mu}")),
            _ => None,
        }
    }

    /// Whether the point is ordinary: as many branches as its multiplicity, with different tangents.
    #[must_use]
    pub fn is_ordinary(&self) -> bool {
        self.branches == Some(self.multiplicity)
            && self.milnor == Some((self.multiplicity - 1).pow(2))
    }
}
