//! Contradictions in `[control]`, whichever process grinds.

use crate::control::check_servo;
use crate::diagnostic::{Diagnostic, Problem};
use crate::tables::Control;

/// What contradicts itself in `[control]`.
pub fn check(control: Option<&Control>, feed_per_revolution: Option<f64>, findings: &mut Vec<Diagnostic>) {
    let Some(control) = control else { return };
    if feed_per_revolution.is_none() {
        findings.push(
            Diagnostic::new(
                Problem::MissingKey,
                "`[control]` needs `grinding.feed_per_revolution`: what the control costs on the flank depends on when each place is ground",
            )
            .field("grinding.feed_per_revolution")
            .allowed("a number > 0 and <= 100")
            .way_out("give the axial feed in mm per revolution of the gear, e.g. 0.3, or leave `[control]` out"),
        );
    }
    check_servo("control.servo", &control.servo, true, findings);
}
