//! Block `error_budget`.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::check_each;
use control::{BudgetInput, ErrorBudget};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    #[serde(rename = "P")]
    multiplier: u32,
    f1_hz: f64,
    q_per_m: f64,
    v_mm_s: f64,
    v_min_mm_s: Option<f64>,
    a_mm_s2: f64,
    alpha_n_deg: f64,
    beta_deg: f64,
}

/// Block `error_budget`: every part of every budget.
pub(crate) fn error_budget(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each(
        "error_budget",
        block,
        ["tolerance_rel"],
        ledger,
        |input: &Input, [relative], expected, ledger| {
            let budget = ErrorBudget::new(&BudgetInput {
                multiplier: input.multiplier,
                clock: input.f1_hz,
                pulses_per_metre: input.q_per_m,
                speed: input.v_mm_s,
                least_speed: input.v_min_mm_s,
                acceleration: input.a_mm_s2,
                normal_pressure_angle: input.alpha_n_deg.to_radians(),
                helix_angle: input.beta_deg.to_radians(),
            })?;
            for (key, actual) in [
                ("pitch_mm", budget.pitch),
                ("quantisation_mm", budget.quantisation),
                ("truncation_mm", budget.truncation),
                ("sync_mm", budget.synchronisation),
                ("acceleration_mm", budget.acceleration),
                ("total_mm", budget.total),
                ("flank_um", budget.flank_um),
                ("v_max_mm_s", budget.greatest_speed),
            ] {
                expected.number(key, actual, relative * actual.abs(), ledger);
            }
            Ok(())
        },
    );
}
