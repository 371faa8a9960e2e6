//! The moment at which a tooth switches the light barrier: the turn at which the rounding of its edge is as far from the beam's axis as
//! both radii together (`docs/mathematics/skiving.md#light-barrier`).

use super::pose::{swivelled, turned};
use super::{Beam, MeasuringPose, RealTool, nominal_angle};
use crate::{MeasuringTrack, SkivingError, VirtualEdge};
use foundation::numerics::wrapped_angle;
use nalgebra::Vector3;

/// A tooth at the moment in which it switches. rad, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// B, not wrapped: near the nominal angle.
    pub turn: f64,
    /// Length of roll that touches.
    pub w: f64,
    /// Angle of the touch on the rounding.
    pub angle: f64,
    /// What is left of the two equations, mm.
    pub residual: f64,
}

/// A cylinder that switches where the tool comes as near as a radius, and where it is.
#[derive(Clone, Copy, Debug)]
pub struct Barrier<'a> {
    /// The beam.
    pub beam: &'a Beam,
    /// Where the tool stands.
    pub pose: &'a MeasuringPose,
}

/// Steps of Newton's iteration, and the last of them, rad and mm; the length of roll follows from the curvature of the gap, less sharply.
const STEPS: usize = 40;
const LAST: f64 = 1e-14;
const LAST_ROLL: f64 = 1e-9;
/// The longest step along the edge, in shares of its length, and about the tool, in shares of a pitch: far starts must not be thrown
/// to another tooth.
const LONGEST_WAY: f64 = 0.25;
const LONGEST_TURN: f64 = 0.1;
/// What a converged touch may miss, mm.
const RESIDUAL: f64 = 1e-11;
/// Material that no whole edge lacks, mm: one with less at its end is chipped there. A deep chip moves the touch along the edge, past the
/// end of tracks that lie beside it; then the end itself switches.
const CHIPPED: f64 = 20e-3;

impl Barrier<'_> {
    /// Where a tooth of a tool switches, from the nominal place of a track on. The switch is at `radius` from the beam's axis, mm. An edge
    /// that is chipped at its end switches there where the touch would lie beyond it.
    ///
    /// # Errors
    /// [`SkivingError::NoTrigger`], [`SkivingError::EdgeEndTouched`], [`SkivingError::BodyTouched`].
    pub fn touch(
        &self,
        edge: &VirtualEdge,
        tool: &RealTool,
        track: &MeasuringTrack,
        tooth: usize,
        radius: f64,
    ) -> Result<Touch, SkivingError> {
        let start = nominal_angle(self.pose, tooth, tool.teeth());
        let mut touch = self.anywhere(edge, tool, tooth, radius, [track.contact.w, start])?;
        let [from, to] = edge.flank().range();
        if !(from..=to).contains(&touch.w) {
            let end = touch.w.clamp(from, to);
            let profile = tool.edges[edge.side()][tooth].profile_at(edge.flank().edge_coordinate(end));
            if profile > -CHIPPED {
                return Err(SkivingError::EdgeEndTouched { tooth, w: touch.w, from, to });
            }
            touch = self.at_end(edge, tool, tooth, radius, [end, touch.turn])?;
        }
        let [least, greatest] = edge.section(touch.w).range;
        if !(least..=greatest).contains(&touch.angle) {
            return Err(SkivingError::BodyTouched { tooth, angle: touch.angle, least, greatest });
        }
        Ok(touch)
    }

    /// Distance of a tooth's rounding, as if it went all around, from the beam's axis at a length of roll and a turn B, mm, and the angle
    /// on the rounding that is nearest to it, rad.
    pub fn distance(
        &self,
        edge: &VirtualEdge,
        tool: &RealTool,
        tooth: usize,
        [w, turn]: [f64; 2],
    ) -> (f64, f64) {
        let at = self.gap(edge, tool, tooth, [w, turn]);
        (at.distance, edge.section(w).angle_of(&tool.direction_in_tooth(tooth, &at.towards_beam)))
    }

    /// The touch of the rounding as if it went all around, wherever it lies; from a length of roll and a turn on.
    ///
    /// # Errors
    /// [`SkivingError::NoTrigger`].
    pub fn anywhere(
        &self,
        edge: &VirtualEdge,
        tool: &RealTool,
        tooth: usize,
        radius: f64,
        [mut w, mut turn]: [f64; 2],
    ) -> Result<Touch, SkivingError> {
        if tool.broken[tooth] {
            return Err(SkivingError::NoTrigger { tooth });
        }
        let [from, to] = edge.flank().range();
        let longest = LONGEST_WAY * (to - from);
        let pitch = std::f64::consts::TAU / tool.teeth() as f64;
        for _ in 0..STEPS {
            let at = self.gap(edge, tool, tooth, [w, turn]);
            let f = [at.distance - radius, at.by_roll];
            let determinant = at.by_roll * at.by_roll_turn - at.by_turn * at.by_roll_roll;
            let step = [
                (f[0] * at.by_roll_turn - f[1] * at.by_turn) / determinant,
                (at.by_roll * f[1] - at.by_roll_roll * f[0]) / determinant,
            ];
            if !(step[0].is_finite() && step[1].is_finite()) {
                return Err(SkivingError::NoTrigger { tooth });
            }
            w -= step[0].clamp(-longest, longest);
            turn -= step[1].clamp(-LONGEST_TURN * pitch, LONGEST_TURN * pitch);
            if step[1].abs() < LAST * turn.abs().max(1.0) && step[0].abs() < LAST_ROLL {
                return self.settled((edge, tool), tooth, radius, [w, turn], true);
            }
        }
        Err(SkivingError::NoTrigger { tooth })
    }

    /// The touch where a search came to rest: inside the edge, where rolling brings nothing nearer, or at an end of it.
    fn settled(
        &self,
        (edge, tool): (&VirtualEdge, &RealTool),
        tooth: usize,
        radius: f64,
        [w, turn]: [f64; 2],
        inside: bool,
    ) -> Result<Touch, SkivingError> {
        let at = self.gap(edge, tool, tooth, [w, turn]);
        let slope = if inside { at.by_roll.abs() } else { 0.0 };
        let residual = (at.distance - radius).abs().max(slope);
        let angle = edge.section(w).angle_of(&tool.direction_in_tooth(tooth, &at.towards_beam));
        if residual < RESIDUAL {
            Ok(Touch { turn, w, angle, residual })
        } else {
            Err(SkivingError::NoTrigger { tooth })
        }
    }

    /// The touch of an end of the edge, from a turn on.
    fn at_end(
        &self,
        edge: &VirtualEdge,
        tool: &RealTool,
        tooth: usize,
        radius: f64,
        [w, mut turn]: [f64; 2],
    ) -> Result<Touch, SkivingError> {
        let pitch = std::f64::consts::TAU / tool.teeth() as f64;
        for _ in 0..STEPS {
            let at = self.gap(edge, tool, tooth, [w, turn]);
            let step = (at.distance - radius) / at.by_turn;
            if !step.is_finite() {
                break;
            }
            turn -= step.clamp(-LONGEST_TURN * pitch, LONGEST_TURN * pitch);
            if step.abs() < LAST * turn.abs().max(1.0) {
                return self.settled((edge, tool), tooth, radius, [w, turn], false);
            }
        }
        Err(SkivingError::NoTrigger { tooth })
    }

    /// Distance of the rounding's surface from the beam's axis, with its derivatives.
    fn gap(&self, edge: &VirtualEdge, tool: &RealTool, tooth: usize, [w, turn]: [f64; 2]) -> Gap {
        let ([c, c_w, c_ww], [rho, rho_w, rho_ww]) = tool.centre(edge, tooth, w);
        let unit = self.beam.unit();
        let across = |v: &Vector3<f64>| v - unit * unit.dot(v);
        let to_machine = |v: &Vector3<f64>| swivelled(self.pose.swivel, &turned(turn, v));
        let about = |v: &Vector3<f64>| to_machine(&Vector3::new(-v.y, v.x, 0.0));
        let off = across(&(self.pose.position + to_machine(&c) - self.beam.point));
        let distance = off.norm();
        let away = off / distance;
        let (p_w, p_b) = (across(&to_machine(&c_w)), across(&about(&c)));
        let (d_w, d_b) = (away.dot(&p_w), away.dot(&p_b));
        Gap {
            distance: distance - rho,
            by_roll: d_w - rho_w,
            by_turn: d_b,
            by_roll_roll: (p_w.norm_squared() - d_w * d_w) / distance + away.dot(&to_machine(&c_ww)) - rho_ww,
            by_roll_turn: (p_w.dot(&p_b) - d_w * d_b) / distance + away.dot(&about(&c_w)),
            towards_beam: turned(-turn, &swivelled(-self.pose.swivel, &-away)),
        }
    }
}

/// The distance and its derivatives by length of roll and turn.
struct Gap {
    distance: f64,
    by_roll: f64,
    by_turn: f64,
    by_roll_roll: f64,
    by_roll_turn: f64,
    /// Direction from the edge to the beam in coordinates of the spindle.
    towards_beam: Vector3<f64>,
}

impl Touch {
    /// B in -pi..pi.
    pub fn wrapped_turn(&self) -> f64 {
        wrapped_angle(self.turn)
    }
}
