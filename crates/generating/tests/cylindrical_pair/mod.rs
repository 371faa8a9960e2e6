//! A cylindrical gear with its worm, for tests of relations on the flank.

use contact::Pair;
use foundation::geometry::{Flank, Gear, GearData, Sides, WormChoice, worm_for_gear};
use foundation::modification::EvaluationField;
use generating::FlankLines;

/// 31 teeth, module 2.5, face width 30, helix angle as given; worm of three threads.
pub fn pair(helix_angle_deg: f64) -> Pair {
    let gear = Gear::new(GearData {
        teeth: 31,
        normal_module: 2.5,
        pressure_angle: Sides::both(20f64.to_radians()),
        helix_angle: helix_angle_deg.to_radians(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap();
    let choice = WormChoice {
        threads: 3,
        hand: 1.0,
        pitch_diameter: Some(250.0),
        tip_diameter: None,
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let made = worm_for_gear(&gear, &choice).unwrap();
    Pair::without_backlash(made.worm, gear, made.crossed_axes_angle).unwrap()
}

/// The numbers of a flank, its worm lines in axial planes.
pub fn lines(pair: &Pair, flank: Flank) -> FlankLines {
    let work = pair.work.flank(flank);
    let roll = [78.0 / 2.0, 87.4 / 2.0].map(|r| work.length_of_roll(r).unwrap());
    let field = EvaluationField::new(roll, [-15.0, 15.0], work.base_radius, work.base_helix_angle).unwrap();
    let line = pair.flanks[flank].axial_section_line(field.roll_middle());
    FlankLines::new(&pair.flanks[flank], &field, line.rho.tan())
}
