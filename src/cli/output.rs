//! Where results go: standard output, or a file that appears whole or not at all.

use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use stellate::error::{Error, OUTPUT, Result};
use tempfile::NamedTempFile;

use super::session::Session;
use super::watch::remove_if_ended;

/// What writes to a file or stream that is open. It is boxed, so that what opens and closes them is compiled once.
type Writing<'a> = Box<dyn FnOnce(&mut dyn Write) -> Result<()> + 'a>;

/// Writes the result of a verb to `-o FILE` or to standard output, and its proof before it. The claims about points that are
/// inspected while they are written are known after them.
pub(crate) fn write_result(
    session: &Session,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    let is_known = session.work.claims() > 0;
    if is_known {
        write_proof(session)?;
    }
    let write: Writing<'_> = Box::new(move |out| {
        write(out)?;
        if is_known {
            return Ok(());
        }
        write_proof(session)
    });
    session
        .work
        .stage("write", || match &session.common.output {
            Some(path) => write_file(path, session, write),
            None => write_stream(
                std::io::stdout().lock(),
                Path::new("standard output"),
                session,
                write,
            ),
        })
}

/// Writes the claims of the output, if they are wanted, after they have been checked.
fn write_proof(session: &Session) -> Result<()> {
    let (Some(path), Some(proof)) = (&session.proof, session.work.proof()) else {
        return Ok(());
    };
    let proof = session
        .work
        .stage("check of the proof", || proof.checked())?;
    session.note(&format!(
        "proof: {} claims, {} of them without a witness",
        proof.claims(),
        proof.without_witness()
    ));
    write_beside(path, proof.text().as_bytes(), session)
}

/// Writes to a stream that is not a regular file. Until the first byte is written, the process may be ended from outside.
fn write_stream(
    stream: impl Write,
    name: &Path,
    session: &Session,
    write: Writing<'_>,
) -> Result<()> {
    let mut out = BufWriter::new(Watched { stream, session });
    whole(write, &mut out, name)
}

/// A stream that tells the session when it is written to.
struct Watched<'a, W> {
    stream: W,
    session: &'a Session,
}

impl<W: Write> Write for Watched<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.session.begin_writing();
        self.stream.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.stream.flush()
    }
}

/// Writes and flushes everything. An error of `out` itself gets the name of the file or stream.
fn whole(write: Writing<'_>, out: &mut dyn Write, name: &Path) -> Result<()> {
    let written = write(out).and_then(|()| Ok(out.flush()?));
    written.map_err(|error| match error {
        Error::Io { path, source } if path == Path::new(OUTPUT) => io_error(name, source),
        other => other,
    })
}

/// Writes a file other than the result, in the same way as the result.
pub(crate) fn write_beside(path: &Path, bytes: &[u8], session: &Session) -> Result<()> {
    session.work.stage("write", || {
        write_file(path, session, Box::new(|out| Ok(out.write_all(bytes)?)))
    })
}

/// Whether two paths lead to one file, which need not be there yet.
pub(super) fn is_one_file(a: &Path, b: &Path) -> bool {
    let place = |path: &Path| {
        let in_folder = || Some(folder_of(path).canonicalize().ok()?.join(path.file_name()?));
        path.canonicalize().ok().or_else(in_folder)
    };
    a == b || place(a).is_some_and(|a| place(b) == Some(a))
}

/// Writes a file beside its destination and renames it. A device or a pipe (`/dev/null`, `/dev/stdout`) is written to directly,
/// because renaming would put a file in its place. Before the renaming the process may be ended from outside; then the
/// unfinished file is removed.
fn write_file(path: &Path, session: &Session, write: Writing<'_>) -> Result<()> {
    let failed = |source| io_error(path, source);
    if ["/dev/stdout", "/dev/fd/1"].map(Path::new).contains(&path) {
        return write_stream(std::io::stdout().lock(), path, session, write);
    }
    // A path in /dev may lead to a regular file that another process has opened, too, so it is never replaced.
    if path.starts_with("/dev") || std::fs::metadata(path).is_ok_and(|m| !m.is_file()) {
        let device = std::fs::OpenOptions::new().append(true).open(path);
        return write_stream(device.map_err(failed)?, path, session, write);
    }
    // The file that a symbolic link points to is replaced, not the link.
    let path = &std::fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let folder = folder_of(path);
    let mut beside = new_file_in(&folder).map_err(failed)?;
    if let Ok(before) = std::fs::metadata(path) {
        let kept = beside.as_file().set_permissions(before.permissions());
        kept.map_err(failed)?;
    }
    remove_if_ended(Some(beside.path()));
    {
        let mut out = BufWriter::new(beside.as_file_mut());
        whole(write, &mut out, path)?;
    }
    session.work.check()?;
    session.begin_writing();
    remove_if_ended(None);
    beside.persist(path).map_err(|e| failed(e.error))?;
    Ok(())
}

/// A temporary file with the usual permissions of new files; those of tempfile are private.
fn new_file_in(folder: &Path) -> std::io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // The system removes the bits of the umask.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

/// Refuses `-o` and a proof into a missing folder, onto a folder, or into one file, before any work is done.
pub(crate) fn check_destination(session: &Session) -> Result<()> {
    let output = &session.common.output;
    if let Some(proof) = &session.proof {
        if proof.as_os_str() == "-" {
            let message = "--proof -: a proof is written to a file of its own, and the answer to standard output";
            return Err(Error::Usage(message.into()));
        }
        check_place("--proof", proof)?;
        if output
            .as_deref()
            .is_some_and(|path| is_one_file(proof, path))
        {
            return Err(Error::Usage(format!(
                "--proof {}: -o writes to this file; write the proof to another one",
                proof.display()
            )));
        }
    }
    match output {
        Some(path) => check_place("-o", path),
        None => Ok(()),
    }
}

/// Refuses a missing folder or a folder in place of a file, for the file that `option` names.
pub(crate) fn check_place(option: &str, path: &Path) -> Result<()> {
    let folder = folder_of(path);
    if !folder.is_dir() {
        return Err(Error::Usage(format!(
            "{option} {}: there is no folder {}",
            path.display(),
            folder.display()
        )));
    }
    if path.is_dir() {
        return Err(Error::Usage(format!(
            "{option} {}: that is a folder",
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

/// The name of a report in its folder.
const PAGE: &str = "index.html";

/// Refuses a folder that cannot be made before any work is done.
pub(crate) fn check_folder(option: &str, folder: &Path) -> Result<()> {
    if folder.exists() && !folder.is_dir() {
        return Err(Error::Usage(format!(
            "{option} {}: that is a file; a folder is wanted, for the report {PAGE}",
            folder.display()
        )));
    }
    if folder.is_dir() {
        check_place(option, &folder.join(PAGE))
    } else {
        check_place(option, folder)
    }
}

/// Writes a report into its folder, which is made if it does not exist.
pub(crate) fn write_page(folder: &Path, page: &[u8], session: &Session) -> Result<()> {
    std::fs::create_dir_all(folder).map_err(|source| Error::Io {
        path: folder.into(),
        source,
    })?;
    write_beside(&folder.join(PAGE), page, session)
}

/// The day in Greenwich, such as `2001-12-31`.
pub(crate) fn today() -> String {
    let now = humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
    now.split('T').take(1).collect()
}
