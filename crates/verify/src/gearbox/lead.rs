//! Block `ratio_of_lead`: fractions for a ratio that is none.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{check_each, require_exact};
use super::coefficients::gear_without_profile;
use super::numbers::{Decimal, Whole};
use electronic_gearbox::coupling::{best_rational, dyadic};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    m_n_mm: Decimal,
    z: i32,
    beta_deg: Decimal,
}

/// The files' limit for denominators of best fractions.
const GREATEST_DENOMINATOR: i64 = 1_000_000;

/// Block `ratio_of_lead`.
pub(crate) fn ratio_of_lead(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let tolerances = ["tolerance_n_rel", "tolerance_rational", "tolerance_rational_error_rel"];
    check_each("ratio_of_lead", block, tolerances, ledger, |input: &Input, tolerances, expected, ledger| {
        let [relative, of_fraction, of_error] = tolerances;
        let gear = gear_without_profile(input.m_n_mm.0, input.z, input.beta_deg.0)?;
        let ratio = 360.0 * gear.turns_per_millimetre();
        let (binary, best) = (dyadic(ratio)?, best_rational(ratio, GREATEST_DENOMINATOR)?);
        let case = expected.case().to_owned();
        // Of the 30 digits a floating number holds 16; n, which is made from it, has the same relative tolerance.
        let key = "dC_dZ_deg_per_mm_30_digits";
        if let Some(value) = expected.take(key) {
            match Decimal::of(value) {
                Some(Decimal(wanted)) => ledger.number(&case, key, wanted, ratio, relative * wanted.abs()),
                None => ledger.fail(&case, key, value.clone(), ratio.into()),
            }
        }
        if let Some(value) = expected.take("n") {
            match Whole::of(value) {
                // As a difference of integers: both have more digits than a floating number.
                Some(Whole(wanted)) => {
                    let apart = i128::from(binary.numerator()) - i128::from(wanted);
                    let tolerance = relative * (wanted as f64).abs();
                    ledger.number(&case, "n less the expected one", 0.0, apart as f64, tolerance);
                }
                None => ledger.fail(&case, "n", value.clone(), binary.numerator().into()),
            }
        }
        expected.whole("shift", binary.shift().into(), ledger);
        // A power of two; reading the number rounds in its last digit.
        let bound = binary.error_bound();
        expected.number("error_abs_upper", bound, f64::EPSILON * bound, ledger);
        require_exact(&case, of_fraction, ledger);
        expected.whole("rational_num", best.ratio().numerator(), ledger);
        expected.whole("rational_den", best.ratio().denominator(), ledger);
        let error = best.error().abs();
        expected.number("rational_error", error, of_error * error, ledger);
        Ok(())
    });
}
