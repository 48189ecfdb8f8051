//! The verb `sample`: certified points of a form.

use super::arcs::{ArcSearch, arcs, refuse_arcs};
use super::claims::{claim_arcs, claim_left_out, claim_rays, claim_superquadric_rays};
use super::equation::{
    Taken, check_surface, equation_and_coverage, implicit_curve, squared_harmonics,
    through_equation,
};
use super::fit::exact_form;
use super::{CoordinatesFrom, Given, Remark, Work};
use crate::arcs::IntersectionArcs;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::fit::FitOptions;
use crate::implicitize::Coverage;
use crate::options::options;
use crate::parallel;
use crate::sample::{
    Direction, HomogeneousParts, NominalAngles, Ray, RaySolver, RealParameters, Sample, SampledRay,
    SpaceDirection, StageCounts, harmonic_ray, solve_radial,
};
use crate::shape::{Form, HarmonicPair, HarmonicSurface, ImplicitSurface};
use crate::witness::{curve_form, surface_form};

const DEFAULT_DIRECTIONS: usize = 360;
/// The default number of steps along a meridian, from pole to pole.
const DEFAULT_POLAR_STEPS: usize = 180;
/// The largest number of directions.
pub const MAX_DIRECTIONS: usize = 10_000_000;

options! {
    /// The directions in which a form is sampled.
    SampleOptions {
        /// How a contour is fitted.
        fit: FitOptions = FitOptions::default(),
        /// The number of directions around the circle, or spread over the sphere: 360 if no angle is given. If only one of the
        /// two angles of a surface is given, the number of steps of the other.
        directions: Option<usize> = None,
        /// The angles θ.
        thetas: Vec<Direction> = Vec::new(),
        /// For a surface: the angles φ from the z axis. Every θ is combined with every φ.
        phis: Vec<Direction> = Vec::new(),
        /// The origin of the coordinates of points, for a form with a center.
        coordinates: CoordinatesFrom = CoordinatesFrom::Center,
        /// Whether only points with r > 0 are returned.
        positive: bool = false,
        /// For an intersection: how its arcs are followed.
        arcs: ArcSearch = ArcSearch::default(),
    }
}

/// Certified points of a form.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Samples {
    /// The points.
    pub points: SampledPoints,
    /// The number of rays that each precision decided, if the form is sampled by rays.
    pub counts: Option<StageCounts>,
}

/// The kinds of certified points.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum SampledPoints {
    /// The points of a plane curve, ray by ray.
    Plane {
        /// The rays.
        rays: Vec<SampledRay>,
        /// The origin of the coordinates.
        center: [Rational; 2],
    },
    /// The points of a surface, ray by ray.
    Space {
        /// The rays.
        rays: Vec<SampledRay<SpaceDirection, 3>>,
        /// The origin of the coordinates.
        center: [Rational; 3],
    },
    /// The points of the curve in which two surfaces meet, arc by arc.
    Arcs(IntersectionArcs),
}

/// The forms that this verb takes.
const SAMPLE: Taken = Taken {
    verb: "sample",
    these: "plane curves, surfaces and intersections of two surfaces",
};

/// Finds all real points of a form in exact directions. Each coordinate is the double nearest to the exact one, and the number
/// of points is proved. A direction is a whole line, so that r may be negative, and directions all around find each point twice;
/// [`SampleOptions::positive`] keeps r ≥ 0. Of a parametric plane curve these are the points that real parameters have, and the limit
/// for an infinite parameter; of a patch they are the points of its equation.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::verb::{self, Given, SampleOptions, SampledPoints, Work};
/// let given = Given::read("x^2 + y^2 = 4", Numbers::Exact)?;
/// let found = verb::sample(given, &SampleOptions::default().directions(Some(4)), &Work::default())?;
/// let SampledPoints::Plane { rays, .. } = found.points else { unreachable!() };
/// assert_eq!(rays.len(), 4);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// Cost: about 5 µs for a ray of degree 80 that 128 bits decide, more for rays that nearly touch the form.
///
/// # Errors
/// [`Error::Usage`] for a form that has no points in directions, or for an option that the form does not have; [`Error::Limit`]
/// beyond [`MAX_DIRECTIONS`].
pub fn sample(given: Given, options: &SampleOptions, work: &Work) -> Result<Samples> {
    check_count(options.directions.unwrap_or(1))?;
    let fitted = exact_form(given, &options.fit, work)?;
    if let Form::Harmonic(surface) = &fitted.form {
        refuse_arcs(&options.arcs)?;
        return of_harmonics(surface, options, work);
    }
    let mut parameters = None;
    let form = match fitted.form {
        Form::PlaneCurve(curve) => {
            let (equation, coverage) = equation_and_coverage(&curve, work)?;
            let is_whole = matches!(coverage, Coverage::Whole);
            parameters = Some(RealParameters::new(&curve, is_whole));
            Form::Curve(equation)
        }
        shape @ (Form::Superquadric(_) | Form::SpaceSuperquadric(_)) => shape,
        other => through_equation(other, work)?,
    };
    if let Form::Intersection(surfaces) = &form {
        return of_intersection(surfaces, options, work);
    }
    refuse_arcs(&options.arcs)?;
    if let Form::Surface(surface) = &form {
        return of_surface(surface, options, work);
    }
    if let Form::SpaceSuperquadric(shape) = &form {
        let directions = space_directions(options)?;
        let rays = solve(|d| solve_radial(shape, d), directions, work)?;
        work.claim(|proof| {
            let level = std::slice::from_ref(shape.level());
            let epsilon = shape.epsilon().as_slice();
            claim_superquadric_rays(proof, [shape.semi_axes(), epsilon, level], &rays);
            Ok(())
        })?;
        let rays = kept(rays, options);
        let center = std::array::from_fn(|_| Rational::zero());
        return Ok(uncounted(SampledPoints::Space { rays, center }));
    }
    if !options.phis.is_empty() {
        return Err(Error::Usage(
            "--phi is the polar angle of a direction in space; this is a plane curve".into(),
        ));
    }
    let mut directions = match options.directions {
        None if options.thetas.is_empty() => Direction::around(DEFAULT_DIRECTIONS),
        count => Direction::around(count.unwrap_or(0)),
    };
    directions.extend(options.thetas.iter().cloned());
    if let Form::Superquadric(shape) = &form {
        let rays = solve(|d| solve_radial(shape, d), directions, work)?;
        work.claim(|proof| {
            let [epsilon, level] = [shape.epsilon(), shape.level()].map(std::slice::from_ref);
            claim_superquadric_rays(proof, [shape.semi_axes(), epsilon, level], &rays);
            Ok(())
        })?;
        let rays = kept(rays, options);
        let center = [Rational::zero(), Rational::zero()];
        return Ok(uncounted(SampledPoints::Plane { rays, center }));
    }
    let curve = work.stage("implicitize", || implicit_curve(form, &SAMPLE, work))?;
    let [center, from] = ends(curve.center(), options.coordinates);
    let solver = RaySolver::new(curve.polynomial()).about(from);
    let rays = solve(|d| Ok(solver.solve(d)), directions, work)?;
    work.claim(|proof| {
        let form = curve_form(proof, curve.polynomial());
        claim_rays(
            proof,
            form,
            curve.polynomial(),
            &solver.center(),
            &rays,
            work,
        )
    })?;
    let rays = match &parameters {
        Some(parameters) => {
            let (rays, left_out) = on_the_curve(rays, parameters, &solver, options.positive, work)?;
            if left_out > 0 {
                work.claim(|proof| {
                    claim_left_out(proof, curve.polynomial(), left_out);
                    Ok(())
                })?;
                work.remark(Remark::PointsBeyond(left_out));
            }
            rays
        }
        None => rays,
    };
    let rays = kept(rays, options);
    work.remark_center(&center);
    let are_whole = parameters.is_none_or(|known| known.have_general_points());
    remark_lines(&rays, are_whole, work);
    Ok(Samples {
        points: SampledPoints::Plane { rays, center },
        counts: Some(solver.stage_counts()),
    })
}

/// The point that the coordinates of points are relative to, and the point, in these coordinates, from which rays begin.
fn ends<const N: usize>(
    center: &[Rational; N],
    coordinates: CoordinatesFrom,
) -> [[Rational; N]; 2] {
    let origin = std::array::from_fn(|_| Rational::zero());
    match coordinates {
        CoordinatesFrom::Center => [center.clone(), origin],
        CoordinatesFrom::Original => [origin, center.clone()],
    }
}

fn uncounted(points: SampledPoints) -> Samples {
    Samples {
        points,
        counts: None,
    }
}

/// The two radii of a harmonic surface on every line.
fn of_harmonics(
    surface: &HarmonicSurface,
    options: &SampleOptions,
    work: &Work,
) -> Result<Samples> {
    let directions = space_directions(options)?;
    let pair = HarmonicPair::new(surface);
    let [center, from] = ends(surface.center(), options.coordinates);
    let rays = solve(|d| Ok(harmonic_ray(&pair, &from, d)), directions, work)?;
    work.claim(|proof| {
        let equation = squared_harmonics(surface, work)?.expand();
        let form = surface_form(proof, equation.polynomial());
        claim_rays(proof, form, equation.by_degree(), &from, &rays, work)
    })?;
    let rays = kept(rays, options);
    work.remark_center(&center);
    Ok(uncounted(SampledPoints::Space { rays, center }))
}

/// Lemmas 7 to 10 and Theorem 6 in single directions: all real R with f(R u, R v, R w) = 0.
fn of_surface(surface: &ImplicitSurface, options: &SampleOptions, work: &Work) -> Result<Samples> {
    let directions = space_directions(options)?;
    check_surface(surface, work)?;
    let [center, from] = ends(surface.center(), options.coordinates);
    let solver = RaySolver::new(surface.by_degree()).about(from);
    let rays = solve(|d| Ok(solver.solve(d)), directions, work)?;
    work.claim(|proof| {
        let form = surface_form(proof, surface.polynomial());
        claim_rays(
            proof,
            form,
            surface.by_degree(),
            &solver.center(),
            &rays,
            work,
        )
    })?;
    let rays = kept(rays, options);
    work.remark_center(&center);
    remark_lines(&rays, true, work);
    Ok(Samples {
        points: SampledPoints::Space { rays, center },
        counts: Some(solver.stage_counts()),
    })
}

/// The points of the curve in which two surfaces meet, arc by arc.
fn of_intersection(
    surfaces: &[ImplicitSurface],
    options: &SampleOptions,
    work: &Work,
) -> Result<Samples> {
    let given = [
        ("--directions", options.directions.is_some()),
        ("--theta", !options.thetas.is_empty()),
        ("--phi", !options.phis.is_empty()),
        ("--positive", options.positive),
    ];
    if let Some((name, _)) = given.iter().find(|(_, given)| *given) {
        return Err(Error::Usage(format!(
            "{name} is for rays from the origin; the curve in which two surfaces meet is followed along itself, in steps of --resolution"
        )));
    }
    let found = arcs(surfaces, &options.arcs, work)?;
    work.claim(|proof| {
        claim_arcs(proof, surfaces, &found);
        Ok(())
    })?;
    Ok(uncounted(SampledPoints::Arcs(found)))
}

fn remark_lines<D: NominalAngles<V>, const V: usize>(
    rays: &[SampledRay<D, V>],
    are_whole: bool,
    work: &Work,
) {
    for ray in rays.iter().filter(|r| r.ray == Ray::Line) {
        let (theta, phi) = ray.direction.angles();
        work.remark(match are_whole {
            true => Remark::WholeLine { theta, phi },
            false => Remark::CurveInLine { theta },
        });
    }
}

fn check_count(count: usize) -> Result<()> {
    match count {
        0 => Err(Error::Usage(
            "--directions 0: at least one is needed".into(),
        )),
        count if count > MAX_DIRECTIONS => Err(Error::limit(format!(
            "--directions {count}: at most {MAX_DIRECTIONS} directions"
        ))),
        _ => Ok(()),
    }
}

/// Every given θ with every given φ. If only one of the two is given, the other runs through its whole range in as many steps
/// as there are directions. If neither is given, the directions are spread evenly over the sphere.
fn space_directions(options: &SampleOptions) -> Result<Vec<SpaceDirection>> {
    let count = options.directions;
    if options.thetas.is_empty() && options.phis.is_empty() {
        return Ok(SpaceDirection::fibonacci(
            count.unwrap_or(DEFAULT_DIRECTIONS),
        ));
    }
    let around = || Direction::around(count.unwrap_or(DEFAULT_DIRECTIONS));
    let thetas = match &options.thetas[..] {
        [] => around(),
        given => given.to_vec(),
    };
    let phis = match &options.phis[..] {
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

/// The directions φ = 0°, …, 180°, in `steps` steps.
fn meridian(steps: usize) -> Vec<Direction> {
    let mut around = Direction::around(2 * steps);
    around.truncate(steps + 1);
    around
}

/// The points that are asked for: all, or those with r > 0.
fn kept<D, const V: usize>(
    mut rays: Vec<SampledRay<D, V>>,
    options: &SampleOptions,
) -> Vec<SampledRay<D, V>> {
    for sampled in &mut rays {
        if let (true, Ray::Points(points)) = (options.positive, &mut sampled.ray) {
            points.retain(|p| p.r > 0.0);
        }
    }
    rays
}

/// The points of the equation of a parametric curve that are on the curve, numbered anew, and the number of the others of those that are
/// asked for.
fn on_the_curve<P: HomogeneousParts<2> + Sync>(
    mut rays: Vec<SampledRay>,
    parameters: &RealParameters,
    solver: &RaySolver<'_, P, 2>,
    positive: bool,
    work: &Work,
) -> Result<(Vec<SampledRay>, usize)> {
    let reached = work.stage("parameters", || {
        parallel::try_map(&rays, work.bounds(), |sampled| {
            Ok(match &sampled.ray {
                Ray::Points(points) => parameters.have(points, solver, &sampled.direction),
                Ray::Line => Vec::new(),
            })
        })
    })?;
    let mut left_out = 0;
    for (sampled, reached) in rays.iter_mut().zip(reached) {
        if let Ray::Points(points) = &mut sampled.ray {
            let on = std::mem::take(points).into_iter().zip(reached);
            let (on, beyond): (Vec<_>, Vec<_>) = on.partition(|(_, is_on)| *is_on);
            let numbered = on.into_iter().enumerate();
            *points = numbered
                .map(|(branch, (point, _))| Sample { branch, ..point })
                .collect();
            let beyond = beyond.iter().filter(|(p, _)| p.r > 0.0 || !positive);
            left_out += beyond.count();
        }
    }
    Ok((rays, left_out))
}

fn solve<D: NominalAngles<V> + Sync, const V: usize>(
    solver: impl Fn(&D) -> Result<Ray<V>> + Sync,
    directions: Vec<D>,
    work: &Work,
) -> Result<Vec<SampledRay<D, V>>> {
    work.stage("sample", || {
        let progress = work.progress("directions", directions.len() as u64);
        let rays = parallel::try_map(&directions, work.bounds(), |direction| {
            let ray = solver(direction)?;
            progress.add(1);
            Ok(ray)
        })?;
        let rays = directions.into_iter().zip(rays);
        let rays = rays.map(|(direction, ray)| SampledRay { direction, ray });
        Ok(rays.collect())
    })
}
