//! Tool, workpiece and light barrier in the units of their drawings.

use crate::job::{LightBarrier, SkivingJob, SkivingToolEntry};
use job::tables::Gear;

/// What a job says of the bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// The tool.
    pub tool: SkivingToolEntry,
    /// The workpiece.
    pub gear: Gear,
    /// The light barrier, not calibrated.
    pub barrier: LightBarrier,
}

impl Drawn {
    pub(super) fn of_job(job: &SkivingJob) -> Self {
        Self { tool: job.skiving_tool, gear: job.gear.clone(), barrier: job.light_barrier }
    }
}
