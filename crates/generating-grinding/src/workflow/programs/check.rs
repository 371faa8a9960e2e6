//! `program check` of grinding and dressing: the strokes of a program, the flank that it leaves, and what comes near on its way.

use super::follow::Followed;
use super::on_grinding::OnGrinding;
use super::surroundings::Surroundings;
use super::technology::Technology;
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use machine::{Machine, Station};
use motion::Tracked;
use nc::Dialect;
use run::RunFailure;
use run::program_check::{CheckedProgram, ProgramCheck, checked_program};
use std::io::BufRead;

/// The bodies of a worm, a dresser and a gear, on which a program is followed.
pub trait FollowedBodies {
    /// What the axes of a machine make of the bodies.
    ///
    /// # Errors
    /// No stroke on these bodies.
    fn follow(&self, machine: &Machine, tracked: &Tracked) -> Result<Followed, RunFailure>;

    /// Speeds, clamping, passes.
    fn technology(&self) -> &Technology;
}

/// Checks any number of programs on one machine and on the bodies of one job.
pub struct BodiesCheck<'a, B> {
    /// The machine.
    pub machine: &'a LoadedMachine,
    /// The bodies.
    pub bodies: B,
}

impl FollowedBodies for OnGrinding {
    fn follow(&self, machine: &Machine, tracked: &Tracked) -> Result<Followed, RunFailure> {
        OnGrinding::follow(self, machine, tracked)
    }

    fn technology(&self) -> &Technology {
        OnGrinding::technology(self)
    }
}

impl<B: FollowedBodies> ProgramCheck for BodiesCheck<'_, B> {
    fn check(
        &self,
        text: &mut dyn BufRead,
        netlist: Option<&str>,
        dialect: Dialect,
        _: &dyn Progress,
    ) -> Result<CheckedProgram, RunFailure> {
        let machine = self.machine;
        let (mut checked, tracked) = checked_program(text, netlist, dialect, machine)?;
        let followed = self.bodies.follow(&machine.machine, &tracked)?;
        checked.kind = Some(followed.kind);
        checked.strokes = followed.strokes;
        checked.flanks = Some(followed.flanks);
        checked.threads = followed.threads;
        checked.remarks.extend(followed.faults);
        let station = if followed.kind == "grinding" { Station::Work } else { Station::Dresser };
        let around = Surroundings::new(machine, self.bodies.technology()).follow(&tracked, station);
        checked.bodies = around.least;
        checked.remarks.extend(around.faults.into_iter().map(|(_, _, fault)| fault));
        Ok(checked)
    }
}
