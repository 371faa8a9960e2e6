//! What `plan` and `simulate` do with a finished run: files, summary, exit status.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use flankwright::exchange::{AnyJob, LoadedJob};
use flankwright::workflow::{
    ControlResult, JobResult, Outcome, ProgramsResult, Remark, RunFailure, Status, WriteError, write_outcome,
    write_refusal,
};
use serde::Serialize;

use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Writes the files of a run and prints its summary.
///
/// # Errors
/// A run that failed; files that cannot be written.
pub fn deliver(
    common: &CommonArguments,
    loaded: &LoadedJob,
    run: Result<Outcome, RunFailure>,
) -> Result<Exit, Failure> {
    let directory = output::own_directory(common, loaded, &loaded.job.job)?;
    let refused = |failure| refuse(&AnyJob::Grinding(loaded.clone()), failure, &directory);
    let outcome = run.map_err(refused)?;
    let written = write_outcome(loaded, &outcome, &directory).map_err(unwritten)?;
    output::note_owner(common, loaded, &directory)?;
    let result = &outcome.result;
    let verdict = Verdict::of(&result.job, &result.verdict);
    conclude(common, result, verdict, || summary(result, &written))
}

/// What is left to say of a run.
pub(super) struct Verdict<'a> {
    pub job: &'a str,
    pub status: Status,
    pub reason: Option<&'a Remark>,
}

impl<'a> Verdict<'a> {
    pub(super) fn of(job: &'a str, verdict: &'a flankwright::verdict::Verdict) -> Self {
        Self { job, status: verdict.status(), reason: verdict.reason() }
    }
}

/// Writes what a refusal of the bodies hands over and makes the failure of it.
pub(super) fn refuse(job: &AnyJob, failure: RunFailure, directory: &Path) -> Failure {
    let report = match &failure {
        RunFailure::NotProducible(finding) => match write_refusal(job, finding, directory) {
            Ok(written) => written.last().cloned(),
            Err(error) => return unwritten(error),
        },
        RunFailure::BadInput(_) => None,
    };
    let failure = match job {
        AnyJob::Grinding(loaded) => Failure::of_run(loaded, failure),
        AnyJob::Tangential(loaded) => Failure::of_run(loaded, failure),
        AnyJob::Gearbox(loaded) => Failure::of_run(loaded, failure),
        AnyJob::Milling(loaded) => Failure::of_run(loaded, failure),
        AnyJob::Skiving(loaded) => Failure::of_run(loaded, failure),
    };
    Failure { report, ..failure }
}

/// Prints what the arguments ask for; the exit status says whether the target is met.
pub(super) fn conclude(
    common: &CommonArguments,
    result: &impl Serialize,
    verdict: Verdict<'_>,
    summary: impl FnOnce() -> String,
) -> Result<Exit, Failure> {
    if common.json {
        output::print_json(result)?;
    } else if !common.quiet {
        output::print(&summary())?;
    }
    if let Some(reason) = verdict.reason.filter(|_| common.quiet) {
        // A miss is reported even when all else is quiet.
        eprintln!("{}: target {}: {} {}", verdict.job, verdict.status.words(), reason.text, reason.way_out);
    }
    // Without a reason the target is met, or nothing was asked for.
    Ok(if verdict.reason.is_none() { Exit::Done } else { Exit::TargetMissed })
}

/// Files that cannot be written.
pub(super) fn unwritten(error: WriteError) -> Failure {
    match error {
        WriteError::Io { path, source } => Failure::cannot_write(&path.display().to_string(), &source),
        WriteError::Busy { path } => Failure::busy(&path.display().to_string()),
        other => Failure::internal(other.to_string()),
    }
}

/// The beginning of a summary: whether the target is met, and why not.
pub(super) fn opening(verdict: &Verdict<'_>, worst_um: f64, tolerance_um: f64) -> String {
    let met = match verdict.status {
        Status::Met => "target met".to_owned(),
        Status::NotJudged => "target NOT JUDGED".to_owned(),
        // Something else is missed: the reason says what.
        Status::Missed if worst_um <= tolerance_um => "target MISSED".to_owned(),
        Status::Missed => format!("target MISSED, largest deviation {worst_um:.3} um"),
    };
    let mut text = format!("{}: {met} (tolerance {tolerance_um} um)\n", verdict.job);
    if let Some(reason) = verdict.reason {
        tell(&mut text, reason);
    }
    text
}

/// Why a target is missed or nothing was judged, and the way out.
pub(super) fn tell(text: &mut String, reason: &Remark) {
    // Writing to a text cannot fail.
    let _ = writeln!(text, "  {}: {}", reason.code, reason.text);
    let _ = writeln!(text, "  remedy: {}", reason.way_out);
}

/// The end of a summary: what the verdict covers, warnings, time, where the report is.
pub(super) fn closing(
    text: &mut String,
    verdict: &flankwright::verdict::Verdict,
    warnings: &[Remark],
    timing: &BTreeMap<&'static str, f64>,
    written: &[PathBuf],
) {
    let _ = writeln!(text, "  {}", verdict.scope_in_words());
    for warning in warnings {
        let _ = writeln!(text, "  warning: {} ({})", warning.text, warning.way_out);
    }
    let total: f64 = timing.values().sum();
    let stages: Vec<String> = timing.iter().map(|(stage, s)| format!("{stage} {s:.2} s")).collect();
    let _ = writeln!(text, "  time {total:.2} s ({})", stages.join(", "));
    if let Some(report) = written.last() {
        let _ = writeln!(text, "  report: {}", report.display());
    }
}

/// A number with fixed decimals; what rounds to zero has no sign.
pub(super) fn fixed(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| c == '0' || c == '.') => rest.to_owned(),
        _ => text,
    }
}

/// What the job's control leaves, a line for each flank.
pub(super) fn controlled(control: Option<&ControlResult>) -> String {
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
pub(super) fn proven(programs: Option<&ProgramsResult>) -> String {
    let proofs = programs.iter().flat_map(|programs| &programs.proofs);
    proofs
        .map(|proof| format!("  programs for {}: {}\n", proof.controls.join(", "), proof.statement))
        .collect()
}

fn summary(result: &JobResult, written: &[PathBuf]) -> String {
    let worst = result.flanks.values().map(|f| f.max_deviation_um).fold(0.0, f64::max);
    let verdict = Verdict::of(&result.job, &result.verdict);
    let mut text = opening(&verdict, worst, result.tolerance_um);
    let settings = &result.settings;
    let why = settings.diagonal_ratio_reason.as_deref().unwrap_or("as set");
    let _ = writeln!(text, "  diagonal ratio {:.6} ({why})", settings.settings.diagonal_ratio);
    let _ = writeln!(text, "  worm length used {:.2} mm", settings.worm_length_mm);
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
