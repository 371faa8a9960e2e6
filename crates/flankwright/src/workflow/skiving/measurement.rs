//! A measured tool: readings of a simulated one or from a file, their evaluation, the correction that answers them.

use super::finding::{failure, of_readings};
use super::prepare::SkivingBodies;
use super::resharpening::Resharpening;
use crate::exchange::Diagnostic;
use crate::exchange::skiving_job::SkivingJob;
use crate::geometry::Sides;
use crate::numerics::root_mean_square;
use crate::process::skiving::evaluation::{
    Deviations, Evaluation, MeasuredTool, Repeated, correction, evaluate, measured_tool, tool_as_measured,
};
use crate::process::skiving::measuring::{
    BarrierData, Noise, Reading, RealTool, Sense, Switches, nominal_angle, readings, switches,
};
use crate::process::skiving::wear::{GrowthOptions, ToothPositions, WearError, edge_growths, regrind};
use crate::process::skiving::{MeasuringTrack, SettingFit, SkivingError};
use crate::workflow::finding::RunFailure;

/// Standard deviation of a growth up to which it is told from a shift of the edge, mm.
const GROWTH_RESOLUTION: f64 = 2e-3;
/// What a linear evaluation is off where nothing scatters (spec 60 section 15), mm.
const LEAST_SIGMA: f64 = 3e-5;

/// A measured tool with all that follows from it.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// What the control wrote down.
    pub readings: Vec<Reading>,
    /// Deviations.
    pub measured: MeasuredTool,
    /// Pitch, mounting, profile, wear.
    pub evaluation: Evaluation,
    /// Change of the machine's setting.
    pub correction: SettingFit,
    /// What grinding the tool again has to take off.
    pub resharpening: Resharpening,
    /// Where the tool switches without noise; of a real tool as its deviations tell.
    pub switches: Switches,
    /// The tool, if it is simulated.
    pub tool: Option<RealTool>,
    /// The tool as its deviations tell it: what the referee takes where nothing else is known.
    pub as_measured: RealTool,
    /// f of the simulated tool without noise, delay and hysteresis: what prediction and referee are compared by.
    pub noiseless: Option<Deviations>,
}

/// Measures a tool with known errors.
///
/// # Errors
/// [`RunFailure`]: a tooth that cannot be measured, or is missing.
pub(super) fn simulated(
    job: &SkivingJob,
    bodies: &SkivingBodies,
    tool: RealTool,
) -> Result<Measurement, RunFailure> {
    let on = |error: SkivingError| failure(&error);
    tool.check(bodies.teeth()).map_err(on)?;
    let measuring = &job.measuring;
    let switched = switches(&bodies.flanks, &bodies.beam, &bodies.barrier, &tool).map_err(on)?;
    let mut noise = Noise::new(measuring.seed);
    let seen = readings(
        &bodies.flanks,
        &switched,
        &bodies.barrier,
        measuring.senses.list(),
        measuring.revolutions,
        &mut noise,
    );
    let measured = measured_tool(&bodies.flanks, &seen, bodies.radius_offset).map_err(on)?;
    let noiseless = noiseless(bodies, &tool).map_err(on)?;
    let measurement = Measurement::of(bodies, seen, measured, switched)?;
    Ok(Measurement { tool: Some(tool), noiseless: Some(noiseless), ..measurement })
}

/// Evaluates readings of a real tool; `field` is where the job or the command names them.
///
/// # Errors
/// [`RunFailure`]: too many or too few switches, switches between teeth.
pub(super) fn evaluated(
    bodies: &SkivingBodies,
    seen: Vec<Reading>,
    field: &str,
) -> Result<Measurement, RunFailure> {
    let measured = measured_tool(&bodies.flanks, &seen, bodies.radius_offset)
        .map_err(|error| of_readings(&error, field))?;
    let switched = switches_of(bodies, &measured);
    Measurement::of(bodies, seen, measured, switched)
}

/// What an ideal barrier would find.
fn noiseless(bodies: &SkivingBodies, tool: &RealTool) -> Result<Deviations, SkivingError> {
    let ideal = BarrierData::ideal();
    let switched = switches(&bodies.flanks, &bodies.beam, &ideal, tool)?;
    let seen = readings(&bodies.flanks, &switched, &ideal, &[Sense::Positive], 1, &mut Noise::new(0));
    Ok(measured_tool(&bodies.flanks, &seen, 0.0)?.deviations)
}

/// Where a tool with these deviations switches.
fn switches_of(bodies: &SkivingBodies, measured: &MeasuredTool) -> Switches {
    let teeth = bodies.teeth();
    bodies.flanks.map(|flank, of| {
        let of_track = |(number, (track, pose)): (usize, &(MeasuringTrack, _))| {
            let lever = track.contact.lever;
            Sense::BOTH.map(|sense| {
                let offset = bodies.radius_offset * (lever * sense.sign()).signum();
                let turn = |tooth: usize| {
                    let f = measured.deviations.of[flank][number][tooth];
                    Some(nominal_angle(pose, tooth, teeth) + (offset - f) / lever)
                };
                (0..teeth).map(turn).collect()
            })
        };
        of.tracks.iter().enumerate().map(of_track).collect()
    })
}

/// What the remaining deviations say of the roundings, and what has to be ground off for it.
fn resharpening(
    bodies: &SkivingBodies,
    measured: &MeasuredTool,
    evaluation: &Evaluation,
) -> Result<Resharpening, RunFailure> {
    let on = |error: WearError| {
        let finding = Diagnostic::with_code(error.code(), error.to_string()).field("readings");
        RunFailure::not_producible(finding.way_out(error.way_out()))
    };
    let sigma = track_deviations(bodies, measured.readings_each);
    let all: Vec<f64> = sigma.iter().flat_map(|(_, of)| of.iter().copied()).collect();
    let options = GrowthOptions {
        positions: ToothPositions::Pitch,
        sigma: root_mean_square(&all).max(LEAST_SIGMA),
        resolution: GROWTH_RESOLUTION,
    };
    let growths = edge_growths(&bodies.flanks, &evaluation.remaining, &options).map_err(on)?;
    let depth = regrind(&bodies.flanks, &growths.growth).map_err(on)?;
    Ok(Resharpening::new(evaluation, &growths, &depth))
}

/// Standard deviation of a mean deviation on every track, mm.
fn track_deviations(bodies: &SkivingBodies, readings_each: usize) -> Sides<Vec<f64>> {
    let count = (readings_each as f64).sqrt();
    bodies.flanks.map(|_, of| {
        let of_track =
            |(track, _): &(MeasuringTrack, _)| bodies.barrier.single_deviation(track.contact.lever) / count;
        of.tracks.iter().map(of_track).collect()
    })
}

impl Measurement {
    fn of(
        bodies: &SkivingBodies,
        readings: Vec<Reading>,
        measured: MeasuredTool,
        switches: Switches,
    ) -> Result<Self, RunFailure> {
        let on = |error: SkivingError| failure(&error);
        let evaluation = evaluate(&bodies.flanks, &measured.deviations, &bodies.options).map_err(on)?;
        let correction =
            correction(&bodies.flanks, &evaluation, (&bodies.free, &bodies.setting_limits)).map_err(on)?;
        let resharpening = resharpening(bodies, &measured, &evaluation)?;
        let as_measured = tool_as_measured(&bodies.flanks, &measured.deviations).map_err(on)?;
        Ok(Self {
            readings,
            measured,
            evaluation,
            correction,
            resharpening,
            switches,
            tool: None,
            as_measured,
            noiseless: None,
        })
    }

    /// Standard deviation of the deviations of every track, mm.
    pub fn deviations(&self, bodies: &SkivingBodies) -> Sides<Vec<f64>> {
        track_deviations(bodies, self.measured.readings_each)
    }

    /// The measurement as one that can be repeated.
    pub(super) fn repeated<'a>(&'a self, job: &'a SkivingJob, bodies: &'a SkivingBodies) -> Repeated<'a> {
        Repeated {
            flanks: &bodies.flanks,
            switches: &self.switches,
            data: &bodies.barrier,
            senses: job.measuring.senses.list(),
            revolutions: job.measuring.revolutions,
            radius_offset: bodies.radius_offset,
            options: &bodies.options,
            settings: (&bodies.free, &bodies.setting_limits),
        }
    }
}
