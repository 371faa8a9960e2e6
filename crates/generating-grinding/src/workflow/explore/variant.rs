//! One worm of a study: the job with another cone angle or crossing angle.

use super::refused::Refused;
use crate::job::{Explore, LoadedJob, Steps};
use crate::workflow::prepare::worm_choice_of_job;
use generating::worm_at_crossing_angle;
use run::gear_of_job;

/// What is changed of the worm; `None` keeps the job's value. Degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variant {
    pub cone_angle_deg: Option<f64>,
    pub crossed_axes_angle_deg: Option<f64>,
}

/// Largest pitch diameter that a job file may give, mm: a worm that `plan` would refuse is no answer.
const LARGEST_PITCH_DIAMETER: f64 = 2000.0;

impl Variant {
    /// Every combination, cone angles outside.
    pub fn all(explore: &Explore) -> Vec<Self> {
        let crossings = Steps::each(explore.crossed_axes_angle_deg);
        Steps::each(explore.worm_cone_angle_deg)
            .into_iter()
            .flat_map(|cone_angle_deg| {
                crossings
                    .iter()
                    .map(move |&crossed_axes_angle_deg| Self { cone_angle_deg, crossed_axes_angle_deg })
            })
            .collect()
    }

    /// The job with this worm. The crossing angle comes about by the pitch diameter; an addendum that the job gives stays.
    ///
    /// # Errors
    /// A gear that is impossible, an angle that no worm of the job's hand reaches.
    pub fn job(self, base: &LoadedJob) -> Result<LoadedJob, Refused> {
        let mut changed = base.clone();
        if let Some(angle) = self.cone_angle_deg {
            changed.job.worm.cone_angle_deg = angle;
        }
        if let Some(angle) = self.crossed_axes_angle_deg {
            let gear = gear_of_job(&changed.job.gear).map_err(|finding| Refused::from(&finding))?;
            let worm = worm_at_crossing_angle(&gear, &worm_choice_of_job(&changed.job), angle.to_radians())
                .map_err(|e| Refused::from(&e))?;
            let pitch = worm.pitch_diameter.unwrap_or_default();
            if pitch > LARGEST_PITCH_DIAMETER {
                return Err(Refused {
                    code: "invalid-number",
                    text: format!(
                        "the crossed-axes angle {angle} deg takes a worm of {pitch:.3} mm pitch diameter; allowed: up to \
                         {LARGEST_PITCH_DIAMETER} mm"
                    ),
                    way_out: "take an angle nearer to that of the job's worm".into(),
                });
            }
            (changed.job.worm.pitch_diameter, changed.job.worm.tip_diameter) =
                (worm.pitch_diameter, worm.tip_diameter);
        }
        Ok(changed)
    }
}
