//! `stellate sample`: certified points.

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use stellate::document::{Format, NominalAngles, SampledRay, arcs_text, write_arcs, write_samples};
use stellate::error::{Error, Result};
use stellate::exact::{Rational, exact_literal};
use stellate::poly::SpacePolynomial;
use stellate::sample::{
    Direction, Ray, RaySolver, SpaceDirection, SpaceSuperquadricSolver, StageCounts,
    SuperquadricSolver,
};
use stellate::shape::{Form, ImplicitSurface};

use super::arcs;
use super::arguments::Sample;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

const DEFAULT_DIRECTIONS: usize = 360;
/// Along a meridian, from pole to pole.
const DEFAULT_POLAR_STEPS: usize = 180;
const MAX_DIRECTIONS: usize = 10_000_000;

/// What is taken.
const SAMPLE: (&str, &str) = (
    "sample",
    "plane curves, surfaces and intersections of two surfaces",
);

pub(crate) fn run(verb: &Sample, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Csv);
    if !matches!(format, Format::Csv | Format::Json) {
        return Err(Error::Usage(format!(
            "--format {format}: points are written as csv or json"
        )));
    }
    let counted = verb.directions.unwrap_or(1);
    check_count(counted)?;
    let thetas = angles("--theta", &verb.theta)?;
    let phis = angles("--phi", &verb.phi)?;
    let input = input::read(&verb.form, session)?;
    let fitted = input::exact_form(input, &verb.fit, session)?;
    let form = match fitted.form {
        shape @ (Form::Superquadric(_) | Form::SpaceSuperquadric(_)) => shape,
        other => input::through_equation(other, session)?,
    };
    if let Form::Intersection(surfaces) = &form {
        return sample_intersection(surfaces, verb, format, session);
    }
    arcs::refuse(&verb.arcs)?;
    if let Form::Surface(surface) = &form {
        let directions = space_directions(verb.directions, &thetas, &phis)?;
        return sample_surface(surface, directions, verb.positive, format, session);
    }
    if let Form::SpaceSuperquadric(shape) = &form {
        let directions = space_directions(verb.directions, &thetas, &phis)?;
        let solver = SpaceSuperquadricSolver::new(shape);
        let rays = session.stage("sample", |session| {
            solve(|d| solver.solve(d), directions, verb.positive, session)
        })?;
        let origin = [Rational::zero(), Rational::zero()];
        return write_result(session, |out| write_samples(&rays, &origin, format, out));
    }
    if !phis.is_empty() {
        return Err(Error::Usage(
            "--phi is the polar angle of a direction in space; this is a plane curve".into(),
        ));
    }
    let mut directions = match verb.directions {
        None if thetas.is_empty() => Direction::around(DEFAULT_DIRECTIONS),
        count => Direction::around(count.unwrap_or(0)),
    };
    directions.extend(thetas);
    if let Form::Superquadric(shape) = &form {
        let solver = SuperquadricSolver::new(shape);
        let rays = session.stage("sample", |session| {
            solve(|d| solver.solve(d), directions, verb.positive, session)
        })?;
        let origin = [Rational::zero(), Rational::zero()];
        return write_result(session, |out| write_samples(&rays, &origin, format, out));
    }
    let curve = session.stage("implicitize", |session| {
        input::implicit_curve(form, SAMPLE, session)
    })?;
    let solver = RaySolver::new(curve.polynomial());
    let rays = session.stage("sample", |session| {
        solve(|d| Ok(solver.solve(d)), directions, verb.positive, session)
    })?;
    record_stages(solver.stage_counts(), session);
    let [a, b] = curve.center();
    if !(a.is_zero() && b.is_zero()) {
        session.note(&format!(
            "coordinates are relative to the centre ({a}, {b})"
        ));
    }
    note_lines(&rays, "curve", session);
    write_result(session, |out| {
        write_samples(&rays, curve.center(), format, out)
    })
}

/// Lemmas 7 to 10 and Theorem 6 at single directions: all real R of f(R u, R v, R w).
fn sample_surface(
    surface: &ImplicitSurface,
    directions: Vec<SpaceDirection>,
    positive: bool,
    format: Format,
    session: &mut Session,
) -> Result<()> {
    let polynomial = SpacePolynomial::from(surface.polynomial());
    session.check_degree(polynomial.degree().unwrap_or(0))?;
    let solver = RaySolver::new(&polynomial);
    let rays = session.stage("sample", |session| {
        solve(|d| Ok(solver.solve(d)), directions, positive, session)
    })?;
    record_stages(solver.stage_counts(), session);
    note_lines(&rays, "surface", session);
    let origin = [Rational::zero(), Rational::zero()];
    write_result(session, |out| write_samples(&rays, &origin, format, out))
}

/// The curve in which two surfaces meet, arc by arc.
fn sample_intersection(
    surfaces: &[ImplicitSurface],
    verb: &Sample,
    format: Format,
    session: &mut Session,
) -> Result<()> {
    let given = [
        ("--directions", verb.directions.is_some()),
        ("--theta", !verb.theta.is_empty()),
        ("--phi", !verb.phi.is_empty()),
        ("--positive", verb.positive),
    ];
    if let Some((name, _)) = given.iter().find(|(_, given)| *given) {
        return Err(Error::Usage(format!(
            "{name} is for rays from the origin; the curve in which two surfaces meet is followed along itself, in steps of --resolution"
        )));
    }
    let window = arcs::window(&verb.arcs)?;
    let found = arcs::arcs(surfaces, window, verb.arcs.resolution, session)?;
    for line in arcs_text(&found) {
        session.note(&line);
    }
    write_result(session, |out| write_arcs(&found, format, out))
}

/// How many directions were decided in how many bits.
fn record_stages(counts: StageCounts, session: &mut Session) {
    let bounded = StageCounts::BITS.iter().zip(counts.bounded);
    let mut rays: serde_json::Map<String, serde_json::Value> = bounded
        .map(|(bits, count)| (format!("{bits}_bits"), count.into()))
        .collect();
    rays.insert("exact".into(), counts.exact.into());
    session.record("rays", rays.into());
}

fn note_lines<D: NominalAngles<V>, const V: usize>(
    rays: &[SampledRay<D, V>],
    what: &str,
    session: &Session,
) {
    for ray in rays.iter().filter(|r| r.ray == Ray::Line) {
        let place = match ray.direction.angles() {
            (theta, None) => format!("theta = {theta}"),
            (theta, Some(phi)) => format!("theta = {theta}, phi = {phi}"),
        };
        session.note(&format!(
            "the whole line at {place} belongs to the {what}: it has no rows"
        ));
    }
}

fn check_count(count: usize) -> Result<()> {
    match count {
        0 => Err(Error::Usage(
            "--directions 0: at least one is needed".into(),
        )),
        count if count > MAX_DIRECTIONS => Err(Error::Limit {
            limit: format!("--directions {count}: at most {MAX_DIRECTIONS} directions"),
            finished: String::new(),
        }),
        _ => Ok(()),
    }
}

/// Every given θ with every given φ. Where only one of them is given, the other one goes all the way,
/// in `count` steps; where none is, the directions are spread evenly over the sphere.
fn space_directions(
    count: Option<usize>,
    thetas: &[Direction],
    phis: &[Direction],
) -> Result<Vec<SpaceDirection>> {
    if thetas.is_empty() && phis.is_empty() {
        return Ok(SpaceDirection::fibonacci(
            count.unwrap_or(DEFAULT_DIRECTIONS),
        ));
    }
    let around = || Direction::around(count.unwrap_or(DEFAULT_DIRECTIONS));
    let thetas = match thetas {
        [] => around(),
        given => given.to_vec(),
    };
    let phis = match phis {
        [] => meridian(count.unwrap_or(DEFAULT_POLAR_STEPS)),
        given => given.to_vec(),
    };
    check_count(thetas.len().saturating_mul(phis.len()))?;
    let pairs = thetas.iter().flat_map(|theta| {
        let along = phis.iter();
        along.map(|phi| SpaceDirection::new(theta.clone(), phi.clone()))
    });
    Ok(pairs.collect())
}

/// φ = 0°, …, 180° in `steps` steps.
fn meridian(steps: usize) -> Vec<Direction> {
    let mut around = Direction::around(2 * steps);
    around.truncate(steps + 1);
    around
}

pub(super) fn angles(flag: &str, texts: &[String]) -> Result<Vec<Direction>> {
    texts.iter().map(|text| angle(flag, text)).collect()
}

/// Radians, or degrees with the suffix `deg`.
fn angle(flag: &str, text: &str) -> Result<Direction> {
    let wrong = || {
        Error::Usage(format!(
            "{flag} {text}: expected radians such as 0.5, or degrees such as 219.5deg"
        ))
    };
    let trimmed = text.trim();
    if let Some(degrees) = trimmed.strip_suffix("deg") {
        return Ok(Direction::from_degrees(
            &exact_literal(degrees).map_err(|_| wrong())?,
        ));
    }
    let radians = exact_literal(trimmed).map_err(|_| wrong())?.to_f64();
    if radians.is_finite() && radians.abs() <= 1e9 {
        Ok(Direction::from_radians(radians))
    } else {
        Err(wrong())
    }
}

fn solve<D: NominalAngles<V> + Send, const V: usize>(
    solver: impl Fn(&D) -> Result<Ray<V>> + Sync,
    directions: Vec<D>,
    positive: bool,
    session: &Session,
) -> Result<Vec<SampledRay<D, V>>> {
    let bar = session.progress(directions.len(), "directions");
    let rays = directions
        .into_par_iter()
        .map(|direction| {
            session.limits.check()?;
            let mut ray = solver(&direction)?;
            if positive && let Ray::Points(points) = &mut ray {
                points.retain(|p| p.r > 0.0);
            }
            bar.inc(1);
            Ok(SampledRay { direction, ray })
        })
        .collect();
    bar.finish_and_clear();
    rays
}
