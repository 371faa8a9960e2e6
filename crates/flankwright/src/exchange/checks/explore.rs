//! Contradictions in `[explore]`.

use crate::exchange::diagnostic::{Diagnostic, Problem};
use crate::exchange::job::{Explore, Job};
use crate::exchange::node::shown_number;

pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
    let Some(explore) = &job.explore else { return };
    if *explore == Explore::default() {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "`explore` does not say what varies")
                .field("explore.diagonal_ratio")
                .allowed("one or more of diagonal_ratio, worm_cone_angle_deg, crossed_axes_angle_deg")
                .way_out("add one, e.g. diagonal_ratio = { from = -3.0, to = 3.0, count = 61 }"),
        );
    }
    for (key, steps) in [
        ("diagonal_ratio", explore.diagonal_ratio),
        ("worm_cone_angle_deg", explore.worm_cone_angle_deg),
        ("crossed_axes_angle_deg", explore.crossed_axes_angle_deg),
    ] {
        let Some(steps) = steps else { continue };
        if steps.to <= steps.from {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, format!("the values of `{key}` do not ascend"))
                    .field(format!("explore.{key}.to"))
                    .value(shown_number(steps.to))
                    .allowed(format!("> from = {}", shown_number(steps.from)))
                    .way_out("give the smaller value as `from`"),
            );
        }
    }
}
