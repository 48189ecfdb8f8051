//! `stellate parametrize`: back to r(θ).

use stellate::document::{
    Format, WrittenDirection, WrittenMeridian, write_arcs, write_intersection_curves,
    write_parametrization, write_surface_parametrization,
};
use stellate::error::{Error, Result};
use stellate::implicitize::SquaredForm;
use stellate::limits::Limits;
use stellate::parametrize::{
    Branch, BranchFit, BranchFitOptions, DEFAULT_HARMONICS, Parametrization, PolarMethod, Radius,
    fit_branch, parametrize, parametrize_intersection, parametrize_space_superquadric,
    parametrize_superquadric, parametrize_surface,
};
use stellate::sample::{RaySolver, SpaceDirection};
use stellate::shape::{Form, FourierRadius, ImplicitSurface};

use super::arcs;
use super::arguments::{ArcFlags, FitFlags, Parametrize};
use super::input;
use super::output::{check_destination, write_result};
use super::sample::angles;
use super::session::Session;

pub(crate) fn run(verb: &Parametrize, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    format.check_fourier()?;
    let input = input::read(&verb.form, session)?;
    // What a fit of a branch (Lemma 6) should be like, for a form that is exact already.
    let is_exact = matches!(input.content, input::Content::Exact(_));
    let fitted = if is_exact {
        input::refuse_contour_flags(&verb.fit)?;
        input::exact_form(input, &FitFlags::default(), session)?
    } else {
        input::exact_form(input, &verb.fit, session)?
    };
    let form = input::through_equation(fitted.form, session)?;
    if let Form::Surface(surface) = &form {
        arcs::refuse(&verb.arcs)?;
        return surface_form(surface, verb, format, session);
    }
    if let Form::Intersection(surfaces) = &form {
        return intersection(surfaces, &verb.arcs, format, session);
    }
    arcs::refuse(&verb.arcs)?;
    if let Form::SpaceSuperquadric(shape) = &form {
        if !verb.theta.is_empty() {
            return Err(Error::Usage(
                "--theta and --phi ask where R is real; that of a superquadric is real and positive in every direction".into(),
            ));
        }
        let spherical = parametrize_space_superquadric(shape);
        let digits = session.decimals();
        return write_result(session, |out| {
            write_surface_parametrization(&spherical, &[], &[], digits, format, out)
        });
    }
    if !verb.theta.is_empty() {
        return Err(Error::Usage(
            "--theta and --phi are for surfaces: the ranges of a plane curve are over theta and given in full".into(),
        ));
    }
    let parametrization = session.stage("parametrize", |session| match &form {
        Form::Fourier(radius) => {
            session.check_degree(2 * radius.harmonics() + 2)?;
            of_radius(radius, &session.limits)
        }
        Form::Curve(curve) => {
            session.check_degree(curve.polynomial().degree().unwrap_or(0))?;
            parametrize(curve, &session.limits)
        }
        Form::Superquadric(shape) => Ok(parametrize_superquadric(shape)),
        _ => Err(input::not_taken(
            "parametrize",
            "plane curves, surfaces and intersections of surfaces",
        )),
    })?;
    let fit = branch_fit(verb, is_exact, &parametrization, session)?;
    let is_series = |b: &Branch| matches!(b.radius, Radius::Fourier(_));
    let has_series = parametrization.branches.first().is_some_and(is_series)
        || fit.is_some() && parametrization.method == PolarMethod::Numeric;
    if format == Format::Csv && !has_series {
        return Err(Error::Usage(
            "--format csv: only a radius that is a Fourier series is a table of coefficients; text, json, latex, sympy and maple write closed forms".into(),
        ));
    }
    let digits = session.decimals();
    write_result(session, |out| {
        write_parametrization(&parametrization, fit.as_ref(), digits, format, out)
    })
}

/// Theorem 6: R(θ, φ), and the exact answers on the meridians and in the directions that are asked for.
fn surface_form(
    surface: &ImplicitSurface,
    verb: &Parametrize,
    format: Format,
    session: &mut Session,
) -> Result<()> {
    let given = [
        ("--branch", verb.branch.is_some()),
        ("--harmonics", verb.fit.harmonics.is_some()),
        ("--samples", verb.fit.samples.is_some()),
        ("--decimals", verb.fit.decimals.is_some()),
    ];
    if let Some((name, _)) = given.iter().find(|(_, given)| *given) {
        return Err(Error::Usage(format!(
            "{name} belongs to Fourier series of plane radii; this is a surface"
        )));
    }
    let degree = surface.polynomial().degree().unwrap_or(0);
    session.check_degree(usize::try_from(degree).unwrap_or(usize::MAX))?;
    let thetas = angles("--theta", &verb.theta)?;
    let phis = angles("--phi", &verb.phi)?;
    let spherical = session.stage("parametrize", |session| {
        parametrize_surface(surface, &session.limits)
    })?;
    let (meridians, directions) = session.stage("ranges", |session| -> Result<_> {
        if phis.is_empty() {
            let meridians = thetas.iter().map(|theta| {
                Ok(WrittenMeridian {
                    branches: spherical.on_meridian(theta, &session.limits)?,
                    theta: theta.clone(),
                })
            });
            return Ok((meridians.collect::<Result<_>>()?, Vec::new()));
        }
        let pairs = thetas.iter().flat_map(|theta| {
            let along = phis.iter();
            along.map(|phi| SpaceDirection::new(theta.clone(), phi.clone()))
        });
        let answers = pairs.map(|direction| {
            let factors = spherical.factors.iter();
            WrittenDirection {
                answer: spherical.in_direction(&direction),
                rays: factors
                    .map(|f| RaySolver::new(&f.polynomial).solve(&direction))
                    .collect(),
                direction,
            }
        });
        Ok((Vec::new(), answers.collect()))
    })?;
    let digits = session.decimals();
    write_result(session, |out| {
        write_surface_parametrization(&spherical, &meridians, &directions, digits, format, out)
    })
}

/// Theorem 7: the curve where surfaces meet; certified arcs of the components that have no parametrization.
fn intersection(
    surfaces: &[ImplicitSurface],
    flags: &ArcFlags,
    format: Format,
    session: &mut Session,
) -> Result<()> {
    let window = arcs::window(flags)?;
    let found = session.stage("parametrize", |session| {
        parametrize_intersection(surfaces, &session.limits)
    })?;
    let has_room = matches!(format, Format::Text | Format::Json | Format::Csv);
    if found.curves.is_empty() && (!has_room || surfaces.len() > 2) {
        let reasons = found.others.iter().map(|other| other.reason.as_str());
        let reasons: Vec<&str> = reasons.collect();
        return Err(Error::Hypothesis {
            statement: "Theorem 7 with a rational or trigonometric relation",
            witness: if reasons.is_empty() {
                "the surfaces do not meet in a curve with a projection".into()
            } else {
                reasons.join("; ")
            },
        });
    }
    if found.others.is_empty() && !found.curves.is_empty() {
        if flags.window.is_some() || flags.resolution.is_some() {
            session.note("every component has an exact parametrization: --window and --resolution are for arcs of the others");
        }
        return write_result(session, |out| {
            write_intersection_curves(&found, None, format, out)
        });
    }
    let traced = if has_room && surfaces.len() == 2 {
        let mut traced = arcs::arcs(surfaces, window, flags.resolution, session)?;
        let over: Vec<_> = found.others.iter().map(|o| &o.projection).collect();
        if !found.curves.is_empty() {
            traced.retain_on(&over);
        }
        Some(traced)
    } else {
        session.note("components without a parametrization are left out: text, json and csv have arcs of them, for two surfaces");
        None
    };
    match &traced {
        Some(traced) if format == Format::Csv => {
            write_result(session, |out| write_arcs(traced, format, out))
        }
        traced => write_result(session, |out| {
            write_intersection_curves(&found, traced.as_ref(), format, out)
        }),
    }
}

/// The Fourier fit of a branch without a closed form, if there is one.
fn branch_fit(
    verb: &Parametrize,
    is_exact: bool,
    curve: &Parametrization,
    session: &mut Session,
) -> Result<Option<BranchFit>> {
    let is_root = |b: &Branch| matches!(&b.radius, Radius::Root(root) if !root.is_point());
    if !curve.branches.iter().any(is_root) {
        let given = [
            ("--branch", verb.branch.is_some()),
            ("--harmonics", is_exact && verb.fit.harmonics.is_some()),
            ("--samples", is_exact && verb.fit.samples.is_some()),
            ("--decimals", is_exact && verb.fit.decimals.is_some()),
        ];
        return match given.iter().find(|(_, given)| *given) {
            Some((name, _)) => Err(Error::Usage(format!(
                "{name} is for contours and for branches without a closed form (Lemma 6); the radii of this form are exact"
            ))),
            None => Ok(None),
        };
    }
    let options = BranchFitOptions {
        branch: verb.branch,
        harmonics: verb.fit.harmonics.unwrap_or(DEFAULT_HARMONICS),
        samples: verb.fit.samples,
        decimals: verb.fit.decimals,
    };
    let fit = session.stage("fit", |session| {
        fit_branch(curve, &options, &session.limits)
    })?;
    match &fit {
        None => session.note("no positive radius without a closed form covers the full circle: there is no Fourier fit"),
        Some(fit) if !fit.jumps.is_empty() => session.note(&format!(
            "no branch covers the full circle: the outermost positive radius is fitted, which jumps between branches (angles: {})",
            fit.jumps.len()
        )),
        Some(_) => {}
    }
    Ok(fit)
}

/// A radius is parametric already; its document lists the branches of its implicit equation.
fn of_radius(radius: &FourierRadius, limits: &Limits) -> Result<Parametrization> {
    let mut curve = parametrize(&SquaredForm::new(radius)?.expand(), limits)?;
    // Both describe the same points; the one that was given comes first.
    let is_given = |b: &Branch| matches!(&b.radius, Radius::Fourier(r) if r == radius);
    if let Some(given) = curve.branches.iter().position(is_given) {
        curve.branches.swap(0, given);
    }
    Ok(curve)
}
