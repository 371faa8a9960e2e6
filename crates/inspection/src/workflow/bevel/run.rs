//! `inspect` of a bevel gear for the job by which it was milled.

use super::super::closed_loop::{BevelRound, MilledBevel};
use super::judgement::{check_class, of_class, of_flanks};
use super::pitches::pitches;
use super::result::BevelInspectionResult;
use super::teeth::teeth_of;
use foundation::geometry::Flank;
use foundation::numerics::Progress;
use job::tables::{JobInfo, Language};
use measured_files::inspection::{GridSize, read_grid_table};
use milling::job::LoadedMillingJob;
use run::JobFailure;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;
use verdict::Remark;

/// Everything that is known of a measured bevel gear.
pub struct BevelInspection {
    /// The document of `result.json`.
    pub result: BevelInspectionResult,
    /// The job that the measurement was judged by.
    pub job: JobInfo,
    /// The job whose compensation answers the measurement.
    pub corrected: Option<LoadedMillingJob>,
    /// Language of the report.
    pub language: Language,
}

/// Judges points on the grid of a bevel gear against the job by which it was milled, and its pitches by a class of ISO 17485 where one is
/// asked for, here or by `bevel.tolerance_class`.
///
/// # Errors
/// [`JobFailure`]: what is wrong with job and table, another workpiece.
pub fn inspect_bevel(
    loaded: &LoadedMillingJob,
    path: &Path,
    class: Option<i32>,
    progress: &dyn Progress,
) -> Result<BevelInspection, JobFailure> {
    let begun = Instant::now();
    let job = &loaded.job;
    let class = class.or(job.bevel.as_ref().and_then(|bevel| bevel.tolerance_class));
    check_class(class)?;
    let made = MilledBevel::of(loaded.clone(), progress)?;
    let grid = made.grid;
    let size = GridSize { teeth: made.gear.data().teeth, rows: grid.rows, columns: grid.columns };
    let measured = teeth_of(&made, &read_grid_table(path, size)?)?;
    let BevelRound { result: round, corrected } = made.judge(&measured.surfaces, progress)?;
    let pitches = pitches(&made, &measured);
    let tolerance_um = job.target.tolerance_um;
    let mut verdict = of_flanks(&round, tolerance_um, &|flank: Flank| job.flanks().contains(&flank));
    match class {
        Some(class) => verdict.extend(of_class(&pitches, class)),
        None => verdict.leave("pitches and run-out", "no class of ISO 17485 was asked for"),
    }
    let mut warnings: Vec<Remark> = pitches.remarks;
    warnings
        .extend(job.flanks().into_iter().flat_map(|flank| few_teeth(flank, measured.surfaces[flank].len())));
    let reached: Option<Vec<i32>> = pitches.classes.iter().map(|of| of.class).collect();
    let name = path.file_stem().map_or_else(|| "part".into(), |name| name.to_string_lossy().into_owned());
    let result = BevelInspectionResult {
        job: name,
        process: "inspection",
        version: env!("CARGO_PKG_VERSION"),
        verdict,
        tolerance_class: class,
        tolerance_um,
        files: path.file_name().map(|name| name.to_string_lossy().into_owned()).into_iter().collect(),
        warnings,
        grid: [grid.rows, grid.columns],
        rounds: vec![round],
        pitch_place: pitches.place,
        pitch: pitches.flanks,
        run_out_um: pitches.run_out_um,
        class: reached.and_then(|classes| classes.into_iter().max()),
        classes: pitches.classes,
        timing_s: BTreeMap::from([("all", begun.elapsed().as_secs_f64())]),
    };
    Ok(BevelInspection { result, job: job.job.clone(), corrected, language: job.output.language })
}

/// Teeth from which on what all share can be distinguished from chance.
const ENOUGH: usize = 3;

fn few_teeth(flank: Flank, teeth: usize) -> Option<Remark> {
    (1..ENOUGH).contains(&teeth).then(|| Remark {
        code: "few-teeth",
        text: format!("{teeth} of the {flank} flanks were measured as a surface: what all teeth share is not distinguished from chance"),
        way_out: "measure the grid on three teeth or more, evenly around the gear".into(),
    })
}
