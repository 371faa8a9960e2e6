//! `flankwright verify`: recomputes every expected value of reference files. A build without the feature `verify` has the command too, and
//! answers how to get it.

use crate::common_arguments::CommonArguments;
use std::path::PathBuf;

#[cfg(feature = "verify")]
use ::verify::{VerifyOptions, VerifySummary, verify_file};
use clap::Args;
use flankwright::exchange::Diagnostic;

use crate::exit::Exit;
use crate::failure::Failure;
#[cfg(feature = "verify")]
use crate::output;

/// Arguments of `verify`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright verify tests/reference/10-gears.json tests/reference/28-planning.json\n\n\
    Exit status 0 only if no check failed."
)]
pub struct VerifyArguments {
    /// Reference files
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Directory with the data files that cases name
    #[arg(long, value_name = "DIR")]
    pub data: Option<PathBuf>,
    /// Without effect since every block is covered; scripts may give it
    #[arg(long, hide = true)]
    pub allow_uncovered: bool,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Says that this build cannot verify.
///
/// # Errors
/// Always.
#[cfg(not(feature = "verify"))]
pub fn run(_: &VerifyArguments) -> Result<Exit, Failure> {
    let finding =
        Diagnostic::with_code("not-in-this-build", "this program was built without the feature `verify`")
            .way_out("build it with `cargo build --release --package flankwright-cli --features verify`");
    Err(Failure::new(Exit::BadInput, finding))
}

/// Verifies the files and prints the summary.
///
/// # Errors
/// A file that cannot be read or is of no known schema.
#[cfg(feature = "verify")]
pub fn run(arguments: &VerifyArguments) -> Result<Exit, Failure> {
    let options = VerifyOptions { data_directories: arguments.data.iter().cloned().collect() };
    let mut reports = Vec::with_capacity(arguments.files.len());
    for file in &arguments.files {
        let report = verify_file(file, &options)
            .map_err(|error| Failure::new(Exit::BadInput, Diagnostic::of(&error)))?;
        reports.push(report);
    }
    let summary = VerifySummary::new(reports);
    if arguments.common.json {
        output::print_json(&summary)?;
    } else if !arguments.common.quiet {
        output::print(&text(&summary))?;
    }
    let done = summary.exit_code() == 0;
    Ok(if done { Exit::Done } else { Exit::Internal })
}

/// Failures shown per file; `--json` lists all.
#[cfg(feature = "verify")]
const SHOWN: usize = 10;

#[cfg(feature = "verify")]
fn text(summary: &VerifySummary) -> String {
    let mut text = String::new();
    for file in &summary.files {
        text += &format!("{}: {} checks, {} failed", file.file, file.checks, file.failed);
        if let Some(worst) = &file.worst {
            text += &format!(
                "; worst {:.2e} of the tolerance: {} {}",
                worst.share_of_tolerance, worst.case, worst.quantity
            );
        }
        text.push('\n');
        for f in file.failures.iter().take(SHOWN) {
            text += &format!("  failed: {} {}: {} instead of {}", f.case, f.quantity, f.actual, f.expected);
            if let (Some(difference), Some(tolerance)) = (f.difference, f.tolerance) {
                text += &format!(" (difference {difference:e}, tolerance {tolerance:e})");
            }
            text.push('\n');
        }
        for skipped in &file.not_run {
            text += &format!("  not run: {}: {}\n", skipped.case, skipped.reason);
        }
    }
    text
}
