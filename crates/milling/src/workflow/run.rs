//! `plan`: from a checked job to the plan of a space, its flanks under the referee, and the verdict.

use super::engagement::engagement;
use super::finding::failure;
use super::flank_result::flank_result;
use super::judge::{Judged, verdict};
use super::mate::{self, MateOutcome};
use super::orientation::{ComparedOrientations, orientations};
use super::part_rays::{Closeness, PartSurface, part_rays};
use super::plan_remarks::remarks_on_plan;
use super::prepare::{MillingBodies, PreparedMilling, prepare_milling};
use super::referee::{RefereedFlank, mill_paths, referee, swept};
use super::result::{CutterResult, FlankResult, MillingResult, OperationResult};
use super::root::{RefereedRoot, referee_root};
use super::stock::standing_stock;
use super::texts::{MillingTexts, texts};
use super::tool_result::{clocking, tools, work_offset};
use super::whole_part::WholePart;
use crate::job::LoadedMillingJob;
use crate::{MillingPlan, Operation, OperationKind, plan_all};
use foundation::numerics::Progress;
use run::{Release, RunFailure};
use std::collections::BTreeMap;
use std::time::Instant;

/// Everything that a run produces.
#[derive(Clone, Debug)]
pub struct MillingOutcome {
    /// The document of `result.json`.
    pub result: MillingResult,
    /// Bodies, tools, machine and outputs.
    pub prepared: PreparedMilling,
    /// The plan of one space.
    pub plan: MillingPlan,
    /// The flanks under the referee.
    pub flanks: Vec<RefereedFlank>,
    /// The root under the referee, part by part; empty without a pass of the root.
    pub root: Vec<RefereedRoot>,
    /// Contact with the mate, if the job has one.
    pub mate: Option<MateOutcome>,
    /// The rotary motion beside that of other systems, flank by flank; empty where the job does not want it.
    pub orientations: Vec<ComparedOrientations>,
    /// Programs and cutter locations.
    pub texts: MillingTexts,
}

/// Plans a job, has the referee judge it, and says whether the target is met.
///
/// # Errors
/// [`RunFailure`]: bad input, or a limit of the bodies.
pub fn run_milling(loaded: &LoadedMillingJob, progress: &dyn Progress) -> Result<MillingOutcome, RunFailure> {
    let begun = Instant::now();
    let prepared = prepare_milling(loaded)?.on_machine(loaded)?;
    let timing = BTreeMap::from([("prepare", begun.elapsed().as_secs_f64())]);
    planned(prepared, timing, progress)
}

fn planned(
    prepared: PreparedMilling,
    mut timing: BTreeMap<&'static str, f64>,
    progress: &dyn Progress,
) -> Result<MillingOutcome, RunFailure> {
    let bodies = &prepared.bodies;
    let begun = Instant::now();
    let mate = prepared.mate.as_ref().map(|pair| mate::roll(pair, bodies)).transpose()?;
    if mate.is_some() {
        timing.insert("mate", begun.elapsed().as_secs_f64());
    }

    let begun = Instant::now();
    progress.start("plan", 1);
    let plan = plan_all(&bodies.parts, &bodies.options).map_err(|error| failure(&error))?;
    progress.advance(1);
    progress.finish();
    timing.insert("plan", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let flanks = referee(bodies, &plan, prepared.rays, progress)?;
    let root = referee_root(bodies, &plan, prepared.rays[1], progress)?;
    let stock = standing_stock(bodies, prepared.pre_stock.as_ref(), &plan, &flanks, progress)?;
    let part = beside(bodies, &plan, prepared.tolerance(), progress)?;
    timing.insert("referee", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let mate = match (mate, &prepared.mate) {
        (Some(mate), Some(pair)) => Some(mate.with_milled(pair, bodies, &plan)?),
        (mate, _) => mate,
    };
    if mate.is_some() {
        timing.insert("milled-mate", begun.elapsed().as_secs_f64());
    }

    let begun = Instant::now();
    let orientations = orientations(&prepared, &plan)?;
    timing.insert("orientations", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let texts = texts(&prepared, &plan, &flanks, progress)?;
    timing.insert("programs", begun.elapsed().as_secs_f64());

    let mut results: BTreeMap<&'static str, FlankResult> = plan
        .flanks
        .iter()
        .zip(&flanks)
        .map(|(plan, refereed)| (plan.side.name(), flank_result(bodies, plan, refereed)))
        .collect();
    for compared in &orientations {
        if let Some(flank) = results.get_mut(compared.side.name()) {
            flank.orientation = Some(compared.result.clone());
        }
    }
    let tolerance_um = prepared.tolerance_um;
    let lacking = mate.as_ref().and_then(|mate| mate.remark.as_ref());
    let found = Judged { bodies, flanks: &results, root: &root, part: &part, mate: lacking, tolerance_um };
    let mut verdict = verdict(&found);
    stock.iter().for_each(|of| of.judge(&mut verdict));
    if let Some((_, measures)) = &prepared.teeth {
        measures.leave_class(&mut verdict);
    }
    if let Some(class) = prepared.bevel_class {
        let why = "a plan has no pitches and no run-out; `flankwright inspect` judges a measured gear by it";
        verdict.leave(format!("class {class} of ISO 17485"), why);
    }
    texts.judge(&mut verdict);
    let mut warnings = prepared.warnings.clone();
    warnings.extend(lacking.cloned());
    warnings.extend(remarks_on_plan(&plan, &flanks));
    if texts.programs.is_some() || texts.locations.is_some() {
        warnings.extend(Release::of(&verdict, prepared.output.programs_of_missed).remark(&verdict));
    }
    let operation = |operation| operation_result(&prepared, &plan, operation);
    let result = MillingResult {
        job: prepared.info.name.clone(),
        process: "five-axis-milling",
        version: env!("CARGO_PKG_VERSION"),
        verdict,
        tolerance_um,
        warnings,
        drawing: prepared.teeth.as_ref().map(|(gear, measures)| measures.result(gear)),
        spaces: [bodies.spaces, bodies.milled],
        cutter: CutterResult::new(bodies.options.cutter.shape(), bodies.options.cutter.cutting_length()),
        tools: tools(&prepared, &plan),
        work_offset: work_offset(&prepared, texts.programs.as_ref()),
        operations: plan.operations.iter().map(operation).collect(),
        flanks: results,
        stock: stock.iter().map(|of| (of.side.name(), of.result())).collect(),
        root: root.iter().map(|part| (part.name(), part.result())).collect(),
        mate: mate.as_ref().map(|mate| mate.result.clone()),
        programs: texts.results(prepared.machine.as_ref()),
        clocking_programs: clocking(&texts.cycles),
        timing_s: timing,
    };
    Ok(MillingOutcome { result, prepared, plan, flanks, root, mate, orientations, texts })
}

/// Everything of the part beside the flanks that are milled in a space, under the paths of that space: what they do not enter there
/// no path of another space enters.
fn beside(
    bodies: &MillingBodies,
    plan: &MillingPlan,
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<WholePart, RunFailure> {
    let mut rays = part_rays(bodies, plan, Closeness::Coarse, tolerance)?;
    let own = |surface: PartSurface| plan.flanks.iter().any(|made| PartSurface::Flank(made.side) == surface);
    rays.retain(|at| at.space > 0 || !own(at.surface));
    rays.iter_mut().for_each(|at| at.stock = None);
    let (cutters, paths) = mill_paths(bodies, plan);
    // What is above the surface does not matter.
    WholePart::of(&swept(&cutters, &paths, tolerance)?, &rays, tolerance, progress)
}

fn operation_result(
    prepared: &PreparedMilling,
    plan: &MillingPlan,
    operation: &Operation,
) -> OperationResult {
    let tool = prepared.technology.tool_of(operation.kind);
    let diameter = 2.0 * prepared.bodies.options.cutter_of(operation.kind).shape().radius();
    let clears = operation.kind == OperationKind::Roughing;
    let way = |path: &crate::CutterPath| {
        path.places.windows(2).map(|pair| (pair[1].tip - pair[0].tip).norm()).sum::<f64>()
    };
    OperationResult {
        name: operation.kind.to_string(),
        paths: operation.paths.len(),
        places: operation.paths.iter().map(|path| path.places.len()).sum(),
        way_mm: operation.paths.iter().map(way).sum(),
        engagement: clears.then(|| engagement(&plan.layers, diameter, &tool)).flatten(),
        feed_per_tooth_mm: tool.edges.map(|edges| tool.feed / (tool.spindle_rpm * f64::from(edges))),
    }
}
