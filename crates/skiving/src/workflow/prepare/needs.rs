//! Tables of a job that need something measured.

use crate::job::SkivingJob;
use job::{Diagnostic, Problem};
use run::RunFailure;

/// Refuses tables that need something measured: a job may leave that to the file that `inspect` is given.
///
/// # Errors
/// A finding on the table.
pub(in crate::workflow) fn needs_measurement(job: &SkivingJob, measured: bool) -> Result<(), RunFailure> {
    let tables = [
        ("history", job.history.is_some()),
        ("monte_carlo", job.monte_carlo.is_some()),
        ("runout", job.runout.is_some()),
    ];
    match tables.into_iter().find(|(_, given)| *given && !measured) {
        None => Ok(()),
        Some((table, _)) => {
            let message = format!("[{table}] needs a measured tool, and nothing is measured");
            let finding = Diagnostic::new(Problem::MissingKey, message)
                .field(table)
                .allowed("a table [readings] or [tool_errors], or a file given to `flankwright inspect`")
                .way_out(format!("add `[readings]`, or leave `[{table}]` out"));
            Err(RunFailure::bad_input(finding))
        }
    }
}
