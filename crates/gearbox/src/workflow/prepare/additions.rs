//! What a job adds to the chain: rotation over feed and worm, the converter, the engagement, multipliers to compare with.

use super::chain::Chain;
use crate::job::{
    AddedRotation, CorrectionAxis, GearboxCompare, GearboxEngagement, GearboxJob, GearboxSplit, LeadingWorm,
    TableEnds,
};
use control::{
    AmplitudeInterpolation, Converter, Correction, CorrectionCurve, Engaging, FollowedWorm, LeadingAxis,
    PhaseLockedLoop, SolvedTable,
};
use electronic_gearbox::coupling::{EndRule, EngagementSettings, PolynomialCoupling};
use run::RunFailure;
use run::control::{control_refused, on_field};
use std::f64::consts::TAU;

/// Most cycles of an engagement: some seconds of work.
const MOST_CYCLES: f64 = 2e7;

/// Rotation that is added.
///
/// # Errors
/// [`RunFailure`] on keys of `correction`: numbers beyond what a curve can hold.
pub(super) fn corrections(given: &[AddedRotation], chain: &Chain) -> Result<Vec<Correction>, RunFailure> {
    let radians = 1.0 / chain.gear.flank_per_angle();
    let in_radians = |list: &[f64]| list.iter().map(|um| um * radians).collect::<Vec<f64>>();
    given
        .iter()
        .enumerate()
        .map(|(i, correction)| match correction {
            AddedRotation::Polynomial { coefficients_um } => {
                let curve = PolynomialCoupling::new(&in_radians(coefficients_um))
                    .map_err(|error| on_field(&error, &format!("correction.curves[{i}].coefficients_um")))?;
                Ok(Correction { axis: LeadingAxis::Feed, curve: CorrectionCurve::Polynomial(curve) })
            }
            AddedRotation::Table { axis, start, spacing, values_um, ends } => {
                let ends = match ends {
                    TableEnds::Natural => EndRule::Natural,
                    TableEnds::Periodic => EndRule::Periodic,
                };
                let axis = match axis {
                    CorrectionAxis::Feed => LeadingAxis::Feed,
                    CorrectionAxis::Worm => LeadingAxis::Worm,
                };
                let table = SolvedTable::new(*start, *spacing, in_radians(values_um), ends)
                    .map_err(|error| on_field(&error, &format!("correction.curves[{i}].values_um")))?;
                Ok(Correction { axis, curve: CorrectionCurve::Table(table) })
            }
        })
        .collect()
}

/// The converter of the voltage.
///
/// # Errors
/// [`RunFailure`] on `split`.
pub(super) fn converter(given: &GearboxSplit) -> Result<Converter, RunFailure> {
    Converter::new(given.volts_per_pulse, given.bits, 1e-3 * given.offset_mv, 1e-2 * given.gain_error_percent)
        .map_err(|error| control_refused(&error, "split"))
}

/// The worm of a job, as gearbox and servo know it.
pub(super) fn followed_worm(worm: &LeadingWorm, teeth: i32) -> FollowedWorm {
    FollowedWorm {
        threads: worm.threads,
        teeth,
        pulses: worm.pulses_per_revolution,
        speed: worm.speed_rpm / 60.0 * TAU,
    }
}

/// The engagement of a job that has a worm.
///
/// # Errors
/// [`RunFailure`] on `engagement`: one that takes too many cycles.
pub(super) fn engaging(
    given: &GearboxEngagement,
    worm: &LeadingWorm,
    job: &GearboxJob,
    chain: &Chain,
) -> Result<Engaging, RunFailure> {
    let parts = i64::from(job.workpiece.pulses_per_revolution)
        * i64::from(chain.interpolation.settings.pulses_per_interval());
    let engaging = Engaging {
        worm: followed_worm(worm, chain.teeth),
        parts,
        settings: EngagementSettings {
            phase_speed: given.phase_speed_deg_per_s,
            acceleration: given.acceleration_deg_per_s2,
            // The workpiece is one that follows.
            fine_window: f64::MAX,
            coarse_window: f64::MAX,
            fault_time: 0.0,
            standstill_speed: 0.0,
        },
        gap: given.gap_deg,
        cycle: 1e-6 * given.cycle_us,
        counter_bits: given.counter_bits,
    };
    let cycles = engaging.most_cycles();
    if cycles > MOST_CYCLES {
        return Err(RunFailure::bad_input(job::checks::contradiction(
            "the engagement takes more cycles than a run can take",
            "engagement.acceleration_deg_per_s2",
            format!("{cycles:.3e} cycles"),
            &format!("up to {MOST_CYCLES:e} cycles of engagement.cycle_us"),
            "accelerate and move faster, or take a longer cycle",
        )));
    }
    Ok(engaging)
}

/// Multipliers to compare with.
#[derive(Clone, Copy, Debug)]
pub struct Compared {
    /// A phase-locked loop.
    pub pll: Option<PhaseLockedLoop>,
    /// Interpolation of amplitudes.
    pub amplitude: Option<AmplitudeInterpolation>,
}

/// The multipliers of a job.
///
/// # Errors
/// [`RunFailure`] on `compare`.
pub(super) fn compared(given: &GearboxCompare) -> Result<Compared, RunFailure> {
    let pll = given.pll.map(|pll| PhaseLockedLoop::new(pll.bandwidth_hz, pll.damping)).transpose();
    let amplitude = given.amplitude.map(|signals| {
        AmplitudeInterpolation::new(
            1e-2 * signals.offset_percent,
            1e-2 * signals.mismatch_percent,
            signals.phase_error_deg.to_radians(),
            1e-6 * signals.delay_us,
        )
    });
    Ok(Compared {
        pll: pll.map_err(|error| control_refused(&error, "compare.pll"))?,
        amplitude: amplitude.transpose().map_err(|error| control_refused(&error, "compare.amplitude"))?,
    })
}
