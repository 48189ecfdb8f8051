//! The verb `mesh`: triangles of a surface, for other programs.

use super::allowed::{MESH_RESOLUTION, check_sides};
use super::equation::{check_surface, cylinder, through_equation};
use super::fit::exact_form;
use super::singular::singular_parts;
use super::{BoxSides, Given, Work};
use crate::error::{Error, Invariant, Result};
use crate::fit::FitOptions;
use crate::mesh::{
    Held, Mesh, MeshOptions, mesh_bounds, mesh_harmonic, mesh_radial, mesh_surface, parts_apart,
};
use crate::options::options;
use crate::shape::{Form, HarmonicPair, HarmonicSurface, ImplicitSurface, SpaceSuperquadric};
use crate::sphere::{Positivity, positivity};

/// How often a box that is too small is made larger, and the factor by which its sides grow each time.
const GROWTHS: usize = 4;
const GROWTH: f64 = 1.4;
/// The least angle, in degrees, by which an edge may bend.
const MIN_ANGLE: f64 = 1.0;

options! {
    /// How a surface is meshed.
    MeshingOptions {
        /// The box in which the surface is meshed; by default a box around the surface.
        window: Option<BoxSides> = None,
        /// The number of cells along the longest side of the box, and of each box where factors of the surface are apart.
        resolution: u32 = 64,
        /// Edges are split where the surface bends by more than this, in degrees from 1 to 180.
        angle: f64 = 20.0,
        /// Whether pieces inside others are turned inward, so that the mesh is the boundary of the solid between them.
        solid: bool = false,
        /// Whether cells along curves in which sheets cross are divided, for pictures. Then the mesh has small cracks around these
        /// cells.
        fine: bool = false,
    }
}

/// Meshes a surface: all of its sheets, with a certified zero near each vertex.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::verb::{self, Given, MeshingOptions, Work};
/// let given = Given::read("x^2 + y^2 + z^2 = 1", Numbers::Exact)?;
/// let mesh = verb::mesh(given, &MeshingOptions::default().resolution(16), &Work::default())?;
/// assert!(mesh.topology().is_watertight());
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] for a form that is no surface, an angle, a resolution or a window out of range, and a surface without a real point; [`Error::Limit`] if no
/// part of the surface is found.
pub fn mesh(given: Given, options: &MeshingOptions, work: &Work) -> Result<Mesh> {
    MESH_RESOLUTION.check(options.resolution)?;
    if let Some(window) = &options.window {
        check_sides(window)?;
    }
    if !(MIN_ANGLE..=180.0).contains(&options.angle) {
        return Err(Error::Usage(format!(
            "--angle {}: expected degrees between {MIN_ANGLE} and 180",
            options.angle
        )));
    }
    let name = given.short_name();
    let fitted = exact_form(given, &FitOptions::default(), work)?;
    if let Form::Harmonic(surface) = &fitted.form {
        if options.window.is_some() {
            return Err(Error::Usage(
                "--window is for surfaces that are cut off; a harmonic surface is meshed whole"
                    .into(),
            ));
        }
        if surface.is_zero() {
            return Err(Error::Usage(format!(
                "{name}: R is 0 in every direction: the surface is a single point"
            )));
        }
        let mut mesh = of_harmonics(surface, options.resolution, work)?;
        mesh.may_meet_origin = !has_one_sign(surface, work)?;
        return Ok(mesh);
    }
    let mut mesh = match through_equation(fitted.form, work)? {
        Form::Surface(surface) => of_surface(&surface, options, work)?,
        Form::Curve(curve) => of_surface(&cylinder(&curve), options, work)?,
        Form::SpaceSuperquadric(shape) => of_superquadric(&shape, options.resolution, work)?,
        _ => {
            return Err(Error::Usage(
                "mesh takes a surface: a polynomial in x, y and z, R = …, a patch, or a superquadric 3d"
                    .into(),
            ));
        }
    };
    if mesh.triangles.is_empty() {
        let place = match options.window {
            Some(_) => " in the window",
            None => "",
        };
        // In a window it is enough that no cell is left.
        let is_proved =
            mesh.has_proved_topology() || mesh.held == Held::NotAsked && mesh.cells[0] == 0;
        if mesh.curves.is_empty() && mesh.points.is_empty() && !is_proved {
            return Err(Error::limit(format!(
                "{name}: no part of the surface was found{place}, with {} cells along the longest side of a box; a larger --resolution or a smaller --window may show one",
                options.resolution
            )));
        }
        let what = match (mesh.curves.is_empty(), mesh.points.is_empty()) {
            (true, true) => "it is proved that the surface has no real point",
            (false, _) => {
                "there are only curves of the surface, which have no triangles; plot draws them"
            }
            (true, false) => {
                "there are only single points of the surface, which have no triangles; plot draws them"
            }
        };
        return Err(Error::Usage(format!("{name}: {what}{place}")));
    }
    if options.solid && !mesh.turn_as_solid() {
        return Err(Error::Usage(format!(
            "--solid: the mesh of {name} is not closed, so it is not the boundary of a solid"
        )));
    }
    Ok(mesh)
}

/// Whether it is proved that R > 0 in every direction, or that R < 0.
fn has_one_sign(surface: &HarmonicSurface, work: &Work) -> Result<bool> {
    let negated;
    let positive = match surface.coefficient(0, 0).signum() {
        -1 => {
            negated = HarmonicSurface::new(surface.terms().map(|(l, m, c)| ((l, m), -c)))?;
            &negated
        }
        _ => surface,
    };
    let pair = HarmonicPair::new(positive);
    let found = work.stage("sign", || positivity(positive, &pair, work.bounds()))?;
    Ok(matches!(found, Positivity::Positive { .. }))
}

/// The mesh in the window, or in a box around the surface. The box grows while a bounded surface does not fit in it. Factors that are
/// apart, in disjoint boxes, are meshed in grids of their own, so that each has enough cells.
pub(super) fn of_surface(
    surface: &ImplicitSurface,
    options: &MeshingOptions,
    work: &Work,
) -> Result<Mesh> {
    check_surface(surface, work)?;
    let surface = &*surface.in_original_coordinates(work.bounds())?;
    let apart = match options.window {
        Some(_) => None,
        None => work.stage("bounds", || parts_apart(surface, work.bounds()))?,
    };
    let Some(parts) = apart else {
        return in_one_box(surface, options, work);
    };
    let mut parts = parts.iter().map(|part| in_one_box(part, options, work));
    let first = parts.next().invariant("there are several parts")?;
    parts.try_fold(first, |mut mesh, part| {
        mesh.append(part?)?;
        Ok(mesh)
    })
}

/// The mesh in one box.
fn in_one_box(surface: &ImplicitSurface, options: &MeshingOptions, work: &Work) -> Result<Mesh> {
    let (mut bounds, may_grow, held) = match options.window {
        Some(window) => (window, false, Held::NotAsked),
        None => match work.stage("bounds", || mesh_bounds(surface, work.bounds()))? {
            // Nothing lies outside of a box that holds the whole surface.
            Some(found) => (
                found.bounds,
                found.seems_bounded && found.held != Held::Whole,
                found.held,
            ),
            // There is no real point, so any box will do.
            None => ([[-1.5, 1.5]; 3], false, Held::Whole),
        },
    };
    if bounds.iter().flatten().any(|x| !x.is_finite()) {
        return Err(Error::Usage(
            "the surface reaches beyond the range of doubles, in which the vertices of a mesh are; in a larger unit of length it does not".into(),
        ));
    }
    work.stage("mesh", || {
        let progress = work.progress("mesh", 1000);
        let with = |bounds, near| -> Result<Mesh> {
            let options = MeshOptions::new(bounds)
                .resolution(options.resolution)
                .angle(options.angle)
                .near(near);
            let mut mesh =
                mesh_surface(surface, &options, work.bounds(), &|done| progress.set(done))?;
            mesh.held = held;
            Ok(mesh)
        };
        let once = |bounds| with(bounds, Vec::new());
        let mut mesh = once(bounds)?;
        for _ in 0..GROWTHS {
            if !may_grow || mesh.topology().boundary_edges == 0 {
                break;
            }
            bounds = bounds.map(|[a, b]| {
                let (middle, half) = (f64::midpoint(a, b), GROWTH * (b - a) / 2.0);
                [middle - half, middle + half]
            });
            mesh = once(bounds)?;
        }
        let found = singular_parts(&mesh, surface, &bounds, work)?;
        if options.fine && !found.crossings.is_empty() {
            mesh = with(bounds, found.crossings.clone())?;
        }
        found.add_to(&mut mesh);
        Ok(mesh)
    })
}

/// The mesh of a superquadric, with `resolution` cells from pole to pole along its longest side.
pub(super) fn of_superquadric(
    shape: &SpaceSuperquadric,
    resolution: u32,
    work: &Work,
) -> Result<Mesh> {
    let count = resolution.div_ceil(2).max(2) as usize;
    work.stage("mesh", || {
        let progress = work.progress("mesh", 1000);
        let angles = shape.angles(count);
        mesh_radial(shape, angles, work.bounds(), &|done| progress.set(done))
    })
}

/// The mesh of a harmonic surface, with `resolution` rows from pole to pole.
pub(super) fn of_harmonics(
    surface: &HarmonicSurface,
    resolution: u32,
    work: &Work,
) -> Result<Mesh> {
    work.stage("mesh", || {
        let progress = work.progress("mesh", 1000);
        let rows = resolution.max(2) as usize;
        mesh_harmonic(surface, rows, work.bounds(), &|done| progress.set(done))
    })
}
