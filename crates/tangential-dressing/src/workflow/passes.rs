//! The passes of a run: flanks that are ground by one motion, over all that each of them needs.

use super::flank::TangentialRun;
use super::prepare::TangentialPrepared;
use crate::TangentialFlank;
use contact::Measure;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::GeneratingMotion;
use foundation::numerics::extremes;

/// A pass with its flanks as run; never without one.
pub struct TangentialPass<'a> {
    /// The flanks in their order.
    pub runs: Vec<(Flank, &'a TangentialRun)>,
}

/// The passes in the order in which they are ground.
pub fn passes_of_runs(runs: &Sides<Option<TangentialRun>>) -> Vec<TangentialPass<'_>> {
    let mut passes: Vec<TangentialPass<'_>> = Vec::new();
    for (flank, run) in runs.iter().filter_map(|(flank, run)| Some((flank, run.as_ref()?))) {
        match passes.iter_mut().find(|pass| pass.runs.iter().any(|(_, other)| other.pass == run.pass)) {
            Some(pass) => pass.runs.push((flank, run)),
            None => passes.push(TangentialPass { runs: vec![(flank, run)] }),
        }
    }
    passes
}

impl TangentialPass<'_> {
    /// Its flanks.
    pub fn flanks(&self) -> Vec<Flank> {
        self.runs.iter().map(|&(flank, _)| flank).collect()
    }

    /// One of its flanks with the motions of the pass, which its other flanks share.
    pub fn ground<'a>(&self, ready: &'a TangentialPrepared) -> Option<TangentialFlank<'a>> {
        let &(flank, run) = self.runs.first()?;
        Some(TangentialFlank::new(&ready.model, flank, &run.pass, &run.settings, Measure::Ray))
    }

    /// The motion of grinding.
    pub fn motion(&self, ready: &TangentialPrepared) -> Option<GeneratingMotion> {
        self.ground(ready).map(|flank| flank.motion().clone())
    }

    /// x_D of the dressing stroke, mm.
    pub fn dressing(&self) -> [f64; 2] {
        extremes(self.runs.iter().flat_map(|(_, run)| run.strokes.dressing))
    }

    /// z_V2 of the grinding stroke, mm.
    pub fn feed(&self) -> [f64; 2] {
        extremes(self.runs.iter().flat_map(|(_, run)| run.strokes.feed))
    }
}
