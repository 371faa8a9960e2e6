//! A worm topography as the thing that is wanted: what its flanks are to be, and the gear that follows from them, which takes the place of
//! a target.

use crate::workflow::generating_finding;
use foundation::geometry::{Flank, Sides};
use foundation::modification::{GridSpec, Modification, ModificationSpec, Reference};
use generating::{FeedLaw, GrindingSetup, PlanningGrid, gear_of_worm};
use job::{Diagnostic, Problem};
use run::RunFailure;

/// Points over profile and face width at which the gear that follows is computed; a spline goes through them.
const GEAR_POINTS: [usize; 2] = [33, 65];

/// The gear that follows from a wanted worm by exact contact under a diagonal ratio, as entries of a target, one for each flank of `which`.
///
/// # Errors
/// [`RunFailure`]: no ratio, a worm that leaves no envelope.
pub(super) fn gear_of_wanted_worm(
    setup: &GrindingSetup,
    wanted: &Sides<Modification>,
    ratio: Option<f64>,
    which: &[Flank],
) -> Result<Vec<ModificationSpec>, RunFailure> {
    let Some(ratio) = ratio else {
        let finding = Diagnostic::new(
            Problem::MissingKey,
            "which gear follows from a worm depends on how it is shifted; a ratio is chosen for targets of the gear only",
        )
        .field("grinding.diagonal_ratio")
        .allowed("a number beside worm.modifications, or method = \"radial\"")
        .way_out("give the ratio, e.g. diagonal_ratio = -1.2");
        return Err(RunFailure::bad_input(finding));
    };
    let shift = FeedLaw::Ratio(ratio).law(setup, which);
    let grid = PlanningGrid::new(setup, GEAR_POINTS[0], GEAR_POINTS[1]);
    let entry = |&flank: &Flank| -> Result<ModificationSpec, RunFailure> {
        let ground = gear_of_worm(setup, flank, &shift, &wanted[flank], &grid)
            .map_err(|e| generating_finding::failure(&e))?;
        let transverse = 1e3 / setup.lines[flank].cos_b2;
        Ok(ModificationSpec::Grid(GridSpec {
            w_mm: grid.w[flank].clone(),
            z_mm: grid.z.clone(),
            f_um: ground
                .chunks(grid.z.len())
                .map(|row| row.iter().map(|f| f * transverse).collect())
                .collect(),
            file: None,
            flank: flank.into(),
            reference: Reference::default(),
        }))
    };
    which.iter().map(entry).collect()
}
