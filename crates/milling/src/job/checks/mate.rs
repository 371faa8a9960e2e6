//! The mate of a bevel gear: its teeth and angles belong together.

use crate::job::MillingJob;
use job::checks::contradiction;
use job::{Diagnostic, shown_number};

pub(super) fn check(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let Some(mate) = &job.mate else { return };
    let Some(bevel) = &job.bevel else {
        findings.push(contradiction(
            "only a bevel gear has a mate here",
            "mate",
            "a table".into(),
            "no table without [bevel]",
            "leave `[mate]` out",
        ));
        return;
    };
    if mate.pitch_cone_angle_deg.is_some() && mate.shaft_angle_deg.is_some() {
        findings.push(contradiction(
            "the shaft angle is the sum of both pitch cone angles",
            "mate.shaft_angle_deg",
            "beside `pitch_cone_angle_deg`".into(),
            "at most one of pitch_cone_angle_deg, shaft_angle_deg",
            "keep one of them",
        ));
    }
    if mate.conjugate_angle_deg(bevel).is_none() {
        let most = f64::from(bevel.teeth) / bevel.pitch_cone_angle_deg.to_radians().sin();
        findings.push(contradiction(
            &format!("no pitch cone below 90 degrees has {} teeth beside this gear", mate.teeth),
            "mate.teeth",
            mate.teeth.to_string(),
            &format!("< {}", shown_number(most)),
            "compare the teeth and the pitch cone angle of both gears with the drawing",
        ));
    } else if let Some(misfit) = mate.misfit(bevel) {
        let by_default = misfit.key == "mate.teeth";
        findings.push(contradiction(
            &format!(
                "{} and {} teeth roll on this pitch cone with an angle of {:.4} degrees, not {}",
                bevel.teeth, mate.teeth, misfit.wanted, misfit.given
            ),
            misfit.key,
            if by_default { mate.teeth.to_string() } else { shown_number(misfit.given) },
            &if by_default {
                format!("teeth for axes at 90 degrees, or shaft_angle_deg = {}", shown_number(misfit.wanted))
            } else {
                shown_number(misfit.wanted)
            },
            "compare the teeth and the angles of both gears with the drawing",
        ));
    }
}
