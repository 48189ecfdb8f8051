//! The results of a check: the compared numbers, and the conclusions from them.

use std::borrow::Cow;

use super::deviation::{DOUBLE_DIGITS, Deviation, MOST_DIGITS};
use super::scale::Scale;
use crate::exact::Rational;

/// An extra term is no rounding error if it is larger than 10^−NOISE_DIGITS times the largest coefficient of its degree.
pub(super) const NOISE_DIGITS: u32 = 6;

/// The meaning of a number of a float program.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum GivenNumber {
    /// The coefficient of x^i y^j z^k.
    Term([u32; 3]),
    /// A point in a row of a file.
    Point {
        /// The line in the file, counted from 1.
        line: usize,
        /// The coordinates x, y and z; z is 0 in the plane.
        position: [f64; 3],
    },
    /// A radius in a row of a file.
    Radius {
        /// The line in the file, counted from 1.
        line: usize,
        /// The angle, exactly this double.
        theta: f64,
    },
    /// The coefficient of the spherical harmonic Y(l, m).
    Harmonic {
        /// The degree.
        l: usize,
        /// The order.
        m: isize,
    },
    /// A radius in space in a row of a file.
    SpaceRadius {
        /// The line in the file, counted from 1.
        line: usize,
        /// The angle about z, exactly this double.
        theta: f64,
        /// The angle from z, exactly this double.
        phi: f64,
    },
}

/// The value of f at a point, computed exactly and then rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Residual {
    /// The value of the reference's polynomial at the point.
    pub value: f64,
    /// |f|/|∇f|: the distance from the zero set to first order; infinite if only the gradient is 0.
    pub first_order: f64,
}

/// A number of a float program and its exact counterpart.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Row {
    /// The meaning of the number.
    pub place: GivenNumber,
    /// The number of the float program; for a point, its distance from the origin, rounded.
    pub got: f64,
    /// The exact counterpart: the coefficient times the common factor, or the radius on the ray up to 2⁻⁶⁰ of itself. `None` if
    /// there is nothing to compare with.
    pub exact: Option<Rational>,
    /// The distance of the two numbers.
    pub deviation: Deviation,
    /// The residual; only points have one.
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
    /// The number of correct digits below which a number counts as a fault.
    pub mark: u32,
    /// How many numbers were compared for this. Of many radii or points, mistakes are tried with some that are spread over all.
    pub compared: usize,
    /// The number of faults among these in the comparison with the reference, with missing and extra terms.
    pub faults: usize,
    /// The number of faults in the comparison with the form that the mistake leads to.
    pub faults_left: usize,
}

/// The comparison of a float program's numbers with the exact ones.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// Whether terms and points have a z.
    pub in_space: bool,
    /// The numbers that both sides have, in the order of the terms or of the file.
    pub rows: Vec<Row>,
    /// Terms that the float program lacks.
    pub missing: Vec<Row>,
    /// Terms that only the float program has. Their deviation is their size relative to the largest exact coefficient of the
    /// same degree, or of all degrees if that degree does not occur.
    pub extra: Vec<Row>,
    /// The common factor of coefficients.
    pub scale: Option<Scale>,
    /// The usual mistakes that explain the faults; if there is none, the faults by kind.
    pub diagnoses: Vec<Diagnosis>,
}

impl Comparison {
    /// All rows: those that both sides have, the missing ones and the extra ones.
    pub fn all(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().chain(&self.missing).chain(&self.extra)
    }

    /// The `count` worst rows, those with the fewest digits first.
    #[must_use]
    pub fn worst(&self, count: usize) -> Vec<&Row> {
        let mut rows: Vec<&Row> = self.rows.iter().collect();
        // A row without a relative distance is infinitely far off.
        rows.sort_by(
            |a, b| match (a.deviation.relative(), b.deviation.relative()) {
                (Some(a), Some(b)) => b.cmp(a),
                (a, b) => a.is_some().cmp(&b.is_some()),
            },
        );
        rows.truncate(count);
        rows
    }

    /// The digits that at least half of the rows have; `None` without rows.
    #[must_use]
    pub fn median_digits(&self) -> Option<f64> {
        let mut digits: Vec<f64> = self.rows.iter().map(|r| r.deviation.digits()).collect();
        let place = digits.len().checked_sub(1)? / 2;
        Some(*digits.select_nth_unstable_by(place, f64::total_cmp).1)
    }

    /// All rows with fewer correct digits than this; a missing term has none.
    #[must_use]
    pub fn below(&self, digits: u32) -> Vec<&Row> {
        self.all()
            .filter(|row| !row.deviation.reaches(digits))
            .collect()
    }

    /// How many digits of a double the worst row has lost; `None` without rows.
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

    /// The rows that fail. With a mark, these are all rows with fewer digits. Without one, they are the missing terms, and the
    /// extra terms that are no rounding errors (with fewer than 6 digits).
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
