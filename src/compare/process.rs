//! Runs a program with a script, within limits. In the end the program and all its children have ended, whatever they do.

use std::fs::File;
use std::io::{self, Read, Seek, Write};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use crate::error::{Invariant, Result};
use crate::limits::Limits;

/// The time between two checks of the program.
const LOOK_EVERY: Duration = Duration::from_millis(4);

/// The largest number of bytes that are read of an output.
const MOST_BYTES: u64 = 256 << 20;

/// The number of characters of a program's output that messages repeat.
const REPEATED: usize = 120;

/// The way in which a program ended.
#[derive(Debug)]
pub(super) enum Ended {
    /// The program ended by itself, with success.
    Done(Output),
    /// The program took longer than its time and was ended.
    OverTime,
    /// There is no such program.
    Absent,
    /// The program ended in another way, which the text describes.
    Failed(String),
}

/// The output of a program.
#[derive(Debug)]
pub(super) struct Output {
    /// The standard output.
    pub(super) text: String,
    errors: String,
}

impl Output {
    /// The last line of the error output or, if that is empty, of the standard output.
    pub(super) fn said(&self) -> String {
        let lines = [&self.errors, &self.text].into_iter();
        let last = lines.filter_map(|text| text.lines().rfind(|line| !line.trim().is_empty()));
        match last.map(str::trim).next() {
            None => "nothing".into(),
            Some(line) if line.chars().count() <= REPEATED => format!("`{line}`"),
            Some(line) => format!("`{}…`", line.chars().take(REPEATED).collect::<String>()),
        }
    }
}

/// Runs a program in an empty folder with a script on its standard input, for at most `time`.
///
/// # Errors
/// Those of `limits`; the program is ended first.
pub(super) fn run(
    command: &str,
    arguments: &[&str],
    script: &str,
    time: Duration,
    limits: &Limits,
) -> Result<Ended> {
    limits.check()?;
    match start(command, arguments, script) {
        Ok(running) => running.wait(time, limits),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Ended::Absent),
        Err(error) => Ok(Ended::Failed(format!("it cannot be run: {error}"))),
    }
}

/// A running program. Its input and output are files without names, so that no pipe fills up and no file is left behind.
struct Running {
    child: Child,
    output: File,
    errors: File,
    _folder: tempfile::TempDir,
}

fn start(command: &str, arguments: &[&str], script: &str) -> io::Result<Running> {
    let mut input = tempfile::tempfile()?;
    input.write_all(script.as_bytes())?;
    input.rewind()?;
    let [output, errors] = [tempfile::tempfile()?, tempfile::tempfile()?];
    let folder = tempfile::tempdir()?;
    let mut process = Command::new(command);
    process
        .args(arguments)
        .current_dir(folder.path())
        .stdin(Stdio::from(input))
        .stdout(Stdio::from(output.try_clone()?))
        .stderr(Stdio::from(errors.try_clone()?));
    #[cfg(unix)]
    {
        use std::os::unix::process::CommandExt;
        // The program gets a process group of its own, so that its children end with it.
        process.process_group(0);
    }
    Ok(Running {
        child: process.spawn()?,
        output,
        errors,
        _folder: folder,
    })
}

impl Running {
    fn wait(mut self, time: Duration, limits: &Limits) -> Result<Ended> {
        let start = Instant::now();
        let status = loop {
            match self.child.try_wait() {
                Ok(Some(status)) => break status,
                Ok(None) => {}
                Err(error) => {
                    return Ok(Ended::Failed(format!("it cannot be waited for: {error}")));
                }
            }
            limits.check()?;
            if start.elapsed() > time {
                return Ok(Ended::OverTime);
            }
            if self.written() > MOST_BYTES {
                let reason = format!("it wrote more than {MOST_BYTES} bytes");
                return Ok(Ended::Failed(reason));
            }
            std::thread::sleep(LOOK_EVERY);
        };
        let output = Output {
            text: text(&mut self.output),
            errors: text(&mut self.errors),
        };
        Ok(if status.success() {
            Ended::Done(output)
        } else {
            Ended::Failed(format!("{} and said {}", ending(status), output.said()))
        })
    }

    fn written(&self) -> u64 {
        let files = [&self.output, &self.errors].into_iter();
        let sizes = files.map(|file| file.metadata().map_or(0, |data| data.len()));
        sizes.sum()
    }
}

impl Drop for Running {
    /// Ends all processes of the group.
    fn drop(&mut self) {
        #[cfg(unix)]
        if let Ok(group) = i32::try_from(self.child.id()) {
            use nix::sys::signal::{Signal, killpg};
            // An error means that no process is left.
            let _ = killpg(nix::unistd::Pid::from_raw(group), Signal::SIGKILL);
        }
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The end of a program in words, such as `it ended with exit code 3`, or its signal.
fn ending(status: ExitStatus) -> String {
    match status.code() {
        Some(code) => format!("it ended with exit code {code}"),
        None => format!("it ended by {status}"),
    }
}

/// The contents of a file, up to [`MOST_BYTES`].
fn text(file: &mut File) -> String {
    let mut bytes = Vec::new();
    file.rewind()
        .and_then(|()| file.take(MOST_BYTES).read_to_end(&mut bytes))
        .invariant("a file of our own can be read");
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
#[cfg(unix)]
mod tests {
    use super::*;
    use crate::error::Error;

    /// A number of milliseconds that is longer than any of these runs.
    const LONG: u64 = 3_600_000;

    fn shell(script: &str, milliseconds: u64) -> Ended {
        let time = Duration::from_millis(milliseconds);
        run("sh", &[], script, time, &Limits::none()).unwrap()
    }

    #[test]
    fn what_it_said_comes_back_and_how_it_ended() {
        let Ended::Done(output) = shell("echo one; pwd; echo late >&2", LONG) else {
            panic!("it ends")
        };
        assert!(output.text.starts_with("one\n"));
        assert_eq!(output.said(), "`late`");
        let folder = output.text.lines().nth(1).unwrap();
        assert!(!std::path::Path::new(folder).exists(), "{folder}");
        let Ended::Failed(reason) = shell("echo bad >&2; exit 3", LONG) else {
            panic!("it fails")
        };
        assert_eq!(reason, "it ended with exit code 3 and said `bad`");
        let absent = run("no-such-program", &[], "", Duration::ZERO, &Limits::none());
        assert!(matches!(absent.unwrap(), Ended::Absent));
    }

    /// The number of processes that have this word in their command line.
    #[cfg(target_os = "linux")]
    fn with_word(word: &str) -> usize {
        let processes = std::fs::read_dir("/proc").unwrap();
        let lines = processes.filter_map(|p| std::fs::read(p.unwrap().path().join("cmdline")).ok());
        lines
            .filter(|line| String::from_utf8_lossy(line).contains(word))
            .count()
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_program_that_hangs_is_ended_with_its_children() {
        // The program would sleep for ever; this test does not end unless the program is ended.
        assert!(matches!(
            shell("sleep 9725725 & sleep 9725725", 300),
            Ended::OverTime
        ));
        // The program ends and leaves a child behind.
        assert!(matches!(shell("sleep 9725725 &", LONG), Ended::Done(_)));
        // The system may take a moment to end it.
        while with_word("9725725") > 0 {
            std::thread::sleep(LOOK_EVERY);
        }
    }

    #[test]
    fn limits_end_it() {
        let limits = Limits::none().with_time_limit(Duration::from_millis(200));
        let ended = run("sh", &[], "sleep 9725725", Duration::MAX, &limits);
        assert!(matches!(ended, Err(Error::Limit { .. })));
    }
}
