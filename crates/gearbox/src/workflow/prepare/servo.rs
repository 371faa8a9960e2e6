//! The servo of a job, ready to be simulated.

use super::additions::followed_worm;
use super::chain::Chain;
use crate::job::GearboxJob;
use control::{Correction, Following};
use job::control::Servo;
use run::RunFailure;
use run::control::{disturbances, servo_parameters};

/// The loop behind the gearbox.
#[derive(Clone, Debug)]
pub struct FollowedServo {
    /// What is simulated.
    pub following: Following,
    /// As the job gives it, for findings on its keys.
    pub given: Servo,
}

impl FollowedServo {
    /// Of a job with this servo.
    ///
    /// # Errors
    /// [`RunFailure`] on keys of `servo`.
    pub(super) fn of_job(
        job: &GearboxJob,
        given: &Servo,
        chain: &Chain,
        corrections: &[Correction],
    ) -> Result<Self, RunFailure> {
        let workpiece_pulses = job.workpiece.pulses_per_revolution;
        let multiplier = chain.interpolation.settings.pulses_per_interval();
        let following = Following {
            servo: servo_parameters(given, workpiece_pulses, multiplier, "")?,
            feed: chain.interpolation,
            rotation: chain.rotation,
            worm: job.worm.map(|worm| followed_worm(&worm, chain.teeth)),
            workpiece_pulses,
            disturbances: disturbances(given, "")?,
            corrections: corrections.to_vec(),
        };
        Ok(Self { following, given: given.clone() })
    }
}
