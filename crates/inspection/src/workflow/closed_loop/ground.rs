//! The flank that a job's plan leaves, by rays, on the machine as it should be or with its deviations. Knows no measurement.

use foundation::geometry::Sides;
use foundation::numerics::Progress;
use generating::correction::{Setting, SettingsFlank};
use generating_grinding::job::{Compensation, DiagonalRatio, LoadedJob, SimulatedMeasurement};
use generating_grinding::workflow::execution::Execution;
use generating_grinding::workflow::generating_finding;
use generating_grinding::workflow::influence::influence;
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
        let mut execution = self.execution.clone();
        execution.motion = self.motion(of)?;
        let dressing = of.dressing.values();
        if dressing != [0.0; 4] && !execution.shift_dressing(dressing) {
            let finding = Diagnostic::new(Problem::InvalidJob, "this tool is not dressed in one stroke")
                .field("inspection.simulated.dressing")
                .value("deviations of the dressing axes")
                .allowed("none")
                .way_out("leave the table out");
            return Err(RunFailure::bad_input(finding));
        }
        by_rays(&self.prepared, &execution, progress)
    }

    /// The grinding motion with its deviations.
    fn motion(
        &self,
        of: &SimulatedMeasurement,
    ) -> Result<foundation::kinematics::GeneratingMotion, RunFailure> {
        let setup = &self.prepared.setup;
        let influence = influence(&self.prepared, &self.execution)?;
        let flank = SettingsFlank::new(&setup.pair, &influence, &self.execution.motion);
        let orders = |values: &[f64], unit: f64, setting: fn(u8) -> Setting| {
            let each = values.iter().zip(0u8..);
            each.map(|(value, k)| (setting(k), value * unit)).collect::<Vec<(Setting, f64)>>()
        };
        let arcsec = (1.0_f64 / 3600.0).to_radians();
        let mut settings = orders(&of.radial_feed_um, 1e-3, Setting::RadialFeed);
        settings.extend(orders(&of.work_angle_arcsec, arcsec, Setting::WorkAngle));
        Ok(flank.motion(&settings, of.crossing_angle_deg.to_radians()))
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
