//! From a checked job to bodies, targets and the task of planning. Every finding names the job's key.

use super::equal_ratio_offers::free_lines;
use super::shift::shift_of_job;
use super::strokes::strokes_of_job;
use crate::job::{
    Condition, DegreeOfFreedom, DesignedFor, DiagonalRatio, Dressing, DressingFlanks, Gauge, GaugeRule, Job,
    LoadedJob, Method, ProfileCrowningBy, RootAlong, Tool as JobTool,
};
use crate::workflow::generating_finding;
use contact::ContactError;
use foundation::geometry::{Flank, Gear, Sides, WormChoice, worm_for_gear};
use foundation::kinematics::MotionLaw;
use foundation::modification::{
    EvaluationField, GridSpec, Modification, ModificationError, ModificationSpec, PointMethod, PointsSpec,
    ToleranceMap,
};
use generating::areas::AreaPlan;
use generating::least_squares::FitNorm;
use generating::{
    Carrier, DresserChoice, DressingLimits, DressingRows, FlankRows, FlankTarget, FreeCoefficients,
    GearRootChoice, GrindingSetup, PlanGauge, PlanTask, ProfilePlace, SetupInput, Tool,
};
use job::tables::{Fit, Modification as JobModification, ToleranceMapSource};
use job::{Diagnostic, Problem, TableForm, read_tolerances, table_form};
use run::{
    RunFailure, blank_of_job, face_names_remark, gear_of_job, geometry_finding, job_files,
    modification_finding, specs_of_flank,
};
use verdict::Remark;

/// A job made ready for planning.
pub struct Prepared {
    /// The bodies.
    pub setup: GrindingSetup,
    /// Targets of the flanks that are ground.
    pub targets: Sides<Option<FlankTarget>>,
    /// Profile forms that are no polynomials and go into the dresser as they stand, as the job describes them.
    pub reliefs: Sides<Vec<ModificationSpec>>,
    /// Places allowed for the profile crowning.
    pub places: Vec<ProfilePlace>,
    /// Whether the dresser is made for this job.
    pub free_dresser: bool,
    /// Tolerance over the flank, normal.
    pub tolerance: ToleranceMap,
    /// The law of the shift, where the job asks for one in place of a ratio.
    pub law: Option<MotionLaw>,
    /// The areas that the law was made for.
    pub areas: Option<AreaPlan>,
    /// Remarks on the job, each with a way out.
    pub warnings: Vec<Remark>,
}

/// What the job chooses of its worm.
pub fn worm_choice_of_job(job: &Job) -> WormChoice {
    WormChoice {
        threads: i32::try_from(job.worm.threads).unwrap_or(i32::MAX),
        hand: job.worm_hand().sign(),
        pitch_diameter: job.worm.pitch_diameter,
        tip_diameter: job.worm.tip_diameter,
        pressure_angle: Some(job.worm_pressure_angle_deg().sides().left.to_radians()),
        profile_shift: job.worm.profile_shift,
        cone_angle: job.worm.cone_angle_deg.to_radians(),
    }
}

/// The worm that the job's dresser was designed for: of the hand of the one that it dresses.
pub fn designed_worm(job: &Job, there: &DesignedFor) -> WormChoice {
    let angles = there.normal_pressure_angle_deg.unwrap_or(job.gear.normal_pressure_angle_deg);
    WormChoice {
        threads: i32::try_from(there.threads).unwrap_or(i32::MAX),
        hand: job.worm_hand().sign(),
        pitch_diameter: there.pitch_diameter,
        tip_diameter: there.tip_diameter,
        pressure_angle: Some(angles.sides().left.to_radians()),
        profile_shift: 0.0,
        cone_angle: 0.0,
    }
}

/// Refuses a worm for which no dresser was designed: an impossible one, pressure angles and a module with which it does not mesh.
fn check_designed_worm(job: &Job, gear: &Gear, there: &DesignedFor) -> Result<(), Diagnostic> {
    const FIELD: &str = "dresser.designed_for";
    let own = gear.own_rack();
    let rack = match there.normal_pressure_angle_deg {
        None => own,
        Some(angles) => {
            let angles = angles.sides();
            let rack = gear.rack_with_pressure_angle(Flank::Left, angles.left.to_radians()).map_err(|e| {
                geometry_finding(&e, FIELD).field(format!("{FIELD}.normal_pressure_angle_deg"))
            })?;
            let right = rack.pressure_angle.right.to_degrees();
            if (right - angles.right).abs() > 1e-6 {
                let text = format!(
                    "a worm that meshes on both flanks has {right:.6} deg on the right flank when its left flank has {:.6} deg",
                    angles.left
                );
                return Err(Diagnostic::with_code("not-mating", text)
                    .field(format!("{FIELD}.normal_pressure_angle_deg"))
                    .value(angles.right)
                    .allowed(format!("{right:.6}"))
                    .way_out("give the matching angle, or leave the pressure angle out"));
            }
            rack
        }
    };
    worm_for_gear(gear, &designed_worm(job, there)).map_err(|e| geometry_finding(&e, FIELD).field(FIELD))?;
    let module = rack.normal_module;
    match there.normal_module {
        Some(stated) if (stated - module).abs() > MATING * module => {
            let text = format!("a worm of normal module {stated} mm does not mesh with the gear");
            Err(Diagnostic::with_code("not-mating", text)
                .field(format!("{FIELD}.normal_module"))
                .value(stated)
                .allowed(format!("{module} mm"))
                .way_out(
                    "take a dresser for this module, or leave the module out if it follows from the angle",
                ))
        }
        _ => Ok(()),
    }
}

/// Modules that mesh may differ by this share (`docs/mathematics/dressing.md#limits-of-a-correction`).
const MATING: f64 = 1e-6;

/// Bodies of the job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn setup_of_job(job: &Job) -> Result<GrindingSetup, RunFailure> {
    let gear = gear_of_job(&job.gear).map_err(RunFailure::bad_input)?;
    let blank = blank_of_job(&job.gear);
    blank.check(&gear).map_err(|e| RunFailure::bad_input(geometry_finding(&e, "gear")))?;
    if let Some(there) = job.dresser.as_ref().and_then(|d| d.designed_for.as_ref()) {
        check_designed_worm(job, &gear, there).map_err(RunFailure::bad_input)?;
    }
    let range = job.gear.evaluation_range();
    let angle = job.worm_pressure_angle_deg().sides();
    let point = job.point_dresser();
    let direction = if point.is_some() { job.dressing.line_direction_deg } else { job.worm.direction_deg };
    let setup = GrindingSetup::new(SetupInput {
        gear,
        blank,
        evaluation: [range.start_diameter, range.end_diameter, range.z_start, range.z_end],
        worm: worm_choice_of_job(job),
        worm_width: job.worm.width,
        // What a disc in point contact writes is any flank: for the plan the tool is made, not profiled.
        dresser: job.dresser.as_ref().filter(|_| point.is_none()).map(|d| DresserChoice {
            tip_diameter: d.tip_diameter,
            pitch_diameter: d.pitch_diameter,
            designed_for: d.designed_for.map(|there| designed_worm(job, &there)),
        }),
        tool_direction: direction.map(|given| given.sides().map(|_, rho| rho.to_radians().tan())),
        root_clearance: job.dresser.as_ref().and_then(|d| d.root_clearance),
        gear_root: job.dressing.gear_root.map(|root| GearRootChoice {
            corner_radius: root.corner_radius,
            constant: root.along == RootAlong::Constant,
            least_fillet_radius: root.least_fillet_radius,
        }),
    })
    .map_err(|e| generating_finding::failure(&e))?;
    if let Some(given) = &direction {
        let key = if point.is_some() { "dressing.line_direction_deg" } else { "worm.direction_deg" };
        check_lines(&setup, &given.sides(), key).map_err(RunFailure::bad_input)?;
    }
    let made = setup.pair.worm.data().pressure_angle;
    for (flank, angle) in angle.iter() {
        let wanted = angle.to_radians();
        if (made[flank] - wanted).abs() > 1e-9 {
            let text = format!(
                "a worm that meshes on both flanks has {:.6} deg on the {flank} flank when its left flank has {:.6} deg",
                made[flank].to_degrees(),
                made.left.to_degrees()
            );
            let d = Diagnostic::with_code("not-mating", text)
                .field("worm.normal_pressure_angle_deg")
                .way_out("give the matching angle, or leave the worm's pressure angle out");
            return Err(RunFailure::bad_input(d));
        }
    }
    Ok(setup)
}

/// Lines of the tool are at least this far from the contact path: along it every direction on the workpiece asks for the ratio 0.
const FROM_CONTACT_PATH_DEG: f64 = 0.1;

/// Refuses lines of the tool along the contact path, for which there is no diagonal ratio.
fn check_lines(setup: &GrindingSetup, given: &Sides<f64>, key: &str) -> Result<(), Diagnostic> {
    for (flank, &degrees) in given.iter() {
        let [path, _] = setup.pair.flanks[flank].contact_path();
        let path = path.rho.to_degrees();
        if (degrees - path).abs() >= FROM_CONTACT_PATH_DEG {
            continue;
        }
        let error = ContactError::DirectionIsContactPath { direction_deg: degrees };
        let text = format!("on the {flank} flank {error}, and no diagonal ratio");
        return Err(Diagnostic::with_code(error.code(), text)
            .field(key)
            .value(degrees)
            .allowed(format!("at least {FROM_CONTACT_PATH_DEG} deg from {path:.4} deg, the contact path"))
            .way_out("turn the lines away from the contact path, or leave the key out"));
    }
    Ok(())
}

/// What a given tool carries on its flanks, over (w_1, z_1).
fn tool_modifications(loaded: &LoadedJob, setup: &GrindingSetup) -> Result<Sides<Modification>, RunFailure> {
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

fn target_of_flank(
    loaded: &LoadedJob,
    file: Option<&ModificationSpec>,
    flank: Flank,
    field: &EvaluationField,
) -> Result<Modification, Diagnostic> {
    let job = &loaded.job;
    let more = job.compensation.as_ref().map_or(&[][..], |compensation| &compensation.modifications[..]);
    let wanted = match (file, &job.target.modifications) {
        (Some(spec), _) => std::slice::from_ref(spec),
        (None, Some(specs)) => &specs[..],
        (None, None) => &[],
    };
    let target = match file {
        Some(_) => Modification::for_flank(wanted, flank, field, &job_files(loaded))
            .map_err(|e| modification_finding(&e, "target.file"))?,
        None => specs_of_flank(loaded, wanted, flank, field)?,
    };
    if more.is_empty() {
        return Ok(target);
    }
    let all: Vec<ModificationSpec> = wanted.iter().chain(more).cloned().collect();
    Modification::for_flank(&all, flank, field, &job_files(loaded))
        .map_err(|e| modification_finding(&e, "compensation.modifications"))
}

/// The wanted flanks of a job on given evaluation fields; `None` for a flank that is not ground.
///
/// # Errors
/// A finding on the entry of the target concerned.
pub fn wanted_flanks(
    loaded: &LoadedJob,
    fields: &Sides<EvaluationField>,
) -> Result<Sides<Option<Modification>>, Diagnostic> {
    let file = match &loaded.job.target.file {
        None => None,
        Some(name) => Some(target_file(loaded, name)?.0),
    };
    Sides::try_from_fn(|flank| {
        is_ground(&loaded.job, flank)
            .then(|| target_of_flank(loaded, file.as_ref(), flank, &fields[flank]))
            .transpose()
    })
}

/// Whether a flank is ground.
fn is_ground(job: &Job, flank: Flank) -> bool {
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

/// Overlaps of worm tip and gear root below this are rounding of the drawing, mm.
const WORTH_SAYING: f64 = 1e-3;

/// Bodies, targets and rules of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn prepare(loaded: &LoadedJob) -> Result<Prepared, RunFailure> {
    let job = &loaded.job;
    if job.catalogue.is_some() {
        let finding =
            Diagnostic::new(Problem::InvalidJob, "this takes one worm and one dresser, not a catalogue")
                .field("catalogue")
                .value("a table")
                .allowed("tables [worm] and [dresser]")
                .way_out("`flankwright plan` chooses the best pair and writes it into settings.json");
        return Err(RunFailure::bad_input(finding));
    }
    let mut setup = setup_of_job(job)?;
    if job.worm.tool == JobTool::Given {
        setup.tool = Tool::Given(Box::new(tool_modifications(loaded, &setup)?));
    }
    let tolerance = tolerance_of_job(loaded).map_err(RunFailure::bad_input)?;
    let mut warnings = Vec::new();
    let strokes = strokes_of_job(loaded, &setup)?;
    // In strokes the corrections make the whole profile, as a dresser made for the target would.
    let given = match &strokes {
        None => job.dresser.as_ref().and_then(|dresser| dresser.modification.given()),
        Some(_) => None,
    };
    setup.strokes = strokes.map(Box::new);
    let cylindrical = setup.pair.work.is_cylindrical();
    // Without a shift even a freely made tool only leaves profile lines.
    let carrier = match (&setup.tool, job.grinding.method) {
        (Tool::Made | Tool::Given(_), Method::Diagonal) => Carrier::Lines,
        _ if cylindrical => Carrier::Dresser,
        _ => Carrier::DresserOnCone,
    };
    let ground = |flank: Flank| is_ground(job, flank);
    let file = match &job.target.file {
        None => None,
        Some(name) => {
            let (spec, remark) = target_file(loaded, name).map_err(RunFailure::bad_input)?;
            warnings.extend(remark);
            Some(spec)
        }
    };
    let targets = Sides::try_from_fn(|flank| {
        if !ground(flank) {
            return Ok(None);
        }
        let field = &setup.fields[flank];
        let wanted = target_of_flank(loaded, file.as_ref(), flank, field).map_err(RunFailure::bad_input)?;
        for warning in wanted.warnings() {
            warnings.push(Remark {
                code: warning.code(),
                text: format!("{flank} flank: {warning}"),
                way_out: "check the length against the evaluation range".into(),
            });
        }
        let target = match given {
            None => FlankTarget::carried_by(wanted, carrier),
            Some(specs) => {
                let made = dresser_profile(loaded, specs, flank, field, "dresser.modification")
                    .map_err(RunFailure::bad_input)?;
                FlankTarget::with_given_dresser(wanted, made)
            }
        };
        let cos = setup.lines[flank].cos_b2;
        target
            .and_then(|target| target.weighed_by(|w, z| tolerance.value(w, z) / cos))
            .map(Some)
            .map_err(|e| RunFailure::bad_input(generating_finding::generating_finding(&e)))
    })?;
    warnings.extend(face_names_remark(specs_of_job(job)));
    if let Some(compensation) = &job.compensation {
        warnings.push(Remark {
            code: "compensated",
            text: format!(
                "the flank that is planned is the target with the compensation of {} measurements",
                compensation.rounds
            ),
            way_out: "leave [compensation] out to plan the target alone".into(),
        });
    }
    let free_dresser = given.is_none();
    let places = match job.dressing.profile_crowning_by {
        ProfileCrowningBy::Dresser => vec![ProfilePlace::Dresser],
        ProfileCrowningBy::Correction => vec![ProfilePlace::Correction],
        ProfileCrowningBy::Diagonal => vec![ProfilePlace::Diagonal],
        ProfileCrowningBy::Auto if free_dresser => vec![ProfilePlace::Dresser],
        // One correction for both flanks makes value and slope of each, no crowning.
        ProfileCrowningBy::Auto if job.dressing.flanks == DressingFlanks::Two => vec![ProfilePlace::Diagonal],
        ProfileCrowningBy::Auto => vec![ProfilePlace::Diagonal, ProfilePlace::Correction],
    };
    if places == [ProfilePlace::Dresser] && !free_dresser {
        let d = Diagnostic::new(
            Problem::InvalidJob,
            "the profile crowning cannot go into a dresser whose profile is given",
        )
        .field("dressing.profile_crowning_by")
        .allowed("\"auto\", \"diagonal\" or \"correction\"")
        .way_out("let the dresser be made for the target (dresser.modification = \"target\")");
        return Err(RunFailure::bad_input(d));
    }
    if setup.root_cut > WORTH_SAYING {
        warnings.push(Remark {
            code: "worm-cuts-root",
            text: format!(
                "the worm's tip reaches {:.3} mm beyond the root circle of the gear",
                setup.root_cut
            ),
            way_out: "reduce worm.tip_diameter or check gear.root_diameter".into(),
        });
    }
    if setup.undercut > WORTH_SAYING {
        warnings.push(Remark {
            code: "undercut-by-worm-tip",
            text: format!(
                "the worm's tip reaches {:.3} mm of roll beyond the point that grinds the base circle: below the start of the evaluated profile it undercuts the gear; what it takes of the evaluated flank is judged",
                setup.undercut
            ),
            way_out: "reduce worm.tip_diameter".into(),
        });
    }
    if setup.tip_short > WORTH_SAYING {
        warnings.push(Remark {
            code: "worm-tip-short",
            text: format!(
                "the worm's tip ends {:.3} mm before the radius that grinds the root form circle",
                setup.tip_short
            ),
            way_out: "raise worm.tip_diameter or gear.form_diameter".into(),
        });
    }
    if let Ok(found) = setup.input.blank.check(&setup.input.gear) {
        for warning in found {
            warnings.push(Remark {
                code: "tooth-pointed",
                text: warning.to_string(),
                way_out: "reduce gear.tip_diameter or gear.profile_shift".into(),
            });
        }
    }
    let reliefs = Sides::from_fn(|flank| match given {
        Some(made) => made.to_vec(),
        None => relief_specs(loaded, flank, &setup.fields[flank]),
    });
    let which: Vec<Flank> = Flank::BOTH.into_iter().filter(|&flank| ground(flank)).collect();
    let mut prepared = Prepared {
        setup,
        targets,
        reliefs,
        places,
        free_dresser,
        tolerance,
        law: None,
        areas: None,
        warnings,
    };
    if job.point_dresser().is_some() && job.dressing.line_direction_deg.is_none() {
        prepared = with_free_lines(prepared);
    }
    let shift = shift_of_job(job, &prepared.setup, &prepared.targets, &prepared.tolerance, &which)?;
    Ok(Prepared { law: shift.law, areas: shift.areas, ..prepared })
}

/// Lays the lines of a disc in point contact so that both flanks ask for the same ratio, where the target's directed parts ask
/// for different ones, and says so.
fn with_free_lines(mut prepared: Prepared) -> Prepared {
    let Some(shared) = free_lines(&prepared) else { return prepared };
    let degrees = shared.direction.map(|_, t| t.atan().to_degrees());
    prepared.warnings.push(Remark {
        code: "dressing-lines-laid",
        text: format!(
            "directed parts of the target ask for diagonal ratio {:.6} on the left flank and {:.6} on the right one; the disc \
             writes lines of {:.4} deg left and {:.4} deg right, with which both ask for {:.6}",
            shared.demanded.left, shared.demanded.right, degrees.left, degrees.right, shared.ratio
        ),
        way_out: "give dressing.line_direction_deg if other lines are wanted".into(),
    });
    prepared.setup = prepared.setup.with_tool_direction(shared.direction);
    prepared
}

/// Entries of the target, sums opened, that depend on the profile only and are no polynomials.
fn relief_specs(loaded: &LoadedJob, flank: Flank, field: &EvaluationField) -> Vec<ModificationSpec> {
    fn flat<'a>(spec: &'a ModificationSpec, into: &mut Vec<&'a ModificationSpec>) {
        match spec {
            ModificationSpec::Sum(sum) => sum.children.iter().for_each(|child| flat(child, into)),
            other => into.push(other),
        }
    }
    let mut entries = Vec::new();
    for spec in loaded.job.target.modifications.iter().flatten().filter(|spec| spec.flank().includes(flank)) {
        flat(spec, &mut entries);
    }
    let is_relief = |spec: &&ModificationSpec| {
        Modification::build_with_files(spec, field, &job_files(loaded))
            .is_ok_and(|built| built.depends_on_profile_only() && built.polynomial().is_none())
    };
    entries.into_iter().filter(is_relief).cloned().collect()
}

/// The profile forms of `[settings]` of one flank, built.
///
/// # Errors
/// [`RunFailure`] for a modification that is impossible or no function of the profile alone.
pub fn settings_reliefs(
    loaded: &LoadedJob,
    specs: &[ModificationSpec],
    flank: Flank,
    field: &EvaluationField,
) -> Result<Vec<Modification>, RunFailure> {
    let entry = format!("settings.{flank}.reliefs");
    let built = Modification::for_flank(specs, flank, field, &job_files(loaded))
        .map_err(|e| RunFailure::bad_input(modification_finding(&e, &entry)))?;
    if !built.terms().iter().all(Modification::depends_on_profile_only) {
        let finding =
            Diagnostic::new(Problem::InvalidJob, "a dresser can only carry modifications of the profile")
                .field(entry)
                .allowed("profile crowning, profile slope, tip or root relief")
                .way_out("leave helix modifications to the motions");
        return Err(RunFailure::bad_input(finding));
    }
    Ok(built.terms())
}

/// What a dresser that exists leaves on the gear; `place` is its key in the job.
///
/// # Errors
/// A finding on that key for what is impossible or no function of the profile alone.
pub fn dresser_profile(
    loaded: &LoadedJob,
    specs: &[JobModification],
    flank: Flank,
    field: &EvaluationField,
    place: &str,
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
        .way_out("leave helix modifications to the target"));
    }
    Ok(made)
}

/// The rows of the dressing motion as the job names them; that they are four has been checked.
fn dressing_rows(dressing: &Dressing) -> DressingRows {
    if dressing.flanks == DressingFlanks::Two {
        return DressingRows::BothFlanks;
    }
    let has = |condition: Condition| dressing.conditions.contains(&condition);
    let fixed = dressing.fixed();
    DressingRows::Alone(FlankRows {
        points: if has(Condition::FourPoint) { 4 } else { 3 },
        map: has(Condition::RadiusMap),
        head: has(Condition::Head),
        fixed: DegreeOfFreedom::ALL.map(|axis| fixed.contains(&axis)),
    })
}

impl Prepared {
    /// The task of planning this job.
    pub fn task(&self, job: &Job) -> PlanTask<'_> {
        let radial = job.grinding.method == Method::Radial;
        let ratio = match &job.grinding.diagonal_ratio {
            _ if radial => Some(0.0),
            Some(DiagonalRatio::Number(k)) => Some(*k),
            _ => None,
        };
        PlanTask {
            setup: &self.setup,
            targets: self.targets.clone(),
            tolerance: self.tolerance.tightest(),
            limits: DressingLimits::default(),
            ratio,
            law: self.law.clone(),
            norm: match job.target.fit {
                Fit::LeastSquares => FitNorm::LeastSquares,
                Fit::Largest => FitNorm::Largest,
            },
            gauge: match job.grinding.gauge {
                Gauge::Rule(GaugeRule::Centred) => PlanGauge::Centred,
                Gauge::Rule(GaugeRule::EqualSwivel) => PlanGauge::EqualSwivel,
                Gauge::Given(g) => {
                    PlanGauge::Given(FreeCoefficients { k_10: g.k_10, k_20: Some(g.k_20), k_k0: g.k_k0 })
                }
            },
            places: self.places.clone(),
            dressing: dressing_rows(&job.dressing),
            free_dresser: self.free_dresser,
            precompensation: job.grinding.precompensation.unwrap_or(!radial),
            grid: (job.grid.profile_points, job.grid.helix_points),
        }
    }
}
