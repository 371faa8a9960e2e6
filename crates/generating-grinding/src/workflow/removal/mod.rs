//! What the strokes of a run take of the stock, how long the worm lasts, what a part takes and costs
//! (`docs/mathematics/grinding-technology.md`). The flank does not depend on it.

mod cycle;
mod dressing;
mod errors;
mod offers;
mod remarks;
mod result;
mod strokes;
mod time;
mod worm;

pub use cycle::RunCycle;
pub use remarks::judge_stock;
pub use result::{
    CostResult, CycleResult, CyclesResult, DressingFiguresResult, FlankRateResult, FlankRemovalResult,
    IndicatorResult, LimitShare, PartTimeResult, RateMapResult, RemovalResult, StockResult, StrokeResult,
    WormLifeResult, WormLoadResult, ZoneLoadResult,
};

use super::execution::Execution;
use super::partition::Partition;
use super::prepare::{Prepared, RemovalTask};
use super::programs::result::ProgramsResult;
use cycle::beyond;
use dressing::dressing_figures;
use errors::refused;
use grinding_technology::TechnologyError;
use remarks::{indicators, remarks};
use run::RunFailure;
use strokes::stroke_result;
use time::{part_time, time_by_law};
use verdict::Remark;
use worm::{life_of, worm_load};

const UM: f64 = 1e3;
const RPM: f64 = 60.0;

/// Figures and remarks.
pub struct Removal {
    /// For `result.json`; `None` where the bodies or motions are beyond what is worked out.
    pub result: Option<RemovalResult>,
    /// What to know.
    pub remarks: Vec<Remark>,
}

/// Puts the strokes of a run on its stock in the place of those of `[machine]`; `None` without stock, and where bodies or motions are beyond
/// what is worked out.
///
/// # Errors
/// [`RunFailure`] with a finding on `[stock]` or `[technology]`.
pub fn put_on_stock(prepared: &mut Prepared, execution: &Execution) -> Result<Option<RunCycle>, RunFailure> {
    let Some(task) = prepared.removal.as_ref().filter(|_| beyond(prepared).is_none()) else {
        return Ok(None);
    };
    let partition = Partition::of_cycle(prepared, execution.ratio, &execution.motion.shift)?;
    let cycle = RunCycle::new(prepared, execution, (task, partition.as_ref())).map_err(|e| refused(&e))?;
    prepared.technology.strokes = cycle.program_strokes();
    Ok(Some(cycle))
}

/// Figures of a run with stock; nothing without.
///
/// # Errors
/// [`RunFailure`] with a finding on `[stock]` or `[technology]`.
pub fn removal_of_run(
    prepared: &Prepared,
    (cycle, programs): (Option<&RunCycle>, Option<&ProgramsResult>),
) -> Result<Removal, RunFailure> {
    let Some(task) = &prepared.removal else { return Ok(Removal { result: None, remarks: Vec::new() }) };
    match cycle {
        Some(cycle) => worked_out(prepared, task, cycle, programs).map_err(|error| refused(&error)),
        None => {
            let why = beyond(prepared).unwrap_or("its bodies are not known");
            let remark = Remark {
                code: "removal-not-worked-out",
                text: format!("stock and removal are not worked out for this job: {why}"),
                way_out: "leave out [stock] and [technology]; the flank does not depend on them".into(),
            };
            Ok(Removal { result: None, remarks: vec![remark] })
        }
    }
}

fn worked_out(
    prepared: &Prepared,
    task: &RemovalTask,
    of_run: &RunCycle,
    programs: Option<&ProgramsResult>,
) -> Result<Removal, TechnologyError> {
    let cycle = &of_run.cycle;
    let strokes: Vec<StrokeResult> =
        (0..cycle.strokes.len()).map(|k| stroke_result(cycle, k, task)).collect();
    let load = worm_load(cycle, task);
    let life = of_run.life.as_ref().zip(load.as_ref());
    let life = life.map(|(life, load)| life_of(life, load.parts_per_dressing));
    let parts_per_dressing = load.as_ref().map(|load| load.parts_per_dressing);
    let by_law = time_by_law(prepared, cycle)?;
    let part_time = part_time(task, programs, (parts_per_dressing, by_law));
    let cost_per_part = match (task.cost, part_time, life, parts_per_dressing) {
        (Some(rates), Some(time), Some(life), Some(parts)) if parts > 0 && life.parts_per_worm > 0.0 => {
            let cost = rates.per_part(time.part_s, parts as f64, life.parts_per_worm)?;
            Some(CostResult {
                machine: cost.machine,
                worm: cost.worm,
                dresser: cost.dresser,
                change: cost.change,
                total: cost.total(),
            })
        }
        _ => None,
    };
    let indicators = indicators(cycle, task, load.as_ref());
    let result = RemovalResult {
        stock: StockResult {
            volume_mm3: cycle.stock_volume(),
            largest_um: cycle.extent.map(|_, [_, most]| UM * most),
            least_um: cycle.extent.map(|_, [least, _]| UM * least),
        },
        strokes,
        cycles: of_run.offers.as_ref().map(CyclesResult::of),
        dressing: dressing_figures(&cycle.bodies, (prepared, task), parts_per_dressing)?,
        worm_load: load,
        worm_life: life,
        part_time,
        cost_per_part,
        indicators,
    };
    let remarks = remarks(&result, cycle, (task, programs));
    Ok(Removal { result: Some(result), remarks })
}
