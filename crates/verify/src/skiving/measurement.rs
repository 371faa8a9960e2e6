//! Block `measurement`: real tools at the light barrier, from the angles to the correction of the setting.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, text};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::band::check_band;
use super::evaluation::{check_corrections, check_evaluation};
use super::example::{SkivingExample, beam};
use super::measured::Measured;
use super::noise::check_noise;
use foundation::geometry::{Flank, Sides};
use serde::Deserialize;
use serde_json::Value;
use skiving::evaluation::Deviations;
use skiving::measuring::{EdgeErrors, RealTool};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RealToolInput {
    pitch_rad: Vec<f64>,
    profile_coeff_mm: SidesInput,
    drho_coeff_mm: SidesInput,
    ecc_mm: [f64; 2],
    tilt_rad: [f64; 2],
}

/// Coefficients of every tooth.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SidesInput {
    left: Vec<Vec<f64>>,
    right: Vec<Vec<f64>>,
}

impl RealToolInput {
    fn tool(self) -> RealTool {
        let edges = |profile: Vec<Vec<f64>>, growth: Vec<Vec<f64>>| {
            profile.into_iter().zip(growth).map(|(profile, growth)| EdgeErrors { profile, growth }).collect()
        };
        RealTool {
            broken: vec![false; self.pitch_rad.len()],
            pitch: self.pitch_rad,
            edges: Sides {
                left: edges(self.profile_coeff_mm.left, self.drho_coeff_mm.left),
                right: edges(self.profile_coeff_mm.right, self.drho_coeff_mm.right),
            },
            eccentricity: self.ecc_mm,
            wobble: self.tilt_rad,
        }
    }
}

/// Block `measurement`.
pub(crate) fn measurement(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_array() else {
        return ledger.fail("measurement", "", block.clone(), "a list is needed here".into());
    };
    for item in list {
        let name = format!("measurement {}", item["example"].as_str().unwrap_or_default());
        let expected = Expected::new(&name, "", item, ledger);
        check_object(expected, ledger, |expected, ledger| check_item(reference, expected, ledger));
    }
}

fn check_item(reference: &Reference<'_>, expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    let example = SkivingExample::named(reference, text(expected, "example", ledger)?)?;
    let beam = beam(expected.take("beam").ok_or("beam is missing")?)?;
    let tool = RealToolInput::deserialize(expected.take("real_tool").ok_or("real_tool is missing")?)?.tool();
    let (measured, switched) = Measured::new(example, beam, tool)?;
    let tolerances = reference.tolerances();
    let radians = tolerances.get("trigger_angle_rad");
    let angles = measured
        .deviations
        .map(|flank, track, tooth, _| switched[flank][track][0][tooth].unwrap_or(f64::NAN));
    check_sides(expected, "trigger_angle_rad", &angles, radians, ledger);
    let um = |deviations: &Deviations| deviations.map(|_, _, _, f| 1e3 * f);
    check_sides(
        expected,
        "deviation_f_um",
        &um(&measured.deviations),
        tolerances.get("deviation_um"),
        ledger,
    );
    let truth = tolerances.get("first_order_truth_um");
    check_sides(expected, "first_order_truth_um", &um(&measured.first_order), truth, ledger);
    // What a measurement finds stands beside what was injected.
    let apart = tolerances.get("first_order_vs_trigger_um");
    for ((flank, track, tooth, found), (.., injected)) in
        measured.deviations.iter().zip(measured.first_order.iter())
    {
        let quantity = format!("deviation against first order.{flank}[{track}][{tooth}]");
        ledger.number(expected.case(), &quantity, 1e3 * injected, 1e3 * found, apart);
    }
    let evaluation = check_evaluation(&tolerances, &measured, expected, ledger)?;
    check_corrections(&tolerances, &measured, &evaluation, expected, ledger)?;
    check_noise(&tolerances, &measured, expected, ledger)?;
    check_band(&tolerances, &measured, expected, ledger)
}

/// Compares a number for every flank, track and tooth.
fn check_sides(
    expected: &mut Expected<'_>,
    key: &str,
    actual: &Deviations,
    tolerance: f64,
    ledger: &mut Ledger,
) {
    let Some(mut object) = expected.object(key, ledger) else { return };
    for flank in Flank::BOTH {
        let rows = actual.of[flank].concat();
        object.table(flank.name(), (&rows, actual.teeth()), tolerance, ledger);
    }
    object.finish(ledger);
}
