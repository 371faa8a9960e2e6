//! What is expected of the whole gear: pitch, thickness, run-out and eccentricity, against the evaluation of the files.

use super::super::super::expected::Expected;
use super::super::super::ledger::Ledger;
use super::super::eccentricity::compare_eccentricity;
use super::super::evaluation_case::mm;
use super::super::pitch::compare_pitch;
use super::{Allowed, EvaluatedGear};
use foundation::geometry::Flank;
use foundation::numerics::extremes;
use measured_files::inspection::Inspection;

/// Compares every quantity of the gear that the file expects; one that the files do not give fails.
pub(super) fn compare(
    inspection: &Inspection,
    found: &EvaluatedGear,
    allowed: &Allowed,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    pitch(found, allowed, expected, ledger);
    from_positions(found, allowed, expected, ledger);
    run_out(inspection, found, allowed, expected, ledger);
    let x = allowed.mm() / inspection.gear.normal_module_mm;
    let of_pitch = found.pitch.as_ref();
    for (key, actual, tolerance) in [
        ("Rs_um", of_pitch.and_then(|pitch| pitch.thickness_variation).map(|mm| mm * 1e3), allowed.um),
        ("x_from_span", found.thickness.by_span, x),
        ("x_from_balls", found.thickness.by_balls, x),
        ("MdK_from_span_mm", found.over_balls_by_span, allowed.mm()),
    ] {
        expected.number(key, actual.unwrap_or(f64::NAN), tolerance, ledger);
    }
    if let Some(mut expected) = expected.object("eccentricity", ledger) {
        match of_pitch.and_then(|pitch| pitch.eccentricity.as_ref()) {
            Some(found) => {
                let tolerances = [allowed.um, allowed.direction_deg(found.amount())];
                compare_eccentricity(found, &mut expected, tolerances, ledger);
            }
            None => expected.refused(&"the files do not give the pitch of both flanks", ledger),
        }
        expected.finish(ledger);
    }
}

fn pitch(found: &EvaluatedGear, allowed: &Allowed, expected: &mut Expected<'_>, ledger: &mut Ledger) {
    let Some(mut expected) = expected.object("pitch", ledger) else { return };
    for flank in Flank::BOTH {
        let Some(mut expected) = expected.object(flank.name(), ledger) else { continue };
        match found.pitch.as_ref().and_then(|pitch| pitch.flanks[flank].as_ref()) {
            Some(found) => {
                let amplitude = found.first_harmonic.amplitude();
                let tolerances = [allowed.um, allowed.direction_deg(amplitude)];
                compare_pitch(found, &mut expected, tolerances, ledger);
            }
            None => expected.refused(&"the files do not give the pitch of this flank", ledger),
        }
        expected.finish(ledger);
    }
    expected.finish(ledger);
}

/// Pitch from the positions of the probe, and how far it is from the table of the file.
fn from_positions(
    found: &EvaluatedGear,
    allowed: &Allowed,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let Some(mut expected) = expected.object("from_positions", ledger) else { return };
    for flank in Flank::BOTH {
        let Some(mut expected) = expected.object(flank.name(), ledger) else { continue };
        let pitch = found.pitch.as_ref();
        match pitch.and_then(|pitch| pitch.from_positions.as_ref().zip(pitch.flanks[flank].as_ref())) {
            Some((sides, table)) => {
                let cumulative = sides[flank].cumulative();
                // Both lists are 0 at the last tooth: what they differ by there is in all others.
                let apart = without_mean(&difference(&cumulative, &table.cumulative));
                for (key, actual) in
                    [("Fp_um", range(&cumulative)), ("max_difference_to_table_um", largest(&apart))]
                {
                    expected.number(key, actual * 1e3, allowed.um, ledger);
                }
            }
            None => expected.refused(&"the files do not give positions and table of this flank", ledger),
        }
        expected.finish(ledger);
    }
    expected.finish(ledger);
}

/// Run-out as the file lists it, as the pitch means it, and how far the two are apart at any space.
fn run_out(
    inspection: &Inspection,
    found: &EvaluatedGear,
    allowed: &Allowed,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let listed = inspection.run_out.as_ref().map(|run_out| mm(&run_out.fr_um));
    let by_pitch = found.pitch.as_ref().and_then(|pitch| pitch.run_out.as_ref());
    let apart = by_pitch.zip(listed.as_ref());
    let apart = apart.map(|(found, listed)| largest(&difference(&found.of_space, listed)));
    for (key, actual) in [
        ("Fr_um", listed.as_deref().map(range)),
        ("Fr_from_pitch_um", by_pitch.map(|found| found.total)),
        ("Fr_from_pitch_max_difference_um", apart),
    ] {
        expected.number(key, actual.map_or(f64::NAN, |mm| mm * 1e3), allowed.um, ledger);
    }
}

/// a - b at every tooth; nothing for lists of different lengths.
fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    if a.len() == b.len() { a.iter().zip(b).map(|(a, b)| a - b).collect() } else { Vec::new() }
}

fn without_mean(values: &[f64]) -> Vec<f64> {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter().map(|x| x - mean).collect()
}

/// Largest size; NaN of nothing and if a value is NaN.
fn largest(values: &[f64]) -> f64 {
    if values.is_empty() || values.iter().any(|x| x.is_nan()) {
        return f64::NAN;
    }
    values.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

/// Greatest less least; NaN if a value is NaN.
fn range(values: &[f64]) -> f64 {
    if values.iter().any(|x| x.is_nan()) {
        return f64::NAN;
    }
    let [least, greatest] = extremes(values.iter().copied());
    greatest - least
}
