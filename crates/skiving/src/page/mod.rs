//! The report of measuring a power-skiving tool, composed from its results and bodies: each section has a file with its tables and
//! figures. Teeth count from 0, tracks from 1. Timing stays out of it, so that the same job gives the same bytes.

mod angles;
mod banner;
mod conventional;
mod corrections;
mod edge_section;
mod first_page;
mod history;
mod measured;
mod monte_carlo;
mod pitch;
mod poses;
mod probe;
mod profile;
mod programs;
mod regrinding;
mod runout;
mod sheets;
mod spread;
mod strip;
mod tooth;

use crate::workflow::SkivingOutcome;
use report::charts::ChartError;
use report::head::scope_blocks;
use report::{Block, PlanReport, Section, html};
use run::{JobTitle, report_head};

/// The report of a run as a self-contained HTML page; a section without blocks leaves no trace on it.
///
/// # Errors
/// A number that is not finite, or lists of different length.
pub fn html_page(outcome: &SkivingOutcome, files: &[(String, &'static str)]) -> Result<String, ChartError> {
    Ok(html::render(&page(outcome, files)?))
}

/// The same as data.
///
/// # Errors
/// As [`html_page`].
pub fn page(outcome: &SkivingOutcome, files: &[(String, &'static str)]) -> Result<PlanReport, ChartError> {
    let (result, prepared) = (&outcome.result, &outcome.prepared);
    let bodies = &prepared.bodies;
    let mut tooth = vec![tooth::block(bodies)?];
    tooth.extend(edge_section::blocks(bodies)?);
    let [concentricity, pitch] = pitch::blocks(outcome)?;
    let sections = vec![
        Section::new("scope-of-the-verdict", "Scope of the verdict", scope_blocks(&result.verdict)),
        Section::new("measured-deviations", "Measured deviations", measured::blocks(outcome)?),
        Section::new("angles-of-the-edges", "Angles of the edges", angles::blocks(outcome)?),
        Section::new("signal-over-one-turn", "Signal over one turn", strip::blocks(outcome)?),
        Section::new("concentricity", "Concentricity", concentricity),
        Section::new("pitch", "Pitch", pitch),
        Section::new("tooth-and-contact-points", "Tooth and contact points", tooth),
        Section::new("measuring-poses", "Measuring poses", poses::blocks(&result.tracks)?),
        Section::new("profile-of-the-workpiece", "Profile of the workpiece", profile::blocks(result)?),
        Section::new("corrections", "Corrections", corrections::blocks(outcome)?),
        Section::new("measured-workpiece", "Measured workpiece", probe::blocks(result.probe.as_ref())?),
        Section::new(
            "run-out-correction",
            "Correction of the run-out",
            runout::blocks(result.runout.as_ref())?,
        ),
        Section::new(
            "comparison-with-the-conventional-method",
            "Comparison with the conventional method",
            conventional::blocks(bodies, &result.conventional)?,
        )
        .in_appendix(),
        Section::new("history", "History", history::blocks(outcome)?),
        Section::new("monte-carlo", "Monte Carlo", monte_carlo::blocks(result.monte_carlo.as_ref())?)
            .in_appendix(),
        Section::new(
            "tool-workpiece-and-measurement",
            "Tool, workpiece and measurement",
            vec![Block::Tables(sheets::tables(prepared, result))],
        ),
        Section::new("programs", "Programs", programs::blocks(&result.programs)?),
    ];
    let title = JobTitle::new(&prepared.info, prepared.output.language).on(prepared.machine.as_ref());
    let answer = banner::answer(result, first_page::first_page(outcome, &sections));
    Ok(report_head(title, answer, files).page(sections))
}
