//! The page of the electronic gearbox, composed from its result: counters, errors beside their bounds, budget, servo, set-ups to choose
//! from. Timing stays out of it, so that the same job gives the same bytes.

mod additions;
mod answer;
mod bands;
mod budget;
mod errors;
mod first_page;
mod quantities;
mod servo;
mod set_up_chart;
mod set_ups;

use crate::workflow::GearboxOutcome;
use quantities::{counters, coupling, settings};
use report::charts::ChartError;
use report::{Block, PlanReport, Section, Table, html};
use run::{Answer, JobTitle, report_head};

/// The report of a run as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(outcome: &GearboxOutcome, files: &[(String, &'static str)]) -> Result<String, ChartError> {
    Ok(html::render(&page(outcome, files)?))
}

/// The same as data.
///
/// # Errors
/// As [`html_page`].
pub fn page(outcome: &GearboxOutcome, files: &[(String, &'static str)]) -> Result<PlanReport, ChartError> {
    let result = &outcome.result;
    let sections = sections(outcome)?;
    let answer = Answer {
        process: "Electronic gearbox",
        status: result.verdict.status(),
        reason: result.verdict.reason(),
        warnings: &result.warnings,
        headline: answer::headline(result),
        figures: answer::figures(result),
        first_page: first_page::first_page(result, &sections),
    };
    let title = JobTitle::new(&outcome.prepared.info, outcome.prepared.language);
    let head = report_head(title, answer, files);
    Ok(head.page(sections))
}

fn sections(outcome: &GearboxOutcome) -> Result<Vec<Section>, ChartError> {
    let result = &outcome.result;
    let mut sections = Vec::new();
    if let Some(explored) = &result.explore {
        let blocks = set_ups::blocks(explored)?;
        sections.push(Section::new("set-ups-to-choose-from", "Set-ups to choose from", blocks));
    }
    sections.push(Section::new("errors", "Errors", errors::blocks(result, &outcome.run.bins)?));
    if let Some(budget) = &result.budget {
        let measuring_um = result.errors.as_ref().map(|errors| errors.sum_flank_um);
        let table = budget::table(budget, result.coupling.flank_um_per_feed_um, measuring_um);
        sections.push(Section::new("error-budget", "Error budget", vec![Block::Table(table)]));
    }
    sections.extend(additions::sections(outcome)?);
    if let (Some(servo), Some(record)) = (&result.servo, &outcome.servo) {
        let blocks = servo::blocks(servo, record, result.coupling.flank_um_per_rad)?;
        sections.push(Section::new(
            "servo-of-the-workpiece-spindle",
            "Servo of the workpiece spindle",
            blocks,
        ));
    }
    let sheets = [
        ("Pulses", counters(&result.pulses)),
        ("Coupling", coupling(&result.coupling)),
        ("Scale, interpolator, encoder", settings(&result.settings)),
    ];
    let tables = sheets.map(|(caption, quantities)| Table::of_quantities(caption, &quantities));
    sections.push(Section::new(
        "counters-and-settings",
        "Counters and settings",
        vec![Block::Tables(tables.to_vec())],
    ));
    Ok(sections)
}
