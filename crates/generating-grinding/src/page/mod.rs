//! The report of a run, composed from its results. Timing stays out of it, so that the same job gives the same bytes.

mod changes;
mod composition;
mod conditions;
mod content;
mod control;
mod deviated;
mod drawn_values;
mod first_page;
mod limit_words;
mod measured_worm;
mod motions;
mod programs;
mod quantities;
mod ratio;
mod removal;
mod strokes;
mod summary;
mod target_amounts;
mod traces;
mod verification;
mod wanted_worm;

pub use composition::{TOPOGRAPHIES, VERIFICATION};
pub use content::{GrindingPage, ShownFlank};
pub use control::control_blocks;
pub use first_page::{MachineSettings, times};
pub use measured_worm::axis_columns;
pub use motions::DressingCurves;
pub use programs::programs_blocks;
pub use quantities::gear_quantities;
pub use target_amounts::{TargetAmount, target_amounts};
pub use verification::{RefereeStage, referee_stages, verification_blocks};

use crate::workflow::executed_strokes::ExecutedStroke;
use crate::workflow::execution::ExecutedFlank;
use crate::workflow::run::Outcome;
use crate::workflow::tables::ROWS;
use foundation::geometry::{Flank, Sides};
use quantities::{settings_quantities, tool_quantities};
use report::charts::ChartError;
use report::{PlanReport, html};
use run::{CharacteristicsUm, GrindingMotion, JobTitle};
use verification::verification;

/// The report of a run as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(outcome: &Outcome, files: &[(String, &'static str)]) -> Result<String, ChartError> {
    Ok(html::render(&page(outcome, files)?))
}

/// The same as data.
///
/// # Errors
/// As [`html_page`].
pub fn page(outcome: &Outcome, files: &[(String, &'static str)]) -> Result<PlanReport, ChartError> {
    let Outcome { result, prepared, execution, .. } = outcome;
    let flanks = Sides::try_from_fn(|flank| -> Result<_, ChartError> {
        let (Some(f), Some(executed)) = (result.flanks.get(flank.name()), &execution.flanks[flank]) else {
            return Ok(None);
        };
        let cos_b = prepared.setup.lines[flank].cos_b2;
        let amounts = target_amounts(&prepared.drawn, flank, &f.target_characteristics);
        ShownFlank::of(amounts, f, CharacteristicsUm::of(&executed.planned, cos_b)).map(Some)
    })?;
    let (worm, dresser) = tool_quantities(outcome);
    let input = &prepared.setup.input;
    let strokes = |flank: Flank| -> &[ExecutedStroke] {
        let strokes = execution.flanks[flank].as_ref().and_then(ExecutedFlank::strokes);
        strokes.map_or(&[], |executed| &executed.strokes)
    };
    let page = GrindingPage {
        title: JobTitle::new(&prepared.info, prepared.output.language).on(prepared.machine.as_ref()),
        process: "Generating grinding",
        verdict: &result.verdict,
        tolerance_um: result.tolerance_um,
        class: result.drawing.tolerances,
        flanks,
        sheets: first_page::sheets(outcome),
        gear: gear_quantities(&input.gear, &input.blank, input.evaluation),
        worm,
        dresser,
        settings: settings_quantities(outcome),
        ratio: outcome.plan.as_ref().map(|_| &result.settings),
        occupation: result.settings.partition.as_ref().map(|partition| partition.chart()),
        sections: &outcome.sections,
        grinding_motions: vec![GrindingMotion::over(
            "both flanks",
            &execution.motion,
            execution.feed_range,
            ROWS,
        )],
        dressing: Sides::from_fn(|flank| {
            let dressing = execution.flanks[flank].as_ref()?.dressing()?;
            Some(DressingCurves::over(&dressing.motion, dressing.corrections[0].interval()))
        }),
        conditions: conditions::conditions(&result.settings.dressing_conditions)?,
        strokes: Sides::from_fn(strokes),
        control: match &result.control {
            None => Vec::new(),
            Some(control) => control_blocks(control, |flank| {
                let f = result.flanks.get(flank.name())?;
                Some([f.w_mm.clone(), f.z_mm.clone()])
            })?,
        },
        removal: result.removal.as_ref().map_or(Ok(Vec::new()), removal::removal)?,
        programs: outcome.programs.as_ref().map_or(Ok(Vec::new()), programs_blocks)?,
        warnings: &result.warnings,
        changes: &result.changes,
        deviated: result
            .deviated
            .as_ref()
            .map_or(Ok(Vec::new()), |of| deviated::deviated(of, &result.flanks))?,
        measured_worm: measured_worm::measured_worm(result.measured_worm.as_ref())?,
        verification: verification(outcome),
        convergence: Some(&result.ideal_error_by_round_um),
        files,
    };
    let mut page = page.to_page()?;
    page.insert_before(TOPOGRAPHIES, wanted_worm::section(&result.worm)?);
    Ok(page)
}
