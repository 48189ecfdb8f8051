//! The syntax of `check` and `vectors`.

use std::path::PathBuf;

use clap::Args;

use super::flags::FitFlags;
use super::values::whole;

pub(crate) const CHECK_EXAMPLES: &str = "\
Examples:
  stellate check 'r = 1 + 1/5*cos(3*t)' --coefficients mine.csv --digits 12
  stellate check outline.csv --harmonics 39 --points mine.csv --plot digits.svg
  stellate check 'r = 1 + 1/5*cos(3*t)' --radii mine.csv --format json
  stellate check 'R = 2 + Y(1,0)/2' --radii mine.csv
Numbers of the file are doubles, bit for bit: decimals, or hex floats such as 0x1.8p+1.
The exit code is 1 if something has fewer than --digits D correct digits. Without --digits it is
1 if a term is missing, if one is there that is no rounding error, or if a usual mistake is
recognised.";

pub(crate) const VECTORS_EXAMPLES: &str = "\
Examples:
  stellate vectors 'r = 1 + 1/5*cos(3*t)' -o vectors.json
  stellate vectors outline.csv --harmonics 10 --directions 360 -o vectors.json
The inputs are rounded to doubles, and everything else follows from these doubles exactly.";

#[derive(Debug, Args)]
pub(crate) struct Check {
    /// What is right: a Fourier radius, a contour with --harmonics, an exact polynomial, or a parametric form
    #[arg(allow_hyphen_values = true)]
    pub(crate) reference: String,
    #[command(flatten)]
    pub(crate) data: CheckedData,
    /// Draw the digits of every number, as SVG or PNG
    #[arg(long, value_name = "FIG")]
    pub(crate) plot: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) fit: FitFlags,
}

/// What is checked: one of these.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub(crate) struct CheckedData {
    /// The coefficients of a float program: an implicit document, rows i,j[,k],value, or a matrix c[i][j] of rows i and columns j;
    /// of a harmonic surface also rows l,m,value
    #[arg(long, value_name = "FILE")]
    pub(crate) coefficients: Option<String>,
    /// Points of a float program: rows x,y[,z], or these columns by name among others, as sample writes them
    #[arg(long, value_name = "FILE")]
    pub(crate) points: Option<String>,
    /// Radii of a float program: rows theta,r, or theta,phi,r for a harmonic surface, or these columns by name among others
    #[arg(long, value_name = "FILE")]
    pub(crate) radii: Option<String>,
    /// The paper's own algorithm in doubles, for growing N
    #[arg(long = "self")]
    pub(crate) itself: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Vectors {
    /// A Fourier radius, a contour with --harmonics, an exact polynomial, or a parametric form
    #[arg(allow_hyphen_values = true)]
    pub(crate) reference: String,
    /// Certified radii and points in this many directions around the circle
    #[arg(long, value_name = "K", default_value_t = 16, value_parser = whole::<usize>(0..=u64::MAX, 16))]
    pub(crate) directions: usize,
    #[command(flatten)]
    pub(crate) fit: FitFlags,
}
