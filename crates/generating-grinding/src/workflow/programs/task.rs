//! What programs are made from: a machine, its controls, the motions of a run. Knows no text.

use super::indexing::Indexing;
use super::lines::LineWork;
use super::technology::Technology;
use super::work::{DressingWork, GrindingWork};
use job::machine::LoadedMachine;
use job::tables::Program as DialectName;
use machine::GearCoupling;

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
