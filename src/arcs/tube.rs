//! Proofs by interval Newton for two surfaces in one box: a single smooth arc, or a single point.

use crate::exact::Rational;
use crate::intervals::{BoxBounds, Field, Interval, distance, rational};

/// The largest number of steps of Newton's method in doubles.
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Enclosed {
    pub(crate) position: [f64; 3],
    pub(crate) radius: f64,
}

impl Tube {
    /// Whether a box is inside the tube.
    pub(super) fn holds(&self, middle: [f64; 3], halves: [f64; 3]) -> bool {
        (0..3).all(|i| {
            let away = Interval::from(middle[i]) - Interval::from(self.middle[i]);
            (away.abs() + Interval::from(halves[i])).high() <= self.halves[i]
        })
    }

    /// Whether the zero near a point is inside the tube.
    pub(super) fn holds_point(&self, point: &Enclosed) -> bool {
        self.holds(point.position, [point.radius; 3])
    }
}

/// The direction of ∇f × ∇g, in doubles.
pub(super) fn tangent(fields: [&Field; 2], p: [f64; 3]) -> Option<[f64; 3]> {
    let [a, b] = fields.map(|f| f.gradient(p));
    let cross = [0, 1, 2].map(|i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    });
    let length = distance(cross, [0.0; 3]);
    let is_usable = length.is_finite() && length > 0.0;
    is_usable.then(|| cross.map(|c| c / length))
}

/// The axis of the largest component.
pub(super) fn largest(v: [f64; 3]) -> usize {
    let better = |best: usize, i: usize| if v[i].abs() > v[best].abs() { i } else { best };
    (0..3).fold(0, better)
}

/// The two axes other than `axis`.
pub(super) fn across(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// Y is a matrix of doubles near the inverse of the 2 × 2 matrix J of the derivatives across an axis, both scaled by the half
/// sides of the box. For each row of I − Y J, a bound on the box of the sum of the sizes of its entries.
struct Preconditioned {
    inverse: [[f64; 2]; 2],
    rest: [f64; 2],
}

impl Preconditioned {
    /// The product of a row of Y and the vector of a quantity of both functions.
    fn row(&self, i: usize, of_both: [Interval; 2]) -> Interval {
        of_both[0] * self.inverse[i][0] + of_both[1] * self.inverse[i][1]
    }
}

fn preconditioned(bounds: &[BoxBounds; 2], axis: usize) -> Option<Preconditioned> {
    let [u, v] = across(axis);
    let slopes = bounds.each_ref().map(|b| [b.slope(u), b.slope(v)]);
    let [[a, b], [c, d]] = slopes.map(|s| s.map(Interval::middle));
    let determinant = a * d - b * c;
    let inverse = [
        [d / determinant, -b / determinant],
        [-c / determinant, a / determinant],
    ];
    if !inverse.as_flattened().iter().all(|y| y.is_finite()) {
        return None;
    }
    let mut system = Preconditioned {
        inverse,
        rest: [0.0; 2],
    };
    system.rest = [0, 1].map(|i: usize| {
        let left = [0, 1].map(|j: usize| {
            let identity = if i == j { 1.0 } else { 0.0 };
            let column = slopes.map(|s| s[j]);
            (Interval::from(identity) - system.row(i, column)).abs()
        });
        (left[0] + left[1]).high()
    });
    Some(system)
}

/// Proves a box to be a tube by Krawczyk's operator over all values of one coordinate at once: with s in [−1, 1]³ on the box and
/// t along the axis, −Y F(t, 0, 0) + (I − Y J)[−1, 1]² stays inside [−1, 1]².
///
/// F(t, 0, 0) is within F(0) + t ∂F/∂t, by the mean value theorem. Krawczyk (1969); Neumaier, *Interval methods for systems of
/// equations*, §5.1.
///
/// Law: `tubes_hold_one_point_in_every_section`.
pub(super) fn tube(
    fields: [&Field; 2],
    axis: usize,
    middle: [f64; 3],
    halves: [f64; 3],
) -> Option<Tube> {
    let bounds = fields.map(|f| f.on_box(middle, halves));
    let system = preconditioned(&bounds, axis)?;
    let is_inside = (0..2).all(|i| {
        let value = system.row(i, bounds.each_ref().map(BoxBounds::value));
        let along = system.row(i, bounds.each_ref().map(|b| b.slope(axis)));
        let reach = value.abs() + along.abs() + Interval::from(system.rest[i]);
        reach.high() < 1.0
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

/// The common zero near a point at which the gradients are not parallel; it is the only one within `reach` with the same coordinate
/// along the axis on which the curve runs fastest.
pub(crate) fn enclose_common_zero(
    fields: [&Field; 2],
    start: [f64; 3],
    reach: f64,
) -> Option<Enclosed> {
    let axis = largest(tangent(fields, start)?);
    enclose(fields, axis, newton(fields, axis, start)?, reach)
}

/// The common zero near a point, one of whose coordinates is kept: there is exactly one within `reach`. The point is moved to
/// doubles near the zero.
///
/// The values of both functions are exact rational numbers, so the radius is about half an ulp.
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
        if !position.iter().all(|x| x.is_finite()) {
            break;
        }
        let bounds = fields.map(|f| f.on_box(position, halves));
        let system = preconditioned(&bounds, axis)?;
        let exact = fields.map(|f| f.exact_value(position));
        let steps = system.inverse.map(|row| {
            let terms = row.iter().zip(&exact);
            let sum: Rational = terms.map(|(y, value)| &rational(*y) * value).sum();
            Interval::from(&sum)
        });
        let step = steps[0].abs().max(steps[1].abs());
        let rest = Interval::from(system.rest[0]).max(Interval::from(system.rest[1]));
        // |solution − position| ≤ |Y F| + rest · |solution − position| in the maximum norm, scaled by the reach.
        let scaled = step / (Interval::from(1.0) - rest);
        if rest.high() < 0.5 && (step + rest).high() < 1.0 {
            let radius = (scaled * reach * Interval::from(2.0).sqrt()).high();
            if best.is_none_or(|known| radius < known.radius) {
                best = Some(Enclosed { position, radius });
            } else {
                break;
            }
        }
        position[u] -= reach * steps[0].middle();
        position[v] -= reach * steps[1].middle();
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intervals::rationals;
    use crate::poly::{Ring, SparsePolynomial};
    use proptest::prelude::*;

    /// c·x − c·m − off, so that the plane passes at a distance from m.
    fn plane(c: [i64; 3], m: [f64; 3], off: &Rational) -> SparsePolynomial<3> {
        let terms =
            (0..3).map(|i| SparsePolynomial::<3>::variable(i).scaled(&Rational::from(c[i])));
        let linear = terms.fold(SparsePolynomial::zero(), |sum, term| sum.plus(&term));
        let at = linear.evaluate(&rationals(m));
        linear.minus(&SparsePolynomial::constant(at + off))
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

        /// Two planes meet in a line; where a box is proved to be a tube of it, the line leaves it by the ends, exactly. The sides
        /// are next to where the line is at the ends.
        #[test]
        fn tubes_hold_one_point_in_every_section(c in prop::array::uniform6(-9i64..10), m in prop::array::uniform3(-3.0f64..3.0), off in prop::array::uniform2(-1.0f64..1.0), half in 0.1f64..2.0, ulps in -8i64..9, side in 0usize..2) {
            let (a, b) = ([c[0], c[1], c[2]], [c[3], c[4], c[5]]);
            let determinant = a[1] * b[2] - a[2] * b[1];
            prop_assume!(determinant != 0);
            let [e, f] = off.map(rational);
            let fields = [Field::new(&plane(a, m, &e)), Field::new(&plane(b, m, &f))];
            // y and z beyond m for a given x beyond m, by Cramer's rule.
            let at = |x: &Rational| {
                let whole = Rational::from(determinant);
                let [r, s] = [&e - &(x * &Rational::from(a[0])), &f - &(x * &Rational::from(b[0]))];
                let y = (&r * &Rational::from(b[2]) - &s * &Rational::from(a[2])) / &whole;
                let z = (&s * &Rational::from(a[1]) - &r * &Rational::from(b[1])) / &whole;
                [y, z]
            };
            let ends = [at(&rational(half)), at(&-rational(half))];
            let most = [0, 1].map(|i| ends[0][i].abs().max(ends[1][i].abs()));
            let mut sides = most.each_ref().map(|x| x.to_f64() * 2.0 + 1e-3);
            let near = i64::try_from(most[side].to_f64().to_bits()).unwrap() + ulps;
            prop_assume!(near > 0);
            sides[side] = f64::from_bits(u64::try_from(near).unwrap());
            if tube([&fields[0], &fields[1]], 0, m, [half, sides[0], sides[1]]).is_some() {
                prop_assert!(most[0] <= rational(sides[0]) && most[1] <= rational(sides[1]));
            }
            sides[side] *= 1.0 + 1e-10;
            prop_assert!(tube([&fields[0], &fields[1]], 0, m, [half, sides[0], sides[1]]).is_some() || ulps < 0 || most[side].to_f64() < 1e-3);
            // The point of the line with the first coordinate of m is beside the one that is found.
            let zero = at(&Rational::zero());
            let start = [m[0], m[1] + zero[0].to_f64() + 1e-4, m[2] + zero[1].to_f64() - 1e-4];
            let found = enclose([&fields[0], &fields[1]], 0, start, 1e-2).expect("a line is found");
            let away: Rational = (0..2).map(|i| {
                let off = rational(m[i + 1]) + &zero[i] - rational(found.position[i + 1]);
                &off * &off
            }).sum();
            prop_assert!(away <= rational(found.radius) * rational(found.radius));
        }

        /// A box is inside a tube only if it is, exactly.
        #[test]
        fn only_boxes_inside_are_held(m in prop::array::uniform3(-3.0f64..3.0), off in prop::array::uniform3(-1.0f64..1.0), half in 0.1f64..1.0, ulps in -3i64..4) {
            let middle: [f64; 3] = std::array::from_fn(|i| m[i] + off[i]);
            let halves = off.map(|x| {
                let least = x.abs() + half;
                f64::from_bits(u64::try_from(i64::try_from(least.to_bits()).unwrap() + ulps).unwrap())
            });
            let tube = Tube { axis: 0, middle: m, halves };
            if tube.holds(middle, [half; 3]) {
                for i in 0..3 {
                    prop_assert!((rational(middle[i]) - rational(m[i])).abs() + rational(half) <= rational(halves[i]));
                }
            }
        }
    }
}
