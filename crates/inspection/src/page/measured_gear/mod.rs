//! The page of a measured gear, composed from its result: its flank beside the target and the process, what all teeth share, the
//! correction and its proof, and the evaluation to ISO 1328-1. Timing stays out of it, so that the same measurement gives the same
//! bytes. The inspection sheet is another page.

mod against_target;
mod answer;
mod axes;
mod correction;
mod evaluation;
mod first_page;
mod flanks;
mod pictures;
mod settings;
mod tests_table;

pub(super) use against_target::with_introduction as against_target;
pub(super) use pictures::{last_deviation, stages};

use crate::workflow::{GearInspection, GearInspectionResult, LinesResult, RoundResult};
use generating_grinding::job::Job;
use job::ProcessJob;
use job::tables::{JobInfo, ProcessName};
use report::charts::ChartError;
use report::head::scope_blocks;
use report::{Block, Column, PlanReport, Section, Table, html};
use run::{Answer, JobTitle, report_head};

/// The report of a measured gear as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite, or lists of different length.
pub fn html_page(found: &GearInspection, files: &[(String, &'static str)]) -> Result<String, ChartError> {
    Ok(html::render(&page(found, files)?))
}

/// The same as data.
///
/// # Errors
/// As [`html_page`].
pub fn page(found: &GearInspection, files: &[(String, &'static str)]) -> Result<PlanReport, ChartError> {
    let result = &found.result;
    let sections = sections(result)?;
    let info = title(found);
    let answer = Answer {
        process: "Inspection of a gear",
        status: result.verdict.status(),
        reason: result.verdict.reason(),
        warnings: &result.warnings,
        headline: answer::headline(result),
        figures: answer::figures(result),
        first_page: first_page::first_page(found)?,
    };
    Ok(report_head(JobTitle::new(&info, found.language), answer, files).page(sections))
}

/// Title block of the job, completed by what the measured files tell; that of the files for a measurement by itself.
fn title(found: &GearInspection) -> JobInfo {
    let result = &found.result;
    let told = |key: &str| result.head.get(key).cloned();
    let asked = found.job.clone().unwrap_or_else(|| JobInfo::named(&result.job, ProcessName::new(Job::NAME)));
    JobInfo {
        name: result.job.clone(),
        description: told("name").or(asked.description),
        part_number: told("part").or(asked.part_number),
        drawing_number: told("drawing").or(asked.drawing_number),
        date: told("date").or(asked.date),
        // The machine that measured, not the one that made the gear.
        machine_name: told("machine"),
        ..asked
    }
}

/// Sections without data are left out.
fn sections(result: &GearInspectionResult) -> Result<Vec<Section>, ChartError> {
    let rounds = &result.rounds;
    let mut sections = vec![
        Section::new("scope-of-the-verdict", "Scope of the verdict", scope_blocks(&result.verdict)),
        Section::new(
            "measured-against-the-target",
            "Measured against the target",
            against_target::blocks(rounds)?,
        ),
    ];
    for round in rounds {
        let title = match rounds.len() {
            1 => "What is systematic, and what removes it".to_owned(),
            _ => format!("Round {}: what is systematic, and what removes it", round.round),
        };
        sections.push(Section::new(format!("round-{}", round.round), title, round_blocks(round)?));
    }
    if let Some(first) = rounds.first() {
        let title = if rounds.len() > 1 {
            "Target, process and part of the first round"
        } else {
            "Target, process and part"
        };
        sections.push(Section::new("stages", title, pictures::stages(first)?));
    }
    sections.push(Section::new("evaluation", "Evaluation to ISO 1328-1", evaluation::blocks(result)?));
    let lines = &result.not_understood;
    let not_understood = (!lines.is_empty()).then(|| Block::Table(lines_table(lines)));
    sections.push(Section::new("not-understood", "Not understood", not_understood.into_iter().collect()));
    sections.retain(|section| !section.blocks.is_empty());
    Ok(sections)
}

pub(super) fn round_blocks(round: &RoundResult) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    if !round.characteristics.is_empty() {
        blocks.push(Block::Table(tests_table::table(&round.characteristics)?));
    }
    if let Some(correction) = &round.correction {
        let ends = round.flanks.values().flat_map(|flank| &flank.z_mm);
        let half_mm = ends.fold(0.0, |most: f64, z| most.max(z.abs()));
        blocks.extend(correction::blocks(correction, half_mm)?);
    }
    if let Some(why) = &round.no_correction {
        blocks.push(Block::Paragraph(format!("No correction: {why}.")));
    }
    blocks.extend(axes::blocks(&round.axes, round.axes_together.as_ref(), &round.axes_not_asked)?);
    Ok(blocks)
}

fn lines_table(lines: &[LinesResult]) -> Table {
    let row = |of: &LinesResult| vec![of.file.clone(), of.line.to_string(), of.text.clone()];
    Table {
        caption: String::new(),
        columns: vec![Column::name("File"), Column::number("Line", ""), Column::text("Beginning")],
        rows: lines.iter().map(row).collect(),
        note: "Nothing of these lines was used.".into(),
    }
}
