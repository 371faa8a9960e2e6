//! Engaging a running coupling, putting it in phase, watching it.

use crate::slot::{Slot, Stored};
use crate::status::{Failure, Refused, Status, give, status, told};
use electronic_gearbox::coupling::{
    Engagement, EngagementSettings, EngagementState, FollowingWindow, Motion,
};

impl Stored for Engagement {
    const WORDS: usize = 40;
    const MARK: u64 = 0x6567_656e_6761_6731;
}

/// `eg_engagement_settings`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct EngagementLimits {
    phase_speed: f64,
    acceleration: f64,
    fine_window: f64,
    coarse_window: f64,
    fault_time: f64,
    standstill_speed: f64,
}

/// `eg_motion`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct AxisMotion {
    position: f64,
    speed: f64,
    acceleration: f64,
}

impl From<AxisMotion> for Motion {
    fn from(motion: AxisMotion) -> Self {
        let AxisMotion { position, speed, acceleration } = motion;
        Self { position, speed, acceleration }
    }
}

impl From<Motion> for AxisMotion {
    fn from(motion: Motion) -> Self {
        let Motion { position, speed, acceleration } = motion;
        Self { position, speed, acceleration }
    }
}

/// `eg_engagement_output`.
#[repr(C)]
pub struct EngagementStep {
    offset: AxisMotion,
    state: u32,
    window: u32,
    follows: bool,
    stop_leading_axes: bool,
}

fn number(state: EngagementState) -> u32 {
    match state {
        EngagementState::Off => 0,
        EngagementState::Ramping => 1,
        EngagementState::Synchronising => 2,
        EngagementState::Coupled => 3,
        EngagementState::Leaving => 4,
        EngagementState::Fault => 5,
    }
}

/// `eg_engagement_init`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_engagement_init(
    engagement: Option<&mut Slot<Engagement>>,
    settings: Option<&EngagementLimits>,
    error: Option<&mut Refused>,
) -> Status {
    let made = || {
        let limits = settings.ok_or(Status::NullPointer)?;
        let settings = EngagementSettings {
            phase_speed: limits.phase_speed,
            acceleration: limits.acceleration,
            fine_window: limits.fine_window,
            coarse_window: limits.coarse_window,
            fault_time: limits.fault_time,
            standstill_speed: limits.standstill_speed,
        };
        Ok(Slot::put(engagement, Engagement::new(settings)?)?)
    };
    told(made(), error)
}

/// `eg_engagement_engage`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_engagement_engage(
    engagement: Option<&mut Slot<Engagement>>,
    coupled: Option<&AxisMotion>,
) -> Status {
    let made = || -> Result<(), Failure> {
        let coupled = *coupled.ok_or(Status::NullPointer)?;
        Ok(Slot::value(engagement)?.engage(coupled.into())?)
    };
    status(made())
}

/// `eg_engagement_synchronise`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_engagement_synchronise(
    engagement: Option<&mut Slot<Engagement>>,
    position: f64,
    target: f64,
    pitch: f64,
) -> Status {
    let made =
        || -> Result<(), Failure> { Ok(Slot::value(engagement)?.synchronise(position, target, pitch)?) };
    status(made())
}

/// `eg_engagement_switch_off`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_engagement_switch_off(engagement: Option<&mut Slot<Engagement>>) -> Status {
    status(Slot::value(engagement).map(Engagement::switch_off).map_err(Failure::from))
}

/// `eg_engagement_update`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_engagement_update(
    engagement: Option<&mut Slot<Engagement>>,
    step: f64,
    coupled: Option<&AxisMotion>,
    following_error: f64,
    output: Option<&mut EngagementStep>,
) -> Status {
    let made = || {
        let coupled = *coupled.ok_or(Status::NullPointer)?;
        let step = Slot::value(engagement)?.update(step, coupled.into(), following_error)?;
        let window = match step.window {
            None => 0,
            Some(FollowingWindow::Fine) => 1,
            Some(FollowingWindow::Coarse) => 2,
            Some(FollowingWindow::Outside) => 3,
        };
        give(
            output,
            EngagementStep {
                offset: step.offset.unwrap_or_default().into(),
                state: number(step.state),
                window,
                follows: step.offset.is_some(),
                stop_leading_axes: step.stop_leading_axes,
            },
        )
    };
    status(made())
}
