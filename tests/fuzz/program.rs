//! The program itself on mutated files and arguments: the exit code, one message, no output of a refused input, memory.

use std::fs;
use std::io::{Read, Write};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use assert_cmd::cargo::CommandCargoExt;
use tempfile::TempDir;

use super::draw::Draw;
use super::harness::{LARGEST_MEMORY, Outcome, peak_memory_of};
use super::mutate::{mutated_text, shown};
use super::pictures::any_picture;
use super::seeds;

/// Seconds that the program may take.
const TIME_LIMIT: u64 = 3;
/// After this the program is stopped, and that is a finding: a limit that is not kept.
const PATIENCE: Duration = Duration::from_secs(60);

fn reader_of(stream: Option<impl Read + Send + 'static>) -> thread::JoinHandle<Vec<u8>> {
    let mut stream = stream.unwrap();
    thread::spawn(move || {
        let mut bytes = Vec::new();
        // The program may be stopped.
        let _ = stream.read_to_end(&mut bytes);
        bytes
    })
}

/// A file name, its bytes, and the arguments besides.
fn input(draw: &mut Draw) -> (&'static str, Vec<u8>, Vec<&'static str>) {
    let verbs: [&[&'static str]; 8] = [
        &["describe"],
        &["implicitize"],
        &["parametrize"],
        &["sample", "--directions", "7"],
        &["inspect", "--tolerance", "0.1", "--point", "0.5,0.5"],
        &["inspect", "--tolerance", "0.1", "--point", "0.5,0.5,1/3"],
        &["check", "--self"],
        &["plot", "-o", "out.svg"],
    ];
    let verb = draw.pick(&verbs);
    let of = |name: &'static str| {
        let mut arguments = verb.to_vec();
        arguments.insert(1, name);
        arguments
    };
    let few = ["--directions", "7"];
    match draw.below(7) {
        0 => (
            "form.txt",
            mutated_text(draw, seeds::formulas()),
            of("form.txt"),
        ),
        1 => (
            "form.json",
            mutated_text(draw, seeds::documents()),
            of("form.json"),
        ),
        2 => (
            "table.csv",
            mutated_text(draw, seeds::coefficients()),
            of("table.csv"),
        ),
        3 => {
            let mut arguments = vec!["implicitize", "rows.csv", "--harmonics", "3"];
            if draw.once_in(2) {
                arguments = vec!["sample", "rows.csv", "--harmonics", "3"];
                arguments.extend(few);
            }
            ("rows.csv", mutated_text(draw, seeds::rows()), arguments)
        }
        4 => {
            let name = draw.pick(&["picture.png", "picture.jpg", "picture.bmp"]);
            (
                name,
                any_picture(draw),
                vec!["implicitize", name, "--harmonics", "3"],
            )
        }
        5 => {
            let arguments = vec![
                "inspect",
                "x^2 + y^2 = 1",
                "--tolerance",
                "0.1",
                "--points",
                "points.csv",
            ];
            ("points.csv", mutated_text(draw, seeds::rows()), arguments)
        }
        _ => {
            let arguments = vec!["check", "r = 1 + cos(t)/4", "--coefficients", "table.csv"];
            (
                "table.csv",
                mutated_text(draw, seeds::coefficients()),
                arguments,
            )
        }
    }
}

pub(crate) fn program(draw: &mut Draw) -> Outcome {
    let (name, bytes, mut arguments) = input(draw);
    let limit = TIME_LIMIT.to_string();
    arguments.extend(["--time-limit", &limit]);
    let by_pipe = draw.once_in(6) && arguments[1] == name && name != "picture.png";
    if by_pipe {
        arguments[1] = "-";
    }
    draw.input = format!("stellate {arguments:?} where {name} has {}", shown(&bytes));
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(name), &bytes).unwrap();
    let mut child = Command::cargo_bin("stellate")
        .unwrap()
        .current_dir(folder.path())
        .args(&arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let fed = thread::spawn(move || {
        // The program need not read it.
        let _ = if by_pipe {
            stdin.write_all(&bytes)
        } else {
            Ok(())
        };
    });
    let (out, err) = (
        reader_of(child.stdout.take()),
        reader_of(child.stderr.take()),
    );
    let start = Instant::now();
    let process = child.id().to_string();
    let mut memory = 0;
    let status = loop {
        memory = memory.max(peak_memory_of(&process).unwrap_or(0));
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if start.elapsed() > PATIENCE {
            child.kill().unwrap();
            let _ = child.wait();
            panic!("it took more than {PATIENCE:?} with a limit of {TIME_LIMIT} s");
        }
        thread::sleep(Duration::from_millis(3));
    };
    fed.join().unwrap();
    let (out, err) = (out.join().unwrap(), err.join().unwrap());
    let said = String::from_utf8_lossy(&err);
    let code = status.code();
    assert!(matches!(code, Some(0..=3)), "exit code {code:?}: {said}");
    assert!(!said.contains("panicked"), "{said}");
    let is_message = |line: &&str| line.starts_with("stellate: ") || line.starts_with("{\"error\"");
    let messages = said.lines().filter(is_message).count();
    if code == Some(2) {
        // Inspection streams: the rows before a bad one stand.
        let streams = arguments.contains(&"--points");
        assert!(
            streams || out.is_empty(),
            "output with exit code 2: {}",
            shown(&out)
        );
        assert_eq!(messages, 1, "one message with exit code 2: {said}");
        assert_eq!(
            fs::read_dir(folder.path()).unwrap().count(),
            1,
            "files were left"
        );
    }
    if code == Some(3) {
        assert_eq!(messages, 1, "one message with exit code 3: {said}");
    }
    assert!(memory < LARGEST_MEMORY, "{memory} bytes of memory");
    if code == Some(0) {
        Outcome::Checked
    } else {
        Outcome::Open
    }
}
