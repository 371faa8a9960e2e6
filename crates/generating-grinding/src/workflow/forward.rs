//! The flank that a process leaves whose axes are off, many times over: bodies, plan and grid are made once, then every set of deviations
//! costs the exact contact alone. Not verified by the referee, which is a run.

use super::execution::{ExecutedTool, Execution};
use super::prepare::{GivenSettings, Prepared, prepare};
use crate::job::Job;
use crate::workflow::generating_finding;
use dressing::DressedWorm;
use foundation::geometry::Sides;
use foundation::kinematics::GeneratingMotion;
use generating::correction::{Setting, SettingInfluence, SettingsFlank};
use generating::{GeneratingError, PlanningGrid, StrokedFlank};
use job::{AnyJob, Diagnostic, Problem};
use metrology::Topography;
use run::{JobFailure, RunFailure};

/// Orders of the deviations over the feed.
const ORDERS: u8 = 6;
const ARCSEC: f64 = std::f64::consts::PI / 180.0 / 3600.0;
const DEG: f64 = std::f64::consts::PI / 180.0;

/// What may be off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deviation {
    /// Coefficient k of the centre distance over q^k, where q runs from -1 to 1 over the face width, um.
    RadialFeed(u8),
    /// Coefficient k of the workpiece's angle over q^k, arcsec.
    WorkAngle(u8),
    /// Crossing angle of worm and workpiece, degrees.
    CrossingAngle,
    /// An axis of dressing, all along the worm: d_phi_S and d_gamma in degrees, d_d and d_v_yA in um.
    Dressing(usize),
}

const DRESSING: [(&str, f64); 4] = [
    ("dressing_phi_s_deg", DEG),
    ("dressing_gamma_deg", DEG),
    ("dressing_d_um", 1e-3),
    ("dressing_v_ya_um", 1e-3),
];

impl Deviation {
    /// All of them.
    pub fn all() -> Vec<Self> {
        let orders = |of: fn(u8) -> Self| (0..ORDERS).map(of);
        let grinding = orders(Self::RadialFeed).chain(orders(Self::WorkAngle)).chain([Self::CrossingAngle]);
        grinding.chain((0..DRESSING.len()).map(Self::Dressing)).collect()
    }

    /// Stable name with the unit, e.g. `radial_feed_1_um`.
    pub fn name(self) -> String {
        match self {
            Self::RadialFeed(k) => format!("radial_feed_{k}_um"),
            Self::WorkAngle(k) => format!("work_angle_{k}_arcsec"),
            Self::CrossingAngle => "crossing_angle_deg".to_owned(),
            Self::Dressing(axis) => DRESSING[axis].0.to_owned(),
        }
    }
}

/// A planned process, ready to be run with deviations.
pub struct ForwardModel {
    prepared: Prepared,
    execution: Execution,
    grid: PlanningGrid,
    target: Sides<Option<Topography>>,
}

impl ForwardModel {
    /// Plans a job of generating grinding, or takes the settings that stand in it; evaluates on a grid of `points`: along the profile, along
    /// the helix.
    ///
    /// # Errors
    /// [`JobFailure`] as for a plan; another process, bodies from a catalogue, a grid of fewer than 2 points.
    pub fn new(job: &AnyJob, points: [usize; 2]) -> Result<Self, JobFailure> {
        let Some(loaded) = job.of::<Job>() else {
            return Err(RunFailure::other_process(job, "\"generating-grinding\"").into());
        };
        if loaded.job.catalogue.is_some() {
            let finding =
                Diagnostic::new(Problem::NotYetSupported, "a forward model needs bodies, not a catalogue");
            let finding =
                finding.field("catalogue").way_out("plan the job and take the bodies that it has chosen");
            return Err(RunFailure::bad_input(finding).into());
        }
        if let Some(few) = points.iter().find(|&&n| n < 2) {
            let finding = Diagnostic::new(Problem::InvalidNumber, "a grid has at least two points each way");
            let finding = finding.field("points").value(few.to_string()).allowed("2 or more");
            return Err(RunFailure::bad_input(finding.way_out("take 9 x 9")).into());
        }
        let prepared = prepare(loaded)?;
        let execution = match GivenSettings::of_job(loaded, &prepared)? {
            Some(settings) => Execution::of_settings(&prepared, &settings)?,
            None => {
                let plan = prepared.task().plan().map_err(|e| generating_finding::failure(&e))?;
                Execution::of_plan(&prepared, &plan)
            }
        };
        Ok(Self::of_run(prepared, execution, points)?)
    }

    /// Of a run that is planned already, on a grid of `points`.
    ///
    /// # Errors
    /// [`RunFailure`] where the target has no value on the grid.
    pub fn of_run(prepared: Prepared, execution: Execution, points: [usize; 2]) -> Result<Self, RunFailure> {
        let grid = PlanningGrid::new(&prepared.setup, points[0], points[1]);
        let target = Sides::try_from_fn(|flank| -> Result<_, RunFailure> {
            let Some(target) = &prepared.targets[flank] else { return Ok(None) };
            let values = grid.target(flank, target, prepared.setup.lines[flank].cos_b2);
            let values = values.map_err(|e| generating_finding::failure(&e))?;
            Ok(Topography::new(grid.w[flank].clone(), grid.z.clone(), values))
        })?;
        Ok(Self { prepared, execution, grid, target })
    }

    /// The target, normal, mm; `None` for a flank that is not ground.
    pub fn target(&self) -> &Sides<Option<Topography>> {
        &self.target
    }

    /// The flank with deviations, each in the unit of its name: normal, mm, row-major over the length of roll and the axial position.
    /// `None` for a flank that is not ground.
    ///
    /// # Errors
    /// [`RunFailure`]: a value that is not finite, deviations of dressing where nothing is dressed, a contact that is not found.
    pub fn flanks(&self, deviations: &[(Deviation, f64)]) -> Result<Sides<Option<Vec<f64>>>, RunFailure> {
        if let Some((of, value)) = deviations.iter().find(|(_, value)| !value.is_finite()) {
            let finding = Diagnostic::new(Problem::InvalidNumber, "a deviation is not finite");
            let finding = finding.field(of.name()).value(value.to_string()).allowed("finite numbers");
            return Err(RunFailure::bad_input(finding.way_out("leave the sample out")));
        }
        let motion = deviated_motion(&self.prepared, &self.execution, deviations)?;
        let mut dressing = [0.0; 4];
        for (of, value) in deviations {
            if let Deviation::Dressing(axis) = of {
                dressing[*axis] += value * DRESSING[*axis].1;
            }
        }
        Sides::try_from_fn(|flank| {
            let Some(executed) = &self.execution.flanks[flank] else { return Ok(None) };
            let setup = &self.prepared.setup;
            let ground = match (&executed.tool, &self.execution.dresser) {
                (ExecutedTool::Dressed(of), Some(dresser)) => {
                    let corrections = std::array::from_fn(|axis| of.corrections[axis].raised(dressing[axis]));
                    self.grid.ground(setup, flank, &motion, &DressedWorm::new(dresser, flank, &corrections))
                }
                (ExecutedTool::Stroked(strokes), _) => {
                    let moved = strokes.strokes.iter().map(|stroke| {
                        let corrections =
                            std::array::from_fn(|axis| stroke.corrections[axis].raised(dressing[axis]));
                        (stroke.place, corrections)
                    });
                    let layout = setup.strokes.as_deref().ok_or(GeneratingError::NotDressed);
                    let stroked = layout
                        .and_then(|layout| StrokedFlank::of_corrections(layout, flank, moved.collect()))
                        .map_err(|e| generating_finding::failure(&e))?;
                    stroked.ground(setup, flank, &self.grid, &motion)
                }
                (ExecutedTool::Made(made), _) if dressing == [0.0; 4] => {
                    self.grid.ground(setup, flank, &motion, &made.surface(setup, flank))
                }
                _ => {
                    let finding = Diagnostic::new(Problem::InvalidJob, "nothing is dressed in this process");
                    let finding = finding.field("dressing").value("deviations of the dressing axes");
                    return Err(RunFailure::bad_input(finding.allowed("none").way_out("leave them out")));
                }
            };
            let ground = ground.map_err(|e| generating_finding::failure(&e))?;
            Ok(Some(ground.iter().map(|g| g.f_n).collect()))
        })
    }
}

/// The grinding motion of an execution with deviations, each in the unit of its name; those of dressing are none of it.
///
/// # Errors
/// [`RunFailure::BadInput`] for a face width that is none.
pub(super) fn deviated_motion(
    prepared: &Prepared,
    execution: &Execution,
    deviations: &[(Deviation, f64)],
) -> Result<GeneratingMotion, RunFailure> {
    let setup = &prepared.setup;
    // Where the feed has its middle and its unit, whatever law the shift follows.
    let feed = SettingInfluence::new(&setup.lines, execution.ratio, setup.input.blank.face_width)
        .map_err(|e| RunFailure::bad_input(Diagnostic::of(&e).field("gear.face_width")))?;
    let (mut settings, mut crossing) = (Vec::new(), 0.0);
    for (of, value) in deviations {
        match of {
            Deviation::RadialFeed(k) => settings.push((Setting::RadialFeed(*k), value * 1e-3)),
            Deviation::WorkAngle(k) => settings.push((Setting::WorkAngle(*k), value * ARCSEC)),
            Deviation::CrossingAngle => crossing += value * DEG,
            Deviation::Dressing(_) => {}
        }
    }
    let flank = SettingsFlank::new(&setup.pair, &feed, &execution.motion);
    Ok(flank.motion(&settings, crossing))
}
