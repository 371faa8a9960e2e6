//! Jobs and REXS models: the gear and its modifications pass from one to the other. What cannot be transferred is reported.

use foundation::modification::ModificationSpec;
use generating_grinding::job::{Job, LoadedJob};
use job::tables::Gear as JobGear;
use job::{Diagnostic, Problem};
use measured_files::rexs::{
    Author, RexsDocument, RexsError, RexsFormat, RexsGear, RexsWarning, RexsWarningKind, document_of,
    gear_ids, gear_of, read_rexs, rexs_bytes,
};
use run::{JobFailure, RunFailure, job_files, standing_elsewhere};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::Path;
use verdict::Remark;

/// Lengths closer than this are the same, mm.
const SAME: f64 = 1e-6;

/// What a REXS model says of a gear, as a job has it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct GearOfRexs {
    /// The table `[gear]`.
    pub gear: JobGear,
    /// The entries of `target.modifications`.
    pub modifications: Vec<ModificationSpec>,
}

impl GearOfRexs {
    /// A job with this gear and these modifications in place of its own, as it can be written anywhere; its settings and compensation,
    /// made for another gear, are left out.
    ///
    /// # Errors
    /// A job that JSON cannot hold.
    pub fn into_job(self, template: &LoadedJob) -> Result<serde_json::Value, serde_json::Error> {
        let own = &template.job.gear;
        let mut gear = self.gear;
        let same = |a: f64, b: f64| (a - b).abs() <= SAME;
        // What the model has no place for is that of the same body, drawn before.
        if gear.teeth == own.teeth
            && same(gear.normal_module, own.normal_module)
            && same(gear.tip_diameter, own.tip_diameter)
            && same(gear.root_diameter, own.root_diameter)
        {
            gear.form_diameter = gear.form_diameter.or(own.form_diameter);
            gear.evaluation = gear.evaluation.or(own.evaluation);
            gear.measured_over = gear.measured_over.or(own.measured_over);
            // Without a stated start the model's profile begins at its root, where there is no involute yet: the drawing knows better.
            let begins = own.evaluation.and_then(|e| e.start_diameter).or(own.form_diameter);
            if let (Some(begins), Some(evaluation)) = (begins, gear.evaluation.as_mut()) {
                let inside = |d: f64| if gear.teeth > 0 { d < begins } else { d > begins };
                if evaluation.start_diameter.is_some_and(inside) {
                    evaluation.start_diameter = own.evaluation.and_then(|e| e.start_diameter);
                }
            }
        }
        let mut job = Job { gear, settings: None, compensation: None, ..template.job.clone() };
        job.target.modifications = Some(self.modifications);
        job.target.file = None;
        standing_elsewhere(template, &job)
    }
}

/// Reads a gear of a REXS model: that numbered `id`, or the only one.
///
/// # Errors
/// [`RunFailure`]: a file that is no model, no gear of this number, several without a number, what a job needs and the model does not say.
pub fn gear_of_rexs(path: &Path, id: Option<i32>) -> Result<(GearOfRexs, Vec<Remark>), RunFailure> {
    let refused = |error: RexsError| of_rexs(&error, path);
    let document = read_rexs(path).map_err(refused)?;
    let id = chosen(&gear_ids(&document), id, path)?;
    let (found, read) = gear_of(&document, id).map_err(refused)?;
    let (gear, lost) = found.job_gear().map_err(refused)?;
    let remarks = read.iter().chain(&lost).map(|w| remark(w, "compare with the drawing")).collect();
    Ok((GearOfRexs { gear, modifications: found.job_modifications() }, remarks))
}

fn chosen(ids: &[i32], wanted: Option<i32>, path: &Path) -> Result<i32, RunFailure> {
    let listed = ids.iter().map(i32::to_string).collect::<Vec<_>>().join(", ");
    let wrong = |message: String, value: String| {
        let finding = Diagnostic::new(Problem::InvalidNumber, message).field("gear").value(value);
        RunFailure::bad_input(
            finding.allowed(format!("one of {listed}")).way_out("tell which with `--gear NUMBER`"),
        )
    };
    match (ids, wanted) {
        ([], _) => {
            let message = format!("{} has no cylindrical gear", path.display());
            let finding = Diagnostic::new(Problem::InvalidTable, message).field("components");
            Err(RunFailure::bad_input(
                finding
                    .allowed("a component cylindrical_gear or ring_gear")
                    .way_out("export the model with its gears"),
            ))
        }
        ([only], None) => Ok(*only),
        (_, None) => Err(wrong(format!("{} has {} gears", path.display(), ids.len()), "none chosen".into())),
        (_, Some(id)) if ids.contains(&id) => Ok(id),
        (_, Some(id)) => Err(wrong(format!("{} has no gear {id}", path.display()), id.to_string())),
    }
}

/// The gear of a job and the modifications of its target as the bytes of a REXS file.
///
/// # Errors
/// [`JobFailure`]: a gear or a modification that REXS has no place for, tables that cannot be read.
pub fn rexs_of_job(
    loaded: &LoadedJob,
    format: RexsFormat,
    packed: bool,
    author: &Author,
) -> Result<(Vec<u8>, Vec<Remark>), JobFailure> {
    let job = &loaded.job;
    let refused = |error: RexsError| RunFailure::bad_input(Diagnostic::of(&error).field("gear"));
    if job.target.file.is_some() {
        let finding =
            Diagnostic::new(Problem::InvalidTable, "the target is a table, which is no modification by name")
                .field("target.file")
                .way_out(
                    "give it as an entry of `target.modifications`, e.g. { kind = \"grid\", file = \"..\" }",
                );
        return Err(RunFailure::bad_input(finding).into());
    }
    let modifications = job.target.modifications.as_deref().unwrap_or_default();
    let mut gear = RexsGear::of_job(&job.gear, modifications).map_err(refused)?;
    gear.name = Some(job.job.name.clone());
    let (document, mut warnings) = document_of(&gear, &job_files(loaded), author).map_err(refused)?;
    let (bytes, lost) = rexs_bytes(&document, format, packed).map_err(refused)?;
    warnings.extend(lost);
    warnings.extend(lost_keys(&job.gear, &document));
    let remarks = warnings.iter().map(|w| remark(w, "tell it to the reader of the file in another way"));
    Ok((bytes, remarks.collect()))
}

/// Keys of the gear that do not come back from the model.
fn lost_keys(gear: &JobGear, document: &RexsDocument) -> Option<RexsWarning> {
    let id = *gear_ids(document).first()?;
    let (back, _) = gear_of(document, id).ok()?.0.job_gear().ok()?;
    let mut lost = Vec::new();
    if gear.evaluation.is_some() && back.evaluation.is_none() {
        lost.push("gear.evaluation");
    }
    for (key, given) in [
        (
            "gear.allowances_um of the normal tooth thickness, for which REXS has no attribute (the gear is exported in the middle between them),",
            gear.allowances_um.is_some() && back.allowances_um.is_none(),
        ),
        ("gear.measured_over", gear.measured_over.is_some()),
    ] {
        if given {
            lost.push(key);
        }
    }
    let exported = if lost.len() == 1 { "is" } else { "are" };
    let message = format!("{} {exported} not exported", lost.join(" and "));
    (!lost.is_empty()).then(|| RexsWarning::new(RexsWarningKind::Lost, message))
}

/// What was assumed or lost, as a remark.
pub(super) fn remark(warning: &RexsWarning, way_out: &str) -> Remark {
    Remark { code: warning.kind.code(), text: warning.message.clone(), way_out: way_out.into() }
}

/// An error of reading a model, with its file.
pub(super) fn of_rexs(error: &RexsError, path: &Path) -> RunFailure {
    let message = match error {
        RexsError::Unreadable { .. } => error.to_string(),
        _ => format!("{}: {error}", path.display()),
    };
    RunFailure::bad_input(Diagnostic::with_code(error.code(), message).way_out(error.way_out()))
}
