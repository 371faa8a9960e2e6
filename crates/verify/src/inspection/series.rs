//! Block `series`: statistics, capability and trend over parts.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::evaluation_case::check_each;
use metrology::inspection::{SpecificationLimits, evaluate_series};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    values: Vec<f64>,
    lower_limit: Option<f64>,
    upper_limit: Option<f64>,
}

/// Block `series`.
pub(crate) fn series(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("series", block, ledger, |input: &Input, tolerances, expected, ledger| {
        let limits = SpecificationLimits::new(input.lower_limit, input.upper_limit)?;
        let found = evaluate_series(&input.values, &limits)?;
        let (capability, trend) = (&found.capability, found.trend.as_ref());
        expected.whole("n", found.parts as i64, ledger);
        expected.whole("outside_3sigma_moving_range", found.outside.len() as i64, ledger);
        for (key, actual) in [
            ("mean", Some(found.mean)),
            ("s", Some(found.deviation)),
            ("min", Some(found.least)),
            ("max", Some(found.greatest)),
            ("sigma_moving_range", Some(found.control.sigma)),
            ("Cp", capability.cp),
            ("Cpk", capability.cpk),
            ("Cpk_lower95", capability.cpk_lower_95),
            ("outside_normal_ppm", capability.outside_share.map(|share| share * 1e6)),
            ("trend_per_part", trend.map(|trend| trend.slope)),
            ("trend_se", trend.map(|trend| trend.standard_error)),
        ] {
            let tolerance = tolerances.get("relative") * actual.unwrap_or(0.0).abs();
            expected.optional(key, actual, tolerance, ledger);
        }
        let probability = trend.and_then(|trend| trend.probability);
        expected.optional("trend_p", probability, tolerances.get("p"), ledger);
        Ok(())
    });
}
