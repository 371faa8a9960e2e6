//! Time of a part: that of its programs, beside the law of moves from rest to rest.

use super::offers::axes_of;
use super::result::PartTimeResult;
use crate::workflow::prepare::{Prepared, RemovalTask};
use crate::workflow::programs::result::{ProgramResult, ProgramsResult};
use grinding_technology::{Cycle, StrokeTime, TechnologyError};

/// Time of all strokes by the law of moves from rest to rest, s; `None` without a machine.
pub(super) fn time_by_law(prepared: &Prepared, cycle: &Cycle) -> Result<Option<f64>, TechnologyError> {
    let Some(machine) = &prepared.machine else { return Ok(None) };
    let times = cycle.times(&axes_of(&machine.machine), prepared.technology.clearance)?;
    Ok(Some(times.iter().map(StrokeTime::sum).sum()))
}

/// Programs of one control, "dressing" or "grinding": those of all controls say the same motion.
pub(super) fn of_one_control<'a>(
    programs: &'a ProgramsResult,
    station: &'static str,
) -> impl Iterator<Item = &'a ProgramResult> {
    let control = programs.programs.first().map(|program| program.control);
    programs.programs.iter().filter(move |program| Some(program.control) == control && program.job == station)
}

/// `None` without times of the job, without programs, or where not even one part fits on the worm.
pub(super) fn part_time(
    task: &RemovalTask,
    programs: Option<&ProgramsResult>,
    (parts_per_dressing, grinding_by_law_s): (Option<usize>, Option<f64>),
) -> Option<PartTimeResult> {
    let (times, programs) = (task.times?, programs?);
    let of_station = |station: &'static str| {
        of_one_control(programs, station).map(|program| program.duration_s).sum::<f64>()
    };
    let (grinding_s, dressing_s) = (of_station("grinding"), of_station("dressing"));
    let parts = parts_per_dressing.filter(|parts| *parts > 0)?;
    let dressing_per_part_s = (dressing_s + times.dressing_aux) / parts as f64;
    let auxiliary_s = times.load + times.index + times.other;
    let part_s = grinding_s + dressing_per_part_s + auxiliary_s;
    Some(PartTimeResult {
        grinding_s,
        grinding_by_law_s,
        dressing_s,
        dressing_per_part_s,
        auxiliary_s,
        part_s,
    })
}
