//! A measured tool: readings of a simulated one or from a file, their evaluation, the correction that answers them.

use super::finding::{failure, of_readings};
use super::prepare::{Recording, SkivingBodies};
use super::readings_file::ReadingsFile;
use super::resharpening::{Resharpening, states};
use crate::evaluation::{
    Deviations, Evaluation, MeasuredTool, MissingSwitch, Repeated, correction, evaluate_measured,
    measured_tool, measured_tool_near, tool_as_measured,
};
use crate::measuring::{
    BarrierData, Noise, Reading, RealTool, Sense, Switches, nominal_angle, readings, switches,
};
use crate::wear::{GrowthOptions, ToothPositions, WearError, edge_growths, regrind_edges};
use crate::{MeasuringTrack, SettingFit, SkivingError};
use foundation::geometry::Sides;
use foundation::numerics::root_mean_square;
use job::Diagnostic;
use run::RunFailure;
use std::collections::{BTreeMap, BTreeSet};

/// Standard deviation of a growth up to which it is distinguished from a shift of the edge, mm.
const GROWTH_RESOLUTION: f64 = 2e-3;
/// What a linear evaluation is off where nothing scatters (`docs/mathematics/skiving.md#how-it-is-verified`), mm.
const LEAST_SIGMA: f64 = 3e-5;

/// In which senses, and how often in each, a tool was measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Taken {
    /// Senses in their order.
    pub senses: Vec<Sense>,
    /// Revolutions in each, on the track that has the fewest.
    pub revolutions: usize,
}

/// A measured tool with all that follows from it.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// What the control wrote down.
    pub readings: Vec<Reading>,
    /// Senses and revolutions of the readings.
    pub taken: Taken,
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
    /// What the referee takes: the simulated tool, else the one that the deviations tell.
    pub cutting: RealTool,
    /// The clocking that is taken off it, rad: 0 where the deviations are without it already.
    pub cutting_clocking: f64,
    /// f_z of that tool, for a simulated one without noise, delay and hysteresis: what prediction and referee are compared by.
    pub told: Deviations,
}

/// Measures a tool with known errors.
///
/// # Errors
/// [`RunFailure`]: a tooth that cannot be measured, or is missing.
pub(super) fn simulated(
    bodies: &SkivingBodies,
    recording: &Recording,
    tool: RealTool,
) -> Result<Measurement, RunFailure> {
    let on = |error: SkivingError| failure(&error);
    tool.check(bodies.teeth()).map_err(on)?;
    let switched = switches(&bodies.flanks, &bodies.beam, &bodies.barrier, &tool).map_err(on)?;
    let mut noise = Noise::new(recording.seed);
    let seen = readings(
        &bodies.flanks,
        &switched,
        &bodies.barrier,
        recording.senses,
        recording.revolutions,
        &mut noise,
    );
    let measured =
        measured_tool_near(&bodies.flanks, &seen, bodies.radius_offset, bodies.clocking).map_err(on)?;
    let still = noiseless(bodies, &tool).map_err(on)?;
    let measurement = Measurement::of(bodies, seen, measured, switched)?;
    Ok(Measurement {
        cutting: tool.clone(),
        cutting_clocking: still.clocking,
        told: still.clocked,
        tool: Some(tool),
        ..measurement
    })
}

/// Evaluates readings of a real tool.
///
/// # Errors
/// [`RunFailure`]: too many or too few switches, switches between teeth.
pub(super) fn evaluated(
    bodies: &SkivingBodies,
    seen: Vec<Reading>,
    field: &ReadingsFile<'_>,
) -> Result<Measurement, RunFailure> {
    same_senses(&seen, field)?;
    let measured = measured_tool_near(&bodies.flanks, &seen, bodies.radius_offset, bodies.clocking)
        .map_err(|error| of_readings(&error, field))?;
    let switched = switches_of(bodies, &measured);
    Measurement::of(bodies, seen, measured, switched)
}

/// What an ideal barrier would find.
fn noiseless(bodies: &SkivingBodies, tool: &RealTool) -> Result<Evaluation, SkivingError> {
    let ideal = BarrierData::ideal();
    let switched = switches(&bodies.flanks, &bodies.beam, &ideal, tool)?;
    let seen = readings(&bodies.flanks, &switched, &ideal, &[Sense::Positive], 1, &mut Noise::new(0));
    let found = measured_tool(&bodies.flanks, &seen, 0.0)?;
    evaluate_measured(&bodies.flanks, &found, &bodies.options)
}

/// Delay and hysteresis drop out of tracks that were measured in both senses: such tracks do not go with others.
fn same_senses(seen: &[Reading], file: &ReadingsFile<'_>) -> Result<(), RunFailure> {
    let mut senses: BTreeMap<(&str, usize), BTreeSet<Sense>> = BTreeMap::new();
    for reading in seen {
        senses.entry((reading.flank.name(), reading.track)).or_default().insert(reading.sense);
    }
    let Some((_, first)) = senses.first_key_value() else { return Ok(()) };
    let Some(((flank, track), _)) = senses.iter().find(|(_, found)| *found != first) else { return Ok(()) };
    let message =
        format!("{flank} flank, track {}: not measured in the same senses as the first track", track + 1);
    let finding =
        Diagnostic::with_code("senses-differ", message).way_out("measure all tracks in the same senses");
    Err(RunFailure::bad_input(file.named(finding)))
}

impl Taken {
    fn of(readings: &[Reading]) -> Self {
        let mut turns: BTreeMap<(&str, usize, Sense), BTreeSet<usize>> = BTreeMap::new();
        for reading in readings {
            let place = (reading.flank.name(), reading.track, reading.sense);
            turns.entry(place).or_default().insert(reading.revolution);
        }
        let senses: BTreeSet<Sense> = turns.keys().map(|(.., sense)| *sense).collect();
        let revolutions = turns.values().map(BTreeSet::len).min().unwrap_or(0);
        Self { senses: senses.into_iter().collect(), revolutions }
    }
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
                    let switch = MissingSwitch { flank, track: number, tooth };
                    if measured.missing.contains(&switch) {
                        return None;
                    }
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
    let on = |error: WearError| RunFailure::not_producible(Diagnostic::of(&error).field("readings"));
    let sigma = track_deviations(bodies, measured.readings_each);
    let all: Vec<f64> = sigma.iter().flat_map(|(_, of)| of.iter().copied()).collect();
    let options = GrowthOptions {
        positions: ToothPositions::Pitch,
        sigma: root_mean_square(&all).max(LEAST_SIGMA),
        resolution: GROWTH_RESOLUTION,
    };
    let growths = edge_growths(&bodies.flanks, &evaluation.remaining, &options).map_err(on)?;
    let incomplete = measured.incomplete();
    let states = states(evaluation, &growths, &incomplete);
    let depth = regrind_edges(&bodies.flanks, &states).map_err(on)?;
    Ok(Resharpening::new(evaluation, &growths, (&states, &depth), &incomplete))
}

/// Standard deviation of a mean deviation on every track, mm.
fn track_deviations(bodies: &SkivingBodies, readings_each: usize) -> Sides<Vec<f64>> {
    bodies.flanks.map(|_, of| {
        let of_track = |(track, _): &(MeasuringTrack, _)| {
            bodies.barrier.mean_deviation(track.contact.lever, readings_each)
        };
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
        let evaluation = evaluate_measured(&bodies.flanks, &measured, &bodies.options).map_err(on)?;
        let correction =
            correction(&bodies.flanks, &evaluation, (&bodies.free, &bodies.setting_limits)).map_err(on)?;
        let resharpening = resharpening(bodies, &measured, &evaluation)?;
        let cutting = tool_as_measured(&bodies.flanks, &evaluation.clocked).map_err(on)?;
        let told = evaluation.clocked.clone();
        Ok(Self {
            taken: Taken::of(&readings),
            readings,
            measured,
            evaluation,
            correction,
            resharpening,
            switches,
            tool: None,
            cutting,
            cutting_clocking: 0.0,
            told,
        })
    }

    /// Standard deviation of the deviations of every track, mm.
    pub fn deviations(&self, bodies: &SkivingBodies) -> Sides<Vec<f64>> {
        track_deviations(bodies, self.measured.readings_each)
    }

    /// The measurement as one that can be repeated.
    pub(super) fn repeated<'a>(&'a self, bodies: &'a SkivingBodies) -> Repeated<'a> {
        Repeated {
            flanks: &bodies.flanks,
            switches: &self.switches,
            data: &bodies.barrier,
            senses: &self.taken.senses,
            revolutions: self.taken.revolutions,
            radius_offset: bodies.radius_offset,
            clocking: self.evaluation.clocking,
            options: &bodies.options,
            settings: (&bodies.free, &bodies.setting_limits),
        }
    }
}
