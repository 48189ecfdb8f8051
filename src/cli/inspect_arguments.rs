//! The syntax of `inspect`.

use std::path::PathBuf;

use clap::Args;
use stellate::exact::Rational;
use stellate::fit::CenterChoice;
use stellate::inspect::ToleranceZone;
use stellate::verb::Frame;

use super::flags::{ModelFlag, OutlineFlags, ProofFlag};
use super::values::{center, frame, point, positive, tolerance, whole};

#[derive(Debug, Args)]
pub(crate) struct Inspect {
    /// A surface, or a curve of the plane (for points X,Y; for points X,Y,Z it is a cylinder) or of space. An equation stands for
    /// its zero set, any other form for itself
    #[arg(allow_hyphen_values = true)]
    pub(crate) form: String,
    /// The largest distance that is inside, exactly as written: 0.1 is one tenth; or two limits of the signed distance,
    /// LOW ≤ 0 ≤ HIGH, which is negative inside a form with sides, such as -0.02,0.05
    #[arg(long, value_name = "D|LOW,HIGH", allow_hyphen_values = true, value_parser = tolerance)]
    pub(crate) tolerance: ToleranceZone,
    /// The true point is at most this far from the measured one: a point is inside, or outside, if it would be so at any distance that
    /// is larger or smaller by at most this; otherwise it is uncertain
    #[arg(long, value_name = "U", value_parser = positive)]
    pub(crate) uncertainty: Option<Rational>,
    /// A point; may be repeated
    #[arg(long, value_name = "X,Y[,Z]", allow_hyphen_values = true, value_parser = point)]
    pub(crate) point: Vec<String>,
    /// Rows x,y[,z] of any number, from a file or standard input; the header is optional. Also the vertices of a .ply file and a NumPy
    /// array (.npy) of the shape (n, 2) or (n, 3); with the feature columnar .parquet and .arrow
    #[arg(long, value_name = "FILE|-", conflicts_with = "point")]
    pub(crate) points: Option<String>,
    /// Distances are looked for up to here [default: until the nearest point is found]
    #[arg(long, value_name = "R", value_parser = positive)]
    pub(crate) reach: Option<Rational>,
    /// Carry the other columns of the table along, such as ids and units
    #[arg(long)]
    pub(crate) keep: bool,
    /// Add the nearest point of the form, the normal there and bounds of the signed distance
    #[arg(long)]
    pub(crate) feet: bool,
    /// Count rows that are no points instead of stopping at the first
    #[arg(long)]
    pub(crate) skip_bad: bool,
    /// Cubes that may be divided for one point before it is undecided
    #[arg(long, value_name = "N", default_value_t = 50_000, value_parser = whole::<usize>(0..=u64::MAX, 50_000))]
    pub(crate) budget: usize,
    /// Draw the surface and the points, coloured by verdict, as .svg or .png
    #[arg(long, value_name = "FIGURE")]
    pub(crate) plot: Option<PathBuf>,
    /// Write a report into this folder: the summary, a map, the histogram and the worst points as one page
    #[arg(long, value_name = "DIR")]
    pub(crate) report: Option<PathBuf>,
    /// Write the points, coloured by verdict and with their distances, as .ply
    #[arg(long, value_name = "CLOUD.ply")]
    pub(crate) cloud: Option<PathBuf>,
    /// The part of space or of the plane that is drawn
    #[arg(long, value_name = "X0,X1,Y0,Y1[,Z0,Z1]", allow_hyphen_values = true, value_parser = frame)]
    pub(crate) window: Option<Frame>,
    /// For a contour: the series that is fitted
    #[arg(long, value_enum, default_value_t = ModelFlag::Radius)]
    pub(crate) model: ModelFlag,
    /// For a contour: number of harmonics N
    #[arg(short = 'n', long, value_name = "N", conflicts_with = "distance", value_parser = whole::<usize>(0..=u64::MAX, 39))]
    pub(crate) harmonics: Option<usize>,
    /// For a contour: the fewest harmonics with which the curve and the outline are certainly at most E apart
    #[arg(long, value_name = "E", value_parser = positive)]
    pub(crate) distance: Option<Rational>,
    /// For a contour: where radii are measured from
    #[arg(
        long,
        value_name = "auto|centroid|kernel|best|X,Y",
        default_value = "auto",
        allow_hyphen_values = true,
        value_parser = center
    )]
    pub(crate) center: CenterChoice,
    #[command(flatten)]
    pub(crate) outline: OutlineFlags,
    #[command(flatten)]
    pub(crate) proof: ProofFlag,
}
