//! The command-line program: exact conversions between parametric and implicit forms.

use std::process::ExitCode;

use mimalloc::MiMalloc;
use stellate::cli;

/// The allocator. Products of large integers take megabytes and free them at once. MiMalloc keeps this memory for the next
/// product. With the allocator of the system the kernel clears it each time, which takes as long as the product itself.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

fn main() -> ExitCode {
    cli::main(std::env::args_os().collect()).into()
}
