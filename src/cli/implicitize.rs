//! `stellate implicitize`: Theorem 2, and canonical forms of what is implicit already.

use stellate::document::{Annotations, Format, write_implicit, write_surface};
use stellate::error::Result;
use stellate::implicitize::SquaredForm;
use stellate::shape::{Form, ImplicitCurve, ImplicitSurface};

use super::arguments::{Coordinates, Implicitize, Scale};
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(verb: &Implicitize, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    let input = input::read(&verb.form, session)?;
    let fitted = input::exact_form(input, &verb.fit, session)?;
    let mut annotations = Annotations::default();
    let curve = match fitted.form {
        Form::Fourier(radius) => {
            session.check_degree(2 * radius.harmonics() + 2)?;
            session.stage("implicitize", |session| {
                let form = SquaredForm::new(&radius)?;
                if form.is_perfect_square() {
                    let remark = "F of Theorem 2 is a perfect square (a0 = 0 and only odd harmonics): this is its reduced equation";
                    annotations.notes.push(remark.into());
                    session.note(remark);
                }
                Ok(form.expand())
            })?
        }
        Form::Curve(curve) => curve,
        Form::Superquadric(shape) => input::polynomial_of(&shape)?,
        Form::Surface(surface) => {
            let f = surface.polynomial();
            let f = match verb.scale {
                Scale::Integer => f.primitive(),
                Scale::Monic => f.monic(),
            };
            let surface = ImplicitSurface::new(f);
            return write_result(session, |out| {
                write_surface(&surface, &annotations, format, out)
            });
        }
    };
    session.check_degree(curve.polynomial().degree().unwrap_or(0))?;
    let curve = session.stage("implicitize", |_| Ok(scaled(curve, verb)))?;
    write_result(session, |out| {
        write_implicit(&curve, &annotations, format, out)
    })
}

fn scaled(curve: ImplicitCurve, verb: &Implicitize) -> ImplicitCurve {
    let curve = match verb.coordinates {
        Coordinates::Centre => curve,
        Coordinates::Original => curve.in_original_coordinates(),
    };
    let f = curve.polynomial();
    let f = match verb.scale {
        Scale::Integer => f.primitive(),
        Scale::Monic => f.monic(),
    };
    ImplicitCurve::new(f).with_center(curve.center().clone())
}
