//! Feeds, speed, and the tools of a job as programs call them.

use crate::OperationKind;
use crate::job::{CutterUse, MillingJob};

/// Feeds in mm/min, speed in 1/min.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MillingTechnology {
    /// Speed of the spindle.
    pub spindle_rpm: f64,
    /// Speed of the contact along a row.
    pub feed: f64,
    /// Speed along a pass that clears the space.
    pub roughing_feed: f64,
    /// Speed towards the first place of a path.
    pub plunge_feed: f64,
    /// The tool that finishes the flanks.
    pub finishing: ToolNumber,
    /// The tool of the bottom.
    pub bottom: ToolNumber,
    /// The tool that clears the space.
    pub roughing: ToolNumber,
}

/// A cutter as programs call it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ToolNumber {
    /// Number of the tool.
    pub number: u32,
    /// Its cutting edges, where the job tells how many there are.
    pub edges: Option<u32>,
}

impl MillingTechnology {
    /// Of a job.
    pub(super) fn of_job(job: &MillingJob) -> Self {
        let milling = &job.milling;
        let feed = milling.feed_mm_per_min;
        let own = milling.roughing.as_ref().and_then(|roughing| roughing.feed_mm_per_min);
        let tool = |purpose| {
            let (cutter, number) = job.cutter_for(purpose);
            ToolNumber { number, edges: cutter.teeth }
        };
        Self {
            spindle_rpm: milling.spindle_rpm,
            feed,
            roughing_feed: own.unwrap_or(feed),
            plunge_feed: milling.plunge_feed(),
            finishing: tool(CutterUse::Finishing),
            bottom: tool(CutterUse::Bottom),
            roughing: tool(CutterUse::Roughing),
        }
    }

    /// The tool of an operation.
    pub fn tool_of(&self, kind: OperationKind) -> ToolNumber {
        match kind {
            OperationKind::Roughing => self.roughing,
            OperationKind::Bottom => self.bottom,
            OperationKind::Flank(_) | OperationKind::Fillet(_) => self.finishing,
        }
    }

    /// The feed of an operation.
    pub fn feed_of(&self, kind: OperationKind) -> f64 {
        if kind == OperationKind::Roughing { self.roughing_feed } else { self.feed }
    }
}
