//! Block `twist_from_traces`: twist by slopes of two profiles and of two leads.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::evaluation_case::check_each;
use foundation::geometry::Flank;
use metrology::inspection::{PlacedSlope, SlopeReference, SlopeRule, SlopeSign, trace_twist};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    #[serde(rename = "fHalpha_low_um")]
    profile_low_um: f64,
    #[serde(rename = "fHalpha_high_um")]
    profile_high_um: f64,
    z_low_mm: f64,
    z_high_mm: f64,
    #[serde(rename = "L_b_mm")]
    helix_length_mm: f64,
    #[serde(rename = "fHbeta_inner_um")]
    lead_inner_um: f64,
    #[serde(rename = "fHbeta_outer_um")]
    lead_outer_um: f64,
    w_inner_mm: f64,
    w_outer_mm: f64,
    #[serde(rename = "L_a_mm")]
    profile_length_mm: f64,
}

/// Block `twist_from_traces`.
pub(crate) fn twist_from_traces(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("twist_from_traces", block, ledger, |input: &Input, tolerances, expected, ledger| {
        let placed = |position: f64, um: f64, length: f64| {
            let reference = SlopeReference::Given(length);
            let rule = SlopeRule { flank: Flank::Left, sign: SlopeSign::Material, reference };
            PlacedSlope { position, slope: rule.slope(um * 1e-3 / length, length) }
        };
        let field = [input.profile_length_mm, input.helix_length_mm];
        let twist = trace_twist(
            [
                placed(input.z_low_mm, input.profile_low_um, field[0]),
                placed(input.z_high_mm, input.profile_high_um, field[0]),
            ],
            [
                placed(input.w_inner_mm, input.lead_inner_um, field[1]),
                placed(input.w_outer_mm, input.lead_outer_um, field[1]),
            ],
            field,
        )?;
        expected.number("S_alpha_um", twist.by_profiles * 1e3, tolerances.get("um"), ledger);
        expected.number("S_beta_um", twist.by_leads * 1e3, tolerances.get("um"), ledger);
        Ok(())
    });
}
