//! Stock of a part whose spaces are cut already.

use crate::job::{MillingJob, StockForm};

/// Allowance of a pre-cut part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreStock {
    /// Normal to the flanks, mm.
    pub allowance: f64,
    /// How far the clocking angle may be off, rad.
    pub clocking_error: f64,
}

impl PreStock {
    /// Of a job.
    pub(super) fn of_job(job: &MillingJob) -> Option<Self> {
        let stock = job.stock.filter(|stock| stock.form == StockForm::PreCut)?;
        Some(Self {
            allowance: stock.allowance?,
            clocking_error: stock.clocking_error_deg.unwrap_or(0.0).to_radians(),
        })
    }
}
