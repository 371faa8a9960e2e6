//! From a checked job to bodies, targets, rules and limits: all that planning, simulation, programs and page need of it. What stands
//! behind [`prepare`] reads no job; the job goes on only as the text that is written back with its settings. Every finding names
//! the job's key.

mod bodies;
mod conditions;
mod cycle;
mod dressing;
mod judged;
mod planning;
mod removal;
mod settings;
mod shift;
mod stock;
mod strokes;
mod targets;
mod tools;
mod wanted_worm;

pub use bodies::{check_designed_worm, designed_worm, setup_of_job, worm_choice_of_job};
pub use cycle::Cycle;
pub use dressing::{DressingTask, PointDresser};
pub use judged::TracePlaces;
use judged::tolerance_over_flank;
pub use planning::{PlanningRules, axis_limits};
pub use removal::{
    CycleLimits, DressingWanted, RemovalTask, ShopLimit, SpeedLimits, StrokesWanted, WantedStroke,
};
pub use settings::GivenSettings;
pub use stock::bodies_on_stock;
pub use targets::{tolerance_of_job, wanted_flanks};
pub use tools::dresser_profile;

use super::equal_ratio_offers::free_lines;
use crate::job::{
    DiagonalRatio, DiagonalRule, Grinding, LoadedJob, MachineDeviations, Method, Tool as JobTool,
};
use crate::workflow::measured_worm::MeasuredWormTask;
use crate::workflow::programs::technology::Technology;
use conditions::{DresserPlaces, places_of_job, rows_of_job};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::modification::{ModificationSpec, ToleranceMap};
use generating::areas::AreaPlan;
use generating::{FlankTarget, GrindingSetup, Tool};
use job::machine::LoadedMachine;
use job::tables::{Control, JobInfo, Output};
use job::{Diagnostic, Problem};
use metrology::Topography;
use run::program_check::machine_of_job;
use run::{RunFailure, ToothMeasures};
use shift::shift_of_job;
use std::f64::consts::TAU;
use strokes::strokes_of_job;
use targets::{JobTargets, is_ground, targets_of_job};
use tools::tool_modifications;
use verdict::Remark;
use wanted_worm::gear_of_wanted_worm;

/// A job made ready for planning.
#[derive(Clone)]
pub struct Prepared {
    /// Name, process and description of the job.
    pub info: JobInfo,
    /// The bodies.
    pub setup: GrindingSetup,
    /// Targets of the flanks that are ground.
    pub targets: Sides<Option<FlankTarget>>,
    /// The entries of the target as the drawing states them.
    pub drawn: Vec<ModificationSpec>,
    /// Profile forms that are no polynomials and go into the dresser as they stand, as the job describes them.
    pub reliefs: Sides<Vec<ModificationSpec>>,
    /// Tolerance over the flank, normal.
    pub tolerance: ToleranceMap,
    /// Where it holds and what is allowed elsewhere, in words; `None` for the whole flank.
    pub judged_on: Option<String>,
    /// Where the traces stand that a drawing states values for.
    pub traces: Sides<TracePlaces>,
    /// What planning is asked for.
    pub rules: PlanningRules,
    /// The law of the shift, where the job asks for one in place of a ratio.
    pub law: Option<MotionLaw>,
    /// The areas that the law was made for.
    pub areas: Option<AreaPlan>,
    /// The grinding cycle.
    pub cycle: Cycle,
    /// How the thickness of the gear's teeth is measured.
    pub measures: ToothMeasures,
    /// How the worm is dressed.
    pub dressing: DressingTask,
    /// Speeds, clamping and passes.
    pub technology: Technology,
    /// Stock and what the shop allows; `None` for a job without stock.
    pub removal: Option<RemovalTask>,
    /// Whether the job names a machine.
    pub names_machine: bool,
    /// The machine whose programs are wanted, once [`Prepared::on_machine`] has read it.
    pub machine: Option<LoadedMachine>,
    /// Axes that are off, where the job asks what that leaves.
    pub deviations: Option<MachineDeviations>,
    /// A worm as it was measured.
    pub measured_worm: Option<MeasuredWormTask>,
    /// The control that couples the axes.
    pub control: Option<Control>,
    /// What is written beside result and report.
    pub output: Output,
    /// Remarks on the job, each with a way out.
    pub warnings: Vec<Remark>,
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
    if job.wants_worm() {
        setup.wanted_worm = Some(Box::new(tool_modifications(loaded, &setup)?));
    }
    let (tolerance, judged_on) = tolerance_over_flank(loaded, &setup).map_err(RunFailure::bad_input)?;
    let strokes = strokes_of_job(loaded, &setup)?;
    // In strokes the corrections make the whole profile, as a dresser made for the target would.
    let given = match &strokes {
        None => job.dresser.as_ref().and_then(|dresser| dresser.modification.given()),
        Some(_) => None,
    };
    setup.strokes = strokes.map(Box::new);
    let axial_pitch = TAU * setup.pair.worm.screw_parameter(Flank::Left).abs() / f64::from(job.worm.threads);
    let rows = rows_of_job(&job.dressing, axial_pitch);
    let rules = PlanningRules::of_job(job, rows, given.is_none())?;
    let places = match given {
        Some(_) => places_of_job(&setup, rows, &rules, job)?,
        None => DresserPlaces::designed(),
    };
    let which: Vec<Flank> = Flank::BOTH.into_iter().filter(|&flank| is_ground(job, flank)).collect();
    let follows = match &setup.wanted_worm {
        Some(wanted) => Some(gear_of_wanted_worm(&setup, wanted, rules.known_ratio(), &which)?),
        None => None,
    };
    let given = given.map(|given| (given, &places));
    let JobTargets { targets, reliefs, remarks: mut warnings } =
        targets_of_job(loaded, &setup, given, &tolerance, follows)?;
    warnings.extend(remarks_on_bodies(&setup));
    warnings.extend(no_choice_of_ratio(&job.grinding));
    if job.point_dresser().is_some()
        && job.dressing.line_direction_deg.is_none()
        && setup.wanted_worm.is_none()
    {
        let remark;
        (setup, remark) = with_free_lines(setup, &targets);
        warnings.extend(remark);
    }
    let shift = shift_of_job(job, &setup, &targets, &tolerance, &which)?;
    let cycle = Cycle::of_job(job)?;
    let dressing = DressingTask::of_job(job);
    let measures = ToothMeasures::of(&job.gear, &setup.input.gear).map_err(RunFailure::bad_input)?;
    let traces = Sides::from_fn(|flank| TracePlaces::of_job(loaded, &setup.fields[flank]));
    let technology =
        Technology::of_grinding(&job.machine.clone().unwrap_or_default(), &setup, cycle.feed_per_revolution);
    let removal = RemovalTask::of_job(loaded, &setup, (&cycle, &technology))?;
    Ok(Prepared {
        info: job.job.clone(),
        technology: match &setup.input.dresser {
            Some(first) => {
                technology.with_dresser(dressing.largest_radius(first.tip_diameter), setup.worm_module())
            }
            None => technology,
        },
        removal,
        setup,
        targets,
        drawn: job.target.modifications.clone().unwrap_or_default(),
        reliefs,
        tolerance,
        judged_on,
        traces,
        rules,
        law: shift.law,
        areas: shift.areas,
        cycle,
        measures,
        dressing,
        names_machine: job.machine.is_some(),
        machine: None,
        deviations: job.deviations.clone(),
        measured_worm: MeasuredWormTask::of_job(loaded)?,
        control: job.control.clone(),
        output: job.output.clone(),
        warnings,
    })
}

impl Prepared {
    /// Largest |deviation| over the tolerance at its place.
    pub fn tolerance_share(&self, deviation: &Topography) -> f64 {
        let points = deviation.w.iter().flat_map(|&w| deviation.z.iter().map(move |&z| (w, z)));
        points.zip(&deviation.f).map(|((w, z), f)| f.abs() / self.tolerance.value(w, z)).fold(0.0, f64::max)
    }

    /// The flanks that are ground.
    pub fn ground_flanks(&self) -> Vec<Flank> {
        Flank::BOTH.into_iter().filter(|&flank| self.targets[flank].is_some()).collect()
    }

    /// With the machine of the job, where it names one, so that programs are made for it.
    ///
    /// # Errors
    /// [`RunFailure`] for a description that cannot be read.
    pub fn on_machine(self, loaded: &LoadedJob) -> Result<Self, RunFailure> {
        let machine = loaded.job.machine.as_ref();
        let machine = machine.map(|machine| machine_of_job(&loaded.document, &machine.file)).transpose()?;
        Ok(Self { machine, ..self })
    }
}

/// What a choice of the ratio would go by, where the job leaves none.
fn no_choice_of_ratio(grinding: &Grinding) -> Option<Remark> {
    let auto = matches!(grinding.diagonal_ratio, None | Some(DiagonalRatio::Rule(DiagonalRule::Auto)));
    let chosen = grinding.method == Method::Diagonal && auto;
    (grinding.prefer.is_some() && !chosen).then(|| Remark {
        code: "no-ratio-to-choose",
        text: "grinding.prefer decides nothing: the job leaves no diagonal ratio to choose".into(),
        way_out: "leave `prefer` out, or let the ratio be chosen (diagonal_ratio = \"auto\")".into(),
    })
}

/// What the bodies do beside the evaluated flank.
fn remarks_on_bodies(setup: &GrindingSetup) -> Vec<Remark> {
    let mut warnings = Vec::new();
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
    warnings
}

/// Lays the lines of a disc in point contact so that both flanks ask for the same ratio, where the target's directed parts ask
/// for different ones, and says so.
fn with_free_lines(
    setup: GrindingSetup,
    targets: &Sides<Option<FlankTarget>>,
) -> (GrindingSetup, Option<Remark>) {
    let Some(shared) = free_lines(&setup, targets) else { return (setup, None) };
    let degrees = shared.direction.map(|_, t| t.atan().to_degrees());
    let remark = Remark {
        code: "dressing-lines-laid",
        text: format!(
            "directed parts of the target ask for diagonal ratio {:.6} on the left flank and {:.6} on the right one; the disc \
             writes lines of {:.4} deg left and {:.4} deg right, with which both ask for {:.6}",
            shared.demanded.left, shared.demanded.right, degrees.left, degrees.right, shared.ratio
        ),
        way_out: "give dressing.line_direction_deg if other lines are wanted".into(),
    };
    (setup.with_tool_direction(shared.direction), Some(remark))
}
