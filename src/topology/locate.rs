//! The exact coordinates of points of a swept curve, which are among the critical values of the coordinates.

use super::components::Pieces;
use super::extent::{Axis, CriticalValues};
use super::sweep::Sweep;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::roots::RealRoot;

/// The coordinate of a point of the graph, which is one of the critical values.
pub(super) fn value_at(
    sweep: &mut Sweep,
    (fibre, place): (usize, usize),
    axis: &CriticalValues,
    limits: &Limits,
) -> Result<RealRoot> {
    let mut bits = 0;
    loop {
        limits.check()?;
        let here = &sweep.fibres[fibre];
        let (low, high) = here.value.bounds();
        let point = &here.points[place];
        let [low, high] = axis.range(sweep, [&low, &high], [&point.low, &point.high]);
        if let Some(value) = axis.only_value_in(&low, &high)? {
            return Ok(value);
        }
        bits = if bits == 0 { 32 } else { 2 * bits };
        let Sweep { fibres, curve, .. } = sweep;
        fibres[fibre].value.refine_to_width(-bits);
        fibres[fibre].refine(&curve.strip, bits, limits)?;
    }
}

/// The constant coordinate of a component without points of the graph: a line. It is the value at the inside of its interval.
pub(super) fn value_on_arc(
    sweep: &Sweep,
    (interval, rank): (usize, usize),
    axis: &CriticalValues,
) -> Result<RealRoot> {
    let t = &sweep.insides[interval];
    let mut root = sweep.arcs[interval][rank].clone();
    let mut bits = 32;
    loop {
        let (a, b) = root.bounds();
        let [low, high] = axis.range(sweep, [t, t], [&a, &b]);
        if let Some(value) = axis.only_value_in(&low, &high)? {
            return Ok(value);
        }
        root.refine_to_width(-bits);
        bits *= 2;
    }
}

/// How narrow the bounds of a coordinate are from which about a point is given, relative to its size.
const BITS_ABOUT: i64 = 30;

/// About some points of a component, as [`super::Component::some_points`] tells.
pub(super) fn some_points(sweep: &Sweep, pieces: &Pieces) -> Vec<[f64; 2]> {
    let shear = Rational::from(sweep.curve.shear);
    let place = |t: &Rational, r: &Rational| [(t + &(&shear * r)).to_f64(), r.to_f64()];
    let points = pieces.points.iter().map(|&(fibre, index)| {
        let fibre = &sweep.fibres[fibre];
        place(&fibre.value.bounds().0, &fibre.points[index].low)
    });
    let on_arcs = pieces.arcs.iter().map(|&(interval, rank)| {
        let mut root = sweep.arcs[interval][rank].clone();
        root.refine(BITS_ABOUT);
        place(&sweep.insides[interval], &root.bounds().0)
    });
    points.chain(on_arcs).collect()
}

impl CriticalValues {
    /// Bounds of the coordinate, x = t + shear·R or y = R, from bounds of t and of R.
    fn range(&self, sweep: &Sweep, t: [&Rational; 2], r: [&Rational; 2]) -> [Rational; 2] {
        match self.axis {
            Axis::Y => r.map(Rational::clone),
            Axis::X => {
                let shear = Rational::from(sweep.curve.shear);
                let mut ends = r.map(|r| &shear * r);
                ends.sort_unstable();
                [t[0] + &ends[0], t[1] + &ends[1]]
            }
        }
    }

    /// The critical value in [low, high], if there is only one.
    fn only_value_in(&self, low: &Rational, high: &Rational) -> Result<Option<RealRoot>> {
        let from = self.values.partition_point(|v| v.cmp_rational(low).is_lt());
        let to = self
            .values
            .partition_point(|v| v.cmp_rational(high).is_le());
        match to.checked_sub(from) {
            Some(1) => Ok(Some(self.values[from].clone())),
            Some(0) | None => Err(Error::internal(
                "the critical values of a coordinate",
                "a singular or isolated point has critical coordinates",
            )),
            _ => Ok(None),
        }
    }
}
