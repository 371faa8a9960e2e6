//! What a text says of one thread, and the referee that is asked with it.

use foundation::geometry::Sides;
use foundation::kinematics::{DressingMotion, GeneratingMotion};
use metrology::Topography;
use motion::ReadStroke;
use run::RunFailure;

/// Finishing strokes of one thread and one index stroke, one for each stroke of the run.
#[derive(Clone, Debug)]
pub struct ReadBack {
    /// Dressing; empty for a worm that no program dresses.
    pub dressing: Vec<ReadStroke<DressingMotion>>,
    /// Grinding.
    pub grinding: Vec<ReadStroke<GeneratingMotion>>,
}

/// The referee of a process, asked with motions from a text.
pub trait Judge {
    /// The flanks that these strokes leave; `area`: z_V1 of their finishing area less that of the first, mm.
    ///
    /// # Errors
    /// Those of the stages.
    fn flanks(&self, read: &ReadBack, area: f64) -> Result<Sides<Option<Topography>>, RunFailure>;

    /// Lengths of rays on a coarse grid over the worm flank that these dressing strokes leave in a finishing area, mm.
    ///
    /// # Errors
    /// Those of dressing.
    fn thread(
        &self,
        dressing: &[ReadStroke<DressingMotion>],
        area: f64,
    ) -> Result<Sides<Option<Vec<f64>>>, RunFailure>;
}

/// A flank of the run itself.
#[derive(Clone, Debug)]
pub struct RunFlank {
    /// What the rays left, normal, mm.
    pub rays: Topography,
    /// Its deviation from the target, in the measure of the job, mm.
    pub deviation: Topography,
}

impl RunFlank {
    /// Largest difference of a flank from this one, and largest deviation from the target in the measure of the job, um.
    pub fn differences_um(&self, left: &Topography) -> [f64; 2] {
        let apart = left.minus(&self.rays);
        let f = self.deviation.f.iter().zip(&apart.f).map(|(d, a)| d + a).collect();
        let deviation = Topography { f, ..self.deviation.clone() };
        [largest(&apart), largest(&deviation)].map(|mm| mm * 1e3)
    }
}

impl RunFlank {
    /// Where a flank deviates most from the target: w and z, mm.
    pub fn worst(&self, left: &Topography) -> [f64; 2] {
        let apart = left.minus(&self.rays);
        let off = self.deviation.f.iter().zip(&apart.f).map(|(d, a)| (d + a).abs());
        let columns = self.deviation.z.len().max(1);
        let worst = off.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(k, _)| k);
        let at = |values: &[f64], k: usize| values.get(k).copied().unwrap_or(f64::NAN);
        [at(&self.deviation.w, worst / columns), at(&self.deviation.z, worst % columns)]
    }
}

/// Largest value; a value that is no number is infinite.
fn largest(of: &Topography) -> f64 {
    if of.f.iter().any(|f| f.is_nan()) { f64::INFINITY } else { of.largest() }
}
