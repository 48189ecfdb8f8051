//! Flags that several verbs have.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use stellate::exact::Rational;
use stellate::fit::{CenterChoice, Column, Columns, Estimator, FitModel};
use stellate::verb::{ARC_RESOLUTION, BoxSides};

use super::values::{center, column, columns, positive, space_window, whole, within};

/// How the curve in which two surfaces meet is followed.
#[derive(Debug, Args)]
pub(crate) struct ArcFlags {
    /// For an intersection: the box in which it is looked for [default: around the smaller surface]
    #[arg(long, value_name = "X0,X1,Y0,Y1,Z0,Z1", allow_hyphen_values = true, value_parser = space_window)]
    pub(crate) window: Option<BoxSides>,
    /// For an intersection: steps along the longest side of the box, at least [default: 64]
    #[arg(long, value_name = "N", value_parser = within(ARC_RESOLUTION))]
    pub(crate) resolution: Option<u32>,
}

/// The series that is fitted to a contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ModelFlag {
    /// The Fourier series of r(theta) (Definition 1)
    Radius,
    /// Elliptic Fourier series x(t), y(t) (Kuhl and Giardina)
    Elliptic,
}

impl From<ModelFlag> for FitModel {
    fn from(flag: ModelFlag) -> Self {
        match flag {
            ModelFlag::Radius => Self::Radius,
            ModelFlag::Elliptic => Self::Elliptic,
        }
    }
}

/// The way in which the coefficients of a series are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum EstimatorFlag {
    /// Integrals over the whole outline
    Quadrature,
    /// The least squares of the errors at the given points
    LeastSquares,
}

impl From<EstimatorFlag> for Estimator {
    fn from(flag: EstimatorFlag) -> Self {
        match flag {
            EstimatorFlag::Quadrature => Self::Quadrature,
            EstimatorFlag::LeastSquares => Self::LeastSquares,
        }
    }
}

/// How a contour becomes a Fourier series.
#[derive(Debug, Args)]
pub(crate) struct FitFlags {
    /// The radius about a center, or the coordinates by arc length, which any outline has
    #[arg(long, value_enum, default_value_t = ModelFlag::Radius)]
    pub(crate) model: ModelFlag,
    /// Number of harmonics N
    #[arg(short = 'n', long, value_name = "N", group = "size", value_parser = whole::<usize>(0..=u64::MAX, 39))]
    pub(crate) harmonics: Option<usize>,
    /// The fewest harmonics (the least degree) with which the error is at most E: the largest radial error of a radius, or the
    /// distance of an elliptic series
    #[arg(long, value_name = "E", group = "size", value_parser = positive)]
    pub(crate) tolerance: Option<Rational>,
    /// The fewest harmonics with which the curve and the outline are certainly at most E apart (Hausdorff distance)
    #[arg(long, value_name = "E", group = "size", value_parser = positive)]
    pub(crate) distance: Option<Rational>,
    /// Of an elliptic series: the fewest harmonics that have this share of the power of all, such as 0.99
    #[arg(long, value_name = "P", group = "size", value_parser = positive)]
    pub(crate) power: Option<Rational>,
    /// Where radii are measured from: the centroid where it sees the whole outline, else the middle of the kernel (auto); one of
    /// these two; the point that sees the most, by search (best); or a point X,Y (X,Y,Z for a mesh)
    #[arg(
        long,
        value_name = "auto|centroid|kernel|best|X,Y[,Z]",
        default_value = "auto",
        allow_hyphen_values = true,
        value_parser = center
    )]
    pub(crate) center: CenterChoice,
    /// Number of samples of the radius [default: at least 8N and twice the number of vertices]
    #[arg(long, value_name = "NS", value_parser = whole::<usize>(0..=u64::MAX, 1024))]
    pub(crate) samples: Option<usize>,
    /// How the coefficients are found [default: least-squares for a cloud, with --weights and with --robust, else quadrature]
    #[arg(long, value_enum)]
    pub(crate) estimator: Option<EstimatorFlag>,
    /// Least squares with less weight for points that are far from the curve (Huber's loss)
    #[arg(long)]
    pub(crate) robust: bool,
    /// Round the center and the coefficients to D decimals
    #[arg(long, value_name = "D", value_parser = whole::<u32>(0..=u64::MAX, 6))]
    pub(crate) decimals: Option<u32>,
    /// Of a table: its points are in no order
    #[arg(long)]
    pub(crate) cloud: bool,
    #[command(flatten)]
    pub(crate) outline: OutlineFlags,
}

/// How an outline is found in a file.
#[derive(Clone, Debug, Args)]
pub(crate) struct OutlineFlags {
    /// Of a table: the columns of x and y, by name or by number from 1 [default: those named so, or the only two]
    #[arg(long, value_name = "X,Y", value_parser = columns)]
    pub(crate) columns: Option<Columns>,
    /// Of a table: the column of the weights 1/sigma^2 of the points, by name or by number from 1
    #[arg(long, value_name = "COLUMN", value_parser = column)]
    pub(crate) weights: Option<Column>,
    /// Of a picture, an SVG drawing or GeoJSON with several outlines: which one, counted from 1 by its size
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = whole::<usize>(1..=u64::MAX, 2))]
    pub(crate) blob: usize,
    /// Of a picture: the largest value of its darker colour, 0 to 254 [default: Otsu's threshold]
    #[arg(long, value_name = "V", value_parser = whole::<u8>(0..=254, 128))]
    pub(crate) threshold: Option<u8>,
    /// Of a picture: take what is otherwise the background
    #[arg(long)]
    pub(crate) invert: bool,
    /// Mend an outline that touches or crosses itself: cut its loops and spurs off, and say what they are
    #[arg(long)]
    pub(crate) repair: bool,
}

impl Default for OutlineFlags {
    fn default() -> Self {
        Self {
            columns: None,
            weights: None,
            blob: 1,
            threshold: None,
            invert: false,
            repair: false,
        }
    }
}

impl Default for FitFlags {
    fn default() -> Self {
        Self {
            model: ModelFlag::Radius,
            harmonics: None,
            tolerance: None,
            distance: None,
            power: None,
            center: CenterChoice::Auto,
            samples: None,
            estimator: None,
            robust: false,
            decimals: None,
            cloud: false,
            outline: OutlineFlags::default(),
        }
    }
}

/// Where the claims of the output go.
#[derive(Debug, Args)]
pub(crate) struct ProofFlag {
    /// Also write everything that the output claims to FILE, with witnesses that `stellate verify` checks
    #[arg(long, value_name = "FILE")]
    pub(crate) proof: Option<PathBuf>,
}
