//! `plan`: from a checked job to the plan of a space, its flanks under the referee, and the verdict.

use super::bodies::{MillingBodies, prepare_milling};
use super::finding::failure;
use super::judge::{Judged, verdict};
use super::mate::{self, MateOutcome};
use super::of_job::{MillingTexts, purpose_and_feed, texts};
use super::orientation::{ComparedOrientations, orientations};
use super::part_rays::{Closeness, PartSurface, part_rays};
use super::referee::{RefereedFlank, mill_paths, referee, swept};
use super::result::{
    CutterResult, DistancesResult, FlankResult, MillingResult, OperationResult, OutOfReachResult, RootResult,
    RowResult, WearResult,
};
use super::root::{RefereedRoot, referee_root};
use super::wear::histograms;
use super::whole_part::WholePart;
use crate::job::{LoadedMillingJob, MilledBody, MillingJob};
use crate::{FlankPlan, MillingPlan, NeighbourDistances, Operation, plan_all};
use foundation::numerics::{Progress, extremes, root_mean_square};
use referee::Unmilled;
use run::program_check::machine_of_job;
use run::{Release, RunFailure, face_names_remark, parquet_warning};
use std::collections::BTreeMap;
use std::time::Instant;
use verdict::Remark;

/// Everything that a run produces.
pub struct MillingOutcome {
    /// The document of `result.json`.
    pub result: MillingResult,
    /// What is milled, and with what.
    pub bodies: MillingBodies,
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
    let job = &loaded.job;
    let mut timing = BTreeMap::new();
    let begun = Instant::now();
    let bodies = prepare_milling(loaded)?;
    timing.insert("prepare", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let mate = mate::roll(job, &bodies)?;
    if mate.is_some() {
        timing.insert("mate", begun.elapsed().as_secs_f64());
    }

    let begun = Instant::now();
    progress.start("plan", 1);
    let made = plan_all(&bodies.parts, &bodies.options).map_err(|error| failure(&error))?;
    progress.advance(1);
    progress.finish();
    timing.insert("plan", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let counts = [job.simulation.rays_profile, job.simulation.rays_length];
    let flanks = referee(&bodies, &made, counts, progress)?;
    let root = referee_root(&bodies, &made, counts[1], progress)?;
    let part = beside(&bodies, &made, 1e-3 * job.target.tolerance_um, progress)?;
    timing.insert("referee", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let machine =
        job.machine.as_ref().map(|given| machine_of_job(&loaded.document, &given.file)).transpose()?;
    let orientations = orientations(job, machine.as_ref(), &bodies, &made)?;
    timing.insert("orientations", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let texts = texts(job, machine, &bodies, &made, &flanks, progress)?;
    timing.insert("programs", begun.elapsed().as_secs_f64());

    let units = match job.body() {
        Some(MilledBody::Bevel(_)) => ["rad", "mm"],
        Some(MilledBody::Blade(_)) => ["1", "1"],
        _ => ["mm", "mm"],
    };
    let mut results: BTreeMap<&'static str, FlankResult> = made
        .flanks
        .iter()
        .zip(&flanks)
        .map(|(plan, refereed)| (plan.side.name(), flank_result(&bodies, plan, refereed, units)))
        .collect();
    for compared in &orientations {
        if let Some(flank) = results.get_mut(compared.side.name()) {
            flank.orientation = Some(compared.result.clone());
        }
    }
    let tolerance_um = job.target.tolerance_um;
    let lacking = mate.as_ref().and_then(|mate| mate.remark.as_ref());
    let found =
        Judged { bodies: &bodies, flanks: &results, root: &root, part: &part, mate: lacking, tolerance_um };
    let mut verdict = verdict(&found);
    texts.judge(&mut verdict);
    let mut warnings = warnings(job, &made, &flanks, (&bodies, mate.as_ref()));
    if texts.programs.is_some() || texts.locations.is_some() {
        warnings.extend(Release::of(&verdict, job.output.programs_of_missed).remark(&verdict));
    }
    let result = MillingResult {
        job: job.job.name.clone(),
        process: "five-axis-milling",
        version: env!("CARGO_PKG_VERSION"),
        verdict,
        tolerance_um,
        warnings,
        spaces: [bodies.spaces, bodies.milled],
        cutter: CutterResult::new(bodies.options.cutter.shape(), bodies.options.cutter.cutting_length()),
        operations: made.operations.iter().map(|operation| operation_result(job, operation)).collect(),
        flanks: results,
        root: root.iter().map(|part| (part.name(), part.result())).collect(),
        mate: mate.as_ref().map(|mate| mate.result.clone()),
        programs: texts.results(),
        timing_s: timing,
    };
    Ok(MillingOutcome { result, bodies, plan: made, flanks, root, mate, orientations, texts })
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

fn warnings(
    job: &MillingJob,
    plan: &MillingPlan,
    refereed: &[RefereedFlank],
    (bodies, mate): (&MillingBodies, Option<&MateOutcome>),
) -> Vec<Remark> {
    let mut warnings: Vec<Remark> = parquet_warning(&job.output.tables).into_iter().collect();
    warnings.extend(face_names_remark(job.target.modifications.iter().flatten()));
    warnings.extend(bodies.unknown.iter().cloned());
    warnings.extend(mate.and_then(|mate| mate.remark.clone()));
    for (flank, rays) in plan.flanks.iter().zip(refereed) {
        if let Some(left) = out_of_reach(flank, rays) {
            warnings.push(Remark {
                code: "middle-out-of-reach",
                text: format!(
                    "{} flank: up to {:.3} mm towards the middle of the gear stay unmilled (row {}), and the root below, because the \
                     cutter meets the other half there; {} of {} rays lie there and are not judged",
                    flank.side,
                    left.length_mm,
                    left.row,
                    left.rays,
                    rays.judged.len()
                ),
                way_out: "give the halves a wider gap, or take a thinner cutter".into(),
            });
        }
        for limit in &flank.lines.dense.violated {
            warnings.push(Remark {
                code: "density-infeasible",
                text: format!(
                    "{} flank: {} = {} mm cannot be kept together with the upper limits, it is {:.4} mm",
                    flank.side, limit.name, limit.limit, limit.measured
                ),
                way_out: "relax this limit or the upper ones".into(),
            });
        }
        let limited: Vec<String> = flank
            .rows
            .iter()
            .enumerate()
            .filter(|(_, row)| row.limited)
            .map(|(n, _)| n.to_string())
            .collect();
        if !limited.is_empty() {
            warnings.push(Remark {
                code: "contact-height-limited",
                text: format!(
                    "{} flank, rows {}: contact height changed; limited by root or hub, cutting edge or opposite flank",
                    flank.side,
                    limited.join(", ")
                ),
                way_out: "see the contact heights in the result, or give others".into(),
            });
        }
    }
    warnings
}

fn operation_result(job: &MillingJob, operation: &Operation) -> OperationResult {
    let (purpose, feed) = purpose_and_feed(job, operation.kind);
    let teeth = job.cutter_for(purpose).0.teeth;
    let way = |path: &crate::CutterPath| {
        path.places.windows(2).map(|pair| (pair[1].tip - pair[0].tip).norm()).sum::<f64>()
    };
    OperationResult {
        name: operation.kind.to_string(),
        paths: operation.paths.len(),
        places: operation.paths.iter().map(|path| path.places.len()).sum(),
        way_mm: operation.paths.iter().map(way).sum(),
        feed_per_tooth_mm: teeth.map(|teeth| feed / (job.milling.spindle_rpm * f64::from(teeth))),
    }
}

/// What the other half of a double-helical gear keeps the cutter from.
fn out_of_reach(plan: &FlankPlan, refereed: &RefereedFlank) -> Option<OutOfReachResult> {
    let lengths = (0..plan.rows.len()).map(|row| (row, plan.unmilled_length(row)));
    let (row, length_mm) = lengths.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, length)| *length > 0.0)?;
    let rays = refereed.judged.iter().filter(|judged| !**judged).count();
    Some(OutOfReachResult { length_mm, row, rays })
}

fn distances(of: &NeighbourDistances) -> DistancesResult {
    DistancesResult {
        min_mm: of.least,
        max_mm: of.greatest,
        min_mean_mm: of.least_mean,
        max_mean_mm: of.greatest_mean,
    }
}

fn flank_result(
    bodies: &MillingBodies,
    plan: &FlankPlan,
    refereed: &RefereedFlank,
    [height_unit, length_unit]: [&'static str; 2],
) -> FlankResult {
    let um = |value: &Option<f64>| value.map(|mm| 1e3 * mm);
    let simulated: Vec<Option<f64>> = refereed.simulated.iter().map(um).collect();
    let planned: Vec<Option<f64>> =
        refereed.predicted.iter().map(|p| p.map(|left| 1e3 * left.stock())).collect();
    let found: Vec<f64> = simulated.iter().flatten().copied().collect();
    let [lowest, highest] = extremes(found.iter().copied());
    let differences =
        simulated.iter().zip(&planned).filter_map(|(found, wanted)| Some(((*found)? - (*wanted)?).abs()));
    let mut unmilled = BTreeMap::new();
    let mut gouged = 0;
    for (reason, count) in &refereed.unmilled {
        if matches!(reason, Unmilled::TooDeep { .. }) {
            gouged += count;
        }
        *unmilled.entry(reason.to_string()).or_insert(0) += count;
    }
    let rows = plan.rows.iter().zip(&plan.figures).enumerate().map(|(row, (finished, figures))| RowResult {
        row,
        contact_height_mm: finished.locations[finished.locations.len() / 2].contact_height,
        allowed_mm: finished.window.map(|window| [window.least, window.greatest]),
        scallop_um: figures.scallop.map(|mm| 1e3 * mm),
        chord_um: 1e3 * figures.chord,
        out_of_plane_deg: figures.out_of_plane.to_degrees(),
        axis_out_of_plane_deg: figures.axis_off.to_degrees(),
        opening_per_mm: figures.opening,
        unmilled_mm: plan.ends[row].map(|_| plan.unmilled_length(row)),
    });
    let root = plan.root.get(plan.root.len() / 2).map(|(section, _)| RootResult {
        lean_deg: section.lean.to_degrees(),
        straight_mm: section.straight,
        contact_height_mm: section.contact_height,
        half_width_mm: section.half_width,
    });
    FlankResult {
        height_unit,
        length_unit,
        height: refereed.heights.clone(),
        length: refereed.lengths.clone(),
        planned_um: planned.clone(),
        max_deviation_um: lowest.abs().max(highest.abs()),
        stock_um: [lowest, highest],
        rms_deviation_um: root_mean_square(&found),
        model_difference_um: extremes(differences)[1].max(0.0),
        referee_error_um: refereed.error_um,
        simulated_um: simulated,
        unmilled,
        gouged,
        out_of_reach: out_of_reach(plan, refereed),
        lead_range: plan.lines.range,
        overrun_columns: plan.lines.first,
        along_rows: distances(&plan.lines.dense.along_rows),
        along_columns: distances(&plan.lines.dense.along_columns),
        rows: rows.collect(),
        wear: wear(bodies, plan),
        root,
        orientation: None,
    }
}

/// Wear along the edge, beside that of one height for all rows.
fn wear(bodies: &MillingBodies, plan: &FlankPlan) -> Option<WearResult> {
    let [made, fixed] = histograms(bodies, plan)?;
    Some(WearResult {
        bin_mm: made.bin,
        peak_over_fixed: made.peak() / fixed.peak(),
        spread_mm: made.spread(),
        load_m_per_mm: made.load,
    })
}
