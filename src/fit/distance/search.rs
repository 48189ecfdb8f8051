//! The search for the fewest harmonics whose distance from an outline is small enough.
//!
//! A curve that is far from the outline also says that those with a few harmonics more are far from it, because they are near
//! this curve. So most numbers of harmonics are excluded without being measured.

use super::{ABSOLUTE, Outline};
use crate::error::{Error, Invariant, Result};
use crate::limits::Limits;
use crate::shape::{Contour, EllipticSeries};

/// After a search without success among fewer numbers of harmonics than this, all are measured to name the best one.
const FEW: usize = 64;
/// Of more, so many parts of the largest number are measured, and so many with the smallest lower bounds.
const CANDIDATES: usize = 8;

/// How far a curve of a family can be from the one with a harmonic less.
#[derive(Debug)]
pub(in crate::fit) enum Step<'a> {
    /// For each number of harmonics, at most about this far: the size of the last harmonic. Those beyond the list are 0.
    Sizes(&'a [f64]),
    /// Any distance: all coefficients change with the number of harmonics.
    Unknown,
}

impl Step<'_> {
    /// An upper bound of the distance between corresponding points of the curves with n and with n − 1 harmonics.
    fn at(&self, n: usize) -> f64 {
        match self {
            // The sizes are a few roundings away from those of the exact coefficients.
            Self::Sizes(sizes) => sizes.get(n).map_or(0.0, |size| size * (1.0 + 1e-9)),
            Self::Unknown => f64::INFINITY,
        }
    }
}

/// The search for the fewest harmonics whose distance from an outline is small enough.
#[derive(Debug)]
pub(in crate::fit) struct DistanceSearch {
    outline: Outline,
    /// The largest distance that is small enough.
    enough: f64,
    /// A lower bound of the distance for the last number of harmonics.
    low: f64,
    /// The last number of harmonics that was tried or excluded.
    last: usize,
    /// The numbers of harmonics that were measured, with lower bounds of their distances.
    measured: Vec<(f64, usize)>,
    /// The first number of harmonics that cannot be tried, and why.
    end: Option<(usize, &'static str)>,
}

impl DistanceSearch {
    /// # Errors
    /// [`Error::Limit`] if a distance of `enough` is too small to be measured.
    pub(in crate::fit) fn new(contour: &Contour, enough: f64) -> Result<Self> {
        let outline = Outline::new(contour);
        let least = ABSOLUTE * outline.frame.scale();
        if enough < least {
            return Err(Error::limit(format!(
                "the distance from this outline is measured to {least:e}, so it cannot be certified to be within {enough:e}"
            )));
        }
        Ok(Self {
            outline,
            enough,
            low: f64::NEG_INFINITY,
            last: 0,
            measured: Vec::new(),
            end: None,
        })
    }

    /// The first number of harmonics for which the upper bound of the distance is small enough. The distance of each smaller one
    /// was measured, or is too large because that of a curve with fewer harmonics is, and the next ones differ little from it.
    ///
    /// The numbers are consecutive, also from one call to the next. The search ends with the first one without a curve, because the
    /// points do not determine it.
    pub(in crate::fit) fn fewest(
        &mut self,
        harmonics: impl Iterator<Item = usize>,
        curve: impl Fn(usize) -> Result<Option<EllipticSeries>>,
        step: &Step<'_>,
        limits: &Limits,
    ) -> Result<Option<usize>> {
        let scale = self.outline.frame.scale();
        for n in harmonics {
            if self.end.is_some() {
                return Ok(None);
            }
            self.last = n;
            // No point of the curve moved farther than the step, so the distance has not changed by more.
            self.low -= step.at(n);
            if self.low > self.enough * (1.0 + 1e-9) {
                continue;
            }
            let Some(tried) = curve(n)? else {
                self.end = Some((n, "the points do not determine the coefficients"));
                return Ok(None);
            };
            let found = self.outline.enclose(&tried, self.enough / scale, limits)?;
            let Some((bounds, _)) = found else {
                self.end = Some((n, "the distance takes too long to measure"));
                return Ok(None);
            };
            let bounds = self.outline.in_its_units(bounds);
            if bounds.high <= self.enough {
                return Ok(Some(n));
            }
            self.low = bounds.low;
            self.measured.push((bounds.low, n));
        }
        Ok(None)
    }

    /// The error for a search without success; `hint` says what would allow more harmonics.
    pub(in crate::fit) fn missed(
        mut self,
        series: &str,
        hint: &str,
        curve: impl Fn(usize) -> Result<Option<EllipticSeries>>,
        limits: &Limits,
    ) -> Error {
        let (last, why) = match self.end {
            Some((n, why)) => (before(n), format!("; with {n}, {why}")),
            None => (self.last, String::new()),
        };
        let best = match self.best(last, curve, limits) {
            Ok(best) => best,
            Err(error) => return error,
        };
        let finished = match best {
            Some((distance, n)) => {
                format!("the best of those measured is ≤ {distance:e}, with {n} harmonics{hint}")
            }
            None => "no distance was measured".to_owned(),
        };
        Error::Limit {
            limit: format!(
                "no number of harmonics up to {last} brings {series} within {} of the outline{why}",
                self.enough
            ),
            finished,
        }
    }

    /// The smallest upper bound of the distance that is found among candidates, and its number of harmonics.
    ///
    /// The search knows of a curve that is too far away only that it is: its bounds say little of how far. Few numbers are all
    /// measured; of many, the largest one, parts of it, and those with the smallest lower bounds.
    fn best(
        &mut self,
        last: usize,
        curve: impl Fn(usize) -> Result<Option<EllipticSeries>>,
        limits: &Limits,
    ) -> Result<Option<(f64, usize)>> {
        self.measured
            .sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let nearest = self.measured.iter().take(CANDIDATES).map(|(_, n)| *n);
        let mut candidates: Vec<usize> = match last < FEW {
            true => (0..=last).collect(),
            false => (1..=CANDIDATES)
                .map(|k| last * k / CANDIDATES)
                .chain(nearest)
                .collect(),
        };
        candidates.sort_unstable();
        candidates.dedup();
        let mut best: Option<(f64, usize)> = None;
        for n in candidates {
            let Some(tried) = curve(n)? else {
                continue;
            };
            let least = best.map_or(f64::INFINITY, |(high, _)| high);
            let enough = least / self.outline.frame.scale();
            let Some((bounds, _)) = self.outline.enclose(&tried, enough, limits)? else {
                continue;
            };
            let high = self.outline.in_its_units(bounds).high;
            if high < least {
                best = Some((high, n));
            }
        }
        Ok(best)
    }
}

/// The number of harmonics before one that cannot be tried.
pub(in crate::fit) fn before(n: usize) -> usize {
    n.checked_sub(1)
        .invariant("a series without harmonics is determined, and measured")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::fit::as_f64;
    use crate::fit::elliptic::sizes;
    use proptest::prelude::*;

    fn contour(points: &[[f64; 2]]) -> Contour {
        Contour::new(points.to_vec(), "test").unwrap()
    }

    /// A curve with the given coefficients of 1, cos nt and sin nt, x before y.
    fn series(harmonics: &[[i8; 4]]) -> EllipticSeries {
        let list = |i: usize| {
            let size = |(n, c): (usize, &[i8; 4])| {
                Rational::from_dyadic(i64::from(c[i]).into(), -6) / Rational::from(n as i64 + 1)
            };
            harmonics.iter().enumerate().map(size).collect()
        };
        EllipticSeries::new(std::array::from_fn(list))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        /// The search finds what measuring every number of harmonics finds, whether it knows the sizes of the steps or not.
        #[test]
        fn what_is_excluded_is_too_far(
            radii in prop::collection::vec(0.2f64..1.0, 3..8),
            harmonics in prop::collection::vec(any::<[i8; 4]>(), 2..25),
            small in 0usize..6,
            enough in 0.01f64..2.5,
        ) {
            // Few large harmonics, and then small ones, of which most are excluded.
            let mut harmonics = harmonics;
            for harmonic in harmonics.iter_mut().skip(small) {
                *harmonic = harmonic.map(|c| c / 32);
            }
            let turn = std::f64::consts::TAU / as_f64(radii.len());
            let points = radii.iter().enumerate().map(|(k, radius)| {
                let (sin, cos) = (turn * as_f64(k)).sin_cos();
                [radius * cos, radius * sin]
            });
            let outline = contour(&points.collect::<Vec<_>>());
            let all = series(&harmonics);
            let most = harmonics.len();
            let curve = |n| Ok(Some(all.truncated(n)));
            let is_near = |n: usize| {
                let found = super::super::distances(&outline, &all.truncated(n), &Limits::none());
                found.unwrap().unwrap().hausdorff.high <= enough
            };
            let expected = (0..=most).find(|&n| is_near(n));
            for step in [Step::Sizes(&sizes(&all)), Step::Unknown] {
                let mut search = DistanceSearch::new(&outline, enough).unwrap();
                let found = search.fewest(0..=most, curve, &step, &Limits::none()).unwrap();
                prop_assert_eq!(found, expected);
                // In two calls, as in a search that computes more harmonics when it needs them.
                let mut search = DistanceSearch::new(&outline, enough).unwrap();
                let parts = [0..=most / 2, most / 2 + 1..=most];
                let found = parts
                    .into_iter()
                    .find_map(|part| search.fewest(part, curve, &step, &Limits::none()).transpose());
                prop_assert_eq!(found.transpose().unwrap(), expected);
            }
        }
    }

    #[test]
    fn few_curves_are_measured() {
        let square = contour(&[[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]);
        let all = series(&[[40, 50, -50, 40]; 500]);
        // Coefficients that decrease as 1/n² bring no curve near.
        let mut lists = all.lists().clone();
        for list in &mut lists {
            for (n, c) in list.iter_mut().enumerate() {
                *c = &*c / &Rational::from(n as i64 + 1);
            }
        }
        let all = EllipticSeries::new(lists);
        let mut search = DistanceSearch::new(&square, 0.2).unwrap();
        let step = Step::Sizes(&sizes(&all));
        let curve = |n| Ok(Some(all.truncated(n)));
        let found = search.fewest(0..=499, curve, &step, &Limits::none());
        assert_eq!(found.unwrap(), None);
        assert!(search.measured.len() < 20, "{:?}", search.measured);
    }

    /// Of the curves, only the one with 3 harmonics is within 1/4 of the square; the error names it and its distance.
    #[test]
    fn a_search_without_success_names_the_best_curve() {
        let square = contour(&[[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]);
        let circle = |radius: i64| {
            let list = |c: i64| vec![Rational::zero(), Rational::from_dyadic(c.into(), -3)];
            EllipticSeries::new([list(radius), list(0), list(0), list(radius)])
        };
        // The circle of radius 9/8 leaves out √2 − 9/8 = 0.2892 of the corners; the others are farther away.
        let curve = |n: usize| Ok(Some(circle([4, 6, 14, 9, 13][n])));
        let mut search = DistanceSearch::new(&square, 0.25).unwrap();
        let found = search.fewest(0..=4, curve, &Step::Unknown, &Limits::none());
        assert_eq!(found.unwrap(), None);
        let error = search.missed("a circle", "; ask for less", curve, &Limits::none());
        let message = error.to_string();
        assert!(
            message.contains("no number of harmonics up to 4 brings a circle within 0.25"),
            "{message}"
        );
        let distance = "the best of those measured is ≤ 2.89";
        assert!(message.contains(distance), "{message}");
        assert!(
            message.contains(", with 3 harmonics; ask for less"),
            "{message}"
        );
    }

    #[test]
    fn a_curve_that_takes_too_long_ends_the_search() {
        let square = contour(&[[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]);
        let wild = |n: usize| {
            let mut lists: [Vec<Rational>; 4] = Default::default();
            lists[0] = vec![Rational::zero(); if n < 2 { 2 } else { 600_000 }];
            *lists[0].last_mut().unwrap() = Rational::from_dyadic(1.into(), -30);
            Ok(Some(EllipticSeries::new(lists)))
        };
        let mut search = DistanceSearch::new(&square, 1e-3).unwrap();
        let found = search.fewest(0..=9, wild, &Step::Unknown, &Limits::none());
        assert_eq!(found.unwrap(), None);
        let message = search
            .missed("a curve", "", wild, &Limits::none())
            .to_string();
        assert!(
            message.contains("up to 1 brings a curve within 0.001"),
            "{message}"
        );
        assert!(
            message.contains("with 2, the distance takes too long to measure"),
            "{message}"
        );
    }

    #[test]
    fn a_distance_below_what_is_measured_is_refused() {
        let square = contour(&[[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]);
        assert!(DistanceSearch::new(&square, 1.1e-6).is_ok());
        let message = DistanceSearch::new(&square, 9e-7).unwrap_err().to_string();
        assert!(message.contains("is measured to 1e-6"), "{message}");
    }
}
