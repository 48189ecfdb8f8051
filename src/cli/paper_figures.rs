//! The figures of the paper, drawn again by `stellate plot`.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::Parser;
use stellate::document::{Format, write_fourier};
use stellate::error::{Error, Result};
use stellate::language::{Numbers, parse_form};
use stellate::paper::{EXAMPLE_DATA, ReportFigure};
use stellate::parametrize::{BranchFitOptions, fit_branch, parametrize};
use stellate::shape::Form;

use super::arguments::{Arguments, Verb};
use super::plot;
use super::session::Session;

/// A figure: the statement that it stands beside, what it shows, and what is plotted.
type Drawn = (&'static str, &'static str, &'static [&'static str]);

/// The circle of Example 7 runs from one tangent point to the other in these parts of its angle.
const FAR: &str = "t=-1.5707963267948966,3.141592653589793";
const NEAR: &str = "t=3.141592653589793,4.71238898038469";

/// The curve of Example 9, and the series that is fitted to it.
const CURVE: &str = "paper-examples/e09-sixth-degree/curve.txt";
const FIT: &str = "fit.txt";

const CIRCLE: &str = "x = 1 + cos(t); y = 1 + sin(t)";

const FIGURES: [Drawn; 15] = [
    (
        "F1",
        "The figure eight, as a parametric curve and as a zero set, one over the other: it crosses itself in the origin.",
        &["x = sin(t); y = sin(t)*cos(t)", "x^4 - x^2 + y^2"],
    ),
    (
        "F2",
        "The outline of a jet, its Fourier radius with 39 harmonics and the zero set of degree 80, one over the other.",
        &["paper-examples/e02-jet/jet.csv", "--harmonics", "39"],
    ),
    (
        "F3",
        "The outline of a butterfly, its Fourier radius with 39 harmonics and the zero set of degree 80, one over the other.",
        &[
            "paper-examples/e02-butterfly/butterfly.csv",
            "--harmonics",
            "39",
        ],
    ),
    (
        "F4",
        "The space curve of Example 3, a saddle over the unit circle, and its shadow on the floor.",
        &["x = sin(t); y = cos(t); z = cos(t)^2"],
    ),
    (
        "F5",
        "The same curve where the cylinder over the unit circle and the parabolic cylinder z = 1 - x^2 meet.",
        &[
            "x = cos(theta); y = sin(theta); z = v",
            "x = u; y = v; z = 1 - u^2",
            "x = sin(t); y = cos(t); z = cos(t)^2",
            "--range=v=-1.2,1.2",
            "--range=u=-1.2,1.2",
            "--window=-1.2,1.2,-1.2,1.2,-0.5,1.2",
            "--cells=28",
        ],
    ),
    (
        "F6",
        "The patch of Example 4: a surface in the cube from -1 to 1 that narrows to lines.",
        &[
            "x = cos(theta)*sin(phi); y = cos(theta); z = cos(phi)",
            "--cells=36",
        ],
    ),
    (
        "F7",
        "The circle of Example 7, of radius 1 about (1, 1), as a zero set.",
        &["x^2 + y^2 - 2x - 2y + 1"],
    ),
    (
        "F8",
        "The far arc of the circle, three quarters of it, between the points where the axes touch it.",
        &[CIRCLE, "--range", FAR],
    ),
    (
        "F9",
        "The near arc of the circle, a quarter of it, between the points where the axes touch it.",
        &[CIRCLE, "--range", NEAR],
    ),
    (
        "F10",
        "The curve of degree 32: both axes, an outer curve with four corners and a small rounded square.",
        &["(x^4 - 1.9x^2*y^2 + y^4 - 0.5)*(x^8 + y^8 - 1e-5)*x^10*y^10"],
    ),
    (
        "F11",
        "The closed curve of degree 6 of Example 9.",
        &[CURVE],
    ),
    (
        "F12",
        "The curve of Example 9, and over it the Fourier series that is fitted to its outermost radius.",
        &[CURVE, FIT],
    ),
    (
        "E9",
        "The fold that the paper does not see: the straight line, the ray at 219.5 degrees, meets the curve three times.",
        &[CURVE, "y = 0.82434*x", "--window=-60,-36,-50,-30"],
    ),
    (
        "F13",
        "The curve (cos t, sin t, sin^5 t) where the cylinder over the unit circle and the surface z = y^5 meet.",
        &[
            "x^2 + y^2 + 0z = 1",
            "z = y^5",
            "x = cos(t); y = sin(t); z = sin(t)^5",
            "--window=-1.3,1.3,-1.3,1.3,-1.3,1.3",
            "--view=20,30",
            "--cells=14",
        ],
    ),
    (
        "F14",
        "The water pipe, a cylinder of radius 1, and the point (0.8, 0.6, 0) on it.",
        &[
            "x = cos(theta); y = sin(theta); z = v",
            "--range=v=-1,1",
            "--point=0.8,0.6,0",
            "--view=60,25",
            "--cells=32",
        ],
    ),
];

/// Draws them; the data of paper-examples and the fit of Example 9 are put into a temporary folder for that.
pub(super) fn draw(session: &Session) -> Result<Vec<ReportFigure>> {
    let folder = tempfile::tempdir().map_err(failed)?;
    for (path, text) in EXAMPLE_DATA {
        write(folder.path(), path, text)?;
    }
    write(folder.path(), FIT, &fit_of_example_9(session)?)?;
    let mut figures = Vec::new();
    for (done, (id, caption, words)) in (0..).zip(FIGURES) {
        session.progress("drawing the figures", done, FIGURES.len() as u64);
        session.limits.check()?;
        figures.push(ReportFigure {
            id,
            caption,
            command: command(words),
            svg: svg(words, folder.path(), session)?,
        });
    }
    let total = FIGURES.len() as u64;
    session.progress("drawing the figures", total, total);
    Ok(figures)
}

fn failed(source: std::io::Error) -> Error {
    Error::Io {
        path: std::env::temp_dir(),
        source,
    }
}

/// Whether a word names a file of the temporary folder.
fn is_data(word: &str) -> bool {
    word == FIT || EXAMPLE_DATA.iter().any(|(path, _)| *path == word)
}

/// Where such a file is.
fn place(folder: &Path, word: &str) -> PathBuf {
    folder.join(Path::new(word).file_name().unwrap_or_default())
}

fn write(folder: &Path, word: &str, text: &str) -> Result<()> {
    std::fs::write(place(folder, word), text).map_err(failed)
}

/// The Fourier series of the outermost radius, as `stellate parametrize` fits it.
fn fit_of_example_9(session: &Session) -> Result<String> {
    let text = EXAMPLE_DATA.iter().find(|(path, _)| *path == CURVE);
    let (name, text) = text.copied().unwrap_or((CURVE, ""));
    let Form::Curve(curve) = parse_form(text, name, Numbers::Exact)? else {
        return Err(Error::Usage(format!("{name} has no plane curve")));
    };
    let found = parametrize(&curve, &session.limits)?;
    let Some(fit) = fit_branch(&found, &BranchFitOptions::default(), &session.limits)? else {
        return Err(Error::Usage(format!(
            "{name} has no radius in every direction"
        )));
    };
    let mut text = Vec::new();
    write_fourier(&fit.radius, None, Format::Text, &mut text)?;
    Ok(String::from_utf8_lossy(&text).into_owned())
}

/// As it would be typed.
fn command(words: &[&str]) -> String {
    let typed = words.iter().map(|word| {
        if word.contains([' ', '*', '^', '(']) {
            format!("\"{word}\"")
        } else {
            (*word).to_owned()
        }
    });
    format!("stellate plot {}", typed.collect::<Vec<_>>().join(" "))
}

fn svg(words: &[&str], folder: &Path, session: &Session) -> Result<String> {
    let words = words.iter().map(|word| {
        if is_data(word) {
            place(folder, word).into_os_string()
        } else {
            word.into()
        }
    });
    let program = ["stellate", "plot"].map(OsString::from);
    let arguments = Arguments::try_parse_from(program.into_iter().chain(words));
    match arguments.map(|arguments| arguments.verb) {
        Ok(Verb::Plot(verb)) => plot::svg(&verb, session),
        Ok(_) => Err(Error::Usage("a figure is plotted".into())),
        Err(error) => Err(Error::Usage(error.to_string())),
    }
}
