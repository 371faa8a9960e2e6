//! Contradictions in a table `servo`, whatever job it stands in.

use super::disturbance::{Disturbance, Spindle};
use super::servo::Servo;
use crate::contradiction::contradiction;
use crate::diagnostic::{Diagnostic, Problem};
use crate::node::shown_number;

/// All contradictions of the table at `path`; `worm`: whether the job has a worm whose angle a torque can follow.
pub fn check_servo(path: &str, servo: &Servo, worm: bool, findings: &mut Vec<Diagnostic>) {
    const GAINS: &str = "exactly one of bandwidth_hz, gains";
    match (servo.bandwidth_hz, &servo.gains) {
        (None, None) => findings.push(
            Diagnostic::new(Problem::MissingKey, format!("`{path}` does not say how stiff the loop is"))
                .field(format!("{path}.bandwidth_hz"))
                .allowed(GAINS)
                .way_out("add `bandwidth_hz`, e.g. 40, from which the gains follow, or `gains`"),
        ),
        (Some(_), Some(_)) => findings.push(contradiction(
            "the gains of the loop are given twice",
            format!("{path}.gains"),
            "a table beside `bandwidth_hz`".to_owned(),
            GAINS,
            "keep one of them",
        )),
        _ => {}
    }
    for (i, disturbance) in servo.disturbances.iter().enumerate() {
        let place = format!("{path}.disturbances[{i}]");
        if disturbance.axis() == Some(Spindle::Worm) && !worm {
            findings.push(contradiction(
                "a torque follows the angle of the worm, but the job has no worm",
                format!("{place}.axis"),
                "\"worm\"".to_owned(),
                "\"workpiece\", or a table [worm]",
                "add `[worm]`, or let the torque follow the workpiece",
            ));
        }
        if let Disturbance::Pulses { per_revolution, width_deg, .. } = *disturbance {
            let distance = 360.0 / f64::from(per_revolution);
            if width_deg >= distance {
                findings.push(contradiction(
                    "each pulse of the torque lasts until the next one begins",
                    format!("{place}.width_deg"),
                    shown_number(width_deg),
                    &format!("< {} = 360/per_revolution", shown_number(distance)),
                    "give a smaller width, or use the kind \"constant\"",
                ));
            }
        }
    }
}
