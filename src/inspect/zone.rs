//! The tolerance zone of an inspection: the limits of the signed distance, and the uncertainty of the measured points.

use std::fmt;
use std::str::FromStr;

use super::{DistanceBounds, Verdict};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::intervals::Interval;

/// The limits LOW ≤ 0 ≤ HIGH of the signed distance of a point from a form, and the uncertainty U of the point.
///
/// With one tolerance D the limits are −D and D, so that a point is inside if its distance is at most D; that needs no sides of
/// the form. With two different limits a point is inside if LOW ≤ s ≤ HIGH for its signed distance s, which is negative inside
/// the form and positive outside.
///
/// With an uncertainty U > 0 (the guard bands of ISO 14253-1) the true point is somewhere within U of the measured one. The point
/// is inside if LOW + U ≤ s ≤ HIGH − U, outside if s < LOW − U or s > HIGH + U, and otherwise uncertain. This is right for every
/// true point, also if the ball of radius U about the measured one reaches across the form, because the signed distance changes
/// by at most |p − q| from p to q: on one side of the form it is ± the distance, which has this property; and if p and q are on
/// different sides, the segment between them meets the form, so that the sum of their distances is at most |p − q|.
///
/// If U is larger than the limit of a side, the inner zone LOW + U … HIGH − U begins on the other side of the form. That end of
/// it does not belong to it: a point exactly there is uncertain.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ToleranceZone {
    low: Rational,
    high: Rational,
    uncertainty: Rational,
    /// Whether the limits are −D and D.
    is_single: bool,
}

/// What is asked of the distance d of a point on one side of a form.
#[derive(Clone, Debug)]
struct SideOfZone {
    /// The point is inside only if d is larger than this.
    more_than: Option<Rational>,
    /// The point is inside only if d is at most this; less than 0 if no point is inside.
    at_most: Rational,
    /// The point is outside if d is larger than this.
    outer: Rational,
}

/// What was decided about the distance of a point: that it is at most a number, or more than it.
#[derive(Clone, Debug)]
pub(crate) struct DecidedDistance {
    pub(crate) distance: Rational,
    pub(crate) is_within: bool,
}

impl ToleranceZone {
    /// The zone between two limits.
    ///
    /// ```
    /// use stellate::inspect::ToleranceZone;
    /// let zone = ToleranceZone::new("-1/50".parse()?, "1/20".parse()?)?;
    /// assert_eq!(zone.to_string(), "-1/50 to 1/20");
    /// assert_eq!(zone, "-0.02,0.05".parse()?);
    /// assert!(ToleranceZone::new("1/50".parse()?, "1/20".parse()?).is_err());
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] unless LOW ≤ 0 ≤ HIGH and LOW < HIGH.
    pub fn new(low: Rational, high: Rational) -> Result<Self> {
        if low.signum() > 0 || high.signum() < 0 || low == high {
            return Err(Error::Usage(format!(
                "the limits {low} and {high}: expected LOW ≤ 0 ≤ HIGH, not both 0, such as -0.02,0.05"
            )));
        }
        Ok(Self {
            is_single: low == -high.clone(),
            low,
            high,
            uncertainty: Rational::zero(),
        })
    }

    /// The zone of the distances up to a tolerance.
    ///
    /// # Errors
    /// [`Error::Usage`] for a tolerance that is not positive.
    pub fn within(tolerance: Rational) -> Result<Self> {
        if tolerance.signum() <= 0 {
            return Err(Error::Usage(format!(
                "the tolerance {tolerance}: expected a positive number, such as 0.1"
            )));
        }
        Self::new(-tolerance.clone(), tolerance)
    }

    /// The zone for points that are known up to an uncertainty.
    ///
    /// # Errors
    /// [`Error::Usage`] for an uncertainty less than 0.
    pub fn with_uncertainty(self, uncertainty: Rational) -> Result<Self> {
        match uncertainty.signum() {
            -1 => Err(Error::Usage(format!(
                "the uncertainty {uncertainty}: expected a positive number, such as 0.01"
            ))),
            _ => Ok(Self {
                uncertainty,
                ..self
            }),
        }
    }

    /// The limits LOW and HIGH.
    #[must_use]
    pub fn limits(&self) -> [&Rational; 2] {
        [&self.low, &self.high]
    }

    /// The uncertainty of the points, at least 0.
    #[must_use]
    pub fn uncertainty(&self) -> &Rational {
        &self.uncertainty
    }

    /// Whether the points have an uncertainty.
    #[must_use]
    pub fn is_uncertain(&self) -> bool {
        self.uncertainty.signum() > 0
    }

    /// The tolerance D, if the limits are −D and D.
    #[must_use]
    pub fn tolerance(&self) -> Option<&Rational> {
        self.is_single.then_some(&self.high)
    }

    /// The tolerance of the side of a point with this sign: −LOW inside, HIGH outside. On the form, and where the side is not known,
    /// it is HIGH unless that is 0.
    #[must_use]
    pub fn tolerance_of_side(&self, sign: Option<i8>) -> Rational {
        match sign {
            Some(-1) => -self.low.clone(),
            Some(1) => self.high.clone(),
            _ if self.high.is_zero() => -self.low.clone(),
            _ => self.high.clone(),
        }
    }

    /// The width of the inner zone LOW + U … HIGH − U. If it is less than 0, no point is inside; if it is 0, at most a point exactly in the
    /// middle.
    #[must_use]
    pub fn inner_width(&self) -> Rational {
        let twice = &self.uncertainty + &self.uncertainty;
        &self.high - &self.low - twice
    }

    fn side(&self, sign: i8) -> SideOfZone {
        let (own, other) = match sign {
            -1 => (-self.low.clone(), self.high.clone()),
            _ => (self.high.clone(), -self.low.clone()),
        };
        let beyond = &self.uncertainty - &other;
        SideOfZone {
            // A single tolerance is taken up by an uncertainty that large: its inner zone has no other end.
            more_than: (beyond.signum() > 0 && self.tolerance().is_none()).then_some(beyond),
            at_most: &own - &self.uncertainty,
            outer: own + &self.uncertainty,
        }
    }

    /// All distances d > 0 for which a verdict or the criterion of Theorem 8 may depend on d. The first is the tolerance of a point
    /// on the form.
    pub(crate) fn levels(&self) -> Vec<Rational> {
        let mut levels = vec![self.tolerance_of_side(None)];
        for sign in [1, -1] {
            let side = self.side(sign);
            let own = self.tolerance_of_side(Some(sign));
            levels.extend([own, side.at_most, side.outer]);
            levels.extend(side.more_than);
        }
        let mut seen: Vec<Rational> = Vec::new();
        for level in levels {
            if level.signum() > 0 && !seen.contains(&level) {
                seen.push(level);
            }
        }
        seen
    }

    /// The verdict for a point with this sign. `within` says whether the distance is at most a number greater than 0, and `None` if
    /// that is undecided; `is_on` whether the point lies on the form.
    ///
    /// If the sign is not known, the verdict is the one of both sides if they agree.
    pub(crate) fn judge(
        &self,
        sign: Option<i8>,
        is_on: Option<bool>,
        within: &mut dyn FnMut(&Rational) -> Option<bool>,
    ) -> Verdict {
        let mut of_side = |sign: i8| {
            self.side(sign).judge(&mut |d| match d.signum() {
                -1 => Some(false),
                0 => is_on,
                _ => within(d),
            })
        };
        match sign {
            Some(sign) => of_side(sign),
            None if self.tolerance().is_some() => of_side(1),
            None => match of_side(1) {
                Verdict::Undecided => Verdict::Undecided,
                verdict if of_side(-1) == verdict => verdict,
                _ => Verdict::Undecided,
            },
        }
    }
}

impl SideOfZone {
    fn judge(&self, within: &mut dyn FnMut(&Rational) -> Option<bool>) -> Verdict {
        let inner = within(&self.at_most);
        if inner == Some(true) {
            return match self.more_than.as_ref().map_or(Some(false), within) {
                Some(false) => Verdict::Inside,
                // The distance is at most the larger number, too.
                Some(true) => Verdict::Uncertain,
                None => Verdict::Undecided,
            };
        }
        if self.outer == self.at_most {
            return match inner {
                Some(_) => Verdict::Outside,
                None => Verdict::Undecided,
            };
        }
        match (within(&self.outer), inner) {
            (Some(false), _) => Verdict::Outside,
            (Some(true), Some(_)) => Verdict::Uncertain,
            _ => Verdict::Undecided,
        }
    }
}

impl fmt::Display for ToleranceZone {
    /// Writes the tolerance, or both limits as in `-1/50 to 1/20`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.tolerance() {
            Some(tolerance) => write!(f, "{tolerance}"),
            None => write!(f, "{} to {}", self.low, self.high),
        }
    }
}

impl FromStr for ToleranceZone {
    type Err = Error;

    /// Reads a tolerance such as `0.1`, or two limits such as `-0.02,0.05`.
    fn from_str(text: &str) -> Result<Self> {
        match text.split_once([',', ';']) {
            Some((low, high)) => Self::new(low.trim().parse()?, high.trim().parse()?),
            None => Self::within(text.parse()?),
        }
    }
}

/// Whether a distance between these bounds is at most d, if that follows from them; d is in the interval `around`.
pub(crate) fn is_within(bounds: &DistanceBounds, around: Interval) -> Option<bool> {
    if bounds.high <= around.low() {
        Some(true)
    } else if bounds.low > around.high() {
        Some(false)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn zone(low: i64, high: i64, uncertainty: i64) -> ToleranceZone {
        let zone = ToleranceZone::new(low.into(), high.into()).unwrap();
        zone.with_uncertainty(uncertainty.into()).unwrap()
    }

    /// The verdict for a signed distance s.
    fn of(zone: &ToleranceZone, s: &Rational) -> Verdict {
        let d = s.abs();
        zone.judge(Some(s.signum()), Some(s.is_zero()), &mut |t| {
            assert!(t.signum() > 0);
            Some(d <= *t)
        })
    }

    #[test]
    fn limits_are_read_and_wrong_ones_are_refused() {
        let read = |text: &str| text.parse::<ToleranceZone>();
        assert_eq!(read("0.1").unwrap(), read("-0.1, 0.1").unwrap());
        assert_eq!(read("0;1").unwrap().limits(), [&0.into(), &1.into()]);
        assert_eq!(
            read("-1/2,0").unwrap().tolerance_of_side(None),
            "1/2".parse().unwrap()
        );
        for wrong in [
            "0", "-1", "0.1,0.2", "-2,-1", "0,0", "0.2,-0.1", "1,2,3", "a",
        ] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
        let wrong = ToleranceZone::new("1/10".parse().unwrap(), "1/5".parse().unwrap());
        assert!(wrong.unwrap_err().to_string().contains("LOW ≤ 0 ≤ HIGH"));
    }

    #[test]
    fn an_uncertainty_that_takes_up_the_zone_leaves_nothing_inside() {
        let width = |low, high, u| zone(low, high, u).inner_width();
        assert_eq!(
            [width(-2, 2, 3), width(-2, 2, 2), width(0, 4, 1)],
            [-2, 0, 2].map(Rational::from)
        );
        // The middle of what is left is the form itself.
        assert_eq!(of(&zone(-2, 2, 2), &0.into()), Verdict::Inside);
        assert_eq!(of(&zone(-2, 2, 2), &1.into()), Verdict::Uncertain);
        assert_eq!(of(&zone(-2, 2, 3), &0.into()), Verdict::Uncertain);
    }

    #[test]
    fn what_one_side_leaves_open_is_undecided() {
        let zone = zone(-1, 3, 0);
        let at = |d: i64| zone.judge(None, Some(false), &mut |t| Some(Rational::from(d) <= *t));
        assert_eq!(
            [at(1), at(2), at(4)],
            [Verdict::Inside, Verdict::Undecided, Verdict::Outside]
        );
        assert_eq!(
            zone.judge(Some(-1), Some(false), &mut |_| None),
            Verdict::Undecided
        );
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

        /// The verdict is the one of the definition, for signed distances at and beside all ends; and with the true signed distance
        /// anywhere within the uncertainty, `inside` and `outside` are right.
        #[test]
        fn verdicts_are_those_of_the_definition(low in 0i64..5, high in 0i64..5, u in 0i64..7, twice in -26i64..27) {
            prop_assume!(low + high > 0);
            let zone = zone(-low, high, u);
            let s = Rational::from(twice) / Rational::from(2);
            let found = of(&zone, &s);
            let [low, high, u] = [-low, high, u].map(Rational::from);
            let is_in = |s: &Rational| low <= *s && *s <= high;
            let (least, most) = (&s - &u, &s + &u);
            // An end of the inner zone on the other side of the form is left out.
            let (first, last) = (&low + &u, &high - &u);
            let is_left_out = zone.tolerance().is_none() && (s == first && first.signum() > 0 || s == last && last.signum() < 0);
            let expected = if is_in(&least) && is_in(&most) && !is_left_out {
                Verdict::Inside
            } else if most < low || least > high {
                Verdict::Outside
            } else if u.is_zero() {
                // Without an uncertainty nothing is in between.
                unreachable!("{s} of {low} to {high}")
            } else {
                Verdict::Uncertain
            };
            prop_assert_eq!(found, expected);
            prop_assert!(zone.levels().iter().all(|d| d.signum() > 0));
        }
    }
}
