//! From angles at which a light barrier switched to what is wrong with a skiving tool, and to what its workpiece will be
//! (`docs/mathematics/skiving.md#evaluation`).

mod as_measured;
mod assignment;
mod correction;
mod deviations;
mod monte_carlo;
mod mounting;
mod pitch;
mod profile;
mod standing_out;

pub use as_measured::tool_as_measured;
pub use correction::correction;
pub use deviations::{Deviations, MeasuredTool, MissingSwitch, measured_tool, measured_tool_near};
pub use monte_carlo::{Quantity, Repeated, Scatter, repeat};
pub use mounting::Mounting;
pub use pitch::Pitch;
pub use profile::{ProfileOptions, ProfileVerdict};

use super::SkivingError;
use super::measuring::FlankTracks;
use foundation::geometry::{Flank, Sides};
use mounting::mounting;
use pitch::pitch;
use profile::profile_verdict;
use standing_out::{StandingOut, beyond_median, standing_out};

/// Whose deviations make clocking, means, pitch and correction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Counting {
    /// Those of teeth that are no outliers.
    Whole,
    /// Those of all teeth, as `docs/mathematics/skiving.md#evaluation` has it; the mounting alone leaves teeth out.
    All,
}

/// All that is known of a measured tool. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Index offset delta_0: the clocking of the tool, rad.
    pub clocking: f64,
    /// f_z: deviations without the clocking, mm. Of a tooth without a switch what the mean tooth would have there.
    pub clocked: Deviations,
    /// Pitch and tooth thickness.
    pub pitch: Pitch,
    /// Eccentricity and wobble.
    pub mounting: Mounting,
    /// f_r: deviations without clocking and mounting, mm.
    pub remaining: Deviations,
    /// Profiles, tolerance bands and wear.
    pub profile: ProfileVerdict,
    /// Teeth that count for clocking, means, mounting and correction: measured whole, and no outlier.
    pub counting: Vec<bool>,
    /// The outlier edges of the teeth that are left out: the left flank first, teeth ascending.
    pub standing_out: Vec<(Flank, usize)>,
}

impl Evaluation {
    /// Number of teeth that count.
    pub fn count(&self) -> usize {
        self.counting.iter().filter(|&&counts| counts).count()
    }
}

/// Evaluates the deviations of all teeth on all tracks. Broken teeth are found first and count for nothing but themselves.
///
/// # Errors
/// [`SkivingError::TooFewTracks`], [`SkivingError::InvalidNumber`].
pub fn evaluate(
    flanks: &Sides<FlankTracks>,
    deviations: &Deviations,
    options: &ProfileOptions,
) -> Result<Evaluation, SkivingError> {
    of_teeth(flanks, deviations, &[], options, Counting::Whole)
}

/// The same of a tool of which some teeth lack a switch.
///
/// # Errors
/// As [`evaluate`].
pub fn evaluate_measured(
    flanks: &Sides<FlankTracks>,
    measured: &MeasuredTool,
    options: &ProfileOptions,
) -> Result<Evaluation, SkivingError> {
    of_teeth(flanks, &measured.deviations, &measured.missing, options, Counting::Whole)
}

/// The evaluation by the letter of `docs/mathematics/skiving.md#evaluation`, where broken teeth are left out of the mounting alone.
///
/// # Errors
/// As [`evaluate`].
pub fn evaluate_all_teeth(
    flanks: &Sides<FlankTracks>,
    deviations: &Deviations,
    options: &ProfileOptions,
) -> Result<Evaluation, SkivingError> {
    of_teeth(flanks, deviations, &[], options, Counting::All)
}

fn of_teeth(
    flanks: &Sides<FlankTracks>,
    deviations: &Deviations,
    missing: &[MissingSwitch],
    options: &ProfileOptions,
    rule: Counting,
) -> Result<Evaluation, SkivingError> {
    let lever = |flank, track: usize| -> f64 {
        let of: &FlankTracks = &flanks[flank];
        of.tracks[track].0.contact.lever
    };
    let teeth = deviations.teeth();
    let mut present = vec![true; teeth];
    missing.iter().for_each(|switch| present[switch.tooth] = false);
    let found = match rule {
        Counting::Whole => standing_out(deviations, &present),
        Counting::All => {
            beyond_median(flanks, deviations, &mounting(flanks, deviations, &present, Vec::new()))
        }
    };
    let StandingOut { teeth: left_out, edges: standing_out } = found;
    let whole: Vec<bool> = (0..teeth).map(|tooth| present[tooth] && !left_out.contains(&tooth)).collect();
    let mut mounting = mounting(flanks, deviations, &whole, left_out);
    let clocking = match rule {
        Counting::All => deviations.map(|flank, track, _, f| f / lever(flank, track)).mean(),
        // Where teeth are left out the mounting does not vanish in their mean: the constants are without it.
        Counting::Whole => {
            let of_track = mounting.constants.iter().flat_map(|(flank, constants)| {
                constants.iter().enumerate().map(move |(track, c)| c / lever(flank, track))
            });
            let of_track: Vec<f64> = of_track.collect();
            of_track.iter().sum::<f64>() / of_track.len() as f64
        }
    };
    for (flank, constants) in
        [(Flank::Left, &mut mounting.constants.left), (Flank::Right, &mut mounting.constants.right)]
    {
        constants.iter_mut().enumerate().for_each(|(track, c)| *c -= lever(flank, track) * clocking);
    }
    let lacking = |flank, track, tooth| missing.contains(&MissingSwitch { flank, track, tooth });
    let clocked = deviations.map(|flank, track, tooth, f| {
        if lacking(flank, track, tooth) {
            let rigid = mounting.rigid_part(&flanks[flank].tracks[track].0, tooth, teeth);
            return mounting.constants[flank][track] + rigid;
        }
        f - lever(flank, track) * clocking
    });
    let counting = if rule == Counting::All { vec![true; teeth] } else { whole };
    // a' = -dF - delta_0.
    let angles = clocked.map(|flank, track, _, f| f / lever(flank, track));
    let pitch = pitch(flanks, &angles, &counting);
    let remaining = clocked
        .map(|flank, track, tooth, f| f - mounting.rigid_part(&flanks[flank].tracks[track].0, tooth, teeth));
    let profile = profile_verdict(flanks, &remaining, (&counting, &present), options)?;
    Ok(Evaluation { clocking, clocked, pitch, mounting, remaining, profile, counting, standing_out })
}
