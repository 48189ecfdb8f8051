//! What a broken invariant becomes.

use std::process::Command;

use rayon::prelude::*;
use stellate::cli::end_at_panics;

/// The variable by which the test runs itself in a process that ends.
const ENDS: &str = "STELLATE_TEST_ENDS";

#[test]
fn a_panic_on_any_thread_is_one_internal_error_that_ends_the_process() {
    if let Ok(format) = std::env::var(ENDS) {
        end_at_panics(format == "json");
        let sum: u32 = (0..100u32).into_par_iter().map(|k| k / (k - k % 100)).sum();
        unreachable!("a division by 0, not {sum}");
    }
    for format in ["text", "json"] {
        let itself = std::env::current_exe().unwrap();
        let name = "panics::a_panic_on_any_thread_is_one_internal_error_that_ends_the_process";
        let run = Command::new(itself)
            .args(["--exact", name])
            .env(ENDS, format)
            .env_remove("RUST_BACKTRACE")
            .output()
            .unwrap();
        assert_eq!(run.status.code(), Some(4));
        let text = String::from_utf8(run.stderr).unwrap();
        let (message, beginning) = match format {
            "json" => {
                let error: serde_json::Value = serde_json::from_str(&text).unwrap();
                assert_eq!(error["error"]["exit_code"], 4);
                (error["error"]["message"].as_str().unwrap().to_owned(), "")
            }
            _ => (text, "stellate: "),
        };
        let beginning = format!("{beginning}internal contradiction in tests/programs/panics.rs:");
        assert!(message.starts_with(&beginning), "{message}");
        assert!(message.contains("divide by zero"), "{message}");
        assert_eq!(message.trim_end().lines().count(), 1);
    }
}
