//! The proof by rays: the cutter moves as the text says, and what it leaves is compared with what was planned
//! (`docs/mathematics/milling.md#the-referee`).

use super::build::{MillingProgram, MillingPrograms};
use super::failure::{not_proven, of_removal};
use super::steps::StepKind;
use super::task::MillingWork;
use foundation::numerics::Progress;
use nc::Dialect;
use referee::{CutterPlace, MillPath, Milling, NormalRay, Unmilled, mill};
use run::RunFailure;

/// What the rays say about a control's text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayProof {
    /// The control.
    pub dialect: Dialect,
    /// Largest difference of a ray's length from the planned one, um.
    pub difference_um: f64,
    /// What digits and straight blocks explain, um.
    pub allowed_um: f64,
}

/// A displaced cutter changes the length of a ray by more than its own displacement where it cuts the ray at an angle: on scallops of
/// up to 45 degrees.
pub const OBLIQUE: f64 = std::f64::consts::SQRT_2;
/// Error of rays and comparison, um.
const MARGIN_UM: f64 = 0.01;

impl MillingPrograms {
    /// Mills the rays of the first space as every text says, rapid moves included, and compares them with `planned`: the lengths (mm)
    /// that the planned paths leave, `None` for a ray that they do not meet. `stock` and `depth` as the planned rays had them, mm.
    ///
    /// # Errors
    /// [`RunFailure`] for a text that leaves another flank: nothing is to be written then. [`RunFailure`] of the rays themselves.
    pub fn prove(
        &self,
        work: &MillingWork<'_>,
        rays: &[NormalRay],
        planned: &[Option<f64>],
        [stock, depth]: [f64; 2],
        progress: &dyn Progress,
    ) -> Result<Vec<RayProof>, RunFailure> {
        if rays.len() != planned.len() {
            let text = format!("{} rays with {} planned lengths", rays.len(), planned.len());
            return Err(not_proven(text));
        }
        let cutters = work.cutters();
        let mut proofs = Vec::new();
        for program in &self.programs {
            let paths = program.first_space_paths();
            let setup = Milling { cutters: &cutters, paths: &paths, stock, depth };
            let milled = mill(&setup, rays, progress).map_err(|error| of_removal(&error))?;
            let straight = program.motion.straight;
            let moved = program.rounding.distance + straight.tip + straight.axis * self.lever;
            let allowed_um = OBLIQUE * moved * 1e3 + milled.error_um + MARGIN_UM;
            let mut difference_um = 0.0f64;
            for (k, (found, planned)) in milled.rays.iter().zip(planned).enumerate() {
                // A side that slides along itself while the cutter is drawn back: the ray tells nothing.
                if matches!(found, Err(Unmilled::NotSettled)) {
                    continue;
                }
                let found = found.ok().map(|ray| ray.length);
                let difference = match (found, planned) {
                    (Some(found), Some(planned)) => (found - planned).abs() * 1e3,
                    (None, None) => 0.0,
                    _ => f64::INFINITY,
                };
                // Written so that NaN fails.
                let same = difference <= allowed_um;
                if !same {
                    return Err(not_proven(format!(
                        "read back and simulated, {} deviates from the plan by {difference:.4} um at ray {k}; segmentation and rounding account for \
                         {allowed_um:.4} um",
                        program.file
                    )));
                }
                difference_um = difference_um.max(difference);
            }
            proofs.push(RayProof { dialect: program.dialect, difference_um, allowed_um });
        }
        Ok(proofs)
    }
}

impl MillingProgram {
    /// The motions of the text in the first space as paths of cutters, index of the operation as index of the cutter; not the first
    /// positioning of a tool, which comes from outside.
    pub fn first_space_paths(&self) -> Vec<MillPath> {
        self.paths(|kind| kind != StepKind::Position)
    }

    /// Only the rapid ones among them.
    pub fn first_space_rapid_paths(&self) -> Vec<MillPath> {
        self.paths(|kind| matches!(kind, StepKind::Link | StepKind::Unwind | StepKind::End))
    }

    fn paths(&self, wanted: impl Fn(StepKind) -> bool) -> Vec<MillPath> {
        let mut paths: Vec<MillPath> = Vec::new();
        for (expected, found) in self.expected.iter().zip(&self.moves) {
            let [run, number] = expected.step;
            let step = &self.motion.tools[run].steps[number];
            if step.space != 0 || expected.stands || !wanted(step.kind) {
                continue;
            }
            let same = |a: &CutterPlace, b: &CutterPlace| a.tip == b.tip && a.axis == b.axis;
            match paths.last_mut() {
                Some(path)
                    if path.cutter == step.operation
                        && path.places.last().zip(found.places.first()).is_some_and(|(a, b)| same(a, b)) =>
                {
                    path.places.extend(found.places.iter().skip(1));
                }
                _ => paths.push(MillPath { cutter: step.operation, places: found.places.clone() }),
            }
        }
        paths
    }
}
