//! `stellate fit MESH`: fits spherical harmonics to a closed mesh.

use std::path::Path;

use stellate::document::{Format, Kind, certified_bounds, write_mesh_fit};
use stellate::error::{Error, Result};
use stellate::fit::{CenterChoice, Estimator, MeshFitOptions, MeshFitSize};
use stellate::verb::{self, FittedMesh};

use super::arguments::Fit;
use super::input::{self, refuse_output};
use super::output::write_result;
use super::session::Session;

/// Fits a mesh, whose name was seen to be one.
pub(super) fn run(argument: &str, flags: &Fit, session: &Session) -> Result<()> {
    let format = session.format_or(Format::Text);
    Kind::Harmonics.check(format)?;
    refuse_contour_flags(flags)?;
    refuse_output(argument, session)?;
    let options = input::fit_options(&flags.fit);
    let size = match (flags.degree, options.tolerance()) {
        (Some(degree), _) => MeshFitSize::Degree(degree),
        (None, Some(tolerance)) => MeshFitSize::Tolerance(tolerance),
        (None, None) => {
            return Err(Error::Usage(
                "the fit of a mesh needs --degree L or --tolerance E".into(),
            ));
        }
    };
    let options = MeshFitOptions::new(size)
        .center(options.center)
        .estimator(options.estimator.unwrap_or(Estimator::Quadrature))
        .samples(options.samples);
    let solid = verb::read_mesh(Path::new(argument), &session.work)?;
    let fit = verb::fit_mesh(&solid, &options, &session.work)?;
    session.note(&summary(&fit, &options.center));
    write_result(session, |out| write_mesh_fit(&fit, format, out))
}

/// Refuses the flags that only contours have.
fn refuse_contour_flags(flags: &Fit) -> Result<()> {
    let fit = input::fit_options(&flags.fit);
    let given = [
        ("--harmonics", fit.harmonics().is_some()),
        ("--model", fit.model != stellate::fit::FitModel::Radius),
        ("--distance", flags.fit.distance.is_some()),
        ("--power", flags.fit.power.is_some()),
        ("--decimals", fit.decimals.is_some()),
        ("--robust", fit.robust),
        ("--cloud", flags.fit.cloud),
        ("--all", flags.all),
        ("--normal-form", flags.normal_form),
        ("--proof", flags.proof.proof.is_some()),
    ];
    match given.iter().find(|(_, given)| *given) {
        Some((name, _)) => Err(Error::Usage(format!(
            "{name} is for contours; the fit of a mesh has --degree or --tolerance, --center, --samples and --estimator"
        ))),
        None => Ok(()),
    }
}

/// A fit in a sentence.
fn summary(found: &FittedMesh, choice: &CenterChoice) -> String {
    let FittedMesh { fit, distance, .. } = found;
    let center = match choice {
        CenterChoice::Auto if fit.is_moved => {
            "the deepest point of the kernel (the centroid does not see the whole mesh)"
        }
        CenterChoice::Auto | CenterChoice::Centroid => "the centroid",
        CenterChoice::Kernel | CenterChoice::Best => "the deepest point of the kernel",
        _ => "the given center",
    };
    let distance = distance.map_or_else(String::new, |found| {
        let bounds = certified_bounds(found.low, found.high);
        format!("; distance {bounds} (Hausdorff, certified)")
    });
    format!(
        "L = {}, {} directions, radial error ≈ {:.3e} at most, ≈ {:.3e} rms{distance}; the mesh is star-shaped about {center}, exactly",
        fit.surface.degree(),
        fit.samples,
        fit.max_radial_error,
        fit.rms_radial_error
    )
}
