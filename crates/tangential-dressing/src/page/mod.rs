//! The report of a run of tangential dressing, composed from its results: what every page on ground flanks shows, and variables, their
//! choice and fit, methods, radial feed, sensitivities. Timing stays out of it, so that the same job gives the same bytes.

mod first_page;
mod passes;
mod quantities;
mod radial_feed;
mod sensitivities;
mod tools;

use crate::TangentialFlank;
use crate::workflow::{TangentialOutcome, TangentialRun};
use contact::Measure;
use foundation::geometry::{Flank, Sides};
use generating_grinding::page::{
    DressingCurves, GrindingPage, ShownFlank, TOPOGRAPHIES, VERIFICATION, control_blocks, gear_quantities,
    programs_blocks, referee_stages, verification_blocks,
};
use generating_grinding::workflow::tables::ROWS;
use quantities::{amounts, dresser_quantities, settings_quantities, worm_lengths, worm_quantities};
use radial_feed::Compared;
use report::charts::{ChartError, format_significant};
use report::{Block, PlanReport, Section, Table, html};
use run::{CharacteristicsUm, GrindingMotion, JobTitle};

/// Id of the section of variables, which belongs to the settings.
const VARIABLES: &str = "variables";

/// The report of a run as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(
    outcome: &TangentialOutcome,
    files: &[(String, &'static str)],
) -> Result<String, ChartError> {
    Ok(html::render(&page(outcome, files)?))
}

/// The same as data.
///
/// # Errors
/// As [`html_page`].
pub fn page(outcome: &TangentialOutcome, files: &[(String, &'static str)]) -> Result<PlanReport, ChartError> {
    let mut page = common(outcome, files)?;
    let own = own(outcome)?;
    // After the settings, before the pictures of the flank.
    let (variables, others): (Vec<Section>, Vec<Section>) =
        own.into_iter().partition(|section| section.id == VARIABLES);
    page.insert_before(TOPOGRAPHIES, variables);
    page.insert_before(VERIFICATION, others);
    Ok(page)
}

/// What every grinding report shows.
fn common(outcome: &TangentialOutcome, files: &[(String, &'static str)]) -> Result<PlanReport, ChartError> {
    let TangentialOutcome { result, prepared, .. } = outcome;
    let model = &prepared.model;
    let input = model.input();
    let flanks = Sides::try_from_fn(|flank| {
        let (Some(f), Some(run)) = (result.flanks.get(flank.name()), &outcome.flanks[flank]) else {
            return Ok(None);
        };
        let cos_b = model.pair.work.flank(flank).base_helix_angle.cos();
        let amounts = amounts(&prepared.drawn, flank, f);
        ShownFlank::of(amounts, &f.flank, CharacteristicsUm::of(&run.planned, cos_b)).map(Some)
    })?;
    let ground = |flank: Flank| {
        let run = outcome.flanks[flank].as_ref()?;
        Some((TangentialFlank::new(model, flank, &run.pass, &run.settings, Measure::Ray), run))
    };
    // Flanks of one pass share the motion.
    let shared = shares_a_pass(outcome);
    let of_flanks = Flank::BOTH.into_iter().filter_map(ground).map(|(flank, run)| {
        let name = if shared { "both flanks".to_owned() } else { format!("{} flank", flank.flank()) };
        GrindingMotion::over(&name, flank.motion(), run.strokes.feed, ROWS)
    });
    let page = GrindingPage {
        title: JobTitle::new(&prepared.info, prepared.output.language).on(prepared.machine.as_ref()),
        process: "Tangential dressing",
        verdict: &result.verdict,
        tolerance_um: result.tolerance_um,
        class: result.drawing.tolerances,
        flanks,
        sheets: first_page::sheets(outcome),
        gear: gear_quantities(
            &input.gear,
            &prepared.blank,
            [2.0 * input.radii[0], 2.0 * input.radii[1], input.faces[0], input.faces[1]],
        ),
        worm: worm_quantities(prepared),
        dresser: dresser_quantities(outcome),
        settings: settings_quantities(outcome),
        ratio: None,
        occupation: None,
        sections: &[],
        grinding_motions: of_flanks.take(if shared { 1 } else { 2 }).collect(),
        dressing: Sides::from_fn(|flank| {
            let (ground, run) = ground(flank)?;
            let (motion, [from, to]) = ground.dressing_motion(run.strokes.dressing).ok()?;
            Some(DressingCurves::over(&motion, (from, to)))
        }),
        conditions: Vec::new(),
        measured_worm: Vec::new(),
        strokes: Sides { left: &[], right: &[] },
        control: match &result.control {
            None => Vec::new(),
            Some(control) => control_blocks(control, |flank| {
                let f = &result.flanks.get(flank.name())?.flank;
                Some([f.w_mm.clone(), f.z_mm.clone()])
            })?,
        },
        removal: Vec::new(),
        programs: outcome.programs.as_ref().map_or(Ok(Vec::new()), programs_blocks)?,
        warnings: &result.warnings,
        changes: &[],
        deviated: Vec::new(),
        verification: verification(outcome),
        convergence: None,
        files,
    };
    page.to_page()
}

fn verification(outcome: &TangentialOutcome) -> Vec<Block> {
    let mut stages = Vec::new();
    let mut samples = Vec::new();
    for (flank, run) in outcome.flanks.iter() {
        let Some(TangentialRun { refereed, sample_difference, .. }) = run else { continue };
        stages.extend(referee_stages(flank, &refereed.verdict));
        samples.push(format!("{flank} flank {} µm", format_significant(sample_difference * 1e3, 2)));
    }
    let sample = format!(
        "On a sample of points the rays of the gear were shortened without a surface between the stages: wherever a ray looked for the \
         worm, the dresser itself was asked over its whole stroke. Planned flank and rays differ there by at most: {}.",
        samples.join(", ")
    );
    verification_blocks([sample], &stages)
}

/// What tangential dressing adds, in reading order.
fn own(outcome: &TangentialOutcome) -> Result<Vec<Section>, ChartError> {
    let result = &outcome.result;
    let fits = result.passes.iter().map(passes::fit).collect::<Result<Vec<_>, ChartError>>()?;
    let remark = if shares_a_pass(outcome) {
        "Both flanks are ground in one pass with the same motions. A half-turn about the common perpendicular exchanges the flanks: even \
         powers of F_z, dX, F_C and F_T then act with opposite signs on them and cannot crown both; what crowns both are the distances \
         dA and dist together with odd powers of dX and F_C."
    } else {
        "Every flank has motions of its own, in a pass of its own: either the worm is dressed again before each pass, or it has a \
         dressed zone for each flank, side by side."
    };
    let lengths = vec![
        Block::Paragraph(remark.to_owned()),
        Block::Table(Table::of_quantities("", &worm_lengths(outcome))),
    ];
    let all = [
        (
            VARIABLES,
            "Variables of dressing and grinding",
            result.passes.iter().flat_map(passes::variables).collect(),
        ),
        ("how-the-values-were-found", "How the values were found", fits.concat()),
        ("worm-and-dresser", "Dresser profile and worm topography", tools::blocks(outcome)?),
        ("radial-feed", "Beside it: crowning by radial feed", radial_feed::blocks(&Compared::of(outcome))?),
        ("worm-length-and-passes", "Worm length and passes", lengths),
        ("sensitivities", "Sensitivity topographies", sensitivities::blocks(&result.sensitivities)?),
    ];
    let sections = all.into_iter().filter(|(.., blocks): &(_, _, Vec<Block>)| !blocks.is_empty());
    Ok(sections.map(|(id, title, blocks)| Section::new(id, title, blocks)).collect())
}

fn shares_a_pass(outcome: &TangentialOutcome) -> bool {
    outcome.flanks.iter().any(|(_, run)| run.as_ref().is_some_and(|r| r.pass.len() > 1))
}

fn heading(flanks: &[&str]) -> String {
    match flanks {
        [one] => format!("{}{} flank", one[..1].to_uppercase(), &one[1..]),
        _ => "Both flanks".to_owned(),
    }
}
