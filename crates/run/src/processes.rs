//! The registry: all processes there are, asked for by the job at hand.

use super::derived::DerivedGeometry;
use super::finding::{JobFailure, Remark, RunFailure};
use super::outcome::TaskOutcome;
use super::preview::Preview;
use super::process::AnyProcess;
use super::program_check::machine_of_job;
use super::task::Task;
use foundation::numerics::Progress;
use job::{AnyJob, Diagnostic, JobFormats, Problem};

/// Processes and the formats of their jobs.
pub struct Processes {
    all: Vec<Box<dyn AnyProcess>>,
    formats: JobFormats,
}

impl Processes {
    /// Of these processes; the first is taken for a job that names none.
    pub fn new(all: Vec<Box<dyn AnyProcess>>) -> Self {
        let formats = JobFormats::new(all.iter().map(|process| process.format()).collect());
        Self { all, formats }
    }

    /// The processes in their order.
    pub fn all(&self) -> impl Iterator<Item = &dyn AnyProcess> {
        self.all.iter().map(AsRef::as_ref)
    }

    /// The formats of their jobs.
    pub fn formats(&self) -> &JobFormats {
        &self.formats
    }

    /// A process by its name.
    pub fn named(&self, name: &str) -> Option<&dyn AnyProcess> {
        self.all().find(|process| process.name() == name)
    }

    /// The process of a job.
    ///
    /// # Errors
    /// A job of a process that is not registered here.
    pub fn of(&self, job: &AnyJob) -> Result<&dyn AnyProcess, RunFailure> {
        let name = job.info().process.name();
        self.named(name).ok_or_else(|| {
            let finding = Diagnostic::new(
                Problem::ProcessNotAvailable,
                format!("there is no process \"{name}\" in this program"),
            );
            let names: Vec<String> = self.all().map(|process| format!("\"{}\"", process.name())).collect();
            RunFailure::bad_input(
                finding
                    .field("job.process")
                    .value(format!("\"{name}\""))
                    .allowed(names.join(", "))
                    .way_out("choose one of the available processes"),
            )
        })
    }

    /// Carries a task out on a job.
    ///
    /// # Errors
    /// [`JobFailure`]: a job or a file that it names is at fault, the process has no such task, or the bodies cannot make the target. A
    /// target that is missed is no error.
    pub fn carry_out(
        &self,
        task: Task,
        job: &AnyJob,
        progress: &dyn Progress,
    ) -> Result<Box<dyn TaskOutcome>, JobFailure> {
        let process = self.of(job)?;
        if process.tasks().contains(&task)
            && let Some(done) = process.carry_out(task, job, progress)
        {
            return done;
        }
        let takes = |process: &&dyn AnyProcess| process.tasks().contains(&task);
        let finding = not_taken(task.name(), process.name(), self.list(takes));
        let finding = finding.way_out("plan the job instead; its report compares what can be compared");
        Err(RunFailure::bad_input(finding).into())
    }

    /// What a command answers to a job of a process whose jobs it does not take; on the key `job.process`.
    pub fn refused(&self, command: &str, job: &AnyJob) -> Diagnostic {
        let name = job.info().process.name();
        let others = self.list(|process| process.name() != name && process.commands().contains(&command));
        let instead =
            self.named(name).map_or("take a job of another process", |process| process.instead(command));
        not_taken(command, name, others).way_out(instead)
    }

    fn list(&self, wanted: impl Fn(&&dyn AnyProcess) -> bool) -> String {
        let names = self.all().filter(wanted).map(|process| format!("\"{}\"", process.name()));
        names.collect::<Vec<_>>().join(", ")
    }

    /// What follows from a job before anything is planned, and remarks on it. A machine description that is missing or wrong is found
    /// here too.
    ///
    /// # Errors
    /// [`JobFailure`]: bodies or targets that cannot exist, a file that the job names.
    pub fn derived_geometry(&self, job: &AnyJob) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure> {
        let process = self.of(job)?;
        if let Some(file) = process.machine_file(job) {
            machine_of_job(job.document(), &file)?;
        }
        process.derived(job).unwrap_or_else(|| Ok((DerivedGeometry::default(), Vec::new())))
    }

    /// The plan of a job without its referee.
    ///
    /// # Errors
    /// [`JobFailure`] as for a plan; a process without a preview.
    pub fn preview(&self, job: &AnyJob) -> Result<Preview, JobFailure> {
        self.of(job)?.preview(job).unwrap_or_else(|| {
            let name = job.info().process.name();
            let finding = Diagnostic::new(Problem::ProcessNotAvailable, format!("\"{name}\" has no preview"))
                .field("job.process")
                .value(format!("\"{name}\""))
                .allowed(self.list(|process| process.has_preview()))
                .way_out("plan the job: it is done at once");
            Err(RunFailure::bad_input(finding).into())
        })
    }
}

fn not_taken(command: &str, name: &str, others: String) -> Diagnostic {
    let message = format!("`{command}` does not take a job of the process \"{name}\"");
    Diagnostic::new(Problem::ProcessNotAvailable, message)
        .field("job.process")
        .value(format!("\"{name}\""))
        .allowed(others)
}
