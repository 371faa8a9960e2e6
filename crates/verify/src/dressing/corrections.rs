//! Dressing corrections DK as the files write them: degrees for the angles, mm for the rest.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use foundation::kinematics::DressingCorrection;

const KEYS: [&str; 4] = ["d_phi_S_deg", "d_gamma_deg", "d_d_mm", "d_v_yA_mm"];

/// Degrees or millimetres of component j.
pub(super) fn in_file_units(j: usize, x: f64) -> f64 {
    if j < 2 { x.to_degrees() } else { x }
}

/// Radians or millimetres of component j.
pub(super) fn from_file_units(j: usize, x: f64) -> f64 {
    if j < 2 { x.to_radians() } else { x }
}

/// A correction that stands among the expected quantities as input.
pub(super) fn given(item: &mut Expected<'_>, ledger: &mut Ledger) -> Option<DressingCorrection> {
    given_as("DK", item, ledger)
}

/// The same under another key.
pub(super) fn given_as(
    key: &str,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Option<DressingCorrection> {
    let mut table = item.object(key, ledger)?;
    let values = KEYS.map(|key| table.given(key, ledger));
    table.finish(ledger);
    let [Some(phi), Some(gamma), Some(d), Some(v_y)] = values else { return None };
    Some([phi.to_radians(), gamma.to_radians(), d, v_y])
}

/// Compares a correction; `tolerance` gives that of component j from its expected value, in the units of the file.
pub(super) fn compare(
    item: &mut Expected<'_>,
    dk: &DressingCorrection,
    tolerance: impl Fn(usize, f64) -> f64,
    ledger: &mut Ledger,
) {
    compare_as("DK", item, dk, tolerance, ledger);
}

/// The same under another key.
pub(super) fn compare_as(
    key: &str,
    item: &mut Expected<'_>,
    dk: &DressingCorrection,
    tolerance: impl Fn(usize, f64) -> f64,
    ledger: &mut Ledger,
) {
    let Some(mut table) = item.object(key, ledger) else { return };
    for (j, key) in KEYS.into_iter().enumerate() {
        let expected = table.peek(key).and_then(serde_json::Value::as_f64).unwrap_or(f64::NAN);
        table.number(key, in_file_units(j, dk[j]), tolerance(j, expected), ledger);
    }
    table.finish(ledger);
}
