//! The command-line program: exact conversions between parametric and implicit forms.

mod cli;

use std::process::ExitCode;

use mimalloc::MiMalloc;

/// Products of large integers take megabytes and give them back at once. This allocator keeps them for the next product;
/// the system's has them cleared by the kernel again, which takes as long as the product itself.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

fn main() -> ExitCode {
    cli::main()
}
