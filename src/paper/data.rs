//! The data of the paper's examples. They are built into the program, so that it does not need the folder paper-examples.

/// The path of each file in the repository, and its text.
pub const EXAMPLE_DATA: [(&str, &str); 3] = [
    (
        "paper-examples/e02-butterfly/butterfly.csv",
        include_str!("../../paper-examples/e02-butterfly/butterfly.csv"),
    ),
    (
        "paper-examples/e02-jet/jet.csv",
        include_str!("../../paper-examples/e02-jet/jet.csv"),
    ),
    (
        "paper-examples/e09-sixth-degree/curve.txt",
        include_str!("../../paper-examples/e09-sixth-degree/curve.txt"),
    ),
];

/// The text of the file with this path.
pub(super) fn example(path: &str) -> Option<&'static str> {
    let found = EXAMPLE_DATA.iter().find(|(known, _)| *known == path);
    found.map(|(_, text)| *text)
}
