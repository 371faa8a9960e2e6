//! What programs are made from: a machine, its controls, the motions of a run. Knows no text.

use super::indexing::Indexing;
use super::lines::LineWork;
use super::technology::Technology;
use crate::exchange::job::Program as DialectName;
use crate::exchange::machine::{LoadedMachine, read_machine};
use crate::exchange::{Diagnostic, Loaded, Problem};
use crate::kinematics::{DressingMotion, GeneratingMotion};
use crate::machine::GearCoupling;
use crate::workflow::finding::RunFailure;
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
    pub(in crate::workflow) lines: Vec<LineWork<'a>>,
    /// Grinding strokes in their order.
    pub grinding: Vec<GrindingWork>,
    /// Threads of the worm and index strokes of the workpiece: each stroke is driven for every one of them.
    pub indexing: Indexing,
    /// Couplings of the bodies.
    pub coupling: GearCoupling,
    /// z_V1 of every finishing area of the worm less that of the first, mm: each has a grinding program of its own.
    pub areas: Vec<f64>,
}

/// The machine that a job names.
///
/// # Errors
/// A finding on `machine.file` with what is wrong in that file.
pub(in crate::workflow) fn machine_of_job<J>(
    loaded: &Loaded<J>,
    file: &str,
) -> Result<LoadedMachine, RunFailure> {
    let path = loaded.beside(file);
    read_machine(&path).map_err(|error| {
        let first = error.diagnostics.first();
        let place = first.and_then(|d| d.span.as_ref()).map(|span| error.source.line_column(span.start));
        let at = place.map_or(String::new(), |(line, column)| format!(", line {line}, column {column}"));
        let message = first.map_or_else(|| error.to_string(), |d| d.message.to_string());
        let code = first.map_or(Problem::InvalidMachine.code(), |d| d.code);
        let mut finding =
            Diagnostic::with_code(code, format!("the machine description {file}{at}: {message}"))
                .field("machine.file")
                .value(format!("{file:?}"));
        if let Some(allowed) = first.and_then(|d| d.allowed.clone()) {
            finding = finding.allowed(allowed);
        }
        let way_out = first.and_then(|d| d.way_out.clone());
        RunFailure::bad_input(
            finding.way_out(way_out.unwrap_or_else(|| "correct the machine description".into())),
        )
    })
}
