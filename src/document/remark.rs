//! Remarks about the work, and missing parts of an answer, as sentences.

use crate::exact::Rational;
use crate::fit::{ContourKind, LeftOut};
use crate::inspect::MAX_EXACT_MONOMIALS;
use crate::reading::{HarmonicLayout, Normalization, ReadHarmonics};
use crate::rows::listed;
use crate::topology::ComponentKind;
use crate::verb::{Missing, Part, Remark};

/// The sentence for a radius without even harmonics, for which the polynomial of Theorem 2 is a square.
pub(super) const PERFECT_SQUARE: &str = "F of Theorem 2 is a perfect square (a0 = 0 and only odd harmonics): this is its reduced equation";

/// A remark as a sentence.
///
/// ```
/// use stellate::document::remark_text;
/// use stellate::verb::Remark;
/// let text = remark_text(&Remark::RelativeTo(vec![1.into(), 2.into()]));
/// assert_eq!(text, "coordinates are relative to the center (1, 2)");
/// ```
#[must_use]
pub fn remark_text(remark: &Remark) -> String {
    match remark {
        Remark::Center {
            outline,
            point: [x, y],
            origin,
        } => format!(
            "the center of the outline of {outline} is ({x}, {y}): {}",
            origin.describe()
        ),
        Remark::HarmonicFile { file, read } => harmonic_file_text(file, read),
        Remark::FormOfComment(form) => format!(
            "the form is {form}, of which the text says in a comment that it parametrizes it; without the comment it is the formula beside it"
        ),
        Remark::OriginAdded => "this radius is never 0, but every polynomial that is 0 on the curve is 0 at the origin, too: all answers are those of the equation, which has the origin as an isolated point".into(),
        Remark::Hidden {
            outline,
            point: [x, y],
            share,
        } => format!(
            "the outline of {outline} is not star-shaped about ({x}, {y}): its outermost boundary is taken; {:.3} % of its length is hidden behind it{}",
            share * 100.0,
            if *share > 0.01 { "; --model elliptic follows all of it" } else { "" }
        ),
        Remark::DistanceNotMeasured => "the distance between the outline and the fitted curve was not measured: the series has too many harmonics for that".into(),
        Remark::LeftOut { outline, left_out } => left_out_text(outline, left_out),
        Remark::PerfectSquare => PERFECT_SQUARE.into(),
        Remark::EquationHasMore(kind) => format!(
            "this is the answer for the equation, which has points that are not on the {kind} (implicitize names some); inspect and plot answer for the {kind} itself"
        ),
        Remark::RelativeTo(center) => {
            format!("coordinates are relative to the center ({})", listed(center))
        }
        Remark::Expanded { center, digits } => format!(
            "in original coordinates the terms of the polynomial cancel: {}; with --coordinates center the polynomial is evaluated at points minus the center ({})",
            match digits {
                0..13 => format!("doubles lose ≈ {digits} of their 16 digits near its zeros"),
                _ => "doubles will mostly fail to evaluate it, even far from its zeros".into(),
            },
            listed(center)
        ),
        Remark::PointsBeyond(count) => format!(
            "points of the equation that no real parameter of the curve has are left out: {count}"
        ),
        Remark::CurveInLine { theta } => format!(
            "the curve lies in the line at theta = {theta} and may be only a part of it: it has no rows"
        ),
        Remark::WholeLine { theta, phi: None } => format!(
            "the whole line at theta = {theta} belongs to the curve: it has no rows"
        ),
        Remark::WholeLine {
            theta,
            phi: Some(phi),
        } => format!(
            "the whole line at theta = {theta}, phi = {phi} belongs to the surface: it has no rows"
        ),
        Remark::NoArcsNeeded => "every component has an exact parametrization: --window and --resolution are for arcs of the others".into(),
        Remark::ComponentsLeftOut => "components without a parametrization are left out: text, json and csv have arcs of them, for two surfaces".into(),
        Remark::NoFourierFit => "no positive radius without a closed form covers the full circle: there is no Fourier fit".into(),
        Remark::Jumps(count) => format!(
            "no branch covers the full circle: the outermost positive radius is fitted, which jumps between branches (angles: {count})"
        ),
        Remark::Rounded { rounded, total } => format!(
            "{rounded} of {total} inputs were no doubles and were rounded; everything follows from the doubles exactly"
        ),
        Remark::NothingToFitTo {
            point,
            shown: [[a, b], [c, d]],
        } => {
            let what = match point {
                None => "no points were found to fit the picture to".to_owned(),
                Some([x, y]) => format!("only the point ({x}, {y}) was found to fit the picture to"),
            };
            format!("{what}: it shows {a},{b},{c},{d}; --window chooses another part")
        }
        Remark::ComponentsUnknown => "the components of the zero set were not found within the limits: some may be missing in the picture, isolated points and small ovals among them".into(),
        Remark::DrawnAsDot { at: [x, y], size } => format!(
            "an oval of size ≈ {size:.3e} about ({x:.6}, {y:.6}) is drawn as a dot; --window shows it larger"
        ),
        Remark::OutsideWindow(components) => outside_text(components),
        Remark::PointsNotDrawn { drawn, total } => format!(
            "{drawn} of the {total} points of the cloud are drawn"
        ),
        Remark::NotDrawn(reason) => format!("a component of the curve is not drawn: {reason}"),
        Remark::SheetsNearCurves(distance) => format!(
            "sheets cross along curves, which are drawn as lines; beside them sheets that are nearer to each other than {distance:.1e} may have gaps"
        ),
        Remark::MayBeSingular => "the surface may have singular points that were not found: isolated points, and curves at which no sheet ends, are not drawn".into(),
        Remark::PiecesMayBeOutside => "a piece of the surface may be outside of the picture".into(),
        Remark::DrawnInOthersBox(label) => format!(
            "{label}: only the part in the box of the other forms is shown; --window shows more"
        ),
        Remark::SurfaceNotSeen(label) => {
            format!("{label}: no part of the surface was found in the box of the picture")
        }
        Remark::SmallPartsMayBeMissing { open, all, cell } => format!(
            "{open} of {all} cells of side {cell:.2e} are not proved to hold a single smooth sheet: there the picture may miss what is smaller; a larger --cells shows more"
        ),
        Remark::ZoneUsedUp => "the uncertainty takes up the tolerance: no point can be proved to be inside".into(),
        Remark::ZoneIsPoint => "the uncertainty takes up the tolerance: no point can be proved to be inside that is not exactly in the middle of the zone".into(),
        Remark::DoublesAlone => format!(
            "a factor has more than {MAX_EXACT_MONOMIALS} monomials: points that doubles do not decide are left undecided"
        ),
    }
}

/// The convention that a file of spherical harmonics was read with.
fn harmonic_file_text(file: &str, read: &ReadHarmonics) -> String {
    let rows = match read.layout {
        HarmonicLayout::Real => "rows l m C S",
        HarmonicLayout::Complex => "rows n m Re Im of complex coefficients",
        HarmonicLayout::Long => "rows l,m,value",
    };
    let normalization = match read.normalization {
        Normalization::Unnormalized => "unnormalized",
        Normalization::FourPi => "4pi-normalized",
        Normalization::Orthonormal => "orthonormal",
        Normalization::Schmidt => "Schmidt semi-normalized",
    };
    let phase = if read.condon_shortley {
        "with"
    } else {
        "without"
    };
    let bound = read.surface.rounding();
    let rounded = match bound.is_zero() {
        true => "the coefficients are exact".to_owned(),
        false => format!(
            "irrational norms were rounded, so that the radius is off by at most {:.3e} in every direction (certified)",
            bound.to_f64()
        ),
    };
    format!(
        "{file}: {rows}, degree {}, taken as {normalization} {phase} the Condon-Shortley phase (--normalization and --condon-shortley say otherwise); {rounded}",
        read.surface.degree()
    )
}

/// A number of things in words: "1 point", "3 points".
pub(super) fn counted(count: usize, one: &str, several: &str) -> String {
    match count {
        1 => format!("1 {one}"),
        count => format!("{count} {several}"),
    }
}

/// What of a file is not in the outline, in a sentence.
fn left_out_text(outline: &str, left_out: &LeftOut) -> String {
    let mut all = Vec::new();
    if left_out.parts > 0 {
        let (parts, size) = match left_out.kind {
            ContourKind::Drawing => (["other closed path", "other closed paths"], "area"),
            ContourKind::Polygons => (["other polygon", "other polygons"], "area"),
            _ => (
                [
                    "other part of the silhouette",
                    "other parts of the silhouette",
                ],
                "pixels",
            ),
        };
        all.push(format!(
            "{}, the largest with {:.1} % of the {size} of the one that is taken (--blob chooses another one)",
            counted(left_out.parts, parts[0], parts[1]),
            left_out.largest * 100.0
        ));
    }
    if left_out.holes > 0 {
        all.push(counted(left_out.holes, "hole", "holes"));
    }
    if left_out.frame > 0 {
        let pixels = counted(left_out.frame, "pixel", "pixels");
        all.push(format!("a frame of {pixels} around the picture"));
    }
    if left_out.background {
        all.push("a rectangle that covers the whole drawing".into());
    }
    if left_out.open > 0 {
        all.push(match left_out.kind {
            ContourKind::Drawing => counted(left_out.open, "open path", "open paths"),
            _ => counted(left_out.open, "point or open line", "points or open lines"),
        });
    }
    let removed = &left_out.removed;
    if removed.points > 0 {
        let points = counted(removed.points, "point", "points");
        let loops = counted(removed.ways.len(), "loop", "loops");
        all.push(format!(
            "{points} in {loops}, {:.3} % of its length (--repair)",
            100.0 * removed.share
        ));
    }
    format!("the outline of {outline} leaves out {}", all.join(", "))
}

/// What is outside of the window of a picture.
fn outside_text(components: &[(ComponentKind, [[f64; 2]; 2])]) -> String {
    const MOST: usize = 5;
    let shown: Vec<String> = components
        .iter()
        .take(MOST)
        .map(|(kind, [x, y])| match kind {
            ComponentKind::Point => format!("the point ({:.6}, {:.6})", x[0], y[0]),
            kind => format!(
                "{} with x in {:.6} to {:.6} and y in {:.6} to {:.6}",
                if *kind == ComponentKind::Oval {
                    "an oval"
                } else {
                    "an unbounded component"
                },
                x[0],
                x[1],
                y[0],
                y[1]
            ),
        })
        .collect();
    let more = components.len().saturating_sub(MOST);
    let rest = if more > 0 {
        format!(", and {more} more")
    } else {
        String::new()
    };
    format!("outside of the window: {}{rest}", shown.join("; "))
}

/// The name of a part of an answer.
pub(super) fn part_text(part: Part) -> &'static str {
    match part {
        Part::Factors => "the factors over Q",
        Part::PositiveRanges => "the angles with r > 0",
        Part::Topology => "the topology of the curve",
        Part::Genus => "the genus of a factor",
        Part::BeyondCurve => {
            "what the real zero set has beyond the curve, isolated points among it, and the real tracing index"
        }
        Part::BeyondPatch => "a point of the zero set beyond the patch",
        Part::PolarPlane => "Eq. (1) of Theorem 1 and its factors",
        Part::PolarSpaceCurve => "Eqs. (10) and (11) of Theorem 3 and their factors",
        Part::PolarPatch => "Eq. (15) of Theorem 4 and its factors",
    }
}

/// The sentence that names the parts of the answer that are missing because a limit was reached.
#[must_use]
pub fn missing_text(missing: &Missing) -> String {
    let parts: Vec<&str> = missing.parts.iter().map(|&part| part_text(part)).collect();
    format!("what is written lacks {}", parts.join(", and "))
}

/// The sentence about rounded coefficients.
pub(super) fn rounding_note(bound: &Rational) -> String {
    format!(
        "the coefficients are rounded: in every direction the radius differs from that of the file by at most {:.3e} (certified)",
        bound.to_f64()
    )
}
