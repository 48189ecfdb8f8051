//! Meshes as OBJ, PLY (binary) and STL (binary).

use std::io::{self, Write};

use super::remark::counted;
use crate::error::{Error, Result};
use crate::mesh::{Held, Mesh, single};

/// A file format for meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshFormat {
    /// Wavefront OBJ: a text format with all digits of the doubles, normals, and a group for every factor.
    Obj,
    /// Stanford PLY: a binary format, little-endian, with doubles and normals.
    Ply,
    /// STL: a binary format, which has single precision by its definition.
    Stl,
}

impl MeshFormat {
    /// The format that the extension of a file name means: obj, ply or stl.
    #[must_use]
    pub fn of_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "obj" => Some(Self::Obj),
            "ply" => Some(Self::Ply),
            "stl" => Some(Self::Stl),
            _ => None,
        }
    }

    /// The mesh as a file of this format holds it, which has bounds of its own: an STL file has single precision.
    ///
    /// # Errors
    /// Those of [`Mesh::in_single_precision`].
    pub fn held(self, mesh: Mesh) -> Result<Mesh> {
        match self {
            Self::Obj | Self::Ply => Ok(mesh),
            Self::Stl => mesh.in_single_precision(),
        }
    }
}

/// Writes a mesh. `comment` is one line, of which STL holds 80 bytes. The bounds of what is written are those of
/// [`MeshFormat::held`].
///
/// # Errors
/// Those of `out`.
pub fn write_mesh(
    mesh: &Mesh,
    comment: &str,
    format: MeshFormat,
    out: &mut dyn Write,
) -> Result<()> {
    match format {
        MeshFormat::Obj => write_obj(mesh, comment, out),
        MeshFormat::Ply => write_ply(mesh, comment, out),
        MeshFormat::Stl => write_stl(mesh, comment, out),
    }
}

fn write_obj(mesh: &Mesh, comment: &str, out: &mut dyn Write) -> Result<()> {
    writeln!(out, "# {comment}")?;
    for [x, y, z] in &mesh.vertices {
        writeln!(out, "v {x:?} {y:?} {z:?}")?;
    }
    for [x, y, z] in &mesh.normals {
        writeln!(out, "vn {x:.6} {y:.6} {z:.6}")?;
    }
    for (index, triangle) in mesh.triangles.iter().enumerate() {
        if mesh.factors.len() > 1 {
            let factors = mesh.factors.iter().enumerate();
            for (factor, _) in factors.filter(|(_, first)| **first == index) {
                writeln!(out, "g factor{factor}")?;
            }
        }
        let [a, b, c] = triangle.map(|v| v + 1);
        writeln!(out, "f {a}//{a} {b}//{b} {c}//{c}")?;
    }
    // A negative number counts from the last vertex, which is -1.
    for line in &mesh.curves {
        for [x, y, z] in line {
            writeln!(out, "v {x:?} {y:?} {z:?}")?;
        }
        write!(out, "l")?;
        for number in (1..=line.len()).rev() {
            write!(out, " -{number}")?;
        }
        writeln!(out)?;
    }
    for [x, y, z] in &mesh.points {
        writeln!(out, "v {x:?} {y:?} {z:?}\np -1")?;
    }
    Ok(())
}

fn write_ply(mesh: &Mesh, comment: &str, out: &mut dyn Write) -> Result<()> {
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment {comment}\nelement vertex {}\n",
        mesh.vertices.len()
    )?;
    for (kind, name) in [("double", ""), ("float", "n")] {
        for axis in ["x", "y", "z"] {
            writeln!(out, "property {kind} {name}{axis}")?;
        }
    }
    write!(
        out,
        "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        mesh.triangles.len()
    )?;
    for (point, normal) in mesh.vertices.iter().zip(&mesh.normals) {
        for value in point {
            out.write_all(&value.to_le_bytes())?;
        }
        for value in normal {
            out.write_all(&single(*value).to_le_bytes())?;
        }
    }
    for triangle in &mesh.triangles {
        out.write_all(&[3])?;
        for vertex in triangle {
            out.write_all(&vertex.to_le_bytes())?;
        }
    }
    Ok(())
}

fn write_stl(mesh: &Mesh, comment: &str, out: &mut dyn Write) -> Result<()> {
    // A header that begins with "solid" would announce the text format.
    let mut header = [b' '; 80];
    for (slot, byte) in header.iter_mut().zip(comment.bytes()) {
        *slot = byte;
    }
    out.write_all(&header)?;
    let count = u32::try_from(mesh.triangles.len())
        .map_err(|_| io::Error::other("an STL file holds at most 2^32 triangles"))?;
    out.write_all(&count.to_le_bytes())?;
    for triangle in &mesh.triangles {
        let corners = triangle.map(|v| mesh.vertices[v as usize].map(|x| f64::from(single(x))));
        if !corners.iter().flatten().all(|x| x.is_finite()) {
            return Err(Error::Usage(
                "a coordinate is too large for single precision, which an STL file holds".into(),
            ));
        }
        for point in std::iter::once(facet_normal(corners)).chain(corners) {
            for value in point {
                out.write_all(&single(value).to_le_bytes())?;
            }
        }
        out.write_all(&[0, 0])?;
    }
    Ok(())
}

/// The unit normal of a triangle; 0 if the triangle has no area.
fn facet_normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let [a, b, c] = [a, b, c].map(nalgebra::Vector3::from);
    let normal = (b - a).cross(&(c - a));
    normal.try_normalize(0.0).unwrap_or_default().into()
}

/// The properties of a mesh, in sentences.
#[must_use]
pub fn mesh_text(mesh: &Mesh) -> Vec<String> {
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
    let said_of = if mesh.has_proved_topology() {
        ","
    } else {
        "; the mesh, which is no proof for the surface:"
    };
    let mut lines = vec![
        format!(
            "{} vertices, {} triangles{said_of} {pieces}, {closed}, Euler characteristic {}",
            mesh.vertices.len(),
            mesh.triangles.len(),
            topology.euler_characteristic
        ),
        format!(
            "every vertex has a certified zero within {:.1e}",
            mesh.vertex_bound
        ),
    ];
    if topology.flat_triangles > 0 {
        let triangles = counted(topology.flat_triangles, "triangle has", "triangles have");
        lines.push(format!("{triangles} two corners at the same place"));
    }
    if mesh.merged > 0 {
        let vertices = counted(mesh.merged, "vertex is", "vertices are");
        lines.push(format!(
            "{vertices} at the place of others in single precision, which an STL file holds; OBJ and PLY files hold doubles"
        ));
    }
    if mesh.bent_edges > 0 {
        let edges = counted(mesh.bent_edges, "edge bends", "edges bend");
        lines.push(format!(
            "{edges} by more than the wanted angle: there the surface is singular, or the cells are too large for it (a larger --resolution has smaller ones)"
        ));
    }
    if mesh.may_meet_origin {
        lines.push(
            "R is not proved to have one sign: the surface may pass through its origin, which the mesh, an image of a sphere, does not show"
                .into(),
        );
    }
    let boxes = if mesh.boxes > 1 { "boxes" } else { "box" };
    lines.push(match mesh.held {
        Held::Whole => {
            format!("it is proved that no part of the surface is outside of the {boxes}")
        }
        Held::BoundedPieces => {
            format!("it is proved that no bounded piece of the surface is outside of the {boxes}")
        }
        Held::Unproved => format!("a piece of the surface may be outside of the {boxes}"),
        Held::NotAsked => {
            "parts of the surface that are more than a cell outside of the window are left out"
                .into()
        }
    });
    if mesh.inward > 0 {
        let pieces = counted(
            mesh.inward,
            "piece inside others points",
            "pieces inside others point",
        );
        lines.push(format!("{pieces} inward"));
    }
    if !mesh.curves.is_empty() || !mesh.points.is_empty() {
        let curves = counted(mesh.curves.len(), "piece of a curve", "pieces of curves");
        let points = counted(mesh.points.len(), "point", "points");
        let place = match (mesh.curves.len(), mesh.points.len()) {
            (0, _) => format!("at {points}"),
            (_, 0) => format!("along {curves}"),
            _ => format!("along {curves} and at {points}"),
        };
        let gaps = match mesh.has_crossings {
            true => "; sheets cross there, and triangles may have gaps",
            false => "",
        };
        lines.push(format!(
            "the surface is singular {place}, which an OBJ file holds as lines and points{gaps}"
        ));
    }
    if mesh.may_be_singular {
        lines.push(
            "the surface may have more singular points: isolated points, and curves at which no sheet ends, are not in the mesh"
                .into(),
        );
    }
    if mesh.shared_cells > 0 {
        let cells = counted(mesh.shared_cells, "cell", "cells");
        lines.push(format!(
            "factors of the polynomial may meet, in {cells}: the pieces and the Euler characteristic are those of each factor by itself"
        ));
    }
    let [all, open] = mesh.cells;
    if open > 0 {
        lines.push(format!(
            "{open} of {all} cells of side {:.2e} are not proved to hold a single smooth sheet: there the mesh may miss what is smaller",
            mesh.cell
        ));
    }
    lines
}
