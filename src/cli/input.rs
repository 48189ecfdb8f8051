//! Forms from text, files and standard input; contours and their fits.

use std::io::Read;
use std::path::Path;

use stellate::document::{FitReport, read_coefficients_csv, read_text};
use stellate::error::{Error, Result};
use stellate::exact::{Rational, exact_literal};
use stellate::fit::{
    CenterChoice, CenterOrigin, ContourKind, Fit, FitOptions, FitSize, contour_from_reader,
    fit_within, read_contour,
};
use stellate::implicitize::{SquaredForm, implicitize_patch, implicitize_plane};
use stellate::language::MAX_TEXT_BYTES;
use stellate::poly::SparsePolynomial;
use stellate::shape::{Contour, Form, FourierRadius, ImplicitCurve, ImplicitSurface, Superquadric};

use super::arguments::FitFlags;
use super::session::Session;

/// A form as given, and what to call it in messages and legends.
pub(crate) struct Input {
    pub(crate) name: String,
    pub(crate) content: Content,
}

#[expect(
    clippy::large_enum_variant,
    reason = "there is one of these for each form on the command line"
)]
pub(crate) enum Content {
    Exact(Form),
    Contour(Contour),
}

impl Input {
    /// The name on one line, cut if it is long.
    pub(crate) fn short_name(&self) -> String {
        const LONGEST: usize = 40;
        let line: String = self.name.split_whitespace().collect::<Vec<_>>().join(" ");
        if line.chars().count() <= LONGEST {
            return line;
        }
        line.chars().take(LONGEST).chain(['…']).collect()
    }
}

/// A form with contours fitted: the exact form and, for a contour, how good the fit is.
pub(crate) struct Fitted {
    pub(crate) form: Form,
    pub(crate) report: Option<FitReport>,
}

/// Reads a FORM argument.
pub(crate) fn read(argument: &str, session: &mut Session) -> Result<Input> {
    session.stage("read", |session| {
        let (name, content) = if argument == "-" {
            ("standard input".into(), read_stdin(session)?)
        } else if names_a_file(argument) {
            (
                file_name(argument),
                read_file(Path::new(argument), session)?,
            )
        } else {
            let form = read_text(argument, "<form>", session.numbers())
                .map_err(|error| folder_instead(argument, error))?;
            (argument.trim().to_string(), Content::Exact(form))
        };
        Ok(Input { name, content })
    })
}

/// What is no form but the name of a folder was meant as a file.
fn folder_instead(argument: &str, error: Error) -> Error {
    if Path::new(argument).is_dir() {
        Error::Usage(format!(
            "{argument}: that is a folder; a form is text, a file, or - for standard input"
        ))
    } else {
        error
    }
}

/// An argument with a known extension is a file even if it is missing; any other only if it exists,
/// as a file or as a pipe (`<(command)` of a shell).
fn names_a_file(argument: &str) -> bool {
    let path = Path::new(argument);
    let known = ["csv", "png", "jpg", "jpeg", "bmp", "json", "txt"];
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .map(str::to_ascii_lowercase);
    extension.is_some_and(|e| known.contains(&e.as_str())) || (path.exists() && !path.is_dir())
}

fn file_name(argument: &str) -> String {
    let name = Path::new(argument).file_name();
    name.map_or_else(
        || argument.to_string(),
        |n| n.to_string_lossy().into_owned(),
    )
}

fn read_file(path: &Path, session: &Session) -> Result<Content> {
    match ContourKind::of(path) {
        Some(ContourKind::Rows) => {
            let text = read_limited(open(path)?, path)?;
            read_table(&text, &path.display().to_string(), session)
        }
        Some(_) => read_contour(path).map(Content::Contour),
        None => {
            let text = read_limited(open(path)?, path)?;
            let form = read_text(&text, &path.display().to_string(), session.numbers())?;
            Ok(Content::Exact(form))
        }
    }
}

/// A CSV file is a contour, unless it has a header `i,j,…` of a table of coefficients.
fn read_table(text: &str, name: &str, session: &Session) -> Result<Content> {
    let mut rows = text
        .lines()
        .map(str::trim)
        .filter(|l| !l.is_empty() && !l.starts_with('#'));
    let header = rows
        .next()
        .unwrap_or("")
        .replace(' ', "")
        .to_ascii_lowercase();
    if header.starts_with("i,j,") {
        return read_coefficients_csv(text, name, session.numbers()).map(Content::Exact);
    }
    if header == "n,cos,sin" {
        let radius = stellate::document::read_fourier_csv(text, name, session.numbers())?;
        return Ok(Content::Exact(Form::Fourier(radius)));
    }
    contour_from_reader(text.as_bytes(), ContourKind::Rows, name).map(Content::Contour)
}

/// A data file of a verb, or standard input, as text with the name it has in messages.
pub(crate) fn read_data(argument: &str) -> Result<(String, String)> {
    if argument == "-" {
        let name = "standard input";
        let text = read_limited(std::io::stdin().lock(), Path::new(name))?;
        return Ok((text, name.into()));
    }
    let path = Path::new(argument);
    Ok((read_limited(open(path)?, path)?, argument.into()))
}

fn open(path: &Path) -> Result<std::fs::File> {
    std::fs::File::open(path).map_err(|source| Error::Io {
        path: path.to_path_buf(),
        source,
    })
}

fn read_stdin(session: &Session) -> Result<Content> {
    let text = read_limited(std::io::stdin().lock(), Path::new("standard input"))?;
    let first = text
        .lines()
        .map(|l| l.split('#').next().unwrap_or("").trim())
        .find(|l| !l.is_empty() && !l.starts_with("//"));
    let looks_like_rows = first.is_some_and(|l| l.contains(',') && !l.contains(['=', '{', '(']));
    if looks_like_rows {
        return read_table(&text, "standard input", session);
    }
    read_text(&text, "standard input", session.numbers()).map(Content::Exact)
}

fn read_limited(source: impl Read, path: &Path) -> Result<String> {
    let failed = |source| Error::Io {
        path: path.to_path_buf(),
        source,
    };
    let limit = MAX_TEXT_BYTES as u64;
    let mut bytes = Vec::new();
    source
        .take(limit + 1)
        .read_to_end(&mut bytes)
        .map_err(failed)?;
    if bytes.len() as u64 > limit {
        return Err(Error::Limit {
            limit: format!("{}: a text has at most {limit} bytes", path.display()),
            finished: String::new(),
        });
    }
    String::from_utf8(bytes).map_err(|e| Error::Data {
        place: path.display().to_string(),
        message: format!(
            "byte {} is not UTF-8 text",
            e.utf8_error().valid_up_to() + 1
        ),
    })
}

/// The exact form of an input; a contour is fitted as the flags say.
pub(crate) fn exact_form(input: Input, flags: &FitFlags, session: &mut Session) -> Result<Fitted> {
    match input.content {
        Content::Exact(form) => {
            refuse_fit_flags(flags)?;
            Ok(Fitted { form, report: None })
        }
        Content::Contour(contour) => {
            let fit = fit_contour(&contour, flags, session)?;
            let report = report(&fit);
            Ok(Fitted {
                form: Form::Fourier(fit.radius),
                report: Some(report),
            })
        }
    }
}

/// A parametric curve as its implicit equation, a patch as that of its surface; other forms as they are.
pub(crate) fn through_equation(form: Form, session: &mut Session) -> Result<Form> {
    Ok(match form {
        Form::PlaneCurve(curve) => {
            let equation = session.stage("implicitize", |session| {
                implicitize_plane(&curve, &session.limits)
            })?;
            Form::Curve(equation.curve)
        }
        Form::Patch(patch) => {
            let equation = session.stage("implicitize", |session| {
                implicitize_patch(&patch, &session.limits)
            })?;
            Form::Surface(equation.surface)
        }
        other => other,
    })
}

/// Why a form is not taken by a verb that takes `these`.
pub(crate) fn not_taken(verb: &str, these: &str) -> Error {
    Error::Usage(format!("this is a curve in space: {verb} takes {these}"))
}

/// The plane curve that a form is or has; `verb` takes `these`.
pub(crate) fn implicit_curve(
    form: Form,
    (verb, these): (&str, &str),
    session: &Session,
) -> Result<ImplicitCurve> {
    match form {
        Form::Fourier(radius) => {
            session.check_degree(2 * radius.harmonics() + 2)?;
            Ok(SquaredForm::new(&radius)?.expand())
        }
        Form::Curve(curve) => {
            session.check_degree(curve.polynomial().degree().unwrap_or(0))?;
            Ok(curve)
        }
        Form::Superquadric(shape) => polynomial_of(&shape),
        _ => Err(not_taken(verb, these)),
    }
}

/// An equation in x and y is a cylinder in space.
pub(crate) fn cylinder(curve: &ImplicitCurve) -> ImplicitSurface {
    let original = curve.in_original_coordinates();
    ImplicitSurface::new(SparsePolynomial::from(original.polynomial()))
}

/// The implicit curve of a superquadric, where it has one.
pub(crate) fn polynomial_of(shape: &Superquadric) -> Result<ImplicitCurve> {
    let polynomial = shape.polynomial().ok_or_else(|| Error::Hypothesis {
        statement: "implicitization as a polynomial",
        witness: format!(
            "|x/a1|^n + |y/a2|^n = level is polynomial only for an even integer n = 2/e, and here n = {}; describe, parametrize, sample and plot take any n",
            shape.exponent()
        ),
    })?;
    Ok(ImplicitCurve::new(polynomial))
}

/// `--harmonics` and the like belong to contours.
pub(crate) fn refuse_fit_flags(flags: &FitFlags) -> Result<()> {
    refuse(&[
        ("--harmonics", flags.harmonics.is_some()),
        ("--samples", flags.samples.is_some()),
        ("--decimals", flags.decimals.is_some()),
    ])?;
    refuse_contour_flags(flags)
}

/// What only a contour has: a centre to choose, and a tolerance.
pub(crate) fn refuse_contour_flags(flags: &FitFlags) -> Result<()> {
    refuse(&[
        ("--tolerance", flags.tolerance.is_some()),
        ("--center", flags.center != "centroid"),
    ])
}

fn refuse(given: &[(&str, bool)]) -> Result<()> {
    match given.iter().find(|(_, given)| *given) {
        Some((name, _)) => Err(Error::Usage(format!(
            "{name} is for contours; this form is exact already"
        ))),
        None => Ok(()),
    }
}

/// Fits a contour and says what a user should know about its centre.
pub(crate) fn fit_contour(
    contour: &Contour,
    flags: &FitFlags,
    session: &mut Session,
) -> Result<Fit> {
    let size = match (flags.harmonics, flags.tolerance) {
        (Some(n), None) => FitSize::Harmonics(n),
        (None, Some(e)) => FitSize::Tolerance(e),
        _ => {
            return Err(Error::Usage(
                "a contour needs --harmonics N or --tolerance E, such as --harmonics 39".into(),
            ));
        }
    };
    if let FitSize::Harmonics(n) = size {
        session.check_degree(n.saturating_mul(2).saturating_add(2))?;
    }
    let options = fit_options(flags, size)?;
    let fit = session.stage("fit", |session| {
        fit_within(contour, &options, &session.limits)
    })?;
    let [x, y] = fit.center.point;
    match fit.center.origin {
        CenterOrigin::Centroid | CenterOrigin::Given => {}
        origin => session.note(&format!("the centre is ({x}, {y}): {}", origin.describe())),
    }
    if !fit.star_shaped {
        session.note(&format!(
            "the outline is not star-shaped about ({x}, {y}): its outermost boundary is taken; {:.3} % of the outline's length is hidden behind it",
            fit.hidden_share * 100.0
        ));
    }
    Ok(fit)
}

/// The fit with another number of harmonics, without notes; `None` if the contour has no such fit.
pub(crate) fn fit_quietly(
    contour: &Contour,
    flags: &FitFlags,
    harmonics: usize,
    session: &Session,
) -> Option<FourierRadius> {
    let options = fit_options(flags, FitSize::Harmonics(harmonics)).ok()?;
    let fit = fit_within(contour, &options, &session.limits).ok()?;
    Some(fit.radius)
}

fn fit_options(flags: &FitFlags, size: FitSize) -> Result<FitOptions> {
    let mut options = FitOptions::new(size);
    options.center = center(&flags.center)?;
    options.samples = flags.samples;
    options.decimals = flags.decimals;
    Ok(options)
}

/// The quality of a fit, as documents carry it.
pub(crate) fn report(fit: &Fit) -> FitReport {
    FitReport {
        max_radial_error: fit.max_radial_error,
        rms_radial_error: fit.rms_radial_error,
        star_shaped: fit.star_shaped,
        samples: fit.samples,
        hidden_share: fit.hidden_share,
    }
}

fn center(text: &str) -> Result<CenterChoice> {
    if text == "centroid" {
        return Ok(CenterChoice::Centroid);
    }
    let point = text.split_once(',').and_then(|(x, y)| {
        let number = |t: &str| exact_literal(t).ok();
        Some([number(x)?, number(y)?])
    });
    let wrong = || {
        Error::Usage(format!(
            "--center {text}: expected centroid or X,Y, such as 12.5,-3"
        ))
    };
    let point: [Rational; 2] = point.ok_or_else(wrong)?;
    Ok(CenterChoice::Point(point))
}
