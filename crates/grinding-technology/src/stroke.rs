//! A stroke as it is asked for.

use super::TechnologyError;
use super::error::{in_range, positive};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::numerics::equidistant;

/// Which way the workpiece feeds past the worm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Direction {
    /// z_V2 rises.
    #[default]
    Up,
    /// z_V2 falls.
    Down,
}

impl Direction {
    /// sigma.
    pub fn sign(self) -> f64 {
        match self {
            Self::Up => 1.0,
            Self::Down => -1.0,
        }
    }
}

/// z_V1 = law(z_V2) + part step.
#[derive(Clone, Debug, PartialEq)]
pub struct Shift {
    /// z_V1 over z_V2 of the first part since dressing, mm.
    pub law: MotionLaw,
    /// Jump from one part to the next, mm.
    pub step_per_part: f64,
}

impl Shift {
    /// z_V1 = ratio z_V2 + origin, without a jump.
    pub fn straight(ratio: f64, origin: f64) -> Self {
        Self { law: MotionLaw::polynomial(0.0, vec![origin, ratio]), step_per_part: 0.0 }
    }
}

/// Places at which the slope of a shift is looked at.
const SLOPES: usize = 65;

/// Diagonal ratios of a shift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShiftRatios {
    /// From end to end.
    pub mean: f64,
    /// The one farthest from 0.
    pub steepest: f64,
}

impl ShiftRatios {
    /// Of a law over a range of the feed.
    pub fn of(law: &MotionLaw, [from, to]: [f64; 2]) -> Self {
        let mean = (law.value(to) - law.value(from)) / (to - from);
        if law.is_affine() {
            return Self { mean, steepest: mean };
        }
        let slopes = equidistant([from, to], SLOPES).into_iter().map(|v| law.jet(v)[1]);
        let steepest = slopes.fold(mean, |most, slope| if slope.abs() > most.abs() { slope } else { most });
        Self { mean, steepest }
    }
}

/// Flanks that a stroke grinds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ground {
    /// Both at once.
    #[default]
    Both,
    /// One by itself.
    Only(Flank),
}

impl Ground {
    /// Whether a flank is among them.
    pub fn has(self, flank: Flank) -> bool {
        match self {
            Self::Both => true,
            Self::Only(only) => only == flank,
        }
    }

    /// The flanks.
    pub fn flanks(self) -> impl Iterator<Item = Flank> {
        Flank::BOTH.into_iter().filter(move |&flank| self.has(flank))
    }
}

/// A stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// Flanks that it grinds.
    pub ground: Ground,
    /// Stock left on each of them, mm.
    pub left: Sides<f64>,
    /// Feed per workpiece revolution, mm.
    pub feed_per_revolution: f64,
    /// At the worm's tip, m/s.
    pub cutting_speed: f64,
    /// Sense of the feed.
    pub direction: Direction,
    /// Shift of the worm.
    pub shift: Shift,
    /// Way beyond first and last contact, each, mm.
    pub overrun: f64,
    /// Pause after the stroke, s.
    pub dwell: f64,
    /// Name of the worm zone that it uses.
    pub zone: String,
}

impl Stroke {
    /// Whether it leaves nothing: it makes the flank, or sparks out.
    pub fn finishes(&self) -> bool {
        self.ground.flanks().all(|flank| self.left[flank] == 0.0)
    }
}

const UM: f64 = 1e3;

/// Checks strokes in driving order.
pub(crate) fn check(strokes: &[Stroke]) -> Result<(), TechnologyError> {
    in_range("technology.strokes", strokes.len() as f64, !strokes.is_empty(), "at least one stroke")?;
    for (k, stroke) in strokes.iter().enumerate() {
        let name = |key: &str| format!("technology.strokes[{k}].{key}");
        positive(&name("feed_per_revolution"), stroke.feed_per_revolution)?;
        positive(&name("cutting_speed_m_per_s"), stroke.cutting_speed)?;
        let [origin, ratio, _] = stroke.shift.law.jet(0.0);
        for (key, value) in [
            ("shift.ratio", ratio),
            ("shift.origin", origin),
            ("shift.step_per_part", stroke.shift.step_per_part),
        ] {
            in_range(&name(key), value, true, "a finite number")?;
        }
        for (key, value) in [("overrun", stroke.overrun), ("dwell_s", stroke.dwell)] {
            in_range(&name(key), value, value >= 0.0, ">= 0")?;
        }
        for flank in stroke.ground.flanks() {
            let left = stroke.left[flank];
            in_range(&name("left_um"), UM * left, left >= 0.0, ">= 0 um")?;
            let grinds = |other: &&Stroke| other.ground.has(flank);
            let before = strokes[..k].iter().rfind(grinds).map_or(f64::INFINITY, |before| before.left[flank]);
            let last = !strokes[k + 1..].iter().any(|other| grinds(&other));
            if left > before || last && left != 0.0 {
                return Err(TechnologyError::StrokeOrder {
                    stroke: k + 1,
                    flank,
                    left_um: UM * left,
                    before_um: UM * before,
                });
            }
        }
    }
    Ok(())
}
