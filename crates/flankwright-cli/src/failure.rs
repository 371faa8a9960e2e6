//! A run that failed, and how it is reported: with the place in the job file for people, as JSON for programs.

use std::fmt::Write as _;
use std::io::{self, IsTerminal, Write as _};
use std::path::PathBuf;

use flankwright::exchange::{Diagnostic, Document, JobError, Source};
use flankwright::workflow::{JobFailure, RunFailure};
use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, NamedSource, Report};
use serde_json::{Value, json};

use crate::exit::Exit;

/// Findings that people are shown at once; programs get all.
const SHOWN: usize = 20;

/// Above this size of a file, or length of a line, the text around a finding is not shown: a job has neither, and
/// drawing megabytes is of no use.
const LONGEST_TEXT: usize = 256 << 10;
const LONGEST_LINE: usize = 400;

/// Exit status and findings of a run that ended badly.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The exit status.
    pub exit: Exit,
    /// The file that the findings are about.
    pub source: Option<Source>,
    /// What was found, never empty.
    pub diagnostics: Vec<Diagnostic>,
    /// Further findings that were not kept.
    pub omitted: usize,
    /// The report of a job that the bodies cannot make.
    pub report: Option<PathBuf>,
}

impl From<JobError> for Failure {
    fn from(error: JobError) -> Self {
        let JobError { source, diagnostics, omitted } = error;
        Self { exit: Exit::BadInput, source: Some(source), diagnostics, omitted, report: None }
    }
}

impl Failure {
    /// A failure that is about no file.
    pub fn new(exit: Exit, diagnostic: Diagnostic) -> Self {
        Self { exit, source: None, diagnostics: vec![diagnostic], omitted: 0, report: None }
    }

    /// A failure of a job, found by any layer; the diagnostic's field decides the place shown.
    pub fn of_job(exit: Exit, document: &Document, diagnostic: Diagnostic) -> Self {
        Self { exit, ..document.error(diagnostic).into() }
    }

    /// A job that the workflow refused or could not make.
    pub fn of_run(document: &Document, failure: RunFailure) -> Self {
        let (exit, finding) = refusal(failure);
        Self::of_job(exit, document, finding)
    }

    /// A run without a job that was refused.
    pub fn of_no_job(failure: RunFailure) -> Self {
        let (exit, finding) = refusal(failure);
        Self::new(exit, finding)
    }

    /// A job of which an entry or a file that it names is at fault.
    pub fn of_job_or_file(document: &Document, failure: JobFailure) -> Self {
        match failure {
            JobFailure::File(error) => Self::from(*error),
            JobFailure::Job(failure) => Self::of_run(document, failure),
        }
    }

    /// A fault of the program.
    pub fn internal(message: String) -> Self {
        let finding = Diagnostic::with_code("internal-error", message)
            .way_out("this is a fault of flankwright: please report it with the job file");
        Self::new(Exit::Internal, finding)
    }

    /// A panic, whose place the hook has already printed.
    pub fn panicked() -> Self {
        Self::internal("the program stopped at an internal fault".to_owned())
    }

    /// A file or stream that cannot be written.
    pub fn cannot_write(name: &str, error: &io::Error) -> Self {
        let finding =
            Diagnostic::with_code("unwritable-file", format!("`{name}` cannot be written: {error}"))
                .way_out("choose another directory with `-o DIR`, or check permissions and space");
        Self::new(Exit::BadInput, finding)
    }

    /// A folder into which another run is writing.
    pub fn busy(name: &str) -> Self {
        let finding = Diagnostic::with_code("folder-in-use", format!("another run is writing into `{name}`"))
            .way_out("wait for it, or choose another directory with `-o DIR`");
        Self::new(Exit::BadInput, finding)
    }

    /// Tells people on standard error, or programs on standard output.
    pub fn tell(&self, json: bool) {
        let told = if json {
            writeln!(io::stdout(), "{:#}", self.to_json())
        } else {
            let stderr = io::stderr();
            let colours = stderr.is_terminal() && std::env::var_os("NO_COLOR").is_none();
            stderr.lock().write_all(self.to_text(colours).as_bytes())
        };
        // If the message cannot be printed, the exit status still tells.
        drop(told);
    }

    /// `{"error": {..}, "errors": [..]}` with line and column from 1.
    pub fn to_json(&self) -> Value {
        let errors: Vec<Value> = self.diagnostics.iter().map(|d| self.diagnostic_json(d)).collect();
        let mut document = json!({ "error": errors.first(), "errors": errors, "omitted": self.omitted });
        if self.exit == Exit::NotProducible {
            document["status"] = json!("not_producible");
        }
        if let Some(report) = &self.report {
            document["report"] = json!(report);
        }
        document
    }

    fn diagnostic_json(&self, diagnostic: &Diagnostic) -> Value {
        let place = self.place(diagnostic);
        json!({
            "code": diagnostic.code,
            "message": diagnostic.message,
            "field": diagnostic.field,
            "value": diagnostic.value,
            "allowed": diagnostic.allowed,
            "way_out": diagnostic.way_out,
            "file": self.source.as_ref().map(Source::name),
            "line": place.map(|(line, _)| line),
            "column": place.map(|(_, column)| column),
        })
    }

    fn place(&self, diagnostic: &Diagnostic) -> Option<(usize, usize)> {
        let span = diagnostic.span.as_ref()?;
        Some(self.source.as_ref()?.line_column(span.start))
    }

    /// All findings with the text around them.
    pub fn to_text(&self, colours: bool) -> String {
        let theme = if colours { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
        let handler = GraphicalReportHandler::new_themed(theme).with_width(110).with_context_lines(1);
        let mut text = String::new();
        for diagnostic in self.diagnostics.iter().take(SHOWN) {
            let report = self.report(diagnostic);
            if handler.render_report(&mut text, report.as_ref()).is_err() {
                let _ = writeln!(text, "{diagnostic}");
            }
        }
        let more = self.diagnostics.len().saturating_sub(SHOWN) + self.omitted;
        if more > 0 {
            let _ = writeln!(text, "and {more} more; `--json` lists up to {}", JobError::MAXIMUM_FINDINGS);
        }
        if let Some(report) = &self.report {
            let _ = writeln!(text, "  report: {}", report.display());
        }
        text
    }

    fn report(&self, diagnostic: &Diagnostic) -> Report {
        let shown = diagnostic.span.clone().filter(|span| self.can_show(span.start));
        let message = match (&self.source, &shown, self.place(diagnostic)) {
            (Some(source), None, Some((line, column))) => {
                format!("{}:{line}:{column}: {}", source.name(), diagnostic.message)
            }
            (Some(source), None, None) if !diagnostic.message.contains(source.name()) => {
                format!("{}: {}", source.name(), diagnostic.message)
            }
            _ => diagnostic.message.to_string(),
        };
        let mut drawn = MietteDiagnostic::new(message).with_code(diagnostic.code);
        let parts = [
            ("key", &diagnostic.field),
            ("value", &diagnostic.value),
            ("allowed", &diagnostic.allowed),
            ("remedy", &diagnostic.way_out),
        ];
        let help: Vec<String> = parts
            .iter()
            .filter_map(|(name, part)| part.as_ref().map(|text| format!("{name}: {text}")))
            .collect();
        if !help.is_empty() {
            drawn = drawn.with_help(help.join("\n"));
        }
        match (&self.source, shown) {
            (Some(source), Some(span)) => {
                Report::new(drawn.with_label(LabeledSpan::new_with_span(None, span)))
                    .with_source_code(NamedSource::new(source.name(), source.text().to_owned()))
            }
            _ => Report::new(drawn),
        }
    }

    fn can_show(&self, offset: usize) -> bool {
        let Some(text) = self.source.as_ref().map(Source::text) else { return false };
        if text.len() > LONGEST_TEXT || !text.is_char_boundary(offset) {
            return false;
        }
        let start = text[..offset].rfind('\n').map_or(0, |i| i + 1);
        let end = text[offset..].find('\n').map_or(text.len(), |i| offset + i);
        end - start <= LONGEST_LINE
    }
}

/// Exit status and finding of a refused run.
fn refusal(failure: RunFailure) -> (Exit, Diagnostic) {
    match failure {
        RunFailure::BadInput(finding) => (Exit::BadInput, *finding),
        RunFailure::NotProducible(finding) => (Exit::NotProducible, *finding),
    }
}

/// An input that cannot be read.
pub fn unreadable(name: &str, error: &io::Error) -> Diagnostic {
    Diagnostic::with_code("unreadable-file", format!("{name} cannot be read: {error}"))
        .way_out("check the input")
}
