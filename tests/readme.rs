//! Every command in the README and in paper-examples is run, and prints what is written there.
//!
//! `UPDATE_README=1 cargo test --test readme` writes what the commands print now into the files.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use tempfile::TempDir;

#[path = "common/documentation.rs"]
mod documentation;
use documentation::DOCUMENTATION;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let target = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy_folder(&path, &target);
        } else {
            fs::copy(&path, &target).unwrap();
        }
    }
}

/// What a command prints: standard output, then standard error.
fn run(command: &str, folder: &Path) -> String {
    let words = shell_words::split(command).unwrap();
    let arguments = match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["stellate", ..] => &words[1..],
        ["cargo", "run", "--release", "--", ..] => &words[4..],
        _ => panic!("not a command of ours: {command}"),
    };
    let output = Command::new(env!("CARGO_BIN_EXE_stellate"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    // 1 is an answer, too: no.
    assert!(
        matches!(output.status.code(), Some(0 | 1)),
        "{command}: {}",
        text(&output.stderr)
    );
    text(&output.stdout) + &text(&output.stderr)
}

/// Runs the commands of a file in one folder; returns the file with their output as it is now.
fn rewritten(file: &Path, folder: &Path) -> (String, usize) {
    let text = fs::read_to_string(file).unwrap();
    let (mut result, mut commands, mut block) = (String::new(), 0, "");
    for line in text.lines() {
        if let Some(kind) = line.strip_prefix("```") {
            block = if block.is_empty() { kind } else { "" };
        }
        let command = match block {
            "console" => line.strip_prefix("$ "),
            "sh" => (!line.starts_with("```") && line != "cargo test").then_some(line),
            _ => None,
        };
        // The old output of a console block is dropped: what comes is compared with the whole file.
        let is_old_output = block == "console" && command.is_none() && !line.starts_with("```");
        if !is_old_output {
            result.push_str(line);
            result.push('\n');
        }
        if let Some(command) = command {
            commands += 1;
            let printed = run(command, folder);
            if block == "console" {
                result.push_str(&printed);
            }
        }
    }
    (result, commands)
}

/// A folder with the data that commands name.
fn folder() -> TempDir {
    let folder = TempDir::new().unwrap();
    for data in [
        "paper-examples",
        "tests/numpy",
        "tests/outlines",
        "tests/proofs",
    ] {
        copy_folder(&root().join(data), &folder.path().join(data));
    }
    folder
}

fn check(file: &Path, folder: &Path) -> usize {
    let (now, commands) = rewritten(file, folder);
    if std::env::var_os("UPDATE_README").is_some() {
        fs::write(file, &now).unwrap();
    }
    let written = fs::read_to_string(file).unwrap();
    assert_eq!(written, now, "{} is out of date", file.display());
    commands
}

#[test]
fn the_readme_and_the_guide_say_what_the_commands_print() {
    let folder = folder();
    let commands = DOCUMENTATION.map(|file| check(&root().join(file), folder.path()));
    assert!(commands.iter().sum::<usize>() > 60, "{commands:?}");
    // The guide is all of it.
    let files = fs::read_dir(root().join("src/guide")).unwrap();
    let files = files.filter(|f| {
        f.as_ref()
            .unwrap()
            .path()
            .extension()
            .is_some_and(|e| e == "md")
    });
    assert_eq!(files.count() + 1, DOCUMENTATION.len());
}

#[test]
fn the_paper_examples_say_what_their_commands_print() {
    let folders = fs::read_dir(root().join("paper-examples")).unwrap();
    let mut readmes: Vec<PathBuf> = folders
        .map(|f| f.unwrap().path().join("README.md"))
        .collect();
    readmes.sort();
    assert!(!readmes.is_empty());
    for readme in readmes {
        assert!(
            check(&readme, folder().path()) > 0,
            "{} has no command",
            readme.display()
        );
    }
}

#[test]
fn the_test_command_of_the_readme_is_what_ci_runs() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(readme.contains("```sh\ncargo test\n```"));
    let ci = fs::read_to_string(root().join(".ci/run")).unwrap();
    assert!(ci.contains("cargo test"));
}

/// The commands that `--help` lists.
fn verbs() -> Vec<String> {
    let help = run("stellate --help", root());
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let listed = listed.take_while(|line| !line.is_empty());
    // A description may go on in the next line, farther to the right.
    let names = listed.filter_map(|line| line.strip_prefix("  "));
    let names = names.filter(|line| !line.starts_with(' '));
    let names = names.filter_map(|line| line.split_whitespace().next());
    names
        .filter(|name| *name != "help")
        .map(str::to_owned)
        .collect()
}

#[test]
fn every_verb_and_every_example_has_its_place_in_the_readme() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(readme.lines().count() < 180, "the README is one page");
    let verbs = verbs();
    assert!(verbs.len() >= 11, "{verbs:?}");
    for verb in verbs {
        assert!(readme.contains(&format!("\n| `{verb}` | ")), "{verb}");
        assert!(readme.contains(&format!("\n$ stellate {verb} ")), "{verb}");
    }
    for folder in fs::read_dir(root().join("paper-examples")).unwrap() {
        let name = folder.unwrap().file_name().into_string().unwrap();
        let link = format!("](paper-examples/{name}/README.md)");
        assert!(readme.contains(&link), "{name}");
    }
}

/// What the titles of a file are called in links.
fn anchors(text: &str) -> Vec<String> {
    let letters = |c: char| c.is_alphanumeric() || c == '-';
    let titles = text.lines().filter(|line| line.starts_with('#'));
    let titles = titles.filter_map(|line| line.trim_start_matches('#').strip_prefix(' '));
    let titles = titles.map(|title| title.to_lowercase().replace(' ', "-"));
    titles
        .map(|title| title.chars().filter(|c| letters(*c)).collect())
        .collect()
}

#[test]
fn the_links_of_the_documentation_lead_somewhere() {
    let mut count = 0;
    for name in DOCUMENTATION {
        let file = root().join(name);
        let text = fs::read_to_string(&file).unwrap();
        let targets = text.split("](").skip(1);
        let targets = targets.filter_map(|rest| rest.split(')').next());
        for target in targets.filter(|target| !target.starts_with("https://")) {
            count += 1;
            let (path, anchor) = target.split_once('#').unwrap_or((target, ""));
            let path = match path {
                "" => file.clone(),
                _ => file.parent().unwrap().join(path),
            };
            assert!(path.exists(), "{name}: {target}");
            if !anchor.is_empty() {
                let anchors = anchors(&fs::read_to_string(&path).unwrap());
                assert!(anchors.iter().any(|a| a == anchor), "{name}: {target}");
            }
        }
    }
    assert!(count > 40, "{count} links");
}

/// The programs of the guide that read a radius, in Python and in C; only where the variable says that both are there.
#[test]
fn the_programs_of_the_guide_read_a_radius() {
    if std::env::var_os("STELLATE_SYSTEMS").is_none() {
        let skipped = "skipped: Python and C read a radius with STELLATE_SYSTEMS=1";
        writeln!(std::io::stderr(), "{skipped}").unwrap();
        return;
    }
    let guide = fs::read_to_string(root().join("src/guide/results.md")).unwrap();
    let folder = folder();
    let fit = guide
        .lines()
        .find_map(|line| line.strip_prefix("$ ").filter(|l| l.contains(" fit ")));
    run(fit.unwrap(), folder.path());
    for (language, file, command, expected) in [
        ("python", "inside.py", "python3 inside.py", "True False\n"),
        (
            "c",
            "inside.c",
            "cc -Wall -Wextra -Werror inside.c -o inside -lm && ./inside",
            "inside\noutside\n",
        ),
    ] {
        let (_, block) = guide.split_once(&format!("```{language}\n")).unwrap();
        let (program, _) = block.split_once("```").unwrap();
        fs::write(folder.path().join(file), program).unwrap();
        let output = std::process::Command::new("sh")
            .args(["-c", command])
            .current_dir(folder.path())
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(String::from_utf8_lossy(&output.stdout), expected, "{said}");
    }
}
