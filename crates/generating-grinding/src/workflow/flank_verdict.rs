//! Items of a verdict that every grinding run has: its flanks, the agreement of plan and simulation, gearbox and servo, programs.

use super::result::FlankResult;
use crate::workflow::control::result::ControlResult;
use crate::workflow::programs::result::{ClearanceResult, ProgramsResult};
use foundation::geometry::Flank;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict, agree};

/// Judges one flank on its simulation: `met` by the rule of its process, then whether plan and simulation agree. `judged_on` says in words
/// where the tolerance holds, if that is not everywhere.
pub fn judge_flank(
    verdict: &mut Verdict,
    name: &str,
    flank: &FlankResult,
    (tolerance_um, judged_on): (f64, Option<&str>),
    met: bool,
    missed: impl FnOnce() -> Remark,
) {
    let detail = match judged_on {
        None => format!("{:.4} of {tolerance_um} um", flank.max_deviation_um),
        Some(places) => {
            format!("{:.3} of the tolerance: {tolerance_um} um on {places}", flank.tolerance_share)
        }
    };
    verdict.judge(format!("{name} flank"), met, detail, missed);
    let difference = flank.model_difference_um;
    if !agree(difference, tolerance_um) {
        let text = format!(
            "plan and simulation of the {name} flank differ by {difference:.3} um, more than a tenth of the tolerance of {tolerance_um} um"
        );
        let help = "round the edges of reliefs (transition_mm), take smaller amounts, or widen the tolerance";
        verdict.owe(
            format!("{name} flank: plan against simulation"),
            Remark::new("models-disagree", text, help),
        );
    }
}

/// Judges how near the envelope of a flank comes to a fold.
pub fn judge_envelope(verdict: &mut Verdict, name: &str, ratio: f64, limit: f64) {
    let detail = format!("determinant ratio {ratio:.3}, at least {limit}");
    verdict.judge(format!("envelope of the {name} flank"), ratio >= limit, detail, || {
        Remark::new(
            "determinant-ratio-below-limit",
            format!("the envelope of the {name} flank comes near a fold: determinant ratio {ratio:.3}, at least {limit} is wanted"),
            "round the edges of reliefs (transition_mm), take smaller amounts or another diagonal ratio, or lower grinding.least_determinant_ratio",
        )
    });
}

/// Notes the flanks that a run leaves out.
pub fn leave_other_flanks<T>(verdict: &mut Verdict, flanks: &BTreeMap<&'static str, T>) {
    for flank in Flank::BOTH.into_iter().filter(|flank| !flanks.contains_key(flank.name())) {
        verdict.leave(format!("{flank} flank"), "the job does not grind it");
    }
}

/// Judges what gearbox and servo leave on each flank.
pub fn judge_control(verdict: &mut Verdict, control: Option<&ControlResult>, tolerance_um: f64) {
    let Some(control) = control else {
        return verdict.leave("gearbox and servo", "the job has no [control]; couplings are ideal");
    };
    for (name, flank) in &control.flanks {
        let detail = format!("{:.4} um with the process", flank.deviation_with_control_um);
        verdict.judge(format!("{name} flank with gearbox and servo"), flank.tolerance_share <= 1.0, detail, || {
            Remark::new(
                "control-above-tolerance",
                format!(
                    "Gearbox and servo leave up to {:.3} um on the {name} flank, together with the process {:.3} um; the tolerance is {tolerance_um} um.",
                    flank.largest_um, flank.deviation_with_control_um
                ),
                "Take a stiffer loop (control.servo.bandwidth_hz), finer encoders and scales, or reduce the disturbances; the report shows which of them counts.",
            )
        });
        let difference = flank.model_difference_um;
        if !agree(difference, tolerance_um) {
            let text = format!(
                "what gearbox and servo leave on the {name} flank by closed form and by rays differs by {difference:.3} um, more than a tenth of the tolerance of {tolerance_um} um"
            );
            let help = "Take a stiffer loop or reduce the disturbances, so that less is left, or widen the tolerance.";
            verdict.owe(
                format!("{name} flank with gearbox and servo: closed form against rays"),
                Remark::new("models-disagree", text, help),
            );
        }
    }
    verdict.leave(
        "dressing of the worm through gearbox and servo",
        "[control] is that of grinding; axes of dressing move as commanded",
    );
}

/// Says what of approach, retraction and rapid moves was checked; texts that fail the check are not written.
pub fn judge_clearance(verdict: &mut Verdict, clearance: Option<&ClearanceResult>) {
    let item = "worm and workpiece beside the strokes of the programs";
    match clearance {
        Some(clearance) => {
            verdict.met(item, format!("{:.3} mm apart or more", clearance.least_mm));
            for body in &clearance.bodies {
                let detail = format!("{:.3} mm of {} or more, over all blocks", body.least_mm, body.of);
                verdict.met(format!("{} clear of the worm's side in the programs", body.body), detail);
            }
            for item in &clearance.not_checked {
                verdict.leave(
                    format!("collisions with {item}"),
                    "no body of the job or of the machine's description stands for it, or its place is not known",
                );
            }
        }
        None => verdict.leave(item, "their clearance is not checked for this process"),
    }
}

/// Notes that a worm which a disc writes line by line is dressed by no program: its passes use more areas than the lines reach.
pub fn owe_line_dressing(verdict: &mut Verdict) {
    verdict.owe(
        "programs: dressing of the worm by lines",
        Remark::new(
            "dressing-without-program",
            "the lines of a disc in point contact reach the one area of the plan; on several areas no program is written for them, only grinding programs are",
            "leave grinding.areas and grinding.roughing_areas out, take motions/dressing-lines-*.csv for the dressing, or a dresser with a profile (dresser.contact = \"line\")",
        ),
    );
}

/// Why there are no programs, mostly.
pub const NO_MACHINE: &str = "the job names no machine";

/// Judges the flanks that were simulated from the texts of the programs. `share` is the deviation of a flank of the run over its
/// tolerance, for tolerances that vary over the flank. Without programs, why there are none.
pub fn judge_programs(
    verdict: &mut Verdict,
    programs: Result<&ProgramsResult, &str>,
    tolerance_um: f64,
    share: impl Fn(&str) -> f64,
) {
    let programs = match programs {
        Ok(programs) => programs,
        Err(why) => return verdict.leave("programs", why),
    };
    for proof in &programs.proofs {
        let controls = proof.controls.join(", ");
        if !proof.threads.is_empty() {
            let detail =
                format!("{} of {} dressed, from the text", proof.threads.len(), proof.threads_of_worm);
            verdict.met(format!("programs for {controls}: threads of the worm"), detail);
        }
        for lines in &proof.lines {
            let off_um = lines.line_difference_um.max(lines.ray_difference_um);
            let item = format!("programs for {controls}: lines on the {} flank of the worm", lines.flank);
            let detail = format!(
                "{} on each of {} threads counted, within {off_um:.4} um of the plan's, from the text",
                lines.lines, lines.threads
            );
            verdict.judge(item, share(lines.flank) + off_um / tolerance_um <= 1.0, detail, || {
                Remark::new(
                    "program-above-tolerance",
                    format!(
                        "from the text of {} the worm is up to {off_um:.4} um off the plan's on its {} flank, which takes the flank of the gear out of its tolerance of {tolerance_um} um",
                        lines.file, lines.flank
                    ),
                    "mend what the plan misses; if the plan is met, lower chord_tolerance_um of the control",
                )
            });
        }
        if proof.areas > 1 {
            let detail = format!("{0} of {0} dressed and ground with, from the texts", proof.areas);
            verdict.met(format!("programs for {controls}: finishing areas of the worm"), detail);
        }
        verdict.met(
            format!("programs for {controls}: tooth spaces"),
            format!("{} ground, from the text", proof.tooth_spaces),
        );
        for item in &proof.not_covered {
            verdict.leave(format!("programs for {controls}: {item}"), "the proof does not cover it");
        }
        for (name, flank) in &proof.flanks {
            let within = flank.max_deviation_um <= tolerance_um
                || share(name) + flank.difference_um / tolerance_um <= 1.0;
            verdict.judge(
                format!("programs for {controls}: {name} flank"),
                within,
                format!("{:.4} of {tolerance_um} um from the text", flank.max_deviation_um),
                || {
                    Remark::new(
                        "program-above-tolerance",
                        format!(
                            "from the text of the programs for {controls} the {name} flank deviates by {:.4} um; the tolerance is {tolerance_um} um",
                            flank.max_deviation_um
                        ),
                        "mend what the plan misses; if the plan is met, lower chord_tolerance_um of the control",
                    )
                },
            );
        }
    }
}
