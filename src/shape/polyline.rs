//! Lines of points along a parametric curve, and the box that shows it.

use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Derivative;

use super::ParametricCurve;
use super::curve_values::CurveValues;
use super::drawn::{DRAWN_NUMBERS, Ratio};
use super::parameter::Parameter;
use crate::error::Invariant;
use crate::poly::{IntegerPolynomial, RationalFunction};
use crate::roots::real_roots;

/// For each degree of the coordinates so many points of a full period are drawn: 100 oscillations still look smooth.
const POINTS_PER_DEGREE: u32 = 20;

/// A picture shows no more than this many segments along its diagonal.
const CHORDS: f64 = 150.0;

/// No more points than this are drawn for oscillations, and no more are added between points that are far apart.
const MOST_POINTS: u32 = 40_000;

/// The work for added points: their number times the square of the degree, because their values may have to be exact.
const MOST_WORK: usize = 500_000_000;

/// Between two points no more points are added than by so many halvings in a row.
const MOST_HALVINGS: usize = 64;

/// A range of numbers that is longer than this is drawn at small numbers, too.
const LONG_RANGE: f64 = 1e4;

/// The extrema of coordinates are found up to this degree.
const MOST_DEGREE: usize = 120;

/// The number of points from which the box around a curve is found.
const BOX_POINTS: u32 = 720;

/// The share of the smallest and of the largest values of a coordinate that a picture need not show if there are poles.
const LEFT_OUT: f64 = 0.05;

/// The smallest and the largest value of every coordinate.
pub(super) type Area<const N: usize> = [[f64; 2]; N];

impl<const N: usize> ParametricCurve<N> {
    /// Lines of points along the curve, over the range of the parameter: `count` of them, more where an angle has many oscillations
    /// and where neighbors would be far apart in the box of [`ParametricCurve::extent`]. A line ends at a pole.
    ///
    /// Without a range the lines cover a full period of an angle, or all numbers.
    #[must_use]
    pub fn polylines(&self, range: Option<[f64; 2]>, count: u32) -> Vec<Vec<[f64; N]>> {
        self.polylines_in(None, range, count)
    }

    /// As [`ParametricCurve::polylines`], with more points in this area instead of the box.
    pub(crate) fn polylines_in(
        &self,
        area: Option<Area<N>>,
        range: Option<[f64; 2]>,
        count: u32,
    ) -> Vec<Vec<[f64; N]>> {
        let drawing = DrawnCurve::new(self, range);
        let mut more = drawing.turns.clone();
        if let (false, Some([low, high])) = (drawing.parameter.is_angle(), range) {
            // Halving a very long range would not come near to small numbers.
            let everywhere = drawing.parameter.values(None, count.max(1)).into_iter();
            more.extend(everywhere.filter(|t| high - low > LONG_RANGE && low <= *t && *t <= high));
        }
        let mut all = drawing.sampled(range, count, &more);
        if let Some(area) = area.or_else(|| drawing.extent(range)) {
            all = drawing.denser(all, &area);
        }
        drawing.cut_at_poles(all)
    }

    /// A box that shows the curve. If the curve is bounded, the box holds all of it; if not, the box holds most of its points
    /// for parameters in the range, or between −3/2 and 3/2. `None` if no point is finite.
    #[must_use]
    pub fn extent(&self, range: Option<[f64; 2]>) -> Option<[[f64; 2]; N]> {
        DrawnCurve::new(self, range).extent(range)
    }

    /// Whether no coordinate has a real pole or a pole at infinity; this is decided exactly.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        self.coordinates()
            .iter()
            .all(|f| !has_pole_at_infinity(f) && real_roots(f.denominator()).is_empty())
    }
}

/// A curve with what its pictures need.
struct DrawnCurve<'a, const N: usize> {
    parameter: &'a Parameter,
    values: CurveValues<N>,
    /// The degree of the coordinates.
    degree: usize,
    is_bounded: bool,
    /// The values of s at the poles of each coordinate.
    poles: [Vec<Ratio>; N],
    /// The values of a number, in the range, at which a coordinate has an extremum. Between them all coordinates are monotone, so that
    /// no part of the curve is outside the box of two neighbors. There are none for an angle, nor beyond some degree.
    turns: Vec<f64>,
}

/// A drawn point: the value of the parameter, the coordinates, and the signs of the denominators.
#[derive(Clone, Copy)]
struct Drawn<const N: usize> {
    parameter: f64,
    point: [f64; N],
    signs: [bool; N],
}

impl<'a, const N: usize> DrawnCurve<'a, N> {
    fn new(curve: &'a ParametricCurve<N>, range: Option<[f64; 2]>) -> Self {
        let degrees = curve.coordinates().iter().map(RationalFunction::degree);
        let degree = degrees.max().invariant("a curve has coordinates");
        let has_turns = !curve.parameter().is_angle() && degree <= MOST_DEGREE;
        Self {
            parameter: curve.parameter(),
            values: CurveValues::of(curve),
            degree,
            is_bounded: curve.is_bounded(),
            poles: curve.coordinates().each_ref().map(poles),
            turns: if has_turns {
                turns(curve.coordinates(), range)
            } else {
                Vec::new()
            },
        }
    }

    fn extent(&self, range: Option<[f64; 2]>) -> Option<Area<N>> {
        let range = if self.parameter.is_angle() || self.is_bounded {
            range
        } else {
            range.or(Some(DRAWN_NUMBERS))
        };
        // All of a bounded curve is between its extrema. Of another one, more points where it is far away would make the box larger.
        let more = if self.is_bounded {
            &self.turns[..]
        } else {
            &[]
        };
        let lines = self.cut_at_poles(self.sampled(range, BOX_POINTS, more));
        // Near its poles a coordinate goes to infinity; then its largest and smallest values are left out.
        let has_pole = |poles: &Vec<Ratio>| poles.iter().any(|s| self.parameter.meets(range, *s));
        box_around(&lines.concat(), self.poles.each_ref().map(has_pole))
    }

    /// Points at values of the parameter over the range, `count` of them or more for many oscillations, and at `more` values, in
    /// their order.
    fn sampled(&self, range: Option<[f64; 2]>, count: u32, more: &[f64]) -> Vec<Drawn<N>> {
        let degree = u32::try_from(self.degree);
        let degree = degree.invariant("the degrees of a form are below 2^32");
        let count = match self.parameter.is_angle() {
            true => count.max(degree.saturating_mul(POINTS_PER_DEGREE).min(MOST_POINTS)),
            false => count,
        };
        let mut parameters = self.parameter.values(range, count.max(1));
        parameters.extend(more);
        parameters.sort_unstable_by(f64::total_cmp);
        parameters.dedup();
        parameters.into_iter().map(|t| self.drawn(t)).collect()
    }

    fn drawn(&self, parameter: f64) -> Drawn<N> {
        let found = self.values.at(self.parameter.ratio(parameter));
        Drawn {
            parameter,
            point: found.map(|v| v.value),
            signs: found.map(|v| v.is_above),
        }
    }

    /// More points, in the middle between neighbors that are far apart and may have a part of the curve in the area between them.
    fn denser(&self, mut all: Vec<Drawn<N>>, area: &Area<N>) -> Vec<Drawn<N>> {
        let size = area.iter().fold(0.0, |size: f64, [a, b]| size.hypot(b - a));
        let work_of_point = self.degree.saturating_mul(self.degree).max(1);
        let mut room = (MOST_WORK / work_of_point).min(MOST_POINTS as usize);
        for _ in 0..MOST_HALVINGS {
            let before = room;
            let mut result: Vec<Drawn<N>> = Vec::with_capacity(all.len());
            for next in all {
                let last = result.last().filter(|_| room > 0);
                let middle = last.and_then(|last| last.middle(&next, area, size / CHORDS));
                if let Some(middle) = middle {
                    room -= 1;
                    result.push(self.drawn(middle));
                }
                result.push(next);
            }
            all = result;
            if room == before {
                break;
            }
        }
        all
    }

    /// The lines that points in their order make.
    fn cut_at_poles(&self, all: Vec<Drawn<N>>) -> Vec<Vec<[f64; N]>> {
        let mut lines: Vec<Vec<[f64; N]>> = vec![Vec::new()];
        let mut signs: Option<[bool; N]> = None;
        for drawn in all {
            // At a pole the denominator changes its sign.
            let jumps = signs.is_some_and(|before| before != drawn.signs);
            if jumps && !self.is_bounded {
                lines.push(Vec::new());
            }
            signs = Some(drawn.signs);
            if drawn.point.iter().all(|v| v.is_finite())
                && let Some(line) = lines.last_mut()
            {
                line.push(drawn.point);
            }
        }
        lines.retain(|line| line.len() > 1);
        lines
    }
}

impl<const N: usize> Drawn<N> {
    /// The value of the parameter in the middle, if the next point is farther than `longest` and there may be a part of the curve in
    /// the area between the two.
    fn middle(&self, next: &Self, area: &Area<N>, longest: f64) -> Option<f64> {
        let pairs = || self.point.iter().zip(&next.point);
        let distance = pairs().fold(0.0, |sum: f64, (a, b)| sum.hypot(a - b));
        let meets = |((a, b), [low, high]): ((&f64, &f64), &[f64; 2])| {
            a.min(*b) <= *high && a.max(*b) >= *low
        };
        // From a point that is not finite nothing is near.
        let is_near = distance <= longest;
        let middle = f64::midpoint(self.parameter, next.parameter);
        let is_between = self.parameter < middle && middle < next.parameter;
        (!is_near && is_between && pairs().zip(area).all(meets)).then_some(middle)
    }
}

/// The real values of s at the poles of a coordinate, the infinite one included.
fn poles(f: &RationalFunction) -> Vec<Ratio> {
    let roots = real_roots(f.denominator()).into_iter();
    let mut poles: Vec<Ratio> = roots.map(|root| [root.to_f64(), 1.0]).collect();
    if has_pole_at_infinity(f) {
        poles.push([1.0, 0.0]);
    }
    poles
}

fn has_pole_at_infinity(f: &RationalFunction) -> bool {
    f.numerator().coefficients_asc().len() > f.denominator().coefficients_asc().len()
}

/// The values of a number, in the range, at which the derivative of a coordinate is 0.
fn turns<const N: usize>(coordinates: &[RationalFunction; N], range: Option<[f64; 2]>) -> Vec<f64> {
    let slopes = coordinates.iter().map(|f| {
        let (p, q) = (f.numerator(), f.denominator());
        p.derivative() * q - q.derivative() * p
    });
    let roots = slopes
        .filter(|slope| *slope != IntegerPolynomial::ZERO)
        .flat_map(|slope| real_roots(&slope));
    let largest = Parameter::LARGEST_NUMBER;
    let [low, high] = range.unwrap_or([-largest, largest]);
    let values = roots.map(|root| root.to_f64());
    values.filter(|t| low <= *t && *t <= high).collect()
}

/// The box around points. Of a coordinate that has poles a share of the smallest and of the largest values is left out, and the
/// range of the others is made half as large again.
pub(super) fn box_around<const N: usize>(
    points: &[[f64; N]],
    has_poles: [bool; N],
) -> Option<Area<N>> {
    let last = points.len().checked_sub(1)?;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "a share of a number of points"
    )]
    let left_out = (LEFT_OUT * last as f64) as usize;
    let mut bounds = [[0.0; 2]; N];
    for (k, side) in bounds.iter_mut().enumerate() {
        let mut values: Vec<f64> = points.iter().map(|p| p[k]).collect();
        values.sort_unstable_by(f64::total_cmp);
        let skipped = if has_poles[k] { left_out } else { 0 };
        let (low, high) = (values[skipped], values[last - skipped]);
        let more = if skipped > 0 { (high - low) / 4.0 } else { 0.0 };
        *side = [low - more, high + more];
    }
    Some(bounds)
}

#[cfg(test)]
mod tests {
    use crate::shape::PlaneCurve;

    /// A curve of the language.
    fn curve(text: &str) -> PlaneCurve {
        use crate::language::{Numbers, parse_form};
        match parse_form(text, "<form>", Numbers::Exact).unwrap() {
            crate::shape::Form::PlaneCurve(curve) => curve,
            other => panic!("{other:?} is no plane curve"),
        }
    }

    #[test]
    fn a_circle_is_closed_and_a_hyperbola_has_two_arms() {
        let circle = curve("x = cos(t); y = sin(t)");
        let lines = circle.polylines(None, 100);
        assert_eq!(lines.len(), 1);
        assert!(
            lines[0]
                .iter()
                .all(|[x, y]| (x * x + y * y - 1.0).abs() < 1e-12)
        );
        let (first, last) = (lines[0][0], lines[0].last().unwrap());
        assert!((first[0] - last[0]).hypot(first[1] - last[1]) < 1e-12);

        let hyperbola = curve("x = t; y = 1/t");
        assert!(!hyperbola.is_bounded());
        let lines = hyperbola.polylines(None, 101);
        assert_eq!(lines.len(), 2);
        // The box shows the middle of the hyperbola, not the parts that go to infinity.
        let [x, y] = hyperbola.extent(None).unwrap();
        assert!(x[1] < 3.0 && y[1] < 40.0, "{x:?} {y:?}");
    }

    #[test]
    fn the_box_leaves_out_what_is_near_poles() {
        // Poles of even and of odd order, at drawn values of the parameter and beside them; the second coordinate may have none.
        for (text, range, least, most) in [
            ("r = 1/(1-cos(t))", None, 1.0, 500.0),
            ("r = 1/(1+cos(t))", None, 1.0, 500.0),
            ("x = tan(t/2)^2; y = 100*sin(t)", None, 100.0, 500.0),
            ("x = 1/(3*t-1)^2; y = t", None, 1.0, 2000.0),
            ("x = 1/(3*t-1); y = t", None, 1.0, 2000.0),
            // No pole is in the range, so all of the curve is in the box.
            ("r = 1/(1-cos(t))", Some([0.1, 3.0]), 199.0, 201.0),
            ("r = 1/(1-cos(t))", Some([-6.1, -3.0]), 59.0, 60.5),
            ("x = 1/t; y = t", Some([0.01, 1.0]), 99.0, 100.0),
            ("x = 1/t; y = t", None, 1.0, 500.0),
        ] {
            let extent = curve(text).extent(range).unwrap();
            let size = extent
                .iter()
                .map(|[low, high]| high - low)
                .fold(0.0, f64::max);
            assert!((least..=most).contains(&size), "{text}: {extent:?}");
        }
        let [_, y] = curve("x = 1/(1+cos(t)); y = sin(t)").extent(None).unwrap();
        assert!(
            (y[0] + 1.0).abs() < 1e-4 && (y[1] - 1.0).abs() < 1e-4,
            "{y:?}"
        );
    }

    #[test]
    fn many_oscillations_are_where_they_are() {
        let lines = curve("x = sin(100*t); y = cos(t)").polylines(None, 2880);
        assert_eq!(lines.len(), 1);
        for [x, y] in &lines[0] {
            // T_100(y) is cos(100t).
            let wave = (100.0 * y.acos()).sin().abs();
            assert!((x.abs() - wave).abs() < 1e-6, "{x} {y}");
        }
        let lines =
            curve("x = cos(t)/(2 + cos(60*t)); y = sin(t)/(2 + cos(60*t))").polylines(None, 2880);
        for [x, y] in &lines[0] {
            let radius = 1.0 / (2.0 + (60.0 * y.atan2(*x)).cos());
            assert!((x.hypot(*y) - radius).abs() < 1e-9, "{x} {y}");
        }
    }

    #[test]
    fn numbers_beyond_the_doubles_are_drawn() {
        for (text, range, expected) in [
            (
                "x = t; y = 1000*(t/1000)^104",
                [900.0, 1000.0],
                [[900.0, 1000.0], [0.0174, 1000.0]],
            ),
            (
                "x = t^3/10^320; y = t^2/10^213",
                [-1e107, 1e107],
                [[-10.0, 10.0], [0.0, 10.0]],
            ),
            (
                "x = 10^400*t/(10^400*t^2+1); y = t/(1+t^2)",
                [-1.0, 1.0],
                [[-5e199, 5e199], [-0.5, 0.5]],
            ),
        ] {
            let extent = curve(text).extent(Some(range)).unwrap();
            for (found, expected) in extent.iter().flatten().zip(expected.iter().flatten()) {
                assert!(
                    (found - expected).abs() <= 1e-2 * expected.abs() + 1e-4,
                    "{text}: {extent:?}"
                );
            }
        }
    }

    #[test]
    fn a_range_of_all_doubles_is_drawn() {
        let circle = curve("x = 1/(1+t^2); y = t/(1+t^2)");
        let lines = circle.polylines(Some([-1.7e308, 1.7e308]), 2880);
        for [x, y] in &lines[0] {
            assert!(((x - 0.5).hypot(*y) - 0.5).abs() < 1e-9);
        }
        let gaps = lines[0]
            .windows(2)
            .map(|p| (p[0][0] - p[1][0]).hypot(p[0][1] - p[1][1]));
        assert!(gaps.fold(0.0, f64::max) < 0.02);
    }

    #[test]
    fn points_are_set_in_an_area_that_is_far_away() {
        let parabola = curve("x = t; y = t^2/1000");
        let area = [[1000.0, 1100.0], [1000.0, 1210.0]];
        let lines = parabola.polylines_in(Some(area), None, 2880);
        let inside = |p: &&[f64; 2]| (1000.0..=1100.0).contains(&p[0]);
        assert!(lines.iter().flatten().filter(inside).count() > 100);
    }

    #[test]
    fn powers_of_small_differences_are_not_noise() {
        for (text, range, shift, power) in [
            ("x = t; y = (t-100)^7", [99.0, 101.0], 100.0, 7),
            ("x = t; y = (t-3)^30", [2.5, 3.5], 3.0, 30),
            ("x = t; y = (t-1000)^5", [999.0, 1001.0], 1000.0, 5),
        ] {
            let lines = curve(text).polylines(Some(range), 2880);
            assert!(lines[0].len() > 2880);
            for [x, y] in &lines[0] {
                let expected = (x - shift).powi(power);
                // x is that of a parameter in doubles.
                let error = 1e-12 * shift * f64::from(power);
                assert!((y - expected).abs() <= error, "{text}: {x} {y}");
            }
        }
    }

    #[test]
    fn a_bounded_curve_is_drawn_whole_wherever_its_parameter_is() {
        for shift in [0i64, 20, 100, 1_000_000] {
            for scale in [1i64, 1000] {
                let s = format!("({scale}*(t-{shift}))");
                let text = format!("x = (1-{s}^2)/(1+{s}^2); y = 2*{s}/(1+{s}^2)");
                let circle = curve(&text);
                let lines = circle.polylines(None, 2880);
                assert_eq!(lines.len(), 1, "{text}");
                let gaps = lines[0]
                    .windows(2)
                    .map(|p| (p[0][0] - p[1][0]).hypot(p[0][1] - p[1][1]));
                let longest = gaps.fold(0.0, f64::max);
                assert!(longest < 0.02, "{text}: {longest}");
                let extent = circle.extent(None).unwrap();
                for [low, high] in extent {
                    assert!(
                        (low + 1.0).abs() < 1e-5 && (high - 1.0).abs() < 1e-5,
                        "{text}: {extent:?}"
                    );
                }
            }
        }
    }
}
