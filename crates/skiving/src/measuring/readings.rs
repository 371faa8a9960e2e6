//! What a control writes down: angles at which the barrier switched, with everything that comes between the moment and the number
//! (`docs/mathematics/skiving.md#light-barrier`).

use super::{Barrier, Beam, MeasuringPose, Noise, RealTool};
use crate::{MeasuringTrack, SkivingError, VirtualEdge};
use foundation::geometry::{Flank, Sides};
use rayon::prelude::*;

/// Sense in which the spindle turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sense {
    /// Growing B.
    Positive,
    /// Falling B.
    Negative,
}

/// Light barrier, spindle and encoder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarrierData {
    /// Speed of the spindle, rad/s.
    pub speed: f64,
    /// From the switch to the reading, s.
    pub latency: f64,
    /// Standard deviation of that time, s.
    pub jitter: f64,
    /// Standard deviation of the beam's edge across itself, mm.
    pub beam_noise: f64,
    /// How much deeper the beam must be shaded to switch to dark than to stay so, mm.
    pub hysteresis: f64,
    /// q: step of the encoder, rad; 0 without.
    pub encoder_step: f64,
}

/// One switch of the barrier.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Flank of the workpiece whose edge was measured.
    pub flank: Flank,
    /// Track, from 0.
    pub track: usize,
    /// Sense of the spindle.
    pub sense: Sense,
    /// Revolution, from 0.
    pub revolution: usize,
    /// B, rad.
    pub angle: f64,
}

/// A flank's tracks, each with the pose in which it is measured.
#[derive(Clone, Debug)]
pub struct FlankTracks {
    /// The edge.
    pub edge: VirtualEdge,
    /// Tracks with their poses.
    pub tracks: Vec<(MeasuringTrack, MeasuringPose)>,
}

/// Turns B at which every tooth switches in each sense: of a flank, track by track, tooth by tooth; `None` for a broken tooth.
pub type Switches = Sides<Vec<[Vec<Option<f64>>; 2]>>;

impl Sense {
    /// Both.
    pub const BOTH: [Self; 2] = [Self::Positive, Self::Negative];

    /// +1 or -1.
    pub fn sign(self) -> f64 {
        match self {
            Self::Positive => 1.0,
            Self::Negative => -1.0,
        }
    }

    fn index(self) -> usize {
        usize::from(self == Self::Negative)
    }
}

impl BarrierData {
    /// A barrier that reads without delay, noise and steps.
    pub fn ideal() -> Self {
        let zero = 0.0;
        Self {
            speed: 1.0,
            latency: zero,
            jitter: zero,
            beam_noise: zero,
            hysteresis: zero,
            encoder_step: zero,
        }
    }

    /// Radius at which a flank with a lever switches: deeper where it runs into the beam.
    pub fn switching_radius(&self, beam: &Beam, lever: f64, sense: Sense) -> f64 {
        beam.radius - 0.5 * self.hysteresis * (lever * sense.sign()).signum()
    }

    /// Standard deviation of a single deviation, mm (`docs/mathematics/skiving.md#light-barrier`).
    pub fn single_deviation(&self, lever: f64) -> f64 {
        let time = lever * self.speed * self.jitter;
        let step = lever * self.encoder_step;
        (time * time + self.beam_noise * self.beam_noise + step * step / 12.0).sqrt()
    }

    /// Standard deviation of the mean of so many deviations, mm. Steps of the encoder average only as far as noise moves the readings over
    /// them: with less than half a step of it every revolution is rounded alike.
    pub fn mean_deviation(&self, lever: f64, count: usize) -> f64 {
        let time = lever * self.speed * self.jitter;
        let noise = time.hypot(self.beam_noise);
        let step = (lever * self.encoder_step).abs();
        let count = count.max(1) as f64;
        let steps = step / 12f64.sqrt() / if noise < 0.5 * step { 1.0 } else { count.sqrt() };
        (noise / count.sqrt()).hypot(steps)
    }

    /// What the control reads of a switch at a turn.
    fn read(&self, turn: f64, lever: f64, sense: Sense, noise: &mut Noise) -> f64 {
        let delay = self.latency + self.jitter * noise.normal();
        let seen = turn + sense.sign() * self.speed * delay + self.beam_noise * noise.normal() / lever;
        if self.encoder_step == 0.0 {
            return seen;
        }
        self.encoder_step * (seen / self.encoder_step + 0.5).floor()
    }
}

/// Where every tooth switches, without noise.
///
/// # Errors
/// Those of [`Barrier::touch`]; a broken tooth is no error.
pub fn switches(
    flanks: &Sides<FlankTracks>,
    beam: &Beam,
    data: &BarrierData,
    tool: &RealTool,
) -> Result<Switches, SkivingError> {
    let of_track = |of: &FlankTracks, (track, pose): &(MeasuringTrack, MeasuringPose)| {
        let barrier = Barrier { beam, pose };
        let of_sense = |sense: Sense| {
            let radius = data.switching_radius(beam, track.contact.lever, sense);
            (0..tool.teeth())
                .map(|tooth| match tool.broken[tooth] {
                    true => Ok(None),
                    false => {
                        barrier.touch(&of.edge, tool, track, tooth, radius).map(|t| Some(t.wrapped_turn()))
                    }
                })
                .collect::<Result<Vec<_>, SkivingError>>()
        };
        let first = of_sense(Sense::Positive)?;
        // Without hysteresis both senses switch at the same place.
        let second = if data.hysteresis == 0.0 { first.clone() } else { of_sense(Sense::Negative)? };
        Ok([first, second])
    };
    let of_flank = |of: &FlankTracks| {
        of.tracks.par_iter().map(|at| of_track(of, at)).collect::<Result<Vec<_>, SkivingError>>()
    };
    Ok(Sides { left: of_flank(&flanks.left)?, right: of_flank(&flanks.right)? })
}

/// All readings of a measurement, in the order in which they are taken: flank, track, sense, revolution, tooth.
pub fn readings(
    flanks: &Sides<FlankTracks>,
    switches: &Switches,
    data: &BarrierData,
    senses: &[Sense],
    revolutions: usize,
    noise: &mut Noise,
) -> Vec<Reading> {
    let mut readings = Vec::new();
    for flank in [Flank::Left, Flank::Right] {
        for (number, of_track) in switches[flank].iter().enumerate() {
            let lever = flanks[flank].tracks[number].0.contact.lever;
            for &sense in senses {
                for revolution in 0..revolutions {
                    for turn in of_track[sense.index()].iter().flatten() {
                        let angle = data.read(*turn, lever, sense, noise);
                        readings.push(Reading { flank, track: number, sense, revolution, angle });
                    }
                }
            }
        }
    }
    readings
}
