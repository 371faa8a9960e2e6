//! Limits of an engagement and the windows of the following error.

use crate::Error;

/// Units: the follower's unit of position (degrees, or counts; one for all) and seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EngagementSettings {
    /// v_max: greatest speed of the phase move, on top of the coupling.
    pub phase_speed: f64,
    /// a_max: greatest acceleration of ramps and phase move; that of the leading axes comes on top.
    pub acceleration: f64,
    /// Greatest following error at which the coupling counts as exact.
    pub fine_window: f64,
    /// Greatest following error that is allowed.
    pub coarse_window: f64,
    /// How long the error may be outside the coarse window, s.
    pub fault_time: f64,
    /// Up to this speed of the coupling the leading axes count as standing.
    pub standstill_speed: f64,
}

impl EngagementSettings {
    /// Every value in its range.
    pub(super) fn check(&self) -> Result<(), Error> {
        for (name, value) in [
            ("greatest speed of the phase move", self.phase_speed),
            ("greatest acceleration", self.acceleration),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::BadParameter { name, value, allowed: "above 0, finite" });
            }
        }
        for (name, value) in [
            ("fine window", self.fine_window),
            ("time until a fault", self.fault_time),
            ("speed at standstill", self.standstill_speed),
        ] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(Error::BadParameter { name, value, allowed: "0 or more, finite" });
            }
        }
        if !(self.coarse_window >= self.fine_window && self.coarse_window.is_finite()) {
            return Err(Error::BadParameter {
                name: "coarse window",
                value: self.coarse_window,
                allowed: "at least the fine window, finite",
            });
        }
        Ok(())
    }

    /// Window of a following error.
    pub(super) fn window(&self, error: f64) -> FollowingWindow {
        // NaN is in no window.
        if error.abs() <= self.fine_window {
            FollowingWindow::Fine
        } else if error.abs() <= self.coarse_window {
            FollowingWindow::Coarse
        } else {
            FollowingWindow::Outside
        }
    }
}

/// How well the follower follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FollowingWindow {
    /// Within the fine window.
    Fine,
    /// Within the coarse window only.
    Coarse,
    /// Outside both.
    Outside,
}
