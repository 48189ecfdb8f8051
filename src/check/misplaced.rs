//! Usual mistakes that displace all points of a float program: a forgotten center, another scale, degrees for radians.

use super::GivenPoint;
use super::comparison::Comparison;
use super::mistakes::Mistaken;
use super::reference::Reference;
use crate::exact::Rational;
use crate::shape::FourierRadius;

/// The number of points whose distances propose a common factor.
const PROPOSALS: usize = 5;
/// Ratios are nearly a factor if they differ from it by this share of its difference from 1.
const NEARLY: f64 = 0.01;

impl Reference {
    /// For each mistake, the points as they would be without it. `found` are the comparisons of these points, in the same
    /// order.
    pub(super) fn misplaced(
        &self,
        found: &Comparison,
        points: &[GivenPoint],
    ) -> Vec<Mistaken<Vec<GivenPoint>>> {
        let center = self.center_in_space().each_ref().map(Rational::to_f64);
        let moved = |sign: f64| mapped(points, |p| [0, 1, 2].map(|i| p[i] + sign * center[i]));
        let mut all = Vec::new();
        if center.iter().any(|c| *c != 0.0) {
            all.push(Mistaken {
                name: "center forgotten".into(),
                explanation: "the points are in the original coordinates; they are compared relative to the center".into(),
                form: moved(-1.0),
            });
            all.push(Mistaken {
                name: "center forgotten".into(),
                explanation: "the center was taken away from points that are relative to it".into(),
                form: moved(1.0),
            });
        }
        all.extend(factors(found).map(|factor| Mistaken {
            name: "scale".into(),
            explanation: format!(
                "all points are {factor} times as far from the center as they should be: a unit of length, or a factor of the radius"
            )
            .into(),
            form: mapped(points, |point| point.map(|v| v / factor)),
        }));
        all.extend(self.radius().map(|radius| Mistaken {
            name: "degrees for radians".into(),
            explanation:
                "the radius was taken at the angle in degrees, where radians are meant".into(),
            form: mapped(points, |point| out_of_degrees(radius, point)),
        }));
        // What leads to no point, or beyond the doubles, is not the mistake.
        all.retain(|mistake| {
            let mut coordinates = mistake.form.iter().flat_map(|point| point.position);
            coordinates.all(f64::is_finite)
        });
        all
    }
}

fn mapped(points: &[GivenPoint], f: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<GivenPoint> {
    let points = points.iter().map(|point| GivenPoint {
        position: f(point.position),
        ..*point
    });
    points.collect()
}

/// The factors that are tried: the ratios of given and exact distances of the first points, if at least half of all points have
/// nearly that ratio, and the ratios of units of length that are confused most often.
fn factors(found: &Comparison) -> impl Iterator<Item = f64> {
    let ratios: Vec<f64> = found
        .rows
        .iter()
        .filter_map(|row| Some(row.got / row.exact.as_ref()?.to_f64()))
        .collect();
    let is_shared = |factor: f64| {
        let near = ratios
            .iter()
            .filter(|ratio| (*ratio - factor).abs() <= NEARLY * (factor - 1.0).abs());
        2 * near.count() >= ratios.len()
    };
    let mut proposed: Vec<f64> = ratios
        .iter()
        // The ratio is rounded to twelve digits, because a ratio of units has few digits.
        .filter_map(|ratio| format!("{ratio:.11e}").parse().ok())
        .filter(|short: &f64| short.is_finite() && *short > 0.0)
        .filter(|short| (short - 1.0).abs() > f64::EPSILON && is_shared(*short))
        .take(PROPOSALS)
        .collect();
    proposed.sort_unstable_by(f64::total_cmp);
    proposed.dedup();
    let units = [10.0, 100.0, 1000.0, 25.4, 2.54];
    let both = units.into_iter().flat_map(|unit| [unit, 1.0 / unit]);
    let others: Vec<f64> = both.filter(|unit| !proposed.contains(unit)).collect();
    proposed.into_iter().chain(others)
}

/// Undoes the mistake for a point whose radius was computed as r(180 α/π) instead of r(α), where α is its angle.
fn out_of_degrees(radius: &FourierRadius, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let angle = y.atan2(x);
    let turned = radius.approximate(angle.to_degrees());
    let factor = radius.approximate(angle) / turned;
    [x * factor, y * factor, z]
}
