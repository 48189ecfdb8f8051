//! The claim `distance`: whether a curve or surface has points in a ball, or on a circle or sphere (T6).

use num_bigint::BigInt;

use super::arcs::Arc;
use super::cover::{Budget, Cell, Dense};
use super::forms::{Forms, Implicit, Locus};
use super::json::{Claim, Value};
use super::numbers::{Exact, common_denominator, sign, squared_distance, unit_vector, vector};
use super::refusal::{Checked, Refusal, need};
use super::series::{Harmonics, Series, length_polynomial, quarter_direction};
use super::sparse::Sparse;
use super::univariate::{power, product, variations};

/// The largest number of multipliers, or of places, of a cover.
const MOST_MULTIPLIERS: usize = 8;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Relation {
    /// A point of the curve or surface has at most the distance.
    AtMost,
    /// No point of the curve or surface has at most the distance.
    MoreThan,
    /// A point of the curve or surface has exactly the distance.
    Meets,
    /// No point of the curve or surface has exactly the distance.
    Misses,
}

/// The point and the bound of a claim.
struct Ball {
    center: Vec<Exact>,
    radius: Exact,
    relation: Relation,
}

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    let fields = claim.statement(&["form", "point", "relation", "bound"], &[])?;
    let locus = fields.get("form", |index| forms.locus(index))?;
    let ball = Ball {
        center: fields.get("point", |value| vector(value, locus.dimension()))?,
        radius: fields.get("bound", Exact::read)?,
        relation: fields.get("relation", read_relation)?,
    };
    need(ball.radius.sign() >= 0, "the bound is negative")?;
    let has_points = matches!(ball.relation, Relation::AtMost | Relation::Meets);
    match locus {
        Locus::Implicit(form) if has_points => check_segment(form, &ball, claim),
        Locus::Implicit(form) => check_cube(form, &ball, claim),
        Locus::Series(radius) if has_points => check_directions(radius, &ball, claim),
        Locus::Series(Series {
            harmonics: Harmonics::Space { .. },
            ..
        }) => Err(Refusal::new(
            "that a surface keeps a distance has no witness for a spherical form",
        )),
        Locus::Series(radius) => check_arcs(radius, &ball, claim),
    }
}

fn read_relation(value: &Value) -> Checked<Relation> {
    match value.text()? {
        "at-most" => Ok(Relation::AtMost),
        "more-than" => Ok(Relation::MoreThan),
        "meets" => Ok(Relation::Meets),
        "misses" => Ok(Relation::Misses),
        _ => Err(Refusal::new("this relation is unknown")),
    }
}

impl Ball {
    /// The sign of the distance of the point from the center minus the radius.
    fn side(&self, point: &[Exact]) -> i64 {
        (&squared_distance(point, &self.center) - &self.radius.squared()).sign()
    }
}

/// A polynomial that does not have the same sign at two points of a ball or a sphere has a zero there.
fn check_segment(form: &Implicit, ball: &Ball, claim: &Claim<'_>) -> Checked<()> {
    let ends = claim.witness(&["segment"], &[])?.get("segment", |list| {
        list.list(2..=2, |point| {
            let point = vector(point, form.dimension)?;
            let side = ball.side(&point);
            need(
                side == 0 || side < 0 && ball.relation == Relation::AtMost,
                "this end is too far from the point, or not on its sphere",
            )?;
            Ok(form.terms.sign_at(&point))
        })
    })?;
    need(
        ends.iter().product::<i64>() <= 0,
        "the polynomial has the same sign at both ends",
    )
}

/// A curve or surface has the points of one or two directions, and points with all distances between those of the two.
fn check_directions(radius: &Series, ball: &Ball, claim: &Claim<'_>) -> Checked<()> {
    let sides = claim
        .witness(&["directions"], &[])?
        .get("directions", |list| {
            list.list(1..=2, |direction| {
                let direction = unit_vector(direction, radius.dimension())?;
                Ok(ball.side(&radius.point(&direction)?))
            })
        })?;
    need(
        sides.iter().any(|side| *side <= 0),
        "the curve is farther from the point than the bound in these directions",
    )?;
    need(
        ball.relation == Relation::AtMost || sides.iter().any(|side| *side >= 0),
        "the curve is nearer to the point than the bound in these directions",
    )
}

/// A polynomial on the cube about a ball has no zero in the cells that contain points of the ball, or of its sphere: the polynomial
/// f itself, or f − μ·(d² − |x − p|²) for one of the multipliers, has one sign there, and the second one that of μ if the inside of
/// the ball matters.
fn check_cube(form: &Implicit, ball: &Ball, claim: &Claim<'_>) -> Checked<()> {
    let witness = claim.witness(&["depth"], &["multipliers"])?;
    let mut budget = Budget::of(&witness)?;
    let multipliers = witness.optional("multipliers", |list| {
        list.list(1..=MOST_MULTIPLIERS, Exact::read)
    })?;
    let mut multipliers = multipliers.unwrap_or_default();
    multipliers.push(Exact::zero());
    Dense::need_small(&form.terms, form.dimension)?;
    let on_cube = |multiplier: &Exact| {
        let mut moved = raised(form, ball, multiplier);
        for (axis, coordinate) in ball.center.iter().enumerate() {
            moved = moved.substituted(axis, coordinate, &ball.radius);
        }
        let lengths: Vec<_> = (0..form.dimension)
            .map(|axis| moved.degree_in(axis) as usize + 1)
            .collect();
        Dense::new(&moved, &lengths)
    };
    let polynomials = multipliers.iter().map(on_cube).collect::<Checked<_>>()?;
    let sphere = ball.relation == Relation::Misses;
    let whole = Cell::whole_cube(polynomials, form.dimension);
    whole.cover(&mut budget, &|cell| {
        let unit = cell.unit();
        let outside = cell.nearest_square() > unit;
        let inside = sphere && cell.farthest_square() < unit;
        let mut pairs = cell.polynomials.iter().zip(&multipliers);
        let decides = |(f, multiplier): (&Dense, &Exact)| {
            let sign = f.sign();
            sign != 0 && (sphere || multiplier.sign() * sign >= 0)
        };
        outside || inside || pairs.any(decides)
    })
}

/// f − μ·(d² − |x − p|²) with integer coefficients, times a positive number.
fn raised(form: &Implicit, ball: &Ball, multiplier: &Exact) -> Sparse {
    let two = Exact::integer(2);
    let mut values: Vec<_> = ball.center.iter().map(|c| c * &two).collect();
    let origin = vec![Exact::zero(); form.dimension];
    values.push(&ball.radius.squared() - &squared_distance(&ball.center, &origin));
    let (values, common) = common_denominator(&values);
    let mut lens = Sparse::default();
    for (axis, c) in values.iter().enumerate() {
        let mut exponents = [0; 4];
        if axis < form.dimension {
            exponents[axis] = 1;
        }
        lens.add_term(exponents, c.clone());
    }
    lens.add_multiple(&-&common, &Sparse::squared_radius(form.dimension));
    let mut result = Sparse::default();
    result.add_multiple(&(multiplier.denominator() * &common), &form.terms);
    result.add_multiple(&-(multiplier.numerator() * &form.denominator), &lens);
    result
}

/// The difference of the squares of the distance and the bound has no zero on a curve, and is positive if nothing of the curve
/// may be in the ball.
fn check_arcs(radius: &Series, ball: &Ball, claim: &Claim<'_>) -> Checked<()> {
    let witness = claim.witness(&["depth"], &["near"])?;
    let mut budget = Budget::of(&witness)?;
    let near = witness.optional("near", |list| list.list(1..=MOST_MULTIPLIERS, Exact::read))?;
    let near = near.unwrap_or_default();
    // With the curve (X, Y)/W about its center and (u, v) from there to p, the numerator of |C − p|² − d² over W² is
    // (X² + Y²) − 2u·X·W − 2v·Y·W + (u² + v² − d²)·W².
    let offset: Vec<_> = ball
        .center
        .iter()
        .zip(&radius.center)
        .map(|(p, c)| p - c)
        .collect();
    let minus_two = Exact::integer(-2);
    let square = &squared_distance(&ball.center, &radius.center) - &ball.radius.squared();
    let mut weights = vec![Exact::one()];
    weights.extend(offset.iter().map(|coordinate| coordinate * &minus_two));
    weights.push(square);
    let (weights, _) = common_denominator(&weights);
    let quarters = radius
        .quarters
        .get_or_init(|| (0..4).map(|q| whole_quarter(radius, q)).collect());
    // The number q + t stands for the parameter t in the quarter q.
    for (index, quarter) in (0_i64..).zip(quarters) {
        let parameters = near.iter().map(|place| place - &Exact::integer(index));
        let here: Vec<_> = parameters.filter(Exact::is_in_unit_interval).collect();
        cover_arc(quarter, &here, &weights, ball.relation, &mut budget)?;
    }
    Ok(())
}

fn cover_arc(
    arc: &Arc,
    near: &[Exact],
    weights: &[BigInt],
    relation: Relation,
    budget: &mut Budget,
) -> Checked<()> {
    budget.enter_cell()?;
    let coefficients = arc.combination(weights);
    let ends = [coefficients.first(), coefficients.last()].map(|c| c.map_or(0, sign));
    let decided = match ends {
        [1, 1] => true,
        [-1, -1] => relation == Relation::Misses,
        _ => false,
    };
    let seen = match variations(&coefficients) {
        0 => decided,
        2 => decided && near.iter().any(|at| arc.sign_about(at, weights) != 0),
        _ => false,
    };
    if seen {
        return Ok(());
    }
    budget.may_halve(arc.level())?;
    arc.try_halves(near, |half, near| {
        cover_arc(half, near, weights, relation, budget)
    })
}

/// X² + Y², X·W, Y·W and W² on a quarter, where W = (1 + t²)^(N + 1)·scale and X + i Y = (1 + t²)^N·r·scale·z with
/// z = i^q·(1 + i t)².
fn whole_quarter(radius: &Series, quarter: usize) -> Arc {
    let on_quarter = radius.on_quarter(quarter);
    let [x, y] = quarter_direction(quarter).map(|coordinate| product(&on_quarter, &coordinate));
    let length = length_polynomial();
    let mut w = power(&length, radius.top() as usize + 1);
    for c in &mut w {
        *c *= &radius.scale;
    }
    // |z| = 1 + t².
    let distance = product(&on_quarter, &length);
    let polynomials = [
        product(&distance, &distance),
        product(&x, &w),
        product(&y, &w),
        product(&w, &w),
    ];
    Arc::new(polynomials, 0)
}
