//! The two-stage referee on the examples of tangential dressing: rays through a surface between the stages within 0.02 um, and rays that
//! ask the dresser at every point within 1e-9 um of the exact contact (`docs/mathematics/tangential-dressing.md#how-it-is-verified`).

use contact::Measure;
use foundation::geometry::{Flank, Gear, GearData, Sides};
use foundation::numerics::Silent;
use referee::{
    ActiveThreads, Dressing, ExactWorm, Grinding, GrindingMode, RayGrid, WormArea, WormModification, dress,
    grind,
};
use serde_json::Value;
use std::path::Path;
use tangential_dressing::{
    FitGrid, ProfileKind, RollGrid, ShiftOffset, ShiftRatio, TangentialFlank, TangentialInput,
    TangentialModel, TangentialSettings, Variable,
};

/// Table 2 of the source.
fn model() -> TangentialModel {
    let data = GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: (-35f64).to_radians(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let lead_angle = (3.0 * 3.5 / (2.0 * 95.625f64)).asin();
    let helix_angle = lead_angle - std::f64::consts::FRAC_PI_2;
    TangentialModel::new(TangentialInput {
        gear: Gear::new(data).unwrap(),
        worm: Gear::new(GearData { teeth: 3, helix_angle, ..data }).unwrap(),
        worm_tip_radius: None,
        dresser_pitch_radius: 57.825,
        dresser_tip_radius: None,
        dresser_depth: None,
        profile: ProfileKind::Conjugate,
        radii: [38.10325, 44.26575],
        faces: [-20.0, 20.0],
        face_width: 40.0,
        shift_width: 48.1042,
        shift_ratio: ShiftRatio::Given(1.202605),
        shift_offset: ShiftOffset::Given(0.0),
    })
    .unwrap()
}

/// Largest differences of the rays from the exact contact, um: through a surface on 9 x 9 points, asking the dresser on 3 x 3.
pub(crate) fn differences(model: &TangentialModel, flank: Flank, settings: &TangentialSettings) -> [f64; 2] {
    let ground = TangentialFlank::new(model, flank, &[flank], settings, Measure::Ray);
    let fine = FitGrid::Equidistant(9, 9).of(model, flank);
    let points = ground.solve(&fine).unwrap();
    let strokes = ground.strokes(&points);
    let (motion, shift_range) = ground.dressing_motion(strokes.dressing).unwrap();
    let dresser = ground.dresser();
    let stock = 0.2f64.max(3.0 * strokes.worm_modification);
    let stage = Dressing { worm: ground.worm(), dresser: &dresser, motion: &motion, shift_range, stock };
    let [from, to] = strokes.worm_faces;
    let rays = RayGrid::spaced(strokes.worm_rolls, 0.4, [from + 0.5, to - 0.5], 1.0).unwrap();
    let surface = dress(&stage, &rays, &Silent).unwrap().surface().unwrap();
    let exact = ExactWorm::new(&stage, surface.clone()).unwrap();
    let area = WormArea { w: strokes.worm_rolls, z: [from + 0.5, to - 0.5] };
    let apart = |modification: &dyn WormModification, grid: &RollGrid| {
        let grinding = Grinding {
            worm: ground.worm(),
            area,
            modification,
            work: ground.work(),
            motion: ground.motion(),
            feed_range: strokes.feed,
            stock,
            threads: ActiveThreads::All,
            mode: GrindingMode::Continuous,
        };
        let rays = RayGrid::new(grid.w.clone(), grid.z.clone()).unwrap();
        let lengths = grind(&grinding, &rays, &Silent).unwrap().lengths().unwrap();
        let planned = ground.deviations(grid).unwrap();
        lengths.iter().zip(planned).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) * 1e3
    };
    [apart(&surface, &fine), apart(&exact, &FitGrid::Equidistant(3, 3).of(model, flank))]
}

#[test]
fn rays_agree_with_the_exact_contact_on_all_examples() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/reference/40-tdm.json");
    let reference: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let model = model();
    let mut count = 0;
    for (name, example) in reference["examples"].as_object().unwrap() {
        let flank = if example["flank"].as_f64().unwrap() > 0.0 { Flank::Left } else { Flank::Right };
        for set in ["paper9", "small_set", "small_set_kappa0"] {
            let Some(fit) = example.get(set) else { continue };
            // These variables need the dresser beyond its profile (s down to -9 mm), where no machine has one.
            if (name.as_str(), set) == ("ex2_symbols", "paper9") {
                continue;
            }
            let mut settings = TangentialSettings::default();
            for (variable, value) in fit["variables"].as_object().unwrap() {
                settings.set(&variable.parse::<Variable>().unwrap(), value.as_f64().unwrap());
            }
            if let Some(ratio) = fit.get("kappa") {
                settings.set(&Variable::shift_ratio(), ratio.as_f64().unwrap() - model.shift_ratio);
            }
            let [through_surface, exact] = differences(&model, flank, &settings);
            assert!(through_surface < 0.02, "{name} {set}: {through_surface:e} um");
            assert!(exact < 1e-9, "{name} {set}: {exact:e} um");
            count += 1;
        }
    }
    assert_eq!(count, 19);
}

#[test]
fn a_wrong_motion_shows() {
    let model = model();
    let mut settings = TangentialSettings::default();
    settings.set(&"dX2".parse().unwrap(), -0.0065);
    let flank = Flank::Right;
    let ground = TangentialFlank::new(&model, flank, &[flank], &settings, Measure::Ray);
    let grid = FitGrid::Equidistant(5, 5).of(&model, flank);
    let strokes = ground.strokes(&ground.solve(&grid).unwrap());
    // The referee gets the motion without the correction.
    let plain = TangentialFlank::new(&model, flank, &[flank], &TangentialSettings::default(), Measure::Ray);
    let (motion, shift_range) = plain.dressing_motion(strokes.dressing).unwrap();
    let dresser = ground.dresser();
    let stage = Dressing { worm: ground.worm(), dresser: &dresser, motion: &motion, shift_range, stock: 0.2 };
    let rays = RayGrid::spaced(strokes.worm_rolls, 0.5, strokes.worm_faces, 2.0).unwrap();
    let lengths = dress(&stage, &rays, &Silent).unwrap().lengths().unwrap();
    assert!(lengths.iter().all(|f| f.abs() < 1e-9), "an unmodified motion leaves an unmodified worm");
    assert!(strokes.worm_modification > 1e-3);
}
