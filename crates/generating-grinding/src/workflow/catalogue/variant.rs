//! One pair of a catalogue as the `[worm]` and `[dresser]` of a job.

use super::task::Task;
use crate::catalogue::{DresserEntry, WormEntry};
use crate::job::{Dresser, DresserContact, DresserModification, FixedDresser, LoadedJob, Worm};
use foundation::geometry::Sides;
use foundation::modification::{AmountSpec, FlankChoice, ModificationSpec, Reference};
use job::tables::OneOrSides;

/// The job with this pair in place of its catalogue.
pub fn job_of_pair(base: &LoadedJob, task: &Task, worm: &WormEntry, dresser: &DresserEntry) -> LoadedJob {
    let mut changed = base.clone();
    let job = &mut changed.job;
    job.worm = Worm {
        threads: worm.threads,
        hand: worm.hand,
        pitch_diameter: worm.pitch_diameter,
        tip_diameter: worm.tip_diameter,
        normal_pressure_angle_deg: worm.normal_pressure_angle_deg,
        width: Some(worm.width),
        ..Worm::absent()
    };
    job.dresser = Some(Dresser {
        others: Vec::new(),
        tip_diameter: dresser.tip_diameter,
        contact: DresserContact::Line,
        tip_radius: None,
        pitch_diameter: dresser.pitch_diameter,
        root_clearance: job.catalogue.as_ref().and_then(|source| source.root_clearance),
        tip_land: dresser.tip_land,
        modification: modification(task, dresser.profile_crowning_um),
        designed_for: Some(dresser.designed_for),
    });
    job.catalogue = None;
    job.explore = None;
    let chosen = format!("worm {}, dresser {}", worm.name, dresser.name);
    job.job.description = Some(match &job.job.description {
        Some(text) => format!("{text} ({chosen})"),
        None => chosen,
    });
    changed
}

/// The crowning of a dresser as a modification of the evaluated profile: the catalogue counts it over the whole involute.
fn modification(task: &Task, crowning_um: OneOrSides<f64>) -> DresserModification {
    let (gear, blank) = (&task.workshop.gear, &task.workshop.blank);
    let [start, end, ..] = task.workshop.evaluation;
    let amounts = crowning_um.sides().map(|flank, um| {
        let f = gear.flank(flank);
        let length = |from: f64, to: f64| -> Option<f64> {
            Some(f.length_of_roll(0.5 * to).ok()? - f.length_of_roll(0.5 * from).ok()?)
        };
        // Both ranges were found when the task was made.
        let share = length(start, end).zip(length(blank.form_diameter, blank.tip_form_diameter));
        um * share.map_or(1.0, |(evaluated, involute)| (evaluated / involute).powi(2))
    });
    let spec = |flank: FlankChoice, amount_um: f64| {
        ModificationSpec::ProfileCrowning(AmountSpec { amount_um, flank, reference: Reference::default() })
    };
    let Sides { left, right } = amounts;
    if left == 0.0 && right == 0.0 {
        DresserModification::Rule(FixedDresser::None)
    } else if left == right {
        DresserModification::Given(spec(FlankChoice::Both, left))
    } else {
        DresserModification::Sum(vec![spec(FlankChoice::Left, left), spec(FlankChoice::Right, right)])
    }
}
