//! Block `measurement`: real tools at the light barrier, from the angles to the correction of the setting.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, text};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::band::check_band;
use super::evaluation::{check_corrections, check_evaluation};
use super::example::{SkivingExample, beam};
use super::noise::check_noise;
use foundation::geometry::{Flank, Sides};
use serde::Deserialize;
use serde_json::Value;
use skiving::evaluation::{Deviations, measured_tool};
use skiving::measuring::{
    BarrierData, Beam, EdgeErrors, FlankTracks, Noise, RealTool, Sense, Switches, first_order_deviation,
    readings, switches,
};

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

/// A tool in front of its beam.
pub(super) struct Measured {
    pub example: SkivingExample,
    pub beam: Beam,
    pub tool: RealTool,
    pub flanks: Sides<FlankTracks>,
    pub first_order: Deviations,
    pub deviations: Deviations,
}

impl Measured {
    /// Measures a tool without noise in the positive sense.
    pub fn new(example: SkivingExample, beam: Beam, tool: RealTool) -> Checked<(Self, Switches)> {
        tool.check(example.teeth())?;
        let flanks = example.flanks(&beam)?;
        let data = BarrierData::ideal();
        let switched = switches(&flanks, &beam, &data, &tool)?;
        let seen = readings(&flanks, &switched, &data, &[Sense::Positive], 1, &mut Noise::new(0));
        let deviations = measured_tool(&flanks, &seen, 0.0)?.deviations;
        let first_order = deviations.map(|flank, track, tooth, _| {
            first_order_deviation(&flanks[flank].edge, &tool, &flanks[flank].tracks[track].0, tooth)
        });
        Ok((Self { example, beam, tool, flanks, first_order, deviations }, switched))
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
