//! The answers for a point against a tolerance zone: the distances that the zone asks about, each by the inspector with that
//! tolerance.

use super::against::Against;
use super::inspect::InspectionTask;
use crate::exact::Rational;
use crate::inspect::{DecidedDistance, DistanceBounds, Inspection, Verdict, is_within};

impl InspectionTask {
    /// The answers for a point, of which `ask` gets those of an inspector. What was decided about the distance is added to `decided`,
    /// if it is asked for.
    ///
    /// The first inspector gives the sign and the bounds of the distance. Where these bounds do not decide another distance that the
    /// zone asks about, its own inspector does.
    pub(super) fn judged(
        &self,
        ask: &dyn Fn(&Against) -> Inspection,
        mut decided: Option<&mut Vec<DecidedDistance>>,
    ) -> Inspection {
        let zone = self.zone();
        let mut found = ask(&self.against);
        let mut decide = |distance: &Rational, is_within: bool| {
            if let Some(decided) = &mut decided {
                decided.push(DecidedDistance {
                    distance: distance.clone(),
                    is_within,
                });
            }
        };
        let of_base = match found.verdict {
            Verdict::Inside => Some(true),
            Verdict::Outside => Some(false),
            Verdict::Uncertain | Verdict::Undecided => None,
        };
        if zone.tolerance().is_some() && !zone.is_uncertain() {
            if let (Some(is_within), Some(tolerance)) = (of_base, zone.tolerance()) {
                decide(tolerance, is_within);
            }
            return found;
        }
        let base = zone.tolerance_of_side(None);
        let sign = found.sign;
        let is_on = match (sign, found.distance) {
            (Some(sign), _) => Some(sign == 0),
            (None, DistanceBounds { high, .. }) if high <= 0.0 => Some(true),
            (None, DistanceBounds { low, .. }) if low > 0.0 => Some(false),
            (None, _) => None,
        };
        // The answers of the other inspectors, each asked at most once.
        let mut answers: Vec<Option<Inspection>> = vec![None; self.levels.len()];
        let mut bounds = found.distance;
        let mut answer_of = |k: usize, bounds: &mut DistanceBounds| {
            let answer = *answers[k].get_or_insert_with(|| ask(&self.levels[k].against));
            bounds.low = bounds.low.max(answer.distance.low);
            bounds.high = bounds.high.min(answer.distance.high);
            bounds.low = bounds.low.min(bounds.high);
            answer
        };
        let verdict = zone.judge(sign, is_on, &mut |distance| {
            let is_within = if *distance == base {
                of_base
            } else {
                let k = self.levels.iter().position(|l| l.distance == *distance)?;
                is_within(&bounds, self.levels[k].around).or_else(|| {
                    match answer_of(k, &mut bounds).verdict {
                        Verdict::Inside => Some(true),
                        Verdict::Outside => Some(false),
                        Verdict::Uncertain | Verdict::Undecided => None,
                    }
                })
            };
            if let Some(is_within) = is_within {
                decide(distance, is_within);
            }
            is_within
        });
        let own = zone.tolerance_of_side(sign);
        let place = self.levels.iter().position(|l| l.distance == own);
        found.curve = match (sign, place) {
            // Which tolerance is that of the point is not known.
            (None, _) if zone.tolerance().is_none() => None,
            _ if own == base => found.curve,
            // The point is strictly on a side whose tolerance is 0.
            (_, None) => Some(false),
            (_, Some(k)) if is_within(&bounds, self.levels[k].around) == Some(false) => Some(false),
            (_, Some(k)) => answer_of(k, &mut bounds).curve,
        };
        found.verdict = verdict;
        found.distance = bounds;
        found
    }
}
