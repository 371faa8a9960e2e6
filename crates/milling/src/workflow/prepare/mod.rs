//! From a checked job of five-axis milling to bodies, tools, rays, machine and outputs: all that planning, referee, programs and page need
//! of it. What stands behind [`prepare_milling`] reads no job. Every finding names the job's key.

mod bevel_offset;
mod bevel_pair;
mod bladed;
mod bodies;
mod body;
mod conical;
mod cutters;
mod cylindrical;
mod gridded;
mod lands;
mod mate;
mod measuring_points;
mod mounting;
mod options;
mod pre_stock;
mod technology;
mod walls;
mod wanted_bevel;
mod workpiece_kind;

pub use bodies::{FlankRange, MillingBodies};
pub use cylindrical::{WantedFlank, wanted_flanks};
pub use mate::{MateKind, MatePair, PairSide};
pub use measuring_points::MeasuringPoint;
pub use mounting::Mounting;
pub use pre_stock::PreStock;
pub use technology::{MillingTechnology, ToolData};
pub use wanted_bevel::{WantedBevel, wanted_bevel};
pub use workpiece_kind::WorkpieceKind;

use crate::job::{LoadedMillingJob, MillingJob, MillingOutput};
use foundation::geometry::Gear;
use job::machine::LoadedMachine;
use job::tables::{JobInfo, Modification};
use measuring_points::measuring_points;
use run::program_check::machine_of_job;
use run::{RunFailure, ToothMeasures, face_names_remark, gear_of_job, parquet_warning};
use verdict::Remark;

/// A job made ready for planning.
#[derive(Clone, Debug)]
pub struct PreparedMilling {
    /// Name, process and description of the job.
    pub info: JobInfo,
    /// What is milled, with what, and how.
    pub bodies: MillingBodies,
    /// A cylindrical gear and how the thickness of its teeth is measured; `None` for other workpieces.
    pub teeth: Option<(Gear, ToothMeasures)>,
    /// Class of ISO 17485 that the drawing of a bevel gear asks for.
    pub bevel_class: Option<i32>,
    /// The gear and its mate, where the job has one.
    pub mate: Option<MatePair>,
    /// Feeds, speed, and the tools as programs call them.
    pub technology: MillingTechnology,
    /// Stock of a part whose spaces are cut already.
    pub pre_stock: Option<PreStock>,
    /// Largest deviation allowed between target and simulated flank, um, normal.
    pub tolerance_um: f64,
    /// Rays of a flank: from root to tip, along the tooth.
    pub rays: [usize; 2],
    /// Whether the rotary motion is compared with that of other orientations.
    pub compare_orientation: bool,
    /// How the workpiece sits on the machine and how its control counts, where the job names a machine.
    pub mounting: Option<Mounting>,
    /// The machine whose programs are wanted, once [`PreparedMilling::on_machine`] has read it.
    pub machine: Option<LoadedMachine>,
    /// Where the flanks of a bevel gear are measured, where the job says so.
    pub measuring_points: Vec<MeasuringPoint>,
    /// What is written beside result and report.
    pub output: MillingOutput,
    /// Remarks on the job, each with a way out.
    pub warnings: Vec<Remark>,
}

/// Bodies, tools and limits of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn prepare_milling(loaded: &LoadedMillingJob) -> Result<PreparedMilling, RunFailure> {
    let job = &loaded.job;
    let (bodies, mate) = bodies::bodies_of_job(loaded)?;
    let mut warnings: Vec<Remark> = parquet_warning(&job.output.tables).into_iter().collect();
    warnings
        .extend(face_names_remark(job.target.modifications.iter().chain(mate_modifications(job)).flatten()));
    warnings.extend(bodies.unknown.iter().cloned());
    Ok(PreparedMilling {
        info: job.job.clone(),
        bodies,
        teeth: teeth_of_job(job)?,
        bevel_class: job.bevel.as_ref().and_then(|bevel| bevel.tolerance_class),
        mate,
        technology: MillingTechnology::of_job(job),
        pre_stock: PreStock::of_job(job),
        tolerance_um: job.target.tolerance_um,
        rays: [job.simulation.rays_profile, job.simulation.rays_length],
        compare_orientation: job.simulation.compare_orientation,
        mounting: job.machine.as_ref().map(Mounting::of_job),
        machine: None,
        measuring_points: measuring_points(loaded)?,
        output: job.output.clone(),
        warnings,
    })
}

fn mate_modifications(job: &MillingJob) -> Option<&Vec<Modification>> {
    job.mate.as_ref().and_then(|mate| mate.modifications.as_ref())
}

fn teeth_of_job(job: &MillingJob) -> Result<Option<(Gear, ToothMeasures)>, RunFailure> {
    let Some(drawn) = &job.gear else { return Ok(None) };
    let gear = gear_of_job(&drawn.drawing).map_err(RunFailure::bad_input)?;
    let measures = ToothMeasures::of(&drawn.drawing, &gear).map_err(RunFailure::bad_input)?;
    Ok(Some((gear, measures)))
}

impl PreparedMilling {
    /// With the machine of the job, where it names one, so that programs are made for it.
    ///
    /// # Errors
    /// [`RunFailure`] for a description that cannot be read.
    pub fn on_machine(self, loaded: &LoadedMillingJob) -> Result<Self, RunFailure> {
        let given = loaded.job.machine.as_ref();
        let machine = given.map(|given| machine_of_job(&loaded.document, &given.file)).transpose()?;
        Ok(Self { machine, ..self })
    }

    /// Largest deviation allowed, mm.
    pub fn tolerance(&self) -> f64 {
        1e-3 * self.tolerance_um
    }
}
