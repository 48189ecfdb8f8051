//! The points of a curve above one critical value, and the arcs that come to each of them from both sides.
//!
//! Below, α is the critical value, and P(t, R) has a constant leading coefficient in R, so no root tends to infinity. The
//! *window* is an interval that holds α and no other critical value. *Separators* are numbers between neighbouring real roots of
//! P(α, ·) with P(t, separator) ≠ 0 for all t in the window. So an arc over the window stays between two separators, and tends to
//! the one real root of P(α, ·) that is between them. All arcs between two separators therefore end at that point, whatever the
//! kind of the point is.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::ShrRound;
use malachite::base::num::basic::traits::Zero;
use malachite::base::rounding_modes::RoundingMode;

use super::clusters::{Enclosed, PRECISIONS, RealCluster, real_clusters, too_near};
use super::strip::Strip;
use crate::error::{Error, Invariant, Result};
use crate::exact::{Dyadic, Rational};
use crate::limits::Limits;
use crate::poly::IntegerPolynomial;
use crate::roots::{RealRoot, disjoint, real_roots, strictly_between};

/// A real point of the curve above a critical value.
#[derive(Clone, Debug)]
pub(crate) struct FibrePoint {
    /// An interval that holds R and no other real root above the same value.
    pub(crate) low: Rational,
    pub(crate) high: Rational,
    /// The multiplicity of R as a root of P(α, ·).
    pub(crate) multiplicity: usize,
    /// The numbers of arcs that end here from below α and from above α.
    pub(crate) arcs: [usize; 2],
}

/// The real points above a critical value, ascending in R.
#[derive(Clone, Debug)]
pub(crate) struct Fibre {
    /// The critical value.
    pub(crate) value: RealRoot,
    /// The points.
    pub(crate) points: Vec<FibrePoint>,
    /// The number of distinct complex roots of P(α, ·).
    distinct: usize,
}

impl Fibre {
    /// The points above α. The enclosure of α holds no other critical value, and there is none within `room` of α. `distinct` is
    /// the number of distinct complex roots of P(α, ·).
    pub(super) fn new(
        strip: &Strip,
        alpha: &RealRoot,
        room: &Rational,
        distinct: usize,
        limits: &Limits,
    ) -> Result<Self> {
        let mut fibre = Self {
            value: alpha.clone(),
            points: Vec::new(),
            distinct,
        };
        fibre.refine(strip, 0, limits)?;
        fibre.count_arcs(strip, room, limits)?;
        Ok(fibre)
    }

    /// Narrows the enclosures of the points until they are at most 2^−bits wide.
    pub(super) fn refine(&mut self, strip: &Strip, bits: i64, limits: &Limits) -> Result<()> {
        let places = match self.value.as_rational() {
            Some(alpha) => exact_points(&strip.along(&alpha), bits),
            None => enclosed_points(strip, &mut self.value, self.distinct, bits, limits)?,
        };
        let old: Vec<[usize; 2]> = self.points.iter().map(|point| point.arcs).collect();
        let places = places.into_iter().enumerate();
        self.points = places
            .map(|(index, (low, high, multiplicity))| FibrePoint {
                low: low.to_rational(),
                high: high.to_rational(),
                multiplicity,
                arcs: old.get(index).copied().unwrap_or([0, 0]),
            })
            .collect();
        Ok(())
    }

    /// The separators between the points.
    fn separators(&self) -> Vec<Rational> {
        self.points
            .windows(2)
            .map(|pair| strictly_between(&pair[0].high, &pair[1].low))
            .collect()
    }

    fn count_arcs(&mut self, strip: &Strip, room: &Rational, limits: &Limits) -> Result<()> {
        let separators = self.separators();
        let rows: Vec<IntegerPolynomial> = separators.iter().map(|r| strip.across(r)).collect();
        let free = |low: &Rational, high: &Rational| {
            rows.iter()
                .all(|row| crate::roots::constant_sign(row, low, high).is_some())
        };
        let window = match self.value.as_rational() {
            Some(alpha) => {
                let mut width = room.clone();
                let quarter = Rational::one() / Rational::from(4);
                loop {
                    limits.check()?;
                    width = width * &quarter;
                    let (low, high) = (&alpha - &width, &alpha + &width);
                    if free(&low, &high) {
                        break (low, high);
                    }
                }
            }
            None => loop {
                limits.check()?;
                let (low, high) = self.value.enclosure();
                let (low, high) = (low.to_rational(), high.to_rational());
                if free(&low, &high) {
                    break (low, high);
                }
                narrow(&mut self.value, 8);
            },
        };
        for (side, t) in [window.0, window.1].iter().enumerate() {
            for root in real_roots(&strip.along(t)) {
                let place = separators.partition_point(|s| root.cmp_rational(s).is_gt());
                let point = self.points.get_mut(place);
                point.invariant("an arc ends at a point").arcs[side] += 1;
            }
        }
        for point in &self.points {
            for count in point.arcs {
                if count % 2 != point.multiplicity % 2 || count > point.multiplicity {
                    return Err(Error::internal(
                        "the points above a critical value",
                        format!(
                            "{count} arcs end at a root of multiplicity {}",
                            point.multiplicity
                        ),
                    ));
                }
            }
        }
        Ok(())
    }
}

/// Narrows the enclosure of an irrational root to 2^−bits of its width.
pub(super) fn narrow(root: &mut RealRoot, bits: i64) {
    let (low, high) = root.enclosure();
    if let Some(width) = high.minus(low).log2() {
        root.refine_to_width(width - bits);
    }
}

/// The distinct real roots with their multiplicities, in disjoint intervals.
fn exact_points(g: &IntegerPolynomial, bits: i64) -> Vec<(Dyadic, Dyadic, usize)> {
    let mut roots = real_roots(g);
    for root in &mut roots {
        root.refine_to_width(-bits);
    }
    let place = |root: &RealRoot| {
        let (low, high) = root.enclosure();
        (low.clone(), high.clone(), root.multiplicity())
    };
    disjoint(roots).iter().map(place).collect()
}

fn enclosed_points(
    strip: &Strip,
    alpha: &mut RealRoot,
    distinct: usize,
    bits: i64,
    limits: &Limits,
) -> Result<Vec<(Dyadic, Dyadic, usize)>> {
    // If 0 is a root, its multiplicity is that of exact zeros: bounds of coefficients that are 0 would give no scale to the others.
    let coefficients = strip.coefficients();
    let at_zero = coefficients
        .iter()
        .take_while(|a| alpha.is_root_of(a))
        .count();
    let zero = (at_zero > 0).then(|| (Dyadic::zero(), Dyadic::zero(), at_zero));
    let others = &coefficients[at_zero..];
    if others.len() == 1 {
        return Ok(zero.into_iter().collect());
    }
    let distinct = distinct - usize::from(zero.is_some());
    for precision in PRECISIONS {
        limits.check()?;
        let digits = 2 * precision.cast_signed();
        alpha.refine_to_width(-digits);
        let polynomial = enclosed(others, alpha, digits.unsigned_abs());
        let Some(found) = real_clusters(&polynomial, distinct, bits, precision) else {
            continue;
        };
        let place = |c: RealCluster| (c.low, c.high, c.multiplicity);
        let mut points: Vec<_> = found.into_iter().map(place).collect();
        if let Some(zero) = &zero {
            let is_apart =
                |(low, high, _): &(Dyadic, Dyadic, usize)| low.signum() * high.signum() > 0;
            if !points.iter().all(is_apart) {
                continue;
            }
            let below = points.partition_point(|(_, high, _)| high.signum() < 0);
            points.insert(below, zero.clone());
        }
        return Ok(points);
    }
    Err(too_near(&alpha.to_decimal(6)))
}

/// Bounds of coefficients at α, in units of 2^−digits.
fn enclosed(coefficients: &[IntegerPolynomial], alpha: &RealRoot, digits: u64) -> Enclosed {
    let (low, high) = alpha.enclosure();
    let ends = [
        low.in_units(digits, RoundingMode::Floor),
        high.in_units(digits, RoundingMode::Ceiling),
    ];
    let mut enclosed = Enclosed {
        low: Vec::new(),
        high: Vec::new(),
    };
    for a in coefficients {
        let mut value = [Integer::ZERO, Integer::ZERO];
        for c in a.coefficients_asc().iter().rev() {
            let mut products = [
                &value[0] * &ends[0],
                &value[0] * &ends[1],
                &value[1] * &ends[0],
                &value[1] * &ends[1],
            ];
            products.sort_unstable();
            let [least, .., most] = products;
            let c = c << digits;
            value = [
                least.shr_round(digits, RoundingMode::Floor).0 + &c,
                most.shr_round(digits, RoundingMode::Ceiling).0 + &c,
            ];
        }
        let [low, high] = value;
        enclosed.low.push(low);
        enclosed.high.push(high);
    }
    enclosed
}
