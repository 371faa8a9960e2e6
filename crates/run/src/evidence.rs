//! What a process found on the way to a refusal.

use job::Diagnostic;
use report::charts::ChartError;
use report::{Block, Figure};
use serde_json::Value;

/// What a process found on the way to a refusal.
pub trait Evidence {
    /// What was judged, as a list for `result.json`.
    fn candidates(&self) -> Value;

    /// What could not be judged, as a list for `result.json`.
    fn failed(&self) -> Value;

    /// Pictures of what limits.
    ///
    /// # Errors
    /// A number that is not finite.
    fn figures(&self, finding: &Diagnostic) -> Result<Vec<Figure>, ChartError>;

    /// What was tried, for the page.
    fn tried(&self) -> Vec<Block>;
}
