//! Questions that certified roots and inspection answer: those on §3 in single directions, and those on §4.

use super::polar::{Polar, polar};
use super::{Answer, form, joined, parts, polynomial, wrong_subject};
use malachite::Integer;

use crate::error::Result;
use crate::exact::{Rational, exact_literal, pi};
use crate::inspect::{Inspector, InspectorOptions, SphereSection};
use crate::limits::Limits;
use crate::parametrize::{AngleRange, BranchRadius, Parametrization, SurfaceParametrization};
use crate::poly::SpacePolynomial;
use crate::sample::{Direction, Ray, RaySolver, Sample, SpaceDirection, UnitVector};
use crate::shape::{Form, ImplicitSurface};

/// The largest distance of a closed form in doubles from the certified root, relative to the largest root of the direction. It
/// is far above the rounding of a double, because terms of a closed form may cancel, and double roots lose half of the digits.
const CLOSE: f64 = 1e-6;

/// The bits of π, and the decimals of multiples of π in answers.
const PI_BITS: u32 = 128;
const DECIMALS: u32 = 7;

pub(super) fn positive_roots(subject: &str, claimed: &str, _: &Limits) -> Result<Answer> {
    let [equation, degrees] = parts(subject)?;
    let curve = super::equations::curve(equation)?;
    let solver = RaySolver::new(curve.polynomial());
    let count = |degrees: &str| {
        let direction = Direction::from_degrees(&exact_literal(degrees.trim())?);
        Ok(match solver.solve(&direction) {
            Ray::Points(points) => points.iter().filter(|p| p.r > 0.0).count().to_string(),
            Ray::Line => "infinite".into(),
        })
    };
    let counts = degrees.split(',').map(count).collect::<Result<Vec<_>>>()?;
    Ok(Answer::text(joined(counts), claimed))
}

pub(super) fn closed_forms(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let [equation, directions] = parts(subject)?;
    let Ok(directions) = directions.parse::<usize>() else {
        return Err(wrong_subject(subject, "a number of directions"));
    };
    let mut roots = 0;
    let mut worst = 0f64;
    let mut refuted = 0;
    let mut note = |values: Option<Vec<f64>>, found: &[f64]| {
        let largest = found.iter().fold(0.0, |m: f64, r| m.max(r.abs()));
        roots += found.len();
        match values {
            Some(mut values) if values.len() == found.len() => {
                values.sort_unstable_by(|a, b| b.total_cmp(a));
                for (value, r) in values.iter().zip(found) {
                    worst = worst.max((value - r).abs() / largest);
                }
            }
            _ => refuted += 1,
        }
    };
    match polar(equation, limits)? {
        Polar::Plane(curve) => {
            let f = super::equations::curve(equation)?;
            for direction in directions_off_branch_ends(directions) {
                if let Some(found) = radii(RaySolver::new(f.polynomial()).solve(&direction)) {
                    note(plane_values(&curve, &direction), &found);
                }
            }
        }
        Polar::Space(surface) => {
            let f = SpacePolynomial::from(&polynomial(equation)?);
            for direction in SpaceDirection::fibonacci(directions) {
                if let Some(found) = radii(RaySolver::new(&f).solve(&direction)) {
                    note(Some(space_values(&surface, &direction)), &found);
                }
            }
        }
    }
    let agrees = refuted == 0 && roots > 0 && worst < CLOSE;
    let count = format!("{roots} roots");
    let compared = if refuted == 0 {
        format!("its closed forms in doubles differ by ≈ {worst:.1e} of the largest root at most")
    } else {
        format!("in {refuted} directions its closed forms do not have as many real values")
    };
    Ok(Answer {
        agrees: agrees && count == claimed,
        found: format!("{count}, and {compared}"),
    })
}

/// `count` equally spaced directions, the first at 1°. Branches often end at multiples of 15°, where doubles cannot tell on
/// which side they are; none of the 72 directions that the statements use is such a multiple.
fn directions_off_branch_ends(count: usize) -> impl Iterator<Item = Direction> {
    let integer = |n: usize| Rational::whole(Integer::from(n));
    let step = integer(360) / integer(count.max(1));
    (0..count).map(move |k| Direction::from_degrees(&(&step * &integer(k) + Rational::one())))
}

/// The certified roots, largest first; `None` along a line of the zero set.
fn radii<const V: usize>(ray: Ray<V>) -> Option<Vec<f64>> {
    match ray {
        Ray::Points(points) => Some(points.iter().map(|p: &Sample<V>| p.r).collect()),
        Ray::Line => None,
    }
}

/// The real values of the closed forms, by the exact ranges of the branches; `None` if a branch has no closed form.
fn plane_values(curve: &Parametrization, direction: &Direction) -> Option<Vec<f64>> {
    let theta = direction.theta().rem_euclid(std::f64::consts::TAU);
    let inside = |range: &AngleRange| {
        let [from, to] = [&range.from, &range.to].map(|end| end.to_decimal(17).parse::<f64>());
        matches!((from, to), (Ok(from), Ok(to)) if from <= theta && theta <= to)
    };
    let real = curve.branches.iter().filter(|b| b.real.iter().any(inside));
    real.map(|branch| match &branch.radius {
        BranchRadius::Root(_) => None,
        radius => Some(radius.approximate(theta)),
    })
    .collect()
}

/// The real values of the closed forms; the exact signs of the branches say which values are real.
fn space_values(surface: &SurfaceParametrization, direction: &SpaceDirection) -> Vec<f64> {
    let at = direction.components().map(|u| u.to_f64());
    let signs = surface.in_direction(direction).branches;
    let branches = surface.branches.iter().zip(signs);
    let real = branches.filter(|(_, sign)| sign.is_some_and(|s| s != 0));
    real.map(|(branch, _)| branch.radius.approximate(at))
        .collect()
}

/// The surface, the point and the distance of `f | x, y, z | d`.
fn inspected(subject: &str) -> Result<(ImplicitSurface, [Rational; 3], Rational)> {
    let [equation, point, distance] = parts(subject)?;
    let coordinates = point.split(',').map(|c| exact_literal(c.trim()));
    let coordinates = coordinates.collect::<Result<Vec<_>>>()?;
    let Ok(point) = coordinates.try_into() else {
        return Err(wrong_subject(subject, "a point x, y, z"));
    };
    let surface = match form(equation)? {
        Form::Surface(surface) => surface,
        _ => ImplicitSurface::new(polynomial(equation)?),
    };
    Ok((surface, point, exact_literal(distance)?))
}

pub(super) fn section(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let (surface, point, distance) = inspected(subject)?;
    let section = SphereSection::new(surface.polynomial(), &point, &distance);
    let (half_turn, _) = pi(PI_BITS);
    // The angle has 30 correct decimals, and π has more.
    let turns = |angle: &crate::parametrize::ExactAngle| -> Result<String> {
        let angle = exact_literal(&angle.to_decimal(30))?;
        Ok((angle / &half_turn).to_decimal(DECIMALS))
    };
    let mut found = Vec::new();
    for range in section.theta_ranges(limits)? {
        found.push(format!("[{}, {}]", turns(&range.from)?, turns(&range.to)?));
    }
    Ok(Answer::text(found.join(" and "), claimed))
}

pub(super) fn inspect(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let (surface, point, tolerance) = inspected(subject)?;
    let options = InspectorOptions::new(tolerance);
    let found = Inspector::surface(&surface, &options, limits)?.inspect(&point);
    let verdict = found.verdict;
    let curve = match found.curve {
        Some(true) => "and the sphere about it meets the surface",
        Some(false) => "and the sphere about it misses the surface",
        None => "and whether the sphere about it meets the surface is undecided",
    };
    Ok(Answer::text(format!("{verdict}, {curve}"), claimed))
}
