//! The verbs: the operations that a user can request, each in a file of its own.
//!
//! A verb is a function. It takes the input ([`Given`]), its options, which all have defaults, and the circumstances of the
//! [`Work`]; [`crate::document`] writes its outcome. A verb prints nothing and opens no file except those of its input. The
//! command line, the tests and all other programs call these functions, so none of them can do more than another.
//!
//! | verb | function | outcome |
//! | --- | --- | --- |
//! | describe | [`describe`] | [`Described`] |
//! | implicitize | [`implicitize()`] | [`Implicitization`] |
//! | parametrize | [`parametrize()`] | [`Parametrized`] |
//! | fit | [`fit()`] | [`OutlineFit`] |
//! | sample | [`sample()`] | [`Samples`] |
//! | inspect | [`inspect()`] | [`InspectionTask`], then a verdict for each point |
//! | mesh | [`mesh()`] | [`crate::mesh::Mesh`] |
//! | plot | [`plot()`] | SVG, and PNG by [`FigureFormat::bytes`] |
//! | check | [`check()`], [`check_doubles`] | [`CheckTask`], then [`crate::check::Comparison`] |
//! | vectors | [`vectors`] | [`crate::check::TestVectors`] |
//!
//! ```
//! use stellate::document::{Format, write_implicitization};
//! use stellate::language::Numbers;
//! use stellate::verb::{self, Given, ImplicitizeOptions, Work};
//!
//! let given = Given::read("x = sin(t); y = sin(t)*cos(t)", Numbers::Exact)?;
//! let found = verb::implicitize(given, &ImplicitizeOptions::default(), &Work::default())?;
//! let mut out = Vec::new();
//! write_implicitization(&found, Format::Text, &mut out)?;
//! assert!(String::from_utf8_lossy(&out).ends_with("x^4 - x^2 + y^2 = 0\n"));
//! # Ok::<(), stellate::error::Error>(())
//! ```

mod against;
mod allowed;
mod arcs;
mod cancelled;
mod check;
#[cfg(feature = "pictures")]
mod check_chart;
mod claims;
mod column_format;
#[cfg(feature = "columnar")]
mod columns;
mod describe;
mod equation;
mod fact;
mod feet;
mod fit;
#[cfg(feature = "meshes")]
mod fit_mesh;
mod foreign;
mod given;
mod implicitize;
mod inspect;
#[cfg(feature = "pictures")]
mod inspect_plot;
mod judged;
mod mesh;
mod parametrize;
#[cfg(feature = "pictures")]
mod plot;
#[cfg(feature = "pictures")]
mod plot_options;
#[cfg(feature = "pictures")]
mod plot_space;
mod point_files;
mod point_layout;
mod point_source;
mod read_mesh;
mod remark;
mod rows;
mod sample;
mod singular;
mod source;
mod topology;
mod work;
#[cfg(feature = "pictures")]
mod zero_set;

pub use crate::mesh::BoxSides;
pub use allowed::{ARC_RESOLUTION, Allowed, DIGITS, MESH_RESOLUTION, PICTURE_CELLS};
pub use arcs::ArcSearch;
pub use check::{
    CheckOptions, CheckTask, FloatKind, FloatNumbers, MAX_VECTOR_DIRECTIONS, VectorOptions, check,
    check_doubles, vectors,
};
#[cfg(feature = "pictures")]
pub use check_chart::{digits_chart, ladder_chart};
pub use column_format::ColumnFormat;
#[cfg(feature = "columnar")]
pub use columns::ColumnTypes;
pub use describe::{DescribeOptions, Described, DescribedForm, describe};
pub use fact::{BeyondCurve, Fact, PolarTheorem, Reach};
pub use fit::{FitReport, FittedOutline, OutlineFit, OutlineSeries, RadialReport, TakenOut, fit};
#[cfg(feature = "meshes")]
pub use fit_mesh::{FittedMesh, fit_mesh};
pub use given::{Content, Given, ReadOptions};
pub use implicitize::{
    CoefficientScale, CoordinatesFrom, Implicitization, ImplicitizeMethod, ImplicitizeOptions,
    implicitize,
};
pub use inspect::{InspectionOptions, InspectionTask, Subject, inspect};
pub use mesh::{MeshingOptions, mesh};
pub use parametrize::{InDirection, OnMeridian, ParametrizeOptions, Parametrized, parametrize};
#[cfg(feature = "pictures")]
pub use plot::plot;
#[cfg(feature = "pictures")]
pub use plot_options::{FigureFormat, Frame, PlotOptions};
pub use point_source::{PointRows, PointSource};
pub use read_mesh::{is_mesh_name, read_mesh};
pub use remark::{Part, Remark};
pub use rows::{KeptPoint, PointWriter, ReadingOptions};
pub use sample::{MAX_DIRECTIONS, SampleOptions, SampledPoints, Samples, sample};
pub use source::read_limited;
pub use topology::CurveTopology;
use work::Progress;
pub use work::{DEFAULT_MAX_DEGREE, Missing, Watcher, Work};
