//! Block `k_band`: traces between limits.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::evaluation_case::{check_each, deviations_mm, flag, mm};
use metrology::inspection::{BandFit, InspectionError, KBand, TraceSamples};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    abscissa_mm: Vec<f64>,
    f_um: Vec<Option<f64>>,
    band_abscissa_mm: Vec<f64>,
    band_lower_um: Vec<f64>,
    band_upper_um: Vec<f64>,
    mode: Mode,
    reference_mm: Option<f64>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Mode {
    Free,
    Fixed,
}

impl Input {
    fn fit(&self) -> Result<BandFit, InspectionError> {
        match (self.mode, self.reference_mm) {
            (Mode::Free, _) => Ok(BandFit::Free),
            (Mode::Fixed, Some(zero)) => Ok(BandFit::Fixed(zero)),
            (Mode::Fixed, None) => {
                Err(InspectionError::WrongCount { field: "reference_mm", found: 0, needed: 1 })
            }
        }
    }
}

/// Block `k_band`: shift, margin and verdict.
pub(crate) fn k_band(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("k_band", block, ledger, |input: &Input, tolerances, expected, ledger| {
        let band = KBand::new(&input.band_abscissa_mm, &mm(&input.band_lower_um), &mm(&input.band_upper_um))?;
        let trace = TraceSamples::new(input.abscissa_mm.clone(), deviations_mm(&input.f_um))?;
        let verdict = band.judge(&trace, input.fit()?)?;
        expected.number("shift_um", verdict.shift * 1e3, tolerances.get("um"), ledger);
        expected.number("margin_um", verdict.margin * 1e3, tolerances.get("um"), ledger);
        flag(expected, "passed", verdict.passed(), ledger);
        expected.number("worst_at_mm", verdict.worst_at, tolerances.get("mm"), ledger);
        Ok(())
    });
}
