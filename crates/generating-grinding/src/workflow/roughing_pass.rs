//! What the strokes that leave stock do in the areas of the worm that are kept for them. Knows the job, no body.

use crate::job::{Job, StrokeOfJob};
use foundation::kinematics::MotionLaw;

/// An area of the worm that is kept for roughing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoughingArea {
    /// Diagonal ratio in it.
    pub ratio: f64,
    /// Whether a stroke gives its ratio.
    pub own_ratio: bool,
    /// Share of the modification that it makes; `None`: the dresser stands still in it.
    pub share: Option<f64>,
}

impl RoughingArea {
    /// Whether a stroke asks something of it.
    pub fn is_own(&self) -> bool {
        self.share.is_some() || self.own_ratio
    }

    /// Those of a job: the strokes that leave stock use them in turn.
    pub fn of_job(job: &Job) -> Vec<Self> {
        let usual = job.grinding.roughing_ratio.unwrap_or(0.0);
        let strokes = job.technology.iter().flat_map(|technology| &technology.strokes);
        let roughing: Vec<&StrokeOfJob> =
            strokes.filter(|stroke| stroke.left_um.sides().iter().any(|(_, um)| *um != 0.0)).collect();
        let area = |number: usize| {
            let stroke = roughing.get(number);
            let ratio = stroke.and_then(|stroke| stroke.shift?.ratio);
            Self {
                ratio: ratio.unwrap_or(usual),
                own_ratio: ratio.is_some(),
                share: stroke.and_then(|stroke| stroke.modification_share),
            }
        };
        (0..job.grinding.roughing_areas as usize).map(area).collect()
    }
}

/// How strokes use a roughing area.
#[derive(Clone, Debug, PartialEq)]
pub struct RoughingPass {
    /// z_V1 over z_V2, mm.
    pub shift: MotionLaw,
    /// The area.
    pub area: RoughingArea,
}
