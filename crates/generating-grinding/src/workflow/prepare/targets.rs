//! What the drawing wants: targets of the flanks that are ground and their tolerance. Each modification is built here, once.

use super::conditions::DresserPlaces;
use super::tools::dresser_profile;
use crate::job::{Job, LoadedJob, Method, ToleranceMapSource};
use crate::workflow::generating_finding;
use foundation::geometry::{Flank, Sides};
use foundation::modification::{
    EvaluationField, GridSpec, Modification, ModificationError, ModificationSpec, PointMethod, PointsSpec,
    ToleranceMap,
};
use generating::{Carrier, FlankTarget, GrindingSetup, Tool};
use job::{Diagnostic, Problem, TableForm, read_tolerances, table_form};
use report::charts::format_significant;
use run::{RunFailure, face_names_remark, job_files, modification_finding};
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
struct Wanted {
    /// The flank.
    flank: Modification,
    /// Entries of the target, sums opened, that depend on the profile only and are no polynomials.
    reliefs: Vec<ModificationSpec>,
}

/// The entries of a target that stand in the job, or the table that it names.
struct TargetEntries {
    wanted: Vec<ModificationSpec>,
    from_file: bool,
}

impl TargetEntries {
    /// Of a job, with a remark on a table that is no full grid.
    ///
    /// # Errors
    /// A finding on `target.file`.
    fn of_job(loaded: &LoadedJob) -> Result<(Self, Option<Remark>), Diagnostic> {
        let target = &loaded.job.target;
        if loaded.job.wants_worm() {
            let message = "the gear of a job that wants a worm topography follows from its plan";
            return Err(Diagnostic::new(Problem::InvalidJob, message)
                .field("worm.modifications")
                .allowed("`plan` and `simulate`")
                .way_out("plan the job and take the target from its result"));
        }
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
    fn flank(&self, loaded: &LoadedJob, flank: Flank, field: &EvaluationField) -> Result<Wanted, Diagnostic> {
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

/// The targets of a job, with what is reported on the way.
pub(super) struct JobTargets {
    /// Targets of the flanks that are ground, weighed by the tolerance.
    pub targets: Sides<Option<FlankTarget>>,
    /// Profile forms that are no polynomials and go into the dresser as they stand, as the job describes them.
    pub reliefs: Sides<Vec<ModificationSpec>>,
    /// Remarks on the target, each with a way out.
    pub remarks: Vec<Remark>,
}

/// What carries the parts of the targets.
fn carrier_of(method: Method, setup: &GrindingSetup) -> Carrier {
    // Without a shift even a freely made tool only leaves profile lines.
    match (&setup.tool, method) {
        (Tool::Made | Tool::Given(_), Method::Diagonal) => Carrier::Lines,
        _ if setup.pair.work.is_cylindrical() => Carrier::Dresser,
        _ => Carrier::DresserOnCone,
    }
}

/// The wanted flanks of a job split into what motion, dresser and lines of the tool may carry; `given` is the modification of a dresser
/// that exists and where it is laid, `follows` the gear that follows from a worm that is wanted in its place.
///
/// # Errors
/// [`RunFailure`] with a finding on the entry of the target or on the modification of the dresser.
pub(super) fn targets_of_job(
    loaded: &LoadedJob,
    setup: &GrindingSetup,
    given: Option<(&[ModificationSpec], &DresserPlaces)>,
    tolerance: &ToleranceMap,
    follows: Option<Vec<ModificationSpec>>,
) -> Result<JobTargets, RunFailure> {
    let job = &loaded.job;
    let carrier = carrier_of(job.grinding.method, setup);
    let (entries, remark) = match follows {
        Some(wanted) => (TargetEntries { wanted, from_file: false }, None),
        None => TargetEntries::of_job(loaded).map_err(RunFailure::bad_input)?,
    };
    let mut remarks: Vec<Remark> = remark.into_iter().collect();
    let mut reliefs = Sides::both(Vec::new());
    let targets = Sides::try_from_fn(|flank| {
        if !is_ground(job, flank) {
            return Ok(None);
        }
        let field = &setup.fields[flank];
        let wanted = entries.flank(loaded, flank, field).map_err(RunFailure::bad_input)?;
        for warning in wanted.flank.warnings() {
            remarks.push(Remark {
                code: warning.code(),
                text: format!("{flank} flank: {warning}"),
                way_out: "check the length against the evaluation range".into(),
            });
        }
        let target = match given {
            None => {
                reliefs[flank] = wanted.reliefs;
                FlankTarget::carried_by(wanted.flank, carrier)
            }
            Some((specs, places)) => {
                let made =
                    dresser_profile(loaded, specs, flank, field, ("dresser.modification", "the target"))
                        .map_err(RunFailure::bad_input)?;
                reliefs[flank] = specs.to_vec();
                remarks.extend(uncertain_dresser(&made, flank, setup, tolerance.tightest()));
                places.target(&setup.lines[flank], wanted.flank, made)
            }
        };
        let cos = setup.lines[flank].cos_b2;
        target
            .and_then(|target| target.weighed_by(|w, z| tolerance.value(w, z) / cos))
            .map(Some)
            .map_err(|e| RunFailure::bad_input(generating_finding::generating_finding(&e)))
    })?;
    remarks.extend(face_names_remark(specs_of_job(job)));
    if let Some(compensation) = &job.compensation {
        remarks.push(Remark {
            code: "compensated",
            text: format!(
                "the flank that is planned is the target with the compensation of {} measurements",
                compensation.rounds
            ),
            way_out: "leave [compensation] out to plan the target alone".into(),
        });
    }
    Ok(JobTargets { targets, reliefs, remarks })
}

/// How well a dresser that was measured is known, as the gear shows it: what its flank scatters by with another measurement.
fn uncertain_dresser(
    made: &Modification,
    flank: Flank,
    setup: &GrindingSetup,
    tolerance: f64,
) -> Option<Remark> {
    let cos = setup.lines[flank].cos_b2;
    let [from, to] = setup.fields[flank].roll();
    let at = |k: usize| made.measured_deviation(from + (to - from) * k as f64 / PLACES as f64);
    let uncertainty = COVERAGE * cos * (0..=PLACES).map(at).fold(0.0, f64::max);
    (uncertainty > 0.0).then(|| Remark {
        code: "dresser-as-measured",
        text: format!(
            "the profile of the dresser is a curve through measured points: with another measurement the {flank} flank would differ by up to {} um (95 %), which no verdict counts",
            format_significant(uncertainty * 1e3, 2)
        ),
        way_out: if uncertainty > NOTABLE * tolerance {
            "measure it at more points or with less noise: that is more than a tenth of the tolerance".into()
        } else {
            "none is needed: that is less than a tenth of the tolerance".into()
        },
    })
}

/// Places over the profile where an uncertainty is looked at, its coverage factor (95 %), and the share of the tolerance that is worth a better
/// measurement.
const PLACES: usize = 40;
const COVERAGE: f64 = 1.96;
const NOTABLE: f64 = 0.1;

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
fn specs_of_job(job: &Job) -> Vec<&ModificationSpec> {
    let mut specs: Vec<&ModificationSpec> = job.target.modifications.iter().flatten().collect();
    specs.extend(job.compensation.iter().flat_map(|compensation| &compensation.modifications));
    specs.extend(job.worm.modifications.iter().flatten());
    specs
}
