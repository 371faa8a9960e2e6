//! What programs are made from: a machine, its controls, the motions of a run. Knows no text.

use super::indexing::Indexing;
use super::lines::LineWork;
use super::technology::Technology;
use foundation::kinematics::{DressingMotion, GeneratingMotion};
use job::machine::LoadedMachine;
use job::tables::Program as DialectName;
use machine::GearCoupling;
use nalgebra::Vector3;

/// One dressing stroke of a run.
#[derive(Clone, Debug)]
pub struct DressingWork {
    /// Its name: capital letters, digits, blanks.
    pub name: String,
    /// The motion that finishes the worm.
    pub motion: DressingMotion,
    /// Worm positions v_zS of the working part, mm.
    pub interval: [f64; 2],
    /// Places where the dresser touches at v_zS = 0: point and normal in worm coordinates.
    pub contacts: Vec<(Vector3<f64>, Vector3<f64>)>,
    /// Largest sin(alpha_n): stock per distance where both flanks are dressed at once.
    pub per_distance: f64,
}

/// One grinding stroke of a run.
#[derive(Clone, Debug)]
pub struct GrindingWork {
    /// Its name.
    pub name: String,
    /// The motion that finishes the flank.
    pub motion: GeneratingMotion,
    /// k_0F of its flanks.
    pub phase: f64,
    /// Feeds z_V2 of the working part, mm.
    pub feeds: [f64; 2],
    /// Largest r_b2 cos(beta_b2) of its flanks, mm/rad.
    pub per_turn: f64,
    /// Largest sin(alpha_n) of its flanks.
    pub per_distance: f64,
}

/// A run's programs to be made.
#[derive(Clone, Debug)]
pub struct ProgramTask<'a> {
    /// Name of the job.
    pub job: &'a str,
    /// The machine.
    pub machine: &'a LoadedMachine,
    /// Dialects in the order of the job.
    pub dialects: &'a [DialectName],
    /// Speeds, clamping, passes.
    pub technology: Technology,
    /// Dressing strokes in their order.
    pub dressing: Vec<DressingWork>,
    /// Flanks of the worm that a disc writes line by line.
    pub lines: Vec<LineWork<'a>>,
    /// Grinding strokes in their order.
    pub grinding: Vec<GrindingWork>,
    /// Threads of the worm and index strokes of the workpiece: each stroke is driven for every one of them.
    pub indexing: Indexing,
    /// Couplings of the bodies.
    pub coupling: GearCoupling,
    /// z_V1 of every finishing area of the worm less that of the first, mm: each has a grinding program of its own.
    pub areas: Vec<f64>,
}
