//! Arcs of intersections, for `parametrize`, `sample` and `plot`.

use stellate::arcs::{ArcOptions, IntersectionArcs, trace_intersection};
use stellate::error::{Error, Result};
use stellate::mesh::mesh_bounds;
use stellate::parametrize::IntersectionParametrization;
use stellate::shape::ImplicitSurface;

use super::arguments::ArcFlags;
use super::numbers::{Bounds, space_window};
use super::session::Session;

const DEFAULT_RESOLUTION: u32 = 64;

/// The arcs of the two surfaces, in the given box or in one around the smaller of them.
pub(crate) fn arcs(
    surfaces: &[ImplicitSurface],
    window: Option<Bounds>,
    resolution: Option<u32>,
    session: &mut Session,
) -> Result<IntersectionArcs> {
    let [first, second] = surfaces else {
        return Err(Error::Usage(format!(
            "arcs are traced where two surfaces meet; here are {}",
            surfaces.len()
        )));
    };
    for surface in surfaces {
        let degree = surface.polynomial().degree().unwrap_or(0);
        session.check_degree(usize::try_from(degree).unwrap_or(usize::MAX))?;
    }
    let bounds = match window {
        Some(window) => window,
        None => session.stage("bounds", |session| box_of([first, second], session))?,
    };
    let options = ArcOptions {
        bounds,
        resolution: resolution.unwrap_or(DEFAULT_RESOLUTION),
    };
    let bar = session.progress(1000, "arcs");
    let found = session.stage("arcs", |session| {
        trace_intersection([first, second], &options, &session.limits, &|done| {
            bar.set_position(done);
        })
    });
    bar.finish_and_clear();
    found
}

/// The arcs of the components that have no parametrization.
pub(crate) fn arcs_of_others(
    found: &IntersectionParametrization,
    surfaces: &[ImplicitSurface],
    window: Option<Bounds>,
    resolution: Option<u32>,
    session: &mut Session,
) -> Result<IntersectionArcs> {
    let mut traced = arcs(surfaces, window, resolution, session)?;
    if !found.curves.is_empty() {
        let over: Vec<_> = found.others.iter().map(|o| &o.projection).collect();
        traced.retain_on(&over);
    }
    Ok(traced)
}

/// Of the boxes around the surfaces that of a bounded one, or the smaller one.
fn box_of(surfaces: [&ImplicitSurface; 2], session: &Session) -> Result<Bounds> {
    let mut best: Option<(bool, f64, Bounds)> = None;
    for surface in surfaces {
        let Some((bounds, is_all)) = mesh_bounds(surface, &session.limits)? else {
            continue;
        };
        let size: f64 = bounds.iter().map(|[a, b]| b - a).sum();
        if best.is_none_or(|(all, known, _)| (is_all, -size) > (all, -known)) {
            best = Some((is_all, size, bounds));
        }
    }
    Ok(best.map_or([[-1.5, 1.5]; 3], |(_, _, bounds)| bounds))
}

/// `--window`, if it was given.
pub(crate) fn window(flags: &ArcFlags) -> Result<Option<Bounds>> {
    flags.window.as_deref().map(space_window).transpose()
}

/// Refuses the flags for forms that are no intersections.
pub(crate) fn refuse(flags: &ArcFlags) -> Result<()> {
    let given = [
        ("--window", flags.window.is_some()),
        ("--resolution", flags.resolution.is_some()),
    ];
    match given.iter().find(|(_, given)| *given) {
        Some((name, _)) => Err(Error::Usage(format!(
            "{name} is for the curve in which two surfaces meet, such as 'x^2 + y^2 + z^2 = 1; x^2 + y^2 = z^2'"
        ))),
        None => Ok(()),
    }
}
