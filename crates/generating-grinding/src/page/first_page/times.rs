//! Times of a part: those of the programs, and what the job adds to them.

use crate::workflow::programs::result::ProgramResult;
use crate::workflow::programs::run_programs::RunPrograms;
use crate::workflow::removal::RemovalResult;
use report::{Quantity, Sheet};

/// The list; without programs it says why there is none.
pub fn times(programs: Option<&RunPrograms>, removal: Option<&RemovalResult>, names_machine: bool) -> Sheet {
    let mut sheet = Sheet::new("Times", Vec::new());
    let Some(first) = programs.and_then(|of| of.result.programs.first()) else {
        return sheet.remark(match names_machine {
            true => "Not known: there are no programs.",
            false => "Not known: no programs, the job names no machine.",
        });
    };
    let all = programs.iter().flat_map(|of| &of.result.programs).filter(|p| p.control == first.control);
    let of = |job: &str| -> f64 {
        all.clone()
            .filter(|program: &&ProgramResult| program.job == job)
            .map(|program| program.duration_s)
            .sum()
    };
    let second = |name: &str, value: f64| Quantity::rounded(name, "", value, 1, "s");
    sheet.quantities.push(second("grinding, all strokes", of("grinding")));
    let dressing = of("dressing");
    if dressing > 0.0 {
        sheet.quantities.push(second("dressing", dressing));
    }
    if let Some(load) = removal.and_then(|of| of.worm_load.as_ref()) {
        let parts = i64::try_from(load.parts_per_dressing).unwrap_or(i64::MAX);
        sheet.quantities.push(Quantity::count("parts per dressing", "", parts));
    }
    match removal.and_then(|of| of.part_time.as_ref()) {
        Some(time) => {
            sheet.quantities.push(second("dressing, share of a part", time.dressing_per_part_s));
            sheet.quantities.push(second("loading and indexing", time.auxiliary_s));
            sheet.quantities.push(second("part", time.part_s));
        }
        None => {
            sheet =
                sheet.remark("Loading and indexing: not given (`stock` and `technology.times` of the job).");
        }
    }
    if let Some(cost) = removal.and_then(|of| of.cost_per_part.as_ref()) {
        sheet.quantities.push(Quantity::rounded("cost per part", "", cost.total, 2, ""));
    }
    sheet
}
