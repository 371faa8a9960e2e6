//! Block `eccentricity`: eccentricity and run-out from the pitch of both flanks.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::evaluation_case::{check_each, mm};
use foundation::geometry::Sides;
use metrology::inspection::{BallContact, Eccentricity, FlankAngles, eccentricity, run_out_from_pitch};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    teeth: usize,
    alpha_t_deg: f64,
    half_tooth_angle_deg: f64,
    reference_diameter_mm: f64,
    ball_circle_mm: f64,
    #[serde(rename = "alpha_K_deg")]
    ball_pressure_angle_deg: f64,
    #[serde(rename = "Fp_left_um")]
    left_um: Vec<f64>,
    #[serde(rename = "Fp_right_um")]
    right_um: Vec<f64>,
}

/// Block `eccentricity`.
pub(crate) fn eccentricity_and_run_out(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("eccentricity", block, ledger, |input: &Input, tolerances, expected, ledger| {
        let um = tolerances.get("um");
        let cumulative = Sides { left: mm(&input.left_um), right: mm(&input.right_um) };
        ledger.equal(expected.case(), "teeth", input.teeth.into(), cumulative.left.len().into());
        let flanks = FlankAngles {
            pressure_angle: input.alpha_t_deg.to_radians(),
            half_tooth_angle: input.half_tooth_angle_deg.to_radians(),
        };
        let found = eccentricity(&cumulative, &flanks)?;
        if let Some(mut expected) = expected.object("eccentricity", ledger) {
            compare_eccentricity(&found, &mut expected, [um, um], ledger);
            expected.finish(ledger);
        }
        let ball = BallContact {
            reference_diameter: input.reference_diameter_mm,
            centre_diameter: input.ball_circle_mm,
            pressure_angle: input.ball_pressure_angle_deg.to_radians(),
            internal: false,
        };
        let run_out = run_out_from_pitch(&cumulative, &ball)?;
        let of_space: Vec<f64> = run_out.of_space.iter().map(|x| x * 1e3).collect();
        expected.list("runout_um", &of_space, um, ledger);
        expected.number("Fr_um", run_out.total * 1e3, um, ledger);
        Ok(())
    });
}

/// Every quantity of an eccentricity, to tolerances in um and for its direction in degree.
pub(super) fn compare_eccentricity(
    found: &Eccentricity,
    expected: &mut Expected<'_>,
    [um, direction_deg]: [f64; 2],
    ledger: &mut Ledger,
) {
    let without = found.total_without();
    for (key, actual) in [
        ("e_x_um", found.x),
        ("e_y_um", found.y),
        ("e_um", found.amount()),
        ("Fp_left_without_um", without.left),
        ("Fp_right_without_um", without.right),
    ] {
        expected.number(key, actual * 1e3, um, ledger);
    }
    expected.periodic("e_angle_deg", found.direction().to_degrees(), 360.0, direction_deg, ledger);
}
