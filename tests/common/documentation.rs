//! The files whose commands are run, in the order in which they build on each other.

pub(crate) const DOCUMENTATION: [&str; 14] = [
    "README.md",
    "src/guide/tour.md",
    "src/guide/space.md",
    "src/guide/topology.md",
    "src/guide/inspection.md",
    "src/guide/float-programs.md",
    "src/guide/paper.md",
    "src/guide/results.md",
    "src/guide/proofs.md",
    "src/guide/python.md",
    "src/guide/clusters.md",
    "src/guide/glossary.md",
    "src/guide/performance.md",
    "src/guide/contributing.md",
];
