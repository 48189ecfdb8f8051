//! Documents: forms and results are written as text for people and for other programs.
//!
//! A writer streams to its output and never holds the whole text in memory. The language ([`crate::language`]) and the reader of
//! documents ([`crate::reading`]) read a written form back without loss, with its center, from every format except LaTeX.

mod angles;
mod arcs;
mod certified;
mod check;
#[cfg(feature = "columnar")]
mod columns;
mod description;
mod display;
mod elliptic;
mod expression;
mod facts;
mod feet;
mod fit_report;
mod fit_table;
mod fourier;
mod harmonic;
mod implicit;
mod inspection;
mod inspection_report;
mod intersection;
mod intersection_curves;
mod json;
mod kind;
mod ladder;
mod mesh;
mod numeric;
mod outcome;
mod parametric;
mod parametric_form;
mod rational;
mod remark;
mod samples;
mod schema;
mod source;
mod spherical;
mod superquadric;
mod topology;
mod vectors;

use std::io;

pub(crate) use arcs::{arcs_text, write_arcs};
pub use certified::certified_bounds;
pub use check::write_check;
#[cfg(feature = "columnar")]
pub use columns::ColumnWriter;
pub(crate) use description::{write_description, write_space_curve_description};
pub use elliptic::{write_elliptic, write_fit};
pub use fit_table::write_fit_table;
pub use fourier::write_fourier;
pub use harmonic::write_harmonic;
#[cfg(feature = "meshes")]
pub use harmonic::write_mesh_fit;
pub(crate) use implicit::write_surface;
pub use inspection::{InspectionWriter, summary_text, write_inspection_cloud};
pub use inspection_report::{ReportHead, write_inspection_report};
pub(crate) use intersection::write_intersection;
pub(crate) use intersection_curves::write_intersection_curves;
pub use kind::Kind;
pub use ladder::write_ladder;
pub use mesh::{MeshFormat, mesh_text, write_mesh};
pub use outcome::{
    sampled_text, write_described, write_implicitization, write_parametrized, write_sampled,
};
pub(crate) use parametric::write_parametrization;
pub(crate) use parametric_form::write_coordinates;
pub use remark::{missing_text, remark_text};
pub(crate) use samples::write_samples;
pub use schema::{json_schema, schema_kinds};
pub(crate) use spherical::write_surface_parametrization;
pub(crate) use superquadric::{
    write_space_superquadric, write_space_superquadric_description, write_superquadric,
    write_superquadric_description,
};
pub use vectors::write_vectors;

use crate::error::Result;
use crate::exact::Rational;
pub use crate::notation::{Coordinates, Format};
pub use crate::reading::SCHEMA;

// Only the tests and benches of this project use these; they are no part of the public interface.
use crate::rows::listed;
use crate::shape::Form;
use crate::verb::Fact;
#[doc(hidden)]
pub use implicit::write_implicit;

/// Writes any form in the given format. The facts are written with an implicit form or an intersection only.
///
/// # Errors
/// Those of `out`; [`crate::error::Error::Usage`] for a format that the kind of form does not have ([`Kind`]).
pub fn write_form(
    form: &Form,
    facts: &[Fact],
    format: Format,
    out: &mut dyn io::Write,
) -> Result<()> {
    match form {
        Form::Fourier(radius) => write_fourier(radius, None, format, out),
        Form::Harmonic(surface) => write_harmonic(surface, format, out),
        Form::Curve(curve) => write_implicit(curve, facts, format, out),
        Form::Surface(surface) => write_surface(surface, facts, format, out),
        Form::Superquadric(shape) => write_superquadric(shape, format, out),
        Form::SpaceSuperquadric(shape) => write_space_superquadric(shape, format, out),
        Form::PlaneCurve(curve) => write_coordinates(&curve.into(), format, out),
        Form::SpaceCurve(curve) => write_coordinates(&curve.into(), format, out),
        Form::Patch(patch) => write_coordinates(&patch.into(), format, out),
        Form::Intersection(surfaces) => write_intersection(surfaces, facts, format, out),
    }
}

/// The text of the comment that states the center, if the center is not the origin.
fn center_comment(center: &[Rational]) -> Option<String> {
    let is_origin = center.iter().all(Rational::is_zero);
    (!is_origin).then(|| format!("center: {}", listed(center)))
}

/// The line about the center in a description, with its doubles if its fractions are long; `None` for the origin.
fn center_line(center: &[Rational]) -> Option<String> {
    const LONG: usize = 12;
    let exact = center_comment(center)?;
    let is_long = center.iter().any(|c| c.to_string().len() > LONG);
    let near: Vec<String> = center.iter().map(|c| format!("{:?}", c.to_f64())).collect();
    Some(match is_long {
        true => format!("{exact} (≈ {})", near.join(", ")),
        false => exact,
    })
}

/// Writes lines.
fn write_lines(lines: impl IntoIterator<Item = String>, out: &mut dyn io::Write) -> Result<()> {
    for line in lines {
        writeln!(out, "{line}")?;
    }
    Ok(())
}
