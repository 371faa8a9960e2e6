//! The flank that a job's plan leaves, by rays, on the machine as it should be or with its deviations. Knows no measurement.

use foundation::geometry::Sides;
use foundation::numerics::Progress;
use generating_grinding::job::{Compensation, DiagonalRatio, LoadedJob, SimulatedMeasurement};
use generating_grinding::workflow::deviated::deviated;
use generating_grinding::workflow::execution::Execution;
use generating_grinding::workflow::generating_finding;
use generating_grinding::workflow::prepare::{Prepared, prepare};
use generating_grinding::workflow::referee::{self, Cutting};
use job::{Diagnostic, Problem};
use metrology::Topography;
use run::RunFailure;

/// A planned job.
pub(super) struct Ground {
    /// The job, to be written back with a compensation.
    pub job: LoadedJob,
    /// Bodies and targets.
    pub prepared: Prepared,
    /// Motions.
    pub execution: Execution,
    /// What the rays leave, normal, mm; `None` for a flank that is not ground.
    pub simulated: Sides<Option<Topography>>,
}

/// Plans a job and lets the referee grind it.
pub(super) fn ground(job: LoadedJob, progress: &dyn Progress) -> Result<Ground, RunFailure> {
    let prepared = prepare(&job)?;
    let plan = prepared.task().plan().map_err(|e| generating_finding::failure(&e))?;
    let execution = Execution::of_plan(&prepared, &plan);
    let simulated = by_rays(&prepared, &execution, progress)?;
    Ok(Ground { job, prepared, execution, simulated })
}

impl Ground {
    /// The compensation with which it was planned.
    pub fn compensation(&self) -> Option<&Compensation> {
        self.job.job.compensation.as_ref()
    }

    /// The same job with another compensation, planned and ground.
    ///
    /// # Errors
    /// Those of planning and referee.
    pub fn compensated(
        &self,
        compensation: Compensation,
        progress: &dyn Progress,
    ) -> Result<Self, RunFailure> {
        let mut job = self.job.clone();
        job.job.compensation = Some(compensation);
        job.job.settings = None;
        // What the settings do was found for this ratio.
        if !self.prepared.rules.radial {
            job.job.grinding.diagonal_ratio = Some(DiagonalRatio::Number(self.execution.ratio));
            job.job.grinding.prefer = None;
        }
        ground(job, progress)
    }

    /// What settings do, and what inspections evaluate, is known for cylinders.
    ///
    /// # Errors
    /// [`RunFailure::BadInput`] for cones.
    pub fn check_cylinders(&self) -> Result<(), RunFailure> {
        let pair = &self.prepared.setup.pair;
        if pair.work.is_cylindrical() && pair.worm.is_cylindrical() {
            return Ok(());
        }
        let message = "measurements are judged against jobs of cylindrical gears and worms";
        let finding = Diagnostic::new(Problem::InvalidJob, message)
            .field("gear.cone_angle_deg")
            .value(self.job.job.gear.cone_angle_deg)
            .allowed("0")
            .way_out("inspect the measurement without `--job`");
        Err(RunFailure::bad_input(finding))
    }

    /// What the same settings leave on a machine with deviations, normal, mm.
    pub fn with_deviations(
        &self,
        of: &SimulatedMeasurement,
        progress: &dyn Progress,
    ) -> Result<Sides<Option<Topography>>, RunFailure> {
        let execution = deviated(&self.prepared, &self.execution, &of.deviations(), "inspection.simulated")?;
        by_rays(&self.prepared, &execution, progress)
    }
}

fn by_rays(
    prepared: &Prepared,
    execution: &Execution,
    progress: &dyn Progress,
) -> Result<Sides<Option<Topography>>, RunFailure> {
    let cutting = Cutting { feed_per_revolution: None, strokes: prepared.cycle.strokes.as_ref() };
    let verdicts = referee::run(&prepared.setup, execution, cutting, progress)
        .map_err(|e| RunFailure::of_removal(&e, "grinding"))?;
    Ok(verdicts.map(|_, verdict| verdict.as_ref().map(|verdict| verdict.simulated.clone())))
}
