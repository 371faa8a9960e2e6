//! Worm and dresser in short.

use crate::workflow::run::Outcome;
use report::charts::format_fixed;
use report::{Quantity, Sheet};
use std::f64::consts::TAU;

/// "−12.50 to 12.50".
pub(super) fn from_to(from: f64, to: f64) -> String {
    format!("{} to {}", format_fixed(from, 2), format_fixed(to, 2))
}

pub(super) fn worm(outcome: &Outcome) -> Sheet {
    let setup = &outcome.prepared.setup;
    let data = setup.pair.worm.data();
    let hand = if data.helix_angle > 0.0 { "right" } else { "left" };
    let lead = 90.0 - data.helix_angle.to_degrees().abs();
    let mut list = vec![
        Quantity::shown("number of threads, hand", "z_0", format!("{}, {hand}", data.teeth.abs()), ""),
        Quantity::rounded("tip diameter", "d_a0", 2.0 * setup.worm_tip_radius, 3, "mm"),
        Quantity::rounded("lead angle", "γ_0", lead, 4, "deg"),
    ];
    list.extend(setup.input.worm_width.map(|width| Quantity::rounded("width", "b_0", width, 1, "mm")));
    let used = outcome.result.settings.worm_length_mm;
    list.push(Quantity::rounded("width used by one stroke", "", used, 1, "mm"));
    Sheet::new("Worm", list)
}

pub(super) fn dresser(outcome: &Outcome) -> Sheet {
    let prepared = &outcome.prepared;
    let settings = &outcome.result.settings;
    let mut list = Vec::new();
    if let Some(point) = &prepared.dressing.point {
        list.push(Quantity::rounded("tip diameter", "d_aA", point.tip_diameter, 3, "mm"));
        list.push(Quantity::rounded("tip radius", "r_T", point.tip_radius, 3, "mm"));
    } else if let Some(choice) = &prepared.setup.input.dresser {
        list.push(Quantity::rounded("tip diameter", "d_aA", choice.tip_diameter, 3, "mm"));
    } else {
        return Sheet::new("Dresser", list).remark("None: the flanks of the tool are given.");
    }
    let distance = settings.dressing_centre_distance_mm;
    list.extend(distance.map(|mm| Quantity::rounded("centre distance", "a_d", mm, 4, "mm")));
    let angle = settings.dressing_crossing_angle_deg;
    list.extend(angle.map(|deg| Quantity::rounded("crossing angle", "Σ_d", deg, 4, "deg")));
    if prepared.names_machine {
        let rpm = |speed: f64| speed * 60.0 / TAU;
        let technology = &prepared.technology;
        list.push(Quantity::rounded("worm speed", "", rpm(technology.dressing_speed), 0, "1/min"));
        list.push(Quantity::rounded("dresser speed", "", rpm(technology.dresser_speed), 0, "1/min"));
    }
    Sheet::new("Dresser", list)
}
