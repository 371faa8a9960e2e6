//! From angles at which a light barrier switched to what is wrong with a skiving tool, and to what its workpiece will be (spec 60
//! section 8).

mod as_measured;
mod assignment;
mod correction;
mod deviations;
mod monte_carlo;
mod mounting;
mod pitch;
mod profile;

pub use as_measured::tool_as_measured;
pub use correction::correction;
pub use deviations::{Deviations, MeasuredTool, measured_tool};
pub use monte_carlo::{Quantity, Repeated, Scatter, repeat};
pub use mounting::{Mounting, mounting};
pub use pitch::{Pitch, pitch};
pub use profile::{ProfileOptions, ProfileVerdict, profile_verdict};

use super::SkivingError;
use super::measuring::FlankTracks;
use crate::geometry::Sides;

/// All that is known of a measured tool. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Index offset delta_0: the clocking of the tool, rad.
    pub clocking: f64,
    /// f_z: deviations without the clocking, mm.
    pub clocked: Deviations,
    /// Pitch and tooth thickness.
    pub pitch: Pitch,
    /// Eccentricity and wobble.
    pub mounting: Mounting,
    /// f_r: deviations without clocking and mounting, mm.
    pub remaining: Deviations,
    /// Profiles, tolerance bands and wear.
    pub profile: ProfileVerdict,
}

/// Evaluates the deviations of all teeth on all tracks.
///
/// # Errors
/// [`SkivingError::TooFewTracks`], [`SkivingError::InvalidNumber`].
pub fn evaluate(
    flanks: &Sides<FlankTracks>,
    deviations: &Deviations,
    options: &ProfileOptions,
) -> Result<Evaluation, SkivingError> {
    let lever = |flank, track: usize| -> f64 {
        let of: &FlankTracks = &flanks[flank];
        of.tracks[track].0.contact.lever
    };
    // a = -dF = f/L.
    let angles = deviations.map(|flank, track, _, f| f / lever(flank, track));
    let clocking = angles.mean();
    let clocked = deviations.map(|flank, track, _, f| f - lever(flank, track) * clocking);
    let pitch = pitch(flanks, &angles.map(|_, _, _, a| a - clocking));
    let mounting = mounting(flanks, &clocked);
    let remaining = clocked.map(|flank, track, tooth, f| {
        f - mounting.rigid_part(&flanks[flank].tracks[track].0, tooth, clocked.teeth())
    });
    let profile = profile_verdict(flanks, &remaining, options)?;
    Ok(Evaluation { clocking, clocked, pitch, mounting, remaining, profile })
}
