//! The plan of a job of tangential dressing without its referee, as a preview.

use super::prepare::prepare_tangential;
use super::preview::{PreviewedPass, preview_passes};
use crate::job::TangentialJob;
use job::{Loaded, ProcessJob};
use run::{Preview, PreviewFlank, RunFailure};
use std::collections::BTreeMap;

/// Plans all passes of a job as far as the planned flanks.
///
/// # Errors
/// As the plan.
pub fn preview_tangential(loaded: &Loaded<TangentialJob>) -> Result<Preview, RunFailure> {
    let ready = prepare_tangential(loaded)?;
    let previewed_passes = preview_passes(&ready)?;
    let mut flanks = BTreeMap::new();
    for PreviewedPass { flank, target, planned, cos_b } in &previewed_passes.flanks {
        flanks.insert(flank.name(), PreviewFlank::of(target, planned, *cos_b));
    }
    Ok(Preview {
        process: TangentialJob::NAME,
        tolerance_um: ready.tolerance_um,
        settings: Preview::settings_of(&previewed_passes.settings)?,
        warnings: previewed_passes.warnings,
        flanks,
        motions: Vec::new(),
    })
}
