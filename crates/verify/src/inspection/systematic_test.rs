//! Block `systematic_test`: which part of a deviation all teeth share.

use super::super::expected::{Expected, numbers};
use super::super::given::{Checked, number};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::each_case::each_case;
use metrology::systematic::{
    Decision, SystematicOptions, SystematicTest, systematic_test as test_systematic,
};
use serde_json::Value;

/// Block `systematic_test`. All values are micrometres, as the test works in any unit.
pub(crate) fn systematic_test(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each_case("systematic_test", block, ledger, |input, tolerances, case, ledger| {
        let mut expected = case.object("expected", ledger).ok_or("expected is missing")?;
        let readings = input.take("values_um").and_then(Value::as_array);
        let readings = readings.and_then(|rows| rows.iter().map(numbers).collect::<Option<Vec<_>>>());
        let readings = readings.ok_or("values_um: a table of numbers is needed here")?;
        let angles = match input.take("tooth_angle_deg") {
            None | Some(Value::Null) => None,
            Some(value) => Some(numbers(value).ok_or("tooth_angle_deg: a list of numbers is needed here")?),
        };
        let angles = angles.map(|list| list.into_iter().map(f64::to_radians).collect::<Vec<_>>());
        let options = SystematicOptions {
            tolerance: number(input, "tolerance_um", ledger)?,
            calibration: number(input, "u_calibration_um", ledger)?,
            dead_band: number(input, "dead_band_share", ledger)?,
            level: number(input, "level", ledger)?,
        };
        let found = test_systematic(&readings, angles.as_deref(), &options)?;
        check_test(&found, [tolerances.get("relative"), tolerances.get("p")], &mut expected, ledger)?;
        expected.finish(ledger);
        Ok(())
    });
}

fn check_test(
    found: &SystematicTest,
    [relative, p]: [f64; 2],
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let variance = &found.variance;
    expected.whole("N", i64::try_from(variance.teeth.len())?, ledger);
    expected.whole("R", i64::try_from(variance.repeats)?, ledger);
    let mut number = |key: &str, value: f64| expected.number(key, value, relative * value.abs(), ledger);
    number("mean_um", variance.mean);
    number("MS_between", variance.between);
    number("u_mean_um", found.uncertainty);
    number("t", found.t);
    number("t_quantile", found.t_quantile);
    number("limit_um", found.limit);
    expected.number("p_mean", found.p, p, ledger);
    expected.number("shrink", found.share, relative, ledger);
    if let Some(within) = &variance.within {
        let pairs = [("MS_within", within.square), ("F", within.f), ("s_tooth_um", within.tooth_deviation)];
        for (key, value) in pairs {
            expected.number(key, value, relative * value.abs(), ledger);
        }
        expected.number("p_between", within.p, p, ledger);
    }
    if let Some(harmonic) = &found.harmonic {
        let pairs = [
            ("harmonic1_um", harmonic.amplitude),
            ("harmonic1_phase_deg", harmonic.phase.to_degrees()),
            ("harmonic1_F", harmonic.f),
            ("mean_without_harmonic1_um", harmonic.mean),
        ];
        for (key, value) in pairs {
            expected.number(key, value, relative * value.abs(), ledger);
        }
        expected.number("harmonic1_p", harmonic.p, p, ledger);
        if let Some(value) = expected.take("harmonic1_removed") {
            ledger.equal(expected.case(), "harmonic1_removed", value.clone(), found.harmonic_removed.into());
        }
    }
    if let Some(value) = expected.take("correct") {
        let corrects = found.decision == Decision::Correct;
        ledger.equal(expected.case(), "correct", value.clone(), corrects.into());
    }
    Ok(())
}
