//! Inspected points, and the numbers of points with each verdict.

use super::{Inspection, Verdict};
use crate::parametrize::AngleRange;

/// A point as it was given, with the result of its inspection.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct InspectedPoint<'a> {
    /// The coordinates as they were written, two or three.
    pub written: &'a [&'a str],
    /// The verdict, the paper's criterion and the bounds of the distance.
    pub inspection: Inspection,
    /// The section of Theorem 8 about the point.
    pub section: Section,
}

/// The angles at which the sphere or circle about a point meets the form.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Section {
    /// The angles were not requested. Or the form is parametric, so that the sphere meets it in single points.
    NotAsked,
    /// The computation of the angles is beyond the limits.
    TooLong,
    /// The exact ranges of the angles.
    At(Vec<AngleRange>),
}

/// The numbers of points with each verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct InspectionSummary {
    /// The number of points within the tolerance.
    pub inside: usize,
    /// The number of points farther away than the tolerance.
    pub outside: usize,
    /// The number of points for which neither was proved.
    pub undecided: usize,
    /// The number of points that are inside although the sphere about the point misses the surface: a whole piece of the
    /// surface is inside the ball.
    pub enclosed: usize,
    /// The number of rows that are no points and were skipped.
    pub bad: usize,
    /// The row of the farthest point, counted from 1, and a lower bound of its distance.
    pub worst: Option<(usize, f64)>,
}

impl InspectionSummary {
    /// Counts a point.
    pub fn add(&mut self, row: usize, found: &Inspection) {
        match found.verdict {
            Verdict::Inside => self.inside += 1,
            Verdict::Outside => self.outside += 1,
            Verdict::Undecided => self.undecided += 1,
        }
        if found.verdict == Verdict::Inside && found.curve == Some(false) {
            self.enclosed += 1;
        }
        if self.worst.is_none_or(|(_, low)| found.distance.low > low) {
            self.worst = Some((row, found.distance.low));
        }
    }

    /// Adds the counts of later rows.
    pub fn join(&mut self, later: &Self) {
        self.inside += later.inside;
        self.outside += later.outside;
        self.undecided += later.undecided;
        self.enclosed += later.enclosed;
        self.bad += later.bad;
        if let Some((row, low)) = later.worst
            && self.worst.is_none_or(|(_, known)| low > known)
        {
            self.worst = Some((row, low));
        }
    }

    /// The number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.inside + self.outside + self.undecided
    }
}
