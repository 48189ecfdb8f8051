//! `stellate implicitize`: Theorems 1 to 4, and canonical forms of what is implicit already.

use stellate::document::{Annotations, Format, write_implicit, write_intersection, write_surface};
use stellate::error::{Error, Result};
use stellate::implicitize::{
    Run, SquaredForm, implicitize_patch, implicitize_plane, implicitize_space_curve, point_beyond,
    polar_patch, polar_plane, polar_space_curve, real_counts, real_image,
};
use stellate::limits::Limits;
use stellate::shape::{
    Form, FourierRadius, ImplicitSurface, ParametricCurve, Patch, PlaneCurve, SpaceCurve,
};

use super::arguments::{Coordinates, Implicitize, ImplicitizeMethod, Scale};
use super::input;
use super::output::{check_destination, write_result};
use super::session::{Session, missing_note};

/// What may be missing at a limit.
const BEYOND_CURVE: &str = "what the real zero set has beyond the curve, isolated points among it, and the real tracing index";
const BEYOND_PATCH: &str = "a point of the zero set beyond the patch";
const POLAR: [&str; 3] = [
    "Eq. (1) of Theorem 1 and its factors",
    "Eqs. (10) and (11) of Theorem 3 and their factors",
    "Eq. (15) of Theorem 4 and its factors",
];

pub(crate) fn run(verb: &Implicitize, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    let input = input::read(&verb.form, session)?;
    let fitted = input::exact_form(input, &verb.fit, session)?;
    refuse_method(verb, &fitted.form)?;
    let (form, annotations) = session.stage("implicitize", |session| {
        let (form, annotations) = equation(fitted.form, verb, session)?;
        Ok((scaled(form, verb), annotations))
    })?;
    match form {
        Form::Curve(curve) => {
            session.check_degree(curve.polynomial().degree().unwrap_or(0))?;
            write_result(session, |out| {
                write_implicit(&curve, &annotations, format, out)
            })
        }
        Form::Surface(surface) => write_result(session, |out| {
            write_surface(&surface, &annotations, format, out)
        }),
        Form::Intersection(surfaces) => {
            if format == Format::Csv {
                return Err(Error::Usage(
                    "--format csv: several equations are written as text, json, latex, sympy, maple or singular".into(),
                ));
            }
            write_result(session, |out| {
                write_intersection(&surfaces, &annotations, format, out)
            })
        }
        _ => Err(Error::Usage("this form has no implicit equation".into())),
    }
}

/// `--method` chooses among ways from a parametric form.
fn refuse_method(verb: &Implicitize, form: &Form) -> Result<()> {
    let Some(method) = verb.method else {
        return Ok(());
    };
    let message = match (method, form) {
        (
            _,
            Form::Curve(_)
            | Form::Surface(_)
            | Form::Intersection(_)
            | Form::Superquadric(_)
            | Form::SpaceSuperquadric(_),
        ) => "--method is for parametric forms; this one is implicit already",
        (ImplicitizeMethod::Resultant, Form::SpaceCurve(_) | Form::Patch(_)) => {
            "--method resultant is for plane curves; in space the default is certified linear algebra, and polar \
             the paper's way"
        }
        _ => return Ok(()),
    };
    Err(Error::Usage(message.into()))
}

/// The implicit form, not yet scaled.
fn equation(form: Form, verb: &Implicitize, session: &Session) -> Result<(Form, Annotations)> {
    let polar = verb.method == Some(ImplicitizeMethod::Polar);
    let plain = Annotations::default();
    Ok(match form {
        Form::Fourier(radius) => of_radius(&radius, verb, session)?,
        Form::Superquadric(shape) => (Form::Curve(input::polynomial_of(&shape)?), plain),
        Form::SpaceSuperquadric(shape) => {
            let surface = ImplicitSurface::new(shape.polynomial()?);
            (Form::Surface(surface), plain)
        }
        Form::PlaneCurve(curve) => of_plane_curve(&curve, polar, session)?,
        Form::SpaceCurve(curve) => of_space_curve(&curve, polar, session)?,
        Form::Patch(patch) => of_patch(&patch, polar, session)?,
        implicit => (implicit, plain),
    })
}

fn of_radius(
    radius: &FourierRadius,
    verb: &Implicitize,
    session: &Session,
) -> Result<(Form, Annotations)> {
    session.check_degree(2 * radius.harmonics() + 2)?;
    if verb.method == Some(ImplicitizeMethod::Resultant) {
        let parametric = radius.to_plane_curve();
        let equation = implicitize_plane(&parametric, &session.limits)?;
        let mut annotations = Annotations::of_plane(&equation, Run::of(&parametric));
        let counts = real_counts(&parametric, equation.tracing_index, &session.limits)?;
        annotations.add_real_tracing(
            counts.as_deref(),
            Run::of(&parametric),
            equation.tracing_index,
        );
        let curve = equation.curve.with_center(radius.center().clone());
        return Ok((Form::Curve(curve), annotations));
    }
    let form = SquaredForm::new(radius)?;
    let mut annotations = Annotations::default();
    if form.is_perfect_square() {
        let remark = "F of Theorem 2 is a perfect square (a0 = 0 and only odd harmonics): this is its reduced equation";
        annotations.notes.push(remark.into());
        session.note(remark);
    }
    Ok((Form::Curve(form.expand()), annotations))
}

pub(crate) fn of_plane_curve(
    curve: &PlaneCurve,
    polar: bool,
    session: &Session,
) -> Result<(Form, Annotations)> {
    let equation = implicitize_plane(curve, &session.limits)?;
    let run = Run::of(curve);
    let mut annotations = Annotations::of_plane(&equation, run);
    add_real_image(
        curve,
        equation.tracing_index,
        run,
        &mut annotations,
        session,
    )?;
    if polar {
        let whole = curve.clone();
        let work = move |limits: &Limits| polar_plane(&whole, limits);
        match session.unless_limited(POLAR[0], work)? {
            Some(polar) => {
                annotations.add_polar_plane(&polar);
                return Ok((Form::Curve(polar.curve), annotations));
            }
            None => annotations.notes.push(missing_note(POLAR[0])),
        }
    }
    Ok((Form::Curve(equation.curve), annotations))
}

pub(crate) fn of_space_curve(
    curve: &SpaceCurve,
    polar: bool,
    session: &Session,
) -> Result<(Form, Annotations)> {
    let equations = implicitize_space_curve(curve, &session.limits)?;
    let run = Run::of(curve);
    let mut annotations = Annotations::of_space_curve(&equations, run);
    add_real_image(
        curve,
        equations.tracing_index,
        run,
        &mut annotations,
        session,
    )?;
    if polar {
        let whole = curve.clone();
        let work = move |limits: &Limits| polar_space_curve(&whole, limits);
        match session.unless_limited(POLAR[1], work)? {
            Some(polar) => annotations.add_polar_space_curve(&polar),
            None => annotations.notes.push(missing_note(POLAR[1])),
        }
    }
    Ok((Form::Intersection(equations.surfaces), annotations))
}

pub(crate) fn of_patch(
    patch: &Patch,
    polar: bool,
    session: &Session,
) -> Result<(Form, Annotations)> {
    let equation = implicitize_patch(patch, &session.limits)?;
    let mut annotations = Annotations::of_patch(&equation, Run::of_patch(patch));
    let whole = (patch.clone(), equation.surface.clone());
    let work = move |_: &Limits| Ok(point_beyond(&whole.0, &whole.1));
    match session.unless_limited(BEYOND_PATCH, work)? {
        Some(found) => annotations.add_point_beyond(found.as_ref()),
        None => annotations.notes.push(missing_note(BEYOND_PATCH)),
    }
    if polar {
        let whole = patch.clone();
        let work = move |limits: &Limits| polar_patch(&whole, limits);
        match session.unless_limited(POLAR[2], work)? {
            Some(polar) => {
                annotations.add_polar_patch(&polar);
                return Ok((Form::Surface(polar.surface), annotations));
            }
            None => annotations.notes.push(missing_note(POLAR[2])),
        }
    }
    Ok((Form::Surface(equation.surface), annotations))
}

/// What the zero set has beyond the curve, and how often real values of the parameter run over it.
fn add_real_image<const N: usize>(
    curve: &ParametricCurve<N>,
    tracing_index: usize,
    run: Run,
    annotations: &mut Annotations,
    session: &Session,
) -> Result<()> {
    let whole = curve.clone();
    let work = move |limits: &Limits| real_image(&whole, tracing_index, limits);
    match session.unless_limited(BEYOND_CURVE, work)? {
        Some(image) => annotations.add_real_image(curve, &image, run, tracing_index),
        None => annotations.notes.push(missing_note(BEYOND_CURVE)),
    }
    Ok(())
}

fn scaled(form: Form, verb: &Implicitize) -> Form {
    let surface = |surface: &ImplicitSurface| {
        let f = surface.polynomial();
        ImplicitSurface::new(match verb.scale {
            Scale::Integer => f.primitive(),
            Scale::Monic => f.monic(),
        })
    };
    match form {
        Form::Curve(curve) => {
            let curve = match verb.coordinates {
                Coordinates::Centre => curve,
                Coordinates::Original => curve.in_original_coordinates(),
            };
            Form::Curve(curve.map_polynomial(|f| match verb.scale {
                Scale::Integer => f.into_primitive(),
                Scale::Monic => f.monic(),
            }))
        }
        Form::Surface(s) => Form::Surface(surface(&s)),
        Form::Intersection(all) => Form::Intersection(all.iter().map(surface).collect()),
        other => other,
    }
}
