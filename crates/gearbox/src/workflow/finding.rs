//! What slide, servo and gearbox refuse, as findings on the keys of the job.

use control::{ControlError, StrokeError};
use job::control::Servo;
use run::RunFailure;
use run::control::{of_scale, of_servo, on_field};

/// What a scale or a slide refuses.
pub(super) fn of_feed(error: &ControlError) -> RunFailure {
    of_scale(error, "", "stimulus.motion")
}

/// What a simulation of the servo refuses.
pub(super) fn of_following(error: &StrokeError, servo: &Servo) -> RunFailure {
    match error {
        StrokeError::Control(error) => of_servo(error, servo, ""),
        StrokeError::Gearbox(error) => on_field(error, "worm"),
    }
}
