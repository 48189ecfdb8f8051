//! `stellate mesh`: writes the triangles of a surface for other programs.

use std::ffi::OsStr;

use stellate::document::{MeshFormat, mesh_text, write_mesh};
use stellate::error::{Error, Result};
use stellate::verb::{self, MeshingOptions};

use super::arguments::Mesh;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

/// The message for `--format`.
pub(crate) const NO_FORMAT: &str =
    "mesh has no --format: the name after -o says .obj, .ply or .stl";

pub(crate) fn run(flags: &Mesh, session: &Session) -> Result<()> {
    if session.common.format.is_some() {
        return Err(Error::Usage(NO_FORMAT.into()));
    }
    check_destination(session)?;
    let format = format(session)?;
    let options = MeshingOptions::default()
        .window(flags.window)
        .resolution(flags.resolution)
        .angle(flags.angle)
        .solid(flags.solid);
    let given = input::read(&flags.form, session)?;
    let name = given.short_name();
    let mesh = format.held(verb::mesh(given, &options, &session.work)?)?;
    for line in mesh_text(&mesh) {
        session.note(&line);
    }
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
