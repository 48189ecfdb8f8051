//! Calls of the verbs: the same functions that the command line calls.

use std::io::Cursor;

use serde_json::json;

use super::contour;
use super::options::{Options, directions, none_of, reading};
use crate::document::{
    Format, InspectionWriter, MeshFormat, ReportHead, json_schema, missing_text, write_check,
    write_described, write_fit, write_fit_table, write_form, write_implicitization,
    write_inspection_cloud, write_inspection_report, write_ladder, write_mesh, write_mesh_fit,
    write_parametrized, write_sampled, write_vectors,
};
use crate::error::{Error, Result};
use crate::language::Numbers;
use crate::verb::{
    self, CheckOptions, Content, DIGITS, DescribeOptions, FigureFormat, FittedOutline, FloatKind,
    Given, OutlineFit, ParametrizeOptions, PointRows, PointSource, ReadOptions, ReadingOptions,
    SampleOptions, VectorOptions, Work, digits_chart, ladder_chart,
};

/// The decimals of algebraic numbers.
const DECIMALS: u32 = 16;

/// A form: a text or a path, or the text of a document or table with a name for messages; and the options of how it is read.
pub(super) type Source = (String, Option<String>, String);

/// What a verb writes.
#[derive(Debug)]
pub(super) struct Written {
    pub(super) document: Vec<u8>,
    /// The limit that was reached, and the parts that are missing therefore.
    pub(super) missing: Option<String>,
    pub(super) proof: Option<String>,
}

/// Reads a form.
pub(super) fn given(source: &Source, options: &ReadOptions, work: &Work) -> Result<Given> {
    let (text, place, _) = source;
    work.stage("read", || match place {
        None => Given::read_with(text, options, work),
        Some(place) => match contour::read(text, place, options)? {
            Some(content) => Ok(Given::new(place, content)),
            None => Given::from_reader_with(text.as_bytes(), place, options, work),
        },
    })
}

/// What the verb writes about the forms.
pub(super) fn run(
    verb: &str,
    forms: &[Source],
    options: &Options,
    data: Vec<u8>,
    mut work: Work,
) -> Result<Written> {
    if options.proof {
        work = work.with_proof();
    }
    let call = Call {
        verb,
        forms,
        options,
        work: &work,
    };
    let document = call.written(data)?;
    let proof = match work.proof() {
        Some(proof) => Some(work.stage("check of the proof", || proof.checked())?.text()),
        None => None,
    };
    Ok(Written {
        document,
        missing: work.missing().map(|missing| {
            let limit = Error::Limit {
                limit: missing.limit.clone(),
                finished: missing_text(&missing),
            };
            limit.to_string()
        }),
        proof,
    })
}

/// One call of a verb.
struct Call<'a> {
    verb: &'a str,
    forms: &'a [Source],
    options: &'a Options,
    work: &'a Work,
}

impl Call<'_> {
    fn all(&self) -> Result<Vec<Given>> {
        let each = self.forms.iter();
        each.map(|source| given(source, &reading(&source.2)?, self.work))
            .collect()
    }

    fn one(&self) -> Result<Given> {
        let mut all = self.all()?;
        match all.len() {
            1 => Ok(all.remove(0)),
            count => Err(Error::Usage(format!(
                "{} takes one form, not {count}",
                self.verb
            ))),
        }
    }

    fn written(&self, data: Vec<u8>) -> Result<Vec<u8>> {
        let (options, work) = (self.options, self.work);
        let digits = options.digits.unwrap_or(DECIMALS);
        // The writers check this, too, but only after the work.
        DIGITS.check(digits)?;
        let format = match (self.verb, options.format.as_deref()) {
            ("plot" | "mesh" | "inspect" | "check", _) | (_, None) => Format::Json,
            (_, Some(name)) => name.parse()?,
        };
        let mut out = Vec::new();
        match self.verb {
            "form" => match self.one()?.content() {
                Content::Exact(form) => write_form(form, &[], format, &mut out)?,
                content => out = contour::written(content)?,
            },
            "describe" => {
                let asked = DescribeOptions::default()
                    .fit(options.fit()?)
                    .topology(options.topology);
                let found = verb::describe(self.one()?, &asked, work)?;
                write_described(&found, digits, format, &mut out)?;
            }
            "implicitize" => {
                let found = verb::implicitize(self.one()?, &options.implicitize()?, work)?;
                write_implicitization(&found, format, &mut out)?;
            }
            "parametrize" => {
                let asked = ParametrizeOptions::default()
                    .fit(options.fit()?)
                    .branch(options.branch)
                    .thetas(directions(&options.thetas)?)
                    .phis(directions(&options.phis)?)
                    .arcs(options.arcs()?)
                    .with_arcs(format == Format::Json);
                let found = verb::parametrize(self.one()?, &asked, work)?;
                write_parametrized(&found, digits, format, &mut out)?;
            }
            "fit" => match self.forms {
                [(path, None, _)] if verb::is_mesh_name(path) => {
                    let solid = verb::read_mesh(path.as_ref(), work)?;
                    let fit = verb::fit_mesh(&solid, &options.mesh_fit()?, work)?;
                    write_mesh_fit(&fit, format, &mut out)?;
                }
                _ => write_fit(&self.fit_of(self.one()?)?, format, &mut out)?,
            },
            "fit_all" => out = self.all_fits()?,
            "sample" => {
                let asked = SampleOptions::default()
                    .fit(options.fit()?)
                    .directions(options.directions)
                    .thetas(directions(&options.thetas)?)
                    .phis(directions(&options.phis)?)
                    .coordinates(options.coordinates()?)
                    .positive(options.positive)
                    .arcs(options.arcs()?);
                let found = verb::sample(self.one()?, &asked, work)?;
                write_sampled(&found, Format::Csv, &mut out)?;
            }
            "inspect" => out = self.inspected(data)?,
            "check" => out = self.checked(data)?,
            "vectors" => {
                let mut asked = VectorOptions::default().fit(options.fit()?);
                if let Some(directions) = options.directions {
                    asked = asked.directions(directions);
                }
                write_vectors(&verb::vectors(self.one()?, &asked, work)?, &mut out)?;
            }
            "plot" => {
                let svg = verb::plot(self.all()?, &options.plot()?, work)?;
                out = self.figure()?.bytes(svg)?;
            }
            "mesh" => {
                let given = self.one()?;
                let name = given.short_name().replace(['\n', '\r'], " ");
                let comment = format!("stellate: {name}");
                let name = options.format.as_deref().unwrap_or("ply");
                let format = MeshFormat::of_extension(name);
                let format = format.ok_or_else(|| none_of("format", name, "obj, ply, stl"))?;
                let mesh = format.held(verb::mesh(given, &options.meshing()?, work)?)?;
                write_mesh(&mesh, &comment, format, &mut out)?;
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

    fn figure(&self) -> Result<FigureFormat> {
        let name = format!("figure.{}", self.options.format.as_deref().unwrap_or("svg"));
        FigureFormat::of("format", name.as_ref())
    }

    fn fit_of(&self, given: Given) -> Result<OutlineFit> {
        let options = self.options.fit()?;
        if !self.options.normal_form {
            return verb::fit(given, &options, self.work);
        }
        // Of a normal form, what is rounded is the normal form.
        let fit = verb::fit(given, &options.decimals(None), self.work)?;
        fit.into_normal_form(self.options.decimals)
    }

    /// The fits of all outlines of all files, as a table.
    fn all_fits(&self) -> Result<Vec<u8>> {
        let mut rows = Vec::new();
        for (text, place, how) in self.forms {
            let options = reading(how)?;
            let outlines = match place {
                None => Given::read_all_with(text, &options)?,
                Some(place) => match contour::read(text, place, &options)? {
                    Some(content) => vec![Ok(Given::new(place, content))],
                    None => Given::all_from_reader_with(text.as_bytes(), place, &options)?,
                },
            };
            let before = rows.len();
            for (k, found) in outlines.into_iter().enumerate() {
                // An outline that cannot be fitted is left out beside others.
                if let Ok(given) = found {
                    let file = place.clone().unwrap_or_else(|| text.clone());
                    let fit = self.fit_of(given)?;
                    let blob = k + 1;
                    rows.push(FittedOutline { file, blob, fit });
                }
            }
            if rows.len() == before {
                let message = format!("{text}: no outline of this file can be fitted");
                return Err(Error::Usage(message));
            }
        }
        let mut out = Vec::new();
        write_fit_table(&rows, &mut out)?;
        Ok(out)
    }

    /// The verdicts of the points of a table, as a table; or a picture, a cloud or a report about them.
    fn inspected(&self, data: Vec<u8>) -> Result<Vec<u8>> {
        let (options, work) = (self.options, self.work);
        let size = data.len() as u64;
        let rows = PointRows::new(Box::new(Cursor::new(data)), "points", size)?;
        let points = PointSource::Rows(rows);
        let dimension = points.dimension()?;
        let given = self.one()?;
        let name = given.whole_name();
        let task = verb::inspect(given, dimension, &options.inspection()?, work)?;
        let writer = InspectionWriter::new(Format::Csv, dimension, DECIMALS)?;
        let kind = options.kind.as_deref();
        // The rows are doubles, written in decimals.
        let reading = ReadingOptions::default()
            .numbers(Numbers::F64)
            .keep(kind.is_some());
        let mut out = Vec::new();
        let (summary, kept) = task.all(points, &reading, &writer, &mut out, work)?;
        let picture = || task.picture(&kept, options.frame()?, work);
        match kind {
            None => {}
            Some("plot") => out = self.figure()?.bytes(picture()?)?,
            Some("cloud") => {
                out.clear();
                write_inspection_cloud(&kept, task.zone(), &mut out)?;
            }
            Some("report") => {
                let mut head = ReportHead::new(name, task.zone().clone());
                head.number = "row";
                out.clear();
                write_inspection_report(&head, &summary, &kept, &picture()?, &mut out)?;
            }
            Some(other) => return Err(none_of("kind", other, "plot, cloud, report")),
        }
        Ok(out)
    }

    /// The comparison of a table of numbers with the exact ones, or the ladder of what doubles keep; or a chart of it.
    fn checked(&self, data: Vec<u8>) -> Result<Vec<u8>> {
        let (options, work) = (self.options, self.work);
        let given = self.one()?;
        let name = given.short_name();
        let asked = CheckOptions::default().fit(options.fit()?);
        let is_chart = options.format.is_some();
        let mut out = Vec::new();
        let place = options.kind.as_deref().unwrap_or("nothing");
        let kind = match place {
            "coefficients" => FloatKind::Coefficients,
            "points" => FloatKind::Points,
            "radii" => FloatKind::Radii,
            "self" => {
                let rungs = verb::check_doubles(given, &asked, work)?;
                if is_chart {
                    return self.figure()?.bytes(ladder_chart(&rungs, &name).to_svg()?);
                }
                let mut table = Vec::new();
                write_ladder(&rungs, Format::Json, &mut out)?;
                write_ladder(&rungs, Format::Csv, &mut table)?;
                return with_table(&text(out)?, &text(table)?);
            }
            other => return Err(none_of("kind", other, "coefficients, points, radii, self")),
        };
        let task = verb::check(given, &asked, work)?;
        let numbers = task.read(kind, &text(data)?, place)?;
        let found = task.compare(&numbers, place, work)?;
        if is_chart {
            let chart = digits_chart(&found, options.digits, &name);
            return self.figure()?.bytes(chart.to_svg()?);
        }
        let mut table = Vec::new();
        write_check(&found, options.digits, Format::Json, &mut out)?;
        write_check(&found, options.digits, Format::Csv, &mut table)?;
        with_table(&text(out)?, &text(table)?)
    }
}

/// A document and a table as one document.
fn with_table(document: &str, table: &str) -> Result<Vec<u8>> {
    let table = serde_json::to_string(table).map_err(std::io::Error::from)?;
    Ok(format!("{{\"document\":{document},\"table\":{table}}}").into_bytes())
}

fn text(data: Vec<u8>) -> Result<String> {
    String::from_utf8(data).map_err(|_| Error::Usage("this is not UTF-8 text".into()))
}
