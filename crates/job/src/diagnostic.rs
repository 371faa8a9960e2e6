//! What is wrong with an input, in a form that a person and a program can both use: a stable code, the key,
//! its value, what is allowed, and a way out. Knows nothing of how a message is drawn on a screen.

use std::fmt;
use std::ops::Range;

use finding::Finding;
use schemars::JsonSchema;
use serde::Serialize;

/// Everything that can be wrong with a job before any geometry is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Problem {
    /// The file is absent, a directory, or cannot be read.
    UnreadableFile,
    /// The file is larger than [`crate::MAXIMUM_BYTES`].
    FileTooLarge,
    /// The bytes are no text: invalid UTF-8 or control characters.
    InvalidText,
    /// The text is no TOML.
    InvalidToml,
    /// The text is no JSON.
    InvalidJson,
    /// A table of numbers (CSV) is malformed.
    InvalidTable,
    /// Tables or lists are nested deeper than any job needs.
    NestedTooDeeply,
    /// A key stands twice in one table.
    DuplicateKey,
    /// A key that the job format does not have.
    UnknownKey,
    /// A key or a whole table that has to be there is absent.
    MissingKey,
    /// A value of another type than the key takes.
    WrongType,
    /// A word that the key does not know.
    UnknownValue,
    /// A number that is not finite or outside its range.
    InvalidNumber,
    /// A list with too few or too many entries.
    InvalidList,
    /// Numbers that are each in range but describe no possible body.
    InvalidGeometry,
    /// Entries that contradict each other.
    InvalidJob,
    /// Entries of a catalogue that contradict each other.
    InvalidCatalogue,
    /// Entries of a machine description that contradict each other or make no machine.
    InvalidMachine,
    /// A process of the job format that this version does not plan.
    ProcessNotAvailable,
    /// A part of the job format that this version does not carry out.
    NotYetSupported,
}

impl Problem {
    /// The stable kebab-case code of messages, JSON and reports.
    pub fn code(self) -> &'static str {
        match self {
            Problem::UnreadableFile => "unreadable-file",
            Problem::FileTooLarge => "file-too-large",
            Problem::InvalidText => "invalid-text",
            Problem::InvalidToml => "invalid-toml",
            Problem::InvalidJson => "invalid-json",
            Problem::InvalidTable => "invalid-table",
            Problem::NestedTooDeeply => "nested-too-deeply",
            Problem::DuplicateKey => "duplicate-key",
            Problem::UnknownKey => "unknown-key",
            Problem::MissingKey => "missing-key",
            Problem::WrongType => "wrong-type",
            Problem::UnknownValue => "unknown-value",
            Problem::InvalidNumber => "invalid-number",
            Problem::InvalidList => "invalid-list",
            Problem::InvalidGeometry => "invalid-geometry",
            Problem::InvalidJob => "invalid-job",
            Problem::InvalidCatalogue => "invalid-catalogue",
            Problem::InvalidMachine => "invalid-machine",
            Problem::ProcessNotAvailable => "process-not-available",
            Problem::NotYetSupported => "not-yet-supported",
        }
    }
}

/// One finding about an input.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Diagnostic {
    /// Stable kebab-case code, e.g. `unknown-key`.
    pub code: &'static str,
    /// The cause in one sentence.
    pub message: Box<str>,
    /// Path of the key, e.g. `target.modifications[1].amount_um`.
    pub field: Option<Box<str>>,
    /// The value as given.
    pub value: Option<Box<str>>,
    /// What would be allowed.
    pub allowed: Option<Box<str>>,
    /// What to do about it, in one sentence.
    pub way_out: Option<Box<str>>,
    /// Place in the source text, in bytes; resolved to line and column by [`crate::Source::line_column`].
    #[serde(skip)]
    pub span: Option<Range<usize>>,
}

impl Diagnostic {
    /// A finding of this layer.
    pub fn new(problem: Problem, message: impl Into<Box<str>>) -> Self {
        Self::with_code(problem.code(), message)
    }

    /// A finding of another layer, under that layer's own stable code.
    pub fn with_code(code: &'static str, message: impl Into<Box<str>>) -> Self {
        Self {
            code,
            message: message.into(),
            field: None,
            value: None,
            allowed: None,
            way_out: None,
            span: None,
        }
    }

    /// An error of another layer with its code, its message and its way out.
    pub fn of(error: &(impl Finding + ?Sized)) -> Self {
        Self::with_code(error.code(), error.to_string()).way_out(error.way_out())
    }

    /// Names the key.
    pub fn field(mut self, field: impl Into<Box<str>>) -> Self {
        self.field = Some(field.into());
        self
    }

    /// States the value as given.
    pub fn value(mut self, value: impl fmt::Display) -> Self {
        self.value = Some(value.to_string().into());
        self
    }

    /// States what would be allowed.
    pub fn allowed(mut self, allowed: impl Into<Box<str>>) -> Self {
        self.allowed = Some(allowed.into());
        self
    }

    /// States what to do.
    pub fn way_out(mut self, way_out: impl Into<Box<str>>) -> Self {
        self.way_out = Some(way_out.into());
        self
    }

    /// Points into the source text (bytes).
    pub fn span(mut self, span: Option<Range<usize>>) -> Self {
        self.span = span;
        self
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} [{}]", self.message, self.code)?;
        let parts = [
            ("key", &self.field),
            ("value", &self.value),
            ("allowed", &self.allowed),
            ("remedy", &self.way_out),
        ];
        for (name, part) in parts {
            if let Some(text) = part {
                write!(f, "\n  {name}: {text}")?;
            }
        }
        Ok(())
    }
}
