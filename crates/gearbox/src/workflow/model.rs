//! The electronic gearbox of a job, asked again and again: its budget at any speed, its pulses for any reference pulses. No servo, no
//! choice of a set-up.

use super::figures;
use super::finding::of_feed;
use super::prepare::{Chain, Driven};
use super::result::CouplingResult;
use crate::job::GearboxJob;
use control::{ErrorBudget, InterpolationRun};
use electronic_gearbox::pulse::TimedPulse;
use job::AnyJob;
use run::control::on_field;
use run::{JobFailure, RunFailure};

/// Workpiece, interpolator, coupling and reference pulses of a job.
pub struct GearboxModel {
    chain: Chain,
    driven: Driven,
}

impl GearboxModel {
    /// The gearbox of a job.
    ///
    /// # Errors
    /// [`JobFailure`] as for a run; a job of another process.
    pub fn new(job: &AnyJob) -> Result<Self, JobFailure> {
        let Some(loaded) = job.of::<GearboxJob>() else {
            return Err(RunFailure::other_process(job, "\"electronic-gearbox\"").into());
        };
        let chain = Chain::of_job(&loaded.job)?;
        let driven = Driven::of_job(loaded, &chain.interpolation)?;
        Ok(Self { chain, driven })
    }

    /// What the lead asks for and what the coupling makes of it.
    pub fn coupling(&self) -> CouplingResult {
        figures::coupling(&self.chain)
    }

    /// Clock, Hz.
    pub fn clock(&self) -> f64 {
        self.chain.interpolation.clock
    }

    /// Reference pulses of the job as (tick, sign), and the tick up to which it runs.
    pub fn references(&self) -> (&[(u64, i64)], u64) {
        (&self.driven.references, self.driven.last_tick)
    }

    /// The budget of the errors at a speed (mm/s) and an acceleration (mm/s^2).
    ///
    /// # Errors
    /// [`RunFailure`]: a speed or acceleration beyond its range.
    pub fn budget(&self, speed: f64, acceleration: f64) -> Result<ErrorBudget, RunFailure> {
        figures::budget(&self.chain, &self.chain.interpolation, [speed, acceleration], None)
            .map_err(|error| of_feed(&error))
    }

    /// Runs the job: counters and errors over time.
    ///
    /// # Errors
    /// [`RunFailure`]: a ratio beyond the accumulator.
    pub fn run(&self) -> Result<InterpolationRun, RunFailure> {
        let driven = &self.driven;
        let Chain { interpolation, rotation, .. } = &self.chain;
        interpolation
            .run(&driven.references, driven.last_tick, driven.motion.as_ref(), Some(rotation), &mut |_, _| {})
            .map_err(|error| on_field(&error, "workpiece.pulses_per_revolution"))
    }

    /// All pulses that reference pulses (tick, sign) cause up to a tick, each with the parts of rotation that it turned.
    ///
    /// # Errors
    /// [`RunFailure`]: reference pulses that cannot be, a ratio beyond the accumulator.
    pub fn pulses(
        &self,
        references: &[(u64, i64)],
        last_tick: u64,
    ) -> Result<Vec<(TimedPulse, i64)>, RunFailure> {
        let Chain { interpolation, rotation, .. } = &self.chain;
        let mut pulses = Vec::new();
        interpolation
            .run(references, last_tick, None, Some(rotation), &mut |pulse, turned| {
                pulses.push((pulse, turned))
            })
            .map_err(|error| on_field(&error, "references"))?;
        Ok(pulses)
    }
}
