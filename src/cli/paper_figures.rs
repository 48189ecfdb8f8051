//! The figures of the paper, drawn again by `stellate plot`.

use std::path::Path;

use clap::Parser;
use stellate::error::{Error, Invariant, Result};
use stellate::language::Numbers;
use stellate::paper::{EXAMPLE_DATA, ReportFigure};
use stellate::parametrize::{BranchFitOptions, fit_branch, parametrize};
use stellate::shape::Form;
use stellate::verb::{Content, Given};

use super::arguments::{Arguments, Verb};
use super::plot;
use super::session::Session;

/// A figure: the id of its statement, its caption, and the arguments of `stellate plot` that draw it.
type Drawn = (&'static str, &'static str, &'static [&'static str]);

/// The ranges of the angle on the two arcs of the circle of Example 7. The arcs end where the axes touch the circle.
const FAR: &str = "t=-1.5707963267948966,3.141592653589793";
const NEAR: &str = "t=3.141592653589793,4.71238898038469";

/// The curve of Example 9.
const CURVE: &str = "paper-examples/e09-sixth-degree/curve.txt";

/// The argument for standard input. The only form that a figure reads there is the series that is fitted to this curve.
const INPUT: &str = "-";
const INPUT_NAME: &str = "standard input";

/// The width of a figure in units of the SVG. It is narrow, so that the letters can be read on a phone.
const WIDTH: &str = "--width=420";

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
        "The same curve where the cylinder over the unit circle and the parabolic cylinder $z = 1 − x²$ meet.",
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
        "The circle of Example 7, of radius 1 about $(1, 1)$, as a zero set.",
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
        &[CURVE, INPUT],
    ),
    (
        "E9",
        "The fold that the paper does not see: the straight line, the ray at 219.5 degrees, meets the curve three times.",
        &[CURVE, "y = 0.82434*x", "--window=-60,-36,-50,-30"],
    ),
    (
        "F13",
        "The curve $(cos t, sin t, sin⁵ t)$ where the cylinder over the unit circle and the surface $z = y⁵$ meet.",
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
        "The water pipe, a cylinder of radius 1, and the point $(0.8, 0.6, 0)$ on it.",
        &[
            "x = cos(theta); y = sin(theta); z = v",
            "--range=v=-1,1",
            "--point=0.8,0.6,0",
            "--view=60,25",
            "--cells=32",
        ],
    ),
];

/// Draws the figures. Files of the repository are read from the copies that are built into the program, under the same paths.
pub(super) fn draw(session: &Session) -> Result<Vec<ReportFigure>> {
    let mut figures = Vec::new();
    for (done, (id, caption, words)) in (0..).zip(FIGURES) {
        session.progress("drawing the figures", done, FIGURES.len() as u64);
        session.limits.check()?;
        let command = Command::new(id, words);
        figures.push(ReportFigure {
            id,
            caption,
            svg: svg(&command, session)?,
            command: command.typed(),
        });
    }
    let total = FIGURES.len() as u64;
    session.progress("drawing the figures", total, total);
    Ok(figures)
}

/// The words of a command that draws a figure.
struct Command(Vec<String>);

impl Command {
    fn new(id: &str, words: &[&str]) -> Self {
        let file = format!("{}.svg", id.to_lowercase());
        let before = ["stellate", "plot"].iter();
        let after = [WIDTH, "-o", &file];
        let words = before.chain(words).chain(&after);
        Self(words.map(|&word| word.to_owned()).collect())
    }

    /// The command as it is typed in the top folder of the repository.
    fn typed(&self) -> String {
        let typed = self.0.iter().map(|word| {
            if word.contains([' ', '*', '^', '(']) {
                format!("\"{word}\"")
            } else {
                word.clone()
            }
        });
        let typed = typed.collect::<Vec<_>>().join(" ");
        if self.0.iter().any(|word| word == INPUT) {
            format!("stellate parametrize {CURVE} | {typed}")
        } else {
            typed
        }
    }
}

fn svg(command: &Command, session: &Session) -> Result<String> {
    let arguments = Arguments::try_parse_from(&command.0);
    match arguments.map(|arguments| arguments.verb) {
        Ok(Verb::Plot(verb)) => plot::svg(&verb, session, |form| read(form, session)),
        Ok(_) => Err(Error::Usage("a figure is plotted".into())),
        Err(error) => Err(Error::Usage(error.to_string())),
    }
}

/// Reads a form of a figure: the fitted series, a file that is built in, or a formula.
fn read(form: &str, session: &Session) -> Result<Given> {
    if form == INPUT {
        let form = fit_of_example_9(session)?;
        return Ok(Given::new(INPUT_NAME, Content::Exact(form)));
    }
    match EXAMPLE_DATA.iter().find(|(path, _)| *path == form) {
        Some((path, text)) => {
            let name = Path::new(path)
                .file_name()
                .invariant("the path of an example ends in a file");
            let given = Given::from_reader(text.as_bytes(), path, Numbers::Exact)?;
            Ok(Given::new(name.to_string_lossy(), given.into_content()))
        }
        None => Given::read(form, Numbers::Exact),
    }
}

/// The Fourier series of the outermost radius of Example 9, as `stellate parametrize` fits it.
fn fit_of_example_9(session: &Session) -> Result<Form> {
    let Content::Exact(Form::Curve(curve)) = read(CURVE, session)?.into_content() else {
        return Err(Error::Usage(format!("{CURVE} has no plane curve")));
    };
    let found = parametrize(&curve, &session.limits)?;
    match fit_branch(&found, &BranchFitOptions::default(), &session.limits)? {
        Some(fit) => Ok(Form::Fourier(fit.radius)),
        None => Err(Error::Usage(format!(
            "{CURVE} has no radius in every direction"
        ))),
    }
}
