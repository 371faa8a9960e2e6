//! The lists of the first page: settings of the machine, times, tooth thickness, worm, dresser.

use crate::workflow::TangentialOutcome;
use generating_grinding::page::{MachineSettings, times};
use report::{Quantity, Sheet};

pub(super) fn sheets(outcome: &TangentialOutcome) -> Vec<Sheet> {
    let prepared = &outcome.prepared;
    let settings = &outcome.result.settings;
    let gear = &prepared.model.input().gear;
    let worm = &prepared.model.pair.worm;
    let strokes = outcome.result.flanks.values().map(|flank| flank.feed_stroke_mm);
    let stroke = strokes.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
    let mut machine = MachineSettings {
        crossed_axes_angle_deg: settings.crossed_axes_angle_deg,
        centre_distance_mm: settings.centre_distance_mm,
        worm_tip_radius_mm: prepared.worm_tip_radius,
        threads: worm.data().teeth,
        teeth: gear.data().teeth,
        feed_stroke_mm: stroke.unwrap_or_default(),
        feed_given: prepared.gives_feed.then_some(prepared.technology.finishing().feed_per_revolution),
        technology: prepared.names_machine.then_some(&prepared.technology),
        programs: outcome.programs.as_ref(),
    }
    .sheet();
    machine.quantities.push(Quantity::rounded("tool shift per feed", "κ", settings.shift_ratio, 5, ""));
    let hand = if worm.data().helix_angle > 0.0 { "right" } else { "left" };
    let threads = format!("{}, {hand}", worm.data().teeth.abs());
    let mut of_worm = vec![
        Quantity::shown("number of threads, hand", "z_0", threads, ""),
        Quantity::rounded("tip diameter", "d_a0", 2.0 * prepared.worm_tip_radius, 3, "mm"),
        Quantity::rounded("lead angle", "γ_0", 90.0 - worm.data().helix_angle.to_degrees().abs(), 4, "deg"),
    ];
    of_worm.extend(prepared.worm_width.map(|width| Quantity::rounded("width", "b_0", width, 1, "mm")));
    let dresser = vec![
        Quantity::rounded("tip diameter", "d_aA", prepared.dresser_tip_diameter, 3, "mm"),
        Quantity::rounded("centre distance", "a_d", settings.dressing_centre_distance_mm, 4, "mm"),
        Quantity::rounded("crossing angle", "Σ_d", settings.dressing_crossing_angle_deg, 4, "deg"),
    ];
    vec![
        machine,
        times(outcome.programs.as_ref(), None, prepared.names_machine),
        prepared.measures.sheet(gear, None),
        Sheet::new("Worm", of_worm),
        Sheet::new("Dresser", dresser),
    ]
}
