//! Remarks about the work, as data. [`crate::document::remark_text`] writes each of them as a sentence.

use crate::exact::Rational;
use crate::fit::{CenterOrigin, LeftOut};
use crate::reading::ReadHarmonics;
use crate::topology::ComponentKind;

/// A remark about the work for the person who waits for it. A remark is not a part of the answer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// A contour is measured from a point that was chosen for it.
    Center {
        /// Where the contour came from.
        outline: String,
        /// The center.
        point: [f64; 2],
        /// The reason for this center.
        origin: CenterOrigin,
    },
    /// A file has more than the outline that was taken.
    LeftOut {
        /// The name of the file.
        outline: String,
        /// The rest.
        left_out: LeftOut,
    },
    /// A file of spherical harmonics was read with this convention.
    HarmonicFile {
        /// The name of the file.
        file: String,
        /// What was read, and how.
        read: ReadHarmonics,
    },
    /// The form is this one, which a comment of the text names, and not the radius beside the comment.
    FormOfComment(String),
    /// The form is an equation that has the origin, and the curve that is written, by a power of its radius, has not.
    OriginAdded,
    /// A contour is not star-shaped about the center.
    Hidden {
        /// Where the contour came from.
        outline: String,
        /// The center.
        point: [f64; 2],
        /// The share of the outline's length that the fit cannot see.
        share: f64,
    },
    /// The distance of a fit from its contour was not measured, because the series has too many harmonics.
    DistanceNotMeasured,
    /// The polynomial of Theorem 2 is a perfect square; its root is taken.
    PerfectSquare,
    /// The answer is that of the equation of a parametric form, a curve or a patch, and the equation has points that are not on it.
    EquationHasMore(&'static str),
    /// Coordinates are relative to this point.
    RelativeTo(Vec<Rational>),
    /// The polynomial of a form with this center is expanded in original coordinates, where its terms cancel.
    Expanded {
        /// The center.
        center: Vec<Rational>,
        /// About how many decimal digits cancel near the form.
        digits: u32,
    },
    /// So many points of the equation of a parametric curve, which are not on the curve, are left out.
    PointsBeyond(usize),
    /// A parametric curve is in a line through the origin, and has no rows; it may be a part of the line.
    CurveInLine {
        /// The angle θ of the line.
        theta: f64,
    },
    /// A whole line through the origin belongs to the form; it has no rows.
    WholeLine {
        /// The nominal angle θ.
        theta: f64,
        /// The nominal angle φ, in space.
        phi: Option<f64>,
    },
    /// Arcs were requested, but every component has an exact parametrization.
    NoArcsNeeded,
    /// Components without a parametrization are left out.
    ComponentsLeftOut,
    /// There is no Fourier fit, because no positive radius without a closed form covers the full circle.
    NoFourierFit,
    /// The outermost positive radius is fitted; it jumps between branches at this number of angles.
    Jumps(usize),
    /// Some inputs were not doubles and were rounded.
    Rounded {
        /// The number of inputs that were rounded.
        rounded: usize,
        /// The number of all inputs.
        total: usize,
    },
    /// The components of a curve were not found within the limits, so some may be missing in the picture.
    ComponentsUnknown,
    /// An oval is too small for the picture and is drawn as a dot.
    DrawnAsDot {
        /// The middle of the oval.
        at: [f64; 2],
        /// The length of the larger side of its extent.
        size: f64,
    },
    /// These components, with their kinds and extents in x and in y, are outside of the window.
    OutsideWindow(Vec<(ComponentKind, [[f64; 2]; 2])>),
    /// No points were found to fit a picture to, or a single one, which is in the middle of the picture.
    NothingToFitTo {
        /// The point.
        point: Option<[f64; 2]>,
        /// The coordinates that the picture shows.
        shown: [[f64; 2]; 2],
    },
    /// Of a cloud, only some points are drawn.
    PointsNotDrawn {
        /// The number of points that are drawn.
        drawn: usize,
        /// The number of all points.
        total: usize,
    },
    /// A component of a curve is not drawn, for this reason.
    NotDrawn(String),
    /// It is not proved that all bounded pieces of a surface are in the box of a picture.
    PiecesMayBeOutside,
    /// This surface is drawn in the box of other forms, which does not show all of what would be shown of it alone.
    DrawnInOthersBox(String),
    /// No part of this surface was found in the box of a picture.
    SurfaceNotSeen(String),
    /// Parts of a surface that are smaller than a cell may be missing in a picture.
    SmallPartsMayBeMissing {
        /// The number of cells that are not proved to hold a single smooth sheet.
        open: usize,
        /// The number of cells that may hold a part of the surface.
        all: usize,
        /// The longest side of a cell.
        cell: f64,
    },
    /// Sheets that are nearer to each other than this may have gaps beside a singular curve.
    SheetsNearCurves(f64),
    /// A surface may have singular points that were not found.
    MayBeSingular,
    /// No point is inside, because the uncertainty of the points takes up the tolerance zone.
    ZoneUsedUp,
    /// At most points exactly in the middle of the tolerance zone are inside, because the uncertainty of the points takes up the rest.
    ZoneIsPoint,
    /// Points that doubles do not decide are left undecided, because a factor has too many monomials.
    DoublesAlone,
}

/// A part of an answer that is missing if a limit is reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Part {
    /// The factors over Q.
    Factors,
    /// The angles at which a radius is positive.
    PositiveRanges,
    /// The topology of a plane curve.
    Topology,
    /// The genus of a factor.
    Genus,
    /// The real points of the zero set beyond a curve, and the real tracing index.
    BeyondCurve,
    /// A point of the zero set beyond a patch.
    BeyondPatch,
    /// Eq. (1) of Theorem 1 and its factors.
    PolarPlane,
    /// Eqs. (10) and (11) of Theorem 3 and their factors.
    PolarSpaceCurve,
    /// Eq. (15) of Theorem 4 and its factors.
    PolarPatch,
}
