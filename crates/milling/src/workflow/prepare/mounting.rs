//! How the workpiece of a job sits on its machine, and how the control counts.

use crate::job::{MillingMachine, MillingMount, PoleWay, Rtcp};
use crate::workflow::programs::AtPole;
use job::tables::{BODY_CLEARANCE, ClampingBody};

/// A workpiece on a machine. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Mounting {
    /// Place of the workpiece on the table.
    pub mount: MillingMount,
    /// From the nose of the spindle to the tip of the cutter.
    pub tool_length: f64,
    /// Who leads the tip of the tool.
    pub rtcp: Rtcp,
    /// Largest distance of the tip from its path that straight blocks of the axes may leave, um.
    pub position_tolerance_um: f64,
    /// What is done near the pole.
    pub at_pole: AtPole,
    /// What holds the workpiece.
    pub clamping: Vec<ClampingBody>,
    /// Distance that tool, holder and spindle keep from it.
    pub body_clearance: f64,
}

impl Mounting {
    /// Of a job's machine table.
    pub(in crate::workflow) fn of_job(given: &MillingMachine) -> Self {
        let cap = given.pole_cap_deg.to_radians();
        Self {
            mount: given.mount,
            tool_length: given.tool_length,
            rtcp: given.rtcp,
            position_tolerance_um: given.position_tolerance_um,
            at_pole: match given.pole {
                PoleWay::Slow => AtPole::Slow { cap },
                PoleWay::Hold => AtPole::Hold { cap },
                PoleWay::Mount => AtPole::Mount { cap },
            },
            clamping: given.clamping.clone(),
            body_clearance: given.body_clearance.unwrap_or(BODY_CLEARANCE),
        }
    }
}
