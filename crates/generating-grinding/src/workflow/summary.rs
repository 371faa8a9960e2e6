//! What a terminal shows of a run of generating grinding.

use super::control::ControlResult;
use super::measured_worm::{MeasuredWormResult, WormAxis};
use super::programs::ProgramsResult;
use super::result::JobResult;
use super::run::Outcome;
use super::scene::scene_of_grinding;
use super::write::write_outcome;
use crate::job::LoadedJob;
use erased_serde::Serialize;
use run::summary::{closing, fixed, opening};
use run::{FlankMaps, RunFailure, TaskOutcome, WriteError};
use scene::Scene;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::Verdict;

/// A run of generating grinding with the job that it is of: what is written has the job with its settings.
pub struct JobOutcome {
    /// The job as it was carried out.
    pub loaded: LoadedJob,
    /// What its run produced.
    pub outcome: Outcome,
}

impl TaskOutcome for JobOutcome {
    fn job(&self) -> &str {
        &self.outcome.result.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        Some(&self.outcome.result.verdict)
    }

    fn result(&self) -> &dyn Serialize {
        &self.outcome.result
    }

    fn scene(&self) -> Option<Result<Scene, RunFailure>> {
        Some(scene_of_grinding(&self.outcome))
    }

    fn flanks(&self) -> Vec<FlankMaps<'_>> {
        self.outcome.result.flanks.iter().map(|(name, flank)| flank.maps(name)).collect()
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_outcome(&self.loaded, &self.outcome, directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        summary(&self.outcome.result, written)
    }
}

/// What the job's control leaves, a line for each flank.
pub fn controlled(control: Option<&ControlResult>) -> String {
    let flanks = control.iter().flat_map(|control| &control.flanks);
    flanks
        .map(|(flank, f)| {
            format!(
                "  {flank:<5} gearbox and servo leave {:.3} um (rms {:.3}), pitch {:.3}/{:.3} um (single/cumulative); deviation with them {:.3} um\n",
                f.largest_um, f.rms_um, f.single_pitch_um, f.cumulative_pitch_um, f.deviation_with_control_um
            )
        })
        .collect()
}

/// What was proven from the texts of programs, a line for each text that says something of its own.
pub fn proven(programs: Option<&ProgramsResult>) -> String {
    let proofs = programs.iter().flat_map(|programs| &programs.proofs);
    proofs
        .map(|proof| format!("  programs for {}: {}\n", proof.controls.join(", "), proof.statement))
        .collect()
}

/// Which dressing axes explain a measured worm.
fn measured_worm(of: Option<&MeasuredWormResult>) -> String {
    let Some(of) = of else { return String::new() };
    let axis = |axis: &WormAxis| match axis.uncertainty {
        0.0 => format!("{} held", axis.axis),
        by => format!("{} {:.5} (uncertainty {by:.5})", axis.axis, axis.value),
    };
    let axes: Vec<String> = of.axes.iter().map(axis).collect();
    format!(
        "  measured worm: rms {:.3} um, {:.3} um with these axes off: {}\n",
        of.rms_um,
        of.rms_left_um,
        axes.join(", ")
    )
}

pub fn summary(result: &JobResult, written: &[PathBuf]) -> String {
    let worst = result.flanks.values().map(|f| f.max_deviation_um).fold(0.0, f64::max);
    let mut text = opening(&result.job, &result.verdict, worst, result.tolerance_um);
    let settings = &result.settings;
    let why = settings.diagonal_ratio_reason.as_deref().unwrap_or("as set");
    let _ = writeln!(text, "  diagonal ratio {:.6} ({why})", settings.settings.diagonal_ratio);
    let _ = writeln!(text, "  worm length used {:.2} mm", settings.worm_length_mm);
    text += &measured_worm(result.measured_worm.as_ref());
    for (flank, f) in &result.flanks {
        let t = &f.target_characteristics;
        let s = &f.simulated_characteristics;
        let _ = writeln!(
            text,
            "  {flank:<5} target, fitted over the whole field: helix crowning {} um, profile crowning {} um, twist {} um",
            fixed(t.helix_crowning_um, 2),
            fixed(t.profile_crowning_um, 2),
            fixed(t.twist_corner_um, 2)
        );
        let _ = writeln!(
            text,
            "        simulated, fitted likewise: helix crowning {} um, profile crowning {} um, twist {} um (corners), {} um (fit)",
            fixed(s.helix_crowning_um, 3),
            fixed(s.profile_crowning_um, 3),
            fixed(s.twist_corner_um, 4),
            fixed(s.twist_fit_um, 4)
        );
        let _ = writeln!(
            text,
            "        deviation max {:.4} um, rms {:.4} um; analytic against referee {:.2e} um (referee's own error {:.1e} um)",
            f.max_deviation_um, f.rms_deviation_um, f.model_difference_um, f.referee_error_um
        );
    }
    let marks: Vec<String> = result
        .flanks
        .iter()
        .filter_map(|(flank, f)| Some(format!("{flank} {:.3} um", f.feed_mark_um?)))
        .collect();
    if !marks.is_empty() {
        let _ = writeln!(text, "  feed marks stand above the envelope by up to {}", marks.join(", "));
    }
    for (flank, f) in &result.flanks {
        let Some(lines) = &f.line_dressing else { continue };
        let _ = writeln!(
            text,
            "  {flank:<5} worm flank in {} lines of {:.4} deg a thread, {:.4} mm apart, {:.2} m: {:.3} um above and {:.3} um below the wanted one",
            lines.lines,
            lines.line_direction_deg,
            lines.pitch_mm,
            lines.path_length_m,
            lines.simulated_scallop_um,
            lines.simulated_undercut_um
        );
    }
    let outside = result.flanks.values().map(|f| f.outside_class_um).fold(0.0, f64::max);
    if outside >= 5e-4 {
        let _ =
            writeln!(text, "  parts of the target are best-fitted only: {outside:.3} um of them are left");
    }
    text += &controlled(result.control.as_ref());
    text += &proven(result.programs.as_ref());
    closing(&mut text, &result.verdict, &result.warnings, &result.timing_s, written);
    text
}
