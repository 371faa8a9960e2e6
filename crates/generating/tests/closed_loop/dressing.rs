//! What the dressing correction does to the gear.

use super::grinding::UM;
use contact::Pair;
use dressing::{DressedProfile, DresserTool, GeometricRange};
use foundation::geometry::{Flank, Gear, GearData, Sides, WormChoice, worm_for_gear};
use foundation::kinematics::DressingChain;
use foundation::modification::EvaluationField;
use generating::FlankLines;
use generating::correction::{DressingInfluence, TwoFlankPattern};
use std::f64::consts::FRAC_PI_2;

/// 19 teeth, five threads, worm 100 mm, disc 123 mm.
fn bodies() -> (DresserTool, FlankLines, GeometricRange) {
    let gear = Gear::new(GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: 35f64.to_radians(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap();
    let choice = WormChoice {
        threads: 5,
        hand: 1.0,
        pitch_diameter: Some(100.0),
        tip_diameter: None,
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let made = worm_for_gear(&gear, &choice).unwrap();
    let pair = Pair::without_backlash(made.worm, gear, made.crossed_axes_angle).unwrap();
    let f = gear.flank(Flank::Left);
    let rolls = [76.6, 88.0].map(|d: f64| f.length_of_roll(d / 2.0).unwrap());
    let own = &pair.flanks.left;
    let [w_na, w_nf] = rolls.map(|w| own.worm_roll(w, 0.0, 0.0));
    let screw = made.worm.screw_parameter(Flank::Left);
    let r_w = gear.pitch_radius();
    let dedendum = 44.0 - r_w + 0.25 * 3.5;
    let chain = DressingChain {
        worm_angle: -FRAC_PI_2,
        crossing_angle: -(screw / 50.0).atan(),
        centre_distance: 61.5 + 50.0 - dedendum,
        offset: 0.0,
        screw_parameter: screw,
    };
    let range = GeometricRange { w_nf, w_na };
    let tool = DresserTool::conjugate(&made.worm, Sides::both(chain), Sides::both(range)).unwrap();
    let field = EvaluationField::new(rolls, [-20.0, 20.0], f.base_radius, f.base_helix_angle).unwrap();
    (tool, FlankLines::new(own, &field, own.axial_section_line(field.roll_middle()).rho.tan()), range)
}

#[test]
fn effects_are_those_of_the_specification() {
    let found = DressingInfluence::new(&bodies().0, [0.0; 4], 41).unwrap();
    let minute = (1.0f64 / 60.0).to_radians();
    let close = |found: f64, wanted: f64| assert!((found - wanted).abs() < 0.006, "{found} {wanted}");
    for (flank, side) in found.flanks.iter() {
        let s = flank.sign();
        close(side.slope[1] * minute / UM, 0.522);
        close(side.slope[3] * 0.1 / UM, s * 1.035);
        close(side.offset[2] * 10.0, -3.02);
        close(side.slope[2] * 10.0, 0.058);
        close(side.offset[0] * minute / UM, s * 2.43);
    }
}

#[test]
fn one_motion_removes_all_but_opposite_crownings() {
    let found = DressingInfluence::new(&bodies().0, [0.0; 4], 41).unwrap();
    let share = |pattern| found.removable_share(pattern).unwrap();
    assert!(share(TwoFlankPattern::EqualSlopes) > 0.9999999);
    assert!(share(TwoFlankPattern::OppositeSlopes) > 0.9999);
    assert!(share(TwoFlankPattern::EqualCrownings) > 0.999999);
    assert!(share(TwoFlankPattern::OppositeCrownings) < 2e-5);
    assert_eq!(DressingInfluence::new(&bodies().0, [0.0; 4], 2).unwrap_err().code(), "invalid-number");
}

#[test]
fn a_small_correction_changes_the_gear_as_its_columns_say() {
    let (tool, lines, range) = bodies();
    let found = DressingInfluence::new(&tool, [0.0; 4], 41).unwrap();
    // Six seconds of crossing angle: the worm gets what the gear loses, root of the gear at the large end of the worm's range.
    let seconds = (6.0f64 / 3600.0).to_radians();
    let dressed = DressedProfile::new(&tool, Flank::Left, [0.0, seconds, 0.0, 0.0]);
    for k in [0, 4, 36, 40] {
        let w_1 = range.w_na + (range.w_nf - range.w_na) * k as f64 / 40.0;
        let gear = found.flanks.left.columns[1][k] * seconds;
        assert!((dressed.at_roll(w_1).unwrap().f + gear).abs() < 1e-4 * UM && gear.abs() > 1e-2 * UM, "{k}");
        // The sample stands where this length of roll of the worm grinds.
        let u =
            (2.0 * lines.work_roll(w_1) - lines.roll[0] - lines.roll[1]) / (lines.roll[1] - lines.roll[0]);
        assert!((u - found.flanks.left.u[k]).abs() < 1e-9);
    }
}
