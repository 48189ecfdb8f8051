//! `stellate describe`: what a form is.

use stellate::describe::Description;
use stellate::document::{
    Annotations, Coordinates, Format, write_description, write_space_curve_description,
    write_space_superquadric_description, write_superquadric_description,
};
use stellate::error::{Error, Result};
use stellate::limits::Limits;
use stellate::shape::{Form, ImplicitCurve, ImplicitSurface};

use super::arguments::Describe;
use super::implicitize;
use super::input::{self, Content};
use super::output::{check_destination, write_result};
use super::session::{Session, missing_note};

/// What may be missing at a limit.
const FACTORS: &str = "the factors over Q";

pub(crate) fn run(verb: &Describe, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    if !matches!(format, Format::Text | Format::Json) {
        return Err(Error::Usage(format!(
            "--format {format}: a description is written as text or json"
        )));
    }
    let input = input::read(&verb.form, session)?;
    let mut annotations = Annotations::default();
    if let Content::Contour(contour) = &input.content {
        let [x, y] = contour.centroid();
        annotations.notes.push(format!(
            "a contour of {} vertices, area ≈ {}, centroid ≈ ({x}, {y}); what follows is its Fourier fit",
            contour.len(),
            contour.area()
        ));
    }
    let fitted = input::exact_form(input, &verb.fit, session)?;
    if let Some(report) = fitted.report {
        annotations.notes.push(format!(
            "radial error of the fit ≈ {:.3e} at most, ≈ {:.3e} rms",
            report.max_radial_error, report.rms_radial_error
        ));
    }
    if let Form::Superquadric(shape) = &fitted.form {
        return write_result(session, |out| {
            write_superquadric_description(shape, format, out)
        });
    }
    if let Form::SpaceSuperquadric(shape) = &fitted.form {
        return write_result(session, |out| {
            write_space_superquadric_description(shape, format, out)
        });
    }
    let form = session.stage("implicitize", |session| {
        with_equation(fitted.form, &mut annotations, session)
    })?;
    if let Form::Intersection(surfaces) = &form {
        return write_result(session, |out| {
            write_space_curve_description(surfaces, &annotations, format, out)
        });
    }
    let description = session.stage("describe", |session| match &form {
        Form::Fourier(radius) => {
            session.check_degree(2 * radius.harmonics() + 2)?;
            Description::of_radius(radius, &session.limits)
        }
        Form::Curve(curve) => of_curve(curve, session),
        Form::Surface(surface) => of_surface(surface, session),
        Form::Superquadric(shape) => of_curve(&input::polynomial_of(shape)?, session),
        _ => Err(input::not_taken(
            "describe",
            "plane curves, surfaces and space curves",
        )),
    })?;
    if description.factors.is_none() {
        annotations.notes.push(missing_note(FACTORS));
    }
    let digits = session.decimals();
    write_result(session, |out| {
        write_description(&description, &annotations, digits, format, out)
    })
}

fn of_curve(curve: &ImplicitCurve, session: &Session) -> Result<Description> {
    let whole = curve.clone();
    let work = move |limits: &Limits| Description::of_curve(&whole, limits);
    let found = session.unless_limited(FACTORS, work)?;
    Ok(found.unwrap_or_else(|| Description::unfactored_curve(curve)))
}

fn of_surface(surface: &ImplicitSurface, session: &Session) -> Result<Description> {
    let whole = surface.clone();
    let work = move |limits: &Limits| Description::of_surface(&whole, limits);
    let found = session.unless_limited(FACTORS, work)?;
    Ok(found.unwrap_or_else(|| Description::unfactored_surface(surface)))
}

/// A parametric form as its implicit one, with what is known of the two.
fn with_equation(form: Form, annotations: &mut Annotations, session: &Session) -> Result<Form> {
    let (form, found, coordinates) = match form {
        Form::PlaneCurve(curve) => {
            let (form, found) = implicitize::of_plane_curve(&curve, false, session)?;
            (form, found, Coordinates::from(&curve))
        }
        Form::SpaceCurve(curve) => {
            let (form, found) = implicitize::of_space_curve(&curve, false, session)?;
            (form, found, Coordinates::from(&curve))
        }
        Form::Patch(patch) => {
            let (form, found) = implicitize::of_patch(&patch, false, session)?;
            (form, found, Coordinates::from(&patch))
        }
        other => return Ok(other),
    };
    *annotations = found;
    annotations.add_coordinates(&coordinates);
    Ok(form)
}
