//! What tools that exist carry: the flanks of a given worm, the profile of a given dresser.

use crate::job::LoadedJob;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::modification::{EvaluationField, Modification, ModificationError};
use generating::GrindingSetup;
use job::tables::Modification as JobModification;
use job::{Diagnostic, Problem};
use run::{RunFailure, job_files, modification_finding};

/// What a given tool carries on its flanks, over (w_1, z_1).
pub(super) fn tool_modifications(
    loaded: &LoadedJob,
    setup: &GrindingSetup,
) -> Result<Sides<Modification>, RunFailure> {
    let worm = &loaded.job.worm;
    let specs = worm.modifications.as_deref().unwrap_or_default();
    let Some(width) = worm.width else {
        let finding = Diagnostic::new(Problem::MissingKey, "a tool that exists has a width")
            .field("worm.width")
            .allowed("the usable width of the tool in mm, with z_1 = 0 in its middle")
            .way_out("give worm.width");
        return Err(RunFailure::bad_input(finding));
    };
    Sides::try_from_fn(|flank| {
        let f = setup.pair.worm.flank(flank);
        let rolls = setup.lines[flank].worm_rolls(&MotionLaw::zero());
        let ends = [-0.5 * width, 0.5 * width];
        let fault =
            |e: &ModificationError| RunFailure::bad_input(modification_finding(e, "worm.modifications"));
        let field =
            EvaluationField::new(rolls, ends, f.base_radius, f.base_helix_angle).map_err(|e| fault(&e))?;
        Modification::for_flank(specs, flank, &field, &job_files(loaded)).map_err(|e| fault(&e))
    })
}

/// What a dresser leaves on the gear; `place` is its key in the job, `elsewhere` where its helix modifications belong.
///
/// # Errors
/// A finding on that key for what is impossible or no function of the profile alone.
pub(super) fn dresser_profile(
    loaded: &LoadedJob,
    specs: &[JobModification],
    flank: Flank,
    field: &EvaluationField,
    (place, elsewhere): (&str, &str),
) -> Result<Modification, Diagnostic> {
    let made = Modification::for_flank(specs, flank, field, &job_files(loaded))
        .map_err(|e| modification_finding(&e, place))?;
    if !made.terms().iter().all(Modification::depends_on_profile_only) {
        return Err(Diagnostic::new(
            Problem::InvalidJob,
            "a dresser can only carry modifications of the profile",
        )
        .field(place)
        .allowed("profile crowning, profile slope, tip or root relief")
        .way_out(format!("leave helix modifications to {elsewhere}")));
    }
    Ok(made)
}
