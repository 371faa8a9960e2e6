//! Tangential dressing of asymmetric and conical gears, and with dressers that exist: what is exact, what the rays find, what derivatives say.

use crate::tangential_referee::differences;
use contact::Measure;
use foundation::geometry::{Flank, Gear, GearData, Sides, WormChoice, worm_for_gear};
use std::sync::Arc;
use tangential_dressing::{
    CarriedProfile, ExistingDresser, FitGrid, ProfileKind, ShiftOffset, ShiftRatio, TangentialFlank,
    TangentialInput, TangentialModel, TangentialSettings, Variable,
};

fn worm(gear: &Gear, pitch_diameter: f64, pressure_angle: Option<f64>) -> Gear {
    let choice = WormChoice {
        threads: 2,
        hand: 1.0,
        pitch_diameter: Some(pitch_diameter),
        tip_diameter: None,
        pressure_angle,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    worm_for_gear(gear, &choice).unwrap().worm
}

fn input(gear: GearData, radii: [f64; 2]) -> TangentialInput {
    let gear = Gear::new(gear).unwrap();
    TangentialInput {
        gear,
        worm: worm(&gear, 240.0, None),
        worm_tip_radius: None,
        dresser_pitch_radius: 58.0,
        dresser_tip_radius: None,
        dresser_depth: None,
        profile: ProfileKind::Conjugate,
        radii,
        faces: [-10.0, 10.0],
        face_width: 20.0,
        shift_width: 30.0,
        shift_ratio: ShiftRatio::Given(1.3),
        shift_offset: ShiftOffset::Contact,
    }
}

/// Gears of the example jobs: asymmetric, conical, both.
fn gears() -> [(&'static str, TangentialInput); 3] {
    let data = |left: f64, right: f64, helix: f64, cone: f64| GearData {
        teeth: 31,
        normal_module: 2.5,
        pressure_angle: Sides { left: left.to_radians(), right: right.to_radians() },
        helix_angle: helix.to_radians(),
        profile_shift: 0.15,
        cone_angle: cone.to_radians(),
    };
    [
        ("asymmetric", input(data(25.0, 18.0, 20.0, 0.0), [39.7, 43.6])),
        ("conical", input(data(20.0, 20.0, 15.0, 5.0), [39.25, 41.75])),
        ("asymmetric cone", input(data(22.0, 18.0, -12.0, -4.0), [39.3, 41.8])),
    ]
}

/// Every channel at once, mm and rad.
const SETTINGS: [(&str, f64); 14] = [
    ("Fp1", 0.001),
    ("Fp2", 0.002),
    ("FpL2", 0.001),
    ("Fz2", 0.1),
    ("dX2", -0.01),
    ("dA1", 0.01),
    ("dA2", 0.01),
    ("gA1", 0.0001),
    ("gam0", 0.02),
    ("dist1", -0.003),
    ("dist2", 0.002),
    ("FC2", 0.008),
    ("FT2", 0.2),
    ("kap", 0.05),
];

fn settings(values: &[(&str, f64)]) -> TangentialSettings {
    let mut settings = TangentialSettings::default();
    for (name, value) in values {
        settings.set(&name.parse::<Variable>().unwrap(), *value);
    }
    settings
}

fn ground<'m>(
    model: &'m TangentialModel,
    flank: Flank,
    settings: &TangentialSettings,
) -> TangentialFlank<'m> {
    TangentialFlank::new(model, flank, &[flank], settings, Measure::Ray)
}

#[test]
fn the_unmodified_flank_is_exact() {
    for (name, input) in gears() {
        let model = TangentialModel::new(input).unwrap();
        for flank in Flank::BOTH {
            let grid = FitGrid::Equidistant(7, 7).of(&model, flank);
            let found = ground(&model, flank, &TangentialSettings::default()).solve(&grid).unwrap();
            for point in &found {
                assert!(point.deviation.abs() < 1e-11, "{name} {flank}: {point:?}");
                assert!((point.determinant_ratio - 1.0).abs() < 1e-6, "{name} {flank}: {point:?}");
            }
        }
    }
}

#[test]
fn the_rays_find_the_flanks_of_the_exact_contact() {
    for (name, input) in gears() {
        let model = TangentialModel::new(input).unwrap();
        for flank in Flank::BOTH {
            let [surface, exact] = differences(&model, flank, &settings(&SETTINGS));
            assert!(surface < 0.02 && exact < 1e-6, "{name} {flank}: {surface} {exact} um");
        }
    }
}

#[test]
fn derivatives_are_those_of_differences() {
    let names = ["Fp2", "Fz2", "dX1", "dA1", "gA0", "dist0", "dist2", "FC1", "FT1", "kap"];
    for (name, input) in gears() {
        let model = TangentialModel::new(input).unwrap();
        let variables: Vec<Variable> = names.iter().map(|name| name.parse().unwrap()).collect();
        for flank in Flank::BOTH {
            let grid = FitGrid::Equidistant(3, 3).of(&model, flank);
            let at = settings(&SETTINGS);
            let (_, by) = ground(&model, flank, &at).linearised(&grid, &variables).unwrap();
            for (j, variable) in variables.iter().enumerate() {
                let step = 1e-5;
                let beside = |by: f64| {
                    let mut moved = at.clone();
                    moved.set(variable, at.value(variable) + by);
                    let points = ground(&model, flank, &moved).solve_beyond_tool(&grid).unwrap();
                    points.iter().map(|p| p.deviation).collect::<Vec<f64>>()
                };
                let (up, down) = (beside(step), beside(-step));
                for i in 0..up.len() {
                    let difference = (up[i] - down[i]) / (2.0 * step);
                    assert!(
                        (by[(i, j)] - difference).abs() < 1e-6,
                        "{name} {flank} {variable}: {difference}"
                    );
                }
            }
        }
    }
}

#[test]
fn at_the_neutral_ratio_the_place_on_the_worm_follows_the_face_alone() {
    for (name, input) in gears() {
        for flank in Flank::BOTH {
            let only = Sides::from_fn(|f| f == flank);
            let input = TangentialInput { shift_ratio: ShiftRatio::Neutral(only), ..input };
            let model = TangentialModel::new(input).unwrap();
            assert_eq!(model.neutral_ratios[flank], Some(model.shift_ratio), "{name}");
            let grid = FitGrid::Equidistant(4, 3).of(&model, flank);
            let points = ground(&model, flank, &TangentialSettings::default()).solve(&grid).unwrap();
            for z in 0..3 {
                let places: Vec<f64> = (0..4).map(|w| points[3 * w + z].position).collect();
                let spread = places.iter().fold(0.0, |m: f64, x| m.max((x - places[0]).abs()));
                // On a cone the place bends a little with the roll.
                assert!(spread < 2e-3, "{name} {flank}: {places:?}");
            }
        }
    }
}

#[test]
fn asymmetric_and_conical_flanks_have_neutral_ratios_of_their_own() {
    for (name, input) in gears() {
        let model = TangentialModel::new(input).unwrap();
        assert_eq!(model.neutral_ratio(), None, "{name}: {:?}", model.neutral_ratios);
    }
}

/// 5 um are taken off at both ends of the profile, as a parabola.
fn crowning(model: &TangentialModel, flank: Flank) -> CarriedProfile {
    let [from, to] = model.rolls(flank);
    Arc::new(move |w| {
        let u = (2.0 * w - from - to) / (to - from);
        Some(-0.005 * u * u)
    })
}

#[test]
fn a_dresser_that_exists_leaves_what_it_carries() {
    for (name, input) in gears() {
        let plain = TangentialModel::new(input).unwrap();
        let carried = Sides::from_fn(|flank| Some(crowning(&plain, flank)));
        let dresser = ExistingDresser { made_for: plain.clone(), carried };
        let model = plain.clone().with_dresser(&dresser).unwrap();
        for flank in Flank::BOTH {
            let wanted = crowning(&plain, flank);
            // In the middle of the face, where also a beveloid is ground as it was meant.
            let [from, to] = plain.rolls(flank);
            let w: Vec<f64> = (0..9).map(|i| from + (to - from) * f64::from(i) / 8.0).collect();
            let grid = tangential_dressing::RollGrid { w: w.clone(), z: vec![0.0] };
            let found = ground(&model, flank, &TangentialSettings::default()).deviations(&grid).unwrap();
            for (w, f) in w.iter().zip(found) {
                let apart = (f - wanted(*w).unwrap()).abs();
                // The contact shifts by the slope of the profile, 0.0025 here: half of its square times the radius of curvature.
                let within = if plain.pair.work.is_cylindrical() { 1.2e-4 } else { 5e-4 };
                assert!(apart < within, "{name} {flank} at {w}: {f}");
            }
        }
    }
}

#[test]
fn the_rays_find_what_a_dresser_for_another_worm_leaves() {
    let (_, input) = gears()[0];
    let model = TangentialModel::new(input).unwrap();
    let left = input.gear.data().pressure_angle.left;
    for pressure_angle in [None, Some(left - 0.01)] {
        let other = worm(&input.gear, 280.0, pressure_angle);
        let made_for = TangentialModel::new(TangentialInput { worm: other, ..input }).unwrap();
        let dresser = ExistingDresser { made_for, carried: Sides { left: None, right: None } };
        let model = model.clone().with_dresser(&dresser).unwrap();
        for flank in Flank::BOTH {
            let grid = FitGrid::Equidistant(5, 5).of(&model, flank);
            let found = ground(&model, flank, &settings(&[("dX2", 0.01)])).solve(&grid).unwrap();
            let largest = found.iter().map(|p| p.deviation.abs()).fold(0.0, f64::max);
            assert!(largest > 1e-4, "{flank}: it does not fit without settling: {largest}");
            let [surface, exact] = differences(&model, flank, &settings(&[("dX2", 0.01)]));
            assert!(surface < 0.02 && exact < 1e-3, "{flank}: {surface} {exact} um");
        }
    }
}
