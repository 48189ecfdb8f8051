//! What interval Newton proves of two surfaces on one box: a single smooth arc, or a single point.

use crate::exact::Rational;
use crate::field::Field;

/// Rounding errors of the small matrix products below are less than this part of the sums of their sizes.
const ROUNDING: f64 = 1e-15;
/// Steps of Newton's method in doubles.
const NEWTON_STEPS: usize = 40;

/// Steps of Newton's method with exact values; each squares the error, down to half an ulp.
const EXACT_STEPS: usize = 8;

/// A box in which the two surfaces meet in exactly one smooth arc, from end to end of the box along one axis: for
/// every value of that coordinate there is exactly one point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tube {
    pub(super) axis: usize,
    pub(super) middle: [f64; 3],
    pub(super) halves: [f64; 3],
}

/// A point with exactly one common zero within `radius` of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Enclosed {
    pub(super) position: [f64; 3],
    pub(super) radius: f64,
}

impl Tube {
    /// Whether a box is inside.
    pub(super) fn holds(&self, middle: [f64; 3], halves: [f64; 3]) -> bool {
        (0..3).all(|i| {
            let reach = (middle[i] - self.middle[i]).abs() + halves[i];
            reach * (1.0 + 1e-12) <= self.halves[i]
        })
    }

    /// Whether the zero beside a point is inside.
    pub(super) fn holds_point(&self, point: &Enclosed) -> bool {
        self.holds(point.position, [point.radius; 3])
    }
}

/// Both of the coordinates that are not along `axis`.
pub(super) fn across(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// The inverse of the derivatives of both functions across an axis, scaled by the half sides; and what it leaves of them: for
/// both rows the part of the interval matrix I − Y J that stays.
struct Preconditioned {
    inverse: [[f64; 2]; 2],
    rest: [f64; 2],
}

fn preconditioned(slopes: [[[f64; 2]; 3]; 2], axis: usize) -> Option<Preconditioned> {
    let [u, v] = across(axis);
    let [[a, b], [c, d]] = slopes.map(|s| [s[u][0], s[v][0]]);
    let determinant = a * d - b * c;
    let inverse = [
        [d / determinant, -b / determinant],
        [-c / determinant, a / determinant],
    ];
    if !inverse.as_flattened().iter().all(|y| y.is_finite()) {
        return None;
    }
    let rest = [0, 1].map(|i: usize| {
        let mut sum = 0.0;
        for (k, y) in inverse[i].iter().enumerate() {
            for j in [u, v] {
                let [middle, radius] = slopes[k][j];
                sum += y.abs() * (radius + ROUNDING * middle.abs());
            }
        }
        // What the doubles leave of the identity.
        for (j, column) in [[a, c], [b, d]].into_iter().enumerate() {
            let entry = inverse[i][0] * column[0] + inverse[i][1] * column[1];
            sum += (entry - if i == j { 1.0 } else { 0.0 }).abs();
        }
        sum * (1.0 + 1e-9)
    });
    Some(Preconditioned { inverse, rest })
}

/// Proves a box to be a tube by Krawczyk's operator over all values of one coordinate at once: with s in [−1, 1]³ on the box and
/// t along the axis, −Y F(t, 0, 0) + (I − Y J)[−1, 1]² stays inside [−1, 1]².
///
/// F(t, 0, 0) is within F(0) + t ∂F/∂t, by the mean value theorem. Krawczyk (1969); Neumaier, *Interval methods for systems of
/// equations*, §5.1.
pub(super) fn tube(
    fields: [&Field; 2],
    axis: usize,
    middle: [f64; 3],
    halves: [f64; 3],
) -> Option<Tube> {
    let bounds = fields.map(|f| f.on_box(middle, halves));
    let system = preconditioned(bounds.each_ref().map(|b| b.slopes), axis)?;
    let is_inside = (0..2).all(|i| {
        let [mut value, mut along, mut loose, mut size] = [0.0; 4];
        for (y, b) in system.inverse[i].iter().zip(&bounds) {
            let [slope, radius] = b.slopes[axis];
            value += y * b.value;
            along += y * slope;
            loose += y.abs() * (b.error + radius);
            size += y.abs() * (b.value.abs() + slope.abs());
        }
        let reach = value.abs() + along.abs() + loose + ROUNDING * size + system.rest[i];
        reach * (1.0 + 1e-9) < 1.0
    });
    is_inside.then_some(Tube {
        axis,
        middle,
        halves,
    })
}

/// Newton's method in doubles with one coordinate held fast.
pub(super) fn newton(fields: [&Field; 2], axis: usize, start: [f64; 3]) -> Option<[f64; 3]> {
    let [u, v] = across(axis);
    let mut p = start;
    for _ in 0..NEWTON_STEPS {
        let [f, g] = fields.map(|field| (field.value(p), field.gradient(p)));
        let determinant = f.1[u] * g.1[v] - f.1[v] * g.1[u];
        let step = [
            (g.1[v] * f.0 - f.1[v] * g.0) / determinant,
            (f.1[u] * g.0 - g.1[u] * f.0) / determinant,
        ];
        if !step.iter().all(|s| s.is_finite()) {
            return None;
        }
        p[u] -= step[0];
        p[v] -= step[1];
        let size = p.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        if step.iter().all(|s| s.abs() <= 4.0 * f64::EPSILON * size) {
            break;
        }
    }
    Some(p)
}

/// The common zero beside a point of which one coordinate is exact: within `reach` there is exactly one, and the doubles are
/// moved to it.
///
/// The values of both functions are exact rational numbers here, so the radius is about half an ulp.
pub(super) fn enclose(
    fields: [&Field; 2],
    axis: usize,
    start: [f64; 3],
    reach: f64,
) -> Option<Enclosed> {
    let [u, v] = across(axis);
    let mut halves = [0.0; 3];
    halves[u] = reach;
    halves[v] = reach;
    let mut position = start;
    let mut best: Option<Enclosed> = None;
    for _ in 0..EXACT_STEPS {
        let slopes = fields.map(|f| f.on_box(position, halves).slopes);
        let system = preconditioned(slopes, axis)?;
        let exact = fields.map(|f| f.exact_value(position));
        let steps = system.inverse.map(|row| {
            let mut sum = Rational::zero();
            for (y, value) in row.iter().zip(&exact) {
                sum = &sum + &(&Rational::try_from(*y).unwrap_or_default() * value);
            }
            sum.to_f64()
        });
        let [step, rest] = [
            steps.iter().fold(0.0, |m: f64, s| m.max(s.abs())),
            system.rest.iter().fold(0.0, |m: f64, r| m.max(*r)),
        ];
        // |solution − position| ≤ |Y F| + rest · |solution − position| in the maximum norm, scaled by the reach.
        let scaled = step / (1.0 - rest) * (1.0 + 1e-9);
        if rest < 0.5 && step + rest < 1.0 {
            let radius = reach * scaled * std::f64::consts::SQRT_2 * (1.0 + 1e-9);
            if best.is_none_or(|known| radius < known.radius) {
                best = Some(Enclosed { position, radius });
            } else {
                break;
            }
        }
        position[u] -= reach * steps[0];
        position[v] -= reach * steps[1];
    }
    best
}
