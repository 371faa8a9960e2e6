//! What an inspection comes to for callers that treat all tasks alike, and what a terminal shows of it.

use super::closed_loop::JointAxis;
use super::result::{GearInspectionResult, PitchInspectionResult, SummaryResult, class_in_words};
use super::run::GearInspection;
use super::sheet::SheetOptions;
use super::write::write_gear_inspection;
use crate::workflow::closed_loop::RoundResult;
use erased_serde::Serialize;
use run::summary::{closing, fixed, give, opening};
use run::{Remark, TaskOutcome, WriteError};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::{Status, Verdict};

impl TaskOutcome for GearInspection {
    fn job(&self) -> &str {
        &self.result.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        Some(&self.result.verdict)
    }

    fn result(&self) -> &dyn Serialize {
        &self.result
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_gear_inspection(self, &SheetOptions::default(), directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        summary(&self.result, written)
    }
}

fn summary(result: &GearInspectionResult, written: &[PathBuf]) -> String {
    let mut text = match result.tolerance_um {
        Some(tolerance) if result.rounds.last().is_some_and(|round| !round.flanks.is_empty()) => {
            opening(&result.job, &result.verdict, result.largest_um(), tolerance)
        }
        // Lines that make no surface are judged one by one; there is no largest deviation to tell.
        Some(tolerance) => {
            let missed = match result.verdict.status() {
                Status::Missed => "target MISSED",
                Status::Met => "target met",
                Status::NotJudged => "target NOT JUDGED",
            };
            let mut text = format!("{}: {missed} (tolerance {tolerance} um)\n", result.job);
            if let Some(reason) = result.verdict.reason() {
                give(&mut text, reason);
            }
            text
        }
        None => {
            let values = match result.printed_values {
                0 => String::new(),
                count => format!(", {count} printed values read"),
            };
            let judged = match (result.verdict.status(), result.tolerance_class) {
                (Status::Met, Some(class)) => format!("class {class} reached"),
                (Status::Missed, Some(class)) => format!("class {class} MISSED"),
                (_, Some(class)) => format!("class {class} NOT JUDGED"),
                (_, None) => "not judged".to_owned(),
            };
            let mut text =
                format!("{}: {judged}; {} traces evaluated{values}\n", result.job, result.traces.len());
            if let Some(reason) = result.verdict.reason() {
                give(&mut text, reason);
            }
            text
        }
    };
    evaluated(&mut text, result);
    for round in &result.rounds {
        of_round(&mut text, round, result.rounds.len());
    }
    if !result.not_understood.is_empty() {
        // Writing to a text cannot fail.
        let _ = writeln!(
            text,
            "  {} lines were not understood: they are listed in result.json",
            result.not_understood.len()
        );
    }
    let warnings: Vec<Remark> = result.warnings.iter().take(SHOWN).cloned().collect();
    closing(&mut text, &result.verdict, &warnings, &result.timing_s, written);
    if result.warnings.len() > SHOWN {
        let _ = writeln!(text, "  {} more warnings are in result.json", result.warnings.len() - SHOWN);
    }
    text
}

/// Warnings that are printed.
const SHOWN: usize = 10;

fn evaluated(text: &mut String, result: &GearInspectionResult) {
    let one = |row: &SummaryResult| {
        let tag = if row.tag.is_empty() { String::new() } else { format!(" {}", row.tag) };
        let range = row.range_um.map_or_else(String::new, |um| format!(" (range {})", fixed(um, 2)));
        format!("{}{tag} {}{range}", row.characteristic, fixed(row.mean_um, 2))
    };
    for kind in ["profile", "helix"] {
        for flank in ["left", "right"] {
            let rows = result.summary.iter().filter(|row| row.kind == kind && row.flank == flank);
            let told: Vec<String> = rows.map(one).collect();
            if !told.is_empty() {
                let _ = writeln!(text, "  {kind:<7} {flank:<5} {} um", told.join(", "));
            }
        }
    }
    of_pitch(text, &result.pitch, result.run_out_um);
    if !result.classes.is_empty() {
        let class = class_in_words(result.class);
        let part = if result.class_is_partial { ", of what could be evaluated" } else { "" };
        let _ = writeln!(text, "  class of ISO 1328-1:2013: {class}{part}");
    }
    if !result.printed.is_empty() {
        let _ = writeln!(
            text,
            "  {} of the {} values that the measuring machine printed are among these, within {:.3} um",
            result.printed.len(),
            result.printed_values,
            result.printed_difference_um
        );
    }
}

/// Pitches by flank and the run-out.
pub(super) fn of_pitch(
    text: &mut String,
    pitches: &BTreeMap<&'static str, PitchInspectionResult>,
    run_out_um: Option<f64>,
) {
    for (flank, pitch) in pitches {
        let _ = writeln!(
            text,
            "  pitch   {flank:<5} fp {:.2}, fu {:.2}, Fp {:.2} um",
            pitch.single_um, pitch.neighbours_um, pitch.total_um
        );
    }
    if let Some(run_out) = run_out_um {
        let _ = writeln!(text, "  run-out {run_out:.2} um");
    }
}

pub(super) fn of_round(text: &mut String, round: &RoundResult, of: usize) {
    let number = if of > 1 { format!("round {}: ", round.round) } else { String::new() };
    for (flank, found) in &round.flanks {
        let explained = if found.explained { ", as the plan says" } else { "" };
        let _ = writeln!(
            text,
            "  {number}{flank} flank, measured less target: rms {:.3} um, largest {:.3} um{explained}",
            found.measured.rms_um, found.measured.largest_um
        );
    }
    for of in round.characteristics.iter().filter(|of| of.decision == "correct") {
        let sure = of.uncertainty_um.map_or_else(String::new, |u| format!(" (uncertainty {u:.3})"));
        let _ = writeln!(
            text,
            "    systematic: {} {} {} um{sure}",
            of.flank,
            of.characteristic,
            fixed(of.common_um, 3)
        );
    }
    if let Some(axis) = round.axes.first() {
        let _ = writeln!(
            text,
            "    {} = {} (uncertainty {}) would explain {:.0} % of it",
            axis.axis,
            fixed(axis.value, 4),
            fixed(axis.uncertainty, 4),
            100.0 * axis.explains
        );
    }
    if let Some(together) = &round.axes_together {
        let named = |axis: &JointAxis| {
            format!("{} = {} (uncertainty {})", axis.axis, fixed(axis.value, 4), fixed(axis.uncertainty, 4))
        };
        let named: Vec<String> = together.axes.iter().map(named).collect();
        let share = 100.0 * together.explains;
        let _ = writeln!(text, "    together {} would explain {share:.0} % of it", named.join(", "));
    }
    if let Some(why) = &round.no_correction {
        let _ = writeln!(text, "    no correction: {why}");
    }
    let Some(correction) = &round.correction else { return };
    for setting in correction.settings.iter().filter(|setting| !setting.dropped) {
        let bound = if setting.at_bound { ", held by its bound" } else { "" };
        let _ = writeln!(text, "    turn {}: {}{bound}", setting.name, fixed(setting.change, 4));
    }
    for group in &correction.not_told_apart {
        let named: Vec<&str> = group.iter().map(|(name, _)| name.as_str()).collect();
        let _ = writeln!(
            text,
            "    the measured lines do not tell apart: {}; the smallest changes are given",
            named.join(", ")
        );
    }
    for (flank, proof) in &correction.proof {
        let _ = writeln!(
            text,
            "    the referee proves for the {flank} flank: rms {:.3} -> {:.3} um, largest {:.3} -> {:.3} um",
            proof.before.rms_um, proof.after.rms_um, proof.before.largest_um, proof.after.largest_um
        );
    }
}
