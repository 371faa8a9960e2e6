//! What the control is shown of a run, whatever its process: bodies, speeds, and each pass with the flanks that it grinds.

use contact::Pair;
use foundation::geometry::Flank;
use foundation::kinematics::GeneratingMotion;
use foundation::numerics::TensorSpline;
use job::tables::Control;
use metrology::Topography;
use referee::WormModification;

/// A run that goes through a control. mm, rad, s.
pub struct ControlledRun<'a> {
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
pub struct ControlledPass<'a> {
    /// The motion over z_V2.
    pub motion: &'a GeneratingMotion,
    /// First and last z_V2.
    pub feed_range: [f64; 2],
    /// The flanks.
    pub flanks: Vec<GroundFlank<'a>>,
}

/// A flank as the run leaves it without errors of the control.
pub struct GroundFlank<'a> {
    /// Which one.
    pub flank: Flank,
    /// Simulated less target, normal.
    pub deviation: Topography,
    /// The flank that the rays left, normal.
    pub simulated: &'a Topography,
    /// f_n1 of the worm whose rays in time judge what the control leaves.
    pub worm: GoesOn<'a>,
    /// Largest length of a ray that counts as this flank's.
    pub stock: f64,
}

/// A worm flank beyond the part that is known as at its border: a ray looks at the instants before and behind its contact as well, where
/// it meets the worm beside the part that is used.
pub struct GoesOn<'a>(pub &'a dyn WormModification);

impl WormModification for GoesOn<'_> {
    fn jet(&self, w: f64, z: f64) -> [f64; 3] {
        let [[from_w, to_w], [from_z, to_z]] = self.0.domain();
        let (at_w, at_z) = (w.max(from_w).min(to_w), z.max(from_z).min(to_z));
        let [f, by_w, by_z] = self.0.jet(at_w, at_z);
        [f, if at_w == w { by_w } else { 0.0 }, if at_z == z { by_z } else { 0.0 }]
    }

    fn creases(&self) -> &[f64] {
        self.0.creases()
    }

    fn error_um(&self) -> f64 {
        self.0.error_um()
    }
}

impl GroundFlank<'_> {
    /// Slopes of the worm that grinds it.
    pub fn worm_slopes(&self) -> impl Fn(f64, f64) -> [f64; 2] {
        |w, z| {
            let [_, by_w, by_z] = self.worm.jet(w, z);
            [by_w, by_z]
        }
    }

    /// Slopes of the flank that is left, by a spline through its grid; none where the grid is too coarse for one.
    pub fn slopes(&self) -> impl Fn(f64, f64) -> [f64; 2] {
        let rows: Vec<Vec<f64>> =
            self.simulated.f.chunks(self.simulated.z.len()).map(<[f64]>::to_vec).collect();
        let spline = TensorSpline::new(&self.simulated.w, &self.simulated.z, &rows).ok();
        move |w, z| {
            spline.as_ref().map_or([0.0; 2], |spline| {
                let jet = spline.jet(w, z);
                [jet.fu, jet.fv]
            })
        }
    }
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
