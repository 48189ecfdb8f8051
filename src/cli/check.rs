//! `stellate check`: a float program's numbers against the exact ones.

use stellate::check::{Comparison, Reference, ladder};
use stellate::document::{
    Format, read_coefficients_csv, read_document, read_points_csv, read_radii_csv, write_check,
    write_ladder,
};
use stellate::error::{Error, Result};
use stellate::language::Numbers;
use stellate::poly::SparsePolynomial;
use stellate::shape::{Form, ImplicitSurface};

use super::arguments::FitFlags;
use super::check_arguments::{Check, CheckedData};
use super::check_plot::{Picture, digits_chart, ladder_chart};
use super::input::{self, Content};
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(verb: &Check, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    if !matches!(format, Format::Text | Format::Json | Format::Csv) {
        return Err(Error::Usage(format!(
            "--format {format}: a check is written as text, json or csv"
        )));
    }
    let mark = session.common.digits;
    if verb.plot.is_some() && verb.plot == session.common.output {
        return Err(Error::Usage(
            "--plot and -o name the same file: one is for the figure, the other for the report"
                .into(),
        ));
    }
    let figure = verb.plot.as_deref().map(Picture::named).transpose()?;
    let file = [&verb.data.coefficients, &verb.data.points, &verb.data.radii];
    let file = file.into_iter().flatten().next();
    if verb.reference == "-" && file.is_some_and(|file| file == "-") {
        return Err(Error::Usage(
            "standard input (-) is either the reference or the file that is checked, not both"
                .into(),
        ));
    }
    if verb.data.itself && mark.is_some() {
        return Err(Error::Usage(
            "--digits is the mark for the numbers of a file; --self says what doubles keep".into(),
        ));
    }
    if verb.data.itself {
        return check_itself(verb, figure, format, session);
    }
    let Given {
        reference, name, ..
    } = reference(&verb.reference, &verb.fit, session)?;
    let found = compared(&reference, &verb.data, session)?;
    if let Some(figure) = figure {
        let chart = digits_chart(&found, mark, &name);
        figure.write(&chart, session)?;
    }
    write_result(session, |out| write_check(&found, mark, format, out))?;
    if !found.passes(mark) {
        session.answer_no();
    }
    Ok(())
}

/// The paper's own algorithm in doubles, with more and more harmonics of a radius.
fn check_itself(
    verb: &Check,
    figure: Option<Picture<'_>>,
    format: Format,
    session: &mut Session,
) -> Result<()> {
    let input = input::read(&verb.reference, session)?;
    let name = input.short_name();
    let Form::Fourier(radius) = input::exact_form(input, &verb.fit, session)?.form else {
        return Err(Error::Usage(
            "check --self takes a Fourier radius, or a contour with --harmonics N: Theorem 2 starts from one".into(),
        ));
    };
    session.check_degree(2 * radius.harmonics() + 2)?;
    let rungs = session.stage("check", |session| ladder(&radius, &session.limits))?;
    if let Some(figure) = figure {
        figure.write(&ladder_chart(&rungs, &name), session)?;
    }
    write_result(session, |out| write_ladder(&rungs, format, out))
}

/// The exact form of a verb that concerns float programs.
pub(super) struct Given {
    pub(super) reference: Reference,
    pub(super) name: String,
    /// Whether it was given by functions of parameters.
    pub(super) is_parametric: bool,
}

/// The exact form to be compared with, and its name; of a contour its fit, and the fit with one harmonic more.
pub(super) fn reference(argument: &str, flags: &FitFlags, session: &mut Session) -> Result<Given> {
    let input = input::read(argument, session)?;
    let name = input.short_name();
    let next = match (&input.content, flags.harmonics) {
        (Content::Contour(contour), Some(n)) => input::fit_quietly(contour, flags, n + 1, session),
        _ => None,
    };
    let fitted = input::exact_form(input, flags, session)?;
    let is_parametric = matches!(fitted.form, Form::PlaneCurve(_) | Form::Patch(_));
    let form = match fitted.form {
        Form::Superquadric(shape) => Form::Curve(input::polynomial_of(&shape)?),
        Form::SpaceSuperquadric(shape) => Form::Surface(ImplicitSurface::new(shape.polynomial()?)),
        other => input::through_equation(other, session)?,
    };
    let reference = session.stage("implicitize", |session| match &form {
        Form::Fourier(radius) => {
            session.check_degree(2 * radius.harmonics() + 2)?;
            Reference::of_radius(radius)
        }
        Form::Curve(curve) => {
            session.check_degree(curve.polynomial().degree().unwrap_or(0))?;
            Ok(Reference::of_curve(curve))
        }
        Form::Surface(surface) => Ok(Reference::of_surface(surface)),
        _ => Err(input::not_taken("check", "plane curves and surfaces")),
    })?;
    let [a, b] = reference.center();
    if !(a.is_zero() && b.is_zero()) {
        session.note(&format!(
            "coordinates are relative to the centre ({a}, {b})"
        ));
    }
    let reference = match next {
        Some(next) => reference.with_next(next),
        None => reference,
    };
    Ok(Given {
        reference,
        name,
        is_parametric,
    })
}

fn compared(
    reference: &Reference,
    data: &CheckedData,
    session: &mut Session,
) -> Result<Comparison> {
    let read =
        |file: &str, session: &mut Session| session.stage("read", |_| input::read_data(file));
    if let Some(file) = &data.coefficients {
        let (text, name) = read(file, session)?;
        let got = coefficients(&text, &name, reference)?;
        return session.stage("check", |_| Ok(reference.check_coefficients(&got)));
    }
    if let Some(file) = &data.points {
        let (text, name) = read(file, session)?;
        let points = read_points_csv(&text, &name, reference.in_space())?;
        return session.stage("check", |session| {
            reference.check_points(&points, &session.limits)
        });
    }
    let file = data.radii.as_deref().unwrap_or("-");
    let (text, name) = read(file, session)?;
    let radii = read_radii_csv(&text, &name)?;
    session.stage("check", |session| {
        reference.check_radii(&radii, &session.limits)
    })
}

/// The polynomial of a float program, every coefficient a double.
fn coefficients(text: &str, name: &str, reference: &Reference) -> Result<SparsePolynomial<3>> {
    let is_document = text
        .trim_start_matches('\u{feff}')
        .trim_start()
        .starts_with('{');
    let form = if is_document {
        read_document(text, name, Numbers::F64)?
    } else {
        read_coefficients_csv(text, name, Numbers::F64)?
    };
    let wrong = |message: String| Error::Data {
        place: name.into(),
        message,
    };
    let (polynomial, in_space) = match &form {
        Form::Curve(curve) => {
            let center = curve.center().each_ref().map(|v| v.to_f64().to_bits());
            let about = reference.center().each_ref().map(|v| v.to_f64().to_bits());
            let [x, y] = curve.center();
            if (!x.is_zero() || !y.is_zero()) && center != about {
                let [a, b] = reference.center();
                return Err(wrong(format!(
                    "the coefficients are relative to ({x}, {y}), the reference to ({a}, {b})"
                )));
            }
            (SparsePolynomial::from(curve.polynomial()), false)
        }
        Form::Surface(surface) => (surface.polynomial().clone(), true),
        _ => {
            return Err(wrong(
                "expected the coefficients of a polynomial: a document of kind \"implicit\", or rows i,j[,k],value".into(),
            ));
        }
    };
    if in_space != reference.in_space() {
        let [these, that] = if in_space {
            ["a surface in x, y, z", "a curve in x, y"]
        } else {
            ["a curve in x, y", "a surface in x, y, z"]
        };
        return Err(wrong(format!(
            "these are the coefficients of {these}, the reference is {that}"
        )));
    }
    Ok(polynomial)
}
