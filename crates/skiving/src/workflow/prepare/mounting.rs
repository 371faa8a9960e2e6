//! How the tool of a job sits in its machine.

use crate::job::{BarrierCarrier, SkivingMachine};
use machine::Mount;

/// A tool in a machine. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolMounting {
    /// Where the tool sits in its spindle.
    pub mount: Mount,
    /// The axis that brings light barrier and tool together.
    pub carrier: Option<BarrierCarrier>,
    /// How far it goes back from the beam.
    pub retreat: f64,
    /// Digital output that is on while the recorder takes down where the spindle stands.
    pub output: u8,
}

impl ToolMounting {
    /// Of a job's machine table.
    pub(in crate::workflow) fn of_job(given: &SkivingMachine) -> Self {
        Self {
            mount: Mount {
                reversed: false,
                axial: given.tool_length,
                angle: given.tooth_angle_deg.to_radians(),
            },
            carrier: given.carrier.clone(),
            retreat: given.retreat,
            output: given.output,
        }
    }
}
