//! What tools that exist carry: the flanks of a given worm, the profile of a given dresser.

use crate::job::{FlankForm, LoadedJob, Worm};
use dressing::WormForm;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::modification::{EvaluationField, GridSpec, Modification, ModificationError, Reference};
use foundation::numerics::equidistant;
use generating::GrindingSetup;
use job::tables::Modification as JobModification;
use job::{Diagnostic, Loaded, Problem};
use run::{RunFailure, job_files, modification_finding};

/// What a given tool carries on its flanks, over (w_1, z_1).
pub(super) fn tool_modifications(
    loaded: &LoadedJob,
    setup: &GrindingSetup,
) -> Result<Sides<Modification>, RunFailure> {
    let worm = &loaded.job.worm;
    let specs = worm.modifications.as_deref().unwrap_or_default();
    let Some(width) = worm.width else {
        let finding = Diagnostic::new(Problem::MissingKey, "a tool whose flanks are given has a width")
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
        let mut all = specs.to_vec();
        all.extend(form_of_flank(worm, setup, flank, (rolls, ends))?);
        Modification::for_flank(&all, flank, &field, &job_files(loaded)).map_err(|e| fault(&e))
    })
}

/// Points of the table of a flank form over the profile; along the worm it is the same everywhere.
const FORM_POINTS: [usize; 2] = [97, 4];
/// Share of the used profile by which that table goes on at each end: corrections of the motion move the contact.
const FORM_MARGIN: f64 = 0.15;

/// What the form of a tool's flank adds to the involute, as a modification; `None` for an involute worm.
fn form_of_flank(
    worm: &Worm,
    setup: &GrindingSetup,
    flank: Flank,
    (rolls, ends): ([f64; 2], [f64; 2]),
) -> Result<Option<JobModification>, RunFailure> {
    let form = match (worm.flank_form, worm.form_disc_diameter) {
        (FlankForm::Zi, _) => return Ok(None),
        (FlankForm::Za, _) => WormForm::Axial,
        (FlankForm::Zn, _) => WormForm::Normal,
        // The job's checks ask for the diameter.
        (FlankForm::Zk, diameter) => WormForm::Disc { diameter: diameter.unwrap_or_default() },
    };
    let body = &setup.pair.worm;
    let involute = body.flank(flank);
    let beyond = FORM_MARGIN * (rolls[1] - rolls[0]);
    // Half of what is left above the base circle, where the margin would reach below it.
    let range = [(rolls[0] - beyond).max(0.5 * rolls[0]), rolls[1] + beyond];
    let w_mm = equidistant(range, FORM_POINTS[0]);
    let f = form
        .distances(body, flank, &w_mm)
        .map_err(|e| RunFailure::not_producible(Diagnostic::of(&e).field("worm.flank_form")))?;
    let transverse = 1e3 / involute.base_helix_angle.cos();
    Ok(Some(JobModification::Grid(GridSpec {
        w_mm,
        z_mm: equidistant(ends, FORM_POINTS[1]),
        f_um: f.iter().map(|f| vec![f * transverse; FORM_POINTS[1]]).collect(),
        file: None,
        flank: flank.into(),
        reference: Reference::default(),
    })))
}

/// What a dresser leaves on the gear; `place` is its key in the job, `elsewhere` where its helix modifications belong.
///
/// # Errors
/// A finding on that key for what is impossible or no function of the profile alone.
pub fn dresser_profile<J>(
    loaded: &Loaded<J>,
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
        .allowed("profile crowning, profile slope, tip or root relief, a measured profile, a polynomial or formula without z and v")
        .way_out(format!("leave helix modifications to {elsewhere}")));
    }
    Ok(made)
}
