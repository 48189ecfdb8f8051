//! The tests of the Python package, which are run by a script.

use std::io::Write as _;
use std::process::Command;

#[test]
fn the_python_package_passes_its_tests() {
    if std::env::var_os("STELLATE_SYSTEMS").is_none() {
        let skipped = "skipped: the Python package is built and tested with STELLATE_SYSTEMS=1";
        writeln!(std::io::stderr(), "{skipped}").unwrap();
        return;
    }
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/python/run");
    let run = Command::new(script).output().unwrap();
    let said = [run.stdout, run.stderr].map(|out| String::from_utf8_lossy(&out).into_owned());
    assert!(run.status.success(), "{}{}", said[0], said[1]);
}
