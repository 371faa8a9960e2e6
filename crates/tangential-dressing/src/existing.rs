//! A dresser that exists: made for some worm, with a profile of its own. On the worm of a job it is what it is; here is what it lacks there of
//! the conjugate profile, as a function that the profile's own variables could not change any more
//! (`docs/mathematics/tangential-dressing.md#a-dresser-that-exists`).

use super::TangentialError;
use super::model::TangentialModel;
use super::profile::Profile;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::numerics::equidistant;
use std::sync::Arc;

/// Material that a dresser's profile leaves on the gear, mm, normal, over the length of roll there; `None` where it has no value.
pub type CarriedProfile = Arc<dyn Fn(f64) -> Option<f64> + Send + Sync>;

/// A dresser with the worm that it was made for.
#[derive(Clone)]
pub struct ExistingDresser {
    /// Gear, dresser and that worm in place.
    pub made_for: TangentialModel,
    /// What it leaves on the gear from that worm, in nominal motion; `None`: a plain side.
    pub carried: Sides<Option<CarriedProfile>>,
}

/// Points of the spline that the profile becomes; over some four modules they stand closer than a grain is large.
const POINTS: usize = 385;
/// The carried profile counts as it is over the evaluated range of the gear and this share of it beyond; farther out its end is held.
const BEYOND: f64 = 0.1;
/// Rounds in which a point of the moved profile is found, and their end, mm.
const ROUNDS: usize = 60;
const ACCURACY: f64 = 1e-13;

impl ExistingDresser {
    /// What the side of this dresser lacks of the half thickness `nominal` over its height s there, mm.
    ///
    /// # Errors
    /// [`TangentialError::InvalidNumber`] for a carried profile that has no value or turns back on itself.
    pub(super) fn lacking(&self, nominal: &Profile, flank: Flank) -> Result<MotionLaw, TangentialError> {
        let own = &self.made_for.profiles[flank];
        let heights = equidistant(nominal.known(), POINTS);
        // Heights count from pitch circles that need not be the same one.
        let raised = nominal.pitch_radius - own.pitch_radius;
        let lacking = heights
            .iter()
            .map(|&s| Ok(nominal.half_thickness(s)[0] - self.half_thickness(own, flank, s + raised)?))
            .collect::<Result<Vec<f64>, TangentialError>>()?;
        MotionLaw::spline(&heights, &lacking).map_err(|_| none(f64::NAN))
    }

    /// Half thickness at a height over the own pitch circle: the plain profile moved along its normal.
    fn half_thickness(&self, own: &Profile, flank: Flank, s: f64) -> Result<f64, TangentialError> {
        let Some(carried) = &self.carried[flank] else { return Ok(own.half_thickness(s)[0]) };
        let pair = &self.made_for.pair.flanks[flank];
        let [start, end] = self.made_for.rolls(flank);
        let beyond = BEYOND * (end - start);
        // In the middle of the face: on a cone the rolls that touch each other change along it.
        let touching = |w: f64| pair.worm_roll(w, 0.0, -pair.work_z(w, 0.0, 0.0) / pair.c_zv22);
        let (origin, rate) = (touching(0.0), touching(1.0) - touching(0.0));
        let work_roll = |w_1: f64| (w_1 - origin) / rate;
        let moved = |at: f64| {
            let w = work_roll(own.roll(at));
            let w = w.clamp((start - beyond).max(0.0), end + beyond);
            // What is left on the gear the dresser has taken off the worm: it is that much thicker.
            carried(w).filter(|g| g.is_finite()).ok_or_else(|| none(w))
        };
        let mut from = s;
        for _ in 0..ROUNDS {
            let [thickness, slope, _] = own.half_thickness(from);
            let (g, length) = (moved(from)?, (1.0 + slope * slope).sqrt());
            let next = s + g * slope / length;
            if (next - from).abs() < ACCURACY {
                return Ok(thickness + g / length);
            }
            from = next;
        }
        Err(none(work_roll(own.roll(s))))
    }
}

fn none(w: f64) -> TangentialError {
    TangentialError::InvalidNumber {
        field: "profile of the dresser at the length of roll",
        value: w,
        allowed: "a profile with a value and a moderate slope everywhere on the flank",
    }
}
