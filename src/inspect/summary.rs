//! Points with what is certain of them, and how many have which verdict.

use super::{Inspection, Verdict};
use crate::parametrize::AngleRange;

/// A point as it was given, and what is certain of it.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct InspectedPoint<'a> {
    /// Its coordinates as written, two or three.
    pub written: &'a [&'a str],
    /// The verdict and the distance.
    pub inspection: Inspection,
    /// The section of Theorem 8 about it.
    pub section: Section,
}

/// The angles at which the sphere or circle about a point meets the form.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Section {
    /// They were not asked for, or the form is given by a parameter: then it is met in single points.
    NotAsked,
    /// They are beyond the limits of what is computed.
    TooLong,
    /// Exactly.
    At(Vec<AngleRange>),
}

/// How many points have which verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct InspectionSummary {
    /// Within the tolerance.
    pub inside: usize,
    /// Farther away.
    pub outside: usize,
    /// Neither could be proved.
    pub undecided: usize,
    /// Inside, but the sphere about the point misses the surface: a whole piece of it is inside the ball.
    pub enclosed: usize,
    /// Rows that are no points, and were passed over.
    pub bad: usize,
    /// The row, from 1, and the distance of the farthest point: at least so much.
    pub worst: Option<(usize, f64)>,
}

impl InspectionSummary {
    /// Counts one more point.
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

    /// Counts what comes after.
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

    /// All points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.inside + self.outside + self.undecided
    }
}
