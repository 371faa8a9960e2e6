//! A stroke as it is asked for.

use super::TechnologyError;
use super::error::{in_range, positive};
use foundation::geometry::{Flank, Sides};

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

/// z_V1 = ratio z_V2 + origin + part step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shift {
    /// Diagonal ratio K.
    pub ratio: f64,
    /// mm.
    pub origin: f64,
    /// Jump from one part to the next since dressing, mm.
    pub step_per_part: f64,
}

/// A stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// Stock left on each flank, mm.
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
        self.left.iter().all(|(_, left)| *left == 0.0)
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
        for (key, value) in [
            ("shift.ratio", stroke.shift.ratio),
            ("shift.origin", stroke.shift.origin),
            ("shift.step_per_part", stroke.shift.step_per_part),
        ] {
            in_range(&name(key), value, true, "a finite number")?;
        }
        for (key, value) in [("overrun", stroke.overrun), ("dwell_s", stroke.dwell)] {
            in_range(&name(key), value, value >= 0.0, ">= 0")?;
        }
        for flank in Flank::BOTH {
            let left = stroke.left[flank];
            in_range(&name("left_um"), UM * left, left >= 0.0, ">= 0 um")?;
            let before = if k == 0 { f64::INFINITY } else { strokes[k - 1].left[flank] };
            let last = k + 1 == strokes.len();
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
