//! The first page of ground flanks: values of the drawing as made, settings of the machine, times, tools. What tangential dressing has
//! too takes its figures, not a result of one process.

mod machine_settings;
mod times;
mod tools;
mod values;

pub use machine_settings::MachineSettings;
pub use times::times;

pub(super) use values::values;

use crate::workflow::run::Outcome;
use report::{Quantity, Sheet};

/// The lists of a run.
pub(super) fn sheets(outcome: &Outcome) -> Vec<Sheet> {
    let prepared = &outcome.prepared;
    let finished = &prepared.setup.input.gear;
    let stocked =
        prepared.removal.as_ref().and_then(|task| finished.with_allowance(&task.stock.allowance).ok());
    let mut settings = machine_settings(outcome).sheet();
    let ratio = outcome.result.settings.settings.diagonal_ratio;
    settings.quantities.push(Quantity::rounded("diagonal ratio", "K", ratio, 4, ""));
    let [from, to] = outcome.execution.feed_range;
    let shift = |z: f64| outcome.execution.motion.shift.value(z);
    settings.quantities.push(Quantity::shown(
        "worm shift over the stroke",
        "z_V1",
        tools::from_to(shift(from), shift(to)),
        "mm",
    ));
    let removal = outcome.result.removal.as_ref();
    let mut senses: Vec<&str> = removal.iter().flat_map(|r| r.strokes.iter().map(|s| s.sense)).collect();
    senses.dedup();
    if !senses.is_empty() {
        settings.quantities.push(Quantity::text("sense of grinding", senses.join(", ")));
    }
    vec![
        settings,
        times(outcome.programs.as_ref(), removal, outcome.prepared.names_machine),
        prepared.measures.sheet(finished, stocked.as_ref()),
        tools::worm(outcome),
        tools::dresser(outcome),
    ]
}

fn machine_settings(outcome: &Outcome) -> MachineSettings<'_> {
    let prepared = &outcome.prepared;
    let setup = &prepared.setup;
    MachineSettings {
        crossed_axes_angle_deg: outcome.result.settings.crossed_axes_angle_deg,
        centre_distance_mm: outcome.result.settings.centre_distance_mm,
        worm_tip_radius_mm: setup.largest_tip_radius,
        threads: setup.pair.worm.data().teeth,
        teeth: setup.input.gear.data().teeth,
        feed_stroke_mm: outcome.execution.feed_range,
        feed_given: prepared.cycle.feed_per_revolution,
        technology: prepared.names_machine.then_some(&prepared.technology),
        programs: outcome.programs.as_ref(),
    }
}
