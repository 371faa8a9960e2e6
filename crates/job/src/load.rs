//! From a file to a checked job: text, tree, process, shape, types, contradictions. The only way to a job from outside, so
//! that a holder of one need not check it again.

use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;

use super::diagnostic::{Diagnostic, JobError, Problem};
use super::document::Document;
use super::gearbox_job::{self, GearboxJob};
use super::job::{Job, JobInfo, Process};
use super::milling_job::{self, MillingJob};
use super::node::Kind;
use super::skiving_job::{self, SkivingJob};
use super::source::Source;
use super::tangential_job::{self, TangentialJob};
use super::{checks, schema, shape};

/// A checked job and the document it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Loaded<J> {
    /// The job.
    pub job: J,
    /// Text and places, for messages about this job from other layers.
    pub document: Document,
}

/// A checked job of generating grinding.
pub type LoadedJob = Loaded<Job>;

/// A checked job of tangential dressing.
pub type LoadedTangentialJob = Loaded<TangentialJob>;

/// A checked job of the electronic gearbox.
pub type LoadedGearboxJob = Loaded<GearboxJob>;

/// A checked job of five-axis milling.
pub type LoadedMillingJob = Loaded<MillingJob>;

/// A checked job of measuring a skiving tool.
pub type LoadedSkivingJob = Loaded<SkivingJob>;

impl<J> Loaded<J> {
    /// The path of a file that the job names ([`Source::beside`]).
    pub fn beside(&self, file: &str) -> PathBuf {
        self.document.source().beside(file)
    }

    /// An error about this job found by another layer; `diagnostic.field` decides its place.
    pub fn error(&self, diagnostic: Diagnostic) -> JobError {
        JobError::single(self.document.source().clone(), placed(&self.document, diagnostic))
    }
}

/// A checked job of whatever process.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a run holds one job")]
pub enum AnyJob {
    /// Generating grinding.
    Grinding(LoadedJob),
    /// Tangential dressing.
    Tangential(LoadedTangentialJob),
    /// The electronic gearbox.
    Gearbox(LoadedGearboxJob),
    /// Five-axis milling.
    Milling(LoadedMillingJob),
    /// Measuring a skiving tool.
    Skiving(LoadedSkivingJob),
}

impl AnyJob {
    /// Name and process.
    pub fn info(&self) -> &JobInfo {
        match self {
            Self::Grinding(loaded) => &loaded.job.job,
            Self::Tangential(loaded) => &loaded.job.job,
            Self::Gearbox(loaded) => &loaded.job.job,
            Self::Milling(loaded) => &loaded.job.job,
            Self::Skiving(loaded) => &loaded.job.job,
        }
    }
}

/// Reads, parses and checks a job file (TOML or JSON) of any process.
///
/// # Errors
/// All findings of the first stage that has any: text, process, keys and types and ranges, contradictions.
pub fn read_any_job(path: &Path) -> Result<AnyJob, JobError> {
    parse_any_job(Source::read(path)?)
}

/// As [`read_any_job`], from a text.
///
/// # Errors
/// As [`read_any_job`].
pub fn parse_any_job(source: Source) -> Result<AnyJob, JobError> {
    let document = Document::parse(source)?;
    match process_of(&document) {
        Process::GeneratingGrinding => typed(document).map(AnyJob::Grinding),
        Process::TangentialDressing => typed(document).map(AnyJob::Tangential),
        Process::ElectronicGearbox => typed(document).map(AnyJob::Gearbox),
        Process::FiveAxisMilling => typed(document).map(AnyJob::Milling),
        Process::SkivingToolMeasuring => typed(document).map(AnyJob::Skiving),
    }
}

/// Reads, parses and checks a job file of generating grinding (TOML or JSON).
///
/// # Errors
/// As [`read_any_job`]; `process-not-available` for a job of another process.
pub fn read_job(path: &Path) -> Result<LoadedJob, JobError> {
    parse_job(Source::read(path)?)
}

/// As [`read_job`], from a text.
///
/// # Errors
/// As [`read_job`].
pub fn parse_job(source: Source) -> Result<LoadedJob, JobError> {
    let document = Document::parse(source)?;
    match process_of(&document) {
        Process::GeneratingGrinding => typed(document),
        other => Err(not_available(
            &document,
            format!("a job of the process \"{}\" is not planned here", other.name()),
            &[Process::GeneratingGrinding],
        )),
    }
}

/// What reading asks of the jobs of a process.
trait ProcessJob: DeserializeOwned {
    const PROCESS: Process;

    /// What the tree lacks or names wrongly beyond what a schema can say.
    fn shape(document: &Document) -> Vec<Diagnostic>;

    /// Contradictions between entries, without places.
    fn contradictions(&self) -> Vec<Diagnostic>;
}

impl ProcessJob for Job {
    const PROCESS: Process = Process::GeneratingGrinding;

    fn shape(document: &Document) -> Vec<Diagnostic> {
        no_tool(document).into_iter().collect()
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        checks::check(self)
    }
}

impl ProcessJob for TangentialJob {
    const PROCESS: Process = Process::TangentialDressing;

    fn shape(document: &Document) -> Vec<Diagnostic> {
        tangential_job::variable_names(document.root())
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        tangential_job::check(self)
    }
}

impl ProcessJob for GearboxJob {
    const PROCESS: Process = Process::ElectronicGearbox;

    fn shape(_: &Document) -> Vec<Diagnostic> {
        Vec::new()
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        gearbox_job::check(self)
    }
}

impl ProcessJob for MillingJob {
    const PROCESS: Process = Process::FiveAxisMilling;

    fn shape(_: &Document) -> Vec<Diagnostic> {
        Vec::new()
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        milling_job::check(self)
    }
}

impl ProcessJob for SkivingJob {
    const PROCESS: Process = Process::SkivingToolMeasuring;

    fn shape(_: &Document) -> Vec<Diagnostic> {
        Vec::new()
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        skiving_job::check(self)
    }
}

/// What messages call a job of the process, and where an example is.
fn subject(process: Process) -> shape::Subject {
    let example = match process {
        Process::GeneratingGrinding => "`flankwright new generating-grinding` prints a complete example",
        Process::TangentialDressing => "`flankwright new tangential-dressing` prints a complete example",
        Process::ElectronicGearbox => "`flankwright new electronic-gearbox` prints a complete example",
        Process::FiveAxisMilling => "`flankwright new five-axis-milling` prints a complete example",
        Process::SkivingToolMeasuring => "`flankwright new skiving-tool-measuring` prints a complete example",
    };
    shape::Subject { document: "the job", example }
}

/// The typed job of a document whose process is known.
fn typed<J: ProcessJob>(document: Document) -> Result<Loaded<J>, JobError> {
    let refuse = |document: Document, findings| Err(JobError::new(document.source().clone(), findings));
    let subject = subject(J::PROCESS);
    let tables = schema::of_process(J::PROCESS);
    let mut findings = shape::check(document.root(), schema::shared(), tables, subject);
    findings.extend(J::shape(&document));
    if !findings.is_empty() {
        return refuse(document, findings);
    }
    let job = match J::deserialize(document.to_value()) {
        Ok(job) => job,
        // The shape check admits what the types take; this is the net below it.
        Err(error) => {
            let finding = Diagnostic::new(Problem::InvalidJob, format!("the job cannot be read: {error}"))
                .way_out(format!("compare with an example: {}", subject.example));
            return refuse(document, vec![finding]);
        }
    };
    let findings: Vec<Diagnostic> = job.contradictions().into_iter().map(|d| placed(&document, d)).collect();
    if !findings.is_empty() {
        return refuse(document, findings);
    }
    Ok(Loaded { job, document })
}

fn placed(document: &Document, diagnostic: Diagnostic) -> Diagnostic {
    if diagnostic.span.is_some() {
        return diagnostic;
    }
    let span = diagnostic.field.as_ref().and_then(|field| document.nearest_span(field));
    diagnostic.span(span)
}

/// Each table may be absent because the other is there.
fn no_tool(document: &Document) -> Option<Diagnostic> {
    let has = |table: &str| document.root().follow(table).is_some();
    (!has("worm") && !has("catalogue")).then(|| {
        Diagnostic::new(Problem::MissingKey, "the table `[worm]` is missing")
            .field("worm")
            .allowed("a table [worm], or a table [catalogue] to choose worm and dresser from")
            .way_out(format!("add `[worm]`; {}", subject(Process::GeneratingGrinding).example))
            .span(Some(document.root().span.clone()))
    })
}

/// The process of a job decides which tables it has. A word that is none is left to the check of the shape, by the
/// tables of the process that is most likely meant.
fn process_of(document: &Document) -> Process {
    let Some(Kind::Text(name)) = document.root().follow("job.process").map(|(node, _)| &node.kind) else {
        return Process::GeneratingGrinding;
    };
    let meant = shape::nearest(name, Process::ALL.map(Process::name));
    let process = Process::ALL.into_iter().find(|process| Some(process.name()) == meant);
    process.unwrap_or(Process::GeneratingGrinding)
}

fn not_available(document: &Document, message: String, available: &[Process]) -> JobError {
    let words: Vec<String> = available.iter().map(|p| format!("\"{}\"", p.name())).collect();
    let mut finding = Diagnostic::new(Problem::ProcessNotAvailable, message)
        .field("job.process")
        .allowed(words.join(", "))
        .way_out("choose one of the available processes");
    if let Some((node, _)) = document.root().follow("job.process") {
        finding = finding.value(node.shown());
    }
    JobError::single(document.source().clone(), placed(document, finding))
}
