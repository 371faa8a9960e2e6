//! The page of a measured bevel gear, composed from its result: its flanks beside the target and the process, what all teeth share, the
//! correction and its proof, pitches and classes.

mod pitch;

use super::measured_gear::{against_target, last_deviation, round_blocks, stages};
use crate::workflow::{BevelInspection, BevelInspectionResult, class_in_words};
use report::charts::{ChartError, format_fixed, format_significant};
use report::head::scope_blocks;
use report::{FirstPage, PlanReport, Quantity, Section, Sheet, html};
use run::{Answer, JobTitle, report_head, sentence};

const INTRODUCTION: &str = "All values are normal to the flank, positive where material is left standing, about their mean: what lies \
     everywhere is thickness or the turn of the gear on the measuring machine. w is the length of roll in the middle of the face; z counts \
     from there along the pitch cone, the heel at the upper end.";

/// The report as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite, or lists of different length.
pub fn html_page(found: &BevelInspection, files: &[(String, &'static str)]) -> Result<String, ChartError> {
    Ok(html::render(&page(found, files)?))
}

/// The same as data.
///
/// # Errors
/// As [`html_page`].
pub fn page(found: &BevelInspection, files: &[(String, &'static str)]) -> Result<PlanReport, ChartError> {
    let result = &found.result;
    let sections = sections(result)?;
    let info = job::tables::JobInfo { name: result.job.clone(), ..found.job.clone() };
    let answer = Answer {
        process: "Inspection of a bevel gear",
        status: result.verdict.status(),
        reason: result.verdict.reason(),
        warnings: &result.warnings,
        headline: headline(result),
        figures: figures(result),
        first_page: first_page(result)?,
    };
    Ok(report_head(JobTitle::new(&info, found.language), answer, files).page(sections))
}

fn headline(result: &BevelInspectionResult) -> String {
    if let Some(reason) = result.verdict.reason() {
        return sentence(reason);
    }
    let tolerance = result.tolerance_um;
    match result.tolerance_class {
        None => format!("The measured flanks are within {tolerance} µm of the target."),
        Some(class) => format!(
            "The measured flanks are within {tolerance} µm of the target, and the gear reaches class {class} of ISO 17485:2006."
        ),
    }
}

fn figures(result: &BevelInspectionResult) -> Vec<(String, String)> {
    let um = |value: f64| format!("{} µm", format_fixed(value, 3));
    let mut figures = Vec::new();
    if let Some(round) = result.rounds.last() {
        let rms = round.flanks.values().map(|flank| flank.measured.rms_um).reduce(f64::max);
        figures.extend(rms.map(|rms| ("deviation rms".into(), um(rms))));
        let proofs = round.correction.iter().flat_map(|correction| correction.proof.values());
        let after = proofs.map(|proof| proof.after.rms_um).reduce(f64::max);
        figures.extend(after.map(|rms| ("after the correction, by the referee".into(), um(rms))));
    }
    figures.extend(result.tolerance_class.map(|class| ("class asked for".into(), class.to_string())));
    if !result.classes.is_empty() {
        figures.push(("class of ISO 17485".into(), reached(result)));
    }
    figures
}

fn reached(result: &BevelInspectionResult) -> String {
    class_in_words(result.class)
}

fn first_page(result: &BevelInspectionResult) -> Result<FirstPage, ChartError> {
    let um = |name: String, value: f64| Quantity::rounded(&name, "", value, 3, "µm");
    let mut correction = Vec::new();
    let mut teeth = Vec::new();
    if let Some(round) = result.rounds.last() {
        for (flank, of) in &round.flanks {
            correction.push(um(format!("deviation rms, {flank}"), of.measured.rms_um));
            let count = i64::try_from(of.teeth).unwrap_or(i64::MAX);
            teeth.push(Quantity::count(&format!("teeth measured, {flank}"), "", count));
        }
        let proofs = round.correction.iter().flat_map(|correction| &correction.proof);
        correction.extend(
            proofs.map(|(flank, proof)| um(format!("after the correction, {flank}"), proof.after.rms_um)),
        );
    }
    let [rows, columns] = result.grid;
    teeth.push(Quantity::shown("points of the grid", "", format!("{rows} x {columns}"), ""));
    let tolerance = format_significant(result.tolerance_um, 4);
    teeth.push(Quantity::shown("tolerance of the job", "", tolerance, "µm"));
    Ok(FirstPage {
        scope: result.verdict.scope_in_short(),
        picture: last_deviation(&result.rounds)?,
        values: pitch::classes(result),
        sheets: vec![
            pitch::sheet(result),
            Sheet::new("Measurement", teeth),
            Sheet::new("Correction", correction),
        ],
    })
}

/// Sections without data are left out.
fn sections(result: &BevelInspectionResult) -> Result<Vec<Section>, ChartError> {
    let mut sections = vec![
        Section::new("scope-of-the-verdict", "Scope of the verdict", scope_blocks(&result.verdict)),
        Section::new(
            "measured-against-the-target",
            "Measured against the target",
            against_target(INTRODUCTION, &result.rounds)?,
        ),
    ];
    for round in &result.rounds {
        let title = "What is systematic, and what removes it";
        sections.push(Section::new("round-1", title, round_blocks(round)?));
        sections.push(Section::new("stages", "Target, process and part", stages(round)?));
    }
    sections.push(Section::new("pitch", "Pitch and run-out", pitch::blocks(result)?));
    sections.retain(|section| !section.blocks.is_empty());
    Ok(sections)
}
