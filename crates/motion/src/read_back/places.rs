//! Where worm and dresser stand along a program, place by place, for motions that are no function of the worm position.

use super::Tracked;
use crate::MotionError;
use foundation::kinematics::{Dresser, DressingPosition, Pose, Worm};
use machine::{Machine, Mounts, Positions, Role, Station};

/// A place of worm and dresser on the way of a program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingPlace {
    /// Block, from 1.
    pub block: usize,
    /// Position of the bodies.
    pub at: DressingPosition,
    /// Time from the place before, s; 0 where a chain begins and for rapid moves.
    pub duration: f64,
}

/// Parts of a rapid move.
const RAPID_PARTS: usize = 32;

/// The bodies at positions of the axes; `near` is their worm angle shortly before.
fn stand(
    machine: &Machine,
    mounts: &Mounts,
    at: &Positions,
    near: impl FnOnce(&Pose<Worm, Dresser>) -> f64,
) -> Option<DressingPosition> {
    let bodies: Pose<Worm, Dresser> = mounts.bodies(&machine.pose(Station::Dresser, at).ok()?);
    DressingPosition::of_pose(&bodies, near(&bodies))
}

fn not_standing(block: usize) -> MotionError {
    MotionError::NotFollowed { block, reason: "the bodies cannot stand so against each other".into() }
}

/// Worm angle by the direction of the dresser's axis, where the crossing angle has the sign of `crossing_angle`.
fn first_angle(bodies: &Pose<Worm, Dresser>, crossing_angle: f64) -> f64 {
    let axis = bodies.rotation().column(2).into_owned() * crossing_angle.signum();
    if axis.x.hypot(axis.y) == 0.0 { 0.0 } else { axis.x.atan2(axis.y) }
}

impl Tracked {
    /// Places along the blocks that interpolate, chain by chain: the start of a chain, then the middle and the end of each straight
    /// part of a block. `crossing_angle` tells the half turn in which the worm stands.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn dressing_places(
        &self,
        machine: &Machine,
        mounts: &Mounts,
        crossing_angle: f64,
    ) -> Result<Vec<Vec<DressingPlace>>, MotionError> {
        let (worm, sense) = (machine.role(Role::Worm), mounts.tool.sense());
        let mut all = Vec::with_capacity(self.chains.len());
        for chain in &self.chains {
            let mut places: Vec<DressingPlace> = Vec::with_capacity(1 + 2 * chain.len());
            let mut before: Option<Positions> = None;
            for segment in chain {
                let shares: &[f64] = if before.is_none() { &[0.0, 0.5, 1.0] } else { &[0.5, 1.0] };
                for &u in shares {
                    let axes = segment.at(machine, u);
                    let at = stand(machine, mounts, &axes, |bodies| match (places.last(), &before) {
                        // Full turns are those of the spindle.
                        (Some(last), Some(from)) => {
                            let turned = worm.map_or(0.0, |axis| sense * (axes[axis] - from[axis]));
                            last.at.worm_angle + turned
                        }
                        _ => first_angle(bodies, crossing_angle),
                    });
                    let at = at.ok_or_else(|| not_standing(segment.block))?;
                    let duration = if u == 0.0 { 0.0 } else { 0.5 * segment.duration };
                    places.push(DressingPlace { block: segment.block, at, duration });
                    before = Some(axes);
                }
            }
            all.push(places);
        }
        Ok(all)
    }

    /// Places along the rapid moves, as if their axes moved together.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn dressing_rapids(
        &self,
        machine: &Machine,
        mounts: &Mounts,
        crossing_angle: f64,
    ) -> Result<Vec<DressingPlace>, MotionError> {
        let mut places = Vec::new();
        for (block, [from, to]) in &self.rapids {
            for k in 0..=RAPID_PARTS {
                let u = k as f64 / RAPID_PARTS as f64;
                let axes = crate::path::straight(machine, from, to, u);
                let at = stand(machine, mounts, &axes, |bodies| first_angle(bodies, crossing_angle));
                let at = at.ok_or_else(|| not_standing(*block))?;
                places.push(DressingPlace { block: *block, at, duration: 0.0 });
            }
        }
        Ok(places)
    }
}
