//! `inspect` of a measured gear: by itself, for a job, or of a simulated machine in rounds.

use super::assemble::{InspectionContext, gear_result};
use super::bands::Bands;
use super::closed_loop::{Round, RoundResult, Wanted, of_file, simulated};
use super::evaluate::{Design, EvaluatedGear, evaluate_inspection};
use super::files::{MeasuredFiles, read_measurement};
use super::result::{BandResult, GearInspectionResult, LinesResult};
use crate::exchange::inspection::Inspection;
use crate::exchange::{Diagnostic, LoadedJob};
use crate::geometry::{Flank, Sides};
use crate::modification::{EvaluationField, Modification};
use crate::numerics::Progress;
use crate::workflow::finding::{JobFailure, Remark, RunFailure};
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// Everything that is known of a measured gear.
pub struct GearInspection {
    /// The document of `result.json`.
    pub result: GearInspectionResult,
    /// What was read, or measured on the simulated machine in the last round.
    pub inspection: Inspection,
    /// Its evaluation.
    pub gear: EvaluatedGear,
    /// Rounds against a job.
    pub rounds: Vec<Round>,
}

/// Reads and evaluates a measurement by itself; a file that states modifications is judged against them.
///
/// # Errors
/// [`JobFailure`]: a file that is no measurement, a header that makes no gear. What single traces lack is told by warnings.
pub fn inspect_gear(path: &Path) -> Result<GearInspection, JobFailure> {
    let begun = Instant::now();
    let mut files = read_measurement(path, None)?;
    let mut timing = BTreeMap::from([("reading", begun.elapsed().as_secs_f64())]);
    let begun = Instant::now();
    let stated = stated_design(&mut files);
    let design = |flank: Flank, w: f64, z: f64| {
        stated[flank].as_ref().map_or(0.0, |m: &Modification| m.value(w, z).unwrap_or(f64::NAN))
    };
    let design: Option<Design<'_>> = stated.iter().any(|(_, m)| m.is_some()).then_some(&design as Design<'_>);
    let gear = evaluate_inspection(&files.inspection, design).map_err(|error| {
        let message = format!("{}: {error}", path.display());
        RunFailure::bad_input(Diagnostic::with_code(error.code(), message).way_out(error.way_out()))
    })?;
    timing.insert("evaluation", begun.elapsed().as_secs_f64());
    let context = InspectionContext {
        name: stem(path),
        not_understood: files.not_understood,
        remarks: files.remarks,
        rounds: Vec::new(),
        bands: BTreeMap::new(),
        tolerance_um: None,
        reason: None,
        timing,
    };
    let result = gear_result(&files.inspection, &gear, context);
    Ok(GearInspection { result, inspection: files.inspection, gear, rounds: Vec::new() })
}

/// Judges a measured file against a job.
///
/// # Errors
/// As [`inspect_gear`]; a measurement of another gear, and what is wrong with the job.
pub fn inspect_for_job(
    loaded: &LoadedJob,
    path: &Path,
    progress: &dyn Progress,
) -> Result<GearInspection, JobFailure> {
    let begun = Instant::now();
    let (round, files) = of_file(loaded, path, progress)?;
    let found = (files.not_understood, files.remarks);
    Ok(of_rounds(loaded, vec![round], stem(path), found, begun)?)
}

/// Measures and corrects the simulated machine of a job.
///
/// # Errors
/// [`RunFailure`]: what is wrong with the job.
pub fn inspect_simulated(loaded: &LoadedJob, progress: &dyn Progress) -> Result<GearInspection, RunFailure> {
    let begun = Instant::now();
    let rounds = simulated(loaded, progress)?;
    of_rounds(loaded, rounds, loaded.job.job.name.clone(), (Vec::new(), Vec::new()), begun)
}

fn of_rounds(
    loaded: &LoadedJob,
    rounds: Vec<Round>,
    name: String,
    (not_understood, mut remarks): (Vec<LinesResult>, Vec<Remark>),
    begun: Instant,
) -> Result<GearInspection, RunFailure> {
    let table = loaded.job.inspection.clone().unwrap_or_default();
    let tolerance = table.tolerance_um.unwrap_or(loaded.job.target.tolerance_um);
    let Some(last) = rounds.last() else { return Err(RunFailure::no_settings()) };
    let wanted = Wanted::of_job(loaded)?;
    let design = wanted.design();
    let all = Bands::of_table(&table)?;
    let judged = |one: &super::evaluate::EvaluatedTrace| {
        Some((one.trace, all.judge(&last.inspection, &last.gear.gear, one.trace, Some(&design))?))
    };
    let bands: BTreeMap<usize, BandResult> = last.gear.traces.iter().filter_map(judged).collect();
    if last.result.flanks.is_empty() {
        remarks.push(Remark {
            code: "nothing-on-the-grid",
            text: "the measurement has no lines or fields of which a surface could be made".into(),
            way_out: "measure at least one profile and one helix trace of every tooth and flank".into(),
        });
    }
    let reason = missed(&last.result, &bands, tolerance);
    let (inspection, gear) = (last.inspection.clone(), last.gear.clone());
    let context = InspectionContext {
        name,
        not_understood,
        remarks,
        rounds: rounds.iter().map(|round| round.result.clone()).collect(),
        bands,
        tolerance_um: Some(tolerance),
        reason,
        timing: BTreeMap::from([("all", begun.elapsed().as_secs_f64())]),
    };
    let result = gear_result(&inspection, &gear, context);
    Ok(GearInspection { result, inspection, gear, rounds })
}

/// Why a measured gear is not what the job asks for.
fn missed(last: &RoundResult, bands: &BTreeMap<usize, BandResult>, tolerance_um: f64) -> Option<Remark> {
    let far = last.flanks.iter().max_by(|a, b| a.1.measured.largest_um.total_cmp(&b.1.measured.largest_um));
    let out = bands.values().filter(|band| !band.passed).count();
    let way_out = match &last.correction {
        Some(_) => "grind the next part by corrected-job.json",
        None => {
            "nothing that the settings could remove is systematic: look at clamping, machine and measurement"
        }
    };
    match far {
        Some((flank, of)) if of.measured.largest_um > tolerance_um => Some(Remark {
            code: "tolerance-exceeded",
            text: format!(
                "the {flank} flank was measured {:.3} um off its target (tolerance {tolerance_um} um)",
                of.measured.largest_um
            ),
            way_out: way_out.into(),
        }),
        _ if out > 0 => Some(Remark {
            code: "outside-the-band",
            text: format!("{out} of {} traces lie outside their band", bands.len()),
            way_out: way_out.into(),
        }),
        _ => None,
    }
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "part".into(), |stem| stem.to_string_lossy().into_owned())
}

/// The modifications that a file states; what they cannot be built from becomes a remark.
fn stated_design(files: &mut MeasuredFiles) -> Sides<Option<Modification>> {
    let Ok(gear) = files.inspection.gear.checked() else { return Sides::default() };
    let conditions = &files.inspection.conditions;
    let mut remarks = Vec::new();
    let found = Sides::from_fn(|flank| {
        let specs = &files.modifications[flank];
        if specs.is_empty() {
            return None;
        }
        let of = &conditions.flanks[flank];
        let involute = gear.flank(flank);
        let made = of.w_1_mm.zip(of.w_2_mm).zip(of.z_1_mm.zip(of.z_2_mm)).map(|((a, b), (c, d))| {
            EvaluationField::new([a, b], [c, d], involute.base_radius, involute.base_helix_angle).and_then(
                |field| Modification::for_flank(specs, flank, &field, &crate::modification::NoFiles),
            )
        });
        match made {
            Some(Ok(made)) => Some(made),
            other => {
                let why = other.map_or_else(
                    || "it states no range".into(),
                    |e| e.err().map_or_else(String::new, |e| e.to_string()),
                );
                remarks.push(Remark {
                    code: "modifications-not-used",
                    text: format!("the {flank} flank is judged against the involute, not against the file's modifications: {why}"),
                    way_out: "give a job with the target".into(),
                });
                None
            }
        }
    });
    files.remarks.extend(remarks);
    found
}
