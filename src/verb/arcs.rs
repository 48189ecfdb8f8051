//! Searches for certified arcs of intersections, for the verbs `parametrize`, `sample` and `plot`.

use super::allowed::{ARC_RESOLUTION, check_sides};
use super::equation::check_surface;
use super::{BoxSides, Work};
use crate::arcs::{ArcOptions, IntersectionArcs, trace_intersection};
use crate::error::{Error, Result};
use crate::mesh::mesh_bounds;
use crate::options::options;
use crate::parametrize::IntersectionParametrization;
use crate::shape::ImplicitSurface;

options! {
    /// How the curve in which two surfaces meet is followed.
    ArcSearch {
        /// The box in which the curve is followed; by default a box around the smaller surface.
        window: Option<BoxSides> = None,
        /// The least number of steps along the longest side of the box; by default 64.
        resolution: Option<u32> = None,
    }
}

/// The arcs in which two surfaces meet, in the given box or in a box around the smaller surface.
pub(super) fn arcs(
    surfaces: &[ImplicitSurface],
    search: &ArcSearch,
    work: &Work,
) -> Result<IntersectionArcs> {
    let [first, second] = surfaces else {
        return Err(Error::Usage(format!(
            "arcs are traced where two surfaces meet; here are {}",
            surfaces.len()
        )));
    };
    for surface in surfaces {
        check_surface(surface, work)?;
    }
    let bounds = match search.window {
        Some(window) => {
            check_sides(&window)?;
            window
        }
        None => work.stage("bounds", || box_of([first, second], work))?,
    };
    let mut options = ArcOptions::new(bounds);
    if let Some(resolution) = search.resolution {
        ARC_RESOLUTION.check(resolution)?;
        options = options.resolution(resolution);
    }
    let progress = work.progress("arcs", 1000);
    work.stage("arcs", || {
        trace_intersection([first, second], &options, work.bounds(), &|done| {
            progress.set(done);
        })
    })
}

/// The arcs of the components that have no exact parametrization.
pub(super) fn arcs_of_others(
    found: &IntersectionParametrization,
    surfaces: &[ImplicitSurface],
    search: &ArcSearch,
    work: &Work,
) -> Result<IntersectionArcs> {
    let mut traced = arcs(surfaces, search, work)?;
    if !found.curves.is_empty() {
        let over: Vec<_> = found.others.iter().map(|o| &o.projection).collect();
        traced.retain_on(&over);
    }
    Ok(traced)
}

/// The box around one of the surfaces: around the bounded one, or around the smaller one if both are bounded.
fn box_of(surfaces: [&ImplicitSurface; 2], work: &Work) -> Result<BoxSides> {
    let mut best: Option<(bool, f64, BoxSides)> = None;
    for surface in surfaces {
        let Some(found) = mesh_bounds(surface, work.bounds())? else {
            continue;
        };
        let (bounds, is_all) = (found.bounds, found.seems_bounded);
        let size: f64 = bounds.iter().map(|[a, b]| b - a).sum();
        if best.is_none_or(|(all, known, _)| (is_all, -size) > (all, -known)) {
            best = Some((is_all, size, bounds));
        }
    }
    Ok(best.map_or([[-1.5, 1.5]; 3], |(_, _, bounds)| bounds))
}

/// Refuses the options of arcs for a form that is not an intersection.
pub(super) fn refuse_arcs(search: &ArcSearch) -> Result<()> {
    let given = [
        ("--window", search.window.is_some()),
        ("--resolution", search.resolution.is_some()),
    ];
    match given.iter().find(|(_, given)| *given) {
        Some((name, _)) => Err(Error::Usage(format!(
            "{name} is for the curve in which two surfaces meet, such as 'x^2 + y^2 + z^2 = 1; x^2 + y^2 = z^2'"
        ))),
        None => Ok(()),
    }
}
