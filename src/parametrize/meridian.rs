//! Surfaces on a meridian θ = const, where they are plane curves in the angle φ, and in single directions.

use std::cmp::Ordering;

use malachite::Integer;

use super::angle::{AngleRange, ExactAngle};
use super::closed::{ranges, signs_at};
use super::parametrization::parametrize;
use super::surface::{SurfaceFactor, SurfaceParametrization};
use crate::error::Result;
use crate::limits::Limits;
use crate::poly::{BinaryForm, TernaryForm, integer_sign};
use crate::sample::{Direction, IntegerVector, SpaceDirection};
use crate::shape::ImplicitCurve;

/// The exact ranges of one branch on a meridian, within [0, π].
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct MeridianBranch {
    /// The index of the factor to which the branch belongs.
    pub factor: usize,
    /// The index of the branch among [`SurfaceParametrization::branches`]; `None` for a factor without a closed form, or with one that
    /// does not hold on this meridian: its branches are those of its curve on this meridian.
    pub branch: Option<usize>,
    /// The ranges of φ in which R is real and finite, of either sign.
    pub real: Vec<AngleRange>,
    /// The ranges of φ in which R > 0.
    pub positive: Vec<AngleRange>,
}

/// The certified signs of a surface's formulas in one direction.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct DirectionAnswer {
    /// For each factor the sign of its discriminant, or `None` if it has no discriminant.
    pub discriminants: Vec<Option<i8>>,
    /// For each branch the sign of R, or `None` if the formula has no real value.
    pub branches: Vec<Option<i8>>,
}

impl SurfaceParametrization {
    /// The exact ranges of φ in [0, π] in which the branches are real, for the azimuth of an exact direction `theta`.
    ///
    /// On the meridian each form f_d(sin φ cos θ, sin φ sin θ, cos φ) is a binary form in (cos φ, sin φ). So the problem is the
    /// one of the plane, and Lemmas 2 to 6 give the ranges. Where the first part of a factor vanishes on the whole meridian, its
    /// formulas do not hold there, and the branches are those of its curve on this meridian.
    ///
    /// # Errors
    /// Those of [`parametrize`] for factors without a closed form.
    pub fn on_meridian(&self, theta: &Direction, limits: &Limits) -> Result<Vec<MeridianBranch>> {
        let mut result: Vec<MeridianBranch> = Vec::new();
        let mut next = 0;
        for (index, factor) in self.factors.iter().enumerate() {
            limits.check()?;
            let first = next;
            next += self.branches.iter().filter(|b| b.factor == index).count();
            let vanishes = factor.first_part_vanishes(theta);
            if let Some(found) = factor.closed_ranges(theta).filter(|_| !vanishes) {
                let known = found.into_iter().enumerate();
                result.extend(known.map(|(i, [real, positive])| MeridianBranch {
                    factor: index,
                    branch: Some(first + i),
                    real: upper_half(real),
                    positive: upper_half(positive),
                }));
            } else if !factor.is_cone() {
                let ([a, b], c) = theta.over_common_denominator();
                let section = factor.polynomial.on_meridian(&a, &b, &c);
                if section.degree().is_none_or(|degree| degree == 0) {
                    continue;
                }
                let curve = parametrize(&ImplicitCurve::new(section), limits)?;
                let found = curve.branches.into_iter().map(|b| MeridianBranch {
                    factor: index,
                    branch: None,
                    real: upper_half(b.real),
                    positive: upper_half(b.positive),
                });
                result.extend(found.filter(|b| !b.real.is_empty()));
            }
        }
        Ok(result)
    }

    /// The certified answer in one direction: the branches that are real there, and their signs.
    #[must_use]
    pub fn in_direction(&self, direction: &SpaceDirection) -> DirectionAnswer {
        let (vector, _) = direction.over_common_denominator();
        let discriminants = self.factors.iter().map(|factor| {
            let form = factor.discriminant.as_ref()?;
            Some(integer_sign(&form.evaluate(&vector)))
        });
        let branches = self.factors.iter().flat_map(|f| f.signs_in(direction));
        DirectionAnswer {
            discriminants: discriminants.collect(),
            branches: branches.collect(),
        }
    }
}

impl SurfaceFactor {
    /// Whether the part of the highest degree is 0 on a whole meridian.
    fn first_part_vanishes(&self, theta: &Direction) -> bool {
        let ([a, b], c) = theta.over_common_denominator();
        let first = self.parts.first();
        first.is_some_and(|first| first.on_meridian(&a, &b, &c).is_zero())
    }

    /// The ranges [real, positive] of every branch for φ in the full circle; `None` if there is no closed form.
    fn closed_ranges(&self, theta: &Direction) -> Option<Vec<[Vec<AngleRange>; 2]>> {
        let solved = self.solved.as_ref()?;
        let on_meridian = Meridian::new(theta);
        let rules = solved.roots.iter().map(|(_, rule)| *rule);
        let found = ranges(
            rules,
            &on_meridian.forms(&solved.critical),
            &on_meridian.forms(&self.parts),
            u32::try_from(self.step).ok()?,
        );
        Some(found.into_iter().map(|r| [r.real, r.positive]).collect())
    }

    fn signs_in(&self, direction: &SpaceDirection) -> Vec<Option<i8>> {
        let (Some(solved), Ok(k)) = (&self.solved, u32::try_from(self.step)) else {
            return Vec::new();
        };
        let on_meridian = Meridian::new(direction.theta());
        let ([cos, sin], _) = direction.phi().over_common_denominator();
        signs_at(
            (cos, sin),
            solved.roots.iter().map(|(_, rule)| *rule),
            &on_meridian.forms(&solved.critical),
            &on_meridian.forms(&self.parts),
            k,
        )
    }
}

struct Meridian {
    components: [Integer; 2],
    length: Integer,
}

impl Meridian {
    fn new(theta: &Direction) -> Self {
        let (components, length) = theta.over_common_denominator();
        Self { components, length }
    }

    fn forms(&self, forms: &[TernaryForm]) -> Vec<BinaryForm> {
        let [a, b] = &self.components;
        let forms = forms.iter();
        forms.map(|f| f.on_meridian(a, b, &self.length)).collect()
    }
}

/// The part of ranges of [0, 2π] that lies in [0, π].
fn upper_half(ranges: Vec<AngleRange>) -> Vec<AngleRange> {
    let clipped =
        ranges
            .into_iter()
            .filter_map(|mut range| match (range.from.cmp_pi(), range.to.cmp_pi()) {
                (Ordering::Greater, _) => None,
                (Ordering::Equal, _) => range.closed[0].then(|| AngleRange::point(range.from)),
                (Ordering::Less, Ordering::Greater) => {
                    range.to = ExactAngle::pi();
                    range.closed[1] = true;
                    Some(range)
                }
                (Ordering::Less, _) => Some(range),
            });
    clipped.collect()
}
