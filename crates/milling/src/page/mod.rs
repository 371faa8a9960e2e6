//! The report of a run, composed from its results and bodies: each section has a file with its tables and figures. Timing stays out of
//! it, so that the same job gives the same bytes.

mod banner;
mod clocking;
mod cutter_words;
mod density;
mod deviations;
mod first_page;
mod flanks;
mod mate;
mod operations;
mod orientation;
mod outline;
mod programs;
mod root;
mod rows;
mod shown_flank;
mod space;
mod stock;
mod tools;
mod wear;

use crate::workflow::MillingOutcome;
use report::charts::ChartError;
use report::head::scope_blocks;
use report::{Block, PlanReport, Section, html};
use run::{JobTitle, report_head};
use shown_flank::ShownFlank;

/// The report of a run as a self-contained HTML page; a section without blocks leaves no trace on it.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(outcome: &MillingOutcome, files: &[(String, &'static str)]) -> Result<String, ChartError> {
    Ok(html::render(&page(outcome, files)?))
}

/// The same as data.
///
/// # Errors
/// As [`html_page`].
pub fn page(outcome: &MillingOutcome, files: &[(String, &'static str)]) -> Result<PlanReport, ChartError> {
    let MillingOutcome { result, prepared, plan, .. } = outcome;
    let shown = ShownFlank::of_run(plan, result);
    let flanks = vec![Block::Table(flanks::table(&shown, result.tolerance_um))];
    let sections = vec![
        Section::new("flanks", "Flanks", flanks),
        Section::new("scope-of-the-verdict", "Scope of the verdict", scope_blocks(&result.verdict)),
        Section::new("workpiece-cutter-and-paths", "Workpiece, cutter and paths", space::blocks(outcome)?),
        Section::new("deviations", "Deviations", deviations::blocks(&shown)?),
        Section::new("rows", "Rows", rows::blocks(&shown)?),
        Section::new("wear-of-the-edge", "Wear of the edge", wear::blocks(&prepared.bodies, &shown)?),
        Section::new("density", "Density", density::blocks(&prepared.bodies.options.lines, &shown)),
        Section::new("root", "Root", root::blocks(outcome)?),
        Section::new("contact-with-the-mate", "Contact with the mate", mate::blocks(outcome.mate.as_ref())?),
        Section::new("stock-before-finishing", "Stock before finishing", stock::blocks(result)),
        Section::new("tools", "Tools", tools::blocks(result)),
        Section::new("operations", "Operations", vec![Block::Table(operations::table(outcome))]),
        Section::new(
            "orientation-of-the-cutter",
            "Orientation of the cutter",
            orientation::blocks(&outcome.orientations)?,
        ),
        Section::new("clocking-of-the-workpiece", "Clocking of the workpiece", clocking::blocks(result)),
        Section::new("programs", "Programs", programs::blocks(outcome)?),
    ];
    let title = JobTitle::new(&prepared.info, prepared.output.language).on(prepared.machine.as_ref());
    let answer = banner::answer(result, first_page::first_page(outcome, &shown, &sections));
    Ok(report_head(title, answer, files).page(sections))
}
