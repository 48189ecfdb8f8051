//! `stellate inspect`: points against a tolerance (Theorem 8).

use std::path::Path;

use stellate::document::{
    Format, InspectedPoint, InspectionSummary, InspectionWriter, write_inspection_cloud,
};
use stellate::error::{Error, Result};
use stellate::exact::{Rational, exact_literal};
use stellate::inspect::{
    CircleSection, InspectOptions, Inspector, MAX_EXACT_MONOMIALS, MAX_SECTION_WORK, SphereSection,
};
use stellate::limits::Limits;
use stellate::parametrize::AngleRange;
use stellate::poly::SparsePolynomial;
use stellate::shape::{Form, ImplicitCurve, ImplicitSurface};

use super::arguments::{FitFlags, Inspect};
use super::input;
use super::inspect_plot;
use super::inspect_rows::{self, Points, Reading, Row};
use super::output::{check_destination, check_place, write_beside, write_result};
use super::session::Session;

/// Significant digits of distances without `--digits`.
const DIGITS: u32 = 6;
/// What is taken.
const INSPECT: (&str, &str) = ("inspect", "surfaces and plane curves");

/// What points are held against.
pub(super) enum Subject {
    /// Points have three coordinates.
    Surface(ImplicitSurface),
    /// Points have two, in the curve's original coordinates.
    Curve(ImplicitCurve),
}

/// All that inspecting a row takes.
pub(super) struct Task {
    pub(super) subject: Subject,
    pub(super) inspector: Inspector,
    pub(super) tolerance: Rational,
    pub(super) writer: InspectionWriter,
    /// Whether the section is asked for, too.
    pub(super) with_ranges: bool,
    pub(super) limits: Limits,
}

pub(crate) fn run(verb: &Inspect, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let plot = verb.plot.as_deref();
    for (option, path) in [("--plot", plot), ("--cloud", verb.cloud.as_deref())] {
        if let Some(path) = path {
            check_place(option, path)?;
        }
    }
    let figure = plot.map(inspect_plot::kind).transpose()?;
    check_cloud(verb)?;
    let tolerance = exact_number("--tolerance", &verb.tolerance)?;
    let reach = match &verb.reach {
        Some(text) => exact_number("--reach", text)?.to_f64(),
        None => 0.0,
    };
    let points = Points::of(verb)?;
    let dimension = points.dimension()?;
    let subject = subject(verb, dimension, session)?;
    let options = InspectOptions {
        tolerance: tolerance.clone(),
        reach,
        digits: session.common.digits.unwrap_or(DIGITS),
        cubes: verb.budget,
    };
    let inspector = session.stage("factor", |session| match &subject {
        Subject::Surface(surface) => Inspector::surface(surface, &options, &session.limits),
        Subject::Curve(curve) => Inspector::plane(curve, &options, &session.limits),
    })?;
    if inspector.is_in_doubles_alone() {
        session.note(&format!(
            "a factor has more than {MAX_EXACT_MONOMIALS} monomials: points that doubles do not decide are left undecided"
        ));
    }
    let format = session.format_or(Format::Csv);
    let task = Task {
        writer: InspectionWriter::new(format, dimension, session.decimals())?,
        with_ranges: points.are_few() && format != Format::Csv,
        subject,
        inspector,
        tolerance,
        limits: session.limits.clone(),
    };
    let keep = figure.is_some() || verb.cloud.is_some();
    let number = if verb.points.is_some() {
        "row"
    } else {
        "point"
    };
    let (summary, kept) = write_all(&task, points, verb, keep, session)?;
    session.note(&summary.text(number));
    if let Some(path) = &verb.cloud {
        let mut bytes = Vec::new();
        let comment = format!("stellate inspect, tolerance {}", task.tolerance);
        write_inspection_cloud(&kept, &comment, &mut bytes).map_err(|source| Error::Io {
            path: path.clone(),
            source,
        })?;
        write_beside(path, &bytes, session)?;
    }
    if let (Some(path), Some(kind)) = (plot, figure) {
        let bytes = inspect_plot::picture(&task, &kept, kind, verb.window.as_deref(), session)?;
        write_beside(path, &bytes, session)?;
    }
    finish(&summary, verb, session)
}

/// Exit codes: 3 for what is undecided, 1 for what is outside.
fn finish(summary: &InspectionSummary, verb: &Inspect, session: &mut Session) -> Result<()> {
    if summary.undecided > 0 {
        return Err(Error::Limit {
            limit: format!("--budget {} cubes", verb.budget),
            finished: format!(
                "{} of {} points are undecided; all others are decided and written",
                summary.undecided,
                summary.points()
            ),
        });
    }
    if summary.outside > 0 {
        session.answer_no();
    }
    Ok(())
}

/// The verdicts, written as they come; the points themselves only where they are kept.
fn write_all(
    task: &Task,
    points: Points,
    verb: &Inspect,
    keep: bool,
    session: &mut Session,
) -> Result<(InspectionSummary, Vec<inspect_rows::Kept>)> {
    let bar = session.progress(points.size(), "inspecting");
    let reading = Reading {
        numbers: session.numbers(),
        skip_bad: verb.skip_bad,
        keep,
    };
    let mut outcome = Ok((InspectionSummary::default(), Vec::new()));
    let written = write_result(session, |out| {
        task.writer.begin(&task.tolerance, out)?;
        outcome = inspect_rows::all(task, points, &reading, &bar, out);
        match &outcome {
            Ok((summary, _)) => task.writer.end(summary, out),
            // Nothing is written; what went wrong is in the outcome.
            Err(_) => Err(std::io::Error::other("stopped")),
        }
    });
    bar.finish_and_clear();
    let found = outcome?;
    written?;
    Ok(found)
}

fn exact_number(option: &str, text: &str) -> Result<Rational> {
    let value = exact_literal(text).ok().filter(|value| value.signum() > 0);
    value.ok_or_else(|| {
        Error::Usage(format!(
            "{option} {text}: expected a positive number, such as 0.1 or 1/10"
        ))
    })
}

fn check_cloud(verb: &Inspect) -> Result<()> {
    let is_ply = |path: &Path| {
        path.extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("ply"))
    };
    match &verb.cloud {
        Some(path) if !is_ply(path) => Err(Error::Usage(format!(
            "--cloud {}: a cloud of points is a .ply file",
            path.display()
        ))),
        _ => Ok(()),
    }
}

/// The surface or curve; an equation in x and y is a cylinder for points in space.
fn subject(verb: &Inspect, dimension: usize, session: &mut Session) -> Result<Subject> {
    let flags = FitFlags {
        harmonics: verb.harmonics,
        center: verb.center.clone(),
        ..FitFlags::default()
    };
    let input = input::read(&verb.form, session)?;
    let fitted = input::exact_form(input, &flags, session)?;
    let form = input::through_equation(fitted.form, session)?;
    let subject = match (form, dimension) {
        (Form::Surface(surface), 3) => Subject::Surface(surface),
        (Form::SpaceSuperquadric(shape), 3) => {
            Subject::Surface(ImplicitSurface::new(shape.polynomial()?))
        }
        (Form::Surface(_) | Form::SpaceSuperquadric(_), _) => {
            return Err(Error::Usage(
                "this is a surface: its points are X,Y,Z, such as 0.8,0.6,0".into(),
            ));
        }
        (Form::SpaceCurve(_) | Form::Intersection(_), _) => {
            return Err(input::not_taken(INSPECT.0, INSPECT.1));
        }
        (form, 2) => Subject::Curve(input::implicit_curve(form, INSPECT, session)?),
        (form, _) => {
            let curve = input::implicit_curve(form, INSPECT, session)?;
            Subject::Surface(input::cylinder(&curve))
        }
    };
    let degree = match &subject {
        Subject::Surface(surface) => surface.polynomial().degree().unwrap_or(0),
        Subject::Curve(curve) => curve.polynomial().degree().unwrap_or(0) as u64,
    };
    session.check_degree(usize::try_from(degree).unwrap_or(usize::MAX))?;
    Ok(subject)
}

impl Task {
    /// What is certain of a row.
    pub(super) fn inspect<'a>(&self, row: &'a Row<'a>) -> Result<InspectedPoint<'a>> {
        let exactly = || self.relative(row.exactly());
        let inspection = if self.is_centred() {
            self.inspector.inspect_near(row.near, &exactly)
        } else {
            self.inspector.inspect(&exactly())
        };
        let ranges = if self.with_ranges {
            self.ranges(&exactly())?
        } else {
            None
        };
        Ok(InspectedPoint {
            written: row.written(),
            inspection,
            ranges,
        })
    }

    /// A plane curve's polynomial is in coordinates about its centre.
    fn relative(&self, point: [Rational; 3]) -> [Rational; 3] {
        match &self.subject {
            Subject::Surface(_) => point,
            Subject::Curve(curve) => {
                let [a, b] = curve.center();
                let [x, y, z] = point;
                [x - a, y - b, z]
            }
        }
    }

    fn is_centred(&self) -> bool {
        match &self.subject {
            Subject::Surface(_) => true,
            Subject::Curve(curve) => curve.center().iter().all(Rational::is_zero),
        }
    }

    /// Where the section is real; `None` beyond the limits of what is computed.
    fn ranges(&self, point: &[Rational; 3]) -> Result<Option<Vec<AngleRange>>> {
        let found = match &self.subject {
            Subject::Surface(surface) => {
                let section = SphereSection::new(surface.polynomial(), point, &self.tolerance);
                if section.work() > MAX_SECTION_WORK {
                    return Ok(None);
                }
                section.theta_ranges(&self.limits)
            }
            Subject::Curve(curve) => {
                let polynomial = SparsePolynomial::from(curve.polynomial());
                Ok(CircleSection::new(&polynomial, point, &self.tolerance).theta_ranges())
            }
        };
        match found {
            Ok(ranges) => Ok(Some(ranges)),
            Err(Error::Limit { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }
}
