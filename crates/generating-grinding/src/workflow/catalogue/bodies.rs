//! Entries of a catalogue as bodies of the search.

use crate::catalogue::{Catalogue, DresserEntry, WormEntry};
use crate::job::Job;
use crate::workflow::prepare::designed_worm;
use dressing::catalogue::{CatalogueDresser, CatalogueWorm, DresserSize, WornDiameter};
use foundation::geometry::WormChoice;

fn worm(job: &Job, entry: &WormEntry) -> CatalogueWorm {
    let angles = entry.normal_pressure_angle_deg.unwrap_or(job.gear.normal_pressure_angle_deg);
    CatalogueWorm {
        name: entry.name.clone(),
        choice: WormChoice {
            threads: i32::try_from(entry.threads).unwrap_or(i32::MAX),
            hand: entry.hand.unwrap_or_else(|| job.worm_hand()).sign(),
            pitch_diameter: entry.pitch_diameter,
            tip_diameter: entry.tip_diameter,
            pressure_angle: Some(angles.sides().left.to_radians()),
            profile_shift: 0.0,
            cone_angle: 0.0,
        },
        right_angle: entry.normal_pressure_angle_deg.map(|given| given.sides().right.to_radians()),
        normal_module: entry.normal_module,
        smallest: entry
            .smallest_pitch_diameter
            .map(WornDiameter::Pitch)
            .or(entry.smallest_tip_diameter.map(WornDiameter::Tip)),
        width: entry.width,
    }
}

fn dresser(job: &Job, entry: &DresserEntry) -> CatalogueDresser {
    let there = &entry.designed_for;
    CatalogueDresser {
        name: entry.name.clone(),
        size: DresserSize {
            tip_radius: 0.5 * entry.tip_diameter,
            pitch_radius: entry.pitch_diameter.map(|d| 0.5 * d),
        },
        designed_for: designed_worm(&job.gear, job.worm_hand(), there),
        designed_right_angle: there.normal_pressure_angle_deg.map(|given| given.sides().right.to_radians()),
        designed_module: there.normal_module,
        crowning: entry.profile_crowning_um.sides().map(|_, um| um * 1e-3),
        tip_land: entry.tip_land,
        flank: entry.flank_diameters.map(|flank| [0.5 * flank.from, 0.5 * flank.to]),
    }
}

/// Worms and dressers of a catalogue, in its order.
pub fn bodies(job: &Job, catalogue: &Catalogue) -> (Vec<CatalogueWorm>, Vec<CatalogueDresser>) {
    let worms = catalogue.worm.iter().map(|entry| worm(job, entry)).collect();
    (worms, catalogue.dresser.iter().map(|entry| dresser(job, entry)).collect())
}
