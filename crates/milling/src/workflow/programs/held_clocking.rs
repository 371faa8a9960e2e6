//! The clocking angle of a workpiece as a value that the control holds for the rotary axis that turns the workpiece about its own axis.

use foundation::kinematics::{Pose, Workpiece};
use job::Diagnostic;
use machine::Positions;
use motion::milling::MillingSetup;
use run::RunFailure;

/// What the control holds.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldClocking {
    /// Number of the axis on the machine.
    pub axis: usize,
    /// Its name.
    pub name: String,
    /// Its value as the control counts, rad.
    pub value: f64,
}

/// Positions of the rotary axes (rad) at which both workpieces are compared.
const LOOKED_AT: [[f64; 2]; 3] = [[0.0, 0.0], [0.6, -0.3], [-0.2, 1.3]];
/// Angle for that, rad, and how far tip and axis may be beside each other, mm.
const TURN: f64 = 0.1;
const SAME: f64 = 1e-9;

/// A workpiece that is turned about its own axis.
pub(super) fn turned<'m>(setup: &MillingSetup<'m>, angle: f64) -> MillingSetup<'m> {
    let turn: Pose<Workpiece, Workpiece> = Pose::rz(angle);
    setup.clamped(setup.clamping().then(&turn))
}

impl HeldClocking {
    /// Of a workpiece whose teeth stand by `angle` (rad) beside those of the setup.
    ///
    /// # Errors
    /// [`RunFailure`] where no axis without end turns the workpiece about its own axis.
    pub fn of(setup: &MillingSetup<'_>, angle: f64) -> Result<Self, RunFailure> {
        let axes = setup.machine().axes();
        let rotary = setup.axes().rotary;
        let found = rotary.into_iter().find_map(|axis| {
            let sense = [1.0, -1.0].into_iter().find(|sense| turns_alike(setup, axis, *sense))?;
            axes[axis].travel.is_none().then_some((axis, sense))
        });
        let Some((axis, sense)) = found else {
            let text = "no rotary axis without end turns the workpiece about its own axis, so that no value of one stands for its clocking angle";
            let finding =
                Diagnostic::with_code("clocking-not-holdable", text).field("machine.work_offset.clocking");
            let finding = finding
                .value("true")
                .allowed("false, or a workpiece in the middle of a table that turns without end");
            let way_out = "leave `clocking` out: the program then holds the angle; or set machine.mount.offset to [0, 0]";
            return Err(RunFailure::bad_input(finding.way_out(way_out)));
        };
        Ok(Self { axis, name: axes[axis].name.clone(), value: axes[axis].nc_sign * sense * angle })
    }
}

/// Whether an axis that turns by an angle in a sense undoes a turn of the workpiece by that angle.
fn turns_alike(setup: &MillingSetup<'_>, axis: usize, sense: f64) -> bool {
    let clocked = turned(setup, TURN);
    LOOKED_AT.into_iter().all(|angles| {
        let mut at = Positions::default();
        for (rotary, angle) in setup.axes().rotary.into_iter().zip(angles) {
            at[rotary] = angle;
        }
        let mut further = at;
        further[axis] += sense * TURN;
        match (setup.stands(&at), clocked.stands(&further)) {
            (Ok((tip, axis)), Ok((found, along))) => {
                (tip.xyz - found.xyz).norm() <= SAME && (axis.xyz - along.xyz).norm() <= SAME
            }
            _ => false,
        }
    })
}
