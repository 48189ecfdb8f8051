//! `stellate mesh`: triangles of a surface, for other programs.

use std::ffi::OsStr;

use stellate::document::{MeshFormat, write_mesh};
use stellate::error::{Error, Result};
use stellate::mesh::{Mesh, MeshOptions, mesh_bounds, mesh_superquadric, mesh_surface};
use stellate::shape::{Form, ImplicitSurface, SpaceSuperquadric};

use super::arguments;
use super::input;
use super::numbers::{Bounds, space_window};
use super::output::{check_destination, write_result};
use super::session::Session;

/// How often a box that was too small is made larger, and by how much.
const GROWTHS: usize = 4;
const GROWTH: f64 = 1.4;
/// Degrees that an edge may bend by.
const MIN_ANGLE: f64 = 1.0;

pub(crate) fn run(verb: &arguments::Mesh, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = format(session)?;
    if !(MIN_ANGLE..=180.0).contains(&verb.angle) {
        return Err(Error::Usage(format!(
            "--angle {}: expected degrees between {MIN_ANGLE} and 180",
            verb.angle
        )));
    }
    let window = verb.window.as_deref().map(space_window).transpose()?;
    let input = input::read(&verb.form, session)?;
    let name = input.short_name();
    let fitted = input::exact_form(input, &arguments::FitFlags::default(), session)?;
    let (resolution, angle) = (verb.resolution, verb.angle);
    let mesh = match input::through_equation(fitted.form, session)? {
        Form::Surface(surface) => of_surface(&surface, window, resolution, angle, session)?,
        Form::Curve(curve) => {
            of_surface(&input::cylinder(&curve), window, resolution, angle, session)?
        }
        Form::SpaceSuperquadric(shape) => of_superquadric(&shape, resolution, session)?,
        _ => {
            return Err(Error::Usage(
                "mesh takes a surface: a polynomial in x, y and z, a patch, or a superquadric 3d"
                    .into(),
            ));
        }
    };
    if mesh.triangles.is_empty() {
        return Err(Error::Usage(format!(
            "{name}: no part of the surface was found{}",
            if window.is_some() {
                " in the window"
            } else {
                ""
            }
        )));
    }
    describe(&mesh, session);
    let comment = format!("stellate: {}", name.replace(['\n', '\r'], " "));
    write_result(session, |out| write_mesh(&mesh, &comment, format, out))
}

fn format(session: &Session) -> Result<MeshFormat> {
    let path = session.common.output.as_ref().ok_or_else(|| {
        Error::Usage("mesh writes a file: give -o OUT.obj, -o OUT.ply or -o OUT.stl".into())
    })?;
    let extension = path.extension().and_then(OsStr::to_str);
    extension.and_then(MeshFormat::of_extension).ok_or_else(|| {
        Error::Usage(format!(
            "-o {}: a mesh is a .obj, a .ply or a .stl file",
            path.display()
        ))
    })
}

/// The mesh in the window, or in a box around the surface that grows while a bounded surface does not fit in.
pub(crate) fn of_surface(
    surface: &ImplicitSurface,
    window: Option<Bounds>,
    resolution: u32,
    angle: f64,
    session: &mut Session,
) -> Result<Mesh> {
    let degree = surface.polynomial().degree().unwrap_or(0);
    session.check_degree(usize::try_from(degree).unwrap_or(usize::MAX))?;
    let found = match window {
        Some(window) => Some((window, false)),
        None => session.stage("bounds", |session| mesh_bounds(surface, &session.limits))?,
    };
    let (mut bounds, may_grow) = found.unwrap_or(([[-1.5, 1.5]; 3], false));
    let bar = session.progress(1000, "mesh");
    let mesh = session.stage("mesh", |session| {
        for _ in 0..GROWTHS {
            let mesh = once(surface, bounds, resolution, angle, session, &bar)?;
            if !may_grow || mesh.topology().boundary_edges == 0 {
                return Ok(mesh);
            }
            bounds = bounds.map(|[a, b]| {
                let (middle, half) = (f64::midpoint(a, b), GROWTH * (b - a) / 2.0);
                [middle - half, middle + half]
            });
        }
        once(surface, bounds, resolution, angle, session, &bar)
    });
    bar.finish_and_clear();
    mesh
}

/// `resolution` is that of the longest side: so many cells from pole to pole.
pub(crate) fn of_superquadric(
    shape: &SpaceSuperquadric,
    resolution: u32,
    session: &mut Session,
) -> Result<Mesh> {
    let count = resolution.div_ceil(2).max(2) as usize;
    let bar = session.progress(1000, "mesh");
    let mesh = session.stage("mesh", |session| {
        mesh_superquadric(shape, count, &session.limits, &|done| {
            bar.set_position(done)
        })
    });
    bar.finish_and_clear();
    mesh
}

fn once(
    surface: &ImplicitSurface,
    bounds: Bounds,
    resolution: u32,
    angle: f64,
    session: &Session,
    bar: &indicatif::ProgressBar,
) -> Result<Mesh> {
    let options = MeshOptions {
        bounds,
        resolution,
        angle,
    };
    mesh_surface(surface, &options, &session.limits, &|done| {
        bar.set_position(done);
    })
}

/// The box around a surface that is closed as far as its certified points in many directions tell.
pub(crate) fn closed_bounds(
    surface: &ImplicitSurface,
    session: &mut Session,
) -> Result<Option<Bounds>> {
    let found = session.stage("bounds", |session| mesh_bounds(surface, &session.limits))?;
    Ok(found.and_then(|(bounds, is_all)| is_all.then_some(bounds)))
}

/// What was made, on stderr.
fn describe(mesh: &Mesh, session: &Session) {
    let topology = mesh.topology();
    let pieces = match topology.components {
        1 => "one piece".to_owned(),
        n => format!("{n} pieces"),
    };
    let closed = if topology.is_watertight() {
        "watertight".to_owned()
    } else if topology.irregular_edges == 0 {
        format!("open, with {} edges on the rim", topology.boundary_edges)
    } else {
        format!(
            "not watertight: {} edges on the rim, {} with other than two triangles",
            topology.boundary_edges, topology.irregular_edges
        )
    };
    session.note(&format!(
        "{} vertices, {} triangles, {pieces}, {closed}, Euler characteristic {}",
        mesh.vertices.len(),
        mesh.triangles.len(),
        topology.euler_characteristic
    ));
    session.note(&format!(
        "every vertex has a certified zero within {:.1e}",
        mesh.vertex_bound
    ));
    let [all, open] = mesh.cells;
    if open > 0 {
        session.note(&format!(
            "{open} of {all} cells of side {:.2e} are not proved to hold a single smooth sheet: there the mesh may miss what is smaller",
            mesh.cell
        ));
    }
}
