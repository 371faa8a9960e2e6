//! Feed marks that a hob leaves on the blank.

use super::error::positive;
use super::{Bodies, TechnologyError};
use contact::Pair;
use foundation::geometry::{WormChoice, worm_for_gear};

/// Height of the feed marks of a hob in the middle of the profile, mm: H f_a^2/8 with the hob as worm of the drawing's own rack.
///
/// # Errors
/// `OutOfRange` for a feed that is none; those of a hob that is too small for its threads.
pub fn hob_mark_height(
    bodies: &Bodies,
    (threads, tip_diameter): (i32, f64),
    feed: f64,
) -> Result<f64, TechnologyError> {
    positive("stock.hob.feed", feed)?;
    let work = &bodies.pair.work;
    let hand = if work.data().helix_angle < 0.0 { -1.0 } else { 1.0 };
    let choice = WormChoice {
        threads,
        hand,
        pitch_diameter: None,
        tip_diameter: Some(tip_diameter),
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let made = worm_for_gear(work, &choice)?;
    let pair = Pair::without_backlash(made.worm, *work, made.crossed_axes_angle)?;
    let roll = bodies.flanks.map(|_, engagement| engagement.roll);
    let hob = Bodies::new(pair, made.tip_radius, bodies.face_width, roll)?;
    let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
    let curvature = hob.flanks.map(|_, engagement| engagement.gap_curvature(middle(engagement.roll)));
    Ok(curvature.left.max(curvature.right) * feed * feed / 8.0)
}
