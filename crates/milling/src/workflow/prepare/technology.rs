//! The tools of a job as programs call them: number, length, speed, feeds, coolant.

use crate::OperationKind;
use crate::job::{CutterCoolant, CutterUse, MillingJob};

/// The tools of a job.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MillingTechnology {
    /// The tool that finishes the flanks.
    pub finishing: ToolData,
    /// The tool of the bottom.
    pub bottom: ToolData,
    /// The tool that clears the space.
    pub roughing: ToolData,
}

/// A tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolData {
    /// Its number.
    pub number: u32,
    /// Number of its length on the control, where the job names one.
    pub length_offset: Option<u32>,
    /// Its cutting edges, where the job tells how many there are.
    pub edges: Option<u32>,
    /// From the nose of the spindle to its tip, mm; 0 without a machine.
    pub length: f64,
    /// Speed of the spindle, 1/min.
    pub spindle_rpm: f64,
    /// Speed of the contact along a path, mm/min.
    pub feed: f64,
    /// Speed towards the first place of a path, mm/min.
    pub plunge_feed: f64,
    /// Coolant.
    pub coolant: CutterCoolant,
}

impl MillingTechnology {
    /// Of a job.
    pub(super) fn of_job(job: &MillingJob) -> Self {
        let milling = &job.milling;
        let tool = |purpose| {
            let (cutter, number) = job.cutter_for(purpose);
            let of_operation = milling.roughing.as_ref().filter(|_| purpose == CutterUse::Roughing);
            let of_operation = of_operation.and_then(|roughing| roughing.feed_mm_per_min);
            let feed = of_operation.or(cutter.feed_mm_per_min).unwrap_or(milling.feed_mm_per_min);
            let plunge_feed = cutter.plunge_feed_mm_per_min.or(milling.plunge_feed_mm_per_min);
            ToolData {
                number,
                length_offset: cutter.length_offset,
                edges: cutter.teeth,
                length: job.tool_length_of(cutter).unwrap_or(0.0),
                spindle_rpm: cutter.spindle_rpm.unwrap_or(milling.spindle_rpm),
                feed,
                // Roughing may have a feed of its own without going into the material at it.
                plunge_feed: plunge_feed.or(cutter.feed_mm_per_min).unwrap_or(milling.feed_mm_per_min),
                coolant: cutter.coolant.unwrap_or(milling.coolant),
            }
        };
        Self {
            finishing: tool(CutterUse::Finishing),
            bottom: tool(CutterUse::Bottom),
            roughing: tool(CutterUse::Roughing),
        }
    }

    /// The tool of an operation.
    pub fn tool_of(&self, kind: OperationKind) -> ToolData {
        match kind {
            OperationKind::Roughing => self.roughing,
            OperationKind::Bottom => self.bottom,
            OperationKind::Flank(_) | OperationKind::Fillet(_) => self.finishing,
        }
    }
}
