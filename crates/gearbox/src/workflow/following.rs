//! The servo of a job: simulation of the loop behind the gearbox, and what it leaves at the flank.

use super::finding::of_following;
use super::prepare::{Driven, FollowedServo};
use super::result::{FlankResponseResult, ServoErrorResult, ServoResult};
use control::{FollowedSlide, FollowingError, FollowingRecord, StrokeError};
use run::RunFailure;

/// Frequencies at which the response to disturbing torques is given, Hz, as far as the sampling reaches.
const FREQUENCIES: [f64; 6] = [1.0, 10.0, 30.0, 100.0, 300.0, 1000.0];

/// Simulates a servo over the whole stimulus.
///
/// # Errors
/// [`RunFailure`] on keys of `servo`, an unstable loop among them.
pub(super) fn follow(
    servo: &FollowedServo,
    driven: &Driven,
    um_per_radian: f64,
) -> Result<(ServoResult, FollowingRecord), RunFailure> {
    let FollowedServo { following, given } = servo;
    let parameters = &following.servo;
    let slide = FollowedSlide {
        references: &driven.references,
        motion: driven.motion.as_ref(),
        duration: driven.duration(&following.feed),
    };
    let record = following.run(&slide).map_err(|error| of_following(&error, given))?;
    let refused = |error| of_following(&StrokeError::Control(error), given);
    let reached = FREQUENCIES.iter().filter(|hz| **hz <= 0.5 / parameters.sample_time);
    let disturbance_response = reached
        .map(|&frequency_hz| {
            let response = parameters.disturbance_response(frequency_hz).map_err(refused)?;
            Ok(FlankResponseResult { frequency_hz, um_per_n_m: response.norm() * um_per_radian })
        })
        .collect::<Result<_, RunFailure>>()?;
    let result = ServoResult {
        settling_s: record.lead_in,
        samples: record.samples,
        setpoint: at_flank(&record.setpoint, um_per_radian),
        workpiece: at_flank(&record.actual, um_per_radian),
        greatest_torque_n_m: record.greatest_torque,
        torque_limited_share: record.limited,
        largest_pole: parameters.largest_pole().map_err(refused)?,
        disturbance_response,
    };
    Ok((result, record))
}

fn at_flank(error: &FollowingError, um_per_radian: f64) -> ServoErrorResult {
    ServoErrorResult {
        mean_um: error.mean * um_per_radian,
        rms_um: error.rms * um_per_radian,
        peak_um: error.extremes.greatest.max(-error.extremes.least) * um_per_radian,
    }
}
