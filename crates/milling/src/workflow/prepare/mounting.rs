//! How the workpiece of a job sits on its machine, and how the control counts.

use crate::job::{EndMove, LengthHolder, MillingMachine, MillingMount, PoleWay, Rtcp};
use crate::workflow::programs::{AtPole, HeldOffset, ProbeTool};
use job::tables::{BODY_CLEARANCE, ClampingBody};

/// A workpiece on a machine. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Mounting {
    /// Place of the workpiece on the table, as programs see it: not turned by a clocking angle that the control holds.
    pub mount: MillingMount,
    /// Clocking angle that the control holds, rad.
    pub held_clocking: Option<f64>,
    /// Origin that the control holds.
    pub work_offset: Option<HeldOffset>,
    /// Whether the control adds the lengths of tools to positions of the axes.
    pub holds_lengths: bool,
    /// Time for the spindle to come to its speed, s.
    pub spindle_dwell: f64,
    /// Where the axes go at the end of a program, one after the other.
    pub end_position: Vec<EndMove>,
    /// The probe that finds the clocking angle.
    pub probe: Option<ProbeTool>,
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
        let held = given.work_offset.is_some_and(|offset| offset.clocking);
        let clocking = given.mount.clocking_deg;
        let MillingMount { offset: [x, y], height, .. } = given.mount;
        Self {
            mount: MillingMount { clocking_deg: if held { 0.0 } else { clocking }, ..given.mount },
            held_clocking: held.then_some(clocking.to_radians()),
            work_offset: given.work_offset.map(|offset| HeldOffset {
                number: offset.number,
                position: offset.position.unwrap_or([x, y, height]),
            }),
            holds_lengths: given.tool_length_in == LengthHolder::Control,
            spindle_dwell: given.spindle_dwell_s,
            end_position: given.end_position.clone(),
            probe: given.probe.as_ref().map(ProbeTool::of_job),
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
