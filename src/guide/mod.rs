//! The guide: the use of the program in examples. The tests run every command and compare its output with the text of the
//! guide.

// Pages name each other by references, which they define at their ends for readers of the files. Here the first definition counts.

#[doc = include_str!("tour.md")]
pub mod tour {}

#[doc = "[inspected]: inspection\n\n"]
#[doc = include_str!("space.md")]
pub mod space {}

#[doc = include_str!("topology.md")]
pub mod topology {}

#[doc = "[harmonic surface]: space#harmonic-surfaces\n[superquadric]: space#superquadrics\n\n"]
#[doc = include_str!("inspection.md")]
pub mod inspection {}

#[doc = include_str!("float-programs.md")]
pub mod float_programs {}

#[doc = include_str!("paper.md")]
pub mod paper {}

#[doc = include_str!("results.md")]
pub mod results {}

#[doc = include_str!("proofs.md")]
pub mod proofs {}

#[doc = "[Inspection]: inspection\n[Past one machine]: clusters\n[a Spark cluster]: clusters#spark\n\n"]
#[doc = include_str!("python.md")]
pub mod python {}

#[doc = "[Python]: python\n\n"]
#[doc = include_str!("clusters.md")]
pub mod clusters {}

#[doc = include_str!("glossary.md")]
pub mod glossary {}

#[doc = include_str!("performance.md")]
pub mod performance {}

#[doc = "[glossary]: glossary\n\n"]
#[doc = include_str!("contributing.md")]
pub mod contributing {}
