//! From a checked job of tangential dressing to bodies, targets, passes and rules of the fit: all that plan, simulation, programs and
//! page need of it. What stands behind [`prepare_tangential`] reads no job; the job goes on only as the text that is written back with
//! its settings. Every finding names the job's key.

mod bodies;
mod fitting;
mod names;
mod settings;
mod targets;
mod technology;

pub use fitting::{Choice, FitRules};
pub use settings::given_settings;
pub use targets::{Drawn, WantedFlank};

use crate::TangentialModel;
use crate::job::{LoadedTangentialJob, Passes};
use bodies::Bodies;
use foundation::geometry::{Blank, Flank, Sides};
use generating_grinding::workflow::programs::Technology;
use job::machine::LoadedMachine;
use job::tables::{Control, JobInfo, Output};
use run::program_check::machine_of_job;
use run::{RunFailure, ToothMeasures, face_names_remark};
use targets::wanted_flank;
use technology::technology;
use verdict::Remark;

/// A job made ready for planning.
pub struct TangentialPrepared {
    /// Name, process and description of the job.
    pub info: JobInfo,
    /// The bodies.
    pub model: TangentialModel,
    /// Diameters and face width of the gear.
    pub blank: Blank,
    /// How the thickness of the gear's teeth is measured.
    pub measures: ToothMeasures,
    /// Tip radius of the worm, mm.
    pub worm_tip_radius: f64,
    /// Width of the worm that the job gives, mm.
    pub worm_width: Option<f64>,
    /// Tip diameter of the dresser, mm.
    pub dresser_tip_diameter: f64,
    /// Whether the dresser exists, so that its profile is no variable.
    pub dresser_exists: bool,
    /// The entries of the target as the drawing states them.
    pub drawn: Drawn,
    /// What is wanted of the flanks that are ground.
    pub wanted: Sides<Option<WantedFlank>>,
    /// Largest deviation allowed, normal, um.
    pub tolerance_um: f64,
    /// Flanks that are ground together, pass by pass.
    pub passes: Vec<Vec<Flank>>,
    /// Whether the job wants one pass for all flanks.
    pub one_pass: bool,
    /// What is asked of the fit.
    pub rules: FitRules,
    /// Speeds, clamping and passes.
    pub technology: Technology,
    /// Whether the job gives a feed per revolution of the gear.
    pub gives_feed: bool,
    /// Whether the job names a machine.
    pub names_machine: bool,
    /// The machine whose programs are wanted, once [`TangentialPrepared::on_machine`] has read it.
    pub machine: Option<LoadedMachine>,
    /// The control that couples the axes.
    pub control: Option<Control>,
    /// What is written beside result and report.
    pub output: Output,
    /// Remarks on the job, each with a way out.
    pub warnings: Vec<Remark>,
}

/// Bodies, targets, passes and rules of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn prepare_tangential(loaded: &LoadedTangentialJob) -> Result<TangentialPrepared, RunFailure> {
    let job = &loaded.job;
    let Bodies { model, blank, worm_tip_radius } = Bodies::of_job(loaded)?;
    let drawn = Drawn::of(&job.target);
    let ground: Vec<Flank> = Flank::BOTH.into_iter().filter(|&f| job.grinding.flanks.includes(f)).collect();
    let wanted = Sides::try_from_fn(|flank| {
        ground.contains(&flank).then(|| wanted_flank(loaded, &drawn, &model, flank)).transpose()
    })
    .map_err(RunFailure::bad_input)?;
    let one_pass = job.dressing.passes == Passes::One;
    let passes = if one_pass { vec![ground] } else { ground.into_iter().map(|flank| vec![flank]).collect() };
    let machine = job.machine.clone().unwrap_or_default();
    let feed = job.grinding.feed_per_revolution;
    let worm = (model.pair.worm.data(), worm_tip_radius, job.worm.width);
    Ok(TangentialPrepared {
        info: job.job.clone(),
        technology: technology(&machine, worm, &blank, feed)
            .with_dresser(0.5 * job.dresser.tip_diameter, model.pair.worm.data().normal_module),
        measures: ToothMeasures::of(&job.gear, &model.input().gear).map_err(RunFailure::bad_input)?,
        model,
        blank,
        worm_tip_radius,
        worm_width: job.worm.width,
        dresser_tip_diameter: job.dresser.tip_diameter,
        dresser_exists: job.dresser.exists(),
        drawn,
        wanted,
        tolerance_um: job.target.tolerance_um,
        passes,
        one_pass,
        rules: FitRules::of_job(job)?,
        gives_feed: feed.is_some(),
        names_machine: job.machine.is_some(),
        machine: None,
        control: job.control.clone(),
        output: job.output.clone(),
        warnings: face_names_remark(job.target.modifications.iter().flatten()).into_iter().collect(),
    })
}

impl TangentialPrepared {
    /// With the machine of the job, where it names one, so that programs are made for it.
    ///
    /// # Errors
    /// [`RunFailure`] for a description that cannot be read.
    pub fn on_machine(self, loaded: &LoadedTangentialJob) -> Result<Self, RunFailure> {
        let machine = loaded.job.machine.as_ref();
        let machine = machine.map(|machine| machine_of_job(&loaded.document, &machine.file)).transpose()?;
        Ok(Self { machine, ..self })
    }

    /// Material left that is wanted, normal, mm; 0 on a flank that is not ground.
    pub fn wanted(&self, flank: Flank, w: f64, z: f64) -> f64 {
        self.wanted[flank].as_ref().map_or(0.0, |wanted| wanted.value(&self.model, flank, w, z))
    }

    /// Largest deviation allowed, normal, mm.
    pub fn tolerance(&self) -> f64 {
        self.tolerance_um * 1e-3
    }
}
