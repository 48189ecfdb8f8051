//! Calls of the verbs: the same functions that the command line calls.

use serde_json::json;

use super::options::{Options, directions, none_of, number};
use crate::document::{
    Format, InspectionWriter, MeshFormat, json_schema, write_check, write_described, write_fit,
    write_form, write_implicitization, write_mesh, write_parametrized, write_sampled,
    write_vectors,
};
use crate::error::{Error, Result};
use crate::language::Numbers;
use crate::picture::Window;
use crate::shape::Form;
use crate::verb::{
    self, CheckOptions, CoefficientScale, Content, DescribeOptions, FigureFormat, FloatKind, Frame,
    Given, ImplicitizeMethod, ImplicitizeOptions, InspectionOptions, MeshingOptions,
    ParametrizeOptions, PlotOptions, PointRows, PointSource, ReadingOptions, SampleOptions,
    VectorOptions, Work,
};

/// The decimals of algebraic numbers.
const DECIMALS: u32 = 16;
/// The significant digits of distances.
const DIGITS: u32 = 6;

/// What the verb writes about the forms.
pub(super) fn run(
    verb: &str,
    forms: &[(String, Option<String>)],
    options: &str,
    data: &[u8],
) -> Result<Vec<u8>> {
    let options = Options::read(options)?;
    let work = options.work()?;
    let all = || {
        let each = forms.iter().map(|(text, place)| match place {
            None => Given::read(text, Numbers::Exact),
            Some(place) => Given::from_reader(text.as_bytes(), place, Numbers::Exact),
        });
        each.collect::<Result<Vec<Given>>>()
    };
    let one = || {
        let mut all = all()?;
        match all.len() {
            1 => Ok(all.remove(0)),
            count => Err(Error::Usage(format!("{verb} takes one form, not {count}"))),
        }
    };
    let digits = options.digits.unwrap_or(DECIMALS);
    let mut out = Vec::new();
    match verb {
        "form" => match one()?.content() {
            Content::Exact(form) => write_form(form, &[], Format::Json, &mut out)?,
            _ => {
                out = json!({ "schema": "stellate/1", "kind": "contour" })
                    .to_string()
                    .into_bytes()
            }
        },
        "radius" => out = radii(one()?, data)?,
        "describe" => {
            let asked = DescribeOptions::default().fit(options.fit()?);
            let found = verb::describe(one()?, &asked, &work)?;
            write_described(&found, digits, Format::Json, &mut out)?;
        }
        "implicitize" => {
            let found = verb::implicitize(one()?, &implicitize_options(&options)?, &work)?;
            write_implicitization(&found, Format::Json, &mut out)?;
        }
        "parametrize" => {
            let asked = ParametrizeOptions::default()
                .fit(options.fit()?)
                .branch(options.branch)
                .thetas(directions(&options.thetas)?)
                .phis(directions(&options.phis)?);
            let found = verb::parametrize(one()?, &asked, &work)?;
            write_parametrized(&found, digits, Format::Json, &mut out)?;
        }
        "fit" => {
            let mut fit = verb::fit(one()?, &options.fit()?, &work)?;
            if options.normal_form {
                fit = fit.into_normal_form(options.decimals)?;
            }
            write_fit(&fit, Format::Json, &mut out)?;
        }
        "sample" => {
            let asked = SampleOptions::default()
                .fit(options.fit()?)
                .directions(options.directions)
                .thetas(directions(&options.thetas)?)
                .phis(directions(&options.phis)?)
                .coordinates(options.coordinates()?)
                .positive(options.positive);
            let found = verb::sample(one()?, &asked, &work)?;
            write_sampled(&found, Format::Csv, &mut out)?;
        }
        "inspect" => inspect(one()?, &options, data, &work, &mut out)?,
        "check" => check(one()?, &options, data, &work, &mut out)?,
        "vectors" => {
            let mut asked = VectorOptions::default().fit(options.fit()?);
            if let Some(directions) = options.directions {
                asked = asked.directions(directions);
            }
            write_vectors(&verb::vectors(one()?, &asked, &work)?, &mut out)?;
        }
        "plot" => {
            let asked = PlotOptions::default()
                .fit(options.fit()?)
                .window(frame(options.window.as_deref())?)
                .title(options.title.clone().unwrap_or_default());
            let svg = verb::plot(all()?, &asked, &work)?;
            let name = format!("figure.{}", options.format.as_deref().unwrap_or("svg"));
            out = FigureFormat::of("format", name.as_ref())?.bytes(svg)?;
        }
        "mesh" => {
            let mut asked = MeshingOptions::default();
            if let Some(resolution) = options.resolution {
                asked = asked.resolution(resolution);
            }
            let given = one()?;
            let comment = format!(
                "stellate: {}",
                given.short_name().replace(['\n', '\r'], " ")
            );
            let name = options.format.as_deref().unwrap_or("ply");
            let format = MeshFormat::of_extension(name);
            let format = format.ok_or_else(|| none_of("format", name, "obj, ply, stl"))?;
            write_mesh(
                &verb::mesh(given, &asked, &work)?,
                &comment,
                format,
                &mut out,
            )?;
        }
        "verify" => {
            let report = crate::proof::check(&text(data)?, options.complete)
                .map_err(|refusal| Error::Usage(format!("no proof: {refusal}")))?;
            let found = json!({ "holds": report.holds(), "claims": report.claims,
                "without_witness": report.without_witness(), "text": report.to_string() });
            out = found.to_string().into_bytes();
        }
        "schema" => out = json_schema(options.kind.as_deref())?.into_bytes(),
        other => return Err(none_of("verb", other, "the functions of the package")),
    }
    Ok(out)
}

fn implicitize_options(options: &Options) -> Result<ImplicitizeOptions> {
    let method = match options.method.as_deref() {
        None => None,
        Some("polar") => Some(ImplicitizeMethod::Polar),
        Some("resultant") => Some(ImplicitizeMethod::Resultant),
        Some(other) => return Err(none_of("method", other, "polar, resultant")),
    };
    let scale = match options.scale.as_deref() {
        None | Some("integer") => CoefficientScale::Integer,
        Some("monic") => CoefficientScale::Monic,
        Some(other) => return Err(none_of("scale", other, "integer, monic")),
    };
    Ok(ImplicitizeOptions::default()
        .fit(options.fit()?)
        .method(method)
        .scale(scale)
        .coordinates(options.coordinates()?))
}

/// The verdicts of the points of a table, as a table.
fn inspect(
    given: Given,
    options: &Options,
    data: &[u8],
    work: &Work,
    out: &mut Vec<u8>,
) -> Result<()> {
    let fit = Options {
        model: options.model.clone(),
        harmonics: options.harmonics,
        distance: options.distance.clone(),
        ..Options::default()
    };
    let mut asked = InspectionOptions::default()
        .reach(options.reach)
        .digits(options.digits.unwrap_or(DIGITS))
        .fit(fit.fit()?);
    if let Some(tolerance) = number("tolerance", options.tolerance.as_deref())? {
        asked = asked.tolerance(tolerance);
    }
    let reader = Box::new(std::io::Cursor::new(data.to_vec()));
    let rows = PointRows::new(reader, "points", data.len() as u64)?;
    let points = PointSource::Rows(rows);
    let dimension = options.dimension.unwrap_or(points.dimension()?);
    let task = verb::inspect(given, dimension, &asked, work)?;
    let writer = InspectionWriter::new(Format::Csv, dimension, DECIMALS)?;
    // The rows are doubles, written in decimals.
    let reading = ReadingOptions::default().numbers(Numbers::F64);
    task.all(points, &reading, &writer, out, work)?;
    Ok(())
}

/// The comparison of a table of numbers with the exact ones.
fn check(
    given: Given,
    options: &Options,
    data: &[u8],
    work: &Work,
    out: &mut Vec<u8>,
) -> Result<()> {
    let kind = match options.kind.as_deref() {
        Some("coefficients") => FloatKind::Coefficients,
        Some("points") => FloatKind::Points,
        Some("radii") => FloatKind::Radii,
        other => {
            let names = "coefficients, points, radii";
            return Err(none_of("kind", other.unwrap_or("nothing"), names));
        }
    };
    let task = verb::check(given, &CheckOptions::default().fit(options.fit()?), work)?;
    let place = options.kind.as_deref().unwrap_or("numbers");
    let numbers = task.read(kind, &text(data)?, place)?;
    let found = task.compare(&numbers, place, work)?;
    write_check(&found, options.digits, Format::Json, out)
}

/// The doubles near r(θ) for the angles of a list in JSON.
fn radii(given: Given, data: &[u8]) -> Result<Vec<u8>> {
    let wrong = |error| Error::Usage(format!("angles: {error}"));
    let angles: Vec<f64> = serde_json::from_slice(data).map_err(wrong)?;
    let Content::Exact(Form::Fourier(radius)) = given.content() else {
        let message = "radius(theta) is for Fourier radii; sample gives the points of other forms";
        return Err(Error::Usage(message.into()));
    };
    let radii: Vec<f64> = angles
        .iter()
        .map(|theta| radius.approximate(*theta))
        .collect();
    Ok(json!(radii).to_string().into_bytes())
}

fn text(data: &[u8]) -> Result<String> {
    let text = std::str::from_utf8(data);
    text.map(str::to_owned)
        .map_err(|_| Error::Usage("this is not UTF-8 text".into()))
}

/// The part of the plane or of space that a picture shows.
fn frame(window: Option<&[f64]>) -> Result<Option<Frame>> {
    match window {
        None => Ok(None),
        Some([a, b, c, d]) => Ok(Some(Frame::Plane(Window {
            x: [*a, *b],
            y: [*c, *d],
        }))),
        Some([a, b, c, d, e, f]) => Ok(Some(Frame::Space([[*a, *b], [*c, *d], [*e, *f]]))),
        Some(_) => {
            let message = "window: four numbers x0, x1, y0, y1, or six in space";
            Err(Error::Usage(message.into()))
        }
    }
}
