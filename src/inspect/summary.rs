//! Inspected points, and the numbers of points with each verdict.

use super::{DistanceBounds, Foot, Inspection, ToleranceZone, Verdict};
use crate::parametrize::AngleRange;

/// A point as it was given, with the result of its inspection.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct InspectedPoint<'a> {
    /// The coordinates as they were written, two or three.
    pub written: &'a [&'a str],
    /// The fields of other columns of its row.
    pub others: &'a [&'a str],
    /// The verdict, the paper's criterion and the bounds of the distance.
    pub inspection: Inspection,
    /// The section of Theorem 8 about the point.
    pub section: Section,
    /// The nearest point of the form, if feet were requested and one was found.
    pub foot: Option<Foot>,
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

/// A point of a table, by its row counted from 1, and the bounds of its distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowDistance {
    /// The row.
    pub row: usize,
    /// The bounds.
    pub distance: DistanceBounds,
}

/// The number of classes of a [`Histogram`] between the limits.
pub const CLASSES: usize = 10;

/// How many points have a signed distance s from the form, in classes of equal length from LOW to HIGH, which are −D and D for a
/// single tolerance D. The distance is negative inside, positive outside, and positive for a form without sides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Histogram {
    /// The number of points with s < LOW.
    pub below: usize,
    /// The numbers with LOW + wk ≤ s < LOW + w(k + 1) for w = (HIGH − LOW)/10 and k = 0 … 9; s = HIGH belongs to the last one.
    pub within: [usize; CLASSES],
    /// The number of points with s > HIGH.
    pub above: usize,
}

/// The limits of a tolerance zone in doubles, for a histogram.
#[derive(Clone, Copy, Debug)]
pub struct HistogramRange {
    middle: f64,
    /// Half the difference of the limits.
    half: f64,
    is_uncertain: bool,
}

impl HistogramRange {
    /// The range of a zone.
    #[must_use]
    pub fn of(zone: &ToleranceZone) -> Self {
        let [low, high] = zone.limits();
        Self {
            middle: (low + high).to_f64() / 2.0,
            half: (high - low).to_f64() / 2.0,
            is_uncertain: zone.is_uncertain(),
        }
    }

    /// The place of a signed distance: −1 is the lower limit, and 1 the upper one.
    fn place(&self, signed: f64) -> f64 {
        (signed - self.middle) / self.half
    }
}

/// The numbers of points with each verdict, and their distances.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct InspectionSummary {
    /// The number of points within the tolerance zone.
    pub inside: usize,
    /// The number of points outside of it.
    pub outside: usize,
    /// The number of points whose uncertainty leaves both open; `None` if the points have no uncertainty.
    pub uncertain: Option<usize>,
    /// The number of points for which neither was proved.
    pub undecided: usize,
    /// The number of points that are inside although the sphere about the point misses the surface: a whole piece of the
    /// surface is inside the ball.
    pub enclosed: usize,
    /// The number of rows that are no points and were skipped.
    pub bad: usize,
    /// The number of points of which no nearest point of the form was found, within the reach if there is one.
    pub not_found: usize,
    /// The number of points whose distance is known to fewer digits than requested.
    pub few_digits: usize,
    /// The number of points whose foot was requested and not found.
    pub without_foot: usize,
    /// The point with the smallest upper bound of the distance.
    pub nearest: Option<RowDistance>,
    /// The point with the largest lower bound of the distance.
    pub farthest: Option<RowDistance>,
    /// The largest upper bound of a distance.
    pub largest: f64,
    /// The signed distances.
    pub histogram: Histogram,
    /// The number of points with a known distance, and the sums of the middles of their bounds: of the distances, of their
    /// squares, and of the signed distances.
    measured: usize,
    sums: [f64; 3],
}

impl InspectionSummary {
    /// Counts a point.
    pub fn add(&mut self, row: usize, found: &Inspection, range: &HistogramRange) {
        if range.is_uncertain {
            let count = self.uncertain.get_or_insert(0);
            *count += usize::from(found.verdict == Verdict::Uncertain);
        }
        match found.verdict {
            Verdict::Inside => self.inside += 1,
            Verdict::Outside => self.outside += 1,
            Verdict::Uncertain => {}
            Verdict::Undecided => self.undecided += 1,
        }
        if found.verdict == Verdict::Inside && found.curve == Some(false) {
            self.enclosed += 1;
        }
        let distance = found.distance;
        let this = Some(RowDistance { row, distance });
        self.take(this, this, distance.high);
        if distance.high.is_finite() {
            let middle = f64::midpoint(distance.low, distance.high);
            let signed = f64::from(found.sign.unwrap_or(1)) * middle;
            self.measured += 1;
            for (sum, value) in self.sums.iter_mut().zip([middle, middle * middle, signed]) {
                *sum += value;
            }
            self.histogram.add(signed, range, found.verdict);
        }
    }

    fn take(&mut self, nearest: Option<RowDistance>, farthest: Option<RowDistance>, largest: f64) {
        let known = |at: &Option<RowDistance>, of: fn(&DistanceBounds) -> f64| {
            at.as_ref().map(|at| of(&at.distance))
        };
        let [high, low]: [fn(&DistanceBounds) -> f64; 2] = [|d| d.high, |d| d.low];
        if known(&nearest, high) < known(&self.nearest, high) || self.nearest.is_none() {
            self.nearest = nearest;
        }
        if known(&farthest, low) > known(&self.farthest, low) {
            self.farthest = farthest;
        }
        self.largest = self.largest.max(largest);
    }

    /// Adds later rows.
    pub fn join(&mut self, later: &Self) {
        self.inside += later.inside;
        self.outside += later.outside;
        self.undecided += later.undecided;
        if let Some(more) = later.uncertain {
            *self.uncertain.get_or_insert(0) += more;
        }
        self.enclosed += later.enclosed;
        self.bad += later.bad;
        self.not_found += later.not_found;
        self.few_digits += later.few_digits;
        self.without_foot += later.without_foot;
        if later.nearest.is_some() {
            self.take(later.nearest, later.farthest, later.largest);
        }
        self.measured += later.measured;
        for (sum, value) in self.sums.iter_mut().zip(later.sums) {
            *sum += value;
        }
        self.histogram.join(&later.histogram);
    }

    /// The number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.inside + self.outside + self.uncertain.unwrap_or(0) + self.undecided
    }

    /// The mean of the distances, the root of the mean of their squares, and the mean of the signed distances; approximate, and of
    /// the points whose distance is known. `None` if there are none.
    #[must_use]
    pub fn means(&self) -> Option<[f64; 3]> {
        #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
        let count = self.measured as f64;
        let [sum, squares, signed] = self.sums;
        (self.measured > 0).then(|| [sum / count, (squares / count).sqrt(), signed / count])
    }
}

impl Histogram {
    /// Counts a signed distance.
    fn add(&mut self, signed: f64, range: &HistogramRange, verdict: Verdict) {
        let part = range.place(signed);
        // The verdict is exact, and the quotient is not.
        let part = match verdict {
            Verdict::Inside => part.clamp(-1.0, 1.0),
            Verdict::Outside if signed < 0.0 => f64::NEG_INFINITY,
            Verdict::Outside => f64::INFINITY,
            Verdict::Uncertain | Verdict::Undecided => part,
        };
        if part < -1.0 {
            self.below += 1;
        } else if part > 1.0 {
            self.above += 1;
        } else {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "the number is from 0 to 10"
            )]
            let class = ((part + 1.0) / 2.0 * 10.0) as usize;
            self.within[class.min(CLASSES - 1)] += 1;
        }
    }

    fn join(&mut self, later: &Self) {
        self.below += later.below;
        self.above += later.above;
        for (count, more) in self.within.iter_mut().zip(later.within) {
            *count += more;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(verdict: Verdict, distance: f64, sign: Option<i8>) -> Inspection {
        Inspection {
            verdict,
            curve: Some(false),
            distance: DistanceBounds {
                low: distance,
                high: distance,
            },
            sign,
        }
    }

    #[test]
    fn distances_are_summed_up() {
        let range = HistogramRange::of(&"1".parse().unwrap());
        let mut first = InspectionSummary::default();
        first.add(1, &found(Verdict::Inside, 0.5, Some(-1)), &range);
        first.add(2, &found(Verdict::Outside, 3.0, Some(1)), &range);
        let mut later = InspectionSummary::default();
        later.add(3, &found(Verdict::Inside, 1.0, Some(1)), &range);
        later.add(4, &found(Verdict::Outside, 2.0, Some(-1)), &range);
        first.join(&later);
        let rows = [first.nearest, first.farthest].map(|at| at.unwrap().row);
        assert_eq!((rows, first.largest), ([1, 2], 3.0));
        let [mean, rms, signed] = first.means().unwrap();
        assert_eq!((mean, signed), (6.5 / 4.0, 1.5 / 4.0));
        assert!((rms * rms - 14.25 / 4.0).abs() < 1e-12);
        let histogram = first.histogram;
        assert_eq!((histogram.below, histogram.above), (1, 1));
        assert_eq!(histogram.within, [0, 0, 1, 0, 0, 0, 0, 0, 0, 1]);
        assert_eq!(InspectionSummary::default().means(), None);
    }

    #[test]
    fn classes_go_from_limit_to_limit() {
        let zone: ToleranceZone = "-1,4".parse().unwrap();
        let zone = zone.with_uncertainty("1/4".parse().unwrap()).unwrap();
        let range = HistogramRange::of(&zone);
        let mut found_all = InspectionSummary::default();
        let points = [
            (Verdict::Inside, 0.6, Some(-1)),
            (Verdict::Inside, 0.1, Some(1)),
            (Verdict::Uncertain, 4.0, Some(1)),
            (Verdict::Uncertain, 4.1, Some(1)),
            (Verdict::Outside, 1.5, Some(-1)),
            (Verdict::Outside, 4.5, Some(1)),
            (Verdict::Undecided, 3.0, Some(1)),
        ];
        for (row, (verdict, distance, sign)) in (1..).zip(points) {
            found_all.add(row, &found(verdict, distance, sign), &range);
        }
        let histogram = found_all.histogram;
        assert_eq!((histogram.below, histogram.above), (1, 2));
        assert_eq!(histogram.within, [1, 0, 1, 0, 0, 0, 0, 0, 1, 1]);
        assert_eq!((found_all.uncertain, found_all.points()), (Some(2), 7));
    }
}
