//! `stellate sample`: certified points.

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use stellate::document::{Format, SampledRay, write_samples};
use stellate::error::{Error, Result};
use stellate::exact::Rational;
use stellate::exact::exact_literal;
use stellate::implicitize::SquaredForm;
use stellate::sample::{Direction, Ray, RaySolver, SuperquadricSolver};
use stellate::shape::{Form, ImplicitCurve};

use super::arguments::Sample;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

const DEFAULT_DIRECTIONS: usize = 360;
const MAX_DIRECTIONS: usize = 10_000_000;

pub(crate) fn run(verb: &Sample, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Csv);
    if !matches!(format, Format::Csv | Format::Json) {
        return Err(Error::Usage(format!(
            "--format {format}: points are written as csv or json"
        )));
    }
    let directions = directions(verb)?;
    let input = input::read(&verb.form, session)?;
    let fitted = input::exact_form(input, &verb.fit, session)?;
    if let Form::Superquadric(shape) = &fitted.form {
        let solver = SuperquadricSolver::new(shape);
        let rays = session.stage("sample", |session| {
            solve(|d| solver.solve(d), directions, verb.positive, session)
        })?;
        let origin = [Rational::zero(), Rational::zero()];
        return write_result(session, |out| write_samples(&rays, &origin, format, out));
    }
    let form = input::through_equation(fitted.form, session)?;
    let curve = session.stage("implicitize", |session| curve(form, session))?;
    let solver = RaySolver::new(curve.polynomial());
    let rays = session.stage("sample", |session| {
        solve(|d| Ok(solver.solve(d)), directions, verb.positive, session)
    })?;
    let [a, b] = curve.center();
    if !(a.is_zero() && b.is_zero()) {
        session.note(&format!(
            "coordinates are relative to the centre ({a}, {b})"
        ));
    }
    for ray in rays.iter().filter(|r| r.ray == Ray::Line) {
        session.note(&format!(
            "the whole line at theta = {} belongs to the curve: it has no rows",
            ray.direction.theta()
        ));
    }
    write_result(session, |out| {
        write_samples(&rays, curve.center(), format, out)
    })
}

fn directions(verb: &Sample) -> Result<Vec<Direction>> {
    let count = match verb.directions {
        Some(0) => {
            return Err(Error::Usage(
                "--directions 0: at least one is needed".into(),
            ));
        }
        Some(count) if count > MAX_DIRECTIONS => {
            return Err(Error::Limit {
                limit: format!("--directions {count}: at most {MAX_DIRECTIONS} directions"),
                finished: String::new(),
            });
        }
        Some(count) => count,
        None if verb.theta.is_empty() => DEFAULT_DIRECTIONS,
        None => 0,
    };
    let mut directions = Direction::around(count);
    for text in &verb.theta {
        directions.push(angle(text)?);
    }
    Ok(directions)
}

/// Radians, or degrees with the suffix `deg`.
fn angle(text: &str) -> Result<Direction> {
    let wrong = || {
        Error::Usage(format!(
            "--theta {text}: expected radians such as 0.5, or degrees such as 219.5deg"
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

fn curve(form: Form, session: &Session) -> Result<ImplicitCurve> {
    match form {
        Form::Fourier(radius) => {
            session.check_degree(2 * radius.harmonics() + 2)?;
            Ok(SquaredForm::new(&radius)?.expand())
        }
        Form::Curve(curve) => {
            session.check_degree(curve.polynomial().degree().unwrap_or(0))?;
            Ok(curve)
        }
        Form::Superquadric(shape) => input::polynomial_of(&shape),
        _ => Err(input::plane_only("sample")),
    }
}

fn solve(
    solver: impl Fn(&Direction) -> Result<Ray> + Sync,
    directions: Vec<Direction>,
    positive: bool,
    session: &Session,
) -> Result<Vec<SampledRay>> {
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
