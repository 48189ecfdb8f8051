//! The syntax of the command line. The verbs decide what the values mean.

use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use stellate::document::Format;
use stellate::verb::{BoxSides, CoordinatesFrom, DIGITS, Frame, MESH_RESOLUTION, PICTURE_CELLS};

use super::check_arguments::{CHECK_EXAMPLES, Check, VECTORS_EXAMPLES, Vectors};
use super::flags::{ArcFlags, FitFlags, ProofFlag};
use super::inspect_arguments::Inspect;
use super::values::{
    Angle, angle, degrees, frame, marked_point, range, space_window, time, view, whole, within,
};

/// Exact conversion between parametric and implicit forms of star-shaped curves and surfaces.
#[derive(Debug, Parser)]
#[command(version, about, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) verb: Verb,
    #[command(flatten)]
    pub(crate) common: Common,
}

pub(crate) const FORMS: &str = "\
A FORM is text, a file, or - for standard input:
  'r = 1 + 1/5*cos(3*t) - 0.1*sin(5*t)'   a Fourier radius (angle t or theta)
  'r = 1/(1 + cos(t)/2)'  'r^2 = cos(2t)' other polar curves
  'x = sin(t); y = sin(t)*cos(t)'         a parametric curve; with z = ... a space curve
  'x = u*cos(v); y = u*sin(v); z = u^2'   a patch, in two parameters (t, theta, u, v, phi, s, w)
  'x^4 - x^2 + y^2 = 0'                   an implicit curve in x, y, or a surface in x, y, z
  'x^2 + y^2 = 1; z = y^5'                a space curve as an intersection of surfaces
  'superquadric 2d a=1,2 e=1/2'           |x/a1|^(2/e) + |y/a2|^(2/e) = 1, or = c with level=c
  'superquadric 3d a=1,1,2 e=1/2,1'       in space, with two exponents: Eq. (77) of the paper
  outline.csv|.tsv|.txt|.dat|.xy|.npy     a contour: rows x,y in order, or a NumPy array of them
  outline.png|.jpg|.bmp                   a contour: a silhouette
  outline.svg|.geojson                    a contour: the largest closed path, or the largest polygon
  document.json                           what another verb wrote
Numbers are exact as written: 0.1 is 1/10.

Exit codes:
  0  done
  1  done, and the answer is no (check, inspect, paper)
  2  the input or the usage is wrong; nothing is written
  3  a limit was reached; what was finished is written
  4  the program contradicted itself; please report the input

Example: an outline of 290 points becomes a polynomial of degree 80, a picture and certified points:
  stellate implicitize paper-examples/e02-butterfly/butterfly.csv --harmonics 39 -o f.json
  stellate plot paper-examples/e02-butterfly/butterfly.csv f.json -o butterfly.svg
  stellate sample f.json --directions 720";

/// Options of every verb.
#[derive(Debug, Args)]
pub(crate) struct Common {
    /// Write to FILE (beside it first, then renamed) instead of standard output, which is -, too; without --format its name
    /// chooses the format: .txt text, .json, .csv, .tex LaTeX
    #[arg(short, long, global = true, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// How the result is written [default: what the name of -o says, else text; sample and inspect: csv; vectors: json]
    #[arg(long, global = true, value_parser = formats())]
    pub(crate) format: Option<Format>,
    /// Decimals shown for algebraic numbers [default: 16]; inspect: significant digits of the distances [default: 6];
    /// check: the digits that everything must have
    #[arg(long, global = true, value_name = "D", value_parser = within(DIGITS))]
    pub(crate) digits: Option<u32>,
    /// Read decimals as written, or as the nearest double
    #[arg(long, global = true, value_enum, default_value_t = NumberReading::Exact)]
    pub(crate) numbers: NumberReading,
    /// Of a file of spherical harmonics: their normalization [default: l m C S: 4pi, n m Re Im: orthonormal,
    /// l,m,value: unnormalized]
    #[arg(long, global = true, value_enum)]
    pub(crate) normalization: Option<NormalizationFlag>,
    /// Of a file of spherical harmonics: whether they have the phase (-1)^m [default: only in n m Re Im]
    #[arg(long, global = true, value_enum, value_name = "YES|NO")]
    pub(crate) condon_shortley: Option<YesNo>,
    /// Refuse polynomials above this degree
    #[arg(long, global = true, value_name = "D", default_value_t = 20_002, value_parser = whole::<usize>(0..=u64::MAX, 100))]
    pub(crate) max_degree: usize,
    /// Stop long work after this many seconds, or with a unit: 500ms, 5min, 2h (exit code 3)
    #[arg(long, global = true, value_name = "SECONDS", value_parser = time(60))]
    pub(crate) time_limit: Option<Duration>,
    /// Threads to use [default: one per core]; the output does not depend on it
    #[arg(long, global = true, value_name = "N", value_parser = whole::<usize>(0..=u64::MAX, 4))]
    pub(crate) threads: Option<usize>,
    /// Print one line of JSON with times, peak memory and how many rays needed how many bits on standard error when done
    #[arg(long, global = true)]
    pub(crate) stats: bool,
    /// No notes and no progress bar on standard error
    #[arg(long, global = true)]
    pub(crate) quiet: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum NormalizationFlag {
    /// The harmonics as they are
    Unnormalized,
    /// Mean square 1
    #[value(name = "4pi")]
    FourPi,
    /// Integral of the square 1
    Orthonormal,
    /// Mean square 1/(2l + 1)
    Schmidt,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum YesNo {
    Yes,
    No,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum NumberReading {
    /// 0.1 is 1/10
    Exact,
    /// 0.1 is the double nearest to it, bit for bit
    F64,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Tell what a form is: degree, parts, lemma, star-shapedness, what is certain about it
    #[command(after_help = "Examples:
  stellate describe 'r = 1 + 1/5*cos(3*t)'
  stellate describe --topology 'y^2 = (x-1)^2*(x-2)'")]
    Describe(Describe),
    /// Turn a Fourier radius, a contour, a parametric curve or a patch into its exact implicit equation (Theorems 1 to 4)
    #[command(after_help = "Examples:
  stellate implicitize 'r = 1 + 1/5*cos(t) + 0.1*sin(t)'
  stellate implicitize 'x = sin(t); y = sin(t)*cos(t)' --method polar
  stellate implicitize 'x = cos(theta)*sin(phi); y = cos(theta); z = cos(phi)'
  stellate implicitize outline.csv --harmonics 39 -o f.json
  stellate implicitize f.json --format singular")]
    Implicitize(Implicitize),
    /// Turn an implicit polynomial into its radius r(theta), or R(theta, phi) in space: closed forms (Lemmas 2 to 5, 7 to 10), else certified roots and a Fourier fit (Lemma 6), with exact ranges
    #[command(after_help = "Examples:
  stellate parametrize 'x^6 + y^6 + x*y^3 = 1 + x' --harmonics 12
  stellate parametrize 'x^2/4 + y^2/9 + z^2 = 1' --theta 30deg
  stellate parametrize '100x^4 + 200x^2y^2 + 100y^4 - 40x^3 - 20x^2y - 40xy^2 - 20y^3 - 96x^2 + 4xy - 99y^2'")]
    Parametrize(Parametrize),
    /// Fit a Fourier radius (Definition 1) or an elliptic Fourier series to a contour, or spherical harmonics to a closed mesh
    #[command(after_help = "Examples:
  stellate fit outline.csv --harmonics 39 --decimals 6
  stellate fit silhouette.png --tolerance 1.5 -o radius.json
  stellate fit silhouette.png --model elliptic --distance 2 -o series.json
  stellate fit wings/*.csv --model elliptic --harmonics 16 -o table.csv
  stellate fit particle.stl --degree 12 -o particle.json")]
    Fit(Fit),
    /// Certified points: exact directions, all real roots r (of a parametric plane curve those that real parameters have), each the nearest double
    #[command(after_help = "Examples:
  stellate sample 'x^4 - x^2 + y^2' --directions 8
  stellate sample f.json --theta 0.5 --theta 219.5deg --positive
  stellate sample 'x^4 + y^4 + z^4 - 1' --theta 30deg --phi 45deg --phi 60deg")]
    Sample(Sample),
    /// Whether points are within a tolerance of a surface or plane curve, exactly (Theorem 8), and how far they are
    #[command(after_help = "Examples:
  stellate inspect 'x^2 + y^2 = 1' --tolerance 0.1 --point 0.8,0.6,0 --format text
  stellate inspect '(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)' --tolerance 1/100 --points measured.csv -o verdicts.csv
  stellate inspect 'x^4 + y^4 + z^4 = 1' --tolerance 0.01 --points - --plot deviations.png
  stellate inspect part.csv --harmonics 20 --tolerance=-0.02,0.05 --uncertainty 0.004 --points probed.csv --feet

Exit code: 0 if all points are inside, 1 if one is outside or uncertain, 3 if one is undecided.")]
    Inspect(Inspect),
    /// Triangles of a surface as OBJ, PLY or STL: every sheet, certified vertices
    #[command(after_help = "Examples:
  stellate mesh '(x^2+9/4*y^2+z^2-1)^3 - x^2*z^3 - 9/80*y^2*z^3' -o heart.ply
  stellate mesh 'x^3 + y^3 + z^3 + 1 = (x+y+z+1)^3' --window=-4,4,-4,4,-4,4 -o clebsch.obj")]
    Mesh(Mesh),
    /// Draw forms over each other with equal axes, as SVG or PNG; curves and surfaces in space in perspective
    #[command(after_help = "Examples:
  stellate plot outline.csv radius.json f.json -o figure.svg
  stellate plot 'x = (2 + cos(v))*cos(u); y = (2 + cos(v))*sin(u); z = sin(v)' -o torus.svg
  stellate plot 'x^2 + y^2 + 0z = 1' 'z = y^5' 'x = cos(t); y = sin(t); z = sin(t)^5' -o curve.png")]
    Plot(Plot),
    /// How many digits of a float program's coefficients, points or radii are right, and which usual mistake explains the rest
    #[command(after_help = CHECK_EXAMPLES)]
    Check(Check),
    /// Test vectors for float programs: inputs, exact results, nearest doubles and condition numbers, as one JSON document
    #[command(after_help = VECTORS_EXAMPLES)]
    Vectors(Vectors),
    /// The whole paper, statement by statement: what is printed, what is true, and the evidence, computed each time
    #[command(after_help = "Examples:
  stellate paper
  stellate paper --only E9
  stellate paper --only \"Theorem 2\"
  stellate paper --out report
  stellate paper --out report --compare
  stellate paper -o paper.json

Exit code: 1 if the outcome of a statement is not the recorded one, or if two methods of --compare disagree.")]
    Paper(Paper),
    /// Check a proof file: whether every claim with a witness holds
    #[command(after_help = "Examples:
  stellate verify proof.json
  stellate verify --checker > checker.py

Exit code: 0 if every claim with a witness holds, 1 if one does not.")]
    Verify(Verify),
    /// Write the completions of a shell, to be put where it looks for them
    #[command(after_help = "Example:
  stellate completions bash > ~/.local/share/bash-completion/completions/stellate")]
    Completions(Completions),
    /// The JSON Schema of a kind of document, or of all kinds
    #[command(
        after_help = "Examples:\n  stellate schema implicit -o implicit.schema.json\n  stellate schema"
    )]
    Schema(Schema),
    /// Write the manual page, in roff
    #[command(after_help = "Example:
  stellate man -o stellate.1 && man ./stellate.1")]
    Man,
}

#[derive(Debug, Args)]
pub(crate) struct Schema {
    /// The kind, as in the field "kind" of a document
    #[arg(value_parser = PossibleValuesParser::new(stellate::document::schema_kinds()))]
    pub(crate) kind: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct Verify {
    /// The proof file, or - for standard input
    #[arg(required_unless_present = "checker", conflicts_with = "checker")]
    pub(crate) file: Option<String>,
    /// A claim without a witness also makes the exit code 1
    #[arg(long, conflicts_with = "checker")]
    pub(crate) complete: bool,
    /// Print the same checker as a program in Python, which needs nothing but its standard library
    #[arg(long)]
    pub(crate) checker: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Completions {
    /// The shell
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Debug, Args)]
pub(crate) struct Paper {
    /// Statements in full, with their formulas and the evidence: one by its id (T2, L4, E9, Eq63, F12, AppB, ...), or all
    /// with these words in their titles
    #[arg(long, value_name = "ID|TITLE")]
    pub(crate) only: Option<String>,
    /// Write the report DIR/index.html, too: one page with all formulas, figures and errata
    #[arg(long, value_name = "DIR", conflicts_with = "only")]
    pub(crate) out: Option<PathBuf>,
    /// Measure Theorem 2 beside elimination, too, for N = 1, 2, 3, ... harmonics: by this program and, where they are
    /// installed, by PARI/GP (gp), Singular and SymPy (python3); takes some minutes
    #[arg(long)]
    pub(crate) compare: bool,
    /// A method of --compare stops where one run takes longer than this; there are at most 14 runs of each
    #[arg(
        long,
        value_name = "SECONDS",
        default_value = "10",
        requires = "compare",
        value_parser = time(10)
    )]
    pub(crate) compare_limit: Duration,
    /// The largest N that --compare measures
    #[arg(long, value_name = "N", default_value_t = 110, requires = "compare", value_parser = whole::<usize>(1..=u64::MAX, 110))]
    pub(crate) compare_up_to: usize,
}

impl Verb {
    /// The file for the claims of the output.
    pub(crate) fn proof(&self) -> Option<&Path> {
        let flag = match self {
            Self::Describe(verb) => &verb.proof,
            Self::Implicitize(verb) => &verb.proof,
            Self::Parametrize(verb) => &verb.proof,
            Self::Fit(verb) => &verb.proof,
            Self::Sample(verb) => &verb.proof,
            Self::Inspect(verb) => &verb.proof,
            _ => return None,
        };
        flag.proof.as_deref()
    }
}

#[derive(Debug, Args)]
pub(crate) struct Describe {
    /// What to describe
    #[arg(allow_hyphen_values = true)]
    pub(crate) form: String,
    /// For plane curves: components and what contains what, exact extents, singular points, asymptotes, and the genus of each
    /// factor
    #[arg(long)]
    pub(crate) topology: bool,
    #[command(flatten)]
    pub(crate) fit: FitFlags,
    #[command(flatten)]
    pub(crate) proof: ProofFlag,
}

#[derive(Debug, Args)]
pub(crate) struct Implicitize {
    /// A Fourier radius, a contour, a parametric curve or patch, a superquadric, or an implicit form to be rewritten
    #[arg(allow_hyphen_values = true)]
    pub(crate) form: String,
    #[command(flatten)]
    pub(crate) fit: FitFlags,
    /// The paper's substitution into polar or spherical coordinates, with its spurious factors named, or a
    /// resultant (plane curves) [default: Theorem 2 for radii, resultant for plane curves, certified linear
    /// algebra in space]
    #[arg(long, value_enum)]
    pub(crate) method: Option<ImplicitizeMethod>,
    /// Coprime integers with the first term positive, or first coefficient 1
    #[arg(long, value_enum, default_value_t = ScaleFlag::Integer)]
    pub(crate) scale: ScaleFlag,
    /// Coordinates relative to the center of the fit, or the contour's own
    #[arg(long, value_enum, default_value_t = CoordinatesFlag::Center)]
    pub(crate) coordinates: CoordinatesFlag,
    #[command(flatten)]
    pub(crate) proof: ProofFlag,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ImplicitizeMethod {
    /// Theorems 1, 3 and 4 of the paper
    Polar,
    /// By elimination of the parameter; plane curves only
    Resultant,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ScaleFlag {
    Integer,
    Monic,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CoordinatesFlag {
    #[value(alias = "centre")]
    Center,
    Original,
}

impl From<CoordinatesFlag> for CoordinatesFrom {
    fn from(flag: CoordinatesFlag) -> Self {
        match flag {
            CoordinatesFlag::Center => Self::Center,
            CoordinatesFlag::Original => Self::Original,
        }
    }
}

#[derive(Debug, Args)]
pub(crate) struct Parametrize {
    /// An implicit polynomial in x, y or in x, y, z, a Fourier radius, a superquadric or a contour
    #[arg(allow_hyphen_values = true)]
    pub(crate) form: String,
    /// For a surface: the exact ranges of phi on the meridian with this angle, for the rational unit vector that is printed; may be repeated
    #[arg(long, value_name = "A", allow_hyphen_values = true, value_parser = angle)]
    pub(crate) theta: Vec<Angle>,
    /// For a surface: what is certain in every direction (theta, phi) with these angles; may be repeated
    #[arg(long, value_name = "B", allow_hyphen_values = true, requires = "theta", value_parser = angle)]
    pub(crate) phi: Vec<Angle>,
    #[command(flatten)]
    pub(crate) arcs: ArcFlags,
    #[command(flatten)]
    pub(crate) fit: FitFlags,
    /// The branch to fit a Fourier series to where there is no closed form [default: the outermost]
    #[arg(long, value_name = "I", value_parser = whole::<usize>(0..=u64::MAX, 1))]
    pub(crate) branch: Option<usize>,
    #[command(flatten)]
    pub(crate) proof: ProofFlag,
}

#[derive(Debug, Args)]
pub(crate) struct Fit {
    /// Contours: .csv rows x,y, .npy, .geojson, .svg, or silhouettes .png, .jpg, .bmp; of several files one row each is written.
    /// Or a closed mesh .obj, .ply, .stl
    #[arg(required = true, value_name = "CONTOUR")]
    pub(crate) contours: Vec<String>,
    /// All outlines of a picture, an SVG drawing or GeoJSON, largest first, one row each
    #[arg(long, conflicts_with = "blob")]
    pub(crate) all: bool,
    /// An elliptic series without position, size, rotation, starting point and direction, to compare specimens
    #[arg(long)]
    pub(crate) normal_form: bool,
    /// Of a mesh: the degree L of the spherical harmonics
    #[arg(long, value_name = "L", group = "size", value_parser = whole::<usize>(0..=u64::MAX, 12))]
    pub(crate) degree: Option<usize>,
    #[command(flatten)]
    pub(crate) fit: FitFlags,
    #[command(flatten)]
    pub(crate) proof: ProofFlag,
}

#[derive(Debug, Args)]
pub(crate) struct Sample {
    /// A Fourier radius, a contour, a superquadric, an implicit polynomial in x, y or x, y, z, or two surfaces
    /// that meet in a curve
    #[arg(allow_hyphen_values = true)]
    pub(crate) form: String,
    #[command(flatten)]
    pub(crate) arcs: ArcFlags,
    #[command(flatten)]
    pub(crate) fit: FitFlags,
    /// This many directions around the circle, or spread over the sphere [default: 360 if no angle is given]; with
    /// one of the two angles of a surface, this many steps of the other
    #[arg(long, value_name = "K", value_parser = whole::<usize>(0..=u64::MAX, 360))]
    pub(crate) directions: Option<usize>,
    /// An angle: 0.5 (radians), pi/6, 30deg or 30°; may be repeated
    #[arg(long, value_name = "A", allow_hyphen_values = true, value_parser = angle)]
    pub(crate) theta: Vec<Angle>,
    /// For a surface: the angle from the z axis, likewise; every theta is taken with every phi
    #[arg(long, value_name = "B", allow_hyphen_values = true, value_parser = angle)]
    pub(crate) phi: Vec<Angle>,
    /// Coordinates of points relative to the center of the form, or the contour's own
    #[arg(long, value_enum, default_value_t = CoordinatesFlag::Center)]
    pub(crate) coordinates: CoordinatesFlag,
    /// Only points with r > 0
    #[arg(long)]
    pub(crate) positive: bool,
    #[command(flatten)]
    pub(crate) proof: ProofFlag,
}

#[derive(Debug, Args)]
pub(crate) struct Mesh {
    /// A polynomial in x, y and z, or a patch; one in x and y is a cylinder
    #[arg(allow_hyphen_values = true)]
    pub(crate) form: String,
    /// The box that is covered [default: around the surface]
    #[arg(long, value_name = "X0,X1,Y0,Y1,Z0,Z1", allow_hyphen_values = true, value_parser = space_window)]
    pub(crate) window: Option<BoxSides>,
    /// Cells along the longest side of the box, or of each box if factors have disjoint ones
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = within(MESH_RESOLUTION))]
    pub(crate) resolution: u32,
    /// Edges are split where the surface bends by more than this: degrees, or with a unit as pi/9
    #[arg(long, value_name = "DEGREES", default_value = "20", value_parser = degrees)]
    pub(crate) angle: f64,
    /// Turn closed pieces inside others inward, as the boundary of the solid between them
    #[arg(long)]
    pub(crate) solid: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Plot {
    /// What to draw, from the lowest to the topmost
    #[arg(required = true)]
    pub(crate) forms: Vec<String>,
    #[command(flatten)]
    pub(crate) fit: FitFlags,
    /// The part of the plane that is shown: x0,x1,y0,y1; in space x0,x1,y0,y1,z0,z1
    #[arg(long, value_name = "X0,X1,Y0,Y1[,Z0,Z1]", allow_hyphen_values = true, value_parser = frame)]
    pub(crate) window: Option<Frame>,
    /// The part of a parameter that is drawn, as t=-2,2 or t=0,2pi; may be repeated [default: once around for an angle, all
    /// numbers for a bounded curve, else -1.5,1.5]
    #[arg(long, value_name = "NAME=A,B", value_parser = range)]
    pub(crate) range: Vec<(String, [f64; 2])>,
    /// In space: where the eye is, in degrees from +x towards +y, and above the plane of x and y [default: 30,25]
    #[arg(long, value_name = "AZIMUTH,ELEVATION", allow_hyphen_values = true, value_parser = view)]
    pub(crate) view: Option<[f64; 2]>,
    /// Heading of the figure
    #[arg(long, default_value = "")]
    pub(crate) title: String,
    /// Width of the picture in units of the SVG, from 300 to 4000: a narrow one has large letters [default: 900]
    #[arg(long, value_name = "UNITS")]
    pub(crate) width: Option<u32>,
    /// Cells along the larger side: for tracing implicit curves [default: 240], for surfaces [default: 36], along
    /// each parameter of a patch [default: 54, more for oscillations]
    #[arg(long, value_name = "N", value_parser = within(PICTURE_CELLS))]
    pub(crate) cells: Option<u32>,
    /// In space: a point to be marked; may be repeated
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = marked_point)]
    pub(crate) point: Vec<[f64; 3]>,
}

/// A parser of the names of formats; the help explains each of them.
fn formats() -> impl TypedValueParser<Value = Format> {
    let names = Format::ALL.map(|format| {
        let name = PossibleValue::new(format.name()).help(format.about());
        match format {
            Format::Latex => name.alias("tex"),
            _ => name,
        }
    });
    PossibleValuesParser::new(names).try_map(|name| name.parse())
}
