//! Every command in the README and in paper-examples is run, and prints what is written there.
//!
//! `UPDATE_README=1 cargo test --test readme` writes what the commands print now into the files.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use tempfile::TempDir;

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

fn check(file: &Path) -> usize {
    let folder = TempDir::new().unwrap();
    for data in ["paper-examples", "tests/numpy"] {
        copy_folder(&root().join(data), &folder.path().join(data));
    }
    let (now, commands) = rewritten(file, folder.path());
    if std::env::var_os("UPDATE_README").is_some() {
        fs::write(file, &now).unwrap();
    }
    let written = fs::read_to_string(file).unwrap();
    assert_eq!(written, now, "{} is out of date", file.display());
    commands
}

#[test]
fn the_readme_says_what_the_commands_print() {
    assert!(check(&root().join("README.md")) >= 10);
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
        assert!(check(&readme) > 0, "{} has no command", readme.display());
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

#[test]
fn the_links_of_the_readme_lead_somewhere() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let letters = |c: char| c.is_alphanumeric() || c == '-';
    let anchors: Vec<String> = readme
        .lines()
        .filter_map(|line| line.trim_start_matches('#').strip_prefix(' '))
        .map(|title| title.to_lowercase().replace(' ', "-"))
        .map(|title| title.chars().filter(|c| letters(*c)).collect())
        .collect();
    let targets = readme.split("](").skip(1);
    let targets: Vec<&str> = targets.filter_map(|rest| rest.split(')').next()).collect();
    assert!(targets.len() > 20);
    for target in targets {
        match target.strip_prefix('#') {
            Some(anchor) => assert!(anchors.iter().any(|a| a == anchor), "{target}"),
            None if target.starts_with("https://") => {}
            None => assert!(root().join(target).exists(), "{target}"),
        }
    }
}
