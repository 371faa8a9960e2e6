//! A measurement with latency, jitter, noise, hysteresis and steps: the records themselves and what averaging leaves of them.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object};
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::measured::Measured;
use foundation::geometry::Flank;
use foundation::numerics::{extremes, root_mean_square};
use serde::Deserialize;
use skiving::evaluation::measured_tool;
use skiving::measuring::{BarrierData, Noise, Sense, readings, switches};
use std::f64::consts::TAU;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct NoiseInput {
    rpm: f64,
    latency_s: f64,
    jitter_s: f64,
    beam_noise_mm: f64,
    encoder_step_deg: f64,
    revolutions: usize,
    #[serde(rename = "seed")]
    start: u64,
    hysteresis_mm: f64,
}

/// Compares a noisy measurement, if the file has one.
pub(super) fn check_noise(
    tolerances: &Tolerances<'_>,
    measured: &Measured,
    outer: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let Some(expected) = outer.object("noise", ledger) else { return Ok(()) };
    check_object(expected, ledger, |expected, ledger| {
        let input = NoiseInput::deserialize(expected.take("config").ok_or("config is missing")?)?;
        let data = BarrierData {
            speed: input.rpm * TAU / 60.0,
            latency: input.latency_s,
            jitter: input.jitter_s,
            beam_noise: input.beam_noise_mm,
            hysteresis: input.hysteresis_mm,
            encoder_step: input.encoder_step_deg.to_radians(),
        };
        let flanks = &measured.flanks;
        let switched = switches(flanks, &measured.beam, &data, &measured.tool)?;
        let seen =
            readings(flanks, &switched, &data, &Sense::BOTH, input.revolutions, &mut Noise::new(input.start));
        let first: Vec<f64> = seen.iter().take(measured.tool.teeth()).map(|reading| reading.angle).collect();
        let radians = tolerances.get("noise_record_rad");
        expected.list("first_record_left_track0_sense_plus_rad", &first, radians, ledger);
        let found = measured_tool(flanks, &seen, 0.0)?;
        // The file judges by what was put in, to the first order.
        let errors: Vec<f64> = found
            .deviations
            .iter()
            .zip(measured.first_order.iter())
            .map(|(a, b)| 1e3 * (a.3 - b.3))
            .collect();
        let rms = root_mean_square(&errors);
        let um = tolerances.get("noise_rms_um");
        expected.number("rms_error_um", rms, um, ledger);
        expected.number("max_error_um", extremes(errors.iter().map(|x| x.abs()))[1], um, ledger);
        let differences = found.sense_difference.ok_or("both senses are needed")?;
        let differences: Vec<f64> =
            Flank::BOTH.iter().flat_map(|&flank| differences[flank].iter().map(|x| 1e3 * x)).collect();
        expected.list("mean_difference_minus_plus_um", &differences, um, ledger);
        // The file leaves the encoder's step out of the figure, which `docs/mathematics/skiving.md#light-barrier` has in it.
        let without_step = BarrierData { encoder_step: 0.0, ..data };
        let single = without_step.single_deviation(flanks.left.tracks[0].0.contact.lever);
        expected.number("single_shot_sigma_um", 1e3 * single, um, ledger);
        Ok(())
    });
    Ok(())
}
