//! Where results go: standard output, or a file that appears whole or not at all.

use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use stellate::error::{Error, Result};
use tempfile::NamedTempFile;

use super::session::Session;

/// Writes the result of a verb to `-o FILE` or to standard output.
pub(crate) fn write_result(
    session: &mut Session,
    write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
) -> Result<()> {
    let path = session.common.output.clone();
    session.stage("write", |session| match &path {
        Some(path) => write_file(path, session, write),
        None => {
            let mut out = BufWriter::new(std::io::stdout().lock());
            let written = write(&mut out).and_then(|()| out.flush());
            written.map_err(|source| io_error(Path::new("standard output"), source))
        }
    })
}

/// Writes a file beside its destination and renames it.
fn write_file(
    path: &Path,
    session: &Session,
    write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
) -> Result<()> {
    let folder = folder_of(path);
    let failed = |source| io_error(path, source);
    let mut beside = NamedTempFile::new_in(&folder).map_err(failed)?;
    {
        let mut out = BufWriter::new(beside.as_file_mut());
        write(&mut out).and_then(|()| out.flush()).map_err(failed)?;
    }
    session.limits.check()?;
    give_default_permissions(&beside).map_err(failed)?;
    beside.persist(path).map_err(|e| failed(e.error))?;
    Ok(())
}

/// A temporary file is private; a result has the permissions that new files have here.
#[cfg(unix)]
fn give_default_permissions(file: &NamedTempFile) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.as_file()
        .set_permissions(std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn give_default_permissions(_: &NamedTempFile) -> std::io::Result<()> {
    Ok(())
}

/// Refuses `-o` into a missing folder or onto a folder before any work is done.
pub(crate) fn check_destination(session: &Session) -> Result<()> {
    let Some(path) = &session.common.output else {
        return Ok(());
    };
    let folder = folder_of(path);
    if !folder.is_dir() {
        return Err(Error::Usage(format!(
            "-o {}: there is no folder {}",
            path.display(),
            folder.display()
        )));
    }
    if path.is_dir() {
        return Err(Error::Usage(format!(
            "-o {}: that is a folder",
            path.display()
        )));
    }
    Ok(())
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_path_buf(),
        _ => PathBuf::from("."),
    }
}

fn io_error(path: &Path, source: std::io::Error) -> Error {
    Error::Io {
        path: path.to_path_buf(),
        source,
    }
}
