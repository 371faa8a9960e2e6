//! Random gears with random cutters: no ray is gouged deeper than was predicted, and what cannot be milled is refused by name.

use super::job;
use foundation::numerics::Silent;
use milling::workflow::run_milling;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use run::RunFailure;

/// Deepest gouge below the prediction, um, and most stock above it.
const DEEPER_UM: f64 = 1e-3;
const OFF_UM: f64 = 0.02;
/// Rays of the 85 on a flank that the referee may leave without proof.
const UNPROVEN: usize = 1;

/// Shares of the module by which cutters and contact heights are chosen.
type Shares = [f64; 4];

/// `[cutter]`, `[milling]` and `[simulation]` for teeth of this module: shares for diameter, corner, contact height and distance.
fn cutting(module: f64, ball: bool, lines: [usize; 2], shares: Shares) -> String {
    let diameter = module * (0.2 + 0.2 * shares[0]);
    let corner = diameter * (0.05 + 0.35 * shares[1]);
    let height = corner + module * shares[2];
    let safety = module * 0.02 * shares[3];
    let length = 4.0 * module;
    let [rows, columns] = lines;
    let (shape, contact) = if ball {
        (r#"shape = "ball""#.to_owned(), format!("tilt_deg = {:?}", 6.0 + 10.0 * shares[1]))
    } else {
        (format!("shape = \"end-mill\"\ncorner_radius = {corner:?}"), format!("contact_height = {height:?}"))
    };
    format!(
        "[target]\ntolerance_um = 1000.0\n\n[cutter]\n{shape}\ndiameter = {diameter:?}\ncutting_length = {length:?}\n\n\
         [milling]\nrows = {rows}\ncolumns = {columns}\n{contact}\nsafety_distance = {safety:?}\nfeed_mm_per_min = 500.0\n\
         spindle_rpm = 10000.0\n\n[simulation]\nrays_profile = 17\nrays_length = 5\n"
    )
}

const HEAD: &str = "[job]\nname = \"random\"\nprocess = \"five-axis-milling\"\n\n";

fn shares() -> impl Strategy<Value = Shares> {
    prop::array::uniform4(0.0..1.0f64)
}

/// Spur and helical gears.
fn cylindrical() -> impl Strategy<Value = String> {
    let helix = prop_oneof![Just(0.0), -30.0..-5.0f64, 5.0..30.0f64];
    let drawing = (14..45i32, 2.0..8.0f64, helix, 18.0..25.0f64, -0.2..0.4f64);
    let lines = [6..12usize, 4..10usize];
    (drawing, any::<bool>(), any::<bool>(), lines, shares()).prop_map(
        |(drawing, ball, root, lines, shares)| {
            let (teeth, module, helix, angle, shift) = drawing;
            let pitch = module * f64::from(teeth) / helix.to_radians().cos();
            let transverse = (angle.to_radians().tan() / helix.to_radians().cos()).atan();
            let (tip, dedendum) =
                (pitch + 2.0 * module * (1.0 + shift), pitch - 2.0 * module * (1.25 - shift));
            let form = (pitch * transverse.cos() * 1.01).max(pitch - 1.8 * module * (1.0 - shift));
            let width = module * (1.0 + shares[3]);
            let gear = format!(
                "[gear]\nteeth = {teeth}\nnormal_module = {module:?}\nnormal_pressure_angle_deg = {angle:?}\n\
             helix_angle_deg = {helix:?}\nprofile_shift = {shift:?}\nface_width = {width:?}\n\
             tip_diameter = {tip:?}\nroot_diameter = {dedendum:?}\nform_diameter = {form:?}\n\n"
            );
            let root =
                if root && !ball { "\n[milling.root]\nbottom = 0.0\nbottom_pass = false\n" } else { "" };
            format!("{HEAD}{gear}{}{root}", cutting(module, ball, lines, shares))
        },
    )
}

/// Straight bevel gears.
fn conical() -> impl Strategy<Value = String> {
    let lines = [6..10usize, 4..8usize];
    (14..30u32, 2.0..8.0f64, 20.0..70.0f64, any::<bool>(), lines, shares()).prop_map(
        |(teeth, module, pitch, ball, lines, shares)| {
            let outer = 0.5 * module * f64::from(teeth) / pitch.to_radians().sin();
            let width = (module * (1.0 + shares[3])).min(0.3 * outer);
            let gear = format!(
                "[bevel]\nouter_transverse_module = {module:?}\nteeth = {teeth}\npitch_cone_angle_deg = {pitch:?}\n\
                 pressure_angle_deg = 20.0\nface_width = {width:?}\n\n"
            );
            // The space is narrower at the small end.
            format!("{HEAD}{gear}{}", cutting(0.7 * module, ball, lines, shares))
        },
    )
}

/// Mills the job and compares its rays with their prediction; a refusal is another case.
fn mills(text: &str) -> Result<(), TestCaseError> {
    let outcome = match run_milling(&job(text), &Silent) {
        Ok(outcome) => outcome,
        Err(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => {
            prop_assert!(!finding.code.is_empty() && finding.way_out.is_some(), "{:?}\n{}", finding, text);
            return Err(TestCaseError::reject(finding.code));
        }
    };
    prop_assert_eq!(outcome.result.flanks.len(), 2);
    for (side, flank) in &outcome.result.flanks {
        // A ray through the seam of side and corner may be left without proof by the referee.
        let unproven = flank.unmilled.get("it only grazes a cutter").copied().unwrap_or(0);
        let unmilled: usize = flank.unmilled.values().sum();
        prop_assert!(unmilled == unproven && unproven <= UNPROVEN, "{} {:?}\n{}", side, flank.unmilled, text);
        for (found, planned) in flank.simulated_um.iter().zip(&flank.planned_um) {
            let Some(planned) = planned else {
                return Err(TestCaseError::fail(format!("{side}: a ray without a prediction\n{text}")));
            };
            let Some(found) = found else { continue };
            // Less stock than predicted is no gouge.
            let deeper = planned.min(0.0) - found.min(0.0);
            prop_assert!(deeper < DEEPER_UM, "{}: {} is below {}\n{}", side, found, planned, text);
            prop_assert!(found - planned < OFF_UM, "{}: {} is above {}\n{}", side, found, planned, text);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn cylindrical_gears_are_milled_as_predicted(text in cylindrical()) {
        mills(&text)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bevel_gears_are_milled_as_predicted(text in conical()) {
        mills(&text)?;
    }
}
