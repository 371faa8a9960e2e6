//! What the control is shown of a run, whatever its process: bodies, speeds, and each pass with the flanks that it grinds.

use crate::contact::Pair;
use crate::exchange::job::Control;
use crate::geometry::Flank;
use crate::kinematics::GeneratingMotion;
use crate::metrology::Topography;
use crate::removal::WormModification;

/// A run that goes through a control. mm, rad, s.
pub(super) struct ControlledRun<'a> {
    /// `[control]` of the job.
    pub control: &'a Control,
    /// Worm and workpiece.
    pub pair: &'a Pair,
    /// Speed of the worm, unless `[control]` gives one.
    pub worm_speed: f64,
    /// Feed z_V2 per revolution of the workpiece.
    pub feed_per_revolution: f64,
    /// Tolerance at a length of roll and an axial position.
    pub tolerance: &'a dyn Fn(f64, f64) -> f64,
    /// The passes in the order in which they are ground.
    pub passes: Vec<ControlledPass<'a>>,
}

/// Flanks that are ground by one motion.
pub(super) struct ControlledPass<'a> {
    /// The motion over z_V2.
    pub motion: &'a GeneratingMotion,
    /// First and last z_V2.
    pub feed_range: [f64; 2],
    /// The flanks.
    pub flanks: Vec<GroundFlank<'a>>,
}

/// A flank as the run leaves it without errors of the control.
pub(super) struct GroundFlank<'a> {
    /// Which one.
    pub flank: Flank,
    /// Simulated less target, normal.
    pub deviation: Topography,
    /// f_n1 of the worm whose rays in time judge what the control leaves.
    pub worm: Box<dyn WormModification + 'a>,
    /// Largest length of a ray that counts as this flank's.
    pub stock: f64,
}

impl ControlledPass<'_> {
    /// Its flanks in words.
    pub fn name(&self) -> String {
        match self.flanks.as_slice() {
            [only] => format!("{} flank", only.flank),
            _ => "both flanks".to_owned(),
        }
    }
}
