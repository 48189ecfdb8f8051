//! Isolated points of elliptic Fourier series: the points of z = e^(it) off the unit circle at which both coordinates are real.
//!
//! A coordinate is real at z if it has the same value at z and at 1/z̄, the two conjugate parameters. All such z outside the circle
//! are found and proved in doubles ([`search`]); their points are computed to hundreds of bits ([`point`]). What is not general
//! enough for that is left to the search by resultants ([`isolated`](super::isolated)), which decides every case.

mod expansion;
#[cfg(test)]
mod laws;
mod point;
mod search;

use expansion::Wave;
use point::{EnclosedLists, Lists, Point, point};
use search::Search;

use super::isolated_point::{Isolated, IsolatedPoint, SHORT_BITS};
use super::reached::is_reached;
use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::parallel;
use crate::poly::{IntegerPolynomial, RationalFunction, polynomial_gcd, squarefree_decomposition};
use crate::shape::EllipticSeries;

/// The coordinates of a series in other units: x = s₀ x′ and y = s₁ y′ + λ x, where the leading waves of x′ and y′ are not
/// proportional.
struct Frame {
    lists: Lists,
    scales: [Rational; 2],
    shear: Rational,
}

impl Frame {
    /// The frame; `None` if a coordinate is constant.
    fn of(series: &EllipticSeries) -> Option<Self> {
        let lists = [
            [series.x_cos(), series.x_sin()],
            [series.y_cos(), series.y_sin()],
        ];
        let mut lists: Lists = lists.map(|both| trimmed(both.map(<[Rational]>::to_vec)));
        let mut shear = Rational::zero();
        let [[a, b], [c, d]] = &lists;
        if a.len() == c.len()
            && let ([.., a], [.., b], [.., c], [.., d]) =
                (a.as_slice(), b.as_slice(), c.as_slice(), d.as_slice())
            && (a * d - b * c).is_zero()
        {
            shear = if a.is_zero() { d / b } else { c / a };
            let [x, y] = &mut lists;
            for (from, to) in x.iter().zip(y.iter_mut()) {
                for (from, to) in from.iter().zip(to) {
                    *to = &*to - &(from * &shear);
                }
            }
            *y = trimmed(std::mem::take(y));
        }
        let mut scales = [Rational::zero(), Rational::zero()];
        for (both, scale) in lists.iter_mut().zip(&mut scales) {
            let sizes = both.iter().flat_map(|list| &list[1..]).map(Rational::abs);
            let largest = sizes.max()?;
            for c in both.iter_mut().flatten() {
                *c = &*c / &largest;
            }
            *scale = largest;
        }
        Some(Self {
            lists,
            scales,
            shear,
        })
    }

    /// Bounds of x and y from those of x′ and y′.
    fn back(&self, [x, y]: [[Rational; 2]; 2]) -> [[Rational; 2]; 2] {
        let x = x.map(|bound| bound * &self.scales[0]);
        let mut shift = x.each_ref().map(|bound| bound * &self.shear);
        shift.sort_unstable();
        let [low, high] = y.map(|bound| bound * &self.scales[1]);
        let y = [low + &shift[0], high + &shift[1]];
        [x, y]
    }
}

/// The two lists without waves of zeros at the end.
fn trimmed([mut cos, mut sin]: [Vec<Rational>; 2]) -> [Vec<Rational>; 2] {
    while let ([_, .., a], [_, .., b]) = (cos.as_slice(), sin.as_slice())
        && a.is_zero()
        && b.is_zero()
    {
        cos.pop();
        sin.pop();
    }
    [cos, sin]
}

/// All isolated points of a series that is traced once; `None` if they are not found in this way.
///
/// - The search proves that there are no other z outside the circle.
/// - Each point is proved to be away from the real curve; if it is rational, exactly.
/// - A point is rational if the short fraction in its bounds is proved to be a point of conjugate parameters alone, as many as
///   there are zeros with this fraction in their bounds.
///
/// # Errors
/// Those of `limits`.
pub(super) fn isolated_of_series(
    series: &EllipticSeries,
    coordinates: [&RationalFunction; 2],
    limits: &Limits,
) -> Result<Option<Isolated>> {
    let Some(frame) = Frame::of(series) else {
        return Ok(None);
    };
    let waves = frame.lists.each_ref().map(|[cos, sin]| Wave::new(cos, sin));
    let search = Search::new(waves);
    let Some(zeros) = search.zeros(limits)? else {
        return Ok(None);
    };
    let arcs = search.arcs();
    let lists = EnclosedLists::new(&frame.lists);
    let found = parallel::try_map(&zeros, limits, |zero| {
        let is_off = search.is_off_the_curve(&arcs, zero);
        Ok(point(&lists, zero).map(|point| (point, is_off)))
    })?;
    let Some(mut found) = found.into_iter().collect::<Option<Vec<_>>>() else {
        return Ok(None);
    };
    for (point, _) in &mut found {
        point.bounds = frame.back(std::mem::take(&mut point.bounds));
    }
    // They are listed by the real part of tan(t/2).
    let place = |point: &Point| point.z.im / (point.z + 1.0).norm_sqr();
    found.sort_by(|(a, _), (b, _)| place(a).total_cmp(&place(b)));
    Ok(points(coordinates, &found).map(|points| Isolated {
        points,
        complete: true,
    }))
}

/// The points that are isolated, without repetitions; `None` if something is not decided.
fn points(
    coordinates: [&RationalFunction; 2],
    found: &[(Point, bool)],
) -> Option<Vec<IsolatedPoint>> {
    let mut points = Vec::new();
    for (k, (point, is_off)) in found.iter().enumerate() {
        let is_alone = || {
            let others = found.iter();
            others
                .filter(|(other, _)| meet(&point.bounds, &other.bounds))
                .count()
                == 1
        };
        match rational_point(coordinates, &point.bounds) {
            // It is the point of all zeros whose bounds hold it, and is listed with the first of them.
            Some((exact, pairs)) => {
                let holding =
                    (0..found.len()).filter(|&other| holds(&found[other].0.bounds, &exact));
                let holding: Vec<usize> = holding.collect();
                if holding.len() != pairs {
                    return None;
                }
                if holding.first() == Some(&k) && !is_reached(coordinates, &exact) {
                    points.push(IsolatedPoint::Exact(exact.to_vec()));
                }
            }
            None if *is_off && is_alone() => {
                let near = |[low, high]: &[Rational; 2]| {
                    let may_be_zero = low.signum() <= 0 && high.signum() >= 0;
                    if may_be_zero {
                        0.0
                    } else {
                        ((low + high) / Rational::from(2)).to_f64()
                    }
                };
                let middle = point.bounds.each_ref().map(near);
                points.push(IsolatedPoint::Near(middle.to_vec()));
            }
            None => return None,
        }
    }
    Some(points)
}

fn holds(bounds: &[[Rational; 2]; 2], point: &[Rational; 2]) -> bool {
    let mut both = bounds.iter().zip(point);
    both.all(|([low, high], value)| low <= value && value <= high)
}

fn meet(a: &[[Rational; 2]; 2], b: &[[Rational; 2]; 2]) -> bool {
    let mut both = a.iter().zip(b);
    both.all(|([low, high], [other_low, other_high])| low <= other_high && other_low <= high)
}

/// The short fractions in the bounds, if they are a point of the curve, and the number of pairs of conjugate parameters that have
/// this point.
fn rational_point(
    coordinates: [&RationalFunction; 2],
    bounds: &[[Rational; 2]; 2],
) -> Option<([Rational; 2], usize)> {
    let exact = bounds
        .each_ref()
        .map(|[low, high]| Rational::simplest_between(low, high));
    if exact.iter().any(|q| q.bits() > SHORT_BITS) {
        return None;
    }
    let [f, g] = [0, 1].map(|k| coordinates[k].plus_constant(&-exact[k].clone()));
    let common = polynomial_gcd(f.numerator(), g.numerator());
    let distinct: usize = squarefree_decomposition(&common)
        .iter()
        .map(|(_, part)| degree(part))
        .sum();
    let complex = distinct - crate::roots::real_roots(&common).len();
    (complex > 0).then_some((exact, complex / 2))
}

fn degree(f: &IntegerPolynomial) -> usize {
    f.coefficients_asc().len().saturating_sub(1)
}
