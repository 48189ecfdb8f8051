//! What a check finds: rows, and what they amount to.

use std::borrow::Cow;

use super::deviation::{DOUBLE_DIGITS, Deviation, MOST_DIGITS};
use super::scale::Scale;
use crate::exact::Rational;

/// An extra term below this many digits of the coefficients of its degree is no rounding error.
pub(super) const NOISE_DIGITS: u32 = 6;

/// Where a number of a float program belongs.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum GivenNumber {
    /// The coefficient of x^i y^j z^k.
    Term([u32; 3]),
    /// A point in a row of a file.
    Point {
        /// The line in the file, from 1.
        line: usize,
        /// x, y and z, the last one 0 in the plane.
        position: [f64; 3],
    },
    /// A radius in a row of a file.
    Radius {
        /// The line in the file, from 1.
        line: usize,
        /// The angle, exactly this double.
        theta: f64,
    },
}

/// f at a point, computed exactly and then rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Residual {
    /// f(x, y), of the polynomial as the reference has it.
    pub value: f64,
    /// |f|/|∇f|: the distance from the zero set to first order; infinite where only the gradient is 0.
    pub first_order: f64,
}

/// A number of a float program beside the exact one.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Row {
    /// Which number.
    pub place: GivenNumber,
    /// What the float program has; for a point its distance from the origin, rounded.
    pub got: f64,
    /// What is exact: the scaled coefficient; or the radius on the ray, within 2⁻⁶⁰ of itself. `None` where there is nothing
    /// to compare with.
    pub exact: Option<Rational>,
    /// The distance of the two.
    pub deviation: Deviation,
    /// Of points.
    pub residual: Option<Residual>,
}

/// A usual mistake that explains what is wrong, or a kind of fault that none explains.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Diagnosis {
    /// A short name: `a0 halved`.
    pub name: Cow<'static, str>,
    /// What a program with this mistake does, and what would be right; or what the wrong numbers have in common.
    pub explanation: Cow<'static, str>,
    /// The mark, in digits, at which faults were counted.
    pub mark: u32,
    /// How many numbers miss the mark beside the reference, missing and extra ones included …
    pub faults: usize,
    /// … and how many beside what the mistake leads to.
    pub faults_left: usize,
}

/// A float program's numbers beside the exact ones.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// Whether places have a z.
    pub in_space: bool,
    /// What both have, in the order of the terms or of the file.
    pub rows: Vec<Row>,
    /// Terms that the float program lacks.
    pub missing: Vec<Row>,
    /// Terms that only the float program has. Their deviation is relative to the largest exact coefficient of the
    /// same degree, or of all where that degree does not occur.
    pub extra: Vec<Row>,
    /// The common factor of coefficients.
    pub scale: Option<Scale>,
    /// Usual mistakes that explain what is wrong; where none does, what is wrong by kind.
    pub diagnoses: Vec<Diagnosis>,
}

impl Comparison {
    /// Everything that was judged: what both have, and what one lacks.
    pub fn all(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().chain(&self.missing).chain(&self.extra)
    }

    /// The rows with the fewest digits first.
    #[must_use]
    pub fn worst(&self, count: usize) -> Vec<&Row> {
        let mut rows: Vec<&Row> = self.rows.iter().collect();
        // No relative distance is an infinite one.
        rows.sort_by(
            |a, b| match (a.deviation.relative(), b.deviation.relative()) {
                (Some(a), Some(b)) => b.cmp(a),
                (a, b) => a.is_some().cmp(&b.is_some()),
            },
        );
        rows.truncate(count);
        rows
    }

    /// The digits that half of the rows have at least; `None` without rows.
    #[must_use]
    pub fn median_digits(&self) -> Option<f64> {
        let mut digits: Vec<f64> = self.rows.iter().map(|r| r.deviation.digits()).collect();
        let place = digits.len().checked_sub(1)? / 2;
        Some(*digits.select_nth_unstable_by(place, f64::total_cmp).1)
    }

    /// What has fewer than so many digits; a missing term has none.
    #[must_use]
    pub fn below(&self, digits: u32) -> Vec<&Row> {
        self.all()
            .filter(|row| !row.deviation.reaches(digits))
            .collect()
    }

    /// The digits of a double that the worst row has lost; `None` without rows.
    #[must_use]
    pub fn digits_lost(&self) -> Option<f64> {
        let worst = self.worst(1).first()?.deviation.digits();
        Some((DOUBLE_DIGITS - worst).max(0.0))
    }

    /// How many rows have 0, 1, …, 17 whole digits.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "digits are from 0 to 17"
    )]
    pub fn histogram(&self) -> Vec<usize> {
        let mut counts = vec![0; MOST_DIGITS as usize + 1];
        for row in &self.rows {
            counts[row.deviation.digits().floor() as usize] += 1;
        }
        counts
    }

    /// What fails: with a mark, everything that has fewer digits; without one, the terms that are missing, and those
    /// that are there and are no rounding errors (of less than 6 digits).
    #[must_use]
    pub fn failures(&self, mark: Option<u32>) -> Vec<&Row> {
        match mark {
            Some(digits) => self.below(digits),
            None => {
                let noise = |row: &&Row| !row.deviation.reaches(NOISE_DIGITS);
                self.missing
                    .iter()
                    .chain(self.extra.iter().filter(noise))
                    .collect()
            }
        }
    }

    /// Whether the float program passes: nothing fails and, without a mark, no usual mistake is recognised.
    #[must_use]
    pub fn passes(&self, mark: Option<u32>) -> bool {
        self.failures(mark).is_empty() && (mark.is_some() || self.diagnoses.is_empty())
    }
}
