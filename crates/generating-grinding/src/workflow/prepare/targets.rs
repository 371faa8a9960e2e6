//! What the drawing wants: targets of the flanks that are ground and their tolerance. Each modification is built here, once.

use crate::job::{Job, LoadedJob, ToleranceMapSource};
use foundation::geometry::{Flank, Sides};
use foundation::modification::{
    EvaluationField, GridSpec, Modification, ModificationError, ModificationSpec, PointMethod, PointsSpec,
    ToleranceMap,
};
use job::{Diagnostic, TableForm, read_tolerances, table_form};
use run::{job_files, modification_finding};
use verdict::Remark;

/// Fewest scattered points that a spline surface is fitted to.
const LEAST_FOR_SPLINE: usize = 16;

/// The table that `target.file` names as an entry: a grid if its rows form one, else scattered points, which a remark
/// says.
fn target_file(loaded: &LoadedJob, file: &str) -> Result<(ModificationSpec, Option<Remark>), Diagnostic> {
    let form = table_form(&loaded.beside(file)).map_err(|error| {
        let (kind, file) = ("target".into(), file.into());
        let error = ModificationError::FileUnavailable { kind, file, reason: error.to_string() };
        modification_finding(&error, "target.file")
    })?;
    let TableForm::Scattered { points, places: [w, z] } = form else {
        let grid = GridSpec { file: Some(file.to_owned()), ..GridSpec::default() };
        return Ok((ModificationSpec::Grid(grid), None));
    };
    let (method, name) = if points < LEAST_FOR_SPLINE {
        (PointMethod::Linear, "linear")
    } else {
        (PointMethod::Spline, "spline")
    };
    let remark = Remark {
        code: "target-scattered",
        text: format!(
            "the table {file:?} is no full grid ({points} points at {w} different w_mm and {z} different z_mm): read as \
             scattered points, method \"{name}\""
        ),
        way_out: "give every pair of w_mm and z_mm once, at least 4 of each, if a grid is meant".into(),
    };
    let points = PointsSpec { file: Some(file.to_owned()), method, ..PointsSpec::default() };
    Ok((ModificationSpec::Points(points), Some(remark)))
}

/// The wanted flank with what it was made from.
pub(super) struct Wanted {
    /// The flank.
    pub flank: Modification,
    /// Entries of the target, sums opened, that depend on the profile only and are no polynomials.
    pub reliefs: Vec<ModificationSpec>,
}

/// The entries of a target that stand in the job, or the table that it names.
pub(super) struct TargetEntries {
    wanted: Vec<ModificationSpec>,
    from_file: bool,
}

impl TargetEntries {
    /// Of a job, with a remark on a table that is no full grid.
    ///
    /// # Errors
    /// A finding on `target.file`.
    pub fn of_job(loaded: &LoadedJob) -> Result<(Self, Option<Remark>), Diagnostic> {
        let target = &loaded.job.target;
        let Some(name) = &target.file else {
            let wanted = target.modifications.clone().unwrap_or_default();
            return Ok((Self { wanted, from_file: false }, None));
        };
        let (spec, remark) = target_file(loaded, name)?;
        Ok((Self { wanted: vec![spec], from_file: true }, remark))
    }

    /// The wanted flank, with what measurements have added to it.
    ///
    /// # Errors
    /// A finding on the entry that cannot be built.
    pub fn flank(
        &self,
        loaded: &LoadedJob,
        flank: Flank,
        field: &EvaluationField,
    ) -> Result<Wanted, Diagnostic> {
        let more = loaded.job.compensation.as_ref().map_or(&[][..], |c| &c.modifications[..]);
        let all: Vec<ModificationSpec> = self.wanted.iter().chain(more).cloned().collect();
        let built = Modification::of_entries(&all, flank, field, &job_files(loaded));
        let built = built.map_err(|(index, error)| match index.checked_sub(self.wanted.len()) {
            Some(_) => modification_finding(&error, "compensation.modifications"),
            None if self.from_file => modification_finding(&error, "target.file"),
            None => modification_finding(&error, &format!("target.modifications[{index}]")),
        })?;
        let stated = if self.from_file { &[] } else { &self.wanted[..] };
        let relief = |(spec, term): (&ModificationSpec, Modification)| {
            (term.depends_on_profile_only() && term.polynomial().is_none()).then(|| spec.clone())
        };
        let reliefs = built.described_terms(stated, flank).into_iter().filter_map(relief).collect();
        Ok(Wanted { flank: built, reliefs })
    }
}

/// The wanted flanks of a job on given evaluation fields; `None` for a flank that is not ground.
///
/// # Errors
/// A finding on the entry of the target concerned.
pub fn wanted_flanks(
    loaded: &LoadedJob,
    fields: &Sides<EvaluationField>,
) -> Result<Sides<Option<Modification>>, Diagnostic> {
    let (entries, _) = TargetEntries::of_job(loaded)?;
    Sides::try_from_fn(|flank| {
        let ground = is_ground(&loaded.job, flank);
        ground.then(|| entries.flank(loaded, flank, &fields[flank]).map(|wanted| wanted.flank)).transpose()
    })
}

/// Whether a flank is ground.
pub(super) fn is_ground(job: &Job, flank: Flank) -> bool {
    job.grinding.flanks.includes(flank)
}

/// The tolerances of a job, normal to the flank: its `tolerance_map`, else `tolerance_um` everywhere.
///
/// # Errors
/// A finding on `target.tolerance_map` that names the cell concerned.
pub fn tolerance_of_job(loaded: &LoadedJob) -> Result<ToleranceMap, Diagnostic> {
    const FIELD: &str = "target.tolerance_map";
    let target = &loaded.job.target;
    let (w, z, um) = match &target.tolerance_map {
        None => {
            return ToleranceMap::uniform(target.tolerance_um * 1e-3)
                .map_err(|e| modification_finding(&e, "target.tolerance_um"));
        }
        Some(ToleranceMapSource::Table(table)) => {
            (table.w_mm.clone(), table.z_mm.clone(), table.tolerance_um.clone())
        }
        Some(ToleranceMapSource::File(file)) => {
            let table = read_tolerances(&loaded.beside(file)).map_err(|error| {
                let (kind, file) = ("tolerance map".into(), file.clone());
                let error = ModificationError::FileUnavailable { kind, file, reason: error.to_string() };
                modification_finding(&error, FIELD)
            })?;
            (table.w_mm, table.z_mm, table.f_um)
        }
    };
    let mm = um.into_iter().map(|row| row.into_iter().map(|t| t * 1e-3).collect()).collect();
    ToleranceMap::new(w, z, mm).map_err(|e| modification_finding(&e, FIELD))
}

/// Every modification that stands in a job: of the target, of what is added to it, of tools.
pub(super) fn specs_of_job(job: &Job) -> Vec<&ModificationSpec> {
    let mut specs: Vec<&ModificationSpec> = job.target.modifications.iter().flatten().collect();
    specs.extend(job.compensation.iter().flat_map(|compensation| &compensation.modifications));
    specs.extend(job.worm.modifications.iter().flatten());
    specs
}
