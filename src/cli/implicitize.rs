//! `stellate implicitize`: Theorems 1 to 4, and canonical forms of what is implicit already.

use stellate::document::{Annotations, Format, write_implicit, write_intersection, write_surface};
use stellate::error::{Error, Result};
use stellate::implicitize::{
    SquaredForm, implicitize_patch, implicitize_plane, implicitize_space_curve, point_beyond,
    polar_patch, polar_plane, polar_space_curve, real_image,
};
use stellate::shape::{Form, FourierRadius, ImplicitSurface, Patch, PlaneCurve, SpaceCurve};

use super::arguments::{Coordinates, Implicitize, ImplicitizeMethod, Scale};
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

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
        let equation = implicitize_plane(&radius.to_plane_curve(), &session.limits)?;
        let annotations = Annotations::of_plane(&equation);
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
    let polar = polar
        .then(|| polar_plane(curve, &session.limits))
        .transpose()?;
    let equation = implicitize_plane(curve, &session.limits)?;
    let mut annotations = Annotations::of_plane(&equation);
    let image = real_image(curve, equation.tracing_index, &session.limits)?;
    annotations.add_real_image(curve, &image);
    let curve = match polar {
        Some(polar) => {
            annotations.add_polar_plane(&polar);
            polar.curve
        }
        None => equation.curve,
    };
    Ok((Form::Curve(curve), annotations))
}

pub(crate) fn of_space_curve(
    curve: &SpaceCurve,
    polar: bool,
    session: &Session,
) -> Result<(Form, Annotations)> {
    let polar = polar
        .then(|| polar_space_curve(curve, &session.limits))
        .transpose()?;
    let equations = implicitize_space_curve(curve, &session.limits)?;
    let mut annotations = Annotations::of_space_curve(&equations);
    let image = real_image(curve, equations.tracing_index, &session.limits)?;
    annotations.add_real_image(curve, &image);
    if let Some(polar) = polar {
        annotations.add_polar_space_curve(&polar);
    }
    Ok((Form::Intersection(equations.surfaces), annotations))
}

pub(crate) fn of_patch(
    patch: &Patch,
    polar: bool,
    session: &Session,
) -> Result<(Form, Annotations)> {
    let polar = polar
        .then(|| polar_patch(patch, &session.limits))
        .transpose()?;
    let equation = implicitize_patch(patch, &session.limits)?;
    let mut annotations = Annotations::of_patch(&equation);
    annotations.add_point_beyond(point_beyond(patch, &equation.surface).as_ref());
    let surface = match polar {
        Some(polar) => {
            annotations.add_polar_patch(&polar);
            polar.surface
        }
        None => equation.surface,
    };
    Ok((Form::Surface(surface), annotations))
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
