//! What a process brings: its job, its tasks, and what can be shown of a job before it runs.

use super::derived::DerivedGeometry;
use super::document::DocumentFormat;
use super::evidence::Evidence;
use super::finding::{JobFailure, Remark, RunFailure};
use super::outcome::TaskOutcome;
use super::preview::Preview;
use super::program_check::ProgramCheck;
use super::task::Task;
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use job::{AnyJob, Diagnostic, JobFormat, Loaded, ProcessJob};

/// A process. Everything that treats all processes alike asks this trait; a line in the registry of `flankwright` makes it known.
pub trait Process: Send + Sync + 'static {
    /// Its job.
    type Job: ProcessJob;

    /// What people call it, e.g. `Generating grinding`.
    fn title(&self) -> &'static str;

    /// The tasks that it carries out.
    fn tasks(&self) -> &'static [Task];

    /// Commands of the program that take its jobs: by default those named after its tasks.
    fn commands(&self) -> Vec<&'static str> {
        self.tasks().iter().map(|task| task.name()).collect()
    }

    /// What a command that does not take jobs of this process advises.
    fn instead(&self, _command: &str) -> &'static str {
        "take a job of one of these processes, or another command for this one"
    }

    /// The documents that its tasks write.
    fn documents(&self) -> Vec<DocumentFormat>;

    /// Carries a task out, one of [`Process::tasks`].
    ///
    /// # Errors
    /// A job or a file that it names is at fault, or the bodies cannot make the target. A target that is missed is no error.
    fn carry_out(
        &self,
        task: Task,
        loaded: &Loaded<Self::Job>,
        progress: &dyn Progress,
    ) -> Result<Box<dyn TaskOutcome>, JobFailure>;

    /// What follows from a job before anything is planned, and remarks on it.
    ///
    /// # Errors
    /// Bodies or targets that cannot exist, a file that the job names.
    fn derived(&self, loaded: &Loaded<Self::Job>) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure>;

    /// The description of the machine that a job names, if it names one.
    fn machine_file<'a>(&self, _: &'a Self::Job) -> Option<&'a str> {
        None
    }

    /// The tolerance of the flank, um; `None` for a process that has none.
    fn tolerance_um(&self, _: &Self::Job) -> Option<f64> {
        None
    }

    /// Whether it has a preview.
    fn has_preview(&self) -> bool {
        false
    }

    /// The plan without its referee; `None` for a process that has no preview.
    ///
    /// # Errors
    /// As [`Process::carry_out`].
    fn preview(&self, _: &Loaded<Self::Job>) -> Option<Result<Preview, JobFailure>> {
        None
    }

    /// The bodies of a job on a machine, on which programs are followed; `None` for a process that has no programs.
    ///
    /// # Errors
    /// Those of the job's own run.
    fn program_check<'a>(
        &self,
        _: &'a Loaded<Self::Job>,
        _: &'a LoadedMachine,
        _: &dyn Progress,
    ) -> Option<Result<Box<dyn ProgramCheck + 'a>, RunFailure>> {
        None
    }

    /// What was tried before a job was refused, for its report.
    fn evidence(&self, _: &Loaded<Self::Job>, _: &Diagnostic) -> Option<Box<dyn Evidence>> {
        None
    }
}

/// A process whose type of job is not known to the caller. A job of another process has nothing to ask here.
pub trait AnyProcess: Send + Sync {
    /// Its name in job files.
    fn name(&self) -> &'static str;

    /// The format of its jobs.
    fn format(&self) -> JobFormat;

    /// As [`Process::title`].
    fn title(&self) -> &'static str;

    /// As [`Process::tasks`].
    fn tasks(&self) -> &'static [Task];

    /// As [`Process::commands`].
    fn commands(&self) -> Vec<&'static str>;

    /// As [`Process::instead`].
    fn instead(&self, command: &str) -> &'static str;

    /// As [`Process::documents`].
    fn documents(&self) -> Vec<DocumentFormat>;

    /// As [`Process::carry_out`]; `None` for a job of another process.
    fn carry_out(
        &self,
        task: Task,
        job: &AnyJob,
        progress: &dyn Progress,
    ) -> Option<Result<Box<dyn TaskOutcome>, JobFailure>>;

    /// As [`Process::derived`]; `None` for a job of another process.
    fn derived(&self, job: &AnyJob) -> Option<Result<(DerivedGeometry, Vec<Remark>), JobFailure>>;

    /// As [`Process::machine_file`].
    fn machine_file(&self, job: &AnyJob) -> Option<String>;

    /// As [`Process::tolerance_um`].
    fn tolerance_um(&self, job: &AnyJob) -> Option<f64>;

    /// As [`Process::has_preview`].
    fn has_preview(&self) -> bool;

    /// As [`Process::preview`].
    fn preview(&self, job: &AnyJob) -> Option<Result<Preview, JobFailure>>;

    /// As [`Process::program_check`].
    fn program_check<'a>(
        &self,
        job: &'a AnyJob,
        machine: &'a LoadedMachine,
        progress: &dyn Progress,
    ) -> Option<Result<Box<dyn ProgramCheck + 'a>, RunFailure>>;

    /// As [`Process::evidence`].
    fn evidence(&self, job: &AnyJob, finding: &Diagnostic) -> Option<Box<dyn Evidence>>;
}

impl<P: Process> AnyProcess for P {
    fn name(&self) -> &'static str {
        P::Job::NAME
    }

    fn format(&self) -> JobFormat {
        JobFormat::of::<P::Job>()
    }

    fn title(&self) -> &'static str {
        Process::title(self)
    }

    fn tasks(&self) -> &'static [Task] {
        Process::tasks(self)
    }

    fn commands(&self) -> Vec<&'static str> {
        Process::commands(self)
    }

    fn instead(&self, command: &str) -> &'static str {
        Process::instead(self, command)
    }

    fn documents(&self) -> Vec<DocumentFormat> {
        Process::documents(self)
    }

    fn carry_out(
        &self,
        task: Task,
        job: &AnyJob,
        progress: &dyn Progress,
    ) -> Option<Result<Box<dyn TaskOutcome>, JobFailure>> {
        job.of().map(|loaded| Process::carry_out(self, task, loaded, progress))
    }

    fn derived(&self, job: &AnyJob) -> Option<Result<(DerivedGeometry, Vec<Remark>), JobFailure>> {
        job.of().map(|loaded| Process::derived(self, loaded))
    }

    fn machine_file(&self, job: &AnyJob) -> Option<String> {
        job.of::<P::Job>().and_then(|loaded| Process::machine_file(self, &loaded.job)).map(str::to_owned)
    }

    fn tolerance_um(&self, job: &AnyJob) -> Option<f64> {
        job.of::<P::Job>().and_then(|loaded| Process::tolerance_um(self, &loaded.job))
    }

    fn has_preview(&self) -> bool {
        Process::has_preview(self)
    }

    fn preview(&self, job: &AnyJob) -> Option<Result<Preview, JobFailure>> {
        job.of().and_then(|loaded| Process::preview(self, loaded))
    }

    fn program_check<'a>(
        &self,
        job: &'a AnyJob,
        machine: &'a LoadedMachine,
        progress: &dyn Progress,
    ) -> Option<Result<Box<dyn ProgramCheck + 'a>, RunFailure>> {
        job.of().and_then(|loaded| Process::program_check(self, loaded, machine, progress))
    }

    fn evidence(&self, job: &AnyJob, finding: &Diagnostic) -> Option<Box<dyn Evidence>> {
        job.of().and_then(|loaded| Process::evidence(self, loaded, finding))
    }
}
