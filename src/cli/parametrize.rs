//! `stellate parametrize`: back to r(θ).

use stellate::document::{Format, write_parametrization};
use stellate::error::{Error, Result};
use stellate::implicitize::SquaredForm;
use stellate::limits::Limits;
use stellate::parametrize::{
    Branch, Parametrization, Radius, parametrize, parametrize_superquadric,
};
use stellate::shape::{Form, FourierRadius};

use super::arguments::Parametrize;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(verb: &Parametrize, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    format.check_fourier()?;
    let input = input::read(&verb.form, session)?;
    let fitted = input::exact_form(input, &verb.fit, session)?;
    let parametrization = session.stage("parametrize", |session| match &fitted.form {
        Form::Fourier(radius) => {
            session.check_degree(2 * radius.harmonics() + 2)?;
            of_radius(radius, &session.limits)
        }
        Form::Curve(curve) => {
            session.check_degree(curve.polynomial().degree().unwrap_or(0))?;
            parametrize(curve, &session.limits)
        }
        Form::Superquadric(shape) => Ok(parametrize_superquadric(shape)),
        Form::Surface(_) => Err(Error::Usage(
            "this polynomial has z: parametrize takes plane curves, in x and y".into(),
        )),
    })?;
    let is_series = |b: &Branch| matches!(b.radius, Radius::Fourier(_));
    if format == Format::Csv && !parametrization.branches.first().is_some_and(is_series) {
        return Err(Error::Usage(
            "--format csv: only a radius that is a Fourier series is a table of coefficients; text, json, latex, sympy and maple write closed forms".into(),
        ));
    }
    let digits = session.common.digits;
    write_result(session, |out| {
        write_parametrization(&parametrization, digits, format, out)
    })
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
