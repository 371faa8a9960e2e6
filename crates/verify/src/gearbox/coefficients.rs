//! Blocks `coefficients` and `couplings`: what gear data make of the gearbox.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::check_each;
use electronic_gearbox::Sign;
use electronic_gearbox::coefficient::{Coefficient, CouplingSigns, Couplings, GearGeometry};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CoefficientInput {
    m_n_mm: f64,
    z: i32,
    beta_deg: f64,
    alpha_n_deg: f64,
    pulses_per_rev: u32,
    q_per_m: f64,
}

/// Block `coefficients`.
pub(crate) fn coefficients(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let tolerances = ["tolerance_rel", "tolerance_b_error_abs"];
    check_each(
        "coefficients",
        block,
        tolerances,
        ledger,
        |input: &CoefficientInput, tolerances, expected, ledger| {
            let [relative, of_error] = tolerances;
            let (beta, alpha) = (input.beta_deg.to_radians(), input.alpha_n_deg.to_radians());
            let gear = GearGeometry::new(input.m_n_mm, input.z, beta, alpha)?;
            let coefficient = Coefficient::new(&gear, input.pulses_per_rev, input.q_per_m, Sign::Plus)?;
            // A spur gear has coefficients but no lead.
            let lead = match gear.lead() {
                Err(error) if expected.peek("error").is_some() => return Err(error.into()),
                lead => lead.ok(),
            };
            let tolerance = |x: f64| relative * x.abs();
            expected.optional("lead_mm", lead, tolerance(lead.unwrap_or(f64::NAN)), ledger);
            for (key, actual) in [
                ("b", coefficient.exact()),
                ("flank_um_per_rad", gear.flank_per_angle()),
                ("flank_um_per_um_axial", gear.flank_per_axial()),
                ("flank_um_per_work_pulse", gear.flank_per_work_pulse(input.pulses_per_rev)?),
            ] {
                expected.number(key, actual, tolerance(actual), ledger);
            }
            expected.whole("B18", coefficient.word().into(), ledger);
            expected.whole("hand", coefficient.hand().as_i64(), ledger);
            expected.number("b_error_rel", coefficient.relative_error(), of_error, ledger);
            Ok(())
        },
    );
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CouplingInput {
    z1: u32,
    z2: i32,
    m_n_mm: f64,
    beta1_deg: f64,
    beta2_deg: f64,
}

/// Block `couplings`.
pub(crate) fn couplings(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each(
        "couplings",
        block,
        ["tolerance_rel"],
        ledger,
        |input: &CouplingInput, [relative], expected, ledger| {
            let workpiece = gear_without_profile(input.m_n_mm, input.z2, input.beta2_deg)?;
            let worm = input.beta1_deg.to_radians();
            let couplings = Couplings::new(&workpiece, input.z1, worm, CouplingSigns::default())?;
            for (key, actual) in [
                ("dC_dB", couplings.worm_turn),
                ("dC_dZ_deg_per_mm", couplings.feed),
                ("dC_dV_deg_per_mm", couplings.shift),
            ] {
                expected.number(key, actual, relative * actual.abs(), ledger);
            }
            Ok(())
        },
    );
}

/// A gear of which only module, teeth and helix are given: rotations do not depend on the pressure angle.
pub(super) fn gear_without_profile(
    normal_module_mm: f64,
    teeth: i32,
    helix_angle_deg: f64,
) -> Result<GearGeometry, electronic_gearbox::Error> {
    const PRESSURE_ANGLE_DEG: f64 = 20.0;
    GearGeometry::new(normal_module_mm, teeth, helix_angle_deg.to_radians(), PRESSURE_ANGLE_DEG.to_radians())
}
