//! Block `pitch`: single pitches of a flank.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::evaluation_case::{check_each, mm};
use metrology::inspection::{PitchDeviations, PitchEvaluation};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    fp_um: Vec<f64>,
    k: Option<usize>,
}

/// Block `pitch`: every quantity of every table.
pub(crate) fn pitch(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("pitch", block, ledger, |input: &Input, tolerances, expected, ledger| {
        let deviations = PitchDeviations::new(mm(&input.fp_um), input.fp_um.len())?;
        let found = deviations.evaluate(input.k)?;
        compare_pitch(&found, expected, [tolerances.get("um"), tolerances.get("phase_deg")], ledger);
        Ok(())
    });
}

/// Every quantity of the pitch of a flank, to tolerances in um and for the phase in degree.
pub(super) fn compare_pitch(
    found: &PitchEvaluation,
    expected: &mut Expected<'_>,
    [um, phase_deg]: [f64; 2],
    ledger: &mut Ledger,
) {
    for (key, actual) in [
        ("fp_max_um", found.single),
        ("fu_max_um", found.neighbours),
        ("Rp_um", found.single_range),
        ("Fp_um", found.total),
        ("Fpk_um", found.sector),
        ("closure_um", found.closure),
        ("harmonic1_um", found.first_harmonic.amplitude()),
    ] {
        expected.number(key, actual * 1e3, um, ledger);
    }
    for (key, actual) in
        [("k", found.sector_pitches), ("index_min", found.least_at), ("index_max", found.greatest_at)]
    {
        expected.whole(key, actual as i64, ledger);
    }
    let phase = found.first_harmonic.phase().to_degrees();
    expected.periodic("harmonic1_phase_deg", phase, 360.0, phase_deg, ledger);
}
